//! Markdown with math to HTML with MathML. The Markdown text is the only source.
use pulldown_cmark::CowStr;
use pulldown_cmark::Event;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use pulldown_latex::RenderConfig;
use pulldown_latex::Storage;
use pulldown_latex::config::DisplayMode;
use rustc_hash::FxHashMap;

/// Turns Markdown into HTML and remembers formulas: the same few occur in every sheet.
#[derive(Default)]
pub struct Converter {
    formulas: FxHashMap<String, String>,
}

/// Formulas remembered at most, so that memory does not grow with the class.
const REMEMBERED: usize = 4096;

impl Converter {
    /// The body of a page.
    pub fn body(&mut self, markdown: &str) -> String {
        let options = Options::ENABLE_MATH | Options::ENABLE_TABLES;
        let mut out = String::with_capacity(markdown.len() * 4);
        let events = Parser::new_ext(markdown, options).map(|event| match event {
            Event::InlineMath(tex) => Event::InlineHtml(self.formula(&tex, DisplayMode::Inline)),
            Event::DisplayMath(tex) => Event::InlineHtml(self.formula(&tex, DisplayMode::Block)),
            event => event,
        });
        // A wide table scrolls by itself and not with the page.
        let events = events.flat_map(|event| match event {
            Event::Start(Tag::Table(_)) => [Some(Event::Html("<div class=\"wide\">".into())), Some(event)],
            Event::End(TagEnd::Table) => [Some(event), Some(Event::Html("</div>\n".into()))],
            event => [Some(event), None],
        });
        pulldown_cmark::html::push_html(&mut out, events.flatten());
        out
    }

    fn formula<'e>(&mut self, tex: &str, display_mode: DisplayMode) -> CowStr<'e> {
        let inline = display_mode == DisplayMode::Inline;
        if inline && let Some(known) = self.formulas.get(tex) {
            return known.clone().into();
        }
        let html = mathml(tex, display_mode);
        if inline {
            if self.formulas.len() >= REMEMBERED {
                self.formulas.clear();
            }
            self.formulas.insert(tex.to_owned(), html.clone());
        }
        html.into()
    }
}

/// A formula as MathML; one that cannot be read is shown as it was written.
fn mathml(tex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let parser = pulldown_latex::Parser::new(tex, &storage);
    let mut out = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    match pulldown_latex::push_mathml(&mut out, parser, config) {
        Ok(()) => tidy(&out),
        Err(_) => {
            let mut shown = String::from("<code>");
            for c in tex.chars() {
                match c {
                    '<' => shown.push_str("&lt;"),
                    '>' => shown.push_str("&gt;"),
                    '&' => shown.push_str("&amp;"),
                    c => shown.push(c),
                }
            }
            shown.push_str("</code>");
            shown
        }
    }
}

/// What the writer of MathML leaves ugly: escaped spaces, the micro sign for the letter mu, wide slashes in units.
fn tidy(mathml: &str) -> String {
    mathml
        .replace("&amp;nbsp;", "\u{a0}")
        .replace('\u{b5}', "\u{3bc}")
        .replace("<mo>/</mo>", "<mo lspace=\"0\" rspace=\"0\">/</mo>")
}

/// Says what is wrong with the formulas of a Markdown text, one sentence each.
pub fn faulty_formulas(markdown: &str) -> Vec<String> {
    let storage = Storage::new();
    Parser::new_ext(markdown, Options::ENABLE_MATH | Options::ENABLE_TABLES)
        .filter_map(|event| match event {
            Event::InlineMath(tex) | Event::DisplayMath(tex) => Some(tex),
            _ => None,
        })
        .filter_map(|tex| {
            let fault = pulldown_latex::Parser::new(&tex, &storage).find_map(Result::err)?;
            let words = fault.to_string();
            Some(format!("`${tex}$`: {}", words.lines().next().unwrap_or("cannot be read")))
        })
        .collect()
}
