//! Words what is known of bodies that are joined in the plane, in the same sections as every other scene.
use crate::num::shown;
use crate::scene::{Acts, End, JointKind, Label, Mass, Owner, Quantity, RotaryInertia};
use crate::solution::AGREEMENT_REL;
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{Expr, SymbolId, ZERO, number, positive_first, ratio, root, square, sum};
use crate::solution::factors::{Cancel, Sum};
use crate::solution::page::{WITHIN, packed};
use crate::solution::plane::Plane;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::tex_digits;
use crate::solution::text::{Block, LINE};
use crate::solution::written::width;

/// The conditions of the joints are written out where there are no more of them.
const FEW: usize = 4;
/// Displayed lines of a solution at most.
const MOST: usize = 12;

/// Writes the sections.
///
/// # Errors
/// What is not covered, by name.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    let mut n = Joined { t: Plane::new(draft)?, inertia: Sum::default() };
    n.idea();
    n.sketch();
    if n.instant() {
        n.motion("short", "one_motion")?;
        n.forces()?;
        n.t.begin_as("why", "which");
        n.say("joined.why_instant", &[]);
    } else if n.rubs() {
        n.motion("short", "one_motion")?;
        n.integrate_friction()?;
    } else {
        n.energy()?;
        n.motion("long", "long_motion")?;
        n.why();
    }
    if !n.instant() {
        n.forces()?;
    }
    n.rest()?;
    n.holds()?;
    n.limits();
    n.onward();
    Ok(())
}

/// Is a joint of some kind?
type IsKind = fn(&JointKind) -> bool;

struct Joined<'d, 'a> {
    t: Plane<'d, 'a>,
    /// `J` of `1/2 J q'^2`.
    inertia: Sum,
}

impl Joined<'_, '_> {
    fn instant(&self) -> bool {
        self.t.scene.end == End::AtOnce
    }
    fn rubs(&self) -> bool {
        !self.t.frictions.is_empty()
    }
    fn single(&self) -> bool {
        self.t.bodies.len() == 1
    }
    fn say(&mut self, name: &str, pieces: &[(&str, &str)]) {
        self.t.page.say(name, pieces);
    }
    fn joint(&self, is: IsKind) -> bool {
        self.t.scene.joints.iter().any(|j| is(&j.kind))
    }

    fn idea(&mut self) {
        self.t.begin("idea");
        let name = match self.t.scene.end {
            End::AtOnce => "joined.idea_instant",
            _ if self.rubs() => "joined.idea_rubs",
            End::Leaves(_) => "joined.idea_leaves",
            End::Angle(..) => "pinned.idea",
            End::Time(..) => "joined.idea_time",
            _ => "pinned.idea_speed",
        };
        self.say(name, &[]);
        if self.instant() || self.rubs() {
            return;
        }
        self.say("joined.idea_one", &[]);
        let kinds: [(&str, IsKind); 5] = [
            ("pin", |k| matches!(k, JointKind::Pin { .. })),
            ("hinge", |k| matches!(k, JointKind::Hinge { .. })),
            ("across", |k| matches!(k, JointKind::Guide { .. } | JointKind::Contact { rolls: false, .. })),
            ("roll", |k| matches!(k, JointKind::Contact { rolls: true, .. })),
            ("cord", |k| matches!(k, JointKind::Cord { .. })),
        ];
        let kinds: Vec<String> = kinds
            .into_iter()
            .filter(|(_, is)| self.joint(*is))
            .map(|(name, _)| self.t.phrase(&format!("joined.idle_{name}"), &[]))
            .collect();
        self.say("joined.idle", &[("why", &kinds.join("; "))]);
    }

    fn sketch(&mut self) {
        self.t.begin("sketch");
        let mut all = vec![Block::Picture("scene".to_owned())];
        all.extend(self.t.scene.bodies.iter().map(|b| Block::Picture(format!("forces-{}", b.name))));
        self.t.out.blocks = all;
    }

