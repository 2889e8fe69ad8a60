//! What work and energy say of joined bodies at a place, and of the equilibrium toward which they set off.
use crate::num::plant::plant;
use crate::num::{Dd, Real, ball, trig};
use crate::scene::pose::{self, dot};
use crate::scene::{Acts, Label, Owner, Quantity, Spot};
use crate::solve::energy::joined::{Accelerations, Account, Motion, Poses, STEP, Vector, right};
use crate::solve::outcome::{Course, Refusal, Road, Said};

impl<T: Real> Account<'_, T> {
    pub fn say(&self, road: &mut Road<T>, quantity: Quantity, of: Owner, value: T) {
        use Quantity::{AX, AY, VX, VY};
        let apart = matches!(quantity, VX | VY | AX | AY) || matches!(of, Owner::Spot(_));
        if apart && self.pinned {
            return;
        }
        let of = if self.pinned && matches!(of, Owner::Strut(_)) { Owner::Body(self.lead) } else { of };
        road.said.push(Said::of(self.n, Label { quantity, of }, value, value.size()));
    }

    /// Everything at a place where the leading angle has this rate and this second derivative.
    pub fn tell(&self, poses: &Poses<T>, rate: T, second: T, road: &mut Road<T>) -> Result<(), Refusal> {
        let rates = self.rates(poses);
        let square = rate.square();
        let moves = |b: usize, along: T| self.accelerates(poses, b, along, second, square);
        let turning = |b: usize| {
            let (first, bend) = poses[b].turn();
            if self.pinned {
                second.signed(self.scene.sense(b))
            } else {
                (first * second).balance(bend * square)
            }
        };
        let moving = rates.iter().map(|r| r.map(|x| x * rate)).collect();
        if self.pinned {
            self.tell_motion(poses, &moving, Some((&moves, &turning)), road);
            self.tell_spin(poses, rate, road);
            self.tell_pin(poses, second, square, road);
            self.tell_springs(poses, road);
            return Ok(());
        }
        self.all(poses, &moving, &moves, &turning, road)
    }

    /// How the power of all forces at unit rate of the leading angle changes with that angle: less `V''`.
    pub fn softens(&self, poses: &Poses<T>) -> T {
        let second = |p: pose::Point<T>| p.map(|x| x.second);
        let first = |p: pose::Point<T>| p.map(|x| x.first);
        let mut sum = T::zero();
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let bend = second(self.centre(poses, b));
            sum =
                sum - plant!("energy: weight on the bend of a way", numbers.mass * self.n.gravity * bend[1]);
            if let Some(a) = self.n.carried {
                sum = sum - plant!("energy: carrier on the bend of a way", numbers.mass * dot(a, bend));
            }
        }
        for (i, push) in self.scene.pushes.iter().enumerate().filter(|(_, push)| !push.blow) {
            if let Some(place) = push.toward_m {
                sum = sum - self.n.massive(push.force_n) * self.layout.distance(poses, push.at, place).second;
                continue;
            }
            let (at, u) = (self.point(poses, push.at), self.layout.push(poses, i));
            let turn = if push.turns { poses[push.at.body].turn().0 } else { T::zero() };
            let turned = [-u[1] * turn, u[0] * turn];
            sum = sum + self.n.massive(push.force_n) * (dot(u, second(at)) + dot(turned, first(at)));
        }
        for c in &self.scene.couples {
            let bend = poses[c.body].turn().1.signed(self.scene.sense(c.body));
            sum = sum + self.n.massive(c.moment_n_m) * c.signed(bend);
        }
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.layout.natural).enumerate() {
            if !self.layout.acts(s, self.layout.beyond(poses, s)) {
                continue;
            }
            // Of (l - l0)^2 / 2 the square of the length bends evenly where the spring is at its anchor, the length does not.
            let [x, y] = self.layout.span(poses, s);
            let mut bend = (x * x + y * y).second.scale2(-1);
            if !natural.is_zero() {
                bend = bend - *natural * self.layout.length(poses, s).second;
            }
            sum = sum
                - plant!("energy: spring on the bend of a way", self.n.massive(strut.stiffness_n_m)) * bend;
        }
        sum
    }

    /// The stable equilibrium toward which the bodies set off from rest, where the potential energy is least, and small oscillations
    /// about it: `omega^2 = V'' / M`.
    pub fn rest(&mut self, road: &mut Road<T>) -> Result<(), Refusal> {
        let power = |account: &Self, way: T| {
            let poses = account.poses(way)?;
            let balance = account.balance(&poses, &account.rates(&poses))?;
            Ok::<_, Refusal>(balance.force)
        };
        let sense = power(self, T::zero())?.sign();
        let full = T::constant(Dd::PI.scale2(1));
        let found = if sense == 0.0 {
            Some(T::zero())
        } else {
            self.sense = sense;
            self.meets = ball::unwatched(|| self.springs_met(true));
            self.sense = 1.0;
            let way = self.first(full, false, &|way| Ok(power(self, way.signed(sense))?.signed(sense)))?;
            way.map(|way| way.signed(sense))
        };
        let stiffness = match found {
            Some(way) => {
                let poses = self.poses(way)?;
                let stiff = -self.softens(&poses);
                // Where it is indifferent, rounding is left of it; where a spring is just met, it is not even.
                let size = pose::size(self.scene, self.n);
                let nothing = 1e-9 * pose::pulls(self.scene, self.n) * size;
                let met = |s: usize| {
                    let apart = self.layout.length(&poses, s).value - self.layout.natural[s];
                    self.scene.struts[s].acts != Acts::Both && apart.size() < 1e-12 * size
                };
                let met = (0..self.layout.natural.len()).any(met);
                if T::of(nothing).below(stiff) && !met { stiff / self.inertia(&poses) } else { T::zero() }
            }
            None => T::zero(),
        };
        let (Some(way), true) = (found, stiffness.sign() > 0.0) else {
            road.course = Some(Course::nowhere());
            return Ok(());
        };
        self.sense = if sense == 0.0 { 1.0 } else { sense };
        let wound = self.overruns((way.abs(), T::of(STEP)));
        self.sense = 1.0;
        if let Some((_, obstacle)) = wound {
            return Err(Refusal::Beyond(obstacle));
        }
        let (of, frequency) = (Owner::Body(self.lead), stiffness.root());
        self.say(road, Quantity::OmegaSmall, of, frequency);
        self.say(road, Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        self.say(road, Quantity::Phi, of, self.layout.turned(way.abs()));
        let (first, poses) = (self.poses(T::zero())?, self.poses(way)?);
        for b in 0..self.scene.bodies.len() {
            let risen = self.centre(&poses, b)[1].value - self.centre(&first, b)[1].value;
            self.say(road, Quantity::Rise, Owner::Body(b), risen);
        }
        let still = |_: usize, _: T| [T::zero(); 2];
        self.tell_whole(&poses, road);
        self.tell_forces(&poses, &still, road);
        Ok(())
    }

    /// The impulses of the joints at blows that give this motion.
    pub fn tell_blow(&self, poses: &Poses<T>, jump: &Motion<T>, road: &mut Road<T>) {
        let moves = |b: usize, along: T| self.velocity(poses, jump, b, along);
        let all = self.reactions(poses, 0..self.scene.joints.len(), &moves, true);
        for (j, (joint, impulses)) in self.scene.joints.iter().zip(all).enumerate() {
            let (of, quantities) = (Owner::Joint(j), joint.kind.impulses());
            match impulses {
                Some(impulses) => {
                    for (quantity, (impulse, _)) in quantities.iter().zip(&impulses) {
                        self.say(road, *quantity, of, *impulse);
                    }
                }
                None => road.leaves_open(of, quantities),
            }
        }
    }

    /// Velocities and energy, with the accelerations of points and the angular ones where they are told.
    pub fn tell_motion(
        &self,
        poses: &Poses<T>,
        motion: &Motion<T>,
        rates: Option<Accelerations<T>>,
        road: &mut Road<T>,
    ) {
        let mut energy = T::zero();
        for (b, body) in self.scene.bodies.iter().enumerate() {
            let (of, (centre, gyration)) = (Owner::Body(b), self.centres[b]);
            let [vx, vy] = self.velocity(poses, motion, b, centre);
            for along in [centre + gyration, centre - gyration] {
                let v = self.velocity(poses, motion, b, along);
                energy = energy
                    + plant!("energy: kinetic energy of the particles", self.n.bodies[b].mass.scale2(-1))
                        * dot(v, v);
            }
            let speed = match self.pinned {
                true => (centre * motion[b][2]).abs(),
                false => (vx.square() + vy.square()).root(),
            };
            self.say(road, Quantity::V, of, speed);
            self.say(road, Quantity::VX, of, vx);
            self.say(road, Quantity::VY, of, vy);
            if let Some((moves, _)) = rates {
                let [mut ax, mut ay] = moves(b, centre);
                if let Some(with) = self.n.carried {
                    let [x, y] = with.map(|a| plant!("energy: rate of the carrier in the plane", a));
                    (ax, ay) = (ax.balance(x), ay.balance(y));
                }
                self.say(road, Quantity::AX, of, ax);
                self.say(road, Quantity::AY, of, ay);
            }
            if body.turns {
                self.say(road, Quantity::Omega, of, motion[b][2].abs());
                if !self.pinned {
                    let momentum = self.n.bodies[b].mass * gyration.square() * motion[b][2].abs();
                    self.say(road, Quantity::AngularMomentum, of, momentum);
                }
                if let Some((_, turning)) = rates {
                    self.say(road, Quantity::Alpha, of, turning(b).signed(self.scene.sense(b)));
                }
            }
            let own = self.of_couples(motion).filter(|(body, _)| *body == b).map(|(_, power)| power);
            let all = own.chain(self.of_drive(motion).filter(|_| b == self.lead)).reduce(T::balance);
            if let Some(power) = all.filter(|_| rates.is_some()) {
                self.say(road, Quantity::PowerCouple, of, power);
            }
            let points = body.planar.as_ref().map_or(0, |p| p.points.len());
            for spot in (0..points).map(|point| Spot { body: b, point }) {
                let [x, y] = self.of_spot(poses, motion, spot);
                self.say(road, Quantity::V, Owner::Spot(spot), (x.square() + y.square()).root());
            }
        }
        if self.pinned {
            energy = self.inertia(poses) * motion[self.lead][2].square();
        }
        self.say(road, Quantity::KineticEnergy, Owner::Scene, energy.scale2(-1));
    }

    /// Of bodies that a pin holds and that are welded into one: mass centre and moments of inertia, by two particles in the place of each
    /// body, which have no inertia of their own.
    fn tell_whole(&self, poses: &Poses<T>, road: &mut Road<T>) {
        let (of, bodies) = (Owner::Scene, &self.n.bodies);
        let Some(pin) = self.scene.only_pin() else { return };
        let halves = || {
            (0..bodies.len()).flat_map(|b| {
                self.particles(poses, b).map(|at| (bodies[b].mass.scale2(-1), at.map(|x| x.value)))
            })
        };
        let mass = halves().fold(T::zero(), |sum, (half, _)| sum + half);
        let centre = [0, 1].map(|i| halves().fold(T::zero(), |sum, (half, at)| sum + half * at[i]) / mass);
        let about = |[x, y]: Vector<T>| {
            let arm = |at: Vector<T>| (at[0] - x).square() + (at[1] - y).square();
            halves().fold(T::zero(), |sum, (half, at)| sum + half * arm(at))
        };
        self.say(road, Quantity::IO, of, about(self.point(poses, pin).map(|x| x.value)));
        self.say(
            road,
            Quantity::IG,
            of,
            plant!("energy: inertia about the common mass centre", about(centre)),
        );
        self.say(road, Quantity::XG, of, centre[0]);
        self.say(road, Quantity::YG, of, centre[1]);
    }

    /// Everything of one place: the velocities, accelerations of points, angular accelerations counter-clockwise.
    pub fn all(
        &self,
        poses: &Poses<T>,
        motion: &Motion<T>,
        moves: &dyn Fn(usize, T) -> Vector<T>,
        turning: &dyn Fn(usize) -> T,
        road: &mut Road<T>,
    ) -> Result<(), Refusal> {
        self.tell_motion(poses, motion, Some((moves, turning)), road);
        self.tell_whole(poses, road);
        self.tell_forces(poses, moves, road);
        Ok(())
    }

    /// The forces of joints and springs, with these accelerations of points.
    pub fn tell_forces(&self, poses: &Poses<T>, moves: &dyn Fn(usize, T) -> Vector<T>, road: &mut Road<T>) {
        let scene = self.scene;
        let all = self.reactions(poses, 0..scene.joints.len(), moves, false);
        for (j, (joint, forces)) in scene.joints.iter().zip(all).enumerate() {
            let of = Owner::Joint(j);
            let quantities = joint.kind.forces();
            let Some(forces) = forces else {
                road.leaves_open(of, quantities);
                continue;
            };
            for (quantity, (force, _)) in quantities.iter().zip(&forces) {
                self.say(road, *quantity, of, *force);
            }
            if let (Some(mu), [(normal, _)]) = (joint.kind.mu_k(), forces.as_slice()) {
                let at = joint
                    .kind
                    .rubs()
                    .map_or([T::zero(); 2], |(at, _)| self.point(poses, at).map(|x| x.value));
                let touch = self.layout.touch(j, at, self.line(poses, j));
                let up = touch.map_or(1.0, |touch| pose::upward(right(touch.normal)));
                let most = plant!("energy: friction that is told", self.n.get(mu)) * *normal;
                self.say(road, Quantity::Friction, of, -most.signed(self.rubs[j]).signed(up));
            }
            if let ([(x, _), (y, _), ..], [_, Quantity::PinY, ..]) = (forces.as_slice(), quantities) {
                let pulls = pose::pulls(scene, self.n);
                let [x, y] = [x, y].map(|f| f.cleared(f.size() + pulls));
                let force = (x.square() + y.square()).root();
                self.say(road, Quantity::PinForce, of, force);
                // A pin on which nothing acts: its force has no angle, and nothing else hangs on that.
                if !ball::unwatched(|| force.is_zero()) {
                    self.say(road, Quantity::PinAngle, of, trig::angle(y, x));
                }
            }
        }
        self.tell_springs(poses, road);
    }

    /// The forces and moments of springs.
    pub fn tell_springs(&self, poses: &Poses<T>, road: &mut Road<T>) {
        for (s, strut) in self.scene.struts.iter().enumerate() {
            let beyond = self.layout.beyond(poses, s);
            let stretch = if self.layout.acts(s, beyond) { beyond } else { T::zero() };
            let force = self.n.massive(strut.stiffness_n_m) * stretch;
            if strut.twists() {
                self.say(road, Quantity::Moment, Owner::Strut(s), -force);
            } else {
                self.say(road, Quantity::SpringForce, Owner::Strut(s), force);
            }
        }
    }
}
