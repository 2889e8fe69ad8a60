//! Marks by the settings of a course: follow-through, credit for known wrong methods, attempts, lateness, corrections, totals;
//! through the command line, on a real bank.
use crate::support;
use crate::support::program;
use slipstick::cli::tell::Exit;
use slipstick::problem::make_key;
use slipstick::problem::maker::Maker;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
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
    // From an answer that is right within its tolerance something may follow that just misses its own.
    let graded = class.grade(&answers(omega * 1.0095, v * 1.018), "");
    assert_eq!([seen(&graded[0]).0, seen(&graded[1]).2], ["right", "follow:omega"]);
    // Beyond that nothing follows from a right answer but the right one.
    let graded = class.grade(&answers(omega, v * 1.3), "");
    assert_eq!(seen(&graded[1]), ("wrong", "0", ""));
    // Trivial values, data repeated, and what cannot be.
    let nearly = class.datum("ann", "m") * 1.0001;
    for trivial in
        [1.0, 0.0, class.datum("ann", "P"), class.datum("ann", "m"), nearly, 20.0, -wrong, omega * 5.0]
    {
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
        hint: its parts: 1.omega, 1.v, 1.friction, 1.mu_required, 1.cord_travel, 1.k_bound, 2.friction_if_rolled, 2.friction, 2.v, 2.omega, 2.phi, 2.slip_distance, 2.heat
    error: ROOM/course.yaml:4:22: corrections: the set has no part `1.w`
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
        .map(|day| {
            let wrong = day.parse::<f64>().unwrap() / 10.0;
            at(if *day == "20" { omega } else { wrong }, &format!("2026-03-{day} 12:00"))
        })
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
        ("\"28 March 2026, 11:59 PM\"", "1", ""),
        ("\"Sunday, 29 March 2026, 12:05 AM\"", "0.9", "late:0.9"),
        ("2026-03-28 23:05 GMT", "0.9", "late:0.9"),
        ("29.03.26 00:05 CET", "0.9", "late:0.9"),
        ("46110.0034722", "0.9", "late:0.9"),
        ("1774739100", "0.9", "late:0.9"),
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
    // What is handed in again, in a whole sheet say, is no further attempt, nor late.
    let rows = [
        at(1.5, "2026-03-19 12:00"),
        at(omega, "2026-03-20 12:00"),
        at(omega, "2026-03-21 12:00"),
        at(omega, "2026-04-01 12:00"),
    ];
    for counts in ["best", "last"] {
        let graded = class.grade(&rows, &course.replace("best", counts));
        assert_eq!(seen(&graded[1]), ("right", "0.8", "attempt:0.8"), "{counts}");
    }
    // Clocks go back: the same time of the next day is a day later, though 25 hours have passed.
    let autumn = "time zone: Europe/Berlin\ndue: 2026-10-24 23:59\nlate: {penalty: 10 %}\n";
    for (time, points) in
        [("2026-10-24 23:59:59", "1"), ("2026-10-25 23:59:30", "0.9"), ("2026-10-26 00:00:01", "0.8")]
    {
        assert_eq!(seen(&class.grade(&[at(omega, time)], autumn)[0]).1, points, "{time}");
    }
    let rows = [at(omega, "3/4/2026 10:00"), "bob,1,omega,1.5,3/25/2026 10:00".to_owned()];
    let graded = class.grade(&rows, "due: 2026-03-03 23:59\nlate: {penalty: 10 %}\n");
    assert_eq!(seen(&graded[0]), ("right", "0.9", "late:0.9"));
    // Other places use words for zones that the program does not know by itself.
    let london = "time zone: Europe/London\ndue: 2026-07-01 12:00\nlate: {penalty: 10 %}\n";
    for (time, points) in
        [("2026-07-01 11:59 BST", "1"), ("2026-07-01 12:01 BST", "0.9"), ("2026-07-01 11:01 UTC", "0.9")]
    {
        assert_eq!(seen(&class.grade(&[at(omega, time)], london)[0]).1, points, "{time}");
    }
    // The last attempt counts, and costs by its number.
    let course = "attempts: {count: last, penalty: 10 %}\n";
    let rows = [at(1.5, "2026-03-20 12:00"), at(2.5, "2026-03-20 12:01"), at(omega, "2026-03-20 12:02")];
    assert_eq!(seen(&class.grade(&rows, course)[2]), ("right", "0.8", "attempt:0.8"));
}

