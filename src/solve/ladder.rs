//! The ladder of methods: which one a scene needs, what it costs, what it gives away; it sees both roads.
//!
//! A method is on one road and yields the state at the ending event; the road derives its answers from that state. The other
//! road stays in closed form and is the judge: a result that disagrees with it beyond both error estimates is refused.
use crate::num::ode::{Count, FINEST, MOST_STEPS, Trouble};
use crate::num::{Dd, Real, U};
use crate::scene::{Label, Owner, Quantity, Scales, Scene};
use crate::solve::method::{Method, Rung, USUAL_POINTS, USUAL_STEP_S, Way, rounding};
use crate::solve::outcome::{Entry, Refusal, Road, Solved};
use crate::solve::{agree, energy, eom};

/// What was asked of the ladder.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wish {
    /// The method; `None` leaves the choice to the program.
    pub method: Option<Method>,
    /// Relative error that may remain; `None`: rounding.
    pub rtol: Option<f64>,
    /// Time step, s, of a method that has one.
    pub step_s: Option<f64>,
}

/// How the force on the ending coordinate varies along the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Force {
    /// Nothing moves on: only an instant is asked.
    Instant,
    /// Not at all.
    Constant,
    /// Not at all on either side of an event: slipping before it, rolling after it.
    Switched,
    /// Evenly with time.
    OfTime,
    /// In proportion to the way (a spring), in pieces where its cord can go slack.
    Linear,
    /// As the sine of an angle: a pendulum, whose time is an elliptic integral.
    Pendulum,
    /// In a way that leaves no closed form for the time: a pinned body under a couple, or under a spring.
    Irregular,
    /// Likewise, with inertias that change too: bodies joined in the plane. Their balance is not summed by points, and their
    /// accelerations hang on the speed, which velocity Verlet does not allow.
    Joined,
    /// Not at all, though followed like joined bodies: one that rubs turns in its place.
    Rubs,
}

/// What was done, and how well.
#[derive(Debug, Clone, PartialEq)]
pub struct Taken {
    /// The method with its setting.
    pub rung: Rung,
    /// Did the program choose it?
    pub chosen: bool,
    /// The relative error that was asked for.
    pub asked: Option<f64>,
    /// What the scene is like.
    pub force: Force,
    /// What it cost.
    pub count: Count,
    /// What the finer run for the error estimate cost besides.
    pub estimate: Count,
    /// Estimated absolute error of each entry that the method gives; empty for the closed form.
    pub errors: Vec<(Label, f64)>,
    /// The largest of them as a share of its answer.
    pub worst: f64,
}

/// The estimate counts what the difference to the finer run says, two and a half times.
const SAFETY: f64 = 2.5;
/// A run whose estimate is a larger share of an answer than this has not settled.
const UNSETTLED: f64 = 0.1;
/// A quadrature without a tolerance that changes by more than this share when set finer has not come to rounding.
const COARSEST_ROUNDING: f64 = 1e-12;
/// The closed form evaluates the forces once.
const ONCE: Count = Count { evaluations: 1, steps: 0, refused: 0 };
/// The time of the motion.
pub const TIME: Label = Label { quantity: Quantity::T, of: Owner::Scene };
/// Numbers of points that are tried for a tolerance.
const POINTS: [usize; 12] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];

/// How the force of a scene varies.
pub fn force(scene: &Scene) -> Force {
    if scene.is_still() {
        Force::Instant
    } else if scene.is_pendulum() {
        Force::Pendulum
    } else if scene.pinned().is_some() {
        Force::Irregular
    } else if scene.lead().is_some() {
        if scene.spins_in_place() { Force::Rubs } else { Force::Joined }
    } else if scene.goes_in_phases() {
        Force::Switched
    } else if !scene.growths.is_empty() {
        Force::OfTime
    } else if scene.is_sprung() {
        Force::Linear
    } else {
        Force::Constant
    }
}

