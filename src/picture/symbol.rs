//! Text of labels: symbols from LaTeX, numbers, units, as runs of letters with their widths.
use crate::picture::{RunStyle, TextRun};

/// Size of small letters (lowered, raised) as a share of the others.
pub const SMALL: f64 = 0.75;

/// Letters of LaTeX by name.
#[rustfmt::skip] // a table
pub const LETTERS: &[(&str, &str)] = &[
    ("alpha", "α"), ("beta", "β"), ("gamma", "γ"), ("delta", "δ"), ("epsilon", "ε"), ("varepsilon", "ε"),
    ("zeta", "ζ"), ("eta", "η"), ("theta", "θ"), ("vartheta", "ϑ"), ("iota", "ι"), ("kappa", "κ"),
    ("lambda", "λ"), ("mu", "μ"), ("nu", "ν"), ("xi", "ξ"), ("pi", "π"), ("rho", "ρ"), ("sigma", "σ"),
    ("tau", "τ"), ("upsilon", "υ"), ("phi", "ϕ"), ("varphi", "φ"), ("chi", "χ"), ("psi", "ψ"),
    ("omega", "ω"), ("Gamma", "Γ"), ("Delta", "Δ"), ("Theta", "Θ"), ("Lambda", "Λ"), ("Xi", "Ξ"),
    ("Pi", "Π"), ("Sigma", "Σ"), ("Phi", "Φ"), ("Psi", "Ψ"), ("Omega", "Ω"), ("ell", "ℓ"), ("cdot", "·"),
    ("prime", "′"), ("circ", "°"), ("max", "max"), ("min", "min"),
];

/// Widths of capital letters A to Z in thousandths of the size, Times.
const CAPITALS: [u16; 26] = [
    722, 667, 667, 722, 611, 556, 722, 722, 333, 389, 722, 611, 889, 722, 722, 556, 722, 667, 556, 611, 722,
    722, 944, 722, 722, 611,
];
/// Widths of letters a to z.
const SMALLS: [u16; 26] = [
    444, 500, 444, 500, 444, 333, 500, 500, 278, 278, 500, 278, 778, 500, 500, 500, 500, 333, 389, 278, 500,
    500, 722, 500, 500, 444,
];
/// What other serif fonts may be wider than Times.
const WIDER: f64 = 1.1;

/// Width of a character in sizes, on the safe side for serif fonts.
fn glyph(c: char) -> f64 {
    let thousandths = match c {
        'A'..='Z' => CAPITALS[(c as usize) - ('A' as usize)],
        'a'..='z' => SMALLS[(c as usize) - ('a' as usize)],
        '0'..='9' | '_' | '#' | '$' | '?' => 500,
        ' ' | '\u{a0}' | '.' | ',' | '·' => 250,
        ':' | ';' | '/' | '!' | 'ι' | 'ı' => 278,
        '\'' | '′' | '|' => 230,
        '(' | ')' | '[' | ']' | '-' => 333,
        '°' | 'ℓ' => 400,
        'ω' | 'Ω' | 'φ' | 'ϕ' | 'ψ' | 'Φ' | 'Ψ' | '…' => 720,
        'α' | 'β' | 'γ'..='θ' | 'κ'..='χ' | 'µ' | 'ϑ' => 580,
        '=' | '+' | '−' | '±' | '<' | '>' | '≤' | '≥' | '×' => 570,
        'ä' | 'à' | 'é' | 'è' => 450,
        'ö' | 'ü' | 'ß' => 500,
        'Ä' | 'Ö' | 'Ü' | '–' => 722,
        _ => 1000,
    };
    f64::from(thousandths) / 1000.0 * WIDER
}

/// Width of runs at a size.
pub fn width(runs: &[TextRun], size: f64) -> f64 {
    runs.iter()
        .map(|r| {
            let share = match r.style {
                RunStyle::Upright | RunStyle::Italic => 1.0,
                RunStyle::Sub | RunStyle::SubItalic | RunStyle::Super => SMALL,
            };
            r.text.chars().map(glyph).sum::<f64>() * share * size
        })
        .sum()
}

/// How far runs reach below their base line, in sizes.
pub fn depth(runs: &[TextRun]) -> f64 {
    if runs.iter().any(|r| matches!(r.style, RunStyle::Sub | RunStyle::SubItalic)) { 0.40 } else { 0.24 }
}

