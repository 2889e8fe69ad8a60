//! Nothing is lost and nothing half-written: killed at any moment, out of disk, files that change, rows that are no rows, cells
//! that a spreadsheet would run.
#![cfg(unix)]
use crate::support::program::tree;
use std::collections::BTreeMap;
use std::fs;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::Instant;
use tempfile::TempDir;

/// A folder with a set of three students (one part asks for a unit, one for a word or a number as the bank has it).
/// A set of one problem for the roster.
const GENERATE: &str =
    "generate wheels-on-inclines --roster roster.csv --seed 7 --problems pulled-rolling --out set";

struct Room(TempDir);

impl Room {
    fn new(students: usize) -> Room {
        let room = Room(tempfile::tempdir().unwrap());
        let roster: String = (0..students).map(|i| format!("s{i}\n")).collect();
        room.write("roster.csv", format!("student\n{roster}").as_bytes());
        room.generate();
        room
    }
    fn generate(&self) {
        let made = self.run(&GENERATE.split(' ').collect::<Vec<_>>());
        assert!(made.status.success(), "{}", stderr(&made));
    }
    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
    fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.path(name), bytes).unwrap();
    }
    /// The program, in this folder.
    fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipstick"));
        command.current_dir(self.0.path());
        command
    }
    fn run(&self, args: &[&str]) -> Output {
        self.command().args(args).output().unwrap()
    }
    /// The program under a shell's limits.
    fn limited(&self, limit: &str, args: &str) -> Output {
        let line = format!("{limit}; exec {} {args}", env!("CARGO_BIN_EXE_slipstick"));
        Command::new("sh").args(["-c", &line]).current_dir(self.0.path()).output().unwrap()
    }
    fn grade(&self, out: &str, more: &[&str]) -> Output {
        self.run(&[&["grade", "set", "in.csv", "--out", out, "--reports", "no"], more].concat())
    }
    /// Rows of answers.csv of a grading of these bytes.
    fn graded(&self, bytes: &[u8]) -> Vec<Vec<String>> {
        self.write("in.csv", bytes);
        let ran = self.grade("g", &["--force"]);
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        let mut reader = csv::Reader::from_path(self.path("g/answers.csv")).unwrap();
        reader.records().map(|r| r.unwrap().iter().map(str::to_owned).collect()).collect()
    }
    fn unfinished(&self) -> Vec<String> {
        let names = fs::read_dir(self.0.path()).unwrap();
        names
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .filter(|n| n.starts_with(".slipstick"))
            .collect()
    }
}

fn stderr(ran: &Output) -> String {
    String::from_utf8_lossy(&ran.stderr).into_owned()
}

/// Answers of a class, attempt after attempt.
fn many_rows(rows: usize, students: usize) -> Vec<u8> {
    let mut text = b"student,problem,part,answer\n".to_vec();
    for i in 0..rows {
        let part = ["omega", "friction", "v"][i % 3];
        writeln!(text, "s{},1,{part},{}.{}", i * 7 % students, i % 300, i % 10).unwrap();
    }
    text
}

