//! A document as strict XHTML, in pieces: between them stand the places for answers and the pictures, of which each format makes
//! its own. Only elements that QTI 2.1 knows, too.
use crate::picture::svg::escaped;
use crate::sheet::document::{ANSWER, Document, is_break};
use crate::sheet::formula::FormulaCache;
use crate::sheet::html::MARKDOWN;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// A piece of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// XHTML; tags may open in one piece and close in another.
    Text(String),
    /// Place for the answer to the part of this index.
    Answer(usize),
    /// The picture of this index.
    Picture(usize),
    ListItem(Vec<Piece>),
}

/// A text in pieces.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ItemText {
    pieces: Vec<Piece>,
}

/// Turns documents into bodies and remembers formulas, as [`crate::sheet::html::Converter`] does.
#[derive(Default)]
pub struct BodyWriter {
    formulas: FormulaCache,
}

/// Lists within lists whose items are pieces of their own at most.
const DEEPEST: usize = 30;

impl BodyWriter {
    /// The body of a document; `parts` are the names of parts for which it has places, `1.omega`.
    pub fn body(&mut self, document: &Document, parts: &[String]) -> ItemText {
        let mut events = Parser::new_ext(&document.markdown, MARKDOWN);
        let mut walk = BodyWalk { document, parts, named: None, placed: Vec::new() };
        let mut pieces = self.pieces(&mut events, &mut walk, 0);
        // A text of one's own may leave no place behind the name of a part.
        for (i, part) in parts.iter().enumerate().filter(|(i, _)| !walk.placed.contains(i)) {
            let begin = format!("<p><code>{}</code> ", escaped(part));
            pieces.push(Piece::ListItem(vec![
                Piece::Text(begin),
                Piece::Answer(i),
                Piece::Text("</p>\n".to_owned()),
            ]));
        }
        ItemText { pieces }
    }

    /// The pieces up to the end of the list item that is open, or of the text.
    fn pieces<'e>(&mut self, events: &mut Parser<'e>, walk: &mut BodyWalk, depth: usize) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut ready: Vec<Event<'e>> = Vec::new();
        let (mut in_picture, mut too_deep) = (0, 0usize);
        while let Some(event) = events.next() {
            if in_picture > 0 {
                in_picture += match event {
                    Event::Start(Tag::Image { .. }) => 1,
                    Event::End(TagEnd::Image) => -1,
                    _ => 0,
                };
                continue;
            }
            let inline = |xhtml: String| Event::InlineHtml(xhtml.into());
            match event {
                Event::Start(Tag::Item) if depth < DEEPEST => {
                    flush(&mut ready, &mut pieces);
                    let mut item = vec![Piece::Text("<li>".to_owned())];
                    item.extend(self.pieces(events, walk, depth + 1));
                    item.push(Piece::Text("</li>\n".to_owned()));
                    pieces.push(Piece::ListItem(item));
                }
                Event::End(TagEnd::Item) if too_deep == 0 => break,
                Event::Start(Tag::Item) => {
                    too_deep += 1;
                    ready.push(event);
                }
                Event::End(TagEnd::Item) => {
                    too_deep -= 1;
                    ready.push(event);
                }
                // The numbers of what is left of a list begin with 1.
                Event::Start(Tag::List(Some(_))) => ready.push(Event::Start(Tag::List(Some(1)))),
                Event::Start(Tag::Image { ref dest_url, .. }) => {
                    let name = dest_url.strip_suffix(".svg").unwrap_or_default();
                    // Of a picture that is not there the description is kept.
                    if let Some(i) = walk.document.pictures.iter().position(|(n, _)| n == name) {
                        flush(&mut ready, &mut pieces);
                        pieces.push(Piece::Picture(i));
                        in_picture = 1;
                    }
                }
                Event::End(TagEnd::Image) => {}
                Event::Html(text) | Event::InlineHtml(text) => {
                    let text = text.trim();
                    if is_break(text) {
                        ready.push(inline("<br/>\n".to_owned()));
                    } else if text == ANSWER
                        && let Some(part) = walk.named.take().filter(|part| !walk.placed.contains(part))
                    {
                        walk.placed.push(part);
                        flush(&mut ready, &mut pieces);
                        pieces.push(Piece::Answer(part));
                    }
                }
                Event::HardBreak => ready.push(inline("<br/>\n".to_owned())),
                Event::Rule => ready.push(inline("<hr/>\n".to_owned())),
                Event::InlineMath(tex) => ready.push(inline(self.formulas.html(&tex, false))),
                Event::DisplayMath(tex) => ready.push(inline(self.formulas.html(&tex, true))),
                Event::Code(name) => {
                    // A place for an answer belongs to the part that was named last.
                    walk.named = walk.parts.iter().position(|part| **part == *name).or(walk.named);
                    ready.push(Event::Code(name));
                }
                // Columns lean by a style, which QTI 2.1 does not have.
                Event::Start(Tag::Table(_)) => ready.push(inline("<table>".to_owned())),
                Event::Start(Tag::TableHead) => ready.push(inline("<thead><tr>".to_owned())),
                Event::End(TagEnd::TableHead) => ready.push(inline("</tr></thead>\n<tbody>".to_owned())),
                Event::Start(Tag::TableRow) => ready.push(inline("<tr>".to_owned())),
                Event::End(TagEnd::TableRow) => ready.push(inline("</tr>\n".to_owned())),
                Event::Start(Tag::TableCell) => ready.push(inline("<td>".to_owned())),
                Event::End(TagEnd::TableCell) => ready.push(inline("</td>".to_owned())),
                Event::End(TagEnd::Table) => ready.push(inline("</tbody></table>\n".to_owned())),
                other => ready.push(other),
            }
        }
        flush(&mut ready, &mut pieces);
        pieces
    }
}

/// What is known on the way through a document.
struct BodyWalk<'w> {
    document: &'w Document,
    parts: &'w [String],
    /// The part that was named last and has no place yet.
    named: Option<usize>,
    /// The parts that have one.
    placed: Vec<usize>,
}

/// What is ready becomes a piece.
fn flush(ready: &mut Vec<Event>, pieces: &mut Vec<Piece>) {
    if !ready.is_empty() {
        let mut text = String::new();
        pulldown_cmark::html::push_html(&mut text, ready.drain(..));
        pieces.push(Piece::Text(text));
    }
}

impl ItemText {
    /// The text as one. With `only` the questions of other parts are left out: items of lists with places for their answers.
    pub fn text(
        &self,
        only: Option<usize>,
        answer: &mut dyn FnMut(usize) -> String,
        picture: &dyn Fn(usize) -> String,
    ) -> String {
        let mut out = String::new();
        write(&self.pieces, only, &mut |piece| match piece {
            Piece::Text(text) => out.push_str(text),
            Piece::Answer(i) => out.push_str(&answer(*i)),
            Piece::Picture(i) => out.push_str(&picture(*i)),
            Piece::ListItem(_) => {}
        });
        out
    }
}

fn write(pieces: &[Piece], only: Option<usize>, tell: &mut dyn FnMut(&Piece)) {
    for piece in pieces {
        match piece {
            Piece::ListItem(inside) => {
                let mut asked = Vec::new();
                write(inside, None, &mut |piece| {
                    if let Piece::Answer(part) = piece {
                        asked.push(*part);
                    }
                });
                if asked.is_empty() || only.is_none_or(|part| asked.contains(&part)) {
                    write(inside, only, tell);
                }
            }
            other => tell(other),
        }
    }
}
