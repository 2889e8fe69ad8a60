//! What is told where draws are refused: what came out instead, with units, the setting that changes a limit, and for constants all
//! that `solve` says. And the words of regimes, on levels too.
//!
//! The earlier tests pinned a table with one bound and asked no more than that it is there: that it said "regime" without saying
//! which, "the key is proved" where it was not, and drew constants ten thousand times, no test could see.
use crate::support::program;
use crate::support::program::Ran;
use slipstick::bank::load;
use slipstick::cli::tell::Exit;
use slipstick::problem::maker::Maker;
use slipstick::solve::outcome::Motion;
use slipstick::words::Words;
use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;
use tempfile::TempDir;

struct Room(TempDir);

impl Room {
    fn new() -> Self {
        let room = Self(TempDir::new().unwrap());
        fs::write(room.path("roster.csv"), "student\n1\n2\n").unwrap();
        room
    }
    fn path(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }
    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }
    fn run(&self, args: &[&str]) -> Ran {
        program::run_with(args, "\n\n")
    }
    /// What `lint` says of a bank that cannot be drawn.
    /// The sheet that a student gets of a bank.
    fn sheet(&self, bank: &str) -> String {
        fs::write(self.path("bank.yaml"), bank).unwrap();
        let (bank, roster, set) = (self.path("bank.yaml"), self.path("roster.csv"), self.path("set"));
        let ran =
            self.run(&["generate", &bank, "--roster", &roster, "--seed", "1", "--out", &set, "--force"]);
        assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
        self.read("set/students/1/sheet.md")
    }
    fn lint(&self, bank: &str) -> String {
        fs::write(self.path("bank.yaml"), bank).unwrap();
        let ran = self.run(&["lint", &self.path("bank.yaml"), "--seeds", "2"]);
        assert_eq!(ran.exit, Exit::Faulty, "{}", ran.out);
        ran.err
    }
}

/// What is replaced in a bank, and by what.
type Changes = &'static [(&'static str, &'static str)];

/// A disc that rolls down a slope.
const ROLLS: &str = "bank: rolls
title: Rolls
problems:
  p:
    title: A disc
    data:
      m: {name: mass, unit: kg, draw: 2 to 9 step 0.5}
      R: {name: radius, unit: mm, draw: 150 to 400 step 10}
      theta: {name: slope, unit: deg, draw: 8 to 30 step 1}
      d: {name: distance, unit: m, draw: 1.0 to 4.0 step 0.1}
      mu_s: {name: static friction, unit: '1', draw: 'one of 0.4, 0.5'}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies:
        disc: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: along incline, positive: down}
      ties: [rolls: {body: disc, on its: rim, mu_s: mu_s}]
      start: at rest
      end: {travel: {of: disc, by: d}}
    regimes: [moves_down]
    questions:
      v: {ask: the speed, unit: m/s}
      friction: {ask: the friction, unit: N}
    statement: '{{ m }}{{ R }}{{ theta }}{{ d }}{{ mu_s }}{{ g }}'
";

/// Each kind of rule: what the bank is changed to, and what is told.
#[test]
fn a_refusal_tells_what_came_out_and_what_changes_it() {
    let room = Room::new();
    let cases: &[(Changes, &[&str])] = &[
        (
            &[("[moves_down]", "[moves_up]")],
            &["10000  regime: 10000 of 10000 move down (`regimes`: moves_up)"],
        ),
        (
            &[("[moves_down]", "[balanced, moves_up]")],
            &["regime: 10000 of 10000 move down (`regimes`: balanced, moves_up)"],
        ),
        (&[("one of 0.4, 0.5", "always 0.01")], &["10000  no_slip: margin -", "% (`margins`: 5 %)"]),
        (
            &[("unit: m/s}", "unit: m/s, cond limit: 1.1}")],
            &["10000  cond of v above 1.1: ", " (`cond limit`)"],
        ),
        (
            &[("    regimes:", "    bounds: {v: {max: 0.3 m/s}}\n    regimes:")],
            &["10000  bound v: ", " m/s (wanted: at most 0.3 m/s)"],
        ),
        (
            &[("    regimes:", "    bounds: {d * 2: {min: 9 m, max: 10 m}}\n    regimes:")],
            &["10000  bound d * 2: 2 m to 8 m (wanted: 9 m to 10 m)"],
        ),
        (
            &[
                (
                    "on its: rim, mu_s: mu_s}]",
                    "on its: rim, mu_s: mu_s}, cord: {from: {body: disc, tied at: centre, leaves: forward}, spring: {stiffness: 400 N/m, stretch: 0.1 m, attached: rigidly}}]",
                ),
                ("1.0 to 4.0 step 0.1", "0.001 to 0.002 step 0.001"),
                ("[moves_down]", "[down ok]"),
                ("cond limit: 1.1", ""),
            ],
            &["input energy above 4 times the kinetic: ", " times (`input energy limit`)"],
        ),
        (
            &[
                ("start: at rest", "start: {disc: {speed: 0.1 m/s}}"),
                ("{travel: {of: disc, by: d}}", "{speed: {of: disc, reaches: v1}}"),
                (
                    "d: {name: distance, unit: m, draw: 1.0 to 4.0 step 0.1}",
                    "v1: {name: speed, unit: m/s, draw: 0.01 to 0.05 step 0.01}",
                ),
                ("{{ d }}", "{{ v1 }}"),
            ],
            &["10000  reaches: does not hold"],
        ),
    ];
    for (changes, told) in cases {
        let bank = changes.iter().fold(ROLLS.to_owned(), |b, (from, to)| b.replace(from, to));
        let err = room.lint(&bank);
        for piece in *told {
            assert!(err.contains(piece), "{piece}\n{err}");
        }
        // No rule is praised where it refuses.
        for praise in [
            "the key is proved",
            "work and energy agree",
            "  solvable",
            "  admissible",
            "has an answer",
            "  regime\n",
        ] {
            assert!(!err.contains(praise), "{err}");
        }
    }
}

/// Several regimes come out: each with its number, and the numbers are those of the draws.
#[test]
fn regimes_that_came_out_are_counted() {
    let bank = ROLLS
        .replace(
            "      mu_s: {name",
            "      P: {name: pull, unit: N, draw: 1 to 60 step 1}\n      mu_s: {name",
        )
        .replace(
            "mu_s: mu_s}]",
            "mu_s: mu_s}, cord: {from: {body: disc, tied at: centre, leaves: back}, pulled with: P}]",
        )
        .replace("[moves_down]", "[rest]")
        .replace("'one of 0.4, 0.5'", "always 9")
        .replace("{{ d }}", "{{ d }}{{ P }}");
    let bank = load::scenes_only(&bank, "bank.yaml").unwrap();
    let none = Maker::new(&bank.problems[0], 1, "x").giving_up_after(400).variant("1").unwrap_err();
    let (row, count) = none.table.iter().find(|(row, _)| row.starts_with("regime: ")).unwrap();
    let numbers: Vec<u32> = row
        .split(", ")
        .map(|part| part.trim_start_matches("regime: ").split(' ').next().unwrap().parse().unwrap())
        .collect();
    assert!(
        row.contains(" move up") && row.contains(" move down") && row.ends_with("(`regimes`: rest)"),
        "{row}"
    );
    assert_eq!(numbers.iter().sum::<u32>(), *count, "{row}");
    assert_eq!(none.table.iter().map(|(_, n)| n).sum::<u32>(), 400, "{none}");
}

/// Constants are drawn once, and every command that draws shows the whole table of `solve`.
#[test]
fn constants_are_drawn_once_and_shown_as_solve_shows_them() {
    let room = Room::new();
    let constant = ROLLS
        .replace("2 to 9 step 0.5", "always 3")
        .replace("150 to 400 step 10", "always 200")
        .replace("8 to 30 step 1", "always 15")
        .replace("1.0 to 4.0 step 0.1", "always 2.0")
        .replace("'one of 0.4, 0.5'", "always 0.4")
        .replace("[moves_down]", "[moves_up]");
    fs::write(room.path("bank.yaml"), &constant).unwrap();
    let (bank, roster, set) = (room.path("bank.yaml"), room.path("roster.csv"), room.path("set"));
    let data = ["m=3 kg", "R=200 mm", "theta=15 deg", "d=2 m", "mu_s=0.4"];
    let mut args = vec!["solve", &bank, "p"];
    for d in &data {
        args.extend(["--set", d]);
    }
    let solved = room.run(&args);
    assert_eq!(solved.exit, Exit::RegimeFails, "{}", solved.err);
    let table = solved.out.split_once('\n').unwrap().1.trim_end();
    assert!(table.contains("\n  kinetic_energy") && table.contains("moves_down"), "{table}");
    let gallery = room.path("gallery.html");
    for args in [
        vec!["lint", &bank, "--seeds", "3"],
        vec!["generate", &bank, "--roster", &roster, "--seed", "1", "--out", &set],
        vec!["solve", &bank, "p", "--seed", "4"],
        vec!["practice", &bank, "--seed", "4"],
        vec!["gallery", &bank, "--out", &gallery],
    ] {
        let ran = room.run(&args);
        assert_eq!(ran.exit, Exit::Faulty, "{args:?}");
        assert!(
            ran.err.contains("          1  regime: 1 of 1 move down (`regimes`: moves_up)"),
            "{args:?} {}",
            ran.err
        );
        assert!(ran.err.contains(table), "{args:?} {}\n{table}", ran.err);
    }
    // Constants that hold the rules are drawn at once, too.
    fs::write(room.path("fine.yaml"), constant.replace("[moves_up]", "[moves_down]")).unwrap();
    let fine =
        room.run(&["generate", &room.path("fine.yaml"), "--roster", &roster, "--seed", "1", "--out", &set]);
    assert!(fine.out.contains("(2 draws)"), "{}{}", fine.out, fine.err);
}

