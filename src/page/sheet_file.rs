//! sheet.json as it is read: the file, and the problem that it puts, as the tree of a bank with the drawn data in their place.
use crate::bank::node::{self, Node};
use crate::finding::{Finding, Findings};
use serde_json::Value;

/// Version of the layout.
pub const FORMAT: u32 = 1;

/// A sheet file as it is read.
#[derive(Debug)]
pub struct SheetFile {
    /// Version of the layout.
    pub format: Option<u32>,
    /// Student id.
    pub student: String,
    /// Name of the set.
    pub set: String,
    /// Language in which the student is answered; English if it does not say.
    pub language: Option<String>,
    /// The problems.
    pub problems: Vec<SheetProblem>,
}

/// One problem of a sheet file.
#[derive(Debug)]
pub struct SheetProblem {
    /// Number in the sheet.
    pub number: usize,
    /// Id.
    pub id: String,
    /// The bank of this problem; nothing if the instructor does not want self-checks.
    pub scene: Node,
    /// The drawn data by symbol: value and unit, where both are texts.
    pub data: Vec<(String, Option<[String; 2]>)>,
    /// What is asked.
    pub parts: Vec<SheetPart>,
}

/// One part of a problem of a sheet file.
#[derive(Debug)]
pub struct SheetPart {
    /// Id.
    pub id: String,
    /// The relative tolerance.
    pub tolerance: Option<f64>,
    /// The words that are offered, where they are not the usual ones.
    pub words: Vec<String>,
}

impl SheetFile {
    /// Reads a sheet file. Errors: what is wrong with it, with its place.
    pub fn parse(text: &str) -> Result<Self, Finding> {
        let value: Value =
            serde_json::from_str(text).map_err(|e| Finding::of_json("sheet file", &e).hint(HINT))?;
        Self::of(&value)
    }

    /// The sheet file that stands in this JSON. Errors: what is wrong with it, with its field.
    pub fn of(value: &Value) -> Result<Self, Finding> {
        let format = match value.get("format") {
            None | Some(Value::Null) => None,
            Some(other) => match other.as_u64().and_then(|n| u32::try_from(n).ok()) {
                Some(FORMAT) => Some(FORMAT),
                _ => {
                    return Err(Finding::new("format", format!("is {other}; this program reads {FORMAT}")));
                }
            },
        };
        let problem = |(i, value): (usize, &Value)| SheetProblem::of(value, &format!("problems[{i}]."));
        Ok(Self {
            format,
            student: text(value, "student", "")?,
            set: text(value, "set", "")?,
            language: value.get("language").and_then(Value::as_str).map(str::to_owned),
            problems: list(value, "problems", "")?
                .iter()
                .enumerate()
                .map(problem)
                .collect::<Result<_, _>>()?,
        })
    }
}

/// What to do about a file that is none of these.
const HINT: &str = "give the file sheet.json that came with your sheet";

/// A field is not there, below this path.
fn wanted(path: &str, name: &str, what: &str) -> Finding {
    Finding::new(format!("{path}{name}"), format!("is no sheet file: {what} is expected here")).hint(HINT)
}

fn text(value: &Value, name: &str, path: &str) -> Result<String, Finding> {
    let text = value.get(name).and_then(Value::as_str);
    text.map(str::to_owned).ok_or_else(|| wanted(path, name, "a text"))
}

fn list<'v>(value: &'v Value, name: &str, path: &str) -> Result<&'v [Value], Finding> {
    let list = value.get(name).and_then(Value::as_array);
    list.map(Vec::as_slice).ok_or_else(|| wanted(path, name, "a list"))
}

impl SheetPart {
    fn of(value: &Value, path: &str) -> Result<Self, Finding> {
        let words = value.get("words").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        Ok(Self {
            id: text(value, "id", path)?,
            tolerance: value.get("tolerance").and_then(Value::as_f64),
            words: words.iter().filter_map(Value::as_str).map(str::to_owned).collect(),
        })
    }
}

impl SheetProblem {
    fn of(value: &Value, path: &str) -> Result<Self, Finding> {
        let parts = match value.get("parts") {
            None => &[][..],
            Some(_) => list(value, "parts", path)?,
        };
        let number = value.get("number").and_then(Value::as_u64).and_then(|n| usize::try_from(n).ok());
        let datum = |(symbol, datum): (&String, &Value)| {
            let text = |name| Some(datum.get(name)?.as_str()?.to_owned());
            (symbol.clone(), text("value").zip(text("unit")).map(|(value, unit)| [value, unit]))
        };
        let data = value.get("data").and_then(Value::as_object).map(|all| all.iter().map(datum).collect());
        Ok(Self {
            number: number.ok_or_else(|| wanted(path, "number", "a whole number"))?,
            id: text(value, "id", path)?,
            scene: value.get("scene").map_or(Node { value: node::Value::Empty, ..Node::of_text("") }, node),
            data: data.ok_or_else(|| wanted(path, "data", "the drawn data"))?,
            parts: parts.iter().map(|part| SheetPart::of(part, path)).collect::<Result<_, _>>()?,
        })
    }

    /// The tree of a bank that holds this problem with its drawn data, or `None` if the sheet carries no scene.
    /// Errors: the drawn data are not those of the scene.
    pub fn bank_tree(&self) -> Result<Option<Node>, Findings> {
        if matches!(self.scene.value, node::Value::Empty) {
            return Ok(None);
        }
        let path = |rest: &str| format!("problems[{}].{rest}", self.number.saturating_sub(1));
        let mut faults = Findings::default();
        let mut bank = self.scene.clone();
        let said = |symbol: &str| self.data.iter().find(|(name, _)| name == symbol).map(|(_, said)| said);
        if let Some(Some([value, unit])) = said("g") {
            bank.set("gravity", &format!("{value} {unit}"));
        }
        let data = bank.field_mut("problems").and_then(|p| p.field_mut(&self.id)?.field_mut("data"));
        let Some(Node { value: node::Value::Map(data), .. }) = data else {
            return Err(Finding::new(path("scene"), "holds no data of this problem").into());
        };
        for (symbol, fields) in data {
            let symbol = symbol.text().unwrap_or_default();
            match (said(symbol), &fields.value) {
                (Some(Some([value, unit])), node::Value::Map(_)) => {
                    fields.set("draw", &format!("always {value}"));
                    fields.set("unit", unit);
                }
                // What this student is not given is not there: a particle, a slope.
                (None, node::Value::Map(_)) => fields.set("draw", "none"),
                _ => faults.push(Finding::new(
                    path(&format!("data.{symbol}")),
                    "needs a value and a unit, as texts",
                )),
            }
        }
        bank.name_paths("");
        faults.into_result(Some(bank))
    }
}

/// What JSON holds, as texts without places.
fn node(value: &Value) -> Node {
    let value = match value {
        Value::String(written) => node::Value::Text(written.clone()),
        Value::Bool(_) | Value::Number(_) => node::Value::Text(value.to_string()),
        Value::Null => node::Value::Empty,
        Value::Array(items) => node::Value::List(items.iter().map(node).collect()),
        Value::Object(fields) => {
            node::Value::Map(fields.iter().map(|(name, value)| (Node::of_text(name), node(value))).collect())
        }
    };
    Node { value, ..Node::of_text("") }
}
