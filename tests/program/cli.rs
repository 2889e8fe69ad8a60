//! The street door: exit code, standard output and standard error of each verb, in fresh folders.
use crate::support::program::{Ran, Room, run, run_with, tree};
use slipstick::cli::tell::Exit;
use slipstick::simulate::truth::TrueKind;
use slipstick::words::Words;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

impl Room {
    /// A fresh folder with a roster.
    fn new(students: &[&str]) -> Self {
        let room = Self::empty();
        room.roster("roster.csv", students);
        room
    }
    fn roster(&self, name: &str, students: &[&str]) {
        let rows: String = students.iter().map(|s| format!("{s},Name of {s}\n")).collect();
        self.write(name, &format!("student,name\n{rows}"));
    }
    fn generate(&self, roster: &str, out: &str, more: &[&str]) -> Ran {
        let (roster, out) = (self.path(roster), self.path(out));
        let mut args = vec!["generate", "wheels-on-inclines", "--roster", &roster, "--out", &out];
        if !more.contains(&"--add") {
            args.extend(["--seed", "7"]);
        }
        args.extend(more);
        run(&args)
    }
}

const CLASS: [&str; 5] = ["0017", "Ana", "../x", "CON", "ana"];

#[test]
fn a_set_has_its_files_and_nothing_for_students_but_theirs() {
    let room = Room::new(&CLASS);
    let ran = room.generate("roster.csv", "set", &[]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(
        ran.out
            .starts_with("5 sheets of 4 problems with 23 questions each, 20 variants drawn and solved twice"),
        "{}",
        ran.out
    );
    let files = tree(&room.0.path().join("set"));
    // Four figures, the sheet in Markdown and as a page, and what `check` reads.
    let with_pdf = usize::from(slipstick::sheet::pdf::BUILT_IN);
    assert_eq!(files.len(), 8 + 2 * with_pdf + (7 + with_pdf) * CLASS.len());
    let of_set = [
        "bank.yaml",
        "key.csv",
        "set.json",
        "submissions.csv",
        "index.html",
        "booklet.html",
        "key-table.html",
        "key-table.md",
    ];
    for name in of_set {
        assert!(files.contains_key(name), "{name}");
    }
    let key = room.read("set/key.csv");
    assert_eq!(
        key.lines().next(),
        Some("student,problem,part,value,unit,eom,energy,gap,cond,tolerance,error_bound,code")
    );
    assert_eq!(key.lines().count(), 1 + 23 * CLASS.len());
    // A unit reads as people write it and stays on one line.
    let html = room.read("set/students/0017/sheet.html");
    let in_one = "<code>2.v</code>, in\u{a0}<span class=\"unit\">m/s</span>";
    assert!(html.contains("in\u{a0}kg\u{a0}m²") && html.contains(in_one), "{html}");
    // No number of the key is in what a student gets.
    let set: serde_json::Value = serde_json::from_str(&room.read("set/set.json")).unwrap();
    let folder = set["students"][0]["folder"].as_str().unwrap().to_owned();
    for name in ["sheet.md", "sheet.html", "sheet.json"] {
        let sheet = room.read(&format!("set/students/{folder}/{name}"));
        for row in key.lines().filter(|l| l.starts_with("0017,")) {
            let value = row.split(',').nth(3).unwrap();
            assert!(value.len() < 8 || !sheet.contains(value), "{name} holds {value}");
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let room = Room::new(&CLASS);
    for (out, threads) in [("one", "1"), ("two", "2"), ("again", "2")] {
        assert_eq!(room.generate("roster.csv", out, &["--threads", threads]).exit, Exit::Fine);
    }
    let first = tree(&room.0.path().join("one"));
    assert!(first == tree(&room.0.path().join("two")), "one thread and two");
    assert!(first == tree(&room.0.path().join("again")), "two runs");
}

#[test]
fn a_student_does_not_depend_on_the_others() {
    let room = Room::new(&CLASS);
    let mut turned = CLASS;
    turned.reverse();
    room.roster("turned.csv", &turned);
    room.roster("few.csv", &CLASS[1..3]);
    for (roster, out) in [("roster.csv", "all"), ("turned.csv", "turned"), ("few.csv", "few")] {
        assert_eq!(room.generate(roster, out, &[]).exit, Exit::Fine);
    }
    let all = tree(&room.0.path().join("all/students"));
    assert!(all == tree(&room.0.path().join("turned/students")));
    for (name, bytes) in tree(&room.0.path().join("few/students")) {
        assert!(all[&name] == bytes, "{name}");
    }
    // Another name of the set, or another seed, gives another sheet.
    assert_eq!(room.generate("roster.csv", "named", &["--name", "week 5"]).exit, Exit::Fine);
    let named = tree(&room.0.path().join("named/students"));
    let sheets = |name: &str| name.rsplit('/').next().is_some_and(|n| n.starts_with("sheet."));
    assert!(all.iter().filter(|(name, _)| sheets(name)).all(|(name, bytes)| named[name] != *bytes));
}

#[test]
fn late_joiners_get_what_they_would_have_got() {
    let room = Room::new(&CLASS);
    room.roster("early.csv", &CLASS[..3]);
    assert_eq!(room.generate("roster.csv", "whole", &[]).exit, Exit::Fine);
    assert_eq!(room.generate("early.csv", "grown", &[]).exit, Exit::Fine);
    let before = tree(&room.0.path().join("grown/students"));
    let ran = room.generate("roster.csv", "grown", &["--add"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.starts_with("2 sheets"), "{}", ran.out);
    let after = tree(&room.0.path().join("grown"));
    assert!(before.iter().all(|(name, bytes)| after[&format!("students/{name}")] == *bytes));
    assert!(after == tree(&room.0.path().join("whole")));
    let again = room.generate("roster.csv", "grown", &["--add"]);
    assert_eq!(again.out, "Nobody to add: every student of the roster has a sheet already.\n");
    let other = room.generate("roster.csv", "grown", &["--add", "--seed", "8"]);
    assert_eq!(other.exit, Exit::Faulty);
    assert!(other.err.contains("seed: the set has 7, this command 8"), "{}", other.err);
}

#[test]
fn a_folder_is_not_overwritten() {
    let room = Room::new(&CLASS);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    let first = tree(&room.0.path().join("set"));
    let ran = room.generate("roster.csv", "set", &[]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert_eq!(
        room.shown(&ran.err),
        "error: ROOM/set: is there already\n    hint: give another --out, or --force to replace a set, or --add for late joiners\n"
    );
    assert_eq!(room.generate("roster.csv", "set", &["--force"]).exit, Exit::Fine);
    assert!(first == tree(&room.0.path().join("set")));
    room.write("set/notes.txt", "mine");
    let ran = room.generate("roster.csv", "set", &["--force"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("holds what `slipstick generate` did not make: notes.txt"), "{}", ran.err);
    assert_eq!(room.read("set/notes.txt"), "mine");
    fs::create_dir(room.path("other")).unwrap();
    room.write("other/thesis.tex", "mine");
    let ran = room.generate("roster.csv", "other", &["--force"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert_eq!(
        room.shown(&ran.err),
        "error: ROOM/other: holds no set\n    hint: --force replaces only what generate made\n"
    );
    assert_eq!(tree(&room.0.path().join("other")).len(), 1);
}

#[test]
fn an_add_that_was_killed_is_made_good_by_the_next() {
    let room = Room::new(&CLASS);
    room.roster("early.csv", &CLASS[..3]);
    for out in ["early", "forced"] {
        assert_eq!(room.generate("early.csv", out, &[]).exit, Exit::Fine);
    }
    assert_eq!(room.generate("roster.csv", "whole", &[]).exit, Exit::Fine);
    // Killed before set.json was put in its place: sheets and the key of the late ones are there.
    let set: serde_json::Value = serde_json::from_str(&room.read("whole/set.json")).unwrap();
    let late = set["students"][4]["folder"].as_str().unwrap();
    let copy = |out: &str| {
        fs::create_dir(room.path(&format!("{out}/students/{late}"))).unwrap();
        for entry in fs::read_dir(room.path(&format!("whole/students/{late}"))).unwrap() {
            let name = entry.unwrap().file_name().to_string_lossy().into_owned();
            let from = room.path(&format!("whole/students/{late}/{name}"));
            fs::copy(from, room.path(&format!("{out}/students/{late}/{name}"))).unwrap();
        }
        fs::copy(room.path("whole/key.csv"), room.path(&format!("{out}/key.csv"))).unwrap();
    };
    let early = tree(&room.0.path().join("early"));
    copy("early");
    copy("forced");
    let ran = room.generate("early.csv", "early", &["--add"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(tree(&room.0.path().join("early")) == early, "the old set, nothing else");
    copy("early");
    assert_eq!(room.generate("roster.csv", "early", &["--add"]).exit, Exit::Fine);
    assert!(tree(&room.0.path().join("early")) == tree(&room.0.path().join("whole")));
    assert_eq!(room.generate("early.csv", "forced", &["--force"]).exit, Exit::Fine);
    assert!(!Path::new(&room.path(&format!("forced/students/{late}"))).exists());
    // Killed after set.json: the form is the old one.
    let form = room.read("whole/submissions.csv");
    room.write("whole/submissions.csv", &room.read("forced/submissions.csv"));
    assert_eq!(room.generate("roster.csv", "whole", &["--add"]).exit, Exit::Fine);
    assert_eq!(room.read("whole/submissions.csv"), form);
    // A folder that somebody else made is not touched.
    fs::create_dir(room.path(&format!("forced/students/{late}"))).unwrap();
    room.write(&format!("forced/students/{late}/mine.txt"), "mine");
    let ran = room.generate("roster.csv", "forced", &["--add"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("is there already, and generate did not make it"), "{}", ran.err);
    assert_eq!(room.read(&format!("forced/students/{late}/mine.txt")), "mine");
}

#[test]
#[cfg(target_os = "linux")]
fn what_killed_runs_left_is_swept_away() {
    let room = Room::new(&CLASS);
    let mut child = std::process::Command::new("true").spawn().unwrap();
    let dead = child.id();
    child.wait().unwrap();
    let machine = fs::read_to_string("/proc/sys/kernel/random/boot_id").unwrap();
    let left = |name: &str, owner: &str| {
        fs::create_dir_all(room.path(&format!(".slipstick-unfinished-{name}/new/students"))).unwrap();
        room.write(&format!(".slipstick-unfinished-{name}/slipstick-owner"), owner);
    };
    left("dead", &format!("{dead}\n{machine}set\n"));
    left("alive", &format!("{}\n{machine}set\n", std::process::id()));
    left("elsewhere", &format!("{dead}\nanother-machine\nset\n"));
    // Killed between the two renames: the old set is inside.
    assert_eq!(room.generate("roster.csv", "old", &[]).exit, Exit::Fine);
    left("between", &format!("{dead}\n{machine}old\n"));
    fs::rename(room.path("old"), room.path(".slipstick-unfinished-between/old")).unwrap();
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    let there = |name: &str| Path::new(&room.path(&format!(".slipstick-unfinished-{name}"))).exists();
    assert!(!there("dead") && !there("between") && there("alive") && there("elsewhere"));
    assert!(tree(&room.0.path().join("old")) == tree(&room.0.path().join("set")));
}

#[test]
fn folders_and_files_in_each_others_place_are_explained() {
    let room = Room::new(&CLASS);
    let here = std::env::current_dir().unwrap().display().to_string();
    for out in [".", "..", &here] {
        let args = [
            "generate",
            "wheels-on-inclines",
            "--seed",
            "1",
            "--roster",
            &room.path("roster.csv"),
            "--out",
            out,
        ];
        let ran = run(&args);
        assert_eq!(ran.exit, Exit::Faulty);
        assert!(ran.err.contains("write into a new folder, such as --out week-5"), "{}", ran.err);
    }
    let below = room.generate("roster.csv", "roster.csv/set", &[]);
    assert!(below.err.contains("something else of this name is in the way"), "{}", below.err);
    let ran = run(&["grade", &room.path("roster.csv"), &room.path("roster.csv"), "--out", &room.path("g")]);
    assert!(ran.err.contains("is a file; a set is a folder"), "{}", ran.err);
    fs::create_dir(room.path("dir")).unwrap();
    let ran = room.generate("dir", "set", &[]);
    assert!(ran.err.contains("it is a folder, and a file is wanted"), "{}", ran.err);
    for ran in [below, ran] {
        assert!(!ran.err.contains("os error") && !ran.err.contains(".slipstick"), "{}", ran.err);
    }
    // Folders named otherwise than the student are told.
    let ran = room.generate("roster.csv", "set", &[]);
    assert!(ran.out.contains("\n  ../x is in students/%2E"), "{}", ran.out);
    assert!(!ran.out.contains("0017 is in"), "{}", ran.out);
}

#[test]
fn what_did_not_finish_is_no_set() {
    // A run that was killed leaves a folder under another name, beside the place.
    let room = Room::new(&CLASS);
    fs::create_dir_all(room.path(".slipstick-unfinished-abc/students/s1")).unwrap();
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    // A set without its set.json is none.
    fs::remove_file(room.path("set/set.json")).unwrap();
    room.write("answers.csv", "student,problem,part,answer\n");
    let ran = run(&["grade", &room.path("set"), &room.path("answers.csv"), "--out", &room.path("grades")]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("holds no set"), "{}", ran.err);
    assert!(!Path::new(&room.path("grades")).exists());
    // A refused run leaves nothing, no half-made folder either.
    let names = |room: &Room| fs::read_dir(room.0.path()).unwrap().count();
    let before = names(&room);
    assert_eq!(room.generate("roster.csv", "third", &["--problems", "no-such"]).exit, Exit::Faulty);
    assert_eq!(names(&room), before);
}

/// value and unit of a part in key.csv
fn key_of(room: &Room, student: &str, problem: &str, part: &str) -> (String, String) {
    let key = room.read("set/key.csv");
    let row = key.lines().find(|l| l.starts_with(&format!("{student},{problem},{part},"))).unwrap();
    let fields: Vec<&str> = row.split(',').collect();
    (fields[3].to_owned(), fields[4].to_owned())
}

#[test]
fn grading_replays_the_key_and_writes_both_files() {
    let room = Room::new(&CLASS[..2]);
    assert_eq!(room.generate("roster.csv", "set", &["--problems", "pulled-rolling"]).exit, Exit::Fine);
    let (v, unit) = key_of(&room, "0017", "1", "v");
    let (omega, _) = key_of(&room, "Ana", "1", "omega");
    room.write("in.csv", &format!("student,problem,part,answer\n0017,1,v,{v} {unit}\n17,1,v,{v}\nAna,pulled-rolling,omega,{omega}\nAna,1,v,\n"));
    let out = room.path("grades");
    let ran = run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &out]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let answers = room.read("grades/answers.csv");
    let verdicts: Vec<&str> = answers.lines().skip(1).map(|l| l.split(',').nth(6).unwrap()).collect();
    assert_eq!(verdicts, ["right", "unknown student", "right", "blank"], "{answers}");
    assert_eq!(room.read("grades/gradebook.csv").lines().count(), 3);
    // Not overwritten without --force.
    let again = run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &out]);
    assert_eq!(again.exit, Exit::Faulty);
    let forced = run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &out, "--force"]);
    assert_eq!(forced.exit, Exit::Fine);
}

#[test]
fn submissions_come_through_a_pipe() {
    let room = Room::new(&CLASS[..2]);
    assert_eq!(room.generate("roster.csv", "set", &["--problems", "pulled-rolling"]).exit, Exit::Fine);
    let (v, unit) = key_of(&room, "0017", "1", "v");
    let piped = format!("student,problem,part,answer\n0017,1,v,{v} {unit}\n");
    let (set, out) = (room.path("set"), room.path("grades"));
    let ran = run_with(&["grade", &set, "-", "--out", &out], &piped);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let answers = room.read("grades/answers.csv");
    assert!(answers.lines().nth(1).unwrap().contains(",right,"), "{answers}");
    // The program itself holds the lock of its standard input: it must not wait for it.
    assert_cmd::Command::cargo_bin("slipstick")
        .unwrap()
        .args(["grade", &set, "-", "--out", &room.path("again")])
        .write_stdin(piped)
        .timeout(std::time::Duration::from_secs(60))
        .assert()
        .code(0);
    assert_eq!(room.read("again/answers.csv"), answers);
}

#[test]
fn a_changed_set_is_not_graded() {
    let room = Room::new(&CLASS[..2]);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    room.write("in.csv", "student,problem,part,answer\n0017,1,T,1 J\n");
    let grade = || run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &room.path("grades")]);
    let change = |file: &str, from: &str, to: &str, says: &str| {
        let old = room.read(file);
        assert!(old.contains(from), "{file} holds {from}");
        room.write(file, &old.replacen(from, to, 1));
        let ran = grade();
        assert_eq!(ran.exit, Exit::Faulty, "{file}");
        assert!(ran.err.contains(says), "{file}: {}", ran.err);
        assert!(!Path::new(&room.path("grades")).exists());
        room.write(file, &old);
    };
    change("set/bank.yaml", "gravity: 9.81", "gravity: 9.80", "the bank copy was changed");
    change("set/set.json", "\"seed\": 7", "\"seed\": 8", "when drawn anew");
    change(
        "set/set.json",
        "\"g\":\"9.81 m/s^2\"",
        "\"g\":\"9.82 m/s^2\"",
        "g is `9.82 m/s^2` in the set, `9.81 m/s^2` when drawn anew",
    );
    let (value, _) = key_of(&room, "0017", "1", "kinetic_energy");
    change("set/key.csv", &value, "1", "when made anew from the set");
    change("set/set.json", "{", "{{", "is no set");
    change(
        "set/set.json",
        "\"draw_version\": 5",
        "\"draw_version\": 9",
        "draw_version: is 9; this program draws by version 5",
    );
    // Another program version that draws the same is fine.
    let set = room.read("set/set.json");
    let program = format!("\"slipstick {}\"", env!("CARGO_PKG_VERSION"));
    assert!(set.contains(&program));
    room.write("set/set.json", &set.replacen(&program, "\"slipstick 99.0.0\"", 1));
    assert_eq!(grade().exit, Exit::Fine);
}

#[test]
fn check_needs_the_sheet_alone() {
    let room = Room::new(&CLASS[..1]);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    fs::copy(room.path("set/students/0017/sheet.json"), room.path("sheet.json")).unwrap();
    let (omega, _) = key_of(&room, "0017", "2", "omega");
    let (friction, _) = key_of(&room, "0017", "2", "friction");
    fs::remove_dir_all(room.path("set")).unwrap();
    let sheet = room.path("sheet.json");
    let right = run(&[
        "check",
        &sheet,
        &format!("2.omega={omega} rad/s"),
        &format!("pulled-rolling.friction={friction}"),
    ]);
    assert_eq!((right.exit, right.err.as_str()), (Exit::Fine, ""));
    assert!(right.out.starts_with("  2.omega "), "{}", right.out);
    let wrong = run(&["check", &sheet, "2.omega=1 rad/s", "--reveal"]);
    assert_eq!(wrong.exit, Exit::NotAllRight);
    assert_eq!(wrong.err, "");
    assert!(wrong.out.contains("  no value shown: the bank does not allow --reveal\n"), "{}", wrong.out);
    assert!(!wrong.out.contains(&omega[..4]), "no value is shown");
    for (answer, says) in [
        ("2.omga=1", "did you mean `omega`?"),
        ("9.v=1", "the sheet has no problem `9`"),
        ("omega", "is no answer"),
    ] {
        let ran = run(&["check", &sheet, answer]);
        assert_eq!(ran.exit, Exit::Faulty);
        assert!(ran.err.contains(says), "{}", ran.err);
    }
    room.write("broken.json", &fs::read_to_string(&sheet).unwrap()[..100]);
    assert_eq!(run(&["check", &room.path("broken.json"), "2.v=1"]).exit, Exit::Faulty);
}

/// The answer of a wheel whose cord pulls with the distance of the centre, from the data that its sheet prints.
fn pull_over_the_distance_of_the_centre(sheet: &str) -> String {
    let sheet: serde_json::Value = serde_json::from_str(sheet).unwrap();
    let data = &sheet["problems"][1]["data"];
    let of = |symbol: &str| data[symbol]["value"].as_str().unwrap().parse::<f64>().unwrap();
    let (m, r, k) = (of("m"), of("r"), of("k"));
    let drive = of("P") - m * of("g") * of("theta").to_radians().sin();
    format!("{:.3}", (2.0 * of("d") * drive / (m * (1.0 + k * k / (r * r)))).sqrt() / r)
}

#[test]
fn check_gives_the_hints_that_the_bank_allows() {
    let room = Room::new(&CLASS[..1]);
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    for level in ["none", "nudge", "explain"] {
        let setting = format!("\ngrading: {{hints: {level}, due: 2030-01-01 12:00}}\nproblems:");
        room.write(&format!("{level}.yaml"), &bank.replacen("\nproblems:", &setting, 1));
        let (bank, roster, out) =
            (room.path(&format!("{level}.yaml")), room.path("roster.csv"), room.path(level));
        let ran = run(&["generate", &bank, "--roster", &roster, "--seed", "7", "--out", &out]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    }
    let file = |level: &str| format!("{level}/students/0017/sheet.json");
    let text = room.read(&file("explain"));
    let wrong = format!("2.omega={} rad/s", pull_over_the_distance_of_the_centre(&text));
    // Of the settings that bear on marks a sheet knows this one, and of the wrong methods no case.
    assert!(text.contains(r#""grading":{"hints":"explain"}"#) && !text.contains("2030"), "{text}");
    assert!(text.contains(r#""A01":"#) && !text.contains("unguarded") && !text.contains(r#""cases""#));
    let hint = |level: &str, n: &str| {
        let ran = run(&["check", &room.path(&file(level)), &wrong, "--hint", n]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::NotAllRight, ""));
        let told =
            ran.out.lines().find_map(|l| l.strip_prefix("2.omega, hint ").or(l.strip_prefix("2.omega: ")));
        let told = told.map(str::to_owned);
        told.unwrap_or_default()
    };
    let first = "How far does the point move at which the pull acts, compared with the centre?";
    assert_eq!(hint("explain", "1"), format!("1 of 4: {first}"));
    assert!(hint("explain", "2").ends_with("What does your formula do there?"), "{}", hint("explain", "2"));
    assert!(hint("explain", "3").starts_with("3 of 4: Look at the figure"), "{}", hint("explain", "3"));
    assert!(
        hint("explain", "4").contains("The pulled end does not move with the centre"),
        "{}",
        hint("explain", "4")
    );
    assert_eq!(hint("explain", "5"), "there are no more than 4 hints");
    assert_eq!(hint("nudge", "1"), format!("1 of 2: {first}"));
    assert_eq!(hint("nudge", "3"), "there are no more than 2 hints");
    assert_eq!(hint("none", "1"), "");
    assert_eq!(run(&["check", &room.path(&file("none")), &wrong, "--hint", "0"]).exit, Exit::Faulty);
    // A part that is misnamed does not hide what becomes of the others.
    let ran = run(&["check", &room.path(&file("nudge")), "2.omga=1 rad/s", &wrong]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.out.contains(first) && ran.err.contains("did you mean `omega`?"), "{}{}", ran.out, ran.err);
}

#[test]
fn a_bank_may_forbid_self_checks_or_allow_values() {
    let room = Room::new(&CLASS[..1]);
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    for (line, name) in [("self check: off", "closed"), ("reveal: on", "open")] {
        room.write(
            &format!("{name}.yaml"),
            &bank.replacen("\nproblems:", &format!("\n{line}\nproblems:"), 1),
        );
        let (bank, roster, out) =
            (room.path(&format!("{name}.yaml")), room.path("roster.csv"), room.path(name));
        let ran = run(&["generate", &bank, "--roster", &roster, "--seed", "1", "--out", &out]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    }
    let closed = run(&["check", &room.path("closed/students/0017/sheet.json"), "2.v=1"]);
    assert_eq!(closed.exit, Exit::Faulty);
    assert!(closed.err.contains("carries no scene"), "{}", closed.err);
    assert!(room.read("closed/students/0017/sheet.json").contains("\"scene\": null"));
    assert!(!room.read("closed/students/0017/sheet.md").contains("slipstick check"));
    let open = run(&["check", &room.path("open/students/0017/sheet.json"), "2.v=1 m/s", "--reveal"]);
    assert_eq!(open.exit, Exit::NotAllRight);
    assert!(open.out.contains("right: "), "{}", open.out);
}

/// A bank of a person's own, with a statement of its own and far too few variants.
const NARROW: &str = r#"bank: narrow
title: Few variants
problems:
  pull:
    title: Pulled
    data:
      m: {name: mass, unit: kg, draw: "one of 40, 60"}
      R: {name: rim, unit: m, draw: always 0.40}
      r: {name: hub, unit: m, draw: always 0.20}
      k: {name: radius of gyration, unit: m, draw: always 0.30}
      theta: {name: slope, unit: deg, draw: always 10}
      P: {name: pull, unit: N, draw: 200 to 201 step 1}
      d: {name: travel, unit: m, draw: always 2.0}
      mu_s: {name: static friction, unit: "1", draw: always 0.9}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies:
        wheel: {mass: m, radius of gyration: k, radii: {rim: R, hub: r}, moves: along incline}
      ties:
        - rolls: {body: wheel, on its: hub, mu_s: mu_s}
        - cord: {from: {body: wheel, wound on: rim, leaves: top forward}, pulled with: P}
      start: at rest
      end: {travel: {of: wheel, by: d, heading: up}}
    regimes: [moves_up]
    questions:
      v: {ask: "the speed of the centre after {{ value.d }}", unit: m/s}
    statement: |
      Data: {{ m }}, {{ R }}, {{ r }}, {{ k }}, {{ theta }}, {{ P }}, {{ d }}, {{ mu_s }}, {{ g }}. Symbol ${{ tex.mu_s }}$.
"#;

#[test]
fn students_with_problems_too_much_alike_are_named() {
    let students: Vec<String> = (0..40).map(|i| format!("s{i}")).collect();
    let room = Room::new(&students.iter().map(String::as_str).collect::<Vec<_>>());
    room.write("narrow.yaml", NARROW);
    let (bank, roster, out) = (room.path("narrow.yaml"), room.path("roster.csv"), room.path("set"));
    let ran = run(&["generate", &bank, "--roster", &roster, "--seed", "1", "--out", &out]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.contains("with an equal problem or all its answers within tolerance"), "{}", ran.out);
    let sheet = room.read("set/students/s0/sheet.md");
    assert!(sheet.contains(r"Symbol $\mu_s$"), "{sheet}");
    assert!(sheet.contains(r"after $2.0\ \mathrm{m}$"), "{sheet}");
    // Every pair is judged rightly: only the masses make a difference beyond the tolerance.
    let set: serde_json::Value = serde_json::from_str(&room.read("set/set.json")).unwrap();
    let data = |i: usize, symbol: &str| set["students"][i]["problems"][0]["data"][symbol].clone();
    let mut expected = Vec::new();
    for a in 0..40 {
        for b in a + 1..40 {
            if data(a, "m") == data(b, "m") {
                let equal = data(a, "P") == data(b, "P");
                let what = if equal { "equal data" } else { "answers within tolerance" };
                expected.push((format!("s{a}"), format!("s{b}"), what.to_owned()));
            }
        }
    }
    let text = |v: &serde_json::Value| v.as_str().unwrap().to_owned();
    let found: Vec<(String, String, String)> = set["coincidences"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| (text(&c["students"][0]), text(&c["students"][1]), text(&c["what"])))
        .collect();
    assert_eq!(found, expected);
}

const ROLLING: [&str; 16] = [
    "--set",
    "m=40kg",
    "--set",
    "R=400mm",
    "--set",
    "r=200mm",
    "--set",
    "k=300mm",
    "--set",
    "theta=30deg",
    "--set",
    "P=200N",
    "--set",
    "d=3m",
    "--set",
    "mu_s=0.6",
];

fn solve(more: &[&str], changed: &[(&str, &str)]) -> Ran {
    let mut args = vec!["solve", "wheels-on-inclines", "pulled-rolling"];
    let data: Vec<String> = ROLLING
        .iter()
        .map(|text| {
            let new = changed.iter().find(|(symbol, _)| text.split('=').next() == Some(*symbol));
            new.map_or_else(|| (*text).to_owned(), |(symbol, value)| format!("{symbol}={value}"))
        })
        .collect();
    args.extend(data.iter().map(String::as_str));
    args.extend(more);
    run(&args)
}

#[test]
fn solve_says_what_happens() {
    let ran = solve(&["--json"], &[]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(json["problem"], "pulled-rolling");
    assert_eq!(json["regime"], "moves_up");
    assert!(json["checks"].as_array().unwrap().iter().all(|c| c["ok"] == true));
    // (T P (c + p)/c d - m g d sin) with the given numbers, by hand: v^2 = 2 a d, a = 404.../130.
    let friction = json["quantities"]["friction"]["value"].as_f64().unwrap();
    assert!((friction - 120.446_153_846_153_85).abs() < 1e-12, "{friction}");
    assert_eq!(json["quantities"]["direction"]["value"], "up");
    assert!(json["quantities"]["direction"]["eom"].is_null());
    let text = ran.out.split("\"omega\": {\"value\": ").nth(1).unwrap();
    let digits = text.split(',').next().unwrap();
    assert_eq!(digits.split('e').next().unwrap().len(), 18, "17 significant digits: {digits}");

    // Plain numbers are SI, angles in degrees; the same bits.
    let plain =
        solve(&["--json"], &[("R", "0.4"), ("r", "0.2"), ("k", "0.3"), ("theta", "30"), ("m", "40000 g")]);
    assert_eq!(plain.out, ran.out);

    let slips = solve(&["--json"], &[("mu_s", "0.1")]);
    assert_eq!(slips.exit, Exit::RegimeFails);
    let json: serde_json::Value = serde_json::from_str(&slips.out).unwrap();
    assert_eq!(json["regime"], "moves_up slips");
    let check = json["checks"].as_array().unwrap().iter().find(|c| c["name"] == "no_slip").unwrap();
    assert_eq!(check["ok"], false);
    assert!(check["detail"].as_str().unwrap().contains("120.45"), "{check}");

    let table = solve(&[], &[]);
    assert_eq!(table.exit, Exit::Fine);
    assert!(table.out.contains("equations of motion  work and energy"), "{}", table.out);
}

#[test]
fn solve_takes_any_regime_where_none_is_declared() {
    let room = Room::new(&[]);
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    let open: String =
        bank.lines().filter(|l| !l.trim_start().starts_with("regimes:")).map(|l| format!("{l}\n")).collect();
    room.write("open.yaml", &open);
    let path = room.path("open.yaml");
    let mut args = vec!["solve", path.as_str(), "pulled-rolling", "--json"];
    args.extend(ROLLING);
    let ran = run(&args);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(!ran.out.contains("-0.0000000000000000e0"), "{}", ran.out);
    // Balanced without a pull on a level: zeros have no sign.
    let rest = solve(&["--json"], &[("theta", "0"), ("P", "0")]);
    assert!(!rest.out.contains("-0.0000000000000000e0"), "{}", rest.out);
}

#[test]
fn checks_say_how_a_motion_goes() {
    let weak = solve(&[], &[("P", "10N")]);
    assert_eq!(weak.exit, Exit::RegimeFails);
    let other_way = "the end is not reached: 3.0000 m asked, the motion goes the other way";
    assert!(weak.out.contains(other_way), "{}", weak.out);
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes/g5-openstax-cyl-up-h.yaml");
    let bank = fs::read_to_string(scene).unwrap();
    let id = bank.lines().skip_while(|l| *l != "problems:").nth(1).unwrap().trim().trim_end_matches(':');
    let rises = run(&["solve", scene, id, "--seed", "1"]);
    assert!(rises.out.contains("it starts with a speed of its own"), "{}", rises.out);
    assert!(rises.out.contains("the end is reached: it comes to rest after"), "{}", rises.out);
}

#[test]
fn solve_refuses_what_is_no_scene() {
    for (symbol, value) in [
        ("m", "-40kg"),
        ("r", "0.5"),
        ("theta", "91"),
        ("m", "nan"),
        ("m", "1e999"),
        ("m", "40 N"),
        ("m", ""),
    ] {
        let ran = solve(&["--json"], &[(symbol, value)]);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""), "{symbol}={value}");
        assert!(ran.err.starts_with("error: "), "{}", ran.err);
    }
    let missing = run(&["solve", "wheels-on-inclines", "pulled-rolling", "--set", "m=40kg", "--json"]);
    assert_eq!((missing.exit, missing.out.as_str()), (Exit::Faulty, ""));
    assert!(missing.err.contains("R is not given"), "{}", missing.err);
    let unknown = solve(&["--set", "mu_x=1"], &[]);
    assert!(unknown.err.contains("no datum `mu_x`"), "{}", unknown.err);
    let twice = solve(&["--set", "m=41kg"], &[]);
    assert!(twice.err.contains("is given twice"), "{}", twice.err);
    let nothing = run(&["solve", "wheels-on-inclines", "pulled-rolling"]);
    assert_eq!(nothing.exit, Exit::Faulty);
    let problem = run(&["solve", "wheels-on-inclines", "pulled-roling", "--seed", "1"]);
    assert!(problem.err.contains("did you mean `pulled-rolling`?"), "{}", problem.err);
    assert_eq!(run(&["solve", "wheels-on-inclines", "spring-released", "--seed", "1"]).exit, Exit::Fine);
}

#[test]
fn lint_says_where_figures_and_tolerance_do_not_fit() {
    let room = Room::new(&CLASS[..1]);
    let sound = run(&["lint", "wheels-on-inclines", "--seeds", "150"]);
    assert!(!sound.out.contains("note:"), "{}", sound.out);
    for rule in ["cond of slip_distance above 16.7", "input energy above 4 times the kinetic"] {
        assert!(sound.out.contains(rule), "{rule}: {}", sound.out);
    }
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    let heat = "unit: J, tolerance: {relative: widens with cond}";
    for (instead, says) in [
        (
            "unit: J, cond limit: 17",
            "% of honest answers with 3 figures on the way miss its tolerance; let its tolerance widen",
        ),
        (
            "unit: J, cond limit: 30, tolerance: {relative: widens with cond}",
            "widens up to cond 16.7, its cond limit is 30.0",
        ),
    ] {
        assert!(bank.contains(heat));
        room.write("tight.yaml", &bank.replace(heat, instead));
        let ran = run(&["lint", &room.path("tight.yaml"), "--seeds", "150"]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        let note =
            ran.out.lines().find(|l| l.contains("note: heat:")).unwrap_or_else(|| panic!("{}", ran.out));
        assert!(note.contains(says), "{note}");
    }
}

#[test]
fn lint_finds_and_sweeps() {
    let fine = run(&["lint", "wheels-on-inclines", "--seeds", "40"]);
    assert_eq!((fine.exit, fine.err.as_str()), (Exit::Fine, ""));
    assert!(fine.out.contains("Chance that two of 500 students get equal sheets"), "{}", fine.out);
    let room = Room::new(&[]);
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    room.write(
        "bank.yaml",
        &bank
            .replacen("title: A wheel pulled up an incline", "titel: A wheel", 1)
            .replacen("unit: kg", "unit: kq", 1),
    );
    let ran = run(&["lint", &room.path("bank.yaml")]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""));
    assert!(ran.err.contains("titel") && ran.err.contains("kq"), "all at once: {}", ran.err);
    let line = bank.lines().position(|l| l.contains("unit: kg")).unwrap() + 1;
    assert!(room.shown(&ran.err).contains(&format!("ROOM/bank.yaml:{line}:")), "{}", ran.err);
    let none = run(&["lint", "no-such-bank"]);
    assert_eq!(none.exit, Exit::Faulty);
    assert!(none.err.contains("built-in banks: wheels-on-inclines"), "{}", none.err);
}

#[test]
fn templates_of_ones_own() {
    let room = Room::new(&CLASS[..1]);
    fs::create_dir_all(room.path("mine/statement")).unwrap();
    let own = ["--templates", &room.path("mine")];
    room.write(
        "mine/statement/pulled-rolling.md",
        "Ein Rad der Masse {{ m }}: {{ R }}, {{ r }}, {{ k }}, {{ theta }}, {{ P }}, {{ d }}, {{ mu_s }}.",
    );
    assert_eq!(room.generate("roster.csv", "set", &own).exit, Exit::Fine);
    assert!(room.read("set/students/0017/sheet.md").contains("Ein Rad der Masse $m = "));
    // A datum that the statement lacks, in both commands.
    room.write(
        "mine/statement/pulled-rolling.md",
        "A wheel: {{ m }}, {{ R }}, {{ r }}, {{ k }}, {{ theta }}, {{ P }}, {{ d }}.",
    );
    let told = "error: ROOM/mine/statement/pulled-rolling.md: the statement never gives `mu_s`\n    hint: write `{{ mu_s }}` where it belongs\n";
    let ran = room.generate("roster.csv", "other", &own);
    assert_eq!((ran.exit, room.shown(&ran.err).as_str()), (Exit::Faulty, told));
    let ran = run(&["lint", "wheels-on-inclines", "--seeds", "5", own[0], own[1]]);
    assert_eq!((ran.exit, room.shown(&ran.err).as_str()), (Exit::Faulty, told));
    room.write("mine/statement/pulled-rolling.md", "A wheel.\nIts mass is {{ mass }}.\n");
    let ran = room.generate("roster.csv", "other", &own);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(
        room.shown(&ran.err).contains("ROOM/mine/statement/pulled-rolling.md:2:16: template: "),
        "{}",
        ran.err
    );
    assert!(!Path::new(&room.path("other")).exists());
    room.write("mine/statement/pulled-rolling.md", "A wheel of {{ m | nosuch }}.\n");
    assert_eq!(room.generate("roster.csv", "other", &own).exit, Exit::Faulty);
}

#[test]
fn practice_takes_piped_answers() {
    let ran = run_with(
        &["practice", "wheels-on-inclines", "--seed", "3", "--problems", "pulled-rolling"],
        "1 N\nsolution\nquit\n",
    );
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.contains("wrong dimension"), "{}", ran.out);
    let omega = ran.out.lines().find_map(|l| l.strip_prefix("  omega = ")).unwrap();
    let again = run_with(
        &["practice", "wheels-on-inclines", "--seed", "3", "--problems", "pulled-rolling"],
        &format!("{omega}\n"),
    );
    assert!(again.out.contains(&format!("omega = {omega}\n  right")), "{}", again.out);
    assert!(again.out.ends_with("\nYou had 1 of 1 questions right.\n"), "{}", again.out);
    let lost = run_with(&["practice", "wheels-on-inclines", "--seed", "3"], "help\nhelpme\nsolution\n\n");
    assert_eq!(lost.out.matches("`solution` shows the right values").count(), 3, "{}", lost.out);
    assert!(lost.out.contains("solution\n  The right values:\n"), "{}", lost.out);
}

/// Each further wrong answer brings the next hint, and none comes twice.
#[test]
fn practice_counts_its_hints() {
    let ran = run_with(
        &["practice", "wheels-on-inclines", "--seed", "3", "--problems", "pulled-rolling"],
        &"123.456 rad/s\n".repeat(6),
    );
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let told: Vec<&str> = ran.out.lines().filter(|l| l.starts_with("  ")).collect();
    let hints: Vec<&&str> = told.iter().filter(|l| l.ends_with('?') || l.ends_with('.')).collect();
    assert!(ran.out.contains("fits no mistake that is known here"), "{}", ran.out);
    assert!(ran.out.contains("the right answer"), "{}", ran.out);
    assert_eq!(ran.out.matches("You have had all hints to this answer").count(), 1, "{}", ran.out);
    let mut once = hints.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!((once.len(), hints.len()), (3, 3), "{hints:?}");
}

#[test]
fn the_demo_runs_twice_and_spares_what_it_did_not_make() {
    let room = Room::new(&[]);
    let dir = room.path("demo");
    let first = run(&["demo", &dir]);
    assert_eq!((first.exit, first.err.as_str()), (Exit::Fine, ""));
    let files = tree(Path::new(&dir));
    let second = run(&["demo", &dir]);
    assert_eq!(second.out, first.out);
    assert!(files == tree(Path::new(&dir)));
    // Where to look, and a line for every two students.
    assert!(first.out.lines().count() <= 25, "{}", first.out);
    assert!(
        first.out.contains("grades/index.html") && first.out.contains("Zoë van der Berg"),
        "{}",
        first.out
    );
    // Everything that may become of an answer is met, and got the verdict that it should.
    let rows = |name: &str| -> Vec<BTreeMap<String, String>> {
        let mut reader = csv::Reader::from_path(room.path(name)).unwrap();
        reader.deserialize().map(Result::unwrap).collect()
    };
    let (truth, answers) = (rows("demo/truth.csv"), rows("demo/grades/answers.csv"));
    assert_eq!(truth.len(), answers.len());
    for kind in TrueKind::ALL {
        let of_kind = truth.iter().filter(|row| row["kind"] == kind.as_str()).count();
        assert!(of_kind >= 5, "{}: {of_kind}", kind.as_str());
    }
    for (truth, graded) in truth.iter().zip(&answers) {
        let verdict = &graded["verdict"];
        assert!(*verdict == truth["verdict"] || verdict == "superseded", "{truth:?} {graded:?}");
    }
    let met = |column: &str, what: &str| answers.iter().any(|row| row[column].contains(what));
    assert!(met("credit", "late:") && met("credit", "follow:") && met("verdict", "superseded"));
    let test = fs::read_to_string(room.path("demo/self-test.txt")).unwrap();
    assert!(test.starts_with("What the simulated rows were"), "{test}");
    room.write("demo/mine.txt", "mine");
    assert_eq!(run(&["demo", &dir]).exit, Exit::Faulty);
    fs::create_dir(room.path("thesis")).unwrap();
    room.write("thesis/a.txt", "mine");
    assert_eq!(run(&["demo", &room.path("thesis")]).exit, Exit::Faulty);
}

/// The browser gets the page as an address of its own; where there is no browser, that is said and is no fault.
#[test]
#[cfg(target_os = "linux")]
fn a_page_is_opened() {
    use std::os::unix::fs::PermissionsExt as _;
    let room = Room::new(&[]);
    let opened = room.path("opened.txt");
    fs::create_dir(room.path("bin")).unwrap();
    room.write(
        "bin/xdg-open",
        &format!("#!/bin/sh\nprintf '%s' \"$1\" > '{opened}.part'\nmv '{opened}.part' '{opened}'\n"),
    );
    fs::set_permissions(room.path("bin/xdg-open"), fs::Permissions::from_mode(0o755)).unwrap();
    let slipstick = |bin: &str, args: &[&str]| {
        let program = assert_cmd::cargo::cargo_bin("slipstick");
        let ran = std::process::Command::new(program)
            .args(args)
            .env("PATH", bin)
            .current_dir(room.path(""))
            .output();
        let ran = ran.unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        String::from_utf8(ran.stderr).unwrap()
    };
    let bin = format!("{}:/usr/bin:/bin", room.path("bin"));
    room.write("r.csv", "student\ns1\n");
    room.write("a.csv", "student,problem,part,answer\ns1,1,v,3 m/s\n");
    let made = [
        "generate",
        "slip-and-roll",
        "--problems",
        "thrown-ball",
        "--roster",
        "r.csv",
        "--seed",
        "1",
        "--out",
        "set",
        "--open",
    ];
    for (args, page) in [
        (&made[..], "set/index.html"),
        (&["grade", "set", "a.csv", "--out", "grades", "--open"], "grades/index.html"),
        (&["demo", "--open"], "slipstick-demo/grades/index.html"),
    ] {
        assert_eq!(slipstick(&bin, args), "", "{args:?}");
        let shown = (0..500).find_map(|_| {
            std::thread::sleep(std::time::Duration::from_millis(20));
            fs::read_to_string(&opened).ok()
        });
        let shown = fs::canonicalize(shown.expect("the browser was called")).unwrap();
        assert_eq!(shown, fs::canonicalize(room.path(page)).unwrap());
        fs::remove_file(&opened).unwrap();
    }
    let told =
        slipstick(&room.path("nothing"), &["grade", "set", "a.csv", "--out", "grades", "--force", "--open"]);
    assert!(
        told.contains("grades/index.html cannot be shown") && told.contains("open it in a browser"),
        "{told}"
    );
}

#[test]
fn what_is_typed_wrong_is_explained() {
    for args in [&["generate"][..], &["no-such-verb"], &["solve", "a", "b", "--seed", "x"], &[]] {
        let ran = run(args);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""), "{args:?}");
        assert!(ran.err.contains("--help") || ran.err.contains("Usage: slipstick"), "{}", ran.err);
    }
    for verb in [
        "generate",
        "grade",
        "check",
        "practice",
        "solve",
        "lint",
        "verify",
        "solutions",
        "templates",
        "demo",
    ] {
        let ran = run(&[verb, "--help"]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        assert!(verb != "generate" || ran.out.contains("required unless --add"), "{}", ran.out);
        assert!(ran.out.contains("Example"), "{verb} teaches by example");
    }
}

#[test]
fn rosters_are_checked() {
    let room = Room::new(&["a", "b", "a"]);
    let ran = room.generate("roster.csv", "set", &[]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(room.shown(&ran.err).contains("ROOM/roster.csv:4"), "{}", ran.err);
    assert!(!Path::new(&room.path("set")).exists());
    let none = room.generate("nowhere.csv", "set", &[]);
    assert!(none.err.contains("there is no such file"), "{}", none.err);
}

#[test]
fn the_program_itself_exits_with_these_codes() {
    let room = Room::new(&CLASS[..1]);
    let slipstick = || assert_cmd::Command::cargo_bin("slipstick").unwrap();
    slipstick()
        .args(["generate", "wheels-on-inclines", "--seed", "7", "--roster"])
        .arg(room.path("roster.csv"))
        .arg("--out")
        .arg(room.path("set"))
        .assert()
        .code(0);
    slipstick().arg("check").arg(room.path("set/students/0017/sheet.json")).arg("2.v=1 m/s").assert().code(1);
    slipstick().args(["lint", "nowhere"]).assert().code(2);
    let mut args = vec!["solve", "wheels-on-inclines", "pulled-rolling"];
    args.extend(&ROLLING[..14]);
    args.extend(["--set", "mu_s=0.1"]);
    slipstick().args(&args).assert().code(3);
}

/// What cannot be told is an error, whatever the length of it; a reader who went away is none.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_behind_standard_output_is_told() {
    use std::process::Command;
    let room = Room::new(&CLASS[..1]);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    room.write("in.csv", "student,problem,part,answer\n0017,1,v,3\n");
    let (set, answers, out) = (room.path("set"), room.path("in.csv"), room.path("out"));
    for args in [
        &["course"][..],
        &["--help"],
        &["lint", "wheels-on-inclines"],
        &["grade", &set, &answers, "--out", &out],
        &["report", &out, "--force"],
        &["explain", &out, "0017", "1"],
        &["what-if", &out],
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let ran = Command::new(env!("CARGO_BIN_EXE_slipstick")).args(args).stdout(full).output().unwrap();
        let err = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(2), "{args:?} {err}");
        assert!(err.contains("standard output: cannot be written: the disk is full"), "{args:?} {err}");
    }
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let ran = Command::new(env!("CARGO_BIN_EXE_slipstick")).arg("course").stdout(writer).output().unwrap();
    assert_eq!((ran.status.code(), ran.stderr.as_slice()), (Some(0), &b""[..]));
}

#[test]
#[cfg(unix)]
fn a_killed_run_leaves_nothing_that_looks_like_a_set() {
    use std::process::Command;
    use std::thread;
    use std::time::Duration;
    let room = Room::new(&[]);
    let many: Vec<String> = (0..2000).map(|i| format!("s{i}")).collect();
    room.roster("many.csv", &many.iter().map(String::as_str).collect::<Vec<_>>());
    let program = assert_cmd::cargo::cargo_bin("slipstick");
    let (mut whole, mut nothing) = (0, 0);
    for wait in [5, 40, 120, 300] {
        let out = room.path(&format!("set{wait}"));
        let mut child = Command::new(&program)
            .args([
                "generate",
                "wheels-on-inclines",
                "--seed",
                "1",
                "--roster",
                &room.path("many.csv"),
                "--out",
                &out,
            ])
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        thread::sleep(Duration::from_millis(wait));
        child.kill().unwrap();
        child.wait().unwrap();
        if Path::new(&out).exists() {
            let set: serde_json::Value =
                serde_json::from_str(&room.read(&format!("set{wait}/set.json"))).unwrap();
            assert_eq!(set["students"].as_array().unwrap().len(), 2000);
            assert_eq!(fs::read_dir(format!("{out}/students")).unwrap().count(), 2000);
            whole += 1;
        } else {
            nothing += 1;
        }
    }
    assert_eq!(whole + nothing, 4);
}

mod mutants {
    //! Files that a person may have broken: any bytes give findings or a result, never a panic.
    use super::*;
    use proptest::prelude::*;
    use slipstick::page::sheet_file::SheetFile;
    use slipstick::set::store::StoredSet;
    use std::sync::LazyLock;

    /// set.json and sheet.json of a small set.
    static TEXTS: LazyLock<(String, String)> = LazyLock::new(|| {
        let room = Room::new(&CLASS[..1]);
        assert_eq!(room.generate("roster.csv", "set", &["--problems", "pulled-rolling"]).exit, Exit::Fine);
        (room.read("set/set.json"), room.read("set/students/0017/sheet.json"))
    });

    fn broken(text: &str, changes: &[(usize, String)]) -> String {
        let mut chars: Vec<char> = text.chars().collect();
        for (at, new) in changes {
            let at = at % chars.len();
            let end = (at + new.chars().count().max(1)).min(chars.len());
            chars.splice(at..end, new.chars());
        }
        chars.into_iter().collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]
        #[test]
        fn a_broken_set_or_sheet_is_a_finding(
            changes in proptest::collection::vec((any::<usize>(), "[\\PC]{0,3}|[0-9e.,:{}\"\\[\\]-]{0,4}"), 1..4)
        ) {
            let _ = StoredSet::parse(&broken(&TEXTS.0, &changes));
            let sheet = broken(&TEXTS.1, &changes);
            if let Ok(file) = SheetFile::parse(&sheet) {
                for problem in &file.problems {
                    let _ = problem.bank_tree();
                }
            }
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("sheet.json");
            fs::write(&path, &sheet).unwrap();
            let ran = run(&["check", &path.display().to_string(), "1.v=1 m/s", "1.friction=3 N up"]);
            prop_assert!(ran.exit != Exit::RegimeFails);
            prop_assert!(!ran.err.is_empty() || !ran.out.is_empty());
        }
    }
}

#[test]
fn the_set_records_tries_and_which_rule_refused_them() {
    let roster: Vec<String> = (0..60).map(|i| format!("s{i}")).collect();
    let roster: Vec<&str> = roster.iter().map(String::as_str).collect();
    let room = Room::new(&roster);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    let set: serde_json::Value = serde_json::from_str(&room.read("set/set.json")).unwrap();
    let mut redrawn = 0;
    for student in set["students"].as_array().unwrap() {
        for problem in student["problems"].as_array().unwrap() {
            let refused = problem["refused"]
                .as_object()
                .map_or(0, |rules| rules.values().map(|count| count.as_u64().unwrap()).sum());
            assert_eq!(problem["tries"].as_u64().unwrap(), refused + 1, "{problem}");
            redrawn += u64::from(refused > 0);
        }
    }
    assert!(redrawn > 10, "{redrawn}");
}

const PULLED: [&str; 18] = [
    "wheels-on-inclines",
    "pulled-rolling",
    "--set",
    "m=40kg",
    "--set",
    "R=200mm",
    "--set",
    "r=100mm",
    "--set",
    "k=150mm",
    "--set",
    "theta=15",
    "--set",
    "P=100N",
    "--set",
    "d=3m",
    "--set",
    "mu_s=0.5",
];

fn pulled(verb: &str, more: &[&str]) -> Ran {
    let mut args = vec![verb];
    args.extend(PULLED);
    args.extend(more);
    run(&args)
}

#[test]
fn solve_says_which_method_it_took_and_why() {
    let ran = pulled("solve", &[]);
    assert_eq!(ran.exit, Exit::Fine);
    assert!(ran.out.contains("\nmethod: closed form (auto): the forces are the same all the way, so the closed form is exact and nothing is cheaper\n"));
    assert!(!ran.out.contains("est. error"));
    let ran = pulled("solve", &["--method", "euler", "--step", "1/60s"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.contains("method: euler, 1/60 s: as asked; work and energy judge it; "), "{}", ran.out);
    assert!(ran.out.contains("est. error"));
    let json: serde_json::Value =
        serde_json::from_str(&pulled("solve", &["--json", "--method", "dop853", "--rtol", "1e-9"]).out)
            .unwrap();
    assert_eq!(json["method"]["name"], "dop853");
    assert_eq!(json["method"]["chosen"], false);
    assert!(json["method"]["evaluations"].as_u64().unwrap() > 10);
    assert!(json["quantities"]["v"]["error"].as_f64().unwrap() < 1e-9);
    let json: serde_json::Value = serde_json::from_str(&pulled("solve", &["--json"]).out).unwrap();
    assert_eq!(json["method"]["name"], "closed");
    assert!(json["method"]["relative_error"].is_null() && json["quantities"]["v"].get("error").is_none());
}

#[test]
fn a_method_that_does_not_fit_is_refused() {
    for (more, message) in [
        (
            &["--method", "rk4", "--rtol", "1e-9"][..],
            "error: --rtol: the method steps at a fixed length and has no tolerance",
        ),
        (&["--step", "1ms"], "error: --step: only euler, verlet and rk4 have a step of fixed length"),
        (&["--method", "rk4", "--step", "1kg"], "error: --step: `1kg`: expected s"),
        (&["--method", "rk4", "--step", "0"], "error: --step: `0` is no step"),
        (&["--method", "rk4", "--step", "1/0s"], "error: --step: `1/0s` is no step"),
        (&["--rtol", "2"], "error: --rtol: 2.0000 is no tolerance"),
        (&["--method", "rk4", "--step", "1e-300"], "error: pulled-rolling: rk4: would need"),
    ] {
        let ran = pulled("solve", more);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""), "{more:?}");
        assert!(ran.err.starts_with(message), "{more:?}: {}", ran.err);
    }
}

#[test]
fn accuracy_prints_and_writes_the_same_every_time() {
    let room = Room::new(&[]);
    let folder = room.path("trade");
    let ran = pulled("accuracy", &["--no-time", "--out", &folder]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let lines: Vec<&str> = ran.out.lines().collect();
    assert!(lines[1].starts_with("auto takes the closed form: "), "{}", ran.out);
    assert_eq!(lines[3].split_whitespace().next(), Some("method"));
    assert!(lines[4].trim_start().starts_with("*       closed  doubles "), "{}", ran.out);
    assert!(lines[5].trim_start().starts_with("* auto  closed  32 digits "), "{}", ran.out);
    let files = tree(&room.0.path().join("trade"));
    assert_eq!(
        files.keys().map(String::as_str).collect::<Vec<_>>(),
        ["accuracy.csv", "accuracy.html", "accuracy.svg"]
    );
    let html = room.read("trade/accuracy.html");
    assert!(html.contains("<svg") && html.contains("Asked and given") && !html.contains("NaN"));
    assert!(
        room.read("trade/accuracy.csv")
            .starts_with("problem,method,setting,step_s,rtol,points,evaluations,steps,error of omega,")
    );
    // Constant acceleration: every formula but Euler's is exact.
    let csv = room.read("trade/accuracy.csv");
    let rows: Vec<Vec<&str>> = csv.lines().map(|l| l.split(',').collect()).collect();
    let worst = rows[0].iter().position(|h| *h == "worst error").unwrap();
    for row in &rows[1..] {
        let error: f64 = row[worst].parse().unwrap();
        assert!(if row[1] == "euler" { error > 1e-6 } else { error < 1e-14 }, "{row:?}");
    }
    // Again: refused, then the same bytes.
    let again = pulled("accuracy", &["--no-time", "--out", &folder]);
    assert_eq!((again.exit, again.out.as_str()), (Exit::Faulty, ""));
    assert!(
        again.err.contains("is there already") && again.err.contains("--force replaces it"),
        "{}",
        again.err
    );
    let again = pulled("accuracy", &["--no-time", "--out", &folder, "--force"]);
    assert_eq!((again.exit, again.out), (Exit::Fine, ran.out));
    assert_eq!(tree(&room.0.path().join("trade")), files);
    // Single files; nothing is written if one cannot be.
    let (csv, odd) = (room.path("a.csv"), room.path("a.pdf"));
    let ran = pulled("accuracy", &["--no-time", "--out", &csv, "--out", &odd]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(
        ran.err.contains("files of the kind .pdf are not written") && !Path::new(&csv).exists(),
        "{}",
        ran.err
    );
    // With the clock there is a column of times.
    let ran = run(&["accuracy", "wheels-on-inclines", "spring-released", "--seed", "5", "--out", &csv]);
    assert_eq!(ran.exit, Exit::Fine);
    assert!(
        ran.out.lines().nth(3).is_some_and(|l| l.contains(" time "))
            && room.read("a.csv").contains(",seconds,")
    );
    let ran = run(&["accuracy", "wheels-on-inclines", "kinetic-energy", "--seed", "5"]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""));
    assert!(ran.err.contains("nothing moves, there is nothing to compare"), "{}", ran.err);
}

/// A command with data.
fn with_data(command: &[&str], data: &str) -> Ran {
    let mut line = command.to_vec();
    for datum in data.split(' ') {
        line.extend(["--set", datum]);
    }
    run(&line)
}

#[test]
fn accuracy_says_when_the_regime_fails() {
    let data = "m=40kg R=200mm r=100mm k=150mm theta=15 P=100N d=3m mu_s=0.1";
    let ran = with_data(&["accuracy", "wheels-on-inclines", "pulled-rolling", "--no-time"], data);
    assert_eq!(ran.exit, Exit::RegimeFails);
    assert!(ran.out.contains("\nregime: ") && ran.out.contains("\n  FAILS  no_slip"), "{}", ran.out);
    for (from, to) in [(10, 351), (0, 90)] {
        let data = format!("m=4kg L=1m phi0={from} phi1={to}");
        let ran = with_data(&["accuracy", "pinned-bodies", "falling-rod", "--no-time"], &data);
        assert_eq!(ran.exit, Exit::RegimeFails);
        assert!(ran.out.contains("nothing to compare") && !ran.out.contains('*'), "{}", ran.out);
    }
}

#[test]
fn a_run_past_an_unstable_point_ends_soon() {
    let data = "m=4kg h=300mm k=200mm phi0=179 phi1=10";
    let ran = with_data(&["accuracy", "pinned-bodies", "compound-pendulum", "--no-time"], data);
    assert!(ran.out.contains("goes past the end without meeting it"), "{}", ran.out);
    assert!(!ran.out.contains("given up"), "{}", ran.out);
}

#[test]
fn a_tolerance_that_is_not_met_is_told() {
    let raised = pulled("solve", &["--method", "dopri5", "--rtol", "1e-300"]).out;
    assert!(raised.contains("the tolerance 1e-300 was raised to 2e-15"), "{raised}");
    let unmet = pulled("solve", &["--method", "gauss", "--rtol", "1e-300"]).out;
    assert!(unmet.contains("the tolerance 1e-300 is not met"), "{unmet}");
}

#[test]
fn verify_proves_a_set_and_sees_what_does_not_belong() {
    let room = Room::new(&CLASS[..2]);
    assert_eq!(room.generate("roster.csv", "set", &[]).exit, Exit::Fine);
    let verify = || run(&["verify", &room.path("set")]);
    let fine = verify();
    assert_eq!((fine.exit, fine.err.as_str()), (Exit::Fine, ""));
    assert!(
        fine.out.contains("are enclosed: the true answer for the printed data lies within"),
        "{}",
        fine.out
    );
    let key = room.read("set/key.csv");
    room.write("set/key.csv", &format!("{key}0099,1,omega,1,rad/s,1,1,0,1,0.01,1e-14\n"));
    let strange = verify();
    assert_eq!(strange.exit, Exit::Faulty);
    assert!(strange.err.contains("has rows of students who are not in the set"), "{}", strange.err);
    let row = key.lines().nth(1).unwrap();
    room.write("set/key.csv", &key.replace(row, &row.replacen("0.", "1.", 1)));
    assert_eq!(verify().exit, Exit::Faulty);
    assert_eq!(run(&["verify", &room.path("none")]).exit, Exit::Faulty);
}

/// Sets of this way of drawing have been made whose key.csv has no codes.
#[test]
fn a_key_without_codes_holds_as_it_was_written() {
    let room = Room::new(&CLASS[..2]);
    room.write("early.csv", "student,name\n0017,Name of 0017\n");
    assert_eq!(room.generate("early.csv", "set", &[]).exit, Exit::Fine);
    let key = room.read("set/key.csv");
    let rows = key.lines().map(|line| line.rsplit_once(',').unwrap().0);
    let older: String = rows.map(|row| format!("{row}\n")).collect();
    assert!(older.starts_with("student,") && !older.contains("code"));
    room.write("set/key.csv", &older);
    let verify = || run(&["verify", &room.path("set")]);
    assert_eq!((verify().exit, verify().err.as_str()), (Exit::Fine, ""));
    room.write("in.csv", "student,problem,part,answer\n0017,1,x_G,18\n");
    let grade =
        || run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &room.path("grades"), "--force"]);
    assert_eq!(grade().exit, Exit::Fine, "{}", grade().err);
    let explain = run(&["explain", &room.path("grades"), "0017", "1.x_G"]);
    assert_eq!((explain.exit, explain.err.as_str()), (Exit::Fine, ""));
    // One that was edited is seen all the same.
    room.write("set/key.csv", &older.replacen(",m,", ",m,1", 1));
    assert_eq!(verify().exit, Exit::Faulty);
    // A set that grows gets codes, and the hash of its key stays true.
    room.write("set/key.csv", &older);
    assert_eq!(room.generate("early.csv", "set", &["--add"]).exit, Exit::Fine);
    assert_eq!(room.read("set/key.csv"), older, "nothing was to be mended");
    assert_eq!(room.generate("roster.csv", "set", &["--add"]).exit, Exit::Fine);
    assert_eq!(room.generate("roster.csv", "anew", &[]).exit, Exit::Fine);
    assert_eq!(room.read("set/key.csv"), room.read("anew/key.csv"));
    assert!(room.read("set/set.json") == room.read("anew/set.json"), "its hash is that of another key");
}

/// Names of files below a folder, sorted.
fn names(room: &Room, folder: &str) -> Vec<String> {
    tree(&room.0.path().join(folder)).into_keys().collect()
}

#[test]
fn formats_are_those_asked_for() {
    let room = Room::new(&CLASS[..2]);
    let one = ["--problems", "pulled-rolling"];
    let generate = |out: &str, more: &[&str]| {
        let ran = room.generate("roster.csv", out, &[&one[..], more].concat());
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""), "{out}");
        ran
    };
    let ran = generate("latex", &["--format", "tex,md"]);
    assert!(ran.out.contains("(sheet.tex, sheet.md, sheet.json); nothing else"), "{}", ran.out);
    assert!(ran.out.contains("latex/booklet.tex (all sheets)"), "{}", ran.out);
    assert_eq!(names(&room, "latex/students/0017"), ["problem-1.svg", "sheet.json", "sheet.md", "sheet.tex"]);
    assert!(!names(&room, "latex").contains(&"booklet.html".to_owned()));
    generate("page", &["--format", " HTML, html"]);
    assert_eq!(names(&room, "page/students/0017"), ["sheet.html", "sheet.json"]);
    // The page needs no other file, the booklet has both students, and the answers stand in neither.
    let page = room.read("page/students/0017/sheet.html");
    assert!(page.contains("<svg") && page.contains("<math") && !page.contains("src="));
    let booklet = room.read("page/booklet.html");
    assert!(booklet.contains("Name of 0017 (0017)") && booklet.contains("Name of Ana (Ana)"));
    // Late joiners get the formats of the set, and other ones are refused.
    room.roster("more.csv", &CLASS[..3]);
    let ran = room.generate("more.csv", "latex", &["--add"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert_eq!(room.read("latex/booklet.tex").matches(r"\setcounter{page}{1}").count(), 3);
    let ran = room.generate("more.csv", "latex", &["--add", "--format", "html"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("formats: the set has md,tex, this command html"), "{}", ran.err);
    // Another run in other formats replaces the set; nothing of the old formats stays.
    generate("latex", &["--format", "html", "--force"]);
    assert_eq!(names(&room, "latex/students/0017"), ["sheet.html", "sheet.json"]);
    let ran = room.generate("roster.csv", "none", &["--format", "docx"]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""));
    assert!(!Path::new(&room.path("none")).exists());
}

#[test]
#[cfg(not(feature = "pdf"))]
fn without_pdf_one_line_says_how_to_get_it() {
    let room = Room::new(&CLASS[..1]);
    let ran = room.generate("roster.csv", "set", &["--format", "pdf"]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""));
    assert!(ran.err.contains("--features pdf"), "{}", ran.err);
    assert!(!Path::new(&room.path("set")).exists());
}

/// Where no word gives the sign, a sheet says what it means, once; and which turn is forward.
#[test]
fn sheets_say_what_a_sign_means_without_a_word() {
    let room = Room::new(&CLASS[..1]);
    room.write(
        "bank.yaml",
        "bank: b
title: B
cond limit: 1000
problems:
  p:
    title: P
    data: {m: {name: mass, unit: kg, draw: always 3}}
    scene:
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from upright}}
      start: {B: {angle: 30 deg, spin: 8 rad/s}}
      end: at once
    questions:
      pin_radial: {ask: along, unit: N}
      pin_tangential: {ask: 'across, positive in the sense of a growing angle', unit: N}
    statement: '{{ m }} and so on'
  q:
    title: Q
    data: {m: {name: mass, unit: kg, draw: always 3}}
    scene:
      bodies:
        D: {mass: m, radius of gyration: 0.2 m, radii: {rim: 0.3 m}, moves: about a fixed axle}
      ties:
      - cord: {from: {body: D, wound on: rim, leaves: top forward}, pulled with: 5 N}
      start: at rest
      end: {turn: {of: D, by: 2 rad}}
    questions: {direction: {ask: direction}}
    statement: '{{ m }} and so on'
  r:
    title: R
    data: {m: {name: mass, unit: kg, draw: always 3}}
    scene:
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from upright}}
      start: {B: {angle: 30 deg, spin: -1 rad/s}}
      end: {turning point: B}
    questions: {angle: {ask: the angle there, unit: deg}}
    statement: '{{ m }} and so on'
