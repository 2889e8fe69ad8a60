//! Boundaries that data hit exactly: balance, equilibrium, turning points, a cord that just goes slack, blocks that stay.
//!
//! Earlier tests could not see these: random draws never balance, and the reference has each boundary only once.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test that cannot set itself up fails; exact values are exact"
)]
mod support;
use slipstick::bank::load;
use slipstick::scene::Quantity;
use slipstick::solve::agree::solve;
use slipstick::solve::outcome::Solved;

/// Solves a problem of the built-in banks with these data, in the order of the bank.
fn built_in(id: &str, data: &[f64]) -> Solved {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == id).unwrap();
    assert_eq!(problem.data.len(), data.len(), "{id}");
    solve(&problem.cases[0].scene, data).unwrap_or_else(|e| panic!("{id} {data:?}: {e:?}"))
}

/// Solves a scene without data, written as in a bank.
fn scene(text: &str) -> Solved {
    let bank = format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{m: {{name: mass, unit: kg, draw: always 5}}}}\n    scene:\n{text}\n    questions: {{direction: {{ask: where}}}}\n    statement: x\n"
    );
    let bank = load::scenes_only(&bank, "test").unwrap_or_else(|f| panic!("{f:#?}"));
    solve(&bank.problems[0].cases[0].scene, &[5.0, 9.81]).unwrap_or_else(|e| panic!("{e:?}\n{text}"))
}

fn value(solved: &Solved, quantity: Quantity) -> f64 {
    let entry = solved.entries.iter().find(|e| e.label.quantity == quantity);
    let entry = entry.unwrap_or_else(|| panic!("no {quantity:?}"));
    assert_eq!(entry.eom.map(f64::to_bits), entry.energy.map(f64::to_bits), "{quantity:?}");
    entry.value()
}

#[test]
fn exact_balance_stays() {
    // m R k theta mu_s M b m_B d g: 20 kg at 30 degrees against 10 kg.
    let s = built_in("block-pulls-wheel", &[20.0, 0.3, 0.2, 30.0, 0.6, 4.0, 0.15, 10.0, 1.0, 9.81]);
    assert_eq!(s.regime.word(), "balanced");
    assert!(s.entries.iter().filter(|e| e.label.quantity == Quantity::A).all(|e| e.value().abs() <= 0.0));
    // Every decimal pair of loads that balances on radii 2 : 1.
    for tenths in 1..60 {
        let m = f64::from(tenths) / 10.0;
        let s = built_in("two-loads-on-a-stepped-drum", &[m, 2.0 * m, 0.6, 0.3, 10.0, 0.2, 1.0, 9.81]);
        assert_eq!(s.regime.word(), "balanced", "{m}");
    }
}

#[test]
fn a_spring_released_at_equilibrium_rests_and_turns_where_it_turns() {
    // m R r k theta ks x0 D mu_s g; m g sin = 100 N, the cord on the rim: equilibrium at 0.5 m.
    let at =
        |x0: f64, d: f64| built_in("spring-released", &[20.0, 0.5, 0.5, 0.2, 30.0, 100.0, x0, d, 2.0, 10.0]);
    let rest = at(0.5, 0.1);
    assert_eq!(rest.regime.word(), "rest");
    assert!(value(&rest, Quantity::VMax) <= 0.0 && value(&rest, Quantity::XEq) == 0.5);
    for (x0, d, word) in [(0.25, 0.25, "down turning_point"), (0.75, 0.25, "up turning_point")] {
        let s = at(x0, d);
        assert_eq!(s.regime.word(), word);
        assert!(value(&s, Quantity::V) <= 0.0);
        assert!((value(&s, Quantity::DTurn) - d).abs() <= 0.0);
        let next = at(x0, d + 1e-15);
        assert_eq!(next.regime.word(), word.replace("turning_point", "unreachable"));
        let before = at(x0, d - 1e-15);
        assert_eq!(before.regime.word(), word.replace("turning_point", "ok"));
    }
}

#[test]
fn beyond_the_squares_of_doubles_answers_stay_right() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "spring-released").unwrap();
    // v_max = (s0 - s_eq) sqrt(ks gamma^2/(m (1 + k^2/c^2))): with such a stretch its square leaves the doubles.
    let data = |x0| [20.0, 0.5, 0.2, 0.35, 15.0, 800.0, x0, 0.3, 0.9, 9.81];
    let of = |x0| solve(&problem.cases[0].scene, &data(x0)).unwrap();
    let (large, small) = (of(1e160), of(1e120));
    let ratio = value(&large, Quantity::VMax) / value(&small, Quantity::VMax) / 1e40;
    assert!((ratio - 1.0).abs() < 1e-14, "{ratio}");
    // The kinetic energy there is 1e320 J: held back, not infinite.
    assert!(large.entries.iter().all(|e| !e.value().is_nan()));
}

