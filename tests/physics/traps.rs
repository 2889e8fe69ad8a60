//! The traps in which obvious formulas lose their digits or fall, each once by name. The sweeps of `extremes.rs` go over
//! the same ground at random.
use crate::support;
use slipstick::bank::{Bank, load};
use slipstick::num::trig::sin_cos_degrees;
use slipstick::scene::Quantity;
use slipstick::solve::agree::solve;
use slipstick::solve::outcome::{Refusal, Solved};
use std::sync::LazyLock;

static BANKS: LazyLock<Vec<Bank>> = LazyLock::new(support::banks);

fn built_in(id: &str, data: &[f64]) -> Result<Solved, Refusal> {
    let problem = BANKS.iter().flat_map(|b| &b.problems).find(|p| p.id == id).unwrap();
    assert_eq!(problem.data.len(), data.len(), "{id}");
    solve(&problem.cases[0].scene, data)
}

/// Solves a scene with constants of its own, written as in a bank; g = 9.81.
fn scene(text: &str) -> Solved {
    let bank = format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{m: {{name: mass, unit: kg, draw: always 5}}}}\n    scene:\n{text}\n    questions: {{direction: {{ask: where}}}}\n    statement: x\n"
    );
    let bank = load::scenes_only(&bank, "test").unwrap_or_else(|f| panic!("{f:#?}"));
    solve(&bank.problems[0].cases[0].scene, &[5.0, 9.81]).unwrap_or_else(|e| panic!("{e:?}\n{text}"))
}

/// Is a quantity what both roads say, to a few units in the last place of the formula in doubles?
fn holds(solved: &Solved, name: &str, want: f64) {
    let quantity = Quantity::from_name(name).unwrap();
    let entry =
        solved.entries.iter().find(|e| e.label.quantity == quantity).unwrap_or_else(|| panic!("no {name}"));
    for got in [entry.eom.unwrap(), entry.energy.unwrap()] {
        assert!((got - want).abs() <= 4.0 * f64::EPSILON * want.abs(), "{name}: {got:e} is not {want:e}");
    }
}

// m R r k theta ks x0 D mu_s g: on a level, hub and rim alike: gamma = 2, w^2 = 4 ks/(m (1 + k^2/R^2)).
const SPRING: [f64; 10] = [8.0, 0.5, 0.5, 0.5, 0.0, 16.0, 1.0, 0.25, 2.0, 9.81];

#[test]
fn x0_squared_less_x_squared() {
    // After 2^-40 m of 1: ks gamma^2/2 (s0^2 - s^2) would keep 13 of 53 bits.
    let d = 1.0 / (1u64 << 40) as f64;
    let s = built_in("spring-released", &SPRING.map(|x| if x == 0.25 { d } else { x })).unwrap();
    holds(&s, "v", (4.0 * d * (1.0 - d)).sqrt());
}

#[test]
fn spring_against_weight_near_equilibrium() {
    // Equilibrium at 0.5 m exactly (m g sin = 100 N on gamma = 2, ks = 100): the drive is ks (x0 - x_eq).
    for step in [1e-3, 1e-9, 1e-13] {
        let x0 = 0.5 + step;
        let s =
            built_in("spring-released", &[20.0, 0.5, 0.5, 0.5, 30.0, 100.0, x0, 1e-16, 2.0, 10.0]).unwrap();
        // s0 - s_eq = (x0 - x_eq)/2, the difference exact in doubles.
        holds(&s, "D_at_v_max", (x0 - 0.5) / 2.0);
    }
}

#[test]
fn tension_of_a_load_that_nearly_falls_freely() {
    // A yo-yo with k = 1e-9 r: T = m (g - a) would be all rounding; T = m g k^2/(k^2 + r^2).
    for ratio in [1e-3, 1e-6, 1e-9, 1e-14] {
        let s = scene(&format!(
            "      bodies: {{yoyo: {{mass: m, radius of gyration: {ratio:?} m, radii: {{hub: 1 m}}, moves: vertically, positive: down}}}}\n      ties: [{{cord: {{from: {{body: yoyo, wound on: hub, leaves: up}}, held: fast}}}}]\n      end: {{travel: {{of: yoyo, by: 1 m}}}}"
        ));
        holds(&s, "tension", 5.0 * 9.81 * ratio * ratio / (ratio * ratio + 1.0));
        // And a load on a cord round a drum that has hardly any inertia: T = m g I/(I + m r^2).
        let inertia = ratio * ratio;
        let s = scene(&format!(
            "      bodies: {{load: {{mass: m, moves: vertically, positive: down}}, drum: {{moment of inertia: {inertia:?} kg m^2, radii: {{rim: 1 m}}, moves: about a fixed axle}}}}\n      ties: [{{cord: {{from: {{body: load, tied at: centre, leaves: up}}, to: {{body: drum, wound on: rim, leaves: front down}}}}}}]\n      end: {{travel: {{of: load, by: 1 m}}}}"
        ));
        holds(&s, "tension", 5.0 * 9.81 * inertia / (inertia + 5.0));
    }
}

