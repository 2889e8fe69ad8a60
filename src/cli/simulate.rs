//! `slipstick simulate`: a made-up class with declared habits hands in answers to a stored set, and the truth is written beside them.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{banks, files, set};
use crate::set::{dealer, replay};
use crate::sheet::terminal;
use crate::simulate::classwork::{Files, Work};
use crate::simulate::habits::Habits;
use crate::simulate::student::SimulatedStudent;
use crate::simulate::{classwork, habits};
use crate::words::Words;
use std::path::Path;

/// Runs it.
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
    let (Some(folder), Some(out), Some(truth)) = (&args.set, &args.out, &args.truth) else {
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
    let (stored, bank) = set::with_bank(folder)?;
    let problems = dealer::indices(&bank, &stored.problems, "problems")?;
    if let Some(path) = &args.like {
        let asked = problems.iter().flat_map(|p| &bank.problems[*p].mistakes);
        let known: Vec<&str> = asked.map(|m| m.id.as_str()).collect();
        known_methods(&habits, &known, path)?;
    }
    let words = match &args.language {
        Some(language) => banks::words(language)?,
        None => Words::of(&stored.language).unwrap_or_else(Words::english),
    };
    let works = replay::each(&bank, &stored, &|_, student, dealt| {
        let drawn = dealt.variants.iter().zip(&dealt.key.problems);
        let sheet: Vec<_> = problems
            .iter()
            .zip(drawn)
            .map(|(p, (variant, key))| (&bank.problems[*p], variant, key))
            .collect();
        let handed = SimulatedStudent::new(&habits, &words, args.seed, &student.student).work(&sheet);
        Ok(Work { key: dealt.key, handed })
    });
    let mut works = works.map_err(|faults| set::of_set(folder, faults))?;
    classwork::copy(&habits, args.seed, &mut works);
    let files = classwork::write(&habits, &words, args.seed, &works);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    files::put_all(&[(out.clone(), text(&files.submissions)), (truth.clone(), text(&files.truth))])?;
    Ok(files)
}

fn read(path: &Path) -> Result<Habits, Findings> {
    let text = files::read_text(path)?;
    Habits::read(&text, &path.display().to_string())
}

/// Are all wrong methods that the habits name listed in the bank?
fn known_methods(habits: &Habits, known: &[&str], path: &Path) -> Result<(), Findings> {
    let file = path.display().to_string();
    let strange = habits.unknown_methods(known).map(|(id, near)| {
        let what = format!("no problem of this set lists the wrong method `{id}`");
        let finding = Finding::new("wrong methods", what).in_file(&file);
        finding.hint(near.unwrap_or_else(|| "the ids stand in the bank under `mistakes`".to_owned()))
    });
    let strange: Findings = strange.collect();
    if strange.is_empty() { Ok(()) } else { Err(strange) }
}

/// A file that is not there, or that may be replaced.
fn may_write(path: &Path, force: bool) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("", what).in_file(path.display().to_string());
    if path == Path::new("-") {
        let hint = "submissions and truth are two files: give both a name";
        return Err(finding("is no file; nothing is written to standard output").hint(hint));
    }
    files::not_among_students(path)?;
    if path.is_dir() {
        return Err(finding("is a folder; a file is written"));
    }
    if path.exists() && !force {
        return Err(finding("is there already").hint("give another name, or --force to replace it"));
    }
    Ok(())
}
