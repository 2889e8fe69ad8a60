//! What no worked solution covers, in a set with what one does: exit codes, notes, and a short page in each format and language.
//!
//! The earlier tests worked the built-in banks alone, all of whose problems are covered: that one problem which is not refuses
//! the solutions of the whole set, after `generate` had said nothing, could not be seen there. Nor could it be seen that a wheel
//! which only its friction drives counted as at rest.
#![expect(clippy::unwrap_used, reason = "a test that cannot set itself up fails")]
use slipstick::cli;
use slipstick::cli::tell::Exit;
use slipstick::cli::tell::Io;
use slipstick::words::Words;
use std::ffi::OsString;
use std::fs;
use tempfile::TempDir;

struct Room(TempDir);

struct Ran {
    exit: Exit,
    out: String,
    err: String,
}

impl Room {
    fn path(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }
    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }
    fn run(&self, args: &[&str]) -> Ran {
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
        let mut io = Io { input: &mut &b""[..], out: &mut out, err: &mut err, watched: false, typed: false };
        let exit = cli::run(words, &mut io);
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Ran { exit, out: text(out), err: text(err) }
    }
}

/// A wheel on a floor that a couple drives; the rest of its scene, its regime and what is asked are given.
fn driven(id: &str, couple: &str, end: &str, regime: &str, line: &str) -> String {
    format!(
        "  {id}:
    title: A driven wheel
    data:
      m: {{name: mass, unit: kg, draw: 20 to 30 step 1}}
      R: {{name: radius, unit: mm, draw: 250 to 400 step 10}}
      M: {{name: couple, unit: N m, draw: 80 to 120 step 1}}
      d: {{name: distance or time, unit: {unit}, draw: 1.0 to 4.0 step 0.1}}
      mu_s: {{name: static friction, unit: '1', draw: 'one of 0.25, 0.3'}}
      mu_k: {{name: kinetic friction, unit: '1', draw: 'one of 0.18, 0.2'}}
    scene:
      surfaces: {{floor: {line}}}
      bodies:
        wheel: {{mass: m, shape: {{disc: R}}, radii: {{rim: R}}, moves: along floor}}
      ties: [slips: {{body: wheel, on its: rim, mu_s: mu_s, mu_k: mu_k}}]
      forces: [couple: {{on: wheel, moment: M, sense: {couple}}}]
      start: at rest
      end: {end}
    regimes: [{regime}]
    questions:
      v: {{ask: the speed of the centre, unit: m/s}}
      friction: {{ask: 'the friction, with its direction', unit: N, tolerance: {{relative: 2 %}}}}
      omega: {{ask: the spin, unit: rad/s, tolerance: {{relative: 2 %}}}}
      heat: {{ask: the heat, unit: J, tolerance: {{relative: 3 %}}, cond limit: 20}}
    statement: 'A disc {{{{ m }}}}, {{{{ R }}}}, {{{{ M }}}}, {{{{ d }}}}, {{{{ mu_s }}}}, {{{{ mu_k }}}}, {{{{ g }}}}.'
",
        unit = if end.contains("time") { "s" } else { "m" },
    )
}

fn bank(problems: &[String]) -> String {
    format!("bank: driven\ntitle: Driven wheels\nproblems:\n{}", problems.concat())
}

const TRAVEL: &str = "{travel: {of: wheel, by: d}}";
const TIME: &str = "{time: {of: wheel, is: d}}";

