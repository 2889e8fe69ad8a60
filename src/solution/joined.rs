//! Words what is known of bodies that are joined in the plane, in the same sections as every other scene.
use crate::num::elliptic;
use crate::scene::{Acts, End, JointKind, Label, Mass, Owner, Quantity, Rest, RotaryInertia, Surface};
use crate::solution::AGREEMENT_REL;
use crate::solution::account::of_body;
use crate::solution::draft::{Detail, is_rate};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, cosine, in_sense, number, positive_first, ratio, root, sine, square, sum,
};
use crate::solution::factors::{Cancel, Sum};
use crate::solution::narrate::Tells;
use crate::solution::page::{Piece, Pieces, WITHIN};
use crate::solution::plane::{END, Pivot, Plane, START};
use crate::solution::stop::{Beyond, DerivationStop, unfound};
use crate::solution::symbols::FIGURES;
use crate::solution::terms::tagged;
use crate::solution::text::{Block, LINE};
use crate::solution::written::width;

/// The conditions of the joints are written out where there are no more of them.
const FEW: usize = 4;
/// Step in degrees in which a way is looked over.
const LOOK: f64 = 0.25;
/// Up to this share numerical derivatives have to give what the equations do.
const DIFFERENCES_REL: f64 = 1e-6;
/// Below this share of the greatest moment on the way the start is almost an equilibrium.
const SLIGHT: f64 = 0.02;
/// Displayed lines of a solution at most.
const MOST: usize = 12;

/// Is a joint of some kind?
type IsKind = fn(&JointKind) -> bool;

/// Is this a force or an acceleration of bodies that are joined?
const fn is_kinetic(q: Quantity) -> bool {
    use Quantity as Q;
    is_rate(q) || matches!(q, Q::AX | Q::AY | Q::Moment | Q::PinRadial | Q::PinTangential | Q::Drive)
}

impl<'d, 'a: 'd> Tells<'d, 'a> for Plane<'d, 'a> {
    fn idea(&mut self) {
        match self.scene.restitution {
            _ if self.blow.is_none() => {}
            _ if !self.impact() => self.say("joined.idea_struck", &[]),
            Some((_, e)) => {
                let e = self.number(e, "e", "1");
                self.say("impact.idea", &[]);
                self.say(if self.entangled() { "impact.idea_each" } else { "impact.idea_free" }, &[]);
                self.say("impact.idea_parts", &[("e", &e)]);
            }
            None => {
                self.say("impact.idea", &[]);
                let names = match self.entangled() {
                    true => ["impact.stays", "impact.idea_each"],
                    false => ["impact.idea_free", "impact.idea_stays"],
                };
                names.into_iter().for_each(|name| self.say(name, &[]));
            }
        }
        let name = match self.scene.end {
            End::AtOnce if self.blow.is_some() => return,
            End::Equilibrium => "joined.idea_rest",
            End::AtOnce => "joined.idea_instant",
            _ if self.in_place() => "joined.idea_in_place",
            _ if self.rubs() => "joined.idea_rubs",
            End::Leaves(_) => "joined.idea_leaves",
            End::Angle(..) => "pinned.idea",
            End::Time(..) => "joined.idea_time",
            End::TurningPoint(_) => "pinned.idea_turning",
            _ => "pinned.idea_speed",
        };
        self.say(name, &[]);
        self.page.say_carried(self.carrier.as_ref());
        if self.scene.is_still() || self.rubs() {
            return;
        }
        if let Some(pivot) = &self.pivot {
            self.page.say("pinned.idea_pin", &[("pin", &pivot.name)]);
            return;
        }
        self.say(if self.scene.drifts().is_some() { "joined.idea_drifts" } else { "joined.idea_one" }, &[]);
        let kinds: [(&str, IsKind); 8] = [
            ("pin", |k| matches!(k, JointKind::Pin { .. })),
            ("hinge", |k| matches!(k, JointKind::Hinge { .. })),
            ("across", |k| matches!(k, JointKind::Guide { .. } | JointKind::Contact { rolls: false, .. })),
            ("roll", |k| matches!(k, JointKind::Contact { rolls: true, teeth: false, .. })),
            ("teeth", |k| matches!(k, JointKind::Contact { teeth: true, .. })),
            ("cord", |k| matches!(k, JointKind::Cord { rod: false, beyond: None, .. })),
            ("cord_over", |k| matches!(k, JointKind::Cord { beyond: Some(_), .. })),
            ("rod", |k| matches!(k, JointKind::Cord { rod: true, .. })),
        ];
        let kinds = kinds.into_iter().filter(|(_, is)| self.joint(*is));
        let kinds = kinds.map(|(name, _)| self.phrase(&format!("joined.idle_{name}"), &[]));
        let kinds: Vec<String> = kinds.collect();
        self.say("joined.idle", &[("why", &kinds.join("; "))]);
    }
    fn ways(&mut self) -> Result<(), DerivationStop> {
        if self.instant() && self.blow.is_some() {
            self.set_off();
            return Ok(());
        }
        if !self.scene.is_still() && !self.in_place() && !self.rubs() {
            let [first, second] = match self.leaves() {
                Some(_) => ["first_energy", "then_motion"],
                None => ["short_energy", "long_motion"],
            };
            self.energy(first)?;
            self.motion("long", second)?;
            self.why();
            return Ok(());
        }
        self.motion("short", if self.still() { "rest_motion" } else { "one_motion" })?;
        let name = match self.driver {
            _ if self.still() => return self.at_rest(),
            _ if self.in_place() => {
                self.turn_steadily()?;
                "joined.why_in_place"
            }
            _ if self.instant() && !self.moves => "joined.why_at_rest",
            Some(_) if self.instant() && self.asks(Quantity::Drive) => "joined.why_driven",
            _ if self.instant() => "joined.why_instant",
            _ => {
                self.integrate_friction()?;
                "joined.why_rubs"
            }
        };
        self.begin_as("why", "which");
        let pieces: Pieces = &[("couple", &Vec::from_iter(self.driver)), ("forces", &self.pressing())];
        self.page.say(name, pieces);
        Ok(())
    }
    fn forces(&mut self) -> Result<(), DerivationStop> {
        if self.pivot.is_some() {
            self.forces_of_the_pin(&is_kinetic)?;
            return self.swings();
        }
        // What turns on the spot has been told with the angular acceleration, on which all else hangs.
        if self.in_place() { Ok(()) } else { self.derive(None) }
    }
    fn asked(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        self.get(label)
    }
    fn before(&mut self, label: Label) {
        if label.quantity == Quantity::T && !self.in_place() && !matches!(self.scene.end, End::Time(..)) {
            self.tell_new();
            self.say("joined.time", &[]);
        }
    }
    fn holds(&mut self) -> Result<(), DerivationStop> {
        if self.pivot.is_some() && !self.scene.is_still() {
            self.gets_there();
        }
        let scene = self.scene;
        let (mut pressed, mut taut, mut limp) = (Vec::new(), Vec::new(), Vec::new());
        for (j, joint) in scene.joints.iter().enumerate() {
            let (quantity, list) = match joint.kind {
                JointKind::Cord { rod: false, .. } => (Quantity::Tension, &mut taut),
                kind if kind.only_pushes() => (Quantity::Normal, &mut pressed),
                _ => continue,
            };
            let Some(force) = self.of_joint(quantity, j) else { continue };
            if self.leaves() == Some(j) {
                // The place is that of the key: there the force has to vanish.
                if self.symbols.value(force).abs() > AGREEMENT_REL * 9.81 * self.mass() {
                    return Err(Beyond::Differs(quantity).into());
                }
            } else if self.symbols.value(force).abs() <= AGREEMENT_REL * 9.81 * self.mass() {
                limp.push(self.shown(force));
            } else if !self.symbols.value(force).is_nan() {
                list.push(self.shown(force));
            }
        }
        if !limp.is_empty() {
            self.say("joined.limp", &[("force", &limp.join(", "))]);
        }
        for (name, list) in [("joined.presses", pressed), ("joined.taut", taut)] {
            if !list.is_empty() {
                let name = if self.scene.is_still() { format!("{name}_at_once") } else { name.to_owned() };
                self.say(&name, &[("force", &list.join(", "))]);
            }
        }
        Ok(())
    }
    fn limits(&mut self) -> Result<(), DerivationStop> {
        self.tell_loss()?;
        let rotation = self.pivot.as_ref().map_or_else(|| self.rotation(), |p| Sum::one(&p.own));
        let moving = self.moves && self.symbols.value(self.rate) > 0.0 && self.carrier.is_none();
        if moving && !self.moving.is_zero() && !rotation.is_zero() {
            let share = self.value(&rotation.expr()) / self.value(&self.moving.expr());
            let several = !self.single();
            self.page.say_share(share, several);
            if self.first == ZERO && self.digits(100.0 * share, 2) != "100" {
                let light = self.symbols.value(self.rate) / (1.0 - share).sqrt();
                let (fast, shown) = (self.rough(light, "rad/s"), self.shown(self.rate));
                if !matches!(self.scene.end, End::Speed(..)) {
                    let name = if several { "joined.massless" } else { "joined.massless_one" };
                    self.say(name, &[("fast", &fast), ("rate", &shown)]);
                }
            }
        }
        let scene = self.scene;
        let weights = scene.pushes.is_empty() && scene.couples.is_empty() && scene.struts.is_empty();
        let body = &scene.bodies[0];
        let given =
            matches!(body.inertia, Some(RotaryInertia::Moment(_))) || matches!(body.mass, Mass::Weight(_));
        if self.single() && weights && !given {
            self.say("joined.no_mass", &[]);
        }
        Ok(())
    }
    fn onward(&self) -> &'static str {
        match self.scene.end {
            End::Equilibrium => "joined.onward_rest",
            End::AtOnce if self.impact() && self.scene.restitution.is_some() => {
                let e = self.scene.restitution.map_or(1.0, |(_, e)| self.datum(e));
                if e == 0.0 { "impact.onward_soft" } else { "impact.onward" }
            }
            _ if self.impact() && self.jolts() && !self.asks_impulses() && !self.entangled() => {
                "impact.onward_stays"
            }
            End::AtOnce if self.impact() => "onward.other",
            End::AtOnce if self.pivot.is_some() && self.jolts() => "pinned.onward_struck",
            End::AtOnce if self.blow.is_some() => "joined.onward_struck",
            End::AtOnce if !self.moves && self.sets_off() => "joined.onward_instant",
            End::Leaves(_) => "joined.onward_leaves",
            _ if self.carried_on() => "onward.other",
            _ if self.in_place() => "joined.onward_in_place",
            _ if self.rubs() && self.first == ZERO => "joined.onward_rubs",
            _ if self.rubs() || self.instant() => "onward.other",
            // Beside other forces a stiffer spring may stop it.
            _ if !self.springs.is_empty() && !self.instant() => match self.works.len() > self.springs.len() {
                true => "joined.onward_spring",
                false => "onward.spring",
            },
            _ if self.pivot.is_some() => "pinned.onward",
            _ if self.single() && self.scene.pushes.iter().any(|p| !p.blow) => "joined.onward_pushed",
            _ if self.single() && self.on_the_floor() => "joined.onward_floor",
            _ if self.single() => "joined.onward",
            _ if self.evenly() => "onward.other",
            _ => "joined.onward_linkage",
        }
    }
}

