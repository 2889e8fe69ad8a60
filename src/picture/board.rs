//! The drawing board: elements and wishes for labels in pixels with y up; [`Board::finish`] finds places for the labels and
//! makes the picture just large enough for everything.
use crate::picture::frame::Frame;
use crate::picture::place::LabelPlaces;
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Element, Outline, Picture, PlacedLabel, Role, TextRun, symbol};

/// Size of letters, pixels; small ones have three quarters of it.
pub const TEXT: f64 = 16.0;
/// Free space round everything.
const MARGIN: f64 = 10.0;
/// Space between the rows of a label.
const ROWS: f64 = 2.0;
/// The box of an empty board.
const EMPTY: Frame = Frame { low: Vec2::ZERO, high: vec2(1.0, 1.0) };

#[derive(Debug, Clone)]
pub struct LabelWish {
    /// What it says, line by line.
    pub rows: Vec<Vec<TextRun>>,
    /// Size of its letters.
    pub size: f64,
    /// Decides its colour.
    pub role: Role,
    /// Points that it may stand beside, each with the direction from the point to the label; best first.
    pub spots: Vec<(Vec2, Vec2)>,
    /// Distance from the point.
    pub gap: f64,
    /// How it is tied to its first point.
    pub tie: LabelTie,
}

impl LabelWish {
    /// A text in one row that stands here, whatever else it covers.
    pub fn note(runs: Vec<TextRun>, size: f64, at: Vec2, towards: Vec2) -> Self {
        let (rows, spots) = (vec![runs], vec![(at, towards)]);
        Self { rows, size, role: Role::Dot, spots, gap: 4.0, tie: LabelTie::Fixed }
    }
}

/// How a label is tied to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LabelTie {
    /// It stands at its first spot unless another label is there, whatever else it covers.
    Fixed,
    /// It stands close by wherever that can be, whatever it covers but labels.
    Near,
    /// It stands close by if it covers nothing there, else it stands off and has a leader.
    Clear,
    /// It may stand off, without a leader.
    Loose,
    /// It may stand off and has a leader then.
    Leader,
}

/// Places on an arc where its label may stand, at these shares of the way from its begin, in the order of preference.
pub fn on_arc(centre: Vec2, radius: f64, from: f64, turned: f64, shares: &[f64]) -> Vec<(Vec2, Vec2)> {
    let place = |share: &f64| {
        let out = Vec2::at_angle(from + turned * share);
        (centre + out * radius, out)
    };
    shares.iter().map(place).collect()
}
/// From the middle to the ends.
pub const MIDDLE_FIRST: &[f64] = &[0.5, 0.35, 0.65, 0.2, 0.8];

/// The drawing board.
#[derive(Debug, Clone, Default)]
pub struct Board {
    elements: Vec<Element>,
    wishes: Vec<LabelWish>,
}

impl Board {
    /// An empty one.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lines from point to point.
    pub fn lines(&mut self, points: &[Vec2], closed: bool, role: Role) {
        self.elements.push(Element { outline: Outline::Lines { points: points.to_vec(), closed }, role });
    }

    /// A straight line.
    pub fn line(&mut self, from: Vec2, to: Vec2, role: Role) {
        self.lines(&[from, to], false, role);
    }

    pub fn circle(&mut self, centre: Vec2, radius: f64, role: Role) {
        self.elements.push(Element { outline: Outline::Circle { centre, radius }, role });
    }

    /// Part of a circle, angles in radians, counter-clockwise from the right.
    pub fn arc(&mut self, centre: Vec2, radius: f64, from: f64, to: f64, role: Role) {
        self.elements.push(Element { outline: Outline::Arc { centre, radius, from, to }, role });
    }

    /// Arcs, joined by straight lines, and closed.
    pub fn arcs(&mut self, arcs: Vec<(Vec2, f64, f64, f64)>, role: Role) {
        self.elements.push(Element { outline: Outline::Arcs(arcs), role });
    }

    /// A small full point.
    pub fn dot(&mut self, at: Vec2) {
        self.circle(at, 2.6, Role::Dot);
    }

    /// An arrow head with its tip here.
    pub fn head(&mut self, tip: Vec2, towards: Vec2, role: Role) {
        let (long, wide) = match role {
            Role::DimensionHead => (9.0, 2.6),
            Role::MotionHead => (11.0, 4.2),
            _ => (12.5, 4.6),
        };
        let back = tip - towards * long;
        let across = towards.left() * wide;
        // A slight notch, as pens make it.
        let notch = tip - towards * (long * 0.82);
        self.lines(&[tip, back + across, notch, back - across], true, role);
    }

