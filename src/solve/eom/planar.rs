//! Free bodies of joined bodies in the plane: Newton-Euler for each, with the force of every joint unknown, and the second
//! derivative of what each joint holds.
//!
//! For each body, x to the right, y up, turns counter-clockwise, `r` from the mass centre to the point of a force:
//!
//! ```text
//! m a = sum of forces,    I alpha = sum of r x F
//! u . (a + alpha k x r - omega^2 r) = ...      a point held along u: at rest on a pin and in a guide, as the other
//!                                              point moves at a hinge, on a circle at the end of a cord
//! ```
//! The angular velocities are those that the joints leave, in proportion to that of the leading body, so the right-hand side is
//! affine in its square, and so are all accelerations and reactions.
//! Source: Meriam & Kraige, *Engineering Mechanics: Dynamics*, articles 5/6 (relative acceleration) and 6/5 (general plane motion).
use crate::num::Real;
use crate::num::eliminate::Equations;
use crate::num::linear::{Factors, Linear};
use crate::num::plant::plant;
use crate::scene::pose::{self, Layout, Poses};
use crate::scene::{JointKind, Numbers, Rest, Scene, Spot, StrutEnd, Surface};
use crate::solve::outcome::Refusal;
use smallvec::{SmallVec, smallvec};

/// Right-hand side of the forces.
pub const CONSTANT: usize = 0;
/// Right-hand side of the centripetal terms, per square of the rate of the leading angle.
pub const SQUARE: usize = 1;

/// A vector of the plane.
type Vector<T> = [T; 2];

/// Bodies and joints in numbers.
#[derive(Debug, Clone)]
pub struct Mechanism<'a, T: Real> {
    /// The scene.
    pub scene: &'a Scene,
    /// The numbers of the scene.
    pub n: &'a Numbers<'a, T>,
    /// Index of the leading body.
    pub lead: usize,
    /// First unknown of each body: two accelerations, and an angular one if it turns.
    first: SmallVec<[usize; 3]>,
    /// First unknown of each joint.
    held: SmallVec<[usize; 4]>,
    unknowns: usize,
    layout: Layout<'a, T>,
    /// For each body: what a unit force and a unit moment make it accelerate; `None` where a body has no inertia against a turn.
    mobility: Option<SmallVec<[[T; 3]; 2]>>,
    /// Natural length of each spring.
    natural: SmallVec<[T; 2]>,
}

/// Where all bodies are, and how fast they move for a unit rate of the leading angle.
#[derive(Debug, Clone)]
pub struct State<T> {
    poses: Poses<T>,
    /// For each body: velocity of the mass centre and angular velocity counter-clockwise.
    rates: SmallVec<[[T; 3]; 2]>,
    rows: Vec<Row<T>>,
    /// What moves at unit rate with the leading angle.
    leads: Row<T>,
}

/// Accelerations and reactions at one place, affine in the square of the rate of the leading angle.
#[derive(Debug, Clone)]
pub struct Response<T> {
    /// For each unknown: constant part, and per square of the rate; `None` where the joints leave it open.
    values: Vec<Option<(T, T)>>,
    /// The leading angle's second derivative likewise.
    lead: (T, T),
}

/// What a joint holds: a row of the constraint, which is also the direction of its force.
#[derive(Debug, Clone)]
struct Row<T> {
    ends: SmallVec<[End<T>; 2]>,
    /// The joint, and the unknown of the force.
    joint: usize,
    unknown: usize,
    /// Curvature of the way of its point toward its direction.
    toward: T,
    /// Direction of friction per normal force; zero where nothing rubs.
    rubs: Vector<T>,
}

/// What a row is for one body.
#[derive(Debug, Clone)]
struct End<T> {
    body: usize,
    /// Direction of the force.
    along: Vector<T>,
    /// From the mass centre to its point, or to the centre of a wheel.
    lever: Vector<T>,
    /// Further lever: the radius at which the force acts below that centre.
    radius: T,
}

impl<T: Real> End<T> {
    fn turn(&self) -> T {
        cross(self.lever, self.along) + self.radius
    }
}

fn dot<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1]
}
fn cross<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[1] - a[1] * b[0]
}

