//! The picture of a scene at its start, to scale.
use crate::bank::FigureLabels;
use crate::bank::Problem;
use crate::figure::board::Board;
use crate::figure::board::TEXT;
use crate::figure::board::Tied;
use crate::figure::board::Wish;
use crate::figure::lamina;
use crate::figure::layout;
use crate::figure::layout::Ground;
use crate::figure::layout::Layout;
use crate::figure::layout::Look;
use crate::figure::layout::Piece;
use crate::figure::layout::Placed;
use crate::figure::layout::Stop;
use crate::figure::picture::Picture;
use crate::figure::picture::Role;
use crate::figure::picture::Run;
use crate::figure::picture::RunStyle;
use crate::figure::pinned;
use crate::figure::say;
use crate::figure::symbol;
use crate::figure::vector::V;
use crate::figure::vector::add;
use crate::figure::vector::along;
use crate::figure::vector::angle;
use crate::figure::vector::dot;
use crate::figure::vector::left;
use crate::figure::vector::middle;
use crate::figure::vector::mul;
use crate::figure::vector::polar;
use crate::figure::vector::polar_degrees;
use crate::figure::vector::size;
use crate::figure::vector::sub;
use crate::figure::vector::unit;
use crate::figure::view::View;
use crate::figure::view::joined;
use crate::figure::view::own;
use crate::problem::make::Variant;
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::End;
use crate::scene::Far;
use crate::scene::Heading;
use crate::scene::Num;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::RotaryInertia;
use crate::scene::Slope;
use crate::scene::Start;
use crate::scene::Tie;
use crate::solve::outcome::Word;
use crate::words::Words;
use std::f64::consts::PI;

/// A body that turns and is no larger has no arrow for its positive sense.
pub const SMALL: f64 = 30.0;

/// The scene of a variant at its start.
pub fn picture(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels) -> Picture {
    drawn(problem, variant, words, labels, false)
}

/// The same for a worked solution: also the way that the ending body takes where its direction is asked.
pub fn worked(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels) -> Picture {
    drawn(problem, variant, words, labels, true)
}

fn drawn(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels, worked: bool) -> Picture {
    let Some(view) = View::new(problem, variant, words, labels).map(|v| View { worked, ..v }) else {
        return Board::new().finish(problem.title.clone(), String::new());
    };
    let mut board = Board::new();
    let mut desc = Vec::new();
    let bodies = &view.scene.bodies;
    if bodies.iter().any(|b| b.pin.is_none() && b.particles.is_empty()) {
        let plan = layout::layout(&view);
        mechanism(&mut board, &view, &plan);
        say::mechanism(&view, &plan, told(&view).is_some(), &mut desc);
    }
    for (i, body) in bodies.iter().enumerate() {
        let mut part = Board::new();
        if body.pin.is_some() {
            pinned::draw(&mut part, &view, i);
            say::pinned(&view, i, &mut desc);
        } else if !body.particles.is_empty() {
            lamina::draw(&mut part, &view, i);
            say::lamina(&view, i, &mut desc);
        } else {
            continue;
        }
        board.beside(part);
    }
    board.finish(words.say("figure.scene.title", &[("title", &problem.title)]), desc.join(" "))
}

/// Bodies on surfaces, on axles, on cords.
fn mechanism(board: &mut Board, view: &View, plan: &Layout) {
    for ground in &plan.grounds {
        if !ground.rail {
            surface(board, view, ground);
        }
    }
    supports(board, view, plan);
    let placed = |b: usize| plan.bodies.get(b).and_then(Option::as_ref);
    for b in 0..view.scene.bodies.len() {
        if let Some(p) = placed(b) {
            outline(board, p);
        }
    }
    for ground in plan.grounds.iter().filter(|g| g.rail) {
        surface(board, view, ground);
    }
    for p in plan.bodies.iter().flatten() {
        inside(board, p);
    }
    for run in &plan.cords {
        cord(board, view, plan, run);
    }
    for b in 0..view.scene.bodies.len() {
        if let Some(p) = placed(b) {
            body_labels(board, view, plan, b, p);
        }
    }
    ties(board, view, plan);
    couples(board, view, plan);
    starts(board, view, plan);
    travel(board, view, plan);
    senses(board, view, plan);
}

