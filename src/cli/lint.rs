//! `slipstick lint`: all that is wrong in a bank, then how it behaves over many seeds.
use crate::bank::Bank;
use crate::bank::Problem;
use crate::bank::Question;
use crate::bank::node::shorten;
use crate::cli::args;
use crate::cli::args::Format;
use crate::cli::banks;
use crate::cli::banks::Texts;
use crate::cli::output::Output;
use crate::cli::solve;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::key::SheetKey;
use crate::num::shown;
use crate::problem::make::Maker;
use crate::problem::make::Variant;
use crate::problem::make_key;
use crate::problem::sweep;
use crate::problem::sweep::Seldom;
use crate::problem::sweep::Sweep;
use crate::sheet::document;
use crate::sheet::document::Dropped;
use crate::sheet::html;
use crate::sheet::html::Converter;
use crate::sheet::key_table;
use crate::sheet::page::Room;
use crate::sheet::page::Sheets;
use crate::sheet::statement;
use crate::solution;
use crate::solution::stop::Beyond;
use crate::solve::outcome::Motion;
use crate::words::Words;
use rayon::prelude::*;

/// A class for which the chance of equal sheets is told.
const CLASS: u32 = 500;
/// More honest answers than this share should not miss the tolerance.
const HONEST_MISSES: f64 = 0.05;
/// The chance that a bank should stay below.
const RARE: f64 = 1e-6;

/// Runs it.
pub fn run(args: &args::Lint, io: &mut Io) -> Exit {
    match lint(args, io) {
        Ok(findings) if findings.is_empty() => Exit::Fine,
        Ok(findings) | Err(findings) => io.findings(&findings),
    }
}

fn lint(args: &args::Lint, io: &mut Io) -> Result<Findings, Findings> {
    let mut loaded = banks::load(&args.bank)?;
    let language = args.own.language.as_deref().unwrap_or("en");
    let texts = banks::texts(&args.own, language, &mut loaded.bank)
        .map_err(|faults| faults.or_in_file(&loaded.file))?;
    let bank = &loaded.bank;
    let mut findings = banks::unknown_names(bank, &texts.templates);
    findings.extend(banks::never_given(bank, &texts.templates));
    let all: Vec<&Problem> = bank.problems.iter().collect();
    let sweeps = sweeps(&all, args.seeds, &bank.id);
    for (problem, sweep) in bank.problems.iter().zip(&sweeps) {
        if let Some((seed, none)) = &sweep.unsatisfiable {
            let mut fault = solve::unsatisfiable(bank, none);
            if none.constant.is_none() {
                fault.message = format!("seed {seed}: {}", fault.message);
            }
            findings.push(
                fault.in_file(&loaded.file).hint("widen the ranges, or loosen the rule that refuses most"),
            );
        } else if let Some(refusal) = &sweep.unsolved {
            for text in words::refusal(problem, &problem.cases[0].scene, refusal) {
                let what = format!("a draw cannot be solved: {text}");
                findings.push(Finding::new(format!("problems.{}", problem.id), what).in_file(&loaded.file));
            }
        }
    }
    let mut notes = Vec::new();
    if findings.is_empty() {
        let texts = faulty_texts(bank, &texts)?;
        findings.extend(texts.faults);
        notes = texts.notes;
        for (problem, sweep) in bank.problems.iter().zip(&sweeps) {
            for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
                let never = sweep::seldom(&seen.words).into_iter().filter(sweep::Seldom::never);
                findings.extend(never.map(|s| seldom(problem, question, &s).in_file(&loaded.file)));
            }
        }
    }
    for (problem, sweep) in bank.problems.iter().zip(&sweeps) {
        let tables = tables(problem, sweep);
        io.line(&format!("{}: {}", problem.id, problem.title));
        io.piece(&tell::table(&tables.cases, &LEFT_CASES));
        for (count, rule) in &tables.refusals {
            io.line(&format!("    refused {count:>6}  {rule}"));
        }
        io.piece(&tell::table(&tables.numbers, &LEFT_NUMBERS));
        io.piece(&tell::table(&tables.words, &LEFT_WORDS));
        if tables.mistakes.len() > 1 {
            let last = tables.mistakes.first().map_or(0, |head| head.len() - 1);
            io.piece(&tell::table(&tables.mistakes, &[0, last]));
        }
        if let Some(never) = never_near(&tables) {
            io.line(&format!("  {never}"));
        }
        let told = notes.iter().filter(|n| n.problem == problem.id).map(|n| &n.what);
        for note in tables.notes.iter().chain(told) {
            io.line(&format!("    note: {note}"));
        }
        io.line("");
    }
    io.line(&chance(&sweeps));
    for sweep in &sweeps {
        let one = sweep::coincidence(std::slice::from_ref(sweep), CLASS);
        io.line(&format!("  {} alone: at most {}", sweep.problem, shown::figures(one, 2)));
    }
    Ok(findings)
}

