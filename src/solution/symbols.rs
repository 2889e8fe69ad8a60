//! The quantities of one solution: how each is written, its full value and the digits that are shown.
use crate::num::shown;
use crate::num::trig::power;
use crate::solution::expr::SymbolId;
use crate::solution::page::Step;
use crate::words::Words;

/// Significant figures of values on the way; answers have those that their question asks.
pub const FIGURES: usize = 4;
/// A quantity of which a difference takes the leading figures away is shown with more of them, up to this many.
const MOST: usize = 8;
/// By so many units of its last figure the printed numbers before a quantity may miss it.
const CARRIED: f64 = 1.5;

#[derive(Debug, Clone)]
struct QuantityLine {
    tex: String,
    value: f64,
    /// How far rounding on the way may have moved the value, to first order.
    doubt: f64,
    /// Digits as shown, with a point.
    digits: String,
    unit: String,
    degrees: bool,
}

/// The quantities of one solution.
#[derive(Debug, Clone)]
pub struct Symbols<'w> {
    words: &'w Words,
    lines: Vec<QuantityLine>,
    /// Figures with which a found quantity is kept; `None`: all.
    kept: Option<usize>,
    /// Quantities that are shown with more than [`FIGURES`].
    longer: Vec<(SymbolId, usize)>,
}

impl<'w> Symbols<'w> {
    /// An empty one.
    pub fn new(words: &'w Words) -> Self {
        Self { words, lines: Vec::new(), kept: None, longer: Vec::new() }
    }

    /// An empty one of somebody who writes each quantity down with so many figures when it is found, and goes on with what is
    /// written. Data are exact.
    pub fn by_hand(words: &'w Words, figures: usize) -> Self {
        Self { kept: Some(figures.max(1)), ..Self::new(words) }
    }

    /// An empty one that shows these with so many figures.
    pub fn with_figures(self, longer: Vec<(SymbolId, usize)>) -> Self {
        Self { longer, ..self }
    }

    /// With how many figures a found quantity is shown.
    fn figures(&self, symbol: SymbolId) -> usize {
        self.longer.iter().find(|(longer, _)| *longer == symbol).map_or(FIGURES, |(_, figures)| *figures)
    }

