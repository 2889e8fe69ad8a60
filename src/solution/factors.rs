//! Products and ratios of symbols that cancel what they can: velocity ratios, masses, moments of inertia.
use crate::solution::expr::{Expr, SymbolId, ZERO, minus, power, product, reduced};
use crate::solution::symbols::Symbols;

/// `constant * over / under`; factors that occur above and below are gone.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    constant: (i64, i64),
    over: Vec<Expr>,
    under: Vec<Expr>,
}

/// What of `from` is not in `taken`, each as often as it stands there more.
fn without(from: &[Expr], taken: &[Expr]) -> Vec<Expr> {
    let mut left = taken.to_vec();
    let mut out = Vec::new();
    for factor in from {
        match left.iter().position(|l| l == factor) {
            Some(i) => {
                left.remove(i);
            }
            None => out.push(factor.clone()),
        }
    }
    out
}

impl Factors {
    /// 1.
    pub fn one() -> Self {
        Self { constant: (1, 1), over: Vec::new(), under: Vec::new() }
    }
    /// 0.
    pub fn zero() -> Self {
        Self { constant: (0, 1), ..Self::one() }
    }
    /// An expression, taken apart into its factors.
    pub fn of(expr: &Expr) -> Self {
        match expr {
            Expr::Number(a, b) => Self { constant: (*a, *b), ..Self::one() },
            Expr::Minus(inner) => Self::of(inner).opposite(),
            Expr::Product(factors) => factors.iter().fold(Self::one(), |all, f| all.times(Self::of(f))),
            Expr::Quotient(over, under) => Self::of(over).per(Self::of(under)),
            Expr::Power(base, n) => (0..*n).fold(Self::one(), |all, _| all.times(Self::of(base))),
            other => Self { over: vec![other.clone()], ..Self::one() },
        }
    }
    /// Is it 0?
    pub fn is_zero(&self) -> bool {
        self.constant.0 == 0
    }
    /// Is it 1?
    pub fn is_one(&self) -> bool {
        *self == Self::one()
    }
    /// Is it a number?
    pub fn is_number(&self) -> bool {
        self.over.is_empty() && self.under.is_empty()
    }
    /// The symbols that both have, above or below.
    #[must_use]
    pub fn shared(&self, other: &Self) -> Self {
        let both = |a: &[Expr], b: &[Expr]| without(a, &without(a, b));
        Self { constant: (1, 1), over: both(&self.over, &other.over), under: both(&self.under, &other.under) }
    }
    /// The opposite.
    #[must_use]
    pub fn opposite(&self) -> Self {
        Self { constant: (-self.constant.0, self.constant.1), ..self.clone() }
    }
    /// With the sign of `sense`, which is 1 or -1.
    #[must_use]
    pub fn signed(&self, sense: i8) -> Self {
        if sense < 0 { self.opposite() } else { self.clone() }
    }
    /// The same without a minus in front where a difference that is negative takes it: `(R - r)/r` for `-(r - R)/r`.
    #[must_use]
    pub fn upright(&self, symbols: &Symbols) -> Self {
        let negative = |f: &Expr| matches!(f, Expr::Sum(_)) && f.value(symbols) < 0.0;
        let mut turned = self.opposite();
        let factor = turned.over.iter_mut().find(|f| negative(f));
        match factor {
            Some(Expr::Sum(terms)) if self.constant.0 < 0 => {
                let opposites = terms.drain(..).map(minus);
                let (below, above): (Vec<Expr>, Vec<Expr>) =
                    opposites.partition(|t| matches!(t, Expr::Minus(_)));
                *terms = [above, below].concat();
                turned
            }
            _ => self.clone(),
        }
    }
    /// The product.
    #[must_use]
    pub fn times(&self, other: impl Into<Self>) -> Self {
        let other = other.into();
        let (a, b) = (self.constant, other.constant);
        if self.is_zero() || other.is_zero() {
            return Self::zero();
        }
        let over = [self.over.clone(), other.over.clone()].concat();
        let under = [self.under.clone(), other.under.clone()].concat();
        Self {
            constant: reduced(a.0 * b.0, a.1 * b.1),
            over: without(&over, &under),
            under: without(&under, &over),
        }
    }
    /// The quotient; `other` is not 0.
    #[must_use]
    pub fn per(&self, other: impl Into<Self>) -> Self {
        let other = other.into();
        let turned = Self {
            constant: reduced(other.constant.1, if other.is_zero() { 1 } else { other.constant.0 }),
            over: other.under.clone(),
            under: other.over.clone(),
        };
        self.times(turned)
    }
    /// The square.
    #[must_use]
    pub fn squared(&self) -> Self {
        self.times(self)
    }
    /// The sum, over a common denominator, what both have put before it.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let common = without(&self.over, &without(&self.over, &other.over));
        let shared = without(&self.under, &without(&self.under, &other.under));
        let rest = |one: &Self, two: &Self| Self {
            constant: one.constant,
            over: [without(&one.over, &common), without(&two.under, &shared)].concat(),
            under: Vec::new(),
        };
        let (first, second) = (rest(self, other), rest(other, self));
        let under = [self.under.clone(), without(&other.under, &shared)].concat();
        let outside = Self { constant: (1, 1), over: common, under };
        if first.over == second.over {
            let (a, b) = (first.constant, second.constant);
            let constant = reduced(a.0 * b.1 + b.0 * a.1, a.1 * b.1);
            if constant.0 == 0 {
                return Self::zero();
            }
            return outside.times(&Self { constant, ..first });
        }
        let both = if first.constant.0 < 0 && second.constant.0 < 0 {
            return outside.times(Self::of(&(first.opposite().expr() + second.opposite().expr()))).opposite();
        } else if first.constant.0 < 0 {
            second.expr() - first.opposite().expr()
        } else {
            first.expr() + second.expr()
        };
        outside.times(Self::of(&both))
    }
    /// As an expression: powers collected.
    pub fn expr(&self) -> Expr {
        if self.is_zero() {
            return ZERO;
        }
        let collected = |list: &[Expr]| {
            let mut seen: Vec<(Expr, u32)> = Vec::new();
            for factor in list {
                match seen.iter_mut().find(|(f, _)| f == factor) {
                    Some((_, n)) => *n += 1,
                    None => seen.push((factor.clone(), 1)),
                }
            }
            product(seen.into_iter().map(|(f, n)| power(f, n)))
        };
        let positive = self.constant.0.abs();
        let size = match (positive, self.constant.1) {
            // A whole denominator goes below: c/2 and not 1/2 c.
            (over, under) if !self.under.is_empty() || self.over.is_empty() => {
                let below = Expr::Number(under, 1) * collected(&self.under);
                Expr::Number(over, 1) * collected(&self.over) / below
            }
            (over, under) => Expr::Number(over, under) * collected(&self.over),
        };
        if self.constant.0 < 0 { -size } else { size }
    }
}

