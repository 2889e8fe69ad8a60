//! Names of files: what a set, a grading and the reports of one consist of, and which names are therefore ours to replace.
use crate::report::class::TABLES as TABLES_OF_CLASS;
use crate::set::grading::JOINED;
use crate::sheet::output::Format;
use std::collections::BTreeSet;

/// What was drawn.
pub const SET: &str = "set.json";
/// The copy of the bank beside it.
pub const BANK: &str = "bank.yaml";
/// The key for scripts.
pub const KEY: &str = "key.csv";
/// The form to fill in.
pub const FORM: &str = "submissions.csv";
/// Folder with a folder for each student.
pub const STUDENTS: &str = "students";
/// Beside the folders of the students, where sheets are put on a web server: what keeps the program that checks.
pub const WORKER: &str = "sw.js";
/// The public file of a sheet, in the student's folder.
pub const SHEET: &str = "sheet.json";
/// The page to start from, of a set and of a grading.
pub const INDEX: &str = "index.html";
/// Where the page of a set says that a gallery goes.
const GALLERY: &str = "gallery.html";
/// The files of a booklet, whatever the formats.
pub const BOOKLETS: [&str; 3] = ["booklet.html", "booklet.pdf", "booklet.tex"];
/// The key for people.
pub const KEY_TABLES: [&str; 3] = ["key-table.html", "key-table.md", "key-table.pdf"];
/// Every answer with its verdict.
pub const ANSWERS: &str = "answers.csv";
/// A row for each student.
pub const GRADEBOOK: &str = "gradebook.csv";
pub const GRADING: &str = "grading.json";
/// What a regrading changed.
pub const CHANGES: &str = "changes.csv";
/// Folder of a grading that holds copies of what it was made from: set, bank, key and course files.
pub const BASIS: &str = "basis";
/// The class report.
pub const REPORT: &str = "report.html";
/// Folder with the tables of the class report.
pub const TABLES: &str = "tables";
/// Folder with a page for each student.
pub const FEEDBACK: &str = "feedback";
/// The gradebook as Canvas imports it.
pub const CANVAS: &str = "gradebook-canvas.csv";
/// The gradebook as Moodle imports it.
pub const MOODLE: &str = "gradebook-moodle.csv";
/// Whose answers the wrong ones are.
pub const MATCHES: &str = "matches.csv";
/// What a report makes, in the folder of the grades or in one of its own.
pub const OF_REPORT: [&str; 7] = [INDEX, REPORT, TABLES, FEEDBACK, CANVAS, MOODLE, MATCHES];
/// What every grading has.
pub const OF_GRADING: [&str; 6] =
    [ANSWERS, GRADEBOOK, GRADING, "basis/set.json", "basis/bank.yaml", "basis/key.csv"];

/// Does `generate` write this beside the folder of the students?
pub fn is_of_set(name: &str) -> bool {
    [BANK, KEY, SET, FORM, INDEX, GALLERY]
        .iter()
        .chain(&BOOKLETS)
        .chain(&KEY_TABLES)
        .any(|ours| *ours == name)
}

/// Does this lie beside the folders of the students, where sheets are put on a web server? A program may be that of an earlier version.
pub fn is_of_site(name: &str) -> bool {
    name == WORKER || name.starts_with("check") && name.ends_with(".wasm.gz")
}

/// Is this a file that a student gets? Sheets in any format, and the figures of a set with this many problems.
pub fn is_of_student(name: &str, problems: usize) -> bool {
    let sheet = name.strip_prefix("sheet.");
    let figure = name.strip_prefix("problem-").and_then(|n| n.strip_suffix(".svg"));
    sheet.is_some_and(|e| e == "json" || Format::ALL.iter().any(|f| f.as_str() == e))
        || figure.is_some_and(|n| (1..=problems).any(|i| i.to_string() == n))
}

/// Name of the course file number `i` (from 0) in a basis; those that a regrading laid over it are `course-2.yaml` and so on.
pub fn course(i: usize) -> String {
    if i == 0 { "course.yaml".to_owned() } else { format!("course-{}.yaml", i + 1) }
}

/// Does a grading hold this (a file, or `folder/`) beside its reports?
pub fn is_of_grading(name: &str, courses: usize) -> bool {
    OF_GRADING.contains(&name)
        || [CHANGES, JOINED].contains(&name)
        || name.strip_prefix(BASIS).is_some_and(|below| {
            below == "/" || (0..courses).any(|i| below.strip_prefix('/') == Some(&course(i)))
        })
}

/// Does a report make this (a file, or `folder/`) for students whose files have these names?
pub fn is_of_report(name: &str, students: &BTreeSet<String>) -> bool {
    match name.split_once('/') {
        None => OF_REPORT.contains(&name) && ![TABLES, FEEDBACK].contains(&name),
        Some((TABLES | FEEDBACK, "")) => true,
        Some((TABLES, file)) => {
            file.strip_suffix(".csv").is_some_and(|t| TABLES_OF_CLASS.split(' ').any(|table| table == t))
        }
        Some((FEEDBACK, file)) => {
            let student = file.strip_suffix(".html").or_else(|| file.strip_suffix(".md"));
            student.is_some_and(|s| students.contains(s))
        }
        Some(_) => false,
    }
}
