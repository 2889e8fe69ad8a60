//! Sets that an earlier version drew. All tests before took sets of their own version: a raised draw version was seen only as a
//! refusal, and nobody asked what becomes of a term's work when the program is renewed.
use crate::support::program;
use slipstick::cli::tell::Exit;
use slipstick::draw::stream::DRAW_VERSION;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

fn kept(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/earlier")).join(name)
}

/// A folder with a copy of the set that draw version 3 made (two students), and answers to it.
fn stored() -> TempDir {
    let room = tempfile::tempdir().unwrap();
    fs::create_dir(room.path().join("set")).unwrap();
    for name in ["bank.yaml", "key.csv", "set.json"] {
        fs::copy(kept("set").join(name), room.path().join("set").join(name)).unwrap();
    }
    let answers = "student,problem,part,answer\n0017,1,direction,up\n0017,1,v,1.096 m/s\n0023,1,direction,stays\n0023,1,v,1.2\n";
    fs::write(room.path().join("in.csv"), answers).unwrap();
    room
}

fn at(room: &TempDir, name: &str) -> String {
    room.path().join(name).display().to_string()
}

fn grade(room: &TempDir, out: &str) -> (Exit, String, String) {
    run(&["grade", &at(room, "set"), &at(room, "in.csv"), "--out", &at(room, out)])
}

fn change(room: &TempDir, file: &str, from: &str, to: &str) {
    let text = fs::read_to_string(at(room, file)).unwrap();
    assert!(text.contains(from), "{file} holds {from}");
    fs::write(at(room, file), text.replacen(from, to, 1)).unwrap();
}

#[test]
fn a_set_of_an_earlier_draw_version_is_graded_from_its_stored_key_and_told_so() {
    let room = stored();
    let (exit, out, err) = grade(&room, "grades");
    assert_eq!(exit, Exit::Fine, "{err}");
    let told = format!("drawn by draw version 3, this program has {DRAW_VERSION}: it was not replayed");
    assert!(out.contains(&told), "{out}");
    assert!(out.contains("2 right, 2 wrong"), "{out}");
    let read = |name: &str| fs::read_to_string(at(&room, name)).unwrap();
    assert!(read("grades/grading.json").contains("\"replayed\": false"));
    assert!(read("grades/report.html").contains("not replayed"), "the report does not say it");
    let (exit, page, err) = run(&["explain", &at(&room, "grades"), "0017", "1.v"]);
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(page.contains("not replayed"), "{page}");
    let (exit, out, err) = run(&["verify", &at(&room, "set")]);
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(out.contains("it was not replayed") && !out.contains("drawn and solved again"), "{out}");
    let (exit, _, err) = run(&["solutions", &at(&room, "set"), "--out", &at(&room, "solved")]);
    assert_eq!(exit, Exit::Fine, "{err}");
}

#[test]
fn an_edited_key_of_an_earlier_set_is_refused() {
    // Without a hash the stored data speak against it.
    for (from, to) in [
        ("1.0962614248094547,m/s", "1.1962614248094547,m/s"),
        (",0.010962614248094547", ",0.2"),
        ("direction,up", "direction,down"),
        ("0023,1,v", "0024,1,v"),
        ("1.0962614248094547,m/s", "much,m/s"),
    ] {
        let room = stored();
        change(&room, "set/key.csv", from, to);
        let (exit, _, err) = grade(&room, "grades");
        assert_eq!(exit, Exit::Faulty, "{from} -> {to}");
        assert!(err.contains("key.csv"), "{err}");
        assert!(!room.path().join("grades").exists());
        assert_eq!(run(&["verify", &at(&room, "set")]).0, Exit::Faulty);
    }
    let room = stored();
    change(&room, "set/bank.yaml", "0.22 m", "0.23 m");
    assert!(grade(&room, "grades").2.contains("the bank copy was changed"));
}

#[test]
fn a_stored_hash_stands_above_what_a_later_version_would_solve() {
    let room = tempfile::tempdir().unwrap();
    fs::write(at(&room, "roster.csv"), "student\n0017\n0023\n").unwrap();
    let bank = kept("set").join("bank.yaml").display().to_string();
    let made =
        ["generate", &bank, "--roster", &at(&room, "roster.csv"), "--out", &at(&room, "set"), "--seed", "7"];
    assert_eq!(run(&made).0, Exit::Fine);
    fs::write(at(&room, "in.csv"), "student,problem,part,answer\n0017,1,v,7\n").unwrap();
    let now = format!("\"draw_version\": {DRAW_VERSION}");
    change(&room, "set/set.json", &now, "\"draw_version\": 3");
    let (exit, out, err) = grade(&room, "grades");
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(out.contains("not replayed") && out.contains("SHA-256") && !out.contains("otherwise"), "{out}");
    // Edited: refused, by its hash.
    let key = fs::read_to_string(at(&room, "set/key.csv")).unwrap();
    let line = key.lines().find(|l| l.starts_with("0017,1,v")).unwrap().to_owned();
    let value = line.split(',').nth(3).unwrap().to_owned();
    let edited = key.replace(&line, &line.replacen(&value, "7", 1));
    fs::write(at(&room, "set/key.csv"), &edited).unwrap();
    let (exit, _, err) = grade(&room, "more");
    assert_eq!(exit, Exit::Faulty);
    assert!(err.contains("SHA-256"), "{err}");
    // The same key as one that was published so: it counts, and how much of it would be solved otherwise today is told.
    let hash = |text: &str| slipstick::bank::load::hash(text);
    change(&room, "set/set.json", &hash(&key), &hash(&edited));
    let (exit, out, err) = grade(&room, "more");
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(out.contains("1 right") && out.contains("would give 1 answer of it otherwise"), "{out}");
    // A set of a later version is none of ours.
    change(&room, "set/set.json", "\"draw_version\": 3", "\"draw_version\": 99");
    assert!(grade(&room, "none").2.contains("draw_version: is 99"));
}

#[test]
fn a_sheet_file_of_an_earlier_version_is_checked() {
    let sheet = kept("sheet.json").display().to_string();
    let text = fs::read_to_string(&sheet).unwrap();
    assert!(text.contains("\"regimes\""), "the layout of draw version 3 had them");
    let (exit, out, err) = run(&["check", &sheet, "1.v=1.096 m/s", "1.direction=up"]);
    assert_eq!(exit, Exit::Fine, "{out}{err}");
    assert_eq!(run(&["check", &sheet, "1.direction=down"]).0, Exit::NotAllRight);
}
