//! What really happens: the word of the regime, and the conditions under which the declared ties hold.
use crate::num::{Dd, Real};
use crate::scene::{End, Heading, Label, Owner, Quantity, Scene, Slope, Tie};
use crate::solve::outcome::{Check, CheckKind, Course, Held, Motion, Regime, Road, Throw, Word};

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
        let held = scene.is_sprung() || scene.bodies.iter().any(|b| b.pin.is_some() || b.planar.is_some());
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

/// Regime, checks and words of an instant: which way it would go and how far is not asked.
fn judge_instant<P: Real>(scene: &Scene, held: &[Held<P>]) -> (Regime, Vec<Check>, Vec<(Label, Word)>) {
    let (regime, mut checks, mut words) = judge(scene, &Course::at_rest(), held);
    checks.retain(|c| c.kind != CheckKind::Moves);
    words.retain(|(label, _)| label.quantity != Quantity::Direction);
    (Regime { motion: Motion::Instant, ..regime }, checks, words)
}

/// Regime, checks and words of a scene, from one road.
pub fn judge_road<P: Real>(scene: &Scene, road: &Road<P>) -> (Regime, Vec<Check>, Vec<(Label, Word)>) {
    match &road.course {
        Some(course) => judge(scene, course, &road.held),
        None => judge_instant(scene, &road.held),
    }
}

/// Whether the motion that follows goes as it is said to, from one road.
pub fn judge_next<P: Real>(scene: &Scene, road: &Road<P>) -> Check {
    let (_, checks, _) = judge_road(scene, road);
    // What drives it is known to one road only, and what was set moving needs no drive.
    let share = |c: &Check| if c.kind == CheckKind::Moves { 1.0 } else { c.margin };
    let worst = if cfg!(feature = "program") {
        checks.iter().min_by(|a, b| a.ok.cmp(&b.ok).then(share(a).total_cmp(&share(b))))
    } else {
        checks.iter().find(|c| !c.ok)
    };
    let (ok, margin) = worst.map_or((true, 1.0), |c| (c.ok, share(c)));
    let of = CheckKind::ALL.iter().position(|k| worst.is_some_and(|c| c.kind == *k)).unwrap_or(0);
    Check { kind: CheckKind::Next, of, ok, required: 0.0, available: margin, margin }
}

