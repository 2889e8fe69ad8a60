//! `slipstick check`: a student's own answers against the public sheet file, which is solved anew.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Case, Draw, Question};
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{banks, files};
use crate::grade::verdict::Verdict;
use crate::inspect::sentences::{refusal, right_answer};
use crate::key::{Answer, ProblemKey};
use crate::misconception::catalogue::{Catalogue, Entry};
use crate::problem::maker::Variant;
use crate::problem::{make_key, maker};
use crate::sheet::public::{SheetFile, SheetProblem};
use crate::sheet::{statement, terminal};
use crate::tutor::{Told, Tutor};
use crate::units;
use crate::words::Words;
use std::collections::BTreeSet;

/// One problem of the sheet, solved.
struct CheckedProblem {
    number: usize,
    id: String,
    bank: Bank,
    variant: Variant,
    key: ProblemKey,
    /// Words for the sign of each part.
    signs: Vec<[String; 2]>,
}

/// Runs it.
pub fn run(args: &args::CheckArgs, io: &mut Io) -> Result<Exit, Findings> {
    let file = args.sheet.display().to_string();
    let text = files::read_text(&args.sheet)?;
    let sheet = SheetFile::parse(&text).map_err(|f| f.in_file(&file))?;
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
        match solve(&sheet.problems[i], &file, words) {
            Ok(done) => solved[i] = Some(done),
            Err(more) => more.into_iter().for_each(|fault| faults.push(fault)),
        }
    }
    let (mut rows, mut hints) = (Vec::new(), Vec::new());
    let mut all_right = true;
    for (name, i, part, cell) in asked {
        let Some(problem) = &solved[i] else { continue };
        let Some(p) = problem.key.parts.iter().position(|e| e.part == part) else {
            let known: Vec<&str> = problem.key.parts.iter().map(|e| e.part.as_str()).collect();
            let what = format!("`{name}`: problem {} ({}) has no part `{part}`", problem.number, problem.id);
            let fault = Finding::new("", what);
            faults.push(match units::spell::did_you_mean(part, known.iter().copied()) {
                Some(hint) => fault.hint(hint),
                None => listed_once(fault, format!("its parts: {}", known.join(", ")), &faults),
            });
            continue;
        };
        let Some(told) = problem.tell(p, cell, words, catalogue) else { continue };
        let entry = &problem.key.parts[p];
        let right = told.verdict == Verdict::Right;
        all_right &= right;
        let mut row = vec![name.to_owned(), cell.to_owned(), told.verdict.as_str().to_owned(), told.reason];
        if !told.hints.is_empty() {
            let of = told.hints.len();
            let (n, of) = (args.hint.to_string(), of.to_string());
            hints.push(match told.hints.get(args.hint - 1).map(|hint| terminal::plain(&hint.text)) {
                Some(hint) => {
                    words.say("tutor.numbered", &[("part", name), ("n", &n), ("of", &of), ("hint", &hint)])
                }
                None => words.say("tutor.no_more", &[("part", name), ("of", &of)]),
            });
        }
        if args.reveal && !right {
            if problem.bank.reveal {
                let [forward, back] = &problem.signs[p];
                let answer = right_answer(words, entry, [forward, back]);
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
    if !faults.is_empty() {
        return Err(faults);
    }
    Ok(if all_right { Exit::Fine } else { Exit::NotAllRight })
}

/// With a list as hint, unless an earlier finding has printed it.
fn listed_once(fault: Finding, list: String, earlier: &[Finding]) -> Finding {
    let said = earlier.iter().any(|f| f.hint.as_ref() == Some(&list));
    if said { fault } else { fault.hint(list) }
}

impl CheckedProblem {
    fn tell(&self, part: usize, cell: &str, words: &Words, catalogue: &Catalogue) -> Option<Told> {
        let find = |id: &str| catalogue.get(id).map(Entry::words);
        let level = self.bank.grading.hints;
        Tutor::new(self.bank.problems.first()?, &self.variant, &self.key, level, words, &find)
            .tell(part, cell)
    }
}

fn solve(problem: &SheetProblem, file: &str, words: &Words) -> Result<CheckedProblem, Findings> {
    let place = format!("{file}, problem {}", problem.number);
    let in_file = |faults: Findings| -> Findings { faults.in_file(&place) };
    let Some(text) = problem.bank_text().map_err(in_file)? else {
        let fault = Finding::new("", "this sheet cannot be checked: it carries no scene").in_file(&place);
        return Err(fault.hint("the instructor has switched self-checks off for this bank").into());
    };
    // Places in the text made here mean nothing to the reader of the sheet.
    let no_place = |faults: Findings| -> Findings {
        faults
            .into_iter()
            .map(|mut f| {
                f.at = None;
                f
            })
            .collect()
    };
    let bank = banks::parse(&text, &place).map_err(no_place)?;
    let Some(only) = bank.problems.first() else {
        return Err(Finding::new("scene", "holds no problem").in_file(&place).into());
    };
    let given = |case: &Case| -> Vec<Option<Decimal>> {
        let draws = case.draws.iter();
        draws
            .map(|d| match d {
                Some(Draw::Always { value, decimals }) => {
                    Some(Decimal { value: *value, decimals: *decimals })
                }
                _ => None,
            })
            .collect()
    };
    // A contact may be left open: what happens is the case in which what was assumed of it holds.
    let mut solved = only.cases.iter().enumerate().map(|(i, case)| maker::from_values(only, i, &given(case)));
    let Some(first) = solved.next() else {
        return Err(Finding::new("scene", "holds no problem").in_file(&place).into());
    };
    let holds = |v: &Variant| v.solved.all_hold() && !v.solved.regime.slips;
    let variant = match first {
        Ok(variant) if !holds(&variant) => solved.flatten().find(holds).unwrap_or(variant),
        Err(why) => solved.flatten().find(holds).ok_or_else(|| {
            let texts = refusal(only, &only.cases[0].scene, &why);
            texts.into_iter().map(|t| Finding::new("data", t).in_file(&place)).collect::<Findings>()
        })?,
        Ok(variant) => variant,
    };
    let scene = &only.cases[variant.case].scene;
    let signs = |q: &Question| statement::direction_words(words, scene, q.label.of).map(str::to_owned);
    let mut key = make_key::key(only, &variant);
    for part in &mut key.parts {
        let printed =
            problem.parts.iter().find(|p| p.id == part.part).and_then(|p| make_key::listed(&p.words));
        if let (Answer::Word { offered, .. }, Some(list)) = (&mut part.answer, printed) {
            *offered = list;
        }
    }
    let signs = only.questions.iter().map(signs).collect();
    Ok(CheckedProblem { number: problem.number, id: problem.id.clone(), bank, variant, key, signs })
}
