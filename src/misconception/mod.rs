//! Wrong roads that students take: where each comes to, from a changed scene, changed data or a change of the value, and what
//! is said about it ([`catalogue`]).
#[cfg(feature = "program")]
pub mod catalogue;

use crate::bank::expression::Expression;
use crate::bank::{Case, Mistake, Problem};
use crate::num::formula::Formula;
use crate::num::lanes::LANES;
use crate::scene::{Label, Owner, Quantity, Scene, Term};
use crate::solve::agree::{self, Quick};
use crate::solve::outcome::{Scope, Set, Solved, Told};

/// Where a wrong method comes to for one quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrong {
    /// Index of the method in the problem.
    pub mistake: usize,
    /// The quantity.
    pub label: Label,
    /// Its place among the quantities that were asked for.
    pub asked: usize,
    /// What it comes to, SI; finite.
    pub value: f64,
}

/// The words of a wrong method that hints use.
#[derive(Debug, Clone, Copy)]
pub struct MethodWords<'w> {
    /// What the student did.
    pub did: &'w str,
    /// How to see that it is wrong.
    pub see: &'w str,
    /// A question that leads on.
    pub hint: &'w str,
}

/// Methods that are solved together at most, beside the right data that lead them; a page does not gain from that.
const TOGETHER: usize = if cfg!(feature = "program") { LANES - 1 } else { 1 };

/// A method that names no quantities spoils those that come out different by more than rounding of doubles.
const SAME: f64 = 1e-9;

/// Where the wrong methods of a problem come to for these quantities, in the order of the methods, then of the quantities. A
/// method without a real answer (a wheel that would not move) has no value.
pub fn values(problem: &Problem, case: usize, data: &[f64], solved: &Solved, labels: &[Label]) -> Vec<Wrong> {
    Methods::new(problem, case, labels, &|_| true).values_while(data, solved, &mut |_| true)
}

/// Where one wrong method, an index into those of the problem, comes to for one quantity; `None` where it has no value.
pub fn value(
    problem: &Problem,
    case: usize,
    (data, solved): (&[f64], &Solved),
    (mistake, label): (usize, Label),
) -> Option<f64> {
    let methods = Methods::new(problem, case, &[label], &|index| index == mistake);
    methods.values_while(data, solved, &mut |_| true).first().map(|w| w.value)
}

/// The wrong methods of one case of a problem and the quantities that they are asked for, ready for many draws.
#[derive(Debug)]
pub struct Methods<'p> {
    problem: &'p Problem,
    /// Those that need no other solution first: they cost least. Then those that are solved together.
    methods: Vec<PreparedMethod<'p>>,
}

/// One wrong method in one case.
#[derive(Debug)]
struct PreparedMethod<'p> {
    /// Its index in the problem.
    index: usize,
    mistake: &'p Mistake,
    /// The right scene: quantities in expressions are taken as it asks them.
    scene: &'p Scene,
    /// The scene that it solves, if it changes scene or data, and what it asks of it.
    solves: Option<Quick<'p>>,
    asked: Scope,
    /// Is it solved together with others that only change data?
    joins: bool,
    /// What it spoils: a quantity, its place among those asked for, and how it comes to it.
    spoils: Vec<(Label, usize, SpoiltBy<'p>)>,
    /// How many values the methods before it in the problem have.
    before: usize,
}

