//! The second method of a scene of lines and axles: states, the work of each force over its own displacement, kinetic energy.
use crate::scene::{Coordinate, Degree, End, Far, Quantity, Tie};
use crate::solution::expr::{Expr, SymbolId, ZERO, in_sense, number, ratio, root, square, sum};
use crate::solution::factors::Factors;
use crate::solution::linear::derivation::{CordSpring, LinearDerivation, of_body, of_tie, positive_first};
use crate::solution::linear::mechanism::{Action, ForceKind, ForceSource, tagged};
use crate::solution::linear::motion::{
    aligned, constant_forces, effective_symbols, lead_way, new_way, places,
};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::text::Block;

/// Writes the derivation and answers the questions by it.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(task: &mut LinearDerivation, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), DerivationStop> {
    let slipping = task.m.parts.iter().position(|p| p.slips);
    friction(task, slip_sense)?;
    task.drive = sum(task
        .terms()
        .into_iter()
        .filter(|(a, _)| a.kind != ForceKind::Spring)
        .map(|(_, e)| e)
        .collect::<Vec<_>>());
    match slipping {
        Some(body) => slipping_body(task, body)?,
        None => one_freedom(task)?,
    }
    if !task.rolled {
        task.out.blocks.push(Block::Picture("energy".to_owned()));
        task.answer()?;
    }
    Ok(())
}

/// Kinetic friction: its size is a law of its own by both methods.
fn friction(task: &mut LinearDerivation, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), DerivationStop> {
    for (tie, f, from, _) in task.kinetic(slip_sense) {
        let body = match &task.draft.scene.ties[tie] {
            Tie::Slip { body, .. } | Tie::Slide { body, .. } | Tie::Roll { body, .. } => *body,
            Tie::Cord(_) => continue,
        };
        task.get(of_body(Quantity::Normal, body))?;
        task.tell("energy.friction", &[]);
        task.find(f, &from);
        task.note(of_body(Quantity::Friction, body), f);
    }
    Ok(())
}

/// What does no work, and why.
fn idle(task: &mut LinearDerivation) {
    let scene = task.draft.scene;
    let mut reasons = Vec::new();
    let symbols = |task: &LinearDerivation, list: Vec<SymbolId>| {
        let list: Vec<String> = list.iter().map(|s| format!("${}$", task.draft.symbols.tex(*s))).collect();
        list.join(", ")
    };
    let normals: Vec<SymbolId> =
        task.m.parts.iter().filter_map(|p| p.normal.as_ref().map(|(n, _)| *n)).collect();
    if !normals.is_empty() {
        reasons.push(task.phrase("energy.idle_normal", &[("forces", &symbols(task, normals))]));
    }
    let of = |task: &LinearDerivation, test: &dyn Fn(&Tie) -> bool| -> Vec<SymbolId> {
        let ties = scene.ties.iter().enumerate().filter(|(_, t)| test(t));
        ties.filter_map(|(t, _)| task.m.force_of(t)).collect()
    };
    let rolled = task.rolled;
    let rolls = of(task, &|t| matches!(t, Tie::Roll { .. }) || (rolled && matches!(t, Tie::Slip { .. })));
    let cords = of(task, &|t| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Body(_))));
    let fixed = of(task, &|t| matches!(t, Tie::Cord(c) if c.to == Far::Fixed));
    for (name, list) in [("roll", rolls), ("cord", cords), ("fixed", fixed)] {
        if !list.is_empty() {
            reasons.push(task.phrase(&format!("energy.idle_{name}"), &[("forces", &symbols(task, list))]));
        }
    }
    if !reasons.is_empty() {
        task.tell("energy.idle", &[]);
        task.out.blocks.push(Block::List(reasons));
    }
}

/// The kinetic energy in symbols, reckoned to the lead.
fn kinetic(task: &mut LinearDerivation) {
    let lead = task.lead();
    let coordinates: Vec<Coordinate> = task.draft.scene.coordinates().collect();
    let mut parts = Vec::new();
    for c in &coordinates {
        let Some(v) = task.m.speed(*c) else { continue };
        if task.own(*c) || task.m.ratio(*c).is_zero() {
            continue;
        }
        for i in task.m.inertia(*c) {
            parts.push(ratio(1, 2) * i.expr() * square(v));
        }
    }
    let Some(v) = task.m.speed(lead) else { return };
    let whole = ratio(1, 2) * &task.effective * square(v);
    let first = sum(parts);
    task.tell("energy.kinetic_sum", &[]);
    let symbols = &task.draft.symbols;
    let e = task.draft.free(&["E_{k}"]);
    let formula = if first == whole {
        format!("{e} = {}", whole.symbols(symbols))
    } else {
        aligned(&[format!("{e} &= {}", first.symbols(symbols)), format!("&= {}", whole.symbols(symbols))])
    };
    task.out.blocks.push(Block::Formula(formula));
    if task.spring.is_some() || matches!(&task.effective, Expr::Sum(t) if t.len() > 2) {
        let (m_e, _) = effective_symbols(task);
        task.tell("energy.effective", &[]);
        task.find(m_e, &task.effective.clone());
        task.effective = m_e.into();
    }
}

