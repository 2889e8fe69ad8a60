//! Places for labels: which of the wished spots, or what place round the first one, covers least of what is drawn.
//!
//! Labels are placed one after the other, in the order of the wishes. Each tries its wished spots, then rings round the first
//! one; a label far from its spot gets a thin leader. Other labels are never covered, lines only where all is crowded.
use crate::picture::board::{LabelTie, LabelWish};
use crate::picture::frame::Frame;
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Element, Outline, Role};
use std::borrow::Cow;
use std::f64::consts::PI;

/// Least distance between a label and what is not its own.
const CLEAR: f64 = 3.0;
/// The same between two labels side by side, which else read as one; fonts differ in width.
const SIDEWAYS: f64 = 12.0;
/// From this distance on a label gets a leader.
const LEADER_FROM: f64 = 16.0;
/// Distances of the rings on which places are looked for.
const RINGS: [f64; 10] = [0.0, 5.0, 10.0, 16.0, 26.0, 38.0, 54.0, 74.0, 100.0, 135.0];
/// Places on a ring.
const TURNS: u32 = 24;

/// The best place so far: what it costs, the box, the leader.
type Best = Option<(f64, Frame, Option<(Vec2, Vec2)>)>;

/// What stands where, while labels are placed.
pub struct LabelPlaces {
    obstacles: Obstacles,
    whole: Frame,
    taken: Vec<Frame>,
}

impl LabelPlaces {
    /// Free places round these elements, which lie in this box.
    pub fn new(elements: &[Element], whole: Frame) -> Self {
        Self { obstacles: Obstacles::new(elements), whole, taken: Vec::new() }
    }

    /// The box for a label of half this size, and its leader.
    pub fn place(&mut self, wish: &LabelWish, half: Vec2) -> (Frame, Option<Element>) {
        let mut best: Best = None;
        if wish.tie == LabelTie::Fixed {
            let (point, towards) = wish.spots[0];
            let frame = beside(point, towards, wish.gap, half);
            if !self.covers_label(frame.grown(1.0)) {
                best = Some((-1.0, frame, None));
            }
        }
        for (i, (point, towards)) in wish.spots.iter().enumerate() {
            for (ring, gap) in [0.0, 5.0, 10.0].into_iter().enumerate() {
                if wish.gap + gap < LEADER_FROM || ring == 0 {
                    let gap = (wish.gap + gap).min(LEADER_FROM.max(wish.gap + 1.0) - 1.0);
                    let base = i as f64 * 1.5 + ring as f64 * 1.2;
                    self.consider(&mut best, wish.tie, base, (*point, || *towards, gap), half);
                }
            }
        }
        let (point, towards) = wish.spots[0];
        let start = towards.angle_of();
        let rings = if matches!(wish.tie, LabelTie::Near | LabelTie::Fixed) { &RINGS[..3] } else { &RINGS };
        for (ring, gap) in rings.iter().enumerate() {
            for turn in 0..TURNS {
                let off = f64::from(turn.div_ceil(2)) * if turn % 2 == 0 { 1.0 } else { -1.0 };
                let base = 5.0 + 2.0 * ring as f64 + 0.45 * off.abs();
                let towards = || Vec2::at_angle(start + off * PI / 12.0);
                self.consider(&mut best, wish.tie, base, (point, towards, wish.gap + gap), half);
            }
        }
        // Farther out there is always room.
        let size = self.whole.high - self.whole.low;
        let mut far = size.x + size.y;
        while best.is_none() {
            for turn in 0..TURNS {
                let towards = || Vec2::at_angle(f64::from(turn) * PI / 12.0);
                self.consider(&mut best, wish.tie, 1e6 + far, (point, towards, far), half);
            }
            far *= 1.3;
            if !far.is_finite() || far > 1e9 {
                // Beyond all that is drawn, where leaders may cross.
                let y = self.taken.iter().map(|t| t.high.y).fold(self.whole.high.y, f64::max) + 8.0;
                let low = vec2(point.x, y);
                best = Some((0.0, Frame { low, high: low + half * 2.0 }, None));
            }
        }
        let (frame, leader) =
            best.map_or((Frame::about(point, half), None), |(_, frame, leader)| (frame, leader));
        self.taken.push(frame);
        (frame, leader.map(|leader| self.obstacles.leader(leader)))
    }

    /// Is a label at this distance in this direction from a point better than the best one so far? `base` is what it costs even
    /// where it covers nothing.
    fn consider(
        &self,
        best: &mut Best,
        tie: LabelTie,
        base: f64,
        (point, towards, gap): (Vec2, impl Fn() -> Vec2, f64),
        half: Vec2,
    ) {
        let limit = best.as_ref().map_or(f64::INFINITY, |b| b.0);
        if limit <= base {
            return;
        }
        let frame = beside(point, towards(), gap, half);
        let wide = frame.grown(CLEAR);
        if self.covers_label(wide) || self.obstacles.leaders.iter().any(|(a, b)| wide.meets(*a, *b)) {
            return;
        }
        // What covers more than the best one is not looked at to its end.
        // What stands near its point and has no leader is read only where it covers nothing.
        let dear = if matches!(tie, LabelTie::Near | LabelTie::Clear) { 4.0 } else { 1.0 };
        let too_much = |covered: f64| base + dear * covered >= limit;
        let Some(covered) = self.obstacles.cost(wide, too_much) else { return };
        let mut cost = base + dear * covered;
        let leader = (gap >= LEADER_FROM && matches!(tie, LabelTie::Leader | LabelTie::Clear))
            .then(|| (frame.grown(1.5).nearest(point), point));
        if let Some((a, b)) = leader {
            if self.taken.iter().any(|t| t.meets(a, b)) || self.obstacles.through_a_dot(a, b) {
                return;
            }
            // A leader to what must be read at once had better cross nothing.
            let share = if tie == LabelTie::Clear { 1.0 } else { 0.3 };
            cost += share * self.obstacles.crossings(a, b);
        }
        // Beyond what is drawn the picture has to grow.
        let whole = self.whole;
        let outside = (whole.low.x - frame.low.x).max(frame.high.x - whole.high.x).max(0.0)
            + (whole.low.y - frame.low.y).max(frame.high.y - whole.high.y).max(0.0);
        cost += outside * 0.02;
        if cost < limit {
            *best = Some((cost, frame, leader));
        }
    }