/// What `lint` refuses of constants `solve` does not pass over: a question without an answer, a measurement with two.
#[test]
fn solve_says_what_is_not_answered() {
    let room = Room::new();
    let cart = |data: &str, more: &str, end: &str, question: &str| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n      m: {{name: mass, unit: kg, draw: always 4}}\n{data}    scene:
      surfaces: {{bed: level}}
      bodies: {{B: {{mass: m, moves: along bed}}}}
      {more}
      end: {end}
    questions: {{q: {question}}}
    statement: '{{{{ m }}}} {{{{ t1 }}}} {{{{ g }}}}'
"
        )
    };
    let time = "      t1: {name: time, unit: s, draw: always 2}\n";
    let pulled = "ties: [cord: {from: {body: B, tied at: centre, leaves: forward}, pulled with: 10 N}]\n      start: at rest";
    let nothing = cart(time, pulled, "{time: {of: B, is: t1}}", "{value: m/0, unit: kg, ask: none}");
    let solved = |text: &str| {
        fs::write(room.path("bank.yaml"), text).unwrap();
        room.run(&["solve", &room.path("bank.yaml"), "p"])
    };
    let said = solved(&nothing);
    assert!(said.err.contains("question q has no answer with these data"), "{}", said.err);
    let something = nothing.replace("m/0", "m/2");
    assert_eq!(solved(&something).err, "");
    // On the bed of a truck the way 2 m takes the same time whether the truck starts or brakes.
    let measured = "      t1: {name: time, unit: s, draw: always 2, measured: t}\n      A: {name: acceleration, unit: m/s^2, unknown: -5 to 5 step 0.1}\n";
    let truck = "carried: {along: bed, acceleration: A}\n      start: at rest";
    let end = "{travel: {of: B, by: 2 m}}";
    let two = cart(measured, truck, end, "{value: A, unit: m/s^2, ask: which}");
    let refused = solved(&two);
    assert_eq!(refused.exit, Exit::Faulty, "{}", refused.out);
    assert!(refused.err.contains("only one value of `A`"), "{}", refused.err);
    let one = solved(&two.replace("-5 to 5", "0.1 to 5"));
    assert!(one.exit == Exit::Fine && one.out.contains("1.00000000000"), "{}{}", one.out, one.err);
}

/// A block slides down a slope until the pull that grows turns it back: it does not go the other way, it turns.
#[test]
fn a_growing_force_turns_a_motion_unless_a_couple_may_brake_it() {
    let room = Room::new();
    let text = "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {t1: {name: time, unit: s, draw: always 5}}\n    scene:
      surfaces: {ramp: {slope: 30 deg}}
      bodies: {B: {mass: 4 kg, moves: along ramp}}
      ties: [cord: {from: {body: B, tied at: centre, leaves: forward}, pulled with: 10 N, growing by: 5 N/s}]
      start: at rest
      end: {time: {of: B, is: t1}}
    questions: {a: {ask: how fast, unit: m/s^2}}
    statement: '{{ t1 }} {{ g }}'
";
    fs::write(room.path("bank.yaml"), text).unwrap();
    // It slides down first, and is pulled up then: a = (P + c t)/m - g sin 30, and v is the sum of that over the time.
    let solved = room.run(&["solve", &room.path("bank.yaml"), "p"]);
    for (name, value) in [("v", 5.0 * (22.5 / 4.0 - 9.81 / 2.0)), ("a", 35.0 / 4.0 - 9.81 / 2.0)] {
        let line = solved.out.lines().find(|l| l.trim_start().starts_with(&format!("{name} "))).expect(name);
        let found: f64 = line.split_whitespace().nth(3).expect("a value").parse().expect("a number");
        assert!((found - value).abs() < 1e-11, "{name}: {line}");
    }
    assert!(solved.out.contains("regime: moves_up"), "{}", solved.out);
    let wheel = text
        .replace("{mass: 4 kg, moves", "{mass: 4 kg, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves")
        .replace("ties: [cord", "ties: [{rolls: {body: B, on its: rim}}, {cord")
        .replace("N/s}]", "N/s}}]\n      forces: [couple: {on: B, moment: 0.1 N*m}]");
    fs::write(room.path("bank.yaml"), wheel).unwrap();
    let solved = room.run(&["solve", &room.path("bank.yaml"), "p"]);
    assert!(solved.out.contains("5.0000 s lie after the turning point"), "{}", solved.out);
    assert!(solved.out.contains("a couple that stays may be a brake"), "{}", solved.out);
}

/// The end by a length of cord takes lengths and radii as data or as constants with their units.
#[test]
fn a_cord_unwinds_by_a_datum_or_a_constant() {
    let room = Room::new();
    let [length, breadth] =
        ["L: {name: length, unit: m, draw: always 1}", "b: {name: breadth, unit: cm, draw: always 10}"];
    // 9 N over 1 m are 1/2 I omega^2 with I = 0.08 kg m^2.
    for (data, rim, by) in [
        (length, "0.2 m", "L"),
        (breadth, "2*b", "100 cm"),
        (breadth, "2*b", "b*10"),
        ("", "200 mm", "1 m"),
        (breadth, "0.2 m", "10*b"),
    ] {
        let told = data.get(..1).map_or_else(String::new, |symbol| format!("{{{{ {symbol} }}}}"));
        let text = format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{{data}}}\n    scene:
      bodies: {{D: {{mass: 4 kg, shape: {{disc: {rim}}}, radii: {{rim: {rim}}}, moves: about a fixed axle}}}}
      ties: [cord: {{name: c, from: {{body: D, wound on: rim, leaves: front down}}, pulled with: 9 N}}]
      start: at rest
      end: {{unwinds: {{cord: c, by: {by}}}}}
    questions: {{omega: {{ask: how fast, unit: rad/s}}}}
    statement: '{told} {{{{ g }}}}'
"
        );
        fs::write(room.path("bank.yaml"), text).unwrap();
        let solved = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert!(solved.out.contains("15.0000000000"), "{rim} {by}: {}{}", solved.out, solved.err);
    }
    let text = "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {}\n    scene:
      surfaces: {ramp: {slope: 30 deg}}
      bodies: {ball: {mass: 6 kg, shape: {sphere: any}, moves: along ramp, positive: down}}
      ties: [rolls: {body: ball, on its: rim}]
      start: at rest
      end: {descent: {of: ball, by: 120 cm}}
    questions: {v: {ask: how fast, unit: m/s}}
    statement: '{{ g }}'
";
    fs::write(room.path("bank.yaml"), text).unwrap();
    let solved = room.run(&["solve", &room.path("bank.yaml"), "p"]);
    let v = format!("{:.10}", (2.0f64 * 9.81 * 1.2 / 1.4).sqrt());
    assert!(solved.out.contains(&v), "{v}: {}{}", solved.out, solved.err);
}

/// Every end of a motion: what is asked and how far it goes have units, whether it is reached or not.
#[test]
fn ends_are_told_with_their_units() {
    let room = Room::new();
    let thrown = |end: &str| {
        ROLLS
            .replace("positive: down", "positive: up")
            .replace("start: at rest", "start: {disc: {speed: 2 m/s}}")
            .replace("{travel: {of: disc, by: d}}", end)
            .replace("      d: {name: distance, unit: m, draw: 1.0 to 4.0 step 0.1}\n", "")
            .replace("{{ d }}", "")
            .replace("    regimes: [moves_down]\n", "")
    };
    let swings = |end: &str, unit: &str| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: T\n    data:\n      m: {{name: m, unit: kg, draw: always 2}}\n      \
             L: {{name: L, unit: m, draw: always 1}}\n    scene:\n      bodies:\n        disc: {{mass: m, shape: {{rod: L}}, pinned: at its end, angle: from hanging}}\n      \
             start: {{disc: {{angle: 40 deg}}}}\n      end: {end}\n    questions:\n      {unit}: {{ask: x, unit: {u}}}\n    statement: '{{{{ m }}}}{{{{ L }}}}{{{{ g }}}}'\n",
            u = if unit == "T" { "J" } else { "rad/s^2" },
        )
    };
    let cases = [
        (thrown("{travel: {of: disc, by: 10 cm}}"), "m", true),
        (thrown("{travel: {of: disc, by: 90 m}}"), "m", false),
        (thrown("{position: {of: disc, at: 0.2 m}}"), "m", true),
        (thrown("{position: {of: disc, at: 40 m}}"), "m", false),
        (thrown("{turn: {of: disc, by: 20 deg}}"), "rad", true),
        (thrown("{turn: {of: disc, by: 90 rev}}"), "rad", false),
        (thrown("{time: {of: disc, is: 0.1 s}}"), "s", true),
        (thrown("{time: {of: disc, is: 90 s}}"), "s", false),
        (thrown("{speed: {of: disc, reaches: 1 m/s}}"), "m/s", true),
        (thrown("{turning point: disc}"), "m", true),
        (swings("{angle: {of: disc, reaches: 10 deg}}", "alpha"), "degrees", true),
        (swings("{angle: {of: disc, reaches: 90 deg}}", "alpha"), "degrees", false),
        (swings("{time: {of: disc, is: 0.1 s}}", "alpha"), "s", true),
        (swings("{speed: {of: disc, reaches: 99 rad/s}}", "alpha"), "rad/s", false),
    ];
    for (bank, unit, reached) in cases {
        fs::write(room.path("bank.yaml"), &bank).unwrap();
        let path = room.path("bank.yaml");
        let mut args = vec!["solve", path.as_str(), "p"];
        let data: &[&str] =
            if bank.contains("rod: L") { &["m=2", "L=1"] } else { &["m=3", "R=0.2", "theta=15", "mu_s=0.6"] };
        for d in data {
            args.extend(["--set", d]);
        }
        let ran = room.run(&args);
        let line = ran
            .out
            .lines()
            .find(|l| l.contains("  reaches: "))
            .unwrap_or_else(|| panic!("{}{}", ran.out, ran.err));
        assert_eq!(line.contains("holds"), reached, "{line}");
        let words: Vec<&str> = line.split([' ', ',']).filter(|w| !w.is_empty()).collect();
        let numbers: Vec<usize> = (0..words.len()).filter(|i| words[*i].parse::<f64>().is_ok()).collect();
        assert!(!numbers.is_empty(), "{line}");
        for i in numbers {
            assert_eq!(words.get(i + 1), Some(&unit), "{line}");
        }
    }
}

