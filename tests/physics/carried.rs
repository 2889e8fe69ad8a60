//! Belts, trucks and lifts that carry a scene, and bodies that rest on wheels, against Newton's law as it is seen from the ground
//! and against the formulas of textbooks, written for this test.
use crate::support;
use slipstick::bank::{Bank, Problem, labels, load};
use slipstick::problem::maker::Maker;
use slipstick::scene::{Carrier, Formulas, Label, Mass, Num, Owner, Quantity, Scene, Slope};
use slipstick::solve::agree;
use slipstick::solve::outcome::Solved;

const G: f64 = 9.81;

fn scene_file(name: &str) -> Bank {
    let path = format!("{}/tests/carried/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("a scene file");
    bank(&text)
}

fn bank(text: &str) -> Bank {
    load::scenes_only(text, "carried.yaml").unwrap_or_else(|found| {
        let lines: Vec<String> = found.iter().map(ToString::to_string).collect();
        panic!("{}", lines.join("\n"))
    })
}

/// Solves a problem with these values in SI (angles in degrees), g last; both roads are held against what is expected.
fn hold(problem: &Problem, data: &[f64], expected: &[(&str, f64)]) -> Solved {
    let scene = &problem.cases[0].scene;
    let mut solved = agree::solve(scene, data).unwrap_or_else(|e| panic!("{} {data:?}: {e:?}", problem.id));
    for (name, value) in expected {
        let label = labels::named(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let entry = solved.get(label).unwrap_or_else(|| panic!("{}: no {name}", problem.id));
        for (road, found) in [("eom", entry.eom), ("energy", entry.energy)] {
            let Some(found) = found.map(|found| scene.as_asked(label, found)) else { continue };
            let size = value.abs().max(entry.scale).max(1e-9);
            assert!(
                (found - value).abs() <= 1e-9 * size,
                "{name} {road}: {found}, expected {value} ({data:?})"
            );
        }
    }
    // What is published is enclosed, wherever no search comes in.
    agree::prove(scene, data, &mut solved);
    solved
}

fn file(name: &str, expected: impl FnOnce(&[f64]) -> Vec<(&'static str, f64)>) -> Solved {
    let bank = scene_file(name);
    let problem = &bank.problems[0];
    let data = support::data(problem);
    hold(problem, &data, &expected(&data))
}

/// Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, problems of chapter 16 on a sphere placed on a belt:
/// t = 2 v/(7 mu g), v/7 * 2 and 5 v/(7 r).
#[test]
fn a_sphere_that_is_set_down_on_a_belt() {
    file("sphere-set-on-a-belt", |d| {
        let [m, r, u, _, mu, g] = d.try_into().unwrap();
        let (t, v): (f64, f64) = (2.0 * u / (7.0 * mu * g), 2.0 * u / 7.0);
        let mark = u * t / 2.0;
        vec![
            ("t", t),
            ("v", v),
            ("omega", 5.0 * u / (7.0 * r)),
            ("displacement", v * t / 2.0),
            ("slip_distance", mark),
            ("heat", mu * m * g * mark),
            ("a", mu * g),
            ("kinetic_energy", 0.5 * m * v * v + 0.2 * m * (5.0 * u / 7.0) * (5.0 * u / 7.0)),
        ]
    });
}

#[test]
fn a_crate_that_is_set_down_on_a_sloping_belt() {
    file("crate-set-on-a-sloping-belt", |d| {
        let [m, theta, u, mu, g] = d.try_into().unwrap();
        let (s, c) = f64::to_radians(theta).sin_cos();
        let a = g * (mu * c - s);
        let (t, way) = (u / a, u * u / (2.0 * a));
        vec![
            ("a", a),
            ("t", t),
            ("v", u),
            ("displacement", way),
            ("slip_distance", u * t - way),
            ("heat", mu * m * g * c * (u * t - way)),
            ("kinetic_energy", 0.5 * m * u * u),
            ("work", 0.5 * m * u * u),
            ("drive", mu * m * g * c * u * t),
        ]
    });
}

/// A uniform cylinder on an accelerating plate: its centre takes a third of the acceleration.
#[test]
fn a_cylinder_that_rolls_back_on_a_truck() {
    file("cylinder-on-a-truck", |d| {
        let [m, r, a, way, _, g] = d.try_into().unwrap();
        let t = f64::sqrt(2.0 * way / (2.0 * a / 3.0));
        let v = a / 3.0 * t;
        let energy = 0.5 * m * v * v + 0.25 * m * (2.0 * v) * (2.0 * v);
        vec![
            ("a", a / 3.0),
            ("alpha", -2.0 * a / (3.0 * r)),
            ("friction", m * a / 3.0),
            ("mu_required", a / (3.0 * g)),
            ("t", t),
            ("v", v),
            ("displacement", way / 2.0),
            ("kinetic_energy", energy),
            ("work", energy),
            ("truck", 1.5 * way),
        ]
    });
}

#[test]
fn loads_in_a_lift_feel_more_than_their_weight() {
    file("loads-in-a-lift", |d| {
        let [m1, m2, pulley, _, lift, g] = d.try_into().unwrap();
        let felt: f64 = g + lift;
        let a = (m1 - m2) * felt / (m1 + m2 + pulley / 2.0);
        vec![
            ("one.a", a - lift),
            ("other.a", a + lift),
            ("left.tension", m1 * (felt - a)),
            ("right.tension", m2 * (felt + a)),
        ]
    });
}

#[test]
fn a_crate_on_a_truck_that_brakes_presses_more_on_its_front_edge() {
    file("crate-that-tips-on-a-truck", |d| {
        let [m, h, b, brake, g] = d.try_into().unwrap();
        let behind = m * (g * b / 2.0 - brake * h / 2.0) / b;
        vec![("A.normal", behind), ("B.pin_x", -m * brake), ("B.pin_y", m * g - behind), ("a_x", -brake)]
    });
}

#[test]
fn a_rod_in_a_truck_hangs_aslant_and_swings_faster() {
    file("pendulum-in-a-truck", |d| {
        let [m, long, a, _, g] = d.try_into().unwrap();
        let felt = f64::hypot(g, a);
        let period = std::f64::consts::TAU * f64::sqrt(2.0 * long / (3.0 * felt));
        vec![("phi", f64::atan2(a, g)), ("period_small", period), ("O.pin_force", m * felt)]
    });
}

#[test]
fn a_plank_goes_twice_as_fast_as_its_rollers() {
    file("plank-on-two-rollers", |d| {
        let [plank, m, r, pull, way, _] = d.try_into().unwrap();
        let a = pull / (plank + 0.75 * m);
        let v = f64::sqrt(2.0 * a * way);
        let roller = a / 2.0;
        // Moments about the top and about the ground: the two forces of a roller.
        let above = 0.75 * m * roller;
        let below = m * roller - above;
        vec![
            ("plank.a", a),
            ("plank.v", v),
            ("front.v", v / 2.0),
            ("front.omega", v / (2.0 * r)),
            ("front.rim_force", above),
            ("front.friction", below),
            ("plank.normal", plank * G),
        ]
    });
}

#[test]
fn a_cart_feels_the_turning_of_its_wheels() {
    file("cart-on-wheels", |d| {
        let [cart, m, _, theta, way, g] = d.try_into().unwrap();
        let pull = g * f64::to_radians(theta).sin();
        let a = pull * (cart + 2.0 * m) / (cart + 3.0 * m);
        vec![
            ("cart.a", a),
            ("cart.v", f64::sqrt(2.0 * a * way)),
            ("front.rim_force", (m * pull - 1.5 * m * a).abs()),
            ("front.friction", 0.5 * m * a),
        ]
    });
}

/// A round body that slips, then rolls, on a surface that is carried along another line, as it is seen from the ground.
struct Ground {
    mass: f64,
    radius: f64,
    inertia: f64,
    mu: f64,
    slope: f64,
    /// Along the surface and out of it: speed and acceleration of the carrier.
    along: (f64, f64),
    out: (f64, f64),
}

impl Ground {
    /// Speed, spin, way along the surface and kinetic energy after a time; `None` where the slip ends near it or goes on. The speed is
    /// that of the centre, also where it is carried out of the surface.
    fn after(&self, (mut v, mut w): (f64, f64), time: f64) -> Option<[f64; 4]> {
        let (sine, cosine) = self.slope.sin_cos();
        let normal = self.mass * (G * cosine + self.out.1);
        if normal < 0.05 * self.mass * G {
            return None;
        }
        let slip = v - self.along.0 - self.radius * w;
        let rates = |friction: f64| (friction / self.mass - G * sine, -friction * self.radius / self.inertia);
        // Rolling: the contact has the acceleration of the surface.
        let felt = 1.0 / self.mass + self.radius * self.radius / self.inertia;
        let needed = (self.along.1 + G * sine) / felt;
        let (a, alpha) = rates(-slip.signum() * self.mu * normal);
        let closing = -slip.signum() * (a - self.along.1 - self.radius * alpha);
        let until = if closing > 0.0 { slip.abs() / closing } else { f64::INFINITY };
        if (until - time).abs() < 0.05 * time || until < time && needed.abs() > 0.95 * self.mu * normal {
            return None;
        }
        let first = until.min(time);
        let mut x = v * first + 0.5 * a * first * first;
        (v, w) = (v + a * first, w + alpha * first);
        if until < time {
            let (a, alpha) = rates(needed);
            let rest = time - until;
            x += v * rest + 0.5 * a * rest * rest;
            (v, w) = (v + a * rest, w + alpha * rest);
        }
        let out = self.out.0 + self.out.1 * time;
        let speed = v.hypot(out);
        Some([speed, w, x, 0.5 * self.mass * speed * speed + 0.5 * self.inertia * w * w])
    }
}

const DISC: &str = "bank: disc
title: A disc
problems:
  disc:
    title: A disc
    data:
      m:     {name: mass, unit: kg, draw: 1 to 9 step 1}
      r:     {name: radius, unit: m, draw: 0.1 to 0.9 step 0.1}
      theta: {name: slope, unit: deg, draw: 1 to 60 step 1}
      u:     {name: speed, unit: m/s, draw: 1 to 9 step 1}
      A:     {name: acceleration, unit: m/s^2, draw: 1 to 9 step 1}
      mu:    {name: coefficient, unit: '1', draw: 0.1 to 0.9 step 0.1}
      v0:    {name: speed, unit: m/s, draw: 1 to 9 step 1}
      w0:    {name: spin, unit: rad/s, draw: 1 to 9 step 1}
      t1:    {name: time, unit: s, draw: 1 to 9 step 1}
    scene:
      surfaces: {belt: {slope: theta}}
      carried: {along: LINE, speed: u, acceleration: A}
      bodies: {disc: {mass: m, shape: {disc: r}, moves: along belt, positive: SENSE}}
      ties: [slips: {body: disc, on its: rim, mu_s: mu, mu_k: mu}]
      start: {disc: {speed: v0, spin: w0}}
      end: {time: {of: disc, is: t1}}
    questions: {v: {ask: the speed}}
";

/// The fraction of the n-th multiple of an irrational number: evenly spread.
fn spread(n: usize, by: f64) -> f64 {
    (n as f64 * by).fract()
}

#[test]
fn what_is_carried_moves_as_it_is_seen_from_the_ground() {
    let mut compared = [0; 2];
    for line in ["belt", "horizontal", "vertical"] {
        for sense in ["up", "down"] {
            let bank = bank(&DISC.replace("LINE", line).replace("SENSE", sense));
            for n in 1..400 {
                let x = |by: f64, low: f64, high: f64| low + (high - low) * spread(n, by);
                let (m, r, theta) = (x(0.618, 1.0, 9.0), x(0.414, 0.1, 0.9), x(0.732, 0.0, 60.0));
                let (u, a) = (x(0.236, -4.0, 4.0), x(0.302, -5.0, 5.0));
                let (mu, t1) = (x(0.162, 0.1, 1.2), x(0.872, 0.1, 2.0));
                let (v0, w0) = (x(0.541, -4.0, 4.0), x(0.317, -9.0, 9.0));
                let slope = theta.to_radians();
                let (along, out) = match line {
                    "belt" => (1.0, 0.0),
                    "horizontal" => (slope.cos(), -slope.sin()),
                    _ => (slope.sin(), slope.cos()),
                };
                let ground = Ground {
                    mass: m,
                    radius: r,
                    inertia: 0.5 * m * r * r,
                    mu,
                    slope,
                    along: (u * along, a * along),
                    out: (u * out, a * out),
                };
                let up = if sense == "up" { 1.0 } else { -1.0 };
                let Some([v, w, way, energy]) = ground.after((up * v0, up * w0), t1) else { continue };
                compared[usize::from(line == "belt")] += 1;
                let expected =
                    [("v", v), ("omega", w.abs()), ("displacement", up * way), ("kinetic_energy", energy)];
                hold(&bank.problems[0], &[m, r, theta, u, a, mu, v0, w0, t1, G], &expected);
            }
        }
    }
    assert!(compared.iter().all(|n| *n > 200), "{compared:?}");
}

/// Whatever stands in a lift feels a stronger or weaker gravity: every scene of the built-in banks in both.
#[test]
fn a_lift_is_another_gravity() {
    let lift = 1.7;
    let (mut compared, mut scenes) = (0, 0);
    for bank in support::banks() {
        for problem in &bank.problems {
            let Ok(variant) = Maker::new(problem, 7, "lift").variant("1") else { continue };
            let scene = &problem.cases[variant.case].scene;
            // A mass by its weight is another one; a pin of its own and a measurement are not carried; where no weight acts
            // there is none to be stronger.
            let weighed = scene.bodies.iter().any(|b| matches!(b.mass, Mass::Weight(_)));
            let other =
                scene.pinned().is_some() || scene.formulas.found.is_some() || scene.drifts().is_some();
            let particles = scene.bodies.iter().any(|b| !b.particles.is_empty());
            if weighed || other || particles || scene.lies_level() {
                continue;
            }
            let carrier = Carrier {
                slope: Slope::Vertical,
                speed_m_s: Num::Fixed(0.0),
                acceleration_m_s2: Num::Fixed(lift),
            };
            let carried = Scene {
                carried: Some(carrier),
                formulas: Formulas { asked: Vec::new(), others: Vec::new(), ..scene.formulas.clone() },
                ..scene.clone()
            };
            let heavy = Scene { carried: None, ..carried.clone() };
            let mut data = variant.data.clone();
            let g = data.len() - 1;
            let own = agree::solve(&carried, &data);
            data[g] += lift;
            let (own, heavy_one) = match (own, agree::solve(&heavy, &data)) {
                (Ok(own), Ok(heavy)) => (own, heavy),
                (own, heavy) => {
                    assert_eq!(own.is_ok(), heavy.is_ok(), "{}: {own:?} {heavy:?}", problem.id);
                    continue;
                }
            };
            scenes += 1;
            assert_eq!(own.regime, heavy_one.regime, "{}", problem.id);
            for entry in &own.entries {
                let Label { quantity, of } = entry.label;
                let along = match of {
                    Owner::Body(b) => carried.bodies[b].line,
                    _ => None,
                };
                let up = along.map_or(0.0, |line| {
                    let steep: f64 = match line.slope {
                        Slope::Level => 0.0,
                        Slope::Vertical => 1.0,
                        Slope::Degrees(n) => carried.value(n, &variant.data).to_radians().sin(),
                    };
                    if line.forward_up { steep } else { -steep }
                });
                let with = match quantity {
                    Quantity::A | Quantity::ARolling => lift * up,
                    Quantity::AY => lift,
                    Quantity::V | Quantity::Displacement | Quantity::KineticEnergy | Quantity::Work => {
                        continue;
                    }
                    _ => 0.0,
                };
                let there =
                    heavy_one.get(entry.label).unwrap_or_else(|| panic!("{}: {:?}", problem.id, entry.label));
                let expected = there.value() + with;
                let size = expected.abs().max(there.scale).max(entry.scale);
                let near = (entry.value() - expected).abs() <= 1e-9 * size * there.cond.clamp(1.0, 1e3);
                assert!(near, "{} {:?}: {}, {expected}", problem.id, entry.label, entry.value());
                compared += 1;
            }
        }
    }
    assert!(scenes > 15 && compared > 150, "{scenes} scenes, {compared} answers");
}

/// A scene of constants, with the questions of its only quantity.
fn constants(data: &[(&str, &str, f64)], scene: &str, question: &str) -> Bank {
    let data: Vec<String> = data
        .iter()
        .map(|(symbol, unit, value)| {
            format!("{symbol}: {{name: {symbol}, unit: '{unit}', draw: always {value}}}")
        })
        .collect();
    let data = data.join(", ");
    bank(&format!(
        "bank: b\ntitle: b\nproblems:\n  p:\n    title: p\n    data: {{{data}}}\n    scene:\n{scene}\n    questions: {{q: {{quantity: {question}, ask: q}}}}\n"
    ))
}

/// What lies on the bed of a truck and is not held there: it slides with the acceleration that friction gives it.
#[test]
fn on_a_truck_that_starts_too_fast_everything_slides_back() {
    let (truck, mu, way): (f64, f64, f64) = (6.0, 0.3, 2.0);
    let data = [("m", "kg", 5.0), ("r", "m", 0.2), ("A", "m/s^2", truck), ("mu", "1", mu), ("d", "m", way)];
    let time = f64::sqrt(2.0 * way / (truck - mu * G));
    let alike = [("t", time), ("v", mu * G * time), ("a", mu * G), ("friction", 5.0 * mu * G)];
    let disc = constants(
        &data,
        "      surfaces: {bed: level}
      carried: {along: bed, acceleration: A}
      bodies: {load: {mass: m, shape: {disc: r}, moves: along bed}}
      ties: [slips: {body: load, on its: rim, mu_s: mu, mu_k: mu}]
      start: at rest
      end: {travel: {of: load, by: d}}",
        "t",
    );
    // At 6 m/s^2 rolling takes a third of m A, which this friction gives: it is said to slip and does not.
    let rolls = agree::solve(&disc.problems[0].cases[0].scene, &[5.0, 0.2, truck, mu, way, G]).unwrap();
    assert!(!rolls.all_hold());
    // At 12 m/s^2 it slips, and friction turns it along.
    let (fast, alpha) = (12.0, mu * G * 0.2 / (0.5 * 0.04));
    let longer = f64::sqrt(2.0 * way / (fast - mu * G));
    let slips = [
        ("t", longer),
        ("omega", alpha * longer),
        ("slip_distance", way - 0.2 * alpha * longer * longer / 2.0),
        ("a", mu * G),
        ("alpha", -alpha),
        ("displacement", mu * G * longer * longer / 2.0),
    ];
    let solved = hold(&disc.problems[0], &[5.0, 0.2, fast, mu, way, G], &slips);
    assert_eq!(solved.regime.word(), "slips_back");
    let slab = constants(
        &[data[0], data[2], data[3], data[4]],
        "      surfaces: {bed: level}
      carried: {along: bed, acceleration: A}
      bodies: {load: {mass: m, moves: along bed}}
      ties: [slides: {body: load, mu_s: mu, mu_k: mu}]
      start: at rest
      end: {travel: {of: load, by: d}}",
        "t",
    );
    let solved = hold(&slab.problems[0], &[5.0, truck, mu, way, G], &alike);
    assert_eq!(solved.regime.word(), "moves_back");
    // Below mu g it stays, and friction takes it along.
    let slow = hold(&slab.problems[0], &[5.0, 2.0, mu, way, G], &[("a", 2.0), ("friction", 10.0)]);
    assert_eq!(slow.regime.word(), "balanced");
}

/// A truck that brakes: what lies on it slides forward until it meets the cab.
#[test]
fn on_a_truck_that_brakes_a_crate_slides_forward() {
    let (speed, brake, mu, way): (f64, f64, f64, f64) = (20.0, 7.0, 0.4, 1.5);
    let crate_bank = constants(
        &[("m", "kg", 50.0), ("u", "m/s", speed), ("A", "m/s^2", brake), ("mu", "1", mu), ("d", "m", way)],
        "      surfaces: {bed: level}
      carried: {along: bed, speed: u, acceleration: -A}
      bodies: {load: {mass: m, moves: along bed}}
      ties: [slides: {body: load, mu_k: mu}]
      start: {load: {speed: u}}
      end: {travel: {of: load, by: d}}",
        "t",
    );
    let time = f64::sqrt(2.0 * way / (brake - mu * G));
    let v = speed - mu * G * time;
    let expected = [
        ("t", time),
        ("v", v),
        ("displacement", speed * time - mu * G * time * time / 2.0),
        ("slip_distance", way),
        ("work", 25.0 * (v * v - speed * speed)),
    ];
    hold(&crate_bank.problems[0], &[50.0, speed, brake, mu, way, G], &expected);
}

/// A slab slides down over rollers that turn about fixed axles, each with the half of its mass at its rim.
#[test]
fn rollers_on_fixed_axles_hold_a_slab_back() {
    let slab = constants(
        &[("M", "kg", 20.0), ("m", "kg", 6.0), ("r", "m", 0.1), ("theta", "deg", 20.0), ("d", "m", 0.4)],
        "      surfaces: {ramp: {slope: theta}}
      bodies:
        slab: {mass: M, moves: along ramp, positive: down}
        one: {mass: m, shape: {disc: r}, moves: about a fixed axle}
        other: {mass: m, shape: {disc: r}, moves: about a fixed axle}
      ties: [rests: {body: slab, on: [one.rim, other.rim]}]
      start: at rest
      end: {travel: {of: slab, by: d, heading: down}}",
        "t",
    );
    let a = 20.0 * G * f64::to_radians(20.0).sin() / 26.0;
    let expected =
        [("slab.a", a), ("one.alpha", -a / 0.1), ("other.rim_force", 3.0 * a), ("t", f64::sqrt(0.8 / a))];
    hold(&slab.problems[0], &[20.0, 6.0, 0.1, 20.0, 0.4, G], &expected);
}

/// What is asked of a scene that cannot be answered is refused by name.
#[test]
fn what_is_not_told_of_what_is_carried_is_refused() {
    let crate_file = include_str!("../carried/crate-set-on-a-sloping-belt.yaml");
    let plank = include_str!("../carried/plank-on-two-rollers.yaml");
    let rod = include_str!("../carried/pendulum-in-a-truck.yaml");
    let pinned = rod.replace("moves: in the plane, angle", "pinned: at its end, angle");
    let pinned = pinned.replace("      joints: {O: {pins: rod.A}}\n", "").replace("equilibrium", "at once");
    let pinned = pinned.replace("phi: {", "alpha: {").replace("O.pin_force", "pin_force");
    for (text, old, new, message) in [
        (
            crate_file,
            "start: {crate: {speed: 0 m/s}}",
            "start: at rest",
            "at rest on the ground, or on what carries",
        ),
        (
            crate_file,
            "{stops slipping: crate}",
            "{speed: {of: crate, reaches: u}}",
            "does not end at a speed",
        ),
        (
            crate_file,
            "along: belt, speed: u}",
            "along: road, speed: u}",
            "along which line the scene is carried",
        ),
        (crate_file, ", speed: u}", "}", "neither a speed nor an acceleration"),
        (crate_file, "a: {ask: the acc", "distance: {ask: the acc", "`distance` does not exist"),
        (rod, "acceleration: A}", "speed: 1 m/s, acceleration: A}", "the acceleration alone counts"),
        (&pinned, "acceleration: A}", "acceleration: A }", "is pinned, and the scene is carried"),
        (
            plank,
            "front, on its: rim}",
            "front, on its: rim, mu_s: 0.3}",
            "friction limits are not told of `front`",
        ),
        (plank, "[front.rim, rear.rim]", "[front.rim, front.rim]", "rests on `front` twice"),
        (plank, "[front.rim, rear.rim]", "[front.top]", "expected the rim or the axle of a wheel"),
        (plank, "{quantity: front.friction", "{quantity: front.normal", "`front.normal` does not exist"),
        (plank, "plank: {mass: M, m", "plank: {mass: M, shape: {disc: r}, m", "cannot rest on wheels"),
    ] {
        assert!(text.contains(old), "{old}");
        let found = load::scenes_only(&text.replacen(old, new, 1), "refused.yaml").expect_err(new);
        let lines: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(lines.iter().any(|l| l.contains(message)), "{new}: {}", lines.join("\n"));
    }
}

/// A block on a wedge in a lift: its speed is that of its centre, with what the lift adds beside its line.
#[test]
fn the_speed_of_a_block_counts_that_of_the_lift_beside_its_line() {
    let (lift, own, theta): (f64, f64, f64) = (3.0, 2.0, 25.0);
    let scene = |end: &str| {
        format!(
            "      surfaces: {{wedge: {{slope: theta}}}}
      carried: {{along: vertical, speed: u, acceleration: A}}
      bodies: {{load: {{mass: m, moves: along wedge, positive: down}}}}
      start: {{load: {{speed: v0}}}}
      end: {end}"
        )
    };
    let data = [
        ("m", "kg", 5.0),
        ("theta", "deg", theta),
        ("u", "m/s", lift),
        ("A", "m/s^2", 1.5),
        ("v0", "m/s", own),
        ("t1", "s", 0.7),
    ];
    let out = theta.to_radians().cos();
    let down = theta.to_radians().sin();
    let then = own + G * down * 0.7;
    let risen = lift + 1.5 * 0.7;
    let after = |v: f64, u: f64| ("v", v.hypot(u * out));
    let now = constants(&data[..5], &scene("at once"), "v");
    hold(&now.problems[0], &[5.0, theta, lift, 1.5, own, G], &[after(own, lift)]);
    let later = constants(&data, &scene("{time: {of: load, is: t1}}"), "v");
    let energy = 2.5 * (then * then + risen * risen * out * out);
    let expected = [after(then, risen), ("a", G * down), ("kinetic_energy", energy)];
    hold(&later.problems[0], &[5.0, theta, lift, 1.5, own, 0.7, G], &expected);
}

/// Forces that grow with place tell no time, so not how far or how fast what carries the scene has come; the rest is told.
#[test]
fn what_grows_with_place_on_a_truck_tells_no_speed_from_the_ground() {
    let grown = |question: &str| {
        format!(
            "bank: b
title: b
problems:
  p:
    title: p
    data: {{d: {{name: way, unit: m, draw: always 2}}}}
    scene:
      surfaces: {{bed: level}}
      carried: {{along: bed, acceleration: 1 m/s^2}}
      bodies: {{load: {{mass: 4 kg, moves: along bed}}}}
      ties: [cord: {{from: {{body: load, tied at: centre, leaves: forward}}, pulled with: 10 N, growing by: {{rate: 3 N/m, with: x}}}}]
      start: at rest
      end: {{travel: {{of: load, by: d}}}}
    questions: {{q: {{quantity: {question}, ask: q}}}}
"
        )
    };
    // On the bed 4 a = 10 + 3 x - 4.
    let known = bank(&grown("a"));
    let solved = hold(&known.problems[0], &[2.0, G], &[("a", 4.0), ("normal", 4.0 * G)]);
    assert!(solved.entries.iter().all(|e| !matches!(e.label.quantity, Quantity::V | Quantity::Displacement)));
    for question in ["v", "displacement"] {
        let found = load::scenes_only(&grown(question), "b.yaml").expect_err(question);
        assert!(found.iter().any(|f| f.to_string().contains("does not exist")), "{found:?}");
    }
}

/// A winch on a truck that brakes draws a crate up a ramp on its bed: what the axle bears takes the drum along, too.
#[test]
fn the_axle_of_a_winch_on_a_truck_bears_what_takes_the_drum_along() {
    let (brake, slope): (f64, f64) = (-2.5, 20.0);
    let (s, c) = slope.to_radians().sin_cos();
    for (line, [right, up]) in [("horizontal", [brake, 0.0]), ("vertical", [0.0, brake])] {
        let winch = constants(
            &[("M", "kg", 8.0), ("m", "kg", 5.0), ("r", "m", 0.2), ("theta", "deg", slope), ("C", "N*m", 9.0)],
            &format!(
                "      surfaces: {{ramp: {{slope: theta}}}}
      carried: {{along: {line}, acceleration: {brake} m/s^2}}
      bodies:
        drum: {{mass: M, shape: {{disc: r}}, moves: about a fixed axle}}
        load: {{mass: m, moves: along ramp}}
      ties: [cord: {{name: c, from: {{body: load, tied at: centre, leaves: forward}}, to: {{body: drum, wound on: rim, leaves: top back}}}}]
      forces: [couple: {{on: drum, moment: C, sense: forward}}]
      start: at rest
      end: at once"
            ),
            "drum.pin_x",
        );
        // On the ramp: 5 a = T - 5 (g + A_y) s - 5 A_x c, and the drum 4 a = C/r - T.
        let held = 5.0 * ((G + up) * s + right * c);
        let a = (45.0 - held) / 9.0;
        let tension = 45.0 - 4.0 * a;
        assert!(tension > 0.0);
        let (x, y) = (8.0 * right + tension * c, 8.0 * (G + up) + tension * s);
        let expected = [
            ("tension", tension),
            ("load.a", a + right * c + up * s),
            ("drum.pin_x", x),
            ("drum.pin_y", y),
            ("drum.pin_force", x.hypot(y)),
            ("drum.pin_angle", y.atan2(x)),
        ];
        hold(&winch.problems[0], &[8.0, 5.0, 0.2, slope, 9.0, G], &expected);
    }
}

/// A pipe on a truck starts as fast as the truck, given by the same datum: relative to it at rest, whatever the datum rounds to. By
/// hand, a hoop is left behind with half the acceleration of the truck.
#[test]
fn what_starts_as_fast_as_its_carrier_is_proved() {
    let text = "
bank: t
title: t
problems:
  p:
    title: t
    data:
      A: {name: A, unit: m/s^2, draw: always -3}
      u: {name: u, unit: m/s, draw: always 15}
      d: {name: d, unit: m, draw: always 3.5}
    scene:
      surfaces: {bed: level}
      carried: {along: bed, speed: u, acceleration: A}
      bodies: {pipe: {mass: 40 kg, shape: {hoop: 0.3 m}, moves: along bed}}
      ties: [rolls: {body: pipe, on its: rim}]
      start: {pipe: {speed: u}}
      end: {travel: {of: pipe, by: d}}
    questions: {t: {quantity: t, ask: none, unit: s}}
";
    let bank = bank(text);
    let t = f64::sqrt(2.0 * 3.5 / 1.5);
    let mut solved = hold(&bank.problems[0], &[-3.0, 15.0, 3.5, G], &[("t", t), ("v", 15.0 - 1.5 * t)]);
    assert!(agree::prove(&bank.problems[0].cases[0].scene, &[-3.0, 15.0, 3.5, G], &mut solved));
}
