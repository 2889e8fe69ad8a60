//! What is proved of a key: for each question the gap of its two derivations and the enclosure.
use crate::finding::{Finding, Findings};
use crate::key::{Answer, KeyEntry, SheetKey};
use crate::num::{U, shown};
use crate::sheet::terminal;

/// What was seen of one question.
#[derive(Default)]
pub struct ProvedQuestion {
    name: String,
    answers: usize,
    words: usize,
    /// Largest distance of the two derivations: in units of the last place of the key, and whose.
    gap_ulps: f64,
    whose: String,
    /// The same in u max(1, cond).
    gap_bar: f64,
    worst_cond: f64,
    enclosed: usize,
    /// Widest enclosure as a share of the tolerance.
    widest: f64,
}

impl ProvedQuestion {
    fn add(&mut self, student: &str, entry: &KeyEntry) {
        let Answer::Number { value, half_width, .. } = entry.answer else {
            self.words += 1;
            return;
        };
        self.answers += 1;
        let cond = entry.cond.unwrap_or(f64::NAN);
        self.worst_cond = self.worst_cond.max(cond);
        if let (Some(eom), Some(energy)) = (entry.eom, entry.energy)
            && eom.is_finite()
            && energy.is_finite()
        {
            let ulps = (eom - energy).abs() / ulp(value);
            if ulps > self.gap_ulps || self.whose.is_empty() {
                self.gap_ulps = ulps;
                student.clone_into(&mut self.whose);
            }
            self.gap_bar = self.gap_bar.max(entry.gap.unwrap_or(f64::NAN) / U / cond.max(1.0));
        }
        if let Some(bound) = entry.bound {
            self.enclosed += 1;
            let share = if bound == 0.0 { 0.0 } else { bound / half_width };
            self.widest = self.widest.max(share);
        }
    }
    /// Do both derivations agree, and is the enclosure narrow?
    pub fn holds(&self) -> bool {
        self.gap_bar <= BAR && self.widest <= crate::problem::make_key::PROVED_SHARE
    }
}

/// Both derivations may differ by this many u max(1, cond); see [`crate::solve::agree::EACH_ROAD`].
const BAR: f64 = 16.0;

/// Distance from a double to the next one.
fn ulp(x: f64) -> f64 {
    let x = x.abs().max(f64::MIN_POSITIVE);
    x.next_up() - x
}

/// The questions of all keys, in the order of the sheet.
pub fn questions(keys: &[SheetKey]) -> Vec<ProvedQuestion> {
    let mut rows: Vec<ProvedQuestion> = Vec::new();
    for key in keys {
        for (i, problem) in key.problems.iter().enumerate() {
            for entry in &problem.parts {
                let name = format!("{}.{}", i + 1, entry.part);
                let at = rows.iter().position(|r| r.name == name).unwrap_or_else(|| {
                    rows.push(ProvedQuestion { name, ..ProvedQuestion::default() });
                    rows.len() - 1
                });
                rows[at].add(&key.student, entry);
            }
        }
    }
    rows
}

pub fn table(rows: &[ProvedQuestion]) -> String {
    let head = "question | answers | worst gap, ulps | in u max(1, cond) | worst cond | enclosed | error bound / tolerance";
    let mut lines = vec![terminal::head(head)];
    for row in rows {
        let mut line = vec![row.name.clone(), (row.answers + row.words).to_string()];
        if row.answers == 0 {
            line.push("in words".to_owned());
        } else {
            line.extend([
                shown::significant(row.gap_ulps, 3),
                shown::decimals(row.gap_bar, 2),
                shown::significant(row.worst_cond, 3),
                row.enclosed.to_string(),
                if row.enclosed == 0 { "-".to_owned() } else { shown::figures(row.widest, 1) },
            ]);
        }
        lines.push(line);
    }
    terminal::table(&lines, &[0])
}

/// The worst of it, in a sentence or two.
pub fn verdict(rows: &[ProvedQuestion]) -> String {
    let answers: usize = rows.iter().map(|r| r.answers).sum();
    let enclosed: usize = rows.iter().map(|r| r.enclosed).sum();
    let worst = rows.iter().filter(|r| r.answers > 0).max_by(|a, b| a.gap_ulps.total_cmp(&b.gap_ulps));
    let differ = match worst {
        Some(ProvedQuestion { gap_ulps, name, whose, .. }) if *gap_ulps > 0.0 => {
            let ulps = shown::significant(*gap_ulps, 3);
            format!(
                "Equations of motion and work and energy differ by {ulps} ulps at most ({name} of {whose}). "
            )
        }
        Some(_) => "Equations of motion and work and energy agree to the last bit. ".to_owned(),
        None => String::new(),
    };
    let widest = shown::figures(rows.iter().fold(0.0f64, |w, r| w.max(r.widest)), 1);
    format!(
        "{differ}{enclosed} of {answers} numbers are enclosed: the true answer for the printed data lies within {widest} of the tolerance."
    )
}

/// The questions that do not hold.
pub fn faults(rows: &[ProvedQuestion]) -> Findings {
    let bad = rows.iter().filter(|r| !r.holds());
    let text = |r: &ProvedQuestion| {
        format!(
            "equations of motion and work and energy differ by {} u max(1, cond) (at most {BAR}), the enclosure is {} of the tolerance (at most {})",
            shown::decimals(r.gap_bar, 1),
            shown::figures(r.widest, 2),
            shown::figures(crate::problem::make_key::PROVED_SHARE, 1)
        )
    };
    bad.map(|r| Finding::new(&r.name, text(r))).collect()
}