/// The work of each force up to the end.
fn works(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    for (action, share) in task.terms() {
        if task.works.iter().any(|(s, ..)| *s == action.source) {
            continue;
        }
        let symbol = match action.source {
            ForceSource::Tie(t) if action.kind == ForceKind::Given => {
                task.get(of_tie(Quantity::WorkPull, t))?
            }
            ForceSource::Tie(_) if action.kind == ForceKind::Spring => {
                let Some(spring) = task.spring.clone() else {
                    return task.beyond(Beyond::Arrangement);
                };
                let x1 = task.new_symbol(&["x_{1}", r"\xi_{1}"], "m");
                let stretch = task.stretch_at(&spring, &task.s.clone());
                let gives = task.value(&stretch).abs() < task.value(&spring.stretch).abs();
                task.tell(if gives { "energy.spring_gives" } else { "energy.spring_takes" }, &[]);
                task.find(x1, &stretch);
                let w = task.new_symbol(&["W_{s}", r"W_{\mathrm{s}}"], "J");
                let squares = square(&spring.stretch) - square(x1);
                task.find(w, &(ratio(1, 2) * &spring.stiffness * squares));
                w
            }
            ForceSource::Tie(_) => {
                // A slide; of a slip, the caller knows the way.
                let w = task.new_symbol(&[&tagged("W", "F"), &tagged("W", "R")], "J");
                task.tell("energy.slide", &[]);
                task.find(w, &Factors::of(&share).times(&Factors::of(&task.s)).expr());
                w
            }
            ForceSource::Weight(body) => {
                let h = task.get(of_body(Quantity::Rise, body))?;
                let several =
                    task.terms().iter().filter(|(a, _)| matches!(a.source, ForceSource::Weight(_))).count()
                        > 1;
                let tag = if several { format!("g{}", task.m.parts[body].tag) } else { "g".to_owned() };
                let w = task.new_symbol(&[&tagged("W", &tag)], "J");
                let mass = task.m.parts[body].mass.clone();
                let weight = mass.times(&Factors::of(&task.m.g)).times(&Factors::of(&h.into()));
                task.find(w, &(-weight.expr()));
                w
            }
            ForceSource::Couple(i) => {
                let tag =
                    if task.draft.scene.couples.len() > 1 { format!("M{}", i + 1) } else { "M".to_owned() };
                let w = task.new_symbol(&[&tagged("W", &tag)], "J");
                let phi = task.get(of_body(Quantity::Phi, action.body))?;
                let helps = task.value(&share) * task.sense;
                task.tell("energy.couple", &[]);
                task.find(w, &in_sense(&action.force * phi, helps));
                w
            }
        };
        task.works.push((action.source, action.kind, symbol));
    }
    Ok(())
}

