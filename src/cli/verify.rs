//! `slipstick verify`: a set is drawn and solved again, and every key held against its enclosure.
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::set::Replayed;
use crate::folder::{files, names, set};
use crate::key::SheetKey;
use crate::report::proved;
use crate::set::key_file;
use crate::sheet::terminal;
use std::path::Path;

pub fn run(folder: &Path, io: &mut Io) -> Result<Exit, Findings> {
    let Replayed { set, keys, not_drawn, .. } = set::replayed(folder)?;
    if not_drawn.is_none() {
        // Of a set that is not drawn again the key was held against its hash already.
        strangers(folder, &keys)?;
    }
    let sheets = terminal::count(keys.len(), "sheet");
    let variants = terminal::count(keys.iter().map(|k| k.problems.len()).sum::<usize>(), "variant");
    io.line(&match not_drawn {
        None => format!(
            "{sheets}, {variants} drawn and solved again from seed {}: bank copy, drawn data and key.csv are what they were",
            set.seed
        ),
        Some(told) => format!("{sheets}, {variants}, solved again from the stored data. {told}"),
    });
    let questions = proved::questions(&keys);
    io.piece(&proved::table(&questions));
    io.line(&proved::verdict(&questions));
    let faults = proved::faults(&questions);
    faults.into_result(Exit::Fine)
}

/// A key with rows beside those of the set: grading leaves them alone, a proof does not.
fn strangers(folder: &Path, keys: &[SheetKey]) -> Result<(), Findings> {
    let path = folder.join(names::KEY);
    let stored = files::read(&path)?;
    if key_file::is_of(&stored, keys) {
        return Ok(());
    }
    let what = "has rows of students who are not in the set, or is written otherwise";
    let fault = Finding::of_file(&path, what);
    Err(fault
        .hint("after an `--add` that was cut off run `generate --add` again; else put the original back")
        .into())
}
