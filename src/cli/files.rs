//! Reading; writing whole or not at all.
use crate::finding::Finding;
use indicatif::ProgressBar;
use indicatif::ProgressStyle;
use std::fs;
use std::io;
use std::io::Write as _;
use std::path::Path;
use std::path::PathBuf;
use std::time::Duration;
use tempfile::NamedTempFile;
use tempfile::TempDir;

/// A fault of the machine as a finding about a path.
pub fn trouble(path: &Path, what: &str, error: &io::Error) -> Finding {
    Finding::new("", format!("{what}: {}", in_words(error))).in_file(path.display().to_string())
}

fn in_words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => error.to_string(),
    }
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

/// Writes a file beside its place and then renames it there: a killed run leaves the old one or the new one.
///
/// # Errors
/// A finding that names the file.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Finding> {
    let mut pending = Pending::new(path)?;
    pending.file().write_all(bytes).map_err(|e| trouble(path, "cannot be written", &e))?;
    pending.finish()
}

/// A file that is being written beside its place.
pub struct Pending {
    temporary: NamedTempFile,
    path: PathBuf,
}

impl Pending {
    /// Begins a file.
    ///
    /// # Errors
    /// A finding that names the file.
    pub fn new(path: &Path) -> Result<Self, Finding> {
        let folder = parent(path);
        let temporary = tempfile::Builder::new()
            .prefix(".slipstick-")
            .permissions_for_people()
            .tempfile_in(&folder)
            .map_err(|e| trouble(path, "cannot be written", &e))?;
        Ok(Self { temporary, path: path.to_owned() })
    }
    /// The file to write to.
    pub fn file(&mut self) -> &mut fs::File {
        self.temporary.as_file_mut()
    }
    /// Puts it in its place.
    ///
    /// # Errors
    /// A finding that names the file.
    pub fn finish(self) -> Result<(), Finding> {
        let Self { temporary, path } = self;
        temporary.persist(&path).map(|_| ()).map_err(|e| trouble(&path, "cannot be written", &e.error))
    }
}

/// Temporary files are private by default; these become ordinary ones.
trait ForPeople {
    fn permissions_for_people(&mut self) -> &mut Self;
}

impl ForPeople for tempfile::Builder<'_, '_> {
    #[cfg(unix)]
    fn permissions_for_people(&mut self) -> &mut Self {
        use std::os::unix::fs::PermissionsExt as _;
        self.permissions(fs::Permissions::from_mode(0o666))
    }
    #[cfg(not(unix))]
    fn permissions_for_people(&mut self) -> &mut Self {
        self
    }
}

fn parent(path: &Path) -> PathBuf {
    match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// A folder that is being filled beside its place.
pub struct Staged {
    folder: TempDir,
    place: PathBuf,
}

impl Staged {
    /// Begins a folder; folders above it are made.
    ///
    /// # Errors
    /// A finding that names the folder.
    pub fn new(place: &Path) -> Result<Self, Finding> {
        let above = parent(place);
        fs::create_dir_all(&above).map_err(|e| trouble(place, "cannot be made", &e))?;
        let mut builder = tempfile::Builder::new();
        builder.prefix(".slipstick-unfinished-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            builder.permissions(fs::Permissions::from_mode(0o777));
        }
        let folder = builder.tempdir_in(&above).map_err(|e| trouble(place, "cannot be made", &e))?;
        Ok(Self { folder, place: place.to_owned() })
    }
    /// Where to write for now.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }
    /// Puts it in its place; what stood there goes away only then.
    ///
    /// # Errors
    /// A finding that names the folder.
    pub fn finish(self) -> Result<(), Finding> {
        let Self { folder, place } = self;
        let fault = |e: &io::Error| trouble(&place, "cannot be put in its place", e);
        let old = if place.exists() {
            let aside = tempfile::Builder::new()
                .prefix(".slipstick-replaced-")
                .tempdir_in(parent(&place))
                .map_err(|e| fault(&e))?;
            let inside = aside.path().join("old");
            fs::rename(&place, &inside).map_err(|e| fault(&e))?;
            Some((aside, inside))
        } else {
            None
        };
        if let Err(error) = fs::rename(folder.path(), &place) {
            if let Some((_, inside)) = &old {
                // Back to where it was; if even this fails, the first error is the one to tell.
                let _ = fs::rename(inside, &place);
            }
            return Err(fault(&error));
        }
        // It has moved: nothing is left to remove.
        let _ = folder.keep();
        Ok(())
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
