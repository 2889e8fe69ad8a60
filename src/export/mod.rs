//! Variants as questions of a learning platform: one file that can be uploaded, with the key in it.
//!
//! A [`item::Item`] is one variant of one problem, in the words of its set; a format makes its text and files of it ([`Fragment`]),
//! several at a time, and at the end one file of all, by the templates in `templates/export`. [`losses`] says what a format cannot
//! carry.
pub(crate) mod body;
pub(crate) mod canvas;
pub(crate) mod item;
pub(crate) mod losses;
pub mod moodle;
pub(crate) mod package;
pub(crate) mod qti;
pub(crate) mod units;

use crate::bank::Problem;
use crate::export::item::Item;
use crate::finding::{Finding, Findings};
use crate::key::{Answer, KeyEntry};
use crate::set::key_file::shortest;
use crate::template::{Templates, View};
use crate::words::Words;
use serde_json::{Value, json};

worded! {
    /// A platform's format.
    ExportFormat {
        /// Moodle XML
        Moodle "moodle",
        /// QTI 1.2 in a ZIP archive, as Canvas imports it
        Canvas "canvas",
        /// QTI 2.1 in a ZIP archive
        Qti21 "qti21",
        /// QTI 3.0 in a ZIP archive
        Qti3 "qti3",
    }
}

/// How a problem becomes questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QuestionLayout {
    /// One question, with a place for the answer to each part.
    Whole,
    /// A question for each part, each with the statement.
    Parts,
    /// The same, and a number may have a unit.
    PartsWithUnits,
}

/// What all questions of an export have in common.
pub struct Export<'e> {
    /// The format.
    pub platform: ExportFormat,
    /// How a problem becomes questions.
    pub layout: QuestionLayout,
    /// Name of the set.
    pub set: &'e str,
    /// Tells this set from others, in letters and digits.
    pub id: String,
    /// Language of the set.
    pub language: &'e str,
    /// The problems, in the order of the sheet.
    pub problems: Vec<&'e Problem>,
    /// What a pool of questions holds, in a sentence.
    pub about: String,
    /// Templates of the formats, as [`templates`] makes them.
    pub templates: Templates,
}

/// The templates of the formats. Errors: one cannot be read, which is a bug.
pub fn templates() -> Result<Templates, Findings> {
    macro_rules! texts {
        ($($name:literal),*) => { [$(($name, include_str!(concat!("../../templates/export/", $name)))),*] };
    }
    let own = texts!(
        "moodle-question.xml",
        "moodle.xml",
        "canvas-question.xml",
        "canvas.xml",
        "canvas-meta.xml",
        "manifest.xml"
    );
    let of_both = texts!("qti-interaction.xml", "qti-item.xml", "qti-test.xml");
    let version = |by: &str, text: fn(&str) -> String| {
        of_both.map(|(name, template)| (name.replacen("qti", by, 1), text(template)))
    };
    let own = own.map(|(name, template)| (name.to_owned(), template.to_owned()));
    let all =
        own.into_iter().chain(version("qti21", str::to_owned)).chain(version("qti3", qti::in_version_3));
    Templates::of_program(&all.collect::<Vec<_>>())
}

/// A part, as the templates see it: of a number what it is at least and at most, and the units in which it may be typed, with the
/// factors that make it one in the unit that is asked; of a word all that are offered, and all that is read as the right one.
pub(crate) fn part_view(part: &KeyEntry, words: &Words) -> Value {
    let (id, points, unit) = (&part.part, shortest(part.points), &part.unit);
    match &part.answer {
        Answer::Number { value, half_width, .. } => {
            let [value, tolerance] = [*value, *half_width].map(|si| unit.from_si(si));
            let units = units::units(unit).into_iter().map(|(name, by)| (name, shortest(by)));
            json!({
                "id": id,
                "points": points,
                "is_number": true,
                "value": shortest(value),
                "tolerance": shortest(tolerance),
                "low": shortest(value - tolerance),
                "high": shortest(value + tolerance),
                "units": units.collect::<Vec<_>>(),
            })
        }
        Answer::Word { right, offered } => json!({
            "id": id,
            "points": points,
            "is_number": false,
            "value": right,
            "offered": offered.iter().map(|word| (word, words.of_key(word))).collect::<Vec<_>>(),
            "spellings": item::spellings(right, words),
        }),
    }
}

