//! The motion of joined bodies in the plane: the rate of the leading angle and the time, integrated over that angle.
//!
//! The equations of motion give `q'' = A(q) + B(q) q'^2`, a linear equation for `y = q'^2 / 2` over the angle,
//! `dy/dq = A + 2 B y`, solved with its integrating factor `exp(-2 int B dq)` panel by panel. Where nothing rubs that is the inertia
//! over the angle, up to a constant, and `A` alone is needed. From rest the angle goes as the square of the variable, which takes
//! the root singularity out of the time, or beside an equilibrium as the square of its hyperbolic sine, as the time itself would
//! if the drive grew with the angle; the last half of a way that ends at rest is summed as the way back from there.
mod instant;
mod pin;
mod tell;

use crate::num::gauss::{self, PerNode, Rule, Unsettled};
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Real, root, trig};
use crate::scene::{End, Numbers, Owner, Quantity, Scene, pose};
use crate::solve::eom::integrate::{Event, Route, pace};
use crate::solve::eom::pendulum::Pendulum;
use crate::solve::eom::planar::{Mechanism, Rates, Response, State};
use crate::solve::eom::travel;
use crate::solve::eom::{STEPS, Steps};
use crate::solve::method::Rung;
use crate::solve::outcome::{self, Course, Held, Lacks, Refusal, Road, Scope};
use smallvec::SmallVec;
use std::cell::RefCell;

/// Angle after which a panel ends at the latest, radians.
const STRIDE: f64 = 1.0;

/// Panels of a way at most, of which one that is rough counts for so many: the way to a singularity takes fewer, what takes more
/// is rough by its rounding.
const PANELS: u32 = 1200;
const ROUGH: u32 = 10;

/// Way on which it is seen whether the drive grows, radians.
const BESIDE: f64 = 1.0 / 4096.0;
/// An equilibrium farther away than this leaves the time smooth, radians.
const NEAR: f64 = 0.25;

/// The share of the nodes of a panel that is the degree of coefficients which fall as its last ones do.
const DEGREE: f64 = 0.8;

/// A panel is no shorter than this share of the way: a singularity so far away is still seen.
const SHORTEST: f64 = 1.0 / (1u64 << 40) as f64;

/// So far does a motion go at most before a torsion spring is wound by half a turn.
const SHORT: f64 = 1.0 - SHORTEST;

/// A turning point in the first 2^-4 of a panel is looked for anew in a shorter one.
const EARLY: i32 = 4;

/// A normal force below this share of all weights does not press.
const PUSHES: f64 = 1e-9;

/// The motion of a mechanism in one sense from a place where half the square of the rate is known.
#[derive(Clone)]
struct Motion<'m, 'a, T: Real> {
    mechanism: &'m Mechanism<'a, T>,
    /// Leading angle where it starts, from the start of the scene.
    start: T,
    /// 1 if the leading angle grows, -1 if it shrinks.
    sense: f64,
    /// What it has there.
    from: Gain<T>,
    /// Beside an equilibrium: root of the way on which the drive would be doubled twice; else 0.
    near: T,
    /// For each joint: sense in which its point slides where it rubs, else 0.
    slides: SmallVec<[f64; 4]>,
    /// The same times the side of the guide to which it presses, 1 or -1: see [`rubbing`].
    rubs: SmallVec<[f64; 4]>,
    /// Springs that are met or let go of, and the leading angles at which, from the start of the scene.
    meets: SmallVec<[(usize, T); 4]>,
    /// What has a closed form.
    pendulum: Option<Pendulum<T>>,
    fine: Fine,
    /// Is the time asked for, or where it is at a time?
    timed: bool,
    /// Does nothing change on the way, so that no part of it is too long?
    steady: bool,
}

/// The panels of a motion, and the shares below which the last Legendre coefficients of its rate and of its time are smooth.
#[derive(Debug, Clone, Copy)]
struct Fine {
    rule: &'static Rule,
    rate: f64,
    time: f64,
    /// Are there joints that can only push, or rub?
    watched: bool,
}

impl Fine {
    /// Longer panels where something may happen within one: a turning point that is asked for (`turns`), a joint that can only push or
    /// rubs being watched there, or a speed.
    fn of<T: Real>(scene: &Scene, turns: bool) -> Self {
        let watched = scene.joints.iter().any(|j| j.kind.is_one_sided() || j.kind.rubs().is_some());
        let ending = !watched && !turns && matches!(scene.end, End::Angle(..));
        let (rule, rate, time) = if ending { gauss::ending::<T>() } else { gauss::long::<T>() };
        Self { rule, rate, time, watched }
    }
}

/// What the rate has come to.
#[derive(Debug, Clone, Copy)]
struct Gain<T> {
    /// Half its square.
    half_square: T,
    /// The integrating factor: the inertia over the angle where nothing rubs, else 1 at the start of each panel.
    factor: T,
}

/// A part of the way on which everything is smooth, told by a variable of which the way is the square where it starts from rest.
struct Panel<T> {
    /// The variable at its ends.
    ends: (T, T),
    /// Half the square of the rate at its nodes.
    squares: PerNode<T>,
    /// The kinetic energy at its nodes up to a factor; where something rubs half the square of the rate stands for it.
    energies: PerNode<f64>,
    /// What the rate comes to at its end.
    last: Gain<T>,
    /// The time over it, per share of it, at its nodes.
    times: PerNode<T>,
    /// For each joint that can only push or rubs: its normal force at the nodes.
    pushes: Watched<T>,
    /// What no longer slides as at the start, at the nodes.
    turned_back: PerNode<Option<usize>>,
    /// How far the last coefficients are above what is smooth.
    rough: f64,
    /// The same of the time.
    uneven: f64,
}

impl<T: Real> Panel<T> {
    /// What turns about where this stops a motion, between the nodes: the normal force of a joint, half the square of the rate less a
    /// level, or all of it.
    fn value(&self, rule: &Rule, why: Why, level: Option<(T, bool)>, x: T) -> T {
        let share = (x - self.ends.0) / (self.ends.1 - self.ends.0);
        match (why, level) {
            (Why::Leaves(joint), _) => {
                let forces = self.pushes.iter().find(|p| p.0 == joint);
                forces.map_or_else(T::zero, |(_, forces)| rule.at(forces, share))
            }
            (Why::Speed, Some((level, _))) => rule.at(&self.squares, share) - level,
            _ => rule.at(&self.squares, share),
        }
    }
}

