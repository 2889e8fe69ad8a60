//! One method for a scene of lines and axles: what is known so far, and each further quantity on demand, written down as it
//! is found.
use crate::scene::{Coordinate, Degree, End, Far, Label, Num, Owner, Quantity, Span, Start, Tie};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{
    Expr, SymbolId, ZERO, in_sense, magnitude, minus, number, ratio, root, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::linear::mechanism::{Action, ForceKind, ForceSource, Mechanism, tagged};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::text::SolutionSection;
use std::cmp::Ordering;

/// Which method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolvingMethod {
    /// Equations of motion.
    Motion,
    /// Work and energy.
    Energy,
}

/// The spring of a scene.
#[derive(Debug, Clone)]
pub struct CordSpring {
    /// Index of its tie.
    pub tie: usize,
    /// Stiffness.
    pub stiffness: Expr,
    /// Stretch at the start.
    pub stretch: Expr,
    /// Can it push?
    pub rigid: bool,
    /// Travel of the cord's end per unit travel of the lead, against the spring's pull counted negative.
    pub gamma: Factors,
    /// Its force at the end.
    pub tension: SymbolId,
    /// Force at the start, reckoned to the lead.
    pub first: Expr,
    /// Stiffness, reckoned to the lead.
    pub kappa: Expr,
}

/// Friction at one end of a motion on a spring.
#[derive(Debug, Clone)]
pub struct Extreme {
    /// The friction.
    pub friction: Expr,
    /// Which end: a phrase of `extremes.at`.
    pub place: &'static str,
    /// Stretch of the spring there, m.
    pub stretch_m: f64,
}

/// The end at which friction is the larger, and whether the spring pulls more there; `None` where it is equally large at both.
pub fn larger(task: &LinearDerivation, ends: &[Extreme; 2]) -> Option<(Extreme, bool)> {
    let [a, b] = ends.each_ref().map(|e| task.value(&e.friction).abs());
    let [one, other] = ends;
    let (most, least) = if a > b { (one, other) } else { (other, one) };
    let equal = (a - b).abs() <= EQUAL * a.max(b);
    (!equal).then(|| (most.clone(), most.stretch_m > least.stretch_m))
}

/// Two values are equal that differ by less than this share: rounding of doubles.
const EQUAL: f64 = 1e-12;

/// Stretch, as a share of the first, below which rounding alone keeps a cord from being slack.
const SLACK: f64 = 1e-12;

/// The derivation by one method.
pub struct LinearDerivation<'d, 'a> {
    /// The draft.
    pub draft: &'d mut Draft<'a>,
    /// The mechanism, with unknowns of its own.
    pub m: Mechanism,
    /// Which method.
    pub method: SolvingMethod,
    /// What is being written.
    pub out: SolutionSection,
    /// What has been found.
    pub known: Vec<(Label, SymbolId)>,
    /// The works that the energy method has written down.
    pub works: Vec<(ForceSource, ForceKind, SymbolId)>,
    /// Number of the equation of each coordinate.
    pub rows: Vec<(Coordinate, usize)>,
    /// Sense in which the lead moves: 1 or -1.
    pub sense: f64,
    /// Velocity of the lead at the start, signed; 0 at rest.
    pub v0: Expr,
    /// Displacement of the lead at the end, signed.
    pub s: Expr,
    /// Speed of the lead at the end.
    pub v: Expr,
    /// What the lead accelerates: effective mass or moment of inertia.
    pub effective: Expr,
    /// Sum of the constant forces, reckoned to the lead.
    pub drive: Expr,
    /// The spring.
    pub spring: Option<CordSpring>,
    /// Is a slipping wheel taken as if it rolled?
    pub rolled: bool,
    /// The ties whose reactions are being solved for, each for the one before it.
    solving: Vec<usize>,
}

/// A body's label.
pub fn of_body(quantity: Quantity, body: usize) -> Label {
    Label { quantity, of: Owner::Body(body) }
}

/// A tie's label.
pub fn of_tie(quantity: Quantity, tie: usize) -> Label {
    Label { quantity, of: Owner::Tie(tie) }
}

/// A label of the whole scene.
pub const fn of_scene(quantity: Quantity) -> Label {
    Label { quantity, of: Owner::Scene }
}

impl<'d, 'a> LinearDerivation<'d, 'a> {
    /// Sets out: mechanism, senses, start. `slips`: each slipping contact with the sense of its friction, positive up.
    ///
    /// # Errors
    /// What the derivation does not cover.
    pub fn new(
        draft: &'d mut Draft<'a>,
        method: SolvingMethod,
        rolled: bool,
        slips: &[(usize, f64)],
        out: SolutionSection,
    ) -> Result<Self, DerivationStop> {
        let m = Mechanism::new(draft, rolled)?;
        let scene = draft.scene;
        let mut spring = None;
        if let Some((tie, ks, x0, rigid)) = scene.spring() {
            let stiffness = draft.number(ks, "k_s", "N/m");
            let stretch = draft.number(x0, "x_0", "m");
            let (Some(action), Some(tension)) = (m.action_of(tie), m.force_of(tie)) else {
                return Err(Beyond::Arrangement.into());
            };
            let gamma = m.point(action);
            let kappa = Factors::of(&stiffness).times(&gamma.squared()).expr();
            spring = Some(CordSpring { tie, stiffness, stretch, rigid, gamma, tension, first: ZERO, kappa });
        }
        let mut task = Self {
            draft,
            m,
            method,
            out,
            known: Vec::new(),
            works: Vec::new(),
            rows: Vec::new(),
            sense: 1.0,
            v0: ZERO,
            s: ZERO,
            v: ZERO,
            effective: ZERO,
            drive: ZERO,
            spring,
            rolled,
            solving: Vec::new(),
        };
        task.effective = task.m.effective(task.draft);
        task.set_out(slips)?;
        Ok(task)
    }

    /// A phrase of this topic.
    pub fn phrase(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        self.draft.say(&format!("solution.{name}"), pieces)
    }

    /// Writes a phrase as a paragraph.
    pub fn tell(&mut self, name: &str, pieces: &[(&str, &str)]) {
        let text = self.phrase(name, pieces);
        self.out.say(text);
    }

    /// The phrase that the method has for this.
    pub fn tell_method(&mut self, name: &str, pieces: &[(&str, &str)]) {
        let method = if self.method == SolvingMethod::Motion { "motion" } else { "energy" };
        self.tell(&format!("{method}.{name}"), pieces);
    }

    /// An expression in symbols, with dollars.
    pub fn tex(&self, e: &Expr) -> String {
        format!("${}$", e.symbols(&self.draft.symbols))
    }

    /// Value of an expression.
    pub fn value(&self, e: &Expr) -> f64 {
        e.value(&self.draft.symbols)
    }

    /// Finds a quantity and writes the steps.
    pub fn find(&mut self, symbol: SymbolId, from: &Expr) {
        self.out.find(&mut self.draft.symbols, symbol, from);
    }

    /// Finds several quantities, each with its steps, without words between.
    pub fn new_symbol(&mut self, names: &[&str], unit: &str) -> SymbolId {
        let tex = self.draft.free(names);
        let tex = if self.rolled { marked(&tex, r"\mathrm{r}") } else { tex };
        self.draft.unknown(&tex, unit)
    }

    /// Magnitude of a quantity: itself where it is positive.
    pub fn size(&self, of: Expr) -> Expr {
        if self.value(&of) < 0.0 { magnitude(of) } else { of }
    }

