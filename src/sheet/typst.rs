//! Documents to the source text of Typst, formulas included. It only makes text; `sheet::pdf` compiles it.
//!
//! Everything is written as calls with texts in quotes (`#strong[..];`, `"kg"`), so that no text of anybody can become
//! markup. A formula or an element that has no translation is a finding, never a gap.
use crate::finding::{Finding, push_new};
use crate::picture::svg;
use crate::sheet::document::{ANSWER, Document, Head, MARKDOWN, is_break, units_apart};
use crate::sheet::formula::unfit;
use crate::words::Words;
use pulldown_cmark::{Alignment, CodeBlockKind, Event as Mark, Parser as Markdown, Tag, TagEnd};
use pulldown_latex::event::{
    ArrayColumn, ColumnAlignment, Content, DelimiterSize, DelimiterType, Dimension, DimensionUnit,
    EnvironmentFlow, Font, Grouping, ScriptPosition, ScriptType, StateChange, Style, Visual,
};
use pulldown_latex::{Event, Parser, Storage};
use std::fmt::Write as _;

/// The built-in prelude: how a page looks.
pub const PRELUDE: &str = include_str!("../../templates/print.typ");

/// Width of the longest formula within a line that is never broken, in characters as read aloud.
const UNBROKEN: usize = 28;

/// A document with a table of more columns than this lies across.
const WIDE: usize = 7;

/// The source of one PDF with these documents.
/// Errors: a formula or an element that has no translation, a picture that is not there.
pub fn source(documents: &[(&Head, &Document)], words: &Words) -> Result<String, Finding> {
    let mut out = String::from("#import \"/print.typ\": *\n#show: book.with(");
    let _ = write!(out, "language: {}, ", quoted(words.language()));
    let (title, authors) = match documents {
        [] => (String::new(), String::new()),
        [(head, _)] => {
            let who = head.who();
            let title = joined(&[&head.title, &head.set, who]);
            (title, if who.is_empty() { String::new() } else { format!("{},", quoted(who)) })
        }
        [(first, _), ..] => (joined(&[&first.title, &first.set]), String::new()),
    };
    // A document without a title is refused, for those who have it read aloud.
    let title = if title.is_empty() { "slipstick".to_owned() } else { title };
    let _ = writeln!(out, "title: {}, authors: ({authors}))", quoted(&title));
    out.push_str("#let labels = (");
    for (name, phrase) in [
        ("student", "student"),
        ("set-name", "set"),
        ("code", "code"),
        ("page", "page"),
        ("answer", "answer"),
    ] {
        let _ = write!(out, "{name}: {}, ", quoted(words.get(&format!("print.{phrase}"))));
    }
    out.push_str(")\n");
    for (i, (head, document)) in documents.iter().enumerate() {
        let _ = write!(out, "#sheet(number: {}, ", i + 1);
        for (name, text) in [
            ("title", &head.title),
            ("name", &head.name),
            ("student", &head.student),
            ("set-name", &head.set),
            ("code", &head.code),
        ] {
            let _ = write!(out, "{name}: {}, ", quoted(text));
        }
        let mut body = String::with_capacity(document.markdown.len() * 4);
        let mut page = TypstPage {
            document,
            words,
            out: &mut body,
            closers: Vec::new(),
            items: Vec::new(),
            hidden: 0,
            columns: 0,
            part: None,
        };
        page.write()?;
        let wide = page.columns > WIDE;
        let _ = writeln!(out, "wide: {wide}, labels: labels)[\n{body}];");
    }
    Ok(out)
}

/// Pieces with something in them, with commas between; no piece twice.
fn joined(pieces: &[&str]) -> String {
    let mut kept: Vec<&str> = Vec::new();
    pieces.iter().filter(|p| !p.is_empty()).for_each(|piece| push_new(&mut kept, *piece));
    kept.join(", ")
}

