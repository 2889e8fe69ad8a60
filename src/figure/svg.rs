//! Pictures as SVG text: in a page, as a file of its own, and for print without style sheets.
//!
//! Lines differ by width and dash, areas by pattern, so that pictures read in black and white; colours are those of Okabe and
//! Ito, darkened for letters. All coordinates have one decimal: equal pictures give equal bytes.
use crate::figure::picture::Label;
use crate::figure::picture::Outline;
use crate::figure::picture::Picture;
use crate::figure::picture::Point;
use crate::figure::picture::Role;
use crate::figure::picture::Run;
use crate::figure::picture::RunStyle;
use crate::figure::picture::Shape;
use crate::figure::symbol;
use crate::figure::vector;
use std::fmt::Write as _;

/// Fonts of labels on screen: Times and what stands in for it.
const FONTS: &str = "\"Libertinus Serif\",\"STIX Two Text\",\"Times New Roman\",Times,\"Liberation Serif\",\"Nimbus Roman\",\"TeX Gyre Termes\",serif";
/// Font of labels in print: the one that the PDF brings with it.
const PRINT_FONT: &str = "Libertinus Serif";

/// A colour on light paper, on dark paper, in print.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ink {
    /// Name of its variable.
    pub name: &'static str,
    /// On light paper.
    pub light: &'static str,
    /// On dark paper.
    pub dark: &'static str,
}

/// All inks.
pub const INKS: &[Ink] = &[
    Ink { name: "ink", light: "#16191d", dark: "#e6e9ed" },
    Ink { name: "paper", light: "#ffffff", dark: "#14171b" },
    Ink { name: "body", light: "#dde6ee", dark: "#2c3843" },
    Ink { name: "inner", light: "#f3f6f9", dark: "#3b4a58" },
    Ink { name: "soft", light: "#59626d", dark: "#a3adb8" },
    Ink { name: "faint", light: "#d9dee4", dark: "#353c45" },
    Ink { name: "force", light: "#b8420a", dark: "#ff9350" },
    Ink { name: "friction", light: "#96337a", dark: "#eda3d3" },
    Ink { name: "motion", light: "#00598f", dark: "#6cc0f0" },
    Ink { name: "spring", light: "#00694c", dark: "#3fd0a3" },
    Ink { name: "cord", light: "#5b4a1e", dark: "#dcc584" },
    Ink { name: "area0", light: "#9cc9e3", dark: "#1d5878" },
    Ink { name: "area1", light: "#f3cf9a", dark: "#7a5416" },
    Ink { name: "area2", light: "#a9dcc9", dark: "#1d6650" },
    Ink { name: "area3", light: "#e3bcd6", dark: "#6d3a5c" },
    Ink { name: "area4", light: "#f4b89a", dark: "#84401c" },
    Ink { name: "area5", light: "#e9e4a6", dark: "#635d1c" },
];

/// How a role is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Ink of the line, and its width; `None`: no line.
    pub stroke: Option<(&'static str, f64)>,
    /// Dashes.
    pub dash: &'static str,
    /// Ink of the area; `None`: empty.
    pub fill: Option<&'static str>,
}

/// Class name and look of a role.
pub fn look(role: Role) -> (&'static str, Look) {
    let line = |ink, width| Look { stroke: Some((ink, width)), dash: "", fill: None };
    let dashed = |ink, width, dash| Look { stroke: Some((ink, width)), dash, fill: None };
    let full = |ink| Look { stroke: None, dash: "", fill: Some(ink) };
    let area = |fill| Look { stroke: Some(("ink", 1.0)), dash: "", fill: Some(fill) };
    match role {
        Role::Body => ("body", Look { stroke: Some(("ink", 1.9)), dash: "", fill: Some("body") }),
        Role::Inner => ("inner", Look { stroke: Some(("ink", 1.3)), dash: "", fill: Some("inner") }),
        Role::Ground => ("ground", line("ink", 2.2)),
        Role::Hatch => ("hatch", line("soft", 0.9)),
        Role::Cord => ("cord", line("cord", 2.0)),
        Role::Spring => ("spring", line("spring", 1.7)),
        Role::Dot => ("dot", full("ink")),
        Role::Dimension => ("dim", line("soft", 1.0)),
        Role::DimensionHead => ("dimhead", full("soft")),
        Role::Ghost => ("ghost", dashed("soft", 1.2, "5 3.5")),
        Role::Force => ("force", line("force", 2.6)),
        Role::ForceHead => ("forcehead", full("force")),
        Role::Friction => ("friction", dashed("friction", 2.6, "7 2.5")),
        Role::FrictionHead => ("frictionhead", full("friction")),
        Role::Motion => ("motion", line("motion", 1.7)),
        Role::MotionHead => {
            ("motionhead", Look { stroke: Some(("motion", 1.4)), dash: "", fill: Some("paper") })
        }
        Role::Axis => ("axis", line("ink", 1.2)),
        Role::Grid => ("grid", line("faint", 0.9)),
        Role::Curve(n) => match n % 4 {
            0 => ("curve0", line("motion", 2.3)),
            1 => ("curve1", dashed("friction", 2.3, "8 3")),
            2 => ("curve2", dashed("force", 1.8, "2.5 3")),
            _ => ("curve3", dashed("spring", 2.1, "9 3 2 3")),
        },
        Role::Area(n) => match n % 6 {
            0 => ("area0", area("area0")),
            1 => ("area1", area("area1")),
            2 => ("area2", area("area2")),
            3 => ("area3", area("area3")),
            4 => ("area4", area("area4")),
            _ => ("area5", area("area5")),
        },
        Role::Paper => ("paper", full("paper")),
    }
}

