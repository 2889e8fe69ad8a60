//! Sentences for what the solvers say in numbers.
use crate::bank::Problem;
use crate::key::{Answer, KeyEntry};
use crate::num::Fast;
use crate::num::gauss::Unsettled;
use crate::num::ode::Trouble;
pub use crate::num::shown::significant as rounded;
use crate::problem::rule::inadmissible;
use crate::scene::admissible::{Inadmissible, Rule, TURNS};
use crate::scene::given;
use crate::scene::pose::{Choice, Gap, Layout, Obstacle};
use crate::scene::{
    AsIf, Asked, Coordinate, Degree, End, Found, Joint, JointKind, Mass, Num, Numbers, Owner, Planar,
    Quantity, Scene, Span, Spot, Straight, Tie,
};
use crate::solve::ladder::{self, Force, Taken};
use crate::solve::method::{Method, Rung};
use crate::solve::outcome::{Check, CheckKind, Lacks, Refusal, Regime};
use crate::words::Words;
use std::fmt::Display;

/// Five significant figures, for people.
pub fn figures(value: f64) -> String {
    rounded(value, 5)
}

/// The id of a body.
fn id(scene: &Scene, index: usize) -> &str {
    scene.bodies.get(index).map_or("?", |b| b.name.as_str())
}

/// What stands behind `the`: the id of a body where it is a word, `body B` where it is not.
fn body(scene: &Scene, index: usize) -> String {
    let Some(body) = scene.bodies.get(index) else { return "body".to_owned() };
    let word = body.name.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_word = word.len() > 1 && word.chars().all(|c| c.is_lowercase() || c == '_');
    if is_word { body.name.clone() } else { format!("body {}", body.name) }
}

fn of_tie(scene: &Scene, index: usize) -> String {
    match scene.ties.get(index) {
        Some(Tie::Cord(cord)) => cord.name.clone(),
        tie => tie.and_then(Tie::touching).map_or_else(|| "tie".to_owned(), |b| body(scene, b)),
    }
}

/// A sentence of `templates/sentences.yaml` with its places filled in.
fn say(name: &str, pieces: &[(&str, &dyn Display)]) -> String {
    let pieces: Vec<(&str, String)> =
        pieces.iter().map(|(place, piece)| (*place, piece.to_string())).collect();
    let pieces: Vec<(&str, &str)> = pieces.iter().map(|(place, text)| (*place, text.as_str())).collect();
    Words::sentences().say(&format!("sentences.{name}"), &pieces)
}

/// How far a condition looks, where the forces change on the way.
fn looks(scene: &Scene, all: &[Check]) -> String {
    // Where it never turns there is no turning point to speak of.
    let endless = all.iter().any(|c| c.kind == CheckKind::Reaches && c.available.is_infinite());
    match (scene.is_sprung(), scene.span) {
        (false, _) => String::new(),
        (true, Span::ToEnd) => say("looks.to_end", &[]),
        (true, Span::ToTurningPoint) if endless => say("looks.whole", &[]),
        (true, Span::ToTurningPoint) => say("looks.to_turning_point", &[]),
    }
}

/// Does it set itself going as declared? The name of the sentence that says so.
fn moves(scene: &Scene, c: &Check) -> &'static str {
    let rubs = || scene.joints.iter().any(|j| j.kind.rubs().is_some());
    let guided = || scene.joints.iter().any(|j| matches!(j.kind, JointKind::Guide { mu_k: Some(_), .. }));
    match c.ok {
        // What moves already needs no drive to set it going; a start speed may be 0.
        true if scene.is_struck() => "struck",
        true if !scene.start.is_empty() && c.available <= c.required => "by_itself",
        // Drive and resistance are given by their ratio, which needs a resistance.
        true if c.required == 0.0 => "free",
        true => "driven",
        false if scene.heading.is_some() && !scene.starts_from_rest() => "other_way",
        false if c.available == 0.0 && c.required == 0.0 && rubs() => match guided() {
            true => "held",
            false => "still",
        },
        false => "not_driven",
    }
}

