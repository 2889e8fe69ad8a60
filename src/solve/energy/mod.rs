//! The second road: velocity ratios from the ties, work of each force over the displacement of its own point, energy.
//!
//! With one freedom the balance of the whole gives the speed, its rate the acceleration, and the balance of one body alone
//! the reactions. With two (a wheel that slips) the power balance of each mode, the mass centre's among them, gives the
//! ratio of the velocities, which from rest is also that of the displacements, and the total balance then the speed.
pub mod account;
pub mod balance;
pub mod instant;
pub mod joined;
mod onset;
pub mod pendulum;
mod phases;
pub mod quadrature;
pub mod speeds;

use crate::num::dd::Dd;
use crate::num::eliminate::Equations;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Real, ball, trig};
use crate::scene::{
    Attach, Coordinate, Cord, Degree, End, Far, GivenForce, Label, Law, Numbers, Owner, Quantity, Scene,
    Span, SpringTie, Tie, speed,
};
use crate::solve::energy::account::{Account, Store, Stores};
use crate::solve::energy::balance::{PerTie, Power, Reactions};
use crate::solve::energy::onset::Rolled;
use crate::solve::energy::phases::{Follower, Phases};
use crate::solve::energy::quadrature::{Sum, Summed};
use crate::solve::energy::speeds::Mode;
use crate::solve::found;
use crate::solve::method::Method;
use crate::solve::outcome;
use crate::solve::outcome::{Course, Refusal, Road, Said, Scope};
use smallvec::{SmallVec, smallvec};
use std::cell::Cell;

/// Everything that work and energy say of a scene whose data are admissible.
///
/// Errors: ties that hold the ending coordinate fast, a start that contradicts them or leaves open what is asked.
pub fn road<T: Real>(scene: &Scene, data: &[f64]) -> Result<Road<T>, Refusal> {
    road_of(scene, data, Scope::ALL)
}

/// The same without the time of joined bodies if that is not asked: it is a quadrature of its own. Errors: those of [`road`].
pub fn road_of<T: Real>(scene: &Scene, data: &[f64], asked: Scope) -> Result<Road<T>, Refusal> {
    found::road_of(scene, data, asked, (of_kind, of_kind))
}

/// The datum that is found from a measurement, to a few units of doubles.
pub fn datum_found(scene: &Scene, data: &[f64]) -> Option<f64> {
    found::datum(scene, data, (of_kind, of_kind))
}

/// Everything that it finds, by the kind of the scene.
fn of_kind<T: Real>(scene: &Scene, n: Numbers<T>, asked: Scope) -> Result<Road<T>, Refusal> {
    Ok(of_kind_by(scene, n, asked, None)?.0)
}

/// [`of_kind`], by a quadrature of so many points if they are given, and what that cost.
fn of_kind_by<T: Real>(
    scene: &Scene,
    n: Numbers<T>,
    asked: Scope,
    points: Option<usize>,
) -> Result<(Road<T>, Count), Refusal> {
    if scene.lead().is_some() {
        return joined::road(scene, &n, asked, points);
    }
    if matches!(scene.end, End::AtOnce) {
        return Ok((at_once(scene, n)?, Count::default()));
    }
    let mut ledger = Ledger::open(scene, n)?;
    ledger.points = points;
    ledger.settle()
}

/// An instant: velocities and energies, and where the scene could go on, what its powers give.
fn at_once<T: Real>(scene: &Scene, n: Numbers<T>) -> Result<Road<T>, Refusal> {
    let road = instant::road(scene, &n)?;
    if !scene.tells_rates() {
        return Ok(road);
    }
    let settle = || {
        let ledger = Ledger::open(scene, n).map(Some);
        let Some(mut ledger) = outcome::or_motion(scene, ledger)? else { return Ok(road) };
        ledger.road = road;
        let n = &ledger.n;
        let pulls = at_start(scene, n);
        ledger.if_rolled();
        ledger.standing(&pulls);
        ledger.grip(&[pulls]);
        Ok(ledger.road)
    };
    // Where nothing rubs, no answer hangs on which way it goes.
    let rubs = scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. } | Tie::Slide { .. }));
    if rubs { settle() } else { ball::unwatched(settle) }
}

/// [`road`], with the work of the forces summed by a quadrature of this many points, or where there are none given in the
/// road's own way; what it cost.
///
/// Errors: those of [`road`].
pub fn road_by<T: Real>(
    scene: &Scene,
    data: &[f64],
    points: Option<usize>,
) -> Result<(Road<T>, Count), Refusal> {
    if scene.formulas.found.is_some() {
        return match points {
            Some(_) => Err(Refusal::NoMethod { method: Method::Gauss }),
            None => Ok((self::road(scene, data)?, Count::default())),
        };
    }
    if scene.goes_in_phases() && !matches!(scene.end, End::AtOnce) {
        return Err(Refusal::NoMethod { method: Method::Gauss });
    }
    let (road, count) = of_kind_by(scene, Numbers::new(scene, data), Scope::ALL, points)?;
    Ok((found::answering(road.telling(scene), scene, data, of_kind)?, count))
}

/// What springs pull at a place.
fn stretched<T: Real>(stores: &[Store<T>], s: T) -> Pulls<T> {
    stores.iter().map(|k| k.stiffness * k.stretch_at(s)).collect()
}

struct Ledger<'a, T: Real> {
    scene: &'a Scene,
    n: Numbers<'a, T>,
    end: Coordinate,
    /// The motion as one mode, unit rate of the ending coordinate.
    mode: Mode<T>,
    /// The same where nothing that could slide stays: what the drive at the start and the equilibrium are told of.
    loose: Mode<T>,
    /// Do the ties hold the ending coordinate, whatever moves beside it?
    held: bool,
    /// Accelerations of all modes at the start, summed to coordinates.
    start_rate: Mode<T>,
    /// Kinetic friction of contacts that slip or slide.
    kinetic: PerTie<Option<T>>,
    /// Friction that has to be overcome at the start, for the drive.
    at_start: PerTie<T>,
    /// For each contact that is said to slip: its friction if it rolled.
    rolled: Rolled<T>,
    /// Sense in which it would set off without sliding friction.
    inclined: f64,
    /// Speed of the ending coordinate at the start.
    v0: T,
    /// Does it start with a speed, of whichever coordinate?
    started: bool,
    /// Does anything move that is not held?
    free: bool,
    road: Road<T>,
    /// Where forces grow: the way, weighted with the share of their growth that they have there.
    late: Option<T>,
    /// Did it turn before its end? Then nothing is said of the length of its path.
    turned: bool,
    /// Points of a quadrature, where the work is to be summed.
    points: Option<usize>,
    /// The motion, where it goes in phases: apart, for it is large and mostly there is none.
    phases: Option<Box<Phases<T>>>,
    /// The reactions that were asked last, and the tensions of the springs for which.
    last: Option<(Pulls<T>, Reactions<T>)>,
}