/// What may stop a motion, with its last values at the nodes.
type Looked<T> = (Why, SmallVec<[(T, T); 3]>);
/// Something of each joint that can only push or rubs, at the nodes of a panel.
type Watched<T> = SmallVec<[(usize, PerNode<T>); 2]>;
/// Sees a panel and what the rate has come to at its start; true ends the march.
type Visit<'v, T> = dyn FnMut(&Panel<T>, Gain<T>) -> Result<bool, Refusal> + 'v;

/// What is asked of the end and where the motion starts in its measure; how far at most it is looked for; half a square of the rate.
type Wanted<T> = ((Option<T>, T), T, Option<T>);
/// What bodies do with these senses of friction.
type Responds<'r, T> = dyn Fn(&[f64]) -> Result<Response<T>, Refusal> + 'r;

/// Where a motion stops.
#[derive(Debug, Clone, Copy)]
struct Stop<T> {
    /// Leading angle turned, radians.
    way: T,
    /// Half the square of the rate.
    half_square: T,
    why: Why,
    /// The time until then, where the panels give it.
    time: Option<T>,
    /// See [`Course::slowest`].
    slowest: f64,
}

/// Kinetic energies that are seen one after the other: the greatest, the least since then, and the least share of the greatest
/// after which one has risen again.
#[derive(Debug, Clone, Copy)]
struct Passes {
    greatest: f64,
    least: f64,
    share: f64,
}

impl Passes {
    const NONE: Self = Self { greatest: 0.0, least: f64::INFINITY, share: 1.0 };
    fn see(&mut self, energy: f64) {
        if self.greatest > 0.0 && self.least < energy {
            self.share = f64::min(self.share, self.least / self.greatest);
        }
        self.least = if self.greatest < energy { energy } else { f64::min(self.least, energy) };
        self.greatest = f64::max(self.greatest, energy);
    }
}

/// What stops a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Why {
    /// It has got as far as was looked.
    Far,
    /// It comes to rest.
    Rest,
    /// It has the speed that is asked.
    Speed,
    /// This joint no longer pushes.
    Leaves(usize),
    /// What rubs at this joint turns back, or presses on the other side of its guide: not before here, or as if it had not.
    Turns(usize),
}

/// What the equations of motion say of what is asked in a scene of joined bodies; with the state at its end from the steps of a
/// rung, if one is given, and what they cost.
///
/// Errors: equations that do not determine the motion, a quadrature that does not settle, a run that does not reach its end.
pub fn road_by<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    asked: Scope,
    by: Option<Steps>,
) -> Result<(Road<T>, Count), Refusal> {
    let mut mechanism = Mechanism::new(scene, n)?;
    let pinned = scene.pinned().map(|(body, _)| body);
    loop {
        let (count, road) = (Count::default(), Road::new(asked));
        let mut teller =
            Teller { scene, n, mechanism: &mechanism, asked, by, pinned, count, road, goes_on: false };
        follow(&mut teller)?;
        let Teller { count, road, goes_on, .. } = teller;
        if !goes_on || !mechanism.layout.looks_farther() {
            return Ok((road, count));
        }
    }
}

/// Follows the bodies to the instant or the end that is asked, and tells what is there.
fn follow<T: Real>(teller: &mut Teller<T>) -> Result<(), Refusal> {
    let (scene, mechanism) = (teller.scene, teller.mechanism);
    let mut spin = if scene.tells_speeds() { T::zero() } else { mechanism.start_rate()? };
    if teller.pinned.is_some() {
        teller.tell_lasting(spin)?;
    }
    let nothing = no_friction(scene);
    if matches!(scene.end, End::AtOnce) {
        return instant::at_once(teller, spin, &nothing);
    }
    if scene.end == End::Equilibrium {
        return teller.tell_equilibrium(&nothing);
    }
    let state = mechanism.state(T::zero(), true)?;
    if scene.is_struck() {
        let jumps = mechanism.struck(&state)?;
        // What strikes straight at a joint moves nothing.
        let most = pose::blows(scene, teller.n) * mechanism.size() / mechanism.inertia(&state).size();
        spin = spin.balance(jumps.lead.0.cleared(most));
        teller.tell_blow(&state, &jumps);
    }
    let free = mechanism.respond(&state, &nothing)?;
    let (a, b) = free.lead;
    // In a balance rounding is left of the drive.
    let turning = match teller.pinned {
        Some(_) => teller.terms(&state),
        None => teller.drives() / mechanism.inertia(&state).size(),
    };
    let first = a.balance(b * spin.square()).cleared(turning);
    let sense = if spin.is_zero() { first.sign() } else { spin.sign() };
    let slides = sliding(mechanism, &state, (&state.rates, sense));
    let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| mechanism.respond(&state, rubs))?;
    let rubbed = slides.iter().any(|s| *s != 0.0);
    let factor = if rubbed { T::of(1.0) } else { mechanism.inertia(&state) };
    let from = Gain { half_square: spin.square().scale2(-1), factor };
    let motion = Motion {
        slides,
        rubs,
        meets: meets(mechanism, sense, mechanism.layout.horizon()),
        pendulum: teller.pendulum(&state, sense, spin),
        steady: scene.spins_in_place(),
        timed: teller.asked.quantities.has(Quantity::T) || matches!(scene.end, End::Time(..)),
        ..Motion::new(mechanism, T::zero(), sense, from)
    };
    // Friction may hold what would set off without it.
    let (a, b) = if rubbed { mechanism.respond(&state, &motion.rubs)?.lead } else { (a, b) };
    let sets_off = a.balance(b * spin.square()).cleared(turning).signed(sense);
    if sense == 0.0 || spin.is_zero() && sets_off.sign() <= 0.0 {
        teller.road.course = Some(Course::at_rest());
        return teller.tell_standing(&state, &free, T::zero());
    }
    motion.set_off(&state)?.to_its_end(teller)
}

/// Step in which places on the way are looked for, radians.
fn look<T: Real>() -> T {
    T::of(STRIDE / 16.0)
}

/// For each joint that nothing rubs there.
fn no_friction(scene: &Scene) -> SmallVec<[f64; 4]> {
    scene.joints.iter().map(|_| 0.0).collect()
}

