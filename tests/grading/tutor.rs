//! Hints in steps: none gives the answer away, none is said twice, and each belongs to what was done.
use crate::support;
use slipstick::bank::Problem;
use slipstick::grade::compare;
use slipstick::grade::verdict::Verdict;
use slipstick::key::{Answer, ProblemKey};
use slipstick::misconception::catalogue::{Catalogue, CatalogueEntry};
use slipstick::num::shown;
use slipstick::policy::Hints;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::tutor::{Hint, HintKind, Tutor, TutorReply};
use slipstick::words::Words;

/// What is told of a cell at a level, in a language.
fn tell(
    (problem, variant, key): (&Problem, &Variant, &ProblemKey),
    (part, cell): (usize, &str),
    level: Hints,
    language: &str,
) -> TutorReply {
    let catalogue = Catalogue::shared(language);
    let find = |id: &str| catalogue.get(id).map(CatalogueEntry::words);
    let words = Words::built_in(language).unwrap();
    Tutor::new(problem, variant, key, level, words, &find).tell(part, cell).unwrap()
}

/// The numbers that stand in a text, decimal commas read as points; formulas and the exponents of units are none.
fn numbers(text: &str) -> Vec<f64> {
    let mut found = Vec::new();
    let prose: String = text.split('$').step_by(2).collect();
    let text = prose.replace("^2", "");
    for word in text.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | 'e'))) {
        let word = word.trim_matches(|c: char| matches!(c, '.' | ',' | '-' | 'e')).replace(',', ".");
        found.extend(word.parse::<f64>());
    }
    found
}

/// Does this text hold the right number of any part, in the unit in which it is asked?
fn tells(key: &ProblemKey, hint: &Hint) -> bool {
    key.parts.iter().any(|entry| match entry.answer {
        Answer::Number { value, half_width, .. } => numbers(&hint.text).into_iter().any(|n| {
            let n = entry.unit.to_si(n);
            compare::accepts(n, value.abs(), half_width)
        }),
        Answer::Word { .. } => false,
    })
}

/// Every wrong method of every problem, as an answer of four figures: its own question comes first where it alone is named, the
/// steps follow in order, no two are the same, and no number of the key stands in any of them.
#[test]
fn hints_to_known_methods_lead_on_step_by_step() {
    let (mut answers, mut single, mut limits, mut odd, mut leaking) = (0, 0, 0, 0, Vec::new());
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 21, "tutor");
            for student in 0..3 {
                let variant = maker.variant(&student.to_string()).unwrap();
                let key = maker.key(&variant);
                for (part, entry) in key.parts.iter().enumerate() {
                    for w in &entry.wrong {
                        let number = shown::significant(entry.unit.from_si(w.value), 4);
                        let unit = if entry.unit.is_number() { "" } else { entry.unit.ascii() };
                        let cell = format!("{number} {unit}");
                        let language = if student == 0 { "de" } else { "en" };
                        let at = (problem, &variant, &key);
                        let told = tell(at, (part, &cell), Hints::Explain, language);
                        if told.verdict != Verdict::Wrong {
                            continue;
                        }
                        answers += 1;
                        let id = &key.methods[usize::from(w.method)];
                        let name = format!("{} {} {id}: {cell}", problem.id, entry.part);
                        assert!(!told.hints.is_empty(), "{name}");
                        for (i, hint) in told.hints.iter().enumerate() {
                            assert!(told.hints[..i].iter().all(|h| h.text != hint.text), "{name}: {hint:?}");
                            if tells(&key, hint) {
                                leaking.push(format!("{name}: {}", hint.text));
                            }
                        }
                        let steps: Vec<u8> = told.hints.iter().map(|h| h.step as u8).collect();
                        assert!(steps.is_sorted(), "{name}: {:?}", told.hints);
                        if told.methods == [id.clone()] && told.hints[0].step != HintKind::Slip {
                            single += 1;
                            let words = Catalogue::shared(language).get(id).unwrap();
                            assert_eq!(told.hints[0].text, words.hint, "{name}");
                            assert!(told.hints.last().unwrap().text.contains(&words.see), "{name}");
                            let Some(limit) = told.hints.iter().find(|h| h.step == HintKind::Limit) else {
                                continue;
                            };
                            limits += 1;
                            // A number is told only in a limit without a datum, and then the method is named, once.
                            let can = if language == "de" { "Kann das sein?" } else { "Can that be?" };
                            if limit.text.ends_with(can) {
                                odd += 1;
                                assert!(limit.text.contains("$ = 0 "), "{name}: {limit:?}");
                                let named = told.hints.iter().filter(|h| h.text.contains(&words.did)).count();
                                assert!(
                                    limit.text.contains(&words.did) && named == 1,
                                    "{name}: {:?}",
                                    told.hints
                                );
                            } else {
                                assert!(told.hints.last().unwrap().text.contains(&words.did), "{name}");
                            }
                        }
                    }
                }
            }
        }
    }
    println!(
        "{answers} answers, {single} told as one method, {limits} of them with a limiting case that tells it from the right one, {odd} of these with a number that is visibly wrong"
    );
    assert!(
        leaking.is_empty(),
        "{} hints hold a right number\n{}",
        leaking.len(),
        leaking[..leaking.len().min(20)].join("\n")
    );
    assert!(answers > 1500 && single * 10 > answers * 8, "{single} of {answers}");
    assert!(limits * 10 > single * 4 && odd * 30 > single, "{odd}, {limits} of {single}");
}

