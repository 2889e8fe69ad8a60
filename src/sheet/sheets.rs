//! A whole sheet of one student: a document of Markdown and pictures, with its head.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, FigureLabels, Problem, load};
use crate::figure::scene;
use crate::finding::{Finding, Findings};
use crate::picture::Picture;
use crate::problem::maker::Variant;
use crate::scene::{Quantity, Slope};
use crate::sheet::document::{Document, Head};
use crate::sheet::statement::{Common, Scratch, Statement, percent};
use crate::template::{self, Templates, View};
use crate::words::Words;

/// The problems of a set, ready to be written for many students.
pub struct Sheets<'b> {
    bank: &'b Bank,
    set: &'b str,
    templates: &'b Templates,
    words: &'b Words,
    statements: Vec<(usize, Statement<'b>)>,
    common: Common,
}

/// Room for writing, one for each thread.
#[derive(Default)]
pub struct SheetScratch {
    statements: Vec<Scratch>,
}

impl<'b> Sheets<'b> {
    /// Prepares the sheets of a set with these problems (indices into the bank), numbered from 1. Errors: faults of the templates.
    pub fn new(
        templates: &'b Templates,
        words: &'b Words,
        bank: &'b Bank,
        set: &'b str,
        problems: &[usize],
    ) -> Result<Self, Findings> {
        let chosen = || problems.iter().filter_map(|p| bank.problems.get(*p));
        let common = Common::of(chosen().flat_map(|p| &p.questions));
        let mut statements = Vec::new();
        let mut faults = Findings::default();
        for (i, index) in problems.iter().enumerate() {
            let Some(problem) = bank.problems.get(*index) else { continue };
            match Statement::new(templates, words, problem, i + 1, &common) {
                Ok(statement) => statements.push((*index, statement)),
                Err(fault) => faults.push(fault),
            }
        }
        faults.into_result(Self { bank, set, templates, words, statements, common })
    }

    /// Appends the Markdown of one problem (counted from 0 in the sheet), without its figure. Errors: faults of the templates.
    pub fn problem(
        &self,
        i: usize,
        variant: &Variant,
        scratch: &mut SheetScratch,
        out: &mut Vec<u8>,
    ) -> Result<(), Finding> {
        self.write(i, variant, None, scratch, out)
    }

    /// Appends the Markdown of one problem (counted from 0 in the sheet) with the line of its figure, which is returned.
    fn whole_problem(
        &self,
        i: usize,
        variant: &Variant,
        scratch: &mut SheetScratch,
        out: &mut Vec<u8>,
    ) -> Result<Option<(String, Picture)>, Finding> {
        let Some((index, _)) = self.statements.get(i) else { return Ok(None) };
        let problem = &self.bank.problems[*index];
        let drawn = (problem.figure != FigureLabels::None).then(|| {
            let picture = scene::picture(problem, variant, self.words, problem.figure);
            (format!("problem-{}", i + 1), picture)
        });
        let line = drawn.as_ref().map(|(name, picture)| format!("![{}]({name}.svg)", alternative(picture)));
        self.write(i, variant, line.as_deref(), scratch, out)?;
        Ok(drawn)
    }

    /// One problem (counted from 0 in the sheet) as a document of its own: heading, if one is given, statement, figure, questions.
    /// Errors: faults of the templates.
    pub fn problem_document(
        &self,
        i: usize,
        heading: &str,
        variant: &Variant,
        scratch: &mut SheetScratch,
    ) -> Result<Document, Finding> {
        let mut out = heading.to_owned().into_bytes();
        let picture = self.whole_problem(i, variant, scratch, &mut out)?;
        Ok(Document::new(String::from_utf8_lossy(&out).into_owned(), picture.into_iter().collect()))
    }

    /// How many significant figures most questions ask for, and in words how near to the right one an answer must be.
    pub fn asked_for(&self) -> (u8, String) {
        let within = self.words.number(&percent(self.common.relative));
        let mut tolerance = self.words.say("sheet.tolerance", &[("share", &within)]);
        let mut questions = self.statements.iter().flat_map(|(i, _)| &self.bank.problems[*i].questions);
        if questions.any(|q| self.common.differs(q)) {
            tolerance.push_str(self.words.get("sheet.unless"));
        }
        (self.common.figures, tolerance)
    }

    fn write(
        &self,
        i: usize,
        variant: &Variant,
        figure: Option<&str>,
        scratch: &mut SheetScratch,
        out: &mut Vec<u8>,
    ) -> Result<(), Finding> {
        scratch.statements.resize_with(self.statements.len().max(scratch.statements.len()), Scratch::default);
        let Some((_, statement)) = self.statements.get(i) else { return Ok(()) };
        statement.write(variant, i + 1, figure, &mut scratch.statements[i], out)
    }

