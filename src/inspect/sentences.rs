//! Sentences for what the solvers say in numbers.
use crate::bank::Problem;
use crate::key::{Answer, KeyEntry};
use crate::num::Fast;
use crate::num::gauss::Unsettled;
use crate::num::ode::Trouble;
pub use crate::num::shown::significant as rounded;
use crate::problem::rule::inadmissible;
use crate::scene::pose::{Choice, Gap, Layout};
use crate::scene::{
    AsIf, Asked, Coordinate, Degree, End, Found, Mass, Num, Numbers, Quantity, Scene, Span, Spot, Tie,
};
use crate::solve::ladder::{self, Force, Taken};
use crate::solve::method::{Method, Rung};
use crate::solve::outcome::{Check, CheckKind, Refusal, Regime, Unsupported};
use crate::words::Words;

/// Five significant figures, for people.
pub fn figures(value: f64) -> String {
    rounded(value, 5)
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

/// How far a condition looks, where the forces change on the way.
fn looks(scene: &Scene, all: &[Check]) -> &'static str {
    // Where it never turns there is no turning point to speak of.
    let endless = all.iter().any(|c| c.kind == CheckKind::Reaches && c.available.is_infinite());
    match (scene.is_sprung(), scene.span) {
        (false, _) => "",
        (true, Span::ToEnd) => " up to the end that is asked",
        (true, Span::ToTurningPoint) if endless => " over the whole motion",
        (true, Span::ToTurningPoint) => " up to the turning point",
    }
}

/// Does it set itself going as declared?
fn moves(scene: &Scene, c: &Check) -> String {
    let body = body(scene, c.of);
    let ratio = || figures(if c.available == 0.0 { 0.0 } else { c.available / c.required });
    match c.ok {
        // What moves already needs no drive to set it going; a start speed may be 0.
        true if scene.is_struck() => format!("the {body} moves as declared: it is struck"),
        true if !scene.start.is_empty() && c.available <= c.required => {
            format!("the {body} moves as declared: it starts with a speed of its own")
        }
        // Drive and resistance are given by their ratio, which needs a resistance.
        true if c.required == 0.0 => format!("the {body} moves as declared: nothing resists"),
        true => {
            format!("the {body} moves as declared: the driving force is {} times the resistance", ratio())
        }
        false if scene.heading.is_some() && !scene.starts_from_rest() => format!(
            "the {body} does not move as declared: it starts the other way; what comes after a turning point is a motion of its own, `next`"
        ),
        false
            if c.available == 0.0
                && c.required == 0.0
                && scene.joints.iter().any(|j| j.kind.rubs().is_some()) =>
        {
            format!(
                "the {body} does not move as declared: friction holds it at rest; for the forces that hold it write `pins:` in place of \
                 the rough guide"
            )
        }
        false => format!(
            "the {body} does not move as declared: the driving force is {} times the resistance, required more than 1",
            ratio()
        ),
    }
}

/// Is a cord taut at the end?
fn slack(scene: &Scene, c: &Check) -> String {
    let (required, available) = (figures(c.required), figures(c.available));
    let unit = c.kind.unit(scene);
    let when = if c.required < c.available { "is still taut" } else { "is slack" };
    format!(
        "{} {when} at the end, after {required} {unit}: it goes slack after {available} {unit}",
        of_tie(scene, c.of)
    )
}

/// Does a spring that only pushes or pulls act before the end?
fn met(scene: &Scene, c: &Check) -> String {
    let name = scene.struts.get(c.of).map_or("?", |s| s.name.as_str());
    let (required, available) = (figures(c.required), figures(c.available));
    if c.required <= 0.0 {
        format!("`{name}` acts from the start")
    } else if c.required.is_infinite() {
        format!("`{name}` is never met: the motion ends after {available} rad without it")
    } else {
        let not = if c.ok { "" } else { "not " };
        format!(
            "`{name}` is {not}met before the end: after {required} rad, the motion ends after {available} rad"
        )
    }
}

