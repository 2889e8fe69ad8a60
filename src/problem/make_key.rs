//! A solved variant to its key: value, accepted half-width, both roads.
use crate::bank::expression::Name;
use crate::bank::{Problem, Question};
use crate::key::{Answer, Given, KeyEntry, KeyFollow, ProblemKey, WordSigns, WrongValue};
use crate::num::trig;
use crate::problem::variant::Variant;
use crate::scene::{Body, JointKind, Label, Owner, Quantity, Scene, Slope, Tie};
use crate::solve::outcome::{Motion, Solved};
use std::sync::Arc;

/// Absolute tolerance of quantities that may vanish, as a share of the scale of their terms: a thousandth of the
/// largest force is below what three figures of the terms can tell.
const VANISHING_SHARE: f64 = 1e-3;

/// A list of words of which a sheet asks for one.
pub type List = &'static [&'static str];

const YES_NO: List = &["yes", "no"];

/// The words offered for a direction on a slope, by which of them can come out: both ways; both ways or rest; up or rest; down
/// or rest.
const SLOPED: [List; 4] = [&["up", "down"], &["up", "down", "stays"], &["up", "stays"], &["down", "stays"]];
/// The same on the level.
const LEVEL: [List; 4] =
    [&["forward", "back"], &["forward", "back", "stays"], &["forward", "stays"], &["back", "stays"]];

/// All words that a key can have.
pub const WORDS: [&str; 7] = ["up", "down", "forward", "back", "stays", "yes", "no"];

/// The key of a variant: one entry for each question of the problem.
///
/// Every question of a drawn variant has an answer; in a replayed one, a question without an answer has a key of NaN,
/// which no answer meets.
pub fn key(problem: &Problem, variant: &Variant) -> ProblemKey {
    KeyFrame::new(problem).key(variant)
}

/// What the keys of all variants of a problem have in common.
#[derive(Debug)]
pub struct KeyFrame<'p> {
    problem: &'p Problem,
    follows: Arc<[KeyFollow]>,
    /// The quantities that the relations need besides the data and the parts.
    extras: Vec<Label>,
}

