//! Mistakes to beware of: wrong methods of the problem and what each comes to with this student's data. Both are the grader's,
//! the values those that are stored with the draw, the words those of its feedback.
use crate::misconception::catalogue::{Catalogue, CatalogueEntry};
use crate::solution::draft::Draft;
use crate::solution::text::{Block, SolutionSection};
use crate::solution::told;

/// So many are told at most: nobody reads a list of all.
const MOST: usize = 3;

/// The section; `None` if the problem lists no wrong method that can be told.
pub fn section(draft: &Draft, number: usize) -> Option<SolutionSection> {
    let items: Vec<String> = chosen(draft, Catalogue::shared(draft.words.language()))
        .into_iter()
        .map(|(question, words, wrong)| {
            let part = format!("`{number}.{}`", draft.problem.questions[question].id);
            let pieces =
                [("did", words.did.as_str()), ("part", &part), ("wrong", &wrong), ("see", &words.see)];
            format!("- {}", draft.words.say("solution.beware.item", &pieces))
        })
        .collect();
    if items.is_empty() {
        return None;
    }
    let mut section = SolutionSection::new("beware", draft.words.get("solution.title.beware"));
    section.blocks.push(Block::Markdown(items.join("\n")));
    Some(section)
}

/// The wrong methods that are told: the question (its index), the words, and the value as an answer is printed.
///
/// A method belongs to the first question whose answer it spoils. Of each question in turn the next method is taken, in the order of
/// the bank, until there are [`MOST`]: so the bank's first mistake about each question comes before a second one about any. Left out are
/// methods from which draws are not kept away (`unguarded`: slips, and what often comes near the right answer), those without
/// words, and values that look, with the figures of the answer, like the right one or like one that the question has already.
fn chosen<'c>(draft: &Draft, catalogue: &'c Catalogue) -> Vec<(usize, &'c CatalogueEntry, String)> {
    let questions = &draft.problem.questions;
    let right = questions.iter().map(|q| draft.key(q.label).map(|value| told(draft, q, value)));
    let right: Vec<Option<String>> = right.collect();
    // In which round each is taken, its question, its words, its value.
    let mut all: Vec<(usize, usize, &CatalogueEntry, String)> = Vec::new();
    for (index, mistake) in draft.problem.mistakes.iter().enumerate() {
        let Some(words) = catalogue.get(&mistake.id).filter(|_| mistake.unguarded.is_none()) else {
            continue;
        };
        let spoilt = questions.iter().enumerate().find_map(|(at, q)| {
            let wrong = draft.variant.wrong.iter().find(|w| w.mistake == index && w.label == q.label)?;
            let wrong = told(draft, q, draft.scene.as_asked(q.label, wrong.value));
            let told = all.iter().any(|(_, of, _, known)| *of == at && *known == wrong);
            (!told && right[at].as_ref() != Some(&wrong)).then_some((at, wrong))
        });
        if let Some((at, wrong)) = spoilt {
            let round = all.iter().filter(|(_, of, ..)| *of == at).count();
            all.push((round, at, words, wrong));
        }
    }
    all.sort_by_key(|(round, at, ..)| (*round, *at));
    all.truncate(MOST);
    all.sort_by_key(|(_, at, ..)| *at);
    all.into_iter().map(|(_, at, words, wrong)| (at, words, wrong)).collect()
}
