//! What helps to write a bank: scenes to begin with, the quantities of a problem, constants solved without a seed.
use slipstick::bank::built_in::{BUILT_IN, SCENES};
use slipstick::bank::load;
use slipstick::cli;
use slipstick::cli::tell::{Exit, Io};
use slipstick::scene::Quantity;
use std::collections::BTreeSet;
use std::ffi::OsString;

fn run(args: &[&str]) -> (Exit, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
    let mut io = Io { input: &mut &b""[..], out: &mut out, err: &mut err, watched: false, typed: false };
    let exit = cli::run(words, &mut io);
    (exit, String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

#[test]
fn each_scene_is_a_bank_that_lints_clean() {
    let folder = tempfile::tempdir().unwrap();
    let (exit, list, err) = run(&["new"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    assert!(SCENES.len() >= 12);
    for (name, text) in SCENES {
        let (exit, out, err) = run(&["new", name]);
        assert_eq!((exit, out.as_str(), err.as_str()), (Exit::Fine, *text, ""));
        let about = text.lines().next().unwrap().trim_start_matches("# ");
        assert!(list.contains(name) && list.contains(about), "{name} in\n{list}");
        assert!(text.matches('#').count() >= 5, "{name} has comments");
        let file = folder.path().join(format!("{name}.yaml")).display().to_string();
        std::fs::write(&file, text).unwrap();
        let (exit, out, err) = run(&["lint", &file, "--seeds", "60"]);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""), "{name}");
        assert!(!out.contains("note:"), "{name}: {out}");
        let bank = load::scenes_only(text, name).unwrap();
        assert_eq!(bank.problems[0].id, *name);
        // Most draws are accepted, so that it is a fair begin.
        let accepted = out.lines().filter(|l| l.trim_start().starts_with("(all)"));
        for line in accepted {
            let share = line.split_whitespace().rev().nth(3).unwrap();
            assert!(share.parse::<f64>().unwrap() >= 20.0, "{name}: {line}");
        }
    }
    let (exit, _, err) = run(&["new", "yoyo"]);
    assert!(exit == Exit::Faulty && err.contains("did you mean `yo-yo`?"), "{err}");
}

#[test]
fn what_is_solved_may_be_asked_and_nothing_else() {
    let (mut named, mut solved) = (BTreeSet::new(), 0);
    for (bank, ..) in BUILT_IN {
        let (_, text) = BUILT_IN.iter().map(|(id, _, text)| (id, text)).find(|(id, _)| *id == bank).unwrap();
        for problem in load::scenes_only(text, bank).unwrap().problems {
            let (exit, out, err) = run(&["quantities", bank, &problem.id, "--json"]);
            assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
            let json: serde_json::Value = serde_json::from_str(&out).unwrap();
            let all = json["quantities"].as_array().unwrap();
            let may: Vec<&serde_json::Value> = all.iter().filter(|q| q["may_be_asked"] == true).collect();
            let name = |q: &serde_json::Value| q["name"].as_str().unwrap().to_owned();
            let names: BTreeSet<String> = may.iter().map(|q| name(q)).collect();
            let asked: BTreeSet<String> = may
                .iter()
                .flat_map(|q| q["asked_as"].as_array().unwrap())
                .map(|id| id.as_str().unwrap().to_owned())
                .collect();
            assert_eq!(asked, problem.questions.iter().map(|q| q.id.clone()).collect(), "{}", problem.id);
            for q in all.iter().filter(|q| q["may_be_asked"] == false) {
                assert!(!q["why"].as_str().unwrap().is_empty());
                assert!(names.iter().all(|n| n.rsplit('.').next() != q["name"].as_str()));
            }
            let every: BTreeSet<String> =
                all.iter().map(|q| name(q).rsplit('.').next().unwrap().to_owned()).collect();
            assert_eq!(every, Quantity::ALL.iter().map(|q| q.name().to_owned()).collect());
            for seed in ["1", "2"] {
                let (_, out, _) = run(&["solve", bank, &problem.id, "--seed", seed, "--json"]);
                let json: serde_json::Value = serde_json::from_str(&out).unwrap();
                for quantity in json["quantities"].as_object().unwrap().keys() {
                    assert!(names.contains(quantity), "{}: {quantity} is not listed", problem.id);
                    named.insert(quantity.clone());
                    solved += 1;
                }
            }
            let (exit, table, _) = run(&["quantities", bank, &problem.id]);
            assert_eq!(exit, Exit::Fine);
            for q in &may {
                let row = table.lines().find(|l| l.split_whitespace().next() == q["name"].as_str()).unwrap();
                assert!(row.contains(q["meaning"].as_str().unwrap()), "{row}");
                assert!(row.trim_end().ends_with(q["sign"].as_str().unwrap()), "{row}");
            }
        }
    }
    assert!(named.len() > 30 && solved > 200, "{} names, {solved} values", named.len());
    let (exit, _, err) = run(&["quantities", "slip-and-roll", "thrown-bal"]);
    assert!(exit == Exit::Faulty && err.contains("did you mean `thrown-ball`?"), "{err}");
}

#[test]
fn constants_need_no_seed_and_json_has_the_questions_in_their_units() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("b.yaml").display().to_string();
    let text = SCENES.iter().find(|(name, _)| *name == "yo-yo").unwrap().1;
    let constant = text
        .replace("draw: 60 to 300 step 1", "draw: always 200")
        .replace("draw: 15.0 to 30.0 step 0.5", "draw: always 20.0")
        .replace("draw: 3.0 to 12.0 step 0.5", "draw: always 10.0")
        .replace("draw: 0.50 to 1.50 step 0.01", "draw: always 1.00")
        .replace("fallen this far', unit: m/s", "fallen this far', unit: km/h");
    std::fs::write(&file, &constant).unwrap();
    let (exit, out, err) = run(&["solve", &file, "yo-yo", "--json"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    // a = g / (1 + k^2/r^2) = g / 5.
    let near =
        |value: &serde_json::Value, right: f64| (value.as_f64().unwrap() - right).abs() < 1e-12 * right;
    let questions = &json["questions"];
    let speed = 3.6 * (2.0 * 9.81 / 5.0_f64).sqrt();
    assert!(near(&questions["a"]["value"], 9.81 / 5.0), "{questions}");
    assert!(near(&questions["v"]["value"], speed), "{questions}");
    assert_eq!(
        (questions["v"]["unit"].as_str(), questions["v"]["quantity"].as_str()),
        (Some("km/h"), Some("v"))
    );
    assert!(near(&questions["tension"]["value"], 0.2 * 9.81 * 0.8), "{questions}");
    assert!(near(&json["quantities"]["v"]["value"], speed / 3.6));
    let (_, seeded, _) = run(&["solve", &file, "yo-yo", "--seed", "9", "--json"]);
    assert_eq!(seeded, out);
    // What breaks a rule is told as with data that are given.
    std::fs::write(&file, constant.replace("[moves_down]", "[moves_up]")).unwrap();
    let (exit, out, _) = run(&["solve", &file, "yo-yo"]);
    assert!(exit == Exit::RegimeFails && out.contains("not what the problem declares"), "{out}");
    // A word is a word, and data that are drawn still need one.
    let (exit, _, err) = run(&["solve", "wheels-on-inclines", "spring-released"]);
    assert!(exit == Exit::Faulty && err.contains("no data are given"), "{err}");
    let (_, out, _) = run(&["solve", "wheels-on-inclines", "spring-released", "--seed", "5", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    let direction = &json["questions"]["direction"];
    assert!(
        matches!(direction["value"].as_str(), Some("up" | "down")) && direction["unit"] == "",
        "{direction}"
    );
}
