//! What other tolerances would make of answers that are graded already: which verdicts and points would change, and which wrong
//! methods would pass for right.
use crate::answer::read::UnitCache;
use crate::grade::feedback::Feedback;
use crate::grade::judge::accepts;
use crate::grade::judge::judge_with;
use crate::grade::verdict::Verdict;
use crate::key::Answer;
use crate::key::KeyEntry;
use crate::regrade::rows::Row;
use std::collections::BTreeMap;

/// What would change for one part, or for all.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Change {
    /// Answers that would become right.
    pub gained: u64,
    /// Answers that would no longer be right.
    pub lost: u64,
    /// Answers that would become right although they fit a known wrong method.
    pub methods: u64,
    /// Sheets on which a known wrong method comes to an answer that would become right.
    pub within: u64,
}

/// What one tolerance would change.
#[derive(Debug, Clone, PartialEq)]
pub struct WhatIf {
    /// For each column of the gradebook.
    pub parts: Vec<Change>,
    /// Change of points of each student.
    pub points: Vec<f64>,
    /// Wrong methods whose answers would become right: id and how many.
    pub methods: BTreeMap<String, u64>,
}

impl WhatIf {
    /// Nothing changed yet.
    pub fn new(students: usize, parts: usize) -> Self {
        Self { parts: vec![Change::default(); parts], points: vec![0.0; students], methods: BTreeMap::new() }
    }

    /// All parts together.
    pub fn total(&self) -> Change {
        let mut sum = Change::default();
        for part in &self.parts {
            sum.gained += part.gained;
            sum.lost += part.lost;
            sum.methods += part.methods;
            sum.within += part.within;
        }
        sum
    }

    /// Holds the row that counts for a student and a part against the key with the other tolerance.
    pub fn take(
        &mut self,
        row: &Row,
        (student, part): (usize, usize),
        entry: &KeyEntry,
        units: &mut UnitCache,
        say: &Feedback,
    ) {
        let Answer::Number { .. } = entry.answer else { return };
        if !matches!(row.verdict, Verdict::Right | Verdict::Wrong | Verdict::WrongDirection) {
            return;
        }
        let is = row.verdict == Verdict::Right;
        let would = judge_with(&row.answer, entry, units, say).verdict == Verdict::Right;
        if is == would {
            return;
        }
        let change = &mut self.parts[part];
        let whole = row.max_points * factors(&row.credit);
        // What a correction gives, everybody keeps.
        let least = if row.credit.split(' ').any(|w| w == "correction") { row.points } else { 0.0 };
        if would {
            change.gained += 1;
            self.points[student] += (whole - row.points).max(0.0);
            if !row.methods.is_empty() {
                change.methods += 1;
                for id in row.methods.split(' ') {
                    *self.methods.entry(id.to_owned()).or_default() += 1;
                }
            }
        } else {
            change.lost += 1;
            self.points[student] -= row.points - least;
        }
    }

    /// Counts a sheet on which a wrong method comes to an answer that is not right now, and would be by the other key.
    pub fn key(&mut self, part: usize, now: &KeyEntry, other: &KeyEntry) {
        let right = |entry: &KeyEntry, x: f64| match entry.answer {
            Answer::Number { value, half_width, .. } => accepts(x, value, half_width),
            Answer::Word { .. } => false,
        };
        if now.wrong.iter().any(|w| right(other, w.value) && !right(now, w.value)) {
            self.parts[part].within += 1;
        }
    }
}

/// What attempts and lateness leave of the points: the product of the factors in the column `credit`.
pub fn factors(credit: &str) -> f64 {
    let factor = |word: &str| match word.split_once(':') {
        Some(("attempt" | "late", factor)) => factor.parse::<f64>().ok().filter(|f| f.is_finite()),
        _ if word == "closed" => Some(0.0),
        _ => None,
    };
    credit.split(' ').filter_map(factor).product()
}
