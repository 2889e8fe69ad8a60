//! The answer cells of a record, in whatever form the file is, and the judgement of one.
use crate::answer::submissions::Record;
use crate::grade::choose::place;
use crate::grade::feedback::Feedback;
use crate::grade::judge::{accepts, judge_with};
use crate::grade::layout::{FileForm, FileLayout, WideColumn, trimmed};
use crate::grade::quick::Quick;
use crate::grade::rules::Rules;
use crate::grade::table::{KeyTable, QuickKey};
use crate::grade::verdict::{Judgement, Verdict};
use crate::policy::time::Moment;
use std::borrow::Cow;

/// What does not change during a grading.
pub(crate) struct GradingJob<'j> {
    pub table: &'j KeyTable,
    pub layout: &'j FileLayout,
    pub rules: &'j Rules<'j>,
    pub say: &'j Feedback<'j>,
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
}

impl AnswerCell<'_> {
    /// Where it stands.
    #[inline]
    pub fn place(&self) -> u64 {
        place(self.line, self.wide.map_or(0, |(i, _)| i))
    }
}

/// Calls `each` for every answer cell of a record.
#[inline]
pub(crate) fn cells<'a>(record: &Record<'a>, layout: &'a FileLayout, mut each: impl FnMut(&AnswerCell<'a>)) {
    let field = |i: usize| record.get(i).unwrap_or_default();
    let (line, student) = (record.line(), trimmed(field(layout.student)));
    match &layout.form {
        FileForm::Long { problem, part, answer } => {
            let (problem, part) = (trimmed(field(*problem)), trimmed(field(*part)));
            each(&AnswerCell { line, wide: None, student, problem, part, answer: field(*answer) });
        }
        FileForm::Wide(all) => {
            for (index, one) in all.iter().enumerate() {
                let (problem, part) = (one.problem.as_bytes(), one.part.as_bytes());
                let wide = Some((index, one));
                each(&AnswerCell { line, wide, student, problem, part, answer: field(one.field) });
            }
        }
    }
}

/// What the number `x`, SI, is for a key.
#[inline]
pub(crate) fn verdict_on(x: f64, key: &QuickKey) -> Verdict {
    if accepts(x, key.value, key.half_width) {
        Verdict::Right
    } else if accepts(-x, key.value, key.half_width) {
        Verdict::WrongDirection
    } else {
        Verdict::Wrong
    }
}

impl GradingJob<'_> {
    /// The number of a student and a column in lists of all cells.
    #[inline]
    pub fn index(&self, who: u32, what: u32) -> usize {
        who as usize * self.table.columns.len() + what as usize
    }

    /// The verdict and the number of a cell if they can be had the quick way, which needs no text.
    #[inline]
    pub fn quickly(&self, index: usize, answer: &[u8], quick: &mut Quick) -> Option<(Verdict, f64)> {
        let (key, asked) = self.table.quick(index);
        let x = quick.si(self.table, asked, answer)?;
        Some((verdict_on(x, key), x))
    }

    /// Judges a cell whose student and column are known.
    pub fn judged(&self, (who, what): (u32, u32), answer: &[u8], quick: &mut Quick) -> Judgement<'_> {
        let GradingJob { table, say, .. } = *self;
        let index = self.index(who, what);
        if let Some((verdict, number)) = self.quickly(index, answer, quick) {
            let (_, asked) = table.quick(index);
            let (points, reason) = match verdict {
                Verdict::Right => (asked.points, say.within),
                Verdict::WrongDirection if asked.magnitude => (0.0, say.no_sign),
                Verdict::WrongDirection => (0.0, say.other_sign),
                _ => (0.0, say.outside),
            };
            return Judgement { verdict, points, reason: Cow::Borrowed(reason), number };
        }
        match table.entry(who as usize, what as usize) {
            Some(entry) => judge_with(&String::from_utf8_lossy(answer), entry, quick.units(), say),
            None => Judgement {
                verdict: Verdict::UnknownPart,
                points: 0.0,
                reason: Cow::Borrowed(say.get("feedback.no_such_part")),
                number: f64::NAN,
            },
        }
    }

    /// The time of a record as far as it can be read.
    pub fn moment(&self, record: &Record) -> Option<Moment> {
        let text = record.get(self.layout.submitted?).and_then(|t| std::str::from_utf8(t).ok())?;
        self.rules.policy.zone.read(text)
    }
}
