//! Initial-value problems `y' = f(x, y)` of a few unknowns, step by step, each event landed on by a step of its own.
//!
//! Formulas: semi-implicit Euler and velocity Verlet (for `q'' = a(q)` with `y = (q, u)`), the classical Runge-Kutta formula, and
//! two embedded pairs that choose their steps, 5(4) and 8(5,3). No dense output: an interpolant is less exact than the steps
//! beside it. A step that passes an event is made anew, shorter, until it ends there, and the event is judged by its
//! residual. Everything is `f64` on the stack; each call of `f` is counted. Sums over steps keep what rounding drops.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (Springer 1993), sections II.1
//! (formulas), II.4 (step control), II.5 (the pairs); Hairer, Lubich, Wanner, *Geometric Numerical Integration*, 2nd edition
//! (2006), section I.1 (semi-implicit Euler and Verlet).
pub mod tableau;

use crate::num::ode::tableau::Tableau;
use crate::num::{U, trig};
use std::ops::AddAssign;

/// How one step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formula {
    /// Semi-implicit Euler, order 1: velocities first, then places with the new velocities.
    Euler,
    /// Velocity Verlet, order 2.
    Verlet,
    /// The classical Runge-Kutta formula, order 4.
    Rk4,
    /// Dormand and Prince, order 5 with an error estimate of order 4.
    Dopri5,
    /// Dormand and Prince, order 8 with error estimates of orders 5 and 3.
    Dop853,
}

impl Formula {
    /// Order of the result.
    pub const fn order(self) -> i32 {
        match self {
            Self::Euler => 1,
            Self::Verlet => 2,
            Self::Rk4 => 4,
            Self::Dopri5 => 5,
            Self::Dop853 => 8,
        }
    }
}

/// How long the steps are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// Always this, save the last before an event.
    Fixed(f64),
    /// As long as the estimated error of a step stays within `rtol` of the largest value that each unknown has had.
    Adaptive {
        /// Relative error allowed in a step; not less than [`FINEST`].
        rtol: f64,
        /// Length of the first try.
        first: f64,
    },
}

/// The finest tolerance of a step: below it the estimate is rounding.
pub const FINEST: f64 = 2e-15;
/// After so many steps a run is given up.
pub const MOST_STEPS: u64 = 20_000_000;
/// An event is reached when its residual is this small, as a share of its scale.
const LANDED: f64 = U;
/// A residual above this share of the scale, when no shorter step changes it any more, is no landing.
const NO_LANDING: f64 = 4096.0 * U;
/// The turning point counts as the event if it comes this near, as a share of the event's scale: at a turning point a place
/// is a double root, and half of the digits of the speed say nothing.
const TOUCH: f64 = 1e-9;
const MOST_TRIES: u32 = 1200;
const MOST_LANDINGS: u32 = 200;

/// Why a run has no result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Trouble {
    /// The motion turned before the event: what was still missing, in the measure of the event.
    Missed {
        /// How far the event was still away.
        by: f64,
        /// Where: the independent variable.
        at: f64,
    },
    /// No step length ends on the event.
    NoConvergence {
        /// What remained of the event.
        residual: f64,
        /// What would have been accepted.
        accepted: f64,
    },
    /// The step became too small to move on.
    StepUnderflow {
        /// Where.
        at: f64,
        /// The step.
        step: f64,
    },
    /// Too many steps.
    TooManySteps {
        /// How many were made.
        steps: u64,
        /// Where they led.
        at: f64,
    },
    /// Far more than the time of the motion has gone by, and the event has not come.
    Overdue {
        /// Where: the independent variable.
        at: f64,
    },
    /// So many steps of this length would be needed that none was made.
    StepTooShort {
        /// The step.
        step: f64,
        /// How many it would take, roughly.
        steps: f64,
    },
    /// A value became NaN or infinite.
    NotFinite {
        /// Where.
        at: f64,
    },
}

/// What a run has cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Count {
    /// Calls of `f`.
    pub evaluations: u64,
    /// Steps made.
    pub steps: u64,
    /// Steps tried and refused by the step control.
    pub refused: u64,
}

impl AddAssign for Count {
    fn add_assign(&mut self, more: Self) {
        self.evaluations += more.evaluations;
        self.steps += more.steps;
        self.refused += more.refused;
    }
}

/// What an event or a turn of the motion is told by, from the independent variable and the unknowns.
type Watched<'w, const N: usize> = &'w dyn Fn(f64, &[f64; N]) -> f64;

