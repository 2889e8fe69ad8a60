//! `slipstick solutions`: a stored set, drawn and solved again, to worked solutions for each student.
use crate::cli::tell::{Exit, Io};
use crate::cli::{args, tell};
use crate::finding::Findings;
use crate::folder::solutions::{self, SolutionsJob};
use crate::sheet::{output, terminal};

pub fn run(args: &args::SolutionsArgs, io: &mut Io) -> Result<Exit, Findings> {
    let formats = output::formats(args.format.as_deref());
    let made = solutions::write(&SolutionsJob {
        set: &args.set,
        out: &args.out,
        templates: args.own.templates.as_deref(),
        language: args.own.language.as_deref(),
        detail: args.detail,
        formats: &formats,
        force: args.force,
        threads: args.threads,
        progress: &io.bar(),
    })?;
    let out = args.out.display();
    io.line(&format!(
        "Worked solutions for {} of {} each, in {out}",
        terminal::count(made.students, "student"),
        terminal::count(made.problems, "problem")
    ));
    let files: Vec<String> = formats.iter().rev().map(|f| format!("solution.{}", f.as_str())).collect();
    io.line(&format!("  one by one:    {out}/ID/ ({})", files.join(", ")));
    let booklets = tell::booklets(&formats, &args.out);
    if !booklets.is_empty() {
        io.line(&format!("  all in one:    {booklets}"));
    }
    for (text, students) in made.short {
        io.note(&format!("{text} (for {})", terminal::count(students, "student")));
    }
    Ok(Exit::Fine)
}
