//! The picture of a scene at its start, to scale.
use crate::bank::{FigureLabels, Problem};
use crate::figure::layout::{BodyLook, CordPiece, CordRun, CordStop, Placed, SceneLayout};
use crate::figure::view::{SceneView, joined};
use crate::figure::{joined as linkage, lamina, layout, names, parts, say};
use crate::picture::board::{Board, LabelTie, TEXT};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Picture, Role, TextRun, symbol};
use crate::problem::maker::Variant;
use crate::scene::{
    Coordinate, Degree, End, Far, GivenForce, Heading, Label, Made, Num, Owner, Quantity, RotaryInertia,
    Slope, Start, Tie,
};
use crate::solve::outcome::Word;
use crate::words::Words;

/// The scene of a variant at its start.
pub fn picture(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels) -> Picture {
    drawn(problem, variant, words, labels, false)
}

/// The same for a worked solution: also the way that the ending body takes where its direction is asked.
pub fn worked(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels) -> Picture {
    drawn(problem, variant, words, labels, true)
}

fn drawn(problem: &Problem, variant: &Variant, words: &Words, labels: FigureLabels, worked: bool) -> Picture {
    let Some(view) = SceneView::new(problem, variant, words, labels).map(|v| SceneView { worked, ..v })
    else {
        return Board::new().finish(problem.title.clone(), String::new());
    };
    let mut board = Board::new();
    let mut desc = Vec::new();
    let bodies = &view.scene.bodies;
    let title = words.say("figure.scene.title", &[("title", &problem.title)]);
    if view.scene.lead().is_some() {
        linkage::draw(&mut board, &view);
        linkage::tell(&view, &mut desc);
        carrier(&mut board, &view, &mut desc);
        return board.finish(title, desc.join(" "));
    }
    if bodies.iter().any(|b| b.planar.is_none() && b.particles.is_empty()) {
        let plan = layout::layout(&view);
        mechanism(&mut board, &view, &plan);
        say::mechanism(&view, &plan, told(&view).is_some(), &mut desc);
        carrier(&mut board, &view, &mut desc);
    }
    for (i, _) in bodies.iter().enumerate().filter(|(_, body)| !body.particles.is_empty()) {
        let mut part = Board::new();
        lamina::draw(&mut part, &view, i);
        say::lamina(&view, i, &mut desc);
        board.beside(part);
    }
    board.finish(title, desc.join(" "))
}

