//! `slipstick verify`: a set is drawn and solved again, and every key held against its enclosure.
use crate::cli::args;
use crate::cli::files;
use crate::cli::grade;
use crate::cli::grade::Replayed;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::key::Answer;
use crate::key::KeyEntry;
use crate::key::SheetKey;
use crate::num::U;
use crate::num::shown;
use crate::set::key_file;

/// Runs it.
pub fn run(args: &args::Verify, io: &mut Io) -> Exit {
    let made = grade::replayed(&args.set).and_then(|made| match made.not_drawn {
        // Held against its hash already.
        Some(_) => Ok(made),
        None => strangers(args, &made.keys).map(|()| made),
    });
    match made {
        Ok(Replayed { set, keys, not_drawn, .. }) => {
            let sheets = tell::count(keys.len(), "sheet");
            let variants = tell::count(keys.iter().map(|k| k.problems.len()).sum(), "variant");
            io.line(&match not_drawn {
                None => format!(
                    "{sheets}, {variants} drawn and solved again from seed {}: bank copy, drawn data and key.csv are what they were",
                    set.seed
                ),
                Some(told) => format!("{sheets}, {variants}, solved again from the stored data. {told}"),
            });
            let rows = rows(&keys);
            io.piece(&table(&rows));
            io.line(&verdict(&rows));
            if rows.iter().all(Row::holds) { Exit::Fine } else { io.findings(&faults(&rows)) }
        }
        Err(findings) => io.findings(&findings),
    }
}

/// A key with rows beside those of the set: grading leaves them alone, a proof does not.
fn strangers(args: &args::Verify, keys: &[SheetKey]) -> Result<(), Findings> {
    let path = args.set.join("key.csv");
    let stored = files::read(&path)?;
    let body = stored.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&stored);
    if body == key_file::text(keys) {
        return Ok(());
    }
    let fault = Finding::new("", "has rows of students who are not in the set, or is written otherwise");
    let fault = fault.in_file(path.display().to_string());
    Err(fault
        .hint("after an `--add` that was cut off run `generate --add` again; else put the original back")
        .into())
}

/// What was seen of one question.
#[derive(Default)]
struct Row {
    name: String,
    answers: usize,
    words: usize,
    /// Largest distance of the two roads: in units of the last place of the key, and whose.
    gap_ulps: f64,
    whose: String,
    /// The same in u max(1, cond).
    gap_bar: f64,
    worst_cond: f64,
    enclosed: usize,
    /// Widest enclosure as a share of the tolerance.
    widest: f64,
}

/// The roads may differ by this many u max(1, cond); see [`crate::solve::agree::EACH_ROAD`].
const BAR: f64 = 16.0;

impl Row {
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
    fn holds(&self) -> bool {
        self.gap_bar <= BAR && self.widest <= crate::problem::make_key::PROVED_SHARE
    }
}

/// Distance from a double to the next one.
fn ulp(x: f64) -> f64 {
    let x = x.abs().max(f64::MIN_POSITIVE);
    x.next_up() - x
}

fn rows(keys: &[SheetKey]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for key in keys {
        for (i, problem) in key.problems.iter().enumerate() {
            for entry in &problem.parts {
                let name = format!("{}.{}", i + 1, entry.part);
                let at = rows.iter().position(|r| r.name == name).unwrap_or_else(|| {
                    rows.push(Row { name, ..Row::default() });
                    rows.len() - 1
                });
                rows[at].add(&key.student, entry);
            }
        }
    }
    rows
}

fn table(rows: &[Row]) -> String {
    let header = [
        "question",
        "answers",
        "worst gap, ulps",
        "in u max(1, cond)",
        "worst cond",
        "enclosed",
        "error bound / tolerance",
    ];
    let mut lines = vec![header.map(str::to_owned).to_vec()];
    for row in rows {
        let mut line = vec![row.name.clone(), (row.answers + row.words).to_string()];
        if row.answers == 0 {
            line.push("in words".to_owned());
        } else {
            line.extend([
                words::rounded(row.gap_ulps, 3),
                shown::decimals(row.gap_bar, 2),
                words::rounded(row.worst_cond, 3),
                row.enclosed.to_string(),
                if row.enclosed == 0 { "-".to_owned() } else { shown::figures(row.widest, 1) },
            ]);
        }
        lines.push(line);
    }
    tell::table(&lines, &[0])
}

fn verdict(rows: &[Row]) -> String {
    let answers: usize = rows.iter().map(|r| r.answers).sum();
    let enclosed: usize = rows.iter().map(|r| r.enclosed).sum();
    let mut text = String::new();
    if let Some(worst) =
        rows.iter().filter(|r| r.answers > 0).max_by(|a, b| a.gap_ulps.total_cmp(&b.gap_ulps))
    {
        text = if worst.gap_ulps > 0.0 {
            let ulps = words::rounded(worst.gap_ulps, 3);
            format!("The roads differ by {ulps} ulps at most ({} of {}). ", worst.name, worst.whose)
        } else {
            "The roads agree to the last bit. ".to_owned()
        };
    }
    let widest = rows.iter().fold(0.0f64, |w, r| w.max(r.widest));
    text.push_str(&format!(
        "{enclosed} of {answers} numbers are enclosed: the true answer for the printed data lies within {} of the tolerance.",
        shown::figures(widest, 1)
    ));
    text
}

fn faults(rows: &[Row]) -> Findings {
    let bad = rows.iter().filter(|r| !r.holds());
    let text = |r: &Row| {
        format!(
            "the roads differ by {} u max(1, cond) (at most {BAR}), the enclosure is {} of the tolerance (at most {})",
            shown::decimals(r.gap_bar, 1),
            shown::figures(r.widest, 2),
            shown::figures(crate::problem::make_key::PROVED_SHARE, 1)
        )
    };
    bad.map(|r| Finding::new(&r.name, text(r))).collect()
}
