//! Worked solutions of scenes composed by lot, of which everything is asked that is published: each has one, and each printed
//! equation, solved again in intervals, holds. The scenes of the banks have the ends and the quantities that somebody thought
//! of; what nobody had thought of got data and answers alone.
use crate::joined_lot;
use crate::lot;
pub use crate::lot::Lot;
use crate::support;
use crate::tex;
use rayon::prelude::*;
use slipstick::bank::{Problem, labels, load};
use slipstick::problem::maker::{self, Variant};
use slipstick::scene::{End, Quantity};
use slipstick::solution;
use slipstick::template::Templates;
use slipstick::words::Words;
use std::collections::BTreeMap;

/// A bank of one scene with a question for each quantity that it has; `None` where it is refused or would not be drawn.
fn asked(text: &str) -> Option<(Problem, Variant, String)> {
    let solve = |text: &str| {
        let bank = load::scenes_only(text, "composed.yaml").ok()?;
        let problem = bank.problems.into_iter().next()?;
        let variant = maker::from_values(&problem, 0, &support::constants(&problem)).ok()?;
        Some((problem, variant))
    };
    let (problem, variant) = solve(text)?;
    if !variant.solved.holds_as(&[variant.solved.regime.word()]) {
        return None;
    }
    let scene = &problem.cases[0].scene;
    let numbers = variant.solved.entries.iter().filter(|e| e.value().is_finite()).map(|e| e.label);
    // On level ground that is drawn turned round no direction is asked.
    let askable = labels::of(scene);
    let words = variant.solved.words.iter().map(|(label, _)| *label);
    let words = words.filter(|label| label.quantity != Quantity::Direction || askable.contains(label));
    let mut labels = numbers.chain(words).peekable();
    labels.peek()?;
    let lines: String = labels
        .enumerate()
        .map(|(i, label)| format!("      q{i}: {{quantity: {}, ask: it}}\n", scene.name_of(label)))
        .collect();
    let text = format!("{}    questions:\n{lines}", text.split("    questions:").next()?);
    let (problem, variant) =
        solve(&text).unwrap_or_else(|| panic!("asked of everything it is refused:\n{text}"));
    Some((problem, variant, text))
}

/// Works the scenes of these seeds; how many, and those that have a short page or a line that does not hold.
fn worked(
    seeds: u32,
    bank: impl Fn(u64) -> Option<String> + Sync,
) -> (usize, usize, BTreeMap<u64, Vec<String>>) {
    let (words, templates) = (Words::english(), Templates::new("en", &[]).unwrap());
    let from: u64 = std::env::var("SLIPSTICK_FIRST").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
    let told: Vec<(u64, bool, Vec<String>)> = (from..from + u64::from(seeds))
        .into_par_iter()
        .filter_map(|seed| {
            let (problem, variant, bank) = asked(&bank(seed)?)?;
            let text = solution::text(&problem, &variant, 1, &words, &templates).expect("a text");
            let short = text.contains(words.get("solution.title.beyond")) && !untold(&problem, &text, &words);
            let wrong = tex::check(&text, &mut tex::Counts::default());
            if (short || !wrong.is_empty()) && std::env::var("TELL").is_ok() {
                println!("{seed}: {}\n{bank}\n{text}", wrong.join("\n"));
            }
            Some((seed, short, wrong))
        })
        .collect();
    let short = told.iter().filter(|(_, short, _)| *short).count();
    println!("{} solutions, {short} of them short pages", told.len());
    let count = told.len();
    let wrong = told.into_iter().filter(|(.., wrong)| !wrong.is_empty());
    (count, short, wrong.map(|(seed, _, wrong)| (seed, wrong)).collect())
}

/// Is it a short page of one of the kinds of scenes that have no other: a motion in phases, a spring that pulls at an instant?
fn untold(problem: &Problem, text: &str, words: &Words) -> bool {
    let scene = &problem.cases[0].scene;
    let [phases, spring] = ["phases", "spring_at_once"]
        .map(|reason| text.contains(words.get(&format!("solution.beyond.{reason}"))));
    let instant = scene.end == End::AtOnce;
    assert!(!phases || scene.goes_in_phases() && scene.thrown().is_none() && !instant, "{text}");
    assert!(!spring || scene.is_sprung() && instant, "{text}");
    phases || spring
}

