//! The first road of a scene of lines and axles: free bodies, elimination by velocity ratios, the integral over displacement.
use crate::figure::names;
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::End;
use crate::scene::Far;
use crate::scene::Owner;
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
use crate::solution::linear::mechanism::Kind;
use crate::solution::linear::mechanism::Source;
use crate::solution::linear::mechanism::lever;
use crate::solution::linear::walk::Spring;
use crate::solution::linear::walk::Walk;
use crate::solution::linear::walk::of_body;
use crate::solution::linear::walk::of_scene;
use crate::solution::linear::walk::of_tie;
use crate::solution::linear::walk::positive_first;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solution::text::Block;
use crate::solution::way;

/// Writes the road up to the speeds at the end, then answers the questions.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(walk: &mut Walk, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), Stop> {
    equations(walk, slip_sense)?;
    if walk.spring.is_some() {
        on_spring(walk)?;
    } else {
        eliminate(walk)?;
        integrate(walk)?;
    }
    if !walk.rolled {
        walk.answer()?;
        walk.out.blocks.push(Block::Picture("graph-speed".to_owned()));
    }
    Ok(())
}

/// The equations of all bodies, numbered, and what closes them.
fn equations(walk: &mut Walk, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), Stop> {
    let mut n = 0;
    let turns = walk.m.parts.iter().filter(|p| p.alpha.is_some()).count();
    for body in 0..walk.m.parts.len() {
        let part = walk.m.parts[body].clone();
        let mut which: Vec<String> = Vec::new();
        let mut lines: Vec<String> = Vec::new();
        let mut line = |walk: &Walk, left: &Expr, right: &Expr| {
            n += 1;
            let ledger = &walk.desk.ledger;
            lines.push(format!(r"{} &= {} \quad ({n})", left.symbols(ledger), right.symbols(ledger)));
            n
        };
        for degree in [Degree::Along, Degree::Turn] {
            let c = Coordinate { body, degree };
            if let Some(a) = walk.m.acceleration(c) {
                let left = sum(walk.row(c).into_iter().map(|(_, e)| e));
                let right = match walk.m.inertia(c).as_slice() {
                    [] => ZERO,
                    [one] => one.times(&Factors::of(&a.into())).expr(),
                    _ => walk.m.inertia_expr(c) * a,
                };
                let at = line(walk, &left, &right);
                walk.rows.push((c, at));
                let name = match (degree, part.path) {
                    (Degree::Along, path) => format!("rows.{path}"),
                    (Degree::Turn, "axle") => "rows.about_axle".to_owned(),
                    (Degree::Turn, _) => "rows.about_centre".to_owned(),
                };
                let mut name = walk.phrase(&name, &[]);
                if degree == Degree::Turn && right != ZERO {
                    let tag = if turns > 1 { part.tag.as_str() } else { "" };
                    let inertia = walk.m.inertia_expr(c).symbols(&walk.desk.ledger);
                    let own = format!("I_{{G{tag}}}");
                    name.push_str(
                        &walk.phrase("rows.inertia", &[("inertia", &format!("${own} = {inertia}$"))]),
                    );
                }
                which.push(name);
            }
            if let (Degree::Along, Some((normal, size))) = (degree, &part.normal) {
                line(walk, &(*normal - size), &ZERO);
                which.push(walk.phrase("rows.across", &[]));
            }
        }
        walk.tell("rows.of", &[("body", &part.label), ("which", &which.join(", "))]);
        walk.out.blocks.push(Block::Formula(aligned(&lines)));
    }
    closing(walk, &mut n);
    // Kinetic friction needs its normal force.
    for (tie, f, from, sense) in walk.kinetic(slip_sense) {
        let body = match &walk.desk.scene.ties[tie] {
            Tie::Slip { body, .. } | Tie::Slide { body, .. } | Tie::Roll { body, .. } => *body,
            Tie::Cord(_) => continue,
        };
        let slips = walk.m.parts[body].slips;
        let direction = way(walk.desk.scene, Owner::Body(body), sense);
        let direction = direction.map_or_else(String::new, |w| walk.desk.words.get(w).to_owned());
        walk.get(of_body(Quantity::Normal, body))?;
        walk.tell(if slips { "close.slip" } else { "close.slide" }, &[("way", &direction)]);
        walk.find(f, &from);
        walk.note(of_body(Quantity::Friction, body), f);
    }
    Ok(())
}

