//! Which of several attempts at a part counts, found in one walk over rows in any order, on several threads.
use crate::policy::time::Evidence;
use crate::policy::{Attempts, Counts};

/// The place of a cell is one number, so that places compare as they follow one another in the file: its line, and in the last
/// bits its column in a wide file.
const COLUMN_BITS: u32 = 13;

/// The place of a cell.
pub(crate) fn place(line: u64, column: usize) -> u64 {
    (line << COLUMN_BITS) | column.min((1 << COLUMN_BITS) - 1) as u64
}

pub(crate) fn line_of(place: u64) -> u64 {
    place >> COLUMN_BITS
}

/// Classes of a cell of an attempt that was never submitted, of one that cannot be read and of others. Of the cells of a student at a part only those of the highest class count.
pub(crate) const OPEN: [u8; 2] = [1, 2];
/// Class of a cell that cannot be read.
pub(crate) const UNREADABLE: u8 = 3;
/// Class of one that can be read, but was handed in after the closing date.
pub(crate) const CLOSED: u8 = 4;
/// Class of one that can be read.
pub(crate) const READABLE: u8 = 5;

/// The attempt that counts.
#[derive(Debug, Clone, Copy)]
pub struct Winner {
    /// Its place; none is handed in where nothing stands there.
    pub(crate) at: u64,
    /// Taken by row from several, because a time cannot be read.
    pub(crate) by_row: bool,
    /// The number that was handed in, SI; NaN where there is none.
    pub(crate) number: f64,
    /// What its being a further attempt leaves of its points.
    pub(crate) attempt: f64,
    /// What its lateness leaves of them; 0 after the closing date.
    pub(crate) late: f64,
    /// After the closing date.
    pub(crate) closed: bool,
    /// When it was handed in is not known.
    pub(crate) undated: bool,
    /// Only the day is known, which is enough.
    pub(crate) whole_day: bool,
}

impl Winner {
    /// Nothing was handed in.
    pub(crate) const NONE: Winner = Winner {
        at: u64::MAX,
        by_row: false,
        number: f64::NAN,
        attempt: 1.0,
        late: 1.0,
        closed: false,
        undated: false,
        whole_day: false,
    };
}

/// One attempt.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Try {
    /// Time and place, or 0 and place where a time of the cell cannot be read.
    pub key: (i64, u64),
    /// The number handed in.
    pub number: f64,
    /// Share of the points before attempts and lateness cost.
    pub share: f64,
    /// What lateness leaves.
    pub late: f64,
    /// When it was handed in is not known.
    pub undated: bool,
    /// Only the day is known, which is enough.
    pub whole_day: bool,
    /// Its time cannot be read; its day and month are uncertain (`03/04`).
    pub untimed: [bool; 2],
}

/// The attempts of a student at a part in the order of time, as far as they can matter: the first and the last one; with a limit the
/// first so many; for the best one as many as differ in what they cost, and the best of the rest.
#[derive(Debug, Clone)]
pub(crate) struct Ordered {
    /// 0: none or blank.
    pub class: u8,
    /// As of one attempt, of any of them.
    untimed: [bool; 2],
    count: u32,
    kept: Vec<Try>,
    last: Try,
    rest: Option<Try>,
}

/// Least and most attempts that are kept in order. A number handed in again is no further attempt (whole sheets are handed in
/// anew to mend one answer), so more are kept than count.
const KEPT: (usize, usize) = (32, 100);
/// How often the same may be handed in again on average before what is kept no longer tells the number of an attempt.
const REPEATED: usize = 8;

/// How many attempts are kept in order; none but the first where neither lateness nor the number of an attempt bears on marks.
pub(crate) fn depth(attempts: &Attempts, careful: bool) -> usize {
    match attempts.counts {
        Counts::First => 1,
        _ if !careful => 0,
        _ if attempts.ordered() => {
            let most = attempts.at_most.unwrap_or(attempts.settles()) as usize;
            most.saturating_mul(REPEATED).clamp(KEPT.0, KEPT.1)
        }
        _ => KEPT.0,
    }
}