/// Wherever a decimal number is read, one that is too long is told as that, with the limit, and never as no number.
#[test]
fn too_many_digits_are_told_with_the_limit() {
    let long = "4.297183463481174";
    let changes = [
        ("2 to 9 step 0.5", format!("always {long}")),
        ("2 to 9 step 0.5", format!("2 to {long} step 1")),
        ("2 to 9 step 0.5", format!("'one of 2, {long}'")),
        ("2 to 9 step 0.5", format!("'one of 2, -{long}'")),
        ("title: Rolls", format!("title: Rolls\ngravity: {long} m/s^2")),
        ("title: Rolls", format!("title: Rolls\ntolerance: {{relative: {long} %}}")),
        ("unit: m/s}", format!("unit: m/s, cond limit: {long}}}")),
        ("unit: m/s}", format!("unit: m/s, points: {long}}}")),
        ("    regimes:", format!("    bounds: {{v: {{max: {long} m/s}}}}\n    regimes:")),
    ];
    for (from, to) in changes {
        let faults = load::scenes_only(&ROLLS.replace(from, &to), "bank.yaml").unwrap_err();
        let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
        let told = told.join("\n");
        assert!(told.contains(long) && told.contains("has too many digits: 16 in all"), "{to}: {told}");
        assert!(told.contains("at most 15"), "{to}: {told}");
        assert!(!told.contains("is not a decimal number"), "{to}: {told}");
    }
}

/// A wheel or block on a level, or a drum about an axle: slips and springs, either way.
fn level(kind: &str, sense: &str, regime: &str) -> String {
    let (data, body, tie, couple, end, ask, used) = match kind {
        "slip" => (
            "      mu: {name: friction, unit: '1', draw: 'one of 0.2, 0.3'}\n",
            "wheel: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: along floor}",
            "slips: {body: wheel, on its: rim, mu_s: mu, mu_k: 0.1}".to_owned(),
            format!("      forces: [couple: {{on: wheel, moment: 90 N m, sense: {sense}}}]\n"),
            "{travel: {of: wheel, by: 1 m}}",
            "friction: {ask: 'the friction', unit: N}",
            "{{ mu }}",
        ),
        "pull" => (
            "      k: {name: radius of gyration, unit: mm, draw: 150 to 200 step 10}\n",
            "wheel: {mass: m, radius of gyration: k, radii: {rim: R}, moves: along floor}",
            format!(
                "cord: {{from: {{body: wheel, wound on: rim, leaves: top {sense}}}, pulled with: 50 N}}, rolls: {{body: wheel, on its: rim, mu_s: 0.9}}"
            ),
            String::new(),
            "{travel: {of: wheel, by: 1 m}}",
            "k_bound: {ask: 'the radius of gyration', unit: m}",
            "{{ k }}",
        ),
        "spring" => (
            "",
            "wheel: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: along floor}",
            format!(
                "cord: {{from: {{body: wheel, tied at: centre, leaves: {sense}}}, spring: {{stiffness: 900 N/m, stretch: 0.5 m, attached: rigidly}}}}, rolls: {{body: wheel, on its: rim, mu_s: 0.9}}"
            ),
            String::new(),
            "{travel: {of: wheel, by: 0.3 m}}",
            "friction: {ask: 'the friction', unit: N}",
            "",
        ),
        _ => (
            "",
            "wheel: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: about a fixed axle}",
            format!(
                "cord: {{from: {{body: wheel, wound on: rim, leaves: top {sense}}}, spring: {{stiffness: 900 N/m, stretch: 0.5 m, attached: rigidly}}}}"
            ),
            String::new(),
            "{turn: {of: wheel, by: 40 deg}}",
            "omega: {ask: 'the spin', unit: rad/s}",
            "",
        ),
    };
    let surface = if kind == "axle" { "" } else { "      surfaces: {floor: level}\n" };
    let tie = tie.replace("}, rolls:", "}\n        - rolls:");
    format!(
        "bank: level\ntitle: Level\ninput energy limit: 100\nproblems:\n  p:\n    title: T\n    data:\n      \
         m: {{name: mass, unit: kg, draw: 20 to 40 step 1}}\n      R: {{name: radius, unit: mm, draw: 300 to 400 step 10}}\n{data}    \
         scene:\n{surface}      bodies:\n        {body}\n      ties:\n        - {tie}\n{couple}      start: at rest\n      end: {end}\n    \
         regimes: [{regime}]\n    questions:\n      direction: {{ask: 'which way'}}\n      {ask}\n    \
         statement: '{{{{ m }}}}{{{{ R }}}}{used}{{{{ g }}}}'\n"
    )
}

/// On a level it is forward or back: in the regime, the answer, sheet, figure and solution, in both languages. The words of slopes
/// are read as before, and draw the same.
#[test]
fn on_a_level_slips_and_springs_go_forward_or_back() {
    let room = Room::new();
    for (kind, sense, word, old, answer) in [
        ("slip", "forward", "slips_forward", "slips_up", "forward"),
        ("slip", "back", "slips_back", "slips_down", "back"),
        ("spring", "forward", "forward ok", "up ok", "forward"),
        ("spring", "back", "back ok", "down ok", "back"),
        ("pull", "forward", "moves_forward", "moves_forward", "forward"),
        ("axle", "forward", "forward ok", "up ok", "forward"),
        ("axle", "back", "back ok", "down ok", "back"),
    ] {
        let mut sheets = Vec::new();
        for (regime, name) in [(word, "new"), (old, "old")] {
            let bank = level(kind, sense, regime);
            fs::write(room.path("bank.yaml"), &bank).unwrap();
            let path = room.path("bank.yaml");
            let solved = room.run(&["solve", &path, "p", "--seed", "3"]);
            assert_eq!(solved.exit, Exit::Fine, "{kind} {regime}: {}{}", solved.out, solved.err);
            assert!(solved.out.contains(&format!("\nregime: {word} (it ")), "{}", solved.out);
            assert!(
                solved.out.lines().any(|l| l.trim() == format!("direction{answer:>20}")
                    || (l.contains("  direction") && l.trim_end().ends_with(answer))),
                "{}",
                solved.out
            );
            for language in Words::languages() {
                let set = format!("{kind}-{sense}-{name}-{language}");
                let made = room.run(&[
                    "generate",
                    &path,
                    "--roster",
                    &room.path("roster.csv"),
                    "--seed",
                    "5",
                    "--out",
                    &room.path(&set),
                    "--language",
                    language,
                ]);
                assert_eq!(made.exit, Exit::Fine, "{}", made.err);
                let sheet = room.read(&format!("{set}/students/1/sheet.md"));
                sheets.push((language, sheet.clone()));
                if name == "old" {
                    continue;
                }
                let out = format!("{set}-solved");
                let ran = room.run(&["solutions", &room.path(&set), "--out", &room.path(&out)]);
                assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
                let solution = room.read(&format!("{out}/1/solution.md"));
                for text in [&sheet, &solution] {
                    let lower = text.to_lowercase();
                    let tokens: Vec<&str> = lower.split(|c: char| !c.is_alphabetic()).collect();
                    for slope in [
                        "up",
                        "down",
                        "upward",
                        "downward",
                        "incline",
                        "aufwärts",
                        "abwärts",
                        "hangaufwärts",
                        "hangabwärts",
                        "ebene",
                        "hinauf",
                        "hinab",
                    ] {
                        assert!(!tokens.contains(&slope), "{kind} {language} says {slope}: {text}");
                    }
                }
                let said = Words::of(language).unwrap();
                assert!(
                    solution.contains(&format!("`{}`", said.get(&format!("sheet.{answer}")))),
                    "{solution}"
                );
            }
        }
        let half = sheets.len() / 2;
        assert_eq!(sheets[..half], sheets[half..], "{kind}: the old word draws the same");
    }
}

/// Each word and each synonym is read in a bank; a motion's synonyms are words of others, which it is not taken for elsewhere.
#[test]
fn every_regime_word_is_read_and_the_message_lists_all() {
    for motion in Motion::ALL {
        for word in std::iter::once(motion.word()).chain(motion.synonyms().iter().copied()) {
            let bank = ROLLS.replace("[moves_down]", &format!("[{word}]"));
            assert!(load::scenes_only(&bank, "bank.yaml").is_ok(), "{word}");
            assert!(motion.is_called(word));
        }
        for other in Motion::ALL.iter().filter(|o| *o != motion) {
            assert_eq!(motion.is_called(other.word()), motion.synonyms().contains(&other.word()));
        }
    }
    let faults = load::scenes_only(&ROLLS.replace("[moves_down]", "[glides]"), "bank.yaml").unwrap_err();
    let told = faults.iter().map(ToString::to_string).collect::<String>();
    for motion in Motion::ALL {
        assert!(told.contains(motion.word()), "{told}");
    }
}