/// Tries problems of a bank over so many seeds.
pub fn sweeps(problems: &[&Problem], seeds: u64, bank: &str) -> Vec<Sweep> {
    let seeds = u32::try_from(seeds.clamp(1, 1_000_000)).unwrap_or(1_000_000);
    problems.par_iter().map(|p| sweep::sweep(p, 1, seeds, bank)).collect()
}

/// What a sweep over one problem says, row by row, heads first.
pub struct Tables {
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

/// Columns of texts, as [`tell::table`] takes them.
pub const LEFT_CASES: [usize; 1] = [0];
/// The same for numbers asked.
pub const LEFT_NUMBERS: [usize; 2] = [0, 3];
/// The same for words asked.
pub const LEFT_WORDS: [usize; 2] = [0, 1];

/// The tables of a sweep.
pub fn tables(problem: &Problem, sweep: &Sweep) -> Tables {
    let refusals = sweep.cases.iter().flat_map(|case| {
        let name = if case.name.is_empty() { String::new() } else { format!("{}: ", case.name) };
        case.refusals.iter().map(move |(rule, count)| (*count, format!("{name}{rule}")))
    });
    let (numbers, words) = questions(problem, sweep);
    let (mistakes, never) = mistakes(problem, sweep);
    Tables {
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
pub fn never_near(tables: &Tables) -> Option<String> {
    (!tables.never.is_empty()).then(|| format!("never near a right answer: {}", tables.never.join(", ")))
}

/// The chance of equal sheets, in a sentence.
pub fn chance(sweeps: &[Sweep]) -> String {
    let chance = sweep::coincidence(sweeps, CLASS);
    let verdict = if chance <= RARE { "rare enough" } else { "too likely: widen the ranges" };
    format!(
        "Chance that two of {CLASS} students get equal sheets of all {}: at most {} ({verdict}).",
        shown::figures(chance, 2),
        tell::count(sweeps.len(), "problem")
    )
}

fn cases(sweep: &Sweep) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["case", "share", "variants", "draws", "accepted", "valid variants"].map(str::to_owned).to_vec(),
    ];
    for case in &sweep.cases {
        let name = if case.name.is_empty() { "(all)" } else { &case.name };
        let accepted = if case.tries == 0 { "-".to_owned() } else { tell::percent(case.acceptance()) };
        rows.push(vec![
            name.to_owned(),
            tell::percent(case.share),
            case.variants.to_string(),
            case.tries.to_string(),
            accepted,
            if case.tries == 0 { "-".to_owned() } else { format!("about {}", shown::figures(case.valid, 1)) },
        ]);
    }
    rows
}

fn questions(problem: &Problem, sweep: &Sweep) -> (Vec<Vec<String>>, Vec<Vec<String>>) {
    let percent = |share: f64| if share.is_nan() { "-".to_owned() } else { tell::percent(share) };
    let mut rows = vec![
        [
            "question",
            "least",
            "greatest",
            "unit",
            "cond",
            "90 %",
            "worst",
            "limit",
            "above",
            "tolerance",
            "missed",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    for (question, seen) in problem.questions.iter().zip(&sweep.questions) {
        let mut row = vec![seen.id.clone()];
        if let Some((low, high)) = seen.range {
            row.extend([words::rounded(low, 4), words::rounded(high, 4), question.unit.ascii().to_owned()]);
            if let Some(cond) = seen.cond {
                row.extend([cond.median, cond.ninth, cond.worst].map(|c| words::rounded(c, 3)));
                row.extend([words::rounded(question.cond_limit, 3), percent(cond.above)]);
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
        s => tell::percent(s),
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
fn seldom(problem: &Problem, question: &Question, seldom: &Seldom) -> Finding {
    let Seldom { word, right, printed } = *seldom;
    let what = match right {
        0 => format!("`{word}` is offered and right in none of {printed} variants: that is no question"),
        _ => format!(
            "`{word}` is right in {right} of {printed} variants, less than {}",
            tell::percent(sweep::WORD_SHARE)
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

/// Where the figures asked and the tolerance do not fit the condition numbers, and words that are right too seldom.
fn notes(problem: &Problem, sweep: &Sweep) -> Vec<String> {
    let mut notes = Vec::new();
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
                tell::percent(missed),
                question.figures
            ));
        }
        if let Some(reach) = question.relative.reach()
            && question.cond_limit > reach
        {
            notes.push(format!(
                "{}: its tolerance widens up to cond {}, its cond limit is {}",
                question.id,
                words::rounded(reach, 3),
                words::rounded(question.cond_limit, 3)
            ));
        }
    }
    notes
}

/// What is found on one variant of each case.
#[derive(Default)]
pub struct Tried {
    /// Faults of statements and questions: students would see them.
    pub faults: Findings,
    /// Faults of worked solutions.
    pub unsolved: Findings,
    /// What is no fault: cases whose worked solution is a short page, what is dropped from a text.
    pub notes: Vec<Note>,
}

/// What is worth knowing of a problem before its sheets go out.
#[derive(Debug, PartialEq)]
pub struct Note {
    /// Id of the problem.
    pub problem: String,
    /// What is to be told.
    pub what: String,
}

/// That the worked solution is a short page, and why.
pub fn short_page(problem: &Problem, case: usize, what: Beyond) -> String {
    let case = match problem.cases.get(case).map_or("", |c| c.name.as_str()) {
        "" => String::new(),
        name => format!(" of the case `{name}`"),
    };
    let report = if what.is_fault() { "; that is a fault of slipstick, please report it" } else { "" };
    format!(
        "the worked solution{case} is a short page with data and answers: it does not cover {}{report}",
        what.text(&Words::english())
    )
}

/// Writes statement and worked solution of one variant of each case of these problems: faults that show only then, formulas
/// that cannot be read, and what the worked solutions do not cover.
///
/// # Errors
/// Faults of the templates.
pub fn tried(bank: &Bank, texts: &Texts, problems: &[usize]) -> Result<Tried, Findings> {
    let sheets = Sheets::new(&texts.templates, &texts.words, bank, &bank.id, problems)?;
    let mut room = Room::default();
    let mut out = Tried::default();
    for (i, problem) in problems.iter().filter_map(|p| bank.problems.get(*p)).enumerate() {
        for variant in one_of_each_case(problem, &bank.id) {
            let mut sheet = Vec::new();
            match sheets.problem(i, &variant, &mut room, &mut sheet) {
                Ok(()) => {
                    let text = String::from_utf8_lossy(&sheet);
                    add_formulas(&mut out.faults, problem, texts, &text);
                    for what in [&problem.title, &*text].into_iter().flat_map(document::dropped) {
                        let note = Note { problem: problem.id.clone(), what: not_kept(&what) };
                        if !out.notes.contains(&note) {
                            out.notes.push(note);
                        }
                    }
                }
                Err(fault) if out.faults.contains(&fault) => {}
                Err(fault) => out.faults.push(fault),
            }
            match solution::worked(problem, &variant, i + 1, &texts.words, &texts.templates) {
                Ok((_, None)) => {}
                Ok((_, Some(what))) => {
                    let what = short_page(problem, variant.case, what);
                    let note = Note { problem: problem.id.clone(), what };
                    if !out.notes.contains(&note) {
                        out.notes.push(note);
                    }
                }
                Err(fault) if out.unsolved.contains(&fault) => {}
                Err(fault) => out.unsolved.push(fault),
            }
        }
    }
    Ok(out)
}

fn add_formulas(findings: &mut Findings, problem: &Problem, texts: &Texts, markdown: &str) {
    for fault in html::faulty_formulas(markdown) {
        let mut finding = Finding::new(format!("problems.{}", problem.id), format!("formula {fault}"));
        // Where the questions are one's own as well, either may hold it.
        let own = |name: &str| texts.templates.own_file(name);
        if let Some(file) = own(&statement::template_name(problem))
            && own("questions.md").is_none()
        {
            finding = finding.in_file(file);
        }
        if !findings.contains(&finding) {
            findings.push(finding);
        }
    }
}

/// A variant of each case that 64 draws meet, one that moves and one that stays where both are declared; fewer if a draw cannot
/// be made.
fn one_of_each_case(problem: &Problem, bank: &str) -> Vec<Variant> {
    let maker = Maker::new(problem, 1, bank);
    let mut variants: Vec<Variant> = Vec::new();
    let may_stay = |regimes: &[String]| {
        [Motion::Balanced, Motion::Rest].iter().any(|m| regimes.iter().any(|word| m.is_called(word)))
    };
    let kinds = |regimes: &[String]| 1 + usize::from(regimes.len() > 1 && may_stay(regimes));
    let wanted: usize = problem.cases.iter().map(|c| kinds(&c.regimes)).sum();
    for student in 0..64 {
        if variants.len() == wanted {
            break;
        }
        let Ok(variant) = maker.variant(&format!("text {student}")) else { break };
        let kind = |v: &Variant| (v.case, v.solved.regime.stays());
        if variants.iter().all(|v| kind(v) != kind(&variant)) {
            variants.push(variant);
        }
    }
    variants
}

/// What a text of students does not keep, in words.
fn not_kept(what: &Dropped) -> String {
    match what {
        Dropped::Tag(html) => {
            format!(
                "`{}` is dropped: the tags are dropped, the words stay; write it in Markdown",
                shorten(html)
            )
        }
        Dropped::Html(html) => {
            format!("`{}` is dropped: it does not reach students, nor does what stands in it", shorten(html))
        }
        Dropped::Link(url) => {
            format!(
                "the link to `{}` is dropped: only http, https, mailto and places nearby stay",
                shorten(url)
            )
        }
        Dropped::Picture(url) => {
            format!("the picture `{}` is dropped: pages hold only what the program draws", shorten(url))
        }
    }
}

/// What [`tried`] finds in the whole bank; where that is nothing, a whole sheet is made in every format that this program makes
/// without a compiler.
fn faulty_texts(bank: &Bank, texts: &Texts) -> Result<Tried, Findings> {
    let problems: Vec<usize> = (0..bank.problems.len()).collect();
    let mut out = tried(bank, texts, &problems)?;
    out.faults.append(&mut out.unsolved);
    let sheets = Sheets::new(&texts.templates, &texts.words, bank, &bank.id, &problems)?;
    let mut room = Room::default();
    let first = |p: &Problem| one_of_each_case(p, &bank.id).into_iter().next();
    let whole: Vec<Variant> = bank.problems.iter().filter_map(first).collect();
    let findings = &out.faults;
    if findings.is_empty() && whole.len() == problems.len() {
        let formats = [Format::Md, Format::Html, Format::Tex];
        let output = Output::new(texts, &formats, "sheet")?;
        let (head, document) = sheets.document("0017", "Name", &whole, &mut room)?;
        let rows = [key_table::row(bank, &problems, &head, &whole)];
        let made = output.make(0, head, document, &mut Converter::new(&texts.words))?;
        output.booklets(&bank.title, std::slice::from_ref(&made))?;
        let parts = bank.problems.iter().zip(&whole).map(|(p, v)| make_key::key(p, v)).collect();
        let keys = [SheetKey { student: "0017".to_owned(), problems: parts }];
        output.key_table(bank, &bank.id, &problems, &rows, keys.iter())?;
    }
    Ok(out)
}
