//! The picture of a pinned body: at its start, with the position considered as a ghost.
use crate::figure::joined::{along, ground};
use crate::figure::parts;
use crate::figure::view::SceneView;
use crate::picture::board::{Board, LabelTie, MIDDLE_FIRST, on_arc};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Role, symbol};
use crate::scene::{
    Body, Degree, End, Num, Place, Planar, Ray, Rest, RotaryInertia, Scene, Shape, Strut, StrutEnd,
};

/// Pixels of the farthest point from the pin.
const REACH: f64 = 175.0;
/// Least distance of the mark of the mass centre from an arc.
const CLEAR: f64 = 10.0;

/// A pinned body on the board, the pin at the origin.
#[derive(Debug, Clone, Copy)]
pub struct Hung {
    /// Pixels per metre.
    pub scale: f64,
    /// Distance from the pin to the mass centre, pixels.
    pub arm: f64,
    /// Ends of a rod, counted from the pin along the line to the mass centre; `None` for another body.
    pub rod: Option<(f64, f64)>,
    /// Radius of what is drawn round the mass centre of another body.
    pub round: f64,
    /// Does its angle count from upright?
    pub upright: bool,
    /// Its angle at the start, degrees.
    pub start: f64,
}

/// The spring of a pinned body: where on its axis it acts, and the place of its anchor.
pub fn spring_of(scene: &Scene) -> Option<(&Strut, Place, [Num; 2])> {
    let spring = scene.struts.first()?;
    let StrutEnd::Ground(place) = spring.to else { return None };
    let (_, [at, _]) = scene.planar(spring.at.body)?.points.get(spring.at.point)?;
    Some((spring, *at, place))
}

impl Hung {
    /// How the body of a view is drawn.
    pub fn new(view: &SceneView, body: &Body, pin: &Planar) -> Self {
        let arm = along(view, pin.centre);
        let long = body.rod().map(|l| view.of(l));
        let mass = view.kilograms(body);
        let gyration = if mass > 0.0 { (view.inertia(body) / mass).max(0.0).sqrt() } else { 0.0 };
        let round = match &body.inertia {
            Some(RotaryInertia::Shape(shape, r)) if *shape != Shape::Rod => view.of(*r),
            _ => (gyration * 1.12).max(arm * 0.12),
        };
        let far = match long {
            Some(l) => (arm + l / 2.0).max((arm - l / 2.0).abs()),
            None => arm + round,
        };
        let spring = spring_of(view.scene).map_or(0.0, |(_, at, place)| {
            let anchor = ground(view, place);
            (anchor.x * anchor.x + anchor.y * anchor.y).sqrt().max(along(view, at)) * 0.92
        });
        let scale = REACH / if far.max(spring) > 0.0 { far.max(spring) } else { 1.0 };
        Self {
            scale,
            arm: arm * scale,
            rod: long.map(|l| ((arm - l / 2.0) * scale, (arm + l / 2.0) * scale)),
            round: round * scale,
            upright: pin.from == Ray::Up,
            start: pin.start_deg.map_or(0.0, |n| view.of(n)),
        }
    }

    /// How far it reaches from the pin beyond its mass centre.
    fn far(&self) -> f64 {
        self.rod.map_or(self.arm + self.round, |(_, to)| to)
    }

    /// Direction from the pin to the mass centre at an angle in degrees.
    pub fn direction(&self, degrees: f64) -> Vec2 {
        let [x, y] = Vec2::at_degrees(degrees).into();
        vec2(y, if self.upright { x } else { -x })
    }

    /// Direction in which the body moves where its angle grows.
    pub fn across(&self, degrees: f64) -> Vec2 {
        let d = self.direction(degrees);
        if self.upright { d.right() } else { d.left() }
    }

    /// Is a growing angle a clockwise turn?
    pub fn clockwise(&self) -> bool {
        self.upright
    }

    /// Does the body at an angle cover this point?
    pub fn covers(&self, point: Vec2, degrees: f64) -> bool {
        let d = self.direction(degrees);
        let far = point.dot(&d);
        if let Some((from, to)) = self.rod {
            return far > from - 7.0 && far < to + 2.0 && point.dot(&(d.left())).abs() < 7.0;
        }
        let small = parts::end_of_link(self.round);
        (0..=20).any(|i| {
            let share = f64::from(i) / 20.0;
            let reach = small + (self.round - small) * share;
            (point - d * (self.arm * share)).norm() < reach + 2.0
        })
    }

