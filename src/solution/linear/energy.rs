//! The second road of a scene of lines and axles: states, the work of each force over its own displacement, kinetic energy.
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::End;
use crate::scene::Far;
use crate::scene::Quantity;
use crate::scene::Tie;
use crate::solution::expr::Expr;
use crate::solution::expr::Symbol;
use crate::solution::expr::ZERO;
use crate::solution::expr::in_sense;
use crate::solution::expr::number;
use crate::solution::expr::ratio;
use crate::solution::expr::root;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::factors::Factors;
use crate::solution::linear::mechanism::Action;
use crate::solution::linear::mechanism::Kind;
use crate::solution::linear::mechanism::Source;
use crate::solution::linear::mechanism::tagged;
use crate::solution::linear::motion::aligned;
use crate::solution::linear::motion::constant_forces;
use crate::solution::linear::motion::effective_symbols;
use crate::solution::linear::motion::lead_way;
use crate::solution::linear::motion::new_way;
use crate::solution::linear::motion::places;
use crate::solution::linear::walk::Spring;
use crate::solution::linear::walk::Walk;
use crate::solution::linear::walk::of_body;
use crate::solution::linear::walk::of_tie;
use crate::solution::linear::walk::positive_first;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solution::text::Block;

/// Writes the road and answers the questions along it.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(walk: &mut Walk, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), Stop> {
    let slipping = walk.m.parts.iter().position(|p| p.slips);
    friction(walk, slip_sense)?;
    walk.drive = sum(walk
        .terms()
        .into_iter()
        .filter(|(a, _)| a.kind != Kind::Spring)
        .map(|(_, e)| e)
        .collect::<Vec<_>>());
    match slipping {
        Some(body) => slipping_body(walk, body)?,
        None => one_freedom(walk)?,
    }
    if !walk.rolled {
        walk.out.blocks.push(Block::Picture("energy".to_owned()));
        walk.answer()?;
    }
    Ok(())
}

/// Kinetic friction: its size is a law of its own on both roads.
fn friction(walk: &mut Walk, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), Stop> {
    for (tie, f, from, _) in walk.kinetic(slip_sense) {
        let body = match &walk.desk.scene.ties[tie] {
            Tie::Slip { body, .. } | Tie::Slide { body, .. } | Tie::Roll { body, .. } => *body,
            Tie::Cord(_) => continue,
        };
        walk.get(of_body(Quantity::Normal, body))?;
        walk.tell("energy.friction", &[]);
        walk.find(f, &from);
        walk.note(of_body(Quantity::Friction, body), f);
    }
    Ok(())
}

/// What does no work, and why.
fn idle(walk: &mut Walk) {
    let scene = walk.desk.scene;
    let mut reasons = Vec::new();
    let symbols = |walk: &Walk, list: Vec<Symbol>| {
        let list: Vec<String> = list.iter().map(|s| format!("${}$", walk.desk.ledger.tex(*s))).collect();
        list.join(", ")
    };
    let normals: Vec<Symbol> =
        walk.m.parts.iter().filter_map(|p| p.normal.as_ref().map(|(n, _)| *n)).collect();
    if !normals.is_empty() {
        reasons.push(walk.phrase("energy.idle_normal", &[("forces", &symbols(walk, normals))]));
    }
    let of = |walk: &Walk, test: &dyn Fn(&Tie) -> bool| -> Vec<Symbol> {
        let ties = scene.ties.iter().enumerate().filter(|(_, t)| test(t));
        ties.filter_map(|(t, _)| walk.m.force_of(t)).collect()
    };
    let rolled = walk.rolled;
    let rolls = of(walk, &|t| matches!(t, Tie::Roll { .. }) || (rolled && matches!(t, Tie::Slip { .. })));
    let cords = of(walk, &|t| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Body(_))));
    let fixed = of(walk, &|t| matches!(t, Tie::Cord(c) if c.to == Far::Fixed));
    for (name, list) in [("roll", rolls), ("cord", cords), ("fixed", fixed)] {
        if !list.is_empty() {
            reasons.push(walk.phrase(&format!("energy.idle_{name}"), &[("forces", &symbols(walk, list))]));
        }
    }
    if !reasons.is_empty() {
        walk.tell("energy.idle", &[]);
        walk.out.blocks.push(Block::List(reasons));
    }
}

