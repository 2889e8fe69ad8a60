//! A text with its pictures: Markdown with `$...$` formulas is the single source of every format. What could act or fetch
//! something in a reader's browser is taken out here, once for all formats.
use crate::figure::picture::Picture;
use crate::figure::svg::Screen;
use pulldown_cmark::Event;
use pulldown_cmark::LinkType;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use std::ops::Range;

/// What of Markdown is read, in every format.
pub const MARKDOWN: Options = Options::ENABLE_MATH.union(Options::ENABLE_TABLES);

/// A text with its pictures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// The text. A picture stands in a paragraph of its own, `![what it shows](NAME.svg)`. Where paper needs room for an
    /// answer stands [`ANSWER`].
    pub markdown: String,
    /// The pictures by name (without `.svg`), in the order of the text.
    pub pictures: Vec<(String, Picture)>,
}

/// Room for an answer on paper: formats that are printed put a line or a box there, files of Markdown leave it out.
pub const ANSWER: &str = "<!-- answer -->";

/// What stands at the head of a document and of each of its printed pages: texts as people wrote them, not escaped.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Head {
    /// Title of the bank, or of the document.
    pub title: String,
    /// Name of the student; empty if the roster has none.
    pub name: String,
    /// Id of the student.
    pub student: String,
    /// Name of the set.
    pub set: String,
    /// Code of the drawn data, so that a sheet on paper can be told from every other.
    pub code: String,
}

impl Document {
    /// A text with its pictures, without what could act or fetch something ([`Dropped`]).
    pub fn new(markdown: String, pictures: Vec<(String, Picture)>) -> Self {
        Self { markdown: clean(markdown), pictures }
    }

    /// The Markdown as a file of its own: without room for answers.
    pub fn plain(&self) -> String {
        without_marks(&self.markdown)
    }

    /// The picture of this name.
    pub fn picture(&self, name: &str) -> Option<&Picture> {
        self.pictures.iter().find(|(n, _)| n == name).map(|(_, picture)| picture)
    }

    /// The pictures as they stand on a screen: made once, shown in the page, in the booklet and as files.
    pub fn screens(&self) -> Vec<(&str, Screen<'_>)> {
        self.pictures.iter().map(|(name, picture)| (name.as_str(), Screen::new(picture))).collect()
    }
}

/// A sign of percent stays on the line of its number: the blank between them becomes one that does not break.
pub fn kept_together(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut pieces = text.split(" %");
    out.push_str(pieces.next().unwrap_or_default());
    for piece in pieces {
        out.push_str(if out.ends_with(|c: char| c.is_ascii_digit()) { "\u{a0}%" } else { " %" });
        out.push_str(piece);
    }
    out
}

/// What a text of students does not keep: HTML (but [`ANSWER`] and breaks of lines), links to anything but the web, mail and
/// places nearby, pictures that the program did not draw. The words of a link and of a picture stay.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Dropped {
    /// A tag or comment.
    Html(String),
    /// The target of a link.
    Link(String),
    /// The source of a picture.
    Picture(String),
}

/// Passes over a text at most: what stays may make a tag anew.
const PASSES: usize = 8;

/// A Markdown text without what could act or fetch something.
pub fn clean(mut markdown: String) -> String {
    for _ in 0..PASSES {
        let cuts = cuts(&markdown);
        if cuts.is_empty() {
            return markdown;
        }
        let mut out = String::with_capacity(markdown.len());
        let mut from = 0;
        for (range, _) in cuts {
            out.push_str(markdown.get(from..range.start).unwrap_or_default());
            from = from.max(range.end);
        }
        out.push_str(markdown.get(from..).unwrap_or_default());
        markdown = out;
    }
    // Somebody nests tags on purpose.
    markdown.replace('<', "&lt;").replace("](", "] (").replace("]:", "] :")
}

/// What [`clean`] takes out of a text.
pub fn dropped(markdown: &str) -> Vec<Dropped> {
    cuts(markdown).into_iter().filter_map(|(_, what)| what).collect()
}

/// Is this HTML that means the same in every format?
pub fn is_mark(html: &str) -> bool {
    let html = html.trim();
    html.is_empty() || html == ANSWER || is_break(html)
}