/// Where springs that only push or pull are met or let go of on a way from the start: which, and the leading angle.
fn meets<T: Real>(mechanism: &Mechanism<T>, sense: f64, far: T) -> SmallVec<[(usize, T); 4]> {
    let met = mechanism.layout.meets(false, sense, (far, look()));
    met.into_iter().map(|(s, way)| (s, way.signed(sense))).collect()
}

/// The senses in which points slide in guides that rub, and wheels at surfaces, by the velocities (or accelerations from rest) of mass
/// centres and turns, and this sense.
fn sliding<T: Real>(
    mechanism: &Mechanism<T>,
    state: &State<T>,
    (moves, sense): (&Rates<T>, f64),
) -> SmallVec<[f64; 4]> {
    let joints = mechanism.scene.joints.iter().enumerate();
    let slip = |j: usize| mechanism.slip(state, j, moves).sign() * sense;
    joints.map(|(j, joint)| if joint.kind.mu_k().is_some() { slip(j) } else { 0.0 }).collect()
}

/// The senses of friction per normal force: those of sliding, turned about where a guide that holds on both sides presses to its
/// right, at this square of the rate. Errors: which side it presses to is open.
fn rubbing<T: Real>(
    mechanism: &Mechanism<T>,
    slides: &[f64],
    square: T,
    respond: &Responds<T>,
) -> Result<SmallVec<[f64; 4]>, Refusal> {
    outcome::sides(mechanism.scene, slides, |rubs, joint| {
        let force = mechanism.reaction(&respond(rubs)?, joint, square);
        Ok(force.map(|force| force[0]))
    })
}

impl<'m, 'a, T: Real> Motion<'m, 'a, T> {
    /// From this place in this sense, where nothing rubs and no spring is met, and which is not known in closed form.
    fn new(mechanism: &'m Mechanism<'a, T>, start: T, sense: f64, from: Gain<T>) -> Self {
        let scene = mechanism.scene;
        Self {
            mechanism,
            start,
            sense,
            from,
            near: T::zero(),
            slides: no_friction(scene),
            rubs: no_friction(scene),
            meets: SmallVec::new(),
            pendulum: None,
            fine: Fine::of::<T>(scene, false),
            timed: false,
            steady: false,
        }
    }
    fn angle(&self, way: T) -> T {
        self.start + way.signed(self.sense)
    }
    fn weights(&self) -> f64 {
        let n = self.mechanism.n;
        n.bodies.iter().fold(0.0, |sum, b| sum + (b.mass * n.gravity).size())
    }
    fn rests(&self) -> bool {
        self.from.half_square.is_zero()
    }
    fn is_rubbed(&self) -> bool {
        self.slides.iter().any(|s| *s != 0.0)
    }
    /// The way at this value of the variable, and its derivative.
    fn way(&self, x: T) -> (T, T) {
        if !self.rests() {
            return (x, T::of(1.0));
        }
        if self.near.is_zero() {
            return (x.square(), x.scale2(1));
        }
        let grown = trig::exp_of(x / self.near);
        let shrunk = T::of(1.0) / grown;
        let sine = (grown - shrunk).scale2(-1) * self.near;
        (sine.square(), sine * (grown + shrunk))
    }
    /// The variable at this way.
    fn variable(&self, way: T) -> T {
        if !self.rests() {
            return way;
        }
        if self.near.is_zero() {
            return way.root();
        }
        let near = self.near.f64();
        let rough = |way: f64| {
            let sine = way.sqrt() / near;
            (trig::ln(sine + (1.0 + sine * sine).sqrt()), 0.0)
        };
        let mut x = way.each(rough).0 * self.near;
        for _ in 0..2 {
            let (here, slope) = self.way(x);
            x = if slope.is_zero() { x } else { x + (way - here) / slope };
        }
        x
    }
    /// The same motion from rest, with the variable that suits it.
    fn set_off(mut self, begin: &State<T>) -> Result<Self, Refusal> {
        if self.rests() && !self.is_rubbed() {
            let beside = self.mechanism.state(self.angle(T::of(BESIDE)), true)?;
            let (first, then) = (self.mechanism.drive(begin), self.mechanism.drive(&beside));
            let doubled = T::leading(|| first.f64() * 2.0 * BESIDE / (then - first).f64());
            if doubled > 0.0 && doubled < NEAR {
                self.near = T::of(doubled.sqrt());
            }
        }
        Ok(self)
    }
    fn at(&self, way: T) -> Result<(State<T>, Response<T>), Refusal> {
        let state = self.mechanism.state(self.angle(way), true)?;
        let response = self.mechanism.respond(&state, &self.rubs)?;
        Ok((state, response))
    }
    /// The first joint that rubs at which nothing slides as at the start.
    fn turned_back(&self, state: &State<T>) -> Option<usize> {
        let now = sliding(self.mechanism, state, (&state.rates, self.sense));
        now.iter().zip(&self.slides).position(|(now, before)| now - before != 0.0)
    }
    /// Does this normal force press to the side to which it pressed at the start?
    fn presses_on(&self, joint: usize, force: T) -> bool {
        let pushes = self.mechanism.scene.joints[joint].kind.is_one_sided();
        let side = if pushes { 1.0 } else { self.rubs[joint] * self.slides[joint] };
        force.signed(side).sign() > 0.0
    }

