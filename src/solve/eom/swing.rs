//! The motion of a pinned body: `omega d omega = alpha d phi`, integrated over the angle, and the time that it takes.
//!
//! Under its weight alone the time is an elliptic integral, here by Carlson's R_F. With a couple or a spring it is a
//! quadrature of `d phi / omega`; from rest the angle goes as the square of the variable, which takes the root
//! singularity away, and so does the last half of a way that ends at rest, which is the way back from there.
use crate::num::gauss::{PerNode, Unsettled};
use crate::num::half::Half;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Real, elliptic, gauss, root, trig};
use crate::scene::{End, Label, Numbers, Owner, Pin, Quantity, Scene, Start};
use crate::solve::eom::integrate::{Event, Route, pace, unpressed};
use crate::solve::eom::pinned::Pinned;
use crate::solve::eom::travel;
use crate::solve::eom::{STEPS, couple_on};
use crate::solve::method::Rung;
use crate::solve::outcome::{Course, Refusal, Road, Said, Scope};

/// A motion is followed for two turns; within them the ends that a bank can ask for lie.
const TURNS: f64 = 2.0;
/// Step in which changes of the drive are looked for, radians.
const STRIDE: f64 = 0.25;
/// Strides after which the speed is computed anew.
const LOOK: u32 = 4;
/// The least share of a stride that is taken to tell two changes of the drive apart, 2^-30.
const LEAST: f64 = 1.0 / (1u64 << 30) as f64;
/// How often strides are halved in one search: where a spring balances the weight everywhere, the drive is 0 everywhere.
const HALVED: u32 = 600;

/// Doubles decide whether a speed is reached where none that was looked at is nearer to it than this share of its terms.
const CLEAR: f64 = 1e-9;
/// A place that doubles found is good if the second of two corrections is below this share of the way, 2^-40: the next one would
/// be below the last digit.
const CORRECTED: f64 = 1.0 / (1u64 << 40) as f64;

/// A place on the way.
#[derive(Debug, Clone, Copy)]
struct Place<T> {
    /// Angle turned from the start, radians, >= 0.
    way: T,
    /// The angle of the body.
    half: Half<T>,
}

/// What is known where the motion ends.
#[derive(Debug, Clone, Copy)]
struct Arrival<T> {
    place: Place<T>,
    /// At rest by the definition of the event, not by what rounding leaves.
    rest: bool,
}

/// The body on its way in one sense.
#[derive(Debug, Clone, Copy)]
struct Swing<T> {
    body: Pinned<T>,
    start: Half<T>,
    /// 1 if the angle grows, -1 if it shrinks.
    sense: f64,
    /// Half the square of the angular speed at the start.
    half_square: T,
}

/// A part of the way, summed on one panel.
struct Stretch<T> {
    time: T,
    /// What the spring has added to half the square of the angular speed at its start and at its end.
    from: T,
    end: T,
    /// Is the sum good as it is?
    smooth: bool,
}

/// A pendulum's way as an elliptic integral sees it: halves of the angle from hanging, growing on the way.
#[derive(Debug, Clone, Copy)]
struct Arc<T> {
    /// Sine and cosine of half the angle.
    sine: T,
    cosine: T,
    /// Angular speed as a share of twice the frequency of small swings: `p^2 = k^2 - sin^2`.
    pace: T,
}

/// Looks up the time to the end without steps.
type Known<'k> = &'k dyn Fn() -> Option<f64>;
/// A rung, and which quantities are wanted of it.
pub type Steps<'s> = (Rung, &'s dyn Fn(Quantity) -> bool);

