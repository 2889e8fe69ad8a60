//! The motion of a pinned body from its balance of energies: speed from the work done, time from the speed.
//!
//! Under its weight alone the time is Legendre's integral of the first kind, here by the arithmetic-geometric mean, its
//! amplitude from the addition theorem of the elliptic functions. With a couple or a spring it is a quadrature in an angle
//! whose cosine is the place: the root singularities at the ends of a swing are gone. Near an end at rest the kinetic
//! energy is the work on the way back from there.
use crate::num::half::Half;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Real, ball, elliptic, gauss, root, trig};
use crate::scene::{End, Label, Numbers, Owner, Pin, Quantity, Scene, Start};
use crate::solve::energy::pinned::{Store, Terms, sum};
use crate::solve::energy::quadrature::Leg;
use crate::solve::outcome::{Course, Refusal, Road, Said, Scope};
use std::cell::Cell;

/// A motion is followed for two turns.
const TURNS: f64 = 2.0;
/// Step in which ends of the swing are looked for, radians.
const STEP: f64 = 0.125;
/// The least step, where the power may change its sign twice within one: 2^-33.
const LEAST: f64 = 1.0 / (1u64 << 33) as f64;
/// Refinements in one search: a power that is 0 over a whole way needs none.
const REFINED: u32 = 500;

/// Doubles decide whether an energy is reached where none that was looked at is nearer to it than this share of its terms.
const CLEAR: f64 = 1e-9;
/// A place that doubles found is good if its first correction is below this share of the way, 2^-40: the second one then leaves
/// nothing.
const CORRECTED: f64 = 1.0 / (1u64 << 40) as f64;

/// The motion: from where, which way, with what kinetic energy.
#[derive(Debug, Clone, Copy)]
struct Motion<'c, T> {
    store: Store<T>,
    from: Half<T>,
    sense: f64,
    /// Kinetic energy at the start.
    energy0: T,
    /// How often a balance has been drawn up.
    balances: &'c Cell<u64>,
}

