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
use crate::scene::{Action, Coordinate, Degree, Far, GivenForce, Grows, Growth, Numbers, Scene, Tie};
use crate::solve::outcome::{Grip, Refusal};
use smallvec::SmallVec;

/// Right-hand side of the constant forces.
pub const CONSTANT: usize = 0;
/// First right-hand side of what varies: a unit tension in the cord of each spring, or the whole growth of the forces that grow.
pub const VARYING: usize = 1;

/// How the contacts are taken.
#[derive(Debug, Clone)]
pub struct Setting {
    /// How contacts that are said to slip are taken.
    pub grip: Grip,
    /// For each tie: is it a body that could slide and stays? Static friction is then a reaction.
    pub stays: SmallVec<[bool; 4]>,
    /// For each tie that slips or slides: sense of the kinetic friction, 0 for none.
    pub friction_sense: SmallVec<[f64; 4]>,
    /// Slides feel their static coefficient (does it start?).
    pub starting: bool,
    /// Add a unit force on this coordinate as the last right-hand side.
    pub probe: Option<Coordinate>,
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
        match c.degree {
            Degree::Along => self.at(self.layout.along[c.body], column),
            Degree::Turn => self.at(self.layout.turn[c.body], column),
        }
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
                let along = |action: Action| {
                    let (toward, arm) = lever(n, &action);
                    let centre = moved(coordinate(action.body, Degree::Along)).signed(toward);
                    centre.balance(arm * moved(coordinate(action.body, Degree::Turn)))
                };
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

/// Assembles the rows that the scene has and solves them.
fn assembled<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    setting: &Setting,
    growths: SmallVec<[(GivenForce, T); 1]>,
) -> Result<Response<T>, Refusal> {
    let grown = |of: GivenForce| growths.iter().find(|g| g.0 == of).map(|g| g.1);
    let layout = Layout::of(scene, setting);
    let mut rows = Linear::new(layout.count, layout.columns);
    let normals = normals(scene, n);

    // The row of a coordinate bears the same number as its unknown.
    for (b, numbers) in n.bodies.iter().enumerate() {
        if let Some(row) = layout.along[b] {
            rows.term(row, row, plant!("eom: mass times acceleration", numbers.mass));
            let weight = numbers.mass * n.gravity;
            rows.right(row, CONSTANT, -plant!("eom: weight along the line", weight * numbers.climb));
            // What is carried accelerates with the carrier, besides what it does on it.
            if let Some([forward, _]) = numbers.carried {
                let taken = numbers.mass * forward.acceleration;
                rows.right(row, CONSTANT, -plant!("eom: mass times acceleration of the carrier", taken));
            }
        }
        if let Some(row) = layout.turn[b] {
            rows.term(row, row, plant!("eom: inertia times angular acceleration", numbers.inertia));
        }
    }
    for (i, c) in scene.couples.iter().enumerate() {
        if let Some(row) = layout.turn[c.body] {
            let moment = plant!("eom: moment of a couple", n.massive(c.moment_n_m));
            rows.right(row, CONSTANT, if c.forward { moment } else { -moment });
            if let Some(grown) = grown(GivenForce::Couple(i)) {
                rows.right(row, VARYING, if c.forward { grown } else { -grown });
            }
        }
    }
    // Adds `factor * tension` of a cord's end to the rows of its body, on the left (an unknown) or on the right.
    let pull = |rows: &mut Linear<T>, end: &Action, tension: T, unknown: Option<usize>, column: usize| {
        let (toward, arm) = lever(n, end);
        if let Some(row) = layout.along[end.body] {
            let f = plant!("eom: pull of a cord along the line", tension.signed(toward));
            let f = end.tilt_deg.map_or(f, |tilt| f * pose::direction(n, tilt)[0]);
            match unknown {
                Some(u) => rows.term(row, u, -f),
                None => rows.right(row, column, f),
            }
        }
        if let Some(row) = layout.turn[end.body] {
            let m = tension * arm;
            match unknown {
                Some(u) => rows.term(row, u, -m),
                None => rows.right(row, column, m),
            }
        }
    };
    // Acceleration of a cord's end along the cord, as terms of a row.
    let take_up = |rows: &mut Linear<T>, row: usize, end: &Action| {
        let (toward, arm) = lever(n, end);
        if let Some(col) = layout.along[end.body] {
            rows.term(row, col, plant!("eom: travel of the centre in a cord", T::of(toward)));
        }
        if let Some(col) = layout.turn[end.body] {
            rows.term(row, col, arm);
        }
    };
    let mut springs = VARYING..;
    for (t, tie) in scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. } => {
                let Some(row) = layout.reaction[t] else { continue };
                let c = n.get(*radius_m);
                for force in tie.actions() {
                    if let Some(along) = layout.along[force.body] {
                        rows.term(along, row, -plant!("eom: friction along the line", T::of(force.along)));
                    }
                    if let (Some(turn), Some((radius, sense))) = (layout.turn[force.body], force.arm) {
                        let moment = -n.get(radius).signed(sense);
                        rows.term(turn, row, plant!("eom: moment of the friction", moment));
                    }
                }
                match tie {
                    Tie::Slip { mu_k, .. } if !setting.grip.rolls(t) => {
                        rows.term(row, row, T::of(1.0));
                        let mu = plant!("eom: kinetic friction coefficient", n.get(*mu_k));
                        rows.right(row, CONSTANT, mu.signed(setting.friction_sense[t]) * normals[*body]);
                    }
                    _ => {
                        if let (Some(a), Some(alpha)) = (layout.along[*body], layout.turn[*body]) {
                            rows.term(row, a, T::of(1.0));
                            rows.term(row, alpha, -plant!("eom: rolling radius", c));
                        }
                    }
                }
            }
            Tie::Slide { body, mu_s, mu_k } => {
                let Some(row) = layout.reaction[t] else { continue };
                if let Some(along) = layout.along[*body] {
                    rows.term(along, row, -plant!("eom: sliding friction along the line", T::of(1.0)));
                }
                if let (true, Some(along)) = (setting.stays[t], layout.along[*body]) {
                    rows.term(row, along, T::of(1.0));
                    continue;
                }
                rows.term(row, row, T::of(1.0));
                let mu = n.get(if setting.starting { mu_s.unwrap_or(*mu_k) } else { *mu_k });
                rows.right(row, CONSTANT, mu.signed(setting.friction_sense[t]) * normals[*body]);
            }
            Tie::Cord(cord) => {
                for end in tie.actions() {
                    match (&cord.to, layout.reaction[t]) {
                        (Far::Pull(force), _) => {
                            let p = plant!("eom: force of a pull", n.massive(*force));
                            pull(&mut rows, &end, p, None, CONSTANT);
                            if let Some(grown) = grown(GivenForce::Pull(t)) {
                                pull(&mut rows, &end, grown, None, VARYING);
                            }
                        }
                        (Far::Spring { .. }, _) => {
                            let column = springs.next().unwrap_or(VARYING);
                            pull(&mut rows, &end, T::of(1.0), None, column);
                        }
                        (Far::Fixed | Far::Body(_), Some(row)) => {
                            pull(&mut rows, &end, T::of(1.0), Some(row), CONSTANT);
                            take_up(&mut rows, row, &end);
                        }
                        (Far::Fixed | Far::Body(_), None) => {}
                    }
                }
            }
        }
    }
    if let Some(c) = setting.probe {
        let place = match c.degree {
            Degree::Along => layout.along[c.body],
            Degree::Turn => layout.turn[c.body],
        };
        if let Some(row) = place {
            rows.right(row, layout.columns - 1, T::of(1.0));
        }
    }
    let solution = rows.solve().map_err(|s| Refusal::Singular { unknowns: s.unknowns, rank: s.rank })?;
    // Ties may share a reaction in any way; where an acceleration is open, the motion is.
    let mut accelerations = layout.along.iter().chain(&layout.turn).flatten();
    if accelerations.any(|i| solution.is_open(*i)) {
        let open = (0..layout.count).filter(|i| solution.is_open(*i)).count();
        return Err(Refusal::Singular { unknowns: layout.count, rank: layout.count - open });
    }
    Ok(Response { layout, solution, normal: normals, grown: growths })
}
