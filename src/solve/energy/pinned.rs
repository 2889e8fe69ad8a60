//! The energies of a pinned body: what a turn of it carries, what weight and spring store, what a couple gives.
//!
//! Unit rate of the turn moves the mass centre with the arm `r`, so `2 T = (m r^2 + I) omega^2`. Stored energies are taken
//! as differences in factors: the weight's height as a product of sines, the spring's as `1/2 k (x0 - x1)(x0 + x1)`, where
//! the difference of the stretches is that of the squares of the lengths over their sum.
use crate::num::Real;
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::scene::{Arm, Numbers, Pin, Rest, Scene, Zero};
use smallvec::SmallVec;

/// A pinned body as an account of energies. Masses and energies are in units of 2^e, as [`Numbers`] has them.
#[derive(Debug, Clone, Copy)]
pub struct Store<T> {
    /// Angle at the start.
    pub start: Half<T>,
    /// Twice the kinetic energy at unit rate of the turn.
    pub doubled: T,
    /// Distance from the pin to the mass centre.
    pub arm: T,
    mass: T,
    weight: T,
    /// Work of the couples per radian of growing angle.
    couple: T,
    /// Moment of inertia about the mass centre.
    own: T,
    spring: Option<Tied<T>>,
    /// 1 where the mass centre is above the pin at 0, -1 where it is below.
    up: f64,
}

/// The spring, in polar places about the pin.
#[derive(Debug, Clone, Copy)]
struct Tied<T> {
    /// Distance of its point of the body.
    at: T,
    /// Distance of its anchor.
    anchor: T,
    /// Direction of the anchor, as the angle of the body counts.
    direction: Half<T>,
    stiffness: T,
    natural: T,
}

/// Terms of one sum.
pub type Terms<T> = SmallVec<[T; 4]>;

/// Sum of terms, exactly 0 where they cancel.
pub fn sum<T: Real>(terms: &[T]) -> T {
    let size = terms.iter().fold(0.0, |sum, t| sum + t.size());
    terms.iter().fold(T::zero(), |sum, t| sum + *t).cleared(size)
}

impl<T: Real> Store<T> {
    /// Reads the body.
    pub fn new(scene: &Scene, n: &Numbers<T>, body: usize, pin: &Pin) -> Self {
        let numbers = n.bodies[body];
        let arm = match pin.arm {
            Arm::Distance(h) => n.get(h),
            Arm::HalfOf(l) => n.get(l).scale2(-1),
        };
        let carried = plant!("energy: speed of the mass centre about the pin", numbers.mass * arm.square());
        let own = plant!("energy: rotation of the pinned body", numbers.inertia);
        let start = Half::of_degrees(n.get(pin.start_deg));
        let couple = scene.couples.iter().fold(T::zero(), |sum, c| {
            let moment = n.get(c.moment_n_m);
            if c.forward { sum + moment } else { sum - moment }
        });
        let up = if pin.from == Zero::Upright { 1.0 } else { -1.0 };
        let spring = pin.spring.as_ref().map(|s| {
            let (x, y) = (n.get(s.x_m), n.get(s.y_m));
            let anchor = (x.square() + y.square()).root();
            // An anchor at the pin has no direction and needs none.
            let direction = if anchor.is_zero() { start } else { Half::of_point(x, y.signed(up)) };
            let at = n.get(s.at_m);
            let stiffness =
                plant!("energy: stiffness of the spring on a pinned body", n.get(s.stiffness_n_m));
            let mut tied = Tied { at, anchor, direction, stiffness, natural: T::zero() };
            tied.natural = match s.rest {
                Rest::Length(l) => n.get(l),
                Rest::Stretch(x0) => tied.length(&start) - n.get(x0),
            };
            tied
        });
        let weight = plant!("energy: weight of the pinned body", numbers.mass * n.gravity);
        Self { start, doubled: carried + own, arm, mass: numbers.mass, weight, couple, own, spring, up }
    }

