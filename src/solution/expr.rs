//! Expressions in symbols: what a step of a solution says, before it is text. They are built by constructors that leave out
//! what says nothing (a term 0, a factor 1), valued in doubles, and written in LaTeX, in symbols or with the numbers put in.
use crate::num::trig;
use crate::solution::ledger::Ledger;
use crate::solution::ledger::Symbol;

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Expr {
    /// A number that belongs to the formula and not to the data: `1/2`, `2`, `-1`; the denominator is > 0.
    Number(i64, i64),
    /// A quantity.
    Symbol(Symbol),
    /// The opposite.
    Minus(Box<Expr>),
    /// A sum; terms that are [`Expr::Minus`] are subtracted.
    Sum(Vec<Expr>),
    /// A product.
    Product(Vec<Expr>),
    /// A fraction.
    Quotient(Box<Expr>, Box<Expr>),
    /// A whole power, not 0 and not 1.
    Power(Box<Expr>, u32),
    /// A square root.
    Root(Box<Expr>),
    /// A function of one argument.
    Of(Function, Box<Expr>),
}

/// Functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// Sine of an angle.
    Sine,
    /// Cosine of an angle.
    Cosine,
    /// Magnitude.
    Magnitude,
}

/// A number that belongs to a formula.
pub const fn number(value: i64) -> Expr {
    Expr::Number(value, 1)
}

/// One half and the like.
pub const fn ratio(over: i64, under: i64) -> Expr {
    Expr::Number(over, under)
}

/// 0, what an empty sum is.
pub const ZERO: Expr = Expr::Number(0, 1);
/// 1, what an empty product is.
pub const ONE: Expr = Expr::Number(1, 1);

/// The sum of these; terms that are 0 fall out.
pub fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    let mut kept = Vec::new();
    for term in terms {
        match term {
            Expr::Number(0, _) => {}
            Expr::Sum(inner) => kept.extend(inner),
            other => kept.push(other),
        }
    }
    if kept.len() > 1 { Expr::Sum(kept) } else { kept.pop().unwrap_or(ZERO) }
}

/// The product of these; factors 1 fall out, signs go to the front, a factor 0 makes it 0. A fraction of numbers stays in
/// front.
pub fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    let mut negative = false;
    let mut constant = (1i64, 1i64);
    let mut kept: Vec<Expr> = Vec::new();
    let mut waiting: Vec<Expr> = factors.into_iter().collect();
    waiting.reverse();
    while let Some(factor) = waiting.pop() {
        match factor {
            Expr::Number(over, under) => {
                negative ^= over < 0;
                constant = reduced(constant.0 * over.abs(), constant.1 * under);
            }
            Expr::Minus(inner) => {
                negative = !negative;
                waiting.push(*inner);
            }
            Expr::Product(inner) => waiting.extend(inner.into_iter().rev()),
            other => kept.push(other),
        }
    }
    if constant.0 == 0 {
        return ZERO;
    }
    if constant != (1, 1) || kept.is_empty() {
        kept.insert(0, Expr::Number(constant.0, constant.1));
    }
    let whole = if kept.len() > 1 { Expr::Product(kept) } else { kept.pop().unwrap_or(ONE) };
    if negative { minus(whole) } else { whole }
}

fn reduced(over: i64, under: i64) -> (i64, i64) {
    let (mut a, mut b) = (over, under);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let divisor = a.abs().max(1);
    (over / divisor, under / divisor)
}

/// The opposite; of a sum, term by term.
pub fn minus(of: Expr) -> Expr {
    match of {
        Expr::Number(over, under) => Expr::Number(-over, under),
        Expr::Minus(inner) => *inner,
        Expr::Sum(terms) => Expr::Sum(terms.into_iter().map(minus).collect()),
        other => Expr::Minus(Box::new(other)),
    }
}

/// `a - b`.
pub fn difference(a: Expr, b: Expr) -> Expr {
    sum([a, minus(b)])
}