    fn panel(&self, ends: (T, T), from: Gain<T>) -> Result<Panel<T>, Refusal> {
        let (width, Fine { rule, rate: share, time, watched }) = (ends.1 - ends.0, self.fine);
        let (mechanism, joints) = (self.mechanism, &self.mechanism.scene.joints);
        let [mut drives, mut growths, mut slopes, mut inertias] =
            [(); 4].map(|()| PerNode::with_capacity(rule.nodes.len()));
        let mut turned_back = PerNode::new();
        let mut pushes: Watched<(T, T)> = SmallVec::new();
        let mut state = mechanism.state(self.angle(self.way(ends.1).0), true)?;
        let mut last = mechanism.inertia(&state);
        for node in rule.nodes.iter() {
            let (way, slope) = self.way(ends.0 + width * T::constant(*node));
            let slope = slope * width;
            mechanism.next(self.angle(way), &mut state)?;
            let inertia = mechanism.inertia(&state);
            let mut drive = mechanism.drive(&state);
            if watched {
                let response = mechanism.respond(&state, &self.rubs)?;
                turned_back.push(self.turned_back(&state));
                for joint in 0..joints.len() {
                    if let Some(parts) = mechanism.push(&response, joint) {
                        match pushes.iter_mut().find(|p| p.0 == joint) {
                            Some((_, list)) => list.push(parts),
                            None => pushes.push((joint, vec![parts])),
                        }
                    }
                }
                if self.is_rubbed() {
                    let (a, b) = response.lead;
                    let b = plant!("eom: centripetal share over the angle", b.signed(self.sense));
                    growths.push(b.scale2(1) * slope);
                    drive = a;
                }
            }
            drives.push(plant!("eom: acceleration over the angle", drive.signed(self.sense)) * slope);
            inertias.push(inertia);
            slopes.push(slope);
        }
        let mass = |inertia: &T| if self.is_rubbed() { 1.0 } else { inertia.f64() };
        let masses: PerNode<f64> = inertias.iter().map(|inertia| T::leading(|| mass(inertia))).collect();
        // The integrating factor where something rubs. Growths are exponents: beside 1 they count.
        let mut rough = 0.0;
        if self.is_rubbed() {
            rough = rule.rough(&growths, share, 1.0);
            inertias = rule.running(&growths).into_iter().map(|x| trig::exp_of(-x)).collect();
            last = trig::exp_of(-rule.mean(&growths));
            drives.iter_mut().zip(&inertias).for_each(|(a, e)| *a = *a * *e);
        }
        let start = from.half_square * from.factor;
        let squares = rule.running(&drives).into_iter().zip(&inertias).map(|(g, e)| (start + g) / *e);
        let squares: PerNode<T> = squares.collect();
        let energies = squares.iter().zip(&masses).map(|(y, mass)| T::leading(|| y.f64()) * mass).collect();
        let times: PerNode<T> =
            squares.iter().zip(&slopes).map(|(y, slope)| *slope / y.scale2(1).root()).collect();
        let force = |(constant, share): &(T, T), square: &T| *constant + *share * square.scale2(1);
        let forces = |parts: &[(T, T)]| parts.iter().zip(&squares).map(|(p, y)| force(p, y)).collect();
        let pushes: Watched<T> = pushes.iter().map(|(joint, parts)| (*joint, forces(parts))).collect();
        for (values, beside) in [(&drives, start.size()), (&squares, 0.0)]
            .into_iter()
            .chain(pushes.iter().map(|p| (&p.1, self.weights())))
        {
            rough = f64::max(rough, rule.rough(values, share, beside));
        }
        let gained = rule.mean(&drives);
        let half_square = (start + gained).cleared(start.size() + gained.size()) / last;
        let factor = if self.is_rubbed() { T::of(1.0) } else { last };
        let uneven = rule.rough(&times, time, 0.0);
        let last = Gain { half_square, factor };
        Ok(Panel { ends, pushes, turned_back, last, rough, uneven, times, squares, energies })
    }

    /// Shows smooth panels one after the other until `visit` has seen enough; gives what the rate comes to at the end.
    fn over(
        &self,
        (mut at, end): (T, T),
        mut from: Gain<T>,
        timely: bool,
        visit: &mut Visit<T>,
    ) -> Result<Option<Gain<T>>, Refusal> {
        let mut width = end - at;
        let (least, mut panels) = (width.size() * SHORTEST, PANELS);
        while at.below(end) {
            let far = if self.steady { end } else { self.variable(self.way(at).0 + T::of(STRIDE)) };
            let ahead = self.meets.iter().map(|(_, angle)| (*angle - self.start).signed(self.sense));
            let meets =
                ahead.filter(|way| way.sign() > 0.0).map(|way| self.variable(way)).filter(|x| at.below(*x));
            let next = meets.chain([at + width, far]).fold(end, |a, b| if b.below(a) { b } else { a });
            let panel = self.panel((at, next), from)?;
            // Beyond where it comes to rest no time is smooth.
            let moves = panel.squares.iter().all(|y| y.sign() > 0.0);
            let rough = if timely && moves { f64::max(panel.rough, panel.uneven) } else { panel.rough };
            // The coefficients fall geometrically, the faster the farther away a singularity is in lengths of the panel.
            let fit = 0.9 * trig::power(rough, -1.0 / (DEGREE * self.fine.rule.nodes.len() as f64));
            width = next - at;
            let cost = if rough <= 1.0 { 1 } else { ROUGH };
            let left = panels.checked_sub(cost);
            panels = left.unwrap_or(0);
            if rough <= 1.0 && left.is_some() {
                if visit(&panel, from)? {
                    return Ok(None);
                }
                (at, from) = (next, panel.last);
                width = width * T::of(fit.clamp(0.5, 2.0));
            } else {
                if left.is_none() || width.size() <= least {
                    if let Some(folds) = self.mechanism.layout.in_line(self.angle(self.way(next).0)) {
                        return Err(Refusal::Beyond(folds));
                    }
                    let value = panel.last.half_square.f64();
                    return Err(Unsettled { value, gap: f64::INFINITY }.into());
                }
                width = width * T::of(fit.clamp(0.1, 0.7));
            }
        }
        Ok(Some(from))
    }

    /// Normal force of a joint that can only push, or tension of a cord; `None` where the joints leave it open.
    fn pushed(&self, response: &Response<T>, joint: usize, half_square: T) -> Option<T> {
        let parts = self.mechanism.push(response, joint);
        parts.map(|(constant, share)| constant + share * half_square.scale2(1))
    }

