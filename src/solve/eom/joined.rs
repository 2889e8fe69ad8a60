//! The motion of joined bodies in the plane: the rate of the leading angle and the time, integrated over that angle.
//!
//! The equations of motion give `q'' = A(q) + B(q) q'^2`, a linear equation for `y = q'^2 / 2` over the angle,
//! `dy/dq = A + 2 B y`, solved with its integrating factor `exp(-2 int B dq)` panel by panel. From rest the angle goes as the
//! square of the variable, which takes the root singularity out of the time; the last half of a way that ends at rest is summed
//! as the way back from there.
use crate::num::gauss::{self, PerNode, Unsettled};
use crate::num::plant::plant;
use crate::num::{Dd, Real, root, trig};
use crate::scene::pose;
use crate::scene::{End, JointKind, Label, Numbers, Owner, Quantity, Scene, Spot, Start};
use crate::solve::eom::planar::{Mechanism, Response, State};
use crate::solve::outcome::{Course, Held, Refusal, Road, Said, Scope};
use smallvec::SmallVec;
use std::cell::Cell;

/// A motion is followed for two turns at most.
const TURNS: f64 = 2.0;
/// Angle after which a panel ends at the latest, radians, in numbers of 32 digits and in doubles.
const STRIDE: [f64; 2] = [0.5, 2.0];
/// Legendre coefficients below this share are rounding of the answer: see [`gauss::smooth`]; likewise.
const SMOOTH: [f64; 2] = [1e-18, 1e-12];

/// Panels of a motion at most: the way to a singularity takes fewer, what takes more is rough by its rounding.
const PANELS: u32 = 100;

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
    /// Half the square of the rate at the start.
    half_square: T,
    /// For each joint: sense in which its point slides where it rubs, else 0.
    sliding: SmallVec<[f64; 4]>,
    /// Panels that may still be made.
    panels: Cell<u32>,
}

/// A part of the way on which everything is smooth, told by a variable of which the way is the square where it starts from rest.
struct Panel<T> {
    /// The variable at its ends.
    ends: (T, T),
    /// Half the square of the rate at its nodes, and at its end.
    squares: PerNode<T>,
    last: T,
    /// Integral of the time over it.
    time: T,
    /// For each joint that can only push: its normal force at the nodes.
    pushes: Watched<T>,
    smooth: bool,
    /// Is the time smooth too?
    timely: bool,
}

/// Something of each joint that can only push, at the nodes of a panel.
type Watched<T> = SmallVec<[(usize, PerNode<T>); 2]>;
/// Sees a panel and the half square of the rate at its start; true ends the march.
type Visit<'v, T> = dyn FnMut(&Panel<T>, T) -> Result<bool, Refusal> + 'v;

/// Where a motion stops.
#[derive(Debug, Clone, Copy)]
struct Stop<T> {
    /// Leading angle turned, radians.
    way: T,
    /// Half the square of the rate.
    half_square: T,
    /// What stops it.
    why: Why,
    /// The time until then, where the panels gave it.
    time: Option<T>,
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
}

