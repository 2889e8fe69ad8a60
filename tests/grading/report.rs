//! Reports on simulated classes of 5, 60 and 500: valid pages, numbers equal to those counted again from answers.csv, feedback
//! that tells nothing of the key nor of others, gradebooks that can be imported.
use crate::support::program;
use scraper::{Html, Selector};
use slipstick::bank::load;
use slipstick::cli::tell::Exit;
use slipstick::key::{Answer, KeyEntry, SheetKey};
use slipstick::misconception::catalogue::Catalogue;
use slipstick::set::replay;
use slipstick::set::store::StoredSet;
use slipstick::template::variables_of;
use slipstick::words::Words;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Runs a command line; what it printed.
fn run(args: &[&str], exit: Exit) -> String {
    let ran = program::run(args);
    let text = ran.out + &ran.err;
    assert_eq!(ran.exit, exit, "{args:?}\n{text}");
    text
}

/// Numbers from 0 to 1 that look like chance.
struct Lot(u64);

impl Lot {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A set, what was handed in, and its grading with the report.
struct Graded {
    room: TempDir,
    keys: Vec<SheetKey>,
}

impl Graded {
    fn path(&self, name: &str) -> PathBuf {
        self.room.path().join(name)
    }
    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }
    fn report(&self, more: &[&str]) -> String {
        let grades = self.path("grades").display().to_string();
        run(&[&["report", &grades], more].concat(), Exit::Fine)
    }
    fn rows(&self, name: &str) -> Vec<BTreeMap<String, String>> {
        let mut reader = csv::Reader::from_path(self.path(name)).unwrap();
        reader.deserialize().map(Result::unwrap).collect()
    }
}

/// A class of so many that hands in: the able more right than the others, the wrong ones by known methods, slips and all else.
fn class(students: usize, problems: &str, course: &str) -> Graded {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let mut roster = String::from("student,name\n");
    for i in 0..students {
        // Names and ids that a spreadsheet or a page would take for something else.
        let name = ["Amina Yusuf", "=SUM(A1)", "<b>Zoë</b> & Co", "\"García, José\"", "*Li* $x$ 李"][i % 5];
        let _ = writeln!(roster, "s{:04},{name} {i}", i + 1);
    }
    fs::write(path("roster.csv"), roster).unwrap();
    let args = ["generate", "wheels-on-inclines", "--roster", &path("roster.csv"), "--seed", "7"];
    run(
        &[&args[..], &["--out", &path("set"), "--format", "md", "--problems", problems]].concat(),
        Exit::Fine,
    );
    let stored = StoredSet::parse(&fs::read_to_string(path("set/set.json")).unwrap()).unwrap();
    let text = fs::read_to_string(path("set/bank.yaml")).unwrap();
    let bank = load::bank(&text, "bank.yaml", &variables_of).unwrap();
    let keys = replay::keys(&bank, &stored).unwrap();
    fs::write(path("submissions.csv"), hand_in(&keys)).unwrap();
    fs::write(path("course.yaml"), course).unwrap();
    grade(&room, "submissions.csv", &[]);
    Graded { room, keys }
}

/// Grades without reports, which the tests ask for by themselves.
fn grade(room: &TempDir, submissions: &str, more: &[&str]) {
    let path = |name: &str| room.path().join(name).display().to_string();
    let (set, submissions, grades) = (path("set"), path(submissions), path("grades"));
    let args = ["grade", &set, &submissions, "--out", &grades, "--course", &path("course.yaml")];
    run(&[&args[..], &["--reports", "no"], more].concat(), Exit::Fine);
}

fn shown(entry: &KeyEntry, si: f64) -> String {
    entry.unit.text_with(&format!("{:.3e}", entry.unit.from_si(si)))
}