impl<'d, 'a> Plane<'d, 'a> {
    fn instant(&self) -> bool {
        self.scene.end == End::AtOnce
    }
    fn still(&self) -> bool {
        self.scene.end == End::Equilibrium
    }
    /// Does anything accelerate?
    fn sets_off(&self) -> bool {
        self.accelerations().iter().any(|a| self.symbols.value(*a) != 0.0)
    }
    /// Do all bodies turn in ratios that do not change on the way, as gears and welded rods do?
    fn evenly(&self) -> bool {
        self.turns.iter().all(|turn| {
            let [first, last] = [START, END].map(|at| self.value(&turn.rate[at]));
            (first - last).abs() <= AGREEMENT_REL
        })
    }
    /// The joint whose contact ends the motion.
    pub fn leaves(&self) -> Option<usize> {
        if let End::Leaves(joint) = self.scene.end { Some(joint) } else { None }
    }
    fn rubs(&self) -> bool {
        !self.frictions.is_empty()
    }
    /// Does it rub while it turns on the spot, so that nothing changes?
    fn in_place(&self) -> bool {
        self.scene.spins_in_place() && !self.scene.is_still()
    }
    fn radial(&self) -> bool {
        self.pivot.as_ref().is_some_and(|p| p.radial)
    }
    fn single(&self) -> bool {
        self.bodies.len() == 1
    }
    /// Is nothing but a surface under one of its points there to hold it?
    fn on_the_floor(&self) -> bool {
        let joints = &self.scene.joints;
        joints.len() == 1 && matches!(joints[0].kind, JointKind::Guide { one_sided: true, .. })
    }
    /// Answers what is asked of these quantities.
    fn answers(&mut self, which: &dyn Fn(Quantity) -> bool) -> Result<Vec<Label>, DerivationStop> {
        let all: Vec<Label> = self.needed().into_iter().filter(|l| which(l.quantity)).collect();
        for label in &all {
            let symbol = self.get(*label)?;
            self.answer(*label, symbol);
        }
        Ok(all)
    }
    /// The forces of joints on which friction depends.
    fn pressing(&self) -> Vec<SymbolId> {
        let rubs: Vec<SymbolId> = self.frictions.iter().flat_map(|(.., is)| is.uses()).collect();
        self.reactions().into_iter().filter(|force| rubs.contains(force)).collect()
    }
    /// The sum of all masses.
    fn mass(&self) -> f64 {
        self.bodies.iter().map(|b| self.value(&b.mass.expr())).sum()
    }
    /// Does nothing turn?
    fn points(&self) -> bool {
        self.bodies.iter().all(|b| b.alpha.is_none())
    }
    fn joint(&self, is: IsKind) -> bool {
        self.scene.joints.iter().any(|j| is(&j.kind))
    }

