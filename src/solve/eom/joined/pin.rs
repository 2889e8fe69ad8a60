//! A body on a pin: how far it gets and where it ends, in closed form under its weight alone, and what is told of it beside what all
//! joined bodies have.
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::num::{Dd, Real};
use crate::scene::{End, Owner, Quantity, Ray, pose};
use crate::solve::eom::integrate::Event;
use crate::solve::eom::joined::tell::risen;
use crate::solve::eom::joined::{Fine, Gain, Motion, Panel, Passes, Stop, Teller, Why, no_friction};
use crate::solve::eom::pendulum::Pendulum;
use crate::solve::eom::planar::{Mechanism, Response, State};
use crate::solve::outcome::Refusal;

/// How often a bracket about a peak is cut by a third.
const PEAK: u32 = 80;

/// Where a pendulum stops within `far`.
pub fn pendulum_stop<T: Real>(pendulum: &Pendulum<T>, far: T, level: Option<T>) -> Result<Stop<T>, Refusal> {
    let limit = pendulum.turning();
    let mut passes = Passes::NONE;
    // What turns has passed nothing that slows it down.
    let mut slowest = |until: T| {
        let at = |i: u32| pendulum.half_square(until * T::of(f64::from(i) / f64::from(PEAK)));
        let seen = (0..PEAK).filter(|_| limit.is_none());
        seen.for_each(|i| passes.see(T::leading(|| at(i).f64())));
        passes.share
    };
    let last = limit.filter(|limit| limit.at_most(far)).unwrap_or(far);
    if let Some(level) = level
        && let Some(way) = pendulum.reaching(level, last)?
    {
        let slowest = slowest(way);
        return Ok(Stop { way, half_square: level, why: Why::Speed, time: None, slowest });
    }
    // What is asked at the turning point is there at rest.
    let (half_square, why) = match limit {
        Some(limit) if far.side(limit) == 0.0 => (T::zero(), Why::Far),
        Some(limit) if limit.below(far) => (T::zero(), Why::Rest),
        _ => (pendulum.half_square(far), Why::Far),
    };
    let way = if why == Why::Rest { last } else { far };
    Ok(Stop { way, half_square, why, time: None, slowest: slowest(way) })
}

impl<T: Real> Motion<'_, '_, T> {
    /// The angle of a body on a pin after a way, at the end of which it rests or not; `exactly` as the end has it.
    pub fn place(&self, way: T, rest: bool, exactly: bool) -> Half<T> {
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

    /// How far a body on a pin gets before it turns, up to twice the way on which it was followed: a margin, for which doubles do. What
    /// spoils the motion further on does not matter.
    pub fn limit(&self, stop: &Stop<T>) -> Option<T> {
        let beyond = || {
            let (scene, start) = (self.mechanism.scene, self.angle(stop.way).f64());
            let n = self.mechanism.n.in_doubles(scene);
            let mechanism = Mechanism::new(scene, &n).ok()?;
            let factor = mechanism.inertia(&mechanism.state(start, true).ok()?);
            let from = Gain { half_square: stop.half_square.f64(), factor };
            let fine = Fine::of::<f64>(scene, true);
            let onward = Motion { fine, ..Motion::new(&mechanism, start, self.sense, from) };
            let next = onward.stop(stop.way.f64(), None, false, &mut []).ok()?;
            (next.why == Why::Rest).then(|| stop.way + T::of(next.way))
        };
        match &self.pendulum {
            _ if stop.half_square.is_zero() => Some(stop.way),
            Some(pendulum) => pendulum.turning(),
            None => T::leading(beyond),
        }
    }

    /// The greatest rate before a body on a pin turns, or on two turns, and at least that of where it stops; infinite where what comes
    /// after that, such as a spring through its anchor, has no speed.
    pub fn fastest(&self, stop: &Stop<T>) -> T {
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
        match self.over(
            (T::zero(), self.variable(self.mechanism.layout.horizon())),
            self.from,
            false,
            &mut visit,
        ) {
            Ok(_) => greatest.scale2(1).root(),
            Err(_) => T::of(f64::INFINITY),
        }
    }

    /// Period and greatest speed of a pendulum from rest by the steps of a rung, where they are wanted.
    pub fn step_through(
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
        teller.count += count;
        teller.replace(Quantity::Period, T::of(2.0 * turned.time));
        teller.replace(Quantity::OmegaMax, T::of(lowest.u));
        Ok(())
    }
}

impl<T: Real> Teller<'_, '_, T> {
    /// Puts another value in the place of what was said of a body on a pin.
    pub fn replace(&mut self, quantity: Quantity, value: T) {
        let value = self.n.publish(quantity, value);
        for said in self.road.said.iter_mut().filter(|s| s.label.quantity == quantity) {
            said.value = value;
        }
    }

