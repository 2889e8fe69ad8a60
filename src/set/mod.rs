//! A problem set as it is stored: who got which data, and all that is needed to make the key again.
//!
//! `set.json` says what was drawn; `bank.yaml` beside it is a copy of the bank; `key.csv` is for people and scripts.
//! [`dealer`] draws and solves for one student. Grading trusts no file alone: [`replay`] has everything dealt again and compares. A set that an earlier version
//! drew cannot be drawn again: its data are taken as stored, its key too, which must have the hash that set.json says.
pub(crate) mod coincide;
pub mod dealer;
pub mod given;
pub(crate) mod grading;
pub mod key_file;
pub mod replay;
pub mod store;
