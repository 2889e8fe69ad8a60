//! Wheels that rub where they are held: in a corner, on a line at the end of a link or a rod, under a brake; by the equations of
//! textbooks, and by a motion in time whose contacts are stiff springs.
use crate::joined::{all_near, constants, told};
use slipstick::scene::Quantity;
use slipstick::solve::agree;
use slipstick::solve::outcome::{CheckKind, Entry, Lacks, Refusal};

const G: f64 = 9.81;

/// A wheel of this shape in the corner between a floor and a wall, with these coefficients.
fn corner(shape: &str, [floor, wall]: [f64; 2], wall_at: &str, spin: f64, end: &str) -> String {
    let along = if wall_at == "left" { -90 } else { 90 };
    format!(
        "
bodies: {{wheel: {{mass: 7 kg, shape: {{{shape}: 0.25 m}}, moves: in the plane}}}}
joints:
  floor: {{slides: wheel, radius: 0.25 m, along: horizontal, mu_k: {floor:?}}}
  wall:  {{slides: wheel, radius: 0.25 m, along: {along} deg, mu_k: {wall:?}}}
start: {{wheel: {{spin: {spin:?} rad/s}}}}
end: {end}
"
    )
}

/// A wheel set down spinning in a corner: `N = m g / (1 + mu_1 mu_2)` at the floor, `mu_1 N` at the wall; with equal coefficients its
/// angular acceleration is `mu (1 + mu) g R / (k^2 (1 + mu^2))`.
#[test]
fn a_wheel_that_spins_in_a_corner() {
    for (shape, k2) in [("disc", 0.5), ("sphere", 0.4), ("hoop", 1.0)] {
        for ([one, two], wall, spin) in [([0.2, 0.2], "left", 30.0), ([0.35, 0.1], "right", -30.0)] {
            let names = ["alpha", "floor.normal", "wall.normal", "floor.friction", "wall.friction"];
            let normal = 7.0 * G / (1.0 + one * two);
            let alpha = one * (1.0 + two) * normal / (7.0 * k2 * 0.25);
            if one == two {
                let books = one * (1.0 + one) * G * 0.25 / (k2 * 0.0625 * (1.0 + one * one));
                all_near(&[alpha], &[books], 1e-14);
            }
            // The floor pushes it against the wall, the wall lifts it.
            let side = -f64::signum(spin);
            let expected = [side * alpha, normal, one * normal, side * one * normal, one * two * normal];
            all_near(&told(&corner(shape, [one, two], wall, spin, "at once"), &names), &expected, 1e-13);
            let stops = corner(shape, [one, two], wall, spin, "{turning point: wheel}");
            let found = told(&stops, &[&names[..], &["phi", "t", "omega"]].concat());
            all_near(&found[..5], &expected, 1e-13);
            all_near(&found[5..], &[450.0 / alpha, 30.0 / alpha, 0.0], 1e-13);
            let slower = corner(shape, [one, two], wall, spin, "{time: {of: wheel, is: 0.4 s}}");
            all_near(&told(&slower, &["omega"]), &[30.0 - 0.4 * alpha], 1e-13);
            let turned = 2.0 * std::f64::consts::PI;
            let way = format!("{{angle: {{of: wheel, reaches: {:?} deg}}}}", -360.0 * side);
            let square = 900.0 - 2.0 * alpha * turned;
            let turns = corner(shape, [one, two], wall, spin, &way);
            all_near(&told(&turns, &["omega", "t"]), &[square.sqrt(), (30.0 - square.sqrt()) / alpha], 1e-12);
        }
    }
}

/// It spins away from the wall: then it does not stay in the corner.
#[test]
fn a_wheel_that_spins_out_of_a_corner() {
    for end in ["at once", "{turning point: wheel}"] {
        let bank = constants(&corner("disc", [0.2, 0.3], "left", -30.0, end));
        let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]).unwrap();
        let off = |c: &slipstick::solve::outcome::Check| c.kind == CheckKind::Pressed && !c.ok;
        assert!(solved.checks.iter().any(off), "{:?}", solved.checks);
    }
}

