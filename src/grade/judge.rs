//! The verdict on an answer cell, and its row of answers.csv.
use crate::answer::submissions::Record;
use crate::grade::attempt::{Winner, line_of};
use crate::grade::award::{awarded, diagnosed};
use crate::grade::cells::{AnswerCell, GradingJob, lossy};
use crate::grade::compare::{compare_with, verdict_on};
use crate::grade::counts::GradedCounts;
use crate::grade::fast_number::SiReader;
use crate::grade::layout::{blank, open_quote};
use crate::grade::owner::{Belongs, Finder};
use crate::grade::row::{AnswerRow, OF_ANOTHER};
use crate::grade::verdict::{Judgement, Verdict};
use std::borrow::Cow;

impl GradingJob<'_> {
    /// The verdict and the number of a cell if they can be had the quick way, which needs no text.
    #[inline]
    pub fn quickly(&self, index: usize, answer: &[u8], numbers: &mut SiReader) -> Option<(Verdict, f64)> {
        let (key, asked) = self.table.quick(index);
        let x = numbers.si(self.table, asked, answer)?;
        Some((verdict_on(x, key.value, key.half_width), x))
    }

    /// Judges a cell whose student and column are known.
    pub fn judged(&self, (who, what): (u32, u32), answer: &[u8], numbers: &mut SiReader) -> Judgement<'_> {
        let GradingJob { table, say, .. } = *self;
        let index = self.index(who, what);
        if let Some((verdict, number)) = self.quickly(index, answer, numbers) {
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
            Some(entry) => compare_with(&lossy(answer), entry, &mut numbers.units, say),
            None => Judgement {
                verdict: Verdict::UnknownPart,
                points: 0.0,
                reason: Cow::Borrowed(say.get("feedback.no_such_part")),
                number: f64::NAN,
            },
        }
    }
}

/// What one worker remembers and counts while it judges.
pub(crate) struct Judging {
    pub finder: Finder,
    pub numbers: SiReader,
    pub counts: GradedCounts,
}

/// Judges cells when it is known which attempts count.
pub(crate) struct Judge<'w> {
    pub job: &'w GradingJob<'w>,
    /// A row of parts for each student.
    pub winners: &'w [Winner],
}

impl<'w> Judge<'w> {
    /// Judges a cell: its row.
    pub fn row<'r>(
        &self,
        judging: &mut Judging,
        record: &Record,
        cell: &AnswerCell<'r>,
        submitted: &'r [u8],
    ) -> AnswerRow<'r>
    where
        'w: 'r,
    {
        let GradingJob { table, say, rules, layout, .. } = *self.job;
        let Judging { finder, numbers, counts } = judging;
        let Belongs { who, what, respelled, of_another } = finder.find(table, cell);
        let (problem, part) = match what.map(|what| &table.columns[what as usize]) {
            Some(column) => (column.number.to_string().into(), column.part.as_str().into()),
            None => (lossy(cell.problem), lossy(cell.part)),
        };
        let mut row = AnswerRow {
            line: cell.line,
            column: cell.wide.map_or("".into(), |(_, column)| column.header.as_str().into()),
            student: who
                .map_or_else(|| lossy(cell.student), |who| table.students[who as usize].id.as_str().into()),
            problem,
            part,
            answer: lossy(cell.answer),
            submitted_at: lossy(submitted),
            ..AnswerRow::default()
        };
        let (Some(who), Some(what)) = (who, what) else {
            (row.verdict, row.reason) = match who {
                None => (Verdict::UnknownStudent, table.unknown_student(&lossy(cell.student), say).into()),
                Some(_) => {
                    let reason = table.unknown_part(&lossy(cell.problem), &lossy(cell.part), say);
                    (Verdict::UnknownPart, reason.into())
                }
            };
            counts.verdict(row.verdict, None);
            return row;
        };
        let index = self.job.index(who, what);
        row.max_points = table.points(index);
        if of_another && !blank(cell.answer) {
            row.verdict = Verdict::Superseded;
            let (code, counts_code) = (lossy(cell.code), table.code(who as usize, what as usize));
            let pieces = [("code", &*code), ("counts", counts_code)];
            row.reason = say.fill("feedback.other_variant", &pieces);
            row.credit = format!("{OF_ANOTHER}{code}").into();
            counts.verdict(row.verdict, Some(what as usize));
            return row;
        }
        let mut judgement = self.job.judged((who, what), cell.answer, numbers);
        if judgement.verdict == Verdict::Unreadable
            && record.open
            && cell.answer.trim_ascii_start().starts_with(b"\"")
        {
            judgement.reason = open_quote(cell.line, say);
        }
        if respelled {
            counts.respelled += 1;
            let pieces = [("written", &*lossy(cell.student)), ("student", &*row.student)];
            let said = say.fill("feedback.respelled", &pieces);
            judgement.reason = Cow::Owned(format!("{}; {said}", judgement.reason));
        }
        let winner = self.winners[index];
        let is_attempt = !matches!(judgement.verdict, Verdict::Blank | Verdict::UnknownPart);
        let by_row = winner.by_row && is_attempt;
        if is_attempt && winner.at != cell.place() {
            row.verdict = Verdict::Superseded;
            row.reason = self.superseded_reason(&judgement, &winner).into();
            counts.verdict(row.verdict, Some(what as usize));
            return row;
        }
        row.verdict = judgement.verdict;
        row.points = judgement.points;
        let wrong = matches!(judgement.verdict, Verdict::Wrong | Verdict::WrongDirection);
        let fits = wrong.then(|| diagnosed(self.job, (who, what), cell.answer, &mut judgement));
        if is_attempt {
            let (points, credit) = awarded(
                self.job,
                (who, what),
                &mut judgement,
                fits.as_ref(),
                (&winner, submitted),
                self.winners,
            );
            (row.points, row.credit) = (points, credit.into());
            counts.points.push((index as u32, points));
            let undated = rules.policy.timed() && (winner.undated || layout.submitted.is_none());
            counts.undated += u64::from(undated);
        }
        row.reason = match by_row {
            true => format!("{}; {}", judgement.reason, say.get("feedback.by_row")).into(),
            false => judgement.reason,
        };
        if let Some(fits) = fits {
            (row.methods, row.slip) = (fits.methods.into(), fits.slip.into());
        }
        counts.verdict(row.verdict, Some(what as usize));
        row
    }
    /// Why an attempt does not count, what it would have been, and why that where the verdict does not say it.
    fn superseded_reason(&self, judgement: &Judgement, winner: &Winner) -> String {
        let say = self.job.say;
        let plain = judgement.verdict != Verdict::Unreadable && matches!(judgement.reason, Cow::Borrowed(_));
        let mut reason = say.superseded(&line_of(winner.at).to_string(), judgement.verdict);
        if !plain {
            reason = format!("{reason}: {}", judgement.reason);
        }
        if winner.by_row {
            let how = if plain { "feedback.by_row_short" } else { "feedback.by_row" };
            reason = format!("{reason}; {}", say.get(how));
        }
        reason
    }
}
