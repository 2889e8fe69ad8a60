//! Words a scene of lines and axles from its terms: idea, short way, long way, why the one is shorter, forces, whether what was
//! assumed is so, limits, a question to go on with. Which way is short is decided from the scene.
use crate::figure::names;
use crate::num::shown;
use crate::scene::{Coordinate, Degree, End, Far, Label, Mass, Owner, Quantity, Span, Tie};
use crate::solution::account::{Account, Eliminated, marked, of_body, of_scene, of_tie};
use crate::solution::draft::{DerivedAnswer, Detail, Draft, tex_of};
use crate::solution::expr::{
    Expr, SymbolId, ZERO, in_sense, magnitude, positive_first, ratio, root, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::page::{PACKED, Page, WITHIN, aligned, packed};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solution::terms::{Action, ForceKind, ForceSource};
use crate::solution::text::{Block, LINE, SolutionSection};
use crate::solution::written::width;
use crate::solution::{instant, way};
use crate::solve::outcome::Word;
use std::ops::{Deref, DerefMut};

/// Which way comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Short {
    /// Work and energy: the question goes from a place to a speed, or from a speed to a place.
    Energy,
    /// Equations of motion: the question goes over a time.
    Motion,
    /// Neither: the contact slips, and each freedom needs an equation of its own.
    Neither,
}

/// Writes the sections of a scene of lines and axles.
///
/// # Errors
/// What is not covered, by name.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    if draft.scene.end == End::AtOnce {
        return instant::write(draft);
    }
    if draft.variant.solved.regime.stays() {
        return Err(Beyond::NothingMoves.into());
    }
    let ties = &draft.scene.ties;
    let slips: Vec<usize> = (0..ties.len()).filter(|t| matches!(ties[*t], Tie::Slip { .. })).collect();
    if slips.len() > 1 {
        return Err(Beyond::SeveralSlips.into());
    }
    let mut senses = Vec::new();
    let mut rolled = None;
    if let [tie] = slips.as_slice() {
        let (sense, section) = could_it_roll(draft, *tie)?;
        senses.push((*tie, sense));
        rolled = Some(section);
    }
    let mut account = Account::new(draft, false, &senses)?;
    account.arrive()?;
    let end = account.page.draft.scene.end;
    let short = match end {
        _ if rolled.is_some() => Short::Neither,
        End::Time(..) => Short::Motion,
        _ => Short::Energy,
    };
    let mut n = Narrator::new(account, short);
    n.idea();
    n.sketch();
    if let Some(section) = rolled {
        n.end();
        n.t.page.draft.sections.push(section);
    }
    match short {
        Short::Energy => {
            n.energy();
            n.motion("long")?;
            n.why();
        }
        Short::Motion => {
            n.motion("short")?;
            n.why_not_energy();
        }
        Short::Neither => {
            n.motion("short")?;
            n.energy_of_slip()?;
        }
    }
    n.forces()?;
    n.rest()?;
    n.holds()?;
    n.limits()?;
    n.onward();
    Ok(())
}

/// What friction rolling would need, and its sense, positive up.
fn could_it_roll(draft: &mut Draft, tie: usize) -> Result<(f64, SolutionSection), DerivationStop> {
    let Tie::Slip { body, mu_s, .. } = draft.scene.ties[tie] else {
        return Err(Beyond::Arrangement.into());
    };
    let mut n = Narrator::new(Account::new(draft, true, &[])?, Short::Neither);
    n.begin("rolled");
    let friction = of_body(Quantity::Friction, body);
    let closed = n.t.closed_friction(body);
    let needed = match closed {
        Some(closed) => {
            let Some(f) = n.t.m.force_of(tie) else { return Err(Beyond::Arrangement.into()) };
            n.t.found(friction, f, closed.expr())
        }
        None => {
            n.t.arrive()?;
            n.t.get(friction)?
        }
    };
    n.say("rolled.needs", &[]);
    n.tell_new();
    let normal = n.t.get(of_body(Quantity::Normal, body))?;
    let value = n.t.page.draft.symbols.value(needed);
    n.t.page.draft.answer(of_body(Quantity::FrictionIfRolled, body), DerivedAnswer::Value(needed));
    let mu = n.t.page.draft.number(mu_s, r"\mu_s", "1");
    let most = mu * normal;
    let slips = value.abs() > n.t.value(&most);
    let size = n.relation(&n.t.size(needed.into()), value.abs(), "N");
    let limit = n.valued(&most, "N");
    let sense = n.way(body, value);
    n.say(
        if slips { "rolled.slips" } else { "rolled.rolls" },
        &[("needed", &size), ("limit", &limit), ("way", &sense)],
    );
    n.stop();
    let section = std::mem::replace(&mut n.out, SolutionSection::new("", ""));
    if !slips {
        return Err(Beyond::RollsAfterAll.into());
    }
    Ok((value.signum(), section))
}

/// Who words the sections, one after the other.
struct Narrator<'d, 'a> {
    t: Account<'d, 'a>,
    short: Short,
    /// The rows as they are numbered.
    rows: Vec<(Coordinate, usize)>,
    gone: Vec<Eliminated>,
}

impl<'d, 'a> Deref for Narrator<'d, 'a> {
    type Target = Page<'d, 'a>;
    fn deref(&self) -> &Self::Target {
        &self.t.page
    }
}

impl DerefMut for Narrator<'_, '_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.t.page
    }
}

impl<'d, 'a> Narrator<'d, 'a> {
    fn new(t: Account<'d, 'a>, short: Short) -> Self {
        Self { t, short, rows: Vec::new(), gone: Vec::new() }
    }

    fn way(&self, body: usize, value: f64) -> String {
        let name = way(self.t.page.draft.scene, Owner::Body(body), value);
        name.map_or_else(String::new, |w| self.t.page.draft.words.get(w).to_owned())
    }
    fn body(&self, body: usize) -> String {
        names::body_within(self.t.page.draft.words, self.t.page.draft.scene, body)
    }
    /// The speed of the lead.
    fn speed(&self) -> SymbolId {
        self.t.m.speed(self.t.lead()).unwrap_or(SymbolId(0))
    }
    /// The acceleration of the lead.
    fn acceleration(&self) -> SymbolId {
        self.t.m.acceleration(self.t.lead()).unwrap_or(SymbolId(0))
    }

    // What the scene has.

