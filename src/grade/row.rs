//! answers.csv: its columns, and one row of it as it is written and as it is read. No other place knows either.
//!
//! The csv crate reads. Fields are written by [`crate::csv_field`], which also keeps a spreadsheet from running them.
use crate::csv_field::{push_text, unguarded};
use crate::finding::Finding;
use crate::grade::verdict::Verdict;
use std::borrow::Cow;
use std::io::{Read, Write as _};

/// The columns in the order in which they are written.
#[rustfmt::skip] // a table
pub const COLUMNS: [&str; 14] = [
    "line", "column", "student", "problem", "part", "answer", "verdict", "points", "max_points", "reason",
    "methods", "slip", "credit", "submitted_at",
];
/// So many have always been there; gradings of the first versions have no others.
const NEEDED: usize = 10;

/// In the column `credit`, before its code: the answer was given to another variant than the one that counts.
pub const OF_ANOTHER: &str = "variant:";

/// One row: an answer cell and what became of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AnswerRow<'r> {
    /// Line of the file of submissions.
    pub line: u64,
    /// Header of the column, where a record has several answers.
    pub column: Cow<'r, str>,
    /// Student as handed in; if known, as on the roster.
    pub student: Cow<'r, str>,
    /// Number of the problem, or what was handed in for it.
    pub problem: Cow<'r, str>,
    pub part: Cow<'r, str>,
    /// The cell as handed in.
    pub answer: Cow<'r, str>,
    pub verdict: Verdict,
    /// Points after credit, penalties and lateness.
    pub points: f64,
    /// Most points of the part.
    pub max_points: f64,
    /// Why.
    pub reason: Cow<'r, str>,
    /// Ids of wrong methods that fit, separated by blanks, the nearest first.
    pub methods: Cow<'r, str>,
    /// `power_of_ten:3` and its like.
    pub slip: Cow<'r, str>,
    /// Why the points are not all or nothing, words separated by blanks.
    pub credit: Cow<'r, str>,
    /// When, as handed in.
    pub submitted_at: Cow<'r, str>,
}

impl AnswerRow<'_> {
    /// Does it belong to a student and a part of the set?
    pub fn is_known(&self) -> bool {
        !matches!(self.verdict, Verdict::UnknownStudent | Verdict::UnknownPart)
    }
    /// Is it the attempt that counts?
    pub fn counts(&self) -> bool {
        self.is_known() && !matches!(self.verdict, Verdict::Superseded | Verdict::Blank)
    }
    /// What explains a wrong answer without help from others: methods and slip, separated by blanks.
    pub fn explained(&self) -> String {
        [&*self.methods, &*self.slip].join(" ").trim().to_owned()
    }
    /// The row with texts of its own.
    pub fn into_owned(self) -> AnswerRow<'static> {
        let own = |text: Cow<str>| Cow::Owned(text.into_owned());
        AnswerRow {
            line: self.line,
            column: own(self.column),
            student: own(self.student),
            problem: own(self.problem),
            part: own(self.part),
            answer: own(self.answer),
            verdict: self.verdict,
            points: self.points,
            max_points: self.max_points,
            reason: own(self.reason),
            methods: own(self.methods),
            slip: own(self.slip),
            credit: own(self.credit),
            submitted_at: own(self.submitted_at),
        }
    }
    /// Appends it as a line.
    pub fn write(&self, out: &mut Vec<u8>) {
        let texts = |out: &mut Vec<u8>, texts: [&str; 5]| {
            for text in texts {
                out.push(b',');
                push_text(out, text.as_bytes());
            }
        };
        push_number(out, self.line);
        texts(out, [&self.column, &self.student, &self.problem, &self.part, &self.answer]);
        out.push(b',');
        out.extend_from_slice(self.verdict.as_str().as_bytes());
        for points in [self.points, self.max_points] {
            // Writing to a vector does not fail.
            let _ = write!(out, ",{}", points + 0.0);
        }
        texts(out, [&self.reason, &self.methods, &self.slip, &self.credit, &self.submitted_at]);
        out.push(b'\n');
    }
}

