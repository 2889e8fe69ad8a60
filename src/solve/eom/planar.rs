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
//! affine in its square, and so are all accelerations and reactions. Where one angle tells all velocities, `a = v q'' + b q'^2`
//! with the `v` and `b` of the joints, and the equations of the bodies are left for `q''` and the forces. Times `v` these fall out
//! where nothing rubs: `(sum of m v^2) q'' = sum of F . v` while the rate is 0.
//! Source: Meriam & Kraige, *Engineering Mechanics: Dynamics*, articles 5/6 (relative acceleration) and 6/5 (general plane motion).
use crate::num::Real;
use crate::num::eliminate::{Equations, Reduced};
use crate::num::half::Half;
use crate::num::linear::{Factors, Linear};
use crate::num::plant::plant;
use crate::num::{root, shares};
use crate::scene::pose::{self, Layout, Obstacle, dot};
use crate::scene::{Acts, Degree, JointKind, Num, Numbers, Rest, Scene, Spot, StrutEnd, Surface};
use crate::solve::outcome::{self, Refusal};
use smallvec::{SmallVec, smallvec};
use std::cell::RefCell;

/// A point that is farther below a surface than this share of the size of everything has passed through it.
const PIERCED: f64 = 1e-9;

/// A speed that is told may be off by this share from what the joints make of the others: by the rounding of the doubles that they are
/// printed as, not by that of a few figures.
const LOOSE: f64 = 1e-12;

/// Right-hand side of the forces.
pub const CONSTANT: usize = 0;
/// Right-hand side of the centripetal terms, per square of the rate of the leading angle.
pub const SQUARE: usize = 1;

type Vector<T> = [T; 2];
/// One for each named point of a body.
type Levers<T> = SmallVec<[Vector<T>; 4]>;

/// Bodies and joints in numbers.
#[derive(Debug, Clone)]
pub struct Mechanism<'a, T: Real> {
    /// The scene.
    pub scene: &'a Scene,
    /// The numbers of the scene.
    pub n: &'a Numbers<'a, T>,
    /// Index of the leading body.
    pub lead: usize,
    /// First velocity of each body: two of its mass centre, and an angular one if it turns.
    first: SmallVec<[usize; 3]>,
    /// First row of each joint.
    held: SmallVec<[usize; 4]>,
    /// How many velocities there are.
    columns: usize,
    /// How the bodies are placed.
    pub layout: Layout<'a, T>,
    /// Where nothing pushes it along its guide: the direction of that.
    drift: Option<Vector<T>>,
    /// For each body: how far its mass centre is along its axis, and its points from there, along the axis and to its left.
    levers: SmallVec<[(T, Levers<T>); 3]>,
    /// Room for the equations of the bodies, which are made anew at each place.
    factors: RefCell<Factors<T>>,
}

type Poses<T> = pose::Poses<T>;
/// Velocity or acceleration of each mass centre, and of each turn, counter-clockwise; or force and moment.
pub type Rates<T> = SmallVec<[[T; 3]; 3]>;

/// Where all bodies are, and how fast they move for a unit rate of the leading angle.
#[derive(Debug, Clone)]
pub struct State<T> {
    /// How the bodies lie.
    pub poses: Poses<T>,
    /// Their velocities for that.
    pub rates: Rates<T>,
    /// What the joints hold, and that nothing drifts where only that holds it.
    rows: Vec<Row<T>>,
    /// What moves with the leading angle at its unit rate, and how fast.
    leads: (Row<T>, T),
    /// Factors of the rows as conditions of the velocities, the leading one last.
    kinematics: Factors<T>,
    /// Do these determine all velocities?
    determined: bool,
}

/// Accelerations and reactions at one place, affine in the square of the rate of the leading angle.
#[derive(Debug, Clone)]
pub struct Response<T> {
    /// For each row: constant part of its force, and per square of the rate; `None` where the joints leave it open.
    forces: SmallVec<[Option<(T, T)>; 8]>,
    /// The leading angle's second derivative likewise.
    pub lead: (T, T),
    /// Accelerations: constant part, which is that from rest, and per square of the rate.
    pub moves: [Rates<T>; 2],
}

/// The response of what is driven, and the couple of the drive likewise.
pub type Driven<T> = (Response<T>, Option<(T, T)>);

/// What a joint holds: a row of the constraint, which is also the direction of its force.
#[derive(Debug, Clone, Copy)]
struct Row<T> {
    /// One, or at a hinge two.
    ends: ([End<T>; 2], usize),
    /// The joint; beyond the last one for what no joint holds.
    joint: usize,
    /// Curvature of the way of the point at each end toward its direction.
    toward: [T; 2],
    /// Does it keep its point at a line that another body carries, and turns?
    turns: bool,
    /// A body that turns under its point and bears the opposite force: it does not move the surface.
    bears: Option<End<T>>,
    /// Friction to the right of its direction per normal force.
    rubs: T,
}

/// What a row is for one body.
#[derive(Debug, Clone, Copy)]
struct End<T> {
    body: usize,
    /// Direction of the force.
    along: Vector<T>,
    /// From the mass centre to its point, or to the centre of a wheel.
    lever: Vector<T>,
    /// Further lever: the radius at which the force acts below that centre.
    radius: T,
    /// The radius below it at which the friction of a normal force acts.
    rim: T,
}

impl<T: Real> End<T> {
    /// At a point.
    fn new(body: usize, along: Vector<T>, lever: Vector<T>) -> Self {
        Self { body, along, lever, radius: T::zero(), rim: T::zero() }
    }
    /// Of a body that turns alone.
    fn turning(body: usize, radius: T) -> Self {
        Self { radius, ..Self::new(body, [T::zero(); 2], [T::zero(); 2]) }
    }
    fn turn(&self) -> T {
        cross(self.lever, self.along) + self.radius
    }
}

impl<T: Real> Row<T> {
    fn new(joint: usize, one: End<T>, other: Option<End<T>>, toward: T) -> Self {
        let ends = ([one, other.unwrap_or(one)], 1 + usize::from(other.is_some()));
        Self { ends, joint, toward: [toward; 2], turns: false, bears: None, rubs: T::zero() }
    }
    fn ends(&self) -> &[End<T>] {
        &self.ends.0[..self.ends.1]
    }
    /// On what its force acts.
    fn loaded(&self) -> impl Iterator<Item = &End<T>> {
        self.ends().iter().chain(&self.bears)
    }
}

fn cross<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[1] - a[1] * b[0]
}

