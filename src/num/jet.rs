//! A double-double with its first derivatives: forward differentiation gives the condition number of every answer.
use crate::num::Dd;
use crate::num::Real;
use std::ops::Add;
use std::ops::Div;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// A value and its derivatives with respect to the logarithms of `N` data. The derivatives are doubles: a condition
/// number needs few digits.
#[derive(Debug, Clone, Copy)]
pub struct Jet<const N: usize> {
    v: Dd,
    d: [f64; N],
}

impl<const N: usize> Jet<N> {
    #[inline(always)]
    fn map(self, v: Dd, factor: f64) -> Self {
        let mut d = self.d;
        for x in &mut d {
            *x *= factor;
        }
        Self { v, d }
    }
    #[inline(always)]
    fn zip(self, o: Self, v: Dd, f: f64, g: f64) -> Self {
        let mut d = self.d;
        for (x, y) in d.iter_mut().zip(&o.d) {
            *x = *x * f + *y * g;
        }
        Self { v, d }
    }
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        let mut d = self.d;
        for (x, y) in d.iter_mut().zip(&o.d) {
            *x += *y;
        }
        Self { v: self.v + o.v, d }
    }
}
impl<const N: usize> Sub for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        let mut d = self.d;
        for (x, y) in d.iter_mut().zip(&o.d) {
            *x -= *y;
        }
        Self { v: self.v - o.v, d }
    }
}
impl<const N: usize> Neg for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(-self.v, -1.0)
    }
}
impl<const N: usize> Mul for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        self.zip(o, self.v * o.v, o.v.hi, self.v.hi)
    }
}
impl<const N: usize> Div for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        let q = self.v / o.v;
        let r = 1.0 / o.v.hi;
        self.zip(o, q, r, -q.hi * r)
    }
}

impl<const N: usize> Real for Jet<N> {
    const SLOPES: usize = N;
    #[inline(always)]
    fn datum(index: usize, value: f64) -> Self {
        let mut d = [0.0; N];
        if let Some(x) = d.get_mut(index) {
            *x = value;
        }
        Self { v: Dd::new(value), d }
    }
    #[inline(always)]
    fn constant(value: Dd) -> Self {
        Self { v: value, d: [0.0; N] }
    }
    #[inline(always)]
    fn with_slopes(value: Dd, slope: impl Fn(usize) -> f64) -> Self {
        Self { v: value, d: std::array::from_fn(slope) }
    }
    #[inline(always)]
    fn value(self) -> Dd {
        self.v
    }
    #[inline(always)]
    fn slope(&self, i: usize) -> f64 {
        self.d[i]
    }
    #[inline(always)]
    fn root(self) -> Self {
        let v = Real::root(self.v);
        if v.hi > 0.0 || v.hi.is_nan() { self.map(v, 0.5 / v.hi) } else { Self::zero() }
    }
    #[inline(always)]
    fn scale2(self, e: i32) -> Self {
        let f = crate::num::dd::pow2(e);
        self.map(self.v.scale2(e), f)
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, clippy::neg_cmp_op_on_partial_ord, reason = "exact bits are what is tested")]
mod tests {
    use super::*;

    #[test]
    fn logarithmic_derivatives_of_a_power_law() {
        // y = sqrt(a b / c): each datum enters with exponent 1/2.
        let (a, b, c) = (Jet::<3>::datum(0, 3.0), Jet::<3>::datum(1, 7.0), Jet::<3>::datum(2, 0.2));
        let y = (a * b / c).root();
        assert!((y.cond() - 1.5).abs() < 1e-14, "{}", y.cond());
    }
    #[test]
    fn a_difference_of_neighbours_is_ill_conditioned() {
        let y = Jet::<2>::datum(0, 1.0) - Jet::<2>::datum(1, 1.0 - 1e-10);
        assert!((y.cond() * 1e-10 / 2.0 - 1.0).abs() < 1e-5);
        let zero = Jet::<2>::datum(0, 1.0) - Jet::<2>::datum(1, 1.0);
        assert_eq!(zero.cond(), f64::INFINITY);
        assert_eq!(Jet::<2>::zero().cond(), 0.0);
    }
}
