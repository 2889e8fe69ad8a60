//! What a grading came to, for the terminal: verdicts, a row for each part, what is odd about the submissions.
use crate::grade::run;
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;
use crate::policy::{Policy, Unread};
use crate::sheet::terminal;

/// Verdicts, a row for each part, and what is odd about the submissions.
pub fn grades(table: &KeyTable, graded: &run::Graded, policy: &Policy) -> String {
    let form = if graded.wide { "wide" } else { "long" };
    let verdicts = Verdict::ALL.iter().map(|verdict| (graded.count(*verdict), verdict));
    let verdicts = verdicts.filter(|(n, _)| *n > 0).map(|(n, verdict)| format!("{n} {verdict}"));
    let verdicts = verdicts.collect::<Vec<_>>().join(", ");
    let cells = terminal::count(graded.cells, "answer cell");
    let mut text = format!("{cells} in {form} form: {verdicts}").trim_end().to_owned() + "\n";
    let mut rows =
        vec![terminal::head("part | right | wrong | unreadable | blank | right of those that count")];
    for (column, counts) in table.columns.iter().zip(&graded.by_column) {
        let of = |verdicts: &[Verdict]| verdicts.iter().map(|v| counts[*v as usize]).sum::<u64>();
        let right = of(&[Verdict::Right]);
        let wrong =
            of(&[Verdict::Wrong, Verdict::WrongDirection, Verdict::WrongDimension, Verdict::MissingUnit]);
        let unreadable = of(&[Verdict::Unreadable]);
        let counting = right + wrong + unreadable;
        rows.push(vec![
            column.label(),
            right.to_string(),
            wrong.to_string(),
            unreadable.to_string(),
            of(&[Verdict::Blank]).to_string(),
            (right * 100).checked_div(counting).map_or_else(|| "-".to_owned(), |p| format!("{p} %")),
        ]);
    }
    text.push_str(terminal::table(&rows, &[0]).trim_end());
    let handed =
        graded.points.chunks(table.columns.len().max(1)).filter(|p| p.iter().any(Option::is_some)).count();
    let students = terminal::count(table.students.len(), "student");
    text.push_str(&format!("\n  {handed} of {students} handed in."));
    if !graded.unused_columns.is_empty() {
        text.push_str(&format!(" Columns not used: {}.", graded.unused_columns.join(", ")));
    }
    let unread = policy.late.unread.map_or("in time", Unread::as_str);
    let notes = [
        (graded.count(Verdict::UnknownStudent), "Not counted: ", " under an id that is not on the roster (`unknown student` in answers.csv). Spreadsheets turn 0017 into 17.".to_owned()),
        (graded.respelled, "", " came under an id that differs from the roster's only in case or in how an accent or apostrophe is coded, and count.".to_owned()),
        (graded.undated, "", format!(" that count have no submitted_at that can be read, and are taken as {unread}.")),
        (graded.untimed, "The attempts at ", " were ordered by row, because a submitted_at cannot be read.".to_owned()),
    ];
    for (count, before, after) in notes.into_iter().filter(|(count, ..)| *count > 0) {
        text.push_str(&format!("\n  {before}{}{after}", terminal::count(count, "answer")));
    }
    text
}
