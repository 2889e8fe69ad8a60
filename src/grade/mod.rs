//! Key and answer give a verdict; a file of submissions gives one for every cell.
pub mod choose;
pub mod credit;
pub mod diagnose;
pub mod feedback;
mod ids;
pub mod judge;
mod layout;
mod lean;
mod quick;
pub mod rules;
pub mod run;
pub mod table;
mod tails;
mod threads;
pub mod verdict;
pub(crate) mod write;