/// One condition of `all` in words with its numbers.
#[rustfmt::skip] // a table
pub fn check(scene: &Scene, all: &[Check], c: &Check) -> String {
    let (required, available) = (figures(c.required), figures(c.available));
    // A condition is about a tie or about a body; what is not meant is not told.
    let (tie, body, looks) = (of_tie(scene, c.of), body(scene, c.of), looks(scene, all));
    // Of joined bodies it is about a joint.
    let joint =
        scene.joints.get(c.of).map(|j| (j.name.as_str(), j.kind.spots().next().map_or(0, |s| s.body)));
    let unknown = |what: String| {
        format!("whether {what} holds is not known: several ties share its force, and statics does not say how")
    };
    match c.kind {
        CheckKind::Moves => moves(scene, c),
        CheckKind::NoSlip if c.available.is_nan() => unknown(format!("the contact of the {tie}")),
        CheckKind::Taut if c.available.is_nan() => unknown(tie),
        CheckKind::NoSlip if matches!(scene.ties.get(c.of), Some(Tie::Slide { .. })) => {
            let [not, then] = if c.ok { ["", ""] } else { ["not", ", and it slips on"] };
            format!(
                "static friction can{not} hold the {tie} where its slip ends{then}: that needs {required} N, mu_s N = {available} N"
            )
        }
        CheckKind::NoSlip if c.ok => format!("the {tie} holds without slipping{looks}: needs {required} N of friction, mu_s N = {available} N"),
        CheckKind::NoSlip => format!("the {tie} slips: rolling{looks} needs {required} N of friction, mu_s N = {available} N is available"),
        CheckKind::MustSlip if c.ok => format!("the {tie} slips: rolling would need {available} N of friction, more than mu_s N = {required} N"),
        CheckKind::MustSlip => format!("the {tie} need not slip: rolling needs {available} N of friction, not more than mu_s N = {required} N"),
        CheckKind::Pressed | CheckKind::Taut if joint.is_some() => {
            let (name, of) = joint.unwrap_or(("?", 0));
            let what = match (c.kind, c.ok) {
                (CheckKind::Pressed, true) => "is pressed on",
                (CheckKind::Pressed, false) => "is not pressed on",
                (_, true) => "pulls at the cord",
                (_, false) => "does not pull at the cord",
            };
            format!("the {} {what} `{name}`: {available} N, required more than 0 N", self::body(scene, of))
        }
        CheckKind::HoldsBlow => {
            let (name, of) = joint.unwrap_or(("?", 0));
            let what = if scene.joints.get(c.of).is_some_and(|j| j.kind.only_pushes()) {
                "pressed on"
            } else {
                "held by"
            };
            let not = if c.ok { "" } else { "not " };
            format!("at the blow the {} is {not}{what} `{name}`: {available} N*s, required more than 0 N*s", self::body(scene, of))
        }
        CheckKind::Met => met(scene, c),
        CheckKind::Next if c.ok => "the motion that follows goes as it is said to".to_owned(),
        CheckKind::Next => {
            let what = match CheckKind::ALL.get(c.of) {
                Some(CheckKind::Moves) => "nothing sets it moving that way",
                Some(CheckKind::Reaches) => "it does not get to its end",
                Some(CheckKind::NoSlip) => "what is to roll slips",
                Some(CheckKind::Taut) => "a cord does not pull",
                Some(CheckKind::Pressed) => "a body is not pressed on its surface",
                _ => "a condition does not hold",
            };
            format!("the motion that follows does not go as it is said to: {what}")
        }
        CheckKind::Pressed if c.ok => format!("the {body} is pressed on its surface with {available} N"),
        CheckKind::Pressed => format!("the {body} is not pressed on its surface: normal force {available} N, required more than {required} N"),
        CheckKind::Taut if c.ok => format!("{tie} is taut{looks} with {available} N"),
        CheckKind::Taut => format!("{tie} is not taut: tension {available} N, required more than {required} N"),
        CheckKind::SlipDirection if c.ok => format!("the slip of the {tie} goes against the friction"),
        CheckKind::SlipDirection => format!("the slip of the {tie} does not go against the friction: {available} m/s^2, required more than {required} m/s^2"),
        CheckKind::StartsSlipping if c.ok => format!("the {tie} starts with slip: its contact moves at {available} m/s"),
        CheckKind::StartsSlipping => format!("the {tie} does not slip at the start: its contact is at rest"),
        CheckKind::Closes if c.ok && c.required <= 0.0 => format!("friction ends the slip of the {tie}: mu_k N = {available} N, nothing keeps it up"),
        CheckKind::Closes if c.ok => format!("friction ends the slip of the {tie}: mu_k N = {available} N, {required} N keep it up"),
        CheckKind::Closes => format!("friction does not end the slip of the {tie}: {required} N keep it up, mu_k N = {available} N"),
        CheckKind::Slack => slack(scene, c),
        CheckKind::SlipEnds if c.available.is_infinite() => format!("the {tie} slips at the end, after {required} s: its slip does not end"),
        CheckKind::SlipEnds => {
            let when = if c.required < c.available { "still slips" } else { "rolls" };
            format!("the {tie} {when} at the end, after {required} s: its slip ends after {available} s")
        }
        CheckKind::UnderWay => format!("the {tie} is on its way at the end: it moves at {available} m/s"),
        CheckKind::StaticLimit => {
            let can = if c.required <= c.available { "could" } else { "could not" };
            format!("static friction {can} hold the {tie} rolling: that needs {required} N, mu_s N = {available} N")
        }
        CheckKind::Reaches => reaches(scene, c),
    }
}