/// What work and energy say of a scene with a pinned body, without times that are not asked: they are integrals of their own. With
/// `points`, speed and time at the end come from the work of the forces, summed by quadratures of so many points; what that cost.
///
/// Errors: a quadrature that does not settle.
pub fn road_by<T: Real>(
    scene: &Scene,
    n: Numbers<T>,
    (body, pin): (usize, &Pin),
    asked: Scope,
    points: Option<usize>,
) -> Result<(Road<T>, Count), Refusal> {
    let store = Store::new(scene, &n, body, pin);
    let spins = scene.start.iter().filter_map(|s| match s {
        Start::Speed(c, w) if c.body == body => Some(n.get(*w)),
        _ => None,
    });
    let spin = spins.last().unwrap_or_else(T::zero);
    let powers = store.powers(&store.start);
    let sense = if spin.is_zero() { sum(&powers).sign() } else { spin.sign() };
    let energy0 = (store.doubled * spin.square()).scale2(-1);
    let balances = Cell::new(0);
    let motion = Motion { store, from: store.start, sense, energy0, balances: &balances };
    let mut book = Book { n: &n, body, asked, road: Road::new(Scope::ALL) };
    let free = scene.is_pendulum() && !store.frequency().is_zero();
    book.say(Quantity::IO, store.doubled);
    if free {
        let frequency = store.frequency();
        book.say(Quantity::OmegaSmall, frequency);
        book.say(Quantity::PeriodSmall, T::constant(Dd::PI.scale2(1)) / frequency);
        if asked.any(&[Quantity::Period, Quantity::OmegaMax]) {
            let (period, fastest) = motion.period();
            book.say(Quantity::Period, period);
            book.say(Quantity::OmegaMax, fastest);
        }
    }
    if matches!(scene.end, End::AtOnce) {
        book.state(&store, &store.start, spin.abs());
        return Ok((book.road, Count::default()));
    }
    if sense == 0.0 {
        book.road.course = Some(Course::at_rest());
        book.forces(&store, &store.start, T::zero());
        return Ok((book.road, Count::default()));
    }
    let (turning, at_rest) = match (free, free.then(|| motion.free_turning()).flatten()) {
        (true, Some((way, place))) => (Some(way), Some(place)),
        (true, None) => (None, None),
        (false, _) => (motion.turning(scene, &n)?, None),
    };
    let limit = turning.unwrap_or_else(|| T::of(f64::INFINITY));
    let end = motion.asked(scene, &n, free, turning)?;
    // The turning point is where it is: no comparison with itself.
    let turns = matches!(scene.end, End::TurningPoint(_));
    let reached = end.filter(|q| turns || q.not_negative() && q.at_most(limit));
    // The drive is for margins alone: what is proved hangs on no sign of its parts.
    let drive = ball::unwatched(|| {
        powers.iter().fold((T::zero(), T::zero()), |(push, hold), power| {
            let power = power.signed(sense);
            if power.sign() > 0.0 { (push + power, hold) } else { (push, hold - power) }
        })
    });
    book.road.course = Some(Course { sense, drive, asked: end, farthest: limit, reached: reached.is_some() });
    let Some(way) = reached else {
        book.forces(&store, &store.start, spin.square());
        return Ok((book.road, Count::default()));
    };
    let ends = turns || way.side(limit) == 0.0;
    let place = match scene.end {
        // The angle itself is printed; the way to it would round it.
        End::Angle(_, angle) => Half::of_degrees(n.get(angle)),
        // A hair from the top the way to it would round off the hair.
        _ => at_rest.filter(|_| ends).unwrap_or_else(|| motion.place(way)),
    };
    let mut count = Count::default();
    let (speed, time) = if let Some(points) = points {
        let ((speed, time), evaluations) = motion.summed(way, ends, turning, points);
        count.evaluations = evaluations;
        (speed, Some(time))
    } else {
        balances.set(0);
        let speed = if ends { T::zero() } else { motion.speed(way, &place) };
        let time = match asked.quantities.has(Quantity::T) {
            false => None,
            true if free => {
                // What rounding leaves open of the time is open of nothing else.
                let (time, doubt) = ball::watch(|| motion.free_time(&place, way, speed));
                Some(if doubt { time.widened(|| f64::INFINITY) } else { time })
            }
            true => Some(motion.time(way, ends)?),
        };
        count.evaluations = balances.get();
        (speed, time)
    };
    if let Some(time) = time {
        book.say_of(Quantity::T, Owner::Scene, time);
    }
    book.say(Quantity::Phi, way);
    let step = Half::of_radians(way.signed(sense));
    let lost = plant!("energy: fall of the mass centre", store.fallen(&store.start, &place, &step));
    book.say(Quantity::Rise, -lost);
    book.state(&store, &place, speed);
    // Of each couple, over the turn in its own sense.
    let couples = scene.couples.iter().map(|c| {
        let moment = n.massive(c.moment_n_m);
        if c.forward { moment } else { -moment }
    });
    if let Some(moment) = couples.reduce(T::balance) {
        book.say(Quantity::WorkCouple, moment * way.signed(sense));
        book.say(Quantity::PowerCouple, moment * speed.signed(sense));
    }
    Ok((book.road, count))
}

/// What is said, with the units put back.
struct Book<'a, T: Real> {
    n: &'a Numbers<'a, T>,
    body: usize,
    /// What decides more than its own value is said where it is asked alone.
    asked: Scope,
    road: Road<T>,
}

impl<T: Real> Book<'_, T> {
    fn say_of(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.road.said.push(Said::of(self.n, Label { quantity, of }, value, value.size()));
    }
    fn say(&mut self, quantity: Quantity, value: T) {
        self.say_of(quantity, Owner::Body(self.body), value);
    }
    fn forces(&mut self, store: &Store<T>, place: &Half<T>, square: T) {
        self.say(Quantity::Alpha, store.rate(place));
        let (toward, across) = store.held(place, square);
        let (toward, across) = (sum(&toward), sum(&across));
        self.say(Quantity::PinRadial, toward);
        self.say(Quantity::PinTangential, across);
        let force = (toward.square() + across.square()).root();
        self.say(Quantity::PinForce, force);
        // What the force does in a unit displacement to the side, and in one upward.
        let sense = if store.is_upright() { 1.0 } else { -1.0 };
        let (sine, cosine) = (place.full_sine(), place.full_cosine());
        let side =
            plant!("energy: pin in a displacement to the side", (across * cosine).balance(-(toward * sine)));
        let lift = plant!("energy: pin in a displacement upward", -(toward * cosine).balance(across * sine));
        self.say(Quantity::PinX, side);
        self.say(Quantity::PinY, lift.signed(sense));
        if self.asked.quantities.has(Quantity::PinAngle) && !force.is_zero() {
            self.say(Quantity::PinAngle, trig::angle(lift.signed(sense), side));
        }
        if let Some(force) = store.spring_force(place) {
            self.say(Quantity::SpringForce, force);
        }
    }
    fn state(&mut self, store: &Store<T>, place: &Half<T>, speed: T) {
        self.say(Quantity::Omega, speed);
        self.say(Quantity::AngularMomentum, store.doubled * speed);
        self.say(Quantity::V, store.arm * speed);
        self.say_of(Quantity::KineticEnergy, Owner::Scene, (store.doubled * speed.square()).scale2(-1));
        if self.asked.quantities.has(Quantity::RotationalFraction) && !speed.is_zero() {
            let own = self.n.bodies[self.body].inertia;
            self.say_of(Quantity::RotationalFraction, Owner::Scene, own / store.doubled);
        }
        self.forces(store, place, speed.square());
    }
}

