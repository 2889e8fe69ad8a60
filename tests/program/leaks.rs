//! Nothing that a student gets tells an answer in words: no file below students/, no range of a datum, no list of words.
//!
//! Earlier tests looked at what one sheet holds (no key, no value of it). A word leaks across sheets: what stands in those with one
//! answer and never in those with another, which no test of a single sheet can see.
use crate::support;
use crate::support::program::{self, Room};
use rayon::prelude::*;
use rustc_hash::FxBuildHasher;
use slipstick::bank::{Bank, Problem, load};
use slipstick::cli::tell::Exit;
use slipstick::problem::make_key;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::scene::Label;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::hash::BuildHasher;
use std::path::Path;
use std::sync::LazyLock;

/// A wheel on a contact that does not say whether it rolls or slips, and a statement that does not either.
const OPEN: &str = "
bank: left-open
title: Left open
problems:
  pulled:
    title: A wheel is pulled
    data:
      m: {name: mass of the wheel, unit: kg, draw: 20 to 40 step 1}
      P: {name: pull of the cord, unit: N, draw: 80 to 300 step 5}
      theta: {name: slope of the incline, unit: deg, draw: 10 to 16 step 1}
      d: {name: distance that the centre moves, unit: m, draw: 1.0 to 3.0 step 0.1}
      mu_s: {name: coefficient of static friction, unit: '1', draw: 0.20 to 0.60 step 0.05}
      mu_k: {name: coefficient of kinetic friction, unit: '1', draw: 0.10 to 0.19 step 0.01}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies: {wheel: {mass: m, radius of gyration: 0.2 m, radii: {rim: 0.4 m, hub: 0.2 m}, moves: along incline}}
      ties:
        - touches: {body: wheel, on its: hub, mu_s: mu_s, mu_k: mu_k}
        - cord: {from: {body: wheel, wound on: rim, leaves: top forward}, pulled with: P}
      start: at rest
      end: {travel: {of: wheel, by: d, heading: up}}
    questions:
      rolls: {ask: whether the wheel rolls without slipping}
      friction: {ask: 'the friction force on it, with its direction', unit: N}
      v: {ask: its speed at that moment, unit: m/s}
    statement: |
      A wheel of mass {{ m }} stands on an incline of {{ theta }} on its hub; the coefficients of friction are {{ mu_s }} (static) and {{ mu_k }} (kinetic). It
      starts from rest, pulled by a cord on its rim, up the incline, with {{ P }}. Its centre moves {{ d }}; whether it rolls or slips is for you to find. Use {{ g }}.
";

fn banks() -> Vec<(Bank, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("banks");
    let mut all: Vec<(Bank, String)> = support::banks()
        .into_iter()
        .map(|b| (folder.join(format!("{}.yaml", b.id)), b))
        .map(|(p, b)| (b, fs::read_to_string(p).unwrap()))
        .collect();
    all.push((load::scenes_only(OPEN, "open.yaml").unwrap_or_else(|f| panic!("{f:?}")), OPEN.to_owned()));
    all
}

/// Which of its questions a problem asks in words.
fn in_words(problem: &Problem) -> Vec<usize> {
    let asked = problem.questions.iter().enumerate().filter(|(_, q)| q.label.quantity.is_word());
    asked.map(|(i, _)| i).collect()
}

/// A problem with questions in words: its bank, which questions, and what a thousand seeds draw.
struct Asked {
    bank: String,
    problem: Problem,
    questions: Vec<usize>,
    drawn: Vec<Variant>,
}

impl Asked {
    /// The quantity of each question.
    fn labels(&self) -> impl Iterator<Item = Label> {
        self.questions.iter().map(|q| self.problem.questions[*q].label)
    }
}

static ASKED: LazyLock<Vec<Asked>> = LazyLock::new(|| {
    let problems =
        banks().into_iter().flat_map(|(b, _)| b.problems.into_iter().map(move |p| (b.id.clone(), p)));
    let asked =
        problems.map(|(bank, problem)| (bank, in_words(&problem), problem)).filter(|(_, q, _)| !q.is_empty());
    asked
        .map(|(bank, questions, problem)| Asked { bank, drawn: variants(&problem, 1000), questions, problem })
        .collect()
});

