//! What a student wrote: files of submissions, rosters, and the text of a single cell.
pub mod figures;
mod numeral;
mod plain;
#[cfg(feature = "program")]
pub(crate) mod quiz;
pub mod read;
#[cfg(feature = "program")]
pub mod roster;
mod spelling;
#[cfg(feature = "program")]
pub mod submissions;
pub mod word;