#[test]
fn every_composed_scene_has_a_true_solution() {
    let seeds = 4 * support::seeds(2500).max(50);
    let (count, short, wrong) = worked(seeds, |seed| Some(lot::yaml(&lot::scene(seed))));
    assert!(wrong.is_empty(), "{wrong:#?}");
    // What is left are motions over no distance and in no time, and springs on bodies that others hold.
    assert!(count > 20 && 100 * short <= 4 * count, "{short} of {count}");
}

/// The same of scenes on a belt, on a truck and in a lift.
#[test]
fn every_composed_scene_that_is_carried_has_a_true_solution() {
    const CARRIERS: [&str; 5] = [
        "horizontal, acceleration: 1.3 m/s^2",
        "vertical, acceleration: -2.1 m/s^2",
        "horizontal, acceleration: -0.7 m/s^2, speed: 2.5 m/s",
        "horizontal, speed: -1.5 m/s",
        "vertical, acceleration: 1.9 m/s^2, speed: 0.8 m/s",
    ];
    let seeds = 12 * support::seeds(1000).max(50);
    let (count, short, wrong) = worked(seeds, |seed| {
        let carried = format!("    scene:\n      carried: {{along: {}}}\n", CARRIERS[seed as usize % 5]);
        Some(lot::yaml(&lot::scene(seed)).replace("    scene:\n", &carried))
    });
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(count > 20 && 100 * short <= 4 * count, "{short} of {count}");
}

/// Forces that grow with each power of time and of place, from rest and from a speed.
#[test]
fn every_growing_force_has_a_true_solution() {
    const LAWS: [(&str, &str, bool); 9] = [
        ("t", "N/s", false),
        ("t^2", "N/s^2", false),
        ("sqrt(t)", "N", false),
        ("t^3", "N/s^3", false),
        ("t^1.5", "N/s", false),
        ("x", "N/m", true),
        ("x^2", "N/m^2", true),
        ("sqrt(x)", "N", true),
        ("x^3", "N/m^3", true),
    ];
    let scene = |seed: u64| {
        let (law, unit, place) = LAWS[seed as usize % LAWS.len()];
        let start = ["at rest", "{wheel: {speed: 1.5 m/s}}"][seed as usize / LAWS.len() % 2];
        let (end, of) =
            if place { ("travel: {of: wheel, by: e}", "m") } else { ("time: {of: wheel, is: e}", "s") };
        let couple = law.replace('x', "phi");
        let couple_unit = unit.replacen('N', "N*m", 1).replace("/m", "/rad");
        let couple = [String::new(), format!(", growing by: {{rate: 1.5 {couple_unit}, with: {couple}}}")];
        let couple = &couple[seed as usize / (2 * LAWS.len()) % 2];
        Some(format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{e: {{name: extent, unit: {of}, draw: always 0.8}}}}\n    scene:
      surfaces: {{incline: {{slope: 20 deg}}}}
      bodies: {{wheel: {{mass: 12 kg, radius of gyration: 0.21 m, radii: {{rim: 0.4 m, hub: 0.15 m}}, moves: along incline, positive: up}}}}
      ties:
        - rolls: {{body: wheel, on its: rim, mu_s: 0.9}}
        - cord: {{from: {{body: wheel, wound on: hub, leaves: top forward}}, pulled with: 90 N, growing by: {{rate: 22 {unit}, with: {law}}}}}
      forces: [couple: {{on: wheel, moment: 3 N*m, sense: forward{couple}}}]
      start: {start}
      end: {{{end}}}
    questions: {{work: {{ask: W}}}}\n    statement: x\n"
        ))
    };
    let (count, short, wrong) = worked(4 * LAWS.len() as u32, scene);
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert_eq!((count, short), (4 * LAWS.len(), 0));
}

