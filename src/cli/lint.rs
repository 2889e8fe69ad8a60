//! `slipstick lint`: all that is wrong in a bank, then how it behaves over many seeds.
use crate::bank::Problem;
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::diagnosis::sentences;
use crate::diagnosis::table::unsatisfiable;
use crate::finding::{Finding, Findings};
use crate::folder::banks::Loaded;
use crate::folder::{Progress, banks};
use crate::num::shown;
use crate::problem::sweep;
use crate::problem::sweep::Sweep;
use crate::review;
use crate::review::texts::TextNote;
use crate::sheet::texts::Texts;
use crate::sheet::{terminal, texts};

/// Runs it.
pub fn run(args: &args::LintArgs, io: &mut Io) -> Result<Exit, Findings> {
    let mut loaded = banks::load(&args.bank)?;
    let texts = args.own.texts(&mut loaded.bank).map_err(|f| f.or_in_file(&loaded.file))?;
    let bank = &loaded.bank;
    let all: Vec<&Problem> = bank.problems.iter().collect();
    let bar = io.bar();
    let sweeps = review::sweeps(&all, args.seeds, &bank.id, &|of| bar.advance("draws", 1, of));
    let (findings, notes) = faults(&loaded, &texts, &sweeps)?;
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
    io.line(&review::chance(&sweeps));
    for sweep in &sweeps {
        let one = sweep::coincidence(std::slice::from_ref(sweep), review::CLASS);
        io.line(&format!("  {} alone: at most {}", sweep.problem, shown::figures(one, 2)));
    }
    if findings.is_empty() { Ok(Exit::Fine) } else { Err(findings) }
}

/// All that is wrong in a bank whose problems behave so over many seeds; and what is worth knowing besides.
///
/// # Errors
/// Faults of the templates.
pub fn faults(
    loaded: &Loaded,
    texts: &Texts,
    sweeps: &[Sweep],
) -> Result<(Findings, Vec<TextNote>), Findings> {
    let bank = &loaded.bank;
    let mut findings = texts::unknown_names(bank, &texts.templates);
    findings.extend(texts::never_given(bank, &texts.templates));
    for (problem, sweep) in bank.problems.iter().zip(sweeps) {
        if let Some((seed, none)) = &sweep.unsatisfiable {
            let mut fault = unsatisfiable(bank, none);
            if none.constant.is_none() {
                fault.message = format!("seed {seed}: {}", fault.message);
            }
            findings.push(
                fault.in_file(&loaded.file).hint("widen the ranges, or loosen the rule that refuses most"),
            );
        } else if let Some(refusal) = &sweep.unsolved {
            for text in sentences::refusal(problem, &problem.cases[0].scene, refusal) {
                let what = format!("a draw cannot be solved: {text}");
                findings.push(Finding::new(format!("problems.{}", problem.id), what).in_file(&loaded.file));
            }
        }
    }
    let mut notes = Vec::new();
    if findings.is_empty() {
        let tried = review::texts::whole_bank(bank, texts)?;
        findings.extend(tried.faults);
        notes = tried.notes;
        for (problem, sweep) in bank.problems.iter().zip(sweeps) {
            for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
                let never = sweep::seldom(&seen.words).into_iter().filter(sweep::Seldom::never);
                findings.extend(never.map(|s| review::seldom(problem, question, &s).in_file(&loaded.file)));
            }
        }
    }
    Ok((findings, notes))
}
