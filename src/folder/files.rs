//! Reading files, and writing some of them whole or not at all.
use crate::finding::{Finding, Findings};
use crate::folder::names;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{fs, io};

/// Makes of a fault of the machine a finding about a path.
pub fn trouble<'t>(path: &'t Path, what: &'t str) -> impl Fn(io::Error) -> Finding + Copy + use<'t> {
    move |error| Finding::of_file(path, format!("{what}: {}", in_words(&error)))
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

/// Bytes of a file. Errors: a finding that names the file.
pub fn read(path: &Path) -> Result<Vec<u8>, Finding> {
    fs::read(path).map_err(trouble(path, "cannot be read"))
}

/// Text of a UTF-8 file; a byte order mark is dropped. Errors: a finding that names the file, and the place of the first byte
/// that is no UTF-8.
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

/// Of each record of a CSV file what stands under these names, nothing where there is no such column. Errors: it cannot be read.
pub fn columns<const N: usize>(path: &Path, names: [&str; N]) -> Result<Vec<[String; N]>, Finding> {
    let bytes = read(path)?;
    let fault = |e: csv::Error| Finding::of_file(path, e.to_string());
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(bytes.as_slice());
    let header = reader.headers().map_err(fault)?.clone();
    let at = names.map(|name| header.iter().position(|field| field == name));
    let fields = |record: csv::StringRecord| {
        at.map(|at| at.and_then(|i| record.get(i)).unwrap_or_default().to_owned())
    };
    reader.records().map(|record| record.map(fields).map_err(fault)).collect()
}

/// The folder above a path.
pub fn parent(path: &Path) -> PathBuf {
    match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Writes several files, all or none: each is made beside its place first, then all are moved there. Folders above are made.
/// Errors: a finding that names the file.
pub fn put_all<T: AsRef<[u8]>>(files: &[(PathBuf, T)]) -> Result<(), Finding> {
    use std::io::Write as _;
    let mut made = Vec::with_capacity(files.len());
    for (path, text) in files {
        let fault = trouble(path, "cannot be written");
        let above = parent(path);
        fs::create_dir_all(&above).map_err(fault)?;
        let mut file = tempfile::Builder::new().prefix(UNFINISHED).tempfile_in(&above).map_err(fault)?;
        file.write_all(text.as_ref()).and_then(|()| readable(file.path())).map_err(fault)?;
        made.push((file, path));
    }
    for (file, path) in made {
        file.persist(path).map_err(|e| trouble(path, "cannot be put in its place")(e.error))?;
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
pub const UNFINISHED: &str = ".slipstick-unfinished-";

/// A set or a grading goes into a folder of its own: not the one that people stand in, nor one above it. Errors: a finding that
/// says what to write instead.
pub fn has_a_name(place: &Path, example: &str) -> Result<(), Finding> {
    let stood_in = || {
        let here = std::env::current_dir().and_then(fs::canonicalize).ok()?;
        Some(here.starts_with(fs::canonicalize(place).ok()?))
    };
    if place.file_name().is_some() && !stood_in().unwrap_or(false) {
        return Ok(());
    }
    let fault = Finding::of_file(place, "is the folder that you stand in, or above it");
    Err(fault.hint(format!("write into a new folder, such as {example}")))
}

/// Nothing goes among what the students of a set get: into a folder `students` beside a `set.json`, or below one. Errors: a
/// finding about the place.
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
    let fault = Finding::of_file(place, "is within the folder of what students get");
    Err(fault.hint("give another --out"))
}

/// May a file be written here that students of a set do not get? Yes if nothing is there, or with `force` a file. Errors: what is
/// in the way.
pub fn may_write_file(path: &Path, force: bool) -> Result<(), Finding> {
    let finding = |what: &str| Finding::of_file(path, what);
    not_among_students(path)?;
    if path.is_dir() {
        return Err(finding("is a folder, and a file is wanted").hint("give the file a name"));
    }
    if path.exists() && !force {
        return Err(finding("is there already").hint("--force replaces it"));
    }
    Ok(())
}

/// A folder that a command is to make.
pub struct NewFolder<'n> {
    /// The verb of the command.
    pub verb: &'n str,
    /// What it makes, as in `holds no set`.
    pub makes: &'n str,
    /// A name that may be given.
    pub example: &'n str,
    /// What to do where something is there that may not be replaced.
    pub taken: &'n str,
}

/// May a folder be made here that students of a set do not get? Yes if nothing or an empty folder is there, and with `force` if all
/// that is there was made by the same command: `foreign` lists what was not, and is `None` where nothing was. Errors: what is in
/// the way.
pub fn may_write_folder(
    out: &Path,
    force: bool,
    new: &NewFolder,
    foreign: impl FnOnce() -> Result<Option<Vec<String>>, Findings>,
) -> Result<(), Findings> {
    let finding = |what: &str| Finding::of_file(out, what);
    has_a_name(out, new.example)?;
    not_among_students(out)?;
    if !out.exists() || (out.is_dir() && names_in(out).is_empty()) {
        return Ok(());
    }
    if !out.is_dir() {
        return Err(finding("is a file; a folder is made").into());
    }
    let of_set = out.join(names::SET).exists();
    if of_set && new.verb != "generate" {
        return Err(finding("is the folder of a set").hint("give another --out").into());
    }
    if !force {
        return Err(finding("is there already").hint(new.taken).into());
    }
    match foreign()? {
        None => {
            let hint = format!("--force replaces only what {} made", new.verb);
            Err(finding(&format!("holds no {}", new.makes)).hint(hint).into())
        }
        Some(foreign) if foreign.is_empty() => Ok(()),
        Some(foreign) => Err(not_ours(out, &foreign, new.verb).into()),
    }
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
    Finding::of_file(place, format!("holds what `slipstick {verb}` did not make: {named}"))
        .hint("nothing was changed: move it elsewhere, or give another --out")
}
