//! What a bank is like before its sheets go out: tables over many draws, texts tried, a page with variants.
use crate::bank::{Bank, Case, Problem, Question};
use crate::finding::{Finding, Findings};
use crate::inspect::sentences;
use crate::inspect::table::unsatisfiable;
use crate::num::shown;
use crate::problem::sweep::{self, Seldom, Sweep};
use crate::review::tried_texts::TextNote;
use crate::sheet::texts::Texts;
use crate::sheet::{self, statement, terminal};
use rayon::prelude::*;

pub mod page;
pub mod tried_texts;

/// A class for which the chance of equal sheets is told.
pub const CLASS: u32 = 500;
/// More honest answers than this share should not miss the tolerance.
const HONEST_MISSES: f64 = 0.05;
/// The chance that a bank should stay below.
const RARE: f64 = 1e-6;

/// Told after each draw: how many there are in all.
pub type OneMore<'p> = &'p (dyn Fn(u64) + Sync);

/// Tries problems of a bank over so many seeds.
pub fn sweeps(problems: &[&Problem], seeds: u64, bank: &str, one_more: OneMore) -> Vec<Sweep> {
    let seeds = u32::try_from(seeds.clamp(1, 1_000_000)).unwrap_or(1_000_000);
    let all = u64::from(seeds) * problems.len() as u64;
    problems.par_iter().map(|p| sweep::sweep(p, 1, seeds, bank, &|| one_more(all))).collect()
}

/// What a sweep over one problem says, row by row, heads first.
#[derive(Default)]
pub struct SweepTables {
    /// Cases and how many of their draws are accepted.
    pub cases: Vec<Vec<String>>,
    /// How often each rule refused, and which.
    pub refusals: Vec<(u32, String)>,
    /// Questions that ask for numbers.
    pub numbers: Vec<Vec<String>>,
    /// Questions that ask for words; without a head.
    pub words: Vec<Vec<String>>,
    /// Wrong methods that land near a right answer in some draws: shares of draws by case, then by question.
    pub mistakes: Vec<Vec<String>>,
    /// Wrong methods that never do.
    pub never: Vec<String>,
    /// Where figures and tolerance do not fit the condition numbers.
    pub notes: Vec<String>,
}

/// Columns of texts, as [`terminal::table`] takes them.
pub const LEFT_CASES: [usize; 1] = [0];
/// The same for numbers asked.
pub const LEFT_NUMBERS: [usize; 2] = [0, 3];
/// The same for words asked.
pub const LEFT_WORDS: [usize; 2] = [0, 1];

/// The tables of a sweep; empty where no draw holds the rules.
pub fn tables(problem: &Problem, sweep: &Sweep) -> SweepTables {
    if !sweep.has_variants() {
        return SweepTables::default();
    }
    let refusals = sweep.cases.iter().flat_map(|case| {
        let name = if case.name.is_empty() { String::new() } else { format!("{}: ", case.name) };
        case.refusals.iter().map(move |(rule, count)| (*count, format!("{name}{rule}")))
    });
    let (numbers, words) = questions(problem, sweep);
    let (mistakes, never) = mistakes(problem, sweep);
    SweepTables {
        cases: cases(sweep),
        refusals: refusals.collect(),
        numbers,
        words,
        mistakes,
        never,
        notes: notes(problem, sweep),
    }
}

/// The wrong methods that no draw has near a right answer, in a sentence; nothing where there are none.
pub fn never_near(tables: &SweepTables) -> Option<String> {
    (!tables.never.is_empty()).then(|| format!("never near a right answer: {}", tables.never.join(", ")))
}

/// The chance of equal sheets, in a sentence, and that of each problem alone; nothing where there can be no sheets.
pub fn chance(sweeps: &[Sweep]) -> Vec<String> {
    if !sweeps.iter().all(Sweep::has_variants) {
        return Vec::new();
    }
    let told = |chance: f64| match chance < 0.01 {
        true => shown::figures(chance, 2),
        false => terminal::percent(chance),
    };
    let chance = sweep::coincidence(sweeps, CLASS);
    let verdict = if chance <= RARE { "rare enough" } else { "too likely: widen the ranges" };
    let all = match sweeps.len() {
        1 => "of the problem".to_owned(),
        n => format!("of all {n} problems"),
    };
    let sentence = format!(
        "Chance that two of {CLASS} students get equal sheets {all}: at most {} ({verdict}).",
        told(chance)
    );
    let alone = |sweep: &Sweep| {
        let one = sweep::coincidence(std::slice::from_ref(sweep), CLASS);
        format!("  {} alone: at most {}", sweep.problem, told(one))
    };
    std::iter::once(sentence).chain(sweeps.iter().filter(|_| sweeps.len() > 1).map(alone)).collect()
}

