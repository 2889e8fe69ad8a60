//! `slipstick report`: a folder of grades to the class report, feedback for each student and gradebooks.
use crate::bank::Bank;
use crate::bank::Question;
use crate::bank::Relative;
use crate::cli::args;
use crate::cli::args::Own;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::generate;
use crate::cli::grade;
use crate::cli::graded;
use crate::cli::matches;
use crate::cli::output;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::row::Unreadable;
use crate::guard::unguarded;
use crate::misconception::catalogue::Catalogue;
use crate::policy::Policy;
use crate::report::class;
use crate::report::class::About;
use crate::report::class::ClassReporter;
use crate::report::feedback::FeedbackDesk;
use crate::report::lms;
use crate::report::lms::GradebookLine;
use crate::report::marks::Class;
use crate::report::marks::Drawn;
use crate::report::marks::Marks;
use crate::report::marks::Part;
use crate::report::marks::Problem;
use crate::report::marks::Student;
use crate::report::settings;
use crate::report::study::ClassStudy;
use crate::report::table;
use crate::set::grading::BASIS;
use crate::set::grading::Grading;
use crate::set::store::StoredSet;
use crate::sheet::document::Document;
use crate::sheet::html;
use crate::sheet::html::Converter;
use crate::sheet::html::Place;
use crate::words::Words;
use clap::ValueEnum as _;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;
use std::path::PathBuf;

/// What a report makes, in the folder of the grades or in one of its own.
pub const MADE: [&str; 6] =
    ["report.html", "tables", "feedback", "gradebook-canvas.csv", "gradebook-moodle.csv", matches::MATCHES];

/// Names of the students' files in a folder of grades, by its basis; none where there is no basis.
pub fn folders(graded: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(graded.join(BASIS).join("set.json")).unwrap_or_default();
    let set = StoredSet::parse(&text).ok();
    set.into_iter().flat_map(|set| set.students).map(|s| s.folder).collect()
}

/// Does a report make this (a file, or `folder/`) for students of these names?
pub fn is_ours(name: &str, students: &BTreeSet<String>) -> bool {
    match name.split_once('/') {
        None => MADE.contains(&name) && !["tables", "feedback"].contains(&name),
        Some(("tables" | "feedback", "")) => true,
        Some(("tables", file)) => {
            file.strip_suffix(".csv").is_some_and(|t| class::TABLES.split(' ').any(|name| name == t))
        }
        Some(("feedback", file)) => {
            let student = file.strip_suffix(".html").or_else(|| file.strip_suffix(".md"));
            student.is_some_and(|s| students.contains(s))
        }
        Some(_) => false,
    }
}

/// Runs it.
pub fn run(args: &args::Report, io: &mut Io) -> Exit {
    match report(args) {
        Ok(made) => {
            let out = args.out.as_deref().unwrap_or(&args.graded).display().to_string();
            io.line(&made.told(&out));
            Exit::Fine
        }
        Err(findings) => io.findings(&findings),
    }
}

/// What was made, for the terminal.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Students of the set.
    pub students: usize,
    /// Students who handed in.
    pub took_part: usize,
    /// Tables.
    pub tables: usize,
    /// What stands out.
    pub lines: Vec<String>,
    /// Whose answers the wrong ones are, in a sentence.
    pub matches: String,
}

impl Summary {
    /// Some lines that say what is where.
    pub fn told(&self, out: &str) -> String {
        let mut text = format!(
            "Report on {} of {} who handed in\n  the class:     {out}/report.html (its {} tables as CSV: {out}/tables)\n  each student:  {out}/feedback (HTML and Markdown, nothing of others in it)\n  to import:     {out}/gradebook-canvas.csv, {out}/gradebook-moodle.csv",
            self.took_part,
            tell::count(self.students, "student"),
            self.tables
        );
        for line in self.lines.iter().chain([&self.matches]) {
            text.push_str(&format!("\n  {line}"));
        }
        text
    }
}

fn report(args: &args::Report) -> Result<Summary, Findings> {
    let place = args.out.as_deref().unwrap_or(&args.graded);
    files::not_among_students(place)?;
    if !args.graded.is_dir() {
        let fault = Finding::new("", "there is no such folder").in_file(args.graded.display().to_string());
        return Err(fault.hint("give the folder that `slipstick grade` made").into());
    }
    files::sweep_beside(place);
    may_write(args, place)?;
    let staged = Staged::new(place)?;
    let made = make(&args.graded, staged.path(), &args.own, args.threads)
        .map_err(|findings| staged.named(findings))?;
    if !place.exists() {
        staged.finish()?;
        return Ok(made);
    }
    may_write(args, place)?;
    exchange(&staged, place)?;
    Ok(made)
}

