//! The tables of the class report: a page shows them, and each is a CSV file.
use crate::grade::verdict::Verdict;
use crate::num::shown;
use crate::plot::rows::shortened;
use crate::report::class::{ClassReporter, Rich, SHOWN};
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::DatumComparison;
use crate::report::table::{Table, TableCell, percent};
use crate::template;
use crate::words::plain::plain;
use std::collections::BTreeMap;

/// Cells of one verdict and reason: how many, of which parts, with examples.
#[derive(Default)]
struct Reason<'t> {
    cells: u64,
    parts: Vec<usize>,
    examples: Vec<&'t str>,
}

impl ClassReporter<'_> {
    /// All tables that have something to tell.
    pub(super) fn tables(&self, rich: Rich) -> Vec<Table> {
        let study = self.study;
        let mut tables = vec![self.verdicts(), self.asked(&mut *rich), self.parts(), self.attempts()];
        if study.most > 0.0 {
            tables.extend(study.summary.map(|_| self.totals()));
        }
        // Where no wrong answer counts, nothing is told of wrong answers.
        if study.wrong.0 > 0 {
            tables.extend((!study.mistakes.is_empty()).then(|| self.methods(rich)));
            tables.extend((!study.slips.is_empty()).then(|| self.slips()));
            tables.extend((!study.credit.is_empty()).then(|| self.credit()));
        }
        tables.extend((!self.marks.troubles.is_empty()).then(|| self.unreadable()));
        tables.extend((!study.fairness.is_empty()).then(|| self.comparisons()));
        tables.extend((!self.matches.pairs.is_empty()).then(|| self.same_answers()));
        tables
    }

    /// A word of the program as people say it, and as it stands in the CSV file.
    fn word(&self, topic: &str, word: &str) -> TableCell {
        let name = format!("report.{topic}.{}", word.replace(' ', "_"));
        TableCell::named(if self.words.has(&name) { self.words.get(&name) } else { word }, word)
    }

    fn verdicts(&self) -> Table {
        let counts = Verdict::ALL.iter().map(|v| (v, self.marks.verdicts[*v as usize]));
        let rows = counts.filter(|(_, n)| *n > 0).map(|(verdict, n)| {
            let share = TableCell::share(n as f64 / self.marks.rows.max(1) as f64);
            vec![self.word("verdict", verdict.as_str()), TableCell::count(n), share]
        });
        let columns = "verdict cells share";
        Table::new("verdicts", columns, 1, rows)
    }

    /// Each part in words, with what counts as right.
    fn asked(&self, rich: Rich) -> Table {
        let text = |text: &str| TableCell::or_none((!text.is_empty()).then(|| TableCell::text(text)));
        let rows = self.marks.class.parts.iter().map(|part| {
            let asked = match part.asked.as_str() {
                "" => template::in_html(&self.marks.class.problems[part.number - 1]),
                asked => rich(asked),
            };
            let unit = match (part.unit.as_str(), part.unit_required) {
                _ if part.tolerance.is_empty() => self.say("parts.word", &[]),
                ("1", _) => String::new(),
                (unit, true) => self.say("parts.required", &[("unit", unit)]),
                (unit, false) => unit.to_owned(),
            };
            vec![
                TableCell::text(&part.label()),
                TableCell::rich(asked, &plain(&part.asked)),
                text(&unit),
                text(&part.tolerance),
                TableCell::points(part.points),
            ]
        });
        let columns = "part what_is_asked unit tolerance points";
        Table::new("asked", columns, 4, rows)
    }

    fn totals(&self) -> Table {
        let row = self.study.summary.map(|s| {
            let points =
                [self.study.most, s.mean, s.deviation, s.least, s.lower, s.median, s.upper, s.greatest];
            let points = points.into_iter().map(TableCell::points);
            std::iter::once(TableCell::count(s.n)).chain(points).collect()
        });
        let columns =
            "students max_total mean standard_deviation minimum lower_quartile median upper_quartile maximum";
        Table::new("totals", columns, 0, row.into_iter())
    }

    fn parts(&self) -> Table {
        let rows = self.study.parts.iter().zip(&self.marks.class.parts).map(|(part, of)| {
            let success = part.success.filter(|_| part.answered >= LEAST_FOR_SHARE);
            let ease = part.ease.filter(|_| part.asked >= LEAST_FOR_SHARE);
            let share = |value: Option<f64>| TableCell::or_none(value.map(TableCell::share));
            let discrimination = part.discrimination;
            let why_none = discrimination.err().map_or_else(String::new, |why| why.say(self.words));
            vec![
                TableCell::text(&of.label()),
                TableCell::points(of.points),
                TableCell::count(part.asked),
                TableCell::count(part.answered),
                TableCell::count(part.right),
                TableCell::count(part.asked.saturating_sub(part.answered)),
                share(success.map(|s| s.value)),
                share(success.map(|s| s.low)),
                share(success.map(|s| s.high)),
                share(ease),
                TableCell::or_none(discrimination.ok().map(|d| TableCell::fixed(d, 2))),
                TableCell::text(&why_none),
                TableCell::text(&self.marks.class.problems[of.number - 1]),
                TableCell::text(&plain(&of.asked)),
            ]
        });
        let columns = "part points asked answered right no_answer share_right interval_low interval_high ease discrimination why_no_discrimination problem what_is_asked";
        Table { shown: 11, ..Table::new("parts", columns, 1, rows) }
    }

    fn methods(&self, rich: Rich) -> Table {
        let rows = self.study.mistakes.iter().map(|mistake| {
            let entries: Vec<_> = mistake.ids.iter().filter_map(|id| self.catalogue.get(id)).collect();
            let did: Vec<String> = entries.iter().map(|e| rich(&e.did)).collect();
            let raw: Vec<&str> = entries.iter().map(|e| e.did.as_str()).collect();
            let parts: Vec<String> =
                mistake.parts.iter().map(|(p, n)| format!("{} ({n})", self.label(*p))).collect();
            let whole: Vec<String> = parts.iter().map(|part| part.replace(' ', "\u{a0}")).collect();
            let or = self.words.get("report.or");
            let also: Vec<String> = mistake.also.iter().map(|id| self.with_words(id, &mut *rich)).collect();
            let also = (!also.is_empty()).then(|| TableCell::rich(also.join("; "), &mistake.also.join(" ")));
            vec![
                TableCell::text(&mistake.ids.join(" ")),
                TableCell::rich(did.join(&format!("<em>{}</em>", template::in_html(or))), &raw.join(or)),
                TableCell::named(&whole.join(", "), &parts.join(", ")),
                TableCell::or_none(also),
                TableCell::count(mistake.students()),
                TableCell::count(mistake.answers),
                TableCell::share(mistake.answers as f64 / self.study.wrong.0 as f64),
            ]
        });
        let columns = "method did parts fits_as_well students answers share_of_wrong";
        Table::new("methods", columns, 4, rows)
    }

    fn slips(&self) -> Table {
        let rows = self.study.slips.iter().map(|(word, n)| {
            let what = match word.strip_prefix("unit ") {
                Some(unit) => self.say("slip.unit", &[("unit", unit)]),
                None => self.word("slip", word).shown,
            };
            vec![TableCell::rich(code(word), word), TableCell::text(&what), TableCell::count(*n)]
        });
        let columns = "slip what answers";
        Table::new("slips", columns, 2, rows)
    }

    fn credit(&self) -> Table {
        let rows = self.study.credit.iter().map(|(word, n)| {
            let what = self.word("credit", word).shown;
            vec![TableCell::rich(code(word), word), TableCell::text(&what), TableCell::count(*n)]
        });
        let columns = "credit what answers";
        Table::new("credit", columns, 2, rows)
    }

    /// What could not be read: one row for each reason, whatever the part.
    fn unreadable(&self) -> Table {
        const EXAMPLES: usize = 3;
        const LONGEST: usize = 40;
        const PARTS: usize = 3;
        let mut reasons: BTreeMap<(Verdict, &str), Reason> = BTreeMap::new();
        for ((part, verdict, reason), trouble) in &self.marks.troubles {
            let found = reasons.entry((*verdict, reason)).or_default();
            found.cells += trouble.cells;
            found.parts.extend(part);
            for example in &trouble.examples {
                if found.examples.len() < EXAMPLES && !found.examples.contains(&example.as_str()) {
                    found.examples.push(example);
                }
            }
        }
        let mut reasons: Vec<_> = reasons.into_iter().collect();
        reasons.sort_by(|a, b| b.1.cells.cmp(&a.1.cells).then_with(|| a.0.cmp(&b.0)));
        let rows = reasons.iter().map(|((verdict, reason), found)| {
            let codes: Vec<String> = found.examples.iter().map(|e| code(&shortened(e, LONGEST))).collect();
            let parts: Vec<String> = found.parts.iter().map(|p| self.label(*p)).collect();
            vec![
                self.word("verdict", verdict.as_str()),
                TableCell::text(reason),
                TableCell::rich(codes.join(" "), &found.examples.join(" | ")),
                TableCell::named(&self.first_of(&parts, PARTS), &parts.join(" ")),
                TableCell::count(found.cells),
            ]
        });
        let columns = "verdict reason examples parts cells";
        Table::new("unreadable", columns, 4, rows)
    }

    fn attempts(&self) -> Table {
        let rows = self.study.parts.iter().enumerate().map(|(p, part)| {
            let never = part.answered - part.first_right.iter().sum::<usize>().min(part.answered);
            let seconds = part.seconds.map(|(median, n)| {
                [TableCell::named(&self.lasting(median), &shown::decimals(median, 0)), TableCell::count(n)]
            });
            let mut row = vec![TableCell::text(&self.label(p)), TableCell::count(part.answered)];
            row.extend(part.first_right.iter().map(TableCell::count));
            row.push(TableCell::count(never));
            row.extend(seconds.unwrap_or_else(|| [TableCell::or_none(None), TableCell::or_none(None)]));
            row.push(TableCell::or_none(part.attempts.map(|m| TableCell::fixed(m, 1))));
            row
        });
        let columns = "part answered right_at_1 right_at_2 right_at_3 right_later never_right median_seconds timed_students median_attempt";
        // Where the median attempt is 1 everywhere it says nothing.
        let several = self.study.parts.iter().any(|p| p.attempts.is_some_and(|m| m > 1.0));
        let shown = if several { 10 } else { 9 };
        Table { shown, ..Table::new("attempts", columns, 1, rows) }
    }

    /// Comparisons of marks with what was drawn, the least likely by chance first.
    fn comparisons(&self) -> Table {
        let mut list: Vec<&DatumComparison> = self.study.fairness.iter().collect();
        list.sort_by(|a, b| a.p.total_cmp(&b.p));
        let rows = list.into_iter().map(|c| {
            let cases = c.cases.iter().map(|(name, n, mean)| {
                self.say_of(*n, "fairness.one_case", &[("name", name), ("mean", &percent(*mean))])
            });
            let cases = cases.collect::<Vec<_>>().join("; ");
            let case = || self.say("fairness.cases", &[("cases", &cases)]);
            let what = if c.datum.is_empty() { case() } else { c.datum.clone() };
            let number = |value: Option<f64>| TableCell::or_none(value.map(|v| TableCell::fixed(v, 2)));
            vec![
                TableCell::count(c.problem + 1),
                TableCell::text(&what),
                TableCell::count(c.n),
                number(c.rho.map(|r| r.value)),
                number(c.rho.map(|r| r.low)),
                number(c.rho.map(|r| r.high)),
                TableCell::fixed(c.p, 3),
                TableCell::fixed(c.corrected, 3),
            ]
        });
        let columns = "problem datum students spearman interval_low interval_high p p_holm";
        Table::new("fairness", columns, 2, rows)
    }

    /// Answers that are those of classmates; matches.csv has all.
    fn same_answers(&self) -> Table {
        let named = |who: &[String; 2]| match who[1].as_str() {
            "" => TableCell::text(&who[0]),
            name => TableCell::text(&format!("{} ({name})", who[0])),
        };
        let rows = self.matches.pairs.iter().take(SHOWN).map(|pair| {
            let look = self.words.get(if pair.flagged { "report.look" } else { "report.no_look" });
            vec![
                named(&pair.student),
                named(&pair.classmate),
                TableCell::text(&pair.parts.join(", ")),
                TableCell::text(&pair.answers.join(" | ")),
                TableCell::named(&self.by_luck(pair.expected), &shown::figures(pair.expected, 2)),
                TableCell::named(look, if pair.flagged { "yes" } else { "no" }),
                TableCell::text(&pair.explained),
            ]
        });
        let columns = "student classmate parts answers expected_by_luck look other_explanation";
        Table::new("matches", columns, 4, rows)
    }
}

fn code(text: &str) -> String {
    format!("<code>{}</code>", template::in_html(text))
}
