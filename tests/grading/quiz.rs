//! Quizzes of learning platforms as submissions: is each answer judged by the variant whose code its question shows, does the mark
//! go to who wrote it, and is no row lost? The downloads are written as the platforms write them, with places for what depends on
//! the set.
use crate::support::program;
use proptest::prelude::*;
use slipstick::cli::tell::Exit;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

type Rows = Vec<BTreeMap<String, String>>;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

fn rows(text: &str) -> Rows {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let fields = |r: csv::StringRecord| head.iter().cloned().zip(r.iter().map(str::to_owned)).collect();
    reader.records().map(|r| fields(r.unwrap())).collect()
}

/// A set: a pool of variants, or a class.
struct Room {
    room: TempDir,
    key: Rows,
}

impl Room {
    fn new(students: &[&str], problems: &str) -> Self {
        let room = tempfile::tempdir().unwrap();
        let at = |name: &str| room.path().join(name).display().to_string();
        let named = students.iter().map(|s| format!("{s},\n")).collect::<String>();
        fs::write(at("roster.csv"), format!("student,name\n{named}")).unwrap();
        let (roster, out) = (at("roster.csv"), at("set"));
        let more = ["--roster", &roster, "--out", &out, "--seed", "5", "--problems", problems];
        let (exit, _, err) = run(&[&["generate", "wheels-on-inclines"], &more[..]].concat());
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
        let key = rows(&fs::read_to_string(at("set/key.csv")).unwrap());
        Self { room, key }
    }
    fn pool() -> Self {
        let names: Vec<String> = (1..=6).map(|i| format!("v{i:04}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        Self::new(&names, "pulled-rolling,spring-released")
    }
    fn at(&self, name: &str) -> String {
        self.room.path().join(name).display().to_string()
    }
    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.at(name)).unwrap()
    }
    fn key(&self, student: &str, problem: &str, part: &str) -> &BTreeMap<String, String> {
        let is = |r: &&BTreeMap<String, String>| {
            r["student"] == student && r["problem"] == problem && (r["part"] == part || part.is_empty())
        };
        self.key.iter().find(is).unwrap_or_else(|| panic!("{student} {problem}.{part}"))
    }
    /// What stands for a place: `key v0001 1 omega`.
    fn place(&self, place: &str) -> String {
        let [what, student, problem, part] =
            [0, 1, 2, 3].map(|i| place.split(' ').nth(i).unwrap_or_default());
        let key = self.key(student, problem, part);
        if what.eq_ignore_ascii_case("code") {
            let code = key["code"].clone();
            return if what == "CODE" { code.to_uppercase() } else { code };
        }
        let Ok(value) = key["value"].parse::<f64>() else { return key["value"].clone() };
        let bare = format!("{value:.6}");
        match what {
            "key" => format!("{bare} {}", key["unit"]).replace(" 1", ""),
            "bare" => bare,
            "comma" => bare.replace('.', ","),
            "commas" => bare.replace('.', "\\,"),
            "off" => format!("{:.6}", value * 1.7),
            other => panic!("{other}"),
        }
    }
    /// A download, with its places filled in.
    fn download(&self, name: &str) -> String {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/quizzes").join(name);
        let text = fs::read_to_string(file).unwrap();
        let mut pieces = text.split("{{");
        let mut out = pieces.next().unwrap().to_owned();
        for piece in pieces {
            let (place, rest) = piece.split_once("}}").unwrap();
            out.push_str(&self.place(place));
            out.push_str(rest);
        }
        out
    }
    fn grade(&self, file: &str, out: &str, more: &[&str]) -> (Exit, String, String) {
        let (set, file, out) = (self.at("set"), self.at(file), self.at(out));
        run(&[&["grade", &set, &file, "--out", &out, "--force"], more].concat())
    }
    /// Grades a download; what it said.
    fn graded(&self, text: &[u8], out: &str, more: &[&str]) -> String {
        fs::write(self.at("quiz.csv"), text).unwrap();
        let (exit, told, err) = self.grade("quiz.csv", out, more);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
        told
    }
    fn answers(&self, out: &str) -> Rows {
        rows(&self.read(&format!("{out}/answers.csv")))
    }
    /// Verdict and points of the answer that counts.
    fn counts(&self, out: &str, student: &str, part: &str) -> String {
        let (problem, part) = part.split_once('.').unwrap();
        let all = self.answers(out);
        let own = all.iter().filter(|r| {
            (r["student"].as_str(), r["problem"].as_str(), r["part"].as_str()) == (student, problem, part)
                && !["superseded", "blank"].contains(&r["verdict"].as_str())
        });
        let told: Vec<String> = own.map(|r| format!("{} {}", r["verdict"], r["points"])).collect();
        told.join("; ")
    }
}