/// Is the end reached, and how far does the motion go?
#[rustfmt::skip] // a table
fn reaches(scene: &Scene, c: &Check) -> String {
    let unit = scene.measure();
    let (required, available) = (figures(c.required), figures(c.available));
    let (pinned, endless) = (scene.pinned().is_some() || scene.lead().is_some(), c.available.is_infinite());
    if scene.end == End::Equilibrium {
        return "the end is not reached: there is no stable equilibrium in the way in which it sets off"
            .to_owned();
    }
    if let End::Leaves(joint) = scene.end {
        let name = &scene.joints[joint].name;
        return if c.ok {
            format!("the end is reached: `{name}` is left")
        } else {
            format!("the end is not reached: `{name}` is not left before it comes to rest or leaves another")
        };
    }
    let name = scene.bodies.get(c.of).map_or("?", |b| b.name.as_str());
    let then = if scene.growths.is_empty() {
        format!("what comes after a turning point is a motion of its own: write `end: {{turning point: {name}}}` and `next: {{end: ...}}`")
    } else {
        "of forces that grow what comes then is told with time, and without other couples: a couple that stays may be a brake".to_owned()
    };
    match (c.ok, matches!(scene.end, End::TurningPoint(_))) {
        // It is reached, and by a motion of no length.
        (false, _) if c.required.total_cmp(&c.available).is_eq() => {
            let started = !scene.starts_from_rest() && scene.ends_at_a_place();
            let then = if started { then } else { "write an end that comes after the start".to_owned() };
            format!("the end lies where the motion starts, and it leaves there; {then}")
        }
        (false, false) if matches!(scene.end, End::Time(..)) && !pinned => {
            let at = if endless { String::new() } else { format!(" at {available} {unit}") };
            format!("the end is not reached: {required} {unit} lie after the turning point{at}, up to which a motion is followed; {then}")
        }
        (true, true) if !endless || pinned => format!("the end is reached: it comes to rest after {available} {unit}"),
        (false, true) if pinned => {
            "the end is not reached: it does not come to rest in two turns, or not before a contact is lost"
                .to_owned()
        }
        (false, true) if endless => "the end is not reached: it never comes to rest".to_owned(),
        (true, _) if endless && pinned => format!("the end is reached: {required} {unit} asked, the motion goes on well beyond"),
        (true, _) if endless => format!("the end is reached: {required} {unit} asked, the motion goes on without end"),
        (true, _) => format!("the end is reached: {required} {unit} asked, the motion goes as far as {available} {unit}"),
        (false, _) if endless && pinned && c.required >= 0.0 => format!("the end is not reached: {required} {unit} asked; a motion is followed up to its turning point or the loss of a contact, for two turns at most"),
        (false, _) if !scene.growths.is_empty() && scene.heading.is_none() && c.required >= 0.0 => format!("the end is not reached: {required} {unit} asked, the motion turns before"),
        (false, _) if c.required < 0.0 => {
            let way = figures(-c.required);
            let on = if endless || pinned { String::new() } else { format!(" and turns after {available} {unit}; {then}") };
            format!("the end is not reached: it lies {way} {unit} from the start, and the motion goes the other way{on}")
        }
        (false, _) if endless || c.required < c.available => format!("the end is not reached: {required} {unit} asked, the motion goes the other way"),
        (false, _) => format!("the end is not reached: {required} {unit} asked, the motion goes only as far as {available} {unit}"),
    }
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
            text.push_str(&format!(
                "; the tolerance {asked:e} was raised to {rtol:e}, below which a step shows only rounding"
            ));
        }
        None if taken.worst > asked => {
            text.push_str(&format!(
                "; the tolerance {asked:e} is not met: {:.1e} is the estimate, most of it rounding",
                taken.worst
            ));
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
        (true, Method::Closed, Force::Switched) => "the forces are the same all the way up to the start of rolling and from there on, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::OfTime) => "the forces grow with a power of time or place, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::Linear) => "the force changes in proportion to the displacement, so the closed form is exact and nothing is cheaper",
        (true, Method::Closed, Force::Pendulum) => "under its weight alone the time is an elliptic integral, known to rounding, and nothing is cheaper",
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
        _ => format!("{}, {}", rung.method().name(), setting(rung)),
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
    format!("the {what} of `{}`", scene.bodies.get(of.body).map_or("?", |b| b.name.as_str()))
}

