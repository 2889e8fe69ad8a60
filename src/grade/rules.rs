//! The settings of a course, resolved against the students and parts of a set.
use crate::finding::{Finding, Findings};
use crate::grade::table::{Column, KeyTable};
use crate::policy::{Counts, Policy, PolicyPart, Unread};

/// Settings, ready for many rows.
#[derive(Debug, Clone)]
pub struct Rules<'p> {
    /// As they were written.
    pub policy: &'p Policy,
    /// For each student, microseconds (UTC); `i64::MAX` where nothing is due.
    due: Vec<i64>,
    closes: Vec<i64>,
    /// For each column the share that each wrong method earns; empty where none earns anything.
    methods: Vec<Vec<f64>>,
    /// For each column what everybody gets at least, and why: who did not answer, who did.
    corrections: Vec<[Option<(f64, String)>; 2]>,
    /// How many relations lead to each column; 0 where it follows from nothing.
    pub(crate) levels: Vec<u8>,
}

impl<'p> Rules<'p> {
    /// Resolves settings; the points of the table are those of the course already ([`KeyTable::take_points`]).
    /// Errors: parts, methods or students that the set does not have.
    pub fn new(table: &KeyTable, policy: &'p Policy) -> Result<Self, Findings> {
        let mut faults = Findings::default();
        let named = |part: &PolicyPart, field: &str, faults: &mut Findings| {
            let known = table.columns.iter().any(|c| part.means(c.number, &c.problem, &c.part));
            if !known {
                let all: Vec<String> = table.columns.iter().take(30).map(Column::label).collect();
                let fault = Finding::new(field, format!("the set has no part `{}`", part.text()));
                let (fault, hint) =
                    (fault.at(part.at.0, part.at.1), format!("its parts: {}", all.join(", ")));
                // The list is printed once.
                let said = faults.iter().any(|f| f.hint.as_ref() == Some(&hint));
                faults.push(if said { fault } else { fault.hint(hint) });
            }
        };
        for (part, _) in &policy.points {
            named(part, "points", &mut faults);
        }
        for correction in &policy.corrections {
            named(&correction.part, "corrections", &mut faults);
        }
        for (id, _) in &policy.credit.by_method {
            if !(0..table.columns.len()).any(|c| table.methods(c).contains(id)) {
                let fault =
                    Finding::new("credit", format!("no problem of the set knows a wrong method `{id}`"));
                faults.push(fault.hint("ids stand in the column `methods` of answers.csv, and in `lint`"));
            }
        }
        for (id, _) in &policy.extensions {
            if table.student(id.as_bytes()).is_none() {
                let fault = Finding::new("extensions", format!("the set has no student `{id}`"));
                faults
                    .push(fault.hint("write the id as on the roster, in quotes where it begins with a zero"));
            }
        }
        let problems = table.columns.last().map_or(0, |c| c.number);
        if policy.drop_lowest > 0 && policy.drop_lowest >= problems {
            let what = format!(
                "is {}, and the set has {problems} problem{}",
                policy.drop_lowest,
                if problems == 1 { "" } else { "s" }
            );
            faults.push(Finding::new("drop lowest", what).hint("at least one problem must count"));
        }
        faults.into_result(())?;
        let methods = (0..table.columns.len()).map(|column| {
            let shares: Vec<f64> = table.methods(column).iter().map(|id| policy.credit.of(id)).collect();
            if shares.iter().any(|s| *s > 0.0) { shares } else { Vec::new() }
        });
        let methods = methods.collect();
        let corrections = table.columns.iter().map(|c| {
            [false, true].map(|answered| {
                let found = policy.correction(c.number, &c.problem, &c.part, answered)?;
                Some((found.share, found.why.clone()))
            })
        });
        let corrections = corrections.collect();
        let mut levels = vec![0u8; table.columns.len()];
        if policy.credit.follow > 0.0 {
            // Parts follow from earlier ones only, so one walk is enough.
            for column in 0..levels.len() {
                if let Some((follow, first)) = table.follow(column) {
                    let below = follow.from.iter().filter_map(|p| levels.get(first + p)).max().copied();
                    levels[column] = below.unwrap_or(0).saturating_add(1);
                }
            }
        }
        let students = table.students.iter();
        let due = students.clone().map(|s| policy.due_for(&s.id).unwrap_or(i64::MAX)).collect();
        let closes = students.map(|s| policy.closes_for(&s.id).unwrap_or(i64::MAX)).collect();
        Ok(Rules { policy, due, closes, methods, corrections, levels })
    }
    /// Do lateness or the number of an attempt bear on marks?
    pub(crate) fn careful(&self) -> bool {
        self.policy.attempts.ordered() || self.policy.timed()
    }
    /// Does it matter which attempt came first? Of the best ones only by what they cost.
    pub(crate) fn ordered_by_time(&self) -> bool {
        self.careful() || self.policy.attempts.counts != Counts::Best
    }
    /// Walks that are needed to find which attempts count.
    pub(crate) fn walks(&self) -> u8 {
        let deepest = self.levels.iter().max().copied().unwrap_or(0);
        if self.policy.attempts.counts == Counts::Best { deepest + 1 } else { 1 }
    }
    /// How often the submissions are read.
    pub fn reads(&self) -> u64 {
        1 + u64::from(self.ordered_by_time()) + u64::from(self.walks())
    }
    /// Can an answer to this part that is not right earn something?
    pub(crate) fn may_earn(&self, column: usize) -> bool {
        self.levels[column] > 0 || !self.methods[column].is_empty()
    }
    /// The share that a wrong method earns.
    pub(crate) fn method(&self, column: usize, method: u16) -> f64 {
        self.methods[column].get(usize::from(method)).copied().unwrap_or(0.0)
    }
    /// Does any wrong method earn something here?
    pub(crate) fn methods_earn(&self, column: usize) -> bool {
        !self.methods[column].is_empty()
    }
    /// What lateness leaves of the points of an answer handed in at `moment`; `None` after the closing date.
    pub(crate) fn late(&self, student: usize, moment: i64) -> Option<f64> {
        self.policy.left((self.due[student], self.closes[student]), moment)
    }
    /// Of an answer that came on the day that begins at `midnight`: does the time of day matter?
    pub(crate) fn hour_matters(&self, student: usize, midnight: i64) -> bool {
        self.policy.hour_matters((self.due[student], self.closes[student]), midnight)
    }
    /// Does it matter when this student handed in?
    pub(crate) fn matters(&self, student: usize) -> bool {
        self.policy.timed() && (self.due[student] != i64::MAX || self.closes[student] != i64::MAX)
    }
    /// What is left of the points of an answer of which nobody knows when it was handed in; `None`: nothing counts.
    pub(crate) fn undated(&self, student: usize) -> Option<f64> {
        let late = &self.policy.late;
        match late.unread {
            Some(Unread::Late) if self.closes[student] != i64::MAX => None,
            Some(Unread::Late) if self.matters(student) => Some((1.0 - late.most).clamp(0.0, 1.0)),
            _ => Some(1.0),
        }
    }
    /// What who answered a part, or did not, gets at least, and why.
    pub(crate) fn correction(&self, column: usize, answered: bool) -> Option<(f64, &str)> {
        self.corrections[column][usize::from(answered)].as_ref().map(|(share, why)| (*share, why.as_str()))
    }
}
