//! Two roads, reference and published cases, limits, extremes and composed scenes: is the key right?
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

mod as_books_say;
mod at_once;
mod axles;
mod bare;
mod big;
mod carried;
mod catalogue;
mod composed;
mod composed_scenes;
mod counterweights;
mod expressions;
mod extremes;
mod growing;
mod impacts;
mod joined;
mod joined_edges;
mod joined_ends;
mod joined_lot;
mod joined_scenes;
mod ladder;
mod lagrange;
mod limits;
mod links;
mod meshes;
mod moving_lines;
mod next;
mod past_limits;
mod phases;
mod pinned_bits;
mod pinned_draws;
mod published;
mod quantities;
mod range;
mod reference_cases;
mod rest;
mod rubbing;
mod seed_sweep;
mod shares;
mod swing_extremes;
mod swings;
mod switches;
mod third_witness;
mod tolerance;
mod traps;
mod two_roads;
mod wrong_method_families;
mod wrong_methods;