    /// Where the bodies are: what the joints say of their angles, and the place where the motion ends.
    pub fn tell_places(&mut self) {
        let last = self.turns[0].at[1].clone();
        let value = self.valued(&last, "1");
        let name = match self.scene.end {
            _ if self.in_place() => None,
            End::Leaves(j) => {
                let force = Vec::from_iter(self.of_joint(Quantity::Normal, j));
                self.say("joined.leaves", &[("force", &force), ("angle", &last)]);
                None
            }
            End::TurningPoint(_) => Some("pinned.angle_turning"),
            End::Speed(..) => Some("pinned.angle_speed"),
            End::Time(..) => Some("joined.angle_time"),
            End::Equilibrium => Some("joined.angle_rest"),
            _ => None,
        };
        if let Some(name) = name {
            self.say(name, &[("angle", &value)]);
        }
        let lengths = self.lengths();
        if !lengths.is_empty() {
            self.say("joined.lengths", &[]);
            self.tell(lengths);
        }
        let own = |e: &Expr| matches!(e, Expr::Symbol(_)) && !self.turns[0].at.contains(e);
        let angles = (1..self.turns.len()).filter_map(|i| {
            let turn = &self.turns[i];
            let name = match turn.link.map(|(joint, _)| &self.scene.joints[joint]) {
                Some(joint) => self.phrase("joined.link", &[("name", &joint.name)]),
                None if turn.slides => self.bodies.iter().find(|b| b.tag == turn.tag)?.name.clone(),
                None => self.bodies.iter().find(|b| b.turn == Some(i))?.name.clone(),
            };
            let mut symbols: Vec<SymbolId> = turn.at.iter().filter(|e| own(e)).flat_map(Expr::uses).collect();
            symbols.dedup();
            let list: Vec<String> = symbols.iter().map(|s| self.shown(*s)).collect();
            (!symbols.is_empty()).then(|| (turn.slides, format!("{name} {}", list.join(", "))))
        });
        let (slides, angles): (Vec<_>, Vec<_>) = angles.partition(|(slides, _)| *slides);
        let all =
            |list: Vec<(bool, String)>| Vec::from_iter(list.into_iter().map(|(_, told)| told)).join("; ");
        let [slides, angles] = [slides, angles].map(all);
        if !slides.is_empty() {
            self.say("joined.slides", &[("places", &slides)]);
        }
        if !angles.is_empty() {
            let name = if self.loops.is_empty() { "joined.angles_alone" } else { "joined.angles" };
            self.say(name, &[("angles", &angles)]);
        }
        let loops: Vec<String> = self.loops.iter().map(|[a, b]| format!("{a} = {b}")).collect();
        self.formulas_or_one(loops);
    }

    /// Moment of inertia about the pin.
    pub fn about_the_pin(&mut self, pivot: &Pivot) {
        let name = if pivot.own == ZERO { "pinned.inertia_point" } else { "pinned.inertia" };
        self.say(name, &[("pin", &pivot.name)]);
        let square = self.bodies[0].mass.times(pivot.h.squared());
        let (short, whole) = (pivot.own.factors().plus(&square).expr(), self.from(pivot.about));
        let line = self.chain(pivot.about, &whole);
        let gathered = short != whole && !matches!(short, Expr::Sum(_)) && pivot.own != ZERO;
        if gathered && !line.contains('&') && width(&line) < LINE - 20.0 {
            let both = format!(" = {} = ", self.tex(&short));
            self.formula(line.replacen(" = ", &both, 1));
        } else {
            self.display(pivot.about, &whole, "");
        }
        self.moving = Sum::one(pivot.about);
    }

    /// The ratios of the angular velocities.
    fn ratios(&mut self) {
        let placed = self.steps[..self.placed].iter().map(|s| s.symbol);
        let lengths = self.lengths();
        let ratios: Vec<SymbolId> = placed.filter(|s| !lengths.contains(s)).collect();
        if ratios.is_empty() {
            return;
        }
        let rate = self.rate;
        self.say("joined.ratios", &[("rate", &rate)]);
        self.tell(ratios.clone());
        if ratios.iter().any(|s| self.symbols.value(*s) < 0.0) {
            self.say("joined.ratios_signs", &[]);
        }
    }

    /// The speeds of the mass centres and the inertia of the motion.
    fn kinetic(&mut self) {
        if let Some(pivot) = self.pivot.clone() {
            if self.blow.is_none() {
                self.about_the_pin(&pivot);
            }
            return;
        }
        self.ratios();
        let before = self.steps.len();
        let speeds = self.speeds();
        self.moving = self.inertia(&speeds);
        let moving = (0..speeds.len()).filter(|b| speeds[*b] != ZERO);
        let moving = moving.map(|b| self.stated(self.bodies[b].v, &speeds[b].by(self.rate)));
        let mut moving: Vec<String> = moving.collect();
        moving.extend(self.own_spin());
        let named: Vec<SymbolId> = self.steps[before..].iter().map(|s| s.symbol).collect();
        let name = match (self.single(), self.scene.drifts()) {
            (true, Some(_)) => "joined.speed_drifts",
            (true, None) => "joined.speed",
            (false, _) if named.is_empty() => "joined.speeds",
            (false, _) => "joined.speeds_added",
        };
        // A disc that turns about its mass centre moves none.
        if !moving.is_empty() {
            self.say(name, &[("speeds", &moving.join(", "))]);
        }
        self.tell(named);
        let is = self.moving.expr();
        let plain = self.single() && self.moving.terms().len() == 1;
        if plain {
            let energy = ratio(1, 2).by(&is).by(square(self.rate));
            self.say("joined.energy_plain", &[("energy", &energy)]);
        } else {
            let j = self.page.find(&["J", r"J_{\mathrm{e}}"], "kg m^2", is.clone());
            let energy = ratio(1, 2).by(j).by(square(self.rate));
            self.say("joined.energy", &[("energy", &energy)]);
            let line = self.step_of(j);
            self.formulas_or_one(vec![line]);
            self.told(j);
            self.j = Some(j);
        }
    }

