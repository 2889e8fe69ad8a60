//! `slipstick regrade`: the same answers by a changed bank or course, as a diff; the old grading stays as it is.
use crate::cli::args;
use crate::cli::args::Reports;
use crate::cli::banks;
use crate::cli::changes::Desk;
use crate::cli::changes::Tables;
use crate::cli::files;
use crate::cli::generate;
use crate::cli::grade;
use crate::cli::grade::Basis;
use crate::cli::grade::Job;
use crate::cli::graded;
use crate::cli::graded::Graded;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::table::KeyTable;
use crate::key::SheetKey;
use crate::regrade::changes;
use crate::regrade::changes::Grading;
use crate::regrade::changes::Who;
use crate::set::given;
use crate::set::key_file;
use crate::set::store::StoredSet;
use crate::units::spell;
use std::collections::BTreeMap;
use std::fs;
use std::io::BufRead;
use std::path::Path;
use std::path::PathBuf;

/// Runs it.
pub fn run(args: &args::Regrade, io: &mut Io) -> Exit {
    let watched = io.watched;
    match regrade(args, &mut *io.input, watched) {
        Ok(done) => {
            for note in &done.notes {
                io.note(&format!("warning: {note}"));
            }
            io.piece(&done.told);
            // What was told is not yet written.
            match done.write() {
                Ok(text) => {
                    io.piece(&text);
                    Exit::Fine
                }
                Err(findings) => io.findings(&findings),
            }
        }
        Err(findings) => io.findings(&findings),
    }
}

/// A regrading that waits to be put in its place.
struct Done {
    told: String,
    notes: Vec<String>,
    made: grade::Made,
    out: Option<PathBuf>,
    old: PathBuf,
}

impl Done {
    fn write(self) -> Result<String, Findings> {
        match self.out {
            None => Ok("Nothing was written (--dry-run).\n".to_owned()),
            Some(out) => {
                self.made.reports()?;
                self.made.finish()?;
                Ok(format!(
                    "Written to {}, all changes in {}/{}; {} is as it was.\n",
                    out.display(),
                    out.display(),
                    graded::CHANGES,
                    self.old.display()
                ))
            }
        }
    }
}

fn regrade(args: &args::Regrade, input: &mut dyn BufRead, watched: bool) -> Result<Done, Findings> {
    if let Some(out) = &args.out {
        may_write(out, args)?;
    }
    let old = graded::open(&args.graded, None)?;
    let set = generate::existing(&args.set)?;
    same_set(&old.set, &set, args)?;
    let bank_path = args.bank.clone().unwrap_or_else(|| args.set.join(&set.bank.file));
    let bank_file = bank_path.display().to_string();
    let text = files::read_text(&bank_path)?;
    let bank = banks::parse(&text, &bank_file)?;
    let found = given::all(&bank, &set).map_err(|faults| {
        let mut found = graded::findings(&bank, faults, &bank_file);
        if let Some(last) = found.pop() {
            found.push(hinted(last, "sheets are printed: a regrading keeps their problems, parts and data, and needs a key for each"));
        }
        found
    })?;
    let keys: Vec<SheetKey> = found.into_iter().map(|g| g.key).collect();
    same_parts(&old, &keys, &bank_file)?;
    same_units(&old, &keys, &bank_file)?;
    let mut courses = grade::courses(&old.folder);
    courses.extend(args.course.clone());
    let typed = graded::attempts(old.grading.attempts.as_deref());
    // What was typed then holds unless the new course says otherwise.
    let then = grade::policy(&bank.grading, &grade::read_courses(&courses)?, None)?.attempts.counts;
    let before = grade::policy(&bank.grading, &grade::read_courses(&grade::courses(&old.folder))?, None)?;
    let attempts = args.attempts.or(typed.filter(|_| then == before.attempts.counts));
    let course = courses.last();
    let columns = if args.columns.is_empty() { &old.grading.columns } else { &args.columns };
    let language = args.language.as_deref().unwrap_or(&old.grading.language);
    // Where nothing is to be written, the folder goes away by itself.
    let nowhere = tempfile::tempdir().map_err(|e| files::trouble(Path::new("."), "cannot be made", &e))?;
    let nowhere_new = nowhere.path().join("regraded");
    let job = Job {
        set: &args.set,
        submissions: &args.submissions,
        out: args.out.as_deref().filter(|_| !args.dry_run).unwrap_or(&nowhere_new),
        attempts,
        courses: &courses,
        columns,
        language: Some(language),
        reports: Reports::Auto,
        force: false,
        watched,
    };
    let old_keys: Vec<SheetKey> = old.given.iter().map(|g| g.key.clone()).collect();
    let new_keys = keys.clone();
    let basis = Basis {
        set_text: set.text(),
        key_text: String::from_utf8_lossy(&key_file::text(&keys)).into_owned(),
        bank_text: text,
        replayed: old.grading.replayed,
        set,
        bank,
        keys,
    };
    let (set, bank) = (basis.set.clone(), basis.bank.clone());
    let made = grade::make(&job, basis, input)?;
    let tables = Tables { old: KeyTable::new(old_keys, &[]), new: KeyTable::new(new_keys, &[]) };
    let who = Who::new(
        set.students.iter().map(|s| s.student.clone()).collect(),
        tables.new.columns.iter().map(|c| (c.number, c.part.clone())).collect(),
    );
    let before = read(&who, &old.folder)?;
    let after = read(&who, made.folder())?;
    let places = tables.places(&who);
    let (then, now) = (&old.policy, made.policy());
    let settings = changes::Settings {
        costs: (&then.zone, then.due, &then.extensions, then.attempts, then.late)
            != (&now.zone, now.due, &now.extensions, now.attempts, now.late),
        credit: then.credit != now.credit,
    };
    let changes = changes::compare(&who, &before, &after, settings, &|s, p| tables.entries(&places, s, p));
    let desk = Desk {
        who: &who,
        set: &set,
        before: &before,
        after: &after,
        changes: &changes,
        tables: &tables,
        places: &places,
    };
    let mut told = format!("{} regraded\n", old.folder.display());
    desk.rules(&mut told, &old, (&bank, &bank_file), &made, course.map(PathBuf::as_path));
    desk.marks(&mut told);
    let csv = desk.csv(made.policy());
    let path = made.folder().join(graded::CHANGES);
    fs::write(&path, csv).map_err(|e| files::trouble(&path, "cannot be written", &e))?;
    let notes = notes(&old, &made);
    let out = args.out.clone().filter(|_| !args.dry_run);
    Ok(Done { told, notes, made, out, old: old.folder })
}

