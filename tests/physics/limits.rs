//! Boundaries that data hit exactly: balance, equilibrium, turning points, a cord that just goes slack, blocks that stay.
//!
//! Earlier tests could not see these: random draws never balance, and the reference has each boundary only once.
use crate::support;
use slipstick::bank::load;
use slipstick::scene::admissible::Rule;
use slipstick::scene::{Label, Owner, Quantity};
use slipstick::solve::agree::solve;
use slipstick::solve::outcome::{Refusal, Solved};

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
fn to_the_ends_of_the_range_answers_stay_right() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "spring-released").unwrap();
    // v_max = (s0 - s_eq) sqrt(ks gamma^2/(m (1 + k^2/c^2))): with such a stretch its square is near the end of the doubles.
    let data = |x0| [20.0, 0.5, 0.2, 0.35, 15.0, 800.0, x0, 0.3, 0.9, 9.81];
    let of = |x0| solve(&problem.cases[0].scene, &data(x0)).unwrap();
    let (large, small) = (of(1e140), of(1e120));
    let ratio = value(&large, Quantity::VMax) / value(&small, Quantity::VMax) / 1e20;
    assert!((ratio - 1.0).abs() < 1e-14, "{ratio}");
    assert!(large.entries.iter().all(|e| !e.value().is_nan()));
    // Beyond 1e150 a datum is refused by name.
    let Err(Refusal::Inadmissible(faults)) = solve(&problem.cases[0].scene, &data(1e160)) else {
        panic!("1e160 m are no stretch")
    };
    assert_eq!(faults.iter().map(|f| (f.rule, f.value)).collect::<Vec<_>>(), [(Rule::Range, 1e160)]);
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

/// A ball (or what `body` says) thrown along `surface`, with `rest` of the scene.
fn throw(surface: &str, line: &str, mu: (f64, f64), start: (f64, f64), end: &str) -> Solved {
    scene(&format!(
        "      surfaces: {{lane: {surface}}}\n      bodies: {{ball: {{mass: m, shape: {{sphere: 0.125 m}}, moves: along lane, positive: {line}}}}}\n      ties:\n        - slips: {{body: ball, on its: rim, mu_s: {}, mu_k: {}}}\n      start: {{ball: {{speed: {} m/s, spin: {} rad/s}}}}\n      end: {end}",
        mu.0, mu.1, start.0, start.1
    ))
}

const TO_ROLLING: &str = "{rolling: ball}";

fn near(solved: &Solved, quantity: Quantity, want: f64) {
    let entry = solved.entries.iter().find(|e| e.label.quantity == quantity).unwrap();
    for got in [entry.eom.unwrap(), entry.energy.unwrap()] {
        assert!((got - want).abs() <= 4e-16 * want.abs(), "{quantity:?}: {got:e} is not {want:e}");
    }
}

/// Five sevenths of the speed are left to a ball, two sevenths of the energy become heat, however rough the level lane.
#[test]
fn on_a_level_friction_decides_when_it_rolls_but_not_how_fast() {
    for mu in [0.001, 0.05, 0.2, 0.9, 3.0] {
        let s = throw("level", "forward", (mu, mu), (7.0, 0.0), TO_ROLLING);
        assert_eq!(s.regime.word(), "rolls_after");
        near(&s, Quantity::V, 5.0);
        near(&s, Quantity::Omega, 40.0);
        near(&s, Quantity::Heat, 35.0);
        near(&s, Quantity::KineticEnergy, 87.5);
        near(&s, Quantity::T, 2.0 / (mu * 9.81));
        near(&s, Quantity::ARolling, 0.0);
        near(&s, Quantity::MuRequired, 0.0);
    }
    // Backspin of 5/2 of the speed stops it for good.
    let s = throw("level", "forward", (0.3, 0.2), (2.0, -40.0), TO_ROLLING);
    near(&s, Quantity::V, 0.0);
    near(&s, Quantity::Omega, 0.0);
    assert!(s.words.iter().any(|(l, w)| l.quantity == Quantity::Direction && w.as_str() == "stays"));
}

