//! What books say in other words is what the language says; and what is welded together, by hand: mass centre and moments of inertia.
use crate::joined::{all_near, constants, read, told};
use slipstick::bank::{labels, load};
use slipstick::misconception;
use slipstick::problem::maker::Maker;
use slipstick::sheet::public::Writer;

/// The scene that is read of this text.
fn scene(text: &str) -> slipstick::scene::Scene {
    constants(text).problems[0].cases[0].scene.clone()
}

/// Both texts are the same scene.
fn same(said: &str, meant: &str) {
    assert_eq!(scene(said), scene(meant), "{said}{meant}");
}

#[test]
fn one_coefficient_and_one_velocity_of_what_slips() {
    let ball = "
surfaces: {floor: level}
bodies: {ball: {mass: 3 kg, shape: {solid sphere: 0.1 m}, moves: along floor}}
ties: [slips: {body: ball, on its: rim, mu_k: 0.2}]
start: {ball: {speed: 5 m/s}}
end: {rolling: ball}
";
    let meant = ball.replace("mu_k: 0.2", "mu_s: 0.2, mu_k: 0.2").replace("solid sphere", "sphere");
    same(ball, &meant.replace("5 m/s}", "5 m/s, spin: 0 rad/s}"));
    // v = 5 v0 / 7 after t = 2 v0 / (7 mu g).
    all_near(&told(ball, &["v", "t"]), &[25.0 / 7.0, 10.0 / (7.0 * 0.2 * 9.81)], 1e-13);
    let spun = ball.replace("speed: 5 m/s", "spin: 30 rad/s");
    all_near(&told(&spun, &["omega"]), &[30.0 * 2.0 / 7.0], 1e-13);
    // A cord may give the other velocity, here that of a load.
    let held = ball
        .replace("ties: [", "ties: [cord: {from: {body: ball, tied at: centre, leaves: back}, held: fast}, ");
    let found = format!("{:?}", read(&held.replace("speed: 5 m/s", "spin: 30 rad/s")).map(|_| ()));
    assert!(!found.contains("already give"), "{found}");
}

#[test]
fn angles_in_the_words_of_books() {
    let rod = |angle: &str| {
        format!(
            "
bodies: {{rod: {{mass: 3 kg, shape: {{slender rod: 2 m}}, moves: in the plane, angle: {angle}}}}}
joints: {{O: {{pins: rod.A}}}}
start: {{rod: {{angle: 20 deg}}}}
end: {{angle: {{of: rod, reaches: 50 deg}}}}
"
        )
    };
    for (said, meant) in [
        ("from the vertical", "from up clockwise"),
        ("from up", "from vertical"),
        ("clockwise from the horizontal", "from right clockwise"),
        ("from the right anticlockwise", "from horizontal"),
        ("from down", "from hanging"),
        ("counterclockwise from upright", "from up counter-clockwise"),
    ] {
        same(&rod(said), &rod(meant));
    }
    assert!(read(&rod("from left")).is_err(), "which sense is not said");
    let hint = format!("{:?}", read(&rod("from the moon")).map(|_| ()));
    for family in [
        "from right",
        "from horizontal",
        "from upright",
        "from vertical",
        "from hanging",
        "from left",
        "counter-clockwise",
    ] {
        assert!(hint.contains(family), "{family}: {hint}");
    }
    assert!(read(&rod("from the wall")).is_err());
}

/// A turn from the start is the angle that it comes to, of constants and of symbols.
#[test]
fn a_turn_ends_at_an_angle() {
    let rod = "
bodies: {rod: {mass: 30 kg, shape: {rod: 3 m}, moves: in a horizontal plane, angle: from right}}
joints: {O: {pins: rod.A}}
forces: [couple: {on: rod, moment: 20 N*m}, force: {on: rod.B, magnitude: 30 N, from the axis: 90 deg}]
start: {rod: {angle: 30 deg}}
end: {turn: {of: rod, by: 1 rev}}
";
    same(rod, &rod.replace("turn: {of: rod, by: 1 rev}", "angle: {of: rod, reaches: 390 deg}"));
    let square = 2.0 * (20.0 + 90.0) * std::f64::consts::TAU / (30.0 * 9.0 / 3.0);
    all_near(&told(rod, &["omega"]), &[square.sqrt()], 1e-13);
    let pinned = "
bodies: {rod: {mass: 3 kg, shape: {rod: 2 m}, pinned: at its end, angle: from up}}
start: {rod: {angle: 10 deg, spin: 1 rad/s}}
end: {turn: {of: rod, by: pi/3}}
";
    let gained = f64::cos(10_f64.to_radians()) - f64::cos(70_f64.to_radians());
    all_near(&told(pinned, &["omega"]), &[(1.0 + 3.0 * 9.81 / 2.0 * gained).sqrt()], 1e-13);
}