fn hinted(finding: Finding, hint: &str) -> Finding {
    if finding.hint.is_some() { finding } else { finding.hint(hint) }
}

/// A new folder, not within the old grading.
fn may_write(out: &Path, args: &args::Regrade) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("--out", what).in_file(out.display().to_string());
    files::not_among_students(out)?;
    if out.is_file() || (out.exists() && !files::names_in(out).is_empty()) {
        let hint = "a regrading keeps both versions: give a folder that is not there yet";
        return Err(finding("is there already").hint(hint));
    }
    let old = fs::canonicalize(&args.graded).ok();
    let above = out
        .ancestors()
        .skip(1)
        .find_map(|a| fs::canonicalize(if a.as_os_str().is_empty() { Path::new(".") } else { a }).ok());
    if old.zip(above).is_some_and(|(old, above)| above.starts_with(old)) {
        return Err(finding("is within the old grading, which stays as it is").hint("give another --out"));
    }
    Ok(())
}

/// The set must be that of the grading; students may have joined since.
fn same_set(old: &StoredSet, new: &StoredSet, args: &args::Regrade) -> Result<(), Findings> {
    let file = args.set.join("set.json").display().to_string();
    let finding = |field: &str, what: String| Finding::new(field, what).in_file(&file);
    let hint = format!("give the set that {} was graded with", args.graded.display());
    let mut faults = Findings::default();
    if (&old.name, old.seed) != (&new.name, new.seed) || old.problems != new.problems {
        let told = |s: &StoredSet| format!("{}, seed {}, problems {}", s.name, s.seed, s.problems.join(", "));
        faults
            .push(finding("", format!("is another set ({}) than the one graded ({})", told(new), told(old))));
    } else {
        let known: BTreeMap<&str, _> = new.students.iter().map(|s| (s.student.as_str(), s)).collect();
        for student in &old.students {
            match known.get(student.student.as_str()) {
                None => faults.push(finding("students", format!("{} is missing", student.student))),
                Some(now)
                    if now
                        .problems
                        .iter()
                        .map(|p| (&p.case, &p.data))
                        .ne(student.problems.iter().map(|p| (&p.case, &p.data))) =>
                {
                    let what =
                        format!("{} has other data than when the answers were graded", student.student);
                    faults.push(finding("students", what));
                }
                Some(_) => {}
            }
        }
    }
    let more = faults.len().saturating_sub(5);
    faults.truncate(5);
    if more > 0 {
        faults.push(finding("", format!("and {more} more differences")));
    }
    match faults.pop() {
        None => Ok(()),
        Some(last) => {
            faults.push(last.hint(hint));
            Err(faults)
        }
    }
}

