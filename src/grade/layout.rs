//! What stands where in a file of submissions, and which of its rows are answers.
use crate::answer::submissions::Header;
use crate::answer::submissions::Record;
use crate::answer::submissions::RecordFault;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::feedback::Feedback;
use crate::grade::table::KeyTable;
use crate::grade::table::joined;
use std::borrow::Cow;

/// A column of a wide file.
pub(crate) struct WideColumn {
    /// Index of the field.
    pub field: usize,
    /// Its header.
    pub header: String,
    /// Problem and part as written in it.
    pub problem: String,
    /// See `problem`.
    pub part: String,
    /// Which column of the table it is.
    pub column: Option<u32>,
    /// The header has more in it than the part.
    loose: bool,
}

pub(crate) enum Form {
    Long { problem: usize, part: usize, answer: usize },
    Wide(Vec<WideColumn>),
}

/// What stands where.
pub(crate) struct Layout {
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
    /// Where the answers stand.
    pub form: Form,
    /// Headers of fields that are not used.
    pub unused: Vec<String>,
}

fn plain_header(text: &str) -> String {
    text.trim().to_lowercase().replace([' ', '-'], "_")
}

/// The one known part that a header contains, as form services write it: `Problem 2: 2.omega`, `1.v (m/s)`. `None`: none, or
/// several.
fn contained(header: &str, table: &KeyTable) -> Option<(String, String, u32)> {
    let mut found: Option<(String, String, u32)> = None;
    let mut key = Vec::new();
    for token in header.split(|c: char| !(c.is_alphanumeric() || matches!(c, '.' | '_' | '-'))) {
        let Some((problem, part)) = token.trim_matches(['.', '-']).split_once('.') else { continue };
        joined(problem.as_bytes(), part.as_bytes(), &mut key);
        let Some(column) = table.column(&key) else { continue };
        if found.as_ref().is_some_and(|(_, _, other)| *other != column) {
            return None;
        }
        found = Some((problem.to_owned(), part.to_owned(), column));
    }
    found
}

/// Of several columns for one part that which names it best: told with --columns or with nothing but the part in its header;
/// or that whose whole header ends the others' (`Points - Problem 2: 2.omega` is about `Problem 2: 2.omega`).
fn the_best(wide: Vec<WideColumn>) -> Vec<WideColumn> {
    const REMARKS: [&str; 9] =
        ["comment", "remark", "feedback", "points", "score", "marks", "kommentar", "bemerkung", "punkte"];
    let remark = |text: &str| REMARKS.iter().any(|word| text.contains(word));
    let about = |one: &WideColumn, other: &WideColumn| {
        let (one_text, other_text) = (plain_header(&one.header), plain_header(&other.header));
        // `Comments on 2.v` beside `Q2 2.v`
        if one.loose && other.loose && one.column == other.column && remark(&one_text) && !remark(&other_text)
        {
            return true;
        }
        one.field != other.field
            && one.loose
            && one.column == other.column
            && (!other.loose || (one_text.len() > other_text.len() && one_text.ends_with(&other_text)))
    };
    let kept: Vec<bool> = wide.iter().map(|one| !wide.iter().any(|other| about(one, other))).collect();
    wide.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(one, _)| one).collect()
}

pub(crate) fn layout(
    header: Option<Header>,
    table: &KeyTable,
    columns: &[(String, String)],
) -> Result<Layout, Findings> {
    let Some(header) = header else {
        return Err(Finding::new("header", "the file is empty")
            .hint("the first line is `student,problem,part,answer`")
            .into());
    };
    let mut findings = Findings::default();
    // Lists that a finding has printed.
    let mut lists: Vec<String> = Vec::new();
    let mut listed = false;
    let mut columns_are = |more: Option<String>| {
        let mut shown = header.fields[..header.fields.len().min(30)].join(" | ");
        if header.fields.len() > 30 {
            shown.push_str(&format!(" | and {} more", header.fields.len() - 30));
        }
        let list = (!std::mem::replace(&mut listed, true)).then(|| format!("the columns are: {shown}"));
        list.into_iter().chain(more).collect::<Vec<String>>().join("; ")
    };
    const ROLES: [&str; 5] = ["student", "problem", "part", "answer", "submitted_at"];
    // `problem.part` stands for a column of a wide file
    let mut mapped_parts = Vec::new();
    for (role, wanted) in columns.iter().filter(|(role, _)| !ROLES.contains(&role.as_str())) {
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
            let said = table.unknown_part(problem, part, Feedback::english());
            // The list behind it is printed once.
            let said = match said.split_once(" parts: ").or_else(|| said.split_once(" problems: ")) {
                Some((before, list)) if lists.iter().any(|l| l == list) => {
                    before.trim_end_matches(';').to_owned()
                }
                Some((_, list)) => {
                    lists.push(list.to_owned());
                    said
                }
                None => said,
            };
            findings.push(Finding::new("--columns", said));
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
                loose: false,
            });
        } else {
            let said = match hits.len() {
                0 => format!("no column `{wanted}`"),
                n => format!("column `{wanted}` stands there {n} times"),
            };
            let fault = Finding::new("header", said).at(header.line as usize, 1);
            let hint = columns_are(None);
            findings.push(if hint.is_empty() { fault } else { fault.hint(hint) });
        }
    }
    let mut find = |role: &str, required: bool| -> Option<usize> {
        let mapped = columns.iter().find(|(r, _)| r == role).map(|(_, h)| h.as_str());
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
            let hint = columns_are(Some(format!("map one with --columns {role}=\"Its header\"")));
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
        if Some(field) == student || Some(field) == submitted {
            continue;
        }
        let (problem, part) = text.split_once('.').map_or(("", ""), |(a, b)| (a.trim(), b.trim()));
        let number = !problem.is_empty() && problem.bytes().all(|b| b.is_ascii_digit());
        let named = !part.is_empty() && (number || table.has_problem(problem));
        joined(problem.as_bytes(), part.as_bytes(), &mut key);
        let exact = if named { table.column(&key) } else { None };
        let inside = if exact.is_some() { None } else { contained(text, table) };
        let header = text.clone();
        if let Some((problem, part, column)) = inside {
            wide.push(WideColumn { field, header, problem, part, column: Some(column), loose: true });
        } else if named {
            let (problem, part) = (problem.to_owned(), part.to_owned());
            wide.push(WideColumn { field, header, problem, part, column: exact, loose: false });
        }
    }
    let told = !mapped_parts.is_empty();
    wide.append(&mut mapped_parts);
    wide.sort_by_key(|w| w.field);
    let wide = the_best(wide);
    let names_long = |role: &str| {
        columns.iter().any(|(r, _)| r == role) || header.fields.iter().any(|h| plain_header(h) == role)
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
                    .hint(format!(
                        "keep one column for each part, or say which it is: --columns {}.{}=\"Its header\"",
                        one.problem, one.part
                    )),
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

/// Why a record is one unreadable line, or that nothing stands in it.
pub(crate) enum Row {
    Cells,
    Empty,
    Unreadable(String),
}

pub(crate) fn sort_of_row(record: &Record, layout: &Layout, say: &Feedback) -> Row {
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
pub(crate) fn open_quote<'w>(line: u64, say: &Feedback<'w>) -> Cow<'w, str> {
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
