//! `slipstick demo`: the whole job on a made-up class.
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::deal::Plan;
use crate::folder::files::NewFolder;
use crate::folder::grading::{GradeOrder, Reports};
use crate::folder::staged::Staged;
use crate::folder::{banks, deal, files, grading, names, simulate};
use crate::grade::verdict::Verdict;
use crate::sheet::output::Format;
use crate::sheet::self_check::Hosting;
use crate::sheet::terminal;
use crate::simulate::class;
use crate::simulate::habits::Habits;
use crate::simulate::truth::TrueKind;
use std::path::Path;

/// A folder with this file was made by `demo`, whole.
const MARKER: &str = ".slipstick-demo";
const NAMES: [&str; 8] = [COURSE, MARKER, "grades", "roster.csv", SELF_TEST, "set", names::FORM, TRUTH];
/// When the answers were due, and what lateness costs.
const COURSE: &str = "course.yaml";
const COURSE_TEXT: &str = "course: A made-up class\ntime zone: +01:00\ndue: 2026-03-06 18:00\nlate: {penalty: 20 %, per: day, at most: 60 %}\n";
/// What each simulated answer really was.
const TRUTH: &str = "truth.csv";
/// What the simulated answers were, and what grading made of them.
const SELF_TEST: &str = "self-test.txt";
const SEED: u64 = 2026;

pub fn run(dir: &Path, open: bool, io: &mut Io) -> Result<Exit, Findings> {
    let bar = io.bar();
    const NEW: NewFolder =
        NewFolder { verb: "demo", makes: "demonstration", example: "slipstick-demo", taken: "" };
    files::may_write_folder(dir, true, &NEW, || Ok(foreign(dir)))?;
    let mut loaded = banks::load("wheels-on-inclines")?;
    let texts = banks::texts(None, "en", &mut loaded.bank)?;
    let bank = &loaded.bank;
    let staged = Staged::new(dir)?;
    let root = staged.path();
    let write = |name: &str, bytes: &[u8]| staged.write(name, bytes);
    write("roster.csv", &class::roster())?;
    let members = deal::members(&root.join("roster.csv"))?;
    let problems: Vec<usize> = (0..bank.problems.len()).collect();
    let plan = Plan {
        hosting: Hosting::default(),
        bank,
        text: &loaded.text,
        texts: &texts,
        formats: &[Format::Md, Format::Html],
        problems: &problems,
        seed: SEED,
        name: &bank.id,
    };
    let made = deal::whole(&plan, &members, &root.join("set"), &bar).map_err(|f| staged.named(f))?;
    let handed = simulate::simulated(&root.join("set"), (&Habits::demo(), None), None, SEED)
        .map_err(|f| staged.named(f))?;
    write(names::FORM, &handed.submissions)?;
    write(TRUTH, &handed.truth)?;
    write(COURSE, COURSE_TEXT.as_bytes())?;
    let job = GradeOrder {
        set: &root.join("set"),
        submissions: &root.join(names::FORM),
        out: &root.join("grades"),
        attempts: None,
        courses: &[root.join(COURSE)],
        columns: &[],
        language: None,
        reports: Reports::Yes,
        force: false,
        progress: &bar,
    };
    let summary = grading::grade(&job, &mut *io.input).map_err(|f| staged.named(f))?;
    let summary = summary.replace(&root.display().to_string(), &dir.display().to_string());
    let table = kinds_and_verdicts(root)?;
    let test = format!(
        "What the simulated rows were, and what became of them:\n{table}\n{}\n\n{summary}\n",
        made.coincidences()
    );
    write(SELF_TEST, test.as_bytes())?;
    let marks = marks(&root.join("grades").join("gradebook.csv"))?;
    write(MARKER, b"Made by `slipstick demo`, which may replace this folder.\n")?;
    staged.finish()?;

    let shown = dir.display();
    let first = members.first().map_or("", |m| m.folder.as_str());
    io.line(&format!(
        "A made-up class of {} has handed in {} of the bank `{}`, and is graded.\n",
        members.len(),
        terminal::count(problems.len(), "problem"),
        bank.id,
    ));
    for (path, what) in [
        (format!("grades/{}", names::INDEX), "look here first: report, feedback, gradebooks"),
        (format!("set/{}", names::INDEX), "what the class was given: sheets, key, booklet"),
        (format!("set/students/{first}/sheet.html"), "one student's sheet"),
        (format!("grades/feedback/{first}.html"), "what this student gets back"),
        (SELF_TEST.to_owned(), "what each made-up answer was, and its verdict"),
    ] {
        io.line(&format!("  {shown}/{path:<29} {what}"));
    }
    io.line("");
    io.piece(&marks);
    io.line(&format!(
        "\nThe same by hand:\n  slipstick generate {} --roster {shown}/roster.csv --seed {SEED} --out my-set\n  slipstick grade my-set {shown}/submissions.csv --course {shown}/course.yaml --out my-grades",
        bank.id
    ));
    io.open(&dir.join("grades").join(names::INDEX), open);
    Ok(Exit::Fine)
}

