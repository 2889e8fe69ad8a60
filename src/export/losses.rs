//! What a platform's questions cannot carry of what `grade` reads and does, question by question, for the instructor.
use crate::bank::{Problem, Question};
use crate::export::{Export, ExportFormat, QuestionLayout, moodle, units};
use crate::problem::make_key;
use crate::set::key_file::shortest;

/// What no platform does.
const NOWHERE: &str =
    "no decimal comma, no points for what follows from an earlier answer, no hint for a wrong method";

/// What is lost where each part is a question.
const APART: &str =
    "each part is a question of its own, and may be drawn from another variant than the parts beside it";

/// Units named at most.
const NAMED: usize = 3;

/// What is lost of the chosen problems, a line each; the tolerances are not: each platform gets those of the key.
pub fn losses(export: &Export, chosen: &[usize]) -> Vec<String> {
    let mut lines = vec![format!("every question: {NOWHERE}")];
    if export.layout != QuestionLayout::Whole {
        lines.push(format!("every question: {APART}"));
    }
    lines.extend(guessed(export, chosen));
    for (i, problem) in chosen.iter().map(|i| (*i, export.problems[*i])) {
        for question in &problem.questions {
            let lost = of_question(export, problem, question);
            if !lost.is_empty() {
                lines.push(format!("{}.{}: {}", i + 1, question.id, lost.join("; ")));
            }
        }
        if export.layout == QuestionLayout::Whole && export.platform == ExportFormat::Moodle {
            lines.extend(points(problem).map(|lost| format!("{}: {lost}", i + 1)));
        }
    }
    lines
}

/// The parts whose word is chosen from a list where it would be typed elsewhere.
fn guessed(export: &Export, chosen: &[usize]) -> Option<String> {
    if export.platform == ExportFormat::Moodle {
        return None;
    }
    let words: Vec<String> = chosen
        .iter()
        .flat_map(|i| export.problems[*i].questions.iter().map(move |question| (i + 1, question)))
        .filter(|(_, question)| question.label.quantity.is_word())
        .map(|(at, question)| format!("{at}.{}", question.id))
        .collect();
    (!words.is_empty()).then(|| {
        format!(
            "every question: an answer that is a word is chosen from a list and can be guessed: {}",
            words.join(", ")
        )
    })
}

fn of_question(export: &Export, problem: &Problem, question: &Question) -> Vec<String> {
    let mut lost = Vec::new();
    if question.label.quantity.is_word() {
        if export.platform == ExportFormat::Moodle {
            lost.push("a word as `grade` reads it, but no sentence around it".to_owned());
        }
        return lost;
    }
    let known = units::units(&question.unit);
    let asked = question.unit.ascii();
    let mut others: Vec<(&str, f64)> = known.iter().map(|(name, times)| (name.as_str(), *times)).collect();
    // Other spellings of a unit are no other unit.
    others.dedup_by(|next, known| next.1.total_cmp(&known.1).is_eq());
    if !question.unit.is_number() {
        let some = others.iter().skip(1).take(NAMED).map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
        lost.push(match export.layout {
            QuestionLayout::PartsWithUnits if some.is_empty() => format!("only the unit {asked}"),
            QuestionLayout::PartsWithUnits => format!("only the units offered ({asked}, {some} ...)"),
            _ if some.is_empty() => format!("a number in {asked}, the unit not typed"),
            _ => format!("a number in {asked}, the unit not typed, no other one ({some} ...)"),
        });
    }
    if problem.cases.iter().any(|case| make_key::sense_words(&case.scene, question.label).is_some()) {
        lost.push("signed, no direction in words".to_owned());
    }
    lost
}

/// Points that are no whole numbers, where weights have to be.
fn points(problem: &Problem) -> Option<String> {
    let points: Vec<f64> = problem.questions.iter().map(|q| q.points).collect();
    let weights = moodle::weights(&points);
    let texts: Vec<String> = points.iter().map(|p| shortest(*p)).collect();
    let whole: Vec<String> = weights.iter().map(u64::to_string).collect();
    (texts != whole).then(|| {
        format!(
            "points {} become the weights {}; give the question {} marks in the quiz",
            texts.join(", "),
            whole.join(", "),
            shortest(points.iter().sum())
        )
    })
}
