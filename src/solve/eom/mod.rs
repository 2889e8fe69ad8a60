//! The first road: equations of motion with their reactions, integrated over displacement.
//!
//! Velocity ratios are not derived from the ties here: they are the ratios of the accelerations that the equations give.
pub mod equations;
pub mod instant;
pub mod integrate;
pub mod joined;
mod onset;
pub mod pendulum;
mod phases;
pub mod planar;
pub mod travel;

use crate::num::dd::Dd;
use crate::num::ode::Count;
use crate::num::plant::plant;
#[cfg(feature = "program")]
use crate::num::{Lanes, lanes};
use crate::num::{Real, U, trig};
use crate::scene::pose;
use crate::scene::{
    Action, Coordinate, Cord, CordEnd, Degree, End, Far, GivenForce, Grows, Label, Law, Made, Numbers, Owner,
    Quantity, Scene, Span, Start, Tie, speed,
};
use crate::solve::eom::equations::{CONSTANT, Response, Setting, VARYING, needs, normals, respond};
use crate::solve::eom::integrate::{Event, Path, path};
use crate::solve::eom::onset::Onset;
use crate::solve::eom::phases::{Linear, Phases};
use crate::solve::eom::travel::{Leg, State, Travel};
use crate::solve::found;
use crate::solve::method::{Method, Rung};
use crate::solve::outcome;
use crate::solve::outcome::{Course, Held, Refusal, Road, Said, Scope, Set, Throw, Told};
use smallvec::{SmallVec, smallvec};
#[cfg(feature = "program")]
use std::rc::Rc;

/// Everything that the equations of motion say of a scene whose data are admissible.
///
/// Errors: equations that do not determine the motion.
pub fn road<T: Real>(scene: &Scene, data: &[f64]) -> Result<Road<T>, Refusal> {
    road_of(scene, data, Scope::ALL)
}

/// What they say of what is asked; where a formula asks, that is everything. Errors: those of [`road`].
pub fn road_of<T: Real>(scene: &Scene, data: &[f64], asked: Scope) -> Result<Road<T>, Refusal> {
    found::road_of(scene, data, asked, (of_kind, of_kind))
}

/// What they say of what is asked with each of several sets of data, in doubles; `None` where they say nothing. Many scenes are walked
/// for several sets at once; those of joined bodies have to be near the first one, whose panels they share.
pub fn roads(scene: &Scene, sets: &[Set], asked: Scope) -> Vec<Option<Told>> {
    let alone = |data: &Set| road_of(scene, data, asked).ok().map(Told::Alone);
    #[cfg(feature = "program")]
    if let Some(least) = least_together(scene) {
        let mut told = Vec::with_capacity(sets.len());
        for sets in sets.chunks(lanes::LANES) {
            match sets.len() < least {
                true => told.extend(sets.iter().map(alone)),
                false => told.extend(together(scene, sets, asked, &alone)),
            }
        }
        return told;
    }
    sets.iter().map(alone).collect()
}

/// So many sets of data are walked together at less cost than one by one, if any are: of joined bodies that costs as much as some four
/// of them alone.
#[cfg(feature = "program")]
fn least_together(scene: &Scene) -> Option<usize> {
    let placed = scene.lead().is_some();
    let joined = is_given(scene) && placed && !scene.is_still();
    if side_by_side(scene) { Some(2) } else { joined.then_some(5) }
}

/// The same of so many sets as go side by side.
#[cfg(feature = "program")]
fn together<'s>(
    scene: &Scene,
    sets: &'s [Set],
    asked: Scope,
    alone: &'s dyn Fn(&Set) -> Option<Told>,
) -> impl Iterator<Item = Option<Told>> + use<'s> {
    let walk = |data: &[f64]| of_kind::<Lanes>(scene, Numbers::new(scene, data), asked);
    let (road, astray) = lanes::side_by_side(sets, walk);
    let road = road.map(|road| Rc::new(road.telling(scene)));
    sets.iter().enumerate().map(move |(lane, data)| match &road {
        Ok(road) if astray >> lane & 1 == 0 => Some(Told::Lane(Rc::clone(road), lane)),
        _ => alone(data),
    })
}

/// Is it walked for several sets of data at once? A motion on lines and axles, with all data given and nothing asked by formulas.
pub fn side_by_side(scene: &Scene) -> bool {
    let placed = scene.lead().is_some() || scene.goes_in_phases();
    cfg!(feature = "program") && is_given(scene) && !placed && !matches!(scene.end, End::AtOnce)
}

/// Is nothing of it found from a measurement, and nothing asked by formulas?
fn is_given(scene: &Scene) -> bool {
    scene.formulas.found.is_none() && scene.formulas.asked.is_empty()
}

/// Everything that it finds, by the kind of the scene.
fn of_kind<T: Real>(scene: &Scene, n: Numbers<T>, asked: Scope) -> Result<Road<T>, Refusal> {
    Ok(of_kind_by(scene, n, asked, None)?.0)
}

/// [`of_kind`], by the steps of a rung if one is given, and what they cost.
fn of_kind_by<'a, T: Real>(
    scene: &'a Scene,
    n: Numbers<'a, T>,
    asked: Scope,
    by: Option<Steps<'a>>,
) -> Result<(Road<T>, Count), Refusal> {
    if scene.lead().is_some() {
        // Its formula wants accelerations that do not hang on the speed.
        return match by.map(|(rung, _)| rung.method()) {
            Some(method @ Method::Verlet) if scene.pinned().is_none() => Err(Refusal::NoMethod { method }),
            _ => joined::road_by(scene, &n, asked, by),
        };
    }
    if matches!(scene.end, End::AtOnce) {
        return Ok((at_once(scene, n, asked)?, Count::default()));
    }
    let mut walk = Walk::new(scene, n, asked)?;
    walk.by = by;
    walk.walk()
}

/// An instant: velocities and energies, and where the scene could go on, accelerations and forces.
fn at_once<T: Real>(scene: &Scene, n: Numbers<T>, asked: Scope) -> Result<Road<T>, Refusal> {
    let mut road = instant::road(scene, &n, asked)?;
    let walk = scene.tells_rates().then(|| Walk::new(scene, n.clone(), asked)).transpose();
    let Some(mut walk) = outcome::or_motion(scene, walk)? else {
        if asked.held {
            let normals = normals(scene, &n);
            let pressed = |b| Held::Pressed(b, n.publish(Quantity::Normal, normals[b]).f64());
            road.held.extend(with_normals(scene).map(pressed));
        }
        return Ok(road);
    };
    walk.road = road;
    let pulls = walk.pulls_at(T::zero());
    walk.contacts_if_rolled(&pulls);
    walk.standing(&pulls);
    walk.grip(&[pulls]);
    Ok(walk.road)
}

/// Bodies on a surface whose normal force is known.
fn with_normals(scene: &Scene) -> impl Iterator<Item = usize> {
    let known = |b: &usize| scene.tells(Label { quantity: Quantity::Normal, of: Owner::Body(*b) });
    (0..scene.bodies.len()).filter(|b| scene.bodies[*b].line.is_some_and(|l| l.surface)).filter(known)
}

/// [`road`], with the states at its events from the steps of this rung and not from the closed form; what it cost. `asked`
/// says which quantities are wanted: a greatest speed and a turning point are events of their own.
///
/// Errors: those of [`road`], and a run that does not reach its events.
pub fn road_by<T: Real>(
    scene: &Scene,
    data: &[f64],
    rung: Rung,
    asked: &dyn Fn(Quantity) -> bool,
) -> Result<(Road<T>, Count), Refusal> {
    // What is looked for is searched for in closed form.
    if scene.formulas.found.is_some() {
        return Err(Refusal::NoMethod { method: rung.method() });
    }
    let (road, count) = of_kind_by(scene, Numbers::new(scene, data), Scope::ALL, Some((rung, asked)))?;
    Ok((found::answering(road.telling(scene), scene, data, of_kind)?, count))
}

/// A rung, and which quantities are wanted of it.
pub type Steps<'s> = (Rung, &'s dyn Fn(Quantity) -> bool);

/// May a road go by steps? Not in a page: what a sheet asks has a closed form or a quadrature, and its page is to be small.
const STEPS: bool = cfg!(feature = "program");

/// What can be worked out by itself, such as kinetic friction, is judged beside terms that are at most so many times greater.
const SMALL: f64 = 40.0;

/// Where an acceleration is so many times smaller than that of the weight, the velocity ratios come from a unit force, not from
/// the forces that nearly balance.
const NEAR_BALANCE: f64 = 1e6;

/// A spring in numbers.
#[derive(Clone, Copy)]
struct Spring<T> {
    tie: usize,
    stiffness: T,
    stretch: T,
    rigid: bool,
    end: CordEnd,
    /// Stretch lost per metre of the way.
    lost: T,
    /// Stretch at equilibrium, friction of sliding left out; `None` where no spring moves anything.
    rest: Option<T>,
}

