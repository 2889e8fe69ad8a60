//! What the solvers need of a number, so that the same equations run in doubles, in double-doubles and in enclosures.
use crate::num::{Dd, U};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// As near to a boundary of regimes is *at* it, 8 u.
const AT: f64 = 8.0 * U;

/// A number of the solvers: `f64`, [`Dd`], or [`crate::num::Ball`], which keeps account of its errors.
///
/// A type brings the first seven methods; the others follow from them, and an enclosure has some of its own. They are inlined where
/// speed counts; a page is to be small.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + std::fmt::Debug
{
    /// A sum below this share of its terms is rounding of this kind of number.
    const NOISE: f64 = crate::num::NOISE;
    /// A residual of equations below this share of the terms of its row is rounding: 2^-98 for double-doubles.
    const SETTLED: f64 = U * U * 256.0;
    /// A number that is given: a datum, or a number of the bank such as a mass of 20 kg.
    fn datum(value: f64) -> Self;
    /// Does it enclose the true value?
    const ENCLOSES: bool = false;
    /// The datum of this index: as [`Real::datum`], but an enclosure may be told to take a whole interval for it.
    fn given(_index: usize, value: f64) -> Self {
        Self::datum(value)
    }
    /// A constant.
    fn constant(value: Dd) -> Self;
    /// The value as a double-double.
    fn value(self) -> Dd;
    /// -1, 0 or 1; 0 for NaN.
    fn sign(self) -> f64;
    /// Square root; 0 where the value is not above 0 (a radicand that rounding made negative at a turning point).
    fn root(self) -> Self;
    /// Product with 2^e.
    fn scale2(self, e: i32) -> Self;
    /// Is it less? NaN is not.
    fn below(self, other: Self) -> bool;

    /// Bound of its error, where the number keeps account of its errors.
    fn radius(self) -> f64 {
        0.0
    }
    /// Encloses an error of at most `bound` too, where the number keeps account of its errors.
    fn widened(self, _bound: impl Fn() -> f64) -> Self {
        self
    }
    /// Does this kind of number hold no more digits than a double? Then no more need be worked out.
    fn is_double() -> bool {
        Self::NOISE > f64::EPSILON
    }
    /// An exact double.
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::constant(Dd::new(value))
    }
    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::constant(Dd::ZERO)
    }
    /// The value rounded to a double.
    #[inline(always)]
    fn f64(self) -> f64 {
        self.value().hi
    }
    /// Two functions of it that are worked out in doubles.
    fn each(self, f: impl Fn(f64) -> (f64, f64)) -> (Self, Self) {
        let (one, other) = f(self.f64());
        (Self::of(one), Self::of(other))
    }
    /// A function of two numbers that is worked out in doubles.
    fn pairwise(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self::of(f(self.f64(), other.f64()))
    }
    /// Decides how something is computed, not what comes out: of several sets of data the first one alone decides.
    #[inline(always)]
    fn leading<R>(decide: impl FnOnce() -> R) -> R {
        decide()
    }
    /// The number, or the other one where it is not finite.
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        if self.is_finite() { self } else { other }
    }
    /// Is the value exactly zero?
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.f64() == 0.0
    }
    /// May terms with it as a factor be left out? Only to save them.
    #[inline(always)]
    fn is_nothing(self) -> bool {
        self.is_zero()
    }
    /// Is it the same number, so that what was computed from the one holds for the other? No question of what is true: two
    /// enclosures are the same if their ends are.
    #[inline(always)]
    fn same(self, other: Self) -> bool {
        (self - other).is_zero()
    }
    /// Its magnitude.
    #[inline(always)]
    fn size(self) -> f64 {
        self.f64().abs()
    }
    /// Is it infinite or NaN?
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.f64().is_finite()
    }
    /// Is it at most so large?
    #[inline(always)]
    fn within(self, bound: f64) -> bool {
        self.size() <= bound
    }
    /// Is it nothing beside `scale`, but rounding of double-doubles?
    #[inline(always)]
    fn negligible(self, scale: f64) -> bool {
        self.size() <= Self::NOISE * scale
    }
    /// At most `limit`, up to what double-doubles leave of a difference of equals; NaN is not.
    #[inline(always)]
    fn at_most(self, limit: Self) -> bool {
        !self.f64().is_nan() && !limit.f64().is_nan() && self.side(limit) <= 0.0
    }
    /// -1 below, 0 at, 1 above the other, up to what double-doubles leave of a difference of equals; 0 beside NaN.
    #[inline(always)]
    fn side(self, other: Self) -> f64 {
        let larger = self.size().max(other.size());
        if larger.is_finite() && (self - other).negligible(larger) {
            0.0
        } else if self.below(other) {
            -1.0
        } else if other.below(self) {
            1.0
        } else {
            0.0
        }
    }
    /// Absolute value.
    #[inline(always)]
    fn abs(self) -> Self {
        if self.sign() < 0.0 { -self } else { self }
    }
    /// The same with its sign turned if `sign < 0`, zero if `sign == 0`.
    #[inline(always)]
    fn signed(self, sign: f64) -> Self {
        if sign > 0.0 {
            self
        } else if sign < 0.0 {
            -self
        } else {
            Self::zero()
        }
    }
    /// -1 below, 0 at, 1 above a boundary of regimes: *at* is within 8 u of it, for a datum that is printed as a decimal is
    /// known no better than to half a u. 0 beside NaN.
    #[inline(always)]
    fn status(self, boundary: Self) -> f64 {
        let larger = self.size().max(boundary.size());
        if larger.is_finite() && (self - boundary).size() <= AT * larger { 0.0 } else { self.side(boundary) }
    }
    /// Difference of two numbers that are equal at a boundary of regimes: exactly zero within 8 u.
    #[inline(always)]
    fn apart(self, other: Self) -> Self {
        let apart = self - other;
        if apart.size() <= AT * self.size().max(other.size()) { Self::zero() } else { apart }
    }
    /// The same, or exactly zero where it is nothing beside `scale`, the sum of the magnitudes of the terms that made it:
    /// what then is left is the rounding of double-doubles.
    #[inline(always)]
    fn cleared(self, scale: f64) -> Self {
        if self.negligible(scale) { Self::zero() } else { self }
    }
    /// Sum of two terms, [`Real::cleared`].
    #[inline(always)]
    fn balance(self, other: Self) -> Self {
        (self + other).cleared(self.size() + other.size())
    }
    /// Sum of two terms, exactly zero where no more is left than printed data leave open of them; an enclosure keeps it.
    #[inline(always)]
    fn settled(self, other: Self) -> Self {
        (self + other).cleared(self.size().max(other.size()) * (AT / Self::NOISE))
    }
    /// Quotient; over exactly zero it is infinite (0 over 0 is 0), whatever the data.
    #[inline(always)]
    fn over(self, under: Self) -> Self {
        if !under.is_zero() {
            self / under
        } else if self.is_zero() {
            Self::zero()
        } else {
            Self::of(self.sign() * f64::INFINITY)
        }
    }
    /// The larger of two.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self.below(other) { other } else { self }
    }
    /// At least the other, exactly; NaN is not.
    #[inline(always)]
    fn reaches(self, other: Self) -> bool {
        other.below(self) || (self - other).is_zero()
    }
    /// 0 or more; NaN is not.
    #[inline(always)]
    fn not_negative(self) -> bool {
        self.sign() > 0.0 || self.is_zero()
    }
    /// Square.
    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }
}

impl Real for Dd {
    #[inline(always)]
    fn datum(value: f64) -> Self {
        Dd::new(value)
    }
    #[inline(always)]
    fn constant(value: Dd) -> Self {
        value
    }
    #[inline(always)]
    fn value(self) -> Dd {
        self
    }
    #[inline(always)]
    fn sign(self) -> f64 {
        Real::sign(self.hi)
    }
    #[inline(always)]
    fn root(self) -> Self {
        // NaN is no radicand by rounding: it must not come out as a zero.
        if self.hi > 0.0 || self.hi.is_nan() { self.sqrt() } else { Dd::ZERO }
    }
    #[inline(always)]
    fn scale2(self, e: i32) -> Self {
        Dd::scale2(self, e)
    }
    #[inline(always)]
    fn below(self, other: Self) -> bool {
        self < other
    }
}
