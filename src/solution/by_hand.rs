//! The answers of a careful student who solves by hand and rounds on the way.
//!
//! Whom this stands for: somebody who follows the worked solution, on one of its two roads, with a pocket calculator. Each
//! quantity that the solution names (a work, an effective mass, an acceleration, a tension) is computed from what stands on the
//! paper in one go, written down with so many figures, and used as it is written from there on. Data and g are exact as
//! printed; what the calculator does between two lines of the paper is exact too. This is the honest
//! reading of "intermediate results rounded to three figures": to round after every key of the calculator would be harsher than
//! anybody works, to move the data a little, as `lint` does, knows nothing of the steps. It needs no formula of its own: every
//! family that has a worked solution has these answers.
use crate::bank::Problem;
use crate::finding::Finding;
use crate::problem::make::Variant;
use crate::scene::Label;
use crate::solution::derive;
use crate::solution::desk::Answer;
use crate::solution::desk::Desk;
use crate::words::Words;

/// What such a student comes to for one question, on either road.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ByHand {
    /// The quantity.
    pub label: Label,
    /// From the equations of motion, SI; `None` if the solution does not find it there.
    pub eom: Option<f64>,
    /// From work and energy, SI; likewise.
    pub energy: Option<f64>,
}

/// What comes out by hand for each question that asks a number, in the order of the questions, with so many figures on the way.
///
/// # Errors
/// The derivations do not cover the scene, or rounding has changed the course of the motion.
pub fn answers(
    problem: &Problem,
    variant: &Variant,
    words: &Words,
    figures: usize,
) -> Result<Vec<ByHand>, Finding> {
    let mut desk = Desk::by_hand(problem, variant, words, figures)?;
    derive(&mut desk)?;
    let value = |answer: Option<Answer>| match answer? {
        Answer::Value(symbol) => Some(desk.ledger.value(symbol)).filter(|v| v.is_finite()),
        Answer::Word(_) => None,
    };
    let numbers = problem.questions.iter().filter(|q| !q.label.quantity.is_word());
    let found = numbers.filter_map(|q| desk.found.iter().find(|f| f.label == q.label));
    Ok(found.map(|f| ByHand { label: f.label, eom: value(f.eom), energy: value(f.energy) }).collect())
}
