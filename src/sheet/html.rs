//! Markdown with math and pictures to HTML with MathML and inline SVG. The Markdown text is the only source.
use crate::finding::Finding;
use crate::picture::svg::{Screen, escaped};
use crate::sheet::document::{ANSWER, Document, Head, is_break, kept_together, units_apart};
use crate::sheet::self_check::Tools;
use crate::template::{self, Templates, View};
use crate::words::Words;
use pulldown_cmark::{Alignment, Event, HeadingLevel, Parser, Tag, TagEnd};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::event::{Content, Event as Formula};
use pulldown_latex::{RenderConfig, Storage};
use rustc_hash::FxHashMap;
use std::fmt::Write as _;

pub use crate::sheet::document::MARKDOWN;

/// Turns documents into HTML and remembers formulas: the same few occur in every sheet.
pub struct Converter<'w> {
    words: &'w Words,
    formulas: Formulas,
}

/// Formulas remembered at most, so that memory does not grow with the class.
const REMEMBERED: usize = 4096;
/// A formula on a line of its own that has more signs than this may be wider than a phone, and scrolls by itself.
const PHONE: usize = 28;
/// One with more signs than this is set smaller on paper, so that it fits.
pub const PAPER: usize = 70;

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
        Self { words, formulas: Formulas::default() }
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
        let mut walk = HtmlWalk {
            tables: 0,
            formulas: 0,
            columns: Vec::new(),
            cell: 0,
            in_head: false,
            in_code: false,
            part: None,
            boxed: Vec::new(),
        };
        let mut events = Parser::new_ext(&document.markdown, MARKDOWN).peekable();
        let mut ready: Vec<Event> = Vec::new();
        // Pictures bring their style along; in one page each style is needed once.
        let mut styles: Vec<&str> = Vec::new();
        let mut picture = |name: &str, screen: &'d Screen| {
            let id = format!("{}{name}", place.prefix);
            let mut svg = if styles.contains(&screen.style()) {
                screen.inline_without_style(&id)
            } else {
                styles.push(screen.style());
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
                let signs = signs(&tex);
                let mut class = String::from("formula");
                if signs > PAPER {
                    class.push_str(" long");
                }
                let parts = beside(&tex);
                let widest = parts.iter().map(|part| self::signs(part)).max().unwrap_or(0);
                let scrolls = if widest > PHONE {
                    let label = format!("{} {}", self.words.get("sheet.formula"), walk.formulas);
                    format!(" role=\"group\" tabindex=\"0\" aria-label=\"{label}\"")
                } else {
                    String::new()
                };
                let math = match parts.as_slice() {
                    [whole] => formula(whole, true),
                    parts => {
                        let shown = |part: &String| formula(part, false).replacen("<math", ROW, 1);
                        parts.iter().map(shown).collect::<Vec<_>>().join(" ")
                    }
                };
                out.push(html(format!("<span class=\"{class}\"{scrolls}>{math}</span>")));
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
            // Nobody's HTML reaches a page.
            Event::Html(_) | Event::InlineHtml(_) => {}
            Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                let level = lowered(level, place.lower);
                out.push(Event::Start(Tag::Heading { level, id: None, classes, attrs }));
            }
            Event::End(TagEnd::Heading(level)) => {
                out.push(Event::End(TagEnd::Heading(lowered(level, place.lower))))
            }
            // A wide table scrolls by itself and not with the page.
            Event::Start(Tag::Table(columns)) => {
                walk.tables += 1;
                walk.columns = columns;
                let label = format!("{} {}", self.words.get("sheet.table"), walk.tables);
                out.push(html(format!(
                    "<div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"{label}\"><table>\n"
                )));
            }
            Event::End(TagEnd::Table) => out.push(html("</tbody></table></div>\n".to_owned())),
            Event::Start(Tag::TableHead) => {
                (walk.in_head, walk.cell) = (true, 0);
                out.push(html("<thead><tr>".to_owned()));
            }
            Event::End(TagEnd::TableHead) => {
                walk.in_head = false;
                out.push(html("</tr></thead>\n<tbody>\n".to_owned()));
            }
            Event::Start(Tag::TableRow) => {
                walk.cell = 0;
                out.push(html("<tr>".to_owned()));
            }
            Event::End(TagEnd::TableRow) => out.push(html("</tr>\n".to_owned())),
            Event::Start(Tag::TableCell) => {
                let class = match walk.columns.get(walk.cell) {
                    Some(Alignment::Right) => " class=\"right\"",
                    Some(Alignment::Center) => " class=\"middle\"",
                    _ => "",
                };
                walk.cell += 1;
                let tag = if walk.in_head { "th scope=\"col\"" } else { "td" };
                out.push(html(format!("<{tag}{class}>")));
            }
            Event::End(TagEnd::TableCell) => {
                out.push(html(if walk.in_head { "</th>" } else { "</td>" }.to_owned()));
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

    /// A box for an answer, which only a script shows, and the line that stands on paper without one.
    fn answer_box(&self, part: &str) -> String {
        let label = escaped(&self.words.say("page.box", &[("part", part)]));
        let part = escaped(part);
        format!(
            "<span class=\"box\"><span class=\"answer\"></span><input name=\"{part}\" form=\"answers\" aria-label=\"{label}\" autocomplete=\"off\" autocapitalize=\"none\" spellcheck=\"false\" maxlength=\"200\"></span>"
        )
    }
}

