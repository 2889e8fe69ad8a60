//! Ends of the lines of answers.csv that many rows share: they are put together once.
use crate::grade::diagnose::Slip;
use crate::grade::feedback::Feedback;
use crate::grade::verdict::Verdict;
use crate::grade::write::push_float;
use crate::guard::push_text;

/// What the end of a line about a superseded attempt depends on, beside the line that superseded it and wrong methods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Kind {
    /// What it would have been.
    pub verdict: Verdict,
    /// A slip.
    pub slip: Option<Slip>,
    /// A magnitude is asked.
    pub magnitude: bool,
    /// Points of the part.
    pub points: f64,
}

/// The end of a line: `before`, the number of a line, `after`, wrong methods, `slip`.
#[derive(Debug)]
pub(crate) struct Tail {
    kind: Kind,
    /// From behind the answer to the number of the line that supersedes it.
    pub before: Vec<u8>,
    /// From there to the wrong methods.
    pub after: Vec<u8>,
    /// From there to the time.
    pub slip: Vec<u8>,
}

/// The ends put together so far, column by column.
#[derive(Debug, Default)]
pub(crate) struct Tails {
    columns: Vec<Vec<Tail>>,
}

/// Stands for the number of the line; no word list has it.
const MARK: u8 = 1;

impl Tails {
    /// The end of a line of this kind, if it was put together before.
    #[inline]
    pub fn find(&self, column: usize, kind: &Kind) -> Option<usize> {
        self.columns.get(column)?.iter().position(|tail| tail.kind == *kind)
    }
    /// An end that was found.
    #[inline]
    pub fn get(&self, column: usize, at: usize) -> Option<&Tail> {
        self.columns.get(column)?.get(at)
    }
    /// Puts one together. `reason` is what would have been said, `slip` is a word for machines, and what is told of it.
    /// `None` where the phrase does not name the line once.
    pub fn add(
        &mut self,
        column: usize,
        kind: Kind,
        say: &Feedback,
        reason: &str,
        (slip, told): (&str, &str),
    ) -> Option<usize> {
        let mut text = Vec::new();
        say.superseded(0, kind.verdict, |out, _| out.push(MARK), &mut text);
        if !told.is_empty() {
            text.extend_from_slice(format!(": {reason}; {told}").as_bytes());
        }
        let mut before = b",".to_vec();
        before.extend_from_slice(Verdict::Superseded.as_str().as_bytes());
        before.extend_from_slice(b",0,");
        push_float(&mut before, kind.points);
        before.push(b',');
        push_text(&mut before, &text);
        before.push(b',');
        let mut marks = before.iter().enumerate().filter(|(_, b)| **b == MARK).map(|(i, _)| i);
        let (Some(mark), None) = (marks.next(), marks.next()) else { return None };
        let mut after = before.split_off(mark);
        after.remove(0);
        let slip = format!(",{slip},,").into_bytes();
        if self.columns.len() <= column {
            self.columns.resize_with(column + 1, Vec::new);
        }
        self.columns[column].push(Tail { kind, before, after, slip });
        Some(self.columns[column].len() - 1)
    }
}
