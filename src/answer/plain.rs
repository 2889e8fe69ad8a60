//! A cell in one alphabet: ASCII digits and marks, one kind of blank, minus and bracket; nothing invisible, and nothing of what web
//! pages, TeX and spreadsheets wrap around a text.
use crate::num::decimal::one_of;

/// A cell in plain text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct PlainText {
    pub text: String,
    /// It had digits of another script.
    pub foreign: bool,
}

pub(crate) fn plain(cell: &str) -> PlainText {
    let mut written = std::borrow::Cow::Borrowed(cell);
    if written.contains(one_of("&<")) {
        // Twice: what a page escaped, a second page escapes again.
        written = without_html(&without_html(&written)).into();
    }
    if written.contains(one_of("\\$")) {
        written = without_tex(&written).into();
    }
    let (mut text, mut foreign) = (String::with_capacity(written.len()), false);
    for c in written.chars() {
        // Full width as in East Asian texts.
        let c = match c {
            '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - 0xfee0).unwrap_or(c),
            c => c,
        };
        match c {
            '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}' | '\u{ad}' | '\u{61c}' => {}
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {}
            '\u{2010}'..='\u{2015}' | '\u{2212}' | '\u{2d7}' | '\u{2796}' | '\u{fe63}' => text.push('-'),
            c if c.is_whitespace() => text.push(' '),
            '‘' | '’' | '‛' | 'ʼ' | '`' | '´' | '\u{66c}' => text.push('\''),
            '“' | '”' | '„' => text.push('"'),
            '\u{66b}' => text.push('.'),
            '\u{60c}' | '、' => text.push(','),
            '\u{66a}' => text.push('%'),
            '[' | '{' | '⟨' | '〈' | '〔' | '【' | '「' => text.push('('),
            ']' | '}' | '⟩' | '〉' | '〕' | '】' | '」' => text.push(')'),
            '\u{2044}' | '\u{2215}' | '÷' => text.push('/'),
            '\u{2191}' => text.push_str(" up "),
            '\u{2193}' => text.push_str(" down "),
            c if c.is_ascii() => text.push(c),
            c => match (digit(c), fraction(c)) {
                (Some(digit), _) => {
                    foreign = true;
                    text.push(digit);
                }
                // Blanks keep it apart from its neighbours: 1½ is 1 1/2.
                (_, Some(fraction)) => text.extend([" ", fraction, " "]),
                _ => text.push(c),
            },
        }
    }
    PlainText { text: unwrapped(text.trim()).to_owned(), foreign }
}

/// Without quotes and what else spreadsheets and sentences put around a value.
fn unwrapped(text: &str) -> &str {
    let mut text = text;
    if let Some(inside) = text.strip_prefix("=\"").and_then(|t| t.strip_suffix('"')) {
        text = inside.trim();
    } else if text.len() >= 2
        && let Some(inside) = text.strip_prefix('"').and_then(|t| t.strip_suffix('"'))
    {
        text = inside.trim();
    }
    let text = text.strip_prefix('\'').unwrap_or(text).trim();
    text.strip_suffix(one_of(".;,")).unwrap_or(text).trim_end()
}

/// Where the digits of a script begin; each has ten in order (Unicode 16, category Nd, those that are written today).
const ZEROS: [u32; 25] = [
    0x660, 0x6f0, 0x7c0, 0x966, 0x9e6, 0xa66, 0xae6, 0xb66, 0xbe6, 0xc66, 0xce6, 0xd66, 0xe50, 0xed0, 0xf20,
    0x1040, 0x17e0, 0x1810, 0x1946, 0xa9d0, 0x1d7ce, 0x1d7d8, 0x1d7e2, 0x1d7ec, 0x1d7f6,
];

fn digit(c: char) -> Option<char> {
    let code = u32::from(c);
    let zero = ZEROS.iter().find(|zero| (**zero..**zero + 10).contains(&code))?;
    char::from_digit(code - zero, 10)
}

