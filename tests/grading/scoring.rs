//! Grading scored against the truth: classes of which it is known what each answer really is, over all families.
//!
//! Each draw of each family is dealt to many made-up students at once. One works it by hand and writes three figures of each
//! quantity on the way; some give the right answer to four figures and more, in the asked unit and in others; for each wrong
//! method that the bank lists there is one who uses it throughout; the rest slip, guess and leave blank as the usual habits
//! have it. All hand in a file, which is graded as `slipstick grade` does it, and what comes out is held against the truth.
//!
//! The tables are printed with `--nocapture`; the longer run, with ten times the draws, is `-- --ignored` (best with `--release`).
use crate::support;
use slipstick::bank::Problem;
use slipstick::grade::rules::Rules;
use slipstick::grade::run;
use slipstick::grade::table::KeyTable;
use slipstick::key::{Answer, KeyEntry, ProblemKey, SheetKey};
use slipstick::policy::Policy;
use slipstick::problem::make_key;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::simulate::chance::Chance;
use slipstick::simulate::classwork::Work;
use slipstick::simulate::habits::{Habits, UnitHabit};
use slipstick::simulate::student::{SimulatedAnswer, SimulatedStudent as Student};
use slipstick::simulate::truth::{TrueKind as Kind, Truth};
use slipstick::simulate::written::WrittenCell as Cell;
use slipstick::simulate::{classwork, written};
use slipstick::solution::by_hand;
use slipstick::words::Words;
use std::collections::BTreeMap;
use std::io::Read;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Figures on the way of a careful student.
const ON_THE_WAY: usize = 3;
/// Of so many answers of each question that were rounded on the way at most one per thousand times this may be rejected.
const REJECTED: f64 = 0.003;
/// Share of wrong methods that are to be named.
const RECALLED: f64 = 0.99;
/// Share of the slips that are to be recognised. The answer to another part is recognised where it is of the same kind only.
const SLIPS: [(&str, f64); 3] = [("power of ten", 0.99), ("unit slip", 0.95), ("other part", 0.70)];
/// Draws whose cost is that of an integration in steps: fewer of them.
const SLOW: [(&str, u32); 2] = [("rod-and-spring", 8), ("lifted-rod", 3)];
/// Only each of so many draws is dealt to those who do anything but round on the way.
const OTHERS: u32 = 4;

/// Right of all.
#[derive(Debug, Clone, Copy, Default)]
struct Count {
    hits: usize,
    all: usize,
}

impl Count {
    fn add(&mut self, hit: bool) {
        self.hits += usize::from(hit);
        self.all += 1;
    }
    fn join(&mut self, other: Count) {
        self.hits += other.hits;
        self.all += other.all;
    }
    fn share(self) -> f64 {
        if self.all == 0 { f64::NAN } else { self.hits as f64 / self.all as f64 }
    }
}

/// What was seen of one family.
#[derive(Debug, Default)]
struct Score {
    rows: usize,
    draws: u32,
    /// For each question: answers rounded on the way that were rejected.
    rounded: Vec<(String, Count)>,
    /// Right answers to four figures and more that were rejected.
    rejected: Count,
    /// Values of guarded wrong methods that were marked right.
    accepted: Count,
    /// Values of unguarded ones that were marked right.
    excepted: Count,
    /// For each wrong method: answers by it that were not marked right, and of these the ones where it was named.
    recalled: BTreeMap<String, Count>,
    /// For each wrong method: answers where it was named, and of these the ones that were by it.
    precise: BTreeMap<String, Count>,
    /// Answers for which one method was named, or it came first.
    first: Count,
    /// For each kind: rows that got the verdict that the truth says.
    verdicts: BTreeMap<&'static str, Count>,
    /// For each kind of slip: wrong answers, and of these the ones where it was recognised.
    slips: BTreeMap<&'static str, Count>,
    /// What is not as it should be, in words.
    faults: Vec<String>,
}

fn handed(part: usize, cell: Cell, entry: &KeyEntry, kind: Kind, method: &str) -> SimulatedAnswer {
    let verdict = cell.verdict(entry);
    let truth = Truth {
        kind,
        method: method.to_owned(),
        figures: None,
        from: String::new(),
        right: kind.deserves(),
        verdict,
    };
    SimulatedAnswer { problem: 0, part, attempt: 1, cell, truth }
}