    /// The spin of a single body whose leading angle is not its own, as that of a wheel on a circle.
    fn own_spin(&self) -> Option<String> {
        let omega = self.bodies[self.lead].omega.filter(|omega| self.single() && *omega != self.rate)?;
        Some(self.stated(omega, &self.positive(&self.spin(self.lead)).by(self.rate)))
    }

    fn j(&self) -> Expr {
        self.j.map_or_else(|| self.moving.expr(), Expr::from)
    }

    fn energy(&mut self, title: &str) -> Result<(), DerivationStop> {
        self.begin_as("short", title);
        self.tell_places();
        self.kinetic();
        let about = self.pivot.as_ref().map(|p| p.about);
        let hidden = [&self.springs[..], &self.units, &Vec::from_iter(about)].concat();
        let needed = self.steps[self.acted.clone()].iter().map(|s| s.symbol);
        let needed: Vec<SymbolId> = needed.filter(|s| !hidden.contains(s)).collect();
        if !needed.is_empty() {
            let needs = |quantity: fn(&Expr) -> bool| needed.iter().any(|s| quantity(&self.from(*s)));
            let angles = needs(|from| from.uses().len() > 1 && matches!(from, Expr::Quotient(..)));
            let notes = [
                ("joined.in_radians", angles),
                ("joined.of_springs", self.scene.struts.iter().any(|s| !s.twists())),
                ("joined.sinking", needed.iter().any(|s| self.heights.contains(s))),
            ];
            let notes = notes.into_iter().filter(|(_, there)| *there);
            let tag = if self.scene.struts.len() > 1 { ",1" } else { "" };
            let given = self.scene.struts.iter().any(|s| matches!(s.rest, Rest::Stretch(_)));
            let [s, x] = self.letters(tag, given);
            let notes: Vec<String> =
                notes.map(|(note, _)| self.phrase(note, &[("s", &s), ("x", &x)])).collect();
            let notes = if notes.is_empty() { String::new() } else { format!(" ({})", notes.join("; ")) };
            self.say("joined.ways", &[("notes", &notes)]);
            // A stretch comes after the lengths that it takes.
            let free = self.springs.is_empty();
            let short = |s: &SymbolId| free && width(&self.step_of(*s)) <= WITHIN;
            let (short, wide): (Vec<SymbolId>, Vec<SymbolId>) = needed.into_iter().partition(short);
            self.tell(short);
            self.tell(wide);
        }
        for strut in &self.scene.struts {
            match strut.acts {
                Acts::Both => {}
                Acts::Pushes => self.say("joined.only_pushes", &[]),
                Acts::Pulls => self.say("joined.only_pulls", &[]),
            }
        }
        if !self.single() {
            let all = positive_first(self.works.clone());
            let work = self.page.find(&["W", "A_{W}"], "J", all.clone());
            self.say("joined.work", &[]);
            self.display(work, &all, "");
            self.works = vec![work.into()];
        }
        self.balance()?;
        self.skip_new();
        use Quantity::{Omega, V, VX, VY};
        self.answers(&|q| matches!(q, V | Omega | VX | VY))?;
        self.tell_new();
        Ok(())
    }

    /// The balance, and the rate of the leading angle that it gives; where that is given, it gave the place.
    fn balance(&mut self) -> Result<(), DerivationStop> {
        let (rate, from_rest) = (self.rate, self.first == ZERO);
        let given = match self.scene.end {
            End::TurningPoint(_) => Some(ZERO),
            End::Speed(_, w) => {
                let w = self.number(w, r"\omega_1", "rad/s");
                Some(w.over(self.spin(self.lead)))
            }
            _ => None,
        };
        let j = self.j();
        let first = self.first_energy();
        let works = positive_first(self.works.clone());
        let last = if given == Some(ZERO) { ZERO } else { ratio(1, 2).by(&j).by(square(rate)) };
        let same = first == ratio(1, 2).by(&j).by(square(&self.first)) && last != ZERO;
        let right = match same && !from_rest {
            true => ratio(1, 2) * &j * (square(rate) - square(&self.first)),
            false => sum([last, -first.clone()]),
        };
        if let Some(is) = &given {
            self.page.step(rate, is.clone());
            // The place is that of the key: there the balance has to hold.
            let (work, gain) = (self.value(&works), self.value(&right));
            let named = |w: &Expr| if let Expr::Symbol(s) = w { self.from(*s) } else { w.clone() };
            let terms = self.works.iter().flat_map(|w| named(w).terms());
            let size = terms.map(|w| self.value(&w).abs()).sum::<f64>();
            let size = size + gain.abs() + self.value(&first).abs();
            if (work - gain).abs() > f64::max(AGREEMENT_REL * size, self.symbols.doubt(rate)) {
                return Err(Beyond::Differs(Quantity::Omega).into());
            }
        }
        let mark = if given.is_some() { r" \quad (\mathrm{E})" } else { "" };
        if self.single() || !from_rest || given.is_some() {
            self.page.tell_balance(from_rest, [&works, &right], mark);
        } else {
            self.say("energy.from_rest", &[]);
        }
        if given.is_some() {
            self.tell([rate]);
            return Ok(());
        }
        let twice = self.works.iter().flat_map(Expr::terms).map(|w| w.factors().times(number(2)));
        let twice = Sum::of(twice).expr();
        let is = if from_rest {
            twice.over(&j)
        } else if same {
            square(&self.first) + twice.over(&j)
        } else {
            (twice + first.by(number(2))) / j
        };
        let is = root(is);
        self.page.step(rate, is.clone());
        if self.symbols.value(rate).is_nan() {
            return unfound();
        }
        self.display(rate, &is, r" \quad (\mathrm{E})");
        if self.sense < 0.0 {
            self.say("pinned.magnitude", &[("omega", &rate)]);
        }
        Ok(())
    }

    /// Kinetic energy at the start.
    fn first_energy(&mut self) -> Expr {
        if let Some(ratio) = self.spun {
            self.say("joined.first_spin", &[("ratio", &self.shown(ratio))]);
        }
        if self.first == ZERO {
            return ZERO;
        }
        let [_, value, _] = self.balance_after(0.0).unwrap_or([f64::NAN; 3]);
        let j = self.j();
        let j = if (self.value(&j) - value).abs() <= AGREEMENT_REL * value {
            j
        } else {
            let symbol = self.named(&["J_0", "J_a"], "kg m^2");
            self.symbols.settle(symbol, value, 0.0);
            self.say("joined.first", &[("inertia", &self.shown(symbol))]);
            symbol.into()
        };
        ratio(1, 2).by(&j).by(square(&self.first))
    }

