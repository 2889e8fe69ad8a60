//! A bank as a tree of texts with places; what the texts mean is read elsewhere.
use crate::finding::{Finding, Findings};
use crate::units::spell;
use std::cell::RefCell;

/// One node of the tree.
#[derive(Debug, Clone)]
pub struct Node {
    /// What it holds.
    pub value: Value,
    /// Line, counted from 1; 0 if unknown.
    pub line: usize,
    /// Column, counted from 1; 0 if unknown.
    pub column: usize,
    /// Path of the field, such as `problems.pulled-rolling.data.m`.
    pub path: String,
}

/// What a node holds.
#[derive(Debug, Clone)]
pub enum Value {
    /// Nothing.
    Empty,
    /// A scalar, as it was written.
    Text(String),
    List(Vec<Node>),
    /// Fields in the order of the file; a name may stand twice. Each name is a node of its own, for its place.
    Map(Vec<(Node, Node)>),
}

impl Node {
    /// The text of a scalar.
    pub fn text(&self) -> Option<&str> {
        match &self.value {
            Value::Text(t) => Some(t),
            _ => None,
        }
    }
    /// The field of this name, of a map.
    pub fn field(&self, name: &str) -> Option<&Self> {
        match &self.value {
            Value::Map(fields) => fields.iter().find(|(k, _)| k.text() == Some(name)).map(|(_, v)| v),
            _ => None,
        }
    }
    /// The same, to change it.
    pub fn field_mut(&mut self, name: &str) -> Option<&mut Self> {
        match &mut self.value {
            Value::Map(fields) => fields.iter_mut().find(|(k, _)| k.text() == Some(name)).map(|(_, v)| v),
            _ => None,
        }
    }
    /// A text without a place.
    pub fn of_text(text: &str) -> Self {
        Self { value: Value::Text(text.to_owned()), line: 0, column: 0, path: String::new() }
    }
    /// Gives a map this text as a field, in the place of what stands there.
    pub fn set(&mut self, name: &str, text: &str) {
        if let Some(field) = self.field_mut(name) {
            *field = Self::of_text(text);
        } else if let Value::Map(fields) = &mut self.value {
            fields.push((Self::of_text(name), Self::of_text(text)));
        }
    }
    /// The same fields with those of another node in their places; `None` where one of the two has no fields.
    pub fn overlaid(&self, changes: &Self) -> Option<Self> {
        let (Value::Map(old), Value::Map(new)) = (&self.value, &changes.value) else { return None };
        let mut fields = old.clone();
        for (key, value) in new {
            match fields.iter_mut().find(|(k, _)| k.text() == key.text()) {
                Some((_, old)) => old.clone_from(value),
                None => fields.push((key.clone(), value.clone())),
            }
        }
        Some(Self { value: Value::Map(fields), ..changes.clone() })
    }
    /// What kind of thing it is, in words.
    pub fn kind(&self) -> String {
        match &self.value {
            Value::Empty => "nothing".to_owned(),
            Value::Text(t) => format!("`{}`", shorten(t)),
            Value::List(items) => format!("a list of {}", items.len()),
            Value::Map(fields) => {
                let names: Vec<&str> = fields.iter().take(4).filter_map(|(k, _)| k.text()).collect();
                format!("fields ({})", names.join(", "))
            }
        }
    }
    /// Gives every node below its path.
    pub fn name_paths(&mut self, path: &str) {
        path.clone_into(&mut self.path);
        match &mut self.value {
            Value::List(items) => {
                for (i, item) in items.iter_mut().enumerate() {
                    item.name_paths(&format!("{path}[{i}]"));
                }
            }
            Value::Map(fields) => {
                for (key, value) in fields {
                    let name = key.text().unwrap_or("?");
                    let below = if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
                    key.path.clone_from(&below);
                    value.name_paths(&below);
                }
            }
            Value::Empty | Value::Text(_) => {}
        }
    }
}

/// A text cut to a length that fits into a message.
pub fn shorten(text: &str) -> String {
    let mut line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(60).collect();
    if text.chars().count() > 60 {
        line.push_str("...");
    }
    line
}

/// Collects findings.
#[derive(Debug, Default)]
pub struct Faults {
    list: RefCell<Findings>,
}