/// The made-up students of one draw, the one who rounds on the way first.
fn students(
    draw: u32,
    (problem, variant, key): (&Problem, &Variant, &ProblemKey),
    habits: &Habits,
    words: &Words,
    score: &mut Score,
) -> Vec<Work> {
    let mut works = Vec::new();
    let mut add = |role: &str, handed: Vec<SimulatedAnswer>| {
        let key = SheetKey { student: format!("{draw}-{role}"), problems: vec![key.clone()] };
        works.push(Work { key, handed });
    };
    let numbers = || {
        key.parts.iter().enumerate().filter_map(|(i, e)| match e.answer {
            Answer::Number { .. } => Some((i, e)),
            Answer::Word { .. } => None,
        })
    };
    // Nobody writes intermediate figures of what has no worked solution of this kind: bodies that are joined in the plane.
    let scene = &problem.cases[variant.case].scene;
    let worked = scene.lead().is_none() || scene.pinned().is_some();
    let hand = match by_hand::answers(problem, variant, words, ON_THE_WAY) {
        _ if !worked => Vec::new(),
        Ok(hand) => hand,
        Err(fault) => {
            score.faults.push(format!("{} by hand: {fault}", problem.id));
            Vec::new()
        }
    };
    let figures = u32::try_from(ON_THE_WAY).unwrap();
    let mut own = Vec::new();
    for (i, entry) in numbers().filter(|_| worked) {
        let Some(found) = hand.iter().find(|h| h.label == problem.questions[i].label) else {
            score.faults.push(format!("{} {}: not found by hand", problem.id, entry.part));
            continue;
        };
        let cell = |x: f64| Cell::number(x, &entry.unit, figures);
        own.extend(found.value().map(|x| handed(i, cell(x), entry, Kind::RoundedOnTheWay, "")));
    }
    add("hand", own);
    if !draw.is_multiple_of(OTHERS) {
        return works;
    }
    let mut chance = Chance::of(u64::from(draw), "units");
    for (role, figures, unit) in [
        ("right-4", 4, UnitHabit::Asked),
        ("right-5", 5, UnitHabit::Other),
        ("right-9", 9, UnitHabit::Asked),
        ("right-4-other", 4, UnitHabit::Other),
    ] {
        let mut answers = Vec::new();
        for (i, entry) in key.parts.iter().enumerate() {
            let cell = match &entry.answer {
                Answer::Word { right, .. } => Cell::Word(right),
                Answer::Number { value, .. } => {
                    let cell = Cell::number(*value, &entry.unit, 15);
                    match written::in_habit(cell, &entry.unit, unit, figures, &mut chance) {
                        Cell::Number { unit: Some(unit), .. } => Cell::number(*value, &unit, figures),
                        cell => cell,
                    }
                }
            };
            answers.push(handed(i, cell, entry, Kind::Right, ""));
        }
        add(role, answers);
    }
    for (m, id) in key.methods.iter().enumerate() {
        let mut answers = Vec::new();
        for (i, entry) in numbers() {
            for wrong in entry.wrong.iter().filter(|w| usize::from(w.method) == m) {
                let cell = Cell::number(wrong.value, &entry.unit, 4);
                answers.push(handed(i, cell, entry, Kind::WrongMethod, id));
            }
        }
        add(id, answers);
    }
    for role in ["any-1", "any-2", "any-3"] {
        let student = format!("{draw}-{role}");
        let work = Student::new(habits, words, 5, &student).work(&[(problem, variant, key)]);
        add(role, work);
    }
    works
}

/// What answers.csv says of such a slip.
const fn recognised(kind: Kind) -> Option<&'static str> {
    match kind {
        Kind::PowerOfTen => Some("power_of_ten:"),
        Kind::UnitSlip => Some(":"),
        Kind::OtherPart => Some("part:"),
        Kind::Followed => Some("follow:"),
        _ => None,
    }
}

/// Is this method at this question one near which draws are not refused?
fn unguarded(problem: &Problem, part: &str, method: &str) -> bool {
    let mistake = problem.mistakes.iter().find(|m| m.id == method).unwrap();
    let question = problem.questions.iter().find(|q| q.id == part).unwrap();
    mistake.unguarded.is_some() || question.unguarded.iter().any(|(id, _)| id == method)
}

fn score(problem: &Problem, draws: u32, words: &Words) -> Score {
    let mut score = Score {
        draws,
        rounded: problem.questions.iter().map(|q| (q.id.clone(), Count::default())).collect(),
        ..Score::default()
    };
    // Many of all sorts, each part once.
    let habits = Habits::read(HABITS, "habits").unwrap();
    let maker = Maker::new(problem, 4, "scoring");
    let mut works = Vec::new();
    for draw in 0..draws {
        let variant = maker.variant(&draw.to_string()).unwrap();
        let key = make_key::key(problem, &variant);
        works.extend(students(draw, (problem, &variant, &key), &habits, words, &mut score));
    }
    let files = classwork::write(&habits, words, 5, &works);
    score.rows = files.rows;
    let table = KeyTable::new(works.into_iter().map(|w| w.key).collect(), &[]);
    let submissions = files.submissions;
    let open = || -> std::io::Result<Box<dyn Read + Send>> {
        Ok(Box::new(std::io::Cursor::new(submissions.clone())))
    };
    let mut answers = Vec::new();
    let policy = Policy::default();
    let rules = Rules::new(&table, &policy).unwrap();
    run::grade(&open, &table, &rules, &run::Options::default(), &mut answers, &mut |_| {}).unwrap();
    compare(problem, &answers, &files.truth, &mut score);
    score
}