/// Rows of one aligned formula.
pub fn aligned(lines: &[String]) -> String {
    if let [only] = lines {
        return only.replacen(" &= ", " = ", 1);
    }
    format!(r"\begin{{aligned}} {} \end{{aligned}}", lines.join(r" \\ "))
}

/// The relations that the ties bring.
fn closing(walk: &mut Walk, n: &mut usize) {
    let scene = walk.desk.scene;
    for (t, tie) in scene.ties.iter().enumerate() {
        let rolls = match tie {
            Tie::Roll { body, radius_m, .. } => Some((*body, *radius_m)),
            Tie::Slip { body, radius_m, .. } if walk.rolled => Some((*body, *radius_m)),
            _ => None,
        };
        let (name, left, right, force) = if let Some((body, radius)) = rolls {
            let c = walk.desk.number(radius, "R", "m");
            let part = walk.m.parts[body].clone();
            let (Some(a), Some(alpha)) = (part.a, part.alpha) else { continue };
            (
                if walk.rolled { "close.roll_if" } else { "close.roll" },
                Expr::from(a),
                c * alpha,
                walk.m.force_of(t),
            )
        } else if let Tie::Cord(cord) = tie {
            let end = |walk: &mut Walk, end| {
                let (along, arm) = lever(walk.desk, end);
                let part = walk.m.parts[end.body].clone();
                let centre = part.a.map_or(ZERO, |a| along.times(&Factors::of(&a.into())).expr());
                let spin = part.alpha.map_or(ZERO, |a| arm.times(&Factors::of(&a.into())).expr());
                (centre, spin)
            };
            match &cord.to {
                Far::Fixed => {
                    let (centre, spin) = end(walk, &cord.from);
                    let (left, right) = match centre {
                        Expr::Minus(inner) => (*inner, spin),
                        other => (other, -spin),
                    };
                    ("close.fixed", left, right, walk.m.force_of(t))
                }
                Far::Body(other) => {
                    let (centre, spin) = end(walk, &cord.from);
                    let one = centre + spin;
                    let (centre, spin) = end(walk, other);
                    let two = centre + spin;
                    let (left, right) = match one {
                        Expr::Minus(inner) => (*inner, two),
                        one => (one, -two),
                    };
                    ("close.cord", left, right, walk.m.force_of(t))
                }
                Far::Pull(_) | Far::Spring { .. } => continue,
            }
        } else {
            continue;
        };
        *n += 1;
        let force = force.map_or_else(String::new, |f| format!("${}$", walk.desk.ledger.tex(f)));
        let cord = match tie {
            Tie::Cord(cord) if scene.cords_with(Quantity::Tension).count() > 1 => {
                format!(" {}", names::cord(walk.desk.words, scene, cord))
            }
            _ => String::new(),
        };
        walk.tell(name, &[("force", &force), ("cord", &cord)]);
        let ledger = &walk.desk.ledger;
        let formula = format!(r"{} = {} \quad ({n})", left.symbols(ledger), right.symbols(ledger));
        walk.out.blocks.push(Block::Formula(formula));
    }
}