/// A sum that keeps what rounding drops.
#[derive(Debug, Clone, Copy)]
struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    fn new(value: f64) -> Self {
        Self { value, lost: 0.0 }
    }
    fn plus(self, more: f64) -> Self {
        let d = more + self.lost;
        let value = self.value + d;
        let t = value - self.value;
        Self { value, lost: (self.value - (value - t)) + (d - t) }
    }
}

/// A solution on its way: where it is, and how it goes on.
///
/// ```
/// use mechanics::num::ode::{Formula, Pace, Run};
/// // q'' = -q from q = 0, u = 1 to q = 1/2: the time is pi/6.
/// let field = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
/// let pace = Pace::Adaptive { rtol: 1e-13, first: 0.1 };
/// let mut run = Run::new(Formula::Dop853, field, 0.0, [0.0, 1.0], pace);
/// run.until(&|_, y| y[0] - 0.5, 0.5, &|_, y| -y[1]).unwrap();
/// assert!((run.x() - std::f64::consts::FRAC_PI_6).abs() < 1e-13);
/// ```
#[derive(Debug, Clone)]
pub struct Run<const N: usize, F> {
    formula: Formula,
    field: F,
    pace: Pace,
    x: Sum,
    y: [Sum; N],
    /// `f` at the place reached.
    slope: [f64; N],
    /// Length of the next step.
    next: f64,
    /// Largest magnitude of each unknown so far.
    peak: [f64; N],
    stages: [[f64; N]; 12],
    count: Count,
    /// An event that has not come by here does not come.
    latest: f64,
}

/// A step that may be made: its length, the change of the unknowns and, where the estimate needed it, the slope at its end.
struct Proposal<const N: usize> {
    h: f64,
    change: [f64; N],
    end: Option<[f64; N]>,
}

