//! Arithmetic that gives the same digits everywhere: double-double numbers, first derivatives, portable functions,
//! small linear systems. No mechanics.
pub mod dd;
pub mod eliminate;
pub mod jet;
pub mod linear;
pub mod plant;
pub mod real;
pub mod trig;

pub use dd::Dd;
pub use jet::Jet;
pub use real::Real;

/// Unit roundoff of a double, 2^-53.
pub const U: f64 = f64::EPSILON / 2.0;