/// Only what a report makes is ours: the folder itself stays. What was there goes aside and is removed with the staged folder; if
/// anything fails, all of it comes back.
fn exchange(staged: &Staged, place: &Path) -> Result<(), Finding> {
    let aside = |name: &str| staged.path().join(format!("old-{name}"));
    let swap = |name: &str| -> Result<(), Finding> {
        let old = place.join(name);
        if old.exists() {
            fs::rename(&old, aside(name)).map_err(|e| files::trouble(&old, "cannot be replaced", &e))?;
        }
        staged.place_one(Path::new(name))
    };
    for (i, name) in MADE.iter().enumerate() {
        let Err(fault) = swap(name) else { continue };
        for name in MADE[..=i].iter().rev() {
            let (here, new) = (place.join(name), staged.path().join(name));
            // The new one makes room, where it came so far.
            if !new.exists() {
                let _ = fs::rename(&here, new);
            }
            if aside(name).exists() {
                let _ = fs::rename(aside(name), &here);
            }
        }
        return Err(fault);
    }
    Ok(())
}

/// Into the folder of the grades, or one that is not there or is empty; with `--force` over an earlier report.
fn may_write(args: &args::Report, place: &Path) -> Result<(), Finding> {
    let fault = |what: &str| Finding::new("", what).in_file(place.display().to_string());
    if place.exists() && !place.is_dir() {
        return Err(fault("is a file; a report is written to a folder"));
    }
    let names = files::names_in(place);
    let old = names.iter().any(|n| MADE.contains(&n.as_str()));
    let same = fs::canonicalize(place).ok() == fs::canonicalize(&args.graded).ok();
    let students = folders(&args.graded);
    let mut foreign = files::foreign(place, &|name: &str| is_ours(name, &students));
    if same {
        // Beside the reports lie the grades, and what else somebody put there: all of it stays.
        foreign.retain(|name| MADE.contains(&name.split('/').next().unwrap_or_default()));
    }
    if !foreign.is_empty() {
        return Err(files::not_ours(place, &foreign, "report"));
    }
    if old && !args.force {
        return Err(fault("holds a report already").hint("--force replaces it; --out DIR writes another"));
    }
    Ok(())
}