/// Multiplies each row by its velocity ratio and adds: says what drops out, writes the sum.
fn added(walk: &mut Walk) {
    let coordinates: Vec<Coordinate> = walk.desk.scene.coordinates().collect();
    let mut steps = Vec::new();
    let mut gone: Vec<usize> = Vec::new();
    for c in coordinates {
        let ratio = walk.m.ratio(c).clone();
        if ratio.is_zero() || walk.own(c) {
            continue;
        }
        let by = walk.tex(&ratio.expr());
        let n = walk.number_of(c);
        steps.push(walk.phrase("motion.times", &[("n", &n), ("ratio", &by)]));
        for (action, _) in walk.row(c) {
            if let (Kind::Reaction, Source::Tie(t)) = (action.kind, action.source)
                && !gone.contains(&t)
            {
                gone.push(t);
            }
        }
    }
    let left: Vec<Expr> = walk.terms().into_iter().map(|(_, e)| e).collect();
    let lead = walk.lead();
    let Some(a) = walk.m.acceleration(lead) else { return };
    let symbol = format!("${}$", walk.desk.ledger.tex(a));
    let lead_speed =
        walk.m.speed(lead).map_or_else(String::new, |v| format!("${}$", walk.desk.ledger.tex(v)));
    if gone.is_empty() && steps.len() < 2 {
        let n = walk.number_of(lead);
        walk.tell("motion.direct", &[("n", &n), ("a", &symbol)]);
    } else {
        let mut text =
            vec![walk.phrase("motion.multiply", &[("v", &lead_speed), ("steps", &steps.join(", "))])];
        let rolls: Vec<usize> = gone.iter().copied().filter(|t| !is_cord(walk, *t)).collect();
        let fixed: Vec<usize> = gone.iter().copied().filter(|t| is_fixed(walk, *t)).collect();
        let between: Vec<usize> =
            gone.iter().copied().filter(|t| is_cord(walk, *t) && !is_fixed(walk, *t)).collect();
        for (name, ties) in [("roll", rolls), ("cord", between), ("fixed", fixed)] {
            if !ties.is_empty() {
                let forces: Vec<String> = ties
                    .iter()
                    .filter_map(|t| walk.m.force_of(*t))
                    .map(|f| format!("${}$", walk.desk.ledger.tex(f)))
                    .collect();
                let many = if forces.len() > 1 { "s" } else { "" };
                text.push(
                    walk.phrase(&format!("motion.gone_{name}{many}"), &[("forces", &forces.join(", "))]),
                );
            }
        }
        walk.out.say(text.join(" "));
    }
    let right = match &walk.effective {
        Expr::Sum(_) => &walk.effective * a,
        one => Factors::of(one).times(&Factors::of(&a.into())).expr(),
    };
    walk.out.equation(&walk.desk.ledger, &sum(left), &right);
}

fn is_cord(walk: &Walk, tie: usize) -> bool {
    matches!(walk.desk.scene.ties[tie], Tie::Cord(_))
}

fn is_fixed(walk: &Walk, tie: usize) -> bool {
    matches!(&walk.desk.scene.ties[tie], Tie::Cord(c) if c.to == Far::Fixed)
}

/// Symbols of the effective mass and force, kilograms and newtons or their likes for a turn.
pub fn effective_symbols(walk: &mut Walk) -> (Symbol, Symbol) {
    if walk.lead().degree == Degree::Along {
        (walk.new_symbol(&["m_{e}", "m^{*}"], "kg"), walk.new_symbol(&["F_{e}", "F^{*}"], "N"))
    } else {
        (walk.new_symbol(&["I_{e}", "I^{*}"], "kg m^2"), walk.new_symbol(&["M_{e}", "M^{*}"], "N m"))
    }
}

/// Does a formula with the whole sums get too long?
fn long(walk: &Walk) -> bool {
    let terms = |e: &Expr| match e {
        Expr::Sum(terms) => terms.len(),
        _ => 1,
    };
    terms(&walk.effective) > 2 || walk.terms().len() > 3
}

