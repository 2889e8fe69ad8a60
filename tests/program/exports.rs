//! What is uploaded to a learning platform: a reader of XML finds in it what the set holds, and a player of QTI 3 scores it so.
use crate::support;
use crate::support::program::{self, Ran, has_pandoc, run, tree};
use crate::support::xml::{self, Node};
use base64::prelude::{BASE64_STANDARD, Engine as _};
use slipstick::answer::word;
use slipstick::cli::tell::Exit;
use slipstick::export::moodle;
use slipstick::units::Unit;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder for a test, and its paths as text.
struct Room(tempfile::TempDir);

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        fs::write(room.path("roster.csv"), "student,name\n0017,Amina Yusuf\n0023,Anders Ødegård\n").unwrap();
        room
    }
    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
    fn at(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }
    fn run(&self, args: &[&str]) -> Ran {
        run(args)
    }
    fn fine(&self, args: &[&str]) -> String {
        let ran = run(args);
        assert_eq!(ran.exit, Exit::Fine, "{args:?}: {}", ran.err);
        ran.out
    }
    /// What is said where the command is refused.
    fn refused(&self, args: &[&str]) -> String {
        let ran = run(args);
        assert_eq!(ran.exit, Exit::Faulty, "{args:?}: {}", ran.out);
        ran.err.replace(&self.0.path().display().to_string(), "ROOM")
    }
    fn set(&self, bank: &str, language: &str) -> Set {
        let name = format!("{}-{language}", Path::new(bank).file_stem().unwrap().to_string_lossy());
        let (roster, out) = (self.at("roster.csv"), self.at(&name));
        let more = ["--seed", "7", "--language", language, "--format", "md", "--out", &out];
        self.fine(&[&["generate", bank, "--roster", &roster], &more[..]].concat());
        Set::read(self.path(&name))
    }
    /// An export of a set, its file.
    fn export(&self, set: &Set, format: &str, more: &[&str]) -> Vec<u8> {
        let out = self.at(&format!("{format}.out"));
        let folder = set.folder.display().to_string();
        self.fine(&[&["export", &folder, "--format", format, "--out", &out, "--force"], more].concat());
        fs::read(out).unwrap()
    }
}

/// One part of a variant as key.csv and the sheets have it.
#[derive(Debug, Clone)]
struct Part {
    id: String,
    value: String,
    unit: String,
    tolerance: Option<f64>,
    points: f64,
    /// The words that the sheet offers.
    offered: Vec<String>,
}

/// One variant of a problem.
#[derive(Debug, Clone)]
struct OneVariant {
    problem: usize,
    title: String,
    code: String,
    parts: Vec<Part>,
    /// The statement as Markdown.
    statement: String,
    figure: Option<String>,
}

/// A set on disk.
struct Set {
    folder: PathBuf,
    variants: Vec<OneVariant>,
}

impl Set {
    fn read(folder: PathBuf) -> Self {
        let mut variants: Vec<OneVariant> = Vec::new();
        let mut reader = csv::Reader::from_path(folder.join("key.csv")).unwrap();
        let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let mut last = String::new();
        for row in reader.records().map(Result::unwrap) {
            let cell =
                |name: &str| row.get(header.iter().position(|h| h == name).unwrap()).unwrap().to_owned();
            let (student, problem): (String, usize) = (cell("student"), cell("problem").parse().unwrap());
            let own = folder.join("students").join(&student);
            let sheet: serde_json::Value =
                serde_json::from_str(&fs::read_to_string(own.join("sheet.json")).unwrap()).unwrap();
            let one = &sheet["problems"][problem - 1];
            let asked = one["parts"].as_array().unwrap().iter().find(|p| p["id"] == cell("part")).unwrap();
            if last != format!("{student} {problem}") {
                last = format!("{student} {problem}");
                let markdown = fs::read_to_string(own.join("sheet.md")).unwrap();
                let text = markdown.split("\n## ").nth(problem).unwrap();
                variants.push(OneVariant {
                    problem,
                    title: text.lines().next().unwrap().split_once(". ").unwrap().1.to_owned(),
                    code: cell("code"),
                    parts: Vec::new(),
                    statement: text.lines().skip(1).collect::<Vec<_>>().join("\n"),
                    figure: fs::read_to_string(own.join(format!("problem-{problem}.svg"))).ok(),
                });
            }
            let ask = format!("`{problem}.{}`", cell("part"));
            let line =
                variants.last().unwrap().statement.lines().find(|l| l.contains(&ask)).unwrap().to_owned();
            let offered = line.split_once(&ask).unwrap().1.split('`').skip(1).step_by(2).map(str::to_owned);
            let part = Part {
                id: cell("part"),
                value: cell("value"),
                unit: cell("unit"),
                tolerance: cell("tolerance").parse().ok(),
                points: asked["points"].as_f64().unwrap(),
                offered: offered.collect(),
            };
            variants.last_mut().unwrap().parts.push(part);
        }
        Self { folder, variants }
    }

    /// Of a pool, which has no sheets: for each code value and unit of its parts.
    fn read_key(folder: PathBuf) -> BTreeMap<String, Vec<(String, String)>> {
        let mut found: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
        for row in csv::Reader::from_path(folder.join("key.csv")).unwrap().records().map(Result::unwrap) {
            let code = row.get(row.len() - 1).unwrap().to_owned();
            found.entry(code).or_default().push((row[3].to_owned(), row[4].to_owned()));
        }
        found
    }

    fn of(&self, code: &str) -> &OneVariant {
        self.variants.iter().find(|v| v.code == code).unwrap_or_else(|| panic!("no variant {code}"))
    }
}

/// Files of an archive of ours, by their names; none has a time of its own.
fn unpacked(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    for i in 0..archive.len() {
        let time = archive.by_index(i).unwrap().last_modified().unwrap();
        assert_eq!((time.year(), time.month(), time.day(), time.hour()), (1980, 1, 1, 0));
    }
    unzipped(bytes)
}

