//! Wrong roads that students take: where each comes to, from a changed scene, changed data or a change of the value, and what
//! is said about it ([`catalogue`]).
pub mod catalogue;

use crate::bank::Mistake;
use crate::bank::Problem;
use crate::num::Real;
use crate::scene::Label;
use crate::scene::Scene;
use crate::solve::agree;
use crate::solve::outcome::Entry;
use crate::solve::outcome::Solved;

/// Where a wrong method comes to for one quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrong {
    /// Index of the method in the problem.
    pub mistake: usize,
    /// The quantity.
    pub label: Label,
    /// What it comes to, SI; finite.
    pub value: f64,
}

/// A method that names no quantities spoils those that come out different by more than rounding of doubles.
const SAME: f64 = 1e-9;

/// Where the wrong methods of a problem come to for these quantities, in the order of the methods, then of the quantities. A
/// method without a real answer (a wheel that would not move) has no value.
pub fn values(problem: &Problem, case: usize, data: &[f64], solved: &Solved, labels: &[Label]) -> Vec<Wrong> {
    values_while(problem, case, data, solved, labels, &mut |_| true)
}

/// The same, as long as each value that is found is to be followed by others: a method is finished, the next one not begun.
pub fn values_while(
    problem: &Problem,
    case: usize,
    data: &[f64],
    solved: &Solved,
    labels: &[Label],
    go_on: &mut dyn FnMut(&Wrong) -> bool,
) -> Vec<Wrong> {
    let mut found = Vec::new();
    let Some(scene) = problem.cases.get(case).map(|c| &c.scene) else { return found };
    for (index, mistake) in problem.mistakes.iter().enumerate() {
        if !mistake.cases.is_empty() && !mistake.cases.contains(&case) {
            continue;
        }
        let mut more = true;
        one(problem, mistake, (case, scene), data, solved, labels, &mut |label, value| {
            let wrong = Wrong { mistake: index, label, value };
            more &= go_on(&wrong);
            found.push(wrong);
        });
        if !more {
            break;
        }
    }
    found
}

fn one(
    problem: &Problem,
    mistake: &Mistake,
    (case, scene): (usize, &Scene),
    data: &[f64],
    solved: &Solved,
    labels: &[Label],
    tell: &mut dyn FnMut(Label, f64),
) {
    let right = |label: Label| solved.get(label).map_or(f64::NAN, Entry::value);
    let changes = !mistake.data.is_empty() || !mistake.scenes.is_empty();
    let spoilt = |label: Label| mistake.of.is_empty() || mistake.of.contains(&label);
    // Most methods come to a value by an expression alone.
    let changed = if changes { self::changed(problem, mistake, (case, scene), data, &right) } else { None };
    let other = |label: Label| match &changed {
        Some(road) => road.iter().find(|(l, _)| *l == label).map_or(f64::NAN, |(_, v)| *v),
        // Without such a motion only what follows from the data alone has a value.
        None if changes => f64::NAN,
        None => right(label),
    };
    for label in labels {
        let expression = mistake.values.iter().find(|(l, _)| l == label).map(|(_, e)| e);
        let value = match expression {
            Some(e) => e.eval(data, &other),
            None if changes && spoilt(*label) => other(*label),
            None => continue,
        };
        let truth = right(*label);
        let same = (value - truth).abs() <= SAME * value.abs().max(truth.abs());
        if value.is_finite() && truth.is_finite() && !(same && expression.is_none() && mistake.of.is_empty())
        {
            tell(*label, value);
        }
    }
}

/// The solution of the scene that the method takes for the right one.
fn changed(
    problem: &Problem,
    mistake: &Mistake,
    (case, scene): (usize, &Scene),
    data: &[f64],
    right: &dyn Fn(Label) -> f64,
) -> Option<Vec<(Label, f64)>> {
    let scene = match mistake.scenes.is_empty() {
        true => scene,
        false => mistake.scenes.get(case)?.as_ref()?,
    };
    let mut taken = data.to_vec();
    for (index, expression) in &mistake.data {
        let value = expression.eval(data, right);
        let degrees = problem.data.get(*index).is_some_and(|d| d.degrees);
        *taken.get_mut(*index)? = if degrees { value.to_degrees() } else { value };
    }
    let road = agree::quick(scene, &taken).ok()?;
    // A swing that does not come to its end tells what holds at the start: nobody's answer to what is asked at the end.
    if scene.pinned().is_some() && road.course.as_ref().is_some_and(|c| c.asked.is_some() && !c.reached) {
        return None;
    }
    Some(road.said.iter().map(|s| (s.label, s.value.f64())).collect())
}