impl<'c, T: Real> Motion<'c, T> {
    fn place(&self, way: T) -> Half<T> {
        self.from.plus(Half::of_radians(way.signed(self.sense)))
    }
    /// Kinetic energy at a place.
    fn energy(&self, way: T, place: &Half<T>) -> T {
        sum(&self.balance(way, place))
    }
    /// Its terms.
    fn balance(&self, way: T, place: &Half<T>) -> Terms<T> {
        self.balances.set(self.balances.get() + 1);
        let turned = way.signed(self.sense);
        let mut terms = self.store.work(&self.from, place, &Half::of_radians(turned), turned);
        terms.push(self.energy0);
        terms
    }
    fn speed_of(&self, energy: T) -> T {
        (energy.scale2(1) / self.store.doubled).root()
    }
    fn speed(&self, way: T, place: &Half<T>) -> T {
        self.speed_of(self.energy(way, place))
    }
    /// Power at a place per unit rate along the motion.
    fn power(&self, place: &Half<T>) -> T {
        sum(&self.store.powers(place)).signed(self.sense)
    }
    /// The farthest that a motion without a turning point is followed.
    fn horizon() -> T {
        T::constant(Dd::PI * Dd::new(2.0 * TURNS))
    }

    // -- ends -----------------------------------------------------------------------------------------------------------

    /// The angle to be turned until the event, radians.
    fn asked(
        &self,
        scene: &Scene,
        n: &Numbers<T>,
        free: bool,
        turning: Option<T>,
    ) -> Result<Option<T>, Refusal> {
        Ok(match scene.end {
            End::Angle(_, angle) => Some(self.way_to(scene, n.get(angle), n)),
            End::TurningPoint(_) => turning,
            End::Time(_, t) => {
                let last = turning.unwrap_or_else(Self::horizon);
                let most = self.duration(last, free, turning.is_some())?;
                let t = n.get(t);
                match t.side(most) {
                    0.0 => Some(last),
                    s if s < 0.0 => Some(self.way_after(t, last, free)?),
                    _ => None,
                }
            }
            End::Speed(_, w) => {
                let wanted = n.get(w).square() * self.store.doubled;
                self.way_to_energy(wanted.scale2(-1), turning.unwrap_or_else(Self::horizon))?
            }
            End::AtOnce
            | End::Travel(..)
            | End::Position(..)
            | End::Rolling(_)
            | End::Leaves(_)
            | End::Equilibrium => None,
        })
    }

    /// The way to an angle in degrees, radians.
    fn way_to(&self, scene: &Scene, angle: T, n: &Numbers<T>) -> T {
        let start = scene.pinned().map_or_else(T::zero, |(_, pin)| n.get(pin.start_deg));
        ((angle - start) * T::constant(Dd::PI / Dd::new(180.0))).signed(self.sense)
    }

    fn duration(&self, way: T, free: bool, rest: bool) -> Result<T, Refusal> {
        if free {
            let place = self.place(way);
            let speed = if rest { T::zero() } else { self.speed(way, &place) };
            Ok(self.free_time(&place, way, speed))
        } else {
            self.time(way, rest)
        }
    }

    fn way_after(&self, time: T, last: T, free: bool) -> Result<T, Refusal> {
        let way = ball::unwatched(|| {
            root::between(T::zero(), last, true, |way| {
                let slowness = T::of(1.0) / self.speed(way, &self.place(way));
                Ok::<_, Refusal>((self.duration(way, free, false)? - time, slowness))
            })
        })?;
        // The data take part in the last step.
        Ok(way + (time - self.duration(way, free, false)?) * self.speed(way, &self.place(way)))
    }