/// The unknowns of equations that are given row by row, each with its right-hand side; `None` where they leave some open.
fn solved<T: Real>(cells: &[T], unknowns: usize) -> Option<SmallVec<[T; 8]>> {
    let rows = cells.chunks_exact(unknowns + 1);
    if rows.len() == unknowns {
        let left = rows.clone().flat_map(|row| row[..unknowns].iter().copied()).collect();
        if let Some(factors) = Factors::new(unknowns, left) {
            let right: SmallVec<[T; 8]> = rows.map(|row| row[unknowns]).collect();
            return Some(factors.solve(&right));
        }
    }
    // Joints that repeat each other, or a place near to where they do.
    let mut equations = Equations::new(unknowns);
    rows.for_each(|row| equations.row().copy_from_slice(row));
    let reduced = equations.reduce(&[]);
    (0..unknowns).map(|i| reduced.value(i)).collect()
}

impl<'a, T: Real> Mechanism<'a, T> {
    /// Reads the scene. Errors: no body leads, or joints do not place a body.
    pub fn new(scene: &'a Scene, n: &'a Numbers<'a, T>) -> Result<Self, Refusal> {
        let lead = scene.lead().ok_or(Refusal::Freedoms(0))?;
        let mut unknowns = 0;
        let mut next = |count: usize| {
            unknowns += count;
            unknowns - count
        };
        let first = scene.bodies.iter().map(|b| next(if b.turns { 3 } else { 2 })).collect();
        let held = scene.joints.iter().map(|j| next(j.kind.forces().len())).collect();
        let layout = Layout::new(scene, n).ok_or(Refusal::Freedoms(2))?;
        let one = T::of(1.0);
        let mobility = scene.bodies.iter().zip(&n.bodies).map(|(body, numbers)| {
            let mass = one / plant!("eom: mass of a body in the plane", numbers.mass);
            let turns = !body.turns || !numbers.inertia.is_zero();
            let turn = if body.turns {
                one / plant!("eom: inertia of a body in the plane", numbers.inertia)
            } else {
                T::zero()
            };
            turns.then_some([mass, mass, turn])
        });
        let mobility = mobility.collect();
        let natural = SmallVec::new();
        let mut mechanism = Self { scene, n, lead, first, held, unknowns, layout, mobility, natural };
        let start = mechanism.poses(T::zero(), true)?;
        for strut in &scene.struts {
            let length = {
                let (_, _, apart) = mechanism.strut(&start, strut.at, &strut.to);
                dot(apart, apart).root()
            };
            mechanism.natural.push(match strut.rest {
                Rest::Length(l) => n.get(l),
                Rest::Stretch(x) => length - n.get(x),
            });
        }
        Ok(mechanism)
    }

    /// Where all bodies are after this change of the leading angle, radians.
    ///
    /// Errors: joints that do not place a body.
    pub fn poses(&self, way: T, at_start: bool) -> Result<Poses<T>, Refusal> {
        self.layout.poses(way, at_start).ok_or(Refusal::Freedoms(2))
    }
    /// Angle that the leading body turns per angle that leads.
    pub fn ratio(&self) -> T {
        self.layout.ratio()
    }

    fn turns(&self, body: usize) -> bool {
        self.scene.bodies[body].turns
    }
    fn place(&self, poses: &Poses<T>, spot: Spot) -> Vector<T> {
        poses[spot.body].point(pose::of_spot(self.scene, self.n, spot)).map(|x| x.value)
    }
    fn centre(&self, poses: &Poses<T>, body: usize) -> Vector<T> {
        let along =
            self.scene.bodies[body].planar.as_ref().map_or_else(T::zero, |p| pose::along(self.n, p.centre));
        poses[body].point(along).map(|x| x.value)
    }
    /// From the mass centre to a point.
    fn lever(&self, poses: &Poses<T>, spot: Spot) -> Vector<T> {
        let (p, g) = (self.place(poses, spot), self.centre(poses, spot.body));
        [p[0] - g[0], p[1] - g[1]]
    }
    /// The far end of a spring if it is a point of a body, its lever there, and the vector to it from the near end.
    fn strut(&self, poses: &Poses<T>, at: Spot, to: &StrutEnd) -> (Option<Spot>, Vector<T>, Vector<T>) {
        let near = self.place(poses, at);
        let (far, spot) = match to {
            StrutEnd::Ground(place) => (pose::ground(self.n, *place), None),
            StrutEnd::Spot(spot) => (self.place(poses, *spot), Some(*spot)),
            StrutEnd::Guide { through_m, direction_deg } => {
                let along = pose::direction(self.n, *direction_deg);
                (pose::foot(near, pose::ground(self.n, *through_m), along), None)
            }
        };
        (spot, near, [far[0] - near[0], far[1] - near[1]])
    }

