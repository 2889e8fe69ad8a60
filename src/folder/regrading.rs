//! The same answers by a changed bank or course, as a diff; the old grading stays as it is.
use crate::bank::Bank;
use crate::finding::{Finding, Findings, FirstFindings};
use crate::folder::graded::OpenGrading;
use crate::folder::grading::{Basis, GradeOrder, Reports, StagedGrading};
use crate::folder::{Progress, banks, files, graded, grading, names, set};
use crate::grade::table::KeyTable;
use crate::key::SheetKey;
use crate::policy::Counts;
use crate::regrade::changes::{Grading, Settings, compare};
use crate::report::changes::{ChangesTold, KeysBeforeAfter};
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::set::{given, key_file};
use crate::units::spell;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::BufRead;
use std::path::{Path, PathBuf};

/// What is to be graded again.
pub struct RegradingJob<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// Folder of the grading.
    pub graded: &'j Path,
    /// File of submissions; `-` is standard input.
    pub submissions: &'j Path,
    /// Folder to make; none where only the changes are told.
    pub out: Option<&'j Path>,
    /// The changed bank; that of the set if not given.
    pub bank: Option<&'j Path>,
    /// Settings over those of the old grading.
    pub course: Option<&'j Path>,
    pub attempts: Option<Counts>,
    /// `field=header`; those of the old grading if empty.
    pub columns: &'j [String],
    /// Language of the reasons; that of the old grading if not given.
    pub language: Option<&'j str>,
    /// Only tell what would change.
    pub dry_run: bool,
    /// Is told how far it is.
    pub progress: &'j dyn Progress,
}

/// A regrading that waits to be put in its place.
pub struct Regrading {
    /// What changes, in words.
    pub told: String,
    /// What is odd about the submissions.
    pub notes: Vec<String>,
    made: StagedGrading,
    out: Option<PathBuf>,
    old: PathBuf,
}

impl Regrading {
    /// Puts it in its place: where it is, in words. Errors: a file cannot be written.
    pub fn write(self) -> Result<String, Findings> {
        let Some(out) = self.out else { return Ok("Nothing was written (--dry-run).\n".to_owned()) };
        self.made.reports()?;
        self.made.finish()?;
        let (out, old, changes) = (out.display(), self.old.display(), names::CHANGES);
        Ok(format!("Written to {out}, with every change in {out}/{changes}; {old} stays as it was.\n"))
    }
}

/// Grades again, beside the place where the new grading is to be. Errors: the folders do not belong together, the bank or the
/// course is faulty, or what is on the sheets has no key any more.
pub fn regrade(job: &RegradingJob, input: &mut dyn BufRead) -> Result<Regrading, Findings> {
    if let Some(out) = job.out {
        may_write(out, job)?;
    }
    let old = graded::open(job.graded, None)?;
    let mut set = set::open(job.set)?;
    same_as_graded(&old, &set, job)?;
    let bank_path = job.bank.map_or_else(|| job.set.join(&set.bank.file), Path::to_owned);
    let bank_file = bank_path.display().to_string();
    let bank_text = files::read_text(&bank_path)?;
    let bank = banks::parse(&bank_text, &bank_file)?;
    let mut keys = keys(&bank, &set, &bank_file)?;
    // Of a quiz each student keeps the variants that were asked; the set says which codes there are.
    let asked = match old.grading.quiz {
        true => {
            let of_quiz = self::keys(&bank, &old.set, &bank_file)?;
            Some((std::mem::replace(&mut set, old.set.clone()), std::mem::replace(&mut keys, of_quiz)))
        }
        false => None,
    };
    same_parts(&old, &keys, &bank_file)?;
    same_units(&old, &keys, &bank_file)?;
    let mut courses = graded::courses(&old.folder);
    let policy_of =
        |courses: &[PathBuf]| graded::policy(&bank.grading, &graded::read_courses(courses)?, None);
    let before = policy_of(&courses)?.attempts.counts;
    courses.extend(job.course.map(Path::to_owned));
    // What was typed then holds unless the new course says otherwise.
    let same = policy_of(&courses)?.attempts.counts == before;
    let said = graded::counts_said(&old.grading).filter(|_| same);
    // Where nothing is to be written, the folder goes away by itself.
    let nowhere = tempfile::tempdir().map_err(files::trouble(Path::new("."), "cannot be made"))?;
    let nowhere = nowhere.path().join("regraded");
    let out = job.out.filter(|_| !job.dry_run);
    let grade = GradeOrder {
        set: job.set,
        submissions: job.submissions,
        out: out.unwrap_or(&nowhere),
        attempts: job.attempts.or(said),
        courses: &courses,
        columns: if job.columns.is_empty() { &old.grading.columns } else { job.columns },
        language: Some(job.language.unwrap_or(&old.grading.language)),
        reports: Reports::Auto,
        force: false,
        progress: job.progress,
    };
    let who_is = set.students.iter().map(|s| (s.student.clone(), s.name.clone())).collect::<Vec<_>>();
    let old_keys = KeyTable::new(old.given.iter().map(|g| g.key.clone()).collect(), &[]);
    let tables = KeysBeforeAfter::new(old_keys, KeyTable::new(keys.clone(), &[]));
    let hash = bank.hash.clone();
    let basis = Basis {
        set_text: set.text(),
        key_text: String::from_utf8_lossy(&key_file::text(&keys)).into_owned(),
        bank_text,
        whole: true,
        replayed: old.grading.replayed,
        set,
        bank,
        keys,
        asked,
    };
    let made = grading::make(&grade, basis, input)?;
    let mut told = format!("What changes in {}:\n", old.folder.display());
    let rules = (old.bank.hash.as_str(), hash.as_str(), bank_file.as_str());
    let csv = changes(&old, &made, &tables, &who_is, rules, courses.last().map(PathBuf::as_path), &mut told)?;
    let path = made.folder().join(names::CHANGES);
    fs::write(&path, csv).map_err(files::trouble(&path, "cannot be written"))?;
    let notes = notes(&old, &made);
    Ok(Regrading { told, notes, made, out: out.map(Path::to_owned), old: old.folder })
}

