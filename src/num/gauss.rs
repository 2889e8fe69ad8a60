//! Gauss-Legendre quadrature in any number type: a panel of 24 nodes, taken as it is where the function is seen to be smooth, else
//! halved until the halves say the same as the whole.
//!
//! `int_a^b f = (b - a) sum w_i f(a + (b - a) x_i)`, exact for polynomials up to degree 2n - 1.
//! Sources: Abramowitz and Stegun, *Handbook of Mathematical Functions*, 25.4.29-30, here on the interval from 0 to 1; Press,
//! Teukolsky, Vetterling, Flannery, *Numerical Recipes*, 3rd ed., 4.6 (nodes by Newton's method), here in double-double.
use crate::num::{Dd, Real, trig};
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
/// Times that a panel may be halved: a singularity 2^-40 of the interval away is still seen.
pub const HALVINGS: u32 = 40;
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

/// A panel from 0 to 1 with its nodes.
#[derive(Debug)]
pub struct Rule {
    /// The nodes, as shares of it, ascending.
    pub nodes: Vec<Dd>,
    /// Of sum 1, > 0.
    weights: Vec<Dd>,
    /// Integral from 0 to node `j` of the polynomial that is 1 at node `k` and 0 at the others, row by row.
    running: Vec<Dd>,
    /// Legendre polynomials at the nodes, node by node.
    legendre: Vec<Vec<Dd>>,
    /// What makes the last Legendre coefficients of the values at the nodes.
    last: [Vec<Dd>; LAST],
    /// Weights of the interpolation between the nodes, in barycentric form.
    between: Vec<Dd>,
}

static SHORT: LazyLock<Rule> = LazyLock::new(|| Rule::new(NODES));

/// A longer panel for numbers of 32 digits that are smooth on a long way and cost much to look at. Where coefficients fall
/// geometrically to a share of 10^-D, a long way takes fewest nodes in panels of D ln 10 of them.
static LONG: LazyLock<Rule> = LazyLock::new(|| Rule::new(40));
/// A panel of which only the end counts, in doubles: there even a rate is exact up to twice its degree. The time is not, and what is
/// published of it has to be.
static ENDING: LazyLock<Rule> = LazyLock::new(|| Rule::new(18));

/// The panel with which numbers of this type are as smooth as they can be told to be on the longest way; the shares below which the
/// last coefficients of a rate are smooth on it, and those of what is summed over its way.
pub fn long<T: Real>() -> (&'static Rule, f64, f64) {
    if T::is_double() { (&SHORT, 1e-12, SMOOTH) } else { (&LONG, 1e-18, SMOOTH) }
}
/// The same of a panel of which only the end counts.
pub fn ending<T: Real>() -> (&'static Rule, f64, f64) {
    if T::is_double() { (&ENDING, 5e-8, 5e-8) } else { long::<T>() }
}

/// Legendre polynomials of degree 0 to `last` at a place from -1 to 1, by the recurrence.
fn polynomials<T: Real>(x: T, last: usize) -> Vec<T> {
    let mut p = vec![T::of(1.0), x];
    for n in 2..=last {
        let m = n as f64;
        p.push((T::of(2.0 * m - 1.0) * x * p[n - 1] - T::of(m - 1.0) * p[n - 2]) / T::of(m));
    }
    p
}

/// The zeros of the polynomial of this degree from -1 to 1, ascending, each with the slope there: Tricomi's estimate, then Newton.
fn zeros(degree: usize) -> impl Iterator<Item = (Dd, Dd)> {
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

/// A panel of [`NODES`] nodes.
pub fn short() -> &'static Rule {
    &SHORT
}

impl Rule {
    /// That of `count` nodes, at least one.
    pub fn new(count: usize) -> Self {
        let mut rule = Self {
            nodes: Vec::new(),
            weights: Vec::new(),
            running: Vec::new(),
            legendre: Vec::new(),
            last: [const { Vec::new() }; LAST],
            between: Vec::new(),
        };
        for (x, slope) in zeros(count) {
            rule.legendre.push(polynomials(x, count + 1));
            rule.nodes.push((x + Dd::ONE).scale2(-1));
            rule.weights.push(Dd::ONE / ((Dd::ONE - x * x) * slope * slope));
            // 1 over the product of the distances from the other nodes is in proportion to 1 over the slope of the polynomial.
            rule.between.push(Dd::ONE / slope);
        }
        for (row, m) in rule.last.iter_mut().zip(count.saturating_sub(LAST)..) {
            let nodes = rule.legendre.iter().zip(&rule.weights);
            row.extend(nodes.map(|(node, weight)| Dd::new(2.0 * m as f64 + 1.0) * *weight * node[m]));
        }
        rule.running = rule.legendre.iter().flat_map(|at| rule.shares(at)).collect();
        rule
    }

