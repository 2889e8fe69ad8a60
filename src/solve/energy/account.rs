//! The energy account of a motion with one freedom: what the forces give, what the spring stores, where it is spent.
use crate::num::plant::plant;
use crate::num::{Real, trig};

/// Energy stored in a spring on the way: stiffness, stretch at the start, and stretch lost per metre of the mode.
#[derive(Debug, Clone, Copy)]
pub struct Store<T> {
    /// Stiffness.
    pub stiffness: T,
    /// Stretch at the start.
    pub stretch: T,
    /// Stretch lost per metre of the way.
    pub lost: T,
    /// Can it push?
    pub rigid: bool,
}

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
}

/// The energy account of the motion, along its sense.
#[derive(Debug, Clone, Copy)]
pub struct Account<T> {
    /// Work of the constant forces per metre.
    pub constant: T,
    /// Twice the kinetic energy at unit rate.
    pub doubled: T,
    /// Kinetic energy at the start.
    pub energy0: T,
    /// Speed at the start.
    pub u0: T,
    /// The spring, if one does work.
    pub store: Option<Store<T>>,
}

impl<T: Real> Account<T> {
    /// Power at the start per unit rate while the spring acts.
    pub fn push(&self, k: Store<T>) -> T {
        self.constant.balance(k.stiffness * k.stretch * k.lost)
    }
    /// Kinetic energy at a place: that of the start and the work of all forces on the way.
    pub fn energy(&self, s: T) -> T {
        match self.store {
            Some(k) if self.slack().is_some_and(|at| at.below(s)) => {
                let given = (k.stiffness * k.stretch.square()).scale2(-1);
                self.energy0.balance((self.constant * s).balance(given))
            }
            _ => self.taut_energy(s),
        }
    }
    /// The same up to the place where the cord goes slack. The spring gives off `1/2 ks (x0^2 - x1^2)`, written as a
    /// product with the way: near equilibrium its difference from the work of the other forces would lose all digits.
    fn taut_energy(&self, s: T) -> T {
        self.energy0.balance(match self.store {
            None => self.constant * s,
            Some(k) => self.push(k).balance(-(k.stiff() * s).scale2(-1)) * s,
        })
    }
    /// Speed at a place.
    pub fn speed(&self, s: T) -> T {
        self.speed_of(self.energy(s))
    }
    fn speed_of(&self, energy: T) -> T {
        (energy.scale2(1) / self.doubled).root()
    }
    /// Place at which the cord goes slack, if it does.
    pub fn slack(&self) -> Option<T> {
        self.store.filter(|k| !k.rigid && k.lost.sign() > 0.0).map(|k| k.stretch / k.lost)
    }
    /// Place at which the whole energy is stored or spent.
    pub fn turning(&self) -> Option<T> {
        if let Some(at) = self.slack() {
            let left = self.taut_energy(at);
            if left.sign() > 0.0 || at.is_zero() {
                return (self.constant.sign() < 0.0).then(|| at - left / self.constant);
            }
        }
        match self.store {
            // energy0 + (Q + ks x0 l) s - 1/2 ks l^2 s^2 = 0
            Some(k) => {
                let stiff = k.stiff();
                let linear = self.push(k);
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
        let start = self.store.map_or(self.constant, |k| self.push(k));
        if start.sign() <= 0.0 {
            // It is never driven on: fastest at the start, if it was thrown.
            return (!self.u0.is_zero()).then(|| (T::zero(), self.u0));
        }
        let k = self.store?;
        let balanced = start / k.stiff();
        let at = match self.slack() {
            // Only against the other forces is it balanced while the cord is taut.
            Some(slack) if self.constant.not_negative() => {
                if self.constant.sign() > 0.0 {
                    return None;
                }
                slack
            }
            _ => balanced,
        };
        Some((at, self.speed_of(self.taut_energy(at))))
    }
    /// Time to a place. On a spring `tan(w t / 2) = w s / (u0 + u)`, on a constant force `u = u0 + a t`.
    pub fn time(&self, s: T, u: T) -> T {
        let slack = self.slack();
        match (self.store, slack) {
            (Some(_), Some(at)) if at.below(s) => {
                let v = self.speed_of(self.taut_energy(at));
                self.taut_time(at, v) + self.uniform_time(s - at, v, u)
            }
            (Some(_), _) => self.taut_time(s, u),
            (None, _) => self.uniform_time(s, self.u0, u),
        }
    }
    fn taut_time(&self, s: T, u: T) -> T {
        let Some(k) = self.store else { return T::zero() };
        if s.is_zero() {
            return T::zero();
        }
        let w = (k.stiff() / self.doubled).root();
        trig::atan2(w * s, self.u0 + u).scale2(1) / w
    }
    fn uniform_time(&self, s: T, u0: T, u: T) -> T {
        let change = u - u0;
        if change.size() < (u + u0).scale2(-1).size() {
            // The change of the speed would lose digits: the mean speed keeps them. Both are right wherever they are taken.
            return (s / (u0 + u)).scale2(1);
        }
        if change.is_zero() { T::zero() } else { change * self.doubled / self.constant }
    }
    /// Place after a time, by the same half angle.
    pub fn place(&self, t: T) -> T {
        let uniform = |u: T, t: T| u * t + (self.constant / self.doubled * t.square()).scale2(-1);
        let Some(k) = self.store else { return uniform(self.u0, t) };
        if let Some(at) = self.slack() {
            let left = self.taut_energy(at);
            if left.sign() > 0.0 || at.is_zero() {
                let v = self.speed_of(left);
                let first = self.taut_time(at, v);
                if first.below(t) {
                    return at + uniform(v, t - first);
                }
            }
        }
        let w = (k.stiff() / self.doubled).root();
        let (sine, cosine) = trig::sin_cos((w * t).scale2(-1));
        let start = self.push(k) / self.doubled;
        let (push, glide) = (start / w.square() * sine, self.u0 / w * cosine);
        ((push + glide) * sine).scale2(1)
    }
    /// First place at which the speed is `u`.
    pub fn where_speed(&self, u: T) -> Option<T> {
        let need = (self.doubled * (u - self.u0) * (u + self.u0)).scale2(-1);
        if need.is_zero() {
            return Some(T::zero());
        }
        let not_negative = |s: T| s.not_negative().then_some(s);
        let Some(k) = self.store else {
            return if self.constant.is_zero() { None } else { not_negative(need / self.constant) };
        };
        let stiff = k.stiff();
        let linear = self.push(k);
        let radicand = linear.square() - stiff.scale2(1) * need;
        let taut = if radicand.sign() < 0.0 {
            None
        } else if need.sign() > 0.0 && linear.sign() > 0.0 {
            Some(need.scale2(1) / (linear + radicand.root()))
        } else {
            not_negative((linear + radicand.root()) / stiff)
        };
        match (taut, self.slack()) {
            (Some(s), None) => Some(s),
            (Some(s), Some(at)) if at.reaches(s) => Some(s),
            (_, Some(at)) if !self.constant.is_zero() => {
                let s = at + (need + self.energy0 - self.taut_energy(at)) / self.constant;
                s.reaches(at).then_some(s)
            }
            _ => None,
        }
    }
}