/// Before, an answer whose time cannot be read was taken as in time, whatever it cost others to be late, and the tests held it
/// to that; now the course has to say what holds, where it matters.
#[test]
fn where_a_time_is_unread_and_lateness_matters_the_course_says_what_holds() {
    let class = Class::new();
    let omega = class.key("ann", "1", "omega");
    let course = "due: 2026-03-09 23:59\nlate: {penalty: 10 %, at most: 40 %}\n";
    let say = |unread: &str| course.replace("at most: 40 %", &format!("at most: 40 %, unread: {unread}"));
    let refused = |answers: &[String], course: &str, head: &str| {
        let out = class.path("refused");
        fs::write(class.path("in.csv"), format!("{head}\n{}\n", answers.join("\n"))).unwrap();
        fs::write(class.path("course.yaml"), course).unwrap();
        let args = ["grade", &class.path("set"), &class.path("in.csv"), "--out", &out, "--course"];
        let (exit, said, err) = run(&[&args[..], &[&class.path("course.yaml")]].concat());
        assert_eq!((exit, said.as_str()), (Exit::Faulty, ""), "{err}");
        assert!(!Path::new(&out).exists());
        err.replace(&class.path(""), "")
    };
    let head = "student,problem,part,answer,submitted_at";
    for (time, piece) in [
        ("yesterday", "1 answer that counts has no time that can be read (line 2: `yesterday`)"),
        ("", "(line 2: nothing)"),
        ("3/4/2026 10:00", "`dates: day first` or `dates: month first`"),
        ("2026-03-01 10:00 CST", "(line 2: `2026-03-01 10:00 CST`, CST means several zones)"),
    ] {
        let row = [format!("ann,1,omega,{omega:.6},{time}")];
        let err = refused(&row, course, head);
        assert!(err.contains(piece) && err.contains("late: {unread: in time}"), "{time}: {err}");
        let graded = class.grade(&row, &say("in time"));
        assert_eq!(seen(&graded[0]), ("right", "1", ""), "{time}");
        assert!(graded[0]["reason"].contains("taken as in time"), "{graded:?}");
        let graded = class.grade(&row, &say("late"));
        assert_eq!(seen(&graded[0]), ("right", "0.6", "late:0.6"), "{time}");
        assert!(graded[0]["reason"].contains("taken as late"), "{graded:?}");
        let closed = say("late").replace("penalty: 10 %", "closes: 2026-03-20 12:00");
        assert_eq!(seen(&class.grade(&row, &closed)[0]), ("right", "0", "closed"), "{time}");
        // Where lateness costs nothing nobody asks.
        assert_eq!(seen(&class.grade(&row, "due: 2026-03-09 23:59\n")[0]), ("right", "1", ""));
    }
    // No column of times at all.
    let row = [format!("ann,1,omega,{omega:.6}")];
    let err = refused(&row, course, "student,problem,part,answer");
    assert!(err.contains("no column `submitted_at`, and lateness bears on marks"), "{err}");
    // One attempt that is read and one that is not: only what counts is asked for.
    let rows = [format!("ann,1,omega,{omega:.6},2026-03-01 10:00"), "nobody,1,omega,1,yesterday".to_owned()];
    assert_eq!(seen(&class.grade(&rows, course)[0]), ("right", "1", ""));
    // The course decides what comes first, against no proof in the file.
    for (first, points) in [("day first", "0.6"), ("month first", "1")] {
        let row = format!("ann,1,omega,{omega:.6},3/4/26 10:00");
        let graded = class.grade(&[row], &format!("dates: {first}\n{course}"));
        assert_eq!(seen(&graded[0]).1, points, "{first}");
    }
}

