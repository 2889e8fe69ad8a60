//! Bodies that are joined in the plane: closed forms, a pendulum in disguise, and a judge in full coordinates that knows no poses.
use crate::support;
use slipstick::bank::{Bank, checks, load};
use slipstick::problem::maker::Maker;
use slipstick::scene::{End, Scene};
use slipstick::solve::agree;
use slipstick::solve::outcome::Solved;
use std::path::Path;

fn bank() -> Bank {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("banks/rods-and-linkages.yaml");
    let text = std::fs::read_to_string(path).unwrap();
    load::scenes_only(&text, "rods-and-linkages.yaml").unwrap_or_else(|found| panic!("{found:?}"))
}

fn scene<'b>(bank: &'b Bank, id: &str) -> (&'b Scene, Vec<String>) {
    let problem = bank.problems.iter().find(|p| p.id == id).unwrap();
    (&problem.cases[0].scene, problem.data.iter().map(|d| d.symbol.clone()).collect())
}

/// The data of a problem by symbol, SI, angles in degrees.
fn data(symbols: &[String], values: &[(&str, f64)]) -> Vec<f64> {
    let of = |s: &String| values.iter().find(|(name, _)| name == s).map_or(9.81, |(_, x)| *x);
    symbols.iter().map(of).collect()
}

fn value(scene: &Scene, solved: &Solved, name: &str) -> f64 {
    let label = checks::label(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let entry = solved.get(label).unwrap_or_else(|| panic!("no {name}"));
    assert!(entry.eom.is_some() && entry.energy.is_some(), "{name}");
    entry.value()
}

fn near(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by * b.abs().max(1e-9), "{a} against {b}");
}

/// A uniform ladder leaves a smooth wall when its top has come down to two thirds of its height; the floor then carries a quarter.
#[test]
fn a_smooth_ladder_leaves_the_wall_at_two_thirds() {
    let bank = bank();
    let (scene, symbols) = scene(&bank, "sliding-ladder");
    for (m, l, theta) in [(10.0, 2.0, 60.0), (8.5, 4.35, 75.0), (21.0, 3.0, 46.0)] {
        let data = data(&symbols, &[("m", m), ("L", l), ("theta0", theta)]);
        let solved = agree::solve(scene, &data).unwrap();
        let height = l / 2.0 * f64::to_radians(theta).sin();
        near(value(scene, &solved, "rise"), -height / 3.0, 1e-13);
        near(value(scene, &solved, "floor.normal"), m * 9.81 / 4.0, 1e-13);
        near(value(scene, &solved, "omega").powi(2), 3.0 * 9.81 * height / 3.0 * 2.0 / (l * l), 1e-13);
    }
}

/// `omega^2 = 12 g (c0 - c) / (L (1 + 3 s^2))` of a rod on a smooth floor, `c` and `s` of its angle to the vertical.
#[test]
fn a_rod_on_a_smooth_floor_sinks_straight_down() {
    let bank = bank();
    let (scene, symbols) = scene(&bank, "rod-on-smooth-floor");
    for (l, from, to) in [(1.0, 5.0, 90.0), (2.3, 33.0, 71.0)] {
        let data = data(&symbols, &[("m", 3.0), ("L", l), ("phi0", from), ("phi1", to)]);
        let solved = agree::solve(scene, &data).unwrap();
        let (s, c) = f64::to_radians(to).sin_cos();
        let square = 12.0 * 9.81 * (f64::to_radians(from).cos() - c) / (l * (1.0 + 3.0 * s * s));
        near(value(scene, &solved, "omega").powi(2), square, 1e-13);
        assert_eq!(value(scene, &solved, "v_x"), 0.0);
        if to == 90.0 {
            near(value(scene, &solved, "floor.normal"), 3.0 * 9.81 / 4.0, 1e-13);
        }
    }
}