/// Bodies on surfaces, on axles, on cords.
fn mechanism(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    for ground in &plan.grounds {
        if !ground.rail {
            parts::surface(board, view, ground);
        }
    }
    parts::supports(board, view, plan);
    let placed = |b: usize| plan.bodies.get(b).and_then(Option::as_ref);
    // What rests on axles stands behind its wheels.
    let mut order: Vec<usize> = (0..view.scene.bodies.len()).collect();
    order.sort_by_key(|b| !view.scene.rests(*b));
    for p in order.into_iter().filter_map(placed) {
        parts::outline(board, p);
    }
    for ground in plan.grounds.iter().filter(|g| g.rail) {
        parts::surface(board, view, ground);
    }
    for p in plan.bodies.iter().flatten() {
        parts::inside(board, p);
    }
    for run in &plan.cords {
        parts::cord(board, view, plan, run);
    }
    if let Some(spring) = &plan.awaited {
        parts::awaited(board, view, spring);
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

/// What carries the scene: its speed at the start and its acceleration as arrows below, and in words.
fn carrier(board: &mut Board, view: &SceneView, desc: &mut Vec<String>) {
    let Some(carrier) = view.scene.carried else { return };
    let seen_from_the_side = view.scene.lead().is_some() && !view.scene.lies_level();
    if let (true, Slope::Level, Some(frame)) = (seen_from_the_side, carrier.slope, board.frame()) {
        // Joined bodies stand on a truck, or hang from a trolley.
        let (y, into) =
            if linkage::hangs(view) { (frame.high.y, Vec2::UP) } else { (frame.low.y, Vec2::DOWN) };
        let at = |x: f64| vec2(x, y);
        parts::moving_surface(board, at(frame.low.x - 24.0), at(frame.high.x + 24.0), into, false);
    }
    let Some(frame) = board.frame() else { return };
    let up = Vec2::at_degrees(view.degrees(carrier.slope));
    let numbers = [(carrier.speed_m_s, "m/s"), (carrier.acceleration_m_s2, "m/s<sup>2</sup>")];
    let moving = numbers.into_iter().filter(|(n, _)| view.of(*n) != 0.0);
    let mut list = Vec::new();
    let mut at = vec2((frame.low.x + frame.high.x) / 2.0, frame.low.y - 16.0);
    for (num, unit) in moving {
        let towards = up * view.of(num).signum();
        let half = towards * 26.0;
        at.y -= half.y.abs() + 14.0;
        board.arrow(at - half, at + half, Role::Motion);
        let beside = at + Vec2::RIGHT * (half.x.abs() + 8.0);
        let spots = vec![(beside, Vec2::RIGHT), (at + Vec2::DOWN * (half.y.abs() + 8.0), Vec2::DOWN)];
        board.wish(view.size_label(num, unit), spots, Role::Motion);
        list.push(say::text(view, num, unit));
        at.y -= half.y.abs();
    }
    let line = match carrier.slope {
        Slope::Level => "level",
        Slope::Vertical => "upright",
        Slope::Degrees(_) => "slope",
    };
    let line = view.words.get(&format!("figure.carried.{line}"));
    let numbers = list.join(say::separator(view));
    desc.push(view.words.say("figure.carried.all", &[("line", line), ("list", &numbers)]));
}

/// Directions from a wheel's centre that are taken.
fn busy(view: &SceneView, plan: &SceneLayout, body: usize, p: &Placed) -> Vec<Vec2> {
    let mut out = Vec::new();
    if p.on.is_some() {
        out.push(-p.top);
    }
    for run in &plan.cords {
        let Some(Tie::Cord(c)) = view.scene.ties.get(run.tie) else { continue };
        let ends_here = |at: Vec2| (at - p.centre).norm() < p.reach(Vec2::RIGHT) + 2.0;
        if c.made == Made::Teeth {
            out.extend(run.at.iter().filter(|(b, _)| *b == body).map(|(_, towards)| *towards));
        }
        if c.from.body == body || matches!(c.to, Far::Body(e) if e.body == body) {
            for piece in &run.pieces {
                if let CordPiece::Straight(a, b) = *piece {
                    for (near, far) in [(a, b), (b, a)] {
                        if ends_here(near) && !ends_here(far) {
                            // The cord crosses the edge between its start and a point a little on.
                            out.push((near + (far - near).unit() * 30.0 - p.centre).unit());
                        }
                    }
                }
            }
        }
    }
    if view.scene.bodies[body].line.is_none() {
        // The bracket.
        out.push(Vec2::UP);
    }
    if matches!(view.scene.end, End::Travel(c, _) if c.body == body)
        && let Some(sense) = told(view)
    {
        out.push(p.forward * sense);
    }
    for start in &view.scene.start {
        if let Start::Speed(c, num) = *start
            && c.body == body
        {
            out.push(p.forward * (if view.of(num) < 0.0 { -1.0 } else { 1.0 }));
        }
    }
    out
}

/// Where radii are drawn, degrees from forward toward the top, best first.
const SPOKES: [f64; 9] = [176.0, 148.0, 38.0, 210.0, 330.0, 120.0, 62.0, 240.0, 300.0];

/// The same for a small pulley, which has cords to the left and below.
const PULLEY_SPOKES: [f64; 9] = [38.0, 62.0, 330.0, 120.0, 148.0, 176.0, 300.0, 210.0, 240.0];

/// A direction for a radius that is clear of those taken.
fn spoke(p: &Placed, taken: &[Vec2]) -> Vec2 {
    let small = p.on.is_none() && p.reach(Vec2::RIGHT) < 48.0;
    let spokes = if small { &PULLEY_SPOKES } else { &SPOKES };
    let direction = |degrees: &f64| p.direction(*degrees);
    // Clear is 22 degrees apart.
    let clear = |d: &Vec2| taken.iter().all(|t| t.dot(d) < 0.927);
    spokes.iter().map(direction).find(clear).unwrap_or_else(|| direction(&spokes[0]))
}

fn body_labels(board: &mut Board, view: &SceneView, plan: &SceneLayout, index: usize, p: &Placed) {
    let body = &view.scene.bodies[index];
    match &p.look {
        BodyLook::Block { .. } => {
            if let Some((n, weight)) = view.mass(body) {
                let runs = view.label(n, if weight { "N" } else { "kg" });
                // Beside it, on the side away from other things.
                let side = if p.on.is_some() { p.top } else { Vec2::RIGHT };
                let at = |d: Vec2| (p.centre + d * p.reach(d), d);
                let wide = symbol::width(&runs, TEXT);
                let within = wide + 6.0 < 2.0 * p.reach(Vec2::RIGHT) && p.reach(Vec2::UP) > 11.0;
                // Within it, unless an arrow sets off from there.
                let within = Some((p.centre + Vec2::DOWN * 14.5, Vec2::UP))
                    .filter(|_| within && !view.scene.rests(index));
                let spots = within.into_iter().chain([at(side), at(-side), at(Vec2::DOWN)]);
                board.wish(runs, spots.collect(), Role::Dot);
            }
        }
        BodyLook::Wheel { outer, rings, .. } => {
            let mut taken = busy(view, plan, index, p);
            for (num, metres) in view.radii(body) {
                let radius = metres * plan.scale;
                let d = spoke(p, &taken);
                taken.push(d);
                let tip = p.centre + d * radius;
                board.arrow(p.centre, tip, Role::Dimension);
                let end = if radius < outer - 1.0 { p.centre + d * (outer + 9.0) } else { tip };
                if radius < outer - 1.0 {
                    board.line(tip, end, Role::Dimension);
                }
                board.wish(view.label(num, "m"), vec![(end, d)], Role::Dimension);
            }
            if *outer > 30.0 && p.on.is_some() {
                // The mass centre has its letter where nothing runs: within the hub, or beyond it where there is room.
                let small = rings.last().is_some_and(|r| *r < 27.0);
                let within = [300.0, 250.0, 60.0, 120.0, 20.0].map(|degrees| p.spot(degrees, 0.0));
                let hub = rings.last().copied().filter(|r| r + 22.0 < *outer);
                let beyond = [90.0, 60.0, 120.0, 30.0, 0.0, 150.0, 210.0, 240.0, 300.0, 330.0];
                let beyond = hub.into_iter().flat_map(|r| beyond.map(|degrees| p.spot(degrees, r)));
                let around = match hub.is_some() && small {
                    true => beyond.collect(),
                    false => within.into_iter().chain(beyond).collect(),
                };
                board.label(vec![symbol::italic("G")], Role::Dot, (LabelTie::Clear, 4.0), around);
            }
            if view.worked && p.on.is_some() {
                // The point about which a rolling body turns at each instant.
                let at = p.centre - p.top * p.contact;
                board.dot(at);
                let below = vec![(at, -p.top), (at, p.forward - p.top), (at, -p.forward - p.top)];
                board.label(vec![symbol::italic("C")], Role::Dot, (LabelTie::Clear, 4.0), below);
            }
            let mut list: Vec<Vec<TextRun>> = Vec::new();
            for (n, weight) in view.masses(body) {
                if matches!(n, Num::Datum(_)) {
                    list.push(view.label(n, if weight { "N" } else { "kg" }));
                }
            }
            match &body.inertia {
                Some(RotaryInertia::Gyration(n @ Num::Datum(_))) => list.push(view.label(*n, "m")),
                Some(RotaryInertia::Moment(n @ Num::Datum(_))) => {
                    list.push(view.label(*n, "kg·m<sup>2</sup>"));
                }
                _ => {}
            }
            let around =
                [40.0, 60.0, 20.0, 130.0, 155.0, 320.0, 220.0].map(|degrees| p.spot(degrees, *outer));
            board.label(list, Role::Dot, (LabelTie::Loose, 6.0), around.to_vec());
        }
    }
}

/// Coefficients at the contacts.
fn ties(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    for (index, tie) in view.scene.ties.iter().enumerate() {
        let Some(body) = tie.touching() else { continue };
        let Some(p) = plan.bodies.get(body).and_then(Option::as_ref) else { continue };
        let contact = p.centre - p.top * p.contact;
        let under = -p.top;
        let aside = |far: f64| (contact + p.forward * far + under * 12.0, under);
        let clear = p.reach(p.forward) + 40.0;
        let spots = if p.on_rail() {
            vec![aside(clear), aside(-clear), aside(clear + 40.0)]
        } else {
            // In a solution the letter of the contact stands below it.
            let apart = if view.worked { 34.0 } else { 0.0 };
            let beside = [aside(40.0 + apart), aside(-40.0 - apart), aside(clear)];
            let below = Some(aside(0.0)).filter(|_| !view.worked);
            below.into_iter().chain(beside).collect()
        };
        let coefficient = |(tex, num): (&str, Num)| match num {
            Num::Datum(_) | Num::Derived(_) => view.label(num, ""),
            // A bare number would say nothing.
            Num::Fixed(_) => joined(symbol::symbol(tex), view.value(num, "")),
        };
        let rows = view.coefficients(index).into_iter().map(coefficient).collect();
        board.label(rows, Role::Dot, (LabelTie::Loose, 3.0), spots);
    }
}

fn couples(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    for (i, couple) in view.scene.couples.iter().enumerate() {
        let Some(p) = plan.bodies.get(couple.body).and_then(Option::as_ref) else { continue };
        let forward = couple.forward == (view.of(couple.moment_n_m) >= 0.0);
        let clockwise = p.clockwise == forward;
        let radius = (p.reach(Vec2::RIGHT) * 0.45).max(16.0);
        let mid = p.top.angle_of();
        let (from, to) = if clockwise { (mid + 1.9, mid - 1.9) } else { (mid - 1.9, mid + 1.9) };
        board.curved_arrow(p.centre, radius, from, to, Role::Force);
        let label = view.force_label(GivenForce::Couple(i), couple.moment_n_m, "N·m");
        board.wish(label, vec![(p.centre + p.top * radius, p.top)], Role::Force);
    }
}

/// Speeds and spins at the start, in the sense that they have.
fn starts(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
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
                let towards = p.forward * actual;
                let to = from + towards * (p.reach(towards) + 42.0);
                board.arrow(from, to, Role::Motion);
                board.wish(view.size_label(num, "m/s"), vec![(to, towards), (to, p.top)], Role::Motion);
            }
            Degree::Turn => {
                let radius = p.reach(Vec2::RIGHT) + 11.0;
                let mid = p.top.angle_of();
                let sense = if p.clockwise { -actual } else { actual };
                board.curved_arrow(p.centre, radius, mid - sense * 0.55, mid + sense * 0.55, Role::Motion);
                let spots = vec![(p.centre + p.top * radius, p.top)];
                board.wish(view.size_label(num, "rad/s"), spots, Role::Motion);
            }
        }
    }
}