/// How far runs reach above their base line, in sizes.
pub fn height(runs: &[TextRun]) -> f64 {
    if runs.iter().any(|r| r.style == RunStyle::Super) { 0.92 } else { 0.76 }
}

/// A run.
pub fn run(text: impl Into<String>, style: RunStyle) -> TextRun {
    TextRun { text: text.into(), style }
}

/// A symbol of one's own: `G`.
pub fn italic(text: impl Into<String>) -> Vec<TextRun> {
    vec![run(text, RunStyle::Italic)]
}

/// Upright text.
pub fn upright(text: impl Into<String>) -> Vec<TextRun> {
    vec![run(text, RunStyle::Upright)]
}

/// A symbol between bars where the value is negative: its arrow shows the actual sense.
pub fn magnitude(runs: Vec<TextRun>, negative: bool) -> Vec<TextRun> {
    if !negative {
        return runs;
    }
    let mut out = upright("|");
    out.extend(runs);
    out.extend(upright("|"));
    out
}

/// Text as people read it: `R = 0.40 m`, lowered letters after `_`.
pub fn plain(runs: &[TextRun]) -> String {
    let mut out = String::new();
    let mut before = RunStyle::Upright;
    for r in runs {
        let lowered = |s| matches!(s, RunStyle::Sub | RunStyle::SubItalic);
        if lowered(r.style) && !lowered(before) {
            out.push('_');
        }
        if r.style == RunStyle::Super && before != RunStyle::Super {
            out.push('^');
        }
        out.push_str(&r.text);
        before = r.style;
    }
    out
}

/// Of LaTeX the text within the braces at the start, or the first sign, and what follows.
pub fn group(text: &str) -> (&str, &str) {
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

/// A symbol in LaTeX as runs: `\mu_s`, `\omega_0`, `v_x`, `m_{\mathrm{max}}`. What it does not know, it writes as it stands.
pub fn symbol(tex: &str) -> Vec<TextRun> {
    let chars: Vec<char> = tex.chars().collect();
    let mut reader = SymbolReader { chars: &chars, at: 0, runs: Vec::new() };
    reader.group(Level::Base, false, 0);
    let mut runs: Vec<TextRun> = Vec::new();
    for r in reader.runs {
        match runs.last_mut() {
            Some(last) if last.style == r.style => last.text.push_str(&r.text),
            _ => runs.push(r),
        }
    }
    if runs.is_empty() { upright(tex) } else { runs }
}

/// Where letters stand.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Level {
    Base,
    Low,
    High,
}

struct SymbolReader<'a> {
    chars: &'a [char],
    at: usize,
    runs: Vec<TextRun>,
}

