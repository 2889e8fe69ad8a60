//! A text with its pictures: Markdown with `$...$` formulas is the single source of every format. What could act or fetch
//! something in a reader's browser is taken out here, once for all formats.
use crate::picture::Picture;
use crate::picture::svg::Screen;
use pulldown_cmark::{Event, LinkType, Options, Parser, Tag, TagEnd};
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

impl Head {
    /// The student: by name, or by id where there is none.
    pub fn who(&self) -> &str {
        if self.name.is_empty() { &self.student } else { &self.name }
    }

    /// What stands at the head of a printed page: student, set, code, as far as they are there.
    pub fn running(&self) -> impl Iterator<Item = &str> {
        [self.who(), &self.set, &self.code].into_iter().filter(|text| !text.is_empty())
    }
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

/// The longest unit with a slash that stays on one line, in bytes.
const LONGEST_UNIT: usize = 16;

/// The pieces of a text: those that are true are words with a slash in them, such as `rad/s`, at which no line should break.
pub fn units_apart(text: &str) -> Vec<(&str, bool)> {
    let ends = |c: char| c.is_whitespace() || matches!(c, '(' | ')' | ',' | ';' | ':');
    let mut pieces: Vec<(&str, bool)> = Vec::new();
    let mut from = 0;
    for word in text.split(ends) {
        let start = word.as_ptr().addr() - text.as_ptr().addr();
        let slash = word.find('/').is_some_and(|at| at > 0 && at + 1 < word.len());
        if slash && word.len() <= LONGEST_UNIT {
            pieces.push((&text[from..start], false));
            pieces.push((word, true));
            from = start + word.len();
        }
    }
    pieces.push((&text[from..], false));
    pieces.retain(|(piece, _)| !piece.is_empty());
    pieces
}

/// What a text of students does not keep: tags of HTML (but [`ANSWER`] and breaks of lines), links to anything but the web, mail
/// and places nearby, pictures that the program did not draw. The words between tags, of a link and of a picture stay.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Dropped {
    /// A tag, whose words stay.
    Tag(String),
    /// HTML that goes with all that it holds: a comment, a script (`WITH_CONTENT`).
    Html(String),
    /// The target of a link.
    Link(String),
    /// The source of a picture.
    Picture(String),
}

/// Elements whose content is not meant to be read, or only where they act.
const WITH_CONTENT: [&str; 12] = [
    "script", "style", "template", "iframe", "object", "applet", "svg", "canvas", "audio", "video",
    "noembed", "noframes",
];

/// Elements within a line: where their tags go, words do not come apart.
const WITHIN_LINE: [&str; 24] = [
    "a", "abbr", "b", "bdi", "bdo", "big", "cite", "code", "del", "dfn", "em", "font", "i", "ins", "kbd",
    "mark", "q", "s", "small", "span", "strong", "tt", "u", "var",
];

/// Stands before a `<` at the begin of a line, so that the line is read as Markdown and not as a block of HTML, in which words
/// would be lost. Means nothing, and is gone at the end.
const GUARD: char = '\u{fffe}';

/// Passes over a text at most: what stays may make a tag anew.
const PASSES: usize = 10;

/// What is taken out of a text.
struct Cut {
    range: Range<usize>,
    told: Option<Dropped>,
    /// What comes in its place; a blank only between words.
    instead: &'static str,
}

/// A Markdown text without what could act or fetch something.
pub fn clean(markdown: String) -> String {
    cleaned(markdown).0
}

/// The text as students get it, and what it lost.
fn cleaned(mut markdown: String) -> (String, Vec<Dropped>) {
    let mut told = Vec::new();
    if is_plain(&markdown) {
        return (markdown, told);
    }
    markdown.retain(|c| c != GUARD);
    for _ in 0..PASSES {
        let cuts = cuts(&markdown);
        if cuts.is_empty() {
            if !markdown.contains(GUARD) {
                return (markdown, told);
            }
            // A tag that never ends is a text. What stood behind a guard begins a line now, and is looked at again.
            markdown = markdown.replace(&format!("{GUARD}<"), "&lt;").replace(GUARD, "");
            continue;
        }
        let mut out = String::with_capacity(markdown.len());
        let mut from = 0;
        for cut in cuts {
            out.push_str(markdown.get(from..cut.range.start).unwrap_or_default());
            from = from.max(cut.range.end);
            let rest = markdown.get(from..).unwrap_or_default();
            let apart = out.ends_with(|c: char| c.is_whitespace() || c == GUARD)
                || rest.starts_with(char::is_whitespace);
            if cut.instead != " " || !apart && !out.is_empty() {
                out.push_str(cut.instead);
            }
            told.extend(cut.told);
        }
        out.push_str(markdown.get(from..).unwrap_or_default());
        markdown = out;
    }
    // So many turns come of tags that were nested on purpose: all that is left of them is shown as text.
    markdown.retain(|c| c != GUARD);
    (markdown.replace('<', "&lt;").replace("](", "] (").replace("]:", "] :"), told)
}

/// What [`clean`] takes out of a text.
pub fn dropped(markdown: &str) -> Vec<Dropped> {
    cleaned(markdown.to_owned()).1
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
    // Words behind a mark that begins their line would stand in a block of HTML.
    let alone = |line: &str| line.trim_start().strip_prefix(ANSWER).is_none_or(|rest| rest.trim().is_empty());
    !without_marks(markdown).contains('<')
        && !markdown.contains("]:")
        && (!markdown.contains(ANSWER) || markdown.lines().all(alone))
        && links.all(|(at, _)| {
            let url = markdown.get(at + 2..).unwrap_or_default();
            is_drawn(url.split(')').next().unwrap_or_default())
        })
}

