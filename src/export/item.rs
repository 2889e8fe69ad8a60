//! One variant of one problem as a question: its text, its figure, and what is right, in the units that are asked.
use crate::answer::word;
use crate::bank::Bank;
use crate::export::body::{BodyWriter, ItemText};
use crate::finding::Finding;
use crate::key::{Answer, KeyEntry, ProblemKey};
use crate::picture::svg;
use crate::problem::maker::Variant;
use crate::sheet::document::Document;
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::texts::Texts;
use crate::solution;
use crate::words::Words;
use std::sync::Arc;

/// One variant of one problem.
pub struct Item<'i> {
    /// Index of the problem in the sheet.
    pub problem: usize,
    /// Code of its data.
    pub code: &'i str,
    /// Title of the problem.
    pub title: &'i str,
    /// Statement, figure and questions.
    pub body: ItemText,
    /// How to answer them.
    pub below: Arc<Below>,
    /// Pictures of the statement, then of the solution.
    pub pictures: Vec<ItemPicture>,
    pub parts: &'i [KeyEntry],
    /// The words of the sheet.
    pub words: &'i Words,
    /// The worked solution, if it is wanted; its pictures come behind those of the statement, of which there are so many.
    pub solution: Option<(ItemText, usize)>,
}

/// What stands below the questions, as XHTML with a place for the code.
pub struct Below {
    /// For all parts together.
    whole: String,
    /// For a part that is answered with a number.
    number: String,
    /// For one that is answered with a word.
    word: String,
}

pub struct ItemPicture {
    /// Name of its file, with its ending.
    pub file: String,
    /// What it shows, for those who do not see it.
    pub alternative: String,
    /// The file.
    pub svg: String,
}

/// Makes items of the variants of a set.
pub struct ItemMaker<'i> {
    bank: &'i Bank,
    problems: &'i [usize],
    texts: &'i Texts,
    sheets: &'i Sheets<'i>,
    /// Below the questions of each problem.
    below: Vec<Arc<Below>>,
    with_solutions: bool,
}

/// Room for making items, one for each thread.
#[derive(Default)]
pub struct ItemScratch {
    sheet: SheetScratch,
    bodies: BodyWriter,
}

impl<'i> ItemMaker<'i> {
    /// For the problems of a set; `sheets` writes them in the words of `texts`, and `rule` of the word list says how a number is
    /// typed, `word_rule` how a word is.
    pub fn new(
        (bank, problems): (&'i Bank, &'i [usize]),
        texts: &'i Texts,
        sheets: &'i Sheets<'i>,
        (rule, word_rule): (&str, &str),
        with_solutions: bool,
    ) -> Self {
        let words = &texts.words;
        let (figures, tolerance) = sheets.asked_for();
        let say = |text: &str, rules: &[&str]| {
            let rules: Vec<&str> = rules.iter().map(|rule| words.get(rule)).collect();
            let pieces = [
                ("rules", rules.join(" ")),
                ("figures", figures.to_string()),
                ("tolerance", tolerance.clone()),
                ("code", CODE.to_owned()),
            ];
            let said = words.say(text, &pieces.each_ref().map(|(name, text)| (*name, text.as_str())));
            let body = BodyWriter::default().body(&Document::new(said, Vec::new()), &[]);
            body.text(None, &mut |_| String::new(), &|_| String::new())
        };
        let below = problems.iter().filter_map(|p| bank.problems.get(*p)).map(|problem| {
            let is_word = |q: &crate::bank::Question| q.label.quantity.is_word();
            let number = say("export.below", &[rule]);
            let word = say("export.below_word", &[word_rule]);
            let whole = match (problem.questions.iter().all(is_word), problem.questions.iter().any(is_word)) {
                (true, _) => word.clone(),
                (false, true) => say("export.below", &[rule, word_rule]),
                (false, false) => number.clone(),
            };
            Arc::new(Below { whole, number, word })
        });
        Self { bank, problems, texts, sheets, below: below.collect(), with_solutions }
    }

