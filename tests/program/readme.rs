//! Every command of README and manual runs, and prints what they show.
use crate::support::program;
use scraper::{Html, Selector};
use slipstick::cli;
use slipstick::cli::tell::{Exit, Io};
use slipstick::manual;
use slipstick::scene::Quantity;
use slipstick::solve::outcome::Motion;
use slipstick::words::Words;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// One ```console block: commands and the output shown below each.
struct Shown {
    line: usize,
    command: String,
    output: Vec<String>,
}

fn commands(readme: &str) -> Vec<Shown> {
    let mut found: Vec<Shown> = Vec::new();
    let mut inside = false;
    let mut first = false;
    for (i, line) in readme.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            inside = !inside && line.trim() == "```console";
            first = inside;
            continue;
        }
        if !inside {
            continue;
        }
        if let Some(command) = line.strip_prefix("$ ") {
            found.push(Shown { line: i + 1, command: command.to_owned(), output: Vec::new() });
            first = false;
        } else if let (false, Some(last)) = (first, found.last_mut()) {
            let continues = last.output.is_empty() && last.command.ends_with('\\');
            if continues {
                last.command.pop();
                last.command.push_str(line.trim_start_matches("> ").trim_start());
            } else {
                last.output.push(line.to_owned());
            }
        }
    }
    found
}

/// Does the output hold the shown lines, in order? `...` stands for any lines, ` ... ` within a line or at its end for any text.
fn shows(output: &str, shown: &[String]) -> Result<(), String> {
    let shown: Vec<&str> = shown.iter().map(|l| l.trim_end()).collect();
    if shown.iter().all(|l| l.is_empty()) {
        return Ok(());
    }
    let lines: Vec<&str> = output.lines().map(str::trim_end).collect();
    let fits = |line: &str, pattern: &str| match pattern.split_once(" ... ") {
        Some((before, after)) => line.starts_with(before) && line.ends_with(after),
        None => pattern.strip_suffix(" ...").map_or(line == pattern, |before| line.starts_with(before)),
    };
    let (mut at, mut skip) = (0, false);
    for pattern in shown {
        if pattern.trim() == "..." {
            skip = true;
            continue;
        }
        let found = if skip {
            (at..lines.len()).find(|i| fits(lines[*i], pattern))
        } else {
            (at < lines.len() && fits(lines[at], pattern)).then_some(at)
        };
        match found {
            Some(i) => at = i + 1,
            None => {
                return Err(format!("shown: {pattern}\nprinted: {}", lines.get(at).unwrap_or(&"(the end)")));
            }
        }
        skip = false;
    }
    if skip || lines[at..].iter().all(|l| l.is_empty()) {
        Ok(())
    } else {
        Err(format!("printed but not shown: {}", lines[at]))
    }
}

/// README and manual: path in the repository and text. Links and pictures are as seen from the folder that they stand in.
fn texts() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let topics = manual::TOPICS.iter().map(|t| format!("templates/manual/{}.md", t.name));
    let read = |path: String| {
        let text = fs::read_to_string(root.join(&path)).unwrap_or_else(|e| panic!("{path}: {e}"));
        (path, text)
    };
    std::iter::once("README.md".to_owned()).chain(topics).map(read).collect()
}

/// Runs the commands of a text in a folder of its own and compares what they print; how many it ran.
fn replay(path: &str, text: &str, folder: &Path) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = assert_cmd::cargo::cargo_bin("slipstick");
    let bin = program.parent().expect("the program stands in a folder");
    // Commands may name banks and data of the repository.
    for entry in ["banks", "templates"] {
        copy(&root.join(entry), &folder.join(entry));
    }
    let mut ran = 0;
    for shown in &commands(text) {
        let word = shown.command.split_whitespace().next().unwrap_or_default();
        if word == "git" || word == "cargo" {
            continue; // getting and building the program: CI has just done it
        }
        if word == "pandoc" && !program::has_pandoc() {
            continue;
        }
        let output = Command::new("sh")
            .arg("-c")
            .arg(&shown.command)
            .current_dir(folder)
            .env("PATH", format!("{}:{}", bin.display(), std::env::var("PATH").unwrap_or_default()))
            .output()
            .expect("a shell runs");
        let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        let place = format!("{path}:{}: {}", shown.line, shown.command);
        let code = output.status.code().unwrap_or(-1);
        // A command may end with 1 or 3 on purpose; then the text says so.
        assert!(code == 0 || code == 1 || code == 3, "{place}\nexit code {code}\n{err}");
        let both = format!("{out}{err}");
        if let Err(difference) =
            shows(&out, &shown.output).or_else(|e| shows(&both, &shown.output).map_err(|_| e))
        {
            panic!("{place}\n{difference}");
        }
        ran += 1;
    }
    ran
}