fn variants(problem: &Problem, count: u64) -> Vec<Variant> {
    let one = |seed| Maker::new(problem, seed, "leaks").variant("s").unwrap_or_else(|e| panic!("{e}"));
    (1..=count).into_par_iter().map(one).collect()
}

/// A set of this one problem with a sheet in every format for each of so many students: the answers of each to these questions, and
/// what stands in the files.
fn sheets(
    text: &str,
    problem: &Problem,
    questions: &[usize],
    language: &str,
    formats: &str,
) -> Vec<(Vec<String>, BTreeSet<String>)> {
    let students = support::seeds(200).max(50);
    let room = Room::empty();
    room.write("bank.yaml", text);
    let rows: String = (0..students).map(|i| format!("s{i:03}\n")).collect();
    room.write("roster.csv", &format!("student\n{rows}"));
    let args = ["--seed", "5", "--name", "leaks", "--problems", &problem.id, "--format", formats];
    let [bank, roster, set] = ["bank.yaml", "roster.csv", "set"].map(|name| room.path(name));
    let more = ["--language", language, "--out", &set];
    let ran = program::run(&[&["generate", &bank, "--roster", &roster], &args[..], &more].concat());
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let key = room.read("set/key.csv");
    let of_student = |i: u32| {
        let answer = |question: &usize| {
            let start = format!("s{i:03},1,{},", problem.questions[*question].id);
            let row = key.lines().find(|l| l.starts_with(&start)).unwrap();
            row.split(',').nth(3).unwrap().to_owned()
        };
        let files = program::tree(Path::new(&room.path(&format!("set/students/s{i:03}"))));
        let files = files.into_iter().map(|(name, bytes)| (name, String::from_utf8(bytes).unwrap()));
        (questions.iter().map(answer).collect(), tokens(&files.collect()))
    };
    (0..students).into_par_iter().map(of_student).collect()
}

/// What stands in a student's files, each token with how often, file by file; numbers only where they are no coordinates of a
/// figure and no values of the data.
fn tokens(files: &BTreeMap<String, String>) -> BTreeSet<String> {
    let sheet: serde_json::Value = serde_json::from_str(&files["sheet.json"]).unwrap();
    let data = sheet["problems"][0]["data"].as_object().unwrap();
    let values: BTreeSet<&str> = data.values().filter_map(|d| d["value"].as_str()).collect();
    let mut found = BTreeSet::new();
    for (file, whole) in files {
        let drawn = !["sheet.json", "sheet.md"].contains(&file.as_str());
        // The program of a page is one token.
        let text = match whole.split_once("id=\"program\"") {
            Some((before, rest)) => {
                let (program, after) = rest.split_once("</script>").expect("the program ends");
                found.insert(format!("{file}: {:x}", FxBuildHasher.hash_one(program)));
                format!("{before}{after}")
            }
            None => whole.clone(),
        };
        let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
        // In what holds a figure a letter stands close to its coordinate (`M250`), so that words are letters alone.
        let is_part =
            |c: char| c == '_' || if drawn { c.is_alphabetic() } else { c.is_alphanumeric() || c == '.' };
        for token in text.split(|c: char| !is_part(c)).map(|t| t.trim_matches('.')).filter(|t| !t.is_empty())
        {
            let number = token.starts_with(|c: char| c.is_ascii_digit());
            if !(number && (drawn || values.contains(token))) {
                *counts.entry(token).or_default() += 1;
            }
        }
        found.insert(format!("file {file}"));
        for (token, n) in counts {
            found.insert(format!("{file}: {token}"));
            found.insert(format!("{file}: {token} {n} times"));
        }
    }
    found
}

/// Tokens that stand, or are missing, with one answer alone, though chance would have put them among the others too.
fn telling(answers: &[&str], tokens: &[BTreeSet<String>]) -> Vec<String> {
    let share = |answer: &str| answers.iter().filter(|a| **a == answer).count() as f64 / answers.len() as f64;
    let mut stands: BTreeMap<&str, Vec<bool>> = BTreeMap::new();
    for (i, tokens) in tokens.iter().enumerate() {
        for token in tokens {
            stands.entry(token).or_insert_with(|| vec![false; answers.len()])[i] = true;
        }
    }
    let mut faults = Vec::new();
    for (token, stands) in stands {
        for there in [true, false] {
            let mut with =
                answers.iter().zip(&stands).filter(|(_, stands)| **stands == there).map(|(a, _)| *a);
            let Some(first) = with.clone().next().filter(|first| with.all(|a| a == *first)) else { continue };
            let sheets = stands.iter().filter(|stands| **stands == there).count();
            // By chance alone it would be rarer than one in a million that so many share an answer.
            if std::iter::repeat_n(share(first), sheets).product::<f64>() < 1e-6 {
                let what = if there { "stands" } else { "is missing" };
                faults.push(format!("`{token}` {what} in {sheets} sheets, all with `{first}`"));
            }
        }
    }
    faults
}

