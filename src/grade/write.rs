//! The walk that judges and writes: a row of answers.csv for each answer cell, in the order of the input.
use crate::answer::submissions::{Batch, Record, RecordFault, RecordScratch};
use crate::grade::attempt::{Winner, line_of};
use crate::grade::cells::{AnswerCell, GradingJob, cells, lossy};
use crate::grade::counts::GradedCounts;
use crate::grade::fast_number::SiReader;
use crate::grade::judge::{Judge, Judging};
use crate::grade::layout::{FileForm, RecordKind, clean, kind_of_record, trimmed};
use crate::grade::owner::Finder;
use crate::grade::row::{AnswerRow, HOLE, RowPattern};
use crate::grade::table::{KeyTable, joined};
use crate::grade::verdict::Verdict;
use crate::grade::winners::{CellNote, Chosen, QUICK_VERDICTS};
use std::borrow::Cow;

/// What a worker keeps while it writes.
pub(crate) struct Writing {
    scratch: RecordScratch,
    judging: Judging,
}

impl Writing {
    /// Nothing yet.
    pub fn new(table: &KeyTable) -> Writing {
        let counts = GradedCounts::new(table);
        let judging = Judging { finder: Finder::default(), numbers: SiReader::default(), counts };
        Writing { scratch: RecordScratch::default(), judging }
    }
    pub fn counts(self) -> GradedCounts {
        self.judging.counts
    }
}

/// Judges and writes.
pub(crate) struct RowWriter<'w> {
    judge: Judge<'w>,
    chosen: &'w Chosen,
    /// The places of the attempts that count; none where more is to be said than that.
    places: Vec<u64>,
    /// For each column what is written of a superseded attempt, by its verdict: most rows of a large file are such.
    superseded: Vec<[Option<RowPattern>; QUICK_VERDICTS.len()]>,
}

impl<'w> RowWriter<'w> {
    /// When it is known which attempts count.
    pub fn new(job: &'w GradingJob<'w>, chosen: &'w Chosen) -> Self {
        let place = |w: &Winner| if w.by_row { Winner::NONE.at } else { w.at };
        let pattern = |what: usize, verdict: Verdict| {
            let column = &job.table.columns[what];
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
                max_points: column.points,
                reason: job.say.superseded(HOLE, verdict).into(),
                submitted_at: hole(),
                ..AnswerRow::default()
            })
        };
        RowWriter {
            judge: Judge { job, winners: &chosen.winners },
            chosen,
            places: chosen.winners.iter().map(place).collect(),
            superseded: (0..job.table.columns.len())
                .map(|what| QUICK_VERDICTS.map(|verdict| pattern(what, verdict)))
                .collect(),
        }
    }

    /// Judges and writes a batch.
    pub fn batch(&self, writing: &mut Writing, batch: &Batch, out: &mut Vec<u8>) {
        let GradingJob { layout, say, .. } = *self.judge.job;
        let mut notes = self.chosen.notes.get(&batch.number).map_or(&[][..], |n| n).iter();
        let Writing { scratch, judging } = writing;
        batch.records(scratch, |record| {
            let (verdict, reason) = match kind_of_record(record, layout, say) {
                RecordKind::Cells => {
                    let submitted = layout.submitted.and_then(|i| record.get(i)).map_or(&b""[..], trimmed);
                    cells(record, layout, |cell| {
                        let note = notes.next().copied().unwrap_or(CellNote::NONE);
                        if self.superseded(&mut judging.counts, cell, note, submitted, out).is_none() {
                            self.judge.row(judging, record, cell, submitted).write(out);
                        }
                    });
                    return;
                }
                RecordKind::Empty => (Verdict::Blank, say.get("feedback.empty_record").to_owned()),
                RecordKind::Unreadable(reason) => (Verdict::Unreadable, reason),
            };
            judging.counts.verdict(verdict, None);
            self.whole_record(record, verdict, &reason).write(out);
        });
    }

    /// Writes the row of an attempt that does not count from what was noted of it; `None`: nothing is written.
    #[inline]
    fn superseded(
        &self,
        counts: &mut GradedCounts,
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
        counts.verdict(Verdict::Superseded, Some(what));
        Some(())
    }

    /// The row of a record that has no cells: nothing stands in it, or it cannot be read. What stands before the trouble can be
    /// shown in its column.
    fn whole_record<'r>(&self, record: &'r Record<'r>, verdict: Verdict, reason: &'r str) -> AnswerRow<'r>
    where
        'w: 'r,
    {
        let GradingJob { table, layout, .. } = *self.judge.job;
        let before_answer = match &layout.form {
            FileForm::Long { answer, .. } => *answer,
            FileForm::Wide(_) => usize::MAX,
        };
        let bytes = record.fault == Some(RecordFault::Bytes);
        let field = |i: usize| -> &'r [u8] {
            let text = trimmed(record.get(i).unwrap_or_default());
            let in_place = i < before_answer || (bytes && record.len() == layout.width);
            let fits = record.fault.is_none() || (bytes && clean(text));
            if fits && in_place { text } else { b"" }
        };
        let student = field(layout.student);
        let mut max_points = 0.0;
        let (mut of_problem, mut of_part) = (Cow::Borrowed(""), Cow::Borrowed(""));
        if let FileForm::Long { problem, part, .. } = layout.form {
            (of_problem, of_part) = (lossy(field(problem)), lossy(field(part)));
            let mut key = Vec::new();
            joined(field(problem), field(part), &mut key);
            if let Some(what) = table.column(&key) {
                let column = &table.columns[what as usize];
                (of_problem, of_part) = (column.number.to_string().into(), column.part.as_str().into());
                let who = table.student(student);
                max_points = who.map_or(0.0, |who| table.points(self.judge.job.index(who, what)));
            }
        }
        AnswerRow {
            line: record.line,
            student: lossy(student),
            problem: of_problem,
            part: of_part,
            answer: record.shown(layout.delimiter).into(),
            verdict,
            max_points,
            reason: reason.into(),
            submitted_at: layout.submitted.map_or("".into(), |at| lossy(field(at))),
            ..AnswerRow::default()
        }
    }
}
