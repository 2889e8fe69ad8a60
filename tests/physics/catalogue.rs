//! Words and ways of wrong methods, paired one to one: whatever a bank lists has words, in each language, and no words are idle.
use crate::support;
use slipstick::misconception::catalogue::{Catalogue, CatalogueEntry};
use slipstick::sheet::formula;
use slipstick::words::Words;
use std::collections::{BTreeMap, BTreeSet};

/// Longest text of an entry, in characters.
const LONG: usize = 200;

fn ids(catalogue: &Catalogue) -> Vec<&str> {
    catalogue.entries().iter().map(|e| e.id.as_str()).collect()
}

fn texts(entry: &CatalogueEntry) -> [(&'static str, &str); 5] {
    [
        ("did", &entry.did),
        ("tempts", &entry.tempts),
        ("see", &entry.see),
        ("hint", &entry.hint),
        ("note", &entry.note),
    ]
}

/// Ids that the banks list, with the problems that do.
fn used() -> BTreeMap<String, Vec<String>> {
    let mut used: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for bank in support::banks() {
        let name = &bank.id;
        for problem in &bank.problems {
            assert!(
                problem.mistakes.len() >= 6,
                "{name}, {}: {} wrong methods",
                problem.id,
                problem.mistakes.len()
            );
            let mut own = BTreeSet::new();
            for mistake in &problem.mistakes {
                assert!(own.insert(&mistake.id), "{name}, {}: {} twice", problem.id, mistake.id);
                used.entry(mistake.id.clone()).or_default().push(problem.id.clone());
            }
        }
    }
    used
}

#[test]
fn every_wrong_method_of_a_bank_has_words_and_no_words_are_idle() {
    let catalogue = Catalogue::shared("en");
    let used = used();
    let listed: BTreeSet<&str> = ids(catalogue).into_iter().collect();
    assert_eq!(listed.len(), catalogue.entries().len(), "an id stands twice in the catalogue");
    let wordless: Vec<_> = used.iter().filter(|(id, _)| !listed.contains(id.as_str())).collect();
    assert!(wordless.is_empty(), "without words: {wordless:?}");
    let idle: Vec<_> = listed.iter().filter(|id| !used.contains_key(**id)).collect();
    assert!(idle.is_empty(), "in no bank: {idle:?}");
    println!("{} wrong methods, {} ways", listed.len(), used.values().map(Vec::len).sum::<usize>());
}

#[test]
fn every_language_has_words_for_the_same_wrong_methods() {
    let english = Catalogue::shared("en");
    for language in Words::languages() {
        let other = Catalogue::of(language).unwrap_or_else(|| panic!("no catalogue in {language}"));
        assert_eq!(ids(english), ids(&other), "{language}");
        if language != "en" {
            for (a, b) in english.entries().iter().zip(other.entries()) {
                for ((field, a_text), (_, b_text)) in texts(a).iter().zip(texts(b)) {
                    assert_ne!(*a_text, b_text, "{language}: {} {field} is not translated", a.id);
                }
            }
        }
    }
    assert_eq!(Catalogue::of("xx"), None);
}

#[test]
fn hints_give_nothing_away_and_all_words_can_be_set() {
    for language in Words::languages() {
        let catalogue = Catalogue::of(language).unwrap();
        let known: BTreeSet<&str> = ids(&catalogue).into_iter().collect();
        for entry in catalogue.entries() {
            let at = format!("{language}: {}", entry.id);
            for (field, text) in texts(entry) {
                assert!(!text.is_empty() && text.trim() == text, "{at} {field}");
                assert!(text.chars().count() <= LONG, "{at} {field}: {} characters", text.chars().count());
                assert!(text.ends_with(['.', '?']), "{at} {field} is no sentence");
                assert!(text.matches('$').count() % 2 == 0, "{at} {field}: a formula is not closed");
                assert_eq!(formula::faulty_formulas(text), Vec::<String>::new(), "{at} {field}");
                assert!(known.iter().all(|id| !text.contains(id)), "{at} {field} names an id");
            }
            let hint = &entry.hint;
            assert!(!hint.chars().any(|c| c.is_ascii_digit()), "{at}: the hint names a number: {hint}");
            assert!(!hint.contains('='), "{at}: the hint gives a formula: {hint}");
        }
    }
}

#[test]
fn every_problem_says_which_parts_follow_from_which() {
    let mut relations = 0;
    for bank in support::banks() {
        for problem in &bank.problems {
            assert!(!problem.follows.is_empty(), "{}, {}: no `follows`", bank.id, problem.id);
            for follow in &problem.follows {
                let part = &problem.questions[follow.question].id;
                assert!(follow.from.iter().all(|f| *f < follow.question), "{}, {part}", problem.id);
                let others = problem.follows.iter().filter(|f| f.question == follow.question);
                assert_eq!(others.count(), 1, "{}, {part}", problem.id);
            }
            relations += problem.follows.len();
        }
    }
    println!("{relations} relations between parts");
    assert!(relations >= 40, "{relations}");
}
