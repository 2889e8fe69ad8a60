//! What the equations of motion say of joined bodies at a place, with the units put back.
use crate::num::dd::pow2;
use crate::num::plant::plant;
use crate::num::{Dd, Real, gauss, root, trig};
use crate::scene::pose::Obstacle;
use crate::scene::{Acts, Label, Owner, Quantity, Spot, pose};
use crate::solve::eom::SMALL;
use crate::solve::eom::joined::{BESIDE, Gain, Motion, PUSHES, SHORT, SHORTEST, Teller, look, meets};
use crate::solve::eom::planar::{Response, State};
use crate::solve::outcome::{Course, Held, Refusal, Said};

/// A way on which springs act is looked at in so many places at least.
const PIECES: f64 = 9.0;

/// An equilibrium is indifferent whose stiffness is below this share of what forces could give it.
const INDIFFERENT: f64 = 1e-9;

/// What accelerations are told of: the response, what adds up on each body to the right and up, and the terms of an angular one.
type Accelerated<'r, T> = (&'r Response<T>, &'r [[f64; 2]], f64);

fn sizes<T: Real>(parts: &[T]) -> f64 {
    parts.iter().map(|part| part.size()).sum()
}

/// The terms of something: where they come to no more than rounding would leave of these loads, those are what cancels.
pub fn beside(terms: f64, loads: f64) -> f64 {
    if loads.is_finite() && terms < f64::EPSILON * loads { loads } else { terms }
}