/// Files of an archive, by their names.
fn unzipped(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    let mut files = BTreeMap::new();
    for i in 0..archive.len() {
        let mut file = archive.by_index(i).unwrap();
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).unwrap();
        files.insert(file.name().unwrap().into_owned(), bytes);
    }
    files
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// Is the statement of a variant in this text: all its words, its formulas as MathML, the figure under this address with what
/// it shows, and the code?
fn holds_statement(variant: &OneVariant, body: &Node, only: Option<&str>, figure: &dyn Fn(&str) -> String) {
    let seen: String = body.text.split_whitespace().collect::<Vec<_>>().join(" ");
    let before_questions: Vec<&str> = variant.statement.split("\n**").next().unwrap().lines().collect();
    for line in before_questions.into_iter().filter(|l| !l.starts_with(['!', '|'])) {
        for words in line.split('$').step_by(2) {
            let words = words.replace(['*', '\\', '`'], "");
            let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(seen.contains(&words), "{}: {words:?} is not in {seen}", variant.code);
        }
    }
    assert!(body.all("math").len() > 3, "{}: no formulas", variant.code);
    assert!(seen.contains(&variant.code), "{}: its code is not in {seen}", variant.code);
    for part in &variant.parts {
        let asked = seen.contains(&format!("{}.{},", variant.problem, part.id));
        assert_eq!(asked, only.is_none_or(|only| only == part.id), "{} {}", variant.code, part.id);
    }
    let images = body.all("img");
    assert_eq!(images.len(), usize::from(variant.figure.is_some()), "{}", variant.code);
    if let Some(svg) = &variant.figure {
        assert_eq!(figure(images[0].get("src")), *svg, "{}", variant.code);
        let shown = xml::read(svg);
        assert_eq!(images[0].get("alt"), shown.one("desc").text, "{}", variant.code);
        assert!(images[0].get("alt").len() > 40);
    }
}

/// Fields of a cloze question by Moodle's grammar: weight, kind, answers. What is no field has no brace.
fn fields(html: &str) -> Vec<(f64, String, Vec<String>)> {
    let mut found = Vec::new();
    let mut rest = html;
    while let Some(at) = rest.find('{') {
        assert!(!rest[..at].contains('}'), "a brace that closes nothing");
        let inside = &rest[at + 1..];
        let (mut end, mut escaped) = (0, false);
        for (i, c) in inside.char_indices() {
            if c == '}' && !escaped {
                end = i;
                break;
            }
            escaped = c == '\\' && !escaped;
        }
        let (weight, more) = inside[..end].split_once(':').unwrap();
        let (kind, answers) = more.split_once(':').unwrap();
        let answers = answers.split('~').map(|a| a.strip_prefix('=').unwrap().replace('\\', ""));
        found.push((weight.parse().unwrap(), kind.to_owned(), answers.collect()));
        rest = &inside[end + 1..];
    }
    assert!(!rest.contains('}'));
    found
}

fn moodle_figure<'n>(question: &'n Node) -> impl Fn(&str) -> String + 'n {
    move |src| {
        let name = src.strip_prefix("@@PLUGINFILE@@/").unwrap();
        let file =
            question.one("questiontext").all("file").into_iter().find(|f| f.get("name") == name).unwrap();
        String::from_utf8(BASE64_STANDARD.decode(&file.text).unwrap()).unwrap()
    }
}

/// Each category of Moodle XML with its questions.
fn categories(quiz: &Node) -> Vec<(String, Vec<&Node>)> {
    let mut found: Vec<(String, Vec<&Node>)> = Vec::new();
    for question in &quiz.children {
        assert_eq!(question.name, "question");
        match question.get("type") {
            "category" => {
                assert!(!question.one("info").one("text").text.is_empty());
                assert!(!question.one("idnumber").text.is_empty());
                found.push((question.one("category").one("text").text.clone(), Vec::new()));
            }
            _ => found.last_mut().unwrap().1.push(question),
        }
    }
    found
}

fn check_moodle(set: &Set, bytes: &[u8], bank: &str) {
    let quiz = xml::read(text(bytes));
    let categories = categories(&quiz);
    let mut seen = BTreeSet::new();
    for (path, questions) in &categories {
        for question in questions {
            let variant = set.of(&question.one("name").one("text").text);
            assert_eq!(*path, format!("$course$/top/{bank}/{}. {}", variant.problem, variant.title));
            assert!(seen.insert(variant.code.clone()));
            let html = &question.one("questiontext").one("text").text;
            let figure = moodle_figure(question);
            holds_statement(variant, &xml::html(html), None, &figure);
            let fields = fields(html);
            assert_eq!(fields.len(), variant.parts.len());
            for (part, (weight, kind, answers)) in variant.parts.iter().zip(fields) {
                assert_eq!(weight, part.points);
                match part.tolerance {
                    Some(tolerance) => {
                        assert_eq!(kind, "NUMERICAL");
                        assert_eq!(answers, [format!("{}:{}", part.value, moodle_number(tolerance))]);
                    }
                    None => {
                        assert_eq!(kind, "SHORTANSWER");
                        let all = word::spellings(known(&part.value));
                        // The first is what Moodle shows as the right answer: the word of the sheet.
                        assert!(part.offered.contains(&answers[0]), "{answers:?}");
                        assert!(part.value != "up" || all.contains(&"nach oben"));
                        assert!(all.len() > 3 && answers.len() == all.len());
                        assert!(all.iter().all(|word| answers.iter().any(|answer| answer == word)));
                    }
                }
            }
        }
    }
    assert_eq!(seen.len(), set.variants.len());
    // A pool of 200 variants of a problem stays below the 3 MB that a slow upload bears.
    for (_, questions) in &categories {
        let share = bytes.len() * questions.len() / set.variants.len();
        assert!(200 * share / questions.len() < 3_000_000, "{bank}: {share} bytes");
    }
}

/// A word of a key.
fn known(word: &str) -> &'static str {
    ["up", "down", "forward", "back", "stays", "yes", "no"].into_iter().find(|w| *w == word).unwrap()
}

fn moodle_number(x: f64) -> String {
    slipstick::set::key_file::shortest(x)
}