/// The scenes of textbooks on belts, trucks, lifts and rollers: in each language no short page, and every line holds.
#[test]
fn what_is_carried_or_rests_on_wheels_is_worked() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/carried");
    let mut worked = 0;
    for file in std::fs::read_dir(folder).expect("scenes").map(|f| f.expect("a file").path()) {
        let text = std::fs::read_to_string(&file).expect("text");
        let bank = load::scenes_only(&text, &file.display().to_string()).expect("a bank");
        for language in Words::languages() {
            let (words, templates) = (Words::of(language).unwrap(), Templates::new(language, &[]).unwrap());
            for problem in &bank.problems {
                let variant = maker::from_values(problem, 0, &support::constants(problem)).expect("solved");
                let text = solution::text(problem, &variant, 1, &words, &templates).expect("a text");
                assert!(!text.contains(words.get("solution.title.beyond")), "{text}");
                let wrong = tex::check(&text.replace("{,}", "."), &mut tex::Counts::default());
                assert!(wrong.is_empty(), "{}\n{text}", wrong.join("\n"));
                worked += 1;
            }
        }
    }
    assert!(worked >= 16, "{worked}");
}

/// An impact by lot: rods, alone, on a pin or hinged to another one, that meet an edge or a ball, which springs back or stays, and
/// pucks that meet at an angle.
fn impact(seed: u64) -> String {
    let mut lot = Lot::new(seed);
    let mut grid = |from: u32, to: u32| f64::from(from + lot.below((to - from) as usize) as u32) / 10.0;
    let [m, mass, length, h, v, w, e] =
        [grid(5, 30), grid(20, 60), grid(8, 15), grid(2, 8), grid(10, 60), grid(0, 30), grid(0, 11)];
    let [a, t, d] =
        [[0, 20, 65, 130, 205], [0, 30, 90, 145, 250], [0, 90, 180, 270, 310]].map(|of| lot.of(&of));
    let spins = if lot.in_100(50) { format!(", spin: {w} rad/s") } else { String::new() };
    let arrives = format!("arrives: {{speed: {v} m/s, direction: {t} deg}}");
    let rod = format!(
        "{{mass: {mass} kg, shape: {{rod: L}}, moves: in the plane, angle: from right, points: {{A: 0 m, P: h, B: L}}"
    );
    let place = "[h*cos(a), h*sin(a)]";
    let stays = lot.in_100(40);
    let ball = |how: &str| match stays {
        true => {
            ("ball: {mass: m, moves: in the plane}".to_owned(), format!("{how}: {{welds: [rod.P, ball]}}"))
        }
        false => (
            format!("ball: {{mass: m, moves: in the plane, placed: {place}}}"),
            format!("{how}: {{guides: ball, on: rod.A, along: 0 deg, restitution: {e}}}"),
        ),
    };
    let (bodies, joints, start) = match lot.below(5) {
        0 => {
            let (ball, hit) = ball("hit");
            let spin =
                if lot.in_100(50) { format!(", arrives: {{spin: -{w} rad/s}}") } else { String::new() };
            let joints = format!("{{O: {{pins: rod.A}}, {hit}}}");
            (format!("rod: {rod}}}, {ball}"), joints, format!("rod: {{angle: a{spin}}}, ball: {{{arrives}}}"))
        }
        1 => {
            let (ball, hit) = ball("hit");
            let bodies = format!("rod: {rod}, placed: [0 m, 0 m]}}, {ball}");
            (bodies, format!("{{{hit}}}"), format!("rod: {{angle: a}}, ball: {{{arrives}}}"))
        }
        2 => {
            let held = match stays {
                true => "edge: {pins: rod.B, at: [L*cos(a), L*sin(a)]}".to_owned(),
                false => format!(
                    "edge: {{guides: rod.B, along: {d} deg, through: [L*cos(a), L*sin(a)], restitution: {e}}}"
                ),
            };
            let moves = arrives.replace('}', &format!("{spins}}}"));
            let bodies = format!("rod: {rod}, placed: [0 m, 0 m]}}");
            (bodies, format!("{{{held}}}"), format!("rod: {{angle: a, {moves}}}"))
        }
        3 => {
            let bodies = format!(
                "rod: {rod}}}, low: {{mass: {m} kg, shape: {{rod: 0.7 m}}, moves: in the plane, angle: from right}}, ball: {{mass: m, moves: in the plane}}"
            );
            let joints = "{O: {pins: rod.A}, H: {hinges: [rod.B, low.A]}, K: {welds: [low.B, ball]}, P: {links: rod.P, to: [h*cos(a) + 1 m, h*sin(a)]}}";
            let joints = if stays {
                joints.to_owned()
            } else {
                joints.split(", P:").next().unwrap_or("").to_owned() + "}"
            };
            (bodies, joints, format!("rod: {{angle: a}}, low: {{angle: {d} deg}}, ball: {{{arrives}}}"))
        }
        _ => {
            let puck = |name: &str, mass: f64| {
                format!("{name}: {{mass: {mass} kg, moves: in a horizontal plane, placed: [0 m, 0 m]}}")
            };
            let bodies = format!(
                "one: {{mass: m, moves: in a horizontal plane, placed: [h - h + L - L, 0 m]}}, {}",
                puck("two", mass)
            );
            let joints = format!("{{hit: {{guides: one, on: two, along: a, restitution: {e}}}}}");
            (
                bodies,
                joints,
                format!("one: {{{arrives}}}, two: {{arrives: {{speed: {w} m/s, direction: {d} deg}}}}"),
            )
        }
    };
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:
      m: {{name: mass, unit: kg, draw: always {m}}}
      h: {{name: place, unit: m, draw: always {h}}}
      L: {{name: length, unit: m, draw: always {length}}}
      a: {{name: angle, unit: deg, draw: always {a}}}
    scene:
      bodies: {{{bodies}}}
      joints: {joints}
      start: {{{start}}}
      end: at once
    questions: {{energy: {{quantity: kinetic_energy, ask: E}}}}\n    statement: x\n"
    )
}

