//! What one problem with given data comes to: regime, conditions, every quantity by both derivations; as a table and as JSON.
use crate::bank::{Bank, Problem, any};
use crate::finding::Finding;
use crate::inspect::data::{fits, printed};
use crate::inspect::sentences;
use crate::num::shown;
use crate::problem::maker::Unsatisfiable;
use crate::scene::{Label, Quantity, Scene};
use crate::sheet::terminal;
use crate::solve::ladder::{self, Taken, Wish};
use crate::solve::method::Rung;
use crate::solve::outcome::{Entry, Solved};
use crate::words::Words;
use std::fmt::Write as _;

/// That no draw holds the rules: which refused, what came out, why it has no solution if it has none; and where the data are
/// constants, all that `solve` says of them.
pub fn unsatisfiable(bank: &Bank, none: &Unsatisfiable) -> Finding {
    let mut text = none.to_string();
    if let Some(problem) = bank.problems.iter().find(|p| p.id == none.problem)
        && let Some(case) = problem.cases.get(none.index)
    {
        if let (Some(refusal), None) = (&none.unsolved, &none.disagreement) {
            for why in sentences::refusal(problem, &case.scene, refusal) {
                text.push_str(&format!("\n    {why}"));
            }
        }
        if let Some((values, data)) = &none.constant
            && let Ok((solved, taken)) = ladder::solve(&case.scene, data, &Wish::default())
        {
            let holds = fits(problem, none.index, &solved);
            let shown = printed(problem, values);
            let told = table(problem, none.index, &shown, &solved, &taken, holds);
            text.push('\n');
            text.push_str(told.trim_end());
        }
    }
    Finding::new(format!("problems.{}", none.problem), text)
}

/// JSON numbers with 17 significant digits; null where there is none.
fn number(value: Option<f64>) -> String {
    match value {
        // A zero has no sign for a reader: -0.0 + 0.0 is 0.0.
        Some(v) if v.is_finite() => format!("{:.16e}", v + 0.0),
        _ => "null".to_owned(),
    }
}

fn method_json(taken: &Taken) -> String {
    let setting = match taken.rung {
        Rung::Closed | Rung::Doubles | Rung::Settled => "\"setting\": null".to_owned(),
        Rung::Gauss(points) => format!("\"points\": {points}"),
        Rung::Adaptive(_, rtol, _) => format!("\"rtol\": {}", number(Some(rtol))),
        Rung::Fixed(_, step) => format!("\"step_s\": {}", number(Some(step))),
    };
    format!(
        "{{\"name\": \"{}\", {setting}, \"chosen\": {}, \"why\": {}, \"evaluations\": {}, \"steps\": {}, \"evaluations_of_the_estimate\": {}, \"relative_error\": {}}}",
        taken.rung.method().as_str(),
        taken.chosen,
        string(&sentences::why(taken)),
        taken.count.evaluations,
        taken.count.steps,
        taken.estimate.evaluations,
        if taken.errors.is_empty() { "null".to_owned() } else { number(Some(taken.worst)) }
    )
}

fn string(text: &str) -> String {
    // A text always has a JSON form.
    serde_json::to_string(text).unwrap_or_default()
}

/// A list or an object of JSON, a line for each of its entries.
fn lines([open, close]: [char; 2], entries: impl Iterator<Item = String>) -> String {
    match entries.collect::<Vec<_>>().join(",\n    ") {
        none if none.is_empty() => format!("{open}{close}"),
        all => format!("{open}\n    {all}\n  {close}"),
    }
}

