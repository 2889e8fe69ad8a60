//! Sheets that check themselves: the program in the page answers what `slipstick check` answers, in Node and in a browser.
use crate::readme_bank;
use crate::support;
use crate::support::program;
use sha2::{Digest, Sha256};
use slipstick::bank::load;
use slipstick::cli::tell::Exit;
use slipstick::grade::verdict::Verdict;
use slipstick::key::{Answer, KeyEntry};
use slipstick::misconception::catalogue::{Catalogue, CatalogueEntry};
use slipstick::num::shown;
use slipstick::page::check::{self, CheckedProblem, PosedProblem};
use slipstick::page::sheet_file::{SheetFile, SheetProblem};
use slipstick::sheet::self_check::PROGRAM;
use slipstick::words::Words;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

/// Answers that are random besides right and wrong ones, over all banks of a language.
const RANDOM: usize = 1000;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

/// Words that follow each other by chance, the same in every run.
struct Lots(u64);

impl Lots {
    fn below(&mut self, n: usize) -> usize {
        // Knuth's constants of a linear congruence; its high bits are good enough to choose answers.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n
    }
    fn one<'t>(&mut self, of: &[&'t str]) -> &'t str {
        of[self.below(of.len())]
    }
}

/// An answer and what the program says of it.
struct Case {
    part: String,
    cell: String,
    told: check::Checked,
}

/// A sheet, and answers to it: in each round one to a part at most. The first round is right, the second is wrong, the next ones are
/// where known wrong methods come to.
struct Made {
    folder: PathBuf,
    language: &'static str,
    parts: Vec<String>,
    rounds: Vec<Vec<Case>>,
}

/// Rounds of answers by wrong methods.
const METHODS: usize = 4;

fn right(entry: &KeyEntry, words: &Words) -> String {
    match &entry.answer {
        Answer::Word { right, .. } => words.get(&format!("sheet.{right}")).to_owned(),
        Answer::Number { value, .. } => entry.unit.text_with(&entry.unit.from_si(*value).to_string()),
    }
}

/// An answer that is off by 1.01 tolerances, or the other word.
fn wrong(entry: &KeyEntry, words: &Words) -> String {
    match &entry.answer {
        Answer::Word { right, offered } => {
            let other = offered.iter().find(|word| *word != right).unwrap();
            words.get(&format!("sheet.{other}")).to_owned()
        }
        Answer::Number { value, half_width, .. } => {
            let off = value + 1.01 * half_width * value.signum();
            entry.unit.text_with(&entry.unit.from_si(off).to_string())
        }
    }
}

/// Where a wrong method comes to, to four figures; the n-th that is known of the part, or the right answer with the wrong sign.
fn by_method(entry: &KeyEntry, n: usize) -> String {
    let Answer::Number { value, .. } = entry.answer else { return "5".to_owned() };
    let wrong = entry.wrong.get(n).map_or(-value, |w| w.value);
    entry.unit.text_with(&shown::significant(entry.unit.from_si(wrong), 4))
}

