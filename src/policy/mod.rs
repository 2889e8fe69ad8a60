//! How marks come about: which attempt counts, what lateness and further attempts cost, what a wrong answer may still earn, how
//! totals are made. Settings and their arithmetic; who writes them (`grading:` in a bank, a course file) is read in
//! `bank/course.rs`.
pub mod time;

use jiff::tz::{AmbiguousOffset, AmbiguousTimestamp, TimeZone};
use serde::{Deserialize, Serialize};

/// Microseconds in a minute.
pub const MINUTE: i64 = 60_000_000;
/// Microseconds in an hour.
pub const HOUR: i64 = 60 * MINUTE;
/// Microseconds in a day.
pub const DAY: i64 = 24 * HOUR;

/// All settings of a course that bear on marks.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Policy {
    /// What the course or the problem set is called; may be empty.
    pub title: String,
    /// Zone of times that name none.
    pub zone: Zone,
    /// Does the day come first in dates such as 3/4/2026? `None`: the dates of the file must say.
    pub day_first: Option<bool>,
    /// When answers are due, microseconds since 1970 (UTC).
    pub due: Option<i64>,
    /// Student id and the moment that takes the place of `due` (and of `closes`, if that is earlier).
    pub extensions: Vec<(String, i64)>,
    /// Several answers to one part.
    pub attempts: Attempts,
    /// Answers after `due`.
    pub late: Late,
    /// What an answer that is not right may earn.
    pub credit: Credit,
    /// What students are told of wrong methods.
    pub hints: Hints,
    /// Points of parts, in place of those of the bank.
    pub points: Vec<(PolicyPart, f64)>,
    /// The problems with the smallest share of their points that do not count.
    pub drop_lowest: usize,
    /// Rounding of totals.
    pub rounding: Option<Rounding>,
    /// What was found wrong with a part after it was handed in.
    pub corrections: Vec<Correction>,
}

/// A part of a problem as somebody writes it, with the place where it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PolicyPart {
    /// Number on the sheet, or id of the problem.
    pub problem: String,
    /// Id of the part; `None`: all parts of the problem.
    pub part: Option<String>,
    /// Line and column in the file, from 1.
    pub at: (usize, usize),
}

impl PolicyPart {
    /// Does it mean this part? `number` counts from 1.
    pub fn means(&self, number: usize, problem: &str, part: &str) -> bool {
        (self.problem == problem || self.problem.parse() == Ok(number))
            && self.part.as_deref().is_none_or(|p| p == part)
    }
    /// As it is written.
    pub fn text(&self) -> String {
        match &self.part {
            Some(part) => format!("{}.{part}", self.problem),
            None => self.problem.clone(),
        }
    }
}

/// A time zone.
#[derive(Debug, Clone)]
pub struct Zone {
    name: String,
    zone: TimeZone,
}