/// Which way the ending coordinate goes, as far as the picture may tell: declared, or asked by no question, or solved.
fn told(view: &SceneView) -> Option<f64> {
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
    let whose = Label { quantity: Quantity::Direction, of: Owner::Body(c.body) };
    let told = view.variant.solved.words.iter().filter(|(label, _)| *label == whose);
    told.filter_map(|(_, word)| match word {
        Word::Stays | Word::Yes | Word::No => None,
        Word::Forward | Word::Back => Some(*word == Word::Forward),
        Word::Up | Word::Down => Some((*word == Word::Up) == up),
    })
    .map(|forward| if forward { 1.0 } else { -1.0 })
    .next()
}

/// How far the ending body goes.
fn travel(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    let End::Travel(Coordinate { body, degree: Degree::Along }, num) = view.scene.end else { return };
    let Some(p) = plan.bodies.get(body).and_then(Option::as_ref) else { return };
    let Some(sense) = told(view) else { return };
    let towards = p.forward * sense;
    let hanging = p.on.is_none();
    // To scale where it fits, else cut short, with a break.
    let real = view.of(num) * plan.scale;
    let (reach, most) = (p.reach(towards), layout::most_travel(p, towards));
    // Beside what hangs, on the side where nothing else is.
    let crowded = plan.bodies.iter().flatten().any(|q| (1.0..160.0).contains(&(q.centre.x - p.centre.x)));
    let beside = if crowded { Vec2::LEFT } else { Vec2::RIGHT };
    // Where something pulls along it, it would lie on that.
    let pulled = plan.cords.iter().filter(|r| matches!(r.stop, CordStop::Pull(..) | CordStop::Spring(..)));
    let mut pulled = pulled.filter(|r| r.at.iter().any(|(b, _)| *b == body));
    let covered =
        pulled.any(|r| (r.leaves.0 - p.centre).dot(&p.top).abs() < 8.0 && r.leaves.1.dot(&towards) > 0.99);
    let low = !hanging && (real < reach || covered);
    let way = if hanging {
        let from = p.centre + beside * (p.reach(Vec2::RIGHT) + 36.0);
        Displacement { from, towards, real, most, hidden: 0.0, across: beside }
    } else if low {
        // A short one would be lost within the body too: below the surface, from the contact.
        let from = p.centre - p.top * (p.contact + 24.0);
        Displacement { from, towards, real, most, hidden: 0.0, across: -p.top }
    } else {
        Displacement { from: p.centre, towards, real, most, hidden: reach, across: p.top }
    };
    way.draw(board, view.label(num, "m"), hanging || low);
    if view.worked {
        unwound(board, view, plan, (body, sense, num));
    }
}

