//! What teacher and students get back.
pub mod changes;
pub mod charts;
pub mod class;
pub mod explain;
pub mod feedback;
pub mod gradebook;
pub mod lms;
pub mod marks;
pub mod matches;
pub mod proved;
pub mod settings;
pub mod stats;
pub mod study;
pub mod summary;
pub mod table;
pub mod tolerances;
