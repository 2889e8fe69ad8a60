//! Moodle XML: a category for each problem with a cloze question for each variant, or a category and a question for each part.
use crate::export::item::{Item, ItemPart, Right};
use crate::export::units::units;
use crate::export::xml::Xml;
use crate::export::{Export, Fragment, QuestionLayout};
use crate::set::key_file::shortest;
use base64::prelude::{BASE64_STANDARD, Engine as _};

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

/// The questions of an item.
pub fn fragment(export: &Export, item: &Item) -> Fragment {
    let questions = match export.layout {
        QuestionLayout::Whole => vec![cloze(item)],
        QuestionLayout::Parts | QuestionLayout::PartsWithUnits => {
            (0..item.parts.len()).map(|i| of_part(item, i)).collect()
        }
    };
    Fragment { problem: item.problem, code: item.code.clone(), questions, files: Vec::new() }
}

/// A text in a question, with the pictures that it shows.
fn text(x: &mut Xml, name: &str, item: &Item, xhtml: &str) {
    x.element(name, &[("format", "html")], |x| {
        x.data("text", &[], xhtml);
        for picture in item.pictures.iter().filter(|p| xhtml.contains(&address(&p.file))) {
            let bytes = BASE64_STANDARD.encode(picture.svg.as_bytes());
            x.text("file", &[("name", &picture.file), ("path", "/"), ("encoding", "base64")], &bytes);
        }
    });
}

/// What all kinds of questions begin with.
fn head(x: &mut Xml, item: &Item, name: &str, xhtml: &str, points: Option<f64>) {
    x.element("name", &[], |x| x.text("text", &[], name));
    text(x, "questiontext", item, xhtml);
    text(x, "generalfeedback", item, &without_fields(&item.solution(&address).unwrap_or_default()));
    if let Some(points) = points {
        x.text("defaultgrade", &[], &shortest(points));
    }
    x.text("penalty", &[], "0");
    x.text("hidden", &[], "0");
    x.text("idnumber", &[], name);
}

/// All parts in one question.
fn cloze(item: &Item) -> String {
    let weights = weights(&item.parts.iter().map(|p| p.points).collect::<Vec<_>>());
    // A mark that no text holds, so that the fields alone keep their braces.
    let place = |i: usize| format!("\u{0}{i}\u{0}");
    let whole = item.text(None, &mut |i| place(i), &address);
    let mut xhtml = without_fields(&whole);
    for (i, (part, weight)) in item.parts.iter().zip(weights).enumerate() {
        xhtml = xhtml.replace(&place(i), &field(part, weight));
    }
    let mut x = Xml::piece();
    x.element("question", &[("type", "cloze")], |x| head(x, item, &item.code, &xhtml, None));
    x.line();
    x.done()
}

/// One part in a question of its own.
fn of_part(item: &Item, i: usize) -> String {
    let part = &item.parts[i];
    let name = format!("{} {}", item.code, part.id);
    let xhtml = item.text(Some(i), &mut |_| String::new(), &address);
    let mut x = Xml::piece();
    let kind = match part.right {
        Right::Number { .. } => "numerical",
        Right::Word { .. } => "shortanswer",
    };
    x.element("question", &[("type", kind)], |x| {
        head(x, item, &name, &xhtml, Some(part.points));
        let answer = |x: &mut Xml, text: &str, tolerance: Option<f64>| {
            x.element("answer", &[("fraction", "100"), ("format", "moodle_auto_format")], |x| {
                x.text("text", &[], text);
                if let Some(tolerance) = tolerance {
                    x.text("tolerance", &[], &shortest(tolerance));
                }
            });
        };
        match &part.right {
            Right::Number { value, tolerance, unit } => {
                answer(x, &shortest(*value), Some(*tolerance));
                let units = units(unit);
                x.text("unitgradingtype", &[], "0");
                x.text("unitpenalty", &[], "0");
                // 0: a unit may be typed, 3: there is none.
                x.text("showunits", &[], if units.is_empty() { "3" } else { "0" });
                x.text("unitsleft", &[], "0");
                if !units.is_empty() {
                    x.element("units", &[], |x| {
                        for (name, multiplier) in &units {
                            x.element("unit", &[], |x| {
                                x.text("multiplier", &[], &shortest(*multiplier));
                                x.text("unit_name", &[], name);
                            });
                        }
                    });
                }
            }
            Right::Word { spellings, .. } => {
                x.text("usecase", &[], "0");
                spellings.iter().for_each(|word| answer(x, word, None));
            }
        }
    });
    x.line();
    x.done()
}

/// A text cut to so many characters.
fn cut(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}

/// A category. In its path a slash is written twice.
fn category(x: &mut Xml, path: &[&str], about: &str, id_number: &str) {
    let names = path.iter().map(|name| cut(name, LONGEST.0).replace('/', "//"));
    let path = std::iter::once("$course$/top".to_owned()).chain(names).collect::<Vec<_>>().join("/");
    x.element("question", &[("type", "category")], |x| {
        x.element("category", &[], |x| x.text("text", &[], &path));
        x.element("info", &[("format", "plain_text")], |x| x.text("text", &[], about));
        x.text("idnumber", &[], &cut(id_number, LONGEST.1));
    });
    x.line();
}

/// The file.
pub fn file(export: &Export, fragments: &[Fragment]) -> Vec<u8> {
    let mut x = Xml::file();
    x.element("quiz", &[], |x| {
        x.line();
        for of_problem in fragments.chunk_by(|a, b| a.problem == b.problem) {
            let at = of_problem[0].problem;
            let (problem, about, name) = (export.problems[at], &export.about, export.name(at));
            let id = format!("{}-{}", export.id, problem.id);
            if export.layout == QuestionLayout::Whole {
                category(x, &[export.set, &name], about, &id);
                of_problem.iter().flat_map(|f| &f.questions).for_each(|question| x.raw(question));
                continue;
            }
            for (i, question) in problem.questions.iter().enumerate() {
                let id = format!("{id}-{}", question.id);
                category(x, &[export.set, &name, &question.id], about, &id);
                of_problem.iter().filter_map(|f| f.questions.get(i)).for_each(|question| x.raw(question));
            }
        }
    });
    x.line();
    x.done().into_bytes()
}