impl<'p> KeyFrame<'p> {
    /// Prepares the keys of a problem: its relations between parts, with parts for their quantities.
    pub fn new(problem: &'p Problem) -> Self {
        let mut extras: Vec<Label> = Vec::new();
        let follows = problem.follows.iter().map(|follow| {
            let by = follow.by.formula().map(&mut |name| match name {
                Name::Datum(i, degrees) => {
                    Given::Known(i, if degrees { trig::radians_per_degree() } else { 1.0 })
                }
                // No relation names what follows.
                Name::Next(_) => Given::Known(usize::MAX, 1.0),
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
            KeyFollow { part: follow.question, from: follow.from.clone(), by }
        });
        Self { problem, follows: follows.collect(), extras }
    }

    /// The key of a variant, as [`key`] gives it.
    pub fn key(&self, variant: &Variant) -> ProblemKey {
        let problem = self.problem;
        let scene = &problem.cases[variant.case].scene;
        let parts = problem.questions.iter().map(|question| {
            let mut entry = entry(problem, question, scene, variant);
            entry.wrong.extend(variant.wrong.iter().filter(|w| w.label == question.label).map(|w| {
                WrongValue {
                    method: u16::try_from(w.mistake).unwrap_or(u16::MAX),
                    value: scene.as_asked(w.label, w.value),
                }
            }));
            entry
        });
        let quantity = |label: &Label| variant.solved.asked(scene, *label);
        let known = variant.data.iter().copied().chain(self.extras.iter().map(quantity)).collect();
        let printed = variant.values.iter().flatten().map(|v| v.f64());
        let given = variant.data.iter().copied().chain(printed).collect();
        let (methods, follows) = (problem.methods.clone(), self.follows.clone());
        let (id, code) = (problem.id.clone(), String::new());
        ProblemKey { id, code, parts: parts.collect(), methods, follows, known, given }
    }
}

fn entry(problem: &Problem, question: &Question, scene: &Scene, variant: &Variant) -> KeyEntry {
    let quantity = question.label.quantity;
    let mut key = KeyEntry {
        part: question.id.clone(),
        answer: Answer::Word { right: "", offered: &[] },
        unit: question.unit.clone(),
        unit_required: question.unit_required,
        points: question.points,
        eom: None,
        energy: None,
        gap: None,
        cond: None,
        bound: None,
        wrong: Vec::new(),
        code: None,
    };
    if quantity.is_word() {
        let right = variant.solved.word(question.label).map_or("", |w| w.as_str());
        key.answer = Answer::Word { right, offered: offered(problem, quantity, scene) };
        return key;
    }
    let (value, scale) = match variant.solved.get(question.label) {
        Some(e) => {
            key.eom = e.eom.map(|value| Scene::as_told(e.label, value));
            key.energy = e.energy.map(|value| Scene::as_told(e.label, value));
            key.gap = e.gap();
            // A page works out none.
            key.cond = Some(e.cond).filter(|cond| !cond.is_nan());
            key.bound = e.bound;
            (scene.as_asked(question.label, e.value()), e.scale)
        }
        None => (f64::NAN, 0.0),
    };
    key.answer = Answer::Number {
        value,
        half_width: half_width(question, value, scale, key.cond.unwrap_or(f64::NAN)),
        directed: quantity.is_directed(),
        magnitude: scene.is_magnitude(question.label),
        words: word_signs(scene, question.label),
        cyclic: quantity == Quantity::PinAngle,
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

/// Quantities that can be 0 although the terms that make them up are not: those with a sign, and what slips.
const fn may_vanish(quantity: Quantity) -> bool {
    match quantity {
        Quantity::SlipDistance | Quantity::SlipSpeed => true,
        Quantity::WorkPull
        | Quantity::PowerPull
        | Quantity::WorkCouple
        | Quantity::PowerCouple
        | Quantity::Tension => false,
        other => !other.is_magnitude(),
    }
}

/// The words that give the sign of a quantity of this label, the positive one first; `None` of a magnitude, and where none tells it.
pub fn sense_words(scene: &Scene, label: Label) -> Option<[&'static str; 2]> {
    let signs = word_signs(scene, label)?;
    // In the plane nothing goes forward.
    let on_a_line = label.quantity.is_directed() && !matches!(label.of, Owner::Joint(_));
    let forward = if on_a_line { signs.forward } else { 0 };
    let senses = [
        (signs.up, ["up", "down"]),
        (forward, ["forward", "back"]),
        (signs.right, ["right", "left"]),
        (signs.counter_clockwise, ["counter_clockwise", "clockwise"]),
    ];
    let (sign, [one, other]) = senses.into_iter().find(|(sign, _)| *sign != 0)?;
    Some(if sign > 0 { [one, other] } else { [other, one] })
}

/// What words of direction say of the sign of a quantity; `None` where they are passed over: of a magnitude, and of a tension,
/// whose sign is no direction.
pub fn word_signs(scene: &Scene, label: Label) -> Option<WordSigns> {
    use Quantity as Q;
    let nothing = WordSigns::default();
    let (up, right) = (WordSigns { up: 1, ..nothing }, WordSigns { right: 1, ..nothing });
    let forward = WordSigns { forward: 1, ..nothing };
    let owner = scene.owner(label);
    let of = match owner {
        Owner::Body(b) => Some(b),
        Owner::Strut(s) => scene.struts.get(s).map(|s| s.at.body),
        _ => scene.bare_body().or(scene.lead()),
    };
    let joint = match owner {
        Owner::Joint(j) => scene.joints.get(j).map(|joint| joint.kind),
        _ => None,
    };
    if scene.is_magnitude(label) || label.quantity == Q::Tension {
        return None;
    }
    let rubs = matches!(label.quantity, Q::Friction | Q::FrictionIfRolled);
    Some(match (label.quantity, joint) {
        (Q::A | Q::ARolling | Q::Displacement | Q::Impulse | Q::Friction | Q::FrictionIfRolled, None) => {
            of.map_or(forward, |b| along(scene, b, rubs))
        }
        (Q::Friction | Q::FrictionImpulse, Some(kind)) if kind.is_level(scene) => {
            WordSigns { right: 1, ..forward }
        }
        (Q::Friction | Q::FrictionImpulse, Some(_)) => up,
        // To the left of the guide.
        (Q::Normal | Q::Impulse, Some(JointKind::Guide { line, .. })) => {
            line.fixed_deg(&scene.bodies, false).map_or(nothing, |along| {
                let sign = |angle: f64| match angle.rem_euclid(360.0) {
                    at if at % 180.0 == 0.0 => 0,
                    at => sign(at < 180.0),
                };
                WordSigns { up: sign(along + 90.0), right: sign(along + 180.0), ..nothing }
            })
        }
        (Q::VX | Q::AX | Q::ImpulseX | Q::PinX | Q::XG, _) => right,
        (Q::VY | Q::AY | Q::ImpulseY | Q::PinY | Q::YG | Q::Rise, _) => up,
        (Q::PinAngle, _) => WordSigns { up: 1, counter_clockwise: 1, ..nothing },
        (Q::PinTangential, _) => forward,
        (Q::Moment, Some(_)) => WordSigns { counter_clockwise: 1, ..nothing },
        (Q::Alpha | Q::Moment | Q::Drive | Q::Angle, _) => {
            WordSigns { counter_clockwise: of.map_or(0, |b| turn(scene, b)), ..nothing }
        }
        _ => nothing,
    })
}

const fn sign(positive: bool) -> i8 {
    if positive { 1 } else { -1 }
}

/// What words say of the sign of what acts along the line of a body: positive up the incline if it rubs, else forward.
fn along(scene: &Scene, body: usize, rubs: bool) -> WordSigns {
    let line = scene.bodies[body].line;
    let ahead = sign(line.is_none_or(|line| line.forward_up));
    let (up, forward) = if rubs { (1, ahead) } else { (ahead, 1) };
    let nothing = WordSigns { forward, ..WordSigns::default() };
    match line {
        Some(line) if line.slope != Slope::Level => WordSigns { up, ..nothing },
        Some(_) => WordSigns { right: if scene.is_turned_round(body) { -up } else { up }, ..nothing },
        None => nothing,
    }
}

/// 1 where a positive turn of a body is counter-clockwise, -1 where it is clockwise.
fn turn(scene: &Scene, body: usize) -> i8 {
    let Body { planar, line, .. } = &scene.bodies[body];
    match (planar, line) {
        (Some(planar), _) => sign(!planar.clockwise),
        (_, Some(line)) => sign(line.surface && line.forward_up == scene.is_turned_round(body)),
        _ => -1,
    }
}

/// The phrase that tells which turn is forward, where the direction of what only turns is asked.
pub fn turns_forward(scene: &Scene, label: Label) -> Option<&'static str> {
    let ending = scene.ending_coordinate().body;
    let body = scene.bodies.get(ending)?;
    let turns = label.quantity == Quantity::Direction && body.line.is_none() && body.planar.is_none();
    turns.then(|| if turn(scene, ending) > 0 { "sheet.forward_left" } else { "sheet.forward_right" })
}

/// The list of words of which one answers a question in words, on the sheet of this scene.
///
/// It follows from the regimes that the problem declares, over all cases whose words are of the same kind: a list that differed
/// from case to case would tell the answer. A single word would tell it, too: then the pair stays, and lint finds it.
pub fn offered(problem: &Problem, quantity: Quantity, scene: &Scene) -> List {
    if quantity == Quantity::Rolls {
        return YES_NO;
    }
    let sloped = is_sloped(scene);
    let like = problem.cases.iter().filter(|c| is_sloped(&c.scene) == sloped);
    let (mut ahead, mut back, mut stays) = (false, false, false);
    for case in like {
        let went = went(&case.scene, &case.regimes);
        (ahead, back, stays) = (ahead || went[0], back || went[1], stays || went[2]);
    }
    let [pair, all, ahead_or_stays, back_or_stays] = if sloped { SLOPED } else { LEVEL };
    match (ahead, back, stays) {
        (_, _, false) => pair,
        (true, false, true) => ahead_or_stays,
        (false, true, true) => back_or_stays,
        (_, _, true) => all,
    }
}

/// The list that consists of these words.
pub fn listed(words: &[String]) -> Option<List> {
    SLOPED.into_iter().chain(LEVEL).find(|list| list.iter().eq(words))
}

/// Does a word for the direction say up or down here?
fn is_sloped(scene: &Scene) -> bool {
    let body = scene.bodies.get(scene.ending_coordinate().body);
    body.and_then(|b| b.line).is_some_and(|line| line.slope != Slope::Level)
}

/// Which directions these regimes can have: up or forward, down or back, none.
fn went(scene: &Scene, regimes: &[String]) -> [bool; 3] {
    use Motion as M;
    // The regime of a slip is that of the body which slips.
    let end = scene.ending_coordinate().body;
    let slips_itself = scene.ties.iter().any(|t| matches!(t, Tie::Slip { body, .. } if *body == end));
    let springs = scene.is_sprung();
    let of = |motion: &M| match motion {
        M::MovesUp | M::MovesForward | M::UpOk | M::UpTurningPoint | M::UpUnreachable => [true, false, false],
        M::ForwardOk | M::ForwardTurningPoint | M::ForwardUnreachable => [true, false, false],
        M::MovesDown | M::MovesBack | M::DownOk | M::DownTurningPoint | M::DownUnreachable => {
            [false, true, false]
        }
        M::BackOk | M::BackTurningPoint | M::BackUnreachable => [false, true, false],
        M::SlipsUp | M::SlipsForward if slips_itself => [true, false, false],
        M::SlipsDown | M::SlipsBack if slips_itself => [false, true, false],
        M::Balanced => [false, false, !springs],
        M::Rest => [false, false, springs],
        _ => [true, true, false],
    };
    // What is declared to do anything is not drawn at rest.
    if regimes.is_empty() {
        return [true, true, false];
    }
    let called = M::ALL.iter().filter(|m| regimes.iter().any(|word| m.is_called(word)));
    called.map(of).fold([false; 3], |a, b| [a[0] || b[0], a[1] || b[1], a[2] || b[2]])
}
