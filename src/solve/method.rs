//! The methods that a user can name, and how finely each is set. No mechanics: both roads and the ladder know these words.
use crate::num::U;
use crate::num::ode::{Count, FINEST, Formula, Pace};

worded! {
    /// A method that takes a motion from its start to its ending event: the closed form first, then by the order of the formula; with
    /// its name for `--method`.
    Method {
    /// The closed form, on both roads.
    Closed "closed",
    /// Gauss-Legendre quadrature of the generalised force over displacement, on the road of work and energy.
    Gauss "gauss",
    /// The embedded pair 8(5,3) of Dormand and Prince in time, on the road of the equations of motion.
    Dop853 "dop853",
    /// The embedded pair 5(4) of Dormand and Prince in time, on the same road.
    Dopri5 "dopri5",
    /// The classical Runge-Kutta formula with a fixed time step, on the same road.
    Rk4 "rk4",
    /// Velocity Verlet with a fixed time step, on the same road.
    Verlet "verlet",
    /// Semi-implicit Euler with a fixed time step, on the same road.
    Euler "euler",
}}

/// What sets how finely a method works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Knob {
    /// Nothing: it is exact but for rounding.
    None,
    /// The number of points.
    Points,
    /// The relative error allowed in a step.
    Tolerance,
    /// The time step.
    Step,
}

/// The two roads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// The equations of motion.
    Motion,
    /// Work and energy.
    Energy,
}

impl Method {
    /// What sets it.
    pub const fn knob(self) -> Knob {
        match self {
            Self::Closed => Knob::None,
            Self::Gauss => Knob::Points,
            Self::Dopri5 | Self::Dop853 => Knob::Tolerance,
            Self::Euler | Self::Verlet | Self::Rk4 => Knob::Step,
        }
    }
    /// The road on which it goes; the closed form goes on both.
    pub const fn way(self) -> Option<Way> {
        match self {
            Self::Closed => None,
            Self::Gauss => Some(Way::Energy),
            _ => Some(Way::Motion),
        }
    }
    /// The formula of its steps, if it steps.
    pub const fn formula(self) -> Option<Formula> {
        match self {
            Self::Closed | Self::Gauss => None,
            Self::Dopri5 => Some(Formula::Dopri5),
            Self::Dop853 => Some(Formula::Dop853),
            Self::Euler => Some(Formula::Euler),
            Self::Verlet => Some(Formula::Verlet),
            Self::Rk4 => Some(Formula::Rk4),
        }
    }
}

/// A method with its setting: one rung of the ladder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rung {
    /// The closed form in double-doubles: right to the last bit of a double.
    Closed,
    /// The closed form in doubles: cheaper, and as wrong as the condition of the answer makes their rounding.
    Doubles,
    /// This many points.
    Gauss(usize),
    /// Panels of points that are halved until nothing changes but rounding.
    Settled,
    /// Steps as long as this relative error of a step allows; the first try has this share of its usual length.
    Adaptive(Method, f64, f64),
    /// Steps of this length, s.
    Fixed(Method, f64),
}

/// The time step that is taken if none is given, s.
pub const USUAL_STEP_S: f64 = 1e-3;
/// The points that are taken if no tolerance is given.
pub const USUAL_POINTS: usize = 24;

/// By how much the error falls when the step is divided by this.
fn fall(order: i32, by: u8) -> f64 {
    (0..order).fold(1.0, |fall, _| f64::from(by) * fall)
}

impl Rung {
    /// The method.
    pub const fn method(self) -> Method {
        match self {
            Self::Closed | Self::Doubles => Method::Closed,
            Self::Gauss(_) | Self::Settled => Method::Gauss,
            Self::Adaptive(m, ..) | Self::Fixed(m, _) => m,
        }
    }
    /// The same method set finer by a whole number, so that the difference of both tells the error of this one: a step divided
    /// by it, a tolerance divided by its power of the order (which divides the steps, the first one too), more points. What is
    /// exact is the same.
    pub fn finer(self, by: u8) -> Self {
        match self {
            Self::Closed | Self::Doubles | Self::Settled => self,
            Self::Gauss(n) => Self::Gauss(n + usize::from(by - 1) * n.div_ceil(3)),
            Self::Adaptive(m, rtol, share) => {
                let fall = m.formula().map_or(1.0, |f| fall(f.order(), by));
                Self::Adaptive(m, (rtol / fall).max(FINEST), share / f64::from(by))
            }
            Self::Fixed(m, h) => Self::Fixed(m, h / f64::from(by)),
        }
    }
    /// What the difference to the finer rung is multiplied with: of a step divided by n the error falls by n^order.
    pub fn extrapolation(self, by: u8) -> f64 {
        match (self, self.method().formula()) {
            (Self::Fixed(..), Some(formula)) => {
                let fall = fall(formula.order(), by);
                fall / (fall - 1.0)
            }
            _ => 1.0,
        }
    }
    /// The pace of its steps; the first try of an adaptive one is given.
    pub fn pace(self, first: f64) -> Pace {
        match self {
            Self::Fixed(_, h) => Pace::Fixed(h),
            Self::Adaptive(_, rtol, share) => Pace::Adaptive { rtol, first: share * first },
            Self::Closed | Self::Doubles | Self::Gauss(_) | Self::Settled => {
                Pace::Adaptive { rtol: FINEST, first }
            }
        }
    }
    /// The relative error that was asked for, if the method has such a knob.
    pub const fn requested(self) -> Option<f64> {
        match self {
            Self::Adaptive(_, rtol, _) => Some(rtol),
            _ => None,
        }
    }
}

/// Relative error that this much work may leave in a state that no finer setting shows, beside the condition of the answer:
/// rounding, and at tolerances near rounding the estimates of the steps, which then all err to one side.
pub fn rounding(rung: Rung, count: Count) -> f64 {
    let steps = count.steps as f64;
    U * (16.0 + if matches!(rung, Rung::Adaptive(..)) { steps } else { steps.sqrt() })
}
