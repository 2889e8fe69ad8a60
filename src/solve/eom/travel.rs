//! Accelerations integrated over displacement: `v dv = a dx`, in closed form where `a` is constant or linear in `x`.
//!
//! The ending coordinate starts at 0 with speed `u0 >= 0` in its sense of motion. Its acceleration is `f - w^2 s`, with a
//! smaller `w^2` from each place on at which the cord of a spring goes slack. A time integral of `v` would need the motion
//! that is looked for; over displacement both sides are known.
use crate::num::plant::plant;
use crate::num::{Real, trig};

/// Acceleration as a function of the distance travelled, from one place on.
#[derive(Debug, Clone, Copy)]
pub struct Leg<T> {
    /// Distance at which it begins.
    pub from: T,
    /// Acceleration there.
    pub f: T,
    /// Its loss per metre: `w^2`, > 0, where a spring acts.
    pub w2: Option<T>,
}

/// A motion along its sense.
#[derive(Debug, Clone, Copy)]
pub struct Travel<'l, T> {
    /// Speed at the start, >= 0.
    pub u0: T,
    /// How it begins, and how it goes on from each place at which a cord goes slack.
    pub legs: &'l [Leg<T>],
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

impl<T: Real> Travel<'_, T> {
    /// Acceleration at the start.
    pub fn starts_at(&self) -> T {
        self.law().0
    }

    /// Acceleration at the start, and its loss per metre.
    fn law(&self) -> (T, Option<T>) {
        self.legs.first().map_or((T::zero(), None), |law| (law.f, law.w2))
    }

    /// Square of the speed under the first law.
    fn taut_square(&self, s: T) -> T {
        let (f0, w2) = self.law();
        let gained = twice(plant!("eom: integral of the acceleration", f0) * s);
        let spring = w2.map_or_else(T::zero, |w2| w2 * s.square());
        let start = self.u0.square();
        (start + gained - spring).cleared(start.size() + gained.size() + spring.size())
    }

    /// What the acceleration adds to the square of the speed up to a distance that is reached.
    pub fn gain(&self, s: T) -> T {
        let rest = Self { u0: T::zero(), legs: self.legs };
        match self.slackens() {
            Some((at, next)) if at.below(s) => rest.taut_square(at).balance(next.gain(s - at)),
            _ => rest.taut_square(s),
        }
    }

    /// Does the motion get to the place where a cord goes slack? Its distance and the motion from there on.
    fn slackens(&self) -> Option<(T, Self)> {
        let [first, legs @ ..] = self.legs else { return None };
        let at = legs.first()?.from - first.from;
        let square = self.taut_square(at);
        (at.is_zero() || square.sign() > 0.0).then(|| (at, Self { u0: square.root(), legs }))
    }

    /// Distance of the turning point; `None` if it never turns.
    pub fn turning(&self) -> Option<T> {
        if let Some((at, next)) = self.slackens() {
            return next.turning().map(|s| at + s);
        }
        match self.law() {
            (f0, Some(w2)) if self.u0.is_zero() => Some(twice(f0 / w2)),
            (f0, Some(w2)) => Some((f0 + (f0.square() + w2 * self.u0.square()).root()) / w2),
            (f0, None) if f0.sign() < 0.0 => Some(-half(self.u0.square() / f0)),
            (_, None) => None,
        }
    }

    /// Distance and greatest speed; `None` if the speed grows without end.
    pub fn fastest(&self) -> Option<(T, T)> {
        let (f0, w2) = self.law();
        if f0.sign() <= 0.0 {
            // Nothing drives it on: fastest at the start, if it was thrown.
            return (!self.u0.is_zero()).then(|| (T::zero(), self.u0));
        }
        let w2 = w2?;
        // With a cord slack it gains speed as long as the other forces do not hold it back.
        if let Some((at, next)) = self.slackens().filter(|(_, next)| next.law().0.not_negative()) {
            return next.fastest().map(|(s, u)| (at + s, u));
        }
        Some((f0 / w2, (self.u0.square() + f0.square() / w2).root()))
    }

    /// State at a distance that is reached before the turning point.
    pub fn at(&self, s: T) -> State<T> {
        match self.slackens() {
            Some((at, next)) if at.below(s) => {
                let State { u, time, .. } = next.at(s - at);
                State { s, u, time: self.taut(at).time + time }
            }
            _ => self.taut(s),
        }
    }

    fn taut(&self, s: T) -> State<T> {
        let u = self.taut_square(s).root();
        let time = match self.law() {
            (_, None) => uniform_time(s, self.u0, u),
            // With y = u/w and x the distance from equilibrium, (x, y) turns at the rate w: no root singularity at rest.
            (f0, Some(w2)) => {
                let w = w2.root();
                let level = f0 / w2;
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
        let (f0, w2) = self.law();
        let Some(w2) = w2 else { return self.u0 * time + half(f0 * time.square()) };
        if let Some((at, next)) = self.slackens() {
            let first = self.taut(at).time;
            if first.below(time) {
                return at + next.after(time - first);
            }
        }
        // 1 - cos = 2 sin^2 of the half: no cancellation soon after the start.
        let w = w2.root();
        let (sine, cosine) = trig::turn(half(w * time));
        twice(sine * (sine * f0 / w2 + cosine * self.u0 / w))
    }

    /// Least distance at which the speed is `u`; `None` if it is never reached.
    pub fn reaching(&self, u: T) -> Option<T> {
        let change = u.apart(self.u0) * (u + self.u0);
        if change.is_zero() {
            return Some(T::zero());
        }
        let not_negative = |s: T| s.not_negative().then_some(s);
        let (f0, w2) = self.law();
        let Some(w2) = w2 else {
            return if f0.is_zero() { None } else { not_negative(half(change / f0)) };
        };
        // w^2 s^2 - 2 f0 s + change = 0, the smaller root that is not negative.
        let radicand = f0.square() - w2 * change;
        let taut = if radicand.sign() < 0.0 {
            None
        } else if change.sign() > 0.0 && f0.sign() > 0.0 {
            Some(change / (f0 + radicand.root()))
        } else {
            not_negative((f0 + radicand.root()) / w2)
        };
        match (taut, self.slackens()) {
            (taut, None) => taut,
            (Some(s), Some((at, _))) if at.reaches(s) => Some(s),
            (_, Some((at, next))) => next.reaching(u).map(|s| at + s),
        }
    }
}

/// Time for a distance at constant acceleration, from the speeds at both ends: `2 s / (u0 + u)`.
fn uniform_time<T: Real>(s: T, u0: T, u: T) -> T {
    let sum = u0 + u;
    if sum.sign() > 0.0 { twice(s) / sum } else { T::zero() }
}
