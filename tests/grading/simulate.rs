//! `slipstick simulate`: the same bytes for the same seed, a truth for every row, faults of the habits all at once, and what grading
//! then says is what the truth says.
use crate::support::program::{self, Room};
use slipstick::cli::tell::Exit;
use slipstick::simulate::habits::EXAMPLE;
use slipstick::simulate::truth::{HEADER, TrueKind as Kind};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::sync::OnceLock;
use tempfile::TempDir;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

impl Room {
    /// Hands in with these habits; the two files are `NAME.csv` and `NAME-truth.csv`.
    fn simulate(&self, habits: Option<&str>, name: &str, more: &[&str]) -> (Exit, String, String) {
        let (out, truth) = (self.path(&format!("{name}.csv")), self.path(&format!("{name}-truth.csv")));
        let like = self.path(&format!("{name}.yaml"));
        let mut args = vec!["simulate", set(), "--out", &out, "--truth", &truth];
        if let Some(habits) = habits {
            fs::write(&like, habits).unwrap();
            args.extend(["--like", &like]);
        }
        args.extend(more);
        let (exit, out, err) = run(&args);
        (exit, out.replace(&self.path(""), "ROOM/"), err.replace(&self.path(""), "ROOM/"))
    }
    fn rows(&self, name: &str) -> Vec<BTreeMap<String, String>> {
        let mut reader = csv::Reader::from_path(self.path(name)).unwrap();
        let header = reader.headers().unwrap().clone();
        let row = |r: csv::StringRecord| {
            header.iter().map(str::to_owned).zip(r.iter().map(str::to_owned)).collect()
        };
        reader.records().map(|r| row(r.unwrap())).collect()
    }
}

/// A set of sixteen students and three problems, made once.
fn set() -> &'static str {
    static SET: OnceLock<(TempDir, String)> = OnceLock::new();
    let (_, set) = SET.get_or_init(|| {
        let room = tempfile::tempdir().unwrap();
        let (roster, set) = (room.path().join("roster.csv"), room.path().join("set"));
        let rows: String = (1..=16).map(|i| format!("{i:03}\n")).collect();
        fs::write(&roster, format!("student\n{rows}")).unwrap();
        let (roster, set) = (roster.display().to_string(), set.display().to_string());
        let problems = ["--problems", "pulled-rolling,pulled-slipping,spring-released", "--format", "md"];
        let mut args =
            vec!["generate", "wheels-on-inclines", "--roster", &roster, "--seed", "7", "--out", &set];
        args.extend(problems);
        let (exit, _, err) = run(&args);
        assert_eq!(exit, Exit::Fine, "{err}");
        (room, set)
    });
    set
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let room = Room::empty();
    for (name, seed) in [("a", "3"), ("b", "3"), ("c", "4")] {
        let (exit, out, err) = room.simulate(None, name, &["--seed", seed]);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
        assert!(
            out.contains(&format!("with seed {seed}")) && out.contains(&format!("ROOM/{name}-truth.csv")),
            "{out}"
        );
    }
    assert_eq!(room.read("a.csv"), room.read("b.csv"));
    assert_eq!(room.read("a-truth.csv"), room.read("b-truth.csv"));
    assert_ne!(room.read("a.csv"), room.read("c.csv"));
    // The example is what is taken without --like.
    assert_eq!(run(&["simulate", "--example"]), (Exit::Fine, EXAMPLE.to_owned(), String::new()));
    room.simulate(Some(EXAMPLE), "d", &["--seed", "3"]);
    assert_eq!(room.read("a.csv"), room.read("d.csv"));
}

