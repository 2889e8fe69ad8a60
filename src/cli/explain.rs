//! `slipstick explain`: everything about one mark, in words.
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::explain;
use std::path::Path;

pub fn run(
    graded: &Path,
    student: &str,
    problem: &str,
    part: Option<&str>,
    io: &mut Io,
) -> Result<Exit, Findings> {
    io.piece(&explain::explain(graded, student, problem, part)?);
    Ok(Exit::Fine)
}
