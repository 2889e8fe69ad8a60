//! How many verdicts of a grading would change with other tolerances, as a table.
use crate::grade::table::KeyTable;
use crate::key::Answer;
use crate::misconception::catalogue::Catalogue;
use crate::num::shown;
use crate::regrade::tolerance::{ToleranceChange, WhatIf};
use crate::sheet::terminal;
use crate::words::plain::plain;

/// One of the tolerances that are tried.
pub struct Trial {
    pub share: f64,
    /// What changes.
    pub what: WhatIf,
    /// Totals as in the gradebook.
    pub totals: Vec<f64>,
}

/// `1 %`, or the range where variants differ; `-` for a word.
pub fn tolerance(table: &KeyTable, part: usize) -> String {
    let mut range: Option<(f64, f64)> = None;
    for student in 0..table.students.len() {
        if let Some(Answer::Number { value, half_width, .. }) = table.entry(student, part).map(|e| &e.answer)
            && *value != 0.0
        {
            let share = half_width / value.abs();
            let (least, most) = range.unwrap_or((share, share));
            range = Some((least.min(share), most.max(share)));
        }
    }
    // Where an absolute tolerance is the wider one, the share is no round number.
    let shown = |share: f64| shown::without_zeros(&shown::significant(share * 100.0, 2));
    match range {
        None => "-".to_owned(),
        Some((least, most)) if shown(least) == shown(most) => format!("{} %", shown(least)),
        Some((least, most)) => format!("{}-{} %", shown(least), shown(most)),
    }
}

/// The table: what changes with each tolerance that is tried, of so many answers that count with these totals.
pub fn told(graded: &str, now: &KeyTable, trials: &[Trial], totals: &[f64], answers: u64) -> String {
    let answers =
        terminal::count(answers, "answer") + if answers == 1 { " that counts" } else { " that count" };
    let students = terminal::count(now.students.len(), "student");
    let mut text = format!(
        "{graded}: {answers} of {students}; answers that would become right (+) or no longer be right (-)\n"
    );
    let changed = |c: &ToleranceChange| match (c.gained, c.lost) {
        (0, 0) => "0".to_owned(),
        (gained, 0) => format!("+{gained}"),
        (0, lost) => format!("-{lost}"),
        (gained, lost) => format!("+{gained} -{lost}"),
    };
    let mut rows = vec![vec!["part".to_owned(), "tolerance now".to_owned()]];
    rows[0].extend(trials.iter().map(|t| format!("{} %", shown::per_cent(t.share, 3))));
    for (i, column) in now.columns.iter().enumerate() {
        let mut row = vec![column.label(), tolerance(now, i)];
        if row[1] == "-" {
            continue;
        }
        row.extend(trials.iter().map(|t| changed(&t.what.parts[i])));
        rows.push(row);
    }
    let mut line = |name: &str, now: String, each: &dyn Fn(&Trial) -> String| {
        let mut row = vec![name.to_owned(), now];
        row.extend(trials.iter().map(each));
        rows.push(row);
    };
    let students = now.students.len().max(1) as f64;
    const DUST: f64 = 1e-9;
    line("all parts", String::new(), &|t| changed(&t.what.total()));
    let moved = |t: &Trial, gain: bool| {
        let moves = t.totals.iter().zip(totals).map(|(is, was)| is - was);
        moves.filter(|d| if gain { *d > DUST } else { *d < -DUST }).count().to_string()
    };
    line("students who gain", String::new(), &|t| moved(t, true));
    line("students who lose", String::new(), &|t| moved(t, false));
    let mean = |totals: &[f64]| shown::decimals(totals.iter().sum::<f64>() / students, 2);
    line("mean of totals", mean(totals), &|t| mean(&t.totals));
    line("answers of wrong methods that would pass", String::new(), &|t| t.what.total().methods.to_string());
    line("sheets where a wrong method would pass", String::new(), &|t| t.what.total().within.to_string());
    text.push_str(&terminal::table(&rows, &[0]));
    let catalogue = Catalogue::shared("en");
    for trial in trials.iter().filter(|t| !t.what.methods.is_empty()) {
        let total = trial.what.total();
        let (share, answers) = (shown::per_cent(trial.share, 3), terminal::count(total.methods, "answer"));
        text.push_str(&format!(
            "  warning: at {share} % {answers} of a known wrong method would be right:\n"
        ));
        let mut list: Vec<(&String, &u64)> = trial.what.methods.iter().collect();
        list.sort_by(|a, b| b.1.cmp(a.1).then(a.0.cmp(b.0)));
        for (id, count) in list {
            let did = catalogue.get(id).map_or_else(String::new, |e| plain(&e.did));
            text.push_str(&format!("    {count} x {id}  {did}\n"));
        }
    }
    text.push_str(
        "  Absolute tolerances stay. All answers are graded anew by each: attempts, lateness, follow-through, corrections, totals.\n",
    );
    text
}