/// The same as JSON.
pub fn json(problem: &Problem, case: usize, solved: &Solved, taken: &Taken) -> String {
    let scene = &problem.cases[case].scene;
    let checks = solved.checks.iter().map(|check| {
        let (name, ok) = (check.kind.name(), check.ok);
        let detail = string(&sentences::check(scene, &solved.checks, check));
        format!("{{\"name\": \"{name}\", \"ok\": {ok}, \"detail\": {detail}}}")
    });
    let quantities = rows(problem, case, solved, taken).into_iter().map(|row| {
        let value = row.word.map_or_else(|| number(row.value), string);
        let (last, error) =
            if taken.errors.is_empty() { ("bound", row.bound) } else { ("error", row.error) };
        format!(
            "{}: {{\"value\": {value}, \"unit\": {}, \"eom\": {}, \"energy\": {}, \"gap\": {}, \"cond\": {}, \"{last}\": {}}}",
            string(&row.name),
            string(row.unit),
            number(row.eom),
            number(row.energy),
            number(row.gap),
            number(row.cond),
            number(error)
        )
    });
    let questions = problem.questions.iter().map(|question| {
        let value = match solved.word(question.label) {
            Some(word) => string(word.as_str()),
            None => {
                let told = |e: &Entry| question.unit.from_si(Scene::as_told(e.label, e.value()));
                number(solved.get(question.label).map(told))
            }
        };
        let (id, quantity) = (string(&question.id), string(&scene.name_of(question.label)));
        let unit = string(if question.label.quantity.is_word() { "" } else { question.unit.ascii() });
        format!("{id}: {{\"quantity\": {quantity}, \"value\": {value}, \"unit\": {unit}}}")
    });
    let names =
        |labels: &[Label]| labels.iter().map(|l| string(&scene.name_of(*l))).collect::<Vec<_>>().join(", ");
    format!(
        "{{\n  \"problem\": {},\n  \"regime\": {},\n  \"method\": {},\n  \"checks\": {},\n  \"quantities\": {},\n  \"questions\": {},\n  \"beyond\": [{}],\n  \"open\": [{}]\n}}\n",
        string(&problem.id),
        string(&solved.regime.word()),
        method_json(taken),
        lines(['[', ']'], checks),
        lines(['{', '}'], quantities),
        lines(['{', '}'], questions),
        names(&solved.beyond),
        names(&solved.open)
    )
}

#[derive(Default)]
struct QuantityRow<'s> {
    order: usize,
    /// What it is; `None` for a word.
    label: Option<Label>,
    name: String,
    unit: &'s str,
    word: Option<&'static str>,
    value: Option<f64>,
    eom: Option<f64>,
    energy: Option<f64>,
    gap: Option<f64>,
    cond: Option<f64>,
    /// Proved bound of the error, for the printed data.
    bound: Option<f64>,
    /// Estimated error of the method, absolute.
    error: Option<f64>,
}

/// All quantities in the order of their list.
fn rows<'s>(problem: &'s Problem, case: usize, solved: &'s Solved, taken: &Taken) -> Vec<QuantityRow<'s>> {
    let scene = &problem.cases[case].scene;
    let place = |q: Quantity| Quantity::ALL.iter().position(|o| *o == q).unwrap_or(usize::MAX);
    let mut rows: Vec<QuantityRow> = solved
        .entries
        .iter()
        .filter(|e| any::is_told(scene, e.label))
        .map(|e| QuantityRow {
            order: place(e.label.quantity),
            label: Some(e.label),
            name: scene.name_of(e.label),
            unit: scene.unit(e.label),
            word: None,
            value: Some(Scene::as_told(e.label, e.value())),
            eom: e.eom.map(|value| Scene::as_told(e.label, value)),
            energy: e.energy.map(|value| Scene::as_told(e.label, value)),
            gap: e.gap(),
            cond: Some(e.cond),
            bound: e.bound,
            error: taken.errors.iter().find(|(l, _)| *l == e.label).map(|(_, error)| *error),
        })
        .chain(solved.words.iter().map(|(label, word)| QuantityRow {
            order: place(label.quantity),
            name: scene.name_of(*label),
            word: Some(word.as_str()),
            ..QuantityRow::default()
        }))
        .collect();
    rows.sort_by_key(|r| r.order);
    rows
}