impl<T: Real> Spring<T> {
    /// Place at which its cord goes slack.
    fn slack(&self) -> Option<T> {
        (!self.rigid && self.lost.sign() > 0.0).then(|| self.stretch / self.lost)
    }
}

/// What varies: the tension of each spring, or the share of their growth that forces have.
type Pulls<T> = SmallVec<[T; 1]>;

/// A response under what varies.
fn under<T: Real>(pulls: &[T], of: impl Fn(usize) -> T) -> T {
    let varying = pulls.iter().enumerate().map(|(i, pull)| of(VARYING + i) * *pull);
    varying.fold(of(CONSTANT), T::balance)
}

/// Travel of a cord's end along the cord, where coordinates travel so far.
fn take_up<T: Real>(n: &Numbers<T>, end: &Action, travel: impl Fn(Degree) -> T) -> T {
    let Action { along, arm, tilt_deg, .. } = *end;
    let centre = travel(Degree::Along).signed(along);
    let centre = tilt_deg.map_or(centre, |tilt| centre * pose::direction(n, tilt)[0]);
    let Some((radius, sense)) = arm else { return centre };
    let arm = plant!("eom: unwinding of a cord", n.get(radius)).signed(sense);
    centre.balance(travel(Degree::Turn) * arm)
}

/// Finds the stretch of each spring where the forces balance: on any coordinate that a spring moves, the ending one first.
fn equilibrium<T: Real>(scene: &Scene, n: &Numbers<T>, springs: &mut [Spring<T>], response: &Response<T>) {
    let columns = VARYING..VARYING + springs.len();
    let mut coordinates = std::iter::once(scene.ending_coordinate()).chain(scene.coordinates());
    let moved = coordinates.find_map(|c| {
        let column = columns.clone().find(|k| !response.acceleration(c, *k).is_zero())?;
        Some((c, column))
    });
    let Some((c, column)) = moved else { return };
    let lost = |s: &Spring<T>| {
        take_up(n, &s.end.action(), |degree| {
            response.acceleration(Coordinate { body: s.end.body, degree }, column)
        })
    };
    let lost: Pulls<T> = springs.iter().map(lost).collect();
    let coast = response.acceleration(c, CONSTANT);
    let stretch = |i: usize| {
        let own = springs[i];
        if lost[i].is_zero() {
            return own.stretch;
        }
        // Acceleration per stretch that it loses, and that by the other springs with its own stretch.
        let (mut per, mut others) = (T::zero(), T::zero());
        for (j, spring) in springs.iter().enumerate() {
            let pull = response.acceleration(c, VARYING + j) * spring.stiffness;
            if i == j {
                per = per + pull;
                continue;
            }
            let share = lost[j] / lost[i];
            per = per + pull * share;
            others = others.balance(pull * (share * own.stretch).balance(-spring.stretch));
        }
        others.balance(-coast) / per
    };
    let rest: Pulls<T> = (0..springs.len()).map(stretch).collect();
    springs.iter_mut().zip(rest).for_each(|(spring, rest)| spring.rest = Some(rest));
}

/// What the end of a motion in this sense asks for, in its own measure: a way, a time or a speed.
fn measure<T: Real>(scene: &Scene, n: &Numbers<T>, sense: f64) -> Option<T> {
    match scene.end {
        End::Travel(_, way) => Some(n.get(way)),
        End::Position(_, place) => Some(n.get(place).signed(sense)),
        End::Time(_, time) => Some(n.get(time)),
        End::Speed(_, speed) => Some(n.get(speed).abs()),
        _ => None,
    }
}

/// Responses with one slipping contact taken as rolling.
type Rolled<T> = Vec<(usize, Response<T>)>;

/// How something has gone that hangs linearly on the coordinates: a point of a cord, a slip, a coordinate itself.
#[derive(Clone, Copy)]
pub(super) struct Gone<T> {
    /// Its velocity in that state of motion in which shares are told: at unit rate of the ending coordinate, or at the end.
    pub unit: T,
    /// Its velocity at the end.
    pub speed: T,
    /// Its displacement, and its path there and back.
    pub moved: T,
    pub path: T,
    /// What its acceleration adds to its velocity, and to half the square of that.
    pub change: T,
    pub work: T,
}

/// A motion with one freedom at its end.
#[derive(Clone, Copy)]
struct Ended<T> {
    state: State<T>,
    sense: f64,
    /// What the acceleration adds to the speed of the ending coordinate, and to half its square.
    change: T,
    gain: T,
}

/// What the bodies have together at the end: energy, its shares, the work of all forces, and the same seen from the ground where they
/// are carried.
struct Sums<T> {
    energy: T,
    moving: T,
    turning: T,
    work: T,
    carried: T,
}

impl<T: Real> Default for Sums<T> {
    fn default() -> Self {
        let zero = T::zero();
        Self { energy: zero, moving: zero, turning: zero, work: zero, carried: zero }
    }
}

struct Walk<'a, T: Real> {
    scene: &'a Scene,
    n: Numbers<'a, T>,
    end: Coordinate,
    springs: SmallVec<[Spring<T>; 1]>,
    /// Do the forces at the start balance, so that nothing accelerates?
    balanced: bool,
    /// Where forces grow: the way of the ending coordinate, averaged over that growth.
    early: Option<T>,
    /// Did it turn before its end? Its way is then not the distance between its ends.
    turned: bool,
    /// For each contact that is said to slip: as if it rolled.
    rolled: Rolled<T>,
    /// With all that slides held where it comes to rest, if the end says that it stays there.
    holding: Option<(Setting, Response<T>)>,
    /// At the end that is told of.
    response: Response<T>,
    /// Column whose accelerations have the ratios of the velocities.
    ratio_column: usize,
    /// The motion, where it goes in phases: apart, for it is large and mostly there is none.
    phases: Option<Box<Phases<'a, T>>>,
    /// Speed of the ending coordinate at the start.
    v0: T,
    /// Does it start with a speed, of whichever coordinate?
    started: bool,
    /// Steps instead of the closed form: the rung, and which quantities are wanted.
    by: Option<Steps<'a>>,
    asked: Scope,
    road: Road<T>,
}

fn springs<T: Real>(scene: &Scene, n: &Numbers<T>) -> SmallVec<[Spring<T>; 1]> {
    let numbers = scene.springs().map(|s| {
        let (stiffness, stretch) = (n.massive(s.stiffness_n_m), n.get(s.stretch_m));
        Spring { tie: s.tie, stiffness, stretch, rigid: s.rigid, end: s.from, lost: T::zero(), rest: None }
    });
    numbers.collect()
}

/// Velocity of a coordinate at the start: as a unit force on the one that is given would set it off; `None` where that moves nothing.
fn velocity<T: Real>(given: Option<(Coordinate, T)>, r: &Response<T>, c: Coordinate) -> Option<T> {
    let Some((known, v)) = given else { return Some(T::zero()) };
    let (own, lead) = (r.acceleration(c, r.last()), r.acceleration(known, r.last()));
    match c == known {
        true => Some(v),
        false if lead.is_zero() => None,
        false => Some(v * own / lead),
    }
}

impl<'a, T: Real> Walk<'a, T> {
    fn new(scene: &'a Scene, n: Numbers<'a, T>, asked: Scope) -> Result<Self, Refusal> {
        if scene.goes_in_phases() {
            return Self::in_phases(scene, n, asked);
        }
        let end = scene.ending_coordinate();
        // What is given as 0 is no speed.
        let given = scene.start.iter().find_map(|s| match s {
            Start::Speed(c, v) if !n.start(*c, *v).is_zero() => Some((*c, n.start(*c, *v))),
            _ => None,
        });
        let started = given.is_some();
        let mut springs = springs(scene, &n);
        let first: Pulls<T> = springs.iter().map(|s| s.stiffness * s.stretch).collect();
        let slipping: SmallVec<[usize; 2]> =
            (0..scene.ties.len()).filter(|t| matches!(scene.ties[*t], Tie::Slip { .. })).collect();
        let mut setting = Setting { probe: given.map(|(c, _)| c), ..Setting::loose(scene) };
        slipping.iter().for_each(|t| setting.holds[*t] = true);
        let response = respond(scene, &n, &setting)?;
        equilibrium(scene, &n, &mut springs, &response);
        if let Some((of, given)) = given
            && response.acceleration(of, response.last()).is_zero()
        {
            return Err(Refusal::Contradiction { of, given: given.f64(), follows: 0.0 });
        }
        let of = |r: &Response<T>, c| velocity(given, r, c).unwrap_or_else(T::zero);
        for (c, v) in scene.start_speeds() {
            outcome::consistent(c, n.start(c, v), of(&response, c))?;
        }
        let mut onset = Onset { scene, n: &n, pulls: &first, setting, response, rolled: Rolled::new() };
        if !slipping.is_empty() {
            onset.slips(&slipping)?;
        }
        if scene.ties.iter().any(|t| matches!(t, Tie::Slide { .. })) {
            onset.slides(if started { Some(&of) } else { None })?;
        }
        let Onset { setting, response, rolled, .. } = onset;
        let v0 = of(&response, end);
        let holding = scene.formulas.stays.then(|| {
            let held = Setting { holds: smallvec![true; scene.ties.len()], ..setting.clone() };
            respond(scene, &n, &held).ok().map(|response| (held, response))
        });
        let mut walk = Self::still((scene, n), (springs, response), asked);
        (walk.rolled, walk.holding) = (rolled, holding.flatten());
        (walk.v0, walk.started) = (v0, started);
        walk.find_ratios(setting)?;
        Ok(walk)
    }