#[test]
fn no_token_of_a_students_files_goes_with_one_answer_in_words_alone() {
    for (bank, text) in banks() {
        for problem in bank.problems.iter().filter(|problem| !in_words(problem).is_empty()) {
            let questions = in_words(problem);
            let (english, german) = (("en", "html,md,tex"), ("de", "md"));
            let languages = if bank.id == "left-open" { vec![english] } else { vec![english, german] };
            for (language, formats) in languages {
                let (answers, tokens): (Vec<_>, Vec<_>) =
                    sheets(&text, problem, &questions, language, formats).into_iter().unzip();
                for of in 0..questions.len() {
                    let answers: Vec<&str> = answers.iter().map(|answers| &*answers[of]).collect();
                    let different: BTreeSet<_> = answers.iter().collect();
                    assert!(different.len() > 1, "{}: a question with one answer", problem.id);
                    let faults = telling(&answers, &tokens);
                    assert!(
                        faults.is_empty(),
                        "{}, {language}: {} leaks\n{}",
                        problem.id,
                        faults.len(),
                        faults[..faults.len().min(20)].join("\n")
                    );
                }
            }
        }
    }
}

/// The test above sees a leak if there is one: the regimes of the case, which sheet.json once carried.
#[test]
fn a_planted_token_is_seen() {
    let sheet = |i: u32| {
        let answer = if i.is_multiple_of(2) { "up" } else { "down" };
        (answer, BTreeSet::from(["the".to_owned(), format!("code {i}"), format!("{answer} ok")]))
    };
    let (answers, tokens): (Vec<_>, Vec<_>) = (0..200).map(sheet).unzip();
    let faults = telling(&answers, &tokens);
    assert_eq!(faults.len(), 4, "{faults:?}");
    assert!(faults.iter().all(|f| f.contains(" ok`")), "{faults:?}");
}

/// A type of its own without regimes, bounds, cases and ranges: the same text for every student of the problem.
#[test]
fn the_scene_of_a_sheet_is_the_same_for_every_student() {
    for (bank, text) in banks() {
        let problems: Vec<usize> = (0..bank.problems.len()).collect();
        let writer = slipstick::sheet::public::Writer::new(&bank, &text, &problems, "leaks", "en").unwrap();
        let drawn: Vec<Vec<Variant>> = bank.problems.iter().map(|p| variants(p, 25)).collect();
        let mut first: Vec<Option<serde_json::Value>> = vec![None; problems.len()];
        for student in 0..25 {
            let of: Vec<Variant> = drawn.iter().map(|v| v[student].clone()).collect();
            let sheet: serde_json::Value = serde_json::from_str(&writer.text("s", &of)).unwrap();
            for (i, problem) in sheet["problems"].as_array().unwrap().iter().enumerate() {
                let scene = problem["scene"].clone();
                let shown = scene.to_string();
                for word in ["regimes", "bounds", "cases", "draw", "unguarded", "margins", "share"] {
                    assert!(!shown.contains(&format!("\"{word}\":")), "{}: {word}", problem["id"]);
                }
                let asked = &scene["problems"][&bank.problems[i].id];
                assert!(asked["scene"].is_object(), "{}", problem["id"]);
                // The wrong methods of all cases, so that none is told by what is missing.
                let listed = asked["mistakes"].as_object().map_or(0, serde_json::Map::len);
                assert_eq!(listed, bank.problems[i].mistakes.len(), "{}", problem["id"]);
                let same = first[i].get_or_insert_with(|| scene.clone());
                assert_eq!(*same, scene, "{} {}", bank.id, problem["id"]);
            }
        }
    }
}

