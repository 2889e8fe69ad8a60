//! Marks by the settings of a course: follow-through, credit for known wrong methods, attempts, lateness, corrections, totals;
//! through the command line, on a real bank.
#![expect(clippy::unwrap_used, reason = "a test that cannot set itself up fails")]
use slipstick::cli;
use slipstick::cli::tell::Exit;
use slipstick::cli::tell::Io;
use slipstick::problem::make::Maker;
use slipstick::problem::make_key;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
mod support;

fn run(args: &[&str]) -> (Exit, String, String) {
    let (mut out, mut err, mut input) = (Vec::new(), Vec::new(), &b""[..]);
    let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
    let exit = cli::run(
        words,
        &mut Io { input: &mut input, out: &mut out, err: &mut err, watched: false, typed: false },
    );
    (exit, String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

/// A set of two students and two problems: 1 pulled-rolling, 2 pulled-slipping.
struct Class {
    room: TempDir,
    /// Key by student, number of the problem and part: value in the asked unit, and the unit.
    key: BTreeMap<(String, String, String), (f64, String)>,
    /// Data by student and symbol, of problem 1.
    data: BTreeMap<(String, String), f64>,
}

fn rows(text: &str) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    reader
        .records()
        .map(|r| head.iter().cloned().zip(r.unwrap().iter().map(str::to_owned)).collect())
        .collect()
}

impl Class {
    fn new() -> Self {
        let room = tempfile::tempdir().unwrap();
        let at = |name: &str| room.path().join(name).display().to_string();
        fs::write(at("roster.csv"), "student,name\nann,Ann\nbob,Bob\n").unwrap();
        let args = ["--seed", "11", "--problems", "pulled-rolling,pulled-slipping"];
        let (roster, out) = (at("roster.csv"), at("set"));
        let mut all = vec!["generate", "wheels-on-inclines", "--roster", &roster, "--out", &out];
        all.extend(args);
        assert_eq!(run(&all).0, Exit::Fine);
        let key = rows(&fs::read_to_string(at("set/key.csv")).unwrap())
            .into_iter()
            .filter_map(|r| {
                let value: f64 = r["value"].parse().ok()?;
                let key = (r["student"].clone(), r["problem"].clone(), r["part"].clone());
                Some((key, (value, r["unit"].clone())))
            })
            .collect();
        let bank = &support::banks().into_iter().find(|b| b.id == "wheels-on-inclines").unwrap();
        let problem = bank.problems.iter().find(|p| p.id == "pulled-rolling").unwrap();
        let mut data = BTreeMap::new();
        for student in ["ann", "bob"] {
            // The set is named after its bank.
            let variant = Maker::new(problem, 11, "wheels-on-inclines").variant(student).unwrap();
            for (datum, value) in problem.data.iter().zip(&variant.data) {
                data.insert((student.to_owned(), datum.symbol.clone()), *value);
            }
            let again = make_key::key(problem, &variant);
            assert_eq!(again.follows.len(), problem.follows.len());
        }
        Class { room, key, data }
    }
    fn path(&self, name: &str) -> String {
        self.room.path().join(name).display().to_string()
    }
    /// Value of the key, in the asked unit.
    fn key(&self, student: &str, problem: &str, part: &str) -> f64 {
        self.key[&(student.to_owned(), problem.to_owned(), part.to_owned())].0
    }
    fn datum(&self, student: &str, symbol: &str) -> f64 {
        self.data[&(student.to_owned(), symbol.to_owned())]
    }
    /// Grades rows `student,problem,part,answer,submitted_at` and gives answers.csv row by row.
    fn grade(&self, answers: &[String], course: &str) -> Vec<BTreeMap<String, String>> {
        let head = "student,problem,part,answer,submitted_at\n";
        fs::write(self.path("in.csv"), head.to_owned() + &answers.join("\n") + "\n").unwrap();
        fs::write(self.path("course.yaml"), course).unwrap();
        let (set, given, out, file) =
            (self.path("set"), self.path("in.csv"), self.path("graded"), self.path("course.yaml"));
        let (exit, said, err) = run(&["grade", &set, &given, "--out", &out, "--course", &file, "--force"]);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""), "{said}");
        rows(&fs::read_to_string(Path::new(&out).join("answers.csv")).unwrap())
    }
    fn gradebook(&self, student: &str) -> BTreeMap<String, String> {
        let text = fs::read_to_string(self.path("graded/gradebook.csv")).unwrap();
        rows(&text).into_iter().find(|r| r["student"] == student).unwrap()
    }
}

