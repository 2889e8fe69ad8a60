//! The reports of a folder of grades: class report, feedback for each student, gradebooks, matches.
use crate::bank::Bank;
use crate::finding::{Finding, Findings};
use crate::folder::graded::OpenGrading;
use crate::folder::staged::Staged;
use crate::folder::{self, banks, class, files, graded, index, matches, names, staged};
use crate::misconception::catalogue::Catalogue;
use crate::report::class::ClassReporter;
use crate::report::feedback::FeedbackWriter;
use crate::report::lms::GradebookLine;
use crate::report::marks::Marks;
use crate::report::study::ClassStudy;
use crate::report::{lms, table};
use crate::set::grading::StoredGrading;
use crate::set::store::{StoredSet, StoredStudent};
use crate::sheet::document::Document;
use crate::sheet::html::{Converter, PlaceInPage};
use crate::sheet::texts::Texts;
use crate::sheet::{html, terminal};
use crate::words::Words;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;
use std::{fs, io};

/// Names of the students' files in a folder of grades, by its basis; none where there is no basis.
pub fn folders(graded: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(graded.join(names::BASIS).join(names::SET)).unwrap_or_default();
    let set = StoredSet::parse(&text).ok();
    set.into_iter().flat_map(|set| set.students).map(|s| s.folder).collect()
}

/// What was made, for the terminal.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportMade {
    /// Students of the set.
    pub students: usize,
    /// Students who handed in.
    pub took_part: usize,
    pub tables: usize,
    pub lines: Vec<String>,
    /// Whose answers the wrong ones are, in a sentence.
    pub matches: String,
}

impl ReportMade {
    /// Some lines that say what is where.
    pub fn told(&self, out: &str) -> String {
        let mut text = format!(
            "Report on {} of {} who handed in: start with {out}/index.html\n  the class:     {out}/report.html (its {} tables as CSV: {out}/tables)\n  each student:  {out}/feedback (HTML and Markdown, nothing of others in it)\n  to import:     {out}/gradebook-canvas.csv, {out}/gradebook-moodle.csv",
            self.took_part,
            terminal::count(self.students, "student"),
            self.tables
        );
        for line in self.lines.iter().chain([&self.matches]) {
            text.push_str(&format!("\n  {line}"));
        }
        text
    }
}

pub struct ReportJob<'j> {
    /// Folder of a grading.
    pub graded: &'j Path,
    /// Folder to make; that of the grading if not given.
    pub out: Option<&'j Path>,
    /// Folder with templates of one's own.
    pub templates: Option<&'j Path>,
    /// Language of the feedback; that of the grading if not given.
    pub language: Option<&'j str>,
    /// Replace an earlier report.
    pub force: bool,
    pub threads: Option<usize>,
}