/// A regime that is the declared one with a check that fails is told as that; and at an end that is the turning point the words
/// `... turning_point` are right.
///
/// The earlier tests looked at failing checks only together with another regime, and at turning points only by the word `... ok`.
#[test]
fn a_declared_regime_is_not_called_another() {
    let room = Room::new();
    let (data, questions) = (
        "    data:\n      m: {name: mass, unit: kg, draw: 2 to 9 step 0.5}\n",
        "    statement: 'S {{ m }} {{ g }}'\n",
    );
    let bank = |scene: &str, rest: &str| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n{data}    scene:\n{scene}{rest}{questions}"
        )
    };
    // Of two blocks that slide down, tied together, the upper one holds back only if it rubs more.
    let blocks = "      surfaces: {slope: {slope: 30 deg}}
      bodies: {A: {mass: m, moves: along slope, positive: down}, B: {mass: 3 kg, moves: along slope, positive: down}}
      ties:
        - slides: {body: A, mu_k: 0.2}
        - slides: {body: B, mu_k: 0.1}
        - cord: {name: c, from: {body: B, tied at: centre, leaves: forward}, to: {body: A, tied at: centre, leaves: back}}
      start: at rest
      end: {travel: {of: A, by: 1 m}}\n";
    let asks = "    regimes: [moves_down]\n    questions: {kinetic_energy: {ask: how much, unit: J}}\n";
    fs::write(room.path("two.yaml"), bank(blocks, asks)).unwrap();
    let Ran { out, err, .. } = room.run(&["solve", &room.path("two.yaml"), "p", "--set", "m=2kg"]);
    assert!(
        out.contains("This is what the problem declares (moves_down), but taut fails; the numbers"),
        "{out}{err}"
    );
    assert!(!out.contains("This is not"), "{out}");

    let spring = "      surfaces: {floor: level}
      bodies: {disc: {mass: m, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: along floor}}
      ties:
        - rolls: {body: disc, on its: rim, mu_s: 0.6}
        - cord: {name: c, from: {body: disc, tied at: centre, leaves: forward}, spring: {stiffness: 30 N/m, stretch: 0.1 m, attached: rigidly}}
      start: at rest
      end: {turning point: disc}\n";
    let rod = "      bodies: {rod: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from hanging}}
      start: {rod: {angle: 20 deg, spin: 1 rad/s}}
      end: {turning point: rod}\n";
    for (scene, words, fits) in [
        (spring, "forward turning_point", true),
        (spring, "forward ok", true),
        (spring, "up turning_point", true),
        (spring, "back turning_point", false),
        (spring, "forward unreachable", false),
        (rod, "swings turning_point", true),
        (rod, "swings ok", true),
        (rod, "swings unreachable", false),
        // Short of the turning point the asked place is not that.
        (
            &spring.replace("{turning point: disc}", "{travel: {of: disc, by: 0.05 m}}"),
            "forward turning_point",
            false,
        ),
    ] {
        let rest = format!("    regimes: [{words}]\n    questions: {{t: {{ask: how long, unit: s}}}}\n");
        let bank = load::scenes_only(&bank(scene, &rest), "bank.yaml").unwrap_or_else(|f| panic!("{f:?}"));
        let drawn = Maker::new(&bank.problems[0], 1, "b").variant("s");
        assert_eq!(drawn.is_ok(), fits, "{words}: {drawn:?}");
    }
}

#[test]
fn what_nothing_reads_and_what_tells_nothing_is_said() {
    let room = Room::new();
    fs::create_dir(room.0.path().join("mine")).unwrap();
    fs::write(room.path("mine/reprot.html"), "<p>{{ nothing }}</p>").unwrap();
    let ran = room.run(&["lint", "wheels-on-inclines", "--templates", &room.path("mine")]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(
        ran.err.contains("no page is made from a file of this name\n    hint: did you mean report.html?"),
        "{}",
        ran.err
    );
    let ran = room.run(&["lint", "wheels-on-inclines", "--seeds", "0"]);
    assert_eq!(ran.exit, Exit::Faulty);
    assert!(ran.err.contains("0 draws tell nothing"), "{}", ran.err);
}

/// A bar was drawn by several threads while one of them held standard error: the program stood still on a terminal, where alone
/// there are bars, and no test ran on one.
#[test]
#[cfg(target_os = "linux")]
fn bars_on_a_terminal_do_not_stop_the_program() {
    let room = Room::new();
    let program = assert_cmd::cargo::cargo_bin("slipstick").display().to_string();
    let lint = format!("{program} lint wheels-on-inclines --seeds 20");
    let Ok(mut child) = Command::new("script")
        .args(["-q", "-e", "-c", &lint, "/dev/null"])
        .current_dir(room.0.path())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
    else {
        return println!("there is no `script` here, so no terminal");
    };
    for _ in 0..600 {
        if let Some(status) = child.try_wait().unwrap() {
            return assert!(status.success(), "{status}");
        }
        sleep(Duration::from_millis(100));
    }
    child.kill().unwrap();
    panic!("it has not ended after a minute");
}

/// A scene with constants, as a bank.
fn constant(data: &str, scene: &str, question: &str) -> String {
    let lines: String = scene.lines().map(|line| format!("      {line}\n")).collect();
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{x: {{name: x, unit: {data}}}}}\n    scene:\n{lines}    \
         questions: {{q: {question}}}\n    statement: '{{{{ x }}}} {{{{ g }}}}'\n"
    )
}

/// Draws that are no motion at all were dealt: no test had a body larger than its bowl, a slope on which nothing stays, or an end
/// where the motion starts.
#[test]
fn what_cannot_be_is_refused_by_name() {
    let room = Room::new();
    let says = |bank: &str| {
        fs::write(room.path("bank.yaml"), bank).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_ne!(ran.exit, Exit::Fine, "{}", ran.out);
        let lint = room.lint(bank);
        assert!(lint.contains("they break the rules; refused by"), "{lint}");
        ran.out + &ran.err + &lint
    };
    let bowl = |shape: &str, radius: &str| {
        let scene = format!(
            "bodies: {{c: {{mass: 2 kg, shape: {{{shape}: x}}, moves: in the plane, angle: from hanging}}}}\n\
             joints: {{bowl: {{rolls: c, radius: x, inside: 0.5 m}}}}\nstart: {{c: {{angle: 40 deg}}}}\n\
             end: {{angle: {{of: c, reaches: 0 deg}}}}"
        );
        constant(&format!("m, draw: always {radius}"), &scene, "{quantity: omega, ask: it, unit: rad/s}")
    };
    for (shape, radius) in [("cylinder", "0.5"), ("disc", "0.6"), ("sphere", "2")] {
        let told = says(&bowl(shape, radius));
        let text = format!("x = {radius}: must be below the constant 0.5, for the body moves inside it");
        assert_eq!(told.matches(&text).count(), 2, "{told}");
    }
    let all_around =
        "x = 0.5: must not be the constant 0.5: the body would touch all around and could not roll or slide";
    assert_eq!(says(&bowl("hoop", "0.5")).matches(all_around).count(), 2);
    fs::write(room.path("bank.yaml"), bowl("hoop", "2")).unwrap();
    let peg = room.run(&["solve", &room.path("bank.yaml"), "p"]);
    assert_eq!(peg.exit, Exit::Fine, "{}{}", peg.out, peg.err);

    let slope = |end: &str, mu: &str| {
        let scene = format!(
            "surfaces: {{s: {{slope: 25 deg}}}}\nbodies: {{b: {{mass: 8 kg, moves: along s}}}}\n\
             ties: [slides: {{body: b, mu_s: {mu}, mu_k: 0.4}}]\nstart: {{b: {{speed: x}}}}\nend: {end}"
        );
        constant("m/s, draw: always 2", &scene, "{quantity: a, ask: it, unit: m/s^2}")
    };
    let told = says(&slope("{stops slipping: b}", "0.4"));
    let text = "FAILS  no_slip: static friction cannot hold the body b where its slip ends, and it slips on: that needs 33.167 N, mu_s N = 28.451 N";
    assert!(told.contains(text) && told.contains("regime: slips_through"), "{told}");
    assert!(told.contains("          1  no_slip: margin -14.22 % (`margins`: 5 %)"), "{told}");
    for fine in [slope("{stops slipping: b}", "0.6"), slope("{turning point: b}", "0.4")] {
        fs::write(room.path("bank.yaml"), fine).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_eq!(ran.exit, Exit::Fine, "{}{}", ran.out, ran.err);
    }

    let starts =
        "the end lies where the motion starts, and it leaves there; write an end that comes after the start";
    for end in ["travel: {of: b, by: 0 m}", "time: {of: b, is: 0 s}", "speed: {of: b, reaches: 2 m/s}"] {
        let told = says(&slope(&format!("{{{end}}}"), "0.4"));
        assert!(
            told.contains(starts) && told.contains("  1  reaches: margin -100 % (`margins`: 5 %)"),
            "{told}"
        );
    }
    let bar = constant(
        "m, draw: always 1",
        "bodies: {bar: {mass: 2 kg, shape: {rod: x}, moves: in the plane, angle: from right}}\njoints: {A: {pins: bar.A}}\n\
         start: {bar: {angle: 0 deg}}\nend: {angle: {of: bar, reaches: 0 deg}}",
        "{quantity: alpha, ask: it, unit: rad/s^2}",
    );
    assert!(says(&bar).contains(starts));
    let beyond = says(&bar.replace("reaches: 0 deg", "reaches: 360 deg"));
    let text =
        "the end is not reached: it lies 360.00 degrees from the start, and the motion goes the other way";
    assert!(beyond.contains(text), "{beyond}");
    // Of draws that may end where they start, others are drawn.
    let drawn = slope("{travel: {of: b, by: d}}", "0.4")
        .replace("data: {x:", "data: {d: {name: way, unit: m, draw: 0 to 0.1 step 0.05}, x:");
    let bank = load::scenes_only(&drawn, "bank.yaml").unwrap();
    let maker = Maker::new(&bank.problems[0], 1, "x");
    let dealt = (0..20).map(|student| maker.variant(&student.to_string()).unwrap());
    assert!(dealt.into_iter().all(|variant| variant.data.iter().all(|x| *x > 0.0)));
}