/// Formulas within lines as HTML, remembered: the same few occur in every sheet.
#[derive(Default)]
pub struct Formulas(FxHashMap<String, String>);

impl Formulas {
    /// A formula, in a line of its own or within one.
    pub fn html(&mut self, tex: &str, of_its_own: bool) -> String {
        if of_its_own {
            return formula(tex, true);
        }
        if let Some(known) = self.0.get(tex) {
            return known.clone();
        }
        if self.0.len() >= REMEMBERED {
            self.0.clear();
        }
        let html = formula(tex, false);
        self.0.insert(tex.to_owned(), html.clone());
        html
    }
}

/// What is known on the way through a document.
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

/// About how many signs wide a formula is: commands count as one, a fraction as the wider of its halves.
pub fn signs(tex: &str) -> usize {
    // Of several lines the longest.
    if tex.contains(r"\\") {
        return tex.split(r"\\").map(signs).max().unwrap_or(0);
    }
    let (mut count, mut rest) = (0, tex);
    while let Some(c) = rest.chars().next() {
        if let Some(command) = rest.strip_prefix('\\') {
            let letters = command.chars().take_while(char::is_ascii_alphabetic).count();
            let name = &command[..letters];
            rest = &command[letters.max(command.chars().next().map_or(0, char::len_utf8))..];
            match name {
                "frac" | "dfrac" | "tfrac" => {
                    let (above, after) = group(rest);
                    let (below, after) = group(after);
                    count += signs(above).max(signs(below));
                    rest = after;
                }
                "begin" | "end" => rest = group(rest).1,
                "mathrm" | "text" | "left" | "right" | "quad" | "qquad" => {}
                _ => count += 1,
            }
            continue;
        }
        if !matches!(c, '{' | '}' | '^' | '_' | '&' | ' ' | '\n') {
            count += 1;
        }
        rest = &rest[c.len_utf8()..];
    }
    count
}

/// The text within the braces at the start, and what follows.
fn group(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let Some(inner) = text.strip_prefix('{') else {
        let end = text.chars().next().map_or(0, char::len_utf8);
        return text.split_at(end);
    };
    let mut depth = 1;
    for (i, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (&inner[..i], &inner[i + 1..]);
        }
    }
    (inner, "")
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
/// a page that checks answers.
///
/// # Errors
/// Faults of the templates.
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
///
/// # Errors
/// Faults of the templates.
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
        template::map([
            ("id", template::finished(&part_id(i))),
            ("who", template::finished(&template::in_html(&who))),
            ("running", template::finished(&running_head(head))),
            ("body", template::finished(&body)),
        ])
    });
    view.value("sheets", template::list(list.collect()));
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

