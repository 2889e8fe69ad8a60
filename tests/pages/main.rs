//! Sheets, figures and worked solutions: is what is printed true, valid and readable?
#![allow(
    clippy::cast_possible_truncation,
    clippy::disallowed_methods,
    clippy::float_cmp,
    clippy::neg_cmp_op_on_partial_ord,
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a test fails by panicking, tells figures with --nocapture, and NaN must fail its comparisons"
)]
#[path = "../support/mod.rs"]
mod support;

mod beware;
mod composed;
mod english;
mod figures;
mod gallery;
#[path = "../physics/joined_lot.rs"]
#[allow(dead_code, reason = "the judge of another program reads more of a mechanism")]
mod joined_lot;
mod looks;
#[path = "../physics/composed.rs"]
#[allow(dead_code, reason = "the judge of another program reads more of a scene")]
mod lot;
mod particles;
#[cfg(feature = "pdf")]
mod pdf;
mod print;
mod sentences;
mod sheets;
mod short_pages;
mod solutions;
mod solutions_pinned;
mod tex;
