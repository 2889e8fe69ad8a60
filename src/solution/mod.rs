//! Worked solutions: both roads in symbols and numbers, from the scene's own terms. A third derivation beside the two that
//! make the key: a solution whose numbers are not those of the key is refused, never printed.
pub mod expr;
pub mod ledger;
pub mod text;
