//! Pure data in SI: what is there, how it starts, what ends the motion, what is asked. No chance, no solving, no text.
//!
//! **Conventions**, stated once. Motion is planar. Each body that moves does so along its own straight line, positive
//! *forward* (up the incline unless the scene says otherwise); a turn is positive in the sense that goes with rolling
//! forward. Friction is the force on the body, positive forward. Cords are massless, inextensible and parallel to the
//! line of the body that they leave. A pinned body has no line: it turns, positive as its angle grows (see [`planar`]). Angles
//! are degrees in the data (they are reduced as degrees), radians in answers.
pub mod admissible;
pub mod ask;
pub mod axle;
pub mod body;
pub mod force;
pub mod formula;
pub mod freedom;
pub mod given;
pub mod inertia;
pub mod link;
pub mod motion;
pub mod numbers;
pub mod planar;
pub mod pose;
pub mod scales;

pub use admissible::{Inadmissible, Rule};
pub use ask::{Label, Owner, Quantities, Quantity};
pub use axle::Aim;
pub use body::{Body, Line, Mass, Part, Particle, RotaryInertia, Shape, Slope};
pub use force::{Couple, GivenForce, Grows, Growth, Law};
pub use formula::{AsIf, Asked, Derived, Formulas, Found, Given, Taken, Term};
pub use link::{Action, Attach, Cord, CordEnd, Far, Made, Rubbing, Side, SpringTie, Tie};
pub use motion::{Carrier, Coordinate, Degree, End, Heading, Span, Start, Thrown};
pub use numbers::{BodyNumbers, Carried, Numbers, speed};
pub use planar::{
    Acts, Arrives, Branch, Joint, JointKind, Place, Planar, Push, Ray, Rest, Spot, Straight, Strut, StrutEnd,
    Surface, on_axis,
};
pub use scales::Scales;

use serde::{Deserialize, Serialize};

/// Where a number of the scene comes from: a datum of the problem (by index), a constant of the bank, or a formula of data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Num {
    /// Index into the data of the problem.
    Datum(usize),
    /// A constant, SI (angles in degrees).
    Fixed(f64),
    /// Index into the numbers of [`Scene::formulas`].
    Derived(usize),
}

impl Default for Num {
    fn default() -> Self {
        Self::Fixed(0.0)
    }
}

/// A scene: structure only. The numbers are passed beside it, one SI `f64` for each datum, so that thousands of draws
/// share one scene.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Acceleration of free fall, m/s^2, > 0.
    pub gravity_m_s2: Num,
    /// The bodies, in the order of the bank.
    pub bodies: Vec<Body>,
    /// The ties, in the order of the bank.
    pub ties: Vec<Tie>,
    /// Couples (weights and normal forces follow from bodies and lines).
    pub couples: Vec<Couple>,
    /// What holds points of bodies that move in the plane.
    pub joints: Vec<Joint>,
    /// The joint that acts in an impact alone, by index, with its coefficient of restitution.
    pub restitution: Option<(usize, Num)>,
    /// Forces on points of bodies that move in the plane.
    pub pushes: Vec<Push>,
    /// Springs at points of bodies that move in the plane.
    pub struts: Vec<Strut>,
    /// What of the given forces and couples grows with time or place.
    pub growths: Vec<Growth>,
    /// What carries all of it and moves as it is told to.
    pub carried: Option<Carrier>,
    /// How it starts; empty means at rest.
    pub start: Vec<Start>,
    /// What ends the motion.
    pub end: End,
    /// Is `end` to be reached in a declared direction? `None`: in whichever it moves.
    pub heading: Option<Heading>,
    /// How far the conditions of validity and the extrema look.
    pub span: Span,
    /// What is worked out by formulas of the bank.
    pub formulas: Formulas,
}
