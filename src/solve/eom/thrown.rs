//! A body thrown with slip: two coordinates with constant accelerations until its contact comes to rest, one from then on.
//!
//! Friction is a force of known size against the slip, with its sign frozen until the event:
//!
//! ```text
//! slip        s = v - c omega                    (velocity of the contact)
//! while s /= 0:  F = -sgn(s) mu_k N,  m a = F - m g sin,  I alpha = -F c
//! event       s + (a - c alpha) t = 0
//! from there  a = c alpha,  F a reaction, |F| <= mu_s N
//! ```
//! Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, section 16.2 (sliding turning into rolling).
use crate::num::Real;
use crate::num::ode::{Count, Formula, Run};
use crate::num::plant::plant;
use crate::scene::{Coordinate, Degree, End, Label, Numbers, Owner, Quantity, Scene, Thrown, speed};
use crate::solve::eom::equations::{CONSTANT, Response, Setting, respond};
use crate::solve::eom::{STEPS, couple_on};
use crate::solve::method::Rung;
use crate::solve::outcome::{Course, Grip, Held, Refusal, Road, Said, Scope, Throw};
use smallvec::{SmallVec, smallvec};
use std::cell::Cell;

/// Says a quantity, with the size of the terms that make it up.
type Says<'r, T> = &'r mut dyn FnMut(Quantity, Owner, T, f64);

/// The phases up to the end, each with the time that it lasts.
type Legs<T> = SmallVec<[(Phase<T>, T); 2]>;

/// Constant accelerations of the centre and of the turn, with the friction that belongs to them.
#[derive(Clone, Copy)]
struct Phase<T> {
    a: T,
    alpha: T,
    friction: T,
}

/// Where the body is and how it moves.
#[derive(Clone, Copy)]
struct State<T> {
    t: T,
    v: T,
    w: T,
    x: T,
    phi: T,
}

impl<T: Real> State<T> {
    /// The state after a time at constant accelerations.
    fn after(self, phase: &Phase<T>, time: T) -> Self {
        let gain = |rate: T| plant!("eom: gain of velocity", rate * time);
        let way = |u: T, rate: T| (u * time).balance((rate * time.square()).scale2(-1));
        Self {
            t: self.t + time,
            v: self.v.balance(gain(phase.a)),
            w: self.w.balance(gain(phase.alpha)),
            x: self.x.balance(plant!("eom: travel while accelerated", way(self.v, phase.a))),
            phi: self.phi.balance(way(self.w, phase.alpha)),
        }
    }
}

/// Path of the centre between two states of one leg, there and back: with `a = (|v0| + |v1|) / t` where it turns back, each way is
/// `v^2 / 2a`.
fn path<T: Real>(from: &State<T>, to: &State<T>) -> T {
    let time = to.t - from.t;
    let speeds = from.v.abs() + to.v.abs();
    if from.v.sign() * to.v.sign() < 0.0 {
        (from.v.square() + to.v.square()).over(speeds).scale2(-1) * time
    } else {
        (speeds * time).scale2(-1)
    }
}

/// A thrown body at its start: how it would roll, how it slips, and when that ends.
struct Contact<'s, 'a, T: Real> {
    scene: &'s Scene,
    n: &'s Numbers<'a, T>,
    thrown: &'s Thrown,
    rolling: Phase<T>,
    /// `None` where it rolls from the start.
    slipping: Option<Phase<T>>,
    normal: T,
    /// Friction that rolling needs, and the most that there is.
    needed: T,
    available: T,
    holds: bool,
    v0: T,
    w0: T,
    /// Speed of the rim at the start.
    rim: T,
    /// Velocity of the contact at the start, and the sense in which it slips.
    slip0: T,
    sense: f64,
    /// Loss of the slip speed per second.
    closing: T,
    /// Time at which the slip ends.
    until: Option<T>,
}

