//! What the pictures of a scene are made of: the outline of a body, surfaces, supports, cords and springs.
use crate::figure::layout::{self, BodyLook, CordPiece, CordStop, Ground, Placed, SceneLayout};
use crate::figure::view::SceneView;
use crate::picture::board::{Board, LabelTie, TEXT};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Role, symbol};
use crate::scene::{Far, GivenForce, Made, Num, Slope, Tie};
use std::f64::consts::PI;

/// Radius at which the angle of a pull is drawn.
const TILT: f64 = 34.0;

/// What is round; a hoop (`open`) has a hole.
pub fn rim(board: &mut Board, centre: Vec2, outer: f64, open: bool, role: Role) {
    board.circle(centre, outer, role);
    if open {
        hole(board, centre, outer);
    }
}

fn hole(board: &mut Board, centre: Vec2, outer: f64) {
    board.circle(centre, outer - 7.0, Role::Paper);
    board.circle(centre, outer - 7.0, Role::Inner);
}

/// The body's outer edge.
pub fn outline(board: &mut Board, p: &Placed) {
    match &p.look {
        BodyLook::Wheel { outer, open, .. } => {
            rim(board, p.centre, *outer, *open, Role::Body);
        }
        BodyLook::Block { along: a, across: b } => {
            let (f, t) = (p.forward * *a, p.top * *b);
            let corners = [p.centre + (f + t), p.centre + (t - f), p.centre - (f + t), p.centre + (f - t)];
            board.lines(&corners, true, Role::Body);
        }
    }
}

/// A body of which nothing is known but its mass centre, how far from it the mass lies and two points on a line with it at most: the
/// hull of a circle and of small ones about these points; a hoop (`open`) has a hole.
pub fn round_link(board: &mut Board, (centre, round): (Vec2, f64), points: &[Vec2], open: bool, role: Role) {
    let small = (round * 0.3).clamp(9.0, 16.0);
    let end = |point: &Vec2| {
        let off = point - centre;
        // Tangents touch both circles at this angle from the line.
        let cosine = ((round - small) / off.norm()).clamp(-1.0, 1.0);
        let apart = vec2(cosine, (1.0 - cosine * cosine).sqrt()).angle_of();
        // What is pinned at its rim is a disc.
        let rim = (off.norm() - round).abs() < 1e-6 * round;
        (off.norm() + small > round + 1.0 && !rim).then(|| (*point, off.angle_of(), apart))
    };
    let ends: Vec<(Vec2, f64, f64)> = points.iter().filter_map(end).collect();
    if ends.is_empty() {
        return rim(board, centre, round, open, role);
    }
    let mut arcs = Vec::new();
    for ((point, towards, apart), (_, next, next_apart)) in ends.iter().zip(ends.iter().cycle().skip(1)) {
        let (from, to) = (towards + apart, next - next_apart);
        arcs.push((*point, small, towards - apart, from));
        arcs.push((centre, round, from, from + (to - from).rem_euclid(2.0 * PI)));
    }
    board.arcs(arcs, role);
    if open {
        hole(board, centre, round);
    }
}

/// What is drawn within a body: hubs, centre.
pub fn inside(board: &mut Board, p: &Placed) {
    if let BodyLook::Wheel { rings, .. } = &p.look {
        for r in rings {
            board.circle(p.centre, *r, Role::Inner);
        }
        board.dot(p.centre);
    }
}

/// Radius of the arc of a slope's angle.
const ARM: f64 = 64.0;
/// An arc shorter than this has no room for the head of an arrow.
const NARROW: f64 = 16.0;

