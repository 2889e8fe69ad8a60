//! One problem with given data: what happens, every quantity by both derivations, what each method gives away; in words, as a table,
//! as JSON, as a page.
pub mod accuracy;
pub mod data;
pub mod quantities;
pub mod sentences;
pub mod table;