impl<'a, T: Real> Mechanism<'a, T> {
    /// Reads the scene. Errors: no body leads, or joints do not place a body.
    pub fn new(scene: &'a Scene, n: &'a Numbers<'a, T>) -> Result<Self, Refusal> {
        let lead = scene.lead().ok_or(Refusal::Freedoms(0))?;
        let sums = |sum: &mut usize, count: usize| {
            *sum += count;
            Some(*sum - count)
        };
        let first = scene.bodies.iter().map(|b| if b.turns { 3 } else { 2 });
        let held = scene.joints.iter().map(|j| j.kind.forces().len());
        let levers = |body: usize| {
            let planar = scene.bodies[body].planar.as_ref();
            let centre = planar.map_or_else(T::zero, |p| pose::along(n, p.centre));
            let spots = (0..planar.map_or(0, |p| p.points.len())).map(|point| Spot { body, point });
            let places = spots.map(|spot| pose::of_spot(scene, n, spot));
            (centre, places.map(|[along, aside]| [along - centre, aside]).collect())
        };
        let mut layout = Layout::new(scene, n).ok_or_else(|| outcome::unplaced(scene, lead))?;
        if !T::is_double() {
            if let Some(crossed) = layout.choices().into_iter().find(|choice| choice.crossed) {
                return Err(Refusal::Crossed(crossed));
            }
            if let Some((body, with)) = layout.idle_side() {
                return Err(Refusal::IdleSide { body, with });
            }
        }
        if layout.measure_springs().is_none() {
            return Err(outcome::unplaced(scene, layout.unplaced(true).unwrap_or(lead)));
        }
        Ok(Self {
            scene,
            n,
            lead,
            columns: first.clone().sum(),
            first: first.scan(0, sums).collect(),
            held: held.scan(0, sums).collect(),
            layout,
            drift: scene.drifts().map(|direction| pose::direction(n, direction)),
            levers: (0..scene.bodies.len()).map(levers).collect(),
            factors: RefCell::new(Factors::none()),
        })
    }

    /// Where all bodies are after this change of the leading angle, radians.
    ///
    /// Errors: joints that do not place a body.
    pub fn poses(&self, way: T, at_start: bool) -> Result<Poses<T>, Refusal> {
        self.layout
            .poses(way, at_start)
            .ok_or_else(|| outcome::unplaced(self.scene, self.layout.unplaced(at_start).unwrap_or(self.lead)))
    }
    /// Rate of the leading angle at the start. Errors: a speed of what does not move with it.
    pub fn start_rate(&self) -> Result<T, Refusal> {
        let Some((of, given)) = self.scene.start_speeds().next() else { return Ok(T::zero()) };
        if let Some(rate) = self.layout.start_rate() {
            return Ok(rate);
        }
        self.poses(T::zero(), false)?;
        Err(Refusal::Contradiction { of, given: self.n.get(given).f64(), follows: 0.0 })
    }

    fn turns(&self, body: usize) -> bool {
        self.scene.bodies[body].turns
    }
    /// Where a mass centre is.
    pub fn centre(&self, poses: &Poses<T>, body: usize) -> Vector<T> {
        poses[body].point([self.levers[body].0, T::zero()])
    }
    /// From the mass centre to a point.
    fn lever(&self, poses: &Poses<T>, spot: Spot) -> Vector<T> {
        let (centre, points) = &self.levers[spot.body];
        let [apart, aside] = points.get(spot.point).copied().unwrap_or([-*centre, T::zero()]);
        let [c, s] = poses[spot.body].axis;
        if aside.is_zero() {
            return [c * apart, s * apart];
        }
        [c * apart - s * aside, s * apart + c * aside]
    }

    fn rows(&self, poses: &Poses<T>, rows: &mut Vec<Row<T>>) {
        let (zero, one) = (T::zero(), T::of(1.0));
        let (both, one_turn) = ([[one, zero], [zero, one]], one);
        let end = |spot: Spot, along: Vector<T>, radius: T| End {
            radius,
            ..End::new(spot.body, along, self.lever(poses, spot))
        };
        rows.clear();
        for (joint, held) in self.scene.joints.iter().enumerate() {
            match held.kind {
                JointKind::Pin { at, .. } => {
                    let end = end(at, both[0], zero);
                    for along in both {
                        rows.push(Row::new(joint, End { along, ..end }, None, zero));
                    }
                }
                JointKind::Hinge { one, other, turned_deg } => {
                    let (one, other) = (end(one, both[0], zero), end(other, both[0], zero));
                    for along in both {
                        let back = End { along: along.map(|x| -x), ..other };
                        rows.push(Row::new(joint, End { along, ..one }, Some(back), zero));
                    }
                    if turned_deg.is_some() {
                        let turn = plant!("eom: turn of a weld", -one_turn);
                        let [one, other] = [(one, one_turn), (other, turn)].map(|(end, radius)| End {
                            along: [zero; 2],
                            radius,
                            ..end
                        });
                        rows.push(Row::new(joint, one, Some(other), zero));
                    }
                }
                JointKind::Guide { at, .. } | JointKind::Contact { at, .. } => {
                    // The centre keeps its distance; rolling, its speed along the surface is the radius times the turn.
                    let line = self.layout.line(joint, poses);
                    let Some(touch) = self.layout.touch(joint, self.layout.spot(at, poses), line) else {
                        continue;
                    };
                    let [rolls, teeth] = held.kind.rolls();
                    if !teeth {
                        let rim = plant!("eom: radius at which a wheel rubs", touch.rim);
                        let normal = End { rim, ..end(at, touch.normal, zero) };
                        let (one, other) = self.against(joint, poses, normal);
                        let (other, bears) =
                            if held.kind.drum().is_none() { (other, None) } else { (None, other) };
                        let turns = other.is_some();
                        rows.push(Row { turns, bears, ..Row::new(joint, one, other, -touch.bend) });
                    }
                    if rolls {
                        let radius = plant!("eom: radius of a rolling wheel", touch.radius);
                        let (one, other) = self.against(joint, poses, end(at, touch.along, radius));
                        rows.push(Row::new(joint, one, other, zero));
                    }
                }
                JointKind::Cord { at, place_m, beyond, .. } => {
                    let tied = |(at, place_m)| {
                        let (along, length) = self.layout.toward(poses, at, place_m);
                        (end(at, along, zero), one / length)
                    };
                    let ((near, bend), far) = (tied((at, place_m)), beyond.map(tied));
                    let toward =
                        [bend, far.map_or(zero, |(_, bend)| plant!("eom: other end of a cord", bend))];
                    rows.push(Row { toward, ..Row::new(joint, near, far.map(|(end, _)| end), bend) });
                }
            }
        }
    }

