//! sheet.json: what a student needs to check answers alone. It holds the drawn data and the scene, never the key.
//!
//! For hints it holds the wrong methods that the bank lists, too, as they are written there: for every student and case the
//! same.
//!
//! The scene is a question (`public_problem`): what is asked of which bodies, without what happens to them. It has no regimes, no
//! bounds, no cases and no ranges, and is the same for every student of the problem; what is drawn stands beside it. With the
//! drawn data put in their place it is read by the ordinary reader of banks and solved anew. A case with a scene of its own
//! gives that one, as its statement does. A bank with `self check: off` gives sheets without scenes.
use crate::bank::node::Node;
use crate::bank::{Bank, Case, Mistake, Problem, labels, node, synonyms, yaml};
use crate::finding::Finding;
use crate::page::sheet_file::FORMAT;
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::scene::{Label, Scene};
use serde_json::{Map, Value, json};
use std::fmt::Write as _;

/// Writes sheet files of one set.
pub struct Writer<'b> {
    bank: &'b Bank,
    set: &'b str,
    language: &'b str,
    problems: Vec<usize>,
    /// For each problem of the sheet and each of its cases: the scene as JSON text; `null` without self-check.
    scenes: Vec<Vec<String>>,
}

impl<'b> Writer<'b> {
    /// Prepares the scenes from the text of the bank. Errors: the text is not that of the bank.
    pub fn new(
        bank: &'b Bank,
        text: &str,
        problems: &[usize],
        set: &'b str,
        language: &'b str,
    ) -> Result<Self, Finding> {
        let mut tree = yaml::tree(text)?;
        synonyms::put(&mut tree);
        let mut scenes = Vec::new();
        for problem in problems.iter().filter_map(|p| bank.problems.get(*p)) {
            let text = |case| match bank.self_check {
                true => public_problem(bank, &tree, problem, case).to_string(),
                false => "null".to_owned(),
            };
            scenes.push(problem.cases.iter().map(text).collect());
        }
        Ok(Self { bank, set, language, problems: problems.to_vec(), scenes })
    }

    /// The file of one student.
    pub fn text(&self, student: &str, variants: &[Variant]) -> String {
        let quote = |text: &str| Value::from(text).to_string();
        let mut out = format!(
            "{{\n\"format\": {FORMAT},\n\"student\": {},\n\"set\": {},\n\"language\": {},\n\"problems\": [",
            quote(student),
            quote(self.set),
            quote(self.language)
        );
        for (i, index) in self.problems.iter().enumerate() {
            let (problem, variant) = (&self.bank.problems[*index], &variants[i]);
            let comma = if i == 0 { "" } else { "," };
            let id = quote(&problem.id);
            let _ = write!(out, "{comma}\n{{\"number\": {}, \"id\": {id},\n \"data\": {{", i + 1);
            let mut first = true;
            for (d, datum) in problem.data.iter().enumerate() {
                if let Some(number) = variant.values.get(d).copied().flatten() {
                    let comma = if first { "" } else { ", " };
                    first = false;
                    let value = number.text();
                    let (symbol, unit) = (quote(&datum.symbol), quote(datum.unit.ascii()));
                    let _ = write!(out, "{comma}{symbol}: {{\"value\": \"{value}\", \"unit\": {unit}}}");
                }
            }
            out.push_str("},\n \"parts\": [");
            for (p, q) in problem.questions.iter().enumerate() {
                let comma = if p == 0 { "" } else { ",\n  " };
                // The relative tolerance, not the half-width: that would give the key away.
                let mut part = json!({
                    "id": q.id,
                    "quantity": q.label.quantity.name(),
                    "unit": q.unit.ascii(),
                    "points": q.points,
                    "tolerance": if q.label.quantity.is_word() { 0.0 } else { variant.within[p] },
                });
                // The scene has no regimes: where they leave a list that is not the usual pair, it is said here.
                let list = make_key::offered(problem, q.label.quantity, &problem.cases[variant.case].scene);
                if q.label.quantity.is_word() && list.contains(&"stays") {
                    part["words"] = json!(list);
                }
                let _ = write!(out, "{comma}{part}");
            }
            let scene = self.scenes.get(i).and_then(|s| s.get(variant.case)).map_or("null", String::as_str);
            let _ = write!(out, "],\n \"scene\": {scene}}}");
        }
        out.push_str("\n]\n}\n");
        out
    }
}

