//! A file of submissions to a file of verdicts: every answer cell exactly once, in the order of the input.
//!
//! Two passes over the input: the first finds which attempt of each student and part counts, the second judges and
//! writes. What is held grows with students times parts, not with rows. Batches of records are graded on several threads;
//! the output does not depend on their number.
use crate::answer::read::UnitCache;
use crate::answer::read::plain_number;
use crate::answer::submissions::Batch;
use crate::answer::submissions::Header;
use crate::answer::submissions::Record;
use crate::answer::submissions::RecordFault;
use crate::answer::submissions::Source;
use crate::finding::Finding;
use crate::grade::diagnose::Slip;
use crate::grade::diagnose::diagnose;
use crate::grade::feedback::Feedback;
use crate::grade::judge::accepts;
use crate::grade::judge::judge_with;
use crate::grade::table::KeyTable;
use crate::grade::table::joined;
use crate::grade::verdict::Judgement;
use crate::grade::verdict::Verdict;
use crate::policy::time;
use crate::policy::time::Evidence;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::io::Read;
use std::io::Write;
use std::sync::Condvar;
use std::sync::Mutex;
use std::sync::PoisonError;

/// Which of several attempts counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Attempts {
    /// The last one.
    #[default]
    Last,
    /// The one with the most points; of equal ones the first in the file.
    Best,
    /// The first one.
    First,
}

/// How to grade.
#[derive(Debug, Clone)]
pub struct Options<'w> {
    /// Which attempt counts.
    pub attempts: Attempts,
    /// Role (`student`, `problem`, `part`, `answer`, `submitted_at`) and the header that stands for it.
    pub columns: Vec<(String, String)>,
    /// Threads, at least 1.
    pub threads: usize,
    /// What is said of an answer.
    pub feedback: Feedback<'w>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        let feedback = Feedback::english().clone();
        Options { attempts: Attempts::Last, columns: Vec::new(), threads: 1, feedback }
    }
}

/// Why nothing was graded.
#[derive(Debug)]
pub enum GradeFault {
    /// Reading or writing failed.
    Io(io::Error),
    /// The header does not do; all that is wrong with it.
    Header(Vec<Finding>),
}