fn hand_in(keys: &[SheetKey]) -> String {
    let mut lot = Lot(42);
    let mut text = String::from("student,problem,part,answer,submitted_at\n");
    for (s, sheet) in keys.iter().enumerate() {
        if s % 17 == 16 {
            continue;
        }
        let ability = (lot.next() + lot.next()) / 2.0;
        for (i, problem) in sheet.problems.iter().enumerate() {
            for (p, entry) in problem.parts.iter().enumerate() {
                let chance = (0.3 + 0.9 * ability - 0.05 * p as f64).clamp(0.05, 0.95);
                let right = match &entry.answer {
                    Answer::Word { right, .. } => (*right).to_owned(),
                    Answer::Number { value, .. } => shown(entry, *value),
                };
                let luck = lot.next();
                let other = lot.next();
                let wrong = match (&entry.answer, luck) {
                    (Answer::Word { offered, right }, _) => {
                        (*offered.iter().find(|o| *o != right).unwrap_or(right)).to_owned()
                    }
                    (_, l) if l < 0.6 && !entry.wrong.is_empty() => {
                        // The favourites are the first of the bank.
                        let at = (other * other * entry.wrong.len() as f64) as usize;
                        shown(entry, entry.wrong[at].value)
                    }
                    (Answer::Number { value, .. }, l) if l < 0.7 => shown(entry, value * 1000.0),
                    (Answer::Number { value, .. }, l) if l < 0.8 => format!("{:.3e} kg", value),
                    (_, l) if l < 0.86 => ["thirty", "=1+2", "3.4.5", "<script>alert(1)</script>"]
                        [(other * 4.0) as usize]
                        .to_owned(),
                    (Answer::Number { value, .. }, _) => shown(entry, value * (1.1 + other)),
                };
                let mut row = |answer: &str, minute: f64| {
                    let at = minute as usize;
                    let _ = writeln!(
                        text,
                        "{},{},{},\"{}\",2026-03-{:02} {:02}:{:02}",
                        sheet.student,
                        i + 1,
                        entry.part,
                        answer.replace('"', "\"\""),
                        1 + at / 1440,
                        at / 60 % 24,
                        at % 60
                    );
                };
                let start = 600.0 + 300.0 * lot.next();
                match lot.next() {
                    l if l < 0.05 => row("  ", start),
                    l if l < 0.2 => {
                        row(&wrong, start);
                        row(&right, start + 5.0 + 2000.0 * lot.next());
                    }
                    _ if lot.next() < chance => row(&right, start),
                    _ => row(&wrong, start),
                }
            }
        }
    }
    text
}

/// A page that a browser reads without a fault, that needs nothing else, with headings in order and pictures that speak.
fn valid(page: &str, language: &str) -> Html {
    let parsed = Html::parse_document(page);
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let select = |css: &str| Selector::parse(css).unwrap();
    assert_eq!(parsed.root_element().value().attr("lang"), Some(language));
    for css in ["script", "link", "img", "iframe", "[src]", "[onload]"] {
        assert_eq!(parsed.select(&select(css)).count(), 0, "{css}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf%") && !page.contains("http://fonts"));
    let mut ids = BTreeSet::new();
    for element in parsed.select(&select("[id]")) {
        assert!(ids.insert(element.value().attr("id").unwrap().to_owned()), "{element:?}");
    }
    for name in ["aria-labelledby", "aria-describedby"] {
        for element in parsed.select(&select(&format!("[{name}]"))) {
            for id in element.value().attr(name).unwrap().split_whitespace() {
                assert!(ids.contains(id), "{name} names {id}");
            }
        }
    }
    for link in parsed.select(&select("a[href]")) {
        let target = link.value().attr("href").and_then(|h| h.strip_prefix('#')).unwrap();
        assert!(ids.contains(target), "#{target}");
    }
    let levels: Vec<u32> =
        parsed.select(&select("h1, h2, h3, h4")).filter_map(|h| h.value().name()[1..].parse().ok()).collect();
    assert_eq!(levels.iter().filter(|l| **l == 1).count(), 1);
    assert!(levels.windows(2).all(|w| w[1] <= w[0] + 1), "{levels:?}");
    for picture in parsed.select(&select("figure > svg")) {
        let words = |css: &str| picture.select(&select(css)).next().unwrap().text().collect::<String>();
        assert!(words("title").len() > 3 && words("desc").len() > 30);
    }
    parsed
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text:?} is no number"))
}

