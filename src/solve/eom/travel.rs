//! Accelerations integrated over displacement: `v dv = a dx`, in closed form where `a` is constant or linear in `x`.
//!
//! The ending coordinate starts at 0 with speed `u0 >= 0` in its sense of motion. While the spring's cord is taut its
//! acceleration is `f0 - w^2 s`; slack (or without a spring) it is constant. A time integral of `v` would need the motion
//! that is looked for; over displacement both sides are known.
use crate::num::plant::plant;
use crate::num::{Real, trig};

/// Acceleration as a function of the distance travelled.
#[derive(Debug, Clone, Copy)]
pub struct Travel<T> {
    /// Speed at the start, >= 0.
    pub u0: T,
    /// Acceleration at the start.
    pub f0: T,
    /// Its loss per metre while the spring acts: `w^2`, > 0.
    pub w2: Option<T>,
    /// Distance at which the cord goes slack, if it does, and the acceleration from there on.
    pub slack: Option<(T, T)>,
}

/// State at a distance.
#[derive(Debug, Clone, Copy)]
pub struct State<T> {
    /// Distance travelled.
    pub s: T,
    /// Speed.
    pub u: T,
    /// Time since the start.
    pub time: T,
}

fn half<T: Real>(x: T) -> T {
    x.scale2(-1)
}
fn twice<T: Real>(x: T) -> T {
    x.scale2(1)
}

impl<T: Real> Travel<T> {
    /// Square of the speed while the spring acts.
    fn taut_square(&self, s: T) -> T {
        let gained = twice(plant!("eom: integral of the acceleration", self.f0) * s);
        let spring = self.w2.map_or_else(T::zero, |w2| w2 * s.square());
        let start = self.u0.square();
        (start + gained - spring).cleared(start.size() + gained.size() + spring.size())
    }

    /// What the acceleration adds to the square of the speed up to a distance that is reached.
    pub fn gain(&self, s: T) -> T {
        let rest = Self { u0: T::zero(), ..*self };
        match self.slack {
            Some((at, f1)) if at.below(s) => rest.taut_square(at).balance(twice(f1 * (s - at))),
            _ => rest.taut_square(s),
        }
    }

    /// Does the motion get to the place where the cord goes slack? Its distance and the acceleration beyond.
    fn reaches_slack(&self) -> Option<(T, T)> {
        self.slack.filter(|(at, _)| at.is_zero() || self.taut_square(*at).sign() > 0.0)
    }

    /// Distance of the turning point; `None` if it never turns.
    pub fn turning(&self) -> Option<T> {
        if let Some((at, f1)) = self.reaches_slack() {
            return (f1.sign() < 0.0).then(|| at - half(self.taut_square(at) / f1));
        }
        match self.w2 {
            Some(w2) if self.u0.is_zero() => Some(twice(self.f0 / w2)),
            Some(w2) => Some((self.f0 + (self.f0.square() + w2 * self.u0.square()).root()) / w2),
            None if self.f0.sign() < 0.0 => Some(-half(self.u0.square() / self.f0)),
            None => None,
        }
    }

    /// Distance and greatest speed; `None` if the speed grows without end.
    pub fn fastest(&self) -> Option<(T, T)> {
        if self.f0.sign() <= 0.0 {
            // Nothing drives it on: fastest at the start, if it was thrown.
            return (!self.u0.is_zero()).then(|| (T::zero(), self.u0));
        }
        let w2 = self.w2?;
        let level = self.f0 / w2;
        // Slack, it gains speed as long as the other forces do not hold it back.
        if let Some((at, f1)) = self.slack
            && f1.not_negative()
        {
            return f1.is_zero().then(|| (at, self.taut_square(at).root()));
        }
        Some((level, (self.u0.square() + self.f0.square() / w2).root()))
    }

    /// State at a distance that is reached before the turning point.
    pub fn at(&self, s: T) -> State<T> {
        match self.slack {
            Some((at, f1)) if at.below(s) => {
                let first = self.taut(at);
                let u = self.taut_square(at).balance(twice(f1 * (s - at))).root();
                State { s, u, time: first.time + uniform_time(s - at, first.u, u) }
            }
            _ => self.taut(s),
        }
    }

    fn taut(&self, s: T) -> State<T> {
        let u = self.taut_square(s).root();
        let time = match self.w2 {
            None => uniform_time(s, self.u0, u),
            // With y = u/w and x the distance from equilibrium, (x, y) turns at the rate w: no root singularity at rest.
            Some(w2) => {
                let w = w2.root();
                let level = self.f0 / w2;
                if self.u0.is_zero() {
                    if level.sign() > 0.0 { trig::atan2(u / w, level - s) / w } else { T::zero() }
                } else {
                    let (x0, y0, x, y) = (-level, self.u0 / w, s - level, u / w);
                    trig::atan2(y0 * x - x0 * y, x0 * x + y0 * y) / w
                }
            }
        };
        State { s, u, time }
    }

    /// Distance after a time; meaningful up to the turning point.
    pub fn after(&self, time: T) -> T {
        let uniform = |u: T, f: T, t: T| u * t + half(f * t.square());
        let Some(w2) = self.w2 else { return uniform(self.u0, self.f0, time) };
        if let Some((at, f1)) = self.reaches_slack() {
            let first = self.taut(at);
            if first.time.below(time) {
                return at + uniform(first.u, f1, time - first.time);
            }
        }
        // 1 - cos = 2 sin^2 of the half: no cancellation soon after the start.
        let w = w2.root();
        let (sine, cosine) = trig::sin_cos(half(w * time));
        twice(sine * (sine * self.f0 / w2 + cosine * self.u0 / w))
    }

    /// Least distance at which the speed is `u`; `None` if it is never reached.
    pub fn reaching(&self, u: T) -> Option<T> {
        let change = u.square() - self.u0.square();
        if change.is_zero() {
            return Some(T::zero());
        }
        let not_negative = |s: T| s.not_negative().then_some(s);
        let Some(w2) = self.w2 else {
            return if self.f0.is_zero() { None } else { not_negative(half(change / self.f0)) };
        };
        // w^2 s^2 - 2 f0 s + change = 0, the smaller root that is not negative.
        let radicand = self.f0.square() - w2 * change;
        let taut = if radicand.sign() < 0.0 {
            None
        } else if change.sign() > 0.0 && self.f0.sign() > 0.0 {
            Some(change / (self.f0 + radicand.root()))
        } else {
            not_negative((self.f0 + radicand.root()) / w2)
        };
        match (taut, self.slack) {
            (Some(s), None) => Some(s),
            (Some(s), Some((at, _))) if at.reaches(s) => Some(s),
            (_, Some((at, f1))) if !f1.is_zero() => {
                let s = at + half((u.square() - self.taut_square(at)) / f1);
                s.reaches(at).then_some(s)
            }
            _ => None,
        }
    }
}

/// Time for a distance at constant acceleration, from the speeds at both ends: `2 s / (u0 + u)`.
fn uniform_time<T: Real>(s: T, u0: T, u: T) -> T {
    let sum = u0 + u;
    if sum.sign() > 0.0 { twice(s) / sum } else { T::zero() }
}
