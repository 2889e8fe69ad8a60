//! `slipstick solutions`: a stored set, drawn and solved again, to worked solutions for each student.
use crate::cli::args;
use crate::cli::args::Format;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::generate;
use crate::cli::lint;
use crate::cli::output;
use crate::cli::output::Made;
use crate::cli::output::Output;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::set::replay;
use crate::set::replay::Dealt;
use crate::set::store::StoredStudent;
use crate::sheet::document::Document;
use crate::sheet::document::Head;
use crate::sheet::html::Converter;
use crate::sheet::page::Sheets;
use crate::solution;
use crate::template;
use crate::words::Words;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A folder with this file was made by `solutions`, whole.
const MARKER: &str = ".slipstick-solutions";

/// Runs it.
pub fn run(args: &args::Solutions, io: &mut Io) -> Exit {
    match solutions(args, io) {
        Ok(()) => Exit::Fine,
        Err(findings) => io.findings(&findings),
    }
}

fn solutions(args: &args::Solutions, io: &mut Io) -> Result<(), Findings> {
    files::sweep_beside(&args.out);
    let set = generate::existing(&args.set)?;
    may_write(&args.out, args.force)?;
    let path = args.set.join(&set.bank.file);
    let text = files::read_text(&path)?;
    let name = path.display().to_string();
    let mut bank = banks::parse(&text, &name)?;
    let language = args.own.language.clone().unwrap_or_else(|| set.language.clone());
    let texts = banks::texts(&args.own, &language, &mut bank)?;
    let formats = output::formats(args.format.as_deref());
    let output = Output::new(&texts, &formats, "solution")?;
    let problems = replay::indices(&bank, &set.problems, "problems")?;
    let words = &texts.words;
    let sheets = Sheets::new(&texts.templates, words, &bank, &set.name, &problems)?;
    let staged = Staged::new(&args.out)?;
    let bar = files::progress(io.watched, set.students.len() as u64, "solutions");
    let make = |at: usize, student: &StoredStudent, dealt: Dealt| -> Result<(Made, Vec<String>), Finding> {
        let head = sheets.head(&student.student, &student.name, &dealt.variants);
        let mut whole = beginning(&head, &bank.title, words);
        let mut short = Vec::new();
        for (i, (index, variant)) in problems.iter().zip(&dealt.variants).enumerate() {
            let problem = &bank.problems[*index];
            let (of_one, beyond) = solution::worked(problem, variant, i + 1, words, &texts.templates)?;
            append(&mut whole, of_one, i + 1);
            if let Some(what) = beyond {
                let word = if what.is_fault() { "warning" } else { "note" };
                let page = lint::short_page(problem, variant.case, what);
                short.push(format!("{word}: problems.{}: {page}", problem.id));
            }
        }
        let mut made = output.make(at, head, whole, &mut Converter::new(words))?;
        let place = staged.path().join(&student.folder);
        let fault = |e: &std::io::Error| files::trouble(&args.out, "cannot be written", e);
        fs::create_dir(&place).map_err(|e| fault(&e))?;
        for (name, bytes) in made.files.drain(..) {
            fs::write(place.join(name), bytes).map_err(|e| fault(&e))?;
        }
        bar.inc(1);
        Ok((made, short))
    };
    let pool = output::pool(args.threads)?;
    let all = pool.install(|| replay::each(&bank, &set, &make));
    bar.finish_and_clear();
    let stored = args.set.join("set.json").display().to_string();
    let all = all.map_err(|faults| staged.named(faults.or_in_file(&stored)))?;
    let (all, short): (Vec<Made>, Vec<Vec<String>>) = all.into_iter().unzip();
    let title = format!("{}: {}, {}", words.get("sheet.solutions"), bank.title, set.name);
    let write = |name: &str, bytes: &[u8]| {
        fs::write(staged.path().join(name), bytes)
            .map_err(|e| files::trouble(&args.out.join(name), "cannot be written", &e))
    };
    for (name, bytes) in output.booklets(&title, &all)? {
        write(name, &bytes)?;
    }
    write(MARKER, b"Made by `slipstick solutions`, which may replace this folder with --force.\n")?;
    staged.finish()?;
    let out = args.out.display();
    io.line(&format!(
        "Worked solutions for {} of {} each, in {out}",
        tell::count(all.len(), "student"),
        tell::count(problems.len(), "problem")
    ));
    let files: Vec<String> = formats.iter().rev().map(|f| format!("solution.{}", f.ending())).collect();
    io.line(&format!("  one by one:    {out}/ID/ ({})", files.join(", ")));
    let booklet = Format::ALL.into_iter().rev().filter(|f| *f != Format::Md && formats.contains(f));
    let booklet: Vec<String> = booklet.map(|f| format!("{out}/booklet.{}", f.ending())).collect();
    if !booklet.is_empty() {
        io.line(&format!("  all in one:    {}", booklet.join(", ")));
    }
    let mut told: BTreeMap<&str, usize> = BTreeMap::new();
    for text in short.iter().flatten() {
        *told.entry(text).or_default() += 1;
    }
    for (text, students) in told {
        io.note(&format!("{text} (for {})", tell::count(students, "student")));
    }
    Ok(())
}