",
    );
    for (language, said) in [
        (
            "en",
            [
                "`1.pin_radial`, in\u{a0}N, positive toward the pin\n",
                "`1.pin_tangential`, in\u{a0}N\n",
                "`2.direction`, `forward` or `back`, a clockwise turn is `forward`",
                "in\u{a0}deg, signed (positive: clockwise) or with `clockwise` / `counter-clockwise`, counted clockwise from straight up",
            ],
        ),
        (
            "de",
            [
                "`1.pin_radial`, in\u{a0}N, positiv zum Lager hin\n",
                "`1.pin_tangential`, in\u{a0}N, positiv im Sinn eines wachsenden Winkels\n",
                "eine Drehung im Uhrzeigersinn ist `vorwärts`",
                "in\u{a0}deg, mit Vorzeichen (positiv: im Uhrzeigersinn) oder mit `im Uhrzeigersinn` / `gegen den Uhrzeigersinn`, von oben aus im Uhrzeigersinn gezählt",
            ],
        ),
    ] {
        let [bank, roster, out] = ["bank.yaml", "roster.csv", language].map(|name| room.path(name));
        let all = ["generate", &bank, "--roster", &roster, "--seed", "1", "--out", &out, "--format", "md"];
        let ran = run(&[&all[..], &["--language", language]].concat());
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        let sheet = room.read(&format!("{language}/students/0017/sheet.md"));
        for words in said {
            assert!(sheet.contains(words), "{words}: {sheet}");
        }
    }
}

