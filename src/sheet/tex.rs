//! Markdown with math and pictures to LaTeX with TikZ, for those who paste into documents of their own.
use crate::finding::Finding;
use crate::picture::tikz;
use crate::sheet::document::{ANSWER, Document, Head, MARKDOWN, is_break, kept_together};
use crate::sheet::formula::{PAPER, fault_of, signs};
use crate::template::{self, Templates, View};
use crate::words::Words;
use pulldown_cmark::{Alignment, Event, HeadingLevel, Parser, Tag, TagEnd};

/// A whole document of LaTeX. Errors: faults of the templates.
pub fn page(templates: &Templates, words: &Words, head: &Head, body: &str) -> Result<Vec<u8>, Finding> {
    let mut view = View::new();
    view.foreign("title", &[head.title.as_str(), &head.student].join(", "));
    view.text("running", &running_head(head));
    view.text("body", body.trim_end());
    view.text("babel", babel(words));
    view.text("language", words.language());
    templates.made("sheet.tex", &view)
}

/// One document of LaTeX with all of a set, each from a new page. Errors: faults of the templates.
pub fn booklet<'p>(
    templates: &Templates,
    words: &Words,
    title: &str,
    parts: impl Iterator<Item = (&'p Head, &'p str)>,
) -> Result<Vec<u8>, Finding> {
    let mut view = View::new();
    view.foreign("title", title);
    let list = parts
        .map(|(head, body)| template::texts([("running", &running_head(head)), ("body", body.trim_end())]));
    view.value("sheets", template::list(list));
    view.text("babel", babel(words));
    view.text("language", words.language());
    templates.made("booklet.tex", &view)
}

/// Name of the language for the package babel.
fn babel(words: &Words) -> &'static str {
    match words.language() {
        "de" => "ngerman",
        _ => "english",
    }
}

/// The text at the head of a printed page.
fn running_head(head: &Head) -> String {
    head.running().map(template::in_tex).collect::<Vec<_>>().join(r" \textperiodcentered{} ")
}

/// Sets a picture; two that follow each other stand beside each other.
const PLACE: &str = "\\pictureplace";