#[test]
fn a_throw_seen_from_the_other_side_is_the_same_throw() {
    let end = "{time: {of: ball, is: 0.9 s}}";
    for (surface, lines) in [("level", ["forward", "back"]), ("{slope: 9 deg}", ["up", "down"])] {
        for end in [TO_ROLLING, end, "{time: {of: ball, is: 6 s}}"] {
            let [one, two] = [(3.0, -17.0, lines[0]), (-3.0, 17.0, lines[1])]
                .map(|(v, w, line)| throw(surface, line, (0.3, 0.25), (v, w), end));
            assert_eq!(one.regime, two.regime);
            assert_eq!(one.words, two.words);
            for (a, b) in one.entries.iter().zip(&two.entries) {
                let turned = [
                    Quantity::A,
                    Quantity::Alpha,
                    Quantity::Displacement,
                    Quantity::ARolling,
                    Quantity::Impulse,
                ]
                .contains(&a.label.quantity);
                let sign = if turned { -1.0 } else { 1.0 };
                assert_eq!((a.eom, a.energy), (b.eom.map(|x| sign * x), b.energy.map(|x| sign * x)), "{a:?}");
            }
        }
    }
}

#[test]
fn what_rolls_already_rolls_at_once() {
    let s = throw("level", "forward", (0.3, 0.2), (5.0, 40.0), TO_ROLLING);
    assert_eq!(s.regime.word(), "rolls_at_start");
    for q in [Quantity::T, Quantity::Heat, Quantity::SlipDistance, Quantity::SlipSpeed, Quantity::Friction] {
        near(&s, q, 0.0);
    }
    assert!(!s.all_hold(), "a question about slip needs slip");
    // A little more slip than the rounding of the data ends after its own time.
    let s = throw("level", "forward", (0.3, 0.2), (5.0, 40.000_000_000_000_1), TO_ROLLING);
    assert_eq!(s.regime.word(), "rolls_after");
    assert!(value(&s, Quantity::T) > 0.0 && value(&s, Quantity::T) < 1e-14);
    // From there on it rolls as a wheel on an incline does: 5/7 of g sin.
    let s = throw("{slope: 30 deg}", "down", (0.3, 0.2), (5.0, 40.0), "{time: {of: ball, is: 2 s}}");
    near(&s, Quantity::A, 9.81 * 5.0 / 14.0);
    near(&s, Quantity::V, 5.0 + 9.81 * 5.0 / 7.0);
}

#[test]
fn too_little_friction_never_makes_it_roll_or_cannot_hold_it() {
    // Down the slope friction would have to drive the turn as fast as gravity the centre: 2/7 tan.
    let s = throw("{slope: 45 deg}", "down", (0.25, 0.25), (8.0, 0.0), TO_ROLLING);
    assert_eq!(s.regime.word(), "never");
    assert!(!s.all_hold());
    let s = throw("{slope: 45 deg}", "down", (0.25, 0.25), (8.0, 0.0), "{time: {of: ball, is: 2 s}}");
    assert_eq!(s.regime.word(), "never");
    assert!(s.all_hold(), "at a time it is somewhere: {:?}", s.checks);
    // Up the slope gravity ends the slip, but nothing holds the contact then.
    let s = throw("{slope: 45 deg}", "up", (0.25, 0.2), (8.0, 0.0), TO_ROLLING);
    assert_eq!(s.regime.word(), "slips_through");
    assert!(!s.all_hold());
    for (time, reached) in [(0.1, true), (5.0, false)] {
        let end = format!("{{time: {{of: ball, is: {time} s}}}}");
        let s = throw("{slope: 45 deg}", "up", (0.25, 0.2), (8.0, 0.0), &end);
        assert_eq!((s.regime.word().as_str(), s.all_hold()), ("slips_through", reached), "{time}");
        assert_eq!(s.entries.iter().any(|e| e.label.quantity == Quantity::V), reached);
    }
    // At rest at the contact without hold: it slips from the start, against the friction that it would need.
    let end = "{time: {of: ball, is: 2 s}}";
    let s = throw("{slope: 45 deg}", "down", (0.25, 0.2), (5.0, 40.0), end);
    assert_eq!(s.regime.word(), "slips_through");
    near(&s, Quantity::Friction, 0.2 * 5.0 * 9.81 * std::f64::consts::FRAC_1_SQRT_2);
    // Without friction nothing changes, without end.
    let s = throw("level", "forward", (0.0, 0.0), (8.0, 3.0), end);
    assert_eq!(s.regime.word(), "never");
    near(&s, Quantity::V, 8.0);
    near(&s, Quantity::Displacement, 16.0);
}