/// It moves: the couple spins the wheel, and friction drives it, either way, with or without a declared heading, up a slope too.
#[test]
fn a_wheel_that_its_friction_alone_drives_has_a_worked_solution() {
    let back = "{travel: {of: wheel, by: d, heading: back}}";
    let cases = [
        driven("a", "forward", TRAVEL, "slips_forward", "level"),
        driven("b", "back", TRAVEL, "slips_back", "level"),
        driven("c", "back", back, "slips_back", "level"),
        driven("d", "forward", "{travel: {of: wheel, by: d, heading: forward}}", "slips_up", "level"),
        driven("e", "forward", TRAVEL, "slips_up", "{slope: 4 deg}"),
        driven("f", "back", TRAVEL, "slips_down", "{slope: 3 deg}"),
    ];
    let room = Room(TempDir::new().unwrap());
    fs::write(room.path("bank.yaml"), bank(&cases)).unwrap();
    fs::write(room.path("roster.csv"), "student\n1\n2\n3\n").unwrap();
    let (bank, roster, set, out) =
        (room.path("bank.yaml"), room.path("roster.csv"), room.path("set"), room.path("out"));
    let lint = room.run(&["lint", &bank, "--seeds", "5"]);
    assert_eq!(lint.exit, Exit::Fine, "{}", lint.err);
    assert!(!lint.out.contains("short page"), "{}", lint.out);
    let made = room.run(&["generate", &bank, "--roster", &roster, "--seed", "3", "--out", &set]);
    assert_eq!((made.exit, made.err.as_str()), (Exit::Fine, ""));
    let ran = room.run(&["solutions", &set, "--out", &out]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    let text = room.read("out/1/solution.md");
    let words = Words::english();
    assert!(!text.contains(words.get("solution.title.beyond")), "{text}");
    assert_eq!(text.matches(words.get("solution.title.agree")).count(), cases.len());
    assert!(text.contains(r"$$F\,(d - \varphi\,R) + M\,\varphi"), "{text}");
}

/// Some that are covered and some that are not, in one set: all formats, both languages, booklets.
#[test]
fn what_is_not_covered_has_a_short_page_and_refuses_nothing() {
    let kinds = [
        driven("whole", "forward", TRAVEL, "slips_forward", "level"),
        driven("short", "forward", TIME, "slips_forward", "level"),
        driven("steep", "back", TIME, "slips_down", "{slope: 3 deg}"),
    ];
    let room = Room(TempDir::new().unwrap());
    fs::write(room.path("bank.yaml"), bank(&kinds)).unwrap();
    fs::write(room.path("roster.csv"), "student\n1\n2\n").unwrap();
    let (bank, roster) = (room.path("bank.yaml"), room.path("roster.csv"));
    let lint = room.run(&["lint", &bank, "--seeds", "5"]);
    assert_eq!(lint.exit, Exit::Fine, "{}", lint.err);
    assert_eq!(lint.out.matches("    note: the worked solution is a short page").count(), 2, "{}", lint.out);
    let mut formats = vec!["html", "md", "tex"];
    if cfg!(feature = "pdf") {
        formats.push("pdf");
    }
    for language in Words::languages() {
        let words = Words::of(language).unwrap();
        let (set, out) = (room.path(&format!("set-{language}")), room.path(&format!("out-{language}")));
        let made = room.run(&[
            "generate",
            &bank,
            "--roster",
            &roster,
            "--seed",
            "3",
            "--out",
            &set,
            "--language",
            language,
        ]);
        assert_eq!(made.exit, Exit::Fine, "{}", made.err);
        let told: Vec<&str> = made.err.lines().collect();
        assert!(told.len() == 2 && told.iter().all(|l| l.starts_with("note: problems.s")), "{}", made.err);
        let ran = room.run(&["solutions", &set, "--out", &out, "--format", &formats.join(",")]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        assert!(ran.err.contains("(for 2 students)") && ran.err.lines().count() == 2, "{}", ran.err);
        let reason = words.get("solution.beyond.slip_in_company");
        let key = room.read(&format!("set-{language}/key.csv"));
        for format in ["html", "md", "tex"] {
            let text = room.read(&format!("out-{language}/1/solution.{format}"));
            let booklet = fs::read_to_string(room.0.path().join(format!("out-{language}/booklet.{format}")));
            let plain = |text: &str| text.replace("{,}", ".").replace(',', ".");
            assert_eq!(plain(&text).matches(&plain(reason)).count(), 2, "{format}: {text}");
            assert_eq!(text.matches(words.get("solution.title.beyond")).count(), 2, "{format}");
            assert_eq!(text.matches(words.get("solution.title.agree")).count(), 1, "{format}");
            if let Ok(booklet) = booklet {
                assert_eq!(plain(&booklet).matches(&plain(reason)).count(), 4, "{format}");
            }
            // Every answer of the student stands there, the short pages' too.
            let text = plain(&text);
            for row in key.lines().filter(|r| r.starts_with("1,")) {
                let cells: Vec<&str> = row.split(',').collect();
                let value =
                    slipstick::sheet::number::rounded(cells[3].trim_start_matches('-').parse().unwrap(), 3);
                assert!(text.contains(&value), "{format}: {value} of {row}");
            }
        }
        if cfg!(feature = "pdf") {
            let pdf = fs::read(room.0.path().join(format!("out-{language}/1/solution.pdf"))).unwrap();
            assert!(pdf.starts_with(b"%PDF"));
        }
    }
}
