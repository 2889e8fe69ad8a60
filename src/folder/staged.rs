//! A folder that is made beside its place and put there whole; what killed runs left is repaired.
use crate::finding::{Finding, Findings, push_new};
use crate::folder::files::{UNFINISHED, names_in, parent, trouble};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tempfile::TempDir;

/// The file in such a folder that says whose it is; without it we leave a folder alone.
const OWNER: &str = "slipstick-owner";
/// The folder being filled, and the one that it replaces.
const NEW: &str = "new";
const OLD: &str = "old";

/// A folder that is being filled beside its place, on the same file system.
///
/// `.slipstick-unfinished-PID-XXXX` holds `slipstick-owner` (process, machine since its start, name of the place), `new`
/// and, for the moment between two renames, `old`. A killed run leaves it; the next run beside it removes it.
pub struct Staged {
    folder: TempDir,
    new: PathBuf,
    place: PathBuf,
    /// Something stood in the place when it was begun: it may be replaced. What another run has put there since may not.
    replaces: bool,
}

impl Staged {
    /// Begins a folder; folders above it are made, and what killed runs left there goes away. Errors: a finding that names the
    /// folder.
    pub fn new(place: &Path) -> Result<Self, Finding> {
        let fault = trouble(place, "cannot be made");
        let above = parent(place);
        fs::create_dir_all(&above).map_err(fault)?;
        sweep(&above);
        let prefix = format!("{UNFINISHED}{}-", std::process::id());
        let folder = tempfile::Builder::new().prefix(&prefix).tempdir_in(&above).map_err(fault)?;
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let owner = format!("{}\n{}\n{name}\n", std::process::id(), machine());
        fs::write(folder.path().join(OWNER), owner).map_err(fault)?;
        let new = folder.path().join(NEW);
        fs::create_dir(&new).map_err(fault)?;
        Ok(Self { folder, new, place: place.to_owned(), replaces: place.exists() })
    }
    /// Where to write for now.
    pub fn path(&self) -> &Path {
        &self.new
    }
    /// Findings about what is written here, told of the place that people know; equal ones once.
    pub fn named(&self, findings: Findings) -> Findings {
        let (here, place) = (self.new.display().to_string(), self.place.display().to_string());
        let mut told = Findings::default();
        for mut finding in findings {
            finding.file = finding.file.map(|f| f.replace(&here, &place));
            finding.message = finding.message.replace(&here, &place);
            push_new(&mut told, finding);
        }
        told
    }
    /// Writes a file of it, and the folders above that file. Errors: a finding that names the file in its place.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), Finding> {
        let path = self.new.join(name);
        let written = fs::create_dir_all(parent(&path)).and_then(|()| fs::write(path, bytes));
        written.map_err(trouble(&self.place.join(name), "cannot be written"))
    }
    /// Moves one file or folder to the same name in the place, which is there already. Errors: a finding that names it.
    pub fn place_one(&self, name: &Path) -> Result<(), Finding> {
        let to = self.place.join(name);
        fs::rename(self.new.join(name), &to).map_err(trouble(&to, "cannot be put in its place"))
    }
    /// Puts it in its place; what stood there goes away only then. Errors: a finding that names the folder.
    pub fn finish(self) -> Result<(), Finding> {
        let Self { folder, new, place, replaces } = self;
        let fault = trouble(&place, "cannot be put in its place");
        let old = folder.path().join(OLD);
        if replaces && place.exists() {
            fs::rename(&place, &old).map_err(fault)?;
        }
        if let Err(error) = fs::rename(&new, &place) {
            if replaces && fs::rename(&old, &place).is_err() {
                // It could not be put back: the set is kept in the hidden folder.
                let _ = folder.keep();
            }
            return Err(fault(error));
        }
        Ok(())
    }
}

/// Takes away what killed runs of ours left in a folder. A run that was killed between the two renames of
/// [`Staged::finish`] has the old folder inside: it goes back to its place.
fn sweep(folder: &Path) {
    for name in names_in(folder).iter().filter(|n| n.starts_with(UNFINISHED)) {
        let left = folder.join(name);
        let owner = fs::read_to_string(left.join(OWNER)).unwrap_or_default();
        if owner.lines().count() < 3 {
            // Killed before it had written whose it is: only its name tells, and nothing else is in it.
            let pid = name.strip_prefix(UNFINISHED).and_then(|n| n.split('-').next()?.parse::<u32>().ok());
            let alone = names_in(&left).iter().all(|n| n == OWNER);
            if alone && pid.is_some_and(|pid| Path::new("/proc/self").exists() && has_ended(pid)) {
                let _ = fs::remove_dir_all(&left);
            }
            continue;
        }
        let mut lines = owner.lines();
        let (pid, run, place) = (lines.next(), lines.next(), lines.next());
        let (Some(Ok(pid)), Some(run), Some(place)) = (pid.map(str::parse::<u32>), run, place) else {
            continue;
        };
        if place.contains(['/', '\\']) || !is_gone(&left.join(OWNER), pid, run) {
            continue;
        }
        let (old, place) = (left.join(OLD), folder.join(place));
        if old.exists() && (place.exists() || fs::rename(&old, &place).is_ok()) || !old.exists() {
            // If it cannot be removed now, the next run removes it.
            let _ = fs::remove_dir_all(&left);
        }
    }
}

/// Has a process of this machine ended?
fn has_ended(pid: u32) -> bool {
    let Ok(stat) = fs::read_to_string(format!("/proc/{pid}/stat")) else { return true };
    // Behind the name in brackets stands the state: a zombie has ended, nobody has asked how.
    stat.rsplit(')').next().is_some_and(|s| s.trim_start().starts_with(['Z', 'X']))
}

/// Is the process gone that wrote this file? Known only on this machine since its start, else after a day.
fn is_gone(owner: &Path, pid: u32, run: &str) -> bool {
    if !run.is_empty() && run == machine() {
        return has_ended(pid);
    }
    const DAY: Duration = Duration::from_secs(24 * 60 * 60);
    let modified = fs::metadata(owner).and_then(|m| m.modified());
    modified.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > DAY))
}

/// Names this machine since its start, where the system says so (Linux); else empty.
fn machine() -> String {
    let id = fs::read_to_string("/proc/sys/kernel/random/boot_id").unwrap_or_default();
    id.trim().to_owned()
}

/// Removes what killed runs left where this folder stands.
pub fn sweep_beside(place: &Path) {
    sweep(&parent(place));
}
