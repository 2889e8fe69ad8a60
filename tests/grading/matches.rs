//! Whose answer is this: how often honest classes are flagged, and how often copying is seen.
use crate::support;

use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha20Rng;
use slipstick::key::{Answer, ProblemKey};
use slipstick::matches;
use slipstick::matches::{AnswerColumn, WrongAnswer};
use slipstick::problem::make_key;
use slipstick::problem::maker::Maker;
use std::sync::LazyLock;

/// Keys of so many drawn students of each problem of a bank: problem, student.
type Keys = Vec<Vec<ProblemKey>>;

const DRAWN: usize = 120;

static BANKS: LazyLock<Vec<(String, Keys)>> = LazyLock::new(|| {
    let keys = |bank: &slipstick::bank::Bank| {
        let of = |problem| {
            let maker = Maker::new(problem, 5, "matches");
            let key = |i: usize| {
                let variant = maker.variant(&format!("s{i}")).expect("a variant");
                make_key::key(problem, &variant)
            };
            (0..DRAWN).map(key).collect()
        };
        bank.problems.iter().map(of).collect()
    };
    support::banks().iter().map(|bank| (bank.id.clone(), keys(bank))).collect()
});

/// A class: which drawn key each student has, problem by problem, dealt anew.
struct Class<'k> {
    questions: Vec<AnswerColumn>,
    keys: Vec<Vec<&'k ProblemKey>>,
}

fn deal<'k>(bank: &'k Keys, students: usize, rng: &mut ChaCha20Rng) -> Class<'k> {
    let mut questions = Vec::new();
    let mut keys = Vec::new();
    for (number, drawn) in bank.iter().enumerate() {
        // A shuffle deals the same lots to other people: who has which key is chance, as in a set.
        let mut lots: Vec<&ProblemKey> = drawn.iter().collect();
        for i in (1..lots.len()).rev() {
            lots.swap(i, rng.random_range(0..=i as u32) as usize);
        }
        for part in 0..lots[0].parts.len() {
            let value = |key: &&ProblemKey| match key.parts[part].answer {
                Answer::Number { value, .. } => value,
                Answer::Word { .. } => f64::NAN,
            };
            let all: Vec<f64> = lots.iter().map(value).collect();
            let (class, further) = all.split_at(students);
            questions.push(AnswerColumn { problem: number, keys: class.to_vec(), draws: further.to_vec() });
        }
        lots.truncate(students);
        keys.push(lots);
    }
    Class { questions, keys }
}

/// Rounded to so many figures, with half a unit of the last.
fn given(value: f64, figures: usize) -> (f64, f64) {
    let text = format!("{value:.*e}", figures - 1);
    let exponent: i32 = text.split_once('e').expect("an exponent").1.parse().expect("digits");
    let rounded: f64 = text.parse().expect("a number");
    let unit: f64 = format!("1e{}", exponent - figures as i32 + 1).parse().expect("a number");
    (rounded, unit / 2.0)
}

/// A wrong answer of an honest student, from the own key and the own wrong methods alone. Of what other grading would
/// explain nothing is told: the hardest case.
fn honest(class: &Class, student: usize, question: usize, rng: &mut ChaCha20Rng) -> Option<WrongAnswer> {
    let first = class.questions.iter().position(|q| q.problem == class.questions[question].problem)?;
    let entry = &class.keys[class.questions[question].problem][student].parts[question - first];
    let Answer::Number { value: key, half_width, .. } = entry.answer else { return None };
    let any = |rng: &mut ChaCha20Rng| rng.random_range(500_000..2_000_000u32);
    let value = match rng.random_range(0..4u32) {
        0 => key * f64::from(any(rng)) / 1e6,
        1 => {
            let n = entry.wrong.len() as u32;
            if n == 0 { 2.0 * key } else { entry.wrong[rng.random_range(0..n) as usize].value }
        }
        2 => key * [0.5, 2.0, 1.7, 9.81, 0.866_025_4][rng.random_range(0..5u32) as usize],
        _ => {
            // Two figures in the wrong order.
            let text = format!("{key:.3e}").replace('-', "");
            let digits: Vec<char> = text.chars().collect();
            let swapped = format!("{}.{}{}", digits[2], digits[0], digits.get(3).unwrap_or(&'0'));
            swapped.parse::<f64>().unwrap_or(1.0)
        }
    };
    let (value, half) = given(value, rng.random_range(3..=5u32) as usize);
    let wrong = value != 0.0 && value.is_finite() && (value - key).abs() > half_width;
    wrong.then(|| WrongAnswer { student, question, value, half, explained: String::new() })
}