/// Makes the reports of a folder of grades into a folder that is there, and replaces nothing in it.
///
/// # Errors
/// What is missing or faulty in the folder of the grades, a language that is not there, or writing that fails.
pub fn make(graded: &Path, out: &Path, own: &Own, threads: Option<usize>) -> Result<Summary, Findings> {
    let mut basis = Basis::read(graded)?;
    let language = own.language.clone().unwrap_or_else(|| basis.grading.language.clone());
    let texts = banks::texts(own, &language, &mut basis.bank)?;
    let catalogue = Catalogue::of(&language).unwrap_or_else(Catalogue::built_in);
    let marks = read_marks(graded, &basis, &texts.words)?;
    let study = ClassStudy::of(&marks);
    let written = |name: &str, e: &io::Error| files::trouble(&out.join(name), "cannot be written", e);
    let write = |name: &str, bytes: &[u8]| fs::write(out.join(name), bytes).map_err(|e| written(name, &e));
    let folder = |name: &str| fs::create_dir(out.join(name)).map_err(|e| written(name, &e));

    let found = matches::find(&graded::open(graded, None)?)?;
    write(matches::MATCHES, &found.csv())?;

    let mut converter = Converter::new(&texts.words);
    let about = about(&basis, &texts.words);
    let reporter = ClassReporter {
        marks: &marks,
        study: &study,
        catalogue: &catalogue,
        matches: &found,
        words: &texts.words,
    };
    let told = reporter.report(&about, &texts.templates, &mut |markdown| inline(&mut converter, markdown))?;
    write("report.html", &told.html)?;
    folder("tables")?;
    for table in &told.tables {
        write(&format!("tables/{}.csv", table.name), &table.csv())?;
    }

    let corrections: Vec<(usize, String)> = marks
        .class
        .parts
        .iter()
        .enumerate()
        .filter_map(|(i, part)| {
            let problem = marks.class.problems.get(part.number.checked_sub(1)?)?;
            let correction = basis.policy.correction(part.number, &problem.id, &part.id, true)?;
            Some((i, correction.why.clone()))
        })
        .collect();
    let desk = FeedbackDesk {
        marks: &marks,
        title: &about.title,
        set: &basis.set.name,
        words: &texts.words,
        templates: &texts.templates,
        catalogue: &catalogue,
        hints: basis.policy.hints,
        corrections: &corrections,
    };
    folder("feedback")?;
    let pool = output::pool(threads)?;
    let students: Vec<usize> = (0..marks.class.students.len()).collect();
    let chunk = students.len().div_ceil(pool.current_num_threads() * 4).max(1);
    let all: Result<Vec<()>, Findings> = pool.install(|| {
        let of_some = |some: &[usize]| -> Result<(), Findings> {
            let mut converter = Converter::new(&texts.words);
            for student in some {
                let (head, document) = desk.document(*student)?;
                let body = converter.body(&document, &[], Place { lower: 0, prefix: "" });
                let page = html::page(&texts.templates, &texts.words, "feedback", &head, &body)?;
                let name = &marks.class.students[*student].folder;
                write(&format!("feedback/{name}.html"), &page)?;
                write(&format!("feedback/{name}.md"), document.plain().as_bytes())?;
            }
            Ok(())
        };
        students.par_chunks(chunk).map(of_some).collect()
    });
    all?;

    let (item, most, lines) = book(&marks, &basis.grading.set, &texts.words);
    write("gradebook-canvas.csv", &lms::canvas(&item, most, &lines))?;
    write("gradebook-moodle.csv", &lms::moodle(&item, &lines))?;
    let english = Words::english();
    Ok(Summary {
        students: marks.class.students.len(),
        took_part: study.took_part.len(),
        tables: told.tables.len(),
        lines: ClassReporter { catalogue: &Catalogue::built_in(), words: &english, ..reporter }.in_brief(),
        matches: found.summary(&english),
    })
}

/// Name of the grade item, the most that it gives, and the lines of the gradebooks; their short text names the verdict of each
/// part. Where not all students can get the same number of points (another problem is dropped), points cannot be compared: the
/// item is then in per cent.
fn book<'m>(marks: &'m Marks, set: &str, words: &Words) -> (String, f64, Vec<GradebookLine<'m>>) {
    let most = marks.totals.iter().map(|t| t.1).fold(0.0, f64::max);
    let same = marks.totals.iter().all(|t| (t.1 - most).abs() <= 1e-9 * most);
    let told = |s: usize| -> String {
        let parts = marks.class.parts.iter().enumerate().filter(|(p, _)| marks.asked(s, *p));
        let told: Vec<String> = parts
            .map(|(p, part)| {
                let verdict = marks.cell(s, p).row.as_ref().map_or("none", |r| r.verdict.as_str());
                let verdict = words.get(&format!("report.verdict.{}", verdict.replace(' ', "_")));
                let number = |value: f64| words.number(&table::points(value));
                let (points, of) = (number(marks.points(s, p)), number(part.points));
                format!("{} {verdict} {points}/{of}", part.label())
            })
            .collect();
        told.join("; ")
    };
    let points = |(points, of): (f64, f64)| match same {
        true => points,
        false if of > 0.0 => (points / of * 10_000.0).round() / 100.0,
        false => 0.0,
    };
    let line = |(s, student): (usize, &'m Student)| {
        let any = marks.took_part(s) || (0..marks.class.parts.len()).any(|p| marks.points(s, p) > 0.0);
        GradebookLine {
            id: &student.id,
            name: &student.name,
            points: any.then(|| points(marks.totals[s])),
            feedback: if any { told(s) } else { String::new() },
        }
    };
    let lines = marks.class.students.iter().enumerate().map(line).collect();
    if same { (set.to_owned(), most, lines) } else { (format!("{set} %"), 100.0, lines) }
}

/// Markdown of one line to HTML without the paragraph around it.
fn inline(converter: &mut Converter, markdown: &str) -> String {
    let document = Document::new(markdown.to_owned(), Vec::new());
    let html = converter.body(&document, &[], Place { lower: 0, prefix: "" });
    let html = html.trim();
    let inner = html.strip_prefix("<p>").and_then(|h| h.strip_suffix("</p>"));
    inner.filter(|h| !h.contains("<p>")).unwrap_or(html).to_owned()
}

