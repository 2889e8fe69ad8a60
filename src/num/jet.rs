//! A number with its first and second derivative by one variable, so that what is differentiated is never written down twice.
use crate::num::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its first and second derivative.
#[derive(Debug, Clone, Copy)]
pub struct Jet<T> {
    /// The value.
    pub value: T,
    /// Its first derivative.
    pub first: T,
    /// Its second derivative.
    pub second: T,
}

impl<T: Real> Jet<T> {
    /// What does not depend on the variable.
    pub fn fixed(value: T) -> Self {
        Self { value, first: T::zero(), second: T::zero() }
    }
}

/// A number that is followed over a variable: with its derivatives by it, or its value alone.
pub trait Followed<T: Real>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A value with its first and second derivative, which are worked out only where they are kept.
    fn with(value: T, derivatives: impl FnOnce() -> [T; 2]) -> Self;
    /// What does not depend on the variable.
    fn still(value: T) -> Self {
        Self::with(value, || [T::zero(); 2])
    }
    /// The value.
    fn here(self) -> T;
    /// First and second derivative; 0 where they are not kept.
    fn derivatives(self) -> [T; 2];
    /// Product with a number that does not depend on the variable.
    fn by(self, factor: T) -> Self;
    /// Square root; its derivatives are not finite where the value is 0.
    fn square_root(self) -> Self;
}

impl<T: Real> Followed<T> for Jet<T> {
    fn with(value: T, derivatives: impl FnOnce() -> [T; 2]) -> Self {
        let [first, second] = derivatives();
        Self { value, first, second }
    }
    fn here(self) -> T {
        self.value
    }
    fn derivatives(self) -> [T; 2] {
        [self.first, self.second]
    }
    fn by(self, factor: T) -> Self {
        Self { value: self.value * factor, first: self.first * factor, second: self.second * factor }
    }
    fn square_root(self) -> Self {
        let value = self.value.root();
        let first = self.first.scale2(-1) / value;
        Self { value, first, second: (self.second.scale2(-1) - first.square()) / value }
    }
}

impl<T: Real> Followed<T> for T {
    fn with(value: T, _: impl FnOnce() -> [T; 2]) -> Self {
        value
    }
    fn here(self) -> T {
        self
    }
    fn derivatives(self) -> [T; 2] {
        [T::zero(); 2]
    }
    fn by(self, factor: T) -> Self {
        self * factor
    }
    fn square_root(self) -> Self {
        self.root()
    }
}

impl<T: Real> Add for Jet<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, first: self.first + o.first, second: self.second + o.second }
    }
}
impl<T: Real> Sub for Jet<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + (-o)
    }
}
impl<T: Real> Neg for Jet<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, first: -self.first, second: -self.second }
    }
}
impl<T: Real> Mul for Jet<T> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            first: self.first * o.value + self.value * o.first,
            second: self.second * o.value + (self.first * o.first).scale2(1) + self.value * o.second,
        }
    }
}
impl<T: Real> Div for Jet<T> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        let first = (self.first - value * o.first) / o.value;
        let second = (self.second - (first * o.first).scale2(1) - value * o.second) / o.value;
        Self { value, first, second }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against differences of `sqrt(1 + x^2) / (2 - x) - 3 x` at x = 0.3.
    #[test]
    fn derivatives_are_limits_of_differences() {
        let f = |x: Jet<f64>| (Jet::fixed(1.0) + x * x).square_root() / (Jet::fixed(2.0) - x) - x.by(3.0);
        let at = |x: f64| f(Jet { value: x, first: 1.0, second: 0.0 });
        let (x, h) = (0.3, 1e-4);
        let (before, here, after) = (at(x - h).value, at(x), at(x + h).value);
        assert!((here.first - (after - before) / (2.0 * h)).abs() < 1e-7);
        assert!((here.second - (after - 2.0 * here.value + before) / (h * h)).abs() < 1e-6);
    }
}