    /// The sheet of one student. Errors: faults of the templates.
    pub fn document(
        &self,
        student: &str,
        name: &str,
        variants: &[Variant],
        scratch: &mut SheetScratch,
    ) -> Result<(Head, Document), Finding> {
        let head = self.head(student, name, variants);
        let mut pictures = Vec::new();
        let mut problems = Vec::with_capacity(variants.len());
        let mut body = Vec::new();
        for (i, (index, _)) in self.statements.iter().enumerate() {
            let Some(variant) = variants.get(i) else { continue };
            body.clear();
            let problem = &self.bank.problems[*index];
            pictures.extend(self.whole_problem(i, variant, scratch, &mut body)?);
            let (number, body) = ((i + 1).to_string(), String::from_utf8_lossy(&body));
            problems.push(template::texts([("number", &number), ("title", &problem.title), ("body", &body)]));
        }
        let mut view = self.view(&head);
        view.value("problems", template::list(problems));
        let markdown = self.templates.markdown("sheet.md", &view)?;
        Ok((head, Document::new(markdown, pictures)))
    }

    /// Who gets the sheet, and the code of what was drawn.
    pub fn head(&self, student: &str, name: &str, variants: &[Variant]) -> Head {
        let mut drawn = format!("{}\u{0}{student}", self.set);
        for ((index, _), variant) in self.statements.iter().zip(variants) {
            let problem = &self.bank.problems[*index];
            // Not the case: whoever knows its names could try which of them gives this code.
            drawn.push_str(&format!("\u{0}{}", problem.id));
            for number in variant.values.iter() {
                drawn.push('\u{0}');
                drawn.push_str(&number.map_or_else(String::new, Decimal::text));
            }
        }
        Head {
            title: self.bank.title.clone(),
            name: name.to_owned(),
            student: student.to_owned(),
            set: self.set.to_owned(),
            code: code(&drawn),
        }
    }

    fn view(&self, head: &Head) -> View {
        let words = self.words;
        let mut view = View::new();
        view.text("title", &self.bank.title);
        view.foreign("student", &head.student);
        view.foreign("name", &head.name);
        view.foreign("set", self.set);
        view.text("code", &head.code);
        view.text("units", if self.common.unit_required { "required" } else { "optional" });
        let (figures, tolerance) = self.asked_for();
        view.text("figures", &figures.to_string());
        view.text("tolerance", &tolerance);
        // A sheet without a student is one to practise with.
        view.text("practice", if head.student.is_empty() { words.get("page.practice") } else { "" });
        view.text("self_check", if self.bank.self_check { "yes" } else { "" });
        let questions =
            self.statements.iter().enumerate().flat_map(|(i, (index, _))| {
                self.bank.problems[*index].questions.iter().map(move |q| (i + 1, q))
            });
        let mut example = ("1.v".to_owned(), "m/s".to_owned());
        let numeric = questions.filter(|(_, q)| !q.label.quantity.is_word() && !q.unit.is_number());
        let preferred = numeric.clone().find(|(_, q)| q.label.quantity == Quantity::V);
        let preferred = preferred.or_else(|| numeric.clone().find(|(_, q)| !q.label.quantity.is_directed()));
        if let Some((number, q)) = preferred.or_else(|| numeric.clone().next()) {
            example = (format!("{number}.{}", q.id), q.unit.ascii().to_owned());
        }
        view.text("example", &example.0);
        view.text("example_unit", &example.1);
        // A word gives a sign only where something goes along a line.
        let directed = self
            .statements
            .iter()
            .map(|(index, _)| &self.bank.problems[*index])
            .filter(|p| p.questions.iter().any(|q| q.label.quantity.is_directed()));
        let lines = |p: &Problem| -> Vec<bool> {
            let bodies = p.cases.iter().flat_map(|c| &c.scene.bodies);
            bodies.filter_map(|b| b.line).map(|l| l.slope != Slope::Level).collect()
        };
        let sloped: Vec<bool> = directed.flat_map(lines).collect();
        view.text(
            "direction",
            match (sloped.is_empty(), sloped.contains(&true)) {
                (true, _) => "",
                (false, true) => words.get("sheet.down"),
                (false, false) => words.get("sheet.back"),
            },
        );
        view
    }
}

/// What a picture shows, in Markdown, for those who do not see it.
fn alternative(picture: &Picture) -> String {
    template::in_markdown(if picture.desc.is_empty() { &picture.title } else { &picture.desc })
}

/// Six letters and digits that stand for a text; none that is easily taken for another.
fn code(text: &str) -> String {
    const LETTERS: &[u8; 32] = b"23456789ABCDEFGHJKLMNPQRSTUVWXYZ";
    let hash = load::hash(text);
    let bits = hash.get(..8).and_then(|hex| u32::from_str_radix(hex, 16).ok()).unwrap_or(0);
    (0..6).map(|i| char::from(LETTERS[(bits >> (5 * i) & 31) as usize])).collect()
}