    /// The rows of all joints.
    fn rows(&self, poses: &Poses<T>) -> Vec<Row<T>> {
        let (zero, one) = (T::zero(), T::of(1.0));
        let both = [[one, zero], [zero, one]];
        let mut rows = Vec::with_capacity(self.scene.joints.len() * 2);
        let end = |spot: Spot, along: Vector<T>, radius: T| End {
            body: spot.body,
            along,
            lever: self.lever(poses, spot),
            radius,
        };
        for (joint, held) in self.scene.joints.iter().enumerate() {
            let first = self.held[joint];
            let mut add = |ends: SmallVec<[End<T>; 2]>, i: usize, toward: T| {
                rows.push(Row { ends, joint, unknown: first + i, toward, rubs: [zero; 2] });
            };
            match held.kind {
                JointKind::Pin { at, .. } => {
                    (0..2).for_each(|i| add(smallvec![end(at, both[i], zero)], i, zero));
                }
                JointKind::Hinge { one, other } => (0..2).for_each(|i| {
                    let ends = smallvec![end(one, both[i], zero), end(other, both[i].map(|x| -x), zero)];
                    add(ends, i, zero);
                }),
                JointKind::Guide { at, .. } => {
                    let [c, s] = self.layout.lines[joint];
                    add(smallvec![end(at, [-s, c], zero)], 0, zero);
                }
                JointKind::Contact { at, rolls, .. } => {
                    // The centre keeps its distance; rolling, its speed along the surface is the radius times the turn.
                    let Some(touch) = self.layout.touch(joint, self.place(poses, at)) else { continue };
                    add(smallvec![end(at, touch.normal, zero)], 0, -touch.bend);
                    if rolls {
                        let radius = plant!("eom: radius of a rolling wheel", touch.radius);
                        add(smallvec![end(at, touch.along, radius)], 1, zero);
                    }
                }
                JointKind::Cord { at, place_m } => {
                    let (near, far) = (self.place(poses, at), pose::ground(self.n, place_m));
                    let apart = [far[0] - near[0], far[1] - near[1]];
                    let length = dot(apart, apart).root();
                    add(smallvec![end(at, apart.map(|x| x / length), zero)], 0, one / length);
                }
            }
        }
        rows
    }

    /// What moves with the leading angle: the turn of the body, or its centre about the axis of a cylinder. The speed at its unit
    /// rate comes with it.
    fn leads(&self, poses: &Poses<T>) -> (Row<T>, T) {
        let zero = T::zero();
        let (end, speed) = match self.layout.arc() {
            Some(arc) => {
                let spot = self.scene.joints[arc.joint].kind.spots().next();
                let spot = spot.unwrap_or(Spot { body: self.lead, point: 0 });
                let place = self.place(poses, spot);
                let along = [(arc.axis[1] - place[1]) / arc.apart, (place[0] - arc.axis[0]) / arc.apart];
                let lever = self.lever(poses, spot);
                (End { body: self.lead, along, lever, radius: zero }, arc.apart)
            }
            None => {
                let none = [zero; 2];
                (End { body: self.lead, along: none, lever: none, radius: T::of(1.0) }, T::of(1.0))
            }
        };
        let row = Row { ends: smallvec![end], joint: 0, unknown: 0, toward: zero, rubs: [zero; 2] };
        (row, speed * self.sense(self.lead))
    }

