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
    let of = |bank: &Bank| *drawn(&bank.problems[0], "s").solved.get(v).expect("a speed");
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

/// A spool on the floor, pulled by a cord on its hub, of which several things are asked that no quantity says.
fn spool(contact: &str, questions: &str, more: &str) -> String {
    format!(
        "bank: b
title: B
problems:
  p:
    title: A spool
    data:
      m:    {{name: mass, unit: kg, draw: 20 to 40 step 1}}
      k:    {{name: radius of gyration, unit: m, draw: 0.2 to 0.3 step 0.01}}
      R:    {{name: radius of the rim, unit: m, draw: 0.36 to 0.44 step 0.01}}
      r:    {{name: radius of the hub, unit: m, draw: 0.1 to 0.2 step 0.01}}
      P:    {{name: pull, unit: N, draw: 200 to 400 step 10}}
      mu_s: {{name: coefficient of static friction, unit: \"1\", draw: always 0.2}}
      mu_k: {{name: coefficient of kinetic friction, unit: \"1\", draw: always 0.15}}
    scene:
      surfaces: {{floor: level}}
      bodies: {{spool: {{mass: m, radius of gyration: k, radii: {{rim: R, hub: r}}, moves: along floor}}}}
      ties:
        - {contact}
        - cord: {{from: {{body: spool, wound on: hub, leaves: bottom forward}}, pulled with: P}}
      start: at rest
      end: {{time: {{of: spool, is: 2 s}}}}
    questions:
{questions}{more}    statement: s
"
    )
}

const SLIPS: &str = "slips: {body: spool, on its: rim, mu_s: mu_s, mu_k: mu_k}";
const ASKED: &str = "
      friction_if_rolled: {ask: it, unit: N}
      largest: {value: mu_s*normal, unit: N, ask: it}
      needed:  {quantity: friction, if: rolls, unit: N, ask: it}
      lacking: {value: abs(friction) - mu_s*normal, if: rolls, unit: kN, ask: it}
      free:    {quantity: a, if: smooth, ask: it}
      share:   {value: kinetic_energy/work_pull, unit: \"1\", ask: it}
";

#[test]
fn expressions_and_other_contacts_are_asked_on_both_roads_and_enclosed() {
    let bank = read(&spool(SLIPS, ASKED, "")).expect("a bank");
    let problem = &bank.problems[0];
    for i in 0..20 {
        let variant = drawn(problem, &format!("s{i}"));
        let [m, _, _, _, p, mu_s, _, g] = variant.data[..] else { panic!("the data") };
        let entry = |id: &str| {
            let q = problem.questions.iter().find(|q| q.id == id).expect("a question");
            variant.solved.get(q.label).unwrap_or_else(|| panic!("{id} has no answer"))
        };
        for id in ["largest", "needed", "lacking", "free", "share"] {
            let e = entry(id);
            assert!(e.eom.is_some() && e.energy.is_some(), "{id}: both roads");
            assert!(e.bound.expect("enclosed") < 1e-13 * e.scale, "{id}: {e:?}");
            assert!(e.cond.is_finite() && e.cond > 0.0, "{id}: {}", e.cond);
        }
        let near = |id: &str, expected: f64| {
            let e = entry(id);
            assert!((e.value() - expected).abs() < 1e-13 * e.scale, "{id}: {} {expected}", e.value());
        };
        let rolled = entry("friction_if_rolled").value();
        near("largest", mu_s * m * g);
        near("needed", rolled);
        near("lacking", rolled.abs() - mu_s * m * g);
        near("free", p / m);
        assert!((entry("free").cond - 2.0).abs() < 1e-4);
        // What is asked of another scene leaves that of this one alone.
        let key = Maker::new(problem, 7, "set").key(&variant);
        assert_eq!(key.parts.len(), problem.questions.len());
    }
}

#[test]
fn a_wrong_method_spoils_what_is_put_together_of_it() {
    let mistakes = "    mistakes:
      A24: {values: {normal: m*g + P}}
      B01: {data: {mu_s: 2*mu_s}}
      A05: {data: {k: 0.9*k}, of: [needed]}
";
    let bank = read(&spool(SLIPS, ASKED, mistakes)).expect("a bank");
    let problem = &bank.problems[0];
    let variant = drawn(problem, "s");
    let wrong = |method: usize, id: &str| {
        let q = problem.questions.iter().find(|q| q.id == id).expect("a question");
        variant.wrong.iter().find(|w| w.mistake == method && w.label == q.label).map(|w| w.value)
    };
    let [m, _, _, _, p, mu_s, _, g] = variant.data[..] else { panic!("the data") };
    let near = |found: Option<f64>, expected: f64| {
        assert!(found.is_some_and(|x| (x - expected).abs() < 1e-12 * expected.abs()), "{found:?} {expected}");
    };
    near(wrong(0, "largest"), mu_s * (m * g + p));
    // The method knows nothing of the other scene.
    assert_eq!(wrong(0, "lacking"), None);
    near(wrong(1, "largest"), 2.0 * mu_s * m * g);
    assert_eq!(wrong(1, "needed"), None, "the static coefficient does not enter");
    assert!(wrong(2, "needed").is_some(), "changed data are those of the other scene too");
    assert_eq!(wrong(2, "lacking"), None, "it is not among `of`");
}

/// A collar that moves inward on an arm that turns to the left presses on the side that no word of the program calls positive: asked is
/// the size of the force, and so it is named in bounds, relations and wrong methods. By hand 2 m omega v, from m (r phi'' + 2 r' phi') where
/// the arm has the moment of inertia M l^2/3 and no moment acts.
#[test]
fn a_quantity_is_named_as_it_is_asked() {
    let text = "
bank: b
title: B
problems:
  p:
    title: A collar
    data:
      m: {name: mass of the collar, unit: kg, draw: 1 to 3 step 0.1}
      b: {name: another acceleration, unit: m/s^2, draw: 1 to 3 step 0.1}
    scene:
      bodies:
        arm:    {mass: 3 kg, shape: {rod: 1 m}, moves: in a horizontal plane, angle: from right}
        collar: {mass: m, moves: in a horizontal plane, placed: [0.4 m, 0 m]}
      joints: {O: {pins: arm.A}, wire: {guides: collar, on: arm.A}}
      start: {arm: {angle: 0 deg, spin: 4 rad/s}, collar: {speed: -2 m/s}}
      end: at once
    bounds: {wire.normal: {min: 1 N}}
    mistakes:
      A24: {values: {wire.normal: 0.5*wire.normal}}
      A25: {values: {wire.normal: 2*wire.normal}}
    follows: {n: wire.normal/m + b}
    questions:
      N: {quantity: wire.normal, ask: the force on the collar}
      n: {value: wire.normal/m + b, unit: m/s^2, ask: the force per mass and the other acceleration}
    statement: s
";
    let bank = read(text).expect("a bank");
    let variant = drawn(&bank.problems[0], "s");
    let (m, b) = (variant.data[0], variant.data[1]);
    // The arm turns faster as the collar comes in: alpha = 2 m r v omega/(M l^2/3 + m r^2), with r = 0.4 m.
    let alpha = 2.0 * m * 0.4 * 2.0 * 4.0 / (1.0 + m * 0.16);
    let force = m * (2.0 * 2.0 * 4.0 - 0.4 * alpha);
    let near = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-12 * expected, "{found} {expected}")
    };
    let key = slipstick::problem::make_key::key(&bank.problems[0], &variant);
    let right = |part: usize| match key.parts[part].answer {
        slipstick::key::Answer::Number { value, .. } => value,
        _ => f64::NAN,
    };
    near(right(0), force);
    near(right(1), force / m + b);
    let wrong = |part: usize| key.parts[part].wrong.iter().map(|w| w.value).collect::<Vec<_>>();
    let [halved, doubled] = [0.5, 2.0].map(|by| by * force);
    let found = [wrong(0), wrong(1)].concat();
    for expected in [halved, doubled, halved / m + b, doubled / m + b] {
        assert!(found.iter().any(|x| (x - expected).abs() < 1e-12 * expected), "{found:?} {expected}");
    }
}

#[test]
fn what_is_wrong_with_a_question_by_formula_is_told() {
    let none = "cord: {name: other, from: {body: spool, tied at: centre, leaves: back}, pulled with: P}";
    let cases = [
        (SLIPS, "x: {value: mu_s*normal, ask: it}", "`x` asks for an expression, and `unit` is missing"),
        (
            SLIPS,
            "x: {value: mu_s*normal, unit: m, ask: it}",
            "`mu_s*normal` has the dimension kg m s^-2, its unit m",
        ),
        (SLIPS, "x: {value: mu_s*norm, unit: N, ask: it}", "character 6: `norm` is no quantity"),
        (SLIPS, "x: {value: mu_s*tension, unit: N, ask: it}", "`tension` does not exist in this scene"),
        (SLIPS, "x: {value: normal + m, unit: N, ask: it}", "different dimensions, kg m s^-2 and kg"),
        (SLIPS, "x: {value: 2*rolls, unit: N, ask: it}", "`rolls` is a word, not a number"),
        (SLIPS, "x: {value: normal, quantity: normal, unit: N, ask: it}", "not for a quantity"),
        (SLIPS, "friction: {if: rolls, unit: N, ask: it}", "`friction` is a quantity itself"),
        (SLIPS, "x: {quantity: friction, if: glides, ask: it}", "found `glides`"),
        (SLIPS, "x: {quantity: direction, if: rolls, ask: it}", "`direction` is answered with a word"),
        (SLIPS, "x: {quantity: friction, if: smooth, unit: m, ask: it}", "expected N"),
        (none, "x: {quantity: a, if: rolls, ask: it}", "no contact of this scene could be another"),
        (SLIPS, "x: {if: rolls, ask: it}", "`x` is no quantity"),
    ];
    for (contact, question, wanted) in cases {
        let text = spool(contact, &format!("      {question}\n"), "");
        let found = read(&text).expect_err(wanted);
        let all: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(
            all.iter().any(|f| f.contains(wanted) && f.contains("questions.")),
            "{wanted}\n{}",
            all.join("\n")
        );
    }
}

/// A disc that rolls down by a height, with some of its numbers `any`.
fn disc(body: &str, rest: &str, question: &str) -> String {
    format!(
        "bank: b
title: B
problems:
  p:
    title: A disc
    data:
      theta: {{name: slope, unit: deg, draw: 10 to 25 step 1}}
      h:     {{name: height, unit: m, draw: 1.0 to 4.0 step 0.1}}
    scene:
      surfaces: {{incline: {{slope: theta}}}}
      bodies: {{disc: {{{body}, moves: along incline, positive: down}}}}
      ties: [rolls: {{body: disc, on its: rim}}]
      {rest}
      end: {{travel: {{of: disc, by: h/sin(theta)}}}}
    questions:
      {question}
    statement: s
"
    )
}

const ANY: &str = "mass: any, shape: {disc: any}";
const REST: &str = "start: at rest";

#[test]
fn what_is_any_cancels() {
    let all =
        "{v: {ask: v}, a: {ask: a}, t: {ask: t}, mu_required: {ask: mu}, rotational_fraction: {ask: q}}";
    let questions = all.trim_matches(['{', '}']).to_owned() + "}";
    let bank =
        read(&disc(ANY, REST, "").replace("questions:\n      ", &format!("questions: {{{questions}}}")))
            .expect("a bank");
    let given = disc("mass: 7 kg, shape: {disc: 0.13 m}", REST, "");
    let given =
        read(&given.replace("questions:\n      ", &format!("questions: {{{questions}}}"))).expect("a bank");
    for i in 0..20 {
        let [any, with] = [&bank, &given].map(|b| drawn(&b.problems[0], &format!("s{i}")));
        assert_eq!(any.data, with.data);
        for q in &bank.problems[0].questions {
            let [a, b] = [&any, &with].map(|v| v.solved.get(q.label).expect("an answer").value());
            assert!((a - b).abs() <= 4e-16 * b.abs(), "{}: {a} {b}", q.id);
        }
    }
}

#[test]
fn what_does_not_cancel_is_told() {
    let gyration = "mass: any, radius of gyration: any, radii: {rim: 1 m}";
    let hub = "mass: 2 kg, shape: {disc: any}, radii: {hub: 0.1 m}";
    let couple = "forces: [couple: {on: disc, moment: 3 N*m, sense: forward}]\n      start: at rest";
    let cases = [
        (ANY, REST, "omega: {ask: x}", "`omega` depends on the radius of `disc`, which is `any`"),
        (ANY, REST, "friction: {ask: x}", "`friction` depends on the mass of `disc`, which is `any`"),
        (ANY, REST, "x: {value: v*omega, unit: m/s^2, ask: x}", "`x` depends on the radius of `disc`"),
        (ANY, REST, "x: {value: normal/h, unit: N/m, ask: x}", "`x` depends on the mass of `disc`"),
        (ANY, couple, "v: {ask: x}", "this does not cancel: there is a couple"),
        (ANY, couple, "v: {ask: x}", "this does not cancel: a couple acts on the body"),
        (
            ANY,
            "start: {disc: {spin: 3 rad/s}}",
            "v: {ask: x}",
            "this does not cancel: the body starts with a spin",
        ),
        (gyration, REST, "v: {ask: x}", "a radius of gyration cannot be `any`"),
        (hub, REST, "v: {ask: x}", "this does not cancel: the body has another radius, `hub`"),
    ];
    for (body, rest, question, wanted) in cases {
        let found = read(&disc(body, rest, question)).expect_err(wanted);
        let all: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(all.iter().any(|f| f.contains(wanted)), "{wanted}\n{}", all.join("\n"));
    }
}

/// A stone that falls on the cord of a pulley, timed.
fn stone(mass: &str, time: &str, questions: &str) -> String {
    format!(
        "bank: b
title: B
problems:
  p:
    title: A stone
    data:
      M:  {{name: mass of the pulley, unit: kg, draw: 6.0 to 14.0 step 0.5}}
      y:  {{name: fall, unit: m, draw: 8.0 to 13.0 step 0.1}}
      t1: {{name: measured time, unit: s, {time}}}
      m:  {{name: mass of the stone, unit: kg, {mass}}}
    scene:
      bodies:
        pulley: {{mass: M, shape: {{disc: any}}, moves: about a fixed axle}}
        stone: {{mass: m, moves: vertically, positive: down}}
      ties:
        - cord: {{from: {{body: stone, tied at: centre, leaves: up}}, to: {{body: pulley, wound on: rim, leaves: back down}}}}
      start: at rest
      end: {{travel: {{of: stone, by: y}}}}
    questions: {questions}
    mistakes: {{A05: {{scene: {{bodies: {{pulley: {{mass: M, shape: {{hoop: any}}, moves: about a fixed axle}}, stone: {{mass: m, moves: vertically, positive: down}}}}}}}}}}
    statement: s
"
    )
}

const UNKNOWN: &str = "unknown: 0.2 to 20 step 0.1";
const TIMED: &str = "draw: 2.0 to 3.6 step 0.05, measured: t";
const MASS: &str = "{mass: {value: m, unit: kg, ask: m}, tension: {unit: N, ask: T}}";

#[test]
fn what_is_unknown_is_found_from_the_printed_measurement() {
    let bank = read(&stone(UNKNOWN, TIMED, MASS)).expect("a bank");
    let problem = &bank.problems[0];
    for i in 0..10 {
        let variant = drawn(problem, &format!("s{i}"));
        let [big, y, t, _, g] = variant.data[..] else { panic!("five data") };
        assert!(variant.values[3].is_none(), "it is not printed");
        let a = 2.0 * y / (t * t);
        let entry = |i: usize| variant.solved.get(problem.questions[i].label).expect("an answer");
        let expected = [big * a / (2.0 * (g - a)), big * a / 2.0];
        for (i, expected) in expected.into_iter().enumerate() {
            let e = entry(i);
            for road in [e.eom, e.energy] {
                let off = (road.expect("both roads") - expected).abs();
                assert!(off < 8e-16 * e.cond * expected, "{road:?} {expected}");
            }
            assert!(e.bound.is_some_and(|b| b < 1e-8 * expected), "enclosed: {e:?}");
        }
        // m = M a/(2 (g - a)) moves with M as 1, with y as q = g/(g - a), with t as 2 q, and with g as q.
        let q = g / (g - a);
        assert!((entry(0).cond - (1.0 + 4.0 * q)).abs() < 1e-3, "{} {q}", entry(0).cond);
        // Who takes the pulley for a hoop finds twice the mass from the same time.
        let wrong = variant.wrong.iter().find(|w| w.label == problem.questions[0].label);
        let off = wrong.map(|w| (w.value - 2.0 * expected[0]).abs() / expected[0]);
        assert!(off.is_some_and(|off| off < 1e-9), "{wrong:?}");
    }
}

/// A friction that is found to be nothing is nothing on both roads, and so is the coefficient that it needs: by hand
/// `P (1 - 2 r/R) = m g sin(theta)` for a disc of radius `R` pulled at a hub of radius `r`.
#[test]
fn what_is_found_may_leave_nothing() {
    let text = "
bank: b
title: B
problems:
  p:
    title: A disc
    data:
      m:     {name: mass, unit: kg, draw: 7 to 9 step 0.5}
      R:     {name: radius, unit: m, draw: 0.2 to 0.3 step 0.02}
      theta: {name: slope, unit: deg, draw: 15 to 20 step 1}
      P:     {name: pull, unit: N, unknown: 30 to 200 step 1}
      F:     {name: friction, unit: N, draw: always 0, measured: friction}
    scene:
      surfaces: {slope: {slope: theta}}
      bodies: {disc: {mass: m, shape: {disc: R}, radii: {rim: R, hub: 0.3*R}, moves: along slope}}
      ties:
        - rolls: {body: disc, on its: rim}
        - cord: {from: {body: disc, wound on: hub, leaves: top forward}, pulled with: P}
      start: at rest
      end: {travel: {of: disc, by: 1 m}}
    questions: {P: {value: P, unit: N, ask: the pull with which no friction acts}}
    statement: s
";
    let bank = read(text).expect("a bank");
    for i in 0..20 {
        let variant = drawn(&bank.problems[0], &format!("s{i}"));
        let [m, _, theta, .., g] = variant.data[..] else { panic!("the data") };
        let expected = m * g * theta.to_radians().sin() / 0.4;
        let key = slipstick::problem::make_key::key(&bank.problems[0], &variant);
        let slipstick::key::Answer::Number { value, .. } = key.parts[0].answer else { panic!("a number") };
        assert!((value - expected).abs() < 1e-13 * expected, "{value} {expected}");
    }
}

#[test]
fn what_is_wrong_with_an_inverse_question_is_told() {
    let cases = [
        (UNKNOWN, "draw: 2 to 3 step 0.1", "`m` is unknown, and nothing is measured"),
        ("draw: 1 to 3 step 0.1", TIMED, "this is measured, and nothing is unknown"),
        (UNKNOWN, "draw: 2 to 3 step 0.1, measured: stone.v", "`t1` has the dimension s, `stone.v` m s^-1"),
        (UNKNOWN, "draw: 2 to 3 step 0.1, measured: time", "`time` is no quantity"),
        (UNKNOWN, "draw: 2 to 3 step 0.1, measured: stone.direction", "only a number is measured"),
        ("unknown: 0 to 3 step 0.1", TIMED, "`m` cannot have all values of this range"),
        ("unknown: 0.2 to 20", TIMED, "has no step"),
        ("unknown: 1 to 3 step 0.1, draw: always 2", TIMED, "what is to be found is not drawn"),
    ];
    for (mass, time, wanted) in cases {
        let found = read(&stone(mass, time, MASS)).expect_err(wanted);
        let all: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(all.iter().any(|f| f.contains(wanted)), "{wanted}\n{}", all.join("\n"));
    }
}

#[test]
fn what_two_values_give_is_refused() {
    // The period is least where the pin is as far from G as the radius of gyration: nearer and farther pins share a period.
    let bank = "bank: b
title: B
problems:
  p:
    title: A pendulum
    data:
      T: {name: measured period, unit: s, draw: always 1.7, measured: period_small}
      h: {name: distance of the pin, unit: m, unknown: RANGE}
    scene:
      bodies: {body: {mass: 2 kg, radius of gyration: 0.3 m, pinned: {distance: h}, angle: from hanging}}
      start: {body: {angle: 10 deg}}
      end: {angle: {of: body, reaches: 0 deg}}
    questions: {distance: {value: h, unit: m, ask: h}}
    statement: s
";
    let drawn = |range: &str| {
        let bank = read(&bank.replace("RANGE", range)).expect("a bank");
        Maker::new(&bank.problems[0], 7, "set")
            .giving_up_after(1)
            .variant("s")
            .map(|v| v.solved.entries.len())
    };
    let two = drawn("0.05 to 2 step 0.05").expect_err("two distances");
    assert_eq!(two.unsolved, Some(slipstick::solve::outcome::Refusal::NotUnique(None)));
    let none = drawn("0.31 to 0.4 step 0.01").expect_err("no distance");
    assert_eq!(none.unsolved, Some(slipstick::solve::outcome::Refusal::NotFound));
    assert!(drawn("0.31 to 2 step 0.01").is_ok(), "one distance");
}

#[test]
fn what_is_found_does_not_hang_on_its_range() {
    // A block that starts down an incline stops after d = v^2 / (2 g (mu cos - sin)); an Atwood machine falls by L in t.
    let stopping = "bank: b
title: B
problems:
  p:
    title: A block
    data:
      d: {name: stopping distance, unit: m, draw: always 2.65, measured: distance}
      v: {name: speed, unit: m/s, draw: always 2}
      mu: {name: friction, unit: '1', unknown: RANGE step 0.01}
    scene:
      surfaces: {ramp: {slope: 16 deg}}
      bodies: {block: {mass: 3 kg, moves: along ramp, positive: down}}
      ties: [{slides: {body: block, mu_k: mu}}]
      start: {block: {speed: v}}
      end: {turning point: block}
    questions: {x: {value: mu, unit: '1', ask: mu}}
    statement: s
";
    let atwood = "bank: b
title: B
problems:
  p:
    title: Two weights
    data:
      t1: {name: time, unit: s, draw: always 1.5, measured: t}
      m: {name: mass, unit: kg, unknown: RANGE step 0.1}
    scene:
      bodies: {A: {mass: 5 kg, moves: vertically}, B: {mass: m, moves: vertically, positive: down}}
      ties: [cord: {from: {body: A, tied at: centre, leaves: up}, to: {body: B, tied at: centre, leaves: up}}]
      start: at rest
      end: {travel: {of: B, by: 1 m, heading: down}}
    questions: {x: {value: m, unit: kg, ask: m}}
    statement: s
";
    // A bar of 0.8 m set off from hanging, by a spin and by a blow at its end, turns after 70 degrees.
    let swing = "bank: b
title: B
problems:
  p:
    title: A bar
    data:
      phi1: {name: angle, unit: deg, draw: always 70, measured: phi}
      x: {name: what sets it off, unit: UNIT, unknown: RANGE step 0.1}
    scene:
      bodies: {bar: {mass: 2 kg, shape: {rod: 0.8 m}, moves: in the plane, angle: from hanging}}
      joints: {O: {pins: bar.A}}
      forces: FORCES
      start: {bar: {angle: 0 deg SPIN}}
      end: {turning point: bar}
    questions: {x: {value: x, unit: UNIT, ask: x}}
    statement: s
";
    let written =
        |unit, forces, spin| swing.replace("UNIT", unit).replace("FORCES", forces).replace("SPIN", spin);
    let spun = written("rad/s", "[]", ", spin: x");
    let struck = written("N*s", "[impulse: {on: bar.B, magnitude: x, direction: right}]", "");
    let spin = (3.0 * 9.81 / 0.8 * (1.0 - 70f64.to_radians().cos())).sqrt();
    let slope = 16f64.to_radians();
    let mu = (4.0 / (2.0 * 9.81 * 2.65) + slope.sin()) / slope.cos();
    let a = 2.0 / (1.5 * 1.5);
    let mass = 5.0 * (9.81 + a) / (9.81 - a);
    let cases = [
        (stopping, mu, ["0.29 to 0.55", "0.2868 to 0.5468", "0.3 to 0.9", "0.36 to 0.37"]),
        (atwood, mass, ["5.1 to 15.7", "5.5 to 6.5", "5.2 to 100", "5.2 to 6"]),
        // Of joined bodies the place where they turn was not enclosed, and every range was refused.
        (&spun, spin, ["1 to 6", "4 to 5", "0.5 to 8", "4.9 to 5"]),
        (&struck, spin * 2.0 * 0.8 / 3.0, ["0.5 to 6", "2 to 3", "1 to 4", "2.6 to 2.7"]),
    ];
    for (text, expected, ranges) in cases {
        for range in ranges {
            let bank = read(&text.replace("RANGE", range)).expect("a bank");
            let variant = drawn(&bank.problems[0], "s");
            let entry = variant.solved.get(bank.problems[0].questions[0].label).expect("an answer");
            assert!((entry.value() - expected).abs() < 1e-14 * expected, "{range}: {entry:?} {expected}");
            assert!(entry.cond < 100.0, "{range}: {entry:?}");
        }
    }
    // A range that begins where nothing is measured, for the weights move the other way: its root is found all the same.
    let wide = read(&atwood.replace("RANGE", "1.3 to 15.7")).expect("a bank");
    let scene = &wide.problems[0].cases[0].scene;
    let mut data = vec![1.5, 0.0];
    data.resize(wide.problems[0].data.len(), 9.81);
    let solved = slipstick::solve::agree::solve(scene, &data).expect("both roads find it");
    let entry = solved.get(wide.problems[0].questions[0].label).expect("an answer");
    assert!((entry.value() - mass).abs() < 1e-14 * mass, "{entry:?} {mass}");
}

/// What starts or holds a swinging body is found from its speed at a place, or from where it turns: the time that it takes, a spring that does nothing yet
/// and an angle of a quarter turn leave nothing of that open.
#[test]
fn a_spin_and_a_stiffness_are_found_from_a_swing() {
    let rod = |data: &str, rod: &str, scene: &str, unit: &str| {
        format!(
            "bank: b
title: B
problems:
  p:
    title: A rod
    data:
{data}
    scene:
      bodies: {{rod: {{mass: 8 kg, shape: {{rod: 1.2 m}}, {rod}}}}}
{scene}
    questions: {{q: {{value: x, unit: {unit}, ask: x}}}}
    statement: s
"
        )
    };
    let (m, length, moment) = (8.0, 1.2, 8.0 * 1.2 * 1.2 / 3.0);
    let quarter = std::f64::consts::FRAC_PI_2;
    // The spring hangs straight down to the tip, not stretched, while the rod lies level; 60 deg farther down it has all that the weight gave.
    let down = 60f64.to_radians();
    let tip = [length * down.cos(), -length * down.sin()];
    let stretch = (length - tip[0]).hypot(0.8 - tip[1]) - 0.8;
    let cases = [
        (
            rod(
                "      w1: {name: w1, unit: rad/s, draw: always 2, measured: omega}
      x: {name: x, unit: rad/s, unknown: 7.2 to 9 step 0.1}",
                "pinned: at its end, angle: from hanging",
                "      start: {rod: {angle: 0 deg, spin: x}}
      end: {angle: {of: rod, reaches: 180 deg}}",
                "rad/s",
            ),
            (4.0 + 6.0 * 9.81 / length).sqrt(),
        ),
        (
            rod(
                "      w1: {name: w1, unit: rad/s, draw: always 2, measured: omega}
      x: {name: x, unit: N*m/rad, unknown: 10 to 38 step 0.1}",
                "moves: in the plane, points: {A: 0 m}, angle: from upright",
                "      joints: {A: {pins: rod.A}}
      forces: [torsion: {on: rod.A, stiffness: x, relaxed at: 0 deg}]
      start: {rod: {angle: 0 deg, spin: 1 rad/s}}
      end: {angle: {of: rod, reaches: 90 deg}}",
                "N*m/rad",
            ),
            (m * 9.81 * length + moment * (1.0 - 4.0)) / quarter.powi(2),
        ),
        (
            rod(
                "      p: {name: p, unit: deg, draw: always 60, measured: phi}
      x: {name: x, unit: N/m, unknown: 50 to 900 step 1}",
                "pinned: at its end, angle: from upright",
                "      forces: [spring: {on: rod, at: 1.2 m, anchor: [1.2 m, 0.8 m], stiffness: x, natural length: 0.8 m}]
      start: {rod: {angle: 90 deg}}
      end: {turning point: rod}",
                "N/m",
            ),
            m * 9.81 * length * down.sin() / stretch.powi(2),
        ),
    ];
    for (text, exact) in cases {
        let bank = read(&text).expect("a bank");
        let variant = drawn(&bank.problems[0], "s");
        let entry = variant.solved.get(bank.problems[0].questions[0].label).expect("an answer");
        assert!((entry.value() - exact).abs() < 1e-13 * exact, "{entry:?} {exact}");
        assert!(entry.bound.is_some(), "{entry:?}");
    }
}

/// A ball is rolling when it comes to an incline: as if that were smooth it would keep its spin and lose `2 g d sin` of the square of
/// its speed, not 10/7 of `g d sin`. What would need the spin that it keeps, or a cord on its rim, is refused.
#[test]
fn a_ball_that_rolls_onto_ice_keeps_its_spin() {
    let text = "bank: b
title: B
problems:
  p:
    title: A ball
    data:
      v0: {name: speed at the foot, unit: m/s, draw: 6.0 to 9.0 step 0.1}
      d:  {name: way up the incline, unit: m, draw: 0.5 to 2.0 step 0.1}
    scene:
      surfaces: {incline: {slope: 30 deg}}
      bodies: {ball: {mass: 2 kg, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along incline}}
      ties: [rolls: {body: ball, on its: rim}]
      start: {ball: {speed: v0}}
      end: {travel: {of: ball, by: d}}
    questions:
      v:    {ask: the speed, unit: m/s}
      ice:  {quantity: v, if: smooth, unit: m/s, ask: the speed on ice}
      back: {quantity: a, if: smooth, unit: m/s^2, ask: the acceleration on ice}
      soon: {quantity: t, if: smooth, unit: s, ask: the time on ice}
    statement: s
";
    let bank = read(text).unwrap_or_else(|f| panic!("{f:#?}"));
    for i in 0..20 {
        let variant = drawn(&bank.problems[0], &format!("s{i}"));
        let (v0, d, g) = (variant.data[0], variant.data[1], 9.81);
        let told = |id: &str| {
            let label = slipstick::bank::asked::label(&bank.problems[0].cases[0].scene, id).expect("asked");
            let entry = variant.solved.get(label).expect("an answer");
            assert!(entry.energy.is_some(), "{id} on both roads");
            entry.value()
        };
        let v = (v0 * v0 - g * d).sqrt();
        for (found, expected) in
            [(told("ice"), v), (told("back"), -g / 2.0), (told("soon"), 2.0 * (v0 - v) / g)]
        {
            assert!((found - expected).abs() < 1e-13 * expected.abs().max(1.0), "{found} {expected}");
        }
    }
    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        read(&text.replace(from, to))
            .expect_err("a finding")
            .iter()
            .map(ToString::to_string)
            .collect::<String>()
    };
    let energy =
        refused("{quantity: v, if: smooth, unit: m/s,", "{quantity: kinetic_energy, if: smooth, unit: J,");
    assert!(energy.contains("spin that a body keeps"), "{energy}");
    let cord = "ties: [rolls: {body: ball, on its: rim}, cord: {from: {body: ball, wound on: rim, leaves: top forward}, pulled with: 3 N}]";
    let wound = refused("ties: [rolls: {body: ball, on its: rim}]", cord);
    assert!(wound.contains("as if it were smooth"), "{wound}");
}

/// An expression is measured: the force at the pin of a rod that swings down from level is `r` times its weight, `w^2 = 2 (r - 1) g/L - 3 g/L`; and
/// what a motion that follows tells: a block compresses a spring by `x` after it has slid `s` down an incline, where
/// `(s + x) m g (sin - mu cos) = ks x^2/2` (Schaum, problem 17.36: 0.33 m).
#[test]
fn an_expression_and_the_motion_that_follows_are_measured() {
    let rod = "bank: b
title: B
problems:
  p:
    title: A rod
    data:
      m: {name: m, unit: kg, draw: always 2}
      L: {name: L, unit: m, draw: always 1.2}
      r: {name: r, unit: '1', draw: always 4, measured: O.pin_y/(m*g)}
      x: {name: x, unit: rad/s, unknown: 1 to 12 step 0.1}
    scene:
      bodies: {rod: {mass: m, shape: {rod: L}, moves: in the plane, angle: from hanging}}
      joints: {O: {pins: rod.A}}
      start: {rod: {angle: 90 deg, spin: -x}}
      end: {angle: {of: rod, reaches: 0 deg}}
    questions: {q: {value: x, unit: rad/s, ask: x}}
    statement: s
";
    let block = "bank: b
title: B
problems:
  p:
    title: A block
    data:
      x1: {name: x1, unit: mm, draw: always 75, measured: next.displacement}
      x: {name: x, unit: mm, unknown: 50 to 2000 step 1}
    scene:
      surfaces: {incline: {slope: atan(0.57735026918962576)}}
      bodies: {block: {mass: 7 kg, moves: along incline, positive: down}}
      ties: [slides: {body: block, mu_k: 0.25}]
      start: at rest
      end: {travel: {of: block, by: x}}
      next:
        ties:
          - slides: {body: block, mu_k: 0.25}
          - cord: {name: spring, from: {body: block, tied at: centre, leaves: forward}, spring: {stiffness: 2800 N/m, stretch: 0 m, attached: rigidly}}
        end: {turning point: block}
    questions: {q: {value: x, unit: mm, ask: x}}
    statement: s
";
    let (s, c) = 30f64.to_radians().sin_cos();
    let slid = 1400.0 * 0.075 * 0.075 / (7.0 * 9.81 * (s - 0.25 * c)) - 0.075;
    for (text, exact) in [(rod, (3.0f64 * 9.81 / 1.2).sqrt()), (block, slid)] {
        let bank = read(text).expect("a bank");
        let variant = drawn(&bank.problems[0], "s");
        let entry = variant.solved.get(bank.problems[0].questions[0].label).expect("an answer");
        assert!((entry.value() - exact).abs() < 1e-13 * exact, "{entry:?} {exact}");
        assert!(entry.bound.is_some_and(|b| b < 1e-8), "enclosed: {entry:?}");
    }
}
