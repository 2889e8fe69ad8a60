//! The motion of joined bodies in the plane: the rate of the leading angle and the time, integrated over that angle.
//!
//! The equations of motion give `q'' = A(q) + B(q) q'^2`, a linear equation for `y = q'^2 / 2` over the angle,
//! `dy/dq = A + 2 B y`, solved with its integrating factor `exp(-2 int B dq)` panel by panel. Where nothing rubs that is the inertia
//! over the angle, up to a constant, and `A` alone is needed. From rest the angle goes as the square of the variable, which takes
//! the root singularity out of the time, or beside an equilibrium as the square of its hyperbolic sine, as the time itself would
//! if the drive grew with the angle; the last half of a way that ends at rest is summed as the way back from there.
use crate::num::dd::pow2;
use crate::num::gauss::{self, PerNode, Rule, Unsettled};
use crate::num::half::Half;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Real, root, trig};
use crate::scene::pose;
use crate::scene::{Acts, End, JointKind, Label, Numbers, Owner, Quantity, Ray, Scene, Spot};
use crate::solve::eom::integrate::{Event, Route, pace};
use crate::solve::eom::pendulum::Pendulum;
use crate::solve::eom::planar::{LOOKED_THROUGH, Mechanism, Response, State};
use crate::solve::eom::travel;
use crate::solve::eom::{STEPS, couple_on};
use crate::solve::method::Rung;
use crate::solve::outcome::{self, Course, Held, Refusal, Road, Said, Scope, Unsupported};
use smallvec::SmallVec;
use std::cell::{Cell, RefCell};

/// A motion is followed for two turns at most.
const TURNS: f64 = 2.0;
/// Angle after which a panel ends at the latest, radians.
const STRIDE: f64 = 1.0;

/// Panels of a motion at most, of which one that is rough counts for so many: the way to a singularity takes fewer, what takes more
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

/// How often a bracket about a peak is cut by a third.
const PEAK: u32 = 80;

/// An equilibrium is indifferent whose stiffness is below this share of what forces could give it.
const INDIFFERENT: f64 = 1e-9;

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
    /// Panels that may still be made.
    panels: Cell<u32>,
    /// What has a closed form.
    pendulum: Option<Pendulum<T>>,
    /// How fine its panels are.
    fine: Fine,
    /// Is the time asked for, or where it is at a time?
    timed: bool,
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
    /// Longer panels where something may happen within one, a turning point of a body on a pin, a joint that can only push or rubs being watched there, or a speed.
    fn of<T: Real>(scene: &Scene, pinned: bool) -> Self {
        let watched = scene.joints.iter().any(|j| j.kind.is_one_sided() || j.kind.rubs().is_some());
        let ending = !watched && !pinned && matches!(scene.end, End::Angle(..));
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
    /// What the rate comes to at its end.
    last: Gain<T>,
    /// The time over it, per share of it, at its nodes.
    times: PerNode<T>,
    /// For each joint that can only push or rubs: its normal force at the nodes.
    pushes: Watched<T>,
    /// Do all points that rub slide as at the start, at the nodes?
    slides_on: PerNode<bool>,
    /// How far the last coefficients are above what is smooth.
    rough: f64,
    /// The same of the time.
    uneven: f64,
}

/// Something of each joint that can only push or rubs, at the nodes of a panel.
type Watched<T> = SmallVec<[(usize, PerNode<T>); 2]>;
/// Sees a panel and what the rate has come to at its start; true ends the march.
type Visit<'v, T> = dyn FnMut(&Panel<T>, Gain<T>) -> Result<bool, Refusal> + 'v;

/// What bodies do with these senses of friction.
type Responds<'r, T> = dyn Fn(&[f64]) -> Result<Response<T>, Refusal> + 'r;

/// Where a motion stops.
#[derive(Debug, Clone, Copy)]
struct Stop<T> {
    /// Leading angle turned, radians.
    way: T,
    /// Half the square of the rate.
    half_square: T,
    /// What stops it.
    why: Why,
    /// The time until then, where the panels give it.
    time: Option<T>,
}

/// A rung, and which quantities are wanted of it.
pub type Steps<'s> = (Rung, &'s dyn Fn(Quantity) -> bool);

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
    let plane = scene.in_the_plane();
    let mechanism = Mechanism::new(&plane, n)?;
    let (count, road) = (Count::default(), Road::new(asked));
    let pinned = scene.pinned().map(|(body, _)| body);
    let mut teller = Teller { scene: &plane, n, mechanism: &mechanism, asked, by, pinned, count, road };
    follow(&mut teller)?;
    Ok((teller.road, teller.count))
}

