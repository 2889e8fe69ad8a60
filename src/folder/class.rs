//! The class of a grading, as reports take it: students with what was drawn, parts with what is asked, how it was graded.
use crate::bank::Bank;
use crate::bank::Question;
use crate::bank::Relative;
use crate::folder::graded::OpenGrading;
use crate::report::class::About;
use crate::report::marks::Class;
use crate::report::marks::Drawn;
use crate::report::marks::Part;
use crate::report::marks::Problem;
use crate::report::marks::Student;
use crate::report::settings;
use crate::report::table;
use crate::set::given::GivenSheet;

/// The title of a problem, or its id.
pub fn title_of(bank: &Bank, id: &str) -> String {
    bank.problems.iter().find(|p| p.id == id).map_or_else(|| id.to_owned(), |p| p.title.clone())
}

/// The class of a grading, without marks.
pub fn of(graded: &OpenGrading) -> Class {
    let indices: Vec<Option<&crate::bank::Problem>> =
        graded.set.problems.iter().map(|id| graded.bank.problems.iter().find(|p| p.id == *id)).collect();
    let parts: Vec<Part> = indices
        .iter()
        .enumerate()
        .flat_map(|(i, problem)| {
            let questions = problem.map_or(&[][..], |p| &p.questions);
            questions.iter().map(move |q| Part {
                number: i + 1,
                id: q.id.clone(),
                points: graded
                    .policy
                    .points_given(i + 1, problem.map_or("", |p| p.id.as_str()), &q.id)
                    .unwrap_or(q.points),
                unit: q.unit.ascii().to_owned(),
                unit_required: q.unit_required,
                asked: asked(&q.ask).to_owned(),
                tolerance: tolerance(q),
            })
        })
        .collect();
    let students: Vec<Student> = graded.set.students.iter().map(student).collect();
    let asks = |sheet: &GivenSheet, part: &Part| {
        let problem = part.number.checked_sub(1).and_then(|i| sheet.key.problems.get(i));
        problem.is_some_and(|p| p.parts.iter().any(|entry| entry.part == part.id))
    };
    let asked = graded.given.iter().flat_map(|sheet| parts.iter().map(move |p| asks(sheet, p))).collect();
    let problems = graded
        .set
        .problems
        .iter()
        .map(|id| Problem { id: id.clone(), title: title_of(&graded.bank, id) })
        .collect();
    Class { students, problems, parts, asked, day_first: graded.policy.day_first }
}

/// What a question asks; nothing where a template makes it of the variant.
pub fn asked(ask: &str) -> &str {
    if ask.contains("{{") || ask.contains("{%") || ask.contains("{#") { "" } else { ask.trim() }
}

/// The rule of the tolerance in words.
fn tolerance(question: &Question) -> String {
    if question.label.quantity.is_word() {
        return String::new();
    }
    let share = |s: f64| format!("{} %", table::points(s * 100.0));
    let mut text = match question.relative {
        Relative::Fixed(s) => share(s),
        Relative::Widens { least, per_cond, most } => format!(
            "{} to {}: {} for each unit of the condition number",
            share(least),
            share(most),
            share(per_cond)
        ),
    };
    if let Some(width) = question.absolute.filter(|w| *w > 0.0) {
        text.push_str(&format!(", at least {width} in SI units"));
    }
    text
}

/// A student of the set with the numbers that were drawn.
fn student(stored: &crate::set::store::StoredStudent) -> Student {
    let drawn = stored.problems.iter().map(|variant| {
        let data = variant.data.iter().filter_map(|(symbol, value)| {
            let text = value.as_str()?;
            let number = text.split_whitespace().next()?.parse::<f64>().ok()?;
            number.is_finite().then(|| (symbol.clone(), number))
        });
        Drawn { case: variant.case.clone(), data: data.collect() }
    });
    Student {
        id: stored.student.clone(),
        name: stored.name.clone(),
        folder: stored.folder.clone(),
        drawn: drawn.collect(),
    }
}

/// How it was graded and of what, in words.
pub fn about(basis: &OpenGrading) -> About {
    let grading = &basis.grading;
    let short = |hash: &str| hash.chars().take(16).collect::<String>();
    let mut provenance = Vec::new();
    let mut add = |name: &str, value: String| provenance.push((name.to_owned(), value));
    add("Graded by", grading.program.clone());
    add("Submissions", format!("{}, {} bytes", grading.submissions, grading.submissions_bytes));
    let replayed = match grading.replayed {
        true => "",
        false => ", of an earlier version: not replayed, graded by its stored key",
    };
    add(
        "Set",
        format!("{}, seed {}, draw version {}{replayed}", grading.set, grading.seed, grading.draw_version),
    );
    add("Bank", format!("{}, SHA-256 {}…", grading.bank, short(&grading.bank_sha256)));
    add("Key", format!("SHA-256 {}…", short(&grading.key_sha256)));
    if let Some(hash) = &grading.course_sha256 {
        add("Course file", format!("SHA-256 {}…", short(hash)));
    }
    add("Language", grading.language.clone());
    if !grading.columns.is_empty() {
        add("Columns", grading.columns.join(", "));
    }
    if grading.untimed > 0 {
        let n = grading.untimed;
        add("By row", format!("attempts at {n} answers, because a submitted_at cannot be read"));
    }
    if grading.undated > 0 {
        add("Undated", format!("{} answers that count have no time that can be read", grading.undated));
    }
    if !grading.unused_columns.is_empty() {
        add("Not used", grading.unused_columns.join(", "));
    }
    About {
        title: if basis.policy.title.is_empty() {
            basis.bank.title.clone()
        } else {
            basis.policy.title.clone()
        },
        set: basis.set.name.clone(),
        settings: settings::in_words(&basis.policy),
        provenance,
    }
}