/// The keys of the printed sheets by the new bank.
fn keys(bank: &Bank, set: &StoredSet, file: &str) -> Result<Vec<SheetKey>, Findings> {
    const HINT: &str =
        "sheets are printed: a regrading keeps their problems, parts and data, and needs a key for each";
    let found = given::all(bank, set);
    let found = found.map_err(|faults| graded::findings(bank, faults, file).hint_last(HINT))?;
    Ok(found.into_iter().map(|g| g.key).collect())
}

/// Tells what changes; changes.csv.
fn changes(
    old: &OpenGrading,
    made: &StagedGrading,
    tables: &KeysBeforeAfter,
    students: &[(String, String)],
    rules: (&str, &str, &str),
    course: Option<&Path>,
    told: &mut String,
) -> Result<Vec<u8>, Findings> {
    let keys = &tables.new;
    let before = read(keys, &old.folder)?;
    let after = read(keys, made.folder())?;
    let (then, now) = (&old.policy, &made.policy);
    let settings = Settings {
        costs: (&then.zone, then.due, &then.extensions, then.attempts, then.late)
            != (&now.zone, now.due, &now.extensions, now.attempts, now.late),
        credit: then.credit != now.credit,
    };
    let changes = compare(keys, &before, &after, settings, &|s, p| tables.entries(s, p));
    let writer = ChangesTold { students, before: &before, after: &after, changes: &changes, keys: tables };
    writer.rules(told, rules, (then, now), course);
    writer.marks(told);
    Ok(writer.csv(now))
}