/// The body's outer edge.
pub fn outline(board: &mut Board, p: &Placed) {
    match &p.look {
        Look::Wheel { outer, open, .. } => {
            board.circle(p.centre, *outer, Role::Body);
            if *open {
                board.circle(p.centre, outer - 7.0, Role::Paper);
                board.circle(p.centre, outer - 7.0, Role::Inner);
            }
        }
        Look::Block { along: a, across: b } => {
            let (f, t) = (mul(p.forward, *a), mul(p.top, *b));
            let corners = [
                add(p.centre, add(f, t)),
                add(p.centre, sub(t, f)),
                sub(p.centre, add(f, t)),
                add(p.centre, sub(f, t)),
            ];
            board.lines(&corners, true, Role::Body);
        }
    }
}

/// What is drawn within a body: hubs, centre.
pub fn inside(board: &mut Board, p: &Placed) {
    if let Look::Wheel { rings, .. } = &p.look {
        for r in rings {
            board.circle(p.centre, *r, Role::Inner);
        }
        board.dot(p.centre);
    }
}

fn surface(board: &mut Board, view: &View, g: &Ground) {
    let at = |s: f64| along(g.origin, g.up, s);
    let (foot, top) = (at(g.from), at(g.to));
    let into = mul(g.out, -1.0);
    let slope = match g.slope {
        Slope::Degrees(n) => Some(n),
        Slope::Level | Slope::Vertical => None,
    };
    let degrees = slope.map_or(0.0, |n| view.of(n));
    let flat = slope.is_none() || degrees.abs() < 1e-9;
    // Where the angle is drawn there is no hatching.
    let (arm, clear): (f64, f64) = if flat { (0.0, 0.0) } else { (64.0, 70.0) };
    if g.rail {
        let thick = 9.0;
        let low = |p: V| along(p, into, thick);
        board.lines(&[foot, top, low(top), low(foot)], true, Role::Paper);
        board.line(low(foot), low(top), Role::Hatch);
        board.hatch(foot, top, into);
        board.line(foot, top, Role::Ground);
    } else {
        board.hatch(at(g.from + clear), top, into);
        if g.drop {
            let floor = if flat { top.1 - 92.0 } else { foot.1 };
            board.hatch((top.0, top.1), (top.0, floor), (-g.up.0.signum(), 0.0));
            board.lines(&[foot, top, (top.0, floor)], false, Role::Ground);
        } else {
            board.line(foot, top, Role::Ground);
        }
    }
    if let (Some(num), false) = (slope, flat) {
        // The level through the foot, the arc, its label.
        let start = if g.rail { along(foot, into, 0.0) } else { foot };
        let level = if g.up.0 < 0.0 { (-1.0, 0.0) } else { (1.0, 0.0) };
        let long = if g.drop { (top.0 - foot.0).abs() } else { arm + 46.0 };
        board.line(start, along(start, level, long), Role::Dimension);
        let (a, b) = (angle(level), angle(g.up));
        let a = if g.up.0 < 0.0 { PI } else { a };
        board.curved_arrow(start, arm, a, b, Role::Dimension);
        let mid = (a + b) / 2.0;
        let out = along(start, polar(mid), arm);
        let label = view.label(num, "°");
        board.wish(
            label,
            vec![
                (out, polar(mid)),
                (along(start, level, arm), unit(add(level, (0.0, -0.7)))),
                (along(start, level, arm), (0.0, -1.0)),
            ],
            Role::Dimension,
        );
    }
}

/// Axles, guide pulleys, walls.
fn supports(board: &mut Board, view: &View, plan: &Layout) {
    for (b, p) in plan.bodies.iter().enumerate() {
        let Some(p) = p else { continue };
        if view.scene.bodies[b].line.is_some() {
            continue;
        }
        // The end of a surface that carries the axle, else a ceiling, or a floor where cords come from above.
        let carrier = plan.grounds.iter().find(|g| {
            let top = along(g.origin, g.up, g.to);
            g.drop && size(sub(p.centre, top)) < p.reach((1.0, 0.0)) * 2.2 + 30.0
        });
        let down = plan.cords.iter().flat_map(|r| &r.at).any(|(body, d)| *body == b && d.1 < -0.5);
        match carrier {
            Some(g) => bar(board, along(along(g.origin, g.up, g.to), g.out, -3.0), p.centre),
            None => axle(board, p.centre, p.reach((0.0, 1.0)), if down { 1.0 } else { -1.0 }),
        }
    }
    for run in &plan.cords {
        let Some((centre, radius)) = run.guide else { continue };
        let carrier = plan.grounds.iter().find(|g| g.drop);
        match carrier {
            Some(g) => bar(board, along(along(g.origin, g.up, g.to), g.out, -3.0), centre),
            None => axle(board, centre, radius, 1.0),
        }
        board.circle(centre, radius, Role::Body);
        board.dot(centre);
    }
}

