//! SVG elements as text, with fixed decimals.
use std::fmt::Write as _;

/// An SVG picture being written.
#[derive(Debug, Clone)]
pub struct Svg {
    text: String,
}

/// A coordinate with one decimal; never `-0.0`.
pub fn px(x: f64) -> String {
    let text = format!("{x:.1}");
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

/// A text for XML.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}

/// Ink, paper and the colours of series, light and dark: Okabe and Ito, lightened where they stand on dark.
const STYLE: &str = "\
.plot{--ink:#1b1f24;--paper:#fff;--soft:#5c6570;--grid:#e3e7ec;--c0:#1b1f24;--c1:#0072b2;--c2:#d55e00;--c3:#00805c;--c4:#b0528f;--c5:#a86f00;--c6:#6b7280;font:13px/1.2 system-ui,-apple-system,\"Segoe UI\",\"Liberation Sans\",Arial,sans-serif}\
@media(prefers-color-scheme:dark){.plot{--ink:#e4e7eb;--paper:#14171b;--soft:#9aa4b0;--grid:#2a3037;--c0:#e4e7eb;--c1:#56b4e9;--c2:#ff8a3d;--c3:#2fc89a;--c4:#e39ac8;--c5:#e6b43c;--c6:#9aa4b0}}\
@media print{.plot{--ink:#000;--paper:#fff;--soft:#444;--grid:#ddd;--c0:#000;--c1:#0072b2;--c2:#d55e00;--c3:#00805c;--c4:#b0528f;--c5:#a86f00;--c6:#6b7280}}\
.plot text{fill:var(--ink)}.plot .soft{fill:var(--soft)}.plot .head{font-weight:600;font-size:15px}.plot .small{font-size:10px}\
.plot .paper{fill:var(--paper)}.plot .grid{stroke:var(--grid);stroke-width:1;fill:none}.plot .frame{stroke:var(--soft);stroke-width:1;fill:none}\
.plot .line{fill:none;stroke-width:1.6;stroke-linejoin:round}.plot .mark{stroke-width:1.6;stroke-linejoin:round}.plot .ring{fill:none;stroke:var(--ink);stroke-width:1.4}";

/// What charts add.
const CHARTS: &str = "\
.plot .bar{fill:var(--c1);fill-opacity:.82}.plot .faint{fill:var(--grid)}.plot .dot{fill:var(--c1);stroke:var(--paper);stroke-width:.8}\
.plot .warn{fill:var(--c2);stroke:var(--paper);stroke-width:.8}.plot .whisker{stroke:var(--ink);stroke-width:1.5;fill:none}.plot .mid{stroke:var(--c2);stroke-width:1.6;fill:none}\
.plot .tiny{font-size:11px}.plot .halo{paint-order:stroke;stroke:var(--paper);stroke-width:3px;stroke-linejoin:round}";

/// Number of colours of series.
pub const COLOURS: usize = 7;
/// Dashes of series, in their order.
pub const DASHES: [&str; 7] = ["", "", "7 3", "2 3", "10 3 2 3", "5 2", "1 2"];

impl Svg {
    /// Begins a picture of this size with a title and a description for those who do not see it. `id` tells the pictures of one
    /// page apart.
    pub fn new(id: &str, width: f64, height: f64, title: &str, description: &str) -> Self {
        Self::styled(id, (width, height), title, description, "")
    }
    /// The same for charts: with bars, whiskers, boxes.
    pub fn chart(id: &str, (width, height): (f64, f64), title: &str, description: &str) -> Self {
        Self::styled(id, (width, height), title, description, CHARTS)
    }
    fn styled(id: &str, (width, height): (f64, f64), title: &str, description: &str, more: &str) -> Self {
        let mut text = String::with_capacity(8192);
        let (w, h) = (px(width), px(height));
        let _ = write!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" aria-labelledby=\"{id}-t {id}-d\">\n<title id=\"{id}-t\">{}</title>\n<desc id=\"{id}-d\">{}</desc>\n<style>{STYLE}{more}</style>\n<rect class=\"paper\" width=\"{w}\" height=\"{h}\"/>\n",
            escaped(title),
            escaped(description)
        );
        Self { text }
    }
    /// A straight line.
    pub fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        let _ = writeln!(
            self.text,
            "<line class=\"{class}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>",
            px(from.0),
            px(from.1),
            px(to.0),
            px(to.1)
        );
    }
    /// A rectangle.
    pub fn rect(&mut self, class: &str, at: (f64, f64), size: (f64, f64)) {
        let _ = writeln!(
            self.text,
            "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
            px(at.0),
            px(at.1),
            px(size.0),
            px(size.1)
        );
    }
    /// A text; `anchor` is `start`, `middle` or `end`. `^{-3}` raises.
    pub fn text(&mut self, class: &str, anchor: &str, at: (f64, f64), text: &str) {
        let _ = writeln!(
            self.text,
            "<text class=\"{class}\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{}</text>",
            px(at.0),
            px(at.1),
            raised(text)
        );
    }
    /// A text that reads upwards.
    pub fn upright(&mut self, class: &str, at: (f64, f64), text: &str) {
        let (x, y) = (px(at.0), px(at.1));
        let _ = writeln!(
            self.text,
            "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" transform=\"rotate(-90 {x} {y})\">{}</text>",
            raised(text)
        );
    }
    /// A line through points, in a colour and with the dash of a series.
    pub fn polyline(&mut self, series: usize, points: &[(f64, f64)]) {
        let list: Vec<String> = points.iter().map(|(x, y)| format!("{},{}", px(*x), px(*y))).collect();
        let dash = DASHES[series % DASHES.len()];
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        let _ = writeln!(
            self.text,
            "<polyline class=\"line\" stroke=\"var(--c{})\"{dash} points=\"{}\"/>",
            series % COLOURS,
            list.join(" ")
        );
    }
    /// The mark of a series at a place, filled or hollow.
    pub fn mark(&mut self, series: usize, (x, y): (f64, f64), filled: bool) {
        let colour = series % COLOURS;
        let fill = if filled { format!("var(--c{colour})") } else { "var(--paper)".to_owned() };
        let path = |points: &[(f64, f64)]| {
            let list: Vec<String> =
                points.iter().map(|(dx, dy)| format!("{},{}", px(x + dx), px(y + dy))).collect();
            format!("M{}Z", list.join("L"))
        };
        let shape = match series % 7 {
            0 => path(&star()),
            1 => format!("M{},{}a4,4 0 1,0 8,0a4,4 0 1,0 -8,0Z", px(x - 4.0), px(y)),
            2 => path(&[(-3.7, -3.7), (3.7, -3.7), (3.7, 3.7), (-3.7, 3.7)]),
            3 => path(&[(0.0, -5.0), (4.6, 3.2), (-4.6, 3.2)]),
            4 => path(&[(0.0, -5.3), (5.3, 0.0), (0.0, 5.3), (-5.3, 0.0)]),
            5 => path(&[(0.0, 5.0), (4.6, -3.2), (-4.6, -3.2)]),
            _ => path(&[
                (-1.6, -5.0),
                (1.6, -5.0),
                (1.6, -1.6),
                (5.0, -1.6),
                (5.0, 1.6),
                (1.6, 1.6),
                (1.6, 5.0),
                (-1.6, 5.0),
                (-1.6, 1.6),
                (-5.0, 1.6),
                (-5.0, -1.6),
                (-1.6, -1.6),
            ]),
        };
        let _ = writeln!(
            self.text,
            "<path class=\"mark\" stroke=\"var(--c{colour})\" fill=\"{fill}\" d=\"{shape}\"/>"
        );
    }
    /// A disc.
    pub fn disc(&mut self, class: &str, (x, y): (f64, f64), radius: f64) {
        let _ = writeln!(
            self.text,
            "<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
            px(x),
            px(y),
            px(radius)
        );
    }
    /// A ring round a place.
    pub fn ring(&mut self, (x, y): (f64, f64), radius: f64) {
        let _ = writeln!(
            self.text,
            "<circle class=\"ring\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
            px(x),
            px(y),
            px(radius)
        );
    }
    /// The finished text.
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

/// A star of five points, radius 6.4.
fn star() -> [(f64, f64); 10] {
    [
        (0.0, -6.4),
        (1.5, -2.1),
        (6.1, -2.0),
        (2.4, 0.8),
        (3.8, 5.2),
        (0.0, 2.5),
        (-3.8, 5.2),
        (-2.4, 0.8),
        (-6.1, -2.0),
        (-1.5, -2.1),
    ]
}

/// `10^{-3}` with a raised exponent.
fn raised(text: &str) -> String {
    let Some((before, rest)) = text.split_once("^{") else { return escaped(text) };
    let (up, after) = rest.split_once('}').unwrap_or((rest, ""));
    let back =
        if after.is_empty() { String::new() } else { format!("<tspan dy=\"5\">{}</tspan>", raised(after)) };
    format!("{}<tspan class=\"small\" dy=\"-5\">{}</tspan>{back}", escaped(before), escaped(up))
}
