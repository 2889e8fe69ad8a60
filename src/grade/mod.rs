//! Key and answer give a verdict; a file of submissions gives one for every cell.
pub mod diagnose;
pub mod feedback;
pub mod judge;
pub mod run;
pub mod table;
pub mod verdict;
