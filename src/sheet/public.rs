//! sheet.json: what a student needs to check answers alone. It holds the drawn data and the scene, never the key.
//!
//! The scene is a bank of one problem and one case without its ranges; with the drawn data put in their place it is
//! read by the ordinary reader of banks and solved anew. A bank with `self check: off` gives sheets without scenes.
use crate::bank::Bank;
use crate::bank::Problem;
use crate::bank::load;
use crate::bank::node;
use crate::bank::node::Node;
use crate::finding::Finding;
use crate::problem::make::Variant;
use crate::sheet::statement;
use serde::Deserialize;
use serde_json::Map;
use serde_json::Value;
use serde_json::json;
use std::fmt::Write as _;

/// Version of the layout.
pub const FORMAT: u32 = 1;

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
    /// Prepares the scenes from the text of the bank.
    ///
    /// # Errors
    /// The text is not that of the bank.
    pub fn new(
        bank: &'b Bank,
        text: &str,
        problems: &[usize],
        set: &'b str,
        language: &'b str,
    ) -> Result<Self, Finding> {
        let tree = load::tree(text)?;
        let mut scenes = Vec::new();
        for problem in problems.iter().filter_map(|p| bank.problems.get(*p)) {
            let cases = 0..problem.cases.len();
            scenes.push(if bank.self_check {
                cases.map(|case| scene(bank, &tree, problem, case).to_string()).collect()
            } else {
                cases.map(|_| "null".to_owned()).collect()
            });
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
                    let value = statement::decimal_text(number);
                    let (symbol, unit) = (quote(&datum.symbol), quote(datum.unit.ascii()));
                    let _ = write!(out, "{comma}{symbol}: {{\"value\": \"{value}\", \"unit\": {unit}}}");
                }
            }
            out.push_str("},\n \"parts\": [");
            for (p, q) in problem.questions.iter().enumerate() {
                let comma = if p == 0 { "" } else { ",\n  " };
                // The relative tolerance, not the half-width: that would give the key away.
                let part = json!({
                    "id": q.id,
                    "quantity": q.label.quantity.name(),
                    "unit": q.unit.ascii(),
                    "points": q.points,
                    "tolerance": if q.label.quantity.is_word() { 0.0 } else { variant.within[p] },
                });
                let _ = write!(out, "{comma}{part}");
            }
            let scene = self.scenes.get(i).and_then(|s| s.get(variant.case)).map_or("null", String::as_str);
            let _ = write!(out, "],\n \"scene\": {scene}}}");
        }
        out.push_str("\n]\n}\n");
        out
    }
}

