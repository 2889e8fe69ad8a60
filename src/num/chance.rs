//! Distributions of chance: normal, chi-squared, F. For the statistics of reports; about 12 digits.
use crate::num::trig;

/// Standard deviations that hold 95 % of a normal distribution, both sides.
pub const NORMAL_95: f64 = 1.959_963_984_540_054;
/// Terms at most of a series or continued fraction; those of reports end after some tens.
const MOST: usize = 10_000;
/// A term below this share ends a sum.
const ENOUGH: f64 = 1e-15;
/// Stands for 0 in a denominator of a continued fraction.
const TINY: f64 = 1e-300;

/// Probability that a normal variable is at least so many standard deviations away, either side.
pub fn normal_two_sided(z: f64) -> f64 {
    trig::erfc(z.abs() / std::f64::consts::SQRT_2).min(1.0)
}

/// Probability that a chi-squared variable with so many degrees of freedom (> 0) is greater than x.
///
/// Q(d/2, x/2), the upper incomplete gamma function: its series below the mean, else its continued fraction (Press et al.,
/// Numerical Recipes, 3rd ed., section 6.2).
pub fn chi_squared_above(x: f64, degrees: f64) -> f64 {
    let (a, x) = (degrees / 2.0, x / 2.0);
    if x <= 0.0 {
        return 1.0;
    }
    let front = trig::exp(a * trig::ln(x) - x - trig::ln_gamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        for _ in 0..MOST {
            n += 1.0;
            term *= x / n;
            sum += term;
            if term < sum * ENOUGH {
                break;
            }
        }
        return (1.0 - front * sum).clamp(0.0, 1.0);
    }
    let b = x + 1.0 - a;
    let terms = (1..).map(f64::from).map(|i| (-i * (i - a), b + 2.0 * i));
    (front * continued(1.0 / TINY, b, terms)).clamp(0.0, 1.0)
}

fn away(x: f64) -> f64 {
    if x.abs() < TINY { TINY } else { x }
}

/// The continued fraction `1/(b + a1/(b1 + a2/(b2 + ...)))` of these terms, by the method of Lentz.
fn continued(above: f64, b: f64, terms: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut c, mut d) = (above, 1.0 / away(b));
    let mut h = d;
    for (a, b) in terms.take(MOST) {
        d = 1.0 / away(a * d + b);
        c = away(b + a / c);
        let change = c * d;
        h *= change;
        if (change - 1.0).abs() < ENOUGH {
            break;
        }
    }
    h
}

/// The regularised incomplete beta function I_x(a, b), a and b > 0: continued fraction of Lentz (Numerical Recipes, 6.4).
pub fn beta_below(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - beta_below(1.0 - x, b, a);
    }
    let front = trig::exp(
        trig::ln_gamma(a + b) - trig::ln_gamma(a) - trig::ln_gamma(b)
            + a * trig::ln(x)
            + b * trig::ln(1.0 - x),
    );
    let terms = (1..).map(f64::from).flat_map(|m| {
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        [(even, 1.0), (odd, 1.0)]
    });
    let h = continued(1.0, 1.0 - (a + b) * x / (a + 1.0), terms);
    (front * h / a).clamp(0.0, 1.0)
}

/// The value below which an F variable with these degrees of freedom (> 0) lies with this probability (0 < p < 1).
pub fn f_quantile(p: f64, above: f64, below: f64) -> f64 {
    // F = (below/above) y/(1 - y), where y has a beta distribution: halved until doubles end.
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if beta_below(middle, above / 2.0, below / 2.0) < p {
            low = middle;
        } else {
            high = middle;
        }
    }
    let y = 0.5 * (low + high);
    below / above * y / (1.0 - y)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed tables and closed forms: `exp(-x/2)` for two degrees, polynomials and the arcsine for the beta function; the long
    /// digits of F and of the normal are those of scipy.
    #[test]
    fn as_tables_have_them() {
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-3), "{a} {b}");
        close(normal_two_sided(NORMAL_95), 0.05);
        close(normal_two_sided(-1.0), 0.317_310_507_862_914);
        close(chi_squared_above(3.841_458_820_694_124, 1.0), 0.05);
        close(chi_squared_above(18.307_038_053_275_146, 10.0), 0.05);
        close(chi_squared_above(2.0, 2.0), 0.367_879_441_171_442_3);
        close(chi_squared_above(0.0, 3.0), 1.0);
        close(beta_below(0.5, 2.0, 3.0), 0.6875);
        close(beta_below(0.1, 2.0, 3.0), 0.0523);
        close(beta_below(0.9, 0.5, 0.5), 0.795_167_235_300_866_6);
        // F(0.95; 5, 10) = 3.3258 and F(0.975; 10, 20) = 2.7737 in every table.
        close(f_quantile(0.95, 5.0, 10.0), 3.325_834_530_413_011);
        assert!((f_quantile(0.975, 10.0, 20.0) - 2.7737).abs() < 5e-5);
        close(f_quantile(0.5, 7.0, 7.0), 1.0);
    }
}
