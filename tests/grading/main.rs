//! Submissions, verdicts, credit, reports and copied answers: is each cell judged right and no row lost?
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

mod copy_flag;
mod directions;
mod grading_table;
mod marks;
mod matches;
mod naming;
mod quiz;
mod regrade;
mod report;
mod scoring;
mod simulate;
mod tutor;