/// One condition of `all` in words with its numbers.
pub fn check(scene: &Scene, all: &[Check], c: &Check) -> String {
    // Of joined bodies it is about a joint.
    let joint = scene.joints.get(c.of);
    let only_pushes = joint.is_some_and(|j| j.kind.only_pushes());
    let ok = |yes, no| if c.ok { yes } else { no };
    let how = match c.kind {
        CheckKind::Reaches => return reaches(scene, all, c),
        CheckKind::Moves => moves(scene, c),
        CheckKind::NoSlip | CheckKind::Taut if c.available.is_nan() => "open",
        CheckKind::NoSlip if matches!(scene.ties.get(c.of), Some(Tie::Slide { .. })) => {
            ok("stays", "slips_on")
        }
        CheckKind::Pressed | CheckKind::Taut | CheckKind::HoldsBlow if c.available == f64::NEG_INFINITY => {
            "shared"
        }
        CheckKind::Pressed | CheckKind::Taut if joint.is_some() => ok("of_joint", "not_of_joint"),
        CheckKind::HoldsBlow if only_pushes => ok("pressed", "not_pressed"),
        CheckKind::HoldsBlow => ok("held", "not_held"),
        CheckKind::Met if c.required <= 0.0 => "at_start",
        CheckKind::Met if c.required.is_infinite() => "never",
        CheckKind::Next if !c.ok => match CheckKind::ALL.get(c.of) {
            Some(
                kind @ (CheckKind::Moves
                | CheckKind::Reaches
                | CheckKind::NoSlip
                | CheckKind::Taut
                | CheckKind::Pressed),
            ) => kind.name(),
            _ => "fails",
        },
        CheckKind::Closes if c.ok && c.required <= 0.0 => "by_itself",
        CheckKind::Slack if c.required < c.available => "taut",
        CheckKind::Slack => "slack",
        CheckKind::SlipEnds if c.available.is_infinite() => "never",
        CheckKind::SlipEnds if c.required < c.available => "slips",
        CheckKind::SlipEnds => "rolls",
        CheckKind::UnderWay if c.available == 0.0 => "rests",
        CheckKind::UnderWay => "is",
        CheckKind::StaticLimit if c.required <= c.available => "could",
        CheckKind::StaticLimit => "could_not",
        _ => ok("holds", "fails"),
    };
    let ratio = if c.available == 0.0 { 0.0 } else { c.available / c.required };
    let held = joint.and_then(|j| j.kind.spots().next()).map_or(0, |spot| spot.body);
    // A condition is about a tie or about a body; what is not meant is not told.
    let pieces: [(&str, &dyn Display); 10] = [
        ("tie", &of_tie(scene, c.of)),
        ("body", &body(scene, c.of)),
        ("of", &body(scene, held)),
        ("name", &joint.map_or("?", |j| j.name.as_str())),
        ("strut", &scene.struts.get(c.of).map_or("?", |s| s.name.as_str())),
        ("looks", &looks(scene, all)),
        ("required", &figures(c.required)),
        ("available", &figures(c.available)),
        ("ratio", &figures(ratio)),
        ("unit", &c.kind.unit(scene)),
    ];
    say(&format!("check.{}.{how}", c.kind.name()), &pieces)
}

/// Is the end reached, and how far does the motion go?
fn reaches(scene: &Scene, all: &[Check], c: &Check) -> String {
    let (pinned, endless) = (scene.lead().is_some(), c.available.is_infinite());
    let started = !scene.starts_from_rest() && scene.ends_at_a_place();
    let at_start = !c.ok && c.required.total_cmp(&c.available).is_eq();
    let how = match (c.ok, matches!(scene.end, End::TurningPoint(_))) {
        _ if scene.end == End::Equilibrium => "no_equilibrium",
        (true, _) if matches!(scene.end, End::Leaves(_)) => "left",
        (false, _) if matches!(scene.end, End::Leaves(_)) => "not_left",
        _ if at_start && all.iter().any(|c| c.kind == CheckKind::Pressed && !c.ok) => "lost_at_start",
        // It is reached, and by a motion of no length.
        _ if at_start => "at_start",
        // In phases it goes on after a turning point, up to where nothing holds what slips.
        (false, false) if matches!(scene.end, End::Time(..)) && !pinned && !scene.goes_in_phases() => {
            if endless {
                "after_turning_endless"
            } else {
                "after_turning"
            }
        }
        (true, true) if !endless || pinned => "comes_to_rest",
        (false, true) if pinned => "not_in_turns",
        (false, true) if endless => "never_at_rest",
        (true, _) if endless && pinned => "well_beyond",
        (true, _) if endless => "without_end",
        (true, _) => "as_far_as",
        (false, _) if endless && pinned && c.required >= 0.0 => "turns_at_most",
        (false, _) if !scene.growths.is_empty() && scene.heading.is_none() && c.required >= 0.0 => {
            "turns_before"
        }
        (false, _) if c.required < 0.0 && (endless || pinned) => "behind",
        (false, _) if c.required < 0.0 => "behind_and_turns",
        (false, _) if endless || c.required < c.available => "other_way",
        (false, _) => "not_so_far",
    };
    let joint = match scene.end {
        End::Leaves(joint) => scene.joints[joint].name.as_str(),
        _ => "",
    };
    let then = match scene.growths.is_empty() {
        _ if at_start && !started => "then.later",
        true => "then.next",
        false => "then.grows",
    };
    let pieces: [(&str, &dyn Display); 7] = [
        ("joint", &joint),
        ("turns", &TURNS),
        ("required", &figures(c.required)),
        ("available", &figures(c.available)),
        ("way", &figures(-c.required)),
        ("unit", &scene.measure()),
        ("then", &say(then, &[("name", &id(scene, c.of))])),
    ];
    say(&format!("reaches.{how}"), &pieces)
}