/// What the equations of motion say of a scene with a pinned body; with the states at its events from the steps of a rung, if one
/// is given, and what they cost.
///
/// Errors: equations that do not determine the motion, a quadrature that does not settle, a run that does not reach its events.
pub fn road_by<T: Real>(
    scene: &Scene,
    n: Numbers<T>,
    (owner, pin): (usize, &Pin),
    asked_for: Scope,
    by: Option<Steps>,
) -> Result<(Road<T>, Count), Refusal> {
    let body = Pinned::new(scene, &n, owner, pin)?;
    let spin = scene.start.iter().find_map(|s| match s {
        Start::Speed(c, w) if c.body == owner => Some(n.get(*w)),
        _ => None,
    });
    let spin = spin.unwrap_or_else(T::zero);
    let first = body.acceleration(&body.start);
    let sense = if spin.is_zero() { first.sign() } else { spin.sign() };
    let swing = Swing { body, start: body.start, sense, half_square: spin.square().scale2(-1) };
    let mut teller = Teller { n: &n, owner, asked: asked_for, road: Road::new(asked_for) };
    let mass_centre = teller.lasting(scene, &swing, pin);
    let start = Place { way: T::zero(), half: swing.start };
    if matches!(scene.end, End::AtOnce) {
        teller.state(&swing, &start, mass_centre, spin.abs());
        return Ok((teller.road, Count::default()));
    }
    if sense == 0.0 {
        teller.road.course = Some(Course::at_rest());
        teller.forces(&swing, &start, T::zero());
        return Ok((teller.road, Count::default()));
    }
    let pendulum = scene.is_pendulum() && !swing.body.frequency().is_zero();
    let turning = if pendulum { swing.pendulum_turning() } else { swing.turning(scene, &n)? };
    let limit = turning.map_or_else(|| T::of(f64::INFINITY), |p| p.way);
    let (asked, farthest, end) = swing.end(scene, &n, pendulum, turning)?;
    // What is asked at the turning point is at rest there; NaN is not reached.
    let end = end.filter(|e| e.place.way.not_negative() && e.place.way.at_most(limit));
    let end = end.map(|e| Arrival { rest: e.rest || e.place.way.side(limit) == 0.0, ..e });
    teller.road.course =
        Some(Course { sense, drive: (T::zero(), T::zero()), asked, farthest, reached: end.is_some() });
    let Some(Arrival { place, rest }) = end else {
        teller.forces(&swing, &start, swing.half_square.scale2(1));
        return Ok((teller.road, Count::default()));
    };
    let mut count = Count::default();
    let (place, speed, time) = if let Some(by) = by.filter(|_| STEPS) {
        let swung = turning.filter(|_| pendulum && swing.half_square.is_zero());
        let known = || {
            let speed = if rest { T::zero() } else { swing.gained(&place).ok()?.scale2(1).root() };
            Some(swing.time(&place, rest, speed, pendulum).ok()?.f64())
        };
        let run = swing.stepped(scene, teller.n, (&place, swung, &known), by)?;
        count = run.count;
        if let Some((period, fastest)) = run.period {
            teller.replace(Quantity::Period, T::of(period));
            teller.replace(Quantity::OmegaMax, T::of(fastest));
        }
        let speed = if rest { T::zero() } else { T::of(run.end.u) };
        (swing.place(T::of(run.end.s)), speed, T::of(run.end.time))
    } else {
        let (speed, time) = swing.arrived(&place, rest, pendulum, asked_for.quantities.has(Quantity::T))?;
        (place, speed, time)
    };
    teller.say(Quantity::T, Owner::Scene, time);
    teller.say(Quantity::Phi, Owner::Body(owner), place.way);
    let step = Half::of_radians(place.way.signed(sense));
    let product = (step.sine * place.half.plus(swing.start).sine).scale2(1);
    let sunk = plant!("eom: height lost by the mass centre", mass_centre) * product;
    // A difference of two heights of the mass centre.
    let rise = if swing.body.is_upright() { -sunk } else { sunk };
    teller.say_scaled(Quantity::Rise, Owner::Body(owner), rise, 2.0 * mass_centre.f64().abs());
    teller.state(&swing, &place, mass_centre, speed);
    if let Some(moment) = couple_on(scene, teller.n, owner) {
        let along = moment.signed(sense);
        teller.say(Quantity::WorkCouple, Owner::Body(owner), along * place.way);
        teller.say(Quantity::PowerCouple, Owner::Body(owner), along * speed);
    }
    Ok((teller.road, count))
}

/// What steps give of a swing.
struct Stepped {
    /// At the ending event: angle turned, angular speed, time.
    end: travel::State<f64>,
    /// Period and greatest angular speed, where they were wanted.
    period: Option<(f64, f64)>,
    count: Count,
}

/// What is said, with the units put back.
struct Teller<'a, T: Real> {
    n: &'a Numbers<'a, T>,
    owner: usize,
    asked: Scope,
    road: Road<T>,
}

