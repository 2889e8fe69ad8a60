//! Pictures as TikZ: needs `\usepackage{tikz}` and nothing else.
use crate::figure::picture::Outline;
use crate::figure::picture::Picture;
use crate::figure::picture::Point;
use crate::figure::picture::Role;
use crate::figure::picture::Run;
use crate::figure::picture::RunStyle;
use crate::figure::svg;
use crate::figure::svg::Coordinate;
use std::fmt::Write as _;

/// Greek letters and signs that TeX fonts have under a name.
const NAMES: &[(char, &str)] = &[
    ('α', r"\alpha"),
    ('β', r"\beta"),
    ('γ', r"\gamma"),
    ('δ', r"\delta"),
    ('ε', r"\varepsilon"),
    ('ζ', r"\zeta"),
    ('η', r"\eta"),
    ('θ', r"\theta"),
    ('ϑ', r"\vartheta"),
    ('ι', r"\iota"),
    ('κ', r"\kappa"),
    ('λ', r"\lambda"),
    ('μ', r"\mu"),
    ('µ', r"\mu"),
    ('ν', r"\nu"),
    ('ξ', r"\xi"),
    ('π', r"\pi"),
    ('ρ', r"\rho"),
    ('σ', r"\sigma"),
    ('τ', r"\tau"),
    ('υ', r"\upsilon"),
    ('φ', r"\varphi"),
    ('ϕ', r"\phi"),
    ('χ', r"\chi"),
    ('ψ', r"\psi"),
    ('ω', r"\omega"),
    ('Γ', r"\Gamma"),
    ('Δ', r"\Delta"),
    ('Θ', r"\Theta"),
    ('Λ', r"\Lambda"),
    ('Ξ', r"\Xi"),
    ('Π', r"\Pi"),
    ('Σ', r"\Sigma"),
    ('Φ', r"\Phi"),
    ('Ψ', r"\Psi"),
    ('Ω', r"\Omega"),
    ('ℓ', r"\ell"),
    ('−', "-"),
    ('=', "="),
    ('<', "<"),
    ('>', ">"),
    ('|', r"\vert"),
    ('·', r"\cdot"),
    ('×', r"\times"),
    ('±', r"\pm"),
    ('≤', r"\leq"),
    ('≥', r"\geq"),
    ('°', r"^{\circ}"),
    ('′', "'"),
];

/// The picture as a `tikzpicture`; one pixel is 0.75 pt.
pub fn picture(picture: &Picture) -> String {
    let mut out = String::with_capacity(8192);
    for line in picture.title.lines().chain(picture.desc.lines()) {
        let _ = writeln!(out, "% {}", line.replace(char::is_control, " "));
    }
    out.push_str("\\begin{tikzpicture}[x=0.75pt,y=-0.75pt,line cap=round,line join=round]\n");
    let mut used: Vec<&str> = Vec::new();
    for role in picture.shapes.iter().map(|s| s.role) {
        let (_, look) = svg::look(role);
        used.extend(look.fill);
        used.extend(look.stroke.map(|(ink, _)| ink));
    }
    used.extend(picture.labels.iter().map(|l| svg::letters(l.role)));
    for ink in svg::INKS.iter().filter(|i| used.contains(&i.name)) {
        let hex = ink.light.trim_start_matches('#').to_uppercase();
        let _ = writeln!(out, "\\definecolor{{fig{}}}{{HTML}}{{{hex}}}", ink.name);
    }
    // The box is the picture's own, so that pictures line up.
    let _ = writeln!(
        out,
        "\\useasboundingbox (0,0) rectangle ({},{});",
        Coordinate(picture.width),
        Coordinate(picture.height)
    );
    for shape in &picture.shapes {
        let _ = write!(out, "\\path[{}] ", options(shape.role));
        match &shape.outline {
            Outline::Lines { points, closed } => {
                let list: Vec<String> = points.iter().map(|p| place(*p)).collect();
                out.push_str(&list.join(" -- "));
                if *closed {
                    out.push_str(" -- cycle");
                }
            }
            Outline::Circle { centre, radius } => {
                let _ = write!(out, "{} circle[radius={}pt]", place(*centre), Coordinate(radius * 0.75));
            }
            Outline::Arc { centre, radius, from, to } => {
                // The y axis points down, radii in points do not follow it: angles stay as seen.
                let (c, s) = crate::figure::vector::polar(*from);
                let start = place((centre.0 + radius * c, centre.1 - radius * s));
                let _ = write!(
                    out,
                    "{start} arc[start angle={},end angle={},radius={}pt]",
                    Coordinate(from.to_degrees()),
                    Coordinate(to.to_degrees()),
                    Coordinate(radius * 0.75)
                );
            }
        }
        out.push_str(";\n");
    }
    for label in &picture.labels {
        let centre = (label.bounds.0 + label.bounds.2) / 2.0;
        let size = Coordinate(label.size * 0.75);
        let _ = writeln!(
            out,
            "\\node[anchor=base,inner sep=0pt,fig{},font=\\fontsize{{{size}}}{{{size}}}\\selectfont] at {} {{{}}};",
            svg::letters(label.role),
            place((centre, label.at.1)),
            text(&label.runs)
        );
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn place(p: Point) -> String {
    format!("({},{})", Coordinate(p.0), Coordinate(p.1))
}

fn options(role: Role) -> String {
    let (_, look) = svg::look(role);
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
fn text(runs: &[Run]) -> String {
    let mut out = String::new();
    for Run { text, style } in runs {
        match style {
            RunStyle::Upright => {
                for c in text.chars() {
                    match named(c) {
                        Some(name) => {
                            let _ = write!(out, "${name}{}$", after(name));
                        }
                        None => out.push_str(&letter(c)),
                    }
                }
            }
            RunStyle::Italic => {
                let _ = write!(out, "${}$", formula(text));
            }
            RunStyle::Sub => {
                let _ = write!(out, "$_{{\\mathrm{{{}}}}}$", formula(text));
            }
            RunStyle::SubItalic => {
                let _ = write!(out, "$_{{{}}}$", formula(text));
            }
            RunStyle::Super => {
                let _ = write!(out, "$^{{\\mathrm{{{}}}}}$", formula(text));
            }
        }
    }
    // Neighbouring formulas are one.
    out.replace("$$", "")
}

fn named(c: char) -> Option<&'static str> {
    NAMES.iter().find(|(n, _)| *n == c).map(|(_, name)| *name)
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
                let _ = write!(out, "{name}{}", after(name));
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
