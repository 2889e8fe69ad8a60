//! What does not move: rest is an answer on both roads, and what statics leaves open is named.
//!
//! Earlier tests could not see it: in every scene of the banks and in every published case something moves, each reaction is
//! determined, and each tie says something of its own. `composed_scenes.rs` finds the kinds; these say what is wanted of each.
use slipstick::bank::load;
use slipstick::scene::{Coordinate, Degree, Scene};
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::{Refusal, Solved};

/// A scene of constants, as in a bank.
fn scene(text: &str) -> Scene {
    let bank = format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:\n{text}\n    questions: {{kinetic_energy: {{ask: how much}}}}\n"
    );
    let bank = load::scenes_only(&bank, "test").unwrap_or_else(|f| panic!("{f:#?}"));
    bank.problems[0].cases[0].scene.clone()
}

fn solved(text: &str) -> (Scene, Solved) {
    let scene = scene(text);
    let solved = solve(&scene, &[9.81]).unwrap_or_else(|e| panic!("{e:?}\n{text}"));
    (scene, solved)
}

/// Name and value of everything that is published; both roads to the last bit.
fn values((scene, solved): &(Scene, Solved)) -> Vec<(String, f64)> {
    let value = |e: &slipstick::solve::outcome::Entry| {
        let near = (e.eom.unwrap() - e.energy.unwrap()).abs() <= 1e-12 * e.value().abs();
        assert!(near, "{:?}", e);
        (scene.name_of(e.label), e.value())
    };
    solved.entries.iter().map(value).collect()
}

fn value(of: &(Scene, Solved), name: &str) -> f64 {
    let all = values(of);
    all.iter().find(|(n, _)| n == name).unwrap_or_else(|| panic!("no {name} in {all:?}")).1
}

fn open((scene, solved): &(Scene, Solved)) -> Vec<String> {
    solved.open.iter().map(|l| scene.name_of(*l)).collect()
}

const FLOOR: &str = "      surfaces: {floor: level}\n";

#[test]
fn two_tied_blocks_that_nothing_pulls_stay() {
    let blocks = "      bodies:
        A: {mass: 3 kg, moves: along floor}
        B: {mass: 2 kg, moves: along floor}
      ties:
        - cord: {from: {body: A, tied at: centre, leaves: forward}, to: {body: B, tied at: centre, leaves: back}}\n";
    let end = "      start: at rest\n      end: {travel: {of: A, by: 1 m}}";
    // Without friction nothing can pull on the cord.
    let smooth = solved(&format!("{FLOOR}{blocks}{end}"));
    assert_eq!(smooth.1.regime.word(), "balanced");
    for name in ["A.v", "A.a", "B.v", "B.a", "tension", "kinetic_energy"] {
        assert_eq!(value(&smooth, name).to_bits(), 0.0f64.to_bits(), "{name}");
    }
    assert!(open(&smooth).is_empty());
    // With friction the cord may be tight between two blocks that hold it: statics does not say.
    let rough = format!(
        "{FLOOR}{blocks}        - slides: {{body: A, mu_k: 0.3}}\n        - slides: {{body: B, mu_k: 0.2}}\n{end}"
    );
    let rough = solved(&rough);
    assert_eq!(rough.1.regime.word(), "balanced");
    for name in ["A.v", "A.a", "B.v", "B.a", "kinetic_energy"] {
        assert_eq!(value(&rough, name).to_bits(), 0.0f64.to_bits(), "{name}");
    }
    let mut named = open(&rough);
    named.sort();
    assert_eq!(named, ["A.friction", "B.friction", "tension"]);
    // Nothing of it is published all the same, and no check says that the cord is taut.
    assert!(values(&rough).iter().all(|(n, v)| !named.contains(n) && v.is_finite()));
    assert!(!rough.1.all_hold());
}

#[test]
fn what_is_braked_down_to_no_speed_comes_to_rest() {
    let braked = "      bodies: {A: {mass: 3 kg, moves: along floor}}
      ties: [{slides: {body: A, mu_k: 0.5}}]
      start: {A: {speed: 2 m/s}}\n";
    let [mut speed, rest] = ["{speed: {of: A, reaches: 0 m/s}}", "{turning point: A}"]
        .map(|end| solved(&format!("{FLOOR}{braked}      end: {end}")));
    assert_eq!(values(&speed), values(&rest));
    assert!(prove(&speed.0, &[9.81], &mut speed.1), "a speed of 0 is no boundary");
}

