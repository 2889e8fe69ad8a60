//! Gauss-Legendre quadrature: nodes and weights of any number of points, in double-double.
//!
//! `int_a^b f = (b - a) sum w_i f(a + (b - a) x_i)`, exact for polynomials up to degree 2n - 1. Source: Abramowitz and Stegun,
//! *Handbook of Mathematical Functions*, 25.4.29-30, here on the interval from 0 to 1.
use crate::num::{Dd, Real, trig};
use std::sync::OnceLock;

/// The most points that [`rule`] gives.
pub const MOST_POINTS: usize = 96;

/// Nodes in (0, 1), ascending, and weights of sum 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    /// Places.
    pub nodes: Vec<Dd>,
    /// Weights, > 0.
    pub weights: Vec<Dd>,
}

/// The rule of `n` points, 1 to [`MOST_POINTS`] (the nearest of these otherwise); computed once, then kept.
pub fn rule(n: usize) -> &'static Rule {
    static RULES: [OnceLock<Rule>; MOST_POINTS] = [const { OnceLock::new() }; MOST_POINTS];
    let n = n.clamp(1, MOST_POINTS);
    RULES[n - 1].get_or_init(|| compute(n))
}

/// Legendre polynomials of degree 0 to `last` at a place from -1 to 1, by the recurrence.
pub fn polynomials<T: Real>(x: T, last: usize) -> Vec<T> {
    let mut p = vec![T::of(1.0), x];
    for n in 2..=last {
        let m = n as f64;
        p.push((T::of(2.0 * m - 1.0) * x * p[n - 1] - T::of(m - 1.0) * p[n - 2]) / T::of(m));
    }
    p
}

/// The zeros of the polynomial of this degree from -1 to 1, ascending, each with the slope there: Tricomi's estimate, then Newton.
pub fn zeros(degree: usize) -> impl Iterator<Item = (Dd, Dd)> {
    let n = degree as f64;
    (0..degree).map(move |j| {
        let mut x = Dd::new(-trig::sin_cos_degrees(180.0 * (j as f64 + 0.75) / (n + 0.5)).1.hi);
        let mut slope = Dd::ONE;
        for _ in 0..8 {
            let p = polynomials(x, degree);
            slope = Dd::new(n) * (x * p[degree] - p[degree - 1]) / (x * x - Dd::ONE);
            x = x - p[degree] / slope;
        }
        (x, slope)
    })
}

/// Node and weight on the interval from 0 to 1 of a zero with its slope.
pub fn node((x, slope): (Dd, Dd)) -> (Dd, Dd) {
    ((x + Dd::ONE).scale2(-1), Dd::ONE / ((Dd::ONE - x * x) * slope * slope))
}

fn compute(n: usize) -> Rule {
    let (nodes, weights) = zeros(n).map(node).unzip();
    Rule { nodes, weights }
}

/// `int_a^b f` by `n` points.
pub fn integral<T: Real>(n: usize, a: T, b: T, mut f: impl FnMut(T) -> T) -> T {
    let rule = rule(n);
    let width = b - a;
    let mut sum = T::zero();
    for (x, w) in rule.nodes.iter().zip(&rule.weights) {
        sum = sum + T::constant(*w) * f(a + width * T::constant(*x));
    }
    width * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact_to_thirty_digits() {
        for n in [1, 2, 3, 5, 8, 16, 33, 64, MOST_POINTS] {
            let rule = rule(n);
            assert!(rule.nodes.windows(2).all(|w| w[0] < w[1]), "{n}: nodes ascend");
            assert!(rule.weights.iter().all(|w| w.hi > 0.0));
            for degree in [0, 1, 2, 3, n, 2 * n - 1] {
                if degree > 2 * n - 1 {
                    continue;
                }
                let sum = integral(n, Dd::ZERO, Dd::ONE, |x| (0..degree).fold(Dd::ONE, |p, _| p * x));
                let miss = sum * Dd::new(degree as f64 + 1.0) - Dd::ONE;
                assert!(miss.hi.abs() < 1e-29, "{n} points, degree {degree}: {miss:?}");
            }
        }
    }
    #[test]
    fn too_high_a_degree_is_not_exact() {
        let sum = integral(2, Dd::ZERO, Dd::ONE, |x| x * x * x * x);
        assert!((sum.hi - 0.2).abs() > 1e-3);
    }
}
