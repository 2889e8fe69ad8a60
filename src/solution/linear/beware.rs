//! Mistakes that suggest themselves in this scene, each with the number that it would give for this variant.
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::End;
use crate::scene::Label;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Tie;
use crate::sheet::number;
use crate::solution::expr::ZERO;
use crate::solution::ledger::Symbol;
use crate::solution::ledger::tex_digits;
use crate::solution::linear::mechanism::Kind;
use crate::solution::linear::mechanism::Part;
use crate::solution::linear::mechanism::Source;
use crate::solution::linear::walk::Walk;
use crate::solution::linear::walk::of_body;
use crate::solution::linear::walk::of_scene;
use crate::solution::linear::walk::of_tie;
use crate::solution::text::Block;

/// A wrong value that comes this close to the right one is no warning.
const APART: f64 = 0.01;

/// Figures of a wrong value.
const FIGURES: usize = 3;

/// Writes the list; the walk has gone its road.
pub fn write(walk: &mut Walk) {
    let mut items: Vec<String> = Vec::new();
    speeds(walk, &mut items);
    frictions(walk, &mut items);
    tensions(walk, &mut items);
    slips(walk, &mut items);
    if !items.is_empty() {
        walk.tell("beware.intro", &[]);
        walk.out.blocks.push(Block::List(items));
    }
}

/// One warning: the phrase with the wrong and the right value, if they are apart.
fn warn(walk: &Walk, items: &mut Vec<String>, name: &str, right: Symbol, wrong: f64, more: &[(&str, &str)]) {
    let value = walk.desk.ledger.value(right);
    let apart = (wrong - value).abs() > APART * value.abs();
    if !wrong.is_finite() || !apart {
        return;
    }
    let tex = walk.desk.ledger.tex(right);
    let digits = tex_digits(&number::rounded(wrong, FIGURES), walk.desk.words);
    let unit = walk.desk.ledger.unit(right);
    let text = if unit.is_empty() { digits } else { format!(r"{digits}\ {unit}") };
    let digits = tex_digits(&number::rounded(value, FIGURES), walk.desk.words);
    let true_text = if unit.is_empty() { digits } else { format!(r"{digits}\ {unit}") };
    let wrong = format!(r"${tex} \approx {text}$");
    let right = format!("${true_text}$");
    let pieces: Vec<(&str, &str)> = [("wrong", wrong.as_str()), ("right", right.as_str())]
        .into_iter()
        .chain(more.iter().copied())
        .collect();
    items.push(walk.phrase(&format!("beware.{name}"), &pieces));
}

/// The speed that is asked first, and its label.
fn asked_speed(walk: &Walk) -> Option<(Label, Symbol)> {
    let labels = walk.desk.problem.questions.iter().map(|q| q.label);
    labels
        .filter(|l| matches!(l.quantity, Quantity::V | Quantity::Omega))
        .filter(|l| !matches!(l.of, Owner::Body(b) if walk.m.parts[b].slips))
        .find_map(|l| Some((l, walk.found(l)?)))
}

fn speeds(walk: &mut Walk, items: &mut Vec<String>) {
    let Some((label, right)) = asked_speed(walk) else { return };
    let Owner::Body(body) = label.of else { return };
    let degree = if label.quantity == Quantity::V { Degree::Along } else { Degree::Turn };
    let ratio = walk.value(&walk.m.ratio(Coordinate { body, degree }).expr()).abs();
    let placed = matches!(walk.desk.scene.end, End::Travel(..) | End::Position(..));
    let v0 = walk.value(&walk.v0.clone());
    let s = walk.value(&walk.s.clone());
    let inertia = walk.value(&walk.effective.clone());
    let moving = |p: &Part| {
        let along = walk.value(&p.along.expr());
        walk.value(&p.mass.expr()) * along * along
    };
    let masses: f64 = walk.m.parts.iter().map(moving).sum();
    let speed = |push: f64, inertia: f64| ratio * (v0 * v0 + 2.0 * push * s / inertia).sqrt();
    if !placed {
        return;
    }
    if let Some(spring) = walk.spring.clone() {
        let (ks, x0) = (walk.value(&spring.stiffness), walk.value(&spring.stretch));
        let gamma = walk.value(&spring.gamma.expr());
        let rest = walk.value(&walk.drive.clone());
        // Mean force over the way.
        let mean = |gamma: f64| gamma * ks * (x0 - gamma * s / 2.0) + rest;
        let shown = walk.tex(&spring.gamma.expr());
        if !spring.gamma.is_unit() {
            warn(
                walk,
                items,
                "spring_lever",
                right,
                speed(mean(gamma.signum()), inertia),
                &[("gamma", &shown)],
            );
        }
        warn(walk, items, "constant", right, speed(gamma * ks * x0 + rest, inertia), &[]);
        warn(walk, items, "rotation", right, speed(mean(gamma), masses), &[]);
        return;
    }
    let slips = walk.m.parts.iter().any(|p| p.slips);
    let drive = walk.value(&walk.drive.clone());
    for action in walk.m.actions.clone() {
        if action.kind != Kind::Given || !matches!(action.source, Source::Tie(_)) || slips {
            continue;
        }
        let (centre, point) = (
            walk.value(&walk.m.parts[action.body].along.times(&action.along).expr()),
            walk.value(&walk.m.point(&action).expr()),
        );
        if (centre - point).abs() < 1e-9 * point.abs() || centre == 0.0 {
            continue;
        }
        let force = walk.value(&action.force);
        let tex = action.force.symbols(&walk.desk.ledger);
        let (work, factor) = (
            format!(r"${tex}\,{}$", walk.distance().symbols(&walk.desk.ledger)),
            walk.tex(&walk.m.point(&action).expr()),
        );
        warn(
            walk,
            items,
            "pull",
            right,
            speed(drive + force * (centre - point), inertia),
            &[("work", &work), ("factor", &factor)],
        );
    }
    if !slips {
        warn(walk, items, "rotation", right, speed(drive, masses), &[]);
    }
    // Rolling friction taken for a loss.
    for (t, tie) in walk.desk.scene.ties.iter().enumerate() {
        if let Tie::Roll { body, .. } = tie
            && let Some(f) = walk.found(of_body(Quantity::Friction, *body))
            && walk.m.force_of(t) == Some(f)
        {
            let along = walk.value(&walk.m.parts[*body].along.expr()) * f64::from(walk.m.parts[*body].up);
            let force = walk.desk.ledger.value(f) * along;
            let tex = format!("${}$", walk.desk.ledger.tex(f));
            warn(walk, items, "friction_work", right, speed(drive + force, inertia), &[("force", &tex)]);
        }
    }
    // The other radius of the rolling wheel.
    if degree == Degree::Turn {
        for tie in &walk.desk.scene.ties {
            if let Tie::Roll { body: b, radius_m, .. } = tie
                && *b == body
            {
                let c = walk.desk.value(*radius_m);
                for (name, other) in &walk.desk.scene.bodies[body].radii_m {
                    if other == radius_m {
                        continue;
                    }
                    let wrong = walk.desk.ledger.value(right) * c / walk.desk.value(*other);
                    let other = walk.desk.number(*other, name, "m");
                    let c = walk.desk.number(*radius_m, "R", "m");
                    let (other, c) = (walk.tex(&other), walk.tex(&c));
                    warn(walk, items, "radius", right, wrong, &[("other", &other), ("radius", &c)]);
                }
            }
        }
    }
}