/// A uniform rod whose ends are guided by two slots swings as a pendulum of two thirds of its length does: same speed, same time.
#[test]
fn a_trammel_is_a_pendulum() {
    let text = "
bank: t
title: t
problems:
  slots:
    title: t
    data: {m: {name: m, unit: kg, draw: always 3}, L: {name: L, unit: m, draw: always 1.2}, a: {name: a, unit: deg, draw: always 20}, b: {name: b, unit: deg, draw: always 155}}
    scene:
      bodies: {rod: {mass: m, shape: {rod: L}, moves: in the plane, angle: from vertical}}
      joints: {floor: {guides: rod.A, along: horizontal}, wall: {guides: rod.B, along: vertical}}
      start: {rod: {angle: a}}
      end: {angle: {of: rod, reaches: b}}
    questions: {omega: {ask: w}}
  pendulum:
    title: t
    data: {m: {name: m, unit: kg, draw: always 3}, h: {name: L, unit: m, draw: always 0.8}, a: {name: a, unit: deg, draw: always 20}, b: {name: b, unit: deg, draw: always 155}}
    scene:
      bodies: {bob: {mass: m, radius of gyration: 0 m, pinned: {distance: h}, angle: from upright}}
      start: {bob: {angle: a}}
      end: {angle: {of: bob, reaches: b}}
    questions: {omega: {ask: w}}
";
    let bank = load::scenes_only(text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"));
    let [slots, pendulum] = ["slots", "pendulum"].map(|id| {
        let (scene, symbols) = scene(&bank, id);
        let length = if id == "slots" { ("L", 1.2) } else { ("h", 0.8) };
        let data = data(&symbols, &[("m", 3.0), length, ("a", 20.0), ("b", 155.0)]);
        let solved = agree::solve(scene, &data).unwrap();
        ["omega", "t", "alpha"].map(|name| value(scene, &solved, name))
    });
    for (a, b) in slots.into_iter().zip(pendulum) {
        near(a, b, 1e-14);
    }
}

/// A body of 3 kg on a surface: its shape, how it touches, its start and its end.
fn touching(body: &str, joint: &str, start: &str, end: &str) -> Bank {
    let text = format!(
        "
bank: t
title: t
problems:
  p:
    title: t
    data: {{m: {{name: m, unit: kg, draw: always 3}}}}
    scene:
      bodies: {{body: {{mass: m, moves: in the plane, {body}}}}}
      joints: {{surface: {{{joint}}}}}
      start: {{body: {{{start}}}}}
      end: {end}
    questions: {{v: {{ask: v}}}}
"
    );
    load::scenes_only(&text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"))
}

/// Rolling off a cylinder from its top, a body leaves it where `cos = (cos0) 2 / (3 + k^2/c^2)`: disc 4/7, sphere 10/17, hoop 1/2;
/// sliding on a smooth one 2/3.
#[test]
fn bodies_leave_a_cylinder_where_the_books_say() {
    let start = f64::to_radians(1.0).cos();
    for (body, joint, share) in [
        (
            "shape: {disc: 0.2 m}, angle: from vertical",
            "rolls: body, radius: 0.2 m, outside: 0.7 m",
            4.0 / 7.0,
        ),
        (
            "shape: {sphere: 0.2 m}, angle: from vertical",
            "rolls: body, radius: 0.2 m, outside: 0.7 m",
            10.0 / 17.0,
        ),
        ("shape: {hoop: 0.2 m}, angle: from vertical", "rolls: body, radius: 0.2 m, outside: 0.7 m", 0.5),
        ("angle: from vertical", "slides: body, outside: 0.7 m", 2.0 / 3.0),
    ] {
        let bank = touching(body, joint, "angle: 1 deg", "{leaves: surface}");
        let (scene, _) = scene(&bank, "p");
        let solved = agree::solve(scene, &[3.0, 9.81]).unwrap_or_else(|e| panic!("{body}: {e:?}"));
        let turned = f64::to_radians(1.0) + value(scene, &solved, "phi");
        near(turned.cos(), share * start, 1e-13);
        let apart = if body.contains("shape") { 0.9 } else { 0.7 };
        near(value(scene, &solved, "v").powi(2), 9.81 * apart * share * start, 1e-13);
        let friction = if body.contains("disc") { 3.0 * 9.81 * turned.sin() / 3.0 } else { continue };
        near(value(scene, &solved, "surface.friction").abs(), friction, 1e-12);
    }
}

/// Inside a cylinder and on a peg: speeds by energy at the lowest place, and what the surface then carries.
#[test]
fn rolling_inside_a_cylinder_and_on_a_peg() {
    for (body, joint, apart, beta) in [
        (
            "shape: {sphere: 0.2 m}, angle: from hanging",
            "rolls: body, radius: 0.2 m, inside: 0.7 m",
            0.5,
            0.4,
        ),
        ("shape: {hoop: 0.7 m}, angle: from hanging", "rolls: body, radius: 0.7 m, inside: 0.2 m", 0.5, 1.0),
    ] {
        let bank = touching(body, joint, "angle: 60 deg", "{angle: {of: body, reaches: 0 deg}}");
        let (scene, _) = scene(&bank, "p");
        let solved = agree::solve(scene, &[3.0, 9.81]).unwrap_or_else(|e| panic!("{body}: {e:?}"));
        let square = 2.0 * 9.81 * apart * 0.5 / (1.0 + beta);
        near(value(scene, &solved, "v").powi(2), square, 1e-13);
        near(value(scene, &solved, "surface.normal"), 3.0 * (9.81 + square / apart), 1e-13);
        let radius = if body.contains("hoop") { 0.7 } else { 0.2 };
        near(value(scene, &solved, "omega"), square.sqrt() / radius, 1e-13);
    }
}

/// A wheel whose mass centre is off its axle, from its speed at the lowest place to the highest: `T = m v_G^2 / 2 + I_G w^2 / 2` with
/// `v_G = (c -+ e) w`, and the normal force from `a_y` of G.
#[test]
fn an_eccentric_wheel_rolls() {
    let body = "radius of gyration: 0.13 m, mass centre: 0.06 m, angle: from hanging";
    let bank = touching(
        body,
        "rolls: body, radius: 0.2 m, along: horizontal",
        "angle: 0 deg, spin: 9 rad/s",
        "{angle: {of: body, reaches: 180 deg}}",
    );
    let (scene, _) = scene(&bank, "p");
    let solved = agree::solve(scene, &[3.0, 9.81]).unwrap();
    let (c, e, k, w): (f64, f64, f64, f64) = (0.2, 0.06, 0.13, 9.0);
    let low = (c - e).powi(2) + k * k;
    let high = (c + e).powi(2) + k * k;
    let square = (w * w * low - 4.0 * 9.81 * e) / high;
    near(value(scene, &solved, "omega").powi(2), square, 1e-13);
    near(value(scene, &solved, "surface.normal"), 3.0 * (9.81 - e * square), 1e-13);
}

/// A rod of the judge: mass, length; its state is place of the centre and angle counter-clockwise from the right.
#[derive(Clone, Copy)]
struct Rod {
    mass: f64,
    length: f64,
}

/// What a judge holds: an end (-1, 1) of a rod at the ground, or at an end of another rod, or its height alone.
#[derive(Clone, Copy)]
enum Hold {
    Ground(usize, f64),
    Hinge((usize, f64), (usize, f64)),
    Level(usize, f64),
}

/// Accelerations in full coordinates with Lagrange multipliers: `M q'' = Q + G^T lambda`, `G q'' = -G' q'`. `slider` moves with the
/// end that is held level.
fn accelerations(rods: &[Rod], holds: &[Hold], slider: f64, couple: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
    let n = 3 * rods.len();
    let arm = |b: usize, side: f64| {
        let (s, c) = q[3 * b + 2].sin_cos();
        (side * rods[b].length / 2.0 * c, side * rods[b].length / 2.0 * s)
    };
    let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
    let mut put = |ends: &[(usize, f64, f64)], x: bool| {
        let (mut row, mut right) = (vec![0.0; n], 0.0);
        for &(b, side, sign) in ends {
            let ((ax, ay), w) = (arm(b, side), v[3 * b + 2]);
            row[3 * b + usize::from(!x)] += sign;
            row[3 * b + 2] += sign * if x { -ay } else { ax };
            right += sign * w * w * if x { ax } else { ay };
        }
        rows.push((row, right));
    };
    for hold in holds {
        match *hold {
            Hold::Ground(b, side) => [true, false].into_iter().for_each(|x| put(&[(b, side, 1.0)], x)),
            Hold::Hinge((a, s), (b, t)) => {
                [true, false].into_iter().for_each(|x| put(&[(a, s, 1.0), (b, t, -1.0)], x));
            }
            Hold::Level(b, side) => put(&[(b, side, 1.0)], false),
        }
    }
    let m = n + rows.len();
    let mut a = vec![vec![0.0; m + 1]; m];
    for (b, rod) in rods.iter().enumerate() {
        for (i, inertia) in
            [rod.mass, rod.mass, rod.mass * rod.length * rod.length / 12.0].into_iter().enumerate()
        {
            a[3 * b + i][3 * b + i] += inertia;
        }
        a[3 * b + 1][m] -= rod.mass * 9.81;
    }
    a[2][m] += couple;
    if let Some((b, side)) = holds.iter().find_map(|h| match *h {
        Hold::Level(b, side) => Some((b, side)),
        _ => None,
    }) {
        // The slider's inertia at the end that it is hinged to, along the guide: u = (1, -ay).
        let ((ax, ay), w) = (arm(b, side), v[3 * b + 2]);
        let u = [(3 * b, 1.0), (3 * b + 2, -ay)];
        for (i, x) in u {
            for (j, y) in u {
                a[i][j] += slider * x * y;
            }
            a[i][m] += slider * x * w * w * ax;
        }
    }
    for (k, (row, right)) in rows.into_iter().enumerate() {
        for (j, x) in row.into_iter().enumerate() {
            a[n + k][j] = x;
            a[j][n + k] = -x;
        }
        a[n + k][m] = right;
    }
    for i in 0..m {
        let p = (i..m).max_by(|x, y| a[*x][i].abs().total_cmp(&a[*y][i].abs())).unwrap();
        a.swap(i, p);
        let pivot = a[i].clone();
        for (k, row) in a.iter_mut().enumerate().filter(|(k, _)| *k != i) {
            let f = row[i] / pivot[i];
            if f != 0.0 {
                row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= f * y);
            }
            let _ = k;
        }
    }
    (0..n).map(|i| a[i][m] / a[i][i]).collect()
}

/// Follows the rods in time by Runge and Kutta's classic method until the first one stands at `angle`; gives all rates there.
fn judged(rods: &[Rod], holds: &[Hold], slider: f64, couple: f64, start: Vec<f64>, angle: f64) -> Vec<f64> {
    let n = start.len();
    let field = |y: &[f64]| {
        let (q, v) = y.split_at(n);
        [v.to_vec(), accelerations(rods, holds, slider, couple, q, v)].concat()
    };
    let mut y = [start, vec![0.0; n]].concat();
    let side = (angle - y[2]).signum();
    let step = |y: &[f64], h: f64| {
        let add = |k: &[f64], by: f64| y.iter().zip(k).map(|(a, b)| a + by * b).collect::<Vec<f64>>();
        let a = field(y);
        let b = field(&add(&a, h / 2.0));
        let c = field(&add(&b, h / 2.0));
        let d = field(&add(&c, h));
        (0..y.len()).map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])).collect::<Vec<f64>>()
    };
    let h = 2e-4;
    for _ in 0..100_000 {
        let next = step(&y, h);
        if side * (next[2] - angle) >= 0.0 {
            // Onto the angle by secants in the length of the step.
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if side * (step(&y, middle)[2] - angle) >= 0.0 { high = middle } else { low = middle }
            }
            return step(&y, high)[n..].to_vec();
        }
        y = next;
    }
    panic!("the judge does not get there");
}

