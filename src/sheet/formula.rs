//! Formulas of TeX: what may stand in one, how wide one is, and each as MathML.
use crate::picture::svg::escaped;
use crate::picture::symbol::group;
use crate::sheet::document::MARKDOWN;
use pulldown_cmark::{Event, Parser};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::event::{Content, Event as Piece};
use pulldown_latex::{RenderConfig, Storage};
use rustc_hash::FxHashMap;

/// A formula on a line of its own that has more signs than this may be wider than a phone, and scrolls by itself.
pub const PHONE: usize = 28;
/// One with more signs than this is set smaller on paper, so that it fits.
pub const PAPER: usize = 70;

/// Formulas remembered at most, so that memory does not grow with the class.
const REMEMBERED: usize = 4096;

/// Formulas within lines as HTML, remembered: the same few occur in every sheet.
#[derive(Default)]
pub struct FormulaCache(FxHashMap<String, String>);

impl FormulaCache {
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

/// A formula within a line, or on a line of its own, as MathML.
pub fn formula(tex: &str, of_its_own: bool) -> String {
    mathml(tex, if of_its_own { DisplayMode::Block } else { DisplayMode::Inline })
}

/// The formulas that stand beside each other in one displayed line.
pub fn beside(tex: &str) -> Vec<String> {
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
            Ok(Piece::Content(Content::Text(text)))
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
    fn the_width_of_a_formula_is_that_of_its_widest_line() {
        assert_eq!(signs(r"\frac{a + b}{c}"), 3);
        assert_eq!(signs(r"\begin{aligned} a &= b \\\\ &= c + d \end{aligned}"), 4);
        assert_eq!(signs(r"\omega = 1{,}5\ \mathrm{rad}"), 9);
    }
}