/// A formula within a line, or on a line of its own, as MathML.
pub fn formula(tex: &str, of_its_own: bool) -> String {
    mathml(tex, if of_its_own { DisplayMode::Block } else { DisplayMode::Inline })
}

/// The formulas that stand beside each other in one displayed line.
fn beside(tex: &str) -> Vec<String> {
    const GAP: &str = r", \qquad ";
    if tex.contains(r"\begin") {
        return vec![tex.to_owned()];
    }
    let last = tex.matches(GAP).count();
    tex.split(GAP)
        .enumerate()
        .map(|(i, part)| if i < last { format!("{part},") } else { part.to_owned() })
        .collect()
}

/// A formula as MathML; one that cannot be read is shown as it was written.
fn mathml(tex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let mut out = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let written = match unfit(tex) {
        Some(_) => None,
        None => {
            let parser = pulldown_latex::Parser::new(tex, &storage);
            pulldown_latex::push_mathml(&mut out, parser, config).ok()
        }
    };
    match written {
        Some(()) => tidy(&out),
        None => format!("<code>{}</code>", escaped(tex)),
    }
}

/// What the writer of MathML leaves ugly: escaped spaces, the micro sign for the letter mu, wide
/// slashes in units, decimal commas as if they parted a list, the letters of a unit one by
/// one.
fn tidy(mathml: &str) -> String {
    let text = mathml
        .replace("&amp;nbsp;", "\u{a0}")
        .replace('\u{b5}', "\u{3bc}")
        .replace("<mo>/</mo>", "<mo lspace=\"0\" rspace=\"0\">/</mo>")
        .replace("</mn><mrow><mo>,</mo></mrow><mn>", ",")
        .replace("<mtable class=\"menv-alignlike", "<mtable displaystyle=\"true\" class=\"menv-alignlike");
    styled(&whole_units(&text))
}

/// Upright letters side by side, as one word.
fn whole_units(mathml: &str) -> String {
    const UPRIGHT: &str = "<mi mathvariant=\"normal\">";
    let mut out = String::with_capacity(mathml.len());
    for (i, piece) in mathml.split("</mi>").enumerate() {
        let upright = out.rfind("<mi").is_some_and(|at| out[at..].starts_with(UPRIGHT));
        match piece.strip_prefix(UPRIGHT) {
            Some(more) if i > 0 && upright => out.push_str(more),
            _ => {
                if i > 0 {
                    out.push_str("</mi>");
                }
                out.push_str(piece);
            }
        }
    }
    out
}

/// Rows that carry a style become elements that may carry one.
fn styled(mathml: &str) -> String {
    const OPEN: &str = "<mrow displaystyle=";
    let mut out = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(at) = rest.find(OPEN) {
        let (before, tail) = rest.split_at(at);
        out.push_str(before);
        // The end of this row, past those of the rows within.
        let (mut depth, mut from) = (0, 0);
        let end = loop {
            let Some(next) = tail[from..].find("mrow").map(|i| from + i) else { break tail.len() };
            depth += if tail[..next].ends_with("</") { -1 } else { 1 };
            from = next + 4;
            if depth == 0 {
                break next - 2;
            }
        };
        let inner = tail.get(5..end).unwrap_or_default();
        out.push_str("<mstyle");
        out.push_str(&styled(inner));
        out.push_str("</mstyle>");
        rest = tail.get(end + 7..).unwrap_or_default();
    }
    out.push_str(rest);
    out
}

/// Signs of a formula at most.
const LONGEST: usize = 10_000;
/// Groups within groups at most.
const DEEPEST: usize = 60;