/// Centre and angle of a rod between two points.
fn between((x, y): (f64, f64), (u, v): (f64, f64)) -> [f64; 3] {
    [(x + u) / 2.0, (y + v) / 2.0, (v - y).atan2(u - x)]
}

#[test]
fn a_slider_crank_moves_as_it_does_in_full_coordinates() {
    let bank = bank();
    let (scene, symbols) = scene(&bank, "slider-crank");
    let (r, l, theta) = (0.2, 0.6, f64::to_radians(20.0));
    let values = [
        ("m1", 2.0),
        ("m2", 3.0),
        ("m3", 1.5),
        ("r", r),
        ("L", l),
        ("M", 15.0),
        ("theta0", 20.0),
        ("theta1", 110.0),
    ];
    let solved = agree::solve(scene, &data(&symbols, &values)).unwrap();
    let crank = (r * theta.cos(), r * theta.sin());
    let piston = (crank.0 + (l * l - crank.1 * crank.1).sqrt(), 0.0);
    let rods = [Rod { mass: 2.0, length: r }, Rod { mass: 3.0, length: l }];
    let holds = [Hold::Ground(0, -1.0), Hold::Hinge((0, 1.0), (1, -1.0)), Hold::Level(1, 1.0)];
    let start = [between((0.0, 0.0), crank), between(crank, piston)].concat();
    let rates = judged(&rods, &holds, 1.5, 15.0, start, f64::to_radians(110.0));
    near(value(scene, &solved, "crank.omega"), rates[2].abs(), 1e-8);
    near(value(scene, &solved, "rod.omega"), rates[5].abs(), 1e-8);
}

