//! The answer key: plain data, one entry for each part of each problem.
use crate::num::formula::Formula;
use crate::units::Unit;
use std::sync::Arc;

/// What the right answer is.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// A number, SI.
    Number {
        /// Value, SI.
        value: f64,
        /// Accepted half-width, SI, >= 0: max(rel |value|, abs).
        half_width: f64,
        /// Signed along a line, where sheets say that a word (`up`) may give the sign.
        directed: bool,
        /// A magnitude: the key is >= 0.
        magnitude: bool,
        /// What words of direction say of the sign; `None` where they are passed over, because none is asked.
        words: Option<WordSigns>,
        /// A direction: whole turns more or less are the same.
        cyclic: bool,
    },
    /// A word, one of those offered.
    Word {
        /// The right one, such as `up`.
        right: &'static str,
        /// All that are offered, such as `up`, `down`.
        offered: &'static [&'static str],
    },
}

/// The sign that each of two opposite words of direction gives a number: that of the first, 1 or -1; 0 where they do not fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WordSigns {
    /// Up, down.
    pub up: i8,
    /// Forward, back.
    pub forward: i8,
    /// To the right, to the left.
    pub right: i8,
    /// Counter-clockwise, clockwise.
    pub counter_clockwise: i8,
}

/// The key of one part.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyEntry {
    /// Id of the part.
    pub part: String,
    /// The right answer.
    pub answer: Answer,
    /// Unit in which it is asked (dimensionless for a word).
    pub unit: Unit,
    /// Must a unit be written?
    pub unit_required: bool,
    /// Points for a right answer.
    pub points: f64,
    /// Value from the equations of motion, SI.
    pub eom: Option<f64>,
    /// Value from work and energy, SI.
    pub energy: Option<f64>,
    /// Gap of the two.
    pub gap: Option<f64>,
    /// Condition number.
    pub cond: Option<f64>,
    /// Proved: the true answer for the printed data lies within this of the value, SI.
    pub bound: Option<f64>,
    /// Where wrong methods come to, in the order of [`ProblemKey::methods`].
    pub wrong: Vec<WrongValue>,
    /// The code of its variant, where that is another than the problem's.
    pub code: Option<Box<str>>,
}

/// Where one wrong method comes to for one part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrongValue {
    /// Which: an index into [`ProblemKey::methods`].
    pub method: u16,
    /// What it comes to, SI; a magnitude where one is asked.
    pub value: f64,
}

/// Finds where the wrong methods of a student's problem come to, part by part. Student and problem are counted from 0.
pub trait FindWrong: Sync {
    /// For all parts of the problem.
    fn values(&self, student: usize, problem: usize) -> &[Vec<WrongValue>];
}

/// The key of one sheet: problems in the order of the sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetKey {
    /// Student id.
    pub student: String,
    /// One for each problem.
    pub problems: Vec<ProblemKey>,
}

/// The key of one problem of one student.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProblemKey {
    /// Id of the problem.
    pub id: String,
    /// The code of the variant; empty where it is of no set.
    pub code: String,
    /// Parts in order.
    pub parts: Vec<KeyEntry>,
    /// Ids of the wrong methods of the problem.
    pub methods: Arc<[String]>,
    /// Which parts follow from which.
    pub follows: Arc<[KeyFollow]>,
    /// What the relations of `follows` and the guards of follow-through need: the data, SI, then other quantities.
    pub known: Box<[f64]>,
    /// Numbers of the statement, SI and as printed: who answers with one of them has not computed it.
    pub given: Box<[f64]>,
}

impl ProblemKey {
    /// The code of the variant of which a part is asked.
    pub fn code_of<'k>(&'k self, entry: &'k KeyEntry) -> &'k str {
        entry.code.as_deref().unwrap_or(&self.code)
    }

    /// Takes a part from the key of another variant: a quiz may have asked each part with other data.
    pub fn take_part(&mut self, part: &str, other: &ProblemKey) {
        let code = (other.code != self.code).then(|| other.code.as_str().into());
        let entry = other.parts.iter().find(|e| e.part == part);
        if let (Some(own), Some(entry)) = (self.parts.iter_mut().find(|e| e.part == part), entry) {
            *own = KeyEntry { code, ..entry.clone() };
        }
    }
}

/// A part that follows from others: `v` from `omega` by `r omega`.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyFollow {
    /// The part, by its index in the problem.
    pub part: usize,
    /// The parts from which it follows, each with a smaller index.
    pub from: Vec<usize>,
    /// How.
    pub by: Formula<Given>,
}

/// A value in the relation of a [`KeyFollow`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// Of [`ProblemKey::known`], times a factor.
    Known(usize, f64),
    /// The answer to a part.
    Part(usize),
}
