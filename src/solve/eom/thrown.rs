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
use crate::num::ode::{Count, Formula, Run, Trouble};
use crate::num::plant::plant;
use crate::scene::{Coordinate, Degree, End, Label, Numbers, Owner, Quantity, Scene, Thrown, speed};
use crate::solve::eom::equations::{CONSTANT, Response, Setting, respond};
use crate::solve::eom::{STEPS, couple_on};
use crate::solve::method::Rung;
use crate::solve::outcome::{Course, Grip, Held, Refusal, Road, Said, Scope, Throw};
use smallvec::{SmallVec, smallvec};
use std::cell::Cell;

/// A phase with the states at which it begins and ends.
type Leg<T> = (Phase<T>, State<T>, State<T>);

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
    let body = thrown.body;
    let phase = |grip: Grip, sense: f64| -> Result<(Phase<T>, Response<T>), Refusal> {
        let mut friction_sense = smallvec![0.0; scene.ties.len()];
        friction_sense[thrown.tie] = sense;
        let stays = smallvec![false; scene.ties.len()];
        let response =
            respond(scene, n, &Setting { grip, stays, friction_sense, starting: false, probe: None })?;
        let of = |degree| response.acceleration(Coordinate { body, degree }, CONSTANT);
        let friction = response.reaction(thrown.tie, CONSTANT);
        Ok((Phase { a: of(Degree::Along), alpha: of(Degree::Turn), friction }, response))
    };
    let (rolling, response) = phase(Grip::AllRoll, 0.0)?;
    let normal = response.normal(body);
    let (needed, available) = (rolling.friction.abs(), n.get(thrown.mu_s) * normal);
    let holds = needed.at_most(available);
    let c = n.get(thrown.radius_m);
    let along = Coordinate { body, degree: Degree::Along };
    let (v0, w0) = (n.start(along, thrown.speed_m_s), n.get(thrown.spin_rad_s));
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

    // Which phase the end falls into, and how long each of them lasts.
    let zero = T::zero();
    let ended = match scene.end {
        End::Time(_, t) => {
            let t = n.get(t);
            match (slipping, until) {
                (None, _) => Some((zero, Some(t))),
                (Some(_), Some(until)) if until.below(t) => holds.then(|| (until, Some(t - until))),
                (Some(_), _) => Some((t, None)),
            }
        }
        _ if slipping.is_none() => Some((zero, Some(zero))),
        _ => until.filter(|_| holds).map(|until| (until, None)),
    };
    let to_roll = match (scene.end, until) {
        (End::Time(_, t), Some(until)) => until.below(n.get(t)),
        (End::Time(..), None) => slipping.is_none(),
        _ => true,
    };
    let start = State { t: zero, v: v0, w: w0, x: zero, phi: zero };
    let mut count = Count::default();
    let (mut ended, mut state) = (ended, None);
    if let (Some((slides, rolls)), Some(rung)) = (ended, by.filter(|_| STEPS)) {
        let spread = match (scene.end, rolls) {
            (End::Rolling(_), _) | (_, Some(_)) => slipping.map(|_| sense),
            _ => None,
        };
        let total = rolls.map_or(slides, |time| slides + time).f64();
        let stop = matches!(scene.end, End::Time(..)).then_some(total);
        let f64s = |p: &Phase<T>| (p.a.f64(), p.alpha.f64());
        let legs = (f64s(&slipping.unwrap_or(rolling)), f64s(&rolling));
        let run = stepped(c.f64(), (v0.f64(), w0.f64()), legs, (spread, stop), rung)
            .map_err(|trouble| Refusal::Trouble { method: rung.method(), trouble })?;
        let [x, phi, v, w] = run.end.map(T::of);
        state = Some(State { t: T::of(run.time), v, w, x, phi });
        // Without slip there is no leg of slipping; without an event the whole time slips.
        let slid = run.switch.map_or(slides, T::of);
        ended = Some((slid, rolls));
        count = run.count;
    }
    let state = state.or_else(|| {
        ended.map(|(slides, rolls)| {
            let slid = slipping.map_or(start, |p| start.after(&p, slides));
            rolls.map_or(slid, |time| slid.after(&rolling, time))
        })
    });
    // The legs of the way: what accelerates it, and the states between which it does.
    let mut legs: SmallVec<[Leg<T>; 2]> = SmallVec::new();
    if let Some((slides, rolls)) = ended {
        legs.extend(slipping.map(|p| (p, start, start.after(&p, slides))));
        let between = legs.last().map_or(start, |leg| leg.2);
        legs.extend(rolls.map(|time| (rolling, between, between.after(&rolling, time))));
    }
    let now = match (ended, slipping) {
        (Some((_, Some(_))), _) | (_, None) => rolling,
        (_, Some(p)) => p,
    };

    let mut road = Road::new(asked);
    let mut say = |quantity, of, value: T, scale: f64| {
        if asked.quantities.has(quantity) {
            road.said.push(Said::of(n, Label { quantity, of }, value, scale));
        }
    };
    let own = Owner::Body(body);
    let up = if scene.bodies[body].line.is_none_or(|l| l.forward_up) { 1.0 } else { -1.0 };
    let size = |x: T| x.f64().abs();
    let numbers = &n.bodies[body];
    let weight = size(numbers.mass * n.gravity * numbers.climb);
    let forward = numbers.carried.map(|[forward, _]| forward);
    let with =
        forward.map_or(zero, |f| plant!("eom: acceleration of the carrier of a thrown body", f.acceleration));
    let seen = |a: T| forward.map_or(a, |_| a.balance(with));
    let weight = weight + size(numbers.mass * with);
    let forces = |p: &Phase<T>| size(p.friction) + weight + size(numbers.mass * p.a);
    say(Quantity::SlipSpeed, own, slip0.abs(), size(v0) + size(rim));
    say(Quantity::FrictionIfRolled, own, rolling.friction.signed(up), forces(&rolling));
    say(Quantity::MuRequired, own, needed / normal, size(needed / normal));
    say(Quantity::Normal, own, normal, size(normal));
    if holds {
        say(Quantity::ARolling, own, seen(rolling.a), forces(&rolling) / size(numbers.mass));
    }
    say(Quantity::A, own, seen(now.a), forces(&now) / size(numbers.mass));
    say(Quantity::Alpha, own, now.alpha, size(now.alpha));
    say(Quantity::Friction, own, now.friction.signed(up), forces(&now));
    if let (Some(state), Some((slides, _))) = (&state, ended) {
        say(Quantity::T, Owner::Scene, state.t, size(state.t));
        let v = forward.map_or(state.v, |f| {
            state.v.balance(plant!("eom: speed of the carrier of a thrown body", f.after(state.t)))
        });
        let carried = forward.map_or(zero, |f| f.way(state.t));
        let aside = numbers.carried.map_or(zero, |[_, out]| out.after(state.t));
        say(Quantity::V, own, speed(v, aside), size(state.v) + size(v - state.v) + size(aside));
        say(Quantity::Omega, own, state.w.abs(), size(state.w));
        let way = (size(v0) + size(state.v)) * size(state.t);
        let moved = forward.map_or(state.x, |_| state.x.balance(carried));
        say(Quantity::Displacement, own, moved, way + size(carried));
        say(Quantity::Rise, own, state.x * numbers.climb, way * size(numbers.climb));
        say(Quantity::Phi, own, state.phi.abs(), size(state.phi));
        let moving = numbers.mass * (v.square() + aside.square());
        let turning = numbers.inertia * state.w.square();
        let energy = (moving + plant!("eom: energy of a turning body", turning)).scale2(-1);
        say(Quantity::KineticEnergy, Owner::Scene, energy, size(energy));
        if !energy.is_zero() {
            say(Quantity::RotationalFraction, Owner::Scene, turning / (moving + turning), 1.0);
        }
        let over = |leg: &(Phase<T>, State<T>, State<T>)| {
            let (phase, from, to) = leg;
            (path(from, to), numbers.mass * phase.a * (to.t - from.t))
        };
        let (mut gone, mut impulse) = (zero, zero);
        for (way, push) in legs.iter().map(over) {
            gone = gone + way;
            impulse = impulse.balance(push);
        }
        say(Quantity::Distance, own, plant!("eom: path of the centre", gone), size(gone));
        // A difference of two momenta.
        let momentum = size(numbers.mass * v0) + size(impulse);
        say(Quantity::Impulse, own, plant!("eom: impulse on a thrown body", impulse), momentum);
        let spin = plant!("eom: angular momentum of a thrown body", numbers.inertia) * state.w.abs();
        say(Quantity::AngularMomentum, own, spin, size(spin));
        if let Some(moment) = couple_on(scene, n, body) {
            say(Quantity::WorkCouple, own, moment * state.phi, size(moment * state.phi));
            say(Quantity::PowerCouple, own, moment * state.w, size(moment * state.w));
        }
        // The slip changes evenly: its mean times its time. At the event nothing is left of it.
        let left = match until {
            Some(until) if !slides.below(until) => zero,
            _ => slip0.abs().balance(-(closing * slides)),
        };
        let slid = plant!("eom: way of the slipping contact", (slip0.abs() + left) * slides).scale2(-1);
        say(Quantity::SlipDistance, own, slid, size(slid));
        let kinetic = slipping.map_or(zero, |p| p.friction.abs());
        say(Quantity::Heat, Owner::Scene, kinetic * slid, size(kinetic * slid));
    }
    if let Some(state) = &state {
        let turn = Coordinate { body, degree: Degree::Turn };
        road.velocities = vec![(along, state.v), (turn, state.w)];
    }
    let force = |f: T| n.publish(Quantity::Friction, f).f64();
    road.held.push(Held::Pressed(body, force(normal)));
    road.held.push(Held::Thrown(Throw {
        tie: thrown.tie,
        slips: !slip0.is_zero(),
        closes,
        holds,
        to_roll,
        times: match scene.end {
            End::Time(_, t) => Some((n.get(t).f64(), until.map_or(f64::INFINITY, T::f64))),
            _ => None,
        },
        at_end: state.as_ref().map(|s| (size(s.v), size(v0) + size(s.v - v0))),
        slip: size(slip0),
        speeds: size(v0) + size(rim),
        upkeep: force(rolling.friction.signed(-sense)),
        kinetic: force(n.get(thrown.mu_k) * normal),
        needed: force(needed),
        available: force(available),
    }));
    let course = Course::moving(state.map_or(v0, |s| s.v).sign(), state.is_some());
    road.course = Some(Course {
        asked: match scene.end {
            End::Time(_, t) => Some(n.get(t)),
            _ => None,
        },
        farthest: until.filter(|_| !holds).unwrap_or(course.farthest),
        ..course
    });
    Ok((road, count))
}

