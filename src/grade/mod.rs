//! Key and answer give a verdict; a file of submissions gives one for every cell.
//!
//! [`run`] has the file walked over: first [`winners`] finds which attempts count, then [`write`] writes a row for each cell.
//! [`judge`] makes the row: whose cell it is ([`belongs`]), the verdict ([`compare`], or [`si`] where a plain number is all
//! that it takes), what it earns ([`award`], [`credit`]), and what a wrong number fits ([`diagnose`]).
pub mod attempt;
mod award;
mod belongs;
pub mod book;
mod cells;
pub mod compare;
mod counts;
pub mod credit;
pub mod diagnose;
pub mod feedback;
mod header;
mod ids;
mod judge;
mod layout;
pub mod row;
pub mod rules;
pub mod run;
mod si;
pub mod table;
mod threads;
pub mod verdict;
mod winners;
mod write;