/// A text as Typst writes it in code.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => {
                let _ = write!(out, "\\u{{{:x}}}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A text as Typst writes it between markup.
fn escaped(out: &mut String, text: &str) {
    let mut last = ' ';
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        // A sign of percent stays with its number.
        if c == ' ' && last.is_ascii_digit() && letters.peek() == Some(&'%') {
            out.push('~');
            last = c;
            continue;
        }
        let plain = match c {
            ',' | ';' | ':' | '!' | '?' | '(' | ')' | '%' | '&' => true,
            // `1. ` begins a list.
            '.' => !last.is_ascii_digit(),
            c => !c.is_ascii_punctuation(),
        };
        if !plain {
            out.push('\\');
        }
        out.push(if c.is_control() { ' ' } else { c });
        last = c;
    }
}

/// One document while it is written.
struct TypstPage<'p> {
    document: &'p Document,
    words: &'p Words,
    out: &'p mut String,
    /// What ends the elements that are open.
    closers: Vec<&'static str>,
    /// Items of lists that are open: where each begins, and whether it has room for an answer.
    items: Vec<(usize, bool)>,
    /// Depth within an image, whose text is a description and not shown.
    hidden: usize,
    /// Columns of the widest table.
    columns: usize,
    /// Where the part begins that is being written: behind a heading, a figure, a list of questions.
    part: Option<usize>,
}