/// A sheet that says so little is enough to check by: what is there and what happens follows from its data.
#[test]
fn a_sheet_is_checked_by_its_neutral_scene_whatever_the_case() {
    let room = tempfile::tempdir().unwrap();
    let file = room.path().join("sheet.json").display().to_string();
    for (bank, text) in banks() {
        for (index, problem) in bank.problems.iter().enumerate() {
            let writer =
                slipstick::sheet::public::Writer::new(&bank, &text, &[index], "leaks", "en").unwrap();
            let mut cases = BTreeSet::new();
            for variant in variants(problem, 16).into_iter().filter(|v| cases.insert(v.case)) {
                fs::write(&file, writer.text("s", std::slice::from_ref(&variant))).unwrap();
                let of = |q: &slipstick::bank::Question| match variant.solved.word(q.label) {
                    Some(word) => format!("1.{}={}", q.id, word.as_str()),
                    None => {
                        let value = variant.solved.get(q.label).unwrap().value();
                        format!("1.{}={:e}", q.id, q.unit.from_si(value))
                    }
                };
                let answers: Vec<String> = problem.questions.iter().map(of).collect();
                let mut args = vec!["check", file.as_str()];
                args.extend(answers.iter().map(String::as_str));
                let (exit, out, err) = run(&args);
                assert_eq!(
                    exit,
                    Exit::Fine,
                    "{} {}\n{out}{err}",
                    problem.id,
                    problem.cases[variant.case].name
                );
            }
        }
    }
}

/// What was drawn for one datum, by answer.
type ByWord = BTreeMap<&'static str, Vec<f64>>;

/// Share of the joint range of the values that two answers have in common; and the share that the best threshold gets right,
/// each answer counted as likely as the other.
fn told_by(a: &[f64], b: &[f64]) -> (f64, f64) {
    let (min, max) = (
        |x: &[f64]| x.iter().copied().fold(f64::INFINITY, f64::min),
        |x: &[f64]| x.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    );
    let (low, high) = (min(a).min(min(b)), max(a).max(max(b)));
    let common = if high > low { (max(a).min(max(b)) - min(a).max(min(b))) / (high - low) } else { 1.0 };
    let below = |x: &[f64], t: f64| x.iter().filter(|v| **v <= t).count() as f64 / x.len() as f64;
    let gap = a.iter().chain(b).map(|t| (below(a, *t) - below(b, *t)).abs()).fold(0.0, f64::max);
    (common, 0.5 + gap / 2.0)
}

/// Least share of the joint range that the answers share, and the most that a threshold may get right.
const COMMON: f64 = 0.5;
const GUESSED: f64 = 0.85;

#[test]
fn no_range_of_a_datum_tells_an_answer_in_words() {
    for (Asked { bank, problem, drawn, .. }, label) in
        ASKED.iter().flat_map(|a| a.labels().map(move |l| (a, l)))
    {
        let word = |v: &Variant| v.solved.word(label).unwrap().as_str();
        let words: BTreeSet<&str> = drawn.iter().map(word).collect();
        // The tolerance of a part is printed too, and may follow how near to each other the terms of its answer are.
        for (i, q) in problem.questions.iter().enumerate().filter(|(_, q)| q.relative.fixed().is_none()) {
            let mut by: ByWord = BTreeMap::new();
            for v in drawn {
                by.entry(word(v)).or_default().push(v.within[i]);
            }
            let values: Vec<&Vec<f64>> = by.values().collect();
            for (n, a) in values.iter().enumerate() {
                for b in &values[n + 1..] {
                    let (_, guessed) = told_by(a, b);
                    println!("{} tolerance of {}: a threshold gets {guessed:.2}", problem.id, q.id);
                    assert!(guessed <= GUESSED, "{} tolerance of {}: {guessed}", problem.id, q.id);
                }
            }
        }
        for (i, datum) in problem.data.iter().enumerate() {
            let mut by: ByWord = BTreeMap::new();
            for v in drawn.iter().filter(|v| v.values[i].is_some()) {
                by.entry(word(v)).or_default().push(v.data[i]);
            }
            // A datum that some variants lack is there with every answer.
            assert_eq!(by.len(), words.len(), "{} {}", problem.id, datum.symbol);
            let values: Vec<(&&str, &Vec<f64>)> = by.iter().collect();
            for (n, (one, a)) in values.iter().enumerate() {
                for (other, b) in &values[n + 1..] {
                    let (common, guessed) = told_by(a, b);
                    let name = format!("{} {}, {one} or {other}", problem.id, datum.symbol);
                    println!("{name}: {common:.2} in common, a threshold gets {guessed:.2}");
                    // Of the open bank of this test only the sheets matter: its ranges are its own.
                    assert!(
                        bank == "left-open" || (common >= COMMON && guessed <= GUESSED),
                        "{name}: {common} {guessed}"
                    );
                }
            }
        }
    }
}

