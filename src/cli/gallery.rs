//! `slipstick gallery`: many variants of a bank's problems side by side on one page, with the tables of `lint`.
use crate::bank::Problem;
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{Progress, files};
use crate::review::{self, page};
use crate::set::dealer;
use crate::sheet::terminal;
use std::path::Path;
use std::thread;
use std::time::Duration;

/// Variants of a problem that are shown at most, so that a browser can show the page.
const MOST: u32 = 1000;
/// Between two looks at a file that is watched.
const LOOK: Duration = Duration::from_millis(250);

pub fn run(args: &args::GalleryArgs, io: &mut Io) -> Result<Exit, Findings> {
    files::may_write_file(&args.out, args.force)?;
    if args.variants == 0 || args.variants > MOST {
        return Err(Finding::new("--variants", format!("{} is not from 1 to {MOST}", args.variants)).into());
    }
    if args.watch {
        return watch(args, io);
    }
    let missing = draw(args, io)?;
    if missing.is_empty() { Ok(Exit::Fine) } else { Err(missing) }
}

/// Writes the page anew whenever the file of the bank changes; ends only where that file is none to begin with.
fn watch(args: &args::GalleryArgs, io: &mut Io) -> Result<Exit, Findings> {
    let bank = Path::new(&args.bank);
    if !bank.is_file() {
        let fault =
            Finding::new("--watch", format!("`{}` is no file, so it cannot be saved anew", args.bank));
        return Err(fault.hint("write a bank of your own: slipstick new").into());
    }
    let mut seen = None;
    loop {
        // While an editor puts a new file in its place there may be none for a moment.
        let text = files::read(bank).ok();
        if text.is_some() && text != seen {
            seen = text;
            let found = draw(args, io).unwrap_or_else(|faults| faults);
            if !found.is_empty() {
                io.findings(&found);
            }
            io.piece(&format!("waiting until {} is saved; Ctrl-C ends\n", args.bank));
        }
        thread::sleep(LOOK);
    }
}

/// Writes the page and says so; gives what is missing on it, and under `--watch` all that `lint` finds.
fn draw(args: &args::GalleryArgs, io: &mut Io) -> Result<Findings, Findings> {
    let (loaded, texts) = args.own.load(&args.bank)?;
    let bank = &loaded.bank;
    let chosen = dealer::chosen(bank, args.problems.as_deref(), "--problems")?;
    let problems: Vec<&Problem> = match args.watch {
        // `lint` looks at the whole bank.
        true => bank.problems.iter().collect(),
        false => chosen.iter().filter_map(|i| bank.problems.get(*i)).collect(),
    };
    let bar = io.bar();
    let sweeps = review::sweeps(&problems, args.seeds, &bank.id, &|of| bar.advance("draws", 1, of));
    let shown = match args.watch {
        true => chosen.iter().filter_map(|i| sweeps.get(*i).cloned()).collect(),
        false => sweeps.clone(),
    };
    let page = page::page((bank, &loaded.file), &chosen, &texts, (args.variants, args.seeds), &shown)?;
    let bytes = page.page.len();
    files::put_all(&[(args.out.clone(), page.page)])?;
    let variants = terminal::count(args.variants, "variant");
    let each = if page.missing.is_empty() { "" } else { ", where so many could be drawn" };
    io.line(&format!(
        "{} of {variants} each{each}, {} kB, in {} (for instructors: it holds keys)",
        terminal::count(chosen.len(), "problem"),
        bytes.div_ceil(1000),
        args.out.display()
    ));
    if args.watch {
        review::faults(bank, &loaded.file, &texts, &sweeps).map(|(found, _)| found)
    } else {
        Ok(page.missing)
    }
}