#[test]
fn every_row_has_its_truth_and_grading_says_what_it_says() {
    let room = Room::empty();
    // In a spreadsheet of its own kind as well: commas, semicolons, a byte order mark.
    let messy =
        EXAMPLE.replace("spreadsheet: no", "spreadsheet: yes").replace("attempts: {1: 80, 2: 15, 3: 5}", "");
    for (name, habits, language) in [("plain", EXAMPLE, "en"), ("messy", messy.as_str(), "de")] {
        let (exit, _, err) = room.simulate(Some(habits), name, &["--language", language]);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
        let truth = room.rows(&format!("{name}-truth.csv"));
        assert_eq!(truth[0].len(), HEADER.len());
        assert_eq!(room.read(&format!("{name}.csv")).lines().count(), truth.len() + 1);
        let (submissions, grades) = (room.path(&format!("{name}.csv")), room.path(name));
        let (exit, _, err) = run(&["grade", set(), &submissions, "--out", &grades]);
        assert_eq!(exit, Exit::Fine, "{err}");
        let graded = room.rows(&format!("{name}/answers.csv"));
        assert_eq!(graded.len(), truth.len());
        let mut kinds = BTreeSet::new();
        for (graded, truth) in graded.iter().zip(&truth) {
            for field in ["line", "student", "problem", "part"] {
                assert_eq!(graded[field], truth[field]);
            }
            kinds.insert(truth["kind"].clone());
            let says = &graded["verdict"];
            // An earlier attempt is superseded, whatever it was.
            if says != "superseded" {
                assert_eq!(says, &truth["verdict"], "{name}: {truth:?} {graded:?}");
            }
            if truth["verdict"] == "right" && truth["kind"] == "right" {
                assert_eq!(truth["right"], "yes");
            }
            let wrong = matches!(says.as_str(), "wrong" | "wrong direction");
            if wrong && truth["kind"] == "wrong method" && !truth["method"].is_empty() {
                assert!(graded["methods"].split(' ').any(|m| m == truth["method"]), "{graded:?}");
            }
        }
        assert_eq!(kinds.len(), Kind::ALL.len(), "{kinds:?}");
    }
    assert!(room.read("messy.csv").starts_with("\u{feff}Submitted_at;"));
    assert!(["abwärts", "ruht"].iter().any(|word| room.read("messy.csv").contains(word)));
}

#[test]
fn habits_are_what_is_done() {
    let room = Room::empty();
    let count = |rows: &[BTreeMap<String, String>], field: &str, value: &str| {
        rows.iter().filter(|r| r[field] == value).count()
    };
    // One wrong method alone, and everybody right where it spoils nothing.
    room.simulate(Some("{answers: {wrong method: 1}, wrong methods: {A05: 1}}"), "one", &[]);
    let rows = room.rows("one-truth.csv");
    let by: BTreeSet<&str> = rows.iter().map(|r| r["method"].as_str()).collect();
    assert_eq!(by, BTreeSet::from(["", "A05"]));
    assert!(rows.iter().all(|r| r["kind"] == "right" || r["kind"] == "wrong method"));
    assert_eq!(rows.len(), 16 * (6 + 7 + 6));
    // All are absent.
    room.simulate(Some("{answers: {right: 1}, absent: 100 %}"), "none", &[]);
    assert_eq!(room.read("none.csv"), "student,problem,part,answer\n");
    // Figures and units.
    room.simulate(Some("{answers: {right: 1}, figures: 6, units: {none: 1}}"), "bare", &[]);
    let rows = room.rows("bare-truth.csv");
    let numbers: Vec<&str> =
        rows.iter().filter(|r| r["figures"] == "6").map(|r| r["answer"].as_str()).collect();
    assert!(numbers.len() > 200 && numbers.iter().all(|n| n.parse::<f64>().is_ok()), "{numbers:?}");
    // Two pairs, of which one copies everything.
    let copying = "{answers: {right: 1}, copying: {groups: 2, size: 2, share: 1}}";
    room.simulate(Some(copying), "pairs", &[]);
    let rows = room.rows("pairs-truth.csv");
    let copied: Vec<_> = rows.iter().filter(|r| r["kind"] == "copied").collect();
    assert_eq!(copied.len(), 2 * (6 + 7 + 6));
    let pairs: BTreeSet<_> = copied.iter().map(|r| (&r["student"], &r["from"])).collect();
    assert_eq!(pairs.len(), 2);
    for row in &copied {
        let source = rows.iter().find(|r| {
            r["student"] == row["from"] && (&r["problem"], &r["part"]) == (&row["problem"], &row["part"])
        });
        let digits = |r: &BTreeMap<String, String>| r["answer"].split(' ').next().map(str::to_owned);
        assert_eq!(source.map(digits), Some(digits(row)));
        assert_eq!(row["right"] == "yes", row["verdict"] == "right");
    }
    // Several attempts, and times in order.
    let late = "{answers: {wrong sign: 1}, attempts: 3, handed in: {opens: 2026-03-02 08:00, due: 2026-03-02 20:00, late: 50 %}}";
    room.simulate(Some(late), "late", &[]);
    assert_eq!(count(&room.rows("late-truth.csv"), "attempt", "3"), 16 * (6 + 7 + 6));
    let times: Vec<String> = room.rows("late.csv").iter().map(|r| r["submitted_at"].clone()).collect();
    assert!(times.is_sorted() && times.iter().any(|t| t.as_str() > "2026-03-02 20:00"), "{times:?}");
    assert!(times.iter().all(|t| t.as_str() >= "2026-03-02 08:00" && t.as_str() <= "2026-03-03 20:00"));
}

