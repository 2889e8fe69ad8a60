//! The manual: one Markdown text for each topic, read on the terminal as it stands, or all of them as one HTML page.
use crate::finding::Finding;
use crate::sheet::document::Document;
use crate::sheet::html::{Converter, PlaceInPage};
use crate::template::{self, Templates, Value, View};
use crate::words::Words;
use std::fmt::Write as _;

/// A text of the manual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Topic {
    /// The word by which it is asked for.
    pub name: &'static str,
    /// What it tells, in a line.
    pub about: &'static str,
    /// The text: a title (`# `), then sections (`## `).
    pub text: &'static str,
}

macro_rules! topics {
    ($($name:literal: $about:literal),* $(,)?) => {
        &[$(Topic { name: $name, about: $about, text: include_str!(concat!("../templates/manual/", $name, ".md")) }),*]
    };
}

/// All topics, in the order of the book.
pub const TOPICS: &[Topic] = topics! {
    "commands": "the command line, from one problem to a graded class",
    "bank": "how to describe a problem: data, scene, regimes, questions, rules",
    "grading": "submissions, verdicts, how answers are read, course files, reports",
    "platforms": "questions for Moodle, Canvas and QTI: what to click, what is lost",
    "formats": "HTML, Markdown, LaTeX and PDF; languages; texts of your own",
    "trust": "why a key can be trusted, and how well grading does",
    "accuracy": "what integrators give away for their speed",
    "speed": "how long things take",
};

/// Pictures of the manual: name of the file, text.
const PICTURES: [(&str, &str); 3] = [
    ("constant.svg", include_str!("../templates/manual/constant.svg")),
    ("linear.svg", include_str!("../templates/manual/linear.svg")),
    ("nonlinear.svg", include_str!("../templates/manual/nonlinear.svg")),
];

/// The topic of this name.
pub fn topic(name: &str) -> Option<&'static Topic> {
    TOPICS.iter().find(|t| t.name == name)
}

/// The manual as one page that needs nothing else; at its end the help of each verb (name, text). Errors: faults of the template.
pub fn book(version: &str, verbs: &[(String, String)]) -> Result<String, Finding> {
    let words = Words::english();
    let mut converter = Converter::new(&words);
    let mut chapters: Vec<Value> = TOPICS.iter().map(|topic| chapter(topic, &mut converter)).collect();
    let sections = verbs.iter().map(|(verb, help)| {
        let body = format!("<pre tabindex=\"0\"><code>{}</code></pre>", template::in_html(help.trim()));
        part(&format!("verb-{verb}"), verb, &body)
    });
    let texts = [("id", "verbs"), ("title", "Every command with its options"), ("lead", "")];
    chapters.push(template::with(texts, [("sections", template::list(sections))]));
    let mut view = View::new();
    view.text("version", version);
    view.value("chapters", template::list(chapters));
    let page = Templates::english().made("manual.html", &view)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}

/// A topic as a chapter: what stands before the first section, and the sections.
fn chapter(topic: &Topic, converter: &mut Converter) -> Value {
    let text = topic.text.strip_prefix("# ").unwrap_or(topic.text);
    let (title, text) = text.split_once('\n').unwrap_or((text, ""));
    let mut pieces = sections(text).into_iter();
    let lead = pieces.next().map_or_else(String::new, |(_, lead)| html(converter, lead));
    let sections = pieces.map(|(heading, body)| {
        let plain = heading.replace('`', "");
        let id = format!("{}-{}", topic.name, anchor(&plain));
        part(&id, &template::in_html(&plain), &html(converter, body))
    });
    let texts = [("id", topic.name), ("title", &template::in_html(title)), ("lead", &lead)];
    template::with(texts, [("sections", template::list(sections))])
}

fn part(id: &str, title: &str, body: &str) -> Value {
    template::texts([("id", id), ("title", title), ("body", body)])
}

/// Heading and text of each section; the first, without a heading, is what comes before. A line in a block of code is no heading.
fn sections(text: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    let (mut heading, mut from, mut at, mut in_code) = ("", 0, 0, false);
    for line in text.split_inclusive('\n') {
        in_code ^= line.starts_with("```");
        if let Some(next) = line.strip_prefix("## ").filter(|_| !in_code) {
            found.push((heading, &text[from..at]));
            (heading, from) = (next.trim_end(), at + line.len());
        }
        at += line.len();
    }
    found.push((heading, &text[from..]));
    found
}

/// A heading as the end of an address: as GitHub makes it.
fn anchor(heading: &str) -> String {
    let letters = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-'));
    letters.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// Markdown of a section to HTML: links to other topics go to their chapters, pictures stand in the page.
fn html(converter: &mut Converter, markdown: &str) -> String {
    let mut linked = markdown.to_owned();
    for topic in TOPICS {
        linked = linked.replace(&format!("]({}.md)", topic.name), &format!("](#{})", topic.name));
        linked = linked.replace(&format!("]({}.md#", topic.name), &format!("](#{}-", topic.name));
    }
    let mut out = String::new();
    let mut text = String::new();
    for line in linked.split_inclusive('\n') {
        let Some((alternative, svg)) = picture(line) else {
            text.push_str(line);
            continue;
        };
        out.push_str(&prose(converter, &std::mem::take(&mut text)));
        let alternative = template::in_html(alternative);
        let _ = write!(out, "<figure><img alt=\"{alternative}\" src=\"{}\"></figure>", address(svg));
    }
    out.push_str(&prose(converter, &text));
    out
}

fn prose(converter: &mut Converter, markdown: &str) -> String {
    let document = Document::new(markdown.to_owned(), Vec::new());
    let body = converter.body(&document, &[], PlaceInPage { lower: 1, prefix: "", boxes: &[] });
    // What is wider than the page scrolls by itself, with the keyboard, too.
    body.replace("<pre>", "<pre tabindex=\"0\">")
}

/// What a line that is a picture shows, and its text.
fn picture(line: &str) -> Option<(&str, &'static str)> {
    let (alternative, file) = line.trim().strip_prefix("![")?.strip_suffix(')')?.split_once("](")?;
    PICTURES.iter().find(|(name, _)| *name == file).map(|(_, svg)| (alternative, *svg))
}

/// A picture as an address that holds it: the page fetches nothing.
fn address(svg: &str) -> String {
    let mut out = String::from("data:image/svg+xml;charset=utf-8,");
    for byte in svg.bytes() {
        match byte {
            b'%' | b'#' | b'"' | b'<' | b'>' | b'&' | 0..=31 | 127.. => {
                let _ = write!(out, "%{byte:02X}");
            }
            byte => out.push(char::from(byte)),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_falls_into_its_sections() {
        let text = "lead\n## One `two`\na\n```\n## no heading\n```\n## Three\nb\n";
        let found = sections(text);
        assert_eq!(found, [("", "lead\n"), ("One `two`", "a\n```\n## no heading\n```\n"), ("Three", "b\n")]);
        assert_eq!(anchor("Questions, tolerances: 2 of 3"), "questions-tolerances-2-of-3");
    }

    #[test]
    fn a_picture_stands_in_the_page() {
        let (alternative, svg) = picture("![error against cost](linear.svg)\n").expect("a picture");
        assert_eq!(alternative, "error against cost");
        assert!(!address(svg).contains(['"', '<', '>', '#', '\n']));
        assert_eq!(picture("![error](no.svg)"), None);
    }
}
