//! `slipstick simulate`: a made-up class with declared habits hands in answers to a stored set, and the truth is written beside them.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{self, banks, files};
use crate::sheet::terminal;
use crate::simulate::classwork::Files;
use crate::simulate::habits::{self, Habits};
use std::path::Path;

pub fn run(args: &args::SimulateArgs, io: &mut Io) -> Result<Exit, Findings> {
    if args.example {
        io.piece(habits::EXAMPLE);
        return Ok(Exit::Fine);
    }
    let files = simulate(args)?;
    let rows = terminal::count(files.rows, "answer");
    let students = terminal::count(files.students, "student");
    io.line(&format!("{rows} by {students} with seed {}", args.seed));
    for (what, path) in [("submissions", &args.out), ("truth", &args.truth)] {
        io.line(&format!("  {what}: {}", path.as_deref().unwrap_or(Path::new("")).display()));
    }
    Ok(Exit::Fine)
}

fn simulate(args: &args::SimulateArgs) -> Result<Files, Findings> {
    // clap demands all three unless --example is given.
    let (Some(set), Some(out), Some(truth)) = (&args.set, &args.out, &args.truth) else {
        return Err(Finding::new("", "give the folder of a set, --out and --truth").into());
    };
    let mut faults = Findings::default();
    let habits = match &args.like {
        Some(path) => read(path).map_err(|f| faults.extend(f)).ok(),
        None => Some(Habits::usual()),
    };
    for path in [out, truth] {
        faults.extend(may_write(path, args.force).err());
    }
    if out == truth {
        faults.push(Finding::new("--truth", "is the file of the submissions").hint("give it another name"));
    }
    if let Some(language) = &args.language {
        faults.extend(banks::words(language).err().unwrap_or_default());
    }
    let (Some(habits), true) = (habits, faults.is_empty()) else { return Err(faults) };
    let file = args.like.as_deref();
    let files = folder::simulate::simulated(set, (&habits, file), args.language.as_deref(), args.seed)?;
    files::put_all(&[(out.clone(), &files.submissions), (truth.clone(), &files.truth)])?;
    Ok(files)
}

fn read(path: &Path) -> Result<Habits, Findings> {
    let text = files::read_text(path)?;
    Habits::read(&text, &path.display().to_string())
}

/// A file that is not there, or that may be replaced.
fn may_write(path: &Path, force: bool) -> Result<(), Finding> {
    if path == Path::new("-") {
        let hint = "submissions and truth are two files: give both a name";
        let fault = Finding::new("", "is no file; nothing is written to standard output");
        return Err(fault.in_file("-").hint(hint));
    }
    files::may_write_file(path, force)
}
