//! Sections on what went wrong: favourite mistakes in words, wrong methods and slips, what could not be read.
use crate::grade::verdict::Verdict;
use crate::picture::svg::escaped;
use crate::report::charts;
use crate::report::class::Pen;
use crate::report::class::Rich;
use crate::report::class::SHOWN;
use crate::report::class::count;
use crate::report::class::figure;
use crate::report::class::paragraph;
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::Mistake;
use crate::report::table::Cell;
use crate::report::table::Table;
use crate::report::table::percent;
use crate::sheet::terminal::plain;
use std::collections::BTreeMap;

/// Mistakes told in words; all are in the table.
const FAVOURITES: usize = 6;

/// Trouble of one kind: cells, parts, examples.
type Kind<'k> = (u64, Vec<usize>, Vec<&'k str>);

impl Pen<'_> {
    /// `1.v (12 answers), 1.omega (1 answer)`
    pub(crate) fn where_made(&self, mistake: &Mistake) -> String {
        let mut parts = mistake.parts.clone();
        parts.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let shown: Vec<String> =
            parts.iter().take(6).map(|(p, n)| format!("{} ({n})", self.label(*p))).collect();
        let more = parts.len().saturating_sub(shown.len());
        format!("{}{}", shown.join(", "), if more > 0 { format!(" and {more} more") } else { String::new() })
    }

    /// The wrong methods; those of the same words, which stand in the lists of several problems, as one.
    pub(crate) fn favourites(&self) -> Vec<Mistake> {
        let words = |m: &Mistake| m.ids.first().and_then(|id| self.catalogue.get(id)).map(|e| e.did.as_str());
        let mut list: Vec<Mistake> = Vec::new();
        for mistake in &self.study.mistakes {
            let same = list.iter_mut().find(|m| words(m).is_some() && words(m) == words(mistake));
            match same {
                Some(known) => known.join(mistake),
                None => list.push(mistake.clone()),
            }
        }
        Mistake::sort(&mut list);
        list
    }

    /// What was done, in a line of plain text.
    pub(crate) fn in_short(&self, mistake: &Mistake) -> String {
        let entry = mistake.ids.first().and_then(|id| self.catalogue.get(id));
        entry.map_or_else(String::new, |e| plain(e.did.trim_end_matches('.')))
    }

    pub(crate) fn lecture(&mut self, rich: Rich) -> String {
        let study = self.study;
        // What a single student did is no matter for a lecture.
        let all = self.favourites();
        let favourites: Vec<&Mistake> = all.iter().filter(|m| m.students() > 1).take(FAVOURITES).collect();
        if favourites.is_empty() {
            return paragraph(match study.wrong.0 {
                0 => "No wrong answer counts: there is no mistake to talk about.",
                _ if study.mistakes.is_empty() => "No wrong answer fits a method of the catalogue.",
                _ => "No wrong method was taken by more than one student.",
            });
        }
        let took = study.took_part.len();
        let mut out = paragraph(
            "The class's favourite mistakes, those of most students first. Each answer fits what the method gives for that student's own numbers, within the tolerance of the part; where several methods give the same, the answers cannot tell which it was, and count for the most likely one.",
        );
        out.push_str("<ol class=\"mistakes\">\n");
        for mistake in favourites {
            let students = mistake.students();
            let share = if took >= LEAST_FOR_SHARE {
                format!(" ({} of those who handed in)", percent(students as f64 / took as f64))
            } else {
                String::new()
            };
            let who = format!("{}{share}, in {}", count(students, "student"), self.where_made(mistake));
            let codes = |ids: &[String]| -> String {
                let codes: Vec<String> =
                    ids.iter().map(|id| format!("<code>{}</code>", escaped(id))).collect();
                codes.join(" ")
            };
            let ids = codes(&mistake.ids);
            let mut body = match mistake.ids.first().and_then(|id| self.catalogue.get(id)) {
                Some(entry) => {
                    let (they, advice) = advice(&entry.note);
                    let advice = match advice {
                        "" => String::new(),
                        text => format!("<p><strong>In the lecture:</strong> {}</p>", rich(text)),
                    };
                    format!("<p>{} {ids}</p>{advice}", rich(&they))
                }
                None => format!("<p>A method that the catalogue does not describe. {ids}</p>"),
            };
            if !mistake.also.is_empty() {
                body.push_str(&format!(
                    "<p class=\"who\">Some of these answers fit {} too.</p>",
                    codes(&mistake.also)
                ));
            }
            out.push_str(&format!("<li><p class=\"who\">{}</p>\n{body}</li>\n", escaped(&who)));
        }
        out.push_str("</ol>\n");
        out
    }

    pub(crate) fn mistakes(&mut self, rich: Rich) -> String {
        let study = self.study;
        let (wrong, unexplained) = study.wrong;
        if wrong == 0 {
            return paragraph("No wrong answer counts.");
        }
        let explained = wrong - unexplained;
        let mut out = paragraph(&format!(
            "Of {} that {}, {explained} fit a wrong method of the catalogue, a wrong direction or a slip; {unexplained} fit nothing that is known.",
            count(wrong, "wrong answer"),
            if wrong == 1 { "counts" } else { "count" }
        ));
        if !study.mistakes.is_empty() {
            let bars: Vec<(String, String, usize)> = (self.favourites().iter())
                .map(|m| (m.ids.join(" "), self.in_short(m), m.students()))
                .collect();
            out.push_str(&figure(&charts::mistakes(self.marks, &bars)));
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
                        Cell::or_none(
                            (!mistake.also.is_empty()).then(|| Cell::text(&mistake.also.join(" "))),
                        ),
                        Cell::count(mistake.students()),
                        Cell::count(mistake.answers),
                        Cell::share(mistake.answers as f64 / wrong as f64),
                    ]
                })
                .collect();
            let methods = Table {
                name: "methods",
                caption: "Wrong methods; an answer that fits several counts for the most likely one"
                    .to_owned(),
                head: vec![
                    ("Method", "method"),
                    ("The mistake", "did"),
                    ("Parts (answers)", "parts"),
                    ("Some fit too", "fits_as_well"),
                    ("Students", "students"),
                    ("Answers", "answers"),
                    ("Of the wrong", "share_of_wrong"),
                ],
                texts: 4,
                shown: 7,
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

    pub(crate) fn reading(&mut self) -> String {
        if self.marks.troubles.is_empty() {
            return paragraph("Every answer could be read and had a unit of the right kind.");
        }
        let total: u64 = self.marks.troubles.values().map(|t| t.cells).sum();
        let mut out = paragraph(&format!(
            "{total} answer cells, replaced attempts included, could not be read, had a unit of another kind, or had none where one is demanded. Where one reason is frequent, tell the class how to write it."
        ));
        // One row for each reason, whatever the part.
        let mut kinds: BTreeMap<(Verdict, &str), Kind> = BTreeMap::new();
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
}

/// A note of the catalogue, `They do this: show that.`, as a sentence and an advice; the advice may be empty.
fn advice(note: &str) -> (String, &str) {
    match note.split_once(": ") {
        Some((they, advice)) => (format!("{they}."), advice),
        None => (note.to_owned(), ""),
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
        "drift" => "just outside the tolerance: rounded intermediate results explain it".to_owned(),
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
