//! From a problem of a bank, a seed and a student to a solved variant ([`maker`]) and its key ([`make_key`]).
pub mod make_key;
pub mod maker;
#[cfg(feature = "program")]
pub(crate) mod rounding;
pub(crate) mod rule;
#[cfg(feature = "program")]
pub mod sweep;
pub mod variant;
