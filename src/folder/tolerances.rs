//! All answers of a grading, graded anew by other tolerances; nothing is written.
use crate::bank::Relative;
use crate::finding::Findings;
use crate::folder::graded::OpenGrading;
use crate::folder::grading::run_file;
use crate::folder::{files, graded};
use crate::grade::row::AnswerRow;
use crate::grade::rules::Rules;
use crate::grade::run::Options;
use crate::grade::table::KeyTable;
use crate::key::{Answer, SheetKey};
use crate::policy::Unread;
use crate::problem::make_key;
use crate::regrade::changes::Grading;
use crate::regrade::tolerance::WhatIf;
use crate::report::tolerances::Trial;
use crate::report::{gradebook, tolerances};
use crate::set::dealer::Dealt;
use std::io::{self, Write as _};
use std::path::Path;
use tempfile::NamedTempFile;

/// All answers graded by a key.
struct GradedAnew {
    answers: Grading,
    /// Totals as in the gradebook.
    totals: Vec<f64>,
}

/// How many verdicts of a grading would change with each of these relative tolerances, in words. Errors: the folder is no
/// grading, or cannot be read.
pub fn what_if(folder: &Path, shares: &[f64]) -> Result<String, Findings> {
    let graded = graded::open(folder, None)?;
    let table = |share: Option<f64>| {
        let mut table = KeyTable::new(graded.given.iter().map(|g| key(&graded, g, share)).collect(), &[]);
        table.take_points(&graded.policy);
        table
    };
    let now = table(None);
    let (students, parts) = (now.students.len(), now.columns.len());
    let handed = handed_in(&graded).map_err(files::trouble(folder, "cannot be graded"))?;
    let as_is = run_with(&graded, &now, &handed)?;
    let mut trials = Vec::new();
    for &share in shares {
        let table = table(Some(share));
        let other = run_with(&graded, &table, &handed)?;
        let mut what = WhatIf::new(parts);
        what.take(&as_is.answers, &other.answers);
        for part in 0..parts {
            for student in 0..students {
                if let (Some(entry), Some(other)) = (now.entry(student, part), table.entry(student, part)) {
                    what.key(part, entry, other);
                }
            }
        }
        trials.push(Trial { share, what, totals: other.totals });
    }
    let counting = as_is.answers.cells.iter().flatten().count() as u64;
    Ok(tolerances::told(&folder.display().to_string(), &now, &trials, &as_is.totals, counting))
}

/// The answers of a grading as they were handed in, one a line and in their order: a file of submissions again.
fn handed_in(graded: &OpenGrading) -> Result<NamedTempFile, io::Error> {
    let mut timed = false;
    let mut faults = Findings::default();
    let mut see = |see: &mut dyn FnMut(AnswerRow)| {
        if let Err(fault) = graded.each_row(see) {
            faults.extend(fault);
        }
    };
    see(&mut |row: AnswerRow| timed |= !row.submitted_at.is_empty());
    let mut file = NamedTempFile::new()?;
    let mut written = Ok(());
    {
        let mut out = csv::Writer::from_writer(io::BufWriter::new(file.as_file_mut()));
        let columns = if timed { 5 } else { 4 };
        out.write_record(&["student", "problem", "part", "answer", "submitted_at"][..columns])?;
        see(&mut |row: AnswerRow| {
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
fn run_with(graded: &OpenGrading, table: &KeyTable, handed: &NamedTempFile) -> Result<GradedAnew, Findings> {
    let trouble = files::trouble(&graded.folder, "cannot be graded");
    let mut policy = graded.policy.clone();
    // What is graded already may be from a version that did not ask.
    policy.late.unread.get_or_insert(Unread::InTime);
    let rules = Rules::new(table, &policy)?;
    let options = Options {
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        ..Options::default()
    };
    let file = NamedTempFile::new().map_err(trouble)?;
    let mut out = io::BufWriter::with_capacity(1 << 18, file.as_file());
    let names = (graded.folder.as_path(), file.path());
    let done = run_file(handed.path(), names, (table, &rules, &options), &mut out, &mut |_| {})?;
    out.flush().map_err(trouble)?;
    drop(out);
    let mut answers = Grading::new(table);
    graded::each_row(file.path(), &mut |row: AnswerRow| answers.take(table, row))?;
    let totals = (0..table.students.len())
        .map(|s| gradebook::total(table, &done.points, s, &graded.policy).points)
        .collect();
    Ok(GradedAnew { answers, totals })
}

/// The key of a student, with another relative tolerance if one is given; absolute tolerances stay.
fn key(graded: &OpenGrading, given: &Dealt, share: Option<f64>) -> SheetKey {
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