#[test]
fn faults_of_habits_come_all_at_once() {
    let room = Room::empty();
    let habits = "\
absent: 140 %
answers: {right: 5, wrong methd: 3, blank: often}
wrong methods: {any: 0}
figures: {3: 1, 40: 1}
copying: {groups: two, share: 1}
units: {feet: 1}
handed in: {opens: 2026-02-30 08:00, due: 2026-03-02 20:00, by at most: soon, zone: CET}
spreadsheet: maybe
lateness: 3
";
    let (exit, out, err) = room.simulate(Some(habits), "h", &[]);
    assert_eq!((exit, out.as_str()), (Exit::Faulty, ""));
    for (line, part) in [
        (1, "expected a share, found `140 %`"),
        (2, "`wrong methd` is none of the kinds of answers"),
        (2, "did you mean `wrong method`?"),
        (2, "expected how often, found `often`"),
        (3, "no wrong method is ever met"),
        (4, "`40` is none of the numbers of figures"),
        (5, "expected a whole number from 0 to 1000000, found `two`"),
        (6, "`feet` is none of the ways of writing units"),
        (7, "expected a time, found `2026-02-30 08:00`"),
        (7, "expected a time span, found `soon`"),
        (7, "`CET` is no offset from UTC"),
        (8, "expected `yes` or `no` or `true` or `false`, found `maybe`"),
        (9, "unknown field `lateness`"),
    ] {
        assert!(err.contains(part), "{part}\n{err}");
        assert!(err.contains(&format!("ROOM/h.yaml:{line}:")), "line {line}\n{err}");
    }
    assert!(!fs::exists(room.path("h.csv")).unwrap() && !fs::exists(room.path("h-truth.csv")).unwrap());
    for (habits, part) in [
        ("title: nothing", "`answers` is missing"),
        ("answers: {right: 0}", "nothing here is ever met"),
        ("{answers: {right: 1}, wrong methods: {A5: 1, A051: 2}}", "lists the wrong method `A051`"),
        ("- right", "expected habits"),
        ("answers: [", "h.yaml"),
    ] {
        let (exit, _, err) = room.simulate(Some(habits), "h", &[]);
        assert_eq!(exit, Exit::Faulty, "{habits}");
        assert!(err.contains(part), "{habits}: {err}");
    }
}

#[test]
fn a_late_joiner_changes_nobody_elses_answers() {
    let room = Room::empty();
    let (roster, set) = (room.path("roster.csv"), room.path("set"));
    let habits = room.path("habits.yaml");
    let alone: Vec<&str> = EXAMPLE.lines().filter(|l| !l.starts_with("copying:")).collect();
    room.write("habits.yaml", &alone.join("\n"));
    let mut seen: Vec<Vec<String>> = Vec::new();
    for (students, more) in
        [("student\na\nb\n", &["--seed", "1"][..]), ("student\nb\nnew\na\n", &["--add"][..])]
    {
        room.write("roster.csv", students);
        let bank = ["generate", "hoists-and-pulleys", "--roster", &roster, "--out", &set];
        let (exit, _, err) = run(&[&bank[..], more].concat());
        assert_eq!(exit, Exit::Fine, "{err}");
        let (out, truth) = (room.path("s.csv"), room.path("t.csv"));
        let args = ["simulate", &set, "--like", &habits, "--out", &out, "--truth", &truth, "--force"];
        let (exit, _, err) = run(&args);
        assert_eq!(exit, Exit::Fine, "{err}");
        let text = room.read("s.csv");
        seen.push(text.lines().filter(|l| !l.starts_with("new,")).map(str::to_owned).collect());
        assert_eq!(more[0] == "--add", text.contains("\nnew,"));
    }
    assert!(seen[0].len() > 20);
    assert_eq!(seen[0], seen[1]);
}

#[test]
fn nothing_is_written_over() {
    let room = Room::empty();
    room.write("a.csv", "mine");
    let (exit, _, err) = room.simulate(None, "a", &[]);
    assert_eq!(exit, Exit::Faulty);
    assert!(err.contains("is there already") && err.contains("--force"), "{err}");
    assert_eq!(room.read("a.csv"), "mine");
    assert!(!fs::exists(room.path("a-truth.csv")).unwrap());
    let (exit, ..) = room.simulate(None, "a", &["--force"]);
    assert_eq!(exit, Exit::Fine);
    let same = room.path("b.csv");
    let (exit, _, err) = run(&["simulate", set(), "--out", &same, "--truth", &same]);
    assert!(exit == Exit::Faulty && err.contains("is the file of the submissions"), "{err}");
    let (exit, _, err) = run(&["simulate", &room.path(""), "--out", &same, "--truth", &room.path("t.csv")]);
    assert!(exit == Exit::Faulty && err.contains("set.json"), "{err}");
    let (exit, ..) = run(&["simulate", set()]);
    assert_eq!(exit, Exit::Faulty);
}