    /// Outline of the body at an angle, moved by `at`.
    pub fn outline(&self, board: &mut Board, at: Vec2, degrees: f64, role: Role) {
        let d = self.direction(degrees);
        match self.rod {
            Some((from, to)) => {
                let side = d.left() * 5.0;
                let (a, b) = (at + d * (from - 5.0), at + d * to);
                board.lines(&[a + side, b + side, b - side, a - side], true, role);
            }
            None => {
                parts::round_link(board, (at + d * self.arm, self.round), &[at], role);
            }
        }
    }
}

/// Draws a pinned body with all that belongs to it.
pub fn draw(board: &mut Board, view: &SceneView, index: usize) {
    let body = &view.scene.bodies[index];
    let Some(pin) = &body.planar else { return };
    let hung = Hung::new(view, body, pin);
    let start = hung.start;
    let end = match view.scene.end {
        End::Angle(_, n) => Some((n, view.of(n))),
        _ => None,
    };
    let d = hung.direction(start);
    let far = hung.far();
    let zero = hung.direction(0.0);
    let bearing = free_side(&hung, start, end.map(|e| e.1));
    if hung.rod.is_some() {
        support(board, bearing);
    }
    // The direction from which angles count, unless the body covers it.
    board.line(zero * 8.0, zero * (far * 0.72 + 14.0), Role::Ghost);
    if let Some((_, degrees)) = end
        && (degrees - start).abs() > 1.0
    {
        hung.outline(board, Vec2::ZERO, degrees, Role::Ghost);
    }
    hung.outline(board, Vec2::ZERO, start, Role::Body);
    if hung.rod.is_none() {
        // The lines between which the angles are, and the support, in front.
        for degrees in end.map(|e| e.1).into_iter().chain([start]) {
            board.line(Vec2::ZERO, hung.direction(degrees) * hung.arm, Role::Ghost);
        }
        board.line(Vec2::ZERO, zero * (far * 0.72 + 14.0), Role::Ghost);
        support(board, bearing);
    }
    let g = d * hung.arm;
    let mut angles: Vec<(Num, f64, f64)> = pin.start_deg.map(|n| (n, start, 0.0)).into_iter().collect();
    if let Some((n, degrees)) = end {
        angles.push((n, degrees, 24.0));
    }
    let base = if hung.rod.is_some() { 50.0 } else { (hung.arm * 0.5).clamp(34.0, 60.0) };
    // No arc runs through the mark of the mass centre.
    let clear = |radius: f64| match radius - hung.arm {
        off if off.abs() >= CLEAR => radius,
        off if off < 0.0 => hung.arm - CLEAR,
        _ => hung.arm + CLEAR,
    };
    for (num, degrees, more) in angles {
        arc(board, view, &hung, num, degrees, clear(base + more));
    }
    board.circle(Vec2::ZERO, 3.6, Role::Inner);
    if hung.arm > 4.0 {
        board.dot(g);
        let side = hung.across(start) * (if end.is_some_and(|(_, e)| e > start) { -1.0 } else { 1.0 });
        // On either side of the body's line, if need be a little farther along it: arcs pass there.
        let beside = |along: f64| [side, -side].map(|s| (g + d * along, s));
        let spots = [0.0, 9.0, -9.0, 17.0, -17.0, 26.0, -26.0].into_iter().flat_map(beside).collect();
        board.label(vec![symbol::italic("G")], Role::Dot, (LabelTie::Clear, 9.0), spots);
    }
    sizes(board, view, body, pin, &hung, end.map(|e| e.1));
    if let Some(spring) = spring_of(view.scene) {
        draw_spring(board, view, &hung, spring, d);
    }
    turns(board, view, index, &hung, d);
}

