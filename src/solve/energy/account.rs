//! The energy account of a motion with one freedom: what the forces give, what springs store, where it is spent.
use crate::num::plant::plant;
use crate::num::{Real, trig};
use smallvec::SmallVec;

/// Energy stored in a spring on the way: stiffness, stretch at the start, and stretch lost per metre of the mode.
#[derive(Debug, Clone, Copy)]
pub struct Store<T> {
    /// Index of its tie.
    pub tie: usize,
    /// Stiffness.
    pub stiffness: T,
    /// Stretch at the start.
    pub stretch: T,
    /// Stretch lost per metre of the way.
    pub lost: T,
    /// Can it push?
    pub rigid: bool,
}

/// The springs of a scene.
pub type Stores<T> = SmallVec<[Store<T>; 1]>;

impl<T: Real> Store<T> {
    /// Stretch at a place; none where the cord is slack.
    pub fn stretch_at(&self, s: T) -> T {
        let stretch = self.stretch.balance(-(self.lost * s));
        if self.rigid { stretch } else { stretch.larger(T::zero()) }
    }
    /// Energy stored per square of the way, doubled.
    pub fn stiff(&self) -> T {
        plant!("energy: stiffness of the spring", self.stiffness) * self.lost.square()
    }
    /// Place at which its cord goes slack, if it does.
    pub fn slack(&self) -> Option<T> {
        (!self.rigid && self.lost.sign() > 0.0).then(|| self.stretch / self.lost)
    }
}

/// The energy account of the motion, along its sense.
#[derive(Debug, Clone)]
pub struct Account<T> {
    /// Work of the constant forces per metre.
    pub constant: T,
    /// Twice the kinetic energy at unit rate.
    pub doubled: T,
    /// Kinetic energy at the start.
    pub energy0: T,
    /// Speed at the start.
    pub u0: T,
    /// The springs that do work.
    pub stores: Stores<T>,
}

