//! Gradings that are there already: their rows, what other tolerances would make of them, what a new grading changes.
pub mod changes;
pub mod tolerance;
