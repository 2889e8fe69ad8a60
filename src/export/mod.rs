//! Variants as questions of a learning platform: one file that can be uploaded, with the key in it.
//!
//! A [`item::Item`] is one variant of one problem, in the words of its set; a format makes its text and files of it ([`Fragment`]),
//! several at a time, and at the end one file of all. [`losses`] says what a format cannot carry.
pub(crate) mod body;
pub(crate) mod canvas;
pub(crate) mod item;
pub(crate) mod losses;
pub mod moodle;
pub(crate) mod package;
pub(crate) mod qti;
pub(crate) mod qti21;
pub(crate) mod qti3;
pub(crate) mod units;
pub(crate) mod xml;

use crate::bank::Problem;
use crate::export::item::Item;
use crate::finding::Findings;

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

    /// An item in the format.
    pub fn fragment(&self, item: &Item) -> Fragment {
        match self.platform {
            ExportFormat::Moodle => moodle::fragment(self, item),
            ExportFormat::Canvas => canvas::fragment(item),
            ExportFormat::Qti21 => qti::fragment(&qti21::DIALECT, self, item),
            ExportFormat::Qti3 => qti::fragment(&qti3::DIALECT, self, item),
        }
    }

    /// The file that is uploaded, of all fragments in the order of the set. Equal data of one problem are one question.
    ///
    /// # Errors
    /// The archive would be too large.
    pub fn file(&self, mut fragments: Vec<Fragment>) -> Result<ExportedFile, Findings> {
        let mut seen = rustc_hash::FxHashSet::default();
        fragments.retain(|f| seen.insert((f.problem, f.code.clone())));
        // By problem, which keeps the order of the set within each.
        fragments.sort_by_key(|f| f.problem);
        let variants = fragments.len();
        let questions = fragments.iter().map(|f| f.questions.len()).sum();
        let bytes = match self.platform {
            ExportFormat::Moodle => moodle::file(self, &fragments),
            ExportFormat::Canvas => canvas::file(self, fragments)?,
            ExportFormat::Qti21 => qti::file(&qti21::DIALECT, self, fragments)?,
            ExportFormat::Qti3 => qti::file(&qti3::DIALECT, self, fragments)?,
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
