//! The work of the generalised force over displacement, summed by Gauss-Legendre: no difference of stored energies is taken.
//!
//! `E(s) = E0 + int_0^s Q ds`, where Q is the sum of the powers of all forces per unit rate. For the time, `dt = ds / u` is made
//! regular first: with `W = s (S - s) h`, S the turning point, `s = S sin^2 p` gives `dt = sqrt(2 M / h) dp`, and h is regular at
//! both ends; without a turning point `s = D x^2`. Where the motion starts with a speed, `ds / u` is regular save towards a
//! turning point, which is taken as the far end of the same form.
use crate::num::gauss::Rule;
use crate::num::{Real, trig};
use crate::solve::energy::account::Account;
use std::cell::Cell;
use std::sync::OnceLock;

/// The most points of a quadrature.
const MOST_POINTS: usize = 96;

/// `int_a^b f / (b - a)` by `n` points, 1 to [`MOST_POINTS`] (the nearest of these otherwise), whose rule is made once.
fn mean<T: Real>(n: usize, (a, b): (T, T), f: impl Fn(T) -> T) -> T {
    static RULES: [OnceLock<Rule>; MOST_POINTS] = [const { OnceLock::new() }; MOST_POINTS];
    let n = n.clamp(1, MOST_POINTS);
    let rule = RULES[n - 1].get_or_init(|| Rule::new(n));
    let values: Vec<T> = rule.nodes.iter().map(|x| f(a + (b - a) * T::constant(*x))).collect();
    rule.mean(&values)
}

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

/// A stretch of the way under one law.
pub struct Leg<'a, T> {
    /// Generalised force at a place, along the motion.
    pub force: &'a dyn Fn(T) -> T,
    /// Twice the kinetic energy at unit rate.
    pub doubled: T,
    /// Points of each quadrature.
    pub points: usize,
}

impl<T: Real> Leg<'_, T> {
    /// Mean force between two places: the work is this times the way.
    pub fn mean(&self, a: T, b: T) -> T {
        mean(self.points, (a, b), self.force)
    }
    /// `int_a^b f`.
    fn integral(&self, a: T, b: T, f: impl Fn(T) -> T) -> T {
        (b - a) * mean(self.points, (a, b), f)
    }
    /// Speed at an energy.
    pub fn speed(&self, energy: T) -> T {
        (energy.scale2(1) / self.doubled).root()
    }
    /// Time from rest at 0 to a place; `far` is where the forces of this law would turn it.
    pub fn from_rest(&self, s: T, far: Option<T>) -> T {
        let twice = self.doubled.scale2(1);
        let Some(far) = far.filter(|far| s.at_most(*far)) else {
            let per_root = |x: T| (twice * s / self.mean(T::zero(), s * x.square())).root();
            return self.integral(T::zero(), T::of(1.0), per_root);
        };
        let end = trig::atan2(s.root(), far.balance(-s).root());
        self.integral(T::zero(), end, |p| {
            let (sine, cosine) = trig::turn(p);
            let (near, left) = (far * sine.square(), far * cosine.square());
            let h = if near.below(left) {
                self.mean(T::zero(), near) / left
            } else {
                -self.mean(near, far) / near
            };
            (twice / h).root()
        })
    }
    /// Time between two places at which it has these speeds, the first above 0; `far` is where it turns under this law.
    pub fn onward(&self, (a, ua): (T, T), (b, ub): (T, T), far: Option<T>) -> T {
        let slows = ub.at_most(ua.scale2(-1));
        let Some(far) = far.filter(|_| slows) else {
            return self.integral(T::zero(), b - a, |x| {
                let work = x * self.mean(a, a + x);
                T::of(1.0) / (ua.square().balance(work.scale2(1) / self.doubled)).root()
            });
        };
        // It slows down to less than half: from the turning point, at the distance z^2, dt = 2 dz / sqrt(-2 Q / M).
        self.integral(far.balance(-b).root(), (far - a).root(), |z| {
            let back = -self.mean(far - z.square(), far);
            (self.doubled.scale2(1) / back).root()
        })
    }
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
    /// Works on the side of a slack place where this account holds.
    fn on<R>(&self, account: &Account<T>, work: impl FnOnce(&Leg<T>) -> R) -> R {
        let force = |s: T| {
            self.evaluations.set(self.evaluations.get() + 1);
            account.power(s)
        };
        work(&Leg { force: &force, doubled: account.doubled, points: self.points })
    }
    /// Kinetic energy at a place before a cord goes slack.
    fn energy(&self, account: &Account<T>, s: T) -> T {
        account.energy0.balance(s * self.on(account, |leg| leg.mean(T::zero(), s)))
    }
    /// Speed at a place.
    pub fn speed(&self, s: T) -> T {
        self.from(self.account, s, false).u
    }
    /// Energy, speed and time at a place that is reached before the motion turns.
    pub fn at(&self, s: T) -> Summed<T> {
        self.from(self.account, s, true)
    }
    /// The same from where an account is opened, the time if it is wanted.
    fn from(&self, account: &Account<T>, s: T, timed: bool) -> Summed<T> {
        if let Some((at, next)) = account.beyond().filter(|(at, _)| at.below(s)) {
            let first = self.summed(account, at, timed);
            let next = Account { energy0: first.energy, u0: first.u, ..next };
            let then = self.from(&next, s - at, timed);
            return Summed { time: first.time + then.time, ..then };
        }
        self.summed(account, s, timed)
    }
    fn summed(&self, account: &Account<T>, s: T, timed: bool) -> Summed<T> {
        let energy = self.energy(account, s);
        let u = self.on(account, |leg| leg.speed(energy));
        Summed { energy, u, time: if timed { self.time(account, s, u) } else { T::zero() } }
    }
    fn time(&self, account: &Account<T>, s: T, u: T) -> T {
        if s.is_zero() {
            return T::zero();
        }
        if account.energy0.is_zero() {
            // Where the forces of this side alone would turn it, beyond a slack place too.
            let push = account.push();
            let far = account.stiff().filter(|_| push.sign() > 0.0).map(|stiff| push.scale2(1) / stiff);
            return self.on(account, |leg| leg.from_rest(s, far));
        }
        // A cord that goes slack before hides the turning point of the taut law.
        let hidden = |far: T| account.beyond().is_some_and(|(at, _)| at.below(far));
        let far = account.turning().filter(|far| !hidden(*far));
        self.on(account, |leg| leg.onward((T::zero(), account.u0), (s, u), far))
    }
}
