//! Free bodies and constraints as rows of one linear system (Newton-Euler with constraint reactions).
//!
//! Unknowns: an acceleration for each line, an angular acceleration for each body that turns, and one reaction for each
//! contact and cord of unknown tension. The normal force is none of them: cords are parallel to the line, so only the weight
//! and given pulls at an angle press a body on its surface. For each body, positive forward:
//!
//! ```text
//! m a         = sum of forces along the line         (weight -m g sin, friction F, cords e T)
//! 0           = N - m g cos + P sin tilt             (only on a surface)
//! I alpha     = sum of moments about the mass centre (friction -F c, cords e s p T, couples)
//! a - c alpha = 0                                    (rolls on c);   F = +- mu_k N  (slips or slides)
//! sum e (a + s p alpha) = 0                          (a cord keeps its length)
//! ```
//! Where a belt or a lift carries the scene, `a` counts on it: `m (a + A)` stands on the left, `N - m g cos = m A_n`.
//! Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, chapter 16 (equations of motion of a rigid body).
use crate::num::Real;
use crate::num::linear::{Linear, Solution};
use crate::num::plant::plant;
use crate::scene::pose;
use crate::scene::{
    Action, Coordinate, Degree, Far, GivenForce, Grows, Growth, Num, Numbers, Rubbing, Scene, Tie,
};
use crate::solve::eom::{take_up, under};
use crate::solve::outcome::{Refusal, Unsupported};
use smallvec::{SmallVec, smallvec};

/// Right-hand side of the constant forces.
pub const CONSTANT: usize = 0;
/// First right-hand side of what varies: a unit tension in the cord of each spring, or the whole growth of the forces that grow.
pub const VARYING: usize = 1;

/// How the contacts are taken.
#[derive(Debug, Clone)]
pub struct Setting {
    /// For each tie: is it a contact that is said to slip or slide, and holds? Its friction is then a reaction.
    pub holds: SmallVec<[bool; 4]>,
    /// For each tie that slips or slides: sense of the kinetic friction, 0 for none.
    pub friction_sense: SmallVec<[f64; 4]>,
    /// Slides feel their static coefficient (does it start?).
    pub starting: bool,
    /// Add a unit force on this coordinate as the last right-hand side.
    pub probe: Option<Coordinate>,
}

impl Setting {
    /// Nothing that could rub holds, and nothing rubs.
    pub fn loose(scene: &Scene) -> Self {
        let ties = scene.ties.len();
        Self {
            holds: smallvec![false; ties],
            friction_sense: smallvec![0.0; ties],
            starting: false,
            probe: None,
        }
    }
}

/// Place of an unknown for each body or tie.
type Places = SmallVec<[Option<usize>; 2]>;

/// Where each unknown stands.
#[derive(Debug, Clone)]
struct Layout {
    along: Places,
    turn: Places,
    reaction: Places,
    count: usize,
    columns: usize,
}

impl Layout {
    /// Place of a coordinate.
    fn place(&self, c: Coordinate) -> Option<usize> {
        match c.degree {
            Degree::Along => self.along[c.body],
            Degree::Turn => self.turn[c.body],
        }
    }
    fn of(scene: &Scene, setting: &Setting) -> Self {
        let mut count = 0;
        let mut next = |present: bool| {
            present.then(|| {
                count += 1;
                count - 1
            })
        };
        let (mut along, mut turn) = (Places::new(), Places::new());
        for b in &scene.bodies {
            along.push(next(b.line.is_some()));
            turn.push(next(b.spins()));
        }
        let reaction = scene
            .ties
            .iter()
            .map(|t| match t {
                Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => next(true),
                Tie::Cord(c) => next(matches!(c.to, Far::Body(_) | Far::Fixed)),
            })
            .collect();
        let varying = scene.springs().count().max(usize::from(!scene.growths.is_empty()));
        let columns = 1 + varying + usize::from(setting.probe.is_some());
        Self { along, turn, reaction, count, columns }
    }
}