/// What a formula may not hold in any format, before it is read: new commands can repeat themselves for ever, and what is no
/// formula would be carried out by LaTeX.
pub fn unfit(tex: &str) -> Option<&'static str> {
    const NEW: [&str; 9] =
        ["def", "edef", "gdef", "xdef", "let", "futurelet", "newcommand", "renewcommand", "providecommand"];
    if tex.len() > LONGEST {
        return Some("is too long");
    }
    let (mut depth, mut rest) = (0usize, tex);
    while let Some(c) = rest.chars().next() {
        let command = rest.strip_prefix('\\').unwrap_or_default();
        let letters = command.chars().take_while(char::is_ascii_alphabetic).count();
        let name = &command[..letters];
        match (c, name) {
            ('\\', name) if NEW.contains(&name) => return Some("new commands cannot be made here"),
            ('\\', "left" | "begin" | "begingroup") | ('{', _) => depth += 1,
            ('\\', "right" | "end" | "endgroup") | ('}', _) => depth = depth.saturating_sub(1),
            ('%', _) => return Some("a sign of percent is written `\\%`"),
            ('^', _) if rest.starts_with("^^") => return Some("`^^` is no exponent"),
            _ => {}
        }
        if depth > DEEPEST {
            return Some("has too many groups within groups");
        }
        // A command of one sign takes that sign with it.
        rest = match (c, letters) {
            ('\\', 0) => &command[command.chars().next().map_or(0, char::len_utf8)..],
            ('\\', _) => &command[letters..],
            (c, _) => &rest[c.len_utf8()..],
        };
    }
    None
}

/// What is wrong with a formula, so that it can be shown in no format.
pub fn fault_of(tex: &str) -> Option<String> {
    if let Some(fault) = unfit(tex) {
        return Some(fault.to_owned());
    }
    let storage = Storage::new();
    for event in pulldown_latex::Parser::new(tex, &storage) {
        match event {
            Err(fault) => {
                let words = fault.to_string();
                return Some(words.lines().next().unwrap_or("cannot be read").to_owned());
            }
            // Words within a formula go to LaTeX as they stand.
            Ok(Formula::Content(Content::Text(text)))
                if text != "&nbsp;" && text.contains(['\\', '$', '{', '}']) =>
            {
                return Some("holds commands within words".to_owned());
            }
            Ok(_) => {}
        }
    }
    None
}

/// Says what is wrong with the formulas of a Markdown text, one sentence each.
pub fn faulty_formulas(markdown: &str) -> Vec<String> {
    Parser::new_ext(markdown, MARKDOWN)
        .filter_map(|event| match event {
            Event::InlineMath(tex) | Event::DisplayMath(tex) => Some(tex),
            _ => None,
        })
        .filter_map(|tex| fault_of(&tex).map(|fault| (tex, fault)))
        .map(|(tex, fault)| match tex.char_indices().nth(200) {
            Some((end, _)) => format!("`${} ...$`: {fault}", &tex[..end]),
            None => format!("`${tex}$`: {fault}"),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_words_and_symbols_stay_apart() {
        let of = |tex| mathml(tex, DisplayMode::Inline);
        assert!(
            of(r"40\ \mathrm{kg}").contains("<mi mathvariant=\"normal\">kg</mi>"),
            "{}",
            of(r"40\ \mathrm{kg}")
        );
        assert!(!of(r"x\Delta y").contains("xΔ"));
        assert!(of("0{,}25").contains("<mn>0,25</mn>"));
        assert!(of(r"f(1, 2)").contains("<mo>,</mo>"), "{}", of(r"f(1, 2)"));
        assert!(of(r"a + \tfrac{1}{2} b").contains("</mstyle>"));
        for tex in [r"\tfrac{1}{\tfrac{2}{3}} + x", r"\mathrm{m}/\mathrm{s}^{2}"] {
            let text = of(tex);
            for name in ["mrow", "mstyle", "mi"] {
                let count = |tag: String| text.matches(&tag).count();
                let open = count(format!("<{name}>")) + count(format!("<{name} "));
                assert_eq!(open, count(format!("</{name}>")), "{text}");
            }
        }
    }

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

    #[test]
    fn the_width_of_a_formula_is_that_of_its_widest_line() {
        assert_eq!(signs(r"\frac{a + b}{c}"), 3);
        assert_eq!(signs(r"\begin{aligned} a &= b \\\\ &= c + d \end{aligned}"), 4);
        assert_eq!(signs(r"\omega = 1{,}5\ \mathrm{rad}"), 9);
    }
}
