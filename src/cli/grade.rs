//! `slipstick grade`: submissions against a stored set, whose key is made anew before anything is graded.
use crate::bank;
use crate::bank::Bank;
use crate::bank::load;
use crate::cli::args;
use crate::cli::args::Attempts;
use crate::cli::args::Own;
use crate::cli::args::Reports;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::generate;
use crate::cli::graded;
use crate::cli::report;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::draw::stream;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::feedback::Feedback;
use crate::grade::rules::Rules;
use crate::grade::run;
use crate::grade::run::GradeFault;
use crate::grade::run::Options;
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;
use crate::key::SheetKey;
use crate::policy::Counts;
use crate::policy::Policy;
use crate::policy::Unread;
use crate::report::gradebook;
use crate::set::grading;
use crate::set::grading::BASIS;
use crate::set::grading::Grading;
use crate::set::key_file;
use crate::set::replay;
use crate::set::store;
use crate::set::store::StoredSet;
use crate::words::Words;
use std::fs;
use std::io;
use std::io::BufRead;
use std::io::Read;
use std::io::Write as _;
use std::path::Path;
use std::path::PathBuf;
use tempfile::NamedTempFile;

/// Every answer with its verdict.
pub const ANSWERS: &str = "answers.csv";
/// A row for each student.
pub const GRADEBOOK: &str = "gradebook.csv";
/// What the grading was made from.
pub const GRADING: &str = "grading.json";
/// The course file within the basis of a grading; those that a regrading laid over it are `course-2.yaml` and so on.
pub const COURSE: &str = "course.yaml";
/// What the folder of a grading may hold beside its reports; anything else there is somebody's own.
const OURS: [&str; 8] = [
    ANSWERS,
    GRADEBOOK,
    GRADING,
    graded::CHANGES,
    "basis/",
    "basis/set.json",
    "basis/bank.yaml",
    "basis/key.csv",
];

/// What is to be graded.
pub struct Job<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// File of submissions; `-` is standard input.
    pub submissions: &'j Path,
    /// Folder to make.
    pub out: &'j Path,
    /// Which attempt counts, over bank and course.
    pub attempts: Option<Attempts>,
    /// Course files, each over those before it.
    pub courses: &'j [PathBuf],
    /// `field=header`.
    pub columns: &'j [String],
    /// Language of the reasons; that of the set if not given.
    pub language: Option<&'j str>,
    /// Are reports made, too?
    pub reports: Reports,
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
        courses: args.course.as_slice(),
        columns: &args.columns,
        language: args.language.as_deref(),
        reports: args.reports,
        force: args.force,
        watched: io.watched,
    };
    match grade(&job, &mut *io.input) {
        Ok(graded) => {
            io.line(&graded.summary);
            let out = args.out.display();
            io.line(&format!(
                "  every answer: {out}/{ANSWERS}; a row for each student: {out}/{GRADEBOOK}; why: slipstick explain {out} STUDENT PROBLEM"
            ));
            Exit::Fine
        }
        Err(findings) => io.findings(&findings),
    }
}

/// A set, its bank and its keys.
pub struct Replayed {
    /// What was drawn.
    pub set: StoredSet,
    /// The bank beside it.
    pub bank: Bank,
    /// The keys, made anew; of a set that an earlier version drew those that are stored.
    pub keys: Vec<SheetKey>,
    /// Of such a set: that it was not drawn again, and what its key was held against.
    pub not_drawn: Option<String>,
}