/// What students write: numbers near and far, in other units, with commas, words, fractions, and what is no answer.
fn random(entry: &KeyEntry, lots: &mut Lots) -> String {
    const ODD: [&str; 24] = [
        "",
        " ",
        "?",
        "12,5",
        "1.234,5",
        "1,234",
        "3/4",
        "2*sqrt(3) m",
        "π/6 rad",
        "up",
        "down",
        "Aufwärts",
        "ja",
        "no",
        "stays",
        "12.5 m/s up",
        "-3 N down",
        "45 km/h",
        "172 rpm",
        "4' 3\"",
        "12 kn",
        "25 ± 1 %",
        "<b>1</b>",
        "1e400",
    ];
    let value = match &entry.answer {
        Answer::Number { value, .. } => entry.unit.from_si(*value),
        Answer::Word { offered, .. } => {
            let lists = [offered[lots.below(offered.len())], "Up.", "vorwärts", "nein", "5", "left"];
            return lots.one(&lists).to_owned();
        }
    };
    if lots.below(3) == 0 {
        return lots.one(&ODD).to_owned();
    }
    let factor = [1.0, 1.004, 0.991, 1.0099, -1.0, 0.5, 2.0, 10.0, 0.001, 57.29577951308232][lots.below(10)];
    let mut text = format!("{:e}", value * factor);
    if lots.below(2) == 0 {
        text = (value * factor).to_string();
    }
    if lots.below(3) == 0 {
        text = text.replace('.', ",");
    }
    const OTHERS: [&str; 11] = ["", "m/s", "rad/s", "N", "mm", "kJ", "rev/min", "deg", "lbf", "ft/s", "%"];
    let unit = if lots.below(3) > 0 { entry.unit.ascii() } else { lots.one(&OTHERS) };
    let unit = if unit == "1" { "" } else { unit };
    let word = lots.one(&["", "", "", " up", " down", " abwärts", " clockwise", " ccw", " rechts", " back"]);
    format!("{text} {unit}{word}").trim_end().to_owned()
}

/// The built-in banks with their names: in English with all hints, in German with those of a bank that says nothing about them.
fn built_in(room: &Path, language: &str) -> Vec<(String, String)> {
    let of = |bank: &str| {
        let mut file = bank.to_owned();
        if language == "en" {
            let built_in = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("banks/{bank}.yaml"));
            let text = std::fs::read_to_string(built_in).unwrap();
            file = room.join(format!("{bank}.yaml")).display().to_string();
            std::fs::write(&file, text.replacen("\nproblems:", "\ngrading: {hints: explain}\nproblems:", 1))
                .unwrap();
        }
        (bank.to_owned(), file)
    };
    support::bank_names().map(of).collect()
}

/// The banks of the manual and the scenes from textbooks.
fn others(room: &Path) -> Vec<(String, String)> {
    let examples = readme_bank::blocks().into_iter().filter(|b| b.starts_with("bank: ")).map(str::to_owned);
    let mut texts: Vec<String> = examples.collect();
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenes");
    let files = std::fs::read_dir(scenes).unwrap().map(|entry| entry.unwrap().path());
    texts.extend(files.map(|file| {
        let text = std::fs::read_to_string(file).unwrap();
        let bank = load::scenes_only(&text, "bank").unwrap();
        let data = bank.problems[0].data.iter().filter(|datum| datum.unknown.is_none());
        let told: String = data.map(|datum| format!("      {{{{ {} }}}}\n", datum.symbol)).collect();
        format!("{text}    statement: |\n      Read the figure.\n{told}")
    }));
    let of = |(i, text): (usize, &String)| {
        let file = room.join(format!("other-{i}.yaml"));
        std::fs::write(&file, text).unwrap();
        (format!("other-{i}"), file.display().to_string())
    };
    texts.iter().enumerate().map(of).collect()
}