/// Kills runs of `args` at moments spread over the time that a whole run takes. After each the place is absent, or holds the old
/// tree, or the new one, all of it; the next run sweeps away what was left and comes to the same bytes.
fn kill_in_a_loop(
    room: &Room,
    args: &[&str],
    place: &str,
    old: Option<&BTreeMap<String, Vec<u8>>>,
    kills: u32,
) {
    let begun = Instant::now();
    let whole = room.run(args);
    let lasts = begun.elapsed();
    assert!(whole.status.success(), "{}", stderr(&whole));
    let new = tree(&room.path(place));
    let put_back = |room: &Room| {
        let _ = fs::remove_dir_all(room.path(place));
        for (name, bytes) in old.into_iter().flatten() {
            fs::create_dir_all(room.path(place).join(name).parent().unwrap()).unwrap();
            fs::write(room.path(place).join(name), bytes).unwrap();
        }
    };
    let mut finished = 0;
    for nth in 0..kills {
        put_back(room);
        let mut child =
            room.command().args(args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // Beyond the end as well, where the folders are exchanged.
        thread::sleep(lasts.mul_f64(1.1 * f64::from(nth) / f64::from(kills)));
        child.kill().unwrap();
        child.wait().unwrap();
        if room.path(place).exists() {
            let there = tree(&room.path(place));
            let is_old = old.is_some_and(|old| *old == there);
            assert!(
                is_old || there == new,
                "kill {nth}: the place holds neither the old tree nor the new one"
            );
            finished += u32::from(!is_old);
        } else if let Some(old) = old {
            // Between the two renames the old tree is beside its place.
            let kept = room.unfinished().iter().any(|left| {
                let beside = room.path(left).join("old");
                beside.exists() && tree(&beside) == *old
            });
            assert!(kept, "kill {nth}: the old tree is gone");
        }
    }
    assert!(finished < kills, "no run was killed before its end");
    put_back(room);
    assert!(room.run(args).status.success());
    assert!(tree(&room.path(place)) == new, "another run comes to other bytes");
    assert_eq!(room.unfinished(), Vec::<String>::new(), "what killed runs left is swept away");
}

fn kill_grade(rows: usize, kills: u32) {
    let room = Room::new(20);
    room.write("in.csv", &many_rows(rows, 20));
    let args = ["grade", "set", "in.csv", "--out", "g", "--reports", "no"];
    kill_in_a_loop(&room, &args, "g", None, kills);
    // Over an earlier grading.
    room.write("in.csv", &many_rows(10, 20));
    assert!(room.grade("g", &["--force"]).status.success());
    let old = tree(&room.path("g"));
    room.write("in.csv", &many_rows(rows, 20));
    let args = ["grade", "set", "in.csv", "--out", "g", "--reports", "no", "--force"];
    kill_in_a_loop(&room, &args, "g", Some(&old), kills);
}

#[test]
fn killed_while_grading() {
    kill_grade(20_000, 8);
}

#[test]
#[ignore = "minutes: 200 kills while grading and 60 while a set is made"]
fn killed_at_any_moment() {
    kill_grade(200_000, 100);
    let room = Room::new(3);
    let roster: String = (0..60).map(|i| format!("t{i}\n")).collect();
    room.write("more.csv", format!("student\n{roster}").as_bytes());
    let bank = "wheels-on-inclines";
    let args = ["generate", bank, "--roster", "more.csv", "--seed", "8", "--out", "other"];
    kill_in_a_loop(&room, &args, "other", None, 60);
}

#[test]
fn a_file_that_may_not_grow_is_told_and_nothing_is_left() {
    let room = Room::new(3);
    room.write("in.csv", &many_rows(30_000, 3));
    // 512 blocks of 512 or 1024 bytes: answers.csv has more than 2 MB.
    let ran = room.limited("ulimit -f 512", "grade set in.csv --out g --reports no");
    assert_eq!(ran.status.code(), Some(2), "{ran:?}");
    assert!(
        stderr(&ran).contains("answers.csv") && stderr(&ran).contains("may not grow"),
        "{}",
        stderr(&ran)
    );
    assert!(!room.path("g").exists());
    assert_eq!(room.unfinished(), Vec::<String>::new());
    // The same over an earlier grading leaves that as it was.
    room.write("small.csv", &many_rows(10, 3));
    assert!(room.run(&["grade", "set", "small.csv", "--out", "g", "--reports", "no"]).status.success());
    let old = tree(&room.path("g"));
    let ran = room.limited("ulimit -f 512", "grade set in.csv --out g --reports no --force");
    assert_eq!(ran.status.code(), Some(2));
    assert!(tree(&room.path("g")) == old);
    // A set as well.
    let roster: String = (0..200).map(|i| format!("t{i}\n")).collect();
    room.write("more.csv", format!("student\n{roster}").as_bytes());
    let ran =
        room.limited("ulimit -f 40", "generate wheels-on-inclines --roster more.csv --seed 1 --out new");
    assert_eq!(ran.status.code(), Some(2), "{ran:?}");
    assert!(!room.path("new").exists());
    assert_eq!(room.unfinished(), Vec::<String>::new());
}

#[test]
fn standard_output_on_a_full_disk_is_a_fault_and_a_reader_who_leaves_is_none() {
    let room = Room::new(3);
    if Path::new("/dev/full").exists() {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let ran = room.command().arg("course").stdout(full).output().unwrap();
        assert_eq!(ran.status.code(), Some(2), "{ran:?}");
        assert!(stderr(&ran).contains("the disk is full"), "{}", stderr(&ran));
    }
    let mut child =
        room.command().arg("course").stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert!(child.wait().unwrap().code().is_some_and(|c| c < 3), "{said}");
    assert!(!said.contains("panicked"), "{said}");
}

#[test]
fn files_that_cannot_be_read() {
    let room = Room::new(3);
    room.write("in.csv", &many_rows(10, 3));
    fs::create_dir(room.path("folder")).unwrap();
    for (file, said) in
        [("folder", "holds no file of answers"), ("absent.csv", "no such file"), ("in.csv/x", "no such file")]
    {
        let ran = room.run(&["grade", "set", file, "--out", "g"]);
        assert_eq!(ran.status.code(), Some(2), "{file}");
        assert!(stderr(&ran).contains(said) && stderr(&ran).contains(file), "{file}: {}", stderr(&ran));
        assert!(!room.path("g").exists());
    }
    // Root reads everything.
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(room.path("in.csv"), fs::Permissions::from_mode(0o0)).unwrap();
    if fs::File::open(room.path("in.csv")).is_err() {
        let ran = room.grade("g", &[]);
        assert_eq!(ran.status.code(), Some(2));
        assert!(stderr(&ran).contains("permission denied"), "{}", stderr(&ran));
    }
}

/// The library walks over a file twice: what changes between the walks is told by the program, which looks at the size and
/// the time of the file before and after.
#[test]
fn a_file_that_changes_while_it_is_graded() {
    let room = Room::new(3);
    let rows = many_rows(150_000, 3);
    room.write("in.csv", &rows);
    let begun = Instant::now();
    assert!(room.grade("g", &[]).status.success());
    let lasts = begun.elapsed();
    let mut told = 0;
    // How long a grading lasts depends on what else runs: some rounds more until a change falls into one.
    for nth in (1..=8u32).cycle().take(64) {
        if nth == 1 && told > 0 {
            break;
        }
        room.write("in.csv", &rows);
        let child = room
            .command()
            .args(["grade", "set", "in.csv", "--out", "g", "--reports", "no", "--force"])
            .stderr(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        thread::sleep(lasts.mul_f64(f64::from(nth) / 9.0));
        let file = fs::OpenOptions::new().write(true).open(room.path("in.csv")).unwrap();
        file.set_len(rows.len() as u64 / 2).unwrap();
        drop(file);
        let ran = child.wait_with_output().unwrap();
        let lines = |bytes: &[u8]| bytes.iter().filter(|b| **b == b'\n').count();
        match ran.status.code() {
            Some(0) => {
                // All of the file before or after it shrank.
                let written = lines(&fs::read(room.path("g/answers.csv")).unwrap());
                let half = lines(&rows[..rows.len() / 2]);
                assert!(written == lines(&rows) || written.abs_diff(half) <= 1, "{written}");
            }
            Some(2) => {
                assert!(stderr(&ran).contains("was changed while it was graded"), "{}", stderr(&ran));
                told += 1;
            }
            other => panic!("{other:?}: {}", stderr(&ran)),
        }
        assert_eq!(room.unfinished(), Vec::<String>::new());
    }
    assert!(told > 0, "none of the changes fell into a grading");
}

#[test]
fn every_row_has_a_verdict_whatever_its_bytes() {
    let room = Room::new(3);
    let parts: &[&[u8]] = &[
        b"student,problem,part,answer",
        b"s0,1,omega,30",
        b"s0,1,ome\0ga,30",
        b"s0,1,omega,\xff\xfe30",
        b"s1,1,omega,31\rs1,1,v,3",
        b"s1,1,friction,\"62.6",
        b"s2,1,omega,1",
        b"s2,1,v,2",
    ];
    let rows = room.graded(&[parts.join(&b'\n'), b"\n".to_vec()].concat());
    // The lone CR ends a row: eight rows below the header.
    assert_eq!(rows.len(), 8, "{rows:#?}");
    let lines: Vec<&str> = rows.iter().map(|r| r[0].as_str()).collect();
    assert_eq!(lines, ["2", "3", "4", "5", "6", "7", "8", "9"]);
    assert_eq!((&*rows[1][6], &*rows[5][6]), ("unreadable", "unreadable"), "{rows:#?}");
    assert_eq!((&*rows[6][2], &*rows[7][2]), ("s2", "s2"), "the open quote swallows nothing");
    assert!(rows.iter().all(|r| !r[6].is_empty() && !r[9].is_empty()));
}

fn a_long_row(bytes: usize, memory: &str) {
    let room = Room::new(3);
    let file = fs::File::create(room.path("in.csv")).unwrap();
    let mut out = std::io::BufWriter::new(file);
    out.write_all(b"student,problem,part,answer\ns0,1,omega,30\ns1,1,omega,").unwrap();
    let block = vec![b'9'; 1 << 20];
    for _ in 0..bytes >> 20 {
        out.write_all(&block).unwrap();
    }
    out.write_all(b"\ns2,1,omega,31\n").unwrap();
    out.into_inner().unwrap();
    let ran = room.limited(memory, "grade set in.csv --out g --reports no");
    assert!(ran.status.success(), "{ran:?}");
    let mut reader = csv::Reader::from_path(room.path("g/answers.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let shown: Vec<(&str, &str)> = rows.iter().map(|r| (&r[0], &r[6])).collect();
    assert_eq!(shown, [("2", "wrong"), ("3", "unreadable"), ("4", "wrong")]);
    assert!(rows[1].iter().map(str::len).sum::<usize>() < 1000, "a long row is cut where it is shown");
}

#[test]
fn a_row_of_20_mb() {
    a_long_row(20 << 20, "true");
}

#[test]
#[ignore = "seconds: a row of 100 MB in less memory than it has, with 60 MB for stacks and the program itself"]
fn a_row_of_100_mb_is_never_held() {
    // Data segments only: what is mapped for the program's code does not count.
    a_long_row(100 << 20, "ulimit -d 80000");
}

#[test]
fn formulas_are_not_run_by_spreadsheets() {
    let room = Room::new(3);
    let formulas = [
        "=cmd|' /C calc'!A0",
        "=1+1",
        "+1+1",
        "-2+3",
        "@SUM(1)",
        "\t=1+1",
        "-2/A1",
        "＝1+1",
        "=HYPERLINK(\"x\")",
    ];
    let numbers = ["-62.6", "+3e5", "-62.6 N", "-1.5e-3 kN"];
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut text = "student,problem,part,answer,submitted_at\n".to_owned();
    for odd in formulas.iter().chain(&numbers) {
        let odd = quoted(odd);
        for row in [
            format!("{odd},1,omega,30,2026-01-01"),
            format!("s0,{odd},omega,30,2026-01-01"),
            format!("s0,1,{odd},30,2026-01-01"),
            format!("s0,1,omega,{odd},2026-01-01"),
            format!("s0,1,omega,30,{odd}"),
            format!("{odd},{odd}"), // too few fields: shown whole
        ] {
            text.push_str(&row);
            text.push('\n');
        }
    }
    let rows = room.graded(text.as_bytes());
    assert_eq!(rows.len(), 6 * (formulas.len() + numbers.len()));
    let runs = |cell: &str| {
        let plain = cell.parse::<f64>().is_ok() || numbers.contains(&cell);
        cell.starts_with(['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠']) && !plain
    };
    for row in &rows {
        assert!(!row.iter().any(|cell| runs(cell)), "{row:?}");
    }
    for number in numbers {
        assert!(rows.iter().any(|r| r[5] == number), "{number} is no longer what was written");
    }
    assert!(
        rows.iter().filter(|r| r[5].starts_with("'=")).count() >= 2,
        "formulas are shown with an apostrophe"
    );
}

#[test]
fn formulas_in_names_stay_texts_in_every_csv() {
    let room = Room(tempfile::tempdir().unwrap());
    room.write("roster.csv", "student,name\n=1+1,@SUM(1)\n+x1,\"=cmd|' /C calc'!A0\"\ns3,-2+3\n".as_bytes());
    room.generate();
    room.write("in.csv", b"student,problem,part,answer\n=1+1,1,omega,30\n+x1,1,omega,=2+2\ns3,1,omega,30\n");
    let ran = room.run(&["grade", "set", "in.csv", "--out", "g", "--reports", "yes"]);
    assert!(ran.status.success(), "{}", stderr(&ran));
    assert!(cells_that_run(&room, &["roster.csv", "in.csv"]) > 20);
}

/// A workbook in the place of a CSV file, through the street door: one clear message, and nothing written.
#[test]
fn a_workbook_is_named_where_csv_is_wanted() {
    let room = Room::new(3);
    room.write("class.xlsx", b"PK\x03\x04\x14\0[Content_Types].xml\0xl/workbook.xml");
    for args in [
        &["grade", "set", "class.xlsx", "--out", "g"][..],
        &["generate", "wheels-on-inclines", "--roster", "class.xlsx", "--seed", "1", "--out", "g"],
    ] {
        let ran = room.run(args);
        let told = stderr(&ran);
        assert_eq!(ran.status.code(), Some(2), "{told}");
        assert!(told.starts_with("error: class.xlsx: ") && told.lines().count() == 1, "{told}");
        assert!(
            told.contains("an Excel workbook (.xlsx)") && told.contains("save the sheet as CSV"),
            "{told}"
        );
        assert!(!room.path("g").exists());
    }
}

/// Cells of all CSV files of a room but these; none of them may be run by a spreadsheet.
fn cells_that_run(room: &Room, own: &[&str]) -> usize {
    let mut seen = 0;
    for (name, bytes) in tree(room.0.path()) {
        if !name.ends_with(".csv") || own.contains(&name.as_str()) {
            continue;
        }
        let head = &bytes[..bytes.len().min(300)];
        let delimiter = if head.contains(&b';') && !head.contains(&b',') { b';' } else { b',' };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(delimiter)
            .from_reader(&bytes[..]);
        for record in reader.byte_records().map(Result::unwrap) {
            for cell in &record {
                let cell = String::from_utf8_lossy(cell);
                seen += 1;
                let odd = cell.starts_with(['=', '+', '-', '@', '\t', '\r', '＝', '＋', '－', '＠']);
                let number = cell[1.min(cell.len())..].starts_with(|c: char| c.is_ascii_digit());
                assert!(!odd || number, "{name}: {cell}");
            }
        }
    }
    seen
}

/// The earlier tests looked at what `grade` writes, and at ids that a guard changes only in writing: the key, the form and the
/// simulated files had none, and nobody filled in a form whose ids had one.
#[test]
fn formula_like_ids_come_back_through_every_file() {
    let room = Room(tempfile::tempdir().unwrap());
    let ids = ["=1+1", "+x1", "-y+1", "@SUM(1)", "'=quoted", "plain", "＝wide", "\"a\"\"b\""];
    room.write(
        "roster.csv",
        format!("student,name\n{}", ids.map(|id| format!("{id},N\n")).concat()).as_bytes(),
    );
    room.generate();
    // The form filled in, with its own ids.
    let form = fs::read_to_string(room.path("set/submissions.csv")).unwrap();
    let filled: String =
        form.lines().map(|l| if l.ends_with(',') { format!("{l}30\n") } else { format!("{l}\n") }).collect();
    room.write("in.csv", filled.as_bytes());
    for (what, args) in [
        ("simulate", "simulate set --out sim.csv --truth truth.csv --seed 3"),
        ("grade the form", "grade set in.csv --out g --reports yes"),
        ("grade what is simulated", "grade set sim.csv --out g2 --reports yes"),
        ("what-if", "what-if g"),
        ("verify", "verify set"),
        ("explain", "explain g =1+1 1"),
        (
            "another roster from the form",
            &GENERATE.replace("roster.csv", "again.csv").replace("out set", "out set-2"),
        ),
    ] {
        if what.starts_with("another") {
            // Ids as the key has them, as somebody would copy them into a new roster.
            let key = fs::read_to_string(room.path("set/key.csv")).unwrap();
            let mut reader = csv::ReaderBuilder::new().from_reader(key.as_bytes());
            let mut again = csv::Writer::from_path(room.path("again.csv")).unwrap();
            again.write_record(["student"]).unwrap();
            let mut last = String::new();
            for record in reader
                .records()
                .map(Result::unwrap)
                .filter(|r| r[0] != *std::mem::replace(&mut last, r[0].to_owned()))
            {
                again.write_record([&record[0]]).unwrap();
            }
            again.flush().unwrap();
        }
        let ran = room.run(&args.split(' ').collect::<Vec<_>>());
        assert!(ran.status.success(), "{what}: {}{}", stderr(&ran), String::from_utf8_lossy(&ran.stdout));
    }
    let answers = fs::read_to_string(room.path("g/answers.csv")).unwrap();
    assert!(!answers.contains("unknown student"), "{answers}");
    assert!(!fs::read_to_string(room.path("g2/answers.csv")).unwrap().contains("unknown student"));
    assert_eq!(
        fs::read(room.path("set/key.csv")).unwrap(),
        fs::read(room.path("set-2/key.csv")).unwrap(),
        "other ids, or other draws"
    );
    assert!(cells_that_run(&room, &["roster.csv"]) > 500);
}

/// Both may have looked before either was done.
#[test]
fn of_two_runs_into_one_new_folder_one_is_refused() {
    let room = Room::new(40);
    let args = |seed| format!("generate wheels-on-inclines --roster roster.csv --seed {seed} --out new");
    let runs = ["1", "2"].map(|seed| {
        let args = args(seed);
        let run = room.command().args(args.split(' ')).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
        run.unwrap()
    });
    let ended = runs.map(|run| run.wait_with_output().unwrap());
    let mut codes = ended.each_ref().map(|ran| ran.status.code());
    codes.sort();
    assert_eq!(codes, [Some(0), Some(2)], "{ended:?}");
    let won = usize::from(ended[0].status.code() == Some(2));
    let told = stderr(&ended[1 - won]);
    assert!(
        told.contains("new") && told.contains("in the way") || told.contains("is there already"),
        "{told}"
    );
    let set = fs::read_to_string(room.path("new/set.json")).unwrap();
    assert!(set.contains(&format!("\"seed\": {}", won + 1)), "{set}");
    assert_eq!(room.unfinished(), Vec::<String>::new());
}
