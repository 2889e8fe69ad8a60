//! Lines with marks over two axes.
use crate::plot::axis::Axis;
use crate::plot::svg::Svg;

/// A point of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
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
    pub points: Vec<Point>,
}

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Tells the figures of a page apart.
    pub id: String,
    /// Title.
    pub title: String,
    /// What it shows, for those who do not see it.
    pub description: String,
    /// First axis.
    pub x: Axis,
    /// Second axis.
    pub y: Axis,
    /// The series.
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

impl Figure {
    fn place(&self, x: f64, y: f64) -> (f64, f64) {
        (
            LEFT + INSET + self.x.at(x) * (RIGHT - LEFT - 2.0 * INSET),
            BOTTOM - INSET - self.y.at(y) * (BOTTOM - TOP - 2.0 * INSET),
        )
    }

    /// The figure as SVG text: the same bytes for the same data.
    pub fn svg(&self) -> String {
        let mut svg = Svg::new(&self.id, WIDTH, HEIGHT, &self.title, &self.description);
        svg.text("head", "start", (LEFT, 28.0), &self.title);
        for tick in self.x.ticks() {
            let x = LEFT + INSET + tick.at * (RIGHT - LEFT - 2.0 * INSET);
            if tick.label.is_empty() {
                svg.line("frame", (x, BOTTOM), (x, BOTTOM + 3.0));
            } else {
                svg.line("grid", (x, TOP), (x, BOTTOM));
                svg.line("frame", (x, BOTTOM), (x, BOTTOM + 6.0));
                svg.text("", "middle", (x, BOTTOM + 22.0), &tick.label);
            }
        }
        for tick in self.y.ticks() {
            let y = BOTTOM - INSET - tick.at * (BOTTOM - TOP - 2.0 * INSET);
            if tick.label.is_empty() {
                svg.line("frame", (LEFT - 3.0, y), (LEFT, y));
            } else {
                svg.line("grid", (LEFT, y), (RIGHT, y));
                svg.line("frame", (LEFT - 6.0, y), (LEFT, y));
                svg.text("", "end", (LEFT - 9.0, y + 4.5), &tick.label);
            }
        }
        svg.rect("frame", (LEFT, TOP), (RIGHT - LEFT, BOTTOM - TOP));
        svg.text("soft", "middle", ((LEFT + RIGHT) / 2.0, BOTTOM + 46.0), &self.x.label);
        svg.upright("soft", (20.0, (TOP + BOTTOM) / 2.0), &self.y.label);
        for series in &self.series {
            let places: Vec<(f64, f64)> = series.points.iter().map(|p| self.place(p.x, p.y)).collect();
            if places.len() > 1 {
                svg.polyline(series.style, &places);
            }
        }
        for series in &self.series {
            for point in &series.points {
                let at = self.place(point.x, point.y);
                svg.mark(series.style, at, point.filled);
                if point.ringed {
                    svg.ring(at, 10.0);
                }
            }
        }
        let (x, mut y) = (RIGHT + 18.0, TOP + 12.0);
        for series in &self.series {
            svg.polyline(series.style, &[(x, y), (x + 34.0, y)]);
            svg.mark(series.style, (x + 17.0, y), true);
            svg.text("", "start", (x + 43.0, y + 4.5), &series.name);
            y += 23.0;
        }
        y += 10.0;
        for note in &self.notes {
            svg.text("soft", "start", (x, y), note);
            y += 17.0;
        }
        svg.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Scale;

    #[test]
    fn a_figure_is_well_formed_escaped_and_the_same_every_time() {
        let figure = Figure {
            id: "f".to_owned(),
            title: "a < b & c".to_owned(),
            description: "two points".to_owned(),
            x: Axis::around("cost", Scale::Log, [1.0, 100.0].into_iter()),
            y: Axis::around("error", Scale::Log, [1e-3, 1.0].into_iter()),
            series: (0..8)
                .map(|style| Series {
                    name: format!("series {style}"),
                    style,
                    points: vec![
                        Point { x: 1.0, y: 1e-3, filled: true, ringed: true },
                        Point { x: 100.0, y: 0.0, filled: false, ringed: false },
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
