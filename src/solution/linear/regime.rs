//! The check of what was assumed: it moves, contacts are pressed, rolling contacts hold, cords are taut, the end is reached.
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::End;
use crate::scene::Far;
use crate::scene::Label;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Span;
use crate::scene::Tie;
use crate::solution::desk::Answer;
use crate::solution::expr::Expr;
use crate::solution::expr::Symbol;
use crate::solution::expr::ZERO;
use crate::solution::expr::in_sense;
use crate::solution::expr::sum;
use crate::solution::linear::mechanism::Kind;
use crate::solution::linear::motion::lead_way;
use crate::solution::linear::walk::Walk;
use crate::solution::linear::walk::larger;
use crate::solution::linear::walk::of_body;
use crate::solution::linear::walk::of_tie;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solution::text::Block;
use crate::solution::way;
use crate::solve::outcome::Word;

/// Writes the checks; the walk has gone its road.
///
/// # Errors
/// What the derivation does not cover, and a check that fails.
pub fn write(walk: &mut Walk) -> Result<(), Stop> {
    walk.tell("regime.intro", &[]);
    if walk.spring.is_some() {
        let far = match walk.desk.scene.span {
            Span::ToEnd => "end",
            Span::ToTurningPoint => "turn",
        };
        walk.tell(&format!("regime.range.{far}"), &[]);
    }
    moves(walk)?;
    for body in 0..walk.m.parts.len() {
        if walk.m.parts[body].normal.is_some() {
            let n = walk.get(of_body(Quantity::Normal, body))?;
            let shown = valued(walk, n);
            walk.tell("regime.pressed", &[("n", &shown)]);
        }
    }
    for (t, tie) in walk.desk.scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { body, mu_s, .. } => {
                if walk.m.parts[*body].normal.is_none() {
                    continue;
                }
                match mu_s {
                    Some(mu) => {
                        let mu = walk.desk.number(*mu, r"\mu_s", "1");
                        grip(walk, *body, &mu)?;
                    }
                    None => walk.tell("regime.no_coefficient", &[]),
                }
            }
            Tie::Slip { body, .. } => slip(walk, *body)?,
            Tie::Slide { .. } => {}
            Tie::Cord(cord) => match cord.to {
                Far::Body(_) | Far::Fixed => taut(walk, t)?,
                Far::Spring { rigid, .. } if !rigid => taut(walk, t)?,
                Far::Spring { .. } | Far::Pull(_) => {}
            },
        }
    }
    reaches(walk)
}

/// `$N = 340.1\ \mathrm{N}$`
fn valued(walk: &Walk, symbol: Symbol) -> String {
    format!("${} = {}$", walk.desk.ledger.tex(symbol), walk.desk.ledger.shown(symbol))
}

/// Which way it moves.
fn moves(walk: &mut Walk) -> Result<(), Stop> {
    let lead = walk.lead();
    let way = lead_way(walk);
    let label = Label { quantity: Quantity::Direction, of: Owner::Body(lead.body) };
    let sloped = walk.m.parts[lead.body].path;
    let up = walk.sense * f64::from(walk.m.parts[lead.body].up) > 0.0;
    let word = match (sloped == "incline" || sloped == "vertical", up) {
        (true, true) => Word::Up,
        (true, false) => Word::Down,
        (false, true) => Word::Forward,
        (false, false) => Word::Back,
    };
    walk.desk.from_motion(label, Answer::Word(word));
    walk.desk.from_energy(label, Answer::Word(word));
    if walk.v0 != ZERO {
        return Ok(());
    }
    // Slides that start from rest have to be torn loose.
    for tie in &walk.desk.scene.ties {
        let Tie::Slide { body, mu_s: Some(mu), .. } = tie else { continue };
        let along = Coordinate { body: *body, degree: Degree::Along };
        if walk.m.ratio(along).is_zero() {
            continue;
        }
        let mu = walk.desk.number(*mu, r"\mu_s", "1");
        let n = walk.get(of_body(Quantity::Normal, *body))?;
        let others: Vec<Expr> =
            walk.terms().into_iter().filter(|(a, _)| a.kind == Kind::Given).map(|(_, e)| e).collect();
        let push = walk.new_symbol(&["F_{d}"], "N");
        let hold = walk.new_symbol(&["F_{h}"], "N");
        walk.tell("regime.torn", &[]);
        walk.find(push, &in_sense(sum(others), walk.sense));
        let ratio = walk.magnitude(walk.m.ratio(along));
        walk.find(hold, &(mu * n * ratio.expr()));
        let (push, hold) = (valued(walk, push), valued(walk, hold));
        walk.tell("regime.torn_loose", &[("push", &push), ("hold", &hold), ("way", &way)]);
    }
    let a = walk.get(walk.label_of_lead(Quantity::A, Quantity::Alpha))?;
    if walk.spring.is_none() {
        let a = valued(walk, a);
        walk.tell("regime.moves", &[("a", &a), ("way", &way)]);
    }
    Ok(())
}

