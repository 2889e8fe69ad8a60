//! A made-up class works on a stored set.
use crate::finding::{Finding, Findings};
use crate::folder::{banks, set};
use crate::set::{dealer, replay};
use crate::simulate::classwork::{self, Files, Work};
use crate::simulate::habits::Habits;
use crate::simulate::student::SimulatedStudent;
use crate::words::Words;
use std::path::Path;

/// What the class hands in, and the truth about it. `file` holds the habits, where they are not built in; the words are those of
/// the set if no language is given. Errors: the set is not what it was, the habits name a wrong method that no problem lists, or
/// the language is not there.
pub fn simulated(
    folder: &Path,
    (habits, file): (&Habits, Option<&Path>),
    language: Option<&str>,
    seed: u64,
) -> Result<Files, Findings> {
    let (stored, bank) = set::with_bank(folder)?;
    let problems = dealer::indices(&bank, &stored.problems, "problems")?;
    if let Some(path) = file {
        let asked = problems.iter().flat_map(|p| &bank.problems[*p].mistakes);
        let known: Vec<&str> = asked.map(|m| m.id.as_str()).collect();
        known_methods(habits, &known, path)?;
    }
    let words = match language {
        Some(language) => banks::words(language)?,
        None => Words::of(&stored.language).unwrap_or_else(Words::english),
    };
    let works = replay::each(&bank, &stored, &|_, student, dealt| {
        let drawn = dealt.variants.iter().zip(&dealt.key.problems);
        let sheet: Vec<_> = problems
            .iter()
            .zip(drawn)
            .map(|(p, (variant, key))| (&bank.problems[*p], variant, key))
            .collect();
        let handed = SimulatedStudent::new(habits, &words, seed, &student.student).work(&sheet);
        Ok(Work { key: dealt.key, handed })
    });
    let mut works = works.map_err(|faults| set::of_set(folder, faults))?;
    classwork::copy(habits, seed, &mut works);
    Ok(classwork::write(habits, &words, seed, &works))
}

/// Are all wrong methods that the habits name listed in the bank?
fn known_methods(habits: &Habits, known: &[&str], path: &Path) -> Result<(), Findings> {
    let file = path.display().to_string();
    let strange = habits.unknown_methods(known).map(|(id, near)| {
        let what = format!("no problem of this set lists the wrong method `{id}`");
        let finding = Finding::new("wrong methods", what).in_file(&file);
        finding.hint(near.unwrap_or_else(|| "the ids stand in the bank under `mistakes`".to_owned()))
    });
    let strange: Findings = strange.collect();
    strange.into_result(())
}
