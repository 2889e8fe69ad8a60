//! Portable elementary functions: the same bits on every machine. Keeper of libm.
//!
//! Angles of data are reduced *in degrees*, where the reduction is exact: sine and cosine are exact at 0, 30, 60 and 90
//! degrees and accurate to double-double everywhere, also near 90 degrees.
use crate::num::ball::STEP;
use crate::num::dd::{exponent, unwatched};
use crate::num::{Dd, Real};
use std::sync::LazyLock;

/// Pi / 180 as a double-double.
const RADIANS_PER_DEGREE: Dd = Dd { hi: 0.017_453_292_519_943_295, lo: 2.948_652_270_870_168e-19 };

/// Absolute error of the functions of libm here, which are within an ulp, and of what is rounded to a double before.
const LAST: f64 = 4.0 * f64::EPSILON;

/// Sine and cosine of whole degrees from 0 to 90.
static WHOLE: LazyLock<[(Dd, Dd); 91]> = LazyLock::new(|| {
    let mut table = [(Dd::ZERO, Dd::ONE); 91];
    for n in 0..=45u32 {
        let x = Dd::new(f64::from(n)) * RADIANS_PER_DEGREE;
        let (mut s, mut c) = series(x, 28);
        if n == 30 {
            s = Dd::new(0.5);
        }
        if n == 0 {
            (s, c) = (Dd::ZERO, Dd::ONE);
        }
        let n = n as usize;
        table[n] = (s, c);
        table[90 - n] = (c, s);
    }
    table
});

/// Sine and cosine by their Taylor series up to the given power.
fn series(x: Dd, powers: u32) -> (Dd, Dd) {
    let (mut sine, mut cosine, mut term) = (Dd::ZERO, Dd::ONE, Dd::ONE);
    for n in 1..=powers {
        term = term * x / Dd::new(f64::from(n));
        match n % 4 {
            1 => sine = sine + term,
            2 => cosine = cosine - term,
            3 => sine = sine - term,
            _ => cosine = cosine + term,
        }
    }
    (sine, cosine)
}

/// `1/n!` for n = 2..=12, for the short series of a fraction of a degree.
static INVERSE_FACTORIAL: LazyLock<[Dd; 13]> = LazyLock::new(|| {
    let mut t = [Dd::ONE; 13];
    for n in 2..=12u32 {
        t[n as usize] = t[n as usize - 1] / Dd::new(f64::from(n));
    }
    t
});

/// Sine and cosine of an angle in degrees, as double-doubles.
///
/// Not finite: NaN. The relative error is below 2^-100 wherever the result is not zero.
pub fn sin_cos_degrees(degrees: f64) -> (Dd, Dd) {
    unwatched(|| reduced(degrees))
}

fn reduced<T: Real>(degrees: f64) -> (T, T) {
    if !degrees.is_finite() {
        return (T::of(f64::NAN), T::of(f64::NAN));
    }
    // A negative angle would lose its last bits beside 360.
    if degrees < 0.0 {
        let (s, c) = reduced::<T>(-degrees);
        return (-s, c);
    }
    // The remainder is exact, and so is each quadrant taken from it.
    let mut x = libm::fmod(degrees, 360.0);
    let mut quadrant = 0;
    while x > 90.0 {
        x -= 90.0;
        quadrant += 1;
    }
    let nearest = libm::rint(x);
    let rest = x - nearest;
    beyond(quadrant, beside(nearest as usize, T::of(rest) * T::constant(RADIANS_PER_DEGREE)))
}