    /// Where the bodies are: what the joints say of their angles, and the place where the motion ends.
    fn places(&mut self) {
        let last = self.t.turns[0].at[1].clone();
        let value = self.t.valued(&last, "1");
        let name = match self.t.scene.end {
            End::Leaves(j) => {
                let force = self.t.of_joint(Quantity::Normal, j);
                let force = force.map_or_else(String::new, |f| self.t.names(&[f]));
                self.say("joined.leaves", &[("force", &force), ("angle", &value)]);
                None
            }
            End::TurningPoint(_) => Some("pinned.angle_turning"),
            End::Speed(..) => Some("pinned.angle_speed"),
            End::Time(..) => Some("joined.angle_time"),
            _ => None,
        };
        if let Some(name) = name {
            self.say(name, &[("angle", &value)]);
        }
        let followers: Vec<(String, Vec<SymbolId>)> = self.t.turns[1..]
            .iter()
            .zip(self.t.followers())
            .map(|(turn, body)| {
                (self.t.bodies[body].name.clone(), turn.at.iter().flat_map(Expr::uses).collect())
            })
            .collect();
        if followers.is_empty() || followers.iter().all(|(_, symbols)| symbols.is_empty()) {
            return;
        }
        let angles: Vec<String> = followers
            .iter()
            .map(|(name, symbols)| {
                let mut symbols = symbols.clone();
                symbols.dedup();
                let list: Vec<String> = symbols.iter().map(|s| self.t.shown(*s)).collect();
                format!("{name} {}", list.join(", "))
            })
            .collect();
        let none = self.t.loops.is_empty();
        self.say(
            if none { "joined.angles_alone" } else { "joined.angles" },
            &[("angles", &angles.join("; "))],
        );
        let loops: Vec<String> = self.t.loops.iter().map(|(_, [a, b])| format!("{a} = {b}")).collect();
        match &loops[..] {
            [one] if width(one) <= WITHIN => self.t.add(format!("${one}$.")),
            _ => self.t.formulas(loops),
        }
    }

    /// The speeds of the mass centres and the inertia of the motion.
    fn kinetic(&mut self) {
        let ratios: Vec<SymbolId> = self.t.steps[..self.t.steps_of[0]].iter().map(|s| s.symbol).collect();
        let rate = self.t.names(&[self.t.rate]);
        if !ratios.is_empty() {
            self.say("joined.ratios", &[("rate", &rate)]);
            self.t.tell(ratios);
        }
        let before = self.t.steps.len();
        let speeds = self.t.speeds();
        self.inertia = self.t.inertia(&speeds);
        let moving: Vec<String> = (0..speeds.len())
            .filter(|b| speeds[*b] != ZERO)
            .map(|b| {
                let is = speeds[b].by(self.t.rate);
                self.t.stated(self.t.bodies[b].v, &is)
            })
            .collect();
        let name = if self.single() { "joined.speed" } else { "joined.speeds" };
        self.say(name, &[("speeds", &moving.join(", "))]);
        let named: Vec<SymbolId> = self.t.steps[before..].iter().map(|s| s.symbol).collect();
        self.t.tell(named);
        let is = self.inertia.expr();
        let plain = self.single() && self.inertia.terms().len() == 1;
        if plain {
            let energy = ratio(1, 2).by(&is).by(square(self.t.rate));
            let energy = self.t.inline(&energy);
            self.say("joined.energy_plain", &[("energy", &energy)]);
        } else {
            let j = self.t.page.find(&["J", r"J_{\mathrm{e}}"], "kg m^2", is.clone());
            let energy = self.t.inline(&(ratio(1, 2).by(j).by(square(self.t.rate))));
            self.say("joined.energy", &[("energy", &energy)]);
            let line = self.t.step_of(j);
            if width(&line) <= WITHIN && !line.contains('&') {
                self.t.add(format!("${line}$."));
                self.t.told(j);
            } else {
                self.t.display(j, &is, "");
            }
            self.t.j = Some(j);
        }
    }

