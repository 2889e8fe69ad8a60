//! Ties between bodies and with the ground: rolling, slipping and sliding contacts, cords.
use crate::scene::{Num, Quantity, RotaryInertia, Scene};
use serde::{Deserialize, Serialize};

/// A tie. Each adds the rows that it needs to the assembly, and no others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Tie {
    /// Rolls without slipping on a radius: one row, friction is its reaction.
    Roll {
        /// Index of the body.
        body: usize,
        /// Radius that touches the surface, m, > 0.
        radius_m: Num,
        /// Static friction coefficient, for the regime check.
        mu_s: Option<Num>,
    },
    /// Is said to slip on a radius: kinetic friction, from rest in the sense that static friction would have; against the slip
    /// where it is thrown with one.
    Slip {
        /// Index of the body.
        body: usize,
        /// Radius that touches the surface, m, > 0.
        radius_m: Num,
        /// Static friction coefficient: it slips only if rolling would need more.
        mu_s: Num,
        /// Kinetic friction coefficient.
        mu_k: Num,
    },
    /// A body that only moves slides on its surface: kinetic friction against the motion.
    Slide {
        /// Index of the body.
        body: usize,
        /// Static friction coefficient: does it start at all?
        mu_s: Option<Num>,
        /// Kinetic friction coefficient.
        mu_k: Num,
    },
    /// A cord.
    Cord(Cord),
}

/// A cord, from a body to something.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cord {
    /// Name for `name.tension` when a scene has several; `cord` unless the bank names it.
    pub name: String,
    /// The end at the body.
    pub from: CordEnd,
    /// The other end.
    pub to: Far,
    /// What it is: a cord pulls, teeth and belts drive both ways.
    pub made: Made,
}

/// What leads from rim to rim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Made {
    /// A cord, which pulls.
    #[default]
    Cord,
    /// A light rod, which pushes as well.
    Link,
    /// The teeth of two gears.
    Teeth,
    /// A belt that runs around two wheels and does not slip.
    Belt,
    /// Nothing: the first body rests on the second, on its rim without slip or on its axle.
    Rests,
}

impl Cord {
    /// What is asked of its force.
    pub fn force(&self) -> Quantity {
        if matches!(self.made, Made::Cord | Made::Link) { Quantity::Tension } else { Quantity::RimForce }
    }
}

/// Where a cord leaves a body. The rate at which this end travels along the cord, away from the body, is
/// `toward (v + side p omega)` with `toward` = +1 forward, -1 back.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CordEnd {
    /// Index of the body.
    pub body: usize,
    /// Tied at the centre, or wound on a radius.
    pub attach: Attach,
    /// Does the cord leave forward?
    pub forward: bool,
    /// Does it leave a fixed axle upward, or downward? To the motion `front down` is what `top forward` is: only the force of the axle
    /// and pictures tell them apart.
    pub upright: Option<bool>,
    /// Degrees by which a cord that is pulled with a given force leads away from the surface of its body; `None`: along it.
    pub tilt_deg: Option<Num>,
}

/// How a cord holds a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Attach {
    /// Tied to the mass centre.
    Centre,
    /// Wound on a radius, m, > 0.
    Wound(Num, Side),
}

/// The side of the body, seen with forward to the right, at which a wound cord leaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Side {
    /// Away from the surface: a turn forward moves this side forward, `side` = +1.
    Top,
    /// Toward the surface, `side` = -1.
    Bottom,
}

/// What is at the other end of a cord.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Far {
    /// A constant force, N, >= 0.
    Pull(Num),
    /// Another body, over fixed massless pulleys if need be.
    Body(CordEnd),
    /// A spring whose other end is fixed.
    Spring {
        /// Stiffness, N/m, > 0.
        stiffness_n_m: Num,
        /// Stretch at the start, m, >= 0.
        stretch_m: Num,
        /// True: the spring is attached rigidly and can push. False: the cord goes slack.
        rigid: bool,
    },
    /// A fixed point.
    Fixed,
}

/// A spring of a scene, with its tie.
#[derive(Debug, Clone, Copy)]
pub struct SpringTie {
    /// Index of the tie.
    pub tie: usize,
    /// The end of its cord at the body.
    pub from: CordEnd,
    /// Stiffness, N/m, > 0.
    pub stiffness_n_m: Num,
    /// Stretch at the start, m, >= 0.
    pub stretch_m: Num,
    /// Can it push?
    pub rigid: bool,
}