#[test]
fn a_cord_from_the_point_of_contact_leaves_its_body_at_rest() {
    let of = |end: &str| {
        solved(&format!(
            "{FLOOR}      bodies:
        wheel: {{mass: 4 kg, shape: {{disc: 0.2 m}}, moves: along floor}}
        block: {{mass: 3 kg, moves: vertically, positive: down}}
      ties:
        - rolls: {{body: wheel, on its: rim}}
        - cord: {{from: {{body: wheel, wound on: rim, leaves: bottom forward}}, to: {{body: block, tied at: centre, leaves: up}}}}
        - cord: {{from: {{body: wheel, tied at: centre, leaves: forward}}, pulled with: 12 N}}
      start: at rest
      end: {end}"
        ))
    };
    // The wheel rolls as if the cord were not there: a = P/(m + I/R^2) = 12/6.
    let wheel = of("{travel: {of: wheel, by: 1 m}}");
    assert!((value(&wheel, "a") - 2.0).abs() < 1e-14 && (value(&wheel, "v") - 2.0).abs() < 1e-14);
    for (name, still) in [("block.a", 0.0), ("block.v", 0.0), ("block.rise", 0.0)] {
        assert_eq!(value(&wheel, name).to_bits(), f64::to_bits(still), "{name}");
    }
    assert!((value(&wheel, "tension") - 3.0 * 9.81).abs() < 1e-13);
    // The block never gets to an end of its own; what holds at the start is told all the same.
    let block = of("{travel: {of: block, by: 1 m}}");
    assert_eq!(block.1.regime.word(), "balanced");
    assert!((value(&block, "a") - 2.0).abs() < 1e-14 && value(&block, "block.a") == 0.0);
    assert!((value(&block, "tension") - 3.0 * 9.81).abs() < 1e-13);
    let started = scene(
        "      surfaces: {floor: level}
      bodies:
        wheel: {mass: 4 kg, shape: {disc: 0.2 m}, moves: along floor}
        block: {mass: 3 kg, moves: vertically}
      ties:
        - rolls: {body: wheel, on its: rim}
        - cord: {from: {body: wheel, wound on: rim, leaves: bottom forward}, to: {body: block, tied at: centre, leaves: up}}
      start: {block: {speed: 1 m/s}}
      end: {time: {of: wheel, is: 1 s}}",
    );
    let of = Coordinate { body: 1, degree: Degree::Along };
    let held = Refusal::Contradiction { of, given: 1.0, follows: 0.0 };
    assert_eq!(solve(&started, &[9.81]).unwrap_err(), held);
}

/// One block that stayed held all others, and its answers were 0 for what slides beside it.
#[test]
fn one_block_slides_while_another_stays() {
    let of = |end: &str| {
        solved(&format!(
            "      surfaces: {{incline: {{slope: 30 deg}}}}
      bodies:
        A: {{mass: 3 kg, moves: along incline}}
        B: {{mass: 2 kg, moves: along incline}}
      ties:
        - slides: {{body: A, mu_k: 0.2, mu_s: 0.3}}
        - slides: {{body: B, mu_k: 0.4, mu_s: 0.7}}
      start: at rest
      end: {end}"
        ))
    };
    let cosine = 0.75f64.sqrt();
    for end in ["{travel: {of: A, by: 1 m}}", "{travel: {of: B, by: 1 m}}"] {
        let s = of(end);
        assert!((value(&s, "A.a") + 9.81 * (0.5 - 0.2 * cosine)).abs() < 1e-13, "{end}");
        assert_eq!(value(&s, "B.a").to_bits(), 0.0f64.to_bits(), "{end}");
        // Static friction is what holds it, not mu N.
        assert!((value(&s, "B.friction") - 9.81).abs() < 1e-13, "{end}");
    }
    assert_eq!(value(&of("{travel: {of: A, by: 1 m}}"), "B.v").to_bits(), 0.0f64.to_bits());
    let rests = of("{travel: {of: B, by: 1 m}}");
    assert_eq!(rests.1.regime.word(), "balanced");
}

