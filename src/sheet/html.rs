//! Markdown with math and pictures to HTML with MathML and inline SVG. The Markdown text is the only source.
use crate::finding::Finding;
use crate::picture::svg::{Screen, escaped};
use crate::sheet::document::{ANSWER, Document, Head, is_break, kept_together, units_apart};
use crate::sheet::formula::{FormulaCache, PAPER, PHONE, beside, formula, signs};
use crate::sheet::self_check::Tools;
use crate::template::{self, Templates, View};
use crate::words::Words;
use pulldown_cmark::{Alignment, Event, HeadingLevel, Parser, Tag, TagEnd};
use std::fmt::Write as _;

pub use crate::sheet::document::MARKDOWN;

/// Turns documents into HTML and remembers formulas: the same few occur in every sheet.
pub struct Converter<'w> {
    words: &'w Words,
    formulas: FormulaCache,
}

/// How a formula begins that stands beside others in a line, which breaks between them where it is narrow.
const ROW: &str = "<math displaystyle=\"true\"";

/// Signs that belong to what stands before them.
const PUNCTUATION: [char; 7] = [',', '.', ';', ':', ')', '!', '?'];
/// Where a document stands in a page.
#[derive(Default, Debug, Clone, Copy)]
pub struct PlaceInPage<'p> {
    /// Levels that its headings go down: 0 for a page of its own, 1 in a booklet.
    pub lower: usize,
    /// Begins the ids of its parts, which are then unique in the page.
    pub prefix: &'p str,
    /// Names of parts that get a box for the answer where there is room for it, `2.omega`.
    pub boxes: &'p [String],
}

impl<'w> Converter<'w> {
    /// A converter that names tables and formulas in these words.
    pub fn new(words: &'w Words) -> Self {
        Self { words, formulas: FormulaCache::default() }
    }

