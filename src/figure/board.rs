//! The drawing board: shapes and wishes for labels in pixels with y up; [`Board::finish`] finds places for the labels and
//! makes the picture just large enough for everything.
//!
//! Labels are placed one after the other, in the order of the wishes. Each tries its wished spots, then rings round the first
//! one; a label far from its spot gets a thin leader. Other labels are never covered, lines only where all is crowded.
use crate::figure::picture::Label;
use crate::figure::picture::Outline;
use crate::figure::picture::Picture;
use crate::figure::picture::Point;
use crate::figure::picture::Role;
use crate::figure::picture::Run;
use crate::figure::picture::Shape;
use crate::figure::symbol;
use crate::figure::vector::V;
use crate::figure::vector::add;
use crate::figure::vector::along;
use crate::figure::vector::angle;
use crate::figure::vector::left;
use crate::figure::vector::mul;
use crate::figure::vector::polar;
use crate::figure::vector::size;
use crate::figure::vector::sub;
use crate::figure::vector::unit;
use std::f64::consts::PI;

/// Size of letters, pixels; small ones have three quarters of it.
pub const TEXT: f64 = 16.0;
/// Free space round everything.
const MARGIN: f64 = 10.0;
/// Least distance between a label and what is not its own.
const CLEAR: f64 = 3.0;
/// From this distance on a label gets a leader.
const LEADER_FROM: f64 = 16.0;

/// A box: left, bottom, right, top.
type Frame = (f64, f64, f64, f64);

/// The best place so far: what it costs, the box, the leader.
type Best = Option<(f64, Frame, Option<(V, V)>)>;

/// A wish for a label.
#[derive(Debug, Clone)]
pub struct Wish {
    /// What it says, line by line.
    pub rows: Vec<Vec<Run>>,
    /// Size of its letters.
    pub size: f64,
    /// Decides its colour.
    pub role: Role,
    /// Points that it may stand beside, each with the direction from the point to the label; best first.
    pub spots: Vec<(V, V)>,
    /// Distance from the point.
    pub gap: f64,
    /// How it is tied to its first point.
    pub tie: Tied,
}

/// How a label is tied to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tied {
    /// It stands at its first spot unless another label is there, whatever else it covers.
    Fixed,
    /// It stands close by wherever that can be, whatever it covers but labels.
    Near,
    /// It may stand off, without a leader.
    Loose,
    /// It may stand off and has a leader then.
    Leader,
}

/// The drawing board.
#[derive(Debug, Clone, Default)]
pub struct Board {
    shapes: Vec<Shape>,
    wishes: Vec<Wish>,
}

impl Board {
    /// An empty one.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lines from point to point.
    pub fn lines(&mut self, points: &[V], closed: bool, role: Role) {
        self.shapes.push(Shape { outline: Outline::Lines { points: points.to_vec(), closed }, role });
    }

    /// A straight line.
    pub fn line(&mut self, from: V, to: V, role: Role) {
        self.lines(&[from, to], false, role);
    }

    /// A circle.
    pub fn circle(&mut self, centre: V, radius: f64, role: Role) {
        self.shapes.push(Shape { outline: Outline::Circle { centre, radius }, role });
    }

    /// Part of a circle, angles in radians, counter-clockwise from the right.
    pub fn arc(&mut self, centre: V, radius: f64, from: f64, to: f64, role: Role) {
        self.shapes.push(Shape { outline: Outline::Arc { centre, radius, from, to }, role });
    }

    /// A small full point.
    pub fn dot(&mut self, at: V) {
        self.circle(at, 2.6, Role::Dot);
    }

    /// An arrow head with its tip here.
    pub fn head(&mut self, tip: V, towards: V, role: Role) {
        let (long, wide) = match role {
            Role::DimensionHead => (9.0, 2.6),
            Role::MotionHead => (11.0, 4.2),
            _ => (12.5, 4.6),
        };
        let back = along(tip, towards, -long);
        let across = mul(left(towards), wide);
        // A slight notch, as pens make it.
        let notch = along(tip, towards, -long * 0.82);
        self.lines(&[tip, add(back, across), notch, sub(back, across)], true, role);
    }

    /// An arrow from point to point.
    pub fn arrow(&mut self, from: V, to: V, role: Role) {
        let towards = unit(sub(to, from));
        let (head, back) = head_of(role);
        self.line(from, along(to, towards, -back), role);
        self.head(to, towards, head);
    }

