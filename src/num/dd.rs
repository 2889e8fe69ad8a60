//! Double-double numbers: an unevaluated sum of two doubles, about 32 digits.
//!
//! A difference of nearly equal terms (pull against weight, `x0^2 - x^2`, a release near equilibrium) loses half of the
//! digits of a double-double and still rounds to the right double. No fused multiply-add: the same bits everywhere.
//! Source: Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18 (1971) 224-242;
//! Joldes, Muller, Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, ACM
//! TOMS 44 (2017) 15res, algorithms 6 (sum, relative error < 3 * 2^-106), 11 (product, 5 * 2^-106), 17 (quotient).
use std::cell::Cell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Magnitudes from here to [`MOST`] keep both their parts, and so do their products with a few numbers near 1.
const LEAST: f64 = pow2(-900);
const MOST: f64 = pow2(960);

thread_local! {
    static LEFT: Cell<bool> = const { Cell::new(false) };
}

/// Runs a computation and says whether a product, a quotient or a root in it left the range of double-doubles.
pub fn watch<R>(run: impl FnOnce() -> R) -> (R, bool) {
    LEFT.set(false);
    let result = run();
    (result, LEFT.get())
}

/// Runs a computation that stays right where small numbers vanish: what leaves the range within it does not count.
pub fn unwatched<R>(run: impl FnOnce() -> R) -> R {
    let before = LEFT.get();
    let result = run();
    LEFT.set(before);
    result
}

/// Notes if a result made of two numbers left the range; what is made with 0, as many are, or without end is exactly so.
#[inline(always)]
fn keep(result: f64, a: f64, b: f64) {
    if !(LEAST..=MOST).contains(&result.abs()) && a != 0.0 && b != 0.0 {
        leave(a, b);
    }
}

#[cold]
#[inline(never)]
fn leave(a: f64, b: f64) {
    if a.is_finite() && b.is_finite() {
        LEFT.set(true);
    }
}

/// `hi + lo` with `hi` the double nearest to the sum.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dd {
    /// The nearest double.
    pub hi: f64,
    /// What is left.
    pub lo: f64,
}

#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

#[inline(always)]
fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Dd {
    /// Zero.
    pub const ZERO: Dd = Dd { hi: 0.0, lo: 0.0 };
    /// One.
    pub const ONE: Dd = Dd { hi: 1.0, lo: 0.0 };
    /// Pi to 107 bits.
    pub const PI: Dd = Dd { hi: std::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };

    /// An exact double.
    #[inline(always)]
    pub const fn new(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
    /// The exact sum of two doubles.
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }
    /// The exact product of two doubles (barring overflow, and underflow of the small part).
    #[inline(always)]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_prod(a, b);
        Self { hi, lo }
    }
    /// Square root; 0 for a negative argument by rounding is the caller's business: NaN below 0.
    #[inline]
    pub fn sqrt(self) -> Self {
        // A relative comparison with zero would be wrong here: exactly zero is the only special case.
        if self.hi == 0.0 {
            return Self::ZERO;
        }
        keep(self.hi, self.hi, 1.0);
        let s = self.hi.sqrt();
        if !s.is_finite() {
            return Self::new(s);
        }
        let (p, e) = two_prod(s, s);
        let r = ((self.hi - p) - e + self.lo) / (2.0 * s);
        let (hi, lo) = quick_two_sum(s, r);
        Self { hi, lo }
    }
    /// Exact product with 2^e, for |e| <= 1000.
    #[inline]
    pub fn scale2(self, e: i32) -> Self {
        let f = pow2(e);
        let scaled = Self { hi: self.hi * f, lo: self.lo * f };
        keep(scaled.hi, self.hi, f);
        scaled
    }
    /// Is it finite?
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }
}

