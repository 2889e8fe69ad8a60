//! A problem of a sheet file solved anew, and what becomes of an answer to one of its parts.
use crate::bank::decimal::Decimal;
use crate::bank::{Draw, Problem};
#[cfg(feature = "program")]
use crate::bank::{Question, Relative};
use crate::finding::{Finding, Findings};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, ProblemKey};
use crate::page::echo;
#[cfg(feature = "program")]
use crate::page::sheet_file::SheetProblem;
use crate::policy::Hints;
use crate::problem::make_key;
use crate::problem::maker::{Variant, of_sheet};
use crate::scene::Scene;
use crate::solve::outcome::Refusal;
use crate::tutor::{FindWords, Tutor};
use crate::words::Words;
use crate::words::plain::plain;
use base64::prelude::{BASE64_STANDARD, Engine as _};
use serde::{Deserialize, Serialize};

/// A problem as it is put to one student, read from the bank and ready to be solved: all that a page gets. It holds no more than
/// sheet.json says.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct PosedProblem {
    /// Number in the sheet.
    pub number: usize,
    /// The problem.
    pub problem: Problem,
    /// The words that each question offers, where they are not the usual ones.
    words: Vec<Vec<String>>,
    /// How far hints go.
    pub hints: Hints,
    /// May right answers be shown?
    pub reveal: bool,
}

/// A problem of a sheet, solved.
#[derive(Debug)]
pub struct CheckedProblem {
    /// The problem.
    pub posed: PosedProblem,
    /// What was solved.
    pub variant: Variant,
    /// The right answers.
    pub key: ProblemKey,
}

/// Why a problem of a sheet cannot be checked.
#[derive(Debug)]
pub enum Unsolved {
    /// The sheet carries no scene: self-checks are switched off.
    NoScene,
    /// What is wrong with the scene or its data.
    Faults(Findings),
    /// The data are no motion: the problem, and the refusal of its first case.
    Refused(Box<Problem>, Box<Refusal>),
}

impl CheckedProblem {
    /// The scene that was solved.
    pub fn scene(&self) -> &Scene {
        &self.posed.problem.cases[self.variant.case].scene
    }
    /// The index of a part by its id.
    pub fn part(&self, id: &str) -> Option<usize> {
        self.key.parts.iter().position(|entry| entry.part == id)
    }

    /// Judges an answer to the part with this index; `find` knows the words of the wrong methods. `None` if there is no such part.
    pub fn check<'w>(
        &self,
        part: usize,
        cell: &str,
        words: &'w Words,
        find: FindWords<'_, 'w>,
    ) -> Option<Checked> {
        let PosedProblem { problem, hints, .. } = &self.posed;
        let tutor = Tutor::new(problem, &self.variant, &self.key, *hints, words, find);
        let told = tutor.tell(part, cell)?;
        let read = match echo::echo(cell, self.key.parts.get(part)?, words) {
            Ok(text) | Err(text) => text,
        };
        let hints = told.hints.iter().map(|hint| plain(&hint.text)).collect();
        Some(Checked { verdict: told.verdict, reason: told.reason, read, hints })
    }
}

/// What is told of an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Checked {
    /// The verdict.
    pub verdict: Verdict,
    /// Why, in the language of the sheet.
    pub reason: String,
    /// How the answer was read, or why it cannot be.
    pub read: String,
    /// Hints that lead on from a wrong answer, as many as the bank allows, as plain text.
    pub hints: Vec<String>,
}

impl PosedProblem {
    /// Reads the scene of a sheet; `file` is the name shown in findings. Of its student it has no more than the data of the scene.
    /// Errors: it carries no scene, or the scene cannot be read.
    #[cfg(feature = "program")]
    pub fn read(sheet: &SheetProblem, file: &str) -> Result<Self, Unsolved> {
        let Some(tree) = sheet.bank_tree().map_err(Unsolved::Faults)? else { return Err(Unsolved::NoScene) };
        // A sheet of an earlier version may hold its scene as the bank says it.
        let tree = crate::bank::synonyms::put_in(tree);
        let mut bank = crate::bank::load::checked(&tree, file, None).map_err(Unsolved::Faults)?;
        if bank.problems.is_empty() {
            return Err(Unsolved::Faults(Finding::new("scene", "holds no problem").into()));
        }
        let problem = bank.problems.swap_remove(0);
        let (words, hints, reveal) = (Vec::new(), bank.grading.hints, bank.reveal);
        Ok(Self { number: sheet.number, problem, words, hints, reveal })
    }