impl Faults {
    /// Adds a finding at a node.
    pub fn at(&self, node: &Node, message: impl Into<String>) {
        self.push(node, || Finding::new(node.path.clone(), message));
    }
    /// Adds a finding at a node, with what would be right.
    pub fn hint(&self, node: &Node, message: impl Into<String>, hint: impl Into<String>) {
        self.push(node, || Finding::new(node.path.clone(), message).hint(hint));
    }
    /// Adds a finding at a node, with a hint if there is one.
    pub fn maybe(&self, node: &Node, message: impl Into<String>, hint: Option<String>) {
        self.push(node, || {
            let finding = Finding::new(node.path.clone(), message);
            if let Some(h) = hint { finding.hint(h) } else { finding }
        });
    }
    /// [`Faults::at`], where there is nothing to go on with.
    pub fn refuse<T>(&self, node: &Node, message: impl Into<String>) -> Option<T> {
        self.at(node, message);
        None
    }
    /// [`Faults::hint`], where there is nothing to go on with.
    pub fn refuse_with<T>(
        &self,
        node: &Node,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Option<T> {
        self.hint(node, message, hint);
        None
    }
    /// [`Faults::refuse_with`] of a node that is something else than was expected.
    pub fn expected<T>(&self, node: &Node, what: &str, hint: impl Into<String>) -> Option<T> {
        self.refuse_with(node, format!("expected {what}, found {}", node.kind()), hint)
    }
    fn push(&self, node: &Node, finding: impl FnOnce() -> Finding) {
        let finding = if node.line > 0 { finding().at(node.line, node.column) } else { finding() };
        let mut list = self.list.borrow_mut();
        if !list.contains(&finding) {
            list.push(finding);
        }
    }
    /// Has anything been found?
    pub fn is_empty(&self) -> bool {
        self.list.borrow().is_empty()
    }
    /// How many so far.
    pub fn count(&self) -> usize {
        self.list.borrow().len()
    }
    /// All findings in the order of the file.
    pub fn into_sorted(self, file: &str) -> Findings {
        let mut list: Findings = self.list.into_inner().in_file(file);
        list.sort_by_key(|f| f.at.unwrap_or((usize::MAX, 0)));
        list
    }
}

/// The fields of a map, taken by name; what is left over where they go out of scope is a finding.
pub struct Fields<'n> {
    /// The map.
    pub node: &'n Node,
    faults: &'n Faults,
    asked: Vec<&'static str>,
}