/// One fault after the other was told of constants, where all of them are known.
#[test]
fn constants_tell_every_rule_that_they_break() {
    let room = Room::new();
    let nearly = ROLLS
        .replace("2 to 9 step 0.5", "always 3")
        .replace("150 to 400 step 10", "always 200")
        .replace("8 to 30 step 1", "always 15")
        .replace("1.0 to 4.0 step 0.1", "always 2.0")
        .replace("'one of 0.4, 0.5'", "always 0.09")
        .replace("    regimes: [moves_down]", "    bounds: {v: {max: 1 m/s}}\n    regimes: [moves_up]");
    let told = room.lint(&nearly);
    for rule in [
        "no_slip: margin",
        "regime: 1 of 1 move down (`regimes`: moves_up)",
        "bound v: 2.602 m/s (wanted: at most 1 m/s)",
    ] {
        assert!(told.contains(&format!("          1  {rule}")), "{rule}: {told}");
    }
}

/// A range of which a part does not reach the end was told to have two values that fit.
#[test]
fn what_is_found_in_a_part_of_its_range_is_told_so() {
    let room = Room::new();
    let spring = constant(
        "m/s, draw: always 1.1, measured: v}, k: {name: k, unit: N/m, unknown: 1 to 200 step 0.1",
        "surfaces: {incline: {slope: 20 deg}}\nbodies: {wheel: {mass: 12 kg, shape: {disc: 0.2 m}, moves: along incline, positive: down}}\n\
         ties:\n  - rolls: {body: wheel, on its: rim, mu_s: 0.5}\n  - cord: {from: {body: wheel, tied at: centre, leaves: up}, spring: {stiffness: k, stretch: 0 m, attached: rigidly}}\n\
         start: at rest\nend: {travel: {of: wheel, by: 0.8 m}}",
        "{value: k, ask: the stiffness, unit: N/m}",
    );
    let told = room.lint(&spring);
    let text = "in a part of the range of `k` there is no `x` to measure: with 112.94 N/m, say, the motion does not get there; narrow \
                `unknown:` to the values with which it does";
    assert!(told.contains(text) && !told.contains("hint:"), "{told}");
}

/// An equilibrium is enclosed like any other place, so that a period about it can be measured: a hanging rod with a torsion spring,
/// `k = 4 pi^2 I / T^2 - m g L / 2`.
#[test]
fn a_period_about_an_equilibrium_can_be_measured() {
    let room = Room::new();
    let rod = constant(
        "s, draw: always 1, measured: period_small}, k: {name: k, unit: N*m/rad, unknown: 1 to 60 step 1",
        "bodies: {rod: {mass: 3 kg, shape: {rod: 0.8 m}, moves: in the plane, angle: from hanging}}\njoints: {O: {pins: rod.A}}\n\
         forces: [torsion: {on: rod.A, stiffness: k, relaxed at: 0 deg}]\nstart: {rod: {angle: 5 deg}}\nend: equilibrium",
        "{value: k, ask: the stiffness, unit: N*m/rad}",
    );
    fs::write(room.path("bank.yaml"), rod).unwrap();
    let ran = room.run(&["solve", &room.path("bank.yaml"), "p", "--json"]);
    assert_eq!(ran.exit, Exit::Fine, "{}", ran.err);
    let told: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let k = told["questions"]["q"]["value"].as_f64().unwrap();
    let pi = std::f64::consts::PI;
    assert!((k / (4.0 * pi * pi * 0.64 - 1.2 * 9.81) - 1.0).abs() < 1e-14, "{k}");
    assert!(told["quantities"]["phi"]["bound"].as_f64().unwrap() < 1e-13, "{}", ran.out);
}

/// A load that hangs in a truck swings back while the truck gains speed; along a wall it does not.
#[test]
fn what_hangs_in_a_truck_is_given_no_acceleration_by_nothing() {
    let room = Room::new();
    let truck = |surfaces: &str, moves: &str| {
        constant(
            "m, draw: always 1",
            &format!(
                "{surfaces}bodies:\n  drum: {{mass: 4 kg, shape: {{disc: 0.2 m}}, moves: about a fixed axle}}\n  load: {{mass: 2 kg, moves: {moves}, positive: down}}\n\
                 carried: {{along: horizontal, acceleration: -3 m/s^2}}\n\
                 ties: [cord: {{from: {{body: load, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: back down}}}}]\n\
                 start: at rest\nend: {{travel: {{of: load, by: x}}}}"
            ),
            "{quantity: load.a, ask: the acceleration, unit: m/s^2}",
        )
    };
    let solved = |text: &str| {
        fs::write(room.path("bank.yaml"), text).unwrap();
        room.run(&["solve", &room.path("bank.yaml"), "p"])
    };
    let hangs = solved(&truck("", "vertically"));
    assert_eq!(hangs.exit, Exit::Faulty, "{}", hangs.out);
    assert!(
        hangs.err.contains("`load` moves vertically, and nothing gives it an acceleration sideways"),
        "{}",
        hangs.err
    );
    let guided = solved(&truck("surfaces: {wall: {slope: 90 deg}}\n", "along wall"));
    assert_eq!(guided.exit, Exit::Fine, "{}", guided.err);
    assert!(guided.out.contains("4.90500000000"), "{}", guided.out);
}

/// The greatest acceleration of a truck on which a crate does not tip, `A = g b / (2 h)`: the force on the front edge is measured to be 0,
/// and rounding does not decide whether that presses.
#[test]
fn a_force_may_be_measured_to_be_nothing() {
    let room = Room::new();
    let crate_on = |mass: &str| {
        constant(
            "N, draw: always 0, measured: F.normal}, A: {name: A, unit: m/s^2, unknown: 1 to 9 step 0.1",
            &format!(
                "bodies: {{crate: {{mass: {mass} kg, moment of inertia: 5 kg*m^2, moves: in the plane, angle: from up counter-clockwise, mass centre: 1 m, placed: [0 m, 0 m], points: {{F: [0 m, -0.3 m], R: [0 m, 0.3 m]}}}}}}\n\
                 carried: {{along: horizontal, acceleration: A}}\n\
                 joints:\n  F: {{guides: crate.F, along: horizontal, pushes: up}}\n  R: {{pins: crate.R, at: [-0.3 m, 0 m]}}\n\
                 start: {{crate: {{angle: 0 deg}}}}\nend: at once"
            ),
            "{value: A, ask: the acceleration, unit: m/s^2}",
        )
    };
    for mass in ["40", "37", "23.4", "61.3"] {
        fs::write(room.path("bank.yaml"), crate_on(mass)).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_eq!(ran.exit, Exit::Fine, "{mass}: {}{}", ran.out, ran.err);
        assert!(ran.out.contains("2.94300000000"), "{}", ran.out);
    }
    // Why no value leads there has nothing to do with the value.
    fs::write(room.path("bank.yaml"), crate_on("40").replace("at: [-0.3 m, 0 m]", "at: [0 m, 0 m]")).unwrap();
    let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
    assert!(ran.err.contains("cannot be met") && !ran.err.contains("in its range"), "{}", ran.err);
    // What is meant to be at its limit has no margin from it.
    fs::write(room.path("bank.yaml"), crate_on("40")).unwrap();
    let ran = room.run(&["lint", &room.path("bank.yaml")]);
    assert_eq!(ran.exit, Exit::Fine, "{}{}", ran.out, ran.err);
    assert!(ran.out.contains("100 %"), "{}", ran.out);
}

/// What an instructor is told of questions the other way round, of units within an expression, and of coefficients.
#[test]
fn what_misled_an_instructor_is_told_plainly() {
    let room = Room::new();
    let rod = "bodies: {rod: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}}\njoints: {O: {pins: rod.A}}\n\
               start: {rod: {angle: 0 deg, spin: w0}}\nend: {angle: {of: rod, reaches: 180 deg}}";
    let spin = |range: &str| {
        let data =
            format!("rad/s, draw: always 0, measured: omega}}, w0: {{name: w, unit: rad/s, unknown: {range}");
        constant(&data, rod, "{value: w0, ask: the spin, unit: rad/s}")
    };
    let told = room.lint(&spin("5 to 12 step 0.1"));
    let text = "no value of `w0` in its range gives the measured `x`; one with which the motion only just gets there";
    assert!(told.contains(text), "{told}");
    let told = room.lint(&spin("5.05 to 12 step 0.1"));
    assert!(told.contains("the step 0.1 does not lead from 5.05 to 12"), "{told}");
    assert_eq!(told.matches("error:").count(), 1, "{told}");
    let block = |mass: &str, tie: &str| {
        let scene = format!(
            "surfaces: {{floor: level}}\nbodies: {{b: {{mass: {mass}, shape: {{disc: 0.2 m}}, radii: {{rim: 0.2 m}}, moves: along floor}}}}\n\
             ties: [{{{tie}}}, {{cord: {{from: {{body: b, tied at: centre, leaves: forward}}, pulled with: 30 N}}}}]\n\
             start: at rest\nend: {{time: {{of: b, is: x}}}}"
        );
        room.lint(&constant("s, draw: always 1", &scene, "{quantity: v, ask: the speed, unit: m/s}"))
    };
    let told = block("3 kg", "touches: {body: b, on its: rim, mu_s: 0.1, mu_k: 0.3}");
    let text = "mu_k, the constant 0.3: must not be above mu_s, the constant 0.1";
    assert!(told.contains(text), "{told}");
    let told = block("5 kg*(x^2/2)", "rolls: {body: b, on its: rim}");
    assert!(told.contains("hint: a number within an expression has no unit"), "{told}");
    let told = room.lint(&constant(
        "deg, draw: always 30",
        "bodies: {rod: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}}\njoints: {O: {pins: rod.A}}\n\
         start: {rod: {angle: 0 deg}}\nend: {angle: {of: rod, reaches: 90 deg - x}}",
        "{value: x, ask: the angle, unit: '1'}",
    ));
    assert!(told.contains("angles count in radians there, as `pi/2 - x`"), "{told}");
    // A particle has no turn that the weld would hold: it is stuck on, and nothing is wrong.
    let stuck = constant(
        "N*s, draw: always 2",
        "bodies: {rod: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane}, bullet: {mass: 1 kg, moves: in the plane}}\n\
         joints: {O: {pins: rod.A}, P: {welds: [rod.B, bullet]}}\n\
         forces: [impulse: {on: rod.B, magnitude: x, direction: right}]\nstart: {rod: {angle: 0 deg}}\nend: at once",
        "{quantity: rod.omega, ask: the angular speed, unit: rad/s}",
    );
    fs::write(room.path("bank.yaml"), stuck).unwrap();
    let ran = room.run(&["lint", &room.path("bank.yaml"), "--seeds", "2"]);
    assert_ne!(ran.exit, Exit::Faulty, "{}", ran.err);
}

