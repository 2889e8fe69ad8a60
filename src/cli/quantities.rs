//! `slipstick quantities`: what may be asked of a problem's scene.
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::banks;
use crate::inspect::quantities;

pub fn run(bank: &str, problem: Option<&str>, json: bool, io: &mut Io) -> Result<Exit, Findings> {
    let loaded = banks::load(bank)?;
    let problem = banks::problem(&loaded, problem)?;
    io.piece(&match json {
        true => quantities::json(problem),
        false => quantities::table(problem),
    });
    Ok(Exit::Fine)
}