/// The acceleration of the lead from the sum of the equations.
fn eliminate(walk: &mut Walk) -> Result<(), Stop> {
    added(walk);
    let Some(a) = walk.m.acceleration(walk.lead()) else { return walk.beyond(Beyond::Arrangement) };
    let drive = sum(walk.terms().into_iter().map(|(_, e)| e).collect::<Vec<_>>());
    walk.drive = drive.clone();
    if long(walk) {
        let (m_e, f_e) = effective_symbols(walk);
        let (m, f) = (format!("${}$", walk.desk.ledger.tex(m_e)), format!("${}$", walk.desk.ledger.tex(f_e)));
        walk.tell("motion.effective", &[("m", &m), ("f", &f)]);
        walk.find(m_e, &walk.effective.clone());
        walk.find(f_e, &drive);
        walk.effective = m_e.into();
        walk.drive = f_e.into();
    }
    let from = &walk.drive / &walk.effective;
    walk.find(a, &from);
    walk.note(walk.label_of_lead(Quantity::A, Quantity::Alpha), a);
    if walk.desk.asks(Quantity::Direction) && !walk.rolled {
        let way = lead_way(walk);
        walk.tell("motion.direction", &[("way", &way)]);
    }
    Ok(())
}

/// Where the lead moves, in words.
pub fn lead_way(walk: &Walk) -> String {
    let lead = walk.lead();
    let sense = walk.sense * f64::from(walk.m.parts[lead.body].up);
    let name = way(walk.desk.scene, Owner::Body(lead.body), sense);
    name.map_or_else(String::new, |w| walk.desk.words.get(w).to_owned())
}

/// The integral over displacement under constant forces.
fn integrate(walk: &mut Walk) -> Result<(), Stop> {
    let lead = walk.lead();
    let (Some(a), Some(v)) = (walk.m.acceleration(lead), walk.m.speed(lead)) else {
        return walk.beyond(Beyond::Arrangement);
    };
    if walk.rolled {
        return Ok(());
    }
    let a: Expr = a.into();
    let label = walk.label_of_lead(Quantity::V, Quantity::Omega);
    let asks_time = walk.desk.asks(Quantity::T);
    let start = walk.tex(&walk.v0.clone());
    let along = lead.degree == Degree::Along;
    match walk.desk.scene.end {
        End::Travel(..) | End::Position(..) => {
            let name = if asks_time { "motion.integral_then_time" } else { "motion.integral" };
            walk.tell(name, &[]);
            if walk.sense < 0.0 {
                let (s, way) = (walk.tex(&walk.s.clone()), lead_way(walk));
                walk.tell("motion.against", &[("s", &s), ("way", &way)]);
            }
            integral(walk, v, &a.symbols(&walk.desk.ledger), along);
            let gained = number(2) * a * &walk.s;
            let square0 = if walk.v0 == ZERO { ZERO } else { square(walk.v0.clone()) };
            walk.find(v, &root(square0 + gained));
            walk.note(label, v);
            walk.v = v.into();
        }
        End::Time(_, t) => {
            let t = walk.desk.number(t, "t", "s");
            walk.tell("motion.over_time", &[("v0", &start)]);
            let end = &walk.v0 + &a * &t;
            walk.find(v, &in_sense(end, walk.sense));
            walk.note(label, v);
            walk.v = v.into();
            let s = new_way(walk);
            let half = ratio(1, 2) * a * square(&t);
            walk.find(s, &(&walk.v0 * t + half));
            walk.s = s.into();
        }
        End::Speed(_, u) => {
            let u = walk.desk.number(
                u,
                if along { "v_1" } else { r"\omega_1" },
                if along { "m/s" } else { "rad/s" },
            );
            walk.tell("motion.to_speed", &[]);
            walk.v = u.clone();
            let s = new_way(walk);
            let squares = square(u) - square(&walk.v0);
            walk.find(s, &(squares / (number(2) * a)));
            walk.s = s.into();
        }
        End::TurningPoint(_) => {
            walk.tell("motion.to_rest", &[]);
            walk.v = ZERO;
            let s = new_way(walk);
            walk.find(s, &(-(square(&walk.v0) / (number(2) * a))));
            walk.s = s.into();
        }
        End::AtOnce | End::Angle(..) | End::Rolling(_) => return walk.beyond(Beyond::OtherEnd),
    }
    Ok(())
}