impl fmt::Display for GradeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GradeFault::Io(fault) => write!(f, "{fault}"),
            GradeFault::Header(findings) => {
                for (i, finding) in findings.iter().enumerate() {
                    write!(f, "{}{finding}", if i > 0 { "\n" } else { "" })?;
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for GradeFault {}

impl From<io::Error> for GradeFault {
    fn from(fault: io::Error) -> Self {
        GradeFault::Io(fault)
    }
}

/// Counts by verdict, in the order of `Verdict::ALL`.
pub type Counts = [u64; Verdict::ALL.len()];

/// What came out.
#[derive(Debug, Clone)]
pub struct Graded {
    /// Lines written, one for each answer cell or unreadable record.
    pub cells: u64,
    /// By verdict.
    pub counts: Counts,
    /// By verdict for each column of the table.
    pub by_column: Vec<Counts>,
    /// Points of the attempt that counts, student after student; `None` where nothing was handed in.
    pub points: Vec<Option<f64>>,
    /// Long or wide form.
    pub wide: bool,
    /// Parts of a student whose attempts were ordered by row because a `submitted_at` cannot be read.
    pub untimed: u64,
    /// Columns of the file that were not used.
    pub unused_columns: Vec<String>,
}

impl Graded {
    /// Count of one verdict.
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.counts[verdict as usize]
    }
}

/// A column of a wide file.
struct WideColumn {
    field: usize,
    header: String,
    problem: String,
    part: String,
    column: Option<u32>,
}

enum Form {
    Long { problem: usize, part: usize, answer: usize },
    Wide(Vec<WideColumn>),
}

/// What stands where.
struct Layout {
    width: usize,
    /// A record with fewer fields lacks one that is needed.
    least: usize,
    delimiter: u8,
    student: usize,
    submitted: Option<usize>,
    form: Form,
    unused: Vec<String>,
}

fn plain_header(text: &str) -> String {
    text.trim().to_lowercase().replace([' ', '-'], "_")
}

fn layout(header: Option<Header>, table: &KeyTable, options: &Options) -> Result<Layout, Vec<Finding>> {
    let Some(header) = header else {
        return Err(vec![
            Finding::new("header", "the file is empty")
                .hint("the first line is `student,problem,part,answer`"),
        ]);
    };
    let mut findings = Vec::new();
    const ROLES: [&str; 5] = ["student", "problem", "part", "answer", "submitted_at"];
    // `problem.part` stands for a column of a wide file
    let mut mapped_parts = Vec::new();
    for (role, wanted) in options.columns.iter().filter(|(role, _)| !ROLES.contains(&role.as_str())) {
        let Some((problem, part)) = role.split_once('.').filter(|(p, _)| table.has_problem(p.trim())) else {
            findings.push(
                Finding::new("--columns", format!("unknown column `{role}`"))
                    .hint(format!("one of {}, or a part such as 1.omega", ROLES.join(", "))),
            );
            continue;
        };
        let (problem, part) = (problem.trim(), part.trim());
        let mut key = Vec::new();
        joined(problem.as_bytes(), part.as_bytes(), &mut key);
        let column = table.column(&key);
        if column.is_none() {
            findings.push(Finding::new("--columns", table.unknown_part(problem, part, Feedback::english())));
        }
        let exact: Vec<usize> = (0..header.fields.len()).filter(|i| header.fields[*i] == *wanted).collect();
        let hits = if exact.is_empty() {
            let wanted = plain_header(wanted);
            (0..header.fields.len()).filter(|i| plain_header(&header.fields[*i]) == wanted).collect()
        } else {
            exact
        };
        if let [field] = hits[..] {
            mapped_parts.push(WideColumn {
                field,
                header: header.fields[field].clone(),
                problem: problem.to_owned(),
                part: part.to_owned(),
                column,
            });
        } else {
            let said = match hits.len() {
                0 => format!("no column `{wanted}`"),
                n => format!("column `{wanted}` stands there {n} times"),
            };
            let hint =
                format!("the columns are: {}", header.fields[..header.fields.len().min(30)].join(" | "));
            findings.push(Finding::new("header", said).at(header.line as usize, 1).hint(hint));
        }
    }
    let mut find = |role: &str, required: bool| -> Option<usize> {
        let mapped = options.columns.iter().find(|(r, _)| r == role).map(|(_, h)| h.as_str());
        let wanted = plain_header(mapped.unwrap_or(role));
        let exact = mapped.and_then(|m| header.fields.iter().position(|h| h == m.trim()));
        let hits: Vec<usize> = match exact {
            Some(at) => vec![at],
            None => (0..header.fields.len()).filter(|i| plain_header(&header.fields[*i]) == wanted).collect(),
        };
        let hits = if hits.is_empty() && role == "submitted_at" && mapped.is_none() {
            (0..header.fields.len()).filter(|i| plain_header(&header.fields[*i]) == "timestamp").collect()
        } else {
            hits
        };
        if hits.len() > 1 {
            let at: Vec<String> = hits.iter().map(|i| (i + 1).to_string()).collect();
            findings.push(
                Finding::new(
                    "header",
                    format!("column `{wanted}` stands there {} times (fields {})", hits.len(), at.join(", ")),
                )
                .at(header.line as usize, 1)
                .hint("rename all but one"),
            );
        } else if hits.is_empty() && (required || mapped.is_some()) {
            let hint = format!(
                "the columns are: {}; map one with --columns {role}=\"Its header\"",
                header.fields.iter().take(30).map(String::as_str).collect::<Vec<_>>().join(" | ")
            );
            findings.push(
                Finding::new("header", format!("no column `{}`", mapped.unwrap_or(role)))
                    .at(header.line as usize, 1)
                    .hint(hint),
            );
        }
        hits.first().copied()
    };
    let student = find("student", true);
    let submitted = find("submitted_at", false);
    // wide: headers such as `1.omega`
    let mut wide = Vec::new();
    let mut key = Vec::new();
    for (field, text) in header.fields.iter().enumerate() {
        if mapped_parts.iter().any(|m| m.field == field) {
            continue;
        }
        let Some((problem, part)) = text.split_once('.') else { continue };
        let (problem, part) = (problem.trim(), part.trim());
        let number = !problem.is_empty() && problem.bytes().all(|b| b.is_ascii_digit());
        if Some(field) == student || part.is_empty() || !(number || table.has_problem(problem)) {
            continue;
        }
        joined(problem.as_bytes(), part.as_bytes(), &mut key);
        let column = table.column(&key);
        wide.push(WideColumn {
            field,
            header: text.clone(),
            problem: problem.to_owned(),
            part: part.to_owned(),
            column,
        });
    }
    let told = !mapped_parts.is_empty();
    wide.append(&mut mapped_parts);
    wide.sort_by_key(|w| w.field);
    let names_long = |role: &str| {
        options.columns.iter().any(|(r, _)| r == role)
            || header.fields.iter().any(|h| plain_header(h) == role)
    };
    let is_wide = told || !wide.is_empty() && !["problem", "part", "answer"].into_iter().all(names_long);
    let form = if is_wide {
        for (i, one) in wide.iter().enumerate() {
            if wide[..i].iter().any(|w| w.column.is_some() && w.column == one.column) {
                findings.push(
                    Finding::new(
                        "header",
                        format!("column `{}` asks for a part that stands there already", one.header),
                    )
                    .at(header.line as usize, 1)
                    .hint("keep one column for each part"),
                );
            }
        }
        Some(Form::Wide(wide))
    } else {
        match (find("problem", true), find("part", true), find("answer", true)) {
            (Some(problem), Some(part), Some(answer)) => Some(Form::Long { problem, part, answer }),
            _ => None,
        }
    };
    match (student, form) {
        (Some(student), Some(form)) if findings.is_empty() => {
            let used = |i: usize| {
                i == student
                    || submitted == Some(i)
                    || match &form {
                        Form::Long { problem, part, answer } => [*problem, *part, *answer].contains(&i),
                        Form::Wide(all) => all.iter().any(|w| w.field == i),
                    }
            };
            let unused =
                (0..header.fields.len()).filter(|i| !used(*i)).map(|i| header.fields[i].clone()).collect();
            let least = match &form {
                Form::Long { problem, part, answer } => *problem.max(part).max(answer),
                Form::Wide(all) => all.iter().map(|w| w.field).max().unwrap_or(0),
            };
            Ok(Layout {
                width: header.fields.len(),
                least: least.max(student) + 1,
                delimiter: header.delimiter,
                student,
                submitted,
                form,
                unused,
            })
        }
        _ => Err(findings),
    }
}

/// One attempt, seen in the first pass, or the sum of several.
#[derive(Debug, Clone, Copy)]
struct Attempt {
    /// 0: none or blank, 1: unreadable, 2: readable.
    class: u8,
    /// More than one of this class.
    several: bool,
    /// A time that cannot be read, and one with slashes, and one with points, whose day and month are uncertain.
    untimed: [bool; 3],
    /// With the day first, with the month first.
    by_time: [(i64, u64); 2],
    by_row: u64,
    best: (f64, u64),
}

impl Attempt {
    const NONE: Attempt = Attempt {
        class: 0,
        several: false,
        untimed: [false; 3],
        by_time: [(0, 0); 2],
        by_row: 0,
        best: (0.0, 0),
    };
    /// Of two, what counts; the order in which they are joined does not matter.
    fn join(&mut self, other: &Attempt, attempts: Attempts) {
        if other.class == 0 || self.class > other.class {
            return;
        }
        if self.class < other.class {
            *self = *other;
            return;
        }
        self.several = true;
        let first = attempts == Attempts::First;
        for (mine, other) in self.untimed.iter_mut().zip(other.untimed) {
            *mine |= other;
        }
        for (mine, other) in self.by_time.iter_mut().zip(other.by_time) {
            if (other < *mine) == first {
                *mine = other;
            }
        }
        if (other.by_row < self.by_row) == first {
            self.by_row = other.by_row;
        }
        if other.best.0 > self.best.0 || (other.best.0 >= self.best.0 && other.best.1 < self.best.1) {
            self.best = other.best;
        }
    }
    /// What the whole column of times makes of it.
    fn decide(&self, attempts: Attempts, evidence: Evidence) -> Winner {
        let [unread, slashed, dotted] = self.untimed;
        let untimed = unread || (slashed && !evidence.decides(false)) || (dotted && !evidence.decides(true));
        let at = match attempts {
            Attempts::Best => self.best.1,
            _ if untimed => self.by_row,
            _ => self.by_time[evidence.choice()].1,
        };
        Winner { at, by_row: untimed && self.several && attempts != Attempts::Best }
    }
}

/// The attempt that counts.
#[derive(Debug, Clone, Copy)]
struct Winner {
    at: u64,
    /// Taken by row from several, because a time cannot be read.
    by_row: bool,
}

/// A place in the file: the line, then the column of a wide file.
const COLUMN_BITS: u32 = 13;
fn place(line: u64, column: usize) -> u64 {
    (line << COLUMN_BITS) | column.min((1 << COLUMN_BITS) - 1) as u64
}

/// What a worker keeps between rows.
struct Worker {
    record: Record,
    units: UnitCache,
    key: Vec<u8>,
    last_student: Option<(Vec<u8>, u32)>,
    last_part: Option<(Vec<u8>, u32)>,
    attempts: Vec<Attempt>,
    evidence: Evidence,
    points: Vec<(u32, f64)>,
    cells: u64,
    counts: Counts,
    by_column: Vec<Counts>,
}

impl Worker {
    fn new(table: &KeyTable, first_pass: bool) -> Worker {
        let cells = table.students.len() * table.columns.len();
        Worker {
            record: Record::default(),
            units: UnitCache::default(),
            key: Vec::new(),
            last_student: None,
            last_part: None,
            attempts: vec![Attempt::NONE; if first_pass { cells } else { 0 }],
            evidence: Evidence::default(),
            points: Vec::new(),
            cells: 0,
            counts: Counts::default(),
            by_column: vec![Counts::default(); table.columns.len()],
        }
    }
}

/// A cell with what is known of it.
struct Cell<'a> {
    line: u64,
    /// Index and header in a wide file.
    column: Option<(usize, &'a str)>,
    student: &'a [u8],
    problem: &'a [u8],
    part: &'a [u8],
    answer: &'a [u8],
    who: Option<u32>,
    what: Option<u32>,
}

/// Why a record is one unreadable line, or that nothing stands in it.
enum Row {
    Cells,
    Empty,
    Unreadable(String),
}

fn sort_of_row(record: &Record, layout: &Layout, say: &Feedback) -> Row {
    match record.fault() {
        Some(RecordFault::Bytes) => return Row::Unreadable(say.get("feedback.bytes").to_owned()),
        Some(RecordFault::TooLong) => return Row::Unreadable(say.get("feedback.long_field").to_owned()),
        None => {}
    }
    let n = record.len();
    // a short record may hold the halves of a split answer in place of the last columns
    let odd = n != layout.width && layout.delimiter == b',';
    // `1,25 m/s` may also have pushed its second half into the column of the time
    let pushed = matches!(layout.form, Form::Long { answer, .. } if layout.submitted == Some(answer + 1));
    let fits = n >= layout.least;
    let spare = fits && (layout.width..n).all(|i| blank(record.get(i).unwrap_or_default()));
    let split = if odd || (pushed && layout.delimiter == b',') {
        comma_split(record, layout, n, spare, say)
    } else {
        None
    };
    if n == layout.width {
        if let Some(said) = split {
            return Row::Unreadable(said);
        }
        let all_empty = || (0..n).all(|i| blank(record.get(i).unwrap_or_default()));
        let student = record.get(layout.student).unwrap_or_default();
        return if student.is_empty() && all_empty() { Row::Empty } else { Row::Cells };
    }
    if (0..n).all(|i| blank(record.get(i).unwrap_or_default())) {
        return Row::Empty;
    }
    if split.is_none() && spare {
        return Row::Cells;
    }
    let pieces = [("n", &*n.to_string()), ("width", &*layout.width.to_string())];
    let mut count = say.fill("feedback.fields", &pieces).into_owned();
    if record.quote_left_open() {
        count.push_str(&format!(": {}", open_quote(record.line(), say)));
    }
    if let Some(said) = split {
        return Row::Unreadable(format!("{count}: {said}"));
    }
    Row::Unreadable(count)
}

/// What is said of a quote that is an ordinary character.
fn open_quote<'w>(line: u64, say: &Feedback<'w>) -> Cow<'w, str> {
    say.fill("feedback.open_quote", &[("line", &line.to_string())])
}

