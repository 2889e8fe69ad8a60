//! The walk that judges and writes: a row of answers.csv for each answer cell, in the order of the input.
use crate::answer::submissions::{Batch, Record, RecordFault, RecordScratch};
use crate::grade::attempts::{CellNote, Chosen, QUICK_VERDICTS};
use crate::grade::award::{awarded, diagnosed};
use crate::grade::cells::{AnswerCell, GradingJob, cells};
use crate::grade::choose::{Winner, line_of};
use crate::grade::layout::{FileForm, RecordKind, clean, kind_of_record, open_quote, trimmed};
use crate::grade::quick::{Belongs, Quick};
use crate::grade::row::{AnswerRow, HOLE, RowPattern};
use crate::grade::run::{Graded, VerdictCounts};
use crate::grade::table::{KeyTable, joined};
use crate::grade::verdict::{Judgement, Verdict};
use std::borrow::Cow;

/// What a worker counts while it writes.
pub(crate) struct WriterCounts {
    scratch: RecordScratch,
    quick: Quick,
    points: Vec<(u32, f64)>,
    cells: u64,
    undated: u64,
    respelled: u64,
    counts: VerdictCounts,
    by_column: Vec<VerdictCounts>,
}

impl WriterCounts {
    /// Nothing yet.
    pub fn new(table: &KeyTable) -> WriterCounts {
        WriterCounts {
            scratch: RecordScratch::default(),
            quick: Quick::default(),
            points: Vec::new(),
            cells: 0,
            undated: 0,
            respelled: 0,
            counts: VerdictCounts::default(),
            by_column: vec![VerdictCounts::default(); table.columns.len()],
        }
    }
    #[inline]
    fn count(&mut self, verdict: Verdict, column: Option<usize>) {
        self.cells += 1;
        self.counts[verdict as usize] += 1;
        if let Some(column) = column {
            self.by_column[column][verdict as usize] += 1;
        }
    }
    /// Adds what was counted.
    pub fn add_to(self, graded: &mut Graded) {
        graded.cells += self.cells;
        graded.undated += self.undated;
        graded.respelled += self.respelled;
        let add = |to: &mut VerdictCounts, from: &VerdictCounts| {
            to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
        };
        add(&mut graded.counts, &self.counts);
        for (to, from) in graded.by_column.iter_mut().zip(&self.by_column) {
            add(to, from);
        }
        for (index, points) in self.points {
            graded.points[index as usize] = Some(points);
        }
    }
}

/// Judges and writes.
pub(crate) struct RowWriter<'w> {
    job: &'w GradingJob<'w>,
    chosen: &'w Chosen,
    /// The places of the attempts that count; none where more is to be said than that.
    places: Vec<u64>,
    /// For each column what is written of a superseded attempt, by its verdict: most rows of a large file are such.
    superseded: Vec<[Option<RowPattern>; QUICK_VERDICTS.len()]>,
}