/// Impacts of all kinds, of which all velocities, impulses and energies are asked.
#[test]
fn every_composed_impact_has_a_true_solution() {
    let (count, short, wrong) = worked(4 * support::seeds(250).max(50), |seed| Some(impact(seed)));
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(count > 20 && short == 0, "{short} of {count}");
}

/// The same of bodies that are joined in the plane: all kinds of joints, forces, springs and ends, some of them carried.
#[test]
fn every_composed_mechanism_has_a_true_solution() {
    let seeds = 4 * support::seeds(250).max(25);
    // An instant at which several freedoms have speeds has a short page.
    let machine = |seed| {
        let (machine, _) = joined_lot::machine(seed)?;
        machine.spins.is_empty().then(|| joined_lot::yaml(&machine))
    };
    let (count, short, wrong) = worked(seeds, machine);
    assert!(wrong.is_empty(), "{wrong:#?}");
    // What is left are springs beside a torsion spring on a pinned body, and rods that hold a wheel which rubs, or brake it.
    assert!(count > 20 && 100 * short <= 5 * count, "{short} of {count}");
}

/// Everything that is published of the scenes of the banks, of swings and of throws is worked, not only what they ask.
#[test]
fn every_published_quantity_of_the_banks_is_worked() {
    let (words, templates) = (Words::english(), Templates::new("en", &[]).unwrap());
    let others = include_str!("../worked/swings-and-throws.yaml");
    let others = load::scenes_only(others, "swings.yaml").unwrap_or_else(|f| panic!("{f:?}"));
    let mut faults = Vec::new();
    for bank in support::banks().into_iter().chain([others]) {
        for mut problem in bank.problems {
            let first = problem.questions.clone();
            for student in 0..8 {
                problem.questions.clone_from(&first);
                let drawn = maker::Maker::new(&problem, 7, "all").variant(&student.to_string());
                let variant = drawn.unwrap_or_else(|e| panic!("{}: {e}", problem.id));
                // What the questions ask has to be within reach of the key; all else comes beside it.
                for (i, entry) in
                    variant.solved.entries.iter().enumerate().filter(|(_, e)| e.value().is_finite())
                {
                    if !first.iter().any(|q| q.label == entry.label) {
                        let mut more = first[0].clone();
                        (more.label, more.id) = (entry.label, format!("more{i}"));
                        more.unit =
                            slipstick::units::Unit::parse(entry.label.quantity.unit()).expect("a unit");
                        problem.questions.push(more);
                    }
                }
                let text = solution::text(&problem, &variant, 1, &words, &templates).expect("a text");
                let mut wrong = if linear(&problem) {
                    tex::check(&text, &mut tex::Counts::default())
                } else {
                    Vec::new()
                };
                wrong.extend(
                    text.split_once(words.get("solution.title.beyond")).map(|(_, why)| why.to_owned()),
                );
                faults.extend(wrong.into_iter().map(|w| format!("{}: {w}", problem.id)));
            }
        }
    }
    faults.sort();
    faults.dedup();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn linear(problem: &Problem) -> bool {
    let scene = &problem.cases[0].scene;
    scene.pinned().is_none() && scene.bodies.iter().all(|b| b.particles.is_empty())
}

const ASKED: &str = "bank: asked
title: Asked by formulas
problems:
  spool:
    title: A spool
    data:
      m:    {name: mass, unit: kg, draw: 20 to 40 step 1}
      k:    {name: radius of gyration, unit: m, draw: 0.2 to 0.3 step 0.01}
      R:    {name: radius of the rim, unit: m, draw: 0.36 to 0.44 step 0.01}
      r:    {name: radius of the hub, unit: m, draw: 0.1 to 0.2 step 0.01}
      P:    {name: pull, unit: N, draw: 200 to 400 step 10}
      mu_s: {name: coefficient of static friction, unit: \"1\", draw: always 0.2}
      mu_k: {name: coefficient of kinetic friction, unit: \"1\", draw: always 0.15}
    scene:
      surfaces: {floor: level}
      bodies: {spool: {mass: m, radius of gyration: k, radii: {rim: R, hub: r}, moves: along floor}}
      ties:
        - slips: {body: spool, on its: rim, mu_s: mu_s, mu_k: mu_k}
        - cord: {from: {body: spool, wound on: hub, leaves: bottom forward}, pulled with: P}
      start: at rest
      end: {time: {of: spool, is: 2 s}}
    questions:
      largest: {value: mu_s*normal, unit: N, ask: it}
      needed:  {quantity: friction, if: rolls, unit: N, ask: it}
      lacking: {value: abs(friction) - mu_s*normal, if: rolls, unit: kN, ask: it}
      free:    {quantity: a, if: smooth, ask: it}
      share:   {value: kinetic_energy/work_pull, unit: \"1\", ask: it}
    statement: s
  disc:
    title: A disc
    data:
      theta: {name: slope, unit: deg, draw: 10 to 25 step 1}
      h:     {name: height, unit: m, draw: 1.0 to 4.0 step 0.1}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies: {disc: {mass: any, shape: {disc: any}, moves: along incline, positive: down}}
      ties: [rolls: {body: disc, on its: rim}]
      start: at rest
      end: {travel: {of: disc, by: h/sin(theta)}}
    questions: {v: {ask: v}, a: {ask: a}, t: {ask: t}, mu_required: {ask: mu}, rotational_fraction: {ask: q}}
    statement: s
  stone:
    title: A stone
    data:
      M:  {name: mass of the pulley, unit: kg, draw: 6.0 to 14.0 step 0.5}
      y:  {name: fall, unit: m, draw: 8.0 to 13.0 step 0.1}
      t1: {name: measured time, unit: s, draw: 2.0 to 3.6 step 0.05, measured: t}
      m:  {name: mass of the stone, unit: kg, unknown: 0.2 to 20 step 0.1}
    scene:
      bodies:
        pulley: {mass: M, shape: {disc: any}, moves: about a fixed axle}
        stone: {mass: m, moves: vertically, positive: down}
      ties:
        - cord: {from: {body: stone, tied at: centre, leaves: up}, to: {body: pulley, wound on: rim, leaves: back down}}
      start: at rest
      end: {travel: {of: stone, by: y}}
    questions: {mass: {value: m, unit: kg, ask: m}, tension: {unit: N, ask: T}}
    statement: s
  pendulum:
    title: A pendulum
    data:
      T: {name: measured period, unit: s, draw: always 1.7, measured: period_small}
      h: {name: distance of the pin, unit: m, unknown: 0.31 to 2 step 0.01}
    scene:
      bodies: {body: {mass: 2 kg, radius of gyration: 0.3 m, pinned: {distance: h}, angle: from hanging}}
      start: {body: {angle: 10 deg}}
      end: {angle: {of: body, reaches: 0 deg}}
    questions: {distance: {value: h, unit: m, ask: h}}
    statement: s
  half-the-pull:
    title: A pull that stands in a formula of the scene
    data:
      m:  {name: mass, unit: kg, draw: 4 to 8 step 1}
      P:  {name: pull, unit: N, unknown: 50 to 200 step 1}
      th: {name: slope, unit: deg, draw: 15 to 25 step 1}
      a0: {name: acceleration, unit: m/s^2, draw: 2.0 to 3.0 step 0.1, measured: a}
    scene:
      surfaces: {inc: {slope: th}}
      bodies: {disc: {mass: m, shape: {disc: 0.2 m}, moves: along inc}}
      ties:
        - rolls: {body: disc, on its: rim}
        - cord: {from: {body: disc, tied at: centre, leaves: forward}, pulled with: P/2}
      start: at rest
      end: at once
    cond limit: 60
    questions: {x: {value: P, unit: N, ask: P}}
    statement: s
  grindstone:
    title: A grindstone
    data:
      m:  {name: mass, unit: kg, draw: 40 to 60 step 1}
      R:  {name: radius, unit: m, draw: 0.20 to 0.30 step 0.01}
      N:  {name: force of the axe, unit: N, draw: 120 to 200 step 10}
      t1: {name: time, unit: s, draw: 6.0 to 9.0 step 0.1, measured: t}
      F:  {name: friction, unit: N, unknown: 10 to 300 step 1}
    scene:
      bodies: {stone: {mass: m, shape: {disc: R}, radii: {rim: R}, moves: about a fixed axle}}
      forces: [couple: {on: stone, moment: F*R, sense: back}]
      start: {stone: {spin: 850 rpm}}
      end: {turning point: stone}
    cond limit: 60
    questions: {mu: {value: F/N, unit: \"1\", ask: mu}}
    statement: s
  from-which-height:
    title: The height of a slope
    data:
      v:  {name: speed, unit: m/s, draw: 2.0 to 4.0 step 0.1, measured: v}
      th: {name: slope, unit: deg, draw: 15 to 25 step 1}
      h:  {name: height, unit: m, unknown: 0.1 to 5 step 0.01}
    scene:
      surfaces: {inc: {slope: th}}
      bodies: {ball: {mass: any, shape: {sphere: any}, moves: along inc, positive: down}}
      ties: [rolls: {body: ball, on its: rim}]
      start: at rest
      end: {descent: {of: ball, by: h}}
    cond limit: 60
    questions: {h: {value: h, unit: m, ask: h}}
    statement: s
  part-across:
    title: A part of a velocity
    data:
      th: {name: slope, unit: deg, draw: 15 to 40 step 1}
    scene:
      surfaces: {inc: {slope: th}}
      bodies: {disc: {mass: any, shape: {disc: any}, moves: along inc, positive: down}}
      ties: [rolls: {body: disc, on its: rim}]
      start: at rest
      end: {travel: {of: disc, by: 0.3 m}}
    questions: {x: {value: v*sin(pi/2 - th), unit: m/s, ask: v_x}, y: {value: v*cos(th - pi/6), unit: m/s, ask: w}}
    statement: s
";

#[test]
fn expressions_other_contacts_and_measurements_are_worked() {
    let bank = load::scenes_only(ASKED, "asked.yaml").unwrap_or_else(|f| panic!("{f:?}"));
    for language in Words::languages() {
        let (words, templates) = (Words::of(language).unwrap(), Templates::new(language, &[]).unwrap());
        for problem in &bank.problems {
            let maker = maker::Maker::new(problem, 7, "set");
            for student in 0..10 {
                let variant = maker.variant(&student.to_string()).expect("a variant");
                let text = solution::text(problem, &variant, 1, &words, &templates).expect("a text");
                assert!(!text.contains(words.get("solution.title.beyond")), "{text}");
                let wrong = tex::check(&text.replace("{,}", "."), &mut tex::Counts::default());
                assert!(wrong.is_empty(), "{}\n{text}", wrong.join("\n"));
            }
        }
    }
}
