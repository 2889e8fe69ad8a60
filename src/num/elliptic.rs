//! Elliptic integrals of the first kind in any number type, by two methods that have nothing in common: Carlson's
//! duplication, and the arithmetic-geometric mean.
//!
//! Sources: B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numer. Algorithms 10 (1995) 13-26;
//! NIST Digital Library of Mathematical Functions, 19.29.4 and 19.36.1; R. Bulirsch, *Numerical calculation of elliptic
//! integrals and elliptic functions*, Numer. Math. 7 (1965) 78-90 (`el1`).
use crate::num::{Dd, Real, trig};

/// Relative spread of the arguments at which the series of R_F takes over: its first term left out, of order 8, is below
/// 2^-100.
const SPREAD: f64 = 1e-4;
/// Relative gap of the two means at which the next step leaves less than 2^-100.
const MEANS: f64 = 1e-16;
/// Relative size of what the methods leave out, at most 2^-92.
const LEFT_OUT: f64 = 1.0 / (1u128 << 92) as f64;
/// Steps after which something is wrong; the widest double-doubles need 20.
const STEPS: usize = 200;

/// Carlson's `R_F(x^2, y^2, z^2) = 1/2 int_0^inf dt / sqrt((t + x^2)(t + y^2)(t + z^2))` from the roots x, y, z >= 0.
///
/// Infinite if two of them are 0. The roots and not the squares, which may be too small for a number of the machine.
pub fn rf_of_roots<T: Real>(x: T, y: T, z: T) -> T {
    if [x, y, z].iter().filter(|v| v.is_zero()).count() > 1 {
        return T::of(f64::INFINITY);
    }
    // The first duplication by the roots, the others by the squares.
    let lambda = x * y + y * z + z * x;
    let quarter = |v: T| (v + lambda).scale2(-2);
    let (mut x, mut y, mut z) = (quarter(x.square()), quarter(y.square()), quarter(z.square()));
    for _ in 0..STEPS {
        let mean = (x + y + z) / T::of(3.0);
        let [a, b, c] = [x, y, z].map(|v| (mean - v) / mean);
        let spread = a.f64().abs().max(b.f64().abs()).max(c.f64().abs());
        if spread.is_nan() || spread < SPREAD {
            let e2 = a * b - c.square();
            let e3 = a * b * c;
            let share = |over: f64, under: f64| T::constant(Dd::new(over) / Dd::new(under));
            let sum =
                T::of(1.0) - e2 * share(1.0, 10.0) + e3 * share(1.0, 14.0) + e2.square() * share(1.0, 24.0)
                    - e2 * e3 * share(3.0, 44.0)
                    - e2.square() * e2 * share(5.0, 208.0)
                    + e3.square() * share(3.0, 104.0)
                    + e2.square() * e3 * share(1.0, 16.0);
            return enclosed(sum / mean.root());
        }
        let (rx, ry, rz) = (x.root(), y.root(), z.root());
        let lambda = rx * ry + ry * rz + rz * rx;
        let quarter = |v: T| (v + lambda).scale2(-2);
        (x, y, z) = (quarter(x), quarter(y), quarter(z));
    }
    T::of(f64::NAN)
}

/// With the part of a series or of an iteration that is left out, for numbers that keep account of their errors.
fn enclosed<T: Real>(value: T) -> T {
    value.widened(|| value.f64().abs() * LEFT_OUT)
}

/// The arithmetic-geometric mean of two numbers >= 0; 0 if one of them is.
pub fn mean_of<T: Real>(a: T, b: T) -> T {
    if a.is_zero() || b.is_zero() {
        return T::zero();
    }
    let (mut a, mut b) = (a, b);
    for _ in 0..STEPS {
        let close = ((a - b) / a).f64().abs();
        (a, b) = ((a + b).scale2(-1), (a * b).root());
        if close.is_nan() || close < MEANS.max(T::NOISE) {
            return enclosed(a);
        }
    }
    T::of(f64::NAN)
}

/// `K = int_0^(pi/2) d theta / sqrt(cos^2 + k'^2 sin^2)` from the complementary modulus k' >= 0; infinite at 0.
pub fn complete<T: Real>(complement: T) -> T {
    let half_pi = T::constant(Dd::PI.scale2(-1));
    let mean = mean_of(T::of(1.0), complement);
    if mean.is_zero() { T::of(f64::INFINITY) } else { half_pi / mean }
}

/// How many terms of `2 K(k) / pi = 1 + (1/2)^2 k^2 + (1 3 / 2 4)^2 k^4 + ...`, the leading 1 among them, come within this share of
/// the whole, for a modulus 0 <= k <= 1; `None` if that takes more than `most`.
pub fn terms_within(modulus: f64, share: f64, most: usize) -> Option<usize> {
    let square = modulus * modulus;
    let half_pi = std::f64::consts::FRAC_PI_2;
    let whole = complete((1.0 - square).max(0.0).sqrt()) / half_pi;
    if !whole.is_finite() {
        return None;
    }
    let (mut sum, mut term, mut factor) = (0.0, 1.0, 0.0);
    for count in 1..=most {
        sum += term;
        // Terms are positive: the sum stays below the whole.
        if whole - sum <= share * whole {
            return Some(count);
        }
        factor += 1.0;
        let odd = (2.0 * factor - 1.0) / (2.0 * factor);
        term *= odd * odd * square;
    }
    None
}

