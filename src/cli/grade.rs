//! `slipstick grade`: submissions against a stored set, whose key is made anew before anything is graded.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::grading::{self, GradeOrder};
use crate::folder::names::{ANSWERS, GRADEBOOK, INDEX};

pub fn run(args: &args::GradeArgs, io: &mut Io) -> Result<Exit, Findings> {
    let job = GradeOrder {
        set: &args.set,
        submissions: &args.submissions,
        out: &args.out,
        attempts: args.attempts,
        courses: args.course.as_slice(),
        columns: &args.columns,
        language: args.language.as_deref(),
        reports: args.reports,
        force: args.force,
        progress: &io.bar(),
    };
    let summary = grading::grade(&job, &mut *io.input)?;
    io.line(&summary);
    let out = args.out.display();
    io.line(&format!(
        "  every answer: {out}/{ANSWERS}; a row for each student: {out}/{GRADEBOOK}; why: slipstick explain {out} STUDENT PROBLEM"
    ));
    io.open(&args.out.join(INDEX), args.open);
    Ok(Exit::Fine)
}
