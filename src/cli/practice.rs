//! `slipstick practice`: a problem is drawn and shown, answers are judged, another one follows; in the terminal or as a page.
use crate::bank::Problem;
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::practice::PracticePlan;
use crate::folder::{files, practice};
use crate::grade::verdict::Verdict;
use crate::inspect::sentences;
use crate::key::ProblemKey;
use crate::misconception::catalogue::{Catalogue, CatalogueEntry};
use crate::problem::make_key;
use crate::problem::maker::{Maker, Variant};
use crate::set::dealer;
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::{document, statement, terminal};
use crate::solve::outcome::Motion;
use crate::tutor::Tutor;
use crate::words::Words;
use crate::words::plain::plain;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::SystemTime;

/// Variants of a problem on a page at most, so that it can be mailed and a phone can show it.
const MOST: u32 = 20;

pub fn run(args: &args::PracticeArgs, io: &mut Io) -> Result<Exit, Findings> {
    let (loaded, texts) = args.own.load(&args.bank)?;
    let (bank, words) = (&loaded.bank, &texts.words);
    let problems = dealer::chosen(bank, args.problems.as_deref(), "--problems")?;
    if problems.is_empty() {
        return Err(Finding::new("problems", "there is none").in_file(&loaded.file).into());
    }
    let seed = args.seed.unwrap_or_else(from_clock);
    if let Some(file) = &args.page {
        let (loaded, texts, problems, variants) = (&loaded, &texts, &problems[..], args.variants);
        return write(&PracticePlan { loaded, texts, problems, seed, variants }, file, args.force, io);
    }
    let sheets = Sheets::new(&texts.templates, words, bank, practice::SET, &problems)?;
    let makers: Vec<Maker> =
        problems.iter().map(|p| Maker::new(&bank.problems[*p], seed, practice::SET)).collect();
    let of_seed = words.say("feedback.seed", &[("seed", &seed.to_string())]);
    io.line(&format!("{} ({of_seed}). {}", bank.title, words.get("feedback.commands")));
    let catalogue = Catalogue::shared(words.language());
    let find = |id: &str| catalogue.get(id).map(CatalogueEntry::words);
    let mut scratch = SheetScratch::default();
    let (mut right, mut asked) = (0, 0);
    for round in 0usize.. {
        let i = round % problems.len();
        let problem = &bank.problems[problems[i]];
        let variant = practice::drawn(&loaded, &makers[i], round / problems.len() + 1)?;
        let mut text = Vec::new();
        sheets.problem(i, &variant, &mut scratch, &mut text)?;
        let text = document::without_marks(&String::from_utf8_lossy(&text));
        io.line(&format!("\n## {}\n\n{}", problem.title, plain(&text)));
        let key = make_key::key(problem, &variant);
        let tutor = Tutor::new(problem, &variant, &key, bank.grading.hints, words, &find);
        if questions(problem, &variant, &key, (&mut right, &mut asked), (words, &tutor), io).is_break() {
            break;
        }
    }
    if asked > 0 {
        let pieces = [("right", &*right.to_string()), ("asked", &*asked.to_string())];
        io.line(&format!("\n{}", words.say("feedback.score", &pieces)));
    }
    Ok(Exit::Fine)
}

/// Writes the page.
fn write(plan: &PracticePlan, file: &Path, force: bool, io: &mut Io) -> Result<Exit, Findings> {
    files::may_write_file(file, force)?;
    if plan.variants == 0 || plan.variants > MOST {
        return Err(Finding::new("--variants", format!("{} is not from 1 to {MOST}", plan.variants)).into());
    }
    let page = practice::page(plan)?;
    let bytes = page.len();
    files::put_all(&[(file.to_owned(), page)])?;
    let problems = terminal::count(plan.problems.len() * plan.variants as usize, "problem");
    io.line(&format!("{}: {problems} (seed {}), {} kB", file.display(), plan.seed, bytes.div_ceil(1000)));
    Ok(Exit::Fine)
}

/// The question part of a round; it breaks where the student wants no other problem.
fn questions(
    problem: &Problem,
    variant: &Variant,
    key: &ProblemKey,
    (right, asked): (&mut usize, &mut usize),
    (words, tutor): (&Words, &Tutor),
    io: &mut Io,
) -> ControlFlow<()> {
    let commands = words.get("feedback.commands");
    for (part, (question, entry)) in problem.questions.iter().zip(&key.parts).enumerate() {
        // Hints that were given to this question; none is given twice.
        let mut said: Vec<String> = Vec::new();
        loop {
            io.piece(&format!("{} = ", entry.part));
            let Some(cell) = io.ask() else {
                io.line("");
                return ControlFlow::Break(());
            };
            match cell.as_str() {
                "quit" | "q" | "exit" => return ControlFlow::Break(()),
                "next" => return ControlFlow::Continue(()),
                "help" | "?" => {
                    io.line(&format!("  {commands}"));
                    continue;
                }
                "solution" => {
                    solution(problem, variant, key, words, io);
                    return ControlFlow::Continue(());
                }
                "" => {
                    *asked += 1;
                    break;
                }
                _ => {}
            }
            let Some(told) = tutor.tell(part, &cell) else { break };
            if told.verdict == Verdict::Right {
                io.line(&format!("  {} ({})", words.get("feedback.right"), told.reason));
                *asked += 1;
                *right += 1;
                break;
            }
            let word = question.label.quantity.is_word();
            let again = if word { "" } else { words.get("feedback.try_again") };
            io.line(&format!("  {}: {}{again}", told.verdict.as_str(), told.reason));
            if !told.hints.is_empty() {
                let next =
                    told.hints.iter().map(|h| h.text.as_str()).find(|text| !said.iter().any(|s| s == text));
                let next = next.unwrap_or_else(|| words.get("tutor.all_told")).to_owned();
                if !said.contains(&next) {
                    io.line(&format!("  {}", plain(&next)));
                    said.push(next);
                }
            }
            // A word that is no answer may have been meant as a command.
            let word = cell.chars().all(char::is_alphabetic);
            if word && told.verdict == Verdict::Unreadable {
                io.line(&format!("  {commands}"));
            }
        }
    }
    ControlFlow::Continue(())
}

fn solution(problem: &Problem, variant: &Variant, key: &ProblemKey, words: &Words, io: &mut Io) {
    let scene = &problem.cases[variant.case].scene;
    io.line(&format!("  {}", words.get("feedback.right_values")));
    if variant.solved.regime.motion != Motion::Instant {
        io.line(&format!("  {}", sentences::regime(words, variant.solved.regime)));
    }
    for (question, entry) in problem.questions.iter().zip(&key.parts) {
        let signs = statement::sense_words(words, scene, question.label);
        io.line(&format!("  {} = {}", entry.part, sentences::right_answer(words, entry, signs)));
    }
    // The conditions are told in English only.
    if words.language() == "en" {
        for check in &variant.solved.checks {
            io.line(&format!("  because {}", sentences::check(scene, &variant.solved.checks, check)));
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "the street door knows a clock; the seed is shown")]
fn from_clock() -> u64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    since.as_secs() % 1_000_000
}