fn title_of(bank: &Bank, id: &str) -> String {
    bank.problems.iter().find(|p| p.id == id).map_or_else(|| id.to_owned(), |p| p.title.clone())
}

/// What stands beside the answers in a folder of grades.
struct Basis {
    set: StoredSet,
    bank: Bank,
    /// Settings of the bank with those of the course over them.
    policy: Policy,
    /// What the grading was made from.
    grading: Grading,
    /// Student, number of the problem, part: what each sheet asks.
    key: Vec<(String, String, String)>,
}

impl Basis {
    fn read(graded: &Path) -> Result<Self, Findings> {
        graded::has_all(graded)?;
        let folder = graded.join(BASIS);
        let set = generate::existing(&folder)?;
        let bank_path = folder.join(&set.bank.file);
        let text = files::read_text(&bank_path)?;
        let bank = banks::parse(&text, &bank_path.display().to_string())?;
        let grading_path = graded.join(grade::GRADING);
        let text = files::read_text(&grading_path)?;
        let grading = Grading::parse(&text).map_err(|f| f.in_file(grading_path.display().to_string()))?;
        graded::intact(graded, &grading)?;
        let courses = grade::read_courses(&grade::courses(graded))?;
        let typed = grading.attempts.as_deref().and_then(|a| args::Attempts::from_str(a, true).ok());
        let policy = grade::policy(&bank.grading, &courses, typed)?;
        let key_path = folder.join("key.csv");
        let key = read_key(&key_path)?;
        Ok(Self { set, bank, policy, grading, key })
    }

    /// The class without marks.
    fn class(&self, words: &Words) -> Class {
        let indices: Vec<Option<&crate::bank::Problem>> =
            self.set.problems.iter().map(|id| self.bank.problems.iter().find(|p| p.id == *id)).collect();
        let parts: Vec<Part> = indices
            .iter()
            .enumerate()
            .flat_map(|(i, problem)| {
                let questions = problem.map_or(&[][..], |p| &p.questions);
                questions.iter().map(move |q| Part {
                    number: i + 1,
                    id: q.id.clone(),
                    points: self
                        .policy
                        .points_given(i + 1, problem.map_or("", |p| p.id.as_str()), &q.id)
                        .unwrap_or(q.points),
                    unit: q.unit.ascii().to_owned(),
                    unit_required: q.unit_required,
                    asked: asked(&q.ask).to_owned(),
                    tolerance: tolerance(q, words),
                })
            })
            .collect();
        let students: Vec<Student> = self.set.students.iter().map(student).collect();
        let whose: rustc_hash::FxHashMap<&str, usize> =
            self.set.students.iter().enumerate().map(|(i, s)| (s.student.as_str(), i)).collect();
        let which: rustc_hash::FxHashMap<(String, &str), usize> =
            parts.iter().enumerate().map(|(i, p)| ((p.number.to_string(), p.id.as_str()), i)).collect();
        let mut asked = vec![false; students.len() * parts.len()];
        for (who, number, part) in &self.key {
            let which = which.get(&(number.clone(), part.as_str()));
            if let (Some(who), Some(what)) = (whose.get(who.as_str()), which) {
                asked[who * parts.len() + what] = true;
            }
        }
        let problems = self
            .set
            .problems
            .iter()
            .map(|id| Problem { id: id.clone(), title: title_of(&self.bank, id) })
            .collect();
        Class { students, problems, parts, asked, day_first: self.policy.day_first }
    }
}

/// What a question asks; nothing where a template makes it of the variant.
fn asked(ask: &str) -> &str {
    if ask.contains("{{") || ask.contains("{%") || ask.contains("{#") { "" } else { ask.trim() }
}

/// The rule of the tolerance in words.
fn tolerance(question: &Question, words: &Words) -> String {
    if question.label.quantity.is_word() {
        return String::new();
    }
    let share = |s: f64| words.number(&format!("{} %", table::points(s * 100.0)));
    let text = match question.relative {
        Relative::Fixed(s) => share(s),
        Relative::Widens { least, per_cond, most } => {
            let pieces = [("least", share(least)), ("most", share(most)), ("each", share(per_cond))];
            words
                .say("report.tolerance.widens", &pieces.each_ref().map(|(name, text)| (*name, text.as_str())))
        }
    };
    match question.absolute.filter(|w| *w > 0.0) {
        None => text,
        Some(width) => {
            let width = words.number(&width.to_string());
            words.say("report.tolerance.at_least", &[("share", &text), ("width", &width)])
        }
    }
}

