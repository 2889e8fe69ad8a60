//! Every command of the README runs, and prints what the README shows.
use slipstick::solve::outcome::Motion;
use slipstick::words::Words;
use std::fs;
use std::path::Path;
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

/// Does the output hold the shown lines, in order? `...` stands for any lines, ` ... ` within a line for any text.
fn shows(output: &str, shown: &[String]) -> Result<(), String> {
    let shown: Vec<&str> = shown.iter().map(|l| l.trim_end()).collect();
    if shown.iter().all(|l| l.is_empty()) {
        return Ok(());
    }
    let lines: Vec<&str> = output.lines().map(str::trim_end).collect();
    let fits = |line: &str, pattern: &str| match pattern.split_once(" ... ") {
        Some((before, after)) => line.starts_with(before) && line.ends_with(after),
        None => line == pattern,
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

#[test]
#[cfg_attr(feature = "pdf", ignore = "the README shows a program without PDF")]
fn the_commands_of_the_readme_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("README.md")).expect("there is a README.md");
    let commands = commands(&readme);
    let folder = tempfile::tempdir().unwrap();
    let program = assert_cmd::cargo::cargo_bin("slipstick");
    let bin = program.parent().expect("the program stands in a folder");
    // The README's commands name banks and data of the repository.
    for entry in ["banks", "templates"] {
        copy(&root.join(entry), &folder.path().join(entry));
    }
    let (mut ran, mut elsewhere) = (0, 0);
    for shown in &commands {
        let word = shown.command.split_whitespace().next().unwrap_or_default();
        if word == "git" || word == "cargo" {
            elsewhere += 1; // getting and building the program: CI has just done it
            continue;
        }
        let output = Command::new("sh")
            .arg("-c")
            .arg(&shown.command)
            .current_dir(folder.path())
            .env("PATH", format!("{}:{}", bin.display(), std::env::var("PATH").unwrap_or_default()))
            .output()
            .expect("a shell runs");
        let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        let place = format!("README.md:{}: {}", shown.line, shown.command);
        let code = output.status.code().unwrap_or(-1);
        // A command may end with 1 or 3 on purpose; then the README says so in its output or text.
        assert!(code == 0 || code == 1 || code == 3, "{place}\nexit code {code}\n{err}");
        let both = format!("{out}{err}");
        if let Err(difference) =
            shows(&out, &shown.output).or_else(|e| shows(&both, &shown.output).map_err(|_| e))
        {
            panic!("{place}\n{difference}");
        }
        ran += 1;
    }
    assert!(ran > 0, "the README shows commands");
    // The pictures are those that the commands have just written; with RENEW_PICTURES=1 they are put in their place.
    let pictures = root.join("tests/readme");
    for entry in fs::read_dir(&pictures).expect("pictures of the README") {
        let picture = entry.unwrap().path();
        let name = picture.file_name().unwrap().to_string_lossy().into_owned();
        assert!(readme.contains(&format!("](tests/readme/{name})")), "{name} is shown");
        let written = fs::read(folder.path().join(&name)).expect("a command of the README writes it");
        if std::env::var("RENEW_PICTURES").is_ok() {
            fs::write(&picture, &written).unwrap();
        }
        assert!(fs::read(&picture).unwrap() == written, "tests/readme/{name} is not what the command writes");
    }
    assert_eq!(ran + elsewhere, commands.len());
    // No block of commands may hide from this test under another name.
    for (i, line) in readme.lines().enumerate() {
        let hidden = ["```sh", "```bash", "```shell"].iter().any(|b| line.trim_start().starts_with(b));
        assert!(!hidden, "README.md:{}: write ```console, so that the commands are run", i + 1);
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

/// The README's list of regimes is the program's table. A word that only the program knew could not be found by anybody: nothing
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
    let readme = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).unwrap();
    let lines = readme.lines().skip_while(|l| !l.starts_with("| regime |"));
    let found: Vec<&str> = lines.take_while(|l| l.starts_with('|')).collect();
    assert_eq!(found, wanted, "the README should have\n{}", wanted.join("\n"));
}