/// Ink of the letters of a label.
pub fn letters(role: Role) -> &'static str {
    match role {
        Role::Force | Role::ForceHead | Role::Curve(2) => "force",
        Role::Friction | Role::FrictionHead | Role::Curve(1) => "friction",
        Role::Motion | Role::MotionHead | Role::Curve(0) => "motion",
        Role::Spring | Role::Curve(3) => "spring",
        _ => "ink",
    }
}

/// All roles that have a look of their own.
const ROLES: &[Role] = &[
    Role::Body,
    Role::Inner,
    Role::Ground,
    Role::Hatch,
    Role::Cord,
    Role::Spring,
    Role::Dot,
    Role::Dimension,
    Role::DimensionHead,
    Role::Ghost,
    Role::Force,
    Role::ForceHead,
    Role::Friction,
    Role::FrictionHead,
    Role::Motion,
    Role::MotionHead,
    Role::Axis,
    Role::Grid,
    Role::Curve(0),
    Role::Curve(1),
    Role::Curve(2),
    Role::Curve(3),
    Role::Area(0),
    Role::Area(1),
    Role::Area(2),
    Role::Area(3),
    Role::Area(4),
    Role::Area(5),
    Role::Paper,
];

/// The style sheet of all pictures; only classes that one of these pictures uses, or all.
fn style(of: Option<&Picture>) -> String {
    let used = |role: Role| of.is_none_or(|p| p.shapes.iter().any(|s| look(s.role).0 == look(role).0));
    let inked = |name: &str| {
        let of_shape = |role: Role| {
            let (_, look) = look(role);
            look.fill == Some(name) || look.stroke.is_some_and(|(ink, _)| ink == name)
        };
        name == "ink"
            || name == "paper"
            || of.is_none_or(|p| {
                p.shapes.iter().any(|s| of_shape(s.role)) || p.labels.iter().any(|l| letters(l.role) == name)
            })
    };
    let inks = |pick: fn(&Ink) -> &'static str| {
        INKS.iter().filter(|i| inked(i.name)).fold(String::new(), |mut out, ink| {
            let _ = write!(out, "--f-{}:{};", ink.name, pick(ink));
            out
        })
    };
    let (light, dark) = (inks(|i| i.light), inks(|i| i.dark));
    let mut out = format!(
        ".fig{{{light}max-width:100%;height:auto;font-family:{FONTS}}}@media(prefers-color-scheme:dark){{.fig{{{dark}}}}}@media print{{.fig{{{light}}}}}.fig text{{fill:var(--f-ink);text-anchor:middle}}.fig path,.fig circle{{fill:none;stroke-linecap:round;stroke-linejoin:round}}"
    );
    for role in ROLES.iter().filter(|r| used(**r)) {
        let (class, look) = look(*role);
        let _ = write!(out, ".fig .{class}{{");
        if let Some((ink, width)) = look.stroke {
            let _ = write!(out, "stroke:var(--f-{ink});stroke-width:{width}");
        }
        if !look.dash.is_empty() {
            let _ = write!(out, ";stroke-dasharray:{};stroke-linecap:butt", look.dash);
        }
        if let Some(ink) = look.fill {
            let _ = write!(out, "{}fill:var(--f-{ink})", if look.stroke.is_some() { ";" } else { "" });
        }
        out.push('}');
    }
    for ink in ["force", "friction", "motion", "spring"] {
        if of.is_none_or(|p| p.labels.iter().any(|l| letters(l.role) == ink)) {
            let _ = write!(out, ".fig .t-{ink}{{fill:var(--f-{ink})}}");
        }
    }
    out
}