    fn way_to_energy(&self, energy: T, last: T) -> Result<Option<T>, Refusal> {
        if energy.side(self.energy0) == 0.0 {
            return Ok(Some(T::zero()));
        }
        let found = self.located(energy, last)?;
        Ok(found.map(|way| {
            let place = self.place(way);
            way - (self.energy(way, &place) - energy) / self.power(&place)
        }))
    }

    /// Where all energy is stored or spent; `None` if not within two turns, nor within twice the way that is asked.
    fn turning(&self, scene: &Scene, n: &Numbers<T>) -> Result<Option<T>, Refusal> {
        let last = match scene.end {
            End::Angle(_, angle) => self.way_to(scene, n.get(angle), n).scale2(1),
            _ => T::constant(Dd::PI * Dd::new(2.0 * TURNS)),
        };
        let found = self.located(T::zero(), last)?;
        Ok(found.map(|way| {
            let place = self.place(way);
            let power = self.power(&place);
            if power.is_zero() { way } else { way - self.energy(way, &place) / power }
        }))
    }

    /// Speed and time at a place by the work of all forces over the angle, and how often these were evaluated.
    fn summed(&self, way: T, ends: bool, turning: Option<T>, points: usize) -> ((T, T), u64) {
        let evaluations = Cell::new(0);
        let force = |way: T| {
            evaluations.set(evaluations.get() + 1);
            self.power(&self.place(way))
        };
        let leg = Leg { force: &force, doubled: self.store.doubled, points };
        let u0 = leg.speed(self.energy0);
        let work = way * leg.mean(T::zero(), way);
        let speed = if ends { T::zero() } else { leg.speed(self.energy0.balance(work)) };
        let time = if way.is_zero() {
            T::zero()
        } else if self.energy0.is_zero() {
            leg.from_rest(way, turning)
        } else {
            leg.onward((T::zero(), u0), (way, speed), turning)
        };
        ((speed, time), evaluations.get())
    }

    // -- time by quadrature ---------------------------------------------------------------------------------------------

    /// Time over a way, which ends at rest or not.
    fn time(&self, way: T, rest: bool) -> Result<T, Refusal> {
        if way.is_zero() {
            return Ok(T::zero());
        }
        // A quadrature settles, it proves nothing: where only what is proved counts, there is nothing to sum.
        let open = T::of(1.0).widened(|| f64::INFINITY);
        if open.radius() > 0.0 {
            return Ok(open);
        }
        let quarter = T::constant(Dd::PI.scale2(-2));
        let started = !self.energy0.is_zero();
        // The way back from an end at rest.
        let back = Motion { from: self.place(way), sense: -self.sense, energy0: T::zero(), ..*self };
        gauss::integral(
            |s: T| {
                // From rest to rest q = way sin^2, from rest q = 2 way sin^2 of half the angle; to rest from the end.
                let (sine, cosine) = trig::turn(s * quarter);
                let (double, level) = ((sine * cosine).scale2(1), cosine.square() - sine.square());
                let (gone, left, slope) = match (started, rest) {
                    (false, false) => {
                        let gone = (way * sine.square()).scale2(1);
                        (gone, way - gone, (way * double).scale2(1))
                    }
                    (true, false) => (way * double, way * (T::of(1.0) - double), (way * level).scale2(1)),
                    (true, true) => {
                        let left = (way * sine.square()).scale2(1);
                        (way - left, left, (way * double).scale2(1))
                    }
                    (false, true) => {
                        let (gone, left) = (way * double.square(), way * level.square());
                        (gone, left, (way * double * level).scale2(2))
                    }
                };
                let energy = if rest && left.below(gone) {
                    back.energy(left, &back.place(left))
                } else {
                    self.energy(gone, &self.place(gone))
                };
                let speed = self.speed_of(plant!("energy: kinetic energy on the way", energy));
                Ok(slope * quarter / speed)
            },
            T::zero(),
            T::of(1.0),
        )
    }

    // -- under the weight alone -----------------------------------------------------------------------------------------

