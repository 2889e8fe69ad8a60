//! Supports that share a load in a way that statics leaves open: can they carry it at all? And answers whose tolerance is their own, not
//! that of something greater beside them.
use crate::joined::{constants, free, read, solved, told, value};
use slipstick::solve::agree;
use slipstick::solve::outcome::CheckKind;

/// Do all of its conditions hold; if not, which does not?
fn fails(scene: &str) -> Option<CheckKind> {
    let (_, solved) = solved(scene);
    solved.checks.iter().find(|check| !check.ok).map(|check| check.kind)
}

/// A plank of 5 kg on two rollers of 2 kg, drawn at 70 degrees: it is lifted off by more than 49.05 N / sin 70.
#[test]
fn a_plank_that_is_lifted_off_its_rollers_is_refused() {
    let plank = |pull: f64| {
        format!(
            "
bodies:
  front: {{mass: 2 kg, shape: {{cylinder: 0.1 m}}, moves: in the plane, placed: [0.5 m, 0.1 m]}}
  rear: {{mass: 2 kg, shape: {{cylinder: 0.1 m}}, moves: in the plane, placed: [-0.5 m, 0.1 m]}}
  plank: {{mass: 5 kg, moves: in the plane, placed: [0 m, 0.2 m]}}
joints:
  A: {{rolls: front, radius: 0.1 m, along: horizontal}}
  B: {{rolls: front, radius: 0.1 m, on: plank, along: 180 deg}}
  C: {{rolls: rear, radius: 0.1 m, along: horizontal}}
  D: {{rolls: rear, radius: 0.1 m, on: plank, along: 180 deg}}
forces: [force: {{on: plank, magnitude: {pull} N, direction: 70 deg}}]
start: {{front: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    let least = 5.0 * 9.81 / f64::to_radians(70.0).sin();
    for pull in [1.0, 30.0, least - 1e-3] {
        assert_eq!(fails(&plank(pull)), None, "{pull}");
    }
    for pull in [least + 1e-3, 100.0, 1e5] {
        assert_eq!(fails(&plank(pull)), Some(CheckKind::Pressed), "{pull}");
    }
    // Half the rollers' mass and I/r^2 move with it: m_eff = 5 + 2 (2/4 + 2/8) kg.
    let (bank, found) = solved(&plank(30.0));
    let a = value(&bank.problems[0].cases[0].scene, &found, "plank.a_x");
    assert!((a - 30.0 * f64::to_radians(70.0).cos() / 6.5).abs() < 1e-12, "{a}");
}

/// A crate of 5 kg on three feet, pushed 0.8 m above its mass centre, which lies at the height of the feet: it tips about the last foot
/// where `0.8 P > 0.5 m g`.
#[test]
fn a_crate_that_tips_over_its_last_foot_is_refused() {
    let scene = |push: f64, feet: &str| {
        format!(
            "
bodies: {{c: {{mass: 5 kg, moment of inertia: 1 kg*m^2, moves: in the plane, angle: from right, placed: [0 m, 0 m], points: {{A: -0.5 m, B: 0.5 m, C: 0.1 m, P: [0.5 m, 0.8 m]}}}}}}
joints: {{{feet}}}
forces: [force: {{on: c.P, magnitude: {push} N, direction: right}}]
start: {{c: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    let foot = |name: &str| format!("{name}: {{guides: c.{name}, along: horizontal, pushes: up}}");
    let (two, three) = (["A", "B"].map(foot).join(", "), ["A", "B", "C"].map(foot).join(", "));
    let most = 0.5 * 5.0 * 9.81 / 0.8;
    for feet in [&two, &three] {
        assert_eq!(fails(&scene(most - 1e-3, feet)), None, "{feet}");
        assert_eq!(fails(&scene(most + 1e-3, feet)), Some(CheckKind::Pressed), "{feet}");
    }
    // On wheels that cannot be lifted it is no question.
    let rails = three.replace(", pushes: up", "");
    assert_eq!(fails(&scene(10.0 * most, &rails)), None);
}

/// What cords carry they pull at; what is struck up leaves its feet.
#[test]
fn cords_that_would_push_and_feet_that_would_pull_are_refused() {
    let hung = |pull: f64| {
        format!(
            "
bodies: {{r: {{mass: 4 kg, shape: {{rod: 1 m}}, moves: in the plane, angle: from right, placed: [0 m, 0 m], points: {{A: 0 m, M: 0.5 m, B: its end}}}}}}
joints:
  a: {{ties: r.A, to: [0 m, 1 m]}}
  b: {{ties: r.B, to: [1 m, 1 m]}}
  c: {{ties: r.M, to: [0.5 m, 1 m]}}
forces: [force: {{on: r.M, magnitude: {pull} N, direction: 80 deg}}]
start: {{r: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    assert_eq!((fails(&hung(30.0)), fails(&hung(80.0))), (None, Some(CheckKind::Taut)));
    let struck = |up: f64| {
        format!(
            "
bodies: {{r: {{mass: 4 kg, shape: {{rod: 1 m}}, moves: in the plane, angle: from right, placed: [0 m, 0 m], points: {{A: 0 m, M: 0.5 m, B: its end}}}}}}
joints:
  a: {{guides: r.A, along: horizontal, pushes: up}}
  b: {{guides: r.B, along: horizontal, pushes: up}}
  c: {{guides: r.M, along: horizontal, pushes: up}}
forces: [impulse: {{on: r.M, magnitude: 8 N*s, direction: {up} deg}}]
start: {{r: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    assert_eq!((fails(&struck(-80.0)), fails(&struck(80.0))), (None, Some(CheckKind::HoldsBlow)));
}

/// A fact of the scene that is small beside another one is not free for that.
#[test]
fn small_answers_beside_great_ones_are_judged() {
    let struck = "
bodies:
  cart: {mass: 300 kg, moves: in the plane, placed: [0 m, 0 m]}
  rod: {mass: 2 kg, shape: {rod: 1.2 m}, moves: in the plane, angle: from hanging}
joints:
  g: {guides: cart, along: horizontal}
  O: {hinges: [cart, rod.A]}
forces: [impulse: {on: rod.B, magnitude: 0.04 N*s, direction: right}]
start: {rod: {angle: 0 deg}}
end: at once
";
    let ballistic = "
bodies:
  rod: {mass: 1 kg, shape: {rod: 1.5 m}, moves: in the plane, angle: from hanging}
  box: {mass: 6 kg, moves: in the plane}
  b: {mass: 8 g, moves: in the plane}
joints:
  O: {pins: rod.A}
  K: {welds: [rod.B, box]}
  H: {welds: [rod.B, b]}
start: {rod: {angle: 0 deg}, b: {arrives: {speed: 300 m/s, direction: right}}}
end: {turning point: rod}
";
    let buffer = "
bodies: {bar: {mass: 13.6 kg, shape: {rod: 1.5 m}, moves: in the plane, angle: from right, points: {O: 0.3 m, B: 0 m}}}
joints: {O: {pins: bar.O}}
forces: [spring: {on: bar.B, to: [-0.3 m, 0.3 m], stiffness: 315 kN/m, stretch: -25 mm, only: pushes}]
start: {bar: {angle: 0 deg}}
end: {angle: {of: bar, reaches: 90 deg}}
";
    let corner = "
bodies: {disc: {mass: 10 kg, shape: {disc: 0.2 m}, moves: in the plane}}
joints:
  floor: {slides: disc, radius: 0.2 m, along: horizontal, mu_k: 0.05}
  wall: {slides: disc, radius: 0.2 m, along: -90 deg, mu_k: 0.05}
start: {disc: {spin: 30 rad/s}}
end: at once
";
    let slides = "
surfaces: {in: {slope: 60 deg}}
bodies: {b: {mass: 8 kg, moves: along in, positive: down}}
ties: [slides: {body: b, mu_s: 0.02, mu_k: 0.02}]
start: at rest
end: {time: {of: b, is: 1 s}}
";
    let cases = [
        (struck, "rod.omega"),
        (struck, "cart.v_x"),
        (struck, "rod.v_x"),
        (ballistic, "box.rise"),
        (buffer, "O.pin_angle"),
        (buffer, "O.pin_force"),
        (corner, "alpha"),
        (slides, "friction"),
    ];
    for (scene, name) in cases {
        assert!(free(scene, name) < 0.05, "{name}: {} in{scene}", free(scene, name));
    }
    // A small force across a great one is worked out beside it.
    assert!(free(corner, "floor.normal") < 0.01);
}

/// What is the same on both roads is no disagreement: half a turn to either side, and nothing beside what adds up.
#[test]
fn what_is_the_same_agrees() {
    let turn = |from: f64| {
        let to = from + 360.0;
        format!(
            "
bodies: {{a: {{mass: 2 kg, shape: {{rod: 0.6 m}}, moves: in a horizontal plane, angle: from right}}}}
joints: {{O: {{pins: a.A}}}}
start: {{a: {{angle: {from} deg, spin: 3 rad/s}}}}
end: {{angle: {{of: a, reaches: {to} deg}}}}
"
        )
    };
    for from in [0.0, 45.0, 90.0, 180.0] {
        let found = told(&turn(from), &["O.pin_force", "t"]);
        assert!((found[0] - 2.0 * 0.3 * 9.0).abs() < 1e-12, "{found:?}");
        assert!((found[1] - std::f64::consts::TAU / 3.0).abs() < 1e-12, "{found:?}");
    }
    // A parallelogram whose light coupler is upright to its cranks: no couple, and no force across.
    let driven = "
bodies:
  a: {mass: 2 kg, shape: {rod: 0.2 m}, moves: in a horizontal plane, angle: from right}
  b: {mass: 0 kg, shape: {rod: 0.5 m}, moves: in a horizontal plane, side: ahead}
  c: {mass: 0.7 kg, shape: {rod: 0.2 m}, moves: in a horizontal plane}
joints:
  O: {pins: a.A}
  A: {hinges: [a.B, b.A]}
  B: {hinges: [b.B, c.B]}
  D: {pins: c.A, at: [0.5 m, 0 m]}
start: {a: {angle: 45 deg, alpha: 2 rad/s^2}}
end: at once
";
    let scene = constants(driven);
    assert!(read(driven).is_ok());
    let found = agree::solve(&scene.problems[0].cases[0].scene, &[9.81]);
    assert!(found.is_ok(), "{:?}", found.err());
}
