//! What a student wrote: files of submissions, rosters, and the text of a single cell.
pub mod figures;
mod numeral;
mod plain;
pub mod quick;
pub mod read;
pub mod roster;
mod spelling;
pub mod submissions;
pub mod word;