/// Follows the bodies to the instant or the end that is asked, and tells what is there.
fn follow<T: Real>(teller: &mut Teller<T>) -> Result<(), Refusal> {
    let (scene, n, mechanism) = (teller.scene, teller.n, teller.mechanism);
    let mut spin = mechanism.start_rate()?;
    if teller.pinned.is_some() {
        teller.tell_lasting(spin)?;
    }
    let nothing: SmallVec<[f64; 4]> = scene.joints.iter().map(|_| 0.0).collect();
    if matches!(scene.end, End::AtOnce) {
        let state = mechanism.state(T::zero(), !spin.is_zero() || teller.pinned.is_some())?;
        if scene.is_struck() {
            let jumps = mechanism.struck(&state)?;
            teller.tell_blow(&jumps);
            teller.tell_motion(&mechanism.after(state, spin, &jumps), T::of(1.0), None);
            return Ok(());
        }
        if let Some(alpha) = scene.driven() {
            // From rest it sets off as it is driven.
            let alpha = n.get(alpha);
            let way = if spin.is_zero() { alpha / mechanism.ratio() } else { spin };
            let state = mechanism.state(T::zero(), true)?;
            let slides = sliding(mechanism, &|at| mechanism.speed(&state, at).map(|v| v * way));
            outcome::all_slide(scene, &slides)?;
            let driven = |rubs: &[f64]| mechanism.driven(&state, rubs, (alpha, spin.square()));
            let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| Ok(driven(rubs)?.0))?;
            let (response, moment) = driven(&rubs)?;
            let size = moment.size() + teller.pulls() * mechanism.size();
            teller.say_scaled(Quantity::Drive, Owner::Body(mechanism.lead), moment, size);
            teller.watch(&response, spin.square());
            let lead = mechanism.leading(&response);
            teller.tell(&state, &response, (spin, lead), &rubs)?;
            return Ok(());
        }
        let smooth = mechanism.respond(&state, &nothing)?;
        // What starts from rest slides as it would without friction, if friction lets it.
        let from_rest = |response| sliding(mechanism, &|at| mechanism.pull_off(&state, response, at));
        let slides = if spin.is_zero() {
            from_rest(&smooth)
        } else {
            sliding(mechanism, &|at| mechanism.speed(&state, at).map(|v| v * spin))
        };
        if !spin.is_zero() {
            outcome::all_slide(scene, &slides)?;
        }
        let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| mechanism.respond(&state, rubs))?;
        let response = mechanism.respond(&state, &rubs)?;
        if spin.is_zero() && from_rest(&response) != slides {
            teller.road.course = Some(Course::at_rest());
            return Ok(());
        }
        teller.watch(&response, spin.square());
        let lead = mechanism.leading(&response);
        teller.tell(&state, &response, (spin, lead), &rubs)?;
        return Ok(());
    }
    if scene.end == End::Equilibrium {
        teller.tell_equilibrium(&nothing)?;
        return Ok(());
    }
    let state = mechanism.state(T::zero(), true)?;
    if scene.is_struck() {
        let jumps = mechanism.struck(&state)?;
        // What strikes straight at a joint moves nothing.
        let most = teller.blows() * mechanism.size() / mechanism.inertia(&state).size();
        spin = spin.balance(mechanism.leading(&jumps).0.cleared(most));
        teller.tell_blow(&jumps);
    }
    let free = mechanism.respond(&state, &nothing)?;
    let (a, b) = mechanism.leading(&free);
    // In a balance rounding is left of the drive.
    let turning = match teller.pinned {
        Some(_) => teller.terms(&state),
        None => teller.drives() / mechanism.inertia(&state).size(),
    };
    let first = a.balance(b * spin.square()).cleared(turning);
    let sense = if spin.is_zero() { first.sign() } else { spin.sign() };
    let slides = sliding(mechanism, &|at| mechanism.speed(&state, at).map(|v| v.signed(sense)));
    let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| mechanism.respond(&state, rubs))?;
    let rubbed = slides.iter().any(|s| *s != 0.0);
    let factor = if rubbed { T::of(1.0) } else { mechanism.inertia(&state) };
    let motion = Motion {
        mechanism,
        start: T::zero(),
        sense,
        from: Gain { half_square: spin.square().scale2(-1), factor },
        near: T::zero(),
        slides,
        rubs,
        meets: mechanism.meets(sense, (horizon(), look())),
        panels: Cell::new(PANELS),
        pendulum: teller.pendulum(&state, sense, spin),
        fine: Fine::of::<T>(scene, teller.pinned.is_some()),
        timed: teller.asked.quantities.has(Quantity::T) || matches!(scene.end, End::Time(..)),
    };
    // Friction may hold what would set off without it.
    let (a, b) = if rubbed { mechanism.leading(&mechanism.respond(&state, &motion.rubs)?) } else { (a, b) };
    let sets_off = a.balance(b * spin.square()).cleared(turning).signed(sense);
    if sense == 0.0 || spin.is_zero() && sets_off.sign() <= 0.0 {
        teller.road.course = Some(Course::at_rest());
        return teller.tell_standing(&state, &free, T::zero());
    }
    motion.set_off(&state)?.to_its_end(teller)?;
    Ok(())
}

/// The angle up to which a motion is followed.
fn horizon<T: Real>() -> T {
    T::constant(Dd::PI * Dd::new(2.0 * TURNS))
}
/// Step in which places on the way are looked for, radians.
fn look<T: Real>() -> T {
    T::of(STRIDE / 16.0)
}

/// The slope of a function, by differences over ever smaller spans, from this one on, from which the error is extrapolated: what
/// one span more changes least, for below that rounding grows. Near a dead centre the first spans tell nothing.
fn slope<T: Real>(value: &dyn Fn(T) -> Result<T, Refusal>, at: T, widest: T) -> Result<T, Refusal> {
    const SPANS: i32 = 24;
    let (mut row, mut best): (Vec<T>, _) = (Vec::new(), (f64::INFINITY, T::zero()));
    for i in 0..SPANS {
        let span = widest.scale2(-i);
        let mut next = vec![(value(at + span)? - value(at - span)?) / span.scale2(1)];
        for (k, coarse) in row.iter().enumerate() {
            let finer = next[k];
            next.push(finer + (finer - *coarse) / T::of(pow2(2 * k as i32 + 2) - 1.0));
        }
        if let (Some(before), Some(now)) = (row.last(), next.last()) {
            let change = (*now - *before).size();
            if change < best.0 {
                best = (change, *now);
            }
            if gauss::settled(*now, *before, now.size()) {
                break;
            }
        }
        row = next;
    }
    Ok(best.1)
}

/// The senses in which points slide in guides that rub, by their velocities (or accelerations from rest).
fn sliding<T: Real>(mechanism: &Mechanism<T>, moves: &dyn Fn(Spot) -> [T; 2]) -> SmallVec<[f64; 4]> {
    let of = |kind: &JointKind| match *kind {
        JointKind::Guide { at, direction_deg, mu_k: Some(_), .. } => {
            let [c, s] = pose::direction(mechanism.n, direction_deg);
            let [x, y] = moves(at);
            (x * c).balance(y * s).sign()
        }
        _ => 0.0,
    };
    mechanism.scene.joints.iter().map(|j| of(&j.kind)).collect()
}

/// The senses of friction per normal force: those of sliding, turned about where a guide that holds on both sides presses to its
/// right, at this square of the rate. Errors: which side it presses to is open.
fn rubbing<T: Real>(
    mechanism: &Mechanism<T>,
    slides: &SmallVec<[f64; 4]>,
    square: T,
    respond: &Responds<T>,
) -> Result<SmallVec<[f64; 4]>, Refusal> {
    let rubs_on_both =
        |j: &usize| slides[*j] != 0.0 && matches!(mechanism.scene.joints[*j].kind.rubs(), Some((_, true)));
    let both: SmallVec<[usize; 4]> = (0..slides.len()).filter(rubs_on_both).collect();
    let turned = |sides: &[f64]| {
        let mut all = slides.clone();
        both.iter().zip(sides).for_each(|(j, side)| all[*j] *= side);
        all
    };
    let sides = outcome::sides(both.len(), |sides| {
        let response = respond(&turned(sides))?;
        let fits = |(j, side): (&usize, &f64)| {
            let force = mechanism.reaction(&response, *j, square);
            force.is_none_or(|force| force[0].signed(*side).sign() >= 0.0)
        };
        Ok(both.iter().zip(sides).all(fits))
    })?;
    Ok(turned(&sides))
}

