//! The picture of a lamina: particles joined by light rods, axes, the velocity of one particle, the spin.
use crate::bank::FigureLabels;
use crate::figure::board::Board;
use crate::figure::board::TEXT;
use crate::figure::board::Tied;
use crate::figure::board::Wish;
use crate::figure::picture::Role;
use crate::figure::picture::RunStyle;
use crate::figure::symbol;
use crate::figure::vector::V;
use crate::figure::vector::add;
use crate::figure::vector::along;
use crate::figure::vector::angle;
use crate::figure::vector::dot;
use crate::figure::vector::left;
use crate::figure::vector::mul;
use crate::figure::vector::right;
use crate::figure::vector::size;
use crate::figure::vector::sub;
use crate::figure::vector::unit;
use crate::figure::view::View;
use crate::num::shown;
use crate::scene::Start;

/// Pixels of the longer side.
const SIDE: f64 = 300.0;
/// Size of the numbers at the axes.
const TICKS: f64 = 12.5;

/// Draws a lamina.
pub fn draw(board: &mut Board, view: &View, index: usize) {
    let body = &view.scene.bodies[index];
    let metres: Vec<V> = body.particles.iter().map(|p| (view.of(p.x_m), view.of(p.y_m))).collect();
    let (mut low, mut high) = ((0.0f64, 0.0f64), (0.0f64, 0.0f64));
    for p in &metres {
        low = (low.0.min(p.0), low.1.min(p.1));
        high = (high.0.max(p.0), high.1.max(p.1));
    }
    let span = (high.0 - low.0).max(high.1 - low.1);
    let span = if span.is_finite() && span > 0.0 { span } else { 1.0 };
    let scale = SIDE / span;
    let at = |p: &V| mul(*p, scale);
    let places: Vec<V> = metres.iter().map(at).collect();
    axes(board, view, mul(low, scale), mul(high, scale), scale);
    // Light rods round the body, in the order of the angles about its middle.
    let middle = mul(places.iter().fold((0.0, 0.0), |sum, p| add(sum, *p)), 1.0 / places.len().max(1) as f64);
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|a, b| {
        let of = |i: usize| angle(sub(places[i], middle));
        of(*a).total_cmp(&of(*b))
    });
    let ring: Vec<V> = order.iter().map(|i| places[*i]).collect();
    if ring.len() > 1 {
        board.lines(&ring, ring.len() > 2, Role::Ground);
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
        let v = (view.of(vx_m_s), view.of(vy_m_s));
        if let Some(place) = places.get(particle)
            && size(v) > 1e-9
        {
            let towards = unit(v);
            let tip = along(*place, towards, (30.0 + 9.0 * size(v)).min(78.0));
            board.arrow(along(*place, towards, 8.0), tip, Role::Motion);
            board.wish_for(Wish {
                rows: vec![view.label(vx_m_s, "m/s"), view.label(vy_m_s, "m/s")],
                size: TEXT,
                role: Role::Motion,
                spots: vec![
                    (tip, towards),
                    (along(tip, towards, -14.0), left(towards)),
                    (along(tip, towards, -14.0), right(towards)),
                    (tip, (1.0, 0.0)),
                    (tip, (-1.0, 0.0)),
                    (tip, (0.0, 1.0)),
                    (tip, (0.0, -1.0)),
                ],
                gap: 4.0,
                tie: Tied::Leader,
            });
        }
        // The spin stands where there is room, in the sense that it has; counter-clockwise is positive.
        let centre = roomy(&ring, mul(low, scale), mul(high, scale));
        let (from, to) = if view.of(spin_rad_s) < 0.0 { (3.7, -1.0) } else { (-0.5, 4.2) };
        board.curved_arrow(centre, 17.0, from, to, Role::Motion);
        board.wish(
            view.size_label(spin_rad_s, "rad/s"),
            vec![
                (along(centre, (0.0, -1.0), 17.0), (0.0, -1.0)),
                (along(centre, (0.0, 1.0), 17.0), (0.0, 1.0)),
            ],
            Role::Motion,
        );
    }
    for (p, place) in body.particles.iter().zip(&places) {
        let out = unit(sub(*place, middle));
        let mut name = vec![symbol::run(p.name.clone(), RunStyle::Italic)];
        if view.labels == FigureLabels::Symbols {
            name.push(symbol::run(",\u{a0}", RunStyle::Upright));
            name.extend(view.label(p.mass_kg, "kg"));
        } else {
            name.push(symbol::run(":\u{a0}", RunStyle::Upright));
            name.extend(view.value(p.mass_kg, "kg"));
        }
        board.wish_for(Wish {
            rows: vec![name],
            size: TEXT,
            role: Role::Dot,
            spots: vec![
                (along(*place, out, 8.0), out),
                (along(*place, (0.0, 1.0), 8.0), (0.0, 1.0)),
                (along(*place, (0.0, -1.0), 8.0), (0.0, -1.0)),
            ],
            gap: 3.0,
            tie: Tied::Leader,
        });
    }
}

