//! `slipstick matches`: whose answers the wrong answers of a grading are. For instructors only.
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::names::MATCHES;
use crate::folder::{files, graded, matches};
use crate::num::shown;
use crate::report::matches::ClassMatches;
use crate::sheet::terminal;
use crate::words::Words;
use std::path::Path;

/// Pairs shown on the terminal; the others stand in the file.
const SHOWN: usize = 20;

pub fn run(graded: &Path, io: &mut Io) -> Result<Exit, Findings> {
    let found = matches::find(&graded::open(graded, None)?)?;
    io.piece(&told(&found));
    let path = graded.join(MATCHES);
    let text = String::from_utf8_lossy(&found.csv()).into_owned();
    files::put_all(&[(path.clone(), text)])?;
    io.line(&format!("  all of them, for your eyes only: {}", path.display()));
    Ok(Exit::Fine)
}

/// Pairs for the terminal.
fn told(found: &ClassMatches) -> String {
    let mut text = found.summary(&Words::english());
    text.push('\n');
    if found.pairs.is_empty() {
        return text;
    }
    let head = "look | student | key of | parts | answers | chance | by luck | other explanation";
    let mut rows = vec![terminal::head(head)];
    for pair in found.pairs.iter().take(SHOWN) {
        rows.push(vec![
            if pair.flagged { "yes" } else { "" }.to_owned(),
            pair.student[0].clone(),
            pair.classmate[0].clone(),
            pair.parts.join(" "),
            pair.answers
                .iter()
                .map(|a| a.chars().take(20).collect::<String>())
                .collect::<Vec<_>>()
                .join(" | "),
            shown::figures(pair.chance, 1),
            shown::figures(pair.expected, 1),
            pair.explained.clone(),
        ]);
    }
    text.push_str(&terminal::table(&rows, &[0, 1, 2, 3, 4, 7]));
    if found.pairs.len() > SHOWN {
        text.push_str(&format!("  and {} more\n", found.pairs.len() - SHOWN));
    }
    text.push_str(
        "  A match accuses nobody: sheets get swapped, friends compute with one set of data, a form is filled in for another.\n",
    );
    text
}
