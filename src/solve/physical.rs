//! What really happens: the word of the regime, and the conditions under which the declared ties hold.
use crate::num::{Dd, Real};
use crate::scene::{End, Heading, Label, Line, Owner, Quantity, Scene, Slope, Tie};
use crate::solve::outcome::{Check, CheckKind, Course, Held, Motion, Regime, Road, Throw, Word};

/// A share by which a draw is judged; nothing on a page.
fn margin<P: Real>(available: P, required: P) -> f64 {
    let larger = available.size().max(required.size());
    if larger == 0.0 {
        0.0
    } else if !available.is_finite() {
        1.0
    } else {
        (available - required).f64() / larger
    }
}

/// Sense in which the ending coordinate is declared to move.
fn heading(scene: &Scene, sense: f64) -> f64 {
    match scene.heading {
        Some(Heading::Forward) => 1.0,
        Some(Heading::Back) => -1.0,
        None => sense,
    }
}

/// Fills in the numbers of [`CheckKind::Moves`]: what drives and what resists at the start, known to one road only.
/// Drive and resistance within 8 u of each other are a balance: the regime then says so, whatever rounding of the data decided.
pub fn fill_drive<P: Real>(
    scene: &Scene,
    sense: f64,
    drive: (P, P),
    (regime, checks, words): (&mut Regime, &mut [Check], &mut [(Label, Word)]),
) {
    let slips = scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. }));
    let balanced = scene.starts_from_rest() && !slips && drive.0.status(drive.1) == 0.0 && !drive.0.is_zero();
    if balanced {
        let held = scene.is_sprung() || scene.bodies.iter().any(|b| b.planar.is_some());
        regime.motion = if held { Motion::Rest } else { Motion::Balanced };
        for (_, word) in words.iter_mut().filter(|(l, _)| l.quantity == Quantity::Direction) {
            *word = Word::Stays;
        }
    }
    let against = heading(scene, sense) * sense < 0.0;
    let (push, hold) = if against { (drive.1, drive.0) } else { drive };
    for check in checks.iter_mut().filter(|c| c.kind == CheckKind::Moves) {
        check.ok &= !balanced;
        check.required = hold.f64();
        check.available = push.f64();
        // What is thrown or struck needs no drive.
        check.margin = if scene.starts_from_rest() { margin(push, hold) } else { 1.0 };
    }
}

/// Regime, checks and words of a scene, from one road.
pub fn judge_road<P: Real>(scene: &Scene, road: &Road<P>) -> (Regime, Vec<Check>, Vec<(Label, Word)>) {
    if let Some(course) = &road.course {
        return judge(scene, course, &road.held);
    }
    // Of an instant it is not asked which way it would go and how far.
    let (regime, mut checks, mut words) = judge(scene, &Course::at_rest(), &road.held);
    checks.retain(|c| c.kind != CheckKind::Moves);
    words.retain(|(label, _)| label.quantity != Quantity::Direction);
    (Regime { motion: Motion::Instant, ..regime }, checks, words)
}

/// Whether the motion that follows goes as it is said to, from one road.
pub fn judge_next<P: Real>(scene: &Scene, road: &Road<P>) -> Check {
    let (_, checks, _) = judge_road(scene, road);
    // What drives it is known to one road only, and what was set moving needs no drive.
    let share = |c: &Check| if c.kind == CheckKind::Moves { 1.0 } else { c.margin };
    let worst = checks.iter().min_by(|a, b| a.ok.cmp(&b.ok).then(share(a).total_cmp(&share(b))));
    let (ok, margin) = worst.map_or((true, 1.0), |c| (c.ok, share(c)));
    let of = CheckKind::ALL.iter().position(|k| worst.is_some_and(|c| c.kind == *k)).unwrap_or(0);
    Check { kind: CheckKind::Next, of, ok, required: 0.0, available: margin, margin }
}

