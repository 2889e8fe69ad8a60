//! Moodle XML: a category for each problem with a cloze question for each variant, or a category and a question for each part.
use crate::export::item::{Item, spellings};
use crate::export::{Export, Fragment, QuestionLayout, part_view};
use crate::finding::Finding;
use crate::key::{Answer, KeyEntry};
use crate::set::key_file::shortest;
use crate::words::Words;
use base64::prelude::{BASE64_STANDARD, Engine as _};
use serde_json::{Value, json};

/// Longest name and longest id number that Moodle keeps.
const LONGEST: (usize, usize) = (255, 100);

/// A text in which Moodle finds no field of a cloze question.
fn without_fields(xhtml: &str) -> String {
    xhtml.replace('{', "&#123;").replace('}', "&#125;")
}

/// A text within a field of a cloze question: what has a meaning there stands behind a backslash.
fn in_field(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if matches!(c, '}' | '~' | '#' | '\\' | '/' | '"') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// Points as weights, which are whole numbers in a cloze question: the points times the least factor that makes them whole.
pub fn weights(points: &[f64]) -> Vec<u64> {
    const MOST: u32 = 1000;
    let whole = |by: u32| points.iter().all(|p| (p * f64::from(by)).fract().abs() < 1e-9);
    let by = f64::from((1..=MOST).find(|by| whole(*by)).unwrap_or(MOST));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "points are from 0 to 1000")]
    points.iter().map(|p| (p * by).round() as u64).collect()
}

/// The field of a part in a cloze question.
fn field(part: &KeyEntry, weight: u64, words: &Words) -> String {
    match &part.answer {
        Answer::Number { value, half_width, .. } => {
            let [value, tolerance] = [*value, *half_width].map(|si| shortest(part.unit.from_si(si)));
            format!("{{{weight}:NUMERICAL:={value}:{tolerance}}}")
        }
        Answer::Word { right, .. } => {
            let all = spellings(right, words).into_iter().map(|word| format!("={}", in_field(word)));
            let all: Vec<String> = all.collect();
            format!("{{{weight}:SHORTANSWER:{}}}", all.join("~"))
        }
    }
}

fn address(file: &str) -> String {
    format!("@@PLUGINFILE@@/{file}")
}

/// A text in a question: its element, XHTML as a section of character data, and the pictures that it shows.
fn text(item: &Item, name: &str, xhtml: &str) -> Value {
    let shown = item.pictures.iter().filter(|p| xhtml.contains(&address(&p.file)));
    let files = shown.map(|p| json!({"name": p.file, "bytes": BASE64_STANDARD.encode(&p.svg)}));
    let data = xhtml.replace("]]>", "]]]]><![CDATA[>");
    json!({"name": name, "data": data, "files": files.collect::<Vec<_>>()})
}

/// The questions of an item. Errors: faults of the template.
pub fn fragment(export: &Export, item: &Item) -> Result<Fragment, Finding> {
    let solution = without_fields(&item.solution(&address).unwrap_or_default());
    // A question of all parts, or of one of them.
    let made = |kind: &str, name: &str, xhtml: &str, part: Option<Value>| {
        let texts = [text(item, "questiontext", xhtml), text(item, "generalfeedback", &solution)];
        let question = json!({"kind": kind, "name": name, "texts": texts, "part": part});
        export.made("moodle-question.xml", &question)
    };
    let of_part = |(i, part): (usize, &KeyEntry)| {
        let kind = if matches!(part.answer, Answer::Number { .. }) { "numerical" } else { "shortanswer" };
        let xhtml = item.text(Some(i), &mut |_| String::new(), &address);
        made(kind, &format!("{} {}", item.code, part.part), &xhtml, Some(part_view(part, item.words)))
    };
    let questions = match export.layout {
        QuestionLayout::Whole => vec![made("cloze", item.code, &cloze(item), None)?],
        _ => item.parts.iter().enumerate().map(of_part).collect::<Result<_, _>>()?,
    };
    Ok(Fragment { problem: item.problem, code: item.code.to_owned(), questions, files: Vec::new() })
}

/// The text of all parts, with a field for each.
fn cloze(item: &Item) -> String {
    let weights = weights(&item.parts.iter().map(|p| p.points).collect::<Vec<_>>());
    // A mark that no text holds, so that the fields alone keep their braces.
    let place = |i: usize| format!("\u{0}{i}\u{0}");
    let mut xhtml = without_fields(&item.text(None, &mut |i| place(i), &address));
    for (i, (part, weight)) in item.parts.iter().zip(weights).enumerate() {
        xhtml = xhtml.replace(&place(i), &field(part, weight, item.words));
    }
    xhtml
}

/// Path and id number of the category of a problem, or of a part of it. In a path a slash is written twice.
pub(crate) fn category(export: &Export, problem: usize, part: &str) -> (String, String) {
    let cut = |text: &str, most: usize| text.chars().take(most).collect::<String>();
    let name = export.name(problem);
    let names = [export.set, &name, part].into_iter().filter(|name| !name.is_empty());
    let names = names.map(|name| cut(name, LONGEST.0).replace('/', "//"));
    let path = std::iter::once("$course$/top".to_owned()).chain(names).collect::<Vec<_>>().join("/");
    let mut id = format!("{}-{}", export.id, export.problems[problem].id);
    if !part.is_empty() {
        id = format!("{id}-{part}");
    }
    (path, cut(&id, LONGEST.1))
}
