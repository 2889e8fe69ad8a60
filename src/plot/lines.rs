//! Lines with marks over two axes.
use crate::picture::vector::{Vec2, vec2};
use crate::plot::axis::Axis;
use crate::plot::chart::{Caption, Chart};

/// A point of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DataPoint {
    /// Along the first axis.
    pub x: f64,
    /// Along the second.
    pub y: f64,
    /// Filled marks stand out from hollow ones.
    pub filled: bool,
    /// With a ring round it.
    pub ringed: bool,
}

/// Points joined by a line, with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Which colour, mark and dash, so that a series looks the same on every figure.
    pub style: usize,
    /// The points, in the order in which they are joined.
    pub points: Vec<DataPoint>,
}

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    pub caption: Caption,
    /// First axis.
    pub x: Axis,
    /// Second axis.
    pub y: Axis,
    pub series: Vec<Series>,
    /// What filled and ringed marks mean, below the legend.
    pub notes: Vec<String>,
}

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 460.0;
const LEFT: f64 = 74.0;
const RIGHT: f64 = 594.0;
const TOP: f64 = 48.0;
const BOTTOM: f64 = 400.0;
/// Room between the frame and the points at the ends of an axis.
const INSET: f64 = 14.0;

impl LineChart {
    fn place(&self, x: f64, y: f64) -> Vec2 {
        vec2(
            LEFT + INSET + self.x.at(x) * (RIGHT - LEFT - 2.0 * INSET),
            BOTTOM - INSET - self.y.at(y) * (BOTTOM - TOP - 2.0 * INSET),
        )
    }

    /// The figure as SVG text: the same bytes for the same data.
    pub fn svg(&self) -> String {
        let mut chart = Chart::new(&self.caption, vec2(WIDTH, HEIGHT), vec2(LEFT, 28.0));
        for tick in self.x.ticks() {
            let x = LEFT + INSET + tick.at * (RIGHT - LEFT - 2.0 * INSET);
            if tick.label.is_empty() {
                chart.line("frame", vec2(x, BOTTOM), vec2(x, BOTTOM + 3.0));
            } else {
                chart.line("grid", vec2(x, TOP), vec2(x, BOTTOM));
                chart.line("frame", vec2(x, BOTTOM), vec2(x, BOTTOM + 6.0));
                chart.text("", "middle", vec2(x, BOTTOM + 22.0), &tick.label);
            }
        }
        for tick in self.y.ticks() {
            let y = BOTTOM - INSET - tick.at * (BOTTOM - TOP - 2.0 * INSET);
            if tick.label.is_empty() {
                chart.line("frame", vec2(LEFT - 3.0, y), vec2(LEFT, y));
            } else {
                chart.line("grid", vec2(LEFT, y), vec2(RIGHT, y));
                chart.line("frame", vec2(LEFT - 6.0, y), vec2(LEFT, y));
                chart.text("", "end", vec2(LEFT - 9.0, y + 4.5), &tick.label);
            }
        }
        chart.rect("frame", vec2(LEFT, TOP), vec2(RIGHT - LEFT, BOTTOM - TOP));
        chart.text("soft", "middle", vec2((LEFT + RIGHT) / 2.0, BOTTOM + 46.0), &self.x.label);
        chart.upright("soft", vec2(20.0, (TOP + BOTTOM) / 2.0), &self.y.label);
        for series in &self.series {
            let places: Vec<Vec2> = series.points.iter().map(|p| self.place(p.x, p.y)).collect();
            if places.len() > 1 {
                chart.polyline(series.style, &places);
            }
        }
        for series in &self.series {
            for point in &series.points {
                let at = self.place(point.x, point.y);
                chart.mark(series.style, at, point.filled);
                if point.ringed {
                    chart.circle("ring", at, 10.0);
                }
            }
        }
        let (x, mut y) = (RIGHT + 18.0, TOP + 12.0);
        for series in &self.series {
            chart.polyline(series.style, &[vec2(x, y), vec2(x + 34.0, y)]);
            chart.mark(series.style, vec2(x + 17.0, y), true);
            chart.text("", "start", vec2(x + 43.0, y + 4.5), &series.name);
            y += 23.0;
        }
        y += 10.0;
        for note in &self.notes {
            chart.text("soft", "start", vec2(x, y), note);
            y += 17.0;
        }
        chart.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::AxisScale;

    #[test]
    fn a_figure_is_well_formed_escaped_and_the_same_every_time() {
        let figure = LineChart {
            caption: Caption::new("f", "a < b & c", "two points"),
            x: Axis::around("cost", AxisScale::Log, [1.0, 100.0].into_iter()),
            y: Axis::around("error", AxisScale::Log, [1e-3, 1.0].into_iter()),
            series: (0..8)
                .map(|style| Series {
                    name: format!("series {style}"),
                    style,
                    points: vec![
                        DataPoint { x: 1.0, y: 1e-3, filled: true, ringed: true },
                        DataPoint { x: 100.0, y: 0.0, filled: false, ringed: false },
                    ],
                })
                .collect(),
            notes: vec!["filled: best".to_owned()],
        };
        let svg = figure.svg();
        assert_eq!(svg, figure.svg());
        assert!(svg.contains("<title id=\"f-t\">a &lt; b &amp; c</title>") && svg.ends_with("</svg>\n"));
        assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("-0.0\""), "{svg}");
        let count = |word: &str| svg.matches(word).count();
        assert_eq!(count("class=\"line\""), 16, "a line for each series, and in the legend");
        assert_eq!(count("class=\"mark\""), 24);
        assert_eq!(count("class=\"ring\""), 8);
        // Every element that opens is closed.
        assert_eq!(count("<text"), count("</text>"));
        assert_eq!(count("<svg"), count("</svg>"));
    }
}