/// Tests of lateness wrote a time of day always, so a date alone was midnight, the best of the day for who is late, and nobody
/// was told; and no weekday of a test contradicted its date.
#[test]
fn a_date_without_a_time_of_day_is_no_early_morning() {
    let class = Class::new();
    let omega = class.key("ann", "1", "omega");
    let row = |time: &str| [format!("ann,1,omega,{omega:.6},{time}")];
    let course = "due: 2026-03-29 15:30\ntime zone: Europe/Berlin\nlate: {penalty: 10 %, per: day, unread: late, at most: 40 %}\n";
    for (time, points, piece) in [
        // Due in the middle of that day; a step of lateness in the middle of the next one; the most from then on.
        ("2026-03-28", "1", "read as 00:00"),
        ("2026-03-29", "0.6", "taken as late, because it is not known when it came (no time of day"),
        ("46110", "0.6", "no time of day"),
        ("2026-03-30", "0.6", "no time of day"),
        ("2026-04-20", "0.6", "read as 00:00"),
        ("\"Monday, 29 March 2026, 3:30 PM\"", "0.6", "the day of the week does not fit the date"),
        ("\"Sunday, 29 March 2026, 3:30 PM\"", "1", "within the tolerance"),
        ("2026-03-29 15:00 CST", "0.6", "CST means several time zones"),
        ("20260329T133000Z", "1", "within the tolerance"),
        ("20260329T133101Z", "0.9", "late"),
        ("3-29-2026 15:30", "1", "within the tolerance"),
        ("2026-03-29 15h31", "0.9", "late"),
    ] {
        let graded = class.grade(&row(time), course);
        assert_eq!(graded[0]["points"], points, "{time}: {graded:?}");
        assert!(graded[0]["reason"].contains(piece), "{time}: {graded:?}");
    }
    let closes = course.replace("penalty: 10 %", "closes: 2026-04-02 12:00");
    for (time, points) in [("2026-04-01", "1"), ("2026-04-02", "0"), ("2026-04-03", "0")] {
        let graded = class.grade(&row(time), &closes);
        let unread = graded[0]["reason"].contains("not known when it came");
        assert_eq!(
            (graded[0]["points"].as_str(), unread),
            (points, time == "2026-04-02"),
            "{time}: {graded:?}"
        );
    }
    // Lateness costs nothing: a date is as good as a time.
    let graded = class.grade(&row("2026-03-29"), "due: 2026-03-29 15:30\n");
    assert_eq!(graded[0]["reason"], "within the tolerance");
}

#[test]
fn a_correction_is_for_everybody() {
    let class = Class::new();
    let rows = ["ann,1,v,1.5,".to_owned(), "ann,1,omega,huh,".to_owned()];
    let course = "corrections:\n  - {part: 1.v, why: the figure was cut}\n  - {part: 1.omega, give: 50 %, to: answered, why: unclear}\n";
    let graded = class.grade(&rows, course);
    assert_eq!(seen(&graded[0]), ("wrong", "1", "correction"));
    assert!(
        graded[0]["reason"].ends_with("100 % of the points by a correction: the figure was cut"),
        "{graded:?}"
    );
    assert_eq!(seen(&graded[1]), ("unreadable", "0.5", "correction"));
    let (ann, bob) = (class.gradebook("ann"), class.gradebook("bob"));
    // Two corrections of one part: each student gets the better of those that are for them.
    assert_eq!([&*ann["1.v"], &*ann["1.omega"], &*ann["total"]], ["1", "0.5", "1.5"]);
    assert_eq!([&*bob["1.v"], &*bob["1.omega"], &*bob["total"]], ["1", "", "1"]);
    let course = "corrections:\n  - {part: 1.v, give: 50 %, why: a}\n  - {part: 1.v, to: answered, why: b}\n";
    class.grade(&rows, course);
    assert_eq!([&*class.gradebook("ann")["1.v"], &*class.gradebook("bob")["1.v"]], ["1", "0.5"]);
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
    // Rounding up gives no more than there is.
    class.grade(&rows, "round: {to: 1000, way: up}\n");
    let ann = class.gradebook("ann");
    assert_eq!(ann["total"], ann["max_total"]);
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