/// The terms of a rise, a difference of two heights that are no greater than this: it can be worked out from the energy, too.
pub fn risen(rise: f64, height: f64) -> f64 {
    beside(f64::min(SMALL * rise, height), height)
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

impl<T: Real> Teller<'_, '_, T> {
    /// How far the mass centre of a body is above where it began.
    pub fn tell_risen(&mut self, body: usize, from: T, to: T) {
        let size = self.mechanism.size();
        let rise = (to - from).cleared(size);
        self.say_scaled(Quantity::Rise, Owner::Body(body), rise, risen(rise.size(), size));
    }

    pub fn say(&mut self, quantity: Quantity, of: Owner, value: T) {
        self.say_scaled(quantity, of, value, value.size());
    }

    pub fn say_scaled(&mut self, quantity: Quantity, of: Owner, value: T, scale: f64) {
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

    /// The stable equilibrium toward which the bodies set off from rest, and small oscillations about it: `q'' = A'(q_e) (q - q_e)`.
    pub fn tell_equilibrium(&mut self, smooth: &[f64]) -> Result<(), Refusal> {
        let (scene, mechanism) = (self.scene, self.mechanism);
        let at = |way: T| {
            let state = mechanism.state(way, true)?;
            let response = mechanism.respond(&state, smooth)?;
            Ok::<_, Refusal>((state, response))
        };
        let drive = |way: T| Ok(at(way)?.1.lead.0);
        let sense = drive(T::zero())?.sign();
        let full = T::constant(Dd::PI.scale2(1));
        let overruns = |far: T| mechanism.layout.overruns(sense, (far, look()));
        let found = if sense == 0.0 {
            Some(T::zero())
        } else {
            // Beyond its pulley no load has a place.
            let at_pulley = overruns(full).filter(|(_, what)| matches!(what, Obstacle::Pulley(_)));
            let far = at_pulley.map_or(full, |(way, _)| way * T::of(SHORT));
            let found = self.falls_off(far, sense, &|x| Ok(drive(x.signed(sense))?.signed(sense)))?;
            match at_pulley.filter(|_| found.is_none()) {
                Some((_, pulley)) => return Err(Refusal::Beyond(pulley)),
                None => found,
            }
        };
        let stiffness = match found {
            Some(way) => {
                // No difference is taken across a place where a spring is met; just there nothing oscillates evenly.
                let meets = [1.0, -1.0].into_iter().flat_map(|sense| meets(mechanism, sense, full));
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
        self.gets_to(way)?;
        if let Some((_, obstacle)) = overruns(way.abs()) {
            return Err(Refusal::Beyond(obstacle));
        }
        self.tell_met(&meets(mechanism, sense, way.abs()), way.abs())?;
        let (of, frequency) = (Owner::Body(mechanism.lead), stiffness.root());
        self.say(Quantity::OmegaSmall, of, frequency);
        self.say(Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        self.say_scaled(Quantity::Phi, of, mechanism.layout.turned(way.abs()), 1.0);
        let ((first, _), (state, response)) = (at(T::zero())?, at(way)?);
        for b in 0..scene.bodies.len() {
            self.tell_risen(b, mechanism.height(&first, b), mechanism.height(&state, b));
        }
        self.tell_whole(&state);
        self.tell_forces(&state, &response, T::zero(), smooth);
        self.watch(&response, T::zero());
        Ok(())
    }

    /// The first place at which a drive that sets the bodies off no longer does, however shortly: a buffer holds them on a little way.
    fn falls_off(
        &self,
        full: T,
        sense: f64,
        drive: &dyn Fn(T) -> Result<T, Refusal>,
    ) -> Result<Option<T>, Refusal> {
        let met = self.mechanism.layout.meets(true, sense, (full, look()));
        let (stops, look) = (met.into_iter().map(|(_, way)| way).chain([full]), look::<T>().f64());
        let Some([low, high]) = root::leaves(stops, [look, look, PIECES], false, drive, &mut |_| ())? else {
            return Ok(None);
        };
        Ok(Some(root::between_values(low, high, false, drive)?.signed(sense)))
    }

    /// Errors: a place on the way at which the bodies cannot pass, as where a linkage locks.
    pub fn gets_to(&self, way: T) -> Result<(), Refusal> {
        // So near nothing lies between, and doubles do not resolve how the drive falls off.
        if way.size() < BESIDE {
            return Ok(());
        }
        let mechanism = self.mechanism;
        let begin = mechanism.state(T::zero(), true)?;
        let from = Gain { half_square: T::zero(), factor: mechanism.inertia(&begin) };
        let motion = Motion {
            meets: meets(mechanism, way.sign(), way.abs()),
            ..Motion::new(mechanism, T::zero(), way.sign(), from)
        };
        let motion = motion.set_off(&begin)?;
        motion.over((T::zero(), motion.variable(way.abs())), motion.from, false, &mut |_, _| Ok(false))?;
        Ok(())
    }

    /// Is each spring that only pushes or pulls met on this way, if it does not act from the start?
    pub fn tell_met(&mut self, meets: &[(usize, T)], way: T) -> Result<(), Refusal> {
        let begin = self.mechanism.poses(T::zero(), true)?;
        for s in (0..self.scene.struts.len()).filter(|s| self.scene.struts[*s].acts != Acts::Both) {
            let first =
                meets.iter().find(|(strut, _)| *strut == s).map_or(f64::INFINITY, |(_, at)| at.size());
            let layout = &self.mechanism.layout;
            let met = if layout.acts(s, layout.beyond(&begin, s)) { 0.0 } else { first };
            self.road.held.push(Held::Met(s, met, T::leading(|| way.f64())));
        }
        Ok(())
    }

    /// Do the joints that can only push or only pull do so, at this square of the rate?
    pub fn watch(&mut self, response: &Response<T>, square: T) {
        for (j, _) in self.scene.joints.iter().enumerate().filter(|(_, j)| j.kind.is_one_sided()) {
            if let Some(force) = self.mechanism.reaction(response, j, square) {
                let force = self.n.publish(Quantity::Normal, force[0]);
                self.road.held.push(Held::Touching(j, T::leading(|| force.f64()), force.size()));
            }
        }
    }

    /// Do those of them that share a load in a way that statics leaves open carry it? In a blow these are impulses.
    pub fn watch_shares(
        &mut self,
        state: &State<T>,
        response: (&Response<T>, T),
        sliding: &[f64],
        blow: bool,
    ) {
        let told = self.road.held.iter().any(|held| matches!(held, Held::Touching(_, f64::NEG_INFINITY, _)));
        if let Some(joint) = self.mechanism.overloaded(state, response, sliding, blow).filter(|_| !told) {
            let held = if blow { Held::Jolted } else { Held::Touching };
            self.road.held.push(held(joint, f64::NEG_INFINITY, 1.0));
        }
    }

    /// What the moments of all forces about one another come to at most, N m.
    pub fn drives(&self) -> f64 {
        let pushes = self.scene.pushes.iter().filter(|p| !p.blow).map(|p| self.n.massive(p.force_n).size());
        let couples = self.scene.couples.iter().map(|c| self.n.massive(c.moment_n_m).size());
        (self.pulls() + pushes.sum::<f64>()) * self.mechanism.size() + couples.sum::<f64>()
    }

    /// The impulses of the joints at a blow. One that can only push and would have to pull lets go, and the other way round.
    pub fn tell_blow(&mut self, state: &State<T>, jumps: &Response<T>) {
        let all = pose::blows(self.scene, self.n) + self.mechanism.gained(jumps);
        self.watch_shares(state, (jumps, T::zero()), &[], true);
        let on = self.mechanism.adding_up(state, (jumps, T::zero()), true);
        for (j, joint) in self.scene.joints.iter().enumerate() {
            let (of, quantities) = (Owner::Joint(j), joint.kind.impulses());
            let Some(impulses) = self.mechanism.reaction(jumps, j, T::zero()) else {
                self.road.leaves_open(of, quantities);
                continue;
            };
            for (i, (quantity, impulse)) in quantities.iter().zip(&impulses).enumerate() {
                let impulse = plant!("eom: impulse of a joint", *impulse).cleared(impulse.size() + all);
                self.say_scaled(
                    *quantity,
                    of,
                    impulse,
                    beside(self.mechanism.adding_to(state, (j, i), &on), all),
                );
            }
            if joint.kind.is_one_sided() && impulses[0].below(T::of(-PUSHES * all)) {
                let [pull, all] =
                    [impulses[0], T::of(all)].map(|x| self.n.publish(Quantity::Impulse, x).f64());
                self.road.held.push(Held::Jolted(j, pull, all));
            }
        }
    }

    /// Velocities and energy at this rate of what leads, with the accelerations where they are told.
    pub fn tell_motion(&mut self, state: &State<T>, rate: T, response: Option<Accelerated<T>>) {
        let (scene, mechanism) = (self.scene, self.mechanism);
        let mut energy = T::zero();
        // How fast the bodies turn and move at most: beside that a speed is small.
        let turn = |b: usize| (mechanism.spin(state, b) * rate).size();
        let quickest = (0..scene.bodies.len()).map(turn).fold(0.0, f64::max);
        let moves = |b: usize| {
            let centre: f64 = state.rates[b][..2].iter().map(|v| (*v * rate).size()).sum();
            centre + turn(b) * pose::extent(scene, self.n, b)
        };
        let fastest = (0..scene.bodies.len()).map(moves).fold(0.0, f64::max);
        // What is driven moves as it is driven; else accelerations are worked out of that body on which least acts for its mass.
        let moved = |b: usize, force: f64| {
            let mass = self.n.bodies[b].mass.size();
            if mass > 0.0 && scene.driven().is_none() { force / mass } else { f64::INFINITY }
        };
        for (b, body) in scene.bodies.iter().enumerate() {
            let of = Owner::Body(b);
            let [vx, vy] = [0, 1].map(|i| state.rates[b][i] * rate);
            let speed = (vx.square() + vy.square()).root();
            let numbers = self.n.bodies[b];
            energy = energy + numbers.mass * speed.square();
            // Its own are its terms, where it moves at all.
            let fastest = beside(moves(b), fastest);
            self.say_scaled(Quantity::V, of, speed, fastest);
            self.say_scaled(Quantity::VX, of, vx, fastest);
            self.say_scaled(Quantity::VY, of, vy, fastest);
            if let Some((response, on, _)) = response {
                let mut seen = mechanism.acceleration(response, b, rate.square());
                for (a, with) in seen.iter_mut().zip(self.n.carried.iter().flatten()) {
                    *a = a.balance(plant!("eom: acceleration of the carrier in the plane", *with));
                }
                let own = sizes(&seen);
                let of_force =
                    |force: f64| if numbers.mass.is_zero() { own } else { force / numbers.mass.size() };
                let noise = beside(own + of_force(self.pulls()), of_force(self.loads(rate.square())));
                for (i, quantity) in [Quantity::AX, Quantity::AY].into_iter().enumerate() {
                    let least =
                        (0..on.len()).map(|other| moved(other, on[other][i])).fold(f64::INFINITY, f64::min);
                    let terms = if least.is_finite() { f64::max(seen[i].size(), least) } else { own };
                    self.say_scaled(quantity, of, seen[i].cleared(noise), beside(terms, noise));
                }
            }
            if body.turns {
                let spin = mechanism.spin(state, b) * rate;
                energy = energy + numbers.inertia * spin.square();
                if self.pinned.is_none() {
                    let momentum = plant!("eom: angular momentum in the plane", numbers.inertia * spin.abs());
                    let size = numbers.inertia.size() * beside(spin.size(), quickest);
                    self.say_scaled(Quantity::AngularMomentum, of, momentum, size);
                }
                self.say_scaled(Quantity::Omega, of, spin.abs(), beside(spin.size(), quickest));
                if let Some((response, _, terms)) = response {
                    let (constant, by_square) = mechanism.turning(response, b);
                    let alpha = constant.balance(by_square * rate.square());
                    let own = constant.size() + by_square.size() * rate.square().size();
                    let turning = self.loads(rate.square()) * mechanism.size() / numbers.inertia.size();
                    self.say_scaled(Quantity::Alpha, of, alpha, beside(f64::max(own, terms), turning));
                }
            }
            let points = body.planar.as_ref().map_or(0, |p| p.points.len());
            for spot in (0..points).map(|point| Spot { body: b, point }) {
                let [x, y] = mechanism.speed(state, spot).map(|v| v * rate);
                self.say_scaled(Quantity::V, Owner::Spot(spot), (x.square() + y.square()).root(), fastest);
            }
        }
        self.say(Quantity::KineticEnergy, Owner::Scene, energy.scale2(-1));
    }

    /// Everything at a place, at this rate of the leading angle.
    pub fn tell(
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
        // Where several turn, the motion bends the way of one against another.
        let several = self.scene.bodies.iter().filter(|body| body.turns).count() > 1;
        let bends = if several { square.size() } else { 0.0 };
        let all = beside(lead.0.size() + lead.1.size() * square.size() + bends, free);
        // Of a body on a pin its own terms measure them.
        let terms = if self.pinned.is_some() { self.terms(state) } else { all };
        let on = self.mechanism.adding_up(state, (response, square), false);
        self.tell_motion(state, rate, Some((response, &on, terms)));
        self.tell_spin(state, rate);
        self.tell_powers(state, rate, None);
        self.tell_whole(state);
        self.tell_forces(state, response, square, sliding);
        Ok(())
    }

    /// The powers of couples at this rate, with the couple that drives the leading body.
    pub fn tell_powers(&mut self, state: &State<T>, rate: T, drive: Option<(T, f64)>) {
        for body in 0..self.scene.bodies.len() {
            let drives = drive.filter(|_| body == self.mechanism.lead);
            // Of a driven body they are told together.
            let waits = drive.is_none()
                && self.scene.bodies[body].planar.as_ref().is_some_and(|p| p.driven.is_some());
            let own = self.scene.couple_on(self.n, body);
            let size = drives.map_or(0.0, |(_, size)| size) + own.map_or(0.0, |own| own.size());
            let moments = own.into_iter().chain(drives.map(|(moment, _)| moment));
            if let Some(moment) = moments.reduce(T::balance).filter(|_| !waits) {
                let turn = if self.pinned.is_some() { rate } else { self.mechanism.spin(state, body) * rate };
                let fastest = size * f64::max(turn.size(), rate.size());
                self.say_scaled(Quantity::PowerCouple, Owner::Body(body), moment * turn, fastest);
            }
        }
    }

    /// Of bodies that a pin holds and that are welded into one: mass centre, and moments of inertia by the theorem of parallel axes.
    fn tell_whole(&mut self, state: &State<T>) {
        let (n, mechanism, of) = (self.n, self.mechanism, Owner::Scene);
        let Some(pin) = self.scene.only_pin().filter(|_| self.pinned.is_none()) else { return };
        // Mass, first moments and moment of inertia about a point.
        let about = |at: [T; 2]| {
            let mut sums = [T::zero(); 4];
            for (b, own) in n.bodies.iter().enumerate() {
                let [x, y] = pose::less(mechanism.centre(&state.poses, b), at);
                let parts = [own.mass, own.mass * x, own.mass * y, own.inertia + own.mass * (x * x + y * y)];
                sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum = *sum + part);
            }
            sums
        };
        let at = mechanism.layout.spot(pin, &state.poses);
        let [mass, x, y, inertia] = about(at);
        let centre = [at[0] + x / mass, at[1] + y / mass];
        let size = mechanism.size();
        self.say(Quantity::IO, of, plant!("eom: inertia about the only pin", inertia));
        self.say(Quantity::IG, of, about(centre)[3]);
        for (quantity, x) in [Quantity::XG, Quantity::YG].into_iter().zip(centre) {
            self.say_scaled(quantity, of, x, size);
        }
    }

    /// Forces that may cancel wherever a force or an acceleration vanishes.
    pub fn pulls(&self) -> f64 {
        pose::pulls(self.scene, self.n)
    }

    /// Forces that may cancel where nothing has a weight, at this square of the rate of the leading angle: what drives, and what
    /// keeps masses on their ways; 0 of a body on a pin, which its own terms measure.
    pub fn loads(&self, square: T) -> f64 {
        let size = self.mechanism.size();
        let masses: f64 = self.n.bodies.iter().map(|b| b.mass.size()).sum();
        if size > 0.0 && self.pinned.is_none() {
            let driven = self.scene.driven().map_or(0.0, |alpha| self.n.get(alpha).size());
            self.drives() / size + masses * size * (square.size() + driven)
        } else {
            0.0
        }
    }

    /// The forces of joints and springs at this square of the rate of the leading angle.
    pub fn tell_forces(&mut self, state: &State<T>, response: &Response<T>, square: T, sliding: &[f64]) {
        let (scene, mechanism, pulls) = (self.scene, self.mechanism, self.pulls());
        let loads = self.loads(square);
        let on = self.mechanism.adding_up(state, (response, square), false);
        for (j, joint) in scene.joints.iter().enumerate() {
            let of = Owner::Joint(j);
            let quantities = joint.kind.forces();
            let Some(mut force) = mechanism.reaction(response, j, square) else {
                self.road.leaves_open(of, quantities);
                continue;
            };
            for f in &mut force {
                *f = f.cleared(beside(f.size() + pulls, loads));
            }
            // Where nothing adds up along it, what adds up across is left to measure it by.
            let adding = |i: usize| mechanism.adding_to(state, (j, i), &on);
            let whole = beside((0..force.len().min(2)).map(adding).sum(), pulls + loads);
            let along = |i: usize| beside(adding(i), whole);
            let turning = |body: usize| (on[body][0] + on[body][1]) * pose::extent(scene, self.n, body);
            for (i, (quantity, force)) in quantities.iter().zip(&force).enumerate() {
                let terms = if *quantity == Quantity::Moment {
                    let least =
                        joint.kind.spots().map(|spot| turning(spot.body)).fold(f64::INFINITY, f64::min);
                    beside(force.size() + least, loads * mechanism.size())
                } else {
                    along(i)
                };
                self.say_scaled(*quantity, of, *force, terms);
            }
            if let (Some(mu), [normal]) = (joint.kind.mu_k(), force.as_slice()) {
                let up = pose::upward(mechanism.line(state, j));
                let most = plant!("eom: friction that is told", self.n.get(mu)) * *normal;
                let friction = -most.signed(sliding[j]).signed(up);
                self.say_scaled(Quantity::Friction, of, friction, along(0) * self.n.get(mu).size());
            }
            if let (&[x, y, ..], [_, Quantity::PinY, ..]) = (force.as_slice(), quantities) {
                let terms = whole;
                self.tell_along(state, response, square, [x, y], terms);
                let force = (x.square() + y.square()).root();
                self.say_scaled(Quantity::PinForce, of, force, terms);
                if self.asked.quantities.has(Quantity::PinAngle) && !force.is_zero() {
                    self.say_scaled(Quantity::PinAngle, of, trig::angle(y, x), terms / force.size());
                }
            }
        }
        self.watch_shares(state, (response, square), sliding, false);
        for (s, strut) in scene.struts.iter().enumerate() {
            let (of, force) = (Owner::Strut(s), mechanism.tension(state, s));
            let terms = force.size() + mechanism.measure(s);
            if strut.twists() {
                self.say_scaled(Quantity::Moment, of, -force, terms);
            } else {
                self.say_scaled(Quantity::SpringForce, of, force, terms);
            }
        }
    }
}
