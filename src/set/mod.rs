//! A problem set as it is stored: who got which data, and all that is needed to make the key again.
//!
//! `set.json` says what was drawn; `bank.yaml` beside it is a copy of the bank; `key.csv` is for people and scripts.
//! [`dealer`] draws and solves for one student. Grading trusts no file alone: [`replay`] has everything dealt again and compares,
//! by one road where the key is sealed, by both for `verify`. A set that an earlier version
//! drew cannot be drawn again: its data are taken as stored, its key too, which must have the hash that set.json says.
use crate::finding::Finding;
use serde::de::DeserializeOwned;

pub(crate) mod coincide;
pub mod dealer;
pub mod given;
pub(crate) mod grading;
pub mod key_file;
pub mod replay;
pub mod store;

/// Reads a file of JSON that the program wrote: what it is called and the verb that writes it; `format` says the version of its layout,
/// and `reads` which one is read. Errors: what is wrong with it, with its place.
fn stored<T: DeserializeOwned>(
    text: &str,
    (what, verb): (&str, &str),
    format: impl Fn(&T) -> u32,
    reads: u32,
) -> Result<T, Finding> {
    let read: T = serde_json::from_str(text).map_err(|e| {
        let hint = format!("{what}.json is written by `slipstick {verb}` and not meant to be edited");
        Finding::of_json(what, &e).hint(hint)
    })?;
    match format(&read) {
        found if found == reads => Ok(read),
        found => Err(Finding::new("format", format!("is {found}; this program reads {reads}"))),
    }
}