/// In a corner whose floor and wall are stiff springs, step by step: it comes to rest after as many turns.
#[test]
fn a_corner_of_stiff_springs() {
    let (mass, radius, [one, two]) = (7.0, 0.25, [0.3, 0.4]);
    let inertia = 0.5 * mass * radius * radius;
    let (stiff, damped, h) = (4e5, 2e3, 1e-5);
    // Places over the floor and from the wall on the left, velocities, and the turn.
    let (mut at, mut v) = ([radius - 1e-4; 2], [0.0; 2]);
    let (mut turn, mut spin, mut time) = (0.0, 20.0, 0.0);
    let [mut pressed, mut steps] = [0.0; 2];
    while spin > 0.0 {
        let press = |i: usize| f64::max(0.0, stiff * (radius - at[i]) - damped * v[i]);
        let (floor, wall) = (press(0), press(1));
        // Its lowest point goes to the right, that at the wall down.
        let slides = [v[1] + radius * spin, v[0] - radius * spin].map(f64::signum);
        let (rub, lift) = (one * floor * slides[0], -two * wall * slides[1]);
        v[0] += h * ((floor + lift) / mass - G);
        v[1] += h * (wall - rub) / mass;
        spin -= h * radius * (rub + lift) / inertia;
        at = [at[0] + h * v[0], at[1] + h * v[1]];
        (turn, time, pressed, steps) = (turn + h * spin, time + h, pressed + floor, steps + 1.0);
    }
    let end = "{turning point: wheel}";
    let found = told(&corner("disc", [one, two], "left", 20.0, end), &["phi", "t", "floor.normal"]);
    all_near(&found, &[turn, time, pressed / steps], 2e-3);
}

/// A wheel on a floor whose axle a light link holds: `N + T sin = m g`, `T cos = mu N`.
#[test]
fn a_wheel_that_a_link_holds() {
    let (mass, radius, mu) = (12.0, 0.3, 0.25);
    for (spin, far) in [(25.0, [0.6, 0.8]), (-25.0, [-0.6, 0.8]), (-25.0, [0.6, 0.1])] {
        let [x, y]: [f64; 2] = far;
        let rod = if spin * x > 0.0 { "ties" } else { "links" };
        let length = x.hypot(y - radius);
        let (c, s) = (x / length, (y - radius) / length);
        // Friction against the slip, to the left where it spins counter-clockwise.
        let side = -f64::signum(spin);
        // T c + side mu N = 0, N = m g - T s
        let tension = -side * mu * mass * G / (c - side * mu * s);
        let normal = mass * G - tension * s;
        let alpha = side * mu * normal * radius / (0.5 * mass * radius * radius);
        let text = |end: &str| {
            format!(
                "
bodies: {{wheel: {{mass: 12 kg, shape: {{disc: 0.3 m}}, moves: in the plane, placed: [0 m, 0.3 m]}}}}
joints:
  floor: {{slides: wheel, radius: 0.3 m, along: horizontal, mu_k: 0.25}}
  link:  {{{rod}: wheel, to: [{x:?} m, {y:?} m]}}
start: {{wheel: {{spin: {spin:?} rad/s}}}}
end: {end}
"
            )
        };
        let names = ["alpha", "link.tension", "floor.normal", "floor.friction"];
        let expected = [alpha, tension, normal, side * mu * normal];
        all_near(&told(&text("at once"), &names), &expected, 1e-13);
        let found = told(&text("{turning point: wheel}"), &[&names[..], &["phi", "t"]].concat());
        all_near(&found[..4], &expected, 1e-12);
        all_near(&found[4..], &[312.5 / alpha.abs(), 25.0 / alpha.abs()], 1e-12);
    }
}

/// A wheel that rests against a wall, its axle held by a rod with a mass: the moments about the pin of the rod, and the wheel's own.
#[test]
fn a_wheel_against_a_wall_on_a_rod() {
    let (mass, radius, mu, own, long, out) = (10.0, 0.3, 0.35, 4.0, 0.9, 0.3);
    let up = f64::sqrt(long * long - out * out);
    for spin in [40.0, -40.0] {
        // At the wall on its left the rim goes down where it turns counter-clockwise: friction lifts it.
        let side = f64::signum(spin);
        // The wheel: X + N = 0, Y + side mu N = m g. The rod, about its pin at (0, up + 1), its end at (out, 1): the wheel pulls it by (-X, -Y).
        // (out, -up) x (-X, -Y) - out/2 own g = 0
        let normal = (out * mass * G + 0.5 * out * own * G) / (up + out * side * mu);
        let alpha = -side * mu * normal * radius / (0.5 * mass * radius * radius);
        let text = format!(
            "
bodies:
  rod:   {{mass: 4 kg, shape: {{rod: 0.9 m}}, moves: in the plane, side: ahead}}
  wheel: {{mass: 10 kg, shape: {{disc: 0.3 m}}, moves: in the plane}}
joints:
  pin:  {{pins: rod.A, at: [0 m, {:?} m]}}
  axle: {{hinges: [rod.B, wheel]}}
  wall: {{slides: wheel, radius: 0.3 m, along: -90 deg, mu_k: 0.35}}
start: {{wheel: {{spin: {spin:?} rad/s}}}}
end: {{turning point: wheel}}
",
            1.0 + up
        );
        let names = ["wheel.alpha", "wall.normal", "axle.pin_x", "axle.pin_y", "wheel.phi", "rod.omega"];
        let lifts = mass * G - side * mu * normal;
        let expected = [alpha, normal, normal, -lifts, 800.0 / alpha.abs(), 0.0];
        all_near(&told(&text, &names), &expected, 1e-12);
    }
}