/// Accelerations and reactions for each right-hand side.
#[derive(Debug, Clone)]
pub struct Response<T> {
    layout: Layout,
    solution: Solution<T>,
    /// Normal force on each body; 0 where it has no surface.
    normal: SmallVec<[T; 2]>,
    /// What each force that grows has grown by at the end.
    grown: SmallVec<[(GivenForce, T); 1]>,
}

impl<T: Real> Response<T> {
    fn at(&self, place: Option<usize>, column: usize) -> T {
        place.map_or_else(T::zero, |i| self.solution.get(i, column))
    }
    /// Acceleration of a coordinate.
    pub fn acceleration(&self, c: Coordinate, column: usize) -> T {
        self.at(self.layout.place(c), column)
    }
    /// Normal force on a body.
    pub fn normal(&self, body: usize) -> T {
        self.normal[body]
    }
    /// How much a force or couple has grown at the end, where it grows.
    pub fn grown(&self, of: GivenForce) -> Option<T> {
        self.grown.iter().find(|g| g.0 == of).map(|g| g.1)
    }
    /// Friction of a contact (positive forward), or tension of a cord.
    pub fn reaction(&self, tie: usize, column: usize) -> T {
        self.at(self.layout.reaction[tie], column)
    }
    /// Do the ties share a reaction in a way that the equations leave open?
    pub fn is_open(&self, tie: usize) -> bool {
        self.layout.reaction[tie].is_some_and(|i| self.solution.is_open(i))
    }
    /// The last right-hand side: the probe, if there is one.
    pub fn last(&self) -> usize {
        self.layout.columns - 1
    }
}

/// Share of a cord's pull along the line, and its arm with the sign of its turn; 0 at the centre.
fn lever<T: Real>(n: &Numbers<T>, action: &Action) -> (f64, T) {
    let arm = match action.arm {
        None => T::zero(),
        Some((radius, sense)) => plant!("eom: lever of a cord", n.get(radius)).signed(sense),
    };
    (action.along, arm)
}

/// Solves the equations of the scene. Where forces grow with place, their points go on in the ratios in which a unit force on the ending
/// coordinate sets them off.
pub fn respond<T: Real>(scene: &Scene, n: &Numbers<T>, setting: &Setting) -> Result<Response<T>, Refusal> {
    let end = scene.ending_coordinate();
    let probed = match scene.grows_with_place() {
        true => Some(assembled(scene, n, &Setting { probe: Some(end), ..setting.clone() }, SmallVec::new())?),
        false => None,
    };
    let extent = scene.growing_for().map_or_else(T::zero, |x| n.get(x).abs());
    let grown = |growth: &Growth| {
        let rate = plant!("eom: growth of a force", n.massive(growth.rate));
        let own = match (&probed, growth.law.with) {
            (Some(response), Grows::Place) => {
                let moved = |c: Coordinate| response.acceleration(c, response.last());
                let coordinate = |body: usize, degree: Degree| Coordinate { body, degree };
                let along =
                    |action: Action| take_up(n, &action, |degree| moved(coordinate(action.body, degree)));
                let own = match growth.of {
                    GivenForce::Pull(t) => scene.ties[t].actions().next().map_or_else(T::zero, along),
                    GivenForce::Couple(i) => moved(coordinate(scene.couples[i].body, Degree::Turn)),
                };
                // Where the ties hold that coordinate, no point gets anywhere with it.
                let lead = moved(end);
                if lead.is_zero() { T::zero() } else { (extent * own / lead).abs() }
            }
            _ => extent,
        };
        (growth.of, rate * growth.law.of(own, n.get(growth.unit)))
    };
    assembled(scene, n, setting, scene.growths.iter().map(grown).collect())
}

/// The response with this contact held too, and the others as they are taken. Errors: other ties share its friction.
pub fn held<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    setting: &Setting,
    tie: usize,
) -> Result<Response<T>, Refusal> {
    let mut setting = setting.clone();
    setting.holds[tie] = true;
    let response = respond(scene, n, &setting)?;
    if response.is_open(tie) { Err(Refusal::SlipShared(tie)) } else { Ok(response) }
}