/// What the equations of motion say of what is asked in a scene of joined bodies.
///
/// Errors: equations that do not determine the motion, a quadrature that does not settle.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>, asked: Scope) -> Result<Road<T>, Refusal> {
    let mechanism = Mechanism::new(scene, n)?;
    let mut teller = Teller { scene, n, mechanism: &mechanism, asked, road: Road::new(asked) };
    let given = scene.start.iter().find_map(|s| match s {
        Start::Speed(c, w) if c.body == mechanism.lead => Some(n.get(*w)),
        _ => None,
    });
    let spin = given.map_or_else(T::zero, |w| w / mechanism.ratio());
    let nothing: SmallVec<[f64; 4]> = scene.joints.iter().map(|_| 0.0).collect();
    if matches!(scene.end, End::AtOnce) {
        let state = mechanism.state(T::zero(), !spin.is_zero())?;
        let smooth = mechanism.respond(&state, &nothing)?;
        // What starts from rest slides as it would without friction.
        let senses = if spin.is_zero() {
            sliding(&mechanism, &|at| mechanism.pull_off(&state, &smooth, at))
        } else {
            sliding(&mechanism, &|at| mechanism.speed(&state, at).map(|v| v * spin))
        };
        let response = mechanism.respond(&state, &senses)?;
        let lead = mechanism.leading(&response);
        teller.tell(&state, &response, (spin, lead), &senses)?;
        return Ok(teller.road);
    }
    let state = mechanism.state(T::zero(), true)?;
    let free = mechanism.respond(&state, &nothing)?;
    let (a, b) = mechanism.leading(&free);
    let first = a.balance(b * spin.square());
    let sense = if spin.is_zero() { first.sign() } else { spin.sign() };
    let sliding = sliding(&mechanism, &|at| mechanism.speed(&state, at).map(|v| v.signed(sense)));
    let motion = Motion {
        mechanism: &mechanism,
        start: T::zero(),
        sense,
        half_square: spin.square().scale2(-1),
        sliding,
        panels: Cell::new(PANELS),
    };
    // Friction may hold what would set off without it.
    let rubbed = mechanism.respond(&state, &motion.sliding)?;
    let (a, b) = mechanism.leading(&rubbed);
    let sets_off = a.balance(b * spin.square()).signed(sense);
    if sense == 0.0 || spin.is_zero() && sets_off.sign() <= 0.0 {
        teller.road.course = Some(Course::at_rest());
        return Ok(teller.road);
    }
    motion.to_its_end(&mut teller)?;
    Ok(teller.road)
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

