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

/// A thrown body at its start, in its two modes.
struct Contact<'s, 'a, T: Real> {
    scene: &'s Scene,
    n: &'s Numbers<'a, T>,
    body: usize,
    roll: Weighed<T>,
    slip: Weighed<T>,
    start: State<T>,
    normal: T,
    /// Kinetic friction, and the friction that rolling needs.
    kinetic: T,
    needed: T,
    holds: bool,
    /// Sense of the slip; 0 where the contact is at rest.
    sense: f64,
    /// Loss of the slip's energy per metre of its way.
    loss: T,
    /// Way and time until the contact is at rest.
    way: T,
    until: Option<T>,
}

/// The state at the end, that at the start of rolling where it comes before, how far the contact has slipped, and whether it rolls.
type Ended<T> = (State<T>, Option<State<T>>, T, bool);

/// Everything that work and energy say of a thrown body whose data are admissible.
///
/// Errors: none of its own.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>, thrown: &Thrown) -> Result<Road<T>, Refusal> {
    let contact = Contact::new(scene, n, thrown);
    let ended = contact.ended();
    let mut road = Road::new(Scope::ALL);
    let mut say = |quantity, of, value: T| {
        road.said.push(Said::of(n, Label { quantity, of }, value, value.size()));
    };
    let rolls = ended.as_ref().is_some_and(|(.., rolls)| *rolls) || contact.sense == 0.0;
    contact.tell_forces(rolls, &mut say);
    if let Some(ended) = &ended {
        contact.tell_end(ended, &mut say);
        let coordinate = |degree| Coordinate { body: thrown.body, degree };
        road.velocities = vec![(coordinate(Degree::Along), ended.0.v), (coordinate(Degree::Turn), ended.0.w)];
    }
    let v = ended.as_ref().map_or(contact.start.v, |(state, ..)| state.v);
    road.course = Some(Course::moving(v.sign(), ended.is_some()));
    Ok(road)
}

impl<'s, 'a, T: Real> Contact<'s, 'a, T> {
    fn new(scene: &'s Scene, n: &'s Numbers<'a, T>, thrown: &Thrown) -> Self {
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
        let (v, w) = (n.start(along, thrown.speed_m_s), n.get(thrown.spin_rad_s));
        let momentum = plant!("energy: momentum of the centre", numbers.mass * v * roll.v)
            .balance(plant!("energy: momentum of the turn", numbers.inertia * w * roll.w));
        let zero = T::zero();
        let slip0 = v.apart(c * w);
        let start = State { t: zero, v, w, x: zero, phi: zero, roll: momentum / roll.inertia, slip: slip0 };
        let normal = balance::normal(scene, n, body);
        let kinetic = plant!("energy: kinetic friction on a thrown body", n.get(thrown.mu_k)) * normal;
        let needed = -slip.power;
        let holds = needed.abs().at_most(n.get(thrown.mu_s) * normal);
        let sense = match (slip0.is_zero(), holds) {
            (false, _) => slip0.sign(),
            (true, true) => 0.0,
            (true, false) => slip.power.sign(),
        };
        let loss = kinetic.balance(-slip.power.signed(sense));
        let closes = !slip0.is_zero() && loss.sign() > 0.0;
        let way = (slip.inertia * slip0.square()).scale2(-1) / loss;
        let until = if closes { Some(way.scale2(1) / slip0.abs()) } else { None };
        Self { scene, n, body, roll, slip, start, normal, kinetic, needed, holds, sense, loss, way, until }
    }

    /// The state after a time in which the slip changes by `lost`; without it the contact is then at rest. Velocities change evenly
    /// within a phase: the ways are mean velocities times time.
    fn advance(&self, from: &State<T>, time: T, lost: Option<T>) -> State<T> {
        let (roll, slip) = (&self.roll, &self.slip);
        let impulse = plant!("energy: impulse in rolling", roll.power / roll.inertia * time);
        let u = from.roll.balance(impulse);
        let (v, w) = match lost {
            // Only what is lost counts: beside a large slip the velocity of the centre may be next to nothing.
            Some(lost) => (
                from.v.balance((roll.v * impulse).balance(slip.v * lost)),
                from.w.balance((roll.w * impulse).balance(slip.w * lost)),
            ),
            // All that is left is rolling.
            None => (roll.v * u, roll.w * u),
        };
        let way = |a: T, b: T| plant!("energy: way at the mean velocity", (a.balance(b) * time).scale2(-1));
        State {
            t: from.t + time,
            v,
            w,
            x: from.x.balance(way(from.v, v)),
            phi: from.phi.balance(way(from.w, w)),
            roll: u,
            slip: lost.map_or_else(T::zero, |lost| from.slip.balance(lost)),
        }
    }