/// How a wrong method comes to a quantity.
#[derive(Debug, Clone, Copy)]
enum SpoiltBy<'p> {
    /// From the changed scene or data.
    Change,
    /// By an expression.
    Expression(&'p Expression),
    /// It is asked by an expression, of which the method spoils a part.
    Part(&'p Formula<Term>),
}

impl<'p> Methods<'p> {
    /// Prepares the methods of these indices that are taken in this case.
    pub fn new(problem: &'p Problem, case: usize, labels: &[Label], wanted: &dyn Fn(usize) -> bool) -> Self {
        let Some(Case { scene: right, .. }) = problem.cases.get(case) else {
            return Self { problem, methods: Vec::new() };
        };
        let taken = |m: &Mistake| m.cases.is_empty() || m.cases.contains(&case);
        let mistakes = problem.mistakes.iter().enumerate().filter(|(i, m)| wanted(*i) && taken(m));
        let method = |(index, mistake): (usize, &'p Mistake)| {
            let changes = !mistake.data.is_empty() || !mistake.scenes.is_empty();
            let scene = match mistake.scenes.is_empty() {
                true => Some(right),
                false => mistake.scenes.get(case).and_then(Option::as_ref),
            };
            let spoils = labels.iter().enumerate().filter_map(|(asked, label)| {
                let expression = |label: &Label| mistake.values.iter().find(|(l, _)| l == label);
                let spoilt = |label: &Label| changes && (mistake.of.is_empty() || mistake.of.contains(label));
                if let Some((_, by)) = expression(label) {
                    return Some((*label, asked, SpoiltBy::Expression(by)));
                }
                // A part that has its own expression, or alone is spoilt, spoils what is put together of it.
                let part = |term: Term| match term {
                    Term::Said(part) => {
                        expression(&part).is_some() || spoilt(&part) && !mistake.of.is_empty()
                    }
                    Term::Given(_) | Term::Other(..) => false,
                };
                let formula = match label.of {
                    Owner::Asked(i) => right.formulas.asked.get(i).map(|a| &a.formula),
                    _ => None,
                };
                match formula.filter(|f| f.names().any(part)) {
                    Some(formula) => Some((*label, asked, SpoiltBy::Part(formula))),
                    None => spoilt(label).then_some((*label, asked, SpoiltBy::Change)),
                }
            });
            let spoils: Vec<(Label, usize, SpoiltBy)> = spoils.collect();
            let changed: Vec<usize> = mistake.data.iter().map(|(i, _)| *i).collect();
            let solves = scene.filter(|_| changes).map(|scene| Quick::new(scene, right, &changed));
            let asked = Scope::only(spoils.iter().flat_map(needed).map(|label| label.quantity));
            let joins = solves.is_some() && mistake.scenes.is_empty() && agree::side_by_side(right);
            PreparedMethod { index, mistake, scene: right, solves, asked, joins, spoils, before: 0 }
        };
        let mut methods: Vec<PreparedMethod> =
            mistakes.map(method).filter(|m| !m.spoils.is_empty()).collect();
        let mut before = 0;
        for method in &mut methods {
            method.before = before;
            before += method.spoils.len();
        }
        methods
            .sort_unstable_by_key(|m| (m.solves.is_some(), !m.joins, m.mistake.unguarded.is_some(), m.index));
        Self { problem, methods }
    }

    /// The quantities of the right solution from which they start.
    pub fn quantities(&self) -> impl Iterator<Item = Quantity> {
        self.methods.iter().flat_map(|m| {
            let data = m.mistake.data.iter().flat_map(|(_, e)| e.quantities());
            let values = m.spoils.iter().flat_map(|s| needed(s).chain([s.0]));
            data.chain(values).map(|label| label.quantity)
        })
    }

    /// Where they come to, in the order of the problem. After a value of which `go_on` says no, no other method is begun; it is
    /// asked about the cheap methods first.
    pub fn values_while(
        &self,
        data: &[f64],
        solved: &Solved,
        go_on: &mut dyn FnMut(&Wrong) -> bool,
    ) -> Vec<Wrong> {
        let mut found: Vec<Option<Wrong>> = vec![None; self.methods.iter().map(|m| m.spoils.len()).sum()];
        let mut left = &self.methods[..];
        'all: while !left.is_empty() {
            let together = left.iter().take(TOGETHER).take_while(|m| m.joins).count().max(1);
            let (methods, others) = left.split_at(together);
            left = others;
            let mut roads = self.roads(methods, data, solved).into_iter();
            for method in methods {
                let (mut more, mut place) = (true, method.before);
                method.values(roads.next().flatten().as_ref(), data, solved, &mut |wrong| {
                    more &= go_on(&wrong);
                    found[place] = Some(wrong);
                    place += 1;
                });
                if !more {
                    break 'all;
                }
            }
        }
        // In one piece: collected, it would grow piece by piece.
        let mut all = Vec::with_capacity(found.len());
        all.extend(found.into_iter().flatten());
        all
    }

    /// The solutions of the scenes that these methods take for the right one.
    fn roads(&self, methods: &[PreparedMethod], data: &[f64], solved: &Solved) -> Vec<Option<Told>> {
        let Some(quick) = &methods[0].solves else { return Vec::new() };
        let mut sets: Vec<Set> = Vec::with_capacity(methods.len() + 1);
        // Several sets are solved as the first one moves: the right one leads.
        let leads = usize::from(methods.len() > 1);
        sets.extend((leads > 0).then(|| data.to_vec()));
        let admitted =
            methods.iter().map(|m| m.changed(self.problem, data, solved).map(|set| sets.push(set)));
        let admitted: Vec<Option<()>> = admitted.collect();
        let asked = methods.iter().fold(Scope::only([]), |all, m| all.with(m.asked));
        let mut found = quick.roads(&sets, asked).into_iter().skip(leads);
        // A swing that does not come to its end tells what holds at the start: nobody's answer to what is asked at the end.
        let stops = |told: &Told| match told {
            Told::Alone(road) => road.course.is_some_and(|c| c.asked.is_some() && !c.reached),
            #[cfg(feature = "program")]
            Told::Lane(..) => false,
        };
        let ends = |told: &Told| !(quick.is_pinned() && stops(told));
        admitted.into_iter().map(|set| set.and_then(|()| found.next()?.filter(ends))).collect()
    }
}

