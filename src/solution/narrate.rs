//! Words a scene of lines and axles from its terms: idea, short way, long way, why the one is shorter, forces, whether what was
//! assumed is so, limits, a question to go on with. Which way is short is decided from the scene.
use crate::figure::names;
use crate::num::shown;
use crate::scene::{AsIf, Coordinate, Degree, End, Far, Label, Mass, Owner, Quantity, Span, Tie};
use crate::solution::account::{Account, Eliminated, marked, of_body, of_scene, of_tie, speed_of};
use crate::solution::asked;
use crate::solution::draft::{DerivedAnswer, Detail, Draft, tex_of};
use crate::solution::expr::{
    Expr, SymbolId, ZERO, in_sense, magnitude, positive_first, ratio, root, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::page::{PACKED, WITHIN, aligned, packed};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solution::terms::{Action, ForceKind, ForceSource};
use crate::solution::text::{Block, LINE, SolutionSection};
use crate::solution::way;
use crate::solution::written::width;
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
    /// The equations of several freedoms, or of what friction holds, solved together.
    Together,
    /// Velocities and forces of an instant.
    Instant,
}

/// Writes the sections of a scene of lines and axles.
///
/// # Errors
/// What is not covered, by name.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    let ties = &draft.scene.ties;
    let slips: Vec<usize> = (0..ties.len()).filter(|t| matches!(ties[*t], Tie::Slip { .. })).collect();
    let alone = draft.scene.bodies.len() == 1 && slips.len() == 1;
    let mut rolled = Vec::new();
    for tie in slips {
        rolled.extend(could_it_roll(draft, tie)?);
    }
    let mut account = Account::new(draft, None)?;
    let stays = account.stays();
    if !stays {
        account.arrive()?;
    }
    let end = account.scene.end;
    let short = match end {
        End::AtOnce => Short::Instant,
        _ if stays || !account.m.one => Short::Together,
        _ if !rolled.is_empty() && alone => Short::Neither,
        _ if !rolled.is_empty() => Short::Together,
        End::Time(..) => Short::Motion,
        _ => Short::Energy,
    };
    let swings = account.spring.is_some() && !matches!(end, End::Travel(..) | End::Position(..));
    let mut n = Narrator { t: account, short, rows: Vec::new(), gone: Vec::new(), ratios_told: false };
    n.idea();
    n.sketch();
    n.end();
    n.draft.sections.extend(rolled);
    match short {
        Short::Energy | Short::Motion if swings => n.swings()?,
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
        Short::Together => {
            n.motion("short")?;
            if !stays {
                n.why_together();
            }
        }
        Short::Instant => n.instant()?,
    }
    let forced = short != Short::Instant || n.forces_asked();
    if forced {
        n.forces()?;
    }
    n.rest()?;
    if forced {
        n.holds()?;
    }
    n.limits()?;
    n.onward();
    Ok(())
}

/// Quantities of the scene as if its contacts were others: the equations of motion, solved again.
///
/// # Errors
/// What is not covered.
pub fn as_if(
    draft: &mut Draft,
    how: AsIf,
    labels: &[Label],
) -> Result<Vec<(Label, SymbolId)>, DerivationStop> {
    let mut account = Account::new(draft, None)?;
    account.arrive()?;
    let mut n = Narrator {
        t: account,
        short: Short::Instant,
        rows: Vec::new(),
        gone: Vec::new(),
        ratios_told: false,
    };
    n.begin_as("as_if", if how == AsIf::Rolls { "rolled" } else { "smooth" });
    n.say(if how == AsIf::Rolls { "asked.rolls" } else { "asked.smooth" }, &[]);
    n.write_rows();
    n.tell_ratios();
    let a = n.acceleration();
    if n.m.one {
        let right = Factors::of(&n.effective).times(&Factors::of(&a.into())).expr();
        let line = format!("{} = {}", n.tex(&n.all_shares()), n.tex(&right));
        n.say("asked.together", &[]);
        n.formula(line);
    }
    n.skip_new();
    let mut found = Vec::new();
    for label in labels {
        found.push((*label, n.get(*label)?));
    }
    let mut wanted = vec![Some(a)];
    wanted
        .extend(n.steps.iter().filter(|s| found.iter().any(|(_, f)| *f == s.symbol)).map(|s| Some(s.symbol)));
    wanted.extend(n.kinetic_frictions().into_iter().map(Some));
    n.forget(&wanted);
    n.tell_new();
    n.end();
    Ok(found)
}

/// What friction rolling would need on a contact that is said to slip.
fn could_it_roll(draft: &mut Draft, tie: usize) -> Result<Option<SolutionSection>, DerivationStop> {
    let Tie::Slip { body, mu_s, .. } = draft.scene.ties[tie] else { return Ok(None) };
    let told = draft.scene.end != End::AtOnce;
    let asked = [Quantity::FrictionIfRolled, Quantity::MuRequired];
    if !told && !asked.iter().any(|q| draft.asks(*q)) || draft.stays() && !draft.asks(asked[0]) {
        return Ok(None);
    }
    let account = Account::new(draft, Some(tie))?;
    let mut n = Narrator {
        t: account,
        short: Short::Neither,
        rows: Vec::new(),
        gone: Vec::new(),
        ratios_told: false,
    };
    n.begin("rolled");
    let friction = of_body(Quantity::Friction, body);
    let closed = if n.m.one { n.t.closed_friction(body) } else { None };
    let needed = match (closed, n.m.force_of(tie)) {
        (Some(closed), Some(f)) => n.found(friction, f, closed.expr()),
        _ => {
            if n.m.one {
                n.arrive()?;
            }
            n.get(friction)?
        }
    };
    let name = if n.m.one { "rolled.needs" } else { "rolled.needs_together" };
    n.say(name, &[]);
    n.tell_new();
    let normal = n.get(of_body(Quantity::Normal, body))?;
    let value = n.symbols.value(needed);
    n.draft.answer(of_body(Quantity::FrictionIfRolled, body), DerivedAnswer::Value(needed));
    let mu = n.number(mu_s, r"\mu_s", "1");
    let most = mu * normal;
    let slips = value.abs() > n.value(&most);
    let size = n.relation(&n.size(needed.into()), value.abs(), "N");
    let limit = n.valued(&most, "N");
    let sense = n.way(body, value);
    n.say(
        if slips { "rolled.slips" } else { "rolled.rolls" },
        &[("needed", &size), ("limit", &limit), ("way", &sense)],
    );
    n.stop();
    Ok(Some(std::mem::replace(&mut n.out, SolutionSection::new("", ""))))
}