impl<T: Real> Teller<'_, T> {
    fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.say_scaled(quantity, of, value, value.f64().abs());
    }
    fn say_scaled(&mut self, quantity: Quantity, of: Owner, value: T, scale: f64) {
        if self.asked.quantities.has(quantity) {
            self.road.said.push(Said::of(self.n, Label { quantity, of }, value, scale));
        }
    }

    /// Puts another value in the place of what was said.
    fn replace(&mut self, quantity: Quantity, value: T) {
        let label = Label { quantity, of: Owner::Body(self.owner) };
        let value = self.n.publish(quantity, value);
        for said in self.road.said.iter_mut().filter(|s| s.label == label) {
            said.value = value;
        }
    }

    /// What holds whatever the end; gives the arm of the mass centre.
    fn lasting(&mut self, scene: &Scene, swing: &Swing<T>, pin: &Pin) -> T {
        let of = Owner::Body(self.owner);
        self.say(Quantity::IO, of, swing.body.inertia());
        let arm = Pinned::arm(self.n, pin);
        let frequency = swing.body.frequency();
        if scene.is_pendulum() && !frequency.is_zero() {
            let turn = T::constant(Dd::PI.scale2(1));
            self.say(Quantity::OmegaSmall, of, frequency);
            self.say(Quantity::PeriodSmall, of, turn / frequency);
            if self.asked.any(&[Quantity::Period, Quantity::OmegaMax]) {
                let (period, fastest) = swing.period();
                self.say(Quantity::Period, of, period);
                self.say(Quantity::OmegaMax, of, fastest);
            }
        }
        arm
    }

    /// Angular acceleration and forces at a place.
    fn forces(&mut self, swing: &Swing<T>, place: &Place<T>, square: T) {
        let of = Owner::Body(self.owner);
        let (alpha, scale) = swing.body.acceleration_of_terms(&place.half);
        self.say_scaled(Quantity::Alpha, of, alpha, scale);
        let held = swing.body.held(&place.half, square);
        let (radial, across) = (held.radial, held.across);
        self.say_scaled(Quantity::PinRadial, of, radial.0, radial.1);
        self.say_scaled(Quantity::PinTangential, of, across.0, across.1);
        let force = (radial.0.square() + across.0.square()).root();
        self.say(Quantity::PinForce, of, force);
        let (sine, cosine) = (place.half.full_sine(), place.half.full_cosine());
        let up = cosine.signed(if swing.body.is_upright() { 1.0 } else { -1.0 });
        let sideways = if swing.body.is_upright() { sine } else { -sine };
        let x = (across.0 * cosine).balance(-(radial.0 * sine));
        let y = -(radial.0 * up).balance(across.0 * sideways);
        let terms = radial.1 + across.1;
        self.say_scaled(Quantity::PinX, of, plant!("eom: horizontal part of the pin's force", x), terms);
        self.say_scaled(Quantity::PinY, of, plant!("eom: vertical part of the pin's force", y), terms);
        if !force.is_zero() {
            self.say(Quantity::PinAngle, of, trig::angle(y, x));
        }
        if let Some((force, scale)) = swing.body.spring_force(&place.half) {
            self.say_scaled(Quantity::SpringForce, of, force, scale);
        }
    }

    /// Everything at a place.
    fn state(&mut self, swing: &Swing<T>, place: &Place<T>, arm: T, speed: T) {
        let of = Owner::Body(self.owner);
        self.say(Quantity::Omega, of, speed);
        self.say(Quantity::V, of, plant!("eom: arm of the speed of the mass centre", arm) * speed);
        self.say(Quantity::AngularMomentum, of, swing.body.inertia() * speed);
        let whole = swing.body.inertia() * speed.square();
        self.say(Quantity::KineticEnergy, Owner::Scene, whole.scale2(-1));
        if !speed.is_zero() {
            let share = self.n.bodies[self.owner].inertia / swing.body.inertia();
            self.say(Quantity::RotationalFraction, Owner::Scene, share);
        }
        self.forces(swing, place, speed.square());
    }
}

impl<T: Real> Swing<T> {
    fn place(&self, way: T) -> Place<T> {
        Place { way, half: self.start.plus(Half::of_radians(way.signed(self.sense))) }
    }

    /// The states at the events by steps in time, in one run: the end, and of a pendulum released from rest that turns at
    /// `swung` the lowest place and the far turning point, if period or greatest speed are wanted.
    fn stepped(
        &self,
        scene: &Scene,
        n: &Numbers<T>,
        (end, swung, known): (&Place<T>, Option<Place<T>>, Known),
        (rung, asked): Steps,
    ) -> Result<Stepped, Refusal> {
        let u0 = self.half_square.scale2(1).root();
        let event = match scene.end {
            End::Time(_, t) => Event::Time(n.get(t).f64()),
            End::Speed(_, w) => {
                let w = n.get(w).abs();
                if u0.below(w) { Event::Rise(w.f64()) } else { Event::Fall(w.f64()) }
            }
            End::TurningPoint(_) => Event::Fall(0.0),
            _ => Event::Place(end.way.f64()),
        };
        const END: usize = 0;
        const LOWEST: usize = 1;
        const FAR: usize = 2;
        let mut events = vec![(event, end.way.f64(), END)];
        if let (true, Some(far)) = (asked(Quantity::Period) || asked(Quantity::OmegaMax), swung) {
            events.push((Event::Level, 0.5 * far.way.f64(), LOWEST));
            events.push((Event::Fall(0.0), far.way.f64(), FAR));
        }
        events.sort_by(|a, b| a.1.total_cmp(&b.1));
        let law = self.body.law();
        let sense = self.sense;
        let law = move |_: usize, way: f64, _: f64| sense * law.at(sense * way);
        let farthest = events.iter().fold(0.0, |far: f64, e| far.max(e.1));
        let force = (0..=8).map(|i| law(0, 0.125 * f64::from(i) * farthest, 0.0).abs()).fold(0.0, f64::max);
        let u0 = u0.f64();
        // The far turning point comes after half a period.
        let half_period = || if events.len() > 1 { 0.5 * self.period().0.f64() } else { 0.0 };
        let time = || known().map_or(f64::INFINITY, |known| known.max(half_period()));
        let pace = pace(farthest, force, u0);
        let route = Route { law, presses: &unpressed, switch: None, u0, pace, time: &time };
        let list: Vec<(Event, f64)> = events.iter().map(|e| (e.0, e.1)).collect();
        let (states, count) = route
            .states(&list, rung)
            .map_err(|trouble| Refusal::Trouble { method: rung.method(), trouble })?;
        let of = |kind: usize| events.iter().zip(&states).find(|(e, _)| e.2 == kind).map(|(_, s)| *s);
        let period = of(FAR).zip(of(LOWEST)).map(|(far, lowest)| (2.0 * far.time, lowest.u));
        let nothing = travel::State { s: f64::NAN, u: f64::NAN, time: f64::NAN };
        Ok(Stepped { end: of(END).unwrap_or(nothing), period, count })
    }

