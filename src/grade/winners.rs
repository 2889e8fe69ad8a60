//! Which attempt of each student at each part counts: the walks over a file of submissions that come before the writing one.
//!
//! One walk is enough where attempts are ordered by row. Where times order them, one more comes before, so that the times are
//! understood: whether `03/04` is in March or April shows only when all of the file are read. Where the best attempt counts, there is
//! one for each step of follow-through. What is held grows with students times parts, and up to a limit with rows ([`Notes`]).
use crate::answer::submissions::{Batch, RecordScratch, RecordSource};
use crate::grade::attempt::{self, Ordered, Try, Winner};
use crate::grade::cells::{AnswerCell, GradingJob, cells};
use crate::grade::credit::credit;
use crate::grade::fast_number::SiReader;
use crate::grade::layout::{RecordKind, kind_of_record};
use crate::grade::owner::Finder;
use crate::grade::run::{GradeFault, Open};
use crate::grade::threads::run_batches;
use crate::grade::verdict::Verdict;
use crate::policy::Counts;
use crate::policy::time::{Evidence, Moment};
use std::collections::BTreeMap;

/// What a walk found out about a cell, for the walk that writes: which entry it belongs to and its verdict, where both could be
/// had the quick way. 0: the cell must be looked at again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CellNote(u32);

/// The verdicts of the quick way.
pub(crate) const QUICK_VERDICTS: [Verdict; 3] = [Verdict::Right, Verdict::Wrong, Verdict::WrongDirection];

impl CellNote {
    /// To be looked at again.
    pub const NONE: CellNote = CellNote(0);

    fn new(index: usize, verdict: Verdict) -> CellNote {
        let code = QUICK_VERDICTS.iter().position(|v| *v == verdict).map_or(0, |code| code as u32 + 1);
        match u32::try_from(index) {
            Ok(index) if index < 1 << 30 && code > 0 => CellNote(index << 2 | code),
            _ => CellNote::NONE,
        }
    }
    /// The number of the entry, and that of the verdict among [`QUICK_VERDICTS`].
    #[inline]
    pub fn read(self) -> Option<(usize, usize)> {
        let verdict = (self.0 & 3).checked_sub(1)?;
        Some(((self.0 >> 2) as usize, verdict as usize))
    }
}

/// Notes of the cells of a file, batch by batch.
pub(crate) type Notes = BTreeMap<u64, Box<[CellNote]>>;

/// So many cells are noted at most: 64 MiB. Later ones are looked at again.
const MOST_NOTES: usize = 1 << 24;

/// What counts.
pub(crate) struct Chosen {
    /// A row of parts for each student.
    pub winners: Vec<Winner>,
    /// Of the cells that were walked over.
    pub notes: Notes,
}

/// What is known of the times, where they order the attempts.
struct Times {
    evidence: Evidence,
    /// Students and parts whose attempts are ordered by row.
    untimed: Vec<bool>,
}

/// What a cell is worth to the choice among attempts.
struct Worth {
    class: u8,
    number: f64,
    /// Share of the points; known only where the best attempt counts.
    share: f64,
    /// The verdict if it came the quick way.
    quickly: Option<Verdict>,
}

/// What a worker collects.
struct Collector {
    scratch: RecordScratch,
    finder: Finder,
    numbers: SiReader,
    tally: Vec<Ordered>,
    evidence: Evidence,
    noted: Vec<CellNote>,
    notes: Vec<(u64, Box<[CellNote]>)>,
    room: usize,
}

/// One walk over the file.
struct AttemptWalk<'w> {
    job: &'w GradingJob<'w>,
    /// Looks at the parts that follow from others by so many steps (0: from none); `None`: at all parts.
    level: Option<u8>,
    /// The attempts that count, as far as walks before this one found them.
    winners: &'w [Winner],
    /// `None`: nothing is known of them yet, or they do not matter.
    times: Option<&'w Times>,
    /// How many attempts are kept in order.
    depth: usize,
}