/// The body of a document.
pub fn body(document: &Document) -> String {
    let mut out = String::with_capacity(document.markdown.len() * 2);
    let (mut columns, mut cell, mut in_code) = (Vec::new(), 0, false);
    // Where the last picture stands that has none beside it.
    let mut alone: Option<std::ops::Range<usize>> = None;
    let mut events = Parser::new_ext(&document.markdown, MARKDOWN);
    while let Some(event) = events.next() {
        match event {
            Event::Start(Tag::Table(alignments)) => {
                out.push_str("\n\\begin{center}\\begin{tabular}{");
                for a in &alignments {
                    out.push(match a {
                        Alignment::Right => 'r',
                        Alignment::Center => 'c',
                        Alignment::Left | Alignment::None => 'l',
                    });
                }
                out.push_str("}\n");
                columns = alignments;
            }
            Event::Start(Tag::TableHead | Tag::TableRow) => cell = 0,
            Event::Start(Tag::TableCell) => {
                if cell > 0 && cell < columns.len() {
                    out.push_str(" & ");
                }
                cell += 1;
            }
            Event::Start(Tag::Image { dest_url, .. }) => {
                // What it shows stands beside it only where it cannot be shown.
                let name = dest_url.strip_suffix(".svg").unwrap_or(&dest_url).to_owned();
                let mut alt = String::new();
                for inner in events.by_ref() {
                    match inner {
                        Event::End(TagEnd::Image) => break,
                        Event::Text(text) | Event::Code(text) => alt.push_str(&text),
                        _ => {}
                    }
                }
                match document.picture(&name) {
                    Some(picture) => {
                        let beside = alone.take().filter(|last| out[last.end..].trim().is_empty());
                        if let Some(last) = &beside {
                            out.truncate(last.end);
                            out.replace_range(last.start..last.start + PLACE.len(), "\\picturesbeside");
                        }
                        let start = out.len();
                        let place = if beside.is_some() { "" } else { PLACE };
                        out.extend([place, "{%\n", tikz::picture(picture).trim_end(), "}"]);
                        alone = beside.is_none().then_some(start..out.len());
                    }
                    None => out.push_str(&template::in_tex(&alt)),
                }
            }
            // LaTeX carries out whatever stands in a formula: what is none is shown as it was written.
            Event::InlineMath(tex) | Event::DisplayMath(tex) if fault_of(&tex).is_some() => {
                out.extend(["\\code{", &code(&tex), "}"]);
            }
            Event::InlineMath(tex) => out.extend(["$", &tex, "$"]),
            Event::DisplayMath(tex) if signs(&tex) > PAPER => {
                out.extend(["\\[\\wideformula{", tex.trim(), "}\\]"]);
            }
            Event::DisplayMath(tex) => out.extend(["\\[", tex.trim(), "\\]"]),
            Event::Code(text) => out.extend(["\\code{", &code(&text), "}"]),
            Event::Text(text) if in_code => {
                let lines: Vec<String> = text.trim_end().lines().map(code).collect();
                out.push_str(&lines.join("\\\\\n"));
                out.push('\n');
            }
            Event::Text(text) => out.push_str(&template::in_tex(&kept_together(&text))),
            Event::Html(text) | Event::InlineHtml(text) => {
                if text.trim() == ANSWER {
                    out.push_str("\\answerroom");
                } else if is_break(&text) {
                    out.push_str("\\\\\n");
                }
            }
            Event::SoftBreak => out.push('\n'),
            Event::HardBreak => out.push_str("\\\\\n"),
            Event::Start(tag) => {
                in_code |= matches!(tag, Tag::CodeBlock(_));
                out.push_str(around(tag.to_end()).0);
            }
            Event::End(tag) => {
                in_code &= tag != TagEnd::CodeBlock;
                out.push_str(around(tag).1);
            }
            Event::Rule => out.push_str("\n\\medskip\\hrule\\medskip\n"),
            _ => {}
        }
    }
    out
}

/// What stands before and after an element.
fn around(element: TagEnd) -> (&'static str, &'static str) {
    match element {
        TagEnd::Paragraph => ("\n", "\n"),
        TagEnd::Heading(HeadingLevel::H1) => ("\n\\sheetsection{", "}\n"),
        TagEnd::Heading(HeadingLevel::H2) => ("\n\\problemsection{", "}\n"),
        TagEnd::Heading(HeadingLevel::H3) => ("\n\\stepsection{", "}\n"),
        TagEnd::Heading(_) => ("\n\\lowersection{", "}\n"),
        TagEnd::BlockQuote(_) => ("\n\\begin{quote}", "\\end{quote}\n"),
        TagEnd::CodeBlock => ("\n\\begin{quote}\\ttfamily\\small\n", "\\end{quote}\n"),
        TagEnd::List(true) => ("\n\\begin{enumerate}\n", "\\end{enumerate}\n"),
        TagEnd::List(false) => ("\n\\begin{itemize}\n", "\\end{itemize}\n"),
        TagEnd::Item => ("\\item ", "\n"),
        TagEnd::Table => ("", "\\hline\n\\end{tabular}\\end{center}\n"),
        TagEnd::TableHead => ("", " \\\\ \\hline\n"),
        TagEnd::TableRow => ("", " \\\\\n"),
        TagEnd::Emphasis => ("\\emph{", "}"),
        TagEnd::Strong => ("\\textbf{", "}"),
        _ => ("", ""),
    }
}

/// A text in typewriter letters: its quotation marks are straight, its blanks stay.
fn code(text: &str) -> String {
    template::in_tex(text).replace('\'', r"\textquotesingle{}").replace(' ', r"\ ")
}
