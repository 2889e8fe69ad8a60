//! How a motion starts and what ends it.
use crate::scene::{Label, Num, Owner, Quantity, Scene, Slope, Tie};
use serde::{Deserialize, Serialize};

/// One coordinate of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coordinate {
    /// Index of the body.
    pub body: usize,
    /// Along its line, or turning.
    pub degree: Degree,
}

impl Coordinate {
    /// What is said of its speed.
    pub const fn speed(self) -> Label {
        let quantity = if matches!(self.degree, Degree::Along) { Quantity::V } else { Quantity::Omega };
        Label { quantity, of: Owner::Body(self.body) }
    }
}

/// Kind of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Degree {
    /// Travel of the mass centre along its line, m.
    Along,
    /// Angle turned, rad.
    Turn,
}

/// What is known of the velocities at the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Start {
    /// Speed along the line (m/s) or spin (rad/s) of one coordinate, positive forward. The ties give the rest; a body that
    /// is thrown with slip has both.
    Speed(Coordinate, Num),
    /// Velocity of one particle of a lamina, m/s, and the spin of the lamina, rad/s, counter-clockwise positive.
    Lamina {
        /// Index of the body.
        body: usize,
        /// Index of the particle.
        particle: usize,
        /// Velocity of that particle along x.
        vx_m_s: Num,
        /// Velocity of that particle along y.
        vy_m_s: Num,
        /// Spin.
        spin_rad_s: Num,
    },
}

/// A belt, the bed of a truck, a lift: it carries the whole scene along a straight line, whatever that takes.
///
/// Ties, joints and ends count places and speeds on it. Speeds at the start and answers are those that are seen from the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Carrier {
    /// Slope of the line, positive up or to the right.
    pub slope: Slope,
    /// Its speed at the start, m/s.
    pub speed_m_s: Num,
    /// Its acceleration, m/s^2.
    pub acceleration_m_s2: Num,
}

/// The event that ends the motion.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub enum End {
    /// No motion: only the instant of the start is asked.
    #[default]
    AtOnce,
    /// When this coordinate has changed by this much (m, or rad), either way unless the scene has a heading.
    Travel(Coordinate, Num),
    /// When this coordinate stands at this value, signed, counted from the start (m).
    Position(Coordinate, Num),
    /// After this time, s.
    Time(Coordinate, Num),
    /// When this coordinate has this speed (m/s or rad/s), a magnitude.
    Speed(Coordinate, Num),
    /// When this coordinate comes to rest.
    TurningPoint(Coordinate),
    /// When a pinned body stands at this angle, degrees, as its pin counts them.
    Angle(Coordinate, Num),
    /// When the contact of this body, thrown with slip, stops slipping.
    Rolling(Coordinate),
    /// When this joint, which can only push, stops pushing.
    Leaves(usize),
    /// No motion: joined bodies at rest in the stable equilibrium toward which they set off, and small oscillations about it.
    Equilibrium,
}

/// A declared direction of motion of the ending coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Heading {
    /// Forward (positive).
    Forward,
    /// Back (negative).
    Back,
}

/// How far the conditions of validity and the extrema (`mu_required`, the least tension of a cord) look. An end event ends the
/// motion; what would come after it counts only where a quantity that is asked looks there ([`Quantity::looks_beyond`]).
///
/// [`Quantity::looks_beyond`]: crate::scene::Quantity::looks_beyond
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Span {
    /// From the start to the end that is asked; to the turning point where the motion turns before it.
    #[default]
    ToEnd,
    /// From the start to the turning point: a quantity of the whole motion is asked.
    ToTurningPoint,
}

impl Span {
    /// How far the questions make it look.
    pub fn of(asked: impl IntoIterator<Item = Quantity>) -> Self {
        if asked.into_iter().any(Quantity::looks_beyond) { Self::ToTurningPoint } else { Self::ToEnd }
    }
}

/// A body thrown with slip: it starts with a speed and a spin that rolling would not tie together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Thrown {
    /// Index of the contact.
    pub tie: usize,
    /// Index of the body.
    pub body: usize,
    /// Radius that touches the surface.
    pub radius_m: Num,
    /// Static friction coefficient: can it roll on?
    pub mu_s: Num,
    /// Kinetic friction coefficient.
    pub mu_k: Num,
    /// Speed at the start, positive forward.
    pub speed_m_s: Num,
    /// Spin at the start, positive with rolling forward.
    pub spin_rad_s: Num,
}

impl Scene {
    /// Is it declared to go the other way than in this sense of the ending coordinate?
    pub fn goes_wrong(&self, sense: f64) -> bool {
        match self.heading {
            Some(Heading::Forward) => sense < 0.0,
            Some(Heading::Back) => sense > 0.0,
            None => false,
        }
    }
    /// The speeds and spins of the start, in the order of the bank.
    pub fn start_speeds(&self) -> impl Iterator<Item = (Coordinate, Num)> {
        self.start.iter().filter_map(|s| match s {
            Start::Speed(c, number) => Some((*c, *number)),
            Start::Lamina { .. } => None,
        })
    }
    /// Are speeds of several freedoms told of joined bodies of which only an instant is asked? Then nothing has to be integrated.
    pub fn tells_speeds(&self) -> bool {
        self.end == End::AtOnce && self.lead().is_some() && self.start_speeds().count() > 1
    }
    /// The body that is thrown with slip and alone, up to the start of rolling, or for a time or an instant: it slips, and its speed and
    /// its spin at the start are both given.
    pub fn thrown(&self) -> Option<Thrown> {
        let ends = matches!(self.end, End::Rolling(_) | End::Time(..) | End::AtOnce);
        if !ends || self.bodies.len() > 1 || self.ties.len() > 1 {
            return None;
        }
        let given = |body: usize, degree: Degree| {
            self.start.iter().find_map(|s| match s {
                Start::Speed(c, n) if *c == Coordinate { body, degree } => Some(*n),
                _ => None,
            })
        };
        self.ties.iter().enumerate().find_map(|(tie, t)| match *t {
            Tie::Slip { body, radius_m, mu_s, mu_k } => Some(Thrown {
                tie,
                body,
                radius_m,
                mu_s,
                mu_k,
                speed_m_s: given(body, Degree::Along)?,
                spin_rad_s: given(body, Degree::Turn)?,
            }),
            _ => None,
        })
    }
}
