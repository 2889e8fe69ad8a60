//! The check of what was assumed: it moves, contacts are pressed, rolling contacts hold, cords are taut, the end is reached.
use crate::scene::{Coordinate, Degree, End, Far, Label, Owner, Quantity, Span, Tie};
use crate::solution::draft::DerivedAnswer;
use crate::solution::expr::{Expr, SymbolId, ZERO, in_sense, sum};
use crate::solution::linear::derivation::{LinearDerivation, larger, of_body, of_tie};
use crate::solution::linear::mechanism::ForceKind;
use crate::solution::linear::motion::lead_way;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::text::Block;
use crate::solution::way;
use crate::solve::outcome::Word;

/// Writes the checks, when the quantities have been found.
///
/// # Errors
/// What the derivation does not cover, and a check that fails.
pub fn write(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    task.tell("regime.intro", &[]);
    if task.spring.is_some() {
        let far = match task.draft.scene.span {
            Span::ToEnd => "end",
            Span::ToTurningPoint => "turn",
        };
        task.tell(&format!("regime.range.{far}"), &[]);
    }
    moves(task)?;
    for body in 0..task.m.parts.len() {
        if task.m.parts[body].normal.is_some() {
            let n = task.get(of_body(Quantity::Normal, body))?;
            let shown = valued(task, n);
            task.tell("regime.pressed", &[("n", &shown)]);
        }
    }
    for (t, tie) in task.draft.scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { body, mu_s, .. } => {
                if task.m.parts[*body].normal.is_none() {
                    continue;
                }
                match mu_s {
                    Some(mu) => {
                        let mu = task.draft.number(*mu, r"\mu_s", "1");
                        grip(task, *body, &mu)?;
                    }
                    None => task.tell("regime.no_coefficient", &[]),
                }
            }
            Tie::Slip { body, .. } => slip(task, *body)?,
            Tie::Slide { .. } => {}
            Tie::Cord(cord) => match cord.to {
                Far::Body(_) | Far::Fixed => taut(task, t)?,
                Far::Spring { rigid, .. } if !rigid => taut(task, t)?,
                Far::Spring { .. } | Far::Pull(_) => {}
            },
        }
    }
    reaches(task)
}

/// `$N = 340.1\ \mathrm{N}$`
fn valued(task: &LinearDerivation, symbol: SymbolId) -> String {
    format!("${} = {}$", task.draft.symbols.tex(symbol), task.draft.symbols.shown(symbol))
}

/// Which way it moves.
fn moves(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    let lead = task.lead();
    let way = lead_way(task);
    let label = Label { quantity: Quantity::Direction, of: Owner::Body(lead.body) };
    let sloped = task.m.parts[lead.body].path;
    let up = task.sense * f64::from(task.m.parts[lead.body].up) > 0.0;
    let word = match (sloped == "incline" || sloped == "vertical", up) {
        (true, true) => Word::Up,
        (true, false) => Word::Down,
        (false, true) => Word::Forward,
        (false, false) => Word::Back,
    };
    task.draft.from_motion(label, DerivedAnswer::Word(word));
    task.draft.from_energy(label, DerivedAnswer::Word(word));
    if task.v0 != ZERO {
        return Ok(());
    }
    // Slides that start from rest have to be torn loose.
    for tie in &task.draft.scene.ties {
        let Tie::Slide { body, mu_s: Some(mu), .. } = tie else { continue };
        let along = Coordinate { body: *body, degree: Degree::Along };
        if task.m.ratio(along).is_zero() {
            continue;
        }
        let mu = task.draft.number(*mu, r"\mu_s", "1");
        let n = task.get(of_body(Quantity::Normal, *body))?;
        let others: Vec<Expr> =
            task.terms().into_iter().filter(|(a, _)| a.kind == ForceKind::Given).map(|(_, e)| e).collect();
        let push = task.new_symbol(&["F_{d}"], "N");
        let hold = task.new_symbol(&["F_{h}"], "N");
        task.tell("regime.torn", &[]);
        task.find(push, &in_sense(sum(others), task.sense));
        let ratio = task.magnitude(task.m.ratio(along));
        task.find(hold, &(mu * n * ratio.expr()));
        let (push, hold) = (valued(task, push), valued(task, hold));
        task.tell("regime.torn_loose", &[("push", &push), ("hold", &hold), ("way", &way)]);
    }
    let a = task.get(task.label_of_lead(Quantity::A, Quantity::Alpha))?;
    if task.spring.is_none() {
        let a = valued(task, a);
        task.tell("regime.moves", &[("a", &a), ("way", &way)]);
    }
    Ok(())
}