impl<T: Real> Account<T> {
    /// Power at the start per unit rate while the springs act.
    pub fn push(&self) -> T {
        self.power(T::zero())
    }
    /// Power at a place per unit rate while the springs act.
    pub fn power(&self, s: T) -> T {
        let of = |k: &Store<T>| k.stiffness * k.stretch.balance(-(k.lost * s)) * k.lost;
        self.stores.iter().map(of).fold(self.constant, T::balance)
    }
    /// What all springs together store per square of the way, doubled; `None` where none does.
    pub fn stiff(&self) -> Option<T> {
        self.stores.iter().map(Store::stiff).reduce(|a, b| a + b)
    }
    /// Kinetic energy at a place: that of the start and the work of all forces on the way.
    pub fn energy(&self, s: T) -> T {
        match self.beyond() {
            Some((at, next)) if at.below(s) => next.energy(s - at),
            _ => self.taut_energy(s),
        }
    }
    /// The same up to the place where a cord goes slack. A spring gives off `1/2 ks (x0^2 - x1^2)`, written as a
    /// product with the way: near equilibrium its difference from the work of the other forces would lose all digits.
    fn taut_energy(&self, s: T) -> T {
        self.energy0.balance(match self.stiff() {
            None => self.constant * s,
            Some(stiff) => self.push().balance(-(stiff * s).scale2(-1)) * s,
        })
    }
    /// Speed at a place.
    pub fn speed(&self, s: T) -> T {
        self.speed_of(self.energy(s))
    }
    fn speed_of(&self, energy: T) -> T {
        (energy.scale2(1) / self.doubled).root()
    }
    /// The first place at which a cord goes slack, if one does, and the account that is opened there, without a speed.
    pub fn beyond(&self) -> Option<(T, Self)> {
        let slack = self.stores.iter().enumerate().filter_map(|(i, k)| Some((i, k.slack()?)));
        let (first, at) = slack.reduce(|a, b| if b.1.below(a.1) { b } else { a })?;
        let left = self.stores.iter().enumerate().filter(|(i, _)| *i != first);
        let stores = left.map(|(_, k)| Store { stretch: k.stretch.balance(-(k.lost * at)), ..*k }).collect();
        Some((at, Self { energy0: self.taut_energy(at), u0: T::zero(), stores, ..*self }))
    }
    /// [`Account::beyond`], if the motion gets there.
    fn slackens(&self) -> Option<(T, Self)> {
        let (at, next) = self.beyond()?;
        let gets = next.energy0.sign() > 0.0 || at.is_zero();
        gets.then(|| (at, Self { u0: self.speed_of(next.energy0), ..next }))
    }
    /// Place at which the whole energy is stored or spent.
    pub fn turning(&self) -> Option<T> {
        if let Some((at, next)) = self.slackens() {
            return next.turning().map(|s| at + s);
        }
        // energy0 + (Q + sum ks x0 l) s - 1/2 sum ks l^2 s^2 = 0
        match self.stiff() {
            Some(stiff) => {
                let linear = self.push();
                if self.energy0.is_zero() {
                    return Some(linear.scale2(1) / stiff);
                }
                let radicand = linear.square() + stiff.scale2(1) * self.energy0;
                Some((linear + radicand.root()) / stiff)
            }
            None => (self.constant.sign() < 0.0).then(|| -self.energy0 / self.constant),
        }
    }
    /// Place and speed at which the kinetic energy is greatest: where the power vanishes.
    pub fn fastest(&self) -> Option<(T, T)> {
        let start = self.push();
        if start.sign() <= 0.0 {
            // It is never driven on: fastest at the start, if it was thrown.
            return (!self.u0.is_zero()).then(|| (T::zero(), self.u0));
        }
        let balanced = start / self.stiff()?;
        // Only if the rest of the forces resists is it balanced while all cords are taut.
        if let Some((at, next)) = self.slackens().filter(|(_, next)| next.push().not_negative()) {
            return next.fastest().map(|(s, u)| (at + s, u));
        }
        Some((balanced, self.speed_of(self.taut_energy(balanced))))
    }
    /// Time to a place. On a spring `tan(w t / 2) = w s / (u0 + u)`, on a constant force `u = u0 + a t`.
    pub fn time(&self, s: T, u: T) -> T {
        match (self.stiff(), self.slackens()) {
            (_, Some((at, next))) if at.below(s) => self.taut_time(at, next.u0) + next.time(s - at, u),
            (Some(_), _) => self.taut_time(s, u),
            (None, _) => self.uniform_time(s, u),
        }
    }
    fn taut_time(&self, s: T, u: T) -> T {
        let Some(stiff) = self.stiff().filter(|_| !s.is_zero()) else { return T::zero() };
        let w = (stiff / self.doubled).root();
        trig::atan2(w * s, self.u0 + u).scale2(1) / w
    }
    fn uniform_time(&self, s: T, u: T) -> T {
        let change = u - self.u0;
        if change.size() < (u + self.u0).scale2(-1).size() {
            // The change of the speed would lose digits: the mean speed keeps them. Both are right wherever they are taken.
            return (s / (self.u0 + u)).scale2(1);
        }
        if change.is_zero() { T::zero() } else { change * self.doubled / self.constant }
    }
    /// Place after a time, by the same half angle.
    pub fn place(&self, t: T) -> T {
        let Some(stiff) = self.stiff() else {
            return self.u0 * t + (self.constant / self.doubled * t.square()).scale2(-1);
        };
        if let Some((at, next)) = self.slackens() {
            let first = self.taut_time(at, next.u0);
            if first.below(t) {
                return at + next.place(t - first);
            }
        }
        let w = (stiff / self.doubled).root();
        let (sine, cosine) = trig::turn((w * t).scale2(-1));
        let start = self.push() / self.doubled;
        let (push, glide) = (start / w.square() * sine, self.u0 / w * cosine);
        ((push + glide) * sine).scale2(1)
    }
    /// First place at which the speed is `u`.
    pub fn where_speed(&self, u: T) -> Option<T> {
        let need = (self.doubled * u.apart(self.u0) * (u + self.u0)).scale2(-1);
        if need.is_zero() {
            return Some(T::zero());
        }
        let not_negative = |s: T| s.not_negative().then_some(s);
        let Some(stiff) = self.stiff() else {
            return if self.constant.is_zero() { None } else { not_negative(need / self.constant) };
        };
        let linear = self.push();
        let radicand = linear.square() - stiff.scale2(1) * need;
        let taut = if radicand.sign() < 0.0 {
            None
        } else if need.sign() > 0.0 && linear.sign() > 0.0 {
            Some(need.scale2(1) / (linear + radicand.root()))
        } else {
            not_negative((linear + radicand.root()) / stiff)
        };
        match (taut, self.slackens()) {
            (taut, None) => taut,
            (Some(s), Some((at, _))) if at.reaches(s) => Some(s),
            (_, Some((at, next))) => next.where_speed(u).map(|s| at + s),
        }
    }
}