    /// What a row is for the body that moves on a line, and for that which carries the line: the opposite force at the same place.
    fn against(&self, joint: usize, poses: &Poses<T>, one: End<T>) -> (End<T>, Option<End<T>>) {
        let Some(on) = self.scene.joints[joint].kind.bearer() else { return (one, None) };
        let [own, its] = [one.body, on.body].map(|body| self.centre(poses, body));
        let apart = [own[0] - its[0], own[1] - its[1]];
        let lever = [one.lever[0] + apart[0], one.lever[1] + apart[1]];
        let along = one.along.map(|x| plant!("eom: force on what carries a line", -x));
        let other = End { body: on.body, along, lever, radius: -one.radius, rim: -one.rim };
        (one, Some(other))
    }

    /// What moves with the leading angle: the turn of the body, or its centre about the axis of a cylinder; or its way along guides. The
    /// speed at its unit rate comes with it.
    fn leads(&self, poses: &Poses<T>) -> (Row<T>, T) {
        let (lead, one) = (self.lead, T::of(1.0));
        let (end, speed) = if let Some(arc) = self.layout.arc() {
            let spot = self.scene.joints[arc.joint].kind.spots().next();
            let spot = spot.unwrap_or(Spot { body: lead, point: 0 });
            let place = self.layout.spot(spot, poses);
            let along = [(arc.axis[1] - place[1]) / arc.apart, (place[0] - arc.axis[0]) / arc.apart];
            (End::new(lead, along, self.lever(poses, spot)), arc.apart.signed(self.scene.sense(lead)))
        } else if let Some(along) = self.layout.glide() {
            (End::new(lead, along, [T::zero(); 2]), one)
        } else {
            (End::turning(lead, one), one.signed(self.scene.sense(lead)))
        };
        (Row::new(0, end, None, T::zero()), speed)
    }

    /// How fast everything moves for a unit rate of the leading angle, by what the joints hold.
    ///
    /// Errors: joints that leave more than that, or hold it fast.
    pub fn state(&self, way: T, moving: bool) -> Result<State<T>, Refusal> {
        let poses = self.poses(way, !moving)?;
        let at_start = way.is_zero();
        self.fits(&poses, !moving, at_start)?;
        let rates = smallvec![[T::zero(); 3]; self.scene.bodies.len()];
        let leads = self.leads(&poses);
        let rows = Vec::with_capacity(self.columns);
        let mut state = State { poses, rates, rows, leads, kinematics: Factors::none(), determined: false };
        self.look(&mut state, moving).map_err(self.in_place(way))?;
        Ok(state)
    }

    /// How everything moves at the start by the speeds that are told of several freedoms, and the rate in units of which that is: the
    /// fastest turn.
    ///
    /// Errors: speeds that leave a freedom open, or that the joints contradict.
    pub fn told(&self) -> Result<(State<T>, T), Refusal> {
        let mut state = self.state(T::zero(), false)?;
        let (mut rows, zero) = (state.rows.clone(), T::zero());
        let mut speeds: Vec<T> = rows.iter().map(|_| zero).collect();
        for (of, number) in self.scene.start_speeds() {
            let (one, other) = match of.degree {
                Degree::Turn => (End::turning(of.body, T::of(self.scene.sense(of.body))), None),
                Degree::Along => {
                    let (joint, at) = self.scene.guide_of(of.body).ok_or(Refusal::Open(of))?;
                    let along = self.layout.told_along(joint, &state.poses);
                    self.against(joint, &state.poses, End::new(of.body, along, self.lever(&state.poses, at)))
                }
            };
            rows.push(Row::new(0, one, other, zero));
            speeds.push(self.n.get(number));
            let (given, lacks) = (speeds[speeds.len() - 1].f64(), self.lacks(&rows, &speeds));
            if lacks.abs() > LOOSE * given.abs() {
                return Err(Refusal::Contradiction { of, given, follows: given - lacks });
            }
        }
        let reduced = self.equations(&rows, &speeds).reduce(&[]);
        let open = self.scene.start_speeds().count() + self.columns - reduced.rank();
        let found = self.found(&reduced).ok_or(Refusal::Freedoms(open))?;
        self.per_body(&found, &mut state.rates);
        let turns = |rate: &[T; 3]| (rate[0].size().max(rate[1].size()) / self.size()).max(rate[2].size());
        let fastest = state.rates.iter().map(turns).filter(|turn| turn.is_finite()).fold(0.0, f64::max);
        if fastest > 0.0 {
            state.rates.iter_mut().flatten().for_each(|rate| *rate = *rate / T::of(fastest));
        }
        Ok((state, T::of(fastest)))
    }

    /// By how much the last speed is more than the rows before it say, where they say it.
    fn lacks(&self, rows: &[Row<T>], speeds: &[T]) -> f64 {
        let reduced = self.equations(rows, speeds).reduce(&[]);
        if reduced.repeats() { 0.0 } else { reduced.lacks().f64() }
    }

    /// Do the bodies lie as the joints and the data say?
    ///
    /// Errors: one that does not bridge what holds it, a joint that does not hold, an angle at the start that is another.
    fn fits(&self, poses: &Poses<T>, still: bool, at_start: bool) -> Result<(), Refusal> {
        if let Some(gap) = self.layout.unbridged(poses, still) {
            return Err(Refusal::Unbridged { gap, at_start });
        }
        if let Some((joint, off_m)) = self.layout.parted(poses, at_start) {
            return Err(Refusal::Parted { joint, off_m, at_start });
        }
        if let Some(body) = (0..self.scene.bodies.len()).find(|b| at_start && self.is_hollow(poses, *b)) {
            return Err(Refusal::Hollow(body));
        }
        match at_start.then(|| self.layout.tilted(poses)).flatten() {
            Some((body, [given_deg, follows_deg])) => Err(Refusal::Tilted { body, given_deg, follows_deg }),
            None => Ok(()),
        }
    }

    /// Is more taken away from a body than there is of it, in mass or about the common mass centre?
    fn is_hollow(&self, poses: &Poses<T>, body: usize) -> bool {
        let own = &self.n.bodies[body];
        let (mut mass, mut moment, mut inertia, mut any) = (own.mass, [T::zero(); 2], own.inertia, false);
        for hole in self.scene.holes(body) {
            let (numbers, off) =
                (&self.n.bodies[hole], pose::less(self.centre(poses, hole), self.centre(poses, body)));
            any = true;
            mass = mass + numbers.mass;
            moment = [0, 1].map(|i| moment[i] + numbers.mass * off[i]);
            inertia = inertia + numbers.inertia + numbers.mass * dot(off, off);
        }
        any && !(mass.f64() > 0.0 && (inertia - dot(moment, moment) / mass).f64() > 0.0)
    }