#[test]
fn a_four_bar_linkage_moves_as_it_does_in_full_coordinates() {
    let bank = bank();
    let (scene, symbols) = scene(&bank, "four-bar-linkage");
    let (a, b, c, d, theta) = (0.3, 0.7, 0.6, 0.8, f64::to_radians(70.0));
    let values = [
        ("m1", 2.0),
        ("m2", 3.0),
        ("m3", 1.5),
        ("a", a),
        ("b", b),
        ("c", c),
        ("d", d),
        ("theta0", 70.0),
        ("theta1", 25.0),
    ];
    let solved = agree::solve(scene, &data(&symbols, &values)).unwrap();
    let crank = (a * theta.cos(), a * theta.sin());
    // The hinge between coupler and rocker, left of the line from the crank's end to the far pin.
    let (dx, dy) = (d - crank.0, -crank.1);
    let far = dx.hypot(dy);
    let along = (b * b - c * c + far * far) / (2.0 * far);
    let beside = (b * b - along * along).sqrt();
    let hinge = (crank.0 + (along * dx - beside * dy) / far, crank.1 + (along * dy + beside * dx) / far);
    let rods = [Rod { mass: 2.0, length: a }, Rod { mass: 3.0, length: b }, Rod { mass: 1.5, length: c }];
    let holds = [
        Hold::Ground(0, -1.0),
        Hold::Hinge((0, 1.0), (1, -1.0)),
        Hold::Hinge((1, 1.0), (2, 1.0)),
        Hold::Ground(2, -1.0),
    ];
    let start = [between((0.0, 0.0), crank), between(crank, hinge), between((d, 0.0), hinge)].concat();
    let rates = judged(&rods, &holds, 0.0, 0.0, start, f64::to_radians(25.0));
    for (name, rate) in [("crank.omega", rates[2]), ("coupler.omega", rates[5]), ("rocker.omega", rates[8])] {
        near(value(scene, &solved, name), rate.abs(), 1e-8);
    }
}