#[test]
fn honest_classes_are_not_flagged() {
    let mut rng = ChaCha20Rng::seed_from_u64(1);
    let (mut answers, mut classes, mut listed, mut flagged, mut hits) = (0, 0, 0, 0, 0);
    while answers < 100_000 {
        for (_, bank) in BANKS.iter() {
            let class = deal(bank, [30, 60, 100][classes % 3], &mut rng);
            let mut wrong = Vec::new();
            for student in 0..class.keys[0].len() {
                for question in 0..class.questions.len() {
                    if rng.random_range(0..3u32) == 0 {
                        wrong.extend(honest(&class, student, question, &mut rng));
                    }
                }
            }
            let found = matches::find(&class.questions, &wrong);
            classes += 1;
            answers += found.answers;
            listed += found.pairs.len();
            flagged += found.pairs.iter().filter(|p| p.flagged).count();
            hits += found.pairs.iter().map(|p| p.hits.len()).sum::<usize>();
        }
    }
    println!(
        "{answers} wrong answers in {classes} honest classes: {flagged} pairs flagged, {listed} listed ({hits} hits); by luck {:.1} and {classes}",
        matches::FLAGGED * classes as f64
    );
    // A pair is listed where luck brings fewer than one: so at most about one for each class, and not none at all.
    assert!(listed <= classes + 3 * classes.isqrt(), "{listed} listed in {classes} classes");
    assert!(listed * 20 >= classes, "the chances are far too large: {listed} listed in {classes} classes");
    // One class in a hundred: the chance of more than 4 where 0.5 are expected is below 1 in 5000.
    assert!(flagged <= 4, "{flagged} flagged in {classes} classes");
}

/// Share of copyists that are flagged: each copies the key of one classmate in so many problems, one part of each.
fn seen(students: usize, problems: usize, figures: usize, rng: &mut ChaCha20Rng) -> (usize, usize) {
    let (mut tried, mut flagged) = (0, 0);
    for _ in 0..4 {
        for (_, bank) in BANKS.iter().filter(|(_, b)| b.len() >= problems) {
            let class = deal(bank, students, rng);
            let mut wrong = Vec::new();
            for student in 0..students {
                for question in 0..class.questions.len() {
                    if rng.random_range(0..4u32) == 0 {
                        wrong.extend(honest(&class, student, question, rng));
                    }
                }
            }
            let copyists: Vec<(usize, usize)> = (0..students / 10).map(|i| (i, students - 1 - i)).collect();
            for (student, classmate) in &copyists {
                for problem in 0..problems {
                    let of = |q: &AnswerColumn| q.problem == problem && q.keys.iter().all(|k| k.is_finite());
                    // Keys that depend on few data are those of several students, and prove less.
                    let distinct = |i: &usize| {
                        let keys = class.questions[*i].keys.iter().map(|k| k.to_bits());
                        keys.collect::<std::collections::BTreeSet<_>>().len()
                    };
                    let parts = (0..class.questions.len()).filter(|i| of(&class.questions[*i]));
                    let Some(question) = parts.max_by_key(distinct) else { continue };
                    wrong.retain(|w| (w.student, w.question) != (*student, question));
                    let (value, half) = given(class.questions[question].keys[*classmate], figures);
                    wrong.push(WrongAnswer {
                        student: *student,
                        question,
                        value,
                        half,
                        explained: String::new(),
                    });
                }
            }
            let found = matches::find(&class.questions, &wrong);
            tried += copyists.len();
            flagged += copyists
                .iter()
                .filter(|c| found.pairs.iter().any(|p| p.flagged && (p.student, p.classmate) == **c))
                .count();
        }
    }
    (flagged, tried)
}

#[test]
fn copying_in_several_problems_is_seen() {
    let mut rng = ChaCha20Rng::seed_from_u64(2);
    let mut share = |students, problems, figures| {
        let (flagged, tried) = seen(students, problems, figures, &mut rng);
        println!(
            "{students} students, {problems} problems copied to {figures} figures: {flagged} of {tried} seen"
        );
        flagged as f64 / tried as f64
    };
    // One answer to three figures proves nothing among 100: it must not be flagged as if it did.
    assert!(share(100, 1, 3) < 0.2);
    share(100, 1, 5);
    share(100, 2, 3);
    assert!(share(30, 2, 4) > 0.8);
    assert!(share(100, 2, 4) > 0.6);
    assert!(share(100, 3, 3) > 0.7);
    assert!(share(100, 3, 4) > 0.95);
}