const HABITS: &str = "
answers: {right: 3, wrong sign: 1, unit slip: 1, wrong unit: 1, power of ten: 1, typing error: 2, other part: 1, blank: 1, garbage: 1, wrong method: 3}
carries on: 50 %
follows on: 50 %
figures: {4: 1, 6: 1}
units: {asked: 3, other: 1, none: 1}
direction by word: 50 %
decimal commas: 20 %
";

/// Holds what grading says against the truth, row by row.
fn compare(problem: &Problem, answers: &[u8], truth: &[u8], score: &mut Score) {
    let mut answers = csv::Reader::from_reader(answers);
    let header = answers.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let (line, verdict, methods, reason) =
        (column("line"), column("verdict"), column("methods"), column("reason"));
    let mut truth = csv::Reader::from_reader(truth);
    let mut truths = truth.records();
    for graded in answers.records() {
        let (graded, truth) = (graded.unwrap(), truths.next().unwrap().unwrap());
        let [l, student, _, part, _, answer, kind, method, _, _, right, says] =
            std::array::from_fn::<_, 12, _>(|i| truth.get(i).unwrap());
        assert_eq!(graded.get(line).unwrap(), l);
        let verdict = graded.get(verdict).unwrap();
        let named: Vec<&str> = graded.get(methods).unwrap().split_whitespace().collect();
        let kind = *Kind::ALL.iter().find(|k| k.as_str() == kind).unwrap();
        let at = || {
            let reason = graded.get(reason).unwrap();
            format!(
                "{} {part} of {student}: `{answer}` ({}) is {verdict}: {reason}",
                problem.id,
                kind.as_str()
            )
        };
        score.verdicts.entry(kind.as_str()).or_default().add(verdict == says);
        if verdict != says {
            score.faults.push(format!("{}, not {says}", at()));
        }
        let rejected = verdict != "right";
        if kind == Kind::RoundedOnTheWay {
            let place = score.rounded.iter().position(|(id, ..)| id == part).unwrap();
            score.rounded[place].1.add(rejected);
        } else if kind == Kind::Right && right == "yes" {
            score.rejected.add(rejected);
            if rejected {
                score.faults.push(at());
            }
        }
        if verdict == "wrong"
            && let Some(sign) = recognised(kind)
        {
            let said =
                format!("{} {}", graded.get(column("slip")).unwrap(), graded.get(column("credit")).unwrap());
            score.slips.entry(kind.as_str()).or_default().add(said.contains(sign));
        }
        for id in &named {
            score.precise.entry((*id).to_owned()).or_default().add(*id == method);
        }
        if kind == Kind::WrongMethod && !method.is_empty() && verdict != "missing unit" {
            let excepted = unguarded(problem, part, method);
            if excepted {
                score.excepted.add(!rejected)
            } else {
                score.accepted.add(!rejected)
            }
            if !excepted && !rejected {
                score.faults.push(at());
            }
            if rejected {
                let hit = named.contains(&method);
                score.recalled.entry(method.to_owned()).or_default().add(hit);
                score.first.add(named.first() == Some(&method));
                // A round number may be a guess: it is left unnamed, and counts in the share alone.
                if !hit && figures(answer) > 1 {
                    score.faults.push(format!("{method} is not named: {} [{}]", at(), named.join(" ")));
                }
            }
        }
    }
    assert!(truths.next().is_none(), "{}: more truth than answers", problem.id);
}

/// Figures of a written number without zeros at either end: of `30000 mm` one.
fn figures(answer: &str) -> usize {
    let digits: String =
        answer.chars().take_while(|c| !c.is_alphabetic()).filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').len()
}

/// All families, on as many threads as there are cores, the slow ones first.
fn all(draws: u32) -> Vec<(String, Score)> {
    let banks = support::banks();
    let slow = |id: &str| SLOW.iter().find(|(s, _)| *s == id).map_or(1, |(_, by)| *by);
    let mut problems: Vec<&Problem> = banks.iter().flat_map(|b| &b.problems).collect();
    problems.sort_by_key(|p| std::cmp::Reverse(slow(&p.id)));
    let words = Words::english();
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(problem) = problems.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let score = score(problem, draws / slow(&problem.id), &words);
                    done.lock().unwrap().push((problem.id.clone(), score));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap();
    done.sort_by_key(|(id, _)| banks.iter().flat_map(|b| &b.problems).position(|p| p.id == *id));
    done
}

