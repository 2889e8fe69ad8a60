//! What the solvers need of a number, so that the same equations give values, and values with their sensitivities.
use crate::num::Dd;
use std::ops::Add;
use std::ops::Div;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// A number of the solvers: [`Dd`] alone, or [`crate::num::Jet`] with derivatives.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + std::fmt::Debug
{
    /// How many derivatives it carries.
    const SLOPES: usize;
    /// The datum of this index, with this value; its derivative is taken with respect to its own logarithm.
    fn datum(index: usize, value: f64) -> Self;
    /// A constant.
    fn constant(value: Dd) -> Self;
    /// A value with given derivatives.
    fn with_slopes(value: Dd, slope: impl Fn(usize) -> f64) -> Self;
    /// The value.
    fn value(self) -> Dd;
    /// Derivative number `i` with respect to the logarithm of datum `i`.
    fn slope(&self, i: usize) -> f64;
    /// Square root; 0 where the value is not above 0 (a radicand that rounding made negative at a turning point).
    fn root(self) -> Self;
    /// Product with 2^e.
    fn scale2(self, e: i32) -> Self;

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
    /// -1, 0 or 1.
    #[inline(always)]
    fn sign(self) -> f64 {
        self.value().sign()
    }
    /// Is the value exactly zero?
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.value() == Dd::ZERO
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
    /// The same, or exactly zero where it is nothing beside `scale`, the sum of the magnitudes of the terms that made it:
    /// what then is left is the rounding of double-doubles. Its derivatives stay.
    #[inline(always)]
    fn cleared(self, scale: f64) -> Self {
        if self.value().hi.abs() <= crate::num::NOISE * scale {
            Self::with_slopes(Dd::ZERO, |i| self.slope(i))
        } else {
            self
        }
    }
    /// Sum of two terms, [`Real::cleared`].
    #[inline(always)]
    fn balance(self, other: Self) -> Self {
        (self + other).cleared(self.f64().abs() + other.f64().abs())
    }
    /// Square.
    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }
    /// `sum |d y / d ln x_i| / |y|`: 0 if no datum moves it, infinite for a zero that some datum moves.
    fn cond(&self) -> f64 {
        let mut sum = 0.0;
        for i in 0..Self::SLOPES {
            sum += self.slope(i).abs();
        }
        if sum == 0.0 { 0.0 } else { sum / self.value().hi.abs() }
    }
}

impl Real for Dd {
    const SLOPES: usize = 0;
    #[inline(always)]
    fn datum(_: usize, value: f64) -> Self {
        Dd::new(value)
    }
    #[inline(always)]
    fn constant(value: Dd) -> Self {
        value
    }
    #[inline(always)]
    fn with_slopes(value: Dd, _: impl Fn(usize) -> f64) -> Self {
        value
    }
    #[inline(always)]
    fn value(self) -> Dd {
        self
    }
    #[inline(always)]
    fn slope(&self, _: usize) -> f64 {
        0.0
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
}