impl PartialEq for Zone {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Default for Zone {
    /// Coordinated universal time.
    fn default() -> Self {
        Zone { name: "UTC".to_owned(), zone: TimeZone::UTC }
    }
}

impl Zone {
    /// A zone by its name in the time zone database (`Europe/Berlin`), or by its offset (`+05:30`, `-3`).
    pub fn named(name: &str) -> Option<Self> {
        let name = name.trim();
        if name.eq_ignore_ascii_case("utc") || name == "Z" {
            return Some(Self::default());
        }
        let zone = if name.starts_with(['+', '-']) {
            let seconds = i32::try_from(time::offset(name)? * 60).ok()?;
            jiff::tz::Offset::from_seconds(seconds).ok()?.to_time_zone()
        } else {
            // A single word such as CET or EST means different things to different people: only places.
            Some(name).filter(|name| name.contains('/')).and_then(|name| TimeZone::get(name).ok())?
        };
        Some(Zone { name: name.to_owned(), zone })
    }
    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }
    /// The moment at which clocks of this zone show what clocks of UTC show at `shown` (microseconds since 1970). Of an hour
    /// that comes twice the first; an hour that is left out goes on from what was before.
    pub fn moment(&self, shown: i64) -> i64 {
        if self.zone == TimeZone::UTC {
            return shown;
        }
        let moment = self.ambiguous(shown).and_then(|moment| moment.compatible().ok());
        moment.map_or(shown, jiff::Timestamp::as_microsecond)
    }
    fn ambiguous(&self, shown: i64) -> Option<AmbiguousTimestamp> {
        let date = TimeZone::UTC.to_datetime(jiff::Timestamp::from_microsecond(shown).ok()?);
        Some(self.zone.to_ambiguous_timestamp(date))
    }
    /// Do clocks of this zone show this under that word (`CEST`)?
    pub fn calls(&self, shown: i64, word: &str) -> bool {
        let stamp = jiff::Timestamp::from_microsecond(self.moment(shown));
        stamp.is_ok_and(|t| self.zone.to_offset_info(t).abbreviation() == word)
    }
    /// Reads a time; one that names no zone is of this one, and so is one that names it by a word that this zone uses.
    pub fn read(&self, text: &str) -> Option<time::Moment> {
        let mut moment = time::parse(text).filter(|m| !m.clashes)?;
        match moment.word {
            None if moment.zoned => {}
            None => moment.micros = moment.micros.map(|shown| self.moment(shown)),
            Some(word) => {
                let shown = moment.micros.map(|at| at.saturating_add(word.offset.unwrap_or(0)));
                if shown.iter().all(|shown| self.calls(*shown, word.name())) {
                    moment.micros = shown.map(|shown| self.moment(shown));
                } else {
                    word.offset?;
                }
            }
        }
        Some(moment)
    }
    /// Why a time cannot be read, or tells no more than the day; `None` where there is no doubt, or no time at all.
    pub fn doubt(&self, text: &str) -> Option<time::Doubt> {
        let moment = time::parse(text)?;
        if moment.clashes {
            return Some(time::Doubt::Weekday);
        }
        match self.read(text) {
            None => moment.word.map(time::Doubt::Zone),
            Some(_) => moment.whole_day.then_some(time::Doubt::WholeDay),
        }
    }
    /// Do clocks of this zone never show this, because they are put forward over it?
    pub fn skips(&self, shown: i64) -> bool {
        self.ambiguous(shown).is_some_and(|moment| matches!(moment.offset(), AmbiguousOffset::Gap { .. }))
    }
    /// What clocks of this zone show at a moment, as microseconds since their 1970.
    pub fn clock(&self, moment: i64) -> i64 {
        let Ok(stamp) = jiff::Timestamp::from_microsecond(moment) else { return moment };
        moment.saturating_add(i64::from(self.zone.to_offset(stamp).seconds()) * 1_000_000)
    }
    /// What clocks of this zone show at a moment, to the minute: `2026-03-09 23:59`.
    pub fn shown(&self, moment: i64) -> String {
        jiff::Timestamp::from_microsecond(moment)
            .map(|t| self.zone.to_datetime(t).strftime("%Y-%m-%d %H:%M").to_string())
            .unwrap_or_default()
    }
}

worded! {
    /// Which of several attempts counts.
    #[derive(Default)]
    Counts {
        /// The last one.
        #[default]
        Last "last",
        /// The one with the most points; of equal ones the first.
        Best "best",
        /// The first one.
        First "first",
    }
}

/// Several answers to one part. An answer that cannot be read, or a blank one, is no attempt where a readable one was handed in.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Attempts {
    /// Which one counts.
    pub counts: Counts,
    /// How many are looked at, in the order of time.
    pub at_most: Option<u32>,
    /// Share of the points that each earlier attempt costs, 0 to 1.
    pub penalty: f64,
    /// Share that is left at least, 0 to 1.
    pub least: f64,
}

impl Attempts {
    /// What attempt number `n` (from 1) keeps of its points: `max(least, 1 - penalty (n - 1))`.
    pub fn factor(&self, n: u32) -> f64 {
        (1.0 - self.penalty * f64::from(n.saturating_sub(1))).max(self.least).clamp(0.0, 1.0)
    }
    /// Does the number of an attempt matter?
    pub fn ordered(&self) -> bool {
        self.at_most.is_some() || self.penalty > 0.0
    }
    /// From this attempt on the factor stays as it is.
    pub fn settles(&self) -> u32 {
        (1..=100).find(|n| self.factor(*n) <= self.least || self.penalty <= 0.0).unwrap_or(100)
    }
}

worded! {
    /// For which time the late penalty is.
    Per {
        /// For each day that has begun.
        Day "day",
        /// For each hour that has begun.
        Hour "hour",
        /// Once.
        Once "once",
    }
}