    fn rolling(&self) -> Vec<(usize, usize)> {
        let ties = self.t.page.draft.scene.ties.iter().enumerate();
        ties.filter_map(|(t, tie)| match tie {
            Tie::Roll { body, .. } => Some((t, *body)),
            _ => None,
        })
        .collect()
    }
    fn cords(&self) -> Vec<usize> {
        let between = |t: &Tie| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Body(_)));
        let ties = self.t.page.draft.scene.ties.iter().enumerate();
        ties.filter(|(_, t)| between(t)).map(|(t, _)| t).collect()
    }
    fn held(&self) -> Option<(usize, usize)> {
        self.t.page.draft.scene.ties.iter().enumerate().find_map(|(t, tie)| match tie {
            Tie::Cord(c) if c.to == Far::Fixed => Some((t, c.from.body)),
            _ => None,
        })
    }
    fn reactions(&self) -> Vec<SymbolId> {
        let mut all = Vec::new();
        for a in self.t.m.actions.iter().filter(|a| a.kind == ForceKind::Reaction) {
            if let ForceSource::Tie(t) = a.source
                && let Some(f) = self.t.m.force_of(t)
                && !all.contains(&f)
            {
                all.push(f);
            }
        }
        all
    }
    fn normals(&self) -> Vec<SymbolId> {
        self.t.m.parts.iter().filter_map(|p| p.normal.as_ref().map(|(n, _)| *n)).collect()
    }
    fn kinetic_frictions(&self) -> Vec<SymbolId> {
        let kinetic = self.t.m.actions.iter().filter(|a| a.kind == ForceKind::Kinetic);
        kinetic
            .filter_map(|a| match a.source {
                ForceSource::Tie(t) => self.t.m.force_of(t),
                _ => None,
            })
            .collect()
    }
    fn coordinates(&self) -> Vec<Coordinate> {
        self.t
            .page
            .draft
            .scene
            .coordinates()
            .filter(|c| !self.t.m.inertia(*c).is_empty() || self.t.m.speed(*c).is_some())
            .collect()
    }
    fn speeds(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.t.m.speed(*c)).collect()
    }
    fn accelerations(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.t.m.acceleration(*c)).collect()
    }
    /// `v = r omega` and its likes: every other coordinate by the lead's.
    fn links(&self, of: impl Fn(&Self, Coordinate) -> Option<SymbolId>) -> Vec<String> {
        let lead = self.t.lead();
        let Some(by) = of(self, lead) else { return Vec::new() };
        let others = self.coordinates().into_iter().filter(|c| *c != lead && !self.t.own(*c));
        others
            .filter_map(|c| {
                let symbol = of(self, c)?;
                let ratio = self.t.magnitude(self.t.m.ratio(c));
                let right = Factors::of(&by.into()).times(&ratio).expr();
                Some(format!("${} = {}$", self.t.page.draft.symbols.tex(symbol), self.tex(&right)))
            })
            .collect()
    }

    // The sections.

    fn idea(&mut self) {
        self.begin("idea");
        let spring = self.t.spring.is_some();
        let name = match (self.short, self.t.page.draft.scene.end) {
            (Short::Neither, _) => "idea.slips",
            (Short::Motion, _) => "idea.time",
            (Short::Energy, End::Travel(..) | End::Position(..)) if spring => "idea.spring",
            (Short::Energy, End::Travel(..) | End::Position(..)) => "idea.place",
            (Short::Energy, _) => "idea.speed",
        };
        self.say(name, &[]);
        if self.short != Short::Neither {
            if let Some((t, body)) = self.rolling().first().copied() {
                let body = self.body(body);
                self.say("idea.rolls", &[("body", &body)]);
                let f = self.t.m.force_of(t).map_or_else(String::new, |f| self.names(&[f]));
                if self.short == Short::Energy {
                    self.say("idea.idle_roll", &[("force", &f)]);
                }
            }
            if let Some((t, body)) = self.held() {
                let body = self.body(body);
                let f = self.t.m.force_of(t).map_or_else(String::new, |f| self.names(&[f]));
                self.say("idea.held", &[("body", &body)]);
                if self.short == Short::Energy {
                    self.say("idea.idle_held", &[("force", &f)]);
                }
            }
            let cords = self.cords();
            if !cords.is_empty() {
                let forces: Vec<SymbolId> = cords.iter().filter_map(|t| self.t.m.force_of(*t)).collect();
                let forces = self.names(&forces);
                self.say("idea.cords", &[]);
                if self.short == Short::Energy {
                    self.say("idea.idle_cords", &[("forces", &forces)]);
                }
            }
        }
    }

    fn sketch(&mut self) {
        self.begin("sketch");
        let mut all = vec![Block::Picture("scene".to_owned())];
        let bodies = &self.t.page.draft.scene.bodies;
        all.extend(bodies.iter().map(|b| Block::Picture(format!("forces-{}", b.name))));
        self.out.blocks = all;
    }

    /// Work and energy: how far each point goes, the balance, what follows.
    fn energy(&mut self) {
        self.begin_as("short", "short_energy");
        if self.t.page.draft.asks(Quantity::Direction) {
            self.tell_direction();
        }
        self.tell_ratios();
        let place = matches!(self.t.page.draft.scene.end, End::Travel(..) | End::Position(..));
        let (lead, d) = (self.t.lead(), self.t.distance());
        let against = self.t.value(&self.t.s) < 0.0;
        if place && against {
            let body = self.body(lead.body);
            let sense = self.way(lead.body, -f64::from(self.t.m.parts[lead.body].up));
            self.say("energy.against", &[("body", &body), ("way", &sense)]);
        }
        // The stretch at the end comes before the balance.
        let spring = self.t.spring.clone();
        let v = self.t.get(self.t.of_lead(Quantity::V, Quantity::Omega)).ok();
        let at = self.t.page.steps.iter().position(|s| Some(s.symbol) == v);
        if spring.is_some() {
            let kept = self.t.page.steps.split_off(at.unwrap_or(0));
            self.say("energy.stretch", &[]);
            let normals = self.normals();
            self.tell_as_known(normals);
            self.tell_new();
            self.t.page.steps.extend(kept);
        }
        let start = if self.t.v0 == ZERO { "energy.from_rest" } else { "energy.moving" };
        self.say(start, &[]);
        let balance = self.balance(&d);
        let links = self.links(|n, c| n.t.m.speed(c));
        self.formula(balance);
        if !links.is_empty() {
            self.say("energy.links", &[("links", &links.join(", "))]);
        }
        if !self.kinetic_frictions().is_empty() {
            self.tell_frictions();
        }
        let target = if place { v } else { self.t.page.steps.last().map(|s| s.symbol) };
        let step = self.t.page.steps.iter().find(|s| Some(s.symbol) == target).cloned();
        if let Some(step) = step {
            if !place {
                // The way, with the acceleration put in.
                let symbol = step.symbol;
                let from = self.way_by_energy();
                let line = self.chain(symbol, &from).concat();
                self.tagged_formula(line);
            } else {
                let line = self.chain(step.symbol, &step.from).concat();
                self.tagged_formula(line);
            }
        }
        self.tell_groups();
        // Speeds that are asked.
        self.skip_new();
        if !place {
            self.forget(&[v]);
        }
        let asked: Vec<Label> = self.t.page.draft.problem.questions.iter().map(|q| q.label).collect();
        for label in asked {
            if matches!(label.quantity, Quantity::V | Quantity::Omega) {
                let _ = self.t.get(label);
            }
        }
        self.tell_new();
        for quantity in [Quantity::XEq, Quantity::VMax, Quantity::DAtVMax] {
            if self.t.page.draft.asks(quantity) && self.t.spring.is_some() {
                self.tell_fastest();
                break;
            }
        }
    }

    fn tagged_formula(&mut self, line: String) {
        let line = if line.contains('&') { aligned(&line) } else { format!(r"{line} \quad (\mathrm{{E}})") };
        self.formula(line);
    }

    /// `s = m_e (v^2 - v0^2)/(2 F)`
    fn way_by_energy(&self) -> Expr {
        let squares = square(&self.t.v) - square(&self.t.v0);
        let squares = if self.t.v == ZERO { -square(&self.t.v0) } else { squares };
        &self.t.effective * squares / (Expr::Number(2, 1) * &self.t.drive)
    }

    /// The named ratios of displacements, from the distances to the point of contact.
    fn tell_ratios(&mut self) {
        let gammas = self.t.gammas.clone();
        for (tie, gamma, is) in gammas {
            let Some(action) = self.t.m.action_of(tie).cloned() else { continue };
            let contact = self.t.contact_of(action.body).and_then(|t| self.t.m.action_of(t)).cloned();
            let Some(contact) = contact else { continue };
            let c = self.t.magnitude(&contact.arm);
            let away = c.times(&Factors::of(&is)).expr();
            let (c, away) = (self.inline(&c.expr()), self.inline(&away));
            let spring = action.kind == ForceKind::Spring;
            let name = if spring { "energy.ratio_spring" } else { "energy.ratio" };
            self.say(name, &[("centre", &c), ("point", &away)]);
            let line = self.chain(gamma, &is).concat();
            let travel = of_tie(Quantity::CordTravel, tie);
            let tail = if !spring && self.t.s != ZERO && self.t.page.draft.asks_label(travel) {
                self.t.get(travel).ok().map(|l| {
                    let from = self.t.page.steps.last().map_or(ZERO, |s| s.from.clone());
                    self.chain(l, &from).concat()
                })
            } else {
                None
            };
            let line = if line.contains('&') { aligned(&line) } else { line };
            match tail {
                Some(tail) if !tail.contains('&') => self.formula(format!(r"{line}, \qquad {tail}")),
                _ => self.formula(line),
            }
            if self.t.page.draft.symbols.value(gamma) > 1.0 && !spring {
                let gamma = self.names(&[gamma]);
                self.say("energy.ratio_check", &[("gamma", &gamma)]);
            }
        }
    }

    /// Works on the left, kinetic energies on the right.
    fn balance(&self, d: &Expr) -> String {
        let half = Factors::of(&ratio(1, 2));
        let sense = if self.t.value(&self.t.s) < 0.0 { -1.0 } else { 1.0 };
        let mut works = Vec::new();
        if let Some(s) = &self.t.spring {
            let last = self.t.stretch_at(&self.t.s);
            let x1 = self.t.page.steps.iter().find(|step| step.from == last).map(|s| Expr::from(s.symbol));
            let squares = match x1 {
                Some(x1) => square(&s.stretch) - square(x1),
                None => square(&s.stretch),
            };
            works.push(ratio(1, 2) * &s.stiffness * squares);
        }
        for (_, share) in self.t.shares(&[ForceKind::Given, ForceKind::Kinetic]) {
            works.push(in_sense(Factors::of(&share).times(&Factors::of(d)).expr(), sense));
        }
        let left = positive_first(works);
        let right = if self.t.v0 == ZERO {
            let mut all = Vec::new();
            for c in self.coordinates() {
                let Some(v) = self.t.m.speed(c) else { continue };
                for i in self.t.m.inertia(c) {
                    all.push(i.times(&Factors::of(&square(v))).times(&half).expr());
                }
            }
            sum(all)
        } else {
            let gain = square(self.t.v.clone()) - square(&self.t.v0);
            let gain = if self.t.v == ZERO { -square(&self.t.v0) } else { gain };
            ratio(1, 2) * &self.t.effective * gain
        };
        let one = format!("{} = {}", self.tex(&left), self.tex(&right));
        if width(&one) <= LINE {
            one
        } else {
            aligned(&format!(r"{} &= {}", self.tex(&left), self.tex(&right)).replacen(" &= ", r" \\ &= ", 1))
        }
    }

    /// The sums in the formula of the speed, in numbers.
    fn tell_groups(&mut self) {
        let (force, inertia) = if self.t.straight() { ("N", "kg") } else { ("N m", "kg m^2") };
        let mut groups = Vec::new();
        for (_, share) in self.t.shares(&[ForceKind::Given]) {
            let size = match share {
                Expr::Minus(inner) => *inner,
                other => other,
            };
            if !matches!(size, Expr::Symbol(_)) {
                groups.push(self.valued(&size, force));
            }
        }
        if !matches!(self.t.effective, Expr::Symbol(_)) {
            groups.push(self.valued(&self.t.effective.clone(), inertia));
        }
        if !groups.is_empty() {
            self.say("energy.groups", &[("groups", &groups.join(", "))]);
        }
    }

    fn tell_frictions(&mut self) {
        let all = self.kinetic_frictions();
        for f in all {
            let normal = self
                .normals()
                .first()
                .and_then(|n| self.t.page.steps.iter().find(|s| s.symbol == *n))
                .cloned();
            let normal =
                normal.map_or_else(String::new, |n| format!("${}$", self.chain(n.symbol, &n.from).concat()));
            if self.draft.detail == Detail::Full {
                for symbol in self.normals().into_iter().take(1).chain([f]) {
                    let from = self.t.page.steps.iter().find(|s| s.symbol == symbol).map(|s| s.from.clone());
                    self.display(symbol, &from.unwrap_or(ZERO), "");
                }
            } else {
                let chain = self.chained(f);
                self.say("energy.slides", &[("normal", &normal), ("friction", &chain)]);
            }
        }
    }

    fn tell_fastest(&mut self) {
        self.skip_new();
        let _ = self.t.get(of_scene(Quantity::XEq));
        self.say("energy.equilibrium", &[]);
        self.tell_new();
        if self.t.page.draft.asks(Quantity::VMax) || self.t.page.draft.asks(Quantity::DAtVMax) {
            let _ = self.t.get(of_body(Quantity::VMax, self.t.lead().body));
            self.say("energy.fastest", &[]);
            self.tell_new();
        }
    }

    fn tell_direction(&mut self) {
        let lead = self.t.lead();
        let part = &self.t.m.parts[lead.body];
        let up = self.t.sense * f64::from(part.up) > 0.0;
        let sense = self.way(lead.body, if up { 1.0 } else { -1.0 });
        match self.t.spring.clone() {
            Some(s) => {
                let pull = Factors::of(&s.stiffness).times(&s.gamma).times(&Factors::of(&s.stretch)).expr();
                let pull = self.valued(&pull, "N");
                let drive = self.t.drive.clone();
                let against = self.valued(&in_sense(drive.clone(), self.t.value(&drive)), "N");
                let name = if drive == ZERO { "energy.direction_alone" } else { "energy.direction_spring" };
                self.say(name, &[("pull", &pull), ("against", &against), ("way", &sense)]);
            }
            None => self.say("energy.direction", &[("way", &sense)]),
        }
    }

    /// The equations of motion, the elimination, the integral.
    fn motion(&mut self, id: &'static str) -> Result<(), DerivationStop> {
        let title = match (id, self.short) {
            ("long", _) => "long_motion",
            (_, Short::Neither) => "one_motion",
            _ => "short_motion",
        };
        self.begin_as(id, title);
        self.say_senses();
        self.write_rows();
        let slips = self.short == Short::Neither;
        let links = self.links(|n, c| n.t.m.acceleration(c));
        if let Some(s) = self.t.spring.clone() {
            let s_now = self.t.new_symbol(&["s", "s_1"], "m");
            let stretch = &s.stretch - s.gamma.times(&Factors::of(&s_now.into())).expr();
            let law = &s.stiffness * stretch;
            let law = format!("${} = {}$", self.t.page.draft.symbols.tex(s.tension), self.tex(&law));
            self.say("motion.spring", &[("law", &law)]);
        }
        if !links.is_empty() {
            self.say("motion.links", &[("links", &links.join(", "))]);
        }
        if slips {
            return self.two_freedoms();
        }
        let (gone, last) = self.t.elimination()?;
        let a = self.acceleration();
        let from: Vec<String> = gone
            .iter()
            .map(|g| {
                let n = self.number_of(g.row);
                let is = format!("${} = {}$", self.t.page.draft.symbols.tex(g.force), self.tex(&g.is));
                self.phrase("motion.from", &[("n", &n), ("is", &is)])
            })
            .collect();
        let n = self.number_of(last);
        self.gone = gone;
        if !from.is_empty() {
            self.say("motion.eliminate", &[("from", &from.join(", ")), ("n", &n)]);
        }
        let sum_of = self.all_shares();
        let right = Factors::of(&self.t.effective).times(&Factors::of(&a.into())).expr();
        let line = format!("{} = {}", self.tex(&sum_of), self.tex(&right));
        let value = self.t.page.draft.symbols.shown(a);
        let tex = self.t.page.draft.symbols.tex(a).to_owned();
        if self.t.spring.is_none() {
            let whole = format!(r"{line}, \qquad {tex} = {value}");
            if !from.is_empty() || width(&whole) > WITHIN {
                self.formula(whole);
            } else {
                self.add(format!("${line}$, ${tex} = {value}$."));
            }
        } else {
            self.formula(line);
        }
        self.integrate(id == "long");
        Ok(())
    }

    fn all_shares(&self) -> Expr {
        let kinds = [ForceKind::Given, ForceKind::Spring, ForceKind::Kinetic];
        positive_first(self.t.shares(&kinds).into_iter().map(|(_, e)| e).collect())
    }

    fn say_senses(&mut self) {
        self.say("motion.senses", &[]);
        let slopes = self.t.page.draft.scene.bodies.iter().any(|b| b.turns && b.line.is_some());
        if slopes && !self.rolling().is_empty() && self.short != Short::Neither {
            self.say("motion.other_sign", &[]);
        }
    }

    /// All rows with numbers, as many on a line as fit.
    fn write_rows(&mut self) {
        let mut rows: Vec<String> = Vec::new();
        let mut n = 0;
        let mut firsts: Vec<(usize, usize, usize)> = Vec::new();
        for body in 0..self.t.m.parts.len() {
            let before = n;
            for degree in [Degree::Along, Degree::Turn] {
                let c = Coordinate { body, degree };
                let inertia = self.t.m.inertia(c);
                let shares: Vec<Expr> = self.t.row(c).into_iter().map(|(_, e)| e).collect();
                if let Some(a) =
                    self.t.m.acceleration(c).filter(|_| !inertia.is_empty() || !shares.is_empty())
                {
                    n += 1;
                    let by = Factors::of(&a.into());
                    let right = sum(inertia.iter().map(|i| i.times(&by).expr()));
                    let left = positive_first(shares);
                    rows.push(format!(r"{} = {} \quad ({n})", self.tex(&left), self.tex(&right)));
                    self.rows.push((c, n));
                }
                let across = self.t.m.parts[body].normal.clone().filter(|_| degree == Degree::Along);
                if let Some((normal, is)) = across {
                    n += 1;
                    let left = Expr::from(normal) - is;
                    rows.push(format!(r"{} = 0 \quad ({n})", self.tex(&left)));
                }
            }
            if n > before {
                firsts.push((body, before + 1, n));
            }
        }
        for line in packed(rows) {
            self.formula(line);
        }
        if self.t.m.parts.len() > 1 {
            let of: Vec<String> = firsts
                .iter()
                .map(|(body, first, last)| {
                    let label = &self.t.m.parts[*body].label;
                    let more = if last > first { format!("–({last})") } else { String::new() };
                    format!("{label} ({first}){more}")
                })
                .collect();
            self.say("motion.of", &[("list", &of.join(", "))]);
        }
    }

    fn number_of(&self, c: Coordinate) -> String {
        self.rows.iter().find(|(r, _)| *r == c).map_or_else(String::new, |(_, n)| n.to_string())
    }

    /// From the acceleration to the speed, or to the distance.
    fn integrate(&mut self, again: bool) {
        let a = self.acceleration();
        let v = self.speed();
        let pieces = [
            ("v", self.names(&[v])),
            ("a", self.names(&[a])),
            ("ds", if self.t.straight() { "ds".to_owned() } else { r"d\varphi".to_owned() }),
            ("d", self.inline(&self.t.distance())),
            ("vv", format!(r"{0}\,d{0}", self.t.page.draft.symbols.tex(v))),
            ("aa", self.t.page.draft.symbols.tex(a).to_owned()),
        ];
        let pieces: Vec<(&str, &str)> = pieces.iter().map(|(n, t)| (*n, t.as_str())).collect();
        match self.t.page.draft.scene.end {
            End::Time(..) => {
                self.say("motion.over_time", &pieces);
                // What comes after the acceleration.
                let at = self.t.page.steps.iter().position(|s| s.symbol == a).map_or(0, |i| i + 1);
                let known = self.t.page.steps[..at].iter().map(|s| s.symbol).collect();
                self.tell_as_known(known);
                self.tell_new();
            }
            _ if self.t.spring.is_some() => self.say("motion.integral_spring", &pieces),
            _ if again => self.say("motion.integral", &pieces),
            _ => {}
        }
    }

    /// A slipping wheel: each freedom has its own equation.
    fn two_freedoms(&mut self) -> Result<(), DerivationStop> {
        let Some(body) = self.t.m.parts.iter().position(|p| p.slips) else {
            return Err(Beyond::Arrangement.into());
        };
        if self.t.m.parts.len() > 1 {
            return Err(Beyond::SlipInCompany.into());
        }
        self.tell_frictions();
        let a = self.t.get(of_body(Quantity::A, body))?;
        let from = self.t.page.steps.iter().find(|s| s.symbol == a).map_or(ZERO, |s| s.from.clone());
        let line = self.chain(a, &from).concat();
        let alpha = self.t.get(of_body(Quantity::Alpha, body))?;
        let from = self.t.page.steps.iter().find(|s| s.symbol == alpha).map_or(ZERO, |s| s.from.clone());
        let other = self.chain(alpha, &from).concat();
        self.say("motion.own", &[]);
        if self.t.page.draft.detail == Detail::Full || width(&line) + width(&other) > PACKED {
            for l in [line, other] {
                let l = if l.contains('&') { aligned(&l) } else { l };
                self.formula(l);
            }
        } else {
            self.formula(format!(r"{line}, \qquad {other}"));
        }
        let c = self.t.contact_of(body).and_then(|t| self.t.m.action_of(t)).map(|x| self.t.magnitude(&x.arm));
        if let Some(c) = c {
            let share = c.times(&Factors::of(&alpha.into())).per(&Factors::of(&a.into())).expr();
            let share = self.valued(&share, "1");
            self.say("motion.share", &[("share", &share)]);
        }
        self.skip_new();
        let v = self.t.get(self.t.of_lead(Quantity::V, Quantity::Omega))?;
        if let Some(step) = self.t.page.steps.iter().find(|s| s.symbol == v).cloned() {
            if matches!(self.t.page.draft.scene.end, End::Travel(..) | End::Position(..)) {
                // v^2 = 2 a d, with the acceleration as it was found.
                let by = in_sense(a.into(), self.t.value(&a.into()));
                let from = root(Expr::Number(2, 1) * by * self.t.distance());
                self.say("motion.speed_of_slip", &[]);
                let tex = self.chain(v, &from).concat();
                let tex = if tex.contains('&') { aligned(&tex) } else { tex };
                self.formula(tex);
            } else {
                let displacement = match self.t.s {
                    Expr::Symbol(s) => Some(s),
                    _ => None,
                };
                self.forget(&[Some(step.symbol), displacement]);
                self.tell_new();
            }
        }
        for quantity in [Quantity::Omega, Quantity::Phi, Quantity::SlipDistance] {
            self.t.get(of_body(quantity, body))?;
        }
        self.say("motion.spin_of_slip", &[]);
        self.tell_new();
        Ok(())
    }

    /// Energy for a slipping wheel: one equation for two unknowns, and the theorem of the mass centre beside it.
    fn energy_of_slip(&mut self) -> Result<(), DerivationStop> {
        self.begin_as("long", "slip_energy");
        let Some(body) = self.t.m.parts.iter().position(|p| p.slips) else { return Ok(()) };
        let phi = self.t.get(of_body(Quantity::Phi, body))?;
        let (part, d) = (self.t.m.parts[body].clone(), self.t.distance());
        let (Some(v), Some(w)) = (part.v, part.omega) else { return Ok(()) };
        let half = ratio(1, 2);
        let place = if self.t.value(&self.t.s) < 0.0 { -1.0 } else { 1.0 };
        let turn = if self.t.value(
            &self
                .t
                .page
                .steps
                .iter()
                .find(|s| Some(s.symbol) == part.alpha)
                .map_or(ZERO, |s| s.symbol.into()),
        ) < 0.0
        {
            -1.0
        } else {
            1.0
        };
        let row = |n: &Self, degree| {
            let row = n.t.row(Coordinate { body, degree });
            positive_first(row.into_iter().map(|(_, e)| e).collect())
        };
        let (forces, moments) = (row(self, Degree::Along), row(self, Degree::Turn));
        let wrapped = |n: &Self, e: Expr, sense: f64, by: Expr| n.tex(&(in_sense(e, sense) * by));
        let centre = format!(
            "{} = {}",
            wrapped(self, forces, place, d),
            self.tex(&(&half * part.mass.expr() * square(v)))
        );
        let spin = sum(part.inertia.iter().map(|i| &half * i.expr() * square(w)));
        let rotation = format!("{} = {}", wrapped(self, moments, turn, phi.into()), self.tex(&spin));
        let f = self.kinetic_frictions();
        let f = self.names(&f);
        self.say("slip.centre", &[("friction", &f)]);
        self.formula(format!(r"{centre}, \qquad {rotation}"));
        let names = self.names(&[v, w]);
        self.say("slip.neither", &[("unknown", &names), ("friction", &f)]);
        Ok(())
    }

    /// Why the first way is shorter: unknowns and equations of both, counted alike.
    fn why(&mut self) {
        let even = self.reactions().is_empty() && self.t.spring.is_none();
        self.begin_as("why", if even { "which" } else { "why" });
        let (reactions, normals, rubs) = (self.reactions(), self.normals(), self.kinetic_frictions());
        let (accelerations, speeds) = (self.accelerations(), self.speeds());
        let newton: Vec<SymbolId> =
            [reactions.clone(), rubs.clone(), normals.clone(), accelerations, speeds.clone()].concat();
        let pressing: Vec<SymbolId> = if rubs.is_empty() { Vec::new() } else { normals.clone() };
        let energy: Vec<SymbolId> = [rubs.clone(), pressing, speeds].concat();
        let (many, few) = (self.names(&newton), self.names(&energy));
        let (n, k) = (newton.len().to_string(), energy.len().to_string());
        let pieces = [("many", &*many), ("n", &*n), ("few", &*few), ("k", &*k)];
        if even {
            self.say("why.neither", &pieces);
        } else {
            let hidden = self.names(&reactions);
            self.say("why.newton", &pieces);
            if self.gone.is_empty() {
                self.say("why.no_reaction", &[]);
            } else {
                self.say("why.eliminate", &[("forces", &hidden)]);
            }
            self.say("why.energy", &pieces);
            let silent: Vec<SymbolId> =
                reactions.into_iter().chain(normals.into_iter().filter(|_| rubs.is_empty())).collect();
            if !silent.is_empty() {
                let silent = self.names(&silent);
                self.say("why.price", &[("forces", &silent)]);
            }
            if self.t.page.draft.asks(Quantity::T) {
                self.say("why.price_time", &[]);
            }
        }
        self.say("why.ask", &[]);
    }

    fn why_not_energy(&mut self) {
        self.begin("why");
        let v = self.speed();
        let s = self.inline(&self.t.s.clone());
        let v = self.names(&[v]);
        self.say("why.not_energy", &[("v", &v), ("s", &s)]);
        self.say("why.ask", &[]);
    }

    /// Forces that are asked; friction of a rolling body always: in closed form, and why it points as it does.
    fn forces(&mut self) -> Result<(), DerivationStop> {
        self.begin("forces");
        let asked: Vec<Label> = self.t.page.draft.problem.questions.iter().map(|q| q.label).collect();
        self.skip_new();
        let rolling = self.rolling();
        for label in asked.iter().filter(|l| matches!(l.quantity, Quantity::A | Quantity::Alpha)) {
            self.t.get(*label)?;
        }
        let wanted = |q: Quantity| matches!(q, Quantity::Friction | Quantity::Tension | Quantity::Normal);
        for label in asked.iter().filter(|l| wanted(l.quantity)) {
            self.t.get(*label)?;
        }
        for (_, body) in &rolling {
            self.t.get(of_body(Quantity::Friction, *body))?;
        }
        let kinds = [ForceKind::Spring];
        let sprung = !self.t.shares(&kinds).is_empty();
        if sprung {
            let at_end = [self.t.spring.as_ref().map(|s| s.tension), Some(self.acceleration())];
            self.forget(&at_end);
            self.say("forces.spring", &[]);
        } else if self.t.page.steps.iter().any(|s| !self.is_told(s.symbol)) {
            let a = self.acceleration();
            let name = if self.short == Short::Energy && self.t.v0 == ZERO && self.t.straight() {
                "forces.back"
            } else {
                "forces.rows"
            };
            let v = self.speed();
            let by = square(v) / (Expr::Number(2, 1) * self.t.distance());
            let place = matches!(self.t.page.draft.scene.end, End::Travel(..));
            let name = if place { name } else { "forces.rows" };
            let by =
                format!("${} = {}$", self.t.page.draft.symbols.tex(a), self.tex(&in_sense(by, self.t.sense)));
            self.say(name, &[("a", &by)]);
        }
        let normals: Vec<Option<SymbolId>> = self.normals().into_iter().map(Some).collect();
        if !rolling.is_empty() {
            self.forget(&normals);
        }
        self.tell_new();
        for (t, body) in rolling {
            self.read_friction(t, body)?;
        }
        Ok(())
    }

    /// The closed form of a rolling body's friction, and what its signs say.
    fn read_friction(&mut self, tie: usize, body: usize) -> Result<(), DerivationStop> {
        let f = self.t.get(of_body(Quantity::Friction, body))?;
        let value = self.t.page.draft.symbols.value(f);
        let up = self.way(body, 1.0);
        if self.t.m.parts[body].normal.is_none() {
            return Ok(());
        }
        if let Some(closed) = self.t.closed_friction(body) {
            let whole = closed.expr();
            let scale = value.abs().max(1e-9);
            if !closed.terms.is_empty() && (self.t.value(&whole) - value).abs() < 1e-6 * scale {
                self.say("friction.closed", &[]);
                let tex = format!(
                    "{} = {} = {}",
                    self.t.page.draft.symbols.tex(f),
                    self.tex(&whole),
                    self.t.page.draft.symbols.shown(f)
                );
                self.formula(tex);
                self.read_signs(body, &closed.terms);
            }
        }
        let sense = self.way(body, value);
        if value != 0.0 {
            let symbol = self.names(&[f]);
            self.say("friction.points", &[("f", &symbol), ("way", &sense)]);
        }
        if let Tie::Roll { mu_s: Some(mu), .. } = self.t.page.draft.scene.ties[tie] {
            let mu = self.t.page.draft.number(mu, r"\mu_s", "1");
            let n = self.t.get(of_body(Quantity::Normal, body))?;
            let most = self.valued(&(mu * n), "N");
            let symbol = self.names(&[f]);
            self.say("friction.not_mu", &[("f", &symbol), ("most", &most)]);
        }
        if self.t.page.draft.asks(Quantity::KBound) {
            self.skip_new();
            let k0 = self.t.get(of_body(Quantity::KBound, body))?;
            self.say("friction.bound", &[("way", &up)]);
            self.tell_new();
            let outer = self.t.page.draft.scene.bodies[body].radii_m.iter().map(|(_, r)| *r);
            let outer =
                outer.max_by(|a, b| self.t.page.draft.value(*a).total_cmp(&self.t.page.draft.value(*b)));
            if let Some(r) = outer
                && self.t.page.draft.symbols.value(k0) >= self.t.page.draft.value(r)
            {
                let r = self.t.page.draft.number(r, "R", "m");
                let r = self.inline(&r);
                self.say("friction.any_wheel", &[("r", &r), ("way", &up)]);
            }
        }
        Ok(())
    }

    /// Which forces always push friction one way, and which change with the distribution of mass.
    fn read_signs(&mut self, body: usize, terms: &[(Action, Factors)]) {
        for (action, lever) in terms {
            let whole = lever.expr();
            let name = match action.source {
                ForceSource::Weight(_) => "friction.weight".to_owned(),
                _ => "friction.force".to_owned(),
            };
            let force = self.inline(&action.force);
            let mixed = match &whole {
                Expr::Sum(parts) => parts.iter().any(|p| matches!(p, Expr::Minus(_))),
                Expr::Product(parts) => parts.iter().any(
                    |p| matches!(p, Expr::Sum(terms) if terms.iter().any(|t| matches!(t, Expr::Minus(_)))),
                ),
                _ => false,
            };
            let positive = self.t.value(&(whole.clone() * self.t.size(action.force.clone()))) > 0.0;
            let sense = self.way(body, if positive { 1.0 } else { -1.0 });
            if mixed {
                let factor = self.inline(&whole);
                self.say("friction.changes", &[("force", &force), ("factor", &factor), ("way", &sense)]);
            } else {
                self.say(&name, &[("force", &force), ("way", &sense)]);
            }
        }
    }

    /// What else is asked.
    fn rest(&mut self) -> Result<(), DerivationStop> {
        self.begin("rest");
        self.skip_new();
        let asked: Vec<Label> = self.t.page.draft.problem.questions.iter().map(|q| q.label).collect();
        for label in &asked {
            let skip = matches!(label.quantity, Quantity::FrictionIfRolled);
            if label.quantity.is_word() || skip {
                continue;
            }
            let symbol = self.t.get(*label)?;
            self.t.page.draft.answer(*label, DerivedAnswer::Value(symbol));
        }
        self.tell_new();
        Ok(())
    }

    /// Is what was assumed so? And the words that are asked.
    fn holds(&mut self) -> Result<(), DerivationStop> {
        self.begin("holds");
        let lead = self.t.lead();
        let part = &self.t.m.parts[lead.body];
        let sloped = matches!(part.path, "incline" | "vertical");
        let up = self.t.sense * f64::from(part.up) > 0.0;
        let word = match (sloped, up) {
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, true) => Word::Forward,
            (false, false) => Word::Back,
        };
        self.answer(Label { quantity: Quantity::Direction, of: Owner::Body(lead.body) }, word);
        self.torn_loose()?;
        let mut taut: Vec<String> = Vec::new();
        for tie in 0..self.t.page.draft.scene.ties.len() {
            match self.t.page.draft.scene.ties[tie].clone() {
                Tie::Roll { body, mu_s, .. } if self.t.m.parts[body].normal.is_some() => {
                    self.grips(body, mu_s)?;
                }
                Tie::Slip { body, .. } => self.slides_against(body)?,
                Tie::Cord(c) => match c.to {
                    Far::Body(_) | Far::Fixed => taut.extend(self.taut(tie)?),
                    Far::Spring { rigid: false, .. } => {
                        if let Some(t) = self.taut(tie)? {
                            self.say("holds.taut_spring", &[("t", &t)]);
                        }
                    }
                    Far::Spring { .. } | Far::Pull(_) => {}
                },
                _ => {}
            }
        }
        if !taut.is_empty() {
            let name = if taut.len() == 1 { "holds.taut" } else { "holds.taut_all" };
            self.say(name, &[("t", &taut.join(", "))]);
        }
        self.reaches()
    }

    fn answer(&mut self, label: Label, word: Word) {
        self.t.page.draft.answer(label, DerivedAnswer::Word(word));
    }

    /// Slides that start from rest have to be torn loose.
    fn torn_loose(&mut self) -> Result<(), DerivationStop> {
        if self.t.v0 != ZERO {
            return Ok(());
        }
        for tie in self.t.page.draft.scene.ties.clone() {
            let Tie::Slide { body, mu_s: Some(mu), .. } = tie else { continue };
            let along = Coordinate { body, degree: Degree::Along };
            if self.t.m.ratio(along).is_zero() {
                continue;
            }
            let mu = self.t.page.draft.number(mu, r"\mu_s", "1");
            let n = self.t.get(of_body(Quantity::Normal, body))?;
            let given = self.t.shares(&[ForceKind::Given]).into_iter().map(|(_, e)| e);
            let push = positive_first(vec![in_sense(sum(given), self.t.sense)]);
            let ratio = self.t.magnitude(self.t.m.ratio(along));
            let hold = (mu * n) * ratio.expr();
            let (push, hold) = (self.valued(&push, "N"), self.valued(&hold, "N"));
            self.say("holds.torn", &[("push", &push), ("hold", &hold)]);
        }
        Ok(())
    }

    /// `|F| <= mu_s N` as far as the scene looks.
    fn grips(&mut self, body: usize, mu_s: Option<crate::scene::Num>) -> Result<(), DerivationStop> {
        let n = self.t.get(of_body(Quantity::Normal, body))?;
        let f = self.t.get(of_body(Quantity::Friction, body))?;
        let normal = self.shown(n);
        let Some(mu) = mu_s else {
            self.say("holds.pressed", &[("n", &normal)]);
            self.say("holds.no_coefficient", &[]);
            return Ok(());
        };
        let mu = self.t.page.draft.number(mu, r"\mu_s", "1");
        let most = self.t.value(&(&mu * n));
        let mut largest = f;
        self.skip_new();
        if self.t.spring.is_some() {
            let ends = self.t.extremes(body)?;
            let [a, b] = ends.map(|(_, f)| self.t.page.draft.symbols.value(f).abs());
            largest = if a >= b { ends[0].1 } else { ends[1].1 };
            let both: Vec<String> = ends.iter().map(|(_, f)| self.shown(*f)).collect();
            let far = match self.t.page.draft.scene.span {
                Span::ToEnd => "end",
                Span::ToTurningPoint => "turn",
            };
            let range = self.phrase(&format!("holds.range.{far}"), &[]);
            self.say("holds.extremes", &[("range", &range), ("one", &both[0]), ("two", &both[1])]);
            self.skip_new();
        }
        let value = self.t.page.draft.symbols.value(largest).abs();
        let share = self.relation(&(magnitude(largest) / n), value / self.t.page.draft.symbols.value(n), "1");
        let mu = self.valued_plain(&mu);
        self.say("holds.rolls", &[("n", &normal), ("share", &share), ("mu", &mu)]);
        if value > most {
            return Err(Beyond::SlipsAfterAll.into());
        }
        self.answer(of_body(Quantity::Rolls, body), Word::Yes);
        Ok(())
    }

    fn valued_plain(&self, e: &Expr) -> String {
        match e {
            Expr::Symbol(s) => self.shown(*s),
            e => self.inline(e),
        }
    }

    /// The contact slides against the friction that was assumed.
    fn slides_against(&mut self, body: usize) -> Result<(), DerivationStop> {
        let a = self.t.get(of_body(Quantity::A, body))?;
        let alpha = self.t.get(of_body(Quantity::Alpha, body))?;
        let friction = self.t.get(of_body(Quantity::Friction, body))?;
        let arm = self.t.contact_of(body).and_then(|t| self.t.m.action_of(t)).map(|x| x.arm.clone());
        let Some(arm) = arm else { return Err(Beyond::Arrangement.into()) };
        let c = self.t.magnitude(&arm).expr();
        let contact = a - c * alpha;
        let up = f64::from(self.t.m.parts[body].up);
        let value = self.t.value(&contact) * up;
        let friction = self.t.page.draft.symbols.value(friction);
        if value * friction >= 0.0 {
            return Err(Beyond::FrictionWithSlip.into());
        }
        let (slides, force) = (self.way(body, value), self.way(body, friction));
        let contact = self.valued(&contact, "m/s^2");
        self.say("holds.slides", &[("a", &contact), ("slides", &slides), ("force", &force)]);
        self.answer(of_body(Quantity::Rolls, body), Word::No);
        Ok(())
    }

    /// Tension of a cord, none where it is 0.
    fn taut(&mut self, tie: usize) -> Result<Option<String>, DerivationStop> {
        let told = self.t.page.steps.len();
        let t = self.t.get(of_tie(Quantity::Tension, tie))?;
        let value = self.t.page.draft.symbols.value(t);
        if value < 0.0 {
            return Err(Beyond::SlackCord.into());
        }
        let new: Vec<SymbolId> = self.t.page.steps[told..].iter().map(|s| s.symbol).collect();
        let shown = match new.is_empty() {
            true => self.shown(t),
            false => new.iter().map(|s| self.chained(*s)).collect::<Vec<_>>().join(", "),
        };
        Ok((value > 0.0).then_some(shown))
    }

    /// The end lies before the turning point.
    fn reaches(&mut self) -> Result<(), DerivationStop> {
        let lead = self.t.lead();
        if !matches!(self.t.page.draft.scene.end, End::Travel(..) | End::Position(..)) || !self.t.straight() {
            return Ok(());
        }
        let turns = self.t.spring.is_some() || self.t.value(&self.t.drive) * self.t.sense < 0.0;
        let level = self.t.spring.as_ref().is_some_and(|s| !s.rigid) && self.t.value(&self.t.drive) == 0.0;
        if !turns || level {
            return Ok(());
        }
        self.skip_new();
        let turn = self.t.get(of_body(Quantity::DTurn, lead.body))?;
        let (d, far) = (self.t.value(&self.t.distance()), self.t.page.draft.symbols.value(turn));
        if d > far {
            return Err(Beyond::BehindTurning.into());
        }
        let distance = self.inline(&self.t.distance());
        let shown = self.shown(turn);
        self.skip_new();
        self.say("holds.reaches", &[("d", &distance), ("turn", &shown)]);
        Ok(())
    }

    /// A limit or two, and where the energy went.
    fn limits(&mut self) -> Result<(), DerivationStop> {
        self.begin("limits");
        if self.short == Short::Energy && self.t.v0 == ZERO && self.t.spring.is_none() {
            self.massless_limit();
        }
        if self.t.spring.is_none() && self.t.v0 == ZERO && self.short == Short::Energy {
            self.balance_limit();
        }
        if self.t.v0 == ZERO && self.short != Short::Motion {
            self.energies()?;
        }
        if let Some(spring) = self.t.spring.clone() {
            let still = self.t.get(of_scene(Quantity::XEq)).ok();
            if let Some(x) = still.filter(|_| self.t.value(&spring.stretch) > 0.0) {
                let (x, x0) = (self.names(&[x]), self.inline(&spring.stretch));
                self.say("limits.still_spring", &[("x0", &x0), ("x", &x)]);
            }
        }
        self.skip_new();
        Ok(())
    }

    /// Without rotary inertia: the closed form of the speed that is left.
    fn massless_limit(&mut self) {
        let turning: Vec<Coordinate> = self
            .coordinates()
            .into_iter()
            .filter(|c| c.degree == Degree::Turn && !self.t.m.inertia(*c).is_empty())
            .collect();
        let v = self.speed();
        let lines = self.coordinates().into_iter().filter(|c| c.degree == Degree::Along);
        let masses: Vec<Expr> = lines
            .flat_map(|c| {
                let by = self.t.m.ratio(c).squared();
                self.t.m.inertia(c).into_iter().map(move |i| i.times(&by).expr())
            })
            .filter(|e| *e != ZERO)
            .collect();
        if turning.is_empty() || masses.is_empty() || !self.t.straight() {
            return;
        }
        let drive = positive_first(vec![in_sense(self.t.drive.clone(), self.t.sense)]);
        let light = Expr::Number(2, 1) * self.t.distance() * drive;
        let light = Factors::of(&light).per(&Factors::of(&sum(masses))).expr();
        let fast = self.relation(&root(light.clone()), self.t.value(&light).sqrt(), "m/s");
        let v = self.shown(v);
        self.say("limits.massless", &[("v", &v), ("fast", &fast)]);
    }

    /// Where the driving force just balances: nothing happens.
    fn balance_limit(&mut self) {
        let pull = self.t.shares(&[ForceKind::Given]).into_iter().find(|(a, share)| {
            matches!(a.source, ForceSource::Tie(_)) && self.t.value(share) * self.t.sense > 0.0
        });
        let Some((action, share)) = pull else { return };
        let others: Vec<Expr> = self
            .t
            .shares(&[ForceKind::Given])
            .into_iter()
            .filter(|(a, _)| a.source != action.source)
            .map(|(_, e)| -e)
            .collect();
        let per = Factors::of(&share).per(&Factors::of(&action.force));
        let needed = Factors::of(&positive_first(others.clone())).per(&per).expr();
        if others.is_empty() || self.t.value(&needed) <= 0.0 {
            return;
        }
        let force = self.tex(&action.force);
        let digits = tex_digits(&shown::significant(self.t.value(&needed), FIGURES), self.t.page.draft.words);
        let text = format!(r"${force} = {} = {digits}\ {}$", self.tex(&needed), tex_of("N")).replace(
            &format!("${force} ="),
            &format!("${} =", marked(&force, r"\mathrm{0}").replace(r"\mathrm{0}", "0")),
        );
        let force = self.inline(&action.force);
        self.say("limits.balance", &[("force", &force), ("is", &text)]);
    }

    /// Shares of the kinetic energy.
    fn energies(&mut self) -> Result<(), DerivationStop> {
        let turning = self
            .coordinates()
            .into_iter()
            .any(|c| c.degree == Degree::Turn && !self.t.m.inertia(c).is_empty());
        let moving = self.coordinates().into_iter().any(|c| c.degree == Degree::Along);
        if !turning || !moving || self.t.value(&self.t.v) == 0.0 {
            return Ok(());
        }
        self.skip_new();
        let share = self.t.get(of_scene(Quantity::RotationalFraction))?;
        let percent = shown::significant(100.0 * self.t.page.draft.symbols.value(share), 2);
        self.skip_new();
        let percent = tex_digits(&percent, self.t.page.draft.words);
        self.say("limits.spin", &[("percent", &percent)]);
        Ok(())
    }

    /// A question to go on with.
    fn onward(&mut self) {
        self.begin("onward");
        let pulled = self
            .t
            .page
            .draft
            .scene
            .ties
            .iter()
            .any(|t| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_))));
        let wheel = !self.rolling().is_empty() && self.t.m.parts.len() == 1;
        let pulley = self.t.m.parts.iter().any(|p| p.a.is_none() && p.alpha.is_some());
        let weighed = self.t.page.draft.scene.bodies.iter().all(|b| !matches!(b.mass, Mass::OfParts));
        let name = match () {
            () if self.short == Short::Neither => "onward.slips",
            () if self.t.spring.is_some() => "onward.spring",
            () if wheel && pulled => "onward.pulled",
            () if wheel => "onward.wheel",
            () if pulley && weighed => "onward.pulley",
            () if self.held().is_some() => "onward.held",
            () => "onward.other",
        };
        self.say(name, &[]);
        self.end();
    }
}
