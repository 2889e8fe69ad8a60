//! One problem with given data: what happens, every quantity by both derivations, what each method gives away; in words, as a table,
//! as JSON, as a page.
pub(crate) mod accuracy;
pub(crate) mod data;
pub(crate) mod quantities;
pub mod sentences;
pub(crate) mod table;
