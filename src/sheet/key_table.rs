//! The key as a table for the instructor: one row for each student, one column for each part, problem by problem.
use crate::bank::{Bank, Problem};
use crate::finding::Finding;
use crate::key::{Answer, KeyEntry, SheetKey};
use crate::num::shown::significant;
use crate::problem::maker::Variant;
use crate::sheet::document::{Document, Head};
use crate::solve::outcome::Motion;
use crate::template::{self, Templates, View};
use crate::words::Words;

/// Significant figures of its numbers.
const FIGURES: usize = 4;

/// One student: head of the sheet, what was drawn and solved, the key.
pub struct KeyTableRow {
    /// Head of the sheet.
    pub head: Head,
    /// For each problem: name of its case, and what happens, as the solver's word.
    pub problems: Vec<(String, String)>,
}

/// What the table needs of a sheet.
pub fn row(bank: &Bank, problems: &[usize], head: &Head, variants: &[Variant]) -> KeyTableRow {
    let of = |(index, variant): (&usize, &Variant)| {
        let case = bank.problems.get(*index).and_then(|p| p.cases.get(variant.case));
        let regime = variant.solved.regime;
        let word = if regime.motion == Motion::Instant { String::new() } else { regime.word() };
        (case.map_or_else(String::new, |c| c.name.clone()), word)
    };
    KeyTableRow { head: head.clone(), problems: problems.iter().zip(variants).map(of).collect() }
}

/// The table of a set; `rows` and `keys` are in the same order. Errors: faults of the template `key-table.md`.
pub fn document<'k>(
    templates: &Templates,
    words: &Words,
    bank: &Bank,
    set: &str,
    problems: &[usize],
    rows: &[KeyTableRow],
    keys: impl Iterator<Item = &'k SheetKey> + Clone,
) -> Result<(Head, Document), Finding> {
    let mut view = View::new();
    view.text("title", &bank.title);
    view.foreign("set", set);
    let chosen = problems.iter().filter_map(|p| bank.problems.get(*p)).enumerate();
    let list = chosen.map(|(i, problem)| {
        let cases = problem.cases.len() > 1;
        let moves = rows.iter().any(|r| r.problems.get(i).is_some_and(|(_, word)| !word.is_empty()));
        let parts = problem.questions.iter().map(|q| {
            let unit = if q.label.quantity.is_word() || q.unit.is_number() {
                String::new()
            } else {
                format!(" / {}", q.unit.ascii().replace("^2", "²").replace("^3", "³"))
            };
            template::texts([("name", &format!("`{}`{unit}", q.id))])
        });
        let students = rows.iter().zip(keys.clone()).map(|(row, key)| {
            let (case, word) = row.problems.get(i).map_or(("", ""), |(c, w)| (c, w));
            let entries = key.problems.get(i).map_or(&[][..], |k| &k.parts);
            let answers = entries.iter().map(|e| template::finished(&shown(words, problem, e)));
            let [student, name, case] = [&row.head.student, &row.head.name, case].map(template::in_markdown);
            let regime = if word.is_empty() { String::new() } else { format!("`{word}`") };
            let texts = [
                ("student", student.as_str()),
                ("name", &name),
                ("code", &row.head.code),
                ("case", &case),
                ("regime", &regime),
            ];
            template::with(texts, [("answers", template::list(answers))])
        });
        let flag = |set: bool| if set { "yes" } else { "" };
        let texts = [("title", problem.title.as_str()), ("cases", flag(cases)), ("moves", flag(moves))];
        template::with(
            texts,
            [
                ("number", template::finished(&(i + 1).to_string())),
                ("parts", template::list(parts)),
                ("students", template::list(students)),
            ],
        )
    });
    view.value("problems", template::list(list));
    let markdown = templates.markdown("key-table.md", &view)?;
    let title = format!("{}: {}", words.get("sheet.key"), bank.title);
    let head = Head { title, set: set.to_owned(), ..Head::default() };
    Ok((head, Document::new(markdown, Vec::new())))
}

/// An answer in its unit, which stands in the head of its column.
pub fn shown(words: &Words, problem: &Problem, entry: &KeyEntry) -> String {
    let directed = problem.questions.iter().any(|q| q.id == entry.part && q.label.quantity.is_directed());
    match &entry.answer {
        Answer::Word { right, .. } => words.of_key(right).to_owned(),
        Answer::Number { value, .. } => {
            let number = words.number(&significant(entry.unit.from_si(*value), FIGURES));
            // A sign that means a direction is shown in both cases.
            if directed && *value > 0.0 { format!("+{number}") } else { number }
        }
    }
}