    /// The same body in doubles.
    pub fn doubles(&self) -> Store<f64> {
        let half = |h: Half<T>| Half { sine: h.sine.f64(), cosine: h.cosine.f64() };
        let spring = self.spring.map(|s| Tied {
            at: s.at.f64(),
            anchor: s.anchor.f64(),
            direction: half(s.direction),
            stiffness: s.stiffness.f64(),
            natural: s.natural.f64(),
        });
        Store {
            start: half(self.start),
            doubled: self.doubled.f64(),
            arm: self.arm.f64(),
            mass: self.mass.f64(),
            weight: self.weight.f64(),
            couple: self.couple.f64(),
            own: self.own.f64(),
            spring,
            up: self.up,
        }
    }

    /// Does the angle count from upright?
    pub fn is_upright(&self) -> bool {
        self.up > 0.0
    }

    /// Powers per unit rate of growing angle at a place: of the weight, of the couples, of the spring.
    pub fn powers(&self, place: &Half<T>) -> Terms<T> {
        let falling = self.arm * place.full_sine().signed(self.up);
        let mut terms = Terms::new();
        terms.push(plant!("energy: power of the weight of the pinned body", self.weight) * falling);
        terms.push(plant!("energy: power of a couple on the pinned body", self.couple));
        if let Some(s) = &self.spring {
            // The anchor's arm times the sine is how fast the spring gets longer, times its length.
            let longer = s.at * s.anchor * place.minus(s.direction).full_sine();
            terms.push(-plant!("energy: power of the spring on the pinned body", s.slope(place)) * longer);
        }
        terms
    }

    /// Bound of the second derivative of the power per unit rate, over the angle, between two places less than a turn apart.
    ///
    /// With the length `l` of the spring, `a` and `b` the distances of its ends from the pin: `l' = a b sin / l` is at most the
    /// smaller of the two, and `sin` at most `l` over the larger, so that `k a b (1 + l0/l (1 + 6 min(a, b)/l))` bounds it.
    pub fn bend(&self, from: &Half<T>, to: &Half<T>) -> f64 {
        let mut bend = self.weight.size() * self.arm.size();
        if let Some(s) = &self.spring {
            let (at, anchor) = (s.at.size(), s.anchor.size());
            let mut share = 1.0;
            if !s.natural.is_zero() {
                // The length falls toward the direction of the anchor and grows from there.
                let (first, last) = (from.minus(s.direction).sine, to.minus(s.direction).sine);
                let through = first.sign() * last.sign() <= 0.0;
                let near = if first.size() < last.size() { from } else { to };
                let shortest = if through { (s.anchor - s.at).size() } else { s.length(near).size() };
                let smaller = if at < anchor { at } else { anchor };
                let by = s.natural.size() / shortest;
                share += by * (1.0 + 6.0 * smaller / shortest);
            }
            bend += s.stiffness.size() * at * anchor * share;
        }
        bend
    }

    /// Angular acceleration at a place, from the rate of the balance; exactly 0 where the powers balance.
    pub fn rate(&self, place: &Half<T>) -> T {
        sum(&self.powers(place))
            / plant!("energy: rate of the kinetic energy of the pinned body", self.doubled)
    }

    /// Work of all forces from one place to another, `step` and `turned` (radians, with sign) apart.
    pub fn work(&self, from: &Half<T>, to: &Half<T>, step: &Half<T>, turned: T) -> Terms<T> {
        let fallen = (self.arm * step.sine * to.plus(*from).sine).scale2(1).signed(self.up);
        let mut terms = Terms::new();
        terms.push(plant!("energy: work of the weight of the pinned body", self.weight) * fallen);
        terms.push(plant!("energy: work of a couple on the pinned body", self.couple) * turned);
        if let Some(s) = &self.spring {
            let (first, last) = (s.length(from), s.length(to));
            // (x0 - x1)(x0 + x1) of the stretches; the difference of the squares of the lengths as a product of sines.
            let turn = to.minus(s.direction).plus(from.minus(s.direction)).sine;
            let shorter = -((s.at * s.anchor * step.sine * turn).scale2(2) / (first + last));
            let stretches = (first - s.natural) + (last - s.natural);
            let stored = (s.stiffness * shorter * stretches).scale2(-1);
            terms.push(plant!("energy: work of the spring on the pinned body", stored));
        }
        terms
    }

