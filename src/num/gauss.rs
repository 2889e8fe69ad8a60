//! Gauss-Legendre quadrature in any number type: a panel of 24 nodes, taken as it is where the function is seen to be smooth, else
//! halved until the halves say the same as the whole.
//!
//! Source: Press, Teukolsky, Vetterling, Flannery, *Numerical Recipes*, 3rd ed., 4.6 (nodes by Newton's method); here in
//! double-double.
use crate::num::{Dd, Real};
use std::sync::LazyLock;

/// Nodes of a panel.
pub const NODES: usize = 24;
/// Whole and halves agree if they differ by less than this share, 2^-62, or by rounding: the halves are then far better.
const SETTLED: f64 = 1.0 / (1u64 << 62) as f64;
/// Legendre coefficients that are looked at for smoothness, the last ones of a panel.
const LAST: usize = 3;
/// A function is smooth on a panel if its last coefficients are below this share of its mean magnitude. They fall geometrically,
/// and the mean is exact up to twice their degree: its error is about the square of this.
pub const SMOOTH: f64 = 1e-12;
/// The same for [`running`], which is exact up to their degree alone: its error is about this.
pub const SMOOTH_RUNNING: f64 = 1e-23;
/// Times that a panel may be halved: a singularity 2^-40 of the interval away is still seen.
const HALVINGS: u32 = 40;
/// Panels of one quadrature at most: a singularity takes two for each halving; what takes more is rough by its rounding, everywhere.
const PANELS: u32 = 300;

/// A quadrature that did not settle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unsettled {
    /// The value by halves.
    pub value: f64,
    /// How far the whole is off it.
    pub gap: f64,
}

/// One value for each node of a panel.
pub type PerNode<T> = Vec<T>;

/// The panel from 0 to 1.
struct Panel {
    nodes: [Dd; NODES],
    weights: [Dd; NODES],
    /// Integral from 0 to node `j` of the polynomial that is 1 at node `k` and 0 at the others, row by row.
    running: Vec<Dd>,
    /// What makes the last Legendre coefficients of the values at the nodes.
    last: [[Dd; NODES]; LAST],
    /// Weights of the interpolation between the nodes, in barycentric form.
    between: [Dd; NODES],
}

/// Legendre polynomials of degree 0 to `NODES + 1` at a place from -1 to 1.
fn legendre(x: Dd) -> [Dd; NODES + 2] {
    let mut p = [Dd::ONE; NODES + 2];
    p[1] = x;
    for n in 2..NODES + 2 {
        let m = n as f64;
        p[n] = (Dd::new(2.0 * m - 1.0) * x * p[n - 1] - Dd::new(m - 1.0) * p[n - 2]) / Dd::new(m);
    }
    p
}

static PANEL: LazyLock<Panel> = LazyLock::new(|| {
    let n = NODES as f64;
    let half = Dd::new(0.5);
    let mut places = [Dd::ZERO; NODES];
    let mut panel = Panel {
        nodes: [Dd::ZERO; NODES],
        weights: [Dd::ZERO; NODES],
        running: Vec::new(),
        last: [[Dd::ZERO; NODES]; LAST],
        between: [Dd::ZERO; NODES],
    };
    for (j, place) in places.iter_mut().enumerate() {
        let mut x = Dd::new(-crate::num::trig::sin_cos_degrees(180.0 * (j as f64 + 0.75) / (n + 0.5)).1.hi);
        let mut slope = Dd::ONE;
        for _ in 0..8 {
            let p = legendre(x);
            slope = Dd::new(n) * (x * p[NODES] - p[NODES - 1]) / (x * x - Dd::ONE);
            x = x - p[NODES] / slope;
        }
        *place = x;
        panel.nodes[j] = (x + Dd::ONE) * half;
        panel.weights[j] = Dd::ONE / ((Dd::ONE - x * x) * slope * slope);
        // 1 over the product of the distances from the other nodes is in proportion to 1 over the slope of the polynomial.
        panel.between[j] = Dd::ONE / slope;
    }
    let values = places.map(legendre);
    for (row, m) in panel.last.iter_mut().zip(NODES - LAST..) {
        for (k, x) in row.iter_mut().enumerate() {
            *x = Dd::new(2.0 * m as f64 + 1.0) * panel.weights[k] * values[k][m];
        }
    }
    for at in &values {
        for (k, other) in values.iter().enumerate() {
            // w_k sum over m of (2m + 1) P_m(x_k) int P_m, with int P_m = (P_(m+1) - P_(m-1)) / (2m + 1); half for the panel.
            let mut sum = at[1] + Dd::ONE;
            for m in 1..NODES {
                sum = sum + other[m] * (at[m + 1] - at[m - 1]);
            }
            panel.running.push(panel.weights[k] * sum * half);
        }
    }
    panel
});