/// Title and student.
fn beginning(head: &Head, title: &str, words: &Words) -> Document {
    let mut markdown = format!("# {}: {title}\n\n", words.get("sheet.solution"));
    if !head.name.is_empty() {
        markdown.push_str(&format!("**{}**, ", template::in_markdown(&head.name)));
    }
    markdown.push_str(&format!(
        "{} {}, {} {}, {} {}\n",
        words.get("sheet.student"),
        template::in_markdown(&head.student),
        words.get("sheet.set"),
        template::in_markdown(&head.set),
        words.get("sheet.code"),
        head.code
    ));
    Document::new(markdown, Vec::new())
}

/// Puts the solution of a problem behind the others; its pictures get names of their own.
fn append(whole: &mut Document, of_one: Document, number: usize) {
    let mut markdown = of_one.markdown;
    for (name, picture) in of_one.pictures {
        let unique = format!("problem-{number}-{name}");
        markdown = markdown.replace(&format!("]({name}.svg)"), &format!("]({unique}.svg)"));
        whole.pictures.push((unique, picture));
    }
    whole.markdown.push('\n');
    whole.markdown.push_str(&markdown);
}

/// Nothing, an empty folder, or with `--force` a folder that `solutions` made; never among what students get.
fn may_write(out: &Path, force: bool) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("", what).in_file(out.display().to_string());
    files::has_a_name(out, "--out week-5-solutions")?;
    files::not_among_students(out)?;
    if out.join("set.json").exists() {
        return Err(finding("is the folder of a set").hint("give another --out for the solutions"));
    }
    let names = files::names_in(out);
    if !out.exists() || (out.is_dir() && names.is_empty()) {
        return Ok(());
    }
    if !out.is_dir() {
        return Err(finding("is a file; solutions are written to a folder"));
    }
    if !force {
        let hint = "give another --out, or --force to replace solutions that were made before";
        return Err(finding("is there already").hint(hint));
    }
    if !names.iter().any(|n| n == MARKER) {
        let hint = "--force replaces only what `slipstick solutions` made";
        return Err(finding("holds no solutions").hint(hint));
    }
    let ours = |folder: &Path, name: &str| {
        name == MARKER
            || output::BOOKLETS.contains(&name)
            || (folder.join(name).is_dir()
                && files::names_in(&folder.join(name)).iter().all(|n| {
                    n.starts_with("solution.") || (n.starts_with("problem-") && n.ends_with(".svg"))
                }))
    };
    let foreign: Vec<&str> = names.iter().map(String::as_str).filter(|n| !ours(out, n)).collect();
    if foreign.is_empty() {
        return Ok(());
    }
    let what = format!("holds what `slipstick solutions` did not make: {}", foreign.join(", "));
    Err(finding(&what).hint("move it away"))
}
