//! The files of answers of a whole class at once: a folder of them, or the archive that a learning platform gives of an
//! assignment, joined to one file of submissions. What is no file of answers is named and stops nothing.
use crate::answer::roster::folded;
use crate::answer::submissions;
use crate::csv_field::{self, unguarded};
use crate::finding::Finding;
use crate::folder::{files, names};
use crate::sheet::terminal;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

/// Largest file of answers of one student, bytes: some thousand times what a page saves.
const LARGEST: u64 = 1 << 20;
/// Most files that are looked at.
const MOST: usize = 100_000;
/// Folders within folders that are looked into.
const DEEPEST: usize = 8;
/// What a file of answers has for columns.
const COLUMNS: [&str; 4] = ["student", "problem", "part", "answer"];
/// When it was saved, where the file says so.
const SAVED: &str = "saved_at";
/// Of which set the sheet is, where the file says so.
const SET: &str = "set";
/// Which file an answer is from, in what is kept.
const FILE: &str = "file";
const HINT: &str = "give what students handed in: a CSV file, or a folder or ZIP archive of the files answers-ID.csv that their pages saved";

/// Files of answers, joined.
#[derive(Debug, Default)]
pub struct JoinedFiles {
    /// One line for each answer.
    pub text: Vec<u8>,
    /// The same lines to look at: each with the file that it is from, and nothing that a spreadsheet would run.
    pub kept: Vec<u8>,
    pub files: usize,
    /// Files that are none, and why.
    pub passed_over: Vec<(String, &'static str)>,
    /// Files that are named for one student and hold answers of others: their names, and those students.
    pub of_others: Vec<(String, String)>,
    /// Students whose answers several people handed in, as far as names of files and folders tell, and these names.
    pub by_several: Vec<(String, String)>,
}

/// Files listed one by one before the rest is only counted.
const LISTED: usize = 20;

impl JoinedFiles {
    /// How many files there were, and which of them are none of answers: lines for the summary.
    pub fn told(&self) -> String {
        let mut text = format!("\n  from {}", terminal::count(self.files, "file"));
        text.push_str(&self.reasons());
        let others = self.of_others.iter();
        let others = others.map(|(name, students)| format!("look at: {name} holds answers of {students}"));
        let several = self.by_several.iter();
        let several = several.map(|(student, files)| {
            format!("look at: answers of {student} stand in files of several people: {files}")
        });
        text + &below(others) + &below(several)
    }
    /// Which files are none of answers, line by line.
    fn reasons(&self) -> String {
        below(self.passed_over.iter().map(|(name, why)| format!("passed over: {name} {why}")))
    }
}

/// The first of some lines, below a line of the summary.
fn below(lines: impl Iterator<Item = String>) -> String {
    terminal::first_of(lines, LISTED).iter().map(|line| format!("\n  {line}")).collect()
}

/// Is this more than one file of submissions?
pub fn is_many(path: &Path) -> bool {
    path.is_dir() || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("zip"))
}

/// Joins the files of answers in a folder or an archive: by the time at which each was saved, then by name, so that of two files
/// of a student the later one is the later attempt.
///
/// A file that says it is of another set is passed over. Errors: it cannot be read, or no file of answers is in it.
pub fn joined(path: &Path, set: &str) -> Result<JoinedFiles, Finding> {
    let mut found = Vec::new();
    if path.is_dir() {
        in_folder(path, "", 0, &mut found)?;
    } else {
        in_archive(path, &mut found)?;
    }
    if let Some(made) = [names::SET, names::GRADING].into_iter().find(|name| path.join(name).is_file()) {
        let what = format!("is no folder of answers: it has {made}, which slipstick made");
        let fault = Finding::of_file(path, what);
        return Err(fault.hint(HINT));
    }
    let mut all = JoinedFiles::default();
    let mut read: Vec<ReadFile> = Vec::new();
    for (name, bytes) in found {
        match bytes.and_then(|bytes| answers(&bytes, set)) {
            Ok((saved, rows)) => read.push((saved, name, rows)),
            Err(why) => all.passed_over.push((name, why)),
        }
    }
    if read.is_empty() {
        let what = format!("holds no file of answers{}", all.reasons());
        let fault = Finding::of_file(path, what);
        return Err(fault.hint(HINT));
    }
    read.sort();
    let mut joined = csv::Writer::from_writer(Vec::new());
    let no_room = |_| Finding::of_file(path, "is too large to be joined");
    joined.write_record(COLUMNS.iter().chain([&SAVED])).map_err(no_room)?;
    csv_field::push_line(&mut all.kept, COLUMNS.iter().chain([&SAVED, &FILE]));
    for (saved, name, rows) in &read {
        for row in rows {
            joined.write_record(row.iter().chain([saved])).map_err(no_room)?;
            csv_field::push_line(&mut all.kept, row.iter().chain([saved, name]));
        }
        if let Some(students) = of_others(name, rows) {
            all.of_others.push((name.clone(), students));
        }
    }
    all.by_several = by_several(&read);
    all.text = joined.into_inner().unwrap_or_default();
    all.files = read.len();
    Ok(all)
}

/// When a file of answers was saved, its name and its rows.
type ReadFile = (String, String, Vec<[String; 4]>);

/// Whose file it is, as far as its name tells: without the number that a browser gives a second file of one name.
fn owner(name: &str) -> &str {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let number = |n: &str| n.strip_suffix(')').is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()));
    stem.rsplit_once('(').filter(|(_, n)| number(n)).map_or(stem, |(stem, _)| stem).trim_end()
}

