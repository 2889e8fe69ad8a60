//! `slipstick explain`: everything about one mark, in words.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::explain;

pub fn run(args: &args::ExplainArgs, io: &mut Io) -> Result<Exit, Findings> {
    io.piece(&explain::explain(&args.graded, &args.student, &args.problem, args.part.as_deref())?);
    Ok(Exit::Fine)
}