/// A displacement as a dimension: to scale, or cut short with a break.
struct Displacement {
    from: Vec2,
    towards: Vec2,
    /// Its true length.
    real: f64,
    /// The longest that is drawn.
    most: f64,
    /// As much of it lies within a body.
    hidden: f64,
    /// Square to it, to where its label stands.
    across: Vec2,
}

impl Displacement {
    /// Draws it; `stands` where it begins at a mark of its own.
    fn draw(&self, board: &mut Board, label: Vec<TextRun>, stands: bool) {
        let Self { from, towards, real, most, hidden, across } = *self;
        let long = real.min(most);
        let to = from + towards * long;
        if stands {
            board.line(from - across * 9.0, from + across * 9.0, Role::Dimension);
        }
        board.line(to - across * 10.0, to + across * 10.0, Role::Ghost);
        let shown = if stands { 0.6 * long } else { (hidden + long) / 2.0 };
        if real > most {
            let at = from + towards * (if stands { 0.5 * long } else { shown });
            board.line(from, at - towards * 3.0, Role::Dimension);
            board.arrow(at + towards * 3.0, to, Role::Dimension);
            for s in [-3.0, 3.0] {
                let c = at + towards * s;
                let slant = (across + towards * 0.5).unit();
                board.line(c - slant * 6.0, c + slant * 6.0, Role::Dimension);
            }
        } else {
            board.arrow(from, to, Role::Dimension);
        }
        let mid = from + towards * shown;
        let spots = match long < hidden + 20.0 && !stands {
            true => vec![(from + towards * hidden.max(long), towards)],
            false => vec![(mid, across), (mid, -across), (to, towards)],
        };
        board.wish(label, spots, Role::Dimension);
    }
}

