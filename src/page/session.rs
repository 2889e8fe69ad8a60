//! A page's talk with the program: a sheet is opened, then each request is a JSON text and so is its answer.
use crate::finding::Finding;
use crate::misconception::MethodWords;
use crate::page::check::{Checked, CheckedProblem, PosedProblem};
use crate::page::echo;
use crate::words::Words;
use serde::Serialize;
use serde_json::Value;

/// A sheet that is open in a page, solved.
#[derive(Debug)]
pub struct Session {
    words: Words,
    /// What is said about wrong methods, by id: `did`, `see`, `hint`.
    methods: Value,
    problems: Vec<CheckedProblem>,
}

/// An answer as the page gets it; nothing is `null`.
#[derive(Serialize)]
#[serde(untagged)]
enum Answer {
    Nothing,
    Read { readable: bool, text: String },
    Check { part: String, verdict: &'static str, reason: String, read: String, hints: Vec<String> },
    All(Vec<Self>),
}

impl Session {
    /// Opens a sheet from the JSON text of `{"problems": [...], "phrases": ..., "methods": ...}`, the problems as they were packed, and
    /// solves it. Errors: the texts cannot be read, or a problem cannot be checked.
    pub fn open(text: &str) -> Result<Self, Finding> {
        let mut opening: Value = serde_json::from_str(text).map_err(|_| Finding::new("", "is no sheet"))?;
        let words = Words::handed(&opening["phrases"]).ok_or_else(|| Finding::new("phrases", "are none"))?;
        let problems = opening["problems"].as_array().into_iter().flatten().map(|packed| {
            let posed = packed.as_str().and_then(PosedProblem::unpacked);
            let posed = posed.ok_or_else(|| Finding::new("problems", "hold one that cannot be read"))?;
            let number = posed.number;
            let fault = |_| Finding::new("problems", format!("problem {number} cannot be checked"));
            posed.solved().map_err(fault)
        });
        let problems = problems.collect::<Result<_, _>>()?;
        Ok(Self { problems, words, methods: opening["methods"].take() })
    }

    /// The answer to a request, `{"read": [part, cell]}` or `{"check": [[part, cell], ...]}`; `null` to what is none.
    pub fn answer(&self, request: &str) -> String {
        let request: Value = serde_json::from_str(request).unwrap_or_default();
        let told = |value: &Value, tell: fn(&Self, &str, &str) -> Option<Answer>| {
            tell(self, value.get(0)?.as_str()?, value.get(1)?.as_str()?)
        };
        let answer = match request["check"].as_array() {
            Some(answers) => Answer::All(answers.iter().filter_map(|one| told(one, Self::check)).collect()),
            None => told(&request["read"], Self::read).unwrap_or(Answer::Nothing),
        };
        serde_json::to_string(&answer).unwrap_or_default()
    }

    /// Problem and index of a part by its name, `2.omega`.
    fn part(&self, name: &str) -> Option<(&CheckedProblem, usize)> {
        let (number, part) = name.split_once('.')?;
        let problem = self.problems.iter().find(|p| p.posed.number.to_string() == number)?;
        Some((problem, problem.part(part)?))
    }

    /// How an answer is read.
    fn read(&self, part: &str, cell: &str) -> Option<Answer> {
        let (problem, index) = self.part(part)?;
        let read = echo::echo(cell, &problem.key.parts[index], &self.words);
        let readable = read.is_ok();
        let (Ok(text) | Err(text)) = read;
        Some(Answer::Read { readable, text })
    }

    /// What an answer is. All hints that lead on from it are handed over; the page tells them one by one.
    fn check(&self, part: &str, cell: &str) -> Option<Answer> {
        let (problem, index) = self.part(part)?;
        let find = |id: &str| {
            let words = |name: &str| self.methods[id][name].as_str();
            Some(MethodWords { did: words("did")?, see: words("see")?, hint: words("hint")? })
        };
        let Checked { verdict, reason, read, hints } = problem.check(index, cell, &self.words, &find)?;
        Some(Answer::Check { part: part.to_owned(), verdict: verdict.as_str(), reason, read, hints })
    }
}