    fn j(&self) -> Expr {
        self.t.j.map_or_else(|| self.inertia.expr(), Expr::from)
    }

    fn energy(&mut self) -> Result<(), DerivationStop> {
        self.t.begin_as("short", "short_energy");
        self.places();
        self.kinetic();
        let [placed, acted] = self.t.steps_of;
        let hidden: Vec<SymbolId> =
            self.t.springs.iter().copied().chain(self.t.units.iter().copied()).collect();
        let needed: Vec<SymbolId> =
            self.t.steps[placed..acted].iter().map(|s| s.symbol).filter(|s| !hidden.contains(s)).collect();
        if !needed.is_empty() {
            self.say(if self.single() { "joined.ways" } else { "joined.ways_sinking" }, &[]);
            // A stretch comes after the lengths that it takes.
            let free = self.t.springs.is_empty();
            let short = |s: &SymbolId| free && width(&self.t.step_of(*s)) <= WITHIN;
            let (short, wide): (Vec<SymbolId>, Vec<SymbolId>) = needed.into_iter().partition(short);
            self.t.tell(short);
            self.t.tell(wide);
        }
        for strut in &self.t.scene.struts {
            match strut.acts {
                Acts::Both => {}
                Acts::Pushes => self.say("joined.only_pushes", &[]),
                Acts::Pulls => self.say("joined.only_pulls", &[]),
            }
        }
        if !self.single() {
            let all = positive_first(self.t.works.clone());
            let work = self.t.page.find(&["W", "A_{W}"], "J", all.clone());
            self.say("joined.work", &[]);
            self.t.display(work, &all, "");
            self.t.works = vec![work.into()];
        }
        self.balance()?;
        self.t.skip_new();
        for label in self.t.labels() {
            if matches!(label.quantity, Quantity::V | Quantity::Omega | Quantity::VX | Quantity::VY) {
                let symbol = self.t.get(label)?;
                self.t.answer(label, DerivedAnswer::Value(symbol));
            }
        }
        self.t.tell_new();
        Ok(())
    }

    /// The balance, and the rate of the leading angle that it gives; where that is given, it gave the place.
    fn balance(&mut self) -> Result<(), DerivationStop> {
        let (rate, from_rest) = (self.t.rate, self.t.first == ZERO);
        let given = match self.t.scene.end {
            End::TurningPoint(_) => Some(ZERO),
            End::Speed(_, w) => {
                let w = self.t.number(w, r"\omega_1", "rad/s");
                Some(w.over(self.t.spin(self.t.lead)))
            }
            _ => None,
        };
        let j = self.j();
        let first = self.first_energy();
        self.say(if from_rest { "energy.from_rest" } else { "energy.moving" }, &[]);
        let works = positive_first(self.t.works.clone());
        let last = if given == Some(ZERO) { ZERO } else { ratio(1, 2).by(&j).by(square(rate)) };
        let right = sum([last, -first.clone()]);
        if let Some(is) = &given {
            self.t.page.step(rate, is.clone());
            // The place is that of the key: there the balance has to hold.
            let (work, gain) = (self.t.value(&works), self.t.value(&right));
            let size = work.abs() + gain.abs() + self.t.value(&first).abs();
            if (work - gain).abs() > f64::max(AGREEMENT_REL * size, self.t.symbols.doubt(rate)) {
                return Err(Beyond::Differs(Quantity::Omega).into());
            }
        }
        let mark = if given.is_some() { r" \quad (\mathrm{E})" } else { "" };
        let line = self.t.equation(&works, &right);
        if self.single() || !from_rest || given.is_some() {
            let lines = format!(r"{} \\ &= {}", self.t.tex(&works), self.t.tex(&right));
            self.t.formula(if width(&line) <= LINE { format!("{line}{mark}") } else { lines });
        }
        if given.is_some() {
            self.t.told(rate);
            return Ok(());
        }
        let twice = Sum::of(self.t.works.iter().flat_map(|w| {
            let terms = if let Expr::Sum(terms) = w { terms.clone() } else { vec![w.clone()] };
            terms.into_iter().map(|w| w.factors().times(number(2))).collect::<Vec<_>>()
        }));
        let twice = twice.expr();
        let is = if from_rest {
            twice.over(&j)
        } else if first == ratio(1, 2).by(&j).by(square(&self.t.first)) {
            square(&self.t.first) + twice.over(&j)
        } else {
            (twice + first.by(number(2))) / j
        };
        let is = root(is);
        self.t.page.step(rate, is.clone());
        if self.t.symbols.value(rate).is_nan() {
            return Err(Beyond::Unfound.into());
        }
        self.t.display(rate, &is, r" \quad (\mathrm{E})");
        Ok(())
    }

