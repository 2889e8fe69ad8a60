//! Grading a file of submissions by a set: a folder with every answer's verdict, and with copies of all that it was made from.
use crate::answer::quiz::{self, Quiz};
use crate::bank::{Bank, load};
use crate::finding::{Finding, Findings};
use crate::folder::files::NewFolder;
use crate::folder::handed_in::JoinedFiles;
use crate::folder::quiz::{MatchedQuiz, StudentPart};
use crate::folder::reports::ReportMade;
use crate::folder::set::Replayed;
use crate::folder::staged::Staged;
use crate::folder::{self, Progress, banks, files, graded, handed_in, names, reports, set};
use crate::grade::feedback::Feedback;
use crate::grade::rules::Rules;
use crate::grade::run::{GradeFault, Options};
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;
use crate::grade::{row, run};
use crate::key::{FindWrong, SheetKey};
use crate::policy::{Counts, Policy};
use crate::report::{gradebook, summary};
use crate::set::grading::{self, StoredGrading};
use crate::set::key_file;
use crate::set::replay::WrongOnDemand;
use crate::set::store::StoredSet;
use crate::words::Words;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, Read, Write};
use std::path::{Path, PathBuf};
use std::{fs, io};
use tempfile::NamedTempFile;

/// Are reports made with the grades?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reports {
    /// Up to 300,000 answers.
    Auto,
    /// Always.
    Yes,
    /// Never.
    No,
}

pub struct GradeOrder<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// File of submissions; `-` is standard input.
    pub submissions: &'j Path,
    /// Folder to make.
    pub out: &'j Path,
    /// Which attempt counts, over bank and course.
    pub attempts: Option<Counts>,
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
    /// Is told how far it is.
    pub progress: &'j dyn Progress,
}

/// Grades: what came out, in words. Errors: the set was changed, the file of submissions cannot be read, or the folder may not be
/// written.
pub fn grade(order: &GradeOrder, input: &mut dyn BufRead) -> Result<String, Findings> {
    let mut faults = Findings::default();
    columns(order.columns).map_err(|f| faults.extend(f)).ok();
    may_write(order.out, order.force).map_err(|f| faults.extend(f)).ok();
    let from_pipe = order.submissions == Path::new("-");
    if !from_pipe && !order.submissions.exists() {
        faults.push(Finding::of_file(order.submissions, "there is no such file"));
    }
    if let Some(language) = order.language {
        faults.extend(banks::words(language).err().unwrap_or_default());
    }
    faults.into_result(())?;
    let Replayed { set, bank, keys, not_drawn, whole } = set::for_grading(order.set)?;
    let text = |name: &str| files::read_text(&order.set.join(name));
    let (set_text, bank_text, key_text) = (text(names::SET)?, text(&set.bank.file)?, text(names::KEY)?);
    let replayed = not_drawn.is_none();
    let asked = None;
    let basis = Basis { set, bank, keys, whole, replayed, set_text, bank_text, key_text, asked };
    let made = make(order, basis, input)?;
    let mut summary = summary::grades(&made.table, &made.graded, &made.policy);
    if let Some(told) = not_drawn {
        summary.push_str(&format!("\n  {told}"));
    }
    summary.push_str(&made.told);
    let out = order.out.display().to_string();
    match made.reports()? {
        Some(report) => summary.push_str(&format!("\n{}", report.told(&out))),
        None if order.reports == Reports::Auto => {
            summary.push_str(&format!(
                "\n  So many answers: for reports and feedback run `slipstick report {out}`."
            ));
        }
        None => {}
    }
    if made.graded.cells == made.graded.count(Verdict::Blank) {
        let file = order.submissions.display();
        summary.push_str(&format!("\n  warning: there is no answer in {file}: is it the right export?"));
    }
    let reported = made.folder().join(names::REPORT).exists();
    let gone = !reported && names::OF_REPORT.iter().any(|name| order.out.join(name).exists());
    made.finish()?;
    if gone {
        summary.push_str(&format!(
            "\n  The earlier report and feedback in {out} told of the grades before, and are gone."
        ));
    }
    Ok(summary)
}