    /// Where it first stops within `far`: at rest, at this half square of the rate, or where a joint stops pushing.
    fn stop(
        &self,
        far: T,
        level: Option<T>,
        timely: bool,
        least: &mut [(usize, f64, f64)],
    ) -> Result<Stop<T>, Refusal> {
        if let Some(pendulum) = &self.pendulum {
            return pin::pendulum_stop(pendulum, far, level);
        }
        let mut found: Option<Stop<T>> = None;
        // Of a body on a pin it is told how far it would get.
        let until = match self.mechanism.scene.end {
            End::Time(_, t) if timely && self.mechanism.scene.pinned().is_none() => {
                Some(self.mechanism.n.get(t))
            }
            _ => None,
        };
        let (mut time, mut passes) = (Some(T::zero()), Passes::NONE);
        let start = if self.is_rubbed() { T::of(1.0) } else { self.from.factor };
        passes.see(T::leading(|| (self.from.half_square * start).f64()));
        let mut visit = |panel: &Panel<T>, from: Gain<T>| {
            found = self.stopped(panel, from.half_square, level, least)?;
            // So early within a panel only a shorter one resolves it.
            let mut end = panel.ends.1;
            while let Some(stop) = &found
                && stop.why == Why::Rest
                && let x = self.variable(stop.way)
                && (x - panel.ends.0).scale2(EARLY).below(end - panel.ends.0)
            {
                end = panel.ends.0 + (x - panel.ends.0).scale2(2);
                let shorter = self.panel((panel.ends.0, end), from)?;
                match self.stopped(&shorter, from.half_square, level, least)? {
                    None => break,
                    finer => found = finer,
                }
            }
            let last = found.map_or(panel.ends.1, |stop| self.variable(stop.way));
            let at = |node: &Dd| panel.ends.0 + (panel.ends.1 - panel.ends.0) * T::constant(*node);
            let before = self.fine.rule.nodes.iter().take_while(|node| at(node).below(last));
            before.zip(&panel.energies).for_each(|(_, energy)| passes.see(*energy));
            let part = match &found {
                Some(stop) => stop.time,
                None => (panel.uneven <= 1.0).then(|| self.fine.rule.mean(&panel.times)),
            };
            time = time.zip(part).map(|(sum, part)| sum + plant!("eom: time of joined bodies", part));
            // What lies beyond the time that is asked may be rough.
            if let (None, Some(now), Some(until)) = (&found, time, until)
                && until.below(now)
            {
                let (way, half_square) = (self.way(panel.ends.1).0, panel.last.half_square);
                found = Some(Stop { way, half_square, why: Why::Far, time, slowest: 1.0 });
            }
            Ok(found.is_some())
        };
        let end = self.over((T::zero(), self.variable(far)), self.from, timely, &mut visit)?;
        let half_square = end.unwrap_or(self.from).half_square;
        let stop = found.unwrap_or(Stop { way: far, half_square, why: Why::Far, time: None, slowest: 1.0 });
        if let (Why::Turns(joint), false) = (stop.why, timely) {
            return Err(Refusal::Friction(joint, Lacks::Lasting));
        }
        Ok(Stop { time, slowest: passes.share, ..stop })
    }

    /// The first event within a panel.
    fn stopped(
        &self,
        panel: &Panel<T>,
        from: T,
        level: Option<T>,
        least: &mut [(usize, f64, f64)],
    ) -> Result<Option<Stop<T>>, Refusal> {
        let ((a, b), rule) = (panel.ends, self.fine.rule);
        let nodes = rule.nodes.iter().map(|s| a + (b - a) * T::constant(*s));
        let level = level.map(|l| (l, from.below(l)));
        let mut watched: SmallVec<[Looked<T>; 3]> = SmallVec::new();
        watched.push((Why::Rest, SmallVec::new()));
        watched.extend(level.map(|_| (Why::Speed, SmallVec::new())));
        watched.extend(panel.pushes.iter().map(|(joint, _)| (Why::Leaves(*joint), SmallVec::new())));
        let mut note = |joint: usize, force: T| {
            if let Some(least) = least.iter_mut().find(|l| l.0 == joint) {
                let now = T::leading(|| force.f64());
                (least.1, least.2) = (f64::min(least.1, now), f64::max(least.2, force.size()));
            }
        };
        let mut before = a;
        let squares = panel.squares.iter().copied();
        for (i, (x, square)) in nodes.zip(squares).chain([(b, panel.last.half_square)]).enumerate() {
            let force = |forces: &PerNode<T>| match forces.get(i) {
                Some(force) => *force,
                None => rule.at(forces, T::of(1.0)),
            };
            let now = panel.pushes.iter().map(|(joint, forces)| (*joint, force(forces)));
            let now: SmallVec<[(usize, T); 2]> = now.collect();
            // Of what has happened since the last node, or between the last ones, the first stops it.
            let mut first: Option<(T, Why)> = None;
            for (why, seen) in &mut watched {
                let (value, gone) = match (*why, level) {
                    (Why::Leaves(joint), _) => {
                        let force = now.iter().find(|(j, _)| *j == joint).map_or(T::zero(), |(_, f)| *f);
                        (force, !self.presses_on(joint, force))
                    }
                    (Why::Speed, Some((level, rising))) => (square - level, square.reaches(level) == rising),
                    _ => (square, square.sign() < 0.0),
                };
                seen.push((x, value));
                let dip = |x| Ok::<_, Refusal>(panel.value(rule, *why, level, x));
                let within = if gone {
                    Some((before, x))
                } else {
                    root::dipped(seen, &dip)?.map(|[left, at, _]| (left, at))
                };
                if seen.len() == 3 {
                    seen.remove(0);
                }
                if let Some(within) = within {
                    let at = self.happens(panel, *why, within, level)?;
                    if first.is_none_or(|(first, _)| at.below(first)) {
                        first = Some((at, *why));
                    }
                }
            }
            let turned = match first {
                Some((_, Why::Leaves(j))) => {
                    Some(j).filter(|j| !self.mechanism.scene.joints[*j].kind.is_one_sided())
                }
                Some(_) => None,
                None => panel.turned_back.get(i).copied().flatten(),
            };
            if let Some(joint) = turned {
                // How long it goes on is looked at as far as it can be: where the end comes before, what is beyond it is not asked.
                let moves = panel.squares.iter().all(|y| y.sign() > 0.0);
                let (x, half_square) = if moves { (b, panel.last.half_square) } else { (before, square) };
                let time = (moves && panel.uneven <= 1.0).then(|| rule.mean(&panel.times));
                let way = self.way(x).0;
                return Ok(Some(Stop { way, half_square, why: Why::Turns(joint), time, slowest: 1.0 }));
            }
            if let Some((x, why)) = first {
                let share = (x - a) / (b - a);
                let timed = self.timed && why != Why::Rest;
                let fine = timed && rule.rough(&panel.times, self.fine.rate, 0.0) <= 1.0;
                let half_square = if why == Why::Rest { T::zero() } else { rule.at(&panel.squares, share) };
                let time = fine.then(|| rule.until(&panel.times, share));
                panel.pushes.iter().for_each(|(joint, forces)| note(*joint, rule.at(forces, share)));
                return Ok(Some(Stop { way: self.way(x).0, half_square, why, time, slowest: 1.0 }));
            }
            now.into_iter().for_each(|(joint, force)| note(joint, force));
            before = x;
        }
        Ok(None)
    }