/// Normal force on each body, which no unknown acts on: `N = m g cos theta + m a_out - P sin tilt`, and 0 off a surface.
pub fn normals<T: Real>(scene: &Scene, n: &Numbers<T>) -> SmallVec<[T; 2]> {
    let pressed = scene.bodies.iter().zip(&n.bodies).map(|(body, numbers)| {
        if !body.line.is_some_and(|l| l.surface) {
            return T::zero();
        }
        let normal = plant!("eom: weight on the surface", numbers.mass * n.gravity * numbers.level);
        numbers.carried.map_or(normal, |[_, out]| {
            let taken = plant!("eom: force that carries out of the surface", numbers.mass);
            normal.balance(taken * out.acceleration)
        })
    });
    let mut normals: SmallVec<[T; 2]> = pressed.collect();
    for (body, force, tilt) in scene.ties.iter().filter_map(Tie::tilted) {
        let lifts = n.massive(force) * pose::direction(n, tilt)[1];
        normals[body] = normals[body].balance(-plant!("eom: lift of a pull at an angle", lifts));
    }
    normals
}

/// Of each tie the friction that its contact needs, if it is one that could rub and holds by friction.
pub type Needs<T> = SmallVec<[Option<T>; 4]>;

/// The friction that those contacts need which hold, under what varies. Bodies that slide and share what they take together are the
/// first to move on all at once, each at the limit of its static friction: each needs the same share of that.
///
/// Errors: what slips is held by other ties as well, or such bodies are free to move on in several ways.
pub fn needs<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    (setting, response): (&Setting, &Response<T>),
    pulls: &[T],
) -> Result<Needs<T>, Refusal> {
    let mut needs: Needs<T> = smallvec![None; scene.ties.len()];
    let mut shared: SmallVec<[(usize, Rubbing); 4]> = SmallVec::new();
    for t in (0..scene.ties.len()).filter(|t| setting.holds[*t]) {
        match scene.ties[t].rubbing() {
            Some(_) if !response.is_open(t) => {
                needs[t] = Some(under(pulls, |k| response.reaction(t, k)).abs());
            }
            Some(rub) if rub.radius_m.is_none() => shared.push((t, rub)),
            Some(_) => return Err(Refusal::SlipShared(t)),
            None => {}
        }
    }
    // What is at rest rubs no more: let go, it is smooth.
    let mut loose = setting.clone();
    for (t, _) in &shared {
        loose.holds[*t] = false;
        loose.friction_sense[*t] = 0.0;
    }
    // With these held alone, is the last of them held by the others?
    let held = |those: &[usize]| -> Result<bool, Refusal> {
        let mut setting = loose.clone();
        those.iter().for_each(|t| setting.holds[*t] = true);
        let response = respond(scene, n, &setting)?;
        Ok(those.last().is_some_and(|t| response.is_open(*t)))
    };
    let mut free = SmallVec::<[(usize, Rubbing); 4]>::new();
    for (t, rub) in shared {
        if !held(&[t])? {
            free.push((t, rub));
        }
    }
    let Some((first, rub)) = free.first() else { return Ok(needs) };
    for (t, _) in &free[1..] {
        if !held(&[*first, *t])? {
            return Err(Refusal::Unsupported(Unsupported::SlidesInTurn));
        }
    }
    let line = |rub: &Rubbing| Coordinate { body: rub.body, degree: Degree::Along };
    let loose = respond(scene, n, &Setting { probe: Some(line(rub)), ..loose })?;
    let driven = under(pulls, |k| loose.acceleration(line(rub), k)).abs();
    // A force on one body accelerates another as it would itself be accelerated by the same force there.
    let limits = free.iter().map(|(_, rub)| n.get(rub.mu_s) * response.normal(rub.body));
    let stopped = free.iter().zip(limits.clone());
    let stopped = stopped.map(|((_, rub), limit)| limit * loose.acceleration(line(rub), loose.last()).abs());
    let stopped = stopped.fold(T::zero(), |sum, a| sum + a);
    for ((t, _), limit) in free.iter().zip(limits) {
        let alone = || driven / loose.acceleration(line(rub), loose.last());
        needs[*t] = Some(if stopped.is_zero() { alone() } else { driven * limit / stopped });
    }
    Ok(needs)
}

