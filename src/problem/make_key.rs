//! A solved variant to its key: value, accepted half-width, both roads.
use crate::bank::expression::Name;
use crate::bank::{Problem, Question};
use crate::key::{Answer, Follow, Given, KeyEntry, ProblemKey, WrongValue};
use crate::problem::make::Variant;
use crate::scene::{Label, Owner, Quantity, Scene, Slope};
use crate::solve::outcome::{Entry, Solved};

/// Absolute tolerance of quantities that may vanish, as a share of the scale of their terms: a thousandth of the
/// largest force is below what three figures of the terms can tell.
pub const VANISHING_SHARE: f64 = 1e-3;

const SLOPED: &[&str] = &["up", "down"];
const LEVEL: &[&str] = &["forward", "back"];
const YES_NO: &[&str] = &["yes", "no"];

/// The lists of words of which a sheet asks for one. No word stands on two of them, and none that no draw can have: what stays
/// at rest is never drawn.
pub const LISTS: [&[&str]; 3] = [SLOPED, LEVEL, YES_NO];

/// The key of a variant: one entry for each question of the problem.
///
/// Every question of a drawn variant has an answer; in a replayed one, a question without an answer has a key of NaN,
/// which no answer meets.
pub fn key(problem: &Problem, variant: &Variant) -> ProblemKey {
    let scene = &problem.cases[variant.case].scene;
    let parts = problem
        .questions
        .iter()
        .map(|question| {
            let mut entry = entry(question, scene, variant);
            let magnitude = is_magnitude(question.label.quantity);
            entry.wrong.extend(variant.wrong.iter().filter(|w| w.label == question.label).map(|w| {
                WrongValue {
                    method: u16::try_from(w.mistake).unwrap_or(u16::MAX),
                    value: if magnitude { w.value.abs() } else { w.value },
                }
            }));
            entry
        })
        .collect();
    let (follows, extras) = follows(problem);
    let quantity = |label: &Label| variant.solved.get(*label).map_or(f64::NAN, Entry::value);
    let known = variant.data.iter().copied().chain(extras.iter().map(quantity)).collect();
    let printed = variant.values.iter().flatten().filter_map(|v| v.text().parse::<f64>().ok());
    let given = variant.data.iter().copied().chain(printed).collect();
    let methods = problem.methods.clone();
    ProblemKey { id: problem.id.clone(), parts, methods, follows: follows.into(), known, given }
}

/// The relations between parts, with parts for their quantities, and the quantities that they need besides.
fn follows(problem: &Problem) -> (Vec<Follow>, Vec<Label>) {
    let mut extras: Vec<Label> = Vec::new();
    let follows = problem.follows.iter().map(|follow| {
        let by = follow.by.formula().map(&mut |name| match name {
            Name::Datum(i, factor) => Given::Known(i, factor),
            Name::Quantity(label) => {
                let part = follow.from.iter().find(|q| problem.questions[**q].label == label);
                match part {
                    Some(part) => Given::Part(*part),
                    None => {
                        let at = extras.iter().position(|l| *l == label).unwrap_or_else(|| {
                            extras.push(label);
                            extras.len() - 1
                        });
                        Given::Known(problem.data.len() + at, 1.0)
                    }
                }
            }
        });
        Follow { part: follow.question, from: follow.from.clone(), by }
    });
    (follows.collect(), extras)
}

fn entry(question: &Question, scene: &Scene, variant: &Variant) -> KeyEntry {
    let quantity = question.label.quantity;
    let mut key = KeyEntry {
        part: question.id.clone(),
        answer: Answer::Word { right: "", offered: offered(quantity, scene) },
        unit: question.unit.clone(),
        unit_required: question.unit_required,
        points: question.points,
        eom: None,
        energy: None,
        gap: None,
        cond: None,
        bound: None,
        wrong: Vec::new(),
    };
    if quantity.is_word() {
        let right = variant.solved.word(question.label).map_or("", |w| w.text());
        key.answer = Answer::Word { right, offered: offered(quantity, scene) };
        return key;
    }
    let (value, scale) = match variant.solved.get(question.label) {
        Some(e) => {
            key.eom = e.eom;
            key.energy = e.energy;
            key.gap = e.gap();
            key.cond = Some(e.cond);
            key.bound = e.bound;
            (e.value(), e.scale)
        }
        None => (f64::NAN, 0.0),
    };
    let words = words_sign(scene, question.label);
    key.answer = Answer::Number {
        value,
        half_width: half_width(question, value, scale, key.cond.unwrap_or(f64::NAN)),
        directed: quantity.is_directed() && words,
        // Where words give no sign, `down` beside a number that is positive down must not spoil it.
        magnitude: is_magnitude(quantity) || (quantity.is_directed() && !words && value >= 0.0),
    };
    key
}

