//! Forces that grow evenly with time. The third witness knows scenes with constant forces only: as the acceleration is linear in
//! the forces, that of a growing force lies evenly between those of its first and its last value.
use crate::composed::Lot;
use crate::support;
use slipstick::bank::load;
use slipstick::solve::agree::solve;
use slipstick::solve::outcome::Solved;

/// A wheel with a hub on an incline, and a drum from which a load hangs: pulls, couples, their growth per second, speed, time.
const SCENES: [&str; 2] = [
    "
      surfaces: {incline: {slope: 20 deg}}
      bodies: {wheel: {mass: 12 kg, radius of gyration: 0.21 m, radii: {rim: 0.4 m, hub: 0.15 m}, moves: along incline, positive: up}}
      ties:
        - rolls: {body: wheel, on its: rim, mu_s: 0.9}
        - cord: {from: {body: wheel, wound on: hub, leaves: top forward}, pulled with: FORCE N GROWTH}
      forces: [couple: {on: wheel, moment: MOMENT N*m, sense: forward TURNING}]
      start: {wheel: {speed: SPEED m/s}}
      end: {time: {of: wheel, is: t1}}",
    "
      bodies:
        drum: {mass: 9 kg, shape: {disc: 0.3 m}, radii: {rim: 0.3 m}, moves: about a fixed axle}
        load: {mass: 5 kg, moves: vertically, positive: up}
      ties:
        - cord: {name: hoist, from: {body: load, tied at: centre, leaves: up}, to: {body: drum, wound on: rim, leaves: front down}}
        - cord: {name: rope, from: {body: drum, wound on: rim, leaves: back down}, pulled with: FORCE N GROWTH}
      forces: [couple: {on: drum, moment: MOMENT N*m, sense: back TURNING}]
      start: {load: {speed: SPEED m/s}}
      end: {time: {of: load, is: t1}}",
];

struct Case {
    scene: usize,
    force: f64,
    moment: f64,
    growths: Option<[f64; 2]>,
    speed: f64,
    time: f64,
}

fn text(case: &Case) -> String {
    let grows = |k: usize, unit: &str| {
        case.growths.map_or_else(String::new, |g| format!(", growing by: {} {unit}", g[k]))
    };
    let scene = SCENES[case.scene]
        .replace("FORCE", &case.force.to_string())
        .replace("MOMENT", &case.moment.to_string())
        .replace(" GROWTH", &grows(0, "N/s"))
        .replace(" TURNING", &grows(1, "N*m/s"))
        .replace("SPEED", &case.speed.to_string());
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{t1: {{name: time, unit: s, draw: always 5}}}}\n    scene:{scene}\n    questions: {{work: {{ask: W}}}}\n    statement: x\n"
    )
}

fn solved(case: &Case) -> Solved {
    let text = text(case);
    let bank = load::scenes_only(&text, "test").unwrap_or_else(|f| panic!("{f:#?}\n{text}"));
    solve(&bank.problems[0].cases[0].scene, &[case.time, 9.81]).unwrap_or_else(|e| panic!("{e:?}\n{text}"))
}

fn value(solved: &Solved, name: &str) -> f64 {
    let of = |e: &&slipstick::solve::outcome::Entry| e.label.quantity.name() == name;
    let entry = solved.entries.iter().find(of).unwrap_or_else(|| panic!("no {name}"));
    assert!(entry.energy.is_some(), "{name} on both roads");
    entry.value()
}

#[test]
fn a_growing_force_is_between_its_first_and_its_last_value() {
    let mut compared = 0;
    for seed in 0..support::seeds(2_000) {
        let mut lot = Lot::new(u64::from(seed));
        let mut between = |low: f64, high: f64| {
            let steps = lot.below(1000) as f64 / 1000.0;
            ((low + (high - low) * steps) * 100.0).round() / 100.0
        };
        let case = Case {
            scene: (seed % 2) as usize,
            force: between(40.0, 160.0),
            moment: between(0.0, 6.0),
            growths: Some([between(0.0, 40.0), between(0.0, 3.0)]),
            speed: between(3.0, 6.0),
            time: between(0.2, 1.0),
        };
        let [c, q] = case.growths.unwrap();
        let t = case.time;
        let first = solved(&Case { growths: None, ..case });
        let last =
            solved(&Case { growths: None, force: case.force + c * t, moment: case.moment + q * t, ..case });
        let grown = solved(&case);
        let (a0, a1) = (value(&first, "a"), value(&last, "a"));
        let v = case.speed + t * f64::midpoint(a0, a1);
        let s = t * (case.speed + t * (2.0 * a0 + a1) / 6.0);
        if [&first, &last].iter().any(|s| !s.entries.iter().any(|e| e.label.quantity.name() == "work"))
            || v < 0.5
        {
            continue;
        }
        compared += 1;
        let near = |name: &str, expected: f64| {
            let found = value(&grown, name);
            let gap = (found - expected).abs();
            assert!(gap <= 1e-11 * expected.abs().max(1.0), "{name}: {found}, {expected}\n{}", text(&case));
        };
        near("v", v);
        near("a", a1);
        near("displacement", s);
        near("impulse", grown_mass(case.scene) * (v - case.speed));
        let force = ["friction", "tension"][case.scene];
        near(force, value(&last, force));
        // The work of the pull, from the speeds at many times.
        let speed = |x: f64| case.speed + x * (a0 + (a1 - a0) * x / (2.0 * t));
        let steps = 2_000;
        let power = (0..steps).map(|i| {
            let x = t * (f64::from(i) + 0.5) / f64::from(steps);
            (case.force + c * x) * speed(x) * t / f64::from(steps)
        });
        let (work, expected) = (value(&grown, "work_pull"), power.sum::<f64>() * pull_ratio(case.scene));
        assert!((work - expected).abs() <= 1e-6 * expected.abs(), "{work}, {expected}\n{}", text(&case));
    }
    assert!(compared > support::seeds(2_000) / 2, "{compared}");
}

const fn grown_mass(scene: usize) -> f64 {
    [12.0, 5.0][scene]
}

/// Travel of the pulled end of the cord per metre of the body that ends the motion.
fn pull_ratio(scene: usize) -> f64 {
    [(0.4 + 0.15) / 0.4, 1.0][scene]
}

#[test]
fn what_does_not_grow_evenly_is_refused_by_name() {
    let case = Case { scene: 0, force: 90.0, moment: 1.0, growths: Some([5.0, 0.5]), speed: 1.0, time: 1.0 };
    for (from, to) in [
        ("time: {of: wheel, is: t1}", "speed: {of: wheel, reaches: 9 m/s}"),
        (
            "rolls: {body: wheel, on its: rim, mu_s: 0.9}",
            "slips: {body: wheel, on its: rim, mu_s: 0.2, mu_k: 0.1}",
        ),
    ] {
        let text = text(&case);
        assert!(text.contains(from));
        let found = format!("{:?}", load::scenes_only(&text.replace(from, to), "test").unwrap_err());
        assert!(found.contains("grows with time"), "{found}");
    }
}