/// Regime, checks and words of a scene that moves, from the course and the contacts of one road.
fn judge<P: Real>(
    scene: &Scene,
    course: &Course<P>,
    held: &[Held<P>],
) -> (Regime, Vec<Check>, Vec<(Label, Word)>) {
    let mut checks = Vec::with_capacity(6);
    let mut words = Vec::with_capacity(2);
    let end = scene.ending_coordinate();
    let body = &scene.bodies[end.body];
    let thrown = held.iter().any(|h| matches!(h, Held::Thrown(_)));
    // What is thrown needs no drive.
    if !thrown {
        let goes = course.sense != 0.0 && heading(scene, course.sense) * course.sense > 0.0;
        checks.push(Check { ok: goes, margin: 0.0, ..positive(CheckKind::Moves, end.body, 0.0, 0.0) });
    }
    for h in held {
        check(scene, h, &mut checks);
        words.extend(rolling(scene, h).map(|(tie, holds)| (rolls(scene, tie), yes_or_no(holds))));
    }
    // The start of rolling has its own checks.
    if if thrown { !matches!(scene.end, End::Rolling(_) | End::AtOnce) } else { course.sense != 0.0 } {
        checks.push(reaches(end.body, course));
    }
    // The turn of a body has no such word.
    if body.planar.is_none() {
        let way = way(body.line, course.way).map_or(Word::Stays, |way| way.word);
        words.push((Label { quantity: Quantity::Direction, of: Owner::Body(end.body) }, way));
    }
    let needs =
        held.iter().any(|h| matches!(h, Held::Rolling(..)) && rolling(scene, h).is_some_and(|r| !r.1));
    (Regime { motion: motion(scene, course, held), slips: needs }, checks, words)
}

/// A way along a line, with the words of it: seen along the line, of what moves, of what slips, and of what has a spring, where it
/// gets to its end, just gets there, or does not.
struct Way {
    word: Word,
    moves: Motion,
    slips: Motion,
    ends: [Motion; 3],
}

#[rustfmt::skip] // a table
const WAYS: [Way; 4] = {
    use Motion as M;
    [
        Way { word: Word::Up, moves: M::MovesUp, slips: M::SlipsUp, ends: [M::UpOk, M::UpTurningPoint, M::UpUnreachable] },
        Way { word: Word::Down, moves: M::MovesDown, slips: M::SlipsDown, ends: [M::DownOk, M::DownTurningPoint, M::DownUnreachable] },
        Way { word: Word::Forward, moves: M::MovesForward, slips: M::SlipsForward, ends: [M::ForwardOk, M::ForwardTurningPoint, M::ForwardUnreachable] },
        Way { word: Word::Back, moves: M::MovesBack, slips: M::SlipsBack, ends: [M::BackOk, M::BackTurningPoint, M::BackUnreachable] },
    ]
};

/// The way in which a body moves. Up or down is geometry: a line that leads down turns the words.
fn way(line: Option<Line>, sense: f64) -> Option<&'static Way> {
    let sloped = line.is_some_and(|l| l.slope != Slope::Level);
    let upward = if line.is_none_or(|l| l.forward_up) { sense } else { -sense };
    let back = match upward {
        u if u > 0.0 => 0,
        u if u < 0.0 => 1,
        _ => return None,
    };
    Some(&WAYS[if sloped { back } else { 2 + back }])
}