/// Appends a whole number.
pub(crate) fn push_number(out: &mut Vec<u8>, mut number: u64) {
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

/// Points as they are written: whole ones without a point, none without a sign.
pub(crate) fn in_points(points: f64) -> String {
    (points + 0.0).to_string()
}

/// Stands in a row for a text that changes from line to line.
pub(crate) const HOLE: &str = "\u{1}";

/// A row with holes: line, student, answer, a number in the reason and the time. What stands between them is written once for
/// many lines.
#[derive(Debug)]
pub(crate) struct RowPattern {
    between: [Vec<u8>; 5],
}

impl RowPattern {
    /// Of a row with [`HOLE`] at those places and line 0; `None` where there are more or fewer.
    pub fn of(row: &AnswerRow) -> Option<RowPattern> {
        let mut text = Vec::new();
        row.write(&mut text);
        let text = text.strip_prefix(b"0")?;
        let pieces: Vec<Vec<u8>> = text.split(|b| *b == HOLE.as_bytes()[0]).map(<[u8]>::to_vec).collect();
        Some(RowPattern { between: pieces.try_into().ok()? })
    }
    /// Appends a line; `student` needs neither quotes nor an apostrophe in front.
    #[inline]
    pub fn write(&self, out: &mut Vec<u8>, line: u64, [student, answer, time]: [&[u8]; 3], number: u64) {
        let [a, b, c, d, end] = &self.between;
        push_number(out, line);
        out.extend_from_slice(a);
        out.extend_from_slice(student);
        out.extend_from_slice(b);
        push_text(out, answer);
        out.extend_from_slice(c);
        push_number(out, number);
        out.extend_from_slice(d);
        push_text(out, time);
        out.extend_from_slice(end);
    }
}

/// What is wrong in a line of a file of answers or a gradebook.
pub(crate) fn in_line(line: u64, what: impl Into<String>) -> Finding {
    Finding::new("", what).at(usize::try_from(line).unwrap_or(usize::MAX), 1)
}

/// What is wrong with such a file as CSV.
pub(crate) fn no_csv(error: csv::Error) -> Finding {
    let what = error.to_string();
    error
        .position()
        .map(csv::Position::line)
        .map_or_else(|| Finding::new("", &*what), |at| in_line(at, &*what))
}

/// The header of such a file lacks a column.
pub(crate) fn no_column(name: &str) -> Finding {
    in_line(1, format!("there is no column `{name}`"))
}

/// Reads rows in a stream.
pub struct AnswerReader<R> {
    reader: csv::Reader<R>,
    at: [Option<usize>; COLUMNS.len()],
    record: csv::ByteRecord,
}

impl<R: Read> AnswerReader<R> {
    /// Begins with the header. Errors: it lacks a column.
    pub fn new(source: R) -> Result<Self, Finding> {
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(source);
        let header = reader.byte_headers().map_err(no_csv)?;
        let at = COLUMNS.map(|name| header.iter().position(|f| f == name.as_bytes()));
        match at[..NEEDED].iter().position(Option::is_none) {
            None => Ok(Self { reader, at, record: csv::ByteRecord::new() }),
            Some(i) => Err(no_column(COLUMNS[i])),
        }
    }

    /// The next row; `None` at the end. Errors: it is none.
    pub fn next_row(&mut self) -> Result<Option<AnswerRow<'_>>, Finding> {
        if !self.reader.read_byte_record(&mut self.record).map_err(no_csv)? {
            return Ok(None);
        }
        let line = self.record.position().map_or(0, csv::Position::line);
        let (record, at) = (&self.record, &self.at);
        let text = |i: usize| String::from_utf8_lossy(at[i].and_then(|c| record.get(c)).unwrap_or_default());
        let verdict = text(6);
        let Some(verdict) = Verdict::of_word(&verdict) else {
            return Err(in_line(line, format!("`{verdict}` is no verdict")));
        };
        let number = |i: usize| {
            let text = text(i);
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            value.ok_or_else(|| in_line(line, format!("{}: `{text}` is no number", COLUMNS[i])))
        };
        let plain = |i: usize| match text(i) {
            Cow::Borrowed(text) => Cow::Borrowed(unguarded(text)),
            Cow::Owned(text) => Cow::Owned(unguarded(&text).to_owned()),
        };
        Ok(Some(AnswerRow {
            line: text(0).parse().unwrap_or(0),
            column: plain(1),
            student: plain(2),
            problem: plain(3),
            part: plain(4),
            answer: plain(5),
            verdict,
            points: number(7)?,
            max_points: number(8)?,
            reason: text(9),
            methods: text(10),
            slip: text(11),
            credit: text(12),
            submitted_at: plain(13),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(columns: usize) -> String {
        COLUMNS[..columns].join(",")
    }
    fn rows(text: &str) -> Result<Vec<AnswerRow<'static>>, Finding> {
        let mut reader = AnswerReader::new(text.as_bytes())?;
        let mut rows = Vec::new();
        while let Some(row) = reader.next_row()? {
            rows.push(row.into_owned());
        }
        Ok(rows)
    }

    #[test]
    fn rows_of_both_versions() {
        let line = "7,,a,1,v,'=1+1,wrong,0.5,2,\"outside, far\",A05 A06,drift,methods late:0.8,3/4/2026\n"
            .to_owned();
        let read = rows(&format!("{}\n{line}", head(14))).unwrap();
        assert_eq!((&*read[0].answer, read[0].verdict, read[0].line), ("=1+1", Verdict::Wrong, 7));
        assert_eq!(read[0].explained(), "A05 A06 drift");
        let mut written = Vec::new();
        read[0].write(&mut written);
        assert_eq!(String::from_utf8(written).unwrap(), line);
        let read = rows(&format!("{}\n7,,a,1,v,3,right,2,2,within\n", head(NEEDED))).unwrap();
        assert_eq!((&*read[0].credit, read[0].counts()), ("", true));
    }

    #[test]
    fn a_pattern_writes_what_its_row_would() {
        let row = |line, student, answer, reason, submitted_at| AnswerRow {
            line,
            column: "1.v".into(),
            student,
            problem: "1".into(),
            part: "v".into(),
            answer,
            verdict: Verdict::Superseded,
            max_points: 2.5,
            reason,
            submitted_at,
            ..AnswerRow::default()
        };
        let hole = || Cow::Borrowed(HOLE);
        let pattern =
            RowPattern::of(&row(0, hole(), hole(), format!("by {HOLE}, so").into(), hole())).unwrap();
        for (answer, time) in [("3", ""), ("=2,5 m", "1/2/26, 10:00"), (" 4 ", "\"x\"")] {
            let (mut quick, mut whole) = (Vec::new(), Vec::new());
            pattern.write(&mut quick, 12, [b"ab", answer.as_bytes(), time.as_bytes()], 40);
            row(12, "ab".into(), answer.into(), "by 40, so".into(), time.into()).write(&mut whole);
            assert_eq!(String::from_utf8(quick), String::from_utf8(whole));
        }
        assert!(RowPattern::of(&row(0, hole(), hole(), "by nobody".into(), hole())).is_none());
    }

    #[test]
    fn faults_name_line_and_field() {
        let row =
            |verdict: &str, points: &str| format!("{}\n7,,a,1,v,3,{verdict},{points},2,x\n", head(NEEDED));
        assert_eq!(rows(&row("great", "1")).unwrap_err(), in_line(2, "`great` is no verdict"));
        assert_eq!(rows(&row("right", "NaN")).unwrap_err().message, "points: `NaN` is no number");
        assert_eq!(rows("student,verdict\n").unwrap_err().message, "there is no column `line`");
    }
}