/// A surface with its hatching and, if it slopes, its angle.
pub fn surface(board: &mut Board, view: &SceneView, g: &Ground) {
    let at = |s: f64| g.origin + g.up * s;
    let (foot, top) = (at(g.from), at(g.to));
    let into = -g.out;
    let slope = match g.slope {
        Slope::Degrees(n) => Some(n),
        Slope::Level | Slope::Vertical => None,
    };
    let degrees = slope.map_or(0.0, |n| view.of(n));
    let flat = slope.is_none() || degrees.abs() < 1e-9;
    // Where the angle is drawn there is no hatching.
    let (arm, clear): (f64, f64) = if flat { (0.0, 0.0) } else { (ARM, ARM + 6.0) };
    if g.rail {
        let thick = 9.0;
        let low = |p: Vec2| p + into * thick;
        board.lines(&[foot, top, low(top), low(foot)], true, Role::Paper);
        board.line(low(foot), low(top), Role::Hatch);
        board.hatch(foot, top, into);
        board.line(foot, top, Role::Ground);
    } else {
        let begin = at(g.from + clear);
        match view.scene.carried.filter(|c| c.slope == g.slope && !g.drop) {
            Some(c) => moving_surface(board, begin, top, into, view.of(c.acceleration_m_s2) == 0.0),
            None => board.hatch(begin, top, into),
        }
        if g.drop {
            let floor = if flat { top.y - 92.0 } else { foot.y };
            let low = vec2(top.x, floor);
            board.hatch(top, low, vec2(-g.up.x.signum(), 0.0));
            board.lines(&[foot, top, low], false, Role::Ground);
        } else {
            board.line(foot, top, Role::Ground);
        }
    }
    if let (Some(num), false) = (slope, flat) {
        // The level through the foot, the arc, its label: within the angle where it is wide enough.
        let start = foot;
        let level = if g.up.x < 0.0 { Vec2::LEFT } else { Vec2::RIGHT };
        let label = view.label(num, "°");
        let wide = symbol::width(&label, TEXT);
        let long = if g.drop { (top.x - foot.x).abs() } else { arm + wide + 14.0 };
        board.line(start, start + level * long, Role::Dimension);
        let (a, b) = (level.angle_of(), g.up.angle_of());
        let a = if g.up.x < 0.0 { PI } else { a };
        let sense = (b - a).signum();
        if (b - a).abs() * arm < NARROW {
            // No room between the lines: the arrow comes from outside. It has as many parts as one from within, so that nothing of a
            // sheet goes with an answer but the angle itself.
            board.arc(start, arm, a, b + sense * 24.0 / arm, Role::Dimension);
            board.curved_head(start, arm, b, -sense, Role::Dimension);
        } else {
            board.curved_arrow(start, arm, a, b, Role::Dimension);
        }
        let within = |more: f64| (start + level * (arm + more) + Vec2::UP * (TEXT * 0.5 + 4.0), level);
        let below = start + level * (arm + 8.0);
        let mut spots = vec![(below, Vec2::DOWN), (below, (level + vec2(0.0, -0.7)).unit())];
        if (b - a).abs() * arm > 1.1 * TEXT {
            spots.splice(0..0, [within(0.0), within(10.0), within(20.0)]);
        }
        board.wish(label, spots, Role::Dimension);
    }
}

/// What carries a scene, below its surface: the two rollers and the other side of a belt, or the bed and the wheels of a truck.
pub fn moving_surface(board: &mut Board, from: Vec2, to: Vec2, into: Vec2, belt: bool) {
    const ROUND: f64 = 9.0;
    let along = (to - from).unit();
    let deep = if belt { 0.0 } else { 10.0 };
    if !belt {
        board.lines(&[from, to, to + into * deep, from + into * deep], true, Role::Inner);
    }
    let inset = if belt { ROUND } else { 2.0 * ROUND };
    let axles = [from + along * inset, to - along * inset].map(|p| p + into * (deep + ROUND));
    for axle in axles {
        board.circle(axle, ROUND, Role::Inner);
        board.dot(axle);
    }
    if belt {
        board.line(axles[0] + into * ROUND, axles[1] + into * ROUND, Role::Ground);
    }
}

/// Axles, guide pulleys, walls.
pub fn supports(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    for (b, p) in plan.bodies.iter().enumerate() {
        let Some(p) = p.as_ref().filter(|_| view.scene.bodies[b].line.is_none()) else { continue };
        // The end of a surface that carries the axle, else a ceiling, or a floor where cords come from above.
        let carrier = plan.grounds.iter().find(|g| {
            let top = g.origin + g.up * g.to;
            g.drop && (p.centre - top).norm() < p.reach(Vec2::RIGHT) * 2.2 + 30.0
        });
        let down = plan.cords.iter().flat_map(|r| &r.at).any(|(body, d)| *body == b && d.y < -0.5);
        match carrier {
            Some(g) => bar(board, g.origin + g.up * g.to - g.out * 3.0, p.centre),
            None => axle(board, p.centre, p.reach(Vec2::UP), if down { 1.0 } else { -1.0 }),
        }
    }
    for run in &plan.cords {
        let Some((centre, radius)) = run.guide else { continue };
        match plan.grounds.iter().find(|g| g.drop) {
            Some(g) => bar(board, g.origin + g.up * g.to - g.out * 3.0, centre),
            None => axle(board, centre, radius, 1.0),
        }
        board.circle(centre, radius, Role::Body);
        board.dot(centre);
    }
}

/// A narrow bar from a support to an axle.
fn bar(board: &mut Board, from: Vec2, to: Vec2) {
    let side = (to - from).unit().left() * 3.2;
    board.lines(&[from + side, to + side, to - side, from - side], true, Role::Inner);
}

/// A bracket from a ceiling (`up` = 1) or a floor (-1).
fn axle(board: &mut Board, centre: Vec2, outer: f64, up: f64) {
    let wall = centre.y + up * (outer + 26.0);
    let at = |x: f64| vec2(centre.x + x, wall);
    board.lines(&[at(-15.0), centre, at(15.0)], true, Role::Inner);
    board.hatch(at(-38.0), at(38.0), vec2(0.0, up));
    board.line(at(-38.0), at(38.0), Role::Ground);
}

/// A wall across a direction, at the end of a spring or cord.
pub fn wall(board: &mut Board, at: Vec2, towards: Vec2, from: f64, to: f64) {
    let side = towards.left();
    let (a, b) = (at + side * from, at + side * to);
    board.hatch(a, b, towards);
    board.line(a, b, Role::Ground);
}