#[test]
fn sheets_and_feedback_in_german() {
    let room = Room::new(&CLASS[..1]);
    let german = ["--language", "de", "--problems", "pulled-rolling"];
    let ran = room.generate("roster.csv", "set", &german);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let sheet = room.read("set/students/0017/sheet.md");
    for words in [
        "# Räder auf schiefen Ebenen",
        "Haftreibungszahl",
        "**Gesucht**",
        "`aufwärts` / `abwärts`",
        "2 Punkte",
    ] {
        assert!(sheet.contains(words), "{words}: {sheet}");
    }
    assert!(sheet.contains(r"$k = 0{,}") && !sheet.contains(r"$k = 0."), "{sheet}");
    assert!(room.read("set/students/0017/sheet.html").contains("<html lang=\"de\">"));
    // The draw does not depend on the language.
    assert_eq!(room.generate("roster.csv", "english", &["--problems", "pulled-rolling"]).exit, Exit::Fine);
    assert_eq!(room.read("set/key.csv"), room.read("english/key.csv"));
    // The sheet knows its language, and so does the set; another one may be asked for.
    let file = room.path("set/students/0017/sheet.json");
    let ran =
        run(&["check", &file, "1.omega=3 N", "1.friction=1 N hinunter", "1.v=vier", "1.k_bound=0,00001"]);
    assert_eq!(ran.exit, Exit::NotAllRight);
    for words in [
        "erwartet rad/s (Winkelgeschwindigkeit), gefunden N (Kraft)",
        "weder eine Zahl noch ein bekanntes Wort",
        "nicht innerhalb der Toleranz",
    ] {
        assert!(ran.out.contains(words), "{words}: {}", ran.out);
    }
    let (friction, _) = key_of(&room, "0017", "1", "friction");
    let size = friction.trim_start_matches('-').replace('.', ",");
    let word = if friction.starts_with('-') { "abwärts" } else { "hinauf" };
    let ran = run(&["check", &file, &format!("1.friction={size} N {word}")]);
    assert_eq!((ran.exit, ran.out.contains("innerhalb der Toleranz")), (Exit::Fine, true), "{}", ran.out);
    room.write("in.csv", "student,problem,part,answer\n0017,1,v,x\n0017,1,v,y\n17,1,v,1\n0017,1,vv,1\n");
    let grade = |out: &str, more: &[&str]| {
        let (set, answers, out_path) = (room.path("set"), room.path("in.csv"), room.path(out));
        let ran = run(&[&["grade", &set, &answers, "--out", &out_path][..], more].concat());
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        room.read(&format!("{out}/answers.csv"))
    };
    let german = grade("de", &[]);
    for words in [
        "superseded,0,1,ersetzt durch Zeile 3; wäre sonst unreadable: weder eine Zahl noch ein bekanntes Wort",
        "steht nicht auf der Liste; ist 0017 gemeint?",
        "keine Teilaufgabe `vv`; Teilaufgaben: ",
    ] {
        assert!(german.contains(words), "{words}: {german}");
    }
    assert!(grade("en", &["--language", "en"]).contains("superseded by line 3; would have been unreadable"));
    let ran = room.generate("roster.csv", "none", &["--language", "fr"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert_eq!(ran.err, "error: --language: there is no language `fr`\n    hint: languages: en, de\n");
    let ran = run_with(&["practice", "slip-and-roll", "--seed", "3", "--language", "de"], "xyz\nquit\n");
    assert!(
        ran.out.contains("Reibungskraft") && ran.out.contains("Eine leere Zeile überspringt"),
        "{}",
        ran.out
    );
    // A changed question of a bank is not shown as the old one in translation.
    let bank = include_str!("../../banks/wheels-on-inclines.yaml");
    room.write(
        "bank.yaml",
        &bank.replace("the speed $v$ of its centre at that instant", "the speed of $G$ after all"),
    );
    let (path, roster, out) = (room.path("bank.yaml"), room.path("roster.csv"), room.path("changed"));
    let ran =
        run(&["generate", &path, "--roster", &roster, "--seed", "7", "--out", &out, "--language", "de"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let sheet = room.read("changed/students/0017/sheet.md");
    assert!(
        sheet.contains("the speed of $G$ after all") && sheet.contains("die Winkelgeschwindigkeit $\\omega$"),
        "{sheet}"
    );
}

#[test]
fn templates_are_written_out_and_do_the_same() {
    let room = Room::new(&CLASS[..1]);
    for language in Words::languages() {
        let (folder, plain, own) =
            (format!("t-{language}"), format!("p-{language}"), format!("o-{language}"));
        let path = room.path(&folder);
        let ran = run(&["templates", "--out", &path, "--language", language]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        let listed = names(&room, &folder);
        for name in [
            "README.md",
            "banks/pinned-bodies.yaml",
            "sheet.md",
            "statement/pulled-rolling.md",
            "words/sheet.yaml",
        ] {
            assert!(listed.iter().any(|n| n == name), "{name}");
        }
        let readme = room.read(&format!("{folder}/README.md"));
        for name in listed.iter().filter(|n| *n != "README.md") {
            let told = match name.split_once('/') {
                Some(("solution", _)) | None => readme.contains(&format!("## {name}\n")),
                Some((folder, _)) => readme.contains(&format!("## {folder}/*\n")),
            };
            assert!(told, "{name} is explained");
        }
        // Unchanged they do what the built-in ones do.
        let formats = ["--format", "md,html,tex", "--language", language];
        assert_eq!(room.generate("roster.csv", &plain, &formats).exit, Exit::Fine);
        let mine = [&formats[..], &["--templates", &path]].concat();
        let ran = room.generate("roster.csv", &own, &mine);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        assert!(tree(&room.0.path().join(&plain)) == tree(&room.0.path().join(&own)), "{language}");
        // What is there is not replaced.
        assert_eq!(run(&["templates", "--out", &path]).exit, Exit::Faulty);
    }
    assert_eq!(run(&["templates", "--out", &room.path("x"), "--language", "xx"]).exit, Exit::Faulty);
}

#[test]
fn broken_templates_and_lists_are_told_with_their_place() {
    let room = Room::new(&CLASS[..1]);
    for (file, text, says) in [
        ("sheet.md", "# Sheet\n\n{{ nosuch }}\n", "ROOM/mine/sheet.md:3:4: template: "),
        (
            "questions.md",
            "Find $\\nosuchcommand{x}$.\n",
            "problems.pulled-rolling: formula `$\\nosuchcommand{x}$`: ",
        ),
        ("sheet.html", "<p>\n{% if %}\n", "ROOM/mine/sheet.html:2:"),
        ("sheet.tex", "\\begin{document}\n{{ body }\n", "ROOM/mine/sheet.tex:2:"),
        ("booklet.html", "{{ titel }}", "ROOM/mine/booklet.html:1:4: template: "),
        ("key-table.md", "# Key\n{{ sets }}", "ROOM/mine/key-table.md:2:4: template: "),
        (
            "words/sheet.yaml",
            "up: up\npionts: x\n",
            "ROOM/mine/words/sheet.yaml:2:9: sheet.pionts: is no phrase of the program",
        ),
        ("words/sheet.yaml", "points: '{m} points'\n", "has a place {m} that nothing fills"),
        ("words/sheat.yaml", "up: up\n", "ROOM/mine/words/sheat.yaml: there is no word list `sheat`"),
        (
            "banks/wheels-on-inclines.yaml",
            "title: Räder\nproblems:\n  pulled-roling: {title: X}\n",
            "ROOM/mine/banks/wheels-on-inclines.yaml:3:3: problems.pulled-roling: the bank has no problem `pulled-roling`\n    hint: did you mean `pulled-rolling`?",
        ),
        (
            "banks/wheels-on-inclines.yaml",
            "problems: {pulled-rolling: {ask: {omeg: x}, data: {q: y}, titel: z}}\n",
            "the problem asks no `omeg`\n    hint: did you mean `omega`?",
        ),
        (
            "banks/wheels-on-inclines.yaml",
            "problems: {pulled-rolling: {ask: {v: '{{ vv }}'}}}\n",
            "`{{ vv }}` is not known",
        ),
    ] {
        let path = Path::new(&room.path("mine")).join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        let ran = room.generate(
            "roster.csv",
            "set",
            &["--templates", &room.path("mine"), "--format", "html,md,tex"],
        );
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""), "{file}");
        assert!(room.shown(&ran.err).contains(says), "{file}: {}", room.shown(&ran.err));
        assert!(!Path::new(&room.path("set")).exists());
        let lint = run(&["lint", "wheels-on-inclines", "--seeds", "2", "--templates", &room.path("mine")]);
        assert_eq!(lint.exit, Exit::Faulty);
        assert!(room.shown(&lint.err).contains(says), "{file}: {}", room.shown(&lint.err));
        fs::remove_dir_all(room.path("mine")).unwrap();
    }
    // The solutions are tried as well, before the sheets go out.
    fs::create_dir_all(room.path("mine/solution")).unwrap();
    room.write("mine/solution/default.md", "## {{ title }}\n{{ sectoins }}\n");
    let lint = run(&["lint", "wheels-on-inclines", "--seeds", "2", "--templates", &room.path("mine")]);
    assert_eq!(lint.exit, Exit::Faulty);
    assert!(room.shown(&lint.err).contains("ROOM/mine/solution/default.md:2:"), "{}", room.shown(&lint.err));
    fs::remove_dir_all(room.path("mine")).unwrap();
    // A folder for several languages: that of the sheet goes before the others.
    for (folder, text) in
        [("", "{{ body_of }}"), ("de/", "Blatt {{ title }} {% for p in problems %}{{ p.body }}{% endfor %}")]
    {
        fs::create_dir_all(room.path(&format!("mine/{folder}"))).unwrap();
        room.write(&format!("mine/{folder}sheet.md"), text);
    }
    let mine = ["--templates", &room.path("mine"), "--language", "de"];
    assert_eq!(room.generate("roster.csv", "set", &mine).exit, Exit::Fine);
    assert!(room.read("set/students/0017/sheet.md").starts_with("Blatt Räder auf schiefen Ebenen "));
}

#[test]
fn solutions_stand_apart_from_what_students_get() {
    let room = Room::new(&CLASS[..3]);
    assert_eq!(
        room.generate("roster.csv", "set", &["--problems", "pulled-rolling,kinetic-energy"]).exit,
        Exit::Fine
    );
    let set = room.path("set");
    let solve = |out: &str, more: &[&str]| {
        let path = room.path(out);
        run(&[&["solutions", &set, "--out", &path][..], more].concat())
    };
    let before = tree(&room.0.path().join("set"));
    let ran = solve("one", &["--threads", "1", "--format", "html,md,tex"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(ran.out.starts_with("Worked solutions for 3 students of 2 problems each"), "{}", ran.out);
    let files = names(&room, "one");
    for name in ["0017/solution.html", "0017/solution.md", "0017/solution.tex", "booklet.html", "booklet.tex"]
    {
        assert!(files.iter().any(|f| f == name), "{name}: {files:?}");
    }
    // Every figure that the Markdown names lies beside it, and no other.
    let markdown = room.read("one/0017/solution.md");
    for name in files.iter().filter_map(|f| f.strip_prefix("0017/").filter(|n| n.ends_with(".svg"))) {
        assert!(markdown.contains(&format!("]({name})")), "{name}");
    }
    assert_eq!(
        markdown.matches(".svg)").count(),
        files.iter().filter(|f| f.starts_with("0017/") && f.ends_with(".svg")).count()
    );
    // The answers of the key are those of the solution.
    let (omega, _) = key_of(&room, "0017", "1", "omega");
    let rounded: f64 = omega.parse().unwrap();
    assert!(markdown.contains(&format!("{rounded:.1}")), "{rounded}: {markdown}");
    // Whatever the threads, and a second time.
    assert_eq!(solve("two", &["--threads", "2", "--format", "html,md,tex"]).exit, Exit::Fine);
    assert!(tree(&room.0.path().join("one")) == tree(&room.0.path().join("two")));
    assert_eq!(solve("two", &["--format", "html"]).exit, Exit::Faulty);
    assert_eq!(solve("two", &["--format", "html", "--force"]).exit, Exit::Fine);
    assert!(!names(&room, "two").contains(&"0017/solution.md".to_owned()));
    room.write("two/mine.txt", "mine");
    let ran = solve("two", &["--force"]);
    assert!(ran.err.contains("holds what `slipstick solutions` did not make: mine.txt"), "{}", ran.err);
    // Never where students look, nor in the place of the set.
    for (out, says) in [
        ("set/students/0017", "is within the folder of what students get"),
        ("set/students/new/deep", "is within the folder of what students get"),
        ("set/students", "is within the folder of what students get"),
        ("set", "is the folder of a set"),
        ("roster.csv", "is a file"),
    ] {
        let ran = solve(out, &["--force"]);
        assert_eq!(ran.exit, Exit::Faulty);
        assert!(ran.err.contains(says), "{out}: {}", ran.err);
    }
    // Nor do others write there, whichever set it is.
    let page = room.path("set/students/0017/page.html");
    let (roster, folder) = (room.path("roster.csv"), room.path("set/students/set2"));
    let among: [&[&str]; 7] = [
        &["templates", "--out", &folder],
        &["generate", "slip-and-roll", "--roster", &roster, "--seed", "1", "--out", &folder],
        &["demo", &folder],
        &["gallery", "slip-and-roll", "--variants", "1", "--seeds", "1", "--out", &page],
        &["practice", "slip-and-roll", "--variants", "1", "--seed", "1", "--page", &page],
        &["accuracy", "wheels-on-inclines", "spring-released", "--seed", "5", "--no-time", "--out", &page],
        &["help", "--html", &page],
    ];
    for args in among {
        let ran = run(args);
        assert_eq!(ran.exit, Exit::Faulty, "{args:?}");
        assert!(ran.err.contains("is within the folder of what students get"), "{}", ran.err);
    }
    assert!(before == tree(&room.0.path().join("set")), "the set is untouched");
    // In another language.
    assert_eq!(solve("german", &["--language", "de", "--format", "md"]).exit, Exit::Fine);
    assert!(room.read("german/0017/solution.md").starts_with("# Lösungen: Räder auf schiefen Ebenen"));
    // A changed set has no solutions.
    room.write("set/bank.yaml", &room.read("set/bank.yaml").replacen("gravity: 9.81", "gravity: 9.80", 1));
    let ran = solve("three", &[]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("the bank copy was changed"), "{}", ran.err);
    assert!(!Path::new(&room.path("three")).exists());
}

#[test]
fn a_set_of_an_earlier_version_is_english_markdown_and_pages() {
    let room = Room::new(&CLASS[..2]);
    room.roster("more.csv", &CLASS[..3]);
    assert_eq!(room.generate("roster.csv", "set", &["--problems", "pulled-rolling"]).exit, Exit::Fine);
    let set = room.read("set/set.json");
    let old: String = set
        .lines()
        .filter(|l| !l.starts_with("  \"language\"") && !l.starts_with("  \"formats\""))
        .map(|l| format!("{l}\n"))
        .collect();
    assert!(old.len() < set.len());
    room.write("set/set.json", &old);
    room.write("in.csv", "student,problem,part,answer\n0017,1,v,x\n");
    let ran = run(&["grade", &room.path("set"), &room.path("in.csv"), "--out", &room.path("grades")]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(room.read("grades/answers.csv").contains("neither a number nor a known word"));
    let ran = room.generate("more.csv", "set", &["--add"]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    assert!(names(&room, "set").iter().filter(|n| n.ends_with("sheet.html")).count() == 3);
    assert_eq!(room.read("set/booklet.html").matches("<article").count(), 3);
}

/// The whole way through the street door: units that end in a digit, for the right kind of datum and for others. Only units
/// that end in a letter were typed before.
#[test]
fn typed_units_that_end_in_a_digit_are_read_and_checked() {
    let pulled = |more: &str| {
        let symbol = more.split('=').next();
        let data = ["m=40kg", "R=200mm", "r=100mm", "k=150mm", "theta=15", "P=100N", "d=3m", "mu_s=0.5"];
        let mut args = vec!["solve", "wheels-on-inclines", "pulled-rolling", "--json"];
        for text in data.iter().filter(|d| d.split('=').next() != symbol).chain([&more]) {
            args.extend(["--set", text]);
        }
        run(&args)
    };
    let metric = pulled("g=9.81456 m/s^2").out;
    assert!(metric.contains("\"omega\""), "{metric}");
    for text in ["g=32.2ft/s^2", "g=9.81456", "g=9.81456 m/s2", "g=9.81456m s^-2", "g=9814.56 mm/s²"] {
        assert_eq!(metric, pulled(text).out, "{text}");
    }
    for (text, found) in [("m=1.4 s^2", "found s^2"), ("m=1.4 m2", "(area)"), ("mu_s=0.5 m^2", "(area)")] {
        let ran = pulled(text);
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::Faulty, ""), "{text}");
        assert!(ran.err.contains(found), "{text}: {}", ran.err);
    }
}
