//! Expressions of a bank: symbols of data, names of quantities, numbers, `pi`, `+ - * / ^ ( )`, `sqrt`, `abs`, `sin`,
//! `cos`, `tan`, `asin`, `acos`, `atan`. They stand where a scene has a number, and in bounds, wrong methods and relations between parts.
//!
//! Values are SI. Dimensions are checked where they are known; the radian counts as a pure number here.
use crate::bank::node::{Faults, Node, shorten};
use crate::bank::{Datum, measure};
use crate::num::decimal::nearest;
use crate::num::formula::{self, Formula};
use crate::num::trig;
use crate::scene::Label;
use serde::{Deserialize, Serialize};

/// Exponents of the base units, in quarters, so that square roots stay whole; the angle is left out.
pub type Exponents = [i32; 3];

/// Deepest nesting that is read.
const DEPTH: usize = (formula::STACK - 8) / 2;
/// Longest expression, in characters.
const LENGTH: usize = 400;

/// An expression, ready to be evaluated without allocation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Expression {
    formula: Formula<Name>,
    /// Dimension of the value.
    pub powers: Exponents,
}

/// What a name means.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Name {
    /// A datum, and whether it is held in degrees: expressions count angles in radians.
    Datum(usize, bool),
    /// A quantity of the solution.
    Quantity(Label),
    /// A quantity of the motion that follows (`next.t`).
    Next(Label),
}

/// What is wrong with an expression, and at which character (from 1).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpressionFault {
    /// Character, from 1.
    pub column: usize,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub hint: Option<String>,
}

impl ExpressionFault {
    pub fn tell(self, node: &Node, text: &str, faults: &Faults) {
        let message = format!("`{}`, character {}: {}", shorten(text), self.column, self.message);
        faults.maybe(node, message, self.hint);
    }
}

/// Looks up a name: its meaning and dimension, or what to say about it.
pub type Lookup<'a> = &'a dyn Fn(&str) -> Result<(Name, Exponents), (String, Option<String>)>;

impl Expression {
    /// Reads an expression.
    pub fn parse(text: &str, lookup: Lookup) -> Result<Self, ExpressionFault> {
        Self::read(text, lookup, true)
    }
    /// Reads an expression whose sums may add what cannot be added, as wrong methods do (`k + r^2`).
    pub fn parse_loosely(text: &str, lookup: Lookup) -> Result<Self, ExpressionFault> {
        Self::read(text, lookup, false)
    }
    fn read(text: &str, lookup: Lookup, strict: bool) -> Result<Self, ExpressionFault> {
        let chars: Vec<char> = text.chars().collect();
        let mut parser = Parser { chars: &chars, at: 0, steps: Vec::new(), depth: 0, strict, lookup };
        if chars.len() > LENGTH {
            return Err(parser.trouble(format!("longer than {LENGTH} characters")));
        }
        let powers = parser.sum()?;
        parser.blanks();
        if parser.at < chars.len() {
            return Err(parser.unexpected(chars[parser.at]));
        }
        Ok(Self { formula: Formula::new(parser.steps), powers })
    }
    /// The quantities that it names.
    pub fn quantities(&self) -> impl Iterator<Item = Label> {
        self.formula.names().filter_map(|name| match name {
            Name::Quantity(label) => Some(label),
            Name::Datum(..) | Name::Next(_) => None,
        })
    }
    /// The data that it names.
    pub fn data(&self) -> impl Iterator<Item = usize> {
        self.formula.names().filter_map(|name| match name {
            Name::Datum(i, _) => Some(i),
            Name::Quantity(_) | Name::Next(_) => None,
        })
    }
    /// Its value, SI; NaN where a quantity does not exist or the expression has no real value.
    pub fn eval(&self, data: &[f64], quantity: &dyn Fn(Label) -> f64) -> f64 {
        self.formula.eval(&|name| match name {
            Name::Datum(i, true) => {
                data.get(i).copied().unwrap_or(f64::NAN) * trig::radians_per_degree::<f64>()
            }
            Name::Datum(i, false) => data.get(i).copied().unwrap_or(f64::NAN),
            Name::Quantity(label) => quantity(label),
            Name::Next(_) => f64::NAN,
        })
    }
    pub fn formula(&self) -> &Formula<Name> {
        &self.formula
    }
}