/// Where the force of a tie acts on a body, positive in the sense in which the force is: friction forward, a cord away from the
/// body. The rows of the equations of motion, the worked solutions and the free bodies of figures are made from these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Action {
    /// Index of the body.
    pub body: usize,
    /// Share along the line of the body: 1 forward, -1 back.
    pub along: f64,
    /// Arm about the mass centre: a radius, m, and the sense in which the force turns; `None` at the centre.
    pub arm: Option<(Num, f64)>,
    /// Degrees by which it leads away from the surface; `None`: along the line.
    pub tilt_deg: Option<Num>,
}

impl CordEnd {
    /// An end that leaves along the line of its body.
    pub const fn new(body: usize, attach: Attach, forward: bool) -> Self {
        Self { body, attach, forward, upright: None, tilt_deg: None }
    }
    /// The pull of the cord at this end.
    pub fn action(&self) -> Action {
        let along = if self.forward { 1.0 } else { -1.0 };
        let arm = match self.attach {
            Attach::Centre => None,
            Attach::Wound(radius, Side::Top) => Some((radius, along)),
            Attach::Wound(radius, Side::Bottom) => Some((radius, -along)),
        };
        Action { body: self.body, along, arm, tilt_deg: self.tilt_deg }
    }
}

/// A contact that is said to slip or slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rubbing {
    /// Index of the body.
    pub body: usize,
    /// Radius on which it slips, m; `None` of a body that only moves.
    pub radius_m: Option<Num>,
    /// Static friction coefficient, or the kinetic one where only that is given.
    pub mu_s: Num,
    /// Kinetic friction coefficient.
    pub mu_k: Num,
}

impl Scene {
    /// The rolling contact of a wheel with a given radius of gyration that rolls alone under constant pulls along its line, and the radius
    /// on which it rolls.
    pub fn pulled_wheel(&self) -> Option<(usize, Num)> {
        let [body] = self.bodies.as_slice() else { return None };
        let given = matches!(body.inertia, Some(RotaryInertia::Gyration(_)));
        let pulls =
            |t: &Tie| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_)) && c.from.tilt_deg.is_none());
        let rolls = |t: &Tie| if let Tie::Roll { radius_m, .. } = t { Some(*radius_m) } else { None };
        let constant = self.couples.is_empty() && self.growths.is_empty() && self.ties.iter().any(pulls);
        let tie = self.ties.iter().position(|t| rolls(t).is_some()).filter(|_| given && constant)?;
        let alone = self.ties.iter().enumerate().all(|(t, other)| t == tie || pulls(other));
        rolls(&self.ties[tie]).filter(|_| alone).map(|radius| (tie, radius))
    }
}

impl Tie {
    /// Its friction, where it is a contact that is said to slip or slide.
    pub fn rubbing(&self) -> Option<Rubbing> {
        match *self {
            Self::Slip { body, radius_m, mu_s, mu_k } => {
                Some(Rubbing { body, radius_m: Some(radius_m), mu_s, mu_k })
            }
            Self::Slide { body, mu_s, mu_k } => {
                Some(Rubbing { body, radius_m: None, mu_s: mu_s.unwrap_or(mu_k), mu_k })
            }
            Self::Roll { .. } | Self::Cord(_) => None,
        }
    }
    /// The body that touches its surface here.
    pub const fn touching(&self) -> Option<usize> {
        match self {
            Self::Roll { body, .. } | Self::Slip { body, .. } | Self::Slide { body, .. } => Some(*body),
            Self::Cord(_) => None,
        }
    }
    /// A given pull that leads away from the surface of a body: the body, the force and the angle in degrees.
    pub const fn tilted(&self) -> Option<(usize, Num, Num)> {
        match self {
            Self::Cord(Cord {
                from: CordEnd { body, tilt_deg: Some(tilt), .. },
                to: Far::Pull(force),
                ..
            }) => Some((*body, *force, *tilt)),
            _ => None,
        }
    }
    /// The forces of the tie on its bodies: one of a contact, one for each end of a cord that is at a body.
    pub fn actions(&self) -> impl Iterator<Item = Action> {
        let [one, other] = match self {
            Self::Roll { body, radius_m, .. } | Self::Slip { body, radius_m, .. } => {
                [Some(Action { body: *body, along: 1.0, arm: Some((*radius_m, -1.0)), tilt_deg: None }), None]
            }
            Self::Slide { body, .. } => {
                [Some(Action { body: *body, along: 1.0, arm: None, tilt_deg: None }), None]
            }
            Self::Cord(cord) => match &cord.to {
                Far::Body(end) => [Some(cord.from.action()), Some(end.action())],
                Far::Pull(_) | Far::Spring { .. } | Far::Fixed => [Some(cord.from.action()), None],
            },
        };
        one.into_iter().chain(other)
    }
}