/// Assembles the rows that the scene has and solves them.
fn assembled<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    setting: &Setting,
    grown: SmallVec<[(GivenForce, T); 1]>,
) -> Result<Response<T>, Refusal> {
    let layout = Layout::of(scene, setting);
    let rows = Linear::new(layout.count, layout.columns);
    let mut all = Assembly { scene, n, layout, rows, normal: normals(scene, n), grown };
    all.free_bodies();
    all.couples();
    let mut springs = VARYING..;
    for (t, tie) in scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => all.contact(t, tie, setting),
            Tie::Cord(cord) => match cord.to {
                Far::Pull(force) => all.given_pull(t, force),
                Far::Spring { .. } => {
                    let column = springs.next().unwrap_or(VARYING);
                    tie.actions().for_each(|end| all.pull(&end, T::of(1.0), None, column));
                }
                Far::Fixed | Far::Body(_) => all.cord(t),
            },
        }
    }
    if let Some(c) = setting.probe
        && let Some(row) = all.layout.place(c)
    {
        all.rows.right(row, all.layout.columns - 1, T::of(1.0));
    }
    let Assembly { layout, rows, normal, grown, .. } = all;
    let solution = rows.solve()?;
    // Ties may share a reaction in any way; where an acceleration is open, the motion is.
    let mut accelerations = layout.along.iter().chain(&layout.turn).flatten();
    if accelerations.any(|i| solution.is_open(*i)) {
        let open = (0..layout.count).filter(|i| solution.is_open(*i)).count();
        return Err(Refusal::Singular { unknowns: layout.count, rank: layout.count - open });
    }
    Ok(Response { layout, solution, normal, grown })
}

/// The rows in the making. The row of a coordinate bears the same number as its unknown, that of a tie the one of its reaction.
struct Assembly<'s, 'a, T> {
    scene: &'s Scene,
    n: &'s Numbers<'a, T>,
    layout: Layout,
    rows: Linear<T>,
    normal: SmallVec<[T; 2]>,
    grown: SmallVec<[(GivenForce, T); 1]>,
}

impl<T: Real> Assembly<'_, '_, T> {
    /// How much a given force has grown at the end.
    fn grown(&self, of: GivenForce) -> Option<T> {
        self.grown.iter().find(|g| g.0 == of).map(|g| g.1)
    }