/// The word of the regime.
fn motion<P: Real>(scene: &Scene, course: &Course<P>, held: &[Held<P>]) -> Motion {
    let slides_on = |h: &Held<P>| match h {
        Held::Rolling(tie, most, Some(available)) => slides(scene, *tie) && !within(*most, *available),
        _ => false,
    };
    let thrown = |h: &Held<P>| if let Held::Thrown(t) = h { Some(*t).filter(|t| t.known) } else { None };
    let slipping = |h: &Held<P>| match h {
        Held::Slipping(tie, friction, available, _, sense) => {
            Some((*tie, friction.abs().status(*available), *sense))
        }
        _ => None,
    };
    // Of several that slip that of the body whose motion is asked.
    let end = scene.ending_coordinate().body;
    let asked = |t: &Throw| scene.ties[t.tie].rubbing().is_some_and(|rub| rub.body == end);
    let throws = || held.iter().filter_map(thrown);
    if let Some(throw) = throws().find(asked).or_else(|| throws().next()) {
        return match (throw.slips, throw.closes, throw.holds) {
            (true, false, _) => Motion::Never,
            (_, _, false) => Motion::SlipsThrough,
            (false, _, true) => Motion::RollsAtStart,
            (true, true, true) => Motion::RollsAfter,
        };
    }
    if held.iter().any(slides_on) {
        return Motion::SlipsThrough;
    }
    if let Some((tie, needs, sense)) = held.iter().find_map(slipping) {
        let line = match &scene.ties[tie] {
            Tie::Slip { body, .. } => scene.bodies[*body].line,
            _ => None,
        };
        return match needs {
            s if s < 0.0 => Motion::Rolls,
            0.0 => Motion::AtLimit,
            _ => way(line, sense).map_or(Motion::SpinsInPlace, |way| way.slips),
        };
    }
    let just = course.asked.is_some_and(|asked| asked.status(course.farthest) == 0.0);
    let end = match course.reached {
        _ if just => 1,
        true => 0,
        false => 2,
    };
    let body = &scene.bodies[scene.ending_coordinate().body];
    // What spins in place is told by its turn.
    let way = way(body.line, if course.way == 0.0 { course.sense } else { course.way });
    if body.planar.is_some() {
        let swings = [Motion::SwingsOk, Motion::SwingsTurningPoint, Motion::SwingsUnreachable];
        if course.sense == 0.0 { Motion::Rest } else { swings[end] }
    } else if scene.is_sprung() {
        way.map_or(Motion::Rest, |way| way.ends[end])
    } else {
        way.map_or(Motion::Balanced, |way| way.moves)
    }
}

/// Does the end come, and after the start?
fn reaches<P: Real>(body: usize, course: &Course<P>) -> Check {
    let asked = course.asked.unwrap_or_else(P::zero);
    // Where it sets off is no end of it.
    let leaves = course.ends_where_it_starts();
    let available = if leaves { asked } else { course.farthest };
    let check = limit(CheckKind::Reaches, body, course.reached && !leaves, asked, available);
    let margin = match course.asked {
        _ if leaves => -1.0,
        // What just gets over something may as well not.
        Some(_) => f64::min(check.margin, course.slowest),
        None => course.slowest,
    };
    Check { margin, ..check }
}

/// The conditions of one contact or cord.
fn check<P: Real>(scene: &Scene, held: &Held<P>, checks: &mut Vec<Check>) {
    let one = match *held {
        Held::Thrown(ref throw) => return throw_checks(scene, throw, checks),
        Held::Rolling(_, _, None) => return,
        Held::Pressed(body, normal) => positive(CheckKind::Pressed, body, normal, 1.0),
        Held::Touching(joint, least, most) => {
            let pushes = scene.joints[joint].kind.only_pushes();
            positive(if pushes { CheckKind::Pressed } else { CheckKind::Taut }, joint, least, least / most)
        }
        Held::Jolted(joint, impulse, all) => positive(CheckKind::HoldsBlow, joint, impulse, impulse / all),
        Held::Cord(tie, tension, share) => positive(CheckKind::Taut, tie, tension, share),
        Held::Met(strut, met, end) => {
            let check = limit(CheckKind::Met, strut, met < end, Dd::new(met), Dd::new(end));
            Check { margin: if met.is_finite() { check.margin } else { -1.0 }, ..check }
        }
        Held::Rolling(tie, most, Some(available)) => {
            limit(CheckKind::NoSlip, tie, within(most, available), most, available)
        }
        Held::Slipping(tie, friction, available, against, _) => {
            let needs = friction.abs();
            checks.push(limit(CheckKind::MustSlip, tie, needs.status(available) > 0.0, available, needs));
            let check = positive(CheckKind::SlipDirection, tie, against.f64(), 0.0);
            Check { ok: against.sign() > 0.0, margin: against.sign(), ..check }
        }
        // Nobody can say that it holds.
        Held::Open(tie) => {
            let cord = matches!(scene.ties[tie], Tie::Cord(_));
            positive(if cord { CheckKind::Taut } else { CheckKind::NoSlip }, tie, f64::NAN, 0.0)
        }
        Held::Slack(tie, asked, slack) => switch(CheckKind::Slack, tie, asked.f64(), slack.f64()),
    };
    checks.push(one);
}

