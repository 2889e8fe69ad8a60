//! What is wrong in somebody's file: where, which value, and what would be right.
use std::fmt;

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
    /// A finding about `field`, with no place in the file yet.
    pub fn new(field: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: None, at: None, field: field.into(), message: message.into(), hint: None }
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
