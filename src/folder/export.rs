//! A stored set as one file for a learning platform, and a set that is made to be one.
use crate::export::item::{ItemMaker, ItemScratch};
use crate::export::{self, Export, ExportFormat, QuestionLayout, canvas, losses};
use crate::finding::{Finding, Findings};
use crate::folder::deal::{Plan, SetMade};
use crate::folder::{Progress, banks, deal, files, set};
use crate::set::store::StoredStudent;
use crate::set::{dealer, replay};
use crate::sheet::sheets::Sheets;
use crate::sheet::texts::Texts;
use std::path::{Path, PathBuf};

pub struct ExportJob<'j> {
    /// Folder of the set.
    pub set: &'j Path,
    /// Name of the bank for messages, if it is not the copy in the set.
    pub bank: Option<&'j str>,
    /// File to make.
    pub out: &'j Path,
    pub platform: ExportFormat,
    /// How a problem becomes questions.
    pub layout: QuestionLayout,
    /// With worked solutions as feedback.
    pub with_solutions: bool,
    /// Only these problems of the set.
    pub problems: Option<&'j [String]>,
    /// Folder with templates of one's own.
    pub templates: Option<&'j Path>,
    /// Language; that of the set if not given.
    pub language: Option<&'j str>,
    /// Is told how far it is.
    pub progress: &'j dyn Progress,
}

pub struct Exported {
    /// Problems in the file.
    pub problems: usize,
    /// Variants, of all problems.
    pub variants: usize,
    pub questions: usize,
    /// Bytes of the file.
    pub bytes: usize,
    /// What the platform cannot carry, a line each.
    pub losses: Vec<String>,
}

/// May the file be written here? It holds the key, so never among what students get. Errors: what is in the way.
pub fn may_write(out: &Path, force: bool) -> Result<(), Finding> {
    files::not_among_students(out).map_err(|fault| {
        fault.hint("an export holds the key, and students never get it: give another --out")
    })?;
    files::may_write_file(out, force)
}

/// The folder of the set beside the file of a pool.
pub fn set_beside(out: &Path) -> PathBuf {
    let stem = out.file_stem().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!("{stem}-set"))
}

/// Makes the set of a pool: so many variants of each problem, as if for students `v0001` and so on. Errors: what the bank or its
/// texts refuse, or writing that fails.
pub fn pool(plan: &Plan, variants: u32, folder: &Path, progress: &dyn Progress) -> Result<SetMade, Findings> {
    let member = |i: u32| {
        let id = format!("v{i:04}");
        StoredStudent { student: id.clone(), name: String::new(), folder: id, problems: Vec::new() }
    };
    let members: Vec<StoredStudent> = (1..=variants).map(member).collect();
    deal::whole(plan, &members, folder, progress)
}

/// Writes the file, whole or not at all. Errors: the set is not what it was, a template is faulty, the platform cannot hold an
/// answer, or the file may not be written.
pub fn write(job: &ExportJob) -> Result<Exported, Findings> {
    let replayed = set::replayed(job.set)?;
    let (set, mut bank) = (replayed.set, replayed.bank);
    let language = job.language.unwrap_or(&set.language);
    let Texts { templates, words, print } = banks::texts(job.templates, language, &mut bank)?;
    // A platform reads a sign and no word for it.
    let texts = Texts { templates, words: words.with("sheet.signed", "export.signed"), print };
    let problems = dealer::indices(&bank, &set.problems, "problems")?;
    let chosen = match job.problems {
        Some(ids) => {
            let asked = dealer::indices(&bank, ids, "--problems")?;
            let at = asked.iter().map(|p| problems.iter().position(|q| q == p));
            at.collect::<Option<Vec<usize>>>().ok_or_else(|| {
                let fault = Finding::new("--problems", "the set does not have all of these problems");
                fault.hint(format!("its problems: {}", set.problems.join(", ")))
            })?
        }
        None => (0..problems.len()).collect(),
    };
    let in_set = job.set.join(&set.bank.file).display().to_string();
    if job.platform == ExportFormat::Canvas {
        let faults = canvas::too_small(&replayed.keys, &chosen);
        faults.in_file(job.bank.unwrap_or(&in_set)).into_result(())?;
    }
    let sheets = Sheets::new(&texts.templates, &texts.words, &bank, &set.name, &problems)?;
    let rules = match (job.layout, job.platform) {
        (QuestionLayout::PartsWithUnits, _) => ("export.units", "export.word"),
        (_, ExportFormat::Moodle) => ("export.numbers", "export.word"),
        _ => ("export.numbers", "export.choice"),
    };
    let maker = ItemMaker::new((&bank, &problems), &texts, &sheets, rules, job.with_solutions);
    let about = match job.layout {
        QuestionLayout::Whole => "export.about",
        QuestionLayout::Parts | QuestionLayout::PartsWithUnits => "export.about_part",
    };
    let about = texts.words.say(about, &[("n", &set.students.len().to_string())]);
    let of_set = format!("{}\u{0}{}\u{0}{}", set.name, set.seed, set.bank.sha256);
    let export = Export {
        platform: job.platform,
        layout: job.layout,
        set: &set.name,
        id: format!("s{}", crate::bank::load::hash(&of_set).get(..12).unwrap_or_default()),
        language,
        problems: problems.iter().filter_map(|p| bank.problems.get(*p)).collect(),
        about,
        templates: export::templates()?,
    };
    let made = replay::each(&bank, &set, &|i, _, dealt| {
        let mut scratch = ItemScratch::default();
        let key = replayed.keys.get(i).unwrap_or(&dealt.key);
        let fragments = chosen.iter().map(|at| {
            let item = maker.item(*at, &dealt.variants[*at], &key.problems[*at], &mut scratch)?;
            export.fragment(&item)
        });
        let fragments: Result<Vec<_>, Finding> = fragments.collect();
        job.progress.advance("questions", 1, set.students.len() as u64);
        fragments
    });
    let made = made.map_err(|faults| set::of_set(job.set, faults))?;
    let file = export.file(made.into_iter().flatten().collect())?;
    let bytes = file.bytes.len();
    files::put_all(&[(job.out.to_owned(), file.bytes)])?;
    Ok(Exported {
        problems: chosen.len(),
        variants: file.variants,
        questions: file.questions,
        bytes,
        losses: losses::losses(&export, &chosen),
    })
}
