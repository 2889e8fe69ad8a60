//! A motion that follows another one: against closed forms, against the same motion in one piece, and what does not follow.
use slipstick::bank::{Problem, load};
use slipstick::problem::maker::Maker;
use slipstick::problem::variant::Variant;

use crate::support::seeds;

fn problem(text: &str) -> Problem {
    let bank = load::scenes_only(text, "bank.yaml").expect("a bank");
    bank.problems.into_iter().next().expect("a problem")
}

fn drawn(problem: &Problem, student: u32) -> Variant {
    Maker::new(problem, 7, "set").variant(&format!("s{student}")).expect("a variant")
}

/// The answers of a variant, both roads, with what their enclosures leave open.
fn answers(problem: &Problem, variant: &Variant) -> Vec<[f64; 2]> {
    let answer = |q: &slipstick::bank::Question| {
        let entry = variant.solved.get(q.label).expect("an answer");
        assert!(entry.bound.is_some(), "{} is enclosed", q.id);
        [entry.eom.expect("the first road"), entry.energy.expect("the second road")]
    };
    problem.questions.iter().map(answer).collect()
}

fn near(found: [f64; 2], exact: f64, what: &str) {
    for x in found {
        assert!((x - exact).abs() <= 2e-13 * exact.abs(), "{what}: {x} {exact}");
    }
}

const G: f64 = 9.81;

/// A scene of one body on an incline, with its data, ties, start and ends.
fn on_incline(body: &str, data: &str, scene: &str, questions: &str) -> String {
    format!(
        "bank: b
title: B
problems:
  p:
    title: P
    data:
      beta: {{name: slope, unit: deg, draw: 10 to 30 step 1}}
{data}
    scene:
      surfaces: {{incline: {{slope: beta}}}}
      bodies: {{it: {body}}}
{scene}
    questions:
{questions}
    statement: s
"
    )
}

