//! The program as its users run it: commands, messages, README, odd input, nothing that tells a key.
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

mod asked;
mod cli;
mod earlier_sets;
mod exports;
mod findings;
mod hostile_texts;
mod leaks;
mod page;
mod readme;
mod readme_bank;
mod refusals;
mod robust;
mod writing;