/// Answers after the due date.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Late {
    /// Share of the points, 0 to 1.
    pub penalty: f64,
    /// For each begun hour or day.
    pub per: Per,
    /// Greatest share that lateness costs, 0 to 1.
    pub most: f64,
    /// So late is not late, microseconds. (A due date without seconds includes its minute.)
    pub grace: i64,
    /// From then on nothing counts, microseconds since 1970 (UTC).
    pub closes: Option<i64>,
    /// What holds where the time of an answer cannot be read; `None`: nobody has said, and it has to be said where it matters.
    pub unread: Option<Unread>,
}

worded! {
    /// An answer of which nobody knows when it was handed in.
    Unread {
        /// It is taken as in time.
        InTime "in time",
        /// It costs what lateness costs at most; after a closing date nothing counts, so neither does it.
        Late "late",
    }
}

impl Default for Late {
    fn default() -> Self {
        Late { penalty: 0.0, per: Per::Day, most: 1.0, grace: 0, closes: None, unread: None }
    }
}

impl Late {
    /// What an answer that comes `by` microseconds after it was due keeps of its points; lateness is counted from the due date,
    /// not from the end of the grace.
    pub fn factor(&self, by: i64) -> f64 {
        if by <= self.grace {
            return 1.0;
        }
        let begun = match self.per {
            Per::Once => 1,
            Per::Hour => by.saturating_add(HOUR - 1) / HOUR,
            Per::Day => by.saturating_add(DAY - 1) / DAY,
        };
        (1.0 - (self.penalty * begun as f64).min(self.most)).clamp(0.0, 1.0)
    }
}

/// What an answer that is not right may earn, as shares of the points of its part.
#[derive(Debug, Clone, PartialEq)]
pub struct Credit {
    /// For a known wrong method.
    pub methods: f64,
    /// For single ones, by id.
    pub by_method: Vec<(String, f64)>,
    /// For what follows correctly from a wrong earlier answer.
    pub follow: f64,
}

impl Default for Credit {
    fn default() -> Self {
        Credit { methods: 0.0, by_method: Vec::new(), follow: 0.5 }
    }
}

impl Credit {
    /// For this method.
    pub fn of(&self, id: &str) -> f64 {
        self.by_method.iter().find(|(m, _)| m == id).map_or(self.methods, |(_, share)| *share)
    }
}

worded! {
    /// What students are told of wrong methods.
    #[derive(Default, Serialize, Deserialize)]
    Hints {
        /// Nothing.
        None "none",
        /// A hint that does not give the answer away.
        #[default]
        Nudge "nudge",
        /// What was done, how to see that it is wrong, and the hint.
        Explain "explain",
    }
}

worded! {
    /// Which way a total is rounded.
    RoundingWay {
        /// To the nearest; from the middle upwards.
        Nearest "nearest",
        /// In favour of the student.
        Up "up",
        /// Downwards.
        Down "down",
    }
}

/// Rounding of totals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounding {
    /// To whole multiples of this, > 0.
    pub to: f64,
    /// Which way.
    pub way: RoundingWay,
}

impl Rounding {
    /// The rounded total. Sums of decimals are a few roundings off: what lies that near to a multiple, or to the middle between
    /// two, is taken for it.
    pub fn round(&self, total: f64) -> f64 {
        const NEAR: f64 = 1e-9;
        let steps = total / self.to;
        let whole = match self.way {
            RoundingWay::Nearest => (steps + 0.5 + NEAR).floor(),
            RoundingWay::Up => (steps - NEAR).ceil(),
            RoundingWay::Down => (steps + NEAR).floor(),
        };
        plain(whole * self.to)
    }
}

/// Without the dust that sums of decimals leave: twelve significant figures.
pub fn plain(points: f64) -> f64 {
    format!("{points:.11e}").parse().unwrap_or(points)
}

worded! {
    /// Whom a correction is for.
    For {
        /// Every student of the set.
        All "all",
        /// Those who handed in something for the part.
        Answered "answered",
    }
}

/// A part that turned out to be faulty: all get so much at least.
#[derive(Debug, Clone, PartialEq)]
pub struct Correction {
    /// The part, or all parts of a problem.
    pub part: PolicyPart,
    /// Share of its points that everybody gets at least, 0 to 1.
    pub share: f64,
    /// Whom it is for.
    pub to: For,
    /// Why, for the reports.
    pub why: String,
}