/// A number with at most one decimal, ties of the binary value to even; never `-0`. Written without allocation: a page of
/// figures holds thousands.
#[derive(Debug, Clone, Copy)]
pub struct Coordinate(pub f64);

impl std::fmt::Display for Coordinate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let tenths = self.0 * 10.0;
        let whole = tenths.round_ties_even();
        // Near a tie the product may have rounded to the wrong side; beyond the integers of i64 there is nothing to round.
        let plain = ((tenths - whole).abs() - 0.5).abs() > 1e-6 && self.0.abs() < 1e9;
        if !plain {
            let text = format!("{:.1}", self.0);
            return match text.strip_suffix(".0") {
                Some("-0") => f.write_str("0"),
                Some(whole) => f.write_str(whole),
                None => f.write_str(&text),
            };
        }
        #[expect(clippy::cast_possible_truncation, reason = "below 1e10 and whole")]
        let whole = whole as i64;
        let (units, tenth) = (whole.unsigned_abs() / 10, whole.unsigned_abs() % 10);
        let sign = if whole < 0 { "-" } else { "" };
        if tenth == 0 { write!(f, "{sign}{units}") } else { write!(f, "{sign}{units}.{tenth}") }
    }
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

/// How looks are written: by class, or on each element.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Manner {
    Classes,
    Attributes,
}

/// A picture for the screen: style by classes and CSS variables, light and dark by the reader's setting, black on white in
/// print. Written once, however many pages and files show it.
#[derive(Debug)]
pub struct Screen<'p> {
    picture: &'p Picture,
    style: String,
    content: String,
}

impl<'p> Screen<'p> {
    /// Writes it.
    pub fn new(picture: &'p Picture) -> Self {
        let mut text = String::with_capacity(8192);
        content(picture, Manner::Classes, &mut text);
        Self { picture, style: style(Some(picture)), content: text }
    }

    fn written(&self, before: &str, id: &str, paper: &str) -> String {
        let (id, picture) = (escaped(id), self.picture);
        format!(
            "{before}<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" aria-labelledby=\"{id}-t {id}-d\"><title id=\"{id}-t\">{}</title><desc id=\"{id}-d\">{}</desc><style>{}</style>\n{paper}{}</svg>\n",
            escaped(&picture.title),
            escaped(&picture.desc),
            self.style,
            self.content,
            w = Coordinate(picture.width),
            h = Coordinate(picture.height),
        )
    }

    /// Within a page; `id` tells the pictures of one page apart.
    pub fn inline(&self, id: &str) -> String {
        self.written("", id, "")
    }

    /// As a file of its own, with the same looks and paper of its own below it.
    pub fn file(&self) -> String {
        let paper = "<rect width=\"100%\" height=\"100%\" style=\"fill:var(--f-paper)\"/>\n";
        self.written("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", "figure", paper)
    }
}

/// The picture for print: attributes alone, no style sheet, the font of the PDF.
pub fn print(picture: &Picture) -> String {
    let mut out = String::with_capacity(8192);
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\"><title>{}</title><desc>{}</desc>",
        escaped(&picture.title),
        escaped(&picture.desc),
        w = Coordinate(picture.width),
        h = Coordinate(picture.height),
    );
    content(picture, Manner::Attributes, &mut out);
    out.push_str("</svg>\n");
    out
}

fn light(name: &str) -> &'static str {
    INKS.iter().find(|i| i.name == name).map_or("#000000", |i| i.light)
}

/// What stands on each element of a role.
fn attributes(role: Role, manner: Manner) -> String {
    let (class, look) = look(role);
    if manner == Manner::Classes {
        return format!("class=\"{class}\"");
    }
    let mut out = format!("fill=\"{}\"", look.fill.map_or("none", light));
    if let Some((ink, width)) = look.stroke {
        let cap = if look.dash.is_empty() { "round" } else { "butt" };
        let _ = write!(
            out,
            " stroke=\"{}\" stroke-width=\"{width}\" stroke-linecap=\"{cap}\" stroke-linejoin=\"round\"",
            light(ink)
        );
        if !look.dash.is_empty() {
            let _ = write!(out, " stroke-dasharray=\"{}\"", look.dash);
        }
    }
    out
}

