//! Words a scene of lines and axles from its terms: idea, short way, long way, why the one is shorter, forces, whether what was
//! assumed is so, limits, a question to go on with. Which way is short is decided from the scene.
use crate::figure::names;
use crate::scene::{
    AsIf, Attach, Coordinate, Cord, CordEnd, Degree, End, Far, Label, Law, Made, Mass, Num, Owner, Particle,
    Quantity, RotaryInertia, Slope, Span, SpringTie, Start, Thrown, Tie,
};
use crate::solution::account::{
    Account, CordSpring, OMEGA_SWING, TIME_SLACK, half_squares, of_body, of_scene, of_tie, stored,
};
use crate::solution::draft::{Detail, Draft, is_rate, tex_of};
use crate::solution::expr::{
    Expr, SymbolId, ZERO, in_sense, magnitude, positive_first, ratio, root, square, sum,
};
use crate::solution::factors::{Cancel, Factors};
use crate::solution::page::{Page, Pieces};
use crate::solution::plane::Plane;
use crate::solution::stop::{DerivationStop, unfound};
use crate::solution::symbols::FIGURES;
use crate::solution::terms::{Action, ForceKind, ForceSource, relative, tagged};
use crate::solution::way;
use crate::solve::outcome::Word;
use crate::words::plain::capital;
use std::ops::DerefMut;

/// What drives the lead or holds it back.
const DRIVING: [ForceKind; 3] = [ForceKind::Given, ForceKind::Spring, ForceKind::Kinetic];

/// Which way comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Short {
    /// Work and energy: the question goes from a place to a speed, or from a speed to a place.
    Energy,
    /// Equations of motion: the question goes over a time.
    Motion,
    /// Neither: the contact slips, and each freedom needs an equation of its own.
    Neither,
    /// The equations of several freedoms, or of what friction holds, solved together.
    Together,
    /// Velocities and forces of an instant.
    Instant,
    /// Forces and accelerations alone are asked: no place, speed or time is needed.
    Rates,
}

/// Velocity, spin, displacement and angle of a thrown body at the end of a leg.
#[derive(Debug, Clone, Copy)]
struct LegEnd {
    v: SymbolId,
    w: SymbolId,
    x: SymbolId,
    phi: SymbolId,
}

/// What a solution says of a kind of scene. The order is one for all: [`tell`].
pub(crate) trait Tells<'d, 'a: 'd>: DerefMut<Target = Page<'d, 'a>> {
    /// What to look at, and what need not be known.
    fn idea(&mut self);
    /// The short way, the long one, and why the one is shorter.
    fn ways(&mut self) -> Result<(), DerivationStop>;
    /// Forces that are asked.
    fn forces(&mut self) -> Result<(), DerivationStop>;
    /// Is this another quantity as it is seen from the ground?
    fn is_grounded(&self, _: Quantity) -> bool {
        false
    }
    /// A quantity, looked up or derived, as it is asked.
    fn asked(&mut self, label: Label) -> Result<SymbolId, DerivationStop>;
    /// What is said before a quantity that is asked besides.
    fn before(&mut self, label: Label);
    /// Is what was assumed so?
    fn holds(&mut self) -> Result<(), DerivationStop>;
    /// A limit or two.
    fn limits(&mut self) -> Result<(), DerivationStop>;
    /// A question to go on with, by name.
    fn onward(&self) -> &'static str;

    // As those of the page; named here so that what they are given may look at the account.
    fn say(&mut self, name: &str, pieces: Pieces) {
        Page::say(self, name, pieces);
    }
    fn formula(&mut self, tex: String) {
        Page::formula(self, tex);
    }
    fn tell(&mut self, symbols: impl IntoIterator<Item = SymbolId>) {
        Page::tell(self, symbols);
    }
}

/// Writes the sections, one after the other.
fn tell<'d, 'a: 'd>(n: &mut impl Tells<'d, 'a>) -> Result<(), DerivationStop> {
    n.begin("idea");
    n.idea();
    n.sketch();
    n.ways()?;
    n.begin("forces");
    n.skip_new();
    n.forces()?;
    let measured = n.scene.formulas.found.is_some();
    n.begin_as("rest", if measured { "measured" } else { "rest" });
    n.skip_new();
    let (ground, own): (Vec<Label>, Vec<Label>) =
        n.needed().into_iter().partition(|l| n.is_grounded(l.quantity));
    for (labels, seen) in [(own, ""), (ground, "carried.ground")] {
        if !seen.is_empty() && !labels.is_empty() {
            n.say(seen, &[]);
        }
        for label in labels {
            if !label.quantity.is_word() && label.quantity != Quantity::FrictionIfRolled {
                n.before(label);
                let symbol = n.asked(label)?;
                n.answer(label, symbol);
            }
        }
        n.tell_new();
    }
    n.begin("holds");
    n.holds()?;
    n.begin("limits");
    n.limits()?;
    n.skip_new();
    n.begin("onward");
    let name = n.onward();
    n.say(name, &[]);
    n.end();
    n.draft.steps = n.steps.clone();
    Ok(())
}

/// Writes the sections of a scene.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    if draft.scene.lead().is_some() {
        return tell(&mut Plane::new(draft)?);
    }
    if draft.scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        return particles(draft);
    }
    let (ties, thrown) = (&draft.scene.ties, draft.scene.thrown().is_some());
    let slips = |t: &usize| matches!(ties[*t], Tie::Slip { .. }) && !thrown;
    let slips: Vec<usize> = (0..ties.len()).filter(slips).collect();
    let alone = draft.scene.bodies.len() == 1 && slips.len() == 1;
    let mut supposed = false;
    for tie in slips {
        supposed |= could_it_roll(draft, tie)?;
    }
    let mut account = Account::new(draft)?;
    let stays = account.stays();
    if !stays {
        account.arrive()?;
    }
    let end = account.scene.end;
    let short = match end {
        End::AtOnce => Short::Instant,
        _ if account.slip.is_some() => Short::Neither,
        _ if stays => Short::Together,
        _ if account.rates_alone() => Short::Rates,
        _ if !account.m.one => Short::Together,
        _ if supposed && alone => Short::Neither,
        _ if supposed => Short::Together,
        End::Time(..) => Short::Motion,
        _ if account.times_alone() => Short::Motion,
        _ => Short::Energy,
    };
    account.short = short;
    tell(&mut account)
}

/// What rounding leaves of a difference of equal places, SI; a particle of a problem is never so near.
const NOTHING: f64 = 1e-13;

/// Words particles that move as one body: the mass centre and the rotation about it, then the sum over the particles. About any
/// other point there is a cross term, which is shown for the particle whose velocity is known.
fn particles(draft: &mut Draft) -> Result<(), DerivationStop> {
    let scene = draft.scene;
    let given = scene.start.iter().find_map(|s| match *s {
        Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } => {
            Some((&scene.bodies[body].particles, particle, [vx_m_s, vy_m_s, spin_rad_s]))
        }
        Start::Speed(..) => None,
    });
    let (1, Some((particles, k, given))) = (scene.bodies.len(), given) else { return unfound() };
    let mut page = Page::new(draft);
    let mut column = |of: fn(&Particle) -> Num, letter: &str, unit: &str| -> Vec<Expr> {
        let number = |p: &Particle| page.number(of(p), &format!("{letter}_{{{}}}", p.name), unit);
        particles.iter().map(number).collect()
    };
    let m = column(|p| p.mass_kg, "m", "kg");
    let [x, y] = [column(|p| p.x_m, "x", "m"), column(|p| p.y_m, "y", "m")];
    let names = [("v_x", "m/s"), ("v_y", "m/s"), (r"\omega", "rad/s")];
    let [ux, uy, spin] = [0, 1, 2].map(|i| page.number(given[i], names[i].0, names[i].1));
    // Of a point: the velocity of the particle that is known, and that of the rotation about it.
    let velocity = |at: [&Expr; 2]| [&ux - &spin * (at[1] - &y[k]), &uy + &spin * (at[0] - &x[k])];
    let names: Vec<String> = particles.iter().map(|p| p.name.clone()).collect();
    let known = format!("${}$", names[k]);
    let each =
        |tex, unit, of: &dyn Fn(usize) -> Expr| -> Column { (tex, unit, (0..names.len()).map(of).collect()) };
    page.begin("idea");
    page.say("lamina.idea", &[]);
    page.sketch();
    page.begin_as("short", "short_lamina");
    page.say("lamina.centre", &[]);
    let total = |page: &mut Page, (tex, unit, cells): &Column| {
        let symbol = page.unknown(&format!(r"\sum {tex}"), unit);
        page.symbols.settle_by(symbol, &sum(cells.iter().cloned()));
        symbol
    };
    let mut columns = vec![
        ("m_i", "kg", m.clone()),
        ("x_i", "m", x.clone()),
        ("y_i", "m", y.clone()),
        each(r"m_i\,x_i", "kg m", &|i| &m[i] * &x[i]),
        each(r"m_i\,y_i", "kg m", &|i| &m[i] * &y[i]),
    ];
    let [mass, mx, my] = [0, 3, 4].map(|i| total(&mut page, &columns[i]));
    let mass = page.find(&["m", "M"], "kg", mass);
    let (xg, yg) = (page.find(&["x_G"], "m", mx / mass), page.find(&["y_G"], "m", my / mass));
    let arm = |i: usize| square(&x[i] - xg) + square(&y[i] - yg);
    columns.push(each(r"\rho_i", "m", &|i| root(arm(i))));
    columns.push(each(r"m_i\,\rho_i^{2}", "kg m^2", &|i| &m[i] * arm(i)));
    table(&mut page, &names, &columns);
    page.formula(r"\rho_i = \sqrt{\left(x_i - x_G\right)^{2} + \left(y_i - y_G\right)^{2}}".to_owned());
    let own = total(&mut page, &columns[6]);
    let own = page.find(&["I_G"], "kg m^2", own);
    for symbol in [mass, xg, yg, own] {
        page.display_step(symbol);
    }
    for (quantity, symbol) in [(Quantity::XG, xg), (Quantity::YG, yg), (Quantity::IG, own)] {
        page.answer(of_body(quantity, 0), symbol);
    }
    page.say("lamina.velocity", &[("known", &known)]);
    let [vx, vy] = velocity([&xg.into(), &yg.into()]);
    let (vx, vy) = (page.find(&["v_{Gx}"], "m/s", vx), page.find(&["v_{Gy}"], "m/s", vy));
    page.tell_new();
    page.say("lamina.split", &[]);
    let half = ratio(1, 2);
    let both = &half * mass * (square(vx) + square(vy)) + &half * own * square(&spin);
    let energy = page.find(&["T", "E"], "J", both);
    page.answer(of_scene(Quantity::KineticEnergy), energy);
    page.tell_new();
    page.begin_as("long", "long_lamina");
    page.say("lamina.velocities", &[("known", &known)]);
    let [tx, ty, turns, xk, yk] = [&ux, &uy, &spin, &x[k], &y[k]].map(|e| page.tex(e));
    page.formula(format!(r"v_{{x,i}} = {tx} - {turns}\,\left(y_i - {yk}\right)"));
    page.formula(format!(r"v_{{y,i}} = {ty} + {turns}\,\left(x_i - {xk}\right)"));
    let own = |i: usize| velocity([&x[i], &y[i]]);
    let speed = |i: usize| sum(own(i).map(square));
    let columns = [
        each("v_{x,i}", "m/s", &|i| own(i)[0].clone()),
        each("v_{y,i}", "m/s", &|i| own(i)[1].clone()),
        each("v_i", "m/s", &|i| root(speed(i))),
        each(r"\tfrac{1}{2}\,m_i\,v_i^{2}", "J", &|i| &half * &m[i] * speed(i)),
    ];
    table(&mut page, &names, &columns);
    page.formula(r"v_i = \sqrt{v_{x,i}^{2} + v_{y,i}^{2}}".to_owned());
    let all = total(&mut page, &columns[3]);
    let again = page.find(&["T", "E"], "J", all);
    page.display_step(again);
    page.begin_as("why", "which");
    let count = |n: usize| n.to_string();
    page.say("lamina.why", &[("n", &count(names.len())), ("count", &count(2 * names.len()))]);
    page.say("lamina.cross", &[("known", &known)]);
    let cross = &uy * (xg - &x[k]) - &ux * (yg - &y[k]);
    page.find(&[r"T_{\times}", r"E_{\times}"], "J", mass * &spin * cross);
    page.tell_new();
    for (id, name) in [("limits", "lamina.limits"), ("onward", "lamina.onward")] {
        page.begin(id);
        page.say(name, &[]);
    }
    page.end();
    Ok(())
}

