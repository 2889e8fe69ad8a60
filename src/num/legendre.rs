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

/// Legendre polynomial of degree n and its derivative, by the recurrence, for |x| < 1.
fn legendre(n: usize, x: Dd) -> (Dd, Dd) {
    let (mut before, mut p) = (Dd::ONE, x);
    for k in 2..=n {
        let k = k as f64;
        let next = (Dd::new(2.0 * k - 1.0) * x * p - Dd::new(k - 1.0) * before) / Dd::new(k);
        (before, p) = (p, next);
    }
    let slope = Dd::new(n as f64) * (before - x * p) / (Dd::ONE - x * x);
    (p, slope)
}

fn compute(n: usize) -> Rule {
    let (mut nodes, mut weights) = (vec![Dd::ZERO; n], vec![Dd::ZERO; n]);
    for i in 0..n.div_ceil(2) {
        let mut x = Dd::ZERO;
        if 2 * i + 1 != n {
            // Tricomi's estimate, then Newton: three rounds reach 32 digits from four, a fourth settles the last.
            let angle = std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5);
            x = trig::sin_cos(Dd::new(angle)).1;
            for _ in 0..5 {
                let (p, slope) = legendre(n, x);
                x = x - p / slope;
            }
        }
        let (_, slope) = legendre(n, x);
        // 1 - x and 1 + x halved: nodes near the ends keep their digits.
        let weight = Dd::ONE / ((Dd::ONE - x) * (Dd::ONE + x) * slope * slope);
        (nodes[i], weights[i]) = ((Dd::ONE - x).scale2(-1), weight);
        (nodes[n - 1 - i], weights[n - 1 - i]) = ((Dd::ONE + x).scale2(-1), weight);
    }
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