impl TypstPage<'_> {
    fn write(&mut self) -> Result<(), Finding> {
        let document = self.document;
        let mut alt = String::new();
        let mut picture: Option<String> = None;
        for mark in Markdown::new_ext(&document.markdown, MARKDOWN) {
            if self.hidden > 0 {
                match mark {
                    Mark::Start(_) => self.hidden += 1,
                    Mark::End(_) => {
                        self.hidden -= 1;
                        if self.hidden == 0
                            && let Some(name) = picture.take()
                        {
                            self.picture(&name, &alt)?;
                            // One in a list or a quotation is part of that.
                            if self.closers.len() == 1 {
                                self.keep_together();
                            }
                        }
                    }
                    Mark::Text(text) | Mark::Code(text) | Mark::InlineMath(text) => alt.push_str(&text),
                    Mark::SoftBreak | Mark::HardBreak => alt.push(' '),
                    _ => {}
                }
                continue;
            }
            if let Mark::Start(Tag::Image { dest_url, .. }) = &mark {
                picture = Some(dest_url.to_string());
                alt.clear();
                self.hidden = 1;
                continue;
            }
            self.mark(mark)?;
        }
        Ok(())
    }

    /// On a sheet no page ends within a statement with its figure, nor within a list of questions with what leads to it: the part
    /// that ends here.
    fn keep_together(&mut self) {
        if !self.document.markdown.contains(ANSWER) {
            return;
        }
        if let Some(begin) = self.part {
            self.out.insert_str(begin, "#together[");
            self.out.push_str("];\n\n");
        }
        self.part = Some(self.out.len());
    }

    fn open(&mut self, begin: &str, end: &'static str) {
        self.out.push_str(begin);
        self.closers.push(end);
    }

    fn mark(&mut self, mark: Mark) -> Result<(), Finding> {
        match mark {
            Mark::Start(tag) => self.start(tag)?,
            Mark::End(TagEnd::TableHead) => self.out.push_str("),\n"),
            Mark::End(TagEnd::Item) => {
                if let Some((begin, true)) = self.items.pop() {
                    self.out.insert_str(begin, "#question(labels)[");
                    self.out.push_str("];");
                }
                self.closers.pop();
                self.out.push_str("],\n");
            }
            Mark::End(end) => {
                self.out.push_str(self.closers.pop().unwrap_or(""));
                if matches!(end, TagEnd::Heading(_)) {
                    self.part = Some(self.out.len());
                } else if matches!(end, TagEnd::List(_)) && self.closers.is_empty() {
                    self.keep_together();
                }
            }
            Mark::Text(text) => {
                // Within code it is part of a text in quotes.
                if self.closers.last() == Some(&CODE_END) {
                    let text = quoted(&text);
                    self.out.push_str(&text[1..text.len() - 1]);
                } else {
                    for (piece, whole) in units_apart(&text) {
                        self.out.push_str(if whole { "#box[" } else { "" });
                        escaped(self.out, piece);
                        self.out.push_str(if whole { "];" } else { "" });
                    }
                }
            }
            Mark::Code(text) => {
                let _ = write!(self.out, "#raw({});", quoted(&text));
            }
            Mark::InlineMath(tex) => self.formula(&tex, false)?,
            Mark::DisplayMath(tex) => self.formula(&tex, true)?,
            Mark::SoftBreak => self.out.push('\n'),
            Mark::HardBreak => self.out.push_str("#linebreak();"),
            Mark::Rule => self.out.push_str("#rule();\n\n"),
            Mark::Html(html) | Mark::InlineHtml(html) => self.html(&html)?,
            Mark::FootnoteReference(_) | Mark::TaskListMarker(_) => {
                return Err(Finding::new("", "a note or a box to tick has no translation for print"));
            }
        }
        Ok(())
    }

    fn start(&mut self, tag: Tag) -> Result<(), Finding> {
        match tag {
            Tag::Paragraph => self.open("", "\n\n"),
            Tag::Heading { level, .. } => {
                self.open(&format!("#heading(level: {})[", level as usize), "];\n\n");
            }
            Tag::BlockQuote(_) => self.open("#quote(block: true)[", "];\n\n"),
            Tag::CodeBlock(kind) => {
                let language = match &kind {
                    CodeBlockKind::Fenced(name) if !name.is_empty() => format!("lang: {}, ", quoted(name)),
                    _ => String::new(),
                };
                self.open(&format!("#raw(block: true, {language}\""), CODE_END);
            }
            Tag::List(None) => self.open("#list(", ");\n\n"),
            Tag::List(Some(first)) => self.open(&format!("#enum(start: {first}, "), ");\n\n"),
            Tag::Item => {
                self.open("[", "],\n");
                self.items.push((self.out.len(), false));
            }
            Tag::Table(columns) => {
                self.columns = self.columns.max(columns.len());
                let aligned: Vec<&str> = columns
                    .iter()
                    .map(|c| match c {
                        Alignment::None | Alignment::Left => "left",
                        Alignment::Center => "center",
                        Alignment::Right => "right",
                    })
                    .collect();
                let begin = format!("#table(columns: {}, align: ({},), ", columns.len(), aligned.join(", "));
                self.open(&begin, ");\n\n");
            }
            Tag::TableHead => self.out.push_str("table.header("),
            Tag::TableRow => self.open("", "\n"),
            Tag::TableCell => self.open("[", "], "),
            Tag::Emphasis => self.open("#emph[", "];"),
            Tag::Strong => self.open("#strong[", "];"),
            Tag::Link { dest_url, .. } => self.open(&format!("#link({})[", quoted(&dest_url)), "];"),
            Tag::HtmlBlock => self.open("", "\n"),
            other => {
                return Err(Finding::new("", format!("this has no translation for print: {other:?}")));
            }
        }
        Ok(())
    }

    /// The marks that we know, comments, and breaks of lines.
    fn html(&mut self, html: &str) -> Result<(), Finding> {
        let trimmed = html.trim();
        if trimmed == ANSWER {
            match self.items.last_mut() {
                Some((_, wants)) => *wants = true,
                None => self.out.push_str("#answer(labels);"),
            }
        } else if is_break(trimmed) {
            self.out.push_str("#linebreak();");
        } else if !(trimmed.is_empty() || trimmed.starts_with("<!--")) {
            let fault = Finding::new("", format!("HTML has no translation for print: {trimmed}"));
            return Err(fault.hint("write it in Markdown"));
        }
        Ok(())
    }

    fn picture(&mut self, url: &str, alt: &str) -> Result<(), Finding> {
        let name = url.strip_suffix(".svg").unwrap_or(url);
        let Some(picture) = self.document.picture(name) else {
            return Err(Finding::new("", format!("there is no picture {url} for print")));
        };
        let svg = svg::print(picture);
        let alt = if picture.desc.is_empty() { alt } else { &picture.desc };
        // From CSS pixels to points.
        let width = picture.width * 0.75;
        let _ = write!(self.out, "#picture({}, width: {width}pt, alt: {});", quoted(&svg), quoted(alt));
        Ok(())
    }

    fn formula(&mut self, tex: &str, block: bool) -> Result<(), Finding> {
        let formula = formula(tex, block, self.words)?;
        let gap = if block { " " } else { "" };
        let equation = format!(
            "math.equation(alt: {}, block: {block}, ${}{}{}$)",
            quoted(&formula.alt),
            gap,
            formula.typst.trim(),
            gap
        );
        if block || formula.alt.chars().count() > UNBROKEN {
            let _ = write!(self.out, "#{equation};");
        } else {
            let _ = write!(self.out, "#box({equation});");
        }
        Ok(())
    }
}

