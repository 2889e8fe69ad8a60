//! Expressions in LaTeX, in symbols or with the numbers put in, and how wide that is in print.
use crate::solution::expr::Expr;
use crate::solution::expr::Function;
use crate::solution::expr::Symbol;
use crate::solution::quantities::Ledger;

/// How an expression is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Symbols.
    Symbols,
    /// Numbers with units.
    Numbers,
}

/// What may stand around a piece without parentheses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
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
    pub fn symbols(&self, ledger: &Ledger) -> String {
        let mut out = String::new();
        self.write(ledger, Form::Symbols, Place::Term, &mut out);
        out
    }

    /// In LaTeX, with the printed numbers and their units put in.
    pub fn numbers(&self, ledger: &Ledger) -> String {
        let mut out = String::new();
        self.write(ledger, Form::Numbers, Place::Term, &mut out);
        out
    }

    /// As [`Expr::numbers`], a sum that is wider than `limit` on several lines, the later ones with their sign in front.
    pub fn numbers_in_lines(&self, ledger: &Ledger, limit: f64) -> Vec<String> {
        let whole = self.numbers(ledger);
        let Self::Sum(terms) = self else { return vec![whole] };
        if width(&whole) <= limit {
            return vec![whole];
        }
        let mut lines: Vec<String> = Vec::new();
        for (i, term) in terms.iter().enumerate() {
            let mut piece = String::new();
            match term {
                term if i == 0 => term.write(ledger, Form::Numbers, Place::Term, &mut piece),
                Self::Minus(inner) => {
                    piece.push_str("- ");
                    inner.write(ledger, Form::Numbers, Place::Later, &mut piece);
                }
                term => {
                    piece.push_str("+ ");
                    term.write(ledger, Form::Numbers, Place::Later, &mut piece);
                }
            }
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

    fn write(&self, ledger: &Ledger, form: Form, place: Place, out: &mut String) {
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
                wrap(negative && place > Place::Term, out, &|out| {
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
            Self::Symbol(s) => write_symbol(*s, ledger, form, place, out),
            Self::Minus(inner) => wrap(place > Place::Term, out, &|out| {
                out.push('-');
                inner.write(ledger, form, Place::Later, out);
            }),
            Self::Sum(terms) => wrap(place > Place::Term, out, &|out| write_sum(terms, ledger, form, out)),
            Self::Product(factors) => wrap(place > Place::Factor, out, &|out| {
                write_product(factors, ledger, form, out);
            }),
            Self::Quotient(over, under) => wrap(place >= Place::Tight, out, &|out| {
                out.push_str(r"\frac{");
                over.write(ledger, form, Place::Term, out);
                out.push_str("}{");
                under.write(ledger, form, Place::Term, out);
                out.push('}');
            }),
            Self::Power(base, n) => {
                base.write(ledger, form, Place::Tight, out);
                out.push_str(&format!("^{{{n}}}"));
            }
            Self::Root(inner) => {
                out.push_str(r"\sqrt{");
                inner.write(ledger, form, Place::Term, out);
                out.push('}');
            }
            Self::Of(Function::Magnitude, inner) => {
                out.push_str(r"\left|");
                inner.write(ledger, form, Place::Term, out);
                out.push_str(r"\right|");
            }
            Self::Of(function, inner) => {
                // The power of a function's value needs parentheses around the whole.
                wrap(place >= Place::Tight, out, &|out| {
                    out.push_str(if *function == Function::Sine { r"\sin " } else { r"\cos " });
                    inner.write(ledger, form, Place::Tight, out);
                });
            }
        }
    }
}

fn write_symbol(s: Symbol, ledger: &Ledger, form: Form, place: Place, out: &mut String) {
    if form == Form::Symbols {
        out.push_str(ledger.tex(s));
        return;
    }
    let plain = ledger.is_pure(s) || ledger.is_degrees(s);
    let negative = ledger.value(s) < 0.0;
    let parentheses = match place {
        // What is its own number: pi.
        _ if ledger.shown(s) == ledger.tex(s) => false,
        Place::Term => false,
        Place::Later => negative,
        Place::Factor => true,
        Place::Tight => !plain || negative,
    };
    let (open, close) = if parentheses { ("(", ")") } else { ("", "") };
    out.push_str(&format!("{open}{}{close}", ledger.shown(s)));
}

fn write_sum(terms: &[Expr], ledger: &Ledger, form: Form, out: &mut String) {
    for (i, term) in terms.iter().enumerate() {
        let opposite;
        let (sign, term) = match term {
            term if i == 0 => ("", term),
            Expr::Minus(inner) => (" - ", &**inner),
            Expr::Number(over, under) if *over < 0 => {
                opposite = Expr::Number(-over, *under);
                (" - ", &opposite)
            }
            term => (" + ", term),
        };
        out.push_str(sign);
        term.write(ledger, form, if i == 0 { Place::Term } else { Place::Later }, out);
    }
}

fn write_product(factors: &[Expr], ledger: &Ledger, form: Form, out: &mut String) {
    // Sines last: what follows one could be read as part of its argument.
    let is_wave = |e: &&Expr| matches!(e, Expr::Of(Function::Sine | Function::Cosine, _));
    let ordered = factors.iter().filter(|f| !is_wave(f)).chain(factors.iter().filter(is_wave));
    for (i, factor) in ordered.enumerate() {
        if i > 0 {
            // Two numbers side by side would be read as one.
            let digit = matches!(factor, Expr::Number(..) | Expr::Power(..)) && factor.uses().is_empty();
            out.push_str(if digit { r" \cdot " } else { r"\," });
        }
        factor.write(ledger, form, Place::Factor, out);
    }
}

/// Width of a formula in print, roughly, in digits.
pub fn width(tex: &str) -> f64 {
    let mut rest = tex;
    let mut sum = 0.0;
    /// The group at the head of a text, without its braces, and what follows.
    fn group(text: &str) -> (&str, &str) {
        let mut depth = 0;
        for (i, c) in text.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                let inside = text[..i].strip_prefix('{').unwrap_or(&text[..i + c.len_utf8()]);
                return (inside, &text[i + c.len_utf8()..]);
            }
        }
        (text, "")
    }
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
                    "sin" | "cos" | "int" => sum += 2.6,
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
    use crate::words::Words;

    fn ledger(words: &Words) -> (Ledger<'_>, [Symbol; 4]) {
        let mut l = Ledger::new(words);
        let m = l.given("m", 40.0, "40", r"\mathrm{kg}", false);
        let g = l.given("g", 9.81, "9.81", r"\mathrm{m}/\mathrm{s}^{2}", false);
        let theta = l.given(r"\theta", 30.0, "30", "", true);
        let f = l.given("F", -2.5, "-2.5", r"\mathrm{N}", false);
        (l, [m, g, theta, f])
    }

    #[test]
    fn written_in_symbols_and_in_numbers() {
        let words = Words::english();
        let (l, [m, g, theta, f]) = ledger(&words);
        let weight = product([m.into(), g.into(), sine(theta.into())]);
        assert_eq!(weight.symbols(&l), r"m\,g\,\sin \theta");
        assert_eq!(
            weight.numbers(&l),
            r"(40\ \mathrm{kg})\,(9.81\ \mathrm{m}/\mathrm{s}^{2})\,\sin 30^\circ"
        );
        let e = difference(f.into(), weight);
        assert_eq!(e.symbols(&l), r"F - m\,g\,\sin \theta");
        assert!((e.value(&l) + 2.5 + 196.2).abs() < 1e-12);
        let e = product([ratio(1, 2), m.into(), square(f.into())]);
        assert_eq!(e.symbols(&l), r"\tfrac{1}{2}\,m\,F^{2}");
        assert_eq!(e.numbers(&l), r"\tfrac{1}{2}\,(40\ \mathrm{kg})\,(-2.5\ \mathrm{N})^{2}");
        let e = product([sum([ONE, square(quotient(m.into(), g.into()))]), minus(f.into())]);
        assert_eq!(e.symbols(&l), r"-\left(1 + \left(\frac{m}{g}\right)^{2}\right)\,F");
        assert_eq!(sum([m.into(), minus(sum([g.into(), f.into()]))]).symbols(&l), "m - g - F");
    }

    #[test]
    fn what_says_nothing_falls_out() {
        let words = Words::english();
        let (_, [m, g, ..]) = ledger(&words);
        assert_eq!(sum([ZERO, m.into(), ZERO]), m.into());
        assert_eq!(product([ONE, m.into(), number(-1)]), minus(m.into()));
        assert_eq!(product([ZERO, m.into()]), ZERO);
        assert_eq!(quotient(m.into(), m.into()), ONE);
        assert_eq!(quotient(minus(m.into()), minus(g.into())), quotient(m.into(), g.into()));
        assert_eq!(product([ratio(1, 2), number(2), m.into()]), m.into());
        assert_eq!(power(minus(m.into()), 2), square(m.into()));
    }
}