/// The quantities of a solution from which the value of a spoilt one is made. A scene that asks by formulas says them all.
fn needed<'e>((label, _, by): &'e (Label, usize, SpoiltBy)) -> impl Iterator<Item = Label> + 'e {
    let (own, expression) = match by {
        SpoiltBy::Expression(expression) => (None, Some(expression)),
        SpoiltBy::Change | SpoiltBy::Part(_) => (Some(*label), None),
    };
    own.into_iter().chain(expression.into_iter().flat_map(|e| e.quantities()))
}

impl PreparedMethod<'_> {
    /// What it comes to, with the solution of the scene that it takes for the right one.
    fn values(&self, changed: Option<&Told>, data: &[f64], solved: &Solved, tell: &mut dyn FnMut(Wrong)) {
        let right = |label: Label| solved.asked(self.scene, label);
        let changes = !self.mistake.data.is_empty() || !self.mistake.scenes.is_empty();
        let other = |label: Label| match changed {
            Some(told) => told.value(0, label).map_or(f64::NAN, |value| self.scene.as_asked(label, value)),
            // Without such a motion only what follows from the data alone has a value.
            None if changes => f64::NAN,
            None => right(label),
        };
        let part = |term: Term| match term {
            Term::Given(given) => given.value(data),
            Term::Other(..) => f64::NAN,
            Term::Said(label) => match self.mistake.values.iter().find(|(l, _)| *l == label) {
                Some((_, by)) => by.eval(data, &other),
                None if changes && (self.mistake.of.is_empty() || self.mistake.of.contains(&label)) => {
                    other(label)
                }
                None => right(label),
            },
        };
        for (label, asked, by) in &self.spoils {
            let (label, truth) = (*label, right(*label));
            let value = match by {
                SpoiltBy::Change => other(label),
                SpoiltBy::Expression(expression) => expression.eval(data, &other),
                SpoiltBy::Part(formula) => formula.eval(&part),
            };
            let same = (value - truth).abs() <= SAME * value.abs().max(truth.abs());
            let all = !matches!(by, SpoiltBy::Expression(_)) && self.mistake.of.is_empty();
            if value.is_finite() && truth.is_finite() && !(same && all) {
                tell(Wrong { mistake: self.index, label, asked: *asked, value });
            }
        }
    }

    /// The data that the method takes for the right ones, if they are such a scene.
    fn changed(&self, problem: &Problem, data: &[f64], solved: &Solved) -> Option<Set> {
        let right = |label: Label| solved.asked(self.scene, label);
        let mut taken = data.to_vec();
        for (index, expression) in &self.mistake.data {
            let value = expression.eval(data, &right);
            let degrees = problem.data.get(*index).is_some_and(|d| d.degrees);
            *taken.get_mut(*index)? = if degrees { value.to_degrees() } else { value };
        }
        self.solves.as_ref()?.admits(&taken).then_some(taken)
    }
}