/// Draws of each problem of the example bank: both roads agree, and where the end is an angle or an instant the key is enclosed.
#[test]
fn draws_of_the_example_bank_are_solved_on_both_roads() {
    let bank = bank();
    for problem in &bank.problems {
        let maker = Maker::new(problem, 3, "joined");
        for student in 0..support::seeds(10_000).div_ceil(1000) {
            let drawn = maker.variant(&student.to_string());
            let variant = drawn.unwrap_or_else(|e| panic!("{}: {e} {:?}", problem.id, e.unsolved));
            let scene = &problem.cases[0].scene;
            for question in &problem.questions {
                let entry = variant.solved.get(question.label).unwrap();
                assert!(entry.eom.is_some() && entry.energy.is_some(), "{} {}", problem.id, question.id);
                let rubs = problem.id == "rough-ladder";
                if matches!(scene.end, End::Angle(..) | End::AtOnce) && !rubs {
                    assert!(entry.bound.is_some(), "{} {}", problem.id, question.id);
                }
            }
        }
    }
}

/// Work and energy know no time: a couple that grows with it is refused, by name and not as an unknown word.
#[test]
fn what_grows_with_time_is_refused_by_name() {
    let text = include_str!("../../banks/rods-and-linkages.yaml");
    let couple = "couple: {on: crank, moment: M}";
    assert!(text.contains(couple));
    let text = text.replace(couple, "couple: {on: crank, moment: M, growing by: 2 N*m/s}");
    let found = load::scenes_only(&text, "growing.yaml").expect_err("a couple that grows");
    let told: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|t| t.contains("no forces that grow with time")), "{told:#?}");
}
