//! A page's talk with the program: a sheet is opened, then each request is a JSON text and so is its answer.
use crate::finding::Finding;
use crate::misconception::MethodWords;
use crate::page::check::{self, CheckedProblem};
use crate::page::echo;
use crate::page::sheet_file::SheetFile;
use crate::words::Words;
use serde_json::{Value, json};

/// A sheet that is open in a page, solved.
#[derive(Debug)]
pub struct Session {
    words: Words,
    /// What is said about wrong methods, by id: `did`, `see`, `hint`.
    methods: Value,
    problems: Vec<CheckedProblem>,
}

impl Session {
    /// Opens a sheet from the JSON text of `{"sheet": ..., "phrases": ..., "methods": ...}` and solves it.
    ///
    /// # Errors
    /// The texts cannot be read, or a problem of the sheet cannot be checked.
    pub fn open(text: &str) -> Result<Self, Finding> {
        let mut opening: Value = serde_json::from_str(text).map_err(|_| Finding::new("", "is no sheet"))?;
        let sheet = SheetFile::of(&opening["sheet"])?;
        let words = Words::handed(&opening["phrases"]).ok_or_else(|| Finding::new("phrases", "are none"))?;
        let problems = sheet.problems.iter().map(|problem| {
            let fault = |_| Finding::new("scene", format!("problem {} cannot be checked", problem.number));
            check::solve(problem, "sheet").map_err(fault)
        });
        let problems = problems.collect::<Result<_, _>>()?;
        Ok(Self { problems, words, methods: opening["methods"].take() })
    }

    /// The answer to a request, `{"read": [part, cell]}` or `{"check": [[part, cell], ...]}`; `null` to what is none.
    pub fn answer(&self, request: &str) -> String {
        let request: Value = serde_json::from_str(request).unwrap_or_default();
        let pair = |value: &Value, answer: fn(&Self, &str, &str) -> Option<Value>| {
            answer(self, value.get(0)?.as_str()?, value.get(1)?.as_str()?)
        };
        let answer = match request["check"].as_array() {
            Some(answers) => answers.iter().filter_map(|one| pair(one, Self::check)).collect(),
            None => pair(&request["read"], Self::read).unwrap_or_default(),
        };
        serde_json::to_string(&answer).unwrap_or_default()
    }

    /// Problem and index of a part by its name, `2.omega`.
    fn part(&self, name: &str) -> Option<(&CheckedProblem, usize)> {
        let (number, part) = name.split_once('.')?;
        let problem = self.problems.iter().find(|p| p.number.to_string() == number)?;
        Some((problem, problem.part(part)?))
    }

    /// How an answer is read.
    fn read(&self, part: &str, cell: &str) -> Option<Value> {
        let (problem, index) = self.part(part)?;
        let read = echo::echo(cell, &problem.key.parts[index], &self.words);
        let readable = read.is_ok();
        let (Ok(text) | Err(text)) = read;
        Some(json!({ "readable": readable, "text": text }))
    }

    /// What an answer is. All hints that lead on from it are handed over; the page tells them one by one.
    fn check(&self, part: &str, cell: &str) -> Option<Value> {
        let (problem, index) = self.part(part)?;
        let find = |id: &str| {
            let words = |name: &str| self.methods[id][name].as_str();
            Some(MethodWords { did: words("did")?, see: words("see")?, hint: words("hint")? })
        };
        let told = problem.check(index, cell, &self.words, &find)?;
        Some(json!({
            "part": part,
            "verdict": told.verdict.as_str(),
            "reason": told.reason,
            "read": told.read,
            "hints": told.hints,
        }))
    }
}
