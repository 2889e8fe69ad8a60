//! Two independent roads to the same quantities, and the one place where they meet.
pub mod agree;
pub mod condition;
pub mod energy;
pub mod eom;
pub mod ladder;
pub mod method;
pub mod outcome;
pub mod physical;
#[cfg(test)]
mod planted;
