//! Runs both roads and compares; the only file that sees both.
use crate::num::Dd;
use crate::num::Jet;
use crate::num::Real;
use crate::num::U;
use crate::scene::End;
use crate::scene::Scene;
use crate::scene::Start;
use crate::scene::Tie;
use crate::scene::admissible;
use crate::solve::energy;
use crate::solve::eom;
use crate::solve::outcome::Entry;
use crate::solve::outcome::Motion;
use crate::solve::outcome::Refusal;
use crate::solve::outcome::Regime;
use crate::solve::outcome::Road;
use crate::solve::outcome::Said;
use crate::solve::outcome::Solved;
use crate::solve::outcome::Unsupported;
use crate::solve::physical;

/// Each road may be off by `8 u max(1, cond)`.
pub const EACH_ROAD: f64 = 8.0;

/// Solves a scene by both roads and publishes only what agrees.
///
/// `data` are the SI values (angles in degrees) that [`crate::scene::Num::Datum`] indexes. Each answer carries both
/// values and its condition number. Errors: data that are no scene, a combination that the assembly does not have,
/// equations that do not determine the motion, two roads that differ by more than `16 u max(1, cond)`.
pub fn solve(scene: &Scene, data: &[f64]) -> Result<Solved, Refusal> {
    let faults = admissible::faults(scene, data);
    if !faults.is_empty() {
        return Err(Refusal::Inadmissible(faults));
    }
    supported(scene)?;
    match data.len() {
        0..=12 => compare::<Jet<12>>(scene, data),
        13..=24 => compare::<Jet<24>>(scene, data),
        25..=64 => compare::<Jet<64>>(scene, data),
        _ => Err(Refusal::Unsupported(Unsupported::TooManyData)),
    }
}

/// Is the combination one that the assembly has?
fn supported(scene: &Scene) -> Result<(), Refusal> {
    let lamina = scene.bodies.iter().any(|b| !b.particles.is_empty());
    if matches!(scene.end, End::AtOnce) {
        return Ok(());
    }
    let refuse = |what| Err(Refusal::Unsupported(what));
    if lamina || scene.start.iter().any(|s| matches!(s, Start::Lamina { .. })) {
        return refuse(Unsupported::MovingLamina);
    }
    let springs = scene
        .ties
        .iter()
        .filter(|t| matches!(t, Tie::Cord(c) if matches!(c.to, crate::scene::Far::Spring { .. })));
    let springs = springs.count();
    if springs > 1 {
        return refuse(Unsupported::TwoSprings);
    }
    let freedoms = freedoms(scene);
    if freedoms > 1 && springs > 0 {
        return refuse(Unsupported::SpringWithTwoFreedoms);
    }
    if freedoms > 1 && !scene.start.is_empty() {
        return refuse(Unsupported::SpeedWithTwoFreedoms);
    }
    if freedoms < 1 {
        return Err(Refusal::Freedoms(0));
    }
    Ok(())
}

/// Coordinates less ties.
fn freedoms(scene: &Scene) -> usize {
    let ties = scene.ties.iter().filter(|t| match t {
        Tie::Roll { .. } => true,
        Tie::Slip { .. } | Tie::Slide { .. } => false,
        Tie::Cord(c) => matches!(c.to, crate::scene::Far::Body(_) | crate::scene::Far::Fixed),
    });
    scene.coordinates().count().saturating_sub(ties.count())
}

fn compare<T: Real>(scene: &Scene, data: &[f64]) -> Result<Solved, Refusal> {
    let first: Road<T> = eom::road(scene, data)?;
    let second: Road<Dd> = energy::road(scene, data)?;
    let mut entries = Vec::with_capacity(first.said.len());
    for (i, said) in first.said.iter().enumerate() {
        let label = said.label;
        let eom = said.value.f64();
        // The roads mostly speak in the same order.
        let other = second.said.get(i).filter(|s| s.label == label).or_else(|| second.get(label));
        let energy = other.map_or(f64::NAN, |s| s.value.f64());
        let cond = said.value.cond();
        if !agree(eom, energy, cond) {
            let allowed = 2.0 * EACH_ROAD * U * cond.max(1.0);
            return Err(Refusal::Disagree { label, eom, energy, allowed });
        }
        entries.push(Entry { label, eom: Some(eom), energy: Some(energy), cond, scale: said.scale });
    }
    // What only the second road says is a disagreement too: both must reach the same quantities.
    let alone = |(i, s): &(usize, &Said<Dd>)| {
        first.said.get(*i).is_none_or(|f| f.label != s.label) && first.get(s.label).is_none()
    };
    if let Some((_, said)) = second.said.iter().enumerate().find(alone) {
        let (label, energy) = (said.label, said.value.f64());
        return Err(Refusal::Disagree { label, eom: f64::NAN, energy, allowed: 2.0 * EACH_ROAD * U });
    }
    entries.sort_by_key(|e| e.label);
    let (Some(mut course), Some(other)) = (first.course, second.course) else {
        let regime = Regime { motion: Motion::Instant, slips: false };
        return Ok(Solved { regime, checks: Vec::new(), entries, words: Vec::new() });
    };
    // The drive is a sum of powers: only the second road has it, and only for margins.
    course.drive = other.drive;
    let (regime, checks, words) = physical::judge(scene, &course, &first.held);
    Ok(Solved { regime, checks, entries, words })
}

/// Within `16 u max(1, cond)` of the larger; NaN agrees with nothing, equal infinities agree.
fn agree(a: f64, b: f64, cond: f64) -> bool {
    if a == b {
        return true;
    }
    let larger = a.abs().max(b.abs());
    larger.is_finite() && (a - b).abs() <= 2.0 * EACH_ROAD * U * cond.max(1.0) * larger
}
