//! The class of a grading, as reports take it: students with what was drawn, parts with what is asked, how it was graded.
use crate::bank::{Bank, Question, Relative};
use crate::folder::graded::OpenGrading;
use crate::report::class::About;
use crate::report::marks::{MarkedClass, MarkedPart};
use crate::report::{settings, table};
use crate::set::dealer::Dealt;
use crate::words::Words;

/// The title of a problem, or its id.
pub fn title_of(bank: &Bank, id: &str) -> String {
    bank.problems.iter().find(|p| p.id == id).map_or_else(|| id.to_owned(), |p| p.title.clone())
}

/// The class of a grading, without marks; texts are those of `bank`, the grading's in the language of the report.
pub fn of(graded: &OpenGrading, bank: &Bank, words: &Words) -> MarkedClass {
    let indices: Vec<Option<&crate::bank::Problem>> =
        graded.set.problems.iter().map(|id| bank.problems.iter().find(|p| p.id == *id)).collect();
    let parts: Vec<MarkedPart> = indices
        .iter()
        .enumerate()
        .flat_map(|(i, problem)| {
            let questions = problem.map_or(&[][..], |p| &p.questions);
            questions.iter().map(move |q| MarkedPart {
                number: i + 1,
                id: q.id.clone(),
                points: graded
                    .policy
                    .points_given(i + 1, problem.map_or("", |p| p.id.as_str()), &q.id)
                    .unwrap_or(q.points),
                unit: q.unit.ascii().to_owned(),
                unit_required: q.unit_required,
                asked: asked(&q.ask).to_owned(),
                tolerance: tolerance(q, words),
            })
        })
        .collect();
    let asks = |sheet: &Dealt, part: &MarkedPart| {
        let problem = part.number.checked_sub(1).and_then(|i| sheet.key.problems.get(i));
        problem.is_some_and(|p| p.parts.iter().any(|entry| entry.part == part.id))
    };
    let asked = graded.given.iter().flat_map(|sheet| parts.iter().map(move |p| asks(sheet, p))).collect();
    let problems = graded.set.problems.iter().map(|id| title_of(bank, id)).collect();
    MarkedClass {
        students: graded.set.students.clone(),
        problems,
        parts,
        asked,
        day_first: graded.policy.day_first,
    }
}

/// What a question asks; nothing where a template makes it of the variant.
pub fn asked(ask: &str) -> &str {
    if ask.contains("{{") || ask.contains("{%") || ask.contains("{#") { "" } else { ask.trim() }
}

/// The rule of the tolerance in words.
fn tolerance(question: &Question, words: &Words) -> String {
    if question.label.quantity.is_word() {
        return String::new();
    }
    let share = |s: f64| words.number(&format!("{} %", table::points(s * 100.0)));
    let text = match question.relative {
        Relative::Fixed(s) => share(s),
        Relative::Widens { least, per_cond, most } => {
            let pieces = [("least", share(least)), ("most", share(most)), ("each", share(per_cond))];
            words
                .say("report.tolerance.widens", &pieces.each_ref().map(|(name, text)| (*name, text.as_str())))
        }
    };
    match question.absolute.filter(|w| *w > 0.0) {
        None => text,
        Some(width) => {
            let width = words.number(&width.to_string());
            words.say("report.tolerance.at_least", &[("share", &text), ("width", &width)])
        }
    }
}

/// How it was graded and of what, in words.
pub fn about(basis: &OpenGrading, bank: &Bank, words: &Words) -> About {
    let grading = &basis.grading;
    let hash = |hash: &str| format!("SHA-256 {}…", hash.chars().take(16).collect::<String>());
    let say = |name: &str, pieces: &[(&str, &str)]| words.say(&format!("report.provenance.{name}"), pieces);
    let mut provenance = Vec::new();
    let mut add = |name: &str, value: String| provenance.push((say(name, &[]), value));
    add("program", grading.program.clone());
    let bytes = grading.submissions_bytes.to_string();
    add("submissions", say("bytes", &[("file", &grading.submissions), ("n", &bytes)]));
    let (seed, version) = (grading.seed.to_string(), grading.draw_version.to_string());
    let draw = say("draw", &[("set", &grading.set), ("seed", &seed), ("version", &version)]);
    add("set", if grading.replayed { draw } else { say("not_replayed", &[("draw", &draw)]) });
    add("bank", format!("{}, {}", grading.bank, hash(&grading.bank_sha256)));
    add("key", hash(&grading.key_sha256));
    if let Some(sha256) = &grading.course_sha256 {
        add("course", hash(sha256));
    }
    add("language", grading.language.clone());
    if !grading.columns.is_empty() {
        add("columns", grading.columns.join(", "));
    }
    if grading.untimed > 0 {
        add("by_row", say("untimed", &[("n", &grading.untimed.to_string())]));
    }
    if grading.undated > 0 {
        add("undated", say("undated_answers", &[("n", &grading.undated.to_string())]));
    }
    if !grading.unused_columns.is_empty() {
        add("not_used", grading.unused_columns.join(", "));
    }
    About {
        title: if basis.policy.title.is_empty() { bank.title.clone() } else { basis.policy.title.clone() },
        set: basis.set.name.clone(),
        settings: settings::in_words(&basis.policy, words),
        provenance,
    }
}
