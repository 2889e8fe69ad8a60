//! Runs both roads and compares; the only file that sees both.
use crate::scene::Scene;
use crate::solve::outcome::{Refusal, Solved};

/// Solves a scene twice and publishes only what agrees.
///
/// `data` are the SI values (angles in degrees) that [`crate::scene::Num::Datum`] indexes.
pub fn solve(_scene: &Scene, _data: &[f64]) -> Result<Solved, Refusal> {
    Err(Refusal::Freedoms(0))
}
