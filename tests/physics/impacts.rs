//! Impacts of bodies that move, what joined bodies are together, and turns without end, against formulas by hand and printed results.
use crate::joined::{all_near, constants, read, told};
use slipstick::bank::load;
use slipstick::grade::{compare::compare, verdict::Verdict};
use slipstick::key::Answer;
use slipstick::problem::{make_key::key, maker::Maker};
use slipstick::solve::agree;
use slipstick::solve::outcome::{CheckKind, Refusal};

const G: f64 = 9.81;

/// Two discs are coupled: `I_A w_A + I_B w_B = (I_A + I_B) w`.
#[test]
fn two_discs_are_coupled() {
    let scene = "
bodies:
  a: {mass: 4 kg, moment of inertia: 0.04 kg*m^2, moves: in the plane}
  b: {mass: 3 kg, moment of inertia: 0.02 kg*m^2, moves: in the plane}
joints: {O: {pins: a.A}, clutch: {welds: [a.A, b.A]}}
start: {a: {angle: 0 deg, arrives: {spin: 50 rad/s}}, b: {arrives: {spin: 200 rad/s}}}
end: at once
";
    let w = (0.04 * 50.0 + 0.02 * 200.0) / 0.06;
    all_near(&told(scene, &["a.omega", "b.omega", "kinetic_energy"]), &[w, w, 0.03 * w * w], 1e-13);
}

/// A rod that turns freely about its own centre is caught at its end: `I_G w_0 = I_A w`, a quarter is left. Its centre does not move
/// before, and that is told.
#[test]
fn a_rod_that_turns_about_its_centre_is_caught_at_its_end() {
    for speed in ["0 m/s", "-0 m/s", "0.0 km/h"] {
        let scene = format!(
            "
bodies: {{rod: {{mass: 4 kg, shape: {{rod: 1.2 m}}, moves: in the plane, angle: from right}}}}
joints: {{O: {{pins: rod.A}}}}
start: {{rod: {{angle: 10 deg, arrives: {{spin: 3 rad/s, speed: {speed}, direction: up}}}}}}
end: at once
"
        );
        // The impulse of the pin is the momentum of the centre, which circles A then.
        let (w, [x, y]) = (0.75, [10.0_f64.to_radians().sin(), 10.0_f64.to_radians().cos()]);
        let blow = 4.0 * w * 0.6;
        let told = told(&scene, &["rod.omega", "O.impulse_x", "O.impulse_y"]);
        all_near(&told, &[w, -blow * x, blow * y], 1e-13);
    }
}

const BULLET: &str = "
bodies:
  rod:    {mass: 5 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging, points: {O: 0 m, P: 0.75 m}}
  bullet: {mass: 0.004 kg, moves: in the plane}
joints: {O: {pins: rod.O}, P: {welds: [rod.P, bullet]}}
start: {rod: {angle: 0 deg}, bullet: {arrives: {speed: 400 m/s, direction: 330 deg}}}
end: {turning point: rod}
";

/// Hibbeler, *Engineering Mechanics: Dynamics*, 14th edition, example 19.7: a bullet stays in a rod, 0.622 rad/s (0.6229); it swings as high
/// as its energy lets it.
#[test]
fn a_bullet_stays_in_a_rod() {
    let about = 5.0 / 3.0 + 0.004 * 0.75 * 0.75;
    let w = 0.004 * 400.0 * f64::to_radians(30.0).cos() * 0.75 / about;
    assert!((w - 0.622).abs() < 1e-3, "{w}");
    all_near(&told(&BULLET.replace("{turning point: rod}", "at once"), &["rod.omega"]), &[w], 1e-13);
    let swing = (1.0 - about * w * w / (2.0 * G * (2.5 + 0.004 * 0.75))).acos();
    all_near(&told(BULLET, &["rod.phi"]), &[swing], 1e-12);
}

const THROWN_BACK: &str = "
bodies:
  rod:  {mass: 5 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}
  ball: {mass: 1 kg, moves: in the plane, placed: [0 m, -0.8 m]}
joints:
  O:   {pins: rod.A}
  hit: {guides: ball, on: rod.A, along: 0 deg, restitution: 0.4}
