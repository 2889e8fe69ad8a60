//! Numbers that keep account of their errors: a midpoint and a radius that provably hold the true value.
//!
//! Each operation adds to the radius what its operands bring, and a bound of its own rounding. The data themselves have a
//! radius: the double nearest to a printed decimal is not that decimal. A comparison that the radii leave open is
//! decided by the midpoints and noted as a *doubt*: nothing that was computed after it is proved ([`watch`]).
//! Source: Rump, *Verification methods*, Acta Numerica 19 (2010) 287-449, midpoint-radius arithmetic.
use crate::num::{Dd, Real, U};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Relative error of one double-double operation, far above the proved bounds (some 2^-103) of those in `dd.rs`.
pub const STEP: f64 = U / (1u64 << 45) as f64;
/// Radii are computed in doubles, a few operations each: this covers their rounding.
const UP: f64 = 1.0 + 16.0 * U;
/// Absolute error of an operation whose low parts underflow.
const FLOOR: f64 = 1e-300;
/// Relative error of a datum: the nearest double to a decimal, perhaps times a unit that is no power of ten.
const DATUM: f64 = 2.0 * U;

thread_local! {
    static DOUBT: Cell<bool> = const { Cell::new(false) };
    static SPREAD: Cell<Option<(usize, f64)>> = const { Cell::new(None) };
}

/// Runs a computation in which the datum of this index is known to within `radius` only.
pub fn spread<R>(index: usize, radius: f64, run: impl FnOnce() -> R) -> R {
    let before = SPREAD.replace(Some((index, radius)));
    let result = run();
    SPREAD.set(before);
    result
}

/// Runs a computation and says whether a comparison in it was left open.
pub fn watch<R>(run: impl FnOnce() -> R) -> (R, bool) {
    let before = DOUBT.replace(false);
    let result = run();
    (result, DOUBT.replace(before))
}

/// Runs a search whose comparisons prove nothing and need no proof: a doubt within it does not count.
pub fn unwatched<R>(run: impl FnOnce() -> R) -> R {
    let before = DOUBT.get();
    let result = run();
    DOUBT.set(before);
    result
}

/// A number known to lie within `radius` of `mid`; nothing is known where the radius is infinite or NaN.
#[derive(Debug, Clone, Copy)]
pub struct Ball {
    mid: Dd,
    radius: f64,
}

impl Ball {
    /// From midpoint and radius >= 0.
    pub const fn new(mid: Dd, radius: f64) -> Self {
        Self { mid, radius }
    }
    /// Half-width of an interval about `value` that holds the true number; NaN or infinite if nothing is known.
    pub fn about(self, value: f64) -> f64 {
        ((self.mid - Dd::new(value)).hi.abs() + self.radius) * UP
    }
    fn made(mid: Dd, radius: f64) -> Self {
        Self { mid, radius: (radius + mid.hi.abs() * STEP + FLOOR) * UP }
    }
    fn exact(self) -> bool {
        self.radius == 0.0
    }
    /// Is it a double, known exactly?
    fn whole(self) -> bool {
        self.exact() && self.mid.lo == 0.0
    }
    /// Is its sign open?
    fn open(self) -> bool {
        !(self.mid.hi.abs() > self.radius || self.exact())
    }
}

