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
use crate::num::half::Half;
use crate::num::linear::{Linear, Solution};
use crate::num::plant::plant;
use crate::scene::pose::{self, Poses};
use crate::scene::{JointKind, Numbers, Rest, Scene, Spot, StrutEnd};
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
    /// Natural length of each spring.
    natural: SmallVec<[T; 2]>,
}

/// Where all bodies are, and how fast they move for a unit rate of the leading angle.
#[derive(Debug, Clone)]
pub struct State<T> {
    poses: Poses<T>,
    /// For each body: velocity of the mass centre and angular velocity counter-clockwise.
    rates: SmallVec<[[T; 3]; 2]>,
}

/// Accelerations and reactions at one place, affine in the square of the rate of the leading angle.
#[derive(Debug, Clone)]
pub struct Response<T> {
    solution: Solution<T>,
    sizes: SmallVec<[f64; 8]>,
}

/// What a joint holds: a row of the constraint, which is also the direction of its force.
struct Row<T> {
    /// Body, direction of the force on it, lever from its mass centre.
    ends: SmallVec<[(usize, Vector<T>, Vector<T>); 2]>,
    /// Unknown of the force.
    unknown: usize,
    /// Further right-hand side: what the centripetal acceleration toward a fixed end adds, per square of the rate.
    toward: T,
}