/// A narrow bar from a support to an axle.
fn bar(board: &mut Board, from: V, to: V) {
    let side = mul(left(unit(sub(to, from))), 3.2);
    board.lines(&[add(from, side), add(to, side), sub(to, side), sub(from, side)], true, Role::Inner);
}

/// A bracket from a ceiling (`up` = 1) or a floor (-1).
fn axle(board: &mut Board, centre: V, outer: f64, up: f64) {
    let wall = centre.1 + up * (outer + 26.0);
    let (l, r) = ((centre.0 - 15.0, wall), (centre.0 + 15.0, wall));
    board.lines(&[l, centre, r], true, Role::Inner);
    let (a, b) = ((centre.0 - 38.0, wall), (centre.0 + 38.0, wall));
    board.hatch(a, b, (0.0, up));
    board.line(a, b, Role::Ground);
}

/// A wall across a direction, at the end of a spring or cord.
pub fn wall(board: &mut Board, at: V, towards: V, from: f64, to: f64) {
    let side = left(towards);
    let (a, b) = (along(at, side, from), along(at, side, to));
    board.hatch(a, b, towards);
    board.line(a, b, Role::Ground);
}

fn cord(board: &mut Board, view: &View, plan: &Layout, run: &layout::Run) {
    for piece in &run.pieces {
        match *piece {
            Piece::Straight(a, b) => board.line(a, b, Role::Cord),
            Piece::Round(c, r, a, b) => board.arc(c, r, a, b, Role::Cord),
            Piece::Post(a, b) => board.line(a, b, Role::Ground),
        }
    }
    let Some(Tie::Cord(tie)) = view.scene.ties.get(run.tie) else { return };
    let standing = plan.bodies.get(tie.from.body).and_then(Option::as_ref);
    match run.stop {
        Stop::Pull(a, b) => {
            board.arrow(a, b, Role::Force);
            if let Far::Pull(n) = tie.to {
                let towards = run.leaves.1;
                let over = standing.map_or(left(towards), |p| p.top);
                board.wish(
                    view.label(n, "N"),
                    vec![(b, towards), (middle(a, b), over), (middle(a, b), mul(over, -1.0))],
                    Role::Force,
                );
            }
        }
        Stop::Spring(a, b, _) => {
            let towards = run.leaves.1;
            board.spring(a, b, 8, 8.5);
            // The wall reaches down to the surface of the body.
            let depth = match standing {
                Some(p) if p.on.is_some() => dot(sub(run.leaves.0, p.centre), p.top) + p.contact,
                _ => 20.0,
            };
            let over = standing.map_or(left(towards), |p| p.top);
            let (down, up) = if dot(left(towards), over) > 0.0 { (-depth, 22.0) } else { (-22.0, depth) };
            wall(board, b, towards, down, up);
            if let Far::Spring { stiffness_n_m, stretch_m, .. } = tie.to {
                let mid = middle(a, b);
                board.wish(
                    view.label(stiffness_n_m, "N/m"),
                    vec![(along(mid, over, 10.0), over), (along(mid, over, -10.0), mul(over, -1.0))],
                    Role::Spring,
                );
                stretch(board, view, run, over, stretch_m);
            }
        }
        Stop::Fixed(at, towards) => wall(board, at, towards, -26.0, 26.0),
        Stop::Body => {}
    }
}

