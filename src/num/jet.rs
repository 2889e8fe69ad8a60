//! A double-double with its first derivatives: forward differentiation gives the condition number of every answer.
use crate::num::Dd;
use crate::num::Real;
use crate::num::rough::Rough;
use std::ops::Add;
use std::ops::Div;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// A value and its derivatives with respect to the logarithms of `N` data. The derivatives are rough: a condition
/// number needs few digits.
#[derive(Debug, Clone, Copy)]
pub struct JetOf<P: Real, const N: usize> {
    v: P,
    d: [P::Rough; N],
}

/// A double-double with its derivatives.
pub type Jet<const N: usize> = JetOf<Dd, N>;

impl<P: Real<Plain = P>, const N: usize> JetOf<P, N> {
    #[inline(always)]
    fn map(self, v: P, factor: P::Rough) -> Self {
        let mut d = self.d;
        for x in &mut d {
            *x = *x * factor;
        }
        Self { v, d }
    }
    #[inline(always)]
    fn zip(self, o: Self, v: P, f: P::Rough, g: P::Rough) -> Self {
        let mut d = self.d;
        for (x, y) in d.iter_mut().zip(&o.d) {
            *x = *x * f + *y * g;
        }
        Self { v, d }
    }
}

impl<P: Real<Plain = P>, const N: usize> Add for JetOf<P, N> {
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
impl<P: Real<Plain = P>, const N: usize> Sub for JetOf<P, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        let mut d = self.d;
        for (x, y) in d.iter_mut().zip(&o.d) {
            *x = *x - *y;
        }
        Self { v: self.v - o.v, d }
    }
}
impl<P: Real<Plain = P>, const N: usize> Neg for JetOf<P, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(-self.v, P::Rough::of(-1.0))
    }
}
impl<P: Real<Plain = P>, const N: usize> Mul for JetOf<P, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        self.zip(o, self.v * o.v, o.v.rough(), self.v.rough())
    }
}
impl<P: Real<Plain = P>, const N: usize> Div for JetOf<P, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        let q = self.v / o.v;
        let r = P::Rough::of(1.0) / o.v.rough();
        self.zip(o, q, r, -q.rough() * r)
    }
}

impl<P: Real<Plain = P>, const N: usize> Real for JetOf<P, N> {
    type Plain = P;
    type Rough = P::Rough;
    const SLOPES: usize = N;
    const NOISE: f64 = P::NOISE;
    const SETTLED: f64 = P::SETTLED;
    #[inline(always)]
    fn datum(index: usize, value: f64) -> Self {
        let mut d = [P::Rough::zero(); N];
        if let Some(x) = d.get_mut(index) {
            *x = P::Rough::of(value);
        }
        Self { v: P::datum(index, value), d }
    }
    #[inline(always)]
    fn constant(value: Dd) -> Self {
        Self { v: P::constant(value), d: [P::Rough::zero(); N] }
    }
    #[inline(always)]
    fn with_slopes(value: P, slope: impl Fn(usize) -> P::Rough) -> Self {
        Self { v: value, d: std::array::from_fn(slope) }
    }
    #[inline(always)]
    fn with_rough(value: P::Rough) -> Self {
        Self { v: P::with_rough(value), d: [P::Rough::zero(); N] }
    }
    #[inline(always)]
    fn plain(self) -> P {
        self.v
    }
    #[inline(always)]
    fn value(self) -> Dd {
        self.v.value()
    }
    #[inline(always)]
    fn f64(self) -> f64 {
        self.v.f64()
    }
    #[inline(always)]
    fn rough(self) -> P::Rough {
        self.v.rough()
    }
    #[inline(always)]
    fn slope(&self, i: usize) -> P::Rough {
        self.d[i]
    }
    #[inline(always)]
    fn sign(self) -> f64 {
        self.v.sign()
    }
    #[inline(always)]
    fn root(self) -> Self {
        let v = self.v.root();
        if v.sign() == 0.0 && !v.rough().is_zero() {
            return Self { v, d: self.d };
        }
        if v.is_zero() { Self::zero() } else { self.map(v, P::Rough::of(0.5) / v.rough()) }
    }
    #[inline(always)]
    fn scale2(self, e: i32) -> Self {
        self.map(self.v.scale2(e), P::Rough::pow2(e))
    }
    #[inline(always)]
    fn below(self, o: Self) -> bool {
        self.v.below(o.v)
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
