//! `slipstick what-if`: how many verdicts of a grading would change with other tolerances.
use crate::answer::read::UnitCache;
use crate::bank::Relative;
use crate::cli::args;
use crate::cli::explain::plain;
use crate::cli::graded;
use crate::cli::graded::Graded;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::finding::Finding;
use crate::grade::feedback::Feedback;
use crate::grade::table::KeyTable;
use crate::key::Answer;
use crate::key::SheetKey;
use crate::misconception::catalogue::Catalogue;
use crate::problem::make_key;
use crate::regrade::rows::Row;
use crate::regrade::tolerance::Change;
use crate::regrade::tolerance::WhatIf;
use std::collections::BTreeMap;

/// Runs it.
pub fn run(args: &args::WhatIf, io: &mut Io) -> Exit {
    match what_if(args) {
        Ok(text) => {
            io.piece(&text);
            Exit::Fine
        }
        Err(findings) => io.findings(&findings),
    }
}

/// Relative tolerances, as shares, from `0.5`, `2%`, `2 %`: per cent.
fn shares(typed: &[String]) -> Result<Vec<f64>, Vec<Finding>> {
    let (mut found, mut faults) = (Vec::new(), Vec::new());
    for text in typed {
        let number = text.trim().trim_end_matches('%').trim().replace(',', ".");
        match number.parse::<f64>() {
            Ok(value) if value > 0.0 && value <= 100.0 => found.push(value / 100.0),
            _ => faults.push(
                Finding::new("--tolerance", format!("`{text}` is no tolerance"))
                    .hint("per cent, above 0 and at most 100, such as --tolerance 0.5,1,2%"),
            ),
        }
    }
    found.sort_by(f64::total_cmp);
    found.dedup();
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

/// A share in per cent, without zeros at the end.
pub fn per_cent(share: f64) -> String {
    let text = format!("{:.3}", share * 100.0);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// One of the tolerances that are tried.
struct Trial {
    share: f64,
    table: KeyTable,
    what: WhatIf,
}

fn what_if(args: &args::WhatIf) -> Result<String, Vec<Finding>> {
    let shares = shares(&args.tolerance)?;
    let graded = graded::open(&args.graded, None)?;
    let keys = |share: Option<f64>| {
        KeyTable::new(graded.given.iter().map(|g| key(&graded, g, share)).collect(), &[])
    };
    let now = keys(None);
    let (students, parts) = (now.students.len(), now.columns.len());
    let mut trials: Vec<Trial> = shares
        .into_iter()
        .map(|share| Trial { share, table: keys(Some(share)), what: WhatIf::new(students, parts) })
        .collect();
    let column: BTreeMap<(String, &str), usize> =
        now.columns.iter().enumerate().map(|(i, c)| ((c.number.to_string(), c.part.as_str()), i)).collect();
    let whose: BTreeMap<&str, usize> =
        now.students.iter().enumerate().map(|(i, s)| (s.id.as_str(), i)).collect();
    let (mut units, say) = (UnitCache::default(), Feedback::english());
    let (mut answers, mut earned) = (0u64, 0.0);
    graded.each_row(&mut |row: Row| {
        if !row.counts() {
            return;
        }
        let student = whose.get(row.student.as_str()).copied();
        let part = column.get(&(row.problem.clone(), row.part.as_str())).copied();
        let (Some(student), Some(part)) = (student, part) else { return };
        earned += row.points;
        answers += 1;
        for trial in &mut trials {
            if let Some(entry) = trial.table.entry(student, part) {
                trial.what.take(&row, (student, part), entry, &mut units, say);
            }
        }
    })?;
    for trial in &mut trials {
        for part in 0..parts {
            for student in 0..students {
                if let (Some(entry), Some(other)) =
                    (now.entry(student, part), trial.table.entry(student, part))
                {
                    trial.what.key(part, entry, other);
                }
            }
        }
    }
    Ok(told(args, &now, &trials, answers, earned))
}

/// The key of a student, with another relative tolerance if one is given; absolute tolerances stay.
fn key(graded: &Graded, given: &crate::set::given::Given, share: Option<f64>) -> SheetKey {
    let mut key = given.key.clone();
    let Some(share) = share else { return key };
    for (problem, variant) in key.problems.iter_mut().zip(&given.variants) {
        let Some(of) = graded.bank.problems.iter().find(|p| p.id == problem.id) else { continue };
        for entry in &mut problem.parts {
            let Some(question) = of.questions.iter().find(|q| q.id == entry.part) else { continue };
            let other = crate::bank::Question { relative: Relative::Fixed(share), ..question.clone() };
            if let (Answer::Number { value, half_width, .. }, Some(solved)) =
                (&mut entry.answer, variant.solved.get(question.label))
            {
                *half_width = make_key::half_width(&other, *value, solved.scale, solved.cond);
            }
        }
    }
    key
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
    let shown = |share: f64| match words::rounded(share * 100.0, 2) {
        text if text.contains('.') => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        text => text,
    };
    match range {
        None => "-".to_owned(),
        Some((least, most)) if shown(least) == shown(most) => format!("{} %", shown(least)),
        Some((least, most)) => format!("{}-{} %", shown(least), shown(most)),
    }
}

fn told(args: &args::WhatIf, now: &KeyTable, trials: &[Trial], answers: u64, earned: f64) -> String {
    let mut text = format!(
        "{}: {} of {}; answers that would become right (+) or no longer be right (-)\n",
        args.graded.display(),
        if answers == 1 {
            "1 answer that counts".to_owned()
        } else {
            format!("{answers} answers that count")
        },
        tell::count(now.students.len(), "student")
    );
    let changed = |c: &Change| match (c.gained, c.lost) {
        (0, 0) => "0".to_owned(),
        (gained, 0) => format!("+{gained}"),
        (0, lost) => format!("-{lost}"),
        (gained, lost) => format!("+{gained} -{lost}"),
    };
    let mut rows = vec![vec!["part".to_owned(), "tolerance now".to_owned()]];
    rows[0].extend(trials.iter().map(|t| format!("{} %", per_cent(t.share))));
    for (i, column) in now.columns.iter().enumerate() {
        let mut row = vec![format!("{}.{}", column.number, column.part), tolerance(now, i)];
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
    line("students who gain", String::new(), &|t| {
        t.what.points.iter().filter(|p| **p > DUST).count().to_string()
    });
    line("students who lose", String::new(), &|t| {
        t.what.points.iter().filter(|p| **p < -DUST).count().to_string()
    });
    line("mean of points", format!("{:.2}", earned / students), &|t| {
        format!("{:.2}", (earned + t.what.points.iter().sum::<f64>()) / students)
    });
    line("answers of wrong methods that would pass", String::new(), &|t| t.what.total().methods.to_string());
    line("sheets where a wrong method would pass", String::new(), &|t| t.what.total().within.to_string());
    text.push_str(&tell::table(&rows, &[0]));
    let catalogue = Catalogue::built_in();
    for trial in trials.iter().filter(|t| !t.what.methods.is_empty()) {
        let total = trial.what.total();
        text.push_str(&format!(
            "  warning: at {} % {} of a known wrong method would be right:\n",
            per_cent(trial.share),
            tell::count(usize::try_from(total.methods).unwrap_or(usize::MAX), "answer")
        ));
        let mut list: Vec<(&String, &u64)> = trial.what.methods.iter().collect();
        list.sort_by(|a, b| b.1.cmp(a.1).then(a.0.cmp(b.0)));
        for (id, count) in list {
            let did = catalogue.get(id).map_or_else(String::new, |e| plain(&e.did));
            text.push_str(&format!("    {count} x {id}  {did}\n"));
        }
    }
    text.push_str(
        "  Absolute tolerances stay. Points are those of the answers that count now, before dropping and rounding.\n",
    );
    text
}
