//! `slipstick export`: a set, or a pool drawn from a bank, to one file for a learning platform.
use crate::cli::args::ExportArgs;
use crate::cli::tell::{Exit, Io};
use crate::export::{ExportFormat, QuestionLayout};
use crate::finding::{Finding, Findings};
use crate::folder::deal::Plan;
use crate::folder::export::{ExportJob, set_beside};
use crate::folder::staged::{self, Staged};
use crate::folder::{self, deal, export, names, set};
use crate::review;
use crate::set::dealer;
use crate::sheet::self_check::Hosting;
use crate::sheet::terminal;
use std::path::{Path, PathBuf};

/// Variants of a pool at most.
const MOST: u32 = 10_000;

pub fn run(args: &ExportArgs, io: &mut Io) -> Result<Exit, Findings> {
    let layout = match (args.format, args.layout) {
        (ExportFormat::Moodle, Some(layout)) => layout,
        (ExportFormat::Canvas, None) => QuestionLayout::Parts,
        (_, Some(_)) => {
            let what = format!("is for moodle, and not for {}", args.format.as_str());
            return Err(Finding::new("--as", what).into());
        }
        _ => QuestionLayout::Whole,
    };
    export::may_write(&args.out, args.force)?;
    let (set, pool) = match args.variants {
        Some(variants) => {
            let pool = drawn(args, variants, io)?;
            (pool.folder.path().to_owned(), Some(pool))
        }
        None => (source(&args.source)?, None),
    };
    let bar = io.bar();
    let job = ExportJob {
        set: &set,
        bank: pool.as_ref().map(|pool| pool.bank.as_str()),
        out: &args.out,
        platform: args.format,
        layout,
        with_solutions: args.with_solutions,
        problems: args.problems.as_deref(),
        templates: args.own.templates.as_deref(),
        language: args.own.language.as_deref(),
        progress: &bar,
    };
    let made = folder::pool(args.threads)?.install(|| export::write(&job));
    let made = match pool {
        Some(pool) => {
            let made = made.map_err(|faults| pool.folder.named(faults))?;
            pool.folder.finish()?;
            made
        }
        None => made?,
    };
    io.line(&format!(
        "{} of {} as {} for {}, {} kB, in {} (it holds the key: not for students)",
        terminal::count(made.variants, "variant"),
        terminal::count(made.problems, "problem"),
        terminal::count(made.questions, "question"),
        args.format.as_str(),
        made.bytes.div_ceil(1000),
        args.out.display()
    ));
    if args.variants.is_some() {
        let set = set_beside(&args.out);
        let set = set.display();
        io.line(&format!("  the key:       {set}/key.csv, by the code of each question"));
    }
    io.line(&format!(
        "What {} does not carry over (tolerances and points are those of the key):",
        args.format.as_str()
    ));
    made.losses.iter().for_each(|lost| io.line(&format!("  {lost}")));
    Ok(Exit::Fine)
}

/// The folder of a set, which the first word names.
fn source(name: &str) -> Result<PathBuf, Finding> {
    let path = Path::new(name);
    if path.is_dir() {
        return Ok(path.to_owned());
    }
    let what = Finding::new("", "is no folder of a set").in_file(name);
    Err(what.hint("give the folder that `slipstick generate` made; from a bank a pool is drawn with --variants 200 --seed 1"))
}

/// The set of a pool, which comes to its place beside the file when that is written.
struct Pool {
    folder: Staged,
    /// Name of the bank for messages.
    bank: String,
}

/// The set of a pool.
fn drawn(args: &ExportArgs, variants: u32, io: &mut Io) -> Result<Pool, Findings> {
    if !(1..=MOST).contains(&variants) {
        return Err(Finding::new("--variants", format!("{variants} is not from 1 to {MOST}")).into());
    }
    let path = Path::new(&args.source);
    if path.join(names::SET).is_file() {
        let fault = Finding::new("--variants", "is for a bank, and this is a set, which has its variants");
        return Err(fault.in_file(&args.source).into());
    }
    let out = set_beside(&args.out);
    staged::sweep_beside(&out);
    let (loaded, texts) = args.own.load(&args.source)?;
    set::may_write(
        &out,
        args.force,
        "--out pool.xml",
        "give another --out, or --force to replace the set beside it",
    )?;
    let problems = dealer::chosen(&loaded.bank, args.problems.as_deref(), "--problems")?;
    let tried = review::tried_texts::tried(&loaded.bank, &texts, &problems)?;
    tried.faults.into_result(())?;
    let name = args.name.as_ref().unwrap_or(&loaded.bank.id);
    deal::may_be_named(name)?;
    let plan = Plan {
        bank: &loaded.bank,
        text: &loaded.text,
        texts: &texts,
        // Of a pool of questions no sheets are written.
        formats: &[],
        hosting: Hosting::Single,
        problems: &problems,
        seed: args.seed.unwrap_or_default(),
        name,
    };
    let bar = io.bar();
    let folder = Staged::new(&out)?;
    let made = folder::pool(args.threads)?.install(|| export::pool(&plan, variants, folder.path(), &bar));
    made.map_err(|faults| folder.named(faults))?;
    Ok(Pool { folder, bank: loaded.file })
}