/// The numbers of the report, counted again in a second and simple way.
fn recounted(graded: &Graded) {
    let answers = graded.rows("grades/answers.csv");
    let asked: BTreeSet<(String, String)> = graded
        .rows("grades/basis/key.csv")
        .iter()
        .map(|r| (r["problem"].clone(), r["part"].clone()))
        .collect();
    let none = ["blank", "superseded", "unknown student", "unknown part"];
    let mut points: BTreeMap<String, f64> = BTreeMap::new();
    for row in answers.iter().filter(|r| !none.contains(&r["verdict"].as_str())) {
        *points.entry(row["student"].clone()).or_default() += number(&row["points"]);
    }
    let parts = graded.rows("grades/tables/parts.csv");
    assert_eq!(parts.len(), asked.len());
    for row in &parts {
        let (problem, part) = row["part"].split_once('.').unwrap();
        let of: Vec<_> = answers
            .iter()
            .filter(|r| r["problem"] == problem && r["part"] == part)
            .filter(|r| !none.contains(&r["verdict"].as_str()))
            .collect();
        let right = of.iter().filter(|r| r["verdict"] == "right").count();
        assert_eq!(row["answered"], of.len().to_string(), "{row:?}");
        assert_eq!(row["right"], right.to_string());
        if of.len() >= 5 {
            let share = right as f64 / of.len() as f64;
            assert!((number(&row["share_right"]) - share).abs() < 1e-5);
            assert!(number(&row["interval_low"]) <= share && share <= number(&row["interval_high"]));
        } else {
            assert_eq!(row["share_right"], "");
        }
    }
    // Who handed in only blanks is not among those who handed in.
    let mut totals: Vec<f64> = points.values().copied().collect();
    totals.sort_by(f64::total_cmp);
    let row = &graded.rows("grades/tables/totals.csv")[0];
    assert_eq!(row["students"], totals.len().to_string());
    assert!((number(&row["mean"]) - totals.iter().sum::<f64>() / totals.len() as f64).abs() < 1e-4);
    assert!((number(&row["maximum"]) - totals[totals.len() - 1]).abs() < 1e-6);
    let middle = (totals[(totals.len() - 1) / 2] + totals[totals.len() / 2]) / 2.0;
    assert!((number(&row["median"]) - middle).abs() < 1e-6);
    for row in graded.rows("grades/tables/verdicts.csv") {
        let n = answers.iter().filter(|r| r["verdict"] == row["verdict"]).count();
        assert_eq!(row["cells"], n.to_string(), "{row:?}");
    }
    // The first of the methods that fit is the most likely.
    let mut methods: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for row in answers.iter().filter(|r| ["wrong", "wrong direction"].contains(&r["verdict"].as_str())) {
        if !row["methods"].is_empty() {
            let first = row["methods"].split(' ').next().unwrap();
            methods.entry(first).or_default().insert(&row["student"]);
        }
    }
    let told = graded.rows("grades/tables/methods.csv");
    assert_eq!(told.len(), methods.len());
    for row in told {
        let students = &methods[row["method"].as_str()];
        assert_eq!(row["students"], students.len().to_string(), "{row:?}");
    }
    let book = graded.text("grades/gradebook-canvas.csv");
    let mut lines = book.lines();
    assert_eq!(lines.next().unwrap(), "Student,ID,SIS User ID,SIS Login ID,Section,wheels-on-inclines");
    assert!(lines.next().unwrap().starts_with("Points Possible,,,,,"));
    for (row, name) in [("gradebook-canvas.csv", "SIS User ID"), ("gradebook-moodle.csv", "ID number")] {
        let rows = graded.rows(&format!("grades/{row}"));
        let mut seen = 0;
        for row in rows.iter().filter(|r| r[name].starts_with('s')) {
            seen += 1;
            let mine = points.get(&row[name]);
            let given = &row["wheels-on-inclines"];
            match mine {
                Some(points) => assert!((number(given) - points).abs() < 1e-9, "{row:?}"),
                None => assert!(given.is_empty() || given == "-", "{row:?}"),
            }
        }
        assert_eq!(seen, graded.keys.len());
    }
    // A cell that a spreadsheet would run.
    for name in ["gradebook-canvas.csv", "gradebook-moodle.csv"] {
        let text = graded.text(&format!("grades/{name}"));
        assert!(text.contains("'=SUM(A1)") && !text.contains(",=") && !text.contains("\n="), "{name}");
    }
}

