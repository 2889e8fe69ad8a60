//! What an instructor writes as a formula: numbers of a scene that are worked out from data.
use crate::num::formula::Formula;
use crate::num::{Real, trig};
use crate::scene::{Num, Scene};

/// A datum in a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Given {
    /// Its index.
    pub datum: usize,
    /// Does the scene hold it in degrees? Formulas count angles in radians.
    pub degrees: bool,
    /// Exponents of mass, length and time in its unit.
    pub powers: [i32; 3],
}

impl Given {
    /// Its value, SI; NaN where there is no such datum.
    pub fn value<T: Real>(self, data: &[f64]) -> T {
        let value = T::datum(data.get(self.datum).copied().unwrap_or(f64::NAN));
        if self.degrees { value * trig::radians_per_degree() } else { value }
    }
}

/// A number of the scene that is worked out from data.
#[derive(Debug, Clone, PartialEq)]
pub struct Derived {
    /// How, SI.
    pub formula: Formula<Given>,
    /// Does the scene take it in degrees?
    pub degrees: bool,
    /// As it is written.
    pub text: String,
}

impl Derived {
    /// Its value, as the scene takes it.
    pub fn value<T: Real>(&self, data: &[f64]) -> T {
        let value: T = self.formula.eval(&|given: Given| given.value(data));
        if self.degrees { value * trig::degrees_per_radian() } else { value }
    }
}

/// The formulas of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Formulas {
    /// Numbers that are worked out from data; index = [`Num::Derived`].
    pub numbers: Vec<Derived>,
}

impl Formulas {
    /// Every datum that a formula looks up.
    pub fn givens(&self) -> impl Iterator<Item = Given> {
        self.numbers.iter().flat_map(|n| n.formula.names())
    }
    /// Says which data the scene holds in degrees.
    pub fn settle(&mut self, degrees: &dyn Fn(usize) -> bool) {
        for number in &mut self.numbers {
            number.formula = number.formula.map(&mut |g: Given| Given { degrees: degrees(g.datum), ..g });
        }
    }
}

impl Scene {
    /// A number of the scene in doubles, as the scene takes it; NaN where there is no such datum.
    pub fn value(&self, number: Num, data: &[f64]) -> f64 {
        match number {
            Num::Datum(i) => data.get(i).copied().unwrap_or(f64::NAN),
            Num::Fixed(x) => x,
            Num::Derived(i) => self.formulas.numbers.get(i).map_or(f64::NAN, |n| n.value(data)),
        }
    }
    /// The data on which a number of the scene hangs.
    pub fn data_of(&self, number: Num) -> impl Iterator<Item = usize> {
        let (itself, formula) = match number {
            Num::Datum(i) => (Some(i), None),
            Num::Derived(i) => (None, self.formulas.numbers.get(i)),
            Num::Fixed(_) => (None, None),
        };
        itself.into_iter().chain(formula.into_iter().flat_map(|n| n.formula.names().map(|g| g.datum)))
    }
}
