//! The workshop: from a problem of a bank and a seed to a finished variant and its key.
pub mod make;
pub mod make_key;
#[cfg(feature = "program")]
pub mod rounding;
pub mod rule;
#[cfg(feature = "program")]
pub mod sweep;
pub mod variant;