/// `|F| <= mu_s N` over the whole motion.
fn grip(walk: &mut Walk, body: usize, mu: &Expr) -> Result<(), Stop> {
    let n = walk.get(of_body(Quantity::Normal, body))?;
    let limit = walk.new_symbol(&[r"F_{\mathrm{max}}"], "N");
    walk.tell("regime.limit", &[]);
    walk.find(limit, &(mu * n));
    let most = walk.desk.ledger.value(limit);
    let limit = valued(walk, limit);
    let size = |walk: &Walk, f: &Expr| {
        let size = walk.value(f).abs();
        let tex = f.symbols(&walk.desk.ledger);
        let number = match f {
            Expr::Symbol(s) => walk.desk.ledger.shown(*s),
            _ => String::new(),
        };
        (size, format!(r"$\left|{tex}\right| = {}$", number.trim_start_matches('-')))
    };
    let mut holds = true;
    if walk.spring.is_some() {
        walk.tell("regime.extremes", &[]);
        let ends = walk.extremes(body)?;
        match larger(walk, &ends) {
            Some((end, pulls_most)) => {
                let at = walk.phrase(&format!("extremes.at.{}", end.place), &[]);
                let force = if pulls_most { "greatest" } else { "least" };
                let force = walk.phrase(&format!("extremes.force.{force}"), &[]);
                walk.tell("regime.larger", &[("at", &at), ("force", &force)]);
            }
            None => walk.tell("regime.equal", &[]),
        }
        let [(a, one), (b, two)] = ends.map(|end| size(walk, &end.friction));
        holds &= a <= most && b <= most;
        walk.out.blocks.push(Block::Picture("graph-friction".to_owned()));
        walk.tell("regime.holds_both", &[("one", &one), ("two", &two), ("limit", &limit)]);
    } else {
        let f = walk.get(of_body(Quantity::Friction, body))?;
        let value = walk.desk.ledger.value(f);
        let (a, one) = size(walk, &f.into());
        holds &= a <= most;
        let direction = way(walk.desk.scene, Owner::Body(body), value);
        let direction = direction.map_or_else(String::new, |w| walk.desk.words.get(w).to_owned());
        walk.tell("regime.holds", &[("one", &one), ("limit", &limit)]);
        if value != 0.0 {
            walk.tell("regime.friction_way", &[("way", &direction)]);
            why_that_way(walk, body, &direction);
        }
    }
    if !holds {
        return walk.beyond(Beyond::SlipsAfterAll);
    }
    let label = of_body(Quantity::Rolls, body);
    walk.desk.from_motion(label, Answer::Word(Word::Yes));
    walk.desk.from_energy(label, Answer::Word(Word::Yes));
    Ok(())
}