/// Who words the sections, one after the other.
struct Narrator<'d, 'a> {
    t: Account<'d, 'a>,
    short: Short,
    /// The rows as they are numbered.
    rows: Vec<(Coordinate, usize)>,
    gone: Vec<Eliminated>,
    /// Are the ratios of displacements on the page?
    ratios_told: bool,
}

impl<'d, 'a> Deref for Narrator<'d, 'a> {
    type Target = Account<'d, 'a>;
    fn deref(&self) -> &Self::Target {
        &self.t
    }
}

impl DerefMut for Narrator<'_, '_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.t
    }
}

impl<'d, 'a> Narrator<'d, 'a> {
    fn way(&self, body: usize, value: f64) -> String {
        let name = way(self.scene, Owner::Body(body), value);
        name.map_or_else(String::new, |w| self.words.get(w).to_owned())
    }
    fn body(&self, body: usize) -> String {
        names::body_within(self.words, self.scene, body)
    }
    /// The speed of the lead.
    fn speed(&self) -> SymbolId {
        self.m.speed(self.lead()).unwrap_or(SymbolId(0))
    }
    /// The acceleration of the lead.
    fn acceleration(&self) -> SymbolId {
        self.m.acceleration(self.lead()).unwrap_or(SymbolId(0))
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
    fn held(&self) -> Option<(usize, usize)> {
        self.scene.ties.iter().enumerate().find_map(|(t, tie)| match tie {
            Tie::Cord(c) if c.to == Far::Fixed => Some((t, c.from.body)),
            _ => None,
        })
    }
    fn hidden(&self) -> Vec<SymbolId> {
        self.reactions().into_iter().map(|(_, f)| f).collect()
    }
    fn normals(&self) -> Vec<SymbolId> {
        self.m.parts.iter().filter_map(|p| p.normal.as_ref().map(|(n, _)| *n)).collect()
    }
    fn kinetic_frictions(&self) -> Vec<SymbolId> {
        let kinetic = self.m.actions.iter().filter(|a| a.kind == ForceKind::Kinetic);
        kinetic
            .filter_map(|a| match a.source {
                ForceSource::Tie(t) => self.m.force_of(t),
                _ => None,
            })
            .collect()
    }
    fn coordinates(&self) -> Vec<Coordinate> {
        self.scene
            .coordinates()
            .filter(|c| !self.m.inertia(*c).is_empty() || self.m.speed(*c).is_some())
            .collect()
    }
    fn speeds(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.m.speed(*c)).collect()
    }
    fn accelerations(&self) -> Vec<SymbolId> {
        self.coordinates().iter().filter_map(|c| self.m.acceleration(*c)).collect()
    }
    /// `v = r omega` and its likes: every other coordinate by the lead's; speeds are magnitudes.
    fn links(&self, signed: bool, of: impl Fn(&Self, Coordinate) -> Option<SymbolId>) -> Vec<String> {
        let lead = self.lead();
        let Some(by) = of(self, lead) else { return Vec::new() };
        let others = self.coordinates().into_iter().filter(|c| *c != lead && !self.own(*c));
        others
            .filter_map(|c| {
                let symbol = of(self, c)?;
                let ratio = self.m.ratio(c);
                let ratio = if signed { ratio.clone() } else { self.magnitude(ratio) };
                let right = Factors::of(&by.into()).times(&ratio).expr();
                Some(format!("${} = {}$", self.symbols.tex(symbol), self.tex(&right)))
            })
            .collect()
    }

    // The sections.