    /// A body on a pin under its weight alone, on its way in this sense from a place and with this rate there, by its closed form.
    pub fn pendulum(&self, state: &State<T>, sense: f64, rate: T) -> Option<Pendulum<T>> {
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
    pub fn tell_lasting(&mut self, rate: T) -> Result<(), Refusal> {
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
    pub fn tell_standing(
        &mut self,
        state: &State<T>,
        response: &Response<T>,
        square: T,
    ) -> Result<(), Refusal> {
        let Some(body) = self.pinned else { return Ok(()) };
        let (constant, by_square) = self.mechanism.turning(response, body);
        let scale = self.terms(state);
        self.say_scaled(Quantity::Alpha, Owner::Body(body), constant.balance(by_square * square), scale);
        self.tell_forces(state, response, square, &no_friction(self.scene));
        Ok(())
    }

    /// Magnitudes of the terms of the angular acceleration of a body on a pin.
    pub fn terms(&self, state: &State<T>) -> f64 {
        self.mechanism.drive_of_terms(state).1 / self.mechanism.inertia(state).size()
    }

    /// How a body on a pin has turned.
    pub fn tell_turned(&mut self, way: T, sense: f64, place: &Half<T>) {
        let Some(body) = self.pinned else { return };
        let (of, Some(planar)) = (Owner::Body(body), self.scene.planar(body)) else { return };
        let (start, step) = (self.scene.start_angle(self.n), Half::of_radians(way.signed(sense)));
        // A difference of two heights, as a product.
        let product = (step.sine * place.plus(start).sine).scale2(1);
        let arm = pose::along(self.n, planar.centre);
        let sunk = plant!("eom: height lost by the mass centre", arm) * product;
        let rise = if planar.from == Ray::Up { -sunk } else { sunk };
        self.say_scaled(Quantity::Rise, of, rise, risen(rise.size(), 2.0 * arm.size()));
        if let Some(moment) = self.scene.couple_on(self.n, body) {
            self.say(Quantity::WorkCouple, of, moment.signed(sense) * way);
        }
    }

    /// Momentum and shares of a body on a pin that turns at this rate.
    pub fn tell_spin(&mut self, state: &State<T>, rate: T) {
        let Some(body) = self.pinned else { return };
        let (of, inertia) = (Owner::Body(body), self.mechanism.inertia(state));
        self.say(Quantity::AngularMomentum, of, inertia * rate.abs());
        if !rate.is_zero() {
            self.say(Quantity::RotationalFraction, Owner::Scene, self.n.bodies[body].inertia / inertia);
        }
    }

    /// The force of the pin of a body along its axis, toward the pin, and across, positive with a growing angle.
    /// `scale` is what adds up to it.
    pub fn tell_along(
        &mut self,
        state: &State<T>,
        response: &Response<T>,
        square: T,
        [x, y]: [T; 2],
        scale: f64,
    ) {
        let (mechanism, Some(body)) = (self.mechanism, self.pinned) else { return };
        let ([c, s], sense) = (state.poses[body].axis, self.scene.sense(body));
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
}
