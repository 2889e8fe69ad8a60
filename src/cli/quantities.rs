//! `slipstick quantities`: what may be asked of a problem's scene.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::banks;
use crate::inspect::quantities;

pub fn run(args: &args::QuantitiesArgs, io: &mut Io) -> Result<Exit, Findings> {
    let loaded = banks::load(&args.bank)?;
    let problem = banks::problem(&loaded, args.problem.as_deref())?;
    io.piece(&match args.json {
        true => quantities::json(problem),
        false => quantities::table(problem),
    });
    Ok(Exit::Fine)
}
