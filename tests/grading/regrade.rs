//! After grading: what other tolerances would change, grading again by a changed bank or course, and marks explained.
use crate::support;
use crate::support::program::{Ran, Room, run, tree};
use slipstick::cli::tell::Exit;
use slipstick::draw::stream::DRAW_VERSION;
use slipstick::set::store::{StoredBank, StoredSet, StoredStudent};
use slipstick::set::{dealer, given, key_file, store};
use std::fs;
use std::path::Path;

const STUDENTS: [&str; 6] = ["0017", "0023", "0031", "0044", "0058", "0062"];

impl Room {
    /// With a set of some students of the built-in wheels and a form of answers.
    fn new() -> Self {
        let room = Self::empty();
        let rows: String = STUDENTS.iter().map(|s| format!("{s},Name of {s}\n")).collect();
        room.write("roster.csv", &format!("student,name\n{rows}"));
        let ran = run(&[
            "generate",
            concat!(env!("CARGO_MANIFEST_DIR"), "/tests/regrade/wheel.yaml"),
            "--roster",
            &room.path("roster.csv"),
            "--seed",
            "7",
            "--name",
            "week",
            "--out",
            &room.path("set"),
        ]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        room
    }
    /// The key of a student's part, in the asked unit.
    fn key(&self, student: &str, part: &str) -> f64 {
        let key = self.read("set/key.csv");
        let row = key.lines().find(|l| l.starts_with(&format!("{student},1,{part},"))).unwrap();
        row.split(',').nth(3).unwrap().parse().unwrap()
    }
    /// By which factor the speeds of a student's wheel are too large without the weight.
    fn weight_left_out(&self, student: &str) -> f64 {
        let sheet = self.read(&format!("set/students/{student}/sheet.json"));
        let sheet: serde_json::Value = serde_json::from_str(&sheet).unwrap();
        let data = &sheet["problems"][0]["data"];
        let of = |symbol: &str| data[symbol]["value"].as_str().unwrap().parse::<f64>().unwrap();
        let pull = of("P") * (of("R") + of("r")) / of("r");
        (pull / (pull - of("m") * of("g") * of("theta").to_radians().sin())).sqrt()
    }
    /// Answers to 1.omega and 1.v: off the key by some per cent, each student by another.
    fn answers(&self) {
        let mut text = "student,problem,part,answer\n".to_owned();
        for (student, off) in STUDENTS.iter().zip([0.0, 0.4, 0.8, 1.5, 3.0, 20.0]) {
            for part in ["omega", "v"] {
                let value = self.key(student, part) * (1.0 + off / 100.0);
                text.push_str(&format!("{student},1,{part},{value:.5}\n"));
            }
        }
        self.write("answers.csv", &text);
    }
    fn grade(&self, more: &[&str]) -> Ran {
        let (set, answers, out) = (self.path("set"), self.path("answers.csv"), self.path("grades"));
        let mut args = vec!["grade", &set, &answers, "--out", &out];
        args.extend(more);
        let ran = run(&args);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        ran
    }
    fn regrade(&self, more: &[&str]) -> Ran {
        let (set, old, answers) = (self.path("set"), self.path("grades"), self.path("answers.csv"));
        let mut args = vec!["regrade", &set, &old, &answers];
        args.extend(more);
        run(&args)
    }
    /// The bank of the set with some changes.
    fn change(&self, changes: &[(&str, &str)]) {
        let mut bank = self.read("set/bank.yaml");
        for (from, to) in changes {
            assert!(bank.contains(from), "the bank has no `{from}`");
            bank = bank.replacen(from, to, 1);
        }
        self.write("bank.yaml", &bank);
    }
}

#[test]
fn other_tolerances_change_so_many_verdicts() {
    let room = Room::new();
    room.answers();
    // One student has left the weight out, which is some 3 % off.
    let student = STUDENTS[4];
    let mut answers = room.read("answers.csv");
    for part in ["omega", "v"] {
        let key = room.key(student, part);
        let row = |value: f64| format!("{student},1,{part},{value:.5}\n");
        answers = answers.replace(&row(key * 1.03), &row(key * room.weight_left_out(student)));
    }
    room.write("answers.csv", &answers);
    room.grade(&[]);
    let ran = run(&["what-if", &room.path("grades")]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
ROOM/grades: 12 answers that count of 6 students; answers that would become right (+) or no longer be right (-)
  part                                      tolerance now  0.5 %   1 %   2 %   5 %
  1.omega                                             1 %     -1     0    +1    +2
  1.v                                                 1 %     -1     0    +1    +2
  1.friction                                      2-2.8 %      0     0     0     0
  1.mu_required                                 1.8-2.7 %      0     0     0     0
  1.cord_travel                                       1 %      0     0     0     0
  1.k_bound                                           1 %      0     0     0     0
  all parts                                                   -2     0    +2    +4
  students who gain                                            0     0     1     2
  students who lose                                            1     0     0     0
  mean of totals                                     1.25   1.00  1.25  1.50  1.75
  answers of wrong methods that would pass                     0     0     0     2
  sheets where a wrong method would pass                       0     0     6    11
  warning: at 5 % 2 answers of a known wrong method would be right:
    2 x A10  Leaving the weight out.
  Absolute tolerances stay. All answers are graded anew by each: attempts, lateness, follow-through, corrections, totals.
"#);
    let ran = run(&["what-if", &room.path("grades"), "--tolerance", "2%,x,0"]);
    assert_eq!(ran.exit, Exit::Faulty);
    insta::assert_snapshot!(ran.err, @r#"
error: --tolerance: `x` is no tolerance
    hint: per cent, above 0 and at most 100, such as --tolerance 0.5,1,2%
error: --tolerance: `0` is no tolerance
    hint: per cent, above 0 and at most 100, such as --tolerance 0.5,1,2%
2 findings
"#);
}

#[test]
fn a_wider_tolerance_is_a_diff() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let old = tree(Path::new(&room.path("grades")));
    room.change(&[("omega: {ask:", "omega: {tolerance: {relative: 2 %}, ask:")]);
    let (bank, new) = (room.path("bank.yaml"), room.path("new"));
    // Nothing is written where nothing is to be.
    let everything = tree(room.0.path());
    let ran = room.regrade(&["--bank", &bank, "--dry-run"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
What changes in ROOM/grades:
  bank: ROOM/bank.yaml (a1bfc625020c…, was 1a2fd9c7c8f8…); the key is solved anew for the data on the sheets
  1.omega: the tolerance is 2 %, was 1 %
  part     gain  lose  points  why (answers)
  1.omega     1     0      +1  tolerance (1)
  Totals rise for 1 and fall for 0 of 6 students; their mean goes from 1.25 to 1.42.
  student  name               total  change  by part
  0044     Name of 0044  0.5 -> 1.5      +1  1.omega +1 (tolerance)
Nothing was written (--dry-run).
"#);
    assert_eq!(tree(room.0.path()), everything);

    let ran = room.regrade(&["--bank", &bank, "--out", &new]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    assert!(ran.out.ends_with("stays as it was.\n"), "{}", ran.out);
    insta::assert_snapshot!(room.read("new/changes.csv"), @r#"
student,problem,part,points_before,points_after,verdict_before,verdict_after,why
0044,1,omega,0,1,wrong,right,tolerance
"#);
    assert_eq!(tree(Path::new(&room.path("grades"))), old);
    let names: Vec<String> = tree(Path::new(&new)).into_keys().collect();
    for name in [
        "answers.csv",
        "gradebook.csv",
        "grading.json",
        "changes.csv",
        "basis/bank.yaml",
        "basis/key.csv",
        "basis/set.json",
    ] {
        assert!(names.iter().any(|n| n == name), "{name} is not among {names:?}");
    }
    // The new grading explains itself, and can be regraded in its turn.
    let ran = run(&["explain", &new, "44", "1.omega"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    assert!(
        ran.out.contains("regraded: 0 points (wrong) before, 1 point (right) now (tolerance)"),
        "{}",
        ran.out
    );
    let (set, answers, third) = (room.path("set"), room.path("answers.csv"), room.path("third"));
    let ran = run(&["regrade", &set, &new, &answers, "--out", &third]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let back = |name: &str| fs::read(Path::new(&third).join(name)).unwrap();
    assert_eq!(back("answers.csv"), old["answers.csv"]);
    assert_eq!(back("gradebook.csv"), old["gradebook.csv"]);
}

#[test]
fn a_part_is_corrected_for_all() {
    let room = Room::new();
    room.answers();
    // One of them gives no answer to it.
    let answers: String = room
        .read("answers.csv")
        .lines()
        .filter(|l| !l.starts_with("0031,1,v,"))
        .map(|l| format!("{l}\n"))
        .collect();
    room.write("answers.csv", &answers);
    room.grade(&[]);
    room.write(
        "course.yaml",
        "corrections:\n  - {part: 1.v, give: full, to: all, why: ambiguous}\ncredit: {wrong methods: 25 %}\n",
    );
    let ran = room.regrade(&["--course", &room.path("course.yaml"), "--out", &room.path("new")]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
What changes in ROOM/grades:
  bank: as before (1a2fd9c7c8f8…)
  course: ROOM/course.yaml
  correction: everybody gets full points for 1.v: ambiguous
  settings that differ: credit
  part     gain  lose  points  why (answers)
  1.omega     2     0    +0.5  credit (2)
  1.v         4     0    +2.5  correction (4)
  Totals rise for 4 and fall for 0 of 6 students; their mean goes from 1.08 to 1.58.
  student  name                total  change  by part
  0044     Name of 0044     0.5 -> 1    +0.5  1.v +0.5 (correction)
  0058     Name of 0058  0.5 -> 1.25   +0.75  1.omega +0.25 (credit), 1.v +0.5 (correction)
  0062     Name of 0062  0.5 -> 1.25   +0.75  1.omega +0.25 (credit), 1.v +0.5 (correction)
  0031     Name of 0031       1 -> 2      +1  1.v +1 (correction)
Written to ROOM/new, with every change in ROOM/new/changes.csv; ROOM/grades stays as it was.
"#);
    // Who handed in nothing gets the points too.
    insta::assert_snapshot!(room.read("new/changes.csv"), @r#"
student,problem,part,points_before,points_after,verdict_before,verdict_after,why
0031,1,v,,1,,,correction: ambiguous
0044,1,v,0.5,1,wrong,wrong,correction: ambiguous
0058,1,omega,0,0.25,wrong,wrong,credit
0058,1,v,0.5,1,wrong,wrong,correction: ambiguous
0062,1,omega,0,0.25,wrong,wrong,credit
0062,1,v,0.5,1,wrong,wrong,correction: ambiguous
"#);
    let ran = run(&["explain", &room.path("new"), "31", "1.v"]);
    assert!(ran.out.contains("1.v: no answer, 1 of 1 points by a correction"), "{}", ran.out);
    assert!(
        ran.out.contains("regraded: no answer before, 1 point without an answer now (correction: ambiguous)"),
        "{}",
        ran.out
    );
}

#[test]
fn another_scene_is_another_key() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    // The wheel was written to roll on its hub and was meant to roll on its rim.
    let scene = [
        ("- rolls: {body: wheel, on its: hub", "- rolls: {body: wheel, on its: rim"),
        (
            "body: wheel, wound on: rim, leaves: top forward",
            "body: wheel, wound on: hub, leaves: top forward",
        ),
    ];
    room.change(&scene);
    let bank = room.path("bank.yaml");
    // The relation between parts that was right for the old scene is not for the new one.
    let ran = room.regrade(&["--bank", &bank, "--dry-run"]);
    assert_eq!(ran.exit, Exit::Faulty);
    insta::assert_snapshot!(room.shown(&ran.err), @r#"
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0017: the relation of `follows` does not give v from the other parts
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0023: the relation of `follows` does not give v from the other parts
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0031: the relation of `follows` does not give v from the other parts
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0044: the relation of `follows` does not give v from the other parts
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0058: the relation of `follows` does not give v from the other parts
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0062: the relation of `follows` does not give v from the other parts
    hint: sheets are printed: a regrading keeps their problems, parts and data, and needs a key for each
6 findings
"#);
    room.change(&[scene[0], scene[1], ("v: r*omega", "v: R*omega")]);
    let ran = room.regrade(&["--bank", &bank, "--dry-run"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
What changes in ROOM/grades:
  bank: ROOM/bank.yaml (f68844e7a69e…, was 1a2fd9c7c8f8…); the key is solved anew for the data on the sheets
  1.omega: the key differs for 6 of 6 students, by up to 71.484 %
  1.v: the key differs for 6 of 6 students, by up to 24.516 %
  1.friction: the key differs for 6 of 6 students, by up to 66.744 %
  1.friction: the tolerance is 1.6-2.7 %, was 2-2.8 %
  1.mu_required: the key differs for 6 of 6 students, by up to 66.744 %
  1.mu_required: the tolerance is 1.3-3.2 %, was 1.8-2.7 %
  1.cord_travel: the key differs for 6 of 6 students, by up to 70.455 %
  part     gain  lose  points  why (answers)
  1.omega     0     3      -3  key (3)
  1.v         0     6    -4.5  key (3), no longer follow-through (3)
  Totals rise for 0 and fall for 6 of 6 students; their mean goes from 1.25 to 0.00.
  student  name             total  change  by part
  0017     Name of 0017    2 -> 0      -2  1.omega -1 (key), 1.v -1 (key)
  0023     Name of 0023    2 -> 0      -2  1.omega -1 (key), 1.v -1 (key)
  0031     Name of 0031    2 -> 0      -2  1.omega -1 (key), 1.v -1 (key)
  0044     Name of 0044  0.5 -> 0    -0.5  1.v -0.5 (no longer follow-through)
  0058     Name of 0058  0.5 -> 0    -0.5  1.v -0.5 (no longer follow-through)
  0062     Name of 0062  0.5 -> 0    -0.5  1.v -0.5 (no longer follow-through)
Nothing was written (--dry-run).
"#);
}

#[test]
fn what_no_longer_fits_is_found() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let bank = room.path("bank.yaml");
    let mut told = Vec::new();
    for (from, to) in [
        // A part renamed.
        ("      k_bound: {ask:", "      k_bounds: {quantity: k_bound, ask:"),
        // A datum in another unit.
        (
            "d: {name: distance that the centre moves, unit: m}",
            "d: {name: distance that the centre moves, unit: cm}",
        ),
        // A case renamed.
        ("      friction up:\n        share: 3", "      upwards:\n        share: 3"),
        // What happens on nobody's sheet.
        ("regimes: [moves_up]", "regimes: [moves_down]"),
        // Another problem.
        ("  pulled-rolling:\n", "  pulled-wheel:\n"),
    ] {
        room.change(&[(from, to)]);
        let ran = room.regrade(&["--bank", &bank, "--out", &room.path("new")]);
        told.push(format!("{:?}\n{}", ran.exit, room.shown(&ran.err)));
        assert!(!Path::new(&room.path("new")).exists());
    }
    insta::assert_snapshot!(told.join("\n"), @r#"
Faulty
error: ROOM/bank.yaml: problems.pulled-rolling.questions: part `k_bound` is on the sheets, the bank has it no more
    hint: was it renamed to `k_bounds`? Parts keep their ids
error: ROOM/bank.yaml: problems.pulled-rolling.questions: part `k_bounds` is on no sheet
    hint: nobody was asked it: take it out again
2 findings

Faulty
error: ROOM/bank.yaml: problems.pulled-rolling.data.d: is printed in m on the sheets, the bank says cm
    hint: give the datum its old unit back

Faulty
error: ROOM/bank.yaml: problems.pulled-rolling.cases: the bank has no case `friction up`, which is on sheets
    hint: sheets are printed: a regrading keeps their problems, parts and data, and needs a key for each

Faulty
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0017: another motion than the problem tells of: moves_up
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0023: another motion than the problem tells of: moves_up
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0031: another motion than the problem tells of: moves_up
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0044: another motion than the problem tells of: moves_up
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0058: another motion than the problem tells of: moves_up
error: ROOM/bank.yaml: problems.pulled-rolling: with the data of 0062: another motion than the problem tells of: moves_up
    hint: sheets are printed: a regrading keeps their problems, parts and data, and needs a key for each
6 findings

Faulty
error: ROOM/bank.yaml: problems: the bank has no problem `pulled-rolling`
    hint: its problems: pulled-wheel
"#);
}

#[test]
fn other_faults_are_told() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let mut told = Vec::new();
    let mut tell = |ran: Ran| told.push(format!("{:?}\n{}", ran.exit, room.shown(&ran.err)));
    tell(room.regrade(&["--out", &room.path("grades")]));
    tell(room.regrade(&["--out", &room.path("grades/new")]));
    let (set, answers, new) = (room.path("set"), room.path("answers.csv"), room.path("new"));
    tell(run(&["regrade", &set, &set, &answers, "--out", &new]));
    tell(run(&["regrade", &set, &room.path("nowhere"), &answers, "--out", &new]));
    tell(run(&["explain", &room.path("grades"), "9999", "1"]));
    tell(run(&["explain", &room.path("grades"), "17", "2"]));
    tell(run(&["explain", &room.path("grades"), "17", "1", "--part", "omga"]));
    // Other submissions than before.
    room.write("answers.csv", "student,problem,part,answer\n0017,1,omega,3\n");
    tell(room.regrade(&["--dry-run"]));
    // A basis that was changed.
    let text = room.read("grades/basis/bank.yaml");
    room.write("grades/basis/bank.yaml", &format!("{text}# a word more\n"));
    tell(run(&["what-if", &room.path("grades")]));
    insta::assert_snapshot!(told.join("\n"), @r#"
Faulty
error: ROOM/grades: --out: is there already
    hint: a regrading keeps both versions: give a folder that is not there yet

Faulty
error: ROOM/grades/new: --out: is within the old grading, which stays as it is
    hint: give another --out

Faulty
error: ROOM/set: holds no answers.csv, gradebook.csv, grading.json, basis/set.json, basis/bank.yaml, basis/key.csv
    hint: give the folder that `slipstick grade` made; if an earlier version did, grade again

Faulty
error: ROOM/nowhere: there is no such folder
    hint: give the folder that `slipstick grade` made

Faulty
error: ROOM/grades: `9999` is no student of this set
    hint: its students: 0017, 0023, 0031, 0044, 0058, ...

Faulty
error: ROOM/grades: the set has no problem `2`
    hint: its problems: 1 (pulled-rolling)

Faulty
error: ROOM/grades: problem 1 (pulled-rolling) has no part `omga`
    hint: did you mean `omega`?

Fine
warning: answers.csv has 43 bytes, the old grading was made from 262: changes may come from other answers too

Faulty
error: ROOM/grades/basis/bank.yaml: is not the bank by which this was graded: its SHA-256 is another
    hint: put the original copy back, or grade again
"#);
}

#[test]
fn a_mark_is_explained() {
    let room = Room::new();
    room.answers();
    let value = room.key("0023", "omega");
    let text = room.read("answers.csv");
    room.write(
        "answers.csv",
        &format!(
            "{text}0023,1,omega,{:.1} rpm\n0023,1,friction,=cmd\n0023,1,k_bound,2 N\n",
            value * 60.0 / std::f64::consts::TAU * 1.2
        ),
    );
    room.write("course.yaml", "attempts: {count: best, penalty: 10 %, least: 50 %}\n");
    room.grade(&["--course", &room.path("course.yaml")]);
    let ran = run(&["explain", &room.path("grades"), "23", "pulled-rolling"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
0023 (Name of 0023), problem 1 (pulled-rolling) of set week

Data on the sheet
  case friction up: m = 40 kg, R = 0.43 m, r = 0.18 m, k = 0.27 m, theta = 22 deg, P = 220 N, d =
      1.8 m, mu_s = 0.70, g = 9.81 m/s^2

1.omega: 1 of 1 points, right
  asked: omega, in rad/s
  key: 22.6183484 rad/s; equations of motion 22.6183484, work and energy 22.6183484, gap 0;
      condition number 3.86; the true answer lies within 5e-14 of it, proved
  tolerance: 1 % of the key, which is 0.22618 rad/s to either side: right is what lies from
      22.3921649 to 22.8445318
  attempts, in the order of the file:
    line 4: `22.70882`, read as 22.70882 without unit, so rad/s, that is 22.7088200 rad/s, +0.400 %
        from the key. Right: within the tolerance
    line 14: `259.2 rpm`, read as 259.2 in rpm, that is 27.1433605 rad/s, +20.0 % from the key.
        Superseded by line 4; would have been wrong
  which counts: the one with the most points; that is line 4
  points: 1 for a right answer; together 1

1.v: 1 of 1 points, right
  asked: v, in m/s
  key: 4.07130270 m/s; equations of motion 4.07130270, work and energy 4.07130270, gap 0; condition
      number 3.37; the true answer lies within 8e-15 of it, proved
  tolerance: 1 % of the key, which is 0.040713 m/s to either side: right is what lies from
      4.03058968 to 4.11201573
  attempts, in the order of the file:
    line 5: `4.08759`, read as 4.08759 without unit, so m/s, that is 4.08759000 m/s, +0.400 % from
        the key. Right: within the tolerance
  points: 1 for a right answer; together 1

1.friction: 0 of 2 points, unreadable
  asked: friction, in N
  key: 111.167913 N; equations of motion 111.167913, work and energy 111.167913, gap 0; condition
      number 7.37; the true answer lies within 5e-13 of it, proved
  tolerance: 2.3 % of the key, by its condition number, which is 2.5569 N to either side: right is
      what lies from 108.611051 to 113.724775
  attempts, in the order of the file:
    line 15: `=cmd`. Unreadable: neither a number nor a known word
  points: 0 of 2, the answer is not right; together 0

1.mu_required: no answer, of 1 points
  asked: mu_required, a plain number
  key: 0.305551622; equations of motion 0.305551622, work and energy 0.305551622, gap 0; condition
      number 5.87; the true answer lies within 2e-15 of it, proved
  tolerance: 1.8 % of the key, by its condition number, which is 0.0054999 to either side: right is
      what lies from 0.300051692 to 0.311051551
  attempts: none was handed in

1.cord_travel: no answer, of 1 points
  asked: cord_travel, in m
  key: 6.10000000 m; equations of motion 6.10000000, work and energy 6.10000000, gap 0; condition
      number 2.41; the true answer lies within 4e-15 of it, proved
  tolerance: 1 % of the key, which is 0.061000 m to either side: right is what lies from 6.03900000
      to 6.16100000
  attempts: none was handed in

1.k_bound: 0 of 1 points, wrong dimension
  asked: k_bound, in m
  key: 0.482955798 m; equations of motion 0.482955798, work and energy 0.482955798, gap 0; condition
      number 4.98; the true answer lies within 2e-15 of it, proved
  tolerance: 1 % of the key, which is 0.0048296 m to either side: right is what lies from
      0.478126240 to 0.487785356
  attempts, in the order of the file:
    line 16: `2 N`, read as 2 in N. Wrong dimension: expected m (length), found N (force)
  points: 0 of 1, the answer is not right; together 0

The total
  2 of 7 points

What it was graded with
  slipstick 0.1.0, draw version 5; set week from seed 7
  bank one-wheel, SHA-256 1a2fd9c7c8f8999d941fe2fc93f5f09c5b98215c9fc3e9e353d7c23ceb374f7d
  key, SHA-256 bb81adad20d57e48c230c32c0388d4b64d3df8427fd612cdaf1f808fb6a7b8ad; solved anew for
      this text, and the same
  course, SHA-256 6774c14141fb11c387157d62401bb3d51daa38446109ee2c8be51eabbf67fe61
  submissions: answers.csv, 325 bytes
"#);
    let ran = run(&["explain", &room.path("grades"), "Name of 0058", "1.v"]);
    let value = room.key("0058", "v") * 1.03;
    assert!(
        ran.out.contains("follow-through: v = r*omega, with the student's own omega it comes to"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains(&format!("{value:.5}")), "{value}: {}", ran.out);
    assert!(ran.out.contains("because the answer follows correctly"), "{}", ran.out);
}

#[test]
fn copied_answers_are_found_and_told_to_nobody_else() {
    let room = Room::new();
    room.answers();
    // One student has the answers of a classmate in three parts of the one problem: one piece of evidence, to five figures.
    let mut text = room.read("answers.csv");
    for part in ["omega", "v", "k_bound"] {
        text.push_str(&format!("0062,1,{part},{:.4}\n", room.key("0023", part)));
    }
    room.write("answers.csv", &text);
    room.grade(&[]);
    let ran = run(&["matches", &room.path("grades")]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @r#"
7 wrong answers in numbers held against classmates' keys, 5 of them with no other explanation: 1 pair stands out. Among honest students luck alone makes a pair stand out in one set of 100.
  look  student  key of  parts                  answers                    chance  by luck  other explanation
  yes   0062     0023    1.omega 1.v 1.k_bound  22.6183 | 4.0713 | 0.4830    4e-6     3e-5
  A match accuses nobody: sheets get swapped, friends compute with one set of data, a form is filled in for another.
  all of them, for your eyes only: ROOM/grades/matches.csv
"#);
    insta::assert_snapshot!(room.read("grades/matches.csv"), @r#"
look,student,classmate,parts,answers,chance,expected_by_luck,other_explanation
yes,0062,0023,1.omega 1.v 1.k_bound,22.6183 | 4.0713 | 0.4830,3.9e-6,3.3e-5,
"#);
    // The class report shows the pair to the instructor; what students get knows nothing of it.
    assert!(room.read("grades/report.html").contains("0023 (Name of 0023)"));
    let feedback = tree(Path::new(&room.path("grades/feedback")));
    assert!(feedback.len() >= 2 * STUDENTS.len());
    for (name, bytes) in feedback.iter().filter(|(name, _)| name.contains("0062")) {
        let text = String::from_utf8_lossy(bytes);
        assert!(!text.contains("0023") && !text.contains("classmate"), "{name}: {text}");
    }
}

/// What is printed on a sheet is enough: solved from it, the key of every family is that of the draw, to the last bit.
#[test]
fn the_printed_data_give_the_key_of_the_draw() {
    for bank in support::banks() {
        let all: Vec<usize> = (0..bank.problems.len()).collect();
        let dealer = dealer::Dealer::new(&bank, &all, 3, "printed");
        let mut keys = Vec::new();
        let mut students = Vec::new();
        for id in ["a", "b", "c", "d"] {
            let dealt = dealer.deal(id).unwrap();
            let problems = dealt.variants.iter().zip(&bank.problems);
            students.push(StoredStudent {
                student: id.to_owned(),
                name: String::new(),
                folder: id.to_owned(),
                problems: problems.map(|(variant, problem)| dealer::stored(problem, variant)).collect(),
            });
            keys.push(dealt.key);
        }
        let set = StoredSet {
            format: store::FORMAT,
            name: "printed".to_owned(),
            seed: 3,
            program: String::new(),
            draw_version: DRAW_VERSION,
            language: "en".to_owned(),
            formats: Vec::new(),
            page: Default::default(),
            bank: StoredBank { id: bank.id.clone(), file: "bank.yaml".to_owned(), sha256: bank.hash.clone() },
            key_sha256: None,
            problems: bank.problems.iter().map(|p| p.id.clone()).collect(),
            students,
            coincidences: Vec::new(),
        };
        // As it is read again.
        let set = StoredSet::parse(&set.text()).unwrap();
        let Ok(found) = given::all(&bank, &set) else { panic!("{}: no key from the printed data", bank.id) };
        let again: Vec<_> = found.into_iter().map(|g| g.key).collect();
        assert!(key_file::text(&again) == key_file::text(&keys), "{}: another key", bank.id);
        assert!(again == keys, "{}: other wrong values or relations", bank.id);
    }
}

#[test]
fn force_replaces_nothing_of_others() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let again = || {
        run(&[
            "grade",
            &room.path("set"),
            &room.path("answers.csv"),
            "--out",
            &room.path("grades"),
            "--force",
        ])
    };
    for name in
        ["notes.txt", "feedback/notes.txt", "feedback/0099.html", "tables/mine.csv", "basis/notes.txt"]
    {
        room.write(&format!("grades/{name}"), "mine");
        let before = tree(room.0.path());
        let mut runs = vec![("grade", again())];
        if !name.starts_with("basis") && name != "notes.txt" {
            runs.push(("report", run(&["report", &room.path("grades"), "--force"])));
        }
        for (verb, ran) in runs {
            assert_eq!(ran.exit, Exit::Faulty, "{verb} {name}");
            let what = format!("ROOM/grades: holds what `slipstick {verb}` did not make: {name}");
            assert!(room.shown(&ran.err).contains(&what), "{}", ran.err);
            assert!(tree(room.0.path()) == before, "{verb} {name}");
        }
        fs::remove_file(room.path(&format!("grades/{name}"))).unwrap();
    }
    // What lies beside the report is not touched by it.
    let before = tree(room.0.path());
    room.write("grades/notes.txt", "mine");
    let ran = run(&["report", &room.path("grades"), "--force"]);
    assert_eq!((ran.exit, room.read("grades/notes.txt").as_str()), (Exit::Fine, "mine"), "{}", ran.err);
    fs::remove_file(room.path("grades/notes.txt")).unwrap();
    assert_eq!(again().exit, Exit::Fine);
    assert!(tree(room.0.path()) == before, "nothing is left over, and the same is made again");
    let ran = room.grade(&["--force", "--reports", "no"]);
    assert!(ran.out.contains("The earlier report and feedback in"), "{}", ran.out);
    assert!(!Path::new(&room.path("grades/report.html")).exists());
}

#[test]
fn an_edited_grading_is_refused() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let grades = room.path("grades");
    for name in ["answers.csv", "gradebook.csv"] {
        let good = room.read(&format!("grades/{name}"));
        let cut = good[..good.trim_end().rfind('\n').unwrap() + 1].to_owned();
        for bad in [cut, good.replacen("0017", "0018", 1)] {
            room.write(&format!("grades/{name}"), &bad);
            for args in [
                &["report", &grades, "--force"][..],
                &["explain", &grades, "0017", "1"],
                &["what-if", &grades],
                &["matches", &grades],
                &["regrade", &room.path("set"), &grades, &room.path("answers.csv"), "--dry-run"],
            ] {
                let ran = run(args);
                assert_eq!(ran.exit, Exit::Faulty, "{args:?}");
                let what = format!("ROOM/grades/{name}: is not as `slipstick grade` wrote it");
                assert!(room.shown(&ran.err).contains(&what), "{args:?} {}", ran.err);
            }
        }
        room.write(&format!("grades/{name}"), &good);
    }
    let answers = room.read("answers.csv");
    room.write("answers.csv", &answers.replacen("0017,1,omega,", "0017,1,omega,9", 1));
    let longer = room.regrade(&["--dry-run"]);
    assert!(longer.err.contains(" bytes, the old grading was made from "), "{}", longer.err);
    room.write("answers.csv", &answers.replacen("0017,1,v,", "0017,1,V,", 1));
    let other = room.regrade(&["--dry-run"]);
    assert!(other.err.contains("and another (by SHA-256)"), "{}", other.err);
    room.write("answers.csv", &answers);
    assert_eq!(room.regrade(&["--dry-run"]).err, "");
}

#[test]
fn a_regrading_keeps_units_and_settings() {
    let room = Room::new();
    room.answers();
    // All of it comes a day late.
    let late: String = room
        .read("answers.csv")
        .lines()
        .enumerate()
        .map(|(i, l)| format!("{l},{}\n", if i == 0 { "submitted_at" } else { "2026-03-10 12:00" }))
        .collect();
    room.write("answers.csv", &late);
    room.write("course.yaml", "due: 2026-03-09 23:59\nlate: {penalty: 20 %, per: day}\n");
    room.grade(&["--course", &room.path("course.yaml"), "--attempts", "best"]);
    assert!(room.read("grades/answers.csv").contains(",late:0.8,"));
    // A file that names one thing leaves the others as they were, also once more.
    let regrade = |from: &str, course: &str, to: &str| {
        room.write("next.yaml", course);
        let [set, old, answers, next, new] =
            ["set", from, "answers.csv", "next.yaml", to].map(|n| room.path(n));
        let ran = run(&["regrade", &set, &old, &answers, "--course", &next, "--out", &new]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        ran.out
    };
    let told =
        regrade("grades", "corrections:\n  - {part: 1.v, give: full, to: all, why: ambiguous}\n", "new");
    assert!(!told.contains("settings that differ"), "{told}");
    let answers = room.read("new/answers.csv");
    assert!(answers.contains(",late:0.8,") && answers.contains("correction"), "{answers}");
    assert!(room.read("new/grading.json").contains("\"attempts\": \"best\""));
    let told = regrade("new", "late: {penalty: 10 %}\nattempts: first\n", "newer");
    assert!(told.contains("settings that differ: attempts, late\n"), "{told}");
    assert!(told.contains("attempts or lateness"), "{told}");
    let answers = room.read("newer/answers.csv");
    assert!(answers.contains(",late:0.9,") && answers.contains("correction"), "{answers}");
    let ran = run(&["explain", &room.path("newer"), "0017", "1"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let told = "due: 2026-03-09 23:59 UTC; came 2026-03-10 12:00, 0 d 12 h 1 min late; lateness costs 10 %";
    let joined = ran.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(joined.contains(told), "{}", ran.out);

    // The sheets say m/s: an answer without unit is one.
    room.change(&[(
        "of its centre at that moment', unit: m/s}",
        "of its centre at that moment', unit: km/h}",
    )]);
    let ran = room.regrade(&["--bank", &room.path("bank.yaml"), "--out", &room.path("other")]);
    assert_eq!(ran.exit, Exit::Faulty, "{}", ran.out);
    assert!(ran.err.contains("the sheets ask for m/s, the bank now for km/h"), "{}", ran.err);
    assert!(!Path::new(&room.path("other")).exists());
}

#[test]
fn a_file_without_answers_is_told() {
    let room = Room::new();
    room.write("answers.csv", "student,problem,part,answer\n");
    assert!(room.grade(&[]).out.contains("warning: there is no answer in"));
    room.answers();
    assert!(!room.grade(&["--force"]).out.contains("warning"));
}

#[test]
fn other_tolerances_are_graded_as_grading_would() {
    let room = Room::new();
    room.answers();
    // A first attempt that is off by 3 %, a second one that is far off; all of it late.
    let mut text = "student,problem,part,answer,submitted_at\n".to_owned();
    for student in STUDENTS {
        for (off, hour) in [(1.03, 10), (1.4, 11)] {
            let value = room.key(student, "omega") * off;
            text.push_str(&format!("{student},1,omega,{value:.5},2026-03-10 {hour}:00\n"));
        }
    }
    room.write("answers.csv", &text);
    room.write(
        "course.yaml",
        "due: 2026-03-09 23:59\nlate: {penalty: 20 %, per: day}\nattempts: {count: best, penalty: 50 %}\ndrop lowest: 0\n",
    );
    room.grade(&["--course", &room.path("course.yaml")]);
    let ran = run(&["what-if", &room.path("grades"), "--tolerance", "5"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    // What the same tolerance in the bank gives.
    let bank = room.read("set/bank.yaml");
    let questions = bank.find("    questions:\n      omega: {ask:").unwrap();
    let (head, rest) = bank.split_at(questions);
    room.write(
        "bank.yaml",
        &format!("{head}{}", rest.replacen("omega: {ask:", "omega: {tolerance: {relative: 5 %}, ask:", 1)),
    );
    let again = room.regrade(&["--bank", &room.path("bank.yaml"), "--dry-run"]);
    assert_eq!(again.exit, Exit::Fine, "{}", again.err);
    let means = again.out.lines().find_map(|l| l.split("their mean goes from ").nth(1)).unwrap();
    let line = ran.out.lines().find(|l| l.contains("mean of totals")).unwrap();
    let told: Vec<&str> = line.split_whitespace().skip(3).collect();
    assert_eq!(format!("{}.", told.join(" to ")), means, "{}", ran.out);
    assert_eq!(means, "0.00 to 0.80.");
}