/// The set in a folder and its key, made anew and compared with what is stored. A set of an earlier version of the drawing is not
/// drawn again: its key is the stored one, which must have the hash that was stored with it.
///
/// # Errors
/// The set is not what it was made as.
pub fn replayed(folder: &Path) -> Result<Replayed, Findings> {
    let set = generate::existing(folder)?;
    let path = folder.join(&set.bank.file);
    let text = files::read_text(&path)?;
    let name = path.display().to_string();
    let bank = banks::parse(&text, &name)?;
    let in_set = |faults: Findings| -> Findings {
        let file = folder.join("set.json").display().to_string();
        faults
            .into_iter()
            .map(|f| if f.file.is_none() { f.in_file(&file) } else { f.in_file(&name) })
            .collect()
    };
    let mut keys = replay::keys(&bank, &set).map_err(in_set)?;
    let path = folder.join("key.csv");
    let stored = files::read(&path)?;
    let file = path.display().to_string();
    let earlier = replay::is_earlier(&set);
    let seal = store::seal(&files::read_text(&folder.join("set.json"))?).filter(|_| earlier);
    let hash = load::hash(&String::from_utf8_lossy(&stored));
    if let Some(seal) = seal.as_ref().filter(|seal| **seal != hash) {
        let short = |hash: &str| hash.chars().take(12).collect::<String>();
        let what = format!(
            "was changed: its SHA-256 is {}…, that of the set's key is {}…",
            short(&hash),
            short(seal)
        );
        return Err(Finding::new("", what)
            .in_file(file)
            .hint("put the original back, or make the set anew")
            .into());
    }
    let (other, faults) = match earlier {
        true => match key_file::put_stored(&stored, &mut keys, seal.is_some()) {
            Ok(other) => (other, Findings::default()),
            Err(faults) => (0, faults),
        },
        false => (0, key_file::compare(&stored, &keys)),
    };
    let mut faults: Findings = faults.in_file(&file);
    if let Some(last) = faults.pop() {
        faults.push(last.hint(match earlier {
            true => format!(
                "put the original back; if it is, grade with the version that made it: {}",
                set.program
            ),
            false => {
                "key.csv is not what the set gives: put the original back, or make the set anew".to_owned()
            }
        }));
        return Err(faults);
    }
    let not_drawn = earlier.then(|| {
        let held = match seal {
            Some(_) => "which has the SHA-256 that is stored with the set",
            None => "which agrees with what the stored data give",
        };
        let mut told = format!(
            "The set was drawn by draw version {}, this program has {}: it was not replayed. Its key is the stored one, {held}.",
            set.draw_version,
            stream::DRAW_VERSION
        );
        if other > 0 {
            let answers = tell::count(other, "answer");
            told.push_str(&format!(" By this version the stored data would give {answers} of it otherwise."));
        }
        told
    });
    Ok(Replayed { set, bank, keys, not_drawn })
}

/// Grades.
///
/// # Errors
/// The set was changed, the file of submissions cannot be read, or the folder may not be written.
pub fn grade(job: &Job, input: &mut dyn BufRead) -> Result<Graded, Findings> {
    let mut faults = Findings::default();
    columns(job.columns).map_err(|f| faults.extend(f)).ok();
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
    let Replayed { set, bank, keys, not_drawn } = replayed(job.set)?;
    let text = |name: &str| files::read_text(&job.set.join(name)).map_err(Findings::from);
    let (set_text, bank_text, key_text) = (text("set.json")?, text(&set.bank.file)?, text("key.csv")?);
    let replayed = not_drawn.is_none();
    let made = make(job, Basis { set, bank, keys, replayed, set_text, bank_text, key_text }, input)?;
    let mut summary = summary(&made.table, &made.graded, &made.policy);
    if let Some(told) = not_drawn {
        summary.push_str(&format!("\n  {told}"));
    }
    let out = job.out.display().to_string();
    match made.reports()? {
        Some(report) => summary.push_str(&format!("\n{}", report.told(&out))),
        None if job.reports == Reports::Auto => {
            summary.push_str(&format!(
                "\n  So many answers: for reports and feedback run `slipstick report {out}`."
            ));
        }
        None => {}
    }
    if made.graded.cells == made.graded.count(Verdict::Blank) {
        let file = job.submissions.display();
        summary.push_str(&format!("\n  warning: there is no answer in {file}: is it the right export?"));
    }
    let gone = made.without_reports() && report::MADE.iter().any(|name| job.out.join(name).exists());
    made.finish()?;
    if gone {
        summary.push_str(&format!(
            "\n  The earlier report and feedback in {out} told of the grades before, and are gone."
        ));
    }
    Ok(Graded { summary })
}