/// One road by one rung, with its cost. `asked` says which quantities are wanted besides the state at the end.
///
/// Errors: those of the road, and of the method.
pub fn road<P: Real>(
    scene: &Scene,
    data: &[f64],
    rung: Rung,
    asked: &dyn Fn(Quantity) -> bool,
) -> Result<(Road<P>, Count), Refusal> {
    match rung {
        Rung::Closed | Rung::Doubles => Ok((energy::road(scene, data)?, ONCE)),
        Rung::Gauss(points) => energy::road_by(scene, data, Some(points)),
        Rung::Settled => energy::road_by(scene, data, None),
        Rung::Adaptive(..) | Rung::Fixed(..) => eom::road_by(scene, data, rung, asked),
    }
}

/// Values of some labels on one road by one rung, computed in these units and rounded to doubles, SI; NaN where it does not give
/// them.
fn values(
    scene: &Scene,
    data: &[f64],
    scales: Scales,
    rung: Rung,
    labels: &[Label],
) -> Result<(Vec<f64>, Count), Refusal> {
    fn of<P: Real>(road: &Road<P>, scene: &Scene, scales: Scales, labels: &[Label]) -> Vec<f64> {
        let value = |l: &Label| road.get(*l).map_or(f64::NAN, |s| s.value.f64());
        labels.iter().map(|l| scales.said(scene, *l, value(l))).collect()
    }
    let asked = |q: Quantity| labels.iter().any(|l| l.quantity == q);
    let rung = match rung {
        Rung::Fixed(method, step_s) => Rung::Fixed(method, scales.own("s", step_s)),
        other => other,
    };
    agree::in_scales(scales, scene, data, |scene, data| {
        if rung == Rung::Doubles {
            let (road, count) = road::<f64>(scene, data, rung, &asked)?;
            Ok((of(&road, scene, scales, labels), count))
        } else {
            let (road, count) = road::<Dd>(scene, data, rung, &asked)?;
            Ok((of(&road, scene, scales, labels), count))
        }
    })
}

/// Solves a scene by the method asked for, or by the cheapest that meets the tolerance.
///
/// Where the forces are constant or linear, and for a pendulum, the closed form is the cheapest at any tolerance; where there
/// is none, a quadrature of as few points as the tolerance allows, or one that settles to rounding. A named method gives the answers
/// of its road; the other road judges them. Errors: those of [`agree::solve`]; a method that misses its event, does not settle,
/// contradicts the judge, or does not apply.
pub fn solve(scene: &Scene, data: &[f64], wish: &Wish) -> Result<(Solved, Taken), Refusal> {
    let mut solved = agree::solve(scene, data)?;
    let force = force(scene);
    let joined = matches!(force, Force::Joined | Force::Rubs);
    let irregular = joined || force == Force::Irregular;
    let method = wish.method.unwrap_or(if irregular { Method::Gauss } else { Method::Closed });
    if irregular && method == Method::Closed || joined && method == Method::Verlet {
        return Err(Refusal::NoMethod { method });
    }
    let mut taken = Taken {
        rung: Rung::Closed,
        chosen: wish.method.is_none(),
        asked: wish.rtol,
        force,
        count: ONCE,
        estimate: Count::default(),
        errors: Vec::new(),
        worst: 0.0,
    };
    let Some(way) = method.way() else {
        // Doubles are cheaper, where they are good enough.
        if let (None, Some(rtol), true) = (wish.method, wish.rtol, force != Force::Instant)
            && let Ok(t) = judged(scene, data, Way::Energy, Rung::Doubles, &solved)
            && t.worst <= rtol
        {
            taken = put(&mut solved, taken, Way::Energy, Rung::Doubles, t);
        }
        return Ok((solved, taken));
    };
    if matches!(force, Force::Instant | Force::OfTime) {
        return Err(Refusal::NoMethod { method });
    }
    let step = wish.step_s.unwrap_or(USUAL_STEP_S);
    let candidates: Vec<Rung> = match (method, wish.rtol) {
        (Method::Gauss, _) if joined => vec![Rung::Settled],
        (Method::Gauss, Some(_)) => {
            let settled = irregular.then_some(Rung::Settled);
            POINTS.iter().map(|n| Rung::Gauss(*n)).chain(settled).collect()
        }
        (Method::Gauss, None) if irregular => vec![Rung::Settled],
        (Method::Gauss, None) => {
            POINTS.iter().filter(|n| **n >= USUAL_POINTS).map(|n| Rung::Gauss(*n)).collect()
        }
        (Method::Dopri5 | Method::Dop853, rtol) => {
            vec![Rung::Adaptive(method, rtol.unwrap_or(FINEST).max(FINEST), 1.0)]
        }
        _ => vec![Rung::Fixed(method, step)],
    };
    let last = candidates.len() - 1;
    for (i, rung) in candidates.into_iter().enumerate() {
        let tried = judged(scene, data, way, rung, &solved);
        let good = match (&tried, wish.rtol) {
            (Ok(t), Some(rtol)) => t.worst <= rtol.max(FINEST),
            (Ok(t), None) => method != Method::Gauss || t.unsettled == 0.0,
            (Err(_), _) => false,
        };
        if good || i == last {
            let tried = tried?;
            let asked = wish.rtol.map_or(COARSEST_ROUNDING, |rtol| rtol.max(FINEST));
            if let (false, Rung::Gauss(points)) = (good, rung)
                && tried.unsettled > asked
            {
                return Err(Refusal::Unmet { method, points, error: tried.unsettled, asked });
            }
            taken = put(&mut solved, taken, way, rung, tried);
            break;
        }
    }
    Ok((solved, taken))
}

