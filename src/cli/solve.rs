//! `slipstick solve`: a diagnosis of one problem with given data.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::banks;
use crate::inspect::{data, sentences, table};
use crate::problem::maker::happens;
use crate::scene::Label;
use crate::solve::{agree, ladder};

pub fn run(args: &args::SolveArgs, io: &mut Io) -> Result<Exit, Findings> {
    let wish = data::wish(args.by.method, args.by.rtol, args.by.step.as_deref())?;
    let loaded = banks::load(&args.of.bank)?;
    let problem = banks::problem(&loaded, args.of.problem.as_deref())?;
    let (case, data, shown) = data::data(&loaded.bank, problem, &args.of.set, args.of.seed)?;
    let scene = &problem.cases[case].scene;
    let (mut solved, taken) =
        ladder::solve(scene, &data, &wish).map_err(|refusal| data::refused(problem, scene, &refusal))?;
    let found = scene.formulas.found.is_some();
    if taken.errors.is_empty() {
        // Nothing is proved where the data leave open which way it goes: the bounds are then absent.
        let proved = agree::prove(scene, &data, &mut solved);
        if !proved && found {
            return Err(data::refused(problem, scene, &agree::not_unique(scene, &data)));
        }
    } else if found && !agree::prove(scene, &data, &mut solved.clone()) {
        // What is summed has no enclosure by which another value could be excluded.
        let why = sentences::refusal(problem, scene, &agree::not_unique(scene, &data)).join("; ");
        io.note(&format!("note: a bank may not draw this: {why}"));
    }
    if happens(&problem.cases[case].rivals, &data) {
        io.note("note: a bank may not draw this: with these data other contacts may roll or slip as well");
    }
    let holds = data::fits(problem, case, &solved);
    let told = |label: Label| solved.get(label).is_some() || solved.word(label).is_some();
    for question in problem.questions.iter().filter(|q| holds && !told(q.label)) {
        io.note(&format!("note: question {} has no answer with these data", question.id));
    }
    io.piece(&match args.json {
        true => table::json(problem, case, &solved, &taken),
        false => table::table(problem, case, &shown, &solved, &taken, holds),
    });
    for note in sentences::sides(scene, &data) {
        io.note(&format!("note: {note}"));
    }
    Ok(if holds { Exit::Fine } else { Exit::RegimeFails })
}