start: {rod: {angle: 0 deg, arrives: {spin: -1.5 rad/s}}, ball: {arrives: {speed: 6 m/s, direction: right}}}
end: at once
";

/// `P (1/m + h^2/I) = (1 + e) (v - w_0 h)`: a ball is thrown back by a rod that turns toward it.
#[test]
fn a_rod_throws_a_ball_back() {
    let (m, h, about) = (1.0, 0.8, 5.0 / 3.0);
    let of = |e: f64| {
        let p = (1.0 + e) * (6.0 + 1.5 * h) / (1.0 / m + h * h / about);
        let (w, v) = (-1.5 + p * h / about, 6.0 - p / m);
        let energy = 0.5 * about * w * w + 0.5 * m * v * v;
        [w.abs(), v, p, 5.0 * 0.5 * (w + 1.5) - p, energy]
    };
    let names = ["rod.omega", "ball.v_x", "hit.impulse", "O.impulse_x", "kinetic_energy"];
    for e in [0.0, 0.4, 1.0] {
        let mut found = told(&THROWN_BACK.replace("0.4}", &format!("{e}}}")), &names);
        found[2] = found[2].abs();
        all_near(&found, &of(e), 1e-13);
    }
    // Nothing is lost where it is elastic.
    all_near(
        &told(&THROWN_BACK.replace("0.4}", "1}"), &names[4..]),
        &[0.5 * about * 1.5 * 1.5 + 18.0],
        1e-13,
    );
}

/// A cylinder that is struck at its axle, and rolls at once: v = 2 J / 3 m, and friction gives the spin, S = J / 3.
#[test]
fn friction_has_an_impulse_where_a_wheel_is_struck() {
    let scene = "
bodies: {cylinder: {mass: 5 kg, shape: {cylinder: 0.1 m}, moves: in the plane, angle: from up clockwise}}
joints: {floor: {rolls: cylinder, radius: 0.1 m, along: horizontal}}
forces: [impulse: {on: cylinder.A, magnitude: 6 N*s, direction: right}]
start: {cylinder: {angle: 0 deg}}
end: at once
";
    let found = told(scene, &["cylinder.v_x", "floor.friction_impulse", "floor.impulse"]);
    all_near(&found, &[0.8, -2.0, 0.0], 1e-13);
    let down = told(&scene.replace("right", "210 deg"), &["floor.friction_impulse", "floor.impulse"]);
    all_near(&down, &[6.0 * 30.0_f64.to_radians().cos() / 3.0, 3.0], 1e-13);
}

/// Hibbeler, example 19.6: a wheel meets a step, about whose edge it turns; 0.729 m/s are just enough.
#[test]
fn a_wheel_rolls_over_a_step() {
    let scene = |v: f64| {
        format!(
            "
bodies: {{wheel: {{mass: 10 kg, moment of inertia: 0.156 kg*m^2, moves: in the plane, angle: from upright, mass centre: 0.2 m, points: {{O: 0 m}}}}}}
joints: {{edge: {{pins: wheel.O}}}}
start: {{wheel: {{angle: -31.788 deg, arrives: {{speed: {v} m/s, direction: right, spin: {} rad/s}}}}}}
end: {{angle: {{of: wheel, reaches: 0 deg}}}}
",
            v / 0.2
        )
    };
    let (about, lifted) = (0.556, 0.2 * (1.0 - f64::to_radians(31.788).cos()));
    let w = (0.156 + 10.0 * 0.2 * (0.2 - lifted)) * 4.0 / about;
    let top = (w * w - 2.0 * 10.0 * G * lifted / about).sqrt();
    all_near(&told(&scene(0.8), &["omega"]), &[top], 1e-12);
    let short = agree::solve(&constants(&scene(0.729)).problems[0].cases[0].scene, &[G]).unwrap();
    let failed: Vec<CheckKind> = short.checks.iter().filter(|c| !c.ok).map(|c| c.kind).collect();
    assert_eq!(failed, [CheckKind::Reaches]);
}

