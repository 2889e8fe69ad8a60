//! gradebook.csv of a grading, read back: points of each student as they were given, and totals.
use crate::csv_field::unguarded;
use crate::finding::Finding;
use crate::grade::row::{in_line, no_column, no_csv};
use std::io::Read;

/// A row of gradebook.csv.
#[derive(Debug, Clone, PartialEq)]
pub struct BookRow {
    /// Line of the file.
    pub line: u64,
    /// Id of the student.
    pub student: String,
    /// Points of the parts that were asked for; `None` where nothing was given or there is no such part.
    pub points: Vec<Option<f64>>,
    pub total: Option<f64>,
    pub of: Option<f64>,
    /// Numbers of the problems that do not count.
    pub dropped: Vec<usize>,
}

/// Reads the points of parts (`1.omega`), row after row. May a part be missing? Errors: it is no gradebook, or `see` finds a
/// fault.
pub fn each_row(
    source: impl Read,
    parts: &[String],
    may_lack: bool,
    see: &mut dyn FnMut(BookRow) -> Result<(), Finding>,
) -> Result<(), Finding> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(source);
    let header = reader.byte_headers().map_err(no_csv)?.clone();
    let at = |name: &str| {
        let named = |field: &[u8]| unguarded(&String::from_utf8_lossy(field)) == name;
        header.iter().position(named)
    };
    let need = |name: &str| at(name).ok_or_else(|| no_column(name));
    let (student, total, of, dropped) = (need("student")?, need("total")?, need("max_total")?, at("dropped"));
    let column = |part: &String| if may_lack { Ok(at(part)) } else { need(part).map(Some) };
    let columns = parts.iter().map(column).collect::<Result<Vec<_>, _>>()?;
    for record in reader.byte_records() {
        let record = record.map_err(no_csv)?;
        let line = record.position().map_or(0, csv::Position::line);
        let text = |i: usize| String::from_utf8_lossy(record.get(i).unwrap_or_default());
        let number = |i: usize| match &*text(i) {
            "" => Ok(None),
            text => match text.parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(Some(value)),
                _ => Err(in_line(line, format!("`{text}` is no number of points"))),
            },
        };
        let dropped = dropped.map(text).unwrap_or_default();
        see(BookRow {
            line,
            student: unguarded(&text(student)).to_owned(),
            points: columns.iter().map(|c| c.map_or(Ok(None), number)).collect::<Result<_, _>>()?,
            total: number(total)?,
            of: number(of)?,
            dropped: dropped.split(' ').filter_map(|n| n.parse().ok()).collect(),
        })?;
    }
    Ok(())
}
