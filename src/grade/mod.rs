//! Key and answer give a verdict; a file of submissions gives one for every cell.
//!
//! `run` has the file walked over: first `winners` finds which attempts count, then `write` writes a row for each cell.
//! `judge` makes the row: whose cell it is (`belongs`), the verdict (`compare`, or `si` where a plain number is all
//! that it takes), what it earns (`award`, `credit`), and what a wrong number fits (`diagnose`).
#[cfg(feature = "program")]
pub(crate) mod attempt;
#[cfg(feature = "program")]
mod award;
#[cfg(feature = "program")]
mod cells;
pub mod compare;
#[cfg(feature = "program")]
mod counts;
#[cfg(feature = "program")]
pub(crate) mod credit;
pub mod diagnose;
#[cfg(feature = "program")]
mod fast_number;
pub mod feedback;
#[cfg(feature = "program")]
pub(crate) mod gradebook_reader;
#[cfg(feature = "program")]
mod header;
#[cfg(feature = "program")]
mod id_index;
#[cfg(feature = "program")]
mod judge;
#[cfg(feature = "program")]
mod layout;
#[cfg(feature = "program")]
mod owner;
#[cfg(feature = "program")]
pub(crate) mod row;
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
mod winners;
#[cfg(feature = "program")]
mod write;
