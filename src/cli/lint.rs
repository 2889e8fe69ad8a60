//! `slipstick lint`: all that is wrong in a bank, then how it behaves over many seeds.
use crate::bank::Problem;
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{Progress, banks};
use crate::review;
use crate::sheet::terminal;

pub fn run(args: &args::LintArgs, io: &mut Io) -> Result<Exit, Findings> {
    if args.seeds == 0 {
        return Err(Finding::new("--seeds", "0 draws tell nothing").hint("write a number from 1 on").into());
    }
    let mut loaded = banks::load(&args.bank)?;
    let texts = args.own.texts(&mut loaded.bank).map_err(|f| f.or_in_file(&loaded.file))?;
    let bank = &loaded.bank;
    let all: Vec<&Problem> = bank.problems.iter().collect();
    let bar = io.bar();
    let sweeps = review::sweeps(&all, args.seeds, &bank.id, &|of| bar.advance("draws", 1, of));
    let (findings, notes) = review::faults(bank, &loaded.file, &texts, &sweeps)?;
    for (problem, sweep) in bank.problems.iter().zip(&sweeps) {
        let tables = review::tables(problem, sweep);
        io.line(&format!("{}: {}", problem.id, problem.title));
        io.piece(&terminal::table(&tables.cases, &review::LEFT_CASES));
        for (count, rule) in &tables.refusals {
            io.line(&format!("    refused {count:>6}  {rule}"));
        }
        io.piece(&terminal::table(&tables.numbers, &review::LEFT_NUMBERS));
        io.piece(&terminal::table(&tables.words, &review::LEFT_WORDS));
        if tables.mistakes.len() > 1 {
            let last = tables.mistakes.first().map_or(0, |head| head.len() - 1);
            io.piece(&terminal::table(&tables.mistakes, &[0, last]));
        }
        if let Some(never) = review::never_near(&tables) {
            io.line(&format!("  {never}"));
        }
        let told = notes.iter().filter(|n| n.problem == problem.id).map(|n| &n.what);
        for note in tables.notes.iter().chain(told) {
            io.line(&format!("    note: {note}"));
        }
        io.line("");
    }
    for line in review::chance(&sweeps) {
        io.line(&line);
    }
    if findings.is_empty() { Ok(Exit::Fine) } else { Err(findings) }
}