/// `over / under`; equal ones give 1, an `under` of 1 falls out, signs go to the front.
pub fn quotient(over: Expr, under: Expr) -> Expr {
    if over == under {
        return ONE;
    }
    match (over, under) {
        (Expr::Number(0, _), _) => ZERO,
        (over, Expr::Number(1, 1)) => over,
        (Expr::Number(a, b), Expr::Number(c, d)) if c != 0 => {
            let (over, under) = reduced(a * d * c.signum(), b * c.abs());
            Expr::Number(over, under)
        }
        (Expr::Minus(over), under) => minus(quotient(*over, under)),
        (over, Expr::Minus(under)) => minus(quotient(over, *under)),
        (over, under) => Expr::Quotient(Box::new(over), Box::new(under)),
    }
}

/// A whole power.
pub fn power(base: Expr, exponent: u32) -> Expr {
    match (base, exponent) {
        (_, 0) => ONE,
        (base, 1) => base,
        (Expr::Number(a, b), n) => Expr::Number(a.pow(n), b.pow(n)),
        (Expr::Minus(inner), n) if n % 2 == 0 => power(*inner, n),
        (base, n) => Expr::Power(Box::new(base), n),
    }
}

/// The square.
pub fn square(base: Expr) -> Expr {
    power(base, 2)
}

/// The square root.
pub fn root(of: Expr) -> Expr {
    Expr::Root(Box::new(of))
}

/// Sine.
pub fn sine(of: Expr) -> Expr {
    Expr::Of(Function::Sine, Box::new(of))
}

/// Cosine.
pub fn cosine(of: Expr) -> Expr {
    Expr::Of(Function::Cosine, Box::new(of))
}

/// Magnitude.
pub fn magnitude(of: Expr) -> Expr {
    Expr::Of(Function::Magnitude, Box::new(of))
}

