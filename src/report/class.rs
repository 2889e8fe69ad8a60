//! The class report: sections of sentences, plots and tables, made of a [`Study`].
use crate::finding::Finding;
use crate::grade::verdict::Verdict;
use crate::misconception::catalogue::Catalogue;
use crate::plot::svg::escaped;
use crate::report::charts;
use crate::report::marks::Marks;
use crate::report::stats::LEAST_FOR_CORRELATION;
use crate::report::stats::LEAST_FOR_MEDIAN;
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::LEVEL;
use crate::report::study::Mistake;
use crate::report::study::Study;
use crate::report::table::Cell;
use crate::report::table::Table;
use crate::report::table::fixed;
use crate::report::table::percent;
use crate::report::table::points;
use crate::template;
use crate::template::Templates;
use crate::template::View;
use std::collections::BTreeMap;

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

/// Mistakes told in words; all are in the table.
const FAVOURITES: usize = 6;
/// Rows of a long table on the page; its file has all.
const SHOWN: usize = 20;

/// Writes the report.
///
/// # Errors
/// Faults of the template.
pub fn report(
    marks: &Marks,
    study: &Study,
    about: &About,
    catalogue: &Catalogue,
    templates: &Templates,
    rich: Rich,
) -> Result<ClassReport, Finding> {
    let mut pen = Pen { marks, study, catalogue, tables: Vec::new() };
    let sections = [
        Section { id: "graded", title: "How this was graded", body: pen.graded(about) },
        Section { id: "overview", title: "Overview", body: pen.overview() },
        Section { id: "lecture", title: "For the next lecture", body: pen.lecture(rich) },
        Section { id: "totals", title: "Totals", body: pen.totals() },
        Section { id: "parts", title: "Part by part", body: pen.parts() },
        Section { id: "items", title: "Difficulty and discrimination", body: pen.items() },
        Section { id: "mistakes", title: "Wrong methods and slips", body: pen.mistakes(rich) },
        Section { id: "reading", title: "What could not be read", body: pen.reading() },
        Section { id: "attempts", title: "Attempts and time", body: pen.attempts() },
        Section { id: "fairness", title: "Fairness between variants", body: pen.fairness() },
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

/// `1 student`, `2 students`
fn count(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}

fn paragraph(text: &str) -> String {
    format!("<p>{}</p>\n", escaped(text))
}

fn figure(svg: &str) -> String {
    format!("<figure>{}</figure>\n", svg.trim_end())
}

/// Seconds in words: `3 min`, `2.5 h`, `3 days`.
fn lasting(seconds: f64) -> String {
    match seconds {
        s if s < 90.0 => format!("{} s", fixed(s, 0)),
        s if s < 90.0 * 60.0 => format!("{} min", fixed(s / 60.0, 0)),
        s if s < 36.0 * 3600.0 => format!("{} h", fixed(s / 3600.0, 1)),
        s => format!("{} days", fixed(s / 86400.0, 1)),
    }
}

struct Pen<'p> {
    marks: &'p Marks,
    study: &'p Study,
    catalogue: &'p Catalogue,
    tables: Vec<Table>,
}

impl Pen<'_> {
    fn table(&mut self, table: Table) -> String {
        let html = table.html();
        self.tables.push(table);
        html
    }

    /// A table of which a page shows the first rows; its file has all.
    fn long_table(&mut self, table: Table, most: usize) -> String {
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

    fn label(&self, part: usize) -> String {
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

    /// `1.v (12 answers), 1.omega (1 answer)`
    fn where_made(&self, mistake: &Mistake) -> String {
        let mut parts = mistake.parts.clone();
        parts.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let shown: Vec<String> =
            parts.iter().take(6).map(|(p, n)| format!("{} ({n})", self.label(*p))).collect();
        let more = parts.len().saturating_sub(shown.len());
        format!("{}{}", shown.join(", "), if more > 0 { format!(" and {more} more") } else { String::new() })
    }

    fn lecture(&mut self, rich: Rich) -> String {
        let study = self.study;
        // What a single student did is no matter for a lecture.
        let favourites: Vec<&Mistake> =
            study.mistakes.iter().filter(|m| m.students > 1).take(FAVOURITES).collect();
        if favourites.is_empty() {
            return paragraph(match study.wrong.0 {
                0 => "No wrong answer counts: there is no mistake to talk about.",
                _ if study.mistakes.is_empty() => "No wrong answer fits a method of the catalogue.",
                _ => "No wrong method was taken by more than one student.",
            });
        }
        let took = study.took_part.len();
        let mut out = paragraph(
            "The class's favourite mistakes, those of most students first. Each answer fits what the method gives for that student's own numbers, within the tolerance of the part; where several methods give the same, the answers cannot tell which it was.",
        );
        out.push_str("<ol class=\"mistakes\">\n");
        for mistake in favourites {
            let share = if took >= LEAST_FOR_SHARE {
                format!(" ({} of those who handed in)", percent(mistake.students as f64 / took as f64))
            } else {
                String::new()
            };
            let who =
                format!("{}{share}, in {}", count(mistake.students, "student"), self.where_made(mistake));
            let notes: Vec<String> = mistake
                .ids
                .iter()
                .map(|id| {
                    let code = format!("<code>{}</code>", escaped(id));
                    match self.catalogue.get(id) {
                        Some(entry) => format!("<p>{} {code}</p>", rich(&entry.note)),
                        None => format!("<p>A method that the catalogue does not describe. {code}</p>"),
                    }
                })
                .collect();
            let one_of =
                if notes.len() > 1 { "<p>One of these, which come to the same value:</p>\n" } else { "" };
            let body = if notes.len() > 1 {
                let items: Vec<String> = notes.iter().map(|n| format!("<li>{n}</li>")).collect();
                format!("{one_of}<ul>\n{}\n</ul>", items.join("\n"))
            } else {
                notes.concat()
            };
            out.push_str(&format!("<li><p class=\"who\">{}</p>\n{body}</li>\n", escaped(&who)));
        }
        out.push_str("</ol>\n");
        out
    }

    fn totals(&mut self) -> String {
        let study = self.study;
        let Some(summary) = study.summary.filter(|_| study.most > 0.0) else {
            return paragraph("Nobody handed in, or nothing gives points: there are no totals.");
        };
        let mut out = figure(&charts::totals(study, &summary));
        let nobody = self.marks.class.students.len() - study.took_part.len();
        if nobody > 0 {
            out.push_str(&paragraph(&format!(
                "{} handed in nothing and {} not counted here.",
                count(nobody, "student"),
                if nobody == 1 { "is" } else { "are" }
            )));
        }
        if !study.same_most {
            out.push_str(&paragraph("The sheets do not all give the same number of points."));
        }
        let cell = Cell::points;
        let rows = vec![vec![
            Cell::count(summary.n),
            cell(study.most),
            cell(summary.mean),
            cell(summary.deviation),
            cell(summary.least),
            cell(summary.lower),
            cell(summary.median),
            cell(summary.upper),
            cell(summary.greatest),
        ]];
        out.push_str(&self.table(Table {
            name: "totals",
            caption: "Totals of those who handed in, in points".to_owned(),
            head: vec![
                ("Students", "students"),
                ("Of", "max_total"),
                ("Mean", "mean"),
                ("Deviation", "standard_deviation"),
                ("Least", "least"),
                ("Quarter", "lower_quartile"),
                ("Median", "median"),
                ("Three quarters", "upper_quartile"),
                ("Greatest", "greatest"),
            ],
            texts: 0,
            shown: 9,
            rows,
        }));
        out
    }

    fn parts(&mut self) -> String {
        let study = self.study;
        let mut out = String::new();
        if study.parts.iter().any(|p| p.answered > 0) {
            out.push_str(&figure(&charts::success(self.marks, study)));
            out.push_str(&paragraph(&format!(
                "The share of right answers among those that count, with Wilson's 95 % interval. Below {LEAST_FOR_SHARE} answers no share is given."
            )));
        }
        let rows = study
            .parts
            .iter()
            .enumerate()
            .map(|(p, part)| {
                let blank = self.marks.by_part[p][Verdict::Blank as usize];
                let success = part.success.filter(|_| part.answered >= LEAST_FOR_SHARE);
                let ease = part.ease.filter(|_| part.asked >= LEAST_FOR_SHARE);
                let discrimination = part.discrimination.as_ref();
                let of = &self.marks.class.parts[p];
                vec![
                    Cell::text(&of.label()),
                    Cell::points(of.points),
                    Cell::count(part.asked),
                    Cell::count(part.answered),
                    Cell::count(part.right),
                    Cell::text(&blank.to_string()),
                    Cell::or_none(success.map(|s| Cell::share(s.value))),
                    Cell::or_none(success.map(|s| Cell::share(s.low))),
                    Cell::or_none(success.map(|s| Cell::share(s.high))),
                    Cell::or_none(ease.map(Cell::share)),
                    Cell::or_none(discrimination.ok().map(|d| Cell::number(*d, 2))),
                    Cell::text(discrimination.err().map_or("", String::as_str)),
                    Cell::text(&self.marks.class.problems[of.number - 1].title),
                ]
            })
            .collect();
        out.push_str(&self.table(Table {
            name: "parts",
            caption: "Each part: students asked, of those who handed in; answers that count; ease and discrimination as told below".to_owned(),
            head: vec![
                ("Part", "part"),
                ("Points", "points"),
                ("Asked", "asked"),
                ("Answered", "answered"),
                ("Right", "right"),
                ("Blank", "blank_cells"),
                ("Share", "share_right"),
                ("from", "interval_low"),
                ("to", "interval_high"),
                ("Ease", "ease"),
                ("Discr.", "discrimination"),
                ("Why none", "why_no_discrimination"),
                ("Problem", "problem"),
            ],
            texts: 1,
            shown: 11,
            rows,
        }));
        out
    }

    fn items(&mut self) -> String {
        let study = self.study;
        let mut out = String::new();
        if let Some(chart) = charts::items(self.marks, study) {
            out.push_str(&figure(&chart));
        }
        let alpha = match &study.alpha {
            Ok(alpha) => {
                let judged = match alpha.value {
                    a if a >= 0.8 => {
                        "The parts measure much the same thing: the totals rank students reliably."
                    }
                    a if a >= 0.6 => {
                        "That is usual for a sheet of homework; for marks that decide much, take more parts."
                    }
                    _ => {
                        "That is low: the parts ask for different things, or chance plays a large part in the totals."
                    }
                };
                format!(
                    "Cronbach's alpha of {} parts and {} students is {} (95 % interval by Feldt: {} to {}). {judged}",
                    study.scale.len(),
                    study.took_part.len(),
                    fixed(alpha.value, 2),
                    fixed(alpha.low, 2),
                    fixed(alpha.high, 2)
                )
            }
            Err(why) => format!("Cronbach's alpha is not given: {why}."),
        };
        out.push_str(&paragraph(&alpha));
        if study.parts.iter().any(|p| p.discrimination.is_ok()) {
            out.push_str(&paragraph(
                "Ease is the mean share of the points, no answer counting 0. Discrimination is the correlation of the points of a part with the sum of all others: above 0.3 good, below 0.2 (marked) the part hardly tells strong from weak, below 0 look at it closely: is it misunderstood, or its key disputed?",
            ));
        } else if study.took_part.len() < LEAST_FOR_CORRELATION {
            out.push_str(&paragraph(&format!(
                "Discrimination is not given: below {LEAST_FOR_CORRELATION} students the 95 % interval of a correlation is wider than ±0.44, so that hardly any value would say anything."
            )));
        }
        out
    }

    fn mistakes(&mut self, rich: Rich) -> String {
        let study = self.study;
        let (wrong, unexplained) = study.wrong;
        if wrong == 0 {
            return paragraph("No wrong answer counts.");
        }
        let explained = wrong - unexplained;
        let mut out = paragraph(&format!(
            "Of {} that count, {explained} fit a wrong method of the catalogue, a wrong direction or a slip; {unexplained} fit nothing that is known.",
            count(wrong, "wrong answer")
        ));
        if !study.mistakes.is_empty() {
            out.push_str(&figure(&charts::mistakes(self.marks, study)));
            let rows = study
                .mistakes
                .iter()
                .map(|mistake| {
                    let entries: Vec<_> =
                        mistake.ids.iter().filter_map(|id| self.catalogue.get(id)).collect();
                    let did: Vec<String> = entries.iter().map(|e| rich(&e.did)).collect();
                    let raw: Vec<&str> = entries.iter().map(|e| e.did.as_str()).collect();
                    let parts: Vec<String> =
                        mistake.parts.iter().map(|(p, n)| format!("{}\u{a0}({n})", self.label(*p))).collect();
                    vec![
                        Cell::text(&mistake.ids.join(" ")),
                        Cell::rich(did.join(" <em>or:</em> "), &raw.join(" or: ")),
                        Cell::rich(escaped(&parts.join(", ")), &parts.join(", ").replace('\u{a0}', " ")),
                        Cell::count(mistake.students),
                        Cell::count(mistake.answers),
                        Cell::share(mistake.answers as f64 / wrong as f64),
                    ]
                })
                .collect();
            let methods = Table {
                name: "methods",
                caption:
                    "Wrong methods; those that come to the same value stand together, the most likely first"
                        .to_owned(),
                head: vec![
                    ("Methods", "methods"),
                    ("What they did", "did"),
                    ("Parts (answers)", "parts"),
                    ("Students", "students"),
                    ("Answers", "answers"),
                    ("Of the wrong", "share_of_wrong"),
                ],
                texts: 3,
                shown: 6,
                rows,
            };
            out.push_str(&self.long_table(methods, SHOWN));
        }
        if !study.slips.is_empty() {
            let rows = study
                .slips
                .iter()
                .map(|(word, n)| vec![Cell::text(word), Cell::text(&slip_in_words(word)), Cell::count(*n)])
                .collect();
            out.push_str(&self.table(Table {
                name: "slips",
                caption: "Slips: answers that have something in common with a right one".to_owned(),
                head: vec![("Slip", "slip"), ("What it is", "what"), ("Answers", "answers")],
                texts: 2,
                shown: 3,
                rows,
            }));
        }
        if !study.credit.is_empty() {
            let rows = study
                .credit
                .iter()
                .map(|(word, n)| vec![Cell::text(word), Cell::text(credit_in_words(word)), Cell::count(*n)])
                .collect();
            out.push_str(&self.table(Table {
                name: "credit",
                caption: "Answers whose points are not simply all or nothing".to_owned(),
                head: vec![("Word", "credit"), ("What it is", "what"), ("Answers", "answers")],
                texts: 2,
                shown: 3,
                rows,
            }));
        }
        out
    }

    fn reading(&mut self) -> String {
        if self.marks.troubles.is_empty() {
            return paragraph("Every answer could be read and had a unit of the right kind.");
        }
        let total: u64 = self.marks.troubles.values().map(|t| t.cells).sum();
        let mut out = paragraph(&format!(
            "{total} answer cells, replaced attempts included, could not be read, had a unit of another kind, or had none where one is demanded. Where one reason is frequent, tell the class how to write it."
        ));
        // One row for each reason, whatever the part.
        let mut kinds: BTreeMap<(Verdict, &str), (u64, Vec<usize>, Vec<&str>)> = BTreeMap::new();
        for ((part, verdict, reason), trouble) in &self.marks.troubles {
            let (cells, parts, examples) = kinds.entry((*verdict, reason)).or_default();
            *cells += trouble.cells;
            parts.extend(part);
            examples.extend(trouble.examples.iter().map(String::as_str));
        }
        let mut kinds: Vec<_> = kinds.into_iter().collect();
        kinds.sort_by(|a, b| b.1.0.cmp(&a.1.0).then_with(|| a.0.cmp(&b.0)));
        let rows: Vec<Vec<Cell>> = kinds
            .iter()
            .map(|((verdict, reason), (cells, parts, examples))| {
                let mut distinct: Vec<&str> = Vec::new();
                for example in examples {
                    if distinct.len() < 3 && !distinct.contains(example) {
                        distinct.push(example);
                    }
                }
                let shown: Vec<String> =
                    distinct.iter().map(|e| format!("<code>{}</code>", escaped(&short(e)))).collect();
                let parts: Vec<String> = parts.iter().map(|p| self.label(*p)).collect();
                vec![
                    Cell::text(verdict.as_str()),
                    Cell::text(reason),
                    Cell::rich(shown.join(" "), &distinct.join(" | ")),
                    Cell::rich(escaped(&several(&parts)), &parts.join(" ")),
                    Cell::text(&cells.to_string()),
                ]
            })
            .collect();
        let table = Table {
            name: "unreadable",
            caption: "Cells that gave trouble, the most frequent reason first".to_owned(),
            head: vec![
                ("Verdict", "verdict"),
                ("Reason", "reason"),
                ("Such as", "examples"),
                ("Parts", "parts"),
                ("Cells", "cells"),
            ],
            texts: 4,
            shown: 5,
            rows,
        };
        out.push_str(&self.long_table(table, SHOWN));
        out
    }

    fn attempts(&mut self) -> String {
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
                row.push(Cell::or_none(part.attempts.map(|m| Cell::number(m, 1))));
                row.push(Cell::or_none(
                    part.seconds.map(|(m, _)| Cell::rich(lasting(m), &format!("{m:.0}"))),
                ));
                row.push(Cell::or_none(part.seconds.map(|(_, n)| Cell::count(n))));
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
                ("Median attempt", "median_attempt"),
                ("Median time", "median_seconds"),
                ("of", "timed_students"),
            ],
            texts: 1,
            shown: 10,
            rows,
        }));
        out
    }

    fn fairness(&mut self) -> String {
        let study = self.study;
        let title = |i: usize| format!("{}. {}", i + 1, self.marks.class.problems[i].title);
        let mut out = String::new();
        for (problem, n) in &study.too_few {
            out.push_str(&paragraph(&format!(
                "{}: {} handed in an answer; below {LEAST_FOR_CORRELATION} nothing is said, because chance alone makes such differences.",
                title(*problem),
                count(*n, "student")
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
        let rows = study
            .fairness
            .iter()
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
        out.push_str(&self.table(Table {
            name: "fairness",
            caption: "Share of the points of a problem against what was drawn".to_owned(),
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
        }));
        out
    }

    fn summary(&self) -> Vec<String> {
        let study = self.study;
        let mut lines = Vec::new();
        if let Some(mistake) = study.mistakes.first().filter(|m| m.students > 1) {
            lines.push(format!(
                "favourite mistake: {} ({}, in {})",
                mistake.ids.join(" or "),
                count(mistake.students, "student"),
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

/// The first few names of a list.
fn several(names: &[String]) -> String {
    const MOST: usize = 3;
    let more = names.len().saturating_sub(MOST);
    let shown = names[..names.len() - more].join(", ");
    if more > 0 { format!("{shown} and {more} more") } else { shown }
}

/// An example of the table, at most so long.
fn short(text: &str) -> String {
    const MOST: usize = 40;
    if text.chars().count() <= MOST {
        return text.to_owned();
    }
    text.chars().take(MOST - 1).chain(std::iter::once('…')).collect()
}

/// A kind of slip for the table.
fn slip_in_words(word: &str) -> String {
    match word {
        "power_of_ten" => "the right number times a power of ten".to_owned(),
        "figures" => "the right number, rounded to too few figures".to_owned(),
        "drift" => "just outside the tolerance: rounding on the way explains it".to_owned(),
        "part" => "the right number of another part".to_owned(),
        other => match other.strip_prefix("unit ") {
            Some(unit) => format!("the right number in {unit}, given in the unit asked"),
            None => String::new(),
        },
    }
}

/// A word of credit for the table.
fn credit_in_words(word: &str) -> &'static str {
    match word {
        "methods" => "some points for a known wrong method",
        "follow" => "some points for what follows correctly from the student's own wrong answer",
        "correction" => "points given to all, because the part was faulty",
        "attempt" => "fewer points for a further attempt",
        "late" => "fewer points because it was late",
        "closed" => "no points: after the end",
        _ => "",
    }
}