    /// An arrow with two heads.
    pub fn double_arrow(&mut self, from: V, to: V, role: Role) {
        let towards = unit(sub(to, from));
        let (head, back) = head_of(role);
        if size(sub(to, from)) > 2.0 * back + 4.0 {
            self.line(along(from, towards, back), along(to, towards, -back), role);
            self.head(from, mul(towards, -1.0), head);
            self.head(to, towards, head);
        } else {
            // No room between: the heads come from outside.
            self.arrow(along(from, towards, -20.0), from, role);
            self.arrow(along(to, towards, 20.0), to, role);
            self.line(from, to, role);
        }
    }

    /// An arrow along a circle, angles in radians.
    pub fn curved_arrow(&mut self, centre: V, radius: f64, from: f64, to: f64, role: Role) {
        let (head, back) = head_of(role);
        let sense = if to > from { 1.0 } else { -1.0 };
        let end = to - sense * back / radius.max(1.0);
        self.arc(centre, radius, from, end, role);
        let tip = along(centre, polar(to), radius);
        // The head points along its own chord.
        let base = along(centre, polar(to - sense * 10.0 / radius.max(1.0)), radius);
        self.head(tip, unit(sub(tip, base)), head);
    }

    /// Hatching along a line; the solid lies on the side `into` (a unit vector).
    pub fn hatch(&mut self, from: V, to: V, into: V) {
        let towards = unit(sub(to, from));
        let long = size(sub(to, from));
        let (step, deep) = (9.0, 8.5);
        let stroke = add(mul(towards, -deep), mul(into, deep));
        let mut s = step;
        while s < long + 0.1 {
            let top = along(from, towards, s);
            self.line(top, add(top, stroke), Role::Hatch);
            s += step;
        }
    }

    /// A spring between two points.
    pub fn spring(&mut self, from: V, to: V, coils: usize, wide: f64) {
        let towards = unit(sub(to, from));
        let across = left(towards);
        let long = size(sub(to, from));
        let lead = (long * 0.1).clamp(4.0, 14.0).min(long * 0.3);
        let half = (long - 2.0 * lead) / (2 * coils.max(1)) as f64;
        let mut points = vec![from, along(from, towards, lead)];
        for i in 0..2 * coils {
            let side = if i % 2 == 0 { wide } else { -wide };
            let at = along(from, towards, lead + half * (i as f64 + 0.5));
            points.push(along(at, across, side));
        }
        points.push(along(to, towards, -lead));
        points.push(to);
        self.lines(&points, false, Role::Spring);
    }

    /// Wishes a label at one of several spots, best first.
    pub fn wish(&mut self, runs: Vec<Run>, spots: Vec<(V, V)>, role: Role) {
        self.wish_for(Wish { rows: vec![runs], size: TEXT, role, spots, gap: 5.0, tie: Tied::Leader });
    }

    /// Wishes a label with all its details.
    pub fn wish_for(&mut self, mut wish: Wish) {
        wish.rows.retain(|runs| runs.iter().any(|r| !r.text.is_empty()));
        if !wish.spots.is_empty() && !wish.rows.is_empty() {
            self.wishes.push(wish);
        }
    }

    /// The box of all shapes so far: left, bottom, right, top; `None` if there are none.
    pub fn frame(&self) -> Option<Frame> {
        let mut frame: Option<Frame> = None;
        for shape in &self.shapes {
            let f = extent(&shape.outline);
            frame = Some(frame.map_or(f, |g| joined(g, f)));
        }
        frame
    }

    /// Moves everything that is there.
    pub fn shift(&mut self, by: V) {
        for shape in &mut self.shapes {
            match &mut shape.outline {
                Outline::Lines { points, .. } => points.iter_mut().for_each(|p| *p = add(*p, by)),
                Outline::Circle { centre, .. } | Outline::Arc { centre, .. } => *centre = add(*centre, by),
            }
        }
        for wish in &mut self.wishes {
            wish.spots.iter_mut().for_each(|(p, _)| *p = add(*p, by));
        }
    }

    /// Puts another board to the right of this one.
    pub fn beside(&mut self, mut other: Board) {
        if let (Some(mine), Some(theirs)) = (self.frame(), other.frame()) {
            other.shift((mine.2 + 60.0 - theirs.0, 0.0));
        }
        self.put(other);
    }

    /// Puts another board on top of this one.
    pub fn put(&mut self, other: Board) {
        self.shapes.extend(other.shapes);
        self.wishes.extend(other.wishes);
    }

