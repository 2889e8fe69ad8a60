//! Products and ratios of symbols that cancel what they can: velocity ratios, masses, moments of inertia.
use crate::solution::expr::{
    Expr, Function, ONE, SymbolId, ZERO, cosine, minus, power, product, reduced, root, sine, sum,
};
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
        let differs =
            |f: &Expr| matches!(f, Expr::Sum(all) if all.iter().any(|t| matches!(t, Expr::Minus(_))));
        let negative = |f: &Expr| differs(f) && f.value(symbols) < 0.0;
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
    /// Each term of a sum, with this in front.
    pub fn each(&self, of: &Sum) -> Sum {
        of.0.iter().map(|term| self.times(term)).collect()
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
        let Self { over: common, under: shared, .. } = self.shared(other);
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
        // What stands on both sides of a difference of sums falls out: b - (b - c).
        let terms = both.terms();
        let gathered = Sum::of(terms.iter().map(Self::of));
        if gathered.0.len() < terms.len() {
            return if gathered.is_zero() { Self::zero() } else { outside.times(Self::of(&gathered.expr())) };
        }
        outside.times(Self::of(&both))
    }
    /// Multiplied out where a factor is a sum that holds this symbol.
    pub fn spread(&self, symbol: SymbolId) -> Vec<Self> {
        let holds = |f: &&Expr| matches!(f, Expr::Sum(_)) && f.uses().contains(&symbol);
        let Some(factor) = self.over.iter().find(holds) else { return vec![self.clone()] };
        let rest = self.per(factor);
        factor.parts().into_iter().flat_map(|term| rest.times(term).spread(symbol)).collect()
    }
    /// Its derivative by a symbol that stands above.
    pub fn slope(&self, by: SymbolId) -> Sum {
        self.over.iter().map(|factor| self.per(factor).times(factor.slope(by, &ONE))).collect()
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
        let (over, under) = (self.constant.0.abs(), self.constant.1);
        let size = if !self.under.is_empty() || self.over.is_empty() {
            // A whole denominator goes below: c/2 and not 1/2 c.
            let below = Expr::Number(under, 1) * collected(&self.under);
            Expr::Number(over, 1) * collected(&self.over) / below
        } else {
            Expr::Number(over, under) * collected(&self.over)
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
pub trait Cancel: Clone + Into<Factors> {
    fn factors(&self) -> Factors {
        self.clone().into()
    }
    /// The product.
    fn by(&self, other: impl Into<Factors>) -> Expr {
        self.factors().times(other).expr()
    }
    /// The quotient; `other` is not 0.
    fn over(&self, other: impl Into<Factors>) -> Expr {
        self.factors().per(other).expr()
    }
}

impl<T: Clone + Into<Factors>> Cancel for T {}

/// A sum of products: what is equal is gathered, and products of sines and cosines are put together by the addition theorems.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sum(Vec<Factors>);

/// A wave and its angle, where a factor is one of a single angle: sine or cosine.
fn wave(factor: &Expr) -> Option<(bool, &Expr)> {
    match factor {
        Expr::Of(Function::Sine, angle) => Some((true, angle)),
        Expr::Of(Function::Cosine, angle) => Some((false, angle)),
        _ => None,
    }
}

/// `sin a cos b - cos a sin b = sin(a - b)` and its likes, of two terms.
fn together(one: &Factors, other: &Factors) -> Option<Factors> {
    let common = one.shared(other);
    let (one, other) = (one.per(&common), other.per(&common));
    let plain = |f: &Factors| f.under.is_empty() && f.over.len() == 2;
    let same = one.constant == other.constant;
    let opposite = one.constant == (-other.constant.0, other.constant.1);
    if !plain(&one) || !plain(&other) || !same && !opposite {
        return None;
    }
    let waves = |f: &Factors| Some([wave(&f.over[0])?, wave(&f.over[1])?].map(|(s, a)| (s, a.clone())));
    let [(s, a), (t, b)] = waves(&one)?;
    let rest = waves(&other)?;
    let turned = [(!s, a.clone()), (!t, b.clone())];
    if rest != turned && rest != [turned[1].clone(), turned[0].clone()] {
        return None;
    }
    let constant = Factors { constant: one.constant, ..Factors::one() };
    let angle = |whole: Expr| Factors::of(&whole);
    let found = match (s, t, same) {
        (false, false, true) | (true, true, true) if a == b => Factors::one(),
        (false, false, true) | (true, true, true) => angle(cosine(a - b)),
        (true, false, true) | (false, true, true) => angle(sine(a + b)),
        (true, false, false) => angle(sine(a - b)),
        (false, true, false) => angle(sine(b - a)),
        _ if a == b => return None,
        (false, false, false) => angle(cosine(a + b)),
        (true, true, false) => angle(cosine(a + b)).opposite(),
    };
    Some(common.times(constant).times(found))
}

/// What all terms have in front, a number and the common denominator too.
fn common(all: &[Factors]) -> Factors {
    let common = all.iter().cloned().reduce(|common, t| common.shared(&t)).unwrap_or_else(Factors::one);
    let divisor = |a: i64, b: i64| a.abs() / reduced(a.abs(), b.abs().max(1)).0.max(1);
    let over = all.iter().fold(0, |d, t| if d == 0 { t.constant.0.abs() } else { divisor(d, t.constant.0) });
    let under = all.iter().fold(1, |m, t| m / divisor(m, t.constant.1) * t.constant.1);
    let sense = if all.iter().all(|t| t.constant.0 < 0) { -1 } else { 1 };
    Factors { constant: reduced(sense * over.max(1), under), ..common }
}

/// The same, a number only beside other factors or where it is that of each term; and the sum that is left.
fn gathered(all: &[Factors]) -> (Factors, Expr) {
    let [first, others @ ..] = all else { return (Factors::one(), ZERO) };
    if others.is_empty() {
        return (first.clone(), Expr::Number(1, 1));
    }
    let mut common = common(all);
    let size = |t: &Factors| (t.constant.0.abs(), t.constant.1);
    if common.over.is_empty() && common.under.is_empty() && others.iter().any(|t| size(t) != size(first)) {
        common = Factors::one();
    }
    let inner = sum(all.iter().map(|t| t.per(&common).expr()));
    (common, inner)
}

impl Sum {
    /// Of these terms.
    pub fn of(terms: impl IntoIterator<Item = Factors>) -> Self {
        let mut all: Vec<Factors> = Vec::new();
        for mut term in terms {
            // What is found by putting two together may go together with a third.
            while let Some((at, both)) = all.iter().enumerate().find_map(|(at, known)| {
                let same = |a: &[Expr], b: &[Expr]| a.len() == b.len() && without(a, b).is_empty();
                let equal = same(&known.over, &term.over) && same(&known.under, &term.under);
                let both = || known.plus(&Factors { constant: term.constant, ..known.clone() });
                Some((at, equal.then(both).or_else(|| together(known, &term))?))
            }) {
                all.remove(at);
                term = both;
            }
            if !term.is_zero() {
                all.push(term);
            }
        }
        Self(all)
    }
    /// Of a single one.
    pub fn one(term: impl Into<Factors>) -> Self {
        Self::of([term.into()])
    }
    /// Is it 0?
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }
    pub fn terms(&self) -> &[Factors] {
        &self.0
    }
    /// The sum of both.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self::of(self.0.iter().chain(&other.0).cloned())
    }
    /// The difference.
    #[must_use]
    pub fn less(&self, other: &Self) -> Self {
        self.plus(&other.opposite())
    }
    /// With an expression in the place of a symbol.
    #[must_use]
    pub fn put(&self, symbol: SymbolId, other: &Expr) -> Self {
        let put = |list: &[Expr]| Factors::of(&product(list.iter().map(|f| f.put(symbol, other))));
        let put = |t: &Factors| {
            Factors { constant: t.constant, ..Factors::one() }.times(put(&t.over)).per(put(&t.under))
        };
        Self::of(self.0.iter().map(put))
    }
    /// Each term times this.
    #[must_use]
    pub fn times(&self, factor: impl Into<Factors>) -> Self {
        let factor = factor.into();
        Self::of(self.0.iter().map(|t| t.times(&factor)))
    }
    /// The opposite.
    #[must_use]
    pub fn opposite(&self) -> Self {
        self.times(Expr::Number(-1, 1))
    }
    /// With the sign of `sense`, which is 1 or -1.
    #[must_use]
    pub fn signed(&self, sense: i8) -> Self {
        if sense < 0 { self.opposite() } else { self.clone() }
    }
    /// Both sides of an equation that says it is 0, without a minus in front.
    pub fn sides(&self) -> [Expr; 2] {
        let (plus, minus): (Vec<Factors>, Vec<Factors>) =
            self.0.iter().cloned().partition(|t| t.constant.0 >= 0);
        [Self::of(plus).expr(), Self::of(minus).opposite().expr()]
    }
    /// The product, term by term.
    #[must_use]
    pub fn by(&self, other: &Self) -> Self {
        Self::of(self.0.iter().flat_map(|a| other.0.iter().map(move |b| a.times(b))))
    }
    /// Without what all terms have in front, but for these symbols.
    #[must_use]
    pub fn primitive(&self, but: &[SymbolId]) -> Self {
        let mut common = common(&self.0);
        common.over.retain(|f| !but.iter().any(|s| *f == Expr::Symbol(*s)));
        self.times(Factors::one().per(common))
    }
    /// As an expression: what is added first, what all have in front.
    pub fn expr(&self) -> Expr {
        let (less, more): (Vec<Factors>, Vec<Factors>) =
            self.0.iter().cloned().partition(|t| t.constant.0 < 0);
        let all = [more, less].concat();
        match gathered(&all) {
            (common, inner) if common.is_one() => inner,
            (common, inner) => common.expr() * inner,
        }
    }
    /// Its root, what is a square in front of the radical.
    pub fn rooted(&self) -> Expr {
        let (common, inner) = gathered(&self.0);
        let halves = |list: &[Expr]| {
            let mut left = list.to_vec();
            let (mut outside, mut inside) = (Vec::new(), Vec::new());
            while let Some(factor) = left.pop() {
                match left.iter().position(|l| *l == factor) {
                    Some(at) => {
                        left.remove(at);
                        outside.insert(0, factor);
                    }
                    None => inside.insert(0, factor),
                }
            }
            (outside, inside)
        };
        let whole = |n: i64| (1..=n.abs().min(4096)).find(|i| i * i == n);
        let (over, under) = (halves(&common.over), halves(&common.under));
        let (constant, rest) = match (whole(common.constant.0), whole(common.constant.1)) {
            (Some(a), Some(b)) => ((a, b), (1, 1)),
            _ => ((1, 1), common.constant),
        };
        let outside = Self::one(Factors { constant, over: over.0, under: under.0 });
        let inside = Factors { constant: rest, over: over.1, under: under.1 }.times(&inner);
        let outside = outside.expr();
        if inside.is_one() { outside } else { outside.by(root(inside.expr())) }
    }
}

impl FromIterator<Factors> for Sum {
    fn from_iter<I: IntoIterator<Item = Factors>>(terms: I) -> Self {
        Self::of(terms)
    }
}

impl std::iter::Sum for Sum {
    fn sum<I: Iterator<Item = Self>>(sums: I) -> Self {
        sums.flat_map(|sum| sum.0).collect()
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