    /// The name of a body in brackets, with a space before; nothing where it is the only one.
    pub fn in_brackets(&self, body: usize) -> String {
        if self.m.parts.len() < 2 { String::new() } else { format!(" ({})", self.m.parts[body].label) }
    }

    /// It stops here: beyond what is covered.
    pub fn beyond<T>(&self, what: Beyond) -> Result<T, DerivationStop> {
        Err(what.into())
    }

    fn start_velocity(&mut self) -> Result<Expr, DerivationStop> {
        let mut v0 = ZERO;
        for start in &self.draft.scene.start {
            let Start::Speed(c, num) = start else { return self.beyond(Beyond::Arrangement) };
            let given =
                self.draft.number(*num, if c.degree == Degree::Along { "v_0" } else { r"\omega_0" }, "m/s");
            if given == ZERO {
                continue;
            }
            let ratio = self.m.ratio(*c).clone();
            if ratio.is_zero() || v0 != ZERO {
                return self.beyond(Beyond::SeveralSpeeds);
            }
            v0 = Factors::of(&given).per(&ratio).expr();
        }
        Ok(v0)
    }

    /// Sense of the motion, kinetic friction with its sign, displacement at the end as far as it is told.
    fn set_out(&mut self, slips: &[(usize, f64)]) -> Result<(), DerivationStop> {
        self.v0 = self.start_velocity()?;
        let scene = self.draft.scene;
        // Without sliding friction first: it needs the sense.
        let push: f64 = self
            .terms()
            .iter()
            .map(|(a, e)| match a.kind {
                ForceKind::Given => self.value(e),
                _ => 0.0,
            })
            .sum();
        let push = match &self.spring {
            Some(s) => {
                let per = self.value(&s.gamma.expr());
                push + per * self.value(&s.stiffness) * self.value(&s.stretch)
            }
            None => push,
        };
        let given = self.terms().into_iter().filter(|(a, _)| a.kind == ForceKind::Given).map(|(_, e)| e);
        let given: Vec<Expr> = given.collect();
        if let Some(s) = &mut self.spring {
            let pull = Factors::of(&s.stiffness).times(&s.gamma).times(&Factors::of(&s.stretch)).expr();
            s.first = sum([pull].into_iter().chain(given));
        }
        let v0 = self.value(&self.v0);
        let slipping = scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. })) && !self.rolled;
        self.sense = if v0 != 0.0 { v0.signum() } else { push.signum() };
        if slipping && v0 == 0.0 {
            // A couple has no share in the path of a centre that slips: friction alone may drive it.
            let rubbed: f64 = slips.iter().map(|(tie, sense)| sense * self.friction_of_slip(*tie)).sum();
            self.sense = (push + rubbed).signum();
        }
        if push == 0.0 && v0 == 0.0 && !slipping {
            return self.beyond(Beyond::NothingMoves);
        }
        if slipping && (v0 != 0.0 || self.spring.is_some()) {
            return self.beyond(Beyond::SlipWithSpeed);
        }
        self.s = match scene.end {
            End::Travel(_, d) => {
                let d = self.length(d);
                in_sense(d, self.sense)
            }
            End::Position(_, x) => self.length(x),
            _ => ZERO,
        };
        Ok(())
    }

    /// Share of the friction of a slipping contact in the equation of the lead, N, if it points up.
    fn friction_of_slip(&mut self, tie: usize) -> f64 {
        let Tie::Slip { body, mu_k, .. } = self.draft.scene.ties[tie] else { return 0.0 };
        let mu = self.draft.number(mu_k, r"\mu_k", "1");
        let mut own = self.m.actions.iter().filter(|a| a.contact && a.source == ForceSource::Tie(tie));
        match (own.next(), &self.m.parts[body].normal) {
            (Some(action), Some((_, normal))) => {
                self.value(&self.m.point(action).expr()) * self.value(&mu) * self.value(normal)
            }
            _ => 0.0,
        }
    }

    fn length(&mut self, num: Num) -> Expr {
        let unit = if self.m.lead.degree == Degree::Along { "m" } else { "rad" };
        self.draft.number(num, "d", unit)
    }

    /// Sets the size and sign of kinetic friction, positive up: of a slide against the motion, of a slip as `slip_sense` says.
    pub fn kinetic(&mut self, slip_sense: &dyn Fn(usize) -> f64) -> Vec<(usize, SymbolId, Expr, f64)> {
        let scene = self.draft.scene;
        let mut all = Vec::new();
        for (t, tie) in scene.ties.iter().enumerate() {
            let (body, mu, sense) = match tie {
                Tie::Slip { body, mu_k, .. } if !self.rolled => (*body, *mu_k, slip_sense(t)),
                Tie::Slide { body, mu_k, .. } => {
                    let velocity = self.value(&self.m.parts[*body].along.expr()) * self.sense;
                    (*body, *mu_k, -velocity.signum() * f64::from(self.m.parts[*body].up))
                }
                _ => continue,
            };
            let mu = self.draft.number(mu, r"\mu_k", "1");
            if let (Some(f), Some((n, _))) = (self.m.force_of(t), self.m.parts[body].normal.clone()) {
                all.push((t, f, in_sense(mu * n, sense), sense));
            }
        }
        all
    }

    /// The forces that do not drop out of the sum, each as its share of the lead's equation.
    pub fn terms(&self) -> Vec<(Action, Expr)> {
        let mut list: Vec<(Action, Factors)> = Vec::new();
        for action in self.m.actions.iter().filter(|a| a.kind != ForceKind::Reaction) {
            let share = Factors::of(&action.force).times(&self.m.point(action));
            if !share.is_zero() {
                list.push((action.clone(), share));
            }
        }
        list.sort_by_key(|(a, share)| (negative(share), rank(a)));
        list.into_iter().map(|(a, share)| (a, share.expr())).collect()
    }

    /// Forces or moments in the equation of a coordinate.
    pub fn row(&self, c: Coordinate) -> Vec<(Action, Expr)> {
        let mut list: Vec<(Action, Factors)> = Vec::new();
        for action in self.m.actions.iter().filter(|a| a.body == c.body) {
            let share = Factors::of(&action.force).times(self.m.lever(action, c));
            if !share.is_zero() {
                list.push((action.clone(), share));
            }
        }
        list.sort_by_key(|(a, share)| (negative(share), rank(a)));
        list.into_iter().map(|(a, share)| (a, share.expr())).collect()
    }

    /// The lead.
    pub fn lead(&self) -> Coordinate {
        self.m.lead
    }

    /// Magnitude of a ratio.
    pub fn magnitude(&self, ratio: &Factors) -> Factors {
        let size = if self.value(&ratio.expr()) < 0.0 { ratio.opposite() } else { ratio.clone() };
        size.upright(&self.draft.symbols)
    }

    /// Distance that the lead goes, a magnitude.
    pub fn distance(&self) -> Expr {
        in_sense(self.s.clone(), if self.value(&self.s) < 0.0 { -1.0 } else { 1.0 })
    }

    /// Is the freedom of this coordinate its own: the spin of a slipping body?
    pub fn own(&self, c: Coordinate) -> bool {
        c.degree == Degree::Turn && self.m.parts[c.body].slips
    }

    /// What was found for a label.
    pub fn found(&self, label: Label) -> Option<SymbolId> {
        self.known.iter().find(|(l, _)| *l == label).map(|(_, s)| *s)
    }

    /// Notes that a label has been found.
    pub fn note(&mut self, label: Label, symbol: SymbolId) {
        if self.found(label).is_none() {
            self.known.push((label, symbol));
        }
    }

    fn found_now(&mut self, label: Label, symbol: SymbolId, from: &Expr) -> SymbolId {
        self.find(symbol, from);
        self.note(label, symbol);
        symbol
    }

    /// A quantity: looked up, or derived and written down.
    ///
    /// # Errors
    /// What the derivation does not cover.
    pub fn get(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some(symbol) = self.found(label) {
            return Ok(symbol);
        }
        let body = match label.of {
            Owner::Body(b) => b,
            _ => self.m.lead.body,
        };
        let along = Coordinate { body, degree: Degree::Along };
        let turn = Coordinate { body, degree: Degree::Turn };
        match label.quantity {
            Quantity::A => self.acceleration(along, label),
            Quantity::Alpha => self.acceleration(turn, label),
            Quantity::V => self.speed(along, label),
            Quantity::Omega => self.speed(turn, label),
            Quantity::Phi => self.angle(body, label),
            Quantity::Displacement => {
                let symbol = self.new_symbol(&[r"\Delta x"], "m");
                let from = Factors::of(&self.s).times(&self.m.parts[body].along).expr();
                Ok(self.found_now(label, symbol, &from))
            }
            Quantity::Rise => self.rise(body, label),
            Quantity::Normal => self.normal(body, label),
            Quantity::Friction => self.friction(body, label),
            Quantity::Tension => match label.of {
                Owner::Tie(t) => self.tension(t, label),
                _ => self.beyond(Beyond::Arrangement),
            },
            Quantity::MuRequired => self.least_grip(body, label),
            Quantity::T => self.time(label),
            Quantity::CordTravel => self.cord_travel(label),
            Quantity::WorkPull => self.work_of_pull(label),
            Quantity::PowerPull => self.power_of_pull(label),
            Quantity::KineticEnergy => self.kinetic_energy(label),
            Quantity::RotationalFraction => self.rotational(label),
            Quantity::SlipDistance => self.slip_distance(body, label),
            Quantity::Heat => self.heat(label),
            Quantity::KBound => self.bound_of_gyration(body, label),
            Quantity::XEq => self.equilibrium(label),
            Quantity::VMax | Quantity::DAtVMax => self.fastest(label),
            Quantity::DTurn => self.turning(label),
            other => self.beyond(Beyond::Quantity(other)),
        }
    }

    /// Another acceleration than the lead's, by its ratio; that of a slipping body's spin from its own equation.
    fn acceleration(&mut self, c: Coordinate, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some(symbol) = self.m.acceleration(c) else { return self.beyond(Beyond::Arrangement) };
        if self.own(c) {
            self.friction(c.body, of_body(Quantity::Friction, c.body))?;
            let over = sum(self.row(c).into_iter().map(|(_, e)| e));
            if self.method == SolvingMethod::Motion {
                let n = self.number_of(c);
                self.tell("motion.spin_apart", &[("n", &n)]);
                let from = over / self.m.inertia_expr(c);
                return Ok(self.found_now(label, symbol, &from));
            }
            // The square of the spin grows with the angle as that of the speed with the way.
            let omega = self.get(of_body(Quantity::Omega, c.body))?;
            let phi = self.get(of_body(Quantity::Phi, c.body))?;
            let sense = self.spin_sense(c.body);
            let from = in_sense(square(omega) / (number(2) * phi), sense);
            self.tell("energy.rate_spin", &[]);
            return Ok(self.found_now(label, symbol, &from));
        }
        if c == self.lead() {
            return self.lead_acceleration(label, symbol);
        }
        let lead = self.get(self.label_of_lead(Quantity::A, Quantity::Alpha))?;
        let from = Factors::of(&lead.into()).times(self.m.ratio(c)).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    /// The label of the lead: this for a line, that for a turn.
    pub fn label_of_lead(&self, along: Quantity, turn: Quantity) -> Label {
        let c = self.lead();
        of_body(if c.degree == Degree::Along { along } else { turn }, c.body)
    }

    /// By the energy method: from the rate of the balance.
    fn lead_acceleration(&mut self, label: Label, symbol: SymbolId) -> Result<SymbolId, DerivationStop> {
        if self.method == SolvingMethod::Motion {
            return self.beyond(Beyond::Arrangement);
        }
        let from = match self.spring.clone() {
            None if self.value(&self.s) != 0.0 => {
                self.tell("energy.rate_constant", &[]);
                let gained = square(&self.v) - square(&self.v0);
                gained / (number(2) * &self.s)
            }
            None => {
                self.tell("energy.rate", &[]);
                &self.drive / &self.effective
            }
            Some(spring) => {
                self.tell("energy.rate_spring", &[]);
                self.tension(spring.tie, of_tie(Quantity::Tension, spring.tie))?;
                let terms = self.terms().into_iter().map(|(_, e)| e);
                sum(terms.collect::<Vec<_>>()) / &self.effective
            }
        };
        Ok(self.found_now(label, symbol, &from))
    }

    fn speed(&mut self, c: Coordinate, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some(symbol) = self.m.speed(c) else { return self.beyond(Beyond::Arrangement) };
        if self.own(c) {
            return self.own_spin(c, label, symbol);
        }
        let ratio = self.magnitude(self.m.ratio(c));
        let from = Factors::of(&self.v).times(&ratio).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    /// Sense in which a body turns.
    fn spin_sense(&self, body: usize) -> f64 {
        let c = Coordinate { body, degree: Degree::Turn };
        let over = sum(self.row(c).into_iter().map(|(_, e)| e));
        if self.value(&over) < 0.0 { -1.0 } else { 1.0 }
    }

    /// Spin of a slipping body.
    fn own_spin(
        &mut self,
        c: Coordinate,
        label: Label,
        symbol: SymbolId,
    ) -> Result<SymbolId, DerivationStop> {
        let own = self.m.parts[c.body].clone();
        let Some(v) = own.v else { return self.beyond(Beyond::Arrangement) };
        let v = self.found(of_body(Quantity::V, c.body)).unwrap_or(v);
        match self.method {
            SolvingMethod::Motion => {
                let alpha = self.get(of_body(Quantity::Alpha, c.body))?;
                let a = self.get(of_body(Quantity::A, c.body))?;
                self.tell("motion.spin_ratio", &[]);
                let turned = self.value(&alpha.into()) * self.value(&a.into());
                let from = in_sense(alpha / a * v, turned);
                Ok(self.found_now(label, symbol, &from))
            }
            SolvingMethod::Energy => self.beyond(Beyond::Arrangement),
        }
    }

    fn angle(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let tag = if self.draft.scene.bodies.iter().filter(|b| b.turns).count() > 1 {
            self.m.parts[body].tag.clone()
        } else {
            String::new()
        };
        let symbol = self.new_symbol(&[&tagged(r"\varphi", &tag), &tagged(r"\psi", &tag)], "rad");
        let c = Coordinate { body, degree: Degree::Turn };
        if self.own(c) {
            let ratio = match self.method {
                SolvingMethod::Motion => {
                    let alpha = self.get(of_body(Quantity::Alpha, body))?;
                    let a = self.get(of_body(Quantity::A, body))?;
                    let sense = self.value(&alpha.into()) * self.value(&a.into());
                    in_sense(alpha / a, sense)
                }
                SolvingMethod::Energy => {
                    let omega = self.get(of_body(Quantity::Omega, body))?;
                    let v = self.get(of_body(Quantity::V, body))?;
                    omega / v
                }
            };
            let way = Factors::of(&self.distance()).times(&self.magnitude(&self.m.parts[body].along)).expr();
            return Ok(self.found_now(label, symbol, &(ratio * way)));
        }
        let ratio = self.magnitude(&self.m.parts[body].turn);
        let from = Factors::of(&self.distance()).times(&ratio).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    fn rise(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let tag = if self.m.parts.iter().filter(|p| p.a.is_some()).count() > 1 {
            self.m.parts[body].tag.clone()
        } else {
            String::new()
        };
        let symbol = self.new_symbol(&[&tagged("h", &tag), &tagged("y", &tag)], "m");
        let climb = self.m.actions.iter().find(|a| a.source == ForceSource::Weight(body));
        let climb = climb.map_or_else(Factors::zero, |a| a.along.opposite());
        let from = Factors::of(&self.s).times(&self.m.parts[body].along).times(&climb).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    fn normal(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some((symbol, from)) = self.m.parts[body].normal.clone() else {
            return self.beyond(Beyond::Arrangement);
        };
        if self.method == SolvingMethod::Energy {
            self.tell("energy.normal", &[]);
        }
        Ok(self.found_now(label, symbol, &from))
    }

    /// Number of a row, as it stands in the text.
    pub fn number_of(&self, c: Coordinate) -> String {
        self.rows.iter().find(|(r, _)| *r == c).map_or_else(|| "?".to_owned(), |(_, n)| n.to_string())
    }

    fn friction(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let tie = self.draft.scene.ties.iter().position(|t| match t {
            Tie::Roll { body: b, .. } | Tie::Slip { body: b, .. } | Tie::Slide { body: b, .. } => *b == body,
            Tie::Cord(_) => false,
        });
        let Some(tie) = tie else { return self.beyond(Beyond::Arrangement) };
        self.reaction(tie, label)
    }

    fn tension(&mut self, tie: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some(spring) = self.spring.clone().filter(|s| s.tie == tie) {
            if let Some(known) = self.found(label) {
                return Ok(known);
            }
            let stretch = self.stretch_at(&spring, &self.s.clone());
            let from = &spring.stiffness * stretch;
            return Ok(self.found_now(label, spring.tension, &from));
        }
        self.reaction(tie, label)
    }

    /// Stretch of the spring after this displacement of the lead.
    pub fn stretch_at(&self, spring: &CordSpring, s: &Expr) -> Expr {
        &spring.stretch - spring.gamma.times(&Factors::of(s)).expr()
    }

    /// A reaction: from the row in which it is the only unknown left, others first where need be.
    fn reaction(&mut self, tie: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some(known) = self.found(label) {
            return Ok(known);
        }
        self.solve_reaction(tie)?;
        match self.found(label) {
            Some(symbol) => Ok(symbol),
            None => self.beyond(Beyond::Arrangement),
        }
    }

    fn label_of_tie(&self, tie: usize) -> Label {
        match &self.draft.scene.ties[tie] {
            Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => {
                of_body(Quantity::Friction, *body)
            }
            Tie::Cord(_) => of_tie(Quantity::Tension, tie),
        }
    }

    fn solve_reaction(&mut self, tie: usize) -> Result<(), DerivationStop> {
        // Each would need the other first.
        if self.solving.contains(&tie) {
            return self.beyond(Beyond::SeveralEquations);
        }
        self.solving.push(tie);
        let coordinates: Vec<Coordinate> = self.draft.scene.coordinates().collect();
        // The row that asks for the fewest other reactions; lines before turns.
        let mut best: Option<(usize, Coordinate, Vec<usize>)> = None;
        for c in coordinates {
            let row = self.row(c);
            if !row.iter().any(|(a, _)| a.source == ForceSource::Tie(tie)) {
                continue;
            }
            let others: Vec<usize> = row
                .iter()
                .filter_map(|(a, _)| match (a.kind, a.source) {
                    (ForceKind::Reaction, ForceSource::Tie(t)) if t != tie => Some(t),
                    _ => None,
                })
                .filter(|t| self.found(self.label_of_tie(*t)).is_none())
                .collect();
            if others.iter().any(|t| self.solving.contains(t)) {
                continue;
            }
            let price = 2 * others.len() + usize::from(c.degree == Degree::Turn);
            if best.as_ref().is_none_or(|(p, ..)| price < *p) {
                best = Some((price, c, others));
            }
        }
        let Some((_, c, others)) = best else {
            return self.beyond(Beyond::SeveralEquations);
        };
        for other in others {
            if self.found(self.label_of_tie(other)).is_none() {
                self.solve_reaction(other)?;
            }
        }
        // Whatever else the row needs.
        for (action, _) in self.row(c) {
            if let (ForceSource::Tie(t), ForceKind::Spring | ForceKind::Kinetic) =
                (action.source, action.kind)
                && t != tie
            {
                self.get(self.label_of_tie(t))?;
            }
        }
        let gain = self.gain(c)?;
        let mut lever = Factors::one();
        let mut rest = vec![gain];
        for (action, share) in self.row(c) {
            if action.source == ForceSource::Tie(tie) {
                lever = self.m.lever(&action, c).clone();
            } else {
                rest.push(-share);
            }
        }
        let negative = self.value(&lever.expr()) < 0.0;
        let rest: Vec<Expr> = rest.into_iter().filter(|e| *e != ZERO).collect();
        let rest: Vec<Expr> = if negative { rest.into_iter().map(minus).collect() } else { rest };
        let over = positive_first(rest);
        let from = Factors::of(&over).per(&self.magnitude(&lever)).expr();
        let Some(symbol) = self.m.force_of(tie) else { return self.beyond(Beyond::Arrangement) };
        let label = self.label_of_tie(tie);
        let body = self.in_brackets(c.body);
        match (self.method, c.degree) {
            (SolvingMethod::Motion, _) => {
                let n = self.number_of(c);
                self.tell("motion.reaction", &[("n", &n)]);
            }
            (SolvingMethod::Energy, Degree::Along) if self.by_rate() => {
                self.tell("energy.reaction_rate", &[("body", &body)]);
            }
            (SolvingMethod::Energy, Degree::Turn) if self.by_rate() => {
                self.tell("energy.reaction_rate_turn", &[("body", &body)]);
            }
            (SolvingMethod::Energy, Degree::Along) => self.tell("energy.reaction_along", &[("body", &body)]),
            (SolvingMethod::Energy, Degree::Turn) => self.tell("energy.reaction_turn", &[("body", &body)]),
        }
        self.found_now(label, symbol, &from);
        self.solving.pop();
        Ok(())
    }

    /// Are reactions by the energy method to be had from the rate of the balance only?
    fn by_rate(&self) -> bool {
        self.spring.is_some() || self.value(&self.s) == 0.0
    }

    /// What the forces of a row amount to: inertia times acceleration, or kinetic energy per displacement.
    fn gain(&mut self, c: Coordinate) -> Result<Expr, DerivationStop> {
        let ratio = self.m.ratio(c).clone();
        if ratio.is_zero() && !self.own(c) {
            return Ok(ZERO);
        }
        let quantity = |along, turn| of_body(if c.degree == Degree::Along { along } else { turn }, c.body);
        let inertia = self.m.inertia(c);
        if self.method == SolvingMethod::Motion || self.by_rate() {
            if inertia.is_empty() {
                return Ok(ZERO);
            }
            let a = self.get(quantity(Quantity::A, Quantity::Alpha))?;
            return Ok(weighted(&inertia, &Factors::of(&a.into())));
        }
        let way = Factors::of(&self.s).times(&ratio);
        let twice = way.times(&Factors::of(&number(2)));
        if self.v0 == ZERO {
            let v = self.get(quantity(Quantity::V, Quantity::Omega))?;
            return Ok(weighted(&inertia, &Factors::of(&v.into()).squared().per(&twice)));
        }
        let squares = square(&self.v) - square(&self.v0);
        let per = Factors::of(&squares).times(&ratio.squared()).per(&twice);
        Ok(weighted(&inertia, &per))
    }

    fn least_grip(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let n = self.get(of_body(Quantity::Normal, body))?;
        let symbol = self.new_symbol(&[r"\mu_{\mathrm{min}}"], "1");
        if self.spring.is_some() {
            let ends = self.extremes(body)?;
            let most = larger(self, &ends).map_or_else(|| ends[0].clone(), |(most, _)| most);
            let at = self.phrase(&format!("extremes.at.{}", most.place), &[]);
            self.tell("grip.least_spring", &[("at", &at)]);
            let size = self.size(most.friction);
            return Ok(self.found_now(label, symbol, &(size / n)));
        }
        // Kinetic friction says nothing of the grip that rolling needs.
        let rolling = if self.m.parts[body].slips { self.if_rolled(body) } else { None };
        let (f, name) = match rolling {
            Some(f) => (f, "grip.least_rolling"),
            None => (self.get(of_body(Quantity::Friction, body))?, "grip.least"),
        };
        self.tell(name, &[]);
        let size = self.size(f.into());
        Ok(self.found_now(label, symbol, &(size / n)))
    }

    /// The friction that rolling would need, as this method found it before.
    fn if_rolled(&self, body: usize) -> Option<SymbolId> {
        let label = of_body(Quantity::FrictionIfRolled, body);
        let found = self.draft.found.iter().find(|f| f.label == label)?;
        match if self.method == SolvingMethod::Motion { found.eom? } else { found.energy? } {
            DerivedAnswer::Value(symbol) => Some(symbol),
            DerivedAnswer::Word(_) => None,
        }
    }

    /// Friction at release and at the far end of the motion, for a wheel on a spring.
    pub fn extremes(&mut self, body: usize) -> Result<[Extreme; 2], DerivationStop> {
        let Some(spring) = self.spring.clone() else { return self.beyond(Beyond::Arrangement) };
        let far = self.far_end()?;
        let stretch = self.stretch_at(&spring, &far);
        let (stretch_m, first_m) = (self.value(&stretch), self.value(&spring.stretch));
        let place = if stretch_m.abs() < SLACK * first_m.abs() {
            "slack"
        } else if far == self.s {
            "end"
        } else {
            "turn"
        };
        self.tell("extremes.release", &[]);
        let friction = self.friction_at(body, &ZERO, "1")?;
        let first = Extreme { friction, place: "release", stretch_m: first_m };
        self.tell(&format!("extremes.{place}"), &[]);
        let friction = self.friction_at(body, &far, "2")?;
        Ok([first, Extreme { friction, place, stretch_m }])
    }

    /// Displacement at the far end of what the conditions look at: the end that is asked or, where the scene looks beyond it, the
    /// turning point; but no farther than where the cord goes slack, for friction then stays what it is.
    fn far_end(&mut self) -> Result<Expr, DerivationStop> {
        if self.draft.scene.span == Span::ToEnd && self.s != ZERO {
            return Ok(self.s.clone());
        }
        self.turning_or_slack()
    }

    /// Displacement at which the tension is least in the whole motion: the turning point, or where the cord goes slack.
    fn turning_or_slack(&mut self) -> Result<Expr, DerivationStop> {
        let Some(spring) = self.spring.clone() else { return self.beyond(Beyond::Arrangement) };
        let (first, kappa) = (spring.first.clone(), spring.kappa.clone());
        let turn = number(2) * &first / &kappa;
        let slack = Factors::of(&spring.stretch).per(&spring.gamma).expr();
        let (t, s) = (self.value(&turn), self.value(&slack));
        let goes_slack = !spring.rigid && s * t > 0.0 && s.abs() < t.abs();
        Ok(if goes_slack { slack } else { turn })
    }

    fn friction_at(&mut self, body: usize, s: &Expr, mark: &str) -> Result<Expr, DerivationStop> {
        let Some(spring) = self.spring.clone() else { return self.beyond(Beyond::Arrangement) };
        let saved = (self.m.clone(), self.known.clone(), self.s.clone());
        // The same equations once more, with unknowns of this place.
        let mut m = Mechanism::new(self.draft, self.rolled)?;
        for part in &mut m.parts {
            for symbol in [&mut part.a, &mut part.alpha].into_iter().flatten() {
                let tex = marked(self.draft.symbols.tex(*symbol), mark);
                *symbol = self.draft.symbols.unknown_like(&tex, *symbol);
            }
        }
        for action in &mut m.actions {
            if let Expr::Symbol(symbol) = &mut action.force
                && action.kind != ForceKind::Given
            {
                let tex = marked(self.draft.symbols.tex(*symbol), mark);
                *symbol = self.draft.symbols.unknown_like(&tex, *symbol);
            }
        }
        self.m = m;
        self.s = s.clone();
        let keep = |l: &Label| matches!(l.quantity, Quantity::Normal);
        self.known.retain(|(l, _)| keep(l));
        let result = self.friction_here(body, &spring, s);
        (self.m, self.known, self.s) = saved;
        result
    }

    fn friction_here(&mut self, body: usize, spring: &CordSpring, s: &Expr) -> Result<Expr, DerivationStop> {
        let Some(tension) = self.m.force_of(spring.tie) else { return self.beyond(Beyond::Arrangement) };
        let stretch = self.stretch_at(spring, s);
        let label = of_tie(Quantity::Tension, spring.tie);
        if self.value(&stretch).abs() < SLACK * self.value(&spring.stretch).abs() {
            for action in self.m.actions.iter_mut().filter(|a| a.kind == ForceKind::Spring) {
                action.force = ZERO;
            }
            self.note(label, tension);
        } else {
            self.found_now(label, tension, &(&spring.stiffness * stretch));
        }
        let terms: Vec<Expr> = self.terms().into_iter().map(|(_, e)| e).collect();
        let lead = self.lead();
        let Some(a) = self.m.acceleration(lead) else { return self.beyond(Beyond::Arrangement) };
        let from = sum(terms) / &self.effective;
        self.found_now(self.label_of_lead(Quantity::A, Quantity::Alpha), a, &from);
        Ok(self.friction(body, of_body(Quantity::Friction, body))?.into())
    }

    fn time(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let symbol = self.new_symbol(&["t", "t_2"], "s");
        if self.spring.is_some() {
            return self.beyond(Beyond::SpringTime);
        }
        if let End::Time(_, t) = self.draft.scene.end {
            let t = self.draft.number(t, "t", "s");
            return Ok(self.found_now(label, symbol, &t));
        }
        let from = match self.method {
            SolvingMethod::Motion => {
                let a = self.get(self.label_of_lead(Quantity::A, Quantity::Alpha))?;
                if self.value(&a.into()) == 0.0 {
                    self.tell("motion.time_uniform", &[]);
                    let from = &self.s / &self.v0;
                    return Ok(self.found_now(label, symbol, &from));
                }
                self.tell("motion.time", &[]);
                let end = in_sense(self.v.clone(), self.sense);
                (end - &self.v0) / a
            }
            SolvingMethod::Energy => {
                self.tell("energy.time", &[]);
                let both = in_sense(self.v.clone(), self.sense) + &self.v0;
                if self.sense < 0.0 {
                    number(2) * self.distance() / (-both)
                } else {
                    number(2) * &self.s / both
                }
            }
        };
        Ok(self.found_now(label, symbol, &from))
    }

    /// Index of the tie of a label that belongs to a cord.
    fn cord_of(&self, label: Label) -> Result<(usize, Action), DerivationStop> {
        let Owner::Tie(t) = label.of else { return self.beyond(Beyond::Arrangement) };
        match self.m.action_of(t) {
            Some(action) => Ok((t, action.clone())),
            None => self.beyond(Beyond::Arrangement),
        }
    }

    fn several_pulls(&self) -> bool {
        let ties = &self.draft.scene.ties;
        let pulls = ties.iter().filter(|t| match t {
            Tie::Cord(c) => matches!(c.to, Far::Pull(_) | Far::Spring { .. }),
            _ => false,
        });
        pulls.count() > 1
    }

    fn cord_travel(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let tag = if self.several_pulls() { (t + 1).to_string() } else { String::new() };
        let symbol = self.new_symbol(&[&tagged(r"\ell", &tag), &tagged("L", &tag)], "m");
        let slips = self.m.parts[action.body].slips;
        let way = self.distance();
        if slips || (self.method == SolvingMethod::Motion && !action.arm.is_zero() && !action.along.is_zero())
        {
            let phi = self.get(of_body(Quantity::Phi, action.body))?;
            // Both parts with the sign that they have along the cord.
            let centre = action.along.times(&self.m.parts[action.body].along);
            let centre = Factors::of(&way).times(&centre.signed(sign(self.sense)));
            let spin = self.signed_turn(action.body);
            let turned = Factors::of(&phi.into()).times(&action.arm.signed(sign(spin)));
            let (along, wound) = (self.value(&centre.expr()), self.value(&turned.expr()));
            let winds = self.phrase(if wound > 0.0 { "motion.unwinds" } else { "motion.winds_up" }, &[]);
            let name = if along * wound > 0.0 {
                "motion.cord_travel"
            } else if along.abs() >= wound.abs() {
                "motion.cord_travel_less"
            } else {
                "motion.cord_travel_against"
            };
            self.tell(name, &[("winds", &winds)]);
            let parts = [centre.expr(), turned.expr()];
            let from = if along + wound < 0.0 { parts.map(minus) } else { parts };
            let from = positive_first(from.to_vec());
            return Ok(self.found_now(label, symbol, &from));
        }
        let point = self.m.point(&action);
        if self.method == SolvingMethod::Energy {
            self.why_cord(&action);
        }
        let from = Factors::of(&way).times(&self.magnitude(&point)).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    /// Why a cord's end goes another way than the centre.
    fn why_cord(&mut self, action: &Action) {
        let rolls = self.draft.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { body, radius_m, .. } if *body == action.body => Some(*radius_m),
            Tie::Slip { body, radius_m, .. } if *body == action.body && self.rolled => Some(*radius_m),
            _ => None,
        });
        match rolls {
            Some(c) if !action.arm.is_zero() && !action.along.is_zero() => {
                let c = self.draft.number(c, "R", "m");
                let arm = self.magnitude(&action.arm).expr();
                // From the point of contact: c to the centre, c + p to a point on the far side.
                let far = self.value(&action.arm.expr()) * self.value(&action.along.expr()) > 0.0;
                let point = match (far, self.value(&c) >= self.value(&arm)) {
                    (true, _) => &c + arm,
                    (false, true) => &c - arm,
                    (false, false) => arm - &c,
                };
                let (near, away) = (self.value(&c), self.value(&point));
                let beyond = !far && self.value(&action.arm.expr()).abs() > near;
                let (centre, point) = (self.tex(&c), self.tex(&point));
                if beyond {
                    let compared = match away.total_cmp(&near) {
                        Ordering::Greater => "energy.further",
                        Ordering::Less => "energy.less_far",
                        Ordering::Equal => "energy.as_far",
                    };
                    let compared = self.phrase(compared, &[]);
                    let pieces = [("centre", &*centre), ("point", &*point), ("compared", &*compared)];
                    self.tell("energy.why_cord_beyond", &pieces);
                } else {
                    let name = if far { "energy.why_cord_far" } else { "energy.why_cord_near" };
                    self.tell(name, &[("centre", &centre), ("point", &point)]);
                }
            }
            _ if action.arm.is_zero() => {
                let body = self.in_brackets(action.body);
                self.tell("energy.cord_at_centre", &[("body", &body)]);
            }
            _ => {
                let body = self.in_brackets(action.body);
                self.tell("energy.cord_unwinds", &[("body", &body)]);
            }
        }
    }

    /// Sense in which a body turns on the way.
    fn signed_turn(&self, body: usize) -> f64 {
        if self.m.parts[body].slips {
            self.spin_sense(body)
        } else {
            self.value(&self.m.parts[body].turn.expr()) * self.sense
        }
    }

    fn work_of_pull(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let travel = self.get(of_tie(Quantity::CordTravel, t))?;
        let helps = self.pull_helps(&action);
        let tag = if self.several_pulls() { (t + 1).to_string() } else { "P".to_owned() };
        let symbol = self.new_symbol(&[&tagged("W", &tag)], "J");
        let from = in_sense(&action.force * travel, helps);
        Ok(self.found_now(label, symbol, &from))
    }

    /// Sign of the work of a pull.
    fn pull_helps(&self, action: &Action) -> f64 {
        let part = &self.m.parts[action.body];
        if !part.slips {
            return self.value(&self.m.point(action).expr()) * self.sense;
        }
        let phi =
            self.found(of_body(Quantity::Phi, action.body)).map_or(0.0, |p| self.draft.symbols.value(p));
        let centre = self.value(&part.along.expr()) * self.value(&self.s) * self.value(&action.along.expr());
        centre + phi * self.spin_sense(action.body) * self.value(&action.arm.expr())
    }

    fn power_of_pull(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let tag = if self.several_pulls() { (t + 1).to_string() } else { "P".to_owned() };
        let symbol = self.new_symbol(&[&tagged(r"\dot{W}", &tag)], "W");
        let part = self.m.parts[action.body].clone();
        self.tell("power", &[]);
        let from = if part.slips {
            let v = self.get(of_body(Quantity::V, action.body))?;
            let omega = self.get(of_body(Quantity::Omega, action.body))?;
            let centre = Factors::of(&v.into()).times(&action.along.signed(sign(self.sense)));
            let turned =
                Factors::of(&omega.into()).times(&action.arm.signed(sign(self.spin_sense(action.body))));
            &action.force * positive_first(vec![centre.expr(), turned.expr()])
        } else {
            let point = self.m.point(&action).signed(sign(self.sense)).upright(&self.draft.symbols);
            Factors::of(&action.force).times(&point).times(&Factors::of(&self.v)).expr()
        };
        Ok(self.found_now(label, symbol, &from))
    }

    /// `1/2 m v^2 + 1/2 I omega^2 + ...` with the speeds of each body.
    pub fn kinetic_sum(&mut self) -> Result<Expr, DerivationStop> {
        if self.v == ZERO {
            return Ok(ZERO);
        }
        let coordinates: Vec<Coordinate> = self.draft.scene.coordinates().collect();
        let mut all = Vec::new();
        for c in coordinates {
            let quantity = if c.degree == Degree::Along { Quantity::V } else { Quantity::Omega };
            let inertia = self.m.inertia(c);
            if inertia.is_empty() {
                continue;
            }
            let v = self.get(of_body(quantity, c.body))?;
            for i in inertia {
                all.push(ratio(1, 2) * i.expr() * square(v));
            }
        }
        Ok(sum(all))
    }

    fn kinetic_energy(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let symbol = self.new_symbol(&["E_{k}", r"E_{\mathrm{kin}}"], "J");
        // Of a slipping body the works that are written down leave out that of friction.
        let slips = self.m.parts.iter().any(|p| p.slips);
        let from = match (self.method, self.works()) {
            (SolvingMethod::Energy, Some(works)) if !slips => {
                self.tell("energy.kinetic", &[]);
                let start = ratio(1, 2) * &self.effective * square(&self.v0);
                sum([if self.v0 == ZERO { ZERO } else { start }, works])
            }
            _ => self.kinetic_sum()?,
        };
        Ok(self.found_now(label, symbol, &from))
    }

    /// The sum of all works as the energy method found them.
    pub fn works(&self) -> Option<Expr> {
        let found: Vec<Expr> = self.works.iter().map(|(_, _, s)| (*s).into()).collect();
        if found.is_empty() { None } else { Some(sum(found)) }
    }

    fn rotational(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let symbol = self.new_symbol(&[r"\eta", r"\beta"], "1");
        let slips = self.m.parts.iter().any(|p| p.slips);
        if self.method == SolvingMethod::Motion || slips {
            let mut turning = Vec::new();
            for body in 0..self.m.parts.len() {
                let c = Coordinate { body, degree: Degree::Turn };
                for i in self.m.inertia(c) {
                    let omega = self.get(of_body(Quantity::Omega, body))?;
                    turning.push(ratio(1, 2) * i.expr() * square(omega));
                }
            }
            let whole = self.get(of_scene(Quantity::KineticEnergy))?;
            if turning.len() > 1 {
                let spin = self.new_symbol(&["E_{r}"], "J");
                self.find(spin, &sum(turning));
                turning = vec![spin.into()];
            }
            return Ok(self.found_now(label, symbol, &(sum(turning) / whole)));
        }
        self.tell("energy.share", &[]);
        let mut turning = Vec::new();
        for body in 0..self.m.parts.len() {
            let c = Coordinate { body, degree: Degree::Turn };
            let square = self.m.ratio(c).squared();
            turning.extend(self.m.inertia(c).into_iter().map(|i| i.times(&square).expr()));
        }
        Ok(self.found_now(label, symbol, &(sum(turning) / &self.effective)))
    }

    fn slip_distance(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some((_, c)) = self.slip_of(body) else { return self.beyond(Beyond::Arrangement) };
        let phi = self.get(of_body(Quantity::Phi, body))?;
        let symbol = self.new_symbol(&[r"\delta", r"\Delta"], "m");
        self.tell("slip_distance", &[]);
        let way = Factors::of(&self.s).times(&self.m.parts[body].along).expr();
        let turned = in_sense(c * phi, self.spin_sense(body));
        let from = way - turned;
        let size = in_sense(from.clone(), self.value(&from));
        let from = positive_first(vec![size]);
        Ok(self.found_now(label, symbol, &from))
    }

    /// Tie and radius of a contact that slips.
    pub fn slip_of(&mut self, body: usize) -> Option<(usize, Expr)> {
        let found = self.draft.scene.ties.iter().enumerate().find_map(|(t, tie)| match tie {
            Tie::Slip { body: b, radius_m, .. } if *b == body => Some((t, *radius_m)),
            _ => None,
        });
        found.map(|(t, r)| (t, self.draft.number(r, "R", "m")))
    }

    fn heat(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let symbol = self.new_symbol(&["Q", r"Q_{\mathrm{th}}"], "J");
        if self.method == SolvingMethod::Energy {
            return self.heat_by_balance(label, symbol);
        }
        let ties = self.draft.scene.ties.clone();
        let mut all = Vec::new();
        for (t, tie) in ties.iter().enumerate() {
            let (body, way) = match tie {
                Tie::Slip { body, .. } => (*body, self.get(of_body(Quantity::SlipDistance, *body))?.into()),
                Tie::Slide { body, .. } => {
                    let ratio = self.magnitude(&self.m.parts[*body].along);
                    (*body, Factors::of(&self.distance()).times(&ratio).expr())
                }
                _ => continue,
            };
            let f = self.get(of_body(Quantity::Friction, body))?;
            debug_assert_eq!(self.m.force_of(t), Some(f), "the friction of this tie");
            let size = self.size(f.into());
            all.push(size * way);
        }
        self.tell("motion.heat", &[]);
        Ok(self.found_now(label, symbol, &sum(all)))
    }

    /// What the forces put in and is not found as kinetic energy.
    fn heat_by_balance(&mut self, label: Label, symbol: SymbolId) -> Result<SymbolId, DerivationStop> {
        let kinetic = self.kinetic_sum()?;
        // Friction's own work is what is asked.
        let others = self.works.iter().filter(|(_, kind, _)| *kind != ForceKind::Kinetic);
        let mut terms: Vec<Expr> = others.map(|(_, _, s)| (*s).into()).collect();
        if self.v0 != ZERO {
            terms.push(ratio(1, 2) * &self.effective * square(&self.v0));
        }
        self.tell("energy.heat", &[]);
        let from = sum(terms) - kinetic;
        Ok(self.found_now(label, symbol, &from))
    }

    fn bound_of_gyration(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let c = self.draft.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { radius_m, .. } => Some(*radius_m),
            _ => None,
        });
        let Some(c) = c else { return self.beyond(Beyond::NoBound) };
        let c = self.draft.number(c, "R", "m");
        let symbol = self.new_symbol(&["k_{0}"], "m");
        let share = |task: &Self, degree| {
            let row = task.row(Coordinate { body, degree });
            sum(row
                .into_iter()
                .filter(|(a, _)| a.kind == ForceKind::Given)
                .map(|(_, e)| e)
                .collect::<Vec<_>>())
        };
        let (force, moment) = (share(self, Degree::Along), share(self, Degree::Turn));
        let up = f64::from(self.m.parts[body].up);
        if self.value(&force) * up <= 0.0 || self.value(&moment) * up <= 0.0 {
            return self.beyond(Beyond::NoBound);
        }
        let way = crate::solution::way(self.draft.scene, Owner::Body(body), 1.0);
        let way = way.map_or_else(String::new, |w| self.draft.words.get(w).to_owned());
        self.tell_method("bound", &[("way", &way)]);
        let (part, k0) = (self.m.parts[body].clone(), Factors::of(&symbol.into()).squared());
        let inertia = part.mass.times(&k0);
        let lines: Vec<(Expr, Expr)> = match self.method {
            SolvingMethod::Motion => {
                let Some(a) = part.a else { return self.beyond(Beyond::Arrangement) };
                let tex = marked(self.draft.symbols.tex(a), "0");
                let a = self.draft.symbols.unknown_like(&tex, a);
                let a = Factors::of(&a.into());
                let spin = inertia.times(&a).per(&Factors::of(&c)).expr();
                vec![(force.clone(), part.mass.times(&a).expr()), (moment.clone(), spin)]
            }
            SolvingMethod::Energy => {
                let v = self.new_symbol(&["u_{0}"], "m/s");
                let half = |i: &Factors| i.times(&Factors::of(&square(v))).times(&Factors::of(&ratio(1, 2)));
                let way = self.distance();
                let turned = Factors::of(&moment).times(&Factors::of(&way)).per(&Factors::of(&c)).expr();
                let spin = half(&inertia).per(&Factors::of(&c).squared()).expr();
                vec![(&force * way, half(&part.mass).expr()), (turned, spin)]
            }
        };
        for (left, right) in lines {
            self.out.equation(&self.draft.symbols, &left, &right);
        }
        self.tell("bound_found", &[]);
        Ok(self.found_now(label, symbol, &root(c * moment / force)))
    }

    fn equilibrium(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some(spring) = self.spring.clone() else { return self.beyond(Beyond::Arrangement) };
        let symbol = self.new_symbol(&[r"x_{\mathrm{eq}}"], "m");
        self.tell_method("equilibrium", &[]);
        let per = Factors::of(&spring.stiffness).times(&spring.gamma);
        let from = Factors::of(&(-&self.drive)).per(&per).expr();
        Ok(self.found_now(label, symbol, &from))
    }

    /// The greatest speed of a motion on a spring, and where it is.
    fn fastest(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let Some(spring) = self.spring.clone() else { return self.fastest_thrown(label) };
        let (first, kappa) = (spring.first.clone(), spring.kappa.clone());
        if self.v0 != ZERO {
            return self.beyond(Beyond::SpringWithSpeed);
        }
        let body = self.lead().body;
        let slack = Factors::of(&spring.stretch).per(&spring.gamma).expr();
        let level = self.value(&first) / self.value(&kappa);
        let s = self.value(&slack);
        if !spring.rigid && s * level > 0.0 && s.abs() < level.abs() * (1.0 - 1e-9) {
            return self.beyond(Beyond::FastestSlack);
        }
        let way = self.new_symbol(&["D_{v}"], "m");
        let top = self.new_symbol(&[r"v_{\mathrm{max}}"], "m/s");
        let first = in_sense(first, level);
        match self.method {
            SolvingMethod::Motion => {
                self.tell("motion.fastest", &[]);
                self.find(way, &(&first / &kappa));
                let under = root(kappa * &self.effective);
                self.find(top, &(first / under));
            }
            SolvingMethod::Energy => {
                let x_eq = self.get(of_scene(Quantity::XEq))?;
                self.tell("energy.fastest", &[]);
                let gap = &spring.stretch - x_eq;
                let from = Factors::of(&gap).per(&spring.gamma).expr();
                let size = in_sense(from.clone(), self.value(&from));
                let from = positive_first(vec![size]);
                self.find(way, &from);
                let signed = in_sense(way.into(), level);
                let stored = &spring.stiffness * (square(&spring.stretch) - square(x_eq));
                let others = number(2) * &self.drive * signed;
                let over = positive_first(vec![stored, others]);
                self.find(top, &root(over / &self.effective));
            }
        }
        self.note(of_body(Quantity::DAtVMax, body), way);
        self.note(of_body(Quantity::VMax, body), top);
        match self.found(label) {
            Some(symbol) => Ok(symbol),
            None => self.beyond(Beyond::Arrangement),
        }
    }

    /// Thrown against a constant force: fastest at the start.
    fn fastest_thrown(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if self.value(&self.drive) * self.sense > 0.0 {
            return self.beyond(Beyond::NeverFastest);
        }
        self.tell("fastest_at_start", &[]);
        let (symbol, from) = if label.quantity == Quantity::VMax {
            let size = in_sense(self.v0.clone(), self.sense);
            (self.new_symbol(&[r"v_{\mathrm{max}}"], "m/s"), size)
        } else {
            (self.new_symbol(&["D_{v}"], "m"), ZERO)
        };
        Ok(self.found_now(label, symbol, &from))
    }

    fn turning(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let symbol = self.new_symbol(&[r"D_{\mathrm{t}}"], "m");
        let Some(spring) = self.spring.clone() else {
            if self.value(&self.drive) * self.sense >= 0.0 {
                return self.beyond(Beyond::NeverTurns);
            }
            self.tell("turning_constant", &[]);
            let size = in_sense(self.drive.clone(), self.value(&self.drive));
            let over = &self.effective * square(&self.v0);
            return Ok(self.found_now(label, symbol, &(over / (number(2) * size))));
        };
        let (first, kappa) = (spring.first.clone(), spring.kappa.clone());
        if self.v0 != ZERO {
            return self.beyond(Beyond::SpringWithSpeed);
        }
        let far = self.turning_or_slack()?;
        let turn = number(2) * &first / &kappa;
        let level = self.value(&turn);
        if far == turn {
            self.tell(if spring.rigid { "turning_rigid" } else { "turning_taut" }, &[]);
            return Ok(self.found_now(label, symbol, &in_sense(turn, level)));
        }
        // Slack: all that the spring stored goes into what the other forces take up to the turning point.
        let rest = self.drive.clone();
        if self.value(&rest) * level >= 0.0 {
            return self.beyond(Beyond::NeverTurns);
        }
        self.tell("turning_slack", &[]);
        let over = &spring.stiffness * square(&spring.stretch);
        let size = in_sense(rest.clone(), self.value(&rest));
        Ok(self.found_now(label, symbol, &(over / (number(2) * size))))
    }

    /// Answers the questions of the problem by this method, behind a sentence that announces what is still to be found.
    ///
    /// # Errors
    /// What the derivation does not cover.
    pub fn answer(&mut self) -> Result<(), DerivationStop> {
        let before = self.out.blocks.len();
        self.tell_method("rest", &[]);
        let labels: Vec<Label> = self.draft.problem.questions.iter().map(|q| q.label).collect();
        for label in labels {
            if label.quantity.is_word() || label.quantity == Quantity::FrictionIfRolled {
                continue;
            }
            let symbol = self.get(label)?;
            match self.method {
                SolvingMethod::Motion => self.draft.from_motion(label, DerivedAnswer::Value(symbol)),
                SolvingMethod::Energy => self.draft.from_energy(label, DerivedAnswer::Value(symbol)),
            }
        }
        // Nothing was left to find.
        if self.out.blocks.len() == before + 1 {
            self.out.blocks.truncate(before);
        }
        Ok(())
    }
}