/// What the numbers mean where the regime fails.
pub const NUMBERS_OF_TIES: &str = "; the numbers below are those of the declared ties";

/// What really happens, whether it is what the problem declares, and each condition.
pub fn regime(problem: &Problem, case: usize, solved: &Solved, holds: bool) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = format!(
        "regime: {} ({})\n",
        solved.regime.word(),
        sentences::regime(&Words::english(), solved.regime)
    );
    if !holds {
        let regimes = &problem.cases[case].regimes;
        let declared = match regimes.join(", ") {
            any if any.is_empty() => String::new(),
            some => format!(" ({some})"),
        };
        let told = match solved.failing(regimes) {
            Some(check) if !regimes.is_empty() && solved.regime.is_one_of(regimes, scene) => {
                format!("This is what the problem declares{declared}, but {} fails", check.kind.name())
            }
            _ if regimes.is_empty() => "This is not what the ties say".to_owned(),
            _ => format!("This is not what the problem declares{declared}"),
        };
        let numbers = if solved.entries.is_empty() { "" } else { NUMBERS_OF_TIES };
        let _ = writeln!(out, "{told}{numbers}.");
    }
    for check in &solved.checks {
        let mark = if check.ok { "holds" } else { "FAILS" };
        let _ = writeln!(
            out,
            "  {mark}  {}: {}",
            check.kind.name(),
            sentences::check(scene, &solved.checks, check)
        );
    }
    out
}

/// Regime, method and every quantity, as a table for people.
pub fn table(
    problem: &Problem,
    case: usize,
    shown: &[String],
    solved: &Solved,
    taken: &Taken,
    holds: bool,
) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = format!("{}: {}\n", problem.id, shown.join(", "));
    out.push_str(&regime(problem, case, solved, holds));
    let _ = writeln!(out, "method: {}", sentences::taken(taken));
    let numerical = !taken.errors.is_empty();
    let mut lines = vec![
        ["quantity", "value", "unit", "equations of motion", "work and energy", "gap", "cond"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for row in rows(problem, case, solved, taken) {
        // What is asked is told in the unit in which it is asked.
        let asked = problem.questions.iter().find(|q| Some(q.label) == row.label);
        let own = |v: f64| asked.map_or(v, |q| q.unit.from_si(v));
        let road = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| shown::significant(own(v), 12));
        lines.push(vec![
            row.name,
            row.word.map_or_else(|| shown::significant(own(row.value.unwrap_or(f64::NAN)), 5), str::to_owned),
            asked.filter(|_| row.word.is_none()).map_or(row.unit, |q| q.unit.ascii()).to_owned(),
            if row.word.is_some() { String::new() } else { road(row.eom) },
            if row.word.is_some() { String::new() } else { road(row.energy) },
            row.gap.map_or_else(String::new, |g| if g == 0.0 { "0".to_owned() } else { format!("{g:.0e}") }),
            row.cond.map_or_else(String::new, |c| shown::significant(c, 3)),
        ]);
        if let (true, Some(line)) = (numerical, lines.last_mut()) {
            line.push(row.error.map_or_else(String::new, |e| shown::significant(own(e), 2)));
        }
    }
    if let (true, Some(head)) = (numerical, lines.first_mut()) {
        head.push("est. error".to_owned());
    }
    if lines.len() > 1 {
        out.push_str(&terminal::table(&lines, &[0, 2]));
    }
    if scene.formulas.numbers.iter().any(|n| n.any) {
        out.push_str("What is `any` is taken as 1 kg or 1 m; what depends on it is not shown.\n");
    }
    for (told, labels) in [
        ("Left open by statics, for several ties share one force", &solved.open),
        ("Not shown, for no double holds them to 16 digits", &solved.beyond),
    ] {
        if !labels.is_empty() {
            let names: Vec<String> = labels.iter().map(|l| scene.name_of(*l)).collect();
            let _ = writeln!(out, "{told}: {}", names.join(", "));
        }
    }
    out
}
