//! Expressions in LaTeX, in symbols or with the numbers put in, and how wide that is in print.
use crate::picture::symbol::group;
use crate::solution::expr::{Expr, Function, SymbolId};
use crate::solution::symbols::Symbols;

/// How an expression is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Notation {
    /// Symbols.
    Symbols,
    /// Numbers with units.
    Numbers,
}

/// What may stand around a piece without parentheses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Surroundings {
    /// Alone, or the first term.
    Term,
    /// A term after a sign.
    Later,
    /// A factor.
    Factor,
    /// The base of a power, the argument of a function.
    Tight,
}

impl Expr {
    /// In LaTeX, in symbols.
    pub fn symbols(&self, symbols: &Symbols) -> String {
        let mut out = String::new();
        self.write(symbols, Notation::Symbols, Surroundings::Term, &mut out);
        out
    }

    /// In LaTeX, with the printed numbers and their units put in.
    pub fn numbers(&self, symbols: &Symbols) -> String {
        let mut out = String::new();
        self.write(symbols, Notation::Numbers, Surroundings::Term, &mut out);
        out
    }

    /// As [`Expr::numbers`], a sum that is wider than `limit` on several lines, the later ones with their sign in front.
    pub fn numbers_in_lines(&self, symbols: &Symbols, limit: f64) -> Vec<String> {
        self.in_lines(symbols, Notation::Numbers, limit)
    }
    /// The same of [`Expr::symbols`].
    pub fn symbols_in_lines(&self, symbols: &Symbols, limit: f64) -> Vec<String> {
        self.in_lines(symbols, Notation::Symbols, limit)
    }
    fn in_lines(&self, symbols: &Symbols, form: Notation, limit: f64) -> Vec<String> {
        let mut whole = String::new();
        self.write(symbols, form, Surroundings::Term, &mut whole);
        let Self::Sum(terms) = self else { return vec![whole] };
        if width(&whole) <= limit {
            return vec![whole];
        }
        let mut lines: Vec<String> = Vec::new();
        for piece in pieces(terms, symbols, form) {
            match lines.last_mut() {
                Some(line) if width(line) + width(&piece) <= limit => {
                    line.push(' ');
                    line.push_str(&piece);
                }
                _ => lines.push(piece),
            }
        }
        lines
    }

    fn write(&self, symbols: &Symbols, form: Notation, place: Surroundings, out: &mut String) {
        let wrap = |needed: bool, out: &mut String, inner: &dyn Fn(&mut String)| {
            if needed {
                let mut within = String::new();
                inner(&mut within);
                // Parentheses grow with what is in them only where it is high.
                let high = [r"\frac", r"\sqrt", r"\left"].iter().any(|h| within.contains(h));
                let (open, close) = if high { (r"\left(", r"\right)") } else { ("(", ")") };
                out.push_str(open);
                out.push_str(&within);
                out.push_str(close);
            } else {
                inner(out);
            }
        };
        match self {
            Self::Number(over, under) => {
                let negative = *over < 0;
                wrap(negative && place > Surroundings::Term, out, &|out| {
                    if negative {
                        out.push('-');
                    }
                    if *under == 1 {
                        out.push_str(&over.abs().to_string());
                    } else {
                        out.push_str(&format!(r"\tfrac{{{}}}{{{under}}}", over.abs()));
                    }
                });
            }
            Self::Symbol(s) => write_symbol(*s, symbols, form, place, out),
            Self::Minus(inner) => wrap(place > Surroundings::Term, out, &|out| {
                out.push('-');
                inner.write(symbols, form, Surroundings::Later, out);
            }),
            Self::Sum(terms) => wrap(place > Surroundings::Term, out, &|out| {
                out.push_str(&pieces(terms, symbols, form).join(" "));
            }),
            Self::Product(factors) => wrap(place > Surroundings::Factor, out, &|out| {
                write_product(factors, symbols, form, out);
            }),
            Self::Quotient(over, under) => wrap(place >= Surroundings::Tight, out, &|out| {
                out.push_str(r"\frac{");
                over.write(symbols, form, Surroundings::Term, out);
                out.push_str("}{");
                under.write(symbols, form, Surroundings::Term, out);
                out.push('}');
            }),
            Self::Power(base, n) => {
                base.write(symbols, form, Surroundings::Tight, out);
                out.push_str(&format!("^{{{n}}}"));
            }
            Self::Root(inner) => {
                out.push_str(r"\sqrt{");
                inner.write(symbols, form, Surroundings::Term, out);
                out.push('}');
            }
            Self::Of(Function::Magnitude, inner) => {
                out.push_str(r"\left|");
                inner.write(symbols, form, Surroundings::Term, out);
                out.push_str(r"\right|");
            }
            Self::Of(function, inner) => {
                // The power of a function's value needs parentheses around the whole.
                wrap(place >= Surroundings::Tight, out, &|out| {
                    out.push_str(match function {
                        Function::Sine => r"\sin ",
                        Function::ArcCosine => r"\arccos ",
                        Function::ArcTangent => r"\arctan ",
                        _ => r"\cos ",
                    });
                    inner.write(symbols, form, Surroundings::Tight, out);
                });
            }
        }
    }
}

