//! `slipstick what-if`: how many verdicts of a grading would change with other tolerances.
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::tolerances;
use std::path::Path;

pub fn run(graded: &Path, typed: &[String], io: &mut Io) -> Result<Exit, Findings> {
    io.piece(&tolerances::what_if(graded, &shares(typed)?)?);
    Ok(Exit::Fine)
}

/// Relative tolerances, as shares, from `0.5`, `2%`, `2 %`: per cent.
fn shares(typed: &[String]) -> Result<Vec<f64>, Findings> {
    let (mut found, mut faults) = (Vec::new(), Findings::default());
    for text in typed {
        let number = text.trim().trim_end_matches('%').trim().replace(',', ".");
        match number.parse::<f64>() {
            Ok(value) if value > 0.0 && value <= 100.0 => found.push(value / 100.0),
            _ => faults.push(
                Finding::new("--tolerance", format!("`{text}` is no tolerance"))
                    .hint("per cent, above 0 and at most 100, such as --tolerance 0.5,1,2%"),
            ),
        }
    }
    found.sort_by(f64::total_cmp);
    found.dedup();
    faults.into_result(found)
}
