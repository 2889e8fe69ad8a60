//! A page's talk with the program: a sheet is opened, then each request is a JSON text and so is its answer.
use crate::answer::read::UnitCache;
use crate::finding::Finding;
use crate::grade::feedback::Feedback;
use crate::page::check::{self, CheckedProblem};
use crate::page::echo;
use crate::page::sheet_file::SheetFile;
use crate::words::{Phrases, Words};
use serde::{Deserialize, Serialize};

/// A sheet that is open in a page, solved.
#[derive(Debug)]
pub struct Session {
    words: Words,
    problems: Vec<CheckedProblem>,
}

/// What a page hands in.
#[derive(Debug, Deserialize)]
struct Opening {
    sheet: SheetFile,
    phrases: Phrases,
}

/// What a page asks.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Request {
    /// How an answer is read: part and cell.
    Read(String, String),
    /// What answers are: parts and cells.
    Check(Vec<(String, String)>),
}

/// What it gets for one answer.
#[derive(Debug, Serialize)]
struct Told {
    part: String,
    verdict: &'static str,
    reason: String,
    read: String,
}

impl Session {
    /// Opens a sheet from the JSON text of `{"sheet": ..., "phrases": ...}` and solves it.
    ///
    /// # Errors
    /// The texts cannot be read, or a problem of the sheet cannot be checked.
    pub fn open(text: &str) -> Result<Self, Finding> {
        let opening: Opening =
            serde_json::from_str(text).map_err(|e| Finding::new("", format!("is no sheet: {e}")))?;
        let words = Words::given(opening.phrases);
        let problems = opening.sheet.problems.iter().map(|problem| {
            let fault = |_| Finding::new("scene", format!("problem {} cannot be checked", problem.number));
            check::solve(problem, "sheet").map_err(fault)
        });
        Ok(Self { problems: problems.collect::<Result<_, _>>()?, words })
    }

    /// The answer to a request; `null` to what is none.
    pub fn answer(&self, request: &str) -> String {
        let answer = match serde_json::from_str(request) {
            Ok(Request::Read(part, cell)) => serde_json::to_string(&self.read(&part, &cell)),
            Ok(Request::Check(answers)) => {
                let told: Vec<Told> =
                    answers.iter().filter_map(|(part, cell)| self.check(part, cell)).collect();
                serde_json::to_string(&told)
            }
            Err(_) => return "null".to_owned(),
        };
        // Texts only: this cannot fail.
        answer.unwrap_or_else(|_| "null".to_owned())
    }

    /// Problem and index of a part by its name, `2.omega`.
    fn part(&self, name: &str) -> Option<(&CheckedProblem, usize)> {
        let (number, part) = name.split_once('.')?;
        let problem = self.problems.iter().find(|p| p.number.to_string() == number)?;
        Some((problem, problem.part(part)?))
    }

    fn read(&self, part: &str, cell: &str) -> Option<String> {
        let (problem, index) = self.part(part)?;
        let say = Feedback::new(&self.words);
        Some(echo::echo(cell, &problem.key.parts[index], &mut UnitCache::default(), &say))
    }

    fn check(&self, part: &str, cell: &str) -> Option<Told> {
        let (problem, index) = self.part(part)?;
        let say = Feedback::new(&self.words);
        let told = check::check(&problem.key.parts[index], cell, &mut UnitCache::default(), &say);
        Some(Told {
            part: part.to_owned(),
            verdict: told.verdict.as_str(),
            reason: told.reason,
            read: told.read,
        })
    }
}