/// A symbol for the displacement of the lead.
pub fn new_way(walk: &mut Walk) -> Symbol {
    if walk.lead().degree == Degree::Along {
        walk.new_symbol(&["s", "s_2"], "m")
    } else {
        walk.new_symbol(&[r"\varphi", r"\psi"], "rad")
    }
}

/// `int v dv = int a ds`
fn integral(walk: &mut Walk, v: Symbol, a: &str, along: bool) {
    let ledger = &walk.desk.ledger;
    let v = ledger.tex(v);
    let (from, to) = (walk.v0.symbols(ledger), walk.s.symbols(ledger));
    let d = if along { "ds" } else { r"d\varphi" };
    walk.out.blocks.push(Block::Formula(format!(
        r"{v}\,\frac{{d{v}}}{{{d}}} = {a} \quad\Rightarrow\quad \int_{{{from}}}^{{{v}}} {v}\,d{v} = \int_{{0}}^{{{to}}} {a}\,{d}"
    )));
}

/// A scene with a spring: force and stiffness reckoned to the lead, then the integral.
fn on_spring(walk: &mut Walk) -> Result<(), Stop> {
    let Some(spring) = walk.spring.clone() else { return walk.beyond(Beyond::Arrangement) };
    let lead = walk.lead();
    let (Some(a), Some(v)) = (walk.m.acceleration(lead), walk.m.speed(lead)) else {
        return walk.beyond(Beyond::Arrangement);
    };
    if !matches!(walk.desk.scene.end, End::Travel(..) | End::Position(..)) {
        return walk.beyond(Beyond::SpringWithoutPlace);
    }
    if walk.v0 != ZERO {
        return walk.beyond(Beyond::SpringWithSpeed);
    }
    added(walk);
    // The spring's law: x = x0 - gamma s.
    let (m_e, _) = effective_symbols(walk);
    let first = walk.new_symbol(&["F_{0}", "F_{00}"], "N");
    let kappa = walk.new_symbol(&[r"\kappa", r"\kappa_e"], "N/m");
    let m = format!("${}$", walk.desk.ledger.tex(m_e));
    let gives = walk.value(&spring.gamma.expr()) > 0.0;
    let s = walk.new_symbol(&["s", "s_1"], "m");
    let moved = walk.magnitude(&spring.gamma).times(&Factors::of(&s.into())).expr();
    let moved = walk.tex(&moved);
    walk.tell(if gives { "spring.law_falls" } else { "spring.law_grows" }, &[("moved", &moved)]);
    let stretch = &spring.stretch - spring.gamma.times(&Factors::of(&s.into())).expr();
    let law = &spring.stiffness * stretch;
    walk.out.equation(&walk.desk.ledger, &spring.tension.into(), &law);
    walk.tell("spring.effective", &[("m", &m)]);
    let rest: Vec<Expr> =
        walk.terms().into_iter().filter(|(a, _)| a.kind != Kind::Spring).map(|(_, e)| e).collect();
    let pull =
        Factors::of(&spring.stiffness).times(&spring.gamma).times(&Factors::of(&spring.stretch)).expr();
    walk.find(m_e, &walk.effective.clone());
    let rest = constant_forces(walk, rest);
    walk.find(first, &sum([pull].into_iter().chain(rest.clone())));
    walk.find(kappa, &Factors::of(&spring.stiffness).times(&spring.gamma.squared()).expr());
    walk.effective = m_e.into();
    walk.drive = sum(rest.clone());
    let force = first - kappa * s;
    walk.out.equation(&walk.desk.ledger, &(m_e * a), &force);
    walk.spring = Some(Spring { first: first.into(), kappa: kappa.into(), ..spring.clone() });
    let way = lead_way(walk);
    let symbol = format!("${}$", walk.desk.ledger.tex(first));
    walk.tell("spring.direction", &[("way", &way), ("f", &symbol)]);

    walk.tell("spring.integral", &[]);
    if walk.sense < 0.0 {
        let s = walk.tex(&walk.s.clone());
        walk.tell("motion.against", &[("s", &s), ("way", &way)]);
    }
    integral_of(walk, v, &force, &ZERO, &walk.s.clone(), "s");
    let end = walk.s.clone();
    let twice = number(2) * first * &end;
    let back = kappa * square(&end);
    walk.find(v, &root((twice - back) / m_e));
    walk.note(walk.label_of_lead(Quantity::V, Quantity::Omega), v);
    walk.v = v.into();
    if spring.stretch != ZERO {
        other_origin(walk, &spring, &rest, (m_e, kappa))?;
    }
    walk.tell("spring.at_end", &[]);
    let tension = walk.get(of_tie(Quantity::Tension, spring.tie))?;
    let _ = tension;
    let force = first - kappa * end;
    walk.find(a, &(force / m_e));
    walk.note(walk.label_of_lead(Quantity::A, Quantity::Alpha), a);
    if walk.desk.asks(Quantity::XEq) {
        walk.get(of_scene(Quantity::XEq))?;
    }
    Ok(())
}

