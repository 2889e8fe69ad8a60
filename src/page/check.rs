//! A problem of a sheet file solved anew, and what becomes of an answer to one of its parts.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Case, Draw, Problem, Relative, load};
use crate::finding::{Finding, Findings};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, ProblemKey};
use crate::page::echo;
use crate::page::sheet_file::SheetProblem;
use crate::problem::make_key;
use crate::problem::maker::{Variant, of_sheet};
use crate::scene::Scene;
use crate::solve::outcome::Refusal;
use crate::tutor::{FindWords, Tutor};
use crate::words::Words;
use crate::words::plain::plain;

/// One problem of a sheet, solved.
#[derive(Debug)]
pub struct CheckedProblem {
    /// Number in the sheet.
    pub number: usize,
    /// Id.
    pub id: String,
    /// The bank that it was read as.
    pub bank: Bank,
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
    /// The data are no motion: the problem as it was read, and the refusal of its first case.
    Refused(Box<Bank>, Box<Refusal>),
}

impl CheckedProblem {
    /// The problem that was solved.
    ///
    /// # Panics
    /// Never: [`solve`] has found it there.
    pub fn problem(&self) -> &Problem {
        self.bank.problems.first().expect("a bank of one problem")
    }
    /// The scene that was solved.
    pub fn scene(&self) -> &Scene {
        &self.problem().cases[self.variant.case].scene
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
        let tutor =
            Tutor::new(self.problem(), &self.variant, &self.key, self.bank.grading.hints, words, find);
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

/// Solves a problem of a sheet; `file` is the name shown in findings.
/// Errors: it carries no scene, the scene cannot be read, or its data are no motion.
pub fn solve(problem: &SheetProblem, file: &str) -> Result<CheckedProblem, Unsolved> {
    let Some(tree) = problem.bank_tree().map_err(Unsolved::Faults)? else { return Err(Unsolved::NoScene) };
    // A sheet of an earlier version may hold its scene as the bank says it.
    #[cfg(feature = "program")]
    let tree = crate::bank::synonyms::put_in(tree);
    let no_problem = || Unsolved::Faults(Finding::new("scene", "holds no problem").into());
    let mut bank = load::checked(&tree, file, None).map_err(Unsolved::Faults)?;
    // A tolerance that widens with the condition number stands on the sheet.
    for question in bank.problems.iter_mut().flat_map(|p| &mut p.questions) {
        let printed =
            problem.parts.iter().find(|part| part.id == question.id).and_then(|part| part.tolerance);
        if let (Relative::Widens { least, most, .. }, Some(share)) = (question.relative, printed) {
            question.relative = Relative::Fixed(share.clamp(least, most));
        }
    }
    let only = bank.problems.first().ok_or_else(no_problem)?;
    let given = |case: &Case| -> Vec<Option<Decimal>> {
        let draws = case.draws.iter();
        draws
            .map(|d| match d {
                Some(Draw::Always { value, decimals }) => {
                    Some(Decimal { value: *value, decimals: *decimals })
                }
                _ => None,
            })
            .collect()
    };
    // A contact may be left open: what happens is the case in which what was assumed of it holds.
    let mut solved = only.cases.iter().enumerate().map(|(i, case)| of_sheet(only, i, &given(case)));
    let first = solved.next().ok_or_else(no_problem)?;
    let holds = |v: &Variant| v.solved.all_hold() && !v.solved.regime.slips;
    let found = match first {
        Ok(variant) if holds(&variant) => Ok(variant),
        first => solved.flatten().find(holds).map_or(first, Ok),
    };
    let variant = match found {
        Ok(variant) => variant,
        Err(why) => return Err(Unsolved::Refused(Box::new(bank), Box::new(why))),
    };
    let mut key = make_key::key(only, &variant);
    for part in &mut key.parts {
        let printed = problem.parts.iter().find(|p| p.id == part.part);
        let list = printed.and_then(|p| make_key::listed(&p.words));
        if let (Answer::Word { offered, .. }, Some(list)) = (&mut part.answer, list) {
            *offered = list;
        }
    }
    Ok(CheckedProblem { number: problem.number, id: problem.id.clone(), bank, variant, key })
}
