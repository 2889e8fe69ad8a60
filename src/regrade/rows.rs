//! answers.csv of a grading, row by row.
use crate::grade::verdict::Verdict;
use crate::guard::unguarded;
use std::io::Read;

/// One row: an answer cell and what became of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Line of the file of submissions.
    pub line: u64,
    /// Header of the column, where a record has several answers.
    pub column: String,
    /// Student as handed in.
    pub student: String,
    /// Number of the problem, or what was handed in for it.
    pub problem: String,
    /// Part.
    pub part: String,
    /// The cell as handed in.
    pub answer: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Points after credit, penalties and lateness.
    pub points: f64,
    /// Most points of the part.
    pub max_points: f64,
    /// Why.
    pub reason: String,
    /// Ids of wrong methods that fit, separated by blanks.
    pub methods: String,
    /// `power_of_ten:3` and its like.
    pub slip: String,
    /// Why the points are not all or nothing, words separated by blanks.
    pub credit: String,
    /// When, as handed in.
    pub submitted_at: String,
}

impl Row {
    /// Does it belong to a student and a part of the set?
    pub fn is_known(&self) -> bool {
        !matches!(self.verdict, Verdict::UnknownStudent | Verdict::UnknownPart)
    }
    /// Is it the attempt that counts?
    pub fn counts(&self) -> bool {
        self.is_known() && !matches!(self.verdict, Verdict::Superseded | Verdict::Blank)
    }
    /// Which answer it is: its line and column.
    pub fn place(&self) -> (u64, &str) {
        (self.line, &self.column)
    }
    /// What explains a wrong answer without help from others: methods and slip, separated by blanks.
    pub fn explained(&self) -> String {
        [self.methods.as_str(), self.slip.as_str()].join(" ").trim().to_owned()
    }
}

/// What is wrong with a file of answers, and in which line (0: unknown).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Line, from 1.
    pub line: u64,
    /// What is wrong.
    pub what: String,
}

/// The names of the columns; the last three are missing in gradings of earlier versions.
const COLUMNS: [&str; 14] = [
    "line",
    "column",
    "student",
    "problem",
    "part",
    "answer",
    "verdict",
    "points",
    "max_points",
    "reason",
    "methods",
    "slip",
    "credit",
    "submitted_at",
];
const NEEDED: usize = 10;

/// Reads rows in a stream.
pub struct Rows<R> {
    reader: csv::Reader<R>,
    at: [Option<usize>; COLUMNS.len()],
    record: csv::ByteRecord,
}

impl<R: Read> Rows<R> {
    /// Begins with the header.
    ///
    /// # Errors
    /// It lacks a column.
    pub fn new(source: R) -> Result<Self, Fault> {
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(source);
        let header = reader.byte_headers().map_err(|e| fault(&e))?;
        let at = COLUMNS.map(|name| header.iter().position(|f| f == name.as_bytes()));
        match at[..NEEDED].iter().position(Option::is_none) {
            None => Ok(Self { reader, at, record: csv::ByteRecord::new() }),
            Some(i) => Err(Fault { line: 1, what: format!("there is no column `{}`", COLUMNS[i]) }),
        }
    }

    fn next_row(&mut self) -> Result<Option<Row>, Fault> {
        if !self.reader.read_byte_record(&mut self.record).map_err(|e| fault(&e))? {
            return Ok(None);
        }
        let line = self.record.position().map_or(0, csv::Position::line);
        let text = |i: usize| {
            let bytes = self.at[i].and_then(|c| self.record.get(c)).unwrap_or_default();
            String::from_utf8_lossy(bytes).into_owned()
        };
        let verdict = text(6);
        let Some(verdict) = Verdict::ALL.iter().copied().find(|v| v.as_str() == verdict) else {
            return Err(Fault { line, what: format!("`{verdict}` is no verdict") });
        };
        let number = |i: usize| {
            let text = text(i);
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            value.ok_or_else(|| Fault { line, what: format!("{}: `{text}` is no number", COLUMNS[i]) })
        };
        let plain = |text: String| unguarded(&text).to_owned();
        Ok(Some(Row {
            line: text(0).parse().unwrap_or(0),
            column: plain(text(1)),
            student: plain(text(2)),
            problem: plain(text(3)),
            part: plain(text(4)),
            answer: plain(text(5)),
            verdict,
            points: number(7)?,
            max_points: number(8)?,
            reason: text(9),
            methods: text(10),
            slip: text(11),
            credit: text(12),
            submitted_at: plain(text(13)),
        }))
    }
}

impl<R: Read> Iterator for Rows<R> {
    type Item = Result<Row, Fault>;
    fn next(&mut self) -> Option<Self::Item> {
        self.next_row().transpose()
    }
}

fn fault(error: &csv::Error) -> Fault {
    Fault { line: error.position().map_or(0, csv::Position::line), what: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "line,column,student,problem,part,answer,verdict,points,max_points,reason";

    #[test]
    fn rows_of_both_versions() {
        let text = format!(
            "{HEAD},methods,slip,credit,submitted_at\n7,,a,1,v,'=1+1,wrong,0.5,2,outside,A05 A06,drift,methods late:0.8,3/4/2026\n"
        );
        let rows: Vec<_> = Rows::new(text.as_bytes()).unwrap().collect::<Result<_, _>>().unwrap();
        assert_eq!((rows[0].answer.as_str(), rows[0].verdict, rows[0].line), ("=1+1", Verdict::Wrong, 7));
        assert_eq!(rows[0].explained(), "A05 A06 drift");
        let text = format!("{HEAD}\n7,,a,1,v,3,right,2,2,within\n");
        let rows: Vec<_> = Rows::new(text.as_bytes()).unwrap().collect::<Result<_, _>>().unwrap();
        assert_eq!((rows[0].credit.as_str(), rows[0].counts()), ("", true));
    }

    #[test]
    fn faults_name_line_and_field() {
        let first = |text: &str| match Rows::new(text.as_bytes()) {
            Ok(rows) => rows.collect::<Result<Vec<_>, _>>().unwrap_err(),
            Err(fault) => fault,
        };
        let row = |verdict: &str, points: &str| format!("{HEAD}\n7,,a,1,v,3,{verdict},{points},2,x\n");
        assert_eq!(first(&row("great", "1")), Fault { line: 2, what: "`great` is no verdict".to_owned() });
        assert_eq!(first(&row("right", "NaN")).what, "points: `NaN` is no number");
        assert_eq!(first("student,verdict\n").what, "there is no column `line`");
    }
}