fn to_json(node: &Node) -> Value {
    match &node.value {
        node::Value::Empty => Value::Null,
        node::Value::Text(text) => Value::from(text.as_str()),
        node::Value::List(items) => items.iter().map(to_json).collect(),
        node::Value::Map(fields) => Value::Object(
            fields.iter().map(|(k, v)| (k.text().unwrap_or("").to_owned(), to_json(v))).collect(),
        ),
    }
}

/// Can a wrong method be read in the scene of each case? Then the sheets of all cases list it.
fn is_everywhere(problem: &Problem, mistake: &Mistake) -> bool {
    let expressions = mistake.data.iter().map(|(_, e)| e).chain(mistake.values.iter().map(|(_, e)| e));
    let labels = expressions.flat_map(|e| e.quantities()).chain(mistake.of.iter().copied());
    let mut labels: Vec<Label> = labels.chain(mistake.values.iter().map(|(label, _)| *label)).collect();
    labels.dedup();
    let known = |scene: &Scene, label: Label| labels::named(scene, &scene.name_of(label)).is_ok();
    problem.cases.iter().all(|case| labels.iter().all(|label| known(&case.scene, *label)))
}

/// A text of the bank in the language of the sheet, where the bank has one.
fn put(fields: &mut Map<String, Value>, name: &str, text: &str) {
    if let Some(field) = fields.get_mut(name) {
        *field = Value::from(text);
    }
}

/// A problem as it is put to everybody: the scene that is asked about, the data that are given, the questions, and wrong methods; of
/// the whole bank the settings that checking needs, as they are written.
///
/// These fields are all that a sheet says of a problem besides the drawn data, so that nothing of how a draw came about can get
/// into it.
fn public_problem(bank: &Bank, tree: &Node, problem: &Problem, case: &Case) -> Value {
    let whole = tree.field("problems").and_then(|p| p.field(&problem.id));
    let of = |name: &str, id: &str| whole.and_then(|p| p.field(name)).and_then(|list| list.field(id));
    // What is written of something in a list, without the fields that are for who reads the bank.
    let written = |list: &str, id: &str, without: &[&str]| {
        let Some(Value::Object(mut fields)) = of(list, id).map(to_json) else { return None };
        without.iter().for_each(|name| drop(fields.shift_remove(*name)));
        Some(fields)
    };
    let data = problem.data.iter().filter_map(|datum| {
        let mut fields = written("data", &datum.symbol, &["draw"])?;
        put(&mut fields, "name", &datum.name);
        Some((datum.symbol.clone(), Value::Object(fields)))
    });
    let questions = problem.questions.iter().filter_map(|q| {
        let mut fields = written("questions", &q.id, &["unguarded"])?;
        put(&mut fields, "ask", &q.ask);
        Some((q.id.clone(), Value::Object(fields)))
    });
    // A case of a wrong method would tell which one was drawn.
    let mistakes = problem.mistakes.iter().filter(|m| is_everywhere(problem, m)).filter_map(|mistake| {
        let fields = written("mistakes", &mistake.id, &["unguarded", "cases"])?;
        Some((mistake.id.clone(), Value::Object(fields)))
    });
    let own = of("cases", &case.written).and_then(|c| c.field("scene"));
    let scene = own.or_else(|| whole.and_then(|p| p.field("scene")));
    let mut asked = json!({
        "title": problem.title,
        "data": data.collect::<Map<_, _>>(),
        "scene": scene.map_or(Value::Null, to_json),
        "questions": questions.collect::<Map<_, _>>(),
    });
    let mistakes: Map<String, Value> = mistakes.collect();
    if !mistakes.is_empty() {
        asked["mistakes"] = Value::Object(mistakes);
    }
    let mut public = json!({"bank": tree.field("bank").map(to_json), "title": bank.title});
    for name in ["reveal", "tolerance", "units"] {
        if let Some(setting) = tree.field(name) {
            public[name] = to_json(setting);
        }
    }
    if let Some(level) = tree.field("grading").and_then(|g| g.field("hints")) {
        public["grading"] = json!({"hints": to_json(level)});
    }
    public["problems"] = json!({&problem.id: asked});
    public
}