/// Pictures of a text: where they are in the repository, and where the commands of the text write them.
fn pictures(path: &str, text: &str) -> Vec<(PathBuf, PathBuf)> {
    let above = Path::new(path).parent().unwrap_or(Path::new(""));
    let linked = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let drawn = linked.filter(|link| link.ends_with(".svg"));
    drawn.map(|link| (above.join(link), link.trim_start_matches("tests/readme/").into())).collect()
}

#[test]
#[cfg_attr(feature = "pdf", ignore = "README and manual show a program without PDF")]
fn the_commands_of_readme_and_manual_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let texts = texts();
    std::thread::scope(|scope| {
        for (path, text) in &texts {
            scope.spawn(move || {
                let folder = tempfile::tempdir().unwrap();
                let ran = replay(path, text, folder.path());
                assert!(ran > 0 || path.ends_with("speed.md"), "{path} shows commands");
                // The pictures are those that the commands have just written; with RENEW_PICTURES=1 they are put in their place.
                for (shown, written) in pictures(path, text) {
                    let written =
                        fs::read(folder.path().join(written)).expect("a command of the text writes it");
                    if std::env::var("RENEW_PICTURES").is_ok() {
                        fs::write(root.join(&shown), &written).unwrap();
                    }
                    let stored = fs::read(root.join(&shown)).unwrap();
                    assert!(stored == written, "{} is not what the command writes", shown.display());
                }
                // What is quoted stands in a sheet or in the feedback that the commands made.
                let quoted = text.lines().filter_map(|l| l.strip_prefix('>')).map(str::trim_start);
                let made = ["week-3/students/0017/sheet.md", "grades/feedback/0017.md"];
                let made = made.map(|file| fs::read_to_string(folder.path().join(file)).unwrap_or_default());
                for line in quoted {
                    let there = made.iter().flat_map(|m| m.lines()).any(|l| l.trim_start() == line);
                    assert!(there, "{path} quotes what no command made: {line}");
                }
            });
        }
    });
    for (path, text) in &texts {
        // No block of commands may hide from this test under another name.
        for (i, line) in text.lines().enumerate() {
            let hidden = ["```sh", "```bash", "```shell"].iter().any(|b| line.trim_start().starts_with(b));
            assert!(!hidden, "{path}:{}: write ```console, so that the commands are run", i + 1);
        }
    }
}

/// The README is a front door: it stays short and shows a picture, and its links and those of the manual lead somewhere.
#[test]
fn the_readme_is_short_and_links_lead_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let texts = texts();
    let lines = texts[0].1.lines().count();
    assert!(lines <= 200, "README.md has {lines} lines: what is more belongs to the manual");
    assert_eq!(pictures(&texts[0].0, &texts[0].1).len(), 1);
    for topic in manual::TOPICS {
        let row = format!("| [{0}](templates/manual/{0}.md) | {1} |", topic.name, topic.about);
        assert!(texts[0].1.contains(&row), "README.md should have the row\n{row}");
    }
    for (path, text) in &texts {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if link.starts_with("https://") {
                continue;
            }
            let (file, section) = link.split_once('#').unwrap_or((link, ""));
            let target = root.join(path).parent().unwrap().join(file);
            let there =
                fs::read_to_string(&target).unwrap_or_else(|_| panic!("{path}: {link} leads nowhere"));
            let anchor =
                |heading: &str| heading.to_lowercase().replace(' ', "-").replace(['`', ',', ':'], "");
            let heading = |line: &str| line.strip_prefix("## ").is_some_and(|h| anchor(h) == section);
            assert!(section.is_empty() || there.lines().any(heading), "{path}: no section of {link}");
        }
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

#[test]
fn shown_output_is_compared() {
    let printed = "one\ntwo 1.25 s\nthree\n";
    let shown = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    for (text, fits) in [
        ("one\ntwo 1.25 s\nthree", true),
        ("one\ntwo ... s\nthree", true),
        ("one\ntwo ...\nthree", true),
        ("one\nthree ...\nthree", false),
        ("one\n...", true),
        ("...\nthree", true),
        ("", true),
        ("one\nthree", false),
        ("one", false),
        ("one\n...\nfour", false),
    ] {
        assert_eq!(shows(printed, &shown(text)).is_ok(), fits, "{text}");
    }
    let found = commands("a\n```console\n$ slipstick a \\\n    --b\nout\n$ c\n```\n```yaml\n$ no\n```\n");
    let list: Vec<(usize, &str, usize)> =
        found.iter().map(|s| (s.line, s.command.as_str(), s.output.len())).collect();
    assert_eq!(list, [(3, "slipstick a --b", 1), (6, "c", 0)]);
}