/// Each word of a list that sheets print is right in at least a fifth of the variants that print it, over 1,000 seeds.
#[test]
fn every_word_of_a_printed_list_is_right_often_enough() {
    for (Asked { bank, problem, drawn, .. }, label) in
        ASKED.iter().flat_map(|a| a.labels().map(move |l| (a, l)))
    {
        let mut lists: BTreeMap<&[&str], BTreeMap<&str, u32>> = BTreeMap::new();
        for v in drawn {
            let list = make_key::offered(problem, label.quantity, &problem.cases[v.case].scene);
            *lists.entry(list).or_default().entry(v.solved.word(label).unwrap().as_str()).or_default() += 1;
        }
        for (list, right) in lists {
            let printed: u32 = right.values().sum();
            for word in list {
                let n = right.get(word).copied().unwrap_or(0);
                println!("{bank} {}: `{word}` right in {n} of {printed}", problem.id);
                assert!(f64::from(n) >= 0.2 * f64::from(printed), "{} {word}: {n} of {printed}", problem.id);
            }
        }
    }
}

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

/// An instructor's bank is told of a word that is never right, by `lint` as a finding, by `generate` as a note.
#[test]
fn a_word_that_is_never_right_is_told_to_the_instructor() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    // Friction always suffices here.
    fs::write(
        at("bank.yaml"),
        OPEN.replace("0.20 to 0.60 step 0.05", "0.90 to 0.98 step 0.02")
            .replace("    questions:", "    regimes: [moves_up]\n    questions:"),
    )
    .unwrap();
    fs::write(at("roster.csv"), "student\n1\n").unwrap();
    let (exit, out, err) = run(&["lint", &at("bank.yaml"), "--seeds", "60"]);
    assert_eq!(exit, Exit::Faulty, "{out}");
    assert!(err.contains("`no` is offered and right in none of 60 variants"), "{err}");
    assert!(out.contains("yes 100 %, no 0 %") || out.contains("no 0 %"), "{out}");
    let (exit, out, _) = program::generate(&at("bank.yaml"), &at("roster.csv"), &at("set"), &[]).parts();
    assert_eq!(exit, Exit::Fine);
    assert!(
        out.contains("note: problems.pulled.questions.rolls: `no` is offered and right in none"),
        "{out}"
    );
    // And nothing where the rule holds.
    fs::write(at("open.yaml"), OPEN).unwrap();
    let (exit, out, err) = run(&["lint", &at("open.yaml"), "--seeds", "200"]);
    assert_eq!(exit, Exit::Fine, "{out}{err}");
    let (_, out, _) = program::generate(&at("open.yaml"), &at("roster.csv"), &at("open"), &[]).parts();
    assert!(!out.contains("note:"), "{out}");
}

/// A contact that is left open rolls or slips as the data have it: of both assumptions exactly one holds, whatever the data.
#[test]
fn a_contact_left_open_rolls_or_slips_and_never_both() {
    let bank = load::scenes_only(OPEN, "open.yaml").unwrap();
    let problem = &bank.problems[0];
    let names: Vec<&str> = problem.cases.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["rolls", "slips"]);
    // With hub and radius of gyration half the rim's radius, rolling needs half the pull and the weight's share as friction.
    let mut seen = [0u32; 2];
    for v in variants(problem, 300) {
        let of = |symbol: &str| v.data[problem.data.iter().position(|d| d.symbol == symbol).unwrap()];
        let (sin, cos) = slipstick::num::trig::sin_cos_degrees(of("theta"));
        let (m, weight) = (of("m"), of("m") * of("g"));
        let (along, normal) = (weight * sin.hi, weight * cos.hi);
        let needed = (of("P") + along) / 2.0;
        let rolls = needed <= of("mu_s") * normal;
        let friction = if rolls { needed } else { of("mu_k") * normal };
        let a = (of("P") + friction - along) / m;
        let entry = |name: &str| {
            let q = problem.questions.iter().find(|q| q.id == name).unwrap();
            v.solved.get(q.label).unwrap().value()
        };
        assert_eq!(
            v.solved.word(problem.questions[0].label).unwrap().as_str(),
            if rolls { "yes" } else { "no" }
        );
        assert!((entry("friction") - friction).abs() <= 1e-9 * needed, "{} {friction}", entry("friction"));
        assert!((entry("v") - (2.0 * a * of("d")).sqrt()).abs() <= 1e-9 * entry("v"));
        seen[usize::from(rolls)] += 1;
        // Whichever was assumed first, the other assumption fails on the same data.
        let hold: Vec<bool> = (0..2)
            .map(|case| {
                slipstick::problem::maker::from_values(problem, case, &v.values)
                    .is_ok_and(|v| v.solved.all_hold() && !v.solved.regime.slips)
            })
            .collect();
        assert_eq!(hold, [rolls, !rolls]);
    }
    assert!(seen.iter().all(|n| *n > 90), "{seen:?}");
}

