//! Writes one section: phrases, equations, and the steps by which a quantity is found, broken into lines that fit a page.
use crate::num::shown;
use crate::scene::{Label, Num, Quantity};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{Expr, SymbolId};
use crate::solution::symbols::{Symbols, tex_digits};
use crate::solution::text::{Block, SolutionSection};

/// Width of a line that still fits 16 cm of print, in characters of average width.
const LINE: usize = 68;
/// A chain `a = symbols = numbers = value` up to this width stands on one line.
const SHORT: usize = 46;

/// A section that is being written.
#[derive(Debug)]
pub struct SectionWriter<'d, 'a> {
    /// The draft.
    pub draft: &'d mut Draft<'a>,
    section: SolutionSection,
}

impl<'d, 'a> SectionWriter<'d, 'a> {
    /// Begins a section with this id; `title` is the name of a phrase.
    pub fn new(draft: &'d mut Draft<'a>, id: &'static str, title: &str) -> Self {
        let section = SolutionSection::new(id, draft.words.get(title));
        Self { draft, section }
    }

    /// Ends the section.
    pub fn done(self) {
        if !self.section.blocks.is_empty() {
            self.draft.sections.push(self.section);
        }
    }

    /// A paragraph: a phrase with its places filled in.
    pub fn say(&mut self, phrase: &str, pieces: &[(&str, &str)]) {
        let text = self.draft.say(phrase, pieces);
        self.section.say(text);
    }

    /// A paragraph of several sentences.
    pub fn paragraph(&mut self, sentences: &[String]) {
        if !sentences.is_empty() {
            self.section.say(sentences.join(" "));
        }
    }

    /// A list.
    pub fn list(&mut self, items: Vec<String>) {
        if !items.is_empty() {
            self.section.blocks.push(Block::List(items));
        }
    }

    /// A table, first row the head.
    pub fn table(&mut self, rows: Vec<Vec<String>>) {
        self.section.blocks.push(Block::Table(rows));
    }

    /// The picture of this name, if there is one.
    pub fn picture(&mut self, name: &str) {
        self.section.blocks.push(Block::Picture(name.to_owned()));
    }

    /// A formula, LaTeX.
    pub fn formula(&mut self, tex: impl Into<String>) {
        self.section.blocks.push(Block::Formula(tex.into()));
    }

    /// `left = right` in symbols.
    pub fn equation(&mut self, left: impl Into<Expr>, right: impl Into<Expr>) {
        let symbols = &self.draft.symbols;
        let (left, rows) = (left.into().symbols(symbols), rows(symbols, &right.into(), true));
        self.formula(match rows.as_slice() {
            [row] => format!("{left} = {row}"),
            rows => {
                format!(r"\begin{{aligned}} {left} &= {} \end{{aligned}}", rows.join(r" \\ &\quad "))
            }
        });
    }

    /// As [`Draft::number`].
    pub fn number(&mut self, num: Num, tex: &str, unit: &str) -> Expr {
        self.draft.number(num, tex, unit)
    }

    /// As [`Draft::free`].
    pub fn free(&self, candidates: &[&str]) -> String {
        self.draft.free(candidates)
    }

    /// Is this quantity asked, of anything?
    pub fn asks(&self, quantity: Quantity) -> bool {
        self.draft.asks(quantity)
    }

    /// A quantity that is not known yet. The unit is ASCII.
    pub fn unknown(&mut self, tex: &str, unit: &str) -> Expr {
        self.draft.unknown(tex, unit).into()
    }

    /// A new quantity and the steps by which it is found: in symbols, with numbers put in, its value. The unit is ASCII.
    pub fn find(&mut self, tex: &str, unit: &str, from: impl Into<Expr>) -> SymbolId {
        let from = from.into();
        let symbol = self.quiet(tex, unit, &from);
        self.steps(symbol, &from);
        symbol
    }

    /// A new quantity with its value, told nowhere.
    pub fn quiet(&mut self, tex: &str, unit: &str, from: impl Into<Expr>) -> SymbolId {
        let symbol = self.draft.unknown(tex, unit);
        self.draft.symbols.settle_by(symbol, &from.into());
        symbol
    }

