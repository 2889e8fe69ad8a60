//! Expressions in symbols: what a step of a solution says, before it is text. Operators and functions build them and leave out
//! what says nothing (a term 0, a factor 1): `ratio(1, 2) * m * square(v)`.
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A quantity of a solution: its place among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SymbolId(pub(super) usize);

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Expr {
    /// A number that belongs to the formula and not to the data: `1/2`, `2`, `-1`; the denominator is > 0.
    Number(i64, i64),
    /// A quantity.
    Symbol(SymbolId),
    /// The opposite.
    Minus(Box<Expr>),
    /// A sum; terms that are [`Expr::Minus`] are subtracted.
    Sum(Vec<Expr>),
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
    Magnitude,
    /// The angle, in radians, whose cosine it is.
    ArcCosine,
    /// The angle, in radians, whose tangent it is.
    ArcTangent,
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
            other => {
                // A weight: the g of W / g and the g after it.
                let over =
                    kept.iter().position(|k| matches!(k, Expr::Quotient(_, under) if **under == other));
                match over.map(|at| kept.remove(at)) {
                    Some(Expr::Quotient(over, _)) => waiting.push(*over),
                    _ => kept.push(other),
                }
            }
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

/// A fraction in lowest terms, its denominator > 0.
pub fn reduced(over: i64, under: i64) -> (i64, i64) {
    let (mut a, mut b) = (over, under);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let divisor = a.abs().max(1) * under.signum();
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

/// `over / under`; equal ones give 1, an `under` of 1 falls out, signs go to the front.
fn quotient(over: Expr, under: Expr) -> Expr {
    if over == under {
        return ONE;
    }
    match (over, under) {
        (Expr::Number(0, _), _) => ZERO,
        (over, Expr::Number(1, 1)) => over,
        (Expr::Number(a, b), Expr::Number(c, d)) if c != 0 => {
            let (over, under) = reduced(a * d, b * c);
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
        (Expr::Root(inner), 2) => *inner,
        (Expr::Sum(terms), n) if n % 2 == 0 && terms.iter().all(|t| matches!(t, Expr::Minus(_))) => {
            power(minus(Expr::Sum(terms)), n)
        }
        (base, n) => Expr::Power(Box::new(base), n),
    }
}

/// The expression, or its opposite.
pub fn signed(of: Expr, positive: bool) -> Expr {
    if positive { of } else { minus(of) }
}

/// The opposite of an expression if `sense` is negative.
pub fn in_sense(of: Expr, sense: f64) -> Expr {
    if sense < 0.0 { minus(of) } else { of }
}

/// A sum that begins with what is added; equal terms are one, with their number.
pub fn positive_first(terms: impl IntoIterator<Item = Expr>) -> Expr {
    let mut counted: Vec<(Expr, i64)> = Vec::new();
    for term in terms.into_iter().flat_map(|t| if let Expr::Sum(inner) = t { inner } else { vec![t] }) {
        match counted.iter_mut().find(|(known, _)| *known == term) {
            Some((_, count)) => *count += 1,
            None => counted.push((term, 1)),
        }
    }
    let all = counted.into_iter().map(|(term, n)| if n == 1 { term } else { product([number(n), term]) });
    let (minus, plus): (Vec<Expr>, Vec<Expr>) = all.partition(|t| matches!(t, Expr::Minus(_)));
    sum(plus.into_iter().chain(minus))
}

pub fn square(base: impl Into<Expr>) -> Expr {
    power(base.into(), 2)
}

/// The square root.
pub fn root(of: impl Into<Expr>) -> Expr {
    Expr::Root(Box::new(of.into()))
}

/// Sine; that of 0 is 0.
pub fn sine(of: impl Into<Expr>) -> Expr {
    match of.into() {
        Expr::Number(0, _) => ZERO,
        angle => Expr::Of(Function::Sine, Box::new(angle)),
    }
}

/// Cosine; that of 0 is 1.
pub fn cosine(of: impl Into<Expr>) -> Expr {
    match of.into() {
        Expr::Number(0, _) => ONE,
        angle => Expr::Of(Function::Cosine, Box::new(angle)),
    }
}

/// The angle from 0 to pi with this cosine.
pub fn arc_cosine(of: impl Into<Expr>) -> Expr {
    Expr::Of(Function::ArcCosine, Box::new(of.into()))
}

/// The angle from -pi/2 to pi/2 with this tangent.
pub fn arc_tangent(of: impl Into<Expr>) -> Expr {
    Expr::Of(Function::ArcTangent, Box::new(of.into()))
}

/// The length of a vector with these components.
pub fn length(x: impl Into<Expr>, y: impl Into<Expr>) -> Expr {
    root(square(x) + square(y))
}

pub fn magnitude(of: impl Into<Expr>) -> Expr {
    Expr::Of(Function::Magnitude, Box::new(of.into()))
}

impl From<SymbolId> for Expr {
    fn from(symbol: SymbolId) -> Self {
        Self::Symbol(symbol)
    }
}

impl From<&Self> for Expr {
    fn from(expr: &Self) -> Self {
        expr.clone()
    }
}

impl From<i64> for Expr {
    fn from(value: i64) -> Self {
        number(value)
    }
}

/// The operators between whatever is an expression, the left one of this type.
macro_rules! operators {
    ($($left:ty)*) => {$(
        impl<E: Into<Expr>> Add<E> for $left {
            type Output = Expr;
            fn add(self, other: E) -> Expr {
                sum([self.into(), other.into()])
            }
        }
        impl<E: Into<Expr>> Sub<E> for $left {
            type Output = Expr;
            fn sub(self, other: E) -> Expr {
                sum([self.into(), minus(other.into())])
            }
        }
        impl<E: Into<Expr>> Mul<E> for $left {
            type Output = Expr;
            fn mul(self, other: E) -> Expr {
                product([self.into(), other.into()])
            }
        }
        impl<E: Into<Expr>> Div<E> for $left {
            type Output = Expr;
            fn div(self, other: E) -> Expr {
                quotient(self.into(), other.into())
            }
        }
        impl Neg for $left {
            type Output = Expr;
            fn neg(self) -> Expr {
                minus(self.into())
            }
        }
    )*};
}
operators! { Expr &Expr SymbolId }

impl Expr {
    /// With another expression in the place of a symbol.
    pub fn put(&self, symbol: SymbolId, other: &Self) -> Self {
        let put = |e: &Self| e.put(symbol, other);
        match self {
            Self::Symbol(s) if *s == symbol => other.clone(),
            Self::Number(..) | Self::Symbol(_) => self.clone(),
            Self::Minus(inner) => minus(put(inner)),
            Self::Sum(terms) => sum(terms.iter().map(put)),
            Self::Product(factors) => product(factors.iter().map(put)),
            Self::Quotient(over, under) => quotient(put(over), put(under)),
            Self::Power(base, n) => power(put(base), *n),
            Self::Root(inner) => root(put(inner)),
            Self::Of(Function::Sine, inner) => sine(put(inner)),
            Self::Of(Function::Cosine, inner) => cosine(put(inner)),
            Self::Of(function, inner) => Self::Of(*function, Box::new(put(inner))),
        }
    }

    /// Its derivative by an angle in radians, where the symbol that holds this angle changes by `per`: an angle in degrees by
    /// `180/pi`, within sines and cosines by 1.
    pub fn slope(&self, by: SymbolId, per: &Self) -> Self {
        let of = |e: &Self| e.slope(by, per);
        match self {
            Self::Symbol(s) if *s == by => per.clone(),
            Self::Number(..) | Self::Symbol(_) => ZERO,
            Self::Minus(inner) => minus(of(inner)),
            Self::Sum(terms) => sum(terms.iter().map(of)),
            Self::Product(factors) => sum((0..factors.len()).map(|i| {
                let mut each = factors.clone();
                each[i] = of(&factors[i]);
                product(each)
            })),
            Self::Quotient(over, under) => {
                let fixed = quotient(of(over), (**under).clone());
                sum([fixed, minus(product([quotient(self.clone(), (**under).clone()), of(under)]))])
            }
            Self::Power(base, n) => {
                product([number(i64::from(*n)), power((**base).clone(), n - 1), of(base)])
            }
            Self::Root(inner) => quotient(of(inner), product([number(2), self.clone()])),
            Self::Of(Function::Sine, inner) => product([cosine(&**inner), inner.slope(by, &ONE)]),
            Self::Of(Function::Cosine, inner) => minus(product([sine(&**inner), inner.slope(by, &ONE)])),
            Self::Of(Function::Magnitude, inner) => {
                product([quotient(self.clone(), (**inner).clone()), of(inner)])
            }
            Self::Of(Function::ArcCosine, inner) => {
                let under = root(sum([ONE, minus(power((**inner).clone(), 2))]));
                minus(quotient(of(inner), under))
            }
            Self::Of(Function::ArcTangent, inner) => {
                quotient(of(inner), sum([ONE, power((**inner).clone(), 2)]))
            }
        }
    }

    /// Its terms: itself where it is no sum.
    pub fn terms(&self) -> Vec<Self> {
        if let Self::Sum(terms) = self { terms.clone() } else { vec![self.clone()] }
    }

    /// The expressions that it is made of.
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Number(..) | Self::Symbol(_) => Vec::new(),
            Self::Minus(inner) | Self::Power(inner, _) | Self::Root(inner) | Self::Of(_, inner) => {
                vec![inner]
            }
            Self::Sum(parts) | Self::Product(parts) => parts.iter().collect(),
            Self::Quotient(over, under) => vec![over, under],
        }
    }

    /// The symbols in it, each once, in order.
    pub fn uses(&self) -> Vec<SymbolId> {
        let mut found = match self {
            Self::Symbol(s) => vec![*s],
            _ => Vec::new(),
        };
        for symbol in self.parts().into_iter().flat_map(Self::uses) {
            if !found.contains(&symbol) {
                found.push(symbol);
            }
        }
        found
    }
}