/// Regime, checks and words of a scene that moves, from the course and the contacts of one road.
#[expect(clippy::float_cmp, reason = "senses are exactly -1, 0 or 1")]
fn judge<P: Real>(
    scene: &Scene,
    course: &Course<P>,
    held: &[Held<P>],
) -> (Regime, Vec<Check>, Vec<(Label, Word)>) {
    let mut checks = Vec::with_capacity(6);
    let mut words = Vec::with_capacity(2);
    let end = scene.ending_coordinate();
    let body = &scene.bodies[end.body];
    // Up or down is geometry: a line that leads down turns the words.
    let (sloped, upward) = match body.line {
        Some(line) => {
            (line.slope != Slope::Level, if line.forward_up { course.sense } else { -course.sense })
        }
        None => (false, course.sense),
    };
    let heading = heading(scene, course.sense);
    let slipping = held.iter().find_map(|h| match h {
        Held::Slipping(tie, friction, available, _, sense) => Some((*tie, *friction, *available, *sense)),
        _ => None,
    });
    checks.push(Check {
        kind: CheckKind::Moves,
        of: end.body,
        ok: course.sense != 0.0 && heading == course.sense,
        required: 0.0,
        available: 0.0,
        margin: 0.0,
    });
    let (mut slips, mut slips_on) = (false, false);
    let thrown = held.iter().find_map(|h| match h {
        Held::Thrown(t) => Some(*t),
        _ => None,
    });
    if thrown.is_some() {
        // What is thrown needs no drive.
        checks.clear();
    }
    for h in held {
        match h {
            Held::Thrown(t) => {
                throw_checks(scene, t, &mut checks);
                words.push((rolls(scene, t.tie), if t.holds { Word::Yes } else { Word::No }));
            }
            Held::Pressed(body, normal) => checks.push(Check {
                kind: CheckKind::Pressed,
                of: *body,
                ok: *normal > 0.0,
                required: 0.0,
                available: *normal,
                margin: if *normal > 0.0 { 1.0 } else { -1.0 },
            }),
            Held::Touching(joint, least, most) => checks.push(Check {
                kind: if scene.joints[*joint].kind.only_pushes() {
                    CheckKind::Pressed
                } else {
                    CheckKind::Taut
                },
                of: *joint,
                ok: *least > 0.0,
                required: 0.0,
                available: *least,
                margin: if *least > 0.0 { *least / *most } else { -1.0 },
            }),
            Held::Jolted(joint, impulse, all) => checks.push(Check {
                kind: CheckKind::HoldsBlow,
                of: *joint,
                ok: *impulse > 0.0,
                required: 0.0,
                available: *impulse,
                margin: if *impulse > 0.0 { *impulse / *all } else { -1.0 },
            }),
            Held::Met(strut, met, end) => checks.push(Check {
                kind: CheckKind::Met,
                of: *strut,
                ok: met < end,
                required: *met,
                available: *end,
                margin: if met.is_finite() { margin(Dd::new(*end), Dd::new(*met)) } else { -1.0 },
            }),
            Held::Rolling(tie, most, Some(available)) => {
                let holds = most.status(*available) <= 0.0;
                let slides = matches!(scene.ties[*tie], Tie::Slide { .. });
                slips |= !holds && !slides;
                slips_on |= !holds && slides;
                checks.push(Check {
                    kind: CheckKind::NoSlip,
                    of: *tie,
                    ok: holds,
                    required: most.f64(),
                    available: available.f64(),
                    margin: margin(*available, *most),
                });
                if !slides {
                    words.push((rolls(scene, *tie), if holds { Word::Yes } else { Word::No }));
                }
            }
            Held::Rolling(_, _, None) => {}
            Held::Slipping(tie, friction, available, against, _) => {
                let needs = friction.abs();
                let must = needs.status(*available) > 0.0;
                checks.push(Check {
                    kind: CheckKind::MustSlip,
                    of: *tie,
                    ok: must,
                    required: available.f64(),
                    available: needs.f64(),
                    margin: margin(needs, *available),
                });
                checks.push(Check {
                    kind: CheckKind::SlipDirection,
                    of: *tie,
                    ok: against.sign() > 0.0,
                    required: 0.0,
                    available: against.f64(),
                    margin: against.sign(),
                });
                words.push((rolls(scene, *tie), if must { Word::No } else { Word::Yes }));
            }
            // Nobody can say that it holds.
            Held::Open(tie) => checks.push(Check {
                kind: if matches!(scene.ties[*tie], Tie::Cord(_)) {
                    CheckKind::Taut
                } else {
                    CheckKind::NoSlip
                },
                of: *tie,
                ok: false,
                required: 0.0,
                available: f64::NAN,
                margin: -1.0,
            }),
            Held::Cord(tie, tension, share) => checks.push(Check {
                kind: CheckKind::Taut,
                of: *tie,
                ok: *tension > 0.0,
                required: 0.0,
                available: *tension,
                margin: if *tension > 0.0 { *share } else { -1.0 },
            }),
            Held::Slack(tie, asked, slack) => {
                checks.push(switch(CheckKind::Slack, *tie, asked.f64(), slack.f64()));
            }
        }
    }
    let asked = course.asked.unwrap_or_else(P::zero);
    let place = asked.status(course.farthest);
    let watched = match thrown {
        // The start of rolling has its own checks.
        Some(_) => course.asked.is_some(),
        None => course.sense != 0.0,
    };
    if watched {
        // Where it sets off is no end of it; what moves at the start may end at the speed 0.
        let stops = matches!(scene.end, End::Speed(..)) && !scene.starts_from_rest();
        let leaves = course.asked.is_some_and(|asked| asked.is_zero()) && !stops;
        checks.push(Check {
            kind: CheckKind::Reaches,
            of: end.body,
            ok: course.reached && !leaves,
            required: asked.f64(),
            available: course.farthest.f64(),
            margin: match course.asked {
                _ if leaves => -1.0,
                Some(_) => margin(course.farthest, asked),
                None => 1.0,
            },
        });
    }
    let word = |up: Word, down: Word| {
        if upward > 0.0 {
            up
        } else if upward < 0.0 {
            down
        } else {
            Word::Stays
        }
    };
    let direction = Label { quantity: Quantity::Direction, of: Owner::Body(end.body) };
    // The turn of a body has no such word.
    let turns = body.pin.is_some() || body.planar.is_some();
    if !turns {
        words.push((
            direction,
            if sloped { word(Word::Up, Word::Down) } else { word(Word::Forward, Word::Back) },
        ));
    }
    let motion = if let Some(throw) = thrown {
        match (throw.slips, throw.closes, throw.holds) {
            (true, false, _) => Motion::Never,
            (_, _, false) => Motion::SlipsThrough,
            (false, _, true) => Motion::RollsAtStart,
            (true, true, true) => Motion::RollsAfter,
        }
    } else if slips_on {
        Motion::SlipsThrough
    } else if let Some((tie, friction, available, sense)) = slipping {
        let line = match &scene.ties[tie] {
            Tie::Slip { body, .. } => scene.bodies[*body].line,
            _ => None,
        };
        let upward = if line.is_none_or(|l| l.forward_up) { sense } else { -sense };
        let sloped = line.is_some_and(|l| l.slope != Slope::Level);
        match (friction.abs().status(available), upward) {
            (s, _) if s < 0.0 => Motion::Rolls,
            (0.0, _) => Motion::AtLimit,
            (_, u) if u > 0.0 && sloped => Motion::SlipsUp,
            (_, u) if u < 0.0 && sloped => Motion::SlipsDown,
            (_, u) if u > 0.0 => Motion::SlipsForward,
            (_, u) if u < 0.0 => Motion::SlipsBack,
            _ => Motion::SpinsInPlace,
        }
    } else if turns {
        match (course.sense, course.reached, place) {
            (0.0, ..) => Motion::Rest,
            (_, _, 0.0) if course.asked.is_some() => Motion::SwingsTurningPoint,
            (_, true, _) => Motion::SwingsOk,
            _ => Motion::SwingsUnreachable,
        }
    } else if scene.is_sprung() {
        let [ok, turning_point, unreachable] = match (sloped, upward > 0.0) {
            (true, true) => [Motion::UpOk, Motion::UpTurningPoint, Motion::UpUnreachable],
            (true, false) => [Motion::DownOk, Motion::DownTurningPoint, Motion::DownUnreachable],
            (false, true) => [Motion::ForwardOk, Motion::ForwardTurningPoint, Motion::ForwardUnreachable],
            (false, false) => [Motion::BackOk, Motion::BackTurningPoint, Motion::BackUnreachable],
        };
        match (upward, course.reached, place) {
            (0.0, ..) => Motion::Rest,
            (_, _, 0.0) if course.asked.is_some() => turning_point,
            (_, true, _) => ok,
            (_, false, _) => unreachable,
        }
    } else {
        match (sloped, upward) {
            (true, u) if u > 0.0 => Motion::MovesUp,
            (true, u) if u < 0.0 => Motion::MovesDown,
            (false, u) if u > 0.0 => Motion::MovesForward,
            (false, u) if u < 0.0 => Motion::MovesBack,
            _ => Motion::Balanced,
        }
    };
    (Regime { motion, slips }, checks, words)
}

