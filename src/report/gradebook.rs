//! Marks as CSV: a row for each student of the set, those who handed in nothing too.
use crate::csv_field::push_line;
use crate::grade::row::in_points;
use crate::grade::run::Graded;
use crate::grade::table::{Column, KeyTable};
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
    let mut out = Vec::new();
    let mut line = |student: &str, name: &str, points: Vec<String>, sums: [String; 2], dropped: String| {
        let dropped = (policy.drop_lowest > 0).then_some(dropped);
        let who = [student.to_owned(), name.to_owned()];
        push_line(&mut out, who.into_iter().chain(points).chain(sums).chain(dropped));
    };
    let labels = table.columns.iter().map(Column::label).collect();
    line("student", "name", labels, ["total", "max_total"].map(str::to_owned), "dropped".to_owned());
    for (s, student) in table.students.iter().enumerate() {
        let points = |c: usize| graded.points.get(s * table.columns.len() + c).copied().flatten();
        let points =
            (0..table.columns.len()).map(|c| points(c).map_or_else(String::new, |p| in_points(plain(p))));
        let total = total(table, &graded.points, s, policy);
        let dropped: Vec<String> = total.dropped.iter().map(usize::to_string).collect();
        let sums = [total.points, total.of].map(in_points);
        line(&student.id, &student.name, points.collect(), sums, dropped.join(" "));
    }
    out
}