fn check_canvas(set: &Set, bytes: &[u8]) {
    let files = unpacked(bytes);
    let manifest = xml::read(text(&files["imsmanifest.xml"]));
    let listed: BTreeSet<String> = manifest.all("file").iter().map(|f| f.get("href").to_owned()).collect();
    let there: BTreeSet<String> = files.keys().filter(|n| *n != "imsmanifest.xml").cloned().collect();
    assert_eq!(listed, there);
    let main = manifest.all("resource").into_iter().find(|r| r.get("type") == "imsqti_xmlv1p2").unwrap();
    let quiz = xml::read(text(&files[main.one("file").get("href")]));
    let figure = |src: &str| {
        let path = src.strip_prefix("%24IMS-CC-FILEBASE%24/").unwrap();
        String::from_utf8(files[path].clone()).unwrap()
    };
    let sections = quiz.one("section").all("section");
    let mut seen = 0;
    for section in sections {
        assert_eq!(section.one("selection_number").text, "1");
        let part_of = section.get("title").rsplit_once(": ").unwrap().1;
        for item in section.all("item") {
            seen += 1;
            let variant = set.of(item.get("title"));
            let part = variant.parts.iter().find(|p| p.id == part_of).unwrap();
            assert_eq!(section.one("points_per_item").number(), part.points);
            let html = xml::html(&item.one("mattext").text);
            holds_statement(variant, &html, Some(&part.id), &figure);
            // What is chosen is not typed.
            assert_eq!(html.text.contains("12.5"), part.tolerance.is_some());
            let about: Vec<String> = item.all("fieldentry").iter().map(|f| f.text.clone()).collect();
            assert_eq!(about[1].parse::<f64>().unwrap(), part.points);
            match part.tolerance {
                Some(tolerance) => {
                    assert_eq!(about[0], "numerical_question");
                    assert_eq!(item.one("varequal").text, part.value);
                    within(item.one("vargte").number(), item.one("varlte").number(), part, tolerance);
                }
                None => {
                    assert_eq!(about[0], "multiple_choice_question");
                    let labels = item.all("response_label");
                    let right = labels.iter().filter(|l| l.get("ident") == item.one("varequal").text);
                    assert_eq!(right.count(), 1);
                    assert_eq!(item.one("varequal").text, part.value);
                    let said: Vec<&str> = labels.iter().map(|l| l.text.as_str()).collect();
                    assert_eq!(said, part.offered);
                }
            }
        }
    }
    assert_eq!(seen, set.variants.iter().map(|v| v.parts.len()).sum::<usize>());
}

/// Do the bounds of a range lie at the tolerance from the key?
fn within(low: f64, high: f64, part: &Part, tolerance: f64) {
    let value: f64 = part.value.parse().unwrap();
    let near = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * value.abs().max(tolerance);
    assert!(near(low, value - tolerance) && near(high, value + tolerance), "{low} {high} {part:?}");
}

/// The same for both versions of QTI; `name` makes the name of an element of theirs from that in 2.1.
fn check_qti(set: &Set, bytes: &[u8], name: &dyn Fn(&str) -> String) {
    let files = unpacked(bytes);
    let manifest = xml::read(text(&files["imsmanifest.xml"]));
    let listed: BTreeSet<String> = manifest.all("file").iter().map(|f| f.get("href").to_owned()).collect();
    let there: BTreeSet<String> = files.keys().filter(|n| *n != "imsmanifest.xml").cloned().collect();
    assert_eq!(listed, there);
    let attribute = |n: &str| name(n).trim_start_matches("qti-").to_owned();
    let test = xml::read(text(&files["test.xml"]));
    let references = test.all(&name("assessmentItemRef"));
    assert_eq!(references.len(), set.variants.len());
    for section in test.all(&name("assessmentSection")) {
        assert_eq!(section.one(&name("selection")).get("select"), "1");
    }
    let figure = |src: &str| String::from_utf8(files[src.strip_prefix("../").unwrap()].clone()).unwrap();
    for reference in references {
        let source = text(&files[reference.get("href")]);
        // A player of QTI 3 scores a right answer 0 by it.
        assert!(!source.to_lowercase().contains("tolerance-mode") && !source.contains("toleranceMode"));
        let item = xml::read(source);
        assert_eq!(item.get("identifier"), reference.get("identifier"));
        let variant = set.of(item.get("identifier").rsplit_once('-').unwrap().1);
        assert_eq!(item.get("title"), format!("{} {}", variant.title, variant.code));
        let body = item.one(&name("itemBody"));
        holds_statement(variant, body, None, &figure);
        assert!(body.all("math").iter().all(|m| m.get("xmlns") == "http://www.w3.org/1998/Math/MathML"));
        let outcome = |id: &str| {
            let all = item.all(&name("outcomeDeclaration"));
            all.into_iter().find(|o| o.get("identifier") == id).unwrap().one(&name("value")).number()
        };
        assert_eq!(outcome("MAXSCORE"), variant.parts.iter().map(|p| p.points).sum::<f64>());
        assert_eq!(outcome("SCORE"), 0.0);
        let conditions = item.all(&name("responseCondition"));
        assert_eq!(conditions.len(), variant.parts.len());
        for (part, condition) in variant.parts.iter().zip(conditions) {
            assert_eq!(outcome(&format!("SCORE-{}", part.id)), 0.0);
            assert_eq!(condition.one(&name("variable")).get("identifier"), part.id);
            let counts = condition.one(&name("setOutcomeValue"));
            assert_eq!(counts.get("identifier"), format!("SCORE-{}", part.id));
            assert_eq!(counts.number(), part.points);
            let declared = item.all(&name("responseDeclaration"));
            let declared = declared.into_iter().find(|d| d.get("identifier") == part.id).unwrap();
            assert_eq!(declared.one(&name("value")).text, part.value);
            match part.tolerance {
                Some(tolerance) => {
                    assert_eq!(declared.get(&attribute("baseType")), "float");
                    let (low, high) = (condition.one(&name("gte")), condition.one(&name("lte")));
                    let bound = |n: &Node| n.one(&name("baseValue")).number();
                    within(bound(low), bound(high), part, tolerance);
                }
                None => {
                    let all = body.all(&name("inlineChoice"));
                    let said: Vec<&str> = all.iter().map(|c| c.text.as_str()).collect();
                    assert_eq!(said, part.offered);
                    assert_eq!(condition.one(&name("match")).one(&name("baseValue")).text, part.value);
                }
            }
        }
    }
}

