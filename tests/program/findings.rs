//! What a wrong bank is told: one small fault each, the changed lines above the whole message.
use insta::assert_snapshot;
use proptest::prelude::*;
use slipstick::bank::load;
use slipstick::template;
use std::fmt::Write as _;

const SOUND: &str = "\
bank: test
title: Test
problems:
  slide:
    title: A block
    data:
      m:
        name: mass
        unit: kg
        draw: 20 to 40 step 1
      theta: {name: slope, unit: deg, draw: 20 to 60 step 5}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies:
        block: {mass: m, moves: along incline}
      ties:
        - slides: {body: block, mu_k: 0.2}
      start: at rest
      end: {travel: {of: block, by: 2 m}}
    regimes: [moves_down]
    questions:
      v: {ask: the speed, unit: m/s}
";

/// The lines that differ from the sound bank, and what is said of them.
fn found(edits: &[(&str, &str)]) -> String {
    let mut bank = SOUND.to_owned();
    for (from, to) in edits {
        assert!(bank.contains(from), "`{from}` is not in the bank");
        bank = bank.replacen(from, to, 1);
    }
    let mut text = String::new();
    for (number, line) in bank.lines().enumerate() {
        if !SOUND.lines().any(|l| l == line) {
            writeln!(text, "{:>3} | {line}", number + 1).expect("a String takes it");
        }
    }
    match load::bank(&bank, "test.yaml", &template::variables_of) {
        Ok(_) => text.push_str("no finding"),
        Err(findings) => {
            for finding in findings {
                writeln!(text, "{finding}").expect("a String takes it");
            }
        }
    }
    text
}

#[test]
fn the_sound_bank_is_sound() {
    let bank = load::bank(SOUND, "test.yaml", &template::variables_of).unwrap();
    assert_eq!(bank.problems.len(), 1);
    assert_eq!(bank.hash.len(), 64);
}

#[test]
fn the_banks_of_the_program_are_sound() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("banks");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        if text.lines().any(|l| l.starts_with("bank:")) {
            let read = load::bank(&text, "bank", &template::variables_of);
            assert!(read.is_ok(), "{}: {:#?}", path.display(), read.err());
            count += 1;
        }
    }
    assert!(count >= 2);
}

