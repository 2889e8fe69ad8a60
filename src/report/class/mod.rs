//! The class report: sections of sentences, plots and tables, made of a [`Study`].
mod alike;
mod chance;
mod mistakes;
mod parts;

use crate::finding::Finding;
use crate::grade::verdict::Verdict;
use crate::misconception::catalogue::Catalogue;
use crate::picture::svg::escaped;
use crate::report::alike::Matches;
use crate::report::marks::Marks;
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::LEVEL;
use crate::report::study::Study;
use crate::report::table::Cell;
use crate::report::table::Table;
use crate::report::table::fixed;
use crate::report::table::percent;
use crate::report::table::points;
use crate::sheet::terminal::plain;
use crate::template;
use crate::template::Templates;
use crate::template::View;

/// Markdown with formulas to HTML within a line.
pub type Rich<'r> = &'r mut dyn FnMut(&str) -> String;

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

/// The finished report.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassReport {
    /// The page.
    pub html: Vec<u8>,
    /// Its tables.
    pub tables: Vec<Table>,
    /// The most important in some lines, for the terminal.
    pub summary: Vec<String>,
}

/// A section: id, heading, body in HTML.
struct Section {
    id: &'static str,
    title: &'static str,
    body: String,
}

/// Rows of a long table on the page; its file has all.
pub(crate) const SHOWN: usize = 20;

/// Writes the report.
///
/// # Errors
/// Faults of the template.
pub fn report(
    marks: &Marks,
    study: &Study,
    about: &About,
    catalogue: &Catalogue,
    matches: &Matches,
    templates: &Templates,
    rich: Rich,
) -> Result<ClassReport, Finding> {
    let mut pen = Pen { marks, study, catalogue, tables: Vec::new() };
    let sections = [
        Section { id: "graded", title: "How this was graded", body: pen.graded(about) },
        Section { id: "overview", title: "Overview", body: pen.overview() },
        Section { id: "lecture", title: "For the next lecture", body: pen.lecture(rich) },
        Section { id: "totals", title: "Totals", body: pen.totals() },
        Section { id: "parts", title: "Part by part", body: pen.legend(rich) + &pen.parts() },
        Section { id: "items", title: "Difficulty and discrimination", body: pen.items() },
        Section { id: "mistakes", title: "Wrong methods and slips", body: pen.mistakes(rich) },
        Section { id: "reading", title: "What could not be read", body: pen.reading() },
        Section { id: "attempts", title: "Attempts and time", body: pen.attempts() },
        Section { id: "fairness", title: "Fairness between variants", body: pen.fairness() },
        Section { id: "matches", title: "Answers of classmates", body: pen.alike(matches) },
    ];
    let mut view = View::new();
    view.foreign("title", &about.title);
    view.foreign("set", &about.set);
    let sections = sections.into_iter().map(|s| {
        template::map([
            ("id", template::finished(s.id)),
            ("title", template::finished(s.title)),
            ("body", template::finished(s.body.trim_end())),
        ])
    });
    view.value("sections", template::list(sections.collect()));
    let mut html = Vec::new();
    templates.render("report.html", &view, &mut html)?;
    Ok(ClassReport { html, summary: pen.summary(), tables: pen.tables })
}

/// The first letter small.
fn lowered(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// `1 student`, `2 students`
pub(crate) fn count(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}

pub(crate) fn paragraph(text: &str) -> String {
    format!("<p>{}</p>\n", escaped(text))
}

pub(crate) fn figure(svg: &str) -> String {
    format!("<figure>{}</figure>\n", svg.trim_end())
}

/// Seconds in words: `3 min`, `2.5 h`, `3 days`.
pub(crate) fn lasting(seconds: f64) -> String {
    match seconds {
        s if s < 90.0 => format!("{} s", fixed(s, 0)),
        s if s < 90.0 * 60.0 => format!("{} min", fixed(s / 60.0, 0)),
        s if s < 36.0 * 3600.0 => format!("{} h", fixed(s / 3600.0, 1)),
        s => format!("{} days", fixed(s / 86400.0, 1)),
    }
}

pub(crate) struct Pen<'p> {
    pub(crate) marks: &'p Marks,
    pub(crate) study: &'p Study,
    pub(crate) catalogue: &'p Catalogue,
    pub(crate) tables: Vec<Table>,
}