#[test]
fn a_moodle_quiz_over_a_pool() {
    let room = Room::pool();
    let quiz = room.download("moodle-en.csv");
    let told = room.graded(quiz.as_bytes(), "g", &[]);
    for said in [
        "from Moodle's responses: 6 attempts by 5 students",
        "None of them is on the roster of the set: the marks are of those who answered, by ID number.",
        "never submitted, and judged all the same: 1 attempt",
        "questions whose code is none of this set, with 1 answer: 00000000",
        "is not known of 1 answer",
    ] {
        assert!(told.contains(said), "{said}\n{told}");
    }
    // Amina took it twice: of each part the last answer counts, each judged by its own data.
    let of = |part: &str| room.counts("g", "0017", part);
    assert_eq!(of("1.omega"), "wrong 0");
    assert_eq!([of("1.v"), of("1.friction"), of("1.k_bound")], ["right 1", "right 2", "right 1"]);
    assert_eq!(
        [of("2.direction"), of("2.x_eq"), of("2.v"), of("2.friction")],
        ["right 1", "right 1", "right 2", ""]
    );
    let answers = room.answers("g");
    let earlier = answers.iter().find(|r| r["part"] == "omega" && r["verdict"] == "superseded").unwrap();
    let [then, now] = [room.place("code v0003 1"), room.place("code v0005 1")];
    assert_eq!(earlier["reason"], format!("the answer to variant {then}; variant {now} counts"));
    // What others wrote: commas, texts, a question of another set, one answer where six were asked.
    assert_eq!(room.counts("g", "0023", "1.omega"), "right 1");
    assert_eq!(
        [room.counts("g", "0023", "1.v"), room.counts("g", "0023", "1.friction")],
        ["unreadable 0"; 2]
    );
    assert_eq!(room.counts("g", "0031", "00000000."), "unknown part 0");
    assert_eq!(room.counts("g", "0031", "2.Response 2"), "unknown part 0");
    assert_eq!(room.counts("g", "0047", "1.omega"), "right 1");
    // Each attempt has a row for each part, or for each answer that has no place; on its line of the download.
    assert_eq!(answers.len(), 12 + 12 + 12 + (1 + 1) + 12 + 12);
    let line = |text: &str| 1 + quiz[..quiz.find(text).unwrap()].matches('\n').count();
    assert_eq!(earlier["line"], line("Yusuf,Amina").to_string());
    let absent: Vec<_> = answers.iter().filter(|r| r["student"] == "0048").collect();
    assert!(absent.iter().all(|r| r["verdict"] == "blank" && r["line"] == line("Absent,Abe").to_string()));
    // The gradebooks name those who answered, and nobody of the pool.
    let book = rows(&room.read("g/gradebook.csv"));
    let ids: Vec<&str> = book.iter().map(|r| r["student"].as_str()).collect();
    assert_eq!(ids, ["0017", "0023", "0031", "0047", "0048"]);
    assert_eq!((book[0]["name"].as_str(), book[0]["total"].as_str()), ("Amina Yusuf", "10"));
    assert_eq!(book[1]["name"], "<script>alert(1)</script> O'Neil =HYPERLINK(\"http://x\")");
    let moodle = room.read("g/gradebook-moodle.csv");
    assert!(moodle.starts_with("ID number,Name,") && moodle.contains("0017,Amina Yusuf,10,"), "{moodle}");
    assert!(!room.read("g/report.html").contains("<script>alert(1)"));
    // A third attempt that is still open takes the place of none that was submitted, wherever it stands in the file.
    let begin = quiz.find("Yusuf,Amina,0017,amina@example.org,Finished,\"3 March").unwrap();
    let second =
        &quiz[begin..][..1 + quiz[begin..].find("\"\n").or_else(|| quiz[begin..].find("-\n")).unwrap()];
    let open = second.replacen("Finished", "In progress", 1).replacen("3 March 2026  9:20 AM", "-", 1);
    let right =
        format!("{}\n", open.replace(&room.place("off v0005 1 omega"), &room.place("key v0005 1 omega")));
    let right = format!("{}\n{right}", quiz.trim_end());
    let open = format!("{}\n", open.replace(&room.place("key v0002 2 v"), "1"));
    let last = format!("{}\n{open}", quiz.trim_end());
    let first = [&quiz[..begin], &open, &quiz[begin..]].concat();
    let earlier = quiz.find("Yusuf,Amina,0017,amina@example.org,Finished,\"1 March").unwrap();
    let (one, rest) = (&quiz[earlier..begin], &quiz[begin + second.len()..]);
    let newest = [&quiz[..earlier], &open, second.trim_end(), "\n", one, rest].concat();
    // The other ways to choose among attempts.
    for (attempts, omega, v) in
        [("first", "right 1", "wrong 0"), ("best", "right 1", "right 2"), ("last", "wrong 0", "right 2")]
    {
        for text in [&*quiz, &last, &first, &newest, &right] {
            room.graded(text.as_bytes(), "g", &["--attempts", attempts]);
            assert_eq!((of("1.omega"), of("2.v")), (omega.to_owned(), v.to_owned()), "{attempts}");
        }
    }
}

