//! SVG text: one writer of elements for pictures and charts, and pictures as SVG: in a page, as a file of its own, and for print
//! without style sheets. All coordinates have one decimal: equal pictures give equal bytes.
use crate::picture::board::TEXT;
use crate::picture::look::{INKS, Ink, letters, look, used};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Element, Outline, Picture, PlacedLabel, Role, RunStyle, TextRun, symbol};
use std::fmt::{self, Display, Write as _};

/// Fonts of labels on screen: Times and what stands in for it.
const FONTS: &str = "\"Libertinus Serif\",\"STIX Two Text\",\"Times New Roman\",Times,\"Liberation Serif\",\"Nimbus Roman\",\"TeX Gyre Termes\",serif";
/// Font of labels in print: the one that the PDF brings with it.
const PRINT_FONT: &str = "Libertinus Serif";

/// Pictures higher than this are not shrunk to the 42 mm of a figure in a worked solution.
const TALL: f64 = 272.0;

/// Labels wider than this are fitted to the width for which room was found.
const FITTED: f64 = 2.0 * TEXT;

/// A coordinate: at most one decimal, ties of the binary value to even; never `-0`. Written without allocation: a page of
/// figures holds thousands.
#[derive(Debug, Clone, Copy)]
pub struct Px(pub f64);

impl Display for Px {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
        let (mut units, tenth) = (whole.unsigned_abs() / 10, whole.unsigned_abs() % 10);
        // From the last digit to the sign.
        let mut digits = [0u8; 16];
        let mut at = digits.len();
        let mut put = |byte: u8| {
            at -= 1;
            digits[at] = byte;
        };
        let digit = |n: u64| b'0' + (n % 10) as u8;
        if tenth > 0 {
            put(digit(tenth));
            put(b'.');
        }
        put(digit(units));
        while units > 9 {
            units /= 10;
            put(digit(units));
        }
        if whole < 0 {
            put(b'-');
        }
        f.write_str(std::str::from_utf8(&digits[at..]).unwrap_or_default())
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

/// The begin of a picture for the screen: size, what it shows for those who do not see it, the element with its style. `id` tells
/// the pictures of one page apart. A tall one has a class of its own, so that its letters stay large enough in print.
pub fn opening(class: &str, id: &str, size: Vec2, (title, desc): (&str, &str), style: &str) -> String {
    let (id, title, desc) = (escaped(id), escaped(title), escaped(desc));
    let (w, h) = (Px(size.x), Px(size.y));
    let tall = if size.y > TALL { " tall" } else { "" };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{class}{tall}\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" aria-labelledby=\"{id}-t {id}-d\"><title id=\"{id}-t\">{title}</title><desc id=\"{id}-d\">{desc}</desc>{style}\n"
    )
}

/// Elements of SVG as they are written, a line for each. What an element looks like is given as its attributes.
#[derive(Debug, Clone, Default)]
pub struct Svg {
    text: String,
}

impl Svg {
    /// Goes on after this text.
    pub fn after(text: String) -> Self {
        Self { text }
    }

    /// What was written.
    pub fn into_text(self) -> String {
        self.text
    }