/// A symbol with a mark below it, behind what stands there already.
fn marked(tex: &str, mark: &str) -> String {
    match tex.split_once("_{").and_then(|(symbol, below)| Some((symbol, below.strip_suffix('}')?))) {
        Some((symbol, below)) => format!("{symbol}_{{{below},{mark}}}"),
        None => format!("{tex}_{{{mark}}}"),
    }
}

/// 1 or -1.
pub fn sign(of: f64) -> i8 {
    if of < 0.0 { -1 } else { 1 }
}

fn negative(of: &Factors) -> bool {
    matches!(of.expr(), Expr::Minus(_) | Expr::Number(i64::MIN..0, _))
}

/// Order of forces in an equation.
fn rank(action: &Action) -> u8 {
    match (action.source, action.kind) {
        (ForceSource::Tie(_), ForceKind::Given) => 0,
        (ForceSource::Tie(_), ForceKind::Spring) => 1,
        (ForceSource::Couple(_), _) => 2,
        (ForceSource::Tie(_), _) if !action.contact => 3,
        (ForceSource::Tie(_), _) => 4,
        (ForceSource::Weight(_), _) => 5,
    }
}

/// A sum that begins with what is added.
pub fn positive_first(terms: Vec<Expr>) -> Expr {
    let (minus, plus): (Vec<Expr>, Vec<Expr>) = terms
        .into_iter()
        .flat_map(|t| match t {
            Expr::Sum(inner) => inner,
            other => vec![other],
        })
        .partition(|t| matches!(t, Expr::Minus(_)));
    sum(plus.into_iter().chain(minus))
}

/// `(i + ...) x`
fn weighted(inertia: &[Factors], by: &Factors) -> Expr {
    match inertia {
        [] => ZERO,
        [only] => only.times(by).expr(),
        several => sum(several.iter().map(Factors::expr)) * by.expr(),
    }
}