    /// Finds places for the labels and makes the picture.
    pub fn finish(mut self, title: String, desc: String) -> Picture {
        let placed = self.place();
        let mut frame = self.frame().unwrap_or((0.0, 0.0, 1.0, 1.0));
        for (_, f) in &placed {
            frame = joined(frame, *f);
        }
        // Whole pixels, so that equal pictures have equal sizes.
        let (x0, y1) = (frame.0.floor() - MARGIN, frame.3.ceil() + MARGIN);
        let (width, height) = (frame.2.ceil() + MARGIN - x0, y1 - (frame.1.floor() - MARGIN));
        let flip = |p: V| (p.0 - x0, y1 - p.1);
        let shapes = self.shapes.into_iter().map(|s| Shape {
            role: s.role,
            outline: match s.outline {
                Outline::Lines { points, closed } => {
                    Outline::Lines { points: points.into_iter().map(flip).collect(), closed }
                }
                Outline::Circle { centre, radius } => Outline::Circle { centre: flip(centre), radius },
                Outline::Arc { centre, radius, from, to } => {
                    Outline::Arc { centre: flip(centre), radius, from, to }
                }
            },
        });
        let mut labels = Vec::with_capacity(placed.len());
        for (wish, f) in placed {
            let (middle, mut top) = ((f.0 + f.2) / 2.0, f.3);
            for runs in wish.rows {
                let (half, high) = half_of(&runs, wish.size);
                let (left, upper) = flip((middle - half, top));
                let (right, bottom) = flip((middle + half, top - 2.0 * high));
                top -= 2.0 * high + ROWS;
                labels.push(Label {
                    at: (left, bottom - symbol::depth(&runs) * wish.size),
                    runs,
                    size: wish.size,
                    bounds: (left, upper, right, bottom),
                    role: wish.role,
                });
            }
        }
        Picture { width, height, title, desc, shapes: shapes.collect(), labels }
    }

    /// The labels with their boxes; leaders become shapes.
    fn place(&mut self) -> Vec<(Wish, Frame)> {
        let mut obstacles = Obstacles::new(&self.shapes);
        let whole = self.frame().unwrap_or((0.0, 0.0, 1.0, 1.0));
        let mut taken: Vec<Frame> = Vec::with_capacity(self.wishes.len());
        let mut placed: Vec<(Wish, Frame)> = Vec::with_capacity(self.wishes.len());
        for wish in std::mem::take(&mut self.wishes) {
            let halves = wish.rows.iter().map(|runs| half_of(runs, wish.size));
            let half =
                halves.fold((0.0f64, -ROWS / 2.0), |all, row| (all.0.max(row.0), all.1 + row.1 + ROWS / 2.0));
            let mut best: Best = None;
            let consider = |best: &mut Best, base: f64, point: V, towards: V, gap: f64| {
                if best.as_ref().is_some_and(|b| b.0 <= base) {
                    return;
                }
                let reach = half.0 * towards.0.abs() + half.1 * towards.1.abs();
                let centre = along(point, towards, gap + reach);
                let frame = (centre.0 - half.0, centre.1 - half.1, centre.0 + half.0, centre.1 + half.1);
                let wide = grown(frame, CLEAR);
                if taken.iter().any(|t| overlap(wide, *t)) || crosses_any(&obstacles.leaders, wide) {
                    return;
                }
                let mut cost = base + obstacles.cost(wide);
                let leader = (gap >= LEADER_FROM && wish.tie == Tied::Leader).then(|| {
                    let near = nearest(grown(frame, 1.5), point);
                    (near, point)
                });
                if let Some((a, b)) = leader {
                    if taken.iter().any(|t| segment_meets(a, b, *t)) {
                        return;
                    }
                    cost += 0.3 * obstacles.crossings(a, b);
                }
                // Beyond what is drawn the picture has to grow.
                let outside = (whole.0 - frame.0).max(frame.2 - whole.2).max(0.0)
                    + (whole.1 - frame.1).max(frame.3 - whole.3).max(0.0);
                cost += outside * 0.02;
                if best.as_ref().is_none_or(|b| cost < b.0) {
                    *best = Some((cost, frame, leader));
                }
            };
            if wish.tie == Tied::Fixed {
                let (point, towards) = wish.spots[0];
                let reach = half.0 * towards.0.abs() + half.1 * towards.1.abs();
                let centre = along(point, towards, wish.gap + reach);
                let frame = (centre.0 - half.0, centre.1 - half.1, centre.0 + half.0, centre.1 + half.1);
                if !taken.iter().any(|t| overlap(grown(frame, 1.0), *t)) {
                    best = Some((-1.0, frame, None));
                }
            }
            for (i, (point, towards)) in wish.spots.iter().enumerate() {
                for (ring, gap) in [0.0, 5.0, 10.0].into_iter().enumerate() {
                    if wish.gap + gap < LEADER_FROM || ring == 0 {
                        let gap = (wish.gap + gap).min(LEADER_FROM.max(wish.gap + 1.0) - 1.0);
                        consider(&mut best, i as f64 * 1.5 + ring as f64 * 1.2, *point, *towards, gap);
                    }
                }
            }
            let (point, towards) = wish.spots[0];
            let start = angle(towards);
            let rings: &[f64] =
                if matches!(wish.tie, Tied::Near | Tied::Fixed) { &RINGS[..3] } else { &RINGS };
            for (ring, gap) in rings.iter().enumerate() {
                for turn in 0..24 {
                    let off = f64::from((turn + 1) / 2) * if turn % 2 == 0 { 1.0 } else { -1.0 };
                    let base = 5.0 + 2.0 * ring as f64 + 0.45 * off.abs();
                    consider(&mut best, base, point, polar(start + off * PI / 12.0), wish.gap + gap);
                }
            }
            // Room is always found farther out.
            let mut far = whole.2 - whole.0 + whole.3 - whole.1;
            while best.is_none() {
                for turn in 0..24 {
                    consider(&mut best, 1e6 + far, point, polar(f64::from(turn) * PI / 12.0), far);
                }
                far *= 1.3;
                if !far.is_finite() || far > 1e9 {
                    // Even leaders may cross there.
                    let y = taken.iter().map(|t| t.3).fold(whole.3, f64::max) + 8.0;
                    best = Some((0.0, (point.0, y, point.0 + 2.0 * half.0, y + 2.0 * half.1), None));
                }
            }
            if let Some((_, frame, leader)) = best {
                if let Some((from, to)) = leader {
                    let shape = Shape {
                        outline: Outline::Lines { points: vec![from, to], closed: false },
                        role: Role::Dimension,
                    };
                    obstacles.add(&shape);
                    obstacles.leaders.push((from, to));
                    self.shapes.push(shape);
                }
                taken.push(frame);
                placed.push((wish, frame));
            }
        }
        placed
    }
}

