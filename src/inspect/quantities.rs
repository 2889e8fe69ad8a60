//! The quantities of a problem's scene: which may be asked, under which name, of what, in which unit and with which sign.
use crate::bank::{Problem, any, labels};
use crate::scene::{Label, Owner, Quantity};
use crate::sheet::terminal;
use serde_json::{Value, json};

/// A quantity that may be asked.
struct Askable {
    name: String,
    quantity: Quantity,
    /// What a question asks by a formula, and its unit.
    formula: Option<(String, String)>,
    /// The body or cord whose it is; empty for the scene as a whole.
    of: String,
    /// The questions that ask it.
    asked: Vec<String>,
}

/// The labels that every case of a problem can answer, in the order of the list.
fn askable(problem: &Problem) -> Vec<Askable> {
    let Some(first) = problem.cases.first().map(|case| &case.scene) else { return Vec::new() };
    let others: Vec<Vec<Label>> = problem.cases.iter().skip(1).map(|c| labels::of(&c.scene)).collect();
    let mut labels = labels::of(first);
    labels.retain(|label| any::is_told(first, *label));
    labels.retain(|label| others.iter().all(|other| other.contains(label)));
    labels.sort_by_key(|label| Quantity::ALL.iter().position(|q| *q == label.quantity));
    let asked = |label: Label| {
        let questions = problem.questions.iter().filter(move |q| q.label == label);
        questions.map(|q| q.id.clone()).collect()
    };
    let row = |label: Label| Askable {
        name: first.name_of(label),
        quantity: label.quantity,
        formula: match label.of {
            Owner::Asked(i) => first.formulas.asked.get(i).map(|a| (a.text.clone(), a.unit.clone())),
            _ => None,
        },
        of: first.owner_name(label.of).unwrap_or_default().into_owned(),
        asked: asked(label),
    };
    let formulas = first.formulas.asked.iter().enumerate();
    let formulas = formulas.map(|(i, a)| Label { quantity: a.quantity, of: Owner::Asked(i) });
    labels.into_iter().chain(formulas).map(row).collect()
}

impl Askable {
    /// What it is, which sign it has, and its unit.
    fn told(&self) -> (&str, &str, &str) {
        match &self.formula {
            Some((text, unit)) => (text, "", unit),
            None => {
                let (what, sign) = self.quantity.meaning_and_sign();
                (what, sign, if self.quantity.is_word() { "a word" } else { self.quantity.unit() })
            }
        }
    }
}

/// The others, with the reason why this scene has them not.
fn absent(problem: &Problem, there: &[Askable]) -> Vec<(Quantity, String)> {
    let Some(case) = problem.cases.first() else { return Vec::new() };
    let missing = Quantity::ALL.iter().filter(|q| there.iter().all(|a| a.quantity != **q));
    let reason = |q: Quantity| match labels::of(&case.scene).iter().any(|label| label.quantity == q) {
        true => "it depends on what is `any`, or not every case has it".to_owned(),
        false => labels::reason(&case.scene, q),
    };
    missing.map(|q| (*q, reason(*q))).collect()
}

/// As tables for people.
pub fn table(problem: &Problem) -> String {
    let there = askable(problem);
    let mut rows = vec![terminal::head("quantity | of | unit | asked as | what it is | sign")];
    for a in &there {
        let asked = if a.asked.is_empty() { "-".to_owned() } else { a.asked.join(", ") };
        let (what, sign, unit) = a.told();
        rows.push(vec![
            a.name.clone(),
            a.of.clone(),
            unit.to_owned(),
            asked,
            what.to_owned(),
            sign.to_owned(),
        ]);
    }
    let mut out = terminal::table(&rows, &[0, 1, 2, 3, 4, 5]);
    let mut reasons: Vec<(String, Vec<&str>)> = Vec::new();
    for (quantity, why) in absent(problem, &there) {
        match reasons.iter_mut().find(|(w, _)| *w == why) {
            Some((_, names)) => names.push(quantity.name()),
            None => reasons.push((why, vec![quantity.name()])),
        }
    }
    if !reasons.is_empty() {
        out.push_str("\nNot in this scene:\n");
        let rows: Vec<Vec<String>> =
            reasons.into_iter().map(|(why, names)| vec![why, names.join(", ")]).collect();
        out.push_str(&terminal::table(&rows, &[0, 1]));
    }
    out
}

/// The same as JSON.
pub fn json(problem: &Problem) -> String {
    let there = askable(problem);
    let may = there.iter().map(|a| {
        let (meaning, sign) = a.quantity.meaning_and_sign();
        let (meaning, unit) = match &a.formula {
            Some((text, unit)) => (text.as_str(), unit.as_str()),
            None => (meaning, a.quantity.unit()),
        };
        json!({"name": a.name, "meaning": meaning, "sign": sign, "unit": unit, "of": a.of, "may_be_asked": true, "asked_as": a.asked})
    });
    let absent = absent(problem, &there);
    let not = absent.iter().map(|(quantity, why)| {
        let (meaning, sign) = quantity.meaning_and_sign();
        let (name, unit) = (quantity.name(), quantity.unit());
        json!({"name": name, "meaning": meaning, "sign": sign, "unit": unit, "may_be_asked": false, "why": why})
    });
    let all: Vec<Value> = may.chain(not).collect();
    let value = json!({ "problem": problem.id, "quantities": all });
    // A tree of texts always has a JSON form.
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}
