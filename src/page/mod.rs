//! The door of a page that checks itself: problems and phrases in, verdicts out. No files, no clock, no chance; the scene is
//! solved here, so that no key is needed. `slipstick check` judges with the same functions.
pub mod check;
pub(crate) mod echo;
pub mod session;
#[cfg(feature = "program")]
pub mod sheet_file;