fn axpy<const N: usize>(y: &mut [f64; N], a: f64, x: &[f64; N]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

impl<const N: usize, F: FnMut(f64, &[f64; N]) -> [f64; N]> Run<N, F> {
    /// Starts at `(x, y)`; one call of `field`. For [`Formula::Euler`] and [`Formula::Verlet`] the first half of `y` are places,
    /// the second their velocities, and the slopes of the velocities depend on places alone.
    pub fn new(formula: Formula, field: F, x: f64, y: [f64; N], pace: Pace) -> Self {
        let next = match pace {
            Pace::Fixed(h) => h,
            Pace::Adaptive { first, .. } => first,
        };
        let mut run = Self {
            formula,
            field,
            pace,
            x: Sum::new(x),
            y: y.map(Sum::new),
            slope: [0.0; N],
            next,
            peak: y.map(f64::abs),
            stages: [[0.0; N]; 12],
            count: Count::default(),
            latest: f64::INFINITY,
        };
        run.slope = run.evaluate(x, &y);
        run
    }

    /// No event is awaited beyond this value of the independent variable.
    pub fn give_up_at(&mut self, latest: f64) {
        self.latest = latest;
    }

    /// Another law holds from here on: asks the field anew.
    pub fn refresh(&mut self) {
        let place = self.y();
        self.slope = self.evaluate(self.x.value, &place);
    }

    /// The independent variable.
    pub fn x(&self) -> f64 {
        self.x.value
    }
    /// The unknowns.
    pub fn y(&self) -> [f64; N] {
        self.y.map(|s| s.value)
    }
    /// What it has cost so far.
    pub fn count(&self) -> Count {
        self.count
    }

    fn evaluate(&mut self, x: f64, y: &[f64; N]) -> [f64; N] {
        self.count.evaluations += 1;
        (self.field)(x, y)
    }

    fn after(&self, change: &[f64; N]) -> [f64; N] {
        let mut y = [0.0; N];
        for (i, y) in y.iter_mut().enumerate() {
            *y = self.y[i].plus(change[i]).value;
        }
        y
    }

    /// Change of the unknowns over a step of this length; the stages stay for [`Run::strain`] and [`Run::commit`].
    fn change(&mut self, h: f64) -> [f64; N] {
        let half = N / 2;
        let mut change = [0.0; N];
        match self.formula {
            Formula::Euler => {
                for i in 0..half {
                    change[half + i] = h * self.slope[half + i];
                    change[i] = h * (self.y[half + i].value + change[half + i]);
                }
            }
            Formula::Verlet => {
                for (i, c) in change.iter_mut().enumerate().take(half) {
                    *c = h * (self.y[half + i].value + 0.5 * h * self.slope[half + i]);
                }
                let end = self.after(&change);
                let there = self.evaluate(self.x.value + h, &end);
                for i in half..N {
                    change[i] = 0.5 * h * (self.slope[i] + there[i]);
                }
                self.stages[0] = there;
            }
            Formula::Rk4 => change = self.runge_kutta(&tableau::RK4, h),
            Formula::Dopri5 => change = self.runge_kutta(&tableau::DOPRI5, h),
            Formula::Dop853 => change = self.runge_kutta(&tableau::DOP853, h),
        }
        change
    }

    fn runge_kutta<const S: usize>(&mut self, t: &Tableau<S>, h: f64) -> [f64; N] {
        let y = self.y();
        self.stages[0] = self.slope;
        for i in 1..S {
            let mut place = y;
            for (a, stage) in t.a[i].iter().zip(&self.stages).filter(|(a, _)| **a != 0.0) {
                axpy(&mut place, h * a, stage);
            }
            self.stages[i] = self.evaluate(self.x.value + t.c[i] * h, &place);
        }
        let mut change = [0.0; N];
        for i in 0..S {
            if t.b[i] != 0.0 {
                axpy(&mut change, h * t.b[i], &self.stages[i]);
            }
        }
        change
    }

    /// `f` at the end of the step whose stages stand.
    fn end_slope(&mut self, h: f64, change: &[f64; N]) -> [f64; N] {
        let end = self.after(change);
        if self.formula == Formula::Verlet {
            let mut slope = self.stages[0];
            let half = N / 2;
            slope[..half].copy_from_slice(&end[half..]);
            return slope;
        }
        self.evaluate(self.x.value + h, &end)
    }

    /// Estimated error of the step as a share of what is allowed; not finite where the step leads nowhere.
    fn strain(&self, h: f64, change: &[f64; N], end_slope: &[f64; N], rtol: f64) -> f64 {
        let share = |error: f64, i: usize| {
            let scale = rtol * self.peak[i].max((self.y[i].value + change[i]).abs());
            if error == 0.0 { 0.0 } else { error / scale }
        };
        let weighed = |weights: &[f64], i: usize| {
            weights.iter().zip(&self.stages).map(|(w, k)| w * k[i]).fold(0.0, |sum, x| sum + x)
        };
        match self.formula {
            Formula::Dop853 => {
                let (mut five, mut three) = (0.0, 0.0);
                for (i, c) in change.iter().enumerate() {
                    let e5 = share(h * weighed(&tableau::DOP853_ERROR5, i), i);
                    let e3 = share(c - h * weighed(&tableau::DOP853_ORDER3, i), i);
                    five += e5 * e5;
                    three += e3 * e3;
                }
                if five == 0.0 { 0.0 } else { five / ((five + 0.01 * three) * N as f64).sqrt() }
            }
            _ => {
                let mut sum = 0.0;
                for (i, end) in end_slope.iter().enumerate() {
                    let e = weighed(&tableau::DOPRI5_ERROR[..6], i) + tableau::DOPRI5_ERROR[6] * end;
                    let e = share(h * e, i);
                    sum += e * e;
                }
                (sum / N as f64).sqrt()
            }
        }
    }

    /// The next step, as long as the pace has it.
    fn propose(&mut self) -> Result<Proposal<N>, Trouble> {
        if self.count.steps >= MOST_STEPS {
            return Err(Trouble::TooManySteps { steps: self.count.steps, at: self.x.value });
        }
        if self.x.value > self.latest {
            return Err(Trouble::Overdue { at: self.x.value });
        }
        let mut h = self.next;
        let Pace::Adaptive { rtol, .. } = self.pace else {
            let change = self.change(h);
            return Ok(Proposal { h, change, end: None });
        };
        let (order, rtol) = (f64::from(self.formula.order()), rtol.max(FINEST));
        let mut refused = false;
        for _ in 0..MOST_TRIES {
            let moved = self.x.plus(h);
            if moved.value - self.x.value == 0.0 && moved.lost - self.x.lost == 0.0 {
                break;
            }
            let change = self.change(h);
            // The 8(5,3) estimate needs no slope at the end: it is not asked for before the step is good.
            let end = if self.formula == Formula::Dop853 { None } else { Some(self.end_slope(h, &change)) };
            let strain = self.strain(h, &change, &end.unwrap_or([0.0; N]), rtol);
            if strain <= 1.0 {
                let grow = if strain > 0.0 { 0.9 / trig::power(strain, 1.0 / order) } else { 5.0 };
                let grow = grow.min(if refused { 1.0 } else { 5.0 });
                self.next = h * grow;
                return Ok(Proposal { h, change, end });
            }
            let shrink = 0.9 / trig::power(strain, 1.0 / order);
            h *= if shrink > 0.2 { shrink } else { 0.2 };
            self.next = h;
            refused = true;
            self.count.refused += 1;
        }
        Err(Trouble::StepUnderflow { at: self.x.value, step: h })
    }

    fn commit(&mut self, h: f64, change: &[f64; N], end: Option<[f64; N]>) {
        let slope = end.unwrap_or_else(|| self.end_slope(h, change));
        for (i, y) in self.y.iter_mut().enumerate() {
            *y = y.plus(change[i]);
            self.peak[i] = self.peak[i].max(y.value.abs());
        }
        self.x = self.x.plus(h);
        self.slope = slope;
        self.count.steps += 1;
    }

    /// Goes to this value of the independent variable, which lies ahead. Errors: [`Trouble`].
    pub fn to(&mut self, x: f64) -> Result<(), Trouble> {
        loop {
            let left = (x - self.x.value) - self.x.lost;
            if left <= 0.0 {
                break;
            }
            // No sliver of a step at the end.
            let closes = left <= self.next * (1.0 + 1e-9);
            let kept = self.next;
            if closes {
                self.next = left;
            }
            let Proposal { h, change, end } = self.propose()?;
            // The step control may have shortened it.
            let last = closes && h >= left;
            self.commit(h, &change, end);
            if !self.y.iter().all(|y| y.value.is_finite()) {
                return Err(Trouble::NotFinite { at: self.x.value });
            }
            if last {
                self.next = kept;
                self.x = Sum::new(x);
                break;
            }
        }
        Ok(())
    }

    /// Goes on until `event`, negative before, is 0, and ends a step there. `scale` is the size of the terms of `event`;
    /// `guard` turns positive where the motion turns, and the event must come before.
    ///
    /// Errors: [`Trouble`]. At a turning point within a billionth of the event the turning point counts as the event.
    pub fn until(&mut self, event: Watched<N>, scale: f64, guard: Watched<N>) -> Result<(), Trouble> {
        self.seek(event, scale, guard, false)
    }

    /// [`Run::until`] the event comes next: one that holds where the run stands (rest, at a start from rest) does not count.
    pub fn until_next(&mut self, event: Watched<N>, scale: f64, guard: Watched<N>) -> Result<(), Trouble> {
        self.seek(event, scale, guard, true)
    }

    fn seek(
        &mut self,
        event: Watched<N>,
        scale: f64,
        guard: Watched<N>,
        mut leaving: bool,
    ) -> Result<(), Trouble> {
        loop {
            let mut before = event(self.x.value, &self.y());
            if before >= 0.0 && leaving {
                before = 0.0;
            } else if before >= 0.0 {
                return Ok(());
            }
            leaving = false;
            let Proposal { h, change, end } = self.propose()?;
            let (x, y) = (self.x.value + h, self.after(&change));
            let after = event(x, &y);
            if !after.is_finite() || !y.iter().all(|y| y.is_finite()) {
                return Err(Trouble::NotFinite { at: x });
            }
            if after >= 0.0 {
                return self.land(h, event, scale, (before, after));
            }
            if guard(x, &y) > 0.0 {
                let turned = guard(x, &y);
                let start = guard(self.x.value, &self.y());
                let at = self.shorten(h, guard, turned.abs().max(start.abs()), (start.min(0.0), turned))?;
                let change = self.change(at);
                let there = event(self.x.value + at, &self.after(&change));
                if there >= 0.0 {
                    return self.land(at, event, scale, (before, there));
                }
                self.commit(at, &change, None);
                if -there <= TOUCH * scale {
                    return Ok(());
                }
                return Err(Trouble::Missed { by: -there, at: self.x.value });
            }
            self.commit(h, &change, end);
        }
    }

    /// Makes the step that ends on the event, between a step of no length and one of length `h`.
    fn land(&mut self, h: f64, event: Watched<N>, scale: f64, ends: (f64, f64)) -> Result<(), Trouble> {
        let at = self.shorten(h, event, scale, ends)?;
        let change = self.change(at);
        let residual = event(self.x.value + at, &self.after(&change));
        if residual.abs() > NO_LANDING * scale {
            return Err(Trouble::NoConvergence { residual, accepted: NO_LANDING * scale });
        }
        self.commit(at, &change, None);
        Ok(())
    }

    /// Length of the step at whose end `event` vanishes, between a step of no length and one of length `h`; the step is made
    /// anew for each try. Inverse quadratic interpolation where it is safe, else halving: T. R. Chandrupatla, *A new hybrid
    /// quadratic/bisection algorithm for finding the zero of a nonlinear function without using derivatives*, Adv. Eng.
    /// Software 28 (1997) 145-149.
    fn shorten(&mut self, h: f64, event: Watched<N>, scale: f64, ends: (f64, f64)) -> Result<f64, Trouble> {
        let at = |run: &mut Self, c: f64| {
            let change = run.change(c);
            let value = event(run.x.value + c, &run.after(&change));
            if value.is_finite() { Ok(value) } else { Err(Trouble::NotFinite { at: run.x.value + c }) }
        };
        let ((mut x1, mut f1), (mut x2, mut f2)) = ((h, ends.1), (0.0, ends.0));
        // It stood on the event and left it: somewhere between it has not come yet.
        let mut tries = 0;
        while f2 >= 0.0 && tries < MOST_LANDINGS {
            x2 = if x2 > 0.0 { 0.5 * x2 } else { 0.5 * h };
            f2 = at(self, x2)?;
            tries += 1;
        }
        let (mut x3, mut f3);
        let mut t = f1 / (f1 - f2);
        // Change of the event over a length as long as the step: the length has an ulp, and the event is told no better.
        let mut rate = 0.0;
        let better = |a: (f64, f64), b: (f64, f64)| if a.1.abs() <= b.1.abs() { a } else { b };
        let mut best = (x1, f1);
        if best.1.abs() <= LANDED * scale {
            return Ok(best.0);
        }
        for _ in 0..MOST_LANDINGS {
            let x = x1 + t * (x2 - x1);
            let f = at(self, x)?;
            if (x - x1).abs() > 0.0 {
                rate = (x * (f - f1) / (x - x1)).abs();
            }
            if (f >= 0.0) == (f1 >= 0.0) {
                (x3, f3) = (x1, f1);
            } else {
                (x3, f3) = (x2, f2);
                (x2, f2) = (x1, f1);
            }
            (x1, f1) = (x, f);
            best = better((x1, f1), (x2, f2));
            if best.0 <= 0.0 {
                best = (x1, f1);
            }
            if best.1.abs() <= LANDED * (scale + rate) || (x2 - x1).abs() <= 2.0 * U * x1.max(x2) {
                break;
            }
            let xi = (x1 - x2) / (x3 - x2);
            let phi = (f1 - f2) / (f3 - f2);
            let least = U * best.0 / (x2 - x1).abs();
            t = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
                f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
            } else {
                0.5
            };
            t = if t.is_nan() { 0.5 } else { t.clamp(least.min(0.5), (1.0 - least).max(0.5)) };
        }
        Ok(best.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Formula; 5] =
        [Formula::Euler, Formula::Verlet, Formula::Rk4, Formula::Dopri5, Formula::Dop853];

    fn spring(_: f64, y: &[f64; 2]) -> [f64; 2] {
        [y[1], -y[0]]
    }

    /// Sum of products over the conditions that a tableau must meet for quadrature and for each stage.
    fn conditions<const S: usize>(t: &Tableau<S>, order: i32) {
        for i in 0..S {
            let row: f64 = (0..i).map(|j| t.a[i][j]).sum();
            assert!((row - t.c[i]).abs() < 1e-14, "stage {i}: {row} against {}", t.c[i]);
            assert_eq!(t.a[i].len(), i, "stage {i} is explicit");
        }
        for power in 0..order {
            let mut moment = 0.0;
            for i in 0..S {
                let mut term = t.b[i];
                for _ in 0..power {
                    term *= t.c[i];
                }
                moment += term;
            }
            let exact = 1.0 / f64::from(power + 1);
            assert!((moment - exact).abs() < 2e-15, "moment {power}: {moment} against {exact}");
        }
        // sum b_i a_ij c_j = 1/6 and sum b_i c_i a_ij c_j = 1/8, sum b_i a_ij c_j^2 = 1/12, sum b_i a_ij a_jk c_k = 1/24.
        let inner = |i: usize, f: &dyn Fn(usize) -> f64| (0..i).map(|j| t.a[i][j] * f(j)).sum::<f64>();
        let (mut third, mut fourth) = (0.0, [0.0; 3]);
        for i in 0..S {
            let ac = inner(i, &|j| t.c[j]);
            third += t.b[i] * ac;
            fourth[0] += t.b[i] * t.c[i] * ac;
            fourth[1] += t.b[i] * inner(i, &|j| t.c[j] * t.c[j]);
            fourth[2] += t.b[i] * inner(i, &|j| inner(j, &|k| t.c[k]));
        }
        for (sum, exact) in
            [(third, 6.0), (fourth[0], 8.0), (fourth[1], 12.0), (fourth[2], 24.0)].map(|(s, e)| (s, 1.0 / e))
        {
            assert!((sum - exact).abs() < 2e-15, "{sum} against {exact}");
        }
    }

    #[test]
    fn the_coefficients_meet_their_order_conditions() {
        conditions(&tableau::RK4, 4);
        conditions(&tableau::DOPRI5, 5);
        conditions(&tableau::DOP853, 8);
        // The error weights vanish on what both orders integrate.
        for power in 0..4 {
            let c = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0f64];
            let moment: f64 = c
                .iter()
                .zip(tableau::DOPRI5_ERROR)
                .map(|(c, e)| e * (0..power).fold(1.0, |p, _| p * c))
                .sum();
            assert!(moment.abs() < 1e-15, "5(4), moment {power}: {moment}");
        }
        for (power, orders) in [(0, 2), (1, 2), (2, 2), (3, 1), (4, 1)] {
            let c = tableau::DOP853.c;
            let moment = |w: &[f64; 12]| -> f64 {
                c.iter().zip(w).map(|(c, e)| e * (0..power).fold(1.0, |p, _| p * c)).sum()
            };
            assert!(moment(&tableau::DOP853_ERROR5).abs() < 1e-14, "8(5), moment {power}");
            let exact = 1.0 / f64::from(power + 1);
            assert!(orders < 2 || (moment(&tableau::DOP853_ORDER3) - exact).abs() < 1e-15, "8(3), {power}");
        }
    }

    /// Error of a nonlinear problem with known solution: y = (ln(1+x), 1/(1+x)), q'' = -exp(-2q).
    fn error_at_fixed_step(formula: Formula, steps: u32) -> f64 {
        let h = 1.0 / f64::from(steps);
        let field = |_: f64, y: &[f64; 2]| [y[1], -1.0 / trig::power(std::f64::consts::E, 2.0 * y[0])];
        let mut run = Run::new(formula, field, 0.0, [0.0, 1.0], Pace::Fixed(h));
        run.to(1.0).unwrap();
        (run.y()[0] - std::f64::consts::LN_2).abs()
    }

    #[test]
    fn each_formula_has_its_order() {
        for (formula, steps) in ALL.into_iter().zip([64, 32, 8, 8, 2]) {
            let (coarse, fine) =
                (error_at_fixed_step(formula, steps), error_at_fixed_step(formula, 4 * steps));
            let mut slope = 0.0;
            let mut ratio = coarse / fine;
            while ratio > 1.0 {
                ratio /= 1.1;
                slope += 1.1f64.log2() / 2.0;
            }
            let order = f64::from(formula.order());
            assert!((slope - order).abs() < 0.15 * order + 0.1, "{formula:?}: slope {slope}");
        }
    }

    #[test]
    fn steps_end_on_the_event_and_its_residual_is_rounding() {
        for formula in ALL {
            for target in [1e-9, 0.3, 0.999, 1.0 - 1e-12] {
                let pace = match formula {
                    Formula::Dopri5 | Formula::Dop853 => Pace::Adaptive { rtol: 1e-12, first: 0.1 },
                    _ => Pace::Fixed(0.01),
                };
                // From rest at -1: the place goes as -cos x.
                let mut run = Run::new(formula, spring, 0.0, [-1.0, 0.0], pace);
                run.until(&|_, y| (y[0] + 1.0) - target, 1.0, &|_, y| -y[1]).unwrap();
                let miss = (run.y()[0] + 1.0 - target).abs();
                assert!(miss <= 3.0 * U, "{formula:?}: {miss}");
                assert!(miss <= 4e-16, "{formula:?} {target}: {miss}");
            }
        }
    }

    #[test]
    fn tolerance_governs_the_error_of_a_whole_swing() {
        for formula in [Formula::Dopri5, Formula::Dop853] {
            let mut last = f64::INFINITY;
            for rtol in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
                let pace = Pace::Adaptive { rtol, first: 1.0 };
                let mut run = Run::new(formula, spring, 0.0, [-1.0, 0.0], pace);
                // It starts at rest: that event is there already. Go a quarter, then to the next rest.
                run.until(&|_, y| -y[1], 1.0, &|_, _| -1.0).unwrap();
                assert!(run.x() == 0.0);
                let mut whole = run.clone();
                whole.until_next(&|_, y| -y[1], 1.0, &|_, _| -1.0).unwrap();
                assert!((whole.x() - std::f64::consts::PI).abs() < 100.0 * rtol);
                run.until(&|_, y| y[0], 1.0, &|_, y| -y[1]).unwrap();
                let error = (run.x() - std::f64::consts::FRAC_PI_2).abs();
                run.until(&|_, y| -y[1], 1.0, &|_, _| -1.0).unwrap();
                let whole = (run.x() - std::f64::consts::PI).abs();
                assert!(error < 50.0 * rtol && whole < 100.0 * rtol, "{formula:?} {rtol}: {error} {whole}");
                assert!(whole < last);
                last = whole.max(1e-15);
            }
        }
    }

    #[test]
    fn over_displacement_the_speed_comes_without_an_event() {
        // d(u^2/2)/dq = -q: from u = 1 at q = 0 to q = 0.8, u = 0.6; f depends on the independent variable.
        let mut run = Run::new(
            Formula::Dop853,
            |q: f64, _: &[f64; 1]| [-q],
            0.0,
            [0.5],
            Pace::Adaptive { rtol: 1e-14, first: 0.1 },
        );
        run.to(0.8).unwrap();
        assert!(((2.0 * run.y()[0]).sqrt() - 0.6).abs() < 1e-15 && (run.x() - 0.8).abs() < 1e-17);
    }

    #[test]
    fn a_missed_event_is_refused_with_its_numbers() {
        for formula in ALL {
            let pace = match formula {
                Formula::Dopri5 | Formula::Dop853 => Pace::Adaptive { rtol: 1e-9, first: 0.1 },
                _ => Pace::Fixed(0.01),
            };
            let mut run = Run::new(formula, spring, 0.0, [-1.0, 0.0], pace);
            let trouble = run.until(&|_, y| y[0] - 1.25, 2.25, &|_, y| -y[1]).unwrap_err();
            let Trouble::Missed { by, at } = trouble else { panic!("{formula:?}: {trouble:?}") };
            assert!(
                (by - 0.25).abs() < 0.02 && (at - std::f64::consts::PI).abs() < 0.02,
                "{formula:?}: {trouble:?}"
            );
        }
    }

    #[test]
    fn what_blows_up_is_refused() {
        // y' = y^2 from 1 reaches infinity at x = 1.
        let blow = |_: f64, y: &[f64; 1]| [y[0] * y[0]];
        let pace = Pace::Adaptive { rtol: 1e-8, first: 0.1 };
        let trouble = Run::new(Formula::Dop853, blow, 0.0, [1.0], pace).to(2.0).unwrap_err();
        let near = |at: f64| (at - 1.0).abs() < 1e-6;
        assert!(
            matches!(trouble, Trouble::StepUnderflow { at, .. } | Trouble::NotFinite { at } if near(at)),
            "{trouble:?}"
        );
        let trouble = Run::new(Formula::Rk4, blow, 0.0, [1.0], Pace::Fixed(0.01)).to(2.0).unwrap_err();
        assert!(matches!(trouble, Trouble::NotFinite { .. }), "{trouble:?}");
    }

    #[test]
    fn a_million_steps_lose_no_digits() {
        let mut run =
            Run::new(Formula::Verlet, |_, y: &[f64; 2]| [y[1], 0.1], 0.0, [0.0, 0.0], Pace::Fixed(1e-5));
        run.to(10.0).unwrap();
        assert!((run.y()[0] - 5.0).abs() <= 2e-15 && (run.y()[1] - 1.0).abs() <= 3e-16, "{:?}", run.y());
        assert!(run.count().steps == 1_000_000 && run.count().evaluations == 1_000_001);
    }
}