#[test]
fn a_german_moodle_quiz_of_a_class() {
    let room = Room::new(&["0017", "0023", "Bo@Uni.example"], "pulled-rolling");
    let quiz = room.download("moodle-de.csv");
    let (latin, _, lost) = encoding_rs::WINDOWS_1252.encode(&quiz);
    assert!(!lost);
    for text in [quiz.as_bytes(), &latin] {
        let told = room.graded(text, "g", &["--language", "de"]);
        assert!(told.contains("3 attempts by 3 students") && !told.contains("None of them"), "{told}");
        let of = |student: &str, part: &str| room.counts("g", student, part);
        // Found by number and by address; each is judged by what the other was to get.
        assert_eq!(
            [of("0017", "1.omega"), of("0017", "1.v"), of("0017", "1.friction")],
            ["right 1", "right 1", "wrong 0"]
        );
        assert_eq!(of("Bo@Uni.example", "1.omega"), "right 1");
        assert_eq!(of("gast", "1.omega"), "unknown student 0");
        let book = rows(&room.read("g/gradebook.csv"));
        let totals: Vec<(&str, &str)> =
            book.iter().map(|r| (r["student"].as_str(), r["total"].as_str())).collect();
        assert_eq!(totals, [("0017", "2"), ("0023", "0"), ("Bo@Uni.example", "1")]);
    }
    // Lateness counts by the time of submission.
    fs::write(room.at("course.yaml"), "due: 2026-03-01 09:42\nlate: {penalty: 50 %, per: once}\n").unwrap();
    room.graded(quiz.as_bytes(), "g", &["--course", &room.at("course.yaml")]);
    assert_eq!(room.counts("g", "0017", "1.omega"), "right 1");
    assert_eq!(room.counts("g", "Bo@Uni.example", "1.omega"), "right 0.5");
}