impl SymbolReader<'_> {
    fn push(&mut self, text: &str, level: Level, upright: bool) {
        let slanted = !upright
            && text.chars().all(|c| c.is_alphabetic() && !c.is_uppercase() || c.is_ascii_uppercase());
        let style = match (level, slanted) {
            (Level::Base, true) => RunStyle::Italic,
            (Level::Base, false) => RunStyle::Upright,
            (Level::Low, true) => RunStyle::SubItalic,
            (Level::Low, false) => RunStyle::Sub,
            (Level::High, _) => RunStyle::Super,
        };
        self.runs.push(run(text, style));
    }

    /// Reads up to the end, or to the brace that closes the group.
    fn group(&mut self, level: Level, upright: bool, deep: u8) {
        while let Some(c) = self.chars.get(self.at).copied() {
            if c == '}' {
                self.at += 1;
                return;
            }
            self.item(level, upright, deep);
        }
    }

    /// Reads one letter, command or group.
    fn item(&mut self, level: Level, upright: bool, deep: u8) {
        let Some(c) = self.chars.get(self.at).copied() else { return };
        self.at += 1;
        match c {
            // Below 16 levels braces are passed over.
            '{' if deep < 16 => self.group(level, upright, deep + 1),
            '{' | '}' | '$' => {}
            '_' if level != Level::High => self.item(Level::Low, upright, deep),
            '^' if level == Level::Base => self.item(Level::High, upright, deep),
            '_' | '^' => {}
            '\\' => self.command(level, upright, deep),
            '~' => self.push("\u{a0}", level, true),
            c if c.is_whitespace() => {}
            '-' => self.push("−", level, true),
            '\'' => self.push("′", level, true),
            c => self.push(&c.to_string(), level, upright),
        }
    }

    fn command(&mut self, level: Level, upright: bool, deep: u8) {
        let from = self.at;
        while self.chars.get(self.at).is_some_and(char::is_ascii_alphabetic) {
            self.at += 1;
        }
        let name: String = self.chars[from..self.at].iter().collect();
        if self.at > from && self.chars.get(self.at) == Some(&' ') {
            self.at += 1;
        }
        match name.as_str() {
            "" => {
                // `\,` and `\ ` are spaces; `\%` is the sign itself.
                let sign = self.chars.get(self.at).copied();
                self.at += 1;
                match sign {
                    Some(' ' | ',' | ';' | ':' | '~') => self.push("\u{a0}", level, true),
                    Some(c) if !matches!(c, '!' | '\\' | '{' | '}') => self.push(&c.to_string(), level, true),
                    _ => {}
                }
            }
            "mathrm" | "text" | "textrm" | "operatorname" | "rm" | "mathsf" => self.item(level, true, deep),
            "mathit" | "mathbf" | "boldsymbol" | "vec" | "hat" | "bar" | "dot" | "tilde" | "overline"
            | "left" | "right" => self.item(level, upright, deep),
            _ => match LETTERS.iter().find(|(n, _)| *n == name) {
                Some((_, letter)) => self.push(letter, level, upright || letter.len() > 2),
                None => self.push(&name, level, true),
            },
        }
    }
}

/// A number and its unit, as the unit is written in HTML (`m/s<sup>2</sup>`): `0.40 m`, `30°`.
pub fn quantity(number: &str, unit_html: &str) -> Vec<TextRun> {
    let mut runs = vec![run(number.replace('-', "−"), RunStyle::Upright)];
    if unit_html.is_empty() || unit_html == "1" {
        return runs;
    }
    if unit_html != "°" {
        runs[0].text.push('\u{a0}');
    }
    let mut rest = unit_html;
    while let Some((before, after)) = rest.split_once("<sup>") {
        let (power, after) = after.split_once("</sup>").unwrap_or((after, ""));
        runs.push(run(before, RunStyle::Upright));
        runs.push(run(power.replace('-', "−"), RunStyle::Super));
        rest = after;
    }
    runs.push(run(rest, RunStyle::Upright));
    runs.retain(|r| !r.text.is_empty());
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_become_runs() {
        let text = |tex: &str| plain(&symbol(tex));
        assert_eq!(text(r"\mu_s"), "μ_s");
        assert_eq!(text(r"\omega_0"), "ω_0");
        assert_eq!(text(r"m_{\mathrm{max}}"), "m_max");
        assert_eq!(text(r"v_x"), "v_x");
        assert_eq!(text("R"), "R");
        assert_eq!(text(r"k^2"), "k^2");
        assert_eq!(symbol(r"\mu_s")[1].style, RunStyle::SubItalic);
        assert_eq!(symbol(r"\omega_0")[1].style, RunStyle::Sub);
        assert_eq!(symbol(r"F_{\text{roll}}")[1].style, RunStyle::Sub);
    }

    #[test]
    fn odd_latex_falls_back_and_ends() {
        for odd in
            [r"\", "{{{{", "}}", "_", "^", r"\frac{a}{b}", r"\nothing_x", "x__y", "", r"\left(a\right)"]
        {
            let runs = symbol(odd);
            assert!(!runs.is_empty(), "{odd}");
            assert!(width(&runs, 16.0).is_finite());
        }
        assert_eq!(plain(&symbol(r"\nothing_x")), "nothing_x");
        assert!(width(&symbol(&"{".repeat(10_000)), 16.0).is_finite());
    }

    #[test]
    fn units_are_raised_and_degrees_stand_close() {
        assert_eq!(plain(&quantity("-9.81", "m/s<sup>2</sup>")), "−9.81\u{a0}m/s^2");
        assert_eq!(plain(&quantity("30", "°")), "30°");
        assert_eq!(plain(&quantity("0.4", "")), "0.4");
    }
}