/// Puts what a rung gave in the place of its road's closed values.
fn put(solved: &mut Solved, taken: Taken, way: Way, rung: Rung, found: Judged) -> Taken {
    let mut errors = Vec::with_capacity(found.values.len());
    for (entry, (value, error)) in solved.entries.iter_mut().zip(found.values) {
        match way {
            Way::Motion => entry.eom = Some(value),
            Way::Energy => entry.energy = Some(value),
        }
        errors.push((entry.label, error));
    }
    Taken { rung, count: found.count, estimate: found.estimate, worst: found.worst, errors, ..taken }
}

/// A rung with its error estimate, as the other road finds it right.
struct Judged {
    /// Value and estimated error of each entry.
    values: Vec<(f64, f64)>,
    count: Count,
    estimate: Count,
    worst: f64,
    /// The largest change to a finer run that is more than rounding, as a share of its answer.
    unsettled: f64,
}

/// A zero, of terms that cancel for some data or for all: steps leave rounding of its terms in its place.
fn vanishes(entry: &Entry) -> bool {
    entry.cond.is_infinite() || entry.value() == 0.0
}

/// What rounding of the data and of the state may do to an answer, absolutely.
fn rounding_of(entry: &Entry, value: f64, share: f64) -> f64 {
    let sensitivity = if vanishes(entry) { entry.scale } else { entry.cond.max(1.0) * value.abs() };
    share * sensitivity
}