/// A drum under a shoe on a lever: `N (a -+ mu b) = P L + m g l/2`, the way round that helps to press and the other.
#[test]
fn a_drum_that_a_lever_brakes() {
    let text = |spin: f64, mu: f64, end: &str| {
        format!(
            "
bodies:
  drum:  {{mass: 20 kg, shape: {{disc: 0.25 m}}, moves: in the plane}}
  lever: {{mass: 2 kg, shape: {{rod: 0.9 m}}, moves: in the plane, points: {{A: 0 m, C: [0.4 m, -0.05 m], B: 0.9 m}}, side: ahead}}
joints:
  axle:  {{pins: drum}}
  pivot: {{pins: lever.A, at: [-0.4 m, 0.3 m]}}
  shoe:  {{slides: lever.C, outside: 0.25 m, on: drum, mu_k: {mu:?}}}
forces: [force: {{on: lever.B, magnitude: 80 N, direction: down}}]
start: {{drum: {{spin: {spin:?} rad/s}}}}
end: {end}
"
        )
    };
    for spin in [40.0, -40.0] {
        let side = f64::signum(spin);
        let normal = (80.0 * 0.9 + 2.0 * G * 0.45) / (0.4 - side * 0.3 * 0.05);
        let friction = 0.3 * normal;
        let alpha = -side * friction * 0.25 / (0.5 * 20.0 * 0.0625);
        let names = ["drum.alpha", "shoe.normal", "shoe.friction", "axle.pin_x", "axle.pin_y", "pivot.pin_y"];
        let pins = [-side * friction, 20.0 * G + normal, 80.0 + 2.0 * G - normal];
        let expected = [alpha, normal, -side * friction, pins[0], pins[1], pins[2]];
        all_near(&told(&text(spin, 0.3, "at once"), &names), &expected, 1e-12);
        let end = "{turning point: drum}";
        let found = told(&text(spin, 0.3, end), &["drum.phi", "t", "lever.omega"]);
        all_near(&found, &[800.0 / alpha.abs(), 40.0 / alpha.abs(), 0.0], 1e-12);
    }
    // With mu above a/b the shoe locks by itself: no normal force fits, and none is published.
    let bank = constants(&text(40.0, 9.0, "at once"));
    let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]);
    assert!(matches!(solved, Err(Refusal::Friction(2, Lacks::Grip))), "{solved:?}");
}

/// What turns under a shoe hangs on a pin at the axis of the rim.
/// Where friction alone decides whether a wheel on a rod presses, it jams or comes off: `N (1 - mu tan) = m g - P`, by moments about
/// the pin of the rod, has a solution that presses though the wheel is lifted, or none though it is heavy.
#[test]
fn a_wheel_that_jams_is_refused() {
    let text = |lift: f64, mu: f64, spin: f64| {
        format!(
            "
bodies: {{disc: {{mass: 5 kg, shape: {{disc: 0.1 m}}, moves: in the plane, placed: [0 m, 0.1 m]}}}}
joints:
  floor: {{slides: disc, radius: 0.1 m, along: horizontal, mu_k: {mu:?}}}
  link:  {{links: disc, to: [-0.3 m, 0.7 m]}}
forces: [force: {{on: disc, magnitude: {lift:?} N, direction: up}}]
start: {{disc: {{spin: {spin:?} rad/s}}}}
end: at once
"
        )
    };
    let normal = |lift: f64, mu: f64, spin: f64| {
        let bank = constants(&text(lift, mu, spin));
        let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]);
        solved.map(|solved| {
            solved.entries.iter().find(|e| e.label.quantity == Quantity::Normal).map(Entry::value)
        })
    };
    // The rod leads up to the left with the slope 2.
    for (lift, spin) in [(70.0, 30.0), (70.0, -30.0), (20.0, 30.0), (20.0, -30.0)] {
        for mu in [0.3, 0.45, 0.55, 0.8] {
            let by_hand = (5.0 * G - lift) / (1.0 - f64::signum(spin) * 2.0 * mu);
            match normal(lift, mu, spin) {
                Ok(found) => {
                    assert!((found.unwrap() / by_hand - 1.0).abs() < 1e-12, "{lift} {mu} {spin}: {found:?}");
                    assert!(spin < 0.0 || mu < 0.5, "{lift} {mu} {spin} jams");
                }
                Err(why) => {
                    assert!(matches!(why, Refusal::Friction(0, Lacks::Grip)), "{lift} {mu} {spin}: {why:?}");
                    assert!(spin > 0.0 && mu > 0.5, "{lift} {mu} {spin} does not jam");
                }
            }
        }
    }
}

