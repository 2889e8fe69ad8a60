//! `slipstick gallery`: many variants of a bank's problems side by side on one page, with the tables of `lint`.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{Progress, files};
use crate::review::page;
use crate::set::dealer;
use crate::sheet::terminal;

/// Variants of a problem that are shown at most, so that a browser can show the page.
const MOST: u32 = 1000;

/// Runs it.
pub fn run(args: &args::GalleryArgs, io: &mut Io) -> Result<Exit, Findings> {
    if args.out.exists() && !args.force {
        let fault = Finding::new("", "is there already").in_file(args.out.display().to_string());
        return Err(fault.hint("--force replaces it").into());
    }
    if args.variants == 0 || args.variants > MOST {
        return Err(Finding::new("--variants", format!("{} is not from 1 to {MOST}", args.variants)).into());
    }
    let (loaded, texts) = args.own.load(&args.bank)?;
    let problems = dealer::chosen(&loaded.bank, args.problems.as_deref(), "--problems")?;
    let bar = io.bar();
    let page =
        page::page((&loaded.bank, &loaded.file), &problems, &texts, (args.variants, args.seeds), &|of| {
            bar.advance("draws", 1, of)
        })?;
    let bytes = page.len();
    files::put_all(&[(args.out.clone(), page)])?;
    io.line(&format!(
        "{} of {} each, {} kB, in {} (for instructors: it holds keys)",
        terminal::count(problems.len(), "problem"),
        terminal::count(usize::try_from(args.variants).unwrap_or(usize::MAX), "variant"),
        bytes.div_ceil(1000),
        args.out.display()
    ));
    Ok(Exit::Fine)
}
