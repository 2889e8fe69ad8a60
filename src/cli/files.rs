//! Reading; writing whole or not at all.
use crate::finding::Finding;
use crate::finding::Findings;
use indicatif::ProgressBar;
use indicatif::ProgressStyle;
use std::fs;
use std::io;
use std::path::Path;
use std::path::PathBuf;
use std::time::Duration;
use std::time::SystemTime;
use tempfile::TempDir;

/// A fault of the machine as a finding about a path.
pub fn trouble(path: &Path, what: &str, error: &io::Error) -> Finding {
    Finding::new("", format!("{what}: {}", in_words(error))).in_file(path.display().to_string())
}

fn in_words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder, and a file is wanted".to_owned(),
        io::ErrorKind::NotADirectory => "a part of this path is a file, and a folder is wanted".to_owned(),
        io::ErrorKind::AlreadyExists | io::ErrorKind::DirectoryNotEmpty => {
            "something else of this name is in the way".to_owned()
        }
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::QuotaExceeded => "the quota of the disk is used up".to_owned(),
        io::ErrorKind::FileTooLarge => "files may not grow that large here".to_owned(),
        _ => error.to_string(),
    }
}

/// Size and last change of a file, to see that it stays as it is.
pub fn stamp(path: &Path) -> Option<(u64, SystemTime)> {
    let about = fs::metadata(path).ok()?;
    Some((about.len(), about.modified().ok()?))
}

/// Bytes of a file.
///
/// # Errors
/// A finding that names the file.
pub fn read(path: &Path) -> Result<Vec<u8>, Finding> {
    fs::read(path).map_err(|e| trouble(path, "cannot be read", &e))
}

/// Text of a UTF-8 file; a byte order mark is dropped.
///
/// # Errors
/// A finding that names the file, and the place of the first byte that is no UTF-8.
pub fn read_text(path: &Path) -> Result<String, Finding> {
    let bytes = read(path)?;
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').map_or(text.clone(), str::to_owned)),
        Err(error) => {
            let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = good.iter().filter(|b| **b == b'\n').count() + 1;
            let start = good.iter().rposition(|b| *b == b'\n').map_or(0, |p| p + 1);
            let column = String::from_utf8_lossy(&good[start..]).chars().count() + 1;
            Err(Finding::new("", "is no UTF-8 text from here on")
                .at(line, column)
                .in_file(path.display().to_string())
                .hint("save the file as UTF-8"))
        }
    }
}