fn dot<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1]
}
fn cross<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[1] - a[1] * b[0]
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
        let held = scene
            .joints
            .iter()
            .map(|j| {
                next(if matches!(j.kind, JointKind::Pin { .. } | JointKind::Hinge { .. }) { 2 } else { 1 })
            })
            .collect();
        let mut mechanism = Self { scene, n, lead, first, held, unknowns, natural: SmallVec::new() };
        let start = mechanism.poses(&scene.start_angle(n), true)?;
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

    /// Where all bodies are at this angle of the leading one.
    ///
    /// Errors: joints that do not place a body.
    pub fn poses(&self, angle: &Half<T>, at_start: bool) -> Result<Poses<T>, Refusal> {
        pose::poses(self.scene, self.n, angle, at_start).ok_or(Refusal::Freedoms(2))
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
        };
        (spot, near, [far[0] - near[0], far[1] - near[1]])
    }

    /// The rows of a joint.
    fn rows(&self, poses: &Poses<T>, joint: usize) -> SmallVec<[Row<T>; 2]> {
        let (zero, one) = (T::zero(), T::of(1.0));
        let first = self.held[joint];
        let both = [[one, zero], [zero, one]];
        let row = |unknown, ends: &[(Spot, Vector<T>)], toward| Row {
            ends: ends.iter().map(|(s, u)| (s.body, *u, self.lever(poses, *s))).collect(),
            unknown,
            toward,
        };
        match self.scene.joints[joint].kind {
            JointKind::Pin { at, .. } => (0..2).map(|i| row(first + i, &[(at, both[i])], zero)).collect(),
            JointKind::Hinge { one, other } => (0..2)
                .map(|i| row(first + i, &[(one, both[i]), (other, both[i].map(|x| -x))], zero))
                .collect(),
            JointKind::Guide { at, direction_deg, .. } => {
                let [c, s] = pose::direction(self.n, direction_deg);
                smallvec![row(first, &[(at, [-s, c])], zero)]
            }
            JointKind::Cord { at, place_m } => {
                let (near, far) = (self.place(poses, at), pose::ground(self.n, place_m));
                let apart = [far[0] - near[0], far[1] - near[1]];
                let length = dot(apart, apart).root();
                // Per length: the rate at which its point moves is put in where rates are known.
                smallvec![row(first, &[(at, apart.map(|x| x / length))], T::of(1.0) / length)]
            }
        }
    }

    /// How fast everything moves for a unit rate of the leading angle, by what the joints hold.
    ///
    /// Errors: joints that leave more than that, or hold it fast.
    pub fn state(&self, angle: &Half<T>, moving: bool) -> Result<State<T>, Refusal> {
        let poses = self.poses(angle, !moving)?;
        let bodies = self.scene.bodies.len();
        let mut rates: SmallVec<[[T; 3]; 2]> = smallvec![[T::zero(); 3]; bodies];
        if !moving {
            return Ok(State { poses, rates });
        }
        let columns: usize = self.scene.bodies.iter().map(|b| if b.turns { 3 } else { 2 }).sum();
        let mut rows = Equations::new(columns);
        for joint in 0..self.scene.joints.len() {
            for held in self.rows(&poses, joint) {
                let row = rows.row();
                for (body, u, r) in &held.ends {
                    let at = self.first[*body];
                    row[at] = row[at] + u[0];
                    row[at + 1] = row[at + 1] + u[1];
                    if self.turns(*body) {
                        row[at + 2] = row[at + 2]
                            + plant!("eom: speed of a joint about the mass centre", cross(*r, *u));
                    }
                }
            }
        }
        if let Some([c, s]) = self.drifts() {
            // Nothing pushes it along the guide: from rest its mass centre does not move that way.
            let row = rows.row();
            (row[self.first[self.lead]], row[self.first[self.lead] + 1]) = (c, s);
        }
        let row = rows.row();
        row[self.first[self.lead] + 2] = T::of(1.0);
        row[columns] = self.sense(self.lead);
        let reduced = rows.reduce(&[]);
        for (b, rate) in rates.iter_mut().enumerate() {
            for (i, x) in rate.iter_mut().enumerate().take(if self.turns(b) { 3 } else { 2 }) {
                *x = reduced.value(self.first[b] + i).ok_or(Refusal::Freedoms(2))?;
            }
        }
        Ok(State { poses, rates })
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

    /// Accelerations and reactions for these senses of sliding of each joint (0 where nothing rubs).
    ///
    /// Errors: equations that do not determine them.
    pub fn respond(&self, state: &State<T>, sliding: &[f64]) -> Result<Response<T>, Refusal> {
        let poses = &state.poses;
        let mut rows = Linear::new(self.unknowns, 2);
        let mut sizes: SmallVec<[f64; 8]> = smallvec![0.0; self.unknowns];
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let at = self.first[b];
            let mass = plant!("eom: mass of a body in the plane", numbers.mass);
            rows.term(at, at, mass);
            rows.term(at + 1, at + 1, mass);
            rows.right(at + 1, CONSTANT, -plant!("eom: weight in the plane", numbers.mass * self.n.gravity));
            if self.turns(b) {
                rows.term(at + 2, at + 2, plant!("eom: inertia of a body in the plane", numbers.inertia));
            }
        }
        let mut force = |body: usize, f: Vector<T>, r: Vector<T>| {
            let at = self.first[body];
            rows.right(at, CONSTANT, f[0]);
            rows.right(at + 1, CONSTANT, f[1]);
            if self.turns(body) {
                rows.right(
                    at + 2,
                    CONSTANT,
                    plant!("eom: moment of a force about the mass centre", cross(r, f)),
                );
            }
        };
        for push in &self.scene.pushes {
            let [c, s] = pose::direction(self.n, push.direction_deg);
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
            rows.right(self.first[c.body] + 2, CONSTANT, if c.forward { moment } else { -moment });
        }
        for (joint, sliding) in sliding.iter().enumerate() {
            for held in self.rows(poses, joint) {
                let row = held.unknown;
                for (body, u, r) in &held.ends {
                    let at = self.first[*body];
                    let [vx, vy, spin] = state.rates[*body];
                    for (i, x) in u.iter().enumerate() {
                        rows.term(at + i, row, -*x);
                        rows.term(row, at + i, *x);
                    }
                    let mut inward = dot(*u, *r) * spin.square();
                    if self.turns(*body) {
                        rows.term(at + 2, row, -plant!("eom: lever of a reaction", cross(*r, *u)));
                        rows.term(row, at + 2, plant!("eom: lever of an acceleration", cross(*r, *u)));
                    }
                    if !held.toward.is_zero() {
                        // The end of a cord is drawn toward its fixed place by the square of its speed over the length.
                        let v = [vx - spin * r[1], vy + spin * r[0]];
                        inward = inward + dot(v, v) * held.toward;
                    }
                    rows.right(row, SQUARE, plant!("eom: centripetal acceleration at a joint", inward));
                }
            }
            if let (JointKind::Guide { at, direction_deg, mu_k: Some(mu), .. }, true) =
                (self.scene.joints[joint].kind, *sliding != 0.0)
            {
                let u = pose::direction(self.n, direction_deg);
                let share = plant!("eom: kinetic friction in a guide", self.n.get(mu)).signed(*sliding);
                let (own, r) = (self.first[at.body], self.lever(poses, at));
                for (i, x) in u.iter().enumerate() {
                    rows.term(own + i, self.held[joint], share * *x);
                }
                if self.turns(at.body) {
                    rows.term(own + 2, self.held[joint], share * cross(r, u));
                }
            }
        }
        let solution = rows.solve().map_err(|s| Refusal::Singular { unknowns: s.unknowns, rank: s.rank })?;
        for (i, size) in sizes.iter_mut().enumerate() {
            *size = solution.get(i, CONSTANT).size() + solution.get(i, SQUARE).size();
        }
        let mut moving = self
            .first
            .iter()
            .zip(&self.scene.bodies)
            .flat_map(|(at, b)| *at..*at + if b.turns { 3 } else { 2 });
        if moving.any(|i| solution.is_open(i)) {
            return Err(Refusal::Singular { unknowns: self.unknowns, rank: self.unknowns - 1 });
        }
        Ok(Response { solution, sizes })
    }

    /// Angular acceleration of a body, as its own angle counts: constant part, and per square of the rate.
    pub fn turning(&self, response: &Response<T>, body: usize) -> (T, T) {
        let (sense, at) = (self.sense(body), self.first[body] + 2);
        (response.solution.get(at, CONSTANT) * sense, response.solution.get(at, SQUARE) * sense)
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
        let turn = response.solution.get(self.first[spot.body] + 2, CONSTANT);
        let r = self.lever(&state.poses, spot);
        [x - turn * r[1], y + turn * r[0]]
    }
    /// The force of a joint at this square of the rate: its components to the right and up on the first body, or along its
    /// normal, or the tension of a cord; `None` where the joints leave it open.
    pub fn reaction(&self, response: &Response<T>, joint: usize, square: T) -> Option<SmallVec<[T; 2]>> {
        let first = self.held[joint];
        let count =
            if matches!(self.scene.joints[joint].kind, JointKind::Pin { .. } | JointKind::Hinge { .. }) {
                2
            } else {
                1
            };
        let known = (first..first + count).all(|i| !response.solution.is_open(i));
        known.then(|| (first..first + count).map(|i| response.at(i, square)).collect())
    }
    /// Sum of the distances of all points from the origins of their axes, m: what lengths and speeds are small beside.
    pub fn size(&self) -> f64 {
        let bodies = self.scene.bodies.iter().filter_map(|b| b.planar.as_ref());
        let places = bodies.flat_map(|p| p.points.iter().map(|(_, place)| *place).chain([p.centre]));
        places.map(|place| pose::along(self.n, place).size()).sum()
    }
    /// The normal force of a guide that can only push: constant part, and per square of the rate; `None` for other joints and where
    /// the joints leave it open.
    pub fn push(&self, response: &Response<T>, joint: usize) -> Option<(T, T)> {
        let JointKind::Guide { one_sided: true, .. } = self.scene.joints[joint].kind else { return None };
        let at = self.held[joint];
        let known = !response.solution.is_open(at);
        known.then(|| (response.solution.get(at, CONSTANT), response.solution.get(at, SQUARE)))
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
    fn at(&self, unknown: usize, square: T) -> T {
        self.solution.get(unknown, CONSTANT).balance(self.solution.get(unknown, SQUARE) * square)
    }
    /// Sum of the magnitudes of the constant part and of that per square of the rate.
    pub fn size(&self, unknown: usize) -> f64 {
        self.sizes[unknown]
    }
}