/// The stretch of a spring as a dimension: from where its end is to where it would be without.
fn stretch(board: &mut Board, view: &View, run: &layout::Run, over: V, num: Num) {
    let Stop::Spring(a, _, rest) = run.stop else { return };
    let under = mul(over, -1.0);
    let long = size(sub(rest, a));
    if long < 1.0 {
        return;
    }
    let off = 22.0;
    for p in [a, rest] {
        board.line(along(p, under, 11.0), along(p, under, off + 5.0), Role::Dimension);
    }
    let (p, q) = (along(a, under, off), along(rest, under, off));
    board.double_arrow(p, q, Role::Dimension);
    board.wish(
        view.label(num, "m"),
        vec![(middle(p, q), under), (q, run.leaves.1), (p, mul(run.leaves.1, -1.0))],
        Role::Dimension,
    );
}

/// Directions from a wheel's centre that are taken.
fn busy(view: &View, plan: &Layout, body: usize, p: &Placed) -> Vec<V> {
    let mut out = Vec::new();
    if p.on.is_some() {
        out.push(mul(p.top, -1.0));
    }
    for run in &plan.cords {
        let Some(Tie::Cord(c)) = view.scene.ties.get(run.tie) else { continue };
        let ends_here = |at: V| size(sub(at, p.centre)) < p.reach((1.0, 0.0)) + 2.0;
        if c.from.body == body || matches!(c.to, Far::Body(e) if e.body == body) {
            for piece in &run.pieces {
                if let Piece::Straight(a, b) = *piece {
                    for (near, far) in [(a, b), (b, a)] {
                        if ends_here(near) && !ends_here(far) {
                            // The cord crosses the edge between its start and a point a little on.
                            out.push(unit(sub(along(near, unit(sub(far, near)), 30.0), p.centre)));
                        }
                    }
                }
            }
        }
    }
    if view.scene.bodies[body].line.is_none() {
        // The bracket.
        out.push((0.0, 1.0));
    }
    if matches!(view.scene.end, End::Travel(c, _) if c.body == body)
        && let Some(sense) = told(view)
    {
        out.push(mul(p.forward, sense));
    }
    for start in &view.scene.start {
        if let Start::Speed(c, num) = *start
            && c.body == body
        {
            out.push(mul(p.forward, if view.of(num) < 0.0 { -1.0 } else { 1.0 }));
        }
    }
    out
}

/// Where radii are drawn, degrees from forward toward the top, best first.
const SPOKES: [f64; 9] = [176.0, 148.0, 38.0, 210.0, 330.0, 120.0, 62.0, 240.0, 300.0];

/// The same for a small pulley, which has cords to the left and below.
const PULLEY_SPOKES: [f64; 9] = [38.0, 62.0, 330.0, 120.0, 148.0, 176.0, 300.0, 210.0, 240.0];

/// A direction for a radius that is clear of those taken.
fn spoke(p: &Placed, taken: &[V]) -> V {
    let small = p.on.is_none() && p.reach((1.0, 0.0)) < 48.0;
    let spokes = if small { &PULLEY_SPOKES } else { &SPOKES };
    let direction = |degrees: &f64| {
        let (c, s) = polar_degrees(*degrees);
        add(mul(p.forward, c), mul(p.top, s))
    };
    // Clear is 22 degrees apart.
    let clear = |d: &V| taken.iter().all(|t| dot(*t, *d) < 0.927);
    spokes.iter().map(direction).find(clear).unwrap_or_else(|| direction(&spokes[0]))
}

