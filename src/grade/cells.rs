//! The answer cells of a record, in whatever form the file is.
use crate::answer::submissions::Record;
use crate::grade::attempt::place;
use crate::grade::feedback::Feedback;
use crate::grade::layout::{FileForm, FileLayout, WideColumn, trimmed};
use crate::grade::rules::Rules;
use crate::grade::table::KeyTable;
use crate::key::{FindWrong, WrongValue};
use crate::policy::time::Moment;
use std::borrow::Cow;

/// What does not change during a grading.
pub(crate) struct GradingJob<'j> {
    pub table: &'j KeyTable,
    pub layout: &'j FileLayout,
    pub rules: &'j Rules<'j>,
    pub say: &'j Feedback<'j>,
    /// Where wrong methods come to, if the table does not say it.
    pub wrong: Option<&'j dyn FindWrong>,
}

/// A cell as it was handed in.
pub(crate) struct AnswerCell<'a> {
    pub line: u64,
    /// The column of a wide file, and its number among those with answers.
    pub wide: Option<(usize, &'a WideColumn)>,
    pub student: &'a [u8],
    pub problem: &'a [u8],
    pub part: &'a [u8],
    pub answer: &'a [u8],
    /// Code of the variant to which it was given; empty where the file does not say it.
    pub code: &'a [u8],
}

impl AnswerCell<'_> {
    #[inline]
    pub fn place(&self) -> u64 {
        place(self.line, self.wide.map_or(0, |(i, _)| i))
    }
}

/// Bytes of a file as text, for people.
pub(crate) fn lossy(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

/// Calls `each` for every answer cell of a record.
#[inline]
pub(crate) fn cells<'a>(record: &Record<'a>, layout: &'a FileLayout, mut each: impl FnMut(&AnswerCell<'a>)) {
    let field = |i: usize| record.get(i).unwrap_or_default();
    let (line, student) = (layout.line(record), trimmed(field(layout.student)));
    let code = layout.code.map_or(&b""[..], field);
    match &layout.form {
        FileForm::Long { problem, part, answer } => {
            let (problem, part) = (trimmed(field(*problem)), trimmed(field(*part)));
            each(&AnswerCell { line, wide: None, student, problem, part, answer: field(*answer), code });
        }
        FileForm::Wide(all) => {
            for (index, one) in all.iter().enumerate() {
                let (problem, part) = (one.problem.as_bytes(), one.part.as_bytes());
                let wide = Some((index, one));
                each(&AnswerCell { line, wide, student, problem, part, answer: field(one.field), code });
            }
        }
    }
}

impl GradingJob<'_> {
    /// Where wrong methods come to for a part of a student.
    pub fn wrong_values(&self, who: usize, what: usize) -> &[WrongValue] {
        let Some((problem, part)) = self.table.problem_of(who, what) else { return &[] };
        match self.wrong {
            Some(wrong) => {
                let of_problem = wrong.values(who, self.table.columns[what].number - 1);
                of_problem.get(part).map_or(&[], Vec::as_slice)
            }
            None => &problem.parts[part].wrong,
        }
    }

    /// The number of a student and a column in lists of all cells.
    #[inline]
    pub fn index(&self, who: u32, what: u32) -> usize {
        who as usize * self.table.columns.len() + what as usize
    }

    /// The time of a record as far as it can be read.
    pub fn moment(&self, record: &Record) -> Option<Moment> {
        let text = record.get(self.layout.submitted?).and_then(|t| std::str::from_utf8(t).ok())?;
        self.rules.policy.zone.read(text)
    }
}