fn in_qti3(name: &str) -> String {
    let kebab: String = name
        .chars()
        .flat_map(|c| c.is_ascii_uppercase().then_some('-').into_iter().chain([c.to_ascii_lowercase()]))
        .collect();
    format!("qti-{kebab}")
}

#[test]
fn every_export_holds_statement_figure_key_tolerance_and_points_of_the_set() {
    for language in ["en", "de"] {
        for bank in support::bank_names() {
            let room = Room::new();
            let set = room.set(bank, language);
            check_moodle(&set, &room.export(&set, "moodle", &[]), bank);
            check_canvas(&set, &room.export(&set, "canvas", &[]));
            check_qti(&set, &room.export(&set, "qti21", &[]), &str::to_owned);
            check_qti(&set, &room.export(&set, "qti3", &[]), &in_qti3);
        }
    }
}

#[test]
fn numerical_questions_take_units_that_come_to_the_same() {
    let room = Room::new();
    let set = room.set("wheels-on-inclines", "en");
    let quiz = room.export(&set, "moodle", &["--as", "numerical"]);
    let quiz = xml::read(text(&quiz));
    let (mut numbers, mut words) = (0, 0);
    for (path, questions) in categories(&quiz) {
        let of_part = path.rsplit_once('/').unwrap().1;
        for question in questions {
            let name = &question.one("name").one("text").text;
            let (code, id) = name.split_once(' ').unwrap();
            assert_eq!(id, of_part);
            let variant = set.of(code);
            let part = variant.parts.iter().find(|p| p.id == id).unwrap();
            let html = &question.one("questiontext").one("text").text;
            holds_statement(variant, &xml::html(html), Some(id), &moodle_figure(question));
            assert_eq!(question.one("defaultgrade").number(), part.points);
            let answers = question.all("answer");
            let Some(tolerance) = part.tolerance else {
                words += 1;
                assert_eq!(question.get("type"), "shortanswer");
                let all: Vec<&str> = answers.iter().map(|a| a.one("text").text.as_str()).collect();
                assert!(part.offered.iter().any(|said| said == all[0]), "{all:?}");
                assert_eq!(all.len(), word::spellings(known(&part.value)).len());
                continue;
            };
            numbers += 1;
            assert_eq!(question.get("type"), "numerical");
            assert_eq!(answers.len(), 1);
            assert_eq!(answers[0].one("text").text, part.value);
            assert_eq!(answers[0].one("tolerance").number(), tolerance);
            let asked = Unit::parse(&part.unit).unwrap();
            let units = question.all("unit");
            assert_eq!(question.one("showunits").text, if units.is_empty() { "3" } else { "0" });
            assert_eq!(units.is_empty(), asked.is_number());
            for (i, unit) in units.iter().enumerate() {
                let name = &unit.one("unit_name").text;
                // Moodle divides what was typed by the multiplier.
                // `grade` reads turns where a speed of turning is asked.
                let read = if name == "1/min" { "rpm" } else { name.as_str() };
                let typed = Unit::parse(read).unwrap_or_else(|e| panic!("{name}: {e:?}"));
                let by_units = asked.from_si(typed.to_si(1.0));
                let by_moodle = 1.0 / unit.one("multiplier").number();
                assert!((by_units - by_moodle).abs() < 1e-12 * by_units, "{name} for {}", part.unit);
                assert!(i > 0 || (name == &part.unit && by_moodle == 1.0));
            }
            let has = |name: &str| units.iter().any(|u| u.one("unit_name").text == name);
            let wanted: &[&str] = match part.unit.as_str() {
                "rad/s" => &["rpm", "U/min", "1/min", "r/min"],
                "m/s" => &["km/h"],
                "m" => &["cm"],
                "rad" => &["deg"],
                "N" => &["kN"],
                _ => &[],
            };
            assert!(wanted.iter().all(|name| has(name)), "{}", part.unit);
            let kmh = units.iter().find(|u| part.unit == "m/s" && u.one("unit_name").text == "km/h");
            assert!(kmh.is_none_or(|unit| unit.one("multiplier").text == "3.6"));
        }
    }
    assert!(numbers > 30 && words > 0, "{numbers} {words}");
}

#[test]
fn a_pool_is_drawn_with_the_set_that_grades_it_the_same_bytes_for_the_same_seed() {
    let room = Room::new();
    for (format, file) in
        [("moodle", "pool.xml"), ("canvas", "pool.zip"), ("qti21", "pool.zip"), ("qti3", "pool.zip")]
    {
        let pool = |folder: &str, seed: &str, threads: &str| {
            fs::create_dir_all(room.path(folder)).unwrap();
            let out = room.at(&format!("{folder}/{file}"));
            let ask = ["--variants", "5", "--seed", seed, "--format", format, "--out", &out];
            let more = ["--problems", "pulled-rolling", "--force", "--threads", threads];
            let told = room.fine(&[&["export", "wheels-on-inclines"], &ask[..], &more[..]].concat());
            assert!(told.contains("5 variants of 1 problem"), "{told}");
            assert!(told.contains("key.csv, by the code of each question"), "{told}");
            tree(&room.path(folder))
        };
        let (one, same, other) = (pool("one", "3", "1"), pool("same", "3", "2"), pool("other", "4", "2"));
        assert!(one == same, "{format}");
        assert!(one[file] != other[file], "{format}");
        let codes: BTreeSet<String> = text(&one["pool-set/key.csv"])
            .lines()
            .skip(1)
            .map(|line| line.rsplit(',').next().unwrap().to_owned())
            .collect();
        assert_eq!(codes.len(), 5);
        let bytes = match format {
            "moodle" => one[file].clone(),
            _ => unpacked(&one[file]).into_values().flatten().collect(),
        };
        let all = text(&bytes);
        assert!(codes.iter().all(|code| all.contains(code)), "{format}");
        room.fine(&["verify", &room.at("one/pool-set")]);
    }
}