impl Ordered {
    /// Nothing.
    pub const NONE: Ordered = Ordered {
        class: 0,
        untimed: [false; 2],
        count: 0,
        kept: Vec::new(),
        last: Try {
            key: (0, 0),
            number: f64::NAN,
            share: 0.0,
            late: 1.0,
            undated: false,
            whole_day: false,
            untimed: [false; 2],
        },
        rest: None,
    };
    /// Adds an attempt.
    pub fn add(&mut self, class: u8, one: Try, depth: usize) {
        if class < self.class {
            return;
        }
        if class > self.class {
            *self = Ordered { class, ..Ordered::NONE };
        }
        if self.count == 0 || one.key > self.last.key {
            self.last = one;
        }
        self.count += 1;
        self.note(one.untimed);
        self.keep(one, depth);
    }
    fn note(&mut self, untimed: [bool; 2]) {
        self.untimed.iter_mut().zip(untimed).for_each(|(mine, other)| *mine |= other);
    }
    /// Are the times of this cell of no use?
    pub fn is_untimed(&self, evidence: Evidence) -> bool {
        let [unread, uncertain] = self.untimed;
        unread || (uncertain && !evidence.decides())
    }
    fn keep(&mut self, one: Try, depth: usize) {
        let at = self.kept.partition_point(|k| k.key < one.key);
        if at >= depth {
            self.put_aside(one);
            return;
        }
        self.kept.insert(at, one);
        if self.kept.len() > depth
            && let Some(out) = self.kept.pop()
        {
            self.put_aside(out);
        }
    }
    /// Of those beyond the depth only the best matters: all cost the same. Of equal ones the first; of those that earn nothing the
    /// last, which is what the student went on with.
    fn put_aside(&mut self, one: Try) {
        let worth = |t: &Try| t.share * t.late;
        let first = worth(&one) > 0.0;
        let better = |old: &Try| {
            worth(&one) > worth(old) || (worth(&one) >= worth(old) && (one.key < old.key) == first)
        };
        if self.rest.as_ref().is_none_or(better) {
            self.rest = Some(one);
        }
    }
    /// Adds what another thread saw.
    pub fn join(&mut self, other: &Ordered, depth: usize) {
        if other.class == 0 || other.class < self.class {
            return;
        }
        if other.class > self.class {
            self.clone_from(other);
            return;
        }
        if other.last.key > self.last.key {
            self.last = other.last;
        }
        self.count += other.count;
        self.note(other.untimed);
        for one in &other.kept {
            self.keep(*one, depth);
        }
        if let Some(rest) = other.rest {
            self.put_aside(rest);
        }
    }
    /// Which one counts, and what it keeps of its points.
    pub fn decide(&self, attempts: &Attempts, untimed: bool) -> Option<Winner> {
        if self.class == 0 {
            return None;
        }
        let by_row = untimed && self.count > 1;
        let winner = |one: &Try, nth: usize| Winner {
            at: one.key.1,
            by_row,
            number: one.number,
            attempt: attempts.factor(u32::try_from(nth).unwrap_or(u32::MAX)),
            late: one.late,
            closed: self.class == CLOSED,
            undated: one.undated,
            whole_day: one.whole_day,
        };
        // The first of each run of equal numbers.
        let same = |a: &Try, b: &Try| a.number.to_bits() == b.number.to_bits() && a.number.is_finite();
        let mut tries: Vec<&Try> = Vec::with_capacity(self.kept.len());
        for (i, one) in self.kept.iter().enumerate() {
            if i == 0 || !same(&self.kept[i - 1], one) {
                tries.push(one);
            }
        }
        let all_kept = self.kept.len() == self.count as usize;
        if let Some(most) = attempts.at_most {
            tries.truncate(most as usize);
        }
        let full = attempts.at_most.is_some_and(|most| tries.len() == most as usize);
        Some(match attempts.counts {
            Counts::First => tries.first().map_or(winner(&self.last, 1), |one| winner(one, 1)),
            Counts::Last => match tries.last() {
                Some(one) if all_kept || full || same(one, &self.last) => winner(one, tries.len()),
                _ => winner(&self.last, self.count as usize),
            },
            Counts::Best => {
                let mut best: Option<(f64, f64, Winner)> = None;
                let rest = self.rest.as_ref().filter(|_| attempts.at_most.is_none());
                for (i, one) in tries.into_iter().chain(rest).enumerate() {
                    let worth =
                        one.share * one.late * attempts.factor(u32::try_from(i + 1).unwrap_or(u32::MAX));
                    // Of equal worth what is right in itself, then the first; of those that earn nothing the last.
                    let better = |(most, share, _): &(f64, f64, Winner)| {
                        worth > *most
                            || (worth >= *most && (one.share > *share || (one.share <= 0.0 && *share <= 0.0)))
                    };
                    if best.as_ref().is_none_or(better) {
                        best = Some((worth, one.share, winner(one, i + 1)));
                    }
                }
                best.map_or(winner(&self.last, self.count as usize), |(_, _, w)| w)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn one(time: i64, share: f64) -> Try {
        let key = (time, time.unsigned_abs());
        let untimed = [false; 2];
        Try { key, number: share, share, late: 1.0, undated: false, whole_day: false, untimed }
    }

    /// What the settings mean, said by sorting all attempts.
    fn plainly(attempts: &Attempts, tries: &[Try]) -> u64 {
        let mut sorted = tries.to_vec();
        sorted.sort_by_key(|t| t.key);
        sorted.dedup_by(|b, a| a.number.to_bits() == b.number.to_bits());
        sorted.truncate(attempts.at_most.unwrap_or(u32::MAX) as usize);
        let worth = |i: usize| sorted[i].share * sorted[i].late * attempts.factor(i as u32 + 1);
        let i = match attempts.counts {
            Counts::First => 0,
            Counts::Last => sorted.len() - 1,
            Counts::Best => {
                let most = (0..sorted.len()).map(worth).fold(0.0, f64::max);
                let share = |i: &usize| (sorted[*i].share * 1e6) as i64;
                let equal = (0..sorted.len()).filter(|i| worth(*i) >= most);
                let most_share = equal.clone().map(|i| share(&i)).max().unwrap_or(0);
                let mut equal = equal.filter(|i| share(i) == most_share);
                let chosen = if most_share > 0 { equal.next() } else { equal.next_back() };
                chosen.unwrap_or(0)
            }
        };
        sorted[i].key.1
    }

    /// Of more attempts than are kept in order one in the middle counted once, though it is the last that the student went on with.
    #[test]
    fn of_many_attempts_that_earn_nothing_the_last_counts() {
        let attempts = Attempts { counts: Counts::Best, ..Attempts::default() };
        for careful in [false, true] {
            let mut all = Ordered::NONE;
            for time in (1..=60).rev() {
                all.add(READABLE, Try { number: time as f64, ..one(time, 0.0) }, depth(&attempts, careful));
            }
            assert_eq!(all.decide(&attempts, false).map(|w| w.at), Some(60));
        }
    }

    proptest! {
        #[test]
        fn any_order_on_any_threads_gives_what_sorting_gives(
            shares in proptest::collection::vec(0u8..5, 1..30),
            shuffle in proptest::collection::vec(any::<u32>(), 30),
            at_most in proptest::option::of(1u32..6),
            penalty in 0u8..4, least in 0u8..4, counts in 0u8..3, split in 0usize..30,
        ) {
            let counts = [Counts::First, Counts::Last, Counts::Best][usize::from(counts)];
            let attempts = Attempts {
                counts, at_most, penalty: f64::from(penalty) / 8.0, least: f64::from(least) / 4.0,
            };
            let mut tries: Vec<Try> =
                (1i64..).zip(&shares).map(|(t, s)| one(t, f64::from(*s) / 4.0)).collect();
            let want = plainly(&attempts, &tries);
            tries.sort_by_key(|t| shuffle[usize::try_from(t.key.0).unwrap() % 30]);
            let deep = depth(&attempts, true);
            let (mut a, mut b) = (Ordered::NONE, Ordered::NONE);
            for (i, t) in tries.iter().enumerate() {
                let to = if i < split { &mut a } else { &mut b };
                to.add(READABLE, *t, deep);
            }
            a.join(&b, deep);
            let winner = a.decide(&attempts, false);
            // Equal worth may be reached by another attempt only where rounding of factors says so.
            prop_assert_eq!(winner.map(|w| w.at), Some(want));
        }
    }
}
