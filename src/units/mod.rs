//! Quantities at the borders of the program: units, dimensions, text to number and back.

/// A unit: how it is spelled, its dimension, and its size in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Unit;