/// What was told of these scenes was no help, or was wrong: a drive of 0 times what holds, an angle with the other sign, a constant that
/// is itself, a bracket that is there.
#[test]
fn what_is_told_says_what_to_do() {
    let room = Room::new();
    let says = |bank: &str| {
        fs::write(room.path("bank.yaml"), bank).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_ne!(ran.exit, Exit::Fine, "{}", ran.out);
        ran.out + &ran.err
    };
    let slope =
        "surfaces: {s: {slope: 30 deg}}\nbodies: {a: {mass: 3 kg, moves: along s}}\nstart: {a: {speed: x}}\n";
    let rod = "bodies: {a: {mass: 10 kg, shape: {rod: x}, moves: in the plane, angle: from horizontal}}\n";
    let guides = "joints:\n  floor: {guides: a.A, along: horizontal, pushes: up, mu_k: 0.5}\n  wall: {guides: a.B, along: vertical, pushes: left, mu_k: 0.5}\n";
    let collar = "bodies: {a: {mass: 1 kg, moves: in the plane, placed: [1 m, 0 m]}}\njoints: {rod: {guides: a, along: vertical}}\nstart: at rest\n";
    let cases = [
        (
            format!("{slope}end: {{travel: {{of: a, by: 0.3 m, heading: down}}}}"),
            "moves: the body a does not move as declared: it starts the other way; what comes after a turning point is a motion of its own, `next`",
        ),
        (
            format!("{slope}end: {{travel: {{of: a, by: 0.3 m, heading: down}}}}"),
            "reaches: the end is not reached: 0.30000 m asked, the motion goes the other way",
        ),
        (
            format!("{slope}ties: [slides: {{body: a, mu_s: 0.3, mu_k: 0.4}}]\nend: {{turning point: a}}"),
            "p: mu_k, the constant 0.4: must not be above mu_s, the constant 0.3",
        ),
        (
            format!("{rod}{guides}start: {{a: {{angle: 75 deg}}}}\nend: at once"),
            "moves: the body a does not move as declared: friction holds it at rest",
        ),
        (
            format!(
                "{}joints: {{A: {{pins: a.A}}}}\nstart: {{a: {{angle: 0 deg}}}}\nend: {{angle: {{of: a, reaches: 90 deg}}}}",
                rod.replace("10 kg", "0 kg")
            ),
            "rank 4; what has a mass of 0 needs a body with mass that moves with it",
        ),
        (
            format!("{collar}end: {{descent: {{of: a, by: x}}}}"),
            "`a` moves in the plane: it ends at an angle\n    hint: a body that only slides leads no motion: end at the angle of one that turns (hinge it to a light rod, of `mass: 0 kg`), or let it move `vertically` or `along` a surface",
        ),
        (
            format!(
                "{}end: {{turning point: a}}\nnext: {{end: {{travel: {{of: a, by: 1 m}}}}}}",
                slope.replace("3 kg", "any")
            ),
            "a motion that follows needs a scene that says everything: `any` gives no value\n    hint: write a value or a datum in its place",
        ),
        (
            format!("{slope}end: {{travel: {{of: a, by: 3*(1 m)}}}}"),
            "`3*(1 m)`, character 6: `m` is not expected here\n    hint: factors are joined by `*`, and numbers of an expression have no unit: make a datum of one that has",
        ),
    ];
    for (scene, text) in cases {
        let told = says(&constant(
            if scene.contains("speed: x") { "m/s, draw: always 3" } else { "m, draw: always 3" },
            &scene,
            "{quantity: a.v, ask: it, unit: m/s}",
        ));
        assert!(told.contains(text), "{text}\n{told}");
    }
}

/// A crank, a coupler and a rocker.
const FOUR_BAR: &str = "bodies:
  crank: {mass: 1 kg, shape: {rod: x}, moves: in the plane, angle: from right}
  coupler: {mass: 2.5 kg, shape: {rod: 0.8 m}, moves: in the plane}
  rocker: {mass: 1.5 kg, shape: {rod: 0.5 m}, moves: in the plane}
joints:
  O: {pins: crank.A}
  C: {pins: rocker.A, at: [0.7 m, 0 m]}
  A: {hinges: [crank.B, coupler.A]}
  B: {hinges: [coupler.B, rocker.B]}
start: {crank: {angle: 100 deg}}
end: {angle: {of: crank, reaches: 125 deg}}";

/// A side or a second angle that decides nothing was passed over, and rods too short to meet were called a fault of the solver. All
/// joined scenes of the tests could be put together, and no test told a side of the body that is placed second.
#[test]
fn joined_bodies_that_do_not_fit_are_refused_by_name() {
    let room = Room::new();
    let says = |scene: &str| {
        let bank = constant("m, draw: always 0.3", scene, "{quantity: crank.omega, ask: it, unit: rad/s}");
        fs::write(room.path("bank.yaml"), bank).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_ne!(ran.exit, Exit::Fine, "{}", ran.out);
        ran.out + &ran.err
    };
    let side =
        |body: &str| FOUR_BAR.replace(&format!("{body}: {{mass"), &format!("{body}: {{side: ahead, mass"));
    let short = FOUR_BAR.replace("rod: 0.8 m", "rod: 0.2 m").replace("rod: 0.5 m", "rod: 0.1 m");
    let long = FOUR_BAR.replace("rod: 0.5 m", "rod: 2 m");
    let slider = "bodies:
  crank: {mass: 2 kg, shape: {rod: x}, moves: in the plane, angle: from right}
  rod: {mass: 3 kg, shape: {rod: 0.1 m}, moves: in the plane, side: ahead}
  piston: {mass: 1 kg, moves: in the plane}
joints:
  O: {pins: crank.A}
  A: {hinges: [crank.B, rod.A]}
  B: {hinges: [rod.B, piston]}
  c: {guides: piston, along: horizontal}
start: {crank: {angle: 90 deg}}
end: at once";
    let angle = |to: &str, end: &str| {
        FOUR_BAR
            .replace("start: {", &format!("start: {{{to}, "))
            .replace("{angle: {of: crank, reaches: 125 deg}}", end)
    };
    let too_short = "`rod` cannot be put in place at the start: what holds it is 0.30000 m apart, and it bridges at most 0.10000 m; change the lengths, the angle at the start, or the places of the joints";
    let cases = [
        (
            side("rocker").replace("coupler: {", "coupler: {side: behind, "),
            "`side:` in `rocker` contradicts that in `coupler`: the two are placed together; write it in one of them",
        ),
        (side("crank"), "`side:` in `crank` decides nothing: there is one place for it; take it away"),
        (
            angle("rocker: {angle: 20 deg}", "{angle: {of: crank, reaches: 125 deg}}"),
            "the start contradicts the joints: it gives the angle of `rocker` as 20.000 deg, and they put it at 87.543 deg; leave that angle out (of two places `side:` says which is meant)",
        ),
        (
            angle("rocker: {angle: 20 deg}", "at once"),
            "the start contradicts the joints: it gives the angle of `rocker` as 20.000 deg, and they put it at 87.543 deg; leave that angle out (of two places `side:` says which is meant)",
        ),
        (
            short,
            "`coupler` and `rocker` cannot be put in place at the start: what holds them is 0.80804 m apart, and they bridge at most 0.30000 m; change the lengths, the angle at the start, or the places of the joints",
        ),
        (
            long,
            "`coupler` and `rocker` cannot be put in place at the start: what holds them is 0.80804 m apart, and they bridge at least 1.2000 m; change the lengths, the angle at the start, or the places of the joints",
        ),
        (slider.to_owned(), too_short),
        (slider.replace("at once", "{angle: {of: crank, reaches: 100 deg}}"), too_short),
        (
            FOUR_BAR.replace("rod: 0.8 m}, ", "rod: 0.8 m}, placed: [3 m, 3 m], "),
            "the joint `A` cannot be met at the start: where the other joints and the data put the bodies, it is 4.0780 m off; change the lengths, the angle at the start, `placed:`, or the place of the joint",
        ),
        (
            FOUR_BAR
                .replace("  B: {hinges: [coupler.B, rocker.B]}", "  B: {hinges: [coupler.B, crank.A]}")
                .replace("coupler", "one"),
            "the joints do not place `one` on the way: bodies are placed one after the other, from the one whose angle is told, and one that turns is welded to what has a place, or pinned or hinged to it and besides guided at another point or by a slot of its own, tied by a cord or a light rod, or hinged to a second such body",
        ),
    ];
    let slotted = |start: &str, end: &str| {
        format!(
            "bodies:
  crank: {{mass: 2 kg, shape: {{rod: x}}, moves: in the plane, angle: from right}}
  arm: {{mass: 3 kg, shape: {{rod: 0.9 m}}, moves: in the plane, angle: from right}}
joints:
  O: {{pins: crank.A}}
  C: {{pins: arm.A, at: [0 m, -0.3 m]}}
  slot: {{guides: crank.B, on: arm.A}}
start: {{crank: {{angle: {start} deg}}}}
end: {end}"
        )
    };
    let folds = "the point in the slot of `arm` comes to the pin of `arm` on the way: from there the linkage can go on in two ways, and it is not followed; let the motion end before";
    let hanging = |cart: &str, block: &str| {
        format!(
            "bodies:
  cart: {{mass: 5 kg, moves: in the plane{cart}}}
  block: {{mass: 2 kg, moves: in the plane{block}}}
  crank: {{mass: 1 kg, shape: {{rod: x}}, moves: in the plane, angle: from hanging}}
joints:
  floor: {{guides: cart, along: horizontal, pushes: up}}
  top: {{slides: block, on: cart}}
  h: {{hinges: [crank.A, block]}}
start: {{crank: {{angle: 40 deg}}}}
end: at once"
        )
    };
    let here = ", placed: [0 m, 0 m]";
    let cases = cases.into_iter().chain([
        (
            slotted("270", "at once"),
            "nothing says at the start which way a body at the joint `C` lies: two places that give it its direction are one, such as the point in a slot at the pin of the arm; change the lengths or the angle at the start",
        ),
        (slotted("200", "{angle: {of: crank, reaches: 270 deg}}"), folds),
        (
            hanging("", here),
            "nothing says where `cart` is: no joint puts it beside what has a place; give it `placed: [x, y]`, where its axis begins",
        ),
        (
            hanging(here, ""),
            "nothing says where `crank` is: no joint puts it beside what has a place; give it `placed: [x, y]`, where its axis begins",
        ),
    ]);
    for (scene, text) in cases {
        assert_eq!(says(&scene).trim_end(), format!("error: p: {text}"), "{scene}");
    }
}

