//! Marks as CSV.