    /// [`Self::state`] in the place of another one of a motion.
    ///
    /// Errors: those of it.
    pub fn next(&self, way: T, state: &mut State<T>) -> Result<(), Refusal> {
        state.poses = self.poses(way, false)?;
        state.leads = self.leads(&state.poses);
        self.look(state, true).map_err(self.in_place(way))
    }

    /// Turns a single body on a pin to this angle.
    ///
    /// Errors: those of [`Self::state`].
    pub fn turn_to(&self, state: &mut State<T>, angle: &Half<T>) -> Result<(), Refusal> {
        let Some(planar) = self.scene.planar(self.lead) else { return Ok(()) };
        let [x, y] = planar.from.components().map(T::of);
        let (c, s) = (angle.full_cosine(), angle.full_sine().signed(self.scene.sense(self.lead)));
        state.poses[self.lead].axis = [(x * c).balance(-(y * s)), (y * c).balance(x * s)];
        state.leads = self.leads(&state.poses);
        self.look(state, true)
    }

    /// Says why there: where rods lie in one line, nothing tells how they go on.
    fn in_place(&self, way: T) -> impl Fn(Refusal) -> Refusal {
        move |why| match why {
            Refusal::Freedoms(_) => self.layout.in_line(way).map_or(why, Refusal::Beyond),
            why => why,
        }
    }

    /// Fills in what follows from the poses.
    fn look(&self, state: &mut State<T>, moving: bool) -> Result<(), Refusal> {
        self.rows(&state.poses, &mut state.rows);
        if !moving {
            return Ok(());
        }
        if let Some(along) = self.drift {
            // From rest its mass centre does not move that way.
            let end = End::new(self.lead, along, [T::zero(); 2]);
            state.rows.push(Row::new(self.scene.joints.len(), end, None, T::zero()));
        }
        let (columns, count) = (self.columns, state.rows.len() + 1);
        let mut speeds: SmallVec<[T; 12]> = smallvec![T::zero(); count];
        speeds[count - 1] = state.leads.1;
        state.determined = count == columns && {
            state.kinematics.room(columns);
            let rows = state.rows.iter().chain([&state.leads.0]).enumerate();
            rows.for_each(|(r, held)| self.speeds(held, |at, x| state.kinematics.add(r, at, x)));
            state.kinematics.reduce()
        };
        if state.determined {
            state.kinematics.solve(&mut speeds);
        } else {
            // Joints that repeat each other, or a place near to where they do.
            let rows: Vec<Row<T>> = state.rows.iter().chain([&state.leads.0]).copied().collect();
            let reduced = self.equations(&rows, &speeds).reduce(&[]);
            speeds = self.found(&reduced).ok_or_else(|| Refusal::Freedoms(columns + 1 - reduced.rank()))?;
        }
        self.per_body(&speeds, &mut state.rates);
        Ok(())
    }

    /// Rows as conditions of the velocities, and the speeds along them.
    fn equations(&self, rows: &[Row<T>], speeds: &[T]) -> Equations<T> {
        let mut equations = Equations::new(self.columns);
        for (held, speed) in rows.iter().zip(speeds) {
            let row = equations.row();
            self.speeds(held, |at, x| row[at] = row[at] + x);
            row[self.columns] = *speed;
        }
        equations
    }

    /// All velocities, if none is open.
    fn found(&self, reduced: &Reduced<T>) -> Option<SmallVec<[T; 12]>> {
        (0..self.columns).map(|i| reduced.value(i)).collect()
    }

    /// What a row makes of the velocities: of each that it holds its place among all, and its share.
    fn speeds(&self, held: &Row<T>, mut tell: impl FnMut(usize, T)) {
        for end in held.ends() {
            let at = self.first[end.body];
            tell(at, end.along[0]);
            tell(at + 1, end.along[1]);
            if self.turns(end.body) {
                tell(at + 2, plant!("eom: speed of a joint about the mass centre", end.turn()));
            }
        }
    }

    /// Sorts velocities or accelerations by bodies.
    fn per_body(&self, all: &[T], rates: &mut Rates<T>) {
        for (b, rate) in rates.iter_mut().enumerate() {
            let own = if self.turns(b) { 3 } else { 2 };
            rate[..own].copy_from_slice(&all[self.first[b]..][..own]);
        }
    }

    /// Twice the kinetic energy at unit rate of the leading angle.
    pub fn inertia(&self, state: &State<T>) -> T {
        let mut sum = T::zero();
        for (numbers, [x, y, turn]) in self.n.bodies.iter().zip(&state.rates) {
            sum = sum + numbers.mass * (x.square() + y.square()) + numbers.inertia * turn.square();
        }
        sum
    }