/// What answers are graded by, and the texts of it that are kept beside the grades.
pub struct Basis {
    /// What was drawn.
    pub set: StoredSet,
    pub bank: Bank,
    pub keys: Vec<SheetKey>,
    /// By both roads, and with wrong methods? Else these are found when an answer is wrong.
    pub whole: bool,
    /// Was the set drawn again?
    pub replayed: bool,
    /// set.json.
    pub set_text: String,
    /// The bank's file.
    pub bank_text: String,
    /// key.csv.
    pub key_text: String,
    /// Where `set` has the variants that a quiz asked: the set of which they are, and its keys.
    pub asked: Option<(StoredSet, Vec<SheetKey>)>,
}

/// A grading that is whole, and not yet in its place.
pub struct StagedGrading {
    staged: Staged,
    out: PathBuf,
    table: KeyTable,
    graded: run::Graded,
    /// The settings by which it was made.
    pub policy: Policy,
    /// What it was made from.
    pub grading: StoredGrading,
    reports: Reports,
    /// What there is to say of files and quizzes from which the answers come.
    told: String,
}

impl StagedGrading {
    /// Where it lies until it is put in its place.
    pub fn folder(&self) -> &Path {
        self.staged.path()
    }
    /// Makes the reports, if there are to be any: what stands out. Errors: a file cannot be written.
    pub fn reports(&self) -> Result<Option<ReportMade>, Findings> {
        if self.reports == Reports::No || self.reports == Reports::Auto && self.graded.cells > REPORTED {
            return Ok(None);
        }
        let folder = self.staged.path();
        let made = reports::make(folder, folder, None, None, None, true).map_err(|f| self.staged.named(f))?;
        Ok(Some(made))
    }
    /// Puts it in its place. Errors: a file cannot be put there.
    pub fn finish(self) -> Result<(), Findings> {
        // Once more: it may have come while answers were graded.
        let foreign = foreign(&self.out);
        if !foreign.is_empty() {
            return Err(files::not_ours(&self.out, &foreign, "grade").into());
        }
        Ok(self.staged.finish()?)
    }
}

/// Up to so many answers, reports are made with the grades, and what was written is hashed.
const REPORTED: u64 = 300_000;

