//! Two independent roads to the same quantities, [`eom`] and [`energy`]. Only [`agree`], which compares them, and [`ladder`],
//! which measures methods by them, see both.
pub mod agree;
pub mod condition;
pub mod energy;
pub mod eom;
pub mod found;
pub mod ladder;
pub mod method;
pub mod outcome;
pub mod physical;
#[cfg(test)]
#[path = "../../tests/mechanics/planted.rs"]
mod planted;