/// A new folder, not within the old grading.
fn may_write(out: &Path, job: &RegradingJob) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("--out", what).in_file(out.display().to_string());
    files::not_among_students(out)?;
    if out.is_file() || (out.exists() && !files::names_in(out).is_empty()) {
        let hint = "a regrading keeps both versions: give a folder that is not there yet";
        return Err(finding("is there already").hint(hint));
    }
    let old = fs::canonicalize(job.graded).ok();
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
fn same_as_graded(graded: &OpenGrading, new: &StoredSet, job: &RegradingJob) -> Result<(), Findings> {
    let old = &graded.set;
    let file = job.set.join(names::SET).display().to_string();
    let mut faults = FirstFindings::default();
    // A quiz need not ask all problems of its set.
    let same_problems = match graded.grading.quiz {
        true => old.problems.iter().all(|id| new.problems.contains(id)),
        false => old.problems == new.problems,
    };
    if (&old.name, old.seed) != (&new.name, new.seed) || !same_problems {
        let told = |s: &StoredSet| format!("{}, seed {}, problems {}", s.name, s.seed, s.problems.join(", "));
        let what = format!("is another set ({}) than the one graded ({})", told(new), told(old));
        faults.push(Finding::new("", what));
    } else if graded.grading.quiz {
        let variants = |set: &StoredSet| -> BTreeSet<String> {
            let own =
                |v: &StoredVariant| v.parts.values().chain([v]).map(StoredVariant::code).collect::<Vec<_>>();
            set.students.iter().flat_map(|s| s.problems.iter().flat_map(own)).collect()
        };
        let gone: Vec<String> = variants(old).difference(&variants(new)).take(5).cloned().collect();
        if !gone.is_empty() {
            let what = format!("variants that the quiz asked are missing: {}", gone.join(", "));
            faults.push(Finding::new("students", what));
        }
    } else {
        let known: BTreeMap<&str, _> = new.students.iter().map(|s| (s.student.as_str(), s)).collect();
        let data = |s: &StoredStudent| {
            s.problems.iter().map(|p| (p.case.clone(), p.data.clone())).collect::<Vec<_>>()
        };
        for student in &old.students {
            let what = match known.get(student.student.as_str()) {
                None => "is missing",
                Some(now) if data(now) != data(student) => "has other data than when the answers were graded",
                Some(_) => continue,
            };
            faults.push(Finding::new("students", format!("{} {what}", student.student)));
        }
    }
    let hint = format!("give the set that {} was graded with", job.graded.display());
    faults.told().in_file(file).hint_last(&hint).into_result(())
}

/// No part may go or come: answers were given to those of the sheets.
fn same_parts(old: &OpenGrading, keys: &[SheetKey], file: &str) -> Result<(), Findings> {
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
            const KEEP: &str =
                "keep the part; to take it out of the marks write `points` or `corrections` in a course file";
            let renamed = |near| format!("was it renamed to `{near}`? Parts keep their ids");
            let hint = spell::closest(part, came).map_or_else(|| KEEP.to_owned(), renamed);
            faults.push(fault.in_file(file).hint(hint));
        }
        for part in new.iter().filter(|p| !old.contains(p)) {
            let fault = Finding::new(&field, format!("part `{part}` is on no sheet"));
            faults.push(fault.in_file(file).hint("nobody was asked it: take it out again"));
        }
    }
    faults.into_result(())
}

/// A part that is asked in another unit reads answers without unit otherwise than the sheet said.
fn same_units(old: &OpenGrading, keys: &[SheetKey], file: &str) -> Result<(), Findings> {
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
                let fault = Finding::new(format!("problems.{}.questions.{}", new.id, was.part), what);
                faults.push(fault.in_file(file).hint("give the part its old unit back"));
            }
        }
    }
    faults.into_result(())
}

fn read(keys: &KeyTable, folder: &Path) -> Result<Grading, Findings> {
    let mut found = Grading::new(keys);
    graded::each_row(&folder.join(names::ANSWERS), &mut |row| found.take(keys, row))?;
    let path = folder.join(names::GRADEBOOK);
    let bytes = files::read(&path)?;
    found.book(keys, bytes.as_slice()).map_err(|fault| fault.in_file(path.display().to_string()))?;
    Ok(found)
}

/// What is odd about the submissions.
fn notes(old: &OpenGrading, made: &StagedGrading) -> Vec<String> {
    let (was, is) = (&old.grading, &made.grading);
    let mut notes = Vec::new();
    let hashes = was.submissions_sha256.as_ref().zip(is.submissions_sha256.as_ref());
    let file = &is.submissions;
    let differs = match (was.submissions_bytes, is.submissions_bytes) {
        (then, now) if then != now => format!("{file} has {now} bytes, the old grading was made from {then}"),
        _ if hashes.is_some_and(|(a, b)| a != b) => {
            format!("{file} is as long as the file of the old grading, and another (by SHA-256)")
        }
        _ if was.cells != is.cells => format!("{} answer cells are graded now, {} then", is.cells, was.cells),
        _ => String::new(),
    };
    if !differs.is_empty() {
        notes.push(format!("{differs}: changes may come from other answers too"));
    }
    if was.program != is.program {
        notes.push(format!("graded by {} then, by {} now", was.program, is.program));
    }
    notes
}