    /// The rate of the leading angle right after a blow.
    fn set_off(&mut self) {
        let (rate, is) = (self.rate, self.positive(&self.first));
        if let (Expr::Symbol(own), Some(_)) = (&self.first, &self.pivot) {
            // It bears the symbol of what the blow gives.
            let own = self.page.sized(*own);
            (self.rate, self.bodies[0].omega) = (own, Some(own));
            return;
        }
        // The blow has been told to change what there was.
        let added = matches!(is, Expr::Sum(_));
        self.page.step(rate, is);
        let hangs = |l: &Label| matches!(l.quantity, Quantity::Omega | Quantity::KineticEnergy);
        if added && self.needed().iter().any(hangs) {
            self.say("impact.added", &[]);
            self.tell([rate]);
        }
    }

    /// Equilibrium: no force accelerates anything; and how it swings beside it.
    fn at_rest(&mut self) -> Result<(), DerivationStop> {
        let rows: Vec<(Expr, Expr)> = (0..self.bodies.len()).flat_map(|b| self.equations(b)).collect();
        let left = rows.iter().map(|(left, _)| self.value(left).abs()).fold(0.0, f64::max);
        if !left.le(&(AGREEMENT_REL * 9.81 * self.mass())) {
            return Err(Beyond::Differs(Quantity::Phi).into());
        }
        let small = [Quantity::OmegaSmall, Quantity::PeriodSmall].iter().any(|q| self.asks(*q));
        if !small {
            return Ok(());
        }
        let Some(k) = self.stiffness() else { return Err(Beyond::Mechanism.into()) };
        self.begin("swings");
        self.skip_new();
        self.kinetic();
        // By the moments it has a formula, by the potential energy a number.
        let closed = self.from(k) != Expr::from(k);
        let fits = closed && width(&self.step_of(k)) <= LINE;
        let shown = if fits { self.names(&[k]) } else { self.shown(k) };
        // A slope that is too wide for a line is told by what it is the slope of.
        let name = match (closed, fits || self.pivot.is_none()) {
            (true, true) => "joined.small",
            (true, false) => "joined.small_wide",
            (false, _) => "joined.small_many",
        };
        self.say(name, &[("k", &shown), ("angle", &self.letter.clone())]);
        if fits {
            self.tell([k]);
        }
        self.skip_new();
        self.answers(&|q| matches!(q, Quantity::OmegaSmall | Quantity::PeriodSmall))?;
        self.tell_new();
        Ok(())
    }

    /// The equations of motion at the place that is asked, and what the joints demand.
    fn motion(&mut self, id: &'static str, title: &str) -> Result<(), DerivationStop> {
        self.begin_as(id, title);
        if id == "short" {
            self.tell_places();
            let rate = self.rate;
            if self.instant() {
                let is = in_sense(self.first.clone(), self.value(&self.first));
                self.page.step(rate, is);
                if self.moves {
                    self.tell([rate]);
                } else {
                    self.told(rate);
                }
                if let Some(pivot) = self.pivot.clone() {
                    self.about_the_pin(&pivot);
                }
            } else if self.moves {
                let value = self.key_rate();
                self.symbols.settle(rate, value, 0.0);
            }
            if self.moves {
                self.ratios();
            }
        }
        let before = self.steps.len();
        self.solve()?;
        let sprung = self.tell_springs(id == "short", before);
        self.skip_new();
        let pivot = self.pivot.clone();
        let mut pieces: Vec<(&str, &dyn Piece)> = Vec::new();
        if let Some(Pivot { force: [radial, across], name, .. }) = &pivot {
            pieces = vec![("radial", radial), ("across", across), ("pin", name)];
        }
        // The place has been named with the force of the spring.
        let there = if self.instant() || self.in_place() || sprung { "" } else { "_there" };
        let name = match (pivot.is_some(), self.radial()) {
            (false, _) if self.points() => "joined.point_senses",
            (false, _) => "joined.senses",
            (true, true) => "pinned.senses",
            (true, false) => "pinned.plane_senses",
        };
        self.say(&format!("{name}{there}"), &pieces);
        let each = |b: usize| (self.bodies[b].name.clone(), self.equations(b));
        let all: Vec<_> = (0..self.bodies.len()).map(each).collect();
        self.rows(&all);
        let demands = self.demands();
        let rolls: IsKind = |k| matches!(k, JointKind::Contact { rolls: true, teeth: false, .. });
        let all_roll = self.scene.joints.iter().all(|j| rolls(&j.kind));
        let many = demands.len() > FEW;
        let arc: IsKind = |k| matches!(k, JointKind::Contact { surface: Surface::Arc { .. }, .. });
        let wheel = if self.joint(arc) { "joined.demands_on_arc" } else { "joined.demands_rolling" };
        let other = match self.points() {
            _ if many => Some("joined.demands_many"),
            true => Some("joined.point_demands"),
            false => (!all_roll).then_some("joined.demands"),
        };
        if !demands.is_empty() {
            let wheel = Some(wheel).filter(|_| self.joint(rolls) && !many);
            let n = demands.len().to_string();
            let both = [wheel, other].into_iter().flatten().map(|name| self.phrase(name, &[("n", &n)]));
            let mut both: Vec<String> = both.collect();
            // What leads on to equations stands before them.
            if let [first, _] = &mut both[..] {
                *first = format!("{}.", first.trim_end_matches(':'));
            }
            self.add(both.join(" "));
            if !many || self.detail == Detail::Full {
                self.page.equations(&demands);
            }
        }
        if let Some(joint) = self.leaves() {
            self.where_it_leaves(joint);
        } else if id == "long" {
            let (alpha, omega) = self.leading();
            let own: Pieces = &[("alpha", &alpha), ("omega", &omega), ("angle", &self.letter.clone())];
            let name = if self.radial() { "pinned.integral" } else { "joined.integral" };
            self.say(name, &[own, &pieces].concat());
        }
        Ok(())
    }

