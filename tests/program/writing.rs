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
            // Beside the quantities stand the values that the problem writes as expressions, each by the name of its question.
            let written =
                |n: &String| Quantity::from_name(n).is_none() && problem.questions.iter().any(|q| q.id == *n);
            let every: BTreeSet<String> = all
                .iter()
                .map(|q| name(q).rsplit('.').next().unwrap().to_owned())
                .filter(|n| !written(n))
                .collect();
            assert_eq!(every, Quantity::ALL.iter().map(|q| q.name().to_owned()).collect());
            for seed in ["1", "2"] {
                let (_, out, _) = run(&["solve", bank, &problem.id, "--seed", seed, "--json"]);
                let json: serde_json::Value = serde_json::from_str(&out).unwrap();
                for quantity in json["quantities"].as_object().unwrap().keys() {
                    // What only slips where a contact is left open is there in some draws, and cannot be asked.
                    let slips = !problem.cases[0].touches.is_empty() && json["regime"] != "rolls";
                    assert!(names.contains(quantity) || slips, "{}: {quantity} is not listed", problem.id);
                    named.insert(quantity.clone());
                    solved += 1;
                }
            }
            let (exit, table, _) = run(&["quantities", bank, &problem.id]);
            assert_eq!(exit, Exit::Fine);
            for q in &may {
                let row = table.lines().find(|l| l.split_whitespace().next() == q["name"].as_str()).unwrap();
                assert!(row.contains(q["meaning"].as_str().unwrap()), "{row}");
                // A value that is written says by its expression how it counts.
                let sign = if written(&name(q)) { "" } else { q["sign"].as_str().unwrap() };
                assert!(row.trim_end().ends_with(sign), "{row}");
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

/// A bank of one problem needs no name for it, one of several says which there are; a seed is explained where it is missing or none.
#[test]
fn what_is_missing_on_the_command_line_is_told_with_an_example() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let (bank, roster, set) = (path("bank.yaml"), path("roster.csv"), path("set"));
    std::fs::write(&bank, run(&["new", "rolling-down"]).1).unwrap();
    std::fs::write(&roster, "student\n0017\n").unwrap();
    assert_eq!(run(&["quantities", &bank]), run(&["quantities", &bank, "rolling-down"]));
    let (exit, _, err) = run(&["quantities", "slip-and-roll"]);
    assert!(exit == Exit::Faulty && err.contains("thrown-ball, wheel-set-down"), "{err}");
    let generate = ["generate", &bank, "--roster", &roster, "--out", &set];
    for seed in [&[][..], &["--seed"], &["--seed", "x"], &["--seed", "-5"], &["--seed", "2.5"]] {
        let (exit, _, err) = run(&[&generate[..], seed].concat());
        assert!(exit == Exit::Faulty && err.contains("such as --seed 2026"), "{seed:?}: {err}");
    }
    let (exit, _, err) = run(&["solve", &bank, "--seed", "1", "--set", "m=2kg"]);
    assert!(exit == Exit::Faulty && err.contains("write one of the two"), "{err}");
    let site = [&generate[..], &["--seed", "1", "--page", "site"]].concat();
    let (exit, told, err) = run(&site);
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(told.contains("as a whole, on a web server") && !told.contains("nothing else"), "{told}");
    let index = std::fs::read_to_string(room.path().join("set/index.html")).unwrap();
    assert!(index.contains("Put the folder students/ as a whole on a web server"), "{index}");
    // The page of a sheet, or its folder, in the place of the file that answers are checked by.
    let sheet = path("set/students/0017/sheet.json");
    for given in ["set/students/0017", "set/students/0017/sheet.html", "set/students/0017/sheet.md"] {
        let (exit, _, err) = run(&["check", &path(given), "1.v=3"]);
        assert!(exit == Exit::Faulty && err.contains(&format!("give {sheet}")), "{err}");
    }
    let (exit, _, err) = run(&["check", &sheet]);
    assert!(exit == Exit::Faulty && err.contains("1.omega="), "{err}");
}

/// One fault of a bank is one finding, with the names that would do.
#[test]
fn one_fault_is_one_finding() {
    let bank = run(&["new", "rolling-down"]).1;
    for (from, to, told) in [
        ("      a: {ask", "      acc: {ask", "quantities of this scene: "),
        ("      v: {ask", "      speed: {ask", "quantities of this scene: "),
        ("v: sqrt(2*a*d)", "a: v/t", "`a` is asked first"),
        ("rolls: {body: body", "rols: {body: body", "did you mean `rolls`?"),
        ("slope: theta", "slope: tetha", "symbols: m, R, theta"),
        ("{{ mu_s }}", "{{ mus }}", "did you mean `mu_s`?"),
    ] {
        assert!(bank.contains(from), "{from}");
        let faults = load::scenes_only(&bank.replacen(from, to, 1), "bank.yaml").err();
        let template = slipstick::template::variables_of;
        let faults = faults.or_else(|| load::bank(&bank.replacen(from, to, 1), "bank.yaml", &template).err());
        let faults: Vec<String> = faults.unwrap().iter().map(ToString::to_string).collect();
        assert!(faults.len() == 1 && faults[0].contains(told), "{to}: {}", faults.join("\n"));
    }
}

/// A problem that no draw meets has no empty tables and no chance of equal sheets.
#[test]
fn what_cannot_be_drawn_is_said_and_not_tabled() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let (bank, page) = (path("bank.yaml"), path("gallery.html"));
    let text = run(&["new", "rolling-down"])
        .1
        .replace("draw: 0.40 to 0.80 step 0.05", "draw: 0.01 to 0.02 step 0.01");
    std::fs::write(&bank, text).unwrap();
    let (exit, out, err) = run(&["lint", &bank, "--seeds", "5"]);
    assert!(exit == Exit::Faulty && err.contains("no_slip: margin"), "{err}");
    assert!(!out.contains("question") && !out.contains("Chance"), "{out}");
    assert_eq!(run(&["gallery", &bank, "--out", &page, "--seeds", "5"]).0, Exit::Faulty);
    let page = std::fs::read_to_string(&page).unwrap();
    assert!(page.contains("No variant can be drawn") && !page.contains("<table>"), "{page}");
    let fine = run(&["lint", "slip-and-roll", "--seeds", "5"]).1;
    assert!(fine.contains("get equal sheets of all 2 problems: at most "), "{fine}");
}