#[test]
fn yaml_syntax() {
    assert_snapshot!(found(&[("title: Test", "title: [Test")]), @r#"
      2 | title: [Test
    test.yaml:3:9: YAML: illegal placement of ':' indicator
    "#);
}

#[test]
fn an_indent_is_told_as_such() {
    assert_snapshot!(found(&[("        unit: kg", "       unit: kg")]), @r#"
      9 |        unit: kg
    test.yaml:9:8: YAML: while parsing a block mapping, did not find expected key
    "#);
}

#[test]
fn missing_fields() {
    assert_snapshot!(found(&[("bank: test\n", ""), ("title: Test\n", "")]), @r#"
    test.yaml:1:1: `bank` is missing
        hint: for example `bank: wheels-on-inclines`
    test.yaml:1:1: `title` is missing
        hint: for example `title: Wheels on inclines`
    "#);
}

#[test]
fn unknown_field() {
    assert_snapshot!(found(&[("        draw: 20 to 40 step 1", "        drwa: 20 to 40 step 1")]), @r#"
     10 |         drwa: 20 to 40 step 1
    test.yaml:8:9: problems.slide.data.m: `m` is used as a mass, but it is not drawn
        hint: for example `draw: 20 to 40 step 1`
    test.yaml:10:9: problems.slide.data.m.drwa: unknown field `drwa`
        hint: did you mean `draw`?
    "#);
}

#[test]
fn a_field_twice() {
    assert_snapshot!(found(&[("    title: A block", "    title: A block\n    title: Another")]), @r#"
      6 |     title: Another
    test.yaml:6:5: problems.slide.title: `title` stands twice
        hint: remove one of them
    "#);
}

#[test]
fn wrong_type() {
    assert_snapshot!(found(&[("    questions:\n      v: {ask: the speed, unit: m/s}\n", "    questions: none\n")]), @r#"
     21 |     questions: none
    test.yaml:21:16: problems.slide.questions: expected questions by id, found `none`
    "#);
}

#[test]
fn bad_id() {
    assert_snapshot!(found(&[("bank: test", "bank: my bank!")]), @r#"
      1 | bank: my bank!
    test.yaml:1:7: bank: `my bank!` is no id of a bank
        hint: letters, digits, `-` and `_`, beginning with a letter or digit, at most 64
    "#);
}

#[test]
fn bad_symbol() {
    assert_snapshot!(found(&[("      m:\n", "      2m:\n")]), @r#"
      7 |       2m:
    test.yaml:7:7: problems.slide.data.2m: `2m` is no symbol
        hint: letters, digits and `_`, beginning with a letter, such as `mu_s`
    test.yaml:15:23: problems.slide.scene.bodies.block.mass: `m` is no symbol of the data
        hint: symbols: 2m, theta; or a constant such as `20 kg`
    "#);
}

#[test]
fn g_is_taken() {
    assert_snapshot!(found(&[("      m:\n", "      g:\n")]), @r#"
      7 |       g:
    test.yaml:7:7: problems.slide.data.g: `g` is the acceleration of free fall
        hint: write `gravity: 9.81 m/s^2` at the top of the bank
    test.yaml:15:23: problems.slide.scene.bodies.block.mass: `m` is no symbol of the data
        hint: symbols: g, theta; or a constant such as `20 kg`
    "#);
}

#[test]
fn bad_unit() {
    assert_snapshot!(found(&[("        unit: kg", "        unit: kgg")]), @r#"
      9 |         unit: kgg
    test.yaml:9:15: problems.slide.data.m.unit: `kgg`: unknown unit `kgg`; did you mean `kg`?
        hint: a unit such as kg, m, deg, N/m; `1` for a pure number
    "#);
}

#[test]
fn unit_does_not_fit_the_use() {
    assert_snapshot!(found(&[("        unit: kg", "        unit: N")]), @r#"
      9 |         unit: N
    test.yaml:15:23: problems.slide.scene.bodies.block.mass: `m` has the unit N, but it is used as a mass
        hint: a mass has a unit such as kg
    "#);
}

#[test]
fn min_above_max() {
    assert_snapshot!(found(&[("20 to 40 step 1", "40 to 20 step 1")]), @r#"
     10 |         draw: 40 to 20 step 1
    test.yaml:10:15: problems.slide.data.m.draw: 40 is above 20
        hint: write `20 to 40 step 1`
    "#);
}

#[test]
fn step_does_not_fit() {
    assert_snapshot!(found(&[("20 to 40 step 1", "20 to 40 step 3")]), @r#"
     10 |         draw: 20 to 40 step 3
    test.yaml:10:15: problems.slide.data.m.draw: the step 3 does not lead from 20 to 40
        hint: the last value would be 38: write `20 to 38 step 3`
    "#);
}

#[test]
fn step_not_positive() {
    assert_snapshot!(found(&[("20 to 40 step 1", "20 to 40 step 0")]), @r#"
     10 |         draw: 20 to 40 step 0
    test.yaml:10:15: problems.slide.data.m.draw: the step 0 is not above 0
        hint: a step is a positive number
    "#);
}

#[test]
fn no_step() {
    assert_snapshot!(found(&[("20 to 40 step 1", "20 to 40")]), @r#"
     10 |         draw: 20 to 40
    test.yaml:10:15: problems.slide.data.m.draw: `20 to 40` has no step
        hint: write `20 to 40 step ...`: values are drawn on a grid
    "#);
}

#[test]
fn no_draw() {
    assert_snapshot!(found(&[("draw: 20 to 40 step 1", "draw: about 30")]), @r#"
     10 |         draw: about 30
    test.yaml:10:15: problems.slide.data.m.draw: `about 30` is no draw
        hint: write `25 to 50 step 1`, `one of 10, 20, 45` or `always 30`
    "#);
}

#[test]
fn a_unit_in_the_draw() {
    assert_snapshot!(found(&[("draw: 20 to 40 step 1", "draw: always 30 kg")]), @r#"
     10 |         draw: always 30 kg
    test.yaml:10:15: problems.slide.data.m.draw: `30 kg` is not a decimal number
        hint: write digits with a point, such as 0.30, without a unit
    "#);
}

#[test]
fn nan_and_inf() {
    assert_snapshot!(found(&[("draw: 20 to 40 step 1", "draw: one of .nan, .inf")]), @r#"
     10 |         draw: one of .nan, .inf
    test.yaml:10:15: problems.slide.data.m.draw: `.nan` is not a decimal number
        hint: write digits with a point, such as 0.30, without a unit
    "#);
}

#[test]
fn could_be_drawn_inadmissible() {
    assert_snapshot!(found(&[("20 to 40 step 1", "0 to 40 step 1")]), @r#"
     10 |         draw: 0 to 40 step 1
    test.yaml:8:9: problems.slide.data.m: `m` could be drawn as 0 kg: a mass is above 0
        hint: change the range
    "#);
}

#[test]
fn slope_above_90() {
    assert_snapshot!(found(&[("20 to 60 step 5", "20 to 95 step 5")]), @r#"
     11 |       theta: {name: slope, unit: deg, draw: 20 to 95 step 5}
    test.yaml:11:14: problems.slide.data.theta: `theta` could be drawn as 95 deg: a slope is from 0 to 90 degrees
        hint: change the range
    "#);
}

#[test]
fn not_used() {
    assert_snapshot!(found(&[("      theta:", "      x0: {name: stretch, unit: m, draw: always 1}\n      theta:")]), @r#"
     11 |       x0: {name: stretch, unit: m, draw: always 1}
    test.yaml:11:11: problems.slide.data.x0: `x0` is drawn, but the scene does not use it
        hint: remove it, or use it in the scene
    "#);
}

#[test]
fn not_drawn() {
    assert_snapshot!(found(&[("        draw: 20 to 40 step 1\n", "")]), @r#"
    test.yaml:8:9: problems.slide.data.m: `m` is used as a mass, but it is not drawn
        hint: for example `draw: 20 to 40 step 1`
    "#);
}

#[test]
fn unknown_symbol() {
    assert_snapshot!(found(&[("mass: m,", "mass: M,")]), @r#"
     15 |         block: {mass: M, moves: along incline}
    test.yaml:15:23: problems.slide.scene.bodies.block.mass: `M` is no symbol of the data
        hint: symbols: m, theta; or a constant such as `20 kg`
    "#);
}

#[test]
fn did_you_mean_a_symbol() {
    assert_snapshot!(found(&[("{slope: theta}", "{slope: thetta}")]), @r#"
     13 |       surfaces: {incline: {slope: thetta}}
    test.yaml:13:35: problems.slide.scene.surfaces.incline.slope: `thetta` is no symbol of the data
        hint: did you mean `theta`?
    "#);
}

#[test]
fn a_constant_without_unit() {
    assert_snapshot!(found(&[("mass: m,", "mass: 20,"), ("      m:\n        name: mass\n        unit: kg\n        draw: 20 to 40 step 1\n", "")]), @r#"
     11 |         block: {mass: 20, moves: along incline}
    test.yaml:11:23: problems.slide.scene.bodies.block.mass: `20`: expected kg (mass), found 1 (pure number): a factor kg is missing
        hint: a mass is written like `20 kg`
    "#);
}

#[test]
fn a_constant_of_the_wrong_kind() {
    assert_snapshot!(found(&[("mu_k: 0.2", "mu_k: 0.2 N")]), @r#"
     17 |         - slides: {body: block, mu_k: 0.2 N}
    test.yaml:17:39: problems.slide.scene.ties[0].slides.mu_k: `0.2 N`: expected 1 (pure number), found N (force): a factor N too many
        hint: a friction coefficient is written like `0.4`
    "#);
}

#[test]
fn unknown_surface() {
    assert_snapshot!(found(&[("moves: along incline", "moves: along inclin")]), @r#"
     15 |         block: {mass: m, moves: along inclin}
    test.yaml:15:33: problems.slide.scene.bodies.block.moves: `inclin` is no surface of this scene
        hint: did you mean `incline`?
    "#);
}

#[test]
fn unknown_motion() {
    assert_snapshot!(found(&[("moves: along incline", "moves: sideways")]), @r#"
     15 |         block: {mass: m, moves: sideways}
    test.yaml:15:33: problems.slide.scene.bodies.block.moves: expected how the body moves, found `sideways`
        hint: `along SURFACE`, `vertically`, `about a fixed axle` or `in the plane`
    "#);
}

#[test]
fn unknown_shape() {
    assert_snapshot!(found(&[("block: {mass: m, moves: along incline}", "block: {mass: m, shape: {cube: 1 m}, moves: along incline}")]), @r#"
     15 |         block: {mass: m, shape: {cube: 1 m}, moves: along incline}
    test.yaml:15:34: problems.slide.scene.bodies.block.shape.cube: `cube` is no shape
        hint: known: disc, disk, cylinder, solid cylinder, hoop, ring, hollow cylinder, sphere, ball, shell, hollow sphere, rod
    test.yaml:17:19: problems.slide.scene.ties[0].slides: `block` can turn, so it rolls or slips
        hint: write `rolls:` or `slips:`
    "#);
}

#[test]
fn unknown_tie() {
    assert_snapshot!(found(&[("- slides:", "- glides:")]), @r#"
     17 |         - glides: {body: block, mu_k: 0.2}
    test.yaml:17:11: problems.slide.scene.ties[0].glides: `glides` is no tie
        hint: did you mean `slides`?
    "#);
}

#[test]
fn unknown_body() {
    assert_snapshot!(found(&[("slides: {body: block,", "slides: {body: blok,")]), @r#"
     17 |         - slides: {body: blok, mu_k: 0.2}
    test.yaml:17:26: problems.slide.scene.ties[0].slides.body: expected a body of this scene, found `blok`
        hint: did you mean `block`?
    "#);
}

#[test]
fn a_tie_needs_a_radius() {
    assert_snapshot!(found(&[("- slides: {body: block, mu_k: 0.2}", "- rolls: {body: block, on its: rim}")]), @r#"
     17 |         - rolls: {body: block, on its: rim}
    test.yaml:17:18: problems.slide.scene.ties[0].rolls: `block` has no inertia, so it cannot turn
        hint: give it a `radius of gyration` or a `shape`, or write `slides:`
    test.yaml:17:40: problems.slide.scene.ties[0].rolls.on its: expected a radius of `block`, found `rim`
        hint: give `block` a field `radii`, for example `radii: {rim: R}`
    "#);
}

#[test]
fn a_cord_with_two_ends() {
    assert_snapshot!(found(&[("- slides: {body: block, mu_k: 0.2}", "- slides: {body: block, mu_k: 0.2}\n        - cord: {from: {body: block, tied at: centre, leaves: up}, pulled with: 5 N, held: fast}")]), @r#"
     18 |         - cord: {from: {body: block, tied at: centre, leaves: up}, pulled with: 5 N, held: fast}
    test.yaml:18:17: problems.slide.scene.ties[1].cord: a cord has exactly one other end
        hint: one of `pulled with: P`, `to: {body: ...}`, `spring: {...}`, `held: fast`
    "#);
}

#[test]
fn a_cord_that_leaves_nowhere() {
    assert_snapshot!(found(&[("- slides: {body: block, mu_k: 0.2}", "- slides: {body: block, mu_k: 0.2}\n        - cord: {from: {body: block, tied at: centre, leaves: top}, pulled with: 5 N}")]), @r#"
     18 |         - cord: {from: {body: block, tied at: centre, leaves: top}, pulled with: 5 N}
    test.yaml:18:63: problems.slide.scene.ties[1].cord.from.leaves: expected where the cord leaves, found `top`
        hint: words known here: forward, back, up, down
    "#);
}

#[test]
fn unknown_end() {
    assert_snapshot!(found(&[("end: {travel: {of: block, by: 2 m}}", "end: {travels: {of: block, by: 2 m}}")]), @r#"
     19 |       end: {travels: {of: block, by: 2 m}}
    test.yaml:19:13: problems.slide.scene.end.travels: `travels` is no end
        hint: did you mean `travel`?
    "#);
}

#[test]
fn unknown_start() {
    assert_snapshot!(found(&[("start: at rest", "start: slowly")]), @r#"
     18 |       start: slowly
    test.yaml:18:14: problems.slide.scene.start: expected the start, found `slowly`
        hint: `at rest`, or for example `{wheel: {speed: v0}}`
    "#);
}

#[test]
fn unknown_heading() {
    assert_snapshot!(found(&[("by: 2 m}}", "by: 2 m, heading: left}}")]), @r#"
     19 |       end: {travel: {of: block, by: 2 m, heading: left}}
    test.yaml:19:51: problems.slide.scene.end.travel.heading: expected the direction of motion, found `left`
        hint: words known here: forward, back, up, down
    "#);
}

#[test]
fn unknown_regime() {
    assert_snapshot!(found(&[("regimes: [moves_down]", "regimes: [moves_dwon]")]), @r#"
     20 |     regimes: [moves_dwon]
    test.yaml:20:15: problems.slide.regimes[0]: expected a regime, found `moves_dwon`
        hint: did you mean `moves_down`?
    "#);
}

#[test]
fn unknown_quantity() {
    assert_snapshot!(found(&[("      v: {ask: the speed, unit: m/s}", "      vel: {ask: the speed, unit: m/s}")]), @r#"
     22 |       vel: {ask: the speed, unit: m/s}
    test.yaml:22:7: problems.slide.questions.vel: `vel` is no quantity
        hint: quantities of this scene: kinetic_energy, v, displacement, distance, rise, impulse, a, normal, t, work, rotational_fraction, direction, friction, heat
    "#);
}

#[test]
fn a_quantity_that_does_not_exist_here() {
    assert_snapshot!(found(&[("      v: {ask: the speed, unit: m/s}", "      slip_distance: {ask: the slip, unit: m}")]), @r#"
     22 |       slip_distance: {ask: the slip, unit: m}
    test.yaml:22:7: problems.slide.questions.slip_distance: `slip_distance` does not exist in this scene
        hint: `slip_distance` is: distance that the contact slips, a magnitude; it needs a tie `slips`
    "#);
}

#[test]
fn the_unit_of_a_question() {
    assert_snapshot!(found(&[("unit: m/s}", "unit: m/s^2}")]), @r#"
     22 |       v: {ask: the speed, unit: m/s^2}
    test.yaml:22:33: problems.slide.questions.v.unit: `v`: expected m/s (speed), found m/s^2 (acceleration): a factor s is missing
        hint: for example `unit: m/s`
    "#);
}

#[test]
fn a_word_has_no_unit() {
    assert_snapshot!(found(&[("      v: {ask: the speed, unit: m/s}", "      direction: {ask: which way, unit: m, tolerance: {relative: 1 %}}")]), @r#"
     22 |       direction: {ask: which way, unit: m, tolerance: {relative: 1 %}}
    test.yaml:22:41: problems.slide.questions.direction.unit: `direction` is answered with a word
        hint: remove the unit
    test.yaml:22:55: problems.slide.questions.direction.tolerance: `direction` is answered with a word
        hint: remove the tolerance
    "#);
}

#[test]
fn unknown_ask() {
    assert_snapshot!(found(&[("    questions:", "    asks: [w]\n    questions:")]), @r#"
     21 |     asks: [w]
    test.yaml:21:12: problems.slide.asks[0]: expected the id of a question, found `w`
        hint: questions: v
    "#);
}

#[test]
fn tolerance_out_of_range() {
    assert_snapshot!(found(&[("unit: m/s}", "unit: m/s, tolerance: {relative: 100 %}}")]), @r#"
     22 |       v: {ask: the speed, unit: m/s, tolerance: {relative: 100 %}}
    test.yaml:22:60: problems.slide.questions.v.tolerance.relative: a relative tolerance of `100 %` makes no sense
        hint: above 0 and below 100 %
    "#);
}

#[test]
fn tolerance_of_the_wrong_unit() {
    assert_snapshot!(found(&[("unit: m/s}", "unit: m/s, tolerance: {absolute: 1 m}}")]), @r#"
     22 |       v: {ask: the speed, unit: m/s, tolerance: {absolute: 1 m}}
    test.yaml:22:60: problems.slide.questions.v.tolerance.absolute: `1 m`: expected m/s (speed), found m (length): a factor s too many
        hint: for example `0.5 m/s`
    "#);
}

#[test]
fn points_and_figures() {
    assert_snapshot!(found(&[("unit: m/s}", "unit: m/s, points: -1, figures: 0}")]), @r#"
     22 |       v: {ask: the speed, unit: m/s, points: -1, figures: 0}
    test.yaml:22:46: problems.slide.questions.v.points: expected points from 0 to 1000, found `-1`
    test.yaml:22:59: problems.slide.questions.v.figures: expected a whole number from 1 to 12, found `0`
    "#);
}

#[test]
fn unknown_margin() {
    assert_snapshot!(found(&[("    regimes:", "    margins: {move: 10 %}\n    regimes:")]), @r#"
     20 |     margins: {move: 10 %}
    test.yaml:20:15: problems.slide.margins.move: `move` is no check
        hint: did you mean `moves`?
    "#);
}

#[test]
fn a_margin_that_cannot_hold() {
    assert_snapshot!(found(&[("    regimes:", "    margins: {moves: 100 %}\n    regimes:")]), @r#"
     20 |     margins: {moves: 100 %}
    test.yaml:20:22: problems.slide.margins.moves: a margin of `100 %` cannot hold
        hint: from 0 to below 100 %
    "#);
}

#[test]
fn a_bound_with_an_unknown_name() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v / w: {max: 2}}\n    regimes:")]), @r#"
     20 |     bounds: {v / w: {max: 2}}
    test.yaml:20:14: problems.slide.bounds.v / w: `v / w`, character 5: `w` is no quantity
        hint: quantities of this scene: kinetic_energy, v, displacement, distance, rise, impulse, a, normal, t, work, rotational_fraction, direction, friction, heat
    "#);
}

#[test]
fn a_bound_of_the_wrong_dimension() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v: {max: 8}}\n    regimes:")]), @r#"
     20 |     bounds: {v: {max: 8}}
    test.yaml:20:23: problems.slide.bounds.v.max: `v` has the dimension m s^-1, this limit 1
        hint: write the unit of the limit, for example `8 m s^-1`
    "#);
}

#[test]
fn a_bound_that_is_no_expression() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v +: {max: 8 m/s}}\n    regimes:")]), @r#"
     20 |     bounds: {v +: {max: 8 m/s}}
    test.yaml:20:14: problems.slide.bounds.v +: `v +`, character 4: something is missing at the end
    "#);
}

#[test]
fn a_bound_that_adds_apples_to_pears() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v + m: {max: 8 m/s}}\n    regimes:")]), @r#"
     20 |     bounds: {v + m: {max: 8 m/s}}
    test.yaml:20:14: problems.slide.bounds.v + m: `v + m`, character 4: the terms of a sum have different dimensions, m s^-1 and kg
    "#);
}

#[test]
fn a_bound_the_wrong_way_round() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v: {min: 9 m/s, max: 8 m/s}}\n    regimes:")]), @r#"
     20 |     bounds: {v: {min: 9 m/s, max: 8 m/s}}
    test.yaml:20:17: problems.slide.bounds.v: the least value is above the greatest
    "#);
}

/// The block as a ball, thrown with slip: what is changed below is wrong.
fn thrown(edits: &[(&str, &str)]) -> String {
    let ball = [
        ("block: {mass: m, moves", "ball: {mass: m, shape: {sphere: 0.1 m}, moves"),
        ("- slides: {body: block, mu_k: 0.2}", "- slips: {body: ball, on its: rim, mu_s: 0.4, mu_k: 0.2}"),
        ("start: at rest", "start: {ball: {speed: 4 m/s, spin: -3 rad/s}}"),
        ("end: {travel: {of: block, by: 2 m}}", "end: {rolling: ball}"),
        ("regimes: [moves_down]", "regimes: [rolls_after]"),
    ];
    found(&[&ball[..], edits].concat())
}

#[test]
fn a_body_thrown_with_slip() {
    assert!(thrown(&[]).ends_with("no finding"), "{}", thrown(&[]));
    // What is said, without the lines that are shown above it.
    let said = |edit: (&str, &str)| {
        let text = thrown(&[edit]);
        text.lines().filter(|l| !l.contains(" | ")).map(|l| format!("{l}\n")).collect::<String>()
    };
    let slips = "        - slips: {body: ball, on its: rim, mu_s: 0.4, mu_k: 0.2}";
    let all = [
        ("{ball: {speed: 4 m/s, spin: -3 rad/s}}", "at rest"),
        ("{rolling: ball}", "{rolling: wheel}"),
        ("{rolling: ball}", "{rollng: ball}"),
        ("{rolling: ball}", "{time: {of: ball, is: 2 s, heading: up}}"),
        ("{rolling: ball}", "{rise: {of: ball, by: 0.1 m}}"),
        (slips, "        - rolls: {body: ball, on its: rim, mu_s: 0.4}"),
        ("v: {ask: the speed, unit: m/s}", "slip_sped: {ask: the speed, unit: m/s}"),
        ("[rolls_after]", "[rolls after]"),
    ]
    .map(said);
    assert_snapshot!(all.concat(), @r#"
    test.yaml:19:12: problems.slide.scene.end: `rolling` ends the slip of a body that is thrown with one; `ball` is not
        hint: write `slips:` for `ball` and `start: {ball: {speed: v0, spin: w0}}`
    test.yaml:19:22: problems.slide.scene.end.rolling: expected a body of this scene, found `wheel`
        hint: bodies: ball
    test.yaml:19:13: problems.slide.scene.end.rollng: `rollng` is no end
        hint: did you mean `rolling`?
    test.yaml:19:12: problems.slide.scene.end: `ball` is thrown; how it starts says which way it goes
        hint: take `heading` away
    test.yaml:19:12: problems.slide.scene.end: `ball` is thrown; how it starts says which way it goes
        hint: write `travel`, along its line
    test.yaml:19:12: problems.slide.scene.end: `rolling` ends the slip of a body that is thrown with one; `ball` is not
        hint: write `slips:` for `ball` and `start: {ball: {speed: v0, spin: w0}}`
    test.yaml:22:7: problems.slide.questions.slip_sped: `slip_sped` is no quantity
        hint: did you mean `slip_speed`?
    test.yaml:20:15: problems.slide.regimes[0]: expected a regime, found `rolls after`
        hint: did you mean `rolls_after`?
    "#);
}

#[test]
fn of_what_rolls_one_speed_gives_the_other() {
    let edits = [
        ("block: {mass: m, moves", "ball: {mass: m, shape: {sphere: 0.1 m}, moves"),
        ("- slides: {body: block, mu_k: 0.2}", "- rolls: {body: ball, on its: rim}"),
        ("start: at rest", "start: {ball: {speed: 4 m/s, spin: 40 rad/s}}"),
        ("of: block", "of: ball"),
    ];
    assert_snapshot!(found(&edits), @r#"
     15 |         ball: {mass: m, shape: {sphere: 0.1 m}, moves: along incline}
     17 |         - rolls: {body: ball, on its: rim}
     18 |       start: {ball: {speed: 4 m/s, spin: 40 rad/s}}
     19 |       end: {travel: {of: ball, by: 2 m}}
    test.yaml:18:14: problems.slide.scene.start: the ties leave one freedom, so one speed at the start gives all others
        hint: give one speed or spin
    "#);
}

#[test]
fn tolerances_and_limits_of_condition_numbers() {
    let question = "{ask: the speed, unit: m/s}";
    let with = |more: &str| format!("{{ask: the speed, unit: m/s, {more}}}");
    for fine in [
        "tolerance: {relative: widens with cond}",
        "tolerance: {relative: {least: 2 %, per cond: 0.5 %, most: 8 %}}",
        "cond limit: 20",
    ] {
        assert!(found(&[(question, &with(fine))]).ends_with("no finding"), "{fine}");
    }
    assert!(
        found(&[("title: Test", "title: Test\ncond limit: 12.5\ninput energy limit: 3")])
            .ends_with("no finding")
    );
    let edits = [
        (question, with("tolerance: {relative: widens with cnod}")),
        (question, with("tolerance: {relative: {least: 6 %, per cond: 0.3 %, most: 5 %}}")),
        (question, with("tolerance: {relative: {least: 1 %, most: 5 %}}")),
        (question, with("tolerance: {relative: {least: 1 %, per cond: 0.3 %, most: 500 %}}")),
        (question, with("cond limit: high")),
        (question, with("cond limit: 0.5")),
        ("v: {ask: the speed, unit: m/s}", "direction: {ask: whither, cond limit: 20}".to_owned()),
        ("title: A block", "title: A block\n    cond limit: -1".to_owned()),
        ("title: A block", "title: A block\n    input energy limit: 4 J".to_owned()),
        ("title: Test", "title: Test\ncond limits: 12".to_owned()),
    ];
    let all: String = edits
        .iter()
        .map(|(from, to)| {
            let text = found(&[(*from, to.as_str())]);
            text.lines().filter(|l| !l.contains(" | ")).map(|l| format!("{l}\n")).collect::<String>()
        })
        .collect();
    assert_snapshot!(all, @r#"
    test.yaml:22:60: problems.slide.questions.v.tolerance.relative: expected a relative tolerance, found `widens with cnod`
        hint: write `1 %`, `widens with cond` or `{least: 1 %, per cond: 0.3 %, most: 5 %}`
    test.yaml:22:60: problems.slide.questions.v.tolerance.relative: the least tolerance is above the most
    test.yaml:22:60: problems.slide.questions.v.tolerance.relative: `per cond` is missing
        hint: for example `per cond: 0.3 %`
    test.yaml:22:96: problems.slide.questions.v.tolerance.relative.most: a relative tolerance of `500 %` makes no sense
        hint: above 0 and below 100 %
    test.yaml:22:50: problems.slide.questions.v.cond limit: expected a condition number from 1 to 1000, found `high`
    test.yaml:22:50: problems.slide.questions.v.cond limit: expected a condition number from 1 to 1000, found `0.5`
    test.yaml:22:45: problems.slide.questions.direction.cond limit: `direction` is answered with a word
        hint: remove the limit
    test.yaml:6:17: problems.slide.cond limit: expected a condition number from 1 to 1000, found `-1`
    test.yaml:6:25: problems.slide.input energy limit: expected a multiple of the kinetic energy from 1 to 1000, found `4 J`
    test.yaml:3:1: cond limits: unknown field `cond limits`
        hint: did you mean `cond limit`?
    "#);
}

#[test]
fn a_bound_without_limits() {
    assert_snapshot!(found(&[("    regimes:", "    bounds: {v: {}}\n    regimes:")]), @r#"
     20 |     bounds: {v: {}}
    test.yaml:20:17: problems.slide.bounds.v: this bound bounds nothing
        hint: give `min`, `max` or both
    "#);
}

#[test]
fn bad_share() {
    assert_snapshot!(found(&[("    questions:", "    cases: {steep: {share: 0}}\n    questions:")]), @r#"
     21 |     cases: {steep: {share: 0}}
    test.yaml:21:28: problems.slide.cases.steep.share: expected a whole number from 1 to 1000000, found `0`
    "#);
}

#[test]
fn a_case_draws_an_unknown_symbol() {
    assert_snapshot!(found(&[("    questions:", "    cases: {steep: {draws: {thta: always 60}}}\n    questions:")]), @r#"
     21 |     cases: {steep: {draws: {thta: always 60}}}
    test.yaml:21:29: problems.slide.cases.steep.draws.thta: `thta` is no symbol of the data
        hint: did you mean `theta`?
    "#);
}

#[test]
fn unknown_name_in_a_statement() {
    assert_snapshot!(found(&[("    questions:", "    statement: A block of mass {{ m }} on {{ theta }}, {{ mu }}.\n    questions:")]), @r#"
     21 |     statement: A block of mass {{ m }} on {{ theta }}, {{ mu }}.
    test.yaml:21:16: problems.slide.statement: `{{ mu }}` is not known
        hint: known names: m, theta, g, value, tex, title, number, case, count, particles, motion, series, questions
    "#);
}

#[test]
fn a_datum_that_the_statement_never_gives() {
    assert_snapshot!(found(&[("    questions:", "    statement: A block of mass {{ m }}.\n    questions:")]), @r#"
     21 |     statement: A block of mass {{ m }}.
    test.yaml:21:16: problems.slide.statement: the statement never gives `theta`
        hint: write `{{ theta }}` where it belongs
    "#);
}

#[test]
fn a_statement_that_is_no_template() {
    assert_snapshot!(found(&[("    questions:", "    statement: A block of mass {{ m on {{ theta }}.\n    questions:")]), @r#"
     21 |     statement: A block of mass {{ m on {{ theta }}.
    test.yaml:21:16: problems.slide.statement: template: Found identifier but expected }}. (line 1, column 22 of the text)
    "#);
}

#[test]
fn unknown_name_in_a_question() {
    assert_snapshot!(found(&[("{ask: the speed, unit: m/s}", "{ask: 'the speed at {{ d }}', unit: m/s}")]), @r#"
     22 |       v: {ask: 'the speed at {{ d }}', unit: m/s}
    test.yaml:22:16: problems.slide.questions.v.ask: `{{ d }}` is not known
        hint: known names: m, theta, g, value, tex, title, number, case, count, particles, motion, series, questions
    "#);
}

#[test]
fn gravity_of_the_wrong_kind() {
    assert_snapshot!(found(&[("title: Test", "title: Test\ngravity: 9.81 m/s")]), @r#"
      3 | gravity: 9.81 m/s
    test.yaml:3:10: gravity: `9.81 m/s` is no acceleration of free fall
        hint: for example `gravity: 9.81 m/s^2`
    "#);
}

#[test]
fn on_and_off() {
    assert_snapshot!(found(&[("title: Test", "title: Test\nself check: yes")]), @r#"
      3 | self check: yes
    test.yaml:3:13: self check: expected `on` or `off`, found `yes`
    "#);
}

#[test]
fn ties_that_leave_nothing_free() {
    assert_snapshot!(found(&[("- slides: {body: block, mu_k: 0.2}", "- slides: {body: block, mu_k: 0.2}\n        - cord: {from: {body: block, tied at: centre, leaves: up}, held: fast}")]), @r#"
     18 |         - cord: {from: {body: block, tied at: centre, leaves: up}, held: fast}
    test.yaml:13:7: problems.slide.scene: the ties leave nothing free to move
        hint: take one of the ties away, or write `slips:` for a wheel that they keep from rolling
    "#);
}

#[test]
fn faults_in_the_scene_hide_no_others() {
    assert_snapshot!(found(&[("mass: m,", "mass: N,"), ("20 to 60 step 5", "20 to 95 step 5"), ("unit: m/s}", "unit: kg}"), ("    regimes:", "    bounds: {vel: {max: 8}}\n    regimes:")]), @r#"
     11 |       theta: {name: slope, unit: deg, draw: 20 to 95 step 5}
     15 |         block: {mass: N, moves: along incline}
     20 |     bounds: {vel: {max: 8}}
     23 |       v: {ask: the speed, unit: kg}
    test.yaml:11:14: problems.slide.data.theta: `theta` could be drawn as 95 deg: a slope is from 0 to 90 degrees
        hint: change the range
    test.yaml:15:23: problems.slide.scene.bodies.block.mass: `N` is no symbol of the data
        hint: symbols: m, theta; or a constant such as `20 kg`
    test.yaml:20:14: problems.slide.bounds.vel: `vel`, character 1: `vel` is no quantity
    test.yaml:23:33: problems.slide.questions.v.unit: `v`: expected m/s (speed), found kg (mass)
        hint: for example `unit: m/s`
    "#);
}

#[test]
fn all_at_once() {
    assert_snapshot!(found(&[("        unit: kg", "        unit: kgg"), ("20 to 60 step 5", "60 to 20 step 5"), ("start: at rest", "start: slowly"), ("unit: m/s}", "unit: kg}"), ("regimes: [moves_down]", "regimes: [moves_dwon]")]), @r#"
      9 |         unit: kgg
     11 |       theta: {name: slope, unit: deg, draw: 60 to 20 step 5}
     18 |       start: slowly
     20 |     regimes: [moves_dwon]
     22 |       v: {ask: the speed, unit: kg}
    test.yaml:9:15: problems.slide.data.m.unit: `kgg`: unknown unit `kgg`; did you mean `kg`?
        hint: a unit such as kg, m, deg, N/m; `1` for a pure number
    test.yaml:11:45: problems.slide.data.theta.draw: 60 is above 20
        hint: write `20 to 60 step 5`
    test.yaml:18:14: problems.slide.scene.start: expected the start, found `slowly`
        hint: `at rest`, or for example `{wheel: {speed: v0}}`
    test.yaml:20:15: problems.slide.regimes[0]: expected a regime, found `moves_dwon`
        hint: did you mean `moves_down`?
    test.yaml:22:33: problems.slide.questions.v.unit: `v`: expected m/s (speed), found kg (mass)
        hint: for example `unit: m/s`
    "#);
}

/// All that a bomb costs is a finding, in plain words (earlier any finding would do, also the reader's own name for it).
#[test]
fn bombs_are_refused() {
    let laughs = (1..12).fold("a0: &a0 [x, x]\n".to_owned(), |mut text, i| {
        let before = i - 1;
        writeln!(
            text,
            "a{i}: &a{i} [*a{before}, *a{before}, *a{before}, *a{before}, *a{before}, *a{before}]"
        )
        .unwrap();
        text
    });
    let deep = "[".repeat(40_000);
    let nested = (0..2000).fold(String::new(), |mut text, i| {
        writeln!(text, "{}a:", " ".repeat(i)).unwrap();
        text
    });
    let long = "a: b\n".repeat(slipstick::bank::yaml::MAX_BYTES / 4);
    for bomb in [
        laughs.clone(),
        deep,
        nested,
        long,
        String::new(),
        "\0".to_owned(),
        "- 1\n- 2".to_owned(),
        "42".to_owned(),
    ] {
        let found = load::bank(&bomb, "bomb.yaml", &template::variables_of).unwrap_err();
        assert!(!found.is_empty());
        for finding in &found {
            let told = finding.to_string();
            assert!(!told.contains("budget") && !told.contains("breach") && !told.contains(" { "), "{told}");
            assert!(bomb != laughs || told.contains("alias") && finding.hint.is_some(), "{told}");
        }
    }
}

const WHOLE: &str = include_str!("../../banks/hoists-and-pulleys.yaml");
const WHEELS: &str = include_str!("../../banks/wheels-on-inclines.yaml");

fn mutated(bank: &str, edits: &[(usize, u8, String)]) -> String {
    let mut lines: Vec<String> = bank.lines().map(str::to_owned).collect();
    for (place, kind, text) in edits {
        let i = place % lines.len();
        match kind % 8 {
            0 => drop(lines.remove(i)),
            1 => lines[i] = text.clone(),
            2 => lines.insert(i, text.clone()),
            3 => lines[i].push_str(text),
            4 => {
                let line = lines[i].clone();
                lines.insert(place / 7 % lines.len(), line);
            }
            5 => lines[i] = format!(" {}", lines[i]),
            6 => {
                let at = lines[i].char_indices().nth(place / 11 % 20).map_or(0, |(at, _)| at);
                lines[i].insert_str(at, text);
            }
            _ => {
                lines[i] = lines[i].replacen(|c: char| c.is_ascii_digit(), text, 1);
            }
        }
        if lines.is_empty() {
            lines.push(String::new());
        }
    }
    lines.join("\n")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    /// Whatever is done to a bank, reading it ends in a bank or in findings.
    #[test]
    fn mutants_of_a_bank_do_not_panic(
        wheels in any::<bool>(),
        edits in prop::collection::vec(
            (any::<usize>(), any::<u8>(), "[ -~]{0,12}|[a-z{}:\\[\\],.&*!|>%@`'\"0-9 ]{0,8}|\\PC{0,4}"), 1..6),
    ) {
        let text = mutated(if wheels { WHEELS } else { WHOLE }, &edits);
        if let Err(found) = load::bank(&text, "mutant.yaml", &template::variables_of) {
            prop_assert!(!found.is_empty());
            for finding in found {
                prop_assert!(!finding.to_string().is_empty());
            }
        }
    }

    /// So does any text at all.
    #[test]
    fn no_text_panics(text in "\\PC{0,80}|[a-z:{}\\[\\] \\n-]{0,200}") {
        let _ = load::bank(&text, "text.yaml", &template::variables_of);
    }

    /// Expressions of bounds, too.
    #[test]
    fn no_bound_panics(text in "[a-z0-9+*/^()., -]{0,40}") {
        let edit = format!("    bounds:\n      ? \"{text}\"\n      : {{max: 8 m/s}}\n    regimes:");
        let bank = SOUND.replacen("    regimes:", &edit, 1);
        let _ = load::bank(&bank, "bound.yaml", &template::variables_of);
    }
}

/// The block as a rod that swings about a pin: what is changed below is wrong.
fn swinging(edits: &[(&str, &str)]) -> String {
    let rod = [
        ("      surfaces: {incline: {slope: theta}}\n", ""),
        (
            "block: {mass: m, moves: along incline}",
            "rod: {mass: m, shape: {rod: 2 m}, pinned: at its end, angle: from upright}",
        ),
        (
            "      ties:\n        - slides: {body: block, mu_k: 0.2}",
            "      forces:\n        - spring: {on: rod, at: 2 m, anchor: [0 m, 1 m], stiffness: 9 N/m, stretch: 0.1 m}",
        ),
        ("start: at rest", "start: {rod: {angle: theta}}"),
        ("end: {travel: {of: block, by: 2 m}}", "end: {angle: {of: rod, reaches: 120 deg}}"),
        ("regimes: [moves_down]", "regimes: [swings ok]"),
        ("v: {ask: the speed, unit: m/s}", "omega: {ask: the angular speed}"),
    ];
    found(&[&rod[..], edits].concat())
}

#[test]
fn a_pinned_body() {
    assert!(swinging(&[]).ends_with("no finding"), "{}", swinging(&[]));
    let said = |edit: (&str, &str)| {
        let text = swinging(&[edit]);
        text.lines().filter(|l| !l.contains(" | ")).map(|l| format!("{l}\n")).collect::<String>()
    };
    let spring = "        - spring: {on: rod, at: 2 m, anchor: [0 m, 1 m], stiffness: 9 N/m, stretch: 0.1 m}";
    let twice = format!("{spring}\n{spring}");
    let tied = format!(
        "{spring}\n      ties:\n        - cord: {{from: {{body: rod, tied at: centre, leaves: up}}, pulled with: 3 N}}"
    );
    let all = [
        ("pinned: at its end, angle: from upright", "pinned: at its end"),
        ("angle: from upright", "angle: from uprigth"),
        ("pinned: at its end", "pinned: at its ends"),
        ("pinned: at its end", "pinned: {distanse: 1 m}"),
        ("shape: {rod: 2 m}", "shape: {disc: 2 m}"),
        ("shape: {rod: 2 m}, ", ""),
        ("pinned: at its end,", "pinned: at its end, moves: vertically, radii: {rim: 2 m},"),
        ("pinned: at its end, ", ""),
        ("{rod: {angle: theta}}", "at rest"),
        ("{rod: {angle: theta}}", "{rod: {angle: theta, speed: 2 m/s}}"),
        ("{rod: {angle: theta}}", "{rod: {angle: 400 deg}}"),
        ("{angle: {of: rod, reaches: 120 deg}}", "{travel: {of: rod, by: 2 rad}}"),
        ("{angle: {of: rod, reaches: 120 deg}}", "{angle: {of: rod, reaches: 2 m}}"),
        ("{angle: {of: rod, reaches: 120 deg}}", "{angel: {of: rod, reaches: 120 deg}}"),
        ("reaches: 120 deg}", "reaches: 120 deg, heading: forward}"),
        ("anchor: [0 m, 1 m]", "anchor: 1 m"),
        (", stretch: 0.1 m", ""),
        ("- spring:", "- sprng:"),
        (spring, twice.as_str()),
        (spring, tied.as_str()),
        ("omega: {ask: the angular speed}", "period: {ask: the period}"),
        ("omega: {ask: the angular speed}", "pin_radail: {ask: the force}"),
        ("[swings ok]", "[swings, ok]"),
    ]
    .map(said);
    assert_snapshot!(all.concat(), @r#"
    test.yaml:14:51: problems.slide.scene.bodies.rod.pinned: `angle` of `rod` is missing
        hint: write `angle: from upright` (mass centre above the pin) or `angle: from hanging`
    test.yaml:14:70: problems.slide.scene.bodies.rod.angle: expected from where the angle counts, found `from uprigth`
        hint: did you mean `from upright`?
    test.yaml:14:51: problems.slide.scene.bodies.rod.pinned: expected `at its end` or `{distance: h}`, found `at its ends`
        hint: did you mean `at its end`?
    test.yaml:14:51: problems.slide.scene.bodies.rod.pinned: `distance` is missing
        hint: for example `distance: h`
    test.yaml:14:52: problems.slide.scene.bodies.rod.pinned.distanse: unknown field `distanse`
        hint: did you mean `distance`?
    test.yaml:14:52: problems.slide.scene.bodies.rod.pinned: `rod` is no rod, so it has no end
        hint: write `pinned: {distance: h}` with the distance from the pin to the mass centre
    test.yaml:14:14: problems.slide.scene.bodies.rod: `rod` has no inertia, so it cannot swing
        hint: give it a `shape`, a `radius of gyration` or a `moment of inertia`
    test.yaml:14:70: problems.slide.scene.bodies.rod.moves: a pinned body moves about its pin, not along a line
        hint: remove this field
    test.yaml:14:89: problems.slide.scene.bodies.rod.radii: nothing rolls on a pinned body and no cord is wound on it
        hint: remove this field
    test.yaml:14:50: problems.slide.scene.bodies.rod.angle: `rod` has an angle, but `pinned` is missing
        hint: write `pinned: at its end` (a rod) or `pinned: {distance: h}`
    test.yaml:17:14: problems.slide.scene.start: the angle at which `rod` starts is missing
        hint: write `start: {rod: {angle: phi0}}`
    test.yaml:17:42: problems.slide.scene.start.rod.speed: `rod` does not move along a line
        hint: write `spin:`
    test.yaml:17:28: problems.slide.scene.start.rod.angle: `400 deg`: an angle is from -360 to 360 degrees
    test.yaml:18:13: problems.slide.scene.end.travel: `rod` is pinned: it ends at an angle
        hint: write `angle: {of: rod, reaches: phi1}`
    test.yaml:18:39: problems.slide.scene.end.angle.reaches: `2 m`: expected deg (angle), found m (length)
        hint: an angle is written like `30 deg`
    test.yaml:18:13: problems.slide.scene.end.angel: `angel` is no end
        hint: did you mean `angle`?
    test.yaml:18:57: problems.slide.scene.end.angle.heading: a pinned body goes where its forces or its start take it
        hint: remove this field
    test.yaml:16:46: problems.slide.scene.forces[0].spring.anchor: expected a place such as `[x_A, y_A]`, found `1 m`
    test.yaml:16:19: problems.slide.scene.forces[0].spring: a spring has a natural length, or a stretch at the start
        hint: write `natural length: l0`, or `stretch: x0`
    test.yaml:16:11: problems.slide.scene.forces[0].sprng: `sprng` is no force
        hint: did you mean `spring`?
    test.yaml:17:19: problems.slide.scene.forces[1].spring: `rod` has a spring already
        hint: a scene has at most one spring
    test.yaml:18:24: problems.slide.scene.ties[0].cord.from: no cord is tied to the pinned body `rod`
        hint: a spring stands under `forces`: `spring: {on: ..., at: b, anchor: [x_A, y_A], ...}`
    test.yaml:21:7: problems.slide.questions.period: `period` does not exist in this scene
        hint: `period` is: time of a full swing to and fro, or of a full turn where it goes over the top; it needs a pinned body that swings under its weight alone
    test.yaml:21:7: problems.slide.questions.pin_radail: `pin_radail` is no quantity
        hint: did you mean `pin_radial`?
    test.yaml:19:15: problems.slide.regimes[0]: expected a regime, found `swings`
        hint: regimes: moves_up, balanced, moves_down, moves_forward, moves_back, rolls, at_limit, slips_up, spins_in_place, slips_down, slips_forward, slips_back, up ok, up turning_point, up unreachable, down ok, down turning_point, down unreachable, forward ok, forward turning_point, forward unreachable, back ok, back turning_point, back unreachable, rest, swings ok, swings turning_point, swings unreachable, rolls_after, rolls_at_start, slips_through, never, instant
    test.yaml:19:23: problems.slide.regimes[1]: expected a regime, found `ok`
        hint: regimes: moves_up, balanced, moves_down, moves_forward, moves_back, rolls, at_limit, slips_up, spins_in_place, slips_down, slips_forward, slips_back, up ok, up turning_point, up unreachable, down ok, down turning_point, down unreachable, forward ok, forward turning_point, forward unreachable, back ok, back turning_point, back unreachable, rest, swings ok, swings turning_point, swings unreachable, rolls_after, rolls_at_start, slips_through, never, instant
    "#);
}

#[test]
fn wrong_methods() {
    let said = [
        "{A01: {data: {mm: 1}}}",
        "{A01: {of: [v]}}",
        "{0A: {values: {v: 2*q}}}",
        "{A01: {values: {omega: v, v: 2*v}}}",
        "{A01: {values: {v: 2*v}, cases: [steep]}}",
        "{A01: {values: {v: 2*v}, cases: steep}}",
        "{A01: {scene: {ties: none}, unguarded: ''}}",
    ]
    .map(|mistakes| {
        let field = format!("    regimes: [moves_down]\n    mistakes: {mistakes}\n");
        found(&[("    regimes: [moves_down]\n", &field)])
    });
    assert_snapshot!(said.join(""), @r#"
     21 |     mistakes: {A01: {data: {mm: 1}}}
    test.yaml:21:29: problems.slide.mistakes.A01.data.mm: `mm` is no symbol of the data
     21 |     mistakes: {A01: {of: [v]}}
    test.yaml:21:21: problems.slide.mistakes.A01: this wrong method changes nothing
        hint: `data: {k: R/sqrt(2)}`, `scene: {ties: [...]}` or `values: {omega: v/R}`
     21 |     mistakes: {0A: {values: {v: 2*q}}}
    test.yaml:21:16: problems.slide.mistakes.0A: `0A` is no id of a wrong method
        hint: letters, digits and `-`, beginning with a letter, such as `A05` or `rotation-forgotten`
    test.yaml:21:33: problems.slide.mistakes.0A.values.v: `2*q`, character 3: `q` is no quantity
        hint: quantities of this scene: kinetic_energy, v, displacement, distance, rise, impulse, a, normal, t, work, rotational_fraction, direction, friction, heat
     21 |     mistakes: {A01: {values: {omega: v, v: 2*v}}}
    test.yaml:21:31: problems.slide.mistakes.A01.values.omega: `omega` does not exist in this scene
        hint: `omega` is: angular speed at the end, a magnitude; nothing turns here
     21 |     mistakes: {A01: {values: {v: 2*v}, cases: [steep]}}
    test.yaml:21:48: problems.slide.mistakes.A01.cases[0]: `steep` is no case of this problem
     21 |     mistakes: {A01: {values: {v: 2*v}, cases: steep}}
    test.yaml:21:47: problems.slide.mistakes.A01.cases: expected a list of cases, found `steep`
     21 |     mistakes: {A01: {scene: {ties: none}, unguarded: ''}}
    test.yaml:21:36: problems.slide.mistakes.A01.scene.ties: expected a list of ties, each after `- `, found `none`
    test.yaml:21:54: problems.slide.mistakes.A01.unguarded: expected the reason why no draw is refused for it
        hint: a sentence
    "#);
}
