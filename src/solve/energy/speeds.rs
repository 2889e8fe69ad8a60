//! Velocity ratios, derived from the ties alone: which velocities are possible together.
//!
//! A rolling contact has a point at rest: the wheel turns about it, `v = c omega`. A cord of constant length gives at one
//! end what it takes in at the other. The possible motions are the modes of these conditions, one for each freedom.
use crate::num::Real;
use crate::num::eliminate::Equations;
use crate::num::plant::plant;
use crate::scene::pose;
use crate::scene::{Attach, Coordinate, CordEnd, Degree, Far, Numbers, Scene, Side, Tie};
use crate::solve::outcome;
use crate::solve::outcome::Refusal;
use smallvec::{SmallVec, smallvec};

/// A possible motion: velocity of the line and spin of each body, per unit rate of the mode.
#[derive(Debug, Clone)]
pub struct Mode<T> {
    /// Velocities along the lines.
    pub v: SmallVec<[T; 2]>,
    /// Spins.
    pub w: SmallVec<[T; 2]>,
}

/// One mode for each freedom.
pub type Modes<T> = SmallVec<[Mode<T>; 2]>;

impl<T: Real> Mode<T> {
    /// No motion.
    pub fn still(bodies: usize) -> Self {
        Self { v: smallvec![T::zero(); bodies], w: smallvec![T::zero(); bodies] }
    }
    /// Both motions at once.
    pub fn plus(&self, other: &Self) -> Self {
        let sum = |a: &[T], b: &[T]| a.iter().zip(b).map(|(a, b)| a.settled(*b)).collect();
        Self { v: sum(&self.v, &other.v), w: sum(&self.w, &other.w) }
    }
    /// Velocity of a coordinate.
    pub fn of(&self, c: Coordinate) -> T {
        match c.degree {
            Degree::Along => self.v[c.body],
            Degree::Turn => self.w[c.body],
        }
    }
    /// Velocity of the point at which a cord leaves its body, along the cord and away from the body.
    pub fn point(&self, n: &Numbers<T>, end: &CordEnd) -> T {
        of_end(n, end, self.v[end.body], self.w[end.body])
    }
}

/// The same where the centre of that body has this velocity and the body this spin: that of the centre and that of the rim against it.
pub fn of_end<T: Real>(n: &Numbers<T>, end: &CordEnd, v: T, w: T) -> T {
    let about_centre = match end.attach {
        Attach::Centre => T::zero(),
        Attach::Wound(p, side) => {
            let rim = plant!("energy: unwinding of a cord", n.get(p) * w);
            if side == Side::Bottom { -rim } else { rim }
        }
    };
    let centre = plant!("energy: travel of the centre with a cord", v);
    let centre = end.tilt_deg.map_or(centre, |tilt| {
        plant!("energy: travel along a pull at an angle", centre * pose::direction(n, tilt)[0])
    });
    let velocity = centre.balance(about_centre);
    if end.forward { velocity } else { -velocity }
}

/// A unit velocity of the centre of a body, or a unit spin.
pub fn unit<T: Real>(degree: Degree) -> [T; 2] {
    let (one, none) = (T::of(1.0), T::zero());
    if degree == Degree::Along { [one, none] } else { [none, one] }
}

/// Place of a coordinate among the unknowns.
fn column(c: Coordinate) -> usize {
    match c.degree {
        Degree::Along => 2 * c.body,
        Degree::Turn => 2 * c.body + 1,
    }
}