impl From<Symbol> for Expr {
    fn from(symbol: Symbol) -> Self {
        Self::Symbol(symbol)
    }
}

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
    /// Its value, from the full values of the ledger; angles in degrees where the ledger has them so.
    pub fn value(&self, ledger: &Ledger) -> f64 {
        match self {
            #[expect(clippy::cast_precision_loss, reason = "numbers of formulas are small")]
            Self::Number(over, under) => *over as f64 / *under as f64,
            Self::Symbol(s) => ledger.value(*s),
            Self::Minus(inner) => -inner.value(ledger),
            Self::Sum(terms) => terms.iter().map(|t| t.value(ledger)).sum(),
            Self::Product(factors) => factors.iter().map(|f| f.value(ledger)).product(),
            Self::Quotient(over, under) => over.value(ledger) / under.value(ledger),
            Self::Power(base, n) => {
                let base = base.value(ledger);
                (0..*n).map(|_| base).product()
            }
            Self::Root(inner) => inner.value(ledger).sqrt(),
            Self::Of(function, inner) => {
                let x = inner.value(ledger);
                let angle = |x: f64| match inner.in_degrees(ledger) {
                    true => trig::sin_cos_of_degrees(x),
                    false => trig::sin_cos(x),
                };
                match function {
                    Function::Sine => angle(x).0,
                    Function::Cosine => angle(x).1,
                    Function::Magnitude => x.abs(),
                }
            }
        }
    }

    /// How far its value may be off because the quantities in it were rounded, to first order.
    pub fn doubt(&self, ledger: &Ledger) -> f64 {
        let of = |e: &Self| (e.value(ledger), e.doubt(ledger));
        match self {
            Self::Number(..) => 0.0,
            Self::Symbol(s) => ledger.doubt(*s),
            Self::Minus(inner) | Self::Of(Function::Magnitude, inner) => inner.doubt(ledger),
            Self::Sum(terms) => terms.iter().map(|t| t.doubt(ledger)).sum(),
            Self::Product(factors) => {
                let share = |(x, doubt): (f64, f64)| if doubt == 0.0 { 0.0 } else { (doubt / x).abs() };
                let size = self.value(ledger).abs();
                let off = size * factors.iter().map(|f| share(of(f))).sum::<f64>();
                // A factor 0: what the others make of its doubt is not worth a line.
                if off.is_finite() { off } else { 0.0 }
            }
            Self::Quotient(over, under) => {
                let ((x, dx), (y, dy)) = (of(over), of(under));
                (dx + (x / y).abs() * dy) / y.abs()
            }
            Self::Power(base, n) => {
                let (x, doubt) = of(base);
                f64::from(*n) * (1..*n).map(|_| x.abs()).product::<f64>() * doubt
            }
            Self::Root(inner) => {
                let (x, doubt) = of(inner);
                if doubt == 0.0 { 0.0 } else { doubt / (2.0 * x.abs().sqrt()) }
            }
            // The sine and the cosine move at most as much as the angle.
            Self::Of(Function::Sine | Function::Cosine, inner) => {
                let per = if inner.in_degrees(ledger) { std::f64::consts::PI / 180.0 } else { 1.0 };
                inner.doubt(ledger) * per
            }
        }
    }

    /// Does it hold an angle that the ledger keeps in degrees?
    fn in_degrees(&self, ledger: &Ledger) -> bool {
        match self {
            Self::Number(..) => false,
            Self::Symbol(s) => ledger.is_degrees(*s),
            Self::Minus(inner) | Self::Power(inner, _) | Self::Root(inner) | Self::Of(_, inner) => {
                inner.in_degrees(ledger)
            }
            Self::Sum(terms) | Self::Product(terms) => terms.iter().any(|t| t.in_degrees(ledger)),
            Self::Quotient(over, under) => over.in_degrees(ledger) || under.in_degrees(ledger),
        }
    }

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

    /// The symbols in it, each once, in order.
    pub fn uses(&self) -> Vec<Symbol> {
        fn walk(expr: &Expr, found: &mut Vec<Symbol>) {
            match expr {
                Expr::Number(..) => {}
                Expr::Symbol(s) => {
                    if !found.contains(s) {
                        found.push(*s);
                    }
                }
                Expr::Minus(inner) | Expr::Power(inner, _) | Expr::Root(inner) | Expr::Of(_, inner) => {
                    walk(inner, found);
                }
                Expr::Sum(parts) | Expr::Product(parts) => parts.iter().for_each(|p| walk(p, found)),
                Expr::Quotient(over, under) => {
                    walk(over, found);
                    walk(under, found);
                }
            }
        }
        let mut found = Vec::new();
        walk(self, &mut found);
        found
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
            Self::Symbol(s) => match form {
                Form::Symbols => out.push_str(ledger.tex(*s)),
                Form::Numbers => {
                    let plain = ledger.is_pure(*s) || ledger.is_degrees(*s);
                    let negative = ledger.value(*s) < 0.0;
                    let parentheses = match place {
                        // What is its own number: pi.
                        _ if ledger.shown(*s) == ledger.tex(*s) => false,
                        Place::Term => false,
                        Place::Later => negative,
                        Place::Factor => true,
                        Place::Tight => !plain || negative,
                    };
                    if parentheses {
                        out.push('(');
                    }
                    out.push_str(&ledger.shown(*s));
                    if parentheses {
                        out.push(')');
                    }
                }
            },
            Self::Minus(inner) => wrap(place > Place::Term, out, &|out| {
                out.push('-');
                inner.write(ledger, form, Place::Later, out);
            }),
            Self::Sum(terms) => wrap(place > Place::Term, out, &|out| {
                for (i, term) in terms.iter().enumerate() {
                    match (i, term) {
                        (0, term) => term.write(ledger, form, Place::Term, out),
                        (_, Self::Minus(inner)) => {
                            out.push_str(" - ");
                            inner.write(ledger, form, Place::Later, out);
                        }
                        (_, Self::Number(over, under)) if *over < 0 => {
                            out.push_str(" - ");
                            Self::Number(-over, *under).write(ledger, form, Place::Later, out);
                        }
                        (_, term) => {
                            out.push_str(" + ");
                            term.write(ledger, form, Place::Later, out);
                        }
                    }
                }
            }),
            Self::Product(factors) => wrap(place > Place::Factor, out, &|out| {
                // Sines last: what follows one could be read as part of its argument.
                let is_wave = |e: &&Self| matches!(e, Self::Of(Function::Sine | Function::Cosine, _));
                let ordered = factors.iter().filter(|f| !is_wave(f)).chain(factors.iter().filter(is_wave));
                for (i, factor) in ordered.enumerate() {
                    if i > 0 {
                        // Two numbers side by side would be read as one.
                        let digit =
                            |e: &Self| matches!(e, Self::Number(..) | Self::Power(..) if e.uses().is_empty());
                        out.push_str(if digit(factor) { r" \cdot " } else { r"\," });
                    }
                    factor.write(ledger, form, Place::Factor, out);
                }
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