/// Grades by a basis, beside the place where the grading is to be. Errors: the file of submissions cannot be read, the course is
/// faulty, or the folder cannot be written.
pub fn make(order: &GradeOrder, basis: Basis, input: &mut dyn BufRead) -> Result<StagedGrading, Findings> {
    let columns = columns(order.columns)?;
    let language = order.language.unwrap_or(&basis.set.language);
    let words = match order.language {
        Some(language) => banks::words(language)?,
        None => Words::of(language).unwrap_or_else(Words::english),
    };
    let courses = graded::read_courses(order.courses)?;
    let policy = graded::policy(&basis.bank.grading, &courses, order.attempts)?;
    let mut options = Options {
        columns,
        quiz: false,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        feedback: Feedback::new(&words),
        wrong: None,
    };
    let (spooled, handed_in) = spool(order.submissions, &basis.set.name, input)?;
    let submitted = spooled.as_ref().map_or(order.submissions, NamedTempFile::path);
    // Who says which column is which has no download of a quiz, nor have the files of a class.
    let alone = order.columns.is_empty() && handed_in.is_none();
    let quiz = if alone { read_quiz(order, submitted)? } else { None };
    let mut told = handed_in.as_ref().map_or_else(String::new, JoinedFiles::told);
    options.quiz = quiz.is_some();
    let (basis, of_quiz) = match &quiz {
        Some(quiz) => {
            let basis = match basis.whole {
                true => basis,
                false => Basis { keys: set::replayed(order.set)?.keys, whole: true, ..basis },
            };
            let (basis, file, taken) = of_quiz(order, quiz, basis, (&policy, &options))?;
            told.push_str(&taken.told);
            (basis, Some((file, taken)))
        }
        None => (basis, None),
    };
    let path = of_quiz.as_ref().map_or(submitted, |(file, _)| file.path());
    let Basis { set, bank, keys, whole, replayed, set_text, bank_text, key_text, .. } = basis;
    let on_demand = if whole { None } else { Some(WrongOnDemand::new(&bank, &set)?) };
    let options = Options { wrong: on_demand.as_ref().map(|all| all as &dyn FindWrong), ..options };
    let table = table(&set, keys, &policy);
    let in_bank = || order.set.join(&set.bank.file).display().to_string();
    let settings = courses.last().map_or_else(in_bank, |(file, _)| file.clone());
    let rules = Rules::new(&table, &policy).map_err(|faults| faults.in_file(settings))?;
    let staged = Staged::new(order.out)?;
    let graded = answers(order, path, &table, &rules, &options, &staged)?;
    let put = |name: &str, bytes: &[u8]| staged.write(name, bytes);
    put(names::GRADEBOOK, &gradebook::gradebook(&table, &graded, &policy))?;
    let kept = [(names::SET, &set_text), (set.bank.file.as_str(), &bank_text), (names::KEY, &key_text)];
    keep_basis(&staged, order.out, kept, &courses)?;
    if let Some(handed_in) = &handed_in {
        put(grading::JOINED, &handed_in.kept)?;
    }
    let hash = |path: &Path| match graded.cells <= REPORTED {
        true => graded::hash(path).map(Some).map_err(|f| staged.named(f.into())),
        false => Ok(None),
    };
    let verdicts = Verdict::ALL.iter().map(|v| (v.as_str().to_owned(), graded.count(*v).into())).collect();
    let course_text = courses.iter().map(|(_, text)| text.as_str()).collect::<String>();
    let grading = StoredGrading {
        format: grading::FORMAT,
        program: folder::program(),
        draw_version: set.draw_version,
        replayed,
        set: set.name.clone(),
        seed: set.seed,
        bank: bank.id.clone(),
        bank_sha256: bank.hash.clone(),
        key_sha256: load::hash(&key_text),
        course_sha256: (!courses.is_empty()).then(|| load::hash(&course_text)),
        attempts: order.attempts.map(|counts| counts.as_str().to_owned()),
        language: words.language().to_owned(),
        submissions: order.submissions.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        submissions_files: handed_in.as_ref().map(|all| all.files),
        submissions_bytes: fs::metadata(submitted).map_or(0, |m| m.len()),
        submissions_sha256: hash(submitted)?,
        quiz: quiz.is_some(),
        canvas: of_quiz.as_ref().map(|(_, taken)| taken.canvas.clone()).unwrap_or_default(),
        moodle: of_quiz.as_ref().and_then(|(_, taken)| taken.moodle.clone()),
        answers_sha256: hash(&staged.path().join(names::ANSWERS))?,
        gradebook_sha256: hash(&staged.path().join(names::GRADEBOOK))?,
        columns: order.columns.to_vec(),
        cells: graded.cells,
        verdicts,
        wide: graded.wide,
        untimed: graded.untimed,
        undated: graded.undated,
        unused_columns: graded.unused_columns.clone(),
    };
    put(names::GRADING, grading.text().as_bytes())?;
    let (out, reports) = (order.out.to_owned(), order.reports);
    Ok(StagedGrading { staged, out, table, graded, policy, grading, reports, told })
}

/// Keeps beside the grades what was graded by: these files, and the settings of the courses.
fn keep_basis(
    staged: &Staged,
    out: &Path,
    files: [(&str, &String); 3],
    courses: &[(String, String)],
) -> Result<(), Findings> {
    let basis = out.join(names::BASIS);
    fs::create_dir(staged.path().join(names::BASIS)).map_err(files::trouble(&basis, "cannot be written"))?;
    let files = files.into_iter().map(|(name, text)| (name.to_owned(), text));
    for (name, text) in files.chain(courses.iter().enumerate().map(|(i, (_, t))| (names::course(i), t))) {
        staged.write(&format!("{}/{name}", names::BASIS), text.as_bytes())?;
    }
    Ok(())
}

/// The keys with the names of the students and the points of the course.
fn table(set: &StoredSet, keys: Vec<SheetKey>, policy: &Policy) -> KeyTable {
    let names: Vec<(String, String)> =
        set.students.iter().map(|s| (s.student.clone(), s.name.clone())).collect();
    let mut table = KeyTable::new(keys, &names);
    table.take_points(policy);
    table
}