    fn covers_label(&self, frame: Frame) -> bool {
        let aside = vec2(SIDEWAYS - CLEAR, 0.0);
        let frame = Frame { low: frame.low - aside, high: frame.high + aside };
        self.taken.iter().any(|t| frame.overlaps(*t))
    }
}

/// The box of half this size beside a point.
fn beside(point: Vec2, towards: Vec2, gap: f64, half: Vec2) -> Frame {
    let reach = half.x * towards.x.abs() + half.y * towards.y.abs();
    Frame::about(point + towards * (gap + reach), half)
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
#[derive(Default)]
struct Obstacles {
    segments: Vec<(Vec2, Vec2, Frame, f64)>,
    circles: Vec<(Vec2, f64, f64)>,
    /// Full points with their radii: a leader over one of them would seem to come from there.
    dots: Vec<(Vec2, f64)>,
    leaders: Vec<(Vec2, Vec2)>,
}

impl Obstacles {
    fn new(elements: &[Element]) -> Self {
        let mut all = Self::default();
        elements.iter().for_each(|element| all.add(element));
        all
    }
    /// A leader that is drawn from now on.
    fn leader(&mut self, (from, to): (Vec2, Vec2)) -> Element {
        let outline = Outline::Lines { points: vec![from, to], closed: false };
        let element = Element { outline, role: Role::Dimension };
        self.add(&element);
        self.leaders.push((from, to));
        element
    }
    fn add(&mut self, element: &Element) {
        let weight = weight(element.role);
        if weight <= 0.0 {
            return;
        }
        let (points, closed): (Cow<[Vec2]>, bool) = match &element.outline {
            Outline::Lines { points, closed } => (Cow::Borrowed(points), *closed),
            Outline::Circle { centre, radius } => {
                self.circles.push((*centre, *radius, weight));
                if element.role == Role::Dot {
                    self.dots.push((*centre, *radius));
                }
                return;
            }
            Outline::Arc { centre, radius, from, to } => {
                (Vec2::on_arc(*centre, *radius, (*from, *to), 12).collect(), false)
            }
            Outline::Arcs(arcs) => {
                let on = |(c, r, from, to): &(Vec2, f64, f64, f64)| Vec2::on_arc(*c, *r, (*from, *to), 12);
                (arcs.iter().flat_map(on).collect(), true)
            }
        };
        let segment = |a: Vec2, b: Vec2| (a, b, Frame { low: a.inf(&b), high: a.sup(&b) }, weight);
        self.segments.extend(points.windows(2).map(|pair| segment(pair[0], pair[1])));
        if let (true, Some(first), Some(last)) = (closed, points.first(), points.last()) {
            self.segments.push(segment(*last, *first));
        }
    }
    /// What a label in this box would cover; `None` once it is too much.
    fn cost(&self, frame: Frame, too_much: impl Fn(f64) -> bool) -> Option<f64> {
        let mut cost = 0.0;
        for (a, b, f, weight) in &self.segments {
            if frame.overlaps(*f) && frame.meets(*a, *b) {
                cost += weight;
                if too_much(cost) {
                    return None;
                }
            }
        }
        for (centre, radius, weight) in &self.circles {
            let near = (frame.nearest(*centre) - *centre).norm();
            if near <= *radius && frame.farthest(*centre) >= *radius {
                cost += weight;
            }
        }
        Some(cost)
    }
    /// Does a leader run over a full point other than that at which it ends?
    fn through_a_dot(&self, a: Vec2, b: Vec2) -> bool {
        self.dots.iter().any(|(dot, radius)| {
            Frame::about(*dot, vec2(radius + 1.0, radius + 1.0)).meets(a, b)
                && (b - dot).norm() > radius + 1.0
        })
    }
    /// What a leader would cross.
    fn crossings(&self, a: Vec2, b: Vec2) -> f64 {
        let mut cost = 0.0;
        let along = b - a;
        // The last 3 pixels may touch what it points at.
        let end = a + along.unit() * (along.norm() - 3.0).max(0.0);
        let side = |p: Vec2, q: Vec2, r: Vec2| (q - p).perp(&(r - p));
        for (c, d, _, weight) in &self.segments {
            if side(a, end, *c) * side(a, end, *d) < 0.0
                && side(*c, *d, a) * side(*c, *d, end) < 0.0
                && (*d - *c).norm() > 0.0
            {
                cost += weight;
            }
        }
        cost
    }
}