    /// Integrals from the start of the panel, to where these are the Legendre polynomials, of the polynomials that are 1 at a node
    /// and 0 at the others: `w sum over m of (2m + 1) P_m(node) int P_m`, with `int P_m = (P_(m+1) - P_(m-1)) / (2m + 1)`; half for
    /// the panel.
    fn shares<T: Real>(&self, at: &[T]) -> PerNode<T> {
        let degrees = 1..self.nodes.len();
        let integrals: PerNode<T> = degrees.map(|m| at[m + 1] - at[m - 1]).collect();
        let of = |(node, weight): (&Vec<Dd>, &Dd)| {
            let terms = node[1..].iter().zip(&integrals).map(|(p, integral)| T::constant(*p) * *integral);
            (T::constant(*weight) * terms.fold(at[1] + T::of(1.0), |sum, term| sum + term)).scale2(-1)
        };
        self.legendre.iter().zip(&self.weights).map(of).collect()
    }

    /// The mean over a panel of what has these values at its nodes.
    pub fn mean<T: Real>(&self, values: &[T]) -> T {
        values.iter().zip(&self.weights).fold(T::zero(), |sum, (v, w)| sum + *v * T::constant(*w))
    }

    /// The value at this share of a panel of the polynomial that has these values at its nodes.
    ///
    /// Source: Berrut & Trefethen, *Barycentric Lagrange interpolation*, SIAM Review 46 (2004).
    pub fn at<T: Real>(&self, values: &[T], share: T) -> T {
        let (mut above, mut below) = (T::zero(), T::zero());
        for ((value, node), weight) in values.iter().zip(&self.nodes).zip(&self.between) {
            let apart = share - T::constant(*node);
            if apart.is_zero() {
                return *value;
            }
            let part = T::constant(*weight) / apart;
            (above, below) = (above + part * *value, below + part);
        }
        above / below
    }

    /// How far the last Legendre coefficients of what has these values at the nodes are above this share of its mean magnitude, as a
    /// multiple of it, where the values are added to something of this size: what is small beside it need not be smooth. Endless for
    /// what is not finite.
    pub fn rough<T: Real>(&self, values: &[T], share: f64, beside: f64) -> f64 {
        let mean: f64 = values.iter().zip(&self.weights).map(|(v, w)| v.size() * w.hi).sum();
        let size = mean + beside;
        let of = |row: &Vec<Dd>| {
            values.iter().zip(row).fold(T::zero(), |sum, (v, r)| sum + *v * T::constant(*r)).size()
        };
        let last = self.last.iter().map(of).fold(0.0, f64::max);
        if !size.is_finite() {
            f64::INFINITY
        } else if last > 0.0 {
            last / (share.max(16.0 * T::SETTLED) * size)
        } else {
            0.0
        }
    }

    /// The integral from the start of a panel of length 1 to each node.
    pub fn running<T: Real>(&self, values: &[T]) -> PerNode<T> {
        let row = |shares: &[Dd]| {
            values.iter().zip(shares).fold(T::zero(), |sum, (v, w)| sum + *v * T::constant(*w))
        };
        self.running.chunks_exact(self.nodes.len()).map(row).collect()
    }

    /// The integral from the start of a panel of length 1 to this share of it of the polynomial that has these values at its nodes.
    pub fn until<T: Real>(&self, values: &[T], share: T) -> T {
        let at = polynomials(share.scale2(1) - T::of(1.0), self.nodes.len());
        let shares = self.shares(&at);
        values.iter().zip(shares).fold(T::zero(), |sum, (v, w)| sum + *v * w)
    }
}

/// One panel.
struct Over<T> {
    integral: T,
    /// Integral of the magnitude.
    size: f64,
    smooth: bool,
}

impl Rule {
    /// The integral of a function that is smooth between these ends, to rounding; of a sum of terms of this magnitude, whose rounding
    /// is no roughness about a zero of it.
    ///
    /// Errors: the function's own, and a quadrature that does not settle after 40 halvings or a few hundred panels.
    pub fn integral<T: Real, E: From<Unsettled>>(
        &self,
        mut f: impl FnMut(T) -> Result<T, E>,
        ends: (T, T),
        terms: f64,
    ) -> Result<T, E> {
        let rounding = 16.0 * T::SETTLED / SMOOTH * terms;
        let whole = self.panel(&mut f, ends, rounding)?;
        let scale = whole.size;
        self.halves(&mut f, ends, rounding, whole, scale, (HALVINGS, &mut { PANELS }))
    }

