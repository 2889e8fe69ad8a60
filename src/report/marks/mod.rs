//! Marks as plain data: for each student and part the row that counts, how often it was tried and when it was first
//! right. What is held grows with students times parts, not with rows.
mod read;

use crate::grade::row::AnswerRow;
use crate::grade::verdict::Verdict;
use crate::set::store::StoredStudent;
use std::collections::BTreeMap;

/// A part of a problem.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MarkedPart {
    /// Number of the problem, from 1.
    pub number: usize,
    pub id: String,
    /// Most points.
    pub points: f64,
    /// Unit in which it is asked, empty for none.
    pub unit: String,
    /// Must it be written?
    pub unit_required: bool,
    /// What is asked, in words: Markdown with formulas, in the language of the reports; empty where it changes with the variant.
    pub asked: String,
    /// What counts as right, in words; empty for answers that are words.
    pub tolerance: String,
}

impl MarkedPart {
    /// `1.omega`
    pub fn label(&self) -> String {
        format!("{}.{}", self.number, self.id)
    }
}

/// Who is there and what was asked.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MarkedClass {
    /// In the order of the set.
    pub students: Vec<StoredStudent>,
    /// Titles of the problems, in the order of the sheet.
    pub problems: Vec<String>,
    /// In the order of the sheet.
    pub parts: Vec<MarkedPart>,
    /// Does the sheet of a student have a part? Row after row, one for each student.
    pub asked: Vec<bool>,
    /// Does the day come first in dates? `None`: they must say themselves.
    pub day_first: Option<bool>,
}

/// Signs of an answer or a reason that are kept.
pub const LONGEST: usize = 240;

/// All that is known of one student and part.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MarkedCell {
    /// The row that counts, its answer and reason shortened to [`LONGEST`]; none where nothing but blanks was handed in.
    pub row: Option<AnswerRow<'static>>,
    /// Rows that are not blank.
    pub attempts: u32,
    /// Which of them was right first, from 1; in the order of time, where times are known.
    pub first_right: Option<u32>,
    /// Seconds from the first attempt at this part to the first right one, where both times are known.
    pub seconds: Option<f64>,
}

/// Cells that could not be read, of one part and for one reason.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UnreadableCells {
    pub cells: u64,
    /// Some of them, the first of the file.
    pub examples: Vec<String>,
}

/// Examples kept for each kind of trouble.
pub(crate) const EXAMPLES: usize = 3;

/// Part (index, none for a row that belongs to none), verdict, reason.
pub type TroubleKey = (Option<usize>, Verdict, String);

/// The marks of a class.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marks {
    pub class: MarkedClass,
    /// Row after row, one for each student.
    pub cells: Vec<MarkedCell>,
    /// Points of each cell as the gradebook has them, corrections included; `None` where it has none.
    pub given: Vec<Option<f64>>,
    /// Points of each student and of how many, what is dropped and rounded included.
    pub totals: Vec<(f64, f64)>,
    /// Problems (indices) of each student that do not count.
    pub dropped: Vec<Vec<usize>>,
    /// Rows of answers.csv by verdict, in the order of `Verdict::ALL`.
    pub verdicts: [u64; Verdict::ALL.len()],
    /// The same for each part.
    pub by_part: Vec<[u64; Verdict::ALL.len()]>,
    pub rows: u64,
    /// Is there a column of times that can be read?
    pub timed: bool,
    /// Cells that could not be read, or have a unit of another kind or none where one is demanded.
    pub troubles: BTreeMap<TroubleKey, UnreadableCells>,
}

impl Marks {
    /// Points of a student for a part; 0 where nothing was given.
    pub fn points(&self, student: usize, part: usize) -> f64 {
        self.given[student * self.class.parts.len() + part].unwrap_or(0.0)
    }
    pub fn cell(&self, student: usize, part: usize) -> &MarkedCell {
        &self.cells[student * self.class.parts.len() + part]
    }
    /// Does the sheet of a student have a part?
    pub fn asked(&self, student: usize, part: usize) -> bool {
        self.class.asked[student * self.class.parts.len() + part]
    }
    /// Did a student hand in anything that is not blank?
    pub fn took_part(&self, student: usize) -> bool {
        (0..self.class.parts.len()).any(|p| self.cell(student, p).attempts > 0)
    }
    /// Points of a student and the most that the sheet gives, as sums of parts.
    pub fn sum(&self, student: usize) -> (f64, f64) {
        let mut sum = (0.0, 0.0);
        for p in 0..self.class.parts.len() {
            sum.0 += self.cell(student, p).row.as_ref().map_or(0.0, |r| r.points);
            sum.1 += if self.asked(student, p) { self.class.parts[p].points } else { 0.0 };
        }
        sum
    }
}
