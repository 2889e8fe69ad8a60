//! How many freedoms the ties leave, whatever the data: for telling what is no scene that is solved, not for solving.
use crate::num::eliminate::Equations;
use crate::scene::{Attach, Coordinate, CordEnd, Degree, Far, Num, Scene, Side, Tie};

/// A number in the place of a datum that is not known: of no simple ratio to those of the other data.
fn stand_in(datum: usize) -> f64 {
    (2.0 + datum as f64).sqrt() + 1.0 / (3.0 + datum as f64)
}

impl Scene {
    /// Coordinates less the ties that say something of their own, whatever the data; contacts that slip or slide hold nothing.
    pub fn freedoms(&self) -> usize {
        self.freedoms_with(&|number| match number {
            Num::Fixed(x) => x,
            Num::Datum(i) => stand_in(i),
            Num::Derived(i) => {
                let formula = self.formulas.numbers.get(i).map(|n| &n.formula);
                formula.map_or(f64::NAN, |f| f.eval(&|given| stand_in(given.datum)))
            }
        })
    }

    /// At an instant (`end: at once`): are accelerations and forces told besides velocities and energies? Where a scene that goes
    /// on is solved too; beside springs, of one freedom and where nothing rubs.
    pub fn tells_rates(&self) -> bool {
        let slips = self.ties.iter().any(|t| matches!(t, Tie::Slip { .. }));
        let slides = self.ties.iter().any(|t| matches!(t, Tie::Slide { .. }));
        let bodies = self.bodies.iter().all(|b| b.planar.is_none() && b.particles.is_empty());
        let alone = self.freedoms() <= 1;
        let still = self.start.is_empty();
        let pulled = !self.is_sprung() || alone && !slips && !slides;
        bodies && pulled && (alone || still) && (!slips || still)
    }

    /// [`Scene::freedoms`] for these numbers: another count where data are equal by chance.
    pub fn freedoms_with(&self, number: &dyn Fn(Num) -> f64) -> usize {
        let coordinates: Vec<Coordinate> = self.coordinates().collect();
        let place =
            |body: usize, degree: Degree| coordinates.iter().position(|c| *c == Coordinate { body, degree });
        let mut ties: Equations<f64> = Equations::new(coordinates.len());
        for tie in &self.ties {
            let ends: [Option<&CordEnd>; 2] = match tie {
                Tie::Roll { body, radius_m, .. } => {
                    let row = ties.row();
                    let along = place(*body, Degree::Along).map(|i| (i, 1.0));
                    let turn = place(*body, Degree::Turn).map(|i| (i, -number(*radius_m)));
                    along.into_iter().chain(turn).for_each(|(i, x)| row[i] = x);
                    continue;
                }
                Tie::Cord(cord) => match &cord.to {
                    Far::Fixed => [Some(&cord.from), None],
                    Far::Body(other) => [Some(&cord.from), Some(other)],
                    Far::Pull(_) | Far::Spring { .. } => continue,
                },
                Tie::Slip { .. } | Tie::Slide { .. } => continue,
            };
            let row = ties.row();
            for end in ends.into_iter().flatten() {
                let toward = if end.forward { 1.0 } else { -1.0 };
                if let Some(i) = place(end.body, Degree::Along) {
                    row[i] += toward;
                }
                if let (Attach::Wound(p, side), Some(i)) = (end.attach, place(end.body, Degree::Turn)) {
                    row[i] += toward * number(p) * if side == Side::Top { 1.0 } else { -1.0 };
                }
            }
        }
        coordinates.len() - ties.reduce(&[]).rank()
    }
}