/// Ends a block of code; text within it is quoted.
const CODE_END: &str = "\");\n\n";

/// A formula in Typst's way, and in words.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TypstFormula {
    /// What stands between dollars.
    pub typst: String,
    /// What it says, for those who do not see it.
    pub alt: String,
}

/// Translates a formula of TeX. Errors: what cannot be read, and what has no translation.
pub fn formula(tex: &str, block: bool, words: &Words) -> Result<TypstFormula, Finding> {
    let storage = Storage::new();
    let fault = |what: &str| Finding::new("", format!("formula `${tex}$`: {what}"));
    if let Some(what) = unfit(tex) {
        return Err(fault(what));
    }
    let events: Result<Vec<Event>, _> = Parser::new(tex, &storage).collect();
    let events = events.map_err(|e| fault(e.to_string().lines().next().unwrap_or("cannot be read")))?;
    let mut reader = FormulaReader { events: &events, next: 0, words, block };
    let pieces = reader.row(Upright::No, false).map_err(|what| fault(&what))?;
    if reader.next < events.len() {
        return Err(fault("ends before its end"));
    }
    Ok(pieces.joined())
}

/// Is the font upright?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Upright {
    No,
    Yes,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum FormulaPiece {
    /// Upright text or a number: neighbours grow together into one word.
    Word(String),
    /// A comma or point in braces, that is, within a number.
    Mark(char),
    /// Anything else.
    Other(TypstFormula),
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct FormulaRow(Vec<FormulaPiece>);

impl FormulaRow {
    fn push(&mut self, piece: FormulaPiece) {
        match (self.0.last_mut(), piece) {
            (Some(FormulaPiece::Word(word)), FormulaPiece::Word(more)) => word.push_str(&more),
            (Some(FormulaPiece::Word(word)), FormulaPiece::Mark(mark))
                if word.ends_with(|c: char| c.is_ascii_digit()) =>
            {
                word.push(mark);
            }
            (_, piece) => self.0.push(piece),
        }
    }

    fn other(&mut self, typst: impl Into<String>, alt: impl Into<String>) {
        self.push(FormulaPiece::Other(TypstFormula { typst: typst.into(), alt: alt.into() }));
    }

    fn joined(&self) -> TypstFormula {
        let mut all = TypstFormula::default();
        for piece in &self.0 {
            let (typst, alt) = match piece {
                FormulaPiece::Word(word) => (quoted(word), word.clone()),
                FormulaPiece::Mark(mark) => (quoted(&mark.to_string()), mark.to_string()),
                FormulaPiece::Other(formula) => (formula.typst.clone(), formula.alt.clone()),
            };
            // Typst shows a space beside a text in quotes, and none elsewhere.
            if !(all.typst.is_empty() || all.typst.ends_with('"') || typst.starts_with('"')) {
                all.typst.push(' ');
            }
            all.typst.push_str(&typst);
            all.alt.push_str(&alt);
        }
        // Of several spaces one is read aloud.
        all.alt = all.alt.split_whitespace().collect::<Vec<_>>().join(" ");
        all
    }
}

/// Walks the events of a formula.
struct FormulaReader<'e> {
    events: &'e [Event<'e>],
    next: usize,
    words: &'e Words,
    block: bool,
}

impl<'e> FormulaReader<'e> {
    fn take(&mut self) -> Option<&'e Event<'e>> {
        let event = self.events.get(self.next)?;
        self.next += 1;
        Some(event)
    }

    fn peek(&self) -> Option<&'e Event<'e>> {
        self.events.get(self.next)
    }