/// The conditions of a throw: it slips, friction ends the slip, and holds what follows. What comes after the end is not asked.
fn throw_checks(scene: &Scene, t: &Throw, checks: &mut Vec<Check>) {
    let share = |available: f64, required: f64| margin(Dd::new(available), Dd::new(required));
    checks.push(Check {
        kind: CheckKind::StartsSlipping,
        of: t.tie,
        ok: t.slips,
        required: 0.0,
        available: t.slip,
        margin: if t.slips { t.slip / t.speeds } else { -1.0 },
    });
    if t.slips && matches!(scene.end, End::Rolling(_)) {
        checks.push(Check {
            kind: CheckKind::Closes,
            of: t.tie,
            ok: t.closes,
            required: t.upkeep,
            available: t.kinetic,
            margin: share(t.kinetic, t.upkeep),
        });
    }
    if t.to_roll {
        checks.push(Check {
            kind: CheckKind::NoSlip,
            of: t.tie,
            ok: t.holds,
            required: t.needed,
            available: t.available,
            margin: share(t.available, t.needed),
        });
    } else {
        checks.push(switch(CheckKind::StaticLimit, t.tie, t.needed, t.available));
    }
    if let (true, Some((asked, until))) = (t.slips, t.times) {
        checks.push(switch(CheckKind::SlipEnds, t.tie, asked, until));
    }
    if let Some((speed, speeds)) = t.at_end {
        let margin = if speeds > 0.0 { speed / speeds } else { 0.0 };
        checks.push(Check {
            kind: CheckKind::UnderWay,
            of: t.tie,
            ok: true,
            required: 0.0,
            available: speed,
            margin,
        });
    }
}

/// A switch and what is asked, on whichever side of it.
fn switch(kind: CheckKind, of: usize, required: f64, available: f64) -> Check {
    let apart = margin(Dd::new(available), Dd::new(required)).abs();
    Check { kind, of, ok: true, required, available, margin: apart }
}

fn rolls(scene: &Scene, tie: usize) -> Label {
    let of = match &scene.ties[tie] {
        Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => Owner::Body(*body),
        Tie::Cord(_) => Owner::Tie(tie),
    };
    Label { quantity: Quantity::Rolls, of }
}
