//! The text of a bank to a bank.
use crate::bank::node::{Faults, Node, Value};
use crate::bank::{Bank, Variables, schema};
use crate::bank::{synonyms, yaml};
use crate::finding::Findings;
use sha2::{Digest, Sha256};
use std::{fmt, io};

/// Reads a bank. All findings come at once; only a fault of the YAML syntax stands alone.
///
/// `file` is the name shown in findings; `variables` finds the names that a statement or question uses.
pub fn bank(text: &str, file: &str, variables: Variables) -> Result<Bank, Findings> {
    read(text, file, Some(variables))
}

fn read(text: &str, file: &str, variables: Option<Variables>) -> Result<Bank, Findings> {
    let mut tree = yaml::tree(text).map_err(|f| f.in_file(file))?;
    synonyms::put(&mut tree);
    let mut bank = checked(&tree, file, variables)?;
    bank.hash = hash(text);
    bank.places =
        texts(&tree).map(|(field, node)| (field, (file.to_owned(), node.line, node.column))).collect();
    Ok(bank)
}

/// Reads the tree of a bank, with a look into its templates where it can tell their variables. Errors: all that is wrong with it.
pub fn checked(tree: &Node, file: &str, variables: Option<Variables>) -> Result<Bank, Findings> {
    let faults = Faults::default();
    match schema::bank(tree, variables, &faults) {
        Some(bank) if faults.is_empty() => Ok(bank),
        _ => {
            if faults.is_empty() {
                faults.at(tree, "this is no bank");
            }
            Err(faults.into_sorted(file))
        }
    }
}

/// Statements and wordings of questions, in a bank or in a file of texts in another language that replaces them
/// (`overlay.rs`): the field path that each has in the bank, and its node.
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

/// SHA-256 of a file, hex, read in a stream. Errors: reading fails.
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
