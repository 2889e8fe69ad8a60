//! `slipstick solve`: a diagnosis of one problem with given data.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::banks;
use crate::inspect::{data, sentences, table};
use crate::solve::{agree, ladder};

/// Runs it.
pub fn run(args: &args::SolveArgs, io: &mut Io) -> Result<Exit, Findings> {
    let wish = data::wish(args.by.method, args.by.rtol, args.by.step.as_deref())?;
    let loaded = banks::load(&args.of.bank)?;
    let problem = banks::problem(&loaded, args.of.problem.as_deref())?;
    let (case, data, shown) = data::data(&loaded.bank, problem, &args.of.set, args.of.seed)?;
    let scene = &problem.cases[case].scene;
    let (mut solved, taken) =
        ladder::solve(scene, &data, &wish).map_err(|refusal| data::refused(problem, scene, &refusal))?;
    if taken.errors.is_empty() {
        // Nothing is proved where the data leave open which way it goes: the bounds are then absent.
        agree::prove(scene, &data, &mut solved);
    }
    let holds = data::fits(problem, case, &solved);
    io.piece(&match args.json {
        true => table::json(problem, case, &solved, &taken),
        false => table::table(problem, case, &shown, &solved, &taken, holds),
    });
    for note in sentences::sides(scene, &data) {
        io.note(&format!("note: {note}"));
    }
    Ok(if holds { Exit::Fine } else { Exit::RegimeFails })
}