/// See [`JoinedFiles::by_several`].
fn by_several(read: &[ReadFile]) -> Vec<(String, String)> {
    let mut files: BTreeMap<String, BTreeMap<&str, &str>> = BTreeMap::new();
    for (_, name, rows) in read {
        for student in rows.iter().map(|row| row[0].trim()).filter(|student| !student.is_empty()) {
            files.entry(folded(student)).or_default().insert(owner(name), name);
        }
    }
    let several = files.into_iter().filter(|(_, files)| files.len() > 1);
    let names = |files: BTreeMap<&str, &str>| files.into_values().collect::<Vec<_>>().join(", ");
    several.map(|(student, files)| (student, names(files))).collect()
}

/// The students whose answers a file holds that is named for another one, `answers-ID.csv`.
fn of_others(name: &str, rows: &[[String; 4]]) -> Option<String> {
    let file = name.rsplit(['/', '\\']).next()?;
    let id = file.strip_prefix("answers-")?.rsplit_once('.')?.0;
    // A browser numbers the files of one name: `answers-0017 (1).csv`.
    let id = id.split_once(" (").map_or(id, |(id, _)| id);
    let mut others: Vec<&str> = rows
        .iter()
        .map(|row| row[0].trim())
        .filter(|s| !s.is_empty() && !s.eq_ignore_ascii_case(id))
        .collect();
    others.sort_unstable();
    others.dedup();
    (!others.is_empty()).then(|| others.join(", "))
}

type FoundFiles = Vec<(String, Result<Vec<u8>, &'static str>)>;

/// Bytes of a file that may be one of answers.
fn bytes(mut source: impl Read) -> Result<Vec<u8>, &'static str> {
    let mut bytes = Vec::new();
    let taken = source.by_ref().take(LARGEST + 1).read_to_end(&mut bytes);
    taken.map_err(|_| "cannot be read")?;
    if bytes.len() as u64 > LARGEST { Err("is larger than any page saves") } else { Ok(bytes) }
}

/// Files that a system leaves beside others, and that nobody has handed in.
fn is_hidden(name: &str) -> bool {
    let is = |part: &str| part.starts_with('.') && !matches!(part, "." | "..") || part == "__MACOSX";
    name.split(['/', '\\']).any(is)
}

fn is_csv(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"))
}

/// What is said of a file of another kind.
fn no_csv(name: &str) -> &'static str {
    match is_many(Path::new(name)) {
        true => "is an archive itself: unpack it",
        false => "is no CSV file",
    }
}

fn in_folder(folder: &Path, prefix: &str, depth: usize, found: &mut FoundFiles) -> Result<(), Finding> {
    for name in files::names_in(folder) {
        let (path, name) = (folder.join(&name), format!("{prefix}{name}"));
        if is_hidden(&name) {
            continue;
        }
        if found.len() >= MOST {
            return Err(Finding::of_file(folder, "holds too many files"));
        }
        if path.is_dir() {
            if depth < DEEPEST {
                in_folder(&path, &format!("{name}/"), depth + 1, found)?;
            }
        } else if is_csv(&name) {
            found.push((name, File::open(&path).map_err(|_| "cannot be read").and_then(bytes)));
        } else {
            let why = no_csv(&name);
            found.push((name, Err(why)));
        }
    }
    Ok(())
}

fn in_archive(path: &Path, found: &mut FoundFiles) -> Result<(), Finding> {
    let file = File::open(path).map_err(files::trouble(path, "cannot be read"))?;
    let no_archive = |_| Finding::of_file(path, "is no ZIP archive");
    let mut archive = zip::ZipArchive::new(std::io::BufReader::new(file)).map_err(no_archive)?;
    if archive.len() > MOST {
        return Err(Finding::of_file(path, "holds too many files"));
    }
    for i in 0..archive.len() {
        let Ok(entry) = archive.by_index(i) else {
            found.push((format!("file {} of the archive", i + 1), Err("cannot be unpacked")));
            continue;
        };
        let name = String::from_utf8_lossy(entry.name_raw()).into_owned();
        if entry.is_dir() || is_hidden(&name) {
            continue;
        }
        let bytes = if is_csv(&name) { bytes(entry) } else { Err(no_csv(&name)) };
        found.push((name, bytes));
    }
    Ok(())
}

/// When a file of answers was saved, as far as it says, and its answers.
fn answers(bytes: &[u8], set: &str) -> Result<(String, Vec<[String; 4]>), &'static str> {
    const NO_CSV: &str = "cannot be read as CSV";
    let (head, records) =
        submissions::all_records(Box::new(Cursor::new(bytes.to_vec()))).map_err(|_| NO_CSV)?;
    let head = head.map_or_else(Vec::new, |head| head.fields);
    let column = |name: &str| head.iter().position(|h| h.trim().eq_ignore_ascii_case(name));
    let [Some(student), Some(problem), Some(part), Some(answer)] = COLUMNS.map(column) else {
        return Err("lacks the columns student, problem, part, answer");
    };
    let (mut saved, mut rows) = (String::new(), Vec::new());
    for (_, record) in records {
        let field = |i: usize| unguarded(record.get(i).map_or("", String::as_str)).to_owned();
        if let Some(at) = column(SAVED).and_then(|i| record.get(i)) {
            saved = saved.max(at.trim().to_owned());
        }
        let of_set = column(SET).map(|i| field(i).trim().to_owned()).unwrap_or_default();
        if !of_set.is_empty() && of_set != set {
            return Err("was saved from a sheet of another set");
        }
        rows.push([student, problem, part, answer].map(field));
    }
    Ok((saved, rows))
}
