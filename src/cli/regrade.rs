//! `slipstick regrade`: the same answers by a changed bank or course, as a diff; the old grading stays as it is.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::regrading::{self, RegradingJob};

pub fn run(args: &args::RegradeArgs, io: &mut Io) -> Result<Exit, Findings> {
    let job = RegradingJob {
        set: &args.set,
        graded: &args.graded,
        submissions: &args.submissions,
        out: args.out.as_deref(),
        bank: args.bank.as_deref(),
        course: args.course.as_deref(),
        attempts: args.attempts,
        columns: &args.columns,
        language: args.language.as_deref(),
        dry_run: args.dry_run,
        progress: &io.bar(),
    };
    let regraded = regrading::regrade(&job, &mut *io.input)?;
    for note in &regraded.notes {
        io.note(&format!("warning: {note}"));
    }
    io.piece(&regraded.told);
    // So far the changes are only told.
    io.piece(&regraded.write()?);
    Ok(Exit::Fine)
}