/// The place in and round the field that is farthest from all rods and from the axes.
fn roomy(ring: &[V], low: V, high: V) -> V {
    let mut best = (f64::NEG_INFINITY, low);
    for i in 0..=14 {
        for j in 0..=14 {
            let p = (
                low.0 - 30.0 + (high.0 - low.0 + 60.0) * f64::from(i) / 14.0,
                low.1 - 30.0 + (high.1 - low.1 + 60.0) * f64::from(j) / 14.0,
            );
            let rods = (0..ring.len()).map(|k| (ring[k], ring[(k + 1) % ring.len()]));
            let near = rods.map(|(a, b)| far(p, a, b)).fold(f64::INFINITY, f64::min);
            // Far enough is far enough: then rather within the field.
            let outside = (low.0 - p.0).max(p.0 - high.0).max(low.1 - p.1).max(p.1 - high.1).max(0.0);
            let score = near.min(p.0.abs() * 1.2).min(p.1.abs() * 1.2).min(70.0) - outside * 0.4;
            if score > best.0 + 1e-9 {
                best = (score, p);
            }
        }
    }
    best.1
}

/// Distance of a point from a segment.
fn far(p: V, a: V, b: V) -> f64 {
    let (along, to) = (sub(b, a), sub(p, a));
    let long = dot(along, along);
    let share = if long > 0.0 { (dot(to, along) / long).clamp(0.0, 1.0) } else { 0.0 };
    size(sub(to, mul(along, share)))
}

fn axes(board: &mut Board, view: &View, low: V, high: V, scale: f64) {
    let (west, east) = (low.0 - 26.0, high.0 + 40.0);
    let (bottom, top) = (low.1 - 26.0, high.1 + 40.0);
    for (from, to, towards) in
        [((west, 0.0), (east, 0.0), (1.0, 0.0)), ((0.0, bottom), (0.0, top), (0.0, 1.0))]
    {
        board.line(from, along(to, towards, -7.0), Role::Axis);
        board.head(to, towards, Role::DimensionHead);
    }
    let italic = |t: &str| vec![symbol::run(t, RunStyle::Italic)];
    let near = |rows, at: V, towards: V, size: f64| Wish {
        rows: vec![rows],
        size,
        role: Role::Dot,
        spots: vec![(at, towards)],
        gap: 4.0,
        tie: Tied::Near,
    };
    board.wish_for(near(italic("x"), (east, 0.0), (1.0, 0.0), TEXT));
    board.wish_for(near(italic("y"), (0.0, top), (0.0, 1.0), TEXT));
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
            ((s, 0.0), (0.0, 1.0), s > west + 8.0 && s < east - 14.0),
            ((0.0, s), (1.0, 0.0), s > bottom + 8.0 && s < top - 14.0),
        ] {
            if inside {
                board.line(along(place, across, -4.0), along(place, across, 4.0), Role::Dimension);
                let towards = mul(across, -1.0);
                let mut wish =
                    near(symbol::upright(text.clone()), along(place, towards, 3.0), towards, TICKS);
                wish.spots.push((along(place, towards, -3.0), across));
                wish.gap = 3.0;
                board.wish_for(wish);
            }
        }
    }
    board.wish_for(Wish {
        rows: vec![symbol::upright("m")],
        size: TICKS,
        role: Role::Dot,
        spots: vec![((east, -6.0), (0.0, -1.0))],
        gap: 4.0,
        tie: Tied::Near,
    });
}