    fn idea(&mut self) {
        self.begin("idea");
        let spring = self.spring.is_some();
        let name = match (self.short, self.scene.end) {
            (Short::Instant, _) => "idea.instant",
            (Short::Together, _) if self.stays() => "idea.stays",
            (Short::Together, _) => "idea.together",
            (Short::Neither, _) => "idea.slips",
            (Short::Motion, _) => "idea.time",
            (Short::Energy, End::Travel(..) | End::Position(..)) if spring => "idea.spring",
            (Short::Energy, End::Travel(..) | End::Position(..)) => "idea.place",
            (Short::Energy, _) => "idea.speed",
        };
        self.say(name, &[]);
        if matches!(self.short, Short::Energy | Short::Motion) {
            if let Some((t, body)) = self.rolling().first().copied() {
                let body = self.body(body);
                self.say("idea.rolls", &[("body", &body)]);
                let f = self.m.force_of(t).map_or_else(String::new, |f| self.names(&[f]));
                if self.short == Short::Energy {
                    self.say("idea.idle_roll", &[("force", &f)]);
                }
            }
            if let Some((t, body)) = self.held() {
                let body = self.body(body);
                let f = self.m.force_of(t).map_or_else(String::new, |f| self.names(&[f]));
                self.say("idea.held", &[("body", &body)]);
                if self.short == Short::Energy {
                    self.say("idea.idle_held", &[("force", &f)]);
                }
            }
            let cords = self.cords();
            if !cords.is_empty() {
                let forces: Vec<SymbolId> = cords.iter().filter_map(|t| self.m.force_of(*t)).collect();
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
        let bodies = &self.scene.bodies;
        all.extend(bodies.iter().map(|b| Block::Picture(format!("forces-{}", b.name))));
        self.out.blocks = all;
    }

    /// Work and energy: how far each point goes, the balance, what follows.
    fn energy(&mut self) {
        self.begin_as("short", "short_energy");
        // The direction is judged with the ratio of displacements.
        self.tell_ratios();
        if self.asks(Quantity::Direction) {
            self.tell_direction();
        }
        let place = matches!(self.scene.end, End::Travel(..) | End::Position(..));
        let (lead, d) = (self.lead(), self.distance());
        let against = self.value(&self.s) < 0.0;
        if place && against {
            let body = self.body(lead.body);
            let sense = self.way(lead.body, -f64::from(self.m.parts[lead.body].up));
            self.say("energy.against", &[("body", &body), ("way", &sense)]);
        }
        // The stretch at the end comes before the balance.
        let spring = self.spring.clone();
        let v = self.t.speed_at_end().ok();
        let at = self.steps.iter().position(|s| Some(s.symbol) == v);
        if spring.is_some() {
            let kept = self.steps.split_off(at.unwrap_or(0));
            self.say("energy.stretch", &[]);
            let normals = self.normals();
            self.tell_as_known(normals);
            self.tell_new();
            self.steps.extend(kept);
        }
        let start = if self.v0 == ZERO { "energy.from_rest" } else { "energy.moving" };
        self.say(start, &[]);
        let balance = self.balance(&d);
        let links = self.links(false, |n, c| n.m.speed(c));
        self.formula(balance);
        if !links.is_empty() {
            self.say("energy.links", &[("links", &links.join(", "))]);
        }
        if !self.kinetic_frictions().is_empty() {
            self.tell_frictions();
        }
        let target = if place { v } else { self.steps.last().map(|s| s.symbol) };
        let step = self.steps.iter().find(|s| Some(s.symbol) == target).cloned();
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
        let asked = asked::needed(self.scene, self.problem);
        for label in asked {
            if matches!(label.quantity, Quantity::V | Quantity::Omega) {
                let _ = self.get(label);
            }
        }
        self.tell_new();
        for quantity in [Quantity::XEq, Quantity::VMax, Quantity::DAtVMax] {
            if self.asks(quantity) && self.spring.is_some() {
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
        let squares = square(&self.v) - square(&self.v0);
        let squares = if self.v == ZERO { -square(&self.v0) } else { squares };
        &self.effective * squares / (Expr::Number(2, 1) * &self.drive)
    }

    /// The named ratios of displacements, from the distances to the point of contact.
    fn tell_ratios(&mut self) {
        if std::mem::replace(&mut self.ratios_told, true) {
            return;
        }
        let gammas = self.gammas.clone();
        for (tie, gamma, is) in gammas {
            let Some(action) = self.m.action_of(tie).cloned() else { continue };
            let contact = self.contact_of(action.body).and_then(|t| self.m.action_of(t)).cloned();
            let Some(contact) = contact else {
                self.display(gamma, &is, "");
                continue;
            };
            let c = self.magnitude(&contact.arm);
            let away = c.times(&Factors::of(&is)).expr();
            let (c, away) = (self.inline(&c.expr()), self.inline(&away));
            let spring = action.kind == ForceKind::Spring;
            let name = if spring { "energy.ratio_spring" } else { "energy.ratio" };
            self.say(name, &[("centre", &c), ("point", &away)]);
            let line = self.chain(gamma, &is).concat();
            let travel = of_tie(Quantity::CordTravel, tie);
            let given = matches!(self.scene.end, End::Travel(..) | End::Position(..));
            let tail = if given && !spring && self.s != ZERO && self.asks_label(travel) {
                self.get(travel).ok().map(|l| {
                    let from = self.steps.last().map_or(ZERO, |s| s.from.clone());
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
            if self.symbols.value(gamma) > 1.0 && !spring {
                let gamma = self.names(&[gamma]);
                self.say("energy.ratio_check", &[("gamma", &gamma)]);
            }
        }
    }

    /// Works on the left, kinetic energies on the right.
    fn balance(&self, d: &Expr) -> String {
        let half = Factors::of(&ratio(1, 2));
        let sense = if self.value(&self.s) < 0.0 { -1.0 } else { 1.0 };
        let mut works = Vec::new();
        if let Some(s) = &self.spring {
            let squares = match &self.last {
                &ZERO => square(&s.stretch),
                x1 => square(&s.stretch) - square(x1),
            };
            works.push(ratio(1, 2) * &s.stiffness * squares);
        }
        for (_, share) in self.shares(&[ForceKind::Given, ForceKind::Kinetic]) {
            works.push(in_sense(Factors::of(&share).times(&Factors::of(d)).expr(), sense));
        }
        let left = positive_first(works);
        let right = if self.v0 == ZERO {
            let mut all = Vec::new();
            for c in self.coordinates() {
                let Some(v) = self.m.speed(c) else { continue };
                for i in self.m.inertia(c) {
                    all.push(i.times(&Factors::of(&square(v))).times(&half).expr());
                }
            }
            sum(all)
        } else {
            let gain = square(self.v.clone()) - square(&self.v0);
            let gain = if self.v == ZERO { -square(&self.v0) } else { gain };
            ratio(1, 2) * &self.effective * gain
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
        let (force, inertia) = if self.straight() { ("N", "kg") } else { ("N m", "kg m^2") };
        let mut groups = Vec::new();
        for (_, share) in self.shares(&[ForceKind::Given]) {
            let size = match share {
                Expr::Minus(inner) => *inner,
                other => other,
            };
            if !matches!(size, Expr::Symbol(_)) {
                groups.push(self.valued(&size, force));
            }
        }
        if !matches!(self.effective, Expr::Symbol(_)) {
            groups.push(self.valued(&self.effective.clone(), inertia));
        }
        if !groups.is_empty() {
            self.say("energy.groups", &[("groups", &groups.join(", "))]);
        }
    }

    /// Sliding friction, with the normal forces that it hangs on.
    fn tell_frictions(&mut self) {
        let of = |n: &Self, s: SymbolId| {
            n.steps.iter().find(|step| step.symbol == s).map(|step| step.from.clone())
        };
        for f in self.kinetic_frictions() {
            let Some(from) = of(self, f) else { continue };
            let normals: Vec<SymbolId> =
                self.normals().into_iter().filter(|n| from.uses().contains(n)).collect();
            if self.detail == Detail::Full {
                for symbol in normals.into_iter().chain([f]) {
                    let from = of(self, symbol).unwrap_or(ZERO);
                    self.display(symbol, &from, "");
                }
            } else {
                let normal: Vec<String> = normals.iter().map(|n| self.chained(*n)).collect();
                let chain = self.chained(f);
                self.say("energy.slides", &[("normal", &normal.join(", ")), ("friction", &chain)]);
            }
        }
    }

    fn tell_fastest(&mut self) {
        self.skip_new();
        let _ = self.get(of_scene(Quantity::XEq));
        self.say("energy.equilibrium", &[]);
        self.tell_new();
        if self.asks(Quantity::VMax) || self.asks(Quantity::DAtVMax) {
            let _ = self.t.top_speed();
            self.say("energy.fastest", &[]);
            self.tell_new();
        }
    }

    fn tell_direction(&mut self) {
        let lead = self.lead();
        let part = &self.m.parts[lead.body];
        let up = self.sense * f64::from(part.up) > 0.0;
        let sense = self.way(lead.body, if up { 1.0 } else { -1.0 });
        match self.spring.clone() {
            Some(s) => {
                let pull = Factors::of(&s.stiffness).times(&s.gamma).times(&Factors::of(&s.stretch)).expr();
                let pull = self.valued(&pull, "N");
                let drive = self.drive.clone();
                let against = self.valued(&in_sense(drive.clone(), self.value(&drive)), "N");
                let name = if drive == ZERO { "energy.direction_alone" } else { "energy.direction_spring" };
                self.say(name, &[("pull", &pull), ("against", &against), ("way", &sense)]);
            }
            None => {
                let shares = self.shares(&[ForceKind::Given]).into_iter().map(|(_, e)| e);
                let helps = |n: &Self, e: &Expr| n.value(e) * n.sense > 0.0;
                let (with, against): (Vec<Expr>, Vec<Expr>) = shares.partition(|e| helps(self, e));
                let size = |n: &Self, all: Vec<Expr>| {
                    let whole = sum(all);
                    let unit = if n.straight() { "N" } else { "N m" };
                    n.valued(&in_sense(whole.clone(), n.value(&whole)), unit)
                };
                let free = against.is_empty();
                let (pull, against) = (size(self, with), size(self, against));
                let name = if free { "energy.direction_free" } else { "energy.direction" };
                self.say(name, &[("pull", &pull), ("against", &against), ("way", &sense)]);
            }
        }
    }

    /// The equations of motion, the elimination, the integral.
    fn motion(&mut self, id: &'static str) -> Result<(), DerivationStop> {
        let title = match (id, self.short) {
            (_, Short::Instant) => "motion",
            ("long", _) => "long_motion",
            (_, Short::Neither | Short::Together) => "one_motion",
            _ => "short_motion",
        };
        self.begin_as(id, title);
        let first = self.short == Short::Instant
            || id == "short" && matches!(self.short, Short::Motion | Short::Energy);
        self.tell_ratios();
        self.say_senses();
        self.write_rows();
        if first || self.short == Short::Together && self.m.one {
            self.tell_frictions();
        }
        if let (Some((tie, ..)), true) = (self.scene.spring(), self.spring.is_none() || self.t.still())
            && let Ok(pull) = self.get(of_tie(Quantity::Tension, tie))
        {
            let pull = self.chained(pull);
            self.say("motion.spring_there", &[("pull", &pull)]);
        }
        let links = if self.m.one { self.links(true, |n, c| n.m.acceleration(c)) } else { self.demands() };
        if let Some(s) = self.spring.clone() {
            // One place on the way, not that at the end.
            let names = if self.symbols.named("s").is_some() { ["s_{x}"] } else { ["s"] };
            let s_now = self.new_symbol(&names, "m");
            let stretch = &s.stretch - s.gamma.times(&Factors::of(&s_now.into())).expr();
            let law = &s.stiffness * stretch;
            let still = self.t.still();
            let law = format!("${} = {}$", self.symbols.tex(s.tension), self.tex(&law));
            if !still {
                self.say("motion.spring", &[("law", &law)]);
            }
        }
        if !links.is_empty() {
            self.say("motion.links", &[("links", &links.join(", "))]);
        }
        if self.short == Short::Neither {
            return self.two_freedoms();
        }
        let gone = if self.m.one { self.elimination().ok() } else { None };
        let Some((gone, last)) = gone else { return self.solved_together(id) };
        let a = self.acceleration();
        let from: Vec<String> = gone
            .iter()
            .map(|g| {
                let n = self.number_of(g.row);
                let is = format!("${} = {}$", self.symbols.tex(g.force), self.tex(&g.is));
                self.phrase("motion.from", &[("n", &n), ("is", &is)])
            })
            .collect();
        let n = self.number_of(last);
        self.gone = gone;
        if !from.is_empty() {
            self.say("motion.eliminate", &[("from", &from.join(", ")), ("n", &n)]);
        }
        let sum_of = self.all_shares();
        let right = Factors::of(&self.effective).times(&Factors::of(&a.into())).expr();
        let line = format!("{} = {}", self.tex(&sum_of), self.tex(&right));
        let value = self.symbols.shown(a);
        let tex = self.symbols.tex(a).to_owned();
        if self.spring.is_none() {
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

    /// What the ties demand of the accelerations.
    fn demands(&self) -> Vec<String> {
        let each = |(tie, _): (usize, SymbolId)| {
            let terms = self.tied(tie).into_iter().filter_map(|(c, share)| {
                let a = self.m.acceleration(c)?;
                Some(share.times(&Factors::of(&a.into())).expr())
            });
            let (left, right): (Vec<Expr>, Vec<Expr>) = terms.partition(|t| !matches!(t, Expr::Minus(_)));
            let right = sum(right.into_iter().map(|t| -t));
            let (left, right) = if left.is_empty() { (right, ZERO) } else { (sum(left), right) };
            format!("${} = {}$", self.tex(&left), self.tex(&right))
        };
        self.reactions().into_iter().map(each).collect()
    }

    /// All equations at once: what comes out.
    fn solved_together(&mut self, id: &str) -> Result<(), DerivationStop> {
        if self.m.one {
            let all: Vec<Label> = self.reactions().iter().map(|(t, _)| self.label_of_tie(*t)).collect();
            for label in all {
                let _ = self.get(label);
            }
        }
        self.tell_frictions();
        self.say("motion.together", &[]);
        let all = [self.accelerations(), self.hidden()].concat();
        let settled: Vec<Option<SymbolId>> =
            all.into_iter().filter(|s| !self.symbols.value(*s).is_nan()).map(Some).collect();
        let later: Vec<SymbolId> = self.steps.iter().map(|s| s.symbol).collect();
        self.skip_new();
        self.forget(&settled);
        self.tell_new();
        if self.short == Short::Together && !self.stays() {
            self.tell_as_known(later.into_iter().filter(|s| settled.contains(&Some(*s))).collect());
            let normals = [self.normals(), self.kinetic_frictions()].concat();
            for symbol in normals {
                self.told(symbol);
            }
            let time = matches!(self.scene.end, End::Time(..));
            self.say(if time { "motion.over_time" } else { "motion.speed_of_slip" }, &[]);
            self.tell_new();
        } else {
            self.integrate(id == "long");
        }
        Ok(())
    }

    /// Energy is one balance for the unknown speeds of several freedoms.
    fn why_together(&mut self) {
        self.begin_as("why", "which");
        let speeds = self.speeds();
        let speeds = self.names(&speeds);
        self.say("why.together", &[("unknown", &speeds)]);
        self.say("why.ask", &[]);
    }

    /// A motion on a spring that ends at a time, at a speed or where it turns.
    fn swings(&mut self) -> Result<(), DerivationStop> {
        self.motion("short")?;
        self.say("motion.swing", &[]);
        let normals = [self.normals(), self.kinetic_frictions()].concat();
        self.tell_as_known(normals);
        self.tell_new();
        self.begin("why");
        let time = matches!(self.scene.end, End::Time(..));
        self.say(if time { "why.swing_time" } else { "why.swing" }, &[]);
        Ok(())
    }

    /// The velocities of an instant, its kinetic energy, and its equations of motion where forces are asked.
    fn instant(&mut self) -> Result<(), DerivationStop> {
        self.begin_as("short", "instant");
        for c in self.coordinates() {
            let _ = self.get(speed_of(c));
        }
        let speeds: Vec<Option<SymbolId>> = self.speeds().into_iter().map(Some).collect();
        self.skip_new();
        self.forget(&speeds);
        self.say("instant.speeds", &[]);
        self.tell_new();
        self.get(of_scene(Quantity::KineticEnergy))?;
        self.say("instant.energy", &[]);
        self.tell_new();
        if self.forces_asked() { self.motion("long") } else { Ok(()) }
    }

    fn all_shares(&self) -> Expr {
        let kinds = [ForceKind::Given, ForceKind::Spring, ForceKind::Kinetic];
        positive_first(self.shares(&kinds).into_iter().map(|(_, e)| e).collect())
    }

    fn say_senses(&mut self) {
        self.say("motion.senses", &[]);
        let slopes = self.scene.bodies.iter().any(|b| b.turns && b.line.is_some());
        if slopes && !self.rolling().is_empty() && self.short != Short::Neither {
            self.say("motion.other_sign", &[]);
        }
    }

    /// All rows with numbers, as many on a line as fit.
    fn write_rows(&mut self) {
        let mut rows: Vec<String> = Vec::new();
        let mut n = 0;
        let mut firsts: Vec<(usize, usize, usize)> = Vec::new();
        for body in 0..self.m.parts.len() {
            let before = n;
            for degree in [Degree::Along, Degree::Turn] {
                let c = Coordinate { body, degree };
                let inertia = self.m.inertia(c);
                let shares: Vec<Expr> = self.row(c).into_iter().map(|(_, e)| e).collect();
                if let Some(a) = self.m.acceleration(c).filter(|_| !inertia.is_empty() || !shares.is_empty())
                {
                    n += 1;
                    let by = Factors::of(&a.into());
                    let right = sum(inertia.iter().map(|i| i.times(&by).expr()));
                    let left = positive_first(shares);
                    rows.push(format!(r"{} = {} \quad ({n})", self.tex(&left), self.tex(&right)));
                    self.rows.push((c, n));
                }
                let across = self.m.parts[body].normal.clone().filter(|_| degree == Degree::Along);
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
        if self.m.parts.len() > 1 {
            let of: Vec<String> = firsts
                .iter()
                .map(|(body, first, last)| {
                    let label = &self.m.parts[*body].label;
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
            ("ds", if self.straight() { r"\mathrm{d}s".to_owned() } else { r"\mathrm{d}\varphi".to_owned() }),
            ("d", self.inline(&self.s)),
            ("vv", format!(r"{0}\,\mathrm{{d}}{0}", self.symbols.tex(v))),
            ("aa", self.symbols.tex(a).to_owned()),
        ];
        let pieces: Vec<(&str, &str)> = pieces.iter().map(|(n, t)| (*n, t.as_str())).collect();
        match self.scene.end {
            End::Time(..) if self.spring.is_some() => {}
            End::Time(..) => {
                self.say("motion.over_time", &pieces);
                // What comes after the acceleration.
                let at = self.steps.iter().position(|s| s.symbol == a).map_or(0, |i| i + 1);
                let known = self.steps[..at].iter().map(|s| s.symbol).collect();
                self.tell_as_known(known);
                self.tell_new();
            }
            End::AtOnce => {}
            _ if self.spring.is_some() => self.say("motion.integral_spring", &pieces),
            _ if again => self.say("motion.integral", &pieces),
            _ => {}
        }
    }

    /// A slipping wheel: each freedom has its own equation.
    fn two_freedoms(&mut self) -> Result<(), DerivationStop> {
        let Some(body) = self.m.parts.iter().position(|p| p.slips) else {
            return Err(Beyond::Unfound.into());
        };
        if self.m.parts.len() > 1 {
            return Err(Beyond::Unfound.into());
        }
        self.tell_frictions();
        let a = self.get(of_body(Quantity::A, body))?;
        let from = self.steps.iter().find(|s| s.symbol == a).map_or(ZERO, |s| s.from.clone());
        let line = self.chain(a, &from).concat();
        let alpha = self.get(of_body(Quantity::Alpha, body))?;
        let from = self.steps.iter().find(|s| s.symbol == alpha).map_or(ZERO, |s| s.from.clone());
        let other = self.chain(alpha, &from).concat();
        self.say("motion.own", &[]);
        if self.detail == Detail::Full || width(&line) + width(&other) > PACKED {
            for l in [line, other] {
                let l = if l.contains('&') { aligned(&l) } else { l };
                self.formula(l);
            }
        } else {
            self.formula(format!(r"{line}, \qquad {other}"));
        }
        let c = self.contact_of(body).and_then(|t| self.m.action_of(t)).map(|x| self.magnitude(&x.arm));
        if let Some(c) = c {
            let share = c.times(&Factors::of(&alpha.into())).per(&Factors::of(&a.into())).expr();
            let share = self.valued(&share, "1");
            self.say("motion.share", &[("share", &share)]);
        }
        self.skip_new();
        let v = self.t.speed_at_end()?;
        if let Some(step) = self.steps.iter().find(|s| s.symbol == v).cloned() {
            if matches!(self.scene.end, End::Travel(..) | End::Position(..)) {
                // v^2 = 2 a d, with the acceleration as it was found.
                let by = in_sense(a.into(), self.value(&a.into()));
                let from = root(Expr::Number(2, 1) * by * self.distance());
                self.say("motion.speed_of_slip", &[]);
                let tex = self.chain(v, &from).concat();
                let tex = if tex.contains('&') { aligned(&tex) } else { tex };
                self.formula(tex);
            } else {
                let displacement = match self.s {
                    Expr::Symbol(s) => Some(s),
                    _ => None,
                };
                self.forget(&[Some(step.symbol), displacement]);
                self.tell_new();
            }
        }
        for quantity in [Quantity::Omega, Quantity::Phi, Quantity::SlipDistance] {
            self.get(of_body(quantity, body))?;
        }
        self.say("motion.spin_of_slip", &[]);
        self.tell_new();
        Ok(())
    }

    /// Energy for a slipping wheel: one equation for two unknowns, and the theorem of the mass centre beside it.
    fn energy_of_slip(&mut self) -> Result<(), DerivationStop> {
        self.begin_as("long", "slip_energy");
        let Some(body) = self.m.parts.iter().position(|p| p.slips) else { return Ok(()) };
        let phi = self.get(of_body(Quantity::Phi, body))?;
        let (part, d) = (self.m.parts[body].clone(), self.distance());
        let (Some(v), Some(w)) = (part.v, part.omega) else { return Ok(()) };
        let half = ratio(1, 2);
        let place = if self.value(&self.s) < 0.0 { -1.0 } else { 1.0 };
        let turn = if self.value(
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
            let row = n.row(Coordinate { body, degree });
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
        let even = self.hidden().is_empty() && self.spring.is_none();
        self.begin_as("why", if even { "which" } else { "why" });
        let (reactions, normals, rubs) = (self.hidden(), self.normals(), self.kinetic_frictions());
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
            let ties = match (!self.rolling().is_empty() || self.held().is_some(), !self.cords().is_empty()) {
                (true, true) => "both",
                (true, false) => "roll",
                (false, true) => "cord",
                (false, false) => "none",
            };
            let ties = self.phrase(&format!("why.ties_{ties}"), &[]);
            let with = [&pieces[..], &[("ties", ties.trim_end())]].concat();
            self.say("why.newton", &with);
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
            if self.asks(Quantity::T) {
                self.say("why.price_time", &[]);
            }
        }
        self.say("why.ask", &[]);
    }

    fn why_not_energy(&mut self) {
        self.begin("why");
        let v = self.speed();
        let s = self.inline(&self.s.clone());
        let v = self.names(&[v]);
        self.say("why.not_energy", &[("v", &v), ("s", &s)]);
        self.say("why.ask", &[]);
    }

    /// Forces that are asked; friction of a rolling body always: in closed form, and why it points as it does.
    fn forces(&mut self) -> Result<(), DerivationStop> {
        self.begin("forces");
        let asked = asked::needed(self.scene, self.problem);
        self.skip_new();
        let rolling = self.rolling();
        for label in asked.iter().filter(|l| matches!(l.quantity, Quantity::A | Quantity::Alpha)) {
            self.get(*label)?;
        }
        let wanted = |q: Quantity| matches!(q, Quantity::Friction | Quantity::Tension | Quantity::Normal);
        for label in asked.iter().filter(|l| wanted(l.quantity)) {
            self.get(*label)?;
        }
        for (_, body) in &rolling {
            let _ = self.get(of_body(Quantity::Friction, *body));
        }
        let kinds = [ForceKind::Spring];
        let sprung = !self.shares(&kinds).is_empty();
        if sprung {
            let at_end = [self.spring.as_ref().map(|s| s.tension), Some(self.acceleration())];
            self.forget(&at_end);
            self.say("forces.spring", &[]);
        } else if self.steps.iter().any(|s| !self.is_told(s.symbol)) {
            let a = self.acceleration();
            let name = if self.short == Short::Energy && self.v0 == ZERO && self.straight() {
                "forces.back"
            } else {
                "forces.rows"
            };
            let v = self.speed();
            let by = square(v) / (Expr::Number(2, 1) * self.distance());
            let place = matches!(self.scene.end, End::Travel(..));
            let name = if place { name } else { "forces.rows" };
            let by = format!("${} = {}$", self.symbols.tex(a), self.tex(&in_sense(by, self.sense)));
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
                let tex =
                    format!("{} = {} = {}", self.symbols.tex(f), self.tex(&whole), self.symbols.shown(f));
                self.formula(tex);
                self.read_signs(body, &closed.terms);
            }
        }
        let sense = self.way(body, value);
        if value != 0.0 {
            let symbol = self.names(&[f]);
            self.say("friction.points", &[("f", &symbol), ("way", &sense)]);
        }
        if let Tie::Roll { mu_s: Some(mu), .. } = self.scene.ties[tie] {
            let mu = self.number(mu, r"\mu_s", "1");
            let n = self.get(of_body(Quantity::Normal, body))?;
            let most = self.valued(&(mu * n), "N");
            let symbol = self.names(&[f]);
            self.say("friction.not_mu", &[("f", &symbol), ("most", &most)]);
        }
        if self.asks(Quantity::KBound) {
            self.skip_new();
            let k0 = self.get(of_body(Quantity::KBound, body))?;
            self.say("friction.bound", &[("way", &up)]);
            self.tell_new();
            let outer = self.scene.bodies[body].radii_m.iter().map(|(_, r)| *r);
            let outer = outer.max_by(|a, b| self.datum(*a).total_cmp(&self.datum(*b)));
            if let Some(r) = outer
                && self.symbols.value(k0) >= self.datum(r)
            {
                let r = self.number(r, "R", "m");
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
            let positive = self.value(&(whole.clone() * self.size(action.force.clone()))) > 0.0;
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
        let place = matches!(self.scene.end, End::Travel(..) | End::Position(..));
        if place && self.asks(Quantity::T) && self.m.one && self.v0 == ZERO && self.spring.is_none() {
            self.say("forces.mean", &[]);
        }
        for label in &asked::needed(self.scene, self.problem) {
            let skip = matches!(label.quantity, Quantity::FrictionIfRolled);
            if label.quantity.is_word() || skip {
                continue;
            }
            let symbol = self.get(*label)?;
            self.draft.answer(*label, DerivedAnswer::Value(symbol));
        }
        self.tell_new();
        Ok(())
    }

    /// Is what was assumed so? And the words that are asked.
    fn holds(&mut self) -> Result<(), DerivationStop> {
        self.begin("holds");
        let lead = self.lead();
        let part = &self.m.parts[lead.body];
        let sloped = matches!(part.path, "incline" | "vertical");
        let up = self.sense * f64::from(part.up) > 0.0;
        let word = match (sloped, up) {
            _ if self.stays() => Word::Stays,
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, true) => Word::Forward,
            (false, false) => Word::Back,
        };
        self.word(Label { quantity: Quantity::Direction, of: Owner::Body(lead.body) }, word);
        self.torn_loose()?;
        let mut taut: Vec<String> = Vec::new();
        for tie in 0..self.scene.ties.len() {
            match self.scene.ties[tie].clone() {
                Tie::Roll { body, mu_s, .. } if self.m.parts[body].normal.is_some() => {
                    self.grips(body, mu_s)?;
                }
                Tie::Slip { body, .. } => self.slides_against(body)?,
                Tie::Cord(c) => match c.to {
                    Far::Body(_) | Far::Fixed => taut.extend(self.taut(tie)?),
                    Far::Spring { rigid: false, .. } => {
                        self.spring_taut(tie)?;
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

    fn word(&mut self, label: Label, word: Word) {
        self.draft.answer(label, DerivedAnswer::Word(word));
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
            if self.m.ratio(along).is_zero() {
                continue;
            }
            let mu = self.number(mu, r"\mu_s", "1");
            let n = self.get(of_body(Quantity::Normal, body))?;
            let given = self.shares(&[ForceKind::Given]).into_iter().map(|(_, e)| e);
            let push = positive_first(vec![in_sense(sum(given), self.sense)]);
            let ratio = self.magnitude(self.m.ratio(along));
            let hold = (mu * n) * ratio.expr();
            let (push, hold) = (self.valued(&push, "N"), self.valued(&hold, "N"));
            self.say("holds.torn", &[("push", &push), ("hold", &hold)]);
        }
        Ok(())
    }

    /// What slides as soon as it moves, and stays.
    fn held_by_friction(&mut self, body: usize, mu: crate::scene::Num) -> Result<(), DerivationStop> {
        let mu = self.number(mu, r"\mu_s", "1");
        let n = self.get(of_body(Quantity::Normal, body))?;
        let Ok(f) = self.get(of_body(Quantity::Friction, body)) else { return Ok(()) };
        let (name, most) = (self.body(body), self.valued(&(mu * n), "N"));
        let f = self.shown(f);
        self.say("holds.held", &[("body", &name), ("f", &f), ("most", &most)]);
        Ok(())
    }

    /// `|F| <= mu_s N` as far as the scene looks.
    fn grips(&mut self, body: usize, mu_s: Option<crate::scene::Num>) -> Result<(), DerivationStop> {
        let n = self.get(of_body(Quantity::Normal, body))?;
        let normal = self.shown(n);
        let Ok(f) = self.get(of_body(Quantity::Friction, body)) else { return Ok(()) };
        let Some(mu) = mu_s else {
            self.say("holds.pressed", &[("n", &normal)]);
            self.say("holds.no_coefficient", &[]);
            return Ok(());
        };
        let mu = self.number(mu, r"\mu_s", "1");
        let most = self.value(&(&mu * n));
        let mut largest = f;
        self.skip_new();
        if self.spring.is_some() {
            let ends = self.extremes(body)?;
            let [a, b] = ends.map(|(_, f)| self.symbols.value(f).abs());
            largest = if a >= b { ends[0].1 } else { ends[1].1 };
            let both: Vec<String> = ends.iter().map(|(_, f)| self.shown(*f)).collect();
            let far = match self.scene.span {
                Span::ToEnd => "end",
                Span::ToTurningPoint => "turn",
            };
            let range = self.phrase(&format!("holds.range.{far}"), &[]);
            self.say("holds.extremes", &[("range", &range), ("one", &both[0]), ("two", &both[1])]);
            self.skip_new();
        }
        let value = self.symbols.value(largest).abs();
        let share = self.relation(&(magnitude(largest) / n), value / self.symbols.value(n), "1");
        let mu = self.valued_plain(&mu);
        self.say("holds.rolls", &[("n", &normal), ("share", &share), ("mu", &mu)]);
        if value > most {
            return Ok(());
        }
        self.word(of_body(Quantity::Rolls, body), Word::Yes);
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
        let a = self.get(of_body(Quantity::A, body))?;
        let alpha = self.get(of_body(Quantity::Alpha, body))?;
        let friction = self.get(of_body(Quantity::Friction, body))?;
        let arm = self.contact_of(body).and_then(|t| self.m.action_of(t)).map(|x| x.arm.clone());
        let Some(arm) = arm else { return Err(Beyond::Unfound.into()) };
        let c = self.magnitude(&arm).expr();
        let contact = a - c * alpha;
        let up = f64::from(self.m.parts[body].up);
        let value = self.value(&contact) * up;
        let friction = self.symbols.value(friction);
        if value * friction >= 0.0 {
            return Ok(());
        }
        let (slides, force) = (self.way(body, value), self.way(body, friction));
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
        let shown = match new.is_empty() {
            true => self.shown(t),
            false => new.iter().map(|s| self.chained(*s)).collect::<Vec<_>>().join(", "),
        };
        Ok((value > 0.0).then_some(shown))
    }

    /// The cord of a spring up to the end: its least tension, and where it goes slack, if that is looked at.
    fn spring_taut(&mut self, tie: usize) -> Result<(), DerivationStop> {
        let (Some(spring), Some(end)) = (self.spring.clone(), self.taut(tie)?) else { return Ok(()) };
        let first = &spring.stiffness * &spring.stretch;
        let least = if self.value(&first) < self.value(&spring.tension.into()) {
            self.valued(&first, "N")
        } else {
            end
        };
        self.say("holds.taut_spring", &[("t", &least)]);
        if self.scene.span == Span::ToTurningPoint
            && let Ok((slack, true)) = self.t.turning_or_slack()
        {
            let size = in_sense(slack.clone(), self.value(&slack));
            let slack = self.valued(&size, "m");
            self.say("holds.goes_slack", &[("s", &slack)]);
        }
        Ok(())
    }

    /// The end lies before the turning point.
    fn reaches(&mut self) -> Result<(), DerivationStop> {
        let lead = self.lead();
        if !matches!(self.scene.end, End::Travel(..) | End::Position(..)) || !self.straight() {
            return Ok(());
        }
        let turns = self.spring.is_some() || self.value(&self.drive) * self.sense < 0.0;
        let level = self.spring.as_ref().is_some_and(|s| !s.rigid) && self.value(&self.drive) == 0.0;
        if !turns || level {
            return Ok(());
        }
        self.skip_new();
        let Ok(turn) = self.get(of_body(Quantity::DTurn, lead.body)) else { return Ok(()) };
        let (d, far) = (self.value(&self.distance()), self.symbols.value(turn));
        if d > far {
            return Ok(());
        }
        let distance = self.inline(&self.distance());
        let shown = self.shown(turn);
        self.skip_new();
        self.say("holds.reaches", &[("d", &distance), ("turn", &shown)]);
        Ok(())
    }

    /// A limit or two, and where the energy went.
    fn limits(&mut self) -> Result<(), DerivationStop> {
        self.begin("limits");
        if self.short == Short::Energy && self.v0 == ZERO && self.spring.is_none() {
            self.massless_limit();
        }
        if self.spring.is_none() && self.v0 == ZERO && self.short == Short::Energy {
            self.balance_limit();
        }
        if self.v0 == ZERO && self.short != Short::Motion {
            self.energies()?;
        }
        if let (Some(spring), true) = (self.spring.clone(), self.m.one) {
            let still = self.get(of_scene(Quantity::XEq)).ok();
            if let Some(x) = still.filter(|_| self.value(&spring.stretch) > 0.0) {
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
            .filter(|c| c.degree == Degree::Turn && !self.m.inertia(*c).is_empty())
            .collect();
        let v = self.speed();
        let lines = self.coordinates().into_iter().filter(|c| c.degree == Degree::Along);
        let masses: Vec<Expr> = lines
            .flat_map(|c| {
                let by = self.m.ratio(c).squared();
                self.m.inertia(c).into_iter().map(move |i| i.times(&by).expr())
            })
            .filter(|e| *e != ZERO)
            .collect();
        if turning.is_empty() || masses.is_empty() || !self.straight() {
            return;
        }
        let drive = positive_first(vec![in_sense(self.drive.clone(), self.sense)]);
        let light = Expr::Number(2, 1) * self.distance() * drive;
        let light = Factors::of(&light).per(&Factors::of(&sum(masses))).expr();
        let fast = self.relation(&root(light.clone()), self.value(&light).sqrt(), "m/s");
        let v = self.shown(v);
        self.say("limits.massless", &[("v", &v), ("fast", &fast)]);
    }

    /// Where the driving force just balances: nothing happens.
    fn balance_limit(&mut self) {
        let pull = self.shares(&[ForceKind::Given]).into_iter().find(|(a, share)| {
            matches!(a.source, ForceSource::Tie(_)) && self.value(share) * self.sense > 0.0
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
        if others.is_empty() || self.value(&needed) <= 0.0 {
            return;
        }
        let force = self.tex(&action.force);
        let digits = tex_digits(&shown::significant(self.value(&needed), FIGURES), self.words);
        let text = format!(r"${force} = {} = {digits}\ {}$", self.tex(&needed), tex_of("N")).replace(
            &format!("${force} ="),
            &format!("${} =", marked(&force, r"\mathrm{0}").replace(r"\mathrm{0}", "0")),
        );
        let force = self.inline(&action.force);
        self.say("limits.balance", &[("force", &force), ("is", &text)]);
    }

    /// Shares of the kinetic energy.
    fn energies(&mut self) -> Result<(), DerivationStop> {
        let turning =
            self.coordinates().into_iter().any(|c| c.degree == Degree::Turn && !self.m.inertia(c).is_empty());
        let moving = self.coordinates().into_iter().any(|c| c.degree == Degree::Along);
        if !turning || !moving || self.value(&self.v) == 0.0 {
            return Ok(());
        }
        self.skip_new();
        let share = self.get(of_scene(Quantity::RotationalFraction))?;
        let percent = shown::significant(100.0 * self.symbols.value(share), 2);
        self.skip_new();
        let percent = tex_digits(&percent, self.words);
        self.say("limits.spin", &[("percent", &percent)]);
        Ok(())
    }

    /// A question to go on with.
    fn onward(&mut self) {
        self.begin("onward");
        let pulled =
            self.scene.ties.iter().any(|t| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_))));
        let wheel = !self.rolling().is_empty() && self.m.parts.len() == 1;
        let pulley = self.m.parts.iter().any(|p| p.a.is_none() && p.alpha.is_some());
        let weighed = self.scene.bodies.iter().all(|b| !matches!(b.mass, Mass::OfParts));
        let name = match () {
            () if self.short == Short::Neither => "onward.slips",
            () if self.spring.is_some() => "onward.spring",
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