/// The spring of a body that points in this direction, with its anchor and its dimensions.
fn draw_spring(
    board: &mut Board,
    view: &SceneView,
    hung: &Hung,
    (spring, at, [x, y]): (&Strut, Place, [Num; 2]),
    d: Vec2,
) {
    let anchor = ground(view, [x, y]) * hung.scale;
    let held = d * (along(view, at) * hung.scale);
    let long = (held - anchor).norm();
    if long > 12.0 {
        board.spring(anchor, held, 9, 7.5);
    } else {
        board.line(anchor, held, Role::Spring);
    }
    let pull = (held - anchor).unit();
    parts::wall(board, anchor, -pull, 15.0, -15.0);
    board.dot(held);
    board.label(
        vec![symbol::italic("A")],
        Role::Dot,
        (LabelTie::Near, 4.0),
        vec![(anchor - pull * 9.0, -pull), (anchor + Vec2::UP * 14.0, Vec2::UP)],
    );
    let rest = match spring.rest {
        Rest::Length(n) | Rest::Stretch(n) => view.label(n, "m"),
    };
    let mid = anchor.middle(held);
    let out = if pull.left().dot(&(vec2(1.0, 0.6))) > 0.0 { pull.left() } else { pull.right() };
    board.label(
        vec![view.label(spring.stiffness_n_m, "N/m"), rest],
        Role::Spring,
        (LabelTie::Leader, 4.0),
        vec![(mid + out * 10.0, out), (mid - out * 10.0, -out)],
    );
    for (num, from, to, out) in [
        (y, Vec2::ZERO, vec2(0.0, anchor.y), Vec2::LEFT),
        (x, vec2(0.0, anchor.y), anchor, vec2(0.0, anchor.y.signum())),
    ] {
        if (to - from).norm() > 2.0 {
            let off = if out.x < 0.0 { 78.0 } else { 40.0 };
            dimension(board, from, to, out, off, view.label(num, "m"));
        }
    }
}

/// Couples and the spin at the start of a body that points in this direction, in the sense that they have.
fn turns(board: &mut Board, view: &SceneView, index: usize, hung: &Hung, d: Vec2) {
    let far = hung.far();
    for couple in view.scene.couples.iter().filter(|c| c.body == index) {
        let forward = couple.forward == (view.of(couple.moment_n_m) >= 0.0);
        let clockwise = hung.clockwise() == forward;
        let mid = d.angle_of();
        let (from, to) = if clockwise { (mid + 2.4, mid - 1.6) } else { (mid - 2.4, mid + 1.6) };
        board.curved_arrow(Vec2::ZERO, 26.0, from, to, Role::Force);
        let spot = Vec2::at_angle(from + (to - from) * 0.15);
        board.wish(
            view.size_label(couple.moment_n_m, "N·m"),
            vec![(spot * 26.0, spot), (Vec2::at_angle(to) * 26.0, Vec2::at_angle(to))],
            Role::Force,
        );
    }
    for (_, num) in view.started(index).filter(|(degree, _)| *degree == Degree::Turn) {
        let actual = if view.of(num) < 0.0 { -1.0 } else { 1.0 };
        let sense = if hung.clockwise() { -actual } else { actual };
        let radius = far + 12.0;
        let mid = d.angle_of();
        board.curved_arrow(Vec2::ZERO, radius, mid - sense * 0.02, mid + sense * 0.3, Role::Motion);
        let at = Vec2::at_angle(mid + sense * 0.16);
        board.wish(view.size_label(num, "rad/s"), vec![(at * radius, at)], Role::Motion);
    }
}

/// The angle from the zero direction, with its label.
fn arc(board: &mut Board, view: &SceneView, hung: &Hung, num: Num, degrees: f64, radius: f64) {
    let fixed_zero = matches!(num, Num::Fixed(x) if x.abs() < 1e-9);
    if fixed_zero {
        return;
    }
    let zero = hung.direction(0.0).angle_of();
    let sense = if hung.clockwise() { -1.0 } else { 1.0 };
    let turned = board.angle(Vec2::ZERO, radius, zero, sense * degrees);
    let mut spots = on_arc(Vec2::ZERO, radius, zero, turned, &[MIDDLE_FIRST, &[1.0]].concat());
    if degrees.abs() < 25.0 {
        // No room between the lines: before them.
        let d = Vec2::at_angle(zero - turned.signum() * 0.12);
        spots.insert(0, (d * radius, hung.across(0.0) * (if degrees < 0.0 { 1.0 } else { -1.0 })));
    }
    board.wish(view.label(num, "°"), spots, Role::Dimension);
}

