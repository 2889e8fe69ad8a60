//! What teacher and students get back.
pub(crate) mod changes;
pub(crate) mod charts;
pub(crate) mod class;
pub(crate) mod explain;
pub(crate) mod feedback;
pub mod gradebook;
pub(crate) mod lms;
pub(crate) mod marks;
pub(crate) mod matches;
pub(crate) mod proved;
pub(crate) mod settings;
pub(crate) mod stats;
pub(crate) mod study;
pub(crate) mod summary;
pub(crate) mod table;
pub(crate) mod tolerances;
