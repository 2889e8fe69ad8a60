//! Moodle XML: a category for each problem with a cloze question for each variant, or a category and a question for each part.
use crate::export::item::{Item, ItemPart, ItemPicture, Right};
use crate::export::{Export, Fragment, PartView, Pool, QuestionLayout};
use crate::finding::Finding;
use crate::set::key_file::shortest;
use base64::prelude::{BASE64_STANDARD, Engine as _};
use serde::Serialize;

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
fn field(part: &ItemPart, weight: u64) -> String {
    match &part.right {
        Right::Number { value, tolerance, .. } => {
            format!("{{{weight}:NUMERICAL:={}:{}}}", shortest(*value), shortest(*tolerance))
        }
        Right::Word { spellings, .. } => {
            let all: Vec<String> = spellings.iter().map(|word| format!("={}", in_field(word))).collect();
            format!("{{{weight}:SHORTANSWER:{}}}", all.join("~"))
        }
    }
}

fn address(file: &str) -> String {
    format!("@@PLUGINFILE@@/{file}")
}

/// A text in a question: its element, XHTML as a section of character data, and the pictures that it shows.
#[derive(Serialize)]
struct QuestionText<'i> {
    name: &'static str,
    data: String,
    files: Vec<PictureFile<'i>>,
}

#[derive(Serialize)]
struct PictureFile<'i> {
    name: &'i str,
    bytes: String,
}

/// A question: all parts, or one of them.
#[derive(Serialize)]
struct Question<'i> {
    kind: &'static str,
    name: String,
    texts: [QuestionText<'i>; 2],
    part: Option<PartView<'i>>,
}

impl<'i> QuestionText<'i> {
    fn new(item: &'i Item, name: &'static str, xhtml: &str) -> Self {
        let shown = item.pictures.iter().filter(|p| xhtml.contains(&address(&p.file)));
        let file = |p: &'i ItemPicture| PictureFile { name: &p.file, bytes: BASE64_STANDARD.encode(&p.svg) };
        Self { name, data: xhtml.replace("]]>", "]]]]><![CDATA[>"), files: shown.map(file).collect() }
    }
}

/// The questions of an item. Errors: faults of the template.
pub fn fragment(export: &Export, item: &Item) -> Result<Fragment, Finding> {
    let solution = without_fields(&item.solution(&address).unwrap_or_default());
    let made = |kind: &'static str, name: String, xhtml: String, part: Option<PartView>| {
        let texts = [("questiontext", &xhtml), ("generalfeedback", &solution)];
        let texts = texts.map(|(name, xhtml)| QuestionText::new(item, name, xhtml));
        export.made("moodle-question.xml", &Question { kind, name, texts, part })
    };
    let of_part = |(i, part): (usize, &ItemPart)| {
        let view = PartView::new(part);
        let kind = if view.is_number { "numerical" } else { "shortanswer" };
        let xhtml = item.text(Some(i), &mut |_| String::new(), &address);
        made(kind, format!("{} {}", item.code, part.id), xhtml, Some(view))
    };
    let questions = match export.layout {
        QuestionLayout::Whole => vec![made("cloze", item.code.clone(), cloze(item), None)?],
        _ => item.parts.iter().enumerate().map(of_part).collect::<Result<_, _>>()?,
    };
    Ok(Fragment { problem: item.problem, code: item.code.clone(), questions, files: Vec::new() })
}

/// The text of all parts, with a field for each.
fn cloze(item: &Item) -> String {
    let weights = weights(&item.parts.iter().map(|p| p.points).collect::<Vec<_>>());
    // A mark that no text holds, so that the fields alone keep their braces.
    let place = |i: usize| format!("\u{0}{i}\u{0}");
    let mut xhtml = without_fields(&item.text(None, &mut |i| place(i), &address));
    for (i, (part, weight)) in item.parts.iter().zip(weights).enumerate() {
        xhtml = xhtml.replace(&place(i), &field(part, weight));
    }
    xhtml
}

/// Path and id number of the category of a pool. In a path a slash is written twice.
pub(crate) fn category(export: &Export, pool: &Pool) -> (String, String) {
    let cut = |text: &str, most: usize| text.chars().take(most).collect::<String>();
    let names = [export.set, &pool.name, pool.part].into_iter().filter(|name| !name.is_empty());
    let names = names.map(|name| cut(name, LONGEST.0).replace('/', "//"));
    let path = std::iter::once("$course$/top".to_owned()).chain(names).collect::<Vec<_>>().join("/");
    let mut id = format!("{}-{}", export.id, export.problems[pool.number - 1].id);
    if !pool.part.is_empty() {
        id = format!("{id}-{}", pool.part);
    }
    (path, cut(&id, LONGEST.1))
}