/// `|F| <= mu_s N` over the whole motion.
fn grip(task: &mut LinearDerivation, body: usize, mu: &Expr) -> Result<(), DerivationStop> {
    let n = task.get(of_body(Quantity::Normal, body))?;
    let limit = task.new_symbol(&[r"F_{\mathrm{max}}"], "N");
    task.tell("regime.limit", &[]);
    task.find(limit, &(mu * n));
    let most = task.draft.symbols.value(limit);
    let limit = valued(task, limit);
    let size = |task: &LinearDerivation, f: &Expr| {
        let size = task.value(f).abs();
        let tex = f.symbols(&task.draft.symbols);
        let number = match f {
            Expr::Symbol(s) => task.draft.symbols.shown(*s),
            _ => String::new(),
        };
        (size, format!(r"$\left|{tex}\right| = {}$", number.trim_start_matches('-')))
    };
    let mut holds = true;
    if task.spring.is_some() {
        task.tell("regime.extremes", &[]);
        let ends = task.extremes(body)?;
        match larger(task, &ends) {
            Some((end, pulls_most)) => {
                let at = task.phrase(&format!("extremes.at.{}", end.place), &[]);
                let force = if pulls_most { "greatest" } else { "least" };
                let force = task.phrase(&format!("extremes.force.{force}"), &[]);
                task.tell("regime.larger", &[("at", &at), ("force", &force)]);
            }
            None => task.tell("regime.equal", &[]),
        }
        let [(a, one), (b, two)] = ends.map(|end| size(task, &end.friction));
        holds &= a <= most && b <= most;
        task.out.blocks.push(Block::Picture("graph-friction".to_owned()));
        task.tell("regime.holds_both", &[("one", &one), ("two", &two), ("limit", &limit)]);
    } else {
        let f = task.get(of_body(Quantity::Friction, body))?;
        let value = task.draft.symbols.value(f);
        let (a, one) = size(task, &f.into());
        holds &= a <= most;
        let direction = way(task.draft.scene, Owner::Body(body), value);
        let direction = direction.map_or_else(String::new, |w| task.draft.words.get(w).to_owned());
        task.tell("regime.holds", &[("one", &one), ("limit", &limit)]);
        if value != 0.0 {
            task.tell("regime.friction_way", &[("way", &direction)]);
            why_that_way(task, body, &direction);
        }
    }
    if !holds {
        return task.beyond(Beyond::SlipsAfterAll);
    }
    let label = of_body(Quantity::Rolls, body);
    task.draft.from_motion(label, DerivedAnswer::Word(Word::Yes));
    task.draft.from_energy(label, DerivedAnswer::Word(Word::Yes));
    Ok(())
}