    /// A new quantity with its value, and the steps if they are to be told.
    pub fn find_if(&mut self, told: bool, tex: &str, unit: &str, from: impl Into<Expr>) -> SymbolId {
        if told { self.find(tex, unit, from) } else { self.quiet(tex, unit, from) }
    }

    /// The steps by which a quantity is found.
    pub fn steps(&mut self, symbol: SymbolId, from: &Expr) {
        let tex = steps(&self.draft.symbols, symbol, from);
        self.formula(tex);
    }

    /// An expression in symbols.
    pub fn tex(&self, e: &Expr) -> String {
        e.symbols(&self.draft.symbols)
    }

    /// The value of an expression.
    pub fn value(&self, e: &Expr) -> f64 {
        e.value(&self.draft.symbols)
    }

    /// A symbol and its value, `h = 0.6\ \mathrm{m}`.
    pub fn with_value(&self, symbol: SymbolId) -> String {
        format!("{} = {}", self.draft.symbols.tex(symbol), self.draft.symbols.shown(symbol))
    }

    /// What is found for a label, by the method of the equations of motion.
    pub fn motion(&mut self, label: Label, symbol: SymbolId) {
        self.draft.from_motion(label, DerivedAnswer::Value(symbol));
    }

    /// What is found for a label by one method only; the phrase says why.
    pub fn only(&mut self, label: Label, symbol: SymbolId, why: &str) {
        let why = self.draft.words.get(why);
        self.draft.from_one_method(label, DerivedAnswer::Value(symbol), why);
    }

    /// What is found for a label, by the method of work and energy.
    pub fn energy(&mut self, label: Label, symbol: SymbolId) {
        self.draft.from_energy(label, DerivedAnswer::Value(symbol));
    }

    /// A number with four figures and a unit (ASCII), for remarks: LaTeX without dollars.
    pub fn rough(&self, value: f64, unit: &str) -> String {
        let digits = tex_digits(&shown::significant(value, 4), self.draft.words);
        match crate::solution::draft::tex_of(unit) {
            unit if unit.is_empty() => digits,
            unit => format!(r"{digits}\ {unit}"),
        }
    }
}

/// The steps by which a quantity is found: in symbols, with numbers put in, its value, on one line if that is short.
pub fn steps(symbols: &Symbols, symbol: SymbolId, from: &Expr) -> String {
    let (name, value) = (symbols.tex(symbol), symbols.shown(symbol));
    if matches!(from, Expr::Number(..)) {
        return format!("{name} = {value}");
    }
    let (letters, numbers) = (from.symbols(symbols), from.numbers(symbols));
    let mut lines = vec![rows(symbols, from, true)];
    if numbers != value && numbers != letters {
        lines.push(rows(symbols, from, false));
    }
    lines.push(vec![value]);
    if let (Expr::Root(inner), [letters, numbers, value]) = (from, lines.as_slice())
        && numbers.iter().any(|row| width(row) > LINE)
        && matches!(**inner, Expr::Sum(_))
    {
        // A root cannot be broken; its square can.
        return format!(
            r"\begin{{aligned}} {name} &= {} \\ {name}^{{2}} &= {} \\ {name} &= {} \end{{aligned}}",
            letters.concat(),
            rows(symbols, inner, false).join(r" \\ &\quad "),
            value.concat()
        );
    }
    let single = lines.iter().all(|l| l.len() == 1);
    let chain: Vec<&str> = lines.iter().flatten().map(String::as_str).collect();
    let total: usize = width(name) + chain.iter().map(|l| width(l) + 3).sum::<usize>();
    if single && total <= SHORT {
        return format!("{name} = {}", chain.join(" = "));
    }
    let lines: Vec<String> = lines.iter().map(|l| l.join(r" \\ &\quad ")).collect();
    format!(r"\begin{{aligned}} {name} &= {} \end{{aligned}}", lines.join(r" \\ &= "))
}

