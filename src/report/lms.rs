//! Gradebooks as Canvas and Moodle import them: one total for each student of the set.
use crate::csv_field::{push_line, push_text};
use crate::grade::row::in_points;

/// A student's line of a gradebook.
#[derive(Debug, Clone, PartialEq)]
pub struct GradebookLine<'l> {
    /// Id, as on the roster.
    pub id: &'l str,
    /// Name, empty if none is known.
    pub name: &'l str,
    /// Points, `None` if nothing was handed in and nothing was given.
    pub points: Option<f64>,
    /// SIS id, login and number on Canvas, if it said so itself; empty where there is none.
    pub canvas: Option<&'l [String; 3]>,
    /// A short text for the student.
    pub feedback: String,
}

/// The CSV file that Canvas imports: `Student,ID,SIS User ID,SIS Login ID,Section` and the assignment, a row `Points Possible`,
/// then the students.
///
/// Canvas looks a student up by `ID` (its own number), by `SIS User ID`, by `SIS Login ID`, then by the name. Of a quiz that was
/// taken there all three are known; else the id of the roster stands in both SIS columns. An assignment of this name is filled, or a new one is
/// made with these points (instructure/canvas-lms, `lib/gradebook_importer.rb`). An empty cell changes nothing.
pub fn canvas(assignment: &str, most: f64, lines: &[GradebookLine]) -> Vec<u8> {
    let mut out = Vec::new();
    let assignment = canvas_name(assignment);
    push_line(&mut out, ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", &assignment]);
    push_line(&mut out, ["Points Possible", "", "", "", "", &in_points(most)]);
    for line in lines {
        let name = if line.name.is_empty() { line.id } else { line.name };
        let [number, sis, login] = match line.canvas {
            Some([sis, login, number]) => [number.as_str(), sis, login],
            None => ["", line.id, line.id],
        };
        let points = line.points.map_or_else(String::new, in_points);
        push_line(&mut out, [name, number, sis, login, "", &points]);
    }
    out
}

/// Canvas reads a number in brackets at the end as its own number of an assignment, and passes over columns whose names it
/// uses itself.
fn canvas_name(name: &str) -> String {
    const RESERVED: [&str; 3] = ["Current", "Final", "Override"];
    let name = name.trim();
    let inner = name.strip_suffix(')').and_then(|n| n.rsplit_once('('));
    let numbered = inner.filter(|(_, n)| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    match numbered {
        Some((before, n)) => format!("{before}[{n}]"),
        None if name.is_empty() => "slipstick".to_owned(),
        None if RESERVED.iter().any(|r| name.contains(r)) => name.replace(' ', "-"),
        None => name.to_owned(),
    }
}

/// The CSV file that Moodle imports: an identifier, the name, the points of a grade item and its feedback.
///
/// Moodle asks which column identifies the user (`Map from`) and with which field (`Map to`: user id, ID number, email address
/// or username), and which column goes into which grade item; a cell `-` is no grade (moodle,
/// `grade/import/csv/classes/load_data.php`). Grades and feedback of an item must be imported together, else the grades are
/// lost (Moodle documentation, Grade import). The first column is called `first`, or else `Email address` if every id is one, or else `ID number`.
pub fn moodle(item: &str, first: Option<&str>, lines: &[GradebookLine]) -> Vec<u8> {
    let emails = !lines.is_empty() && lines.iter().all(|l| l.id.contains('@'));
    let first = first.unwrap_or(if emails { "Email address" } else { "ID number" });
    let mut out = Vec::new();
    push_line(&mut out, [first, "Name", item, &format!("{item} (Feedback)")]);
    for line in lines {
        let points = line.points.map_or_else(|| "-".to_owned(), in_points);
        push_text(&mut out, line.id.as_bytes());
        out.push(b',');
        push_text(&mut out, line.name.as_bytes());
        // A dash is no formula here: nothing stands before it.
        out.extend_from_slice(format!(",{points},").as_bytes());
        push_text(&mut out, line.feedback.as_bytes());
        out.push(b'\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line<'l>(id: &'l str, name: &'l str, points: Option<f64>) -> GradebookLine<'l> {
        GradebookLine { id, name, points, canvas: None, feedback: "1.v right".to_owned() }
    }

    #[test]
    fn canvas_has_its_columns() {
        let lines =
            [line("0017", "Yusuf, Amina", Some(7.5)), line("+23", "", None), line("9", "=cmd()", Some(0.0))];
        let text = String::from_utf8(canvas("week (3)", 20.0, &lines)).unwrap();
        assert_eq!(
            text,
            "Student,ID,SIS User ID,SIS Login ID,Section,week [3]\nPoints Possible,,,,,20\n\"Yusuf, Amina\",,0017,0017,,7.5\n+23,,+23,+23,,\n'=cmd(),,9,9,,0\n"
        );
        assert_eq!(canvas_name("Final Score of week 3"), "Final-Score-of-week-3");
        assert_eq!(canvas_name(""), "slipstick");
        assert_eq!(canvas_name("week ()"), "week ()");
    }

    #[test]
    fn moodle_has_its_columns() {
        let text =
            String::from_utf8(moodle("week-3", None, &[line("a@b.c", "A", Some(1.0)), line("@d", "", None)]))
                .unwrap();
        assert_eq!(
            text,
            "Email address,Name,week-3,week-3 (Feedback)\na@b.c,A,1,1.v right\n'@d,,-,1.v right\n"
        );
        assert!(moodle("x", None, &[line("17", "", None)]).starts_with(b"ID number,"));
        assert!(moodle("x", Some("Username"), &[line("a", "", None)]).starts_with(b"Username,"));
    }
}