    /// The direction along the surface of a joint, that to the right of its normal.
    pub fn line(&self, state: &State<T>, joint: usize) -> Vector<T> {
        match self.row_of(state, joint) {
            Some(Row { ends: ([end, _], _), .. }) => [end.along[1], -end.along[0]],
            None => [T::zero(); 2],
        }
    }
    fn row_of<'s>(&self, state: &'s State<T>, joint: usize) -> Option<&'s Row<T>> {
        state.rows.get(self.held[joint])
    }
    /// How fast a body slides along the surface of a joint, by the velocities (or accelerations from rest) of mass centres and turns.
    pub fn slip(&self, state: &State<T>, joint: usize, moves: &Rates<T>) -> T {
        let ends = self.row_of(state, joint).into_iter().flat_map(Row::loaded);
        ends.fold(T::zero(), |slip, end| {
            let ([x, y, turn], along) = (moves[end.body], [end.along[1], -end.along[0]]);
            let rim = cross(end.lever, along).balance(end.rim);
            slip.balance(x * along[0]).balance(y * along[1]).balance(rim * turn)
        })
    }

    /// For each body: the forces on it and their moment about the mass centre, save those of joints; or the impulses of blows.
    fn forces(&self, poses: &Poses<T>, blows: bool) -> Rates<T> {
        let mut forces: Rates<T> = smallvec![[T::zero(); 3]; self.n.bodies.len()];
        if !blows {
            for (force, numbers) in forces.iter_mut().zip(&self.n.bodies) {
                force[1] = -plant!("eom: weight in the plane", numbers.mass * self.n.gravity);
                // Seen from what carries it, a body is held back as by a weight.
                for (force, a) in force.iter_mut().zip(self.n.carried.iter().flatten()) {
                    *force = force.balance(-plant!("eom: inertia in the plane", numbers.mass * *a));
                }
            }
        }
        let mut force = |body: usize, f: Vector<T>, r: Vector<T>| {
            let on: &mut [T; 3] = &mut forces[body];
            (on[0], on[1]) = (on[0].balance(f[0]), on[1].balance(f[1]));
            on[2] = on[2].balance(plant!("eom: moment of a force about the mass centre", cross(r, f)));
        };
        for (i, push) in self.scene.pushes.iter().enumerate().filter(|(_, push)| push.blow == blows) {
            let p = plant!("eom: force on a point", self.n.massive(push.force_n));
            let along = self.layout.push(poses, i).map(|x| x * p);
            force(push.at.body, along, self.lever(poses, push.at));
        }
        if blows {
            for (b, before) in self.before(poses).into_iter().enumerate() {
                for (k, inertia) in self.inertias(b).into_iter().enumerate() {
                    forces[b][k] = forces[b][k].balance(inertia * before[k]);
                }
            }
            return forces;
        }
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.layout.natural).enumerate() {
            if strut.twists() || strut.acts != Acts::Both && self.stretch(poses, s).is_zero() {
                continue;
            }
            let apart = self.layout.span(poses, s);
            let stiffness =
                plant!("eom: stiffness of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            let slope = if natural.is_zero() {
                stiffness
            } else {
                stiffness - stiffness * *natural / dot(apart, apart).root()
            };
            force(strut.at.body, apart.map(|x| x * slope), self.lever(poses, strut.at));
            if let StrutEnd::Spot(other) = strut.to {
                force(other.body, apart.map(|x| -(x * slope)), self.lever(poses, other));
            }
        }
        for (s, strut) in self.scene.struts.iter().enumerate().filter(|(_, strut)| strut.twists()) {
            let stiffness = plant!("eom: stiffness of a torsion spring", self.n.massive(strut.stiffness_n_m));
            let moment = -(stiffness * self.stretch(poses, s)).signed(self.scene.sense(strut.at.body));
            forces[strut.at.body][2] = forces[strut.at.body][2].balance(moment);
        }
        for c in &self.scene.couples {
            let moment = plant!("eom: moment of a couple in the plane", self.n.massive(c.moment_n_m));
            let moment = moment.signed(self.scene.sense(c.body));
            forces[c.body][2] = forces[c.body][2].balance(c.signed(moment));
        }
        forces
    }

    /// What a row's points accelerate toward its direction by their motion alone, per square of the rate.
    fn inward(&self, state: &State<T>, row: &Row<T>) -> T {
        let mut sum = T::zero();
        for (End { body, along, lever: r, .. }, toward) in row.ends().iter().zip(row.toward) {
            let [vx, vy, spin] = state.rates[*body];
            sum = sum + dot(*along, *r) * spin.square();
            let v = [vx - spin * r[1], vy + spin * r[0]];
            if !toward.is_zero() {
                // A point is drawn toward the middle of its circle by the square of its speed about it over the radius.
                sum = sum + cross(*along, v).square() * toward;
            }
            if row.turns {
                // Coriolis: what moves along the line turns with it.
                let carrier = state.rates[row.ends.0[1].body][2];
                let along = v[0] * along[1] - v[1] * along[0];
                sum = sum + plant!("eom: Coriolis acceleration", (carrier * along).scale2(1));
            }
        }
        plant!("eom: centripetal acceleration at a joint", sum)
    }

    /// Friction of a row per its normal force, on the body that slides.
    fn rubbing(&self, state: &State<T>, sliding: &[f64]) -> Vec<Row<T>> {
        let mut rows = state.rows.clone();
        for row in &mut rows {
            let Some(sense) = sliding.get(row.joint).copied() else { continue };
            if let Some(mu) = self.scene.joints[row.joint].kind.mu_k().filter(|_| sense != 0.0) {
                let share = plant!("eom: kinetic friction in a guide", self.n.get(mu)).signed(-sense);
                row.rubs = share;
            }
        }
        rows
    }

    /// Force and moment of a unit reaction on a body.
    fn reacts(row: &Row<T>, end: &End<T>) -> [T; 3] {
        let (u, rubs) = (end.along, row.rubs);
        let turn = plant!("eom: lever of a reaction", end.turn());
        if rubs.is_zero() {
            return [u[0], u[1], turn];
        }
        let f = [u[1] * rubs, -u[0] * rubs];
        [u[0] + f[0], u[1] + f[1], turn + cross(end.lever, f) + end.rim * rubs]
    }

    /// The sum of the forces times the velocities for a unit rate of the leading angle, where nothing rubs.
    pub fn drive(&self, state: &State<T>) -> T {
        self.drive_of_terms(state).0
    }

    /// The same with the magnitudes of its terms.
    pub fn drive_of_terms(&self, state: &State<T>) -> (T, f64) {
        let forces = self.forces(&state.poses, false);
        let terms = forces.iter().flatten().zip(state.rates.iter().flatten());
        let (mut sum, mut size) = (T::zero(), 0.0);
        for (force, rate) in terms.filter(|(force, rate)| !force.is_nothing() && !rate.is_nothing()) {
            let power = *force * *rate;
            (sum, size) = (sum + power, size + power.size());
        }
        (sum.cleared(size), size)
    }

    /// Moment about the mass centre of a body of all forces on it but those of joints, as its own angle counts.
    pub fn moment(&self, state: &State<T>, body: usize) -> T {
        self.forces(&state.poses, false)[body][2].signed(self.scene.sense(body))
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
        self.answer(state, rows, &self.forces(&state.poses, false), true)
    }

    /// The jumps of all velocities by the blows at the start, and the impulses of the joints: the same equations with impulses for
    /// forces, and nothing that moves on a bend in no time.
    ///
    /// Errors: as for [`Self::respond`].
    pub fn struck(&self, state: &State<T>) -> Result<Response<T>, Refusal> {
        let mut after = self.answer(state, &state.rows, &self.forces(&state.poses, true), false)?;
        if let Some((joint, e)) = self.scene.restitution {
            if let Some(parts) = self.parts_before(state, joint) {
                return Err(parts);
            }
            // What the joints would give if they held, and as much again for each part that springs back.
            let e = plant!("eom: restitution", self.n.get(e));
            let back = |x: T, before: T| x.balance(e * (x - before));
            let impulses = after.forces.iter_mut().flatten();
            impulses.for_each(|(impulse, _)| *impulse = back(*impulse, T::zero()));
            let before = self.before(&state.poses);
            let velocities = after.moves[0].iter_mut().flatten().zip(before.iter().flatten());
            velocities.for_each(|(v, before)| *v = back(*v, *before));
        }
        Ok(after)
    }
    /// Why not, if a joint other than this one does not allow how the bodies move just before an impact.
    fn parts_before(&self, state: &State<T>, impact: usize) -> Option<Refusal> {
        let mut before: SmallVec<[T; 12]> = smallvec![T::zero(); self.columns];
        for (b, v) in self.before(&state.poses).into_iter().enumerate() {
            let own = if self.turns(b) { 3 } else { 2 };
            before[self.first[b]..][..own].copy_from_slice(&v[..own]);
        }
        let fastest: f64 = before.iter().map(|v| v.size()).sum();
        state.rows.iter().filter(|row| row.joint != impact).find_map(|row| {
            let mut speed = T::zero();
            self.speeds(row, |at, x| speed = speed + x * before[at]);
            let parts = speed.size() > PIERCED * fastest * (1.0 + self.size());
            let turn = row.ends()[0].along.iter().all(|x| x.is_nothing());
            let degree = if turn { Degree::Turn } else { Degree::Along };
            parts.then_some(Refusal::PartedBefore { joint: row.joint, speed: speed.size(), degree })
        })
    }
    /// The velocities of bodies just before an impact: of the mass centre, and of the turn.
    fn before(&self, poses: &Poses<T>) -> Rates<T> {
        let mut before: Rates<T> = smallvec![[T::zero(); 3]; self.n.bodies.len()];
        for (b, arrives) in self.scene.arrivals() {
            let spin = plant!(
                "eom: spin before an impact",
                self.n.get(arrives.spin_rad_s).signed(self.scene.sense(b))
            );
            let speed = plant!("eom: speed before an impact", self.n.get(arrives.speed_m_s));
            let [c, s] = pose::direction(self.n, arrives.direction_deg);
            let pin = self.scene.turns_about((b, arrives));
            let [x, y] = pin.map_or([T::zero(); 2], |pin| self.lever(poses, pin));
            before[b] = [c * speed + spin * y, s * speed - spin * x, spin];
        }
        before
    }
    /// The state with the velocities that the bodies have after a blow: those at this rate before it, and their jumps.
    pub fn after(&self, mut state: State<T>, rate: T, jumps: &Response<T>) -> State<T> {
        for (v, jump) in state.rates.iter_mut().flatten().zip(jumps.moves[0].iter().flatten()) {
            *v = (*v * rate).balance(*jump);
        }
        state
    }

    /// The response with the couple on the leading body that gives it this angular acceleration, and that couple: one more row, whose
    /// second derivative is given.
    ///
    /// Errors: as for [`Self::respond`].
    pub fn driven(&self, state: &State<T>, sliding: &[f64], alpha: T) -> Result<Driven<T>, Refusal> {
        let mut rows = self.rubbing(state, sliding);
        let sense = plant!("eom: couple of a drive", T::of(self.scene.sense(self.lead)));
        let turn = End::turning(self.lead, sense);
        rows.push(Row::new(self.scene.joints.len(), turn, None, T::zero()));
        let inward: SmallVec<[T; 12]> =
            rows.iter().chain([&state.leads.0]).map(|row| self.inward(state, row)).collect();
        let mut response = self.general(state, &rows, &self.forces(&state.poses, false), &inward, alpha)?;
        let couple = response.forces.pop().flatten();
        Ok((response, couple))
    }

    /// What bodies do under these forces, and by their motion if they `bend` their ways in time.
    fn answer(
        &self,
        state: &State<T>,
        rows: &[Row<T>],
        forces: &[[T; 3]],
        bend: bool,
    ) -> Result<Response<T>, Refusal> {
        let inward = |row: &Row<T>| if bend { self.inward(state, row) } else { T::zero() };
        let inward: SmallVec<[T; 12]> = rows.iter().chain([&state.leads.0]).map(inward).collect();
        match self.bodies(state, rows, forces, &inward) {
            Some(response) => Ok(response),
            None => self.general(state, rows, forces, &inward, T::zero()),
        }
    }

    /// How hard a body is to accelerate along an axis and to turn.
    fn inertias(&self, body: usize) -> [T; 3] {
        let numbers = &self.n.bodies[body];
        let mass = plant!("eom: mass of a body in the plane", numbers.mass);
        [mass, mass, plant!("eom: inertia of a body in the plane", numbers.inertia)]
    }

    /// The equations of the bodies for the leading angle's second derivative and the forces of the joints; `None` where these are not
    /// well determined.
    fn bodies(
        &self,
        state: &State<T>,
        rows: &[Row<T>],
        forces: &[[T; 3]],
        inward: &[T],
    ) -> Option<Response<T>> {
        if !state.determined {
            return None;
        }
        let count = self.columns;
        let mut bends: Rates<T> = smallvec![[T::zero(); 3]; forces.len()];
        let mut bend: SmallVec<[T; 12]> = smallvec![T::zero(); inward.len()];
        bend.copy_from_slice(inward);
        state.kinematics.solve(&mut bend);
        self.per_body(&bend, &mut bends);
        let mut factors = self.factors.borrow_mut();
        factors.room(count);
        let mut rights: [SmallVec<[T; 12]>; 2] = [smallvec![T::zero(); count], smallvec![T::zero(); count]];
        for (b, force) in forces.iter().enumerate() {
            let inertias = self.inertias(b);
            for k in 0..if self.turns(b) { 3 } else { 2 } {
                let at = self.first[b] + k;
                factors.add(at, count - 1, inertias[k] * state.rates[b][k]);
                rights[0][at] = force[k];
                rights[1][at] = -(inertias[k] * bends[b][k]);
            }
        }
        for (j, row) in rows.iter().enumerate() {
            for end in row.loaded() {
                let force = Self::reacts(row, end);
                for (k, f) in force.iter().enumerate().take(if self.turns(end.body) { 3 } else { 2 }) {
                    factors.add(self.first[end.body] + k, j, -*f);
                }
            }
        }
        if !factors.reduce() {
            return None;
        }
        rights.iter_mut().for_each(|right| factors.solve(right));
        let [constant, square] = &rights;
        let pairs = || constant.iter().copied().zip(square.iter().copied());
        let lead = pairs().next_back()?;
        let mut rates = state.rates.clone();
        for (rate, bend) in rates.iter_mut().flatten().zip(bends.iter_mut().flatten()) {
            (*rate, *bend) = (*rate * lead.0, bend.balance(*rate * lead.1));
        }
        Some(Response { forces: pairs().take(rows.len()).map(Some).collect(), lead, moves: [rates, bends] })
    }

    /// All accelerations and forces at once, where there are more freedoms, or where reactions repeat each other; `given` is the constant
    /// part of the second derivative that the last row keeps.
    fn general(
        &self,
        state: &State<T>,
        held: &[Row<T>],
        forces: &[[T; 3]],
        inward: &[T],
        given: T,
    ) -> Result<Response<T>, Refusal> {
        let unknowns = self.columns + held.len();
        let mut rows = Linear::new(unknowns, 2);
        for (b, force) in forces.iter().enumerate() {
            let (at, inertias) = (self.first[b], self.inertias(b));
            for k in 0..if self.turns(b) { 3 } else { 2 } {
                rows.term(at + k, at + k, inertias[k]);
                rows.right(at + k, CONSTANT, force[k]);
            }
        }
        for (j, (row, inward)) in held.iter().zip(inward).enumerate() {
            let unknown = self.columns + j;
            for end in row.loaded() {
                let (force, at) = (Self::reacts(row, end), self.first[end.body]);
                for (k, f) in force.iter().enumerate().take(if self.turns(end.body) { 3 } else { 2 }) {
                    rows.term(at + k, unknown, -*f);
                }
            }
            for end in row.ends() {
                let turn = plant!("eom: lever of an acceleration", end.turn());
                let (own, at) = ([end.along[0], end.along[1], turn], self.first[end.body]);
                for (k, x) in own.iter().enumerate().take(if self.turns(end.body) { 3 } else { 2 }) {
                    rows.term(unknown, at + k, *x);
                }
            }
            rows.right(unknown, SQUARE, *inward);
        }
        if !given.is_zero() {
            rows.right(unknowns - 1, CONSTANT, given);
        }
        let solution = rows.solve()?;
        if (0..self.columns).any(|i| solution.is_open(i)) {
            return Err(Refusal::Singular { unknowns, rank: unknowns - 1 });
        }
        let value = |i: usize, k: usize| solution.get(i, k);
        let part = |k: usize| {
            let all: SmallVec<[T; 12]> = (0..self.columns).map(|i| value(i, k)).collect();
            let mut rates = state.rates.clone();
            self.per_body(&all, &mut rates);
            rates
        };
        let moves = [part(CONSTANT), part(SQUARE)];
        // The acceleration along what leads is that of its point, less what is due to the turn.
        let (leads, speed) = &state.leads;
        let along = |k: usize, from: T| {
            leads.ends().iter().fold(from, |sum, end| {
                let [x, y, turn] = moves[k][end.body];
                let sum = sum.balance(end.along[0] * x).balance(end.along[1] * y);
                if self.turns(end.body) { sum.balance(end.turn() * turn) } else { sum }
            }) / *speed
        };
        let lead = (along(CONSTANT, T::zero()), along(SQUARE, -inward[held.len()]));
        let of = |i: usize| (!solution.is_open(i)).then(|| (value(i, CONSTANT), value(i, SQUARE)));
        Ok(Response { forces: (self.columns..unknowns).map(of).collect(), lead, moves })
    }

    /// Angular acceleration of a body, as its own angle counts: constant part, and per square of the rate.
    pub fn turning(&self, response: &Response<T>, body: usize) -> (T, T) {
        let [constant, square] = [0, 1].map(|i| response.moves[i][body][2].signed(self.scene.sense(body)));
        (constant, square)
    }
    /// Acceleration of a mass centre at this square of the rate: to the right and up.
    pub fn acceleration(&self, response: &Response<T>, body: usize, square: T) -> Vector<T> {
        let [x, y, _] = Self::moved(response, body, square);
        [x, y]
    }
    /// The same with that of the turn, counter-clockwise; in a blow the jumps of the velocities.
    fn moved(response: &Response<T>, body: usize, square: T) -> [T; 3] {
        let [constant, by_square] = &response.moves;
        [0, 1, 2].map(|i| constant[body][i].balance(by_square[body][i] * square))
    }
    /// Angular velocity of a body for a unit rate, as its own angle counts.
    pub fn spin(&self, state: &State<T>, body: usize) -> T {
        state.rates[body][2].signed(self.scene.sense(body))
    }
    /// Sum of the magnitudes of the momenta that bodies gain by these jumps of their velocities.
    pub fn gained(&self, jumps: &Response<T>) -> f64 {
        let gains = self.n.bodies.iter().zip(&jumps.moves[0]);
        gains.map(|(numbers, [x, y, _])| numbers.mass.size() * (x.size() + y.size())).sum()
    }
    /// For each body the sizes, to the right and up, of what adds up to its mass times its acceleration at this square of the rate, or
    /// in a blow to its momentum: what is given, and the forces of joints.
    pub fn adding_up(
        &self,
        state: &State<T>,
        (response, square): (&Response<T>, T),
        blow: bool,
    ) -> SmallVec<[[f64; 2]; 4]> {
        let given = self.forces(&state.poses, blow);
        let mut on: SmallVec<[[f64; 2]; 4]> = given.iter().map(|f| [f[0].size(), f[1].size()]).collect();
        for (row, parts) in state.rows.iter().zip(&response.forces) {
            let force =
                parts.map_or(0.0, |(constant, by_square)| constant.balance(by_square * square).size());
            for end in row.loaded() {
                let own = &mut on[end.body];
                *own = [0, 1].map(|i| own[i] + force * end.along[i].size());
            }
        }
        on
    }
    /// What of this adds up to a force of a joint: along it, on the one of its bodies on which that is least, for from that it is worked
    /// out.
    pub fn adding_to(&self, state: &State<T>, (joint, i): (usize, usize), on: &[[f64; 2]]) -> f64 {
        let along = |end: &End<T>| (0..2).map(|i| end.along[i].size() * on[end.body][i]).sum();
        state.rows[self.held[joint] + i].loaded().map(along).fold(f64::INFINITY, f64::min)
    }
    /// The first of the joints that can only push or only pull and share a load in a way that statics leaves open, if they cannot carry
    /// it: however they share it, one of them would have to do the other.
    pub fn overloaded(
        &self,
        state: &State<T>,
        (response, square): (&Response<T>, T),
        sliding: &[f64],
        blow: bool,
    ) -> Option<usize> {
        let sided = |i: usize, row: &Row<T>| {
            let joint = self.scene.joints.get(row.joint);
            joint.is_some_and(|joint| joint.kind.is_one_sided() && i == self.held[row.joint])
        };
        let mut held = state.rows.iter().zip(&response.forces).enumerate();
        let (_, (first, _)) = held.find(|(i, (row, force))| force.is_none() && sided(*i, row))?;
        let rows = self.rubbing(state, sliding);
        let given = self.forces(&state.poses, blow);
        let mut load = vec![0.0; 3 * given.len()];
        for (b, force) in given.iter().enumerate() {
            let (inertias, moved) = (self.inertias(b), Self::moved(response, b, square));
            for k in 0..if self.turns(b) { 3 } else { 2 } {
                load[3 * b + k] = (inertias[k] * moved[k] - force[k]).f64();
            }
        }
        let mut columns = Vec::new();
        for (i, (row, force)) in rows.iter().zip(&response.forces).enumerate() {
            let mut column = vec![0.0; load.len()];
            for end in row.loaded() {
                let reacts = Self::reacts(row, end);
                for (k, f) in reacts.iter().enumerate().take(if self.turns(end.body) { 3 } else { 2 }) {
                    column[3 * end.body + k] += f.f64();
                }
            }
            match force {
                None => columns.push((column, !sided(i, row))),
                Some((constant, by_square)) => {
                    let force = constant.balance(*by_square * square).f64();
                    load.iter_mut().zip(&column).for_each(|(load, of)| *load -= force * of);
                }
            }
        }
        (!shares::carry(&columns, &load)).then_some(first.joint)
    }
    /// Velocity of a point for a unit rate.
    pub fn speed(&self, state: &State<T>, spot: Spot) -> Vector<T> {
        let [x, y, spin] = state.rates[spot.body];
        let r = self.lever(&state.poses, spot);
        [x - spin * r[1], y + spin * r[0]]
    }
    /// The force of a joint at this square of the rate: its components to the right and up on the first body, or along its
    /// normal, or the tension of a cord; `None` where the joints leave it open.
    pub fn reaction(&self, response: &Response<T>, joint: usize, square: T) -> Option<SmallVec<[T; 2]>> {
        let first = self.held[joint];
        let count = self.scene.joints[joint].kind.forces().len();
        let at = |(constant, by_square): (T, T)| constant.balance(by_square * square);
        response.forces[first..first + count].iter().map(|parts| parts.map(at)).collect()
    }
    /// [`pose::size`].
    pub fn size(&self) -> f64 {
        pose::size(self.scene, self.n)
    }
    /// The normal force of a guide that can only push: constant part, and per square of the rate; `None` for other joints and where
    /// the joints leave it open.
    pub fn push(&self, response: &Response<T>, joint: usize) -> Option<(T, T)> {
        let kind = &self.scene.joints[joint].kind;
        (kind.is_one_sided() || kind.rubs().is_some()).then(|| response.forces[self.held[joint]])?
    }
    /// Height of a mass centre.
    pub fn height(&self, state: &State<T>, body: usize) -> T {
        self.centre(&state.poses, body)[1]
    }
    /// How far a spring is stretched, or the body of a torsion spring turned beyond where that is relaxed; 0 where it does not act.
    fn stretch(&self, poses: &Poses<T>, strut: usize) -> T {
        let beyond = self.layout.beyond(poses, strut);
        if self.layout.acts(strut, beyond) { beyond } else { T::zero() }
    }
    /// The force of a spring that is stretched by its natural length, N, or the moment of one that is turned by 1 rad, N m; 0 where its
    /// stretch is given.
    pub fn measure(&self, strut: usize) -> f64 {
        let s = &self.scene.struts[strut];
        let by = match s.rest {
            _ if s.twists() => T::of(1.0),
            Rest::Length(_) => self.layout.natural[strut],
            Rest::Stretch(_) => T::zero(),
        };
        (self.n.massive(s.stiffness_n_m) * by).size()
    }
    /// Does a point of a body pass on this way through the surface that pushes another one of its points? One that starts beyond is no
    /// part of what the surface bears; what stands out over the rim of a wheel runs beside its rail. Doubles tell.
    pub fn pierces(&self, sense: f64, far: (T, T)) -> Option<Obstacle> {
        let (scene, margin) = (self.scene, PIERCED * self.size());
        if T::is_double() || pushing(scene).next().is_none() {
            return strikes(&self.layout, self.n, sense, far, margin);
        }
        let n = self.n.in_doubles(scene);
        strikes(&Layout::new(scene, &n)?, &n, sense, (far.0.f64(), far.1.f64()), margin)
    }
    /// Force of a spring, positive if it pulls; moment of a torsion spring against its stretch.
    pub fn tension(&self, state: &State<T>, strut: usize) -> T {
        self.n.massive(self.scene.struts[strut].stiffness_n_m) * self.stretch(&state.poses, strut)
    }
}