#[expect(clippy::float_cmp, reason = "equal bits agree, infinities among them")]
fn judged(scene: &Scene, data: &[f64], way: Way, rung: Rung, solved: &Solved) -> Result<Judged, Refusal> {
    let method = rung.method();
    let labels: Vec<Label> = solved.entries.iter().map(|e| e.label).collect();
    // The run and the two finer ones together.
    if let (Rung::Fixed(_, step), Some(time)) = (rung, solved.get(TIME).map(Entry::value)) {
        let steps = (1.0 + 2.0 + 3.0) * time / step;
        if steps > MOST_STEPS as f64 {
            return Err(Refusal::Trouble { method, trouble: Trouble::StepTooShort { step, steps } });
        }
    }
    let (coarse, count) = values(scene, data, solved.scales, rung, &labels)?;
    let mut estimate = Count::default();
    // Two finer runs: with one, an error that happens to be the same on both would hide.
    let mut finer: Vec<(f64, Vec<f64>)> = Vec::with_capacity(2);
    for by in [2, 3].into_iter().filter(|by| rung.finer(*by) != rung) {
        let (fine, count) = values(scene, data, solved.scales, rung.finer(by), &labels)?;
        estimate.evaluations += count.evaluations;
        estimate.steps += count.steps;
        finer.push((rung.extrapolation(by), fine));
    }
    let mut found =
        Judged { values: Vec::with_capacity(labels.len()), count, estimate, worst: 0.0, unsettled: 0.0 };
    for (i, (entry, value)) in solved.entries.iter().zip(coarse).enumerate() {
        let label = entry.label;
        let judge = match way {
            Way::Motion => entry.energy,
            Way::Energy => entry.eom,
        };
        let judge = judge.unwrap_or(f64::NAN);
        if value == judge && finer.iter().all(|(_, fine)| fine[i] == value) {
            // Nothing depends on the method here, or nothing is lost.
            let error = rounding_of(entry, value, 8.0 * U);
            found.values.push((value, if error.is_finite() { error } else { 0.0 }));
            if error.is_finite() && value.abs() > 0.0 {
                found.worst = found.worst.max(error / value.abs());
            }
            continue;
        }
        let size = value.abs().max(judge.abs()).max(if vanishes(entry) { entry.scale } else { 0.0 });
        let changes = finer.iter().map(|(factor, fine)| (factor * (value - fine[i]).abs(), fine[i]));
        let (change, finer) =
            changes.fold((0.0f64, value), |most, c| if most.0.is_nan() || c.0 <= most.0 { most } else { c });
        let change = SAFETY * change;
        let floor = rounding_of(entry, value.abs().max(judge.abs()), rounding(rung, count));
        let error = change + floor;
        // What the data themselves do not determine need not settle.
        if !error.is_finite() || change > UNSETTLED * size && change > floor {
            return Err(Refusal::Unsteady { method, label, value, finer });
        }
        let allowed = error + rounding_of(entry, judge, 8.0 * U);
        let apart = (value - judge).abs();
        if apart.is_nan() || apart > allowed {
            return Err(Refusal::Contradicts { method, label, value, judge, allowed });
        }
        if change > floor {
            found.unsettled = found.unsettled.max(change / size);
        }
        found.worst = found.worst.max(error / size);
        found.values.push((value, error));
    }
    Ok(found)
}

/// One rung of a study.
#[derive(Debug, Clone)]
pub struct Row {
    /// The method with its setting.
    pub rung: Rung,
    /// Would the program choose it?
    pub auto: bool,
    /// What came out, or why nothing did.
    pub found: Result<Measured, Refusal>,
}

/// What a rung gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// True relative error of each label; absolute where the reference is 0.
    pub errors: Vec<f64>,
    /// The largest.
    pub worst: f64,
    /// What it cost.
    pub count: Count,
}

/// Every method that applies, against a reference in double-double.
#[derive(Debug, Clone)]
pub struct Study {
    /// How the force varies.
    pub force: Force,
    /// The answers that are compared.
    pub labels: Vec<Label>,
    /// The reference.
    pub reference: Vec<Dd>,
    /// The rungs, method by method, from coarse to fine.
    pub rows: Vec<Row>,
}

/// Steps that users choose, s, each with the name under which it goes.
pub const STEPS_S: [(f64, &str); 6] = [
    (0.1, "0.1 s"),
    (1.0 / 30.0, "1/30 s"),
    (1.0 / 60.0, "1/60 s"),
    (1.0 / 240.0, "1/240 s"),
    (1e-3, "1 ms"),
    (1e-4, "0.1 ms"),
];

/// The rungs of a study of a motion that takes this time.
fn rungs(force: Force, time_s: Option<f64>) -> Vec<Rung> {
    let usual =
        |t: f64| STEPS_S.iter().map(|s| s.0).filter(|h| t / h > 2.0 && t / h < 1e6).collect::<Vec<_>>();
    let mut steps = usual(time_s.unwrap_or(1.0));
    if let (true, Some(t)) = (steps.len() < 4, time_s) {
        // A motion of another time scale: from a quarter of it on.
        steps = (1..=6)
            .scan(t, |h, _| {
                *h *= 0.25;
                Some(*h)
            })
            .collect();
    }
    let joined = matches!(force, Force::Joined | Force::Rubs);
    let mut rungs = if joined || force == Force::Irregular {
        vec![Rung::Settled]
    } else {
        vec![Rung::Doubles, Rung::Closed]
    };
    for method in Method::ALL.iter().copied() {
        match method {
            Method::Closed => {}
            Method::Gauss | Method::Verlet if joined => {}
            // Two modes share the work while it slips: there is no one force to sum over one way.
            Method::Gauss if force == Force::Switched => {}
            Method::Gauss => rungs.extend([1, 2, 4, 8, 16, 24].map(Rung::Gauss)),
            Method::Dopri5 | Method::Dop853 => {
                let tolerances = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];
                rungs.extend(tolerances.map(|rtol| Rung::Adaptive(method, rtol, 1.0)));
            }
            Method::Euler | Method::Verlet | Method::Rk4 => {
                rungs.extend(steps.iter().map(|h| Rung::Fixed(method, *h)));
            }
        }
    }
    rungs
}

