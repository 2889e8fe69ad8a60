//! Two gradings of the same answers: who gains and who loses, for which part, and why.
use crate::csv_field::{push_line, unguarded};
use crate::finding::Finding;
use crate::grade::gradebook_reader;
use crate::grade::row::{AnswerRow, no_csv};
use crate::grade::table::{Column, KeyTable};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, KeyEntry};
use serde::Deserialize;
use std::io::Read;

/// A grading as far as it is compared; students and parts are those of the new key.
#[derive(Debug, Clone, PartialEq)]
pub struct Grading {
    parts: usize,
    /// The answers that count, a row of parts for each student.
    pub cells: Vec<Option<AnswerRow<'static>>>,
    /// Points in the gradebook, likewise.
    points: Vec<Option<f64>>,
    /// Total and of how many, for each student.
    pub totals: Vec<Option<(f64, f64)>>,
}

impl Grading {
    /// Nothing known yet.
    pub fn new(keys: &KeyTable) -> Self {
        let size = keys.students.len() * keys.columns.len();
        Self {
            parts: keys.columns.len(),
            cells: vec![None; size],
            points: vec![None; size],
            totals: vec![None; keys.students.len()],
        }
    }

    /// Takes a row of answers.csv.
    pub fn take(&mut self, keys: &KeyTable, row: AnswerRow) {
        if !row.counts() {
            return;
        }
        if let Some((s, p)) = keys.place_of(&row) {
            self.cells[s * self.parts + p] = Some(row.into_owned());
        }
    }

    /// Takes gradebook.csv. Errors: it is no gradebook.
    pub fn book(&mut self, keys: &KeyTable, gradebook: impl Read) -> Result<(), Finding> {
        let parts: Vec<String> = keys.columns.iter().map(Column::label).collect();
        gradebook_reader::each_row(gradebook, &parts, true, &mut |row| {
            if let Some(s) = keys.student(row.student.as_bytes()).map(|s| s as usize) {
                self.points[s * self.parts..][..self.parts].copy_from_slice(&row.points);
                self.totals[s] = row.total.zip(row.of);
            }
            Ok(())
        })
    }

    pub fn cell(&self, student: usize, part: usize) -> Option<&AnswerRow<'static>> {
        self.cells[student * self.parts + part].as_ref()
    }
    /// Points as the gradebook has them.
    pub fn points(&self, student: usize, part: usize) -> Option<f64> {
        self.points[student * self.parts + part]
    }
}

worded! {
    /// Why a mark changed.
    #[derive(PartialOrd, Ord)]
    Why {
        /// The key has another value.
        Key "key",
        /// The tolerance is another.
        Tolerance "tolerance",
        /// Whether a unit must be written is settled otherwise.
        Unit "unit",
        /// The part has other points.
        Points "points of the part",
        /// A wrong method is now recognised.
        Method "wrong method recognised",
        NoMethod "wrong method no longer recognised",
        /// Credit for a wrong method is another.
        Credit "credit",
        /// Points because it follows from an earlier answer, or other ones.
        Follow "follow-through",
        /// What followed from an earlier answer does so no more, or earns more by itself.
        NoFollow "no longer follow-through",
        Correction "correction",
        Attempt "another attempt counts",
        /// What attempts or lateness cost, or when answers were due.
        Policy "attempts or lateness",
        /// Something else, such as a later version of the program.
        Other "other",
    }
}

/// Which settings of the course are others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Settings {
    /// Those of attempts, due dates and lateness.
    pub costs: bool,
    /// What an answer that is not right may earn.
    pub credit: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub struct MarkChange {
    /// Student, an index.
    pub student: usize,
    /// Part, an index.
    pub part: usize,
    /// Points before; `None` where there were none.
    pub before: Option<f64>,
    /// Points after.
    pub after: Option<f64>,
    /// Verdict before; `None` where nothing counted.
    pub was: Option<Verdict>,
    /// Verdict after.
    pub is: Option<Verdict>,
    /// Why, at least one reason.
    pub why: Vec<Why>,
}

impl MarkChange {
    /// How many points more.
    pub fn gain(&self) -> f64 {
        self.after.unwrap_or(0.0) - self.before.unwrap_or(0.0)
    }
}

/// A row of changes.csv.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct ChangeRow {
    /// Id of the student.
    pub student: String,
    /// Number of the problem.
    pub problem: String,
    /// Id of the part.
    pub part: String,
    /// Points before, nothing where there were none; likewise the next three.
    pub points_before: String,
    pub points_after: String,
    pub verdict_before: String,
    pub verdict_after: String,
    /// Why, reasons separated by semicolons.
    pub why: String,
}