/// Rest is enclosed as what it is: 0, and friction to the last digits.
#[test]
fn a_block_that_stays_is_proved_to_stay() {
    let (scene, mut solved) = solved(
        "      surfaces: {incline: {slope: 20 deg}}
      bodies:
        A: {mass: 3 kg, moves: along incline}
      ties:
        - slides: {body: A, mu_k: 0.4, mu_s: 0.5}
      start: at rest
      end: {travel: {of: A, by: 1 m}}",
    );
    assert!(prove(&scene, &[9.81], &mut solved));
    for (name, most) in [("v", 0.0), ("a", 0.0), ("kinetic_energy", 0.0), ("friction", 1e-13)] {
        let entry = solved.entries.iter().find(|e| scene.name_of(e.label) == name).unwrap();
        assert!(entry.bound.is_some_and(|b| b <= most), "{name}: {:?}", entry.bound);
    }
}

/// Freedoms were coordinates less ties: a tie that says again what others say took one that was not there.
#[test]
fn two_cords_in_parallel_hold_no_more_than_one() {
    let cord = "        - cord: {from: {body: A, tied at: centre, leaves: up}, to: {body: B, tied at: centre, leaves: up}}\n";
    let twice = solved(&format!(
        "      bodies:
        A: {{mass: 3 kg, moves: vertically}}
        B: {{mass: 2 kg, moves: vertically}}
      ties:
{cord}{cord}      start: at rest
      end: {{travel: {{of: B, by: 1 m}}}}"
    ));
    assert!((value(&twice, "B.a") - 9.81 / 5.0).abs() < 1e-14);
    assert_eq!(open(&twice), ["cord1.tension", "cord2.tension"]);
}

/// A wheel that slips and pulls a block: the friction that it would need to roll was told as if the block slid for nothing.
#[test]
fn what_slides_beside_counts_in_the_friction_that_rolling_needs() {
    let s = solved(&format!(
        "{FLOOR}      bodies:
        wheel: {{mass: 4 kg, shape: {{disc: 0.2 m}}, moves: along floor}}
        block: {{mass: 3 kg, moves: along floor}}
      ties:
        - slips: {{body: wheel, on its: rim, mu_s: 0.5, mu_k: 0.4}}
        - slides: {{body: block, mu_k: 0.2}}
        - cord: {{from: {{body: wheel, tied at: centre, leaves: back}}, to: {{body: block, tied at: centre, leaves: forward}}}}
      forces:
        - couple: {{on: wheel, moment: 30 N*m, sense: forward}}
      start: at rest
      end: {{travel: {{of: wheel, by: 1 m}}}}"
    ));
    // Rolling: (m + M + I/R^2) a = C/R - mu M g, and C/R - F = I a/R^2.
    let drag = 0.2 * 3.0 * 9.81;
    let a = (150.0 - drag) / (4.0 + 3.0 + 2.0);
    assert!((value(&s, "friction_if_rolled") - (150.0 - 2.0 * a)).abs() < 1e-12);
    assert!((value(&s, "a") - (0.4 * 4.0 * 9.81 - drag) / 7.0).abs() < 1e-13);
}

/// A spring was left out of the friction that rolling needs: it is refused by name. A start speed, which took the sense of friction from
/// rest, goes in phases.
#[test]
fn what_slips_goes_without_a_spring() {
    let of = |extra: &str, start: &str| {
        let text = format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:\n{FLOOR}      bodies:
        wheel: {{mass: 4 kg, shape: {{disc: 0.2 m}}, radii: {{hub: 0.1 m}}, moves: along floor}}
      ties:
        - slips: {{body: wheel, on its: rim, mu_s: 0.2, mu_k: 0.1}}
        - cord: {{from: {{body: wheel, wound on: hub, leaves: top forward}}, held: fast}}
{extra}      start: {start}
      end: {{travel: {{of: wheel, by: 1 m}}}}
    questions: {{kinetic_energy: {{ask: how much}}}}\n"
        );
        let findings = load::scenes_only(&text, "test").err();
        findings.iter().flat_map(|all| all.iter()).map(ToString::to_string).collect::<String>()
    };
    let spring = "        - cord: {from: {body: wheel, tied at: centre, leaves: back}, spring: {stiffness: 50 N/m, stretch: 0.1 m}}\n";
    assert!(
        of(spring, "at rest").contains("`wheel` slips, and there is a spring"),
        "{}",
        of(spring, "at rest")
    );
    assert_eq!(of("", "{wheel: {speed: 1 m/s}}"), "");
}

