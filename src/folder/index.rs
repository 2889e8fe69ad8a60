//! Pages to start from: `index.html` of a set and of a grading, for the instructor, with links to what lies beside them.
use crate::finding::Finding;
use crate::folder::deal::Plan;
use crate::folder::names;
use crate::sheet::document::Head;
use crate::sheet::texts::Texts;
use crate::template::{self, Value, View};

/// Something to look at: its address from the page, and what it is.
struct IndexLink {
    href: String,
    what: String,
}

/// A student, with the pages of their own: address and name of each.
struct Person<'p> {
    id: &'p str,
    name: &'p str,
    pages: Vec<(String, String)>,
}

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
    let words = &plan.texts.words;
    let known = [
        ("booklet", &names::BOOKLETS[..]),
        ("key_table", &names::KEY_TABLES[..]),
        ("key", &[names::KEY]),
        ("form", &[names::FORM]),
        ("bank", &[names::BANK]),
    ];
    let always = [names::KEY, names::FORM, names::BANK];
    let mut entries = Vec::new();
    for (what, files) in known {
        for file in files.iter().filter(|f| made.contains(f) || always.contains(f)) {
            entries.push(IndexLink {
                href: (*file).to_owned(),
                what: words.get(&format!("index.set.{what}")).to_owned(),
            });
        }
    }
    let people = students.map(|(head, folder)| Person {
        id: &head.student,
        name: &head.name,
        pages: plan
            .formats
            .iter()
            .rev()
            .map(|format| {
                let file = format!("sheet.{}", format.as_str());
                (address(names::STUDENTS, &format!("{folder}/{file}")), file)
            })
            .collect(),
    });
    let about = if plan.has_program() { "index.set.site" } else { "index.set.about" };
    page(plan.texts, ("set", about), plan.name, &entries, people)
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
    let here = files.iter().filter(|(_, file)| beside || names::OF_REPORT.contains(file));
    let entries: Vec<IndexLink> = here
        .map(|(what, file)| IndexLink {
            href: (*file).to_owned(),
            what: texts.words.get(&format!("index.grades.{what}")).to_owned(),
        })
        .collect();
    let people = students.map(|(id, name, folder)| Person {
        id,
        name,
        pages: vec![(
            address(names::FEEDBACK, &format!("{folder}.html")),
            texts.words.get("index.grades.feedback").to_owned(),
        )],
    });
    page(texts, ("grades", "index.grades.about"), set, &entries, people)
}

fn page<'p>(
    texts: &Texts,
    (kind, about): (&str, &str),
    set: &str,
    entries: &[IndexLink],
    people: impl Iterator<Item = Person<'p>>,
) -> Result<Vec<u8>, Finding> {
    let words = &texts.words;
    let link = |href: &str, what: &str| {
        template::map([("href", template::finished(href)), ("what", Value::from(what))])
    };
    let people = people.map(|person| {
        let pages = person.pages.iter().map(|(href, what)| link(href, what));
        template::map([
            ("id", Value::from(person.id)),
            ("name", Value::from(person.name)),
            ("pages", template::list(pages.collect())),
        ])
    });
    let mut view = View::new();
    view.text("language", words.language());
    view.foreign("title", &words.say(&format!("index.{kind}.title"), &[("set", set)]));
    view.text("about", words.get(about));
    for text in ["first", "students"] {
        view.text(text, words.get(&format!("index.{kind}.{text}")));
    }
    // Only a set is looked through; where nothing is told, there is nothing.
    let gallery = format!("index.{kind}.gallery");
    view.text("gallery", if words.has(&gallery) { words.get(&gallery) } else { "" });
    for text in ["student", "name"] {
        view.text(text, words.get(&format!("index.{text}")));
    }
    view.value("entries", template::list(entries.iter().map(|e| link(&e.href, &e.what)).collect()));
    view.value("people", template::list(people.collect()));
    texts.templates.made("index.html", &view)
}
