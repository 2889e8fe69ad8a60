//! What an instructor writes as a formula: numbers of a scene that are worked out from data, and what is asked of its solution.
use crate::num::formula::Formula;
use crate::num::{Real, trig};
use crate::scene::{Coordinate, Degree, End, Label, Num, Owner, Quantity, Scene, Span, Tie};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A datum in a formula.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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
        let value = T::given(self.datum, data.get(self.datum).copied().unwrap_or(f64::NAN));
        if self.degrees { value * trig::radians_per_degree() } else { value }
    }
}

/// A number of the scene that is worked out from data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Derived {
    /// How, SI.
    pub formula: Formula<Given>,
    /// Does the scene take it in degrees?
    pub degrees: bool,
    /// As it is written; of what is `any`, a symbol.
    pub text: String,
    /// Is it `any`, so that no answer depends on it?
    pub any: bool,
}

impl Derived {
    /// Its value, as the scene takes it.
    pub fn value<T: Real>(&self, data: &[f64]) -> T {
        self.value_after(data, &[])
    }
    /// The same in a motion that follows another one: the last data are what it takes over, rounded to doubles, and `taken` is that
    /// in full.
    pub fn value_after<T: Real>(&self, data: &[f64], taken: &[T]) -> T {
        let first = data.len() - taken.len();
        let value: T = self.formula.eval(&|given: Given| {
            let taken = given.datum.checked_sub(first).and_then(|i| taken.get(i));
            taken.copied().unwrap_or_else(|| given.value(data))
        });
        if self.degrees { value * trig::degrees_per_radian() } else { value }
    }
}

/// What a motion takes over from the one before it. In its formulas these stand behind the data of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Taken {
    /// What the motion before it says.
    pub label: Label,
    /// Is that a magnitude, which has the sense of the motion before it?
    pub directed: bool,
}

/// How another scene, of which a question asks, differs from the one that is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum AsIf {
    /// Its contacts roll, whatever friction that needs.
    Rolls,
    /// They are smooth: without friction.
    Smooth,
    /// It is what follows: the motion that begins where the one that is told ends.
    Next,
}

/// What the formula of a question names.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Term {
    /// A datum.
    Given(Given),
    /// A quantity of the solution.
    Said(Label),
    /// A quantity of the solution of another scene, by its index in [`Formulas::others`].
    Other(usize, Label),
}

/// What a question asks that is no quantity as it stands: an expression in data and quantities, or a quantity of another scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Asked {
    /// Id of the question.
    pub id: String,
    /// What it asks, as it is written.
    pub text: String,
    /// How it is worked out, SI.
    pub formula: Formula<Term>,
    /// [`Quantity::Value`], or the quantity that is asked of the other scene.
    pub quantity: Quantity,
    /// Whose quantity it is.
    pub of: Owner,
    /// Its unit, SI, ASCII.
    pub unit: String,
    /// Exponents of mass, length and time in its unit.
    pub powers: [i32; 3],
}

/// A datum that is found from a measurement: it is not given, and its value is the one that gives the measured datum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// The datum that is found.
    pub unknown: Given,
    /// Least and greatest value that it may have, as the scene takes it.
    pub range: [f64; 2],
    /// The datum that was measured.
    pub measured: Given,
    /// What it is the measurement of.
    pub label: Label,
}

/// The formulas of a scene.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Formulas {
    /// Numbers that are worked out from data; index = [`Num::Derived`].
    pub numbers: Vec<Derived>,
    /// What is asked by formulas; index = [`Owner::Asked`].
    pub asked: Vec<Asked>,
    /// The scene as if its contacts were others, and the motion that follows.
    pub others: Vec<(AsIf, Scene)>,
    /// What this motion takes over, where it follows another one.
    pub taken: Vec<Taken>,
    /// What is found from a measurement.
    pub found: Option<Found>,
    /// Does the end say that what slides stays where it comes to rest?
    pub stays: bool,
    /// Numbers that are not above others beside them, which no tie says.
    pub below: Vec<(Num, Num)>,
}

