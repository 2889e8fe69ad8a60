//! `slipstick what-if`: how many verdicts of a grading would change with other tolerances.
use crate::bank::Relative;
use crate::cli::args;
use crate::cli::files;
use crate::cli::graded;
use crate::cli::graded::Graded;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::rules::Rules;
use crate::grade::run;
use crate::grade::run::GradeFault;
use crate::grade::run::Options;
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;
use crate::key::Answer;
use crate::key::SheetKey;
use crate::misconception::catalogue::Catalogue;
use crate::num::shown;
use crate::policy::Unread;
use crate::problem::make_key;
use crate::regrade::rows::Row;
use crate::regrade::tolerance::Cell;
use crate::regrade::tolerance::Change;
use crate::regrade::tolerance::WhatIf;
use crate::report::gradebook;
use crate::sheet::terminal::plain;
use std::collections::BTreeMap;
use std::fs::File;
use std::io;
use std::io::Read;
use std::io::Write as _;
use tempfile::NamedTempFile;

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
fn shares(typed: &[String]) -> Result<Vec<f64>, Findings> {
    let (mut found, mut faults) = (Vec::new(), Findings::default());
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
    faults.into_result(found)
}

/// A share in per cent, without zeros at the end.
pub fn per_cent(share: f64) -> String {
    let text = shown::decimals(share * 100.0, 3);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// One of the tolerances that are tried.
struct Trial {
    share: f64,
    what: WhatIf,
    totals: Vec<f64>,
}

/// All answers graded by a key.
struct Run {
    /// Student after student, what counts for each part.
    cells: Vec<Cell>,
    /// Totals as in the gradebook.
    totals: Vec<f64>,
    /// How many answers count.
    answers: u64,
}

fn what_if(args: &args::WhatIf) -> Result<String, Findings> {
    let shares = shares(&args.tolerance)?;
    let graded = graded::open(&args.graded, None)?;
    let table = |share: Option<f64>| {
        let mut table = KeyTable::new(graded.given.iter().map(|g| key(&graded, g, share)).collect(), &[]);
        table.take_points(&graded.policy);
        table
    };
    let now = table(None);
    let (students, parts) = (now.students.len(), now.columns.len());
    let handed = handed_in(&graded).map_err(|e| files::trouble(&args.graded, "cannot be graded", &e))?;
    let as_is = run_with(&graded, &now, &handed)?;
    let mut trials = Vec::new();
    for share in shares {
        let table = table(Some(share));
        let other = run_with(&graded, &table, &handed)?;
        let mut what = WhatIf::new(parts);
        what.take(&as_is.cells, &other.cells);
        for part in 0..parts {
            for student in 0..students {
                if let (Some(entry), Some(other)) = (now.entry(student, part), table.entry(student, part)) {
                    what.key(part, entry, other);
                }
            }
        }
        trials.push(Trial { share, what, totals: other.totals });
    }
    Ok(told(args, &now, &trials, &as_is))
}

/// The answers of a grading as they were handed in, one a line and in their order: a file of submissions again.
fn handed_in(graded: &Graded) -> Result<NamedTempFile, io::Error> {
    let mut timed = false;
    let mut faults = Findings::default();
    let mut see = |see: &mut dyn FnMut(Row)| {
        if let Err(fault) = graded.each_row(see) {
            faults.extend(fault);
        }
    };
    see(&mut |row: Row| timed |= !row.submitted_at.is_empty());
    let mut file = NamedTempFile::new()?;
    let mut written = Ok(());
    {
        let mut out = csv::Writer::from_writer(io::BufWriter::new(file.as_file_mut()));
        let columns = if timed { 5 } else { 4 };
        out.write_record(&["student", "problem", "part", "answer", "submitted_at"][..columns])?;
        see(&mut |row: Row| {
            let fields = [&row.student, &row.problem, &row.part, &row.answer, &row.submitted_at];
            if written.is_ok() {
                written = out.write_record(fields[..columns].iter().map(|f| f.as_bytes()));
            }
        });
        out.flush()?;
    }
    written?;
    match faults.first() {
        Some(fault) => Err(io::Error::other(fault.to_string())),
        None => Ok(file),
    }
}

/// Grades them by another key, by the same settings.
fn run_with(graded: &Graded, table: &KeyTable, handed: &NamedTempFile) -> Result<Run, Findings> {
    let trouble = |e: &io::Error| files::trouble(&graded.folder, "cannot be graded", e);
    let mut policy = graded.policy.clone();
    // What is graded already may be from a version that did not ask.
    policy.late.unread.get_or_insert(Unread::InTime);
    let rules = Rules::new(table, &policy)?;
    let open = || -> io::Result<Box<dyn Read + Send>> { Ok(Box::new(File::open(handed.path())?)) };
    let options = Options {
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        ..Options::default()
    };
    let mut file = NamedTempFile::new().map_err(|e| trouble(&e))?;
    let mut out = io::BufWriter::with_capacity(1 << 18, file.as_file_mut());
    let done =
        run::grade(&open, table, &rules, &options, &mut out, &mut |_| {}).map_err(|why| match why {
            GradeFault::Io(e) | GradeFault::Write(e) => Findings::from(trouble(&e)),
            GradeFault::Header(findings) => findings,
        })?;
    out.flush().map_err(|e| trouble(&e))?;
    drop(out);
    let parts = table.columns.len();
    let column: BTreeMap<(String, &str), usize> =
        table.columns.iter().enumerate().map(|(i, c)| ((c.number.to_string(), c.part.as_str()), i)).collect();
    let whose: BTreeMap<&str, usize> =
        table.students.iter().enumerate().map(|(i, s)| (s.id.as_str(), i)).collect();
    let mut cells = vec![Cell::default(); table.students.len() * parts];
    let mut answers = 0;
    graded::each_row(file.path(), &mut |row: Row| {
        if !row.counts() {
            return;
        }
        let student = whose.get(row.student.as_str());
        let part = column.get(&(row.problem, row.part.as_str()));
        let (Some(student), Some(part)) = (student, part) else { return };
        answers += 1;
        cells[student * parts + part] = Cell { right: row.verdict == Verdict::Right, methods: row.methods };
    })?;
    let totals = (0..table.students.len())
        .map(|s| gradebook::total(table, &done.points, s, &graded.policy).points)
        .collect();
    Ok(Run { cells, totals, answers })
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

fn told(args: &args::WhatIf, now: &KeyTable, trials: &[Trial], as_is: &Run) -> String {
    let answers = as_is.answers;
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
    let moved = |t: &Trial, gain: bool| {
        let moves = t.totals.iter().zip(&as_is.totals).map(|(is, was)| is - was);
        moves.filter(|d| if gain { *d > DUST } else { *d < -DUST }).count().to_string()
    };
    line("students who gain", String::new(), &|t| moved(t, true));
    line("students who lose", String::new(), &|t| moved(t, false));
    let mean = |totals: &[f64]| shown::decimals(totals.iter().sum::<f64>() / students, 2);
    line("mean of totals", mean(&as_is.totals), &|t| mean(&t.totals));
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
        "  Absolute tolerances stay. All answers are graded anew by each: attempts, lateness, follow-through, corrections, totals.\n",
    );
    text
}