fn field<'n>(node: &'n Node, name: &str) -> Option<&'n Node> {
    match &node.value {
        node::Value::Map(fields) => fields.iter().find(|(k, _)| k.text() == Some(name)).map(|(_, v)| v),
        _ => None,
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

/// A text of the bank in the language of the sheet, where the bank has one.
fn put(fields: &mut Map<String, Value>, name: &str, text: &str) {
    if let Some(field) = fields.get_mut(name) {
        *field = Value::from(text);
    }
}

/// A bank with this one case of this one problem, without ranges and bounds.
fn scene(bank: &Bank, tree: &Node, problem: &Problem, case: usize) -> Value {
    let mut out = Map::new();
    for name in ["bank", "title", "reveal", "tolerance", "units"] {
        if let Some(node) = field(tree, name) {
            out.insert(name.to_owned(), to_json(node));
        }
    }
    out.entry("title").or_insert_with(|| Value::from(""));
    put(&mut out, "title", &bank.title);
    let whole = field(tree, "problems").and_then(|p| field(p, &problem.id));
    let of_case = whole
        .and_then(|p| field(p, "cases"))
        .and_then(|c| problem.cases.get(case).and_then(|this| field(c, &this.name)));
    let mut one = Map::new();
    one.insert("title".to_owned(), Value::from(problem.title.as_str()));
    let mut data = Map::new();
    for (i, datum) in problem.data.iter().enumerate() {
        let drawn = problem.cases.get(case).and_then(|c| c.draws.get(i)).is_some_and(Option::is_some);
        let written = whole.and_then(|p| field(p, "data")).and_then(|d| field(d, &datum.symbol));
        if let (true, Some(written)) = (drawn, written) {
            let mut fields = to_json(written);
            if let Value::Object(fields) = &mut fields {
                fields.shift_remove("draw");
                put(fields, "name", &problem.data[i].name);
            }
            data.insert(datum.symbol.clone(), fields);
        }
    }
    one.insert("data".to_owned(), Value::Object(data));
    for name in ["scene", "regimes"] {
        if let Some(node) =
            of_case.and_then(|c| field(c, name)).or_else(|| whole.and_then(|p| field(p, name)))
        {
            one.insert(name.to_owned(), to_json(node));
        }
    }
    let mut questions = Map::new();
    for q in &problem.questions {
        if let Some(node) = whole.and_then(|p| field(p, "questions")).and_then(|n| field(n, &q.id)) {
            let mut fields = to_json(node);
            if let Value::Object(fields) = &mut fields {
                put(fields, "ask", &q.ask);
            }
            questions.insert(q.id.clone(), fields);
        }
    }
    one.insert("questions".to_owned(), Value::Object(questions));
    out.insert("problems".to_owned(), json!({ problem.id.as_str(): one }));
    Value::Object(out)
}

/// A sheet file as it is read.
#[derive(Debug, Deserialize)]
pub struct SheetFile {
    /// Version of the layout.
    #[serde(default)]
    pub format: Option<u32>,
    /// Student id.
    pub student: String,
    /// Name of the set.
    pub set: String,
    /// Language in which the student is answered; English if it does not say.
    #[serde(default)]
    pub language: Option<String>,
    /// The problems.
    pub problems: Vec<SheetProblem>,
}

/// One problem of a sheet file.
#[derive(Debug, Deserialize)]
pub struct SheetProblem {
    /// Number in the sheet.
    pub number: usize,
    /// Id.
    pub id: String,
    /// The bank of this problem; null if the instructor does not want self-checks.
    #[serde(default)]
    pub scene: Value,
    /// The drawn data.
    pub data: Map<String, Value>,
}

impl SheetFile {
    /// Reads a sheet file.
    ///
    /// # Errors
    /// What is wrong with it, with its place.
    pub fn parse(text: &str) -> Result<Self, Finding> {
        let sheet: Self = serde_json::from_str(text).map_err(|e| {
            let words = e.to_string();
            let words = words.split(" at line ").next().unwrap_or("cannot be read").to_owned();
            Finding::new("", format!("is no sheet file: {words}"))
                .at(e.line().max(1), e.column().max(1))
                .hint("give the file sheet.json that came with your sheet")
        })?;
        match sheet.format {
            None | Some(FORMAT) => Ok(sheet),
            Some(other) => Err(Finding::new("format", format!("is {other}; this program reads {FORMAT}"))),
        }
    }
}

impl SheetProblem {
    /// The text of a bank that holds this problem with its drawn data, or `None` if the sheet carries no scene.
    ///
    /// # Errors
    /// The drawn data are not those of the scene.
    pub fn bank_text(&self) -> Result<Option<String>, Vec<Finding>> {
        if self.scene.is_null() {
            return Ok(None);
        }
        let path = |rest: &str| format!("problems[{}].{rest}", self.number.saturating_sub(1));
        let mut faults = Vec::new();
        let mut bank = self.scene.clone();
        let said = |symbol: &str, what: &str| {
            self.data.get(symbol).and_then(|d| d.get(what)).and_then(Value::as_str)
        };
        if let (Some(value), Some(unit)) = (said("g", "value"), said("g", "unit"))
            && let Some(fields) = bank.as_object_mut()
        {
            fields.insert("gravity".to_owned(), Value::from(format!("{value} {unit}")));
        }
        let data = bank
            .pointer_mut("/problems")
            .and_then(|p| p.get_mut(self.id.as_str()))
            .and_then(|p| p.get_mut("data"));
        let Some(Value::Object(data)) = data else {
            return Err(vec![Finding::new(path("scene"), "holds no data of this problem")]);
        };
        for (symbol, fields) in data.iter_mut() {
            let field = path(&format!("data.{symbol}"));
            match (said(symbol, "value"), said(symbol, "unit"), fields) {
                (Some(value), Some(unit), Value::Object(fields)) => {
                    fields.insert("draw".to_owned(), Value::from(format!("always {value}")));
                    fields.insert("unit".to_owned(), Value::from(unit));
                }
                _ => faults.push(Finding::new(field, "needs a value and a unit, as texts")),
            }
        }
        if faults.is_empty() { Ok(Some(bank.to_string())) } else { Err(faults) }
    }
}
