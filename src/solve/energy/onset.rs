//! What a motion with one freedom, or from rest, sets off with: which contacts hold, and what those take that rub.
use crate::num::Real;
use crate::scene::Tie;
use crate::solve::energy::balance::{self, PerTie};
use crate::solve::energy::frictions;
use crate::solve::energy::phases::{Follower, slips};
use smallvec::{SmallVec, smallvec};

/// Of contacts that are said to slip: index of the tie, and its friction if it rolled.
pub type Rolled<T> = SmallVec<[(usize, T); 1]>;

impl<T: Real> Follower<'_, '_, T> {
    /// The friction of a contact that holds besides those that do, the others as they rub.
    pub fn friction_if_held(&mut self, tie: usize) -> T {
        let rubs = self.kinetic[tie].take();
        let friction = self.reactions(&self.rate())[tie];
        self.kinetic[tie] = rubs;
        friction
    }

    /// Contacts that are said to slip: friction in the sense that it would have if they rolled, each with the others as declared.
    pub fn slips(&mut self) -> Rolled<T> {
        let slipping: SmallVec<[usize; 2]> =
            (0..self.kinetic.len()).filter(|t| slips(self.scene, *t)).collect();
        if slipping.is_empty() {
            return Rolled::new();
        }
        let all = self.reactions(&self.rate());
        for t in &slipping {
            self.rub(*t, all[*t]);
        }
        if let [only] = slipping[..] {
            return smallvec![(only, all[only])];
        }
        let mut rolled = Rolled::new();
        for settled in [false, true] {
            for t in &slipping {
                let friction = self.friction_if_held(*t);
                self.rub(*t, friction);
                if settled {
                    rolled.push((*t, friction));
                }
            }
        }
        rolled
    }

    /// Kinetic friction in the sense of a force.
    fn rub(&mut self, tie: usize, like: T) {
        let friction = |rub| self.friction(&rub).signed(like.sign());
        self.kinetic[tie] = self.scene.ties[tie].rubbing().map(friction);
    }

    /// Bodies that slide go in these senses, or are held: the work of sliding friction is negative, whichever way a body goes. The
    /// friction that has to be overcome at the start, where nothing is held.
    pub fn slides(&mut self, going: &[f64], started: bool) -> PerTie<T> {
        let mut holds: PerTie<bool> = smallvec![false; self.kinetic.len()];
        self.slide(going, &holds, !started);
        let at_start = frictions(&self.kinetic);
        for (t, tie) in self.scene.ties.iter().enumerate() {
            holds[t] = matches!(tie, Tie::Slide { body, .. } if going[*body] == 0.0);
        }
        // What static friction takes more power from than all else gives does not set off.
        let mut settled = started;
        while !settled {
            self.slide(going, &holds, true);
            let first = self.rate();
            let before = holds.clone();
            for (t, tie) in self.scene.ties.iter().enumerate() {
                if let Tie::Slide { body, .. } = tie {
                    holds[t] |= first.v[*body].sign() * going[*body] <= 0.0;
                }
            }
            settled = holds == before;
        }
        self.slide(going, &holds, false);
        at_start
    }

    /// Of what slides: held by static friction, which is then a reaction, or sliding with this coefficient.
    fn slide(&mut self, going: &[f64], holds: &[bool], starting: bool) {
        for (t, tie) in self.scene.ties.iter().enumerate() {
            if let Tie::Slide { body, mu_s, mu_k } = tie {
                let mu = if starting { mu_s.unwrap_or(*mu_k) } else { *mu_k };
                let most = self.n.get(mu) * balance::normal(self.scene, self.n, *body);
                self.kinetic[t] = (!holds[t]).then(|| most.signed(-going[*body]));
            }
        }
    }
}