impl AttemptWalk<'_> {
    /// Worth of a cell; blank ones have none.
    #[inline]
    fn worth(&self, (who, what): (u32, u32), answer: &[u8], numbers: &mut SiReader) -> Option<Worth> {
        let rules = self.job.rules;
        let quickly = self.job.quickly(self.job.index(who, what), answer, numbers);
        let (verdict, number) = quickly.unwrap_or_else(|| {
            let judgement = self.job.judged((who, what), answer, numbers);
            (judgement.verdict, judgement.number)
        });
        let (class, share) = match verdict {
            Verdict::Blank | Verdict::UnknownPart => return None,
            Verdict::Unreadable => (attempt::UNREADABLE, 0.0),
            Verdict::Right => (attempt::READABLE, 1.0),
            _ if rules.policy.attempts.counts == Counts::Best => {
                let at = (who as usize, what as usize);
                (attempt::READABLE, credit(number, at, self.job, self.winners, None).share)
            }
            _ => (attempt::READABLE, 0.0),
        };
        Some(Worth { class, number, share, quickly: quickly.map(|(verdict, _)| verdict) })
    }

    /// Walks over a batch.
    fn batch(&self, collector: &mut Collector, batch: &Batch) {
        let Collector { scratch, finder, numbers, tally, evidence, noted, notes, room } = collector;
        let job = self.job;
        noted.clear();
        batch.records(scratch, |record| {
            if !matches!(kind_of_record(record, job.layout, job.say), RecordKind::Cells) {
                return;
            }
            let time = job.moment(record);
            if let Some(moment) = time {
                evidence.join(moment.evidence);
            }
            let open = job.layout.is_open(record);
            cells(record, job.layout, |cell| {
                noted.push(self.cell(cell, (time, open), (finder, numbers), tally));
            });
        });
        if self.level.is_none() && noted.len() <= *room {
            *room -= noted.len();
            notes.push((batch.number, noted.as_slice().into()));
        }
    }

    /// Takes a cell into the tally.
    #[inline]
    fn cell(
        &self,
        cell: &AnswerCell,
        (time, open): (Option<Moment>, bool),
        (finder, numbers): (&mut Finder, &mut SiReader),
        tally: &mut [Ordered],
    ) -> CellNote {
        let job = self.job;
        let belongs = finder.find(job.table, cell);
        let (Some(who), Some(what)) = (belongs.who, belongs.what) else { return CellNote::NONE };
        if belongs.of_another || self.level.is_some_and(|level| job.rules.levels[what as usize] != level) {
            return CellNote::NONE;
        }
        let Some(mut worth) = self.worth((who, what), cell.answer, numbers) else { return CellNote::NONE };
        if open {
            // It replaces no answer that was submitted.
            worth.class = attempt::OPEN[usize::from(worth.class == attempt::READABLE)];
        }
        let index = job.index(who, what);
        let (class, one) = self.ordered(&worth, cell.place(), time, (who, index));
        tally[index].add(class, one, self.depth);
        // An id with an apostrophe in front may be one that was guarded against spreadsheets.
        let as_on_the_roster = !belongs.respelled && cell.student.first() != Some(&b'\'');
        match worth.quickly {
            Some(verdict) if as_on_the_roster => CellNote::new(index, verdict),
            _ => CellNote::NONE,
        }
    }

    /// The attempt with what its time costs, and its class.
    fn ordered(&self, worth: &Worth, at: u64, time: Option<Moment>, (who, index): (u32, usize)) -> (u8, Try) {
        let Worth { class, number, share, .. } = *worth;
        let Some(Times { evidence, untimed }) = self.times else {
            let unread = self.job.layout.submitted.is_some() && time.is_none();
            let untimed = [unread, time.is_some_and(|t| t.uncertain)];
            let (key, late, undated, whole_day) = ((0, at), 1.0, false, false);
            return (class, Try { key, number, share, late, undated, whole_day, untimed });
        };
        let (rules, who) = (self.job.rules, who as usize);
        let read = time.filter(|m| !m.uncertain || evidence.decides());
        let time = read.map(|m| m.micros[evidence.choice()]);
        let whole_day = read.is_some_and(|m| m.whole_day);
        // A date alone is enough where every hour of the day costs the same.
        let known = time.filter(|time| !(whole_day && rules.hour_matters(who, *time)));
        let late = match known {
            Some(time) => rules.late(who, time),
            None => rules.undated(who),
        };
        let closed = late.is_none() && class == attempt::READABLE;
        let key = (if untimed[index] { 0 } else { time.unwrap_or(0) }, at);
        let (late, undated, untimed) = (late.unwrap_or(0.0), known.is_none(), [false; 2]);
        let one = Try { key, number, share, late, undated, whole_day, untimed };
        (if closed { attempt::CLOSED } else { class }, one)
    }

    /// Walks over all batches on several threads.
    fn all(
        &self,
        open: Open<'_>,
        threads: usize,
        heard: &mut (dyn FnMut(u64) + Send),
    ) -> Result<(Vec<Ordered>, Evidence, Notes), GradeFault> {
        let (source, _) = RecordSource::open(open()?)?;
        let empty = || vec![Ordered::NONE; self.winners.len()];
        let collector = || Collector {
            scratch: RecordScratch::default(),
            finder: Finder::default(),
            numbers: SiReader::default(),
            tally: empty(),
            evidence: Evidence::default(),
            noted: Vec::new(),
            notes: Vec::new(),
            room: MOST_NOTES / threads,
        };
        let workers = (0..threads).map(|_| collector()).collect();
        let process = |w: &mut Collector, b: &Batch, _: &mut Vec<u8>| self.batch(w, b);
        let (mut tally, mut evidence, mut notes) = (None, Evidence::default(), Notes::new());
        for worker in run_batches(source, workers, &process, None, heard)? {
            evidence.join(worker.evidence);
            notes.extend(worker.notes);
            match &mut tally {
                None => tally = Some(worker.tally),
                Some(all) => all.iter_mut().zip(&worker.tally).for_each(|(a, b)| a.join(b, self.depth)),
            }
        }
        let evidence = self.job.rules.policy.day_first.map_or(evidence, Evidence::said);
        Ok((tally.unwrap_or_else(empty), evidence, notes))
    }
}