    /// The forces of springs and cords at the asked place, alone or with all that they hang on of these first steps. Are there springs?
    fn tell_springs(&mut self, alone: bool, steps: usize) -> bool {
        let about = self.pivot.as_ref().map(|p| p.about);
        // Of what the works take, only what the forces at this place need.
        let springs = [&self.springs[..], &self.units].concat();
        let used = self.behind(springs.clone(), |_| true);
        let own = |s: &SymbolId| *s != self.rate && Some(*s) != about && (self.instant() || used.contains(s));
        let late = self.steps[self.acted.start..steps].iter().map(|s| s.symbol).filter(own).collect();
        let wanted: Vec<SymbolId> = if alone { late } else { springs };
        let sprung = !wanted.is_empty() && !self.springs.is_empty();
        let corded = self.joint(|k| matches!(k, JointKind::Cord { .. }))
            || self.scene.pushes.iter().any(|p| p.toward_m.is_some());
        if !wanted.is_empty() && (corded || !self.springs.is_empty()) {
            let twists = self.scene.struts.iter().all(crate::scene::Strut::twists);
            let name = match (self.springs.is_empty(), self.units.is_empty()) {
                (true, _) if self.joint(|k| matches!(k, JointKind::Cord { rod: true, .. })) => {
                    "joined.rod_there"
                }
                (true, _) => "joined.cord_there",
                (false, true) if twists => "joined.spring_moment",
                (false, true) => "joined.spring_force",
                (false, false) if self.radial() => "pinned.spring_there",
                (false, false) => "joined.spring_there",
            };
            let arm = format!("${}$", self.free(&["p", r"p_{\mathrm{s}}"]));
            self.say(name, &[("arm", &arm)]);
            self.tell(wanted);
        }
        sprung
    }

    /// The place at which a force has fallen to 0, by both methods.
    fn where_it_leaves(&mut self, joint: usize) {
        let force = Vec::from_iter(self.of_joint(Quantity::Normal, joint));
        let (j, rate) = (self.j(), self.rate);
        let found = self.leaving(joint, &j);
        let name = if found.is_some() { "joined.leaves_closed" } else { "joined.leaves_solved" };
        let angle = self.valued(&self.turns[0].at[END], "1");
        self.say(name, &[("force", &force), ("rate", &rate), ("angle", &angle)]);
        let Some([left, right, wave, is]) = found else { return };
        let (line, value) = (self.equation(&left, &right), self.valued(&is, "1"));
        let value = format!("{} = {}", self.tex(&wave), value.trim_matches('$'));
        self.formulas([line, value]);
    }

    /// Symbols of the second and first derivative of the leading angle.
    fn leading(&self) -> (String, String) {
        let omega = self.symbols.tex(self.rate).to_owned();
        let own = self.bodies[self.lead].alpha.filter(|_| self.bodies[self.lead].omega == Some(self.rate));
        let alpha = own.map_or_else(|| omega.replace(r"\dot", r"\ddot"), |a| self.symbols.tex(a).to_owned());
        (alpha, omega)
    }

    /// The rate of the leading angle that the key has.
    fn key_rate(&self) -> f64 {
        let spin = self.spin(self.lead);
        let per = if spin == ZERO { f64::NAN } else { self.value(&spin).abs() };
        self.key(of_body(Quantity::Omega, self.lead)).map_or(f64::NAN, |key| key / per)
    }

    fn integrate_friction(&mut self) -> Result<(), DerivationStop> {
        let rate = self.rate;
        if self.symbols.value(rate).is_nan() {
            return unfound();
        }
        let mu = self.scene.joints.iter().find_map(|joint| joint.kind.mu_k());
        let mu = mu.map_or(ZERO, |mu| self.number(mu, r"\mu_k", "1"));
        self.say("joined.rubs", &[("rate", &rate), ("mu", &self.tex(&mu))]);
        self.say("joined.rubs_rate", &[("rate", &self.shown(rate))]);
        self.told(rate);
        Ok(())
    }

    /// What is asked of forces and accelerations, one after the other from the equations of motion; this one first.
    fn derive(&mut self, first: Option<SymbolId>) -> Result<(), DerivationStop> {
        let asked: Vec<Label> = self.needed().into_iter().filter(|l| is_kinetic(l.quantity)).collect();
        if asked.is_empty() && first.is_none() {
            return Ok(());
        }
        let told = if self.single() { None } else { self.by_rate() };
        let mut values: Vec<SymbolId> = first.into_iter().collect();
        for label in asked {
            // Components come before what they give.
            let composed = matches!(label.quantity, Quantity::PinForce | Quantity::PinAngle);
            let parts = [Quantity::PinX, Quantity::PinY].into_iter().filter(|_| composed);
            for quantity in parts.chain([label.quantity]) {
                let symbol = self.get(Label { quantity, ..label })?;
                self.answer(Label { quantity, ..label }, symbol);
                if !values.contains(&symbol) && told != Some(symbol) {
                    values.push(symbol);
                }
            }
        }
        if values.is_empty() {
            return Ok(());
        }
        let own = if self.single() && !self.still() { self.one_equation() } else { None };
        let known = told.or(own);
        let full = self.detail == Detail::Full;
        let room = if full { usize::MAX } else { MOST.saturating_sub(self.lines()) };
        self.tell_solved(known, &values, room);
        Ok(())
    }

    /// Angle, rate and time of a turn at the angular acceleration that the equations of motion give.
    fn turn_steadily(&mut self) -> Result<(), DerivationStop> {
        let (rate, turned) = (self.rate, self.turned());
        let Some(alpha) = self.bodies[self.lead].alpha else { return unfound() };
        let own: Expr = in_sense(alpha.into(), self.sense);
        let first = in_sense(self.first.clone(), self.value(&self.first));
        let twice = own.by(number(2));
        let gained = |last: &Expr| (square(last) - square(&first)).over(&twice);
        let (last, way) = match self.scene.end {
            End::Time(_, t) => {
                let t = self.number(t, "t", "s");
                (&first + own.by(&t), first.by(&t) + ratio(1, 2).by(&own).by(square(&t)))
            }
            End::Angle(..) => {
                let [from, to] = self.turns[0].at.clone();
                let way = in_sense(to - from, self.sense);
                let way = self.draft.radians(way);
                (root(square(&first) + twice.by(turned)), way)
            }
            End::Speed(_, w) => {
                let last = self.number(w, r"\omega_1", "rad/s");
                (last.clone(), gained(&last))
            }
            _ => (ZERO, gained(&ZERO)),
        };
        if self.pivot.is_none() {
            self.derive(Some(alpha))?;
        }
        self.skip_new();
        self.page.step(turned, way);
        self.page.step(rate, last.clone());
        self.say("joined.in_place", &[("alpha", &self.shown(alpha))]);
        let after = if last == ZERO { Vec::new() } else { vec![rate] };
        self.tell([vec![turned], after].concat());
        if self.asks(Quantity::T) && !matches!(self.scene.end, End::Time(..)) {
            let last: Expr = if last == ZERO { ZERO } else { rate.into() };
            let time = self.page.find(&["t", "t_1"], "s", (last - &first).over(&own));
            self.answer(Label { quantity: Quantity::T, of: Owner::Scene }, time);
            self.tell([time]);
        }
        Ok(())
    }

