//! What teacher and students get back.
pub mod gradebook;
