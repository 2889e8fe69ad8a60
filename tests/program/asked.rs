//! What is asked can be drawn and is proved: every kind of end, every quantity that the solver gives, zeros among them.
use slipstick::bank::{Bank, labels, load};
use slipstick::problem::maker::{Maker, Variant};
use slipstick::scene::{Owner, Quantity, Scene};
use std::fmt::Write as _;

/// Name, data by symbol (unit and draw), scene without its end.
type Kind = (&'static str, &'static [(&'static str, &'static str, &'static str)], &'static str);

const MASS: (&str, &str, &str) = ("m", "kg", "2 to 20 step 0.5");
const RADIUS: (&str, &str, &str) = ("R", "m", "0.20 to 0.40 step 0.01");
const GYRATION: (&str, &str, &str) = ("k", "m", "0.12 to 0.18 step 0.01");
const SLOPE: (&str, &str, &str) = ("theta", "deg", "10 to 30 step 1");
const SPEED: (&str, &str, &str) = ("v0", "m/s", "1.0 to 4.0 step 0.1");
const ROUGH: (&str, &str, &str) = ("mu_s", "1", "3 to 4 step 1");
const STIFF: (&str, &str, &str) = ("ks", "N/m", "400 to 800 step 10");

const WHEEL: &str =
    "wheel: {mass: m, radius of gyration: k, radii: {rim: R, hub: 0.1 m}, moves: along track}";

/// A wheel whose cord a spring holds; its stretch says which way it goes.
const SPRING_BY_CORD: &str = "surfaces: {track: {slope: theta}}
bodies: {WHEEL}
ties:
  - rolls: {body: wheel, on its: rim, mu_s: mu_s}
  - cord: {from: {body: wheel, wound on: hub, leaves: top forward}, spring: {stiffness: ks, stretch: x0, attached: by the cord}}
start: at rest";

/// Bodies that move under a force, each with ends at rest.
const MOVING: &[Kind] = &[
    (
        "crate thrown up",
        &[MASS, SLOPE, SPEED, ("mu", "1", "0.10 to 0.40 step 0.01")],
        "surfaces: {track: {slope: theta}}
bodies: {wheel: {mass: m, moves: along track, positive: up}}
ties: [slides: {body: wheel, mu_k: mu}]
start: {wheel: {speed: v0}}",
    ),
    (
        "crate on a floor",
        &[MASS, SPEED, ("mu", "1", "0.10 to 0.40 step 0.01")],
        "surfaces: {track: level}
bodies: {wheel: {mass: m, moves: along track}}
ties: [slides: {body: wheel, mu_k: mu}]
start: {wheel: {speed: v0}}",
    ),
    (
        "wheel rolls up",
        &[MASS, RADIUS, GYRATION, SLOPE, SPEED, ROUGH],
        "surfaces: {track: {slope: theta}}
bodies: {WHEEL}
ties: [rolls: {body: wheel, on its: rim, mu_s: mu_s}]
start: {wheel: {speed: v0}}",
    ),
    (
        "wheel pulled and thrown against it",
        &[MASS, RADIUS, GYRATION, SPEED, ROUGH, ("P", "N", "5 to 40 step 1")],
        "surfaces: {track: level}
bodies: {WHEEL}
ties:
  - rolls: {body: wheel, on its: rim, mu_s: mu_s}
  - cord: {from: {body: wheel, wound on: hub, leaves: top back}, pulled with: P}
start: {wheel: {speed: v0}}",
    ),
    (
        "wheel on a spring by its cord, down",
        &[MASS, RADIUS, GYRATION, SLOPE, ROUGH, STIFF, ("x0", "m", "0.00 to 0.01 step 0.01")],
        SPRING_BY_CORD,
    ),
    (
        "wheel on a spring by its cord, up",
        &[MASS, RADIUS, GYRATION, SLOPE, ROUGH, STIFF, ("x0", "m", "0.20 to 0.40 step 0.01")],
        SPRING_BY_CORD,
    ),
    (
        "wheel on a rigid spring on a floor",
        &[MASS, RADIUS, GYRATION, ROUGH, STIFF, ("x0", "m", "0.20 to 0.40 step 0.01")],
        "surfaces: {track: level}
bodies: {WHEEL}
ties:
  - rolls: {body: wheel, on its: rim, mu_s: mu_s}
  - cord: {from: {body: wheel, tied at: centre, leaves: forward}, spring: {stiffness: ks, stretch: x0, attached: rigidly}}
start: at rest",
    ),
    (
        "wheel thrown against a rigid spring",
        &[MASS, RADIUS, GYRATION, SLOPE, SPEED, ROUGH, STIFF, ("x0", "m", "0.05 to 0.10 step 0.01")],
        "surfaces: {track: {slope: theta}}
bodies: {WHEEL}
ties:
  - rolls: {body: wheel, on its: rim, mu_s: mu_s}
  - cord: {from: {body: wheel, tied at: centre, leaves: back}, spring: {stiffness: ks, stretch: x0, attached: rigidly}}
start: {wheel: {speed: v0}}",
    ),
    (
        "two blocks over a pulley, thrown",
        &[MASS, SPEED, ("M", "kg", "25 to 40 step 1")],
        "bodies:
  wheel: {mass: m, moves: vertically, positive: down}
  other: {mass: M, moves: vertically}
  pulley: {mass: 3 kg, shape: {disc: 0.1 m}, radii: {rim: 0.1 m}, moves: about a fixed axle}
ties:
  - cord: {name: left, from: {body: wheel, tied at: centre, leaves: up}, to: {body: pulley, wound on: rim, leaves: front down}}
  - cord: {name: right, from: {body: other, tied at: centre, leaves: up}, to: {body: pulley, wound on: rim, leaves: back down}}
start: {wheel: {speed: v0}}",
    ),
];

/// On a floor the place of equilibrium is that of the slack cord: equal by structure, whatever rounding says of both.
const SLACKENING: &Kind = &(
    "cart on a spring by its cord on a floor",
    &[MASS, STIFF, ("x0", "m", "0.20 to 0.40 step 0.01")],
    "surfaces: {track: level}
bodies: {wheel: {mass: m, moves: along track}}
ties: [cord: {from: {body: wheel, tied at: centre, leaves: forward}, spring: {stiffness: ks, stretch: x0, attached: by the cord}}]
start: at rest",
);

/// Pinned bodies: an end at rest is a zero of the speed that no quadrature may spoil.
const PINNED: &[Kind] = &[
    ("pendulum", &[MASS, ("phi", "deg", "20 to 120 step 1")], "bodies: {wheel: {mass: m, radius of gyration: 0.3 m, pinned: {distance: 0.5 m}, angle: from hanging}}
start: {wheel: {angle: phi}}"),
    ("pendulum with a spin", &[MASS, ("phi", "deg", "20 to 60 step 1"), ("w0", "rad/s", "1.0 to 2.0 step 0.1")], "bodies: {wheel: {mass: m, radius of gyration: 0.3 m, pinned: {distance: 0.5 m}, angle: from hanging}}
start: {wheel: {angle: phi, spin: w0}}"),
    ("rod with a couple", &[MASS, ("M", "N m", "1 to 4 step 1"), ("phi", "deg", "30 to 80 step 1")], "bodies: {wheel: {mass: m, shape: {rod: 1.2 m}, pinned: at its end, angle: from hanging}}
forces: [couple: {on: wheel, moment: M, sense: forward}]
start: {wheel: {angle: phi}}"),
    ("rod with a spring", &[MASS, ("ks", "N/m", "40 to 90 step 1"), ("phi", "deg", "10 to 30 step 1")], "bodies: {wheel: {mass: m, shape: {rod: 1.2 m}, pinned: at its end, angle: from upright}}
forces: [spring: {on: wheel, at: 1 m, anchor: [1 m, 1 m], stiffness: ks, natural length: 0.3 m}]
start: {wheel: {angle: phi}}"),
];

/// Motion on which nothing acts: every force and acceleration is exactly nothing.
const UNIFORM: &[Kind] = &[
    (
        "block on smooth ground",
        &[MASS, SPEED],
        "surfaces: {track: level}
bodies: {wheel: {mass: m, moves: along track}}
start: {wheel: {speed: v0}}",
    ),
    (
        "wheel rolls on a floor",
        &[MASS, RADIUS, GYRATION, SPEED, ROUGH],
        "surfaces: {track: level}
bodies: {WHEEL}
ties: [rolls: {body: wheel, on its: rim, mu_s: mu_s}]
start: {wheel: {speed: v0}}",
    ),
    (
        "a drum turns about its axle",
        &[MASS, RADIUS, ("w0", "rad/s", "2 to 9 step 1")],
        "bodies: {wheel: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: about a fixed axle}}
start: {wheel: {spin: w0}}",
    ),
    (
        "wheel on a slope of nothing",
        &[MASS, RADIUS, GYRATION, SPEED, ROUGH, ("theta", "deg", "always 0")],
        "surfaces: {track: {slope: theta}}
bodies: {WHEEL}
ties: [rolls: {body: wheel, on its: rim, mu_s: mu_s}]
start: {wheel: {speed: v0}}",
    ),
];

/// Bodies thrown with slip, on a floor and on a slope: they end rolling, still slipping, or at the start of rolling.
const THROWN: &[Kind] = &[
    (
        "ball thrown on a floor",
        &[MASS, RADIUS, SPEED, ("w0", "rad/s", "-2 to 2 step 1")],
        "surfaces: {track: level}
bodies: {wheel: {mass: m, shape: {sphere: R}, radii: {rim: R}, moves: along track}}
ties: [slips: {body: wheel, on its: rim, mu_s: 0.4, mu_k: 0.3}]
start: {wheel: {speed: v0, spin: w0}}",
    ),
    (
        "ball thrown up",
        &[MASS, RADIUS, SPEED, SLOPE, ("w0", "rad/s", "-2 to 2 step 1")],
        "surfaces: {track: {slope: theta}}
bodies: {wheel: {mass: m, shape: {sphere: R}, radii: {rim: R}, moves: along track}}
ties: [slips: {body: wheel, on its: rim, mu_s: 0.9, mu_k: 0.8}]
start: {wheel: {speed: v0, spin: w0}}",
    ),
];

/// A bank of one problem that asks these quantities; its margins do not matter here.
fn bank(kind: &Kind, end: &str, more: &[(&str, &str, &str)], asked: &[String]) -> Bank {
    let (name, data, scene) = kind;
    let mut text = "bank: asked\ntitle: Asked\nproblems:\n  one:\n    title: One\n    input energy limit: 1000\n    data:\n".to_owned();
    for (symbol, unit, draw) in data.iter().chain(more) {
        let _ = writeln!(text, "      {symbol}: {{name: {symbol}, unit: \"{unit}\", draw: {draw}}}");
    }
    text.push_str("    scene:\n");
    for line in scene.replace("WHEEL", WHEEL).lines() {
        let _ = writeln!(text, "      {line}");
    }
    let _ = writeln!(text, "      end: {end}\n    margins: {{taut: 0 %, slack: 0 %}}\n    questions:");
    for (i, quantity) in asked.iter().enumerate() {
        let _ = writeln!(text, "      q{i}: {{ask: it, quantity: {quantity}, cond limit: 1000}}");
    }
    match load::scenes_only(&text, name) {
        Ok(bank) => bank,
        Err(findings) => {
            panic!("{text}\n{}", findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
        }
    }
}

fn scene(bank: &Bank) -> &Scene {
    &bank.problems[0].cases[0].scene
}

fn drawn(bank: &Bank, what: &str) -> Result<Variant, String> {
    let maker = Maker::new(&bank.problems[0], 7, "asked").giving_up_after(300);
    maker.variant("one").map_err(|e| format!("{what}: {e}, {:?}", e.unsolved))
}

/// What [`everything`] finds for each kind and end; all faults together.
fn all(of: impl Iterator<Item = Result<Vec<String>, String>>) -> Vec<Vec<String>> {
    let (good, bad): (Vec<_>, Vec<_>) = of.partition(Result::is_ok);
    let bad: Vec<String> = bad.into_iter().filter_map(Result::err).collect();
    assert!(bad.is_empty(), "{}", bad.join("\n"));
    good.into_iter().flatten().collect()
}

/// Asks everything that the solver says of a drawn scene, and draws once more.
fn everything(kind: &Kind, end: &str, more: &[(&str, &str, &str)]) -> Result<Vec<String>, String> {
    let what = format!("{}, {end}", kind.0);
    let first = bank(kind, end, more, &["kinetic_energy".to_owned()]);
    let names: Vec<String> = drawn(&first, &what)?
        .solved
        .entries
        .iter()
        .filter(|e| e.value().is_finite())
        .map(|e| scene(&first).name_of(e.label))
        .collect();
    let mut bad = Vec::new();
    // What `solve` prints can be asked.
    let known = labels::of(scene(&first));
    for name in &names {
        if !known.iter().any(|l| scene(&first).name_of(*l) == *name) {
            bad.push(format!("{what}: {name} cannot be asked"));
        }
    }
    if !bad.is_empty() {
        return Err(bad.join("\n"));
    }
    let all = bank(kind, end, more, &names);
    let variant = drawn(&all, &what)?;
    for q in &all.problems[0].questions {
        let entry = variant.solved.get(q.label).unwrap();
        match entry.bound {
            None if q.label.quantity == Quantity::T && !scene(&all).is_pendulum() => {}
            None => bad.push(format!("{what}: {:?} is not enclosed", q.label)),
            Some(bound) if entry.value() == 0.0 && entry.cond == 0.0 && bound != 0.0 => {
                bad.push(format!("{what}: {:?} is zero by structure, within {bound:e}", q.label));
            }
            Some(_) => {}
        }
    }
    // Every body that moves along a line has a distance.
    for (b, body) in scene(&all).bodies.iter().enumerate() {
        let far = variant
            .solved
            .entries
            .iter()
            .any(|e| e.label.of == Owner::Body(b) && e.label.quantity == Quantity::Displacement);
        if far != body.line.is_some() {
            bad.push(format!("{what}: how far does {} go?", body.name));
        }
    }
    if bad.is_empty() { Ok(names) } else { Err(bad.join("\n")) }
}

/// `end: {turning point}` with a spring or for a pinned body could never be drawn: the banks of the tests had no such end, and
/// `solve --set`, which was tried, does not refuse what is not proved.
#[test]
fn an_end_at_rest_is_drawn_and_proved() {
    let found = all(MOVING.iter().chain(PINNED).map(|kind| everything(kind, "{turning point: wheel}", &[])));
    let count = found.iter().flatten().count();
    println!("{count} answers at turning points");
    assert!(count > 150, "{count}");
}

/// The same for other ends: what `solve` prints was refused as a question (`displacement`: "it needs a spring"), because nobody
/// had held the list of questions against what the solver says.
#[test]
fn what_the_solver_says_can_be_asked() {
    let travel = ("{travel: {of: wheel, by: d}}", ("d", "m", "0.02 to 0.05 step 0.001"));
    let time = ("{time: {of: wheel, is: t1}}", ("t1", "s", "0.05 to 0.10 step 0.001"));
    let lines = MOVING
        .iter()
        .chain([SLACKENING])
        .flat_map(|kind| [travel, time].map(|(end, more)| everything(kind, end, &[more])));
    // Where a couple or a spring acts on a pinned body, an integral gives the time, which is not enclosed.
    let pins = PINNED[..2].iter().map(|kind| everything(kind, time.0, &[time.1]));
    let late = ("{time: {of: wheel, is: t1}}", ("t1", "s", "0.5 to 1.0 step 0.1"));
    let thrown = THROWN.iter().flat_map(|kind| {
        [time, late].map(|(end, more)| everything(kind, end, &[more])).into_iter().chain([everything(
            kind,
            "{rolling: wheel}",
            &[],
        )])
    });
    let found = all(lines.chain(pins).chain(thrown));
    let count = found.iter().flatten().count();
    println!("{count} answers");
    assert!(count > 300, "{count}");
}

/// Uniform motion could not be drawn either: no scene of the tests was without forces, and each zero was only nearly one.
#[test]
fn nothing_is_enclosed_as_nothing() {
    let travel = ("{travel: {of: wheel, by: d}}", ("d", "m", "1.0 to 3.0 step 0.1"));
    let time = ("{time: {of: wheel, is: t1}}", ("t1", "s", "1.0 to 3.0 step 0.1"));
    let found = all(UNIFORM.iter().flat_map(|kind| {
        let turn = ("{turn: {of: wheel, by: 40 deg}}", time.1);
        let ends = if kind.0.starts_with("a drum") { [turn, time] } else { [travel, time] };
        ends.iter()
            .map(|(end, more)| {
                everything(kind, end, if *end == turn.0 { &[] } else { std::slice::from_ref(more) })
            })
            .collect::<Vec<_>>()
    }));
    for names in found {
        assert!(names.iter().any(|n| n == "a" || n == "alpha"), "{names:?}");
    }
}

/// How far it slides or rolls up is a question like any other: with wrong methods, beside them a right answer of its own.
#[test]
fn wrong_methods_know_distances() {
    let text = "bank: asked
title: Asked
problems:
  one:
    title: One
    data:
      v0: {name: v0, unit: m/s, draw: 1.0 to 4.0 step 0.1}
      theta: {name: slope, unit: deg, draw: 10 to 30 step 1}
    scene:
      surfaces: {track: {slope: theta}}
      bodies: {ball: {mass: 2 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along track, positive: up}}
      ties: [rolls: {body: ball, on its: rim, mu_s: 0.5}]
      start: {ball: {speed: v0}}
      end: {turning point: ball}
    questions:
      D_turn: {ask: how far does it roll up, unit: m}
      displacement: {ask: and by how much is it displaced, unit: cm}
    follows: {displacement: D_turn}
    mistakes:
      rotation-forgotten: {values: {D_turn: v0^2/(2*g*sin(theta)), displacement: v0^2/(2*g*sin(theta))}}
";
    let bank = load::scenes_only(text, "asked.yaml").unwrap();
    let variant = Maker::new(&bank.problems[0], 3, "asked").variant("one").unwrap();
    let value = |q: Quantity| variant.solved.entries.iter().find(|e| e.label.quantity == q).unwrap().value();
    let sine = libm::sin(variant.data[1].to_radians());
    let far = 0.7 * variant.data[0] * variant.data[0] / (variant.data[2] * sine);
    assert!((value(Quantity::DTurn) / far - 1.0).abs() < 1e-14);
    assert!((value(Quantity::Displacement) / far - 1.0).abs() < 1e-14);
    assert_eq!(variant.wrong.len(), 2);
    for wrong in &variant.wrong {
        assert!((wrong.value / far * 1.4 - 1.0).abs() < 1e-14, "{wrong:?}");
    }
}

/// The only draw of a scene of constants: what it asks, as its questions are written, in a problem that declares these regimes.
fn only_draw(scene: &str, regimes: &str, questions: &str) -> Result<Vec<f64>, String> {
    let text = format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:\n      {}\n    regimes: [{regimes}]\n    questions: {{{questions}}}\n",
        scene.replace('\n', "\n      ")
    );
    let bank = load::scenes_only(&text, "test").unwrap_or_else(|f| panic!("{f:#?}\n{text}"));
    let problem = &bank.problems[0];
    let variant = Maker::new(problem, 1, "set").variant("one").map_err(|e| e.to_string())?;
    let value = |q: &slipstick::bank::Question| variant.solved.get(q.label).unwrap().value();
    Ok(problem.questions.iter().map(value).collect())
}

/// A pull at the axle has no lever. The tests above have pulls on hubs and rims, whose moment leaves no doubt of its sign: the one that
/// is zero by structure was enclosed as a difference, and refused every draw for the sake of `k_bound`, which nobody asked.
#[test]
fn a_wheel_pulled_at_its_axle_is_drawn() {
    let wheel = |track: &str, leaves: &str| {
        format!(
            "surfaces: {{track: {track}}}
bodies: {{wheel: {{mass: 4.3 kg, radius of gyration: 0.13 m, radii: {{rim: 0.31 m}}, moves: along track}}}}
ties:
  - rolls: {{body: wheel, on its: rim, mu_s: 0.9}}
  - cord: {{from: {{body: wheel, tied at: centre, leaves: {leaves}}}, pulled with: 23.7 N}}
start: at rest
end: {{travel: {{of: wheel, by: 1.7 m}}}}"
        )
    };
    let inertia = 4.3 * (1.0 + 0.13 * 0.13 / (0.31 * 0.31));
    let weight = 4.3 * 9.81 * 0.173_648_177_666_930_33;
    for (track, leaves, regime, a) in [
        ("level", "forward", "moves_forward", 23.7 / inertia),
        ("{slope: 10 deg}", "up", "moves_up", (23.7 - weight) / inertia),
        ("{slope: 10 deg}", "down", "moves_down", -(23.7 + weight) / inertia),
    ] {
        let drawn = only_draw(&wheel(track, leaves), regime, "a: {ask: a}").unwrap();
        assert!((drawn[0] - a).abs() < 1e-13 * a.abs(), "{track}, {leaves}: {drawn:?}, not {a}");
    }
}

/// Rest by structure can be drawn where it is declared. The tests of rest in `rest.rs` only solve: no test drew one.
#[test]
fn what_rests_by_structure_is_drawn() {
    let blocks = |friction: &str| {
        format!(
            "surfaces: {{floor: level}}
bodies: {{A: {{mass: 2 kg, moves: along floor}}, B: {{mass: 3 kg, moves: along floor}}}}
ties:
{friction}  - cord: {{name: c, from: {{body: A, tied at: centre, leaves: forward}}, to: {{body: B, tied at: centre, leaves: back}}}}
start: at rest
end: {{travel: {{of: A, by: 1 m}}}}"
        )
    };
    let a = "A_a: {quantity: A.a, ask: a}";
    let rough = blocks("  - slides: {body: A, mu_k: 0.2}\n  - slides: {body: B, mu_k: 0.2}\n");
    assert_eq!(only_draw(&blocks(""), "balanced", a), Ok(vec![0.0]));
    assert_eq!(only_draw(&rough, "balanced", a), Ok(vec![0.0]));
    // Without friction nothing can pull on the cord; with it statics leaves the tension open, and it cannot be asked.
    let tension = "c_tension: {quantity: c.tension, ask: t}";
    assert_eq!(only_draw(&blocks(""), "balanced", tension), Ok(vec![0.0]));
    assert!(only_draw(&rough, "balanced", tension).is_err());
    // An idle cord is no licence for what is declared to move.
    assert!(only_draw(&blocks(""), "moves_forward", a).is_err());
    for end in ["W", "B"] {
        let scene = format!(
            "surfaces: {{floor: level}}
bodies:
  W: {{mass: 4 kg, shape: {{disc: 0.2 m}}, radii: {{rim: 0.2 m}}, moves: along floor}}
  B: {{mass: 3 kg, moves: vertically, positive: down}}
ties:
  - rolls: {{body: W, on its: rim, mu_s: 0.9}}
  - cord: {{name: c, from: {{body: W, wound on: rim, leaves: bottom forward}}, to: {{body: B, tied at: centre, leaves: up}}}}
start: at rest
end: {{travel: {{of: {end}, by: 1 m}}}}"
        );
        let asked = "B_a: {quantity: B.a, ask: a}, c_tension: {quantity: c.tension, ask: t}";
        let drawn = only_draw(&scene, "balanced", asked).unwrap();
        assert!(drawn[0] == 0.0 && (drawn[1] - 29.43).abs() < 1e-13, "{end}: {drawn:?}");
    }
}