    /// The value of the variable, between two within a panel, at which something happens; of a speed its level and whether it rises
    /// to it.
    fn happens(
        &self,
        panel: &Panel<T>,
        why: Why,
        (before, after): (T, T),
        level: Option<(T, bool)>,
    ) -> Result<T, Refusal> {
        let rule = self.fine.rule;
        let value = |x: T| panel.value(rule, why, level, x);
        let rising = match (why, level) {
            (Why::Speed, Some((_, rising))) => rising,
            (Why::Leaves(_), _) => value(after).sign() > 0.0,
            _ => false,
        };
        let x = root::between_values(before, after, rising, &|x| Ok::<_, Refusal>(value(x)))?;
        let Why::Leaves(joint) = why else { return Ok(x) };
        // What the interpolation leaves of the force is taken off by one step.
        let step = (x - before).scale2(-20);
        let slope = (value(x) - value(x - step)) / step;
        let (_, response) = self.at(self.way(x).0)?;
        let square = panel.value(rule, Why::Rest, None, x);
        Ok(self.pushed(&response, joint, square).map_or(x, |force| x - force / slope))
    }

    /// The state at the end by the steps of a rung in time, in doubles: what the angle is, or the half square of the rate that ends
    /// the motion, is given.
    fn stepped(
        &self,
        (far, level): (T, Option<T>),
        known: &dyn Fn() -> f64,
        rung: Rung,
    ) -> Result<(Stop<T>, Count), Refusal> {
        let scene = self.mechanism.scene;
        let u0 = self.from.half_square.scale2(1).root().f64();
        let (event, why) = match (scene.end, level) {
            (End::Time(_, t), _) => (Event::Time(self.mechanism.n.get(t).f64()), Why::Far),
            (End::Leaves(joint), _) => (Event::Release, Why::Leaves(joint)),
            (End::TurningPoint(_), _) => (Event::Fall(0.0), Why::Rest),
            (_, Some(level)) => {
                let u = level.scale2(1).root().f64();
                (if u0 < u { Event::Rise(u) } else { Event::Fall(u) }, Why::Speed)
            }
            _ => (Event::Place(far.f64()), Why::Far),
        };
        let expected = if let Event::Place(way) = event { way } else { STRIDE };
        let (states, count) = self.run(&[(event, expected)], expected, known, rung)?;
        let [x, u, time] = states.first().map_or([f64::NAN; 3], |end| [end.s, end.u, end.time]).map(T::of);
        let half_square = if why == Why::Rest { T::zero() } else { u.square().scale2(-1) };
        Ok((Stop { way: x, half_square, why, time: Some(time), slowest: 1.0 }, count))
    }

    /// The time until it stops, without steps.
    fn until(&self, far: T, level: Option<T>) -> Result<f64, Refusal> {
        let stop = self.stop(far, level, true, &mut [])?;
        let rest = stop.why == Why::Rest || stop.half_square.is_zero();
        Ok(self.time(stop.way, rest)?.f64())
    }

    /// The states at these events by the steps of a rung in time, in doubles; how far the last one is, and a time that is not passed
    /// without them.
    fn run(
        &self,
        events: &[(Event, f64)],
        expected: f64,
        known: &dyn Fn() -> f64,
        rung: Rung,
    ) -> Result<(Vec<travel::State<f64>>, Count), Refusal> {
        let scene = self.mechanism.scene;
        let n = self.mechanism.n.in_doubles(scene);
        let mechanism = Mechanism::new(scene, &n)?;
        let state = RefCell::new(mechanism.state(self.start.f64(), true)?);
        let respond = |way: f64| {
            let mut state = state.borrow_mut();
            mechanism.next(self.start.f64() + self.sense * way, &mut state).ok()?;
            mechanism.respond(&state, &self.rubs).ok()
        };
        let law = |_: usize, way: f64, u: f64| {
            let leading = respond(way).map(|response| response.lead);
            leading.map_or(f64::NAN, |(a, b)| self.sense * (a + b * u * u))
        };
        let presses = |way: f64, u: f64| match scene.end {
            End::Leaves(joint) => {
                let parts = respond(way).and_then(|response| mechanism.push(&response, joint));
                parts.map_or(f64::NAN, |(constant, share)| constant + share * u * u)
            }
            _ => f64::NAN,
        };
        let u0 = self.from.half_square.scale2(1).root().f64();
        let force = law(0, 0.0, u0).abs().max(law(0, 0.5 * expected, u0).abs());
        let pace = if let [(Event::Time(t), _)] = events { *t } else { pace(expected, force, u0) };
        let route = Route { law, presses: &presses, switches: &[], u0, pace, time: known };
        route.states(events, rung).map_err(|trouble| Refusal::Trouble { method: rung.method(), trouble })
    }

    /// Time over a way that ends at rest or not.
    fn time(&self, way: T, rest: bool) -> Result<T, Refusal> {
        if way.is_zero() {
            return Ok(T::zero());
        }
        if let Some(pendulum) = &self.pendulum {
            return Ok(pendulum.time(way, rest));
        }
        if rest {
            // The last half is the way back from the turning point.
            let half = way.scale2(-1);
            return Ok(self.time(half, false)? + self.back_from(way)?.time(half, false)?);
        }
        let mut time = T::zero();
        let mut visit = |panel: &Panel<T>, _: Gain<T>| {
            time = time + self.fine.rule.mean(&panel.times);
            Ok(false)
        };
        self.over((T::zero(), self.variable(way)), self.from, true, &mut visit)?;
        Ok(plant!("eom: time of joined bodies", time))
    }

    /// The way back from rest after a way.
    fn back_from(&self, way: T) -> Result<Self, Refusal> {
        let from = Gain { half_square: T::zero(), factor: T::of(1.0) };
        let (start, near) = (self.angle(way), T::zero());
        let back = Motion { start, sense: -self.sense, from, near, ..self.clone() };
        back.set_off(&self.mechanism.state(start, true)?)
    }