/// What really happens, in a sentence.
pub fn regime(words: &Words, regime: Regime) -> String {
    let text = words.get(&regime.motion.phrase());
    if regime.slips { words.say("sheet.regime.if_rolled", &[("regime", text)]) } else { text.to_owned() }
}

/// Why this method, and whether it meets what was asked.
pub fn why(taken: &Taken) -> String {
    let mut text = reason(taken).to_owned();
    let Some(asked) = taken.asked.filter(|_| !taken.errors.is_empty()) else { return text };
    match taken.rung.requested() {
        Some(rtol) if rtol > asked => {
            let (asked, rtol) = (format!("{asked:e}"), format!("{rtol:e}"));
            text.push_str(&say("why.raised", &[("asked", &asked), ("rtol", &rtol)]));
        }
        None if taken.worst > asked => {
            let (asked, worst) = (format!("{asked:e}"), format!("{:.1e}", taken.worst));
            text.push_str(&say("why.not_met", &[("asked", &asked), ("worst", &worst)]));
        }
        _ => {}
    }
    text
}

#[rustfmt::skip] // a table
fn reason(taken: &Taken) -> &'static str {
    if taken.rung == Rung::Doubles {
        return "a closed form exists, and doubles are exact enough for the tolerance";
    }
    match (taken.chosen, taken.rung.method(), taken.force) {
        (_, Method::Closed, Force::Instant) => "only an instant is asked, nothing has to be integrated",
        (true, Method::Closed, Force::Constant) => "the forces are the same all the way, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::Switched) => "the forces are the same all the way up to where a contact comes to rest and from there on, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::OfTime) => "the forces grow with a power of time or place, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::Linear) => "the force changes in proportion to the displacement, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::Pendulum) => "under its weight alone the time is an elliptic integral, known to rounding, and nothing is cheaper",
        (true, _, Force::Rubs) => "friction does not change on the way, whose integral a few points settle",
        (true, _, Force::Irregular | Force::Joined) => "the force changes with the angle so that the time has no closed form; its integral is regular, so nothing has to be stepped",
        (_, Method::Closed, _) => "as asked; exact but for rounding",
        (_, Method::Gauss, _) => "as asked; the equations of motion judge it",
        _ => "as asked; work and energy judge it",
    }
}

/// How finely a method was set: `1 ms`, `rtol 1e-9`, `24 points`; empty for the closed form.
pub fn setting(rung: Rung) -> String {
    match rung {
        Rung::Closed => "32 digits".to_owned(),
        Rung::Doubles => "doubles".to_owned(),
        Rung::Settled => "until settled".to_owned(),
        Rung::Gauss(1) => "1 point".to_owned(),
        Rung::Gauss(points) => format!("{points} points"),
        Rung::Adaptive(_, rtol, _) => format!("rtol {rtol:.2e}").replace(".00e", "e").replace("0e", "e"),
        Rung::Fixed(_, step) => ladder::STEPS_S
            .iter()
            .find(|(s, _)| (s - step).abs() <= 1e-12 * s)
            .map_or_else(|| format!("{} s", figures(step)), |(_, name)| (*name).to_owned()),
    }
}

/// A method with its setting: `closed form`, `rk4, 1/60 s`.
pub fn rung(rung: Rung) -> String {
    match rung {
        Rung::Closed => "closed form".to_owned(),
        Rung::Doubles => "closed form in doubles".to_owned(),
        Rung::Settled => "gauss quadrature with as many points as rounding allows".to_owned(),
        _ => format!("{}, {}", rung.method().as_str(), setting(rung)),
    }
}