/// Explains an answer such as `1,25 m/s` that stands in a comma file without quotes. Where the record would also fit
/// the header without it (`fits`), only a unit after the second half gives it away.
fn comma_split(record: &Record, layout: &Layout, n: usize, fits: bool, say: &Feedback) -> Option<String> {
    let (from, to) = match layout.form {
        Form::Long { answer, .. } => (answer, answer + 1),
        Form::Wide(_) => (0, if fits { 0 } else { n.saturating_sub(1) }),
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
fn blank(text: &[u8]) -> bool {
    text.iter().all(|b| *b == b' ' || *b == b'\t')
        || std::str::from_utf8(text).is_ok_and(|t| t.trim().is_empty())
}

/// Text without NUL, replacement characters and control characters.
fn clean(text: &[u8]) -> bool {
    std::str::from_utf8(text).is_ok_and(|t| !t.contains(|c: char| c == '\u{fffd}' || c.is_control()))
}

/// A field without blanks around it.
#[inline]
fn trimmed(text: &[u8]) -> &[u8] {
    match (text.first(), text.last()) {
        (Some(a), Some(b)) if a.is_ascii_graphic() && b.is_ascii_graphic() => text,
        _ => std::str::from_utf8(text).map_or(text.trim_ascii(), |t| {
            t.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}').as_bytes()
        }),
    }
}

/// Calls `each` for every cell of a record.
fn cells<'a>(
    record: &'a Record,
    layout: &'a Layout,
    table: &KeyTable,
    memory: &mut Memory<'_>,
    each: &mut dyn FnMut(&mut Memory<'_>, &Cell<'a>),
) {
    let student = trimmed(record.get(layout.student).unwrap_or_default());
    let who = match memory.last_student {
        Some((bytes, s)) if bytes == student => Some(*s),
        _ => {
            let found = table.student(student);
            *memory.last_student = found.map(|s| (student.to_vec(), s));
            found
        }
    };
    let line = record.line();
    match &layout.form {
        Form::Long { problem, part, answer } => {
            let (problem, part) = (
                trimmed(record.get(*problem).unwrap_or_default()),
                trimmed(record.get(*part).unwrap_or_default()),
            );
            joined(problem, part, memory.key);
            let what = match memory.last_part {
                Some((bytes, c)) if bytes == memory.key => Some(*c),
                _ => {
                    let found = table.column(memory.key);
                    *memory.last_part = found.map(|c| (memory.key.clone(), c));
                    found
                }
            };
            let answer = record.get(*answer).unwrap_or_default();
            each(memory, &Cell { line, column: None, student, problem, part, answer, who, what });
        }
        Form::Wide(all) => {
            for (index, one) in all.iter().enumerate() {
                let cell = Cell {
                    line,
                    column: Some((index, &one.header)),
                    student,
                    problem: one.problem.as_bytes(),
                    part: one.part.as_bytes(),
                    answer: record.get(one.field).unwrap_or_default(),
                    who,
                    what: one.column,
                };
                each(memory, &cell);
            }
        }
    }
}