    fn panel<T: Real, E>(
        &self,
        f: &mut impl FnMut(T) -> Result<T, E>,
        (a, b): (T, T),
        rounding: f64,
    ) -> Result<Over<T>, E> {
        let width = b - a;
        let mut values = vec![T::zero(); self.nodes.len()];
        for (value, x) in values.iter_mut().zip(&self.nodes) {
            *value = f(a + width * T::constant(*x))?;
        }
        let size = values.iter().zip(&self.weights).map(|(v, w)| v.size() * w.hi).sum::<f64>();
        let size = size * width.size();
        Ok(Over {
            integral: self.mean(&values) * width,
            size,
            smooth: self.rough(&values, SMOOTH, rounding) <= 1.0,
        })
    }

    fn halves<T: Real, E: From<Unsettled>>(
        &self,
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
        let (first, second) = (self.panel(f, (a, middle), rounding)?, self.panel(f, (middle, b), rounding)?);
        let sum = first.integral + second.integral;
        let scale = sized(scale, sum);
        if settled(sum, whole.integral, scale) {
            return Ok(sum);
        }
        if left == 0 || *panels < 2 {
            return Err(Unsettled { value: sum.f64(), gap: (sum - whole.integral).f64().abs() }.into());
        }
        *panels -= 2;
        let first = self.halves(f, (a, middle), rounding, first, scale, (left - 1, panels))?;
        Ok(first + self.halves(f, (middle, b), rounding, second, scale, (left - 1, panels))?)
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact_to_thirty_digits() {
        for degree in [0u32, 1, 2, 7, 24, 47] {
            let values: Vec<Dd> =
                short().nodes.iter().map(|x| (0..degree).fold(Dd::ONE, |p, _| p * *x)).collect();
            let known = Dd::ONE / Dd::new(f64::from(degree) + 1.0);
            assert!(((short().mean(&values) - known) / known).hi.abs() < 1e-29, "{degree}");
            if degree < 24 {
                for (x, r) in short().nodes.iter().zip(short().running(&values)) {
                    let power = (0..=degree).fold(Dd::ONE, |p, _| p * *x);
                    assert!((r - power * known).hi.abs() < 1e-29, "{degree}");
                }
            }
        }
    }
    #[test]
    fn a_rule_is_exact_up_to_twice_its_nodes_and_no_further() {
        let mean = |n: usize, degree: usize| {
            let rule = Rule::new(n);
            assert!(rule.nodes.windows(2).all(|w| w[0] < w[1]), "{n}: nodes ascend");
            assert!(rule.weights.iter().all(|w| w.hi > 0.0));
            let values: Vec<Dd> =
                rule.nodes.iter().map(|x| (0..degree).fold(Dd::ONE, |p, _| p * *x)).collect();
            rule.mean(&values) * Dd::new(degree as f64 + 1.0) - Dd::ONE
        };
        for n in [1, 2, 3, 5, 8, 16, 33, 64, 96] {
            for degree in [0, 1, 2, 3, n, 2 * n - 1].into_iter().filter(|degree| *degree < 2 * n) {
                let miss = mean(n, degree);
                assert!(miss.hi.abs() < 1e-29, "{n} points, degree {degree}: {miss:?}");
            }
        }
        assert!(mean(2, 4).hi.abs() > 5e-3);
    }
    #[test]
    fn between_the_nodes_a_polynomial_is_itself() {
        let of = |x: Dd| (0..23).fold(Dd::new(3.0), |p, _| p * x - Dd::new(0.5));
        let values: Vec<Dd> = short().nodes.iter().map(|x| of(*x)).collect();
        for x in [0.0, 1e-3, 0.4, 0.999, 1.0].map(Dd::new).into_iter().chain([short().nodes[5]]) {
            assert!((short().at(&values, x) - of(x)).hi.abs() < 1e-28, "{x:?}");
        }
    }
    #[test]
    fn a_pole_nearby_is_halved_away() {
        // int_0^1 dx / (x + 1e-6) = ln(1000001), in double-doubles and in doubles.
        let f = |x: Dd| Ok::<_, Unsettled>(Dd::ONE / (x + Dd::new(1e-6)));
        let found = short().integral(f, (Dd::ZERO, Dd::ONE), 0.0).unwrap();
        assert!((found.hi - 13.815_511_557_963_774).abs() < 1e-14, "{found:?}");
        let found = short().integral(|x: f64| Ok::<_, Unsettled>(1.0 / (x + 1e-6)), (0.0, 1.0), 0.0).unwrap();
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
        short().integral(f, (0.0, 1e-7), 1e3).unwrap();
        assert_eq!(calls, NODES);
    }
    #[test]
    fn what_does_not_settle_says_so() {
        let f = |x: Dd| Ok::<_, Unsettled>(if x.hi < 1.0 / 3.0 { Dd::ZERO } else { Dd::ONE });
        let gap = short().integral(f, (Dd::ZERO, Dd::ONE), 0.0).unwrap_err();
        assert!(gap.gap > 0.0, "{gap:?}");
    }
}
