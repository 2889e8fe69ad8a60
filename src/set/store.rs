//! set.json: what a set is made of, to text and back.
use crate::bank::load;
use crate::finding::Finding;
use crate::set::stored;
use crate::sheet::self_check::Hosting;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Version of the layout of set.json.
pub const FORMAT: u32 = 1;

/// A stored set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredSet {
    /// Version of this layout.
    pub format: u32,
    /// Name of the set; part of every seed.
    pub name: String,
    /// Seed.
    pub seed: u64,
    /// Program and version that made it.
    pub program: String,
    /// Version of the drawing.
    pub draw_version: u32,
    /// Language of the sheets.
    #[serde(default = "english")]
    pub language: String,
    /// Formats of the sheets, by the endings of their files.
    #[serde(default = "first_formats")]
    pub formats: Vec<String>,
    /// Where the program of sheets that check themselves lies.
    #[serde(default)]
    pub page: Hosting,
    /// The bank.
    pub bank: StoredBank,
    /// The SHA-256 of its key.csv, as [`StoredSet::sealed`] wrote it; sets of versions before 4 of the drawing have none.
    #[serde(default)]
    pub key_sha256: Option<String>,
    /// Ids of the problems, in the order of the sheet.
    pub problems: Vec<String>,
    /// Students in the order of the roster, late joiners behind.
    pub students: Vec<StoredStudent>,
    /// Pairs with an equal problem, or with all numeric answers of a problem within tolerance of each other.
    pub coincidences: Vec<Coincidence>,
}

/// Sets of earlier versions are English.
fn english() -> String {
    "en".to_owned()
}

/// And of these formats.
fn first_formats() -> Vec<String> {
    vec!["md".to_owned(), "html".to_owned()]
}

/// Which bank.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct StoredBank {
    /// Id of the bank.
    pub id: String,
    /// The copy in the set's folder.
    pub file: String,
    /// SHA-256 of the copy, hex.
    pub sha256: String,
}

/// One student.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct StoredStudent {
    /// Id, as in the roster.
    pub student: String,
    /// Name; empty if the roster has none.
    pub name: String,
    /// Folder below `students`.
    pub folder: String,
    /// What was drawn for each problem.
    pub problems: Vec<StoredVariant>,
}

/// One problem of one student.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredVariant {
    /// Id of the problem.
    pub id: String,
    /// Name of the case; empty if the problem has only one.
    pub case: String,
    /// How many draws it took.
    pub tries: u32,
    /// Which rule refused how many of them.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub refused: Map<String, Value>,
    /// Symbol to value with unit, exactly as printed.
    pub data: Map<String, Value>,
    /// Parts that were asked with other data, as a quiz may do that draws each part by itself: none on sheets.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub parts: BTreeMap<String, StoredVariant>,
}

/// Digits of Crockford's base 32, small: no i, l, o and u, which are taken for others.
const DIGITS: &[u8; 32] = b"0123456789abcdefghjkmnpqrstvwxyz";

impl StoredVariant {
    /// The code by which a variant is known where its student is not, as in the question bank of a learning platform: eight digits
    /// to base 32, five bits each, of the SHA-256 of its problem, its case and its data as they are printed, one on a line. It is
    /// the same for whoever has the same data, and tells no more than they do.
    pub fn code(&self) -> String {
        let mut hash = Sha256::new();
        let mut line = |text: &str| {
            hash.update(text.as_bytes());
            hash.update(b"\n");
        };
        line(&self.id);
        line(&self.case);
        for (symbol, value) in &self.data {
            line(&format!("{symbol} = {}", value.as_str().unwrap_or_default()));
        }
        let digest = hash.finalize();
        let bits = digest.iter().take(5).fold(0u64, |bits, byte| bits << 8 | u64::from(*byte));
        (0..8).rev().map(|i| char::from(DIGITS[(bits >> (5 * i) & 31) as usize])).collect()
    }
    /// A datum as printed, without its unit: equal symbols have equal units within a problem.
    pub fn number(&self, symbol: &str) -> Option<f64> {
        let printed = self.data.get(symbol)?.as_str()?;
        printed.split_whitespace().next()?.parse().ok().filter(|x: &f64| x.is_finite())
    }
    /// What differs between this stored variant and one drawn anew.
    pub fn difference(&self, new: &StoredVariant) -> Option<String> {
        let old = self;
        if old.id != new.id {
            return Some(format!("the problem is `{}` in the set, `{}` when drawn anew", old.id, new.id));
        }
        if old.case != new.case {
            return Some(format!("the case is `{}` in the set, `{}` when drawn anew", old.case, new.case));
        }
        let shown = |v: Option<&Value>| match v {
            Some(Value::String(text)) => format!("`{text}`"),
            Some(other) => format!("`{other}`"),
            None => "missing".to_owned(),
        };
        let names = old.data.keys().chain(new.data.keys().filter(|k| !old.data.contains_key(*k)));
        for name in names {
            if old.data.get(name) != new.data.get(name) {
                let (old, new) = (shown(old.data.get(name)), shown(new.data.get(name)));
                return Some(format!("{name} is {old} in the set, {new} when drawn anew"));
            }
        }
        None
    }
}