#[test]
fn it_comes_back_with_what_friction_leaves() {
    let text = on_incline(
        "{mass: 2 kg, moves: along incline}",
        "      v0: {name: speed, unit: m/s, draw: 2 to 9 step 0.1}
      mu: {name: friction, unit: \"1\", draw: 0.05 to 0.12 step 0.01}",
        "      ties: [slides: {body: it, mu_s: mu, mu_k: mu}]
      start: {it: {speed: v0}}
      end: {turning point: it}
      next: {end: {position: {of: it, at: 0 m}}}",
        "      back: {quantity: v, motion: next, unit: m/s, ask: a}
      total: {value: t + next.t, unit: s, ask: a}
      way: {quantity: displacement, motion: next, unit: m, ask: a}",
    );
    let problem = problem(&text);
    for s in 0..seeds(1000) {
        let variant = drawn(&problem, s);
        let [beta, v0, mu, _] = variant.data[..] else { panic!("four data") };
        let (sine, cosine) = beta.to_radians().sin_cos();
        let (up, down) = (G * (sine + mu * cosine), G * (sine - mu * cosine));
        let way = v0 * v0 / (2.0 * up);
        let back = (2.0 * down * way).sqrt();
        let found = answers(&problem, &variant);
        for (found, exact) in found.into_iter().zip([back, v0 / up + back / down, -way]) {
            near(found, exact, "block");
        }
    }
}

/// A body whose positive sense is down its slope keeps it where it runs out on a level floor.
#[test]
fn it_runs_out_on_the_level() {
    let text = on_incline(
        "{mass: 2 kg, moves: along incline, positive: down}",
        "      d: {name: way, unit: m, draw: 1 to 4 step 0.1}
      mu: {name: friction, unit: \"1\", draw: 0.2 to 0.4 step 0.01}",
        "      start: at rest
      end: {travel: {of: it, by: d}}
      next:
        surfaces: {incline: level}
        ties: [slides: {body: it, mu_s: mu, mu_k: mu}]
        end: {turning point: it}",
        "      way: {quantity: displacement, motion: next, unit: m, ask: a}
      rubs: {quantity: friction, motion: next, unit: N, ask: a}",
    );
    let problem = problem(&text);
    for s in 0..seeds(1000) {
        let variant = drawn(&problem, s);
        let [beta, d, mu, _] = variant.data[..] else { panic!("four data") };
        let found = answers(&problem, &variant);
        near(found[0], d * beta.to_radians().sin() / mu, "way");
        near(found[1], mu * 2.0 * G, "friction");
    }
}

#[test]
fn a_time_counts_from_the_start_of_the_whole() {
    // Without friction the way there and back is one formula: x = v0 t - g sin(beta) t^2/2.
    let text = on_incline(
        "{mass: 2 kg, moves: along incline}",
        "      v0: {name: speed, unit: m/s, draw: 2 to 5 step 0.1}",
        "      start: {it: {speed: v0}}
      end: {turning point: it}
      next: {end: {time: {of: it, is: 7 s}}}",
        "      x: {value: displacement + next.displacement, unit: m, cond limit: 100, ask: a}
      later: {quantity: v, motion: next, unit: m/s, ask: a}",
    );
    let problem = problem(&text);
    for s in 0..seeds(1000) {
        let variant = drawn(&problem, s);
        let [beta, v0, _] = variant.data[..] else { panic!("three data") };
        let a = G * beta.to_radians().sin();
        let found = answers(&problem, &variant);
        near(found[0], v0 * 7.0 - a * 24.5, "place");
        near(found[1], a * 7.0 - v0, "speed");
    }
}

#[test]
fn a_ball_slips_then_rolls_up_a_slope() {
    let text = "bank: b
title: B
problems:
  p:
    title: P
    data:
      v0: {name: speed, unit: m/s, draw: 4.0 to 8.0 step 0.1}
      b: {name: slope, unit: deg, draw: 8 to 20 step 1}
    scene:
      surfaces: {lane: level}
      bodies: {ball: {mass: 3 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along lane}}
      ties: [slips: {body: ball, on its: rim, mu_s: 0.3, mu_k: 0.2}]
      start: {ball: {speed: v0, spin: 0 rad/s}}
      end: {rolling: ball}
      next:
        surfaces: {lane: {slope: b}}
        ties: [rolls: {body: ball, on its: rim, mu_s: 0.3}]
        end: {turning point: ball}
    questions:
      up: {quantity: displacement, motion: next, unit: m, ask: a}
    statement: s
";
    let problem = problem(text);
    for s in 0..seeds(1000) {
        let variant = drawn(&problem, s);
        let [v0, slope, _] = variant.data[..] else { panic!("three data") };
        let v = 5.0 / 7.0 * v0;
        near(answers(&problem, &variant)[0], 0.7 * v * v / (G * slope.to_radians().sin()), "ball");
    }
}

/// Scenes told in one piece and in two: the lines that differ, and what both are asked.
const PIECES: [(&str, &str, &str, &str); 5] = [
    // A spool pulled against a spring that could slacken.
    (
        "      surfaces: {floor: level}
      bodies: {it: {mass: 5 kg, radius of gyration: 0.3 m, radii: {rim: 0.4 m, hub: 0.2 m}, moves: along floor}}
      ties:
        - rolls: {body: it, on its: rim, mu_s: 0.9}
        - cord: {from: {body: it, wound on: hub, leaves: top forward}, spring: {stiffness: 100 N/m, stretch: d}}
      start: at rest",
        "{travel: {of: it, by: d/3}}",
        "{travel: {of: it, by: d/6}}",
        "{travel: {of: it, by: d/6}}",
    ),
    // A block that falls and turns a drum against a brake.
    (
        "      bodies:
        it: {mass: 5 kg, moves: vertically, positive: down}
        drum: {moment of inertia: 2 kg*m^2, radii: {rim: 0.4 m}, moves: about a fixed axle}
      ties:
        - cord: {from: {body: it, tied at: centre, leaves: back}, to: {body: drum, wound on: rim, leaves: front down}}
      forces: [couple: {on: drum, moment: 3 N*m, sense: back}]
      start: {it: {speed: 1 m/s}}",
        "{travel: {of: it, by: d}}",
        "{travel: {of: it, by: d/4}}",
        "{travel: {of: it, by: d*3/4}}",
    ),
    // A rod on a pin, over the bottom.
    (
        "      bodies: {it: {mass: 2 kg, shape: {rod: d}, pinned: at its end, angle: from hanging}}
      start: {it: {angle: 70 deg}}",
        "{angle: {of: it, reaches: \"-30 deg\"}}",
        "{angle: {of: it, reaches: 25 deg}}",
        "{angle: {of: it, reaches: \"-30 deg\"}}",
    ),
    // A spring that pulls at first and then pushes.
    (
        "      surfaces: {floor: level}
      bodies: {it: {mass: 5 kg, radius of gyration: 0.3 m, radii: {rim: 0.4 m}, moves: along floor}}
      ties:
        - rolls: {body: it, on its: rim, mu_s: 0.9}
        - cord: {from: {body: it, tied at: centre, leaves: forward}, spring: {stiffness: 200 N/m, stretch: d/2, attached: rigidly}}
      start: at rest",
        "{travel: {of: it, by: d*0.9}}",
        "{travel: {of: it, by: d*0.7}}",
        "{travel: {of: it, by: d*0.2}}",
    ),
    // A rod guided at both ends, with a spring between them.
    (
        "      bodies: {it: {mass: 2 kg, shape: {rod: d}, moves: in the plane, points: {A: 0 m, B: d}, angle: from right}}
      joints:
        floor: {guides: it.A, along: horizontal}
        wall: {guides: it.B, along: vertical}
      forces: [spring: {on: it.A, to: [0 m, 0 m], stiffness: 20 N/m, natural length: 0.1 m}]
      start: {it: {angle: 60 deg}}",
        "{angle: {of: it, reaches: 20 deg}}",
        "{angle: {of: it, reaches: 45 deg}}",
        "{angle: {of: it, reaches: 20 deg}}",
    ),
];

#[test]
fn two_pieces_are_the_whole() {
    for (scene, end, first, rest) in PIECES {
        let text = |end: &str, motion: &str, time: &str| {
            let v = if scene.contains("moves: vertically") || scene.contains("floor: level") {
                "v"
            } else {
                "omega"
            };
            let unit = if v == "v" { "m/s" } else { "rad/s" };
            let of = if scene.contains("drum") { "it." } else { "" };
            format!(
                "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n      d: {{name: length, unit: m, draw: 0.30 to 0.90 step 0.01}}
    scene:\n{scene}\n      {end}\n    questions:\n      rate: {{quantity: {of}{v}, {motion}unit: {unit}, cond limit: 50, ask: a}}
      total: {{value: {time}, unit: s, cond limit: 50, ask: a}}\n    statement: s\n"
            )
        };
        let whole = problem(&text(&format!("end: {end}"), "", "t"));
        let pieces = problem(&text(
            &format!("end: {first}\n      next: {{end: {rest}}}"),
            "motion: next, ",
            "t + next.t",
        ));
        for s in 0..seeds(200) {
            let (one, two) = (drawn(&whole, s), drawn(&pieces, s));
            assert_eq!(one.data, two.data);
            let value = |p: &Problem, v: &Variant, at: usize| {
                let entry = v.solved.get(p.questions[at].label).expect("an answer");
                [entry.eom.expect("the first road"), entry.energy.expect("the second road")]
            };
            for at in 0..2 {
                let exact = value(&whole, &one, at)[0];
                for x in value(&pieces, &two, at) {
                    assert!(
                        (x - exact).abs() <= 1e-14 * exact,
                        "{first}: {} {x} {exact}",
                        pieces.questions[at].id
                    );
                }
            }
        }
    }
}

#[test]
fn a_spring_keeps_its_own_number() {
    // The stiffness is worked out; so is, in the motion that follows, what is read before it.
    let text = on_incline(
        "{mass: 2 kg, moves: along incline}",
        "      ks: {name: stiffness, unit: N/m, draw: 300 to 500 step 10}",
        "      ties: [cord: {from: {body: it, tied at: centre, leaves: forward}, spring: {stiffness: 2*ks, stretch: 0.5 m}}]
      start: at rest
      end: {travel: {of: it, by: 0.1 m}}
      next:
        surfaces: {incline: {slope: beta*2}}
        end: {travel: {of: it, by: 0.2 m}}",
        "      later: {quantity: v, motion: next, unit: m/s, ask: a}
      pull: {quantity: tension, motion: next, unit: N, ask: a}",
    );
    let problem = problem(&text);
    for s in 0..seeds(200) {
        let variant = drawn(&problem, s);
        let [beta, ks, _] = variant.data[..] else { panic!("three data") };
        let (first, then) = (beta.to_radians().sin(), (2.0 * beta).to_radians().sin());
        let gained = ks * (0.25 - 0.04) - 2.0 * G * (0.1 * first + 0.2 * then);
        let found = answers(&problem, &variant);
        near(found[0], gained.sqrt(), "speed");
        near(found[1], 0.4 * ks, "tension");
    }
}

#[test]
fn what_does_not_follow_is_refused() {
    // Still slipping, it cannot be said to roll; held by friction, it does not come back.
    let jolt = on_incline(
        "{mass: 3 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along incline, positive: down}",
        "",
        "      ties: [slips: {body: it, on its: rim, mu_s: 0.3, mu_k: 0.2}]
      start: {it: {speed: 5 m/s, spin: 0 rad/s}}
      end: {time: {of: it, is: 0.1 s}}
      next: {ties: [rolls: {body: it, on its: rim, mu_s: 0.3}], end: {time: {of: it, is: 1 s}}}",
        "      x: {quantity: displacement, motion: next, unit: m, ask: a}",
    );
    let held = on_incline(
        "{mass: 2 kg, moves: along incline}",
        "",
        "      ties: [slides: {body: it, mu_s: 0.8, mu_k: 0.8}]
      start: {it: {speed: 5 m/s}}
      end: {turning point: it}
      next: {end: {position: {of: it, at: 0 m}}}",
        "      x: {quantity: v, motion: next, unit: m/s, ask: a}",
    );
    // A hoop with back spin moves as fast as its rim turns, the other way: it does not roll.
    let back = on_incline(
        "{mass: 3 kg, shape: {hoop: 0.1 m}, radii: {rim: 0.1 m}, moves: along incline, positive: down}",
        "",
        "      ties: [slips: {body: it, on its: rim, mu_s: 0.3, mu_k: 0.2}]
      start: {it: {speed: 5 m/s, spin: \"-50 rad/s\"}}
      end: {time: {of: it, is: 0.5 s}}
      next: {ties: [rolls: {body: it, on its: rim, mu_s: 0.3}], end: {time: {of: it, is: 1 s}}}",
        "      x: {quantity: displacement, motion: next, unit: m, ask: a}",
    )
    .replace("slope: beta", "slope: 0*beta");
    // It rolled down, and is to unwind from a cord at its top as fast: so it would have to turn the other way.
    let turned = on_incline(
        "{mass: 3 kg, shape: {disc: 0.1 m}, radii: {rim: 0.1 m}, moves: along incline, positive: down}",
        "",
        "      ties: [rolls: {body: it, on its: rim, mu_s: 0.9}]
      start: at rest
      end: {travel: {of: it, by: 1 m}}
      next: {ties: [cord: {from: {body: it, wound on: rim, leaves: top back}, held: fast}], end: {travel: {of: it, by: 1 m}}}",
        "      x: {quantity: v, motion: next, unit: m/s, ask: a}",
    );
    // It coasts beyond the natural length of its spring; where it turns, the cord is slack.
    let slack = |by: &str| {
        on_incline(
            "{mass: 2 kg, moves: along incline}",
            "",
            &format!(
                "      ties: [cord: {{from: {{body: it, tied at: centre, leaves: forward}}, spring: {{stiffness: 900 N/m, stretch: 0.3 m}}}}]
      start: at rest
      end: {{turning point: it}}
      next: {{end: {{travel: {{of: it, by: {by}}}}}}}"
            ),
            "      x: {quantity: v, motion: next, unit: m/s, ask: a}",
        )
    };
    let (near, far) = (slack("0.001 m"), slack("1 m"));
    // What is taken over is not told in other units than those of the bank.
    let huge = slack("0.001 m")
        .replace("mass: 2 kg", "mass: 2e31 kg")
        .replace("900 N/m", "9e33 N/m")
        .replace("{turning point: it}", "{travel: {of: it, by: 0.1 m}}");
    let all = [
        (jolt, "contradicts the ties"),
        (held, "next"),
        (back, "contradicts the ties"),
        (turned, "contradicts the ties"),
    ];
    for (text, why) in all.into_iter().chain([near, far, huge].map(|slack| (slack, "cannot be solved"))) {
        let problem = problem(&text);
        let none = Maker::new(&problem, 7, "set").giving_up_after(20).variant("s").expect_err(why);
        assert!(none.table.iter().any(|(rule, _)| rule.contains(why)), "{:?}", none.table);
    }
}

#[test]
fn bodies_stay_where_they_are() {
    let ladder = |next: &str| {
        format!(
            "bank: b
title: B
problems:
  p:
    title: P
    data:
      d: {{name: length, unit: m, draw: 0.30 to 0.90 step 0.01}}
    scene:
      bodies: {{it: {{mass: 2 kg, shape: {{rod: d}}, moves: in the plane, angle: from right}}}}
      joints:
        floor: {{guides: it.A, along: horizontal}}
        wall: {{guides: it.B, along: vertical}}
      start: {{it: {{angle: 60 deg}}}}
      end: {{angle: {{of: it, reaches: 45 deg}}}}
      next: {{{next}end: {{angle: {{of: it, reaches: 20 deg}}}}}}
    questions:
      x: {{quantity: omega, motion: next, unit: rad/s, ask: a}}
    statement: s
"
        )
    };
    let moved = "joints: {floor: {guides: it.A, along: horizontal, through: [0 m, 1 m]}, wall: {guides: it.B, along: vertical}}, ";
    let problem = problem(&ladder(moved));
    let none = Maker::new(&problem, 7, "set").giving_up_after(20).variant("s").expect_err("moved");
    assert!(none.table.iter().any(|(rule, _)| rule.contains("cannot be solved")), "{:?}", none.table);
    let other =
        ladder("bodies: {it: {mass: 1 kg, shape: {rod: d}, moves: in the plane, angle: from left}}, ");
    let findings = load::scenes_only(&other, "bank.yaml").expect_err("other bodies");
    assert!(findings[0].to_string().contains("`bodies` is not written here"), "{findings:?}");
    let timeless = on_incline(
        "{mass: 2 kg, moves: along incline}",
        "",
        "      ties: [cord: {from: {body: it, tied at: centre, leaves: forward}, pulled with: 60 N, growing by: {rate: 5 N/m, with: x}}]
      start: at rest
      end: {travel: {of: it, by: 1 m}}
      next: {ties: [], end: {time: {of: it, is: 3 s}}}",
        "      x: {quantity: v, motion: next, unit: m/s, ask: a}",
    );
    let findings = load::scenes_only(&timeless, "bank.yaml").expect_err("no time");
    assert!(findings[0].to_string().contains("the time is not told"), "{findings:?}");
}

/// Launched by one spring, stopped by another, which has the stretch that is given of it: `1/2 k1 0.2^2 - 1/2 k1 0.1^2` runs up against
/// `1/2 k2 ((x - D)^2 - x^2)`. Tests before this one had one spring in both motions.
#[test]
fn another_spring_keeps_its_own_stretch() {
    let text = |name: &str, leaves: &str, stretch: &str| {
        on_incline(
            "{mass: m, moves: along incline}",
            "      x: {name: stretch, unit: m, draw: 0.10 to 0.50 step 0.01}",
            &format!(
                "      ties: [cord: {{name: left, from: {{body: it, tied at: centre, leaves: back}}, spring: {{stiffness: 100 N/m, stretch: -0.2 m, attached: rigidly}}}}]
      start: at rest
      end: {{travel: {{of: it, by: 0.1 m}}}}
      next:
        ties: [cord: {{name: {name}, from: {{body: it, tied at: centre, leaves: {leaves}}}, spring: {{stiffness: 50 N/m, stretch: {stretch}, attached: rigidly}}}}]
        end: {{turning point: it}}"
            ),
            "      way: {quantity: displacement, motion: next, unit: m, ask: a}",
        )
        .replace("beta: {name: slope, unit: deg, draw: 10 to 30 step 1}", "m: {name: mass, unit: kg, draw: always 2}")
        .replace("{slope: beta}", "level")
    };
    for name in ["right", "left"] {
        let problem = problem(&text(name, "forward", "x"));
        for s in 0..seeds(50) {
            let variant = drawn(&problem, s);
            let x = variant.data[1];
            near(answers(&problem, &variant)[0], x + (x * x + 2.0 * 1.5 / 50.0).sqrt(), "way");
        }
    }
    let findings = load::scenes_only(&text("left", "back", "x"), "bank.yaml").expect_err("two stretches");
    assert!(findings[0].to_string().contains("goes on with the stretch that it has"), "{findings:?}");
    let told = load::scenes_only(&text("left", "back", "-0.2 m"), "bank.yaml").expect_err("no use of x");
    assert!(told.len() == 1 && told[0].to_string().contains("`x` is drawn"), "{told:?}");
}

/// What still slips goes on with its speed and its spin, each in a sense of its own: a ball with backspin, cut in two where it still goes
/// forward and where it turns, goes back and rolls.
#[test]
fn what_slips_goes_on_slipping() {
    let text = |end: &str| {
        format!(
            "bank: b
title: B
problems:
  p:
    title: P
    data:
      v0: {{name: speed, unit: m/s, draw: 2.00 to 2.50 step 0.01}}
      w0: {{name: spin, unit: rad/s, draw: 70 to 80 step 1}}
    scene:
      surfaces: {{lane: level}}
      bodies: {{ball: {{mass: 3 kg, shape: {{sphere: 0.1 m}}, moves: along lane}}}}
      ties: [slips: {{body: ball, on its: rim, mu_s: 0.3, mu_k: 0.2}}]
      start: {{ball: {{speed: v0, spin: -w0}}}}
      end: {end}
      next: {{end: {{rolling: ball}}}}
    questions:
      back: {{quantity: v, motion: next, unit: m/s, cond limit: 100, ask: a}}
      late: {{quantity: t, motion: next, unit: s, ask: a}}
      x: {{value: displacement + next.displacement, unit: m, cond limit: 100, ask: a}}
      slips: {{value: slip_distance + next.slip_distance, unit: m, ask: a}}
    statement: s
"
        )
    };
    for (end, turns) in [("{time: {of: ball, is: 0.3 s}}", false), ("{turning point: ball}", true)] {
        let problem = problem(&text(end));
        for s in 0..seeds(200) {
            let variant = drawn(&problem, s);
            let [v0, w0, _] = variant.data[..] else { panic!("three data") };
            let rolls = (v0 + 0.1 * w0) / (0.7 * G);
            let first = if turns { v0 / (0.2 * G) } else { 0.3 };
            let found = answers(&problem, &variant);
            near(found[0], (0.2 * w0 - 5.0 * v0) / 7.0, "speed");
            near(found[1], rolls - first, "time");
            near(found[2], v0 * rolls - 0.1 * G * rolls * rolls, "way");
            near(found[3], (v0 + 0.1 * w0) * rolls / 2.0, "slip");
        }
    }
}

/// Two crates that slide each by itself go on so, up to where both stay.
#[test]
fn several_bodies_go_on_each_with_its_speed() {
    let text = "bank: b
title: B
problems:
  p:
    title: P
    data:
      v0: {name: speed, unit: m/s, draw: 1.00 to 1.50 step 0.01}
      u0: {name: speed, unit: m/s, draw: 0.90 to 1.00 step 0.01}
    scene:
      surfaces: {ramp: {slope: 20 deg}}
      bodies: {one: {mass: 2 kg, moves: along ramp}, other: {mass: 3 kg, moves: along ramp}}
      ties:
        - slides: {body: one, mu_s: 0.5, mu_k: 0.2}
        - slides: {body: other, mu_s: 0.5, mu_k: 0.4}
      start: {one: {speed: v0}, other: {speed: u0}}
      end: {time: {of: one, is: 0.1 s}}
      next: {end: {stops slipping: one}}
    questions:
      late: {quantity: t, motion: next, unit: s, ask: a}
      x: {quantity: one.displacement, motion: next, unit: m, cond limit: 100, ask: a}
      y: {quantity: other.displacement, motion: next, unit: m, cond limit: 100, ask: a}
    statement: s
";
    let problem = problem(text);
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let [a, b] = [0.2, 0.4].map(|mu| G * (sin + mu * cos));
    for s in 0..seeds(200) {
        let variant = drawn(&problem, s);
        let [v0, u0, _] = variant.data[..] else { panic!("three data") };
        let found = answers(&problem, &variant);
        near(found[0], v0 / a - 0.1, "time");
        near(found[1], (v0 - 0.1 * a) * (v0 - 0.1 * a) / (2.0 * a), "way");
        near(found[2], (u0 - 0.1 * b) * (u0 - 0.1 * b) / (2.0 * b), "way of the other");
    }
}

/// The cord between a crate and a load is cut: both go on as fast as they are, the crate up to where it stays.
#[test]
fn a_cord_is_cut_and_both_bodies_go_on() {
    let text = "bank: b
title: B
problems:
  p:
    title: P
    data:
      d: {name: way, unit: m, draw: 1.0 to 4.0 step 0.1}
    scene:
      surfaces: {floor: level}
      bodies: {crate: {mass: 3 kg, moves: along floor}, load: {mass: 2 kg, moves: vertically, positive: down}}
      ties:
        - slides: {body: crate, mu_k: 0.2}
        - cord: {from: {body: crate, tied at: centre, leaves: forward}, to: {body: load, tied at: centre, leaves: up}}
      start: {load: {speed: 2 m/s}}
      end: {travel: {of: load, by: d}}
      next: {ties: [slides: {body: crate, mu_k: 0.2}], end: {turning point: crate}}
    questions:
      way: {quantity: crate.displacement, motion: next, unit: m, ask: a}
      falls: {quantity: load.v, motion: next, unit: m/s, ask: a}
    statement: s
";
    let problem = problem(text);
    for s in 0..seeds(200) {
        let variant = drawn(&problem, s);
        let square = 4.0 + 2.0 * (2.0 - 0.6) / 5.0 * G * variant.data[0];
        let found = answers(&problem, &variant);
        near(found[0], square / (0.4 * G), "crate");
        near(found[1], square.sqrt() * (1.0 + 1.0 / 0.2), "load");
    }
}