/// A sheet of every problem of each bank in a language, with answers and what the program says of them.
fn made(room: &Path, language: &'static str, banks: &[(String, String)]) -> Vec<Made> {
    let roster = room.join("roster.csv");
    std::fs::write(&roster, "student,name\n0017,Amina Yusuf\n0023,Ben Okoro\n").unwrap();
    let words = Words::built_in(language).unwrap();
    let catalogue = Catalogue::shared(language);
    let find = |id: &str| catalogue.get(id).map(CatalogueEntry::words);
    let mut lots = Lots(17);
    let mut all = Vec::new();
    for (bank, file) in banks {
        let out = room.join(format!("{bank}-{language}"));
        let (folder, roster) = (out.display().to_string(), roster.display().to_string());
        let args =
            ["generate", file, "--roster", &roster, "--seed", "7", "--language", language, "--out", &folder];
        let (exit, _, err) = run(&args);
        // A textbook's data are constants: a case of the scene may never come true, or an answer be too sensitive.
        let never = ["draws holds the rules", "they break the rules"];
        if never.iter().any(|why| err.contains(why)) {
            continue;
        }
        assert_eq!(exit, Exit::Fine, "{err}");
        // A page holds what its sheet says, whichever sheet of the scene was read first.
        for student in std::fs::read_dir(out.join("students")).unwrap().map(|entry| entry.unwrap().path()) {
            let text = |name: &str| std::fs::read_to_string(student.join(name)).unwrap();
            let sheet = SheetFile::parse(&text("sheet.json")).unwrap();
            let packed =
                |p: &SheetProblem| PosedProblem::read(p, "sheet").unwrap().put_to(p).packed().unwrap();
            let packed: Vec<String> = sheet.problems.iter().map(packed).collect();
            assert_eq!(
                data_of(&text("sheet.html"))["problems"],
                serde_json::json!(packed),
                "{}",
                student.display()
            );
        }
        let folder = out.join("students/0017");
        let sheet = SheetFile::parse(&std::fs::read_to_string(folder.join("sheet.json")).unwrap()).unwrap();
        let solved: Vec<_> = sheet.problems.iter().map(|p| check::solve(p, "sheet").unwrap()).collect();
        let parts: Vec<(String, &CheckedProblem, usize)> = solved
            .iter()
            .flat_map(|p| {
                p.key
                    .parts
                    .iter()
                    .enumerate()
                    .map(move |(i, e)| (format!("{}.{}", p.posed.number, e.part), p, i))
            })
            .collect();
        let round = |cell: &mut dyn FnMut(&KeyEntry) -> String| -> Vec<Case> {
            let case = |(part, problem, index): &(String, &CheckedProblem, usize)| {
                let cell = cell(&problem.key.parts[*index]);
                let told = problem.check(*index, &cell, words, &find).unwrap();
                Case { part: part.clone(), cell, told }
            };
            parts.iter().map(case).collect()
        };
        let mut rounds = vec![round(&mut |e| right(e, words)), round(&mut |e| wrong(e, words))];
        rounds.extend((0..METHODS).map(|n| round(&mut |e| by_method(e, n))));
        for _ in 0..RANDOM.div_ceil(banks.len() * parts.len()) {
            rounds.push(round(&mut |e| random(e, &mut lots)));
        }
        let parts = parts.iter().map(|(part, ..)| part.clone()).collect();
        all.push(Made { folder, language, parts, rounds });
    }
    all
}

/// The sheets of the built-in banks in both languages, made once for all tests, and their folder.
static SHEETS: LazyLock<(PathBuf, Vec<Made>)> = LazyLock::new(|| {
    let room = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sheets");
    let _ = std::fs::remove_dir_all(&room);
    std::fs::create_dir_all(&room).unwrap();
    let all = ["en", "de"].into_iter().flat_map(|language| made(&room, language, &built_in(&room, language)));
    let all = all.collect();
    (room, all)
});

fn case(case: &Case) -> serde_json::Value {
    let check::Checked { verdict, reason, read, hints } = &case.told;
    serde_json::json!({
        "part": case.part, "cell": case.cell, "verdict": verdict.as_str(), "reason": reason, "read": read, "hints": hints,
    })
}

#[test]
fn key_answers_are_right_and_what_is_just_beyond_the_tolerance_is_not() {
    for made in &SHEETS.1 {
        let right = |case: &Case| case.told.verdict == Verdict::Right;
        for (i, want) in [(0, true), (1, false)] {
            for case in &made.rounds[i] {
                let Case { part, cell, told } = case;
                assert_eq!(right(case), want, "{} {part}: {cell}: {told:?}", made.folder.display());
            }
        }
        let random = made.rounds[2 + METHODS..].iter().flatten();
        let share = random.clone().filter(|case| right(case)).count() * 100 / random.count();
        assert!((5..60).contains(&share), "{share} % of the random answers are right");
    }
}