fn one_freedom(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    let lead = task.lead();
    let Some(v) = task.m.speed(lead) else { return task.beyond(Beyond::Arrangement) };
    let label = task.label_of_lead(Quantity::V, Quantity::Omega);
    let placed = matches!(task.draft.scene.end, End::Travel(..) | End::Position(..));
    task.tell(if task.v0 == ZERO { "energy.states_rest" } else { "energy.states_moving" }, &[]);
    idle(task);
    let start = |task: &LinearDerivation| {
        if task.v0 == ZERO { ZERO } else { ratio(1, 2) * &task.effective * square(&task.v0) }
    };
    if placed {
        task.tell("energy.works", &[]);
        works(task)?;
        kinetic(task);
        let works = task.works().unwrap_or(ZERO);
        let end = ratio(1, 2) * &task.effective * square(v);
        task.tell("energy.balance", &[]);
        let right = end - start(task);
        task.out.equation(&task.draft.symbols, &works, &right);
        let gained = number(2) * works / &task.effective;
        let square0 = if task.v0 == ZERO { ZERO } else { square(task.v0.clone()) };
        task.find(v, &root(square0 + gained));
        task.note(label, v);
        task.v = v.into();
        if let Some(spring) = task.spring.clone().filter(|s| s.stretch != ZERO) {
            other_origin(task, &spring, v)?;
        }
        if task.draft.asks(Quantity::Direction) && !task.rolled {
            let way = lead_way(task);
            task.tell(
                if task.spring.is_some() { "energy.direction_spring" } else { "energy.direction" },
                &[("way", &way)],
            );
        }
        return Ok(());
    }
    if task.spring.is_some() {
        return task.beyond(Beyond::SpringWithoutPlace);
    }
    // The place is not known: work per displacement first.
    kinetic(task);
    task.tell("energy.per_way", &[]);
    let terms: Vec<Expr> = task.terms().into_iter().map(|(_, e)| e).collect();
    let (_, f_e) = effective_symbols(task);
    task.find(f_e, &sum(terms));
    task.drive = f_e.into();
    let per = &task.drive / &task.effective;
    match task.draft.scene.end {
        End::Speed(_, u) => {
            let along = lead.degree == Degree::Along;
            let u = task.draft.number(
                u,
                if along { "v_1" } else { r"\omega_1" },
                if along { "m/s" } else { "rad/s" },
            );
            task.v = u;
        }
        End::TurningPoint(_) => task.v = ZERO,
        End::Time(_, t) => {
            let t = task.draft.number(t, "t", "s");
            task.tell("energy.rate_time", &[]);
            let end = &task.v0 + per * &t;
            task.find(v, &in_sense(end, task.sense));
            task.note(label, v);
            task.v = v.into();
            let s = new_way(task);
            task.tell("energy.mean_speed", &[]);
            let both = &task.v0 + in_sense(v.into(), task.sense);
            task.find(s, &(ratio(1, 2) * both * t));
            task.s = s.into();
            return works_if_asked(task);
        }
        _ => return task.beyond(Beyond::OtherEnd),
    }
    let s = new_way(task);
    task.tell("energy.balance", &[]);
    let squares = square(&task.v) - square(&task.v0);
    let from = &task.effective * squares / (number(2) * &task.drive);
    task.find(s, &from);
    task.s = s.into();
    works_if_asked(task)
}

/// The works of the forces, where heat or kinetic energy is asked and the displacement had to be found first.
fn works_if_asked(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    if !task.draft.asks(Quantity::Heat) && !task.draft.asks(Quantity::KineticEnergy) {
        return Ok(());
    }
    task.tell("energy.works", &[]);
    works(task)
}

/// Conservation of energy with heights and the spring counted from where the spring is not stretched.
fn other_origin(task: &mut LinearDerivation, spring: &CordSpring, v: SymbolId) -> Result<(), DerivationStop> {
    let (z0, z1) = places(task, spring);
    let z = task.new_symbol(&["z", "u"], "m");
    let stretch = spring.gamma.times(&Factors::of(&z.into())).opposite().expr();
    let stretch = task.tex(&stretch);
    task.tell("energy.other_origin", &[("stretch", &stretch)]);
    task.find(z0.0, &z0.1);
    task.find(z1.0, &z1.1);
    let (z0, z1): (Expr, Expr) = (z0.0.into(), z1.0.into());
    let rest: Vec<Expr> =
        task.terms().into_iter().filter(|(a, _)| a.kind != ForceKind::Spring).map(|(_, e)| e).collect();
    let rest = constant_forces(task, rest);
    let kappa = task.new_symbol(&[r"\kappa", r"\kappa_e"], "N/m");
    task.find(kappa, &spring.kappa);
    task.drive = sum(rest.clone());
    let stiffness: Expr = kappa.into();
    let energy = |z: &Expr| {
        let stored = ratio(1, 2) * &stiffness * square(z);
        let others = rest.iter().map(|r| -(r * z));
        sum([stored].into_iter().chain(others).collect::<Vec<_>>())
    };
    let moving = ratio(1, 2) * &task.effective * square(v);
    let (before, after) = (energy(&z0), energy(&z1) + moving);
    task.out.equation(&task.draft.symbols, &before, &after);
    let tex = task.draft.symbols.tex(v).to_owned();
    let again = task.draft.symbols.unknown_like(&tex, v);
    let squares = stiffness * (square(&z0) - square(&z1));
    let linear: Vec<Expr> = rest.iter().map(|r| number(2) * r * &task.s).collect();
    let over = positive_first([vec![squares], linear].concat());
    task.find(again, &root(over / &task.effective));
    Ok(())
}