    /// Angular acceleration along the way.
    fn drive(&self, place: &Place<T>) -> T {
        self.body.acceleration(&place.half).signed(self.sense)
    }

    /// What all but the spring adds to half the square of the angular speed between two places.
    fn closed(&self, from: &Place<T>, to: &Place<T>) -> T {
        let turned = (to.way - from.way).signed(self.sense);
        self.body.closed_gain(&from.half, &to.half, &Half::of_radians(turned), turned)
    }

    /// What the spring adds: its moment integrated over the angle.
    fn sprung(&self, from: T, to: T) -> Result<T, Refusal> {
        if !self.body.has_spring() {
            return Ok(T::zero());
        }
        gauss::integral_of_terms(|way| Ok(self.spring_at(way)), (from, to), self.body.pull_terms())
    }

    fn spring_at(&self, way: T) -> T {
        let pull = self.body.pulling(&self.place(way).half).signed(self.sense);
        plant!("eom: moment of the spring over the angle", pull)
    }

    /// Half the square of the angular speed at a place.
    fn gained(&self, to: &Place<T>) -> Result<T, Refusal> {
        Ok(self.square(to, self.sprung(T::zero(), to.way)?))
    }

    /// The same, with what the spring adds on the way there.
    fn square(&self, to: &Place<T>, sprung: T) -> T {
        let closed = self.closed(&Place { way: T::zero(), half: self.start }, to);
        let size = self.half_square.size() + closed.size() + sprung.size();
        (self.half_square + closed + sprung).cleared(size)
    }

    // -- where it ends --------------------------------------------------------------------------------------------------

    /// What the event asks for and how far the motion goes, both in its measure (degrees, seconds, rad/s), and the place.
    #[expect(clippy::type_complexity, reason = "three numbers of one moment")]
    fn end(
        &self,
        scene: &Scene,
        n: &Numbers<T>,
        pendulum: bool,
        turning: Option<Place<T>>,
    ) -> Result<(Option<T>, T, Option<Arrival<T>>), Refusal> {
        let infinite = T::of(f64::INFINITY);
        let arrive = |place| Some(Arrival { place, rest: false });
        let degrees = || T::constant(Dd::new(180.0) / Dd::PI);
        Ok(match scene.end {
            End::Angle(_, angle) => {
                let Some(apart) = self.apart(scene, n) else { return Ok((None, infinite, None)) };
                let place = Place { way: radians(apart), half: Half::of_degrees(n.get(angle)) };
                (Some(apart), turning.map_or(infinite, |t| t.way * degrees()), arrive(place))
            }
            End::TurningPoint(_) => {
                let place = turning.map(|place| Arrival { place, rest: true });
                (None, turning.map_or(infinite, |t| t.way * degrees()), place)
            }
            End::Time(_, t) => {
                let t = n.get(t);
                let last = turning.unwrap_or_else(|| self.place(T::constant(Dd::PI * Dd::new(2.0 * TURNS))));
                let most = self.time_to(&last, turning.is_some(), pendulum)?;
                if t.side(most) == 0.0 {
                    return Ok((Some(t), most, Some(Arrival { place: last, rest: turning.is_some() })));
                }
                let place = if t.below(most) { arrive(self.after(t, last.way, pendulum)?) } else { None };
                (Some(t), most, place)
            }
            End::Speed(_, w) => {
                let w = n.get(w).abs();
                let (place, most) = self.reaching(w, turning)?;
                (Some(w), most, place.and_then(arrive))
            }
            End::AtOnce
            | End::Travel(..)
            | End::Position(..)
            | End::Rolling(_)
            | End::Leaves(_)
            | End::Equilibrium => (None, infinite, None),
        })
    }

    /// How far the asked angle is from the start along the motion, degrees.
    fn apart(&self, scene: &Scene, n: &Numbers<T>) -> Option<T> {
        match (scene.end, scene.pinned()) {
            (End::Angle(_, angle), Some((_, pin))) => {
                Some((n.get(angle) - n.get(pin.start_deg)).signed(self.sense))
            }
            _ => None,
        }
    }