    /// The same scene with all that one sheet says: number, data, tolerances and words.
    #[cfg(feature = "program")]
    pub fn put_to(&self, sheet: &SheetProblem) -> Self {
        let mut problem = self.problem.clone();
        for (i, datum) in problem.data.iter().enumerate() {
            let said = sheet.data.iter().find(|(symbol, _)| *symbol == datum.symbol);
            let said = said.and_then(|(_, said)| Decimal::parse(&said.as_ref()?[0]));
            let Some(Decimal { value, decimals }) = said else { continue };
            for case in &mut problem.cases {
                if let Some(Some(draw @ Draw::Always { .. })) = case.draws.get_mut(i) {
                    *draw = Draw::Always { value, decimals };
                }
            }
        }
        let part = |id: &str| sheet.parts.iter().find(|part| part.id == id);
        // A tolerance that widens with the condition number stands on the sheet.
        for question in &mut problem.questions {
            let printed = part(&question.id).and_then(|part| part.tolerance);
            if let (Relative::Widens { least, most, .. }, Some(share)) = (question.relative, printed) {
                question.relative = Relative::Fixed(share.clamp(least, most));
            }
        }
        let words = |q: &Question| part(&q.id).map_or_else(Vec::new, |p| p.words.clone());
        let words = problem.questions.iter().map(words).collect();
        Self { number: sheet.number, problem, words, ..*self }
    }

    /// For a page: as bytes in text.
    #[cfg(feature = "program")]
    pub fn packed(&self) -> Result<String, postcard::Error> {
        postcard::to_allocvec(self).map(|bytes| BASE64_STANDARD.encode(bytes))
    }

    /// What was packed; `None` if this is no such text.
    pub fn unpacked(text: &str) -> Option<Self> {
        postcard::from_bytes(&BASE64_STANDARD.decode(text).ok()?).ok()
    }

    /// The problem with its key. Errors: the data are no motion.
    pub fn solved(self) -> Result<CheckedProblem, Unsolved> {
        // A contact may be left open: what happens is the case in which what was assumed of it holds.
        let given = |draw: &Option<Draw>| match draw {
            Some(Draw::Always { value, decimals }) => Some(Decimal { value: *value, decimals: *decimals }),
            _ => None,
        };
        let cases = self.problem.cases.iter().enumerate();
        let mut cases = cases.map(|(i, case)| {
            let given: Vec<Option<Decimal>> = case.draws.iter().map(given).collect();
            of_sheet(&self.problem, i, &given)
        });
        let no_case = || Unsolved::Faults(Finding::new("scene", "holds no problem").into());
        let first = cases.next().ok_or_else(no_case)?;
        let holds = |v: &Variant| v.solved.all_hold() && !v.solved.regime.slips;
        let found = match first {
            Ok(variant) if holds(&variant) => Ok(variant),
            first => cases.flatten().find(holds).map_or(first, Ok),
        };
        let variant = match found {
            Ok(variant) => variant,
            Err(why) => return Err(Unsolved::Refused(Box::new(self.problem), Box::new(why))),
        };
        let mut key = make_key::key(&self.problem, &variant);
        for (part, words) in key.parts.iter_mut().zip(&self.words) {
            if let (Answer::Word { offered, .. }, Some(list)) = (&mut part.answer, make_key::listed(words)) {
                *offered = list;
            }
        }
        Ok(CheckedProblem { posed: self, variant, key })
    }
}

/// Solves a problem of a sheet; `file` is the name shown in findings.
/// Errors: it carries no scene, the scene cannot be read, or its data are no motion.
#[cfg(feature = "program")]
pub fn solve(problem: &SheetProblem, file: &str) -> Result<CheckedProblem, Unsolved> {
    PosedProblem::read(problem, file)?.put_to(problem).solved()
}
