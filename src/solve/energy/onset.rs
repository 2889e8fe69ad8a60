//! What a motion sets off with: which contacts hold, and what those take that rub.
use crate::num::Real;
use crate::num::plant::plant;
use crate::scene::{Coordinate, Numbers, Scene, Tie};
use crate::solve::energy::balance::{self, PerTie};
use crate::solve::energy::{drive, frictions, speeds};
use smallvec::{SmallVec, smallvec};

/// The contacts of a scene at the start of a motion with one freedom, or from rest.
pub struct Onset<'s, 'a, T: Real> {
    scene: &'s Scene,
    n: &'s Numbers<'a, T>,
    pulls: &'s [T],
    /// For each tie: is it a contact that could rub and is at rest?
    pub holds: PerTie<bool>,
    /// Kinetic friction of the others.
    pub kinetic: PerTie<Option<T>>,
    /// For each contact that is said to slip: its friction if it rolled.
    pub rolled: SmallVec<[(usize, T); 1]>,
}

impl<'s, 'a, T: Real> Onset<'s, 'a, T> {
    /// Nothing holds, and what slides has no friction until the sense of the motion is known.
    pub fn new(scene: &'s Scene, n: &'s Numbers<'a, T>, pulls: &'s [T]) -> Self {
        let smooth = |tie: &Tie| matches!(tie, Tie::Slide { .. }).then(T::zero);
        let kinetic = scene.ties.iter().map(smooth).collect();
        Self { scene, n, pulls, holds: smallvec![false; scene.ties.len()], kinetic, rolled: SmallVec::new() }
    }

    /// The friction of a contact that holds besides those that do, the others as they rub.
    fn friction_if_held(&self, tie: usize) -> T {
        let (mut holds, mut kinetic) = (self.holds.clone(), self.kinetic.clone());
        (holds[tie], kinetic[tie]) = (true, None);
        self.reactions(&holds, &kinetic)[tie]
    }

    fn reactions(&self, holds: &[bool], kinetic: &[Option<T>]) -> balance::Reactions<T> {
        let modes = speeds::modes(self.scene, self.n, holds);
        let rate = drive(self.scene, self.n, &modes, &frictions(kinetic), self.pulls);
        balance::reactions(self.scene, self.n, &|c: Coordinate| rate.of(c), self.pulls, kinetic)
    }

    /// Contacts that are said to slip: friction in the sense that it would have if they rolled, each with the others as declared.
    pub fn slips(&mut self) {
        let slipping: SmallVec<[usize; 2]> =
            (0..self.scene.ties.len()).filter(|t| matches!(self.scene.ties[*t], Tie::Slip { .. })).collect();
        if slipping.is_empty() {
            return;
        }
        let mut holds = self.holds.clone();
        slipping.iter().for_each(|t| holds[*t] = true);
        let all = self.reactions(&holds, &self.kinetic);
        for t in &slipping {
            self.rub(*t, all[*t]);
        }
        if let [only] = slipping[..] {
            self.rolled.push((only, all[only]));
            return;
        }
        for settled in [false, true] {
            for t in &slipping {
                let friction = self.friction_if_held(*t);
                self.rub(*t, friction);
                if settled {
                    self.rolled.push((*t, friction));
                }
            }
        }
    }

    /// Kinetic friction in the sense of a force.
    fn rub(&mut self, tie: usize, like: T) {
        let Some(rub) = self.scene.ties[tie].rubbing() else { return };
        let normal = balance::normal(self.scene, self.n, rub.body);
        let most = plant!("energy: kinetic friction", self.n.get(rub.mu_k)) * normal;
        self.kinetic[tie] = Some(most.signed(like.sign()));
    }

    /// Bodies that slide go in these senses, or are held: the work of sliding friction is negative, whichever way a body goes. The
    /// friction that has to be overcome at the start, where nothing is held.
    pub fn slides(&mut self, going: SmallVec<[f64; 4]>, started: bool) -> PerTie<T> {
        let at_start = self.friction(&going, !started);
        for (t, tie) in self.scene.ties.iter().enumerate() {
            self.holds[t] = matches!(tie, Tie::Slide { body, .. } if going[*body] == 0.0);
        }
        // What static friction takes more power from than all else gives does not set off.
        let mut settled = started;
        while !settled {
            let most = self.friction(&going, true);
            let modes = speeds::modes(self.scene, self.n, &self.holds);
            let first = drive(self.scene, self.n, &modes, &most, self.pulls);
            let before = self.holds.clone();
            for (t, tie) in self.scene.ties.iter().enumerate() {
                if let Tie::Slide { body, .. } = tie {
                    self.holds[t] |= first.v[*body].sign() * going[*body] <= 0.0;
                }
            }
            settled = self.holds == before;
        }
        self.friction(&going, false);
        at_start
    }

    /// Of what slides: held by static friction, which is then a reaction, or sliding with this coefficient.
    fn friction(&mut self, going: &[f64], starting: bool) -> PerTie<T> {
        for (t, tie) in self.scene.ties.iter().enumerate() {
            if let Tie::Slide { body, mu_s, mu_k } = tie {
                let mu = if starting { mu_s.unwrap_or(*mu_k) } else { *mu_k };
                let most = self.n.get(mu) * balance::normal(self.scene, self.n, *body);
                self.kinetic[t] = (!self.holds[t]).then(|| most.signed(-going[*body]));
            }
        }
        frictions(&self.kinetic)
    }

    /// The work of what slides counts in what the contacts that slip would need to roll.
    pub fn rolled_beside_sliding(&mut self) {
        for i in 0..self.rolled.len() {
            let tie = self.rolled[i].0;
            self.rolled[i].1 = self.friction_if_held(tie);
        }
    }
}