/// The parts of a worker that looking up needs.
struct Memory<'a> {
    last_student: &'a mut Option<(Vec<u8>, u32)>,
    last_part: &'a mut Option<(Vec<u8>, u32)>,
    key: &'a mut Vec<u8>,
    units: &'a mut UnitCache,
}

/// Judges a cell whose student and column are known; the plain number's way needs no text.
#[inline]
fn judged<'w>(
    table: &KeyTable,
    who: u32,
    what: u32,
    answer: &[u8],
    units: &mut UnitCache,
    say: &Feedback<'w>,
) -> Judgement<'w> {
    let hot = &table.hot[who as usize * table.columns.len() + what as usize];
    if hot.fast
        && let Some(number) = plain_number(answer)
    {
        let x = number * hot.times / hot.over;
        if x.is_finite() {
            let (verdict, points, reason) = if accepts(x, hot.value, hot.half_width) {
                (Verdict::Right, hot.points, say.within)
            } else if accepts(-x, hot.value, hot.half_width) {
                (Verdict::WrongDirection, 0.0, if hot.magnitude { say.no_sign } else { say.other_sign })
            } else {
                (Verdict::Wrong, 0.0, say.outside)
            };
            return Judgement { verdict, points, reason: Cow::Borrowed(reason), number: x };
        }
    }
    match table.entry(who as usize, what as usize) {
        Some(entry) => judge_with(&String::from_utf8_lossy(answer), entry, units, say),
        None => Judgement {
            verdict: Verdict::UnknownPart,
            points: 0.0,
            reason: Cow::Borrowed(say.get("feedback.no_such_part")),
            number: f64::NAN,
        },
    }
}

