//! The class report: numbers and names for the template `report.html`, and its tables. Sections, sentences and heads are the
//! template's and the phrases' (`report`).
//!
//! `report.html` receives what `page` puts together and includes `report-table.html` for each table, as `t`. What is finished HTML (plots, formulas) it marks as `safe`; all else is escaped.
mod marks_and_weakest;
mod mistakes;
mod tables;

use crate::finding::Finding;
use crate::matches::FLAGGED;
use crate::misconception::catalogue::Catalogue;
use crate::num::shown;
use crate::report::charts::{self, ClassCharts};
use crate::report::marks::Marks;
use crate::report::matches::ClassMatches;
use crate::report::stats::{LEAST_FOR_CORRELATION, LEAST_FOR_MEDIAN, LEAST_FOR_SHARE};
use crate::report::study::{ClassStudy, LEVEL, PartStudy};
use crate::report::table::{Table, fixed, percent, points};
use crate::template::{Templates, View};
use crate::words::Words;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Markdown with formulas to HTML within a line.
pub type Rich<'r> = &'r mut dyn FnMut(&str) -> String;

/// Names of all tables.
pub const TABLES: &str =
    "asked attempts credit fairness matches methods parts slips totals unreadable verdicts";

/// Rows of a long table on the page; its file has all.
const SHOWN: usize = 20;
/// Tables that may be long.
const LONG: [&str; 3] = ["methods", "unreadable", "fairness"];

/// What the report says of itself.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct About {
    /// Title of the course or the bank.
    pub title: String,
    /// Name of the set.
    pub set: String,
    /// How it was graded: name of the setting, what it is.
    pub settings: Vec<(String, String)>,
    /// What was graded by what.
    pub provenance: Vec<(String, String)>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct ClassReport {
    /// The page.
    pub html: Vec<u8>,
    pub tables: Vec<Table>,
}

/// What a class report is made of.
#[derive(Clone, Copy)]
pub struct ClassReporter<'r> {
    pub marks: &'r Marks,
    pub study: &'r ClassStudy,
    /// Words about wrong methods, in the language.
    pub catalogue: &'r Catalogue,
    /// Wrong answers that equal the keys of classmates.
    pub matches: &'r ClassMatches,
    /// Words of the language.
    pub words: &'r Words,
}