/// The words of an expression: names, numbers and signs, without blanks.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text.trim_start();
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let joined = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let end = match joined(first) {
            true => rest.find(|c| !joined(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (word, after) = rest.split_at(end);
        rest = after.trim_start();
        Some(word)
    })
}

/// An expression in LaTeX, its data by their symbols.
pub fn tex(text: &str, data: &[Datum]) -> String {
    // What closes the brackets that are open.
    let (mut out, mut open) = (String::new(), Vec::new());
    let mut words = words(text).peekable();
    while let Some(word) = words.next() {
        let called = words.peek() == Some(&"(");
        let datum = data.iter().find(|d| d.symbol == word);
        let (opens, closes) = match word {
            _ if datum.is_some() => ("", ""),
            "sqrt" if called => ("\\sqrt{", "}"),
            "abs" if called => ("\\left|", "\\right|"),
            "sin" if called => ("\\sin(", ")"),
            "cos" if called => ("\\cos(", ")"),
            "tan" if called => ("\\tan(", ")"),
            "asin" if called => ("\\arcsin(", ")"),
            "acos" if called => ("\\arccos(", ")"),
            "atan" if called => ("\\arctan(", ")"),
            _ => ("", ""),
        };
        if !opens.is_empty() {
            words.next();
            out.push_str(opens);
            open.push(closes);
            continue;
        }
        match (datum, word) {
            (Some(datum), _) => out.push_str(&format!("{{{}}}", datum.tex)),
            (None, "(") => {
                open.push(")");
                out.push('(');
            }
            (None, ")") => out.push_str(open.pop().unwrap_or(")")),
            (None, "*") => out.push_str("\\,"),
            (None, "pi") => out.push_str("\\pi "),
            (None, other) => out.push_str(other),
        }
    }
    out
}

struct Parser<'a> {
    chars: &'a [char],
    at: usize,
    steps: Vec<formula::Step<Name>>,
    depth: usize,
    /// Must the terms of a sum have one dimension?
    strict: bool,
    lookup: Lookup<'a>,
}