fn parent(path: &Path) -> PathBuf {
    match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Writes several files, all or none: each is made beside its place first, then all are moved there. Folders above are made.
///
/// # Errors
/// A finding that names the file.
pub fn put_all(files: &[(PathBuf, String)]) -> Result<(), Finding> {
    use std::io::Write as _;
    let mut made = Vec::with_capacity(files.len());
    for (path, text) in files {
        let fault = |e: &io::Error| trouble(path, "cannot be written", e);
        let above = parent(path);
        fs::create_dir_all(&above).map_err(|e| fault(&e))?;
        let mut file =
            tempfile::Builder::new().prefix(UNFINISHED).tempfile_in(&above).map_err(|e| fault(&e))?;
        file.write_all(text.as_bytes()).map_err(|e| fault(&e))?;
        readable(file.path()).map_err(|e| fault(&e))?;
        made.push((file, path));
    }
    for (file, path) in made {
        file.persist(path).map_err(|e| trouble(path, "cannot be put in its place", &e.error))?;
    }
    Ok(())
}

/// A temporary file is its owner's alone; what is put in its place is as other files are.
#[cfg(unix)]
fn readable(path: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(path, fs::Permissions::from_mode(0o644))
}
#[cfg(not(unix))]
fn readable(_: &Path) -> io::Result<()> {
    Ok(())
}

/// Folders of runs that are at work, or were killed.
const UNFINISHED: &str = ".slipstick-unfinished-";
/// The file in such a folder that says whose it is; without it we leave a folder alone.
const OWNER: &str = "slipstick-owner";
/// The folder being filled, and the one that it replaces.
const NEW: &str = "new";
const OLD: &str = "old";

/// A folder that is being filled beside its place, on the same file system.
///
/// `.slipstick-unfinished-PID-XXXX` holds `slipstick-owner` (process, machine since its start, name of the place), `new`
/// and, for the moment between two renames, `old`. A killed run leaves it; the next run beside it [`sweep`]s it away.
pub struct Staged {
    folder: TempDir,
    new: PathBuf,
    place: PathBuf,
}

impl Staged {
    /// Begins a folder; folders above it are made, and what killed runs left there goes away.
    ///
    /// # Errors
    /// A finding that names the folder.
    pub fn new(place: &Path) -> Result<Self, Finding> {
        let fault = |e: &io::Error| trouble(place, "cannot be made", e);
        let above = parent(place);
        fs::create_dir_all(&above).map_err(|e| fault(&e))?;
        sweep(&above);
        let prefix = format!("{UNFINISHED}{}-", std::process::id());
        let folder = tempfile::Builder::new().prefix(&prefix).tempdir_in(&above).map_err(|e| fault(&e))?;
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let owner = format!("{}\n{}\n{name}\n", std::process::id(), machine());
        fs::write(folder.path().join(OWNER), owner).map_err(|e| fault(&e))?;
        let new = folder.path().join(NEW);
        fs::create_dir(&new).map_err(|e| fault(&e))?;
        Ok(Self { folder, new, place: place.to_owned() })
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
            if !told.contains(&finding) {
                told.push(finding);
            }
        }
        told
    }
    /// Moves one file or folder to the same name in the place, which is there already.
    ///
    /// # Errors
    /// A finding that names it.
    pub fn place_one(&self, name: &Path) -> Result<(), Finding> {
        let to = self.place.join(name);
        fs::rename(self.new.join(name), &to).map_err(|e| trouble(&to, "cannot be put in its place", &e))
    }
    /// Puts it in its place; what stood there goes away only then.
    ///
    /// # Errors
    /// A finding that names the folder.
    pub fn finish(self) -> Result<(), Finding> {
        let Self { folder, new, place } = self;
        let fault = |e: &io::Error| trouble(&place, "cannot be put in its place", e);
        let old = folder.path().join(OLD);
        let replaces = place.exists();
        if replaces {
            fs::rename(&place, &old).map_err(|e| fault(&e))?;
        }
        if let Err(error) = fs::rename(&new, &place) {
            if replaces && fs::rename(&old, &place).is_err() {
                // Better a hidden folder than a set that is gone.
                let _ = folder.keep();
            }
            return Err(fault(&error));
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
            // What cannot be removed now stays for the next run.
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

/// [`sweep`]s where this folder stands.
pub fn sweep_beside(place: &Path) {
    sweep(&parent(place));
}

/// A set or a grading goes into a folder of its own: not the one that people stand in, nor one above it.
///
/// # Errors
/// A finding that says what to write instead.
pub fn has_a_name(place: &Path, example: &str) -> Result<(), Finding> {
    let stood_in = || {
        let here = std::env::current_dir().and_then(fs::canonicalize).ok()?;
        Some(here.starts_with(fs::canonicalize(place).ok()?))
    };
    if place.file_name().is_some() && !stood_in().unwrap_or(false) {
        return Ok(());
    }
    let fault = Finding::new("", "is the folder that you stand in, or above it");
    Err(fault
        .in_file(place.display().to_string())
        .hint(format!("write into a new folder, such as {example}")))
}

/// Nothing goes among what the students of a set get: into a folder `students` beside a `set.json`, or below one.
///
/// # Errors
/// A finding about the place.
pub fn not_among_students(place: &Path) -> Result<(), Finding> {
    // The folder may not be there yet: those above it are asked, and what is missing is put behind them.
    let here = Path::new(".");
    let known = place.ancestors().find_map(|above| {
        let there = fs::canonicalize(if above.as_os_str().is_empty() { here } else { above }).ok()?;
        Some(there.join(place.strip_prefix(above).unwrap_or(here)))
    });
    let known = known.unwrap_or_else(|| place.to_owned());
    let of_a_set = |folder: &Path| {
        folder.file_name().is_some_and(|name| name.eq_ignore_ascii_case("students"))
            && folder.with_file_name("set.json").is_file()
    };
    if !known.ancestors().any(of_a_set) {
        return Ok(());
    }
    let fault = Finding::new("", "is within the folder of what students get");
    Err(fault.in_file(place.display().to_string()).hint("give another --out"))
}

/// Names in a folder, sorted; none if the folder is not there.
pub fn names_in(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut names: Vec<String> =
        entries.flatten().map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort_unstable();
    names
}

/// What a folder holds that is not ours, as paths below it, sorted; `ours` is asked about `name`, `folder/` and `folder/name`. What
/// stands in a folder that is not ours is not listed.
pub fn foreign(folder: &Path, ours: &dyn Fn(&str) -> bool) -> Vec<String> {
    fn walk(folder: &Path, above: &str, ours: &dyn Fn(&str) -> bool, found: &mut Vec<String>) {
        for name in names_in(folder).into_iter().filter(|n| !n.starts_with(UNFINISHED)) {
            let path = folder.join(&name);
            let end = if path.is_dir() { "/" } else { "" };
            let below = format!("{above}{name}{end}");
            if !ours(&below) {
                found.push(below);
            } else if path.is_dir() {
                walk(&path, &below, ours, found);
            }
        }
    }
    let mut found = Vec::new();
    walk(folder, "", ours, &mut found);
    found
}

/// The finding that names what is not ours; `verb` did not make it.
pub fn not_ours(place: &Path, foreign: &[String], verb: &str) -> Finding {
    const NAMED: usize = 5;
    let mut named = foreign.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
    if foreign.len() > NAMED {
        named.push_str(&format!(" and {} more", foreign.len() - NAMED));
    }
    Finding::new("", format!("holds what `slipstick {verb}` did not make: {named}"))
        .in_file(place.display().to_string())
        .hint("nothing was changed: move it elsewhere, or give another --out")
}

/// A bar that shows itself only where a person watches and the work takes long.
pub fn progress(watched: bool, length: u64, what: &str) -> ProgressBar {
    if !watched || length < 200 {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(length);
    if let Ok(style) = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len} {eta}") {
        bar.set_style(style);
    }
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