/// A column of a table of particles: its symbol, the unit, and a cell for each.
type Column = (&'static str, &'static str, Vec<Expr>);

/// A table with a row for each particle: its name and these columns, data as they are printed.
fn table(page: &mut Page, names: &[String], columns: &[Column]) {
    let mut head = columns.iter().map(|(tex, unit, _)| format!("${tex}$ $({})$", tex_of(unit)));
    let row = |first: &str, cells: &mut dyn Iterator<Item = String>| {
        let cells: Vec<String> = std::iter::once(first.to_owned()).chain(cells).collect();
        format!("| {} |", cells.join(" | "))
    };
    let rule = format!("|{}|", vec![":--"; columns.len() + 1].join("|"));
    let mut rows = vec![row("$i$", &mut head), rule];
    for (i, name) in names.iter().enumerate() {
        let mut cells = columns.iter().map(|(.., cells)| match &cells[i] {
            Expr::Symbol(s) => {
                let shown = page.symbols.shown(*s);
                format!("${}$", shown.split(r"\ ").next().unwrap_or_default())
            }
            e => {
                let value = page.value(e);
                let value = if value.abs() < NOTHING { 0.0 } else { value };
                format!("${}$", page.digits(value, FIGURES))
            }
        });
        rows.push(row(&format!("${name}$"), &mut cells));
    }
    page.markdown(rows.join("\n"));
}

/// Quantities of the scene as if its contacts were others: the equations of motion, solved again.
pub fn as_if(
    draft: &mut Draft,
    how: AsIf,
    labels: &[Label],
) -> Result<Vec<(Label, SymbolId)>, DerivationStop> {
    let mut n = Account::new(draft)?;
    if labels.iter().all(|l| is_rate(l.quantity)) {
        n.accelerate();
    } else {
        n.arrive()?;
    }
    let (id, title, says) = match how {
        AsIf::Rolls => ("as_if", "rolled", "asked.rolls"),
        AsIf::Smooth => ("as_if", "smooth", "asked.smooth"),
        AsIf::Next => ("next", "next", "asked.next"),
    };
    n.begin_as(id, title);
    n.say(says, &[]);
    n.write_rows();
    n.tell_ratios();
    let a = n.rate();
    let links = n.links(true, |n, c| n.m.of(c).a);
    // Of one row nothing is left to eliminate.
    if n.m.one && !links.is_empty() {
        n.say_links(&links);
        let right = n.effective.by(a);
        let line = n.equation(&n.share_sum(&DRIVING), &right);
        n.say("asked.together", &[]);
        n.formula(line);
    }
    n.skip_new();
    let mut found = Vec::new();
    for label in labels {
        found.push((*label, n.get(*label)?));
    }
    let mut wanted = vec![a];
    wanted.extend(found.iter().map(|(_, symbol)| *symbol));
    wanted.extend(n.kinetic_frictions());
    // Of another motion all that is used on the way is new.
    if how == AsIf::Next {
        wanted = n.behind(wanted, |s| n.steps.iter().any(|step| step.symbol == s));
    }
    if how == AsIf::Next && n.m.one && n.spring.is_none() && labels.iter().any(|l| !is_rate(l.quantity)) {
        let rows = [n.normals(), n.kinetic_frictions(), vec![a]].concat();
        let (rows, rest) = wanted.into_iter().partition::<Vec<SymbolId>, _>(|s| rows.contains(s));
        n.tell(rows);
        wanted = rest;
        n.say_integrated();
    }
    n.tell(wanted);
    if how == AsIf::Next {
        n.short = if labels.iter().all(|l| is_rate(l.quantity)) { Short::Rates } else { Short::Together };
        // What is said of it here is no answer about the motion before.
        let answers = n.draft.found.clone();
        for (_, body) in n.rolling() {
            n.get(of_body(Quantity::Friction, body))?;
        }
        n.tell_new();
        n.holds()?;
        n.draft.found = answers;
    }
    n.end();
    Ok(found)
}

/// Is there a difference in it, which may have either sign?
fn subtracts(e: &Expr) -> bool {
    let less = |t: &&&Expr| matches!(t, Expr::Minus(_));
    let minus = e.parts().iter().filter(less).count();
    matches!(e, Expr::Sum(_)) && (1..e.parts().len()).contains(&minus) || e.parts().into_iter().any(subtracts)
}

/// What friction rolling would need on a contact that is said to slip; `false` where nobody asks.
fn could_it_roll(draft: &mut Draft, tie: usize) -> Result<bool, DerivationStop> {
    let Tie::Slip { body, mu_s, .. } = draft.scene.ties[tie] else { return Ok(false) };
    let told = draft.scene.end != End::AtOnce || draft.scene.start.is_empty() || draft.asks(Quantity::Rolls);
    let asked = [Quantity::FrictionIfRolled, Quantity::MuRequired];
    if !told && !asked.iter().any(|q| draft.asks(*q)) || draft.stays() && !draft.asks(asked[0]) {
        return Ok(false);
    }
    draft.rolled = Some(tie);
    let mut n = Account::new(draft)?;
    n.short = Short::Neither;
    n.begin("rolled");
    let friction = of_body(Quantity::Friction, body);
    let closed = if n.m.one { n.closed_friction(body) } else { None };
    let needed = match (closed, n.m.force_of(tie)) {
        (Some(closed), Some(f)) => n.found(friction, f, closed.expr()),
        _ => {
            // The force alone: such a motion need not reach the end.
            n.accelerate();
            n.get(friction)?
        }
    };
    let name = if n.m.one { "rolled.needs" } else { "rolled.needs_together" };
    n.say(name, &[]);
    n.tell_new();
    let normal = n.get(of_body(Quantity::Normal, body))?;
    let value = n.symbols.value(needed);
    n.draft.answer(of_body(Quantity::FrictionIfRolled, body), needed);
    let mu = n.number(mu_s, r"\mu_s", "1");
    let most = mu * normal;
    let slips = value.abs() > n.value(&most);
    let size = n.relation(&n.size(needed.into()), value.abs(), "N");
    let (limit, way) = (n.valued(&most, "N"), n.way(body, value));
    let name = if slips { "rolled.slips" } else { "rolled.rolls" };
    n.say(name, &[("needed", &size), ("limit", &limit), ("way", &way)]);
    n.end();
    draft.rolled = None;
    Ok(true)
}