    /// Kinetic energy at the start.
    fn first_energy(&mut self) -> Expr {
        if self.t.first == ZERO {
            return ZERO;
        }
        let value = self.t.first_inertia();
        let j = self.j();
        let j = if (self.t.value(&j) - value).abs() <= AGREEMENT_REL * value {
            j
        } else {
            let symbol = self.t.named(&["J_0", "J_a"], "kg m^2");
            self.t.symbols.settle(symbol, value, 0.0);
            let shown = self.t.shown(symbol);
            self.say("joined.first", &[("inertia", &shown)]);
            symbol.into()
        };
        ratio(1, 2).by(&j).by(square(&self.t.first))
    }

    /// The equations of motion at the place that is asked, and what the joints demand.
    fn motion(&mut self, id: &'static str, title: &str) -> Result<(), DerivationStop> {
        self.t.begin_as(id, title);
        if id == "short" {
            self.places();
            let rate = self.t.rate;
            if self.instant() {
                let is = self.t.first.clone();
                let is = if self.t.value(&is) < 0.0 { -is } else { is };
                self.t.page.step(rate, is);
                if self.t.moves {
                    self.t.tell([rate]);
                } else {
                    self.t.told(rate);
                }
            } else {
                let value = self.key_rate();
                self.t.symbols.settle(rate, value, 0.0);
            }
            let ratios: Vec<SymbolId> = self.t.steps[..self.t.steps_of[0]].iter().map(|s| s.symbol).collect();
            if !ratios.is_empty() && self.t.moves {
                let rate = self.t.names(&[self.t.rate]);
                self.say("joined.ratios", &[("rate", &rate)]);
                self.t.tell(ratios);
            }
        }
        self.t.solve()?;
        let late: Vec<SymbolId> = self.t.steps[self.t.steps_of[0]..]
            .iter()
            .map(|s| s.symbol)
            .filter(|s| *s != self.t.rate)
            .collect();
        let mut springs: Vec<SymbolId> = self.t.springs.to_vec();
        springs.extend(self.t.units.iter().copied());
        let wanted: Vec<SymbolId> = if id == "short" { late } else { springs };
        if !wanted.is_empty() {
            let twists = self.t.scene.struts.iter().all(crate::scene::Strut::twists);
            let name = match (self.t.springs.is_empty(), self.t.units.is_empty()) {
                (true, _) => "joined.cord_there",
                (false, true) if twists => "joined.spring_moment",
                (false, true) => "joined.spring_force",
                (false, false) => "joined.spring_there",
            };
            self.say(name, &[]);
            self.t.tell(wanted);
        }
        self.t.skip_new();
        self.say(if self.instant() { "joined.senses" } else { "joined.senses_there" }, &[]);
        let mut rows = Vec::new();
        let mut firsts = Vec::new();
        for body in 0..self.t.bodies.len() {
            let before = rows.len();
            for (left, right) in self.t.equations(body) {
                rows.push(format!(r"{} \quad ({})", self.t.equation(&left, &right), rows.len() + 1));
            }
            firsts.push(format!("{} ({})–({})", self.t.bodies[body].name, before + 1, rows.len()));
        }
        self.t.formulas(rows);
        if !self.single() {
            self.say("motion.of", &[("list", &firsts.join(", "))]);
        }
        let demands = self.t.demands();
        if demands.len() <= FEW {
            self.say("joined.demands", &[]);
            let lines: Vec<String> = demands.iter().map(|(_, l, r)| self.t.equation(l, r)).collect();
            self.t.formulas(lines);
        } else {
            self.say("joined.demands_many", &[("n", &demands.len().to_string())]);
        }
        if id == "long" {
            let (alpha, omega) = self.leading();
            let angle = self.t.letter.clone();
            self.say("joined.integral", &[("alpha", &alpha), ("omega", &omega), ("angle", &angle)]);
        }
        Ok(())
    }