/// A student of the set with the numbers that were drawn.
fn student(stored: &crate::set::store::StoredStudent) -> Student {
    let drawn = stored.problems.iter().map(|variant| {
        let data = variant.data.iter().filter_map(|(symbol, value)| {
            let text = value.as_str()?;
            let number = text.split_whitespace().next()?.parse::<f64>().ok()?;
            number.is_finite().then(|| (symbol.clone(), number))
        });
        Drawn { case: variant.case.clone(), data: data.collect() }
    });
    Student {
        id: stored.student.clone(),
        name: stored.name.clone(),
        folder: stored.folder.clone(),
        drawn: drawn.collect(),
    }
}

fn read_key(path: &Path) -> Result<Vec<(String, String, String)>, Finding> {
    let bytes = files::read(path)?;
    let mut reader = csv::ReaderBuilder::new().from_reader(bytes.as_slice());
    let fault = |e: &csv::Error| Finding::new("", e.to_string()).in_file(path.display().to_string());
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| fault(&e))?;
        let text = |i: usize| unguarded(record.get(i).unwrap_or_default()).to_owned();
        rows.push((text(0), text(1), text(2)));
    }
    Ok(rows)
}

fn read_marks(graded: &Path, basis: &Basis, words: &Words) -> Result<Marks, Findings> {
    let unreadable = |path: &PathBuf, fault: Unreadable| {
        let finding = Finding::new("", fault.what).in_file(path.display().to_string());
        let finding = if fault.line > 0 {
            finding.at(usize::try_from(fault.line).unwrap_or(usize::MAX), 1)
        } else {
            finding
        };
        finding.hint("it is written by `slipstick grade` and not meant to be edited: grade again")
    };
    let answers = graded.join("answers.csv");
    let mut open = || fs::File::open(&answers).map(|f| io::BufReader::with_capacity(1 << 18, f));
    let mut marks = Marks::read(basis.class(words), &mut open).map_err(|f| unreadable(&answers, f))?;
    let book = graded.join("gradebook.csv");
    let file = fs::File::open(&book).map_err(|e| files::trouble(&book, "cannot be read", &e))?;
    marks.book(io::BufReader::new(file)).map_err(|f| unreadable(&book, f))?;
    Ok(marks)
}

/// How it was graded and of what, in words.
fn about(basis: &Basis, words: &Words) -> About {
    let grading = &basis.grading;
    let hash = |hash: &str| format!("SHA-256 {}…", hash.chars().take(16).collect::<String>());
    let say = |name: &str, pieces: &[(&str, &str)]| words.say(&format!("report.provenance.{name}"), pieces);
    let mut provenance = Vec::new();
    let mut add = |name: &str, value: String| provenance.push((say(name, &[]), value));
    add("program", grading.program.clone());
    let bytes = grading.submissions_bytes.to_string();
    add("submissions", say("bytes", &[("file", &grading.submissions), ("n", &bytes)]));
    let (seed, version) = (grading.seed.to_string(), grading.draw_version.to_string());
    let draw = say("draw", &[("set", &grading.set), ("seed", &seed), ("version", &version)]);
    add("set", if grading.replayed { draw } else { say("not_replayed", &[("draw", &draw)]) });
    add("bank", format!("{}, {}", grading.bank, hash(&grading.bank_sha256)));
    add("key", hash(&grading.key_sha256));
    if let Some(sha256) = &grading.course_sha256 {
        add("course", hash(sha256));
    }
    add("language", grading.language.clone());
    if !grading.columns.is_empty() {
        add("columns", grading.columns.join(", "));
    }
    if grading.untimed > 0 {
        add("by_row", say("untimed", &[("n", &grading.untimed.to_string())]));
    }
    if grading.undated > 0 {
        add("undated", say("undated_answers", &[("n", &grading.undated.to_string())]));
    }
    if !grading.unused_columns.is_empty() {
        add("not_used", grading.unused_columns.join(", "));
    }
    About {
        title: if basis.policy.title.is_empty() {
            basis.bank.title.clone()
        } else {
            basis.policy.title.clone()
        },
        set: basis.set.name.clone(),
        settings: settings::in_words(&basis.policy, words),
        provenance,
    }
}