    /// A full circle.
    pub fn circle(&mut self, look: impl Display, centre: Vec2, radius: f64) {
        let (x, y, r) = (Px(centre.x), Px(centre.y), Px(radius));
        let _ = writeln!(self.text, "<circle {look} cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
    }

    /// A rectangle, from its upper left corner.
    pub fn rect(&mut self, look: impl Display, corner: Vec2, size: Vec2) {
        let (x, y, w, h) = (Px(corner.x), Px(corner.y), Px(size.x), Px(size.y));
        let _ = writeln!(self.text, "<rect {look} x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/>");
    }

    /// Lines from point to point.
    pub fn lines(&mut self, look: impl Display, points: &[Vec2], closed: bool) {
        self.begin_path(look);
        self.path_of_lines(points, closed);
        self.end_path();
    }

    /// A text with its base line here; `more` is what else it has for attributes, `class` may be empty.
    pub fn label(&mut self, class: &str, at: Vec2, size: f64, more: impl Display, runs: &[TextRun]) {
        let (x, y, letters) = (Px(at.x), Px(at.y), Px(size));
        self.text.push_str("<text ");
        if !class.is_empty() {
            let _ = write!(self.text, "class=\"{class}\" ");
        }
        let _ = write!(self.text, "x=\"{x}\" y=\"{y}\" font-size=\"{letters}\"{more}>");
        // Each shift counts from the run before: what was lowered is raised again.
        let mut low = 0.0;
        for TextRun { text, style } in runs {
            let (small, italic, want) = match style {
                RunStyle::Upright => (false, false, 0.0),
                RunStyle::Italic => (false, true, 0.0),
                RunStyle::Sub => (true, false, 0.24),
                RunStyle::SubItalic => (true, true, 0.24),
                RunStyle::Super => (true, false, -0.36),
            };
            let shift: f64 = (want - low) * size;
            low = want;
            if !small && !italic && shift.abs() < 1e-9 {
                self.text.push_str(&escaped(text));
                continue;
            }
            self.text.push_str("<tspan");
            if shift.abs() > 1e-9 {
                let _ = write!(self.text, " dy=\"{}\"", Px(shift));
            }
            if small {
                let _ = write!(self.text, " font-size=\"{}\"", Px(symbol::SMALL * size));
            }
            if italic {
                self.text.push_str(" font-style=\"italic\"");
            }
            let _ = write!(self.text, ">{}</tspan>", escaped(text));
        }
        self.text.push_str("</text>\n");
    }

    fn begin_path(&mut self, look: impl Display) {
        let _ = write!(self.text, "<path {look} d=\"");
    }

    fn end_path(&mut self) {
        self.text.push_str("\"/>\n");
    }

    fn path_of_lines(&mut self, points: &[Vec2], closed: bool) {
        for (i, p) in points.iter().enumerate() {
            let _ = write!(self.text, "{}{} {}", if i == 0 { 'M' } else { 'L' }, Px(p.x), Px(p.y));
        }
        if closed {
            self.text.push('Z');
        }
    }

    /// Path of an outline that is no circle.
    fn path(&mut self, outline: &Outline) {
        match outline {
            Outline::Lines { points, closed } => self.path_of_lines(points, *closed),
            Outline::Arc { centre, radius, from, to } => self.arc('M', *centre, *radius, (*from, *to)),
            Outline::Arcs(arcs) => {
                for (i, (centre, radius, from, to)) in arcs.iter().enumerate() {
                    self.arc(if i == 0 { 'M' } else { 'L' }, *centre, *radius, (*from, *to));
                }
                self.text.push('Z');
            }
            Outline::Circle { .. } => {}
        }
    }

    /// Part of a circle, to whose begin this command leads.
    fn arc(&mut self, command: char, centre: Vec2, radius: f64, (from, to): (f64, f64)) {
        let at = |angle: f64| on_arc(centre, radius, angle);
        let (a, b) = (at(from), at(to));
        let _ = write!(self.text, "{command}{} {}", Px(a.x), Px(a.y));
        // A circle is more than one arc can be.
        let parts = ((to - from).abs() / 3.0).ceil().max(1.0);
        let sweep = u8::from(to < from);
        let mut i = 1.0;
        while i <= parts {
            let p = if i < parts { at(from + (to - from) * i / parts) } else { b };
            let r = Px(radius);
            let _ = write!(self.text, "A{r} {r} 0 0 {sweep} {} {}", Px(p.x), Px(p.y));
            i += 1.0;
        }
    }

    /// All elements and labels of a picture.
    fn picture(&mut self, picture: &Picture, manner: Manner) {
        let mut elements = picture.elements.iter().peekable();
        while let Some(Element { outline, role }) = elements.next() {
            let dress = Dress(*role, manner);
            if let Outline::Circle { centre, radius } = outline {
                self.circle(dress, *centre, *radius);
                continue;
            }
            self.begin_path(dress);
            self.path(outline);
            // Strokes of one kind in a row are one path.
            while look(*role).1.fill.is_none()
                && let Some(next) =
                    elements.next_if(|n| n.role == *role && !matches!(n.outline, Outline::Circle { .. }))
            {
                self.path(&next.outline);
            }
            self.end_path();
        }
        for PlacedLabel { runs, at, size, bounds, role } in &picture.labels {
            let ink = letters(*role);
            let at = vec2((bounds.low.x + bounds.high.x) / 2.0, at.y);
            match manner {
                Manner::Classes => {
                    let class = if ink == "ink" { String::new() } else { format!("t-{ink}") };
                    // A wider font than Times would run into what the label stands beside.
                    let wide = bounds.high.x - bounds.low.x;
                    let long = format_args!(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", Px(wide));
                    match wide > FITTED {
                        true => self.label(&class, at, *size, long, runs),
                        false => self.label(&class, at, *size, "", runs),
                    }
                }
                Manner::Attributes => {
                    let fill = light(ink);
                    let more =
                        format_args!(" text-anchor=\"middle\" font-family=\"{PRINT_FONT}\" fill=\"{fill}\"");
                    self.label("", at, *size, more, runs);
                }
            }
        }
    }
}

/// The point of a circle at an angle, in a picture, whose y axis points down.
pub fn on_arc(centre: Vec2, radius: f64, angle: f64) -> Vec2 {
    let towards = Vec2::at_angle(angle);
    vec2(centre.x + radius * towards.x, centre.y - radius * towards.y)
}

/// How looks are written: by class, or on each element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Manner {
    Classes,
    Attributes,
}

/// What stands on each element of a role.
struct Dress(Role, Manner);

impl Display for Dress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (class, look) = look(self.0);
        if self.1 == Manner::Classes {
            return write!(f, "class=\"{class}\"");
        }
        write!(f, "fill=\"{}\"", look.fill.map_or("none", light))?;
        if let Some((ink, width)) = look.stroke {
            let (cap, ink) = (if look.dash.is_empty() { "round" } else { "butt" }, light(ink));
            write!(
                f,
                " stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linecap=\"{cap}\" stroke-linejoin=\"round\""
            )?;
            if !look.dash.is_empty() {
                write!(f, " stroke-dasharray=\"{}\"", look.dash)?;
            }
        }
        Ok(())
    }
}