    /// Frequency of small swings under the weight alone.
    pub fn frequency(&self) -> T {
        (self.weight * self.arm / self.doubled).root()
    }

    /// Height of the mass centre lost from one place to another.
    pub fn fallen(&self, from: &Half<T>, to: &Half<T>, step: &Half<T>) -> T {
        (self.arm * step.sine * to.plus(*from).sine).scale2(1).signed(self.up)
    }

    /// Force of the spring, positive if it pulls.
    pub fn spring_force(&self, place: &Half<T>) -> Option<T> {
        self.spring.as_ref().map(|s| s.stiffness * s.length(place).balance(-s.natural))
    }

    /// Force of the pin toward it and across: from virtual displacements of the body along the line to the mass centre and
    /// across it, without a turn, in which the pin's force does work. Each with its terms.
    pub fn held(&self, place: &Half<T>, square: T) -> (Terms<T>, Terms<T>) {
        let kept = plant!("energy: centripetal term", self.mass * self.arm) * square;
        let climb = place.full_cosine().signed(self.up);
        let weight = plant!("energy: weight in a displacement from the pin", self.weight);
        let mut toward: Terms<T> = [kept, -(weight * climb)].into_iter().collect();
        let speeding =
            plant!("energy: speeding up of the mass centre", self.mass * self.arm) * self.rate(place);
        let sinking = place.full_sine().signed(self.up);
        let weight = plant!("energy: weight in a displacement across", self.weight);
        let mut across: Terms<T> = [speeding, -(weight * sinking)].into_iter().collect();
        if let Some(s) = &self.spring {
            let apart = place.minus(s.direction);
            // How fast the spring gets longer, times its length: outward, and across.
            let outward = s.at - s.anchor * apart.full_cosine();
            let sideways = s.anchor * apart.full_sine();
            let slope = plant!("energy: spring in a displacement", s.slope(place));
            toward.push(-(slope * outward));
            across.push(slope * sideways);
        }
        if !self.arm.is_zero() {
            // The same force from a virtual turn about the mass centre: of a body whose mass sits there the force across is
            // a small difference of weight and speeding up, but no difference here.
            let turning =
                plant!("energy: rotation in a turn about the mass centre", self.own) * self.rate(place);
            let couple = plant!("energy: couple in a turn about the mass centre", self.couple);
            let mut turned: Terms<T> = [-(turning / self.arm), couple / self.arm].into_iter().collect();
            if let Some(s) = &self.spring {
                let sideways = s.anchor * place.minus(s.direction).full_sine();
                let lever = (s.at - self.arm) / self.arm;
                let slope = plant!("energy: spring in a turn about the mass centre", s.slope(place));
                turned.push(-(slope * sideways * lever));
            }
            let size = |terms: &Terms<T>| terms.iter().fold(0.0, |sum, t| sum + t.size());
            if size(&turned) < size(&across) {
                across = turned;
            }
        }
        (toward, across)
    }
}

impl<T: Real> Tied<T> {
    /// Length: `l^2 = (b - a)^2 + 4 a b sin^2` of half the angle between the body and the anchor.
    fn length(&self, place: &Half<T>) -> T {
        let sine = place.minus(self.direction).sine;
        let apart = self.anchor - self.at;
        (apart.square() + (self.anchor * self.at * sine.square()).scale2(2)).root()
    }
    /// Force over length.
    fn slope(&self, place: &Half<T>) -> T {
        if self.natural.is_zero() {
            return self.stiffness;
        }
        let length = self.length(place);
        self.stiffness * (length - self.natural) / length
    }
}
