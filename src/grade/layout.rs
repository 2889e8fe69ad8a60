//! What stands where in a file of submissions, and which of its rows are answers.
use crate::answer::submissions::{Record, RecordFault};
use crate::grade::feedback::Feedback;
use std::borrow::Cow;

/// A column of a wide file.
pub(crate) struct WideColumn {
    /// Index of the field.
    pub field: usize,
    pub header: String,
    /// Problem and part as written in it.
    pub problem: String,
    /// See `problem`.
    pub part: String,
    /// Which column of the table it is.
    pub column: Option<u32>,
    /// The header has more in it than the part.
    pub loose: bool,
}

pub(crate) enum FileForm {
    Long { problem: usize, part: usize, answer: usize },
    Wide(Vec<WideColumn>),
}

pub(crate) struct FileLayout {
    /// Fields of a record.
    pub width: usize,
    /// A record with fewer fields lacks one that is needed.
    pub least: usize,
    /// What separates fields.
    pub delimiter: u8,
    /// Field of the student.
    pub student: usize,
    /// Field of the time.
    pub submitted: Option<usize>,
    /// Field of the line on which the answer stood before, where the file was made of another.
    pub told_line: Option<usize>,
    /// Field of the code of the variant.
    pub code: Option<usize>,
    /// Where the answers stand.
    pub form: FileForm,
    /// Headers of fields that are not used.
    pub unused: Vec<String>,
}

impl FileLayout {
    /// The line of a record, for people.
    #[inline]
    pub fn line(&self, record: &Record) -> u64 {
        let told = self.told_line.and_then(|at| std::str::from_utf8(record.get(at)?).ok()?.parse().ok());
        told.unwrap_or(record.line)
    }
    /// Is it of an attempt at a quiz that was never submitted?
    pub fn is_open(&self, record: &Record) -> bool {
        let submitted = self.submitted.filter(|_| self.told_line.is_some());
        submitted.is_some_and(|at| trimmed(record.get(at).unwrap_or_default()).is_empty())
    }
}

/// Why a record is one unreadable line, or that nothing stands in it.
pub(crate) enum RecordKind {
    Cells,
    Empty,
    Unreadable(String),
}

pub(crate) fn kind_of_record(record: &Record, layout: &FileLayout, say: &Feedback) -> RecordKind {
    match record.fault {
        Some(RecordFault::Bytes) => return RecordKind::Unreadable(say.get("feedback.bytes").to_owned()),
        Some(RecordFault::TooLong) => {
            return RecordKind::Unreadable(say.get("feedback.long_field").to_owned());
        }
        None => {}
    }
    let n = record.len();
    // a short record may hold the halves of a split answer in place of the last columns
    let odd = n != layout.width && layout.delimiter == b',';
    // `1,25 m/s` may also have pushed its second half into the column of the time
    let pushed = matches!(layout.form, FileForm::Long { answer, .. } if layout.submitted == Some(answer + 1));
    let fits = n >= layout.least;
    let spare = fits && (layout.width..n).all(|i| blank(record.get(i).unwrap_or_default()));
    let split = if odd || (pushed && layout.delimiter == b',') {
        comma_split(record, layout, n, spare, say)
    } else {
        None
    };
    if n == layout.width {
        if let Some(said) = split {
            return RecordKind::Unreadable(said);
        }
        let all_empty = || (0..n).all(|i| blank(record.get(i).unwrap_or_default()));
        let student = record.get(layout.student).unwrap_or_default();
        return if student.is_empty() && all_empty() { RecordKind::Empty } else { RecordKind::Cells };
    }
    if (0..n).all(|i| blank(record.get(i).unwrap_or_default())) {
        return RecordKind::Empty;
    }
    if split.is_none() && spare {
        return RecordKind::Cells;
    }
    let pieces = [("n", &*n.to_string()), ("width", &*layout.width.to_string())];
    let mut count = say.fill("feedback.fields", &pieces).into_owned();
    if record.open {
        count.push_str(&format!(": {}", open_quote(record.line, say)));
    }
    if let Some(said) = split {
        return RecordKind::Unreadable(format!("{count}: {said}"));
    }
    RecordKind::Unreadable(count)
}

/// What is said of a quote that is an ordinary character.
pub(crate) fn open_quote<'w>(line: u64, say: &Feedback<'w>) -> Cow<'w, str> {
    say.fill("feedback.open_quote", &[("line", &line.to_string())])
}

/// Explains an answer such as `1,25 m/s` that stands in a comma file without quotes. Where the record would also fit
/// the header without it (`fits`), only a unit after the second half gives it away.
fn comma_split(record: &Record, layout: &FileLayout, n: usize, fits: bool, say: &Feedback) -> Option<String> {
    let (from, to) = match layout.form {
        FileForm::Long { answer, .. } => (answer, answer + 1),
        FileForm::Wide(_) => (0, if fits { 0 } else { n.saturating_sub(1) }),
    };
    (from..to).find_map(|i| {
        let (a, b) = (record.get(i)?.trim_ascii(), record.get(i + 1)?);
        let whole = a.strip_prefix(b"-").or_else(|| a.strip_prefix("\u{2212}".as_bytes())).unwrap_or(a);
        let digits = b.iter().take_while(|b| b.is_ascii_digit()).count();
        // digits, then perhaps a unit: neither a date nor a time
        let second = digits > 0
            && (!fits || b.len() > digits)
            && b.len() < 40
            && !b[digits..].iter().any(|b| matches!(b, b':' | b'-' | b'.'))
            && b.get(digits).is_none_or(|b| *b != b'/');
        if !second || !(1..=6).contains(&whole.len()) || !whole.iter().all(u8::is_ascii_digit) {
            return None;
        }
        let (a, b) = (String::from_utf8_lossy(a), String::from_utf8_lossy(b.trim_ascii()));
        Some(say.fill("feedback.comma_split", &[("a", &a), ("b", &b)]).into_owned())
    })
}

#[inline]
pub(crate) fn blank(text: &[u8]) -> bool {
    text.iter().all(|b| *b == b' ' || *b == b'\t')
        || std::str::from_utf8(text).is_ok_and(|t| t.trim().is_empty())
}

/// Text without NUL, replacement characters and control characters.
pub(crate) fn clean(text: &[u8]) -> bool {
    std::str::from_utf8(text).is_ok_and(|t| !t.contains(|c: char| c == '\u{fffd}' || c.is_control()))
}

/// A field without blanks around it.
#[inline]
pub(crate) fn trimmed(text: &[u8]) -> &[u8] {
    match (text.first(), text.last()) {
        (Some(a), Some(b)) if a.is_ascii_graphic() && b.is_ascii_graphic() => text,
        _ => std::str::from_utf8(text).map_or(text.trim_ascii(), |t| {
            t.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}').as_bytes()
        }),
    }
}