impl ChangeRow {
    #[rustfmt::skip] // a table
    const COLUMNS: [&str; 8] = [
        "student", "problem", "part", "points_before", "points_after", "verdict_before", "verdict_after",
        "why",
    ];
    /// changes.csv of these rows.
    pub fn csv(rows: &[ChangeRow]) -> Vec<u8> {
        let mut out = Vec::new();
        push_line(&mut out, ChangeRow::COLUMNS);
        for row in rows {
            let ChangeRow { student, problem, part, .. } = row;
            let marks = [&row.points_before, &row.points_after, &row.verdict_before, &row.verdict_after];
            push_line(&mut out, [student, problem, part].into_iter().chain(marks).chain([&row.why]));
        }
        out
    }
    /// The rows of changes.csv. Errors: it is none.
    pub fn read(csv: &[u8]) -> Result<Vec<ChangeRow>, Finding> {
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(csv);
        let mut rows: Vec<ChangeRow> = reader.deserialize().collect::<Result<_, _>>().map_err(no_csv)?;
        for text in rows.iter_mut().flat_map(|row| [&mut row.student, &mut row.part, &mut row.why]) {
            *text = unguarded(text).to_owned();
        }
        Ok(rows)
    }
}

/// Points nearer to each other than this are equal.
pub const DUST: f64 = 1e-9;
/// Keys that differ by no more than this share are equal.
const SAME: f64 = 1e-12;

/// All marks whose points or verdicts differ, by student, then part. `entries` gives the entry before and after.
pub fn compare<'k>(
    keys: &KeyTable,
    old: &Grading,
    new: &Grading,
    settings: Settings,
    entries: &dyn Fn(usize, usize) -> [Option<&'k KeyEntry>; 2],
) -> Vec<MarkChange> {
    let mut found = Vec::new();
    for student in 0..keys.students.len() {
        for part in 0..keys.columns.len() {
            let (before, after) = (old.points(student, part), new.points(student, part));
            let (a, b) = (old.cell(student, part), new.cell(student, part));
            let (was, is) = (a.map(|c| c.verdict), b.map(|c| c.verdict));
            let moved = (after.unwrap_or(0.0) - before.unwrap_or(0.0)).abs() > DUST;
            if moved || was != is {
                let why = why(a, b, settings, entries(student, part), moved);
                found.push(MarkChange { student, part, before, after, was, is, why });
            }
        }
    }
    found
}

fn has(credit: &str, word: &str) -> bool {
    credit.split(' ').any(|w| w == word || w.split(':').next() == Some(word))
}

/// Words of `credit` of some kinds, to be compared.
fn of_kind<'c>(credit: &'c str, kinds: &[&str]) -> Vec<&'c str> {
    credit.split(' ').filter(|w| kinds.contains(&w.split(':').next().unwrap_or_default())).collect()
}

fn why(
    a: Option<&AnswerRow>,
    b: Option<&AnswerRow>,
    settings: Settings,
    keys: [Option<&KeyEntry>; 2],
    moved: bool,
) -> Vec<Why> {
    let mut why = Vec::new();
    let (credit_a, credit_b) = (a.map_or("", |c| &*c.credit), b.map_or("", |c| &*c.credit));
    if has(credit_a, "correction") != has(credit_b, "correction") || (a.is_none() && b.is_none()) {
        // Without an answer only a correction gives points.
        why.push(Why::Correction);
    }
    let (Some(a), Some(b)) = (a, b) else {
        if why.is_empty() {
            why.push(Why::Other);
        }
        return why;
    };
    if (a.line, &a.column) != (b.line, &b.column) {
        why.push(Why::Attempt);
    } else if a.verdict != b.verdict {
        why.extend(of_key(keys));
    }
    if moved {
        if (a.max_points - b.max_points).abs() > DUST {
            why.push(Why::Points);
        }
        match (has(credit_a, "methods"), has(credit_b, "methods")) {
            (false, true) if a.methods != b.methods => why.push(Why::Method),
            (true, false) if a.methods != b.methods => why.push(Why::NoMethod),
            (true, true) | (false, true) | (true, false) if settings.credit && a.verdict == b.verdict => {
                why.push(Why::Credit);
            }
            _ => {}
        }
        let follow = |credit: &str| of_kind(credit, &["follow"]).join(" ");
        if follow(credit_a) != follow(credit_b) {
            why.push(if has(credit_b, "follow") { Why::Follow } else { Why::NoFollow });
        }
        const COSTS: [&str; 3] = ["attempt", "late", "closed"];
        // A wrong answer has no points for these to bear on, so that the words come and go with them.
        if settings.costs && of_kind(credit_a, &COSTS) != of_kind(credit_b, &COSTS) {
            why.push(Why::Policy);
        }
    }
    if why.is_empty() && moved && has(credit_a, "follow") && has(credit_b, "follow") {
        why.push(Why::Credit);
    }
    if why.is_empty() {
        why.push(Why::Other);
    }
    why.sort();
    why.dedup();
    why
}

