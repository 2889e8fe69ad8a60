//! What a student wrote: files of submissions, rosters, and the text of a single cell.
mod numeral;
mod plain;
pub mod quick;
pub mod read;
pub mod roster;
pub mod submissions;