/// Path of an outline that is no circle.
fn path(outline: &Outline, out: &mut String) {
    match outline {
        Outline::Lines { points, closed } => {
            for (i, p) in points.iter().enumerate() {
                let _ =
                    write!(out, "{}{} {}", if i == 0 { 'M' } else { 'L' }, Coordinate(p.0), Coordinate(p.1));
            }
            if *closed {
                out.push('Z');
            }
        }
        Outline::Arc { centre, radius, from, to } => {
            let at = |angle: f64| -> Point {
                let (c, s) = vector::polar(angle);
                (centre.0 + radius * c, centre.1 - radius * s)
            };
            let (a, b) = (at(*from), at(*to));
            let _ = write!(out, "M{} {}", Coordinate(a.0), Coordinate(a.1));
            // A circle is more than one arc can be.
            let parts = ((to - from).abs() / 3.0).ceil().max(1.0);
            let sweep = u8::from(to < from);
            let mut i = 1.0;
            while i <= parts {
                let p = if i < parts { at(from + (to - from) * i / parts) } else { b };
                let r = Coordinate(*radius);
                let _ = write!(out, "A{r} {r} 0 0 {sweep} {} {}", Coordinate(p.0), Coordinate(p.1));
                i += 1.0;
            }
        }
        Outline::Circle { .. } => {}
    }
}

fn content(picture: &Picture, manner: Manner, out: &mut String) {
    let mut shapes = picture.shapes.iter().peekable();
    while let Some(Shape { outline, role }) = shapes.next() {
        let what = attributes(*role, manner);
        if let Outline::Circle { centre, radius } = outline {
            let (x, y, r) = (Coordinate(centre.0), Coordinate(centre.1), Coordinate(*radius));
            let _ = writeln!(out, "<circle {what} cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
            continue;
        }
        let _ = write!(out, "<path {what} d=\"");
        path(outline, out);
        // Strokes of one kind in a row are one path.
        while look(*role).1.fill.is_none()
            && let Some(next) =
                shapes.next_if(|n| n.role == *role && !matches!(n.outline, Outline::Circle { .. }))
        {
            path(&next.outline, out);
        }
        out.push_str("\"/>\n");
    }
    for label in &picture.labels {
        text(label, manner, out);
    }
}

fn text(label: &Label, manner: Manner, out: &mut String) {
    let centre = (label.bounds.0 + label.bounds.2) / 2.0;
    let (x, y) = (Coordinate(centre), Coordinate(label.at.1));
    let size = Coordinate(label.size);
    let ink = letters(label.role);
    let _ = match manner {
        Manner::Classes if ink == "ink" => {
            write!(out, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\">")
        }
        Manner::Classes => write!(out, "<text class=\"t-{ink}\" x=\"{x}\" y=\"{y}\" font-size=\"{size}\">"),
        Manner::Attributes => write!(
            out,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"middle\" font-family=\"{PRINT_FONT}\" fill=\"{}\">",
            light(ink)
        ),
    };
    // What the last run has lowered, the next one raises again.
    let mut low = 0.0;
    for Run { text, style } in &label.runs {
        let (small, italic, want) = match style {
            RunStyle::Upright => (false, false, 0.0),
            RunStyle::Italic => (false, true, 0.0),
            RunStyle::Sub => (true, false, 0.24),
            RunStyle::SubItalic => (true, true, 0.24),
            RunStyle::Super => (true, false, -0.36),
        };
        let shift: f64 = (want - low) * label.size;
        low = want;
        let plain = !small && !italic && shift.abs() < 1e-9;
        if plain {
            out.push_str(&escaped(text));
            continue;
        }
        out.push_str("<tspan");
        if shift.abs() > 1e-9 {
            let _ = write!(out, " dy=\"{}\"", Coordinate(shift));
        }
        if small {
            let _ = write!(out, " font-size=\"{}\"", Coordinate(symbol::SMALL * label.size));
        }
        if italic {
            out.push_str(" font-style=\"italic\"");
        }
        let _ = write!(out, ">{}</tspan>", escaped(text));
    }
    out.push_str("</text>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Goldens show coordinates that happen to occur; ties and halves of a last binary digit do not.
    #[test]
    fn coordinates_are_rounded_as_the_decimal_value_is() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut values =
            vec![0.0, -0.0, 0.05, -0.05, 0.25, 0.35, 1e9, -1e300, 0.049_999_999_999_999_996, f64::NAN];
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            #[expect(clippy::cast_precision_loss, reason = "any number will do")]
            let near = ((bits >> 40) as f64 - 8_388_608.0) / 1000.0;
            values.extend([near, (near * 20.0).round() / 20.0, f64::from_bits(bits)]);
        }
        for x in values {
            let text = format!("{x:.1}");
            let short = text.strip_suffix(".0").unwrap_or(&text);
            assert_eq!(Coordinate(x).to_string(), if short == "-0" { "0" } else { short }, "{x:e}");
        }
    }
}