impl<E: Into<Expr>> From<E> for Factors {
    fn from(expr: E) -> Self {
        Self::of(&expr.into())
    }
}

impl From<&Self> for Factors {
    fn from(factors: &Self) -> Self {
        factors.clone()
    }
}

/// Products and quotients in which equal factors above and below are gone.
pub trait Cancel {
    /// Its factors.
    fn factors(&self) -> Factors;
    /// The product.
    fn by(&self, other: impl Into<Factors>) -> Expr {
        self.factors().times(other).expr()
    }
    /// The quotient; `other` is not 0.
    fn over(&self, other: impl Into<Factors>) -> Expr {
        self.factors().per(other).expr()
    }
}

impl Cancel for Expr {
    fn factors(&self) -> Factors {
        Factors::of(self)
    }
}

impl Cancel for SymbolId {
    fn factors(&self) -> Factors {
        (*self).into()
    }
}

impl Cancel for Factors {
    fn factors(&self) -> Factors {
        self.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::Words;

    #[test]
    fn ratios_cancel_and_add() {
        let words = Words::english();
        let mut l = Symbols::new(&words);
        let mut symbol = |tex: &str| {
            let s = l.given(tex, 2.0, "2", "", false);
            Factors::of(&s.into())
        };
        let (c, p, m, k) = (symbol("c"), symbol("p"), symbol("m"), symbol("k"));
        let text = |f: &Factors| f.expr().symbols(&l);
        let turn = Factors::one().per(&c);
        assert_eq!(text(&turn), r"\frac{1}{c}");
        assert_eq!(text(&Factors::one().plus(&p.times(&turn))), r"\frac{c + p}{c}");
        assert_eq!(text(&Factors::one().plus(&p.times(&turn).opposite())), r"\frac{c - p}{c}");
        assert_eq!(text(&Factors::one().plus(&c.times(&turn))), "2");
        assert!(Factors::one().plus(&c.times(&turn).opposite()).is_zero());
        assert_eq!(text(&m.times(&k).times(&k).times(turn.squared())), r"\frac{m\,k^{2}}{c^{2}}");
        let half = Factors::of(&Expr::Number(1, 2));
        assert_eq!(text(&half.times(&m).times(c.squared()).times(turn.squared())), r"\tfrac{1}{2}\,m");
        assert_eq!(text(&half.times(&m).times(&turn).opposite()), r"-\frac{m}{2\,c}");
        assert!(c.per(&p).times(&p).per(&c).is_one());
        let mut l = Symbols::new(&words);
        let [small, large] = [("r", 2.0), ("R", 3.0)].map(|(tex, x)| {
            let s = l.given(tex, x, "", "", false);
            Factors::of(&s.into())
        });
        let back = small.plus(&large.opposite()).per(&small).opposite();
        assert_eq!(back.expr().symbols(&l), r"-\frac{r - R}{r}");
        assert_eq!(back.upright(&l).expr().symbols(&l), r"\frac{R - r}{r}");
        assert_eq!(back.opposite().upright(&l), back.opposite());
    }
}
