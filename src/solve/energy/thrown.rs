//! A body thrown with slip, by energies and impulses of its two modes: rolling, and slipping.
//!
//! In the mode of rolling the contact is at rest, so sliding friction has no power in it; the mode of slipping is the motion
//! that has no kinetic energy in common with it. The energy of the body is the sum of theirs,
//!
//! ```text
//! T = 1/2 M_r u^2 + 1/2 M_s s^2        u: rate of rolling, s: velocity of the contact
//! M_r u' = Q_r                         impulse of the given forces alone: on a level u never changes
//! 1/2 M_s s0^2 = (mu_k N - Q_s) l      work until the contact is at rest, l its way over the surface
//! ```
//! so that the way comes first, then the time (twice the way over the slip at the start), then the speeds. The friction that
//! rolling needs is what keeps the slip at rest, `-Q_s`.
use crate::num::Real;
use crate::num::plant::plant;
use crate::scene::{Carried, Coordinate, Degree, End, Label, Numbers, Owner, Quantity, Scene, Thrown, speed};
use crate::solve::energy::balance::PerTie;
use crate::solve::energy::speeds::Mode;
use crate::solve::energy::{balance, speeds};
use crate::solve::outcome::{Course, Grip, Refusal, Road, Said, Scope};
use smallvec::smallvec;

/// A mode with its inertia (`M`, twice its kinetic energy at unit rate) and the power of the given forces at unit rate.
struct Weighed<T> {
    v: T,
    w: T,
    inertia: T,
    power: T,
}

impl<T: Real> Weighed<T> {
    fn new(scene: &Scene, n: &Numbers<T>, mode: &Mode<T>, body: usize) -> Self {
        let none: PerTie<T> = smallvec![T::zero(); scene.ties.len()];
        let (mut power, mut size) = (T::zero(), 0.0);
        for p in balance::powers(scene, n, mode, &none) {
            power = power + p.power;
            size += p.power.size();
        }
        Self {
            v: mode.v[body],
            w: mode.w[body],
            inertia: balance::inertia(n, mode, mode),
            power: power.cleared(size),
        }
    }
}

/// Rates of both modes, and the ways that centre and turn have made so far.
#[derive(Clone, Copy)]
struct State<T> {
    t: T,
    v: T,
    w: T,
    x: T,
    phi: T,
    roll: T,
    slip: T,
}

/// Path of the centre between two states of one phase, at the mean speed of each stretch in one sense.
fn path<T: Real>(from: &State<T>, to: &State<T>) -> T {
    let (before, after, time) = (from.v.abs(), to.v.abs(), to.t - from.t);
    if from.v.sign() * to.v.sign() < 0.0 {
        let there = time * (before / (before + after));
        (before * there + after * (time - there)).scale2(-1)
    } else {
        ((before + after) * time).scale2(-1)
    }
}

