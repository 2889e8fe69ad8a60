//! A folder of grades, opened: its set, its bank, the settings of its course, and the key solved anew from what was printed.
use crate::bank::Bank;
use crate::bank::load;
use crate::cli::args::Attempts;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::generate;
use crate::cli::grade;
use crate::cli::grade::ANSWERS;
use crate::cli::grade::GRADEBOOK;
use crate::cli::grade::GRADING;
use crate::cli::words;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::key::SheetKey;
use crate::policy::Policy;
use crate::regrade::rows::Fault;
use crate::regrade::rows::Row;
use crate::regrade::rows::Rows;
use crate::set::given;
use crate::set::given::Given;
use crate::set::given::Why;
use crate::set::grading::BASIS;
use crate::set::grading::Grading;
use crate::set::key_file;
use crate::set::store::StoredSet;
use crate::units::spell;
use std::fs::File;
use std::path::Path;
use std::path::PathBuf;

/// What a regrading changed.
pub const CHANGES: &str = "changes.csv";

/// A grading.
pub struct Graded {
    /// Its folder.
    pub folder: PathBuf,
    /// The set, as it was drawn.
    pub set: StoredSet,
    /// The bank by which it was graded.
    pub bank: Bank,
    /// Settings of the bank with those of the course over them.
    pub policy: Policy,
    /// Variants and keys in the order of the set; with `only`, of that student alone.
    pub given: Vec<Given>,
    /// grading.json.
    pub grading: Grading,
}

/// Opens a grading and solves its key anew, that of one student (an id) if only that is needed.
///
/// # Errors
/// The folder is no grading, or its parts do not fit each other.
pub fn open(folder: &Path, only: Option<&str>) -> Result<Graded, Findings> {
    let name = folder.display().to_string();
    if !folder.is_dir() {
        let what =
            if folder.exists() { "is a file; a grading is a folder" } else { "there is no such folder" };
        let fault = Finding::new("", what).in_file(name);
        return Err(fault.hint("give the folder that `slipstick grade` made").into());
    }
    has_all(folder)?;
    let basis = folder.join(BASIS);
    let mut set = generate::existing(&basis)?;
    let bank_path = basis.join("bank.yaml").display().to_string();
    let bank = banks::parse(&files::read_text(&basis.join("bank.yaml"))?, &bank_path)?;
    let path = folder.join(GRADING);
    let file = path.display().to_string();
    let grading = Grading::parse(&files::read_text(&path)?).map_err(|f| f.in_file(&file))?;
    intact(folder, &grading)?;
    if grading.bank_sha256 != bank.hash {
        let fault = Finding::new("", "is not the bank by which this was graded: its SHA-256 is another");
        return Err(fault.in_file(bank_path).hint("put the original copy back, or grade again").into());
    }
    let courses = grade::read_courses(&grade::courses(folder))?;
    let policy = grade::policy(&bank.grading, &courses, attempts(grading.attempts.as_deref()))?;
    if let Some(only) = only {
        set.students.retain(|s| s.student == only);
    }
    let mut given = match grading.replayed {
        true => given::all(&bank, &set).map_err(|faults| findings(&bank, faults, &bank_path))?,
        false => given::all_as_stored(&bank, &set)?,
    };
    let mut keys: Vec<SheetKey> = given.iter().map(|g| g.key.clone()).collect();
    let key_path = basis.join("key.csv");
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
    let faults: Findings = faults.in_file(&file);
    if !faults.is_empty() {
        return Err(faults);
    }
    Ok(Graded { folder: folder.to_owned(), set, bank, policy, given, grading })
}

/// Are the files there that every grading has?
///
/// # Errors
/// A finding that names those that are missing.
pub fn has_all(folder: &Path) -> Result<(), Finding> {
    let all = [ANSWERS, GRADEBOOK, GRADING, "basis/set.json", "basis/bank.yaml", "basis/key.csv"];
    let missing: Vec<&str> = all.into_iter().filter(|name| !folder.join(name).is_file()).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let fault = Finding::new("", format!("holds no {}", missing.join(", ")));
    Err(fault
        .in_file(folder.display().to_string())
        .hint("give the folder that `slipstick grade` made; if an earlier version did, grade again"))
}

/// Are the marks those that were written? Large gradings are not hashed.
///
/// # Errors
/// A finding for each file that was cut short or edited.
pub fn intact(folder: &Path, grading: &Grading) -> Result<(), Findings> {
    let mut faults = Findings::default();
    for (name, told) in [(ANSWERS, &grading.answers_sha256), (GRADEBOOK, &grading.gradebook_sha256)] {
        let Some(told) = told else { continue };
        let path = folder.join(name);
        match hash(&path) {
            Ok(found) if found == *told => {}
            Ok(_) => faults.push(
                Finding::new("", "is not as `slipstick grade` wrote it: its SHA-256 is another")
                    .in_file(path.display().to_string())
                    .hint("put the original back, or grade again; marks are changed by a course file"),
            ),
            Err(fault) => faults.push(fault),
        }
    }
    faults.into_result(())
}

/// SHA-256 of a file, hex.
///
/// # Errors
/// It cannot be read.
pub fn hash(path: &Path) -> Result<String, Finding> {
    let hashed = File::open(path).and_then(load::hash_of);
    hashed.map_err(|e| files::trouble(path, "cannot be read", &e))
}