#[test]
fn speeds_pass_the_start_of_rolling_without_a_jump() {
    let at = |end: &str| throw("{slope: 6 deg}", "up", (0.3, 0.2), (4.0, -20.0), end);
    let event = at(TO_ROLLING);
    let time = value(&event, Quantity::T);
    for (factor, rolls) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
        let s = at(&format!("{{time: {{of: ball, is: {} s}}}}", time * factor));
        for q in
            [Quantity::V, Quantity::Omega, Quantity::Displacement, Quantity::SlipDistance, Quantity::Heat]
        {
            let (a, b) = (value(&s, q), value(&event, q));
            assert!((a - b).abs() < 1e-7 * b.abs(), "{q:?}: {a} {b}");
        }
        let rolling = (value(&s, Quantity::A) - value(&event, Quantity::ARolling)).abs() < 1e-12;
        assert_eq!(rolling, rolls, "the acceleration does jump");
    }
}

/// Throws of any size: both roads agree, and nothing published is NaN. Earlier tests could not see these: homework has no
/// ball of 1e30 kg, no slip of 1e-12 of the speed and no slope within 1e-12 of where friction just ends the slip.
#[test]
fn throws_of_any_size_have_one_answer() {
    let bank = "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n".to_owned()
        + &[
            ("m", "kg"),
            ("R", "m"),
            ("k", "m"),
            ("theta", "deg"),
            ("v0", "m/s"),
            ("w0", "rad/s"),
            ("mu_s", "1"),
            ("mu_k", "1"),
            ("t1", "s"),
        ]
        .map(|(s, u)| format!("      {s}: {{name: {s}, unit: \"{u}\", draw: always 1}}\n"))
        .concat()
        + "    scene:\n      surfaces: {lane: {slope: theta}}\n      bodies: {ball: {mass: m, radius of gyration: k, radii: {rim: R}, moves: along lane}}\n      ties: [slips: {body: ball, on its: rim, mu_s: mu_s, mu_k: mu_k}]\n      start: {ball: {speed: v0, spin: w0}}\n      end: {time: {of: ball, is: t1}}\n    questions: {v: {ask: v, unit: m/s}}\n    statement: x\n";
    let bank = load::scenes_only(&bank, "test").unwrap_or_else(|f| panic!("{f:#?}"));
    let timed = bank.problems[0].cases[0].scene.clone();
    let mut rolling = timed.clone();
    rolling.end = slipstick::scene::End::Rolling(timed.ending_coordinate());
    // A plain generator: the cases are the same on every machine.
    let mut state = 1u64;
    let mut unit = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(u32::MAX)
    };
    let mut words = std::collections::BTreeMap::<String, u32>::new();
    for i in 0..5_000 {
        let mut power = |low: f64, high: f64| libm::exp10(low + (high - low) * unit());
        // Some beyond the squares of doubles.
        let far = if i % 10 == 9 { 4.0 } else { 1.0 };
        let (m, radius) = (power(-20.0 * far, 20.0 * far), power(-12.0 * far, 12.0 * far));
        let k = radius * power(-6.0, 6.0);
        let v0 = power(-12.0 * far, 12.0 * far);
        let near = 1.0 + power(-15.0, 0.0);
        let w0 = if i % 2 == 0 { v0 / radius * near } else { v0 / radius * power(-12.0, 12.0) };
        let mu_k = power(-9.0, 2.0);
        let slope = match i % 5 {
            0 => 0.0,
            // Where kinetic friction just balances what keeps the slip up.
            1 => libm::atan(mu_k * (1.0 + (radius / k) * (radius / k)) * (1.0 + power(-15.0, -1.0)))
                .to_degrees(),
            2 => 90.0 - power(-12.0, 1.0),
            _ => 90.0 * unit(),
        };
        let (s, r) = (if i % 3 == 0 { -1.0 } else { 1.0 }, if i % 7 < 3 { -1.0 } else { 1.0 });
        let data =
            [m, radius, k, slope, s * v0, r * w0, mu_k * (1.0 + (i % 4) as f64), mu_k, v0 / 9.81, 9.81];
        for scene in [&timed, &rolling] {
            let solved = solve(scene, &data).unwrap_or_else(|e| panic!("{data:?}: {e:?}"));
            assert!(solved.entries.iter().all(|e| !e.value().is_nan()), "{data:?}");
            *words.entry(solved.regime.word()).or_default() += 1;
        }
    }
    assert!(words.len() == 3 && words.values().all(|n| *n > 250), "{words:?}");
}