/// What a student reads and types in each platform, as the platform tells it, comes back as an answer to the variant.
#[test]
fn answers_to_a_pool_are_graded_by_the_codes_that_its_questions_print() {
    let room = Room::new();
    let out = room.at("pool.xml");
    let pool = ["--variants", "4", "--seed", "3", "--problems", "spring-released", "--format"];
    room.fine(&[&["export", "wheels-on-inclines"], &pool[..], &["moodle", "--out", &out]].concat());
    let set = Set::read_key(room.path("pool-set"));
    let cell = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let quiz = xml::read(&fs::read_to_string(&out).unwrap());
    let questions = categories(&quiz).remove(0).1;
    let mut moodle = "Last name,First name,ID number,Status,Completed,Question 1,Response 1\n".to_owned();
    for (i, question) in questions.iter().enumerate() {
        let shown = xml::html(&question.one("questiontext").one("text").text).text;
        let variant = &set[&question.one("name").one("text").text];
        // The third of them types a decimal comma and a unit, which Moodle would not read.
        let typed = variant.iter().enumerate().map(|(p, (value, unit))| {
            let typed =
                if i == 2 && p > 0 { format!("{} {unit}", value.replace('.', ",")) } else { value.clone() };
            format!("part {}: {typed}", p + 1)
        });
        let typed = typed.collect::<Vec<_>>().join("; ");
        moodle.push_str(&format!(
            "B,A,{i},Finished,1 March 2026  9:40 AM,{},{}\n",
            cell(&shown),
            cell(&typed)
        ));
    }
    fs::write(room.path("responses.csv"), moodle).unwrap();
    let (folder, responses, grades) = (room.at("pool-set"), room.at("responses.csv"), room.at("grades"));
    let told = room.fine(&["grade", &folder, &responses, "--out", &grades]);
    let answers = questions.len() * set.values().next().unwrap().len();
    assert_eq!(answers, 4 * 6);
    assert!(told.starts_with(&format!("{answers} answer cells in long form: {answers} right")), "{told}");

    // Canvas asks each part by itself.
    let zip = room.at("pool.zip");
    room.fine(&["export", &folder, "--format", "canvas", "--out", &zip]);
    let files = unpacked(&fs::read(&zip).unwrap());
    let (_, quiz) = files.iter().find(|(n, _)| n.starts_with("quiz-") && !n.contains("meta")).unwrap();
    let quiz = xml::read(text(quiz));
    let mut header = "name,id,sis_id,section,section_id,section_sis_id,submitted,attempt".to_owned();
    let mut row = "A B,5001,S-1,P,31,p-1,2026-03-01 09:40:00 UTC,1".to_owned();
    let sections = quiz.one("section").all("section");
    for (i, section) in sections.iter().enumerate() {
        // Each part from another variant.
        let item = section.all("item")[i % 4];
        let shown = xml::html(&item.one("mattext").text).text;
        header.push_str(&format!(",{},1.0", cell(&format!("{}: {shown}", 700 + i))));
        row.push_str(&format!(",{},1.0", set[item.get("title")][i].0));
    }
    fs::write(&responses, format!("{header},n correct,n incorrect,score\n{row},6,0,6.0\n")).unwrap();
    let told = room.fine(&["grade", &folder, &responses, "--out", &room.at("canvas-grades")]);
    assert!(told.starts_with("6 answer cells in long form: 6 right"), "{told}");
}

/// Every formula of the built-in problems and their solutions is MathML 3, by the schema that Debian's python3-xsdata brings.
#[test]
fn formulas_are_valid_by_the_schema_of_mathml() {
    let Ok(schema) = std::env::var("SLIPSTICK_MATHML") else {
        println!("passed over: SLIPSTICK_MATHML names no schema");
        return;
    };
    let room = Room::new();
    let mut formulas = BTreeSet::new();
    for bank in support::bank_names() {
        let set = room.set(bank, "de");
        let files = unpacked(&room.export(&set, "qti3", &["--with-solutions"]));
        for bytes in files.iter().filter(|(n, _)| n.starts_with("items/")).map(|(_, bytes)| bytes) {
            let pieces = text(bytes).split("<math ").skip(1);
            formulas.extend(pieces.map(|p| format!("<math {}</math>", p.split("</math>").next().unwrap())));
        }
    }
    assert!(formulas.len() > 500, "{} formulas", formulas.len());
    let names: Vec<String> = (0..formulas.len()).map(|i| room.at(&format!("{i}.xml"))).collect();
    for (name, formula) in names.iter().zip(&formulas) {
        fs::write(name, formula).unwrap();
    }
    let args = ["--nonet", "--noout", "--schema", &schema];
    let done = Command::new("xmllint").args(args).args(&names).output().unwrap();
    let told = String::from_utf8_lossy(&done.stderr);
    let faults: Vec<&str> = told.lines().filter(|l| !l.ends_with(" validates")).take(5).collect();
    assert!(done.status.success() && faults.is_empty(), "{faults:?}");
    assert_eq!(told.lines().count(), formulas.len());
}