/// What a wrong answer fits: ids of wrong methods, and the reason told with its slip.
fn diagnosed(table: &KeyTable, who: u32, what: u32, judgement: &mut Judgement, say: &Feedback) -> String {
    let (parts, part, methods) = table.problem_of(who as usize, what as usize);
    let found = diagnose(judgement.number, part, parts);
    let slip = match found.slip {
        Some(Slip::PowerOfTen(n)) => Some(say.fill("feedback.slip.power_of_ten", &[("n", &n.to_string())])),
        Some(Slip::Unit(from, to)) => Some(say.fill("feedback.slip.unit", &[("from", from), ("to", to)])),
        Some(Slip::FewerFigures(n)) => Some(say.fill("feedback.slip.figures", &[("n", &n.to_string())])),
        Some(Slip::Drift) => Some(Cow::Borrowed(say.get("feedback.slip.drift"))),
        Some(Slip::OtherPart(i)) => {
            let first = what as usize - part;
            let other = table.columns.get(first + i).map_or("", |c| c.part.as_str());
            Some(say.fill("feedback.slip.other_part", &[("part", other)]))
        }
        None => None,
    };
    if let Some(slip) = slip {
        judgement.reason = Cow::Owned(format!("{}; {slip}", judgement.reason));
    }
    let mut ids = String::new();
    for method in found.methods {
        if let Some(id) = methods.get(usize::from(method)) {
            if !ids.is_empty() {
                ids.push(' ');
            }
            ids.push_str(id);
        }
    }
    ids
}

fn first_pass(worker: &mut Worker, batch: &Batch, table: &KeyTable, layout: &Layout, options: &Options) {
    let Worker { record, units, key, last_student, last_part, attempts, evidence, .. } = worker;
    let mut memory = Memory { last_student, last_part, key, units };
    batch.records(record, &mut |record| {
        if !matches!(sort_of_row(record, layout, &options.feedback), Row::Cells) {
            return;
        }
        let text = layout.submitted.and_then(|i| record.get(i)).and_then(|t| std::str::from_utf8(t).ok());
        let time = text.and_then(time::parse);
        if let Some(moment) = time {
            evidence.join(moment.evidence);
        }
        let uncertain = time.and_then(|t| t.uncertain);
        cells(record, layout, table, &mut memory, &mut |memory, cell| {
            let (Some(who), Some(what)) = (cell.who, cell.what) else { return };
            let index = who as usize * table.columns.len() + what as usize;
            let known = options.attempts != Attempts::Best
                && table.hot[index].fast
                && plain_number(cell.answer).is_some();
            let (class, points) = if known {
                (2, 0.0)
            } else {
                let judgement = judged(table, who, what, cell.answer, memory.units, &options.feedback);
                let class = match judgement.verdict {
                    Verdict::Blank | Verdict::UnknownPart => return,
                    Verdict::Unreadable => 1,
                    _ => 2,
                };
                (class, judgement.points)
            };
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            let one = Attempt {
                class,
                several: false,
                untimed: [
                    layout.submitted.is_some() && time.is_none(),
                    uncertain == Some(false),
                    uncertain == Some(true),
                ],
                by_time: time.map_or([0; 2], |t| t.micros).map(|t| (t, at)),
                by_row: at,
                best: (points, at),
            };
            attempts[index].join(&one, options.attempts);
        });
    });
}

