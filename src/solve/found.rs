//! The inverse question: of a datum that was measured, the solution with the value of another datum that gives just this
//! measurement. Each road finds it for itself, on its own equations, from the stated range alone.
//!
//! Beside it stands what both roads do alike with what they find of one scene: what is asked by formulas is worked out from it.
use crate::num::Dd;
use crate::num::dd::pow2;
use crate::num::{Fast, Real, ball, root};
use crate::scene::{Found, Numbers, Quantity, Scene};
use crate::solve::outcome::{Refusal, Road, Said, Scope};

/// Places of the stated range at which a change of sign is looked for.
const PLACES: u32 = 16;
/// Halvings of a place of the range at whose one end there is nothing to measure.
const HALVINGS: u32 = 50;
/// Relative step of the last correction, in doubles and in 32 digits: the slope is good to half of the digits in doubles; in 32 to as
/// many as the correction of some 2^-53 needs, and the step is hardly longer than that: the less the solution bends over it, as it does
/// just above a least speed.
const STEPS: [f64; 2] = [pow2(-26), pow2(-50)];
/// The last correction may not be larger than this: beyond it what is linear over a step no longer tells the root.
const NEAR: f64 = pow2(-34);
/// Half-widths that are tried about the root, as powers of 2 of its size.
const WIDTHS: [i32; 4] = [-44, -40, -34, -28];
/// Enclosures of parts of the range that are spent on showing that there is no other root.
const MOST: u32 = 20_000;

/// What a road finds of one scene with its numbers, as far as it is asked.
pub type Finds<T> = fn(&Scene, Numbers<T>, Scope) -> Result<Road<T>, Refusal>;

/// A road that solves a scene again and again with other values of the unknown.
struct Forward<'s, T: Real> {
    scene: &'s Scene,
    finds: Finds<T>,
    /// The same in doubles.
    rough: Finds<Fast>,
}

impl<T: Real> Forward<'_, T> {
    /// What was measured, with all data given: of an expression that is everything.
    fn measured<X: Real>(&self, found: &Found, data: &[f64], finds: Finds<X>) -> Result<Road<X>, Refusal> {
        match found.label.quantity {
            Quantity::Value => answered(self.scene, data, Scope::ALL.granting(), finds),
            quantity => alone(self.scene, data, Scope::only([quantity]).granting(), finds),
        }
    }
    /// All that is asked.
    fn exact(&self, data: &[f64]) -> Result<Road<T>, Refusal> {
        answered(self.scene, data, Scope::ALL, self.finds)
    }
}

/// What a road says of what is asked, in its own numbers and, where it searches, in doubles; where a formula asks, that is everything.
///
/// # Errors
/// Those of the road; no value of the stated range gives the measurement, or it cannot be shown to be the only one.
pub fn road_of<T: Real>(
    scene: &Scene,
    data: &[f64],
    asked: Scope,
    (finds, rough): (Finds<T>, Finds<Fast>),
) -> Result<Road<T>, Refusal> {
    match &scene.formulas.found {
        Some(found) => road(found, data, &Forward { scene, finds, rough }),
        None => answered(scene, data, asked, finds),
    }
}

/// The value of the unknown that gives the measurement, to a few units of doubles.
pub fn datum(scene: &Scene, data: &[f64], (finds, rough): (Finds<Dd>, Finds<Fast>)) -> Option<f64> {
    search(scene.formulas.found.as_ref()?, data, &Forward { scene, finds, rough })
}

/// The road without what is asked by formulas, with all data given.
fn alone<T: Real>(scene: &Scene, data: &[f64], asked: Scope, finds: Finds<T>) -> Result<Road<T>, Refusal> {
    Ok(finds(scene, Numbers::new(scene, data), asked)?.telling(scene))
}

/// [`road_of`] with all data given.
fn answered<T: Real>(scene: &Scene, data: &[f64], asked: Scope, finds: Finds<T>) -> Result<Road<T>, Refusal> {
    let asked = if scene.formulas.asked.is_empty() { asked } else { asked.with(Scope::ALL) };
    answering(alone(scene, data, asked, finds)?, scene, data, finds)
}

/// What was found of a scene, with what is asked by formulas.
///
/// # Errors
/// Those of [`Road::answering`].
pub fn answering<T: Real>(
    road: Road<T>,
    scene: &Scene,
    data: &[f64],
    finds: Finds<T>,
) -> Result<Road<T>, Refusal> {
    road.answering(scene, data, &|other, data, taken| {
        Ok(finds(other, Numbers::after(other, data, taken), Scope::ALL)?.telling(other))
    })
}

/// What is measured on a road, less its printed value.
fn miss<T: Real>(found: &Found, road: &Road<T>, data: &[f64]) -> Option<T> {
    road.get(found.label).map(|said| said.value - found.measured.value(data))
}

/// The road at the value of the unknown that gives the measurement.
fn road<T: Real>(found: &Found, data: &[f64], forward: &Forward<T>) -> Result<Road<T>, Refusal> {
    let root = search(found, data, forward).ok_or_else(|| nowhere(found, data, forward))?;
    let mut at = data.to_vec();
    let unknown = found.unknown.datum;
    if T::ENCLOSES {
        return enclosed(found, &mut at, root, forward);
    }
    at[unknown] = root;
    let mut near = forward.exact(&at)?;
    let step = STEPS[usize::from(!T::is_double())];
    at[unknown] = root * (1.0 + step);
    let beside = forward.exact(&at)?;
    let (y0, y1) = (miss(found, &near, data), miss(found, &beside, data));
    let (Some(y0), Some(y1)) = (y0, y1) else { return Err(Refusal::NotFound) };
    // The share of the step at which nothing is missing.
    let share = -(y0 / (y1 - y0));
    let settled = share.size() * step < NEAR;
    if !settled && !T::is_double() {
        return Err(Refusal::NotFound);
    }
    let correct = |said: &mut Said<T>| {
        // What is endless stays so.
        if let Some(change) =
            beside.get(said.label).map(|other| other.value - said.value).filter(|c| c.is_finite())
        {
            said.value = said.value + share * change;
        }
    };
    near.said.iter_mut().for_each(correct);
    Ok(near)
}