/// The nodes of a panel, as shares of it, ascending.
pub fn nodes() -> &'static [Dd; NODES] {
    &PANEL.nodes
}

/// The mean over a panel of what has these values at its nodes.
pub fn mean<T: Real>(values: &[T]) -> T {
    values.iter().zip(&PANEL.weights).fold(T::zero(), |sum, (v, w)| sum + *v * T::constant(*w))
}

/// The value at this share of a panel of the polynomial that has these values at its nodes.
///
/// Source: Berrut & Trefethen, *Barycentric Lagrange interpolation*, SIAM Review 46 (2004).
pub fn at<T: Real>(values: &[T], share: T) -> T {
    let (mut above, mut below) = (T::zero(), T::zero());
    for ((value, node), weight) in values.iter().zip(&PANEL.nodes).zip(&PANEL.between) {
        let apart = share - T::constant(*node);
        if apart.is_zero() {
            return *value;
        }
        let part = T::constant(*weight) / apart;
        (above, below) = (above + part * *value, below + part);
    }
    above / below
}

/// Are the last Legendre coefficients of what has these values at the nodes of a panel below this share of its mean magnitude, or
/// rounding?
pub fn smooth<T: Real>(values: &[T], share: f64) -> bool {
    smooth_beside(values, share, 0.0)
}

/// The same where the values are added to something of this size: what is small beside it need not be smooth.
pub fn smooth_beside<T: Real>(values: &[T], share: f64, beside: f64) -> bool {
    let mean: f64 = values.iter().zip(&PANEL.weights).map(|(v, w)| v.size() * w.hi).sum();
    let size = mean + beside;
    let of = |row: &[Dd; NODES]| {
        values.iter().zip(row).fold(T::zero(), |sum, (v, r)| sum + *v * T::constant(*r)).size()
    };
    // NaN is not smooth.
    size.is_finite() && PANEL.last.iter().all(|row| of(row) <= share.max(16.0 * T::SETTLED) * size)
}

/// The integral from the start of a panel of length 1 to each node.
pub fn running<T: Real>(values: &[T]) -> PerNode<T> {
    let row =
        |shares: &[Dd]| values.iter().zip(shares).fold(T::zero(), |sum, (v, w)| sum + *v * T::constant(*w));
    PANEL.running.chunks_exact(NODES).map(row).collect()
}

/// The integral of a function that is smooth within (a, b), to rounding.
///
/// Errors: the function's own, and a quadrature that does not settle after 40 halvings or a few hundred panels.
pub fn integral<T: Real, E: From<Unsettled>>(
    mut f: impl FnMut(T) -> Result<T, E>,
    a: T,
    b: T,
) -> Result<T, E> {
    integral_of_terms(&mut f, (a, b), 0.0)
}

/// The same of a function that is a sum of terms of this magnitude: about a zero of it their rounding is no roughness.
///
/// Errors: those of [`integral`].
pub fn integral_of_terms<T: Real, E: From<Unsettled>>(
    mut f: impl FnMut(T) -> Result<T, E>,
    (a, b): (T, T),
    terms: f64,
) -> Result<T, E> {
    let rounding = 16.0 * T::SETTLED / SMOOTH * terms;
    let whole = panel(&mut f, (a, b), rounding)?;
    let scale = whole.size;
    halves(&mut f, (a, b), rounding, whole, scale, (HALVINGS, &mut { PANELS }))
}

/// One panel.
struct Over<T> {
    integral: T,
    /// Integral of the magnitude.
    size: f64,
    smooth: bool,
}

fn panel<T: Real, E>(
    f: &mut impl FnMut(T) -> Result<T, E>,
    (a, b): (T, T),
    rounding: f64,
) -> Result<Over<T>, E> {
    let width = b - a;
    let mut values = [T::zero(); NODES];
    for (value, x) in values.iter_mut().zip(&PANEL.nodes) {
        *value = f(a + width * T::constant(*x))?;
    }
    let size = values.iter().zip(&PANEL.weights).map(|(v, w)| v.size() * w.hi).sum::<f64>();
    let size = size * width.size();
    Ok(Over { integral: mean(&values) * width, size, smooth: smooth_beside(&values, SMOOTH, rounding) })
}