/// What steps give: places and speeds at the end, its time, the time at which the slip ended.
struct Stepped {
    end: [f64; 4],
    time: f64,
    switch: Option<f64>,
    count: Count,
}

/// Centre and turn step by step, `(x, phi, v, omega)`: with the accelerations of the first leg until the slip `v - c omega`, of
/// the given sense at the start, is 0 (a step ends there), then with those of the second until the given time.
fn stepped(
    c: f64,
    (v0, w0): (f64, f64),
    (slipping, rolling): ((f64, f64), (f64, f64)),
    (sense, stop): (Option<f64>, Option<f64>),
    rung: Rung,
) -> Result<Stepped, Trouble> {
    let leg = Cell::new(slipping);
    let field = |_: f64, y: &[f64; 4]| [y[2], y[3], leg.get().0, leg.get().1];
    let speeds = v0.abs() + (c * w0).abs();
    let closing = (slipping.0 - c * slipping.1).abs();
    let pace = [speeds / closing, stop.unwrap_or(f64::INFINITY)].into_iter().fold(f64::INFINITY, f64::min);
    let first = if pace.is_finite() && pace > 0.0 { 0.05 * pace } else { 1.0 };
    let formula = rung.method().formula().unwrap_or(Formula::Dop853);
    let mut run = Run::new(formula, field, 0.0, [0.0, 0.0, v0, w0], rung.pace(first));
    let mut switch = None;
    if let Some(sense) = sense {
        let slip = |_: f64, y: &[f64; 4]| -sense * (y[2] - c * y[3]);
        run.until(&slip, speeds, &|_, _| -1.0)?;
        switch = Some(run.x());
        leg.set(rolling);
        run.refresh();
    }
    if let Some(stop) = stop {
        run.to(stop)?;
    }
    Ok(Stepped { end: run.y(), time: run.x(), switch, count: run.count() })
}