    /// The way that takes this time, of one that takes longer: in the panel where the time runs out, by the rate at its end.
    fn after(&self, t: T, far: T) -> Result<T, Refusal> {
        if let Some(pendulum) = &self.pendulum {
            return root::between_values(T::zero(), far, true, &|way| Ok(pendulum.time(way, false) - t));
        }
        let rule = self.fine.rule;
        let (mut left, mut found) = (t, far);
        let mut visit = |panel: &Panel<T>, from: Gain<T>| {
            let lasts = |panel: &Panel<T>| plant!("eom: time of joined bodies", rule.mean(&panel.times));
            let all = lasts(panel);
            if all.below(left) {
                left = left - all;
                return Ok(false);
            }
            let (a, b) = panel.ends;
            let x = root::between(a, b, true, |x| {
                let part = self.panel((a, x), from)?;
                let slowness = self.way(x).1 / part.last.half_square.scale2(1).root();
                Ok::<_, Refusal>((lasts(&part) - left, slowness))
            })?;
            found = self.way(x).0;
            Ok(true)
        };
        self.over((T::zero(), self.variable(far)), self.from, true, &mut visit)?;
        Ok(found)
    }

    /// How far it is looked for an end: what spins in one place twice as far as it takes to come to rest.
    fn horizon(&self) -> Result<T, Refusal> {
        let usual = self.mechanism.layout.horizon();
        if !self.steady {
            return Ok(usual);
        }
        let (a, _) = self.at(T::zero())?.1.lead;
        let slows = a.signed(-self.sense);
        Ok(if slows.sign() > 0.0 { (self.from.half_square / slows).scale2(1) } else { usual })
    }

    /// What is asked of the end and where the motion starts in its measure, how far at most it is looked for, and half the square of
    /// the rate that ends the motion.
    fn wanted(&self) -> Result<Wanted<T>, Refusal> {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        if let Some(apart) = self.mechanism.layout.to_end_deg() {
            let apart = apart.signed(self.sense);
            return Ok(((Some(apart), T::zero()), apart / trig::degrees_per_radian(), None));
        }
        let far = self.horizon()?;
        Ok(match scene.end {
            End::Speed(_, w) => {
                let w = n.get(w) / self.mechanism.layout.ratio();
                let begins = self.from.half_square.scale2(1).root();
                ((Some(w.abs()), begins), far, Some(w.square().scale2(-1)))
            }
            End::Time(_, t) => ((Some(n.get(t)), T::zero()), far, None),
            _ => ((None, T::zero()), far, None),
        })
    }

    /// The first joint that can only push and does not at the start.
    fn untouched(&self, begin: &Response<T>) -> Option<usize> {
        let (joints, least) = (&self.mechanism.scene.joints, T::of(PUSHES * self.weights()));
        (0..joints.len()).filter(|j| joints[*j].kind.is_one_sided()).find(|joint| {
            let force = self.pushed(begin, *joint, self.from.half_square);
            force.is_some_and(|force| !least.below(force))
        })
    }

    /// Where it stops within `far`, by the steps of a rung if one is given.
    fn followed(
        &self,
        teller: &mut Teller<'_, '_, T>,
        (far, level): (T, Option<T>),
        by: Option<Steps>,
        least: &mut [(usize, f64, f64)],
    ) -> Result<Stop<T>, Refusal> {
        let (half_square, why) = (self.from.half_square, Why::Far);
        let here = Stop { way: T::zero(), half_square, why, time: None, slowest: 1.0 };
        if let Some((rung, _)) = by {
            let known = || match teller.pinned {
                Some(_) => self.until(far, level).unwrap_or(f64::INFINITY),
                None => f64::INFINITY,
            };
            let (stop, count) = self.stepped((far, level), &known, rung)?;
            teller.count = count;
            return Ok(stop);
        }
        if far.sign() < 0.0 {
            return Ok(here);
        }
        match (level, teller.pinned) {
            (Some(level), Some(_)) if level.side(self.from.half_square) == 0.0 => {
                Ok(Stop { half_square: level, why: Why::Speed, ..here })
            }
            // Whether the time is asked changes no other answer, not even by its rounding.
            _ => self.stop(far, level, matches!(self.mechanism.scene.end, End::Time(..)), least),
        }
    }

    /// Follows the motion to the end that is asked and tells what is there.
    fn to_its_end(&self, teller: &mut Teller<'_, '_, T>) -> Result<(), Refusal> {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        let ((asked, begins), mut far, level) = self.wanted()?;
        let limit = self.mechanism.layout.overruns(self.sense, (far + look(), look()));
        let limit = limit.filter(|(limit, _)| limit.at_most(far));
        far = limit.map_or(far, |(limit, _)| limit * T::of(SHORT));
        let (first, begin) = self.at(T::zero())?;
        let course = |farthest: T, slowest: f64, reached: bool| {
            Some(Course { asked, begins, farthest, slowest, ..Course::moving(self.sense, reached) })
        };
        if let Some(joint) = self.untouched(&begin) {
            teller.road.course = course(T::zero(), 1.0, false);
            teller.road.held.push(Held::Touching(joint, 0.0, 1.0));
            return Ok(());
        }
        let square = self.mechanism.start_rate()?.square();
        teller.watch_shares(&first, (&begin, square), &self.rubs, false);
        let nothing: Vec<(usize, f64, f64)> =
            (0..scene.joints.len()).map(|j| (j, f64::INFINITY, 0.0)).collect();
        let mut least = nothing.clone();
        let backward = far.sign() < 0.0;
        let by = teller.by.filter(|_| STEPS && !backward);
        let mut stop = self.followed(teller, (far, level), by, &mut least)?;
        let mut most = None;
        let overrun = || limit.map_or(Ok(()), |(_, obstacle)| Err(Refusal::Beyond(obstacle)));
        if stop.why == Why::Far && !matches!(scene.end, End::Time(..)) {
            overrun()?;
        }
        if let (End::Time(_, t), None) = (scene.end, by) {
            let t = n.get(t);
            let until = match stop.time {
                Some(time) => time,
                None => self.time(stop.way, stop.why == Why::Rest)?,
            };
            most = Some(until);
            if let (Why::Turns(joint), false) = (stop.why, t.below(until)) {
                return Err(Refusal::Friction(joint, Lacks::Lasting));
            }
            if t.side(until) == 0.0 {
                (stop.why, stop.time) = (Why::Far, most);
            } else if t.below(until) {
                // Beside the turning point the time is counted from there.
                let way = match (stop.why, &self.pendulum) {
                    (Why::Rest, None) if until.below(t.scale2(1)) => {
                        stop.way - self.back_from(stop.way)?.after(until - t, stop.way)?
                    }
                    _ => self.after(t, stop.way)?,
                };
                // What pushes is watched up to there alone.
                least = nothing;
                stop = Stop { why: Why::Far, time: Some(t), ..self.stop(way, None, false, &mut least)? };
            } else {
                if stop.why == Why::Far {
                    overrun()?;
                    teller.goes_on = true;
                }
                (stop.why, stop.time) = (Why::Rest, None);
            }
        }
        let reached = !backward
            && match scene.end {
                End::Angle(..) => stop.why == Why::Far,
                End::Speed(..) => stop.why == Why::Speed,
                End::TurningPoint(_) => stop.why == Why::Rest,
                End::Leaves(joint) => stop.why == Why::Leaves(joint),
                End::Time(..) => stop.why == Why::Far && stop.time.is_some(),
                _ => false,
            };
        teller.goes_on |=
            !reached && !backward && stop.why == Why::Far && !matches!(scene.end, End::Time(..));
        let farthest = self.farthest(teller, &stop, reached, most);
        teller.road.course = course(farthest, stop.slowest, reached);
        self.tell_touching(teller, &stop, least);
        if reached {
            self.tell_end(teller, &stop, &first, by)
        } else {
            teller.tell_standing(&first, &begin, self.from.half_square.scale2(1))
        }
    }