/// 2^e as a double, for -1022 <= e <= 1023.
#[inline]
pub const fn pow2(e: i32) -> f64 {
    let biased = if e < -1022 {
        1
    } else if e > 1023 {
        2046
    } else {
        (1023 + e).unsigned_abs()
    };
    f64::from_bits((biased as u64) << 52)
}

/// `x 2^e` for any e, exact where the result is a normal number.
pub fn ldexp(mut x: f64, mut e: i32) -> f64 {
    while e != 0 && x != 0.0 && x.is_finite() {
        let part = e.clamp(-1000, 1000);
        x *= pow2(part);
        e -= part;
    }
    x
}

/// Exponent of a finite nonzero double: `2^e <= |x| < 2^(e+1)`; 0 for zero, subnormal counts as -1023.
#[inline]
pub fn exponent(x: f64) -> i32 {
    if x == 0.0 {
        return 0;
    }
    i32::try_from((x.to_bits() >> 52) & 0x7ff).map_or(0, |b| b - 1023)
}

impl Add for Dd {
    type Output = Dd;
    #[inline(always)]
    fn add(self, o: Dd) -> Dd {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Dd { hi, lo }
    }
}
impl Sub for Dd {
    type Output = Dd;
    #[inline(always)]
    fn sub(self, o: Dd) -> Dd {
        self + (-o)
    }
}
impl Neg for Dd {
    type Output = Dd;
    #[inline(always)]
    fn neg(self) -> Dd {
        Dd { hi: -self.hi, lo: -self.lo }
    }
}
impl Mul for Dd {
    type Output = Dd;
    #[inline(always)]
    fn mul(self, o: Dd) -> Dd {
        let (p, e) = two_prod(self.hi, o.hi);
        keep(p, self.hi, o.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * o.lo + self.lo * o.hi));
        Dd { hi, lo }
    }
}
impl Div for Dd {
    type Output = Dd;
    #[inline]
    fn div(self, o: Dd) -> Dd {
        let q1 = self.hi / o.hi;
        keep(q1, self.hi, o.hi);
        if !q1.is_finite() || q1 == 0.0 {
            return Dd::new(q1);
        }
        let (p, e) = two_prod(q1, o.hi);
        let rest = (self.hi - p) - e + (self.lo - q1 * o.lo);
        let (hi, lo) = quick_two_sum(q1, rest / o.hi);
        Dd { hi, lo }
    }
}
impl PartialOrd for Dd {
    /// NaN compares with nothing.
    #[inline(always)]
    fn partial_cmp(&self, o: &Dd) -> Option<Ordering> {
        match self.hi.partial_cmp(&o.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&o.lo),
            other => other,
        }
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, clippy::neg_cmp_op_on_partial_ord, reason = "exact bits are what is tested")]
mod tests {
    use super::*;
    use crate::num::Real;

    #[test]
    fn a_third_times_three_is_one_to_32_digits() {
        let third = Dd::ONE / Dd::new(3.0);
        let back = third * Dd::new(3.0) - Dd::ONE;
        assert!(back.hi.abs() < 1e-31, "{back:?}");
    }
    #[test]
    fn square_root_of_two_squared() {
        let r = Dd::new(2.0).sqrt();
        let back = r * r - Dd::new(2.0);
        assert!(back.hi.abs() < 1e-31, "{back:?}");
    }
    #[test]
    fn cancellation_keeps_the_small_part() {
        let x = Dd::sum(1.0, 1e-20);
        assert_eq!((x - Dd::ONE).hi, 1e-20);
    }
    #[test]
    fn nan_compares_with_nothing() {
        let n = Dd::new(f64::NAN);
        assert!(!(n <= Dd::ZERO) && !(n > Dd::ZERO));
        assert_eq!(n.sign(), 0.0);
    }
    #[test]
    fn powers_of_two() {
        assert_eq!(pow2(10), 1024.0);
        assert_eq!(pow2(-1), 0.5);
        assert_eq!(exponent(1024.0), 10);
        assert_eq!(exponent(0.75), -1);
    }
}
