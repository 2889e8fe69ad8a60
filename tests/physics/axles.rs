//! The force of a fixed axle. The third witness is the momentum of everything together: axle, weights and surfaces give what the centres
//! that move have gained, and no tension comes in.
use crate::support;
use slipstick::bank::{Bank, labels, load};
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::Solved;

fn bank(scene: &str) -> Bank {
    let text = format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:\n{scene}\n    questions: {{R: {{quantity: drum.pin_force, ask: R, unit: N}}}}\n    statement: x\n"
    );
    load::scenes_only(&text, "test").unwrap_or_else(|f| panic!("{f:#?}\n{text}"))
}

fn solved(scene: &str) -> (Bank, Solved) {
    let bank = bank(scene);
    let mut solved =
        solve(&bank.problems[0].cases[0].scene, &[9.81]).unwrap_or_else(|e| panic!("{e:?}\n{scene}"));
    prove(&bank.problems[0].cases[0].scene, &[9.81], &mut solved);
    (bank, solved)
}

fn value((bank, solved): &(Bank, Solved), name: &str) -> f64 {
    let scene = &bank.problems[0].cases[0].scene;
    let label = labels::named(scene, name).expect(name);
    let entry = solved.entries.iter().find(|e| e.label == label);
    let entry = entry.unwrap_or_else(|| panic!("no {name}"));
    assert!(entry.energy.is_some(), "{name} on both roads");
    entry.value()
}

/// The force of the axle from momentum: bodies with mass, line (to the right and up) and acceleration; the normal force of a surface.
fn axle(drum: f64, bodies: &[(f64, [f64; 2], f64, bool)], pulls: &[[f64; 2]]) -> [f64; 2] {
    let mut force = [0.0, drum * 9.81];
    for (mass, [c, s], a, on_surface) in bodies {
        force[0] += mass * a * c;
        force[1] += mass * (a * s + 9.81);
        if *on_surface {
            // Perpendicular to the surface, and as large as that part of the weight.
            force[0] += mass * 9.81 * c * s;
            force[1] -= mass * 9.81 * c * c;
        }
    }
    for pull in pulls {
        (force[0], force[1]) = (force[0] - pull[0], force[1] - pull[1]);
    }
    force
}

fn compare(of: &(Bank, Solved), expected: [f64; 2], scene: &str) {
    let size = expected[0].hypot(expected[1]);
    let near = |name: &str, x: f64, unit: f64| {
        let found = value(of, &format!("drum.{name}"));
        assert!((found - x).abs() <= 1e-13 * unit, "{name}: {found}, {x}\n{scene}");
    };
    near("pin_x", expected[0], size);
    near("pin_y", expected[1], size);
    near("pin_force", size, size);
    near("pin_angle", expected[1].atan2(expected[0]), 4.0);
}