/// `F = int_0^theta d theta / sqrt(cos^2 + k'^2 sin^2)` for the angle theta from 0 to 180 degrees of the point
/// (along, across), across >= 0, and the complementary modulus k' >= 0.
pub fn incomplete<T: Real>(across: T, along: T, complement: T) -> T {
    if across.is_zero() && along.sign() >= 0.0 {
        return T::zero();
    }
    if complement.is_zero() {
        // asinh(tan theta), infinite at 90 degrees.
        if along.sign() <= 0.0 {
            return T::of(f64::INFINITY);
        }
        let secant = (across.square() + along.square()).root();
        return across / along * rf_of_roots(secant / along, T::of(1.0), T::of(1.0));
    }
    if along.is_zero() {
        return complete(complement);
    }
    if across.is_zero() {
        return complete(complement).scale2(1);
    }
    let (mut a, mut b, mut y) = (T::of(1.0), complement, along / across);
    // Half turns of the amplitude, which about doubles with every step.
    let mut turns = if y.sign() < 0.0 { 1.0 } else { 0.0 };
    for _ in 0..STEPS {
        let product = a * b;
        let close = ((a - b) / a).f64().abs();
        (a, b) = (a + b, product.root().scale2(1));
        // A cotangent of exactly 0 is the quarter turn itself; the next would be infinite.
        if y.is_zero() {
            y = T::of(f64::MIN_POSITIVE);
        }
        y = y - product / y;
        if close.is_nan() || close < MEANS.max(T::NOISE) {
            return enclosed((trig::angle(a, y) + T::constant(Dd::PI * Dd::new(turns))) / a);
        }
        turns = 2.0 * turns + if y.sign() < 0.0 { 1.0 } else { 0.0 };
    }
    T::of(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "a check to 1e-9 needs no last bits")]
    fn so_many_terms_suffice_and_one_less_does_not() {
        let mut seen = [0usize; 40];
        for step in 1..1000u32 {
            let k = f64::from(step) / 1000.0;
            for share in [0.05, 0.01, 0.003, 1e-4] {
                let Some(count) = terms_within(k, share, 400) else { continue };
                // Summed the other way round, from binomials, against the integral by a fine midpoint rule.
                let panels = 4000;
                let whole: f64 = (0..panels)
                    .map(|i| (f64::from(i) + 0.5) / f64::from(panels) * std::f64::consts::FRAC_PI_2)
                    .map(|t| 1.0 / (1.0 - k * k * t.sin() * t.sin()).sqrt() / f64::from(panels))
                    .sum();
                let sum = |n: usize| -> f64 {
                    let term = |j: usize| {
                        let ratio: f64 = (1..=j).map(|i| (2 * i - 1) as f64 / (2 * i) as f64).product();
                        ratio * ratio * k.powi(2 * i32::try_from(j).unwrap())
                    };
                    (0..n).rev().map(term).sum()
                };
                assert!(whole - sum(count) <= share * whole * (1.0 + 1e-9), "{k} {share} {count}");
                assert!(
                    count == 1 || whole - sum(count - 1) > share * whole * (1.0 - 1e-9),
                    "{k} {share} {count}"
                );
                seen[count.min(39)] += 1;
            }
        }
        assert!(seen.iter().take(12).skip(1).all(|n| *n > 0), "{seen:?}");
        assert_eq!(terms_within(1.0, 0.01, 400), None);
    }

    fn near(a: Dd, b: Dd) -> bool {
        ((a - b) / b).hi.abs() < 1e-29
    }

    /// K by the two methods, from a modulus of almost 0 to one of almost 1.
    #[test]
    fn both_methods_give_the_complete_integral() {
        for complement in [1.0, 0.999_999, 0.7, 0.1, 1e-3, 1e-12, 1e-100] {
            let c = Dd::new(complement);
            let (carlson, mean) = (rf_of_roots(Dd::ZERO, c, Dd::ONE), complete(c));
            assert!(near(carlson, mean), "{complement}: {carlson:?} {mean:?}");
        }
        // K(1/sqrt 2) = Gamma(1/4)^2 / (4 sqrt pi) = 1.85407467730137191843385034719526...
        let k = complete(Dd::new(0.5).sqrt());
        let known = Dd::sum(1.854_074_677_301_371_9, 4.220_810_632_962_079e-17);
        assert!((k - known).hi.abs() < 1e-30, "{k:?}");
    }
    /// F(theta, k) = sin R_F(cos^2, 1 - k^2 sin^2, 1), also beyond the quarter turn.
    #[test]
    fn both_methods_give_the_incomplete_integral() {
        for complement in [1.0, 0.9, 0.3, 1e-6, 1e-60] {
            for degrees in [1e-30, 0.01, 20.0, 45.0, 77.7, 89.999_999, 90.0, 91.0, 150.0, 179.0, 180.0] {
                let c = Dd::new(complement);
                let (sine, cosine) = trig::sin_cos_degrees(degrees);
                let delta = (cosine * cosine + c * c * sine * sine).sqrt();
                let first = sine * rf_of_roots(cosine.abs(), delta, Dd::ONE);
                let carlson = if degrees > 90.0 { complete(c) + complete(c) - first } else { first };
                let mean = incomplete(sine, cosine, c);
                assert!(near(carlson, mean), "{complement} {degrees}: {carlson:?} {mean:?}");
            }
        }
    }
    #[test]
    fn the_separatrix_has_a_logarithm() {
        // F(45 degrees, 1) = ln(1 + sqrt 2).
        let f = incomplete(Dd::ONE, Dd::ONE, Dd::ZERO);
        assert!((f.hi - 0.881_373_587_019_543).abs() < 1e-15, "{f:?}");
        assert!(incomplete(Dd::ONE, Dd::ZERO, Dd::ZERO).hi.is_infinite());
        assert!(rf_of_roots(Dd::ZERO, Dd::ZERO, Dd::ONE).hi.is_infinite());
    }
}
