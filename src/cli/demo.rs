//! `slipstick demo`: the whole job on a made-up class.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::deal::Plan;
use crate::folder::grading::{GradeOrder, Reports};
use crate::folder::staged::Staged;
use crate::folder::{banks, deal, files, grading, names};
use crate::grade::verdict::Verdict;
use crate::inspect::table::unsatisfiable;
use crate::set::dealer::Dealer;
use crate::sheet::output::Format;
use crate::sheet::self_check::Hosting;
use crate::sheet::terminal;
use crate::simulate::hand_in::{CellKind, HandIn, Sheet};
use crate::simulate::{class, hand_in};
use std::path::Path;

/// A folder with this file was made by `demo`, whole.
const MARKER: &str = ".slipstick-demo";
const NAMES: [&str; 6] = [MARKER, "grades", "roster.csv", SELF_TEST, "set", "submissions.csv"];
/// What the simulated answers were, and what grading made of them.
const SELF_TEST: &str = "self-test.txt";
const SEED: u64 = 2026;

/// Runs it.
pub fn run(args: &args::DemoArgs, io: &mut Io) -> Result<Exit, Findings> {
    let dir = &args.dir;
    let bar = io.bar();
    files::has_a_name(dir, "slipstick-demo")?;
    files::not_among_students(dir)?;
    may_replace(dir)?;
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
    let handed = submissions(&plan)?;
    write("submissions.csv", &handed.bytes)?;
    let job = GradeOrder {
        set: &root.join("set"),
        submissions: &root.join("submissions.csv"),
        out: &root.join("grades"),
        attempts: None,
        courses: &[],
        columns: &[],
        language: None,
        reports: Reports::Yes,
        force: false,
        progress: &bar,
    };
    let summary = grading::grade(&job, &mut *io.input).map_err(|f| staged.named(f))?;
    let summary = summary.replace(&root.display().to_string(), &dir.display().to_string());
    let table = kinds_and_verdicts(&handed, &root.join("grades").join("answers.csv"))?;
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
        "\nThe same by hand:\n  slipstick generate {} --roster {shown}/roster.csv --seed {SEED} --out my-set\n  slipstick grade my-set {shown}/submissions.csv --out my-grades",
        bank.id
    ));
    io.open(&dir.join("grades").join(names::INDEX), args.open);
    Ok(Exit::Fine)
}

/// Nothing, an empty folder, or a demo and nothing else.
fn may_replace(dir: &Path) -> Result<(), Findings> {
    let names = files::names_in(dir);
    if !dir.exists() || (dir.is_dir() && names.is_empty()) {
        return Ok(());
    }
    let finding = |what: String| Finding::new("", what).in_file(dir.display().to_string());
    if !dir.is_dir() || !names.iter().any(|n| n == MARKER) {
        let fault = finding("is there already, and `slipstick demo` did not make it".to_owned());
        return Err(fault.hint("give another folder: slipstick demo DIR").into());
    }
    let foreign: Vec<String> = names.into_iter().filter(|n| !NAMES.contains(&n.as_str())).collect();
    if foreign.is_empty() {
        return Ok(());
    }
    let fault = finding(format!("holds what `slipstick demo` did not make: {}", foreign.join(", ")));
    Err(fault.hint("move it away, or give another folder").into())
}

fn submissions(plan: &Plan) -> Result<HandIn, Findings> {
    let dealer = Dealer::new(plan.bank, plan.problems, plan.seed, plan.name);
    let mut dealt = Vec::new();
    for (id, _) in class::STUDENTS {
        dealt.push(dealer.deal(id).map_err(|none| unsatisfiable(plan.bank, &none))?);
    }
    let sheets: Vec<Sheet> = class::STUDENTS
        .iter()
        .zip(&dealt)
        .map(|((id, _), dealt)| Sheet {
            student: id,
            problems: plan
                .chosen()
                .zip(&dealt.variants)
                .zip(&dealt.key.problems)
                .map(|((p, v), k)| (p, v, k))
                .collect(),
        })
        .collect();
    Ok(hand_in::hand_in(&sheets, plan.seed))
}

/// Simulated kinds against verdicts.
fn kinds_and_verdicts(handed: &HandIn, answers: &Path) -> Result<String, Findings> {
    let records = files::records(answers)?;
    let column = |name: &str| records.first().and_then(|h| h.iter().position(|f| f == name));
    let verdict = column("verdict").unwrap_or(6);
    let mut verdicts: Vec<String> = Vec::new();
    for record in records.iter().skip(1) {
        let this = record.get(verdict).unwrap_or_default();
        if !verdicts.iter().any(|v| v == this) {
            verdicts.push(this.to_owned());
        }
    }
    let order = |v: &String| Verdict::ALL.iter().position(|o| o.as_str() == v);
    verdicts.sort_by_key(order);
    let mut rows =
        vec![std::iter::once("rows".to_owned()).chain(verdicts.iter().cloned()).collect::<Vec<_>>()];
    rows[0].push("all".to_owned());
    for kind in CellKind::ALL {
        let of_kind: Vec<&str> = records
            .iter()
            .skip(1)
            .zip(&handed.kinds)
            .filter(|(_, k)| *k == kind)
            .map(|(r, _)| r.get(verdict).unwrap_or_default())
            .collect();
        let mut row = vec![kind.name().to_owned()];
        for v in &verdicts {
            let n = of_kind.iter().filter(|o| *o == v).count();
            row.push(if n == 0 { "·".to_owned() } else { n.to_string() });
        }
        row.push(of_kind.len().to_string());
        rows.push(row);
    }
    Ok(terminal::table(&rows, &[0]))
}

/// The totals, two students to a line.
fn marks(gradebook: &Path) -> Result<String, Findings> {
    let records = files::records(gradebook)?;
    let Some(header) = records.first() else { return Ok(String::new()) };
    let text = |record: &files::Record, name: &str| {
        let column = header.iter().position(|f| f == name);
        column.and_then(|c| record.get(c)).unwrap_or_default().to_owned()
    };
    let most = records.get(1).map_or_else(String::new, |record| text(record, "max_total"));
    let head = ["student".to_owned(), "name".to_owned(), format!("points of {most}")];
    let students: Vec<[String; 3]> =
        records.iter().skip(1).map(|r| ["student", "name", "total"].map(|column| text(r, column))).collect();
    let (left, right) = students.split_at(students.len().div_ceil(2));
    let mut rows = vec![[head.clone(), head].concat()];
    for (i, student) in left.iter().enumerate() {
        rows.push([student.clone(), right.get(i).cloned().unwrap_or_default()].concat());
    }
    Ok(terminal::table(&rows, &[0, 1, 3, 4]))
}