/// Balanced, at the limit, at rest, rolling in the *decimals*, which the doubles next to them miss by a rounding. Earlier
/// tests had only data that doubles hold exactly.
#[test]
fn a_boundary_in_the_printed_decimals_is_a_boundary() {
    // 65.4 N . 0.3 m = 40 kg . 9.81 m/s^2 . 1/2 . 0.1 m
    let pulled = |p: f64| built_in("pulled-rolling", &[40.0, 0.2, 0.1, 0.15, 30.0, p, 3.0, 0.9, 9.81]);
    for (p, word) in [(65.4, "balanced"), (65.39, "moves_down"), (65.41, "moves_up")] {
        assert_eq!(pulled(p).regime.word(), word, "{p}");
    }
    assert!(!pulled(65.4).all_hold());
    // k = 0: friction is P p/c = mu_s m g.
    let s = built_in("pulled-rolling", &[3.0, 0.2, 0.1, 0.0, 0.0, 4.4145, 1.0, 0.3, 9.81]);
    assert_eq!(s.regime.word(), "moves_up");
    // x0 = m g sin/(ks gamma), with r = R and with r = R/2.
    for (r, ks) in [(0.3, 98.1), (0.15, 130.8)] {
        let s = built_in("spring-released", &[4.0, 0.3, r, 0.1, 30.0, ks, 0.1, 0.01, 2.0, 9.81]);
        assert_eq!(s.regime.word(), "rest", "{r}");
    }
    for (radius, v, w) in [(0.1, 3.0, 30.0), (0.3, 0.9, 3.0), (0.11, 3.3, 30.0), (0.7, 2.1, 3.0)] {
        let s = scene(&format!(
            "      surfaces: {{incline: {{slope: 5 deg}}}}\n      bodies: {{ball: {{mass: m, radius of gyration: 0.07 m, radii: {{rim: {radius:?} m}}, moves: along incline}}}}\n      ties: [{{slips: {{body: ball, on its: rim, mu_s: 0.5, mu_k: 0.3}}}}]\n      start: {{ball: {{speed: {v:?} m/s, spin: {w:?} rad/s}}}}\n      end: {{rolling: ball}}"
        ));
        assert_eq!(s.regime.word(), "rolls_at_start", "{radius}");
        assert!(value(&s, Quantity::A) < 0.0);
    }
    // On the level nothing pushes it then.
    for (radius, v, w) in [(0.3, 2.1, 7.0), (0.1, 0.3, 3.0), (0.7, 2.1, 3.0), (0.11, 3.3, 30.0)] {
        let s = scene(&format!(
            "      surfaces: {{lane: level}}\n      bodies: {{ball: {{mass: m, shape: {{sphere: {radius:?} m}}, moves: along lane}}}}\n      ties: [{{slips: {{body: ball, on its: rim, mu_s: 0.3, mu_k: 0.2}}}}]\n      start: {{ball: {{speed: {v:?} m/s, spin: {w:?} rad/s}}}}\n      end: {{time: {{of: ball, is: 1 s}}}}"
        ));
        near(&s, Quantity::Impulse, 0.0);
        near(&s, Quantity::V, v);
    }
}

