//! What other tolerances would make of answers that are graded already: which verdicts would change, and which wrong
//! methods would pass for right.
use crate::grade::compare::accepts;
use crate::key::{Answer, KeyEntry};
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

/// The answer that counts for a student and a part, if there is one.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct AnswerUnder {
    pub right: bool,
    /// Ids of the wrong methods that it fits.
    pub methods: String,
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
    pub fn take(&mut self, now: &[AnswerUnder], other: &[AnswerUnder]) {
        let parts = self.parts.len().max(1);
        for (i, (was, is)) in now.iter().zip(other).enumerate() {
            let change = &mut self.parts[i % parts];
            if is.right && !was.right {
                change.gained += 1;
                if !was.methods.is_empty() {
                    change.methods += 1;
                    for id in was.methods.split(' ') {
                        *self.methods.entry(id.to_owned()).or_default() += 1;
                    }
                }
            } else if was.right && !is.right {
                change.lost += 1;
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
