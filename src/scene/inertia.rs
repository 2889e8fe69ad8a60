//! Moments of inertia of uniform shapes about the axis through the mass centre, `I = beta m R^2`, one entry a shape.
use crate::num::{Dd, Real};
use crate::scene::Shape;

/// beta of a shape, over and under. Source: Meriam & Kraige, *Engineering Mechanics: Dynamics*, table D/4.
pub const fn fraction(shape: Shape) -> [u8; 2] {
    match shape {
        Shape::Hoop => [1, 1],
        Shape::Disc => [1, 2],
        Shape::Sphere => [2, 5],
        Shape::Shell => [2, 3],
        Shape::Rod => [1, 12],
    }
}

/// beta of a shape.
pub fn beta<T: Real>(shape: Shape) -> T {
    let [over, under] = fraction(shape).map(|n| Dd::new(n.into()));
    T::constant(over / under)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Third witness: the integral of s^2 dm over the mass, by the midpoint rule, for each shape.
    #[test]
    fn beta_is_the_second_moment_of_the_shape() {
        let n = 20_000;
        let mid = |i: i32| (f64::from(i) + 0.5) / f64::from(n);
        // Weight of the mass at distance s from the axis (unit radius).
        let moment = |weight: &dyn Fn(f64) -> f64| {
            let (mut m, mut i2) = (0.0, 0.0);
            for i in 0..n {
                let s = mid(i);
                m += weight(s);
                i2 += weight(s) * s * s;
            }
            i2 / m
        };
        // A rod of unit length, by halves.
        let rod = moment(&|_| 1.0) / 4.0;
        let disc = moment(&|s| s);
        let sphere = moment(&|s| s * (1.0 - s * s).sqrt());
        // A shell by polar angle: s = sin t, dm = sin t dt.
        let (mut m, mut shell) = (0.0, 0.0);
        for i in 0..n {
            let t = mid(i) * std::f64::consts::PI;
            m += libm::sin(t);
            shell += libm::sin(t) * libm::sin(t) * libm::sin(t);
        }
        for (shape, quadrature) in [
            (Shape::Disc, disc),
            (Shape::Sphere, sphere),
            (Shape::Shell, shell / m),
            (Shape::Hoop, 1.0),
            (Shape::Rod, rod),
        ] {
            let b: Dd = beta(shape);
            assert!((b.hi - quadrature).abs() < 1e-5, "{shape:?}: {} against {quadrature}", b.hi);
        }
    }
}