    fn why(&mut self) {
        if self.leaves().is_some() {
            let rate = self.rate;
            self.begin_as("why", "which");
            self.say("joined.why_leaves", &[("rate", &rate)]);
            return;
        }
        self.begin("why");
        let (reactions, accelerations) = (self.reactions(), self.accelerations());
        // Where the speed at the end is given, the place is asked.
        let given = matches!(self.scene.end, End::Speed(..) | End::TurningPoint(_));
        let place = self.turns[0].at[END].uses();
        let what = place.first().copied().filter(|_| given).unwrap_or(self.rate);
        let mut rates: Vec<SymbolId> = vec![what];
        rates.extend(self.bodies.iter().filter_map(|b| b.omega).filter(|o| *o != self.rate));
        let speeds: Vec<SymbolId> = self.bodies.iter().map(|b| b.v).collect();
        let newton = [reactions.clone(), accelerations, rates.clone()].concat();
        let energy = [speeds, rates].concat();
        if let Some(pivot) = &self.pivot {
            // Moments about the pin ask for none of its forces.
            let (alpha, few) = (self.names(&self.accelerations()), self.names(&[what]));
            let (many, pin) = (format!("{alpha}, {few}"), pivot.force);
            let count: Pieces = &[("n", &"2"), ("many", &many), ("k", &"1"), ("few", &few)];
            let own: Pieces = &[("pin", &pin), ("alpha", &alpha)];
            self.say("pinned.why", &[count, own].concat());
            self.say("why.ask", &[]);
            return;
        }
        let forces = if reactions.len() <= FEW {
            self.names(&reactions)
        } else {
            self.phrase("joined.forces_of_joints", &[])
        };
        let ties = if self.single() && self.own_spin().is_none() { "joined.ties_one" } else { "joined.ties" };
        self.compare(what, [&newton, &energy], &[ties], [&forces; 2]);
    }

    /// What is left when the forces of the joints have been eliminated, of a single body: the angular acceleration that it gives.
    fn one_equation(&mut self) -> Option<SymbolId> {
        let [power, bend] = self.eliminated()?;
        if self.instant() {
            let before = self.steps.len();
            let speeds = self.speeds();
            self.moving = self.inertia(&speeds);
            let named: Vec<SymbolId> = self.steps[before..].iter().map(|s| s.symbol).collect();
            if !named.is_empty() {
                let speed = self.stated(self.bodies[0].v, &speeds[0].by(self.rate));
                self.say("joined.speed", &[("speeds", &speed)]);
                self.tell(named);
            }
        }
        let (alpha, _) = self.leading();
        let bend = bend.times(square(self.rate)).opposite();
        let right = power.plus(&bend).expr();
        let line = format!(r"{}\,{alpha} = {}", self.factor(&self.moving.expr()), self.tex(&right));
        if width(&line) > LINE {
            return None;
        }
        self.say("joined.eliminate", &[]);
        self.formula(line);
        let it = &self.bodies[self.lead];
        it.alpha.filter(|_| it.omega == Some(self.rate))
    }
    /// The leading angular acceleration of several bodies by the rate of the balance.
    fn by_rate(&mut self) -> Option<SymbolId> {
        let (j, letter) = (self.j.filter(|_| !self.scene.is_still())?, self.letter.clone());
        let (lead, rate) = (&self.bodies[self.lead], self.rate);
        let alpha = lead.alpha.filter(|_| lead.omega == Some(rate))?;
        let [force, _, bend] = self.balance_after(self.way())?;
        let [w, g] = [("W", "N m", force), ("J", "kg m^2", 2.0 * bend)].map(|(name, unit, value)| {
            let symbol = self.unknown(&tagged(name, &letter), unit);
            self.symbols.settle(symbol, value, 0.0);
            symbol
        });
        let is = (w - ratio(1, 2) * g * square(rate)) / j;
        let (here, there) = (self.value(&is), self.symbols.value(alpha));
        if !(here - there).abs().le(&(DIFFERENCES_REL * there.abs())) {
            return None;
        }
        let derivatives = [w, g].map(|s| self.shown(s)).join(", ");
        self.say("joined.by_rate", &[("alpha", &alpha), ("derivatives", &derivatives)]);
        self.display(alpha, &is, "");
        Some(alpha)
    }
    /// What the equations of a body on a pin give one after the other, as far as it is asked, and what the signs say.
    fn forces_of_the_pin(&mut self, kinetic: &dyn Fn(Quantity) -> bool) -> Result<(), DerivationStop> {
        let before = self.steps.len();
        let asked = self.answers(kinetic)?;
        let Some(pivot) = self.pivot.clone().filter(|_| !asked.is_empty()) else { return Ok(()) };
        self.skip_new();
        let held = asked.iter().any(|l| l.quantity != Quantity::Alpha);
        let solved = self.accelerations().into_iter().chain(pivot.force.into_iter().filter(|_| held));
        let later: Vec<SymbolId> = self.steps[before..].iter().map(|s| s.symbol).collect();
        self.say("pinned.forces", &[("angle", &self.angle(END))]);
        self.tell(solved.chain(later).collect::<Vec<_>>());
        if held && pivot.radial {
            let signs = [
                ["radial", "pinned.pin_toward", "pinned.pin_outward"],
                ["across", "pinned.pin_with", "pinned.pin_against"],
            ];
            for (symbol, [piece, plus, minus]) in pivot.force.into_iter().zip(signs) {
                let value = self.symbols.value(symbol);
                if value != 0.0 && !value.is_nan() {
                    self.say(if value > 0.0 { plus } else { minus }, &[(piece, &symbol)]);
                }
            }
        }
        Ok(())
    }

    /// Does nothing but its weight act on a body on a pin?
    fn pendulum(&self) -> Option<Pivot> {
        let s = self.scene;
        let alone = s.couples.is_empty() && s.pushes.is_empty() && s.struts.is_empty();
        let alone = alone && s.end != End::Equilibrium;
        self.pivot.clone().filter(|_| alone)
    }

    /// Periods and the greatest speed of a pendulum.
    fn swings(&mut self) -> Result<(), DerivationStop> {
        let all = [Quantity::Period, Quantity::PeriodSmall, Quantity::OmegaSmall, Quantity::OmegaMax];
        let [whole, .., fastest] = all.map(|q| self.asks(q));
        let Some(pivot) = self.pendulum().filter(|_| all.iter().any(|q| self.asks(*q))) else {
            return Ok(());
        };
        self.begin("swings");
        self.skip_new();
        if fastest {
            self.answers(&|q| q == Quantity::OmegaMax)?;
            self.say("pinned.fastest", &[]);
            self.tell_new();
        }
        let frequency = self.get(of_body(Quantity::OmegaSmall, self.lead))?;
        self.answers(&|q| matches!(q, Quantity::OmegaSmall | Quantity::PeriodSmall))?;
        self.say("pinned.small", &[("omega", &self.names(&[frequency]))]);
        self.tell_new();
        if whole {
            self.period(pivot, frequency);
        }
        Ok(())
    }