/// Space between the rows of a label.
const ROWS: f64 = 2.0;

/// Half the size of a row.
fn half_of(runs: &[Run], size: f64) -> V {
    (symbol::width(runs, size) / 2.0, (symbol::height(runs) + symbol::depth(runs)) * size / 2.0)
}

/// Distances of the rings on which places are looked for.
const RINGS: [f64; 10] = [0.0, 5.0, 10.0, 16.0, 26.0, 38.0, 54.0, 74.0, 100.0, 135.0];

/// Head and length to leave for it, by the role of the line.
fn head_of(role: Role) -> (Role, f64) {
    match role {
        Role::Dimension => (Role::DimensionHead, 7.0),
        Role::Motion => (Role::MotionHead, 9.0),
        Role::Friction => (Role::FrictionHead, 10.0),
        _ => (Role::ForceHead, 10.0),
    }
}

/// How much a label on such a line disturbs; 0: not at all.
fn weight(role: Role) -> f64 {
    match role {
        Role::Force | Role::Friction | Role::Motion => 30.0,
        Role::ForceHead | Role::FrictionHead | Role::MotionHead | Role::Dot => 30.0,
        Role::Cord | Role::Spring | Role::Body | Role::Ground => 28.0,
        Role::Inner => 14.0,
        Role::Curve(_) | Role::Axis | Role::Area(_) => 16.0,
        Role::DimensionHead => 7.0,
        Role::Dimension => 6.0,
        Role::Hatch => 3.0,
        Role::Ghost => 12.0,
        Role::Grid => 0.8,
        Role::Paper => 0.0,
    }
}

/// What labels should not cover.
struct Obstacles {
    segments: Vec<(V, V, Frame, f64)>,
    circles: Vec<(V, f64, f64)>,
    leaders: Vec<(V, V)>,
}

