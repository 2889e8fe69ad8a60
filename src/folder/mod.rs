//! What lies on disk: a set, a grading, its reports; written whole or not at all, repaired after a kill, opened again and held
//! against its hashes. Prints nothing and knows no command line: what a command did comes back as a value, how far it is goes to a
//! [`Progress`].
use crate::finding::Finding;

pub mod banks;
pub mod class;
pub mod deal;
pub mod explain;
pub mod export;
pub mod files;
pub mod graded;
pub mod grading;
pub mod handed_in;
pub mod index;
pub mod matches;
pub mod names;
pub mod practice;
pub mod quiz;
pub mod regrading;
pub mod reports;
pub mod set;
pub mod simulate;
pub mod solutions;
pub mod staged;
pub mod tolerances;

/// Is told how far long work has come.
pub trait Progress: Sync {
    /// So many more units of work are done, of so many in all.
    fn advance(&self, what: &str, units: u64, of: u64);
}

/// Nobody watches.
impl Progress for () {
    fn advance(&self, _: &str, _: u64, _: u64) {}
}

/// The threads on which sheets are made, as many as cores where no number is given. Errors: they cannot be started.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Finding> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build()
        .map_err(|e| Finding::new("--threads", e.to_string()))
}

/// Name and version of this program, for what it makes.
pub fn program() -> String {
    format!("{} {}", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"))
}