fn frictions(walk: &mut Walk, items: &mut Vec<String>) {
    for tie in &walk.desk.scene.ties {
        match tie {
            Tie::Roll { body, mu_s: Some(mu), .. } => {
                let label = of_body(Quantity::Friction, *body);
                let (Some(f), Some(n)) = (walk.found(label), walk.found(of_body(Quantity::Normal, *body)))
                else {
                    continue;
                };
                if !walk.desk.asks_label(label) {
                    continue;
                }
                let value = walk.desk.ledger.value(f);
                let wrong = value.signum() * walk.desk.value(*mu) * walk.desk.ledger.value(n);
                warn(walk, items, "grip", f, wrong, &[]);
                // Friction that drives on is a surprise.
                let velocity = walk.value(&walk.m.parts[*body].along.expr())
                    * walk.sense
                    * f64::from(walk.m.parts[*body].up);
                if velocity * value > 0.0 && walk.v0 == ZERO {
                    items.push(walk.phrase("beware.friction_drives", &[]));
                }
            }
            Tie::Slip { body, mu_s, .. } => {
                let (Some(f), Some(n)) = (
                    walk.found(of_body(Quantity::Friction, *body)),
                    walk.found(of_body(Quantity::Normal, *body)),
                ) else {
                    continue;
                };
                let sign = walk.desk.ledger.value(f).signum();
                let wrong = sign * walk.desk.value(*mu_s) * walk.desk.ledger.value(n);
                warn(walk, items, "kinetic", f, wrong, &[]);
            }
            _ => {}
        }
    }
}

/// The tension taken for the weight of what hangs on the cord.
fn tensions(walk: &mut Walk, items: &mut Vec<String>) {
    for (t, tie) in walk.desk.scene.ties.iter().enumerate() {
        let Tie::Cord(_) = tie else { continue };
        let label = of_tie(Quantity::Tension, t);
        let Some(tension) = walk.found(label) else { continue };
        if !walk.desk.asks_label(label) || walk.spring.is_some() {
            continue;
        }
        let hangs = walk
            .m
            .actions
            .iter()
            .find(|a| a.source == Source::Tie(t) && walk.m.parts[a.body].path == "vertical");
        let Some(body) = hangs.map(|a| a.body) else { continue };
        let weight = walk.value(&walk.m.parts[body].mass.expr()) * walk.value(&walk.m.g.clone());
        warn(walk, items, "weight", tension, weight, &[]);
    }
}

fn slips(walk: &mut Walk, items: &mut Vec<String>) {
    for tie in &walk.desk.scene.ties {
        let Tie::Slip { body, radius_m, .. } = tie else { continue };
        let c = walk.desk.value(*radius_m);
        if let (Some(v), Some(omega)) =
            (walk.found(of_body(Quantity::V, *body)), walk.found(of_body(Quantity::Omega, *body)))
        {
            let wrong = walk.desk.ledger.value(v) / c;
            warn(walk, items, "no_slip", omega, wrong, &[]);
        }
        let friction = walk.found(of_body(Quantity::Friction, *body));
        if let (Some(heat), Some(f)) = (walk.found(of_scene(Quantity::Heat)), friction) {
            let wrong = walk.desk.ledger.value(f).abs() * walk.value(&walk.distance());
            warn(walk, items, "heat", heat, wrong, &[]);
        }
    }
}
