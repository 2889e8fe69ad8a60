//! Inverse questions whose range runs past a limit: the least speed with which a body gets there, the height from which it tips, the friction
//! that holds it. What is found is told by hand; that it is the only value is proved, or refused before anything is drawn.
use slipstick::bank::load;
use slipstick::finding::Finding;
use slipstick::problem::maker::Maker;
use slipstick::solve::outcome::Solved;

const G: f64 = 9.81;

/// A bank of one problem, its data and its scene in the text.
fn bank(text: &str, question: &str) -> String {
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n{text}    questions: {{x: {{value: {question}, ask: x}}}}\n    statement: s\n"
    )
}

/// For some students the data, in the order of the bank, and what is found.
fn found(text: &str, question: &str, check: impl Fn(&[f64], f64)) {
    let bank = load::scenes_only(&bank(text, question), "b.yaml").unwrap_or_else(|found| panic!("{found:?}"));
    let problem = &bank.problems[0];
    let maker = Maker::new(problem, 3, "set").giving_up_after(40);
    for student in 0..8 {
        let variant = maker.variant(&format!("s{student}")).unwrap_or_else(|why| panic!("{why}"));
        let solved: &Solved = &variant.solved;
        let entry = solved.get(problem.questions[0].label).expect("an answer");
        assert!(entry.eom.is_some() && entry.energy.is_some(), "both roads find it");
        assert!(entry.bound.is_some_and(|b| b <= 1e-8 * entry.value().abs()), "it is enclosed: {entry:?}");
        check(&variant.data, entry.value());
    }
}

fn near(a: f64, b: f64, share: f64) {
    assert!((a - b).abs() <= share * b.abs(), "{a} against {b}");
}

/// `w0^2 = w1^2 + 6 g/L`: with less it does not get over the top, and the range begins far below.
#[test]
fn the_least_spin_of_a_bar_that_passes_the_top() {
    let text = "    data:
      L: {name: L, unit: m, draw: 1.0 to 1.4 step 0.05}
      w1: {name: w1, unit: rad/s, draw: 0.1 to 0.5 step 0.1, measured: omega}
      w0: {name: w0, unit: rad/s, unknown: 3 to 12 step 0.1}
    scene:
      bodies: {bar: {mass: 5 kg, shape: {rod: L}, moves: in the plane, angle: from hanging}}
      joints: {O: {pins: bar.A}}
      start: {bar: {angle: 0 deg, spin: w0}}
      end: {angle: {of: bar, reaches: 180 deg}}
";
    found(text, "w0, unit: rad/s", |data, w0| {
        near(w0, (data[1] * data[1] + 6.0 * G / data[0]).sqrt(), 1e-13);
    });
}

/// A block strikes a step and just gets upright on it: momentum about the edge, then energy. That it hardly turns there leaves the last
/// digits of everything else, asked or not, to the roads.
#[test]
fn the_least_speed_of_a_block_that_tips_over_a_step() {
    let text = "    data:
      m: {name: m, unit: kg, draw: 5 to 15 step 0.5}
      b: {name: b, unit: m, draw: 0.25 to 0.35 step 0.01}
      c: {name: c, unit: m, draw: 0.40 to 0.55 step 0.01}
      w1: {name: w1, unit: rad/s, draw: always 0.001, measured: omega}
      v: {name: v, unit: m/s, unknown: 0.8 to 4 step 0.01}
    scene:
      bodies: {block: {mass: m, moment of inertia: m*(b^2 + c^2)/12, moves: in the plane, angle: from right, mass centre: b/2, placed: [-b, c/2], points: {O: [b, -c/2]}}}
      joints: {O: {pins: block.O}}
      start: {block: {angle: 0 deg, arrives: {speed: v, direction: right}}}
      end: {turn: {of: block, by: -atan(b/c)}}
";
    found(text, "v, unit: m/s", |data, v| {
        let [_, b, c, w1, ..] = *data else { panic!("data") };
        let diagonal = (b * b + c * c).sqrt();
        let per_mass = diagonal * diagonal / 3.0;
        let w0 = (w1 * w1 + G * (diagonal - c) / per_mass).sqrt();
        near(v, per_mass * w0 / (c / 2.0), 1e-13);
    });
}

/// `N = 0` behind: higher up it tips, and what its friction would then be does not happen.
#[test]
fn the_height_at_which_a_cabinet_is_pushed_over() {
    let text = "    data:
      b: {name: b, unit: m, draw: 0.50 to 0.65 step 0.01}
      P: {name: P, unit: N, draw: 200 to 300 step 10}
      N: {name: N, unit: N, draw: always 0, measured: rear.normal}
      y: {name: y, unit: m, unknown: 0.5 to 1.5 step 0.01}
    scene:
      bodies: {cabinet: {mass: 50 kg, moment of inertia: 10 kg*m^2, moves: in the plane, angle: from up counter-clockwise, mass centre: 0.75 m, placed: [0 m, 0 m], points: {R: [0 m, b/2], F: [0 m, -b/2], P: [y, b/2]}}}
      joints:
        rear: {guides: cabinet.R, along: horizontal, pushes: up, mu_k: 0.3}
        front: {guides: cabinet.F, along: horizontal, pushes: up, mu_k: 0.3}
      forces: [force: {on: cabinet.P, magnitude: P, direction: right}]
      start: {cabinet: {angle: 0 deg}}
      end: at once
";
    found(text, "y, unit: m", |data, y| {
        let weight = 50.0 * G;
        near(y, 0.75 + weight * (data[0] / 2.0 - 0.3 * 0.75) / data[1], 1e-13);
    });
}