fn seen(row: &BTreeMap<String, String>) -> (&str, &str, &str) {
    (&row["verdict"], &row["points"], &row["credit"])
}

#[test]
fn what_follows_from_a_wrong_answer_earns_method_marks() {
    let class = Class::new();
    let (omega, v) = (class.key("ann", "1", "omega"), class.key("ann", "1", "v"));
    let r = class.datum("ann", "r");
    // 1.3 times the right omega, and v = r omega from it.
    let wrong = omega * 1.3;
    let answers = |omega: f64, v: f64| vec![format!("ann,1,omega,{omega:.6},"), format!("ann,1,v,{v:.6},")];
    let graded = class.grade(&answers(wrong, wrong * r), "");
    assert_eq!(seen(&graded[0]).0, "wrong");
    assert_eq!(seen(&graded[1]), ("wrong", "0.5", "follow:omega"));
    assert!(
        graded[1]["reason"].contains("follows correctly from your own answer to omega: 50 %"),
        "{graded:?}"
    );
    // The share is the course's.
    let graded = class.grade(&answers(wrong, wrong * r), "credit: {follow through: 80 %}");
    assert_eq!(seen(&graded[1]), ("wrong", "0.8", "follow:omega"));
    let graded = class.grade(&answers(wrong, wrong * r), "credit: {follow through: 0 %}");
    assert_eq!(seen(&graded[1]), ("wrong", "0", ""));
    // What does not follow earns nothing; what is right is right.
    let graded = class.grade(&answers(wrong, wrong * r * 1.1), "");
    assert_eq!(seen(&graded[1]), ("wrong", "0", ""));
    let graded = class.grade(&answers(wrong, v), "");
    assert_eq!(seen(&graded[1]), ("right", "1", ""));
    // From a right answer nothing follows but the right one.
    let graded = class.grade(&answers(omega, v * 1.3), "");
    assert_eq!(seen(&graded[1]), ("wrong", "0", ""));
    // Trivial values, data repeated, and what cannot be.
    for trivial in [1.0, 0.0, class.datum("ann", "P"), class.datum("ann", "m"), omega * 11.0] {
        let graded = class.grade(&answers(trivial, trivial * r), "");
        assert_eq!(seen(&graded[1]), ("wrong", "0", ""), "{trivial}");
    }
    // The order of the rows and the unit do not matter.
    let rpm = wrong * 60.0 / std::f64::consts::TAU;
    let mut turned =
        vec![format!("ann,1,v,{:.6} cm/s,", wrong * r * 100.0), format!("ann,1,omega,{rpm:.6} rpm,")];
    let graded = class.grade(&turned, "");
    assert_eq!(seen(&graded[0]), ("wrong", "0.5", "follow:omega"));
    // With the best attempt the one that follows counts before one that does not; its source is the one that counts.
    turned.push("ann,1,v,7.77 m/s,".to_owned());
    let graded = class.grade(&turned, "attempts: best");
    assert_eq!([&*graded[0]["verdict"], &*graded[2]["verdict"]], ["wrong", "superseded"]);
    assert_eq!(seen(&graded[0]), ("wrong", "0.5", "follow:omega"));
    // Another student's answers have nothing to do with it.
    let graded = class.grade(&[format!("bob,1,omega,{wrong:.6},"), format!("ann,1,v,{:.6},", wrong * r)], "");
    assert_eq!(seen(&graded[1]).2, "");
}

#[test]
fn a_chain_follows_step_by_step() {
    let class = Class::new();
    let key = |part: &str| class.key("bob", "2", part);
    let (phi, friction) = (key("phi") * 1.25, key("friction"));
    let bank = &support::banks().into_iter().find(|b| b.id == "wheels-on-inclines").unwrap();
    let problem = bank.problems.iter().find(|p| p.id == "pulled-slipping").unwrap();
    let variant = Maker::new(problem, 11, "wheels-on-inclines").variant("bob").unwrap();
    let datum = |symbol: &str| variant.data[problem.data.iter().position(|d| d.symbol == symbol).unwrap()];
    let slip = (datum("d") - datum("r") * phi).abs();
    let heat = friction.abs() * slip;
    let graded = class.grade(
        &[
            format!("bob,2,phi,{phi:.6},"),
            format!("bob,2,friction,{friction:.6},"),
            format!("bob,2,slip_distance,{slip:.6},"),
            format!("bob,2,heat,{heat:.6},"),
        ],
        "",
    );
    let share = |i: usize| {
        let number = |name: &str| graded[i][name].parse::<f64>().unwrap();
        (number("points") / number("max_points"), graded[i]["credit"].as_str())
    };
    assert_eq!([0, 1, 2, 3].map(|i| graded[i]["verdict"].as_str()), ["wrong", "right", "wrong", "wrong"]);
    assert_eq!([1, 2, 3].map(share), [(1.0, ""), (0.5, "follow:phi"), (0.5, "follow:slip_distance")]);
}