/// What an item becomes in a format.
pub struct Fragment {
    /// Index of the problem in the sheet.
    pub problem: usize,
    /// Code of the data.
    pub code: String,
    /// Its questions, one or one for each part: their XML, or the name of the item where that is a file.
    pub questions: Vec<String>,
    /// Files beside them: path and bytes.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Export<'_> {
    /// Name of the pool of a problem: as its heading on a sheet.
    pub fn name(&self, problem: usize) -> String {
        format!("{}. {}", problem + 1, self.problems[problem].title)
    }

    /// What a template makes of this, without the characters that XML cannot hold in any way. Errors: faults of the template.
    pub(crate) fn made(&self, template: &str, data: &Value) -> Result<String, Finding> {
        let mut view = View::new();
        view.fields(data);
        let made = String::from_utf8_lossy(&self.templates.made(template, &view)?).into_owned();
        let may = |c: &char| !c.is_control() || matches!(c, '\t' | '\n' | '\r' | '\u{7f}'..='\u{9f}');
        Ok(made.chars().filter(may).filter(|c| !matches!(c, '\u{fffe}' | '\u{ffff}')).collect())
    }

    /// All of it, as the templates see it, with the questions of these fragments, which stand problem by problem. Of a pool of questions
    /// a student gets one: the variants of a problem, or of one of its parts; `spaces` are attributes of QTI.
    pub(crate) fn whole(&self, id: &str, spaces: &str, fragments: &[Fragment]) -> Value {
        let of_problem = |of: &[Fragment]| {
            let at = of[0].problem;
            let questions = &self.problems[at].questions;
            let parts = match self.layout {
                QuestionLayout::Whole => vec![("", 0.0)],
                _ => questions.iter().map(|q| (q.id.as_str(), q.points)).collect(),
            };
            let pool = move |(i, (part, points)): (usize, (&str, f64))| {
                let of_part = of.iter().filter_map(|f| f.questions.get(i));
                let (path, id) = moodle::category(self, at, part);
                json!({
                    "number": at + 1,
                    "name": self.name(at),
                    "part": part,
                    "points": shortest(points),
                    "path": path,
                    "id": id,
                    "questions": of_part.collect::<Vec<_>>(),
                })
            };
            parts.into_iter().enumerate().map(pool).collect::<Vec<_>>()
        };
        let points: f64 = self.problems.iter().flat_map(|p| &p.questions).map(|q| q.points).sum();
        let pools = fragments.chunk_by(|a, b| a.problem == b.problem).flat_map(of_problem);
        json!({
            "id": id,
            "set": self.set,
            "about": self.about,
            "points": shortest(points),
            "spaces": spaces,
            "pools": pools.collect::<Vec<_>>(),
        })
    }

    /// An item in the format. Errors: faults of the templates.
    pub fn fragment(&self, item: &Item) -> Result<Fragment, Finding> {
        match self.platform {
            ExportFormat::Moodle => moodle::fragment(self, item),
            ExportFormat::Canvas => canvas::fragment(self, item),
            ExportFormat::Qti21 => qti::fragment(&qti::QTI21, self, item),
            ExportFormat::Qti3 => qti::fragment(&qti::QTI3, self, item),
        }
    }

    /// The file that is uploaded, of all fragments in the order of the set. Equal data of one problem are one question.
    /// Errors: the archive would be too large.
    pub fn file(&self, mut fragments: Vec<Fragment>) -> Result<ExportedFile, Findings> {
        let mut seen = rustc_hash::FxHashSet::default();
        fragments.retain(|f| seen.insert((f.problem, f.code.clone())));
        // By problem, which keeps the order of the set within each.
        fragments.sort_by_key(|f| f.problem);
        let variants = fragments.len();
        let questions = fragments.iter().map(|f| f.questions.len()).sum();
        let bytes = match self.platform {
            ExportFormat::Moodle => self.made("moodle.xml", &self.whole("", "", &fragments))?.into_bytes(),
            ExportFormat::Canvas => canvas::file(self, fragments)?,
            ExportFormat::Qti21 => qti::file(&qti::QTI21, self, fragments)?,
            ExportFormat::Qti3 => qti::file(&qti::QTI3, self, fragments)?,
        };
        Ok(ExportedFile { bytes, variants, questions })
    }
}

/// A file that can be uploaded.
pub struct ExportedFile {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Variants in it, of all problems.
    pub variants: usize,
    /// Questions in it.
    pub questions: usize,
}