    /// How fast everything moves for a unit rate of the leading angle, by what the joints hold.
    ///
    /// Errors: joints that leave more than that, or hold it fast.
    pub fn state(&self, way: T, moving: bool) -> Result<State<T>, Refusal> {
        let poses = self.poses(way, !moving)?;
        let bodies = self.scene.bodies.len();
        let rates: SmallVec<[[T; 3]; 2]> = smallvec![[T::zero(); 3]; bodies];
        let (leads, speed) = self.leads(&poses);
        let rows = self.rows(&poses);
        let mut state = State { poses, rates, rows, leads };
        if !moving {
            return Ok(state);
        }
        let columns: usize = self.scene.bodies.iter().map(|b| if b.turns { 3 } else { 2 }).sum();
        let width = columns + 1;
        let mut cells: SmallVec<[T; 64]> = SmallVec::new();
        for held in state.rows.iter().chain([&state.leads]) {
            let start = cells.len();
            cells.resize(start + width, T::zero());
            let row = &mut cells[start..];
            for end in &held.ends {
                let at = self.first[end.body];
                row[at] = row[at] + end.along[0];
                row[at + 1] = row[at + 1] + end.along[1];
                if self.turns(end.body) {
                    row[at + 2] =
                        row[at + 2] + plant!("eom: speed of a joint about the mass centre", end.turn());
                }
            }
        }
        let leading = cells.len() - 1;
        cells[leading] = speed;
        if let Some([c, s]) = self.drifts() {
            // Nothing pushes it along the guide: from rest its mass centre does not move that way.
            let start = cells.len() + self.first[self.lead];
            cells.resize(cells.len() + width, T::zero());
            (cells[start], cells[start + 1]) = (c, s);
        }
        let found = solved(&cells, columns).ok_or(Refusal::Freedoms(2))?;
        for (b, rate) in state.rates.iter_mut().enumerate() {
            let own = if self.turns(b) { 3 } else { 2 };
            rate[..own].copy_from_slice(&found[self.first[b]..][..own]);
        }
        Ok(state)
    }

    /// 1 where the angle of a body counts counter-clockwise, else -1.
    fn sense(&self, body: usize) -> T {
        let clockwise = self.scene.bodies[body].planar.as_ref().is_some_and(|p| p.clockwise);
        T::of(if clockwise { -1.0 } else { 1.0 })
    }

    /// The direction along which the leading body could drift, if it has one guide alone.
    fn drifts(&self) -> Option<Vector<T>> {
        self.scene.drifts().map(|direction| pose::direction(self.n, direction))
    }

    /// For each body: the forces on it and their moment about the mass centre, save those of joints.
    fn forces(&self, poses: &Poses<T>) -> SmallVec<[[T; 3]; 2]> {
        let mut forces: SmallVec<[[T; 3]; 2]> = smallvec![[T::zero(); 3]; self.n.bodies.len()];
        for (force, numbers) in forces.iter_mut().zip(&self.n.bodies) {
            force[1] = -plant!("eom: weight in the plane", numbers.mass * self.n.gravity);
        }
        let mut force = |body: usize, f: Vector<T>, r: Vector<T>| {
            let on: &mut [T; 3] = &mut forces[body];
            (on[0], on[1]) = (on[0].balance(f[0]), on[1].balance(f[1]));
            on[2] = on[2].balance(plant!("eom: moment of a force about the mass centre", cross(r, f)));
        };
        for (push, [c, s]) in self.scene.pushes.iter().zip(self.layout.pushes.iter().copied()) {
            let axis = poses[push.at.body].axis.map(|x| x.value);
            let u = if push.turns { [axis[0] * c - axis[1] * s, axis[1] * c + axis[0] * s] } else { [c, s] };
            let p = plant!("eom: force on a point", self.n.massive(push.force_n));
            force(push.at.body, u.map(|x| x * p), self.lever(poses, push.at));
        }
        for (strut, natural) in self.scene.struts.iter().zip(&self.natural) {
            let (other, _, apart) = self.strut(poses, strut.at, &strut.to);
            let stiffness =
                plant!("eom: stiffness of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            let slope = if natural.is_zero() {
                stiffness
            } else {
                stiffness - stiffness * *natural / dot(apart, apart).root()
            };
            force(strut.at.body, apart.map(|x| x * slope), self.lever(poses, strut.at));
            if let Some(other) = other {
                force(other.body, apart.map(|x| -(x * slope)), self.lever(poses, other));
            }
        }
        for c in &self.scene.couples {
            let moment = plant!("eom: moment of a couple in the plane", self.n.massive(c.moment_n_m));
            let moment = moment * self.sense(c.body);
            forces[c.body][2] = forces[c.body][2].balance(if c.forward { moment } else { -moment });
        }
        forces
    }