fn fraction(c: char) -> Option<&'static str> {
    #[rustfmt::skip] // a table
    const FRACTIONS: [(char, &str); 18] = [
        ('½', "1/2"), ('⅓', "1/3"), ('⅔', "2/3"), ('¼', "1/4"), ('¾', "3/4"), ('⅕', "1/5"), ('⅖', "2/5"),
        ('⅗', "3/5"), ('⅘', "4/5"), ('⅙', "1/6"), ('⅚', "5/6"), ('⅐', "1/7"), ('⅛', "1/8"), ('⅜', "3/8"),
        ('⅝', "5/8"), ('⅞', "7/8"), ('⅑', "1/9"), ('⅒', "1/10"),
    ];
    FRACTIONS.iter().find(|(f, _)| *f == c).map(|(_, text)| *text)
}

/// Entities that stand in numbers, units and the words around them.
#[rustfmt::skip] // a table
const ENTITIES: &[(&str, &str)] = &[
    ("nbsp", " "), ("ensp", " "), ("emsp", " "), ("thinsp", " "), ("amp", "&"), ("lt", "<"), ("gt", ">"),
    ("quot", "\""), ("apos", "'"), ("lsquo", "'"), ("rsquo", "'"), ("minus", "-"), ("ndash", "-"),
    ("mdash", "-"), ("plus", "+"), ("plusmn", "±"), ("pm", "±"), ("times", "×"), ("middot", "·"),
    ("sdot", "⋅"), ("divide", "/"), ("frasl", "/"), ("sol", "/"), ("deg", "°"), ("micro", "µ"), ("mu", "μ"),
    ("pi", "π"), ("omega", "ω"), ("radic", "√"), ("asymp", "≈"), ("sup1", "¹"), ("sup2", "²"),
    ("sup3", "³"), ("frac12", "½"), ("frac14", "¼"), ("frac34", "¾"), ("uarr", "↑"), ("darr", "↓"),
    ("auml", "ä"), ("uuml", "ü"), ("percnt", "%"), ("period", "."), ("comma", ","), ("equals", "="),
    ("shy", ""), ("zwnj", ""), ("zwj", ""),
];

/// Entities as characters, raised numbers with `^`, other tags as blanks. What is neither stays.
fn without_html(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(one_of("&<")) {
        out.push_str(&rest[..at]);
        let (mark, behind) = rest[at..].split_at(1);
        let end = if mark == "&" { ';' } else { '>' };
        let inside = behind.split_once(end).map(|(inside, _)| inside);
        let read = inside.and_then(|inside| {
            let said = if mark == "&" { entity(inside)? } else { tag(inside)?.to_owned() };
            Some((said, &behind[inside.len() + 1..]))
        });
        match read {
            Some((said, behind)) => {
                out.push_str(&said);
                rest = behind;
            }
            None => {
                out.push_str(mark);
                rest = behind;
            }
        }
    }
    out.push_str(rest);
    out
}

fn entity(name: &str) -> Option<String> {
    if let Some(number) = name.strip_prefix('#') {
        let code = match number.strip_prefix(one_of("xX")) {
            Some(hex) => u32::from_str_radix(hex, 16).ok()?,
            None => number.parse().ok()?,
        };
        return char::from_u32(code).map(String::from);
    }
    ENTITIES.iter().find(|(n, _)| *n == name).map(|(_, said)| (*said).to_owned())
}

/// What stands for a tag, by the text between its brackets.
fn tag(inside: &str) -> Option<&'static str> {
    let closing = inside.starts_with('/');
    let name = inside.trim_start_matches('/');
    let name = &name[..name.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(name.len())];
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    Some(match (name.to_ascii_lowercase().as_str(), closing) {
        ("sup", false) => "^(",
        ("sub", false) => "_(",
        ("sup" | "sub", true) => ")",
        ("b" | "i" | "em" | "strong" | "span" | "font" | "u", _) => "",
        _ => " ",
    })
}

