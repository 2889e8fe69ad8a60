//! Placed shapes and labels: what a picture is before anybody decides how it looks. Coordinates are CSS pixels (1/96 inch),
//! x to the right, y down; the picture is the box from (0, 0) to (width, height).
//!
//! Figures of scenes and charts of numbers are made of the same elements, by the same writer of SVG ([`svg`]).
use crate::picture::frame::Frame;
use crate::picture::vector::Vec2;

pub(crate) mod board;
pub mod frame;
pub(crate) mod look;
pub(crate) mod place;
pub mod svg;
pub mod symbol;
pub mod tikz;
pub mod vector;

/// A picture, laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width, > 0.
    pub width: f64,
    /// Height, > 0.
    pub height: f64,
    /// What it is, in a few words.
    pub title: String,
    /// What it shows, in sentences, for those who do not see it.
    pub desc: String,
    /// Elements, from back to front.
    pub elements: Vec<Element>,
    /// Labels, in front of all elements.
    pub labels: Vec<PlacedLabel>,
}

/// A placed element.
#[derive(Debug, Clone, PartialEq)]
pub struct Element {
    /// Its outline.
    pub outline: Outline,
    /// What it stands for; decides line, fill and colour.
    pub role: Role,
}

/// The outline of an element.
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// Straight lines from point to point.
    Lines {
        /// The points.
        points: Vec<Vec2>,
        /// Back to the first one?
        closed: bool,
    },
    /// A full circle.
    Circle {
        /// Its centre.
        centre: Vec2,
        /// Its radius.
        radius: f64,
    },
    /// Part of a circle.
    Arc {
        /// Its centre.
        centre: Vec2,
        /// Its radius.
        radius: f64,
        /// Where it begins, radians, counter-clockwise from the right as seen.
        from: f64,
        /// Where it ends; the arc runs counter-clockwise from `from` if this is greater, else clockwise.
        to: f64,
    },
    /// Arcs, joined by straight lines, and closed: centre, radius, where each begins and ends, as for [`Self::Arc`].
    Arcs(Vec<(Vec2, f64, f64, f64)>),
}

impl Outline {
    /// The same with its points elsewhere.
    pub fn map(self, place: impl Fn(Vec2) -> Vec2) -> Self {
        match self {
            Self::Lines { points, closed } => {
                Self::Lines { points: points.into_iter().map(place).collect(), closed }
            }
            Self::Circle { centre, radius } => Self::Circle { centre: place(centre), radius },
            Self::Arc { centre, radius, from, to } => Self::Arc { centre: place(centre), radius, from, to },
            Self::Arcs(arcs) => {
                Self::Arcs(arcs.into_iter().map(|(c, r, a, b)| (place(c), r, a, b)).collect())
            }
        }
    }
}

/// What an element stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Edge of a body, filled with the body's tint.
    Body,
    /// A second, lighter part of a body: its hub, its spokes.
    Inner,
    /// Surface of the ground or of a support.
    Ground,
    /// Hatching behind a surface.
    Hatch,
    /// A cord.
    Cord,
    /// A spring.
    Spring,
    /// A pin or a mass centre: small and full.
    Dot,
    /// Thin line of a dimension, an axis, an angle; with [`Role::DimensionHead`].
    Dimension,
    /// Arrow head of a dimension, full.
    DimensionHead,
    /// A construction line, dashed: another position, a reference direction.
    Ghost,
    /// Arrow of a force that is given, with [`Role::ForceHead`].
    Force,
    /// Its head, full.
    ForceHead,
    /// Arrow of a friction force.
    Friction,
    /// Its head.
    FrictionHead,
    /// Arrow of a velocity, a positive sense, an acceleration, `m a`, `I alpha`.
    Motion,
    /// Its head.
    MotionHead,
    /// Axis of a graph.
    Axis,
    /// Grid line of a graph.
    Grid,
    /// Curve of a graph, by number: each has a dash and a colour of its own.
    Curve(u8),
    /// Full area of a graph (a bar), by number, with a pattern that survives black and white.
    Area(u8),
    /// Background that hides what is behind it.
    Paper,
}

/// A label: runs of text, placed.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedLabel {
    /// What it says.
    pub runs: Vec<TextRun>,
    /// Left end of its base line.
    pub at: Vec2,
    /// Size of its letters.
    pub size: f64,
    /// Its box. Boxes of labels do not overlap and do not leave the picture.
    pub bounds: Frame,
    /// What it stands for; decides its colour.
    pub role: Role,
}

/// A piece of a label.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextRun {
    /// The letters.
    pub text: String,
    /// How they stand.
    pub style: RunStyle,
}

/// How a piece of a label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunStyle {
    /// Upright: numbers, units, words.
    Upright,
    /// Italic: symbols of quantities.
    Italic,
    /// Lowered and small, upright.
    Sub,
    /// Lowered and small, italic.
    SubItalic,
    /// Raised and small: powers in units.
    Super,
}
