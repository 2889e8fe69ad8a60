//! Findings and results on the terminal: the only place that prints.
use crate::finding::Finding;
use crate::folder::Progress;
use crate::sheet::output::Format;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, BufRead, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How a command ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// All is fine.
    Fine = 0,
    /// `check`: not all answers are right.
    NotAllRight = 1,
    /// Somebody's file or the command line is faulty.
    Faulty = 2,
    /// `solve`: the declared regime fails.
    RegimeFails = 3,
}

/// The terminal, or what stands for it in a test.
pub struct Io<'a> {
    /// Standard input.
    pub input: &'a mut dyn BufRead,
    /// Standard output: results.
    pub out: &'a mut dyn Write,
    /// Standard error: findings, notes, progress.
    pub err: &'a mut dyn Write,
    /// Does a person watch standard error?
    pub watched: bool,
    /// Does a person type? What comes through a pipe does not end the line of a prompt.
    pub typed: bool,
}

/// Standard output that remembers the first fault, so that it is told at the end.
pub struct ResultStream<'a> {
    /// Where it goes.
    pub out: &'a mut dyn Write,
    /// What went wrong first.
    pub fault: Option<io::Error>,
}

impl ResultStream<'_> {
    fn noted<T>(&mut self, done: io::Result<T>) -> io::Result<T> {
        done.map_err(|fault| {
            let kind = fault.kind();
            if kind == io::ErrorKind::Interrupted {
                return fault;
            }
            self.fault.get_or_insert(fault);
            kind.into()
        })
    }
}

impl Write for ResultStream<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let done = self.out.write(bytes);
        self.noted(done)
    }
    fn flush(&mut self) -> io::Result<()> {
        let done = self.out.flush();
        self.noted(done)
    }
}

impl Io<'_> {
    /// How far work has come that takes long: a bar where a person watches, else a line now and then.
    pub fn bar(&self) -> Bar {
        Bar { watched: self.watched, bar: Mutex::new(None), told: Mutex::new((0, Instant::now())) }
    }
    /// A line of the result. What cannot be written is told at the end ([`ResultStream`]).
    pub fn line(&mut self, text: &str) {
        let _ = writeln!(self.out, "{text}");
    }
    /// A piece of the result, shown at once.
    pub fn piece(&mut self, text: &str) {
        let _ = self.out.write_all(text.as_bytes());
        let _ = self.out.flush();
    }
    /// A line beside the result.
    pub fn note(&mut self, text: &str) {
        let _ = writeln!(self.err, "{text}");
    }
    /// All findings, then how many there were.
    pub fn findings(&mut self, findings: &[Finding]) -> Exit {
        for finding in findings {
            let _ = writeln!(self.err, "error: {finding}");
        }
        if findings.len() > 1 {
            let _ = writeln!(self.err, "{} findings", findings.len());
        }
        Exit::Faulty
    }
    /// Shows a page in the browser, if that is wanted. Nothing waits for the browser, and one that does not start is no fault.
    pub fn open(&mut self, page: &Path, wanted: bool) {
        if !wanted {
            return;
        }
        let shown = page.display();
        let started = match page.is_file() {
            true => std::path::absolute(page).and_then(|page| browser(&page).spawn().map(drop)),
            false => Err(io::Error::from(io::ErrorKind::NotFound)),
        };
        if let Err(error) = started {
            self.note(&format!("note: {shown} cannot be shown ({error}); open it in a browser"));
        }
    }
    /// A line of input without its end, repeated behind the prompt if nobody typed it there; `None` at the end of the input. Bytes that are no UTF-8 are replaced.
    pub fn ask(&mut self) -> Option<String> {
        let mut bytes = Vec::new();
        match self.input.read_until(b'\n', &mut bytes) {
            Ok(0) | Err(_) => None,
            Ok(_) => {
                let text = String::from_utf8_lossy(&bytes).trim().to_owned();
                if !self.typed {
                    self.line(&text);
                }
                Some(text)
            }
        }
    }
}

/// What the system opens a page with.
fn browser(page: &Path) -> Command {
    let mut command = if cfg!(windows) {
        let mut start = Command::new("cmd");
        // The first text in quotes would be the title of a window.
        start.args(["/C", "start", ""]);
        start
    } else {
        Command::new(if cfg!(target_os = "macos") { "open" } else { "xdg-open" })
    };
    command.arg(page).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Booklets in these formats, as paths.
pub fn booklets(formats: &[Format], folder: &Path) -> String {
    let all = formats.iter().rev().filter(|f| **f != Format::Md);
    let all: Vec<String> = all.map(|f| format!("{}/booklet.{}", folder.display(), f.as_str())).collect();
    all.join(", ")
}

/// How far long work has come, on the terminal.
pub struct Bar {
    watched: bool,
    bar: Mutex<Option<ProgressBar>>,
    /// What is done, and when that was told last where nobody watches.
    told: Mutex<(u64, Instant)>,
}

/// Between two lines where nobody watches.
const EVERY: Duration = Duration::from_secs(10);

impl Progress for Bar {
    fn advance(&self, what: &str, units: u64, of: u64) {
        if !self.watched {
            let Ok(mut told) = self.told.lock() else { return };
            told.0 += units;
            if told.1.elapsed() >= EVERY && told.0 < of {
                told.1 = Instant::now();
                let _ = writeln!(io::stderr(), "{what}: {} of {of}", told.0);
            }
            return;
        }
        let Some(mut shown) = self.bar.lock().ok().filter(|_| of >= 200) else { return };
        let bar = shown.get_or_insert_with(|| {
            let bar = ProgressBar::new(of).with_message(what.to_owned());
            if let Ok(style) = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len} {eta}") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(200));
            bar
        });
        bar.inc(units);
        if bar.position() >= of {
            shown.take().iter().for_each(ProgressBar::finish_and_clear);
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Ok(Some(bar)) = self.bar.get_mut() {
            bar.finish_and_clear();
        }
    }
}