/// Writes the reports of a grading beside it or into a folder of their own, whole or not at all. Errors: what is missing or
/// faulty in the folder of the grades, what is in the way, or writing that fails.
pub fn write(job: &ReportJob) -> Result<ReportMade, Findings> {
    let place = job.out.unwrap_or(job.graded);
    files::not_among_students(place)?;
    if !job.graded.is_dir() {
        let fault = Finding::of_file(job.graded, "there is no such folder");
        return Err(fault.hint("give the folder that `slipstick grade` made").into());
    }
    staged::sweep_beside(place);
    may_write(job, place)?;
    let staged = Staged::new(place)?;
    let beside = fs::canonicalize(place).ok() == fs::canonicalize(job.graded).ok();
    let made = make(job.graded, staged.path(), job.templates, job.language, job.threads, beside)
        .map_err(|findings| staged.named(findings))?;
    if !place.exists() {
        staged.finish()?;
        return Ok(made);
    }
    may_write(job, place)?;
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
            fs::rename(&old, aside(name)).map_err(files::trouble(&old, "cannot be replaced"))?;
        }
        staged.place_one(Path::new(name))
    };
    for (i, name) in names::OF_REPORT.iter().enumerate() {
        let Err(fault) = swap(name) else { continue };
        for name in names::OF_REPORT[..=i].iter().rev() {
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
fn may_write(job: &ReportJob, place: &Path) -> Result<(), Finding> {
    let fault = |what: &str| Finding::of_file(place, what);
    if place.exists() && !place.is_dir() {
        return Err(fault("is a file; a report is written to a folder"));
    }
    let old = files::names_in(place).iter().any(|n| names::OF_REPORT.contains(&n.as_str()));
    let same = fs::canonicalize(place).ok() == fs::canonicalize(job.graded).ok();
    let students = folders(job.graded);
    let mut foreign = files::foreign(place, &|name: &str| names::is_of_report(name, &students));
    if same {
        // Beside the reports lie the grades, and what else somebody put there: all of it stays.
        foreign.retain(|name| names::OF_REPORT.contains(&name.split('/').next().unwrap_or_default()));
    }
    if !foreign.is_empty() {
        return Err(files::not_ours(place, &foreign, "report"));
    }
    if old && !job.force {
        return Err(fault("holds a report already").hint("--force replaces it; --out DIR writes another"));
    }
    Ok(())
}

/// Makes the reports of a folder of grades into a folder that is there, and replaces nothing in it. They will lie `beside` the grades,
/// or not. Errors: what is missing or faulty in the folder of the grades, a language that is not there, or writing that fails.
pub fn make(
    graded: &Path,
    out: &Path,
    templates: Option<&Path>,
    language: Option<&str>,
    threads: Option<usize>,
    beside: bool,
) -> Result<ReportMade, Findings> {
    let graded = graded::open(graded, None)?;
    let mut bank = graded.bank.clone();
    let texts = banks::texts(templates, language.unwrap_or(&graded.grading.language), &mut bank)?;
    let catalogue = Catalogue::shared(texts.words.language());
    let marks = read_marks(&graded, &bank, &texts.words)?;
    let study = ClassStudy::of(&marks);
    let written = |name: &str, done: io::Result<()>| {
        done.map_err(|e| Findings::from(files::trouble(&out.join(name), "cannot be written")(e)))
    };
    let write = |name: &str, bytes: &[u8]| written(name, fs::write(out.join(name), bytes));
    let folder = |name: &str| written(name, fs::create_dir(out.join(name)));

    let found = matches::find(&graded)?;
    write(names::MATCHES, &found.csv())?;

    let mut converter = Converter::new(&texts.words);
    let about = class::about(&graded, &bank, &texts.words);
    let reporter =
        ClassReporter { marks: &marks, study: &study, catalogue, matches: &found, words: &texts.words };
    let told = reporter.report(&about, &texts.templates, &mut |markdown| inline(&mut converter, markdown))?;
    write(names::REPORT, &told.html)?;
    folder(names::TABLES)?;
    for table in &told.tables {
        write(&format!("{}/{}.csv", names::TABLES, table.name), &table.csv())?;
    }
    folder(names::FEEDBACK)?;
    feedback(&graded, (&texts, catalogue), &about.title, &marks, threads, &write)?;
    let (item, most, lines) = book(&marks, &graded.grading, &texts.words);
    write(names::CANVAS, &lms::canvas(&item, most, &lines))?;
    write(names::MOODLE, &lms::moodle(&item, graded.grading.moodle.as_deref(), &lines))?;
    let people =
        marks.class.students.iter().map(|s| (s.student.as_str(), s.name.as_str(), s.folder.as_str()));
    write(names::INDEX, &index::of_grades(&texts, &graded.set.name, beside, people)?)?;
    let english = Words::english();
    Ok(ReportMade {
        students: marks.class.students.len(),
        took_part: study.took_part.len(),
        tables: told.tables.len(),
        lines: ClassReporter { catalogue: Catalogue::shared("en"), words: &english, ..reporter }.in_brief(),
        matches: found.summary(&english),
    })
}

/// Writes a file of the reports: its name, its bytes.
type WriteFile<'w> = dyn Fn(&str, &[u8]) -> Result<(), Findings> + Sync + 'w;

/// Writes a page for each student.
fn feedback(
    graded: &OpenGrading,
    (texts, catalogue): (&Texts, &Catalogue),
    title: &str,
    marks: &Marks,
    threads: Option<usize>,
    write: &WriteFile,
) -> Result<(), Findings> {
    let policy = &graded.policy;
    let mut corrections = Vec::new();
    for (i, part) in marks.class.parts.iter().enumerate() {
        let id =
            part.number.checked_sub(1).and_then(|i| graded.set.problems.get(i)).map_or("", String::as_str);
        if let Some(correction) = policy.correction(part.number, id, &part.id, true) {
            corrections.push((i, correction.why.clone()));
        }
    }
    let writer = FeedbackWriter {
        marks,
        title,
        set: &graded.set.name,
        words: &texts.words,
        templates: &texts.templates,
        catalogue,
        hints: policy.hints,
        corrections: &corrections,
    };
    let pool = folder::pool(threads)?;
    let students: Vec<usize> = (0..marks.class.students.len()).collect();
    let chunk = students.len().div_ceil(pool.current_num_threads() * 4).max(1);
    let of_some = |some: &[usize]| -> Result<(), Findings> {
        let mut converter = Converter::new(&texts.words);
        for student in some {
            let (head, document) = writer.document(*student)?;
            let body = converter.body(&document, &[], PlaceInPage::default());
            let page = html::page(&texts.templates, &texts.words, "feedback", &head, &body, None)?;
            let name = format!("{}/{}", names::FEEDBACK, marks.class.students[*student].folder);
            write(&format!("{name}.html"), &page)?;
            write(&format!("{name}.md"), document.plain().as_bytes())?;
        }
        Ok(())
    };
    pool.install(|| students.par_chunks(chunk).map(of_some).collect())
}

/// Name of the grade item, the most that it gives, and the lines of the gradebooks; their short text names the verdict of each
/// part. Where not all students can get the same number of points (another problem is dropped), points cannot be compared: the
/// item is then in per cent.
fn book<'m>(
    marks: &'m Marks,
    grading: &'m StoredGrading,
    words: &Words,
) -> (String, f64, Vec<GradebookLine<'m>>) {
    let set = &grading.set;
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
    let line = |(s, student): (usize, &'m StoredStudent)| {
        let any = marks.took_part(s) || (0..marks.class.parts.len()).any(|p| marks.points(s, p) > 0.0);
        GradebookLine {
            id: &student.student,
            name: &student.name,
            canvas: grading.canvas.get(&student.student),
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
    let html = converter.body(&document, &[], PlaceInPage::default());
    let html = html.trim();
    let inner = html.strip_prefix("<p>").and_then(|h| h.strip_suffix("</p>"));
    inner.filter(|h| !h.contains("<p>")).unwrap_or(html).to_owned()
}

fn read_marks(graded: &OpenGrading, bank: &Bank, words: &Words) -> Result<Marks, Findings> {
    let unreadable = |path: &Path, fault: Finding| {
        let hint = "it is written by `slipstick grade` and not meant to be edited: grade again";
        fault.in_file(path.display().to_string()).hint(hint)
    };
    let answers = graded.folder.join(names::ANSWERS);
    let mut open = || fs::File::open(&answers).map(|f| io::BufReader::with_capacity(1 << 18, f));
    let mut marks =
        Marks::read(class::of(graded, bank, words), &mut open).map_err(|f| unreadable(&answers, f))?;
    let book = graded.folder.join(names::GRADEBOOK);
    let file = fs::File::open(&book).map_err(files::trouble(&book, "cannot be read"))?;
    marks.book(io::BufReader::new(file)).map_err(|f| unreadable(&book, f))?;
    Ok(marks)
}