/// What the program does not solve.
#[rustfmt::skip] // a table
const fn unsupported(what: Unsupported) -> &'static str {
    match what {
        Unsupported::SpringWithTwoFreedoms => "a spring where two coordinates are free is solved at an instant alone",
        Unsupported::StartHeld => "the start gives a speed to what the ties hold at rest; take it away, or one of the ties",
        Unsupported::SpringWithSlip => "a spring where something slips is solved at an instant alone",
        Unsupported::SlipShared => "a contact is said to slip where other ties hold it, too: what friction it would need is open",
        Unsupported::EqualByChance => "two data are equal, and only so the ties leave another number of freedoms: such data are not solved",
        Unsupported::SlidesInTurn => "of the bodies that slide here one stays or moves on account of what another does, or is not pressed on its surface; that is not solved",
        Unsupported::SlackBetween => "the cord of the spring is slack where the motion ends, and the one that follows draws it tight; end the motion before the cord goes slack, or leave the spring out under `next`",
        Unsupported::NotThrown => "only a body that slips and starts with a speed or a spin begins to roll",
        Unsupported::MovingLamina => "of a body of particles only what holds at the instant can be asked; write `end: at once`",
        Unsupported::PinnedInCompany => "a pinned body is alone in its scene, without ties; it ends at an angle, a time, a speed or a turning point",
        Unsupported::Overwound => "a torsion spring may be wound by less than half a turn, from the start to the end",
        Unsupported::InLine => "two hinged rods come to lie in one line on the way, or a rod lies across its guide: from there the linkage can go on in two ways, and it is not followed; let the motion end before",
        Unsupported::FrictionTurns => "a point that rubs stands still or turns back in its guide, or it is open on which side of the guide it presses",
    }
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
        let body = scene.bodies.get(at.body).map_or("?", |b| &b.name);
        format!(
            "`{body}`: `{}` lies at {}; `side: behind` puts it at {} (`side: ahead` says that it is meant so)",
            point(scene, at),
            at_place(here, there),
            at_place(there, here)
        )
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
        Some(format!(
            "`{}` in `{}` is the answer to the question of that name, not the quantity; another id leaves the quantity its name",
            answer.id, other.id
        ))
    });
    told.collect()
}