/// A break of a line, as HTML writes it.
pub fn is_break(html: &str) -> bool {
    ["<br>", "<br/>", "<br />"].iter().any(|b| html.trim().eq_ignore_ascii_case(b))
}

/// May a page for students link to this?
fn is_harmless(url: &str) -> bool {
    let odd = |c: char| c.is_control() || c.is_whitespace() || c == '\\';
    let begins = |with: &str| url.get(..with.len()).is_some_and(|b| b.eq_ignore_ascii_case(with));
    let nearby = !url.starts_with("//") && url.split(['/', '?', '#']).next().is_none_or(|s| !s.contains(':'));
    !url.contains(odd) && (nearby || begins("https://") || begins("http://") || begins("mailto:"))
}

/// Is this the name of a picture that the program draws?
fn is_drawn(url: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
    url.strip_suffix(".svg").is_some_and(|name| !name.is_empty() && name.chars().all(plain))
}

/// Can there be nothing to cut? Most texts are of this kind, and need not be read twice.
fn is_plain(markdown: &str) -> bool {
    let mut links = markdown.match_indices("](");
    !without_marks(markdown).contains('<')
        && !markdown.contains("]:")
        && links.all(|(at, _)| {
            let url = markdown.get(at + 2..).unwrap_or_default();
            is_drawn(url.split(')').next().unwrap_or_default())
        })
}

/// What is cut out of a text, in order and apart; what it is, where it is told.
fn cuts(markdown: &str) -> Vec<(Range<usize>, Option<Dropped>)> {
    if is_plain(markdown) {
        return Vec::new();
    }
    let parser = Parser::new_ext(markdown, MARKDOWN);
    let mut found: Vec<(Range<usize>, Option<Dropped>)> = Vec::new();
    for (_, definition) in parser.reference_definitions().iter() {
        if !is_harmless(&definition.dest) && !is_drawn(&definition.dest) {
            found.push((definition.span.clone(), Some(Dropped::Link(definition.dest.to_string()))));
        }
    }
    // Links and pictures that are open: what is told of them if they go, and where their words stand.
    let mut open: Vec<(Option<Dropped>, Option<Range<usize>>)> = Vec::new();
    for (event, range) in parser.into_offset_iter() {
        let begins = match &event {
            Event::Start(Tag::Link { dest_url, link_type, .. }) => {
                let good = *link_type == LinkType::Email || is_harmless(dest_url);
                Some((!good).then(|| Dropped::Link(dest_url.to_string())))
            }
            Event::Start(Tag::Image { dest_url, .. }) => {
                Some((!is_drawn(dest_url)).then(|| Dropped::Picture(dest_url.to_string())))
            }
            _ => None,
        };
        let ends = matches!(event, Event::End(TagEnd::Link | TagEnd::Image));
        if !ends {
            for (_, words) in &mut open {
                let words = words.get_or_insert(range.clone());
                *words = words.start.min(range.start)..words.end.max(range.end);
            }
        }
        if let Some(told) = begins {
            open.push((told, None));
        } else if ends && let Some((Some(told), words)) = open.pop() {
            // An address in angle brackets has no words of its own.
            let is_address = markdown.get(range.clone()).is_some_and(|t| t.starts_with('<'));
            let words = words.filter(|_| !is_address).unwrap_or(range.end..range.end);
            found.push((range.start..words.start, Some(told)));
            found.push((words.end..range.end, None));
        } else if let Event::Html(html) | Event::InlineHtml(html) = &event
            && !is_mark(html)
        {
            found.push((range, Some(Dropped::Html(html.trim().to_string()))));
        }
    }
    found.retain(|(range, _)| !range.is_empty());
    found.sort_by_key(|(range, _)| (range.start, range.end));
    found
}

/// A Markdown text without room for answers.
pub fn without_marks(markdown: &str) -> String {
    markdown.replace(&format!(" {ANSWER}"), "").replace(ANSWER, "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_stays_with_its_number() {
        assert_eq!(kept_together("within 1.9 % or 2 %, in %"), "within 1.9\u{a0}% or 2\u{a0}%, in %");
    }
}