fn light(name: &str) -> &'static str {
    INKS.iter().find(|i| i.name == name).map_or("#000000", |i| i.light)
}

/// The style sheet of a picture: only what it uses.
fn style(picture: &Picture) -> String {
    let (roles, used) = used(picture);
    let inks = |pick: fn(&Ink) -> &'static str| {
        let always = |ink: &&Ink| used.contains(ink.name) || matches!(ink.name, "ink" | "paper");
        INKS.iter().filter(always).fold(String::new(), |mut out, ink| {
            let _ = write!(out, "--f-{}:{};", ink.name, pick(ink));
            out
        })
    };
    let (light, dark) = (inks(|i| i.light), inks(|i| i.dark));
    let mut out = format!(
        ".fig{{{light}max-width:100%;height:auto;font-family:{FONTS}}}@media(prefers-color-scheme:dark){{.fig{{{dark}}}}}@media print{{.fig{{{light}}}}}.fig text{{fill:var(--f-ink);text-anchor:middle}}.fig path,.fig circle{{fill:none;stroke-linecap:round;stroke-linejoin:round}}"
    );
    for role in roles {
        let (class, look) = look(role);
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
        if picture.labels.iter().any(|l| letters(l.role) == ink) {
            let _ = write!(out, ".fig .t-{ink}{{fill:var(--f-{ink})}}");
        }
    }
    out
}

/// A picture for the screen: style by classes and CSS variables, light and dark by the reader's setting, black on white in
/// print. Written once, however many pages and files show it.
#[derive(Debug)]
pub struct Screen<'p> {
    picture: &'p Picture,
    /// The element with the style, which counts for all pictures of a page.
    pub style: String,
    content: String,
}

impl<'p> Screen<'p> {
    /// Writes it.
    pub fn new(picture: &'p Picture) -> Self {
        let mut svg = Svg::after(String::with_capacity(8192));
        svg.picture(picture, Manner::Classes);
        Self { picture, style: format!("<style>{}</style>", style(picture)), content: svg.into_text() }
    }

    /// About how many bytes it takes within a page.
    pub fn bytes(&self) -> usize {
        self.content.len() + self.style.len() + self.picture.desc.len()
    }

    /// Within a page; `id` tells the pictures of one page apart.
    pub fn inline(&self, id: &str) -> String {
        self.written(id, &self.style)
    }

    /// Within a page that has its style already.
    pub fn inline_without_style(&self, id: &str) -> String {
        self.written(id, "")
    }

    fn written(&self, id: &str, style: &str) -> String {
        let Picture { width, height, title, desc, .. } = self.picture;
        opening("fig", id, vec2(*width, *height), (title, desc), style) + &self.content + "</svg>\n"
    }

    /// As a file of its own, with the same looks and paper of its own below it. Programs that know no variables of CSS (Word, what
    /// makes a document for it) take the looks on light paper, which stand before each variable.
    pub fn file(&self) -> String {
        let paper = "\n<rect width=\"100%\" height=\"100%\" style=\"fill:var(--f-paper)\"/>\n";
        let mut text = self.inline("figure").replacen('\n', paper, 1);
        for Ink { name, light, .. } in INKS {
            for what in ["fill", "stroke"] {
                let variable = format!("{what}:var(--f-{name})");
                text = text.replace(&variable, &format!("{what}:{light};{variable}"));
            }
        }
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{text}")
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
        w = Px(picture.width),
        h = Px(picture.height),
    );
    let mut svg = Svg::after(out);
    svg.picture(picture, Manner::Attributes);
    svg.into_text() + "</svg>\n"
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
        values.extend([999_999_999.9, -999_999_999.9, 10.0, -10.1, 99.95]);
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            #[expect(clippy::cast_precision_loss, reason = "any number will do")]
            let near = ((bits >> 40) as f64 - 8_388_608.0) / 1000.0;
            values.extend([near, (near * 20.0).round() / 20.0, f64::from_bits(bits)]);
        }
        for x in values {
            let text = format!("{x:.1}");
            let short = text.strip_suffix(".0").unwrap_or(&text);
            assert_eq!(Px(x).to_string(), if short == "-0" { "0" } else { short }, "{x:e}");
        }
    }
}
