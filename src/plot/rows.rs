//! One row for each thing: a bar or a mark, with its interval.
use crate::picture::vector::vec2;
use crate::plot::axis::Axis;
use crate::plot::chart::{Caption, Chart};

#[derive(Debug, Clone, PartialEq)]
pub struct ChartRow {
    /// Name, to the left.
    pub label: String,
    /// A line of words above the bar, cut where the chart ends; empty for none.
    pub words: String,
    /// Value; a row without one says why in its note.
    pub value: Option<f64>,
    /// Interval, both ends.
    pub interval: Option<(f64, f64)>,
    /// To the right.
    pub note: String,
    /// In the second colour.
    pub marked: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub struct RowChart {
    pub caption: Caption,
    pub axis: Axis,
    /// Labels of ticks are per cent.
    pub percent: bool,
    /// Bars from the low end of the axis, else marks and a line at 0.
    pub bars: bool,
    /// The rows, from above.
    pub rows: Vec<ChartRow>,
}

/// Width of charts: on a phone their letters are still read.
pub const WIDTH: f64 = 480.0;
const STEP: f64 = 24.0;
const TOP: f64 = 40.0;
/// About how wide a letter is, and how far a label may reach.
const LETTER: f64 = 7.8;
const WIDEST: f64 = 220.0;
/// Height of a line of words, and about how wide one of its letters is.
const WORDS: f64 = 16.0;
const SMALL: f64 = 6.2;

impl RowChart {
    /// The chart as SVG text: the same bytes for the same data.
    pub fn svg(&self) -> String {
        let longest =
            |text: &dyn Fn(&ChartRow) -> usize| self.rows.iter().map(text).max().unwrap_or(0) as f64 * LETTER;
        let left = (longest(&|r| r.label.chars().count()) + 14.0).clamp(40.0, WIDEST);
        let right = WIDTH - (longest(&|r| r.note.chars().count()) + 12.0).clamp(16.0, 120.0);
        let worded = self.rows.iter().any(|r| !r.words.is_empty());
        let step = if worded { STEP + WORDS } else { STEP };
        let bottom = TOP + self.rows.len() as f64 * step + 4.0;
        let mut chart = Chart::new(&self.caption, vec2(WIDTH, bottom + 44.0), vec2(8.0, 22.0));
        let place = |value: f64| left + self.axis.at(value) * (right - left);
        for tick in self.axis.ticks() {
            let x = left + tick.at * (right - left);
            chart.line("grid", vec2(x, TOP), vec2(x, bottom));
            let label = if self.percent { tick.percent() } else { tick.signed() };
            chart.text("soft tiny", "middle", vec2(x, bottom + 16.0), &label);
        }
        chart.text("soft tiny", "middle", vec2((left + right) / 2.0, bottom + 34.0), &self.axis.label);
        let base = if self.bars { place(self.axis.low) } else { place(0.0) };
        chart.line("frame", vec2(base, TOP), vec2(base, bottom));
        for (i, row) in self.rows.iter().enumerate() {
            let y = TOP + (i as f64 + 1.0) * step - 0.5 * STEP + 2.0;
            if !row.words.is_empty() {
                let most = ((WIDTH - left) / SMALL) as usize;
                chart.text("soft tiny", "start", vec2(left + 2.0, y - 12.0), &shortened(&row.words, most));
            }
            chart.text(
                "",
                "end",
                vec2(left - 8.0, y + 4.5),
                &shortened(&row.label, ((WIDEST - 14.0) / LETTER) as usize),
            );
            chart.text("soft tiny", "start", vec2(right + 8.0, y + 4.0), &row.note);
            let Some(value) = row.value else { continue };
            if self.bars {
                let class = if row.marked { "warn" } else { "bar" };
                chart.rect(class, vec2(base, y - 7.5), vec2((place(value) - base).max(0.0), 15.0));
            }
            if let Some((low, high)) = row.interval {
                let (a, b) = (place(low), place(high));
                chart.line("whisker", vec2(a, y), vec2(b, y));
                for end in [a, b] {
                    chart.line("whisker", vec2(end, y - 3.5), vec2(end, y + 3.5));
                }
            }
            if !self.bars {
                chart.circle(if row.marked { "warn" } else { "dot" }, vec2(place(value), y), 5.0);
            }
        }
        chart.finish()
    }
}

/// A text of at most so many letters.
pub fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most.saturating_sub(1)).chain(std::iter::once('…')).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::AxisScale;

    #[test]
    fn bars_are_as_long_as_their_values() {
        let row = |label: &str, value| ChartRow {
            label: label.to_owned(),
            words: String::new(),
            value,
            interval: value.map(|v| (v - 0.1, v + 0.1)),
            note: "n".to_owned(),
            marked: false,
        };
        let chart = RowChart {
            caption: Caption::new("r", "a & b", "three rows"),
            axis: Axis { label: "share".to_owned(), scale: AxisScale::Linear, low: 0.0, high: 1.0 },
            percent: true,
            bars: true,
            rows: vec![
                row("one", Some(0.25)),
                row("two", Some(0.75)),
                row("a very long name of a part, longer than any", None),
            ],
        };
        let svg = chart.svg();
        assert_eq!(svg, chart.svg());
        let widths: Vec<f64> = svg
            .lines()
            .filter(|l| l.contains("class=\"bar\""))
            .filter_map(|l| l.split("width=\"").nth(1)?.split('"').next()?.parse().ok())
            .collect();
        assert_eq!(widths.len(), 2);
        assert!((widths[1] / widths[0] - 3.0).abs() < 0.01, "{widths:?}");
        assert!(svg.contains("a &amp; b") && svg.contains("100 %") && svg.contains("…</text>"));
        assert!(!svg.contains("NaN"));
    }
}