/// The contact that could roll, and whether it does.
fn rolling<P: Real>(scene: &Scene, held: &Held<P>) -> Option<(usize, bool)> {
    match held {
        // Does it come to roll, and not only: could it?
        Held::Thrown(throw) => {
            (throw.known && (throw.closes || !throw.slips)).then_some((throw.tie, throw.holds))
        }
        Held::Rolling(tie, most, Some(available)) if !slides(scene, *tie) => {
            Some((*tie, within(*most, *available)))
        }
        Held::Slipping(tie, friction, available, ..) => {
            Some((*tie, friction.abs().status(*available) <= 0.0))
        }
        _ => None,
    }
}

fn slides(scene: &Scene, tie: usize) -> bool {
    matches!(scene.ties[tie], Tie::Slide { .. })
}

fn within<P: Real>(needed: P, available: P) -> bool {
    needed.status(available) <= 0.0
}

const fn yes_or_no(holds: bool) -> Word {
    if holds { Word::Yes } else { Word::No }
}

/// What has to be above 0: by how much where it is.
fn positive(kind: CheckKind, of: usize, available: f64, share: f64) -> Check {
    let ok = available > 0.0;
    Check { kind, of, ok, required: 0.0, available, margin: if ok { share } else { -1.0 } }
}

/// What may not be above what there is.
fn limit<P: Real>(kind: CheckKind, of: usize, ok: bool, required: P, available: P) -> Check {
    let margin = margin(available, required);
    Check { kind, of, ok, required: required.f64(), available: available.f64(), margin }
}

/// The conditions of a throw: it slips, friction ends the slip, and holds what follows. What comes after the end is not asked.
fn throw_checks(scene: &Scene, t: &Throw, checks: &mut Vec<Check>) {
    let holds = |kind: CheckKind, ok: bool, required: f64, available: f64| {
        limit(kind, t.tie, ok, Dd::new(required), Dd::new(available))
    };
    checks.push(positive(CheckKind::StartsSlipping, t.tie, t.slip, t.slip / t.speeds));
    let rubs = scene.ties[t.tie].rubbing();
    if t.known
        && t.slips
        && matches!(scene.end, End::Rolling(c) if rubs.is_some_and(|rub| rub.body == c.body))
    {
        checks.push(holds(CheckKind::Closes, t.closes, t.upkeep, t.kinetic));
    }
    if t.known {
        checks.push(match t.to_roll {
            true => holds(CheckKind::NoSlip, t.holds, t.needed, t.available),
            false => switch(CheckKind::StaticLimit, t.tie, t.needed, t.available),
        });
    }
    // What follows holds however it is: its margins alone count, for a draw.
    if let (true, Some((asked, until))) = (t.known && t.slips, t.times) {
        checks.push(switch(CheckKind::SlipEnds, t.tie, asked, until));
    }
    if let Some((speed, speeds)) = t.at_end {
        let margin = if speeds > 0.0 { speed / speeds } else { 0.0 };
        let check = positive(CheckKind::UnderWay, t.tie, speed, margin);
        checks.push(Check { ok: true, margin, ..check });
    }
}

/// A switch and what is asked, on whichever side of it.
fn switch(kind: CheckKind, of: usize, required: f64, available: f64) -> Check {
    let check = limit(kind, of, true, Dd::new(required), Dd::new(available));
    Check { margin: check.margin.abs(), ..check }
}

fn rolls(scene: &Scene, tie: usize) -> Label {
    let of = scene.ties[tie].touching().map_or(Owner::Tie(tie), Owner::Body);
    Label { quantity: Quantity::Rolls, of }
}