/// What an impact does not go together with is refused by name.
#[test]
fn impacts_that_are_none_are_refused() {
    let refused = |scene: String, words: &str| {
        let found = read(&scene).expect_err("a finding").iter().map(ToString::to_string).collect::<String>();
        assert!(found.contains(words), "{found}");
    };
    refused(THROWN_BACK.replace("at once", "{angle: {of: rod, reaches: 10 deg}}"), "`hit` has a restitution");
    refused(THROWN_BACK.replace("restitution: 0.4", "restitution: 1.4"), "from 0 to 1");
    refused(THROWN_BACK.replace(", restitution: 0.4", ", mu_k: 0.4"), "what friction does in a blow");
    refused(THROWN_BACK.replace("{spin: -1.5 rad/s}", "{}"), "no such velocity before the impact");
    refused(THROWN_BACK.replace("arrives: {spin: -1.5 rad/s}", "spin: -1.5 rad/s"), "beside another one");
    let pinned = THROWN_BACK
        .replace("{pins: rod.A}", "{pins: rod.A, restitution: 0.4}")
        .replace(", restitution: 0.4}\nstart", "}\nstart");
    refused(pinned, "`O` has a restitution and holds in more than one direction");
    let bent = THROWN_BACK.replace("{spin: -1.5 rad/s}", "{speed: 1 m/s, direction: right}");
    let solved = agree::solve(&constants(&bent).problems[0].cases[0].scene, &[G]);
    assert!(matches!(solved, Err(Refusal::PartedBefore { joint: 0, .. })), "{solved:?}");
}

/// Hibbeler, example 19.1: a rod between two walls has 6.67 kg m^2/s about its mass centre; each of joined bodies tells its own.
#[test]
fn joined_bodies_tell_their_angular_momentum() {
    let bar = "
bodies: {bar: {mass: 5 kg, shape: {rod: 4 m}, moves: in the plane, angle: from horizontal}}
joints: {A: {guides: bar.A, along: horizontal}, B: {guides: bar.B, along: vertical}}
start: {bar: {angle: 30 deg, spin: -1 rad/s}}
end: at once
";
    all_near(&told(bar, &["angular_momentum"]), &[20.0 / 3.0], 1e-13);
}

/// A planet gear on a driven arm after five turns: `J w^2/2 = M phi`.
#[test]
fn an_arm_makes_many_turns() {
    let scene = |turns: f64| {
        format!(
            "
bodies:
  arm:  {{mass: 3 kg, shape: {{rod: 0.3 m}}, moves: in a horizontal plane, angle: from right}}
  gear: {{mass: 1 kg, shape: {{disc: 0.1 m}}, moves: in a horizontal plane}}
joints: {{O: {{pins: arm.A}}, A: {{hinges: [arm.B, gear.A]}}, sun: {{meshes: gear, radius: 0.1 m, outside: 0.2 m}}}}
forces: [couple: {{on: arm, moment: 5 N*m}}]
start: {{arm: {{angle: 0 deg}}}}
end: {{angle: {{of: arm, reaches: {} deg}}}}
",
            360.0 * turns
        )
    };
    let inertia = 3.0 * 0.09 / 3.0 + 1.0 * 0.09 + 0.005 * 9.0;
    let phi = 10.0 * std::f64::consts::PI;
    let found = told(&scene(5.0), &["arm.omega", "arm.phi", "t", "gear.angular_momentum"]);
    let w = (2.0 * 5.0 * phi / inertia).sqrt();
    all_near(&found, &[w, phi, 2.0 * phi / w, 0.005 * 3.0 * w], 1e-12);
    assert!(read(&scene(21.0)).is_err());
}