    /// An arrow from point to point.
    pub fn arrow(&mut self, from: Vec2, to: Vec2, role: Role) {
        let towards = (to - from).unit();
        let (head, back) = head_of(role);
        self.line(from, to - towards * back, role);
        self.head(to, towards, head);
    }

    /// An angle of so many degrees, counter-clockwise positive, from a direction on: with a head where there is room for one. Its
    /// size in radians.
    pub fn angle(&mut self, corner: Vec2, radius: f64, zero: f64, degrees: f64) -> f64 {
        let to = zero + degrees * std::f64::consts::PI / 180.0;
        if degrees.abs() * radius < 400.0 {
            self.arc(corner, radius, zero, to, Role::Dimension);
        } else {
            self.curved_arrow(corner, radius, zero, to, Role::Dimension);
        }
        to - zero
    }
    /// An arrow with two heads.
    pub fn double_arrow(&mut self, from: Vec2, to: Vec2, role: Role) {
        let towards = (to - from).unit();
        let (head, back) = head_of(role);
        if (to - from).norm() > 2.0 * back + 4.0 {
            self.line(from + towards * back, to - towards * back, role);
            self.head(from, -towards, head);
            self.head(to, towards, head);
        } else {
            // No room between: the heads come from outside.
            self.arrow(from - towards * 20.0, from, role);
            self.arrow(to + towards * 20.0, to, role);
            self.line(from, to, role);
        }
    }

    /// An arrow along a circle, angles in radians.
    pub fn curved_arrow(&mut self, centre: Vec2, radius: f64, from: f64, to: f64, role: Role) {
        let (_, back) = head_of(role);
        let sense = if to > from { 1.0 } else { -1.0 };
        let end = to - sense * back / radius.max(1.0);
        self.arc(centre, radius, from, end, role);
        self.curved_head(centre, radius, to, sense, role);
    }

    /// The head of a curved arrow that ends here.
    pub fn curved_head(&mut self, centre: Vec2, radius: f64, to: f64, sense: f64, role: Role) {
        let (head, _) = head_of(role);
        let tip = centre + Vec2::at_angle(to) * radius;
        // The head points along its own chord.
        let base = centre + Vec2::at_angle(to - sense * 10.0 / radius.max(1.0)) * radius;
        self.head(tip, (tip - base).unit(), head);
    }

    /// Hatching along a line; the solid lies on the side `into` (a unit vector).
    pub fn hatch(&mut self, from: Vec2, to: Vec2, into: Vec2) {
        let towards = (to - from).unit();
        let long = (to - from).norm();
        let (step, deep) = (9.0, 8.5);
        let stroke = towards * -deep + into * deep;
        let mut s = step;
        while s < long + 0.1 {
            let top = from + towards * s;
            self.line(top, top + stroke, Role::Hatch);
            s += step;
        }
    }

    /// A spring between two points.
    pub fn spring(&mut self, from: Vec2, to: Vec2, coils: usize, wide: f64) {
        let towards = (to - from).unit();
        let across = towards.left();
        let long = (to - from).norm();
        let lead = (long * 0.1).clamp(4.0, 14.0).min(long * 0.3);
        let half = (long - 2.0 * lead) / (2 * coils.max(1)) as f64;
        let mut points = vec![from, from + towards * lead];
        for i in 0..2 * coils {
            let side = if i % 2 == 0 { wide } else { -wide };
            let at = from + towards * (lead + half * (i as f64 + 0.5));
            points.push(at + across * side);
        }
        points.push(to - towards * lead);
        points.push(to);
        self.lines(&points, false, Role::Spring);
    }

    /// Wishes a label at one of several spots, best first.
    pub fn wish(&mut self, runs: Vec<TextRun>, spots: Vec<(Vec2, Vec2)>, role: Role) {
        self.label(vec![runs], role, (LabelTie::Leader, 5.0), spots);
    }

    /// Wishes a label of some rows, tied to its point in this way at this distance, at one of several spots, best first.
    pub fn label(
        &mut self,
        rows: Vec<Vec<TextRun>>,
        role: Role,
        (tie, gap): (LabelTie, f64),
        spots: Vec<(Vec2, Vec2)>,
    ) {
        self.wish_for(LabelWish { rows, size: TEXT, role, spots, gap, tie });
    }

    /// Wishes a label with all its details.
    pub fn wish_for(&mut self, mut wish: LabelWish) {
        wish.rows.retain(|runs| runs.iter().any(|r| !r.text.is_empty()));
        if !wish.spots.is_empty() && !wish.rows.is_empty() {
            self.wishes.push(wish);
        }
    }