    /// The real period, by the arithmetic-geometric mean.
    fn period(&mut self, pivot: Pivot, frequency: SymbolId) {
        let t = &mut *self;
        let (first, started) = (t.turns[0].at[START].clone(), t.first != ZERO);
        let half =
            if pivot.up { t.symbols.given(r"180^\circ", 180.0, "180", "", true) - first } else { first };
        let half = half / number(2);
        let amplitude = match started {
            true => root(square(sine(&half)) + square(&t.first / (number(2) * frequency))),
            false => t.positive(&sine(&half)),
        };
        let over = t.value(&amplitude) > 1.0;
        let (names, pi) = ([r"\kappa_c", r"\lambda_c"], Expr::from(t.draft.pi()));
        let (one, rest, turns) = if over {
            let kappa = t.find(&[r"\kappa", r"\lambda"], "1", amplitude);
            (t.symbols.value(kappa), root(square(kappa) - ONE), pi)
        } else {
            let rest = if started { root(ONE - square(&amplitude)) } else { t.positive(&cosine(half)) };
            (1.0, rest, number(2) * pi)
        };
        let rest = t.find(&names, "1", rest);
        t.page.say(if over { "pinned.period_over" } else { "pinned.period" }, &[("rest", &rest)]);
        let first = [one, t.symbols.value(rest)];
        t.tell_new();
        let means = |[a, b]: &[f64; 2]| Some([0.5 * (a + b), (a * b).sqrt()]);
        let printed = std::iter::successors(Some(first), means).skip(1).take(3).map(|pair| {
            let [a, b] = pair.map(|x| t.digits(x, FIGURES));
            format!("${a}$ {} ${b}$", t.words.get("solution.pinned.and"))
        });
        let mut pairs: Vec<String> = printed.collect();
        pairs.dedup();
        t.page.say("pinned.means", &[("pairs", &pairs.join("; "))]);
        let name = t.free(&[r"a_{\infty}", r"b_{\infty}"]);
        let mean = t.symbols.found(&name, elliptic::mean_of(first[0], first[1]), "");
        t.page.say("pinned.mean_found", &[("mean", &t.page.shown(mean))]);
        let period = t.find(&[r"\tau", r"\tau_1"], "s", turns / (frequency * mean));
        let label = of_body(Quantity::Period, t.lead);
        t.answer(label, period);
        t.tell_new();
    }

    /// An angle of the leading body at the start or at the end, with its value.
    fn angle(&self, which: usize) -> String {
        match &self.turns[0].at[which] {
            Expr::Symbol(s) => self.shown(*s),
            _ => format!("${} = 0$", self.letter),
        }
    }

    /// Which way a body on a pin goes, and that it gets there.
    fn gets_there(&mut self) {
        let [start, end] = [START, END].map(|which| self.angle(which));
        let (angle, turns_back) =
            (("angle", &end as &dyn Piece), matches!(self.scene.end, End::TurningPoint(_)));
        // The moments of a spring that only pushes or pulls are those of the asked place alone.
        if self.scene.struts.iter().any(|s| s.acts != Acts::Both) {
            if turns_back {
                self.say("pinned.turns_there", &[angle]);
            }
            return;
        }
        let sense = self.phrase(if self.sense > 0.0 { "pinned.growing" } else { "pinned.falling" }, &[]);
        let [first, last] = self.turns[0].at.each_ref().map(|a| self.value(a));
        // How often the moment changes its sense on the way.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
        let steps = ((last - first).abs() / LOOK).ceil().clamp(1.0, 4000.0) as u32;
        let places: Vec<f64> =
            (0..=steps).map(|i| first + (last - first) * f64::from(i) / f64::from(steps)).collect();
        let moments: Vec<f64> = places.iter().map(|at| self.moment_at(*at)).collect();
        if moments.iter().any(|moment| moment.is_nan()) {
            return;
        }
        let drives: Vec<f64> = moments.iter().map(|moment| moment * self.sense).collect();
        let sizes = drives.iter().fold(0.0f64, |most, d| most.max(d.abs()));
        let name = match self.first == ZERO {
            true if moments[0].abs() <= SLIGHT * sizes => "pinned.set_off_slightly",
            true => "pinned.sets_off",
            false => "pinned.goes_on",
        };
        let moment = self.rough(moments[0], "N m");
        self.say(name, &[("angle", &start), ("moment", &moment), ("sense", &sense)]);
        let turns = drives.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        if turns_back {
            self.say("pinned.turns_there", &[angle]);
        } else if drives.iter().all(|d| *d >= -1e-12 * sizes) {
            self.say("pinned.only_faster", &[angle]);
        } else if turns <= 1 && drives[0] >= 0.0 {
            self.say("pinned.brakes_late", &[angle]);
        } else {
            let about = self.pivot.as_ref().map_or(f64::NAN, |p| self.symbols.value(p.about));
            let (mut square, mut least) = (self.value(&square(&self.first)), f64::INFINITY);
            for (at, moments) in places.windows(2).zip(moments.windows(2)) {
                let middle = self.moment_at(f64::midpoint(at[0], at[1]));
                let mean = (moments[0] + 4.0 * middle + moments[1]) / 6.0;
                square += 2.0 * mean * (at[1] - at[0]).to_radians() / about;
                least = least.min(square);
            }
            self.say("pinned.never_rests", &[angle, ("least", &self.rough(least.sqrt(), "rad/s"))]);
        }
    }

    /// The moment of all forces at this leading angle, degrees.
    fn moment_at(&self, angle: f64) -> f64 {
        let first = self.value(&self.turns[0].at[START]);
        self.balance_after((angle - first).to_radians()).map_or(f64::NAN, |[moment, ..]| moment)
    }

    /// Displayed lines so far.
    fn lines(&self) -> usize {
        let written = self.sections.iter().chain([&self.out]).flat_map(|s| &s.blocks);
        let lines = written.map(|b| match b {
            Block::Formula(tex) => tex.matches(r" \\ ").count() + 1,
            _ => 0,
        });
        lines.sum()
    }
    /// An expression as a factor.
    fn factor(&self, of: &Expr) -> String {
        let text = self.tex(of);
        if matches!(of, Expr::Sum(_)) { format!("({text})") } else { text }
    }
}