/// Two guides at the same drawn angle: `F = m (a + g sin th)`. Enclosures of an angle do not see that its two normals are one; nor, where
/// the points lie beside the axis, that the normal does not turn it.
#[test]
fn a_force_on_two_parallel_guides_of_a_drawn_slope() {
    let text = |slope: &str, along: &str, place: &str, points: &str| {
        format!(
            "    data:
      {slope}
      h: {{name: h, unit: m, draw: 0.5 to 0.7 step 0.01}}
      a: {{name: a, unit: m/s^2, draw: 1.0 to 2.0 step 0.1, measured: a_x/cos({along})}}
      F: {{name: F, unit: N, unknown: 5 to 60 step 1}}
    scene:
      bodies: {{plate: {{mass: 4 kg, moment of inertia: 1 kg*m^2, moves: in the plane, angle: from right, placed: [{place}], points: {{{points}}}}}}}
      joints:
        a: {{guides: plate.R, along: {along}}}
        b: {{guides: plate.F, along: {along}}}
      forces: [force: {{on: plate.R, magnitude: F, from the axis: 0 deg}}]
      start: {{plate: {{angle: {along}}}}}
      end: at once
"
        )
    };
    let force = |slope: f64, a: f64| 4.0 * (a + G * libm::sin(slope));
    let slope = "th: {name: th, unit: deg, draw: 15 to 30 step 1}";
    let on_the_axis = text(slope, "th", "0 m, 0 m", "R: 0 m, F: h");
    found(&on_the_axis, "F, unit: N", |data, f| near(f, force(data[0].to_radians(), data[2]), 1e-13));
    let grade = "n: {name: n, unit: '1', draw: 0.10 to 0.30 step 0.01}";
    let place = "-h*sin(atan(n)), h*cos(atan(n))";
    let beside = text(grade, "atan(n)", place, "R: [0 m, -h], F: [3 m, -h]");
    found(&beside, "F, unit: N", |data, f| near(f, force(libm::atan(data[0]), data[2]), 1e-13));
}

/// A ladder at a rough wall on a rough floor: with more friction than `tan 15 deg` it stays, and has no acceleration to measure.
#[test]
fn the_friction_of_a_ladder_that_more_of_it_would_hold() {
    let text = "    data:
      L: {name: L, unit: m, draw: 1.5 to 2.5 step 0.1}
      a: {name: a, unit: rad/s^2, draw: 0.5 to 2.0 step 0.1, measured: alpha}
      mu: {name: mu, unit: '1', unknown: 0.01 to 0.6 step 0.01}
    scene:
      bodies: {ladder: {mass: 4 kg, shape: {rod: L}, moves: in the plane, angle: from vertical clockwise}}
      joints:
        a: {guides: ladder.A, along: horizontal, pushes: up, mu_k: mu}
        b: {guides: ladder.B, along: vertical, pushes: left, mu_k: mu}
      start: {ladder: {angle: 30 deg}}
      end: at once
";
    found(text, "mu, unit: '1'", |data, mu| {
        let (s, c) = (0.5, 0.75_f64.sqrt());
        // m a_G of the middle of the ladder; on the floor N, at the wall W.
        let k = 4.0 * data[1] * data[0] / 2.0;
        let normal = (4.0 * G - k * s - mu * k * c) / (1.0 + mu * mu);
        let wall = mu * normal + k * c;
        let moments = (s - mu * c) * normal - (c + mu * s) * wall;
        assert!((k / 3.0 - moments).abs() < 1e-11 * k, "{mu}: {} against {moments}", k / 3.0);
    });
}

/// What is followed in steps or summed is enclosed by nothing: no draw would be accepted, and each is looked at for long.
#[test]
fn what_no_draw_could_prove_is_refused_at_once() {
    let ladder = |mu: &str, measured: &str| {
        let text = format!(
            "    data:
      w: {{name: w, unit: {measured}}}
      M: {{name: M, unit: kg, draw: always 4}}
      mu: {{name: mu, unit: '1', unknown: 0.05 to 0.25 step 0.01}}
    scene:
      bodies: {{ladder: {{mass: M*mu, shape: {{rod: 2 m}}, moves: in the plane, angle: from vertical clockwise}}}}
      joints:
        a: {{guides: ladder.A, along: horizontal, pushes: up{mu}}}
        b: {{guides: ladder.B, along: vertical, pushes: left}}
      start: {{ladder: {{angle: 30 deg}}}}
      end: {{angle: {{of: ladder, reaches: 40 deg}}}}
"
        );
        let found = load::scenes_only(&bank(&text, "mu, unit: '1'"), "b.yaml").expect_err("refused");
        let found: Vec<String> = found.iter().map(Finding::to_string).collect();
        let found = found.join("\n");
        found.split_once("problems.").map(|(_, what)| what.to_owned()).expect("where it stands")
    };
    let rough = ladder(", mu_k: mu", "rad/s, draw: 0.7 to 0.9 step 0.05, measured: omega");
    let timed = ladder("", "s, draw: 0.4 to 0.5 step 0.01, measured: t");
    let hint = "\n    hint: measure a speed where nothing rubs on the way, or look at an instant: `end: at once`; or give this datum and ask for what was measured";
    let told = |name: &str, why: &str| {
        format!("p.data.w.measured: that only one value of `mu` gives `{name}` cannot be proved {why}{hint}")
    };
    assert_eq!(rough, told("omega", "after friction on the way"));
    assert_eq!(timed, told("t", "from a time"));
}