/// No draw could stay: the check that it moves refused each, whatever regime was declared.
#[test]
fn a_problem_may_declare_that_a_block_stays() {
    let bank = |regimes: &str| {
        let text = format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n      m: {{name: mass, unit: kg, draw: 2 to 9 step 0.5}}\n      theta: {{name: slope, unit: deg, draw: 10 to 40 step 1}}\n      mu: {{name: friction, unit: \"1\", draw: 0.3 to 0.6 step 0.05}}\n    scene:
      surfaces: {{incline: {{slope: theta}}}}
      bodies:
        A: {{mass: m, moves: along incline}}
      ties:
        - slides: {{body: A, mu_k: 0.2, mu_s: mu}}
      start: at rest
      end: {{travel: {{of: A, by: 1 m}}}}
    regimes: [{regimes}]
    questions:
      friction: {{ask: the friction, unit: N}}\n"
        );
        load::scenes_only(&text, "test").unwrap_or_else(|f| panic!("{f:#?}"))
    };
    for (regime, stays) in [("balanced", true), ("moves_down", false)] {
        let bank = bank(regime);
        let maker = slipstick::problem::maker::Maker::new(&bank.problems[0], 1, "rest");
        for student in 0..40 {
            let v = maker.variant(&student.to_string()).unwrap_or_else(|e| panic!("{regime}: {e}"));
            let [m, theta, mu, g] = v.data[..] else { panic!("{:?}", v.data) };
            let (sine, cosine) = (libm::sin(theta.to_radians()), libm::cos(theta.to_radians()));
            // With the margin of `moves`, 10 % of the larger of drive and hold.
            let margin = (sine - mu * cosine) / sine.max(mu * cosine);
            assert!(if stays { margin <= -0.1 + 1e-12 } else { margin >= 0.1 - 1e-12 }, "{regime}: {margin}");
            let friction = v.solved.entries.iter().find(|e| e.label.quantity.name() == "friction").unwrap();
            let want = m * g * if stays { sine } else { 0.2 * cosine };
            assert!((friction.value() / want - 1.0).abs() < 1e-13, "{regime}: {}", friction.value());
        }
    }
}

/// A crate that is pushed just as hard as friction holds back goes on at its speed, whatever the doubles of the decimals leave.
#[test]
fn a_crate_that_is_pushed_as_friction_resists_keeps_its_speed() {
    let mut gone = 0;
    for step in 1..90 {
        let mu = f64::from(step) / 100.0;
        let push = (mu * 98.1 * 1e3).round() / 1e3;
        let scene = format!(
            "{{surfaces: {{S: level}}, bodies: {{B: {{mass: 10 kg, moves: along S}}}}, ties: [{{slides: {{body: B, mu_k: {mu:?}}}}}, {{cord: {{from: {{body: B, tied at: centre, leaves: forward}}, pulled with: {push:?} N}}}}], start: {{B: {{speed: 3 m/s}}}}, end: {{travel: {{of: B, by: 6 m}}}}}}"
        );
        let (_, solved) = solved(&format!("      {scene}"));
        assert!(solved.all_hold(), "{mu}: {:?}", solved.checks);
        for (name, expected) in [("a", 0.0), ("v", 3.0), ("t", 2.0), ("friction", -push)] {
            let entry = solved.entries.iter().find(|e| e.label.quantity.name() == name).unwrap();
            for found in [entry.value(), entry.energy.unwrap()] {
                assert!((found - expected).abs() <= 1e-15 * expected.abs(), "{mu} {name}: {found}");
            }
        }
        gone += 1;
    }
    assert!(gone > 80);
}
