//! The text of a YAML file to a tree of texts with places; keeper of the YAML crate.
use crate::bank::node::{Node, Value};
use crate::finding::Finding;
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_yaml::{Spanned, from_str_with_options, options};
use std::fmt;

/// Largest file that is read, bytes: a hundred times the built-in banks.
pub const MAX_BYTES: usize = 4 << 20;

/// Text to a tree of texts with places.
pub fn tree(text: &str) -> Result<Node, Finding> {
    if text.len() > MAX_BYTES {
        return Err(Finding::new("", format!("the file has {} bytes; {MAX_BYTES} are read", text.len())));
    }
    let settings = || {
        options! {
            strict_booleans: true,
            with_snippet: false,
            duplicate_keys: serde_yaml::DuplicateKeyPolicy::LastWins,
            budget: serde_yaml::budget! { max_depth: 48, max_nodes: 400_000, flow_nesting_limit: 48 },
        }
    };
    // Syntax first: a wrong indent must not be told as a missing field.
    from_str_with_options::<serde::de::IgnoredAny>(text, settings()).map_err(|e| syntax(&e))?;
    let raw: Spanned<Raw> = from_str_with_options(text, settings()).map_err(|e| syntax(&e))?;
    let mut node = place(raw, text);
    node.name_paths("");
    Ok(node)
}

fn syntax(error: &serde_yaml::Error) -> Finding {
    let message = error.without_snippet().to_string();
    let message = message.lines().next().unwrap_or("cannot be read").to_owned();
    // The place is told before the message.
    let message = message.split(" at line ").next().unwrap_or("cannot be read").trim_end_matches(',');
    let mut finding = Finding::new("", format!("YAML: {message}"));
    if let Some(breach) = message.strip_prefix("budget breached: ") {
        let (what, hint) = if breach.contains("Depth") {
            ("lists and maps are nested too deeply", "48 levels are read")
        } else {
            // Any other limit is reached by aliases alone.
            (
                "the file holds too much, with what each alias stands for counted each time",
                "aliases (`*name`) within aliases multiply: write out what is meant",
            )
        };
        finding = Finding::new("", format!("YAML: {what}")).hint(hint);
    }
    match error.location() {
        Some(at) if at.line() > 0 => finding.at(small(at.line()), small(at.column())),
        _ => finding,
    }
}

fn small(n: u64) -> usize {
    usize::try_from(n).unwrap_or(usize::MAX)
}

enum Raw {
    Empty,
    Text(String),
    /// A scalar that YAML takes for a number or a truth value: its text is looked up in the source.
    Plain(String),
    List(Vec<Spanned<Raw>>),
    Map(Vec<(Spanned<Raw>, Spanned<Raw>)>),
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RawVisitor)
    }
}

struct RawVisitor;

impl<'de> Visitor<'de> for RawVisitor {
    type Value = Raw;
    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("anything")
    }
    fn visit_unit<E>(self) -> Result<Raw, E> {
        Ok(Raw::Empty)
    }
    fn visit_none<E>(self) -> Result<Raw, E> {
        Ok(Raw::Empty)
    }
    fn visit_bool<E>(self, v: bool) -> Result<Raw, E> {
        Ok(Raw::Plain(v.to_string()))
    }
    fn visit_i64<E>(self, v: i64) -> Result<Raw, E> {
        Ok(Raw::Plain(v.to_string()))
    }
    fn visit_u64<E>(self, v: u64) -> Result<Raw, E> {
        Ok(Raw::Plain(v.to_string()))
    }
    fn visit_f64<E>(self, v: f64) -> Result<Raw, E> {
        Ok(Raw::Plain(v.to_string()))
    }
    fn visit_str<E>(self, v: &str) -> Result<Raw, E> {
        Ok(Raw::Text(v.to_owned()))
    }
    fn visit_string<E>(self, v: String) -> Result<Raw, E> {
        Ok(Raw::Text(v))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Raw, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = seq.next_element()? {
            list.push(item);
        }
        Ok(Raw::List(list))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Raw, A::Error> {
        let mut list = Vec::new();
        while let Some(entry) = map.next_entry()? {
            list.push(entry);
        }
        Ok(Raw::Map(list))
    }
}

fn place(raw: Spanned<Raw>, source: &str) -> Node {
    let at = raw.referenced;
    let value = match raw.value {
        Raw::Empty => Value::Empty,
        Raw::Text(t) => Value::Text(t),
        Raw::Plain(t) => {
            let span = raw.defined.span();
            let written = span.byte_offset().zip(span.byte_len()).and_then(|(start, len)| {
                let start = usize::try_from(start).ok()?;
                let len = usize::try_from(len).ok()?;
                source.get(start..start.checked_add(len)?)
            });
            Value::Text(written.map_or(t, |w| w.trim().to_owned()))
        }
        Raw::List(items) => Value::List(items.into_iter().map(|n| place(n, source)).collect()),
        Raw::Map(fields) => {
            Value::Map(fields.into_iter().map(|(k, v)| (place(k, source), place(v, source))).collect())
        }
    };
    Node { value, line: small(at.line()), column: small(at.column()), path: String::new() }
}