/// Lengths along the body, its mass and radius of gyration.
fn sizes(board: &mut Board, view: &SceneView, body: &Body, pin: &Planar, hung: &Hung, end: Option<f64>) {
    let start = hung.start;
    let d = hung.direction(start);
    // On the side that the body does not sweep, unless a small angle or a spring is there.
    let away = hung.across(start) * (if end.is_some_and(|e| e < start) { 1.0 } else { -1.0 });
    let full = !view.scene.struts.is_empty() || (1.0..35.0).contains(&start.abs());
    let out = if full && hung.rod.is_some() { -away } else { away };
    // The letter of the mass centre has room between.
    let off = if hung.rod.is_some() { 37.0 } else { 28.0 };
    let at = |far: f64| d * far;
    let mut rows = Vec::new();
    match (&body.inertia, pin.centre, hung.rod) {
        (Some(RotaryInertia::Shape(Shape::Rod, l)), arm, Some((from, to))) => {
            dimension(board, at(from), at(to), out, off, view.label(*l, "m"));
            if let Place::At(h) = arm
                && hung.arm > 4.0
            {
                dimension(board, at(0.0), at(hung.arm), -out, 24.0, view.label(h, "m"));
            }
        }
        (inertia, Place::At(h), _) => {
            if hung.arm > 4.0 {
                let clear = if hung.round > hung.arm * 0.9 {
                    hung.round + 14.0
                } else {
                    (hung.round + 14.0).min(64.0).max(hung.round + 8.0)
                };
                dimension(board, at(0.0), at(hung.arm), out, clear, view.label(h, "m"));
            }
            match inertia {
                Some(RotaryInertia::Gyration(n)) => rows.push(view.label(*n, "m")),
                Some(RotaryInertia::Moment(n @ Num::Datum(_))) => {
                    rows.push(view.label(*n, "kg·m<sup>2</sup>"))
                }
                _ => {}
            }
        }
        (Some(RotaryInertia::Gyration(n)), ..) => rows.push(view.label(*n, "m")),
        _ => {}
    }
    if let Some((n, weight)) = view.mass(body) {
        rows.insert(0, view.label(n, if weight { "N" } else { "kg" }));
    }
    let far = hung.far();
    let spots = match hung.rod {
        Some(_) => {
            vec![(at(far), d), (at(far * 0.8), -out), (at(far), (d + -out).unit())]
        }
        None => vec![(at(far), d), (at(hung.arm) - away * hung.round, -away)],
    };
    board.label(rows, Role::Dot, (LabelTie::Loose, 6.0), spots);
}

/// A dimension line beside a length.
pub fn dimension(
    board: &mut Board,
    from: Vec2,
    to: Vec2,
    out: Vec2,
    off: f64,
    label: Vec<crate::picture::TextRun>,
) {
    for p in [from, to] {
        board.line(p + out * (off - 16.0).clamp(8.0, 30.0), p + out * (off + 5.0), Role::Dimension);
    }
    let (a, b) = (from + out * off, to + out * off);
    board.double_arrow(a, b, Role::Dimension);
    let mid = a.middle(b);
    let along = (b - a).unit();
    let spots =
        vec![(mid, out), (mid + along * 34.0, out), (mid + along * 60.0, out), (b, along), (a, -along)];
    board.label(vec![label], Role::Dimension, (LabelTie::Clear, 5.0), spots);
}

/// Distance from a pin to the wall that holds it.
const WALL: f64 = 24.0;
/// Half the width of that wall.
const HALF_WALL: f64 = 28.0;

/// The direction from the pin to a wall that holds it without lying in the body; `None` where the body is all round the pin.
/// The wall is above what hangs and below what stands wherever that is free.
fn free_side(hung: &Hung, start: f64, end: Option<f64>) -> Option<Vec2> {
    let usual = -hung.direction(0.0);
    let sides = [usual, usual.left(), usual.right(), -usual];
    let covered = |side: Vec2, degrees: f64| {
        let across = side.left();
        (-4..=4).any(|i| {
            let foot = side * WALL + across * (HALF_WALL * f64::from(i) / 4.0);
            [0.0, 9.0].into_iter().any(|deep| hung.covers(foot + side * deep, degrees))
        })
    };
    let free: Vec<Vec2> = sides.into_iter().filter(|s| !covered(*s, start)).collect();
    // The other position is only dashed: its side is the second best.
    let best = free.iter().find(|s| end.is_none_or(|e| !covered(**s, e)));
    best.or(free.first()).copied()
}

/// The support of a pin: a bracket with a wall on one side, or the bearing alone.
fn support(board: &mut Board, side: Option<Vec2>) {
    let pin = Vec2::ZERO;
    let Some(side) = side else {
        board.circle(pin, 7.5, Role::Inner);
        return;
    };
    let (wall, across) = (side * WALL, side.left());
    board.lines(&[wall - across * 13.0, pin, wall + across * 13.0], true, Role::Inner);
    let (a, b) = (wall + across * HALF_WALL, wall - across * HALF_WALL);
    let (a, b) = if side.y < -0.5 || side.x < -0.5 { (b, a) } else { (a, b) };
    board.hatch(a, b, side);
    board.line(a, b, Role::Ground);
}