    /// Masses and inertias, weights, and what it takes to be carried.
    fn free_bodies(&mut self) {
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            if let Some(row) = self.layout.along[b] {
                self.rows.term(row, row, plant!("eom: mass times acceleration", numbers.mass));
                let weight = numbers.mass * self.n.gravity;
                let along = plant!("eom: weight along the line", weight * numbers.climb);
                self.rows.right(row, CONSTANT, -along);
                // What is carried accelerates with the carrier, besides what it does on it.
                if let Some([forward, _]) = numbers.carried {
                    let taken = numbers.mass * forward.acceleration;
                    let taken = plant!("eom: mass times acceleration of the carrier", taken);
                    self.rows.right(row, CONSTANT, -taken);
                }
            }
            if let Some(row) = self.layout.turn[b] {
                self.rows.term(row, row, plant!("eom: inertia times angular acceleration", numbers.inertia));
            }
        }
    }

    fn couples(&mut self) {
        for (i, c) in self.scene.couples.iter().enumerate() {
            let Some(row) = self.layout.turn[c.body] else { continue };
            let moment = plant!("eom: moment of a couple", self.n.massive(c.moment_n_m));
            self.rows.right(row, CONSTANT, c.signed(moment));
            if let Some(grown) = self.grown(GivenForce::Couple(i)) {
                self.rows.right(row, VARYING, c.signed(grown));
            }
        }
    }

    /// Adds `factor * tension` of a cord's end to the rows of its body, on the left (an unknown) or on the right.
    fn pull(&mut self, end: &Action, tension: T, unknown: Option<usize>, column: usize) {
        let (toward, arm) = lever(self.n, end);
        if let Some(row) = self.layout.along[end.body] {
            let f = plant!("eom: pull of a cord along the line", tension.signed(toward));
            let f = end.tilt_deg.map_or(f, |tilt| f * pose::direction(self.n, tilt)[0]);
            match unknown {
                Some(u) => self.rows.term(row, u, -f),
                None => self.rows.right(row, column, f),
            }
        }
        if let Some(row) = self.layout.turn[end.body] {
            let m = tension * arm;
            match unknown {
                Some(u) => self.rows.term(row, u, -m),
                None => self.rows.right(row, column, m),
            }
        }
    }

    /// A given force, with what it has grown by.
    fn given_pull(&mut self, tie: usize, force: Num) {
        let scene = self.scene;
        for end in scene.ties[tie].actions() {
            let p = plant!("eom: force of a pull", self.n.massive(force));
            self.pull(&end, p, None, CONSTANT);
            if let Some(grown) = self.grown(GivenForce::Pull(tie)) {
                self.pull(&end, grown, None, VARYING);
            }
        }
    }

    /// A cord that keeps its length: its tension on its bodies, and the accelerations of its ends along it.
    fn cord(&mut self, tie: usize) {
        let (scene, Some(row)) = (self.scene, self.layout.reaction[tie]) else { return };
        for end in scene.ties[tie].actions() {
            self.pull(&end, T::of(1.0), Some(row), CONSTANT);
            let (toward, arm) = lever(self.n, &end);
            if let Some(col) = self.layout.along[end.body] {
                self.rows.term(row, col, plant!("eom: travel of the centre in a cord", T::of(toward)));
            }
            if let Some(col) = self.layout.turn[end.body] {
                self.rows.term(row, col, arm);
            }
        }
    }

    /// The friction of a contact on its body, and what is known of it: the contact holds, or rubs.
    fn contact(&mut self, t: usize, tie: &Tie, setting: &Setting) {
        let Some(row) = self.layout.reaction[t] else { return };
        let one = T::of(1.0);
        for force in tie.actions() {
            let (along, turn) = (self.layout.along[force.body], self.layout.turn[force.body]);
            if let Some(along) = along {
                self.rows.term(along, row, -plant!("eom: friction along the line", T::of(force.along)));
            }
            if let (Some(turn), Some((radius, sense))) = (turn, force.arm) {
                let moment = -self.n.get(radius).signed(sense);
                self.rows.term(turn, row, plant!("eom: moment of the friction", moment));
            }
            match *tie {
                Tie::Slip { mu_k, .. } if !setting.holds[t] => {
                    let mu = plant!("eom: kinetic friction coefficient", self.n.get(mu_k));
                    self.rubs((row, t), force.body, mu, setting);
                }
                Tie::Slide { mu_s, mu_k, .. } if !(setting.holds[t] && along.is_some()) => {
                    let mu = self.n.get(if setting.starting { mu_s.unwrap_or(mu_k) } else { mu_k });
                    self.rubs((row, t), force.body, mu, setting);
                }
                _ => {
                    if let Some(a) = along {
                        self.rows.term(row, a, one);
                    }
                    if let (Some(alpha), Some((radius, sense))) = (turn, force.arm) {
                        let c = plant!("eom: rolling radius", self.n.get(radius));
                        self.rows.term(row, alpha, c.signed(sense));
                    }
                }
            }
        }
    }

    /// Kinetic friction of a tie, whose unknown has this place, against its slip.
    fn rubs(&mut self, (row, tie): (usize, usize), body: usize, mu: T, setting: &Setting) {
        self.rows.term(row, row, T::of(1.0));
        self.rows.right(row, CONSTANT, mu.signed(setting.friction_sense[tie]) * self.normal[body]);
    }
}