/// Numbers of a text as they are written.
fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+' | 'e' | '\u{2212}')))
        .filter_map(|t| t.replace(',', ".").trim_end_matches('.').parse().ok())
        .filter(|x: &f64| x.is_finite())
        .collect()
}

/// No feedback has a number within the tolerance of a key of that student whose part is not right, but what the student wrote, or
/// a small whole number (points, parts of names).
fn tells_no_key(graded: &Graded, folder: &Path) {
    let answers = graded.rows("grades/answers.csv");
    let mut compared = 0;
    for sheet in &graded.keys {
        let text = fs::read_to_string(folder.join(format!("{}.md", sheet.student))).unwrap();
        let mine: Vec<_> = answers.iter().filter(|r| r["student"] == sheet.student).collect();
        let wrote: Vec<f64> = mine.iter().flat_map(|r| numbers(&r["answer"])).collect();
        for (i, problem) in sheet.problems.iter().enumerate() {
            for entry in &problem.parts {
                let Answer::Number { value, half_width, .. } = entry.answer else { continue };
                let right = mine.iter().any(|r| {
                    r["problem"] == (i + 1).to_string() && r["part"] == entry.part && r["verdict"] == "right"
                });
                if right {
                    continue;
                }
                let key = entry.unit.from_si(value).abs();
                let width = entry.unit.from_si(half_width).abs();
                compared += 1;
                for x in numbers(&text) {
                    let plain = x.fract() == 0.0 && x.abs() < 100.0;
                    let own = wrote.iter().any(|w| (w - x).abs() < 1e-9 * w.abs().max(1e-9));
                    let half = (x * 2.0).fract() == 0.0 && x.abs() < 10.0;
                    assert!(
                        plain || own || half || (x.abs() - key).abs() > width,
                        "{} of {} in {}: {x}",
                        entry.part,
                        key,
                        sheet.student
                    );
                }
            }
        }
        for other in graded.keys.iter().filter(|k| k.student != sheet.student) {
            assert!(!text.contains(&other.student), "{} is named in {}", other.student, sheet.student);
        }
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn a_class_of_sixty() {
    let graded = class(60, "kinetic-energy,pulled-rolling", "hints: explain\ncourse: Mechanics\n");
    let told = graded.report(&["--threads", "2"]);
    assert!(told.contains("of 60 students") && told.contains("favourite mistake"), "{told}");
    recounted(&graded);
    let page = graded.text("grades/report.html");
    let parsed = valid(&page, "en");
    let select = |css: &str| Selector::parse(css).unwrap();
    assert!(parsed.select(&select("figure > svg")).count() >= 6);
    assert_eq!(parsed.select(&select("table > caption")).count(), parsed.select(&select("table")).count());
    assert!(page.contains("Cronbach") && page.contains("Hints to students") && page.contains("explain"));
    assert!(!page.contains("<script") && page.contains("&lt;script&gt;"));
    // It begins with who got what, as the gradebook has it, and ends with the settings.
    let sections = page.split("<section id=\"").skip(1).map(|s| s.split_once("\">").unwrap());
    let sections: Vec<(&str, &str)> = sections.collect();
    let names: Vec<&str> = sections.iter().map(|(id, _)| *id).collect();
    assert_eq!((&names[..3], names.last()), (&["marks", "weakest", "lecture"][..], Some(&"graded")));
    for (row, line) in graded.rows("grades/gradebook.csv").iter().zip(sections[0].1.split("<tr>").skip(2)) {
        let cells = Html::parse_fragment(&format!("<table><tr>{line}</table>"));
        let cells: Vec<String> = cells.select(&select("th, td")).map(|c| c.text().collect()).collect();
        // The CSV file keeps a spreadsheet from running a name.
        let name = row["name"].trim_start_matches('\'');
        assert_eq!((&cells[0], cells[1].as_str()), (&row["student"], name));
        assert_eq!(cells.last(), Some(&row["max_total"]));
        assert_eq!(cells[cells.len() - 2], row["total"], "{line}");
    }
    // The three parts with the least share of their points.
    let mut parts = graded.rows("grades/tables/parts.csv");
    parts.sort_by(|a, b| number(&a["ease"]).total_cmp(&number(&b["ease"])));
    let weak: Vec<&str> =
        sections[1].1.split("<li><p><strong>").skip(1).map(|w| w.split('<').next().unwrap()).collect();
    assert_eq!(weak, parts.iter().take(3).map(|p| p["part"].as_str()).collect::<Vec<_>>());
    // A method's id never stands without its words, and what tells nothing is folded.
    for cell in parsed.select(&select("#mistakes td, .mistakes p")) {
        let text: String = cell.text().collect();
        let alone = |id: &str| text.trim() == id;
        assert!(!Catalogue::shared("en").entries().iter().any(|e| alone(&e.id)), "{text}");
    }
    let folded = parsed.select(&select("#fairness details figure")).count();
    assert_eq!(folded == 0, page.contains("these stand out:"), "{folded}");
    // No student is named elsewhere but where answers match those of classmates.
    for (id, told) in sections.iter().filter(|(id, _)| !["marks", "matches"].contains(id)) {
        assert!(!told.contains("s0001") && !told.contains("Amina") && !told.contains("Zoë"), "{id}");
    }
    let folder = graded.path("grades/feedback");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 120);
    tells_no_key(&graded, &folder);
    for sheet in &graded.keys {
        let page = fs::read_to_string(folder.join(format!("{}.html", sheet.student))).unwrap();
        valid(&page, "en");
        assert!(!page.contains("<b>Zoë"));
    }
    // The same bytes with another number of threads; nothing is replaced unless it is asked for.
    let said = run(&["report", &graded.path("grades").display().to_string()], Exit::Faulty);
    assert!(said.contains("holds a report already"), "{said}");
    let other = graded.path("other").display().to_string();
    graded.report(&["--threads", "1", "--out", &other]);
    for name in ["report.html", "feedback/s0003.html", "tables/methods.csv"] {
        assert_eq!(graded.text(&format!("grades/{name}")), graded.text(&format!("other/{name}")), "{name}");
    }
    graded.report(&["--force"]);
    assert_eq!(graded.text("grades/report.html"), page);

    own_templates(&graded);
    hint_levels(&graded, &folder);
    german(&graded);
}

/// none says nothing of methods, nudge the hint alone, explain all three.
fn hint_levels(graded: &Graded, explained: &Path) {
    let catalogue = Catalogue::shared("en");
    let answers = graded.rows("grades/answers.csv");
    let mistaken = answers
        .iter()
        .find(|r| r["verdict"] == "wrong" && !r["methods"].is_empty() && !r["methods"].contains(' '))
        .expect("somebody took a wrong method");
    let entry = catalogue.get(&mistaken["methods"]).unwrap();
    let name = format!("{}.md", mistaken["student"]);
    let squeezed = |t: &str| t.split_whitespace().collect::<Vec<_>>().join(" ");
    let levels = |folder: &Path| {
        let text = squeezed(&fs::read_to_string(folder.join(&name)).unwrap());
        [&entry.hint, &entry.did, &entry.see].map(|t| text.contains(&squeezed(t)))
    };
    assert_eq!(levels(explained), [true; 3]);
    for (level, told) in [("none", [false; 3]), ("nudge", [true, false, false])] {
        fs::write(graded.path("grades/basis/course.yaml"), format!("hints: {level}\n")).unwrap();
        let out = graded.path(level);
        graded.report(&["--out", &out.display().to_string()]);
        assert_eq!(levels(&out.join("feedback")), told, "{level}");
        tells_no_key(graded, &out.join("feedback"));
    }
    let ids: Vec<&str> = catalogue.entries().iter().map(|e| e.id.as_str()).collect();
    for file in fs::read_dir(explained).unwrap() {
        let text = fs::read_to_string(file.unwrap().path()).unwrap();
        let words: BTreeSet<&str> = text.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        assert!(ids.iter().all(|id| !words.contains(id)), "an id of the catalogue is told");
    }
}

fn german(graded: &Graded) {
    let out = graded.path("deutsch");
    graded.report(&["--language", "de", "--out", &out.display().to_string()]);
    let text = fs::read_to_string(out.join("feedback/s0001.md")).unwrap();
    assert!(text.contains("Punkten") && text.contains("Kennung s0001"), "{text}");
    assert!(!text.contains("points") && !text.contains("you wrote"), "{text}");
    valid(&fs::read_to_string(out.join("feedback/s0002.html")).unwrap(), "de");
    let book = fs::read_to_string(out.join("gradebook-moodle.csv")).unwrap();
    assert!(book.contains(" richtig ") && !book.contains(" right ") && !book.contains("no answer"));
}

/// The texts of a page, one for each element that holds one.
fn texts(page: &Html) -> Vec<String> {
    let nodes = page.root_element().descendants().filter(|node| {
        let element = node.parent().and_then(|p| p.value().as_element().map(|e| e.name().to_owned()));
        !element.is_some_and(|name| ["style", "code", "annotation"].contains(&name.as_str()))
    });
    let texts = nodes.filter_map(|node| node.value().as_text().map(|text| text.trim().to_owned()));
    texts.filter(|text| !text.is_empty()).collect()
}

/// A class graded in German gets a German report: no text of it is an English phrase or holds the words of one.
#[test]
fn a_german_report_is_german() {
    let course = "due: 2026-03-01 13:00\nattempts: {penalty: 25 %, at most: 3}\nlate: {penalty: 20 %, grace: 10 min}\ndrop lowest: 1\nround: {to: 0.5}\nhints: explain\ncorrections: [{part: 1.x_G, give: full, why: sorry}]\n";
    let (english, german) = (Words::english(), Words::of("de").unwrap());
    let names = || english.names().into_iter().filter(|name| name.starts_with("report."));
    let same: Vec<&str> =
        names().filter(|n| english.get(n) == german.get(n)).map(|n| english.get(n)).collect();
    for students in [60, 5, 0] {
        let graded = class(students.max(2), "kinetic-energy,pulled-rolling", course);
        if students == 0 {
            fs::write(graded.path("submissions.csv"), "student,problem,part,answer\n").unwrap();
        }
        grade(&graded.room, "submissions.csv", &["--force", "--language", "de"]);
        graded.report(&[]);
        let page = valid(&graded.text("grades/report.html"), "de");
        let texts = texts(&page);
        let matched = graded.text("grades/matches.csv");
        for name in names() {
            let phrase = english.get(name);
            assert!(same.contains(&phrase) || !texts.iter().any(|text| text == phrase), "{name}: {phrase}");
            let pieces = phrase.split('{').enumerate().map(|(i, piece)| match i {
                0 => piece,
                _ => piece.split_once('}').map_or(piece, |(_, after)| after),
            });
            for piece in pieces.map(str::trim).filter(|p| p.split(' ').count() > 2) {
                assert!(!texts.iter().any(|text| text.contains(piece)), "{name}: {piece}");
            }
        }
        for (i, text) in texts.iter().enumerate() {
            assert!(!text.contains('{') || text.starts_with("<!"), "a place is not filled: {i} {text}");
            // Answers stand as they were handed in; a number may end a sentence or be an ordinal.
            let has_point =
                |word: &str| word.trim_end_matches('.').contains('.') && word.parse::<f64>().is_ok();
            let point = text.split(' ').any(has_point) && !matched.contains(text.as_str());
            assert!(!point, "a number with a point: {text}");
        }
    }
}

/// Every phrase of the report is used by its template or by the program.
#[test]
fn every_phrase_of_the_report_is_used() {
    fn read(folder: &Path, out: &mut String) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                read(&path, out);
            } else if path.extension().is_some_and(|e| e == "rs") {
                out.push_str(&fs::read_to_string(&path).unwrap());
            }
        }
    }
    let mut code = String::new();
    for folder in ["report", "folder", "cli", "policy", "grade"] {
        read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(folder), &mut code);
    }
    // Verdicts are written with blanks.
    let code: BTreeSet<String> = (code.split(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | ' ')))
        .flat_map(|text| text.split(' ').map(str::to_owned).chain([text.replace(' ', "_")]))
        .collect();
    let templates = slipstick::template::built_in("en").filter(|(name, _)| name.starts_with("report"));
    let template: String = templates.map(|(_, text)| text).collect();
    let english = Words::english();
    let is_used = |name: &str| {
        let last = name.rsplit('.').next().unwrap();
        template.contains(&format!("words.{name} "))
            || code.contains(last)
            || last.strip_suffix("_one").is_some_and(|stem| code.contains(stem))
            || (name.starts_with("section.") && template.contains(&format!("\"{last}\"")))
    };
    let all = english.names();
    let names = all.iter().filter_map(|name| name.strip_prefix("report."));
    let unused: Vec<&str> = names.filter(|name| !is_used(name)).collect();
    assert!(unused.is_empty(), "{unused:?}");
    assert!(!is_used("lecture.no_such_phrase"));
}