/// An expression in symbols or numbers; a sum that is too wide for a line is broken before its signs.
fn rows(symbols: &Symbols, e: &Expr, in_symbols: bool) -> Vec<String> {
    let write = |e: &Expr| if in_symbols { e.symbols(symbols) } else { e.numbers(symbols) };
    let whole = write(e);
    let Expr::Sum(terms) = e else { return vec![whole] };
    if width(&whole) <= LINE {
        return vec![whole];
    }
    let mut rows: Vec<String> = Vec::new();
    for (i, term) in terms.iter().enumerate() {
        let (sign, size) = match term {
            Expr::Minus(inner) => ("- ", write(inner)),
            Expr::Number(over, under) if *over < 0 => ("- ", write(&Expr::Number(-over, *under))),
            other => ("+ ", write(other)),
        };
        if i == 0 {
            rows.push(write(term));
            continue;
        }
        let size = match (size.starts_with('-'), term) {
            (true, Expr::Symbol(_)) => format!("({size})"),
            (true, _) => format!(r"\left({size}\right)"),
            (false, _) => size,
        };
        let next = format!("{sign}{size}");
        match rows.last_mut() {
            Some(last) if width(last) + width(&next) < LINE => {
                last.push(' ');
                last.push_str(&next);
            }
            _ => rows.push(next),
        }
    }
    rows
}

/// Width of a formula in characters of average width, roughly.
pub fn width(tex: &str) -> usize {
    let chars: Vec<char> = tex.chars().collect();
    tenths(&chars, &mut 0, false).div_ceil(10)
}

/// Width in tenths from a place up to the end or to a closing brace.
fn tenths(chars: &[char], at: &mut usize, one: bool) -> usize {
    let mut sum = 0;
    while let Some(c) = chars.get(*at).copied() {
        *at += 1;
        sum += match c {
            '}' => return sum,
            '{' => tenths(chars, at, false),
            ' ' => continue,
            '^' | '_' => tenths(chars, at, true) * 7 / 10,
            '=' | '+' | '-' => 20,
            '.' | ',' | '(' | ')' | '|' => 7,
            '\\' => {
                let start = *at;
                while chars.get(*at).is_some_and(char::is_ascii_alphabetic) {
                    *at += 1;
                }
                let name: String = chars[start..*at].iter().collect();
                match name.as_str() {
                    "" => {
                        *at += 1;
                        4
                    }
                    "frac" | "tfrac" => {
                        let (over, under) = (tenths(chars, at, true), tenths(chars, at, true));
                        over.max(under) + 4
                    }
                    "left" | "right" | "mathrm" | "begin" | "end" => 0,
                    "sqrt" => 15,
                    "sin" | "cos" => 32,
                    "quad" => 20,
                    "cdot" => 14,
                    "sum" | "int" => 20,
                    _ => 11,
                }
            }
            _ => 10,
        };
        if one {
            return sum;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::expr::{product, sum};
    use crate::words::Words;

    #[test]
    fn widths_count_what_is_seen() {
        for (tex, seen) in [
            ("m", 1),
            (r"m\,g", 3),
            (r"\frac{m\,g}{2}", 3),
            (r"(40\ \mathrm{kg})", 6),
            (r"\phi_{0}", 2),
            (r"\sin 30^\circ", 6),
        ] {
            assert_eq!(width(tex), seen, "{tex}");
        }
    }

    #[test]
    fn a_long_sum_is_broken_before_its_signs() {
        let words = Words::english();
        let mut l = Symbols::new(&words);
        let x = l.given("x", -12.345, "-12.345", r"\mathrm{m}", false);
        let term = || product([x.into(), x.into()]);
        let long = sum([term(), Expr::Minus(Box::new(term())), term(), x.into(), term()]);
        let rows = rows(&l, &long, false);
        assert!(rows.len() > 1, "{rows:?}");
        assert!(rows.iter().all(|r| width(r) <= LINE), "{rows:?}");
        let y = l.found("y", long.value(&l), r"\mathrm{m}");
        let whole = steps(&l, y, &long);
        assert_eq!(whole.matches(r"\\ &= ").count(), 2, "{whole}");
        assert_eq!(rows.join(" "), long.numbers(&l));
    }
}
