//! `slipstick grade`: submissions against a stored set, whose key is made anew before anything is graded.
use crate::cli::args;
use crate::cli::args::Attempts;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::generate;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::finding::Finding;
use crate::grade::feedback::Feedback;
use crate::grade::run;
use crate::grade::run::GradeFault;
use crate::grade::run::Options;
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;
use crate::key::SheetKey;
use crate::report::gradebook;
use crate::set::key_file;
use crate::set::replay;
use crate::set::store::StoredSet;
use crate::words::Words;
use std::fs;
use std::io;
use std::io::BufRead;
use std::io::Read;
use std::io::Write as _;
use std::path::Path;
use tempfile::NamedTempFile;

/// Files of a grading.
const MADE: [&str; 2] = ["answers.csv", "gradebook.csv"];

/// What is to be graded.
pub struct Job<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// File of submissions; `-` is standard input.
    pub submissions: &'j Path,
    /// Folder to make.
    pub out: &'j Path,
    /// Which attempt counts.
    pub attempts: Attempts,
    /// `field=header`.
    pub columns: &'j [String],
    /// Language of the reasons; that of the set if not given.
    pub language: Option<&'j str>,
    /// Replace an earlier grading.
    pub force: bool,
    /// Does a person watch?
    pub watched: bool,
}

/// What became of it.
pub struct Graded {
    /// For the terminal.
    pub summary: String,
}

/// Runs it.
pub fn run(args: &args::Grade, io: &mut Io) -> Exit {
    let job = Job {
        set: &args.set,
        submissions: &args.submissions,
        out: &args.out,
        attempts: args.attempts,
        columns: &args.columns,
        language: args.language.as_deref(),
        force: args.force,
        watched: io.watched,
    };
    match grade(&job, &mut *io.input) {
        Ok(graded) => {
            io.line(&graded.summary);
            let out = args.out.display();
            io.line(&format!(
                "  every answer: {out}/answers.csv; a row for each student: {out}/gradebook.csv"
            ));
            Exit::Fine
        }
        Err(findings) => io.findings(&findings),
    }
}

/// The set in a folder and its key, made anew and compared with what is stored.
pub fn replayed(folder: &Path) -> Result<(StoredSet, Vec<SheetKey>), Vec<Finding>> {
    let set = generate::existing(folder)?;
    let path = folder.join(&set.bank.file);
    let text = files::read_text(&path).map_err(|f| vec![f])?;
    let name = path.display().to_string();
    let bank = banks::parse(&text, &name)?;
    let in_set = |faults: Vec<Finding>| -> Vec<Finding> {
        let file = folder.join("set.json").display().to_string();
        faults
            .into_iter()
            .map(|f| if f.file.is_none() { f.in_file(&file) } else { f.in_file(&name) })
            .collect()
    };
    let keys = replay::keys(&bank, &set).map_err(in_set)?;
    let path = folder.join("key.csv");
    let stored = files::read(&path).map_err(|f| vec![f])?;
    let file = path.display().to_string();
    let mut faults: Vec<Finding> =
        key_file::compare(&stored, &keys).into_iter().map(|f| f.in_file(&file)).collect();
    if let Some(last) = faults.pop() {
        faults.push(
            last.hint("key.csv is not what the set gives: put the original back, or make the set anew"),
        );
        return Err(faults);
    }
    Ok((set, keys))
}