/// What the command said about attempts.
pub fn attempts(said: Option<&str>) -> Option<Attempts> {
    match said? {
        "best" => Some(Attempts::Best),
        "first" => Some(Attempts::First),
        "last" => Some(Attempts::Last),
        _ => None,
    }
}

impl Graded {
    /// Walks over the rows of answers.csv.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn each_row(&self, see: &mut dyn FnMut(Row)) -> Result<(), Findings> {
        each_row(&self.folder.join(ANSWERS), see)
    }
}

/// Walks over the rows of a file of answers.
///
/// # Errors
/// It cannot be read.
pub fn each_row(path: &Path, see: &mut dyn FnMut(Row)) -> Result<(), Findings> {
    let in_words = |fault: Fault| {
        let found = Finding::new("", fault.what).at(usize::try_from(fault.line).unwrap_or(0).max(1), 1);
        found.in_file(path.display().to_string())
    };
    let file = File::open(path).map_err(|e| files::trouble(path, "cannot be read", &e))?;
    for row in Rows::new(file).map_err(in_words)? {
        see(row.map_err(in_words)?);
    }
    Ok(())
}

/// Students listed one by one before the rest is only counted.
const LISTED: usize = 20;

/// What stands in the way of a key, in words.
pub fn findings(bank: &Bank, faults: Vec<given::Fault>, file: &str) -> Findings {
    let mut found = Findings::default();
    let (mut lost, mut more) = (0usize, 0usize);
    for fault in faults {
        match fault {
            given::Fault::Misfit(finding) => found.push(finding.in_file(file)),
            given::Fault::Lost(fault) => {
                lost += 1;
                if lost > LISTED {
                    more += 1;
                    continue;
                }
                let Some(problem) = bank.problems.get(fault.problem) else { continue };
                let texts = match &fault.why {
                    Why::Refused(refusal) => problem
                        .cases
                        .get(fault.case)
                        .map_or_else(Vec::new, |case| words::refusal(problem, &case.scene, refusal)),
                    Why::Happens(what) => vec![format!("another motion than the problem tells of: {what}")],
                    Why::Relation(part) => {
                        vec![format!("the relation of `follows` does not give {part} from the other parts")]
                    }
                    Why::Unanswered(part) => vec![format!("part {part} has no answer")],
                };
                let field = format!("problems.{}", problem.id);
                let text = format!("with the data of {}: {}", fault.student, texts.join("; "));
                found.push(Finding::new(field, text).in_file(file));
            }
        }
    }
    if more > 0 {
        found.push(Finding::new("", format!("and the data of {more} more students")).in_file(file));
    }
    found
}

/// Without blanks, case and leading zeros.
fn loose(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
    text.trim_start_matches('0').to_owned()
}

/// The student that is meant: by id, by an id that is alike but for blanks, case and zeros in front, or by name.
///
/// # Errors
/// Nobody, or several.
pub fn student(set: &StoredSet, typed: &str) -> Result<usize, Finding> {
    let students = &set.students;
    if let Some(i) = students.iter().position(|s| s.student == typed) {
        return Ok(i);
    }
    let alike: Vec<usize> = (0..students.len())
        .filter(|i| {
            let (id, name) = (&students[*i].student, &students[*i].name);
            loose(id) == loose(typed) || (!name.is_empty() && loose(name) == loose(typed))
        })
        .collect();
    let fault = Finding::new("", format!("`{typed}` is no student of this set"));
    match alike[..] {
        [one] => Ok(one),
        [] => {
            let known = || students.iter().map(|s| s.student.as_str());
            Err(match spell::closest(typed, known()) {
                Some(near) => fault.hint(format!("did you mean `{near}`?")),
                None => {
                    let some: Vec<&str> = known().take(5).collect();
                    let rest = if students.len() > 5 { ", ..." } else { "" };
                    fault.hint(format!("its students: {}{rest}", some.join(", ")))
                }
            })
        }
        _ => {
            let ids: Vec<&str> = alike.iter().map(|i| students[*i].student.as_str()).collect();
            Err(fault.hint(format!("write the id exactly: {}", ids.join(", "))))
        }
    }
}

/// The problem that is meant, by number or id, and the part of it if one is named behind a point (`1.omega`).
///
/// # Errors
/// There is none.
pub fn problem(set: &StoredSet, typed: &str) -> Result<(usize, Option<String>), Finding> {
    let find = |text: &str| {
        let number = text.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
        set.problems
            .iter()
            .position(|p| p.eq_ignore_ascii_case(text))
            .or(number.filter(|n| *n < set.problems.len()))
    };
    let text = typed.trim();
    if let Some(found) = find(text) {
        return Ok((found, None));
    }
    if let Some((problem, part)) = text.split_once('.')
        && let Some(found) = find(problem)
    {
        return Ok((found, Some(part.to_owned())));
    }
    let known: Vec<String> =
        set.problems.iter().enumerate().map(|(i, p)| format!("{} ({p})", i + 1)).collect();
    let fault = Finding::new("", format!("the set has no problem `{typed}`"));
    Err(match spell::closest(text, set.problems.iter().map(String::as_str)) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint(format!("its problems: {}", known.join(", "))),
    })
}