impl Add for Ball {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        // Nothing is rounded where one of them is exactly zero.
        if self.exact() && self.mid == Dd::ZERO {
            return o;
        }
        if o.exact() && o.mid == Dd::ZERO {
            return self;
        }
        let sum = self.mid + o.mid;
        // The sum of two doubles is a double-double.
        if self.whole() && o.whole() && sum.is_finite() {
            return Self::new(sum, 0.0);
        }
        Self::made(sum, self.radius + o.radius)
    }
}
impl Sub for Ball {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}
impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self { mid: -self.mid, radius: self.radius }
    }
}
impl Mul for Ball {
    type Output = Self;
    #[expect(clippy::float_cmp, reason = "an exact 0, 1 or -1 makes an exact product")]
    fn mul(self, o: Self) -> Self {
        for (a, b) in [(self, o), (o, self)] {
            if a.whole() {
                if a.mid.hi == 0.0 && b.radius.is_finite() {
                    return Self::new(Dd::ZERO, 0.0);
                }
                if a.mid.hi.abs() == 1.0 {
                    return if a.mid.hi > 0.0 { b } else { -b };
                }
            }
        }
        let (a, b) = (self.mid.hi.abs(), o.mid.hi.abs());
        Self::made(self.mid * o.mid, (a * o.radius + b * self.radius) * UP + self.radius * o.radius)
    }
}
impl Div for Ball {
    type Output = Self;
    #[expect(clippy::float_cmp, reason = "an exact 1 or -1 makes an exact quotient")]
    fn div(self, o: Self) -> Self {
        if o.whole() && o.mid.hi.abs() == 1.0 {
            return if o.mid.hi > 0.0 { self } else { -self };
        }
        let q = self.mid / o.mid;
        let least = (o.mid.hi.abs() - o.radius) / UP;
        let radius =
            if least > 0.0 { (self.radius + q.hi.abs() * o.radius * UP) / least } else { f64::INFINITY };
        if self.exact() && self.mid == Dd::ZERO && least > 0.0 {
            return self;
        }
        Self::made(q, radius * UP)
    }
}