#[test]
fn on_a_level_the_cord_goes_slack_and_the_speed_stays() {
    let s = built_in("spring-released", &[18.0, 0.48, 0.12, 0.16, 0.0, 430.0, 0.49, 0.9, 0.9, 9.81]);
    assert_eq!(s.regime.word(), "up ok");
    assert!(value(&s, Quantity::A) <= 0.0 && value(&s, Quantity::Tension) <= 0.0);
    assert_eq!(value(&s, Quantity::V).to_bits(), value(&s, Quantity::VMax).to_bits());
    assert!(value(&s, Quantity::DTurn).is_infinite());
}

#[test]
fn a_block_that_stays_is_held_by_the_friction_that_it_needs() {
    let block = |ties: &str| {
        scene(&format!(
            "      surfaces: {{incline: {{slope: 30 deg}}}}\n      bodies: {{block: {{mass: m, moves: along incline}}}}\n      ties:\n{ties}      end: {{travel: {{of: block, by: 1 m}}}}"
        ))
    };
    let need = 5.0 * 9.81 / 2.0;
    for mu in ["mu_s: 0.9, mu_k: 0.3", "mu_k: 0.9"] {
        let s = block(&format!("        - slides: {{body: block, {mu}}}\n"));
        assert_eq!(s.regime.word(), "balanced");
        assert!((value(&s, Quantity::Friction) - need).abs() < 1e-14, "{mu}");
    }
    // Pulled up with 20 N it needs the rest, pulled with the whole weight nothing.
    for (pull, rest) in [(20.0, need - 20.0), (24.525, 0.0)] {
        let s = block(&format!(
            "        - slides: {{body: block, mu_s: 0.9, mu_k: 0.3}}\n        - cord: {{from: {{body: block, tied at: centre, leaves: up}}, pulled with: {pull} N}}\n"
        ));
        assert!((value(&s, Quantity::Friction) - rest).abs() < 1e-13, "{pull}");
    }
    // Less grip than the slope needs: it goes, against kinetic friction.
    let s = block("        - slides: {body: block, mu_s: 0.3, mu_k: 0.2}\n");
    assert_eq!(s.regime.word(), "moves_down");
}

#[test]
fn of_two_contacts_each_is_judged_with_the_other_as_declared() {
    let towed = |b: &str| {
        scene(&format!(
            "      surfaces: {{floor: level}}\n      bodies:\n        A: {{mass: 10 kg, shape: {{hoop: 0.3 m}}, radii: {{rim: 0.3 m}}, moves: along floor}}\n        B: {{mass: m, shape: {{disc: 0.3 m}}, radii: {{rim: 0.3 m}}, moves: along floor}}\n      ties:\n        - slips: {{body: A, on its: rim, mu_s: 0.02, mu_k: 0.01}}\n        - {b}\n        - cord: {{from: {{body: A, tied at: centre, leaves: forward}}, to: {{body: B, tied at: centre, leaves: back}}}}\n      forces: [couple: {{on: B, moment: 10 N m, sense: forward}}]\n      end: {{travel: {{of: B, by: 1 m}}}}"
        ))
    };
    let rolls = towed("rolls: {body: B, on its: rim, mu_s: 0.6}");
    let slips = towed("slips: {body: B, on its: rim, mu_s: 0.6, mu_k: 0.3}");
    assert!(rolls.all_hold(), "{:?}", rolls.checks);
    assert!(!slips.all_hold(), "B need not slip where A does: {:?}", slips.checks);
}

#[test]
fn a_spring_whose_end_does_not_move_only_presses() {
    // The cord leaves the bottom of the rim on which the wheel rolls.
    let s = scene(
        "      surfaces: {incline: {slope: 30 deg}}\n      bodies: {wheel: {mass: m, shape: {disc: 0.3 m}, radii: {rim: 0.3 m}, moves: along incline, positive: down}}\n      ties:\n        - rolls: {body: wheel, on its: rim, mu_s: 9}\n        - cord: {from: {body: wheel, wound on: rim, leaves: bottom back}, spring: {stiffness: 100 N/m, stretch: 0.2 m, attached: by the cord}}\n      end: {travel: {of: wheel, by: 1 m}}",
    );
    assert!((value(&s, Quantity::A) - 9.81 / 3.0).abs() < 1e-14);
    assert!(value(&s, Quantity::CordTravel) <= 0.0);
    assert!((value(&s, Quantity::Tension) - 20.0).abs() < 1e-14);
}