/// The method that was taken, why, and what it cost.
pub fn taken(taken: &Taken) -> String {
    let name = rung(taken.rung);
    let by = if taken.chosen { " (auto)" } else { "" };
    let mut text = format!("{name}{by}: {}", why(taken));
    if !taken.errors.is_empty() {
        let n = taken.count.evaluations;
        text.push_str(&format!("; {n} force evaluation{}", if n == 1 { "" } else { "s" }));
        if taken.estimate.evaluations > 0 {
            text.push_str(&format!(", {} more for the error estimate", taken.estimate.evaluations));
        }
        text.push_str(&format!("; off by {} of an answer at most", rounded(taken.worst, 2)));
    }
    text
}

/// Why a run has no result.
#[rustfmt::skip] // a table
fn trouble(trouble: &Trouble) -> String {
    match trouble {
        Trouble::Missed { by, at } => format!("misses its event: the motion turns at t = {at:e} s with {by:e} still to go; take a smaller step or tolerance"),
        Trouble::NoConvergence { residual, accepted } => format!("no step ends on its event: {residual:e} remains, {accepted:.1e} would be accepted"),
        Trouble::StepUnderflow { at, step } => format!("its step shrinks to {step:e} s at t = {at:e} s and does not move on"),
        Trouble::TooManySteps { steps, at } => format!("is given up after {steps} steps at t = {at:e} s; take a longer step or a larger tolerance"),
        Trouble::Overdue { at } => format!("goes past the end without meeting it, as far as t = {} s; take a shorter step or a smaller tolerance", figures(*at)),
        Trouble::StepTooShort { step, steps } => format!("would need {steps:.0e} steps of {step:e} s or, for the error estimate, shorter; take a longer step"),
        Trouble::NotFinite { at } => format!("runs off: a value is no longer finite at t = {at:e} s"),
    }
}

/// A velocity in words, such as "the spin of `drum`".
fn velocity(scene: &Scene, of: Coordinate) -> String {
    let what = if of.degree == Degree::Along { "speed" } else { "spin" };
    format!("the {what} of `{}`", id(scene, of.body))
}

/// A place of the plane.
fn at_place(place: [f64; 2], beside: [f64; 2]) -> String {
    // What is nothing beside the coordinates of both places is 0.
    let size = place.iter().chain(&beside).fold(0.0, |size: f64, x| size.max(x.abs()));
    let [x, y] = place.map(|x| figures(if x.abs() <= 1e-9 * size { 0.0 } else { x }));
    format!("({x} m, {y} m)")
}

/// A point of a body, as banks name it.
fn point(scene: &Scene, at: Spot) -> String {
    scene.point_name(at).map_or_else(|| "?".to_owned(), |(body, point)| format!("{body}.{point}"))
}

/// Where the joints put at the start what they could put in two places, where the bank does not say which is meant.
pub fn sides(scene: &Scene, data: &[f64]) -> Vec<String> {
    let numbers = Numbers::<Fast>::new(scene, data);
    let choices = Layout::new(scene, &numbers).map(|layout| layout.choices());
    let told = |Choice { at, here, there, .. }: Choice| {
        let (here, there) = (at_place(here, there), at_place(there, here));
        let (body, point) = (id(scene, at.body), point(scene, at));
        say("side", &[("body", &body), ("point", &point), ("here", &here), ("there", &there)])
    };
    choices.into_iter().flatten().map(told).collect()
}

/// Answers that later expressions use by the name of a quantity, which they hide.
pub fn hidden(scene: &Scene) -> Vec<String> {
    let asked = &scene.formulas.asked;
    let word = |c: char| !(c.is_alphanumeric() || c == '_' || c == '.');
    let told = asked.iter().enumerate().filter_map(|(i, answer)| {
        let hides = Quantity::from_name(&answer.id).is_some() && answer.text.trim() != answer.id;
        let uses = |other: &&Asked| other.text.split(word).any(|name| name == answer.id);
        let other = asked.iter().skip(i + 1).find(uses).filter(|_| hides)?;
        Some(say("hidden", &[("id", &answer.id), ("other", &other.id)]))
    });
    told.collect()
}

/// Why a scene with these data has no answer; a sentence each.
pub fn refusal(problem: &Problem, scene: &Scene, refusal: &Refusal) -> Vec<String> {
    match refusal {
        Refusal::Inadmissible(faults) => faults.iter().map(|f| inadmissible(problem, scene, f)).collect(),
        Refusal::NextInadmissible(faults) => {
            let next = scene.formulas.others.iter().find(|(how, _)| *how == AsIf::Next);
            let next = next.map_or(scene, |(_, next)| next);
            let told = |f: &Inadmissible| {
                let valley =
                    if f.rule == Rule::Slope { say("refused.no_valley", &[]) } else { String::new() };
                say("refused.next", &[("why", &format!("{}{valley}", inadmissible(problem, next, f)))])
            };
            faults.iter().map(told).collect()
        }
        one => vec![refused(problem, scene, one)],
    }
}