    /// Symbols of the second and first derivative of the leading angle.
    fn leading(&self) -> (String, String) {
        let omega = self.t.symbols.tex(self.t.rate).to_owned();
        let own = self.t.bodies[self.t.lead]
            .alpha
            .filter(|_| self.t.bodies[self.t.lead].omega == Some(self.t.rate));
        let alpha =
            own.map_or_else(|| omega.replace(r"\dot", r"\ddot"), |a| self.t.symbols.tex(a).to_owned());
        (alpha, omega)
    }

    /// The rate of the leading angle that the key has.
    fn key_rate(&self) -> f64 {
        let of = |quantity| self.t.variant.solved.get(Label { quantity, of: Owner::Body(self.t.lead) });
        let spin = self.t.spin(self.t.lead);
        let per = if spin == ZERO { f64::NAN } else { self.t.value(&spin).abs() };
        of(Quantity::Omega).map_or(f64::NAN, |e| e.value() / per)
    }

    fn integrate_friction(&mut self) -> Result<(), DerivationStop> {
        let rate = self.t.rate;
        if self.t.symbols.value(rate).is_nan() {
            return Err(Beyond::Unfound.into());
        }
        self.say("joined.rubs", &[("rate", &self.t.names(&[rate]))]);
        let shown = self.t.shown(rate);
        self.say("joined.rubs_rate", &[("rate", &shown)]);
        self.t.told(rate);
        self.t.begin_as("why", "which");
        let forces = self.t.names(&self.t.reactions());
        self.say("joined.why_rubs", &[("forces", &forces)]);
        Ok(())
    }

    fn why(&mut self) {
        self.t.begin("why");
        let (reactions, accelerations) = (self.t.reactions(), self.t.accelerations());
        let mut rates: Vec<SymbolId> = vec![self.t.rate];
        rates.extend(self.t.bodies.iter().filter_map(|b| b.omega).filter(|o| *o != self.t.rate));
        let speeds: Vec<SymbolId> = self.t.bodies.iter().map(|b| b.v).collect();
        let newton = [reactions.clone(), accelerations, rates.clone()].concat();
        let energy = [speeds, rates].concat();
        let (many, few) = (self.t.names(&newton), self.t.names(&energy));
        let (n, k) = (newton.len().to_string(), energy.len().to_string());
        let ties = self.t.phrase("joined.ties", &[]);
        let forces = if reactions.len() <= FEW {
            self.t.names(&reactions)
        } else {
            self.t.phrase("joined.forces_of_joints", &[])
        };
        self.say("why.newton", &[("many", &many), ("n", &n), ("ties", ties.trim_end())]);
        self.say("why.eliminate", &[("forces", &forces)]);
        self.say("why.energy", &[("few", &few), ("k", &k)]);
        self.say("why.price", &[("forces", &forces)]);
        self.say("why.ask", &[]);
    }

