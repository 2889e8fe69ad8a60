//! Sections on totals and parts: how many points, how hard, how telling.
use crate::report::charts;
use crate::report::class::Pen;
use crate::report::class::count;
use crate::report::class::figure;
use crate::report::class::paragraph;
use crate::report::stats::LEAST_FOR_CORRELATION;
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::table::Cell;
use crate::report::table::Table;
use crate::report::table::fixed;
use crate::sheet::terminal::plain;

impl Pen<'_> {
    pub(crate) fn totals(&mut self) -> String {
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
                ("SD", "standard_deviation"),
                ("Minimum", "minimum"),
                ("Lower quartile", "lower_quartile"),
                ("Median", "median"),
                ("Upper quartile", "upper_quartile"),
                ("Maximum", "maximum"),
            ],
            texts: 0,
            shown: 9,
            rows,
        }));
        out
    }

    pub(crate) fn parts(&mut self) -> String {
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
                let none = part.asked.saturating_sub(part.answered);
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
                    Cell::count(none),
                    Cell::or_none(success.map(|s| Cell::share(s.value))),
                    Cell::or_none(success.map(|s| Cell::share(s.low))),
                    Cell::or_none(success.map(|s| Cell::share(s.high))),
                    Cell::or_none(ease.map(Cell::share)),
                    Cell::or_none(discrimination.ok().map(|d| Cell::number(*d, 2))),
                    Cell::text(discrimination.err().map_or("", String::as_str)),
                    Cell::text(&self.marks.class.problems[of.number - 1].title),
                    Cell::text(&plain(&of.asked)),
                ]
            })
            .collect();
        out.push_str(&self.table(Table {
            name: "parts",
            caption: "Each part, in students who handed in: asked it, answered it, were right, gave no answer; ease and discrimination as told below".to_owned(),
            head: vec![
                ("Part", "part"),
                ("Points", "points"),
                ("Asked", "asked"),
                ("Answered", "answered"),
                ("Right", "right"),
                ("No answer", "no_answer"),
                ("Share", "share_right"),
                ("from", "interval_low"),
                ("to", "interval_high"),
                ("Ease", "ease"),
                ("Discr.", "discrimination"),
                ("Why none", "why_no_discrimination"),
                ("Problem", "problem"),
                ("What is asked", "what_is_asked"),
            ],
            texts: 1,
            shown: 11,
            rows,
        }));
        out
    }

    pub(crate) fn items(&mut self) -> String {
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
}
