//! Velocity ratios, derived from the ties alone: which velocities are possible together.
//!
//! A rolling contact has a point at rest: the wheel turns about it, `v = c omega`. A cord of constant length gives at one
//! end what it takes in at the other. The possible motions are the modes of these conditions, one for each freedom.
use crate::num::Real;
use crate::num::eliminate::reduce;
use crate::num::plant::plant;
use crate::scene::Attach;
use crate::scene::Coordinate;
use crate::scene::CordEnd;
use crate::scene::Degree;
use crate::scene::Far;
use crate::scene::Numbers;
use crate::scene::Scene;
use crate::scene::Side;
use crate::scene::Tie;
use crate::solve::outcome::Refusal;

/// A possible motion: velocity of the line and spin of each body, per unit rate of the mode.
#[derive(Debug, Clone)]
pub struct Mode<T> {
    /// Velocities along the lines.
    pub v: Vec<T>,
    /// Spins.
    pub w: Vec<T>,
}

impl<T: Real> Mode<T> {
    /// Velocity of a coordinate.
    pub fn of(&self, c: Coordinate) -> T {
        match c.degree {
            Degree::Along => self.v[c.body],
            Degree::Turn => self.w[c.body],
        }
    }
    /// Velocity, along the cord and away from the body, of the point at which a cord leaves: that of the centre and that
    /// of the rim against the centre.
    pub fn point(&self, n: &Numbers<T>, end: &CordEnd) -> T {
        let about_centre = match end.attach {
            Attach::Centre => T::zero(),
            Attach::Wound(p, side) => {
                let rim = plant!("energy: unwinding of a cord", n.get(p) * self.w[end.body]);
                if side == Side::Bottom { -rim } else { rim }
            }
        };
        let centre = plant!("energy: travel of the centre with a cord", self.v[end.body]);
        let velocity = centre + about_centre;
        if end.forward { velocity } else { -velocity }
    }
}

/// The possible motions: the first has unit rate of the ending coordinate, the others leave it at rest.
///
/// `rolled`: a contact that is said to slip is taken as rolling. Errors: the ties hold the ending coordinate fast.
pub fn modes<T: Real>(scene: &Scene, n: &Numbers<T>, rolled: bool) -> Result<Vec<Mode<T>>, Refusal> {
    let bodies = scene.bodies.len();
    let column = |c: Coordinate| match c.degree {
        Degree::Along => 2 * c.body,
        Degree::Turn => 2 * c.body + 1,
    };
    let cols = 2 * bodies;
    let mut rows: Vec<Vec<T>> = Vec::with_capacity(cols);
    let blank = || vec![T::zero(); cols + 1];
    // A body without a line does not travel, one that does not turn has no spin.
    for (b, body) in scene.bodies.iter().enumerate() {
        for (missing, degree) in [(body.line.is_none(), Degree::Along), (!body.turns, Degree::Turn)] {
            if missing {
                let mut row = blank();
                row[column(Coordinate { body: b, degree })] = T::of(1.0);
                rows.push(row);
            }
        }
    }
    // Velocity of a cord's end as a linear form: its values on the unit motions of the body.
    let add_point = |row: &mut [T], end: &CordEnd| {
        for degree in [Degree::Along, Degree::Turn] {
            let mut unit = Mode { v: vec![T::zero(); bodies], w: vec![T::zero(); bodies] };
            let c = Coordinate { body: end.body, degree };
            match degree {
                Degree::Along => unit.v[end.body] = T::of(1.0),
                Degree::Turn => unit.w[end.body] = T::of(1.0),
            }
            row[column(c)] = row[column(c)] + unit.point(n, end);
        }
    };
    for tie in &scene.ties {
        let rolls = match tie {
            Tie::Roll { body, radius_m, .. } => Some((body, radius_m)),
            Tie::Slip { body, radius_m, .. } if rolled => Some((body, radius_m)),
            _ => None,
        };
        if let Some((body, radius)) = rolls {
            let mut row = blank();
            row[column(Coordinate { body: *body, degree: Degree::Along })] = T::of(1.0);
            row[column(Coordinate { body: *body, degree: Degree::Turn })] =
                -plant!("energy: distance from the contact", n.get(*radius));
            rows.push(row);
        }
        if let Tie::Cord(cord) = tie {
            let mut row = blank();
            match &cord.to {
                Far::Fixed => add_point(&mut row, &cord.from),
                Far::Body(other) => {
                    add_point(&mut row, &cord.from);
                    add_point(&mut row, other);
                }
                Far::Pull(_) | Far::Spring { .. } => continue,
            }
            rows.push(row);
        }
    }
    let main = column(scene.ending_coordinate());
    // Keep the spin of a slipping wheel open beside the ending coordinate.
    let mut free = vec![main];
    if !rolled {
        free.extend(scene.ties.iter().filter_map(|t| match t {
            Tie::Slip { body, .. } => Some(column(Coordinate { body: *body, degree: Degree::Turn })),
            _ => None,
        }));
    }
    let reduced = reduce(cols, rows, &free);
    let mut open = reduced.open();
    let Some(first) = open.iter().position(|j| *j == main) else { return Err(Refusal::Freedoms(0)) };
    open.swap(0, first);
    Ok(open
        .into_iter()
        .map(|j| {
            let x = reduced.mode(j);
            Mode {
                v: x.iter().step_by(2).copied().collect(),
                w: x.iter().skip(1).step_by(2).copied().collect(),
            }
        })
        .collect())
}