impl<'n> Fields<'n> {
    /// Opens a map; anything else is a finding.
    pub fn open(node: &'n Node, what: &str, faults: &'n Faults) -> Option<Self> {
        let Value::Map(entries) = &node.value else {
            return faults.refuse(node, format!("expected {what}, found {}", node.kind()));
        };
        for (i, (key, _)) in entries.iter().enumerate() {
            if let Some(text) = key.text()
                && entries[..i].iter().any(|(k, _)| k.text() == Some(text))
            {
                faults.hint(key, format!("`{}` stands twice", shorten(text)), "remove one of them");
            }
        }
        Some(Self { node, faults, asked: Vec::new() })
    }
    /// A field that may be absent.
    pub fn get(&mut self, name: &'static str) -> Option<&'n Node> {
        self.asked.push(name);
        self.node.field(name)
    }
    /// Several fields that may be absent.
    pub fn each<const N: usize>(&mut self, names: [&'static str; N]) -> [Option<&'n Node>; N] {
        names.map(|name| self.get(name))
    }
    /// A field that must be there.
    pub fn need(&mut self, name: &'static str, example: &str) -> Option<&'n Node> {
        let found = self.get(name);
        if found.is_none() {
            let hint = format!("for example `{name}: {example}`");
            self.faults.hint(self.node, format!("`{name}` is missing"), hint);
        }
        found
    }
    /// The value of a field that may be absent, as `read` reads it.
    pub fn read<T>(
        &mut self,
        name: &'static str,
        read: impl FnOnce(&'n Node, &Faults) -> Option<T>,
    ) -> Option<T> {
        self.get(name).and_then(|node| read(node, self.faults))
    }
    /// Sets what a field stands for, where it is there and `read` finds it sound.
    pub fn set<T>(
        &mut self,
        name: &'static str,
        to: &mut T,
        read: impl FnOnce(&'n Node, &Faults) -> Option<T>,
    ) {
        if let Some(value) = self.read(name, read) {
            *to = value;
        }
    }
}

impl Drop for Fields<'_> {
    /// Whatever was not asked for is unknown.
    fn drop(&mut self) {
        let Value::Map(entries) = &self.node.value else { return };
        for (key, _) in entries {
            match key.text() {
                Some(text) if self.asked.contains(&text) => {}
                Some(text) => {
                    let hint = spell::hint(text, "fields known here", self.asked.iter().copied());
                    self.faults.hint(key, format!("unknown field `{}`", shorten(text)), hint);
                }
                None => self.faults.at(key, "a field name must be a text"),
            }
        }
    }
}

/// A text that is not blank, without the blanks around it; `what` is told where there is none.
pub fn text(node: &Node, what: &str, faults: &Faults) -> Option<String> {
    let found = node.text().map(str::trim).filter(|t| !t.is_empty());
    if found.is_none() {
        faults.at(node, format!("expected {what}, found {}", node.kind()));
    }
    found.map(str::to_owned)
}

/// The items of a list; anything else is a finding.
pub fn items<'n>(node: &'n Node, what: &str, faults: &Faults) -> Option<&'n [Node]> {
    match &node.value {
        Value::List(items) => Some(items),
        _ => faults.refuse(node, format!("expected {what}, found {}", node.kind())),
    }
}

/// What one of some words means.
pub fn choice<T: Copy>(node: &Node, words: &[(&str, T)], faults: &Faults) -> Option<T> {
    let found = node.text().and_then(|t| words.iter().find(|(w, _)| *w == t.trim()));
    if found.is_none() {
        let known: Vec<String> = words.iter().map(|(w, _)| format!("`{w}`")).collect();
        faults.at(node, format!("expected {}, found {}", known.join(" or "), node.kind()));
    }
    found.map(|(_, meaning)| *meaning)
}

/// A whole number within limits.
pub fn whole(node: &Node, least: u32, most: u32, faults: &Faults) -> Option<u32> {
    let found = node.text().and_then(|t| t.trim().parse::<u32>().ok()).filter(|n| (least..=most).contains(n));
    if found.is_none() {
        faults.at(node, format!("expected a whole number from {least} to {most}, found {}", node.kind()));
    }
    found
}

/// All entries of a map whose names are free (ids, symbols), each name once.
pub fn named<'n>(node: &'n Node, what: &str, faults: &Faults) -> Vec<(&'n str, &'n Node, &'n Node)> {
    let Value::Map(entries) = &node.value else {
        faults.at(node, format!("expected {what}, found {}", node.kind()));
        return Vec::new();
    };
    let mut list: Vec<(&str, &Node, &Node)> = Vec::new();
    for (key, value) in entries {
        let Some(name) = key.text() else {
            faults.at(key, "a name must be a text");
            continue;
        };
        if list.iter().any(|(n, _, _)| *n == name) {
            faults.hint(key, format!("`{}` stands twice", shorten(name)), "remove one of them");
            continue;
        }
        list.push((name, key, value));
    }
    list
}

/// [`named`] of a map that holds something; `none` is told of one that does not.
pub fn some_named<'n>(
    node: &'n Node,
    what: &str,
    none: &str,
    faults: &Faults,
) -> Vec<(&'n str, &'n Node, &'n Node)> {
    if matches!(&node.value, Value::Map(entries) if entries.is_empty()) {
        faults.at(node, none);
    }
    named(node, what, faults)
}

/// The place of a name among those that are known; `what` it would be is told of one that is not.
pub fn known_as<'s>(
    name: &str,
    node: &Node,
    what: &str,
    known: impl Iterator<Item = &'s str> + Clone,
    faults: &Faults,
) -> Option<usize> {
    let found = known.clone().position(|one| one == name);
    if found.is_none() {
        faults.maybe(node, format!("`{}` is no {what}", shorten(name)), spell::did_you_mean(name, known));
    }
    found
}
