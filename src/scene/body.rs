//! Bodies: mass, inertia, named radii, and the line along which the mass centre moves.
use crate::scene::{Num, Planar};
use serde::{Deserialize, Serialize};

/// One rigid body.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Name in the bank, such as `wheel`.
    pub name: String,
    /// Mass, or what gives it. Not read when `particles` is not empty.
    pub mass: Mass,
    /// How the mass is spread about the mass centre; `None` for a body that only moves.
    pub inertia: Option<RotaryInertia>,
    /// Named radii, m, > 0, such as `("rim", R)`.
    pub radii_m: Vec<(String, Num)>,
    /// The line of the mass centre; `None` for a body that turns about a fixed axle.
    pub line: Option<Line>,
    /// Does it turn?
    pub turns: bool,
    /// Is it taken away from what it is welded to, as a hole is? Its mass and its moment of inertia then count negative.
    pub removed: bool,
    /// Particles rigidly joined; not empty only for a lamina whose kinetic energy is asked.
    pub particles: Vec<Particle>,
    /// Moves in the plane as joints let it; `None` for every other body.
    pub planar: Option<Planar>,
}

impl Body {
    /// Is its spin a coordinate of the scene? The motion of a body of particles is told by itself.
    pub fn spins(&self) -> bool {
        self.turns && self.particles.is_empty()
    }
    /// Its length, if it is a slender rod.
    pub const fn rod(&self) -> Option<Num> {
        match self.inertia {
            Some(RotaryInertia::Shape(Shape::Rod, length)) => Some(length),
            _ => None,
        }
    }
    /// Is no mass told of it? On a fixed axle a given moment of inertia says all but what the axle bears.
    pub const fn massless(&self) -> bool {
        matches!((&self.mass, &self.inertia), (Mass::OfParts, Some(RotaryInertia::Moment(_))))
    }
}

/// Mass of a body.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub enum Mass {
    /// Mass, kg.
    Kilograms(Num),
    /// Weight, N; the mass is weight / g.
    Weight(Num),
    /// Sum of the masses of the parts of [`RotaryInertia::Parts`], or of the particles; none where only a moment of inertia is told.
    #[default]
    OfParts,
}

/// Moment of inertia about the mass centre, from one of several data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum RotaryInertia {
    /// `I = m k^2`, k in m, >= 0.
    Gyration(Num),
    /// Given, kg m^2, >= 0.
    Moment(Num),
    /// A uniform shape of one radius.
    Shape(Shape, Num),
    /// Several uniform shapes about one axis.
    Parts(Vec<Part>),
}

/// One part of a compound body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Mass of the part.
    pub mass: Mass,
    /// Its shape.
    pub shape: Shape,
    /// Its radius, m.
    pub radius_m: Num,
}

/// Uniform shapes, about the axis through the mass centre and normal to the plane: `I = beta m R^2`, R the radius (of a
/// rod: the length).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Shape {
    /// Thin ring or thin-walled hollow cylinder, beta = 1.
    Hoop,
    /// Disc or solid cylinder, beta = 1/2.
    Disc,
    /// Solid sphere, beta = 2/5.
    Sphere,
    /// Thin spherical shell, beta = 2/3.
    Shell,
    /// Slender rod, beta = 1/12 of the square of its length, which stands for R.
    Rod,
}

/// The straight line of a mass centre, and whether the body rests on it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Slope of the line.
    pub slope: Slope,
    /// True: forward is up the slope (on a level: to the right). False: forward is down the slope.
    pub forward_up: bool,
    /// True: it is a surface, so there is a normal force. False: the body hangs or is guided without force.
    pub surface: bool,
}

/// Slope of a line.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Slope {
    /// Horizontal.
    Level,
    /// An incline, degrees, 0 to 90.
    Degrees(Num),
    /// Vertical.
    Vertical,
}

/// A particle of a lamina.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Particle {
    /// Name, such as `A`.
    pub name: String,
    /// Mass, kg, > 0.
    pub mass_kg: Num,
    /// Place, m.
    pub x_m: Num,
    /// Place, m.
    pub y_m: Num,
}