fn halves<T: Real, E: From<Unsettled>>(
    f: &mut impl FnMut(T) -> Result<T, E>,
    (a, b): (T, T),
    rounding: f64,
    whole: Over<T>,
    scale: f64,
    (left, panels): (u32, &mut u32),
) -> Result<T, E> {
    if whole.smooth {
        return Ok(whole.integral);
    }
    let middle = (a + b).scale2(-1);
    let (first, second) = (panel(f, (a, middle), rounding)?, panel(f, (middle, b), rounding)?);
    let sum = first.integral + second.integral;
    let scale = sized(scale, sum);
    if settled(sum, whole.integral, scale) {
        return Ok(sum);
    }
    if left == 0 || *panels < 2 {
        return Err(Unsettled { value: sum.f64(), gap: (sum - whole.integral).f64().abs() }.into());
    }
    *panels -= 2;
    let first = halves(f, (a, middle), rounding, first, scale, (left - 1, panels))?;
    Ok(first + halves(f, (middle, b), rounding, second, scale, (left - 1, panels))?)
}

/// Do halves and whole say the same, for an integral of this size? Halving goes on for more than 60 bits, in doubles to the rounding of a sum.
pub fn settled<T: Real>(halves: T, whole: T, scale: f64) -> bool {
    whole.is_finite()
        && halves.is_finite()
        && (halves - whole).size() <= SETTLED.max(16.0 * T::SETTLED) * scale
}

/// The size of the integral: that of the first panels which have one.
pub fn sized<T: Real>(scale: f64, sum: T) -> f64 {
    if scale.is_finite() { scale } else { sum.size() }
}

/// How often a panel may be halved.
pub const fn halvings() -> u32 {
    HALVINGS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact_to_thirty_digits() {
        for degree in [0u32, 1, 2, 7, 24, 47] {
            let values: Vec<Dd> = nodes().iter().map(|x| (0..degree).fold(Dd::ONE, |p, _| p * *x)).collect();
            let known = Dd::ONE / Dd::new(f64::from(degree) + 1.0);
            assert!(((mean(&values) - known) / known).hi.abs() < 1e-29, "{degree}");
            if degree < 24 {
                for (x, r) in nodes().iter().zip(running(&values)) {
                    let power = (0..=degree).fold(Dd::ONE, |p, _| p * *x);
                    assert!((r - power * known).hi.abs() < 1e-29, "{degree}");
                }
            }
        }
    }
    #[test]
    fn between_the_nodes_a_polynomial_is_itself() {
        let of = |x: Dd| (0..23).fold(Dd::new(3.0), |p, _| p * x - Dd::new(0.5));
        let values: Vec<Dd> = nodes().iter().map(|x| of(*x)).collect();
        for x in [0.0, 1e-3, 0.4, 0.999, 1.0].map(Dd::new).into_iter().chain([nodes()[5]]) {
            assert!((at(&values, x) - of(x)).hi.abs() < 1e-28, "{x:?}");
        }
    }
    #[test]
    fn a_pole_nearby_is_halved_away() {
        // int_0^1 dx / (x + 1e-6) = ln(1000001), in double-doubles and in doubles.
        let f = |x: Dd| Ok::<_, Unsettled>(Dd::ONE / (x + Dd::new(1e-6)));
        let found = integral(f, Dd::ZERO, Dd::ONE).unwrap();
        assert!((found.hi - 13.815_511_557_963_774).abs() < 1e-14, "{found:?}");
        let found = integral(|x: f64| Ok::<_, Unsettled>(1.0 / (x + 1e-6)), 0.0, 1.0).unwrap();
        assert!((found - 13.815_511_557_963_774).abs() < 1e-13, "{found:?}");
    }
    /// A sum of terms that all but cancel, over a short way about their zero.
    #[test]
    fn rounding_about_a_zero_is_not_halved() {
        let mut calls = 0;
        let f = |x: f64| {
            calls += 1;
            Ok::<_, Unsettled>((1e3 + x) - 1e3)
        };
        integral_of_terms(f, (0.0, 1e-7), 1e3).unwrap();
        assert_eq!(calls, NODES);
    }
    #[test]
    fn what_does_not_settle_says_so() {
        let f = |x: Dd| Ok::<_, Unsettled>(if x.hi < 1.0 / 3.0 { Dd::ZERO } else { Dd::ONE });
        let gap = integral(f, Dd::ZERO, Dd::ONE).unwrap_err();
        assert!(gap.gap > 0.0, "{gap:?}");
    }
}