    /// The place after a time that is less than that of `last`.
    fn after(&self, time: T, last: T, pendulum: bool) -> Result<Place<T>, Refusal> {
        let pace = |way: T| -> Result<(T, T), Refusal> {
            let place = self.place(way);
            let speed = self.gained(&place)?.scale2(1).root();
            Ok((self.time(&place, false, speed, pendulum)? - time, T::of(1.0) / speed))
        };
        Ok(self.place(root::between(T::zero(), last, true, pace)?))
    }

    /// The first place at which the angular speed is `w`, and the greatest that is reached before the turning point.
    fn reaching(&self, w: T, turning: Option<Place<T>>) -> Result<(Option<Place<T>>, T), Refusal> {
        let level = w.square().scale2(-1);
        let far = turning.map_or_else(|| T::constant(Dd::PI * Dd::new(2.0 * TURNS)), |t| t.way);
        if level.side(self.half_square) == 0.0 {
            return Ok((Some(self.place(T::zero())), self.fastest(far, w)));
        }
        let (found, greatest) = self.located(level, far, T::zero())?;
        Ok(match found {
            Some(way) => (Some(self.place(way)), self.fastest(far, w)),
            None => (None, greatest.scale2(1).root()),
        })
    }

    /// Where it comes to rest; `None` if not within two turns, nor within twice the way to an angle that is asked.
    fn turning(&self, scene: &Scene, n: &Numbers<T>) -> Result<Option<Place<T>>, Refusal> {
        let far = T::constant(Dd::PI * Dd::new(2.0 * TURNS));
        let zero = T::zero();
        let (found, _) = match self.apart(scene, n) {
            Some(apart) => {
                let asked = radians(apart);
                // What spoils the motion further on does not matter.
                let beyond = self.located(zero, asked.scale2(1), asked);
                beyond.or_else(|_| self.located(zero, asked, asked))?
            }
            None => self.located(zero, far, zero)?,
        };
        Ok(found.map(|way| self.place(way)))
    }

    // -- the time -------------------------------------------------------------------------------------------------------

    fn time_to(&self, place: &Place<T>, rest: bool, pendulum: bool) -> Result<T, Refusal> {
        let speed = if rest { T::zero() } else { self.gained(place)?.scale2(1).root() };
        self.time(place, rest, speed, pendulum)
    }

    /// Angular speed and, if it is asked, time at a place, at which it rests or not.
    fn arrived(&self, place: &Place<T>, rest: bool, pendulum: bool, timed: bool) -> Result<(T, T), Refusal> {
        // In doubles what else is asked must not change the last digits of the speed: differences are made of them.
        if rest || pendulum || place.way.is_zero() || !timed || T::is_double() {
            let speed = if rest { T::zero() } else { self.gained(place)?.scale2(1).root() };
            let time = if timed { self.time(place, rest, speed, pendulum)? } else { T::zero() };
            return Ok((speed, time));
        }
        // The quadrature for the time sums up the work of the spring.
        let (time, sprung) = self.quadrature(place.way)?;
        Ok((self.square(place, sprung).scale2(1).root(), time))
    }

    /// Time to a place at which the angular speed is known.
    fn time(&self, place: &Place<T>, rest: bool, speed: T, pendulum: bool) -> Result<T, Refusal> {
        if place.way.is_zero() {
            return Ok(T::zero());
        }
        if pendulum {
            return Ok(self.pendulum_time(place, speed));
        }
        if !rest {
            return Ok(self.quadrature(place.way)?.0);
        }
        // The last half is the way back from the turning point.
        let half = place.way.scale2(-1);
        let back = Swing { body: self.body, start: place.half, sense: -self.sense, half_square: T::zero() };
        Ok(self.quadrature(half)?.0 + back.quadrature(half)?.0)
    }

    /// `int d phi / omega` over the way, panel by panel, and what the spring adds to half the square of omega, which is summed up
    /// along with it.
    fn quadrature(&self, way: T) -> Result<(T, T), Refusal> {
        let whole = self.panel(way, 0.0, 1.0, T::zero());
        let end = self.place(way);
        let start = Place { way: T::zero(), half: self.start };
        let square = self.half_square.size() + self.closed(&start, &end).size() + whole.end.size();
        let scales = (whole.time.size(), square);
        self.halves(way, (0.0, 1.0), T::zero(), whole, scales, gauss::halvings())
    }