/// LaTeX such as `$47.3$\\ \\mathrm{rad/s}` as plain text.
fn without_tex(text: &str) -> String {
    #[rustfmt::skip] // a table
    const PLAIN: &[(&str, &str)] = &[
        ("$", ""), ("^{\\circ}", "°"), ("^\\circ", "°"), ("\\degree", "°"), ("{,}", ","), ("\\mathrm", ""),
        ("\\textrm", ""), ("\\text", ""), ("\\rm", ""), ("\\left", ""), ("\\right", ""), ("\\qquad", " "),
        ("\\quad", " "), ("\\cdot", "·"), ("\\times", "×"), ("\\approx", "≈"), ("\\uparrow", " up "),
        ("\\downarrow", " down "), ("\\pm", "±"), ("\\pi", "π"), ("\\%", "%"), ("\\ ", " "), ("\\,", " "),
        ("\\;", " "), ("\\:", " "), ("\\!", ""), ("\\(", ""), ("\\)", ""),
    ];
    let mut text = text.to_owned();
    // Each turn takes one backslash away.
    while let Some(written) = call(&text) {
        text = written;
    }
    for (from, to) in PLAIN {
        text = text.replace(from, to);
    }
    let mut out = String::with_capacity(text.len());
    let mut raised = false; // inside ^{ }
    for c in text.chars() {
        match c {
            '{' if out.ends_with('^') => {
                raised = true;
                out.push('(');
            }
            '}' if raised => {
                raised = false;
                out.push(')');
            }
            '{' | '}' => {}
            c => out.push(c),
        }
    }
    out
}

/// The first `\sqrt{2}` as `sqrt(2)` or `\frac{3}{4}` as `(3)/(4)`; `None` where there is none.
fn call(text: &str) -> Option<String> {
    let (at, name) = ["\\sqrt", "\\dfrac", "\\tfrac", "\\frac"]
        .into_iter()
        .filter_map(|name| text.find(name).map(|at| (at, name)))
        .min()?;
    let (before, behind) = (&text[..at], &text[at + name.len()..]);
    // `{...}` or a single character
    let argument = |text: &str| -> Option<(String, String)> {
        let text = text.trim_start();
        let mut depth = 0usize;
        for (i, c) in text.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth = depth.checked_sub(1)?,
                _ => {}
            }
            if depth == 0 {
                let end = i + c.len_utf8();
                let inside = &text[..end];
                let inside = inside.strip_prefix('{').and_then(|t| t.strip_suffix('}')).unwrap_or(inside);
                return Some((inside.to_owned(), text[end..].to_owned()));
            }
        }
        None
    };
    let read = || {
        let (first, rest) = argument(behind)?;
        if name == "\\sqrt" {
            return Some(format!("{before}sqrt({first}){rest}"));
        }
        let (second, rest) = argument(&rest)?;
        Some(format!("{before}({first})/({second}){rest}"))
    };
    Some(read().unwrap_or_else(|| format!("{before}?{behind}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_alphabet() {
        for (cell, text) in [
            ("34.65&nbsp;rad/s", "34.65 rad/s"),
            ("34.65&amp;nbsp;rad/s", "34.65 rad/s"),
            ("&#51;4&#x2e;65 &plusmn; 1", "34.65 ± 1"),
            ("<p>4.5 m/s<sup>2</sup></p>", "4.5 m/s^(2)"),
            ("5 < 6 & 7", "5 < 6 & 7"),
            ("٣٤٫٦٥", "34.65"),
            ("۱۲٬۸۷۷", "12'877"),
            ("１２，８７６．９　ｍｍ", "12,876.9 mm"),
            ("1½ m", "1 1/2  m"),
            ("34.65 【rad/s】", "34.65 (rad/s)"),
            ("12’877", "12'877"),
            ("$\\frac{3}{4}\\,\\mathrm{m}$", "(3)/(4) m"),
            ("\\sqrt{\\frac12}", "sqrt((1)/(2))"),
            ("34.65 \\pm 0.1", "34.65 ± 0.1"),
        ] {
            assert_eq!(plain(cell).text, text, "{cell}");
        }
        assert!(plain("٣").foreign && !plain("３").foreign);
    }
}
