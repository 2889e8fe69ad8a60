//! How numbers are spread: columns of a histogram, or a dot for each of a few.
use crate::picture::vector::vec2;
use crate::plot::axis::{Axis, AxisScale};
use crate::plot::chart::{Caption, Chart};
use crate::plot::rows::WIDTH;

/// A chart of a list of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct SpreadChart {
    pub caption: Caption,
    /// The axis of the numbers; it holds all classes.
    pub axis: Axis,
    /// Classes: lower end, upper end, how many numbers lie between.
    pub classes: Vec<(f64, f64, usize)>,
    /// Each number, where there are so few that a dot for each says more; empty: columns.
    pub dots: Vec<f64>,
    /// Where a line stands, and what it is: median.
    pub line: Option<(f64, String)>,
    /// Names the second axis: students.
    pub what: String,
}

const LEFT: f64 = 46.0;
const RIGHT: f64 = 464.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 246.0;
const HEIGHT: f64 = 292.0;
const DOT: f64 = 5.5;

impl SpreadChart {
    /// The chart as SVG text: the same bytes for the same data.
    pub fn svg(&self) -> String {
        let (top, bottom) = (TOP, if self.dots.is_empty() { BOTTOM } else { self.dots_bottom() });
        let size = vec2(WIDTH, HEIGHT - BOTTOM + bottom);
        let mut chart = Chart::new(&self.caption, size, vec2(8.0, 22.0));
        let place = |v: f64| LEFT + self.axis.at(v) * (RIGHT - LEFT);
        if self.dots.is_empty() {
            let most = self.classes.iter().map(|c| c.2).max().unwrap_or(1).max(1) as f64;
            let mut upright = Axis::around(&self.what, AxisScale::Linear, [0.0, most].into_iter());
            // Students are counted in whole numbers: an axis of fewer than four would have ticks between them.
            upright.high = upright.high.max(4.0);
            for tick in upright.ticks().into_iter().filter(|t| !t.label.contains('.')) {
                let y = bottom - tick.at * (bottom - top);
                chart.line("grid", vec2(LEFT, y), vec2(RIGHT, y));
                chart.text("soft tiny", "end", vec2(LEFT - 7.0, y + 4.0), &tick.label);
            }
            for (from, to, count) in self.classes.iter().filter(|(.., c)| *c > 0) {
                let high = *count as f64 / upright.high * (bottom - top);
                let (from, to) = (place(*from), place(*to));
                let gap = if to - from > 8.0 { 1.0 } else { 0.3 };
                chart.rect("bar", vec2(from + gap, bottom - high), vec2(to - from - 2.0 * gap, high));
            }
            chart.upright("soft tiny", vec2(14.0, (top + bottom) / 2.0), &self.what);
        } else {
            // Dots are stacked where they would touch.
            let mut sorted = self.dots.clone();
            sorted.sort_by(f64::total_cmp);
            let mut placed: Vec<(f64, usize)> = Vec::new();
            for value in sorted {
                let x = place(value);
                let touching = placed.iter().filter(|(other, _)| (x - other).abs() < 2.0 * DOT);
                let used: Vec<usize> = touching.map(|(_, level)| *level).collect();
                let level = (0..).find(|l| !used.contains(l)).unwrap_or(0);
                chart.circle("dot", vec2(x, bottom - DOT - 2.0 - level as f64 * 2.0 * DOT), DOT);
                placed.push((x, level));
            }
        }
        chart.line("frame", vec2(LEFT, bottom), vec2(RIGHT, bottom));
        for tick in self.axis.ticks() {
            let x = LEFT + tick.at * (RIGHT - LEFT);
            chart.line("frame", vec2(x, bottom), vec2(x, bottom + 4.0));
            chart.text("soft tiny", "middle", vec2(x, bottom + 18.0), &tick.label);
        }
        chart.text("soft tiny", "middle", vec2((LEFT + RIGHT) / 2.0, bottom + 38.0), &self.axis.label);
        if let Some((value, says)) = &self.line {
            let x = place(*value);
            chart.line("mid", vec2(x, top - 6.0), vec2(x, bottom));
            // Above the columns, within the chart.
            let anchor = match x {
                x if x > RIGHT - 60.0 => "end",
                x if x < LEFT + 60.0 => "start",
                _ => "middle",
            };
            chart.text("tiny halo", anchor, vec2(x, top - 10.0), says);
        }
        chart.finish()
    }

    /// As many dots as could stand on each other find room.
    fn dots_bottom(&self) -> f64 {
        let place = |v: &f64| LEFT + self.axis.at(*v) * (RIGHT - LEFT);
        let near = |v: &f64| self.dots.iter().filter(|o| (place(o) - place(v)).abs() < 2.0 * DOT).count();
        let most = self.dots.iter().map(near).max().unwrap_or(1) as f64;
        TOP + 16.0 + (most * 2.0 * DOT).max(40.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(dots: Vec<f64>) -> SpreadChart {
        SpreadChart {
            caption: Caption::new("h", "totals", "d"),
            axis: Axis { label: "points".to_owned(), scale: AxisScale::Linear, low: 0.0, high: 10.0 },
            classes: vec![(0.0, 2.5, 1), (2.5, 5.0, 0), (5.0, 7.5, 3), (7.5, 10.0, 2)],
            dots,
            line: Some((7.0, "median 7".to_owned())),
            what: "students".to_owned(),
        }
    }

    #[test]
    fn columns_or_dots() {
        let columns = chart(Vec::new()).svg();
        assert_eq!(columns.matches("class=\"bar\"").count(), 3);
        let dots = chart(vec![1.0, 1.0, 1.0, 9.0]).svg();
        assert_eq!(dots.matches("class=\"dot\"").count(), 4);
        assert_eq!(dots.matches("class=\"bar\"").count(), 0);
        assert!(!columns.contains("NaN") && !columns.contains("0.5</text>"));
    }
}