/// A cord with what it ends at.
pub fn cord(board: &mut Board, view: &SceneView, plan: &SceneLayout, run: &layout::CordRun) {
    let link = matches!(view.scene.ties.get(run.tie), Some(Tie::Cord(c)) if c.made == Made::Link);
    for piece in &run.pieces {
        match *piece {
            CordPiece::Straight(a, b) if link => {
                board.line(a, b, Role::Body);
                [a, b].into_iter().for_each(|end| board.dot(end));
            }
            CordPiece::Straight(a, b) => board.line(a, b, Role::Cord),
            CordPiece::Round(c, r, a, b) => board.arc(c, r, a, b, Role::Cord),
            CordPiece::Post(a, b) => board.line(a, b, Role::Ground),
        }
    }
    let Some(Tie::Cord(tie)) = view.scene.ties.get(run.tie) else { return };
    let standing = plan.bodies.get(tie.from.body).and_then(Option::as_ref);
    match run.stop {
        CordStop::Pull(a, b) => {
            board.arrow(a, b, Role::Force);
            if let Far::Pull(n) = tie.to {
                let towards = run.leaves.1;
                let over = standing.map_or(towards.left(), |p| p.top);
                if let (Some(tilt), Some(p)) = (tie.from.tilt_deg, standing) {
                    // The angle to a parallel to the surface.
                    let level = if tie.from.forward { p.forward } else { -p.forward };
                    board.line(a, a + level * (TILT + 14.0), Role::Ghost);
                    let (from, to) = (level.angle_of(), towards.angle_of());
                    let turn = (to - from + 3.0 * PI).rem_euclid(2.0 * PI) - PI;
                    board.arc(a, TILT, from, from + turn, Role::Dimension);
                    let middle = (level + towards).unit();
                    let spots = [6.0, 14.0, 24.0].map(|far| (a + middle * (TILT + far), middle)).to_vec();
                    board.label(vec![view.label(tilt, "°")], Role::Dimension, (LabelTie::Clear, 5.0), spots);
                }
                let spots = vec![(b, towards), (a.middle(b), over), (a.middle(b), -over)];
                board.wish(view.force_label(GivenForce::Pull(run.tie), n, "N"), spots, Role::Force);
            }
        }
        CordStop::Spring(a, b, _) => {
            let towards = run.leaves.1;
            board.spring(a, b, 8, 8.5);
            // The wall reaches down to the surface of the body.
            let depth = match standing {
                Some(p) if p.on.is_some() => (run.leaves.0 - p.centre).dot(&p.top) + p.contact,
                _ => 20.0,
            };
            let over = standing.map_or(towards.left(), |p| p.top);
            wall_of_spring(board, b, towards, over, depth);
            if let Far::Spring { stiffness_n_m, stretch_m, .. } = tie.to {
                stiffness(board, view, a.middle(b), over, stiffness_n_m);
                stretch(board, view, run, over, stretch_m);
            }
        }
        CordStop::Fixed(at, towards) => wall(board, at, towards, -26.0, 26.0),
        CordStop::Body => {}
    }
}

/// A spring that is met only in the motion that follows, with its plate and its wall.
pub fn awaited(board: &mut Board, view: &SceneView, spring: &layout::Awaited) {
    let layout::Awaited { stiffness, from, to, out, high } = *spring;
    let towards = (to - from).unit();
    board.spring(from, to, 8, 8.5);
    board.line(from + out * 10.0, from - out * 10.0, Role::Spring);
    wall_of_spring(board, to, towards, out, if high > 0.0 { high } else { 22.0 });
    self::stiffness(board, view, from.middle(to), out, stiffness);
}

/// The wall at the end of a spring, so deep on the side away from `over`.
fn wall_of_spring(board: &mut Board, at: Vec2, towards: Vec2, over: Vec2, depth: f64) {
    let (low, up) = if towards.left().dot(&over) > 0.0 { (-depth, 22.0) } else { (-22.0, depth) };
    wall(board, at, towards, low, up);
}

/// The label of a spring, over or under its middle.
fn stiffness(board: &mut Board, view: &SceneView, middle: Vec2, over: Vec2, num: Num) {
    let spots = [over, -over].map(|out| (middle + out * 10.0, out));
    board.wish(view.label(num, "N/m"), spots.to_vec(), Role::Spring);
}

/// The stretch of a spring as a dimension: from where its end is to where it would be without.
fn stretch(board: &mut Board, view: &SceneView, run: &layout::CordRun, over: Vec2, num: Num) {
    let CordStop::Spring(a, _, rest) = run.stop else { return };
    let under = -over;
    let long = (rest - a).norm();
    if long < 1.0 {
        return;
    }
    let off = 22.0;
    for p in [a, rest] {
        board.line(p + under * 11.0, p + under * (off + 5.0), Role::Dimension);
    }
    let (p, q) = (a + under * off, rest + under * off);
    board.double_arrow(p, q, Role::Dimension);
    let spots = vec![(p.middle(q), under), (q, run.leaves.1), (p, -run.leaves.1)];
    board.wish(view.label(num, "m"), spots, Role::Dimension);
}
