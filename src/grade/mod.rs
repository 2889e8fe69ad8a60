//! Key and answer give a verdict; a file of submissions gives one for every cell.
pub mod choose;
pub mod credit;
pub mod diagnose;
pub mod feedback;
pub mod judge;
mod layout;
pub mod rules;
pub mod run;
pub mod table;
mod threads;
pub mod verdict;
pub(crate) mod write;
