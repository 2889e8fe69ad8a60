//! What a regrading changes, in words: rules, parts, students; and changes.csv.
use crate::grade::table::{Column, KeyTable};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, KeyEntry};
use crate::num::shown;
use crate::policy::{Correction, Policy};
use crate::regrade::changes::{self, ChangeRow, DUST, Grading, MarkChange, Why};
use crate::report::tolerances;
use crate::sheet::terminal;
use crate::words::plain::beginning;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// Students shown one by one; the others stand in changes.csv.
const SHOWN: usize = 20;

/// The keys before and after, by the students and parts of the new one.
pub struct KeysBeforeAfter {
    old: KeyTable,
    /// Its students and parts are those that are compared.
    pub new: KeyTable,
    /// Where students and parts of the new key are in the old one.
    students: Vec<Option<usize>>,
    parts: Vec<Option<usize>>,
}

impl KeysBeforeAfter {
    /// Finds the students and parts of the new key in the old one.
    pub fn new(old: KeyTable, new: KeyTable) -> Self {
        let part = |p: &Column| old.columns.iter().position(|c| (c.number, &c.part) == (p.number, &p.part));
        let students =
            new.students.iter().map(|s| old.student(s.id.as_bytes()).map(|s| s as usize)).collect();
        let parts = new.columns.iter().map(part).collect();
        Self { old, new, students, parts }
    }
    /// The entries of a student and a part, before and after.
    pub fn entries(&self, student: usize, part: usize) -> [Option<&KeyEntry>; 2] {
        let old = self.students[student].zip(self.parts[part]).and_then(|(s, p)| self.old.entry(s, p));
        [old, self.new.entry(student, part)]
    }
}

/// A regrading, to be told.
pub struct ChangesTold<'d> {
    /// Id and name of each student.
    pub students: &'d [(String, String)],
    /// The old grading.
    pub before: &'d Grading,
    /// The new one.
    pub after: &'d Grading,
    pub changes: &'d [MarkChange],
    pub keys: &'d KeysBeforeAfter,
}