/// A rigid spring: from rest to the turning point takes half a period, however far that is; a soft spring on a cord that never
/// goes slack oscillates alike.
#[test]
fn half_a_period_leads_to_the_turning_point() {
    for (slope, k, stiffness, stretch) in
        [(0, 0.2, 300, 0.4), (25, 0.31, 900, 0.02), (40, 0.05, 150, 1.3), (12, 0.25, 60, 0.0)]
    {
        let text = |attached: &str, end: &str| {
            format!(
                "
      surfaces: {{incline: {{slope: {slope} deg}}}}
      bodies: {{wheel: {{mass: m, radius of gyration: {k} m, radii: {{rim: 0.4 m, hub: 0.15 m}}, moves: along incline, positive: up}}}}
      ties:
        - rolls: {{body: wheel, on its: rim}}
        - cord: {{from: {{body: wheel, wound on: hub, leaves: top forward}}, spring: {{stiffness: {stiffness} N/m, stretch: {stretch} m, attached: {attached}}}}}
      start: at rest
      end: {end}"
            )
        };
        let turned = scene(&text("rigidly", "{turning point: wheel}"));
        let period = value(&turned, Quantity::PeriodSmall);
        let half = value(&turned, Quantity::T);
        assert!((2.0 * half - period).abs() <= 1e-12 * period, "{slope}: {half}, {period}");
        let turns = 2.0 * std::f64::consts::PI;
        assert!((value(&turned, Quantity::OmegaSmall) * period - turns).abs() <= 1e-12);
        // Without equilibrium under tension there is a kink, and no small oscillation.
        let loose = scene(&text("by the cord", "{time: {of: wheel, is: 0.01 s}}"));
        let told = loose.entries.iter().find(|e| e.label.quantity == Quantity::PeriodSmall);
        assert_eq!(told.is_some(), slope > 0);
        if let Some(told) = told {
            assert!((told.value() - period).abs() <= 1e-12 * period);
        }
    }
}

/// A hoop is pulled and draws a disc behind it by a cord between their centres: with a growing pull both roll, then the hoop slips
/// alone, for it needs twice the friction, then both slip. Of the ways in which they may touch the one that happens is found.
#[test]
fn of_two_contacts_that_touch_one_may_slip_alone() {
    let text = |pull: f64| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{}}\n    scene:
      surfaces: {{floor: level}}
      bodies:
        disc: {{mass: 2 kg, shape: {{disc: 0.2 m}}, moves: along floor}}
        hoop: {{mass: 2 kg, shape: {{hoop: 0.3 m}}, moves: along floor}}
      ties:
        - touches: {{body: disc, on its: rim, mu_s: 0.3, mu_k: 0.25}}
        - touches: {{body: hoop, on its: rim, mu_s: 0.3, mu_k: 0.25}}
        - cord: {{name: c, from: {{body: disc, tied at: centre, leaves: forward}}, to: {{body: hoop, tied at: centre, leaves: back}}}}
        - cord: {{name: p, from: {{body: hoop, tied at: centre, leaves: forward}}, pulled with: {pull} N}}
      start: at rest
      end: at once
    questions: {{q: {{quantity: hoop.a, ask: a}}}}\n"
        )
    };
    let friction = 0.25 * 2.0 * 9.81;
    for (pull, name, a) in [
        (15.0, "rolls", 15.0 / 7.0),
        (25.0, "hoop slips", (25.0 - friction) / 5.0),
        (32.0, "hoop slips", (32.0 - friction) / 5.0),
        (40.0, "slips", (40.0 - 2.0 * friction) / 4.0),
    ] {
        let bank = load::scenes_only(&text(pull), "test").unwrap_or_else(|f| panic!("{f:#?}"));
        let cases = &bank.problems[0].cases;
        let names: Vec<&str> = cases.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["rolls", "disc slips", "hoop slips", "slips"]);
        let solved = cases.iter().map(|c| (c, solve(&c.scene, &[9.81]).unwrap()));
        let found: Vec<_> = solved.filter(|(_, s)| s.all_hold()).collect();
        let [(case, solved)] = found.as_slice() else { panic!("{pull}: {}", found.len()) };
        assert_eq!(case.name, name, "{pull}");
        for body in 0..2 {
            let label = Label { quantity: Quantity::A, of: Owner::Body(body) };
            let entry = solved.get(label).unwrap();
            assert!((entry.value() - a).abs() < 1e-14 * a, "{pull}: {} {a}", entry.value());
        }
        assert!(solved.checks.iter().all(|c| c.ok), "{:?}", solved.checks);
    }
}
