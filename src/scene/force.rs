//! Forces that no body and no tie brings with it.
use crate::scene::{End, Num, Scene};

/// A couple, of constant moment unless [`Scene::growths`] says otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Couple {
    /// Index of the body.
    pub body: usize,
    /// Moment, N m, >= 0.
    pub moment_n_m: Num,
    /// True: in the sense of rolling forward.
    pub forward: bool,
}

/// A given force or couple of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenForce {
    /// The pull at the far end of a cord, by the index of its tie.
    Pull(usize),
    /// By its index in [`Scene::couples`].
    Couple(usize),
}

/// A given force or couple that grows with time: `P = P_0 + c t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Which.
    pub of: GivenForce,
    /// Its growth, N/s or N m/s, >= 0.
    pub per_second: Num,
}

impl Scene {
    /// Growth of a given force or couple and the time for which it grows, where it does.
    pub fn growth(&self, of: GivenForce) -> Option<(Num, Num)> {
        let End::Time(_, time) = self.end else { return None };
        self.growths.iter().find(|g| g.of == of).map(|g| (g.per_second, time))
    }
}
