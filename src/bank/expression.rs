//! Expressions of bounds.

/// An expression.
#[derive(Debug, Clone)]
pub struct Expression;