fn second_pass(
    worker: &mut Worker,
    batch: &Batch,
    out: &mut Vec<u8>,
    table: &KeyTable,
    layout: &Layout,
    winners: &[Winner],
    say: &Feedback,
) {
    let Worker {
        record,
        units,
        key,
        last_student,
        last_part,
        points: earned,
        cells: written,
        counts,
        by_column,
        ..
    } = worker;
    let mut memory = Memory { last_student, last_part, key, units };
    let by_row_says = say.get("feedback.by_row");
    let mut reason = Vec::new();
    let whole = |out: &mut Vec<u8>, record: &Record, verdict: Verdict, reason: &str| {
        push_number(out, record.line());
        out.extend_from_slice(b",,");
        let before_answer = match &layout.form {
            Form::Long { answer, .. } => *answer,
            Form::Wide(_) => usize::MAX,
        };
        let bytes = record.fault() == Some(RecordFault::Bytes);
        let in_place = |i: usize| i < before_answer || (bytes && record.len() == layout.width);
        // what stands before the trouble can be shown in its column
        let field = |i: usize| {
            let text = trimmed(record.get(i).unwrap_or_default());
            let fits = record.fault().is_none() || (bytes && clean(text));
            if fits && in_place(i) { text } else { b"" }
        };
        let student = field(layout.student);
        push_text(out, student);
        out.push(b',');
        let mut points = None;
        if let Form::Long { problem, part, .. } = layout.form {
            let mut key = Vec::new();
            joined(field(problem), field(part), &mut key);
            match table.column(&key) {
                Some(what) => {
                    out.extend_from_slice(&table.columns[what as usize].fields);
                    points = table
                        .student(student)
                        .map(|who| table.hot[who as usize * table.columns.len() + what as usize].points);
                }
                None => {
                    push_text(out, field(problem));
                    out.push(b',');
                    push_text(out, field(part));
                }
            }
        } else {
            out.push(b',');
        }
        out.push(b',');
        push_text(out, record.shown(layout.delimiter).as_bytes());
        out.push(b',');
        out.extend_from_slice(verdict.as_str().as_bytes());
        out.extend_from_slice(b",0,");
        push_float(out, points.unwrap_or(0.0));
        out.push(b',');
        push_text(out, reason.as_bytes());
        out.extend_from_slice(b",\n");
    };
    batch.records(record, &mut |record| {
        match sort_of_row(record, layout, say) {
            Row::Cells => {}
            Row::Empty => {
                *written += 1;
                counts[Verdict::Blank as usize] += 1;
                return whole(out, record, Verdict::Blank, say.get("feedback.empty_record"));
            }
            Row::Unreadable(reason) => {
                *written += 1;
                counts[Verdict::Unreadable as usize] += 1;
                return whole(out, record, Verdict::Unreadable, &reason);
            }
        }
        cells(record, layout, table, &mut memory, &mut |memory, cell| {
            push_number(out, cell.line);
            out.push(b',');
            if let Some((_, header)) = cell.column {
                push_text(out, header.as_bytes());
            }
            out.push(b',');
            match cell.who {
                Some(who) => out.extend_from_slice(&table.students[who as usize].field),
                None => push_text(out, cell.student),
            }
            out.push(b',');
            match cell.what {
                Some(what) => out.extend_from_slice(&table.columns[what as usize].fields),
                None => {
                    push_text(out, cell.problem);
                    out.push(b',');
                    push_text(out, cell.part);
                }
            }
            out.push(b',');
            push_text(out, cell.answer);
            out.push(b',');
            *written += 1;
            let (Some(who), Some(what)) = (cell.who, cell.what) else {
                let text = |b: &[u8]| String::from_utf8_lossy(b).into_owned();
                let (verdict, reason) = if cell.who.is_none() {
                    (Verdict::UnknownStudent, table.unknown_student(&text(cell.student), say))
                } else {
                    (Verdict::UnknownPart, table.unknown_part(&text(cell.problem), &text(cell.part), say))
                };
                counts[verdict as usize] += 1;
                out.extend_from_slice(verdict.as_str().as_bytes());
                out.extend_from_slice(b",0,0,");
                push_text(out, reason.as_bytes());
                out.extend_from_slice(b",\n");
                return;
            };
            let index = who as usize * table.columns.len() + what as usize;
            let mut judgement = judged(table, who, what, cell.answer, memory.units, say);
            if judgement.verdict == Verdict::Unreadable
                && record.quote_left_open()
                && cell.answer.trim_ascii_start().starts_with(b"\"")
            {
                judgement.reason = open_quote(cell.line, say);
            }
            let methods = if matches!(judgement.verdict, Verdict::Wrong | Verdict::WrongDirection) {
                diagnosed(table, who, what, &mut judgement, say)
            } else {
                String::new()
            };
            let Winner { at: winner, by_row } = winners[index];
            let counts_not = !matches!(judgement.verdict, Verdict::Blank | Verdict::UnknownPart);
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            let superseded = counts_not && winner != at;
            let verdict = if superseded { Verdict::Superseded } else { judgement.verdict };
            counts[verdict as usize] += 1;
            by_column[what as usize][verdict as usize] += 1;
            if counts_not && !superseded {
                earned.push((index as u32, judgement.points));
            }
            out.extend_from_slice(verdict.as_str().as_bytes());
            out.push(b',');
            push_float(out, if superseded { 0.0 } else { judgement.points });
            out.push(b',');
            push_float(out, table.hot[index].points);
            out.push(b',');
            let by_row = by_row && counts_not;
            if superseded {
                let plain =
                    judgement.verdict != Verdict::Unreadable && matches!(judgement.reason, Cow::Borrowed(_));
                reason.clear();
                say.superseded(winner >> COLUMN_BITS, judgement.verdict, push_number, &mut reason);
                if !plain {
                    reason.extend_from_slice(b": ");
                    reason.extend_from_slice(judgement.reason.as_bytes());
                    if by_row {
                        reason.extend_from_slice(b"; ");
                        reason.extend_from_slice(by_row_says.as_bytes());
                    }
                } else if by_row {
                    reason.extend_from_slice(b"; ");
                    reason.extend_from_slice(say.get("feedback.by_row_short").as_bytes());
                }
                push_text(out, &reason);
            } else if by_row {
                push_text(out, format!("{}; {by_row_says}", judgement.reason).as_bytes());
            } else {
                push_text(out, judgement.reason.as_bytes());
            }
            out.push(b',');
            out.extend_from_slice(methods.as_bytes());
            out.push(b'\n');
        });
    });
}