    /// A motion in phases: what holds at its end, or at the start where that is not reached.
    fn in_phases(scene: &'a Scene, n: Numbers<'a, T>, asked: Scope) -> Result<Self, Refusal> {
        let springs = springs(scene, &n);
        let pulls: Pulls<T> = springs.iter().map(|s| s.stiffness * s.stretch).collect();
        let mut phases = Phases::follow(scene, &n, &pulls)?;
        let at = if phases.ended { phases.legs.len() - 1 } else { 0 };
        let response = phases.legs[at].response.clone();
        let mut walk = Self::still((scene, n), (springs, response), asked);
        walk.rolled = std::mem::take(&mut phases.rolled);
        walk.holding = phases.after.take().filter(|_| scene.formulas.stays);
        walk.v0 = phases.start_of(walk.end);
        (walk.started, walk.phases) = (true, Some(Box::new(phases)));
        Ok(walk)
    }

    /// Nothing known yet but springs and forces.
    fn still(
        (scene, n): (&'a Scene, Numbers<'a, T>),
        (springs, response): (SmallVec<[Spring<T>; 1]>, Response<T>),
        asked: Scope,
    ) -> Self {
        Self {
            scene,
            n,
            end: scene.ending_coordinate(),
            springs,
            balanced: false,
            early: None,
            turned: false,
            rolled: Rolled::new(),
            holding: None,
            response,
            ratio_column: CONSTANT,
            phases: None,
            v0: T::zero(),
            started: false,
            by: None,
            asked,
            road: Road::new(asked),
        }
    }

    /// In which response the accelerations have the ratios of the velocities, and whether all forces balance.
    fn find_ratios(&mut self, mut setting: Setting) -> Result<(), Refusal> {
        let (scene, end) = (self.scene, self.end);
        // The first spring that moves it.
        let pulling = VARYING..VARYING + self.springs.len();
        let moving = pulling.clone().find(|k| !self.response.acceleration(end, *k).is_zero());
        self.ratio_column = match moving {
            Some(column) => column,
            None if self.started => self.response.last(),
            None => CONSTANT,
        };
        let idle_spring = moving.is_none() && !self.springs.is_empty();
        let grows = !scene.growths.is_empty();
        // What drives it along the slope is all but taken up.
        let body = &self.n.bodies[end.body];
        let a = self.response.acceleration(Coordinate { body: end.body, degree: Degree::Along }, CONSTANT);
        let near_balance = self.ratio_column == CONSTANT
            && self.rolled.is_empty()
            && !a.is_zero()
            && a.size() * NEAR_BALANCE < (body.climb * self.n.gravity).size();
        if idle_spring || near_balance || grows && !self.started {
            // Ratios of accelerations that nearly vanish would lose digits; what grows may begin at nothing.
            setting.probe = Some(end);
            self.response = respond(scene, &self.n, &setting)?;
            self.ratio_column = self.response.last();
        }
        // Forces that balance but for the last digits of what is printed balance: what is given, and what comes of the weights.
        let accelerated = |r: &Response<T>| -> SmallVec<[T; 4]> {
            scene.coordinates().map(|c| r.acceleration(c, CONSTANT)).collect()
        };
        let tiny = |c: Coordinate| {
            c.degree == Degree::Turn
                || self.response.acceleration(c, CONSTANT).size() * NEAR_BALANCE < self.n.gravity.size()
        };
        let alone = self.springs.is_empty() && self.rolled.is_empty() && (grows || !scene.starts_from_rest());
        if alone && scene.coordinates().all(tiny) {
            let gravity = std::mem::replace(&mut self.n.gravity, T::zero());
            let weightless = respond(scene, &self.n, &setting);
            self.n.gravity = gravity;
            let given = accelerated(&weightless?);
            let all = given.iter().zip(accelerated(&self.response));
            self.balanced = all.into_iter().all(|(given, a)| given.apart(*given - a).is_zero());
        }
        Ok(())
    }

    /// What the springs pull at a place of the way: nothing where their cords are slack. Of forces that grow: nothing of their growth.
    fn pulls_at(&self, s: T) -> Pulls<T> {
        if !self.scene.growths.is_empty() {
            return smallvec![T::zero()];
        }
        let pull = |spring: &Spring<T>| {
            let stretch = spring.stretch.balance(-(spring.lost * s));
            let slack = stretch.sign() < 0.0 && !spring.rigid;
            if slack { T::zero() } else { spring.stiffness * stretch }
        };
        self.springs.iter().map(pull).collect()
    }

    /// The pull of the spring on this tie.
    fn pull_of(&self, tie: usize, pulls: &[T]) -> T {
        let of = self.springs.iter().zip(pulls).find(|(spring, _)| spring.tie == tie);
        of.map_or_else(T::zero, |(_, pull)| *pull)
    }

    fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.say_scaled(quantity, of, value, value.size());
    }
    fn say_scaled(&mut self, quantity: Quantity, of: Owner, value: T, scale: f64) {
        let way = matches!(quantity, Quantity::Distance | Quantity::Phi | Quantity::CordTravel);
        if self.asked.quantities.has(quantity) && !(self.turned && way) {
            self.road.said.push(Said::of(&self.n, Label { quantity, of }, value, scale));
        }
    }
    /// The velocity with which a motion that follows begins.
    fn leaves(&mut self, c: Coordinate, velocity: T) {
        if !self.scene.formulas.others.is_empty() {
            self.road.velocities.push((c, velocity));
        }
    }
    fn hold(&mut self, held: impl FnOnce(&Self) -> Held<T>) {
        if self.asked.held {
            self.road.held.push(held(self));
        }
    }
    /// Is one of these quantities asked?
    fn asks(&self, quantities: &[Quantity]) -> bool {
        self.asked.any(quantities)
    }

    /// Velocity of a coordinate per unit velocity of the ending one.
    fn ratio(&self, c: Coordinate) -> T {
        if c == self.end {
            return T::of(1.0);
        }
        self.response.acceleration(c, self.ratio_column)
            / self.response.acceleration(self.end, self.ratio_column)
    }
    fn along(&self, body: usize) -> Option<Coordinate> {
        self.scene.bodies[body].line.map(|_| Coordinate { body, degree: Degree::Along })
    }
    fn turn(&self, body: usize) -> Option<Coordinate> {
        self.scene.bodies[body].turns.then_some(Coordinate { body, degree: Degree::Turn })
    }
    /// Travel of a cord's end along the cord per unit travel of the ending coordinate.
    fn take_up(&self, end: &CordEnd) -> T {
        take_up(&self.n, &end.action(), |degree| self.ratio_of(Coordinate { body: end.body, degree }))
    }
    /// [`Walk::ratio`]; 0 of a coordinate that the body does not have.
    fn ratio_of(&self, c: Coordinate) -> T {
        let (line, turns) = (self.scene.bodies[c.body].line, self.scene.bodies[c.body].turns);
        let present = if c.degree == Degree::Along { line.is_some() } else { turns };
        if present { self.ratio(c) } else { T::zero() }
    }
    /// How something has gone at the end that hangs linearly on the coordinates.
    fn gone(&self, end: &Ended<T>, of: Linear<'_, T>) -> Gone<T> {
        if let Some(phases) = &self.phases {
            return phases.gone(of);
        }
        let ratio = of(&|c| self.ratio_of(c));
        let signed = |x: T| (ratio * x).signed(end.sense);
        Gone {
            unit: ratio,
            speed: signed(end.state.u),
            moved: signed(end.state.s),
            path: ratio.abs() * end.state.s,
            change: signed(end.change),
            work: ratio * ratio * end.gain,
        }
    }
    fn friction(&self, tie: usize, pulls: &[T]) -> T {
        under(pulls, |k| self.response.reaction(tie, k))
    }
    fn acceleration(&self, c: Coordinate, pulls: &[T]) -> T {
        self.acceleration_in(&self.response, c, pulls)
    }
    fn acceleration_in(&self, response: &Response<T>, c: Coordinate, pulls: &[T]) -> T {
        under(pulls, |k| match k {
            CONSTANT if self.balanced => T::zero(),
            _ => response.acceleration(c, k),
        })
    }
    /// Sense of "up the incline" for a body.
    fn up(&self, body: usize) -> f64 {
        if self.scene.bodies[body].line.is_none_or(|l| l.forward_up) { 1.0 } else { -1.0 }
    }

    fn walk(mut self) -> Result<(Road<T>, Count), Refusal> {
        if self.phases.is_some() {
            return self.through_phases();
        }
        let zero = T::zero();
        let pulls0 = self.pulls_at(zero);
        let a0 = self.acceleration(self.end, &pulls0);
        let v0 = self.v0;
        let sense = if !v0.is_zero() {
            v0.sign()
        } else if self.started {
            // The ties hold it while others move.
            0.0
        } else {
            a0.sign()
        };
        let wrong_way = self.scene.goes_wrong(sense);
        if self.rests(0.0) {
            for i in 0..self.springs.len() {
                if let Spring { tie, rest: Some(rest), .. } = self.springs[i] {
                    self.say(Quantity::XEq, Owner::Tie(tie), rest);
                }
            }
            self.small_oscillations();
        }
        self.contacts_if_rolled(&pulls0);
        if !self.scene.growths.is_empty() {
            return Ok((self.grown(wrong_way), Count::default()));
        }
        if sense == 0.0 || self.response.acceleration(self.end, self.ratio_column).is_zero() {
            self.rest(pulls0);
            return Ok((self.road, Count::default()));
        }

        let lost: Pulls<T> = self.springs.iter().map(|s| self.take_up(&s.end).signed(sense)).collect();
        self.springs.iter_mut().zip(lost).for_each(|(spring, lost)| spring.lost = lost);
        let legs = self.legs(a0, sense);
        let travel = Travel { u0: v0.abs(), legs: &legs };
        let turning = travel.turning();
        let limit = turning.unwrap_or_else(|| T::of(f64::INFINITY));
        let (asked, s) = self.asked(&travel, turning, sense);
        let reached = !wrong_way && s.is_some_and(|s| s.at_most(limit) && s.not_negative());
        let begins = if matches!(self.scene.end, End::Speed(..)) { travel.u0 } else { zero };
        let farthest = self.farthest(&travel, limit);
        let way = self.way(sense);
        self.road.course = Some(Course { way, asked, begins, farthest, ..Course::moving(sense, reached) });

        self.look(&travel, if reached { s } else { None }, turning, pulls0.clone());
        let path = self.stepped(&travel, if reached { s } else { None })?;
        let (met, peak) = path.map_or((None, None), |p| (p.end, p.fastest));
        self.extremes(&travel, peak, path.and_then(|p| p.turning).map(|rest| rest.s).or(turning));
        match s {
            Some(s) if reached => {
                let mut state = met.unwrap_or_else(|| travel.at(s));
                if matches!(self.scene.end, End::TurningPoint(_)) {
                    // At rest by the definition of the event, not by what rounding leaves.
                    state.u = zero;
                }
                let gain = travel.gain(state.s).scale2(-1);
                // Of constant forces the impulse is that of the acceleration, else the change of the speed.
                let change = match travel.legs {
                    [Leg { f, w2: None, .. }] => *f * state.time,
                    _ => state.u.balance(-travel.u0),
                };
                self.arrived(&Ended { state, sense, change, gain }, &self.pulls_at(state.s));
            }
            _ => self.standing(&pulls0),
        }
        Ok((self.road, path.map_or_else(Count::default, |p| p.count)))
    }

    /// The centre of the body whose turn is counted, if it has a line.
    fn centre(&self) -> Option<Coordinate> {
        self.along(self.end.body).filter(|_| self.end.degree == Degree::Turn)
    }

    /// Sense in which the centre of the ending body moves, where the end is counted in this one.
    fn way(&self, sense: f64) -> f64 {
        self.centre().map_or(sense, |line| sense * self.ratio(line).sign())
    }

    fn rest(&mut self, pulls: Pulls<T>) {
        self.road.course = Some(Course::at_rest());
        self.standing(&pulls);
        self.resting(&pulls);
        if !self.springs.is_empty() && self.along(self.end.body) == Some(self.end) {
            for q in [Quantity::VMax, Quantity::DAtVMax, Quantity::DTurn] {
                self.say(q, Owner::Body(self.end.body), T::zero());
            }
        }
        self.grip(&[pulls]);
    }

    /// Looks at the contacts and cords up to the end at `s`, or as far as the motion goes.
    fn look(&mut self, travel: &Travel<'_, T>, s: Option<T>, turning: Option<T>, pulls0: Pulls<T>) {
        let last = if self.scene.span == Span::ToEnd { s.or(turning) } else { turning };
        // A tension falls or grows all the way until its cord is slack: what hangs on all of them has its extremes there, at the start
        // and at the end of what is looked at.
        let slack =
            travel.legs.iter().skip(1).map(|leg| leg.from).filter(|at| last.is_none_or(|s| at.below(s)));
        let mut pulls = vec![pulls0];
        for s in slack.chain(last) {
            pulls.push(self.pulls_at(s));
        }
        self.grip(&pulls);
        if let Some(s) = s {
            for spring in self.springs.clone() {
                if let Some(slack) = spring.slack() {
                    self.hold(|_| Held::Slack(spring.tie, s, slack));
                }
            }
        }
    }

    /// Where it is fastest, and where it turns.
    fn extremes(&mut self, travel: &Travel<'_, T>, peak: Option<State<T>>, farthest: Option<T>) {
        let beyond = self.asks(&[Quantity::VMax, Quantity::DAtVMax, Quantity::DTurn]);
        let starts = !self.springs.is_empty() || !self.v0.is_zero();
        if !(beyond && starts && self.along(self.end.body) == Some(self.end)) {
            return;
        }
        let body = Owner::Body(self.end.body);
        if let Some((at, v)) = peak.map(|p| (p.s, p.u)).or_else(|| travel.fastest()) {
            self.say(Quantity::VMax, body, v);
            self.say(Quantity::DAtVMax, body, at);
        }
        self.say(Quantity::DTurn, body, farthest.unwrap_or_else(|| T::of(f64::INFINITY)));
    }

    fn through_phases(mut self) -> Result<(Road<T>, Count), Refusal> {
        let mut count = Count::default();
        let Some(mut phases) = self.phases.take() else { return Ok((self.road, count)) };
        let wrong_way = self.scene.goes_wrong(phases.sense);
        let asked = measure(self.scene, &self.n, phases.sense);
        let begins = if matches!(self.scene.end, End::Speed(..)) { self.v0.abs() } else { T::zero() };
        let farthest = phases.farthest();
        if let (Some((rung, _)), true) = (self.by.filter(|_| STEPS), phases.ended) {
            count = phases.stepped(rung)?;
        }
        let (reached, set_off, time) = (phases.ended && !wrong_way, phases.sense, phases.time());
        let goes = |c| if reached { phases.gone(&|of| of(c)).speed } else { phases.start_of(c) };
        let speed = goes(self.end);
        let sense = if speed.is_zero() { set_off } else { speed.sign() };
        // What is at rest as it comes to roll stays there.
        let rolls = (reached && matches!(self.scene.end, End::Rolling(_))).then_some(self.end);
        let way = self.centre().or(rolls).map_or(sense, |line| goes(line).sign());
        self.phases = Some(phases);
        self.road.course = Some(Course { way, asked, begins, farthest, ..Course::moving(sense, reached) });
        self.contacts_if_rolled(&[]);
        self.grip(&[Pulls::new()]);
        if reached {
            let zero = T::zero();
            let state = State { s: zero, u: zero, time };
            self.arrived(&Ended { state, sense, change: zero, gain: zero }, &[]);
        } else {
            self.standing(&[]);
        }
        Ok((self.road, count))
    }

    /// How the acceleration goes on from the start, where it is `a0`, and from each place at which a cord goes slack.
    fn legs(&self, a0: T, sense: f64) -> SmallVec<[Leg<T>; 1]> {
        let leg = |from: Option<T>| {
            let (mut f, mut w2) = (self.response.acceleration(self.end, CONSTANT).signed(sense), None);
            for (i, spring) in self.springs.iter().enumerate() {
                if from.zip(spring.slack()).is_some_and(|(from, slack)| from.reaches(slack)) {
                    continue;
                }
                let pull = self.response.acceleration(self.end, VARYING + i).signed(sense);
                let loss = plant!("eom: stiffness of the spring", spring.stiffness) * pull;
                f = f.balance(loss * spring.stretch.balance(-(spring.lost * from.unwrap_or_else(T::zero))));
                let loss = loss * spring.lost;
                if !loss.is_zero() {
                    w2 = Some(w2.map_or(loss, |w2: T| w2 + loss));
                }
            }
            match from {
                Some(from) => Leg { from, f, w2 },
                None => Leg { from: T::zero(), f: a0.signed(sense), w2 },
            }
        };
        let (mut legs, mut from) = (smallvec![leg(None)], None);
        let next = |from: Option<T>| {
            let ahead = self.springs.iter().filter_map(Spring::slack);
            let ahead = ahead.filter(|at| from.is_none_or(|from| from.below(*at)));
            ahead.reduce(|one, other| if other.below(one) { other } else { one })
        };
        while let Some(at) = next(from) {
            from = Some(at);
            legs.push(leg(from));
        }
        legs
    }

    /// Are all springs stretched at equilibrium, or can push, if they stand there at all? At the least not compressed (0), or more (1).
    fn rests(&self, least: f64) -> bool {
        self.springs.iter().all(|s| s.rigid || s.rest.is_none_or(|rest| rest.sign() >= least))
    }

    /// Small oscillations about equilibrium, where nothing rubs and the cords stay taut: `a = -omega^2 s`.
    fn small_oscillations(&mut self) {
        let held = self.response.acceleration(self.end, self.ratio_column).is_zero();
        if held || !self.scene.oscillates() || !self.rests(1.0) {
            return;
        }
        let loss = self.springs.iter().enumerate().map(|(i, spring)| {
            let pull = self.response.acceleration(self.end, VARYING + i);
            spring.stiffness * pull * self.take_up(&spring.end)
        });
        let Some(loss) = loss.reduce(|a, b| a + b).filter(|loss| !loss.is_zero()) else { return };
        if !self.asks(&[Quantity::OmegaSmall, Quantity::PeriodSmall]) {
            return;
        }
        let frequency = plant!("eom: frequency of small oscillations", loss.root());
        let turn = T::constant(Dd::PI.scale2(1));
        self.say(Quantity::OmegaSmall, Owner::Body(self.end.body), frequency);
        self.say(Quantity::PeriodSmall, Owner::Body(self.end.body), turn / frequency);
    }

    /// The motion under forces that grow with a power of time or place: so does the acceleration, and is integrated over that.
    fn grown(mut self, wrong_way: bool) -> Road<T> {
        let (zero, whole) = (T::zero(), T::of(1.0));
        let law = self.scene.law().unwrap_or(Law::EVEN);
        let power = plant!("eom: power of a growth", law.power::<T>());
        let senses = [self.v0, self.acceleration(self.end, &[zero]), self.acceleration(self.end, &[whole])];
        let sense = senses.iter().map(|x| x.sign()).find(|s| *s != 0.0).unwrap_or(0.0);
        if sense == 0.0 {
            self.road.course = Some(Course::at_rest());
            self.standing(&[whole]);
            self.resting(&[whole]);
            self.grip(&[smallvec![zero], smallvec![whole]]);
            return self.road;
        }
        let extent = self.scene.growing_for().map_or(zero, |x| self.n.get(x));
        let extent = if matches!(self.scene.end, End::Position(..)) { extent.signed(sense) } else { extent };
        let [u0, f0, f1] = senses.map(|x| x.signed(sense));
        let growth = self.response.acceleration(self.end, VARYING).signed(sense);
        // Over time the acceleration adds to the speed, over the way to half its square.
        let from = if law.with == Grows::Time { u0 } else { u0.square().scale2(-1) };
        let change = extent * f0.balance(growth / (power + whole));
        let last = from.balance(change);
        // It must not stop on the way: where the acceleration changes its sign the speed is least, else at an end.
        let least = if f0.sign() < 0.0 && f1.sign() > 0.0 {
            let share = -f0 / growth;
            let at =
                if law == Law::EVEN { share } else { T::of(trig::power(share.f64(), 1.0 / power.f64())) };
            from + extent * at * f0 * power / (power + whole)
        } else {
            last
        };
        let straight = least.sign() > 0.0 && (u0.sign() > 0.0 || f0.not_negative());
        self.turned = !straight && self.scene.may_turn() && !last.is_zero();
        let reached = !wrong_way && extent.not_negative() && (straight || self.turned);
        // Told is the sense in which it moves at the end.
        let back = if self.turned { last.sign() } else { 1.0 };
        let sense = sense * back;
        // How much of the greatest kinetic energy is left where it is slowest: for margins alone.
        let slowest = if straight && !least.same(last) {
            let share = T::leading(|| least.f64() / from.f64().max(last.f64()));
            if law.with == Grows::Time { share * share } else { share }
        } else {
            1.0
        };
        self.road.course = Some(Course {
            way: self.way(sense),
            asked: Some(extent),
            slowest,
            ..Course::moving(sense, reached)
        });
        self.grip(&[smallvec![zero], smallvec![whole]]);
        if !reached {
            self.standing(&[whole]);
            return self.road;
        }
        let two = power + T::of(2.0);
        let (s, u, early, time) = if law.with == Grows::Time {
            let bent = f0.scale2(-1).balance(growth / ((power + whole) * two));
            let s = extent * u0.balance(extent * bent);
            let part = f0 / two.scale2(1) + growth / ((power + whole).square() * two).scale2(1);
            (s, last, power * extent * (u0 / (power + whole) + extent * part), extent)
        } else {
            (extent, last.scale2(1).root(), power * extent / (power + whole), zero)
        };
        let [s, u, u0, early, change] = [s, u, u0, early, change].map(|x| x.signed(back));
        self.early = Some(early);
        let (gain, change) = match law.with {
            Grows::Time => ((change * u.balance(u0)).scale2(-1), change),
            Grows::Place => (change, u.balance(-u0)),
        };
        self.arrived(&Ended { state: State { s, u, time }, sense, change, gain }, &[whole]);
        self.road
    }

    /// Work of a given force over the way of its point: its last value over the whole way, less what it had not yet grown.
    fn work(&self, force: T, growth: Option<T>, point: &Gone<T>, sense: f64) -> T {
        match (self.early, growth) {
            (Some(early), Some(growth)) => {
                ((force + growth) * point.moved).balance(-(growth * early * point.unit.signed(sense)))
            }
            _ => force * point.moved,
        }
    }

    /// The states at the events by steps, where steps are asked for.
    fn stepped(&self, travel: &Travel<'_, T>, s: Option<T>) -> Result<Option<Path<T>>, Refusal> {
        let Some((rung, asked)) = self.by.filter(|_| STEPS) else { return Ok(None) };
        let event = s.and_then(|s| {
            let event = match self.scene.end {
                End::Travel(..) | End::Position(..) => Event::Place(s.f64()),
                End::Time(_, t) => Event::Time(self.n.get(t).f64()),
                End::Speed(_, u) => {
                    let u = self.n.get(u).abs();
                    if travel.u0.below(u) { Event::Rise(u.f64()) } else { Event::Fall(u.f64()) }
                }
                End::TurningPoint(_) => Event::Fall(0.0),
                End::Angle(..) | End::Rolling(_) | End::AtOnce | End::Leaves(_) | End::Equilibrium => {
                    return None;
                }
            };
            Some((event, s))
        });
        let trouble = |trouble| Refusal::Trouble { method: rung.method(), trouble };
        path(travel, event, (rung, asked)).map(Some).map_err(trouble)
    }

    /// What the event asks for, in its own measure, and the distance at which it comes.
    fn asked(&self, travel: &Travel<'_, T>, turning: Option<T>, sense: f64) -> (Option<T>, Option<T>) {
        let asked = measure(self.scene, &self.n, sense);
        let s = match self.scene.end {
            End::Time(..) => {
                let in_time = |t: &T| turning.is_none_or(|s| travel.at(s).time.reaches(*t));
                asked.filter(in_time).map(|t| travel.after(t))
            }
            End::Speed(..) => asked.and_then(|u| travel.reaching(u)),
            End::TurningPoint(_) => turning,
            _ => asked,
        };
        (asked, s)
    }

    /// The farthest that the motion goes, in the measure of the event.
    fn farthest(&self, travel: &Travel<'_, T>, limit: T) -> T {
        match self.scene.end {
            End::Time(..) if limit.is_finite() => travel.at(limit).time,
            End::Speed(..) => match (travel.fastest(), travel.starts_at().sign() > 0.0) {
                (Some((_, v)), _) => v,
                (None, true) => T::of(f64::INFINITY),
                (None, false) => travel.u0,
            },
            _ => limit,
        }
    }

    /// Friction that rolling would need, where a contact is said to slip.
    fn contacts_if_rolled(&mut self, pulls: &[T]) {
        use Quantity::{ARolling, FrictionIfRolled, MuRequired, SlipSpeed};
        if !self.asked.held && !self.asks(&[FrictionIfRolled, MuRequired, SlipSpeed, ARolling]) {
            return;
        }
        let mut known = std::mem::take(&mut self.rolled);
        for (t, tie) in self.scene.ties.iter().enumerate() {
            let Tie::Slip { body, mu_s, radius_m, .. } = *tie else { continue };
            let of = Owner::Body(body);
            let Some(at) = known.iter().position(|(of, _)| *of == t) else {
                self.thrown(t, None);
                continue;
            };
            let (_, rolled) = known.swap_remove(at);
            let friction = under(pulls, |k| rolled.reaction(t, k));
            let normal = rolled.normal(body);
            let scale = self.friction_scale(&rolled, body, friction, pulls);
            // Where no force at all acts along its line, what presses it has a size.
            let scale = if scale == 0.0 { normal.size() } else { scale };
            let needed = self.needed(t).map_or(friction.abs(), |later| later.larger(friction.abs()));
            self.say_scaled(FrictionIfRolled, of, friction.signed(self.up(body)), scale);
            self.say_scaled(MuRequired, of, needed.over(normal), scale / normal.size());
            let available = self.n.get(mu_s) * normal;
            let [along, turn] = [Degree::Along, Degree::Turn]
                .map(|degree| self.acceleration(Coordinate { body, degree }, pulls));
            if let Some(phases) = &self.phases {
                let comes = phases.until[t].is_some() && self.scene.end != End::AtOnce;
                if comes && needed.at_most(available) {
                    let line = Coordinate { body, degree: Degree::Along };
                    let a = under(pulls, |k| rolled.acceleration(line, k));
                    let with = self.n.bodies[body].carried.map(|[forward, _]| forward.acceleration);
                    let scale = scale / self.n.bodies[body].mass.size();
                    self.say_scaled(ARolling, of, with.map_or(a, |with| a.balance(with)), scale);
                }
                self.thrown(t, Some((friction, [needed, available])));
                continue;
            }
            let slip = along - self.n.get(radius_m) * turn;
            let against = slip.signed(-friction.sign());
            self.hold(|walk| {
                let force = |f: T| walk.n.publish(Quantity::Friction, f);
                Held::Slipping(t, force(friction), force(available), against, along.sign())
            });
        }
    }

    /// The most friction that a contact which could rub needs while it holds, if it does.
    fn needed(&self, tie: usize) -> Option<T> {
        let legs = self.phases.iter().flat_map(|phases| &phases.legs);
        legs.filter_map(|leg| leg.needs[tie]).reduce(T::larger)
    }

    /// What becomes of the slip of a body that starts with one; told if known, the friction with which it would roll, how much it needs
    /// while it rolls and what there is.
    fn thrown(&mut self, tie: usize, rolls: Option<(T, [T; 2])>) {
        let (rolling, [needed, available]) = rolls.unwrap_or((T::zero(), [T::zero(); 2]));
        let (Some(phases), Some(rub)) = (&self.phases, self.scene.ties[tie].rubbing()) else { return };
        let (slip0, speeds) = phases.slip(tie);
        let until = phases.until[tie];
        let line = Coordinate { body: rub.body, degree: Degree::Along };
        let start = phases.start_of(line);
        let v = phases.gone(&|of| of(line)).speed;
        let last = phases.legs.last().is_some_and(|leg| leg.holds[tie]);
        let ends_it = matches!(self.scene.end, End::Rolling(c) if c.body == rub.body);
        let time = match self.scene.end {
            End::Time(_, t) => Some(self.n.get(t)),
            _ => (phases.ended && !ends_it).then(|| phases.time()),
        };
        let ends = matches!(self.scene.end, End::Time(..) | End::Rolling(_)) && phases.ended;
        let force = |f: T| self.n.publish(Quantity::Friction, f).f64();
        let throw = Throw {
            tie,
            known: rolls.is_some(),
            slips: !slip0.is_zero(),
            closes: !slip0.is_zero() && until.is_some(),
            holds: needed.at_most(available),
            to_roll: ends_it
                || last
                || phases.through.is_some() && !phases.ended
                || time.zip(until).is_some_and(|(t, until)| until.status(t) < 0.0),
            times: time.map(|t| (t.f64(), until.map_or(f64::INFINITY, T::f64))),
            at_end: ends.then(|| (v.size(), start.size() + (v - start).size())),
            slip: slip0.size(),
            speeds,
            upkeep: force(rolling.signed(-slip0.sign())),
            kinetic: force(self.n.get(rub.mu_k) * self.response.normal(rub.body)),
            needed: force(needed),
            available: force(available),
        };
        let (of, still) = (Owner::Body(rub.body), self.scene.end == End::AtOnce);
        if !still {
            self.say_scaled(Quantity::SlipSpeed, of, slip0.abs(), speeds);
        }
        self.hold(|_| Held::Thrown(throw));
    }

    /// Sum of the magnitudes of the forces along the line of a body.
    fn friction_scale(&self, r: &Response<T>, body: usize, friction: T, pulls: &[T]) -> f64 {
        let n = &self.n.bodies[body];
        let weight = self.drawn(body);
        let a = self.along(body).map_or_else(T::zero, |c| under(pulls, |k| r.acceleration(c, k)));
        let inertial = n.mass * a;
        // The rest (pulls and tensions) follows from the force sum.
        let rest = inertial + weight - friction;
        inertial.size() + weight.size() + rest.size()
    }

    /// Weight of a body along its line, with what its mass takes to be carried.
    fn drawn(&self, body: usize) -> T {
        let n = &self.n.bodies[body];
        let weight = n.mass * n.climb * self.n.gravity;
        n.carried.map_or(weight, |[forward, _]| weight.balance(n.mass * forward.acceleration))
    }

    /// Normal forces, friction needed over the whole motion, tensions of the cords.
    fn grip(&mut self, places: &[Pulls<T>]) {
        if !self.asked.held && !self.asks(&[Quantity::Normal, Quantity::MuRequired]) {
            return;
        }
        for b in with_normals(self.scene) {
            let normal = self.response.normal(b);
            self.say(Quantity::Normal, Owner::Body(b), normal);
            self.hold(|walk| Held::Pressed(b, walk.n.publish(Quantity::Normal, normal).f64()));
        }
        let pulls = places.last().map_or(&[][..], |pulls| pulls);
        for (t, tie) in self.scene.ties.iter().enumerate() {
            // What slides may share its friction with others and still need some.
            if let Tie::Slide { body, mu_s, mu_k } = tie {
                let needed = self.needed(t).into_iter().chain(self.to_stay(t, pulls));
                if let Some(needed) = needed.reduce(T::larger) {
                    let available = self.n.get(mu_s.unwrap_or(*mu_k)) * self.response.normal(*body);
                    self.hold(|walk| {
                        let force = |f: T| walk.n.publish(Quantity::Friction, f);
                        Held::Rolling(t, force(needed), Some(force(available)))
                    });
                }
                continue;
            }
            let Some(forces) = self.reactions(t, places) else {
                if let Tie::Roll { body, .. } = tie
                    && self.scene.bodies[*body].line.is_some_and(|l| l.surface)
                {
                    self.road.leaves_open(Owner::Body(*body), &[Quantity::MuRequired]);
                }
                // A light rod may push as well.
                let watched = match tie {
                    Tie::Cord(cord) => cord.made == Made::Cord,
                    _ => matches!(tie, Tie::Roll { mu_s: Some(_), .. }),
                };
                if watched {
                    self.hold(|_| Held::Open(t));
                }
                continue;
            };
            match tie {
                Tie::Roll { body, mu_s, .. } => {
                    let most = forces.iter().map(|f| f.abs()).reduce(T::larger).unwrap_or_else(T::zero);
                    let normal = self.response.normal(*body);
                    let surface = self.scene.bodies[*body].line.is_some_and(|l| l.surface);
                    if surface && self.asks(&[Quantity::MuRequired]) {
                        let forces = self.friction_scale(&self.response, *body, most, pulls);
                        // Beside nothing but the rounding of its terms it is measured by them.
                        let nothing = most.size() <= 8.0 * U * forces;
                        let scale = if nothing { forces } else { most.size() } / normal.size();
                        self.say_scaled(Quantity::MuRequired, Owner::Body(*body), most.over(normal), scale);
                    }
                    self.hold(|walk| {
                        let force = |f: T| walk.n.publish(Quantity::Friction, f);
                        Held::Rolling(t, force(most), mu_s.map(|mu| force(walk.n.get(mu) * normal)))
                    });
                }
                Tie::Cord(c) if matches!(c.to, Far::Body(_) | Far::Fixed) && c.made == Made::Cord => {
                    let least =
                        (0..forces.len()).reduce(|i, j| if forces[j].below(forces[i]) { j } else { i });
                    self.hold(|walk| {
                        let least = least.unwrap_or(0);
                        let force = walk.n.publish(Quantity::Tension, forces[least]).f64();
                        let at = walk.moments(places).nth(least).unwrap_or((&walk.response, &[]));
                        let share = walk.share_of_tension(t, forces[least], at);
                        Held::Cord(t, force, share)
                    });
                }
                _ => {}
            }
        }
    }

    /// The reaction of a tie at each of the moments up to the end; `None` where it is open at one of them.
    fn reactions(&self, tie: usize, places: &[Pulls<T>]) -> Option<Pulls<T>> {
        let known = |(r, pulls): (&Response<T>, &[T])| {
            (!r.is_open(tie)).then(|| under(pulls, |k| r.reaction(tie, k)))
        };
        self.moments(places).map(known).collect()
    }

    /// The responses up to the end, each with what varies.
    fn moments<'p>(&'p self, places: &'p [Pulls<T>]) -> impl Iterator<Item = (&'p Response<T>, &'p [T])> {
        let legs = self.phases.as_ref().map_or(&[][..], |phases| &phases.legs[..]);
        let now = std::iter::once(&self.response).filter(|_| legs.is_empty());
        now.chain(legs.iter().map(|leg| &leg.response)).flat_map(|r| places.iter().map(move |p| (r, &p[..])))
    }

    /// The friction that a body needs to stay where it came to rest by sliding.
    fn to_stay(&self, tie: usize, pulls: &[T]) -> Option<T> {
        let (setting, response) =
            self.holding.as_ref().filter(|_| self.road.course.is_some_and(|c| c.reached))?;
        needs(self.scene, &self.n, (setting, response), pulls).ok()?[tie]
    }

    /// Tension of a cord as a share of the other forces (or moments) on what it pulls, under these tensions of the springs: near 0 the
    /// cord is about to go slack. The smaller share of its two ends.
    fn share_of_tension(&self, tie: usize, tension: T, (response, pulls): (&Response<T>, &[T])) -> f64 {
        let size = |x: T| x.f64().abs();
        let share = |end: Action| {
            let (b, n) = (end.body, &self.n.bodies[end.body]);
            let line = self.along(b);
            if line.is_none() && end.arm.is_none() {
                return 1.0;
            }
            let a = |c| self.acceleration_in(response, c, pulls);
            let mut others = match line {
                Some(line) => size(n.mass * a(line)) + size(self.drawn(b)),
                None => size(n.inertia * a(Coordinate { body: b, degree: Degree::Turn })),
            };
            for couple in self.scene.couples.iter().filter(|k| line.is_none() && k.body == b) {
                others += size(self.n.massive(couple.moment_n_m));
            }
            // The force of what acts on the body, or its moment.
            let acts = |force: T, action: &Action| match (line, action.arm) {
                (Some(_), _) => size(force),
                (None, arm) => arm.map_or(0.0, |(radius, _)| size(force * self.n.get(radius))),
            };
            for (t, other) in self.scene.ties.iter().enumerate().filter(|(t, _)| *t != tie) {
                let force = match other {
                    Tie::Cord(Cord { to: Far::Pull(p), .. }) => self.n.massive(*p),
                    Tie::Cord(Cord { to: Far::Spring { .. }, .. }) => self.pull_of(t, pulls),
                    _ => under(pulls, |k| response.reaction(t, k)),
                };
                let on_it = other.actions().filter(|action| action.body == b);
                others += on_it.map(|action| acts(force, &action)).sum::<f64>();
            }
            let own = acts(tension, &end);
            if others > 0.0 { own / others } else { 1.0 }
        };
        self.scene.ties[tie].actions().map(share).fold(1.0, f64::min)
    }

    /// What needs no ending event: accelerations and forces at the start.
    fn standing(&mut self, pulls: &[T]) {
        self.accelerations(pulls);
        self.forces(pulls);
        self.bound_of_gyration(pulls);
    }

    /// Where nothing sets off, everything stays as it is: no speed, no energy.
    fn resting(&mut self, pulls: &[T]) {
        let moves = |c: Coordinate| !self.acceleration(c, pulls).is_zero();
        if self.started || self.scene.carried.is_some() || self.scene.coordinates().any(moves) {
            return;
        }
        for b in 0..self.scene.bodies.len() {
            for (c, q) in [(self.along(b), Quantity::V), (self.turn(b), Quantity::Omega)] {
                if c.is_some() {
                    self.say(q, Owner::Body(b), T::zero());
                }
            }
        }
        self.say(Quantity::KineticEnergy, Owner::Scene, T::zero());
    }

    fn accelerations(&mut self, pulls: &[T]) {
        if !self.asks(&[Quantity::A, Quantity::Alpha]) {
            return;
        }
        for b in 0..self.scene.bodies.len() {
            for (c, q) in [(self.along(b), Quantity::A), (self.turn(b), Quantity::Alpha)] {
                if let Some(c) = c {
                    let a = self.acceleration(c, pulls);
                    let scale = if a.is_zero() { self.rate_that_vanishes(c, pulls) } else { a.size() };
                    match (c.degree, self.n.bodies[b].carried) {
                        (Degree::Along, Some([forward, _])) => {
                            let with = plant!("eom: acceleration of the carrier", forward.acceleration);
                            self.say_scaled(q, Owner::Body(b), a.balance(with), scale + with.size());
                        }
                        _ => self.say_scaled(q, Owner::Body(b), a, scale),
                    }
                }
            }
        }
    }

    /// Size of what cancels where a body does not accelerate while others do: the largest acceleration along a line, for a turn
    /// over the arm at which it acts.
    fn rate_that_vanishes(&self, c: Coordinate, pulls: &[T]) -> f64 {
        let lines = (0..self.scene.bodies.len()).filter_map(|b| self.along(b));
        let most = lines.map(|line| self.acceleration(line, pulls).size()).fold(0.0, f64::max);
        match c.degree {
            Degree::Along => most,
            Degree::Turn => {
                let acting = self.scene.ties.iter().flat_map(Tie::actions).filter(|a| a.body == c.body);
                let arms = acting.filter_map(|a| a.arm).map(|(arm, _)| self.n.get(arm).size());
                arms.filter(|arm| *arm > 0.0).map(|arm| most / arm).fold(0.0, f64::max)
            }
        }
    }

    /// Friction of the contacts and tension of the cords at these tensions of the springs.
    fn forces(&mut self, pulls: &[T]) {
        use Quantity::{PinAngle, PinForce, PinX, PinY};
        if self.asks(&[PinAngle, PinForce, PinX, PinY]) {
            (0..self.scene.bodies.len()).for_each(|b| self.axle(b, pulls));
        }
        if !self.asks(&[Quantity::Friction, Quantity::Tension, Quantity::RimForce]) {
            return;
        }
        for (t, tie) in self.scene.ties.iter().enumerate() {
            match tie {
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. }
                    if self.response.is_open(t) =>
                {
                    self.road.leaves_open(Owner::Body(*body), &[Quantity::Friction]);
                }
                Tie::Cord(c) if self.response.is_open(t) => {
                    self.road.leaves_open(Owner::Tie(t), &[c.force()])
                }
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => {
                    let f = self.friction(t, pulls);
                    let terms = self.friction_scale(&self.response, *body, f, pulls);
                    // Of what slides it is mu N; else it follows from the other forces.
                    let moves = self.along(*body).is_some_and(|c| !self.acceleration(c, pulls).is_zero());
                    let slides = moves && !matches!(tie, Tie::Roll { .. }) && !f.is_zero();
                    let scale = if slides { terms.min(SMALL * f.size()) } else { terms };
                    self.say_scaled(Quantity::Friction, Owner::Body(*body), f.signed(self.up(*body)), scale);
                }
                Tie::Cord(c) => match c.to {
                    Far::Pull(_) => {}
                    Far::Spring { .. } => self.say(Quantity::Tension, Owner::Tie(t), self.pull_of(t, pulls)),
                    Far::Body(_) | Far::Fixed => {
                        let f = self.friction(t, pulls);
                        let ends = tie.actions().map(|end| end.body);
                        let forces = ends.map(|b| self.friction_scale(&self.response, b, f, pulls));
                        let scale = if f.is_zero() { forces.fold(0.0, f64::max) } else { f.size() };
                        self.say_scaled(c.force(), Owner::Tie(t), f, scale);
                    }
                },
            }
        }
    }

    /// The force of a fixed axle: the forces on its body sum up to nothing.
    fn axle(&mut self, body: usize, pulls: &[T]) {
        let Some(cords) = self.scene.axle_pulls(body) else { return };
        let (of, quantities) =
            (Owner::Body(body), [Quantity::PinX, Quantity::PinY, Quantity::PinForce, Quantity::PinAngle]);
        let mass = self.n.bodies[body].mass;
        let weight = plant!("eom: weight on an axle", mass * self.n.gravity);
        // What carries the axle takes its body along.
        let carried = self.n.carried.unwrap_or([T::zero(); 2]);
        let taken = carried.map(|a| plant!("eom: force that takes an axle along", mass * a));
        let (mut x, mut y) = (taken[0], weight.balance(taken[1]));
        let mut size = weight.size() + taken[0].size() + taken[1].size();
        for (t, aim) in cords {
            let Tie::Cord(cord) = &self.scene.ties[t] else { continue };
            let pull = match cord.to {
                Far::Pull(force) => {
                    let growth = self.response.grown(GivenForce::Pull(t)).map(|growth| growth * pulls[0]);
                    self.n.massive(force) + growth.unwrap_or_else(T::zero)
                }
                Far::Spring { .. } => self.pull_of(t, pulls),
                _ if self.response.is_open(t) => {
                    self.road.leaves_open(of, &quantities);
                    return;
                }
                _ => self.friction(t, pulls),
            };
            let [right, up] = aim.unit(&self.n).map(|u| plant!("eom: pull on an axle", pull) * u);
            (x, y, size) = (x - right, y - up, size + pull.size());
        }
        let [x, y] = [x, y].map(|f| f.cleared(size));
        self.say_scaled(Quantity::PinX, of, x, size);
        self.say_scaled(Quantity::PinY, of, y, size);
        self.say_scaled(Quantity::PinForce, of, (x.square() + y.square()).root(), size);
        if !(x.is_zero() && y.is_zero()) {
            self.say(Quantity::PinAngle, of, trig::angle(y, x));
        }
    }

    fn arrived(&mut self, end: &Ended<T>, pulls: &[T]) {
        if !self.scene.grows_with_place() {
            self.say(Quantity::T, Owner::Scene, end.state.time);
        }
        self.accelerations(pulls);
        self.forces(pulls);
        self.bound_of_gyration(pulls);
        let mut sums = Sums::default();
        for b in 0..self.scene.bodies.len() {
            if let Some(c) = self.along(b) {
                self.line_at_end(c, end, pulls, &mut sums);
            }
            if let Some(c) = self.turn(b) {
                self.turn_at_end(c, end, pulls, &mut sums);
            }
        }
        if self.scene.carried.is_some() && self.phases.is_none() {
            self.say(Quantity::Work, Owner::Scene, sums.carried);
        }
        self.say(Quantity::KineticEnergy, Owner::Scene, sums.energy);
        if !sums.energy.is_zero() {
            let share = sums.turning / (sums.turning + sums.moving);
            self.say(Quantity::RotationalFraction, Owner::Scene, share);
        }
        let mut heat = None;
        for t in 0..self.scene.ties.len() {
            if let Some(warm) = self.tie_at_end(t, end) {
                heat = Some(heat.unwrap_or_else(T::zero) + warm);
            }
        }
        if let Some(heat) = heat {
            self.say(Quantity::Heat, Owner::Scene, heat);
        }
        // With a spring and in phases it may be the small rest of large works, which what is printed does not determine.
        if self.springs.is_empty() && self.phases.is_none() && self.scene.carried.is_none() {
            self.say(Quantity::Work, Owner::Scene, plant!("eom: work of all forces", sums.work));
        }
    }

    /// The way of a body along its line.
    fn line_at_end(&mut self, c: Coordinate, end: &Ended<T>, pulls: &[T], sums: &mut Sums<T>) {
        let (n, of, time) = (self.n.bodies[c.body], Owner::Body(c.body), end.state.time);
        let gone = self.gone(end, &|of| of(c));
        let mut v = gone.speed;
        let mut moved = plant!("eom: displacement of the centre", gone.moved);
        let mut sizes = [v.size(), gone.path.size()];
        let mut aside = T::zero();
        self.say(Quantity::Rise, of, moved * n.climb);
        if let Some([forward, out]) = n.carried {
            let (with, way) = (forward.after(time), forward.way(time));
            aside = out.after(time);
            v = v.balance(plant!("eom: speed of the carrier", with));
            moved = moved.balance(way);
            sizes = [sizes[0] + with.size(), sizes[1] + way.size()];
            sums.energy = sums.energy + (n.mass * aside.square()).scale2(-1);
            // Of constant forces, each over the way that is seen from the ground.
            let a = self.acceleration(c, pulls).balance(forward.acceleration);
            sums.carried = sums.carried.balance(n.mass * a * moved);
            sums.carried = sums.carried.balance(n.mass * out.acceleration * out.way(time));
        }
        self.leaves(c, if self.phases.is_some() { gone.speed } else { v });
        self.say_scaled(Quantity::V, of, speed(v, aside), sizes[0] + aside.size());
        self.say_scaled(Quantity::Displacement, of, moved, sizes[1]);
        self.say(Quantity::Distance, of, gone.path);
        let momentum = plant!("eom: impulse of all forces", n.mass) * gone.change;
        // What keeps its speed has the difference of two momenta.
        let before = (gone.speed - gone.change).size();
        self.say_scaled(Quantity::Impulse, of, momentum, n.mass.size() * (before + gone.speed.size()));
        sums.energy = sums.energy + (n.mass * v * v).scale2(-1);
        // Shares at unit rate: the speed would bring in its own rounding and leave by cancelling.
        sums.moving = sums.moving + n.mass * gone.unit * gone.unit;
        sums.work = sums.work.balance(n.mass * gone.work);
    }

    fn turn_at_end(&mut self, c: Coordinate, end: &Ended<T>, pulls: &[T], sums: &mut Sums<T>) {
        let (n, of) = (self.n.bodies[c.body], Owner::Body(c.body));
        let gone = self.gone(end, &|of| of(c));
        let w = gone.speed.abs();
        self.leaves(c, gone.speed);
        self.say(Quantity::Omega, of, w);
        self.say(Quantity::Phi, of, gone.moved.abs());
        let spin = plant!("eom: angular momentum", n.inertia) * w;
        self.say(Quantity::AngularMomentum, of, spin);
        sums.energy = sums.energy + (n.inertia * w * w).scale2(-1);
        sums.turning = sums.turning + n.inertia * gone.unit * gone.unit;
        sums.work = sums.work.balance(n.inertia * gone.work);
        if self.scene.carried.is_some() {
            let alpha = plant!("eom: couple on what is carried", self.acceleration(c, pulls));
            sums.carried = sums.carried.balance(n.inertia * alpha * gone.moved);
        }
        let Some(moment) = self.scene.couple_on(&self.n, c.body) else { return };
        // Of all couples on it, whose moment at the start is given.
        let acting = self.scene.couples.iter().enumerate().filter(|(_, k)| k.body == c.body);
        let growth = acting.filter_map(|(i, k)| Some(k.signed(self.response.grown(GivenForce::Couple(i))?)));
        let growth = growth.reduce(T::balance);
        self.say(Quantity::WorkCouple, of, self.work(moment, growth, &gone, end.sense));
        let last = growth.map_or(moment, |growth| moment + growth);
        self.say(Quantity::PowerCouple, of, last * gone.speed);
    }

    /// The way of a contact that rubs or of a cord, and the heat.
    fn tie_at_end(&mut self, t: usize, end: &Ended<T>) -> Option<T> {
        let scene = self.scene;
        if let Some(rub) = scene.ties[t].rubbing() {
            let of = Owner::Body(rub.body);
            let coordinate = |degree| Coordinate { body: rub.body, degree };
            let (v, w) = (coordinate(Degree::Along), coordinate(Degree::Turn));
            let c = rub.radius_m.map_or_else(T::zero, |c| plant!("eom: radius of the slip", self.n.get(c)));
            let slip = |of: &dyn Fn(Coordinate) -> T| of(v) - c * of(w);
            let slid = match &self.phases {
                Some(phases) => phases.slid(t, &slip),
                None => self.gone(end, &slip).path,
            };
            if rub.radius_m.is_some() || scene.carried.is_some() {
                let [centre, wound] = [self.gone(end, &|of| of(v)), self.gone(end, &|of| c * of(w))];
                let scale = centre.path.size() + wound.path.size();
                self.say_scaled(Quantity::SlipDistance, of, slid, scale);
            }
            // What the ties hold produces no heat, whatever its friction.
            let force = self.n.get(rub.mu_k) * self.response.normal(rub.body);
            let held = self.phases.is_none() && self.response.is_open(t);
            return Some(if held { T::zero() } else { force * slid });
        }
        let Tie::Cord(cord) = &scene.ties[t] else { return None };
        let (of, given) = (Owner::Tie(t), matches!(cord.to, Far::Pull(_)));
        if !given && !matches!(cord.to, Far::Spring { .. }) {
            return None;
        }
        let gone = self.gone(end, &|of| {
            take_up(&self.n, &cord.from.action(), |degree| of(Coordinate { body: cord.from.body, degree }))
        });
        if cord.from.tilt_deg.is_none() {
            self.say(Quantity::CordTravel, of, gone.path);
        }
        if let Far::Pull(force) = cord.to {
            let p = self.n.massive(force);
            let growth = self.response.grown(GivenForce::Pull(t));
            let last = growth.map_or(p, |growth| p + growth);
            self.say(Quantity::WorkPull, of, self.work(p, growth, &gone, end.sense));
            self.say(Quantity::PowerPull, of, last * gone.speed);
        }
        None
    }

    /// With F = 0: `a = X/m`, `alpha = M/(m k^2)` and `a = c alpha`, so `k^2 = c M/X`, with `X = m a - F` and `c M = I a + c^2 F` of
    /// the wheel as it is; infinite where friction points up at any k.
    fn bound_of_gyration(&mut self, pulls: &[T]) {
        let Some((tie, radius)) = self.scene.pulled_wheel() else { return };
        let Some(line) = self.along(0).filter(|_| self.asks(&[Quantity::KBound])) else { return };
        let (n, a, friction) = (self.n.bodies[0], self.acceleration(line, pulls), self.friction(tie, pulls));
        let force = (n.mass * a).balance(-friction).signed(self.up(0));
        let moment = (n.inertia * a).balance(self.n.get(radius).square() * friction).signed(self.up(0));
        if force.sign() > 0.0 && moment.sign() > 0.0 {
            self.say(Quantity::KBound, Owner::Body(0), (moment / force).root());
        } else if force.sign() <= 0.0 && moment.sign() >= 0.0 {
            self.say(Quantity::KBound, Owner::Body(0), T::of(f64::INFINITY));
        }
    }
}