fn text(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

impl<'w> RowWriter<'w> {
    /// When it is known which attempts count.
    pub fn new(job: &'w GradingJob<'w>, chosen: &'w Chosen) -> Self {
        let place = |w: &Winner| if w.by_row { Winner::NONE.at } else { w.at };
        let pattern = |what: usize, verdict: Verdict| {
            let column = &job.table.columns[what];
            // The same for all students, or not known here.
            let max_points = job.table.points_of_all(what)?;
            let header = match &job.layout.form {
                FileForm::Long { .. } => "",
                FileForm::Wide(all) => all
                    .iter()
                    .find(|w| w.column.is_some_and(|c| c as usize == what))
                    .map_or("", |w| &w.header),
            };
            let hole = || Cow::Borrowed(HOLE);
            RowPattern::of(&AnswerRow {
                column: header.into(),
                student: hole(),
                problem: column.number.to_string().into(),
                part: column.part.as_str().into(),
                answer: hole(),
                verdict: Verdict::Superseded,
                max_points,
                reason: job.say.superseded(HOLE, verdict).into(),
                submitted_at: hole(),
                ..AnswerRow::EMPTY
            })
        };
        RowWriter {
            job,
            chosen,
            places: chosen.winners.iter().map(place).collect(),
            superseded: (0..job.table.columns.len())
                .map(|what| QUICK_VERDICTS.map(|verdict| pattern(what, verdict)))
                .collect(),
        }
    }

    /// Judges and writes a batch.
    pub fn batch(&self, counts: &mut WriterCounts, batch: &Batch, out: &mut Vec<u8>) {
        let GradingJob { layout, say, .. } = *self.job;
        let mut notes = self.chosen.notes.get(&batch.number).map_or(&[][..], |n| n).iter();
        let mut scratch = std::mem::take(&mut counts.scratch);
        batch.records(&mut scratch, |record| {
            let (verdict, reason) = match kind_of_record(record, layout, say) {
                RecordKind::Cells => {
                    let submitted = layout.submitted.and_then(|i| record.get(i)).map_or(&b""[..], trimmed);
                    cells(record, layout, |cell| {
                        let note = notes.next().copied().unwrap_or(CellNote::NONE);
                        if self.superseded(counts, cell, note, submitted, out).is_none() {
                            self.judge(counts, record, cell, submitted).write(out);
                        }
                    });
                    return;
                }
                RecordKind::Empty => (Verdict::Blank, say.get("feedback.empty_record").to_owned()),
                RecordKind::Unreadable(reason) => (Verdict::Unreadable, reason),
            };
            counts.count(verdict, None);
            self.whole_record(record, verdict, &reason).write(out);
        });
        counts.scratch = scratch;
    }

    /// Writes the row of an attempt that does not count from what was noted of it; `None`: nothing is written.
    #[inline]
    fn superseded(
        &self,
        counts: &mut WriterCounts,
        cell: &AnswerCell,
        note: CellNote,
        submitted: &[u8],
        out: &mut Vec<u8>,
    ) -> Option<()> {
        let (index, verdict) = note.read()?;
        let winner = *self.places.get(index)?;
        if winner == Winner::NONE.at || winner == cell.place() {
            return None;
        }
        let what = index % self.superseded.len();
        let pattern = self.superseded[what][verdict].as_ref()?;
        pattern.write(out, cell.line, [cell.student, cell.answer, submitted], line_of(winner));
        counts.count(Verdict::Superseded, Some(what));
        Some(())
    }

    /// The row of a record that has no cells: nothing stands in it, or it cannot be read. What stands before the trouble can be
    /// shown in its column.
    fn whole_record<'r>(&self, record: &'r Record<'r>, verdict: Verdict, reason: &'r str) -> AnswerRow<'r>
    where
        'w: 'r,
    {
        let GradingJob { table, layout, .. } = *self.job;
        let before_answer = match &layout.form {
            FileForm::Long { answer, .. } => *answer,
            FileForm::Wide(_) => usize::MAX,
        };
        let bytes = record.fault() == Some(RecordFault::Bytes);
        let field = |i: usize| -> &'r [u8] {
            let text = trimmed(record.get(i).unwrap_or_default());
            let in_place = i < before_answer || (bytes && record.len() == layout.width);
            let fits = record.fault().is_none() || (bytes && clean(text));
            if fits && in_place { text } else { b"" }
        };
        let student = field(layout.student);
        let mut max_points = 0.0;
        let (mut of_problem, mut of_part) = (Cow::Borrowed(""), Cow::Borrowed(""));
        if let FileForm::Long { problem, part, .. } = layout.form {
            (of_problem, of_part) = (text(field(problem)), text(field(part)));
            let mut key = Vec::new();
            joined(field(problem), field(part), &mut key);
            if let Some(what) = table.column(&key) {
                let column = &table.columns[what as usize];
                (of_problem, of_part) = (column.number.to_string().into(), column.part.as_str().into());
                let who = table.student(student);
                max_points = who.map_or(0.0, |who| table.quick(self.job.index(who, what)).1.points);
            }
        }
        AnswerRow {
            line: record.line(),
            student: text(student),
            problem: of_problem,
            part: of_part,
            answer: record.shown(layout.delimiter).into(),
            verdict,
            max_points,
            reason: reason.into(),
            submitted_at: layout.submitted.map_or("".into(), |at| text(field(at))),
            ..AnswerRow::EMPTY
        }
    }

    /// Judges a cell: its row.
    fn judge<'r>(
        &self,
        counts: &mut WriterCounts,
        record: &Record,
        cell: &AnswerCell<'r>,
        submitted: &'r [u8],
    ) -> AnswerRow<'r>
    where
        'w: 'r,
    {
        let GradingJob { table, say, rules, layout } = *self.job;
        let Belongs { who, what, respelled } = counts.quick.find(table, cell);
        let (problem, part) = match what.map(|what| &table.columns[what as usize]) {
            Some(column) => (column.number.to_string().into(), column.part.as_str().into()),
            None => (text(cell.problem), text(cell.part)),
        };
        let mut row = AnswerRow {
            line: cell.line,
            column: cell.wide.map_or("".into(), |(_, column)| column.header.as_str().into()),
            student: who
                .map_or_else(|| text(cell.student), |who| table.students[who as usize].id.as_str().into()),
            problem,
            part,
            answer: text(cell.answer),
            submitted_at: text(submitted),
            ..AnswerRow::EMPTY
        };
        let (Some(who), Some(what)) = (who, what) else {
            (row.verdict, row.reason) = match who {
                None => (Verdict::UnknownStudent, table.unknown_student(&text(cell.student), say).into()),
                Some(_) => {
                    let reason = table.unknown_part(&text(cell.problem), &text(cell.part), say);
                    (Verdict::UnknownPart, reason.into())
                }
            };
            counts.count(row.verdict, None);
            return row;
        };
        let index = self.job.index(who, what);
        row.max_points = table.quick(index).1.points;
        let mut judgement = self.job.judged((who, what), cell.answer, &mut counts.quick);
        if judgement.verdict == Verdict::Unreadable
            && record.quote_left_open()
            && cell.answer.trim_ascii_start().starts_with(b"\"")
        {
            judgement.reason = open_quote(cell.line, say);
        }
        if respelled {
            counts.respelled += 1;
            let pieces = [("written", &*text(cell.student)), ("student", &*row.student)];
            let said = say.fill("feedback.respelled", &pieces);
            judgement.reason = Cow::Owned(format!("{}; {said}", judgement.reason));
        }
        let winner = self.chosen.winners[index];
        let is_attempt = !matches!(judgement.verdict, Verdict::Blank | Verdict::UnknownPart);
        let by_row = winner.by_row && is_attempt;
        if is_attempt && winner.at != cell.place() {
            row.verdict = Verdict::Superseded;
            row.reason = self.superseded_reason(&judgement, &winner).into();
            counts.count(row.verdict, Some(what as usize));
            return row;
        }
        row.verdict = judgement.verdict;
        row.points = judgement.points;
        let wrong = matches!(judgement.verdict, Verdict::Wrong | Verdict::WrongDirection);
        let fits = wrong.then(|| diagnosed(table, (who, what), cell.answer, &mut judgement, say));
        if is_attempt {
            let (points, credit) = awarded(
                self.job,
                (who, what),
                &mut judgement,
                fits.as_ref(),
                (&winner, submitted),
                &self.chosen.winners,
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
        counts.count(row.verdict, Some(what as usize));
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
