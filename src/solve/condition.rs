//! How far an answer moves with the data: its condition number `sum |d ln y / d ln x_i|` over the data that the scene uses, by
//! difference quotients of the first road, in doubles. Where their rounding would tell, the data are changed farther to both sides, and
//! if that does not do, it is reckoned in 32 digits.
//!
//! A quotient needs a motion of the same kind at the changed data: where a changed datum turns the motion or takes its end out of
//! reach, the other side alone counts. The step is so small that what curvature does is below a millionth, of the order of
//! `step cond` on one side and of `(step cond)^2` between two, and so large that the rounding of doubles, `2^-53 / step`, is so too.
//! Of joined bodies and bodies on a pin, whose motions are summed, up to three data are not changed: no answer hangs on the units of mass, length
//! and time, so what these data do follows from what the others do.
use crate::num::dd::pow2;
use crate::num::eliminate::Equations;
use crate::num::{Dd, NOISE, Real};
use crate::scene::{Scales, Scene, admissible, scales};
use crate::solve::eom;
use crate::solve::outcome::{Entry, Kind, Scope, Set, Told};

/// Relative changes of a datum, as powers of 2; the next one for the answers that are too sensitive for the one before.
const STEPS: [i32; 4] = [-26, -29, -36, -46];
/// The same where the rounding of doubles would tell.
const WIDE: [i32; 1] = [-18];
/// Up to this relative change of an answer its change to one side tells its slope, up to the second its changes to both sides.
const FINE: [f64; 2] = [6e-7, 2e-4];

/// Slopes to the two sides of a datum that differ by more than this share belong to a kink, or to a singularity between them.
const UNEVEN: f64 = 0.1;

/// What differences of doubles leave of a condition number of 0.
const NOTHING: f64 = 1e-6;

/// Error of a condition number, as a share of it or of 1, that the rounding of an answer may make.
const ROUNDING: f64 = 1e-5;

/// The road where one datum is changed, if there is one.
struct Changed<T: Real> {
    /// By which share of itself the datum is changed.
    by: f64,
    /// Is it a motion of the same kind?
    alike: bool,
    road: Option<Told<T>>,
}

/// Condition numbers, and for each whether it is not told so.
type Conditions = (Vec<f64>, Vec<bool>);

/// The roads with several sets of data.
type Roads<'r, T> = &'r dyn Fn(&[Set], Scope) -> Vec<Option<Told<T>>>;

/// Condition number of each entry: 0 if no datum moves it, infinite for a zero that some datum moves, or where no changed data have a
/// solution.
pub fn numbers(scene: &Scene, data: &[f64], kind: Kind, entries: &[Entry]) -> Vec<f64> {
    let (mut conds, mut left) = (vec![f64::INFINITY; entries.len()], (0..entries.len()).collect::<Vec<_>>());
    let doubles = |sets: &[Set], asked| eom::roads(scene, sets, asked);
    let digits = |sets: &[Set], asked| {
        sets.iter().map(|data| eom::road_of(scene, data, asked).ok().map(Told::Alone)).collect()
    };
    let of = (scene, data, kind);
    for (steps, in_doubles) in [(&STEPS[..], true), (&WIDE, true), (&STEPS, false)] {
        let entries: Vec<Entry> = left.iter().map(|at| entries[*at]).collect();
        let (found, rounded) = match in_doubles {
            true => quotients::<f64>(of, &entries, &doubles, steps),
            false => quotients::<Dd>(of, &entries, &digits, steps),
        };
        left.iter().zip(found).for_each(|(at, found)| conds[*at] = found);
        left = left.into_iter().zip(rounded).filter_map(|(at, rounded)| rounded.then_some(at)).collect();
        if left.is_empty() {
            break;
        }
    }
    conds
}

/// Condition numbers by difference quotients of these steps in numbers of this type, and for each whether it is not told so: their
/// rounding may tell, or the only step is too wide. Data that follow others are not changed, save for what is told so beside a kink: that
/// needs the slope of each datum.
fn quotients<T: Real>(
    of: (&Scene, &[f64], Kind),
    entries: &[Entry],
    roads: Roads<T>,
    steps: &[i32],
) -> Conditions {
    let mut found = (vec![None; entries.len()], vec![false; entries.len()]);
    let (scene, data, _) = of;
    let all = used(scene, data);
    let mut changed = all.clone();
    let followers = if scene.lead().is_some() { followers(scene, &mut changed) } else { Vec::new() };
    let plans = [(changed, followers), (all, Vec::new())];
    for (used, followers) in &plans {
        search(of, entries, (roads, steps), (used, followers), &mut found);
        if found.0.iter().all(Option::is_some) {
            break;
        }
    }
    let told = |cond: Option<f64>| match cond {
        Some(cond) if cond < NOTHING => 0.0,
        Some(cond) if !cond.is_nan() => cond,
        _ => f64::INFINITY,
    };
    (found.0.into_iter().map(told).collect(), found.1)
}