    /// The body of a page.
    pub fn body<'d>(
        &mut self,
        document: &'d Document,
        screens: &'d [(&str, Screen)],
        place: PlaceInPage,
    ) -> String {
        let drawn: usize = screens.iter().map(|(_, screen)| screen.bytes()).sum();
        let mut out = String::with_capacity(document.markdown.len() * 6 + drawn);
        let mut walk = HtmlWalk::default();
        let mut events = Parser::new_ext(&document.markdown, MARKDOWN).peekable();
        let mut ready: Vec<Event> = Vec::new();
        // Pictures bring their style along; in one page each style is needed once.
        let mut styles: Vec<&str> = Vec::new();
        let mut picture = |name: &str, screen: &'d Screen| {
            let id = format!("{}{name}", place.prefix);
            let mut svg = if styles.contains(&screen.style.as_str()) {
                screen.inline_without_style(&id)
            } else {
                styles.push(screen.style.as_str());
                screen.inline(&id)
            };
            svg.truncate(svg.trim_end().len());
            svg
        };
        while let Some(event) = events.next() {
            // A picture within a text; one that is not there leaves its words.
            if let Event::Start(Tag::Image { dest_url, .. }) = &event {
                if let Some(name) = dest_url.strip_suffix(".svg")
                    && let Some((_, screen)) = screens.iter().find(|(n, _)| *n == name)
                {
                    ready.push(Event::InlineHtml(picture(name, screen).into()));
                    let mut depth = 1;
                    for inner in events.by_ref() {
                        match inner {
                            Event::Start(Tag::Image { .. }) => depth += 1,
                            Event::End(TagEnd::Image) => depth -= 1,
                            _ => {}
                        }
                        if depth == 0 {
                            break;
                        }
                    }
                }
                continue;
            }
            if event == Event::End(TagEnd::Image) {
                continue;
            }
            // A paragraph that holds nothing but a picture becomes that picture.
            if event == Event::Start(Tag::Paragraph)
                && let Some(Event::Start(Tag::Image { dest_url, .. })) = events.peek()
                && let Some(name) = dest_url.strip_suffix(".svg").map(str::to_owned)
                && let Some((_, screen)) = screens.iter().find(|(n, _)| *n == name)
            {
                while events.next().is_some_and(|skipped| skipped != Event::End(TagEnd::Paragraph)) {}
                ready.push(Event::Html("<figure>".into()));
                ready.push(Event::Html(picture(&name, screen).into()));
                ready.push(Event::Html("</figure>\n".into()));
                continue;
            }
            // A browser would break a line between a formula and the sign that belongs to it.
            if matches!(event, Event::InlineMath(_))
                && let Some(Event::Text(next)) = events.peek()
                && let Some(rest) = next.strip_prefix(PUNCTUATION).map(str::to_owned)
            {
                let sign = next[..next.len() - rest.len()].to_owned();
                events.next();
                ready.push(Event::InlineHtml("<span class=\"kept\">".into()));
                self.event(event, place, &mut walk, &mut ready);
                ready.push(Event::InlineHtml(format!("{sign}</span>").into()));
                self.event(Event::Text(rest.into()), place, &mut walk, &mut ready);
                continue;
            }
            self.event(event, place, &mut walk, &mut ready);
        }
        // A text of one's own may leave no room behind the name of a part.
        for part in place.boxes.iter().filter(|part| !walk.boxed.contains(part)) {
            ready.push(Event::Html(
                format!("<p><code>{}</code> {}</p>\n", escaped(part), self.answer_box(part)).into(),
            ));
        }
        pulldown_cmark::html::push_html(&mut out, ready.into_iter());
        out
    }

    /// One event of Markdown to events that the writer of HTML knows.
    fn event<'e, 'p>(
        &mut self,
        event: Event<'e>,
        place: PlaceInPage<'p>,
        walk: &mut HtmlWalk<'p>,
        out: &mut Vec<Event<'e>>,
    ) {
        let html = |text: String| Event::InlineHtml(text.into());
        match event {
            Event::InlineMath(tex) => out.push(Event::InlineHtml(self.formulas.html(&tex, false).into())),
            Event::DisplayMath(tex) => {
                walk.formulas += 1;
                out.push(html(self.displayed(&tex, walk.formulas)));
            }
            Event::Html(text) | Event::InlineHtml(text) if text.trim() == ANSWER => {
                out.push(html(match walk.part.take().filter(|part| !walk.boxed.contains(part)) {
                    Some(part) => {
                        walk.boxed.push(part);
                        self.answer_box(part)
                    }
                    None => "<span class=\"answer\"></span>".to_owned(),
                }));
            }
            Event::Html(text) | Event::InlineHtml(text) if is_break(&text) => {
                out.push(html("<br>\n".to_owned()));
            }
            // HTML in a text is left out of the page.
            Event::Html(_) | Event::InlineHtml(_) => {}
            Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                let level = lowered(level, place.lower);
                out.push(Event::Start(Tag::Heading { level, id: None, classes, attrs }));
            }
            Event::End(TagEnd::Heading(level)) => {
                out.push(Event::End(TagEnd::Heading(lowered(level, place.lower))))
            }
            Event::Start(Tag::Table(_) | Tag::TableHead | Tag::TableRow | Tag::TableCell)
            | Event::End(TagEnd::Table | TagEnd::TableHead | TagEnd::TableRow | TagEnd::TableCell) => {
                out.push(html(self.of_table(event, walk)));
            }
            Event::Start(Tag::CodeBlock(_)) => {
                walk.in_code = true;
                out.push(event);
            }
            Event::End(TagEnd::CodeBlock) => {
                walk.in_code = false;
                out.push(event);
            }
            Event::Text(text) if !walk.in_code && text.contains(['%', '/']) => {
                for (piece, whole) in units_apart(&kept_together(&text)) {
                    out.push(match whole {
                        true => html(format!("<span class=\"unit\">{}</span>", escaped(piece))),
                        false => Event::Text(piece.to_owned().into()),
                    });
                }
            }
            Event::Code(name) => {
                // Room for an answer belongs to the part that was named last.
                walk.part = place.boxes.iter().find(|part| **part == *name).or(walk.part);
                out.push(Event::Code(name));
            }
            Event::Rule => out.push(Event::Html("<hr>\n".into())),
            Event::HardBreak => out.push(html("<br>\n".to_owned())),
            event => out.push(event),
        }
    }

    /// A formula on a line of its own, the one of this number in its document.
    fn displayed(&self, tex: &str, number: usize) -> String {
        let class = if signs(tex) > PAPER { "formula long" } else { "formula" };
        let parts = beside(tex);
        let widest = parts.iter().map(|part| signs(part)).max().unwrap_or(0);
        let scrolls = if widest > PHONE { self.scrolls("sheet.formula", number) } else { String::new() };
        let math = match parts.as_slice() {
            [whole] => formula(whole, true),
            parts => {
                let shown = |part: &String| formula(part, false).replacen("<math", ROW, 1);
                parts.iter().map(shown).collect::<Vec<_>>().join(" ")
            }
        };
        format!("<span class=\"{class}\"{scrolls}>{math}</span>")
    }

    /// Attributes of what may be wider than the page and scrolls by itself.
    fn scrolls(&self, name: &str, number: usize) -> String {
        format!(" role=\"group\" tabindex=\"0\" aria-label=\"{} {number}\"", self.words.get(name))
    }

    /// What begins and ends a table, its rows and its cells.
    fn of_table(&self, event: Event, walk: &mut HtmlWalk) -> String {
        match event {
            Event::Start(Tag::Table(columns)) => {
                walk.tables += 1;
                walk.columns = columns;
                return format!("<div class=\"wide\"{}><table>\n", self.scrolls("sheet.table", walk.tables));
            }
            Event::End(TagEnd::Table) => "</tbody></table></div>\n",
            Event::Start(Tag::TableHead) => {
                (walk.in_head, walk.cell) = (true, 0);
                "<thead><tr>"
            }
            Event::End(TagEnd::TableHead) => {
                walk.in_head = false;
                "</tr></thead>\n<tbody>\n"
            }
            Event::Start(Tag::TableRow) => {
                walk.cell = 0;
                "<tr>"
            }
            Event::End(TagEnd::TableRow) => "</tr>\n",
            Event::End(_) if walk.in_head => "</th>",
            Event::End(_) => "</td>",
            _ => {
                let class = match walk.columns.get(walk.cell) {
                    Some(Alignment::Right) => " class=\"right\"",
                    Some(Alignment::Center) => " class=\"middle\"",
                    _ => "",
                };
                walk.cell += 1;
                let tag = if walk.in_head { "th scope=\"col\"" } else { "td" };
                return format!("<{tag}{class}>");
            }
        }
        .to_owned()
    }

    /// A box for an answer, which only a script shows, and the line that stands on paper without one.
    fn answer_box(&self, part: &str) -> String {
        let label = escaped(&self.words.say("page.box", &[("part", part)]));
        let part = escaped(part);
        format!(
            "<span class=\"box\"><span class=\"answer\"></span><input name=\"{part}\" form=\"answers\" aria-label=\"{label}\" autocomplete=\"off\" autocapitalize=\"none\" spellcheck=\"false\" maxlength=\"200\"></span>"
        )
    }
}