impl<'d, 'a: 'd> Tells<'d, 'a> for Account<'d, 'a> {
    fn idea(&mut self) {
        let spring = self.spring.is_some();
        let name = match (self.short, self.scene.end) {
            (Short::Instant, _) if self.asks(Quantity::Rolls) => "idea.which",
            (Short::Instant, _) if self.starts() => "idea.start",
            (Short::Instant, _) => "idea.instant",
            (Short::Rates, _) if self.slips() => "idea.rates_slip",
            (Short::Rates, _) => "idea.rates",
            (Short::Together, _) if self.stays() => "idea.stays",
            (Short::Together, _) => "idea.together",
            (Short::Neither, End::Rolling(_)) => "thrown.idea",
            (Short::Neither, _) if self.slip.is_some() => "thrown.idea_time",
            (Short::Neither, _) => "idea.slips",
            (Short::Motion, End::Time(..)) => "idea.time",
            (Short::Motion, _) => "idea.time_asked",
            (Short::Energy, _) if self.swings_alone() => "idea.small",
            (Short::Energy, _) if self.placed() && spring => "idea.spring",
            (Short::Energy, _) if self.placed() && !self.straight() => "idea.angle",
            (Short::Energy, _) if self.placed() => "idea.place",
            (Short::Energy, _) => "idea.speed",
        };
        let mu = self.kinetic_letter();
        self.say(name, &[("mu", &mu)]);
        self.page.say_carried(self.m.carrier.as_ref());
        if matches!(self.short, Short::Energy | Short::Motion | Short::Rates) {
            let cords = self.cords();
            let rolling = self.rolling();
            let rolls = if rolling.len() > 1 { "rolls_all" } else { "rolls" };
            for (found, name) in [(rolling, rolls), (self.held().into_iter().collect(), "held")] {
                let Some((_, body)) = found.first() else { continue };
                self.say_of(&format!("idea.{name}"), *body, &[]);
                if self.short == Short::Energy {
                    let forces = found.iter().filter_map(|(t, _)| self.m.force_of(*t));
                    let forces: Vec<SymbolId> = forces.collect();
                    self.say(&format!("idea.idle_{name}"), &[("force", &forces)]);
                }
            }
            if !cords.is_empty() {
                let all = |made: &[Made]| cords.iter().all(|t| made.contains(&self.made(*t)));
                let what = match () {
                    () if all(&[Made::Cord]) => self.kind_of_cords(&cords),
                    () if all(&[Made::Cord, Made::Link]) => "links",
                    () if all(&[Made::Rests]) => "loads",
                    () => "rims",
                };
                let forces: Vec<SymbolId> = cords.iter().filter_map(|t| self.m.force_of(*t)).collect();
                self.say(&format!("idea.{what}"), &[("forces", &forces)]);
                if self.short == Short::Energy {
                    let several = what.trim_end_matches('s');
                    self.say(&format!("idea.idle_{several}s"), &[("forces", &forces)]);
                }
            }
        }
    }
    fn ways(&mut self) -> Result<(), DerivationStop> {
        let speaks = matches!(self.short, Short::Energy | Short::Motion);
        let swings = speaks && self.spring.is_some() && !self.placed();
        match self.short {
            Short::Energy if !swings => {
                self.energy();
                self.grow_up();
                self.motion("long")?;
                self.why();
                return Ok(());
            }
            Short::Instant if !self.starts() => return self.instant(),
            _ => self.motion("short")?,
        }
        if swings {
            self.tell_swing();
        }
        let name = match self.short {
            _ if swings && matches!(self.scene.end, End::Time(..)) => "why.swing_time",
            _ if swings => "why.swing",
            Short::Neither => return self.energy_of_slip(),
            Short::Together if self.stays() => return Ok(()),
            // Energy is one balance for the unknown speeds of several freedoms.
            Short::Together => "why.together",
            Short::Instant => "why.start",
            Short::Rates => "why.rates",
            _ => "why.not_energy",
        };
        self.begin_as("why", "which");
        let (v, s, unknown) = (self.speed(), self.s.clone(), self.speeds());
        self.say(name, &[("v", &v), ("s", &s), ("unknown", &unknown)]);
        if matches!(name, "why.together" | "why.not_energy") {
            self.say("why.ask", &[]);
        }
        Ok(())
    }
    fn forces(&mut self) -> Result<(), DerivationStop> {
        if !self.forced() {
            return Ok(());
        }
        let rolling = self.rolling();
        use Quantity::{A, Alpha, Friction, Normal, RimForce, Tension};
        let is = |label: &Label, which: &[Quantity]| which.contains(&label.quantity);
        let (rates, rest): (Vec<Label>, Vec<Label>) =
            self.needed().into_iter().partition(|l| is(l, &[A, Alpha]));
        let forces = rest.into_iter().filter(|l| is(l, &[Friction, Tension, RimForce, Normal]));
        for label in rates.into_iter().chain(forces) {
            self.get(label)?;
        }
        for (_, body) in &rolling {
            let _ = self.get(of_body(Friction, *body));
        }
        let sprung = !self.shares(&[ForceKind::Spring]).is_empty();
        // Where no place is given the swing has told them.
        let placed = self.placed() || matches!(self.scene.end, End::AtOnce);
        let told = self.steps.iter().all(|s| self.is_told(s.symbol));
        if sprung && (placed || !told) {
            let at_end = self.spring.iter().chain(&self.springs).map(|s| s.tension).chain([self.rate()]);
            let at_end: Vec<SymbolId> = at_end.filter(|_| placed).collect();
            self.forget(at_end);
            self.say("forces.spring", &[]);
        } else if self.steps.iter().any(|s| !self.is_told(s.symbol)) {
            let a = self.rate();
            let even = self.grown.is_empty() && self.straight();
            let place = matches!(self.scene.end, End::Travel(..)) && even;
            let back = place && self.short == Short::Energy && self.v0 == ZERO;
            let by = square(self.speed()) / (Expr::Number(2, 1) * self.distance());
            let by = self.stated(a, &in_sense(by, self.sense));
            self.say(if back { "forces.back" } else { "forces.rows" }, &[("a", &by)]);
        }
        if !rolling.is_empty() {
            let normals = self.normals();
            self.forget(normals);
        }
        self.tell_new();
        for (t, body) in rolling {
            self.read_friction(t, body)?;
        }
        Ok(())
    }
    fn is_grounded(&self, quantity: Quantity) -> bool {
        Account::is_grounded(self, quantity)
    }
    fn asked(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        Account::asked(self, label)
    }
    fn before(&mut self, label: Label) {
        let place = self.placed();
        let even = self.m.one && self.v0 == ZERO && self.spring.is_none() && self.grown.is_empty();
        if label.quantity == Quantity::T && place && even {
            self.say("forces.mean", &[]);
        }
        if label.quantity == Quantity::T
            && self.spring.is_some()
            && self.symbols.named(&[OMEGA_SWING]).is_none()
        {
            self.say("motion.letters", &[]);
        }
    }
    fn holds(&mut self) -> Result<(), DerivationStop> {
        if !self.forced() {
            return Ok(());
        }
        let lead = self.lead();
        let part = &self.m.parts[lead.body];
        let line = self.scene.bodies[lead.body].line;
        let sloped = line.is_some_and(|l| l.slope != Slope::Level);
        // The word is that of the centre, which may go back as its body turns forward.
        let way = match lead.degree == Degree::Turn && line.is_some() {
            true => self.velocity_sense(Coordinate { degree: Degree::Along, ..lead }),
            false => self.sense,
        };
        let up = way * f64::from(part.up) > 0.0;
        let word = match (sloped, up) {
            _ if self.stays() || way == 0.0 => Word::Stays,
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, true) => Word::Forward,
            (false, false) => Word::Back,
        };
        self.word(of_body(Quantity::Direction, lead.body), word);
        self.torn_loose()?;
        let (mut taut, mut cords) = (Vec::<String>::new(), Vec::new());
        for (tie, it) in self.scene.ties.iter().enumerate() {
            match it {
                Tie::Cord(Cord { made: Made::Cord, to: Far::Body(_) | Far::Fixed, .. }) => {
                    taut.extend(self.taut(tie)?);
                    cords.push(tie);
                }
                Tie::Cord(Cord { made: Made::Cord, to: Far::Spring { rigid: false, .. }, .. }) => {
                    self.spring_taut(tie)?;
                }
                _ => {}
            }
        }
        if !taut.is_empty() {
            let name = match self.kind_of_cords(&cords) {
                "cords" if taut.len() > 1 => "holds.taut_all",
                "belt" => "holds.taut_belt",
                "belts" => "holds.taut_belts",
                _ => "holds.taut",
            };
            self.say(name, &[("t", &taut.join(", "))]);
        }
        self.reaches()?;
        for tie in self.scene.ties.clone() {
            match tie {
                Tie::Roll { body, mu_s, .. } if self.m.parts[body].normal.is_some() => {
                    self.grips(body, mu_s)?;
                }
                Tie::Slip { body, mu_s, .. } if self.slip.is_some() => self.rolls_on(body, mu_s)?,
                Tie::Slip { body, .. } => self.slides_against(body)?,
                _ => {}
            }
        }
        Ok(())
    }
    fn limits(&mut self) -> Result<(), DerivationStop> {
        if self.slip.is_some() {
            let level = self.share_sum(&[ForceKind::Given]) == ZERO && !self.still_slips;
            let mu = self.kinetic_letter();
            self.say(if level { "thrown.limit_level" } else { "thrown.limit" }, &[("mu", &mu)]);
            return Ok(());
        }
        if self.short == Short::Energy && self.v0 == ZERO && self.spring.is_none() && self.grown.is_empty() {
            self.massless_limit();
            self.balance_limit();
        }
        if self.v0 == ZERO && self.short != Short::Motion {
            self.energies()?;
        }
        if self.v0 == ZERO && self.placed() && self.slips() && self.m.parts.len() == 1 {
            self.smooth_limit();
        }
        if let (Some(spring), true) = (self.spring.clone(), self.m.one && self.springs.len() == 1) {
            // At an instant the stretch at rest has no symbol.
            let still = self.get(of_tie(Quantity::XEq, spring.tie)).ok().filter(|_| !self.scene.is_still());
            if let Some(x) = still.filter(|_| self.value(&spring.stretch) > 0.0) {
                let (x, x0) = (self.names(&[x]), self.inline(&spring.stretch));
                self.say("limits.still_spring", &[("x0", &x0), ("x", &x)]);
            }
        }
        Ok(())
    }
    fn onward(&self) -> &'static str {
        let pulled =
            self.scene.ties.iter().any(|t| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_))));
        let wheel = !self.rolling().is_empty() && self.m.parts.len() == 1;
        let shares = self.shares(&[ForceKind::Given]);
        let weights = shares.iter().all(|(action, _)| matches!(action.source, ForceSource::Weight(_)));
        let pulley = self.m.parts.iter().filter(|p| p.line.a.is_none() && p.spin.a.is_some()).count() == 1;
        let weighed = self.scene.bodies.iter().all(|b| b.massless() || !matches!(b.mass, Mass::OfParts));
        match () {
            () if let Some(found) = self.scene.formulas.found => {
                // Of what was measured to be 0 nothing is one per cent too large.
                if self.values[found.measured.datum] == 0.0 { "onward.other" } else { "onward.measured" }
            }
            () if self.rests() => "onward.other",
            () if self.slip.is_some() && matches!(self.scene.end, End::Time(..)) => "thrown.onward_time",
            () if self.slip.is_some() => "thrown.onward",
            () if self.slips() && self.m.parts.len() == 1 => "onward.slips",
            () if self.spring.is_some() && !self.scene.is_still() => "onward.spring",
            () if wheel && pulled && self.level() => "onward.pulled_level",
            () if wheel && pulled && self.balancing_pull().is_some() => "onward.pulled",
            () if wheel && weights => "onward.wheel",
            () if pulley && weighed && self.cords().iter().any(|t| self.made(*t) == Made::Cord) => {
                "onward.pulley"
            }
            () if self.held().is_some() => "onward.held",
            () => "onward.other",
        }
    }
}

impl<'d, 'a> Account<'d, 'a> {
    /// Is the place given at which it ends?
    fn placed(&self) -> bool {
        matches!(self.scene.end, End::Travel(..) | End::Position(..))
    }
    /// Is nothing set in motion?
    fn rests(&self) -> bool {
        self.stays() || self.starts() && self.symbols.value(self.rate()) == 0.0
    }
    fn slips(&self) -> bool {
        self.m.parts.iter().any(|p| p.slips)
    }
    fn forced(&self) -> bool {
        self.short != Short::Instant || self.forces_asked()
    }
    fn way(&self, body: usize, value: f64) -> String {
        let name = way(self.scene, Owner::Body(body), value);
        name.map_or_else(String::new, |w| self.words.get(w).to_owned())
    }
    /// Says something of a body, which stands there alone and with its article, within a sentence and at its beginning.
    fn say_of(&mut self, name: &str, body: usize, pieces: Pieces) {
        let own = names::body_within(self.words, self.scene, body);
        let the = names::the_body(self.words, self.scene, body);
        let at_first = capital(&the);
        let all: [Pieces; 2] = [&[("body", &own), ("the", &the), ("The", &at_first)], pieces];
        self.say(name, &all.concat());
    }
    /// The speed of the lead.
    fn speed(&self) -> SymbolId {
        self.m.of(self.lead()).v.unwrap_or(SymbolId(0))
    }
    /// The acceleration of the lead.
    fn rate(&self) -> SymbolId {
        self.m.of(self.lead()).a.unwrap_or(SymbolId(0))
    }

    // What the scene has.