/// Where the contact of a single wheel would go without friction.
fn why_that_way(task: &mut LinearDerivation, body: usize, direction: &str) {
    if task.m.parts.len() > 1 || task.spring.is_some() {
        return;
    }
    let share = |task: &LinearDerivation, degree| {
        let row = task.row(Coordinate { body, degree });
        sum(row.into_iter().filter(|(a, _)| a.kind == ForceKind::Given).map(|(_, e)| e).collect::<Vec<_>>())
    };
    let arm = task.m.actions.iter().find(|a| a.body == body && a.contact);
    let Some(c) = arm.map(|a| task.magnitude(&a.arm).expr()) else { return };
    let along = task.m.inertia_expr(Coordinate { body, degree: Degree::Along });
    let turn = task.m.inertia_expr(Coordinate { body, degree: Degree::Turn });
    if turn == ZERO {
        return;
    }
    let (force, moment) = (share(task, Degree::Along), share(task, Degree::Turn));
    let contact = task.new_symbol(&["a_{C0}"], "m/s^2");
    task.tell("regime.why_that_way", &[]);
    let spin = c * (moment / turn);
    task.find(contact, &(force / along - spin));
    let value = task.draft.symbols.value(contact) * f64::from(task.m.parts[body].up);
    let against = way(task.draft.scene, Owner::Body(body), value);
    let against = against.map_or_else(String::new, |w| task.draft.words.get(w).to_owned());
    task.tell("regime.so_that_way", &[("against", &against), ("way", direction)]);
}

/// The contact slides against the friction that was assumed.
fn slip(task: &mut LinearDerivation, body: usize) -> Result<(), DerivationStop> {
    let Some((_, c)) = task.slip_of(body) else { return Ok(()) };
    let a = task.get(of_body(Quantity::A, body))?;
    let alpha = task.get(of_body(Quantity::Alpha, body))?;
    let contact = task.new_symbol(&["a_{C}"], "m/s^2");
    task.tell("regime.slip", &[]);
    task.find(contact, &(a - c * alpha));
    let up = f64::from(task.m.parts[body].up);
    let value = task.draft.symbols.value(contact) * up;
    let friction = task.get(of_body(Quantity::Friction, body))?;
    let friction = task.draft.symbols.value(friction);
    let names = [value, friction].map(|x| way(task.draft.scene, Owner::Body(body), x));
    let [slides, force] = names.map(|n| n.map_or_else(String::new, |w| task.draft.words.get(w).to_owned()));
    if value * friction >= 0.0 {
        return task.beyond(Beyond::FrictionWithSlip);
    }
    task.tell("regime.slip_way", &[("slides", &slides), ("force", &force)]);
    let label = of_body(Quantity::Rolls, body);
    task.draft.from_motion(label, DerivedAnswer::Word(Word::No));
    task.draft.from_energy(label, DerivedAnswer::Word(Word::No));
    Ok(())
}

/// Tension of a cord.
fn taut(task: &mut LinearDerivation, tie: usize) -> Result<(), DerivationStop> {
    let t = task.get(of_tie(Quantity::Tension, tie))?;
    if task.draft.symbols.value(t) <= 0.0 {
        return task.beyond(Beyond::SlackCord);
    }
    let shown = valued(task, t);
    let spring = task.spring.as_ref().is_some_and(|s| s.tie == tie);
    task.tell(if spring { "regime.taut_spring" } else { "regime.taut" }, &[("t", &shown)]);
    Ok(())
}

/// The end lies before the turning point.
fn reaches(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    let lead = task.lead();
    if !matches!(task.draft.scene.end, End::Travel(..) | End::Position(..)) {
        return Ok(());
    }
    let turns = task.spring.is_some() || task.value(&task.drive.clone()) * task.sense < 0.0;
    if !turns || lead.degree == Degree::Turn {
        return Ok(());
    }
    let level = task.spring.as_ref().is_some_and(|s| !s.rigid) && task.value(&task.drive.clone()) == 0.0;
    if level {
        return Ok(());
    }
    let turn = task.get(of_body(Quantity::DTurn, lead.body))?;
    let (d, far) = (task.value(&task.distance()), task.draft.symbols.value(turn));
    if d > far {
        return task.beyond(Beyond::BehindTurning);
    }
    let distance = task.tex(&task.distance());
    let shown = valued(task, turn);
    task.tell("regime.reaches", &[("d", &distance), ("turn", &shown)]);
    Ok(())
}