impl Real for Ball {
    fn datum(value: f64) -> Self {
        Self { mid: Dd::new(value), radius: value.abs() * DATUM }
    }
    const ENCLOSES: bool = true;
    fn given(index: usize, value: f64) -> Self {
        let datum = Self::datum(value);
        match SPREAD.get() {
            Some((i, radius)) if i == index => Self { mid: datum.mid, radius: (datum.radius + radius) * UP },
            _ => datum,
        }
    }
    fn constant(value: Dd) -> Self {
        // One double is exact; two are the rounding of something.
        Self { mid: value, radius: if value.lo == 0.0 { 0.0 } else { value.hi.abs() * STEP } }
    }
    fn value(self) -> Dd {
        self.mid
    }
    fn radius(self) -> f64 {
        self.radius
    }
    fn widened(self, bound: impl Fn() -> f64) -> Self {
        Self { mid: self.mid, radius: (self.radius + bound()) * UP }
    }
    fn sign(self) -> f64 {
        if self.open() {
            DOUBT.set(true);
        }
        self.mid.sign()
    }
    fn abs(self) -> Self {
        // The magnitudes of two numbers are no farther apart than the numbers: nothing is decided here.
        Self { mid: if self.mid.sign() < 0.0 { -self.mid } else { self.mid }, radius: self.radius }
    }
    fn is_nothing(self) -> bool {
        // What only may be zero is a factor like any other.
        self.exact() && self.mid == Dd::ZERO
    }
    fn is_zero(self) -> bool {
        if self.open() {
            DOUBT.set(true);
        }
        self.mid == Dd::ZERO
    }
    #[expect(clippy::float_cmp, reason = "equal bits make the same enclosure")]
    fn same(self, other: Self) -> bool {
        self.mid == other.mid && self.radius == other.radius
    }
    fn root(self) -> Self {
        if self.exact() && self.mid == Dd::ZERO {
            return self;
        }
        let mid = Real::root(self.mid);
        let radius = if self.mid.hi > self.radius {
            self.radius / mid.hi
        } else {
            // Both the midpoint and the truth lie between 0 and this.
            ((self.mid.hi.abs() + self.radius) * UP).sqrt()
        };
        Self::made(mid, radius * UP)
    }
    fn scale2(self, e: i32) -> Self {
        let factor = crate::num::dd::pow2(e);
        // Exact, unless the low part underflows.
        let floor = if self.exact() { 0.0 } else { FLOOR };
        Self { mid: self.mid.scale2(e), radius: self.radius * factor + floor }
    }
    fn below(self, o: Self) -> bool {
        let apart = (self.mid - o.mid).hi.abs();
        let infinite = self.mid.hi.is_infinite() || o.mid.hi.is_infinite();
        if !(apart > (self.radius + o.radius) * UP || infinite || self.exact() && o.exact()) {
            DOUBT.set(true);
        }
        self.mid < o.mid
    }
    fn larger(self, o: Self) -> Self {
        // Whichever it is, the larger of the truths is not below the one nor above both.
        let (large, small) = if self.mid < o.mid { (o, self) } else { (self, o) };
        let above = (small.mid - large.mid).hi * (1.0 - STEP) + small.radius;
        Self { mid: large.mid, radius: large.radius.max(above * UP) }
    }
    fn apart(self, o: Self) -> Self {
        let apart = self - o;
        // Whether it is zero is open wherever the data may round to it.
        if apart.mid.hi.abs() <= 8.0 * U * self.mid.hi.abs().max(o.mid.hi.abs()) && !apart.exact() {
            DOUBT.set(true);
            return Self::zero();
        }
        apart
    }
    fn negligible(self, _: f64) -> bool {
        // What rounding left is inside the radius already.
        false
    }
    fn side(self, o: Self) -> f64 {
        if self.below(o) {
            -1.0
        } else if o.below(self) {
            1.0
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_float::DBig;
    use proptest::prelude::*;
    use std::str::FromStr;

    fn big(x: f64) -> DBig {
        // The decimal expansion of a double is finite.
        DBig::from_str(&format!("{x:.1100e}")).unwrap().with_precision(120).value()
    }
    fn holds(ball: Ball, truth: &DBig) -> bool {
        let mid = big(ball.mid.hi) + big(ball.mid.lo);
        let off = mid - truth;
        let size = if off < DBig::ZERO { -off } else { off };
        size <= big(ball.radius)
    }

    proptest! {
        /// The result of each operation holds the exact result of any point of its operands (their ends among them).
        #[test]
        fn every_operation_holds_the_truth(
            a in -1e6f64..1e6, b in -1e6f64..1e6, ra in 0.0f64..1e-3, rb in 0.0f64..1e-3,
            low in -1e-17f64..1e-17, s in -1i32..=1, t in -1i32..=1,
        ) {
            let (mid_a, mid_b) = (Dd::sum(a, a * low), Dd::sum(b, b * low));
            let (x, y) = (Ball::new(mid_a, ra), Ball::new(mid_b, rb));
            let point = |m: Dd, r: f64, s: i32| big(m.hi) + big(m.lo) + big(r * f64::from(s));
            let (p, q) = (point(mid_a, ra, s), point(mid_b, rb, t));
            prop_assert!(holds(x + y, &(&p + &q)));
            prop_assert!(holds(x - y, &(&p - &q)));
            prop_assert!(holds(x * y, &(&p * &q)));
            prop_assume!(b.abs() > 1.0);
            prop_assert!(holds(x / y, &(&p / &q)));
            let square = point(mid_b, rb, t);
            let root = (y * y).root();
            let size = if square < DBig::ZERO { -square } else { square };
            prop_assert!(holds(root, &size));
        }
    }

    #[test]
    fn an_open_comparison_is_a_doubt() {
        let x = Ball::datum(0.1);
        assert!(!watch(|| x.sign()).1);
        assert!(watch(|| (x - Ball::datum(0.1)).sign()).1);
        assert!(watch(|| x.below(Ball::datum(0.1))).1);
        assert!(!watch(|| Ball::zero().sign()).1);
        assert!(watch(|| Ball::new(Dd::ZERO, f64::NAN).sign()).1);
    }
    #[test]
    fn a_radicand_that_may_be_negative_keeps_the_truth_inside() {
        let y = Ball::new(Dd::new(1e-20), 1e-18).root();
        assert!(y.about(0.0) >= (1.01e-18f64).sqrt() && y.about(0.0) < 1e-8);
    }
}