#[test]
fn an_axle_bears_what_moves_on_it() {
    for seed in 0..support::seeds(60) {
        let step = |k: u32, low: f64, high: f64| {
            low + (high - low)
                * f64::from(seed.wrapping_mul(2_654_435_761).wrapping_add(k * 40_503) >> 8 & 1023)
                / 1023.0
        };
        let round = |x: f64| (x * 100.0).round() / 100.0;
        let [drum, one, other, moment] = [
            round(step(1, 2.0, 9.0)),
            round(step(2, 4.0, 9.0)),
            round(step(3, 1.0, 3.9)),
            round(step(4, 0.0, 4.0)),
        ];
        let slope: f64 = round(step(5, 10.0, 60.0));
        let drums = format!(
            "drum: {{mass: {drum} kg, shape: {{disc: 0.3 m}}, radii: {{rim: 0.3 m}}, moves: about a fixed axle}}"
        );
        // Two loads over a drum.
        let atwood = format!("      bodies:
        {drums}
        one: {{mass: {one} kg, moves: vertically, positive: down}}
        other: {{mass: {other} kg, moves: vertically}}
      ties:
        - cord: {{name: r1, from: {{body: one, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: front down}}}}
        - cord: {{name: r2, from: {{body: other, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: back down}}}}
      forces: [couple: {{on: drum, moment: {moment} N*m, sense: forward}}]
      start: at rest
      end: {{travel: {{of: one, by: 2 m}}}}");
        let found = solved(&atwood);
        let a = value(&found, "one.a");
        compare(
            &found,
            axle(drum, &[(one, [0.0, -1.0], a, false), (other, [0.0, 1.0], a, false)], &[]),
            &atwood,
        );
        // A winch draws a block up a slope, its cord parallel to that; the same at once.
        let (s, c) = slope.to_radians().sin_cos();
        let winch = |end: &str| {
            format!("      surfaces: {{incline: {{slope: {slope} deg}}}}
      bodies:
        {drums}
        block: {{mass: {one} kg, moves: along incline}}
      ties:
        - cord: {{from: {{body: block, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: top back}}}}
      forces: [couple: {{on: drum, moment: {} N*m, sense: forward}}]
      start: at rest
      end: {end}", 30.0 + moment)
        };
        for end in ["{travel: {of: block, by: 1 m}}", "at once"] {
            let found = solved(&winch(end));
            let a = value(&found, "block.a");
            compare(&found, axle(drum, &[(one, [c, s], a, true)], &[]), &winch(end));
        }
        // A load draws a block along a table, over a drum; and a drum that is pulled to the right, with more and more force.
        let table = format!("      surfaces: {{table: level}}
      bodies:
        {drums}
        block: {{mass: {other} kg, moves: along table}}
        load: {{mass: {one} kg, moves: vertically, positive: down}}
      ties:
        - cord: {{name: r1, from: {{body: block, tied at: centre, leaves: forward}}, to: {{body: drum, wound on: rim, leaves: top back}}}}
        - cord: {{name: r2, from: {{body: load, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: front down}}}}
      start: at rest
      end: {{time: {{of: load, is: 1 s}}}}");
        let found = solved(&table);
        let a = value(&found, "load.a");
        compare(
            &found,
            axle(drum, &[(other, [1.0, 0.0], a, true), (one, [0.0, -1.0], a, false)], &[]),
            &table,
        );
        let pulled = format!("      bodies:
        {drums}
      ties:
        - cord: {{from: {{body: drum, wound on: rim, leaves: top forward}}, pulled with: {one} N, growing by: 3 N/s}}
      start: at rest
      end: {{time: {{of: drum, is: 2 s}}}}");
        compare(&solved(&pulled), axle(drum, &[], &[[one + 6.0, 0.0]]), &pulled);
    }
}

/// Meriam and Kraige, sample problem 6/3, in SI: a load on the inner radius of a drum, and a cord from its outer radius that is pulled
/// at an angle. By hand: `I alpha = P R - T r`, `T = m (g + r alpha)`; the axle holds the drum, the load's cord and the pull. The
/// moment of inertia may be told beside the mass, or come of its radius of gyration.
#[test]
fn an_axle_bears_a_pull_at_an_angle() {
    let moment = format!("moment of inertia: {} kg*m^2", 146.0 * 0.45 * 0.45);
    for inertia in ["radius of gyration: 0.45 m", moment.as_str()] {
        for (leaves, right, tilt) in [
            ("top forward", 1.0, -45.0f64),
            ("top forward", 1.0, 30.0),
            ("bottom back", -1.0, 60.0),
            ("bottom back", -1.0, -20.0),
        ] {
            let scene = format!(
                "      bodies:
        drum: {{mass: 146 kg, {inertia}, radii: {{outer: 0.6 m, inner: 0.3 m}}, moves: about a fixed axle}}
        load: {{mass: 290 kg, moves: vertically, positive: up}}
      ties:
        - cord: {{name: hoist, from: {{body: load, tied at: centre, leaves: up}}, to: {{body: drum, wound on: inner, leaves: back down}}}}
        - cord: {{name: pull, from: {{body: drum, wound on: outer, leaves: {leaves}, at an angle: {tilt:?} deg}}, pulled with: 1800 N}}
      start: at rest
      end: at once"
            );
            let of = solved(&scene);
            // Both cords turn it clockwise from the top and from behind below.
            let alpha = (1800.0 * 0.6 - 290.0 * 9.81 * 0.3) / (146.0 * 0.45 * 0.45 + 290.0 * 0.09);
            let tension = 290.0 * (9.81 + 0.3 * alpha);
            assert!((value(&of, "drum.alpha") - alpha).abs() < 1e-12, "{scene}");
            let (sin, cos) = tilt.to_radians().sin_cos();
            compare(&of, [-right * 1800.0 * cos, 146.0 * 9.81 + tension - 1800.0 * sin], &scene);
        }
    }
}

/// Without a mass, with teeth, or with a cord that goes round a corner nobody can tell the force of an axle.
#[test]
fn an_axle_whose_force_is_not_told_is_refused() {
    let told = |scene: &str| {
        let text = format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:\n{scene}\n    questions: {{R: {{quantity: drum.pin_force, ask: R, unit: N}}}}\n    statement: x\n"
        );
        load::scenes_only(&text, "test")
            .expect_err("a finding")
            .iter()
            .map(ToString::to_string)
            .collect::<String>()
    };
    let winch = "      surfaces: {incline: {slope: 30 deg}}
      bodies:
        drum: {mass: 3 kg, shape: {disc: 0.3 m}, radii: {rim: 0.3 m}, moves: about a fixed axle}
        block: {mass: 2 kg, moves: along incline}
      ties:
        - cord: {from: {body: block, tied at: centre, leaves: up}, to: {body: drum, wound on: rim, leaves: top back}}
      start: at rest
      end: at once";
    bank(winch);
    for (from, to) in [
        ("mass: 3 kg, shape: {disc: 0.3 m}", "moment of inertia: 2 kg*m^2"),
        ("leaves: top back", "leaves: top forward"),
        (
            "cord: {from: {body: block, tied at: centre, leaves: up}, to: {body: drum, wound on: rim, leaves: top back}}",
            "meshes: [drum.rim, gear.rim]",
        ),
    ] {
        assert!(winch.contains(from));
        let mut scene = winch.replace(from, to);
        if to.contains("gear") {
            scene = scene.replace(
                "block: {mass: 2 kg, moves: along incline}",
                "gear: {mass: 2 kg, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: about a fixed axle}",
            );
            scene = scene.replace("surfaces: {incline: {slope: 30 deg}}", "surfaces: {}");
        }
        let found = told(&scene);
        assert!(found.contains("whose mass and whose cords' directions are told"), "{found}");
    }
}
