//! The first method of a scene of lines and axles: free bodies, elimination by velocity ratios, the integral over displacement.
use crate::figure::names;
use crate::scene::{Coordinate, Degree, End, Far, Owner, Quantity, Tie};
use crate::solution::expr::{Expr, SymbolId, ZERO, in_sense, number, ratio, root, square, sum};
use crate::solution::factors::Factors;
use crate::solution::linear::derivation::{
    CordSpring, LinearDerivation, of_body, of_scene, of_tie, positive_first,
};
use crate::solution::linear::mechanism::{ForceKind, ForceSource, lever};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::text::Block;
use crate::solution::way;

/// Writes the derivation up to the speeds at the end, then answers the questions.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(task: &mut LinearDerivation, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), DerivationStop> {
    equations(task, slip_sense)?;
    if task.spring.is_some() {
        on_spring(task)?;
    } else {
        eliminate(task)?;
        integrate(task)?;
    }
    if !task.rolled {
        task.answer()?;
        task.out.blocks.push(Block::Picture("graph-speed".to_owned()));
    }
    Ok(())
}

/// The equations of all bodies, numbered, and what closes them.
fn equations(task: &mut LinearDerivation, slip_sense: &dyn Fn(usize) -> f64) -> Result<(), DerivationStop> {
    let mut n = 0;
    let turns = task.m.parts.iter().filter(|p| p.alpha.is_some()).count();
    for body in 0..task.m.parts.len() {
        let part = task.m.parts[body].clone();
        let mut which: Vec<String> = Vec::new();
        let mut lines: Vec<String> = Vec::new();
        let mut line = |task: &LinearDerivation, left: &Expr, right: &Expr| {
            n += 1;
            let symbols = &task.draft.symbols;
            lines.push(format!(r"{} &= {} \quad ({n})", left.symbols(symbols), right.symbols(symbols)));
            n
        };
        for degree in [Degree::Along, Degree::Turn] {
            let c = Coordinate { body, degree };
            if let Some(a) = task.m.acceleration(c) {
                let left = sum(task.row(c).into_iter().map(|(_, e)| e));
                let right = match task.m.inertia(c).as_slice() {
                    [] => ZERO,
                    [one] => one.times(&Factors::of(&a.into())).expr(),
                    _ => task.m.inertia_expr(c) * a,
                };
                let at = line(task, &left, &right);
                task.rows.push((c, at));
                let name = match (degree, part.path) {
                    (Degree::Along, path) => format!("rows.{path}"),
                    (Degree::Turn, "axle") => "rows.about_axle".to_owned(),
                    (Degree::Turn, _) => "rows.about_centre".to_owned(),
                };
                let mut name = task.phrase(&name, &[]);
                if degree == Degree::Turn && right != ZERO {
                    let tag = if turns > 1 { part.tag.as_str() } else { "" };
                    let inertia = task.m.inertia_expr(c).symbols(&task.draft.symbols);
                    let own = format!("I_{{G{tag}}}");
                    name.push_str(
                        &task.phrase("rows.inertia", &[("inertia", &format!("${own} = {inertia}$"))]),
                    );
                }
                which.push(name);
            }
            if let (Degree::Along, Some((normal, size))) = (degree, &part.normal) {
                line(task, &(*normal - size), &ZERO);
                which.push(task.phrase("rows.across", &[]));
            }
        }
        task.tell("rows.of", &[("body", &part.label), ("which", &which.join(", "))]);
        task.out.blocks.push(Block::Formula(aligned(&lines)));
    }
    closing(task, &mut n);
    // Kinetic friction needs its normal force.
    for (tie, f, from, sense) in task.kinetic(slip_sense) {
        let body = match &task.draft.scene.ties[tie] {
            Tie::Slip { body, .. } | Tie::Slide { body, .. } | Tie::Roll { body, .. } => *body,
            Tie::Cord(_) => continue,
        };
        let slips = task.m.parts[body].slips;
        let direction = way(task.draft.scene, Owner::Body(body), sense);
        let direction = direction.map_or_else(String::new, |w| task.draft.words.get(w).to_owned());
        task.get(of_body(Quantity::Normal, body))?;
        task.tell(if slips { "close.slip" } else { "close.slide" }, &[("way", &direction)]);
        task.find(f, &from);
        task.note(of_body(Quantity::Friction, body), f);
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
fn closing(task: &mut LinearDerivation, n: &mut usize) {
    let scene = task.draft.scene;
    for (t, tie) in scene.ties.iter().enumerate() {
        let rolls = match tie {
            Tie::Roll { body, radius_m, .. } => Some((*body, *radius_m)),
            Tie::Slip { body, radius_m, .. } if task.rolled => Some((*body, *radius_m)),
            _ => None,
        };
        let (name, left, right, force) = if let Some((body, radius)) = rolls {
            let c = task.draft.number(radius, "R", "m");
            let part = task.m.parts[body].clone();
            let (Some(a), Some(alpha)) = (part.a, part.alpha) else { continue };
            (
                if task.rolled { "close.roll_if" } else { "close.roll" },
                Expr::from(a),
                c * alpha,
                task.m.force_of(t),
            )
        } else if let Tie::Cord(cord) = tie {
            let end = |task: &mut LinearDerivation, end| {
                let (along, arm) = lever(task.draft, end);
                let part = task.m.parts[end.body].clone();
                let centre = part.a.map_or(ZERO, |a| along.times(&Factors::of(&a.into())).expr());
                let spin = part.alpha.map_or(ZERO, |a| arm.times(&Factors::of(&a.into())).expr());
                (centre, spin)
            };
            match &cord.to {
                Far::Fixed => {
                    let (centre, spin) = end(task, &cord.from);
                    let (left, right) = match centre {
                        Expr::Minus(inner) => (*inner, spin),
                        other => (other, -spin),
                    };
                    ("close.fixed", left, right, task.m.force_of(t))
                }
                Far::Body(other) => {
                    let (centre, spin) = end(task, &cord.from);
                    let one = centre + spin;
                    let (centre, spin) = end(task, other);
                    let two = centre + spin;
                    let (left, right) = match one {
                        Expr::Minus(inner) => (*inner, two),
                        one => (one, -two),
                    };
                    ("close.cord", left, right, task.m.force_of(t))
                }
                Far::Pull(_) | Far::Spring { .. } => continue,
            }
        } else {
            continue;
        };
        *n += 1;
        let force = force.map_or_else(String::new, |f| format!("${}$", task.draft.symbols.tex(f)));
        let cord = match tie {
            Tie::Cord(cord) if scene.cords_with(Quantity::Tension).count() > 1 => {
                format!(" {}", names::cord(task.draft.words, scene, cord))
            }
            _ => String::new(),
        };
        task.tell(name, &[("force", &force), ("cord", &cord)]);
        let symbols = &task.draft.symbols;
        let formula = format!(r"{} = {} \quad ({n})", left.symbols(symbols), right.symbols(symbols));
        task.out.blocks.push(Block::Formula(formula));
    }
}

/// Multiplies each row by its velocity ratio and adds: says what drops out, writes the sum.
fn added(task: &mut LinearDerivation) {
    let coordinates: Vec<Coordinate> = task.draft.scene.coordinates().collect();
    let mut steps = Vec::new();
    let mut gone: Vec<usize> = Vec::new();
    for c in coordinates {
        let ratio = task.m.ratio(c).clone();
        if ratio.is_zero() || task.own(c) {
            continue;
        }
        let by = task.tex(&ratio.expr());
        let n = task.number_of(c);
        steps.push(task.phrase("motion.times", &[("n", &n), ("ratio", &by)]));
        for (action, _) in task.row(c) {
            if let (ForceKind::Reaction, ForceSource::Tie(t)) = (action.kind, action.source)
                && !gone.contains(&t)
            {
                gone.push(t);
            }
        }
    }
    let left: Vec<Expr> = task.terms().into_iter().map(|(_, e)| e).collect();
    let lead = task.lead();
    let Some(a) = task.m.acceleration(lead) else { return };
    let symbol = format!("${}$", task.draft.symbols.tex(a));
    let lead_speed =
        task.m.speed(lead).map_or_else(String::new, |v| format!("${}$", task.draft.symbols.tex(v)));
    if gone.is_empty() && steps.len() < 2 {
        let n = task.number_of(lead);
        task.tell("motion.direct", &[("n", &n), ("a", &symbol)]);
    } else {
        let mut text =
            vec![task.phrase("motion.multiply", &[("v", &lead_speed), ("steps", &steps.join(", "))])];
        let rolls: Vec<usize> = gone.iter().copied().filter(|t| !is_cord(task, *t)).collect();
        let fixed: Vec<usize> = gone.iter().copied().filter(|t| is_fixed(task, *t)).collect();
        let between: Vec<usize> =
            gone.iter().copied().filter(|t| is_cord(task, *t) && !is_fixed(task, *t)).collect();
        for (name, ties) in [("roll", rolls), ("cord", between), ("fixed", fixed)] {
            if !ties.is_empty() {
                let forces: Vec<String> = ties
                    .iter()
                    .filter_map(|t| task.m.force_of(*t))
                    .map(|f| format!("${}$", task.draft.symbols.tex(f)))
                    .collect();
                let many = if forces.len() > 1 { "s" } else { "" };
                text.push(
                    task.phrase(&format!("motion.gone_{name}{many}"), &[("forces", &forces.join(", "))]),
                );
            }
        }
        task.out.say(text.join(" "));
    }
    let right = match &task.effective {
        Expr::Sum(_) => &task.effective * a,
        one => Factors::of(one).times(&Factors::of(&a.into())).expr(),
    };
    task.out.equation(&task.draft.symbols, &sum(left), &right);
}

fn is_cord(task: &LinearDerivation, tie: usize) -> bool {
    matches!(task.draft.scene.ties[tie], Tie::Cord(_))
}

fn is_fixed(task: &LinearDerivation, tie: usize) -> bool {
    matches!(&task.draft.scene.ties[tie], Tie::Cord(c) if c.to == Far::Fixed)
}

/// Symbols of the effective mass and force, kilograms and newtons or their likes for a turn.
pub fn effective_symbols(task: &mut LinearDerivation) -> (SymbolId, SymbolId) {
    if task.lead().degree == Degree::Along {
        (task.new_symbol(&["m_{e}", "m^{*}"], "kg"), task.new_symbol(&["F_{e}", "F^{*}"], "N"))
    } else {
        (task.new_symbol(&["I_{e}", "I^{*}"], "kg m^2"), task.new_symbol(&["M_{e}", "M^{*}"], "N m"))
    }
}

/// Does a formula with the whole sums get too long?
fn long(task: &LinearDerivation) -> bool {
    let terms = |e: &Expr| match e {
        Expr::Sum(terms) => terms.len(),
        _ => 1,
    };
    terms(&task.effective) > 2 || task.terms().len() > 3
}

/// The acceleration of the lead from the sum of the equations.
fn eliminate(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    added(task);
    let Some(a) = task.m.acceleration(task.lead()) else {
        return task.beyond(Beyond::Arrangement);
    };
    let drive = sum(task.terms().into_iter().map(|(_, e)| e).collect::<Vec<_>>());
    task.drive = drive.clone();
    if long(task) {
        let (m_e, f_e) = effective_symbols(task);
        let (m, f) =
            (format!("${}$", task.draft.symbols.tex(m_e)), format!("${}$", task.draft.symbols.tex(f_e)));
        task.tell("motion.effective", &[("m", &m), ("f", &f)]);
        task.find(m_e, &task.effective.clone());
        task.find(f_e, &drive);
        task.effective = m_e.into();
        task.drive = f_e.into();
    }
    let from = &task.drive / &task.effective;
    task.find(a, &from);
    task.note(task.label_of_lead(Quantity::A, Quantity::Alpha), a);
    if task.draft.asks(Quantity::Direction) && !task.rolled {
        let way = lead_way(task);
        task.tell("motion.direction", &[("way", &way)]);
    }
    Ok(())
}

/// Where the lead moves, in words.
pub fn lead_way(task: &LinearDerivation) -> String {
    let lead = task.lead();
    let sense = task.sense * f64::from(task.m.parts[lead.body].up);
    let name = way(task.draft.scene, Owner::Body(lead.body), sense);
    name.map_or_else(String::new, |w| task.draft.words.get(w).to_owned())
}

/// The integral over displacement under constant forces.
fn integrate(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    let lead = task.lead();
    let (Some(a), Some(v)) = (task.m.acceleration(lead), task.m.speed(lead)) else {
        return task.beyond(Beyond::Arrangement);
    };
    if task.rolled {
        return Ok(());
    }
    let a: Expr = a.into();
    let label = task.label_of_lead(Quantity::V, Quantity::Omega);
    let asks_time = task.draft.asks(Quantity::T);
    let start = task.tex(&task.v0.clone());
    let along = lead.degree == Degree::Along;
    match task.draft.scene.end {
        End::Travel(..) | End::Position(..) => {
            let name = if asks_time { "motion.integral_then_time" } else { "motion.integral" };
            task.tell(name, &[]);
            if task.sense < 0.0 {
                let (s, way) = (task.tex(&task.s.clone()), lead_way(task));
                task.tell("motion.against", &[("s", &s), ("way", &way)]);
            }
            integral(task, v, &a.symbols(&task.draft.symbols), along);
            let gained = number(2) * a * &task.s;
            let square0 = if task.v0 == ZERO { ZERO } else { square(task.v0.clone()) };
            task.find(v, &root(square0 + gained));
            task.note(label, v);
            task.v = v.into();
        }
        End::Time(_, t) => {
            let t = task.draft.number(t, "t", "s");
            task.tell("motion.over_time", &[("v0", &start)]);
            let end = &task.v0 + &a * &t;
            task.find(v, &in_sense(end, task.sense));
            task.note(label, v);
            task.v = v.into();
            let s = new_way(task);
            let half = ratio(1, 2) * a * square(&t);
            task.find(s, &(&task.v0 * t + half));
            task.s = s.into();
        }
        End::Speed(_, u) => {
            let u = task.draft.number(
                u,
                if along { "v_1" } else { r"\omega_1" },
                if along { "m/s" } else { "rad/s" },
            );
            task.tell("motion.to_speed", &[]);
            task.v = u.clone();
            let s = new_way(task);
            let squares = square(u) - square(&task.v0);
            task.find(s, &(squares / (number(2) * a)));
            task.s = s.into();
        }
        End::TurningPoint(_) => {
            task.tell("motion.to_rest", &[]);
            task.v = ZERO;
            let s = new_way(task);
            task.find(s, &(-(square(&task.v0) / (number(2) * a))));
            task.s = s.into();
        }
        End::AtOnce | End::Angle(..) | End::Rolling(_) | End::Leaves(_) => {
            return task.beyond(Beyond::OtherEnd);
        }
    }
    Ok(())
}

/// A symbol for the displacement of the lead.
pub fn new_way(task: &mut LinearDerivation) -> SymbolId {
    if task.lead().degree == Degree::Along {
        task.new_symbol(&["s", "s_2"], "m")
    } else {
        task.new_symbol(&[r"\varphi", r"\psi"], "rad")
    }
}

/// `int v dv = int a ds`
fn integral(task: &mut LinearDerivation, v: SymbolId, a: &str, along: bool) {
    let symbols = &task.draft.symbols;
    let v = symbols.tex(v);
    let (from, to) = (task.v0.symbols(symbols), task.s.symbols(symbols));
    let d = if along { "ds" } else { r"d\varphi" };
    task.out.blocks.push(Block::Formula(format!(
        r"{v}\,\frac{{d{v}}}{{{d}}} = {a} \quad\Rightarrow\quad \int_{{{from}}}^{{{v}}} {v}\,d{v} = \int_{{0}}^{{{to}}} {a}\,{d}"
    )));
}

/// A scene with a spring: force and stiffness reckoned to the lead, then the integral.
fn on_spring(task: &mut LinearDerivation) -> Result<(), DerivationStop> {
    let Some(spring) = task.spring.clone() else { return task.beyond(Beyond::Arrangement) };
    let lead = task.lead();
    let (Some(a), Some(v)) = (task.m.acceleration(lead), task.m.speed(lead)) else {
        return task.beyond(Beyond::Arrangement);
    };
    if !matches!(task.draft.scene.end, End::Travel(..) | End::Position(..)) {
        return task.beyond(Beyond::SpringWithoutPlace);
    }
    if task.v0 != ZERO {
        return task.beyond(Beyond::SpringWithSpeed);
    }
    added(task);
    // The spring's law: x = x0 - gamma s.
    let (m_e, _) = effective_symbols(task);
    let first = task.new_symbol(&["F_{0}", "F_{00}"], "N");
    let kappa = task.new_symbol(&[r"\kappa", r"\kappa_e"], "N/m");
    let m = format!("${}$", task.draft.symbols.tex(m_e));
    let gives = task.value(&spring.gamma.expr()) > 0.0;
    let s = task.new_symbol(&["s", "s_1"], "m");
    let moved = task.magnitude(&spring.gamma).times(&Factors::of(&s.into())).expr();
    let moved = task.tex(&moved);
    task.tell(if gives { "spring.law_falls" } else { "spring.law_grows" }, &[("moved", &moved)]);
    let stretch = &spring.stretch - spring.gamma.times(&Factors::of(&s.into())).expr();
    let law = &spring.stiffness * stretch;
    task.out.equation(&task.draft.symbols, &spring.tension.into(), &law);
    task.tell("spring.effective", &[("m", &m)]);
    let rest: Vec<Expr> =
        task.terms().into_iter().filter(|(a, _)| a.kind != ForceKind::Spring).map(|(_, e)| e).collect();
    let pull =
        Factors::of(&spring.stiffness).times(&spring.gamma).times(&Factors::of(&spring.stretch)).expr();
    task.find(m_e, &task.effective.clone());
    let rest = constant_forces(task, rest);
    task.find(first, &sum([pull].into_iter().chain(rest.clone())));
    task.find(kappa, &Factors::of(&spring.stiffness).times(&spring.gamma.squared()).expr());
    task.effective = m_e.into();
    task.drive = sum(rest.clone());
    let force = first - kappa * s;
    task.out.equation(&task.draft.symbols, &(m_e * a), &force);
    task.spring = Some(CordSpring { first: first.into(), kappa: kappa.into(), ..spring.clone() });
    let way = lead_way(task);
    let symbol = format!("${}$", task.draft.symbols.tex(first));
    task.tell("spring.direction", &[("way", &way), ("f", &symbol)]);

    task.tell("spring.integral", &[]);
    if task.sense < 0.0 {
        let s = task.tex(&task.s.clone());
        task.tell("motion.against", &[("s", &s), ("way", &way)]);
    }
    integral_of(task, v, &force, &ZERO, &task.s.clone(), "s");
    let end = task.s.clone();
    let twice = number(2) * first * &end;
    let back = kappa * square(&end);
    task.find(v, &root((twice - back) / m_e));
    task.note(task.label_of_lead(Quantity::V, Quantity::Omega), v);
    task.v = v.into();
    if spring.stretch != ZERO {
        other_origin(task, &spring, &rest, (m_e, kappa))?;
    }
    task.tell("spring.at_end", &[]);
    let tension = task.get(of_tie(Quantity::Tension, spring.tie))?;
    let _ = tension;
    let force = first - kappa * end;
    task.find(a, &(force / m_e));
    task.note(task.label_of_lead(Quantity::A, Quantity::Alpha), a);
    if task.draft.asks(Quantity::XEq) {
        task.get(of_scene(Quantity::XEq))?;
    }
    Ok(())
}

/// The sum of the constant forces as one quantity; nothing where there are none.
pub fn constant_forces(task: &mut LinearDerivation, rest: Vec<Expr>) -> Vec<Expr> {
    if rest.is_empty() {
        return rest;
    }
    task.tell("spring.constant", &[]);
    let f_c = task.new_symbol(&["F_{c}", "F_{cc}"], "N");
    task.find(f_c, &sum(rest));
    vec![f_c.into()]
}

/// `m_e int v dv = int (...) ds`
fn integral_of(task: &mut LinearDerivation, v: SymbolId, force: &Expr, from: &Expr, to: &Expr, d: &str) {
    let symbols = &task.draft.symbols;
    let (m, tex) = (task.effective.symbols(symbols), symbols.tex(v));
    let (from, to, force) = (from.symbols(symbols), to.symbols(symbols), force.symbols(symbols));
    task.out.blocks.push(Block::Formula(format!(
        r"{m} \int_{{0}}^{{{tex}}} {tex}\,d{tex} = \int_{{{from}}}^{{{to}}} \left({force}\right) d{d}"
    )));
}

/// The same integral with the place counted from where the spring is not stretched.
fn other_origin(
    task: &mut LinearDerivation,
    spring: &CordSpring,
    rest: &[Expr],
    (m_e, kappa): (SymbolId, SymbolId),
) -> Result<(), DerivationStop> {
    let Some(v) = task.m.speed(task.lead()) else {
        return task.beyond(Beyond::Arrangement);
    };
    let z = task.new_symbol(&["z", "u"], "m");
    let (z0, z1) = places(task, spring);
    task.tell("spring.other_origin", &[]);
    task.find(z0.0, &z0.1);
    task.find(z1.0, &z1.1);
    let (z0, z1) = (z0.0, z1.0);
    let force = sum(rest.to_vec()) - kappa * z;
    integral_of(task, v, &force, &z0.into(), &z1.into(), "z");
    let tex = task.draft.symbols.tex(v).to_owned();
    let again = task.draft.symbols.unknown_like(&tex, v);
    let way = task.s.clone();
    let linear: Vec<Expr> = rest.iter().map(|r| number(2) * r * &way).collect();
    let squares = kappa * (square(z0) - square(z1));
    let over = positive_first([vec![squares], linear].concat());
    task.find(again, &root(over / m_e));
    Ok(())
}

/// Places of release and of the end, counted from where the spring is not stretched.
pub fn places(task: &mut LinearDerivation, spring: &CordSpring) -> ((SymbolId, Expr), (SymbolId, Expr)) {
    let z0 = task.new_symbol(&["z_{0}", "u_{0}"], "m");
    let z1 = task.new_symbol(&["z_{1}", "u_{1}"], "m");
    let first = -Factors::of(&spring.stretch).per(&spring.gamma).expr();
    let second = z0 + &task.s;
    ((z0, first), (z1, second))
}