/// Is it the download of a quiz?
fn read_quiz(order: &GradeOrder, path: &Path) -> Result<Option<Quiz>, Findings> {
    let file = order.submissions.display().to_string();
    // What cannot be read is told by grading.
    let read = fs::File::open(path).and_then(|file| quiz::read(Box::new(file)));
    read.unwrap_or(Ok(None)).map_err(|fault| fault.in_file(file).into())
}

/// The basis in which each student has the variants that the quiz asked, and the answers as a file of submissions.
///
/// Where a part was answered in several variants, that of the last or the first attempt counts, or the best one: then all are
/// graded, and for each part that with the most points is taken.
fn of_quiz(
    order: &GradeOrder,
    quiz: &Quiz,
    basis: Basis,
    (policy, options): (&Policy, &Options),
) -> Result<(Basis, NamedTempFile, MatchedQuiz), Findings> {
    let file = order.submissions.display().to_string();
    let fault = files::trouble(order.submissions, "cannot be read");
    let (set, keys, before) = match &basis.asked {
        Some((set, keys)) => (set, keys, Some(&basis.set)),
        None => (&basis.set, &basis.keys, None),
    };
    let taken = MatchedQuiz::new(quiz, (set, keys), before, policy).map_err(|f| f.in_file(&file))?;
    let mut spooled = NamedTempFile::new().map_err(fault)?;
    spooled.write_all(&taken.text).map_err(fault)?;
    // Which variant counts was settled when it was first graded.
    if basis.asked.is_some() {
        return Ok((basis, spooled, taken));
    }
    let points_of = |nth: usize| -> Result<BTreeMap<StudentPart, f64>, Findings> {
        let (set, keys) = taken.set((set, keys), &|_, _, _, _| nth);
        let table = table(&set, keys, policy);
        let rules = Rules::new(&table, policy)?;
        let names = (order.submissions, Path::new(""));
        let by = (&table, &rules, options);
        let graded = run_file(spooled.path(), names, by, &mut io::sink(), &mut |_| {})?;
        let width = table.columns.len().max(1);
        let place = |(i, points): (usize, &Option<f64>)| {
            let (column, student) = (table.columns.get(i % width)?, table.students.get(i / width)?);
            let first = table.columns.partition_point(|c| c.number < column.number);
            Some(((student.id.clone(), column.number - 1, i % width - first), (*points)?))
        };
        Ok(graded.points.iter().enumerate().filter_map(place).collect())
    };
    let mut rounds = Vec::new();
    if policy.attempts.counts == Counts::Best && taken.most() > 1 {
        rounds = (0..taken.most()).map(points_of).collect::<Result<_, _>>()?;
    }
    let (set, keys) = taken.set((set, keys), &|id, problem, part, n| match policy.attempts.counts {
        Counts::First => 0,
        Counts::Last => n.saturating_sub(1),
        Counts::Best => {
            let at = (id.to_owned(), problem, part);
            let points = |nth: &usize| rounds.get(*nth).and_then(|r| r.get(&at)).copied().unwrap_or(0.0);
            // Of equal ones the first.
            (0..n).rev().max_by(|a, b| points(a).total_cmp(&points(b))).unwrap_or(0)
        }
    });
    let (set_text, key_text) = (set.text(), String::from_utf8_lossy(&key_file::text(&keys)).into_owned());
    Ok((Basis { set, keys, set_text, key_text, ..basis }, spooled, taken))
}

/// Grades a file; faults name what is read and what is written.
pub(super) fn run_file(
    path: &Path,
    (read, written): (&Path, &Path),
    (table, rules, options): (&KeyTable, &Rules, &Options),
    out: &mut (dyn Write + Send),
    progress: &mut (dyn FnMut(u64) + Send),
) -> Result<run::Graded, Findings> {
    let open = || -> io::Result<Box<dyn Read + Send>> { Ok(Box::new(fs::File::open(path)?)) };
    run::grade(&open, table, rules, options, out, progress).map_err(|why| match why {
        GradeFault::Io(e) => files::trouble(read, "cannot be graded")(e).into(),
        GradeFault::Write(e) => files::trouble(written, "cannot be written")(e).into(),
        GradeFault::Header(findings) => findings.in_file(read.display().to_string()),
    })
}