/// What differs between two entries of a key.
pub fn of_key([old, new]: [Option<&KeyEntry>; 2]) -> Vec<Why> {
    let (Some(old), Some(new)) = (old, new) else { return vec![Why::Key] };
    let mut why = Vec::new();
    match (&old.answer, &new.answer) {
        (
            Answer::Number { value: a, half_width: wide_a, directed: d, magnitude: m, words: v, cyclic: c },
            Answer::Number { value: b, half_width: wide_b, directed: e, magnitude: n, words: w, cyclic: t },
        ) => {
            if (a - b).abs() > SAME * a.abs().max(b.abs()) || (d, m, v, c) != (e, n, w, t) {
                why.push(Why::Key);
            }
            // A half-width that only goes with the value is the same tolerance.
            let share = |value: f64, wide: f64| if value == 0.0 { wide } else { wide / value.abs() };
            let (a, b) = (share(*a, *wide_a), share(*b, *wide_b));
            if (a - b).abs() > 1e-9 * a.max(b) {
                why.push(Why::Tolerance);
            }
        }
        (a, b) if a != b => why.push(Why::Key),
        _ => {}
    }
    if old.unit_required != new.unit_required || old.unit.ascii() != new.unit.ascii() {
        why.push(Why::Unit);
    }
    why
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::{ProblemKey, SheetKey};
    use crate::units::Unit;

    fn who() -> KeyTable {
        let part = |id: &str| KeyEntry {
            part: id.to_owned(),
            answer: Answer::Word { right: "", offered: &[] },
            unit: Unit::one(),
            unit_required: false,
            points: 2.0,
            eom: None,
            energy: None,
            gap: None,
            cond: None,
            bound: None,
            wrong: Vec::new(),
            code: None,
        };
        let problem =
            ProblemKey { id: "p".to_owned(), parts: vec![part("v"), part("t")], ..ProblemKey::default() };
        let sheet = |id: &str| SheetKey { student: id.to_owned(), problems: vec![problem.clone()] };
        KeyTable::new(vec![sheet("a"), sheet("b")], &[])
    }

    fn grading(rows: &[(&str, &str, u64, Verdict, &str, &str)], book: &str) -> Grading {
        let mut found = Grading::new(&who());
        for (student, part, line, verdict, methods, credit) in rows {
            found.take(
                &who(),
                AnswerRow {
                    line: *line,
                    student: (*student).into(),
                    problem: "1".into(),
                    part: (*part).into(),
                    answer: "3".into(),
                    verdict: *verdict,
                    max_points: 2.0,
                    methods: (*methods).into(),
                    credit: (*credit).into(),
                    ..AnswerRow::default()
                },
            );
        }
        found.book(&who(), format!("student,name,1.v,1.t,total,max_total\n{book}").as_bytes()).unwrap();
        found
    }

    #[test]
    fn each_change_has_its_reason() {
        let old = grading(
            &[
                ("a", "v", 2, Verdict::Wrong, "", ""),
                ("a", "t", 3, Verdict::Right, "", "late:0.8"),
                ("b", "v", 4, Verdict::Wrong, "", ""),
            ],
            "a,,0,1.6,1.6,4\nb,,0,,0,4\n",
        );
        let new = grading(
            &[
                ("a", "v", 2, Verdict::Wrong, "A05", "methods"),
                ("a", "t", 3, Verdict::Right, "", ""),
                ("b", "v", 5, Verdict::Right, "", ""),
            ],
            "a,,0.5,2,2.5,4\nb,,2,2,4,4\n",
        );
        let found =
            compare(&who(), &old, &new, Settings { costs: true, credit: false }, &|_, _| [None, None]);
        let told: Vec<_> = found.iter().map(|c| (c.student, c.part, c.gain(), c.why.clone())).collect();
        assert_eq!(told[0], (0, 0, 0.5, vec![Why::Method]));
        assert!((told[1].2 - 0.4).abs() < 1e-12 && told[1].3 == [Why::Policy]);
        assert_eq!(told[2], (1, 0, 2.0, vec![Why::Attempt]));
        // Points without an answer: a correction.
        assert_eq!(told[3], (1, 1, 2.0, vec![Why::Correction]));
        // The words of lateness came and went, the settings did not.
        let found = compare(&who(), &old, &new, Settings::default(), &|_, _| [None, None]);
        assert_eq!(found[1].why, [Why::Other]);
        assert!(compare(&who(), &old, &old, Settings::default(), &|_, _| [None, None]).is_empty());
    }
}