    /// Which quantities have to be shown with more figures, and with how many, so that what is printed of them gives these steps: each
    /// but for [`CARRIED`].
    pub fn too_short<'s>(&self, steps: impl Iterator<Item = &'s Step>) -> Vec<(SymbolId, usize)> {
        let mut shown = self.clone();
        for line in &mut shown.lines {
            line.value = line.digits.parse().unwrap_or(line.value);
        }
        for Step { symbol, from } in steps {
            let value = self.value(*symbol);
            let within = 2.0 * CARRIED * half_unit(value, FIGURES);
            while (from.value(&shown) - value).abs() > within {
                let exact = |s: SymbolId, shown: &Self| {
                    let mut one = shown.clone();
                    one.place(s, self.value(s));
                    (from.value(&one) - from.value(shown)).abs()
                };
                let each = from.uses().into_iter().map(|s| (s, exact(s, &shown)));
                let most = each.filter(|(s, off)| *off > 0.0 && shown.figures(*s) < MOST);
                let Some((most, _)) = most.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
                let figures = shown.figures(most) + 1;
                shown.longer.retain(|(s, _)| *s != most);
                shown.longer.push((most, figures));
                shown.place(most, shown::rounded(self.value(most), figures));
            }
        }
        shown.longer
    }

    /// What is kept of a found value, and how far that may be off: half a unit of the last figure.
    fn kept(&self, value: f64) -> (f64, f64) {
        let Some(figures) = self.kept else { return (value, 0.0) };
        (shown::rounded(value, figures), half_unit(value, figures))
    }

    /// How far rounding on the way may have moved a value, to first order; 0 where nothing is rounded.
    pub fn doubt(&self, symbol: SymbolId) -> f64 {
        self.lines.get(symbol.0).map_or(0.0, |l| l.doubt)
    }

    /// A datum: its digits are those printed. `unit` is LaTeX, empty for a pure number; an angle in degrees has none.
    pub fn given(&mut self, tex: &str, value: f64, digits: &str, unit: &str, degrees: bool) -> SymbolId {
        let (tex, digits, unit) = (tex.to_owned(), digits.to_owned(), unit.to_owned());
        self.lines.push(QuantityLine { tex, value, doubt: 0.0, digits, unit, degrees });
        SymbolId(self.lines.len() - 1)
    }

    /// A quantity that is found: its full value is kept, [`FIGURES`] figures of it are shown.
    pub fn found(&mut self, tex: &str, value: f64, unit: &str) -> SymbolId {
        let symbol = self.unknown(tex, unit);
        self.settle(symbol, value, 0.0);
        symbol
    }

    /// A quantity that is not known yet: it can be written, not valued.
    pub fn unknown(&mut self, tex: &str, unit: &str) -> SymbolId {
        self.given(tex, f64::NAN, &shown::significant(f64::NAN, FIGURES), unit, false)
    }

    /// The quantity that bears one of these symbols and has a value.
    pub fn named(&self, names: &[impl AsRef<str>]) -> Option<SymbolId> {
        let found = |l: &QuantityLine| names.iter().any(|name| name.as_ref() == l.tex) && !l.value.is_nan();
        self.lines.iter().rposition(found).map(SymbolId)
    }

    /// A quantity that is not known yet, of the kind of another.
    pub fn unknown_like(&mut self, tex: &str, other: SymbolId) -> SymbolId {
        let unit = self.lines.get(other.0).map_or_else(String::new, |l| l.unit.clone());
        self.unknown(tex, &unit)
    }

    /// Puts a variable at a value, unrounded, where something is looked for along the way.
    pub fn place(&mut self, symbol: SymbolId, value: f64) {
        if let Some(line) = self.lines.get_mut(symbol.0) {
            line.value = value;
        }
    }

    /// Gives an unknown its value, which may be off by `doubt` before it is written down.
    pub fn settle(&mut self, symbol: SymbolId, value: f64, doubt: f64) {
        let (value, rounding) = self.kept(value);
        let digits = shown::significant(value, self.figures(symbol));
        if let Some(line) = self.lines.get_mut(symbol.0) {
            line.value = value;
            line.doubt = doubt + rounding;
            line.digits = digits;
        }
    }

    /// Gives an unknown the value of another quantity, or its opposite, with the digits that this one is shown with.
    pub fn settle_as(&mut self, symbol: SymbolId, other: SymbolId, opposite: bool) {
        let Some(QuantityLine { value, doubt, digits, .. }) = self.lines.get(other.0).cloned() else {
            return;
        };
        if let Some(line) = self.lines.get_mut(symbol.0) {
            line.doubt = doubt;
            (line.value, line.digits) = if opposite {
                let turned = digits.strip_prefix('-').map_or_else(|| format!("-{digits}"), str::to_owned);
                (-value, turned)
            } else {
                (value, digits)
            };
        }
    }

    /// The full value, SI (angles in degrees where [`Symbols::is_degrees`]).
    pub fn value(&self, symbol: SymbolId) -> f64 {
        self.lines.get(symbol.0).map_or(f64::NAN, |l| l.value)
    }

    /// The symbol in LaTeX.
    pub fn tex(&self, symbol: SymbolId) -> &str {
        self.lines.get(symbol.0).map_or("?", |l| l.tex.as_str())
    }

    /// The unit in LaTeX, empty for a pure number.
    pub fn unit(&self, symbol: SymbolId) -> &str {
        self.lines.get(symbol.0).map_or("", |l| l.unit.as_str())
    }

    /// Is it an angle in degrees?
    pub fn is_degrees(&self, symbol: SymbolId) -> bool {
        self.lines.get(symbol.0).is_some_and(|l| l.degrees)
    }

    /// Is it a number without a unit?
    pub fn is_pure(&self, symbol: SymbolId) -> bool {
        self.lines.get(symbol.0).is_some_and(|l| l.unit.is_empty() && !l.degrees)
    }

    /// Number and unit in LaTeX: `40\ \mathrm{kg}`, `30^\circ`, with the decimal mark of the language.
    pub fn shown(&self, symbol: SymbolId) -> String {
        let Some(line) = self.lines.get(symbol.0) else { return String::new() };
        let digits = tex_digits(&line.digits, self.words);
        match (line.degrees, line.unit.as_str()) {
            (true, _) => format!(r"{digits}^\circ"),
            (false, "") => digits,
            (false, unit) => format!(r"{digits}\ {unit}"),
        }
    }
}