/// Finds which attempts count.
pub(crate) fn choose_winners(
    open: Open<'_>,
    job: &GradingJob,
    threads: usize,
    heard: &mut (dyn FnMut(u64) + Send),
) -> Result<Chosen, GradeFault> {
    let (rules, timed) = (job.rules, job.layout.submitted.is_some());
    let attempts = rules.policy.attempts;
    let size = job.table.students.len() * job.table.columns.len();
    let mut chosen = Chosen { winners: vec![Winner::NONE; size], notes: Notes::new() };
    let mut times = None;
    if timed && rules.ordered_by_time() {
        let walk = AttemptWalk { job, level: None, winners: &chosen.winners, times: None, depth: 0 };
        let (tally, evidence, _) = walk.all(open, threads, heard)?;
        let untimed = tally.iter().map(|one| one.class > 0 && one.is_untimed(evidence)).collect();
        times = Some(Times { evidence, untimed });
    }
    let depth = attempt::depth(&attempts, timed && rules.careful() || attempts.ordered());
    // What follows from another part is worth what it is only when the winner there is known.
    let levels: Vec<Option<u8>> = match rules.walks() {
        1 => vec![None],
        n => (0..n).map(Some).collect(),
    };
    for level in levels {
        let walk = AttemptWalk { job, level, winners: &chosen.winners, times: times.as_ref(), depth };
        let (tally, _, notes) = walk.all(open, threads, heard)?;
        for (index, (winner, one)) in chosen.winners.iter_mut().zip(&tally).enumerate() {
            let untimed = times.as_ref().is_some_and(|times| times.untimed[index]);
            *winner = one.decide(&attempts, untimed).unwrap_or(*winner);
        }
        chosen.notes = notes;
    }
    Ok(chosen)
}
