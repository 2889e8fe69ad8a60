//! Pages to start from: `index.html` of a set and of a grading, for the instructor, with links to what lies beside them.
use crate::finding::Finding;
use crate::folder::deal::Plan;
use crate::folder::names;
use crate::sheet::document::Head;
use crate::sheet::output::Format;
use crate::sheet::texts::Texts;
use crate::template::View;
use serde_json::{Value, json};

/// An address of a file in a folder whose name may hold anything.
fn address(folder: &str, name: &str) -> String {
    let mut out = format!("{folder}/");
    for byte in name.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => {
                out.push(char::from(byte));
            }
            byte => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

/// The page of a set: its booklets and key tables have these names, its sheets these heads and folders. Errors: faults of the
/// template.
pub fn of_set<'s>(
    plan: &Plan,
    students: impl Iterator<Item = (&'s Head, String)>,
    made: &[&str],
) -> Result<Vec<u8>, Finding> {
    let known = [
        ("booklet", &names::BOOKLETS[..]),
        ("key_table", &names::KEY_TABLES[..]),
        ("key", &[names::KEY]),
        ("form", &[names::FORM]),
        ("bank", &[names::BANK]),
    ];
    let always = [names::KEY, names::FORM, names::BANK];
    let files = known.iter().flat_map(|(what, files)| files.iter().map(|file| (*what, *file)));
    let files = files.filter(|(_, file)| made.contains(file) || always.contains(file));
    let people = students.map(|(head, folder)| {
        let page = |format: &Format| {
            let what = format!("sheet.{}", format.as_str());
            json!({"href": address(names::STUDENTS, &format!("{folder}/{what}")), "what": what})
        };
        let pages: Vec<Value> = plan.formats.iter().rev().map(page).collect();
        json!({"id": head.student, "name": head.name, "pages": pages})
    });
    let about = if plan.has_program() { "site" } else { "about" };
    page(plan.texts, ("set", about), plan.name, files, people)
}

/// The page of the reports: students with the names of their files; beside it lie the grades, or not. Errors: faults of the
/// template.
pub fn of_grades<'s>(
    texts: &Texts,
    set: &str,
    beside: bool,
    students: impl Iterator<Item = (&'s str, &'s str, &'s str)>,
) -> Result<Vec<u8>, Finding> {
    let files = [
        ("report", names::REPORT),
        ("gradebook", names::GRADEBOOK),
        ("canvas", names::CANVAS),
        ("moodle", names::MOODLE),
        ("answers", names::ANSWERS),
        ("matches", names::MATCHES),
    ];
    let here = files.into_iter().filter(|(_, file)| beside || names::OF_REPORT.contains(file));
    let what = texts.words.get("index.grades.feedback");
    let people = students.map(|(id, name, folder)| {
        let href = address(names::FEEDBACK, &format!("{folder}.html"));
        json!({"id": id, "name": name, "pages": [{"href": href, "what": what}]})
    });
    page(texts, ("grades", "about"), set, here, people)
}

/// The page of a kind, with files, each with the phrase that tells of it, and with students, each with the pages of their own.
fn page<'p>(
    texts: &Texts,
    (kind, about): (&str, &str),
    set: &str,
    files: impl Iterator<Item = (&'p str, &'p str)>,
    people: impl Iterator<Item = Value>,
) -> Result<Vec<u8>, Finding> {
    let words = &texts.words;
    let told = |text: &str| words.get(&format!("index.{kind}.{text}"));
    // Something to look at: its address from the page, and what it is.
    let link = |(what, file): (&str, &str)| json!({"href": file, "what": told(what)});
    let mut view = View::new();
    view.text("language", words.language());
    view.foreign("title", &words.say(&format!("index.{kind}.title"), &[("set", set)]));
    view.text("about", told(about));
    // Only a set is looked through; where nothing is told, there is nothing.
    view.text("gallery", if words.has(&format!("index.{kind}.gallery")) { told("gallery") } else { "" });
    for text in ["first", "students"] {
        view.text(text, told(text));
    }
    for text in ["student", "name"] {
        view.text(text, words.get(&format!("index.{text}")));
    }
    let (entries, people): (Vec<Value>, Vec<Value>) = (files.map(link).collect(), people.collect());
    view.fields(&json!({"entries": entries, "people": people}));
    texts.templates.made("index.html", &view)
}