#[test]
fn worked_solutions_come_as_feedback_with_their_figures() {
    let room = Room::new();
    let set = room.set("hoists-and-pulleys", "en");
    let quiz = xml::read(text(&room.export(&set, "moodle", &["--with-solutions"]))).clone();
    for (_, questions) in categories(&quiz) {
        for question in questions {
            let feedback = question.one("generalfeedback");
            let html = xml::html(&feedback.one("text").text);
            assert!(html.all("strong").len() > 5);
            let shown: BTreeSet<String> = html.all("img").iter().map(|i| i.get("src").to_owned()).collect();
            let files = feedback.all("file");
            let there = files.iter().map(|f| format!("@@PLUGINFILE@@/{}", f.get("name"))).collect();
            assert!(!shown.is_empty());
            assert_eq!(shown, there);
        }
    }
    let without = room.export(&set, "moodle", &[]);
    assert!(xml::read(text(&without)).all("generalfeedback").iter().all(|f| f.text.is_empty()));
    let files = unpacked(&room.export(&set, "qti3", &["--with-solutions"]));
    for (_, bytes) in files.iter().filter(|(name, _)| name.starts_with("items/")) {
        let item = xml::read(text(bytes));
        let feedback = item.one("qti-modal-feedback");
        assert!(feedback.all("strong").len() > 5);
        assert!(
            feedback.all("img").iter().all(|i| files.contains_key(i.get("src").trim_start_matches("../")))
        );
        let set = item.all("qti-set-outcome-value");
        assert!(set.iter().any(|s| s.get("identifier") == feedback.get("outcome-identifier")));
    }
    let files = unpacked(&room.export(&set, "canvas", &["--with-solutions"]));
    let quiz =
        files.iter().find(|(n, _)| n.ends_with(".xml") && n.starts_with("quiz-") && !n.contains("meta"));
    let quiz = xml::read(text(quiz.unwrap().1));
    let mut explained = Vec::new();
    for item in quiz.all("item").into_iter().filter(|item| !item.all("itemfeedback").is_empty()) {
        assert_eq!(item.one("displayfeedback").get("linkrefid"), item.one("itemfeedback").get("ident"));
        assert!(xml::html(&item.one("itemfeedback").text).all("strong").len() > 5);
        explained.push(item.get("title").to_owned());
    }
    // Once for each variant.
    explained.sort();
    let mut codes: Vec<String> = set.variants.iter().map(|v| v.code.clone()).collect();
    codes.sort();
    assert_eq!(explained, codes);
}

/// Titles and questions that would end a section of data, a tag or a field of a cloze question, or act in a browser.
const HOSTILE: &str = "Q\"uo'te ]]> <script>alert(1)</script> & {1:NUMERICAL:=5:9} {=a~b#c} \\ / 🛞";

#[test]
fn hostile_titles_names_and_questions_come_through_whole() {
    let room = Room::new();
    let quoted = serde_json::json!(HOSTILE).to_string();
    // In a question, which is Markdown, a tag does not reach anybody.
    let questions = format!(
        "v: {{ask: {quoted}, unit: m/s, points: 0.5}}
kmh: {{ask: the same in other units, quantity: v, unit: km/h, points: 1.5}}"
    );
    let statement = "A block of mass {{ m }} slides {{ d }} with {{ g }}, $a^{2} > 0$. ".to_owned() + HOSTILE;
    let bank = program::sliding(&quoted, &questions, &statement);
    fs::write(room.path("blocks.yaml"), bank).unwrap();
    let roster = format!(
        "student,name\n{quoted},{quoted}\n",
        quoted = format!("\"{}\"", HOSTILE.replace('"', "\"\""))
    );
    fs::write(room.path("roster.csv"), roster).unwrap();
    let (bank, roster, out) = (room.at("blocks.yaml"), room.at("roster.csv"), room.at("set"));
    let make = ["--seed", "1", "--name", HOSTILE, "--format", "md", "--out", &out];
    room.fine(&[&["generate", &bank, "--roster", &roster], &make[..]].concat());
    let set = Set { folder: room.path("set"), variants: Vec::new() };
    let words = ["Q\"uo'te ]]>", "& {1:NUMERICAL:=5:9} {=a~b#c}", "🛞"];

    let file = room.export(&set, "moodle", &[]);
    let quiz = xml::read(text(&file));
    let categories = categories(&quiz);
    let slashed = HOSTILE.replace('/', "//");
    assert_eq!(categories[0].0, format!("$course$/top/{slashed}/1. {slashed}"));
    let html = &categories[0].1[0].one("questiontext").one("text").text;
    let found = fields(html);
    let weights: Vec<f64> = found.iter().map(|(weight, ..)| *weight).collect();
    assert_eq!(weights, [1.0, 3.0], "points 0.5 and 1.5");
    let page = xml::html(html);
    assert!(page.all("script").is_empty());
    // In the statement and in the question, the fields beside them.
    for words in words {
        assert!(page.text.matches(words).count() >= 2, "{words}: {}", page.text);
    }
    let file = room.export(&set, "moodle", &["--with-solutions"]);
    let feedback = &xml::read(text(&file)).one("generalfeedback").one("text").text.clone();
    let heading = xml::html(feedback).one("h2").text.clone();
    assert!(heading.contains("<script>alert(1)</script>"), "{heading}");
    // No name of a student is anybody's question.
    assert!(!text(&file).contains("Amina"));

    for (format, name) in [("qti21", &str::to_owned as &dyn Fn(&str) -> String), ("qti3", &in_qti3)] {
        let files = unpacked(&room.export(&set, format, &[]));
        let test = xml::read(text(&files["test.xml"]));
        assert_eq!(test.get("title"), HOSTILE);
        assert_eq!(test.one(&name("assessmentSection")).get("title"), format!("1. {HOSTILE}"));
        let (_, item) = files.iter().find(|(n, _)| n.starts_with("items/")).unwrap();
        let item = xml::read(text(item));
        assert!(item.get("title").starts_with(HOSTILE));
        assert!(item.all("script").is_empty());
        let body = item.one(&name("itemBody"));
        assert!(words.iter().all(|words| body.text.matches(words).count() >= 2));
    }
    let files = unpacked(&room.export(&set, "canvas", &[]));
    let (_, quiz) = files.iter().find(|(n, _)| n.starts_with("quiz-") && !n.contains("meta")).unwrap();
    let quiz = xml::read(text(quiz));
    assert_eq!(quiz.one("assessment").get("title"), HOSTILE);
    let page = xml::html(&quiz.one("item").one("mattext").text);
    assert!(page.all("script").is_empty());
    assert!(words.iter().all(|words| page.text.matches(words).count() >= 2));
}