/// Why the search for a datum fails: no value of it fits what was measured, or more than one.
fn not_found(problem: &Problem, scene: &Scene, why: &Refusal) -> String {
    let symbol = |of: fn(&Found) -> usize| {
        let datum = scene.formulas.found.as_ref().and_then(|f| problem.data.get(of(f)));
        datum.map_or_else(|| "a datum".to_owned(), |d| format!("`{}`", d.symbol))
    };
    let (unknown, measured) = (symbol(|f| f.unknown.datum), symbol(|f| f.measured.datum));
    let both: [(&str, &dyn Display); 2] = [("unknown", &unknown), ("measured", &measured)];
    match why {
        Refusal::NotFound => say("not_found.none", &both),
        Refusal::NotUnique(Some(value)) => {
            let name = if scene.end == End::AtOnce { "not_found.not_held" } else { "not_found.not_reached" };
            say(name, &[both[0], both[1], ("value", &in_unit(problem, scene, *value))])
        }
        _ => say("not_found.several", &both),
    }
}

/// A value of the unknown, as the bank writes it.
fn in_unit(problem: &Problem, scene: &Scene, value: f64) -> String {
    let datum = scene.formulas.found.as_ref().and_then(|f| problem.data.get(f.unknown.datum));
    datum.map_or_else(String::new, |datum| {
        let own = if datum.degrees { value } else { datum.unit.from_si(value) };
        datum.unit.text_with(&figures(own))
    })
}

/// Why an integral over a motion has no value.
fn unsettled(scene: &Scene, Unsettled { value, gap }: &Unsettled) -> String {
    let spring = if scene.struts.is_empty() { String::new() } else { say("unsettled.spring", &[]) };
    let mut rough = scene.joints.iter().filter_map(|joint| joint.kind.mu_k()).peekable();
    let name = match value.is_finite() && gap.is_finite() {
        _ if rough.peek().is_some() && rough.all(|mu| mu == Num::Fixed(0.0)) => "unsettled.smooth",
        true => "unsettled.slow",
        false => "unsettled.stops",
    };
    let (value, gap) = (format!("{value:e}"), format!("{gap:e}"));
    say(name, &[("value", &value), ("gap", &gap), ("spring", &spring)])
}