fn percent(count: Count) -> String {
    if count.all == 0 { "-".to_owned() } else { format!("{:.2} %", 100.0 * count.share()) }
}

/// Prints what was seen and asserts the bars.
fn judge(scores: &[(String, Score)], least: usize) {
    let mut faults: Vec<String> = Vec::new();
    let mut kinds: BTreeMap<&str, Count> = BTreeMap::new();
    let mut slips: BTreeMap<&str, Count> = BTreeMap::new();
    let (mut rejected, mut accepted, mut excepted) = (Count::default(), Count::default(), Count::default());
    let (mut recalled, mut precise, mut first) = (Count::default(), Count::default(), Count::default());
    println!("Rejected although right, with {ON_THE_WAY} figures on the way");
    for (family, s) in scores {
        println!("  {family}: {} draws, {} answers", s.draws, s.rows);
        for (part, count) in s.rounded.iter().filter(|(_, c)| c.all > 0) {
            println!("    {part:20} {:>8} of {:5}", percent(*count), count.all);
            // The worst of some sixty questions: of a few hundred answers each, chance alone moves it by four standard deviations.
            let chance = 4.0 * (REJECTED * (1.0 - REJECTED) / count.all as f64).sqrt();
            if count.share() > REJECTED + chance {
                faults.push(format!(
                    "{family} {part}: {} rejected of {} rounded on the way",
                    count.hits, count.all
                ));
            }
        }
    }
    println!("Wrong methods: how many, of these named (recall); how often named, of these by it (precision)");
    for (family, s) in scores {
        println!("  {family}");
        for (id, count) in &s.recalled {
            let named = s.precise.get(id).copied().unwrap_or_default();
            println!(
                "    {id:5} {:6} {:>9}   {:6} {:>9}",
                count.all,
                percent(*count),
                named.all,
                percent(named)
            );
            if count.share() < RECALLED {
                faults.push(format!("{family} {id}: {} of {} named", count.hits, count.all));
            }
            recalled.join(*count);
            precise.join(named);
        }
        rejected.join(s.rejected);
        accepted.join(s.accepted);
        excepted.join(s.excepted);
        first.join(s.first);
        for (kind, count) in &s.slips {
            slips.entry(kind).or_default().join(*count);
        }
        for (kind, count) in &s.verdicts {
            kinds.entry(kind).or_default().join(*count);
        }
        faults.extend(s.faults.iter().cloned());
    }
    println!("Verdicts as the truth says, by kind");
    for (kind, count) in kinds {
        println!("  {kind:20} {:7} {:>9}", count.all, percent(count));
    }
    println!(
        "Slips of wrong answers that are recognised; what follows from an answer that is too far off earns nothing"
    );
    for (kind, count) in slips {
        println!("  {kind:20} {:7} {:>9}", count.all, percent(count));
        let bar = SLIPS.iter().find(|(k, _)| *k == kind).map_or(0.0, |(_, bar)| *bar);
        // Of a few the share says little: within two standard deviations of the bar it is chance.
        let chance = 2.0 * (bar * (1.0 - bar) / count.all as f64).sqrt();
        if count.all >= 100 && count.share() < bar - chance {
            faults.push(format!("{kind}: {} of {} recognised", count.hits, count.all));
        }
    }
    let answers: usize = scores.iter().map(|(_, s)| s.rows).sum();
    println!("{answers} answers of {} families", scores.len());
    println!("  right to 4 figures or more, rejected:      {} of {}", rejected.hits, rejected.all);
    println!("  guarded wrong methods marked right:        {} of {}", accepted.hits, accepted.all);
    println!("  unguarded ones marked right (excepted):    {} of {}", excepted.hits, excepted.all);
    println!(
        "  wrong methods named: {} of {}; first of those named: {}",
        percent(recalled),
        recalled.all,
        percent(first)
    );
    println!("  names that are right: {} of {}", percent(precise), precise.all);
    let shown: Vec<String> = faults.iter().take(40).cloned().collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), shown.join("\n"));
    assert_eq!(scores.len(), support::banks().iter().map(|b| b.problems.len()).sum::<usize>());
    assert!(answers >= least, "{answers} answers");
    assert!(rejected.all > answers / 20 && accepted.all > answers / 10, "too few of a kind");
}

#[test]
fn grading_is_held_against_the_truth() {
    let draws = support::seeds(400);
    judge(&all(draws), 250 * draws as usize);
}

#[test]
#[ignore = "ten times the draws, a minute and more in a release build"]
fn grading_is_held_against_the_truth_at_length() {
    judge(&all(4000), 1_000_000);
}