/// The accepted half-width, SI: the larger of the relative and the absolute tolerance.
pub fn half_width(question: &Question, value: f64, scale: f64, cond: f64) -> f64 {
    let absolute = question.absolute.unwrap_or_else(|| {
        if may_vanish(question.label.quantity) && scale.is_finite() { VANISHING_SHARE * scale } else { 0.0 }
    });
    (question.relative.at(cond) * value.abs()).max(absolute)
}

/// The relative tolerance of each question for this solution, as the sheet prints it; that of a word means nothing.
pub fn within(problem: &Problem, solved: &Solved) -> Vec<f64> {
    let cond = |q: &Question| solved.get(q.label).map_or(f64::NAN, |e| e.cond);
    problem.questions.iter().map(|q| q.relative.at(cond(q))).collect()
}

/// The proved bound of the error of a key is to be below this share of the accepted half-width.
pub const PROVED_SHARE: f64 = 1e-3;

/// The first numeric answer whose enclosure is not narrow beside its tolerance: index of the question, and the bound as a share
/// of the half-width. Quantities that are not enclosed at all do not count.
pub fn wide(problem: &Problem, solved: &Solved) -> Option<(usize, f64)> {
    let shares = problem.questions.iter().enumerate().filter_map(|(i, question)| {
        let entry = solved.get(question.label)?;
        let half_width = half_width(question, entry.value(), entry.scale, entry.cond);
        Some((i, entry.bound?, half_width))
    });
    let mut wide = shares.filter(|(_, bound, half_width)| !bound.le(&(PROVED_SHARE * half_width)));
    wide.next().map(|(i, bound, half_width)| (i, bound / half_width))
}

/// Quantities that can be 0 although the terms that make them up are not.
pub const fn may_vanish(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::Friction
            | Quantity::FrictionIfRolled
            | Quantity::SlipDistance
            | Quantity::SlipSpeed
            | Quantity::Displacement
            | Quantity::ARolling
            | Quantity::A
            | Quantity::Alpha
            | Quantity::Rise
            | Quantity::PinRadial
            | Quantity::PinTangential
            | Quantity::SpringForce
            | Quantity::XG
            | Quantity::YG
    )
}

/// May a word give the sign? Friction is positive up the incline in every scene; an acceleration or a displacement is
/// positive forward, so not where positive is down: there `up` would mean a minus.
pub fn words_sign(scene: &Scene, label: Label) -> bool {
    let body = match label.of {
        Owner::Body(b) => Some(b),
        _ => scene.bare_body(),
    };
    !matches!(label.quantity, Quantity::A | Quantity::ARolling | Quantity::Displacement)
        || body.and_then(|b| scene.bodies.get(b)).and_then(|b| b.line).is_none_or(|line| line.forward_up)
}

/// Is it a number that is never negative, whichever way the scene goes?
pub const fn is_magnitude(quantity: Quantity) -> bool {
    !matches!(
        quantity,
        Quantity::Friction
            | Quantity::FrictionIfRolled
            | Quantity::A
            | Quantity::ARolling
            | Quantity::Displacement
            | Quantity::Alpha
            | Quantity::Rise
            | Quantity::PinRadial
            | Quantity::PinTangential
            | Quantity::SpringForce
            | Quantity::XG
            | Quantity::YG
            | Quantity::WorkPull
            | Quantity::PowerPull
            | Quantity::Tension
    )
}

/// The list of words of which one answers a question in words.
pub fn offered(quantity: Quantity, scene: &Scene) -> &'static [&'static str] {
    if quantity == Quantity::Rolls {
        return YES_NO;
    }
    let body = scene.ending_coordinate().body;
    match scene.bodies.get(body).and_then(|b| b.line) {
        Some(line) if line.slope != Slope::Level => SLOPED,
        _ => LEVEL,
    }
}
