//! `slipstick check`: a student's own answers against the public sheet file, which is solved anew.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{files, names};
use crate::grade::verdict::Verdict;
use crate::inspect::sentences::{refusal, right_answer};
use crate::misconception::catalogue::{Catalogue, CatalogueEntry};
use crate::page::check::{self, CheckedProblem, Unsolved};
use crate::page::sheet_file::{SheetFile, SheetProblem};
use crate::sheet::{statement, terminal};
use crate::units;
use crate::words::Words;
use std::collections::BTreeSet;
use std::path::Path;

/// A folder, or another file of a sheet than the one that answers are checked by.
fn no_sheet(given: &Path, is: &str) -> Finding {
    let beside = if given.is_dir() { given.join(names::SHEET) } else { given.with_file_name(names::SHEET) };
    let fault = Finding::of_file(given, is);
    fault.hint(match beside.is_file() {
        true => format!("answers are checked by another file: give {}", beside.display()),
        false => "give the file sheet.json that came with your sheet; the page sheet.html is for a browser"
            .to_owned(),
    })
}

pub fn run(args: &args::CheckArgs, io: &mut Io) -> Result<Exit, Findings> {
    let file = args.sheet.display().to_string();
    if args.sheet.is_dir() {
        return Err(no_sheet(&args.sheet, "is a folder").into());
    }
    let text = files::read_text(&args.sheet)?;
    let sheet = SheetFile::parse(&text).map_err(|fault| {
        // What begins otherwise is no JSON at all: the page, or the sheet in Markdown or LaTeX.
        match text.trim_start().starts_with('{') {
            true => fault.in_file(&file),
            false => no_sheet(&args.sheet, "is no sheet file"),
        }
    })?;
    // A sheet in a language that this program does not know is answered in English.
    let words = sheet.language.as_deref().and_then(Words::built_in);
    let words = words.or_else(|| Words::built_in("en")).unwrap_or_else(|| panic!("English is built in"));
    let catalogue = Catalogue::shared(words.language());
    let mut faults = Findings::default();
    // Which problems and parts are meant, before anything is solved.
    let mut asked = Vec::new();
    for answer in &args.answers {
        let Some((name, cell)) = answer.split_once('=') else {
            let fault = Finding::new("", format!("`{answer}` is no answer"));
            faults.push(fault.hint("write the part, `=` and the answer, such as 1.omega='30.3 rad/s'"));
            continue;
        };
        let Some((problem, part)) = name.trim().split_once('.') else {
            let fault = Finding::new("", format!("`{name}` is no part of a problem"));
            faults.push(fault.hint("write problem, point, part, such as 1.omega"));
            continue;
        };
        let found = sheet.problems.iter().position(|p| p.number.to_string() == problem || p.id == problem);
        match found {
            Some(i) => asked.push((name.trim(), i, part, cell)),
            None => {
                let known: Vec<String> =
                    sheet.problems.iter().map(|p| format!("{} ({})", p.number, p.id)).collect();
                let fault = Finding::new("", format!("`{name}`: the sheet has no problem `{problem}`"));
                faults.push(listed_once(fault, format!("its problems: {}", known.join(", ")), &faults));
            }
        }
    }
    let mut solved: Vec<Option<CheckedProblem>> = sheet.problems.iter().map(|_| None).collect();
    let named: BTreeSet<usize> = asked.iter().map(|(_, i, _, _)| *i).collect();
    for i in named {
        match solve(&sheet.problems[i], &file) {
            Ok(done) => solved[i] = Some(done),
            Err(more) => more.into_iter().for_each(|fault| faults.push(fault)),
        }
    }
    let (mut rows, mut hints) = (Vec::new(), Vec::new());
    let mut all_right = true;
    for (name, i, part, cell) in asked {
        let Some(problem) = &solved[i] else { continue };
        let Some(p) = problem.part(part) else {
            let known: Vec<&str> = problem.key.parts.iter().map(|e| e.part.as_str()).collect();
            let what = format!(
                "`{name}`: problem {} ({}) has no part `{part}`",
                problem.posed.number, problem.posed.problem.id
            );
            let fault = Finding::new("", what);
            faults.push(match units::spell::did_you_mean(part, known.iter().copied()) {
                Some(hint) => fault.hint(hint),
                None => listed_once(fault, format!("its parts: {}", known.join(", ")), &faults),
            });
            continue;
        };
        let find = |id: &str| catalogue.get(id).map(CatalogueEntry::words);
        let Some(told) = problem.check(p, cell, words, &find) else { continue };
        let entry = &problem.key.parts[p];
        let right = told.verdict == Verdict::Right;
        all_right &= right;
        let mut row = vec![name.to_owned(), cell.to_owned(), told.verdict.as_str().to_owned(), told.reason];
        if !told.hints.is_empty() {
            let of = told.hints.len();
            let (n, of) = (args.hint.to_string(), of.to_string());
            hints.push(match told.hints.get(args.hint - 1) {
                Some(hint) => {
                    words.say("tutor.numbered", &[("part", name), ("n", &n), ("of", &of), ("hint", hint)])
                }
                None => words.say("tutor.no_more", &[("part", name), ("of", &of)]),
            });
        }
        if args.reveal && !right {
            if problem.posed.reveal {
                let label = problem.posed.problem.questions[p].label;
                let signs = statement::sense_words(words, problem.scene(), label);
                let answer = right_answer(words, entry, signs);
                row.push(words.say("feedback.shown", &[("answer", &answer)]));
            } else {
                row.push(words.get("feedback.not_shown").to_owned());
            }
        }
        rows.push(row);
    }
    // What can be judged is judged, whatever is wrong with the rest.
    io.piece(&terminal::table(&rows, &[0, 1, 2, 3, 4]));
    for hint in hints {
        io.line(&hint);
    }
    faults.into_result(())?;
    Ok(if all_right { Exit::Fine } else { Exit::NotAllRight })
}

/// With a list as hint, unless an earlier finding has printed it.
fn listed_once(fault: Finding, list: String, earlier: &[Finding]) -> Finding {
    let said = earlier.iter().any(|f| f.hint.as_ref() == Some(&list));
    if said { fault } else { fault.hint(list) }
}

fn solve(problem: &SheetProblem, file: &str) -> Result<CheckedProblem, Findings> {
    let place = format!("{file}, problem {}", problem.number);
    check::solve(problem, &place).map_err(|unsolved| match unsolved {
        Unsolved::NoScene => {
            let fault = Finding::new("", "this sheet cannot be checked: it carries no scene").in_file(&place);
            fault.hint("the instructor has switched self-checks off for this bank").into()
        }
        Unsolved::Faults(faults) => faults.in_file(&place),
        Unsolved::Refused(only, why) => {
            let texts = refusal(&only, &only.cases[0].scene, &why);
            texts.into_iter().map(|text| Finding::new("data", text).in_file(&place)).collect()
        }
    })
}