/// Everything that the equations of motion say of a thrown body whose data are admissible.
///
/// While it slips at the end, `a`, `alpha` and `friction` are those of slipping; where the end is the start of rolling, those
/// just before it. An end that is not reached (never rolls, or slips through) leaves what holds at the start. The state at the
/// end is from the steps of a rung, if one is given, with what they cost.
/// Errors: equations that do not determine the motion; a run that does not reach the start of rolling.
pub fn road_by<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    thrown: &Thrown,
    asked: Scope,
    by: Option<Rung>,
) -> Result<(Road<T>, Count), Refusal> {
    let contact = Contact::new(scene, n, thrown)?;
    let mut legs = contact.legs();
    let mut stepped = None;
    if let (Some(legs), Some(rung)) = (&mut legs, by.filter(|_| STEPS)) {
        stepped = Some(contact.stepped(legs, rung)?);
    }
    let mut road = Road::new(asked);
    let mut say = |quantity, of, value: T, scale: f64| {
        if asked.quantities.has(quantity) {
            road.said.push(Said::of(n, Label { quantity, of }, value, scale));
        }
    };
    let now = legs.as_ref().and_then(|legs| legs.last()).map(|leg| leg.0).or(contact.slipping);
    contact.tell_forces(&now.unwrap_or(contact.rolling), &mut say);
    let state = legs.map(|legs| {
        let start = State { t: T::zero(), v: contact.v0, w: contact.w0, x: T::zero(), phi: T::zero() };
        let last = legs.iter().fold(start, |from, (phase, time)| from.after(phase, *time));
        let state = stepped.as_ref().map_or(last, |(state, _)| *state);
        contact.tell_end(&state, &mut say);
        contact.tell_way((start, &legs, &state), &mut say);
        state
    });
    if let Some(state) = &state {
        let coordinate = |degree| Coordinate { body: thrown.body, degree };
        road.velocities = vec![(coordinate(Degree::Along), state.v), (coordinate(Degree::Turn), state.w)];
    }
    road.held.push(Held::Pressed(thrown.body, n.publish(Quantity::Friction, contact.normal).f64()));
    road.held.push(Held::Thrown(contact.throw(state.as_ref())));
    let course = Course::moving(state.map_or(contact.v0, |s| s.v).sign(), state.is_some());
    road.course = Some(Course {
        asked: contact.time(),
        farthest: contact.until.filter(|_| !contact.holds).unwrap_or(course.farthest),
        ..course
    });
    Ok((road, stepped.map_or_else(Count::default, |(_, count)| count)))
}

impl<'s, 'a, T: Real> Contact<'s, 'a, T> {
    fn new(scene: &'s Scene, n: &'s Numbers<'a, T>, thrown: &'s Thrown) -> Result<Self, Refusal> {
        let coordinate = |degree| Coordinate { body: thrown.body, degree };
        let phase = |grip: Grip, sense: f64| -> Result<(Phase<T>, Response<T>), Refusal> {
            let mut friction_sense = smallvec![0.0; scene.ties.len()];
            friction_sense[thrown.tie] = sense;
            let stays = smallvec![false; scene.ties.len()];
            let response =
                respond(scene, n, &Setting { grip, stays, friction_sense, starting: false, probe: None })?;
            let of = |degree| response.acceleration(coordinate(degree), CONSTANT);
            let friction = response.reaction(thrown.tie, CONSTANT);
            Ok((Phase { a: of(Degree::Along), alpha: of(Degree::Turn), friction }, response))
        };
        let (rolling, response) = phase(Grip::AllRoll, 0.0)?;
        let normal = response.normal(thrown.body);
        let (needed, available) = (rolling.friction.abs(), n.get(thrown.mu_s) * normal);
        let holds = needed.at_most(available);
        let c = n.get(thrown.radius_m);
        let (v0, w0) = (n.start(coordinate(Degree::Along), thrown.speed_m_s), n.get(thrown.spin_rad_s));
        let rim = plant!("eom: speed of the rim at the start", c * w0);
        let slip0 = v0.apart(rim);
        // A contact that is at rest and cannot be held begins to slip against the friction that it would need.
        let sense = if !slip0.is_zero() {
            slip0.sign()
        } else if holds {
            0.0
        } else {
            -rolling.friction.sign()
        };
        let slipping = if sense == 0.0 { None } else { Some(phase(Grip::Declared, -sense)?.0) };
        let closing = slipping.map_or_else(T::zero, |p| {
            let turned = plant!("eom: rim of a slipping body", c) * p.alpha;
            p.a.balance(-turned).signed(-sense)
        });
        let closes = !slip0.is_zero() && closing.sign() > 0.0;
        let until = if closes { Some(slip0.abs() / closing) } else { None };
        Ok(Self {
            scene,
            n,
            thrown,
            rolling,
            slipping,
            normal,
            needed,
            available,
            holds,
            v0,
            w0,
            rim,
            slip0,
            sense,
            closing,
            until,
        })
    }

    /// The time that is asked.
    fn time(&self) -> Option<T> {
        if let End::Time(_, t) = self.scene.end { Some(self.n.get(t)) } else { None }
    }