    /// Sine and cosine of half the angle from hanging, growing on the way, and the pace `omega / (2 frequency)`.
    fn bob(&self) -> (T, T, T) {
        let hanging = if self.store.is_upright() { self.from.less_half_turn() } else { self.from };
        let pace = (self.speed_of(self.energy0) / self.store.frequency()).scale2(-1);
        let (sine, cosine) = (hanging.sine.signed(self.sense), hanging.cosine);
        // Beyond the top it is a turn further on: both signs are those of the same place between top and top.
        let beyond = cosine.sign() < 0.0 || (cosine.is_zero() && sine.sign() > 0.0);
        if beyond { (-sine, -cosine, pace) } else { (sine, cosine, pace) }
    }

    /// Sine and cosine of half the angle at a place, with the signs that they have on the way there from (s0, c0).
    fn end_of(&self, place: &Half<T>, way: T, s0: T, c0: T) -> (T, T) {
        let hanging = if self.store.is_upright() { place.less_half_turn() } else { *place };
        let (sine, cosine) = (hanging.sine.signed(self.sense), hanging.cosine);
        // Which of the two signs: the half angle is that of the start and half the way, roughly.
        let half = trig::atan2(s0, c0).f64() + 0.5 * way.f64();
        let (s, c) = trig::sin_cos_radians(Dd::new(half));
        let same = s.hi * sine.f64() + c.hi * cosine.f64();
        if same < 0.0 { (-sine, -cosine) } else { (sine, cosine) }
    }

    /// Energy from the lowest place as a share of that at the top: `k^2`, and `1 - k^2` with its root.
    fn share(sine: T, cosine: T, pace: T) -> (T, T, T) {
        if pace.is_zero() {
            return (sine.square(), cosine.square(), cosine);
        }
        let rest = cosine.square().balance(-pace.square());
        (sine.square() + pace.square(), rest, rest.root())
    }

    /// The way to the place at rest, and that place.
    fn free_turning(&self) -> Option<(T, Half<T>)> {
        let (sine, cosine, pace) = self.bob();
        let (_, rest, complement) = Self::share(sine, cosine, pace);
        if rest.sign() < 0.0 {
            return None;
        }
        // It turns where half the angle has the sine k.
        let k = if pace.is_zero() { sine.abs() } else { (sine.square() + pace.square()).root() };
        let across = (k * cosine).balance(-(complement * sine));
        let way = trig::angle(across, (complement * cosine).balance(k * sine)).scale2(1);
        let hanging = Half { sine: k.signed(self.sense), cosine: complement };
        // From upright it is half a turn more; and a whole turn more or less, as the way there has it.
        let place = if self.store.is_upright() {
            hanging.less_half_turn().less_half_turn().less_half_turn()
        } else {
            hanging
        };
        let roughly = self.place(way);
        let same = place.sine * roughly.sine + place.cosine * roughly.cosine;
        let whole = if same.sign() < 0.0 { place.less_half_turn().less_half_turn() } else { place };
        Some((way, whole))
    }

    /// Period, and greatest angular speed, from the energy at the lowest place.
    fn period(&self) -> (T, T) {
        let (sine, cosine, pace) = self.bob();
        let (k2, rest, complement) = Self::share(sine, cosine, pace);
        let k = if pace.is_zero() { sine.abs() } else { k2.root() };
        let frequency = self.store.frequency();
        let fastest = (k * frequency).scale2(1);
        let quarters = if rest.sign() < 0.0 {
            (elliptic::complete((-rest).root() / k) / k).scale2(1)
        } else {
            elliptic::complete(complement).scale2(2)
        };
        (quarters / frequency, fastest)
    }

    fn free_time(&self, place: &Half<T>, way: T, speed: T) -> T {
        if way.is_zero() {
            return T::zero();
        }
        let (s0, c0, p0) = self.bob();
        let (s1, c1) = self.end_of(place, way, s0, c0);
        let frequency = self.store.frequency();
        let p1 = (speed / frequency).scale2(-1);
        let (k2, rest, complement) = Self::share(s0, c0, p0);
        let integral = if rest.sign() < 0.0 {
            // Over the top: modulus 1/k; the amplitude is half the angle.
            let k = k2.root();
            let across = k * (s1 * c0 * p0).balance(-(s0 * c1 * p1));
            let along = (k2 * c0 * c1).balance(s0 * s1 * p0 * p1);
            let complement = (-rest).root() / k;
            // The way of a turn is half a turn of the amplitude.
            let turn = || elliptic::complete(complement).scale2(2);
            let part = match (across.sign() < 0.0, way.f64() > 3.0 * std::f64::consts::PI) {
                (true, _) => turn() - elliptic::incomplete(-across, along, complement),
                (false, false) => elliptic::incomplete(across, along, complement),
                (false, true) => turn() + elliptic::incomplete(across, along, complement),
            };
            part / k
        } else if p0.is_zero() {
            // From rest, without the common factors, which may be very small.
            elliptic::incomplete(p1, -(s1 * c0), complement)
        } else {
            let across = (s1 * p0 * c0).balance(-(s0 * p1 * c1));
            let along = (p0 * p1).balance(s0 * s1 * c0 * c1);
            elliptic::incomplete(across, along, complement)
        };
        plant!("energy: time of the swing", integral) / frequency
    }
}