/// A refusal of one sentence.
fn refused(problem: &Problem, scene: &Scene, refusal: &Refusal) -> String {
    let power = |x: &f64| format!("{x:e}");
    match refusal {
        // Those are several sentences.
        Refusal::Inadmissible(_) | Refusal::NextInadmissible(_) => String::new(),
        Refusal::Singular { unknowns, rank } => {
            let nothing = Mass::Kilograms(Num::Fixed(0.0));
            let light = scene.bodies.iter().any(|b| b.planar.is_some() && b.mass == nothing);
            let name = if light { "refused.singular_light" } else { "refused.singular" };
            say(name, &[("unknowns", unknowns), ("rank", rank)])
        }
        Refusal::NotFound | Refusal::NotUnique(_) => not_found(problem, scene, refusal),
        Refusal::Freedoms(n) => {
            let name = match n {
                _ if scene.joints.is_empty() => "of_ties",
                0 => "none",
                _ => "of_joints",
            };
            say(&format!("refused.freedoms.{name}"), &[("n", n)])
        }
        Refusal::Unplaced(_)
        | Refusal::Hollow(_)
        | Refusal::IdleSide { .. }
        | Refusal::Unbridged { .. }
        | Refusal::Tilted { .. }
        | Refusal::Crossed(_)
        | Refusal::Parted { .. }
        | Refusal::PartedBefore { .. }
        | Refusal::Moved { .. } => misplaced(scene, refusal),
        Refusal::Beyond(obstacle) => beyond(scene, *obstacle),
        Refusal::SlackBetween(tie) => say("refused.slack_between", &[("tie", &of_tie(scene, *tie))]),
        Refusal::SlipShared(tie) => say("refused.slip_shared", &[("body", &of_tie(scene, *tie))]),
        Refusal::EqualByChance { usual, now } => {
            say("refused.equal_by_chance", &[("usual", usual), ("now", now)])
        }
        Refusal::Open(of) => say("refused.open", &[("of", &velocity(scene, *of))]),
        Refusal::Contradiction { of, given, follows } => {
            let pieces: [(&str, &dyn Display); 4] = [
                ("of", &velocity(scene, *of)),
                ("given", &figures(*given)),
                ("follows", &figures(*follows)),
                ("unit", &given::speed_unit(of.degree)),
            ];
            say("refused.contradiction", &pieces)
        }
        Refusal::Friction(joint, lacks) => {
            let name = match lacks {
                Lacks::Sliding => "refused.friction.sliding",
                Lacks::Side => "refused.friction.side",
                Lacks::Lasting => "refused.friction.lasting",
                Lacks::Grip => "refused.friction.grip",
            };
            say(name, &[("joint", &joint_name(scene, *joint))])
        }
        Refusal::Unsupported(what) => say(&format!("unsupported.{what:?}"), &[]),
        Refusal::Trouble { method, trouble: why } => format!("{}: {}", method.as_str(), trouble(why)),
        Refusal::Unsteady { method, label, value, finer } => {
            let (method, label) = (method.as_str(), scene.name_of(*label));
            let (value, finer) = (power(value), power(finer));
            say(
                "refused.unsteady",
                &[("method", &method), ("label", &label), ("value", &value), ("finer", &finer)],
            )
        }
        Refusal::Contradicts { method, label, value, judge, allowed } => {
            let by = if *method == Method::Gauss { "the equations of motion" } else { "work and energy" };
            let pieces: [(&str, &dyn Display); 6] = [
                ("method", &method.as_str()),
                ("by", &by),
                ("label", &scene.name_of(*label)),
                ("value", &power(value)),
                ("judge", &power(judge)),
                ("allowed", &rounded(*allowed, 2)),
            ];
            say("refused.contradicts", &pieces)
        }
        Refusal::Unmet { method, points, error, asked } => {
            let (method, error, asked) = (method.as_str(), format!("{error:.1e}"), format!("{asked:.1e}"));
            say(
                "refused.unmet",
                &[("method", &method), ("points", points), ("error", &error), ("asked", &asked)],
            )
        }
        Refusal::Apart => say("refused.apart", &[]),
        Refusal::Barely => say("refused.barely", &[]),
        Refusal::NoMethod { method } => say("refused.no_method", &[("method", &method.as_str())]),
        Refusal::Unsettled(why) => unsettled(scene, why),
        Refusal::Disagree { label, eom, energy, allowed } => {
            let cord = |j: &Joint| matches!(j.kind, JointKind::Cord { .. });
            let name = match *allowed < 1.0 {
                _ if (eom + energy).is_nan() && scene.joints.iter().any(cord) => "refused.no_length",
                true => "refused.disagree",
                false => "refused.last_digits",
            };
            let (eom, energy, allowed) = (power(eom), power(energy), format!("{allowed:.1e}"));
            let label = scene.name_of(*label);
            say(name, &[("label", &label), ("eom", &eom), ("energy", &energy), ("allowed", &allowed)])
        }
    }
}

/// What is placed in a straight guide and hangs on a cord from another body can be followed, save where it starts at its pulley.
fn hangs_at_its_pulley(scene: &Scene, body: usize) -> bool {
    let placed = scene.planar(body).is_some_and(|planar| planar.origin_m.is_some());
    let held = |is: fn(&JointKind) -> bool| {
        scene.joints.iter().any(|j| is(&j.kind) && j.kind.spots().any(|spot| spot.body == body))
    };
    let hangs = held(|kind| matches!(kind, JointKind::Cord { beyond: Some(_), .. }));
    placed && hangs && held(|kind| matches!(kind, JointKind::Guide { line: Straight { on: None, .. }, .. }))
}

fn joint_name(scene: &Scene, joint: usize) -> &str {
    scene.joints.get(joint).map_or("?", |j| j.name.as_str())
}

/// What a motion does not pass.
fn beyond(scene: &Scene, obstacle: Obstacle) -> String {
    let name = |of: Owner| scene.owner_name(of).unwrap_or_default();
    match obstacle {
        Obstacle::Wound(strut) => say("refused.beyond.wound", &[("spring", &name(Owner::Strut(strut)))]),
        Obstacle::Pulley(joint) => say("refused.beyond.pulley", &[("joint", &joint_name(scene, joint))]),
        Obstacle::InLine(body, other) => {
            say("refused.beyond.in_line", &[("body", &id(scene, body)), ("other", &id(scene, other))])
        }
        Obstacle::Across(body) => say("refused.beyond.across", &[("body", &id(scene, body))]),
        Obstacle::AtPin(body) => say("refused.beyond.at_pin", &[("body", &id(scene, body))]),
        Obstacle::Strikes(spot, joint) => {
            let (body, point) = scene.point_name(spot).unwrap_or_default();
            let joint = joint_name(scene, joint);
            say("refused.beyond.strikes", &[("point", &point), ("body", &body), ("joint", &joint)])
        }
    }
}