/// `k_O` and `I_O` are put about the mass centre, of constants and of data; both `asin` and `acos` are angles.
#[test]
fn about_the_pin() {
    let held = |inertia: &str| {
        format!(
            "
bodies: {{pendulum: {{mass: 7.5 kg, {inertia}, pinned: {{distance: 0.25 m}}, angle: from hanging}}}}
start: {{pendulum: {{angle: acos(sqrt(3)/2)}}}}
end: {{angle: {{of: pendulum, reaches: asin(0)}}}}
"
        )
    };
    let square = 2.0 * 9.81 * 0.25 * (1.0 - 0.75_f64.sqrt()) / (0.295 * 0.295);
    let inertia = 7.5 * 0.295 * 0.295;
    let moment = format!("moment of inertia about the pin: {inertia} kg*m^2");
    for said in ["radius of gyration about the pin: 295 mm", &moment] {
        all_near(&told(&held(said), &["omega", "I_O"]), &[square.sqrt(), inertia], 1e-13);
    }
    // Of data, on a joint beside the axis' beginning.
    let text = "bank: t\ntitle: t\nproblems:\n  p:\n    title: t\n    data:\n      k: {name: k, unit: m, draw: always 0.45}\n      h: {name: h, unit: m, draw: always 0.4}\n      W: {name: W, unit: N, draw: always 200}\n    scene:\n      bodies: {door: {weight: W, radius of gyration about the pin: k, moves: in the plane, angle: from right, mass centre: h}}\n      joints: {O: {pins: door.A}}\n      start: {door: {angle: 0 deg}}\n      end: at once\n    questions: {alpha: {ask: none, unit: rad/s^2}}\n";
    let alpha = |text: &str| {
        let bank = load::scenes_only(text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"));
        let solved =
            slipstick::solve::agree::solve(&bank.problems[0].cases[0].scene, &[0.45, 0.4, 200.0, 9.81]);
        crate::joined::value(&bank.problems[0].cases[0].scene, &solved.unwrap(), "alpha")
    };
    let expected = -9.81 * 0.4 / (0.45 * 0.45);
    all_near(&[alpha(text)], &[expected], 1e-13);
    let moment =
        text.replace("radius of gyration about the pin: k", "moment of inertia about the pin: W/g*k^2");
    all_near(&[alpha(&moment)], &[expected], 1e-13);
    let mixed =
        load::scenes_only(&text.replace("about the pin: k", "about the pin: 0.45 m"), "t.yaml").unwrap_err();
    assert!(mixed[0].to_string().contains("cannot be put about the mass centre"), "{mixed:?}");
    // What a sheet holds is read without these words.
    let bank = load::scenes_only(text, "t.yaml").unwrap();
    let variant = slipstick::problem::maker::Maker::new(&bank.problems[0], 1, "t").variant("s").unwrap();
    let sheet = Writer::new(&bank, text, &[0], "t", "en").unwrap().text("s", &[variant]);
    assert!(sheet.contains("sqrt((k)^2 - (h)^2)") && !sheet.contains("about the pin"), "{sheet}");
    assert!(sheet.contains("from right counter-clockwise"), "{sheet}");
}

/// A crank that is pinned beside others may count its angle from anywhere.
#[test]
fn a_pin_in_company() {
    let crank = "
bodies:
  AB: {mass: 6 kg, shape: {rod: 0.75 m}, pinned: at its end, angle: from the right, points: {B: its end}}
  BD: {mass: 6 kg, shape: {rod: 0.75 m}, moves: in the plane, points: {B: 0 m, D: its end}}
joints:
  B: {hinges: [AB.B, BD.B]}
  D: {guides: BD.D, along: horizontal}
start: {AB: {angle: 60 deg}}
end: {turn: {of: AB, by: -40 deg}}
";
    // Beer and Johnston, sample problem 17.4: 3.90 rad/s and 2.00 m/s, by T = 1.520 omega^2 and 22.9 J.
    let [high, low] = [60_f64, 20.0].map(f64::to_radians);
    let (length, mass, falls) = (0.75, 6.0, 0.75 * (high.sin() - low.sin()));
    // BD turns as fast as AB; its middle moves by this for a unit of the angle.
    let middle = (1.5 * length * low.sin()).powi(2) + (0.5 * length * low.cos()).powi(2);
    let inertia = mass * length * length * (1.0 / 3.0 + 1.0 / 12.0) + mass * middle;
    let omega = (2.0 * mass * 9.81 * falls / inertia).sqrt();
    all_near(
        &told(crank, &["AB.omega", "BD.omega", "BD.D.v"]),
        &[omega, omega, 2.0 * omega * length * low.sin()],
        1e-12,
    );
}

/// A rod with a disc at its end and a particle on it: both roads, against sums by hand, at rest, on the way and at its end; and by
/// the energy of its motion.
#[test]
fn what_is_welded_together() {
    let (rod, disc, bead) = (0.2, 2.0, 0.5);
    let pendulum = |start: &str, end: &str| {
        format!(
            "
bodies:
  rod: {{mass: 0.2 kg, shape: {{rod: 0.5 m}}, moves: in the plane, angle: from hanging, points: {{A: 0 m, B: 0.5 m, P: [0.1 m, 0.3 m]}}}}
  disc: {{mass: 2 kg, shape: {{disc: 0.3 m}}, moves: in the plane, points: {{T: -0.3 m}}}}
  bead: {{mass: 0.5 kg, moves: in the plane}}
joints:
  O: {{pins: rod.A, at: [1 m, 2 m]}}
  B: {{welds: [rod.B, disc.T]}}
  P: {{welds: [rod.P, bead]}}
start: {{rod: {{angle: {start}}}}}
end: {end}
"
        )
    };
    let inertia = rod * 0.25 / 3.0 + disc * (0.09 / 2.0 + 0.64) + bead * (0.01 + 0.09);
    let mass = rod + disc + bead;
    // Along the rod and to the left of it; hanging, that is down and to the right.
    let along = (rod * 0.25 + disc * 0.8 + bead * 0.1) / mass;
    let aside = bead * 0.3 / mass;
    let central = inertia - mass * (along * along + aside * aside);
    let names = ["I_O", "I_G", "x_G", "y_G"];
    let at = |angle: f64| {
        let (s, c) = f64::to_radians(angle).sin_cos();
        [inertia, central, 1.0 + along * s + aside * c, 2.0 - along * c + aside * s]
    };
    all_near(&told(&pendulum("0 deg", "at once"), &names), &at(0.0), 1e-13);
    all_near(&told(&pendulum("70 deg, spin: 2 rad/s", "at once"), &names), &at(70.0), 1e-13);
    let swings = pendulum("70 deg", "{angle: {of: rod, reaches: 10 deg}}");
    all_near(&told(&swings, &names), &at(10.0), 1e-13);
    let [energy, omega] = told(&swings, &["kinetic_energy", "rod.omega"])[..] else { panic!("two") };
    all_near(&[2.0 * energy / (omega * omega)], &[inertia], 1e-12);
    // A hinge leaves the disc free to turn: there is no such moment of inertia.
    let hinged =
        pendulum("0 deg", "at once").replace("B: {welds: [rod.B, disc.T]}", "B: {hinges: [rod.B, disc.T]}");
    let scene = constants(&hinged).problems[0].cases[0].scene.clone();
    assert!(slipstick::bank::labels::named(&scene, "I_O").is_err());
}

/// The numbers of a book are what they are: no usual limit of condition numbers refuses them, as it does drawn data.
#[test]
fn the_numbers_of_a_book() {
    let text = |draw: &str, more: &str| {
        format!(
            "bank: t\ntitle: t\nproblems:\n  p:\n    title: t\n    data: {{T: {{name: pull, unit: N, draw: {draw}}}}}\n    scene:\n      bodies: {{disc: {{mass: 15 kg, shape: {{disc: 0.5 m}}, radii: {{rim: 0.5 m}}, moves: vertically}}}}\n      ties: [cord: {{from: {{body: disc, wound on: rim, leaves: up}}, pulled with: T}}]\n      start: at rest\n      end: at once\n    questions: {{a: {{ask: none, unit: m/s^2{more}}}}}\n"
        )
    };
    let maker = |text: &str| {
        let bank = load::scenes_only(text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"));
        let problem = &bank.problems[0];
        (
            problem.questions[0].cond_limit,
            slipstick::problem::maker::Maker::new(problem, 1, "t").variant("s").is_ok(),
        )
    };
    assert_eq!(maker(&text("always 160", "")), (1000.0, true));
    assert_eq!(
        maker(&text("always 160", ", cond limit: 12")),
        (12.0, false),
        "23.9 is above what is written"
    );
    assert_eq!(maker(&text("160 to 161 step 1", "")), (10.0, false));
}

/// A radius of gyration about the pin that is smaller than the distance of the pin belongs to no body: that is said of the draw, with its data.
#[test]
fn a_radius_of_gyration_about_the_pin_is_no_smaller_than_its_distance() {
    for (inertia, unit, range, is, needs) in [
        (
            "radius of gyration about the pin: k",
            "m",
            "0.2 to 0.3 step 0.1",
            "k = 0.",
            "the radius of gyration about the pin must not be below the distance",
        ),
        (
            "moment of inertia about the pin: k",
            "kg*m^2",
            "0.2 to 0.3 step 0.1",
            "k = 0.",
            "the moment of inertia about the pin must not be below the mass times",
        ),
    ] {
        let text = format!(
            "
bank: b
title: B
problems:
  p:
    title: P
    data:
      m: {{name: mass, unit: kg, draw: 2 to 3 step 1}}
      k: {{name: inertia, unit: {unit}, draw: {range}}}
      h: {{name: distance of the pin, unit: mm, draw: 400 to 500 step 100}}
    scene:
      bodies: {{rod: {{mass: m, {inertia}, pinned: {{distance: h}}, angle: from hanging}}}}
      start: {{rod: {{angle: 90 deg}}}}
      end: {{turn: {{of: rod, by: -30 deg}}}}
    questions: {{omega: {{unit: rad/s, ask: the spin}}}}
"
        );
        let bank = load::scenes_only(&text, "b.yaml").unwrap_or_else(|found| panic!("{found:?}"));
        let refused =
            Maker::new(&bank.problems[0], 1, "b").giving_up_after(5).variant("0").unwrap_err().to_string();
        assert!(!refused.contains("NaN"), "{refused}");
        for part in [needs, is, "h = ", "00 mm"] {
            assert!(refused.contains(part), "{part}: {refused}");
        }
    }
}

/// A wrong method that changes the start alone of a motion that ends after a turn ends so far from its own start; one that changes the
/// turn turns so far from the right start.
#[test]
fn a_wrong_start_turns_as_far_as_the_right_one() {
    let text = "
bank: b
title: B
problems:
  p:
    title: P
    data:
      phi: {name: angle at the start, unit: deg, draw: always 90}
      by:  {name: turn, unit: deg, draw: always 30}
    scene:
      bodies: {rod: {mass: 2 kg, shape: {rod: 1.5 m}, pinned: at its end, angle: from hanging}}
      start: {rod: {angle: phi}}
      end: {turn: {of: rod, by: -by}}
    mistakes:
      start: {scene: {start: {rod: {angle: 60 deg}}}}
      turn:  {scene: {end: {turn: {of: rod, by: -50 deg}}}}
      both:  {scene: {start: {rod: {angle: 80 deg}}, end: {turn: {of: rod, by: -20 deg}}}}
    questions: {omega: {unit: rad/s, ask: the spin}}
";
    let bank = load::scenes_only(text, "b.yaml").unwrap_or_else(|found| panic!("{found:?}"));
    let problem = &bank.problems[0];
    let variant = Maker::new(problem, 1, "b").variant("0").unwrap_or_else(|e| panic!("{e}"));
    // I w^2 / 2 = m g L/2 (cos - cos)
    let spin =
        |from: f64, to: f64| (3.0 * 9.81 / 1.5 * (to.to_radians().cos() - from.to_radians().cos())).sqrt();
    let label = problem.questions[0].label;
    all_near(&[variant.solved.get(label).unwrap().value()], &[spin(90.0, 60.0)], 1e-13);
    let wrong = misconception::values(problem, 0, &variant.data, &variant.solved, &[label]);
    let of = |id: &str| {
        wrong.iter().find(|w| problem.mistakes[w.mistake].id == id).unwrap_or_else(|| panic!("{id}")).value
    };
    all_near(
        &["start", "turn", "both"].map(of),
        &[spin(60.0, 30.0), spin(90.0, 40.0), spin(80.0, 60.0)],
        1e-13,
    );
}

/// A hole counts negative: the whole about the pin less the hole about it, by the theorem of parallel axes, and the moment of the weights
/// likewise.
#[test]
fn a_disc_with_a_hole_that_swings() {
    let (m, r, a, c, g) = (6.0_f64, 0.3_f64, 0.08_f64, 0.12_f64, 9.81_f64);
    let hole = m * a * a / (r * r);
    let about_pin = 1.5 * m * r * r - hole * (a * a / 2.0 + (r + c) * (r + c));
    let moment = g * (m * r - hole * (r + c));
    let left = m - hole;
    let depth = moment / g / left;
    let scene = |removed: &str, end: &str| {
        format!(
            "
bodies:
  disc: {{mass: 6 kg, shape: {{disc: 0.3 m}}, moves: in the plane, angle: from hanging, mass centre: 0.3 m, points: {{A: 0 m, H: 0.42 m}}}}
  hole: {{{removed}: {hole} kg, shape: {{disc: 0.08 m}}, moves: in the plane}}
joints: {{O: {{pins: disc.A}}, cut: {{welds: [disc.H, hole.A]}}}}
start: {{disc: {{angle: 90 deg}}}}
end: {end}
"
        )
    };
    let period = 2.0 * std::f64::consts::PI * (about_pin / moment).sqrt();
    let found = told(&scene("mass removed", "equilibrium"), &["I_O", "I_G", "y_G", "disc.period_small"]);
    all_near(&found, &[about_pin, about_pin - left * depth * depth, -depth, period], 1e-12);
    // Down to hanging: energy, and the force of the pin on what is left.
    let found = told(
        &scene("mass removed", "{angle: {of: disc, reaches: 0 deg}}"),
        &["disc.omega", "O.pin_y", "kinetic_energy"],
    );
    let omega = (2.0 * moment / about_pin).sqrt();
    all_near(&found, &[omega, left * (g + omega * omega * depth), moment], 1e-12);
    // The same mass welded on is another body.
    let welded = told(&scene("mass", "equilibrium"), &["I_O"]);
    all_near(&welded, &[about_pin + 2.0 * (1.5 * m * r * r - about_pin)], 1e-12);
}

/// Set down with its hole to the right: about the place where it touches, the weight that lacks there turns it to the left.
#[test]
fn a_disc_with_a_hole_sets_off_on_a_floor() {
    let scene = "
bodies:
  disc: {mass: 6 kg, shape: {disc: 0.3 m}, moves: in the plane, angle: from right, placed: [0 m, 0.3 m], points: {C: 0 m, H: 0.15 m}}
  hole: {mass removed: 0.375 kg, shape: {disc: 0.075 m}, moves: in the plane}
joints: {floor: {rolls: disc.C, radius: 0.3 m, along: horizontal}, cut: {welds: [disc.H, hole.A]}}
start: {disc: {angle: 0 deg}}
end: at once
";
    let hole = 0.375 * (0.075 * 0.075 / 2.0 + 0.15 * 0.15 + 0.3 * 0.3);
    let alpha = 0.375 * 9.81 * 0.15 / (1.5 * 6.0 * 0.09 - hole);
    let found = told(scene, &["disc.alpha", "floor.normal"]);
    // The mass centre of what is left lies to the left of the centre, which does not rise.
    all_near(&found, &[alpha, 5.625 * 9.81 - 0.375 * 0.15 * alpha], 1e-12);
    // The disc alone does not say where that mass centre lies, and on what is not there nothing acts.
    let bank = constants(scene);
    let scene_read = &bank.problems[0].cases[0].scene;
    for name in ["disc.a_x", "disc.v", "disc.angular_momentum", "hole.omega"] {
        assert!(labels::named(scene_read, name).is_err(), "{name}");
    }
    for acts in [
        "force: {on: hole.A, magnitude: 1 N, direction: up}",
        "couple: {on: hole, moment: 1 N*m, sense: forward}",
    ] {
        let loaded = scene.replace("start:", &format!("forces: [{acts}]\nstart:"));
        assert!(format!("{:?}", read(&loaded)).contains("is taken away: nothing acts there"), "{acts}");
    }
    // Touching the rim it still lies within; farther out it does not.
    let at = |far: &str| format!("{:?}", read(&scene.replace("H: 0.15 m", far)));
    assert!(!at("H: 0.225 m").contains("reaches beyond"), "{}", at("H: 0.225 m"));
    for far in ["H: 0.23 m", "H: [0.15 m, 0.2 m]"] {
        assert!(at(far).contains("`hole` reaches beyond `disc`"), "{}", at(far));
    }
}

/// Two holes in a plate, one of them square, each by its own moment of inertia; and what cannot be taken away.
#[test]
fn a_plate_with_two_holes_at_an_instant() {
    let scene = |first: &str| {
        format!(
            "
bodies:
  plate: {{mass: 8 kg, moment of inertia: 0.6 kg*m^2, moves: in the plane, angle: from right, mass centre: 0 m, points: {{P: [-0.3 m, 0.2 m], U: [0.2 m, 0.1 m], V: [-0.1 m, -0.15 m]}}}}
  round: {{mass removed: {first}, shape: {{disc: 0.05 m}}, moves: in the plane}}
  square: {{mass removed: 0.4 kg, moment of inertia: 0.001 kg*m^2, moves: in the plane}}
joints:
  O: {{pins: plate.P}}
  u: {{welds: [plate.U, round.A]}}
  v: {{welds: [plate.V, square.A], turned: 30 deg}}
start: {{plate: {{angle: 0 deg}}}}
end: at once
"
        )
    };
    let holes = 0.3 * (0.05 * 0.05 / 2.0 + 0.5 * 0.5 + 0.1 * 0.1) + 0.001 + 0.4 * (0.2 * 0.2 + 0.35 * 0.35);
    let about_pin = 0.6 + 8.0 * (0.09 + 0.04) - holes;
    let moment = 8.0 * 0.3 - 0.3 * 0.5 - 0.4 * 0.2;
    let found = told(&scene("0.3 kg"), &["I_O", "plate.alpha"]);
    all_near(&found, &[about_pin, -moment * 9.81 / about_pin], 1e-12);
    let heavy = format!(
        "{:?}",
        read(&scene("9 kg")).map(|bank| {
            let case = &bank.problems[0].cases[0];
            slipstick::solve::agree::solve(&case.scene, &[9.81])
        })
    );
    assert!(heavy.contains("Inadmissible"), "{heavy}");
    let wide = read(&scene("7 kg"))
        .map(|bank| slipstick::solve::agree::solve(&bank.problems[0].cases[0].scene, &[9.81]));
    assert_eq!(wide.unwrap().unwrap_err(), slipstick::solve::outcome::Refusal::Hollow(0));
    let loose = scene("0.3 kg").replace("  u: {welds: [plate.U, round.A]}\n", "");
    let told = format!("{:?}", read(&loose).map(|_| ()));
    assert!(told.contains("`round` is taken away, and is not held by one weld alone"), "{told}");
    let both = scene("0.3 kg, mass: 0.3 kg");
    let told = format!("{:?}", read(&both).map(|_| ()));
    assert!(told.contains("`round` has a mass, and a mass that is taken away"), "{told}");
}