    /// What moves it up to its end, `None` where it does not get there.
    fn legs(&self) -> Option<Legs<T>> {
        let until = self.until.filter(|_| self.holds);
        Some(match (self.slipping, self.time()) {
            (None, time) => smallvec![(self.rolling, time.unwrap_or_else(T::zero))],
            (Some(slipping), None) => smallvec![(slipping, until?)],
            (Some(slipping), Some(t)) if self.until.is_some_and(|until| until.below(t)) => {
                smallvec![(slipping, until?), (self.rolling, t - until?)]
            }
            (Some(slipping), Some(t)) => smallvec![(slipping, t)],
        })
    }

    /// The state at the end by steps in time of `(x, phi, v, omega)`, and what they cost: one of them ends where the slip is 0, and the
    /// time of slipping becomes theirs.
    fn stepped(&self, legs: &mut Legs<T>, rung: Rung) -> Result<(State<T>, Count), Refusal> {
        let c = self.n.get(self.thrown.radius_m).f64();
        let (v0, w0) = (self.v0.f64(), self.w0.f64());
        let rates = |phase: &Phase<T>| [phase.a.f64(), phase.alpha.f64()];
        let phase = Cell::new(rates(&legs[0].0));
        let field = |_: f64, y: &[f64; 4]| [y[2], y[3], phase.get()[0], phase.get()[1]];
        let total = legs.iter().map(|leg| leg.1).reduce(|sum, time| sum + time).map_or(0.0, T::f64);
        let stop = self.time().map(|_| total);
        let speeds = v0.abs() + (c * w0).abs();
        let closing = (phase.get()[0] - c * phase.get()[1]).abs();
        let pace = (speeds / closing).min(stop.unwrap_or(f64::INFINITY));
        let first = if pace.is_finite() && pace > 0.0 { 0.05 * pace } else { 1.0 };
        let formula = rung.method().formula().unwrap_or(Formula::Dop853);
        let mut run = Run::new(formula, field, 0.0, [0.0, 0.0, v0, w0], rung.pace(first));
        let trouble = |trouble| Refusal::Trouble { method: rung.method(), trouble };
        if self.slipping.is_some() && (legs.len() > 1 || stop.is_none()) {
            let slip = |_: f64, y: &[f64; 4]| -self.sense * (y[2] - c * y[3]);
            run.until(&slip, speeds, &|_, _| -1.0).map_err(trouble)?;
            legs[0].1 = T::of(run.x());
            phase.set(rates(&self.rolling));
            run.refresh();
        }
        if let Some(stop) = stop {
            run.to(stop).map_err(trouble)?;
        }
        let [x, phi, v, w] = run.y().map(T::of);
        Ok((State { t: T::of(run.x()), v, w, x, phi }, run.count()))
    }

    /// Slip, forces and accelerations, with the phase at the end.
    fn tell_forces(&self, now: &Phase<T>, say: Says<T>) {
        let own = Owner::Body(self.thrown.body);
        let forward_up = self.scene.bodies[self.thrown.body].line.is_none_or(|l| l.forward_up);
        let up = if forward_up { 1.0 } else { -1.0 };
        let numbers = &self.n.bodies[self.thrown.body];
        let mass = numbers.mass.size();
        let with = numbers.carried.map(|[forward, _]| {
            plant!("eom: acceleration of the carrier of a thrown body", forward.acceleration)
        });
        let seen = |a: T| with.map_or(a, |with| a.balance(with));
        let weight = (numbers.mass * self.n.gravity * numbers.climb).size()
            + with.map_or(0.0, |with| (numbers.mass * with).size());
        let forces = |p: &Phase<T>| p.friction.size() + weight + (numbers.mass * p.a).size();
        let (rolling, normal) = (&self.rolling, self.normal);
        say(Quantity::SlipSpeed, own, self.slip0.abs(), self.v0.size() + self.rim.size());
        say(Quantity::FrictionIfRolled, own, rolling.friction.signed(up), forces(rolling));
        say(Quantity::MuRequired, own, self.needed / normal, (self.needed / normal).size());
        say(Quantity::Normal, own, normal, normal.size());
        if self.holds {
            say(Quantity::ARolling, own, seen(rolling.a), forces(rolling) / mass);
        }
        say(Quantity::A, own, seen(now.a), forces(now) / mass);
        say(Quantity::Alpha, own, now.alpha, now.alpha.size());
        say(Quantity::Friction, own, now.friction.signed(up), forces(now));
    }

