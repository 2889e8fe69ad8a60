//! How far an answer moves with the data: its condition number `sum |d ln y / d ln x_i|` over the data that the scene uses, by
//! difference quotients of the first road in doubles.
//!
//! A quotient needs a motion of the same kind on both sides: where a changed datum turns the motion or takes its end out of
//! reach, the other side alone counts. The step is so small that its curvature, of the order of `(step cond)^2`, is below a
//! millionth, and so large that the rounding of doubles, `2^-53 cond / step`, is so too.
use crate::num::NOISE;
use crate::num::Real;
use crate::num::dd::pow2;
use crate::scene::Label;
use crate::scene::Num;
use crate::scene::Scene;
use crate::scene::admissible;
use crate::solve::eom;
use crate::solve::outcome::Entry;
use crate::solve::outcome::Road;

/// Relative changes of a datum, the next one where an answer is too sensitive for the one before.
const STEPS: [i32; 4] = [-20, -26, -36, -46];
/// A step is fine enough for an answer whose relative change stays below this.
const FINE: f64 = 2e-4;

/// Sense of the motion, and whether its end is reached; `None` where only an instant is asked.
pub type Kind = Option<(f64, bool)>;

/// Condition number of each entry: 0 if no datum moves it, infinite for a zero that some datum moves.
pub fn numbers(scene: &Scene, data: &[f64], kind: Kind, entries: &[Entry]) -> Vec<f64> {
    let used = used(scene, data);
    let mut conds = vec![f64::NAN; entries.len()];
    for step in STEPS.map(pow2) {
        let mut sums = vec![0.0; entries.len()];
        let mut moved = data.to_vec();
        for &i in &used {
            let sides = [1.0 + step, 1.0 - step].map(|by| {
                moved[i] = data[i] * by;
                let road: Option<Road<f64>> = eom::road(scene, &moved).ok();
                (road, moved[i] / data[i] - 1.0)
            });
            moved[i] = data[i];
            // Of two sides of which one has another kind of motion, that one does not count.
            let same = |road: &Road<f64>| road.course.as_ref().map(|c| (c.sense, c.reached)) == kind;
            let alike = sides.each_ref().map(|(road, _)| road.as_ref().is_some_and(same));
            for (at, (sum, entry)) in sums.iter_mut().zip(entries).enumerate() {
                let value = |side: usize| {
                    let road = sides[side].0.as_ref().filter(|_| alike[side] || !alike[1 - side])?;
                    value(road, at, entry.label)
                };
                *sum += slope(entry, [(value(0), sides[0].1), (value(1), sides[1].1)]);
            }
        }
        let mut rough = false;
        for ((cond, sum), entry) in conds.iter_mut().zip(sums).zip(entries).filter(|((c, _), _)| c.is_nan()) {
            let found = relative(entry, sum);
            let fine = found * step <= FINE || found.is_infinite() || step <= pow2(STEPS[STEPS.len() - 1]);
            rough |= !fine;
            *cond = if fine { found } else { f64::NAN };
        }
        if !rough {
            break;
        }
    }
    conds
}

/// The data that the scene uses and that are not 0: a relative change of 0 is none.
fn used(scene: &Scene, data: &[f64]) -> Vec<usize> {
    let mut used = vec![false; data.len()];
    admissible::rules(scene, |number, _| {
        if let Num::Datum(i) = number
            && data.get(i).is_some_and(|x| *x != 0.0)
        {
            used[i] = true;
        }
    });
    (0..data.len()).filter(|i| used[*i]).collect()
}

/// What a road says of a label; the roads mostly speak in the same order.
fn value(road: &Road<f64>, at: usize, label: Label) -> Option<f64> {
    road.said.get(at).filter(|s| s.label == label).or_else(|| road.get(label)).map(|s| s.value)
}

/// Change of an entry per relative change of a datum, from its values at changed data; endless where no changed datum gives one.
fn slope(entry: &Entry, sides: [(Option<f64>, f64); 2]) -> f64 {
    let y = entry.value();
    // At a zero the two sides of a magnitude are alike: each counts by itself.
    if let ([(Some(a), up), (Some(b), down)], true) = (sides, y != 0.0) {
        return ((a - b) / (up - down)).abs();
    }
    let rounding = 2.0 * f64::NOISE * entry.scale;
    let alone = |(value, by): (Option<f64>, f64)| {
        let change = (value? - y).abs();
        Some(if y == 0.0 && change <= rounding { 0.0 } else { (change / by).abs() })
    };
    sides
        .into_iter()
        .filter_map(alone)
        .fold(None, |most: Option<f64>, s| Some(most.map_or(s, |m| m.max(s))))
        .unwrap_or(f64::INFINITY)
}

/// The sum of the changes as a share of the answer. A place that is 0 is told by the scale of its terms: where the origin lies
/// says nothing of how well it is known.
fn relative(entry: &Entry, sum: f64) -> f64 {
    let y = entry.value();
    if y.is_infinite() || sum == 0.0 {
        // What is endless stays so, whatever small change of the data.
        0.0
    } else if entry.label.quantity.is_place() && vanishes(y, NOISE, entry.scale) {
        sum / entry.scale
    } else {
        (sum / y).abs()
    }
}

/// Is a value this share of the terms that make it up, or less? A scale near the least of doubles judges nothing.
pub fn vanishes(value: f64, share: f64, scale: f64) -> bool {
    scale.is_finite() && share * scale > f64::MIN_POSITIVE && value.abs() <= share * scale
}
