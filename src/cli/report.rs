//! `slipstick report`: a folder of grades to the class report, feedback for each student and gradebooks.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::reports::{self, ReportJob};

pub fn run(args: &args::ReportArgs, io: &mut Io) -> Result<Exit, Findings> {
    let made = reports::write(&ReportJob {
        graded: &args.graded,
        out: args.out.as_deref(),
        templates: args.own.templates.as_deref(),
        language: args.own.language.as_deref(),
        force: args.force,
        threads: args.threads,
    })?;
    let out = args.out.as_deref().unwrap_or(&args.graded).display().to_string();
    io.line(&made.told(&out));
    Ok(Exit::Fine)
}