/// Looks for those condition numbers that are missing, with the data that are changed and what follows from their slopes; what that
/// does not tell stays missing.
fn search<T: Real>(
    (scene, data, kind): (&Scene, &[f64], Kind),
    entries: &[Entry],
    (roads, steps): (Roads<T>, &[i32]),
    (used, followers): (&[usize], &[Vec<f64>]),
    (conds, rounded): &mut (Vec<Option<f64>>, Vec<bool>),
) {
    let mut kinked: Vec<usize> = Vec::new();
    let mut kinks: Vec<Option<f64>> = vec![None; entries.len()];
    // Where each datum is changed, after the data as they are if these are wanted.
    let changed = |by: f64, conds: &[Option<f64>], own: bool| -> Vec<Changed<T>> {
        // What was found needs no further road.
        let missing = entries.iter().zip(conds).filter(|(_, cond)| cond.is_none());
        let asked = Scope::only(missing.map(|(e, _)| e.label.quantity));
        let moves = own.then_some(None).into_iter().chain(used.iter().copied().map(Some));
        let moved = |i: Option<usize>| {
            let mut moved = data.to_vec();
            i.iter().for_each(|i| moved[*i] = data[*i] * (1.0 + by));
            moved
        };
        let sets: Vec<Set> = moves.clone().map(moved).collect();
        let change = |((road, set), i): ((Option<Told<T>>, &Set), Option<usize>)| {
            let by = i.map_or(0.0, |i| set[i] / data[i] - 1.0);
            Changed { by, alike: road.as_ref().is_some_and(|road| road.kind() == kind), road }
        };
        roads(&sets, asked).into_iter().zip(&sets).zip(moves).map(change).collect()
    };
    let mut base = None;
    let mut slopes: Vec<EntrySlope> = Vec::with_capacity(used.len());
    let only = steps.len() == 1;
    'found: for power in steps.iter().copied() {
        let step = pow2(power);
        let mut up = changed(step, conds, base.is_none());
        let base = base.get_or_insert_with(|| up.remove(0));
        let mut down: Vec<Changed<T>> = Vec::new();
        for (both, fine) in [false, true].into_iter().zip(FINE) {
            if both {
                down = changed(-step, conds, false);
            }
            let alike = up.iter().chain(&down).all(|c| c.alike);
            if !both && !alike {
                continue;
            }
            for (at, (cond, entry)) in
                conds.iter_mut().zip(entries).enumerate().filter(|(_, (c, _))| c.is_none())
            {
                let value = |changed: &Changed<T>| changed.road.as_ref()?.value(at, entry.label);
                let at_data = value(base);
                slopes.clear();
                slopes.extend((0..used.len()).map(|i| slope(entry, at_data, (&up[i], down.get(i)), value)));
                let uneven = slopes.iter().any(|s| s.uneven);
                let mut sum: f64 = slopes.iter().map(|s| s.per.abs()).sum();
                if !followers.is_empty() {
                    if uneven {
                        kinked.push(at);
                        *cond = Some(f64::NAN);
                        continue;
                    }
                    sum += followed(scene, entry, followers, &slopes);
                }
                let found = relative(entry, sum);
                let last = both && (found.is_infinite() || steps.last() == Some(&power));
                if found * step <= fine || last {
                    // A kink beside the data is left behind by a smaller step; one at the data is not.
                    if uneven {
                        let kink = *kinks[at].get_or_insert(found);
                        // Seen from the widest step, where rounding tells least, unless the last one sees something else.
                        let same = (found - kink).abs() <= UNEVEN * found;
                        *cond = last.then_some(if same { kink } else { found });
                        rounded[at] = only;
                        continue;
                    }
                    *cond = Some(found);
                    let wide = only && !(alike && found * step <= fine);
                    rounded[at] = T::is_double() && (wide || misses(entry, at_data, step * found.max(1.0)));
                }
            }
            if conds.iter().all(Option::is_some) {
                break 'found;
            }
        }
    }
    kinked.into_iter().for_each(|at| conds[at] = None);
}

/// The slopes, added up, of the data that follow others.
fn followed(scene: &Scene, entry: &Entry, followers: &[Vec<f64>], slopes: &[EntrySlope]) -> f64 {
    let powers = Scales::powers_of(scene, entry.label).map(|p| f64::from(p) * entry.value());
    let known: Vec<f64> = slopes.iter().map(|s| s.per).chain(powers).collect();
    let of = |shares: &Vec<f64>| {
        let terms = shares.iter().zip(&known).filter(|(share, _)| **share != 0.0);
        terms.map(|(share, slope)| share * slope).sum::<f64>().abs()
    };
    followers.iter().map(of).sum()
}