fn cases(sweep: &Sweep) -> Vec<Vec<String>> {
    let mut rows = vec![terminal::head("case | share | variants | draws | accepted | valid variants")];
    for case in &sweep.cases {
        let name = if case.name.is_empty() { "(all)" } else { &case.name }.to_owned();
        let tried = |text: &dyn Fn() -> String| if case.tries == 0 { "-".to_owned() } else { text() };
        let accepted = tried(&|| terminal::percent(case.acceptance()));
        let valid = tried(&|| format!("about {}", shown::figures(case.valid, 1)));
        let counts = [case.variants.to_string(), case.tries.to_string(), accepted, valid];
        rows.push([name, terminal::percent(case.share)].into_iter().chain(counts).collect());
    }
    rows
}

fn questions(problem: &Problem, sweep: &Sweep) -> (Vec<Vec<String>>, Vec<Vec<String>>) {
    let percent = |share: f64| if share.is_nan() { "-".to_owned() } else { terminal::percent(share) };
    let head =
        "question | least | greatest | unit | cond | 90 % | worst | limit | above | tolerance | missed";
    let mut rows = vec![terminal::head(head)];
    for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
        let mut row = vec![seen.id.clone()];
        if let Some((low, high)) = seen.range {
            row.extend([low, high].map(|end| shown::significant(end, 4)));
            row.push(question.unit.ascii().to_owned());
            if let Some(cond) = seen.cond {
                row.extend([cond.median, cond.ninth, cond.worst].map(|c| shown::significant(c, 3)));
                row.extend([shown::significant(question.cond_limit, 3), percent(cond.above)]);
            }
            let (least, most) = (statement::percent(seen.within.0), statement::percent(seen.within.1));
            row.push(if least == most { most } else { format!("{least} to {most}") });
            row.push(percent(seen.missed()));
        } else {
            let share = |w: &sweep::Listed| {
                format!("{} {} %", w.word, w.right * 100 / sweep::printed(&seen.words, w.list).max(1))
            };
            let list: Vec<String> = seen.words.iter().map(share).collect();
            row.push(list.join(", "));
        }
        rows.push(row);
    }
    // Words may be longer than a number: they stand behind the table's first column.
    rows.into_iter().partition(|r| r.len() != 2)
}

/// For each wrong method the share of draws that it would refuse: those in which it lands near a right answer. Then those that
/// never do.
fn mistakes(problem: &Problem, sweep: &Sweep) -> (Vec<Vec<String>>, Vec<String>) {
    let percent = |share: f64| match share {
        s if s.is_nan() => "-".to_owned(),
        s if s <= 0.0 => "0 %".to_owned(),
        s if s < 0.01 => "< 1 %".to_owned(),
        s => terminal::percent(s),
    };
    let single = sweep.cases.len() == 1;
    let mut head = vec!["wrong method".to_owned()];
    head.extend(sweep.cases.iter().map(|c| match single {
        true => "would refuse".to_owned(),
        false => c.name.clone(),
    }));
    head.push("near".to_owned());
    let mut rows = vec![head];
    let mut never = Vec::new();
    for (mistake, seen) in problem.mistakes.iter().zip(&sweep.mistakes) {
        if seen.near.iter().all(|s| s.is_nan() || *s <= 0.0) {
            never.push(seen.id.clone());
            continue;
        }
        let mut near: Vec<String> = Vec::new();
        for (q, share) in problem.questions.iter().zip(&seen.by_question).filter(|(_, s)| **s > 0.0) {
            let own = q.unguarded.iter().any(|(id, _)| *id == mistake.id) || mistake.unguarded.is_some();
            near.push(format!("{} {}{}", q.id, percent(*share), if own { " (allowed)" } else { "" }));
        }
        let mut row = vec![seen.id.clone()];
        row.extend(seen.near.iter().map(|s| percent(*s)));
        row.push(near.join(", "));
        rows.push(row);
    }
    (rows, never)
}