/// What these faults are told by named no way out, or one that is none there.
#[test]
fn hints_for_joined_bodies_fit_where_they_are_told() {
    let room = Room::new();
    let says = |data: &str, scene: &str| {
        fs::write(room.path("bank.yaml"), constant(data, scene, "{quantity: a.v, ask: it, unit: m/s}"))
            .unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_ne!(ran.exit, Exit::Fine, "{}", ran.out);
        ran.out + &ran.err
    };
    let rod = "bodies: {a: {mass: 10 kg, shape: {rod: 4 m}, moves: in the plane, angle: from right}}\njoints: {O: {pins: a.A}}\n";
    let push =
        "start: {a: {angle: 0 deg}}\nend: at once\nforces: [force: {on: a.B, direction: up, magnitude: P}]";
    let couple = "start: {a: {angle: 0 deg}}\nend: at once\nforces: [couple: {on: a, moment: P}]";
    let wheel = "bodies: {a: {mass: 10 kg, shape: {disc: x}, moves: in the plane, angle: from right, points: {G: 0 m, P: 0.1 m}}}\n\
                 joints: {f: {rolls: a, radius: x, along: horizontal}}\nstart: {a: {angle: 0 deg}}\nend: at once";
    let gears = "surfaces: {floor: level}\nbodies:\n  a: {mass: 3 kg, shape: {disc: x}, moves: along floor}\n  b: {mass: 3 kg, shape: {disc: x}, moves: about a fixed axle}\n\
                 ties:\n  - rolls: {body: a, on its: rim}\n  - meshes: [a.rim, b.rim]\nstart: at rest\nend: {turn: {of: b, by: 1 rad}}";
    let ladder = "bodies: {a: {mass: 20 kg, shape: {rod: x}, moves: in the plane, angle: from upright clockwise}}\njoints:\n  \
                  floor: {guides: a.A, along: horizontal, pushes: up, mu_k: 0.4}\n  \
                  wall: {guides: a.B, along: vertical, through: [2 m, 0 m], pushes: left}\nstart: {a: {angle: 30 deg}}\nend: at once";
    let length = "m, draw: always 4";
    let cases = [
        (
            length,
            rod.to_owned() + &push.replace('P', "-5 N"),
            "a force is not negative: its direction says whither it acts",
        ),
        (
            length,
            rod.to_owned() + &couple.replace('P', "-5 N*m"),
            "a moment is not negative: `sense: back` turns the other way",
        ),
        (
            "N, draw: always 5",
            rod.to_owned() + &push.replace('P', "-x"),
            "`-x` = -5 with x = 5 N: must not be below 0: its direction says whither it acts",
        ),
        (
            "N*m, draw: always 5",
            rod.to_owned() + &couple.replace('P', "-x"),
            "must not be below 0: `sense: back` turns the other way",
        ),
        (
            length,
            wheel.replace("mass: 10 kg", "mass: 10 kg, mass centre: 0.05 m"),
            "expected a point of `a`, such as `a.G`, found `a`\n    hint: points: a.G, a.P\n",
        ),
        (length, gears.to_owned(), "expected the rim of a wheel about a fixed axle, found `a.rim`\n"),
        (
            length,
            ladder.to_owned(),
            "regime: rest (it stays at rest)\n\
             This is not what the ties say.\n  \
             FAILS  moves: the body a does not move as declared: friction holds it at rest, if it does not tip over; for the forces that hold it write `pins:` in place of the rough guide\n\
             method: closed form (auto): only an instant is asked, nothing has to be integrated\n",
        ),
    ];
    for (data, scene, text) in cases {
        let told = says(data, &scene);
        assert!(told.contains(text), "{text}\n{told}");
    }
    assert!(!says(length, ladder).contains("quantity "));
}

