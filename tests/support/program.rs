//! The program run in this process, and what it leaves on disk.
#![allow(dead_code, reason = "each program of tests takes what it needs")]
use slipstick::cli;
use slipstick::cli::tell::{Exit, Io};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;

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