/// What varies: the tension of each spring, or the share of their growth that forces have.
type Pulls<T> = SmallVec<[T; 1]>;

/// What the springs pull at the start. Of forces that grow: nothing of their growth.
fn at_start<T: Real>(scene: &Scene, n: &Numbers<T>) -> Pulls<T> {
    if !scene.growths.is_empty() {
        return smallvec![T::zero()];
    }
    scene.springs().map(|s| n.massive(s.stiffness_n_m) * n.get(s.stretch_m)).collect()
}

/// The motion that has in each mode this momentum, given with the sum of its terms: with powers for momenta, the accelerations.
fn motion<T: Real>(n: &Numbers<T>, modes: &[Mode<T>], given: impl Fn(&Mode<T>) -> (T, f64)) -> Mode<T> {
    let m = modes.len();
    let mut rows = Equations::new(m);
    for a in modes {
        let row = rows.row();
        for (cell, b) in row.iter_mut().zip(modes) {
            *cell = balance::inertia(n, a, b);
        }
        let (right, size) = given(a);
        row[m] = right.cleared(size);
        rows.sized(size);
    }
    let rates = rows.reduce(&[]).solution().unwrap_or_else(|| smallvec![T::of(f64::NAN); m]);
    combine(n.bodies.len(), modes, &rates)
}

/// The power in a mode of all forces that are known, and the sum of the magnitudes.
fn push<T: Real>(scene: &Scene, n: &Numbers<T>, mode: &Mode<T>, friction: &[T], pulls: &[T]) -> (T, f64) {
    let (mut power, mut size) = (T::zero(), 0.0);
    let mut add = |p: T| {
        power = power + p;
        size += p.size();
    };
    for p in balance::powers(scene, n, mode, friction) {
        add(p.power);
    }
    for (spring, pull) in scene.springs().zip(pulls) {
        add(*pull * mode.point(n, &spring.from));
    }
    if !scene.growths.is_empty() {
        add(pulls[0] * balance::grown_power(scene, n, mode));
    }
    (power, size)
}

/// Rates of the modes from their power balances, and their sum as one motion.
fn drive<T: Real>(scene: &Scene, n: &Numbers<T>, modes: &[Mode<T>], friction: &[T], pulls: &[T]) -> Mode<T> {
    motion(n, modes, |mode| push(scene, n, mode, friction, pulls))
}

/// Where a power is so many times smaller than those that make it up, they may balance.
const NEAR_BALANCE: f64 = 1e6;

/// Kinetic friction of each tie, zero where it has none.
fn frictions<T: Real>(kinetic: &[Option<T>]) -> PerTie<T> {
    kinetic.iter().map(|k| k.unwrap_or_else(T::zero)).collect()
}

/// `sum rate_j mode_j`.
fn combine<T: Real>(bodies: usize, modes: &[Mode<T>], rates: &[T]) -> Mode<T> {
    let mut sum: Mode<T> = Mode::still(bodies);
    for (mode, rate) in modes.iter().zip(rates) {
        for b in 0..bodies {
            sum.v[b] = sum.v[b].balance(*rate * mode.v[b]);
            sum.w[b] = sum.w[b].balance(*rate * mode.w[b]);
        }
    }
    sum
}

/// What the closed account gives at a place.
fn closed<T: Real>(account: &Account<T>, s: T, rest: bool) -> Summed<T> {
    let u = if rest { T::zero() } else { account.speed(s) };
    Summed { energy: account.energy(s), u, time: account.time(s, u) }
}

/// How something has gone that hangs linearly on the velocities.
#[derive(Clone, Copy)]
struct Gone<T> {
    /// Its velocity at unit rate of the mode, or at the end.
    unit: T,
    /// Its velocity before and at the end.
    before: T,
    speed: T,
    /// Its displacement, and its path there and back.
    moved: T,
    path: T,
}

/// A motion at its end.
#[derive(Clone, Copy)]
struct Ended<T> {
    /// Way, energy, speed and time of the mode.
    s: T,
    there: Summed<T>,
    sense: f64,
    u0: T,
    /// Twice the energy at unit rate.
    doubled: T,
    work: T,
}

impl<'a, T: Real> Ledger<'a, T> {
    fn open(scene: &'a Scene, n: Numbers<'a, T>) -> Result<Self, Refusal> {
        let end = scene.ending_coordinate();
        let pulls = at_start(scene, &n);
        if scene.goes_in_phases() {
            return Self::in_phases(scene, n, &pulls);
        }
        let mut now = Follower::new(scene, &n, &pulls);
        // What slides has no friction until the sense of the motion is known.
        for (kinetic, tie) in now.kinetic.iter_mut().zip(&scene.ties) {
            *kinetic = matches!(tie, Tie::Slide { .. }).then(T::zero);
        }
        let mut rolled = now.slips();
        let modes = speeds::modes(scene, &n, &[]);
        // Rate of the first mode at the start, from the first given speed that it has; the others have to agree.
        let rate0 = modes.first().map_or_else(T::zero, |m| {
            let leads = scene.start_speeds().find(|(c, _)| !m.of(*c).is_zero());
            leads.map_or_else(T::zero, |(c, v)| n.start(c, v) / m.of(c))
        });
        for (c, v) in scene.start_speeds() {
            let follows = modes.first().map_or_else(T::zero, |m| rate0 * m.of(c));
            outcome::consistent(c, n.start(c, v), follows)?;
        }
        // What is given as 0 is no speed.
        let started = scene.start_speeds().any(|(c, v)| !n.start(c, v).is_zero());
        let v0 = modes.first().map_or_else(T::zero, |m| rate0 * m.of(end));
        let loose = modes.first().cloned();
        let held = modes.iter().all(|m| m.of(end).is_zero());
        let mut start_rate = drive(scene, &n, &modes, &frictions(&now.kinetic), &pulls);
        let inclined = start_rate.of(end).sign();
        let mut at_start = frictions(&now.kinetic);
        let mut left = modes;
        if scene.ties.iter().any(|t| matches!(t, Tie::Slide { .. })) {
            let going: SmallVec<[f64; 4]> = match left.first() {
                Some(m) if started => m.v.iter().map(|v| (*v * rate0).sign()).collect(),
                _ => start_rate.v.iter().map(|v| v.sign()).collect(),
            };
            at_start = now.slides(&going, started);
            (left, start_rate) = (now.modes(), now.rate());
            // The work of what slides counts in what the contacts that slip would need to roll.
            rolled.iter_mut().for_each(|(t, friction)| *friction = now.friction_if_held(*t));
        }
        let lead = start_rate.of(end);
        let mode = if left.len() == 1 || lead.is_zero() {
            left.first().cloned().unwrap_or_else(|| Mode::still(scene.bodies.len()))
        } else {
            // From rest the displacements are as the accelerations.
            let mut mode = start_rate.clone();
            for x in mode.v.iter_mut().chain(&mut mode.w) {
                *x = *x / lead;
            }
            mode
        };
        let loose = loose.filter(|_| mode.of(end).is_zero()).unwrap_or_else(|| mode.clone());
        let kinetic = now.kinetic;
        let mut ledger = Self::still(scene, n, (mode, start_rate), kinetic);
        (ledger.loose, ledger.held, ledger.free) = (loose, held, !left.is_empty());
        (ledger.at_start, ledger.rolled, ledger.inclined) = (at_start, rolled, inclined);
        (ledger.v0, ledger.started) = (v0, started);
        Ok(ledger)
    }