    /// Time over a part of the way, and what the spring has added at its end.
    fn halves(
        &self,
        way: T,
        (a, b): (f64, f64),
        sprung: T,
        whole: Stretch<T>,
        scales: (f64, f64),
        left: u32,
    ) -> Result<(T, T), Refusal> {
        if whole.smooth {
            return Ok((whole.time, whole.end));
        }
        let middle = 0.5 * (a + b);
        let first = self.panel(way, a, middle, sprung);
        let second = self.panel(way, middle, b, first.end);
        let sum = first.time + second.time;
        let scales = (gauss::sized(scales.0, sum), gauss::sized(scales.1, second.end));
        if gauss::settled(sum, whole.time, scales.0) && gauss::settled(second.end, whole.end, scales.1) {
            return Ok((sum, second.end));
        }
        if left == 0 {
            let gap = (sum - whole.time).f64().abs();
            return Err(Refusal::Unsettled(Unsettled { value: sum.f64(), gap }));
        }
        let (first, half) = self.halves(way, (a, middle), sprung, first, scales, left - 1)?;
        // What the spring has added by then is known better now, unless the first half was taken as it was.
        let second = if half.same(second.from) { second } else { self.panel(way, middle, b, half) };
        let (second, end) = self.halves(way, (middle, b), half, second, scales, left - 1)?;
        Ok((first + second, end))
    }

    /// One panel of the variable s from `a` to `b`: from rest the angle is `way s^2`, else `way s`.
    // Its many numbers must not lie in every frame of the halving.
    #[inline(never)]
    fn panel(&self, way: T, a: f64, b: f64, sprung: T) -> Stretch<T> {
        let rest = self.half_square.is_zero();
        let width = T::of(b) - T::of(a);
        let start = Place { way: T::zero(), half: self.start };
        let mut places: PerNode<(Place<T>, T)> = PerNode::new();
        let mut pulls: PerNode<T> = PerNode::new();
        for node in gauss::nodes() {
            let s = T::of(a) + width * T::constant(*node);
            let (at, slope) = if rest { (way * s.square(), (way * s).scale2(1)) } else { (way * s, way) };
            let place = self.place(at);
            if self.body.has_spring() {
                let pull = self.body.pulling(&place.half).signed(self.sense);
                pulls.push(plant!("eom: moment of the spring over the angle", pull) * slope * width);
            }
            places.push((place, slope));
        }
        let added = if pulls.is_empty() { PerNode::new() } else { gauss::running(&pulls) };
        let times: PerNode<T> = places
            .iter()
            .enumerate()
            .map(|(j, (place, slope))| {
                let spring = added.get(j).map_or(sprung, |r| sprung + *r);
                let square = self.half_square + self.closed(&start, place) + spring;
                *slope * width / square.scale2(1).root()
            })
            .collect();
        let end = if pulls.is_empty() { sprung } else { sprung + gauss::mean(&pulls) };
        let even = pulls.is_empty() || gauss::smooth(&pulls, gauss::SMOOTH_RUNNING);
        let smooth = even && gauss::smooth(&times, gauss::SMOOTH);
        Stretch { time: gauss::mean(&times), from: sprung, end, smooth }
    }

    // -- under the weight alone -----------------------------------------------------------------------------------------

    /// The start as the elliptic integral sees it.
    fn arc(&self) -> Arc<T> {
        let hanging = if self.body.is_upright() { self.start.less_half_turn() } else { self.start };
        let speed = self.half_square.scale2(1).root();
        let mut arc = Arc {
            sine: hanging.sine.signed(self.sense),
            cosine: hanging.cosine,
            pace: (speed / self.body.frequency()).scale2(-1),
        };
        // Half turns change both signs: the pendulum starts between top and top, and leaves the top behind it.
        if arc.cosine.sign() < 0.0 || (arc.cosine.is_zero() && arc.sine.sign() > 0.0) {
            (arc.sine, arc.cosine) = (-arc.sine, -arc.cosine);
        }
        arc
    }

    /// Modulus k, and `1 - k^2`: above 0 it swings, below it goes over the top.
    fn modulus(arc: &Arc<T>) -> (T, T) {
        let k =
            if arc.pace.is_zero() { arc.sine.abs() } else { (arc.sine.square() + arc.pace.square()).root() };
        (k, arc.cosine.square().balance(-arc.pace.square()))
    }

    /// Complementary modulus; the root without squaring where it starts from rest.
    fn complement(arc: &Arc<T>, rest: T) -> T {
        if arc.pace.is_zero() { arc.cosine } else { rest.root() }
    }

    fn pendulum_turning(&self) -> Option<Place<T>> {
        let arc = self.arc();
        let (k, rest) = Self::modulus(&arc);
        if rest.sign() < 0.0 {
            return None;
        }
        let complement = Self::complement(&arc, rest);
        let across = (k * arc.cosine).balance(-(complement * arc.sine));
        let along = (complement * arc.cosine).balance(k * arc.sine);
        let step = Half { sine: across.signed(self.sense), cosine: along };
        let about = self.start.plus(step);
        // At rest half the angle from hanging has the sine k: a hair from the top only this keeps the digits of the hair.
        let (k, rest) = (k.signed(self.sense), complement);
        let half = if self.body.is_upright() {
            Half { sine: rest, cosine: -k }
        } else {
            Half { sine: k, cosine: rest }
        };
        let same = half.sine * about.sine + half.cosine * about.cosine;
        let half = if same.sign() < 0.0 { Half { sine: -half.sine, cosine: -half.cosine } } else { half };
        Some(Place { way: trig::angle(across, along).scale2(1), half })
    }