    /// Accelerations and forces: what elimination leaves, and the values.
    fn forces(&mut self) -> Result<(), DerivationStop> {
        use Quantity as Q;
        self.t.begin("forces");
        self.t.skip_new();
        let kinetic = |q: Quantity| {
            matches!(q, Q::Alpha | Q::AX | Q::AY | Q::Normal | Q::Friction | Q::Tension)
                || matches!(q, Q::PinX | Q::PinY | Q::PinForce | Q::Moment | Q::Drive)
        };
        let mut values: Vec<SymbolId> = Vec::new();
        for label in self.t.labels().into_iter().filter(|l| kinetic(l.quantity)) {
            if label.quantity == Q::PinForce {
                // Its components come first.
                for quantity in [Q::PinX, Q::PinY] {
                    let part = self.t.get(Label { quantity, ..label })?;
                    if !values.contains(&part) {
                        values.push(part);
                    }
                }
            }
            let symbol = self.t.get(label)?;
            self.t.answer(label, DerivedAnswer::Value(symbol));
            if !values.contains(&symbol) {
                values.push(symbol);
            }
        }
        if values.is_empty() {
            return Ok(());
        }
        if let Some([power, bend]) = self.t.eliminated() {
            if self.instant() {
                let before = self.t.steps.len();
                let speeds = self.t.speeds();
                self.inertia = self.t.inertia(&speeds);
                let named: Vec<SymbolId> = self.t.steps[before..].iter().map(|s| s.symbol).collect();
                if !named.is_empty() {
                    let speed = self.t.stated(self.t.bodies[0].v, &speeds[0].by(self.t.rate));
                    self.say("joined.speed", &[("speeds", &speed)]);
                    self.t.tell(named);
                }
            }
            let (alpha, _) = self.leading();
            let bend = bend.times(square(self.t.rate)).opposite();
            let right = power.plus(&bend).expr();
            let line = format!(r"{}\,{alpha} = {}", self.factor(&self.inertia.expr()), self.t.tex(&right));
            let fits = width(&line) <= LINE;
            self.say(if fits { "joined.eliminate" } else { "joined.together" }, &[]);
            if fits {
                self.t.formula(line);
            }
        } else {
            self.say("joined.together", &[]);
        }
        // What the equations were solved for besides, where the page has room for it.
        let others = [self.t.accelerations(), self.t.reactions()].concat();
        let known = |s: &SymbolId| !self.t.symbols.value(*s).is_nan() && !values.contains(s);
        let others: Vec<SymbolId> = others.into_iter().filter(known).collect();
        let room = MOST.saturating_sub(self.lines());
        let chains =
            |n: &Self, all: &[SymbolId]| -> Vec<String> { all.iter().map(|s| n.t.step_of(*s)).collect() };
        let all = [values.clone(), others].concat();
        let enough = self.single() && packed(chains(self, &all)).len() <= room;
        let told = chains(self, if enough { &all } else { &values });
        match &told[..] {
            [one] if width(one) <= WITHIN => self.t.add(format!("${one}$.")),
            _ => self.t.formulas(told),
        }
        self.t.skip_new();
        Ok(())
    }
    /// Displayed lines so far.
    fn lines(&self) -> usize {
        let written = self.t.sections.iter().chain([&self.t.out]).flat_map(|s| &s.blocks);
        let lines = written.map(|b| match b {
            Block::Formula(tex) => tex.matches(r" \\ ").count() + 1,
            _ => 0,
        });
        lines.sum()
    }
    /// An expression as a factor.
    fn factor(&self, of: &Expr) -> String {
        let text = self.t.tex(of);
        if matches!(of, Expr::Sum(_)) { format!("({text})") } else { text }
    }

    /// All that is asked and not told yet.
    fn rest(&mut self) -> Result<(), DerivationStop> {
        self.t.begin("rest");
        self.t.skip_new();
        for label in self.t.labels() {
            if label.quantity.is_word() {
                continue;
            }
            if label.quantity == Quantity::T && !matches!(self.t.scene.end, End::Time(..)) {
                self.t.tell_new();
                self.say("joined.time", &[]);
            }
            let symbol = self.t.get(label)?;
            self.t.answer(label, DerivedAnswer::Value(symbol));
        }
        self.t.tell_new();
        Ok(())
    }

