//! The program run in this process, and what it leaves on disk.
#![allow(dead_code, reason = "each program of tests takes what it needs")]
use slipstick::cli;
use slipstick::cli::tell::{Exit, Io};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// How a command line ended, and what it wrote.
pub struct Ran {
    pub exit: Exit,
    pub out: String,
    pub err: String,
}

impl Ran {
    pub fn parts(self) -> (Exit, String, String) {
        (self.exit, self.out, self.err)
    }
}

/// A folder of a test's own, which goes when the test ends.
pub struct Room(pub TempDir);

impl Room {
    pub fn empty() -> Self {
        Self(TempDir::new().unwrap())
    }
    pub fn path(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }
    /// A message without the name of the folder.
    pub fn shown(&self, text: &str) -> String {
        text.replace(&self.0.path().display().to_string(), "ROOM")
    }
}

/// Runs a command line with this standard input. Paths in it are absolute: tests share one working folder.
pub fn run_with(args: &[&str], input: &str) -> Ran {
    let mut input = input.as_bytes();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
    let mut io = Io { input: &mut input, out: &mut out, err: &mut err, watched: false, typed: false };
    let exit = cli::run(words, &mut io);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Ran { exit, out: text(out), err: text(err) }
}

/// The same with nothing on standard input.
pub fn run(args: &[&str]) -> Ran {
    run_with(args, "")
}

/// `generate` with seed 1.
pub fn generate(bank: &str, roster: &str, out: &str, more: &[&str]) -> Ran {
    run(&[&["generate", bank, "--roster", roster, "--seed", "1", "--out", out], more].concat())
}

/// Is there pandoc? Where there is none, tests pass over what needs it, but not in `.ci/run`.
pub fn has_pandoc() -> bool {
    let there = Command::new("pandoc").arg("--version").output().is_ok_and(|o| o.status.success());
    assert!(there || std::env::var_os("SLIPSTICK_NEEDS_PANDOC").is_none(), "there is no pandoc");
    if !there {
        println!("passed over: there is no pandoc");
    }
    there
}

/// All files below a folder with their bytes, by their paths with `/`.
pub fn tree(folder: &Path) -> BTreeMap<String, Vec<u8>> {
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

/// A bank with a block that slides down a ramp, of mass m over the distance d; its questions and its statement, lines of YAML and
/// of Markdown, are given.
pub fn sliding(title: &str, questions: &str, statement: &str) -> String {
    let lines = |text: &str| text.lines().map(|line| format!("      {line}\n")).collect::<String>();
    let (questions, statement) = (lines(questions), lines(statement));
    format!(
        "bank: blocks
title: {title}
problems:
  slide:
    title: {title}
    data:
      m: {{name: mass, unit: kg, draw: 2 to 9 step 1}}
      d: {{name: distance, unit: m, draw: 1 to 4 step 0.01}}
    scene:
      surfaces: {{ramp: {{slope: 30 deg}}}}
      bodies:
        block: {{mass: m, moves: along ramp, positive: down}}
      ties:
        - slides: {{body: block, mu_k: 0.1, mu_s: 0.15}}
      start: at rest
      end: {{travel: {{of: block, by: d, heading: down}}}}
    questions:
{questions}    statement: |
{statement}"
    )
}
