//! Text to bank; keeper of the YAML crate.
use crate::bank::Bank;
use crate::bank::Variables;
use crate::bank::node::{Faults, Node, Value};
use crate::bank::schema;
use crate::finding::Finding;
use crate::finding::Findings;
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_yaml::{Spanned, from_str_with_options, options};
use sha2::{Digest, Sha256};
use std::fmt;
use std::io;

/// Largest bank that is read, bytes: a hundred times the built-in ones.
pub const MAX_BYTES: usize = 4 << 20;

/// Reads a bank. All findings come at once; only a fault of the YAML syntax stands alone.
///
/// `file` is the name shown in findings; `variables` finds the names that a statement or question uses.
pub fn bank(text: &str, file: &str, variables: Variables) -> Result<Bank, Findings> {
    read(text, file, Some(variables))
}

fn read(text: &str, file: &str, variables: Option<Variables>) -> Result<Bank, Findings> {
    let tree = tree(text).map_err(|f| f.in_file(file))?;
    let faults = Faults::default();
    let read = schema::bank(&tree, variables, &faults);
    match read {
        Some(mut bank) if faults.is_empty() => {
            bank.hash = hash(text);
            bank.places = texts(&tree)
                .map(|(field, node)| (field, (file.to_owned(), node.line, node.column)))
                .collect();
            Ok(bank)
        }
        _ => {
            if faults.is_empty() {
                faults.at(&tree, "this is no bank");
            }
            Err(faults.into_sorted(file))
        }
    }
}

/// The statements and questions of a bank or of texts put over one: field path in the bank, and node.
pub fn texts(tree: &Node) -> impl Iterator<Item = (String, &Node)> {
    fn fields(node: &Node) -> &[(Node, Node)] {
        match &node.value {
            Value::Map(fields) => fields,
            _ => &[],
        }
    }
    let field = |node, name: &'static str| {
        fields(node).iter().filter(move |(k, _)| k.text() == Some(name)).map(|(_, v)| v)
    };
    let problems = field(tree, "problems").flat_map(fields).map(|(_, problem)| problem);
    problems.flat_map(move |problem| {
        let statements = field(problem, "statement").map(|node| (node.path.clone(), node));
        let asks = field(problem, "questions").flat_map(fields).flat_map(move |(_, q)| field(q, "ask"));
        let over = field(problem, "ask").flat_map(fields).map(|(id, node)| {
            (format!("{}.questions.{}.ask", problem.path, id.text().unwrap_or_default()), node)
        });
        statements.chain(asks.map(|node| (node.path.clone(), node))).chain(over)
    })
}

/// Reads a bank without looking into its templates, for uses that show no text.
pub fn scenes_only(text: &str, file: &str) -> Result<Bank, Findings> {
    read(text, file, None)
}

/// SHA-256 of a text, hex.
pub fn hash(text: &str) -> String {
    hex(&Sha256::digest(text.as_bytes()))
}

/// SHA-256 of a file, hex, read in a stream.
///
/// # Errors
/// Reading fails.
pub fn hash_of(mut source: impl io::Read) -> io::Result<String> {
    let (mut hash, mut piece) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match source.read(&mut piece)? {
            0 => return Ok(hex(&hash.finalize())),
            n => hash.update(&piece[..n]),
        }
    }
}

fn hex(bytes: &[u8]) -> String {
    use fmt::Write as _;
    bytes.iter().fold(String::with_capacity(64), |mut hex, byte| {
        // Writing to a String cannot fail.
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

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
            // Whatever was counted: no bank comes near the limits but by aliases.
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