    /// Period and greatest angular speed.
    fn period(&self) -> (T, T) {
        let arc = self.arc();
        let frequency = self.body.frequency();
        let (k, rest) = Self::modulus(&arc);
        let fastest = (frequency * k).scale2(1);
        let period = if rest.sign() < 0.0 {
            elliptic::rf_of_roots(T::zero(), (-rest).root(), k).scale2(1)
        } else {
            let complement = Self::complement(&arc, rest);
            elliptic::rf_of_roots(T::zero(), complement, T::of(1.0)).scale2(2)
        };
        (plant!("eom: period", period) / frequency, fastest)
    }

    fn pendulum_time(&self, place: &Place<T>, speed: T) -> T {
        let first = self.arc();
        let frequency = self.body.frequency();
        let pace = (speed / frequency).scale2(-1);
        // Half of the way as an angle of its own.
        let (sine, cosine) = trig::turn(place.way.scale2(-1));
        let hanging = if self.body.is_upright() { place.half.less_half_turn() } else { place.half };
        let mut last = Arc { sine: hanging.sine.signed(self.sense), cosine: hanging.cosine, pace };
        // The signs that it has on the way there from the start, and how often it has passed the top: an even number where
        // the cosine has kept its sign.
        let half = trig::atan2(first.sine, first.cosine).f64() + 0.5 * place.way.f64();
        let (s, c) = trig::sin_cos_radians(Dd::new(half));
        if s.hi * last.sine.f64() + c.hi * last.cosine.f64() < 0.0 {
            (last.sine, last.cosine) = (-last.sine, -last.cosine);
        }
        let tops = half / std::f64::consts::PI;
        let odd = last.cosine.sign() < 0.0;
        let passed = if odd { 2.0 * ((tops - 1.0) / 2.0).round() + 1.0 } else { 2.0 * (tops / 2.0).round() };
        let (k, rest) = Self::modulus(&first);
        let total = if passed < 0.5 {
            between(&first, &last, k, Half { sine, cosine })
        } else {
            if odd {
                (last.sine, last.cosine) = (-last.sine, -last.cosine);
            }
            let pace = (-rest).root();
            let one = T::of(1.0);
            let before = Arc { sine: one, cosine: T::zero(), pace };
            let beyond = Arc { sine: -one, cosine: T::zero(), pace };
            let up = Half { sine: first.cosine, cosine: first.sine };
            let down = Half { sine: last.cosine, cosine: -last.sine };
            let turn = elliptic::rf_of_roots(T::zero(), pace, k);
            between(&first, &before, k, up) + between(&beyond, &last, k, down) + turn * T::of(passed - 1.0)
        };
        plant!("eom: time of the swing", total.scale2(1)) / frequency
    }
}

/// Half of `int ds / sqrt((1 - s^2)(k^2 - s^2))` between two places of one swing whose halves are `step` apart:
/// R_F of four factors `1 - s, 1 + s, k - s, k + s` (NIST DLMF 19.29.4).
fn between<T: Real>(from: &Arc<T>, to: &Arc<T>, k: T, step: Half<T>) -> T {
    // The difference of the sines as a product: it vanishes with the way.
    let quarter = Half::of_point(step.sine, step.cosine);
    let middle = (from.cosine * quarter.cosine).balance(-(from.sine * quarter.sine));
    let apart = (quarter.sine * middle).scale2(1);
    if apart.is_zero() {
        return T::zero();
    }
    // Roots of the factors; the smaller of two from their product.
    let roots = |a: &Arc<T>| {
        let pair = |one: T, product: T| {
            let larger = (one + a.sine.abs()).root();
            let smaller = if larger.is_zero() { larger } else { product / larger };
            if a.sine.sign() < 0.0 { (larger, smaller) } else { (smaller, larger) }
        };
        (pair(T::of(1.0), a.cosine), pair(k, a.pace))
    };
    let ((x1, x2), (x3, x4)) = roots(to);
    let ((y1, y2), (y3, y4)) = roots(from);
    let u12 = (x1 * x2 * y3 * y4 + y1 * y2 * x3 * x4) / apart;
    let u13 = (x1 * x3 * y2 * y4 + y1 * y3 * x2 * x4) / apart;
    let u14 = (x1 * x4 * y2 * y3 + y1 * y4 * x2 * x3) / apart;
    elliptic::rf_of_roots(u12, u13, u14)
}

fn radians<T: Real>(degrees: T) -> T {
    degrees * T::constant(Dd::PI / Dd::new(180.0))
}

