//! key.csv: one row for each part of each student, numbers in the asked unit.
use crate::csv_field::{push_line, unguarded};
use crate::finding::{Finding, Findings, FirstFindings};
use crate::key::{Answer, KeyEntry, ProblemKey, SheetKey};
use crate::problem::make_key;
use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};

/// The columns.
#[rustfmt::skip] // a table
pub const HEADER: [&str; 12] = [
    "student", "problem", "part", "value", "unit", "eom", "energy", "gap", "cond", "tolerance",
    "error_bound", "code",
];
/// Columns of a file that an earlier version wrote, which had no codes.
const WITHOUT_CODE: usize = 11;

/// Shortest text that reads back as the same double; an exponent only where it helps.
pub fn shortest(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if (1e-5..1e16).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

/// Three significant figures for columns that only describe.
fn about(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "inf".to_owned();
    }
    if (1e-3..1e6).contains(&value.abs()) {
        let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
        format!("{rounded}")
    } else {
        format!("{value:.2e}")
    }
}

/// The fields behind student and problem.
fn fields(entry: &KeyEntry) -> [String; 9] {
    let unit = &entry.unit;
    match &entry.answer {
        Answer::Number { value, half_width, .. } => {
            let text = shortest(unit.from_si(*value));
            // The roads mostly say the same double.
            let road = |si: Option<f64>| match si {
                Some(si) if si.to_bits() == value.to_bits() => text.clone(),
                Some(si) => shortest(unit.from_si(si)),
                None => String::new(),
            };
            let (eom, energy) = (road(entry.eom), road(entry.energy));
            [
                entry.part.clone(),
                text,
                unit.ascii().to_owned(),
                eom,
                energy,
                entry.gap.map_or_else(String::new, about),
                entry.cond.map_or_else(String::new, about),
                shortest(unit.from_si(*half_width)),
                entry.bound.map_or_else(String::new, |b| about(unit.from_si(b))),
            ]
        }
        Answer::Word { right, .. } => {
            let mut fields = [const { String::new() }; 9];
            entry.part.clone_into(&mut fields[0]);
            (*right).clone_into(&mut fields[1]);
            fields
        }
    }
}

/// All rows, header first.
pub fn rows(keys: &[SheetKey]) -> impl Iterator<Item = [String; 12]> {
    let header = std::iter::once(HEADER.map(str::to_owned));
    header.chain(keys.iter().flat_map(|key| {
        key.problems.iter().enumerate().flat_map(move |(i, problem)| {
            problem.parts.iter().map(move |entry| {
                let [part, value, unit, eom, energy, gap, cond, tolerance, bound] = fields(entry);
                let number = (i + 1).to_string();
                let (student, code) = (key.student.clone(), problem.code_of(entry).to_owned());
                [student, number, part, value, unit, eom, energy, gap, cond, tolerance, bound, code]
            })
        })
    }))
}

/// The text of key.csv.
pub fn text(keys: &[SheetKey]) -> Vec<u8> {
    with_columns(keys, HEADER.len())
}

/// Is a stored key.csv the text of these keys, as this version or an earlier one wrote it?
pub fn is_of(stored: &[u8], keys: &[SheetKey]) -> bool {
    let body = unmarked(stored);
    body == with_columns(keys, columns(body))
}

/// Has a stored key.csv, row by row, the right answers and tolerances of these keys, to the last bit, and their codes?
pub fn grades_as(stored: &[u8], keys: &[SheetKey]) -> bool {
    let mut reader = csv::Reader::from_reader(stored);
    let mut row = csv::StringRecord::new();
    let mut next = |student: &str, number: &str, problem: &ProblemKey, entry: &KeyEntry| {
        if !reader.read_record(&mut row).unwrap_or(false) || row.len() != HEADER.len() {
            return false;
        }
        let is = |at: usize, si: f64| {
            row[at].parse::<f64>().is_ok_and(|x| x.to_bits() == (entry.unit.from_si(si) + 0.0).to_bits())
        };
        let answered = match &entry.answer {
            Answer::Number { value, half_width, .. } => {
                let road = entry.eom.is_none_or(|eom| is(5, eom));
                is(3, *value) && is(9, *half_width) && road && row[4] == *entry.unit.ascii()
            }
            Answer::Word { right, .. } => row[3] == **right,
        };
        let names = [unguarded(&row[0]), &row[1], &row[2], &row[11]];
        answered && names == [student, number, &entry.part, problem.code_of(entry)]
    };
    let all = keys.iter().all(|key| {
        key.problems.iter().enumerate().all(|(i, problem)| {
            let number = (i + 1).to_string();
            problem.parts.iter().all(|entry| next(&key.student, &number, problem, entry))
        })
    });
    all && !reader.read_record(&mut row).unwrap_or(true)
}

/// Without the mark of its encoding that an editor may have put before it.
fn unmarked(stored: &[u8]) -> &[u8] {
    stored.strip_prefix(b"\xef\xbb\xbf").unwrap_or(stored)
}

/// How many columns a stored key.csv is to have.
fn columns(body: &[u8]) -> usize {
    let header = body.split(|b| matches!(b, b'\r' | b'\n')).next().unwrap_or_default();
    if header == HEADER[..WITHOUT_CODE].join(",").as_bytes() { WITHOUT_CODE } else { HEADER.len() }
}

fn with_columns(keys: &[SheetKey], columns: usize) -> Vec<u8> {
    // The header is the first row of each part, and stays in the first part alone.
    let part = |(i, keys): (usize, &[SheetKey])| {
        let mut out = Vec::new();
        for row in rows(keys).skip(usize::from(i > 0)) {
            push_line(&mut out, &row[..columns]);
        }
        out
    };
    let parts: Vec<Vec<u8>> = keys.par_chunks(512).enumerate().map(part).collect();
    if parts.is_empty() { part((0, &[])) } else { parts.concat() }
}