/// Grades.
///
/// # Errors
/// The set was changed, the file of submissions cannot be read, or the folder may not be written.
pub fn grade(job: &Job, input: &mut dyn BufRead) -> Result<Graded, Vec<Finding>> {
    let mut faults = Vec::new();
    let columns = columns(job.columns).map_err(|f| faults.extend(f)).unwrap_or_default();
    may_write(job.out, job.set, job.force).map_err(|f| faults.push(f)).ok();
    let from_pipe = job.submissions == Path::new("-");
    if !from_pipe && !job.submissions.exists() {
        let fault = Finding::new("", "there is no such file").in_file(job.submissions.display().to_string());
        faults.push(fault);
    }
    if let Some(language) = job.language {
        faults.extend(banks::words(language).err().unwrap_or_default());
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let (set, keys) = replayed(job.set)?;
    let words = match job.language {
        Some(language) => banks::words(language)?,
        None => Words::of(&set.language).unwrap_or_else(Words::english),
    };
    let names: Vec<(String, String)> =
        set.students.iter().map(|s| (s.student.clone(), s.name.clone())).collect();
    let table = KeyTable::new(keys, &names);
    let submissions = job.submissions.display().to_string();
    let spooled = spool(job.submissions, input)
        .map_err(|e| vec![files::trouble(job.submissions, "cannot be read", &e)])?;
    let path = spooled.as_ref().map_or(job.submissions, NamedTempFile::path);
    let size = fs::metadata(path).map_or(0, |m| m.len());
    let bar = files::progress(job.watched && size > 20_000_000, size * 2, "grading");
    let open = || -> io::Result<Box<dyn Read + Send>> { Ok(Box::new(fs::File::open(path)?)) };
    let options = Options {
        attempts: match job.attempts {
            Attempts::Last => run::Attempts::Last,
            Attempts::Best => run::Attempts::Best,
            Attempts::First => run::Attempts::First,
        },
        columns,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        feedback: Feedback::new(&words),
    };
    let staged = Staged::new(job.out).map_err(|f| vec![f])?;
    let answers = staged.path().join(MADE[0]);
    let written = |e: &io::Error| vec![files::trouble(&job.out.join(MADE[0]), "cannot be written", e)];
    let file = fs::File::create(&answers).map_err(|e| written(&e))?;
    let mut out = io::BufWriter::with_capacity(1 << 18, file);
    let graded = run::grade(&open, &table, &options, &mut out, &mut |read| bar.set_position(read));
    bar.finish_and_clear();
    let graded = graded.map_err(|fault| match fault {
        GradeFault::Io(e) => vec![files::trouble(job.submissions, "cannot be graded", &e)],
        GradeFault::Header(findings) => findings.into_iter().map(|f| f.in_file(&submissions)).collect(),
    })?;
    out.flush().map_err(|e| written(&e))?;
    drop(out);
    let book = staged.path().join(MADE[1]);
    fs::write(&book, gradebook::gradebook(&table, &graded)).map_err(|e| written(&e))?;
    if job.out.exists() {
        // Only these two files are ours: the folder itself stays.
        for name in MADE {
            let (from, to) = (staged.path().join(name), job.out.join(name));
            fs::rename(&from, &to).map_err(|e| vec![files::trouble(&to, "cannot be written", &e)])?;
        }
    } else {
        staged.finish().map_err(|f| vec![f])?;
    }
    Ok(Graded { summary: summary(&table, &graded) })
}

/// A pipe is read once, grading reads twice. Standard input is the caller's, who holds its lock.
fn spool(path: &Path, input: &mut dyn BufRead) -> io::Result<Option<NamedTempFile>> {
    let is_pipe = path == Path::new("-") || !fs::metadata(path)?.is_file();
    if !is_pipe {
        return Ok(None);
    }
    let mut file = NamedTempFile::new()?;
    if path == Path::new("-") {
        io::copy(input, file.as_file_mut())?;
    } else {
        io::copy(&mut fs::File::open(path)?, file.as_file_mut())?;
    }
    Ok(Some(file))
}

fn columns(typed: &[String]) -> Result<Vec<(String, String)>, Vec<Finding>> {
    let mut found = Vec::new();
    let mut faults = Vec::new();
    for text in typed {
        match text.split_once('=') {
            Some((role, header)) if !role.trim().is_empty() && !header.trim().is_empty() => {
                let header = header.trim().trim_matches('"');
                found.push((role.trim().to_lowercase(), header.to_owned()));
            }
            _ => faults.push(
                Finding::new("--columns", format!("`{text}` maps nothing"))
                    .hint("write a field, `=` and a header, such as student=\"Email Address\""),
            ),
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

/// Nothing, an empty folder, or with `--force` a folder with an earlier grading.
fn may_write(out: &Path, set: &Path, force: bool) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("", what).in_file(out.display().to_string());
    files::not_among_students(out)?;
    let same = fs::canonicalize(out).ok().zip(fs::canonicalize(set).ok()).is_some_and(|(a, b)| a == b);
    if same || out.join("set.json").exists() {
        return Err(finding("is the folder of a set").hint("give another --out for the grades"));
    }
    if !out.exists() || (out.is_dir() && files::names_in(out).is_empty()) {
        return Ok(());
    }
    if !out.is_dir() {
        return Err(finding("is a file; grades are written to a folder"));
    }
    if !force {
        let hint = "give another --out, or --force to replace answers.csv and gradebook.csv";
        return Err(finding("is there already").hint(hint));
    }
    let header = run::ANSWERS_HEADER.trim_end();
    let mut start = vec![0; header.len()];
    let ours = fs::File::open(out.join(MADE[0])).and_then(|mut f| f.read_exact(&mut start)).is_ok()
        && start == header.as_bytes();
    if ours {
        Ok(())
    } else {
        Err(finding("holds no earlier grading").hint("--force replaces only what grade made"))
    }
}

fn summary(table: &KeyTable, graded: &run::Graded) -> String {
    let form = if graded.wide { "wide" } else { "long" };
    let mut text = format!(
        "{} in {form} form:",
        tell::count(usize::try_from(graded.cells).unwrap_or(usize::MAX), "answer cell")
    );
    let mut first = true;
    for verdict in Verdict::ALL {
        let n = graded.count(*verdict);
        if n > 0 {
            text.push_str(if first { " " } else { ", " });
            first = false;
            text.push_str(&format!("{n} {verdict}"));
        }
    }
    text.push('\n');
    let mut rows = vec![
        ["part", "right", "wrong", "unreadable", "blank", "right of those that count"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (column, counts) in table.columns.iter().zip(&graded.by_column) {
        let of = |verdicts: &[Verdict]| verdicts.iter().map(|v| counts[*v as usize]).sum::<u64>();
        let right = of(&[Verdict::Right]);
        let wrong =
            of(&[Verdict::Wrong, Verdict::WrongDirection, Verdict::WrongDimension, Verdict::MissingUnit]);
        let unreadable = of(&[Verdict::Unreadable]);
        let counting = right + wrong + unreadable;
        rows.push(vec![
            format!("{}.{}", column.number, column.part),
            right.to_string(),
            wrong.to_string(),
            unreadable.to_string(),
            of(&[Verdict::Blank]).to_string(),
            (right * 100).checked_div(counting).map_or_else(|| "-".to_owned(), |p| format!("{p} %")),
        ]);
    }
    text.push_str(tell::table(&rows, &[0]).trim_end());
    let handed =
        graded.points.chunks(table.columns.len().max(1)).filter(|p| p.iter().any(Option::is_some)).count();
    text.push_str(&format!("\n  {handed} of {} handed in.", tell::count(table.students.len(), "student")));
    if !graded.unused_columns.is_empty() {
        text.push_str(&format!(" Columns not used: {}.", graded.unused_columns.join(", ")));
    }
    if graded.untimed > 0 {
        let parts = tell::count(usize::try_from(graded.untimed).unwrap_or(usize::MAX), "answer");
        text.push_str(&format!(
            "\n  The attempts at {parts} were ordered by row, because a submitted_at cannot be read."
        ));
    }
    text
}
