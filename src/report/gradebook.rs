//! Marks as CSV: a row for each student of the set, those who handed in nothing too.
use crate::csv_field::push_text;
use crate::grade::row::push_points;
use crate::grade::run::Graded;
use crate::grade::table::KeyTable;
use crate::policy::{Policy, Total, plain};

/// A student's total over the problems, by the settings of the course.
pub fn total(table: &KeyTable, points: &[Option<f64>], student: usize, policy: &Policy) -> Total {
    let mut problems: Vec<(usize, f64, f64)> = Vec::new();
    for (c, column) in table.columns.iter().enumerate() {
        let earned = points.get(student * table.columns.len() + c).copied().flatten().unwrap_or(0.0);
        let possible = table.entry(student, c).map_or(0.0, |e| e.points);
        match problems.last_mut() {
            Some((number, have, of)) if *number == column.number => {
                *have += earned;
                *of += possible;
            }
            _ => problems.push((column.number, earned, possible)),
        }
    }
    let sums: Vec<(f64, f64)> = problems.iter().map(|(_, have, of)| (*have, *of)).collect();
    let mut total = policy.total(&sums);
    // As numbers on the sheet.
    for dropped in &mut total.dropped {
        *dropped = problems[*dropped].0;
    }
    total
}

/// gradebook.csv: student, name, a column for each `problem.part`, total, max_total; where the course drops the lowest
/// problems also which ones. Parts not handed in are empty and count nothing.
pub fn gradebook(table: &KeyTable, graded: &Graded, policy: &Policy) -> Vec<u8> {
    let mut out = b"student,name".to_vec();
    for column in &table.columns {
        out.push(b',');
        push_text(&mut out, column.label().as_bytes());
    }
    out.extend_from_slice(b",total,max_total");
    let drops = policy.drop_lowest > 0;
    out.extend_from_slice(if drops { b",dropped\n" } else { b"\n" });
    for (s, student) in table.students.iter().enumerate() {
        push_text(&mut out, student.id.as_bytes());
        out.push(b',');
        push_text(&mut out, student.name.as_bytes());
        for c in 0..table.columns.len() {
            out.push(b',');
            if let Some(points) = graded.points.get(s * table.columns.len() + c).copied().flatten() {
                push_points(&mut out, plain(points));
            }
        }
        let total = total(table, &graded.points, s, policy);
        for sum in [total.points, total.of] {
            out.push(b',');
            push_points(&mut out, sum);
        }
        if drops {
            out.push(b',');
            let numbers: Vec<String> = total.dropped.iter().map(usize::to_string).collect();
            out.extend_from_slice(numbers.join(" ").as_bytes());
        }
        out.push(b'\n');
    }
    out
}
