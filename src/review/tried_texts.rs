//! Statements and worked solutions of a bank, tried on a variant of each case.
use crate::bank::node::shorten;
use crate::bank::{Bank, Problem};
use crate::finding::{Finding, Findings, push_new};
use crate::key::SheetKey;
use crate::problem::make_key;
use crate::problem::maker::{Maker, Variant};
use crate::sheet::document::Dropped;
use crate::sheet::html::Converter;
use crate::sheet::output::{DocumentWriter, Format};
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::texts::Texts;
use crate::sheet::{document, formula, key_table, statement};
use crate::solution;
use crate::solution::draft::Detail;
use crate::solution::stop::Beyond;
use crate::solve::outcome::Motion;
use crate::words::Words;

/// What is found on one variant of each case.
#[derive(Default)]
pub struct Tried {
    /// Faults of statements and questions: students would see them.
    pub faults: Findings,
    /// Faults of worked solutions.
    pub unsolved: Findings,
    /// What is no fault: cases whose worked solution is a short page, what is dropped from a text.
    pub notes: Vec<TextNote>,
}

/// What is worth knowing of a problem before its sheets go out.
#[derive(Debug, PartialEq)]
pub struct TextNote {
    /// Id of the problem.
    pub problem: String,
    pub what: String,
}

/// That the worked solution is a short page, and why.
pub fn short_page(problem: &Problem, case: usize, what: Beyond) -> String {
    let case = match problem.cases.get(case).map_or("", |c| c.name.as_str()) {
        "" => String::new(),
        name => format!(" of the case `{name}`"),
    };
    let report = if what.is_fault() { "; that is a fault of slipstick, please report it" } else { "" };
    format!(
        "the worked solution{case} is a short page with data and answers: it does not cover {}{report}",
        what.text(&Words::english())
    )
}

/// Writes statement and worked solution of one variant of each case of these problems: faults that show only then, formulas
/// that cannot be read, and what the worked solutions do not cover. Errors: faults of the templates.
pub fn tried(bank: &Bank, texts: &Texts, problems: &[usize]) -> Result<Tried, Findings> {
    let sheets = Sheets::new(&texts.templates, &texts.words, bank, &bank.id, problems)?;
    let mut scratch = SheetScratch::default();
    let mut out = Tried::default();
    for (i, problem) in problems.iter().filter_map(|p| bank.problems.get(*p)).enumerate() {
        for variant in one_of_each_case(problem, &bank.id) {
            let mut sheet = Vec::new();
            match sheets.problem(i, &variant, &mut scratch, &mut sheet) {
                Ok(()) => {
                    let text = String::from_utf8_lossy(&sheet);
                    add_formulas(&mut out.faults, problem, texts, &text);
                    for what in [&problem.title, &*text].into_iter().flat_map(document::dropped) {
                        let note = TextNote { problem: problem.id.clone(), what: not_kept(&what) };
                        push_new(&mut out.notes, note);
                    }
                }
                Err(fault) => push_new(&mut out.faults, fault),
            }
            match solution::worked(problem, &variant, i + 1, Detail::Short, (&texts.words, &texts.templates))
            {
                Ok((_, None)) => {}
                Ok((_, Some(what))) => {
                    let what = short_page(problem, variant.case, what);
                    push_new(&mut out.notes, TextNote { problem: problem.id.clone(), what });
                }
                Err(fault) => push_new(&mut out.unsolved, fault),
            }
        }
    }
    Ok(out)
}

fn add_formulas(findings: &mut Findings, problem: &Problem, texts: &Texts, markdown: &str) {
    for fault in formula::faulty_formulas(markdown) {
        let mut finding = Finding::new(format!("problems.{}", problem.id), format!("formula {fault}"));
        // Where the questions are one's own as well, either may hold it.
        let own = |name: &str| texts.templates.own_file(name);
        if let Some(file) = own(&statement::template_name(problem))
            && own("questions.md").is_none()
        {
            finding = finding.in_file(file);
        }
        push_new(findings, finding);
    }
}

/// A variant of each case that 64 draws meet, one that moves and one that stays where both are declared; fewer if a draw cannot
/// be made.
fn one_of_each_case(problem: &Problem, bank: &str) -> Vec<Variant> {
    let maker = Maker::new(problem, 1, bank);
    let mut variants: Vec<Variant> = Vec::new();
    let may_stay = |regimes: &[String]| {
        [Motion::Balanced, Motion::Rest].iter().any(|m| regimes.iter().any(|word| m.is_called(word)))
    };
    let kinds = |regimes: &[String]| 1 + usize::from(regimes.len() > 1 && may_stay(regimes));
    let wanted: usize = problem.cases.iter().map(|c| kinds(&c.regimes)).sum();
    for student in 0..64 {
        if variants.len() == wanted {
            break;
        }
        let Ok(variant) = maker.variant(&format!("text {student}")) else { break };
        let kind = |v: &Variant| (v.case, v.solved.regime.stays());
        if variants.iter().all(|v| kind(v) != kind(&variant)) {
            variants.push(variant);
        }
    }
    variants
}

/// What a text of students does not keep, in words.
fn not_kept(what: &Dropped) -> String {
    let (before, text, why) = match what {
        Dropped::Tag(html) => ("", html, "the tags are dropped, the words stay; write it in Markdown"),
        Dropped::Html(html) => ("", html, "it does not reach students, nor does what stands in it"),
        Dropped::Link(url) => ("the link to ", url, "only http, https, mailto and places nearby stay"),
        Dropped::Picture(url) => ("the picture ", url, "pages hold only what the program draws"),
    };
    format!("{before}`{}` is dropped: {why}", shorten(text))
}

/// What [`tried`] finds in the whole bank; where that is nothing, a whole sheet is made in every format that this program makes
/// without a compiler. Errors: faults of the templates.
pub fn whole_bank(bank: &Bank, texts: &Texts) -> Result<Tried, Findings> {
    let problems: Vec<usize> = (0..bank.problems.len()).collect();
    let mut out = tried(bank, texts, &problems)?;
    out.faults.append(&mut out.unsolved);
    let sheets = Sheets::new(&texts.templates, &texts.words, bank, &bank.id, &problems)?;
    let mut scratch = SheetScratch::default();
    let first = |p: &Problem| one_of_each_case(p, &bank.id).into_iter().next();
    let whole: Vec<Variant> = bank.problems.iter().filter_map(first).collect();
    let findings = &out.faults;
    if findings.is_empty() && whole.len() == problems.len() {
        let formats = [Format::Md, Format::Html, Format::Tex];
        let output = DocumentWriter::new(texts, &formats, "sheet")?;
        let (head, document) = sheets.document("0017", "Name", &whole, &mut scratch)?;
        let rows = [key_table::row(bank, &problems, &head, &whole)];
        let made = output.make(0, head, document, &mut Converter::new(&texts.words), None)?;
        output.booklets(&bank.title, std::slice::from_ref(&made))?;
        let parts = bank.problems.iter().zip(&whole).map(|(p, v)| make_key::key(p, v)).collect();
        let keys = [SheetKey { student: "0017".to_owned(), problems: parts }];
        output.key_table(bank, &bank.id, &problems, &rows, keys.iter())?;
    }
    Ok(out)
}
