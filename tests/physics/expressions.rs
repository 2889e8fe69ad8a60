//! Expressions in the place of numbers: what they come to on both roads, enclosed, and what is said of wrong ones.
use slipstick::bank::{Bank, Problem, load};
use slipstick::finding::Findings;
use slipstick::problem::maker::Maker;
use slipstick::problem::variant::Variant;
use slipstick::scene::{Label, Owner, Quantity};

const DATA: &str = "
      m:     {name: mass of the wheel, unit: kg, draw: 2 to 9 step 0.5}
      R:     {name: radius of the wheel, unit: mm, draw: 200 to 400 step 10}
      k_O:   {name: radius of gyration about a point of the rim, unit: mm, draw: 440 to 520 step 10}
      theta: {name: slope, unit: deg, draw: 10 to 25 step 1}
      h:     {name: height, unit: m, draw: 1 to 2 step 0.1}";

/// A wheel that rolls down an incline by a height, of which the inertia about a point of the rim is known.
fn wheel(moment: &str, by: &str, more: &str) -> String {
    format!(
        "bank: b
title: B
problems:
  p:
    title: A wheel
    data:{DATA}
    scene:
      surfaces: {{incline: {{slope: theta}}}}
      bodies:
        wheel: {{mass: m, moment of inertia: {moment}, radii: {{rim: R}}, moves: along incline, positive: down}}
      ties: [rolls: {{body: wheel, on its: rim}}]
      start: at rest
      end: {{travel: {{of: wheel, by: {by}}}}}
    bounds: {{k_O / R: {{min: 1.2, max: 1.6}}}}
{more}    questions:
      v: {{ask: the speed, unit: m/s}}
    statement: s
"
    )
}

fn read(text: &str) -> Result<Bank, Findings> {
    load::scenes_only(text, "bank.yaml")
}

fn drawn(problem: &Problem, student: &str) -> Variant {
    Maker::new(problem, 7, "set").variant(student).expect("a variant")
}

#[test]
fn a_scene_of_expressions_is_solved_and_enclosed() {
    let bank = read(&wheel("m*(k_O^2 - R^2)", "h/sin(theta)", "")).expect("a bank");
    let v = Label { quantity: Quantity::V, of: Owner::Body(0) };
    for i in 0..20 {
        let variant = drawn(&bank.problems[0], &format!("s{i}"));
        let [_, r, k, _, h, g] = variant.data[..] else { panic!("six data") };
        // Energy: 2 g h = v^2 (1 + (k_O^2 - R^2)/R^2) = v^2 k_O^2/R^2.
        let exact = (2.0 * g * h).sqrt() * r / k;
        let entry = variant.solved.get(v).expect("a speed");
        for road in [entry.eom, entry.energy] {
            assert!((road.expect("both roads") - exact).abs() < 1e-14 * exact, "{road:?} {exact}");
        }
        // sqrt(h) R/k_O sqrt(g), and nothing of m or theta: their parts cancel.
        assert!((entry.cond - 3.0).abs() < 1e-4, "{}", entry.cond);
        let bound = entry.bound.expect("enclosed");
        assert!(bound > 0.0 && bound < 1e-14 * exact, "{bound}");
    }
}

#[test]
fn an_enclosure_knows_what_cancels_in_an_expression() {
    // The data are decimals, known to some 1e-16 of themselves: of their difference that is much more.
    let text =
        wheel("m*(k_O^2 - R^2)", "h - 0.999999*h", "").replace("unit: m/s", "unit: m/s, cond limit: 1000");
    let bank = read(&text).expect("a bank");
    let v = Label { quantity: Quantity::V, of: Owner::Body(0) };
    let of = |bank: &Bank| drawn(&bank.problems[0], "s").solved.get(v).expect("a speed").clone();
    let entry = of(&bank);
    let other = of(&read(&text.replace("h - 0.999999*h", "h")).expect("a bank"));
    let share = |e: &slipstick::solve::outcome::Entry| e.bound.expect("enclosed") / e.value();
    assert!(share(&entry) > 1e4 * share(&other), "{} {}", share(&entry), share(&other));
}

#[test]
fn wrong_data_go_through_expressions() {
    // Who takes k_O for the radius of gyration about the centre.
    let mistakes = "    mistakes: {K01: {data: {k_O: sqrt(k_O^2 + R^2)}}}\n";
    let bank = read(&wheel("m*(k_O^2 - R^2)", "h/sin(theta)", mistakes)).expect("a bank");
    let variant = drawn(&bank.problems[0], "s");
    let [_, r, k, _, h, g] = variant.data[..] else { panic!("six data") };
    let wrong = (2.0 * g * h / (1.0 + k * k / (r * r))).sqrt();
    let found = variant.wrong.first().expect("a wrong value").value;
    assert!((found - wrong).abs() < 1e-12 * wrong, "{found} {wrong}");
}

#[test]
fn what_is_wrong_with_an_expression_is_told() {
    let cases = [
        (
            "m*(k_O^2 - R)",
            "h",
            "`m*(k_O^2 - R)`, character 11: the terms of a sum have different dimensions, m^2 and m",
        ),
        ("m*k_O", "h", "`m*k_O` has the dimension kg m, but it is used as a moment of inertia"),
        ("m*k_0^2", "h", "`m*k_0^2`, character 3: `k_0` is no symbol of the data"),
        ("m*(k_O^2 - R^2", "h", "character 15: `)` is missing"),
        ("m*R^2", "2*h m", "`2*h m`, character 5: `m` is not expected here"),
        ("m*R^2", "h/sin(h)", "`sin` takes an angle"),
        ("m*R^2", "-2*3", "`-2*3` has the dimension 1, but it is used as a length"),
        ("m*R^2*v", "h", "`v` is no symbol of the data"),
        ("m*R^2*2 kg", "h", "numbers of an expression have no unit"),
    ];
    for (moment, by, wanted) in cases {
        let found = read(&wheel(moment, by, "")).expect_err(wanted);
        let all: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(all.iter().any(|f| f.contains(wanted)), "{wanted}\n{}", all.join("\n"));
    }
}

#[test]
fn a_number_with_its_unit_is_no_expression() {
    for moment in ["4 kg*m^2", "0.5e0 kg m^2", "4 kg·m²"] {
        let found = read(&wheel(moment, "2 m", "")).expect_err("k_O and h are not used");
        let idle = |f: &slipstick::finding::Finding| f.message.contains("the scene does not use it");
        assert!(found.iter().all(idle), "{moment}: {found:#?}");
    }
}
