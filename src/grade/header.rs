//! The header of a file of submissions to its layout: which fields are students, times and answers.
use crate::answer::submissions::Header;
use crate::finding::{Finding, Findings};
use crate::grade::feedback::Feedback;
use crate::grade::layout::{FileForm, FileLayout, WideColumn};
use crate::grade::run::{Options, QUIZ_COLUMNS};
use crate::grade::table::{KeyTable, joined};

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
fn best_of_each_part(wide: Vec<WideColumn>) -> Vec<WideColumn> {
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

/// Columns with a name of their own; any other that is told stands for a part.
const ROLES: [&str; 5] = ["student", "problem", "part", "answer", "submitted_at"];

/// What stands where, by the header and what the command says of columns (role and header). Errors: all that is wrong with both.
pub(crate) fn layout(
    header: Option<Header>,
    table: &KeyTable,
    options: &Options,
) -> Result<FileLayout, Findings> {
    let columns = &options.columns[..];
    let Some(header) = header else {
        return Err(Finding::new("header", "the file is empty")
            .hint("the first line is `student,problem,part,answer`")
            .into());
    };
    let (findings, lists) = (Findings::default(), Vec::new());
    let mut reader = HeaderReader { header: &header, table, columns, findings, lists, listed: false };
    let told = reader.told_parts();
    let student = reader.find("student", true);
    let submitted = reader.find("submitted_at", false);
    let form = reader.form(told, [student, submitted]);
    let (Some(student), Some(form), true) = (student, form, reader.findings.is_empty()) else {
        return Err(reader.findings);
    };
    let mut answers: Vec<usize> = match &form {
        FileForm::Long { problem, part, answer } => vec![*problem, *part, *answer],
        FileForm::Wide(all) => all.iter().map(|w| w.field).collect(),
    };
    answers.push(student);
    let named = |name: &str| header.fields.iter().position(|h| h == name).filter(|_| options.quiz);
    let [told_line, code] = [QUIZ_COLUMNS[0], QUIZ_COLUMNS[1]].map(named);
    let fields = header.fields.iter().enumerate();
    let unused =
        fields.filter(|(i, _)| !answers.contains(i) && ![submitted, told_line, code].contains(&Some(*i)));
    Ok(FileLayout {
        width: header.fields.len(),
        least: answers.iter().max().map_or(1, |last| last + 1),
        delimiter: header.delimiter,
        student,
        submitted,
        told_line,
        code,
        unused: unused.map(|(_, field)| field.clone()).collect(),
        form,
    })
}

/// A header while it is read.
struct HeaderReader<'h> {
    header: &'h Header,
    table: &'h KeyTable,
    columns: &'h [(String, String)],
    findings: Findings,
    /// Lists of parts and problems that a finding has printed.
    lists: Vec<String>,
    /// Were the columns listed?
    listed: bool,
}

