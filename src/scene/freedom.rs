//! How many freedoms the ties leave, whatever the data: for telling what is no scene that is solved, not for solving.
use crate::num::eliminate::Equations;
use crate::scene::{Body, Coordinate, Degree, End, Far, Num, Scene, Tie};

/// A number in the place of a datum that is not known: of no simple ratio to those of the other data.
fn stand_in(datum: usize) -> f64 {
    (2.0 + datum as f64).sqrt() + 1.0 / (3.0 + datum as f64)
}

impl Scene {
    /// Coordinates less the ties that say something of their own, whatever the data; contacts that slip or slide hold nothing.
    pub fn freedoms(&self) -> usize {
        self.left(&|number| self.any(number), None, &[])
    }

    /// This coordinate, and others whose velocities with its own give all that the ties leave open, whatever the data.
    pub fn free(&self, first: Coordinate) -> Vec<Coordinate> {
        let mut free = vec![first];
        for c in self.coordinates() {
            let left = |free: &[Coordinate]| self.left(&|number| self.any(number), None, free);
            let before = left(&free);
            free.push(c);
            if left(&free) == before {
                free.pop();
            }
        }
        free
    }

    /// A number, whatever the data.
    fn any(&self, number: Num) -> f64 {
        match number {
            Num::Fixed(x) => x,
            Num::Datum(i) => stand_in(i),
            Num::Derived(i) => {
                let formula = self.formulas.numbers.get(i).map(|n| &n.formula);
                formula.map_or(f64::NAN, |f| f.eval(&|given| stand_in(given.datum)))
            }
        }
    }

    /// At an instant (`end: at once`): are accelerations and forces told besides velocities and energies? Not of particles or of joined
    /// bodies, nor where a contact that is said to slip is held by the other ties while something moves.
    pub fn tells_rates(&self) -> bool {
        let lines = self.bodies.iter().all(|b| b.planar.is_none() && b.particles.is_empty());
        lines && !(self.goes_in_phases() && self.holds_slip())
    }

    /// Do the other ties hold a contact that is said to slip?
    fn holds_slip(&self) -> bool {
        let mut slips = (0..self.ties.len()).filter(|t| matches!(self.ties[*t], Tie::Slip { .. }));
        slips.any(|t| self.left(&|number| self.any(number), Some(t), &[]) == self.freedoms())
    }

    /// Is it followed in phases, each of which lasts until a contact that rubs comes to rest? With a speed at the start under constant
    /// forces, where a contact is said to slip or several freedoms are left.
    pub fn goes_in_phases(&self) -> bool {
        let constant = self.growths.is_empty() && (!self.is_sprung() || matches!(self.end, End::AtOnce));
        let lines = |b: &Body| b.planar.is_none() && b.particles.is_empty();
        let slips = || self.ties.iter().any(|t| matches!(t, Tie::Slip { .. }));
        !self.start.is_empty()
            && constant
            && self.bodies.iter().all(lines)
            && (slips() || self.freedoms() > 1)
    }

    /// Is it the end that the contact of this tie comes to rest?
    pub fn ends_with(&self, tie: usize) -> bool {
        self.ties[tie].rubbing().is_some_and(|rub| match self.end {
            End::Rolling(c) => rub.radius_m.is_some() && c.body == rub.body,
            End::TurningPoint(c) => rub.radius_m.is_none() && c.body == rub.body,
            _ => false,
        })
    }
    /// Does it end where a contact that rubs comes to rest?
    pub fn ends_slip(&self) -> bool {
        (0..self.ties.len()).any(|tie| self.ends_with(tie))
    }

    /// [`Scene::freedoms`] for these numbers: another count where data are equal by chance.
    pub fn freedoms_with(&self, number: &dyn Fn(Num) -> f64) -> usize {
        self.left(number, None, &[])
    }

    /// Those that are left where the contact of one tie, if any, holds that is said to slip, and the velocities of these are given.
    fn left(&self, number: &dyn Fn(Num) -> f64, held: Option<usize>, given: &[Coordinate]) -> usize {
        let coordinates: Vec<Coordinate> = self.coordinates().collect();
        let place =
            |body: usize, degree: Degree| coordinates.iter().position(|c| *c == Coordinate { body, degree });
        let mut ties: Equations<f64> = Equations::new(coordinates.len());
        for (t, tie) in self.ties.iter().enumerate() {
            let holds = match tie {
                Tie::Roll { .. } => true,
                Tie::Slip { .. } => held == Some(t),
                Tie::Slide { .. } => false,
                Tie::Cord(cord) => matches!(cord.to, Far::Fixed | Far::Body(_)),
            };
            if !holds {
                continue;
            }
            let row = ties.row();
            for action in tie.actions() {
                if let Some(i) = place(action.body, Degree::Along) {
                    row[i] += action.along;
                }
                if let (Some((radius, sense)), Some(i)) = (action.arm, place(action.body, Degree::Turn)) {
                    row[i] += number(radius) * sense;
                }
            }
        }
        for place in given.iter().filter_map(|c| place(c.body, c.degree)) {
            ties.row()[place] = 1.0;
        }
        coordinates.len() - ties.reduce(&[]).rank()
    }
}
