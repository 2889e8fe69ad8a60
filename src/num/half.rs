//! Angles by sine and cosine of their halves: differences of cosines become products, and an angle that is a hair from 0
//! or from 180 degrees keeps its digits.
use crate::num::{Real, trig};

/// Sine and cosine of half an angle.
#[derive(Debug, Clone, Copy)]
pub struct Half<T> {
    /// Sine of the half.
    pub sine: T,
    /// Cosine of the half.
    pub cosine: T,
}

impl<T: Real> Half<T> {
    /// Half of an angle in degrees.
    pub fn of_degrees(angle: T) -> Self {
        let (sine, cosine) = trig::sin_cos_of_degrees(angle.scale2(-1));
        Self { sine, cosine }
    }
    /// Half of an angle in radians, of a few turns at most.
    pub fn of_radians(angle: T) -> Self {
        let (sine, cosine) = trig::turn(angle.scale2(-1));
        Self { sine, cosine }
    }
    /// Half of the direction of a point, from 0 degrees along (0, 1), positive toward (1, 0); the point must not be (0, 0).
    pub fn of_point(across: T, along: T) -> Self {
        let far = (across.square() + along.square()).root();
        // The larger of the two halves first: it does not cancel.
        let larger = ((far + along.abs()) / far).scale2(-1).root();
        let smaller = (across / (far * larger)).scale2(-1);
        if along.sign() < 0.0 {
            let sense = if across.sign() < 0.0 { -1.0 } else { 1.0 };
            Self { sine: larger.signed(sense), cosine: smaller.signed(sense) }
        } else {
            Self { sine: smaller, cosine: larger }
        }
    }
    /// Half of the sum of two angles.
    pub fn plus(self, o: Self) -> Self {
        Self {
            sine: (self.sine * o.cosine).balance(self.cosine * o.sine),
            cosine: (self.cosine * o.cosine).balance(-(self.sine * o.sine)),
        }
    }
    /// Half of the difference of two angles.
    pub fn minus(self, o: Self) -> Self {
        self.plus(Self { sine: -o.sine, ..o })
    }
    /// The same angle less half a turn.
    pub fn less_half_turn(self) -> Self {
        Self { sine: -self.cosine, cosine: self.sine }
    }
    /// Sine of the whole angle.
    pub fn full_sine(self) -> T {
        (self.sine * self.cosine).scale2(1)
    }
    /// Cosine of the whole angle.
    pub fn full_cosine(self) -> T {
        self.cosine.square().balance(-self.sine.square())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Dd;

    #[test]
    fn points_and_degrees_give_the_same_halves() {
        for degrees in [-170.0, -90.0, -1.0, 1e-200, 0.0, 30.0, 90.0, 135.0, 179.999_999, 180.0] {
            let half = Half::of_degrees(Dd::new(degrees));
            let (s, c) = trig::sin_cos_degrees(degrees);
            let back = Half::of_point(s, c);
            assert!(
                (half.sine - back.sine).hi.abs() <= 1e-30 * half.sine.hi.abs(),
                "{degrees}: {half:?} {back:?}"
            );
            assert!(
                (half.cosine - back.cosine).hi.abs() <= 1e-30 * half.cosine.hi.abs(),
                "{degrees}: {half:?} {back:?}"
            );
        }
    }
    #[test]
    fn sums_and_differences() {
        let of = |x: f64| Half::of_degrees(Dd::new(x));
        let close = |a: Half<Dd>, b: Half<Dd>| {
            (a.sine - b.sine).hi.abs() < 1e-30 && (a.cosine - b.cosine).hi.abs() < 1e-30
        };
        assert!(close(of(17.0).plus(of(40.0)), of(57.0)));
        assert!(close(of(17.0).minus(of(40.0)), of(-23.0)));
        assert!(close(of(17.0).less_half_turn(), of(-163.0)));
        assert_eq!(of(40.0).plus(of(-40.0)).sine, Dd::ZERO);
    }
}