#[test]
fn friction_as_a_small_difference_of_large_forces() {
    // A hoop-less wheel rolls down: F = m g sin k^2/(k^2 + c^2), not m a + m g sin.
    for ratio in [1e-4, 1e-8, 1e-13] {
        let s = scene(&format!(
            "      surfaces: {{incline: {{slope: 30 deg}}}}\n      bodies: {{wheel: {{mass: m, radius of gyration: {ratio:?} m, radii: {{rim: 1 m}}, moves: along incline}}}}\n      ties: [{{rolls: {{body: wheel, on its: rim}}}}]\n      end: {{travel: {{of: wheel, by: 1 m}}}}"
        ));
        holds(&s, "friction", 5.0 * 9.81 * 0.5 * ratio * ratio / (ratio * ratio + 1.0));
    }
}

#[test]
fn heat_is_no_difference_of_kinetic_energies() {
    // A ball thrown with hardly any slip: T0 - T1 is 1e-18 of T0; the heat is m v_s^2/2 (2/5)/(1 + 2/5).
    let problem = BANKS.iter().flat_map(|b| &b.problems).find(|p| p.id == "thrown-ball").unwrap();
    let at = |symbol: &str| problem.data.iter().position(|d| d.symbol == symbol);
    let mut data = vec![0.0; problem.data.len()];
    for (symbol, value) in
        [("m", 4.0), ("R", 0.125), ("k", 0.125), ("mu_s", 0.5), ("mu_k", 0.25), ("g", 9.81), ("v0", 8.0)]
    {
        if let Some(i) = at(symbol) {
            data[i] = value;
        }
    }
    let spin = problem
        .cases
        .iter()
        .position(|c| c.scene.start.len() == 2 && at("w0").is_some_and(|i| c.draws[i].is_some()));
    let (Some(case), Some(i)) = (spin, at("w0")) else { panic!("no case with a spin") };
    data[i] = 64.0 * (1.0 - 1e-9);
    let value = |name: &str| {
        let s = solve(&problem.cases[case].scene, &data).unwrap_or_else(|e| panic!("{e:?}"));
        s.entries.iter().find(|e| e.label.quantity == Quantity::from_name(name).unwrap()).map(|e| e.value())
    };
    let slip = value("slip_speed").unwrap();
    let heat = value("heat").unwrap();
    let want = 4.0 * slip * slip / 7.0;
    assert!((heat / want - 1.0).abs() < 1e-14, "{heat:e} is not {want:e}");
}

#[test]
fn angles_are_reduced_in_degrees() {
    assert_eq!(sin_cos_degrees(90.0).1.hi, 0.0);
    assert_eq!(sin_cos_degrees(60.0).1.hi, 0.5);
    assert_eq!(sin_cos_degrees(30.0).0.hi, 0.5);
    assert_eq!(sin_cos_degrees(45.0).0.hi, sin_cos_degrees(45.0).1.hi);
    // cos 89.99999999 degrees is 1.7e-10: in radians nine of its digits are gone.
    let (s, c) = (sin_cos_degrees(90.0 - 89.999_999_99).0.hi, sin_cos_degrees(89.999_999_99).1.hi);
    assert_eq!(s, c);
}

#[test]
fn a_square_that_leaves_the_doubles() {
    // alpha = [P (c + p) - m g sin c]/(m (k^2 + c^2)); omega^2 = 2 alpha d/c: 1e-240 and 1e-120 for k = 1e120 m.
    let with = |k| built_in("pulled-rolling", &[20.0, 0.5, 0.25, k, 30.0, 200.0, 2.0, 1e6, 9.81]);
    let drive: f64 = 200.0 * 0.75 - 20.0 * 9.81 * 0.5 * 0.25;
    holds(&with(1e120).unwrap(), "omega", (2.0 * drive / 20.0 * 2.0 / 0.25).sqrt() / 1e120);
    assert!(matches!(with(1e160), Err(Refusal::Inadmissible(_))), "data end at 1e150");
}

#[test]
fn a_radicand_that_rounding_makes_negative_is_zero() {
    let at = |d: f64| built_in("spring-released", &SPRING.map(|x| if x == 0.25 { d } else { x })).unwrap();
    // On a level the cord goes slack at 1/2 m with v_max: nothing turns. Downhill: turning point 2 |s0 - s_eq|.
    assert!(at(0.5).entries.iter().all(|e| !e.value().is_nan()));
    for i in 1..200 {
        let theta = f64::from(i) * 0.2;
        let mut data = [20.0, 0.5, 0.3, 0.2, theta, 100.0, 0.0, 0.0, 2.0, 9.81];
        let turn = built_in("spring-released", &data).unwrap();
        let d = turn
            .entries
            .iter()
            .find(|e| e.label.quantity == Quantity::from_name("D_turn").unwrap())
            .unwrap()
            .value();
        for d in [d.next_down(), d, d.next_up()] {
            data[7] = d;
            let s = built_in("spring-released", &data).unwrap();
            assert!(s.entries.iter().all(|e| !e.value().is_nan()), "{data:?}");
            if let Some(v) = s.entries.iter().find(|e| e.label.quantity == Quantity::from_name("v").unwrap())
            {
                assert!(v.value() >= 0.0 && v.value() < 1e-6, "{v:?}");
            }
        }
    }
}

#[test]
fn nan_passes_no_test_of_the_data() {
    let good = [20.0, 0.5, 0.25, 0.3, 30.0, 200.0, 2.0, 0.9, 9.81];
    for i in 0..good.len() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut data = good;
            data[i] = bad;
            let refused = built_in("pulled-rolling", &data);
            assert!(matches!(refused, Err(Refusal::Inadmissible(_))), "{i} {bad}: {refused:?}");
        }
    }
}
