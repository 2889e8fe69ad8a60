//! Made-up classes and what they hand in. [`classwork`] lets a class with declared [`habits`] work on a set and records the truth,
//! so that grading can be scored; [`class`] names the students of demonstrations.
pub mod chance;
pub(crate) mod class;
pub mod classwork;
pub mod habits;
pub mod student;
pub mod truth;
pub mod written;