    fn ended(&self) -> Option<Ended<T>> {
        let (start, zero) = (&self.start, T::zero());
        let time = if let End::Time(_, t) = self.scene.end { Some(self.n.get(t)) } else { None };
        if self.sense == 0.0 {
            return Some((time.map_or(*start, |t| self.advance(start, t, None)), None, zero, true));
        }
        let event = self.until.filter(|_| self.holds).map(|until| self.advance(start, until, None));
        match (time, self.until) {
            (Some(t), Some(until)) if until.below(t) => {
                event.map(|e| (self.advance(&e, t - until, None), Some(e), self.way, true))
            }
            (Some(t), _) => {
                let rate = -(self.loss / self.slip.inertia).signed(self.sense);
                let state = self.advance(start, t, Some(rate * t));
                let slid = ((start.slip + state.slip) * t).abs().scale2(-1);
                Some((state, None, slid, false))
            }
            (None, _) => event.map(|e| (e, None, self.way, false)),
        }
    }

    /// Slip, forces and accelerations.
    fn tell_forces(&self, rolls: bool, say: &mut dyn FnMut(Quantity, Owner, T)) {
        let own = Owner::Body(self.body);
        let (roll, slip) = (&self.roll, &self.slip);
        let up = if self.scene.bodies[self.body].line.is_some_and(|l| !l.forward_up) { -1.0 } else { 1.0 };
        let forward = self.n.bodies[self.body].carried.map(|[forward, _]| forward);
        let with = |f: Carried<T>| plant!("energy: rate of the carrier of a thrown body", f.acceleration);
        let seen = |a: T| forward.map_or(a, |f| a.balance(with(f)));
        say(Quantity::SlipSpeed, own, self.start.slip.abs());
        say(Quantity::FrictionIfRolled, own, self.needed.signed(up));
        say(Quantity::MuRequired, own, self.needed.abs() / self.normal);
        say(Quantity::Normal, own, self.normal);
        let gained = roll.power / roll.inertia;
        if self.holds {
            say(Quantity::ARolling, own, seen(roll.v * gained));
        }
        let friction = if rolls { self.needed } else { self.kinetic.signed(-self.sense) };
        // The power of each mode, friction's among them in that of slipping, is the rate of its energy.
        let own_rate = if rolls { T::zero() } else { (slip.power + friction) / slip.inertia };
        say(Quantity::A, own, seen((roll.v * gained).balance(slip.v * own_rate)));
        say(Quantity::Alpha, own, (roll.w * gained).balance(slip.w * own_rate));
        say(Quantity::Friction, own, friction.signed(up));
    }

    /// Everything at the end.
    fn tell_end(&self, (state, between, slid, _): &Ended<T>, say: &mut dyn FnMut(Quantity, Owner, T)) {
        let (own, zero) = (Owner::Body(self.body), T::zero());
        let numbers = &self.n.bodies[self.body];
        say(Quantity::T, Owner::Scene, state.t);
        let seen = numbers.carried.map_or([state.v, zero], |[forward, out]| {
            let with = plant!("energy: speed of the carrier of a thrown body", forward.after(state.t));
            [state.v.balance(with), out.after(state.t)]
        });
        say(Quantity::V, own, speed(seen[0], seen[1]));
        say(Quantity::Omega, own, state.w.abs());
        let carried = numbers.carried.map(|[forward, _]| forward.way(state.t));
        say(Quantity::Displacement, own, carried.map_or(state.x, |way| state.x.balance(way)));
        say(Quantity::Rise, own, state.x * numbers.climb);
        say(Quantity::Phi, own, state.phi.abs());
        let energy = self.energy(state);
        say(Quantity::KineticEnergy, Owner::Scene, energy);
        if !energy.is_zero() {
            let spinning = (numbers.inertia * state.w.square()).scale2(-1);
            say(Quantity::RotationalFraction, Owner::Scene, spinning / energy);
        }
        let momentum = plant!("energy: gain of momentum", state.v.balance(-self.start.v)) * numbers.mass;
        say(Quantity::Impulse, own, momentum);
        let spin = plant!("energy: angular momentum of a thrown body", state.w.abs()) * numbers.inertia;
        say(Quantity::AngularMomentum, own, spin);
        let path =
            between.map_or_else(|| path(&self.start, state), |e| path(&self.start, &e) + path(&e, state));
        say(Quantity::Distance, own, plant!("energy: path of the centre", path));
        // Of each couple, over the turn in its own sense.
        let couples = self.scene.couples.iter().filter(|c| c.body == self.body);
        let couples =
            couples.map(|c| self.n.massive(c.moment_n_m).signed(if c.forward { 1.0 } else { -1.0 }));
        if let Some(moment) = couples.reduce(T::balance) {
            say(Quantity::WorkCouple, own, moment * state.phi);
            say(Quantity::PowerCouple, own, moment * state.w);
        }
        say(Quantity::SlipDistance, own, *slid);
        say(Quantity::Heat, Owner::Scene, self.kinetic * *slid);
    }

    /// Energy of the two modes, seen from the ground.
    fn energy(&self, state: &State<T>) -> T {
        let mass = self.n.bodies[self.body].mass;
        let modes = self.roll.inertia * state.roll.square() + self.slip.inertia * state.slip.square();
        let energy = modes.scale2(-1);
        let Some(carried) = self.n.bodies[self.body].carried else { return energy };
        // What both motions have in common, and the energy of being carried.
        let [forward, out] = carried.map(|c| c.after(state.t));
        let with = (mass * (forward.square() + out.square())).scale2(-1);
        energy.balance(mass * forward * state.v).balance(with)
    }
}