/// Two students whose problems are too much alike.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coincidence {
    /// Id of the problem.
    pub problem: String,
    /// `equal data` or `answers within tolerance`.
    pub what: String,
    /// The two.
    pub students: [String; 2],
}

impl StoredSet {
    /// Reads set.json. Errors: what is wrong with it, with its place.
    pub fn parse(text: &str) -> Result<Self, Finding> {
        stored(text, ("set", "generate"), |set: &Self| set.format, FORMAT)
    }

    /// The text of set.json with the SHA-256 of its key.csv: a later version that draws otherwise, or solves otherwise, knows by
    /// it that the key is the one that was published.
    pub fn sealed(&self, key: &[u8]) -> String {
        self.written(Some(load::hash(&String::from_utf8_lossy(key))))
    }

    /// The text of set.json, without a seal: its key.csv is another or none.
    pub fn text(&self) -> String {
        self.written(None)
    }

    /// A line for each field, and one for each student and each coincidence.
    fn written(&self, key_sha256: Option<String>) -> String {
        // Maps with text keys and finite numbers only: this cannot fail.
        let fields = serde_json::to_value(self).unwrap_or_default();
        let lines = fields.as_object().into_iter().flatten().filter_map(|(name, value)| {
            let text = match (name.as_str(), value.as_array()) {
                ("key_sha256", _) => Value::from(key_sha256.as_deref()?).to_string(),
                ("students" | "coincidences", Some(items)) if !items.is_empty() => {
                    let items: Vec<String> = items.iter().map(|item| format!("    {item}")).collect();
                    format!("[\n{}\n  ]", items.join(",\n"))
                }
                _ => value.to_string(),
            };
            Some(format!("  \"{name}\": {text}"))
        });
        format!("{{\n{}\n}}\n", lines.collect::<Vec<_>>().join(",\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variant(id: &str, case: &str, data: &[(&str, &str)]) -> StoredVariant {
        let data = data.iter().map(|(name, value)| ((*name).to_owned(), Value::from(*value))).collect();
        let (refused, parts) = (Map::new(), BTreeMap::new());
        StoredVariant { id: id.into(), case: case.into(), tries: 1, refused, data, parts }
    }

    /// Made anew with Python: hashlib.sha256(b"pulled-rolling\nfriction up\nm = 47 kg\n...").digest()[:5] to base 32.
    #[test]
    fn the_code_is_that_of_the_printed_data() {
        let data = [
            ("m", "47 kg"),
            ("R", "0.44 m"),
            ("r", "0.14 m"),
            ("k", "0.26 m"),
            ("theta", "20 deg"),
            ("P", "360 N"),
            ("d", "0.5 m"),
            ("mu_s", "0.85"),
            ("g", "9.81 m/s^2"),
        ];
        let one = variant("pulled-rolling", "friction up", &data);
        assert_eq!(one.code(), "d9g6rc5z");
        assert_eq!(StoredVariant { tries: 9, ..one.clone() }.code(), one.code());
        // Whatever is printed otherwise has another code: a digit, a name, the order, the case, the problem.
        let mut others = vec![one.code()];
        let mut printed = data;
        printed[0].1 = "47.0 kg";
        others.push(variant("pulled-rolling", "friction up", &printed).code());
        let mut named = data;
        named[1].0 = "S";
        others.push(variant("pulled-rolling", "friction up", &named).code());
        let mut turned = data;
        turned.swap(0, 1);
        others.push(variant("pulled-rolling", "friction up", &turned).code());
        others.push(variant("pulled-rolling", "", &data).code());
        others.push(variant("spring-released", "friction up", &data).code());
        let all = others.len();
        others.sort();
        others.dedup();
        assert_eq!(others.len(), all);
    }
}