#[test]
fn a_drum_hangs_on_a_pin_at_its_axis() {
    let text = "
bodies:
  drum:  {mass: 20 kg, shape: {disc: 0.25 m}, moves: in the plane}
  lever: {mass: 2 kg, shape: {rod: 0.9 m}, moves: in the plane}
joints:
  axle:  {pins: drum, at: [0.1 m, 0 m]}
  pivot: {pins: lever.A, at: [-0.4 m, 0.3 m]}
  shoe:  {slides: lever.B, outside: 0.25 m, on: drum, mu_k: 0.2}
start: {drum: {spin: 4 rad/s}}
end: at once
";
    let found = crate::joined::read(text).unwrap_err();
    assert!(found.iter().any(|f| f.to_string().contains("no pin holds that body at the axis")), "{found:?}");
    let rolls = "shoe:  {rolls: lever.B, radius: 0.1 m, outside: 0.25 m, on: drum}";
    let found = crate::joined::read(
        &text.replace("shoe:  {slides: lever.B, outside: 0.25 m, on: drum, mu_k: 0.2}", rolls),
    );
    let found = found.unwrap_err();
    assert!(found.iter().any(|f| f.to_string().contains("a cylinder that turns is not solved")), "{found:?}");
}

/// A particle on a rough cylinder: `w = (2 g/rho) ((2 mu^2 - 1) cos - 3 mu sin)/(1 + 4 mu^2) + C exp(2 mu phi)`, the square of its rate.
#[test]
fn a_block_on_a_rough_cylinder() {
    let (rho, mu) = (2.0, 0.2_f64);
    let own = |phi: f64| {
        2.0 * G / rho * ((2.0 * mu * mu - 1.0) * phi.cos() - 3.0 * mu * phi.sin()) / (1.0 + 4.0 * mu * mu)
    };
    let text = |end: &str| {
        format!(
            "
bodies: {{block: {{mass: 3 kg, moves: in the plane, angle: from vertical}}}}
joints: {{top: {{slides: block, outside: 2 m, mu_k: 0.2}}}}
start: {{block: {{angle: 25 deg}}}}
end: {end}
"
        )
    };
    let from = 25.0_f64.to_radians();
    let square = |phi: f64| own(phi) - own(from) * (2.0 * mu * (phi - from)).exp();
    let to = 40.0_f64.to_radians();
    let found = told(&text("{angle: {of: block, reaches: 40 deg}}"), &["v", "top.normal", "top.friction"]);
    let normal = 3.0 * (G * to.cos() - rho * square(to));
    all_near(&found, &[rho * square(to).sqrt(), normal, mu * normal], 1e-12);
    let left = told(&text("{leaves: top}"), &["phi"])[0] + from;
    all_near(&[G * left.cos()], &[rho * square(left)], 1e-12);
}

/// From rest, with two freedoms: a wheel that is pulled so hard by its axle that it slips, and one that is not.
#[test]
fn a_wheel_that_is_pulled_slips() {
    let text = |force: f64| {
        format!(
            "
bodies: {{wheel: {{mass: 10 kg, shape: {{disc: 0.3 m}}, moves: in the plane, placed: [0 m, 0.3 m]}}}}
joints: {{floor: {{slides: wheel, radius: 0.3 m, along: horizontal, mu_k: 0.2}}}}
forces: [force: {{on: wheel, magnitude: {force:?} N, direction: right}}]
start: {{wheel: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    let friction = 0.2 * 10.0 * G;
    let found = told(&text(90.0), &["a_x", "alpha", "floor.friction"]);
    all_near(&found, &[(90.0 - friction) / 10.0, -friction * 0.3 / 0.45, -friction], 1e-13);
    // Below 3 mu m g it rolls, which kinetic friction does not tell.
    let bank = constants(&text(50.0));
    let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]);
    assert!(matches!(solved, Err(Refusal::Friction(0, Lacks::Sliding))), "{solved:?}");
}
