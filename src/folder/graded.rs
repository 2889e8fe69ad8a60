//! A folder of grades, opened: its set, its bank, the settings of its course, and the key solved anew from what was printed.
use crate::bank::{self, Bank, load};
use crate::finding::{Finding, Findings};
use crate::folder::{files, names, set};
use crate::grade::row::{AnswerReader, AnswerRow};
use crate::inspect::sentences;
use crate::key::SheetKey;
use crate::policy::{Counts, Policy};
use crate::set::dealer::Dealt;
use crate::set::given::{GivenFault, LostWhy};
use crate::set::grading::StoredGrading;
use crate::set::store::StoredSet;
use crate::set::{given, key_file};
use std::fs::File;
use std::path::{Path, PathBuf};

pub struct OpenGrading {
    pub folder: PathBuf,
    /// The set, as it was drawn.
    pub set: StoredSet,
    /// The bank by which it was graded.
    pub bank: Bank,
    /// Settings of the bank with those of the course over them.
    pub policy: Policy,
    /// Variants and keys in the order of the set; with `only`, of that student alone.
    pub given: Vec<Dealt>,
    /// grading.json.
    pub grading: StoredGrading,
}

/// Opens a grading and solves its key anew, that of one student (an id) if only that is needed. Errors: the folder is no grading,
/// or its parts do not fit each other.
pub fn open(folder: &Path, only: Option<&str>) -> Result<OpenGrading, Findings> {
    if !folder.is_dir() {
        let is = if folder.exists() { "is a file; a grading is a folder" } else { "there is no such folder" };
        let fault = Finding::of_file(folder, is);
        return Err(fault.hint("give the folder that `slipstick grade` made").into());
    }
    has_all(folder)?;
    let basis = folder.join(names::BASIS);
    let (mut set, bank) = set::with_bank(&basis)?;
    let bank_path = basis.join(&set.bank.file).display().to_string();
    let path = folder.join(names::GRADING);
    let file = path.display().to_string();
    let grading = StoredGrading::parse(&files::read_text(&path)?).map_err(|f| f.in_file(&file))?;
    intact(folder, &grading)?;
    if grading.bank_sha256 != bank.hash {
        let fault = Finding::new("", "is not the bank by which this was graded: its SHA-256 is another");
        return Err(fault.in_file(bank_path).hint("put the original copy back, or grade again").into());
    }
    let courses = read_courses(&courses(folder))?;
    let policy = policy(&bank.grading, &courses, counts_said(&grading))?;
    if let Some(only) = only {
        set.students.retain(|s| s.student == only);
    }
    let mut given = match grading.replayed {
        true => given::all(&bank, &set).map_err(|faults| findings(&bank, faults, &bank_path))?,
        false => given::all_as_stored(&bank, &set)?,
    };
    let mut keys: Vec<SheetKey> = given.iter().map(|g| g.key.clone()).collect();
    let key_path = basis.join(names::KEY);
    let stored = files::read(&key_path)?;
    let file = key_path.display().to_string();
    let faults = match grading.replayed {
        true => key_file::compare(&stored, &keys),
        // What was graded by is the stored key; its hash stands in the grading.
        false => {
            let sealed = load::hash(&String::from_utf8_lossy(&stored)) == grading.key_sha256;
            let faults = key_file::put_stored(&stored, &mut keys, sealed).err().unwrap_or_default();
            for (given, key) in given.iter_mut().zip(keys) {
                given.key = key;
            }
            faults
        }
    };
    faults.in_file(&file).into_result(())?;
    Ok(OpenGrading { folder: folder.to_owned(), set, bank, policy, given, grading })
}

/// Are the files there that every grading has? Errors: a finding that names those that are missing.
fn has_all(folder: &Path) -> Result<(), Finding> {
    let missing: Vec<&str> =
        names::OF_GRADING.into_iter().filter(|name| !folder.join(name).is_file()).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let fault = Finding::of_file(folder, format!("holds no {}", missing.join(", ")));
    Err(fault.hint("give the folder that `slipstick grade` made; if an earlier version did, grade again"))
}