fn write_symbol(s: SymbolId, symbols: &Symbols, form: Notation, place: Surroundings, out: &mut String) {
    if form == Notation::Symbols {
        let tex = symbols.tex(s);
        // A star is a power already.
        let starred = place >= Surroundings::Tight && tex.contains('^');
        let (open, close) = if starred { (r"\left(", r"\right)") } else { ("", "") };
        out.push_str(&format!("{open}{tex}{close}"));
        return;
    }
    let plain = symbols.is_pure(s) || symbols.is_degrees(s);
    let negative = symbols.value(s) < 0.0;
    let parentheses = match place {
        // What is its own number: pi.
        _ if symbols.shown(s) == symbols.tex(s) => false,
        Surroundings::Term => false,
        Surroundings::Later => negative,
        Surroundings::Factor => true,
        Surroundings::Tight => !plain || negative,
    };
    let (open, close) = if parentheses { ("(", ")") } else { ("", "") };
    out.push_str(&format!("{open}{}{close}", symbols.shown(s)));
}

/// The terms of a sum, the later ones with their sign in front.
fn pieces(terms: &[Expr], symbols: &Symbols, form: Notation) -> Vec<String> {
    let each = terms.iter().enumerate().map(|(i, term)| {
        let opposite;
        let (sign, term) = match term {
            term if i == 0 => ("", term),
            Expr::Minus(inner) => ("- ", &**inner),
            Expr::Number(over, under) if *over < 0 => {
                opposite = Expr::Number(-over, *under);
                ("- ", &opposite)
            }
            term => ("+ ", term),
        };
        let mut piece = sign.to_owned();
        term.write(symbols, form, if i == 0 { Surroundings::Term } else { Surroundings::Later }, &mut piece);
        piece
    });
    each.collect()
}

fn write_product(factors: &[Expr], symbols: &Symbols, form: Notation, out: &mut String) {
    // Sines last: what follows one could be read as part of its argument.
    let is_wave = |e: &&Expr| {
        let base = if let Expr::Power(base, _) = e { base } else { *e };
        matches!(base, Expr::Of(function, _) if *function != Function::Magnitude)
    };
    let ordered = factors.iter().filter(|f| !is_wave(f)).chain(factors.iter().filter(is_wave));
    for (i, factor) in ordered.enumerate() {
        if i > 0 {
            // Two numbers side by side would be read as one.
            let digit = matches!(factor, Expr::Number(..) | Expr::Power(..)) && factor.uses().is_empty();
            out.push_str(if digit { r" \cdot " } else { r"\," });
        }
        factor.write(symbols, form, Surroundings::Factor, out);
    }
}

