//! What other tolerances would make of answers that are graded already: which verdicts would change, and which wrong
//! methods would pass for right.
use crate::grade::compare::accepts;
use crate::grade::row::AnswerRow;
use crate::grade::verdict::Verdict;
use crate::key::{Answer, KeyEntry};
use crate::regrade::changes::Grading;
use std::collections::BTreeMap;

/// What would change for one part, or for all.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ToleranceChange {
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
    pub parts: Vec<ToleranceChange>,
    /// Wrong methods whose answers would become right: id and how many.
    pub methods: BTreeMap<String, u64>,
}

impl WhatIf {
    /// Nothing changed yet.
    pub fn new(parts: usize) -> Self {
        Self { parts: vec![ToleranceChange::default(); parts], methods: BTreeMap::new() }
    }

    /// All parts together.
    pub fn total(&self) -> ToleranceChange {
        let mut sum = ToleranceChange::default();
        for part in &self.parts {
            sum.gained += part.gained;
            sum.lost += part.lost;
            sum.methods += part.methods;
            sum.within += part.within;
        }
        sum
    }

    /// Holds the answers that count of all students and parts against those of the grading as it is.
    pub fn take(&mut self, now: &Grading, other: &Grading) {
        let parts = self.parts.len().max(1);
        let right = |cell: &Option<AnswerRow>| cell.as_ref().is_some_and(|c| c.verdict == Verdict::Right);
        for (i, (was, is)) in now.cells.iter().zip(&other.cells).enumerate() {
            let change = &mut self.parts[i % parts];
            match (right(was), right(is)) {
                (false, true) => {
                    change.gained += 1;
                    let methods = was.as_ref().map_or("", |c| &*c.methods);
                    change.methods += u64::from(!methods.is_empty());
                    for id in methods.split_whitespace() {
                        *self.methods.entry(id.to_owned()).or_default() += 1;
                    }
                }
                (true, false) => change.lost += 1,
                _ => {}
            }
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