/// Slips come first, `none` names nothing, `nudge` gives two steps, an unknown answer is called unknown.
#[test]
fn slips_come_first_and_the_bank_rules_how_much_is_told() {
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 22, "tutor");
            let variant = maker.variant("1").unwrap();
            let key = maker.key(&variant);
            for (part, entry) in key.parts.iter().enumerate() {
                let Answer::Number { value, .. } = entry.answer else { continue };
                let unit = if entry.unit.is_number() { "" } else { entry.unit.ascii() };
                let cell = |x: f64| format!("{} {unit}", shown::significant(entry.unit.from_si(x), 6));
                let at = (problem, &variant, &key);
                let name = format!("{} {}", problem.id, entry.part);
                for (wrong, slip) in [(1000.0 * value, true), (-value, true), (1.8765 * value, false)] {
                    let cell = cell(wrong);
                    let told = tell(at, (part, &cell), Hints::Explain, "en");
                    if !told.methods.is_empty() || told.verdict == Verdict::Right {
                        continue;
                    }
                    let first = told.hints.first().map(|h| h.step);
                    if slip {
                        assert_eq!(first, Some(HintKind::Slip), "{name} {cell}: {told:?}");
                    } else if first == Some(HintKind::Nudge) {
                        let unknown = Words::english().get("tutor.unknown").to_owned();
                        assert!(told.hints[0].text.starts_with(&unknown), "{name} {cell}: {told:?}");
                    }
                    let few = tell(at, (part, &cell), Hints::Nudge, "en");
                    assert_eq!(few.hints, told.hints[..told.hints.len().min(2)], "{name} {cell}");
                    let none = tell(at, (part, &cell), Hints::None, "en");
                    assert_eq!((none.hints.len(), none.methods.len()), (0, 0), "{name} {cell}");
                    // That only the sign is wrong is not named either.
                    let outside = (Verdict::Wrong, "not within the tolerance");
                    assert_eq!((none.verdict, &*none.reason), outside, "{name} {cell}");
                }
                assert!(tell(at, (part, &cell(value)), Hints::Explain, "en").hints.is_empty(), "{name}");
                assert!(tell(at, (part, ""), Hints::Explain, "en").hints.is_empty(), "{name}");
                assert!(tell(at, (part, "about so"), Hints::Explain, "en").hints.is_empty(), "{name}");
            }
        }
    }
}