    /// The box of all elements so far; `None` if there are none.
    pub fn frame(&self) -> Option<Frame> {
        let of = |element: &Element| match &element.outline {
            Outline::Lines { points, .. } => Frame::round(points.iter().copied()),
            Outline::Circle { centre, radius } => Some(Frame::about(*centre, vec2(*radius, *radius))),
            Outline::Arc { centre, radius, from, to } => {
                Frame::round(Vec2::on_arc(*centre, *radius, (*from, *to), 16))
            }
            Outline::Arcs(arcs) => {
                Frame::round(arcs.iter().flat_map(|(c, r, from, to)| Vec2::on_arc(*c, *r, (*from, *to), 16)))
            }
        };
        self.elements.iter().filter_map(of).reduce(Frame::joined)
    }

    /// Moves everything that is there.
    pub fn shift(&mut self, by: Vec2) {
        for element in &mut self.elements {
            match &mut element.outline {
                Outline::Lines { points, .. } => points.iter_mut().for_each(|p| *p += by),
                Outline::Circle { centre, .. } | Outline::Arc { centre, .. } => *centre += by,
                Outline::Arcs(arcs) => arcs.iter_mut().for_each(|(centre, ..)| *centre += by),
            }
        }
        for wish in &mut self.wishes {
            wish.spots.iter_mut().for_each(|(p, _)| *p += by);
        }
    }

    /// Puts another board to the right of this one.
    pub fn beside(&mut self, mut other: Board) {
        if let (Some(mine), Some(theirs)) = (self.frame(), other.frame()) {
            other.shift(vec2(mine.high.x + 60.0 - theirs.low.x, 0.0));
        }
        self.put(other);
    }

    /// Puts another board on top of this one.
    pub fn put(&mut self, other: Board) {
        self.elements.extend(other.elements);
        self.wishes.extend(other.wishes);
    }

    /// Finds places for the labels and makes the picture.
    pub fn finish(mut self, title: String, desc: String) -> Picture {
        let placed = self.place();
        let frame = self.frame().unwrap_or(EMPTY);
        let Frame { low, high } = placed.iter().map(|(_, f)| *f).fold(frame, Frame::joined);
        // Whole pixels, so that equal pictures have equal sizes.
        let (x0, y1) = (low.x.floor() - MARGIN, high.y.ceil() + MARGIN);
        let (width, height) = (high.x.ceil() + MARGIN - x0, y1 - (low.y.floor() - MARGIN));
        let flip = |p: Vec2| vec2(p.x - x0, y1 - p.y);
        let flipped = |e: Element| Element { outline: e.outline.map(flip), ..e };
        let elements = self.elements.into_iter().map(flipped).collect();
        let mut labels = Vec::with_capacity(placed.len());
        for (wish, f) in placed {
            let (middle, mut top) = ((f.low.x + f.high.x) / 2.0, f.high.y);
            for runs in wish.rows {
                let half = half_of(&runs, wish.size);
                let low = flip(vec2(middle - half.x, top));
                let high = flip(vec2(middle + half.x, top - 2.0 * half.y));
                top -= 2.0 * half.y + ROWS;
                labels.push(PlacedLabel {
                    at: vec2(low.x, high.y - symbol::depth(&runs) * wish.size),
                    runs,
                    size: wish.size,
                    bounds: Frame { low, high },
                    role: wish.role,
                });
            }
        }
        Picture { width, height, title, desc, elements, labels }
    }

    /// The labels with their boxes; leaders become elements.
    fn place(&mut self) -> Vec<(LabelWish, Frame)> {
        let mut places = LabelPlaces::new(&self.elements, self.frame().unwrap_or(EMPTY));
        let mut placed = Vec::with_capacity(self.wishes.len());
        for wish in std::mem::take(&mut self.wishes) {
            let rows = wish.rows.iter().map(|runs| half_of(runs, wish.size));
            let half = rows
                .fold(vec2(0.0, -ROWS / 2.0), |all, row| vec2(all.x.max(row.x), all.y + row.y + ROWS / 2.0));
            let (frame, leader) = places.place(&wish, half);
            self.elements.extend(leader);
            placed.push((wish, frame));
        }
        placed
    }
}

/// Half the size of a row.
fn half_of(runs: &[TextRun], size: f64) -> Vec2 {
    vec2(symbol::width(runs, size) / 2.0, (symbol::height(runs) + symbol::depth(runs)) * size / 2.0)
}

/// Head and length to leave for it, by the role of the line.
fn head_of(role: Role) -> (Role, f64) {
    match role {
        Role::Dimension => (Role::DimensionHead, 7.0),
        Role::Motion => (Role::MotionHead, 9.0),
        Role::Friction => (Role::FrictionHead, 10.0),
        _ => (Role::ForceHead, 10.0),
    }
}