/// What is known on the way through a document.
#[derive(Default)]
struct HtmlWalk<'p> {
    tables: usize,
    formulas: usize,
    columns: Vec<Alignment>,
    cell: usize,
    in_head: bool,
    in_code: bool,
    /// The part of a sheet that was named last and has no box yet.
    part: Option<&'p String>,
    /// The parts that have one.
    boxed: Vec<&'p String>,
}

fn lowered(level: HeadingLevel, by: usize) -> HeadingLevel {
    HeadingLevel::try_from((level as usize + by).min(6)).unwrap_or(HeadingLevel::H6)
}

/// The text at the head of a printed page, as a string of CSS: `"Amina Yusuf · week-3 · 7K3QF2"`.
pub fn running_head(head: &Head) -> String {
    let mut text = String::from("\"");
    for (i, part) in head.running().enumerate() {
        if i > 0 {
            text.push_str(" \u{b7} ");
        }
        for c in part.chars() {
            match c {
                // A quotation mark would end the string, a less-than sign might end the style.
                '"' | '\\' | '<' | '>' | '&' => {
                    let _ = write!(text, "\\{:x} ", u32::from(c));
                }
                c if c.is_control() => text.push(' '),
                c => text.push(c),
            }
        }
    }
    text.push('"');
    text
}