#[test]
fn the_binary_is_made_from_these_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let hex = |bytes: &[u8]| {
        Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        })
    };
    let list = std::fs::read_to_string(root.join("templates/page/made-from")).unwrap();
    let mut stale = Vec::new();
    let mut of_solver = 0;
    for line in list.lines() {
        let (hash, file) = line.split_once("  ").unwrap();
        of_solver += usize::from(file.starts_with("src/solve/eom/"));
        if std::fs::read(root.join(file)).map_or(true, |bytes| hex(&bytes) != hash) {
            stale.push(file);
        }
    }
    assert!(of_solver > 3, "the sources of the solver are among those of the page");
    assert!(
        stale.is_empty(),
        "changed since the page's program was made, run .ci/page: {}",
        stale.join(", ")
    );
    assert!(PROGRAM.len() <= 400_000, "{} bytes packed", PROGRAM.len());
}

/// Is there Node? Where there is none, the tests of the page pass over it, but not in `.ci/run`.
fn node() -> bool {
    let there = Command::new("node").arg("--version").output().is_ok_and(|o| o.status.success());
    assert!(there || std::env::var_os("SLIPSTICK_NEEDS_NODE").is_none(), "there is no node");
    if !there {
        println!("passed over: there is no node");
    }
    there
}

/// The data of a page.
fn data_of(page: &str) -> serde_json::Value {
    let begin = "<script type=\"application/json\" id=\"sheet\">";
    let (_, rest) = page.split_once(begin).unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// What the page and `check` tell is one ladder; a bank without hints gives verdicts alone, and its pages carry no words for more.
#[test]
fn the_ladder_of_hints_is_that_of_check() {
    let (mut hints, mut longest) = (0, 0);
    let (made, all) = &*SHEETS;
    for made in all.iter().filter(|made| made.language == "en").step_by(3) {
        let file = made.folder.join("sheet.json").display().to_string();
        for case in made.rounds[2].iter().chain(&made.rounds[3]) {
            let Case { part, cell, told } = case;
            let answer = format!("{part}={cell}");
            let of = told.hints.len();
            longest = longest.max(of);
            for (n, hint) in told.hints.iter().enumerate() {
                hints += 1;
                let n = (n + 1).to_string();
                let (exit, out, err) = run(&["check", &file, &answer, "--hint", &n]);
                assert_eq!(exit, Exit::NotAllRight, "{err}");
                assert_eq!(out.lines().last().unwrap(), format!("{part}, hint {n} of {of}: {hint}"));
            }
        }
    }
    assert!(hints > 80 && longest >= 4, "{hints}, {longest}");
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    let text = std::fs::read_to_string(made.join("slip-and-roll.yaml")).unwrap();
    std::fs::write(at("none.yaml"), text.replace("hints: explain", "hints: none")).unwrap();
    let (roster, out) = (made.join("roster.csv").display().to_string(), at("none"));
    assert_eq!(
        run(&["generate", &at("none.yaml"), "--roster", &roster, "--seed", "7", "--out", &out]).0,
        Exit::Fine
    );
    let data = data_of(&std::fs::read_to_string(at("none/students/0017/sheet.html")).unwrap());
    assert_eq!(data["methods"], serde_json::json!({}));
    let mut signs = 0;
    for problem in posed(&data) {
        for (index, entry) in problem.key.parts.iter().enumerate() {
            let Answer::Number { value, .. } = entry.answer else { continue };
            let cell = entry.unit.text_with(&entry.unit.from_si(-value).to_string());
            let told = problem.check(index, &cell, Words::built_in("en").unwrap(), &|_| None).unwrap();
            signs += 1;
            assert_eq!((told.verdict, &*told.reason), (Verdict::Wrong, "not within the tolerance"), "{cell}");
            assert!(told.hints.is_empty(), "{told:?}");
        }
    }
    assert!(signs > 5, "{signs}");
}

#[test]
fn the_program_of_the_page_answers_in_node_what_check_answers() {
    if !node() {
        return;
    }
    let room = tempfile::tempdir().unwrap();
    let others = made(room.path(), "en", &others(room.path()));
    assert!(others.len() > 40, "{} scenes of textbooks and the manual", others.len());
    let all: Vec<&Made> = SHEETS.1.iter().chain(&others).collect();
    let mut cases = Vec::new();
    for made in &all {
        let answers: Vec<_> = made.rounds.iter().flatten().map(|c| [&c.part, &c.cell]).collect();
        let opening = data_of(&std::fs::read_to_string(made.folder.join("sheet.html")).unwrap());
        cases.push(serde_json::json!({"opening": opening, "answers": answers}));
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut node = Command::new("node")
        .args([root.join("tests/browser/node.mjs"), root.join("templates/page/check.wasm.gz")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let input = serde_json::to_vec(&cases).unwrap();
    let mut pipe = node.stdin.take().unwrap();
    pipe.write_all(&input).unwrap();
    drop(pipe);
    let told: Vec<serde_json::Value> =
        serde_json::from_slice(&node.wait_with_output().unwrap().stdout).unwrap();
    let mut judged = 0;
    for (made, told) in all.iter().zip(&told) {
        let told = told.as_array().unwrap_or_else(|| panic!("{}: {told}", made.folder.display()));
        let wanted: Vec<&Case> = made.rounds.iter().flatten().collect();
        assert_eq!(told.len(), wanted.len());
        for (told, want) in told.iter().zip(wanted) {
            judged += 1;
            for (what, want) in case(want).as_object().unwrap().iter().filter(|(what, _)| *what != "cell") {
                assert_eq!(&told[what], want, "{}: {told}", made.folder.display());
            }
        }
    }
    assert!(judged > 2 * RANDOM, "{judged} answers");
}

/// The problems of a page, solved.
fn posed(data: &serde_json::Value) -> impl Iterator<Item = CheckedProblem> {
    let problems = data["problems"].as_array().unwrap().iter();
    problems.map(|packed| PosedProblem::unpacked(packed.as_str().unwrap()).unwrap().solved().unwrap())
}

/// A page to practise with: its file, and right answers to its problems in their order.
fn practice(file: &str) -> serde_json::Value {
    let problems = "pulled-rolling,spring-released";
    let args = [
        "practice",
        "wheels-on-inclines",
        "--problems",
        problems,
        "--seed",
        "5",
        "--variants",
        "2",
        "--page",
        file,
    ];
    let (exit, out, err) = run(&args);
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(out.contains("4 problems (seed 5)"), "{out}");
    let words = Words::built_in("en").unwrap();
    let data = data_of(&std::fs::read_to_string(file).unwrap());
    let tasks: Vec<_> = posed(&data)
        .map(|p| {
            let answer =
                |e: &KeyEntry| serde_json::json!([format!("{}.{}", p.posed.number, e.part), right(e, words)]);
            p.key.parts.iter().map(answer).collect::<Vec<_>>()
        })
        .collect();
    serde_json::json!({"file": file, "tasks": tasks})
}

/// Practice in a terminal draws the same problems; a page is not written over another, nor from a bank that leaves no scene.
#[test]
fn a_page_to_practise_with_has_solutions_and_is_written_whole_or_not_at_all() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    let file = at("practice.html");
    let made = practice(&file);
    assert_eq!(made["tasks"].as_array().unwrap().len(), 4);
    let page = std::fs::read_to_string(&file).unwrap();
    assert_eq!(page.matches("<section class=\"task\">").count(), 4);
    assert_eq!(page.matches("<details><summary>Worked solution</summary>").count(), 4);
    assert!(!page.contains("<details open"), "solutions are closed");
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let unique: std::collections::BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), unique.len(), "an id stands twice");
    let (exit, _, err) = run(&["practice", "wheels-on-inclines", "--page", &file]);
    assert!(exit != Exit::Fine && err.contains("is there already"), "{err}");
    assert_eq!(run(&["practice", "wheels-on-inclines", "--variants", "2"]).0, Exit::Faulty);
    let bank = Path::new(env!("CARGO_MANIFEST_DIR")).join("banks/slip-and-roll.yaml");
    let text = std::fs::read_to_string(bank).unwrap();
    std::fs::write(at("off.yaml"), text.replacen("\nproblems:", "\nself check: off\nproblems:", 1)).unwrap();
    let (exit, _, err) = run(&["practice", &at("off.yaml"), "--page", &at("off.html")]);
    assert!(
        exit != Exit::Fine && err.contains("self check") && !Path::new(&at("off.html")).exists(),
        "{err}"
    );
}

#[test]
fn sheets_check_themselves_in_a_browser() {
    if std::env::var_os("SLIPSTICK_BROWSER").is_none() {
        println!("passed over: SLIPSTICK_BROWSER names no folder with playwright-core and axe-core");
        return;
    }
    let room = tempfile::tempdir().unwrap();
    let (made, all) = &*SHEETS;
    let (quick, banks) = (support::is_quick(), all.len() / 2);
    let opened = all.iter().enumerate().filter(|(i, _)| !quick || (i % banks) % 2 == i / banks);
    let sheets: Vec<_> = opened
        .map(|(_, made)| {
            let rounds: Vec<Vec<_>> = made.rounds.iter().map(|round| round.iter().map(case).collect()).collect();
            serde_json::json!({
                "file": made.folder.join("sheet.html"), "parts": made.parts, "rounds": rounds, "answers": "answers-0017.csv",
                "button": Words::built_in(made.language).unwrap().get("page.check"),
                "no_more": Words::built_in(made.language).unwrap().get("tutor.no_more"),
            })
        })
        .collect();
    let at = |name: &str| room.path().join(name).display().to_string();
    let (roster, site, off) = (made.join("roster.csv").display().to_string(), at("site"), at("off"));
    let generate = |bank: &str, out: &str, more: &[&str]| {
        let mut args = vec!["generate", bank, "--roster", &roster, "--seed", "7", "--out", out];
        args.extend(more);
        let (exit, _, err) = run(&args);
        assert_eq!(exit, Exit::Fine, "{err}");
    };
    generate("wheels-on-inclines", &site, &["--page", "site"]);
    let bank =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("banks/slip-and-roll.yaml"))
            .unwrap();
    std::fs::write(at("bank.yaml"), bank.replacen("\nproblems:", "\nself check: off\nproblems:", 1)).unwrap();
    generate(&at("bank.yaml"), &off, &[]);
    // The same seed, name and student: the same data as in the sheet that is one file.
    let first = &all[0].rounds[0][0];
    let cases = serde_json::json!({
        "sheets": sheets, "practice": practice(&at("practice.html")), "hints": if quick { 100 } else { 300 },
        "site": {"folder": format!("{site}/students"), "sheet": "0017/sheet.html", "part": first.part, "cell": first.cell},
        "off": format!("{off}/students/0017/sheet.html"),
    });
    std::fs::write(at("cases.json"), cases.to_string()).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/browser/page.mjs");
    let done = Command::new("node").arg(script).arg(at("cases.json")).output().unwrap();
    println!("{}", String::from_utf8_lossy(&done.stdout));
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
}