/// The straight surfaces on the ground that push points of bodies: the joint, the point, a place on the line.
fn pushing(scene: &Scene) -> impl Iterator<Item = (usize, Spot, [Num; 2])> {
    scene.joints.iter().enumerate().filter_map(|(j, joint)| match joint.kind {
        JointKind::Guide { at, line, one_sided: true, .. }
        | JointKind::Contact { at, surface: Surface::Line(line), rolls: false, teeth: false, .. }
            if line.on.is_none() =>
        {
            Some((j, at, line.through_m))
        }
        _ => None,
    })
}

/// [`Mechanism::pierces`], by more than a margin.
fn strikes<T: Real>(
    layout: &Layout<T>,
    n: &Numbers<T>,
    sense: f64,
    far: (T, T),
    margin: f64,
) -> Option<Obstacle> {
    pushing(layout.scene).find_map(|(j, at, through_m)| {
        let ([c, s], through) = (layout.lines[j], pose::ground(n, through_m));
        let above = |spot: Spot, way: T| {
            let poses: Poses<T> = layout.poses(way.signed(sense), false).ok_or(())?;
            let [x, y] = layout.spot(spot, &poses);
            Ok::<_, ()>((y - through[1]) * c - (x - through[0]) * s + T::of(margin))
        };
        let pierces = |spot: &Spot| {
            let above = |way: T| above(*spot, way);
            above(T::zero()).is_ok_and(|first| first.sign() > 0.0)
                && root::changes(far, &[], &above).is_ok_and(|places| !places.is_empty())
        };
        let points = layout.scene.planar(at.body).map_or(0, |p| p.points.len());
        let mut others = (0..points).map(|point| Spot { body: at.body, point }).filter(|spot| *spot != at);
        others.find(pierces).map(|spot| Obstacle::Strikes(spot, j))
    })
}
