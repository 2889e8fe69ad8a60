//! How the elements of a picture look: ink, width of the line and dash of each role, the same in every format.
//!
//! Lines differ by width and dash, areas by pattern, so that pictures read in black and white; colours are those of Okabe and
//! Ito, darkened for letters.
use crate::picture::{Picture, Role};
use std::collections::BTreeSet;

/// A colour on light and on dark paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ink {
    /// Name of its variable.
    pub name: &'static str,
    /// On light paper.
    pub light: &'static str,
    /// On dark paper.
    pub dark: &'static str,
}

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

/// Inks of the areas of a graph, by number.
const AREAS: [&str; 6] = ["area0", "area1", "area2", "area3", "area4", "area5"];

/// How a role is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Ink of the line, and its width; `None`: no line.
    pub stroke: Option<(&'static str, f64)>,
    pub dash: &'static str,
    /// Ink of the area; `None`: empty.
    pub fill: Option<&'static str>,
}

/// Class name and look of a role.
pub fn look(role: Role) -> (&'static str, Look) {
    let dashed = |ink, width, dash| Look { stroke: Some((ink, width)), dash, fill: None };
    let line = |ink, width| dashed(ink, width, "");
    let full = |ink| Look { stroke: None, dash: "", fill: Some(ink) };
    let area = |ink, width, fill| Look { fill: Some(fill), ..line(ink, width) };
    match role {
        Role::Body => ("body", area("ink", 1.9, "body")),
        Role::Inner => ("inner", area("ink", 1.3, "inner")),
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
        Role::MotionHead => ("motionhead", area("motion", 1.4, "paper")),
        Role::Axis => ("axis", line("ink", 1.2)),
        Role::Grid => ("grid", line("faint", 0.9)),
        Role::Curve(n) => match n % 4 {
            0 => ("curve0", line("motion", 2.3)),
            1 => ("curve1", dashed("friction", 2.3, "8 3")),
            2 => ("curve2", dashed("force", 1.8, "2.5 3")),
            _ => ("curve3", dashed("spring", 2.1, "9 3 2 3")),
        },
        Role::Area(n) => {
            let name = AREAS[usize::from(n) % AREAS.len()];
            (name, area("ink", 1.0, name))
        }
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

/// The roles of a picture's elements, each once, and the inks of these and of its letters.
pub fn used(picture: &Picture) -> (BTreeSet<Role>, BTreeSet<&'static str>) {
    let roles: BTreeSet<Role> = picture.elements.iter().map(|e| e.role).collect();
    let drawn = roles.iter().map(|role| look(*role).1);
    let drawn = drawn.flat_map(|look| [look.fill, look.stroke.map(|(ink, _)| ink)]).flatten();
    let inks = drawn.chain(picture.labels.iter().map(|l| letters(l.role))).collect();
    (roles, inks)
}
