//! Sections on attempts, time, and whether variants were equally hard.
use crate::num::shown;
use crate::report::charts;
use crate::report::class::Pen;
use crate::report::class::SHOWN;
use crate::report::class::count;
use crate::report::class::figure;
use crate::report::class::lasting;
use crate::report::class::paragraph;
use crate::report::stats::LEAST_FOR_CORRELATION;
use crate::report::stats::LEAST_FOR_MEDIAN;
use crate::report::study::Comparison;
use crate::report::study::LEVEL;
use crate::report::table::Cell;
use crate::report::table::Table;
use crate::report::table::fixed;
use crate::report::table::percent;

impl Pen<'_> {
    pub(crate) fn attempts(&mut self) -> String {
        let study = self.study;
        let rows: Vec<Vec<Cell>> = study
            .parts
            .iter()
            .enumerate()
            .map(|(p, part)| {
                let never = part.answered - part.first_right.iter().sum::<usize>().min(part.answered);
                let mut row = vec![Cell::text(&self.label(p)), Cell::count(part.answered)];
                row.extend(part.first_right.iter().map(|n| Cell::count(*n)));
                row.push(Cell::count(never));
                row.push(Cell::or_none(
                    part.seconds.map(|(m, _)| Cell::rich(lasting(m), &shown::decimals(m, 0))),
                ));
                row.push(Cell::or_none(part.seconds.map(|(_, n)| Cell::count(n))));
                row.push(Cell::or_none(part.attempts.map(|m| Cell::number(m, 1))));
                row
            })
            .collect();
        let several = self.marks.cells.iter().filter(|c| c.attempts > 1).count();
        let mut out = String::new();
        if several == 0 {
            out.push_str(&paragraph("Nobody answered a part more than once."));
        }
        out.push_str(&paragraph(&if self.marks.timed {
            format!(
                "The time is from a student's first attempt at a part to the first right one, the median of those who needed several attempts; at least {LEAST_FOR_MEDIAN} of them, else none is given."
            )
        } else {
            "The submissions have no times that can be read: attempts are counted in the order of the rows, and no time to the first right attempt is known.".to_owned()
        }));
        out.push_str(&self.table(Table {
            name: "attempts",
            caption: "At which attempt each part was first right".to_owned(),
            head: vec![
                ("Part", "part"),
                ("Answered", "answered"),
                ("1st", "right_at_1"),
                ("2nd", "right_at_2"),
                ("3rd", "right_at_3"),
                ("Later", "right_later"),
                ("Never", "never_right"),
                ("Median time", "median_seconds"),
                ("Students", "timed_students"),
                ("Median attempt", "median_attempt"),
            ],
            texts: 1,
            // Where it is 1 everywhere it says nothing.
            shown: if study.parts.iter().any(|p| p.attempts.is_some_and(|m| m > 1.0)) { 10 } else { 9 },
            rows,
        }));
        out
    }

    pub(crate) fn fairness(&mut self) -> String {
        let study = self.study;
        let title = |i: usize| format!("{}. {}", i + 1, self.marks.class.problems[i].title);
        let mut out = String::new();
        if !study.too_few.is_empty() {
            let few: Vec<String> = study
                .too_few
                .iter()
                .map(|(i, n)| format!("{} ({})", title(*i), count(*n, "student")))
                .collect();
            out.push_str(&paragraph(&format!(
                "Nothing is said about {}: with answers of fewer than {LEAST_FOR_CORRELATION} students chance alone makes such differences.",
                few.join("; ")
            )));
        }
        if study.fairness.is_empty() {
            return out;
        }
        let odd: Vec<String> = study
            .fairness
            .iter()
            .filter(|c| c.corrected < LEVEL)
            .map(|c| {
                let what = if c.datum.is_empty() { "the case".to_owned() } else { c.datum.clone() };
                format!("{what} in problem {}", c.problem + 1)
            })
            .collect();
        let n = study.fairness.iter().map(|c| c.n).max().unwrap_or(0);
        out.push_str(&paragraph(&format!(
            "Does the share of the points of a problem go with what a student was dealt? {} made; {}",
            if study.fairness.len() == 1 {
                "One comparison was".to_owned()
            } else {
                format!("{} comparisons were", study.fairness.len())
            },
            if odd.is_empty() {
                "none stands out.".to_owned()
            } else {
                format!("these stand out: {}.", odd.join(", "))
            }
        )));
        out.push_str(&paragraph(&format!(
            "Each datum is compared by Spearman's correlation of ranks, with its 95 % interval; cases by the test of Kruskal and Wallis. Variants were dealt by lot, so a correlation that stands out means that some variants were harder, or that it is the one class in twenty where chance does this. The probabilities are corrected for the number of comparisons (Holm), so that chance makes any of them stand out in at most 5 % of classes. That nothing stands out does not prove that all variants are equally hard: with {n} students a correlation below about ±{} would go unnoticed.",
            fixed(charts::noticed(n, study.fairness.len()), 2)
        )));
        for problem in 0..self.marks.class.problems.len() {
            if let Some(chart) = charts::fairness(&title(problem), study, problem) {
                out.push_str(&figure(&chart));
            }
        }
        let mut list: Vec<&Comparison> = study.fairness.iter().collect();
        list.sort_by(|a, b| a.p.total_cmp(&b.p));
        let rows = list
            .into_iter()
            .map(|c| {
                let cases: Vec<String> = c
                    .cases
                    .iter()
                    .map(|(name, n, mean)| {
                        format!("{name}: mean {}, {}", percent(*mean), count(*n, "student"))
                    })
                    .collect();
                let what =
                    if c.datum.is_empty() { format!("case ({})", cases.join("; ")) } else { c.datum.clone() };
                vec![
                    Cell::text(&(c.problem + 1).to_string()),
                    Cell::text(&what),
                    Cell::count(c.n),
                    Cell::or_none(c.rho.map(|r| Cell::number(r.value, 2))),
                    Cell::or_none(c.rho.map(|r| Cell::number(r.low, 2))),
                    Cell::or_none(c.rho.map(|r| Cell::number(r.high, 2))),
                    Cell::number(c.p, 3),
                    Cell::number(c.corrected, 3),
                ]
            })
            .collect();
        let table = Table {
            name: "fairness",
            caption:
                "Share of the points of a problem against what was drawn, the least likely by chance first"
                    .to_owned(),
            head: vec![
                ("Problem", "problem"),
                ("Datum", "datum"),
                ("Students", "students"),
                ("Correlation", "spearman"),
                ("from", "interval_low"),
                ("to", "interval_high"),
                ("p", "p"),
                ("p corrected", "p_holm"),
            ],
            texts: 2,
            shown: 8,
            rows,
        };
        out.push_str(&self.long_table(table, SHOWN));
        out
    }
}