    /// Elements up to the end of their group, or to a mark of flow if they stand in an environment.
    fn row(&mut self, font: Upright, flows: bool) -> Result<FormulaRow, String> {
        let mut row = FormulaRow::default();
        let mut font = font;
        while let Some(event) = self.peek() {
            match event {
                Event::End => break,
                Event::EnvironmentFlow(_) if flows => break,
                Event::StateChange(change) => {
                    self.next += 1;
                    match change {
                        StateChange::Font(None) => font = Upright::No,
                        StateChange::Font(Some(Font::UpRight)) => font = Upright::Yes,
                        StateChange::Font(Some(other)) => {
                            let rest = self.row(Upright::No, flows)?.joined();
                            row.other(format!("{}({})", font_name(*other)?, rest.typst), rest.alt);
                        }
                        StateChange::Style(style) => {
                            let rest = self.row(font, flows)?.joined();
                            let style = match style {
                                Style::Display => "display",
                                Style::Text => "inline",
                                Style::Script => "script",
                                Style::ScriptScript => "sscript",
                            };
                            row.other(format!("{style}({})", rest.typst), rest.alt);
                        }
                        StateChange::Color(_) => return Err("colours have no translation for print".into()),
                    }
                }
                _ => self.element(font, &mut row)?,
            }
        }
        Ok(row)
    }

    /// The next element by itself.
    fn one(&mut self, font: Upright) -> Result<TypstFormula, String> {
        let mut row = FormulaRow::default();
        self.element(font, &mut row)?;
        Ok(row.joined())
    }

    fn element(&mut self, font: Upright, row: &mut FormulaRow) -> Result<(), String> {
        let Some(event) = self.take() else { return Err("an element is missing".into()) };
        match event {
            Event::Content(content) => self.content(*content, font, row)?,
            Event::Begin(grouping) => self.group(grouping, font, row)?,
            Event::Visual(visual) => self.visual(*visual, font, row)?,
            Event::Script { ty, position } => self.script(*ty, *position, font, row)?,
            Event::Space { width, height: _, depth: _ } => {
                if let Some(width) = width {
                    row.other(format!("#h({})", length(*width)?), " ");
                }
            }
            Event::StateChange(_) => {
                self.next -= 1;
                self.row(font, true)?.0.into_iter().for_each(|piece| row.push(piece));
            }
            Event::End => return Err("a group ends where an element should be".into()),
            Event::EnvironmentFlow(_) => return Err("`&` or `\\\\` where an element should be".into()),
        }
        Ok(())
    }

    fn content(&mut self, content: Content, font: Upright, row: &mut FormulaRow) -> Result<(), String> {
        match content {
            Content::Text("&nbsp;") => row.other("#h(0.25em)", " "),
            Content::Text(text) => {
                let word = text.replace("&nbsp;", "\u{a0}");
                row.other(quoted(&word), word);
            }
            Content::Number(number) => row.push(FormulaPiece::Word(number.to_owned())),
            Content::Function(name) => {
                let limits = matches!(name, "lim" | "max" | "min" | "sup" | "inf" | "lim inf" | "lim sup");
                let limits = if limits { ", limits: #true" } else { "" };
                row.other(format!("op({}{limits})", quoted(name)), format!(" {name} "));
            }
            Content::Ordinary { content, stretchy: _ } => {
                // The micro sign is the letter mu.
                let c = if content == '\u{b5}' { '\u{3bc}' } else { content };
                match (font, c) {
                    (Upright::Yes, c) if c.is_alphanumeric() || matches!(c, '°' | '%' | '/') => {
                        row.push(FormulaPiece::Word(c.to_string()));
                    }
                    (Upright::No, c) if c.is_alphabetic() && !is_upright(c) => row.other(c, c),
                    (_, c) if c.is_alphabetic() => row.other(format!("upright({c})"), c),
                    (_, '′' | '″' | '‴') => row.other(format!("attach(\"\", tr: {c})"), c),
                    (_, c) => row.other(symbol(c), c),
                }
            }
            Content::LargeOp { content, small: _ } => row.other(symbol(content), format!(" {content} ")),
            Content::BinaryOp { content, small: _ } => {
                if font == Upright::Yes && content == '/' {
                    row.push(FormulaPiece::Word("/".to_owned()));
                } else if content == '/' {
                    // As in TeX, tight.
                    row.other("class(\"normal\", \\/)", "/");
                } else {
                    row.other(symbol(content), format!(" {content} "));
                }
            }
            Content::Relation { content, small: _ } => {
                let mut buffer = [0u8; 8];
                let text = String::from_utf8_lossy(content.encode_utf8_to_buf(&mut buffer)).into_owned();
                let mut letters = text.chars();
                match (letters.next(), letters.next()) {
                    (Some(c), None) => row.other(symbol(c), format!(" {c} ")),
                    _ => row.other(format!("class(\"relation\", {})", quoted(&text)), format!(" {text} ")),
                }
            }
            Content::Delimiter { content, size, ty } => {
                let class = match ty {
                    DelimiterType::Open => "opening",
                    DelimiterType::Close => "closing",
                    DelimiterType::Fence => "fence",
                };
                let bare = symbol(content);
                let sized = match size {
                    None => bare,
                    Some(size) => format!("lr({bare}, size: #{}em)", ems(size)),
                };
                row.other(format!("class(\"{class}\", {sized})"), content);
            }
            Content::Punctuation(c) => match (font, c) {
                (Upright::Yes, '.') => row.push(FormulaPiece::Word(".".to_owned())),
                (_, c) => row.other(symbol(c), format!("{c} ")),
            },
        }
        Ok(())
    }