/// Why joined bodies are not put where the joints and the data say.
fn misplaced(scene: &Scene, refusal: &Refusal) -> String {
    let when = |at_start: &bool| if *at_start { "at the start" } else { "on the way" };
    match refusal {
        Refusal::Unplaced(index) => {
            let open = matches!(scene.planar(*index), Some(Planar { start_deg: None, .. }));
            let placed = scene.planar(*index).is_some_and(|planar| planar.origin_m.is_some());
            let turns = scene.bodies[*index].turns;
            let name = match scene.is_still() && (scene.starts_from_rest() || scene.tells_speeds()) {
                true if placed => "placed",
                true if open && turns => "turns",
                true => "at_once",
                false if hangs_at_its_pulley(scene, *index) => "at_its_pulley",
                false => "on_the_way",
            };
            let wheels = |is: fn(&JointKind) -> bool| scene.joints.iter().filter(|j| is(&j.kind)).count();
            let rule = match turns {
                false => "slides",
                true if wheels(|kind| kind.rolls()[1]) > 0 => "meshes",
                true if wheels(|kind| kind.rolls()[0]) > 1 => "rolls",
                true => "turns",
            };
            let rule = say(&format!("refused.unplaced.rule.{rule}"), &[]);
            say(&format!("refused.unplaced.{name}"), &[("body", &id(scene, *index)), ("rule", &rule)])
        }
        Refusal::Hollow(body) => say("refused.hollow", &[("body", &id(scene, *body))]),
        Refusal::IdleSide { body, with: None } => say("refused.idle_side", &[("body", &id(scene, *body))]),
        Refusal::IdleSide { body, with: Some(with) } => {
            say("refused.other_side", &[("body", &id(scene, *body)), ("with", &id(scene, *with))])
        }
        Refusal::Unbridged { gap: Gap { body, other, apart_m, bridged_m }, at_start } => {
            let pieces: [(&str, &dyn Display); 6] = [
                ("body", &id(scene, *body)),
                ("other", &other.map_or("", |other| id(scene, other))),
                ("when", &when(at_start)),
                ("apart", &figures(*apart_m)),
                ("most", &if apart_m > bridged_m { "most" } else { "least" }),
                ("bridged", &figures(*bridged_m)),
            ];
            say(if other.is_some() { "refused.unbridged_two" } else { "refused.unbridged" }, &pieces)
        }
        Refusal::Tilted { body, given_deg, follows_deg } => {
            let (given, follows) = (figures(*given_deg), figures(*follows_deg));
            say("refused.tilted", &[("body", &id(scene, *body)), ("given", &given), ("follows", &follows)])
        }
        Refusal::Crossed(Choice { at, here, there, .. }) => {
            let (here, there) = (at_place(*here, *there), at_place(*there, *here));
            let (body, point) = (id(scene, at.body), point(scene, *at));
            say("refused.crossed", &[("body", &body), ("point", &point), ("here", &here), ("there", &there)])
        }
        Refusal::Parted { joint, off_m, at_start } => {
            let joint = joint_name(scene, *joint);
            let name = if off_m.is_nan() { "refused.parted_open" } else { "refused.parted" };
            say(name, &[("joint", &joint), ("when", &when(at_start)), ("off", &figures(*off_m))])
        }
        Refusal::PartedBefore { joint, speed, degree } => {
            let speed = format!("{} {}", figures(*speed), given::speed_unit(*degree));
            say("refused.parted_before", &[("joint", &joint_name(scene, *joint)), ("speed", &speed)])
        }
        Refusal::Moved { body, off_m } => {
            say("refused.moved", &[("body", &id(scene, *body)), ("off", &figures(*off_m))])
        }
        _ => String::new(),
    }
}