/// Everything that work and energy say of a thrown body whose data are admissible.
///
/// Errors: none of its own.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>, thrown: &Thrown) -> Result<Road<T>, Refusal> {
    let body = thrown.body;
    let numbers = n.bodies[body];
    let c = n.get(thrown.radius_m);
    let modes = speeds::modes(scene, n, Grip::AllRoll, &[]);
    let rolling = &modes[0];
    // No kinetic energy in common: m v v' + I w w' = 0; at unit velocity of the contact.
    let (across, turning) = (numbers.inertia * rolling.w[body], numbers.mass * rolling.v[body]);
    let contact = across + plant!("energy: contact of a thrown body", c) * turning;
    let mut slipping = Mode::still(scene.bodies.len());
    slipping.v[body] = plant!("energy: centre in the mode of slipping", across / contact);
    slipping.w[body] = -plant!("energy: turn in the mode of slipping", turning / contact);
    let roll = Weighed::new(scene, n, rolling, body);
    let slip = Weighed::new(scene, n, &slipping, body);

    let along = Coordinate { body, degree: Degree::Along };
    let (v0, w0) = (n.start(along, thrown.speed_m_s), n.get(thrown.spin_rad_s));
    let momentum = plant!("energy: momentum of the centre", numbers.mass * v0 * roll.v)
        .balance(plant!("energy: momentum of the turn", numbers.inertia * w0 * roll.w));
    let u0 = momentum / roll.inertia;
    let slip0 = v0.apart(c * w0);
    let normal = balance::normal(scene, n, body);
    let kinetic = plant!("energy: kinetic friction on a thrown body", n.get(thrown.mu_k)) * normal;
    let needed = -slip.power;
    let available = n.get(thrown.mu_s) * normal;
    let holds = needed.abs().at_most(available);
    let sense = match (slip0.is_zero(), holds) {
        (false, _) => slip0.sign(),
        (true, true) => 0.0,
        (true, false) => slip.power.sign(),
    };
    // Loss of the slip's energy per metre of its way.
    let loss = kinetic.balance(-slip.power.signed(sense));
    let closes = !slip0.is_zero() && loss.sign() > 0.0;
    let way = (slip.inertia * slip0.square()).scale2(-1) / loss;
    let until = if closes { Some(way.scale2(1) / slip0.abs()) } else { None };

    let zero = T::zero();
    let at_rest = sense == 0.0;
    let rate = |friction: T| (slip.power + friction) / slip.inertia;
    let slips_at = if at_rest { zero } else { -(loss / slip.inertia).signed(sense) };
    let gained = roll.power / roll.inertia;
    // Velocities change evenly within a phase: the ways are mean velocities times time.
    let advance = |from: State<T>, time: T, lost: Option<T>| {
        let impulse = plant!("energy: impulse in rolling", gained * time);
        let u = from.roll.balance(impulse);
        let (v, w) = match lost {
            // Only what is lost counts: beside a large slip the velocity of the centre may be next to nothing.
            Some(lost) => (
                from.v.balance((roll.v * impulse).balance(slip.v * lost)),
                from.w.balance((roll.w * impulse).balance(slip.w * lost)),
            ),
            // The contact is at rest: all that is left is rolling.
            None => (roll.v * u, roll.w * u),
        };
        let slip_after = lost.map_or(zero, |lost| from.slip.balance(lost));
        let way = |a: T, b: T| plant!("energy: way at the mean velocity", (a.balance(b) * time).scale2(-1));
        State {
            t: from.t + time,
            v,
            w,
            x: from.x.balance(way(from.v, v)),
            phi: from.phi.balance(way(from.w, w)),
            roll: u,
            slip: slip_after,
        }
    };
    let start = State { t: zero, v: v0, w: w0, x: zero, phi: zero, roll: u0, slip: slip0 };
    let slide = |time: T| advance(start, time, Some(slips_at * time));
    let event = until.filter(|_| holds).map(|until| advance(start, until, None));
    // The state at the end, how far the contact has slipped by then, and whether it rolls.
    let ended: Option<(State<T>, T, bool)> = match (scene.end, until) {
        (End::Time(_, t), _) if at_rest => Some((advance(start, n.get(t), None), zero, true)),
        (_, _) if at_rest => Some((start, zero, true)),
        (End::Time(_, t), until) => {
            let t = n.get(t);
            match until {
                Some(until) if until.below(t) => event.map(|e| (advance(e, t - until, None), way, true)),
                _ => {
                    let state = slide(t);
                    let slid = ((slip0 + state.slip) * t).abs().scale2(-1);
                    Some((state, slid, false))
                }
            }
        }
        _ => event.map(|e| (e, way, false)),
    };
    let rolls = ended.as_ref().is_some_and(|(_, _, rolls)| *rolls) || at_rest;

    let mut road = Road::new(Scope::ALL);
    let mut say = |quantity, of, value: T| {
        road.said.push(Said::of(n, Label { quantity, of }, value, value.size()));
    };
    let own = Owner::Body(body);
    let up = if scene.bodies[body].line.is_some_and(|l| !l.forward_up) { -1.0 } else { 1.0 };
    let forward = numbers.carried.map(|[forward, _]| forward);
    let with = |f: Carried<T>| plant!("energy: rate of the carrier of a thrown body", f.acceleration);
    let seen = |a: T| forward.map_or(a, |f| a.balance(with(f)));
    say(Quantity::SlipSpeed, own, slip0.abs());
    say(Quantity::FrictionIfRolled, own, needed.signed(up));
    say(Quantity::MuRequired, own, needed.abs() / normal);
    say(Quantity::Normal, own, normal);
    if holds {
        say(Quantity::ARolling, own, seen(roll.v * gained));
    }
    let friction = if rolls { needed } else { kinetic.signed(-sense) };
    // The power of each mode, friction's among them in that of slipping, is the rate of its energy.
    let own_rate = if rolls { zero } else { rate(friction) };
    say(Quantity::A, own, seen((roll.v * gained).balance(slip.v * own_rate)));
    say(Quantity::Alpha, own, (roll.w * gained).balance(slip.w * own_rate));
    say(Quantity::Friction, own, friction.signed(up));
    if let Some((state, slid, rolled)) = &ended {
        say(Quantity::T, Owner::Scene, state.t);
        let seen = numbers.carried.map_or([state.v, zero], |[forward, out]| {
            let with = plant!("energy: speed of the carrier of a thrown body", forward.after(state.t));
            let aside = out.after(state.t);
            [state.v.balance(with), aside]
        });
        say(Quantity::V, own, speed(seen[0], seen[1]));
        say(Quantity::Omega, own, state.w.abs());
        say(Quantity::Displacement, own, forward.map_or(state.x, |f| state.x.balance(f.way(state.t))));
        say(Quantity::Rise, own, state.x * numbers.climb);
        say(Quantity::Phi, own, state.phi.abs());
        let mut energy = (roll.inertia * state.roll.square() + slip.inertia * state.slip.square()).scale2(-1);
        if let Some(carried) = numbers.carried {
            // What both motions have in common, and the energy of being carried.
            let [forward, out] = carried.map(|c| c.after(state.t));
            energy = energy.balance(numbers.mass * forward * state.v);
            energy = energy.balance((numbers.mass * (forward.square() + out.square())).scale2(-1));
        }
        say(Quantity::KineticEnergy, Owner::Scene, energy);
        if !energy.is_zero() {
            let spinning = (numbers.inertia * state.w.square()).scale2(-1);
            say(Quantity::RotationalFraction, Owner::Scene, spinning / energy);
        }
        let momentum = plant!("energy: gain of momentum", state.v.balance(-v0)) * numbers.mass;
        say(Quantity::Impulse, own, momentum);
        let spin = plant!("energy: angular momentum of a thrown body", state.w.abs()) * numbers.inertia;
        say(Quantity::AngularMomentum, own, spin);
        // Rolled on after the slip, or a single phase.
        let after = event.filter(|_| *rolled && !at_rest && matches!(scene.end, End::Time(..)));
        let path = after.map_or_else(|| path(&start, state), |e| path(&start, &e) + path(&e, state));
        say(Quantity::Distance, own, plant!("energy: path of the centre", path));
        // Of each couple, over the turn in its own sense.
        let couples = scene.couples.iter().filter(|c| c.body == body).map(|c| {
            let moment = n.massive(c.moment_n_m);
            if c.forward { moment } else { -moment }
        });
        if let Some(moment) = couples.reduce(T::balance) {
            say(Quantity::WorkCouple, own, moment * state.phi);
            say(Quantity::PowerCouple, own, moment * state.w);
        }
        say(Quantity::SlipDistance, own, *slid);
        say(Quantity::Heat, Owner::Scene, kinetic * *slid);
    }
    if let Some((state, ..)) = &ended {
        let turn = Coordinate { body, degree: Degree::Turn };
        road.velocities = vec![(along, state.v), (turn, state.w)];
    }
    road.course = Some(Course::moving(ended.as_ref().map_or(v0, |(s, ..)| s.v).sign(), ended.is_some()));
    Ok(road)
}