    fn visual(&mut self, visual: Visual, font: Upright, row: &mut FormulaRow) -> Result<(), String> {
        match visual {
            Visual::SquareRoot => {
                let inner = self.one(font)?;
                let alt = self.words.say("print.alt.root", &[("x", &inner.alt)]);
                row.other(format!("sqrt({})", inner.typst), format!(" {alt} "));
            }
            Visual::Root => {
                let inner = self.one(font)?;
                let order = self.one(font)?;
                let pieces = [("n", order.alt.as_str()), ("x", inner.alt.as_str())];
                let alt = self.words.say("print.alt.nth_root", &pieces);
                row.other(format!("root({}, {})", order.typst, inner.typst), format!(" {alt} "));
            }
            Visual::Fraction(None) => {
                let over = self.one(font)?;
                let under = self.one(font)?;
                let alt = format!(" {}/{} ", bracketed(&over.alt), bracketed(&under.alt));
                row.other(format!("frac({}, {})", over.typst, under.typst), alt);
            }
            Visual::Fraction(Some(_)) => return Err("a fraction without its line".into()),
            Visual::Negation => {
                let inner = self.one(font)?;
                row.other(format!("cancel({})", inner.typst), format!(" \u{ac}{} ", inner.alt.trim()));
            }
        }
        Ok(())
    }

    fn script(
        &mut self,
        ty: ScriptType,
        position: ScriptPosition,
        font: Upright,
        row: &mut FormulaRow,
    ) -> Result<(), String> {
        let base = self.one(font)?;
        let over_or_under = position == ScriptPosition::AboveBelow;
        // An accent is a script of one letter above or below.
        if over_or_under && let Some(Event::Content(Content::Ordinary { content, .. })) = self.peek() {
            let accent = match (ty, content) {
                (ScriptType::Superscript, '˙') => Some(("dot", "print.alt.dot")),
                (ScriptType::Superscript, '¨') => Some(("dot.double", "print.alt.double_dot")),
                (ScriptType::Superscript, '→') => Some(("arrow", "print.alt.vector")),
                (ScriptType::Superscript, '‾' | '¯') => Some(("overline", "print.alt.bar")),
                (ScriptType::Superscript, '^') => Some(("hat", "print.alt.hat")),
                (ScriptType::Superscript, '~') => Some(("tilde", "print.alt.tilde")),
                (ScriptType::Subscript, '_' | '‾') => Some(("underline", "print.alt.bar")),
                _ => None,
            };
            let Some((name, phrase)) = accent else {
                return Err(format!("the accent {content} has no translation for print"));
            };
            self.next += 1;
            let alt = self.words.say(phrase, &[("x", base.alt.trim())]);
            row.other(format!("{name}({})", base.typst), format!(" {alt} "));
            return Ok(());
        }
        let (below, above) = match ty {
            ScriptType::Subscript => (Some(self.one(font)?), None),
            ScriptType::Superscript => (None, Some(self.one(font)?)),
            ScriptType::SubSuperscript => {
                let below = self.one(font)?;
                (Some(below), Some(self.one(font)?))
            }
        };
        let limits = over_or_under || position == ScriptPosition::Movable && self.block;
        let mut typst =
            if limits { format!("attach(limits({})", base.typst) } else { format!("attach({}", base.typst) };
        let mut alt = base.alt.trim_end().to_owned();
        let degree = above.as_ref().is_some_and(|a| matches!(a.alt.trim(), "∘" | "°"));
        for (script, at, mark) in [(below, ["br", "b"], '_'), (above, ["tr", "t"], '^')] {
            let Some(script) = script else { continue };
            let _ = write!(typst, ", {}: {}", at[usize::from(limits)], script.typst);
            if mark == '^' && degree {
                alt.push('°');
            } else {
                let _ = write!(alt, "{mark}{}", bracketed(&script.alt));
            }
        }
        typst.push(')');
        let gap = if self.peek().is_some() && !degree { " " } else { "" };
        row.other(typst, format!("{alt}{gap}"));
        Ok(())
    }