/// The templates of the report are written out, do the same when they are given back, may be changed, and are told when broken.
fn own_templates(graded: &Graded) {
    let own = graded.path("own");
    let folder = own.display().to_string();
    run(&["templates", "--out", &folder], Exit::Fine);
    graded.report(&["--templates", &folder, "--out", &graded.path("same").display().to_string()]);
    assert_eq!(graded.text("same/report.html"), graded.text("grades/report.html"));
    let page = fs::read_to_string(own.join("report.html")).unwrap();
    let with = |from: &str, to: &str| {
        assert!(page.contains(from));
        fs::write(own.join("report.html"), page.replace(from, to)).unwrap();
    };
    with("<h1>{{ title }}</h1>", "<h1>{{ title }}</h1>\n<p>Office hours on Monday</p>");
    fs::write(own.join("words/report.yaml"), "skip: To the <main> things\n").unwrap();
    graded.report(&["--templates", &folder, "--out", &graded.path("changed").display().to_string()]);
    let changed = graded.text("changed/report.html");
    assert!(changed.contains("Office hours on Monday") && changed.contains("To the &lt;main&gt; things"));
    let grades = graded.path("grades").display().to_string();
    let broken = graded.path("broken").display().to_string();
    for (to, said) in [
        ("<h1>{{ titel }}</h1>", "undefined"),
        ("<h1>{{ title</h1>", "template"),
        ("<h1>{{ words.of | fill(n=1) }}</h1>", "nothing fills the place {of}"),
    ] {
        with("<h1>{{ title }}</h1>", to);
        let told = run(&["report", &grades, "--templates", &folder, "--out", &broken], Exit::Faulty);
        let line = 1 + page[..page.find("<h1>{{ title }}").unwrap()].matches('\n').count();
        assert!(told.contains(said) && told.contains(&format!("report.html:{line}:")), "{told}");
        assert!(!graded.path("broken").exists());
    }
}

