//! sheet.json as it is read: the file, and the problem that it puts, as the tree of a bank with the drawn data in their place.
use crate::bank::node::{self, Node};
use crate::finding::{Finding, Findings};
use serde::Deserialize;
use serde_json::{Map, Value};

/// Version of the layout.
pub const FORMAT: u32 = 1;

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
    /// What is asked.
    #[serde(default)]
    pub parts: Vec<SheetPart>,
}

/// One part of a problem of a sheet file.
#[derive(Debug, Deserialize)]
pub struct SheetPart {
    /// Id.
    pub id: String,
    /// The relative tolerance.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// The words that are offered, where they are not the usual ones.
    #[serde(default)]
    pub words: Vec<String>,
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
    /// The tree of a bank that holds this problem with its drawn data, or `None` if the sheet carries no scene.
    ///
    /// # Errors
    /// The drawn data are not those of the scene.
    pub fn bank_tree(&self) -> Result<Option<Node>, Findings> {
        if self.scene.is_null() {
            return Ok(None);
        }
        let path = |rest: &str| format!("problems[{}].{rest}", self.number.saturating_sub(1));
        let mut faults = Findings::default();
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
            return Err(Finding::new(path("scene"), "holds no data of this problem").into());
        };
        for (symbol, fields) in data.iter_mut() {
            let field = path(&format!("data.{symbol}"));
            match (said(symbol, "value"), said(symbol, "unit"), fields) {
                (Some(value), Some(unit), Value::Object(fields)) => {
                    fields.insert("draw".to_owned(), Value::from(format!("always {value}")));
                    fields.insert("unit".to_owned(), Value::from(unit));
                }
                // What this student is not given is not there: a particle, a slope.
                (_, _, Value::Object(fields)) if !self.data.contains_key(symbol) => {
                    fields.insert("draw".to_owned(), Value::from("none"));
                }
                _ => faults.push(Finding::new(field, "needs a value and a unit, as texts")),
            }
        }
        let mut tree = node(&bank);
        tree.name_paths("");
        faults.into_result(Some(tree))
    }
}

/// What JSON holds, as texts without places.
fn node(value: &Value) -> Node {
    let text = |text: &str| Node {
        value: node::Value::Text(text.to_owned()),
        line: 0,
        column: 0,
        path: String::new(),
    };
    let value = match value {
        Value::Null => node::Value::Empty,
        Value::String(written) => node::Value::Text(written.clone()),
        Value::Bool(_) | Value::Number(_) => node::Value::Text(value.to_string()),
        Value::Array(items) => node::Value::List(items.iter().map(node).collect()),
        Value::Object(fields) => {
            node::Value::Map(fields.iter().map(|(name, value)| (text(name), node(value))).collect())
        }
    };
    Node { value, line: 0, column: 0, path: String::new() }
}