    /// What a row's points accelerate toward its direction by their motion alone, per square of the rate.
    fn inward(&self, state: &State<T>, row: &Row<T>) -> T {
        let mut sum = T::zero();
        for End { body, along, lever: r, .. } in &row.ends {
            let [vx, vy, spin] = state.rates[*body];
            sum = sum + dot(*along, *r) * spin.square();
            if !row.toward.is_zero() {
                // A point on a circle is drawn toward its middle by the square of its speed over the radius.
                let v = [vx - spin * r[1], vy + spin * r[0]];
                sum = sum + dot(v, v) * row.toward;
            }
        }
        plant!("eom: centripetal acceleration at a joint", sum)
    }

    /// Friction of a row per its normal force, on the body that slides.
    fn rubbing(&self, state: &State<T>, sliding: &[f64]) -> Vec<Row<T>> {
        let mut rows = state.rows.clone();
        for row in &mut rows {
            let sense = sliding[row.joint];
            if let (JointKind::Guide { mu_k: Some(mu), .. }, true) =
                (self.scene.joints[row.joint].kind, sense != 0.0)
            {
                let share = plant!("eom: kinetic friction in a guide", self.n.get(mu)).signed(-sense);
                row.rubs = self.layout.lines[row.joint].map(|x| x * share);
            }
        }
        rows
    }

    /// Force and moment of a unit reaction on a body.
    fn reacts(row: &Row<T>, end: &End<T>) -> [T; 3] {
        let (u, f) = (end.along, row.rubs);
        let turn = plant!("eom: lever of a reaction", end.turn());
        if f[0].is_zero() && f[1].is_zero() {
            return [u[0], u[1], turn];
        }
        [u[0] + f[0], u[1] + f[1], turn + cross(end.lever, f)]
    }

    /// Accelerations and reactions for these senses of sliding of each joint (0 where nothing rubs).
    ///
    /// Errors: equations that do not determine them.
    pub fn respond(&self, state: &State<T>, sliding: &[f64]) -> Result<Response<T>, Refusal> {
        let rubbing;
        let rows: &[Row<T>] = if sliding.iter().all(|s| *s == 0.0) {
            &state.rows
        } else {
            rubbing = self.rubbing(state, sliding);
            &rubbing
        };
        let forces = self.forces(&state.poses);
        let inward: SmallVec<[T; 8]> = rows.iter().map(|row| self.inward(state, row)).collect();
        let mut response = match self.eliminated(rows, &forces, &inward) {
            Some(response) => response,
            None => self.general(rows, &forces, &inward)?,
        };
        // The acceleration along what leads is that of its point, less what is due to the turn.
        let (leads, speed) = self.leads(&state.poses);
        let bend = self.inward(state, &leads);
        let part = |square: bool| {
            leads.ends.iter().fold(if square { -bend } else { T::zero() }, |sum, end| {
                let of = |i: usize| {
                    let found = response.values.get(self.first[end.body] + i).copied().flatten();
                    found.map_or_else(T::zero, |(constant, share)| if square { share } else { constant })
                };
                let mut sum = sum;
                for (i, u) in end.along.iter().enumerate().filter(|(_, u)| !u.is_zero()) {
                    sum = sum.balance(*u * of(i));
                }
                if self.turns(end.body) { sum.balance(end.turn() * of(2)) } else { sum }
            })
        };
        response.lead = (part(false) / speed, part(true) / speed);
        Ok(response)
    }