    /// How far it could go, in what its end is told by.
    fn farthest(&self, teller: &Teller<T>, stop: &Stop<T>, reached: bool, most: Option<T>) -> T {
        let endless = T::of(f64::INFINITY);
        let margins = teller.pinned.is_some() && teller.asked.held;
        match self.mechanism.scene.end {
            End::Angle(..) if reached && margins => {
                self.limit(stop).map_or(endless, |way| way * trig::degrees_per_radian())
            }
            End::Speed(..) if margins => self.fastest(stop),
            End::Time(..) if teller.pinned.is_some() => most.unwrap_or(endless),
            End::Angle(..) if reached => endless,
            End::Angle(..) => stop.way * trig::degrees_per_radian(),
            End::TurningPoint(_) if stop.why == Why::Rest => stop.way * trig::degrees_per_radian(),
            _ => endless,
        }
    }

    /// How much the joints that can only push did so at least.
    fn tell_touching(&self, teller: &mut Teller<T>, stop: &Stop<T>, least: Vec<(usize, f64, f64)>) {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        let leaving = |joint| scene.end == End::Leaves(joint);
        for (joint, least, most) in least {
            if scene.joints[joint].kind.is_one_sided() && least.is_finite() && !leaving(joint) {
                let [least, most] = [least, most].map(|x| n.publish(Quantity::Normal, T::of(x)).f64());
                teller.road.held.push(Held::Touching(joint, least, most));
            }
        }
        if let Why::Leaves(joint) = stop.why
            && !leaving(joint)
        {
            teller.road.held.retain(|h| !matches!(h, Held::Touching(j, ..) if *j == joint));
            teller.road.held.push(Held::Touching(joint, 0.0, 1.0));
        }
    }

    /// Everything where it stops, at the end that is asked; `first` is the start.
    fn tell_end(
        &self,
        teller: &mut Teller<'_, '_, T>,
        stop: &Stop<T>,
        first: &State<T>,
        by: Option<Steps>,
    ) -> Result<(), Refusal> {
        let scene = self.mechanism.scene;
        if let Some(strikes) = self.mechanism.pierces(self.sense, (stop.way, look())) {
            return Err(Refusal::Beyond(strikes));
        }
        teller.tell_met(&self.meets, stop.way)?;
        let rest = stop.why == Why::Rest || stop.half_square.is_zero();
        if teller.asked.quantities.has(Quantity::T) {
            let time = match stop.time {
                Some(time) => time,
                None => self.time(stop.way, rest)?,
            };
            teller.say(Quantity::T, Owner::Scene, time);
        }
        teller.say(Quantity::Phi, Owner::Body(self.mechanism.lead), self.mechanism.layout.turned(stop.way));
        if let Some(lead) = scene.ends_at_an_angle() {
            let start = scene.planar(lead).and_then(|planar| planar.start_deg);
            let start =
                start.map_or_else(T::zero, |start| self.mechanism.n.get(start) * trig::radians_per_degree());
            let reached = start.balance(plant!("eom: angle at the end", stop.way.signed(self.sense)));
            teller.say_scaled(Quantity::Angle, Owner::Body(lead), reached, start.size() + stop.way.size());
        }
        let (mut state, mut response) = self.at(stop.way)?;
        if teller.pinned.is_some() {
            let place = self.place(stop.way, rest, by.is_none());
            teller.tell_turned(stop.way, self.sense, &place);
            self.mechanism.turn_to(&mut state, &place)?;
            response = self.mechanism.respond(&state, &self.rubs)?;
        }
        let presses_on = |j: usize| {
            let force = self.mechanism.reaction(&response, j, stop.half_square.scale2(1));
            force.is_none_or(|force| self.presses_on(j, force[0]))
        };
        let mut rubs =
            (0..scene.joints.len()).filter(|j| self.slides[*j] != 0.0 && scene.end != End::Leaves(*j));
        if let Some(joint) = self.turned_back(&state).or_else(|| rubs.find(|j| !presses_on(*j))) {
            return Err(Refusal::Friction(joint, Lacks::Lasting));
        }
        if let (Some(pinned), Some((_, rung_asks))) = (&self.pendulum, by) {
            self.step_through(teller, pinned, rung_asks)?;
        }
        for (b, body) in scene.bodies.iter().enumerate() {
            if body.planar.is_some() && teller.pinned.is_none() {
                teller.tell_risen(b, self.mechanism.height(first, b), self.mechanism.height(&state, b));
            }
        }
        let speed = stop.half_square.scale2(1).root().signed(self.sense);
        let lead = response.lead;
        teller.tell(&state, &response, (speed, lead), &self.rubs)
    }
}

/// What is said, with the units put back.
struct Teller<'t, 'a, T: Real> {
    scene: &'a Scene,
    n: &'t Numbers<'a, T>,
    mechanism: &'t Mechanism<'a, T>,
    asked: Scope,
    by: Option<Steps<'t>>,
    /// A body on a pin, of which all is told as its own.
    pinned: Option<usize>,
    count: Count,
    road: Road<T>,
    /// Does it go on where it was looked for the end no farther?
    goes_on: bool,
}