impl<T: Real> Swing<T> {
    /// The greatest angular speed on the way to `far`, at least `known`; infinite where what comes after the event, such as
    /// a spring through its anchor, has no speed.
    fn fastest(&self, far: T, known: T) -> T {
        // No square is at a level below 0: the search goes on to the end.
        match self.located(T::of(-1.0), far, T::zero()) {
            Ok((_, greatest)) => known.larger(greatest.scale2(1).root()),
            Err(_) => T::of(f64::INFINITY),
        }
    }

    /// The first way at which half the square of the angular speed is at `level` (from above if the level is 0), and the
    /// greatest that was met on the way to it or to `far`. It is searched in doubles and then corrected; if another way is given,
    /// it need be no better than what tells it from that one.
    fn located(&self, level: T, far: T, other: T) -> Result<(Option<T>, T), Refusal> {
        if !T::is_double() {
            let doubles = Swing {
                body: self.body.doubles(),
                start: Half { sine: self.start.sine.f64(), cosine: self.start.cosine.f64() },
                sense: self.sense,
                half_square: self.half_square.f64(),
            };
            if let Ok((found, greatest, true)) = doubles.crossing(level.f64(), far.f64()) {
                let Some(way) = found else { return Ok((None, T::of(greatest))) };
                let apart = !other.is_zero() && (way - other.f64()).abs() > CLEAR * way;
                let way = if apart { Some(T::of(way)) } else { self.corrected(T::of(way), level)? };
                if way.is_some() {
                    return Ok((way, T::of(greatest)));
                }
            }
        }
        self.crossing(level, far).map(|(found, greatest, _)| (found, greatest))
    }

    /// The way that two steps of Newton's method lead to, if they settle.
    fn corrected(&self, near: T, level: T) -> Result<Option<T>, Refusal> {
        let (mut way, mut step) = (near, near);
        for _ in 0..2 {
            let place = self.place(way);
            step = (self.gained(&place)? - level) / self.drive(&place);
            way = way - step;
        }
        Ok((step.size() <= CORRECTED * way.size()).then_some(way))
    }

    /// The same by a search in this number type, and whether no comparison in it was close.
    fn crossing(&self, level: T, far: T) -> Result<(Option<T>, T, bool), Refusal> {
        let stride = T::of(STRIDE);
        let above = |square: T| (square - level).sign();
        let from_above = level.is_zero() || level.below(self.half_square);
        let crossed = |square: T| if from_above { above(square) <= 0.0 } else { above(square) >= 0.0 };
        // The last place whose speed is known, and the last whose drive is.
        let mut here = self.place(T::zero());
        let mut before = (here.way, self.drive(&here));
        let (mut square, mut greatest) = (self.half_square, self.half_square);
        let (mut strides, mut clear) = (0, true);
        // Shorter strides where the drive may change its sign twice within one.
        let law = self.body.law();
        let once = |a: T, b: T| law.changes_once(self.sense * a.f64(), self.sense * b.f64());
        let (mut share, mut halved) = (1.0, 0);
        while before.0.below(far) {
            let mut next = before.0 + T::of(share) * stride;
            while share > LEAST && halved < HALVED && !once(before.0, next) {
                (share, halved) = (0.5 * share, halved + 1);
                next = before.0 + T::of(share) * stride;
            }
            share = f64::min(2.0 * share, 1.0);
            let next = if next.below(far) { next } else { far };
            let drive = self.drive(&self.place(next));
            // The speed has its extremes where the drive changes its sign; between them and every few strides it is enough
            // to look.
            let turns = before.1.sign() * drive.sign() < 0.0;
            strides += 1;
            let mut stop = None;
            if turns {
                stop = Some(root::between(before.0, next, drive.sign() > 0.0, |way| {
                    Ok::<_, Refusal>((self.drive(&self.place(way)), T::zero()))
                })?);
            } else if strides % LOOK == 0 || drive.is_zero() || !next.below(far) {
                stop = Some(next);
            }
            before = (next, drive);
            while let Some(way) = stop.take() {
                let at = |way: T| -> Result<(T, T, f64), Refusal> {
                    let place = self.place(way);
                    let parts = [square, self.closed(&here, &place), self.sprung(here.way, way)?];
                    let size = parts[0].size() + parts[1].size() + parts[2].size();
                    Ok(((parts[0] + parts[1] + parts[2]).cleared(size), self.drive(&place), size))
                };
                let (value, _, size) = at(way)?;
                // NaN is not clear.
                clear &= (value - level).size() > CLEAR * (size + greatest.size() + level.size());
                if greatest.below(value) {
                    greatest = value;
                }
                if crossed(value) {
                    let found = root::between(here.way, way, !from_above, |x| {
                        let (value, slope, _) = at(x)?;
                        Ok::<_, Refusal>((value - level, slope))
                    })?;
                    return Ok((Some(found), greatest, clear));
                }
                (here, square) = (self.place(way), value);
                if turns && !next.below(far) && way.below(next) {
                    stop = Some(next);
                }
            }
        }
        Ok((None, greatest, clear))
    }
}