/// A word of a printed list that is right too seldom.
pub fn seldom(problem: &Problem, question: &Question, seldom: &Seldom) -> Finding {
    let Seldom { word, right, printed } = *seldom;
    let what = match right {
        0 => format!("`{word}` is offered and right in none of {printed} variants: that is no question"),
        _ => format!(
            "`{word}` is right in {right} of {printed} variants, less than {}",
            terminal::percent(sweep::WORD_SHARE)
        ),
    };
    let hint = "leave the question out, or let cases and ranges bring each word about, with the same data drawn for all";
    Finding::new(format!("problems.{}.questions.{}", problem.id, question.id), what).hint(hint)
}

/// Variants that are tried for the words of a problem where nothing else is asked of it.
const FOR_WORDS: u32 = 100;

/// Words of printed lists that are right too seldom, on a few variants of these problems.
pub fn seldom_words(bank: &Bank, problems: &[usize]) -> Findings {
    let mut found = Findings::default();
    for problem in problems.iter().filter_map(|p| bank.problems.get(*p)) {
        for (question, words) in sweep::words_of(problem, FOR_WORDS, &bank.id) {
            let question = &problem.questions[question];
            found.extend(sweep::seldom(&words).iter().map(|s| seldom(problem, question, s)));
        }
    }
    found
}

/// Where the figures asked and the tolerance do not fit the condition numbers, words that are right too seldom, and where bodies
/// lie that could lie elsewhere.
fn notes(problem: &Problem, sweep: &Sweep) -> Vec<String> {
    let mut notes = Vec::new();
    for (case, seen) in problem.cases.iter().zip(&sweep.cases) {
        let sides = seen.sample.iter().flat_map(|data| sentences::sides(&case.scene, data));
        notes.extend(sides);
    }
    notes.extend(problem.cases.iter().take(1).flat_map(|case| sentences::hidden(&case.scene)));
    for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
        let rare = sweep::seldom(&seen.words).into_iter().filter(|s| !s.never());
        notes.extend(rare.map(|s| format!("{}: {}", question.id, seldom(problem, question, &s).message)));
        let missed = seen.missed();
        if missed > HONEST_MISSES {
            let advice = match question.relative.fixed() {
                Some(_) => "let its tolerance widen with cond, ask for more figures, or lower its cond limit",
                None => "ask for more figures, or lower its cond limit",
            };
            notes.push(format!(
                "{}: {} of honest answers with {} figures on the way miss its tolerance; {advice}",
                question.id,
                terminal::percent(missed),
                question.figures
            ));
        }
        if let Some(reach) = question.relative.reach()
            && question.cond_limit > reach
        {
            notes.push(format!(
                "{}: its tolerance widens up to cond {}, its cond limit is {}",
                question.id,
                shown::significant(reach, 3),
                shown::significant(question.cond_limit, 3)
            ));
        }
    }
    notes
}

/// All that is wrong in a bank whose problems behave so over many seeds; and what is worth knowing besides. Errors: faults of the
/// templates.
pub fn faults(
    bank: &Bank,
    file: &str,
    own: &Texts,
    sweeps: &[Sweep],
) -> Result<(Findings, Vec<TextNote>), Findings> {
    let mut findings = sheet::texts::unknown_names(bank, &own.templates);
    findings.extend(sheet::texts::never_given(bank, &own.templates));
    for (problem, sweep) in bank.problems.iter().zip(sweeps) {
        if let Some((seed, none)) = &sweep.unsatisfiable {
            let mut fault = unsatisfiable(bank, none);
            if none.constant.is_none() {
                fault.message = format!("seed {seed}: {}", fault.message);
            }
            fault.hint.clone_from(&none.hint);
            findings.push(fault.in_file(file));
        } else if let Some(refusal) = &sweep.unsolved {
            for text in sentences::refusal(problem, &problem.cases[0].scene, refusal) {
                let what = format!("a draw cannot be solved: {text}");
                findings.push(Finding::new(format!("problems.{}", problem.id), what).in_file(file));
            }
        }
    }
    let mut notes = Vec::new();
    if findings.is_empty() {
        let tried = tried_texts::whole_bank(bank, own)?;
        findings.extend(tried.faults);
        notes = tried.notes;
        // Constants are of a book, and have the one answer that they have.
        let constant = |p: &Problem| p.cases.iter().all(Case::is_constant);
        for (problem, sweep) in bank.problems.iter().zip(sweeps).filter(|(p, _)| !constant(p)) {
            for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
                let never = sweep::seldom(&seen.words).into_iter().filter(sweep::Seldom::never);
                findings.extend(never.map(|s| seldom(problem, question, &s).in_file(file)));
            }
        }
    }
    Ok((findings, notes))
}