    fn group(&mut self, grouping: &Grouping, font: Upright, row: &mut FormulaRow) -> Result<(), String> {
        match grouping {
            Grouping::Normal => {
                let inner = self.row(font, false)?;
                self.end()?;
                match inner.0.as_slice() {
                    // `{,}`: the decimal mark of a number.
                    [FormulaPiece::Other(one)] if one.typst == symbol(',') => {
                        row.push(FormulaPiece::Mark(','))
                    }
                    // Words grow together with their neighbours: `\mathrm{kg}`.
                    [FormulaPiece::Word(word)] => row.push(FormulaPiece::Word(word.clone())),
                    [] => row.other("\"\"", ""),
                    _ => {
                        let inner = inner.joined();
                        row.other(inner.typst, inner.alt);
                    }
                }
            }
            Grouping::LeftRight(open, close) => {
                let inner = self.row(font, false)?.joined();
                self.end()?;
                let side = |c: &Option<char>| c.map_or(String::new(), symbol);
                let letter = |c: &Option<char>| c.map_or(String::new(), |c| c.to_string());
                row.other(
                    format!("lr({} {} {})", side(open), inner.typst, side(close)),
                    format!("{}{}{}", letter(open), inner.alt, letter(close)),
                );
            }
            Grouping::Cases { left: true } => {
                let (rows, alt) = self.rows(" & ")?;
                row.other(format!("cases({})", rows.join(", ")), format!("{{ {alt} }}"));
            }
            Grouping::Matrix { alignment } => {
                let (rows, alt) = self.rows(", ")?;
                row.other(matrix(&rows, *alignment), format!("({alt})"));
            }
            Grouping::Array(columns) => {
                let mut alignments = Vec::new();
                for column in columns {
                    match column {
                        ArrayColumn::Column(alignment) => alignments.push(*alignment),
                        ArrayColumn::Separator(_) => return Err("lines in an array".into()),
                    }
                }
                let first = alignments.first().copied().unwrap_or(ColumnAlignment::Center);
                if alignments.iter().any(|a| *a != first) {
                    return Err("an array whose columns are aligned in different ways".into());
                }
                let (rows, alt) = self.rows(", ")?;
                row.other(matrix(&rows, first), format!("({alt})"));
            }
            Grouping::Aligned
            | Grouping::Align { .. }
            | Grouping::Alignedat { .. }
            | Grouping::Alignat { .. }
            | Grouping::Split
            | Grouping::Gather { .. }
            | Grouping::Gathered
            | Grouping::Multline
            | Grouping::Equation { .. } => {
                let whole = self.next == 1 && row.0.is_empty();
                let (rows, alt) = self.rows(" & ")?;
                if whole && self.next == self.events.len() {
                    row.other(rows.join(" \\\n"), alt);
                } else {
                    let rows: Vec<String> = rows.iter().map(|r| format!("display({r})")).collect();
                    row.other(format!("mat(delim: #none, {})", rows.join("; ")), alt);
                }
            }
            other => return Err(format!("this environment has no translation for print: {other:?}")),
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), String> {
        match self.take() {
            Some(Event::End) => Ok(()),
            _ => Err("a group does not end".into()),
        }
    }

    /// Rows of an environment, cells joined; its end is taken too. An empty row at the end is none.
    fn rows(&mut self, between: &str) -> Result<(Vec<String>, String), String> {
        let mut rows: Vec<Vec<TypstFormula>> = vec![Vec::new()];
        loop {
            let cell = self.row(Upright::No, true)?.joined();
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            match self.take() {
                Some(Event::EnvironmentFlow(EnvironmentFlow::Alignment)) => {}
                Some(Event::EnvironmentFlow(EnvironmentFlow::NewLine { horizontal_lines, .. })) => {
                    if !horizontal_lines.is_empty() {
                        return Err("lines in an environment".into());
                    }
                    rows.push(Vec::new());
                }
                Some(Event::EnvironmentFlow(EnvironmentFlow::StartLines { .. })) => {
                    return Err("lines in an environment".into());
                }
                Some(Event::End) => break,
                _ => return Err("an environment does not end".into()),
            }
        }
        if rows.len() > 1 && rows.last().is_some_and(|r| r.iter().all(|c| c.typst.is_empty())) {
            rows.pop();
        }
        let alt: Vec<String> = rows
            .iter()
            .map(|r| r.iter().map(|c| c.alt.trim()).collect::<Vec<_>>().join(" ").trim().to_owned())
            .collect();
        let texts = rows
            .iter()
            .map(|r| r.iter().map(|c| c.typst.as_str()).collect::<Vec<_>>().join(between))
            .collect();
        Ok((texts, alt.join("; ")))
    }
}

fn matrix(rows: &[String], alignment: ColumnAlignment) -> String {
    let alignment = match alignment {
        ColumnAlignment::Left => "left",
        ColumnAlignment::Center => "center",
        ColumnAlignment::Right => "right",
    };
    format!("mat(delim: #none, align: #{alignment}, {})", rows.join("; "))
}

/// A character that stands for itself.
fn symbol(c: char) -> String {
    match c {
        '-' => "−".to_owned(),
        '*' => "∗".to_owned(),
        '=' | '+' | '<' | '>' => c.to_string(),
        c if c.is_ascii_punctuation() => format!("\\{c}"),
        c => c.to_string(),
    }
}

/// Capital Greek letters stand upright, as in TeX.
fn is_upright(c: char) -> bool {
    ('Α'..='Ω').contains(&c)
}

/// In brackets unless it is one thing.
fn bracketed(alt: &str) -> String {
    let alt = alt.trim();
    let one = alt.chars().all(|c| c.is_alphanumeric() || matches!(c, '.' | ',' | '′'));
    if one || alt.starts_with('(') && alt.ends_with(')') && alt.matches('(').count() == 1 {
        alt.to_owned()
    } else {
        format!("({alt})")
    }
}

fn font_name(font: Font) -> Result<&'static str, String> {
    match font {
        Font::Bold | Font::BoldSymbol | Font::BoldItalic => Ok("bold"),
        Font::Italic => Ok("italic"),
        Font::Script => Ok("cal"),
        Font::DoubleStruck => Ok("bb"),
        Font::Fraktur => Ok("frak"),
        Font::SansSerif => Ok("sans"),
        Font::Monospace => Ok("mono"),
        other => Err(format!("the font {other:?} has no translation for print")),
    }
}

fn ems(size: DelimiterSize) -> f64 {
    match size {
        DelimiterSize::Big => 1.2,
        DelimiterSize::BIG => 1.8,
        DelimiterSize::Bigg => 2.4,
        DelimiterSize::BIGG => 3.0,
    }
}

/// A length of TeX; `mu` is an eighteenth of an em.
fn length(dimension: Dimension) -> Result<String, String> {
    let value = f64::from(dimension.value);
    Ok(match dimension.unit {
        DimensionUnit::Em => format!("{value:.4}em"),
        DimensionUnit::Mu => format!("{:.4}em", value / 18.0),
        DimensionUnit::Ex => format!("{:.4}em", value * 0.45),
        DimensionUnit::Pt | DimensionUnit::Bp => format!("{value:.4}pt"),
        DimensionUnit::Mm => format!("{value:.4}mm"),
        DimensionUnit::Cm => format!("{value:.4}cm"),
        DimensionUnit::In => format!("{value:.4}in"),
        other => return Err(format!("the unit {other:?} has no translation for print")),
    })
}