impl ChangesTold<'_> {
    /// `1.omega`
    fn label(&self, part: usize) -> String {
        self.keys.new.columns[part].label()
    }

    /// What is graded otherwise than before: banks, by their hashes and the file of the new one, and settings.
    pub fn rules(
        &self,
        text: &mut String,
        (old, new, file): (&str, &str, &str),
        (then, now): (&Policy, &Policy),
        course: Option<&Path>,
    ) {
        let [was, is] = [old, new].map(|hash| beginning(hash, 12));
        let bank = match old == new {
            true => format!("as before ({is})"),
            false => format!("{file} ({is}, was {was}); the key is solved anew for the data on the sheets"),
        };
        let _ = writeln!(text, "  bank: {bank}");
        let parts = (0..self.keys.new.columns.len()).flat_map(|p| self.part(p));
        let mut said: Vec<String> = parts.chain(settings(then, now)).collect();
        if said.is_empty() && old != new {
            said.push("no key, tolerance or setting differs: only words do".to_owned());
        }
        if let Some(course) = course.filter(|_| then != now) {
            let _ = writeln!(text, "  course: {}", course.display());
        }
        for line in said {
            let _ = writeln!(text, "  {line}");
        }
    }

    /// How the key of a part differs.
    fn part(&self, part: usize) -> Vec<String> {
        let mut counts: BTreeMap<Why, usize> = BTreeMap::new();
        let mut farthest = 0.0f64;
        let mut points: Option<(f64, f64)> = None;
        for student in 0..self.keys.new.students.len() {
            let keys = self.keys.entries(student, part);
            let [Some(old), Some(new)] = keys else { continue };
            for why in changes::of_key(keys) {
                *counts.entry(why).or_default() += 1;
            }
            if let (Answer::Number { value: a, .. }, Answer::Number { value: b, .. }) =
                (&old.answer, &new.answer)
            {
                let size = a.abs().max(b.abs());
                if size > 0.0 {
                    farthest = farthest.max((a - b).abs() / size);
                }
            }
            if (old.points - new.points).abs() > DUST {
                points = Some((old.points, new.points));
            }
        }
        let label = self.label(part);
        let mut said = Vec::new();
        for (why, count) in counts {
            said.push(match why {
                Why::Key => format!(
                    "{label}: the key differs for {count} of {}, by up to {} %",
                    terminal::count(self.keys.new.students.len(), "student"),
                    shown::per_cent(farthest, 3)
                ),
                Why::Tolerance => {
                    let old = self.keys.parts[part].map(|p| tolerances::tolerance(&self.keys.old, p));
                    let (new, old) = (tolerances::tolerance(&self.keys.new, part), old.unwrap_or_default());
                    format!("{label}: the tolerance is {new}, was {old}")
                }
                _ => format!("{label}: another unit, or it must be written or not"),
            });
        }
        if let Some((old, new)) = points {
            said.push(format!("{label}: {new} points in the bank, were {old}"));
        }
        said
    }

    /// Who gains and who loses.
    pub fn marks(&self, text: &mut String) {
        if self.changes.is_empty() {
            text.push_str("  No mark changes.\n");
            return;
        }
        let mut rows = vec![terminal::head("part | gain | lose | points | why (answers)")];
        for part in 0..self.keys.new.columns.len() {
            let of: Vec<&MarkChange> = self.changes.iter().filter(|c| c.part == part).collect();
            if of.is_empty() {
                continue;
            }
            let count = |f: &dyn Fn(f64) -> bool| of.iter().filter(|c| f(c.gain())).count().to_string();
            let mut whys: BTreeMap<&Why, usize> = BTreeMap::new();
            for why in of.iter().flat_map(|c| &c.why) {
                *whys.entry(why).or_default() += 1;
            }
            let whys: Vec<String> = whys.iter().map(|(w, n)| format!("{} ({n})", w.as_str())).collect();
            rows.push(vec![
                self.label(part),
                count(&|g| g > DUST),
                count(&|g| g < -DUST),
                signed(of.iter().map(|c| c.gain()).sum()),
                whys.join(", "),
            ]);
        }
        text.push_str(&terminal::table(&rows, &[0, 4]));
        let total = |g: &Grading, s: usize| g.totals[s].map_or(0.0, |t| t.0);
        let mut moved: Vec<(usize, f64)> = (0..self.keys.new.students.len())
            .map(|s| (s, total(self.after, s) - total(self.before, s)))
            .filter(|(_, d)| d.abs() > DUST)
            .collect();
        let gain = moved.iter().filter(|(_, d)| *d > 0.0).count();
        let lose = moved.len() - gain;
        let n = self.keys.new.students.len().max(1) as f64;
        let mean = |g: &Grading| (0..self.keys.new.students.len()).map(|s| total(g, s)).sum::<f64>() / n;
        let _ = writeln!(
            text,
            "  Totals rise for {gain} and fall for {lose} of {}; their mean goes from {} to {}.",
            terminal::count(self.keys.new.students.len(), "student"),
            shown::decimals(mean(self.before), 2),
            shown::decimals(mean(self.after), 2)
        );
        // Those who lose first: they will ask.
        moved.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        let mut rows = vec![terminal::head("student | name | total | change | by part")];
        for (student, change) in moved.iter().take(SHOWN) {
            let of = self.changes.iter().filter(|c| c.student == *student && c.gain().abs() > DUST);
            let parts = of.map(|c| {
                let why: Vec<&str> = c.why.iter().map(|why| why.as_str()).collect();
                format!("{} {} ({})", self.label(c.part), signed(c.gain()), why.join(", "))
            });
            let parts = parts.collect::<Vec<_>>().join(", ");
            let (id, name) = &self.students[*student];
            let [was, is] = [self.before, self.after].map(|grading| points(total(grading, *student)));
            rows.push(vec![id.clone(), name.clone(), format!("{was} -> {is}"), signed(*change), parts]);
        }
        if !moved.is_empty() {
            text.push_str(&terminal::table(&rows, &[0, 1, 4]));
        }
        if moved.len() > SHOWN {
            let _ = writeln!(text, "  and {} more", moved.len() - SHOWN);
        }
    }

    pub fn csv(&self, policy: &Policy) -> Vec<u8> {
        let row = |change: &MarkChange| {
            let Column { number, problem, part, .. } = &self.keys.new.columns[change.part];
            let correction = policy.correction(*number, problem, part, change.is.is_some());
            let why = change.why.iter().map(|w| match (w, correction) {
                (Why::Correction, Some(c)) if !c.why.is_empty() => format!("correction: {}", c.why),
                _ => w.as_str().to_owned(),
            });
            let shown = |p: Option<f64>| p.map_or_else(String::new, points);
            let verdict = |v: Option<Verdict>| v.map_or("", |v| v.as_str()).to_owned();
            ChangeRow {
                student: self.keys.new.students[change.student].id.clone(),
                problem: number.to_string(),
                part: part.clone(),
                points_before: shown(change.before),
                points_after: shown(change.after),
                verdict_before: verdict(change.was),
                verdict_after: verdict(change.is),
                why: why.collect::<Vec<_>>().join("; "),
            }
        };
        ChangeRow::csv(&self.changes.iter().map(row).collect::<Vec<_>>())
    }
}

/// Which settings of the course differ.
fn settings(old: &Policy, new: &Policy) -> Vec<String> {
    let mut said = Vec::new();
    let of = |c: &Correction| (c.part.text(), c.share.to_bits(), c.to);
    let came = |c: &&Correction| old.corrections.iter().all(|o| of(o) != of(c));
    said.extend(new.corrections.iter().filter(came).map(|c| c.in_words(&c.part.text())));
    let gone = |c: &&Correction| !new.corrections.iter().any(|n| n.part.text() == c.part.text());
    let gone = old.corrections.iter().filter(gone);
    said.extend(gone.map(|c| format!("the correction of {} is gone", c.part.text())));
    let points = |p: &Policy| p.points.iter().map(|(p, x)| (p.text(), x.to_bits())).collect::<Vec<_>>();
    let differ = [
        ("due", old.due != new.due || old.zone != new.zone || old.day_first != new.day_first),
        ("extensions", old.extensions != new.extensions),
        ("attempts", old.attempts != new.attempts),
        ("late", old.late != new.late),
        ("credit", old.credit != new.credit),
        ("points", points(old) != points(new)),
        ("drop lowest", old.drop_lowest != new.drop_lowest),
        ("round", old.rounding != new.rounding),
    ];
    let differ: Vec<&str> = differ.iter().filter(|(_, d)| *d).map(|(name, _)| *name).collect();
    if !differ.is_empty() {
        said.push(format!("settings that differ: {}", differ.join(", ")));
    }
    said
}

/// Points without the dust of sums.
fn points(value: f64) -> String {
    crate::policy::plain(value).to_string()
}

fn signed(value: f64) -> String {
    let value = crate::policy::plain(value);
    if value > 0.0 { format!("+{value}") } else { value.to_string() }
}