/// The kinetic energy in symbols, reckoned to the lead.
fn kinetic(walk: &mut Walk) {
    let lead = walk.lead();
    let coordinates: Vec<Coordinate> = walk.desk.scene.coordinates().collect();
    let mut parts = Vec::new();
    for c in &coordinates {
        let Some(v) = walk.m.speed(*c) else { continue };
        if walk.own(*c) || walk.m.ratio(*c).is_zero() {
            continue;
        }
        for i in walk.m.inertia(*c) {
            parts.push(ratio(1, 2) * i.expr() * square(v));
        }
    }
    let Some(v) = walk.m.speed(lead) else { return };
    let whole = ratio(1, 2) * &walk.effective * square(v);
    let first = sum(parts);
    walk.tell("energy.kinetic_sum", &[]);
    let ledger = &walk.desk.ledger;
    let e = walk.desk.free(&["E_{k}"]);
    let formula = if first == whole {
        format!("{e} = {}", whole.symbols(ledger))
    } else {
        aligned(&[format!("{e} &= {}", first.symbols(ledger)), format!("&= {}", whole.symbols(ledger))])
    };
    walk.out.blocks.push(Block::Formula(formula));
    if walk.spring.is_some() || matches!(&walk.effective, Expr::Sum(t) if t.len() > 2) {
        let (m_e, _) = effective_symbols(walk);
        walk.tell("energy.effective", &[]);
        walk.find(m_e, &walk.effective.clone());
        walk.effective = m_e.into();
    }
}

/// The work of each force up to the end.
fn works(walk: &mut Walk) -> Result<(), Stop> {
    for (action, share) in walk.terms() {
        if walk.works.iter().any(|(s, ..)| *s == action.source) {
            continue;
        }
        let symbol = match action.source {
            Source::Tie(t) if action.kind == Kind::Given => walk.get(of_tie(Quantity::WorkPull, t))?,
            Source::Tie(_) if action.kind == Kind::Spring => {
                let Some(spring) = walk.spring.clone() else { return walk.beyond(Beyond::Arrangement) };
                let x1 = walk.new_symbol(&["x_{1}", r"\xi_{1}"], "m");
                let stretch = walk.stretch_at(&spring, &walk.s.clone());
                let gives = walk.value(&stretch).abs() < walk.value(&spring.stretch).abs();
                walk.tell(if gives { "energy.spring_gives" } else { "energy.spring_takes" }, &[]);
                walk.find(x1, &stretch);
                let w = walk.new_symbol(&["W_{s}", r"W_{\mathrm{s}}"], "J");
                let squares = square(&spring.stretch) - square(x1);
                walk.find(w, &(ratio(1, 2) * &spring.stiffness * squares));
                w
            }
            Source::Tie(_) => {
                // A slide; of a slip, the caller knows the way.
                let w = walk.new_symbol(&[&tagged("W", "F"), &tagged("W", "R")], "J");
                walk.tell("energy.slide", &[]);
                walk.find(w, &Factors::of(&share).times(&Factors::of(&walk.s)).expr());
                w
            }
            Source::Weight(body) => {
                let h = walk.get(of_body(Quantity::Rise, body))?;
                let several =
                    walk.terms().iter().filter(|(a, _)| matches!(a.source, Source::Weight(_))).count() > 1;
                let tag = if several { format!("g{}", walk.m.parts[body].tag) } else { "g".to_owned() };
                let w = walk.new_symbol(&[&tagged("W", &tag)], "J");
                let mass = walk.m.parts[body].mass.clone();
                let weight = mass.times(&Factors::of(&walk.m.g)).times(&Factors::of(&h.into()));
                walk.find(w, &(-weight.expr()));
                w
            }
            Source::Couple(i) => {
                let tag =
                    if walk.desk.scene.couples.len() > 1 { format!("M{}", i + 1) } else { "M".to_owned() };
                let w = walk.new_symbol(&[&tagged("W", &tag)], "J");
                let phi = walk.get(of_body(Quantity::Phi, action.body))?;
                let helps = walk.value(&share) * walk.sense;
                walk.tell("energy.couple", &[]);
                walk.find(w, &in_sense(&action.force * phi, helps));
                w
            }
        };
        walk.works.push((action.source, action.kind, symbol));
    }
    Ok(())
}

