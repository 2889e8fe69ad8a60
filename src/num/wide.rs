//! Double-double numbers with an exponent of their own, for data so large or small that their products leave the doubles.
use crate::num::Dd;
use crate::num::Real;
use crate::num::dd::exponent;
use crate::num::dd::pow2;
use crate::num::rough::WideRough;
use crate::num::rough::scaled;
use std::ops::Add;
use std::ops::Div;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// `m 2^e` with `1 <= |m| < 2`; `m` is 0, infinite or NaN with `e` = 0.
#[derive(Debug, Clone, Copy)]
pub struct Wide {
    m: Dd,
    e: i32,
}

/// Beyond this distance of exponents the smaller term of a sum is nothing.
const FAR: i32 = 240;

impl Wide {
    fn new(m: Dd, e: i32) -> Self {
        if m.hi == 0.0 || !m.hi.is_finite() {
            return Self { m: Dd::new(m.hi), e: 0 };
        }
        let (m, e) = if m.hi.abs() < 1e-200 { (m.scale2(500), e - 500) } else { (m, e) };
        let own = exponent(m.hi);
        Self { m: m.scale2(-own / 2).scale2(-(own - own / 2)), e: e + own }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        let (large, small) =
            if self.m.hi == 0.0 || (self.e < o.e && o.m.hi != 0.0) { (o, self) } else { (self, o) };
        if !self.m.hi.is_finite() || !o.m.hi.is_finite() {
            return Self::new(Dd::new(self.m.hi + o.m.hi), 0);
        }
        let apart = large.e - small.e;
        if small.m.hi == 0.0 || apart > FAR {
            return large;
        }
        Self::new(large.m + small.m.scale2(-apart), large.e)
    }
}
impl Sub for Wide {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}
impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { m: -self.m, e: self.e }
    }
}
impl Mul for Wide {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        if self.m.hi.is_finite() && o.m.hi.is_finite() {
            Self::new(self.m * o.m, self.e + o.e)
        } else {
            Self::new(Dd::new(self.m.hi * o.m.hi), 0)
        }
    }
}
impl Div for Wide {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        Self::new(self.m / o.m, self.e - o.e)
    }
}

impl Real for Wide {
    type Plain = Self;
    type Rough = WideRough;
    const SLOPES: usize = 0;
    fn datum(_: usize, value: f64) -> Self {
        Self::new(Dd::new(value), 0)
    }
    fn constant(value: Dd) -> Self {
        Self::new(value, 0)
    }
    fn with_slopes(value: Self, _: impl Fn(usize) -> WideRough) -> Self {
        value
    }
    fn with_rough(value: WideRough) -> Self {
        let (m, e) = value.parts();
        Self { m: Dd::new(m), e }
    }
    fn plain(self) -> Self {
        self
    }
    fn value(self) -> Dd {
        Dd { hi: scaled(self.m.hi, self.e), lo: scaled(self.m.lo, self.e) }
    }
    fn rough(self) -> WideRough {
        WideRough::new(self.m.hi, self.e)
    }
    fn slope(&self, _: usize) -> WideRough {
        WideRough::new(0.0, 0)
    }
    fn sign(self) -> f64 {
        self.m.sign()
    }
    fn root(self) -> Self {
        if self.m.hi.is_nan() || self.m.hi == f64::INFINITY {
            return self;
        }
        if self.m.hi <= 0.0 {
            return Self::zero();
        }
        let odd = self.e & 1;
        Self::new(self.m.scale2(odd).sqrt(), (self.e - odd) / 2)
    }
    fn scale2(self, e: i32) -> Self {
        if self.m.hi == 0.0 || !self.m.hi.is_finite() { self } else { Self { m: self.m, e: self.e + e } }
    }
    fn below(self, o: Self) -> bool {
        // A difference of infinities has no sign.
        if self.m.hi.is_infinite() || o.m.hi.is_infinite() {
            self.f64() < o.f64()
        } else {
            (self - o).m.hi < 0.0
        }
    }
}

/// Does a number fit among the plain double-doubles with room for products of several? Zero does.
pub fn ordinary(x: f64) -> bool {
    x == 0.0 || (x.abs() < pow2(ROOM) && x.abs() > pow2(-ROOM))
}

/// Products of ten such numbers stay far from the ends of the doubles.
const ROOM: i32 = 80;

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "exact bits are what is tested")]
mod tests {
    use super::*;

    #[test]
    fn products_and_roots_beyond_the_doubles() {
        let w = |x| Wide::datum(0, x);
        let k = w(1e160);
        assert_eq!(((k * k + w(1.0)).root() / k).f64(), 1.0);
        let t = w(1e-300);
        assert_eq!((t * t / t).f64(), 1e-300);
        assert_eq!((t * t * t).root().root().root().scale2(0).sign(), 1.0);
        assert!((t * t).below(t) && !t.below(t * t) && t.at_most(t));
        assert_eq!((w(3.0) - w(3.0)).sign(), 0.0);
        assert!((w(1.0) / w(3.0) * w(3.0) - w(1.0)).negligible(WideRough::new(1.0, 0)));
        assert_eq!(w(f64::INFINITY).f64(), f64::INFINITY);
        assert!(w(1e300).below(w(f64::INFINITY)) && !w(f64::NAN).below(w(1.0)));
    }
}