/// No part may go or come: answers were given to those of the sheets.
fn same_parts(old: &Graded, keys: &[SheetKey], file: &str) -> Result<(), Findings> {
    let parts = |key: Option<&SheetKey>| -> Vec<(String, Vec<String>)> {
        let problems = key.map_or(&[][..], |k| &k.problems);
        problems.iter().map(|p| (p.id.clone(), p.parts.iter().map(|e| e.part.clone()).collect())).collect()
    };
    let (before, after) = (parts(old.given.first().map(|g| &g.key)), parts(keys.first()));
    let mut faults = Findings::default();
    for ((id, old), (_, new)) in before.iter().zip(&after) {
        let field = format!("problems.{id}.questions");
        for part in old.iter().filter(|p| !new.contains(p)) {
            let fault =
                Finding::new(&field, format!("part `{part}` is on the sheets, the bank has it no more"));
            let came = new.iter().filter(|p| !old.contains(p)).map(String::as_str);
            let fault = match spell::closest(part, came) {
                Some(near) => fault.hint(format!("was it renamed to `{near}`? Parts keep their ids")),
                None => fault.hint(
                    "keep the part; to take it out of the marks write `points` or `corrections` in a course file",
                ),
            };
            faults.push(fault.in_file(file));
        }
        for part in new.iter().filter(|p| !old.contains(p)) {
            let fault = Finding::new(&field, format!("part `{part}` is on no sheet"));
            faults.push(fault.in_file(file).hint("nobody was asked it: take it out again"));
        }
    }
    faults.into_result(())
}

/// A part that is asked in another unit reads answers without unit otherwise than the sheet said.
fn same_units(old: &Graded, keys: &[SheetKey], file: &str) -> Result<(), Findings> {
    let (Some(before), Some(after)) = (old.given.first(), keys.first()) else { return Ok(()) };
    let mut faults = Findings::default();
    for (old, new) in before.key.problems.iter().zip(&after.problems) {
        for was in &old.parts {
            let Some(is) = new.parts.iter().find(|e| e.part == was.part) else { continue };
            let needed = was.unit_required && is.unit_required;
            let (from, to) = (was.unit.ascii(), is.unit.ascii());
            if from != to && !needed {
                let shown = |unit: &str| if unit.is_empty() { "no unit".to_owned() } else { unit.to_owned() };
                let what = format!(
                    "the sheets ask for {}, the bank now for {}: answers without unit would be read otherwise than they were meant",
                    shown(from),
                    shown(to)
                );
                faults.push(
                    Finding::new(format!("problems.{}.questions.{}", new.id, was.part), what)
                        .in_file(file)
                        .hint("give the part its old unit back"),
                );
            }
        }
    }
    faults.into_result(())
}

fn read(who: &Who, folder: &Path) -> Result<Grading, Findings> {
    let mut found = Grading::new(who);
    graded::each_row(&folder.join(grade::ANSWERS), &mut |row| found.take(who, row))?;
    let path = folder.join(grade::GRADEBOOK);
    let bytes = files::read(&path)?;
    found.book(who, bytes.as_slice()).map_err(|fault| {
        let line = usize::try_from(fault.line).unwrap_or(1).max(1);
        Finding::new("", fault.what).at(line, 1).in_file(path.display().to_string())
    })?;
    Ok(found)
}

/// What is odd about the submissions.
fn notes(old: &Graded, made: &grade::Made) -> Vec<String> {
    let (was, is) = (&old.grading, made.grading());
    let mut notes = Vec::new();
    let hashes = was.submissions_sha256.as_ref().zip(is.submissions_sha256.as_ref());
    if was.submissions_bytes == is.submissions_bytes && hashes.is_some_and(|(a, b)| a != b) {
        notes.push(format!(
            "{} is as long as the file of the old grading, and another (by SHA-256): changes may come from other answers too",
            is.submissions
        ));
    } else if was.submissions_bytes != is.submissions_bytes {
        notes.push(format!(
            "{} has {} bytes, the old grading was made from {}: changes may come from other answers too",
            is.submissions, is.submissions_bytes, was.submissions_bytes
        ));
    } else if was.cells != is.cells {
        notes.push(format!(
            "{} answer cells are graded now, {} then: changes may come from other answers too",
            is.cells, was.cells
        ));
    }
    if was.program != is.program {
        notes.push(format!("graded by {} then, by {} now", was.program, is.program));
    }
    notes
}
