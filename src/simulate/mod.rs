//! A made-up class and what it hands in, for demonstrations and tests. Its bytes are promised to nobody.
pub mod class;
pub mod hand_in;