fn one_freedom(walk: &mut Walk) -> Result<(), Stop> {
    let lead = walk.lead();
    let Some(v) = walk.m.speed(lead) else { return walk.beyond(Beyond::Arrangement) };
    let label = walk.label_of_lead(Quantity::V, Quantity::Omega);
    let placed = matches!(walk.desk.scene.end, End::Travel(..) | End::Position(..));
    walk.tell(if walk.v0 == ZERO { "energy.states_rest" } else { "energy.states_moving" }, &[]);
    idle(walk);
    let start = |walk: &Walk| {
        if walk.v0 == ZERO { ZERO } else { ratio(1, 2) * &walk.effective * square(&walk.v0) }
    };
    if placed {
        walk.tell("energy.works", &[]);
        works(walk)?;
        kinetic(walk);
        let works = walk.works().unwrap_or(ZERO);
        let end = ratio(1, 2) * &walk.effective * square(v);
        walk.tell("energy.balance", &[]);
        let right = end - start(walk);
        walk.out.equation(&walk.desk.ledger, &works, &right);
        let gained = number(2) * works / &walk.effective;
        let square0 = if walk.v0 == ZERO { ZERO } else { square(walk.v0.clone()) };
        walk.find(v, &root(square0 + gained));
        walk.note(label, v);
        walk.v = v.into();
        if let Some(spring) = walk.spring.clone().filter(|s| s.stretch != ZERO) {
            other_origin(walk, &spring, v)?;
        }
        if walk.desk.asks(Quantity::Direction) && !walk.rolled {
            let way = lead_way(walk);
            walk.tell(
                if walk.spring.is_some() { "energy.direction_spring" } else { "energy.direction" },
                &[("way", &way)],
            );
        }
        return Ok(());
    }
    if walk.spring.is_some() {
        return walk.beyond(Beyond::SpringWithoutPlace);
    }
    // The place is not known: work per displacement first.
    kinetic(walk);
    walk.tell("energy.per_way", &[]);
    let terms: Vec<Expr> = walk.terms().into_iter().map(|(_, e)| e).collect();
    let (_, f_e) = effective_symbols(walk);
    walk.find(f_e, &sum(terms));
    walk.drive = f_e.into();
    let per = &walk.drive / &walk.effective;
    match walk.desk.scene.end {
        End::Speed(_, u) => {
            let along = lead.degree == Degree::Along;
            let u = walk.desk.number(
                u,
                if along { "v_1" } else { r"\omega_1" },
                if along { "m/s" } else { "rad/s" },
            );
            walk.v = u;
        }
        End::TurningPoint(_) => walk.v = ZERO,
        End::Time(_, t) => {
            let t = walk.desk.number(t, "t", "s");
            walk.tell("energy.rate_time", &[]);
            let end = &walk.v0 + per * &t;
            walk.find(v, &in_sense(end, walk.sense));
            walk.note(label, v);
            walk.v = v.into();
            let s = new_way(walk);
            walk.tell("energy.mean_speed", &[]);
            let both = &walk.v0 + in_sense(v.into(), walk.sense);
            walk.find(s, &(ratio(1, 2) * both * t));
            walk.s = s.into();
            return works_if_asked(walk);
        }
        _ => return walk.beyond(Beyond::OtherEnd),
    }
    let s = new_way(walk);
    walk.tell("energy.balance", &[]);
    let squares = square(&walk.v) - square(&walk.v0);
    let from = &walk.effective * squares / (number(2) * &walk.drive);
    walk.find(s, &from);
    walk.s = s.into();
    works_if_asked(walk)
}

/// The works of the forces, where heat or kinetic energy is asked and the displacement had to be found first.
fn works_if_asked(walk: &mut Walk) -> Result<(), Stop> {
    if !walk.desk.asks(Quantity::Heat) && !walk.desk.asks(Quantity::KineticEnergy) {
        return Ok(());
    }
    walk.tell("energy.works", &[]);
    works(walk)
}

/// Conservation of energy with heights and the spring counted from where the spring is not stretched.
fn other_origin(walk: &mut Walk, spring: &Spring, v: Symbol) -> Result<(), Stop> {
    let (z0, z1) = places(walk, spring);
    let z = walk.new_symbol(&["z", "u"], "m");
    let stretch = spring.gamma.times(&Factors::of(&z.into())).opposite().expr();
    let stretch = walk.tex(&stretch);
    walk.tell("energy.other_origin", &[("stretch", &stretch)]);
    walk.find(z0.0, &z0.1);
    walk.find(z1.0, &z1.1);
    let (z0, z1): (Expr, Expr) = (z0.0.into(), z1.0.into());
    let rest: Vec<Expr> =
        walk.terms().into_iter().filter(|(a, _)| a.kind != Kind::Spring).map(|(_, e)| e).collect();
    let rest = constant_forces(walk, rest);
    let kappa = walk.new_symbol(&[r"\kappa", r"\kappa_e"], "N/m");
    walk.find(kappa, &spring.kappa);
    walk.drive = sum(rest.clone());
    let stiffness: Expr = kappa.into();
    let energy = |z: &Expr| {
        let stored = ratio(1, 2) * &stiffness * square(z);
        let others = rest.iter().map(|r| -(r * z));
        sum([stored].into_iter().chain(others).collect::<Vec<_>>())
    };
    let moving = ratio(1, 2) * &walk.effective * square(v);
    let (before, after) = (energy(&z0), energy(&z1) + moving);
    walk.out.equation(&walk.desk.ledger, &before, &after);
    let tex = walk.desk.ledger.tex(v).to_owned();
    let again = walk.desk.ledger.unknown_like(&tex, v);
    let squares = stiffness * (square(&z0) - square(&z1));
    let linear: Vec<Expr> = rest.iter().map(|r| number(2) * r * &walk.s).collect();
    let over = positive_first([vec![squares], linear].concat());
    walk.find(again, &root(over / &walk.effective));
    Ok(())
}