/// A slipping body: the work theorem of the mass centre gives its speed, the total balance its spin.
fn slipping_body(task: &mut LinearDerivation, body: usize) -> Result<(), DerivationStop> {
    let placed = matches!(task.draft.scene.end, End::Travel(..) | End::Position(..));
    let lead = task.lead();
    let Some(v) = task.m.speed(lead) else { return task.beyond(Beyond::Arrangement) };
    if !placed || task.m.parts.len() > 1 || lead.degree == Degree::Turn {
        return task.beyond(Beyond::SlipInCompany);
    }
    task.tell("energy.slip_two", &[]);
    let share = task.drive.clone();
    let (c_v, omega) = (task.m.parts[body].v, task.m.parts[body].omega);
    let (Some(_), Some(omega)) = (c_v, omega) else { return task.beyond(Beyond::Arrangement) };
    // The mass centre.
    task.tell("energy.centre", &[]);
    let half = ratio(1, 2) * &task.effective * square(v);
    let left = &share * &task.s;
    task.out.equation(&task.draft.symbols, &left, &half);
    let over = number(2) * share * &task.s;
    task.find(v, &root(over / &task.effective));
    task.note(of_body(Quantity::V, body), v);
    task.v = v.into();
    // The whole.
    let turn = Coordinate { body, degree: Degree::Turn };
    let phi = task.draft.free(&[r"\varphi", r"\psi"]);
    let phi = task.draft.symbols.unknown_like(&phi, omega);
    let moments: Vec<(Action, Expr)> = task.row(turn);
    let spin = task.value(&sum(moments.iter().map(|(_, e)| e.clone()).collect::<Vec<_>>()));
    let mut total = Vec::new();
    for (action, e) in task.terms() {
        let way = task.s.clone();
        let arm = moments.iter().find(|(a, _)| a.source == action.source);
        let both = match arm {
            None => e * way,
            Some((a, _)) => {
                let centre = Factors::of(&way).times(&a.along);
                let turned = Factors::of(&phi.into()).times(&a.arm).expr();
                let turned = in_sense(turned, spin);
                &a.force * positive_first(vec![centre.expr(), turned])
            }
        };
        total.push(both);
    }
    // Couples turn the body without moving it.
    for (action, e) in &moments {
        if action.along.is_zero() {
            total.push(in_sense(e * phi, spin));
        }
    }
    let inertia = task.m.inertia_expr(turn);
    let turning = ratio(1, 2) * &inertia * square(omega);
    task.tell("energy.total", &[]);
    let right = half + turning;
    let symbols = &task.draft.symbols;
    let (total, right) = (positive_first(total).symbols(symbols), right.symbols(symbols));
    task.out.blocks.push(Block::Formula(format!("{total} = {right}")));
    let law = omega / v;
    let way = task.distance();
    task.tell("energy.uniform", &[]);
    task.out.equation(&task.draft.symbols, &phi.into(), &(law * &way));
    task.tell("energy.root", &[]);
    let moment = in_sense(sum(moments.into_iter().map(|(_, e)| e).collect::<Vec<_>>()), spin);
    let moment = match moment {
        Expr::Sum(terms) => positive_first(terms),
        other => other,
    };
    let from = number(2) * moment * way / (inertia * v);
    task.find(omega, &from);
    task.note(of_body(Quantity::Omega, body), omega);
    task.get(of_body(Quantity::Phi, body))?;
    if task.draft.asks(Quantity::Heat) || task.draft.asks(Quantity::KineticEnergy) {
        task.tell("energy.slip_works", &[]);
        slip_works(task, body)?;
    }
    Ok(())
}

/// Works of all forces on a slipping body but that of friction, which is the heat lost.
fn slip_works(task: &mut LinearDerivation, body: usize) -> Result<(), DerivationStop> {
    let phi = task.get(of_body(Quantity::Phi, body))?;
    for action in task.m.actions.clone() {
        let symbol = match action.source {
            ForceSource::Tie(t) if action.kind == ForceKind::Given => {
                task.get(of_tie(Quantity::WorkPull, t))?
            }
            ForceSource::Weight(b) => {
                let h = task.get(of_body(Quantity::Rise, b))?;
                let w = task.new_symbol(&["W_{g}"], "J");
                let mass = task.m.parts[b].mass.clone();
                let weight = mass.times(&Factors::of(&task.m.g)).times(&Factors::of(&h.into()));
                task.find(w, &(-weight.expr()));
                w
            }
            ForceSource::Couple(i) => {
                let w = task.new_symbol(&[&tagged("W", &format!("M{}", i + 1))], "J");
                let turn = Coordinate { body, degree: Degree::Turn };
                let spin = task.value(&sum(task.row(turn).into_iter().map(|(_, e)| e).collect::<Vec<_>>()));
                let helps = spin * task.value(&action.arm.expr());
                task.find(w, &in_sense(&action.force * phi, helps));
                w
            }
            ForceSource::Tie(_) => continue,
        };
        task.works.push((action.source, action.kind, symbol));
    }
    Ok(())
}