/// Are the marks those that were written? Large gradings are not hashed. Errors: a finding for each file that was cut short or
/// edited.
fn intact(folder: &Path, grading: &StoredGrading) -> Result<(), Findings> {
    let mut faults = Findings::default();
    for (name, told) in
        [(names::ANSWERS, &grading.answers_sha256), (names::GRADEBOOK, &grading.gradebook_sha256)]
    {
        let Some(told) = told else { continue };
        let path = folder.join(name);
        match hash(&path) {
            Ok(found) if found == *told => {}
            Ok(_) => {
                let what = "is not as `slipstick grade` wrote it: its SHA-256 is another";
                let hint = "put the original back, or grade again; marks are changed by a course file";
                faults.push(Finding::of_file(&path, what).hint(hint));
            }
            Err(fault) => faults.push(fault),
        }
    }
    faults.into_result(())
}

/// SHA-256 of a file, hex. Errors: it cannot be read.
pub fn hash(path: &Path) -> Result<String, Finding> {
    let hashed = File::open(path).and_then(load::hash_of);
    hashed.map_err(files::trouble(path, "cannot be read"))
}

impl OpenGrading {
    /// Walks over the rows of answers.csv. Errors: it cannot be read.
    pub fn each_row(&self, see: &mut dyn FnMut(AnswerRow)) -> Result<(), Findings> {
        each_row(&self.folder.join(names::ANSWERS), see)
    }
}

/// Walks over the rows of a file of answers. Errors: it cannot be read.
pub fn each_row(path: &Path, see: &mut dyn FnMut(AnswerRow)) -> Result<(), Findings> {
    let here = |fault: Finding| fault.in_file(path.display().to_string());
    let file = File::open(path).map_err(files::trouble(path, "cannot be read"))?;
    let mut reader = AnswerReader::new(file).map_err(here)?;
    while let Some(row) = reader.next_row().map_err(here)? {
        see(row);
    }
    Ok(())
}

/// Students listed one by one before the rest is only counted.
const LISTED: usize = 20;

/// What stands in the way of a key, in words.
pub fn findings(bank: &Bank, faults: Vec<GivenFault>, file: &str) -> Findings {
    let mut found = Findings::default();
    let mut lost = 0;
    for fault in faults {
        let fault = match fault {
            GivenFault::Misfit(finding) => {
                found.push(finding);
                continue;
            }
            GivenFault::Lost(fault) => fault,
        };
        lost += 1;
        let Some(problem) = bank.problems.get(fault.problem).filter(|_| lost <= LISTED) else { continue };
        let text = match &fault.why {
            LostWhy::Refused(refusal) => problem.cases.get(fault.case).map_or_else(String::new, |case| {
                sentences::refusal(problem, &case.scene, refusal).join("; ")
            }),
            LostWhy::Happens(what) => format!("another motion than the problem tells of: {what}"),
            LostWhy::Relation(part) => {
                format!("the relation of `follows` does not give {part} from the other parts")
            }
            LostWhy::Unanswered(part) => format!("part {part} has no answer"),
        };
        let text = format!("with the data of {}: {text}", fault.student);
        found.push(Finding::new(format!("problems.{}", problem.id), text));
    }
    if lost > LISTED {
        found.push(Finding::new("", format!("and the data of {} more students", lost - LISTED)));
    }
    found.in_file(file)
}

/// The course files of a grading, in the order in which they were laid over each other.
pub fn courses(graded: &Path) -> Vec<PathBuf> {
    let files = (0..).map(|i| graded.join(names::BASIS).join(names::course(i)));
    files.take_while(|path| path.is_file()).collect()
}

/// Course files: name and text. Errors: one cannot be read.
pub fn read_courses(paths: &[PathBuf]) -> Result<Vec<(String, String)>, Findings> {
    let read = |path: &PathBuf| Ok((path.display().to_string(), files::read_text(path)?));
    paths.iter().map(read).collect()
}

/// The settings that bear on marks: those of the bank, over them those of courses (name and text of each file), over them
/// what the command says. Errors: all that is wrong with the course file.
pub fn policy(
    bank: &Policy,
    courses: &[(String, String)],
    counts: Option<Counts>,
) -> Result<Policy, Findings> {
    let mut policy = bank.clone();
    for (file, text) in courses {
        policy = bank::course::course(text, file, &policy)?;
    }
    if let Some(counts) = counts {
        policy.attempts.counts = counts;
    }
    Ok(policy)
}

/// Which attempt counts, if the command said so when it was graded.
pub fn counts_said(grading: &StoredGrading) -> Option<Counts> {
    grading.attempts.as_deref().and_then(Counts::of_word)
}