/// A later version may round otherwise in the last digits: a stored answer counts as the one that the stored data give if the
/// two differ by no more than this share.
const AS_STORED: f64 = 1e-9;

/// Takes right answers and tolerances from a stored key.csv, which was published, into keys that this version solved from the
/// stored data of a set drawn by an earlier one. Returns how many stored answers this version does not get from the data. A
/// file that is `sealed` (its hash stands in set.json) was not edited, so such answers are taken all the same; in another file
/// they are findings.
/// Errors: at most five findings and their number: rows that are missing, cells that cannot be read, answers that the stored data do not
/// give where no hash tells an edit from another way of solving.
pub fn put_stored(stored: &[u8], keys: &mut [SheetKey], sealed: bool) -> Result<usize, Findings> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(unmarked(stored));
    let mut rows: FxHashMap<(String, String, String), (usize, csv::StringRecord)> = FxHashMap::default();
    let mut findings = FirstFindings::default();
    let mut other = 0;
    for record in reader.records() {
        let Ok(record) = record else {
            findings.push(Finding::new("", "a record cannot be read"));
            continue;
        };
        let line = line(record.position());
        let cell = |i: usize| record.get(i).unwrap_or_default().to_owned();
        if rows.insert((cell(0), cell(1), cell(2)), (line, record.clone())).is_some() {
            let what = format!("{} {}.{} stands twice", cell(0), cell(1), cell(2));
            findings.push(Finding::new("", what).at(line, 1));
        }
    }
    for key in keys {
        for (i, problem) in key.problems.iter_mut().enumerate() {
            for entry in &mut problem.parts {
                let name = (key.student.clone(), (i + 1).to_string(), entry.part.clone());
                let Some((line, row)) = rows.get(&name) else {
                    findings.push(Finding::new("", format!("{} {}.{} is missing", name.0, name.1, name.2)));
                    continue;
                };
                match take(entry, row, sealed) {
                    Ok(same) => other += usize::from(!same),
                    Err(what) => {
                        let what = format!("{} {}.{}: {what}", name.0, name.1, name.2);
                        findings.push(Finding::new("", what).at(*line, 1));
                    }
                }
            }
        }
    }
    findings.told().into_result(other)
}

/// The line of a record in its file.
fn line(position: Option<&csv::Position>) -> usize {
    position.map_or(0, |p| usize::try_from(p.line()).unwrap_or(0))
}

/// One row into its entry, or what is wrong with it. Is it what the entry was, up to rounding?
fn take(entry: &mut KeyEntry, row: &csv::StringRecord, sealed: bool) -> Result<bool, String> {
    let mut same = true;
    let cell = |i: usize| row.get(i).unwrap_or_default();
    let now = fields(entry);
    let other = |i: usize| {
        let stored = cell(i);
        Err(format!("{} is `{stored}` here, `{}` from the stored data", HEADER[i], now[i - 2]))
    };
    if cell(4) != now[2] {
        return other(4);
    }
    match &mut entry.answer {
        Answer::Word { right, .. } => match make_key::WORDS.into_iter().find(|w| *w == cell(3)) {
            Some(word) if sealed || word == *right => {
                same &= word == *right;
                *right = word;
            }
            _ => return other(3),
        },
        Answer::Number { value, half_width, .. } => {
            for (i, number) in [(3, value), (9, half_width)] {
                // What is written as it would be now is the same double.
                if cell(i) == now[i - 2] {
                    continue;
                }
                let Some(read) = cell(i).parse::<f64>().ok().filter(|x| x.is_finite()) else {
                    return other(i);
                };
                let read = entry.unit.to_si(read);
                let near = (read - *number).abs() <= AS_STORED * read.abs().max(number.abs());
                if !sealed && !near {
                    return other(i);
                }
                same &= near;
                *number = read;
            }
        }
    }
    Ok(same)
}

/// Compares a stored key.csv with the key made anew. Rows of students who are not in `keys` are left over from an
/// `--add` that was cut off, and do not matter. At most five findings and their number.
pub fn compare(stored: &[u8], keys: &[SheetKey]) -> Findings {
    if is_of(stored, keys) {
        return Findings::default();
    }
    let known: FxHashSet<&str> = keys.iter().map(|k| k.student.as_str()).collect();
    let mut findings = FirstFindings::default();
    let body = unmarked(stored);
    let columns = columns(body);
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(body);
    let mut expected = rows(keys);
    for record in reader.byte_records() {
        let Ok(record) = record else {
            findings.push(Finding::new("", "a record cannot be read"));
            continue;
        };
        let line = line(record.position());
        let field = |i: usize| {
            let text = String::from_utf8_lossy(record.get(i).unwrap_or_default());
            unguarded(&text).to_owned()
        };
        let is_header = field(0) == HEADER[0];
        if !is_header && !known.contains(field(0).as_str()) {
            continue;
        }
        let Some(row) = expected.next() else {
            findings.push(Finding::new("", format!("a row too many, for {}", field(0))).at(line, 1));
            continue;
        };
        for (i, right) in row.iter().enumerate().take(columns) {
            if field(i) != *right {
                let what = format!(
                    "{} {}.{}: {} is `{}` here, `{right}` when made anew from the set",
                    row[0],
                    row[1],
                    row[2],
                    HEADER[i],
                    field(i)
                );
                findings.push(Finding::new("", what).at(line, 1));
                break;
            }
        }
    }
    let missing = expected.count();
    if missing > 0 {
        findings.push(Finding::new("", format!("{missing} rows are missing at the end")));
    }
    findings.told()
}