/// A class hands in: a second attempt of a student, a file that is none, one that a spreadsheet has changed.
#[test]
fn files_of_a_class_are_graded_at_once_from_a_folder_and_from_an_archive() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    std::fs::write(at("roster.csv"), "student\n0017\n0023\n").unwrap();
    let problems = ["--problems", "pulled-rolling"];
    let (roster, set) = (at("roster.csv"), at("set"));
    let mut args = vec!["generate", "wheels-on-inclines", "--roster", &roster, "--seed", "7", "--out", &set];
    args.extend(problems);
    assert_eq!(run(&args).0, Exit::Fine);
    let files: [(&str, &str); 6] = [
        (
            "Amina_1_file_/answers-0017 (2).csv",
            "student,problem,part,answer,saved_at,set\r\n0017,1,omega,3 rad/s,2026-03-03T10:00:00.000Z,another\r\n",
        ),
        (
            "Amina_1_file_/answers-0017 (1).csv",
            "student,problem,part,answer,saved_at,set\r\n0017,1,omega,2 rad/s,2026-03-02T10:00:00.000Z,wheels-on-inclines\r\n",
        ),
        (
            "Amina_1_file_/answers-0017.csv",
            "\u{feff}student,problem,part,answer,saved_at\r\n0017,1,omega,1 rad/s,2026-03-01T10:00:00.000Z\r\n",
        ),
        ("Anders_2_file_/answers-0023.csv", "student;problem;part;answer\n0023;1;friction;\"12,5 N up\"\n"),
        ("Anders_2_file_/notes.csv", "what,when\n1,2\n"),
        ("Anders_2_file_/scan.pdf", "%PDF"),
    ];
    let mut archive = zip::ZipWriter::new(std::fs::File::create(at("class.zip")).unwrap());
    for (name, text) in files {
        let place = room.path().join("class").join(name);
        std::fs::create_dir_all(place.parent().unwrap()).unwrap();
        std::fs::write(place, text).unwrap();
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    }
    archive.finish().unwrap();
    let mut graded = Vec::new();
    for from in ["class", "class.zip"] {
        let (from, out) = (at(from), at(&format!("grades-{from}")));
        let (exit, told, err) = run(&["grade", &set, &from, "--out", &out]);
        assert_eq!(exit, Exit::Fine, "{err}");
        assert!(told.contains("from 3 files"), "{told}");
        assert!(told.contains("answers-0017 (2).csv was saved from a sheet of another set"), "{told}");
        assert!(told.contains("passed over: Anders_2_file_/notes.csv lacks the columns"), "{told}");
        assert!(told.contains("passed over: Anders_2_file_/scan.pdf is no CSV file"), "{told}");
        graded.push(std::fs::read_to_string(Path::new(&out).join("answers.csv")).unwrap());
    }
    assert_eq!(graded[0], graded[1]);
    let lines: Vec<&str> = graded[0].lines().collect();
    assert_eq!(lines.len(), 4, "{}", graded[0]);
    let of = |answer: &str| lines.iter().find(|line| line.contains(answer)).unwrap();
    // The line that an answer is told to stand on can be looked up, and tells the file.
    let grades = at("grades-class");
    let kept = std::fs::read_to_string(Path::new(&grades).join("basis/submissions.csv")).unwrap();
    for line in &lines[1..] {
        let cells: Vec<&str> = line.split(',').collect();
        let there = kept.lines().nth(cells[0].parse::<usize>().unwrap() - 1).unwrap();
        assert!(there.starts_with(cells[2]) && there.contains("answers-"), "{line}: {there}");
    }
    assert!(
        kept.contains("0017,1,omega,2 rad/s,2026-03-02T10:00:00.000Z,Amina_1_file_/answers-0017 (1).csv"),
        "{kept}"
    );
    let (_, told, _) = run(&["explain", &grades, "0017", "1.omega"]);
    assert!(
        told.contains("in the order of basis/submissions.csv") && told.contains("line 4: `2 rad/s`"),
        "{told}"
    );
    let (again, zipped) = (at("again"), at("grades-class.zip"));
    let (exit, told, err) = run(&["regrade", &set, &zipped, &at("class"), "--out", &again]);
    assert!(exit == Exit::Fine && told.contains("No mark changes"), "{told}{err}");
    let (exit, _, err) = run(&["grade", &set, &grades, "--out", &again, "--force"]);
    assert!(exit != Exit::Fine && err.contains("it has grading.json, which slipstick made"), "{err}");
    assert!(of("1 rad/s").contains("superseded") && !of("2 rad/s").contains("superseded"), "{}", graded[0]);
    assert!(of("12,5 N up").contains("0023"), "{}", graded[0]);
    std::fs::write(at("no.zip"), "no archive").unwrap();
    let (no, out) = (at("no.zip"), at("nothing"));
    let (exit, _, err) = run(&["grade", &set, &no, "--out", &out]);
    assert!(exit != Exit::Fine && err.contains("is no ZIP archive") && !Path::new(&out).exists(), "{err}");
}

