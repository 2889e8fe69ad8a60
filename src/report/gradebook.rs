//! Marks as CSV: a row for each student of the set, those who handed in nothing too.
use crate::grade::run::Graded;
use crate::grade::run::push_float;
use crate::grade::run::push_text;
use crate::grade::table::KeyTable;

/// gradebook.csv: student, name, a column for each `problem.part`, total, max_total. Parts not handed in are empty and
/// count nothing.
pub fn gradebook(table: &KeyTable, graded: &Graded) -> Vec<u8> {
    let mut out = b"student,name".to_vec();
    for column in &table.columns {
        out.push(b',');
        push_text(&mut out, format!("{}.{}", column.number, column.part).as_bytes());
    }
    out.extend_from_slice(b",total,max_total\n");
    for (s, student) in table.students.iter().enumerate() {
        push_text(&mut out, student.id.as_bytes());
        out.push(b',');
        push_text(&mut out, student.name.as_bytes());
        let (mut total, mut greatest) = (0.0, 0.0);
        for c in 0..table.columns.len() {
            out.push(b',');
            if let Some(points) = graded.points.get(s * table.columns.len() + c).copied().flatten() {
                push_float(&mut out, points);
                total += points;
            }
            greatest += table.entry(s, c).map_or(0.0, |e| e.points);
        }
        for sum in [total, greatest] {
            out.push(b',');
            push_float(&mut out, (sum * 1e9_f64).round() / 1e9); // 0.1 + 0.2 is shown as 0.3
        }
        out.push(b'\n');
    }
    out
}