#[test]
fn a_class_of_five_gets_no_statistics_that_mean_nothing() {
    let graded = class(5, "kinetic-energy", "");
    graded.report(&[]);
    recounted(&graded);
    let page = graded.text("grades/report.html");
    valid(&page, "en");
    assert!(page.contains("alpha is not given") && page.contains("too few"), "{page}");
    assert!(page.contains("Discrimination is not given") && page.contains("fewer than 20 students"));
    assert!(graded.rows("grades/tables/parts.csv").iter().all(|r| r["discrimination"].is_empty()));
    assert!(!graded.path("grades/tables/fairness.csv").exists());
    // `grade` makes the same by itself.
    let path = |name: &str| graded.path(name).display().to_string();
    run(&["grade", &path("set"), &path("submissions.csv"), "--out", &path("alone")], Exit::Fine);
    for name in ["feedback/s0002.html", "tables/parts.csv", "gradebook-canvas.csv", "gradebook-moodle.csv"] {
        assert_eq!(graded.text(&format!("alone/{name}")), graded.text(&format!("grades/{name}")), "{name}");
    }
    assert!(graded.path("alone/report.html").exists());
}

/// A course with everything: what a student reads of it, and totals that are those of the gradebook.
#[test]
fn feedback_tells_what_lateness_attempts_and_corrections_did() {
    let course = "due: 2026-03-01 13:00\nattempts: {penalty: 25 %}\nlate: {penalty: 20 %, per: once}\ndrop lowest: 1\nround: {to: 0.5}\ncorrections: [{part: 1.x_G, give: full, why: the figure was wrong; sorry}]\n";
    let graded = class(12, "kinetic-energy,pulled-rolling", course);
    graded.report(&[]);
    let mut told = [0; 5];
    let words = [
        "Late: 80 % of the points.",
        "A further attempt: 75 % of the points.",
        "Points given by a correction: the figure was wrong; sorry.",
        "does not count",
        "for everybody",
    ];
    let book = graded.rows("grades/gradebook.csv");
    for row in &book {
        let text = graded.text(&format!("grades/feedback/{}.md", row["student"]));
        for (n, word) in told.iter_mut().zip(words) {
            *n += text.matches(word).count();
        }
        let total = format!("**{} of {} points**", row["total"], row["max_total"]);
        assert!(text.contains(&total), "{total}\n{text}");
        assert!(text.contains(&format!("problem {} does not count", row["dropped"])), "{text}");
    }
    assert!(told[..4].iter().all(|n| *n > 0) && told[4] == 0, "{told:?}");
    for row in graded.rows("grades/gradebook-moodle.csv") {
        let mine = book.iter().find(|r| r["student"] == row["ID number"]).unwrap();
        // Not everybody can get the same number of points, as different problems are dropped.
        let share = 100.0 * number(&mine["total"]) / number(&mine["max_total"]);
        assert!((number(&row["wheels-on-inclines %"]) - share).abs() <= 0.005 + 1e-9, "{row:?}");
    }
    assert!(graded.text("grades/gradebook-canvas.csv").contains("\nPoints Possible,,,,,100\n"));
    let page = graded.text("grades/report.html");
    valid(&page, "en");
    for said in ["2026-03-01 13:00 (UTC)", "the figure was wrong; sorry", "the weakest problem", "SHA-256"] {
        assert!(page.contains(said), "{said}");
    }
    let late = graded.rows("grades/tables/credit.csv");
    assert!(late.iter().any(|r| r["credit"] == "late" && number(&r["answers"]) > 0.0), "{late:?}");
}