impl Correction {
    /// Who gets how much for the part, called so, and why.
    pub fn in_words(&self, part: &str) -> String {
        let who = if self.to == For::All { "everybody" } else { "everybody who answered" };
        let points = match self.share >= 1.0 {
            true => "full points".to_owned(),
            false => format!("at least {} % of the points", plain(100.0 * self.share)),
        };
        format!("correction: {who} gets {points} for {part}: {}", self.why)
    }
}

/// A student's sum.
#[derive(Debug, Clone, PartialEq)]
pub struct Total {
    /// Points, rounded.
    pub points: f64,
    /// Of so many.
    pub of: f64,
    /// Indices of the problems that do not count.
    pub dropped: Vec<usize>,
}

impl Policy {
    /// When answers of a student are due.
    pub fn due_for(&self, student: &str) -> Option<i64> {
        let extended = self.extensions.iter().find(|(id, _)| id == student).map(|(_, at)| *at);
        extended.or(self.due)
    }
    /// From when on nothing counts for a student: an extension moves it by as much as the due date.
    pub fn closes_for(&self, student: &str) -> Option<i64> {
        let extended = self.extensions.iter().find(|(id, _)| id == student).map(|(_, at)| *at);
        self.late.closes.map(|at| match (extended, self.due) {
            (Some(extended), Some(due)) => at.saturating_add(extended.saturating_sub(due).max(0)),
            (Some(extended), None) => at.max(extended),
            _ => at,
        })
    }
    /// What an answer that is handed in at `moment` and was due at `due` keeps of its points. Days are those of the zone's
    /// clocks: the same time of the next day is a day later, whether the night had 23 hours or 25.
    fn late_factor(&self, due: i64, moment: i64) -> f64 {
        if moment <= due {
            return 1.0;
        }
        let by = match self.late.per {
            Per::Day => self.zone.clock(moment).saturating_sub(self.zone.clock(due)),
            Per::Hour | Per::Once => moment.saturating_sub(due),
        };
        self.late.factor(by.max(1))
    }
    /// What is left of an answer that came at `moment` and was due at `due`; `None` once nothing counts. `i64::MAX`: never.
    pub fn left(&self, (due, closes): (i64, i64), moment: i64) -> Option<f64> {
        if moment > closes {
            return None;
        }
        Some(if due == i64::MAX { 1.0 } else { self.late_factor(due, moment) })
    }
    /// Of an answer that came on the day that begins at `midnight`: does the time of day matter?
    pub fn hour_matters(&self, limits: (i64, i64), midnight: i64) -> bool {
        let last = self.zone.moment(self.zone.clock(midnight).saturating_add(DAY - 1));
        let left = |moment| self.left(limits, moment).map(f64::to_bits);
        left(midnight) != left(last)
    }
    /// Does it matter when an answer was handed in, besides the order?
    pub fn timed(&self) -> bool {
        self.late.closes.is_some()
            || self.late.penalty > 0.0 && (self.due.is_some() || !self.extensions.is_empty())
    }
    /// Points that the course gives a part.
    pub fn points_given(&self, number: usize, problem: &str, part: &str) -> Option<f64> {
        let mut given =
            self.points.iter().filter(|(p, _)| p.part.is_some() && p.means(number, problem, part));
        given.next().map(|(_, points)| *points)
    }
    /// The correction of a part that gives most to a student who answered it, or did not.
    pub fn correction(
        &self,
        number: usize,
        problem: &str,
        part: &str,
        answered: bool,
    ) -> Option<&Correction> {
        let meant = |c: &&Correction| c.part.means(number, problem, part) && (answered || c.to == For::All);
        let meant = self.corrections.iter().filter(meant);
        // Of equal ones the first.
        meant.rev().max_by(|a, b| a.share.total_cmp(&b.share))
    }
    /// A student's total from (earned, possible) of each problem. The problems with the smallest share of their points are
    /// dropped, of equal ones the later; never the last one that is left. A problem without points has nothing to drop.
    pub fn total(&self, problems: &[(f64, f64)]) -> Total {
        let mut order: Vec<usize> = (0..problems.len()).filter(|i| problems[*i].1 > 0.0).collect();
        let share = |i: usize| problems[i].0 / problems[i].1;
        order.sort_by(|a, b| share(*a).total_cmp(&share(*b)).then(b.cmp(a)));
        order.truncate(self.drop_lowest.min(order.len().saturating_sub(1)));
        order.sort_unstable();
        let (mut points, mut of) = (0.0, 0.0);
        for (i, (earned, possible)) in problems.iter().enumerate() {
            if !order.contains(&i) {
                points += earned;
                of += possible;
            }
        }
        let of = plain(of);
        // Rounding up must not give more than there is.
        let points = self.rounding.map_or_else(|| plain(points), |r| r.round(points).min(of));
        Total { points, of, dropped: order }
    }
}

