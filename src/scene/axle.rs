//! The directions in which cords pull at a body about a fixed axle, as far as a scene tells them: the force of its axle hangs on them.
use crate::num::Real;
use crate::scene::{CordEnd, Far, Made, Mass, Num, Numbers, Scene, Slope, Tie, pose};
use smallvec::SmallVec;

/// A direction of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Aim {
    /// To the right, or to the left.
    Level(bool),
    /// Up, or down.
    Upright(bool),
    /// Along the line of a body, forward or back.
    Along(usize, bool),
    /// So many degrees above level, to the right or to the left.
    Tilted(Num, bool),
}

impl Aim {
    /// As a unit vector, to the right and up; forward is to the right.
    pub fn unit<T: Real>(self, n: &Numbers<T>) -> [T; 2] {
        let (vector, positive) = match self {
            Self::Tilted(tilt, right) => {
                let [level, up] = pose::direction(n, tilt);
                return [if right { level } else { -level }, up];
            }
            Self::Level(right) => ([T::of(1.0), T::zero()], right),
            Self::Upright(up) => ([T::zero(), T::of(1.0)], up),
            Self::Along(body, forward) => ([n.bodies[body].level, n.bodies[body].climb], forward),
        };
        vector.map(|x| if positive { x } else { -x })
    }
}

impl Scene {
    /// The ties that pull at a body about a fixed axle, and in which direction; `None` of another body, of one without a mass, and
    /// where the scene does not tell a direction.
    pub fn axle_pulls(&self, body: usize) -> Option<SmallVec<[(usize, Aim); 2]>> {
        let b = self.bodies.get(body)?;
        let fixed = b.line.is_none() && b.planar.is_none() && b.particles.is_empty();
        if !fixed || b.massless() || matches!(b.mass, Mass::OfParts) && b.inertia.is_none() {
            return None;
        }
        let mut pulls = SmallVec::new();
        for (t, tie) in self.ties.iter().enumerate() {
            let Tie::Cord(cord) = tie else { continue };
            let far = if let Far::Body(end) = &cord.to { Some(end) } else { None };
            let (own, other) = match far {
                Some(end) if end.body == body => (end, Some(&cord.from)),
                _ if cord.from.body == body => (&cord.from, far),
                _ => continue,
            };
            if cord.made != Made::Cord {
                return None;
            }
            pulls.push((t, self.aim(own, other)?));
        }
        Some(pulls)
    }

    /// The direction in which a cord leaves a fixed axle: parallel to the slope of the body at its other end, if that is on one.
    fn aim(&self, own: &CordEnd, other: Option<&CordEnd>) -> Option<Aim> {
        if let Some(tilt) = own.tilt_deg {
            return Some(Aim::Tilted(tilt, own.forward));
        }
        if let Some(up) = own.upright {
            return Some(Aim::Upright(up));
        }
        let sloped = |end: &&CordEnd| {
            matches!(self.bodies[end.body].line.map(|line| line.slope), Some(Slope::Degrees(_)))
        };
        match other.filter(sloped) {
            // From one end to the other; what goes round a corner on the way has no direction of its own, and of what counts positive
            // down a slope a picture may show either side.
            Some(end) => {
                let up = self.bodies[end.body].line.is_some_and(|line| line.forward_up);
                (up && own.forward != end.forward).then_some(Aim::Along(end.body, !end.forward))
            }
            None => Some(Aim::Level(own.forward)),
        }
    }
}
