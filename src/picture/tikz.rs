//! Pictures as TikZ: needs `\usepackage{tikz}` and nothing else.
use crate::picture::look::{INKS, letters, look, used};
use crate::picture::svg::{Px, on_arc};
use crate::picture::vector::{Vec2, vec2};
use crate::picture::{Outline, Picture, Role, RunStyle, TextRun, symbol};
use std::borrow::Cow;
use std::fmt::Write as _;

/// Signs that TeX fonts have under another name than [`symbol::LETTERS`] says, or under none.
#[rustfmt::skip] // a table
const SIGNS: &[(char, &str)] = &[
    ('µ', r"\mu"), ('−', "-"), ('=', "="), ('<', "<"), ('>', ">"), ('|', r"\vert"), ('×', r"\times"),
    ('±', r"\pm"), ('≤', r"\leq"), ('≥', r"\geq"), ('°', r"^{\circ}"), ('′', "'"), ('\u{2009}', r"\,"),
];

/// Part of a circle. The y axis points down, radii in points do not follow it: angles stay as seen.
fn arc(centre: Vec2, radius: f64, from: f64, to: f64) -> String {
    let start = place(on_arc(centre, radius, from));
    let (from, to, radius) = (Px(from.to_degrees()), Px(to.to_degrees()), Px(radius * 0.75));
    format!("{start} arc[start angle={from},end angle={to},radius={radius}pt]")
}

/// The picture as a `tikzpicture`; one pixel is 0.75 pt.
pub fn picture(picture: &Picture) -> String {
    let mut out = String::with_capacity(8192);
    for line in picture.title.lines().chain(picture.desc.lines()) {
        let _ = writeln!(out, "% {}", line.replace(char::is_control, " "));
    }
    out.push_str("\\begin{tikzpicture}[x=0.75pt,y=-0.75pt,line cap=round,line join=round]\n");
    let (_, inks) = used(picture);
    for ink in INKS.iter().filter(|i| inks.contains(i.name)) {
        let hex = ink.light.trim_start_matches('#').to_uppercase();
        let _ = writeln!(out, "\\definecolor{{fig{}}}{{HTML}}{{{hex}}}", ink.name);
    }
    // The box is the picture's own, so that pictures line up.
    let _ =
        writeln!(out, "\\useasboundingbox (0,0) rectangle ({},{});", Px(picture.width), Px(picture.height));
    for element in &picture.elements {
        let _ = write!(out, "\\path[{}] ", options(element.role));
        match &element.outline {
            Outline::Lines { points, closed } => {
                let list: Vec<String> = points.iter().map(|p| place(*p)).collect();
                out.push_str(&list.join(" -- "));
                if *closed {
                    out.push_str(" -- cycle");
                }
            }
            Outline::Circle { centre, radius } => {
                let _ = write!(out, "{} circle[radius={}pt]", place(*centre), Px(radius * 0.75));
            }
            Outline::Arc { centre, radius, from, to } => {
                out.push_str(&arc(*centre, *radius, *from, *to));
            }
            Outline::Arcs(arcs) => {
                for (centre, radius, from, to) in arcs {
                    out.push_str(&arc(*centre, *radius, *from, *to));
                    out.push_str(" -- ");
                }
                out.push_str("cycle");
            }
        }
        out.push_str(";\n");
    }
    for label in &picture.labels {
        let centre = (label.bounds.low.x + label.bounds.high.x) / 2.0;
        let size = Px(label.size * 0.75);
        let _ = writeln!(
            out,
            "\\node[anchor=base,inner sep=0pt,fig{},font=\\fontsize{{{size}}}{{{size}}}\\selectfont] at {} {{{}}};",
            letters(label.role),
            place(vec2(centre, label.at.y)),
            text(&label.runs)
        );
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn place(p: Vec2) -> String {
    format!("({},{})", Px(p.x), Px(p.y))
}

fn options(role: Role) -> String {
    let (_, look) = look(role);
    let mut out = Vec::new();
    if let Some((ink, width)) = look.stroke {
        out.push(format!("draw=fig{ink}"));
        out.push(format!("line width={:.2}pt", width * 0.75));
    }
    if !look.dash.is_empty() {
        let lengths: Vec<f64> = look.dash.split(' ').filter_map(|d| d.parse().ok()).collect();
        let words = ["on", "off"];
        let pattern: Vec<String> = lengths
            .iter()
            .enumerate()
            .map(|(i, long)| format!("{} {:.2}pt", words[i % 2], long * 0.75))
            .collect();
        out.push(format!("dash pattern={},line cap=butt", pattern.join(" ")));
    }
    if let Some(ink) = look.fill {
        out.push(format!("fill=fig{ink}"));
    }
    out.join(",")
}

/// Runs as TeX text with formulas.
fn text(runs: &[TextRun]) -> String {
    let mut out = String::new();
    let mut lowered = false;
    for TextRun { text, style } in runs {
        let below = match style {
            RunStyle::Sub => format!("\\mathrm{{{}}}", formula(text)),
            _ => formula(text),
        };
        let after_another =
            std::mem::replace(&mut lowered, matches!(style, RunStyle::Sub | RunStyle::SubItalic));
        if lowered && after_another {
            // Two indices in a row are one: LaTeX refuses a second.
            out.truncate(out.len() - "}$".len());
            let _ = write!(out, "{below}}}$");
            continue;
        }
        match style {
            RunStyle::Upright => {
                for c in text.chars() {
                    match named(c) {
                        Some(name) => {
                            let _ = write!(out, "${name}{}$", after(&name));
                        }
                        None => out.push_str(&letter(c)),
                    }
                }
            }
            RunStyle::Italic => {
                let _ = write!(out, "${}$", formula(text));
            }
            RunStyle::Sub | RunStyle::SubItalic => {
                let _ = write!(out, "$_{{{below}}}$");
            }
            RunStyle::Super => {
                let _ = write!(out, "$^{{\\mathrm{{{}}}}}$", formula(text));
            }
        }
    }
    // Neighbouring formulas are one.
    out.replace("$$", "")
}

/// A Greek letter or a sign as a command of formulas.
fn named(c: char) -> Option<Cow<'static, str>> {
    if let Some((_, name)) = SIGNS.iter().find(|(sign, _)| *sign == c) {
        return Some(Cow::Borrowed(name));
    }
    // The last name is that of the shape: `\varepsilon`.
    let is_it = |letter: &str| letter.chars().eq([c]);
    let (name, _) = symbol::LETTERS.iter().rev().find(|(_, letter)| is_it(letter))?;
    Some(Cow::Owned(format!("\\{name}")))
}

fn letter(c: char) -> String {
    match c {
        '\u{a0}' => "~".to_owned(),
        '\\' => r"\textbackslash{}".to_owned(),
        '{' | '}' | '%' | '&' | '#' | '_' => format!("\\{c}"),
        // In braces: a formula may begin right after it.
        '$' => r"{\$}".to_owned(),
        '~' => r"\textasciitilde{}".to_owned(),
        '^' => r"\textasciicircum{}".to_owned(),
        c => c.to_string(),
    }
}

fn formula(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match named(c) {
            Some(name) => {
                let _ = write!(out, "{name}{}", after(&name));
            }
            None => out.push_str(&letter(c)),
        }
    }
    // A power with a name of its own would be a second one.
    out.replace(r"^{\circ}", r"\circ")
}

/// A space that keeps the letters after a command from becoming part of its name.
fn after(name: &str) -> &'static str {
    if name.starts_with('\\') { " " } else { "" }
}
