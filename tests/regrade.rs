//! After grading: what other tolerances would change, grading again by a changed bank or course, and marks explained.
#![expect(clippy::unwrap_used, reason = "a test that cannot set itself up fails")]
use slipstick::cli;
use slipstick::cli::tell::Exit;
use slipstick::cli::tell::Io;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

struct Ran {
    exit: Exit,
    out: String,
    err: String,
}

/// Runs a command line in this process. Paths in it are absolute: tests share one working folder.
fn run(args: &[&str]) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut input = "".as_bytes();
    let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
    let exit = cli::run(
        words,
        &mut Io { input: &mut input, out: &mut out, err: &mut err, watched: false, typed: false },
    );
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Ran { exit, out: text(out), err: text(err) }
}

/// All files below a folder with their bytes.
fn tree(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fn walk(folder: &Path, prefix: &str, found: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                walk(&entry.path(), &format!("{name}/"), found);
            } else {
                found.insert(name, fs::read(entry.path()).unwrap());
            }
        }
    }
    let mut found = BTreeMap::new();
    walk(folder, "", &mut found);
    found
}

const BANK: &str = "bank: small
title: One wheel
tolerance: 1 %
problems:
  pulled:
    title: Pulled wheel
    statement: 'A wheel of mass {{ value.m }} is pulled.'
    data:
      m: {name: mass, unit: kg, draw: 20 to 60 by 1}
      R: {name: outer radius, unit: m, draw: 0.20 to 0.60 by 0.01}
      k: {name: radius of gyration, unit: m, draw: 0.10 to 0.40 by 0.01}
      P: {name: pull, unit: N, draw: 200 to 600 by 10}
      d: {name: travel, unit: m, draw: 1.0 to 5.0 by 0.1}
      mu_s: {name: static friction, unit: 1, draw: always 0.9}
";

/// A room with a set of some students of the built-in wheels and a form of answers.
struct Room(TempDir);

const STUDENTS: [&str; 6] = ["0017", "0023", "0031", "0044", "0058", "0062"];

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        let rows: String = STUDENTS.iter().map(|s| format!("{s},Name of {s}\n")).collect();
        room.write("roster.csv", &format!("student,name\n{rows}"));
        let ran = run(&[
            "generate",
            "wheels-on-inclines",
            "--roster",
            &room.path("roster.csv"),
            "--seed",
            "7",
            "--name",
            "week",
            "--problems",
            "pulled-rolling",
            "--out",
            &room.path("set"),
        ]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        room
    }
    fn path(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }
    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }
    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }
    /// The message without the name of the temporary folder.
    fn shown(&self, text: &str) -> String {
        text.replace(&self.0.path().display().to_string(), "ROOM")
    }
    /// The key of a student's part, in the asked unit.
    fn key(&self, student: &str, part: &str) -> f64 {
        let key = self.read("set/key.csv");
        let row = key.lines().find(|l| l.starts_with(&format!("{student},1,{part},"))).unwrap();
        row.split(',').nth(3).unwrap().parse().unwrap()
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
    /// The bank of the set with a change.
    fn change(&self, from: &str, to: &str) {
        let bank = self.read("set/bank.yaml");
        assert!(bank.contains(from), "the bank has no `{from}`");
        self.write("bank.yaml", &bank.replacen(from, to, 1));
    }
}

#[test]
fn other_tolerances_change_so_many_verdicts() {
    let room = Room::new();
    room.answers();
    room.grade(&[]);
    let ran = run(&["what-if", &room.path("grades")]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    insta::assert_snapshot!(room.shown(&ran.out), @"");
    let ran = run(&["what-if", &room.path("grades"), "--tolerance", "2%,x,0"]);
    assert_eq!(ran.exit, Exit::Faulty);
    insta::assert_snapshot!(ran.err, @"");
}