impl Obstacles {
    fn new(shapes: &[Shape]) -> Self {
        let mut all = Self { segments: Vec::new(), circles: Vec::new(), leaders: Vec::new() };
        for shape in shapes {
            all.add(shape);
        }
        all
    }
    fn segment(&mut self, a: V, b: V, weight: f64) {
        let frame = (a.0.min(b.0), a.1.min(b.1), a.0.max(b.0), a.1.max(b.1));
        self.segments.push((a, b, frame, weight));
    }
    fn add(&mut self, shape: &Shape) {
        let weight = weight(shape.role);
        if weight <= 0.0 {
            return;
        }
        match &shape.outline {
            Outline::Lines { points, closed } => {
                for pair in points.windows(2) {
                    self.segment(pair[0], pair[1], weight);
                }
                if let (true, Some(first), Some(last)) = (*closed, points.first(), points.last()) {
                    self.segment(*last, *first, weight);
                }
            }
            Outline::Circle { centre, radius } => self.circles.push((*centre, *radius, weight)),
            Outline::Arc { centre, radius, from, to } => {
                let steps = 12;
                let at = |i: i32| {
                    let share = f64::from(i) / f64::from(steps);
                    along(*centre, polar(from + (to - from) * share), *radius)
                };
                for i in 0..steps {
                    self.segment(at(i), at(i + 1), weight);
                }
            }
        }
    }
    /// What a label in this box would cover.
    fn cost(&self, frame: Frame) -> f64 {
        let mut cost = 0.0;
        for (a, b, f, weight) in &self.segments {
            if overlap(frame, *f) && segment_meets(*a, *b, frame) {
                cost += weight;
            }
        }
        for (centre, radius, weight) in &self.circles {
            let near = size(sub(nearest(frame, *centre), *centre));
            let corner = |x: f64, y: f64| size(sub((x, y), *centre));
            let far = corner(frame.0, frame.1)
                .max(corner(frame.2, frame.1))
                .max(corner(frame.0, frame.3))
                .max(corner(frame.2, frame.3));
            if near <= *radius && far >= *radius {
                cost += weight;
            }
        }
        cost
    }
    /// What a leader would cross.
    fn crossings(&self, a: V, b: V) -> f64 {
        let mut cost = 0.0;
        for (c, d, _, weight) in &self.segments {
            let (u, v) = (sub(b, a), sub(*d, *c));
            let side = |p: V, q: V, r: V| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
            // Its own end may touch what it points at.
            let end = along(a, unit(u), (size(u) - 3.0).max(0.0));
            if side(a, end, *c) * side(a, end, *d) < 0.0
                && side(*c, *d, a) * side(*c, *d, end) < 0.0
                && size(v) > 0.0
            {
                cost += weight;
            }
        }
        cost
    }
}

/// Does a leader run through this box?
fn crosses_any(leaders: &[(V, V)], frame: Frame) -> bool {
    leaders.iter().any(|(a, b)| segment_meets(*a, *b, frame))
}

/// Point of a box nearest to a point.
fn nearest(frame: Frame, p: V) -> V {
    (p.0.clamp(frame.0, frame.2), p.1.clamp(frame.1, frame.3))
}

fn grown(f: Frame, by: f64) -> Frame {
    (f.0 - by, f.1 - by, f.2 + by, f.3 + by)
}

fn joined(f: Frame, g: Frame) -> Frame {
    (f.0.min(g.0), f.1.min(g.1), f.2.max(g.2), f.3.max(g.3))
}

fn overlap(f: Frame, g: Frame) -> bool {
    f.0 < g.2 && g.0 < f.2 && f.1 < g.3 && g.1 < f.3
}

/// Does a segment meet a box? (Clipped slab by slab.)
fn segment_meets(a: V, b: V, f: Frame) -> bool {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for (start, step, low, high) in [(a.0, b.0 - a.0, f.0, f.2), (a.1, b.1 - a.1, f.1, f.3)] {
        if step.abs() < 1e-12 {
            if start < low || start > high {
                return false;
            }
        } else {
            let (t1, t2) = ((low - start) / step, (high - start) / step);
            from = from.max(t1.min(t2));
            to = to.min(t1.max(t2));
        }
    }
    from <= to
}

/// The box of an outline.
fn extent(outline: &Outline) -> Frame {
    let of = |points: &[Point]| {
        let mut f = (f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY);
        for p in points {
            f = joined(f, (p.0, p.1, p.0, p.1));
        }
        f
    };
    match outline {
        Outline::Lines { points, .. } => of(points),
        Outline::Circle { centre, radius } => {
            (centre.0 - radius, centre.1 - radius, centre.0 + radius, centre.1 + radius)
        }
        Outline::Arc { centre, radius, from, to } => {
            let points: Vec<V> = (0..=16)
                .map(|i| along(*centre, polar(from + (to - from) * f64::from(i) / 16.0), *radius))
                .collect();
            of(&points)
        }
    }
}