/// Two spools on one link, of which either may slip while the other one rolls: m = 10 kg, k = 0.17 m, hub 0.1 m, M = 10 N m on A. With
/// (k/c)^2 = 2.89 rolling of both asks 62.9 and 37.2 N of the floor, which holds 54.0 and 29.4 N. If A slips, a = 44.1/48.9 = 0.903 m/s^2
/// and B needs 26.1 N; if B slips, a = 90.2/48.9 = 1.844 m/s^2 and A needs 46.7 N. And a disc of 4 kg whose acceleration 10.4 m/s^2 is
/// measured: 31.2 N let it roll so, 37.7 N make it slip so.
#[test]
fn a_draw_in_which_two_things_may_happen_is_refused() {
    let room = Room::new();
    let spools = |mu| {
        format!(
            "bank: b
title: B
problems:
  p:
    title: Two spools
    data: {{mu: {{name: friction of B, unit: \"1\", draw: always {mu}}}}}
    scene:
      surfaces: {{floor: level}}
      bodies:
        A: {{mass: 10 kg, radius of gyration: 0.17 m, radii: {{hub: 0.1 m}}, moves: along floor}}
        B: {{mass: 10 kg, radius of gyration: 0.17 m, radii: {{hub: 0.1 m}}, moves: along floor}}
      ties:
        - touches: {{body: A, on its: hub, mu_s: 0.55, mu_k: 0.45}}
        - touches: {{body: B, on its: hub, mu_s: mu, mu_k: 0.1}}
        - link: {{from: {{body: A, tied at: centre, leaves: back}}, to: {{body: B, tied at: centre, leaves: forward}}}}
      forces: [couple: {{on: A, moment: 10 N*m, sense: forward}}]
      start: at rest
      end: {{time: {{of: A, is: 1 s}}}}
    questions: {{a: {{quantity: A.a, ask: the acceleration, unit: m/s^2}}}}
    statement: Spools, {{{{ mu }}}}.
"
        )
    };
    let pull = "bank: b
title: B
problems:
  p:
    title: Which pull
    data:
      a1: {name: measured acceleration, unit: m/s^2, draw: always 10.4, measured: a}
      P: {name: pull, unit: N, unknown: 20 to 60 step 1}
    scene:
      surfaces: {floor: level}
      bodies: {w: {mass: 4 kg, shape: {disc: 0.2 m}, moves: along floor}}
      ties:
        - touches: {body: w, on its: rim, mu_s: 0.3, mu_k: 0.1}
        - cord: {from: {body: w, wound on: rim, leaves: top forward}, pulled with: P}
      start: at rest
      end: {travel: {of: w, by: 1 m}}
    REGIMES
    questions: {pull: {value: P, unit: N, ask: the pull}}
    statement: A disc, {{ a1 }}.
";
    let either = "with these data other contacts may roll or slip as well";
    // That only rolling is declared tells a student nothing.
    let rolls = pull.replace("REGIMES", "regimes: [moves_forward]");
    for bank in [spools("0.3"), pull.replace("    REGIMES\n", ""), rolls] {
        let told = room.lint(&bank);
        assert!(told.contains(either), "{told}");
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert!(ran.err.contains(either), "{}{}", ran.out, ran.err);
    }
    // With 0.2 the hub of B cannot be held while A slips.
    fs::write(room.path("bank.yaml"), spools("0.2")).unwrap();
    let ran = room.run(&["lint", &room.path("bank.yaml"), "--seeds", "2"]);
    assert_eq!(ran.exit, Exit::Fine, "{}{}", ran.out, ran.err);
}

/// These were told reasons that were not there: an angle that is missing and stands there, a place that is given and asked for, friction
/// that holds what nothing drives, an end that lies behind.
#[test]
fn a_refusal_tells_the_reason_that_is_there() {
    let room = Room::new();
    let says = |scene: &str, asked: &str| {
        let bank = constant("m, draw: always 0.5", &scene.replace("; ", "\n"), asked);
        fs::write(room.path("bank.yaml"), bank).unwrap();
        let ran = room.run(&["solve", &room.path("bank.yaml"), "p"]);
        assert_ne!(ran.exit, Exit::Fine, "{}", ran.out);
        let told = (ran.out + &ran.err).replace(&room.path("bank.yaml"), "bank.yaml");
        let fails =
            |line: &&str| ["error:", "hint:", "FAILS"].iter().any(|s| line.trim_start().starts_with(s));
        told.lines().filter(fails).map(|line| line.trim_start().to_owned() + "\n").collect::<String>()
    };
    let kinetic = "{quantity: kinetic_energy, ask: it, unit: J}";
    let value = "{value: 2*x, ask: it, unit: m}";
    let wheel = "bodies: {X: {mass: 7 kg, shape: {disc: x}, moves: in the plane}}; joints: {floor: {slides: X, radius: x, along: horizontal, mu_k: 0.2}, ";
    let cases = [
        (
            "bodies: {bob: {mass: 2 kg, moves: in the plane, angle: from vertical, mass centre: x, points: {O: 0 m, B: x}}}; joints: {O: {pins: bob.O}}; start: {bob: {angle: 5 deg}}; end: at once".to_owned(),
            kinetic,
            "error: bank.yaml:10:14: problems.p.scene.start: `bob` has an angle, and a mass alone: it only slides, and does not turn\n\
             hint: give it a `shape:`, or a `moment of inertia:`, which is 0 kg*m^2 of a small body on a light rod",
        ),
        (
            "bodies: {log: {mass: 1 kg, shape: {cylinder: x}, moves: in the plane, angle: from right, points: {A: 0 m, B: x}}, board: {mass: 3 kg, shape: {rod: 2 m}, moves: in the plane, points: {A: 0 m, M: midway, B: its end}, placed: [-1 m, x]}}; joints: {O: {pins: log.A}, O2: {pins: log.B}, contact: {rolls: log.A, radius: x, on: board.M}}; start: {board: {angle: 5 deg}}; end: equilibrium".to_owned(),
            value,
            "error: p: `board` has its place at the start alone: no joint takes it along from there; pin or hinge a point of it, or let it roll, touch or slide on what has a place (a straight body that rolls on a cylinder is not solved)",
        ),
        (
            "bodies: {left: {mass: 2 kg, shape: {disc: x}, moves: in the plane, angle: from right, points: {C: 0 m, A: x}, placed: [0 m, x]}, right: {mass: 2 kg, shape: {disc: x}, moves: in the plane, points: {C: 0 m, B: x}, placed: [2 m, x]}, rod: {mass: 1 kg, shape: {rod: 2 m}, moves: in the plane}}; joints: {f1: {rolls: left.C, radius: x, along: horizontal}, f2: {rolls: right.C, radius: x, along: horizontal}, A: {hinges: [left.A, rod.A]}, B: {hinges: [right.B, rod.B]}}; start: {left: {angle: 80 deg}}; end: {angle: {of: left, reaches: -90 deg}}".to_owned(),
            kinetic,
            "error: p: the joints do not place `left` on the way: two wheels that roll, joined by a rod, are not followed, for where the second one is follows from no body before it",
        ),
        (
            "bodies: {sun: {mass: 1 kg, shape: {disc: x}, moves: in the plane}, arm: {mass: 1 kg, shape: {rod: 0.8 m}, moves: in the plane, angle: from right}, planet: {mass: 1 kg, shape: {disc: 0.3 m}, moves: in the plane}}; joints: {O: {pins: sun}, Q: {pins: arm.A}, A: {hinges: [arm.B, planet]}, mesh: {meshes: planet, radius: 0.3 m, on: sun}}; start: {arm: {angle: 0 deg}}; end: at once".to_owned(),
            kinetic,
            "error: bank.yaml:9:122: problems.p.scene.joints.mesh.on: `on:` alone means a straight line that this body carries along its axis, and it is round\n\
             hint: tell the line by `along: 0 deg`; wheels about fixed axles turn one another by `meshes` or `belt`, two that both turn while an arm carries one of them are not solved",
        ),
        (
            "bodies: {rod: {mass: 1 kg, shape: {rod: 2 m}, moves: in the plane, angle: from right}, bead: {mass: 1 kg, moves: in the plane, placed: [x, 0 m]}}; joints: {O: {pins: rod.A}, slot: {guides: bead, on: rod.A}}; start: {rod: {angle: 0 deg}}; end: {position: {of: bead, at: 1 m}}".to_owned(),
            kinetic,
            "error: bank.yaml:11:12: problems.p.scene.end: the motion is followed by the angle of `rod`, not by that of `bead`\n\
             hint: end it at `of: rod`\n\
             error: bank.yaml:11:13: problems.p.scene.end.position: `bead` moves in the plane: it ends at an angle\n\
             hint: a body that only slides leads no motion: end at the angle of one that turns (hinge it to a light rod, of `mass: 0 kg`), or let it move `vertically` or `along` a surface",
        ),
        (
            format!("{wheel}link: {{links: X, to: [-1 m, x]}}}}; start: {{X: {{angle: 30 deg}}}}; end: {{leaves: floor}}"),
            value,
            "FAILS  moves: the body X does not move as declared: nothing sets it in motion that friction does not hold",
        ),
        (
            format!("{wheel}link: {{ties: X, to: [0 m, x]}}}}; start: {{X: {{spin: 0 rad/s}}}}; end: at once"),
            value,
            "error: p: a_x has no value: a cord or a light rod has no length where it is asked, and so no direction; change its places. No key is published.",
        ),
        (
            format!("{wheel}wall: {{slides: X, radius: x, along: -90 deg, mu_k: 0.2}}}}; start: {{X: {{spin: -30 rad/s}}}}; end: {{turning point: X}}"),
            "{quantity: t, ask: it, unit: s}",
            "FAILS  pressed: the body X is not pressed on `wall`: 0 N, required more than 0 N\n\
             FAILS  reaches: the end is not reached: a contact that only pushes is not pressed from the start on",
        ),
        (
            "bodies: {drum: {mass: 10 kg, shape: {disc: x}, moves: in the plane}, lever: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane, points: {A: 0 m, C: 0.4 m, B: 1 m}}}; joints: {axle: {pins: drum}, pivot: {pins: lever.A, at: [-0.4 m, x]}, shoe: {slides: lever.C, outside: x, on: drum, mu_k: 0}}; start: {drum: {spin: 20 rad/s}}; end: {turning point: drum}".to_owned(),
            "{quantity: drum.phi, ask: it, unit: rad}",
            "error: p: nothing slows what turns here: every coefficient of friction is 0, and it never comes to rest. No answer is given.",
        ),
        (
            "surfaces: {hill: {slope: 45 deg}}; bodies: {ball: {mass: 2 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along hill, positive: down}}; ties: [rolls: {body: ball, on its: rim}]; start: at rest; end: {descent: {of: ball, by: x}}; next: {surfaces: {hill: {slope: -atan(x/x)}}, ties: [], end: {turning point: ball}}".to_owned(),
            "{value: abs(next.rise), ask: it, unit: m}",
            "error: p: in the motion that follows `-atan(x/x)` = -45 with x = 0.5 m: a slope is from 0 to 90 degrees; its line rises in the sense in which that of the motion before it does, so that no valley is written (places, angles and times count from the start of the whole)",
        ),
        (
            "surfaces: {floor: level}; bodies: {spool: {mass: 2 kg, radius of gyration: 0.3 m, radii: {rim: x, hub: 0.2 m}, moves: along floor}}; ties: [rolls: {body: spool, on its: rim}, cord: {from: {body: spool, wound on: hub, leaves: bottom forward, at an angle: 20 deg}, pulled with: 5 N}]; start: at rest; end: {travel: {of: spool, by: 1 m}}".to_owned(),
            "{quantity: cord_travel, ask: it, unit: m}",
            "error: bank.yaml:13:31: problems.p.questions.q.quantity: `cord_travel` does not exist in this scene\n\
             hint: `cord_travel` is: distance that the pulled end of the cord moves; it is told of a cord that is pulled along the line of its body, not at an angle to it",
        ),
    ];
    for (scene, asked, text) in cases {
        let told = says(&scene, asked);
        assert_eq!(told.trim_end(), text, "{scene}");
    }
}

/// A sphere that is set down on a belt: where its slip ends friction changes, and its direction counts on the belt.
#[test]
fn a_sheet_says_which_side_of_an_instant_and_what_a_direction_counts_from() {
    let room = Room::new();
    let scene = "surfaces: {belt: level}
carried: {along: belt, speed: x}
bodies: {sphere: {mass: 3 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along belt}}
ties: [slips: {body: sphere, on its: rim, mu_s: 0.3, mu_k: 0.25}]
start: {sphere: {speed: 0 m/s, spin: 0 rad/s}}
end: {stops slipping: sphere}";
    for (asked, told) in [
        (
            "{quantity: friction, ask: f, unit: N}",
            "signed (positive: forward) or with `forward` / `back`, just before the end",
        ),
        ("{quantity: direction, ask: d}", "`forward` or `back`, at the end, relative to the moving support"),
    ] {
        let sheet = room.sheet(&constant("m/s, draw: always 4", scene, asked));
        assert!(sheet.contains(told), "{told}: {sheet}");
    }
}

/// Where a sign counts a sheet says so: of a formula with a signed quantity in it, of work and power; and that whole turns count where more
/// than one may be made. A root, a square and what is made of magnitudes has no sign to tell.
#[test]
fn a_sheet_says_where_a_sign_and_whole_turns_count() {
    let room = Room::new();
    let disc = |end: &str| {
        format!(
            "bodies: {{disc: {{mass: 3 kg, shape: {{disc: x}}, moves: in the plane, angle: from right}}}}\njoints: {{O: {{pins: disc.A}}}}\n\
             forces: [couple: {{on: disc, moment: 2 N*m}}]\nstart: {{disc: {{angle: 0 deg}}}}\nend: {end}"
        )
    };
    let time = disc("{time: {of: disc, is: 3 s}}");
    let at_once = disc("at once");
    for (scene, asked, told) in [
        (&at_once, "{value: disc.alpha*x, ask: a, unit: m/s^2}", "in\u{a0}m/s², signed\n"),
        (&at_once, "{value: disc.alpha^2, ask: a, unit: rad^2/s^4}", "in\u{a0}rad²/s^4\n"),
        (&time, "{value: disc.omega*x, ask: v, unit: m/s}", "in\u{a0}m/s\n"),
        (
            &time,
            "{quantity: disc.power_couple, ask: P, unit: W}",
            "positive if it adds energy to the bodies\n",
        ),
        (
            &time,
            "{quantity: disc.angle, ask: phi, unit: rad}",
            "counted counter-clockwise from the right, whole turns included\n",
        ),
    ] {
        let sheet = room.sheet(&constant("m, draw: always 0.5", scene, asked));
        assert!(sheet.contains(told), "{told}: {sheet}");
    }
}
