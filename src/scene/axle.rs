//! The directions in which cords pull at a body about a fixed axle, as far as a scene tells them: the force of its axle hangs on them.
use crate::num::Real;
use crate::scene::{Cord, CordEnd, Far, Line, Made, Mass, Num, Numbers, Scene, Slope, Tie, pose};
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
        if !fixed
            || self.is_any_turned_round()
            || b.massless()
            || matches!(b.mass, Mass::OfParts) && b.inertia.is_none()
        {
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

    /// The cords from surface to surface, straight or from slope to slope over a wheel about a fixed axle: the slopes at both ends, and
    /// whether they leave the body there to the right. From a wall, which faces left, what leads upward leads to the right.
    fn cords_between_surfaces(&self) -> SmallVec<[[(Slope, bool); 2]; 2]> {
        let right = |end: &CordEnd| {
            let line = self.bodies[end.body].line.filter(|line| line.surface)?;
            Some((line.slope, end.forward == line.forward_up))
        };
        let (mut found, mut led) = (SmallVec::new(), SmallVec::<[(usize, (Slope, bool)); 2]>::new());
        for tie in &self.ties {
            let Tie::Cord(Cord { from, to: Far::Body(to), made, .. }) = tie else { continue };
            let (axle, surface) = match (right(from), right(to)) {
                _ if *made == Made::Rests => continue,
                (Some(one), Some(other)) => {
                    found.push([one, other]);
                    continue;
                }
                (Some(surface), None) => (to.body, surface),
                (None, Some(surface)) => (from.body, surface),
                (None, None) => continue,
            };
            if self.bodies[axle].line.is_none() {
                let led_on = led.iter().filter(|(at, other)| *at == axle && other.0 != surface.0);
                found.extend(led_on.map(|(_, other)| [*other, surface]));
                led.push((axle, surface));
            }
        }
        found
    }

    /// The slopes on which bodies lie, and whether a picture turns each surface round: a cord that leads from one surface to another
    /// leaves one body to the right and the other to the left.
    fn turned_round(&self) -> SmallVec<[(Slope, bool); 2]> {
        let mut known: SmallVec<[(Slope, bool); 2]> = SmallVec::new();
        for line in self.bodies.iter().filter_map(|body| body.line).filter(|line| line.surface) {
            if known.iter().all(|(slope, _)| *slope != line.slope) {
                known.push((line.slope, false));
            }
            // As often as cords may lead on from what one of them has led to.
            for [one, other] in self.ties.iter().flat_map(|_| self.cords_between_surfaces()) {
                for [near, far] in [[one, other], [other, one]] {
                    let turned =
                        |end: (Slope, bool)| Some(known.iter().find(|(slope, _)| *slope == end.0)?.1);
                    if let (Some(turned), None) = (turned(near), turned(far)) {
                        known.push((far.0, (near.1 == far.1) != turned));
                    }
                }
            }
        }
        known
    }

    /// Does a cord leave two bodies on surfaces to the same side, so that a surface is drawn turned round?
    pub fn is_any_turned_round(&self) -> bool {
        self.cords_between_surfaces().iter().any(|[(_, one), (_, other)]| one == other)
    }

    /// Is the surface on which a body lies drawn turned round, rising to the left?
    pub fn is_turned_round(&self, body: usize) -> bool {
        let slope = self.bodies[body].line.filter(|line| line.surface).map(|line| line.slope);
        self.turned_round().iter().any(|(other, turned)| *turned && Some(*other) == slope)
    }

    /// The direction in which a cord leaves a fixed axle: parallel to the slope of the body at its other end, if that is on one.
    pub fn aim(&self, own: &CordEnd, other: Option<&CordEnd>) -> Option<Aim> {
        if let Some(tilt) = own.tilt_deg {
            return Some(Aim::Tilted(tilt, own.forward));
        }
        let line = other.and_then(|end| Some((end, self.bodies[end.body].line?)));
        // From axle to axle it is told where it leads from the one to the other.
        let axle = other.filter(|end| self.bodies[end.body].line.is_none());
        if let Some(end) = axle
            && ((own.upright.is_some(), own.upright.unwrap_or(own.forward))
                != (end.upright.is_some(), !end.upright.unwrap_or(end.forward)))
        {
            return None;
        }
        match (line, own.upright) {
            // From one end to the other; what goes round a corner has no direction of its own, and of what counts positive down a slope
            // a picture may show either side.
            (Some((end, Line { slope: Slope::Degrees(_), forward_up, .. })), _) => {
                let towards = own.upright.unwrap_or(own.forward);
                (forward_up && towards != end.forward).then_some(Aim::Along(end.body, !end.forward))
            }
            (Some((_, Line { slope: Slope::Level, .. })), Some(_)) => None,
            (_, Some(up)) => Some(Aim::Upright(up)),
            _ => Some(Aim::Level(own.forward)),
        }
    }
}