/// A couple brakes an arm that passes a short spring in each turn: in its third one it may no longer have the energy for it. With
/// `E = E_0 - M q - k (l_0 - l)^2/2` the time is the integral of `sqrt(J/2E)`.
#[test]
fn a_spring_is_met_in_every_turn() {
    let scene = |energy: f64, reaches: u32| {
        format!(
            "
bodies: {{arm: {{mass: 3 kg, shape: {{rod: 0.3 m}}, moves: in a horizontal plane, angle: from right}}}}
joints: {{O: {{pins: arm.A}}}}
forces:
  - couple: {{on: arm, moment: 0.5 N*m, sense: back}}
  - spring: {{on: arm.B, to: [-0.301 m, 0 m], stiffness: 1e6 N/m, natural length: 0.004 m, only: pushes}}
start: {{arm: {{angle: 0 deg, spin: {} rad/s}}}}
end: {{angle: {{of: arm, reaches: {reaches} deg}}}}
",
            (2.0 * energy / 0.09).sqrt()
        )
    };
    let left = |energy: f64, q: f64| {
        let pressed = f64::max(0.0, 0.004 - f64::hypot(0.301 + 0.3 * q.cos(), 0.3 * q.sin()));
        energy - 0.5 * q - 0.5e6 * pressed * pressed
    };
    for (energy, reaches) in [(13.0, 1080), (20.0, 1800)] {
        let far = f64::from(reaches).to_radians();
        let steps = 2_000_000;
        let each = far / f64::from(steps);
        let time: f64 =
            (0..steps).map(|i| each * (0.045 / left(energy, (f64::from(i) + 0.5) * each)).sqrt()).sum();
        let found = told(&scene(energy, reaches), &["omega", "t"]);
        all_near(&found[..1], &[(left(energy, far) / 0.045).sqrt()], 1e-12);
        all_near(&found[1..], &[time], 1e-7);
    }
    let stopped = agree::solve(&constants(&scene(11.0, 950)).problems[0].cases[0].scene, &[G]).unwrap();
    let failed: Vec<CheckKind> = stopped.checks.iter().filter(|c| !c.ok).map(|c| c.kind).collect();
    assert_eq!(failed, [CheckKind::Reaches]);
}

/// A heavy bullet strikes a light rod near its centre of percussion: the impulse of the pin is small beside what the bullet brings, but
/// not beside what the rod and the bullet gain, and that alone is what it may be off by beside its own share.
#[test]
fn the_impulse_of_a_pin_is_judged_by_what_adds_up_to_it() {
    let (m, big, v, l, h): (f64, f64, f64, f64, f64) = (4.0, 100.0, 300.0, 1.2, 0.85);
    let text = format!(
        "
bank: b
title: B
problems:
  p:
    title: P
    data: {{v: {{name: speed, unit: m/s, draw: always {v}}}}}
    scene:
      bodies:
        rod:    {{mass: {m} kg, shape: {{rod: {l} m}}, moves: in the plane, angle: from hanging, points: {{O: 0 m, B: {h} m}}}}
        bullet: {{mass: {big} kg, moves: in the plane}}
      joints:
        O: {{pins: rod.O}}
        B: {{welds: [rod.B, bullet]}}
      start: {{rod: {{angle: 0 deg}}, bullet: {{arrives: {{speed: v, direction: right}}}}}}
      end: at once
    questions:
      pin:  {{quantity: O.impulse_x, unit: N*s, ask: the impulse of the pin}}
      weld: {{quantity: B.impulse_x, unit: N*s, ask: the impulse between rod and bullet}}
"
    );
    let bank = load::scenes_only(&text, "b.yaml").unwrap_or_else(|found| panic!("{found:?}"));
    let problem = &bank.problems[0];
    let variant = Maker::new(problem, 1, "pin").variant("0").unwrap_or_else(|e| panic!("{e}"));
    let key = key(problem, &variant);
    // About O: (m L^2/3 + M h^2) w = M v h.
    let w = big * v * h / (m * l * l / 3.0 + big * h * h);
    let bullet = big * (v - w * h);
    let rod = m * w * l / 2.0;
    for (part, by_hand, terms) in
        [(&key.parts[0], rod - bullet, rod + 2.0 * bullet), (&key.parts[1], bullet, 2.0 * bullet)]
    {
        let Answer::Number { value, half_width, .. } = part.answer else { panic!("a number is asked") };
        assert!((value.abs() - by_hand.abs()).abs() < 1e-10 * terms, "{value} {by_hand}");
        assert!(
            half_width <= f64::max(0.01 * value.abs(), 1.1e-3 * (terms + value.abs())),
            "{half_width} of {value}"
        );
        for (share, verdict) in [(1.0, Verdict::Right), (1.33, Verdict::Wrong), (0.67, Verdict::Wrong)] {
            assert_eq!(
                compare(&format!("{} N*s", share * value), part).verdict,
                verdict,
                "{share} of {value}"
            );
        }
    }
}