/// Grades the file at `path` into the answers of a staged folder.
fn answers(
    order: &GradeOrder,
    path: &Path,
    table: &KeyTable,
    rules: &Rules,
    options: &Options,
    staged: &Staged,
) -> Result<run::Graded, Findings> {
    let answers = order.out.join(names::ANSWERS);
    let fault = files::trouble(&answers, "cannot be written");
    let first = files::stamp(path);
    let size = first.map_or(0, |(size, _)| size);
    let mut before = 0;
    let mut progress = |read: u64| {
        // A smaller file is graded before a bar would be seen.
        if size > 20_000_000 {
            order.progress.advance("grading", read.saturating_sub(before), size * rules.reads());
        }
        before = read;
    };
    let out = fs::File::create(staged.path().join(names::ANSWERS)).map_err(fault)?;
    let mut out = io::BufWriter::with_capacity(1 << 18, out);
    let graded =
        run_file(path, (order.submissions, &answers), (table, rules, options), &mut out, &mut progress)?;
    // Which attempt counts was found in an earlier walk over the file.
    if files::stamp(path) != first {
        let changed = Finding::of_file(order.submissions, "was changed while it was graded");
        return Err(changed.hint("grade it again, or a copy of it").into());
    }
    out.flush().map_err(fault)?;
    Ok(graded)
}

/// What is in the folder that is no grading's, such as notes of somebody else: the whole folder is exchanged at once.
fn foreign(out: &Path) -> Vec<String> {
    // Only reports have files for students.
    let students = if out.join(names::FEEDBACK).exists() { reports::folders(out) } else { BTreeSet::new() };
    let courses = graded::courses(out).len();
    let ours = |name: &str| names::is_of_grading(name, courses) || names::is_of_report(name, &students);
    files::foreign(out, &ours)
}

/// A pipe is read once, grading reads twice; many files become one. Standard input is the caller's, who holds its lock.
fn spool(
    path: &Path,
    set: &str,
    input: &mut dyn BufRead,
) -> Result<(Option<NamedTempFile>, Option<JoinedFiles>), Finding> {
    let fault = files::trouble(path, "cannot be read");
    if path != Path::new("-") && handed_in::is_many(path) {
        let all = handed_in::joined(path, set)?;
        let mut file = NamedTempFile::new().map_err(fault)?;
        io::Write::write_all(file.as_file_mut(), &all.text).map_err(fault)?;
        return Ok((Some(file), Some(all)));
    }
    let mut pipe: Box<dyn Read + '_> = match path == Path::new("-") {
        true => Box::new(input),
        false if fs::metadata(path).map_err(fault)?.is_file() => return Ok((None, None)),
        false => Box::new(fs::File::open(path).map_err(fault)?),
    };
    let mut file = NamedTempFile::new().map_err(fault)?;
    io::copy(&mut pipe, file.as_file_mut()).map_err(fault)?;
    Ok((Some(file), None))
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
            _ => {
                let fault = Finding::new("--columns", format!("`{text}` maps nothing"));
                faults.push(fault.hint("write a field, `=` and a header, such as student=\"Email Address\""));
            }
        }
    }
    faults.into_result(found)
}

/// Nothing, an empty folder, or with `--force` a folder with an earlier grading.
fn may_write(out: &Path, force: bool) -> Result<(), Findings> {
    const NEW: NewFolder = NewFolder {
        verb: "grade",
        makes: "earlier grading",
        example: "grades",
        taken: "give another --out, or --force to replace an earlier grading",
    };
    // What every version of answers.csv begins with.
    let header = row::COLUMNS[..7].join(",");
    files::may_write_folder(out, force, &NEW, || {
        let mut start = vec![0; header.len()];
        let read = fs::File::open(out.join(names::ANSWERS)).and_then(|mut f| f.read_exact(&mut start));
        Ok((read.is_ok() && start == header.as_bytes()).then(|| foreign(out)))
    })
}