    /// Places, velocities and energy at the end.
    fn tell_end(&self, state: &State<T>, say: Says<T>) {
        let (own, zero) = (Owner::Body(self.thrown.body), T::zero());
        let numbers = &self.n.bodies[self.thrown.body];
        let forward = numbers.carried.map(|[forward, _]| forward);
        say(Quantity::T, Owner::Scene, state.t, state.t.size());
        let v = forward.map_or(state.v, |f| {
            state.v.balance(plant!("eom: speed of the carrier of a thrown body", f.after(state.t)))
        });
        let carried = forward.map_or(zero, |f| f.way(state.t));
        let aside = numbers.carried.map_or(zero, |[_, out]| out.after(state.t));
        say(Quantity::V, own, speed(v, aside), state.v.size() + (v - state.v).size() + aside.size());
        say(Quantity::Omega, own, state.w.abs(), state.w.size());
        let way = (self.v0.size() + state.v.size()) * state.t.size();
        let moved = forward.map_or(state.x, |_| state.x.balance(carried));
        say(Quantity::Displacement, own, moved, way + carried.size());
        say(Quantity::Rise, own, state.x * numbers.climb, way * numbers.climb.size());
        say(Quantity::Phi, own, state.phi.abs(), state.phi.size());
        let moving = numbers.mass * (v.square() + aside.square());
        let turning = numbers.inertia * state.w.square();
        let energy = (moving + plant!("eom: energy of a turning body", turning)).scale2(-1);
        say(Quantity::KineticEnergy, Owner::Scene, energy, energy.size());
        if !energy.is_zero() {
            say(Quantity::RotationalFraction, Owner::Scene, turning / (moving + turning), 1.0);
        }
    }

    /// Path, impulse and momentum, work, and what the contact slips.
    fn tell_way(&self, (start, legs, state): (State<T>, &Legs<T>, &State<T>), say: Says<T>) {
        let (own, zero) = (Owner::Body(self.thrown.body), T::zero());
        let numbers = &self.n.bodies[self.thrown.body];
        let mass = numbers.mass;
        let (mut gone, mut impulse, mut from) = (zero, zero, start);
        for (phase, time) in legs {
            let to = from.after(phase, *time);
            gone = gone + path(&from, &to);
            impulse = impulse.balance(mass * phase.a * (to.t - from.t));
            from = to;
        }
        say(Quantity::Distance, own, plant!("eom: path of the centre", gone), gone.size());
        // A difference of two momenta.
        let momentum = (mass * self.v0).size() + impulse.size();
        say(Quantity::Impulse, own, plant!("eom: impulse on a thrown body", impulse), momentum);
        let spin = plant!("eom: angular momentum of a thrown body", numbers.inertia) * state.w.abs();
        say(Quantity::AngularMomentum, own, spin, spin.size());
        if let Some(moment) = couple_on(self.scene, self.n, self.thrown.body) {
            say(Quantity::WorkCouple, own, moment * state.phi, (moment * state.phi).size());
            say(Quantity::PowerCouple, own, moment * state.w, (moment * state.w).size());
        }
        // The slip changes evenly: its mean times its time. At the event nothing is left of it.
        let (slides, slip0) = (if self.slipping.is_some() { legs[0].1 } else { zero }, self.slip0.abs());
        let left = match self.until {
            Some(until) if !slides.below(until) => zero,
            _ => slip0.balance(-(self.closing * slides)),
        };
        let slid = plant!("eom: way of the slipping contact", (slip0 + left) * slides).scale2(-1);
        say(Quantity::SlipDistance, own, slid, slid.size());
        let kinetic = self.slipping.map_or(zero, |p| p.friction.abs());
        say(Quantity::Heat, Owner::Scene, kinetic * slid, (kinetic * slid).size());
    }

    /// What becomes of the slip, with the state at the end if that is reached.
    fn throw(&self, end: Option<&State<T>>) -> Throw {
        let force = |f: T| self.n.publish(Quantity::Friction, f).f64();
        let until = self.until;
        Throw {
            tie: self.thrown.tie,
            slips: !self.slip0.is_zero(),
            closes: until.is_some(),
            holds: self.holds,
            to_roll: match (self.time(), until) {
                (Some(t), Some(until)) => until.below(t),
                (Some(_), None) => self.slipping.is_none(),
                (None, _) => true,
            },
            times: self.time().map(|t| (t.f64(), until.map_or(f64::INFINITY, T::f64))),
            at_end: end.map(|s| (s.v.size(), self.v0.size() + (s.v - self.v0).size())),
            slip: self.slip0.size(),
            speeds: self.v0.size() + self.rim.size(),
            upkeep: force(self.rolling.friction.signed(-self.sense)),
            kinetic: force(self.n.get(self.thrown.mu_k) * self.normal),
            needed: force(self.needed),
            available: force(self.available),
        }
    }
}
