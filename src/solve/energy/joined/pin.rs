//! A body on a pin: what work and energy say of it beside what all joined bodies have.
use crate::num::plant::plant;
use crate::num::{Dd, Real, ball, trig};
use crate::scene::{End, Owner, Quantity, Ray};
use crate::solve::energy::joined::{Account, Poses};
use crate::solve::energy::pendulum::Pendulum;
use crate::solve::energy::quadrature::Leg;
use crate::solve::outcome::{Refusal, Road, Scope};
use smallvec::{SmallVec, smallvec};

impl<T: Real> Account<'_, T> {
    /// What holds whatever the end, with this spin at the start.
    pub fn tell_lasting(&mut self, spin: T, asked: Scope, road: &mut Road<T>) -> Result<(), Refusal> {
        let (poses, of) = (self.poses(T::zero())?, Owner::Body(self.lead));
        let inertia = self.inertia(&poses);
        self.say(road, Quantity::IO, of, inertia);
        let numbers = &self.n.bodies[self.lead];
        let weight = plant!("energy: weight of a pendulum", numbers.mass * self.n.gravity);
        let frequency = (weight * self.centres[self.lead].0 / inertia).root();
        if !self.scene.couples.is_empty() || !self.scene.struts.is_empty() || frequency.is_zero() {
            return Ok(());
        }
        let force = self.balance(&poses, &self.rates(&poses))?.force;
        let sense = if spin.is_zero() { force.sign() } else { spin.sign() };
        let upright = self.scene.planar(self.lead).is_some_and(|p| p.from == Ray::Up);
        let start = (self.scene.start_angle(self.n), upright);
        let pendulum = Pendulum::new(start, sense, spin, frequency);
        self.say(road, Quantity::OmegaSmall, of, frequency);
        self.say(road, Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        if asked.any(&[Quantity::Period, Quantity::OmegaMax]) {
            let (period, fastest) = pendulum.period();
            self.say(road, Quantity::Period, of, period);
            self.say(road, Quantity::OmegaMax, of, fastest);
        }
        self.pendulum = Some(pendulum);
        Ok(())
    }

    /// Its acceleration and forces where it stands, at this square of its rate.
    pub fn tell_standing(&self, poses: &Poses<T>, square: T, road: &mut Road<T>) -> Result<(), Refusal> {
        if self.pinned {
            let (second, _) = self.acceleration(poses, square)?;
            self.say(road, Quantity::Alpha, Owner::Body(self.lead), second);
            self.tell_pin(poses, second, square, road);
            self.tell_springs(poses, road);
        }
        Ok(())
    }

    /// What it has at this rate beside what every body has.
    pub fn tell_spin(&self, poses: &Poses<T>, rate: T, road: &mut Road<T>) {
        let (of, inertia) = (Owner::Body(self.lead), self.inertia(poses));
        self.say(road, Quantity::AngularMomentum, of, inertia * rate.abs());
        if !rate.is_zero() {
            let own = self.n.bodies[self.lead].inertia;
            self.say(road, Quantity::RotationalFraction, Owner::Scene, own / inertia);
        }
    }

    /// The force of its pin: along its axis and across from virtual displacements of the body without a turn, in which the pin's force
    /// does work, to the right and up from both.
    pub fn tell_pin(&self, poses: &Poses<T>, second: T, square: T, road: &mut Road<T>) {
        let (b, zero) = (self.lead, T::zero());
        let (numbers, arm, sense) = (&self.n.bodies[b], self.centres[b].0, self.scene.sense(b));
        let [c, s] = poses[b].axis.map(|x| x.value);
        let lacks = |powers: SmallVec<[T; 6]>, needed: T| {
            let size = powers.iter().fold(needed.size(), |sum, p| sum + p.size());
            (powers.into_iter().fold(needed, |sum, p| sum - p).cleared(size), size)
        };
        let kept = plant!("energy: centripetal term", numbers.mass * arm) * square;
        let (outward, _) = lacks(self.powers(poses, &smallvec![[c, s, zero]], false), -kept);
        let speeding = plant!("energy: speeding up of the mass centre", numbers.mass * arm) * second;
        let aside = [-s, c].map(|x| x.signed(sense));
        let mut across = lacks(self.powers(poses, &smallvec![[aside[0], aside[1], zero]], false), speeding);
        if !arm.is_zero() {
            // The same force from a virtual turn about the mass centre, in which the weight does no work: of a body whose mass sits
            // there the force across is a small difference of weight and speeding up, but no difference here.
            let own = plant!("energy: rotation in a turn about the mass centre", numbers.inertia);
            let turn = T::of(1.0) / arm;
            let about = smallvec![[-aside[0], -aside[1], turn.signed(sense)]];
            let about = lacks(self.applied(poses, &about), own * second / arm);
            if about.1 < across.1 {
                across = (-about.0, about.1);
            }
        }
        let across = across.0;
        let of = Owner::Body(b);
        self.say(road, Quantity::PinRadial, of, -outward);
        self.say(road, Quantity::PinTangential, of, across);
        let force = (outward.square() + across.square()).root();
        self.say(road, Quantity::PinForce, of, force);
        let turned = across.signed(sense);
        let side = plant!("energy: pin in a displacement to the side", (outward * c).balance(-(turned * s)));
        let lift = plant!("energy: pin in a displacement upward", (outward * s).balance(turned * c));
        self.say(road, Quantity::PinX, of, side);
        self.say(road, Quantity::PinY, of, lift);
        // A pin on which nothing acts: its force has no angle, and nothing else hangs on that.
        if !ball::unwatched(|| force.is_zero()) {
            self.say(road, Quantity::PinAngle, of, trig::angle(lift, side));
        }
    }

    /// Rate and time at the end of a way, at which it rests or not, by the work of all forces over the angle.
    pub fn summed(&self, way: T, rest: bool, from: (&Poses<T>, T), points: usize) -> Result<(T, T), Refusal> {
        let far = match self.scene.end {
            End::Angle(..) => way.scale2(1),
            _ => self.layout.horizon(),
        };
        let turning = self.turning(far, from)?;
        self.looked.set(0);
        let force = |way: T| {
            let force = self.poses(way).and_then(|poses| self.balance(&poses, &self.rates(&poses)));
            force.map_or_else(|_| T::of(f64::NAN), |balance| balance.force.signed(self.sense))
        };
        let leg = Leg { force: &force, doubled: self.inertia(from.0), points };
        let energy = leg.doubled * from.1;
        let work = way * leg.mean(T::zero(), way);
        let speed = if rest { T::zero() } else { leg.speed(energy.balance(work)) };
        let time = if way.is_zero() {
            T::zero()
        } else if energy.is_zero() {
            leg.from_rest(way, turning)
        } else {
            leg.onward((T::zero(), leg.speed(energy)), (way, speed), turning)
        };
        Ok((speed, time))
    }
}