/// What the ties say of the velocities. `holds` says of each tie whether it is a contact that could rub and is at rest.
fn conditions<T: Real>(scene: &Scene, n: &Numbers<T>, holds: &[bool]) -> Equations<T> {
    let bodies = scene.bodies.len();
    let mut rows = Equations::of_decimals(2 * bodies);
    // A body without a line does not travel, one that does not turn has no spin.
    for (b, body) in scene.bodies.iter().enumerate() {
        for (missing, degree) in [(body.line.is_none(), Degree::Along), (!body.spins(), Degree::Turn)] {
            if missing {
                rows.row()[column(Coordinate { body: b, degree })] = T::of(1.0);
            }
        }
    }
    // Velocity of a cord's end as a linear form: its values on the unit motions of the body.
    let add_point = |row: &mut [T], end: &CordEnd| {
        for degree in [Degree::Along, Degree::Turn] {
            let (at, [v, w]) = (column(Coordinate { body: end.body, degree }), unit(degree));
            row[at] = row[at] + of_end(n, end, v, w);
        }
    };
    for (t, tie) in scene.ties.iter().enumerate() {
        let rolls = match tie {
            Tie::Roll { body, radius_m, .. } => Some((body, radius_m)),
            Tie::Slip { body, radius_m, .. } if holds.get(t) == Some(&true) => Some((body, radius_m)),
            _ => None,
        };
        if let Some((body, radius)) = rolls {
            let row = rows.row();
            row[column(Coordinate { body: *body, degree: Degree::Along })] = T::of(1.0);
            row[column(Coordinate { body: *body, degree: Degree::Turn })] =
                -plant!("energy: distance from the contact", n.get(*radius));
        }
        if let (Tie::Slide { body, .. }, Some(true)) = (tie, holds.get(t)) {
            rows.row()[column(Coordinate { body: *body, degree: Degree::Along })] = T::of(1.0);
        }
        if let Tie::Cord(cord) = tie {
            match &cord.to {
                Far::Fixed => add_point(rows.row(), &cord.from),
                Far::Body(other) => {
                    let row = rows.row();
                    add_point(row, &cord.from);
                    add_point(row, other);
                }
                Far::Pull(_) | Far::Spring { .. } => {}
            }
        }
    }
    rows
}

/// The velocities that the start and the ties give; all 0 where it starts from rest.
///
/// Errors: a velocity that they leave open, or one that the start gives against them.
pub fn at_start<T: Real>(scene: &Scene, n: &Numbers<T>) -> Result<Mode<T>, Refusal> {
    let mut motion = Mode::still(scene.bodies.len());
    let given: SmallVec<[(Coordinate, T); 4]> =
        scene.start_speeds().map(|(c, v)| (c, n.start(c, v))).collect();
    if given.is_empty() {
        return Ok(motion);
    }
    // The given velocities are solved for last: what then is left open must be one of them.
    let columns: SmallVec<[usize; 4]> = given.iter().map(|(c, _)| column(*c)).collect();
    let reduced = conditions(scene, n, &[]).reduce(&columns);
    let open = reduced.open();
    if let Some(c) =
        scene.coordinates().find(|c| open.contains(&column(*c)) && !columns.contains(&column(*c)))
    {
        return Err(Refusal::Open(c));
    }
    for (i, (_, v)) in given.iter().enumerate() {
        if open.contains(&columns[i]) && !columns[..i].contains(&columns[i]) {
            let part = |j: usize| *v * reduced.in_mode(columns[i], j);
            for b in 0..scene.bodies.len() {
                motion.v[b] = motion.v[b].settled(part(2 * b));
                motion.w[b] = motion.w[b].settled(part(2 * b + 1));
            }
        }
    }
    for (c, v) in &given {
        outcome::consistent(*c, *v, motion.of(*c))?;
    }
    Ok(motion)
}

/// The possible motions: the first has unit rate of the ending coordinate, the others leave it at rest; all of them do where
/// the ties hold it fast, and there are none where they hold everything.
///
/// `holds` says of each tie whether it is a contact that could rub and is at rest.
pub fn modes<T: Real>(scene: &Scene, n: &Numbers<T>, holds: &[bool]) -> Modes<T> {
    let bodies = scene.bodies.len();
    let rows = conditions(scene, n, holds);
    let main = column(scene.ending_coordinate());
    // Keep the spin of a slipping wheel open beside the ending coordinate.
    let mut free: SmallVec<[usize; 4]> = smallvec![main];
    free.extend(scene.ties.iter().enumerate().filter_map(|(t, tie)| match tie {
        Tie::Slip { body, .. } if holds.get(t) != Some(&true) => {
            Some(column(Coordinate { body: *body, degree: Degree::Turn }))
        }
        _ => None,
    }));
    let reduced = rows.reduce(&free);
    let mut open = reduced.open();
    if let Some(first) = open.iter().position(|j| *j == main) {
        open.swap(0, first);
    }
    open.into_iter()
        .map(|j| {
            let part = |offset: usize| (0..bodies).map(|b| reduced.in_mode(j, 2 * b + offset)).collect();
            Mode { v: part(0), w: part(1) }
        })
        .collect()
}