/// What answers are graded by, and the texts of it that are kept beside the grades.
pub struct Basis {
    /// What was drawn.
    pub set: StoredSet,
    /// The bank.
    pub bank: Bank,
    /// The keys.
    pub keys: Vec<SheetKey>,
    /// Was the set drawn again?
    pub replayed: bool,
    /// set.json.
    pub set_text: String,
    /// The bank's file.
    pub bank_text: String,
    /// key.csv.
    pub key_text: String,
}

/// A grading that is whole, and not yet in its place.
pub struct Made {
    staged: Staged,
    out: PathBuf,
    table: KeyTable,
    graded: run::Graded,
    policy: Policy,
    grading: Grading,
    reports: Reports,
}

/// Up to so many answers, reports are made with the grades, and what was written is hashed.
const REPORTED: u64 = 300_000;

impl Made {
    /// Where it lies until it is put in its place.
    pub fn folder(&self) -> &Path {
        self.staged.path()
    }
    /// The settings by which it was made.
    pub fn policy(&self) -> &Policy {
        &self.policy
    }
    /// What it was made from.
    pub fn grading(&self) -> &Grading {
        &self.grading
    }
    /// Makes the reports, if there are to be any: what stands out.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn reports(&self) -> Result<Option<report::Summary>, Findings> {
        let made = match self.reports {
            Reports::Yes => true,
            Reports::No => false,
            Reports::Auto => self.graded.cells <= REPORTED,
        };
        if !made {
            return Ok(None);
        }
        let folder = self.staged.path();
        let own = Own { templates: None, language: Some(self.grading.language.clone()) };
        let reported = report::make(folder, folder, &own, None).map_err(|f| self.staged.named(f))?;
        Ok(Some(reported))
    }
    /// Are there no reports in it?
    fn without_reports(&self) -> bool {
        !self.staged.path().join("report.html").exists()
    }
    /// Puts it in its place.
    ///
    /// # Errors
    /// A file cannot be put there.
    pub fn finish(self) -> Result<(), Findings> {
        // Once more: it may have come while answers were graded.
        only_ours(&self.out).and_then(|()| self.staged.finish()).map_err(Findings::from)
    }
}

