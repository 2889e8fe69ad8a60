//! Worked solutions of scenes composed by lot, of which everything is asked that is published: each has one, and each printed
//! equation, solved again in intervals, holds. The scenes of the banks have the ends and the quantities that somebody thought
//! of; what nobody had thought of got data and answers alone.
use crate::lot;
use crate::support;
use crate::tex;
use rayon::prelude::*;
use slipstick::bank::decimal::Decimal;
use slipstick::bank::{Draw, Problem, load};
use slipstick::problem::maker::{self, Variant};
use slipstick::solution;
use slipstick::template::Templates;
use slipstick::words::Words;
use std::collections::BTreeMap;

fn values(problem: &Problem) -> Vec<Option<Decimal>> {
    let given = |draw: &Option<Draw>| match draw {
        Some(Draw::Always { value, decimals }) => Some(Decimal { value: *value, decimals: *decimals }),
        _ => None,
    };
    problem.cases[0].draws.iter().map(given).collect()
}

/// The scene of this lot with a question for each quantity that it has; `None` where it is refused or would not be drawn.
fn asked(seed: u64) -> Option<(Problem, Variant, String)> {
    let text = lot::yaml(&lot::scene(seed));
    let solve = |text: &str| {
        let bank = load::scenes_only(text, "composed.yaml").ok()?;
        let problem = bank.problems.into_iter().next()?;
        let variant = maker::from_values(&problem, 0, &values(&problem)).ok()?;
        Some((problem, variant))
    };
    let (problem, variant) = solve(&text)?;
    if !variant.solved.holds_as(&[variant.solved.regime.word()]) {
        return None;
    }
    let scene = &problem.cases[0].scene;
    let numbers = variant.solved.entries.iter().filter(|e| e.value().is_finite()).map(|e| e.label);
    let labels = numbers.chain(variant.solved.words.iter().map(|(label, _)| *label));
    let lines: String = labels
        .enumerate()
        .map(|(i, label)| format!("      q{i}: {{quantity: {}, ask: it}}\n", scene.name_of(label)))
        .collect();
    let text = format!("{}    questions:\n{lines}", text.split("    questions:").next()?);
    let (problem, variant) =
        solve(&text).unwrap_or_else(|| panic!("asked of everything it is refused:\n{text}"));
    Some((problem, variant, text))
}

#[test]
#[ignore = "under way"]
fn every_composed_scene_has_a_true_solution() {
    let (words, templates) = (Words::english(), Templates::new("en", &[]).unwrap());
    let from: u64 = std::env::var("SLIPSTICK_FIRST").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
    let told: Vec<(u64, String)> = (from..from + 10 * u64::from(support::seeds(1000)))
        .into_par_iter()
        .filter_map(|seed| {
            let (problem, variant, bank) = asked(seed)?;
            let text = solution::text(&problem, &variant, 1, &words, &templates).expect("a text");
            let short = text.split_once(words.get("solution.title.beyond")).map(|(_, why)| why.to_owned());
            let mut wrong = tex::check(&text, &mut tex::Counts::default());
            wrong.extend(short);
            let kind = wrong.first().cloned().unwrap_or_default();
            if !kind.is_empty() && std::env::var("TELL").is_ok() {
                println!("{seed}: {}\n{bank}\n{text}", wrong.join("\n"));
            }
            Some((seed, kind))
        })
        .collect();
    let mut kinds: BTreeMap<String, (u32, u64)> = BTreeMap::new();
    for (seed, kind) in told.iter().filter(|(_, kind)| !kind.is_empty()) {
        kinds.entry(kind.chars().take(230).collect()).or_insert((0, *seed)).0 += 1;
    }
    let bad: u32 = kinds.values().map(|(n, _)| n).sum();
    println!("{} solutions, {bad} short or false", told.len());
    let mut kinds: Vec<_> = kinds.into_iter().collect();
    kinds.sort_by_key(|(_, (n, _))| std::cmp::Reverse(*n));
    for (kind, (n, seed)) in kinds.iter().take(40) {
        println!("{n:>5} x, first {seed}: {kind}");
    }
    assert_eq!(bad, 0);
}
