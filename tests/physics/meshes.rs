//! Gears and belts between wheels about fixed axles, against the books and against a balance by hand.
use slipstick::bank::{Bank, labels, load};
use slipstick::solve::agree;

fn bank(ties: &str, more: &str, end: &str) -> Bank {
    let text = format!(
        "
bank: t
title: t
problems:
  p:
    title: t
    data: {{}}
    scene:
      bodies:
        A: {{mass: 10 kg, radius of gyration: 200 mm, radii: {{rim: 250 mm}}, moves: about a fixed axle}}
        B: {{mass: 3 kg, radius of gyration: 80 mm, radii: {{rim: 100 mm, hub: 40 mm}}, moves: about a fixed axle}}
{more}
      ties:
{ties}
      forces: [couple: {{on: B, moment: 6 N*m}}]
      start: at rest
      end: {end}
    questions: {{q: {{value: 1*1, ask: none, unit: '1'}}}}
"
    );
    load::scenes_only(&text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"))
}

fn told(bank: &Bank, names: &[&str]) -> Vec<f64> {
    let scene = &bank.problems[0].cases[0].scene;
    let solved = agree::solve(scene, &[9.81]).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(solved.checks.iter().all(|c| c.ok), "{:?}", solved.checks);
    let of = |name: &&str| {
        let label = labels::named(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let entry = solved.get(label).unwrap_or_else(|| panic!("no {name}"));
        assert!(entry.eom.is_some() && entry.energy.is_some(), "{name}");
        scene.as_asked(label, entry.value())
    };
    names.iter().map(of).collect()
}

fn near(found: &[f64], expected: &[f64], by: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= by * b.abs().max(1e-9), "{a} against {b}");
    }
}

/// Beer & Johnston, sample problem 17.2: a couple of 6 N m on gear B (3 kg, k 80 mm, r 100 mm), which drives gear A (10 kg, k 200 mm,
/// r 250 mm): 4.35 revolutions of B until it makes 600 rpm, and 46.2 N between the teeth.
#[test]
fn two_gears_of_the_book() {
    let bank =
        bank("        - meshes: [B.rim, A.rim]", "", "{speed: {of: B, reaches: 62.83185307179586 rad/s}}");
    let [turned, force, a, b, energy] =
        told(&bank, &["B.phi", "rim_force", "A.alpha", "B.alpha", "kinetic_energy"])[..]
    else {
        panic!("five are told")
    };
    assert!((turned / (2.0 * std::f64::consts::PI) - 4.35).abs() < 0.01, "{turned}");
    assert!((force - 46.2).abs() < 0.05, "{force}");
    // M = (I_B + I_A (r_B/r_A)^2) alpha_B, and the teeth turn A alone, the other way.
    let alpha = 6.0 / (0.0192 + 0.4 * 0.16);
    near(&[b, a, force, energy], &[alpha, -0.4 * alpha, 0.4 * 0.4 * alpha / 0.25, 6.0 * turned], 1e-13);
}

/// A belt turns both wheels the same way; a rack of gears on one axle ends in a drum with a bucket.
#[test]
fn belts_and_trains_of_gears() {
    let belt = bank("        - belt: [B.rim, A.rim]", "", "at once");
    let alpha = 6.0 / (0.0192 + 0.4 * 0.16);
    near(&told(&belt, &["B.alpha", "A.alpha", "rim_force"]), &[alpha, 0.4 * alpha, 0.64 * alpha], 1e-13);
    let more = "        bucket: {mass: 4 kg, moves: vertically}\n        C: {moment of inertia: 0.05 kg*m^2, radii: {rim: 0.12 m, drum: 0.03 m}, moves: about a fixed axle}";
    let ties = "        - meshes: [B.rim, A.rim]
        - meshes: [A.rim, C.rim]
        - cord: {from: {body: bucket, tied at: centre, leaves: up}, to: {body: C, wound on: drum, leaves: back down}}";
    let train = bank(ties, more, "at once");
    // Per turn of B: A turns 0.4, C turns 5/6 the way that B does, the bucket rises by 0.03 * 5/6.
    let (w, v) = (0.1 / 0.12, 0.03 * 0.1 / 0.12);
    let inertia = 0.0192 + 0.4 * 0.16 + 0.05 * w * w + 4.0 * v * v;
    let alpha = (6.0 - 4.0 * 9.81 * v) / inertia;
    let tension = 4.0 * (9.81 + v * alpha);
    let second = (0.05 * w * alpha + 0.03 * tension) / 0.12;
    let first = (6.0 - 0.0192 * alpha) / 0.1;
    near(
        &told(&train, &["B.alpha", "C.alpha", "bucket.a", "tension", "mesh.rim_force", "mesh2.rim_force"]),
        &[alpha, w * alpha, v * alpha, tension, first, second],
        1e-12,
    );
    assert!((first - 0.4 * 0.4 * alpha / 0.25 - second).abs() < 1e-9);
}

/// What is no rim of a wheel about a fixed axle is refused by name.
#[test]
fn only_wheels_on_axles_mesh() {
    for (ties, what) in [
        ("        - meshes: [B.rim]", "expected two rims"),
        ("        - meshes: [B.rim, A.tooth]", "expected the rim of a wheel"),
        ("        - belt: [B.rim, B.hub]", "a wheel does not drive itself"),
    ] {
        let text = std::panic::catch_unwind(|| bank(ties, "", "at once")).map(|_| ()).unwrap_err();
        let text = text.downcast_ref::<String>().cloned().unwrap_or_default();
        assert!(text.contains(what), "{ties}: {text}");
    }
}
