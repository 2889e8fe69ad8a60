//! Wrong methods against reference values: what each of the known ones comes to, by its id, on homework-like data.
use crate::support;
use serde_json::Value;
use slipstick::bank::load;
use slipstick::misconception;
use slipstick::problem::maker::Maker;
use slipstick::scene::{Label, Owner, Quantity};
use slipstick::solve::outcome::{Road, Scope, Set};
use slipstick::solve::{agree, eom};
use std::collections::BTreeMap;

const CASES: &str = include_str!("../reference/solver_cases.json");
const METHODS: &str = include_str!("../reference/wrong_methods.tsv");
const WHEELS: &str = include_str!("../../banks/wheels-on-inclines.yaml");

/// Quantity of a method of the list.
fn quantity(name: &str) -> Quantity {
    match name {
        "omega" => Quantity::Omega,
        "v" => Quantity::V,
        "f" => Quantity::Friction,
        "N" => Quantity::Normal,
        "work_f" => Quantity::Heat,
        "vmax" => Quantity::VMax,
        _ => panic!("no quantity {name}"),
    }
}

#[test]
fn each_known_wrong_method_comes_to_its_reference_value() {
    let bank = load::scenes_only(WHEELS, "wheels-on-inclines.yaml").unwrap();
    let methods: Vec<Vec<&str>> = METHODS.lines().skip(1).map(|l| l.split('\t').collect()).collect();
    assert_eq!(methods.len(), 71);
    let file: Value = serde_json::from_str(CASES).unwrap();
    let cases = file["cases"].as_array().or(file.as_array()).unwrap();
    let mut faults: Vec<String> = Vec::new();
    let mut compared: BTreeMap<&str, usize> = BTreeMap::new();
    for case in cases.iter().filter(|c| c["wrong"].is_object()) {
        let id = case["scene"].as_str().unwrap();
        let problem = bank.problems.iter().find(|p| p.id == id).unwrap();
        let data: Vec<f64> = problem
            .data
            .iter()
            .map(|d| {
                case["inputs"][d.symbol.as_str()].as_f64().unwrap_or_else(|| panic!("{id} {}", d.symbol))
            })
            .collect();
        let solved = agree::solve(&problem.cases[0].scene, &data).unwrap();
        for m in methods.iter().filter(|m| m[1] == id) {
            let of = match quantity(m[2]) {
                Quantity::Heat => Owner::Scene,
                _ => Owner::Body(0),
            };
            let label = Label { quantity: quantity(m[2]), of };
            let mistake = problem.mistakes.iter().position(|x| x.id == m[0]);
            let mistake = mistake.unwrap_or_else(|| panic!("{id} has no wrong method {}", m[0]));
            assert!(solved.get(label).is_some(), "{label:?}");
            let mut all = misconception::values(problem, 0, &data, &solved, &[label]);
            all.retain(|w| w.mistake == mistake);
            let expected = case["wrong"][m[0]].as_str().map(|t| t.parse::<f64>().unwrap());
            let found = all.first().map(|w| w.value);
            // The reference gives the work of friction and the friction of A26 down the incline as negative.
            let same = match (found, expected) {
                (Some(f), Some(e)) if quantity(m[2]) == Quantity::Heat => {
                    (f - e.abs()).abs() <= 1e-9 * e.abs()
                }
                (Some(f), Some(e)) => (f - e).abs() <= 1e-9 * e.abs(),
                (None, None) => true,
                _ => false,
            };
            if !same {
                faults.push(format!("{} {}: {found:?} against {expected:?}", case["id"], m[0]));
            }
            *compared.entry(m[0]).or_default() += usize::from(found.is_some());
        }
    }
    assert!(
        faults.is_empty(),
        "{} faults\n{}",
        faults.len(),
        faults.iter().take(40).cloned().collect::<Vec<_>>().join("\n")
    );
    println!("{} methods, {} values", compared.len(), compared.values().sum::<usize>());
    assert_eq!(compared.len(), 71, "{compared:?}");
    assert!(compared.values().filter(|n| **n >= 10).count() >= 68, "{compared:?}");
}

/// Several sets of data are walked at once: the first as it would be alone, the others as the first one moves or, where they would
/// move otherwise, alone.
#[test]
fn several_sets_of_data_come_to_what_each_comes_to_alone() {
    let mut compared = 0;
    for bank in support::banks() {
        for problem in &bank.problems {
            let variant = Maker::new(problem, 1, "sets").variant("1").unwrap();
            let scene = &problem.cases[variant.case].scene;
            // A little off, by far, the other way, and nothing at all; joined bodies are walked together a little off alone.
            let factors = [1.0 + 1e-8, 0.3, 7.0, -1.0, 0.0];
            let factors = &factors[..if eom::side_by_side(scene) { factors.len() } else { 1 }];
            let moved = |(i, factor): (usize, &f64)| {
                let mut set: Set = variant.data.clone();
                set[i] *= factor;
                set
            };
            let mut sets: Vec<Set> = vec![variant.data.clone()];
            sets.extend((0..variant.data.len()).flat_map(|i| factors.iter().map(move |f| (i, f))).map(moved));
            let asked = Scope { held: false, ..Scope::ALL };
            for (set, road) in sets.iter().zip(eom::roads(scene, &sets, asked)) {
                let alone: Option<Road<f64>> = eom::road_of(scene, set, asked).ok();
                let what = format!("{} {set:?}", problem.id);
                assert_eq!(road.is_some(), alone.is_some(), "{what}");
                let (Some(road), Some(alone)) = (road, alone) else { continue };
                assert_eq!(road.kind(), alone.kind(), "{what}");
                for (at, alone) in alone.said.iter().enumerate() {
                    let (label, a, b) = (alone.label, road.value(at, alone.label), alone.value);
                    let a = a.unwrap_or_else(|| panic!("{what}: {label:?}"));
                    let near = (a - b).abs() <= 1e-11 * a.abs().max(b.abs()).max(alone.scale);
                    assert!(
                        near || a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
                        "{what} {label:?}: {a:e}, {b:e}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}