/// A page that needs nothing else. `kind` is the class of its body: `sheets`, `solutions`, `practice`, `key`; `tools` are those of
/// a page that checks answers. Errors: faults of the templates.
pub fn page(
    templates: &Templates,
    words: &Words,
    kind: &str,
    head: &Head,
    body: &str,
    tools: Option<&Tools>,
) -> Result<Vec<u8>, Finding> {
    let mut view = View::new();
    view.value("check", tools.map_or_else(|| template::finished(""), |tools| tools.view.clone()));
    view.allow(tools.map_or("", |tools| &tools.policy));
    view.text("language", words.language());
    view.text("kind", kind);
    view.foreign("title", &head.title);
    view.foreign("student", &head.student);
    view.foreign("name", &head.name);
    view.foreign("set", &head.set);
    view.text("code", &head.code);
    view.text("running", &running_head(head));
    view.text("body", body.trim_end());
    templates.made("sheet.html", &view)
}

/// One page with all of a set: each document, its headings lowered by one, is an article with the id `s1`, `s2`, ...
/// Errors: faults of the templates.
pub fn booklet<'p>(
    templates: &Templates,
    words: &Words,
    title: &str,
    parts: impl Iterator<Item = (&'p Head, &'p str)>,
) -> Result<Vec<u8>, Finding> {
    let mut view = View::new();
    view.text("language", words.language());
    view.foreign("title", title);
    view.text("skip", words.get("sheet.skip"));
    view.text("contents", words.get("sheet.contents"));
    let mut styles = Vec::new();
    let list = parts.enumerate().map(|(i, (head, body))| {
        let body = styles_once(body.trim_end(), &mut styles);
        let who = match head.name.as_str() {
            "" => head.student.clone(),
            name => format!("{name} ({})", head.student),
        };
        let (id, who, running) = (part_id(i), template::in_html(&who), running_head(head));
        template::texts([("id", &id), ("who", &who), ("running", &running), ("body", &body)])
    });
    view.value("sheets", template::list(list));
    templates.made("booklet.html", &view)
}

/// Figures bring their style along; in one page each style is needed once, and counts for all figures.
pub fn styles_once(html: &str, seen: &mut Vec<String>) -> String {
    const END: &str = "</style>";
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find("<style>") {
        let (before, tail) = rest.split_at(at);
        let (style, after) = tail.split_at(tail.find(END).map_or(tail.len(), |end| end + END.len()));
        out.push_str(before);
        if !seen.iter().any(|s| s == style) {
            out.push_str(style);
            seen.push(style.to_owned());
        }
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Id of a document in a booklet, counted from 0.
pub fn part_id(i: usize) -> String {
    format!("s{}", i + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_style_stands_once_in_a_page() {
        let mut seen = Vec::new();
        let first = styles_once("a<style>x</style>b<style>x</style>c<style>y</style>", &mut seen);
        assert_eq!(first, "a<style>x</style>bc<style>y</style>");
        assert_eq!(styles_once("<p><style>y</style></p>", &mut seen), "<p></p>");
    }

    #[test]
    fn a_name_ends_no_style_sheet() {
        let head = Head { name: "</style><script>\"\\".to_owned(), ..Head::default() };
        let text = running_head(&head);
        assert!(!text[1..text.len() - 1].contains(['<', '>', '"']), "{text}");
        assert!(text.starts_with("\"\\3c /style"), "{text}");
    }
}