    /// A motion in phases: what holds at its end, or at the start where that is not reached.
    fn in_phases(scene: &'a Scene, n: Numbers<'a, T>, pulls: &[T]) -> Result<Self, Refusal> {
        let phases = Phases::follow(scene, &n, pulls)?;
        let leg = &phases.legs[if phases.ended { phases.legs.len() - 1 } else { 0 }];
        let (rate, kinetic) = (leg.rate.clone(), leg.kinetic.clone());
        let mut ledger = Self::still(scene, n, (Mode::still(scene.bodies.len()), rate), kinetic);
        ledger.v0 = phases.ends()[0].of(ledger.end);
        ledger.rolled = phases.rolled.iter().map(|r| (r.tie, r.friction)).collect();
        (ledger.started, ledger.phases) = (true, Some(Box::new(phases)));
        Ok(ledger)
    }

    /// Nothing known yet but a mode, the accelerations and what rubs.
    fn still(
        scene: &'a Scene,
        n: Numbers<'a, T>,
        (mode, start_rate): (Mode<T>, Mode<T>),
        kinetic: PerTie<Option<T>>,
    ) -> Self {
        Self {
            scene,
            n,
            end: scene.ending_coordinate(),
            loose: mode.clone(),
            mode,
            held: false,
            start_rate,
            at_start: frictions(&kinetic),
            kinetic,
            rolled: Rolled::new(),
            inclined: 0.0,
            v0: T::zero(),
            started: false,
            free: true,
            road: Road::new(Scope::ALL),
            late: None,
            turned: false,
            points: None,
            phases: None,
            last: None,
        }
    }

    fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        if self.turned && matches!(quantity, Quantity::CordTravel | Quantity::Distance | Quantity::Phi) {
            return;
        }
        self.road.said.push(Said::of(&self.n, Label { quantity, of }, value, value.size()));
    }

    /// The velocity with which a motion that follows begins.
    fn leaves(&mut self, body: usize, degree: Degree, velocity: T) {
        if !self.scene.formulas.others.is_empty() {
            self.road.velocities.push((Coordinate { body, degree }, velocity));
        }
    }
    fn up(&self, body: usize) -> f64 {
        if self.scene.bodies[body].line.is_some_and(|l| !l.forward_up) { -1.0 } else { 1.0 }
    }

    /// The power of the constant forces per unit rate.
    fn constant(&mut self, sprung: bool) -> T {
        let frictions: PerTie<T> = frictions(&self.kinetic);
        let powers = balance::powers(self.scene, &self.n, &self.mode, &frictions);
        let size = powers.iter().fold(0.0, |sum, p| sum + p.power.size());
        let constant = powers.iter().fold(T::zero(), |sum, p| sum + p.power).cleared(size);
        let starts = !self.scene.growths.is_empty() || !self.scene.starts_from_rest();
        let near_balance = constant.size() * NEAR_BALANCE < size && !constant.is_zero();
        if near_balance && starts && !sprung && self.rolled.is_empty() {
            // Powers that balance but for the last digits of what is printed balance: of what is given, and of the weights.
            let mut weightless = self.n.clone();
            weightless.gravity = T::zero();
            let rubs = |(tie, force): (&Tie, &T)| match tie {
                Tie::Slide { body, mu_k, .. } => {
                    (self.n.get(*mu_k) * balance::normal(self.scene, &weightless, *body)).signed(force.sign())
                }
                _ => T::zero(),
            };
            let rubbing: PerTie<T> = self.scene.ties.iter().zip(&frictions).map(rubs).collect();
            let given = balance::powers(self.scene, &weightless, &self.mode, &rubbing);
            let given = given.iter().fold(T::zero(), |sum, p| sum + p.power);
            if given.apart(given - constant).is_zero() {
                self.start_rate = Mode::still(self.scene.bodies.len());
                return T::zero();
            }
        }
        constant
    }

    fn settle(mut self) -> Result<(Road<T>, Count), Refusal> {
        if self.phases.is_some() {
            return Ok((self.through_phases(), Count::default()));
        }
        let mut stores = self.stores(&self.mode);
        let constant = self.constant(!stores.is_empty());
        let start_powers = balance::powers(self.scene, &self.n, &self.loose, &self.at_start);
        let loosely = self.stores(&self.loose);
        let doubled = balance::inertia(&self.n, &self.mode, &self.mode);
        let pulls0 = at_start(self.scene, &self.n);
        let lead = self.start_rate.of(self.end);
        let sense = if !self.v0.is_zero() {
            self.v0.sign()
        } else if self.started {
            0.0
        } else {
            lead.sign()
        };
        self.equilibrium(&loosely, &start_powers, doubled);
        self.if_rolled();
        if !self.scene.growths.is_empty() {
            return Ok((self.grown(constant, doubled, (&start_powers, &loosely)), Count::default()));
        }
        // A power of nothing neither drives nor resists: for the margin alone, nothing of it is proved.
        let drive = ball::unwatched(|| {
            // Nothing drives what the ties hold.
            if self.held {
                return (T::zero(), T::zero());
            }
            self.driving(
                &start_powers,
                &loosely,
                [sense, self.inclined, 1.0].into_iter().find(|s| *s != 0.0).unwrap_or(1.0),
            )
        });
        if sense == 0.0 || lead.is_zero() && self.v0.is_zero() {
            self.rest(drive, pulls0);
            return Ok((self.road, Count::default()));
        }
        let constant = constant.signed(sense);
        stores.iter_mut().for_each(|k| k.lost = k.lost.signed(sense));
        let u0 = self.v0.abs();
        let energy0 = (doubled * u0.square()).scale2(-1);
        // A spring whose end does not move keeps its tension and does no work.
        let acting = stores.iter().filter(|k| !k.lost.is_zero()).copied().collect();
        let account = Account { constant, doubled, energy0, u0, stores: acting };

        let turning = account.turning();
        let limit = turning.unwrap_or_else(|| T::of(f64::INFINITY));
        let wrong_way = self.scene.goes_wrong(sense);
        let s = self.asked(&account, turning, sense);
        let arrives = |s: T| s.not_negative() && s.at_most(limit);
        // The turning point is where it is: no comparison with itself.
        let turns = matches!(self.scene.end, End::TurningPoint(_));
        let reached = !wrong_way && s.is_some_and(|s| turns || arrives(s));
        let way = self.way(&self.mode, sense);
        self.road.course = Some(Course { drive, way, ..Course::moving(sense, reached) });
        self.look(&stores, if reached { s } else { None }, turning);
        let summed = self.points.map(|points| Sum { account: &account, points, evaluations: Cell::new(0) });
        if (!stores.is_empty() || !u0.is_zero()) && self.end.degree == Degree::Along {
            self.extremes(&account, summed.as_ref(), turning);
        }
        match s {
            Some(s) if reached => {
                let rest = matches!(self.scene.end, End::TurningPoint(_));
                let there = summed.as_ref().map_or_else(|| closed(&account, s, rest), |sum| sum.at(s));
                let work = Account { energy0: T::zero(), ..account.clone() }.energy(s);
                self.arrived(&Ended { s, there, sense, u0, doubled, work }, &stretched(&stores, s));
            }
            _ => self.standing(&pulls0),
        }
        let evaluations = summed.map_or(0, |sum| sum.evaluations.get());
        Ok((self.road, Count { evaluations, ..Count::default() }))
    }

    /// Is it the turn of a body on a line that ends the motion?
    fn counts_turn(&self) -> bool {
        self.end.degree == Degree::Turn && self.scene.bodies[self.end.body].line.is_some()
    }

    /// Sense in which the centre of the ending body goes in this mode, taken in this sense.
    fn way(&self, mode: &Mode<T>, sense: f64) -> f64 {
        if self.counts_turn() { sense * mode.v[self.end.body].sign() } else { sense }
    }

    fn rest(&mut self, drive: (T, T), pulls: Pulls<T>) {
        self.road.course = Some(Course { drive, ..Course::at_rest() });
        self.standing(&pulls);
        self.resting(&pulls);
        if self.scene.is_sprung() && self.end.degree == Degree::Along {
            for q in [Quantity::VMax, Quantity::DAtVMax, Quantity::DTurn] {
                self.say(q, Owner::Body(self.end.body), T::zero());
            }
        }
        self.grip(&[pulls]);
    }

    /// The contacts over the way: the extremes of what springs pull are where the account of the way opens, where a cord goes slack and
    /// where it is closed.
    fn look(&mut self, stores: &[Store<T>], s: Option<T>, turning: Option<T>) {
        let closing = if self.scene.span == Span::ToEnd { s.or(turning) } else { turning };
        let slack = stores.iter().filter_map(Store::slack).filter(|at| closing.is_none_or(|s| at.below(s)));
        let places = std::iter::once(T::zero()).chain(slack).chain(closing);
        let pulls: SmallVec<[Pulls<T>; 3]> = places.map(|s| stretched(stores, s)).collect();
        self.grip(&pulls);
    }

    /// Where it is fastest, and where it turns.
    fn extremes(&mut self, account: &Account<T>, summed: Option<&Sum<T>>, turning: Option<T>) {
        let body = Owner::Body(self.end.body);
        if let Some((at, v)) = account.fastest() {
            let v = summed.map_or(v, |sum| sum.speed(at));
            self.say(Quantity::VMax, body, v);
            self.say(Quantity::DAtVMax, body, at);
        }
        let farthest = turning.unwrap_or_else(|| T::of(f64::INFINITY));
        self.say(Quantity::DTurn, body, farthest);
    }

    fn through_phases(mut self) -> Road<T> {
        let Some(phases) = &self.phases else { return self.road };
        let reached = phases.ended && !self.scene.goes_wrong(phases.sense);
        let [first, last] = phases.ends();
        let at = if reached { last } else { first };
        let own = at.of(self.end).sign();
        let sense = if own == 0.0 { phases.sense } else { own };
        // A body that begins to roll at rest goes nowhere.
        let centre = self.counts_turn() || reached && matches!(self.scene.end, End::Rolling(_));
        let way = if centre { at.v[self.end.body].sign() } else { sense };
        let (doubled, time) = (balance::inertia(&self.n, last, last), phases.time());
        self.road.course = Some(Course { way, ..Course::moving(sense, reached) });
        self.if_rolled();
        self.grip(&[Pulls::new()]);
        if reached {
            let (s, one) = (T::zero(), T::of(1.0));
            let there = Summed { energy: doubled.scale2(-1), u: one, time };
            self.arrived(&Ended { s, there, sense: 1.0, u0: one, doubled, work: s }, &[]);
        } else {
            self.standing(&[]);
        }
        self.road
    }

    /// Where the power of all but the sliding friction vanishes, and small oscillations about it.
    fn equilibrium(&mut self, stores: &[Store<T>], powers: &[Power<T>], doubled: T) {
        let given = |p: &&Power<T>| !p.tie.is_some_and(|t| matches!(self.scene.ties[t], Tie::Slide { .. }));
        let given = powers.iter().filter(given);
        let size = given.clone().fold(0.0, |sum, p| sum + p.power.size());
        let given = given.fold(T::zero(), |sum, p| sum + p.power).cleared(size);
        if stores.iter().all(|k| k.lost.is_zero()) {
            return;
        }
        let stretch = |own: &Store<T>| {
            if own.lost.is_zero() {
                return own.stretch;
            }
            // Power per stretch that it loses, and what the other springs give with its own stretch.
            let (mut per, mut power) = (own.stiffness * own.lost, -given);
            for k in stores.iter().filter(|k| k.tie != own.tie) {
                let (push, share) = (k.stiffness * k.lost, k.lost / own.lost);
                per = per + push * share;
                power = power.balance(push * (share * own.stretch).balance(-k.stretch));
            }
            power / per
        };
        let at_rest: Pulls<T> = stores.iter().map(stretch).collect();
        let taut = |least: f64| stores.iter().zip(&at_rest).all(|(k, x)| k.rigid || x.sign() >= least);
        if !taut(0.0) {
            return;
        }
        for (store, x) in stores.iter().zip(&at_rest) {
            self.say(Quantity::XEq, Owner::Tie(store.tie), *x);
        }
        if !self.mode.of(self.end).is_zero() && self.scene.oscillates() && taut(1.0) {
            // What the springs store in a displacement is what moves at the place of rest.
            let stiff = stores.iter().map(|k| k.stiffness * k.lost.square()).fold(T::zero(), |a, b| a + b);
            let frequency = plant!("energy: frequency of small oscillations", (stiff / doubled).root());
            let of = Owner::Body(self.end.body);
            self.say(Quantity::OmegaSmall, of, frequency);
            self.say(Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        }
    }

    /// The motion under forces that grow with a power of time, by impulse and momentum, or of place, by their work. `constant` is the
    /// power of all forces at the start per unit rate.
    fn grown(mut self, constant: T, doubled: T, at_start: (&[Power<T>], &[Store<T>])) -> Road<T> {
        let (zero, whole) = (T::zero(), T::of(1.0));
        let law = self.scene.law().unwrap_or(Law::EVEN);
        let growth = balance::grown_power(self.scene, &self.n, &self.mode);
        let found = [self.v0, constant, growth].iter().map(|x| x.sign()).find(|s| *s != 0.0);
        let sense = found.filter(|_| !self.held).unwrap_or(0.0);
        let drive = match constant.is_zero() {
            _ if self.held => (zero, zero),
            // What begins at nothing, or in a balance, is driven by its growth.
            true => (growth.signed(sense).larger(zero), (-growth.signed(sense)).larger(zero)),
            false => ball::unwatched(|| self.driving(at_start.0, at_start.1, sense)),
        };
        if sense == 0.0 {
            self.road.course = Some(Course { drive, ..Course::at_rest() });
            self.standing(&[whole]);
            self.resting(&[whole]);
            self.grip(&[smallvec![zero], smallvec![whole]]);
            return self.road;
        }
        let (extent, along) = match (self.scene.end, self.scene.growing_for()) {
            (End::Position(..), Some(x)) => (self.n.get(x).signed(sense), true),
            (end, x) => (x.map_or(zero, |x| self.n.get(x)), !matches!(end, End::Time(..))),
        };
        let [u0, first, growth] = [self.v0, constant, growth].map(|x| x.signed(sense));
        // The mean of a growth up to a place that is 1 at the end, and of what it has come to there.
        let mean = plant!("energy: mean of a growth", whole / (whole + law.power::<T>()));
        let energy0 = (doubled * u0.square()).scale2(-1);
        // Impulse of the forces over time, or their work over the way, up to a share of it; over what it moves.
        let gained = |share: T, grown: T| extent * share * (first + growth * grown * mean);
        let turn = -first / growth;
        let turns = first.sign() < 0.0 && growth.sign() > 0.0 && turn.below(whole);
        let (share, grown) = match turns {
            true if law == Law::EVEN => (turn, turn),
            true => (T::of(trig::power(turn.f64(), 2.0 / f64::from(law.halves))), turn),
            false => (whole, whole),
        };
        let held = if along { energy0 } else { doubled * u0 };
        let least = held + gained(share, grown);
        let declared = !self.scene.goes_wrong(sense);
        let sets_off = u0.sign() > 0.0 || first.not_negative();
        let onward = least.sign() > 0.0 && sets_off;
        let momentum = held + gained(whole, whole);
        self.turned = !onward && self.scene.may_turn() && !momentum.is_zero();
        let reached = declared && extent.not_negative() && (onward || self.turned);
        let turn_back = if self.turned { momentum.sign() } else { 1.0 };
        let sense = sense * turn_back;
        let way = self.way(&self.mode, sense);
        self.road.course = Some(Course { drive, way, ..Course::moving(sense, reached) });
        self.grip(&[smallvec![zero], smallvec![whole]]);
        if !reached {
            self.standing(&[whole]);
            return self.road;
        }
        // The way, and the mean way of a force that grows with its growth, from the sums of powers.
        let (s, late) = if along {
            (extent, extent * mean)
        } else {
            let push = extent.square() / doubled;
            let next = whole / (whole / mean + whole);
            let s = (u0 * extent).balance(push * first.scale2(-1).balance(growth * mean * next));
            (s, u0 * extent * mean + push * (first * next + (growth * mean.square()).scale2(-1)))
        };
        let work = (first * s).balance(growth * late);
        let energy = energy0 + work;
        let u = if along { (energy.scale2(1) / doubled).root() } else { u0 + gained(whole, whole) / doubled };
        let [s, late, u0, u] = [s, late, u0, u].map(|x| x.signed(turn_back));
        self.late = Some(late);
        let there = Summed { energy, u, time: extent };
        self.arrived(&Ended { s, there, sense, u0, doubled, work }, &[whole]);
        self.road
    }

    /// Work of a given force over the way of its point, and its size at the end.
    fn work(&self, force: T, growth: Option<T>, point: &Gone<T>, sense: f64) -> (T, T) {
        match (growth, self.late) {
            (Some(growth), Some(late)) => {
                let later = growth * late * point.unit.signed(sense);
                ((force * point.moved).balance(later), force + growth)
            }
            _ => (force * point.moved, force),
        }
    }

    /// How something has gone at the end that hangs linearly on the velocities.
    fn gone(&self, end: &Ended<T>, of: impl Fn(&Mode<T>) -> T) -> Gone<T> {
        if let Some(phases) = &self.phases {
            return phases.gone(&of);
        }
        let unit = of(&self.mode);
        let signed = |x: T| (unit * x).signed(end.sense);
        let path = (unit * end.s).abs();
        Gone { unit, before: signed(end.u0), speed: signed(end.there.u), moved: signed(end.s), path }
    }

    /// Driving and resisting power at the start, per unit rate.
    fn driving(&self, powers: &[Power<T>], stores: &[Store<T>], sense: f64) -> (T, T) {
        let (mut plus, mut minus) = (T::zero(), T::zero());
        let mut add = |power: T| {
            if power.sign() * sense > 0.0 {
                plus = plus + power.abs();
            } else {
                minus = minus + power.abs();
            }
        };
        for p in powers {
            add(p.power);
        }
        for k in stores {
            add(k.stiffness * k.stretch * k.lost);
        }
        let size = self.n.exponent(Quantity::Friction);
        (plus.scale2(size), minus.scale2(size))
    }

    fn asked(&self, account: &Account<T>, turning: Option<T>, sense: f64) -> Option<T> {
        match self.scene.end {
            End::AtOnce | End::Angle(..) | End::Rolling(_) | End::Leaves(_) | End::Equilibrium => None,
            End::Travel(_, d) => Some(self.n.get(d)),
            End::Position(_, x) => Some(self.n.get(x).signed(sense)),
            End::Speed(_, u) => account.where_speed(self.n.get(u).abs()),
            End::Time(_, t) => {
                let t = self.n.get(t);
                let late = turning.is_some_and(|s| account.time(s, account.speed(s)).below(t));
                if late { None } else { Some(account.place(t)) }
            }
            End::TurningPoint(_) => turning,
        }
    }

    fn if_rolled(&mut self) {
        let rolled = std::mem::take(&mut self.rolled);
        for (t, tie) in self.scene.ties.iter().enumerate() {
            let Some(rub) = tie.rubbing().filter(|rub| rub.radius_m.is_some()) else { continue };
            let Some((_, friction)) = rolled.iter().find(|(of, _)| *of == t) else {
                self.thrown(t, false);
                continue;
            };
            let (of, normal) = (Owner::Body(rub.body), balance::normal(self.scene, &self.n, rub.body));
            let later = self.phases.as_ref().and_then(|phases| phases.needed(t));
            let needed = later.map_or(friction.abs(), |later| later.larger(friction.abs()));
            self.say(Quantity::FrictionIfRolled, of, friction.signed(self.up(rub.body)));
            self.say(Quantity::MuRequired, of, needed.over(normal));
            if self.scene.end != End::AtOnce {
                self.thrown(t, needed.at_most(self.n.get(rub.mu_s) * normal));
            }
        }
    }

    /// The slip with which a contact starts, and how its body goes on once that has ended.
    fn thrown(&mut self, tie: usize, holds: bool) {
        let (Some(phases), Some(rub)) = (&self.phases, self.scene.ties[tie].rubbing()) else { return };
        let [v, rim] = phases::slip(&self.n, &rub, phases.ends()[0]);
        let rolled = phases.rolled.iter().find(|rolled| rolled.tie == tie);
        let a = rolled.and_then(|rolled| Some(rolled.rate.as_ref()?.v[rub.body])).filter(|_| holds);
        let of = Owner::Body(rub.body);
        self.say(Quantity::SlipSpeed, of, v.apart(rim).abs());
        if let Some(a) = a {
            let with = self.n.bodies[rub.body].carried.map(|[forward, _]| forward.acceleration);
            self.say(Quantity::ARolling, of, with.map_or(a, |with| a.balance(with)));
        }
    }

    /// Accelerations at this tension of the spring, from the power balance there.
    fn rate(&self, pulls: &[T]) -> Mode<T> {
        let constant = !self.scene.is_sprung() && self.scene.growths.is_empty();
        if constant || !self.free || self.scene.end == End::AtOnce {
            return self.start_rate.clone();
        }
        let frictions: PerTie<T> = frictions(&self.kinetic);
        drive(self.scene, &self.n, std::slice::from_ref(&self.mode), &frictions, pulls)
    }

    fn reactions(&mut self, pulls: &[T]) -> Reactions<T> {
        if let Some((at, known)) = &self.last
            && at.iter().zip(pulls).all(|(at, pull)| at.same(*pull))
        {
            return known.clone();
        }
        let rate = self.rate(pulls);
        let found = balance::reactions(self.scene, &self.n, &|c| rate.of(c), pulls, &self.kinetic);
        self.last = Some((pulls.into(), found.clone()));
        found
    }

    /// The springs, with the stretch that they lose in a mode.
    fn stores(&self, mode: &Mode<T>) -> Stores<T> {
        let of = |s: SpringTie| Store {
            tie: s.tie,
            stiffness: self.n.massive(s.stiffness_n_m),
            stretch: self.n.get(s.stretch_m),
            lost: mode.point(&self.n, &s.from),
            rigid: s.rigid,
        };
        self.scene.springs().map(of).collect()
    }

    fn grip(&mut self, places: &[Pulls<T>]) {
        for b in 0..self.scene.bodies.len() {
            if self.scene.bodies[b].line.is_some_and(|l| l.surface) {
                let normal = balance::normal(self.scene, &self.n, b);
                self.say(Quantity::Normal, Owner::Body(b), normal);
            }
        }
        let held: SmallVec<[Reactions<T>; 3]> = match &self.phases {
            Some(phases) => phases.legs.iter().map(|leg| leg.held.clone()).collect(),
            None => places.iter().map(|pulls| self.reactions(pulls)).collect(),
        };
        for (t, tie) in self.scene.ties.iter().enumerate() {
            if let Tie::Roll { body, .. } = tie {
                if held.iter().any(|held| held.is_open(t)) {
                    if self.scene.bodies[*body].line.is_some_and(|l| l.surface) {
                        self.road.leaves_open(Owner::Body(*body), &[Quantity::MuRequired]);
                    }
                    continue;
                }
                let most = held.iter().map(|held| held[t].abs()).reduce(T::larger).unwrap_or_else(T::zero);
                let normal = balance::normal(self.scene, &self.n, *body);
                if self.scene.bodies[*body].line.is_some_and(|l| l.surface) {
                    self.say(Quantity::MuRequired, Owner::Body(*body), most.over(normal));
                }
            }
        }
    }

    fn standing(&mut self, pulls: &[T]) {
        let rate = self.rate(pulls);
        self.say_rates(&rate);
        self.say_forces(pulls);
        self.bound_of_gyration();
    }

    /// No power at the start, no speed, no energy, ever.
    fn resting(&mut self, pulls: &[T]) {
        let rate = self.rate(pulls);
        if self.started || self.scene.carried.is_some() || rate.v.iter().chain(&rate.w).any(|x| !x.is_zero())
        {
            return;
        }
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if body.line.is_some() {
                self.say(Quantity::V, Owner::Body(b), T::zero());
            }
            if body.turns {
                self.say(Quantity::Omega, Owner::Body(b), T::zero());
            }
        }
        self.say(Quantity::KineticEnergy, Owner::Scene, T::zero());
    }

    fn say_rates(&mut self, rate: &Mode<T>) {
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if body.line.is_some() {
                let forward = self.n.bodies[b].carried.map(|[forward, _]| forward);
                let with = forward.map(|f| plant!("energy: rate of the carrier", f.acceleration));
                let seen = with.map_or(rate.v[b], |with| rate.v[b].balance(with));
                self.say(Quantity::A, Owner::Body(b), seen);
            }
            if body.turns {
                self.say(Quantity::Alpha, Owner::Body(b), rate.w[b]);
            }
        }
    }

    /// The force of a fixed axle, by what all forces would do if it gave way a little, to the right or up.
    fn axle(&mut self, body: usize, held: &Reactions<T>, pulls: &[T]) {
        let Some(cords) = self.scene.axle_pulls(body) else { return };
        let of = Owner::Body(body);
        let mut lifts: SmallVec<[[T; 2]; 4]> = SmallVec::new();
        let mass = self.n.bodies[body].mass;
        lifts.push([T::zero(), plant!("energy: weight that is lifted with an axle", mass * self.n.gravity)]);
        // Of 1/2 m (V + v)^2 the part m V v grows with V as the axle gives way.
        lifts.extend(self.n.carried.map(|rate| {
            rate.map(|a| plant!("energy: momentum of the body of an axle with the carrier", mass * a))
        }));
        for (t, aim) in cords {
            let Tie::Cord(cord) = &self.scene.ties[t] else { continue };
            let force = match cord.to {
                Far::Pull(force) => {
                    let growth = balance::grown(self.scene, &self.n, GivenForce::Pull(t));
                    growth.map_or_else(|| self.n.massive(force), |g| self.n.massive(force) + g * pulls[0])
                }
                Far::Spring { .. } => self.pull_of(t, pulls),
                Far::Body(_) | Far::Fixed if held.is_open(t) => {
                    let open = [Quantity::PinX, Quantity::PinY, Quantity::PinForce, Quantity::PinAngle];
                    self.road.leaves_open(of, &open);
                    return;
                }
                Far::Body(_) | Far::Fixed => held[t],
            };
            let given = plant!("energy: work of a cord as its axle gives way", -force);
            lifts.push(aim.unit(&self.n).map(|u| u * given));
        }
        let sum = |i: usize| {
            let size = lifts.iter().map(|l| l[i].size()).sum();
            lifts.iter().fold(T::zero(), |sum, l| sum + l[i]).cleared(size)
        };
        let (right, up) = (sum(0), sum(1));
        self.say(Quantity::PinX, of, right);
        self.say(Quantity::PinY, of, up);
        self.say(Quantity::PinForce, of, (right.square() + up.square()).root());
        if !(right.is_zero() && up.is_zero()) {
            self.say(Quantity::PinAngle, of, trig::angle(up, right));
        }
    }

    /// The pull of the spring on this tie.
    fn pull_of(&self, tie: usize, pulls: &[T]) -> T {
        let of = self.scene.springs().zip(pulls).find(|(spring, _)| spring.tie == tie);
        of.map_or_else(T::zero, |(_, pull)| *pull)
    }

    fn say_forces(&mut self, pulls: &[T]) {
        let held = self.reactions(pulls);
        (0..self.scene.bodies.len()).for_each(|b| self.axle(b, &held, pulls));
        for (t, tie) in self.scene.ties.iter().enumerate() {
            match tie {
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. }
                    if held.is_open(t) =>
                {
                    self.road.leaves_open(Owner::Body(*body), &[Quantity::Friction]);
                }
                Tie::Cord(c) if held.is_open(t) => self.road.leaves_open(Owner::Tie(t), &[c.force()]),
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => {
                    self.say(Quantity::Friction, Owner::Body(*body), held[t].signed(self.up(*body)));
                }
                Tie::Cord(c) => match c.to {
                    Far::Pull(_) => {}
                    Far::Spring { .. } => self.say(Quantity::Tension, Owner::Tie(t), self.pull_of(t, pulls)),
                    Far::Body(_) | Far::Fixed => self.say(c.force(), Owner::Tie(t), held[t]),
                },
            }
        }
    }

    fn arrived(&mut self, end: &Ended<T>, pulls: &[T]) {
        // At rest by the definition of the event, not by what rounding leaves.
        let rest = matches!(self.scene.end, End::TurningPoint(_)) && self.phases.is_none();
        let mut end = *end;
        if rest {
            (end.there.energy, end.there.u) = (T::zero(), T::zero());
        }
        let (energy, time) = (end.there.energy, end.there.time);
        let rate = self.rate(pulls);
        if !self.scene.grows_with_place() {
            self.say(Quantity::T, Owner::Scene, time);
        }
        self.say_rates(&rate);
        self.say_forces(pulls);
        self.bound_of_gyration();
        let gone = |b: usize| self.gone(&end, |mode| mode.v[b]);
        let centres: SmallVec<[Gone<T>; 2]> = (0..self.scene.bodies.len()).map(gone).collect();
        let seen = energy.balance(self.shared(centres.iter().map(|gone| gone.speed), time));
        self.say(Quantity::KineticEnergy, Owner::Scene, seen);
        if self.scene.carried.is_some() && self.phases.is_none() {
            let shared = self.shared(centres.iter().map(|gone| gone.before), T::zero());
            let before = (end.doubled * end.u0.square()).scale2(-1).balance(shared);
            self.say(Quantity::Work, Owner::Scene, seen.balance(-before));
        }
        let mut spinning = T::zero();
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if body.line.is_some() {
                self.line_at_end(b, &centres[b], time);
            }
            if body.turns {
                let gone = self.gone(&end, |mode| mode.w[b]);
                self.turn_at_end(b, &gone, end.sense);
                spinning = spinning + self.n.bodies[b].inertia * gone.unit * gone.unit;
            }
        }
        if !energy.is_zero() {
            self.say(Quantity::RotationalFraction, Owner::Scene, spinning / end.doubled);
        }
        let heat = (0..self.scene.ties.len()).filter_map(|t| self.tie_at_end(t, &end));
        if let Some(heat) = heat.reduce(|a, b| a + b) {
            self.say(Quantity::Heat, Owner::Scene, heat);
        }
        if !self.scene.is_sprung() && self.phases.is_none() && self.scene.carried.is_none() {
            self.say(Quantity::Work, Owner::Scene, plant!("energy: work of all forces", end.work));
        }
    }

    /// The way of a mass centre, and the momentum that it gains.
    fn line_at_end(&mut self, b: usize, gone: &Gone<T>, time: T) {
        let (of, numbers) = (Owner::Body(b), self.n.bodies[b]);
        let (mut along, mut moved) = (gone.speed, plant!("energy: way of the centre", gone.moved));
        let mut aside = T::zero();
        self.say(Quantity::Rise, of, moved * numbers.climb);
        if let Some([forward, out]) = numbers.carried {
            aside = out.after(time);
            along = along.balance(plant!("energy: speed of the carrier", forward.after(time)));
            moved = moved.balance(forward.way(time));
        }
        self.leaves(b, Degree::Along, if self.phases.is_some() { gone.speed } else { along });
        self.say(Quantity::V, of, speed(along, aside));
        self.say(Quantity::Displacement, of, moved);
        self.say(Quantity::Distance, of, gone.path);
        let after = plant!("energy: momentum after", numbers.mass * gone.speed);
        self.say(Quantity::Impulse, of, after.balance(-(numbers.mass * gone.before)));
    }

    /// The turn of a body, and the work of its couples.
    fn turn_at_end(&mut self, b: usize, gone: &Gone<T>, sense: f64) {
        let of = Owner::Body(b);
        self.leaves(b, Degree::Turn, gone.speed);
        self.say(Quantity::Omega, of, gone.speed.abs());
        self.say(Quantity::Phi, of, gone.moved.abs());
        let spin = plant!("energy: angular momentum", gone.speed.abs()) * self.n.bodies[b].inertia;
        self.say(Quantity::AngularMomentum, of, spin);
        // Each couple gives power to the turn that it acts along, and takes it from the other.
        let couples = self.scene.couples.iter().enumerate().filter(|(_, c)| c.body == b);
        let parts = couples.map(|(i, c)| {
            let growth = balance::grown(self.scene, &self.n, GivenForce::Couple(i));
            let (work, last) = self.work(self.n.massive(c.moment_n_m), growth, gone, sense);
            (c.signed(work), c.signed(last * gone.speed))
        });
        let sum = |one: (T, T), other: (T, T)| (one.0.balance(other.0), one.1.balance(other.1));
        if let Some((work, power)) = parts.reduce(sum) {
            self.say(Quantity::WorkCouple, of, work);
            self.say(Quantity::PowerCouple, of, power);
        }
    }

    /// The way of a contact that rubs or of a cord; the heat of the contact.
    fn tie_at_end(&mut self, t: usize, end: &Ended<T>) -> Option<T> {
        if let Some(rub) = self.scene.ties[t].rubbing() {
            let slip = |mode: &Mode<T>| {
                let [centre, rim] = phases::slip(&self.n, &rub, mode);
                centre - rim
            };
            let slid = match &self.phases {
                Some(phases) => phases.slid(t, &slip),
                None => self.gone(end, slip).path,
            };
            if rub.radius_m.is_some() || self.scene.carried.is_some() {
                self.say(Quantity::SlipDistance, Owner::Body(rub.body), slid);
            }
            // What static friction holds has none.
            let rubs = self.phases.is_some() || self.kinetic[t].is_some();
            let force = self.n.get(rub.mu_k) * balance::normal(self.scene, &self.n, rub.body);
            let force = if rubs { plant!("energy: heat of sliding", force) } else { T::zero() };
            return Some(force * slid);
        }
        let Tie::Cord(cord) = &self.scene.ties[t] else { return None };
        let given = if let Far::Pull(p) = cord.to { Some(p) } else { None };
        if given.is_none() && !matches!(cord.to, Far::Spring { .. }) {
            return None;
        }
        let (of, gone) = (Owner::Tie(t), self.gone(end, |mode| mode.point(&self.n, &cord.from)));
        if cord.from.tilt_deg.is_none() {
            self.say(Quantity::CordTravel, of, gone.path);
        }
        if let Some(p) = given {
            let p = plant!("energy: work of the pull", self.n.massive(p));
            let growth = balance::grown(self.scene, &self.n, GivenForce::Pull(t));
            let (work, last) = self.work(p, growth, &gone, end.sense);
            self.say(Quantity::WorkPull, of, work);
            self.say(Quantity::PowerPull, of, last * gone.speed);
        }
        None
    }

    /// Kinetic energy that is seen from the ground beside that of the motion on the carrier, at these velocities of the mass centres and
    /// a time: `m V v` and `1/2 m V^2` of each body.
    fn shared(&self, centres: impl Iterator<Item = T>, time: T) -> T {
        let mut sum = T::zero();
        for (numbers, v) in self.n.bodies.iter().zip(centres) {
            let Some(carried) = numbers.carried else { continue };
            let [forward, out] = carried.map(|c| c.after(time));
            sum = sum.balance(numbers.mass * forward * v);
            sum = sum.balance((numbers.mass * (forward.square() + out.square())).scale2(-1));
        }
        sum
    }

    /// Without friction the mass centre takes the power `X v`, the rotation what is left of the whole:
    /// `k^2 = c^2 (W' - X)/X` with `v = c omega`. Infinite where friction points up at any k.
    fn bound_of_gyration(&mut self) {
        let Some((_, radius)) = self.scene.pulled_wheel().filter(|_| !self.mode.v[0].is_zero()) else {
            return;
        };
        let (numbers, up) = (self.n.bodies[0], self.up(0));
        let mut centre = -(numbers.mass * self.n.gravity * numbers.climb);
        let mut wound = false;
        for tie in &self.scene.ties {
            if let Tie::Cord(Cord { from, to: Far::Pull(p), .. }) = tie {
                let p = self.n.massive(*p);
                centre = if from.forward { centre + p } else { centre - p };
                wound |= from.attach != Attach::Centre;
            }
        }
        let none: PerTie<T> = smallvec![T::zero(); self.scene.ties.len()];
        let powers = balance::powers(self.scene, &self.n, &self.mode, &none);
        let whole = powers.into_iter().fold(T::zero(), |sum, p| sum + p.power) / self.mode.v[0];
        let (centre, whole) = (centre.signed(up), whole.signed(up));
        // A pull at the centre turns nothing: so it is, whatever rounding leaves of the difference.
        let rotation = if wound { whole.balance(-centre) } else { T::zero() };
        let bound = match centre.sign() > 0.0 {
            true if rotation.sign() > 0.0 => (self.n.get(radius).square() * rotation / centre).root(),
            false if rotation.sign() >= 0.0 => T::of(f64::INFINITY),
            _ => return,
        };
        self.say(Quantity::KBound, Owner::Body(0), bound);
    }
}