/// Why a scene with these data has no answer; a sentence each.
pub fn refusal(problem: &Problem, scene: &Scene, refusal: &Refusal) -> Vec<String> {
    match refusal {
        Refusal::Inadmissible(faults) => faults.iter().map(|f| inadmissible(problem, scene, f)).collect(),
        Refusal::NextInadmissible(faults) => {
            let next = scene.formulas.others.iter().find(|(how, _)| *how == AsIf::Next);
            let told = |f| {
                let why = inadmissible(problem, next.map_or(scene, |(_, next)| next), f);
                format!(
                    "in the motion that follows {why} (places, angles and times count from the start of the whole)"
                )
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
    match why {
        Refusal::NotFound => format!(
            "no value of {unknown} in its range gives the measured {measured}; one with which the motion only just gets there, or a contact only just holds on the way, is not found"
        ),
        Refusal::NotUnique(Some(value)) => {
            let (lacks, has) = match scene.end {
                End::AtOnce => ("the bodies do not hold or move as declared", "they do"),
                _ => ("the motion does not get there", "it does"),
            };
            let value = in_unit(problem, scene, *value);
            format!(
                "in a part of the range of {unknown} there is no {measured} to measure: with {value}, say, {lacks}; narrow `unknown:` to the values with which {has}"
            )
        }
        _ => format!(
            "it cannot be shown that only one value of {unknown} in its range gives the measured {measured}; narrow `unknown:`, or measure a speed at a place, not where it turns nor after friction in a guide"
        ),
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
    let sprung = !scene.struts.is_empty() || scene.pinned().is_some_and(|(_, pin)| pin.spring.is_some());
    let spring =
        if sprung { ", or a spring passes its anchor, where its force has no direction" } else { "" };
    if value.is_finite() && gap.is_finite() {
        format!(
            "an integral over the motion does not settle: a part of it is {value:e}, and halving its panels still changes that by {gap:e}; the motion all but stops before its end{spring}. No answer is given."
        )
    } else {
        format!(
            "an integral over the motion has no value: the motion stops before its end{spring}. No answer is given."
        )
    }
}

/// A refusal of one sentence.
fn refused(problem: &Problem, scene: &Scene, refusal: &Refusal) -> String {
    match refusal {
        // Those are several sentences.
        Refusal::Inadmissible(_) | Refusal::NextInadmissible(_) => String::new(),
        Refusal::Singular { unknowns, rank } => {
            let nothing = Mass::Kilograms(Num::Fixed(0.0));
            let light = scene.bodies.iter().any(|b| b.planar.is_some() && b.mass == nothing);
            let why =
                if light { "; what has a mass of 0 needs a body with mass that moves with it" } else { "" };
            format!("the equations do not determine the motion: {unknowns} unknowns, rank {rank}{why}")
        }
        Refusal::NotFound | Refusal::NotUnique(_) => not_found(problem, scene, refusal),
        Refusal::Freedoms(0) if !scene.joints.is_empty() => {
            "the joints leave nothing free to move: a motion needs one freedom".to_owned()
        }
        Refusal::Freedoms(n) if !scene.joints.is_empty() => format!(
            "the joints leave {n} freedoms: a motion needs one, or `end: at once` from rest, where each body may have its `angle` and \
             be `placed:`"
        ),
        Refusal::Unplaced(_)
        | Refusal::IdleSide { .. }
        | Refusal::Unbridged { .. }
        | Refusal::Tilted { .. }
        | Refusal::Crossed(_)
        | Refusal::Parted { .. }
        | Refusal::Moved { .. } => misplaced(scene, refusal),
        Refusal::Freedoms(n) => {
            format!("the ties leave {n} freedoms; the program solves one, or two where something slips")
        }
        Refusal::Open(of) => format!(
            "the start leaves {} open: neither the speeds that are given nor the ties determine it",
            velocity(scene, *of)
        ),
        Refusal::Contradiction { of, given, follows } => {
            let unit = if of.degree == Degree::Along { "m/s" } else { "rad/s" };
            format!(
                "the start contradicts the ties: it gives {} as {} {unit}, but {} {unit} follows from the ties and the rest of \
                 the start",
                velocity(scene, *of),
                rounded(*given, 5),
                rounded(*follows, 5)
            )
        }
        Refusal::Unsupported(what) => unsupported(*what).to_owned(),
        Refusal::Trouble { method, trouble: why } => format!("{}: {}", method.name(), trouble(why)),
        Refusal::Unsteady { method, label, value, finer } => format!(
            "{} does not settle on {}: {value:e}, and {finer:e} when set finer; take a smaller step or tolerance",
            method.name(),
            scene.name_of(*label)
        ),
        Refusal::Contradicts { method, label, value, judge, allowed } => format!(
            "{} and {} disagree on {}: {value:e} against {judge:e}; only {} would lie within both error estimates. Nothing is published.",
            method.name(),
            if *method == Method::Gauss { "the equations of motion" } else { "work and energy" },
            scene.name_of(*label),
            rounded(*allowed, 2)
        ),
        Refusal::Unmet { method, points, error, asked } => format!(
            "{} does not get there: with {points} points its estimated error is {error:.1e} of an answer, above {asked:.1e}; auto finds what does",
            method.name()
        ),
        Refusal::Apart => {
            "the data lie so many powers of ten apart that products of them leave the double-precision numbers, in whatever units they are computed. No answer is given."
                .to_owned()
        }
        Refusal::NoMethod { method } => {
            format!("{} does not apply to this scene; auto finds what does", method.name())
        }
        Refusal::Unsettled(why) => unsettled(scene, why),
        Refusal::Disagree { label, eom, energy, allowed } if *allowed < 1.0 => format!(
            "the equations of motion and work and energy disagree on {}: {eom:e} against {energy:e}; a relative gap of {allowed:.1e} would be accepted. No key is published.",
            scene.name_of(*label)
        ),
        Refusal::Disagree { label, eom, energy, .. } => format!(
            "the equations of motion and work and energy disagree on {}: {eom:e} against {energy:e}; the last digits of the data decide it, and no digit of it is the same in both. No key is published.",
            scene.name_of(*label)
        ),
    }
}

/// Why joined bodies are not put where the joints and the data say.
fn misplaced(scene: &Scene, refusal: &Refusal) -> String {
    let name = |body: usize| scene.bodies.get(body).map_or("?", |b| b.name.as_str());
    let when = |at_start| if at_start { "at the start" } else { "on the way" };
    match refusal {
        Refusal::Unplaced(index) => format!(
            "the joints do not place `{}` on the way: a body is placed that leads, is welded, or is pinned or hinged to what has a \
             place and either guided at another point, by a cord or a light rod too, or hinged there to a second such body",
            name(*index)
        ),
        Refusal::IdleSide { body, with } => {
            let why = with.map_or_else(
                || "decides nothing: there is one place for it; take it away".to_owned(),
                |with| {
                    format!(
                        "contradicts that in `{}`: the two are placed together; write it in one of them",
                        name(with)
                    )
                },
            );
            format!("`side:` in `{}` {why}", name(*body))
        }
        Refusal::Unbridged { gap: Gap { body, other, apart_m, bridged_m }, at_start } => {
            let (with, it, bridge) = match other {
                Some(other) => (format!(" and `{}`", name(*other)), "them", "they bridge"),
                None => (String::new(), "it", "it bridges"),
            };
            format!(
                "`{}`{with} cannot be put in place {}: what holds {it} is {} m apart, and {bridge} at {} {} m; change the lengths, \
                 the angle at the start, or the places of the joints",
                name(*body),
                when(*at_start),
                figures(*apart_m),
                if apart_m > bridged_m { "most" } else { "least" },
                figures(*bridged_m)
            )
        }
        Refusal::Tilted { body, given_deg, follows_deg } => format!(
            "the start contradicts the joints: it gives the angle of `{}` as {} deg, and they put it at {} deg; leave that angle out \
             (of two places `side:` says which is meant)",
            name(*body),
            figures(*given_deg),
            figures(*follows_deg)
        ),
        Refusal::Crossed(Choice { at, here, there, .. }) => format!(
            "the links at `{}` are a parallelogram, with equal opposite sides, and would lie crossed, with that point at {}; write \
             `side: behind` in `{}` for the parallelogram, with it at {}, or `side: ahead` for the crossed linkage",
            point(scene, *at),
            at_place(*here, *there),
            name(at.body),
            at_place(*there, *here)
        ),
        Refusal::Parted { joint, off_m, at_start } => {
            let name = scene.joints.get(*joint).map_or("?", |j| j.name.as_str());
            let when = when(*at_start);
            format!(
                "the joint `{name}` cannot be met {when}: where the other joints and the data put the bodies, it is {} m off; \
                 change the lengths, the angle at the start, `placed:`, or the place of the joint",
                figures(*off_m)
            )
        }
        Refusal::Moved { body, off_m } => format!(
            "the motion that follows does not begin where the one before it ends: `{}` would be {} m off; under `next` keep the \
             joints that place it as they are",
            name(*body),
            figures(*off_m)
        ),
        _ => String::new(),
    }
}

/// The right answer of a key, rounded for a person: `30.26 rad/s`, `62.6 N up`, `yes`.
pub fn right_answer(words: &Words, entry: &KeyEntry, signs: [&str; 2]) -> String {
    match &entry.answer {
        Answer::Word { right, .. } => words.of_key(right).to_owned(),
        Answer::Number { value, directed, .. } => {
            let value = entry.unit.from_si(*value);
            if *directed && value != 0.0 {
                let word = if value > 0.0 { signs[0] } else { signs[1] };
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

    /// The words were only read with speeds above 0.
    #[test]
    fn a_start_speed_of_nothing_is_not_said_to_move_it() {
        let turn = crate::scene::Coordinate { body: 0, degree: crate::scene::Degree::Turn };
        let zero = crate::scene::Num::Fixed(0.0);
        let scene = Scene {
            gravity_m_s2: zero,
            bodies: vec![],
            ties: vec![],
            couples: vec![],
            joints: vec![],
            pushes: vec![],
            struts: vec![],
            growths: vec![],
            carried: None,
            start: vec![crate::scene::Start::Speed(turn, zero)],
            end: End::TurningPoint(turn),
            heading: None,
            span: Span::ToEnd,
            formulas: crate::scene::Formulas::default(),
        };
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
}
