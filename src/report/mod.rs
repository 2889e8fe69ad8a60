//! What teacher and students get back.
pub mod alike;
pub mod charts;
pub mod class;
pub mod feedback;
pub mod gradebook;
pub mod lms;
pub mod marks;
pub mod settings;
pub mod stats;
pub mod study;
pub mod table;