/// Width of a formula in print, roughly, in digits.
pub fn width(tex: &str) -> f64 {
    let mut rest = tex;
    let mut sum = 0.0;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match c {
            '\\' => {
                let letters = rest.chars().take_while(char::is_ascii_alphabetic).count();
                let name = &rest[..letters];
                rest = &rest[letters..];
                match name {
                    "" => {
                        let mark = rest.chars().next();
                        rest = &rest[mark.map_or(0, char::len_utf8)..];
                        sum += if mark == Some(',') { 0.35 } else { 0.6 };
                    }
                    "frac" | "tfrac" => {
                        let (over, after) = group(rest);
                        let (under, after) = group(after);
                        sum += width(over).max(width(under)) + 0.3;
                        rest = after;
                    }
                    "sqrt" => sum += 1.6,
                    "left" | "right" => {}
                    "quad" => sum += 2.0,
                    "qquad" => sum += 4.0,
                    "sin" | "cos" | "int" => sum += 2.6,
                    "arccos" | "arctan" => sum += 5.0,
                    "mathrm" => {}
                    _ => sum += 1.0,
                }
            }
            '^' | '_' => {
                let (inside, after) = group(rest);
                sum += 0.75 * width(inside);
                rest = after;
            }
            '{' | '}' | ' ' | '&' => {}
            '+' | '-' | '=' | '<' | '>' => sum += 2.2,
            '(' | ')' | '.' | ',' | '/' => sum += 0.6,
            _ => sum += 1.0,
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::expr::{ONE, ZERO, minus, number, power, product, ratio, sine, square, sum};
    use crate::words::Words;

    fn symbols(words: &Words) -> (Symbols<'_>, [SymbolId; 4]) {
        let mut l = Symbols::new(words);
        let m = l.given("m", 40.0, "40", r"\mathrm{kg}", false);
        let g = l.given("g", 9.81, "9.81", r"\mathrm{m}/\mathrm{s}^{2}", false);
        let theta = l.given(r"\theta", 30.0, "30", "", true);
        let f = l.given("F", -2.5, "-2.5", r"\mathrm{N}", false);
        (l, [m, g, theta, f])
    }

    #[test]
    fn written_in_symbols_and_in_numbers() {
        let words = Words::english();
        let (l, [m, g, theta, f]) = symbols(&words);
        let weight = m * g * sine(theta);
        assert_eq!(weight.symbols(&l), r"m\,g\,\sin \theta");
        assert_eq!(
            weight.numbers(&l),
            r"(40\ \mathrm{kg})\,(9.81\ \mathrm{m}/\mathrm{s}^{2})\,\sin 30^\circ"
        );
        let e = f - weight;
        assert_eq!(e.symbols(&l), r"F - m\,g\,\sin \theta");
        assert!((e.value(&l) + 2.5 + 196.2).abs() < 1e-12);
        let e = ratio(1, 2) * m * square(f);
        assert_eq!(e.symbols(&l), r"\tfrac{1}{2}\,m\,F^{2}");
        assert_eq!(e.numbers(&l), r"\tfrac{1}{2}\,(40\ \mathrm{kg})\,(-2.5\ \mathrm{N})^{2}");
        let e = (ONE + square(m / g)) * -f;
        assert_eq!(e.symbols(&l), r"-\left(1 + \left(\frac{m}{g}\right)^{2}\right)\,F");
        assert_eq!((m - (g + f)).symbols(&l), "m - g - F");
    }

    #[test]
    fn what_says_nothing_falls_out() {
        let words = Words::english();
        let (_, [m, g, ..]) = symbols(&words);
        assert_eq!(sum([ZERO, m.into(), ZERO]), m.into());
        assert_eq!(product([ONE, m.into(), number(-1)]), -m);
        assert_eq!(ZERO * m, ZERO);
        assert_eq!(m / m, ONE);
        assert_eq!(-m / -g, m / g);
        assert_eq!(ratio(1, 2) * 2 * m, m.into());
        assert_eq!(power(minus(m.into()), 2), square(m));
        assert_eq!((sine(ZERO), square(ZERO)), (ZERO, ZERO));
    }
}