/// The sum of the constant forces as one quantity; nothing where there are none.
pub fn constant_forces(walk: &mut Walk, rest: Vec<Expr>) -> Vec<Expr> {
    if rest.is_empty() {
        return rest;
    }
    walk.tell("spring.constant", &[]);
    let f_c = walk.new_symbol(&["F_{c}", "F_{cc}"], "N");
    walk.find(f_c, &sum(rest));
    vec![f_c.into()]
}

/// `m_e int v dv = int (...) ds`
fn integral_of(walk: &mut Walk, v: Symbol, force: &Expr, from: &Expr, to: &Expr, d: &str) {
    let ledger = &walk.desk.ledger;
    let (m, tex) = (walk.effective.symbols(ledger), ledger.tex(v));
    let (from, to, force) = (from.symbols(ledger), to.symbols(ledger), force.symbols(ledger));
    walk.out.blocks.push(Block::Formula(format!(
        r"{m} \int_{{0}}^{{{tex}}} {tex}\,d{tex} = \int_{{{from}}}^{{{to}}} \left({force}\right) d{d}"
    )));
}

/// The same integral with the place counted from where the spring is not stretched.
fn other_origin(
    walk: &mut Walk,
    spring: &Spring,
    rest: &[Expr],
    (m_e, kappa): (Symbol, Symbol),
) -> Result<(), Stop> {
    let Some(v) = walk.m.speed(walk.lead()) else { return walk.beyond(Beyond::Arrangement) };
    let z = walk.new_symbol(&["z", "u"], "m");
    let (z0, z1) = places(walk, spring);
    walk.tell("spring.other_origin", &[]);
    walk.find(z0.0, &z0.1);
    walk.find(z1.0, &z1.1);
    let (z0, z1) = (z0.0, z1.0);
    let force = sum(rest.to_vec()) - kappa * z;
    integral_of(walk, v, &force, &z0.into(), &z1.into(), "z");
    let tex = walk.desk.ledger.tex(v).to_owned();
    let again = walk.desk.ledger.unknown_like(&tex, v);
    let way = walk.s.clone();
    let linear: Vec<Expr> = rest.iter().map(|r| number(2) * r * &way).collect();
    let squares = kappa * (square(z0) - square(z1));
    let over = positive_first([vec![squares], linear].concat());
    walk.find(again, &root(over / m_e));
    Ok(())
}

/// Places of release and of the end, counted from where the spring is not stretched.
pub fn places(walk: &mut Walk, spring: &Spring) -> ((Symbol, Expr), (Symbol, Expr)) {
    let z0 = walk.new_symbol(&["z_{0}", "u_{0}"], "m");
    let z1 = walk.new_symbol(&["z_{1}", "u_{1}"], "m");
    let first = -Factors::of(&spring.stretch).per(&spring.gamma).expr();
    let second = z0 + &walk.s;
    ((z0, first), (z1, second))
}