impl Parser<'_> {
    fn trouble(&self, message: impl Into<String>) -> ExpressionFault {
        ExpressionFault { column: self.at + 1, message: message.into(), hint: None }
    }
    fn unexpected(&self, found: char) -> ExpressionFault {
        let mut fault = self.trouble(format!("`{found}` is not expected here"));
        if found.is_alphabetic() || found == '(' {
            let hint = "factors are joined by `*`, and numbers of an expression have no unit: make a datum of one that has";
            fault.hint = Some(hint.to_owned());
        }
        fault
    }
    /// A bracket is not closed where it should be: something else stands there, or nothing.
    fn unclosed(&self) -> ExpressionFault {
        match self.chars.get(self.at) {
            Some(found) if found.is_alphabetic() || *found == '(' => self.unexpected(*found),
            _ => self.trouble("`)` is missing"),
        }
    }
    fn blanks(&mut self) {
        while self.chars.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
    }
    fn peek(&mut self) -> Option<char> {
        self.blanks();
        self.chars.get(self.at).copied()
    }
    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += 1;
        }
        found
    }
    fn deeper(&mut self) -> Result<(), ExpressionFault> {
        self.depth += 1;
        if self.depth > DEPTH { Err(self.trouble("nested too deeply")) } else { Ok(()) }
    }
    fn sum(&mut self) -> Result<Exponents, ExpressionFault> {
        self.deeper()?;
        let first = self.product()?;
        loop {
            let step = if self.take('+') {
                formula::Step::Add
            } else if self.take('-') {
                formula::Step::Subtract
            } else {
                break;
            };
            let start = self.at;
            let next = self.product()?;
            if self.strict && next != first {
                self.at = start;
                return Err(self.trouble(format!(
                    "the terms of a sum have different dimensions, {} and {}",
                    measure::powers_text(first),
                    measure::powers_text(next)
                )));
            }
            self.steps.push(step);
        }
        self.depth -= 1;
        Ok(first)
    }
    fn product(&mut self) -> Result<Exponents, ExpressionFault> {
        let mut powers = self.signed()?;
        loop {
            let (step, sign) = if self.take('*') || self.take('·') {
                (formula::Step::Multiply, 1)
            } else if self.take('/') {
                (formula::Step::Divide, -1)
            } else {
                return Ok(powers);
            };
            let next = self.signed()?;
            for (p, n) in powers.iter_mut().zip(next) {
                *p = self.small(*p + sign * n)?;
            }
            self.steps.push(step);
        }
    }
    fn small(&self, exponent: i32) -> Result<i32, ExpressionFault> {
        if exponent.abs() > 400 { Err(self.trouble("an exponent is too large")) } else { Ok(exponent) }
    }
    fn signed(&mut self) -> Result<Exponents, ExpressionFault> {
        let mut negative = false;
        while self.take('-') {
            negative = !negative;
        }
        let powers = self.raised()?;
        if negative {
            self.steps.push(formula::Step::Negate);
        }
        Ok(powers)
    }
    fn raised(&mut self) -> Result<Exponents, ExpressionFault> {
        let mut powers = self.atom()?;
        if self.take('^') {
            let negative = self.take('-');
            self.blanks();
            let start = self.at;
            while self.chars.get(self.at).is_some_and(char::is_ascii_digit) {
                self.at += 1;
            }
            let digits: String = self.chars[start..self.at].iter().collect();
            let n: i32 = match digits.parse() {
                Ok(n) if n <= 9 => n,
                _ => return Err(self.trouble("an exponent is a whole number up to 9")),
            };
            let n = if negative { -n } else { n };
            for p in &mut powers {
                *p = self.small(p.saturating_mul(n))?;
            }
            self.steps.push(formula::Step::Power(n));
        }
        Ok(powers)
    }
    fn atom(&mut self) -> Result<Exponents, ExpressionFault> {
        let Some(c) = self.peek() else {
            return Err(self.trouble("something is missing at the end"));
        };
        if c == '(' {
            self.at += 1;
            let powers = self.sum()?;
            if !self.take(')') {
                return Err(self.unclosed());
            }
            return Ok(powers);
        }
        let start = self.at;
        if c.is_ascii_digit() || c == '.' {
            while self.chars.get(self.at).is_some_and(|c| c.is_ascii_digit() || *c == '.') {
                self.at += 1;
            }
            let digits: String = self.chars[start..self.at].iter().collect();
            return match nearest(&digits) {
                Some(x) if x.is_finite() => {
                    self.steps.push(formula::Step::Number(x));
                    Ok([0; 3])
                }
                _ => {
                    self.at = start;
                    Err(self.trouble(format!("`{digits}` is not a number")))
                }
            };
        }
        if c.is_alphabetic() || c == '_' {
            while self.chars.get(self.at).is_some_and(|c| c.is_alphanumeric() || *c == '_' || *c == '.') {
                self.at += 1;
            }
            let name: String = self.chars[start..self.at].iter().collect();
            let functions = ["sqrt", "abs", "sin", "cos", "tan", "asin", "acos", "atan"];
            if functions.contains(&name.as_str()) && self.peek() == Some('(') {
                self.at += 1;
                let mut powers = self.sum()?;
                if !self.take(')') {
                    return Err(self.unclosed());
                }
                match name.as_str() {
                    "sqrt" => {
                        for p in &mut powers {
                            if self.strict && *p % 2 != 0 {
                                return Err(
                                    self.trouble("this square root has no dimension that makes sense")
                                );
                            }
                            *p /= 2;
                        }
                        self.steps.push(formula::Step::Sqrt);
                    }
                    "abs" => self.steps.push(formula::Step::Abs),
                    _ if self.strict && powers != [0; 3] => {
                        self.at = start;
                        let what = if name.starts_with('a') { "a pure number" } else { "an angle" };
                        return Err(self.trouble(format!("`{name}` takes {what}")));
                    }
                    "sin" => self.steps.push(formula::Step::Sin),
                    "asin" => self.steps.push(formula::Step::Asin),
                    "acos" => self.steps.push(formula::Step::Acos),
                    "atan" => self.steps.push(formula::Step::Atan),
                    "tan" => self.steps.push(formula::Step::Tan),
                    _ => self.steps.push(formula::Step::Cos),
                }
                return Ok(powers);
            }
            if name == "pi" && (self.lookup)(&name).is_err() {
                self.steps.push(formula::Step::Pi);
                return Ok([0; 3]);
            }
            return match (self.lookup)(&name) {
                Ok((meaning, powers)) => {
                    self.steps.push(formula::Step::Name(meaning));
                    Ok(powers)
                }
                Err((message, hint)) => Err(ExpressionFault { column: start + 1, message, hint }),
            };
        }
        Err(self.trouble(format!("`{c}` is not expected here")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Expression, ExpressionFault> {
        Expression::parse(text, &|name| match name {
            "k" => Ok((Name::Datum(0, false), [4, 0, 0])),
            "r" => Ok((Name::Datum(1, false), [4, 0, 0])),
            _ => Err((format!("`{name}` is not known"), None)),
        })
    }

    #[test]
    fn values_and_dimensions() {
        let value = |text: &str| read(text).map(|e| e.eval(&[3.0, 4.0], &|_| f64::NAN));
        assert_eq!(value("k / r"), Ok(0.75));
        assert_eq!(value("sqrt(k^2 + r^2)"), Ok(5.0));
        assert_eq!(value("-k^2 + 2*r*(k - r)"), Ok(-17.0));
        assert_eq!(value("abs(k - r) / r^-1"), Ok(4.0));
        assert!(value("sin(k / r)").is_ok_and(|s| (s - 0.681_638_760_023_334_2).abs() < 1e-15));
        assert!(value("cos(k / r)^2 + sin(k / r)^2").is_ok_and(|s| (s - 1.0).abs() < 1e-15));
        assert!(value("tan(k / r) * cos(k / r) - sin(k / r)").is_ok_and(|s| s.abs() < 1e-15));
        assert!(value("atan(k / r)").is_ok_and(|a| (a - 0.643_501_108_793_284_4).abs() < 1e-15));
        assert_eq!(value("1 - 2 - 3"), Ok(-4.0));
        assert_eq!(value("8 / 4 / 2"), Ok(1.0));
        assert_eq!(read("k*r").map(|e| e.powers[0]), Ok(8));
    }

    #[test]
    fn troubles() {
        for text in [
            "",
            "k +",
            "k + 1",
            "(k",
            "k ^ r",
            "q",
            "1.2.3",
            "k k",
            "sqrt(k)*",
            "sqrt(sqrt(sqrt(k)))",
            "k^99",
            "sin(k)",
            "atan(k)",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
        assert!(read(&"(".repeat(500)).is_err());
        assert!(read(&"(".repeat(100)).is_err());
        assert!(read(&"-".repeat(300)).is_err());
    }

    #[test]
    fn the_stack_holds_the_deepest_expression() {
        let deep = format!("{}k{}", "k+k*(".repeat(22), ")".repeat(22));
        // Dimensions do not fit, so use pure numbers.
        let deep = deep.replace('k', "1");
        assert!(read(&deep).is_ok_and(|e| e.eval(&[], &|_| 0.0).is_finite()));
    }
}