/// Takes up to three data out of those that are used, and tells for each the shares that the slopes of the others have in its own, and
/// an answer as often as it has units of mass, length and time: a change of units changes the answer as it does all data.
fn followers(scene: &Scene, used: &mut Vec<usize>) -> Vec<Vec<f64>> {
    let Some(powers) = scales::powers_of_data(scene, used) else { return Vec::new() };
    let count = used.len();
    let mut units = Equations::<f64>::new(count + 3);
    for unit in 0..3 {
        let row = units.row();
        row.iter_mut().zip(&powers).for_each(|(cell, powers)| *cell = f64::from(powers[unit]));
        row[count + unit] = -1.0;
    }
    let reduced = units.reduce(&[count, count + 1, count + 2]);
    let open = reduced.open();
    let columns: Vec<usize> = open.iter().copied().filter(|j| *j < count).chain(count..count + 3).collect();
    let share = |which: &usize, j| if open.contains(which) { reduced.in_mode(*which, j) } else { 0.0 };
    let follows = (0..count).filter(|j| !open.contains(j));
    let shares = follows.map(|j| columns.iter().map(|which| share(which, j)).collect()).collect();
    *used = columns.into_iter().filter(|j| *j < count).map(|j| used[j]).collect();
    shares
}

/// Is an answer in doubles off its value in 32 digits by what a change of this share would be told by?
fn misses<T: Real>(entry: &Entry, base: Option<T>, change: f64) -> bool {
    let y = entry.value();
    base.is_some_and(|base| y != 0.0 && y.is_finite() && (base.f64() - y).abs() > ROUNDING * change * y.abs())
}

/// The data that the scene uses and that are not 0: a relative change of 0 is none.
fn used(scene: &Scene, data: &[f64]) -> Vec<usize> {
    let mut used = vec![false; data.len()];
    let others = scene.formulas.others.iter().map(|(_, other)| other);
    for scene in others.chain([scene]) {
        admissible::rules(scene, &mut |number, _| {
            for i in scene.data_of(number) {
                if let (Some(used), Some(x)) = (used.get_mut(i), data.get(i)) {
                    *used |= *x != 0.0;
                }
            }
        });
    }
    for given in scene.formulas.givens() {
        used[given.datum] |= data.get(given.datum).is_some_and(|x| *x != 0.0);
    }
    (0..data.len()).filter(|i| used[*i]).collect()
}

/// Change of an entry per relative change of a datum.
struct EntrySlope {
    per: f64,
    /// Do the two sides of the datum differ? The larger one then counts.
    uneven: bool,
}

/// Slope of an entry from its values at the data and at changed data; endless where no changed datum gives one.
fn slope<T: Real>(
    entry: &Entry,
    base: Option<T>,
    (up, down): (&Changed<T>, Option<&Changed<T>>),
    value: impl Fn(&Changed<T>) -> Option<T>,
) -> EntrySlope {
    let y = entry.value();
    let larger = |one: f64, other: f64| if one.abs() < other.abs() { other } else { one };
    let alone = |value: T, by: f64| {
        let change = (value - base.unwrap_or_else(|| T::of(y))).f64();
        let rounded = y == 0.0 && change.abs() <= 2.0 * T::NOISE * entry.scale;
        if rounded { 0.0 } else { change / by }
    };
    let Some(down) = down else {
        let per = value(up).map_or(f64::INFINITY, |above| alone(above, up.by));
        return EntrySlope { per, uneven: false };
    };
    // Of two sides of which one has another kind of motion, that one does not count.
    let above = value(up).filter(|_| up.alike || !down.alike);
    let below = value(down).filter(|_| down.alike || !up.alike);
    let per = |from: T, to: T, by: f64| (to - from).f64() / by;
    match (above, below) {
        // At a zero the two sides of a magnitude are alike: each counts by itself.
        (Some(a), Some(b)) if y != 0.0 => {
            let whole = per(b, a, up.by - down.by);
            // Where the sides differ, as about a singularity, their mean would hide it.
            let sides = base.map(|base| (per(base, a, up.by), per(base, b, down.by)));
            let kink = sides.filter(|(u, d)| (u.abs() - d.abs()).abs() > UNEVEN * whole.abs());
            EntrySlope { per: kink.map_or(whole, |(u, d)| larger(u, d)), uneven: kink.is_some() }
        }
        (above, below) => {
            let sides = [above.map(|a| alone(a, up.by)), below.map(|b| alone(b, down.by))];
            let per = sides.into_iter().flatten().reduce(larger).unwrap_or(f64::INFINITY);
            EntrySlope { per, uneven: false }
        }
    }
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
