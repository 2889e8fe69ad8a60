//! Key and answer give a verdict; a file of submissions gives one for every cell.
mod attempts;
mod award;
mod cells;
pub mod choose;
pub mod credit;
pub mod diagnose;
pub mod feedback;
mod ids;
pub mod judge;
mod layout;
mod quick;
pub mod row;
pub mod rules;
pub mod run;
pub mod table;
mod threads;
pub mod verdict;
mod write;
