//! The picture of a lamina: particles joined by light rods, axes, the velocity of one particle, the spin.
use crate::bank::FigureLabels;
use crate::figure::view::SceneView;
use crate::num::shown;
use crate::picture::board::{Board, LabelTie, LabelWish, TEXT};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Role, RunStyle, symbol};
use crate::scene::Start;

/// Pixels of the longer side.
const SIDE: f64 = 300.0;
/// Size of the numbers at the axes.
const TICKS: f64 = 12.5;

/// Draws a lamina.
pub fn draw(board: &mut Board, view: &SceneView, index: usize) {
    let body = &view.scene.bodies[index];
    let metres: Vec<Vec2> = body.particles.iter().map(|p| vec2(view.of(p.x_m), view.of(p.y_m))).collect();
    let (mut low, mut high) = (Vec2::ZERO, Vec2::ZERO);
    for p in &metres {
        low = low.inf(p);
        high = high.sup(p);
    }
    let span = (high.x - low.x).max(high.y - low.y);
    let span = if span.is_finite() && span > 0.0 { span } else { 1.0 };
    let scale = SIDE / span;
    let at = |p: &Vec2| *p * scale;
    let places: Vec<Vec2> = metres.iter().map(at).collect();
    axes(board, view, low * scale, high * scale, scale);
    // Light rods round the body, in the order of the angles about its middle.
    let middle = places.iter().fold(Vec2::ZERO, |sum, p| sum + *p) * (1.0 / places.len().max(1) as f64);
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|a, b| {
        let of = |i: usize| (places[i] - middle).angle_of();
        of(*a).total_cmp(&of(*b))
    });
    let ring: Vec<Vec2> = order.iter().map(|i| places[*i]).collect();
    if ring.len() > 1 {
        board.lines(&ring, ring.len() > 2, Role::Ground);
    }
    // A mere ring of rods would be a linkage.
    let diagonals = diagonals(&ring);
    for (a, b) in &diagonals {
        board.line(*a, *b, Role::Ground);
    }
    let most = body.particles.iter().map(|p| view.of(p.mass_kg)).fold(0.0, f64::max);
    for (p, place) in body.particles.iter().zip(&places) {
        let share = if most > 0.0 { view.of(p.mass_kg) / most } else { 1.0 };
        board.circle(*place, 8.5 * crate::num::trig::power(share.clamp(0.15, 1.0), 1.0 / 3.0), Role::Body);
    }
    for s in &view.scene.start {
        let Start::Lamina { body: b, particle, vx_m_s, vy_m_s, spin_rad_s } = *s else { continue };
        if b != index {
            continue;
        }
        let v = vec2(view.of(vx_m_s), view.of(vy_m_s));
        if let Some(place) = places.get(particle)
            && v.norm() > 1e-9
        {
            let towards = v.unit();
            let tip = *place + towards * (30.0 + 9.0 * v.norm()).min(78.0);
            board.arrow(*place + towards * 8.0, tip, Role::Motion);
            board.label(
                vec![view.label(vx_m_s, "m/s"), view.label(vy_m_s, "m/s")],
                Role::Motion,
                (LabelTie::Leader, 4.0),
                vec![
                    (tip, towards),
                    (tip - towards * 14.0, towards.left()),
                    (tip - towards * 14.0, towards.right()),
                    (tip, Vec2::RIGHT),
                    (tip, Vec2::LEFT),
                    (tip, Vec2::UP),
                    (tip, Vec2::DOWN),
                ],
            );
        }
        // The spin stands where there is room, in the sense that it has; counter-clockwise is positive.
        let centre = roomy(&ring, &diagonals, low * scale, high * scale);
        let (from, to) = if view.of(spin_rad_s) < 0.0 { (3.7, -1.0) } else { (-0.5, 4.2) };
        board.curved_arrow(centre, 17.0, from, to, Role::Motion);
        board.wish(
            view.size_label(spin_rad_s, "rad/s"),
            vec![(centre + Vec2::DOWN * 17.0, Vec2::DOWN), (centre + Vec2::UP * 17.0, Vec2::UP)],
            Role::Motion,
        );
    }
    for (p, place) in body.particles.iter().zip(&places) {
        let out = (*place - middle).unit();
        let mut name = symbol::italic(p.name.clone());
        if view.labels == FigureLabels::Symbols {
            name.push(symbol::run(",\u{a0}", RunStyle::Upright));
            name.extend(view.label(p.mass_kg, "kg"));
        } else {
            name.push(symbol::run(":\u{a0}", RunStyle::Upright));
            name.extend(view.value(p.mass_kg, "kg"));
        }
        board.label(
            vec![name],
            Role::Dot,
            (LabelTie::Leader, 3.0),
            vec![
                (*place + out * 8.0, out),
                (*place + Vec2::UP * 8.0, Vec2::UP),
                (*place + Vec2::DOWN * 8.0, Vec2::DOWN),
            ],
        );
    }
}