    /// Do the contacts press, are the cords taut? Over the whole way as the key has it.
    fn holds(&mut self) -> Result<(), DerivationStop> {
        self.t.begin("holds");
        let scene = self.t.scene;
        let (mut pressed, mut taut) = (Vec::new(), Vec::new());
        for (j, joint) in scene.joints.iter().enumerate() {
            let leaves = matches!(scene.end, End::Leaves(l) if l == j);
            let (quantity, list) = match joint.kind {
                JointKind::Cord { .. } => (Quantity::Tension, &mut taut),
                kind if kind.only_pushes() => (Quantity::Normal, &mut pressed),
                _ => continue,
            };
            let Some(force) = self.t.of_joint(quantity, j) else { continue };
            if leaves {
                // The place is that of the key: there the force has to vanish.
                let weight: f64 = self.t.bodies.iter().map(|b| self.t.value(&b.mass.expr())).sum();
                if self.t.symbols.value(force).abs() > AGREEMENT_REL * 9.81 * weight {
                    return Err(Beyond::Differs(quantity).into());
                }
            } else if !self.t.symbols.value(force).is_nan() {
                list.push(self.t.shown(force));
            }
        }
        for (name, list) in [("joined.presses", pressed), ("joined.taut", taut)] {
            if !list.is_empty() {
                let name = if self.instant() { format!("{name}_at_once") } else { name.to_owned() };
                self.say(&name, &[("force", &list.join(", "))]);
            }
        }
        Ok(())
    }

    fn limits(&mut self) {
        self.t.begin("limits");
        let rotation = self.t.rotation();
        let moving = self.t.moves && self.t.symbols.value(self.t.rate) > 0.0;
        if moving && !self.inertia.is_zero() && !rotation.is_zero() {
            let percent = 100.0 * self.t.value(&rotation.expr()) / self.t.value(&self.inertia.expr());
            let percent = shown::significant(percent, 2);
            self.say("limits.spin", &[("percent", &tex_digits(&percent, self.t.words))]);
            if self.t.first == ZERO && percent != "100" {
                let light = self.t.symbols.value(self.t.rate)
                    / (1.0 - self.t.value(&rotation.expr()) / self.t.value(&self.inertia.expr())).sqrt();
                let unit = "rad/s";
                let fast = shown::significant(light, crate::solution::symbols::FIGURES);
                let unit = crate::solution::draft::tex_of(unit);
                let fast = format!(r"${}\ {unit}$", tex_digits(&fast, self.t.words));
                let shown = self.t.shown(self.t.rate);
                if !matches!(self.t.scene.end, End::Speed(..)) {
                    self.say("joined.massless", &[("fast", &fast), ("rate", &shown)]);
                }
            }
        }
        let scene = self.t.scene;
        let weights = scene.pushes.is_empty() && scene.couples.is_empty() && scene.struts.is_empty();
        let body = &scene.bodies[0];
        let given =
            matches!(body.inertia, Some(RotaryInertia::Moment(_))) || matches!(body.mass, Mass::Weight(_));
        if self.single() && weights && !given {
            self.say("joined.no_mass", &[]);
        }
        self.t.skip_new();
    }

    fn onward(&mut self) {
        self.t.begin("onward");
        let name = match self.t.scene.end {
            End::AtOnce => "joined.onward_instant",
            End::Leaves(_) => "joined.onward_leaves",
            _ if self.rubs() => "joined.onward_rubs",
            _ if !self.t.springs.is_empty() => "joined.onward_spring",
            _ if self.single() => "joined.onward",
            _ => "joined.onward_linkage",
        };
        self.say(name, &[]);
        self.t.end();
    }
}
