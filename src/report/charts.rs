//! The plots of the class report, in the words of a language.
use crate::num::{chance, trig};
use crate::plot::{Axis, AxisScale, Caption, ChartRow, NamedPoint, RowChart, ScatterChart, SpreadChart};
use crate::report::marks::Marks;
use crate::report::stats::spread::Distribution;
use crate::report::stats::{LEAST_FOR_SHARE, spread};
use crate::report::study::{ClassStudy, LEVEL};
use crate::report::table::{fixed, percent, points};
use crate::words::Words;

/// From so many students on the histogram has twice as many columns.
const MANY: usize = 120;
/// So few students get a dot each.
const FEW: usize = 30;
/// Below this a part hardly tells strong from weak (Ebel 1965).
pub const POOR: f64 = 0.2;

/// What the plots are made of.
#[derive(Clone, Copy)]
pub struct ClassCharts<'c> {
    pub marks: &'c Marks,
    pub study: &'c ClassStudy,
    /// Words of the language.
    pub words: &'c Words,
}

impl ClassCharts<'_> {
    fn say(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        self.words.say(&format!("report.chart.{name}"), pieces)
    }

    fn axis(&self, name: &str, low: f64, high: f64) -> Axis {
        Axis { label: self.say(name, &[]), scale: AxisScale::Linear, low, high }
    }

    /// A bar or a dot with its interval, and the number beside it.
    fn row(label: &str, value: Option<f64>, note: String) -> ChartRow {
        let (label, words) = (label.to_owned(), String::new());
        ChartRow { label, words, value, interval: None, note, marked: false }
    }

    /// A plot of rows; its description lists them.
    fn rows(&self, name: &str, title: &str, axis: Axis, shares: bool, rows: Vec<ChartRow>) -> RowChart {
        let told: Vec<String> = rows.iter().map(|r| format!("{}: {}", r.label, r.note)).collect();
        let all = self.marks.class.students.len().to_string();
        let pieces = [("all", all.as_str()), ("list", &told.join("; "))];
        let description = self.say(&format!("{name}.description"), &pieces);
        RowChart {
            caption: Caption::new(format!("plot-{name}"), title, description),
            axis,
            percent: shares,
            bars: true,
            rows,
        }
    }

    /// The numbers on the axes with the mark of the language: they alone stand in a picture as nothing but a number.
    fn in_language(&self, svg: &str) -> String {
        if self.words.decimal() == '.' {
            return svg.to_owned();
        }
        let is_number = |text: &str| {
            text.bytes().any(|b| b.is_ascii_digit())
                && text.trim_start_matches('\u{2212}').parse::<f64>().is_ok()
        };
        let pieces = svg.split('>').map(|piece| match piece.split_once("</text") {
            Some((text, rest)) if is_number(text) => format!("{}</text{rest}", self.words.number(text)),
            _ => piece.to_owned(),
        });
        pieces.collect::<Vec<_>>().join(">")
    }

    pub fn totals(&self, summary: &Distribution) -> String {
        let study = self.study;
        // Credit beyond the sheet does not exist, but rounding up may pass the end.
        let most = study.most.max(summary.greatest);
        let classes = if study.totals.len() >= MANY { 26 } else { 16 };
        let histogram = spread::histogram(&study.totals, most, classes);
        let end = |i: usize| histogram.from + i as f64 * histogram.width;
        let classes = histogram.counts.iter().enumerate().map(|(i, n)| (end(i), end(i + 1), *n)).collect();
        let few = study.totals.len() < FEW;
        let of = |value: f64| self.words.number(&points(value));
        let (n, median, sum) = (summary.n.to_string(), of(summary.median), of(study.most));
        let (lower, upper) = (of(summary.lower), of(summary.upper));
        let (least, greatest) = (of(summary.least), of(summary.greatest));
        let pieces = [
            ("n", n.as_str()),
            ("median", &median),
            ("lower", &lower),
            ("upper", &upper),
            ("least", &least),
            ("greatest", &greatest),
            ("most", &sum),
        ];
        let how = self.say(if few { "totals.dots" } else { "totals.columns" }, &[]);
        let description = format!("{} {how}", self.say("totals.description", &pieces));
        let spread = SpreadChart {
            caption: Caption::new("plot-totals", self.say("totals.title", &[]), description),
            axis: Axis {
                label: self.say("totals.axis", &[("most", &sum)]),
                scale: AxisScale::Linear,
                low: if few { 0.0 } else { histogram.from },
                high: if few { most } else { end(histogram.counts.len()) },
            },
            classes,
            dots: if few { study.totals.clone() } else { Vec::new() },
            line: Some((summary.median, self.say("totals.median", &[("n", &median)]))),
            what: self.say("totals.students", &[]),
        };
        self.in_language(&spread.svg())
    }

    /// Success of each part; `None` if nobody answered any.
    pub fn parts(&self) -> Option<String> {
        let rows = self.study.parts.iter().zip(&self.marks.class.parts).map(|(part, of)| {
            let success = part.success.filter(|_| part.answered >= LEAST_FOR_SHARE);
            let (right, answered) = (part.right.to_string(), part.answered.to_string());
            let note = self.words.say("report.of", &[("n", &right), ("of", &answered)]);
            let interval = success.map(|s| (s.low, s.high));
            ChartRow { interval, ..Self::row(&of.label(), success.map(|s| s.value), note) }
        });
        let axis = self.axis("parts.axis", 0.0, 1.0);
        let rows = self.rows("parts", &self.say("parts.title", &[]), axis, true, rows.collect());
        self.study.parts.iter().any(|p| p.answered > 0).then(|| rows.svg())
    }

    /// Ease against discrimination; `None` if no part has both.
    pub fn items(&self) -> Option<String> {
        let spots = self.study.parts.iter().zip(&self.marks.class.parts).filter_map(|(part, of)| {
            let (x, y) = (part.ease?, *part.discrimination.as_ref().ok()?);
            Some(NamedPoint { x, y, label: of.label(), marked: y < POOR })
        });
        let spots: Vec<NamedPoint> = spots.collect();
        if spots.is_empty() {
            return None;
        }
        let told = spots.iter().map(|s| {
            let discrimination = self.words.number(&fixed(s.y, 2));
            let (ease, discrimination) = (percent(s.x), discrimination.as_str());
            self.say("items.part", &[("part", &s.label), ("ease", &ease), ("discrimination", discrimination)])
        });
        let list = told.collect::<Vec<_>>().join("; ");
        let level = self.words.number(&fixed(POOR, 1));
        let ys = spots.iter().map(|s| s.y).chain([0.0, 0.4]);
        let description = self.say("items.description", &[("list", &list)]);
        let scatter = ScatterChart {
            caption: Caption::new("plot-items", self.say("items.title", &[]), description),
            x: self.axis("items.x", 0.0, 1.0),
            y: Axis::around(&self.say("items.y", &[]), AxisScale::Linear, ys),
            level: Some((POOR, self.say("items.poor", &[("level", &level)]))),
            spots,
        };
        Some(self.in_language(&scatter.svg()))
    }

    /// Wrong methods by students: ids, words, how many.
    pub fn mistakes(&self, methods: &[(String, String, usize)]) -> String {
        const MOST: usize = 12;
        let most = methods.iter().map(|m| m.2).max().unwrap_or(1);
        let rows = methods.iter().take(MOST).map(|(ids, words, students)| ChartRow {
            words: words.clone(),
            ..Self::row(ids, Some(*students as f64), students.to_string())
        });
        let label = self.say("mistakes.axis", &[]);
        let mut axis = Axis::around(&label, AxisScale::Linear, [0.0, most as f64].into_iter());
        axis.high = axis.high.max(4.0);
        self.rows("mistakes", &self.say("mistakes.title", &[]), axis, false, rows.collect()).svg()
    }

    /// Correlations of the marks of a problem with its data; `None` if there are none.
    pub fn fairness(&self, title: &str, problem: usize) -> Option<String> {
        let rows = self.study.fairness.iter().filter(|c| c.problem == problem).filter_map(|c| {
            let rho = c.rho?;
            let note = self.words.number(&fixed(rho.value, 2));
            let row = Self::row(&c.datum, Some(rho.value), note);
            Some(ChartRow { interval: Some((rho.low, rho.high)), marked: c.corrected < LEVEL, ..row })
        });
        let rows: Vec<ChartRow> = rows.collect();
        if rows.is_empty() {
            return None;
        }
        let ends = rows.iter().filter_map(|r| r.interval);
        let widest = ends.fold(0.0, |w: f64, (a, b)| w.max(a.abs()).max(b.abs()));
        let reach = [0.25, 0.5, 1.0].into_iter().find(|r| widest <= *r).unwrap_or(1.0);
        let mut plot = self.rows("fairness", title, self.axis("fairness.axis", -reach, reach), false, rows);
        plot.caption.id = format!("plot-fairness-{}", problem + 1);
        plot.bars = false;
        Some(self.in_language(&plot.svg()))
    }
}

/// The least correlation that stands out among so many comparisons of n students (at least 4): tanh(z/sqrt(n - 3)), where z leaves
/// 5 % shared among the comparisons outside.
pub fn noticed(n: usize, comparisons: usize) -> f64 {
    let level = LEVEL / comparisons.max(1) as f64;
    let (mut low, mut high) = (0.0, 10.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if chance::normal_two_sided(middle) > level {
            low = middle;
        } else {
            high = middle;
        }
    }
    let e = trig::exp(2.0 * low / (n.max(4) as f64 - 3.0).sqrt());
    (e - 1.0) / (e + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_be_noticed() {
        // One comparison of 20 students: tanh(1.96/sqrt(17)) = 0.4426.
        assert!((noticed(20, 1) - 0.4426).abs() < 1e-4);
        assert!(noticed(500, 30) < noticed(60, 30));
        assert!(noticed(4, 1) < 1.0);
    }
}