fn body_labels(board: &mut Board, view: &View, plan: &Layout, index: usize, p: &Placed) {
    let body = &view.scene.bodies[index];
    match &p.look {
        Look::Block { .. } => {
            if let Some((n, weight)) = view.mass(body) {
                let runs = view.label(n, if weight { "N" } else { "kg" });
                // Beside it, on the side away from other things.
                let side = if p.on.is_some() { p.top } else { (1.0, 0.0) };
                let at = |d: V| (along(p.centre, d, p.reach(d)), d);
                let wide = symbol::width(&runs, TEXT);
                if wide + 6.0 < 2.0 * p.reach((1.0, 0.0)) && p.reach((0.0, 1.0)) > 11.0 {
                    board.wish_for(Wish {
                        rows: vec![runs],
                        size: TEXT,
                        role: Role::Dot,
                        spots: vec![(along(p.centre, (0.0, -1.0), 9.5), (0.0, 1.0))],
                        gap: 0.0,
                        tie: Tied::Near,
                    });
                } else {
                    board.wish(runs, vec![at(side), at(mul(side, -1.0)), at((0.0, -1.0))], Role::Dot);
                }
            }
        }
        Look::Wheel { outer, rings, .. } => {
            let mut taken = busy(view, plan, index, p);
            for (num, metres) in view.radii(body) {
                let radius = metres * plan.scale;
                let d = spoke(p, &taken);
                taken.push(d);
                let tip = along(p.centre, d, radius);
                board.arrow(p.centre, tip, Role::Dimension);
                let end = if radius < outer - 1.0 { along(p.centre, d, outer + 9.0) } else { tip };
                if radius < outer - 1.0 {
                    board.line(tip, end, Role::Dimension);
                }
                board.wish(view.label(num, "m"), vec![(end, d)], Role::Dimension);
            }
            if *outer > 30.0 && p.on.is_some() {
                // The mass centre has its letter where nothing runs.
                // A hub too small for it has it above.
                let small = rings.last().copied().filter(|r| *r < 27.0 && r + 22.0 < *outer);
                let off = small.unwrap_or(0.0);
                let angles = if small.is_some() {
                    [90.0, 60.0, 120.0, 30.0, 0.0]
                } else {
                    [300.0, 250.0, 60.0, 120.0, 20.0]
                };
                let around = angles.map(|degrees| {
                    let (c, s) = polar_degrees(degrees);
                    let d = add(mul(p.forward, c), mul(p.top, s));
                    (along(p.centre, d, off), d)
                });
                board.wish_for(Wish {
                    rows: vec![vec![symbol::run("G", RunStyle::Italic)]],
                    size: TEXT,
                    role: Role::Dot,
                    spots: around.to_vec(),
                    gap: 4.0,
                    tie: Tied::Near,
                });
            }
            let mut list: Vec<Vec<Run>> = Vec::new();
            if let Some((n, weight)) = view.mass(body)
                && matches!(n, Num::Datum(_))
            {
                list.push(view.label(n, if weight { "N" } else { "kg" }));
            }
            match &body.inertia {
                Some(RotaryInertia::Gyration(n @ Num::Datum(_))) => list.push(view.label(*n, "m")),
                Some(RotaryInertia::Moment(n @ Num::Datum(_))) => {
                    list.push(view.label(*n, "kg·m<sup>2</sup>"));
                }
                _ => {}
            }
            let around = [40.0, 60.0, 20.0, 130.0, 155.0, 320.0, 220.0].map(|degrees| {
                let (c, s) = polar_degrees(degrees);
                let d = add(mul(p.forward, c), mul(p.top, s));
                (along(p.centre, d, *outer), d)
            });
            board.wish_for(Wish {
                rows: list,
                size: TEXT,
                role: Role::Dot,
                spots: around.to_vec(),
                gap: 6.0,
                tie: Tied::Loose,
            });
        }
    }
}

/// Coefficients at the contacts.
fn ties(board: &mut Board, view: &View, plan: &Layout) {
    for (index, tie) in view.scene.ties.iter().enumerate() {
        let (Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. }) = *tie else {
            continue;
        };
        let Some(p) = plan.bodies.get(body).and_then(Option::as_ref) else { continue };
        let contact = along(p.centre, p.top, -p.contact);
        let under = mul(p.top, -1.0);
        let aside = |far: f64| (along(along(contact, p.forward, far), under, 12.0), under);
        let clear = p.reach(p.forward) + 40.0;
        let spots = if p.on_rail() {
            vec![aside(clear), aside(-clear), aside(clear + 40.0)]
        } else {
            vec![aside(0.0), aside(40.0), aside(-40.0), aside(clear)]
        };
        let coefficient = |(tex, num): (&str, Num)| match num {
            Num::Datum(_) => view.label(num, ""),
            // A bare number would say nothing.
            Num::Fixed(_) => joined(own(tex), view.value(num, "")),
        };
        let rows = view.coefficients(index).into_iter().map(coefficient).collect();
        board.wish_for(Wish { rows, size: TEXT, role: Role::Dot, spots, gap: 3.0, tie: Tied::Loose });
    }
}