impl<'m, 'a, T: Real> Motion<'m, 'a, T> {
    fn n(&self) -> &Numbers<'a, T> {
        self.mechanism.n
    }
    fn angle(&self, way: T) -> T {
        self.start + way.signed(self.sense)
    }
    fn rests(&self) -> bool {
        self.half_square.is_zero()
    }
    /// The way at this value of the variable, and its derivative.
    fn way(&self, x: T) -> (T, T) {
        if self.rests() { (x.square(), x.scale2(1)) } else { (x, T::of(1.0)) }
    }
    /// The variable at this way.
    fn variable(&self, way: T) -> T {
        if self.rests() { way.root() } else { way }
    }
    fn at(&self, way: T) -> Result<(State<T>, Response<T>), Refusal> {
        let state = self.mechanism.state(self.angle(way), true)?;
        let response = self.mechanism.respond(&state, &self.sliding)?;
        Ok((state, response))
    }

    fn panel(&self, ends: (T, T), from: T) -> Result<Panel<T>, Refusal> {
        let (width, share) = (ends.1 - ends.0, SMOOTH[usize::from(T::is_double())]);
        let (mut drives, mut growths, mut slopes) = (PerNode::new(), PerNode::new(), PerNode::new());
        let mut pushes: Watched<(T, T)> = SmallVec::new();
        for node in gauss::nodes() {
            let (way, slope) = self.way(ends.0 + width * T::constant(*node));
            let slope = slope * width;
            let (_, response) = self.at(way)?;
            for joint in 0..self.mechanism.scene.joints.len() {
                if let Some(parts) = self.mechanism.push(&response, joint) {
                    match pushes.iter_mut().find(|p| p.0 == joint) {
                        Some((_, list)) => list.push(parts),
                        None => pushes.push((joint, vec![parts])),
                    }
                }
            }
            let (a, b) = self.mechanism.leading(&response);
            drives.push(plant!("eom: acceleration over the angle", a.signed(self.sense)) * slope);
            growths.push(
                plant!("eom: centripetal share over the angle", b.signed(self.sense)).scale2(1) * slope,
            );
            slopes.push(slope);
        }
        let factors: PerNode<T> = gauss::running(&growths).into_iter().map(|x| trig::exp_of(-x)).collect();
        let whole = trig::exp_of(-gauss::mean(&growths));
        let driven: PerNode<T> = drives.iter().zip(&factors).map(|(a, e)| *a * *e).collect();
        let squares: PerNode<T> =
            gauss::running(&driven).into_iter().zip(&factors).map(|(g, e)| (from + g) / *e).collect();
        let times: PerNode<T> =
            squares.iter().zip(&slopes).map(|(y, slope)| *slope / y.scale2(1).root()).collect();
        let force = |(constant, share): &(T, T), square: &T| *constant + *share * square.scale2(1);
        let pushes = pushes
            .iter()
            .map(|(joint, parts)| (*joint, parts.iter().zip(&squares).map(|(p, y)| force(p, y)).collect()))
            .collect();
        Ok(Panel {
            ends,
            pushes,
            last: (from + gauss::mean(&driven)) / whole,
            time: gauss::mean(&times),
            // Growths are exponents: beside 1 they count.
            smooth: gauss::smooth_beside(&growths, share, 1.0)
                && gauss::smooth_beside(&driven, share, from.size()),
            timely: gauss::smooth(&times, gauss::SMOOTH),
            squares,
        })
    }

    /// Shows smooth panels one after the other until `visit` has seen enough; gives half the square of the rate at the end.
    fn over(
        &self,
        ends: (T, T),
        from: T,
        timely: bool,
        left: u32,
        visit: &mut Visit<T>,
    ) -> Result<Option<T>, Refusal> {
        let panel = self.panel(ends, from)?;
        if panel.smooth && (panel.timely || !timely) {
            return Ok((!visit(&panel, from)?).then_some(panel.last));
        }
        let panels = self.panels.get();
        self.panels.set(panels.saturating_sub(1));
        if left == 0 || panels == 0 {
            return Err(Unsettled { value: panel.last.f64(), gap: f64::INFINITY }.into());
        }
        let middle = (ends.0 + ends.1).scale2(-1);
        match self.over((ends.0, middle), from, timely, left - 1, visit)? {
            Some(half) => self.over((middle, ends.1), half, timely, left - 1, visit),
            None => Ok(None),
        }
    }

    /// Normal force of a joint that can only push, at this place.
    fn contact(&self, joint: usize, way: T, half_square: T) -> Result<T, Refusal> {
        let (_, response) = self.at(way)?;
        let parts = self.mechanism.push(&response, joint);
        Ok(parts.map_or_else(T::zero, |(constant, share)| constant + share * half_square.scale2(1)))
    }

    /// Where it first stops within `far`: at rest, at this half square of the rate, or where a joint stops pushing.
    fn stop(&self, far: T, level: Option<T>, least: &mut [(usize, f64, f64)]) -> Result<Stop<T>, Refusal> {
        let (mut x, mut square) = (T::zero(), self.half_square);
        let last = self.variable(far);
        let mut found: Option<Stop<T>> = None;
        let mut time = Some(T::zero());
        while x.below(last) && found.is_none() {
            let (way, _) = self.way(x);
            let next = self.variable(way + T::of(STRIDE[usize::from(T::is_double())]));
            let next = if next.below(last) { next } else { last };
            let mut visit = |panel: &Panel<T>, from: T| {
                found = self.stopped(panel, from, level, least)?;
                time = match &found {
                    Some(stop) => sum(time, stop.time),
                    None => {
                        sum(time, panel.timely.then_some(plant!("eom: time of joined bodies", panel.time)))
                    }
                };
                Ok(found.is_some())
            };
            match self.over((x, next), square, false, gauss::halvings(), &mut visit)? {
                Some(end) => (x, square) = (next, end),
                None => break,
            }
        }
        let stop = found.unwrap_or(Stop { way: far, half_square: square, why: Why::Far, time: None });
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
        let (a, b) = panel.ends;
        let nodes = gauss::nodes().iter().map(|s| a + (b - a) * T::constant(*s));
        let rising = level.map(|l| from.below(l));
        let mut before = a;
        let squares = panel.squares.iter().copied();
        for (i, (x, square)) in nodes.zip(squares).chain([(b, panel.last)]).enumerate() {
            let mut why = None;
            if square.sign() < 0.0 {
                why = Some(Why::Rest);
            } else if let (Some(level), Some(rising)) = (level, rising)
                && (square.reaches(level) == rising)
            {
                why = Some(Why::Speed);
            } else {
                for (joint, forces) in &panel.pushes {
                    let Some(force) = forces.get(i) else { continue };
                    if let Some(least) = least.iter_mut().find(|l| l.0 == *joint) {
                        (least.1, least.2) =
                            (f64::min(least.1, force.f64()), f64::max(least.2, force.size()));
                    }
                    if force.sign() <= 0.0 {
                        why = Some(Why::Leaves(*joint));
                        break;
                    }
                }
            }
            if let Some(why) = why {
                let value = |x: T, square: T| match why {
                    Why::Leaves(joint) => self.contact(joint, self.way(x).0, square),
                    Why::Speed => Ok(square - level.unwrap_or_else(T::zero)),
                    _ => Ok(square),
                };
                let between = |x: T| value(x, gauss::at(&panel.squares, (x - a) / (b - a)));
                let rough = secant(before, x, why == Why::Speed && rising == Some(true), &between)?;
                // What the interpolation leaves is taken off by one step with the panel up to there.
                let step = (x - before).scale2(-20);
                let slope = (between(rough)? - between(rough - step)?) / step;
                let x = rough - value(rough, self.panel((a, rough), from)?.last)? / slope;
                let part = self.panel((a, x), from)?;
                let half_square = if why == Why::Rest { T::zero() } else { part.last };
                let time = (part.timely && why != Why::Rest)
                    .then_some(plant!("eom: time of joined bodies", part.time));
                return Ok(Some(Stop { way: self.way(x).0, half_square, why, time }));
            }
            before = x;
        }
        Ok(None)
    }

    /// Time over a way that ends at rest or not.
    fn time(&self, way: T, rest: bool) -> Result<T, Refusal> {
        if way.is_zero() {
            return Ok(T::zero());
        }
        if rest {
            // The last half is the way back from the turning point.
            let half = way.scale2(-1);
            let back =
                Motion { start: self.angle(way), sense: -self.sense, half_square: T::zero(), ..self.clone() };
            return Ok(self.time(half, false)? + back.time(half, false)?);
        }
        let mut time = T::zero();
        let mut visit = |panel: &Panel<T>, _: T| {
            time = time + panel.time;
            Ok(false)
        };
        self.over((T::zero(), self.variable(way)), self.half_square, true, gauss::halvings(), &mut visit)?;
        Ok(plant!("eom: time of joined bodies", time))
    }

    /// Follows the motion to the end that is asked and tells what is there.
    fn to_its_end(&self, teller: &mut Teller<'_, '_, T>) -> Result<(), Refusal> {
        let (scene, n) = (self.mechanism.scene, self.mechanism.n);
        let horizon = T::constant(Dd::PI * Dd::new(2.0 * TURNS));
        let degrees = || T::constant(Dd::new(180.0) / Dd::PI);
        let (mut asked, mut far, mut level) = (None, horizon, None);
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
        // What does not push at the start is not touched.
        let weights = self.n().bodies.iter().fold(0.0, |sum, b| sum + (b.mass * self.n().gravity).size());
        for joint in (0..scene.joints.len()).filter(|j| scene.joints[*j].kind.only_pushes()) {
            let force = self.contact(joint, T::zero(), self.half_square)?;
            if force.below(T::of(PUSHES * weights)) {
                let drive = (T::zero(), T::zero());
                teller.road.course =
                    Some(Course { sense: self.sense, drive, asked, farthest: T::zero(), reached: false });
                teller.road.held.push(Held::Touching(joint, 0.0, 1.0));
                return Ok(());
            }
        }
        let mut least: Vec<(usize, f64, f64)> =
            (0..scene.joints.len()).map(|j| (j, f64::INFINITY, 0.0)).collect();
        let backward = far.sign() < 0.0;
        let mut stop = if backward {
            Stop { way: T::zero(), half_square: self.half_square, why: Why::Far, time: None }
        } else {
            self.stop(far, level, &mut least)?
        };
        let mut time = stop.time;
        if let End::Time(_, t) = scene.end {
            let t = n.get(t);
            let most = match time {
                Some(time) => time,
                None => self.time(stop.way, stop.why == Why::Rest)?,
            };
            if t.at_most(most) {
                let way = secant(T::zero(), stop.way, true, &|way| Ok(self.time(way, false)? - t))?;
                stop = Stop { way, half_square: self.gained(way)?, why: Why::Far, time: Some(t) };
                time = Some(t);
            } else {
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
        let farthest = match scene.end {
            End::Angle(..) if reached => T::of(f64::INFINITY),
            End::Angle(..) => stop.way * degrees(),
            End::TurningPoint(_) if stop.why == Why::Rest => stop.way * degrees(),
            _ => T::of(f64::INFINITY),
        };
        let drive = (T::zero(), T::zero());
        teller.road.course = Some(Course { sense: self.sense, drive, asked, farthest, reached });
        for (joint, least, most) in least {
            let one_sided = scene.joints[joint].kind.only_pushes();
            if one_sided && least.is_finite() && leaving != Some(joint) {
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
            return Ok(());
        }
        let rest = stop.why == Why::Rest;
        if teller.asked.quantities.has(Quantity::T) {
            let time = match time {
                Some(time) => time,
                None => self.time(stop.way, rest)?,
            };
            teller.say(Quantity::T, Owner::Scene, time);
        }
        teller.say(Quantity::Phi, Owner::Body(self.mechanism.lead), stop.way);
        let (first, _) = self.at(T::zero())?;
        let (state, response) = self.at(stop.way)?;
        let size = self.mechanism.size();
        for (b, body) in scene.bodies.iter().enumerate() {
            let (high, low) = (self.mechanism.height(&state, b), self.mechanism.height(&first, b));
            if body.planar.is_some() {
                teller.say_scaled(Quantity::Rise, Owner::Body(b), high - low, size);
            }
        }
        let speed = stop.half_square.scale2(1).root().signed(self.sense);
        let lead = self.mechanism.leading(&response);
        teller.tell(&state, &response, (speed, lead), &self.sliding)
    }

    /// Half the square of the rate after this way.
    fn gained(&self, way: T) -> Result<T, Refusal> {
        let mut see = |_: &Panel<T>, _: T| Ok(false);
        let end =
            self.over((T::zero(), self.variable(way)), self.half_square, false, gauss::halvings(), &mut see)?;
        Ok(end.unwrap_or(self.half_square))
    }
}

fn sum<T: Real>(one: Option<T>, other: Option<T>) -> Option<T> {
    Some(one? + other?)
}

/// The root of a function without a known slope between two places: by the secant of the last two values, never out of its bracket.
fn secant<T: Real>(
    low: T,
    high: T,
    rising: bool,
    value: &dyn Fn(T) -> Result<T, Refusal>,
) -> Result<T, Refusal> {
    let mut last: Option<(T, T)> = None;
    root::between(low, high, rising, |x| {
        let now = value(x)?;
        let slope = match last {
            Some((at, before)) if !(x - at).is_zero() => (now - before) / (x - at),
            _ => T::zero(),
        };
        last = Some((x, now));
        Ok((now, slope))
    })
}

/// What is said, with the units put back.
struct Teller<'t, 'a, T: Real> {
    scene: &'a Scene,
    n: &'t Numbers<'a, T>,
    mechanism: &'t Mechanism<'a, T>,
    asked: Scope,
    road: Road<T>,
}

impl<T: Real> Teller<'_, '_, T> {
    fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.say_scaled(quantity, of, value, value.f64().abs());
    }
    fn say_scaled(&mut self, quantity: Quantity, of: Owner, value: T, scale: f64) {
        if self.asked.quantities.has(quantity) {
            self.road.said.push(Said::of(self.n, Label { quantity, of }, value, scale));
        }
    }

    /// Everything at a place, at this rate of the leading angle.
    fn tell(
        &mut self,
        state: &State<T>,
        response: &Response<T>,
        (rate, lead): (T, (T, T)),
        sliding: &[f64],
    ) -> Result<(), Refusal> {
        let (scene, mechanism) = (self.scene, self.mechanism);
        let square = rate.square();
        // Where all vanish by symmetry, what falls freely over such a distance is left to measure them by.
        let size = mechanism.size();
        let free = if size > 0.0 { self.n.gravity.size() / size } else { 0.0 };
        let terms = lead.0.size() + lead.1.size() * square.size() + square.size() + free;
        // Forces that may cancel wherever a force or an acceleration vanishes.
        let weights = self.n.bodies.iter().map(|b| (b.mass * self.n.gravity).size());
        let springs = (0..scene.struts.len()).map(|s| mechanism.tension(state, s).size());
        let pulls: f64 = weights.chain(springs).sum();
        let mut energy = T::zero();
        // The fastest point moves no faster than this share of the leading angle's rate.
        let fastest = rate.size() * mechanism.size();
        for (b, body) in scene.bodies.iter().enumerate() {
            let of = Owner::Body(b);
            let [vx, vy] = mechanism.velocity(state, b).map(|v| v * rate);
            let speed = (vx.square() + vy.square()).root();
            let numbers = self.n.bodies[b];
            energy = energy + numbers.mass * speed.square();
            self.say_scaled(Quantity::V, of, speed, fastest);
            self.say_scaled(Quantity::VX, of, vx, fastest);
            self.say_scaled(Quantity::VY, of, vy, fastest);
            let [ax, ay] = mechanism.acceleration(response, b, square);
            let size = ax.size()
                + ay.size()
                + if numbers.mass.is_zero() { 0.0 } else { pulls / numbers.mass.size() };
            self.say_scaled(Quantity::AX, of, ax, size);
            self.say_scaled(Quantity::AY, of, ay, size);
            if body.turns {
                let spin = mechanism.spin(state, b) * rate;
                energy = energy + numbers.inertia * spin.square();
                self.say(Quantity::Omega, of, spin.abs());
                let (constant, by_square) = mechanism.turning(response, b);
                let alpha = constant.balance(by_square * square);
                let own = constant.size() + by_square.size() * square.size();
                self.say_scaled(Quantity::Alpha, of, alpha, f64::max(own, terms));
            }
            let points = body.planar.as_ref().map_or(0, |p| p.points.len());
            for spot in (0..points).map(|point| Spot { body: b, point }) {
                let [x, y] = mechanism.speed(state, spot).map(|v| v * rate);
                self.say_scaled(Quantity::V, Owner::Spot(spot), (x.square() + y.square()).root(), fastest);
            }
        }
        self.say(Quantity::KineticEnergy, Owner::Scene, energy.scale2(-1));
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
            if let ([x, y], [_, Quantity::PinY]) = (force.as_slice(), quantities) {
                self.say(Quantity::PinForce, of, (x.square() + y.square()).root());
            }
        }
        for s in 0..scene.struts.len() {
            let force = mechanism.tension(state, s);
            self.say_scaled(Quantity::SpringForce, Owner::Strut(s), force, force.size() + pulls);
        }
        Ok(())
    }
}