/// Where a pendulum stops within `far`.
fn pendulum_stop<T: Real>(pendulum: &Pendulum<T>, far: T, level: Option<T>) -> Result<Stop<T>, Refusal> {
    let limit = pendulum.turning();
    let last = limit.filter(|limit| limit.at_most(far)).unwrap_or(far);
    if let Some(level) = level
        && let Some(way) = pendulum.reaching(level, last)?
    {
        return Ok(Stop { way, half_square: level, why: Why::Speed, time: None });
    }
    // What is asked at the turning point is there at rest.
    let (half_square, why) = match limit {
        Some(limit) if far.side(limit) == 0.0 => (T::zero(), Why::Far),
        Some(limit) if limit.below(far) => (T::zero(), Why::Rest),
        _ => (pendulum.half_square(far), Why::Far),
    };
    Ok(Stop { way: if why == Why::Rest { last } else { far }, half_square, why, time: None })
}

impl<'m, 'a, T: Real> Motion<'m, 'a, T> {
    fn angle(&self, way: T) -> T {
        self.start + way.signed(self.sense)
    }
    /// Sum of all weights.
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
    /// Do all points that rub slide as at the start?
    fn slides_on(&self, state: &State<T>) -> bool {
        let now = |at| self.mechanism.speed(state, at).map(|v| v.signed(self.sense));
        sliding(self.mechanism, &now) == self.slides
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
        let mut slides_on = PerNode::new();
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
                slides_on.push(self.slides_on(&state));
                for joint in 0..joints.len() {
                    if let Some(parts) = mechanism.push(&response, joint) {
                        match pushes.iter_mut().find(|p| p.0 == joint) {
                            Some((_, list)) => list.push(parts),
                            None => pushes.push((joint, vec![parts])),
                        }
                    }
                }
                if self.is_rubbed() {
                    let (a, b) = mechanism.leading(&response);
                    let b = plant!("eom: centripetal share over the angle", b.signed(self.sense));
                    growths.push(b.scale2(1) * slope);
                    drive = a;
                }
            }
            drives.push(plant!("eom: acceleration over the angle", drive.signed(self.sense)) * slope);
            inertias.push(inertia);
            slopes.push(slope);
        }
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
        Ok(Panel { ends, pushes, slides_on, last, rough, uneven, times, squares })
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
        let least = width.size() * SHORTEST;
        while at.below(end) {
            let far = self.variable(self.way(at).0 + T::of(STRIDE));
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
            let left = self.panels.get().checked_sub(cost);
            self.panels.set(left.unwrap_or(0));
            if rough <= 1.0 && left.is_some() {
                if visit(&panel, from)? {
                    return Ok(None);
                }
                (at, from) = (next, panel.last);
                width = width * T::of(fit.clamp(0.5, 2.0));
            } else {
                if left.is_none() || width.size() <= least {
                    if self.mechanism.in_line(self.angle(self.way(next).0)) {
                        return Err(Refusal::Unsupported(Unsupported::InLine));
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
            return pendulum_stop(pendulum, far, level);
        }
        let mut found: Option<Stop<T>> = None;
        let mut time = Some(T::zero());
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
            let part = match &found {
                Some(stop) => stop.time,
                None => (panel.uneven <= 1.0).then(|| self.fine.rule.mean(&panel.times)),
            };
            time = time.zip(part).map(|(sum, part)| sum + plant!("eom: time of joined bodies", part));
            Ok(found.is_some())
        };
        let end = self.over((T::zero(), self.variable(far)), self.from, timely, &mut visit)?;
        let half_square = end.unwrap_or(self.from).half_square;
        let stop = found.unwrap_or(Stop { way: far, half_square, why: Why::Far, time: None });
        Ok(Stop { time, ..stop })
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
        let rising = level.map(|l| from.below(l));
        let mut before = a;
        let squares = panel.squares.iter().copied();
        for (i, (x, square)) in nodes.zip(squares).chain([(b, panel.last.half_square)]).enumerate() {
            let mut events: SmallVec<[Why; 2]> = SmallVec::new();
            if square.sign() < 0.0 {
                events.push(Why::Rest);
            }
            if let (Some(level), Some(rising)) = (level, rising)
                && (square.reaches(level) == rising)
            {
                events.push(Why::Speed);
            }
            let force = |forces: &PerNode<T>| match forces.get(i) {
                Some(force) => *force,
                None => rule.at(forces, T::of(1.0)),
            };
            let now = panel.pushes.iter().map(|(joint, forces)| (*joint, force(forces)));
            let now: SmallVec<[(usize, T); 2]> = now.collect();
            let off = now.iter().filter(|(joint, force)| !self.presses_on(*joint, *force));
            events.extend(off.map(|(joint, _)| Why::Leaves(*joint)));
            // Of what has happened since the last node, the first stops it.
            let mut first: Option<(T, Why)> = None;
            for why in events {
                let at = self.happens(panel, why, (before, x), level.zip(rising))?;
                if first.is_none_or(|(first, _)| at.below(first)) {
                    first = Some((at, why));
                }
            }
            let turned = match first {
                Some((_, Why::Leaves(j))) => !self.mechanism.scene.joints[j].kind.is_one_sided(),
                Some(_) => false,
                None => !panel.slides_on.get(i).copied().unwrap_or(true),
            };
            if turned {
                return Err(Refusal::Unsupported(Unsupported::FrictionTurns));
            }
            if let Some((x, why)) = first {
                let share = (x - a) / (b - a);
                let timed = self.timed && why != Why::Rest;
                let fine = timed && rule.rough(&panel.times, self.fine.rate, 0.0) <= 1.0;
                let half_square = if why == Why::Rest { T::zero() } else { rule.at(&panel.squares, share) };
                let time = fine.then(|| rule.until(&panel.times, share));
                return Ok(Some(Stop { way: self.way(x).0, half_square, why, time }));
            }
            for (joint, force) in now {
                if let Some(least) = least.iter_mut().find(|l| l.0 == joint) {
                    let now = T::leading(|| force.f64());
                    (least.1, least.2) = (f64::min(least.1, now), f64::max(least.2, force.size()));
                }
            }
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
        let ((a, b), rule) = (panel.ends, self.fine.rule);
        let share = |x: T| (x - a) / (b - a);
        let square = |x: T| rule.at(&panel.squares, share(x));
        match (why, level) {
            (Why::Speed, Some((level, rising))) => {
                root::between_values(before, after, rising, &|x| Ok(square(x) - level))
            }
            (Why::Leaves(joint), _) => {
                let forces = panel.pushes.iter().find(|p| p.0 == joint).map(|p| &p.1);
                let force = |x: T| forces.map_or_else(T::zero, |forces| rule.at(forces, share(x)));
                let x = root::between_values(before, after, force(after).sign() > 0.0, &|x| {
                    Ok::<_, Refusal>(force(x))
                })?;
                // What the interpolation leaves of the force is taken off by one step.
                let step = (x - before).scale2(-20);
                let slope = (force(x) - force(x - step)) / step;
                let (_, response) = self.at(self.way(x).0)?;
                Ok(self.pushed(&response, joint, square(x)).map_or(x, |force| x - force / slope))
            }
            _ => root::between_values(before, after, false, &|x| Ok(square(x))),
        }
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
        Ok((Stop { way: x, half_square, why, time: Some(time) }, count))
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
            let leading = respond(way).map(|response| mechanism.leading(&response));
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
        let route = Route { law, presses: &presses, switch: None, u0, pace, time: known };
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
            let from = Gain { half_square: T::zero(), factor: T::of(1.0) };
            let (start, near) = (self.angle(way), T::zero());
            let back = Motion { start, sense: -self.sense, from, near, ..self.clone() };
            let back = back.set_off(&self.mechanism.state(start, true)?)?;
            return Ok(self.time(half, false)? + back.time(half, false)?);
        }
        let mut time = T::zero();
        let mut visit = |panel: &Panel<T>, _: Gain<T>| {
            time = time + self.fine.rule.mean(&panel.times);
            Ok(false)
        };
        self.over((T::zero(), self.variable(way)), self.from, true, &mut visit)?;
        Ok(plant!("eom: time of joined bodies", time))
    }

    /// The angle of a body on a pin after a way, at the end of which it rests or not; `exactly` as the end has it.
    fn place(&self, way: T, rest: bool, exactly: bool) -> Half<T> {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        let about = scene.start_angle(n).plus(Half::of_radians(way.signed(self.sense)));
        match (scene.end, &self.pendulum) {
            // The angle itself is printed; the way to it would round it.
            (End::Angle(_, angle), _) if exactly => Half::of_degrees(n.get(angle)),
            (_, Some(pendulum)) if rest && exactly => {
                // A hair from the top the way to it would round off the hair.
                let Half { sine, cosine } = pendulum.turned();
                let hanging = Half { sine: sine.signed(self.sense), cosine };
                let up = scene.planar(self.mechanism.lead).is_some_and(|p| p.from == Ray::Up);
                let half = if up { hanging.less_half_turn() } else { hanging };
                let same = half.sine * about.sine + half.cosine * about.cosine;
                if same.sign() < 0.0 { Half { sine: -half.sine, cosine: -half.cosine } } else { half }
            }
            _ => about,
        }
    }

    /// How far a body on a pin gets before it turns, up to twice the way on which it was followed. What spoils the motion further on
    /// does not matter.
    fn limit(&self, stop: &Stop<T>) -> Option<T> {
        let beyond = || {
            let state = self.mechanism.state(self.angle(stop.way), true).ok()?;
            let from = Gain { half_square: stop.half_square, factor: self.mechanism.inertia(&state) };
            let onward = Motion { start: self.angle(stop.way), from, ..self.clone() };
            let next = onward.stop(stop.way, None, false, &mut []).ok()?;
            (next.why == Why::Rest).then(|| stop.way + next.way)
        };
        match &self.pendulum {
            _ if stop.half_square.is_zero() => Some(stop.way),
            Some(pendulum) => pendulum.turning(),
            None => beyond(),
        }
    }

    /// The greatest rate before a body on a pin turns, or on two turns, and at least that of where it stops; infinite where what comes
    /// after that, such as a spring through its anchor, has no speed.
    fn fastest(&self, stop: &Stop<T>) -> T {
        let known = stop.half_square.larger(self.from.half_square).scale2(1).root();
        if let Some(pendulum) = &self.pendulum {
            return known.larger(pendulum.fastest(pendulum.turning()));
        }
        let mut greatest = known.square().scale2(-1);
        let mut visit = |panel: &Panel<T>, _: Gain<T>| {
            let values: Vec<T> = panel.squares.iter().copied().chain([panel.last.half_square]).collect();
            let fallen = values.iter().position(|y| y.sign() < 0.0);
            let until = fallen.unwrap_or(values.len());
            let nodes: Vec<f64> = self.fine.rule.nodes.iter().map(|s| s.hi).chain([1.0]).collect();
            let best = (0..until).max_by(|a, b| values[*a].f64().total_cmp(&values[*b].f64()));
            if let Some(i) = best {
                // Between its neighbours it has one peak.
                let (mut low, mut high) =
                    (i.checked_sub(1).map_or(0.0, |i| nodes[i]), *nodes.get(i + 1).unwrap_or(&1.0));
                let at = |x: f64| self.fine.rule.at(&panel.squares, T::of(x));
                for _ in 0..PEAK {
                    let [a, b] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
                    if at(a).below(at(b)) { low = a } else { high = b }
                }
                greatest = greatest.larger(values[i]).larger(at(0.5 * (low + high)));
            }
            Ok(fallen.is_some())
        };
        match self.over((T::zero(), self.variable(horizon())), self.from, false, &mut visit) {
            Ok(_) => greatest.scale2(1).root(),
            Err(_) => T::of(f64::INFINITY),
        }
    }

    /// Period and greatest speed of a pendulum from rest by the steps of a rung, where they are wanted.
    fn step_through(
        &self,
        teller: &mut Teller<'_, '_, T>,
        pendulum: &Pendulum<T>,
        asked: &dyn Fn(Quantity) -> bool,
    ) -> Result<(), Refusal> {
        let wanted = asked(Quantity::Period) || asked(Quantity::OmegaMax);
        let (Some(far), Some((rung, _)), true) = (pendulum.turning(), teller.by, wanted && self.rests())
        else {
            return Ok(());
        };
        let far = far.f64();
        let events = [(Event::Level, 0.5 * far), (Event::Fall(0.0), far)];
        let (states, count) = self.run(&events, far, &|| pendulum.period().0.f64(), rung)?;
        let [lowest, turned] = states[..] else { return Ok(()) };
        teller.count.evaluations += count.evaluations;
        teller.count.steps += count.steps;
        teller.count.refused += count.refused;
        teller.replace(Quantity::Period, T::of(2.0 * turned.time));
        teller.replace(Quantity::OmegaMax, T::of(lowest.u));
        Ok(())
    }

    /// Follows the motion to the end that is asked and tells what is there.
    fn to_its_end(&self, teller: &mut Teller<'_, '_, T>) -> Result<(), Refusal> {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        let degrees = || T::constant(Dd::new(180.0) / Dd::PI);
        let (mut asked, mut far, mut level) = (None, horizon(), None);
        match scene.end {
            End::Angle(_, angle) => {
                let start = scene.lead().and_then(|l| scene.planar(l)?.start_deg);
                let apart = (n.get(angle) - start.map_or_else(T::zero, |s| n.get(s))).signed(self.sense);
                asked = Some(apart);
                far = apart / degrees();
            }
            End::Speed(_, w) => {
                let w = n.get(w) / self.mechanism.ratio();
                asked = Some(w.abs());
                level = Some(w.square().scale2(-1));
            }
            End::Time(_, t) => asked = Some(n.get(t)),
            _ => {}
        }
        let leaving = match scene.end {
            End::Leaves(joint) => Some(joint),
            _ => None,
        };
        let limit =
            self.mechanism.overwinds(self.sense, (far + look(), look())).filter(|limit| limit.at_most(far));
        far = limit.map_or(far, |limit| limit * T::of(SHORT));
        // What does not push at the start is not touched.
        let weights = self.weights();
        let (first, begin) = self.at(T::zero())?;
        for joint in (0..scene.joints.len()).filter(|j| scene.joints[*j].kind.is_one_sided()) {
            let force = self.pushed(&begin, joint, self.from.half_square);
            if force.is_some_and(|force| force.below(T::of(PUSHES * weights))) {
                let drive = (T::zero(), T::zero());
                teller.road.course =
                    Some(Course { sense: self.sense, drive, asked, farthest: T::zero(), reached: false });
                teller.road.held.push(Held::Touching(joint, 0.0, 1.0));
                return Ok(());
            }
        }
        let nothing: Vec<(usize, f64, f64)> =
            (0..scene.joints.len()).map(|j| (j, f64::INFINITY, 0.0)).collect();
        let mut least = nothing.clone();
        let backward = far.sign() < 0.0;
        let by = teller.by.filter(|_| STEPS && !backward);
        let mut stop = if let Some((rung, _)) = by {
            let known = || match teller.pinned {
                Some(_) => self.until(far, level).unwrap_or(f64::INFINITY),
                None => f64::INFINITY,
            };
            let (stop, count) = self.stepped((far, level), &known, rung)?;
            teller.count = count;
            stop
        } else if backward {
            Stop { way: T::zero(), half_square: self.from.half_square, why: Why::Far, time: None }
        } else if let (Some(level), Some(_)) = (level, teller.pinned)
            && level.side(self.from.half_square) == 0.0
        {
            Stop { way: T::zero(), half_square: level, why: Why::Speed, time: None }
        } else {
            // Whether the time is asked changes no other answer, not even by its rounding.
            self.stop(far, level, matches!(scene.end, End::Time(..)), &mut least)?
        };
        let (mut time, mut most) = (stop.time, None);
        let overwound =
            || if limit.is_some() { Err(Refusal::Unsupported(Unsupported::Overwound)) } else { Ok(()) };
        if stop.why == Why::Far && !matches!(scene.end, End::Time(..)) {
            overwound()?;
        }
        if let (End::Time(_, t), None) = (scene.end, by) {
            let t = n.get(t);
            let until = match time {
                Some(time) => time,
                None => self.time(stop.way, stop.why == Why::Rest)?,
            };
            most = Some(until);
            if t.side(until) == 0.0 {
                (stop.why, time) = (Why::Far, most);
            } else if t.below(until) {
                let way = root::between_values(T::zero(), stop.way, true, &|way| {
                    Ok::<_, Refusal>(self.time(way, false)? - t)
                })?;
                // What pushes is watched up to there alone.
                least = nothing;
                stop = Stop { why: Why::Far, ..self.stop(way, None, false, &mut least)? };
                time = Some(t);
            } else {
                if stop.why == Why::Far {
                    overwound()?;
                }
                (stop.why, time) = (Why::Rest, None);
            }
        }
        let reached = !backward
            && match scene.end {
                End::Angle(..) => stop.why == Why::Far,
                End::Speed(..) => stop.why == Why::Speed,
                End::TurningPoint(_) => stop.why == Why::Rest,
                End::Leaves(joint) => stop.why == Why::Leaves(joint),
                End::Time(..) => stop.why == Why::Far && time.is_some(),
                _ => false,
            };
        let margins = teller.pinned.is_some() && teller.asked.held;
        let farthest = match scene.end {
            End::Angle(..) if reached && margins => {
                self.limit(&stop).map_or_else(|| T::of(f64::INFINITY), |way| way * degrees())
            }
            End::Speed(..) if margins => self.fastest(&stop),
            End::Time(..) if teller.pinned.is_some() => most.unwrap_or_else(|| T::of(f64::INFINITY)),
            End::Angle(..) if reached => T::of(f64::INFINITY),
            End::Angle(..) => stop.way * degrees(),
            End::TurningPoint(_) if stop.why == Why::Rest => stop.way * degrees(),
            _ => T::of(f64::INFINITY),
        };
        let drive = (T::zero(), T::zero());
        teller.road.course = Some(Course { sense: self.sense, drive, asked, farthest, reached });
        for (joint, least, most) in least {
            let one_sided = scene.joints[joint].kind.is_one_sided();
            if one_sided && least.is_finite() && leaving != Some(joint) {
                let [least, most] = [least, most].map(|x| n.publish(Quantity::Normal, T::of(x)).f64());
                teller.road.held.push(Held::Touching(joint, least, most));
            }
        }
        if let Why::Leaves(joint) = stop.why
            && leaving != Some(joint)
        {
            teller.road.held.retain(|h| !matches!(h, Held::Touching(j, ..) if *j == joint));
            teller.road.held.push(Held::Touching(joint, 0.0, 1.0));
        }
        if !reached {
            return teller.tell_standing(&first, &begin, self.from.half_square.scale2(1));
        }
        teller.tell_met(&self.meets, stop.way)?;
        let rest = stop.why == Why::Rest || stop.half_square.is_zero();
        if teller.asked.quantities.has(Quantity::T) {
            let time = match time {
                Some(time) => time,
                None => self.time(stop.way, rest)?,
            };
            teller.say(Quantity::T, Owner::Scene, time);
        }
        teller.say(Quantity::Phi, Owner::Body(self.mechanism.lead), stop.way);
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
        let rubs = (0..scene.joints.len()).filter(|j| self.slides[*j] != 0.0 && leaving != Some(*j));
        if !self.slides_on(&state) || !rubs.into_iter().all(presses_on) {
            return Err(Refusal::Unsupported(Unsupported::FrictionTurns));
        }
        if let (Some(pinned), Some((_, rung_asks))) = (&self.pendulum, by) {
            self.step_through(teller, pinned, rung_asks)?;
        }
        let size = self.mechanism.size();
        for (b, body) in scene.bodies.iter().enumerate() {
            let (high, low) = (self.mechanism.height(&state, b), self.mechanism.height(&first, b));
            if body.planar.is_some() && teller.pinned.is_none() {
                teller.say_scaled(Quantity::Rise, Owner::Body(b), high - low, size);
            }
        }
        let speed = stop.half_square.scale2(1).root().signed(self.sense);
        let lead = self.mechanism.leading(&response);
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
}

impl<T: Real> Teller<'_, '_, T> {
    fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.say_scaled(quantity, of, value, value.size());
    }
    fn say_scaled(&mut self, quantity: Quantity, of: Owner, value: T, scale: f64) {
        use Quantity::{AX, AY, VX, VY};
        let of = match (self.pinned, of) {
            (Some(body), Owner::Joint(_) | Owner::Strut(_)) => Owner::Body(body),
            _ => of,
        };
        let apart = matches!(quantity, VX | VY | AX | AY) || matches!(of, Owner::Spot(_));
        if apart && self.pinned.is_some() {
            return;
        }
        if self.asked.quantities.has(quantity) {
            self.road.said.push(Said::of(self.n, Label { quantity, of }, value, scale));
        }
    }

    /// Puts another value in the place of what was said of a body on a pin.
    fn replace(&mut self, quantity: Quantity, value: T) {
        let value = self.n.publish(quantity, value);
        for said in self.road.said.iter_mut().filter(|s| s.label.quantity == quantity) {
            said.value = value;
        }
    }

    /// A body on a pin under its weight alone, on its way in this sense from a place and with this rate there, by its closed form.
    fn pendulum(&self, state: &State<T>, sense: f64, rate: T) -> Option<Pendulum<T>> {
        let planar = self.scene.planar(self.pinned?)?;
        let numbers = &self.n.bodies[self.mechanism.lead];
        let arm = pose::along(self.n, planar.centre);
        let weight = plant!("eom: weight of a pendulum", numbers.mass * self.n.gravity);
        let frequency = (weight * arm / self.mechanism.inertia(state)).root();
        let free = self.scene.couples.is_empty() && self.scene.struts.is_empty();
        let start = self.scene.start_angle(self.n);
        let hanging = if planar.from == Ray::Up { start.less_half_turn() } else { start };
        let hanging = Half { sine: hanging.sine.signed(sense), cosine: hanging.cosine };
        let half_square = rate.square().scale2(-1);
        (free && !frequency.is_zero()).then(|| Pendulum::new(hanging, half_square, frequency))
    }

    /// What holds of a body on a pin whatever the end.
    fn tell_lasting(&mut self, rate: T) -> Result<(), Refusal> {
        use Quantity::{IO, OmegaMax, OmegaSmall, Period, PeriodSmall};
        if !self.asked.any(&[IO, OmegaMax, OmegaSmall, Period, PeriodSmall]) {
            return Ok(());
        }
        let (mechanism, of) = (self.mechanism, Owner::Body(self.mechanism.lead));
        let state = mechanism.state(T::zero(), true)?;
        self.say(IO, of, mechanism.inertia(&state));
        let sense = if rate.is_zero() { mechanism.drive(&state).sign() } else { rate.sign() };
        if let Some(pendulum) = self.pendulum(&state, sense, rate) {
            let (frequency, (period, fastest)) = (pendulum.frequency(), pendulum.period());
            self.say(OmegaSmall, of, frequency);
            self.say(PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
            self.say(Period, of, period);
            self.say(OmegaMax, of, fastest);
        }
        Ok(())
    }

    /// Acceleration and forces of a body on a pin where it stands, at this square of its rate.
    fn tell_standing(&mut self, state: &State<T>, response: &Response<T>, square: T) -> Result<(), Refusal> {
        let Some(body) = self.pinned else { return Ok(()) };
        let (constant, by_square) = self.mechanism.turning(response, body);
        let scale = self.terms(state);
        self.say_scaled(Quantity::Alpha, Owner::Body(body), constant.balance(by_square * square), scale);
        let nothing: SmallVec<[f64; 4]> = self.scene.joints.iter().map(|_| 0.0).collect();
        self.tell_forces(state, response, square, &nothing);
        Ok(())
    }

    /// Magnitudes of the terms of the angular acceleration of a body on a pin.
    fn terms(&self, state: &State<T>) -> f64 {
        self.mechanism.drive_of_terms(state).1 / self.mechanism.inertia(state).size()
    }

    /// How a body on a pin has turned.
    fn tell_turned(&mut self, way: T, sense: f64, place: &Half<T>) {
        let Some(body) = self.pinned else { return };
        let (of, Some(planar)) = (Owner::Body(body), self.scene.planar(body)) else { return };
        let (start, step) = (self.scene.start_angle(self.n), Half::of_radians(way.signed(sense)));
        // A difference of two heights, as a product.
        let product = (step.sine * place.plus(start).sine).scale2(1);
        let arm = pose::along(self.n, planar.centre);
        let sunk = plant!("eom: height lost by the mass centre", arm) * product;
        let rise = if planar.from == Ray::Up { -sunk } else { sunk };
        self.say_scaled(Quantity::Rise, of, rise, 2.0 * arm.size());
        if let Some(moment) = couple_on(self.scene, self.n, body) {
            self.say(Quantity::WorkCouple, of, moment.signed(sense) * way);
        }
    }

    /// The stable equilibrium toward which the bodies set off from rest, and small oscillations about it: `q'' = A'(q_e) (q - q_e)`.
    fn tell_equilibrium(&mut self, smooth: &[f64]) -> Result<(), Refusal> {
        let (scene, mechanism) = (self.scene, self.mechanism);
        let at = |way: T| {
            let state = mechanism.state(way, true)?;
            let response = mechanism.respond(&state, smooth)?;
            Ok::<_, Refusal>((state, response))
        };
        let drive = |way: T| Ok(mechanism.leading(&at(way)?.1).0);
        let sense = drive(T::zero())?.sign();
        let mut found = (sense == 0.0).then(T::zero);
        let (mut before, full) = (T::zero(), T::constant(Dd::PI.scale2(1)));
        while sense != 0.0 && found.is_none() && before.below(full) {
            let next = before + look();
            if drive(next.signed(sense))?.signed(sense).sign() <= 0.0 {
                let way = root::between_values(before, next, false, &|x| {
                    Ok::<_, Refusal>(drive(x.signed(sense))?.signed(sense))
                })?;
                found = Some(way.signed(sense));
            }
            before = next;
        }
        let stiffness = match found {
            Some(way) => {
                // No difference is taken across a place where a spring is met; just there nothing oscillates evenly.
                let meets = [1.0, -1.0].into_iter().flat_map(|sense| mechanism.meets(sense, (full, look())));
                let apart = meets.map(|(_, at)| (at - way).abs().scale2(-1));
                let widest = apart.fold(look(), |one, other| if other.below(one) { other } else { one });
                let slope = if widest.size() < SHORTEST { T::zero() } else { slope(&drive, way, widest)? };
                -plant!("eom: slope of the acceleration at equilibrium", slope)
            }
            None => T::zero(),
        };
        // Where it is indifferent, rounding is left of its stiffness.
        let nothing = T::of(INDIFFERENT * self.pulls() * mechanism.size());
        let inertia = mechanism.inertia(&mechanism.state(found.unwrap_or_else(T::zero), true)?);
        let (Some(way), true) = (found, nothing.below(stiffness * inertia)) else {
            self.road.course = Some(Course::nowhere());
            return Ok(());
        };
        if LOOKED_THROUGH {
            self.gets_to(way)?;
        }
        if mechanism.overwinds(sense, (way.abs(), look())).is_some() {
            return Err(Refusal::Unsupported(Unsupported::Overwound));
        }
        self.tell_met(&mechanism.meets(sense, (way.abs(), look())), way.abs())?;
        let (of, frequency) = (Owner::Body(mechanism.lead), stiffness.root());
        self.say(Quantity::OmegaSmall, of, frequency);
        self.say(Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        self.say_scaled(Quantity::Phi, of, way.abs(), 1.0);
        let ((first, _), (state, response)) = (at(T::zero())?, at(way)?);
        for b in 0..scene.bodies.len() {
            let risen = mechanism.height(&state, b) - mechanism.height(&first, b);
            self.say_scaled(Quantity::Rise, Owner::Body(b), risen, mechanism.size());
        }
        self.tell_forces(&state, &response, T::zero(), smooth);
        self.watch(&response, T::zero());
        Ok(())
    }

    /// Errors: a place on the way at which the bodies cannot pass, as where a linkage locks.
    fn gets_to(&self, way: T) -> Result<(), Refusal> {
        // So near nothing lies between, and doubles do not resolve how the drive falls off.
        if way.size() < BESIDE {
            return Ok(());
        }
        let (mechanism, nothing) = (self.mechanism, self.scene.joints.iter().map(|_| 0.0));
        let begin = mechanism.state(T::zero(), true)?;
        let motion = Motion {
            mechanism,
            start: T::zero(),
            sense: way.sign(),
            from: Gain { half_square: T::zero(), factor: mechanism.inertia(&begin) },
            near: T::zero(),
            slides: nothing.clone().collect(),
            rubs: nothing.collect(),
            meets: mechanism.meets(way.sign(), (way.abs(), look())),
            panels: Cell::new(PANELS),
            pendulum: None,
            fine: Fine::of::<T>(self.scene, self.pinned.is_some()),
            timed: false,
        };
        let motion = motion.set_off(&begin)?;
        motion.over((T::zero(), motion.variable(way.abs())), motion.from, false, &mut |_, _| Ok(false))?;
        Ok(())
    }

    /// Is each spring that only pushes or pulls met on this way, if it does not act from the start?
    fn tell_met(&mut self, meets: &[(usize, T)], way: T) -> Result<(), Refusal> {
        if !LOOKED_THROUGH {
            return Ok(());
        }
        let begin = self.mechanism.poses(T::zero(), true)?;
        for s in (0..self.scene.struts.len()).filter(|s| self.scene.struts[*s].acts != Acts::Both) {
            let first =
                meets.iter().find(|(strut, _)| *strut == s).map_or(f64::INFINITY, |(_, at)| at.size());
            let met = if self.mechanism.idles(&begin, s) { first } else { 0.0 };
            self.road.held.push(Held::Met(s, met, T::leading(|| way.f64())));
        }
        Ok(())
    }

    /// Do the joints that can only push or only pull do so, at this square of the rate?
    fn watch(&mut self, response: &Response<T>, square: T) {
        for (j, _) in self.scene.joints.iter().enumerate().filter(|(_, j)| j.kind.is_one_sided()) {
            if let Some(force) = self.mechanism.reaction(response, j, square) {
                let force = self.n.publish(Quantity::Normal, force[0]);
                self.road.held.push(Held::Touching(j, T::leading(|| force.f64()), force.size()));
            }
        }
    }

    /// Sum of the magnitudes of all impulses that strike.
    fn blows(&self) -> f64 {
        let blows = self.scene.pushes.iter().filter(|p| p.blow);
        blows.map(|p| self.n.massive(p.force_n).size()).sum()
    }

    /// What the moments of all forces about one another come to at most, N m.
    fn drives(&self) -> f64 {
        let pushes = self.scene.pushes.iter().filter(|p| !p.blow).map(|p| self.n.massive(p.force_n).size());
        let couples = self.scene.couples.iter().map(|c| self.n.massive(c.moment_n_m).size());
        (self.pulls() + pushes.sum::<f64>()) * self.mechanism.size() + couples.sum::<f64>()
    }

    /// The impulses of the joints at a blow. One that can only push and would have to pull lets go, and the other way round.
    fn tell_blow(&mut self, jumps: &Response<T>) {
        let all = self.blows();
        for (j, joint) in self.scene.joints.iter().enumerate() {
            let (of, quantities) = (Owner::Joint(j), joint.kind.impulses());
            let Some(impulses) = self.mechanism.reaction(jumps, j, T::zero()) else {
                self.road.open.extend(quantities.iter().map(|q| Label { quantity: *q, of }));
                continue;
            };
            for (quantity, impulse) in quantities.iter().zip(&impulses) {
                let impulse = plant!("eom: impulse of a joint", *impulse);
                self.say_scaled(*quantity, of, impulse, impulse.size() + all);
            }
            if joint.kind.is_one_sided() && impulses[0].below(T::of(-PUSHES * all)) {
                let [pull, all] =
                    [impulses[0], T::of(all)].map(|x| self.n.publish(Quantity::Impulse, x).f64());
                self.road.held.push(Held::Jolted(j, pull, all));
            }
        }
    }

    /// Velocities and energy at this rate of what leads, with the accelerations where they are told.
    fn tell_motion(&mut self, state: &State<T>, rate: T, response: Option<(&Response<T>, f64, f64)>) {
        let (scene, mechanism) = (self.scene, self.mechanism);
        let (mut energy, mut heavy) = (T::zero(), 0.0);
        // The fastest point moves no faster than this share of the leading angle's rate.
        let fastest = rate.size() * mechanism.size();
        for (b, body) in scene.bodies.iter().enumerate() {
            let of = Owner::Body(b);
            let [vx, vy] = mechanism.velocity(state, b).map(|v| v * rate);
            let speed = (vx.square() + vy.square()).root();
            let numbers = self.n.bodies[b];
            energy = energy + numbers.mass * speed.square();
            heavy += numbers.mass.size();
            self.say_scaled(Quantity::V, of, speed, fastest);
            self.say_scaled(Quantity::VX, of, vx, fastest);
            self.say_scaled(Quantity::VY, of, vy, fastest);
            if let Some((response, pulls, _)) = response {
                let mut seen = mechanism.acceleration(response, b, rate.square());
                for (a, with) in seen.iter_mut().zip(self.n.carried.iter().flatten()) {
                    *a = a.balance(plant!("eom: acceleration of the carrier in the plane", *with));
                }
                let [ax, ay] = seen;
                let size = ax.size()
                    + ay.size()
                    + if numbers.mass.is_zero() { 0.0 } else { pulls / numbers.mass.size() };
                self.say_scaled(Quantity::AX, of, ax, size);
                self.say_scaled(Quantity::AY, of, ay, size);
            }
            if body.turns {
                let spin = mechanism.spin(state, b) * rate;
                energy = energy + numbers.inertia * spin.square();
                self.say_scaled(Quantity::Omega, of, spin.abs(), f64::max(spin.size(), rate.size()));
                if let Some((response, _, terms)) = response {
                    let (constant, by_square) = mechanism.turning(response, b);
                    let alpha = constant.balance(by_square * rate.square());
                    let own = constant.size() + by_square.size() * rate.square().size();
                    self.say_scaled(Quantity::Alpha, of, alpha, f64::max(own, terms));
                }
            }
            let points = body.planar.as_ref().map_or(0, |p| p.points.len());
            for spot in (0..points).map(|point| Spot { body: b, point }) {
                let [x, y] = mechanism.speed(state, spot).map(|v| v * rate);
                self.say_scaled(Quantity::V, Owner::Spot(spot), (x.square() + y.square()).root(), fastest);
            }
        }
        let most = f64::max(energy.size(), heavy * fastest * fastest);
        self.say_scaled(Quantity::KineticEnergy, Owner::Scene, energy.scale2(-1), most);
    }

    /// Momentum and shares of a body on a pin that turns at this rate.
    fn tell_spin(&mut self, state: &State<T>, rate: T) {
        let Some(body) = self.pinned else { return };
        let (of, inertia) = (Owner::Body(body), self.mechanism.inertia(state));
        self.say(Quantity::AngularMomentum, of, inertia * rate.abs());
        if !rate.is_zero() {
            self.say(Quantity::RotationalFraction, Owner::Scene, self.n.bodies[body].inertia / inertia);
        }
        if let Some(moment) = couple_on(self.scene, self.n, body)
            && self.road.course.is_some()
        {
            self.say(Quantity::PowerCouple, of, moment * rate);
        }
    }

    /// The force of the pin of a body along its axis, toward the pin, and across, positive with a growing angle.
    fn tell_along(&mut self, state: &State<T>, response: &Response<T>, square: T, [x, y]: [T; 2]) {
        let (mechanism, Some(body)) = (self.mechanism, self.pinned) else { return };
        let ([c, s], sense) = (mechanism.axis(state, body), mechanism.sense(body));
        let scale = x.size() + y.size() + self.pulls();
        let radial = -(x * c).balance(y * s);
        let mut across = ((y * c).balance(-(x * s)).signed(sense), scale);
        // Of a body whose mass sits at its centre it is a small difference, but not of the moments about that.
        let arm = self.scene.planar(body).map_or_else(T::zero, |p| pose::along(self.n, p.centre));
        if !arm.is_zero() {
            let (constant, by_square) = mechanism.turning(response, body);
            let turning = self.n.bodies[body].inertia * constant.balance(by_square * square);
            let moment = mechanism.moment(state, body);
            let size = (moment.size() + turning.size()) / arm.size();
            if size < scale {
                across = (moment.balance(-turning) / arm, size);
            }
        }
        self.say_scaled(Quantity::PinRadial, Owner::Body(body), radial, scale);
        self.say_scaled(Quantity::PinTangential, Owner::Body(body), across.0, across.1);
    }

    /// Everything at a place, at this rate of the leading angle.
    fn tell(
        &mut self,
        state: &State<T>,
        response: &Response<T>,
        (rate, lead): (T, (T, T)),
        sliding: &[f64],
    ) -> Result<(), Refusal> {
        let square = rate.square();
        // Where all vanish by symmetry, what falls freely over such a distance is left to measure them by.
        let size = self.mechanism.size();
        let free = if size > 0.0 { self.n.gravity.size() / size } else { 0.0 };
        let all = lead.0.size() + lead.1.size() * square.size() + square.size() + free;
        // Of a body on a pin its own terms measure them.
        let terms = if self.pinned.is_some() { self.terms(state) } else { all };
        self.tell_motion(state, rate, Some((response, self.pulls(), terms)));
        self.tell_spin(state, rate);
        self.tell_forces(state, response, square, sliding);
        Ok(())
    }

    /// Forces that may cancel wherever a force or an acceleration vanishes.
    fn pulls(&self) -> f64 {
        pose::pulls(self.scene, self.n)
    }

    /// The forces of joints and springs at this square of the rate of the leading angle.
    fn tell_forces(&mut self, state: &State<T>, response: &Response<T>, square: T, sliding: &[f64]) {
        let (scene, mechanism, pulls) = (self.scene, self.mechanism, self.pulls());
        for (j, joint) in scene.joints.iter().enumerate() {
            let of = Owner::Joint(j);
            let quantities = joint.kind.forces();
            let Some(force) = mechanism.reaction(response, j, square) else {
                self.road.open.extend(quantities.iter().map(|q| Label { quantity: *q, of }));
                continue;
            };
            for (quantity, force) in quantities.iter().zip(&force) {
                self.say_scaled(*quantity, of, *force, force.size() + pulls);
            }
            if let (JointKind::Guide { direction_deg, mu_k: Some(mu), .. }, [normal]) =
                (joint.kind, force.as_slice())
            {
                let up = pose::upward(pose::direction(self.n, direction_deg));
                let most = plant!("eom: friction that is told", self.n.get(mu)) * *normal;
                let friction = -most.signed(sliding[j]).signed(up);
                self.say_scaled(Quantity::Friction, of, friction, force[0].size() + pulls);
            }
            if let ([x, y, ..], [_, Quantity::PinY, ..]) = (force.as_slice(), quantities) {
                let [x, y] = [x, y].map(|f| f.cleared(f.size() + pulls));
                self.tell_along(state, response, square, [x, y]);
                let force = (x.square() + y.square()).root();
                self.say_scaled(Quantity::PinForce, of, force, force.size() + pulls);
                if self.asked.quantities.has(Quantity::PinAngle) && !force.is_zero() {
                    self.say_scaled(Quantity::PinAngle, of, trig::angle(y, x), pulls / force.size());
                }
            }
        }
        for (s, strut) in scene.struts.iter().enumerate() {
            let (of, force) = (Owner::Strut(s), mechanism.tension(state, s));
            if strut.twists() {
                self.say_scaled(Quantity::Moment, of, -force, force.size() + pulls * mechanism.size());
            } else {
                self.say_scaled(Quantity::SpringForce, of, force, force.size() + pulls);
            }
        }
    }
}
