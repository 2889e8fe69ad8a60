//! One student's version of a problem, solved.
use crate::bank::decimal::Decimal;
use crate::misconception::Wrong;
use crate::problem::rule::Refusals;
use crate::solve::outcome::Solved;

/// One student's version of a problem, solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Variant {
    /// Index of the case.
    pub case: usize,
    /// One for each datum of the problem, as printed; `None` where the case does not use it.
    pub values: Vec<Option<Decimal>>,
    /// The same as the scene takes them: SI, slopes in degrees; 0 where the case does not use it.
    pub data: Vec<f64>,
    /// The solution.
    pub solved: Solved,
    /// Tries that it took, from 1.
    pub tries: u32,
    /// How often each rule refused.
    pub refusals: Refusals,
    /// Relative tolerance of each question.
    pub within: Vec<f64>,
    /// Where the wrong methods come to, for all questions.
    pub wrong: Vec<Wrong>,
}
