//! Forces that no body and no tie brings with it.
use crate::num::Real;
use crate::scene::{End, Num, Numbers, Scene};
use serde::{Deserialize, Serialize};

/// A couple, of constant moment unless [`Scene::growths`] says otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Couple {
    /// Index of the body.
    pub body: usize,
    /// Moment, N m, >= 0.
    pub moment_n_m: Num,
    /// True: in the sense of rolling forward.
    pub forward: bool,
}

impl Couple {
    /// Something of it, positive in the sense of rolling forward, or in which the angle of its body grows.
    pub fn signed<T: Real>(&self, x: T) -> T {
        if self.forward { x } else { -x }
    }
}

/// A given force or couple of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum GivenForce {
    /// The pull at the far end of a cord, by the index of its tie.
    Pull(usize),
    /// By its index in [`Scene::couples`].
    Couple(usize),
}

/// What a given force or couple grows with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grows {
    /// The time since the start.
    Time,
    /// The way of its point along it since the start, or the angle that its body has turned.
    Place,
}

/// How a given force or couple grows: with a power of time or place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Law {
    /// Of what.
    pub with: Grows,
    /// Twice the power, > 0.
    pub halves: u8,
}

impl Law {
    /// With the time, evenly.
    pub const EVEN: Self = Self { with: Grows::Time, halves: 2 };
    /// The power.
    pub fn power<T: Real>(self) -> T {
        T::of(f64::from(self.halves)).scale2(-1)
    }
    /// The whole part of the power, which is in the unit of the rate.
    pub const fn whole(self) -> u8 {
        self.halves / 2
    }
    /// The power of a time or place; `unit` is 1 s or 1 m, by which half a power goes.
    pub fn of<T: Real>(self, x: T, unit: T) -> T {
        let root = if self.halves % 2 == 1 { (x / unit).root() } else { T::of(1.0) };
        (0..self.whole()).fold(root, |product, _| product * x)
    }
}

/// A given force or couple that grows: `P = P_0 + c t^p`, or with place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// Which.
    pub of: GivenForce,
    /// How.
    pub law: Law,
    /// Its rate `c`, >= 0: N or N m, per unit of time or place to the whole part of the power.
    pub rate: Num,
    /// 1 s, or 1 m or rad.
    pub unit: Num,
}

impl Growth {
    /// Units of the rate of a pull, and of a couple, by the whole part of the power: over time, and over place.
    pub const UNITS: [[[&str; 4]; 2]; 2] = [
        [["N", "N/s", "N/s^2", "N/s^3"], ["N", "N/m", "N/m^2", "N/m^3"]],
        [["N*m", "N*m/s", "N*m/s^2", "N*m/s^3"], ["N*m", "N*m/rad", "N*m/rad^2", "N*m/rad^3"]],
    ];
    /// Unit of the rate, SI.
    pub fn rate_unit(&self) -> &'static str {
        let of_couple = usize::from(matches!(self.of, GivenForce::Couple(_)));
        let over_place = usize::from(self.law.with == Grows::Place);
        Self::UNITS[of_couple][over_place][usize::from(self.law.whole().min(3))]
    }
    /// Unit of what it grows with, SI.
    pub const fn of_unit(&self) -> &'static str {
        match (self.law.with, self.of) {
            (Grows::Time, _) => "s",
            (Grows::Place, GivenForce::Pull(_)) => "m",
            (Grows::Place, GivenForce::Couple(_)) => "rad",
        }
    }
}

impl Scene {
    /// Moment of the couples on a body as they are at the start, positive with rolling forward; `None` without any.
    pub fn couple_on<T: Real>(&self, n: &Numbers<T>, body: usize) -> Option<T> {
        let own = self.couples.iter().filter(|c| c.body == body);
        own.map(|c| c.signed(n.massive(c.moment_n_m))).reduce(T::balance)
    }
    /// Growth of a given force or couple, where it does.
    pub fn growth(&self, of: GivenForce) -> Option<&Growth> {
        self.growths.iter().find(|g| g.of == of)
    }
    /// How the forces grow that do; all do alike.
    pub fn law(&self) -> Option<Law> {
        self.growths.first().map(|g| g.law)
    }
    /// Does a force grow with place? The time is then no answer.
    pub fn grows_with_place(&self) -> bool {
        self.law().is_some_and(|law| law.with == Grows::Place)
    }
    /// May the motion turn before its end? Where forces grow with time and nothing that holds back could stop it: the same equations
    /// hold on its way back. A couple of constant moment may be meant as one that brakes.
    pub fn may_turn(&self) -> bool {
        let timed =
            matches!(self.end, End::Time(..)) && self.law().is_some_and(|law| law.with == Grows::Time);
        let grown = |i: usize| self.growth(GivenForce::Couple(i)).is_some();
        timed && self.carried.is_none() && (0..self.couples.len()).all(grown)
    }
    /// The time or the way of the ending coordinate on which forces grow.
    pub fn growing_for(&self) -> Option<Num> {
        match self.end {
            End::Time(_, x) | End::Travel(_, x) | End::Position(_, x) => Some(x),
            _ => None,
        }
    }
}