/// Digits with a point, perhaps with an exponent, in LaTeX: `1{,}5 \cdot 10^{-7}` in German.
pub fn tex_digits(digits: &str, words: &Words) -> String {
    match digits.split_once('e') {
        Some((mantissa, exponent)) => {
            format!(r"{} \cdot 10^{{{exponent}}}", words.tex_number(mantissa))
        }
        None => words.tex_number(digits),
    }
}

/// Half a unit of the last one of so many figures; of 0 it is 0.
fn half_unit(value: f64, figures: usize) -> f64 {
    let text = shown::figures(value, figures);
    let exponent: Option<i32> = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    let last = exponent.map_or(0.0, |e| power(10.0, f64::from(e) - float(figures)));
    if value == 0.0 { 0.0 } else { 5.0 * last }
}

#[expect(clippy::cast_precision_loss, reason = "a handful of figures")]
const fn float(figures: usize) -> f64 {
    figures as f64
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "digits on paper are exact")]
mod tests {
    use super::*;
    use crate::solution::expr::{Expr, root};

    #[test]
    fn by_hand_each_quantity_is_kept_as_it_is_written() {
        let words = Words::english();
        let mut l = Symbols::by_hand(&words, 3);
        let g = l.given("g", 9.81, "9.81", "", false);
        let found = |l: &mut Symbols, from: &Expr| {
            let symbol = l.unknown("x", "");
            l.settle_by(symbol, from);
            symbol
        };
        let square = found(&mut l, &(g * g));
        // 96.2361 is 96.2 on the paper, off by at most 0.05.
        assert_eq!(l.value(square), 96.2);
        assert!((l.doubt(square) - 0.05).abs() < 1e-12, "{}", l.doubt(square));
        // sqrt(96.2) = 9.80816: what is written decides, not 9.81.
        let root = found(&mut l, &root(square));
        assert_eq!(l.value(root), 9.81);
        assert!((l.doubt(root) - (0.005 + 0.05 / (2.0 * 96.2f64.sqrt()))).abs() < 1e-9, "{}", l.doubt(root));
        // 1165 is 1160 or 1170 on the paper: of 1200 less it two figures are left, and the doubt says so.
        let large = l.found("W", 1204.0, "");
        let less = l.found("T", 1163.0, "");
        let rest = found(&mut l, &(large - less));
        assert_eq!((l.value(large), l.value(less), l.value(rest)), (1200.0, 1160.0, 40.0));
        assert!((l.doubt(rest) - 10.05).abs() < 1e-9, "{}", l.doubt(rest));
        assert_eq!(l.doubt(g), 0.0);
    }

    #[test]
    fn otherwise_all_digits_are_kept() {
        let words = Words::english();
        let mut l = Symbols::new(&words);
        let x = l.found("x", 1.0 / 3.0, "");
        assert_eq!((l.value(x), l.doubt(x)), (1.0 / 3.0, 0.0));
        let y = l.unknown("y", "");
        l.settle_by(y, &(x * x));
        assert_eq!((l.value(y), l.doubt(y)), ((1.0 / 3.0) * (1.0 / 3.0), 0.0));
    }

    #[test]
    fn what_a_difference_is_taken_of_is_shown_with_more_figures() {
        let words = Words::english();
        let mut l = Symbols::new(&words);
        let (rest, length) = (l.given("l_0", 1.0, "1", "", false), l.found("s", 1.174_57, ""));
        let (twice, stretch) = (length * 2, length - rest);
        let step = |symbol, from: &Expr| Step { symbol, from: from.clone() };
        let double = l.found("d", twice.value(&l), "");
        assert!(l.too_short([step(double, &twice)].iter()).is_empty());
        let stretched = l.found("x", stretch.value(&l), "");
        // 1.175 - 1 is 0.175, and 1.1746 - 1 the 0.1746 that is printed.
        let longer = l.too_short([step(double, &twice), step(stretched, &stretch)].iter());
        assert_eq!(longer, [(length, 5)]);
        let mut l = Symbols::new(&words).with_figures(longer);
        l.given("l_0", 1.0, "1", "", false);
        let length = l.found("s", 1.174_57, "");
        assert_eq!(l.shown(length), "1.1746");
    }
}
