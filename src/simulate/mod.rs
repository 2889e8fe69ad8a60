//! Made-up classes and what they hand in. [`classwork`] lets a class with declared [`habits`] work on a set and records the truth,
//! so that grading can be scored; [`hand_in`] is the small class of demonstrations, whose bytes are promised to nobody.
pub mod chance;
pub mod class;
pub mod classwork;
pub mod habits;
pub mod hand_in;
mod moment;
pub mod student;
pub mod truth;
pub mod written;