#[test]
fn a_canvas_quiz_draws_each_part_by_itself() {
    let room = Room::pool();
    let quiz = room.download("canvas.csv");
    let told = room.graded(quiz.as_bytes(), "g", &["--attempts", "best"]);
    assert!(told.contains("from Canvas's student analysis: 3 attempts by 2 students"), "{told}");
    assert!(told.contains("by SIS id") && told.contains("is not known of 1 answer"), "{told}");
    let of = |student: &str, part: &str| room.counts("g", student, part);
    assert_eq!([of("S-17", "1.omega"), of("S-17", "1.v")], ["right 1", "right 1"]);
    assert_eq!(
        [of("S-17", "2.direction"), of("S-17", "2.x_eq"), of("S-17", "2.v")],
        ["right 1", "right 1", "right 2"]
    );
    assert_eq!([of("S-17", "2.friction"), of("S-17", "2.v_max")], ["", "unreadable 0"]);
    assert_eq!([of("S-23", "1.omega"), of("S-23", "1.v"), of("S-23", "2.v")], ["right 1", "right 1", ""]);
    room.graded(quiz.as_bytes(), "g", &[]);
    assert_eq!(of("S-17", "1.omega"), "wrong 0");
    let canvas = room.read("g/gradebook-canvas.csv");
    assert!(canvas.contains("Amina Yusuf,5001,S-17,,,"), "{canvas}");
    assert!(canvas.contains("\"O'Neil, =cmd()\",5002,S-23,,,"), "{canvas}");
    // Every mark can be explained, with the data that were asked.
    let g = room.at("g");
    let (exit, page, err) = run(&["explain", &g, "S-23", "1"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let set = room.read("set/set.json");
    let set: serde_json::Value = serde_json::from_str(&set).unwrap();
    for (student, part) in [(1, "Data on the sheet"), (0, "1.v was asked with")] {
        let d = set["students"][student]["problems"][0]["data"]["d"].as_str().unwrap();
        let at = page.find(part).unwrap_or_else(|| panic!("{part}: {page}"));
        let told = page[at..].split_whitespace().take(40).collect::<Vec<_>>().join(" ");
        assert!(told.contains(&format!("d = {d}")), "{part}, {d}: {told}");
    }
    let (exit, page, err) = run(&["explain", &g, "S-17", "1.omega"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let first = page.lines().find(|l| l.contains("line 2")).unwrap();
    assert!(!first.contains("from the key"), "{first}");
}

/// The second of two problems is asked, on Canvas, of students without a SIS id; one of them has one.
#[test]
fn what_nobody_was_asked_does_not_count() {
    let room = Room::pool();
    let place = |text: &str| room.place(text);
    let quiz = format!(
        "name,id,sis_id,submitted,attempt,\"7: A wheel. Code: {}\",14,n correct\n\
         Amina Yusuf,501,,2026-03-01 09:40:00 UTC,1,\"{},{},,,,\",2,2\n\
         Bo Ek,502,S-2,2026-03-01 09:40:00 UTC,1,\"{},,,,,\",1,1\n",
        place("code v0002 2"),
        place("key v0002 2 direction"),
        place("key v0002 2 x_eq"),
        place("key v0002 2 direction"),
    );
    let told = room.graded(quiz.as_bytes(), "g", &[]);
    let left = "the quiz did not ask, and that do not count: 1 (pulled-rolling); in the grades 2 (spring-released) is problem 1";
    assert!(told.contains(left) && told.contains("by Canvas's own number"), "{told}");
    // The second problem gives 7 points, both together 14.
    let most = "7";
    let book = rows(&room.read("g/gradebook.csv"));
    assert!(book.iter().all(|r| r["max_total"] == most), "{book:?}");
    assert!(book[0].keys().all(|column| !column.starts_with("2.")) && book[0]["1.x_eq"] == "1");
    assert_eq!(room.counts("g", "501", "1.direction"), "right 1");
    let canvas = room.read("g/gradebook-canvas.csv");
    for line in
        [format!("Points Possible,,,,,{most}"), "Amina Yusuf,501,,,,2".into(), "Bo Ek,502,S-2,,,1".into()]
    {
        assert!(canvas.lines().any(|l| l == line), "{line}\n{canvas}");
    }
    let basis: serde_json::Value = serde_json::from_str(&room.read("g/basis/set.json")).unwrap();
    assert_eq!(basis["problems"], serde_json::json!(["spring-released"]));
    assert!(!room.read("g/report.html").contains("pulled-rolling"));
    // Graded again, it is the same.
    let (set, g, file, again) = (room.at("set"), room.at("g"), room.at("quiz.csv"), room.at("again"));
    let (exit, told, err) = run(&["regrade", &set, &g, &file, "--out", &again]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""), "{told}");
    for name in ["answers.csv", "gradebook.csv", "gradebook-canvas.csv"] {
        assert_eq!(room.read(&format!("g/{name}")), room.read(&format!("again/{name}")), "{name}");
    }
    // An attempt at which nothing was typed was not judged, and Moodle finds nobody by name.
    let code = place("code v0002 2");
    let opened = format!(
        "Last name,First name,Completed,Question 1,Response 1\nYusuf,Amina,-,Code: {code},part 1: ; part 2: ; part 3: ; part 4: ; part 5: ; part 6: \n"
    );
    let told = room.graded(opened.as_bytes(), "m", &[]);
    assert!(
        !told.contains("never submitted") && told.contains("Moodle cannot import grades by name"),
        "{told}"
    );
    assert!(room.read("m/gradebook-moodle.csv").starts_with("Full name,Name,"));
}

#[test]
fn a_quiz_is_graded_again_by_the_same_variants() {
    let room = Room::pool();
    let quiz = room.download("moodle-en.csv");
    room.graded(quiz.as_bytes(), "g", &[]);
    fs::write(
        room.at("course.yaml"),
        "corrections:\n  - {part: 1.omega, give: full, why: the drawing was wrong}\n",
    )
    .unwrap();
    let at = |name: &str| room.at(name);
    let regrade = |set: &str, out: &str| {
        let (course, out) = (at("course.yaml"), at(out));
        run(&["regrade", set, &at("g"), &at("quiz.csv"), "--course", &course, "--out", &out])
    };
    let (exit, told, err) = regrade(&at("set"), "again");
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""), "{told}");
    assert!(told.contains("Totals rise for 3 and fall for 0 of 5 students"), "{told}");
    let (before, after) = (room.answers("g"), room.answers("again"));
    assert_eq!(before.len(), after.len());
    for (a, b) in before.iter().zip(&after) {
        assert_eq!((&a["line"], &a["verdict"]), (&b["line"], &b["verdict"]));
        assert!(b["reason"].starts_with(&a["reason"]), "{b:?}");
    }
    assert_eq!(room.counts("again", "0017", "1.omega"), "wrong 1");
    // By a set that has not those variants it cannot be.
    let other = Room::new(&["x", "y"], "pulled-rolling,spring-released");
    let (exit, _, err) = regrade(&other.at("set"), "never");
    assert_eq!(exit, Exit::Faulty);
    assert!(err.contains("variants that the quiz asked are missing"), "{err}");
}

#[test]
fn files_that_say_too_little_are_named() {
    let room = Room::pool();
    let quiz = room.download("moodle-en.csv");
    let refused = |text: &str| {
        fs::write(room.at("quiz.csv"), text).unwrap();
        let (exit, out, err) = room.grade("quiz.csv", "never", &[]);
        assert_eq!((exit, out.as_str()), (Exit::Faulty, ""));
        assert!(!Path::new(&room.at("never")).exists());
        err
    };
    // Without the texts of the questions.
    let table: Vec<csv::StringRecord> = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(quiz.as_bytes())
        .records()
        .map(Result::unwrap)
        .collect();
    let mut out = csv::Writer::from_writer(Vec::new());
    for record in &table {
        out.write_record(record.iter().enumerate().filter(|(i, _)| ![9, 12].contains(i)).map(|(_, f)| f))
            .unwrap();
    }
    let err = refused(&String::from_utf8(out.into_inner().unwrap()).unwrap());
    assert!(
        err.contains("no question shows the code of a variant of this set: Response 1, Response 2"),
        "{err}"
    );
    assert!(err.contains("tick `question text`"), "{err}");
    // The report of marks.
    let err = refused(
        "Last name,First name,Email address,Status,Started,Completed,Duration,Grade/14.00,Q. 1 /7.00,Q. 2 /7.00\nA,B,c@d.e,Finished,x,y,z,3,1,2\n",
    );
    assert!(err.contains("report of marks") && err.contains("Responses"), "{err}");
    // Another set.
    let other = Room::new(&["x"], "pulled-rolling");
    fs::write(other.at("quiz.csv"), &quiz).unwrap();
    let (exit, _, err) = other.grade("quiz.csv", "never", &[]);
    assert_eq!(exit, Exit::Faulty);
    assert!(err.contains("codes are of another set: give the set that was exported"), "{err}");
    assert!(!err.contains("tick"), "{err}");
    // Columns in another order, and none but those that are needed, do as well.
    let mut out = csv::Writer::from_writer(Vec::new());
    for record in &table {
        out.write_record([10, 9, 2, 12, 13].map(|i| &record[i])).unwrap();
    }
    room.graded(&out.into_inner().unwrap(), "few", &["--attempts", "last"]);
    assert_eq!(room.counts("few", "0017", "1.omega"), "wrong 0");
    assert_eq!(room.counts("few", "0017", "1.v"), "right 1");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// What students write is judged alike, however it comes in: as a quiz in which each was asked what another one's sheet asks, and
    /// as a plain file of that other one.
    #[test]
    fn a_quiz_and_a_plain_file_agree(
        turn in 0usize..4,
        typed in prop::collection::vec((0usize..9, "[0-9,.; a-z=-]{0,9}"), 48),
        german: bool,
    ) {
        let class = ["0017", "0023", "0031", "0047"];
        let room = Room::new(&class, "pulled-rolling,spring-released");
        let mut plain = csv::Writer::from_writer(Vec::new());
        plain.write_record(["student", "problem", "part", "answer"]).unwrap();
        let mut quiz = csv::Writer::from_writer(Vec::new());
        let (head, word) = match german {
            true => (["ID-Nummer", "Nachname", "Frage 1", "Antwort 1", "Frage 2", "Antwort 2"], "Teil"),
            false => (["ID number", "Surname", "Question 1", "Response 1", "Question 2", "Response 2"], "part"),
        };
        quiz.write_record(head).unwrap();
        let mut typed = typed.into_iter();
        for (i, taker) in class.iter().enumerate() {
            let owner = class[(i + turn) % class.len()];
            let mut cells = vec![(*taker).to_owned(), format!("Name of {taker}")];
            for problem in ["1", "2"] {
                let parts = room.key.iter().filter(|r| r["student"] == owner && r["problem"] == problem);
                let mut answers = Vec::new();
                for key in parts {
                    let (kind, text) = typed.next().unwrap();
                    let place = |what: &str| room.place(&format!("{what} {owner} {problem} {}", key["part"]));
                    let answer = match kind {
                        0 | 1 => place("key"),
                        2 => place("comma"),
                        3 | 4 => place("off"),
                        5 => String::new(),
                        6 => format!("{} furlongs", place("bare")),
                        // A dash alone stands for nothing in Moodle.
                        _ => text.trim_matches([' ', '-', ';']).to_owned(),
                    };
                    plain.write_record([owner, problem, &key["part"], &answer]).unwrap();
                    answers.push(format!("{word} {}: {answer}", answers.len() + 1));
                }
                let code = room.place(&format!("code {owner} {problem}"));
                cells.extend([format!("A wheel. Code: {code}"), answers.join("; ")]);
            }
            quiz.write_record(&cells).unwrap();
        }
        room.graded(&quiz.into_inner().unwrap(), "quiz", &[]);
        room.graded(&plain.into_inner().unwrap(), "plain", &[]);
        let told = |out: &str, turn: usize| -> BTreeMap<(String, String, String), String> {
            room.answers(out).iter().map(|r| {
                let at = class.iter().position(|s| *s == r["student"]).unwrap();
                let owner = class[(at + turn) % class.len()].to_owned();
                let all = ["answer", "verdict", "points", "reason", "methods", "slip", "credit"].map(|c| r[c].as_str());
                ((owner, r["problem"].clone(), r["part"].clone()), all.join("|"))
            }).collect()
        };
        prop_assert_eq!(told("quiz", turn), told("plain", 0));
    }
}