/// The name of the element whose tag begins here, in small letters, and whether the tag opens it.
fn element(tag: &str) -> Option<(String, bool)> {
    let inside = tag.strip_prefix('<')?;
    let name = inside.strip_prefix('/').unwrap_or(inside);
    let end = name.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(name.len());
    let name = name.get(..end).filter(|n| n.starts_with(|c: char| c.is_ascii_alphabetic()))?;
    Some((name.to_ascii_lowercase(), !inside.starts_with('/')))
}

/// Where what begins in a text ends, if it goes with all that it holds. Looks for each end once.
#[derive(Default)]
struct Ends {
    /// The text in small letters, once it is needed.
    small: String,
    /// Ends that come no more.
    never: Vec<String>,
}

impl Ends {
    fn of(&mut self, markdown: &str, from: usize) -> Option<usize> {
        let text = markdown.get(from..)?;
        let known = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("<!", ">")];
        let (end, skip) = match known.iter().find(|(begin, _)| text.starts_with(begin)) {
            // `<!-->` is a comment, too.
            Some(("<!--", end)) => ((*end).to_owned(), 2),
            Some((begin, end)) => ((*end).to_owned(), begin.len()),
            None => {
                let (name, opens) = element(text)?;
                if !opens || !WITH_CONTENT.contains(&name.as_str()) {
                    return None;
                }
                (format!("</{name}"), name.len())
            }
        };
        if self.never.contains(&end) {
            return None;
        }
        if self.small.is_empty() {
            self.small = markdown.to_ascii_lowercase();
        }
        let Some(at) = self.small.get(from + skip..).and_then(|rest| rest.find(&end)) else {
            self.never.push(end);
            return None;
        };
        let at = from + skip + at;
        if end.starts_with("</") {
            return Some(markdown.get(at..)?.find('>').map_or(markdown.len(), |close| at + close + 1));
        }
        Some(at + end.len())
    }
}

/// What is cut out of a text, in order.
fn cuts(markdown: &str) -> Vec<Cut> {
    let link = |range, told| Cut { range, told, instead: "" };
    let parser = Parser::new_ext(markdown, MARKDOWN);
    let mut found: Vec<Cut> = Vec::new();
    for (_, definition) in parser.reference_definitions().iter() {
        if !is_harmless(&definition.dest) && !is_drawn(&definition.dest) {
            found.push(link(definition.span.clone(), Some(Dropped::Link(definition.dest.to_string()))));
        }
    }
    // Links and pictures that are open: what is told of them if they go, and where their words stand.
    let mut open: Vec<(Option<Dropped>, Option<Range<usize>>)> = Vec::new();
    // The lines of the block of HTML that is open; up to where all is cut already.
    let mut block: Vec<Range<usize>> = Vec::new();
    let (mut ends_of, mut gone) = (Ends::default(), 0);
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
            found.push(link(range.start..words.start, Some(told)));
            found.push(link(words.end..range.end, None));
        } else if let Event::Html(_) = &event {
            block.push(range);
        } else if let Event::End(TagEnd::HtmlBlock) = &event {
            let lines = std::mem::take(&mut block);
            if lines.iter().all(|line| markdown.get(line.clone()).is_none_or(is_mark)) {
                continue;
            }
            for line in lines {
                let text = markdown.get(line.clone()).unwrap_or_default();
                let start = line.start + text.len() - text.trim_start_matches([' ', '\t']).len();
                if start < gone {
                    continue;
                }
                // What is set in would be a text of a program.
                found.push(link(line.start..start, None));
                if let Some(end) = ends_of.of(markdown, start) {
                    let html = markdown.get(start..end).unwrap_or_default();
                    let told = (!is_mark(html)).then(|| Dropped::Html(html.to_owned()));
                    found.push(link(start..end, told));
                    gone = end;
                } else if markdown.get(start..).is_some_and(|rest| rest.starts_with('<')) {
                    found.push(Cut { range: start..start, told: None, instead: "\u{fffe}" });
                }
            }
        } else if let Event::InlineHtml(html) = &event
            && range.start >= gone
            && (!is_mark(html) || markdown.get(..range.start).is_some_and(|t| t.ends_with(GUARD)))
        {
            let (name, opens) = element(html).unwrap_or_default();
            let end = ends_of.of(markdown, range.start).unwrap_or(range.end).max(range.end);
            let is_tag = end == range.end && !name.is_empty();
            let html = markdown.get(range.start..end).unwrap_or_default().to_owned();
            gone = end;
            let told =
                (!is_mark(&html)).then_some(if is_tag { Dropped::Tag(html) } else { Dropped::Html(html) });
            let instead = match name.as_str() {
                // Raised and lowered text is written as in TeX.
                "sup" if opens => "^",
                "sub" if opens => "\\_",
                "sup" | "sub" => "",
                name if name.is_empty() || WITHIN_LINE.contains(&name) => "",
                _ => " ",
            };
            found.push(Cut { range: range.start..end, told, instead });
        }
    }
    found.retain(|cut| !cut.range.is_empty() || !cut.instead.is_empty());
    found.sort_by_key(|cut| (cut.range.start, cut.range.end));
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

    #[test]
    fn a_unit_does_not_break_at_its_slash() {
        let units = |text| units_apart(text).into_iter().filter(|p| p.1).map(|p| p.0).collect::<Vec<_>>();
        assert_eq!(units(", in rad/s, within 2 % (or km/h)"), ["rad/s", "km/h"]);
        assert_eq!(units("a / b, /c and https://example.org/a-long-way"), [""; 0]);
        let text = "in m/s² or kg·m/s";
        assert_eq!(units_apart(text).iter().map(|p| p.0).collect::<String>(), text);
    }
}