/// Opens the input anew.
pub type Open<'a> = &'a dyn Fn() -> io::Result<Box<dyn Read + Send>>;

/// Header of answers.csv.
pub const ANSWERS_HEADER: &str =
    "line,column,student,problem,part,answer,verdict,points,max_points,reason,methods\n";

/// Grades a file of submissions. `open` is called twice and must give the same bytes; `out` receives answers.csv; `progress`
/// hears the bytes read so far over both passes (twice the size of the file at the end).
///
/// # Errors
/// A header that does not do, or reading and writing that fail.
pub fn grade(
    open: Open<'_>,
    table: &KeyTable,
    options: &Options,
    out: &mut (dyn Write + Send),
    progress: &mut (dyn FnMut(u64) + Send),
) -> Result<Graded, GradeFault> {
    let threads = options.threads.max(1);
    let (source, header) = Source::open(open()?)?;
    let layout = layout(header, table, options).map_err(GradeFault::Header)?;
    let workers = (0..threads).map(|_| Worker::new(table, true)).collect();
    let mut read = 0;
    let workers = {
        let mut heard = |n: u64| {
            read = read.max(n);
            progress(n);
        };
        sweep(
            source,
            workers,
            &|w, batch, _| first_pass(w, batch, table, &layout, options),
            None,
            &mut heard,
        )?
    };
    let mut all = vec![Attempt::NONE; table.students.len() * table.columns.len()];
    let mut evidence = Evidence::default();
    for worker in workers {
        evidence.join(worker.evidence);
        for (all, one) in all.iter_mut().zip(&worker.attempts) {
            all.join(one, options.attempts);
        }
    }
    let winners: Vec<Winner> = all.iter().map(|a| a.decide(options.attempts, evidence)).collect();
    drop(all);
    let (source, _) = Source::open(open()?)?;
    out.write_all(ANSWERS_HEADER.as_bytes())?;
    let workers = (0..threads).map(|_| Worker::new(table, false)).collect();
    let workers = sweep(
        source,
        workers,
        &|w, batch, out| second_pass(w, batch, out, table, &layout, &winners, &options.feedback),
        Some(&mut *out),
        &mut |n| progress(read + n),
    )?;
    out.flush()?;
    let mut graded = Graded {
        cells: 0,
        counts: Counts::default(),
        by_column: vec![Counts::default(); table.columns.len()],
        points: vec![None; winners.len()],
        wide: matches!(layout.form, Form::Wide(_)),
        untimed: winners.iter().filter(|w| w.by_row).count() as u64,
        unused_columns: layout.unused.clone(),
    };
    for worker in workers {
        graded.cells += worker.cells;
        let add = |to: &mut Counts, from: &Counts| to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
        add(&mut graded.counts, &worker.counts);
        for (to, from) in graded.by_column.iter_mut().zip(&worker.by_column) {
            add(to, from);
        }
        for (index, points) in worker.points {
            graded.points[index as usize] = Some(points);
        }
    }
    Ok(graded)
}