/// How far the end of a cord goes that pulls a rolling body: the ratio of displacements times the way of the centre.
fn unwound(board: &mut Board, view: &SceneView, plan: &SceneLayout, (body, sense, num): (usize, f64, Num)) {
    let rolling = view.scene.ties.iter().find_map(|t| match t {
        Tie::Roll { body: b, radius_m, .. } if *b == body => Some(view.of(*radius_m)),
        _ => None,
    });
    let pulling = |run: &&CordRun| match view.scene.ties.get(run.tie) {
        Some(Tie::Cord(c)) => c.from.body == body && matches!(c.to, Far::Pull(_) | Far::Spring { .. }),
        _ => false,
    };
    let mut runs = plan.cords.iter().filter(pulling);
    let (Some(radius), Some(run), None) = (rolling, runs.next(), runs.next()) else { return };
    let (CordStop::Pull(end, _) | CordStop::Spring(end, ..)) = run.stop else { return };
    let Some(action) = view.scene.ties[run.tie].actions().next() else { return };
    let (Some((arm, turn)), None) = (action.arm, action.tilt_deg) else { return };
    let ratio = action.along + turn * view.of(arm) / radius;
    let symbol = names::free(view.problem, &[r"\gamma".to_owned(), "n".to_owned()]);
    let mut label = symbol::symbol(&symbol);
    label.extend(view.symbol(num));
    let over = plan.bodies[body].as_ref().map_or(Vec2::UP, |p| p.top);
    let real = ratio.abs() * view.of(num) * plan.scale;
    let towards = run.leaves.1 * (sense * ratio).signum();
    let way = Displacement { from: end + over * 18.0, towards, real, most: 90.0, hidden: 0.0, across: over };
    way.draw(board, label, true);
}

