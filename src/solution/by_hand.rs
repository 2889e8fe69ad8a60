//! The answers of a careful student who solves by hand and rounds on the way.
//!
//! Whom this stands for: somebody who follows the worked solution with a pocket calculator. Each
//! quantity that the solution names (a work, an effective mass, an acceleration, a tension) is computed in one go from what stands
//! on the paper, written down with so many figures, and used as it is written from there on. Data and g are exact as
//! printed; what the calculator does between two lines of the paper is exact too.
//!
//! This is the honest reading of "intermediate results rounded to three figures": to round after every key of the calculator
//! would be harsher than anybody works, and to move the data a little, as `lint` does, knows nothing of the steps. It needs no
//! formula of its own: every family that has a worked solution has these answers.
use crate::bank::Problem;
use crate::problem::maker::Variant;
use crate::scene::Label;
use crate::solution::derive;
use crate::solution::draft::{DerivedAnswer, Draft, scene_of};
use crate::solution::stop::DerivationStop;
use crate::solution::symbols::Symbols;
use crate::words::Words;

/// A number that came about with rounding on the way, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedValue {
    /// The value.
    pub value: f64,
    /// How far the figures that were left out may have moved it, to first order, >= 0.
    pub doubt: f64,
}

/// What such a student comes to for one question.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ByHand {
    /// The quantity.
    pub label: Label,
    /// The number; `None` where it is none.
    pub rounded: Option<RoundedValue>,
}

impl ByHand {
    /// The number, SI.
    pub fn value(&self) -> Option<f64> {
        self.rounded.map(|r| r.value)
    }
}

/// What comes out by hand for each question that asks a number, in the order of the questions, with so many figures on the way.
/// Errors: the derivations do not cover the scene, or rounding has changed the course of the motion.
pub fn answers(
    problem: &Problem,
    variant: &Variant,
    words: &Words,
    figures: usize,
) -> Result<Vec<ByHand>, DerivationStop> {
    let scene = scene_of(problem, variant)?;
    let mut draft = Draft::new(problem, variant, scene, words, Symbols::by_hand(words, figures));
    derive(&mut draft)?;
    let rough = |answer: DerivedAnswer| match answer {
        DerivedAnswer::Value(symbol) => {
            let (value, doubt) = (draft.symbols.value(symbol), draft.symbols.doubt(symbol));
            value.is_finite().then_some(RoundedValue { value, doubt })
        }
        DerivedAnswer::Word(_) => None,
    };
    let numbers = problem.questions.iter().filter(|q| !q.label.quantity.is_word());
    let found = numbers.filter_map(|q| Some((q.label, draft.found_for(q.label)?)));
    Ok(found.map(|(label, answer)| ByHand { label, rounded: rough(answer) }).collect())
}