impl Formulas {
    /// Every datum that a formula looks up.
    pub fn givens(&self) -> impl Iterator<Item = Given> {
        let found = self.found.iter().flat_map(|f| [f.unknown, f.measured]);
        let asked = self.asked.iter().flat_map(|a| a.formula.names()).filter_map(|term| match term {
            Term::Given(given) => Some(given),
            Term::Said(_) | Term::Other(..) => None,
        });
        self.numbers.iter().flat_map(|n| n.formula.names()).chain(asked).chain(found)
    }
    /// Says which data the scene holds in degrees.
    pub fn settle(&mut self, degrees: &dyn Fn(usize) -> bool) {
        for number in &mut self.numbers {
            number.formula = number.formula.map(&mut |g: Given| Given { degrees: degrees(g.datum), ..g });
        }
        if let Some(found) = &mut self.found {
            found.unknown.degrees = degrees(found.unknown.datum);
            found.measured.degrees = degrees(found.measured.datum);
        }
        for (_, other) in &mut self.others {
            other.formulas.settle(degrees);
        }
    }
}

impl Scene {
    /// Whose quantity the formula of a question names: of which scene, and which.
    pub fn quantity_of(&self, term: Term) -> Option<(&Self, Label)> {
        match term {
            Term::Given(_) => None,
            Term::Said(label) => Some((self, label)),
            Term::Other(at, label) => self.formulas.others.get(at).map(|(_, other)| (other, label)),
        }
    }
    /// A number of the scene in doubles, as the scene takes it; NaN where there is no such datum.
    pub fn value(&self, number: Num, data: &[f64]) -> f64 {
        let mut data = Cow::Borrowed(data);
        if let Some(found) = self.formulas.found
            && let Some(unknown) = data.to_mut().get_mut(found.unknown.datum)
        {
            // Anything of its range stands for what is to be found.
            *unknown = f64::midpoint(found.range[0], found.range[1]);
        }
        match number {
            Num::Datum(i) => data.get(i).copied().unwrap_or(f64::NAN),
            Num::Fixed(x) => x,
            Num::Derived(i) => self.formulas.numbers.get(i).map_or(f64::NAN, |n| n.value(&data)),
        }
    }
    /// Whose quantity this is; of what a formula asks of another scene, the body there.
    pub fn owner(&self, label: Label) -> Owner {
        match label.of {
            Owner::Asked(i) => self.formulas.asked.get(i).map_or(Owner::Scene, |a| a.of),
            owner => owner,
        }
    }
    /// Looks so far, as if its contacts were others too.
    pub fn look(&mut self, span: Span) {
        self.span = span;
        self.formulas.others.iter_mut().for_each(|(_, other)| other.span = span);
    }
    /// The unit of a quantity, SI, ASCII.
    pub fn unit(&self, label: Label) -> &str {
        match label.of {
            Owner::Asked(i) => self.formulas.asked.get(i).map_or("1", |a| a.unit.as_str()),
            _ => label.quantity.unit(),
        }
    }
    /// The scene as if its contacts rolled or were smooth; `None` where no contact makes a difference.
    pub fn as_if(&self, how: AsIf) -> Option<Self> {
        let mut other = self.clone();
        let mut touches = false;
        for tie in &mut other.ties {
            let smooth = Num::Fixed(0.0);
            *tie = match (how, tie.clone()) {
                (AsIf::Rolls, Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. }) => {
                    Tie::Roll { body, radius_m, mu_s: None }
                }
                (AsIf::Smooth, Tie::Roll { body, .. })
                    if !self.start.is_empty() && self.spins_freely(body) =>
                {
                    // Nothing changes its spin, and nothing else hangs on that.
                    other.bodies[body].turns = false;
                    Tie::Slide { body, mu_s: None, mu_k: smooth }
                }
                (AsIf::Smooth, Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. }) => {
                    Tie::Slip { body, radius_m, mu_s: smooth, mu_k: smooth }
                }
                (AsIf::Smooth, Tie::Slide { body, .. }) => Tie::Slide { body, mu_s: None, mu_k: smooth },
                (AsIf::Rolls, Tie::Slide { .. }) | (AsIf::Next, _) | (_, Tie::Cord(_)) => continue,
            };
            touches = true;
        }
        other.formulas.asked.clear();
        other.formulas.others.clear();
        other.formulas.found = None;
        touches.then_some(other)
    }
    /// Would a body that rolls keep its spin on a smooth surface, whatever else happens, and is its start told without that?
    fn spins_freely(&self, body: usize) -> bool {
        let acts = |t: &Tie| t.actions().filter(|a| a.body == body && a.arm.is_some()).count();
        let told = |c: &Coordinate| c.body == body && c.degree == Degree::Turn;
        self.ties.iter().map(acts).sum::<usize>() == 1
            && self.couples.iter().all(|c| c.body != body)
            && !self.start_speeds().any(|(c, _)| told(&c))
            && !matches!(self.end, End::Travel(c, _) | End::Speed(c, _) | End::Position(c, _) if told(&c))
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