/// Grades by a basis, beside the place where the grading is to be.
///
/// # Errors
/// The file of submissions cannot be read, the course is faulty, or the folder cannot be written.
pub fn make(job: &Job, basis: Basis, input: &mut dyn BufRead) -> Result<Made, Findings> {
    let columns = columns(job.columns)?;
    let Basis { set, bank, keys, replayed, set_text, bank_text, key_text } = basis;
    let language = job.language.unwrap_or(&set.language);
    let words = match job.language {
        Some(language) => banks::words(language)?,
        None => Words::of(language).unwrap_or_else(Words::english),
    };
    let courses = read_courses(job.courses)?;
    let policy = policy(&bank.grading, &courses, job.attempts)?;
    let names: Vec<(String, String)> =
        set.students.iter().map(|s| (s.student.clone(), s.name.clone())).collect();
    let mut table = KeyTable::new(keys, &names);
    let settings = courses
        .last()
        .map_or_else(|| job.set.join(&set.bank.file).display().to_string(), |(file, _)| file.clone());
    table.take_points(&policy);
    let rules = Rules::new(&table, &policy).map_err(|faults| faults.in_file(&settings))?;
    let submissions = job.submissions.display().to_string();
    let spooled =
        spool(job.submissions, input).map_err(|e| files::trouble(job.submissions, "cannot be read", &e))?;
    let path = spooled.as_ref().map_or(job.submissions, NamedTempFile::path);
    let size = fs::metadata(path).map_or(0, |m| m.len());
    let first = files::stamp(path);
    let bar = files::progress(job.watched && size > 20_000_000, size * rules.reads(), "grading");
    let open = || -> io::Result<Box<dyn Read + Send>> { Ok(Box::new(fs::File::open(path)?)) };
    let options = Options {
        columns,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        feedback: Feedback::new(&words),
    };
    let staged = Staged::new(job.out)?;
    let written = |name: &str| {
        let path = job.out.join(name);
        move |e: &io::Error| files::trouble(&path, "cannot be written", e)
    };
    let fault = written(ANSWERS);
    let file = fs::File::create(staged.path().join(ANSWERS)).map_err(|e| fault(&e))?;
    let mut out = io::BufWriter::with_capacity(1 << 18, file);
    let graded = run::grade(&open, &table, &rules, &options, &mut out, &mut |read| bar.set_position(read));
    bar.finish_and_clear();
    let graded = graded.map_err(|why| match why {
        GradeFault::Io(e) => Findings::from(files::trouble(job.submissions, "cannot be graded", &e)),
        GradeFault::Write(e) => fault(&e).into(),
        GradeFault::Header(findings) => findings.in_file(&submissions),
    })?;
    // Which attempt counts was found in an earlier walk over the file.
    if files::stamp(path) != first {
        let changed = Finding::new("", "was changed while it was graded").in_file(submissions);
        return Err(changed.hint("grade it again, or a copy of it").into());
    }
    out.flush().map_err(|e| fault(&e))?;
    drop(out);
    let put = |name: &str, bytes: &[u8]| {
        let fault = written(name);
        fs::write(staged.path().join(name), bytes).map_err(|e| fault(&e))
    };
    put(GRADEBOOK, &gradebook::gradebook(&table, &graded, &policy))?;
    let basis = Path::new(BASIS);
    fs::create_dir(staged.path().join(basis)).map_err(|e| written(BASIS)(&e))?;
    for (name, text) in
        [("set.json", &set_text), (set.bank.file.as_str(), &bank_text), ("key.csv", &key_text)]
    {
        put(&format!("{BASIS}/{name}"), text.as_bytes())?;
    }
    for (i, (_, text)) in courses.iter().enumerate() {
        put(&format!("{BASIS}/{}", course_name(i)), text.as_bytes())?;
    }
    let hash = |path: &Path| match graded.cells <= REPORTED {
        true => graded::hash(path).map(Some).map_err(|f| staged.named(f.into())),
        false => Ok(None),
    };
    let verdicts = Verdict::ALL.iter().map(|v| (v.as_str().to_owned(), graded.count(*v).into())).collect();
    let grading = Grading {
        format: grading::FORMAT,
        program: tell::program(),
        draw_version: set.draw_version,
        replayed,
        set: set.name.clone(),
        seed: set.seed,
        bank: bank.id.clone(),
        bank_sha256: bank.hash.clone(),
        key_sha256: load::hash(&key_text),
        course_sha256: (!courses.is_empty())
            .then(|| load::hash(&courses.iter().map(|(_, text)| text.as_str()).collect::<String>())),
        attempts: job.attempts.map(|a| counts(a).as_str().to_owned()),
        language: words.language().to_owned(),
        submissions: job.submissions.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        submissions_bytes: size,
        submissions_sha256: hash(path)?,
        answers_sha256: hash(&staged.path().join(ANSWERS))?,
        gradebook_sha256: hash(&staged.path().join(GRADEBOOK))?,
        columns: job.columns.to_vec(),
        cells: graded.cells,
        verdicts,
        wide: graded.wide,
        untimed: graded.untimed,
        undated: graded.undated,
        unused_columns: graded.unused_columns.clone(),
    };
    put(GRADING, grading.text().as_bytes())?;
    Ok(Made { staged, out: job.out.to_owned(), table, graded, policy, grading, reports: job.reports })
}

/// Name of the course file number `i` (from 0) in a basis.
fn course_name(i: usize) -> String {
    if i == 0 { COURSE.to_owned() } else { format!("course-{}.yaml", i + 1) }
}

