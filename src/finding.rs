//! What is wrong in somebody's file: where, which value, and what would be right.
use std::ops::{Deref, DerefMut};
use std::path::Path;
use std::{fmt, slice, vec};

/// Adds to a list what it does not hold yet.
pub fn push_new<T: PartialEq>(list: &mut Vec<T>, item: T) {
    if !list.contains(&item) {
        list.push(item);
    }
}

/// One fault in a file that a person wrote. Faults are collected, never thrown one by one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The file as the user named it, if there is one.
    pub file: Option<String>,
    /// Line and column, counted from 1.
    pub at: Option<(usize, usize)>,
    /// Path of the field, such as `problems.pulled-rolling.data.m`.
    pub field: String,
    /// What is wrong, with the value that was found.
    pub message: String,
    /// What would be right.
    pub hint: Option<String>,
}

impl Finding {
    /// That a text is not the JSON that it should be: `what` (a set), and what is wrong with it where.
    pub fn of_json(what: &str, error: &serde_json::Error) -> Self {
        let words = error.to_string();
        let words = words.split(" at line ").next().unwrap_or("cannot be read");
        Self::new("", format!("is no {what}: {words}")).at(error.line().max(1), error.column().max(1))
    }
    /// A finding about `field`, with no place in the file yet.
    pub fn new(field: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: None, at: None, field: field.into(), message: message.into(), hint: None }
    }
    /// A finding about a file or a folder as a whole.
    pub fn of_file(path: &Path, message: impl Into<String>) -> Self {
        Self::new("", message).in_file(path.display().to_string())
    }
    /// Adds what would be right.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
    /// Adds line and column, counted from 1.
    #[must_use]
    pub fn at(mut self, line: usize, column: usize) -> Self {
        self.at = Some((line, column));
        self
    }
    /// Adds the file's name.
    #[must_use]
    pub fn in_file(mut self, file: impl Into<String>) -> Self {
        self.file = Some(file.into());
        self
    }
}

impl fmt::Display for Finding {
    /// `bank.yaml:12:9: problems.p.data.m: 30 is above 20; write ...`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{file}:")?;
            if let Some((line, column)) = self.at {
                write!(f, "{line}:{column}:")?;
            }
            write!(f, " ")?;
        } else if let Some((line, column)) = self.at {
            write!(f, "line {line}, column {column}: ")?;
        }
        if !self.field.is_empty() {
            write!(f, "{}: ", self.field)?;
        }
        write!(f, "{}", self.message)?;
        if let Some(hint) = &self.hint {
            write!(f, "\n    hint: {hint}")?;
        }
        Ok(())
    }
}

/// All that is wrong in somebody's files, in the order in which it is told. `?` makes one of a single finding.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Findings(Vec<Finding>);

impl Findings {
    /// Adds one.
    pub fn push(&mut self, finding: Finding) {
        self.0.push(finding);
    }
    /// Adds the file's name to each.
    #[must_use]
    pub fn in_file(self, file: impl Into<String>) -> Self {
        let file = file.into();
        self.into_iter().map(|finding| finding.in_file(file.as_str())).collect()
    }
    /// Adds the file's name to each that has none.
    #[must_use]
    pub fn or_in_file(mut self, file: &str) -> Self {
        for finding in self.iter_mut().filter(|f| f.file.is_none()) {
            finding.file = Some(file.to_owned());
        }
        self
    }
    /// Adds what would be right to the last, if it does not say so itself.
    #[must_use]
    pub fn hint_last(mut self, hint: &str) -> Self {
        if let Some(last) = self.last_mut() {
            last.hint.get_or_insert_with(|| hint.to_owned());
        }
        self
    }
    /// `value`, if nothing was found. Errors: what was found.
    pub fn into_result<T>(self, value: T) -> Result<T, Self> {
        if self.is_empty() { Ok(value) } else { Err(self) }
    }
}

/// The first findings of many, and how many more there are.
#[derive(Debug, Default)]
pub struct FirstFindings {
    shown: Findings,
    more: usize,
}

impl FirstFindings {
    /// So many are told; where one thing is wrong in many places, more help nobody.
    pub const MOST: usize = 5;

    /// Adds one.
    pub fn push(&mut self, finding: Finding) {
        if self.shown.len() < Self::MOST { self.shown.push(finding) } else { self.more += 1 }
    }
    /// What is told, the number of the others last.
    pub fn told(mut self) -> Findings {
        if self.more > 0 {
            self.shown.push(Finding::new("", format!("and {} more differences", self.more)));
        }
        self.shown
    }
}

impl From<Finding> for Findings {
    fn from(finding: Finding) -> Self {
        Self(vec![finding])
    }
}

impl Extend<Finding> for Findings {
    fn extend<I: IntoIterator<Item = Finding>>(&mut self, findings: I) {
        self.0.extend(findings);
    }
}

impl FromIterator<Finding> for Findings {
    fn from_iter<I: IntoIterator<Item = Finding>>(findings: I) -> Self {
        Self(findings.into_iter().collect())
    }
}

impl IntoIterator for Findings {
    type Item = Finding;
    type IntoIter = vec::IntoIter<Finding>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'f> IntoIterator for &'f Findings {
    type Item = &'f Finding;
    type IntoIter = slice::Iter<'f, Finding>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl Deref for Findings {
    type Target = Vec<Finding>;
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl DerefMut for Findings {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

impl fmt::Display for Findings {
    /// One paragraph each.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|finding| writeln!(f, "{finding}"))
    }
}