/// A slipping body: the work theorem of the mass centre gives its speed, the total balance its spin.
fn slipping_body(walk: &mut Walk, body: usize) -> Result<(), Stop> {
    let placed = matches!(walk.desk.scene.end, End::Travel(..) | End::Position(..));
    let lead = walk.lead();
    let Some(v) = walk.m.speed(lead) else { return walk.beyond(Beyond::Arrangement) };
    if !placed || walk.m.parts.len() > 1 || lead.degree == Degree::Turn {
        return walk.beyond(Beyond::SlipInCompany);
    }
    walk.tell("energy.slip_two", &[]);
    let share = walk.drive.clone();
    let (c_v, omega) = (walk.m.parts[body].v, walk.m.parts[body].omega);
    let (Some(_), Some(omega)) = (c_v, omega) else { return walk.beyond(Beyond::Arrangement) };
    // The mass centre.
    walk.tell("energy.centre", &[]);
    let half = ratio(1, 2) * &walk.effective * square(v);
    let left = &share * &walk.s;
    walk.out.equation(&walk.desk.ledger, &left, &half);
    let over = number(2) * share * &walk.s;
    walk.find(v, &root(over / &walk.effective));
    walk.note(of_body(Quantity::V, body), v);
    walk.v = v.into();
    // The whole.
    let turn = Coordinate { body, degree: Degree::Turn };
    let phi = walk.desk.free(&[r"\varphi", r"\psi"]);
    let phi = walk.desk.ledger.unknown_like(&phi, omega);
    let moments: Vec<(Action, Expr)> = walk.row(turn);
    let spin = walk.value(&sum(moments.iter().map(|(_, e)| e.clone()).collect::<Vec<_>>()));
    let mut total = Vec::new();
    for (action, e) in walk.terms() {
        let way = walk.s.clone();
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
    let inertia = walk.m.inertia_expr(turn);
    let turning = ratio(1, 2) * &inertia * square(omega);
    walk.tell("energy.total", &[]);
    let right = half + turning;
    let ledger = &walk.desk.ledger;
    let (total, right) = (positive_first(total).symbols(ledger), right.symbols(ledger));
    walk.out.blocks.push(Block::Formula(format!("{total} = {right}")));
    let law = omega / v;
    let way = walk.distance();
    walk.tell("energy.uniform", &[]);
    walk.out.equation(&walk.desk.ledger, &phi.into(), &(law * &way));
    walk.tell("energy.root", &[]);
    let moment = in_sense(sum(moments.into_iter().map(|(_, e)| e).collect::<Vec<_>>()), spin);
    let moment = match moment {
        Expr::Sum(terms) => positive_first(terms),
        other => other,
    };
    let from = number(2) * moment * way / (inertia * v);
    walk.find(omega, &from);
    walk.note(of_body(Quantity::Omega, body), omega);
    walk.get(of_body(Quantity::Phi, body))?;
    if walk.desk.asks(Quantity::Heat) || walk.desk.asks(Quantity::KineticEnergy) {
        walk.tell("energy.slip_works", &[]);
        slip_works(walk, body)?;
    }
    Ok(())
}

/// Works of all forces on a slipping body but that of friction, which is the heat lost.
fn slip_works(walk: &mut Walk, body: usize) -> Result<(), Stop> {
    let phi = walk.get(of_body(Quantity::Phi, body))?;
    for action in walk.m.actions.clone() {
        let symbol = match action.source {
            Source::Tie(t) if action.kind == Kind::Given => walk.get(of_tie(Quantity::WorkPull, t))?,
            Source::Weight(b) => {
                let h = walk.get(of_body(Quantity::Rise, b))?;
                let w = walk.new_symbol(&["W_{g}"], "J");
                let mass = walk.m.parts[b].mass.clone();
                let weight = mass.times(&Factors::of(&walk.m.g)).times(&Factors::of(&h.into()));
                walk.find(w, &(-weight.expr()));
                w
            }
            Source::Couple(i) => {
                let w = walk.new_symbol(&[&tagged("W", &format!("M{}", i + 1))], "J");
                let turn = Coordinate { body, degree: Degree::Turn };
                let spin = walk.value(&sum(walk.row(turn).into_iter().map(|(_, e)| e).collect::<Vec<_>>()));
                let helps = spin * walk.value(&action.arm.expr());
                walk.find(w, &in_sense(&action.force * phi, helps));
                w
            }
            Source::Tie(_) => continue,
        };
        walk.works.push((action.source, action.kind, symbol));
    }
    Ok(())
}