impl<T: Real> Motion<'_, T> {
    /// The first way, up to `last`, at which the kinetic energy is at this level, coming from where it is now: to a correction by
    /// Newton's method, in which the data take part. It is searched in doubles where they can tell.
    fn located(&self, level: T, last: T) -> Result<Option<T>, Refusal> {
        if !T::is_double() {
            let doubles = Motion {
                store: self.store.doubles(),
                from: Half { sine: self.from.sine.f64(), cosine: self.from.cosine.f64() },
                sense: self.sense,
                energy0: self.energy0.f64(),
                balances: self.balances,
            };
            if let Ok((found, true)) = doubles.first_at(level.f64(), last.f64()) {
                let Some(way) = found.map(T::of) else { return Ok(None) };
                let place = self.place(way);
                let step = ((self.energy(way, &place) - level) / self.power(&place)).value();
                if step.hi.abs() <= CORRECTED * way.size() {
                    return Ok(Some(way - T::constant(step)));
                }
            }
        }
        ball::unwatched(|| self.first_at(level, last)).map(|(found, _)| found)
    }

    /// The same by a search in this number type, and whether no comparison in it was close.
    fn first_at(&self, level: T, last: T) -> Result<(Option<T>, bool), Refusal> {
        let falling = level.is_zero() || level.below(self.energy0);
        let over = |energy: T| {
            let side = (energy - level).sign();
            if falling { side <= 0.0 } else { side >= 0.0 }
        };
        let mut low = T::zero();
        let (mut start, mut drive) = (self.from, self.power(&self.from));
        let (mut width, mut refined) = (STEP, 0);
        let (mut clear, mut most) = (true, 0.0);
        while low.below(last) {
            let ahead = |width: f64| {
                let step = low + T::of(width);
                let high = if step.below(last) { step } else { last };
                let place = self.place(high);
                (high, place, self.power(&place))
            };
            let (mut high, mut place, mut next) = ahead(width);
            while width > LEAST
                && refined < REFINED
                && !self.turns_once((&start, drive), (&place, next), width)
            {
                (width, refined) = (0.5 * width, refined + 1);
                (high, place, next) = ahead(width);
            }
            width = f64::min(2.0 * width, STEP);
            let mut marks = [None, Some(high)];
            if drive.sign() * next.sign() < 0.0 {
                // The energy has a peak or a dip within the step.
                let turn = root::between(low, high, next.sign() > 0.0, |way| {
                    Ok::<_, Refusal>((self.power(&self.place(way)), T::zero()))
                })?;
                marks[0] = Some(turn);
            }
            let mut from = low;
            for mark in marks.into_iter().flatten() {
                let terms = self.balance(mark, &self.place(mark));
                let energy = sum(&terms);
                most = terms.iter().fold(most, |most: f64, t| most.max(t.size()));
                // NaN is not clear.
                clear &= (energy - level).size() > CLEAR * (most + level.size());
                if over(energy) {
                    return root::between(from, mark, !falling, |way| {
                        let place = self.place(way);
                        Ok((self.energy(way, &place) - level, self.power(&place)))
                    })
                    .map(|found| (Some(found), clear));
                }
                from = mark;
            }
            (low, start, drive) = (high, place, next);
        }
        Ok((None, clear))
    }

    /// Is it certain that the power changes its sign at most once between two places? It is off the chord by at most an
    /// eighth of its second derivative times the square of the width: too little to reach 0, or to bend back.
    fn turns_once(&self, (start, first): (&Half<T>, T), (end, last): (&Half<T>, T), width: f64) -> bool {
        let sag = self.store.bend(start, end) * (width * width);
        if first.sign() * last.sign() > 0.0 {
            let (a, b) = (first.size(), last.size());
            return sag * 0.125 <= if a < b { a } else { b };
        }
        sag <= (last - first).size()
    }
}