/// The manual's list of regimes is the program's table. A word that only the program knew could not be found by anybody: nothing
/// compared the two.
#[test]
fn the_list_of_regimes_is_the_table_of_the_program() {
    let words = Words::english();
    let mut wanted = vec!["| regime | what happens | also read |".to_owned(), "|---|---|---|".to_owned()];
    for motion in Motion::ALL {
        let also: Vec<String> = motion.synonyms().iter().map(|s| format!("`{s}`")).collect();
        let also = if also.is_empty() { " ".to_owned() } else { format!(" {} ", also.join(", ")) };
        wanted.push(format!("| `{}` | {} |{also}|", motion.word(), words.get(&motion.phrase())));
    }
    let text = manual::topic("bank").expect("a topic").text;
    let lines = text.lines().skip_while(|l| !l.starts_with("| regime |"));
    let found: Vec<&str> = lines.take_while(|l| l.starts_with('|')).collect();
    assert_eq!(found, wanted, "the manual should have\n{}", wanted.join("\n"));
}

/// Each quantity that can be asked stands in the manual.
#[test]
fn the_manual_names_every_quantity() {
    let text = manual::topic("bank").expect("a topic").text;
    let from = text.find("The quantities are").expect("their list");
    let list = text[from..].split("\n\n").next().unwrap_or_default();
    let named: Vec<&str> = list.split('`').skip(1).step_by(2).flat_map(str::split_whitespace).collect();
    for quantity in Quantity::ALL {
        assert!(named.contains(&quantity.name()), "{} is not among {named:?}", quantity.name());
    }
}

struct Ran {
    exit: Exit,
    out: String,
    err: String,
}

fn run(args: &[&str]) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let words = std::iter::once("slipstick").chain(args.iter().copied()).map(OsString::from);
    let mut io = Io { input: &mut &b""[..], out: &mut out, err: &mut err, watched: false, typed: false };
    let exit = cli::run(words, &mut io);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Ran { exit, out: text(out), err: text(err) }
}

/// What `slipstick help` tells, and the book: every link of it leads to a place in it.
#[test]
fn the_manual_is_read_and_written() {
    let room = tempfile::tempdir().unwrap();
    let listed = run(&["help"]);
    assert_eq!((listed.exit, listed.err.as_str()), (Exit::Fine, ""));
    for topic in manual::TOPICS {
        assert!(listed.out.contains(topic.about), "{}", listed.out);
        let read = run(&["help", topic.name]);
        assert_eq!((read.exit, read.err.as_str()), (Exit::Fine, ""));
        assert!(read.out.ends_with(topic.text), "{}", topic.name);
        // A verb of this name is helped with first.
        assert_eq!(read.out.starts_with("# "), topic.name != "accuracy", "{}", read.out);
    }
    assert!(run(&["help", "generate"]).out.contains("required unless --add"));
    let unknown = run(&["help", "gradin"]);
    assert_eq!(unknown.exit, Exit::Faulty);
    assert!(unknown.err.contains("did you mean `grading`?"), "{}", unknown.err);

    let book = room.path().join("book.html").display().to_string();
    assert_eq!(run(&["help", "--html", &book]).exit, Exit::Fine);
    assert!(run(&["help", "--html", &book]).err.contains("--force replaces it"));
    let page = Html::parse_document(&fs::read_to_string(&book).unwrap());
    let all = |css: &str, name: &str| -> Vec<String> {
        let css = Selector::parse(css).unwrap();
        page.select(&css).map(|e| e.attr(name).unwrap().to_owned()).collect()
    };
    let ids = all("[id]", "id");
    let unique: BTreeSet<&String> = ids.iter().collect();
    assert_eq!(unique.len(), ids.len(), "an id stands twice");
    let links = all("a[href]", "href");
    for link in links.iter().filter(|link| !link.starts_with("https://")) {
        assert!(link.strip_prefix('#').is_some_and(|id| ids.iter().any(|i| i == id)), "{link}");
    }
    // Each section of each topic is in the contents; formulas are formulas, and pictures stand in the page.
    let sections =
        manual::TOPICS.iter().flat_map(|t| t.text.lines()).filter(|l| l.starts_with("## ")).count();
    assert!(all("nav ol ol a", "href").len() > sections && sections > 30, "{sections}");
    assert!(page.select(&Selector::parse("math").unwrap()).count() > 5);
    let pictures = all("img", "src");
    assert!(pictures.len() == 3 && pictures.iter().all(|src| src.starts_with("data:image/svg+xml")));
}