/// What spreadsheets and systems make of a student's file costs nobody an answer: other encodings, a line for the delimiter, odd places
/// in an archive, times for lateness. A file that answers for somebody else is told.
#[test]
fn no_students_file_is_lost_for_its_form() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name).display().to_string();
    std::fs::write(at("roster.csv"), "student\n0017\n0023\n0031\n").unwrap();
    let (roster, set) = (at("roster.csv"), at("set"));
    let args = ["generate", "wheels-on-inclines", "--roster", &roster, "--seed", "7", "--out", &set];
    assert_eq!(run(&[&args[..], &["--problems", "pulled-rolling"]].concat()).0, Exit::Fine);
    let wide = |text: &str| -> Vec<u8> {
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
    };
    let files: [(&str, Vec<u8>); 4] = [
        (
            "./answers-0017.csv",
            wide("student,problem,part,answer,saved_at\n0017,1,omega,1 rad/s,2026-03-09T10:00:00Z\n"),
        ),
        ("x\\answers-0023.csv", b"sep=;\nstudent;problem;part;answer\n0023;1;omega;2 \xb5m\n".to_vec()),
        ("../answers-0031.csv", b"student,problem,part,answer\n0023,1,v,\"'=2.07\"\n".to_vec()),
        ("more.zip", b"PK".to_vec()),
    ];
    let mut archive = zip::ZipWriter::new(std::fs::File::create(at("class.zip")).unwrap());
    for (name, bytes) in &files {
        archive.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap();
    let (from, out) = (at("class.zip"), at("grades"));
    let (exit, told, err) = run(&["grade", &set, &from, "--out", &out]);
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(told.contains("from 3 files"), "{told}");
    assert!(told.contains("look at: ../answers-0031.csv holds answers of 0023"), "{told}");
    assert!(
        told.contains("look at: answers of 0023 stand in files of several people: x\\answers-0023.csv, ../answers-0031.csv")
            || told.contains("look at: answers of 0023 stand in files of several people: ../answers-0031.csv, x\\answers-0023.csv"),
        "{told}"
    );
    assert!(!told.contains("answers of 0017 stand"), "{told}");
    assert!(told.contains("passed over: more.zip is an archive itself"), "{told}");
    let answers = std::fs::read_to_string(Path::new(&out).join("answers.csv")).unwrap();
    assert!(
        answers.contains("1 rad/s") && answers.contains("2 \u{b5}m") && answers.contains("'=2.07"),
        "{answers}"
    );
    assert!(!answers.contains("''="), "{answers}");
    // Times of saving serve for lateness where the instructor says so.
    let (timed, column) = (at("timed"), "submitted_at=saved_at");
    let (exit, told, err) = run(&["grade", &set, &from, "--out", &timed, "--columns", column]);
    assert_eq!(exit, Exit::Fine, "{told}{err}");
    let answers = std::fs::read_to_string(Path::new(&timed).join("answers.csv")).unwrap();
    assert!(answers.contains("2026-03-09T10:00:00Z"), "{answers}");
    // Where there is none at all, it is said why.
    std::fs::create_dir(at("none")).unwrap();
    std::fs::write(at("none/scan.pdf"), "%PDF").unwrap();
    let (exit, _, err) = run(&["grade", &set, &at("none"), "--out", &at("nothing")]);
    assert!(exit != Exit::Fine && err.contains("passed over: scan.pdf is no CSV file"), "{err}");
}