/// The course files of a grading, in the order in which they were laid over each other.
pub fn courses(graded: &Path) -> Vec<PathBuf> {
    let files = (0..).map(|i| graded.join(BASIS).join(course_name(i)));
    files.take_while(|path| path.is_file()).collect()
}

/// Course files: name and text.
///
/// # Errors
/// One cannot be read.
pub fn read_courses(paths: &[PathBuf]) -> Result<Vec<(String, String)>, Findings> {
    let read = |path: &PathBuf| Ok((path.display().to_string(), files::read_text(path)?));
    paths.iter().map(read).collect()
}

/// The settings that bear on marks: those of the bank, over them those of courses (name and text of each file), over them
/// what the command says.
///
/// # Errors
/// All that is wrong with the course file.
pub fn policy(
    bank: &Policy,
    courses: &[(String, String)],
    attempts: Option<Attempts>,
) -> Result<Policy, Findings> {
    let mut policy = bank.clone();
    for (file, text) in courses {
        policy = bank::course::course(text, file, &policy)?;
    }
    if let Some(attempts) = attempts {
        policy.attempts.counts = counts(attempts);
    }
    Ok(policy)
}

fn counts(typed: Attempts) -> Counts {
    match typed {
        Attempts::Last => Counts::Last,
        Attempts::Best => Counts::Best,
        Attempts::First => Counts::First,
    }
}

/// The whole folder is exchanged at once: nothing may be in it that is not a grading's, such as notes of somebody else.
fn only_ours(out: &Path) -> Result<(), Finding> {
    let students = report::folders(out);
    let courses: Vec<String> =
        (0..courses(out).len()).map(|i| format!("{BASIS}/{}", course_name(i))).collect();
    let ours = |name: &str| {
        OURS.contains(&name) || courses.iter().any(|c| c == name) || report::is_ours(name, &students)
    };
    let foreign = files::foreign(out, &ours);
    if foreign.is_empty() { Ok(()) } else { Err(files::not_ours(out, &foreign, "grade")) }
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

fn columns(typed: &[String]) -> Result<Vec<(String, String)>, Findings> {
    let mut found = Vec::new();
    let mut faults = Findings::default();
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
    faults.into_result(found)
}

/// Nothing, an empty folder, or with `--force` a folder with an earlier grading.
fn may_write(out: &Path, set: &Path, force: bool) -> Result<(), Finding> {
    let finding = |what: &str| Finding::new("", what).in_file(out.display().to_string());
    files::not_among_students(out)?;
    files::has_a_name(out, "grades")?;
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
        let hint = "give another --out, or --force to replace an earlier grading";
        return Err(finding("is there already").hint(hint));
    }
    // What every version of answers.csv begins with.
    let header = "line,column,student,problem,part,answer,verdict,";
    let mut start = vec![0; header.len()];
    let ours = fs::File::open(out.join(ANSWERS)).and_then(|mut f| f.read_exact(&mut start)).is_ok()
        && start == header.as_bytes();
    if ours {
        only_ours(out)
    } else {
        Err(finding("holds no earlier grading").hint("--force replaces only what grade made"))
    }
}

fn summary(table: &KeyTable, graded: &run::Graded, policy: &Policy) -> String {
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
    if graded.respelled > 0 {
        let answers = tell::count(usize::try_from(graded.respelled).unwrap_or(usize::MAX), "answer");
        text.push_str(&format!(
            "\n  {answers} came under an id that differs from the roster's in upper and lower case alone, and count."
        ));
    }
    if graded.undated > 0 {
        let answers = tell::count(usize::try_from(graded.undated).unwrap_or(usize::MAX), "answer");
        text.push_str(&format!(
            "\n  {answers} that count have no submitted_at that can be read, and are taken as {}.",
            policy.late.unread.map_or("in time", Unread::as_str)
        ));
    }
    if graded.untimed > 0 {
        let parts = tell::count(usize::try_from(graded.untimed).unwrap_or(usize::MAX), "answer");
        text.push_str(&format!(
            "\n  The attempts at {parts} were ordered by row, because a submitted_at cannot be read."
        ));
    }
    text
}