#[test]
fn an_export_is_refused_where_students_look_and_where_something_lies() {
    let room = Room::new();
    let set = room.set("hoists-and-pulleys", "en");
    let folder = set.folder.display().to_string();
    let name = folder.rsplit('/').next().unwrap();
    let export = |out: &str, more: &[&str]| {
        room.refused(&[&["export", &folder, "--format", "moodle", "--out", &room.at(out)], more].concat())
    };
    for within in ["students/q.xml", "students/0017/q.xml", "students/new/q.xml"] {
        let told = export(&format!("{name}/{within}"), &[]);
        assert!(told.contains("is within the folder of what students get"), "{told}");
        assert!(
            told.contains("an export holds the key, and students never get it: give another --out"),
            "{told}"
        );
    }
    let inside = room.at(&format!("{name}/students/pool.xml"));
    let pool = ["--variants", "3", "--seed", "1", "--format", "moodle", "--out", &inside];
    let told = room.refused(&[&["export", "hoists-and-pulleys"], &pool[..]].concat());
    assert!(told.contains("an export holds the key"), "{told}");
    assert!(tree(&set.folder).keys().all(|n| !n.contains(".xml") && !n.contains("pool")));
    fs::write(room.path("there.xml"), "mine").unwrap();
    assert!(export("there.xml", &[]).contains("ROOM/there.xml: is there already"));
    assert_eq!(fs::read(room.path("there.xml")).unwrap(), b"mine");
    assert!(export(name, &[]).contains("is a folder, and a file is wanted"));
    let told =
        room.refused(&["export", &folder, "--format", "qti3", "--as", "cloze", "--out", &room.at("x.zip")]);
    assert!(told.contains("--as: is for moodle, and not for qti3"), "{told}");
    let told =
        room.refused(&["export", "hoists-and-pulleys", "--format", "qti3", "--out", &room.at("x.zip")]);
    assert!(told.contains("is no folder of a set") && told.contains("--variants 200 --seed 1"), "{told}");
    let told = export("x.xml", &["--variants", "3", "--seed", "1"]);
    assert!(told.contains("this is a set, which has its variants"), "{told}");
    let told = export("x.xml", &["--problems", "pulled-rolling"]);
    assert!(told.contains("the bank has no problem `pulled-rolling`"), "{told}");
    let told = room.run(&["export", &folder, "--format", "scorm", "--out", &room.at("x.zip")]);
    assert!(told.exit == Exit::Faulty && told.err.contains("the formats are moodle, canvas, qti21 and qti3"));
    assert!(!room.path("x.zip").exists() && !room.path("x.xml").exists());
}

#[test]
fn canvas_is_given_no_number_that_it_takes_for_nothing() {
    let room = Room::new();
    let bank = "bank: slow
title: Slow
problems:
  slide:
    title: Slide
    data:
      m: {name: mass, unit: kg, draw: 2 to 9 step 1}
      d: {name: distance, unit: m, draw: 0.00001 to 0.00002 step 0.000001}
    scene:
      surfaces: {ramp: {slope: 30 deg}}
      bodies:
        block: {mass: m, moves: along ramp, positive: down}
      ties:
        - slides: {body: block, mu_k: 0.1, mu_s: 0.15}
      start: at rest
      end: {travel: {of: block, by: d, heading: down}}
    questions:
      t: {ask: the time, unit: UNIT}
    statement: |
      The mass is {{ m }} and the distance {{ d }}; {{ g }}.
";
    let roster = room.at("roster.csv");
    for (unit, fits) in [("s", false), ("ms", true)] {
        let (file, out) = (room.at(&format!("{unit}.yaml")), room.at(&format!("set-{unit}")));
        fs::write(&file, bank.replace("UNIT", unit)).unwrap();
        room.fine(&["generate", &file, "--roster", &roster, "--seed", "1", "--format", "md", "--out", &out]);
        let zip = room.at(&format!("{unit}.zip"));
        let args = ["export", &out, "--format", "canvas", "--out", &zip];
        if fits {
            room.fine(&args);
        } else {
            let told = room.refused(&args);
            let of_bank =
                "set-s/bank.yaml: problems.slide.questions.t.unit: the answer or its tolerance is down to";
            assert_eq!(told.matches(of_bank).count(), 1, "{told}");
            assert!(told.contains("too small for Canvas, which takes what is below 0.0001 for 0"), "{told}");
            assert!(told.contains("ask for it in ms, or leave the problem out with --problems"), "{told}");
        }
        assert_eq!(Path::new(&zip).exists(), fits);
        if !fits {
            // A refused pool leaves nothing, and is told of the bank that was given.
            let pool = room.at("pool.zip");
            let draw = ["--variants", "3", "--seed", "1", "--format", "canvas", "--out", &pool];
            let told = room.refused(&[&["export", &file], &draw[..]].concat());
            assert!(told.contains("s.yaml: problems.slide.questions.t.unit"), "{told}");
            assert!(!room.path("pool.zip").exists() && !room.path("pool-set").exists());
        }
        // The others do not round.
        room.fine(&["export", &out, "--format", "qti3", "--out", &room.at(&format!("{unit}3.zip"))]);
    }
}

#[test]
fn what_a_platform_does_not_carry_is_told_question_by_question() {
    let room = Room::new();
    let set = room.set("wheels-on-inclines", "en");
    let folder = set.folder.display().to_string();
    let told = |format: &str, more: &[&str]| {
        let out = room.at("o");
        room.fine(&[&["export", &folder, "--format", format, "--out", &out, "--force"], more].concat())
    };
    let moodle = told("moodle", &[]);
    for line in [
        "8 variants of 4 problems as 8 questions for moodle",
        "What moodle does not carry over (tolerances and points are those of the key):",
        "  every question: no decimal comma, no points for what follows from an earlier answer, no hint",
        "  2.omega: a number in rad/s, the unit not typed, no other one (rpm, rev/s, deg/s ...)\n",
        "  2.friction: a number in N, the unit not typed, no other one (kN, mN ...); signed, no direction in words\n",
        "  4.direction: a word as `grade` reads it, but no sentence around it\n",
    ] {
        assert!(moodle.contains(line), "{line}: {moodle}");
    }
    assert!(
        told("moodle", &["--as", "numerical"]).contains("2.omega: only the units offered (rad/s, rpm, rev/s")
    );
    let guess = "every question: an answer that is a word is chosen from a list and can be guessed: ";
    let apart = "every question: each part is a question of its own";
    let (qti, canvas, numerical) =
        (told("qti3", &[]), told("canvas", &[]), told("moodle", &["--as", "numerical"]));
    assert!(qti.contains(guess) && qti.contains("4.direction") && !qti.contains(apart), "{qti}");
    assert!(canvas.contains(guess) && canvas.matches(apart).count() == 1, "{canvas}");
    assert!(!numerical.contains(guess) && numerical.contains(apart), "{numerical}");
    assert!(!numerical.contains(",  ..."), "{numerical}");
    assert_eq!(moodle::weights(&[1.0, 2.0]), [1, 2]);
    assert_eq!(moodle::weights(&[0.5, 1.25]), [2, 5]);
}

