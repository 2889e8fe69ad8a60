//! The work of the generalised force over displacement, summed by Gauss-Legendre: no difference of stored energies is taken.
//!
//! `E(s) = E0 + int_0^s Q ds`, where Q is the sum of the powers of all forces per unit rate. For the time, `dt = ds / u` is made
//! regular first: with `W = s (S - s) h`, S the turning point, `s = S sin^2 p` gives `dt = sqrt(2 M / h) dp`, and h is regular at
//! both ends; without a turning point `s = D x^2`. Where the motion starts with a speed, `ds / u` is regular save towards a
//! turning point, which is taken as the far end of the same form.
use crate::num::Real;
use crate::num::legendre;
use crate::num::trig;
use crate::solve::energy::account::Account;
use std::cell::Cell;

/// What the quadrature gives at a place.
#[derive(Debug, Clone, Copy)]
pub struct Summed<T> {
    /// Kinetic energy.
    pub energy: T,
    /// Speed.
    pub u: T,
    /// Time since the start.
    pub time: T,
}

/// An account whose work is summed by quadrature.
pub struct Sum<'a, T> {
    /// The forces and the start.
    pub account: &'a Account<T>,
    /// Points of each quadrature.
    pub points: usize,
    /// Evaluations of the generalised force so far.
    pub evaluations: Cell<u64>,
}

impl<T: Real> Sum<'_, T> {
    /// Generalised force at a place, along the motion. `taut`: on the side of the slack place where the spring acts.
    fn force(&self, s: T, taut: bool) -> T {
        self.evaluations.set(self.evaluations.get() + 1);
        let account = self.account;
        match account.store {
            Some(k) if taut => {
                account.constant.balance(k.stiffness * k.stretch.balance(-(k.lost * s)) * k.lost)
            }
            _ => account.constant,
        }
    }
    /// Mean force between two places.
    fn mean(&self, a: T, b: T, taut: bool) -> T {
        let width = b - a;
        let rule = legendre::rule(self.points);
        rule.nodes.iter().zip(&rule.weights).fold(T::zero(), |sum, (x, w)| {
            sum + T::constant(*w) * self.force(a + width * T::constant(*x), taut)
        })
    }
    /// Kinetic energy at a place.
    pub fn energy(&self, s: T) -> T {
        let account = self.account;
        match account.slack() {
            Some(at) if at.below(s) => {
                let first = account.energy0.balance(at * self.mean(T::zero(), at, true));
                first.balance((s - at) * self.mean(at, s, false))
            }
            _ => account.energy0.balance(s * self.mean(T::zero(), s, true)),
        }
    }
    /// Speed at a place.
    pub fn speed(&self, s: T) -> T {
        self.speed_of(self.energy(s))
    }
    fn speed_of(&self, energy: T) -> T {
        (energy.scale2(1) / self.account.doubled).root()
    }
    /// Energy, speed and time at a place that is reached before the motion turns.
    pub fn at(&self, s: T) -> Summed<T> {
        let energy = self.energy(s);
        let u = self.speed_of(energy);
        let account = self.account;
        let time = match account.slack() {
            Some(at) if at.below(s) => {
                let between = self.speed_of(self.energy(at));
                self.taut_time(at, between) + self.time(at, s, between, u)
            }
            _ => self.taut_time(s, u),
        };
        Summed { energy, u, time }
    }
    fn taut_time(&self, s: T, u: T) -> T {
        if s.is_zero() {
            return T::zero();
        }
        if !self.account.energy0.is_zero() {
            return self.time(T::zero(), s, self.account.u0, u);
        }
        let doubled = self.account.doubled;
        // Where the forces of this side alone would turn it, beyond a slack place too.
        let turning = match self.account.store {
            Some(k) if self.account.push(k).sign() > 0.0 => Some(self.account.push(k).scale2(1) / k.stiff()),
            _ => None,
        };
        let Some(far) = turning.filter(|far| s.at_most(*far)) else {
            let per_root = |x: T| (doubled.scale2(1) * s / self.mean(T::zero(), s * x.square(), true)).root();
            return legendre::integral(self.points, T::zero(), T::of(1.0), per_root);
        };
        let end = trig::atan2(s.root(), (far - s).root());
        legendre::integral(self.points, T::zero(), end, |p| {
            let (sine, cosine) = trig::sin_cos(p);
            let (near, left) = (far * sine.square(), far * cosine.square());
            let h = if near.below(left) {
                self.mean(T::zero(), near, true) / left
            } else {
                -self.mean(near, far, true) / near
            };
            (doubled.scale2(1) / h).root()
        })
    }
    /// Time between two places where it starts with a speed: regular, or rising from the turning point backwards.
    fn time(&self, a: T, b: T, ua: T, ub: T) -> T {
        let taut = self.account.slack().is_none_or(|at| a.below(at));
        let width = b - a;
        let doubled = self.account.doubled;
        // A cord that goes slack before hides the turning point of the taut law.
        let far = self.account.turning();
        let hidden = taut && self.account.slack().is_some_and(|at| far.is_none_or(|far| at.below(far)));
        if hidden || ua.scale2(-1).below(ub) {
            return legendre::integral(self.points, T::zero(), width, |x| {
                let work = x * self.mean(a, a + x, taut);
                T::of(1.0) / (ua.square().balance(work.scale2(1) / doubled)).root()
            });
        }
        // It slows down to less than half: from the turning point, at the distance z^2, dt = 2 dz / sqrt(-2 Q / M).
        let Some(far) = far else { return T::of(f64::NAN) };
        legendre::integral(self.points, (far - b).root(), (far - a).root(), |z| {
            let back = -self.mean(far - z.square(), far, taut);
            (doubled.scale2(1) / back).root()
        })
    }
}
