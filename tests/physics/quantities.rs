//! Work, momentum, pin forces, ends by height and cord, and the forces of an instant, against values found by hand.
use crate::joined::{all_near, constants, told};
use slipstick::bank::{labels, load};
use slipstick::problem::maker::Maker;
use slipstick::solve::outcome::Solved;

/// A bank of one problem with one question.
fn bank(data: &str, scene: &str, question: &str) -> String {
    let lines =
        |text: &str| text.trim().lines().map(|l| format!("      {}\n", l.trim_start())).collect::<String>();
    let scene: String = scene.trim_matches('\n').lines().map(|l| format!("      {l}\n")).collect();
    format!(
        "bank: b\ntitle: B\ngravity: 9.8 m/s^2\nproblems:\n  p:\n    title: P\n    data:\n{}    scene:\n{scene}    questions:\n      \
         asked: {{quantity: {question}, ask: it}}\n",
        lines(data)
    )
}

/// The solution, and the value of a quantity on both roads, enclosed.
struct Told {
    bank: slipstick::bank::Bank,
    solved: Solved,
    case: usize,
    /// The last datum before g.
    mu: f64,
}

impl Told {
    fn of(text: &str) -> Self {
        Self::by(text, "0")
    }
    fn by(text: &str, student: &str) -> Self {
        let all = |found: slipstick::finding::Findings| {
            found.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
        };
        let bank = load::scenes_only(text, "b.yaml").map_err(all).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let maker = Maker::new(&bank.problems[0], 1, "quantities").giving_up_after(5);
        let variant = maker.variant(student).unwrap_or_else(|e| panic!("{e} {:?}\n{text}", e.unsolved));
        let mu = variant.data[variant.data.len() - 2];
        Self { solved: variant.solved, case: variant.case, mu, bank }
    }
    fn is(&self, name: &str, want: f64) {
        let scene = &self.bank.problems[0].cases[self.case].scene;
        let label = labels::named(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let entry = self.solved.get(label).unwrap_or_else(|| panic!("no {name}"));
        let near = 1e-13 * want.abs().max(entry.scale);
        for road in [entry.eom, entry.energy] {
            assert!((road.expect("both roads") - want).abs() <= near, "{name}: {entry:?}, {want} by hand");
        }
        assert!(entry.bound.is_some_and(|b| b <= near.max(1e-13)), "{name} is enclosed: {entry:?}");
    }
}

#[test]
fn a_braked_hoist_has_work_impulse_and_angular_momentum() {
    let data = "
        M: {name: drum, unit: kg, draw: always 8}
        R: {name: radius, unit: m, draw: always 0.25}
        m: {name: bucket, unit: kg, draw: always 6}
        C: {name: brake, unit: N*m, draw: always 2}
        L: {name: rope, unit: m, draw: always 3}";
    let scene = "
bodies:
  drum: {mass: M, shape: {disc: R}, radii: {rim: R}, moves: about a fixed axle}
  bucket: {mass: m, moves: vertically}
ties:
  - cord: {name: rope, from: {body: bucket, tied at: centre, leaves: up}, to: {body: drum, wound on: rim, leaves: back down}}
forces: [couple: {on: drum, moment: C, sense: forward}]
start: at rest
end: {unwinds: {cord: rope, by: L}}";
    let told = Told::of(&bank(data, scene, "work"));
    // (m + M/2) a = m g - C/R, over the length of the rope.
    let a = (6.0 * 9.8 - 8.0) / 10.0;
    let (v, t) = ((2.0 * a * 3.0_f64).sqrt(), (6.0 / a).sqrt());
    told.is("bucket.distance", 3.0);
    told.is("bucket.displacement", -3.0);
    told.is("t", t);
    told.is("work", 3.0 * 6.0 * 9.8 - 2.0 * 12.0);
    told.is("drum.work_couple", -24.0);
    told.is("drum.power_couple", -2.0 * v / 0.25);
    told.is("bucket.impulse", -6.0 * v);
    told.is("drum.angular_momentum", 0.5 * 8.0 * 0.25 * v);
}

#[test]
fn an_end_by_height_is_the_way_that_the_slope_gives() {
    let data = "
        m: {name: mass, unit: kg, draw: always 3}
        R: {name: radius, unit: m, draw: always 0.2}
        theta: {name: slope, unit: deg, draw: always 30}
        h: {name: height, unit: m, draw: always 0.7}";
    let scene = |positive: &str, end: &str| {
        format!(
            "
surfaces: {{incline: {{slope: theta}}}}
bodies: {{hoop: {{mass: m, shape: {{hoop: R}}, radii: {{rim: R}}, moves: along incline, positive: {positive}}}}}
ties: [rolls: {{body: hoop, on its: rim}}]
start: at rest
end: {end}"
        )
    };
    for positive in ["up", "down"] {
        let told = Told::of(&bank(data, &scene(positive, "{descent: {of: hoop, by: h}}"), "v"));
        told.is("v", (9.8 * 0.7_f64).sqrt());
        told.is("distance", 1.4);
        told.is("rise", -0.7);
    }
    let without = data.split("\n        h: ").next().unwrap_or_default();
    let constant = Told::of(&bank(without, &scene("up", "{descent: {of: hoop, by: 70 cm}}"), "v"));
    constant.is("v", (9.8 * 0.7_f64).sqrt());
    constant.is("distance", 1.4);
    // What is let go does not rise.
    let rises = bank(data, &scene("up", "{rise: {of: hoop, by: h}}"), "v");
    let bank = load::scenes_only(&rises, "b.yaml").expect("a bank");
    assert!(Maker::new(&bank.problems[0], 1, "q").giving_up_after(3).variant("0").is_err());
}

#[test]
fn a_ball_that_comes_back_has_moved_there_and_back() {
    let data = "
        m: {name: mass, unit: kg, draw: always 2}
        R: {name: radius, unit: m, draw: always 0.1}
        v0: {name: speed, unit: m/s, draw: always 2}
        w0: {name: backspin, unit: rad/s, draw: always 80}
        mu: {name: friction, unit: \"1\", draw: always 0.2}";
    let scene = "
surfaces: {floor: level}
bodies: {hoop: {mass: m, shape: {hoop: R}, radii: {rim: R}, moves: along floor}}
ties: [slips: {body: hoop, on its: rim, mu_s: mu, mu_k: mu}]
start: {hoop: {speed: v0, spin: -w0}}
end: {rolling: hoop}";
    let told = Told::of(&bank(data, scene, "distance"));
    // v = R omega after t: 2 - mu g t = -8 + mu g t, so mu g t = 5 and v = -3: out 4/(2 mu g), back 9/(2 mu g).
    let deceleration = 0.2 * 9.8;
    told.is("distance", (4.0 + 9.0) / (2.0 * deceleration));
    told.is("displacement", (4.0 - 9.0) / (2.0 * deceleration));
    told.is("impulse", -10.0);
    told.is("angular_momentum", 2.0 * 0.1 * 3.0);
}

#[test]
fn the_force_of_a_pin_has_parts_and_a_direction() {
    let data = "
        m: {name: mass, unit: kg, draw: always 6}
        L: {name: length, unit: m, draw: always 1.2}";
    let rod = |start: &str, end: &str| {
        format!(
            "
bodies: {{rod: {{mass: m, shape: {{rod: L}}, pinned: at its end, angle: from upright}}}}
start: {{rod: {{angle: {start}}}}}
end: {end}"
        )
    };
    // Let go from the horizontal: a quarter of the weight, straight up.
    let weight = 6.0 * 9.8;
    let level = Told::of(&bank(data, &rod("90 deg", "at once"), "pin_y"));
    level.is("pin_y", 0.25 * weight);
    level.is("pin_x", 0.0);
    level.is("pin_angle", std::f64::consts::FRAC_PI_2);
    // Fallen from upright to the horizontal: omega^2 = 3 g / L, so 3/2 of the weight toward the pin.
    let fallen = Told::of(&bank(data, &rod("0.0001 deg", "{angle: {of: rod, reaches: 90 deg}}"), "pin_x"));
    let share = 1.0_f64.min((1e-4_f64.to_radians()).cos());
    fallen.is("pin_x", -1.5 * weight * share);
    fallen.is("pin_y", 0.25 * weight);
    fallen.is("pin_angle", std::f64::consts::PI - (0.25 / (1.5 * share)).atan());
    let omega = (3.0 * 9.8 / 1.2 * share).sqrt();
    fallen.is("angular_momentum", 6.0 * 1.44 / 3.0 * omega);
}

#[test]
fn an_instant_has_accelerations_and_forces() {
    let data = "
        m: {name: mass, unit: kg, draw: always 3}
        M: {name: mass, unit: kg, draw: always 5}
        v: {name: speed, unit: m/s, draw: always 2}
        mu: {name: friction, unit: \"1\", draw: always 0.25}";
    let scene = |start: &str| {
        format!(
            "
surfaces: {{floor: level}}
bodies:
  sled: {{mass: m, moves: along floor}}
  load: {{mass: M, moves: vertically, positive: down}}
ties:
  - slides: {{body: sled, mu_k: mu}}
  - cord: {{from: {{body: sled, tied at: centre, leaves: forward}}, to: {{body: load, tied at: centre, leaves: up}}}}
start: {start}
end: at once"
        )
    };
    // The friction turns with the velocity; the acceleration is there whatever the velocity.
    for (start, sense) in [("{sled: {speed: v}}", 1.0), ("{sled: {speed: -v}}", -1.0), ("at rest", 1.0)] {
        let data = if start == "at rest" {
            data.replace("        v: {name: speed, unit: m/s, draw: always 2}\n", "")
        } else {
            data.to_owned()
        };
        let told = Told::of(&bank(&data, &scene(start), "sled.a"));
        let friction = 0.25 * 3.0 * 9.8 * sense;
        let a = (5.0 * 9.8 - friction) / 8.0;
        told.is("sled.a", a);
        told.is("load.a", a);
        told.is("friction", -friction);
        told.is("normal", 3.0 * 9.8);
        told.is("tension", 5.0 * (9.8 - a));
        assert!(told.solved.all_hold() && told.solved.regime.word() == "instant");
    }
}

#[test]
fn an_instant_rolls_only_where_friction_holds() {
    let data = "
        m: {name: mass, unit: kg, draw: always 3}
        R: {name: radius, unit: m, draw: always 0.2}
        theta: {name: slope, unit: deg, draw: always 30}
        mu: {name: friction, unit: \"1\", draw: \"one of 0.1, 0.3\"}";
    let scene = "
surfaces: {incline: {slope: theta}}
bodies: {disc: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: along incline, positive: down}}
ties: [touches: {body: disc, on its: rim, mu_s: mu, mu_k: mu}]
start: at rest
end: at once";
    // Rolling needs tan(30 deg)/3 = 0.192.
    let normal = 3.0 * 9.8 * 0.75_f64.sqrt();
    let text = bank(data, scene, "a");
    let mut seen = [0, 0];
    for student in 0..12 {
        let told = Told::by(&text, &student.to_string());
        let slips = told.mu < 0.192;
        let friction = if slips { told.mu * normal } else { 3.0 * 9.8 * 0.5 / 3.0 };
        told.is("friction", friction);
        told.is("a", 4.9 - friction / 3.0);
        seen[usize::from(slips)] += 1;
    }
    assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
}

/// At once: `P v` of a pull where its cord moves, `M omega` of couples, that of a drive among them.
#[test]
fn power_at_once() {
    let data = "
        P: {name: pull, unit: N, draw: always 10}
        C: {name: couple, unit: N*m, draw: always 3}";
    let scene = "
surfaces: {incline: {slope: 10 deg}}
bodies: {wheel: {mass: 5 kg, shape: {disc: 0.3 m}, radii: {rim: 0.3 m}, moves: along incline, positive: up}}
ties:
  - rolls: {body: wheel, on its: rim}
  - cord: {from: {body: wheel, wound on: rim, leaves: top forward}, pulled with: P}
forces: [couple: {on: wheel, moment: C, sense: back}]
start: {wheel: {speed: 2 m/s}}
end: at once
";
    // The top of the wheel is twice as fast as its centre.
    let rolls = Told::of(&bank(data, scene, "power_pull"));
    rolls.is("power_pull", 10.0 * 4.0);
    rolls.is("power_couple", -3.0 * 2.0 / 0.3);
    // A cord at an angle gives power along the surface alone.
    let tilted = scene.replace(
        "wound on: rim, leaves: top forward",
        "tied at: centre, leaves: forward, at an angle: 60 deg",
    );
    Told::of(&bank(data, &tilted, "power_pull")).is("power_pull", 10.0 * 0.5 * 2.0);
    let pendulum = "
bodies: {rod: {mass: 2 kg, shape: {rod: 1.2 m}, pinned: at its end, angle: from hanging}}
forces: [couple: {on: rod, moment: 5 N*m, sense: back}]
start: {rod: {angle: 30 deg, spin: 3 rad/s}}
end: at once
";
    all_near(&told(pendulum, &["power_couple"]), &[-15.0], 1e-13);
    // It takes I alpha + m g L/2 to drive a level rod.
    let driven = "
bodies: {rod: {mass: 2 kg, shape: {rod: 1.2 m}, moves: in the plane, angle: from right}}
joints: {O: {pins: rod.A}}
forces: [couple: {on: rod, moment: 4 N*m}]
start: {rod: {angle: 0 deg, spin: 3 rad/s, alpha: 2 rad/s^2}}
end: at once
";
    let all = 2.0 * 1.2 * 1.2 / 3.0 * 2.0 + 2.0 * 9.81 * 0.6;
    all_near(&told(driven, &["rod.drive", "rod.power_couple"]), &[all - 4.0, all * 3.0], 1e-13);
    // The couple on a rod that is hinged to a crank, as the crank passes over the top: the rod does not turn, then it turns the other way.
    for (angle, rate) in [(90.0_f64, 0.0), (0.0, -2.0)] {
        let linkage = format!(
            "
bodies:
  crank: {{mass: 1 kg, shape: {{rod: 0.3 m}}, moves: in the plane, angle: from right}}
  rod:   {{mass: 2 kg, shape: {{rod: 0.9 m}}, moves: in the plane}}
joints:
  O: {{pins: crank.A}}
  A: {{hinges: [crank.B, rod.A]}}
  B: {{guides: rod.B, along: horizontal}}
forces: [couple: {{on: rod, moment: 7 N*m}}]
start: {{crank: {{angle: {angle} deg, spin: 6 rad/s}}}}
end: at once
"
        );
        let power = told(&linkage, &["rod.power_couple"])[0];
        assert!((power - 7.0 * rate).abs() < 1e-12, "{power} at {angle}");
    }
}

/// The angle that is reached, counted as at the start, in time, to a speed and at rest.
#[test]
fn the_angle_at_the_end() {
    let arm = |angle: &str, start: &str, end: &str| {
        format!(
            "
bodies: {{arm: {{mass: 3 kg, shape: {{rod: 2 m}}, moves: in a horizontal plane, angle: {angle}}}}}
joints: {{O: {{pins: arm.A}}}}
forces: [couple: {{on: arm, moment: 2 N*m, sense: back}}]
start: {{arm: {start}}}
end: {end}
"
        )
    };
    // I = 4 kg m^2, so it slows down by 0.5 rad/s^2.
    let first = 30.0_f64.to_radians();
    for (end, turned) in [
        ("{time: {of: arm, is: 1.5 s}}", 2.0 * 1.5 - 0.25 * 1.5 * 1.5),
        ("{speed: {of: arm, reaches: 1 rad/s}}", 3.0),
        ("{turning point: arm}", 4.0),
    ] {
        for angle in ["from right", "from up", "from left clockwise"] {
            let scene = arm(angle, "{angle: 30 deg, spin: 2 rad/s}", end);
            all_near(&told(&scene, &["arm.angle"]), &[first + turned], 1e-13);
        }
    }
    // From rest it goes back.
    let back = arm("from hanging", "{angle: 30 deg}", "{time: {of: arm, is: 2 s}}");
    all_near(&told(&back, &["arm.angle"]), &[first - 1.0], 1e-13);
    // A pendulum comes to rest on the other side.
    let swing = "
bodies: {rod: {mass: 2 kg, shape: {rod: 1 m}, pinned: at its end, angle: from hanging}}
start: {rod: {angle: 40 deg}}
end: {turning point: rod}
";
    all_near(&told(swing, &["angle"]), &[-(40.0_f64.to_radians())], 1e-13);
    // What is told at the end, or of what is round, is not asked.
    let told_at_the_end = swing.replace("{turning point: rod}", "{angle: {of: rod, reaches: 0 deg}}");
    for scene in [
        told_at_the_end.as_str(),
        "
bodies: {wheel: {mass: 2 kg, shape: {disc: 0.3 m}, moves: in the plane, placed: [0 m, 0.3 m]}}
joints: {floor: {rolls: wheel, radius: 0.3 m, along: horizontal}}
start: {wheel: {speed: 2 m/s}}
end: {time: {of: wheel, is: 2 s}}
",
    ] {
        let scene = &constants(scene).problems[0].cases[0].scene;
        let hint = labels::named(scene, "angle").unwrap_err().1.unwrap_or_default();
        assert!(hint.contains("an end at a time"), "{hint}");
    }
}