/// Why no value is found: what the road refuses alike at both ends of the range and between them has nothing to do with it.
fn nowhere<T: Real>(found: &Found, data: &[f64], forward: &Forward<T>) -> Refusal {
    let [low, high] = found.range;
    let [one, middle, other] = [low, f64::midpoint(low, high), high].map(|x| {
        let mut at = data.to_vec();
        at[found.unknown.datum] = x;
        forward.measured(found, &at, forward.rough).err()
    });
    let alike = |why: &Option<Refusal>| why.as_ref().map(std::mem::discriminant);
    one.filter(|why| [&middle, &other].into_iter().all(|w| alike(w) == Some(std::mem::discriminant(why))))
        .unwrap_or(Refusal::NotFound)
}

/// The root to a few units of doubles, in the first place of the range where the sign changes.
fn search<T: Real>(found: &Found, data: &[f64], forward: &Forward<T>) -> Option<f64> {
    let printed: f64 = found.measured.value(data);
    let miss = |x: f64| {
        let mut at = data.to_vec();
        at[found.unknown.datum] = x;
        let road = forward.measured(found, &at, forward.rough).ok();
        road.and_then(|road| Some(road.get(found.label)?.value)).unwrap_or(f64::NAN) - printed
    };
    let between = |low: (f64, f64), high: (f64, f64)| {
        let value = |x: f64| Ok::<_, ()>(miss(x));
        root::between_values(low.0, high.0, high.1 > 0.0, &value).ok()
    };
    let [low, high] = found.range;
    // A wrong method may come to a value beyond the range; what is published may not.
    let beyond = [(low, low - 3.0 * low.abs() / 4.0), (high, high + 3.0 * high.abs())];
    let tried = std::iter::once((low, high)).chain(beyond.into_iter().filter(|_| T::is_double()));
    for (low, high) in tried {
        let mut before: Option<(f64, f64)> = None;
        let step = (high - low) / f64::from(PLACES);
        for i in 0..=PLACES {
            let now = (low + step * f64::from(i), miss(low + step * f64::from(i)));
            if now.1 == 0.0 {
                return Some(now.0);
            }
            let Some(last) = before.replace(now) else { continue };
            // Where there is nothing to measure at one end, what is measured may still pass the printed value before that.
            let [from, to] = match (last.1.is_nan(), now.1.is_nan()) {
                (true, true) => continue,
                (false, false) => [last, now],
                (true, false) => [edge(last.0, now, &miss), now],
                (false, true) => [last, edge(now.0, last, &miss)],
            };
            if from.1 * to.1 <= 0.0 {
                return between(from, to);
            }
        }
    }
    None
}

/// The place with a value, next to one that has none or of the other sign than at a place with a value.
fn edge(mut nowhere: f64, mut place: (f64, f64), miss: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let sign = place.1;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(nowhere, place.0);
        let now = miss(middle);
        if now.is_nan() {
            nowhere = middle;
        } else {
            place = (middle, now);
            if now * sign <= 0.0 {
                break;
            }
        }
    }
    place
}

/// The road over an interval about the root, which is shown to hold every root of the range.
fn enclosed<T: Real>(
    found: &Found,
    at: &mut [f64],
    root: f64,
    forward: &Forward<T>,
) -> Result<Road<T>, Refusal> {
    let unknown = found.unknown.datum;
    // The sign of what is missing over an interval, where the enclosure decides it.
    let mut sign = |low: f64, high: f64| {
        let middle = f64::midpoint(low, high);
        at[unknown] = middle;
        let radius = (high - middle).max(middle - low);
        let measured = || forward.measured(found, at, forward.finds);
        let (road, doubt) = ball::watch(|| ball::spread(unknown, radius, measured));
        let Some(missed) = miss(found, &road.ok()?, at) else {
            // All over it there is nothing to measure.
            return (!doubt).then_some(f64::NAN);
        };
        let size = missed.f64().abs();
        (!doubt && size.is_finite() && size > missed.radius()).then(|| missed.sign())
    };
    let [low, high] = found.range;
    let width = WIDTHS.into_iter().map(|power| root.abs() * pow2(power)).find(|w| {
        let ends = (sign(root - w, root - w), sign(root + w, root + w));
        matches!(ends, (Some(a), Some(b)) if a * b < 0.0)
    });
    let width = width.ok_or(Refusal::NotFound)?;
    let mut spent = 0;
    for (from, to) in [(low, root - width), (root + width, high)] {
        let mut open = if from < to { vec![(from, to)] } else { Vec::new() };
        while let Some((from, to)) = open.pop() {
            spent += 1;
            if spent > MOST {
                return Err(Refusal::NotUnique(None));
            }
            if sign(from, to).is_none() {
                let middle = f64::midpoint(from, to);
                if middle <= from || middle >= to {
                    return Err(Refusal::NotUnique(None));
                }
                open.extend([(from, middle), (middle, to)]);
            }
        }
    }
    at[unknown] = root;
    ball::spread(unknown, width, || forward.exact(at))
}