    /// Accelerations eliminated first: the reactions alone. `None` where these are not well determined.
    fn eliminated(&self, rows: &[Row<T>], forces: &[[T; 3]], inward: &[T]) -> Option<Response<T>> {
        let mobility = self.mobility.as_ref()?;
        let count = rows.len();
        let mut cells: SmallVec<[T; 64]> = smallvec![T::zero(); count * count];
        let mut rights: [SmallVec<[T; 8]>; 2] = [SmallVec::new(), inward.iter().copied().collect()];
        let held = |end: &End<T>| {
            let turn = plant!("eom: lever of an acceleration", end.turn());
            let [x, y, about] = mobility[end.body];
            [end.along[0] * x, end.along[1] * y, turn * about]
        };
        for (i, row) in rows.iter().enumerate() {
            let (mut right, mut size) = (T::zero(), 0.0);
            for end in &row.ends {
                let own = held(end);
                for (k, x) in own.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
                    let term = *x * forces[end.body][k];
                    (right, size) = (right - term, size + term.size());
                }
                for (j, other) in rows.iter().enumerate() {
                    for to in other.ends.iter().filter(|to| to.body == end.body) {
                        let force = Self::reacts(other, to);
                        let cell = &mut cells[i * count + j];
                        for (x, f) in own.iter().zip(&force).filter(|(x, f)| !x.is_zero() && !f.is_zero()) {
                            *cell = *cell + *x * *f;
                        }
                    }
                }
            }
            rights[0].push(right.cleared(size));
        }
        let factors = Factors::new(count, cells)?;
        let [constant, square] = rights.map(|right| factors.solve(&right));
        let mut values: Vec<Option<(T, T)>> = vec![Some((T::zero(), T::zero())); self.unknowns];
        for (b, force) in forces.iter().enumerate() {
            for (k, given) in force.iter().enumerate().take(if self.turns(b) { 3 } else { 2 }) {
                let (mut one, mut two) = (*given, T::zero());
                let mut sizes = (given.size(), 0.0);
                for (j, row) in rows.iter().enumerate() {
                    for end in row.ends.iter().filter(|end| end.body == b) {
                        let share = Self::reacts(row, end)[k];
                        let terms = (share * constant[j], share * square[j]);
                        (one, two) = (one + terms.0, two + terms.1);
                        sizes = (sizes.0 + terms.0.size(), sizes.1 + terms.1.size());
                    }
                }
                let per = mobility[b][k];
                values[self.first[b] + k] = Some((one.cleared(sizes.0) * per, two.cleared(sizes.1) * per));
            }
        }
        for (j, row) in rows.iter().enumerate() {
            values[row.unknown] = Some((constant[j], square[j]));
        }
        Some(Response { values, lead: (T::zero(), T::zero()) })
    }

    /// All unknowns at once, where reactions repeat each other or bodies are very unlike.
    fn general(&self, held: &[Row<T>], forces: &[[T; 3]], inward: &[T]) -> Result<Response<T>, Refusal> {
        let mut rows = Linear::new(self.unknowns, 2);
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let at = self.first[b];
            for (k, force) in forces[b].iter().enumerate().take(if self.turns(b) { 3 } else { 2 }) {
                let inertia = if k < 2 {
                    plant!("eom: mass of a body in the plane", numbers.mass)
                } else {
                    plant!("eom: inertia of a body in the plane", numbers.inertia)
                };
                rows.term(at + k, at + k, inertia);
                rows.right(at + k, CONSTANT, *force);
            }
        }
        for (row, inward) in held.iter().zip(inward) {
            for end in &row.ends {
                let (own, force) = ([end.along[0], end.along[1], end.turn()], Self::reacts(row, end));
                let at = self.first[end.body];
                for k in 0..if self.turns(end.body) { 3 } else { 2 } {
                    rows.term(at + k, row.unknown, -force[k]);
                    rows.term(row.unknown, at + k, own[k]);
                }
            }
            rows.right(row.unknown, SQUARE, *inward);
        }
        let solution = rows.solve().map_err(|s| Refusal::Singular { unknowns: s.unknowns, rank: s.rank })?;
        let mut moving = self
            .first
            .iter()
            .zip(&self.scene.bodies)
            .flat_map(|(at, b)| *at..*at + if b.turns { 3 } else { 2 });
        if moving.any(|i| solution.is_open(i)) {
            return Err(Refusal::Singular { unknowns: self.unknowns, rank: self.unknowns - 1 });
        }
        let value =
            |i: usize| (!solution.is_open(i)).then(|| (solution.get(i, CONSTANT), solution.get(i, SQUARE)));
        Ok(Response { values: (0..self.unknowns).map(value).collect(), lead: (T::zero(), T::zero()) })
    }

    /// The second derivative of the leading angle: constant part, and per square of its rate.
    pub const fn leading(&self, response: &Response<T>) -> (T, T) {
        response.lead
    }
    /// Angular acceleration of a body, as its own angle counts: constant part, and per square of the rate.
    pub fn turning(&self, response: &Response<T>, body: usize) -> (T, T) {
        let (sense, at) = (self.sense(body), self.first[body] + 2);
        let (constant, square) = response.parts(at);
        (constant * sense, square * sense)
    }
    /// Acceleration of a mass centre at this square of the rate: to the right and up.
    pub fn acceleration(&self, response: &Response<T>, body: usize, square: T) -> Vector<T> {
        [0, 1].map(|i| response.at(self.first[body] + i, square))
    }
    /// Angular velocity of a body for a unit rate, as its own angle counts.
    pub fn spin(&self, state: &State<T>, body: usize) -> T {
        state.rates[body][2] * self.sense(body)
    }
    /// Velocity of a mass centre for a unit rate.
    pub fn velocity(&self, state: &State<T>, body: usize) -> Vector<T> {
        let [x, y, _] = state.rates[body];
        [x, y]
    }
    /// Velocity of a point for a unit rate.
    pub fn speed(&self, state: &State<T>, spot: Spot) -> Vector<T> {
        let [x, y, spin] = state.rates[spot.body];
        let r = self.lever(&state.poses, spot);
        [x - spin * r[1], y + spin * r[0]]
    }
    /// Acceleration of a point from rest.
    pub fn pull_off(&self, state: &State<T>, response: &Response<T>, spot: Spot) -> Vector<T> {
        let [x, y] = self.acceleration(response, spot.body, T::zero());
        if !self.turns(spot.body) {
            return [x, y];
        }
        let (turn, _) = response.parts(self.first[spot.body] + 2);
        let r = self.lever(&state.poses, spot);
        [x - turn * r[1], y + turn * r[0]]
    }
    /// The force of a joint at this square of the rate: its components to the right and up on the first body, or along its
    /// normal, or the tension of a cord; `None` where the joints leave it open.
    pub fn reaction(&self, response: &Response<T>, joint: usize, square: T) -> Option<SmallVec<[T; 2]>> {
        let first = self.held[joint];
        let count = self.scene.joints[joint].kind.forces().len();
        (first..first + count).map(|i| response.values[i].map(|_| response.at(i, square))).collect()
    }
    /// Sum of the distances of all points from the origins of their axes, and of radii, m: what lengths and speeds are small beside.
    pub fn size(&self) -> f64 {
        let bodies = self.scene.bodies.iter().filter_map(|b| b.planar.as_ref());
        let places = bodies.flat_map(|p| p.points.iter().map(|(_, place)| *place).chain([p.centre]));
        let rods: f64 = places.map(|place| pose::along(self.n, place).size()).sum();
        let round = self.scene.joints.iter().map(|joint| match joint.kind {
            JointKind::Contact { radius_m, surface: Surface::Arc { radius_m: arc, .. }, .. } => {
                self.n.get(radius_m).size() + self.n.get(arc).size()
            }
            JointKind::Contact { radius_m, .. } => self.n.get(radius_m).size(),
            _ => 0.0,
        });
        rods + round.sum::<f64>()
    }
    /// The normal force of a guide that can only push: constant part, and per square of the rate; `None` for other joints and where
    /// the joints leave it open.
    pub fn push(&self, response: &Response<T>, joint: usize) -> Option<(T, T)> {
        self.scene.joints[joint].kind.only_pushes().then(|| response.values[self.held[joint]])?
    }
    /// Height of a mass centre.
    pub fn height(&self, state: &State<T>, body: usize) -> T {
        self.centre(&state.poses, body)[1]
    }
    /// Force of a spring, positive if it pulls.
    pub fn tension(&self, state: &State<T>, strut: usize) -> T {
        let s = &self.scene.struts[strut];
        let (_, _, apart) = self.strut(&state.poses, s.at, &s.to);
        self.n.massive(s.stiffness_n_m) * dot(apart, apart).root().balance(-self.natural[strut])
    }
}

impl<T: Real> Response<T> {
    fn parts(&self, unknown: usize) -> (T, T) {
        self.values[unknown].unwrap_or_else(|| (T::of(f64::NAN), T::of(f64::NAN)))
    }
    fn at(&self, unknown: usize, square: T) -> T {
        let (constant, by_square) = self.parts(unknown);
        constant.balance(by_square * square)
    }
}