/// `solve` and `check` find what happens; the sheet does not say it.
#[test]
fn solve_and_check_find_what_an_open_contact_does() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    fs::write(at("bank.yaml"), OPEN).unwrap();
    for (pull, regime) in [("80N", "moves_up"), ("300N", "slips_up")] {
        let args = ["m=25kg", &format!("P={pull}"), "d=2m", "mu_s=0.5", "mu_k=0.12", "theta=12"]
            .map(|a| format!("--set={a}"));
        let all: Vec<&str> = ["solve", &at("bank.yaml"), "pulled"]
            .into_iter()
            .map(|s| Box::leak(s.to_owned().into_boxed_str()) as &str)
            .chain(args.iter().map(String::as_str))
            .collect();
        let (exit, out, err) = run(&all);
        assert_eq!(exit, Exit::Fine, "{out}{err}");
        assert!(out.contains(&format!("regime: {regime}")), "{out}");
    }
    let rows: String = (0..12).map(|i| format!("s{i}\n")).collect();
    fs::write(at("roster.csv"), format!("student\n{rows}")).unwrap();
    assert_eq!(program::generate(&at("bank.yaml"), &at("roster.csv"), &at("set"), &[]).exit, Exit::Fine);
    let key = fs::read_to_string(at("set/key.csv")).unwrap();
    let mut words = BTreeSet::new();
    for i in 0..12 {
        let cell = |part: &str| {
            key.lines()
                .find(|l| l.starts_with(&format!("s{i},1,{part},")))
                .unwrap()
                .split(',')
                .nth(3)
                .unwrap()
                .to_owned()
        };
        words.insert(cell("rolls"));
        let sheet = at(&format!("set/students/s{i}/sheet.json"));
        let answers = [
            format!("1.rolls={}", cell("rolls")),
            format!("1.friction={} N", cell("friction")),
            format!("1.v={}", cell("v")),
        ];
        let (exit, out, err) = run(&["check", &sheet, &answers[0], &answers[1], &answers[2]]);
        assert_eq!(exit, Exit::Fine, "{out}{err}");
    }
    assert_eq!(words.len(), 2);
    assert_eq!(run(&["solutions", &at("set"), "--out", &at("solved")]).0, Exit::Fine);
}

/// A block that stays or slides, by its data.
const STAYS: &str = "
bank: may-stay
title: May stay
problems:
  block:
    title: A block is let go
    data:
      m: {name: mass of the block, unit: kg, draw: 1 to 9 step 0.5}
      theta: {name: slope of the incline, unit: deg, draw: 10 to 45 step 1}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies: {block: {mass: m, moves: along incline}}
      ties: [slides: {body: block, mu_k: 0.5}]
      start: at rest
      end: {travel: {of: block, by: 1 m}}
    regimes: [balanced, moves_down]
    questions:
      direction: {ask: which way the block goes}
    statement: 'A block of mass {{ m }} lies on an incline of {{ theta }}, the coefficient of friction is 0.5; use {{ g }}.'
";