#[cfg(test)]
#[allow(
    clippy::float_cmp,
    reason = "shares and points of the tests are exact, or rounded to what is compared"
)]
mod tests {
    use super::*;

    #[test]
    fn further_attempts_cost_down_to_the_least() {
        let attempts = Attempts { penalty: 0.25, least: 0.4, ..Attempts::default() };
        let factors: Vec<f64> = (1..=5).map(|n| attempts.factor(n)).collect();
        assert_eq!(factors, [1.0, 0.75, 0.5, 0.4, 0.4]);
        assert_eq!(attempts.settles(), 4);
        assert_eq!(Attempts::default().settles(), 1);
        assert_eq!(Attempts { penalty: 1e-9, ..attempts }.settles(), 100);
    }

    #[test]
    fn lateness_is_counted_in_begun_days() {
        let late = Late { penalty: 0.1, most: 0.5, grace: 10 * MINUTE, ..Late::default() };
        for (by, left) in [
            (-DAY, 1.0),
            (0, 1.0),
            (10 * MINUTE, 1.0),
            (10 * MINUTE + 1, 0.9),
            (DAY, 0.9),
            (DAY + 1, 0.8),
            (9 * DAY, 0.5),
        ] {
            assert_eq!(late.factor(by), left, "{by}");
        }
        assert_eq!(late.factor(i64::MAX), 0.5);
        assert_eq!(Late { per: Per::Once, ..late }.factor(9 * DAY), 0.9);
        assert_eq!(Late { per: Per::Hour, ..late }.factor(HOUR + 1), 0.8);
    }

    #[test]
    fn clocks_change_in_spring_and_autumn() {
        let berlin = Zone::named("Europe/Berlin").unwrap();
        let at = |day: i64, hour: i64, minute: i64| berlin.moment(day * DAY + hour * HOUR + minute * MINUTE);
        // 2026-03-29 is day 20541; clocks go from 2 to 3.
        assert_eq!(at(20_541, 1, 30), 20_541 * DAY + 30 * MINUTE);
        assert_eq!(at(20_541, 3, 30), 20_541 * DAY + HOUR + 30 * MINUTE);
        // An hour that does not exist goes on from before.
        assert_eq!(at(20_541, 2, 30), 20_541 * DAY + HOUR + 30 * MINUTE);
        // 2026-10-25 is day 20751; the hour from 2 to 3 comes twice: the first.
        assert_eq!(at(20_751, 2, 30), 20_751 * DAY + 30 * MINUTE);
        assert_eq!(berlin.shown(20_541 * DAY + HOUR), "2026-03-29 03:00");
        assert_eq!(Zone::named("+05:30").unwrap().moment(0), -(5 * HOUR + 30 * MINUTE));
        assert_eq!(Zone::named("-3").unwrap().moment(0), 3 * HOUR);
        for odd in ["CET", "Europe/Bremen ", "+99", "+1:99", "", "+", "Mars/Olympus"] {
            assert_eq!(Zone::named(odd), None, "{odd}");
        }
    }

    #[test]
    fn totals_drop_and_round() {
        let problems = [(1.0, 4.0), (3.0, 4.0), (0.5, 2.0), (0.0, 0.0)];
        let mut policy = Policy::default();
        assert_eq!(policy.total(&problems), Total { points: 4.5, of: 10.0, dropped: vec![] });
        policy.drop_lowest = 1;
        assert_eq!(policy.total(&problems), Total { points: 4.0, of: 8.0, dropped: vec![2] });
        policy.drop_lowest = 9;
        assert_eq!(policy.total(&problems), Total { points: 3.0, of: 4.0, dropped: vec![0, 2] });
        let round = |to, way| Rounding { to, way };
        assert_eq!(round(0.5, RoundingWay::Nearest).round(0.1 + 0.2 + 0.45), 1.0);
        assert_eq!(round(0.5, RoundingWay::Nearest).round(0.74), 0.5);
        assert_eq!(round(0.1, RoundingWay::Up).round(0.1 + 0.2), 0.3);
        assert_eq!(round(1.0, RoundingWay::Down).round(0.7 + 0.2 + 0.1), 1.0);
    }
}