    fn rolling(&self) -> Vec<(usize, usize)> {
        let ties = self.scene.ties.iter().enumerate();
        ties.filter_map(|(t, tie)| match tie {
            Tie::Roll { body, .. } => Some((t, *body)),
            _ => None,
        })
        .collect()
    }
    fn cords(&self) -> Vec<usize> {
        let between = |t: &Tie| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Body(_)));
        let ties = self.scene.ties.iter().enumerate();
        ties.filter(|(_, t)| between(t)).map(|(t, _)| t).collect()
    }
    /// What these cords are called: one that leads from wheel to wheel about fixed axles is a belt.
    fn kind_of_cords(&self, cords: &[usize]) -> &'static str {
        let winds = |end: &CordEnd| {
            matches!(end.attach, Attach::Wound(..)) && self.scene.bodies[end.body].line.is_none()
        };
        let is_belt = |tie: &&usize| match &self.scene.ties[**tie] {
            Tie::Cord(Cord { from, to: Far::Body(to), .. }) => winds(from) && winds(to),
            _ => false,
        };
        match (cords.iter().filter(is_belt).count(), cords.len()) {
            (0, 1) => "cord",
            (0, _) => "cords",
            (1, 1) => "belt",
            _ => "belts",
        }
    }
    /// What leads from body to body.
    fn made(&self, tie: usize) -> Made {
        if let Tie::Cord(cord) = &self.scene.ties[tie] { cord.made } else { Made::Cord }
    }
    fn held(&self) -> Option<(usize, usize)> {
        self.scene.ties.iter().enumerate().find_map(|(t, tie)| match tie {
            Tie::Cord(c) if c.to == Far::Fixed => Some((t, c.from.body)),
            _ => None,
        })
    }
    /// Is neither way shorter, as no reaction has to be eliminated?
    fn alike(&self) -> bool {
        self.hidden().is_empty()
    }
    fn hidden(&self) -> Vec<SymbolId> {
        self.m.reactions().into_iter().map(|(_, f)| f).collect()
    }
    fn normals(&self) -> Vec<SymbolId> {
        self.m.parts.iter().filter_map(|p| p.normal.as_ref().map(|(n, _)| *n)).collect()
    }
    /// The letter of the coefficient of kinetic friction.
    fn kinetic_letter(&mut self) -> String {
        let mu = self.scene.ties.iter().find_map(|tie| match tie {
            Tie::Slip { mu_k, .. } | Tie::Slide { mu_k, .. } => Some(*mu_k),
            _ => None,
        });
        // Where it rolls, the one of slipping is no number of the scene.
        let mu = mu.map(|mu| self.number(mu, r"\mu_k", "1"));
        mu.map_or_else(|| r"\mu_k".to_owned(), |mu| self.tex(&mu))
    }
    fn kinetic_frictions(&self) -> Vec<SymbolId> {
        let tie = |a: &Action| if let ForceSource::Tie(t) = a.source { Some(t) } else { None };
        let kinetic = self.m.actions.iter().filter(|a| a.kind == ForceKind::Kinetic);
        kinetic.filter_map(|a| self.m.force_of(tie(a)?)).collect()
    }
    fn coordinates(&self) -> Vec<Coordinate> {
        self.scene
            .coordinates()
            .filter(|c| !self.m.of(*c).inertia.is_empty() || self.m.of(*c).v.is_some())
            .collect()
    }
    fn speeds(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.m.of(*c).v).collect()
    }
    fn accelerations(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.m.of(*c).a).collect()
    }
    /// `v = r omega` and its likes: every other coordinate by the lead's; speeds are magnitudes.
    fn links(&self, signed: bool, of: impl Fn(&Self, Coordinate) -> Option<SymbolId>) -> Vec<String> {
        let lead = self.lead();
        let Some(by) = of(self, lead) else { return Vec::new() };
        let others = self.coordinates().into_iter().filter(|c| *c != lead && !self.own(*c));
        others
            .filter_map(|c| {
                let symbol = of(self, c)?;
                let ratio = &self.m.of(c).ratio;
                let ratio = if signed { ratio.clone() } else { self.magnitude(ratio) };
                let right = by.by(&ratio);
                Some(self.stated(symbol, &right))
            })
            .collect()
    }

    // The sections.

    /// Work and energy: how far each point goes, the balance, what follows.
    fn energy(&mut self) {
        let title = if self.alike() { "one_energy" } else { "short_energy" };
        self.begin_as("short", title);
        // The direction is judged with the ratio of displacements.
        self.tell_ratios();
        if self.asks(Quantity::Direction) {
            self.tell_direction();
        }
        let place = self.placed();
        let lead = self.lead();
        if place && self.value(&self.s) < 0.0 {
            let sense = self.way(lead.body, -f64::from(self.m.parts[lead.body].up));
            let name = match self.straight() {
                _ if self.asks(Quantity::Direction) => "energy.counted",
                true => "energy.against",
                false => "energy.against_turn",
            };
            self.say_of(name, lead.body, &[("way", &sense)]);
        }
        // The stretch at the end comes before the balance.
        let spring = self.spring.clone();
        let v = self.lead().speed();
        let v = self.get(v).ok();
        let at = self.steps.iter().position(|s| Some(s.symbol) == v);
        if spring.is_some() {
            let kept = self.steps.split_off(at.unwrap_or(0));
            let normals = self.normals();
            self.tell_as_known(normals);
            if self.steps.iter().any(|step| !self.is_told(step.symbol)) {
                self.say("energy.stretch", &[]);
            }
            self.tell_new();
            self.steps.extend(kept);
        }
        let grown: Vec<SymbolId> =
            self.grown.iter().filter_map(|g| Some([g.last, g.mean?])).flatten().collect();
        if !grown.is_empty() {
            self.say("energy.grows", &[]);
            self.tell(grown);
        }
        let links = self.links(false, |n, c| n.m.of(c).v);
        // Of a start with a speed the gain is written with them already.
        let (before, links) = if self.v0 == ZERO { (Vec::new(), links) } else { (links, Vec::new()) };
        if !before.is_empty() {
            self.say("energy.linked", &[("links", &before.join(", "))]);
        }
        let [works, gain] = self.balance(&self.distance());
        self.page.tell_balance(self.v0 == ZERO, [&works, &gain], "");
        if let Some(spring) = spring.as_ref().filter(|s| !s.rigid && self.last == ZERO) {
            let (far, all) =
                (spring.stretch.over(&spring.gamma), stored(&spring.stiffness, &spring.stretch, &ZERO));
            self.say("energy.slack", &[("far", &self.inline(&far)), ("stored", &self.inline(&all))]);
        }
        self.tell_frictions();
        if !links.is_empty() {
            self.say("energy.links", &[("links", &links.join(", "))]);
        }
        // The speed, or the way, with the acceleration put in.
        let target = if place { v } else { self.steps.last().map(|s| s.symbol) };
        if let Some(symbol) = target {
            // `s = m_e (v^2 - v0^2)/(2 F)`
            let squares = square(&self.v) - square(&self.v0);
            let way = &self.effective * squares / (Expr::Number(2, 1) * &self.drive);
            let from = if place { self.from(symbol) } else { way };
            self.display(symbol, &from, r" \quad (\mathrm{E})");
            self.tell_groups(&from);
        }
        // Speeds that are asked.
        self.skip_new();
        if !place && (self.asks(Quantity::V) || self.asks(Quantity::Omega)) {
            self.forget(v);
        }
        for label in self.needed() {
            if matches!(label.quantity, Quantity::V | Quantity::Omega) {
                let _ = self.get(label);
            }
        }
        self.tell_new();
        let fastest = [Quantity::XEq, Quantity::VMax, Quantity::DAtVMax];
        if spring.is_some() && fastest.iter().any(|q| self.asks(*q)) {
            self.tell_fastest();
        }
    }

    /// The named ratios of displacements, from the distances to the point of contact.
    fn tell_ratios(&mut self) {
        if std::mem::replace(&mut self.ratios_told, true) {
            return;
        }
        let gammas = self.gammas.clone();
        for (tie, gamma, is) in gammas {
            let Some(action) = self.m.action_of(tie).cloned() else { continue };
            let Some(c) = self.radius_of(action.body) else {
                self.display(gamma, &is, "");
                continue;
            };
            let away = c.by(&is);
            let spring = action.kind == ForceKind::Spring;
            let name = if spring { "energy.ratio_spring" } else { "energy.ratio" };
            self.say_of(name, action.body, &[("centre", &c.expr()), ("point", &away), ("gamma", &gamma)]);
            let line = self.chain(gamma, &is);
            let travel = of_tie(Quantity::CordTravel, tie);
            let asked = self.problem.questions.iter().any(|q| q.label == travel);
            let told = self.placed() && !spring && self.s != ZERO && asked;
            let tail = if told { self.get(travel).ok() } else { None }.map(|l| self.step_of(l));
            match tail {
                Some(tail) if !tail.contains('&') => self.formula(format!(r"{line}, \qquad {tail}")),
                _ => self.formula(line),
            }
            let ahead = self.value(&self.m.point(&action).per(&action.along).expr()) > 0.0;
            let level = self.magnitude(&action.along).is_one();
            if !ahead && level && !spring {
                self.say("energy.ratio_against", &[]);
            } else if ahead && self.symbols.value(gamma) > 1.0 && !spring {
                self.say("energy.ratio_check", &[("gamma", &gamma)]);
            }
        }
        if !self.together_as.is_empty() {
            let all = self.together_as.clone();
            let names: Vec<SymbolId> = all.iter().map(|(symbol, _)| *symbol).collect();
            self.say_of("energy.springs", self.lead().body, &[("one", &names)]);
            for (symbol, is) in all {
                self.display(symbol, &is, "");
            }
        }
    }

    /// Works on the left, kinetic energies on the right.
    fn balance(&self, d: &Expr) -> [Expr; 2] {
        let sense = if self.value(&self.s) < 0.0 { -1.0 } else { 1.0 };
        let mut works = Vec::new();
        if let Some(s) = &self.spring {
            works.push(stored(&s.stiffness, &s.stretch, &self.last));
        }
        let shares = self.shares(&[ForceKind::Given, ForceKind::Kinetic]).into_iter();
        works.extend(shares.map(|(_, share)| in_sense(share.by(d), sense)));
        let gain = if self.v0 == ZERO {
            let freedoms = self.coordinates().into_iter().map(|c| self.m.of(c));
            sum(freedoms.filter_map(|of| Some(half_squares(&of.inertia, of.v?))))
        } else {
            ratio(1, 2) * &self.effective * (square(&self.v) - square(&self.v0))
        };
        [positive_first(works), gain]
    }

    /// The sums in the formula of the speed, in numbers, but for what has been cancelled in it.
    fn tell_groups(&mut self, formula: &Expr) {
        let kept = formula.uses();
        let (force, inertia) = self.of_lead(("N", "kg"), ("N m", "kg m^2"));
        let mut groups = Vec::new();
        for (_, share) in self.shares(&[ForceKind::Given]) {
            let size = match share {
                Expr::Minus(inner) => *inner,
                other => other,
            };
            let told = self.valued(&size, force);
            let plain = matches!(size, Expr::Symbol(_)) || size.uses().iter().any(|s| !kept.contains(s));
            if !plain && !groups.contains(&told) {
                groups.push(told);
            }
        }
        let cancelled = self.effective.uses().iter().any(|s| !kept.contains(s));
        if !cancelled && !matches!(self.effective, Expr::Symbol(_)) {
            groups.push(self.valued(&self.effective.clone(), inertia));
        }
        if !groups.is_empty() {
            self.say("energy.groups", &[("groups", &groups.join(", "))]);
        }
    }

    /// Sliding friction, with the normal forces that it hangs on.
    fn tell_frictions(&mut self) {
        for f in self.kinetic_frictions() {
            let from = self.from(f);
            let normals: Vec<SymbolId> =
                self.normals().into_iter().filter(|n| from.uses().contains(n)).collect();
            let normal: Vec<String> = normals.iter().map(|n| self.chained(*n)).collect();
            self.say("energy.slides", &[("normal", &normal.join(", ")), ("friction", &self.chained(f))]);
            if self.detail == Detail::Full {
                for symbol in normals.into_iter().chain([f]) {
                    self.display_step(symbol);
                }
            }
        }
    }

    fn tell_fastest(&mut self) {
        self.skip_new();
        for spring in self.springs.clone() {
            let _ = self.get(of_tie(Quantity::XEq, spring.tie));
        }
        if let (Some(spring), true) = (self.spring.clone(), self.springs.len() > 1) {
            let _ = self.middle(&spring);
        }
        self.say("energy.equilibrium", &[]);
        self.tell_new();
        if self.asks(Quantity::VMax) || self.asks(Quantity::DAtVMax) {
            let _ = self.get(of_body(Quantity::VMax, self.lead().body));
            if let Some(spring) = self.spring.clone()
                && let Ok(rest) = self.middle(&spring)
            {
                let (k, x) = (&spring.stiffness, &spring.stretch);
                let pull = in_sense(-(k * spring.gamma.by(rest)), self.sense);
                let works = stored(k, x, &rest.into()) - k * rest * (x - rest);
                let all = ratio(1, 2) * k * square(x - rest);
                let all = format!("${}$", self.equation(&works, &all));
                self.say("energy.fastest", &[("others", &pull), ("square", &all)]);
            }
            self.tell_new();
        }
    }

    fn tell_direction(&mut self) {
        let lead = self.lead();
        let sense = self.way(lead.body, self.sense * f64::from(self.m.parts[lead.body].up));
        match self.spring.clone() {
            Some(s) => {
                let drive = self.drive.clone();
                let name = if drive == ZERO { "energy.direction_alone" } else { "energy.direction_spring" };
                let all = [
                    &s.stiffness * &s.stretch,
                    s.stiffness.by(&s.gamma).by(&s.stretch),
                    self.positive(&drive),
                ];
                let [force, pull, against] = all.map(|e| self.valued(&e, "N"));
                let pieces: Pieces =
                    &[("force", &force), ("pull", &pull), ("against", &against), ("way", &sense)];
                self.say_of(name, lead.body, pieces);
            }
            None => {
                let shares = self.shares(&[ForceKind::Given]).into_iter().map(|(_, e)| e);
                let helps = |n: &Self, e: &Expr| n.value(e) * n.sense > 0.0;
                let (with, against): (Vec<Expr>, Vec<Expr>) = shares.partition(|e| helps(self, e));
                let free = against.is_empty();
                let unit = self.of_lead("N", "N m");
                let [pull, against] = [with, against].map(|all| self.valued(&self.positive(&sum(all)), unit));
                let name = if free { "energy.direction_free" } else { "energy.direction" };
                self.say_of(name, lead.body, &[("pull", &pull), ("against", &against), ("way", &sense)]);
            }
        }
    }

    /// The equations of motion, the elimination, the integral.
    fn motion(&mut self, id: &'static str) -> Result<(), DerivationStop> {
        let title = match (id, self.short) {
            (_, Short::Instant) if self.starts() => "one_motion",
            (_, Short::Instant) => "motion",
            ("long", _) if self.alike() => "other_motion",
            ("long", _) => "long_motion",
            _ => "one_motion",
        };
        self.begin_as(id, title);
        let first = self.short == Short::Instant
            || id == "short" && matches!(self.short, Short::Motion | Short::Energy)
            || self.short == Short::Rates && !self.slips();
        self.tell_ratios();
        if let Some(slip) = self.slip {
            self.slip_at_start(slip)?;
        }
        self.say_senses();
        self.write_rows();
        if first || self.short == Short::Together && self.m.one {
            self.tell_frictions();
        }
        for SpringTie { tie, .. } in self.scene.springs() {
            if (self.still() || self.springs.iter().all(|s| s.tie != tie))
                && let Ok(pull) = self.get(of_tie(Quantity::Tension, tie))
            {
                self.say("motion.spring_there", &[("pull", &self.chained(pull))]);
            }
        }
        let links = if self.m.one {
            self.links(true, |n, c| n.m.of(c).a)
        } else {
            self.demands().iter().map(|(left, right)| format!("${}$", self.equation(left, right))).collect()
        };
        if !self.springs.is_empty() && !self.still() {
            // One place on the way, not that at the end.
            let names = if self.symbols.named(&["s"]).is_some() { ["s_{x}"] } else { ["s"] };
            let s_now = self.new_symbol(&names, "m");
            let law =
                |s: &CordSpring| self.stated(s.tension, &(&s.stiffness * (&s.stretch - s.gamma.by(s_now))));
            let laws: Vec<String> = self.springs.iter().map(law).collect();
            self.say("motion.spring", &[("law", &laws.join(", ")), ("s", &s_now)]);
        }
        self.say_links(&links);
        if self.short == Short::Neither || self.short == Short::Rates && self.slips() && self.m.one {
            return match (self.scene.thrown(), self.slip) {
                (Some(thrown), Some(slip)) => self.legs(&thrown, slip),
                _ => self.two_freedoms(),
            };
        }
        let gone = if self.m.one { self.elimination() } else { None };
        let Some((gone, last)) = gone else { return self.solved_together(id) };
        let a = self.rate();
        let from = gone.iter().filter_map(|f| {
            let is = self.stated(f.symbols[0], f.is.as_ref()?);
            Some(self.phrase("motion.from", &[("n", &f.rows[0].name), ("is", &is)]))
        });
        let from: Vec<String> = from.collect();
        if !from.is_empty() {
            let n = self.number_of(last);
            self.say("motion.eliminate", &[("from", &from.join(", ")), ("n", &n)]);
        }
        let (drive, gain) = (self.share_sum(&DRIVING), self.effective.by(a));
        let line = self.equation(&drive, &gain);
        if self.spring.is_some() {
            // What is the last row itself stands there already.
            if !self.equations(last.body).contains(&(Some(last), drive, gain)) {
                self.formula(line);
            }
        } else if from.is_empty() {
            let row = self.chain(a, &drive.over(&self.effective));
            self.formulas_or_one(vec![row]);
        } else {
            self.formula(format!(r"{line}, \qquad {} = {}", self.symbols.tex(a), self.symbols.shown(a)));
        }
        self.integrate(id == "long");
        Ok(())
    }

    /// All equations at once: what comes out.
    fn solved_together(&mut self, id: &str) -> Result<(), DerivationStop> {
        if self.m.one {
            for (tie, _) in self.m.reactions() {
                let _ = self.get(self.label_of_tie(tie));
            }
        }
        self.tell_frictions();
        self.say("motion.together", &[]);
        let mut settled = [self.accelerations(), self.hidden()].concat();
        settled.retain(|s| !self.symbols.value(*s).is_nan());
        let later: Vec<SymbolId> = self.steps.iter().map(|s| s.symbol).collect();
        self.tell(settled.clone());
        if self.short == Short::Together && !self.stays() {
            let rubs = [self.normals(), self.kinetic_frictions()].concat();
            let later = later.into_iter().filter(|s| settled.contains(s)).chain(rubs);
            self.tell_as_known(later.collect());
            self.say_integrated();
            self.tell_new();
        } else {
            self.integrate(id == "long");
        }
        Ok(())
    }

    /// A motion on a spring that ends at a time, at a speed or where it turns.
    fn tell_swing(&mut self) {
        self.say("motion.swing", &[]);
        for (symbol, name) in [(OMEGA_SWING, "motion.letters"), (TIME_SLACK, "motion.letters_slack")] {
            if self.symbols.named(&[symbol]).is_some() {
                self.say(name, &[]);
            }
        }
        let normals = [self.normals(), self.kinetic_frictions()].concat();
        self.tell_as_known(normals);
        self.tell_new();
    }

    /// The velocities of an instant, its kinetic energy, and its equations of motion where forces are asked.
    fn instant(&mut self) -> Result<(), DerivationStop> {
        self.begin_as("short", "instant");
        for c in self.coordinates() {
            let _ = self.get(c.speed());
        }
        let speeds = self.speeds();
        self.say("instant.speeds", &[]);
        self.tell(speeds);
        self.get(of_scene(Quantity::KineticEnergy))?;
        self.say("instant.energy", &[]);
        self.tell_new();
        if self.forces_asked() { self.motion("long") } else { Ok(()) }
    }

    /// Is an instant looked at in which all is at rest, so that there is no energy to speak of?
    fn starts(&self) -> bool {
        let at_rest = self.scene.start.is_empty() && !self.scene.is_struck();
        at_rest && self.forces_asked() && !self.asks(Quantity::KineticEnergy)
    }

    fn say_senses(&mut self) {
        let both = self.m.parts.iter().filter(|p| p.line.a.is_some() && p.spin.a.is_some());
        let ahead: Vec<bool> =
            both.map(|p| self.value(&p.line.ratio.times(&p.spin.ratio).expr()) >= 0.0).collect();
        let wheels = !ahead.is_empty() && ahead.iter().all(|a| *a);
        self.say(if wheels { "motion.senses" } else { "motion.senses_alone" }, &[]);
        if self.m.parts.iter().any(|p| p.line.a.is_none() && p.spin.a.is_some()) {
            self.say("motion.senses_axle", &[]);
        }
        let slopes = self.scene.bodies.iter().any(|b| b.turns && b.line.is_some());
        if slopes && !self.rolling().is_empty() && self.short != Short::Neither {
            self.say("motion.other_sign", &[]);
        }
    }

    fn say_links(&mut self, links: &[String]) {
        let name = if links.len() == 1 { "motion.link" } else { "motion.links" };
        if !links.is_empty() {
            self.say(name, &[("links", &links.join(", "))]);
        }
    }

    /// All rows with numbers.
    fn write_rows(&mut self) {
        let plain = |body| self.equations(body).into_iter().map(|(_, left, right)| (left, right)).collect();
        let all = self.m.parts.iter().zip(0..).map(|(part, body)| (part.label.clone(), plain(body)));
        let all: Vec<_> = all.collect();
        self.page.rows(&all);
    }

    /// The number of the row of a coordinate.
    pub fn number_of(&self, c: Coordinate) -> String {
        let rows = (0..self.m.parts.len()).flat_map(|body| self.equations(body)).zip(1..);
        let mut own = rows.filter(|((of, ..), _)| *of == Some(c)).map(|(_, n)| n.to_string());
        own.next().unwrap_or_default()
    }

    /// `v dv = a ds` of the lead, or `omega d omega = alpha d phi`: its three pieces.
    fn over_way(&self) -> [String; 3] {
        let (v, a) = (self.symbols.tex(self.speed()), self.symbols.tex(self.rate()).to_owned());
        let ds = self.of_lead(r"\mathrm{d}s", r"\mathrm{d}\varphi").to_owned();
        [format!(r"{v}\,\mathrm{{d}}{v}"), a, ds]
    }

    /// How the accelerations lead to the speed at the end, over the time or over the way.
    fn say_integrated(&mut self) {
        let time = matches!(self.scene.end, End::Time(..));
        let [vv, aa, ds] = self.over_way();
        let name = if time { "motion.over_time" } else { "motion.over_way" };
        self.say(name, &[("vv", &vv), ("aa", &aa), ("ds", &ds)]);
    }

    /// From the acceleration to the speed, or to the distance.
    fn integrate(&mut self, again: bool) {
        let a = self.rate();
        let v = self.speed();
        let gain = ratio(1, 2) * (square(&self.v) - square(&self.v0));
        let [vv, aa, ds] = self.over_way();
        let gain = self.equation(&gain, &(a * &self.s));
        let way = self.s.clone();
        let pieces: Pieces =
            &[("a", &a), ("gain", &gain), ("d", &way), ("vv", &vv), ("aa", &aa), ("ds", &ds)];
        match self.scene.end {
            _ if self.short == Short::Rates => {}
            End::Time(..) if self.spring.is_some() => {}
            End::Speed(..) | End::TurningPoint(_) if self.short == Short::Motion => {
                self.say("motion.over_time", pieces);
                self.skip_new();
                if let Ok(t) = self.get(of_scene(Quantity::T)) {
                    self.tell([t]);
                }
            }
            End::Time(..) => {
                let grown: Vec<SymbolId> = self.grown.iter().map(|g| g.last).chain(self.first_rate).collect();
                if grown.is_empty() {
                    self.say("motion.over_time", pieces);
                } else {
                    let even = self.scene.law() == Some(Law::EVEN);
                    self.say(if even { "motion.grows" } else { "motion.grows_power" }, &[]);
                    self.tell(grown);
                    self.say(if even { "motion.over_time_grows" } else { "motion.over_time_power" }, pieces);
                }
                // What comes after the acceleration.
                let at = self.steps.iter().position(|s| s.symbol == a).map_or(0, |i| i + 1);
                let known = self.steps[..at].iter().map(|s| s.symbol).collect();
                self.tell_as_known(known);
                self.tell_new();
            }
            End::AtOnce => {}
            _ => {
                if let Some(spring) = self.spring.clone().filter(|_| again) {
                    let pull = positive_first(self.springs.iter().map(|s| s.gamma.by(s.tension)));
                    let several = matches!(pull, Expr::Sum(_));
                    let pull = self.tex(&pull);
                    let pull = if several { format!(r"\left({pull}\right)") } else { pull };
                    let (k, x) = (self.tex(&spring.stiffness), r"x\,\mathrm{d}x");
                    let stored = stored(&spring.stiffness, &spring.stretch, &self.last);
                    let share = format!(r"${pull}\,\mathrm{{d}}s = -{k}\,{x}$");
                    let share =
                        self.phrase("motion.share_of_spring", &[("share", &share), ("stored", &stored)]);
                    let all: [Pieces; 2] = [pieces, &[("spring", &share)]];
                    self.say("motion.integral_spring", &all.concat());
                } else if again && !self.grown.is_empty() {
                    self.say("motion.integral_place", pieces);
                } else if again {
                    self.say("motion.integral", pieces);
                } else if self.short == Short::Together && !self.stays() {
                    self.say_integrated();
                    self.tell([v]);
                }
            }
        }
        let opposite = self.coordinates().into_iter().any(|c| self.value(&self.m.of(c).ratio.expr()) < 0.0);
        let magnitudes = self.short == Short::Energy && self.placed() && (self.sense < 0.0 || opposite);
        if again && magnitudes {
            self.say("motion.signed", &[]);
        }
    }

    /// Friction of a slipping body, and the acceleration and the angular acceleration, each from its own equation.
    fn tell_own(&mut self, body: usize) -> Result<(SymbolId, SymbolId), DerivationStop> {
        self.tell_frictions();
        let rates = (self.get(of_body(Quantity::A, body))?, self.get(of_body(Quantity::Alpha, body))?);
        self.say("motion.own", &[]);
        let lines = [rates.0, rates.1].map(|s| self.step_of(s));
        self.formulas(lines);
        Ok(rates)
    }

    /// How the contact of a body slips that is thrown.
    fn slip_at_start(&mut self, slip: SymbolId) -> Result<(), DerivationStop> {
        let (body, up) = (self.lead().body, f64::from(self.m.parts[self.lead().body].up));
        let value = self.symbols.value(slip) * up;
        if value == 0.0 {
            return unfound();
        }
        let c = self.scene.thrown().map(|t| self.number(t.radius_m, "R", "m"));
        let c = c.map_or_else(String::new, |c| self.tex(&c));
        let (u, v) = (self.free(&["u", "w"]), tagged("v", &relative(self, "")));
        self.say("thrown.slip", &[("u", &u), ("v", &v), ("c", &c)]);
        self.tell([slip]);
        let size = self.sized(slip);
        self.ends_as(of_body(Quantity::SlipSpeed, body), size);
        let (slides, points) = (self.way(body, value), self.way(body, -value));
        self.say("thrown.sense", &[("slides", &slides), ("points", &points)]);
        Ok(())
    }

    /// A body thrown with slip: when the slip ends, where it is then or at the time asked, and the heat.
    fn legs(&mut self, thrown: &Thrown, slip: SymbolId) -> Result<(), DerivationStop> {
        let body = thrown.body;
        let (a, alpha) = self.tell_own(body)?;
        self.skip_new();
        let (c, w0) =
            (self.number(thrown.radius_m, "R", "m"), self.number(thrown.spin_rad_s, r"\omega_0", "rad/s"));
        let (v0, sense) = (self.v0.clone(), self.symbols.value(slip).signum());
        let tex = self.free(&["u", "w"]);
        let rate = self.find(&[format!(r"\dot{{{tex}}}")], "m/s^2", a - &c * alpha);
        let closes = self.symbols.value(rate) * sense < 0.0;
        self.say(if closes { "thrown.even" } else { "thrown.even_open" }, &[("u", &tex)]);
        let asked = match self.scene.end {
            End::Time(_, t) => Some(self.number(t, "t_1", "s")),
            _ => None,
        };
        let names = if asked.is_some() { [r"t_{\mathrm{r}}", "t_e"] } else { ["t", r"t_{\mathrm{r}}"] };
        let event = closes.then(|| self.find(&names, "s", -(slip / rate)));
        self.tell_new();
        // Would it roll on?
        let normal = self.get(of_body(Quantity::Normal, body))?;
        let (fall, j) = (self.share_sum(&[ForceKind::Given]), self.inertia_of(body).per(square(&c)));
        let rolling = fall.over(self.m.parts[body].mass.plus(&j));
        let grip = self.grip(body, thrown.mu_s)?;
        let holds = self.value(&j.by(&rolling)).abs() <= self.value(&grip);
        let rolls = matches!((&asked, event), (Some(t), Some(e)) if self.value(t) > self.symbols.value(e));
        let slid = match (&asked, event) {
            (Some(t), _) if !rolls => t.clone(),
            (_, Some(event)) if holds => event.into(),
            _ => return unfound(),
        };
        if let (Some(t), Some(event)) = (&asked, event) {
            let name = if rolls { "thrown.by_then" } else { "thrown.not_yet" };
            self.say(name, &[("asked", t), ("event", &event)]);
        }
        self.still_slips = asked.is_some() && !rolls;
        self.say("thrown.state", &[("t", &slid)]);
        let way = |start: &Expr, rate: SymbolId| start * &slid + ratio(1, 2) * (rate * square(&slid));
        let spins = self.still_slips.then(|| &w0 + alpha * &slid);
        let mark = if rolls { r"\mathrm{r}" } else { "1" };
        let mark = if asked.is_some() { mark } else { "" };
        let phi = way(&w0, alpha);
        let first = self.leg(mark, [&v0 + a * &slid, way(&v0, a)], spins.clone(), &c, &|_| phi.clone());
        if self.value(&v0) * self.symbols.value(first.v) < 0.0 {
            self.say("thrown.turns_back", &[]);
        }
        let left =
            spins.map_or(ZERO, |_| self.find(&[format!("{tex}_1")], "m/s", slip + rate * &slid).into());
        let mean = in_sense(slip + left, sense);
        let warm = self.asks(Quantity::Heat) || self.asks(Quantity::SlipDistance);
        if warm {
            self.say("thrown.heat", &[("u", &tex)]);
        }
        let distance = self.find(&["l", r"\ell", r"\lambda"], "m", mean.by(&slid).by(ratio(1, 2)));
        let mu_k = self.number(thrown.mu_k, r"\mu_k", "1");
        let heat = self.find(&["Q", "Q_f"], "J", mu_k * normal * distance);
        if warm {
            self.tell_new();
        }
        self.skip_new();
        let mut end = first;
        let mut rates = [a, alpha];
        let of_rolling = [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired];
        if rolls || of_rolling.iter().any(|q| self.asks(*q)) {
            let [a_r, f_r] = self.once_rolling(rolling, &j)?;
            if let (true, Some(t), Some(event)) = (rolls, &asked, event) {
                self.say("thrown.leg", &[]);
                let left = self.find(&[r"\Delta t"], "s", t - event);
                let x = first.x + first.v * left + ratio(1, 2) * (a_r * square(left));
                let phi = |x: SymbolId| first.phi + (x - first.x) / &c;
                end = self.leg("1", [first.v + a_r * left, x], None, &c, &phi);
                let tex = tagged(self.symbols.tex(alpha), r"\mathrm{r}");
                rates = [a_r, self.find(&[&tex], "rad/s^2", a_r / &c)];
                if self.asks(Quantity::Alpha) {
                    self.tell_new();
                }
                self.skip_new();
                self.ends_as(of_body(Quantity::Friction, body), f_r);
            }
        }
        if self.asks(Quantity::Distance) {
            self.there_and_back([v0.clone(), first.v.into(), end.v.into()], [a, rates[0]], [first.x, end.x]);
        }
        let sized = [end.v, end.w, end.phi].map(|s| self.sized(s));
        let of = |q| of_body(q, body);
        let ends = [(Quantity::V, sized[0]), (Quantity::Omega, sized[1]), (Quantity::Phi, sized[2])];
        let more = [(Quantity::Displacement, end.x), (Quantity::A, rates[0]), (Quantity::Alpha, rates[1])];
        for (quantity, symbol) in ends.into_iter().chain(more).chain([(Quantity::SlipDistance, distance)]) {
            self.ends_as(of(quantity), symbol);
        }
        self.ends_as(of_scene(Quantity::Heat), heat);
        if let (Some(Expr::Symbol(t)), _) | (None, Some(t)) = (&asked, event.as_ref()) {
            self.ends_as(of_scene(Quantity::T), *t);
        }
        (self.s, self.v, self.sense) = (end.x.into(), sized[0].into(), self.symbols.value(end.v).signum());
        self.word(of(Quantity::Rolls), if holds { Word::Yes } else { Word::No });
        self.by_balances([&v0, &w0, &c, &slid], slip, first, heat, rolls);
        Ok(())
    }

    /// Acceleration and friction of a thrown body once it rolls.
    fn once_rolling(&mut self, rolling: Expr, j: &Factors) -> Result<[SymbolId; 2], DerivationStop> {
        let body = self.lead().body;
        let level = rolling == ZERO;
        self.say(if level { "thrown.roll_level" } else { "thrown.roll" }, &[]);
        let f = self.get(of_body(Quantity::Friction, body))?;
        let [a_tex, f_tex] = [self.rate(), f].map(|s| tagged(self.symbols.tex(s), r"\mathrm{r}"));
        let a = self.find(&[&a_tex], "m/s^2", rolling);
        let back = -f64::from(self.m.parts[body].up);
        let f = self.find(&[&f_tex], "N", if level { ZERO } else { in_sense(j.by(a), back) });
        self.draft.answer(of_body(Quantity::FrictionIfRolled, body), f);
        self.ends_as(of_body(Quantity::ARolling, body), a);
        self.tell_new();
        Ok([a, f])
    }

    /// How far a thrown body goes in all: from one leg to the next it has these speeds and places, on each an acceleration.
    fn there_and_back(&mut self, v: [Expr; 3], a: [SymbolId; 2], x: [SymbolId; 2]) {
        let turn = (0..2).find(|i| self.value(&v[*i]) * self.value(&v[i + 1]) < 0.0);
        let way = match turn {
            Some(leg) => {
                let more = -(square(&v[leg]) / (Expr::Number(2, 1) * a[leg]));
                let turn = self.find(&["x_t"], "m", if leg == 0 { more } else { x[0] + more });
                magnitude(turn) + magnitude(x[1] - turn)
            }
            None => self.positive(&x[1].into()),
        };
        let d = self.find(&["d", "d_G"], "m", way);
        let body = self.lead().body;
        self.ends_as(of_body(Quantity::Distance, body), d);
    }

    /// Moment of inertia of a body as one term.
    fn inertia_of(&self, body: usize) -> Factors {
        self.m.parts[body].spin.inertia.iter().fold(Factors::zero(), |all, i| all.plus(i))
    }

    /// Where a thrown body is at the end of a leg; it rolls where no spin is given.
    fn leg(
        &mut self,
        mark: &str,
        [v, x]: [Expr; 2],
        spin: Option<Expr>,
        c: &Expr,
        phi: &dyn Fn(SymbolId) -> Expr,
    ) -> LegEnd {
        let below = relative(self, "");
        let found = |n: &mut Self, names: &[&str], unit: &str, is: Expr| {
            let tex = tagged(&n.free(names), mark);
            n.find(&[tex], unit, is)
        };
        let v = found(self, &[&tagged("v", &below), &tagged("v_G", &below)], "m/s", v);
        let w = found(self, &[r"\omega", r"\Omega"], "rad/s", spin.unwrap_or_else(|| v / c));
        let x = found(self, &[&tagged("x", &below), &tagged("x_G", &below)], "m", x);
        self.tell_new();
        let phi = found(self, &[r"\phi", r"\varphi", r"\psi"], "rad", phi(x));
        if self.asks(Quantity::Phi) {
            self.tell_new();
        }
        self.skip_new();
        LegEnd { v, w, x, phi }
    }

    /// Angular momentum about the contact, and the balance of energies: what they give, and what not.
    fn by_balances(
        &mut self,
        [v0, w0, c, t]: [&Expr; 4],
        slip: SymbolId,
        end: LegEnd,
        heat: SymbolId,
        rolls: bool,
    ) {
        let body = self.lead().body;
        let (fall, mass, own) =
            (self.share_sum(&[ForceKind::Given]), self.m.parts[body].mass.clone(), self.inertia_of(body));
        let level = fall == ZERO;
        self.begin_as("long", "momentum");
        self.say(if level { "thrown.momentum_level" } else { "thrown.momentum" }, &[]);
        let spun = |w: &Expr, v: &Expr| own.by(w) + mass.times(c).by(v);
        let kinetic = |w: &Expr, v: &Expr| {
            half_squares(std::slice::from_ref(&mass), v) + half_squares(std::slice::from_ref(&own), w)
        };
        let (w, v) = (Expr::from(end.w), Expr::from(end.v));
        self.formula(self.equation(&(spun(w0, v0) + fall.by(c).by(t)), &spun(&w, &v)));
        let warm = self.asks(Quantity::Heat) || self.asks(Quantity::SlipDistance);
        if warm {
            self.say("thrown.balance", &[]);
            self.formula(self.equation(&(kinetic(w0, v0) - heat + fall.by(end.x)), &kinetic(&w, &v)));
        }
        if level && (rolls || !matches!(self.scene.end, End::Time(..))) {
            // The speed at which rolling begins, and the heat, without the friction.
            let whole = mass.expr();
            let per_mass = own.per(&whole);
            let whole_mass = Factors::one().plus(&per_mass.per(square(c)));
            let speed = (v0 + per_mass.by(w0).over(c)).over(&whole_mass);
            let whole = own.plus(&mass.times(square(c))).times(Expr::Number(2, 1));
            let lost = mass.times(&own).times(square(slip)).over(&whole);
            self.say(if warm { "thrown.by_momentum" } else { "thrown.by_speed" }, &[]);
            let lines = [(end.v, speed), (heat, lost)].into_iter().take(if warm { 2 } else { 1 });
            let lines: Vec<String> = lines.map(|(symbol, from)| self.chain(symbol, &from)).collect();
            self.formulas(lines);
        }
        self.begin_as("why", "which");
        let why = match level {
            true if warm => "thrown.why_level",
            true => "thrown.why_speed",
            false => "thrown.why",
        };
        self.say(why, &[]);
        self.say("why.ask_slip", &[]);
    }

    /// Can a thrown body roll on?
    fn rolls_on(&mut self, body: usize, mu_s: Num) -> Result<(), DerivationStop> {
        let normal = self.get(of_body(Quantity::Normal, body))?;
        self.say("thrown.presses", &[("n", &self.shown(normal))]);
        let fall = self.share_sum(&[ForceKind::Given]);
        if self.still_slips {
            return Ok(());
        }
        if fall == ZERO {
            self.say("thrown.rolls_on_level", &[]);
            return Ok(());
        }
        let c = self.radius_of(body).unwrap_or_else(Factors::one);
        let j = self.inertia_of(body).per(c.squared());
        let needed = j.by(&fall).over(self.m.parts[body].mass.plus(&j));
        let needed = self.valued(&self.positive(&needed), "N");
        let limit = self.grip(body, mu_s)?;
        self.say("thrown.rolls_on", &[("needed", &needed), ("limit", &self.valued(&limit, "N"))]);
        Ok(())
    }

    /// A slipping wheel: each freedom has its own equation.
    fn two_freedoms(&mut self) -> Result<(), DerivationStop> {
        let (1, Some(body)) = (self.m.parts.len(), self.m.parts.iter().position(|p| p.slips)) else {
            return unfound();
        };
        let (a, alpha) = self.tell_own(body)?;
        if let Some(c) = self.radius_of(body) {
            self.say("motion.share", &[("share", &self.valued(&c.times(alpha).over(a), "1"))]);
        }
        self.skip_new();
        if self.short == Short::Rates {
            return Ok(());
        }
        let v = self.lead().speed();
        let v = self.get(v)?;
        if self.placed() {
            // v^2 = 2 a d, with the acceleration as it was found.
            let by = self.positive(&a.into());
            let from = root(Expr::Number(2, 1) * by * self.distance());
            self.say_integrated();
            self.formula(self.chain(v, &from));
        } else {
            self.tell([v].into_iter().chain(self.s.uses()));
        }
        for quantity in [Quantity::Omega, Quantity::Phi] {
            self.get(of_body(quantity, body))?;
        }
        let slip = self.get(of_body(Quantity::SlipDistance, body))?;
        self.say("motion.spin_of_slip", &[("slip", &slip)]);
        self.tell_new();
        Ok(())
    }

    /// Energy for a slipping wheel: one equation for two unknowns, and the theorem of the mass centre beside it.
    fn energy_of_slip(&mut self) -> Result<(), DerivationStop> {
        if self.slip.is_some() {
            return Ok(());
        }
        self.begin_as("long", "slip_energy");
        let Some(body) = self.m.parts.iter().position(|p| p.slips) else { return Ok(()) };
        let phi = self.get(of_body(Quantity::Phi, body))?;
        let (part, d) = (self.m.parts[body].clone(), self.distance());
        let (Some(v), Some(w)) = (part.line.v, part.spin.v) else { return Ok(()) };
        let place = if self.value(&self.s) < 0.0 { -1.0 } else { 1.0 };
        let alpha = self.get(of_body(Quantity::Alpha, body))?;
        let turn = self.symbols.value(alpha);
        let [forces, moments] =
            [Degree::Along, Degree::Turn].map(|degree| self.row_sum(Coordinate { body, degree }));
        let (work, gain) = (in_sense(forces, place) * d, half_squares(&part.line.inertia, v));
        let spin = half_squares(&part.spin.inertia, w);
        let centre = self.equation(&work, &gain);
        let rotation = self.equation(&(in_sense(moments, turn) * phi), &spin);
        let f = self.kinetic_frictions();
        self.say("slip.centre", &[("friction", &f)]);
        self.formula(format!(r"{centre}, \qquad {rotation}"));
        self.say("slip.neither", &[("unknown", &[v, w]), ("friction", &f)]);
        Ok(())
    }

    /// Why the first way is shorter: unknowns and equations of both, counted alike.
    fn why(&mut self) {
        let even = self.alike();
        self.begin_as("why", if even { "which" } else { "why" });
        let (reactions, normals, rubs) = (self.hidden(), self.normals(), self.kinetic_frictions());
        let (accelerations, mut speeds, own) = (self.accelerations(), self.speeds(), self.speed());
        // Where the speed at the end is given, the place is asked.
        let placed = self.placed();
        let what = if placed { own } else { self.s.uses().first().copied().unwrap_or(own) };
        speeds.iter_mut().filter(|s| **s == own).for_each(|s| *s = what);
        let newton: Vec<SymbolId> =
            [reactions.clone(), rubs.clone(), normals.clone(), accelerations, speeds.clone()].concat();
        let pressing: Vec<SymbolId> = if rubs.is_empty() { Vec::new() } else { normals.clone() };
        let energy: Vec<SymbolId> = [rubs.clone(), pressing, speeds].concat();
        if even {
            let (n, k) = (newton.len().to_string(), energy.len().to_string());
            self.say("why.neither", &[("many", &newton), ("n", &n), ("few", &energy), ("k", &k)]);
            self.say("why.ask", &[]);
        } else {
            let tied = !self.rolling().is_empty() || self.held().is_some() || !self.cords().is_empty();
            let more = [(tied, "why.ties"), (!rubs.is_empty(), "why.friction")];
            let more: Vec<&str> = more.into_iter().filter_map(|(is, name)| is.then_some(name)).collect();
            let pressing = if rubs.is_empty() { normals } else { Vec::new() };
            let [gone, silent] = [self.names(&reactions), self.names(&[reactions, pressing].concat())];
            self.page.compare(what, [&newton, &energy], &more, [&gone, &silent]);
        }
    }

    /// The closed form of a rolling body's friction, and what its signs say.
    fn read_friction(&mut self, tie: usize, body: usize) -> Result<(), DerivationStop> {
        let Ok(f) = self.get(of_body(Quantity::Friction, body)) else { return Ok(()) };
        let value = self.symbols.value(f);
        let up = self.way(body, 1.0);
        if self.m.parts[body].normal.is_none() {
            return Ok(());
        }
        if let Some(closed) = self.closed_friction(body) {
            let whole = closed.expr();
            let scale = value.abs().max(1e-9);
            if !closed.terms.is_empty() && (self.value(&whole) - value).abs() < 1e-6 * scale {
                self.say("friction.closed", &[]);
                let tex = self.tex(&whole);
                self.formula(format!("{} = {tex} = {}", self.symbols.tex(f), self.symbols.shown(f)));
                self.read_signs(body, &closed.terms);
            }
        }
        let sense = self.way(body, value);
        if value != 0.0 {
            let moments = self.row(Coordinate { body, degree: Degree::Turn });
            if moments.iter().all(|(action, _)| action.contact) {
                self.say("friction.alone", &[("f", &f)]);
            }
            self.say("friction.points", &[("f", &f), ("way", &sense)]);
        }
        if let Tie::Roll { mu_s: Some(mu), .. } = self.scene.ties[tie] {
            let grip = self.grip(body, mu)?;
            let mu = self.number(mu, r"\mu_s", "1");
            let (letter, most) = (self.tex(&mu), self.valued(&grip, "N"));
            self.say("friction.not_mu", &[("mu", &letter), ("most", &most)]);
        }
        if self.asks(Quantity::KBound) {
            self.skip_new();
            let k0 = self.get(of_body(Quantity::KBound, body))?;
            self.say("friction.bound", &[("way", &up)]);
            self.tell_new();
            if let Some(r) = self.rim(body)
                && self.symbols.value(k0) >= self.datum(r)
            {
                let r = self.number(r, "R", "m");
                self.say("friction.any_wheel", &[("r", &r), ("way", &up)]);
            }
        }
        Ok(())
    }

    /// Which forces always push friction one way, and which change with the distribution of mass.
    fn read_signs(&mut self, body: usize, terms: &[(Action, Factors)]) {
        for (action, lever) in terms {
            let whole = lever.expr();
            let force = &action.force;
            let value = self.value(&(whole.clone() * self.size(action.force.clone())));
            let vanishes = self.value(&whole) == 0.0;
            if value == 0.0 && !vanishes {
                continue;
            }
            let name = match action.source {
                _ if vanishes => "friction.none",
                _ if subtracts(&whole) && self.either_way(body, &whole) => "friction.changes",
                ForceSource::Weight(_) => "friction.weight",
                _ => "friction.force",
            };
            let sense = self.way(body, value);
            // The factor of a force that turns nothing stands there alone.
            let factor = if vanishes { self.tex(&whole) } else { self.inline(&whole) };
            self.say(name, &[("force", force), ("factor", &factor), ("way", &sense)]);
        }
    }

    /// The largest radius of a body.
    fn rim(&self, body: usize) -> Option<Num> {
        let radii = self.scene.bodies[body].radii_m.iter().map(|(_, r)| *r);
        radii.max_by(|a, b| self.datum(*a).total_cmp(&self.datum(*b)))
    }

    /// Can this term have either sign, with the mass of the body near its axis or far out?
    fn either_way(&mut self, body: usize, term: &Expr) -> bool {
        let Some(RotaryInertia::Gyration(k)) = self.scene.bodies[body].inertia else { return true };
        let (Expr::Symbol(k), Some(rim)) = (self.number(k, "k", "m"), self.rim(body)) else { return true };
        let rim = self.number(rim, "R", "m");
        self.value(&term.put(k, &ZERO)) * self.value(&term.put(k, &rim)) < 0.0
    }

    fn word(&mut self, label: Label, word: Word) {
        self.draft.answer(label, word);
    }

    /// Slides that start from rest have to be torn loose.
    fn torn_loose(&mut self) -> Result<(), DerivationStop> {
        for tie in self.scene.ties.clone() {
            let Tie::Slide { body, mu_s, mu_k } = tie else { continue };
            if self.m.actions.iter().any(|a| a.contact && a.body == body && a.kind == ForceKind::Reaction) {
                self.held_by_friction(body, mu_s.unwrap_or(mu_k))?;
            }
            let (true, Some(mu)) = (self.v0 == ZERO && self.m.one, mu_s) else { continue };
            let along = Coordinate { body, degree: Degree::Along };
            if self.m.of(along).ratio.is_zero() {
                continue;
            }
            let grip = self.grip(body, mu)?;
            let push = self.at_start(&self.share_sum(&[ForceKind::Given]));
            let push = positive_first([in_sense(push, self.sense)]);
            let hold = grip * self.magnitude(&self.m.of(along).ratio).expr();
            let (push, hold) = (self.valued(&push, "N"), self.valued(&hold, "N"));
            self.say("holds.torn", &[("push", &push), ("hold", &hold)]);
        }
        Ok(())
    }

    /// Are small oscillations all that is asked?
    fn swings_alone(&self) -> bool {
        let small = |q| matches!(q, Quantity::PeriodSmall | Quantity::OmegaSmall);
        self.needed().iter().all(|label| small(label.quantity))
    }

    /// The most that static friction holds: `mu_s N`.
    fn grip(&mut self, body: usize, mu: Num) -> Result<Expr, DerivationStop> {
        let mu = self.number(mu, r"\mu_s", "1");
        Ok(mu * self.get(of_body(Quantity::Normal, body))?)
    }

    /// What slides as soon as it moves, and stays.
    fn held_by_friction(&mut self, body: usize, mu: Num) -> Result<(), DerivationStop> {
        let grip = self.grip(body, mu)?;
        let Ok(f) = self.get(of_body(Quantity::Friction, body)) else { return Ok(()) };
        let most = self.valued(&grip, "N");
        self.say_of("holds.held", body, &[("f", &self.shown(f)), ("most", &most)]);
        Ok(())
    }

    /// `|F| <= mu_s N` as far as the scene looks.
    fn grips(&mut self, body: usize, mu_s: Option<Num>) -> Result<(), DerivationStop> {
        let n = self.get(of_body(Quantity::Normal, body))?;
        let normal = self.shown(n);
        let Ok(f) = self.get(of_body(Quantity::Friction, body)) else { return Ok(()) };
        let Some(mu) = mu_s else {
            self.say_of("holds.pressed", body, &[("n", &normal)]);
            // Where the coefficient that it takes was measured, friction is at its limit.
            let limit = |label: Label| label.quantity == Quantity::MuRequired;
            let at_limit = self.scene.formulas.found.is_some_and(|found| limit(found.label));
            self.say(if at_limit { "holds.at_the_limit" } else { "holds.no_coefficient" }, &[]);
            return Ok(());
        };
        let mu = self.number(mu, r"\mu_s", "1");
        let most = self.value(&(&mu * n));
        let mut largest = f;
        self.skip_new();
        if self.spring.is_some() {
            let ends = self.extremes(body)?;
            let [a, b] = ends.map(|[_, f]| self.symbols.value(f).abs());
            largest = if a >= b { ends[0][1] } else { ends[1][1] };
            let far = match self.scene.span {
                Span::ToEnd => "end",
                Span::ToTurningPoint => "turn",
            };
            let range = self.phrase(&format!("holds.range.{far}"), &[]);
            self.say("holds.range_is", &[("range", &range)]);
            ends.into_iter().flatten().for_each(|s| self.page.told(s));
            self.tell_new();
            let [[first, one], [last, other]] = ends;
            let ([first, last], [one, other]) =
                ([first, last].map(|s| self.chained(s)), [one, other].map(|s| self.shown(s)));
            self.say("holds.extremes", &[("first", &first), ("one", &one), ("last", &last), ("two", &other)]);
        }
        let value = self.symbols.value(largest).abs();
        let share = match self.draft.value_for(of_body(Quantity::MuRequired, body)) {
            Some(least) => self.shown(least),
            None => self.relation(&(magnitude(largest) / n), value / self.symbols.value(n), "1"),
        };
        let mu = self.valued(&mu, "1");
        self.say_of("holds.rolls", body, &[("n", &normal), ("share", &share), ("mu", &mu)]);
        if value <= most {
            self.word(of_body(Quantity::Rolls, body), Word::Yes);
        }
        Ok(())
    }

    /// The contact slides against the friction that was assumed.
    fn slides_against(&mut self, body: usize) -> Result<(), DerivationStop> {
        let a = self.get(of_body(Quantity::A, body))?;
        let alpha = self.get(of_body(Quantity::Alpha, body))?;
        let friction = self.get(of_body(Quantity::Friction, body))?;
        let Some(c) = self.radius_of(body) else { return unfound() };
        let contact = a - c.expr() * alpha;
        let up = f64::from(self.m.parts[body].up);
        let value = self.value(&contact) * up;
        let friction = self.symbols.value(friction);
        if value * friction >= 0.0 {
            return Ok(());
        }
        let (slides, force) = (self.way(body, value), self.way(body, friction));
        if !self.is_told(alpha) {
            let line = self.chained(alpha);
            self.add(format!("{line}."));
        }
        let contact = self.valued(&contact, "m/s^2");
        self.say("holds.slides", &[("a", &contact), ("slides", &slides), ("force", &force)]);
        self.word(of_body(Quantity::Rolls, body), Word::No);
        Ok(())
    }

    /// Tension of a cord, none where it is 0.
    fn taut(&mut self, tie: usize) -> Result<Option<String>, DerivationStop> {
        let told = self.steps.len();
        let Ok(t) = self.get(of_tie(Quantity::Tension, tie)) else { return Ok(None) };
        let value = self.symbols.value(t);
        if value < 0.0 {
            return Ok(None);
        }
        let new: Vec<SymbolId> = self.steps[told..].iter().map(|s| s.symbol).collect();
        let (own, others): (Vec<SymbolId>, Vec<SymbolId>) = new.into_iter().partition(|s| *s == t);
        let mut shown = if own.is_empty() { self.shown(t) } else { self.chained(t) };
        if !others.is_empty() {
            let list: Vec<String> = others.iter().map(|s| self.chained(*s)).collect();
            shown = format!("{shown} ({})", self.phrase("holds.with", &[("list", &list.join(", "))]));
        }
        Ok((value > 0.0).then_some(shown))
    }

    /// The cord of a spring up to the end: its least tension, and where it goes slack, if that is looked at.
    fn spring_taut(&mut self, tie: usize) -> Result<(), DerivationStop> {
        let own = self.springs.iter().find(|s| s.tie == tie).cloned();
        let (Some(spring), Some(end)) = (own, self.taut(tie)?) else { return Ok(()) };
        let first = &spring.stiffness * &spring.stretch;
        let least = if self.value(&first) < self.value(&spring.tension.into()) {
            self.valued(&first, "N")
        } else {
            end
        };
        let name = if self.value(&first) == 0.0 { "holds.taut_spring_from" } else { "holds.taut_spring" };
        self.say(name, &[("t", &least)]);
        if self.scene.span == Span::ToTurningPoint
            && let Ok((slack, true)) = self.turning_or_slack()
        {
            self.say("holds.goes_slack", &[("s", &self.valued(&self.positive(&slack), "m"))]);
        }
        Ok(())
    }

    /// The end lies before the turning point.
    fn reaches(&mut self) -> Result<(), DerivationStop> {
        let lead = self.lead();
        if !self.placed() || !self.straight() || self.stays() {
            return Ok(());
        }
        let turns = self.spring.is_some() || self.value(&self.drive) * self.sense < 0.0;
        let level = self.spring.as_ref().is_some_and(|s| !s.rigid) && self.value(&self.drive) == 0.0;
        if !turns || level || !self.grown.is_empty() || self.short == Short::Rates {
            return Ok(());
        }
        self.skip_new();
        let Ok(turn) = self.get(of_body(Quantity::DTurn, lead.body)) else { return Ok(()) };
        let (d, far) = (self.value(&self.distance()), self.symbols.value(turn));
        if d > far {
            return Ok(());
        }
        let known = self.is_told(turn);
        let far = if known { self.shown(turn) } else { self.names(&[turn]) };
        self.say("holds.reaches", &[("d", &self.distance()), ("turn", &far)]);
        if !known {
            self.tell([turn]);
        }
        Ok(())
    }

    /// Without friction: the closed form of the speed of a wheel that only slips, if it goes the same way.
    fn smooth_limit(&mut self) {
        let drive = positive_first([in_sense(self.share_sum(&[ForceKind::Given]), self.sense)]);
        let smooth = (Expr::Number(2, 1) * self.distance() * drive).over(&self.effective);
        if self.value(&smooth) > 0.0 && self.grown.is_empty() && self.spring.is_none() {
            self.say_fast("limits.smooth", &smooth);
        }
    }

    /// Without rotary inertia: the closed form of the speed that is left.
    fn massless_limit(&mut self) {
        let lines = self.coordinates().into_iter().filter(|c| c.degree == Degree::Along);
        let masses = lines.flat_map(|c| self.reckoned(c)).map(|i| i.expr());
        let masses: Vec<Expr> = masses.filter(|e| *e != ZERO).collect();
        if !self.spins() || masses.is_empty() || !self.straight() || matches!(self.scene.end, End::Speed(..))
        {
            return;
        }
        let drive = positive_first([in_sense(self.drive.clone(), self.sense)]);
        let light = Expr::Number(2, 1) * self.distance() * drive;
        let light = light.over(positive_first(masses));
        self.say_fast("limits.massless", &light);
    }

    /// Compares the speed with another one, of which this is the square.
    fn say_fast(&mut self, name: &str, square: &Expr) {
        let fast = self.relation(&root(square), self.value(square).sqrt(), "m/s");
        self.say(name, &[("v", &self.shown(self.speed())), ("fast", &fast)]);
    }

    /// Where the driving force just balances: nothing happens.
    fn balance_limit(&mut self) {
        let Some((action, needed)) = self.balancing_pull() else { return };
        let force = self.tex(&action.force);
        let digits = self.digits(self.value(&needed), FIGURES);
        let text = format!(r"${} = {} = {digits}\ {}$", tagged(&force, "0"), self.tex(&needed), tex_of("N"));
        self.say("limits.balance", &[("force", &action.force), ("is", &text)]);
    }

    /// Is every line on which something moves level?
    fn level(&self) -> bool {
        self.scene.bodies.iter().filter_map(|b| b.line).all(|l| l.slope == Slope::Level)
    }

    /// The pull that drives it, and how large it would be in equilibrium.
    fn balancing_pull(&self) -> Option<(Action, Expr)> {
        let pull = self.shares(&[ForceKind::Given]).into_iter().find(|(a, share)| {
            matches!(a.source, ForceSource::Tie(_)) && self.value(share) * self.sense > 0.0
        });
        let (action, share) = pull?;
        let others = self.shares(&[ForceKind::Given]).into_iter();
        let others: Vec<Expr> = others.filter(|(a, _)| a.source != action.source).map(|(_, e)| -e).collect();
        let per = Factors::of(&share).per(&action.force);
        let needed = positive_first(others.clone()).over(&per);
        (!others.is_empty() && self.value(&needed) > 0.0).then_some((action, needed))
    }

    /// Has anything that turns a moment of inertia?
    fn spins(&self) -> bool {
        self.coordinates().into_iter().any(|c| c.degree == Degree::Turn && !self.m.of(c).inertia.is_empty())
    }

    /// Shares of the kinetic energy.
    fn energies(&mut self) -> Result<(), DerivationStop> {
        let moving = self.coordinates().into_iter().any(|c| c.degree == Degree::Along);
        if self.m.carrier.is_some()
            || !self.spins()
            || !moving
            || self.value(&self.v) == 0.0
            || self.short == Short::Rates
        {
            return Ok(());
        }
        self.skip_new();
        let share = self.get(of_scene(Quantity::RotationalFraction))?;
        let share = self.symbols.value(share);
        self.skip_new();
        let several = self.m.parts.len() > 1;
        self.page.say_share(share, several);
        Ok(())
    }
}
