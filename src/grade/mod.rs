//! Key and answer give a verdict; a file of submissions gives one for every cell.
#[cfg(feature = "program")]
mod attempts;
#[cfg(feature = "program")]
mod award;
#[cfg(feature = "program")]
pub mod book;
#[cfg(feature = "program")]
mod cells;
#[cfg(feature = "program")]
pub mod choose;
#[cfg(feature = "program")]
pub mod credit;
#[cfg(feature = "program")]
pub mod diagnose;
pub mod feedback;
#[cfg(feature = "program")]
mod header;
#[cfg(feature = "program")]
mod ids;
pub mod judge;
#[cfg(feature = "program")]
mod layout;
#[cfg(feature = "program")]
mod quick;
#[cfg(feature = "program")]
pub mod row;
#[cfg(feature = "program")]
pub mod rules;
#[cfg(feature = "program")]
pub mod run;
#[cfg(feature = "program")]
pub mod table;
#[cfg(feature = "program")]
mod threads;
pub mod verdict;
#[cfg(feature = "program")]
mod write;
