//! A whole sheet of one student, as Markdown and as a page of HTML that needs nothing else.
use crate::bank::Bank;
use crate::bank::Problem;
use crate::finding::Finding;
use crate::problem::make::Variant;
use crate::scene::Quantity;
use crate::scene::Slope;
use crate::sheet::html::Converter;
use crate::sheet::statement::Common;
use crate::sheet::statement::Scratch;
use crate::sheet::statement::Statement;
use crate::sheet::statement::percent;
use crate::template;
use crate::template::Templates;
use crate::template::View;

/// The problems of a set, ready to be written for many students.
pub struct Sheets<'b> {
    bank: &'b Bank,
    set: &'b str,
    templates: &'b Templates,
    statements: Vec<(usize, Statement<'b>)>,
    common: Common,
}

/// Room for writing, one for each thread.
#[derive(Default)]
pub struct Room {
    scratch: Vec<Scratch>,
    converter: Converter,
}

impl<'b> Sheets<'b> {
    /// Prepares the sheets of a set with these problems (indices into the bank), numbered from 1.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn new(
        templates: &'b Templates,
        bank: &'b Bank,
        set: &'b str,
        problems: &[usize],
    ) -> Result<Self, Vec<Finding>> {
        let chosen = || problems.iter().filter_map(|p| bank.problems.get(*p));
        let common = Common::of(chosen().flat_map(|p| &p.questions));
        let mut statements = Vec::new();
        let mut faults = Vec::new();
        for (i, index) in problems.iter().enumerate() {
            let Some(problem) = bank.problems.get(*index) else { continue };
            match Statement::new(templates, problem, i + 1, &common) {
                Ok(statement) => statements.push((*index, statement)),
                Err(fault) => faults.push(fault),
            }
        }
        if faults.is_empty() { Ok(Self { bank, set, templates, statements, common }) } else { Err(faults) }
    }

    /// Appends the Markdown of one problem (counted from 0 in the sheet).
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn problem(
        &self,
        i: usize,
        variant: &Variant,
        room: &mut Room,
        out: &mut Vec<u8>,
    ) -> Result<(), Finding> {
        room.scratch.resize_with(self.statements.len().max(room.scratch.len()), Scratch::default);
        let Some((_, statement)) = self.statements.get(i) else { return Ok(()) };
        statement.write(variant, i + 1, &mut room.scratch[i], out)
    }

    /// The sheet of one student as Markdown.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn markdown(
        &self,
        student: &str,
        name: &str,
        variants: &[Variant],
        room: &mut Room,
    ) -> Result<String, Finding> {
        let mut problems = Vec::with_capacity(variants.len());
        let mut body = Vec::new();
        for (i, (index, _)) in self.statements.iter().enumerate() {
            body.clear();
            if let Some(variant) = variants.get(i) {
                self.problem(i, variant, room, &mut body)?;
            }
            problems.push(template::map([
                ("number", template::finished(&(i + 1).to_string())),
                ("title", template::finished(&self.bank.problems[*index].title)),
                ("body", template::finished(&String::from_utf8_lossy(&body))),
            ]));
        }
        let mut view = self.head(student, name);
        view.value("problems", template::list(problems));
        let mut out = Vec::new();
        self.templates.markdown("sheet.md", &view, &mut out)?;
        let mut text = String::from_utf8_lossy(&out).trim_end().to_owned();
        text.push('\n');
        Ok(text)
    }

    /// The page of the same sheet.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn html(
        &self,
        student: &str,
        name: &str,
        markdown: &str,
        room: &mut Room,
    ) -> Result<Vec<u8>, Finding> {
        let mut view = self.head(student, name);
        view.foreign("title", &self.bank.title);
        view.text("body", room.converter.body(markdown).trim_end());
        let mut out = Vec::new();
        self.templates.html("sheet.html", &view, &mut out)?;
        Ok(out)
    }

    fn head(&self, student: &str, name: &str) -> View {
        let mut view = View::new();
        view.text("title", &self.bank.title);
        view.foreign("student", student);
        view.foreign("name", name);
        view.foreign("set", self.set);
        view.text("units", if self.common.unit_required { "required" } else { "optional" });
        view.text("figures", &self.common.figures.to_string());
        let within = percent(self.common.relative);
        let questions =
            || self.statements.iter().flat_map(|(index, _)| &self.bank.problems[*index].questions);
        let unless = match questions().any(|q| self.common.differs(q)) {
            true => ", or where a question says `within`, within what it says",
            false => "",
        };
        view.text(
            "tolerance",
            &format!("an answer within {within} of the right one counts as right{unless}"),
        );
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
                (false, true) => "down",
                (false, false) => "back",
            },
        );
        view
    }
}
