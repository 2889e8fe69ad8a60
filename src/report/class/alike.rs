//! The section on answers that are those of classmates.
use crate::matches::FLAGGED;
use crate::num::shown;
use crate::picture::svg::escaped;
use crate::report::alike::Matches;
use crate::report::class::Pen;
use crate::report::class::SHOWN;
use crate::report::class::paragraph;
use crate::report::table::Cell;
use crate::report::table::Table;

/// `1 in 2e14`, and as it is where luck brings one or more.
fn by_luck(expected: f64) -> String {
    match 1.0 / expected {
        _ if expected >= 1.0 => shown::decimals(expected, 1),
        one_in if one_in < 1000.0 => format!("1 in {}", shown::decimals(one_in, 0)),
        one_in if one_in.is_finite() => format!("1 in {}", shown::figures(one_in, 1)),
        _ => "never".to_owned(),
    }
}

impl Pen<'_> {
    pub(crate) fn alike(&mut self, found: &Matches) -> String {
        let mut out = paragraph(&format!("{} All pairs stand in matches.csv.", found.summary()));
        if found.pairs.is_empty() {
            return out;
        }
        out.push_str(&paragraph(&format!(
            "An answer hits a classmate's key if it equals it within the rounding of the figures it was given with. By luck: how many pairs as striking honest work would bring in the whole class, all students beside all classmates; a pair is to be looked at where that is below {FLAGGED}. What a wrong method, a slip or another part of the student's own problem explains is told and not counted against anybody. A match accuses nobody: sheets get swapped, friends compute with one set of data, a form is filled in for another."
        )));
        let named = |who: &[String; 2]| match who[1].as_str() {
            "" => Cell::text(&who[0]),
            name => Cell::text(&format!("{} ({name})", who[0])),
        };
        let rows = found.pairs.iter().take(SHOWN).map(|pair| {
            vec![
                named(&pair.student),
                named(&pair.classmate),
                Cell::text(&pair.parts.join(", ")),
                Cell::text(&pair.answers.join(" | ")),
                Cell::rich(escaped(&by_luck(pair.expected)), &shown::figures(pair.expected, 2)),
                Cell::text(if pair.flagged { "yes" } else { "no" }),
                Cell::text(&pair.explained),
            ]
        });
        let table = Table {
            name: "matches",
            caption: "Wrong answers that equal the key of a classmate".to_owned(),
            head: vec![
                ("Answers of", "student"),
                ("equal the key of", "classmate"),
                ("Parts", "parts"),
                ("Answers", "answers"),
                ("By luck", "expected_by_luck"),
                ("Look", "look"),
                ("Other explanation", "other_explanation"),
            ],
            texts: 4,
            shown: 7,
            rows: rows.collect(),
        };
        out.push_str(&table.html());
        out
    }
}
