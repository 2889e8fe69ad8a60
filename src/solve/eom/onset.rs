//! What a motion sets off with: which contacts hold, and against what the others rub.
use crate::num::Real;
use crate::scene::{Coordinate, Degree, Numbers, Scene, Tie};
use crate::solve::eom::equations::{Response, Setting, held, respond};
use crate::solve::eom::{Rolled, under};
use crate::solve::outcome::{Refusal, Unsupported};
use smallvec::SmallVec;

/// The contacts of a scene at the start of a motion with one freedom, or from rest.
pub struct Onset<'s, 'a, T: Real> {
    /// The scene.
    pub scene: &'s Scene,
    /// Its numbers.
    pub n: &'s Numbers<'a, T>,
    /// What the springs pull.
    pub pulls: &'s [T],
    /// How the contacts are taken.
    pub setting: Setting,
    /// The accelerations and reactions then.
    pub response: Response<T>,
    /// Those with one slipping contact taken as rolling.
    pub rolled: Rolled<T>,
}

/// The velocity of a coordinate at the start, as a response gives it.
pub type Velocity<'f, T> = &'f dyn Fn(&Response<T>, Coordinate) -> T;

/// The line of a body that slides at this tie.
fn sliding(scene: &Scene, tie: usize) -> Option<Coordinate> {
    match scene.ties[tie] {
        Tie::Slide { body, .. } => Some(Coordinate { body, degree: Degree::Along }),
        _ => None,
    }
}

impl<T: Real> Onset<'_, '_, T> {
    fn acceleration(&self, c: Coordinate) -> T {
        under(self.pulls, |k| self.response.acceleration(c, k))
    }
    fn reaction(&self, r: &Response<T>, tie: usize) -> T {
        under(self.pulls, |k| r.reaction(tie, k))
    }
    fn respond(&mut self) -> Result<(), Refusal> {
        self.response = respond(self.scene, self.n, &self.setting)?;
        Ok(())
    }

    /// Contacts that are said to slip, from rest: kinetic friction has the sense that static friction would have, the other contacts as
    /// declared. The response is so far that with all of them held.
    pub fn slips(&mut self, slipping: &[usize]) -> Result<(), Refusal> {
        if let Some(shared) = slipping.iter().find(|t| self.response.is_open(**t)) {
            return Err(Refusal::SlipShared(*shared));
        }
        for t in slipping {
            self.setting.friction_sense[*t] = self.reaction(&self.response, *t).sign();
            self.setting.holds[*t] = false;
        }
        if let [only] = slipping {
            self.rolled.push((*only, self.response.clone()));
        } else {
            for settled in [false, true] {
                for t in slipping {
                    let one = held(self.scene, self.n, &self.setting, *t)?;
                    self.setting.friction_sense[*t] = self.reaction(&one, *t).sign();
                    if settled {
                        self.rolled.push((*t, one));
                    }
                }
            }
        }
        self.respond()
    }

    /// Bodies that slide: against the motion, which is that of the start if there is one, else the one that would set in without
    /// friction.
    pub fn slides(&mut self, velocity: Option<Velocity<'_, T>>) -> Result<(), Refusal> {
        let ties = self.scene.ties.len();
        for t in 0..ties {
            let Some(c) = sliding(self.scene, t) else { continue };
            let goes = velocity.map_or_else(|| self.acceleration(c), |v| v(&self.response, c));
            self.setting.friction_sense[t] = -goes.sign();
            self.setting.holds[t] = goes.sign() == 0.0;
        }
        let from_rest = velocity.is_none();
        if from_rest {
            self.held_back()?;
        }
        self.respond()?;
        let in_turn = Err(Refusal::Unsupported(Unsupported::SlidesInTurn));
        if from_rest && !(0..ties).all(|t| sliding(self.scene, t).is_none_or(|c| self.is_settled(t, c))) {
            return in_turn;
        }
        // What slips may pull what slides: the friction that it would need is told with theirs.
        for (t, _) in std::mem::take(&mut self.rolled) {
            let one = held(self.scene, self.n, &self.setting, t)?;
            let turned = self.reaction(&one, t).sign() * self.setting.friction_sense[t] < 0.0;
            let back = |s: usize| {
                let a = sliding(self.scene, s).map(|c| under(self.pulls, |k| one.acceleration(c, k)).sign());
                !self.setting.holds[s] && a.is_some_and(|a| a * self.setting.friction_sense[s] > 0.0)
            };
            if turned || (0..ties).any(back) {
                return in_turn;
            }
            self.rolled.push((t, one));
        }
        Ok(())
    }

    /// What static friction can turn back stays, and may take others with it.
    fn held_back(&mut self) -> Result<(), Refusal> {
        self.setting.starting = true;
        loop {
            self.respond()?;
            let turned = |t: &usize| {
                let back = |c| self.acceleration(c).sign() * self.setting.friction_sense[*t] >= 0.0;
                !self.setting.holds[*t] && sliding(self.scene, *t).is_some_and(back)
            };
            let turned: SmallVec<[usize; 4]> = (0..self.scene.ties.len()).filter(turned).collect();
            if turned.is_empty() {
                break;
            }
            turned.into_iter().for_each(|t| self.setting.holds[t] = true);
        }
        self.setting.starting = false;
        Ok(())
    }

    /// With several freedoms what one body does may free or turn another: then no guess is made.
    fn is_settled(&self, t: usize, c: Coordinate) -> bool {
        if !self.setting.holds[t] {
            return self.acceleration(c).sign() * self.setting.friction_sense[t] < 0.0;
        }
        let (Tie::Slide { mu_s, mu_k, .. }, false) = (&self.scene.ties[t], self.response.is_open(t)) else {
            return true;
        };
        let friction = self.reaction(&self.response, t);
        friction.abs().at_most(self.n.get(mu_s.unwrap_or(*mu_k)) * self.response.normal(c.body))
    }
}
