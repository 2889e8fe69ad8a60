//! grading.json: what a grading was made from, so that every mark in it can be traced.
use crate::finding::Finding;
use crate::set::stored;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Version of the layout of grading.json.
pub const FORMAT: u32 = 1;

/// Answers that came in many files, joined: the lines that answers.csv tells are lines of this.
pub const JOINED: &str = "basis/submissions.csv";

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredGrading {
    /// Version of this layout.
    pub format: u32,
    /// Program and version that graded.
    pub program: String,
    /// Version of the drawing of the set.
    pub draw_version: u32,
    /// Was the set drawn again before it was graded? Not one of an earlier version of the drawing.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub replayed: bool,
    /// Name of the set.
    pub set: String,
    /// Seed of the set.
    pub seed: u64,
    /// Id of the bank.
    pub bank: String,
    /// SHA-256 of the bank that made the key, hex.
    pub bank_sha256: String,
    /// SHA-256 of key.csv, hex.
    pub key_sha256: String,
    /// SHA-256 of the course file, hex, if one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub course_sha256: Option<String>,
    /// Which attempt counts, if the command said so over bank and course.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub attempts: Option<String>,
    /// Language of the reasons.
    pub language: String,
    /// File of submissions, as it was named.
    pub submissions: String,
    /// How many files were joined to `basis/submissions.csv`, where it is a folder or an archive of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub submissions_files: Option<usize>,
    /// Its size in bytes.
    pub submissions_bytes: u64,
    /// They are the download of a quiz: the set in the basis has the variants that it asked.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub quiz: bool,
    /// Who the students are on Canvas, where the quiz was taken there: SIS id, login, Canvas's own number.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub canvas: BTreeMap<String, [String; 3]>,
    /// What the ids are on Moodle, where the quiz was taken there and they are neither ID numbers nor e-mail addresses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moodle: Option<String>,
    /// SHA-256 of the submissions, hex; left out of large gradings, as the next two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub submissions_sha256: Option<String>,
    /// SHA-256 of answers.csv, hex.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub answers_sha256: Option<String>,
    /// SHA-256 of gradebook.csv, hex.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gradebook_sha256: Option<String>,
    /// `field=header`, as the command gave them.
    #[serde(default)]
    pub columns: Vec<String>,
    /// Lines of answers.csv below the header.
    pub cells: u64,
    /// How many of each verdict.
    pub verdicts: Map<String, Value>,
    /// One record for each student, rather than for each answer.
    pub wide: bool,
    /// Parts of students whose attempts were ordered by row, because a time cannot be read.
    pub untimed: u64,
    /// Answers that count and have no time that can be read, where lateness bears on marks.
    pub undated: u64,
    /// Columns of the submissions that were not used.
    #[serde(default)]
    pub unused_columns: Vec<String>,
}

const fn yes() -> bool {
    true
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks with a reference")]
const fn is_yes(said: &bool) -> bool {
    *said
}

impl StoredGrading {
    /// Reads grading.json. Errors: what is wrong with it, with its place.
    pub fn parse(text: &str) -> Result<Self, Finding> {
        stored(text, ("grading", "grade"), |grading: &Self| grading.format, FORMAT)
    }

    /// The text of grading.json.
    pub fn text(&self) -> String {
        // Text keys and finite numbers only: this cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_else(|_| "{}".to_owned()) + "\n"
    }
}