/// The diagonals that make a ring of rods, counter-clockwise, a rigid frame of triangles: corner by corner is cut off, each time
/// the one with the shortest diagonal among those that have no other particle within.
fn diagonals(ring: &[Vec2]) -> Vec<(Vec2, Vec2)> {
    let mut left = ring.to_vec();
    let mut found = Vec::new();
    let turn = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp(&(c - b));
    while left.len() > 3 {
        let n = left.len();
        let corner = |i: usize| (left[(i + n - 1) % n], left[i], left[(i + 1) % n]);
        let ear = |i: &usize| {
            let (a, b, c) = corner(*i);
            let within = |p: &Vec2| turn(a, b, *p) >= 0.0 && turn(b, c, *p) >= 0.0 && turn(c, a, *p) >= 0.0;
            let others = left.iter().filter(|p| **p != a && **p != b && **p != c);
            turn(a, b, c) > 1e-6 && !others.into_iter().any(within)
        };
        let long = |i: &usize| {
            let (a, _, c) = corner(*i);
            (c - a).norm()
        };
        let shortest = (0..n).filter(ear).min_by(|i, j| long(i).total_cmp(&long(j)));
        // Particles on one line have no ear.
        let Some(cut) = shortest else { break };
        let (a, _, c) = corner(cut);
        found.push((a, c));
        left.remove(cut);
    }
    found
}

/// The place in and round the field that is farthest from all rods and from the axes.
fn roomy(ring: &[Vec2], diagonals: &[(Vec2, Vec2)], low: Vec2, high: Vec2) -> Vec2 {
    let mut best = (f64::NEG_INFINITY, low);
    for i in 0..=14 {
        for j in 0..=14 {
            let p = vec2(
                low.x - 30.0 + (high.x - low.x + 60.0) * f64::from(i) / 14.0,
                low.y - 30.0 + (high.y - low.y + 60.0) * f64::from(j) / 14.0,
            );
            let rods = (0..ring.len()).map(|k| (ring[k], ring[(k + 1) % ring.len()]));
            let rods = rods.chain(diagonals.iter().copied());
            let near = rods.map(|(a, b)| far(p, a, b)).fold(f64::INFINITY, f64::min);
            // Far enough is far enough: then rather within the field.
            let outside = (low.x - p.x).max(p.x - high.x).max(low.y - p.y).max(p.y - high.y).max(0.0);
            let score = near.min(p.x.abs() * 1.2).min(p.y.abs() * 1.2).min(70.0) - outside * 0.4;
            if score > best.0 + 1e-9 {
                best = (score, p);
            }
        }
    }
    best.1
}

/// Distance of a point from a segment.
fn far(p: Vec2, a: Vec2, b: Vec2) -> f64 {
    let (along, to) = (b - a, p - a);
    let long = along.dot(&along);
    let share = if long > 0.0 { (to.dot(&along) / long).clamp(0.0, 1.0) } else { 0.0 };
    (to - along * share).norm()
}

fn axes(board: &mut Board, view: &SceneView, low: Vec2, high: Vec2, scale: f64) {
    let (west, east) = (low.x - 26.0, high.x + 40.0);
    let (bottom, top) = (low.y - 26.0, high.y + 40.0);
    for (from, to, towards) in
        [(vec2(west, 0.0), vec2(east, 0.0), Vec2::RIGHT), (vec2(0.0, bottom), vec2(0.0, top), Vec2::UP)]
    {
        board.line(from, to - towards * 7.0, Role::Axis);
        board.head(to, towards, Role::DimensionHead);
    }
    let near = |runs, at: Vec2, towards: Vec2, size: f64| LabelWish {
        tie: LabelTie::Near,
        ..LabelWish::note(runs, size, at, towards)
    };
    board.wish_for(near(symbol::italic("x"), vec2(east, 0.0), Vec2::RIGHT, TEXT));
    board.wish_for(near(symbol::italic("y"), vec2(0.0, top), Vec2::UP, TEXT));
    // Marks at round numbers, 48 pixels apart or more, with as many decimals as their step has.
    let steps = [(0.01, 2), (0.02, 2), (0.05, 2), (0.1, 1), (0.2, 1), (0.5, 1), (1.0, 0), (2.0, 0), (5.0, 0)];
    let wide = |(step, _): &&(f64, usize)| step * scale >= 48.0;
    let (step, decimals) = steps.iter().find(wide).copied().unwrap_or((10.0, 0));
    for i in -10..=10 {
        let value = f64::from(i) * step;
        let s = value * scale;
        if i == 0 {
            continue;
        }
        let text = view.words.number(&shown::decimals(value, decimals)).replace('-', "−");
        for (place, across, inside) in [
            (vec2(s, 0.0), Vec2::UP, s > west + 8.0 && s < east - 14.0),
            (vec2(0.0, s), Vec2::RIGHT, s > bottom + 8.0 && s < top - 14.0),
        ] {
            if inside {
                board.line(place - across * 4.0, place + across * 4.0, Role::Dimension);
                let towards = -across;
                let mut wish = near(symbol::upright(text.clone()), place + towards * 3.0, towards, TICKS);
                wish.spots.push((place - towards * 3.0, across));
                wish.gap = 3.0;
                board.wish_for(wish);
            }
        }
    }
    board.wish_for(near(symbol::upright("m"), vec2(east, -6.0), Vec2::DOWN, TICKS));
}
