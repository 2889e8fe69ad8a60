//! The surface on which charts are drawn: the elements of all pictures, in the classes of charts, with marks of series.
use crate::picture::svg::Svg;
use crate::picture::symbol::run;
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{RunStyle, svg};

/// Ink, paper and the colours of series, light and dark: Okabe and Ito, lightened where they stand on dark.
const STYLE: &str = "\
.plot{--ink:#1b1f24;--paper:#fff;--soft:#5c6570;--grid:#e3e7ec;--c0:#1b1f24;--c1:#0072b2;--c2:#d55e00;--c3:#00805c;--c4:#b0528f;--c5:#a86f00;--c6:#6b7280;font-family:system-ui,-apple-system,\"Segoe UI\",\"Liberation Sans\",Arial,sans-serif}\
@media(prefers-color-scheme:dark){.plot{--ink:#e4e7eb;--paper:#14171b;--soft:#9aa4b0;--grid:#2a3037;--c0:#e4e7eb;--c1:#56b4e9;--c2:#ff8a3d;--c3:#2fc89a;--c4:#e39ac8;--c5:#e6b43c;--c6:#9aa4b0}}\
@media print{.plot{--ink:#000;--paper:#fff;--soft:#444;--grid:#ddd;--c0:#000;--c1:#0072b2;--c2:#d55e00;--c3:#00805c;--c4:#b0528f;--c5:#a86f00;--c6:#6b7280}}\
.plot text{fill:var(--ink)}.plot .soft{fill:var(--soft)}.plot .head{font-weight:600}\
.plot .paper{fill:var(--paper)}.plot .grid{stroke:var(--grid);stroke-width:1;fill:none}.plot .frame{stroke:var(--soft);stroke-width:1;fill:none}\
.plot .line{fill:none;stroke-width:1.6;stroke-linejoin:round}.plot .mark{stroke-width:1.6;stroke-linejoin:round}.plot .ring{fill:none;stroke:var(--ink);stroke-width:1.4}\
.plot .bar{fill:var(--c1);fill-opacity:.82}.plot .dot{fill:var(--c1);stroke:var(--paper);stroke-width:.8}\
.plot .warn{fill:var(--c2);stroke:var(--paper);stroke-width:.8}.plot .whisker{stroke:var(--ink);stroke-width:1.5;fill:none}.plot .mid{stroke:var(--c2);stroke-width:1.6;fill:none}\
.plot .halo{paint-order:stroke;stroke:var(--paper);stroke-width:3px;stroke-linejoin:round}";

/// Number of colours of series.
const COLOURS: usize = 7;
/// Dashes of series, in their order.
const DASHES: [&str; 7] = ["", "", "7 3", "2 3", "10 3 2 3", "5 2", "1 2"];

/// What every chart says of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Caption {
    /// Tells the figures of a page apart.
    pub id: String,
    pub title: String,
    /// What it shows, for those who do not see it.
    pub description: String,
}

impl Caption {
    pub fn new(id: impl Into<String>, title: impl Into<String>, description: impl Into<String>) -> Self {
        Self { id: id.into(), title: title.into(), description: description.into() }
    }
}

/// A chart being drawn.
#[derive(Debug, Clone)]
pub struct Chart(Svg);

