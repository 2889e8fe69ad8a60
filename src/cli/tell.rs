//! Findings and results on the terminal: the only place that prints.
use crate::finding::Finding;
use crate::num::shown;
use std::io;
use std::io::BufRead;
use std::io::Write;

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
pub struct Told<'a> {
    /// Where it goes.
    pub out: &'a mut dyn Write,
    /// What went wrong first.
    pub fault: Option<io::Error>,
}

impl Told<'_> {
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

impl Write for Told<'_> {
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
    /// A line of the result. What cannot be written is told at the end ([`Told`]).
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

/// A table with columns as wide as they need; the first column to the left, the others to the right unless `left` says so.
pub fn table(rows: &[Vec<String>], left: &[usize]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| rows.iter().filter_map(|r| r.get(c)).map(|t| wide(t)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (c, cell) in row.iter().enumerate() {
            if c > 0 {
                line.push_str("  ");
            }
            let pad = widths[c].saturating_sub(wide(cell));
            if left.contains(&c) {
                line.push_str(cell);
                line.extend(std::iter::repeat_n(' ', pad));
            } else {
                line.extend(std::iter::repeat_n(' ', pad));
                line.push_str(cell);
            }
        }
        text.push_str("  ");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// A share in whole per cent: `40 %`.
pub fn percent(share: f64) -> String {
    format!("{} %", shown::per_cent(share, 0))
}

/// `1 sheet`, `2 sheets`
pub fn count(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}

/// Columns that a text takes on a terminal: Chinese, Japanese and Korean signs take two.
fn wide(text: &str) -> usize {
    let two = |c: &char| matches!(u32::from(*c), 0x1100..=0x115F | 0x2E80..=0xA4CF | 0xAC00..=0xD7A3 | 0xF900..=0xFAFF | 0xFE30..=0xFE6F | 0xFF00..=0xFF60);
    text.chars().count() + text.chars().filter(two).count()
}

/// Name and version of this program, for what it makes.
pub fn program() -> String {
    format!("{} {}", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"))
}