/// Sine and cosine of an angle so many right angles on.
fn beyond<T: Real>(quadrant: u32, (s, c): (T, T)) -> (T, T) {
    match quadrant {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// Sine and cosine beside a whole number of degrees from 0 to 90, at most 0.0088 radians away.
fn beside<T: Real>(whole: usize, d: T) -> (T, T) {
    let (sn, cn) = WHOLE[whole];
    let (sn, cn) = (T::constant(sn), T::constant(cn));
    if d.is_nothing() {
        return (sn, cn);
    }
    let f = |n: usize| T::constant(INVERSE_FACTORIAL[n]);
    let q = d * d;
    // sin d / d - 1 and 1 - cos d: the last terms kept are below 1e-33 of the sum, or below 1e-18 of it in doubles.
    let (sine, one_minus_cosine) = if T::is_double() {
        (d - d * q * (f(3) - q * (f(5) - q * f(7))), q * (f(2) - q * (f(4) - q * (f(6) - q * f(8)))))
    } else {
        (
            d - d * q * (f(3) - q * (f(5) - q * (f(7) - q * (f(9) - q * f(11))))),
            q * (f(2) - q * (f(4) - q * (f(6) - q * (f(8) - q * (f(10) - q * f(12)))))),
        )
    };
    let one = T::of(1.0);
    match whole {
        0 => (sine, one - one_minus_cosine),
        90 => (one - one_minus_cosine, -sine),
        _ => (sn - sn * one_minus_cosine + cn * sine, cn - cn * one_minus_cosine - sn * sine),
    }
}

/// Sine and cosine of an angle in radians, as double-doubles.
///
/// Not finite: NaN. The error is below 2^-95 for angles of a few turns; near 0 it is relative.
pub fn sin_cos_radians(x: Dd) -> (Dd, Dd) {
    unwatched(|| turned(x))
}

fn turned<T: Real>(x: T) -> (T, T) {
    if !x.is_finite() {
        return (T::of(f64::NAN), T::of(f64::NAN));
    }
    if T::leading(|| x.f64() < 0.0) {
        let (s, c) = turned(-x);
        return (-s, c);
    }
    let whole = T::leading(|| libm::rint(x.f64() / RADIANS_PER_DEGREE.hi));
    let rest = x - T::of(whole) * T::constant(RADIANS_PER_DEGREE);
    let turned = libm::fmod(whole, 360.0);
    let quadrant = libm::floor(turned / 90.0);
    beyond(quadrant as u32, beside((turned - 90.0 * quadrant) as usize, rest))
}

/// Below this share a sine is its angle, and a tangent too: the next term is below 2^-112.
const STRAIGHT: f64 = 1.0 / (1u64 << 56) as f64;

/// [`sin_cos_radians`] in any number type.
pub fn turn<T: Real>(x: T) -> (T, T) {
    if T::leading(|| x.f64().abs() < STRAIGHT) {
        let sine = x.widened(|| x.f64().abs() * STEP);
        let cosine = unwatched(|| T::of(1.0) - x.square().scale2(-1));
        return (sine, cosine.widened(|| STEP));
    }
    if T::is_double() {
        return turned(x);
    }
    let (s, c) = sin_cos_radians(x.value());
    let with = |value: Dd| T::constant(value).widened(|| x.radius() + 64.0 * STEP);
    (with(s), with(c))
}

/// Angle of the point (x, y), radians, to double-double.
pub fn angle<T: Real>(y: T, x: T) -> T {
    let slope = y / x;
    if T::leading(|| x.value().hi > 0.0 && slope.f64().abs() < STRAIGHT) {
        return slope.widened(|| slope.f64().abs() * STEP);
    }
    let rough = atan2(y, x);
    if T::is_double() || !rough.is_finite() {
        return rough;
    }
    // What is left after turning back is so small that it is its own tangent.
    let (s, c) = sin_cos_radians(rough.value());
    let (s, c) = (T::constant(s), T::constant(c));
    (rough + (y * c - x * s) / (x * c + y * s)).widened(|| 64.0 * STEP)
}

/// Radians in a degree.
pub fn radians_per_degree<T: Real>() -> T {
    T::constant(RADIANS_PER_DEGREE)
}

/// Degrees in a radian.
pub fn degrees_per_radian<T: Real>() -> T {
    T::constant(Dd::new(180.0) / Dd::PI)
}

/// [`sin_cos_degrees`] in any number type.
pub fn sin_cos_of_degrees<T: Real>(degrees: T) -> (T, T) {
    if T::is_double() {
        return degrees.each(reduced);
    }
    let (s, c) = sin_cos_degrees(degrees.f64());
    // Sine and cosine change no faster than the angle in radians.
    let with = |value: Dd| T::constant(value).widened(|| degrees.radius() * 0.018 + value.hi.abs() * STEP);
    (with(s), with(c))
}

/// Angle of the point (x, y), radians, within one ulp.
pub fn atan2<T: Real>(y: T, x: T) -> T {
    // Only their ratio counts: near 1 no square overflows.
    let e = exponent(y.size().max(x.size())).clamp(-1000, 1000);
    let (y, x) = (y.scale2(-e), x.scale2(-e));
    y.pairwise(x, libm::atan2).widened(|| {
        // A point moved by d, seen from the distance h, turns by at most asin(d/h) <= pi/2 d/h.
        let (moved, distance) = (y.radius() + x.radius(), y.f64().abs().max(x.f64().abs()));
        if moved < 0.5 * distance { 1.6 * moved / (distance - moved) + 4.0 * LAST } else { f64::INFINITY }
    })
}

/// Sine and cosine of a double in radians, within an ulp.
pub fn sin_cos_f64(x: f64) -> (f64, f64) {
    (libm::sin(x), libm::cos(x))
}

/// Logarithm to base 10, for axes; within an ulp.
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// Natural logarithm; within an ulp.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// `e^x`; within an ulp.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// ln 2.
const LN_2: Dd = Dd { hi: std::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17 };

/// [`exp`] in any number type, by Taylor's series after the argument is made small; the error is below 2^-94 of the result.
pub fn exp_of<T: Real>(x: T) -> T {
    /// The argument is divided by 2^HALVED, the sum squared as often.
    const HALVED: i32 = 6;
    let whole = T::leading(|| libm::rint(x.f64() / LN_2.hi));
    if whole.is_nan() || whole.abs() > 1000.0 {
        return x.each(|x| (exp(x), 0.0)).0;
    }
    let d = (x - T::of(whole) * T::constant(LN_2)).scale2(-HALVED);
    // e^d - 1: the last term kept is below 2^-110 of it.
    let mut less_one = T::zero();
    for n in (1..INVERSE_FACTORIAL.len()).rev() {
        less_one = d * (T::constant(INVERSE_FACTORIAL[n]) + less_one);
    }
    // (1 + y)^2 - 1 = y (2 + y): the digits of a small y are kept.
    for _ in 0..HALVED {
        less_one = less_one * (T::of(2.0) + less_one);
    }
    (T::of(1.0) + less_one).scale2(whole as i32)
}

/// Logarithm of the gamma function of a positive x; within a few ulp of the greater of it and 1.
pub fn ln_gamma(x: f64) -> f64 {
    libm::lgamma(x)
}

/// What of a normal distribution lies beyond: `2/sqrt(pi)` times the integral of `exp(-t^2)` from x on; within a few ulp.
pub fn erfc(x: f64) -> f64 {
    libm::erfc(x)
}

/// `x^y` of a positive x, for step sizes; within a few ulp.
pub fn power(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

#[cfg(test)]
#[allow(clippy::float_cmp, clippy::neg_cmp_op_on_partial_ord, reason = "exact bits are what is tested")]
mod tests {
    use super::*;

    #[test]
    fn exact_where_the_value_is_a_double() {
        for (deg, s, c) in [(0.0, 0.0, 1.0), (90.0, 1.0, 0.0)] {
            assert_eq!(sin_cos_degrees(deg), (Dd::new(s), Dd::new(c)));
        }
        assert_eq!(sin_cos_degrees(30.0).0, Dd::new(0.5));
        assert_eq!(sin_cos_degrees(60.0).1, Dd::new(0.5));
        assert_eq!(sin_cos_degrees(-30.0).0, Dd::new(-0.5));
        assert_eq!(sin_cos_degrees(150.0).0, Dd::new(0.5));
    }
    #[test]
    fn squares_sum_to_one_to_thirty_digits() {
        let mut x = 0.013_7;
        while x < 400.0 {
            let (s, c) = sin_cos_degrees(x);
            let miss = s * s + c * c - Dd::ONE;
            assert!(miss.hi.abs() < 1e-30, "{x}: {miss:?}");
            x *= 1.037;
        }
    }
    #[test]
    fn addition_theorem_links_whole_and_broken_degrees() {
        // sin(a + b) with a + b exact in binary.
        for (a, b) in [(17.25, 3.5), (44.75, 12.125), (88.5, 1.25)] {
            let ((sa, ca), (sb, cb)) = (sin_cos_degrees(a), sin_cos_degrees(b));
            let miss = sa * cb + ca * sb - sin_cos_degrees(a + b).0;
            assert!(miss.hi.abs() < 1e-30, "{a} {b}: {miss:?}");
        }
    }
    /// Found by a pinned body at -185.6 degrees, whose two roads differed by more than rounding: earlier tests had no angle
    /// below -90 degrees whose last bits 360 does not hold.
    #[test]
    fn negative_angles_keep_their_last_bits() {
        for x in [-92.813_807, -120.928_073_111_206_32, -185.627_613_707_822_23, -359.9, -1000.1] {
            let ((s, c), (t, d)) = (sin_cos_degrees(x), sin_cos_degrees(-x));
            assert_eq!((s, c), (-t, d), "{x}");
        }
    }
    #[test]
    fn radians_and_degrees_agree() {
        for degrees in [-359.0, -20.5, 0.0, 1e-9, 12.25, 89.75, 90.0, 200.0, 359.5, 700.125] {
            let (s, c) = sin_cos_degrees(degrees);
            let (t, d) = sin_cos_radians(Dd::new(degrees) * RADIANS_PER_DEGREE);
            assert!((s - t).hi.abs() < 1e-29 && (c - d).hi.abs() < 1e-29, "{degrees}");
        }
    }
    #[test]
    fn the_angle_of_a_point_has_32_digits() {
        for x in [-3.1, -2.0, -0.5, 1e-20, 1e-3, 0.7, 1.55, 1.6, 3.0] {
            let (s, c) = sin_cos_radians(Dd::new(x));
            let back = angle(s, c);
            assert!(((back - Dd::new(x)) / Dd::new(x)).hi.abs() < 1e-29, "{x}: {back:?}");
        }
    }
    #[test]
    fn near_ninety_the_cosine_keeps_its_digits() {
        let (_, c) = sin_cos_degrees(89.999_999_999);
        let (s, _) = sin_cos_degrees(90.0 - 89.999_999_999);
        assert!(((c - s).hi / s.hi).abs() < 1e-29);
    }
}
