//! Freely composed scenes (one to four bodies; blocks, wheels, drums, yo-yos; contacts, cords, couples, pulls, springs; any
//! start and end) against Lagrange's equations written for this test.
//!
//! The banks of the project have a few dozen kinds of scenes, and every earlier test draws from them: what nobody had thought of
//! (a body that ties hold at rest, blocks that stay where they are, two cords in parallel) was never solved. Here
//! nobody thinks of anything: the lot composes, and what is refused must be refused by name.
use crate::composed;

use crate::composed::{nudged, scene, set_going, yaml};
use crate::lagrange::{Owner, System, Told, Verdict};
use crate::support;
use rayon::prelude::*;
use slipstick::bank::load;
use slipstick::scene as program;
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::{Entry, Refusal, Solved};
use std::collections::BTreeMap;

/// What became of one scene.
enum Outcome {
    Published,
    Refused(String),
    /// Published, and this judge has no say.
    Unjudged(&'static str),
}

fn judge(s: composed::Scene) -> Result<Outcome, String> {
    let text = yaml(&s);
    let verdict = System::new(&s).judge();
    let bank = match load::scenes_only(&text, "composed.yaml") {
        Ok(bank) => bank,
        Err(findings) => {
            let messages: Vec<String> = findings.iter().map(ToString::to_string).collect();
            return named(&messages).map(Outcome::Refused).ok_or_else(|| messages.join("\n"));
        }
    };
    let problem = &bank.problems[0];
    let case = &problem.cases[0];
    let data = support::data(problem);
    // Ties that hold more or less than others only because two data are equal by chance.
    let chance = System::new(&nudged(s.clone())).rank() != System::new(&s).rank();
    let mut solved = match solve(&case.scene, &data) {
        Ok(solved) => solved,
        Err(Refusal::Singular { .. }) => {
            return match verdict {
                Verdict::Undetermined => Ok(Outcome::Refused("motion not determined".into())),
                _ if System::new(&s).massless() => Ok(Outcome::Refused("motion not determined".into())),
                _ => Err("the equations are said not to determine it".into()),
            };
        }
        Err(Refusal::Contradiction { .. }) => {
            return match verdict {
                Verdict::Contradiction => Ok(Outcome::Refused("start against the ties".into())),
                _ => Err("its start is said to contradict the ties".into()),
            };
        }
        Err(Refusal::Open(_)) => {
            return match verdict {
                Verdict::Undetermined | Verdict::Beyond(_) | Verdict::Contradiction => {
                    Ok(Outcome::Refused("start that leaves a velocity open".into()))
                }
                // A speed of 0 of what is held fast: this judge takes that for rest.
                Verdict::Told(told)
                    if told.values.iter().all(|v| *v.0 != *"v" && *v.0 != *"omega" || v.2 == 0.0) =>
                {
                    Ok(Outcome::Refused("start that leaves a velocity open".into()))
                }
                _ => Err("its start is said to leave a velocity open".into()),
            };
        }
        Err(Refusal::EqualByChance { .. }) if !chance => {
            return Err("data are said to be equal by chance".into());
        }
        Err(what @ (Refusal::Unsupported(_) | Refusal::SlipShared(_) | Refusal::EqualByChance { .. })) => {
            return Ok(Outcome::Refused(format!("{what:?}")));
        }
        Err(other) => return Err(format!("{other:?}")),
    };
    prove(&case.scene, &data, &mut solved);
    for e in &solved.entries {
        if e.value().is_nan() || e.energy.is_none_or(f64::is_nan) || e.bound.is_some_and(f64::is_nan) {
            return Err(format!("{:?} is no number", e.label));
        }
    }
    // Where bodies slide in turn, an instant has velocities alone.
    let rates = |e: &Entry| ["a", "alpha"].contains(&e.label.quantity.name());
    let resting = s.event == composed::Event::AtOnce && case.scene.goes_in_phases();
    let alone = resting && !solved.entries.iter().any(rates);
    let told = match verdict {
        Verdict::Told(mut told) if alone => {
            let speeds = [
                "v",
                "omega",
                "kinetic_energy",
                "angular_momentum",
                "rotational_fraction",
                "power_pull",
                "power_couple",
            ];
            told.values.retain(|v| speeds.contains(&v.0));
            told
        }
        _ if alone => return Ok(Outcome::Unjudged("an instant with velocities alone")),
        Verdict::Told(told) => told,
        Verdict::Ambiguous => return Ok(Outcome::Unjudged("two grips fit")),
        Verdict::CouldRoll => {
            return if solved.all_hold() {
                Err("it is said to slip, and could roll".into())
            } else {
                Ok(Outcome::Unjudged("said to slip, could roll: not drawn"))
            };
        }
        Verdict::LiftsOff => {
            return if solved.all_hold() {
                Err("it is said to stay on its surface, and lifts off".into())
            } else {
                Ok(Outcome::Unjudged("lifts off its surface: not drawn"))
            };
        }
        Verdict::Torn => {
            return if solved.all_hold() {
                Err("a contact is said to hold, and is torn loose".into())
            } else {
                Ok(Outcome::Unjudged("a contact that holds is torn loose: not drawn"))
            };
        }
        Verdict::Undetermined => return Err("the motion is not determined".into()),
        Verdict::Contradiction => return Err("its start contradicts the ties".into()),
        Verdict::Beyond(what) => return Err(format!("{what}: not solved by this judge")),
    };
    if told.near_reach {
        return Ok(Outcome::Unjudged("the end is the turning point, to rounding"));
    }
    compare(&s, System::new(&s).forces, &solved, &told)?;
    Ok(Outcome::Published)
}

fn owner(of: program::Owner) -> Owner {
    match of {
        program::Owner::Scene => Owner::Scene,
        program::Owner::Body(b) => Owner::Body(b),
        program::Owner::Tie(t) => Owner::Tie(t),
        other => panic!("these scenes ask for nothing of the kind: {other:?}"),
    }
}

/// Every quantity that is published against the judge, and every one of the judge against what is published.
fn compare(s: &composed::Scene, forces: f64, solved: &Solved, told: &Told) -> Result<(), String> {
    let mut faults = Vec::new();
    for e in &solved.entries {
        let (name, of) = (e.label.quantity.name(), owner(e.label.of));
        if name == "k_bound" {
            // At this radius of gyration there is no friction; where there is no such radius, it points up at any.
            let bound = e.value();
            let k = if bound.is_finite() { bound } else { 1e4 };
            let friction = System::friction_with(s, k).unwrap_or(f64::NAN);
            let fits =
                if bound.is_finite() { friction.abs() <= 1e-9 * forces } else { friction >= -1e-9 * forces };
            if !fits {
                faults.push(format!("k_bound {bound:e}: there the friction is {friction:e}"));
            }
            continue;
        }
        if told.open.contains(&(name, of)) {
            faults.push(format!("{name} of {of:?}: {:e} is published, but nothing determines it", e.value()));
            continue;
        }
        let Some((_, _, want, size)) = told.values.iter().find(|v| v.0 == name && v.1 == of) else {
            if !["mu_required", "friction_if_rolled", "pin_angle", "slip_speed", "a_rolling"].contains(&name)
            {
                faults.push(format!("{name} of {of:?}: {:e} is published, the judge has none", e.value()));
            }
            continue;
        };
        let got = e.value();
        let near = 1e-8 * e.cond.clamp(1.0, 1e6) * want.abs() + 1e-10 * size.abs();
        if !(got == *want || (got - want).abs() <= near) {
            faults.push(format!("{name} of {of:?}: {got:e} is published, {want:e} by the judge"));
        }
    }
    for (name, of, want, _) in &told.values {
        let published =
            solved.entries.iter().any(|e| e.label.quantity.name() == *name && owner(e.label.of) == *of);
        if !published {
            faults.push(format!("{name} of {of:?} is not published; the judge has {want:e}"));
        }
    }
    for c in &solved.checks {
        let name = c.kind.name();
        if let Some((_, _, ok)) = told.checks.iter().find(|k| k.0 == name && k.1 == c.of)
            && *ok != c.ok
        {
            faults.push(format!("check {name} of {}: {} is published, {ok} by the judge", c.of, c.ok));
        }
        if name == "moves" && c.ok != told.as_said {
            faults.push(format!("moves: {} is published, {} by the judge", c.ok, told.as_said));
        }
        if name == "reaches" && !told.near_reach && c.ok != told.reached {
            faults.push(format!("reaches: {} is published, {} by the judge", c.ok, told.reached));
        }
    }
    for (label, word) in &solved.words {
        if label.quantity == program::Quantity::Direction && word.as_str() != told.direction {
            faults.push(format!(
                "direction: {} is published, {} by the judge",
                word.as_str(),
                told.direction
            ));
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// The name of a refusal by the bank, if it is one that a scene of this kind may meet.
fn named(messages: &[String]) -> Option<String> {
    const NAMES: &[(&str, &str)] = &[
        ("the ties leave nothing free to move", "no freedom"),
        ("a spring holds a scene with", "spring with two freedoms"),
        ("slips, and there is a spring", "spring where something slips"),
        ("how it starts says which way it goes", "heading of what starts with slip"),
        ("the start and the ties leave", "start that leaves a velocity open"),
        ("the rest of the start already give", "start that says a velocity twice"),
        ("`rolling` ends the slip of a body", "rolling of what does not start with slip"),
        ("the ties leave one freedom, so one speed", "start that says a velocity twice"),
    ];
    let mut first = None;
    for m in messages {
        let name = NAMES.iter().find(|(text, _)| m.contains(text))?.1;
        first.get_or_insert(name);
    }
    first.map(str::to_owned)
}

#[test]
fn composed_scenes_agree_with_lagrange_or_are_refused_by_name() {
    all_agree(&scene, |name| match name {
        "slips" => 12,
        "end: at once" | "start with a speed" | "rigid spring" | "spring on a cord" | "pull at an angle" => {
            30
        }
        _ => 45,
    });
}

/// The same of scenes that are set going, in as many freedoms as they have, with contacts that rub.
#[test]
fn composed_scenes_set_going_agree_with_lagrange_or_are_refused_by_name() {
    let adds = |s: &composed::Scene| System::new(s).starts_add();
    all_agree(&|seed| set_going(seed, adds), |_| 12);
}

/// Judges the scenes of the seeds; of each construct so many of 100 at least are published.
fn all_agree(scene: &(dyn Fn(u64) -> composed::Scene + Sync), least: impl Fn(&str) -> u32) {
    let mut refusals: BTreeMap<String, u32> = BTreeMap::new();
    let mut unjudged: BTreeMap<&str, u32> = BTreeMap::new();
    // For each construct: scenes, published and judged.
    let mut constructs: BTreeMap<&str, (u32, u32)> = BTreeMap::new();
    let mut faults = Vec::new();
    let from: u64 = std::env::var("SLIPSTICK_FIRST").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
    let judged: Vec<_> = (from..from + u64::from(support::seeds(1_000_000)))
        .into_par_iter()
        .map(|seed| {
            let judged = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| judge(scene(seed))));
            (seed, judged.unwrap_or_else(|_| Err("panics".into())))
        })
        .collect();
    for (seed, outcome) in judged {
        let published = matches!(outcome, Ok(Outcome::Published));
        for c in scene(seed).constructs {
            let (all, good) = constructs.entry(c).or_default();
            *all += 1;
            *good += u32::from(published);
        }
        match outcome {
            Ok(Outcome::Published) => {}
            Ok(Outcome::Refused(name)) => *refusals.entry(name).or_default() += 1,
            Ok(Outcome::Unjudged(why)) => *unjudged.entry(why).or_default() += 1,
            Err(why) => faults.push((seed, why)),
        }
    }
    println!("construct: scenes, published and judged right");
    for (name, (all, good)) in &constructs {
        println!("  {name:<22}{all:>7}{good:>7}  {:.0} %", 100.0 * f64::from(*good) / f64::from(*all));
    }
    println!("refused by name");
    for (name, count) in &refusals {
        println!("  {name:<30}{count:>7}");
    }
    println!("published, and not judged here");
    for (name, count) in &unjudged {
        println!("  {name:<40}{count:>7}");
    }
    let mut kinds: BTreeMap<String, (u32, u64)> = BTreeMap::new();
    for (seed, why) in &faults {
        let kind: String =
            why.lines().next().unwrap_or("").chars().filter(|c| !c.is_ascii_digit()).take(60).collect();
        let k = kinds.entry(kind).or_insert((0, *seed));
        k.0 += 1;
    }
    for (kind, (count, seed)) in &kinds {
        println!("fault {count:>5} x, first seed {seed}: {kind}");
        let why = &faults.iter().find(|(s, _)| s == seed).unwrap().1;
        println!("{why}\n{}", yaml(&scene(*seed)).split_once("data:").unwrap().1);
    }
    // What refuses everything would pass, too: of each construct so many of 100 are published, and judged right.
    for (name, (all, good)) in &constructs {
        let least = least(name);
        assert!(*all < 40 || good * 100 >= least * all, "{name}: only {good} of {all} are published");
    }
    if let Some((seed, why)) = faults.first() {
        panic!("{} scenes fail; seed {seed}:\n{why}\n{}", faults.len(), yaml(&scene(*seed)));
    }
}