fn couples(board: &mut Board, view: &View, plan: &Layout) {
    for couple in &view.scene.couples {
        let Some(p) = plan.bodies.get(couple.body).and_then(Option::as_ref) else { continue };
        let forward = couple.forward == (view.of(couple.moment_n_m) >= 0.0);
        let clockwise = p.clockwise == forward;
        let radius = (p.reach((1.0, 0.0)) * 0.45).max(16.0);
        let mid = angle(p.top);
        let (from, to) = if clockwise { (mid + 1.9, mid - 1.9) } else { (mid - 1.9, mid + 1.9) };
        board.curved_arrow(p.centre, radius, from, to, Role::Force);
        board.wish(
            view.size_label(couple.moment_n_m, "N·m"),
            vec![(along(p.centre, p.top, radius), p.top)],
            Role::Force,
        );
    }
}

/// Speeds and spins at the start, in the sense that they have.
fn starts(board: &mut Board, view: &View, plan: &Layout) {
    for start in &view.scene.start {
        let Start::Speed(Coordinate { body, degree }, num) = *start else { continue };
        let Some(p) = plan.bodies.get(body).and_then(Option::as_ref) else { continue };
        if view.of(num).abs() < 1e-12 {
            continue;
        }
        let actual = if view.of(num) < 0.0 { -1.0 } else { 1.0 };
        match degree {
            Degree::Along => {
                let from = p.centre;
                let towards = mul(p.forward, actual);
                let to = along(from, towards, p.reach(towards) + 42.0);
                board.arrow(from, to, Role::Motion);
                board.wish(view.size_label(num, "m/s"), vec![(to, towards), (to, p.top)], Role::Motion);
            }
            Degree::Turn => {
                let radius = p.reach((1.0, 0.0)) + 11.0;
                let mid = angle(p.top);
                let sense = if p.clockwise { -actual } else { actual };
                board.curved_arrow(p.centre, radius, mid - sense * 0.55, mid + sense * 0.55, Role::Motion);
                board.wish(
                    view.size_label(num, "rad/s"),
                    vec![(along(p.centre, p.top, radius), p.top)],
                    Role::Motion,
                );
            }
        }
    }
}

/// Which way the ending coordinate goes, as far as the picture may tell: declared, or asked by no question, or solved.
fn told(view: &View) -> Option<f64> {
    match view.scene.heading {
        Some(Heading::Forward) => return Some(1.0),
        Some(Heading::Back) => return Some(-1.0),
        None => {}
    }
    let asked = |q: Quantity| view.problem.questions.iter().any(|x| x.label.quantity == q);
    if !view.worked && (asked(Quantity::Direction) || asked(Quantity::Displacement)) {
        return None;
    }
    let c = view.scene.ending_coordinate();
    let up = view.scene.bodies.get(c.body).and_then(|b| b.line).is_none_or(|l| l.forward_up);
    view.variant.solved.words.iter().find_map(|(label, word)| {
        let whose = label.quantity == Quantity::Direction && label.of == Owner::Body(c.body);
        match word {
            _ if !whose => None,
            Word::Forward => Some(1.0),
            Word::Back => Some(-1.0),
            Word::Up => Some(if up { 1.0 } else { -1.0 }),
            Word::Down => Some(if up { -1.0 } else { 1.0 }),
            Word::Stays | Word::Yes | Word::No => None,
        }
    })
}

