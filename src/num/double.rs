//! Doubles as numbers of the solvers: the cheapest rung, good to a few units in the last place where nothing cancels.
use crate::num::dd::pow2;
use crate::num::{Dd, Real};

impl Real for f64 {
    // A few units in the last place: what rounding of doubles leaves of a difference of equals.
    const NOISE: f64 = 4.0 * f64::EPSILON;
    const SETTLED: f64 = 4.0 * f64::EPSILON;
    #[inline(always)]
    fn datum(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn constant(value: Dd) -> Self {
        value.hi
    }
    #[inline(always)]
    fn value(self) -> Dd {
        Dd::new(self)
    }
    #[inline(always)]
    fn sign(self) -> f64 {
        if self > 0.0 {
            1.0
        } else if self < 0.0 {
            -1.0
        } else {
            0.0
        }
    }
    #[inline(always)]
    fn root(self) -> Self {
        // NaN is no radicand by rounding: it must not come out as a zero.
        if self > 0.0 || self.is_nan() { self.sqrt() } else { 0.0 }
    }
    #[inline(always)]
    fn scale2(self, e: i32) -> Self {
        self * pow2(e)
    }
    #[inline(always)]
    fn below(self, other: Self) -> bool {
        self < other
    }
}