/// Positive senses.
fn senses(board: &mut Board, view: &SceneView, plan: &SceneLayout) {
    let plus = |board: &mut Board, spots: Vec<(Vec2, Vec2)>| {
        board.label(vec![symbol::upright("+")], Role::Motion, (LabelTie::Near, 3.0), spots);
    };
    for (b, p) in plan.bodies.iter().enumerate() {
        let Some(p) = p else { continue };
        let body = &view.scene.bodies[b];
        if view.started(b).next().is_some() {
            continue;
        }
        // Bodies that stand on one surface share their arrow.
        let shares = |q: &Placed| p.on.is_some() && q.on == p.on && q.forward.dot(&p.forward) > 0.0;
        let told = plan.bodies[..b].iter().flatten().any(shares);
        if body.line.is_some() && !told {
            let (at, off) = if p.on.is_some() {
                let back = -p.forward;
                (p.centre + back * (p.reach(back) + 50.0) + p.top * (22.0 - p.contact), p.top)
            } else {
                let side = Vec2::RIGHT;
                // Beside what turns, farther on: its own arrow is round the top.
                let far = if body.turns { p.reach(side) * 0.5 } else { -16.0 };
                (p.centre + side * (p.reach(side) + 14.0) + p.forward * far, side)
            };
            let tip = at + p.forward * 32.0;
            board.arrow(at, tip, Role::Motion);
            plus(board, vec![(tip, off), (at.middle(tip), off), (at, -p.forward), (tip, p.forward)]);
        }
        if body.turns {
            let sense = if p.clockwise { -1.0 } else { 1.0 };
            let radius = p.reach(Vec2::RIGHT) + 9.0;
            // As long on a small body as on a larger one.
            let half = (14.0 / radius).max(0.36);
            let taken = busy(view, plan, b, p);
            // Round the top, behind where cords leave; on an axle where it is free.
            let places =
                [113.0, 68.0, 160.0, 20.0, 205.0, 230.0, 310.0, 335.0].map(|degrees| p.direction(degrees));
            let clear = |d: &Vec2| taken.iter().all(|t| t.dot(d) < Vec2::at_angle(half + 0.25).x);
            let d = places.iter().copied().find(clear).unwrap_or(places[0]);
            let mid = d.angle_of();
            board.curved_arrow(p.centre, radius, mid - sense * half, mid + sense * half, Role::Motion);
            let tip = Vec2::at_angle(mid + sense * half);
            plus(board, vec![(p.centre + d * radius, d), (p.centre + tip * radius, d)]);
        }
    }
}