impl Chart {
    /// Begins a chart of this size, with its title here.
    pub fn new(caption: &Caption, size: Vec2, head: Vec2) -> Self {
        let Caption { id, title, description } = caption;
        let style = format!("<style>{STYLE}</style>");
        let mut svg = Svg::after(svg::opening("plot", id, size, (title, description), &style));
        svg.rect("class=\"paper\"", Vec2::ZERO, size);
        let mut chart = Self(svg);
        chart.text("head", "start", head, title);
        chart
    }
    /// A straight line.
    pub fn line(&mut self, class: &str, from: Vec2, to: Vec2) {
        self.0.lines(format_args!("class=\"{class}\""), &[from, to], false);
    }
    /// A rectangle, from its upper left corner.
    pub fn rect(&mut self, class: &str, corner: Vec2, size: Vec2) {
        self.0.rect(format_args!("class=\"{class}\""), corner, size);
    }
    /// A circle, full or a ring.
    pub fn circle(&mut self, class: &str, centre: Vec2, radius: f64) {
        self.0.circle(format_args!("class=\"{class}\""), centre, radius);
    }
    /// A text; `anchor` is `start`, `middle` or `end`. `^{-3}` raises. Headings are larger, what is `tiny` is smaller.
    pub fn text(&mut self, class: &str, anchor: &str, at: Vec2, text: &str) {
        self.label(class, at, format_args!(" text-anchor=\"{anchor}\""), text);
    }
    /// A text that reads upwards.
    pub fn upright(&mut self, class: &str, at: Vec2, text: &str) {
        let (x, y) = (svg::Px(at.x), svg::Px(at.y));
        let more = format_args!(" text-anchor=\"middle\" transform=\"rotate(-90 {x} {y})\"");
        self.label(class, at, more, text);
    }
    fn label(&mut self, class: &str, at: Vec2, more: std::fmt::Arguments, text: &str) {
        let size = match class {
            "head" => 15.0,
            _ if class.contains("tiny") => 11.0,
            _ => 13.0,
        };
        let mut pieces = text.split("^{");
        let mut runs = vec![run(pieces.next().unwrap_or_default(), RunStyle::Upright)];
        for piece in pieces {
            let (power, after) = piece.split_once('}').unwrap_or((piece, ""));
            runs.extend([run(power, RunStyle::Super), run(after, RunStyle::Upright)]);
        }
        runs.retain(|r| !r.text.is_empty());
        self.0.label(class, at, size, more, &runs);
    }
    /// A line through points, in a colour and with the dash of a series.
    pub fn polyline(&mut self, series: usize, points: &[Vec2]) {
        let (colour, dash) = (series % COLOURS, DASHES[series % DASHES.len()]);
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        self.0.lines(format_args!("class=\"line\" stroke=\"var(--c{colour})\"{dash}"), points, false);
    }
    /// The mark of a series at a place, filled or hollow.
    pub fn mark(&mut self, series: usize, at: Vec2, filled: bool) {
        let colour = series % COLOURS;
        let fill = if filled { format!("var(--c{colour})") } else { "var(--paper)".to_owned() };
        let look = format_args!("class=\"mark\" stroke=\"var(--c{colour})\" fill=\"{fill}\"");
        let corners: &[(f64, f64)] = match series % 7 {
            0 => &STAR,
            1 => return self.0.circle(look, at, 4.0),
            2 => &[(-3.7, -3.7), (3.7, -3.7), (3.7, 3.7), (-3.7, 3.7)],
            3 => &[(0.0, -5.0), (4.6, 3.2), (-4.6, 3.2)],
            4 => &[(0.0, -5.3), (5.3, 0.0), (0.0, 5.3), (-5.3, 0.0)],
            5 => &[(0.0, 5.0), (4.6, -3.2), (-4.6, -3.2)],
            _ => &CROSS,
        };
        let corners: Vec<Vec2> = corners.iter().map(|(x, y)| at + vec2(*x, *y)).collect();
        self.0.lines(look, &corners, true);
    }
    /// The finished text.
    pub fn finish(self) -> String {
        self.0.into_text() + "</svg>\n"
    }
}

/// A star of five points, radius 6.4.
#[rustfmt::skip] // a table
const STAR: [(f64, f64); 10] = [
    (0.0, -6.4), (1.5, -2.1), (6.1, -2.0), (2.4, 0.8), (3.8, 5.2), (0.0, 2.5), (-3.8, 5.2), (-2.4, 0.8),
    (-6.1, -2.0), (-1.5, -2.1),
];

/// A cross of arms with thickness.
#[rustfmt::skip] // a table
const CROSS: [(f64, f64); 12] = [
    (-1.6, -5.0), (1.6, -5.0), (1.6, -1.6), (5.0, -1.6), (5.0, 1.6), (1.6, 1.6), (1.6, 5.0), (-1.6, 5.0),
    (-1.6, 1.6), (-5.0, 1.6), (-5.0, -1.6), (-1.6, -1.6),
];