#[test]
fn a_class_of_five_hundred() {
    let graded = class(500, "kinetic-energy", "");
    graded.report(&[]);
    recounted(&graded);
    valid(&graded.text("grades/report.html"), "en");
    let items = graded.rows("grades/tables/parts.csv");
    assert!(items.iter().all(|r| number(&r["discrimination"]).abs() <= 1.0));
    // Variants were drawn by lot and nobody looked at the data: fair, at the level of 5 %.
    let fairness = graded.rows("grades/tables/fairness.csv");
    assert!(fairness.iter().all(|r| number(&r["p_holm"]) > 0.05), "{fairness:?}");
    // When all are right for heavy particles alone, it is noticed.
    let stored = graded.text("grades/basis/set.json");
    let set = StoredSet::parse(&stored).unwrap();
    let mut lines = String::from("student,problem,part,answer\n");
    for (student, sheet) in set.students.iter().zip(&graded.keys) {
        let mass = numbers(student.problems[0].data["m_A"].as_str().unwrap())[0];
        for entry in &sheet.problems[0].parts {
            let answer = match &entry.answer {
                Answer::Number { value, .. } if mass > 3.5 => shown(entry, *value),
                _ => "1".to_owned(),
            };
            let _ = writeln!(lines, "{},1,{},{answer}", student.student, entry.part);
        }
    }
    fs::write(graded.path("unfair.csv"), lines).unwrap();
    grade(&graded.room, "unfair.csv", &["--force"]);
    let told = graded.report(&["--force"]);
    assert!(told.contains("fairness"), "{told}");
    let fairness = graded.rows("grades/tables/fairness.csv");
    let mass = fairness.iter().find(|r| r["datum"] == "m_A").unwrap();
    assert!(number(&mass["p_holm"]) < 1e-6 && number(&mass["spearman"]) > 0.5, "{mass:?}");
}

#[test]
fn a_folder_that_is_no_grading_is_told_so() {
    let room = tempfile::tempdir().unwrap();
    let path = room.path().display().to_string();
    let said = run(&["report", &path], Exit::Faulty);
    assert!(said.contains("basis/set.json") && said.contains("slipstick grade"), "{said}");
    let said = run(&["report", &format!("{path}/none")], Exit::Faulty);
    assert!(said.contains("no such folder"), "{said}");
    assert_eq!(fs::read_dir(room.path()).unwrap().count(), 0, "nothing is left behind");
}