impl Pen<'_> {
    pub(crate) fn table(&mut self, table: Table) -> String {
        let html = table.html();
        self.tables.push(table);
        html
    }

    /// A table of which a page shows the first rows; its file has all.
    pub(crate) fn long_table(&mut self, table: Table, most: usize) -> String {
        let mut page = table.clone();
        page.rows.truncate(most);
        let mut html = page.html();
        if table.rows.len() > most {
            let (all, name) = (table.rows.len(), table.name);
            html.push_str(&paragraph(&format!("The first {most} of {all}; tables/{name}.csv has all.")));
        }
        self.tables.push(table);
        html
    }

    pub(crate) fn label(&self, part: usize) -> String {
        self.marks.class.parts[part].label()
    }

    fn graded(&mut self, about: &About) -> String {
        let mut out = String::from("<div class=\"facts\">\n");
        for (title, pairs) in [("Settings", &about.settings), ("Provenance", &about.provenance)] {
            if pairs.is_empty() {
                continue;
            }
            out.push_str(&format!("<div><h3>{title}</h3>\n<dl>\n"));
            for (name, value) in pairs {
                out.push_str(&format!("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(value)));
            }
            out.push_str("</dl></div>\n");
        }
        out.push_str("</div>\n");
        out
    }

    /// Each part in words, with what counts as right.
    fn legend(&mut self, rich: Rich) -> String {
        let rows = (self.marks.class.parts.iter())
            .map(|part| {
                let none = |text: &str| match text {
                    "" => Cell::none(),
                    text => Cell::text(text),
                };
                let shown = match part.asked.as_str() {
                    "" => escaped(&self.marks.class.problems[part.number - 1].title),
                    asked => rich(asked),
                };
                let unit = match (part.unit.as_str(), part.unit_required) {
                    _ if part.tolerance.is_empty() => "a word".to_owned(),
                    ("1", _) => String::new(),
                    (unit, true) => format!("{unit}, required"),
                    (unit, false) => unit.to_owned(),
                };
                vec![
                    Cell::text(&part.label()),
                    Cell::rich(shown, &plain(&part.asked)),
                    none(&unit),
                    none(&part.tolerance),
                    Cell::points(part.points),
                ]
            })
            .collect();
        self.table(Table {
            name: "asked",
            caption: "What each part asks, and what counts as right".to_owned(),
            head: vec![
                ("Part", "part"),
                ("What is asked", "what_is_asked"),
                ("Unit", "unit"),
                ("Tolerance", "tolerance"),
                ("Points", "points"),
            ],
            texts: 4,
            shown: 5,
            rows,
        })
    }

    fn overview(&mut self) -> String {
        let study = self.study;
        let all = self.marks.class.students.len();
        let counting: usize = study.parts.iter().map(|p| p.answered).sum();
        let right: usize = study.parts.iter().map(|p| p.right).sum();
        let mut facts = vec![
            (format!("{} of {all}", study.took_part.len()), "students handed in"),
            (self.marks.rows.to_string(), "answer cells"),
        ];
        if let Some(summary) = study.summary.filter(|_| study.most > 0.0) {
            let of = if study.same_most { format!(" of {}", points(study.most)) } else { String::new() };
            facts.push((format!("{}{of}", points(summary.median)), "median of the totals"));
        }
        if counting >= LEAST_FOR_SHARE {
            facts.push((percent(right as f64 / counting as f64), "of the answers that count are right"));
        }
        if let Ok(alpha) = &study.alpha {
            facts.push((fixed(alpha.value, 2), "Cronbach's alpha"));
        }
        let mut out = String::from("<ul class=\"figures\">\n");
        for (value, what) in facts {
            out.push_str(&format!("<li><strong>{}</strong> {what}</li>\n", escaped(&value)));
        }
        out.push_str("</ul>\n");
        let rows = Verdict::ALL
            .iter()
            .filter(|v| self.marks.verdicts[**v as usize] > 0)
            .map(|v| {
                let n = self.marks.verdicts[*v as usize];
                vec![
                    Cell::text(v.as_str()),
                    Cell::text(&n.to_string()),
                    Cell::share(n as f64 / self.marks.rows.max(1) as f64),
                ]
            })
            .collect();
        out.push_str(&self.table(Table {
            name: "verdicts",
            caption: "What became of every answer cell".to_owned(),
            head: vec![("Verdict", "verdict"), ("Cells", "cells"), ("Share", "share")],
            texts: 1,
            shown: 3,
            rows,
        }));
        out
    }

    fn summary(&self) -> Vec<String> {
        let study = self.study;
        let mut lines = Vec::new();
        let favourites = self.favourites();
        if let Some(mistake) = favourites.first().filter(|m| m.students() > 1) {
            lines.push(format!(
                "favourite mistake: {} ({}; {}, in {})",
                lowered(&self.in_short(mistake)),
                mistake.ids.join(" or "),
                count(mistake.students(), "student"),
                self.where_made(mistake)
            ));
        }
        let odd = study.fairness.iter().filter(|c| c.corrected < LEVEL).count();
        if odd > 0 {
            lines.push(format!(
                "fairness: {} out, see the report",
                if odd == 1 { "1 comparison stands" } else { "some comparisons stand" }
            ));
        }
        lines
    }
}
