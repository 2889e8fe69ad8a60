//! The plots of the class report.
use crate::num::chance;
use crate::num::trig;
use crate::plot::Axis;
use crate::plot::AxisScale;
use crate::plot::ChartRow;
use crate::plot::RowChart;
use crate::plot::ScatterChart;
use crate::plot::Spot;
use crate::plot::SpreadChart;
use crate::report::marks::Marks;
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::stats::spread;
use crate::report::stats::spread::Summary;
use crate::report::study::LEVEL;
use crate::report::study::Study;
use crate::report::table::fixed;
use crate::report::table::percent;
use crate::report::table::points;

/// From so many students on the histogram has twice as many columns.
const MANY: usize = 120;
/// So few students get a dot each.
const FEW: usize = 30;
/// Below this a part hardly tells strong from weak (Ebel 1965).
const POOR: f64 = 0.2;

fn axis(label: &str, low: f64, high: f64) -> Axis {
    Axis { label: label.to_owned(), scale: AxisScale::Linear, low, high }
}

/// Distribution of the totals.
pub fn totals(study: &Study, summary: &Summary) -> String {
    // Credit beyond the sheet does not exist, but rounding up may pass the end.
    let most = study.most.max(summary.greatest);
    let classes = if study.totals.len() >= MANY { 26 } else { 16 };
    let histogram = spread::histogram(&study.totals, most, classes);
    let end = |i: usize| histogram.from + i as f64 * histogram.width;
    let classes = histogram.counts.iter().enumerate().map(|(i, n)| (end(i), end(i + 1), *n)).collect();
    let few = study.totals.len() < FEW;
    let description = format!(
        "Totals of {} students: median {}, half of them from {} to {}, all from {} to {} of {} points. {}",
        summary.n,
        points(summary.median),
        points(summary.lower),
        points(summary.upper),
        points(summary.least),
        points(summary.greatest),
        points(study.most),
        if few { "A dot for each student." } else { "Columns count the students." }
    );
    SpreadChart {
        id: "plot-totals".to_owned(),
        title: "Distribution of the totals".to_owned(),
        description,
        axis: axis(
            &format!("points of {}", points(study.most)),
            if few { 0.0 } else { histogram.from },
            if few { most } else { end(histogram.counts.len()) },
        ),
        classes,
        dots: if few { study.totals.clone() } else { Vec::new() },
        line: Some((summary.median, format!("median {}", points(summary.median)))),
        what: "students".to_owned(),
    }
    .svg()
}

/// Success of each part.
pub fn success(marks: &Marks, study: &Study) -> String {
    let rows: Vec<ChartRow> = study
        .parts
        .iter()
        .enumerate()
        .map(|(p, part)| {
            let success = part.success.filter(|_| part.answered >= LEAST_FOR_SHARE);
            ChartRow {
                label: marks.class.parts[p].label(),
                words: String::new(),
                value: success.map(|s| s.value),
                interval: success.map(|s| (s.low, s.high)),
                note: format!("{} of {}", part.right, part.answered),
                marked: false,
            }
        })
        .collect();
    let told: Vec<String> = rows.iter().map(|r| format!("{}: {}", r.label, r.note)).collect();
    RowChart {
        id: "plot-parts".to_owned(),
        title: "Right answers".to_owned(),
        description: format!("Right answers of those that count, part by part. {}.", told.join("; ")),
        axis: axis("share of the answers that count", 0.0, 1.0),
        percent: true,
        bars: true,
        rows,
    }
    .svg()
}

/// Ease against discrimination; `None` if no part has both.
pub fn items(marks: &Marks, study: &Study) -> Option<String> {
    let spots: Vec<Spot> = study
        .parts
        .iter()
        .enumerate()
        .filter_map(|(p, part)| {
            let (x, y) = (part.ease?, *part.discrimination.as_ref().ok()?);
            Some(Spot { x, y, label: marks.class.parts[p].label(), marked: y < POOR })
        })
        .collect();
    if spots.is_empty() {
        return None;
    }
    let told: Vec<String> =
        spots.iter().map(|s| format!("{} {} and {}", s.label, percent(s.x), fixed(s.y, 2))).collect();
    let y = Axis::around("discrimination", AxisScale::Linear, spots.iter().map(|s| s.y).chain([0.0, 0.4]));
    Some(
        ScatterChart {
            id: "plot-items".to_owned(),
            title: "Ease and discrimination of the parts".to_owned(),
            description: format!("Ease of each part, then its discrimination: {}.", told.join("; ")),
            x: axis("ease: mean share of the points", 0.0, 1.0),
            y,
            level: Some((POOR, "orange: below 0.2, hardly tells strong from weak".to_owned())),
            spots,
        }
        .svg(),
    )
}

/// Wrong methods by students: ids, words, how many.
pub fn mistakes(marks: &Marks, methods: &[(String, String, usize)]) -> String {
    const MOST: usize = 12;
    let most = methods.iter().map(|m| m.2).max().unwrap_or(1);
    let rows: Vec<ChartRow> = (methods.iter().take(MOST))
        .map(|(ids, words, students)| ChartRow {
            label: ids.clone(),
            words: words.clone(),
            value: Some(*students as f64),
            interval: None,
            note: students.to_string(),
            marked: false,
        })
        .collect();
    let told: Vec<String> = rows.iter().map(|r| format!("{}: {}", r.label, r.note)).collect();
    let mut axis = Axis::around("students", AxisScale::Linear, [0.0, most as f64].into_iter());
    axis.high = axis.high.max(4.0);
    let all = marks.class.students.len();
    RowChart {
        id: "plot-mistakes".to_owned(),
        title: "Students with each wrong method".to_owned(),
        description: format!(
            "Students, of {all}, with an answer that fits a wrong method. {}.",
            told.join("; ")
        ),
        axis,
        percent: false,
        bars: true,
        rows,
    }
    .svg()
}

/// Correlations of the marks of a problem with its data; `None` if there are none.
pub fn fairness(title: &str, study: &Study, problem: usize) -> Option<String> {
    let rows: Vec<ChartRow> = study
        .fairness
        .iter()
        .filter(|c| c.problem == problem)
        .filter_map(|c| {
            let rho = c.rho?;
            Some(ChartRow {
                label: c.datum.clone(),
                words: String::new(),
                value: Some(rho.value),
                interval: Some((rho.low, rho.high)),
                note: fixed(rho.value, 2),
                marked: c.corrected < LEVEL,
            })
        })
        .collect();
    if rows.is_empty() {
        return None;
    }
    let told: Vec<String> = rows.iter().map(|r| format!("{}: {}", r.label, r.note)).collect();
    let widest =
        rows.iter().filter_map(|r| r.interval).fold(0.0, |w: f64, (a, b)| w.max(a.abs()).max(b.abs()));
    let reach = [0.25, 0.5, 1.0].into_iter().find(|r| widest <= *r).unwrap_or(1.0);
    Some(
        RowChart {
            id: format!("plot-fairness-{}", problem + 1),
            title: title.to_owned(),
            description: format!("Correlation of the marks with each datum. {}.", told.join("; ")),
            axis: axis("correlation of the marks with the datum, with its 95 % interval", -reach, reach),
            percent: false,
            bars: false,
            rows,
        }
        .svg(),
    )
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