impl ClassReporter<'_> {
    /// Writes the report. Errors: faults of the template.
    pub fn report(&self, about: &About, templates: &Templates, rich: Rich) -> Result<ClassReport, Finding> {
        let tables = self.tables(&mut *rich);
        let mut view = View::new();
        view.fields(&self.page(about, &tables, rich));
        let html = templates.made("report.html", &view)?;
        Ok(ClassReport { html, tables })
    }

    fn say(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        self.words.say(&format!("report.{name}"), pieces)
    }

    fn number(&self, value: f64, decimals: usize) -> String {
        self.words.number(&fixed(value, decimals))
    }

    /// A phrase about so many: that of one, or with their number.
    fn say_of(&self, n: usize, name: &str, pieces: &[(&str, &str)]) -> String {
        let number = n.to_string();
        let pieces: Vec<(&str, &str)> = pieces.iter().copied().chain([("n", number.as_str())]).collect();
        self.say(&format!("{name}{}", if n == 1 { "_one" } else { "" }), &pieces)
    }

    fn label(&self, part: usize) -> String {
        self.marks.class.parts[part].label()
    }

    fn title(&self, problem: usize) -> String {
        format!("{}. {}", problem + 1, self.marks.class.problems[problem])
    }

    /// What the template receives; numbers that are texts are finished, with the mark of the language. `graded` holds lists of
    /// name and value; `least` the sizes below which nothing is told; `right` the share of the answers that count; `no_favourites`
    /// the name of the phrase that says why there are no favourite mistakes.
    fn page(&self, about: &About, tables: &[Table], rich: Rich) -> Value {
        let weakest = self.weakest(&mut *rich);
        let (study, marks, words) = (self.study, self.marks, self.words);
        let facts = [("settings", &about.settings), ("provenance", &about.provenance)];
        let facts: Vec<_> = facts.into_iter().filter(|(_, list)| !list.is_empty()).collect();
        let counting: usize = study.parts.iter().map(|p| p.answered).sum();
        let right: usize = study.parts.iter().map(|p| p.right).sum();
        let (no_favourites, favourites) = self.lecture(rich);
        let (wrong, unexplained) = study.wrong;
        let number = |value: f64| words.number(&points(value));
        let totals = study.summary.filter(|_| study.most > 0.0).map(
            |s| json!({"median": number(s.median), "most": number(study.most), "same": study.same_most}),
        );
        let alpha = study.alpha.ok().map(|alpha| {
            let [value, low, high] = [alpha.value, alpha.low, alpha.high].map(|v| self.number(v, 2));
            let judged = match alpha.value {
                a if a >= 0.8 => "high",
                a if a >= 0.6 => "usual",
                _ => "low",
            };
            json!({"value": value, "low": low, "high": high, "parts": study.scale.len(), "judged": judged})
        });
        let views = tables.iter().map(|table| {
            let most = if LONG.contains(&table.name) { SHOWN } else { usize::MAX };
            (table.name, Some(table.view(words, most)))
        });
        let none = TABLES.split(' ').map(|name| (name, None));
        let (about_fairness, compared) = self.fairness();
        json!({
            "language": words.language(),
            "title": about.title,
            "set": about.set,
            "words": words.tree("report"),
            "graded": facts,
            "least": {
                "share": LEAST_FOR_SHARE,
                "median": LEAST_FOR_MEDIAN,
                "correlation": LEAST_FOR_CORRELATION,
            },
            "marks": self.student_lines(),
            "problems": marks.class.problems.len(),
            "weakest": weakest,
            "students": marks.class.students.len(),
            "took_part": study.took_part.len(),
            "absent": marks.class.students.len() - study.took_part.len(),
            "rows": marks.rows,
            "totals": totals,
            "right": (counting >= LEAST_FOR_SHARE).then(|| percent(right as f64 / counting as f64)),
            "alpha": alpha,
            "no_alpha": study.alpha.err().map(|why| why.say(words)),
            "no_favourites": no_favourites,
            "favourites": favourites,
            "wrong": wrong,
            "explained": wrong - unexplained,
            "unexplained": unexplained,
            "trouble": marks.troubles.values().map(|t| t.cells).sum::<u64>(),
            "several_attempts": marks.cells.iter().any(|c| c.attempts > 1),
            "timed": marks.timed,
            "too_few": about_fairness[0],
            "stand_out": about_fairness[1],
            "comparisons": study.fairness.len(),
            "compared": compared,
            "noticed": self.number(charts::noticed(compared, study.fairness.len()), 2),
            "matches": self.matches.summary(words),
            "flagged": words.number(&FLAGGED.to_string()),
            "tells": self.tells(),
            "charts": self.charts(),
            "tables": none.chain(views).collect::<BTreeMap<_, _>>(),
        })
    }

    /// The plots, finished.
    fn charts(&self) -> Value {
        let charts = ClassCharts { marks: self.marks, study: self.study, words: self.words };
        let bars: Vec<(String, String, usize)> =
            (self.favourites().iter()).map(|m| (m.ids.join(" "), self.in_short(m), m.students())).collect();
        let fairness =
            (0..self.marks.class.problems.len()).filter_map(|i| charts.fairness(&self.title(i), i));
        json!({
            "totals": self.study.summary.filter(|_| self.study.most > 0.0).map(|s| charts.totals(&s)),
            "parts": charts.parts(),
            "items": charts.items(),
            "mistakes": (!bars.is_empty()).then(|| charts.mistakes(&bars)),
            "fairness": fairness.collect::<Vec<_>>(),
        })
    }

    /// Which plots tell something; the others are folded.
    fn tells(&self) -> Value {
        let study = self.study;
        let poor = |p: &PartStudy| p.discrimination.is_ok_and(|d| d < charts::POOR);
        json!({
            "items": study.parts.iter().any(poor),
            "mistakes": self.favourites().iter().any(|m| m.students() > 1),
            "fairness": study.fairness.iter().any(|c| c.corrected < LEVEL),
        })
    }

    /// The problems with too few students to compare, what stands out, and the most students in a comparison.
    fn fairness(&self) -> ([String; 2], usize) {
        let found = &self.study.fairness;
        let few = self.study.too_few.iter().map(|(problem, n)| {
            self.say_of(*n, "fairness.few_problem", &[("problem", &self.title(*problem))])
        });
        let stand_out = found.iter().filter(|c| c.corrected < LEVEL).map(|c| {
            let case = self.words.get("report.fairness.case");
            let what = if c.datum.is_empty() { case } else { &c.datum };
            self.say("fairness.in_problem", &[("what", what), ("number", &(c.problem + 1).to_string())])
        });
        let told = [few.collect::<Vec<_>>().join("; "), stand_out.collect::<Vec<_>>().join(", ")];
        (told, found.iter().map(|c| c.n).max().unwrap_or(0))
    }

    /// `1 in 2e14`, and as it is where luck brings one or more.
    fn by_luck(&self, expected: f64) -> String {
        let one_in = match 1.0 / expected {
            _ if expected >= 1.0 => return self.words.number(&shown::decimals(expected, 1)),
            one_in if one_in < 1000.0 => shown::decimals(one_in, 0),
            one_in if one_in.is_finite() => shown::figures(one_in, 1),
            _ => return self.words.get("report.matches.never").to_owned(),
        };
        self.say("matches.one_in", &[("n", &one_in)])
    }

    /// Seconds in words: `3 min`, `2.5 h`, `3 days`.
    fn lasting(&self, seconds: f64) -> String {
        match seconds {
            s if s < 90.0 => format!("{} s", self.number(s, 0)),
            s if s < 90.0 * 60.0 => format!("{} min", self.number(s / 60.0, 0)),
            s if s < 36.0 * 3600.0 => format!("{} h", self.number(s / 3600.0, 1)),
            s => self.say("days", &[("n", &self.number(s / 86400.0, 1))]),
        }
    }
}
