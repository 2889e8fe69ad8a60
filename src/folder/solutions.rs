//! Worked solutions of a stored set, drawn and solved again: a folder for each student, and booklets.
use crate::finding::{Finding, Findings};
use crate::folder::files::NewFolder;
use crate::folder::staged::Staged;
use crate::folder::{self, Progress, banks, files, names, set, staged};
use crate::review::tried_texts::short_page;
use crate::set::dealer::Dealt;
use crate::set::store::StoredStudent;
use crate::set::{dealer, replay};
use crate::sheet::document::{Document, Head};
use crate::sheet::html::Converter;
use crate::sheet::output::{DocumentWriter, Format, WrittenDocument};
use crate::sheet::sheets::Sheets;
use crate::solution::{self, draft::Detail};
use crate::template;
use crate::words::Words;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A folder with this file was made here, whole.
const MARKER: &str = ".slipstick-solutions";

pub struct SolutionsJob<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// Folder to make.
    pub out: &'j Path,
    /// Folder with templates of one's own.
    pub templates: Option<&'j Path>,
    /// Language; that of the set if not given.
    pub language: Option<&'j str>,
    /// How much they tell.
    pub detail: Detail,
    pub formats: &'j [Format],
    /// Replace solutions that were made before.
    pub force: bool,
    pub threads: Option<usize>,
    /// Is told how far it is.
    pub progress: &'j dyn Progress,
}

pub struct SolutionsMade {
    pub students: usize,
    pub problems: usize,
    /// That a solution is a short page, and for how many students.
    pub short: BTreeMap<String, usize>,
}

/// Writes worked solutions for everybody, whole or not at all. Errors: the set is not what it was, a template is faulty, or the
/// folder may not be written.
pub fn write(job: &SolutionsJob) -> Result<SolutionsMade, Findings> {
    let out = job.out;
    staged::sweep_beside(out);
    let (set, mut bank) = set::with_bank(job.set)?;
    may_write(out, job.force)?;
    let language = job.language.unwrap_or(&set.language);
    let texts = banks::texts(job.templates, language, &mut bank)?;
    let output = DocumentWriter::new(&texts, job.formats, "solution")?;
    let problems = dealer::indices(&bank, &set.problems, "problems")?;
    let words = &texts.words;
    let sheets = Sheets::new(&texts.templates, words, &bank, &set.name, &problems)?;
    let staged = Staged::new(out)?;
    let make = |at: usize,
                student: &StoredStudent,
                dealt: Dealt|
     -> Result<(WrittenDocument, Vec<String>), Finding> {
        let head = sheets.head(&student.student, &student.name, &dealt.variants);
        let mut whole = beginning(&head, &bank.title, words);
        let mut short = Vec::new();
        for (i, (index, variant)) in problems.iter().zip(&dealt.variants).enumerate() {
            let problem = &bank.problems[*index];
            let (of_one, beyond) =
                solution::worked(problem, variant, i + 1, job.detail, (words, &texts.templates))?;
            append(&mut whole, of_one, i + 1);
            if let Some(what) = beyond {
                let word = if what.is_fault() { "warning" } else { "note" };
                let page = short_page(problem, variant.case, what);
                short.push(format!("{word}: problems.{}: {page}", problem.id));
            }
        }
        let mut made = output.make(at, head, whole, &mut Converter::new(words), None)?;
        let place = staged.path().join(&student.folder);
        let fault = files::trouble(out, "cannot be written");
        fs::create_dir(&place).map_err(fault)?;
        for (name, bytes) in made.files.drain(..) {
            fs::write(place.join(name), bytes).map_err(fault)?;
        }
        job.progress.advance("solutions", 1, set.students.len() as u64);
        Ok((made, short))
    };
    let pool = folder::pool(job.threads)?;
    let all = pool.install(|| replay::each(&bank, &set, &make));
    let all = all.map_err(|faults| staged.named(set::of_set(job.set, faults)))?;
    let (all, short): (Vec<WrittenDocument>, Vec<Vec<String>>) = all.into_iter().unzip();
    let title = format!("{}: {}, {}", words.get("sheet.solutions"), bank.title, set.name);
    for (name, bytes) in output.booklets(&title, &all)? {
        staged.write(name, &bytes)?;
    }
    let marker = b"Made by `slipstick solutions`, which may replace this folder with --force.\n";
    staged.write(MARKER, marker)?;
    staged.finish()?;
    let mut told: BTreeMap<String, usize> = BTreeMap::new();
    for text in short.into_iter().flatten() {
        *told.entry(text).or_default() += 1;
    }
    Ok(SolutionsMade { students: all.len(), problems: problems.len(), short: told })
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
fn may_write(out: &Path, force: bool) -> Result<(), Findings> {
    const NEW: NewFolder = NewFolder {
        verb: "solutions",
        makes: "solutions",
        example: "--out week-5-solutions",
        taken: "give another --out, or --force to replace solutions that were made before",
    };
    let ours = |name: &str| match name.trim_end_matches('/').split_once('/') {
        None => name.ends_with('/') || name == MARKER || names::BOOKLETS.contains(&name),
        Some((_, file)) => {
            file.starts_with("solution.") || (file.starts_with("problem-") && file.ends_with(".svg"))
        }
    };
    files::may_write_folder(out, force, &NEW, || {
        Ok(out.join(MARKER).exists().then(|| files::foreign(out, &ours)))
    })
}