/// The list on a sheet is that of the words which the declared regimes can have: what is drawn at rest is answered by a word on it.
///
/// The earlier tests counted over the words of a list, and every list was a pair: a right answer that stands on none was not
/// counted anywhere.
#[test]
fn the_words_on_a_sheet_follow_from_the_declared_regimes() {
    let lists = |bank: &str| {
        let bank = load::scenes_only(bank, "bank.yaml").unwrap_or_else(|f| panic!("{f:?}"));
        let problem = &bank.problems[0];
        let quantity = problem.questions[0].label.quantity;
        let of = |c: &slipstick::bank::Case| make_key::offered(problem, quantity, &c.scene);
        problem.cases.iter().map(of).collect::<Vec<_>>()
    };
    for (regimes, list) in [
        ("balanced, moves_down", &["down", "stays"][..]),
        ("moves_up, balanced", &["up", "stays"]),
        ("moves_up, balanced, moves_down", &["up", "down", "stays"]),
        ("moves_up, moves_down", &["up", "down"]),
        // One word would tell the answer. A block without a spring never has the regime `rest`.
        ("moves_down", &["up", "down"]),
        ("moves_down, rest", &["up", "down"]),
        ("balanced", &["up", "down", "stays"]),
    ] {
        assert_eq!(lists(&STAYS.replace("balanced, moves_down", regimes)), [list], "{regimes}");
    }
    let level =
        STAYS.replace("{slope: theta}", "level").replace("balanced, moves_down", "balanced, moves_forward");
    let level =
        level.replace("      theta: {name: slope of the incline, unit: deg, draw: 10 to 45 step 1}\n", "");
    assert_eq!(lists(&level), [["forward", "stays"]]);
    // A case of its own for each answer prints the same list: else it would tell.
    let cases = STAYS.replace("    regimes: [balanced, moves_down]\n", "").replace(
        "    questions:",
        "    cases:\n      holds: {regimes: [balanced]}\n      slides: {regimes: [moves_down]}\n    questions:",
    );
    assert_eq!(lists(&cases), [["down", "stays"]; 2]);

    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    fs::write(at("bank.yaml"), STAYS).unwrap();
    fs::write(at("roster.csv"), "student\n1\n2\n3\n4\n5\n6\n7\n8\n").unwrap();
    let (exit, out, err) = run(&["lint", &at("bank.yaml"), "--seeds", "60"]);
    assert_eq!(exit, Exit::Fine, "{out}{err}");
    assert!(out.contains("down ") && out.contains("stays ") && !out.contains("up 0 %"), "{out}");
    for (language, list) in [("en", "`down` or `stays`"), ("de", "`abwärts` oder `ruht`")] {
        let (bank, roster, set) = (at("bank.yaml"), at("roster.csv"), at(language));
        let (exit, out, err) = program::generate(&bank, &roster, &set, &["--language", language]).parts();
        assert_eq!(exit, Exit::Fine, "{out}{err}");
        assert!(!out.contains("note: problems"), "{out}");
        let key = fs::read_to_string(format!("{set}/key.csv")).unwrap();
        assert!(key.contains("stays") && key.contains("down"), "{key}");
        let plain = |html: String| html.replace("<code>", "`").replace("</code>", "`");
        let sheet = plain(fs::read_to_string(format!("{set}/students/1/sheet.html")).unwrap());
        assert!(sheet.contains(list), "{sheet}");
        // The key is right by the sheet's own words, and no student is told that it is not offered.
        let answers: String = key
            .lines()
            .filter_map(|l| l.split_once(','))
            .filter(|(s, _)| s.parse::<u32>().is_ok())
            .map(|(s, rest)| format!("{s},{}\n", if rest.contains("stays") { "stays" } else { "down" }))
            .collect();
        fs::write(at("answers.csv"), format!("student,1.direction\n{answers}")).unwrap();
        let graded = at(&format!("graded-{language}"));
        let (exit, out, err) = run(&["grade", &set, &at("answers.csv"), "--out", &graded]);
        assert_eq!(exit, Exit::Fine, "{out}{err}");
        assert!(!out.contains("not offered"), "{out}");
        let grades = fs::read_to_string(format!("{graded}/answers.csv")).unwrap();
        assert_eq!(grades.matches(",right,").count(), 8, "{grades}");
        let (_, out, _) = run(&["check", &format!("{set}/students/1/sheet.json"), "1.direction=up"]);
        assert!(out.contains("down, stays") || out.contains("abwärts, ruht"), "{out}");
    }
}