/// The right answer of a key, rounded for a person: `30.26 rad/s`, `62.6 N up`, `yes`.
pub fn right_answer(words: &Words, entry: &KeyEntry, signs: Option<[&str; 2]>) -> String {
    match &entry.answer {
        Answer::Word { right, .. } => words.of_key(right).to_owned(),
        Answer::Number { value, .. } => {
            let value = entry.unit.from_si(*value);
            if let Some([positive, negative]) = signs.filter(|_| value != 0.0) {
                let word = if value > 0.0 { positive } else { negative };
                let number = words.number(&rounded(value.abs(), 4));
                format!("{} {word}", entry.unit.text_with(&number))
            } else {
                entry.unit.text_with(&words.number(&rounded(value, 4)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined() -> Scene {
        let text = "
bank: t
title: t
problems:
  p:
    title: t
    data: {}
    scene:
      bodies: {rod: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane, angle: from vertical}}
      joints: {floor: {guides: rod.A, along: horizontal, pushes: up}, cord: {links: rod.B, to: [0 m, 3 m]}}
      start: {rod: {angle: 10 deg}}
      end: {angle: {of: rod, reaches: 20 deg}}
    questions: {v: {ask: v}}
";
        let bank = crate::bank::load::scenes_only(text, "t.yaml").unwrap_or_else(|found| panic!("{found:?}"));
        bank.problems[0].cases[0].scene.clone()
    }

    /// The words were only read with speeds above 0.
    #[test]
    fn a_start_speed_of_nothing_is_not_said_to_move_it() {
        let turn = Coordinate { body: 0, degree: Degree::Turn };
        let start = vec![crate::scene::Start::Speed(turn, Num::Fixed(0.0))];
        let scene = Scene { start, joints: Vec::new(), end: End::TurningPoint(turn), ..joined() };
        let moves = |available: f64, required: f64| {
            let kind = CheckKind::Moves;
            check(&scene, &[], &Check { kind, of: 0, ok: true, required, available, margin: 1.0 })
        };
        // Without a drive only a speed of its own can move it.
        assert!(moves(0.0, 3.0).contains("a speed of its own"));
        assert!(moves(0.0, 0.0).contains("a speed of its own"));
        assert!(moves(3.0, 0.0).contains("nothing resists"));
        assert!(moves(3.0, 2.0).contains("the driving force is 1.5000 times the resistance"));
    }

    /// How every condition can come out has its sentence, whatever it is about: a name that is put together is found out only where
    /// it is said.
    #[test]
    fn every_condition_has_its_sentences() {
        let joined = joined();
        let mut scenes = vec![joined.clone()];
        scenes.push(Scene { joints: Vec::new(), ..joined.clone() });
        scenes.push(Scene { joints: joined.joints[1..].to_vec(), ..joined.clone() });
        let numbers = [f64::NAN, -1.0, 0.0, 1.0, 2.0, f64::INFINITY];
        for (scene, kind) in scenes.iter().flat_map(|s| CheckKind::ALL.iter().map(move |kind| (s, *kind))) {
            for (required, available) in numbers.iter().flat_map(|r| numbers.iter().map(move |a| (*r, *a))) {
                // Of what follows the kind of its condition is told as a body is of others.
                for (of, ok) in (0..CheckKind::ALL.len()).flat_map(|of| [(of, true), (of, false)]) {
                    let of = if kind == CheckKind::Next { of } else { 0 };
                    let one = Check { kind, of, ok, required, available, margin: 1.0 };
                    assert!(!check(scene, &[], &one).is_empty(), "{one:?}");
                }
            }
        }
        // How the end is reached or not hangs on the whole scene: the names stand in the source.
        let source = include_str!("sentences.rs");
        let (_, all) = source.split_once("let how = match (c.ok, matches!").expect("it is there");
        let (all, _) = all.split_once("\n    };").expect("it ends");
        let names: Vec<&str> = all.split('"').skip(1).step_by(2).collect();
        let said: Vec<String> = names.iter().map(|name| say(&format!("reaches.{name}"), &[])).collect();
        assert!(names.len() > 10 && said.iter().all(|text| !text.is_empty()), "{names:?}");
    }

    /// A missing sentence is found out only where it is said.
    #[test]
    fn every_name_in_the_source_has_its_sentence() {
        let (source, _) = include_str!("sentences.rs").split_once("mod tests").expect("they are here");
        let topics = ["looks.", "then.", "why.", "refused.", "not_found.", "unsettled."];
        let names = source.split('"').skip(1).step_by(2).filter(|s| topics.iter().any(|t| s.starts_with(t)));
        let said = names.filter(|name| !name.contains('{')).map(|name| say(name, &[]));
        assert!(said.filter(|text| !text.is_empty()).count() > 30);
    }

    /// A name that is put together is found out only where it is said.
    #[test]
    fn what_is_not_solved_has_its_sentence() {
        let (_, all) =
            include_str!("../solve/outcome.rs").split_once("pub enum Unsupported {").expect("it is there");
        let (all, _) = all.split_once("\n}").expect("it ends");
        let names = all.lines().map(str::trim).filter(|line| !line.starts_with("//") && !line.is_empty());
        for name in names.map(|line| line.trim_end_matches(',')) {
            assert!(!say(&format!("unsupported.{name}"), &[]).is_empty(), "{name}");
        }
    }
}