#[test]
fn known_wrong_methods_may_earn_credit() {
    let class = Class::new();
    // A17 (the half forgotten): omega over the square root of 2.
    let answer = [format!("ann,1,omega,{:.5},", class.key("ann", "1", "omega") / 2.0f64.sqrt())];
    let graded = class.grade(&answer, "");
    assert!(graded[0]["methods"].split(' ').any(|m| m == "A17"), "{graded:?}");
    assert_eq!(seen(&graded[0]), ("wrong", "0", ""));
    let graded = class.grade(&answer, "credit: {wrong methods: 10 %, A17: 25 %}");
    assert_eq!(seen(&graded[0]), ("wrong", "0.25", "methods"));
    let (exit, _, err) = {
        fs::write(class.path("course.yaml"), "credit: {Z99: 25 %}\npoints: {3.v: 2}\nextensions: {zoe: 2026-01-01 12:00}\ncorrections: [{part: 1.w, why: x}]\n").unwrap();
        let (set, given, out, file) =
            (class.path("set"), class.path("in.csv"), class.path("other"), class.path("course.yaml"));
        run(&["grade", &set, &given, "--out", &out, "--course", &file])
    };
    assert_eq!(exit, Exit::Faulty);
    let err = err.replace(&class.path(""), "ROOM/");
    insta::assert_snapshot!(err, @r"
    error: ROOM/course.yaml:2:10: points: the set has no part `3.v`
        hint: its parts: 1.omega, 1.v, 1.friction, 1.mu_required, 1.cord_travel, 1.k_bound, 2.rolls, 2.friction_if_rolled, 2.friction, 2.v, 2.omega, 2.phi, 2.slip_distance, 2.heat
    error: ROOM/course.yaml:4:22: corrections: the set has no part `1.w`
        hint: its parts: 1.omega, 1.v, 1.friction, 1.mu_required, 1.cord_travel, 1.k_bound, 2.rolls, 2.friction_if_rolled, 2.friction, 2.v, 2.omega, 2.phi, 2.slip_distance, 2.heat
    error: ROOM/course.yaml: credit: no problem of the set knows a wrong method `Z99`
        hint: ids stand in the column `methods` of answers.csv, and in `lint`
    error: ROOM/course.yaml: extensions: the set has no student `zoe`
        hint: write the id as on the roster, in quotes where it begins with a zero
    4 findings
    ");
    assert!(!Path::new(&class.path("other")).exists());
}

#[test]
fn further_attempts_and_lateness_cost_what_the_course_says() {
    let class = Class::new();
    let omega = class.key("ann", "1", "omega");
    let at = |answer: f64, time: &str| format!("ann,1,omega,{answer:.6},{time}");
    let course = "\
time zone: Europe/Berlin
due: 2026-03-28 23:59
attempts: {count: best, at most: 3, penalty: 20 %, least: 30 %}
late: {penalty: 10 %, per: day, at most: 50 %, grace: 5 min, closes: 2026-04-10 12:00}
";
    // Right at the second attempt, in rows that are not in the order of time.
    let rows = [at(omega, "2026-03-20 12:00"), at(1.5, "2026-03-19 12:00"), at(omega, "2026-03-21 12:00")];
    let graded = class.grade(&rows, course);
    assert_eq!(seen(&graded[0]), ("right", "0.8", "attempt:0.8"));
    assert_eq!([&*graded[1]["verdict"], &*graded[2]["verdict"]], ["superseded", "superseded"]);
    // The fourth is not looked at.
    let rows: Vec<String> = ["17", "18", "19", "20"]
        .iter()
        .map(|day| at(if *day == "20" { omega } else { 1.5 }, &format!("2026-03-{day} 12:00")))
        .collect();
    let graded = class.grade(&rows, course);
    assert_eq!(seen(&graded[3]).0, "superseded");
    assert_eq!(graded.iter().filter(|r| r["verdict"] == "wrong").count(), 1);
    // Summer time begins in the night: a day after 23:59 is 23:59 of the next day all the same.
    for (time, points, credit) in [
        ("2026-03-28 23:59", "1", ""),
        ("2026-03-29 00:03", "1", ""),
        ("2026-03-29 00:05", "0.9", "late:0.9"),
        ("2026-03-28T23:05:00Z", "0.9", "late:0.9"),
        ("2026-03-29T23:30:00+02:00", "0.9", "late:0.9"),
        ("2026-03-30 01:00", "0.8", "late:0.8"),
        ("2026-04-08 12:00", "0.5", "late:0.5"),
        ("2026-04-10 12:01", "0", "closed"),
        ("yesterday", "1", ""),
    ] {
        let graded = class.grade(&[at(omega, time)], course);
        assert_eq!(seen(&graded[0]), ("right", points, credit), "{time}");
    }
    // A student with more time, and one attempt too late after one in time.
    let more = format!("{course}extensions: {{ann: 2026-04-11 00:00}}\n");
    assert_eq!(seen(&class.grade(&[at(omega, "2026-04-10 12:01")], &more)[0]), ("right", "1", ""));
    let rows = [at(1.5, "2026-03-20 12:00"), at(omega, "2026-04-11 12:00")];
    let graded = class.grade(&rows, course);
    assert_eq!([&*graded[0]["verdict"], &*graded[1]["verdict"]], ["wrong", "superseded"]);
    // The last attempt counts, and costs by its number.
    let course = "attempts: {count: last, penalty: 10 %}\n";
    let rows = [at(1.5, "2026-03-20 12:00"), at(2.5, "2026-03-20 12:01"), at(omega, "2026-03-20 12:02")];
    assert_eq!(seen(&class.grade(&rows, course)[2]), ("right", "0.8", "attempt:0.8"));
}

#[test]
fn a_correction_is_for_everybody() {
    let class = Class::new();
    let rows = ["ann,1,v,1.5,".to_owned(), "ann,1,omega,huh,".to_owned()];
    let course = "corrections:\n  - {part: 1.v, why: the figure was cut}\n  - {part: 1.omega, give: 50 %, to: answered, why: unclear}\n";
    let graded = class.grade(&rows, course);
    assert_eq!(seen(&graded[0]), ("wrong", "1", "correction"));
    assert!(
        graded[0]["reason"].ends_with("100 % of the points for everybody: the figure was cut"),
        "{graded:?}"
    );
    assert_eq!(seen(&graded[1]), ("unreadable", "0.5", "correction"));
    let (ann, bob) = (class.gradebook("ann"), class.gradebook("bob"));
    assert_eq!([&*ann["1.v"], &*ann["1.omega"], &*ann["total"]], ["1", "0.5", "1.5"]);
    assert_eq!([&*bob["1.v"], &*bob["1.omega"], &*bob["total"]], ["1", "", "1"]);
}

#[test]
fn totals_have_the_points_of_the_course() {
    let class = Class::new();
    let rows = [
        format!("ann,1,omega,{:.6},", class.key("ann", "1", "omega")),
        format!("ann,2,v,{:.6},", class.key("ann", "2", "v")),
    ];
    let course = "points: {1.omega: 2.4, pulled-slipping.v: 0.3}\nround: {to: 0.5, way: up}\n";
    let graded = class.grade(&rows, course);
    assert_eq!(
        [&*graded[0]["points"], &*graded[0]["max_points"], &*graded[1]["points"]],
        ["2.4", "2.4", "0.3"]
    );
    assert_eq!(class.gradebook("ann")["total"], "3");
    class.grade(&rows, &format!("{course}drop lowest: 1\n"));
    let ann = class.gradebook("ann");
    assert_eq!([&*ann["total"], &*ann["dropped"]], ["2.5", "2"]);
    // What it was made from lies beside it.
    let grading = fs::read_to_string(class.path("graded/grading.json")).unwrap();
    for word in
        ["\"seed\": 11", "\"draw_version\": ", "\"bank_sha256\": ", "\"key_sha256\": ", "\"course_sha256\": "]
    {
        assert!(grading.contains(word), "{word} in {grading}");
    }
    for name in ["set.json", "bank.yaml", "key.csv"] {
        let (a, b) = (class.path(&format!("graded/basis/{name}")), class.path(&format!("set/{name}")));
        assert_eq!(fs::read(a).unwrap(), fs::read(b).unwrap(), "{name}");
    }
    assert_eq!(run(&["course"]).1, slipstick::bank::course::EXAMPLE);
}