/// How far the ending body goes.
fn travel(board: &mut Board, view: &View, plan: &Layout) {
    let End::Travel(Coordinate { body, degree: Degree::Along }, num) = view.scene.end else { return };
    let Some(p) = plan.bodies.get(body).and_then(Option::as_ref) else { return };
    let Some(sense) = told(view) else { return };
    let towards = mul(p.forward, sense);
    // To scale where it fits, else cut short, with a break.
    let real = view.of(num) * plan.scale;
    let reach = p.reach(towards);
    let hanging = p.on.is_none();
    let most = if hanging { reach + 70.0 } else { reach + 96.0 };
    let (long, cut) = if real > most { (most, true) } else { (real, false) };
    // Beside what hangs, on the side where nothing else is.
    let crowded = plan.bodies.iter().flatten().any(|q| (1.0..160.0).contains(&(q.centre.0 - p.centre.0)));
    let beside = if crowded { (-1.0, 0.0) } else { (1.0, 0.0) };
    let side = if hanging { (p.reach((1.0, 0.0)) + 36.0, beside) } else { (0.0, p.top) };
    let from = along(p.centre, side.1, side.0);
    let to = along(from, towards, long);
    let across = if hanging { beside } else { p.top };
    if hanging {
        board.line(along(from, across, -9.0), along(from, across, 9.0), Role::Dimension);
    }
    board.line(along(to, across, -10.0), along(to, across, 10.0), Role::Ghost);
    if cut {
        let at = along(from, towards, (reach + long) / 2.0 - if hanging { 6.0 } else { 0.0 });
        board.line(from, along(at, towards, -3.0), Role::Dimension);
        board.arrow(along(at, towards, 3.0), to, Role::Dimension);
        for s in [-3.0, 3.0] {
            let c = along(at, towards, s);
            let slant = unit(add(across, mul(towards, 0.5)));
            board.line(along(c, slant, -6.0), along(c, slant, 6.0), Role::Dimension);
        }
    } else {
        board.arrow(from, to, Role::Dimension);
    }
    let mid = along(from, towards, if hanging { long * 0.6 } else { (reach + long) / 2.0 });
    let spots = match long < reach + 20.0 && !hanging {
        true => vec![(along(from, towards, reach.max(long)), towards)],
        false => vec![(mid, across), (mid, mul(across, -1.0)), (to, towards)],
    };
    board.wish(view.label(num, "m"), spots, Role::Dimension);
}

/// Positive senses.
fn senses(board: &mut Board, view: &View, plan: &Layout) {
    let plus = |board: &mut Board, spots: Vec<(V, V)>| {
        board.wish_for(Wish {
            rows: vec![vec![symbol::run("+", RunStyle::Upright)]],
            size: TEXT,
            role: Role::Motion,
            spots,
            gap: 3.0,
            tie: Tied::Near,
        });
    };
    for (b, p) in plan.bodies.iter().enumerate() {
        let Some(p) = p else { continue };
        let body = &view.scene.bodies[b];
        let given = |s: &Start| matches!(s, Start::Speed(c, n) if c.body == b && view.of(*n).abs() > 1e-12);
        if view.scene.start.iter().any(given) {
            continue;
        }
        // Bodies that stand on one surface share their arrow.
        let told = plan.bodies[..b]
            .iter()
            .flatten()
            .any(|q| p.on.is_some() && q.on == p.on && dot(q.forward, p.forward) > 0.0);
        if body.line.is_some() && !told {
            let (at, off) = if p.on.is_some() {
                let back = mul(p.forward, -1.0);
                (along(along(p.centre, back, p.reach(back) + 50.0), p.top, 22.0 - p.contact), p.top)
            } else {
                let side = (1.0, 0.0);
                // Beside what turns, farther on: its own arrow is round the top.
                let far = if body.turns { p.reach(side) * 0.5 } else { -16.0 };
                (along(along(p.centre, side, p.reach(side) + 14.0), p.forward, far), side)
            };
            let tip = along(at, p.forward, 32.0);
            board.arrow(at, tip, Role::Motion);
            plus(
                board,
                vec![(tip, off), (middle(at, tip), off), (at, mul(p.forward, -1.0)), (tip, p.forward)],
            );
        }
        let outer = p.reach((1.0, 0.0));
        if body.turns && outer > SMALL {
            let sense = if p.clockwise { -1.0 } else { 1.0 };
            let radius = outer + 9.0;
            let taken = busy(view, plan, b, p);
            // Round the top, behind where cords leave; on an axle where it is free.
            let places = [113.0, 68.0, 160.0, 20.0, 205.0, 230.0, 310.0, 335.0].map(|degrees| {
                let (c, s) = polar_degrees(degrees);
                add(mul(p.forward, c), mul(p.top, s))
            });
            let clear = |d: &V| taken.iter().all(|t| dot(*t, *d) < 0.82);
            let d = places.iter().copied().find(clear).unwrap_or(places[0]);
            let mid = angle(d);
            board.curved_arrow(p.centre, radius, mid - sense * 0.36, mid + sense * 0.36, Role::Motion);
            plus(
                board,
                vec![
                    (along(p.centre, d, radius), d),
                    (along(p.centre, polar(mid + sense * 0.36), radius), d),
                ],
            );
        }
    }
}