/// The QTI 3 player of Citolab in Chromium: the key has all points, what is just beyond the tolerance none.
#[test]
fn a_player_of_qti_3_scores_the_key_fully_and_what_is_beyond_the_tolerance_not_at_all() {
    if std::env::var_os("SLIPSTICK_BROWSER").is_none() {
        println!(
            "passed over: SLIPSTICK_BROWSER names no folder with playwright-core and @citolab/qti-components"
        );
        return;
    }
    let room = Room::new();
    let mut items = Vec::new();
    let (mut negative, mut judged) = (0, 0);
    for (turn, language) in ["en", "de"].into_iter().enumerate() {
        for (_, bank) in
            support::bank_names().enumerate().filter(|(i, _)| !support::is_quick() || i % 2 == turn)
        {
            let set = room.set(bank, language);
            for (name, bytes) in unpacked(&room.export(&set, "qti3", &[])) {
                let Some(code) = name.strip_prefix("items/").and_then(|n| n.strip_suffix(".xml")) else {
                    continue;
                };
                let variant = set.of(code.rsplit_once('-').unwrap().1);
                let points: f64 = variant.parts.iter().map(|p| p.points).sum();
                let mut tries = Vec::new();
                let mut round = |write: &dyn Fn(&Part, f64, f64) -> String, word: bool, score: f64| {
                    let answers: serde_json::Map<String, serde_json::Value> = variant
                        .parts
                        .iter()
                        .map(|part| {
                            let answer = match part.tolerance {
                                Some(tolerance) => write(part, part.value.parse().unwrap(), tolerance),
                                None if word => part.value.clone(),
                                None => "".to_owned(),
                            };
                            (part.id.clone(), answer.into())
                        })
                        .collect();
                    judged += answers.len();
                    tries.push(serde_json::json!({"answers": answers, "score": score}));
                };
                round(&|part, _, _| part.value.clone(), true, points);
                round(&|_, value, _| format!("{value:e}"), true, points);
                round(&|_, value, tolerance| format!("{:E}", value + 0.98 * tolerance), true, points);
                round(&|_, value, tolerance| (value - 0.98 * tolerance).to_string(), true, points);
                round(&|_, value, tolerance| (value + 1.02 * tolerance).to_string(), false, 0.0);
                round(&|_, value, tolerance| format!("{:e}", value - 1.02 * tolerance), false, 0.0);
                round(&|_, _, _| String::new(), false, 0.0);
                negative += variant.parts.iter().filter(|p| p.value.starts_with('-')).count();
                let file = room.path(&format!("{bank}-{language}-{code}.xml"));
                fs::write(&file, bytes).unwrap();
                items.push(serde_json::json!({"file": file, "points": points, "tries": tries}));
            }
        }
    }
    assert!(negative > 5, "{negative} negative answers");
    fs::write(room.path("items.json"), serde_json::json!(items).to_string()).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/browser/qti3.mjs");
    let done = Command::new("node").arg(script).arg(room.at("items.json")).output().unwrap();
    let told = String::from_utf8_lossy(&done.stdout).into_owned();
    println!("{told}");
    assert!(done.status.success(), "{told}{}", String::from_utf8_lossy(&done.stderr));
    assert!(told.contains(&format!("{judged} answers in {} items", items.len())), "{told}");
}

/// The line of the manual makes a document for Word: formulas as Word has them, figures that are no empty pictures, each with its text.
#[test]
fn the_line_of_the_manual_makes_a_document_for_word_with_formulas_and_figures() {
    if !has_pandoc() {
        return;
    }
    let room = Room::new();
    let (roster, out) = (room.at("roster.csv"), room.at("woche-3"));
    room.fine(&[
        "generate",
        "wheels-on-inclines",
        "--roster",
        &roster,
        "--seed",
        "7",
        "--format",
        "md",
        "--out",
        &out,
    ]);
    let manual = slipstick::manual::topic("formats").unwrap().text;
    let line = manual.split_once("$ pandoc ").unwrap().1.split("```").next().unwrap();
    let done = Command::new("sh")
        .args(["-c", &format!("pandoc {line}")])
        .current_dir(room.0.path())
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let files = unzipped(&fs::read(room.path("0017.docx")).unwrap());
    let sheet = fs::read_to_string(room.path("woche-3/students/0017/sheet.md")).unwrap();
    let figures = sheet.lines().filter(|l| l.starts_with("![")).count();
    let document = xml::read(text(&files["word/document.xml"]));
    assert!(document.all("m:oMath").len() > 20);
    assert!(document.text.contains("particles are joined by light rigid rods"));
    let told = document.all("pic:cNvPr");
    let of =
        |end: &str| files.iter().filter(|(n, _)| n.starts_with("word/media/") && n.ends_with(end)).count();
    assert_eq!((figures, of(".svg"), told.len()), (4, 4, 4));
    // A picture in which nothing is drawn takes some hundred bytes.
    let drawn = files.iter().filter(|(n, bytes)| n.ends_with(".png") && bytes.len() > 5_000).count();
    let converts = Command::new("rsvg-convert").arg("--version").output().is_ok();
    assert!(drawn == figures || !converts, "{drawn} of {figures} figures are drawn");
}