/// Where the contact of a single wheel would go without friction.
fn why_that_way(walk: &mut Walk, body: usize, direction: &str) {
    if walk.m.parts.len() > 1 || walk.spring.is_some() {
        return;
    }
    let share = |walk: &Walk, degree| {
        let row = walk.row(Coordinate { body, degree });
        sum(row.into_iter().filter(|(a, _)| a.kind == Kind::Given).map(|(_, e)| e).collect::<Vec<_>>())
    };
    let arm = walk.m.actions.iter().find(|a| a.body == body && a.contact);
    let Some(c) = arm.map(|a| walk.magnitude(&a.arm).expr()) else { return };
    let along = walk.m.inertia_expr(Coordinate { body, degree: Degree::Along });
    let turn = walk.m.inertia_expr(Coordinate { body, degree: Degree::Turn });
    if turn == ZERO {
        return;
    }
    let (force, moment) = (share(walk, Degree::Along), share(walk, Degree::Turn));
    let contact = walk.new_symbol(&["a_{C0}"], "m/s^2");
    walk.tell("regime.why_that_way", &[]);
    let spin = c * (moment / turn);
    walk.find(contact, &(force / along - spin));
    let value = walk.desk.ledger.value(contact) * f64::from(walk.m.parts[body].up);
    let against = way(walk.desk.scene, Owner::Body(body), value);
    let against = against.map_or_else(String::new, |w| walk.desk.words.get(w).to_owned());
    walk.tell("regime.so_that_way", &[("against", &against), ("way", direction)]);
}

/// The contact slides against the friction that was assumed.
fn slip(walk: &mut Walk, body: usize) -> Result<(), Stop> {
    let Some((_, c)) = walk.slip_of(body) else { return Ok(()) };
    let a = walk.get(of_body(Quantity::A, body))?;
    let alpha = walk.get(of_body(Quantity::Alpha, body))?;
    let contact = walk.new_symbol(&["a_{C}"], "m/s^2");
    walk.tell("regime.slip", &[]);
    walk.find(contact, &(a - c * alpha));
    let up = f64::from(walk.m.parts[body].up);
    let value = walk.desk.ledger.value(contact) * up;
    let friction = walk.get(of_body(Quantity::Friction, body))?;
    let friction = walk.desk.ledger.value(friction);
    let names = [value, friction].map(|x| way(walk.desk.scene, Owner::Body(body), x));
    let [slides, force] = names.map(|n| n.map_or_else(String::new, |w| walk.desk.words.get(w).to_owned()));
    if value * friction >= 0.0 {
        return walk.beyond(Beyond::FrictionWithSlip);
    }
    walk.tell("regime.slip_way", &[("slides", &slides), ("force", &force)]);
    let label = of_body(Quantity::Rolls, body);
    walk.desk.from_motion(label, Answer::Word(Word::No));
    walk.desk.from_energy(label, Answer::Word(Word::No));
    Ok(())
}

/// Tension of a cord.
fn taut(walk: &mut Walk, tie: usize) -> Result<(), Stop> {
    let t = walk.get(of_tie(Quantity::Tension, tie))?;
    if walk.desk.ledger.value(t) <= 0.0 {
        return walk.beyond(Beyond::SlackCord);
    }
    let shown = valued(walk, t);
    let spring = walk.spring.as_ref().is_some_and(|s| s.tie == tie);
    walk.tell(if spring { "regime.taut_spring" } else { "regime.taut" }, &[("t", &shown)]);
    Ok(())
}

/// The end lies before the turning point.
fn reaches(walk: &mut Walk) -> Result<(), Stop> {
    let lead = walk.lead();
    if !matches!(walk.desk.scene.end, End::Travel(..) | End::Position(..)) {
        return Ok(());
    }
    let turns = walk.spring.is_some() || walk.value(&walk.drive.clone()) * walk.sense < 0.0;
    if !turns || lead.degree == Degree::Turn {
        return Ok(());
    }
    let level = walk.spring.as_ref().is_some_and(|s| !s.rigid) && walk.value(&walk.drive.clone()) == 0.0;
    if level {
        return Ok(());
    }
    let turn = walk.get(of_body(Quantity::DTurn, lead.body))?;
    let (d, far) = (walk.value(&walk.distance()), walk.desk.ledger.value(turn));
    if d > far {
        return walk.beyond(Beyond::BehindTurning);
    }
    let distance = walk.tex(&walk.distance());
    let shown = valued(walk, turn);
    walk.tell("regime.reaches", &[("d", &distance), ("turn", &shown)]);
    Ok(())
}