/// Relative error of a value, absolute where the reference is 0; none where no double is nearer.
#[expect(clippy::float_cmp, reason = "the nearest double has no error that a double could mend")]
fn error(value: f64, reference: Dd) -> f64 {
    if value == reference.hi {
        return 0.0;
    }
    let miss = (Dd::new(value) - reference).abs();
    if !reference.hi.is_finite() {
        // An infinite answer is right or not.
        return if value.is_infinite() && value.signum() * reference.hi.signum() > 0.0 {
            0.0
        } else {
            f64::NAN
        };
    }
    if reference.hi == 0.0 { miss.hi } else { (miss / reference.abs()).hi }
}

/// Runs every method that applies, coarse to fine, against the closed form in double-double.
///
/// Errors: those of [`agree::answers`], and [`Refusal::NoMethod`] where nothing moves.
pub fn study(scene: &Scene, data: &[f64], labels: &[Label]) -> Result<Study, Refusal> {
    let solved = agree::answers(scene, data)?;
    let force = force(scene);
    if matches!(force, Force::Instant | Force::OfTime) {
        return Err(Refusal::NoMethod { method: Method::Dop853 });
    }
    let labels: Vec<Label> = labels.iter().copied().filter(|l| solved.get(*l).is_some()).collect();
    let road: Road<Dd> = eom::road(scene, data)?;
    let reference: Vec<Dd> =
        labels.iter().map(|l| road.get(*l).map_or(Dd::new(f64::NAN), |s| s.value)).collect();
    let time = solved.get(TIME).map(Entry::value);
    let searched = scene.formulas.found.is_some();
    let applies = |rung: &Rung| !searched || matches!(rung, Rung::Doubles | Rung::Closed | Rung::Settled);
    let rungs = rungs(force, time.filter(|t| t.is_finite() && *t > 0.0)).into_iter().filter(applies);
    let rows = rungs.map(|rung| {
        let found = values(scene, data, Scales::SI, rung, &labels).map(|(values, count)| {
            let errors: Vec<f64> = values.iter().zip(&reference).map(|(v, r)| error(*v, *r)).collect();
            let worst = errors.iter().copied().fold(0.0, |w: f64, e| if e > w || e.is_nan() { e } else { w });
            Measured { errors, worst, count }
        });
        Row { rung, auto: matches!(rung, Rung::Closed | Rung::Settled), found }
    });
    let rows = rows.collect();
    Ok(Study { force, labels, reference, rows })
}

/// One whole solve of a rung, for a clock: the values of the labels.
///
/// Errors: those of the road and of the method.
pub fn once(scene: &Scene, data: &[f64], rung: Rung, labels: &[Label]) -> Result<Vec<f64>, Refusal> {
    Ok(values(scene, data, Scales::SI, rung, labels)?.0)
}

/// Errors below this are rounding: no method is better than another there.
pub const ROUNDING: f64 = 4.0 * U;

/// Which of these pairs of cost and error are beaten by no other: none is as cheap and as right, and better in one. Costs
/// count as equal within this share (clocks are not exact). What is not finite is beaten.
pub fn pareto(pairs: &[(f64, f64)], slack: f64) -> Vec<bool> {
    let clean: Vec<(f64, f64)> =
        pairs.iter().map(|(c, e)| (*c, if *e < ROUNDING { ROUNDING } else { *e })).collect();
    let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    let beaten = |p: &(f64, f64)| {
        clean.iter().filter(|q| finite(q)).any(|q| {
            let (cheaper, as_cheap) = (q.0 * (1.0 + slack) < p.0, q.0 <= p.0 * (1.0 + slack));
            cheaper && q.1 <= p.1 || as_cheap && q.1 < p.1
        })
    };
    clean.iter().map(|p| finite(p) && !beaten(p)).collect()
}