impl HeaderReader<'_> {
    /// The columns of the file, once; and what more there is to say.
    fn columns_are(&mut self, more: Option<String>) -> String {
        let fields = &self.header.fields;
        let mut shown = fields[..fields.len().min(30)].join(" | ");
        if fields.len() > 30 {
            shown.push_str(&format!(" | and {} more", fields.len() - 30));
        }
        let list = (!std::mem::replace(&mut self.listed, true)).then(|| format!("the columns are: {shown}"));
        list.into_iter().chain(more).collect::<Vec<String>>().join("; ")
    }

    fn fault(&mut self, what: String, hint: String) {
        let fault = Finding::new("header", what).at(self.header.line as usize, 1);
        self.findings.push(if hint.is_empty() { fault } else { fault.hint(hint) });
    }

    /// Fields of this header, blanks and case aside.
    fn like(&self, wanted: &str) -> Vec<usize> {
        let wanted = plain_header(wanted);
        let fields = self.header.fields.iter().enumerate();
        fields.filter(|(_, field)| plain_header(field) == wanted).map(|(i, _)| i).collect()
    }

    /// Columns of a wide file that the command says: `problem.part`.
    fn told_parts(&mut self) -> Vec<WideColumn> {
        let mut told = Vec::new();
        for (role, wanted) in self.columns.iter().filter(|(role, _)| !ROLES.contains(&role.as_str())) {
            let named = role.split_once('.').filter(|(problem, _)| self.table.has_problem(problem.trim()));
            let Some((problem, part)) = named else {
                let fault = Finding::new("--columns", format!("unknown column `{role}`"));
                let hint = format!("one of {}, or a part such as 1.omega", ROLES.join(", "));
                self.findings.push(fault.hint(hint));
                continue;
            };
            let (problem, part) = (problem.trim(), part.trim());
            let column = self.column(problem, part);
            if column.is_none() {
                self.unknown_part(problem, part);
            }
            let fields = &self.header.fields;
            let mut hits: Vec<usize> = (0..fields.len()).filter(|i| fields[*i] == *wanted).collect();
            if hits.is_empty() {
                hits = self.like(wanted);
            }
            if let [field] = hits[..] {
                let (header, problem, part) = (fields[field].clone(), problem.to_owned(), part.to_owned());
                told.push(WideColumn { field, header, problem, part, column, loose: false });
                continue;
            }
            let what = match hits.len() {
                0 => format!("no column `{wanted}`"),
                n => format!("column `{wanted}` stands there {n} times"),
            };
            let hint = self.columns_are(None);
            self.fault(what, hint);
        }
        told
    }

    fn column(&self, problem: &str, part: &str) -> Option<u32> {
        let mut key = Vec::new();
        joined(problem.as_bytes(), part.as_bytes(), &mut key);
        self.table.column(&key)
    }

    /// A part that is told and not on the sheet; the list of those that are is printed once.
    fn unknown_part(&mut self, problem: &str, part: &str) {
        let mut said = self.table.unknown_part(problem, part, Feedback::english());
        if let Some((before, list)) = said.split_once(" parts: ").or_else(|| said.split_once(" problems: ")) {
            if self.lists.iter().any(|l| l == list) {
                said = before.trim_end_matches(';').to_owned();
            } else {
                self.lists.push(list.to_owned());
            }
        }
        self.findings.push(Finding::new("--columns", said));
    }

    /// The field of a role, by the header that the command says or by its own name.
    fn find(&mut self, role: &str, required: bool) -> Option<usize> {
        let told = self.columns.iter().find(|(r, _)| r == role).map(|(_, h)| h.as_str());
        let exact = told.and_then(|told| self.header.fields.iter().position(|h| h == told.trim()));
        let mut hits = exact.map_or_else(|| self.like(told.unwrap_or(role)), |at| vec![at]);
        if hits.is_empty() && role == "submitted_at" && told.is_none() {
            hits = self.like("timestamp");
        }
        if hits.len() > 1 {
            let at: Vec<String> = hits.iter().map(|i| (i + 1).to_string()).collect();
            let wanted = plain_header(told.unwrap_or(role));
            let what =
                format!("column `{wanted}` stands there {} times (fields {})", hits.len(), at.join(", "));
            self.fault(what, "rename all but one".to_owned());
        } else if hits.is_empty() && (required || told.is_some()) {
            let hint = self.columns_are(Some(format!("map one with --columns {role}=\"Its header\"")));
            self.fault(format!("no column `{}`", told.unwrap_or(role)), hint);
        }
        hits.first().copied()
    }

    /// Columns whose headers name a part, such as `1.omega`, beside those that are told.
    fn wide_columns(&self, told: Vec<WideColumn>, others: [Option<usize>; 2]) -> Vec<WideColumn> {
        let mut wide = Vec::new();
        for (field, text) in self.header.fields.iter().enumerate() {
            if told.iter().any(|w| w.field == field) || others.contains(&Some(field)) {
                continue;
            }
            let (problem, part) = text.split_once('.').map_or(("", ""), |(a, b)| (a.trim(), b.trim()));
            let number = !problem.is_empty() && problem.bytes().all(|b| b.is_ascii_digit());
            let named = !part.is_empty() && (number || self.table.has_problem(problem));
            let exact = if named { self.column(problem, part) } else { None };
            let inside = if exact.is_some() { None } else { contained(text, self.table) };
            let header = text.clone();
            if let Some((problem, part, column)) = inside {
                wide.push(WideColumn { field, header, problem, part, column: Some(column), loose: true });
            } else if named {
                let (problem, part) = (problem.to_owned(), part.to_owned());
                wide.push(WideColumn { field, header, problem, part, column: exact, loose: false });
            }
        }
        wide.extend(told);
        wide.sort_by_key(|w| w.field);
        best_of_each_part(wide)
    }

    /// Long or wide; `others` are the fields of the student and the time.
    fn form(&mut self, told: Vec<WideColumn>, others: [Option<usize>; 2]) -> Option<FileForm> {
        let any_told = !told.is_empty();
        let wide = self.wide_columns(told, others);
        let names_long =
            |role: &str| self.columns.iter().any(|(r, _)| r == role) || !self.like(role).is_empty();
        if any_told || !wide.is_empty() && !["problem", "part", "answer"].into_iter().all(names_long) {
            for (i, one) in wide.iter().enumerate() {
                if wide[..i].iter().any(|w| w.column.is_some() && w.column == one.column) {
                    let WideColumn { header, problem, part, .. } = one;
                    self.fault(
                        format!("column `{header}` asks for a part that stands there already"),
                        format!(
                            "keep one column for each part, or say which it is: --columns {problem}.{part}=\"Its header\""
                        ),
                    );
                }
            }
            return Some(FileForm::Wide(wide));
        }
        let [problem, part, answer] = ["problem", "part", "answer"].map(|role| self.find(role, true));
        Some(FileForm::Long { problem: problem?, part: part?, answer: answer? })
    }
}