struct Output<'a, 'b> {
    next: u64,
    waiting: BTreeMap<u64, Vec<u8>>,
    out: Option<&'b mut (dyn Write + Send + 'b)>,
    progress: &'a mut (dyn FnMut(u64) + Send),
    fault: Option<io::Error>,
}

type Process<'a> = &'a (dyn Fn(&mut Worker, &Batch, &mut Vec<u8>) + Sync);

/// Runs all batches through the workers; what they write comes out in the order of the batches.
fn sweep<'b>(
    source: Source,
    workers: Vec<Worker>,
    process: Process<'_>,
    out: Option<&'b mut (dyn Write + Send + 'b)>,
    progress: &mut (dyn FnMut(u64) + Send),
) -> io::Result<Vec<Worker>> {
    let limit = workers.len() * 4;
    let source = Mutex::new(source);
    let output = Mutex::new(Output { next: 0, waiting: BTreeMap::new(), out, progress, fault: None });
    let turn = Condvar::new();
    let work = |mut worker: Worker| -> io::Result<Worker> {
        let (mut batch, mut text) = (Batch::default(), Vec::new());
        let hold = || output.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            let more = source.lock().unwrap_or_else(PoisonError::into_inner).next_batch(&mut batch);
            match more {
                Ok(true) => {}
                Ok(false) => return Ok(worker),
                Err(fault) => {
                    hold().fault.get_or_insert_with(|| io::Error::from(fault.kind()));
                    turn.notify_all();
                    return Err(fault);
                }
            }
            text.clear();
            process(&mut worker, &batch, &mut text);
            let mut held = hold();
            while held.next != batch.number && held.waiting.len() >= limit && held.fault.is_none() {
                held = turn.wait(held).unwrap_or_else(PoisonError::into_inner);
            }
            if held.fault.is_some() {
                return Ok(worker);
            }
            if held.next != batch.number {
                held.waiting.insert(batch.number, std::mem::take(&mut text));
                continue;
            }
            (held.progress)(batch.read_so_far);
            let mut bytes = std::mem::take(&mut text);
            loop {
                if let Some(out) = &mut held.out
                    && let Err(fault) = out.write_all(&bytes)
                {
                    held.fault = Some(io::Error::from(fault.kind()));
                    turn.notify_all();
                    return Err(fault);
                }
                text = bytes;
                held.next += 1;
                let next = held.next;
                match held.waiting.remove(&next) {
                    Some(more) => bytes = more,
                    None => break,
                }
            }
            turn.notify_all();
        }
    };
    if workers.len() == 1 {
        return workers.into_iter().map(work).collect();
    }
    std::thread::scope(|scope| {
        let running: Vec<_> = workers.into_iter().map(|w| scope.spawn(|| work(w))).collect();
        running
            .into_iter()
            .map(|r| r.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

/// A whole number.
fn push_number(out: &mut Vec<u8>, mut number: u64) {
    let mut digits = [0u8; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

/// Points: whole numbers without a point.
pub(crate) fn push_float(out: &mut Vec<u8>, value: f64) {
    if (0.0..1e15).contains(&value) && value.fract() <= 0.0 {
        push_number(out, value as u64);
    } else {
        out.extend_from_slice(value.to_string().as_bytes());
    }
}

/// `-62.6 N` and its like: a sign, a number, letters; nothing that a spreadsheet could run.
fn signed_quantity(text: &[u8]) -> bool {
    let [b'+' | b'-', rest @ ..] = text else { return false };
    let exponent = |i: usize| i > 0 && matches!(rest[i - 1], b'e' | b'E' | b'^');
    rest.first().is_some_and(|b| b.is_ascii_digit() || *b == b'.')
        && rest.iter().enumerate().all(|(i, b)| match b {
            b'.' | b',' | b' ' | b'/' | b'^' | b'%' => true,
            b'+' | b'-' => exponent(i),
            _ => b.is_ascii_alphanumeric() || !b.is_ascii(),
        })
}

/// A field of CSV: quoted where needed, and harmless to a spreadsheet: what begins with `= + - @` and is neither a number
/// nor a number with a unit gets an apostrophe in front.
pub(crate) fn push_text(out: &mut Vec<u8>, text: &[u8]) {
    let odd = matches!(text.first(), Some(b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r'));
    let number = || {
        plain_number(text).is_some()
            || std::str::from_utf8(text).is_ok_and(|t| t.parse::<f64>().is_ok_and(f64::is_finite))
    };
    let guard = odd && !number() && !signed_quantity(text);
    let space = |b: Option<&u8>| matches!(b, Some(b' '));
    let quote = text.iter().any(|b| matches!(b, b',' | b'"' | b'\n' | b'\r'))
        || space(text.first())
        || space(text.last());
    if quote {
        out.push(b'"');
    }
    if guard {
        out.push(b'\'');
    }
    if quote {
        for b in text {
            if *b == b'"' {
                out.push(b'"');
            }
            out.push(*b);
        }
        out.push(b'"');
    } else {
        out.extend_from_slice(text);
    }
}