/// What is in the folder that `demo` did not make; `None` where it made nothing.
fn foreign(dir: &Path) -> Option<Vec<String>> {
    let names = files::names_in(dir);
    let made = names.iter().any(|name| name == MARKER);
    made.then(|| names.into_iter().filter(|n| !NAMES.contains(&n.as_str())).collect())
}

/// What the answers really were against their verdicts, a row for each kind.
fn kinds_and_verdicts(root: &Path) -> Result<String, Findings> {
    // Both have a row for each row of the submissions, in their order.
    let kinds = files::columns(&root.join(TRUTH), ["kind"])?;
    let verdicts = files::columns(&root.join("grades").join(names::ANSWERS), ["verdict"])?;
    let pairs: Vec<(&str, &str)> =
        kinds.iter().zip(&verdicts).map(|([kind], [verdict])| (kind.as_str(), verdict.as_str())).collect();
    let met = Verdict::ALL.iter().map(|v| v.as_str()).filter(|v| pairs.iter().any(|(_, w)| w == v));
    let met: Vec<&str> = met.collect();
    let row = |kind: &str| {
        let number = |verdict: &&str| match pairs.iter().filter(|pair| **pair == (kind, *verdict)).count() {
            0 => "·".to_owned(),
            n => n.to_string(),
        };
        let all = pairs.iter().filter(|(k, _)| *k == kind).count().to_string();
        [kind.to_owned()].into_iter().chain(met.iter().map(number)).chain([all]).collect::<Vec<_>>()
    };
    let head = ["rows"].into_iter().chain(met.iter().copied()).chain(["all"]).map(str::to_owned).collect();
    let rows: Vec<Vec<String>> =
        [head].into_iter().chain(TrueKind::ALL.iter().map(|kind| row(kind.as_str()))).collect();
    Ok(terminal::table(&rows, &[0]))
}

/// The totals, two students to a line.
fn marks(gradebook: &Path) -> Result<String, Findings> {
    let students = files::columns(gradebook, ["student", "name", "total", "max_total"])?;
    let most = students.first().map_or("", |[.., most]| most.as_str());
    let head = ["student".to_owned(), "name".to_owned(), format!("points of {most}")];
    let students: Vec<[String; 3]> =
        students.iter().map(|[id, name, total, _]| [id, name, total].map(String::clone)).collect();
    let (left, right) = students.split_at(students.len().div_ceil(2));
    let mut rows = vec![[head.clone(), head].concat()];
    for (i, student) in left.iter().enumerate() {
        rows.push([student.clone(), right.get(i).cloned().unwrap_or_default()].concat());
    }
    Ok(terminal::table(&rows, &[0, 1, 3, 4]))
}
