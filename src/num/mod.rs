//! Arithmetic that gives the same digits everywhere.
