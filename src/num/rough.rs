//! Rough numbers of the solvers, for sizes and derivatives, which need few digits: a double, or one with a wide exponent.
use crate::num::dd::exponent;
use crate::num::dd::pow2;
use std::cmp::Ordering;
use std::ops::Add;
use std::ops::AddAssign;
use std::ops::Div;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// What the solvers need of a rough number.
pub trait Rough:
    Copy
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + PartialOrd
    + std::fmt::Debug
{
    /// A double.
    fn of(value: f64) -> Self;
    /// The nearest double; infinite or 0 where no double is so large or small.
    fn f64(self) -> f64;
    /// 2^e.
    fn pow2(e: i32) -> Self;
    /// `2^e <= |x| < 2^(e+1)`; 0 for 0.
    fn exponent(self) -> i32;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Is it neither infinite nor NaN?
    fn is_finite(self) -> bool;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::of(0.0)
    }
    /// Is it 0?
    #[inline(always)]
    fn is_zero(self) -> bool {
        self == Self::zero()
    }
    /// The larger; NaN is not larger.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

impl Rough for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn pow2(e: i32) -> Self {
        pow2(e)
    }
    #[inline(always)]
    fn exponent(self) -> i32 {
        exponent(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}

/// A double times a power of two of its own, `m 2^e` with `1 <= |m| < 2`; `m` is 0, infinite or NaN with `e` = 0.
#[derive(Debug, Clone, Copy)]
pub struct WideRough {
    m: f64,
    e: i32,
}

/// Beyond this distance of exponents the smaller term of a sum is nothing.
const FAR: i32 = 120;

impl WideRough {
    /// Mantissa and exponent.
    pub(crate) const fn parts(self) -> (f64, i32) {
        (self.m, self.e)
    }
    /// `m 2^e` for any double `m`.
    pub(crate) fn new(m: f64, e: i32) -> Self {
        if m == 0.0 || !m.is_finite() {
            return Self { m, e: 0 };
        }
        // A subnormal has no exponent of its own.
        let (m, e) = if m.abs() < f64::MIN_POSITIVE { (m * pow2(200), e - 200) } else { (m, e) };
        let own = exponent(m);
        // In two steps: 2^-own of a number near the largest would be subnormal.
        Self { m: m * pow2(-own / 2) * pow2(-(own - own / 2)), e: e + own }
    }
}

impl Add for WideRough {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        if self.m == 0.0 || !o.m.is_finite() {
            return if self.m.is_finite() { o } else { Self::new(self.m + o.m, 0) };
        }
        if o.m == 0.0 || !self.m.is_finite() {
            return self;
        }
        let (large, small) = if self.e >= o.e { (self, o) } else { (o, self) };
        let apart = large.e - small.e;
        if apart > FAR { large } else { Self::new(large.m + small.m * pow2(-apart), large.e) }
    }
}
impl AddAssign for WideRough {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl Sub for WideRough {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}
impl Neg for WideRough {
    type Output = Self;
    fn neg(self) -> Self {
        Self { m: -self.m, e: self.e }
    }
}
impl Mul for WideRough {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.m * o.m, self.e + o.e)
    }
}
impl Div for WideRough {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        Self::new(self.m / o.m, self.e - o.e)
    }
}
impl PartialEq for WideRough {
    fn eq(&self, o: &Self) -> bool {
        self.partial_cmp(o) == Some(Ordering::Equal)
    }
}
impl PartialOrd for WideRough {
    fn partial_cmp(&self, o: &Self) -> Option<Ordering> {
        let plain = self.e == o.e || self.m == 0.0 || o.m == 0.0 || !self.m.is_finite() || !o.m.is_finite();
        // Signs decide before exponents do.
        if plain || (self.m > 0.0) != (o.m > 0.0) {
            self.m.partial_cmp(&o.m)
        } else if self.m > 0.0 {
            Some(self.e.cmp(&o.e))
        } else {
            Some(o.e.cmp(&self.e))
        }
    }
}
impl Rough for WideRough {
    fn of(value: f64) -> Self {
        Self::new(value, 0)
    }
    fn f64(self) -> f64 {
        scaled(self.m, self.e)
    }
    fn pow2(e: i32) -> Self {
        Self { m: 1.0, e }
    }
    fn exponent(self) -> i32 {
        self.e
    }
    fn abs(self) -> Self {
        Self { m: self.m.abs(), e: self.e }
    }
    fn is_finite(self) -> bool {
        self.m.is_finite()
    }
}

/// `m 2^e` rounded once: infinite, 0 or subnormal where the double ends.
pub(crate) fn scaled(m: f64, e: i32) -> f64 {
    if (-1000..=1000).contains(&e) {
        m * pow2(e)
    } else if e > 0 {
        m * pow2(1000) * pow2((e - 1000).min(1000))
    } else {
        // The last step alone may round.
        let rest = (e + 1000).max(-1022);
        let large = m * pow2(rest / 2);
        large * pow2(rest - rest / 2) * pow2(-1000)
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "exact bits are what is tested")]
mod tests {
    use super::*;

    #[test]
    fn wide_numbers_do_what_doubles_do_and_go_on() {
        let w = WideRough::of;
        assert_eq!((w(3.0) * w(-0.125) + w(1.0)).f64(), 0.625);
        assert_eq!((w(1e200) * w(1e200) / w(1e300)).f64(), 1e200 * (1e200 / 1e300));
        assert!(w(1e-200) * w(1e-200) > WideRough::zero());
        assert!(w(-1e200) * w(1e200) < w(-1.0) && w(-1e-300) > w(-1e-299));
        assert_eq!(w(5e-324).f64(), 5e-324);
        assert_eq!((w(5e-324) * w(0.5) * w(4.0)).f64(), 1e-323);
        assert_eq!(w(f64::MAX).f64(), f64::MAX);
        assert_eq!((w(f64::MAX) * w(2.0)).f64(), f64::INFINITY);
        assert!((w(f64::NAN) + w(1.0)).f64().is_nan());
        assert_eq!((w(f64::INFINITY) + w(1.0)).f64(), f64::INFINITY);
        assert!((w(f64::INFINITY) - w(f64::INFINITY)).f64().is_nan());
    }
}