    /// The item of a variant of the problem at this place of the sheet. Errors: faults of the templates.
    pub fn item<'k>(
        &'k self,
        at: usize,
        variant: &Variant,
        key: &'k ProblemKey,
        scratch: &mut ItemScratch,
    ) -> Result<Item<'k>, Finding> {
        let problem = &self.bank.problems[self.problems[at]];
        let (words, code) = (&self.texts.words, key.code.as_str());
        if let Some(none) =
            key.parts.iter().find(|p| matches!(p.answer, Answer::Number { value, .. } if !value.is_finite()))
        {
            let field = format!("problems.{}.questions.{}", problem.id, none.part);
            return Err(Finding::new(field, format!("has no answer for the data of {code}")));
        }
        let names: Vec<String> = key.parts.iter().map(|p| format!("{}.{}", at + 1, p.part)).collect();
        let document = self.sheets.problem_document(at, "", variant, &mut scratch.sheet)?;
        let body = scratch.bodies.body(&document, &names);
        let prefix = format!("p{}-{code}", at + 1);
        let mut pictures: Vec<ItemPicture> = pictures(&document, &prefix).collect();
        let solution = match self.with_solutions {
            true => {
                let worked = solution::document(problem, variant, at + 1, words, &self.texts.templates)?;
                let own = pictures.len();
                pictures.extend(self::pictures(&worked, &format!("{prefix}-solution")));
                Some((scratch.bodies.body(&worked, &[]), own))
            }
            false => None,
        };
        let (title, below, parts) = (problem.title.as_str(), Arc::clone(&self.below[at]), &key.parts[..]);
        Ok(Item { problem: at, code, title, body, below, pictures, parts, words, solution })
    }
}

/// Stands for the code until it is known.
const CODE: &str = "\u{e000}";

fn pictures<'d>(document: &'d Document, prefix: &'d str) -> impl Iterator<Item = ItemPicture> + 'd {
    document.screens().into_iter().zip(&document.pictures).map(move |((name, screen), (_, picture))| {
        let told = if picture.desc.is_empty() { &picture.title } else { &picture.desc };
        let file = match document.pictures.len() {
            1 => format!("{prefix}.svg"),
            _ => format!("{prefix}-{name}.svg"),
        };
        ItemPicture { file, alternative: told.clone(), svg: screen.file() }
    })
}

/// All that is read as a word of a key, first as the sheet says it: a platform may show the first as the answer.
pub fn spellings<'w>(right: &'static str, words: &'w Words) -> Vec<&'w str> {
    let said = words.of_key(right);
    let others = word::spellings(right).into_iter().filter(|word| *word != said);
    std::iter::once(said).chain(others).collect()
}

impl Item<'_> {
    /// The text with what stands below it; with `only` for this part alone, which says no more than this part needs.
    pub fn text(
        &self,
        only: Option<usize>,
        answer: &mut dyn FnMut(usize) -> String,
        address: &dyn Fn(&str) -> String,
    ) -> String {
        let mut out = self.body.text(only, answer, &|i| self.picture(i, address));
        let below = match only.and_then(|i| self.parts.get(i)).map(|part| &part.answer) {
            None => &self.below.whole,
            Some(Answer::Number { .. }) => &self.below.number,
            Some(Answer::Word { .. }) => &self.below.word,
        };
        out.push_str(&below.replace(CODE, self.code));
        out
    }

    /// The picture of this index in the text; `address` makes the address of its file.
    pub fn picture(&self, i: usize, address: &dyn Fn(&str) -> String) -> String {
        self.pictures.get(i).map_or_else(String::new, |picture| {
            let (src, alt) = (svg::escaped(&address(&picture.file)), svg::escaped(&picture.alternative));
            format!("<img src=\"{src}\" alt=\"{alt}\"/>")
        })
    }

    /// The worked solution as XHTML, if it is there.
    pub fn solution(&self, address: &dyn Fn(&str) -> String) -> Option<String> {
        let (body, before) = self.solution.as_ref()?;
        Some(body.text(None, &mut |_| String::new(), &|i| self.picture(before + i, address)))
    }

    /// Points of all parts.
    pub fn points(&self) -> f64 {
        self.parts.iter().map(|p| p.points).sum()
    }
}
