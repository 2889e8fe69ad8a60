//! What follows from the terms of a scene of lines and axles: the motion, and each further quantity on demand, as an
//! expression in symbols. Nothing is worded here; [`crate::solution::narrate`] tells it.
use crate::scene::{Coordinate, Degree, End, Far, Label, Num, Owner, Quantity, Span, Start, Tie};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{
    Expr, SymbolId, ZERO, in_sense, magnitude, number, positive_first, ratio, root, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::page::Page;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::terms::{Action, ForceKind, ForceSource, Terms, tagged};

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
    /// Travel of the cord's end per unit travel of the lead; the stretch falls by it.
    pub gamma: Factors,
    /// Its force at the end.
    pub tension: SymbolId,
}

/// A reaction as it leaves the equations: from which row, and what it is there.
#[derive(Debug, Clone)]
pub struct Eliminated {
    /// The row.
    pub row: Coordinate,
    /// The reaction.
    pub force: SymbolId,
    /// What it is equal to, with the acceleration in it.
    pub is: Expr,
}

/// Stretch, as a share of the first, below which rounding alone keeps a cord from being slack.
const SLACK: f64 = 1e-12;

/// What is known of a scene.
pub struct Account<'d, 'a> {
    /// The page, with the draft and what was found.
    pub page: Page<'d, 'a>,
    /// The terms.
    pub m: Terms,
    /// Ratios of displacements that bear a name, with the cord they belong to.
    pub gammas: Vec<(usize, SymbolId, Expr)>,
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
    /// Sum of the forces but the spring's, reckoned to the lead.
    pub drive: Expr,
    /// The spring.
    pub spring: Option<CordSpring>,
    /// Is a slipping wheel taken as if it rolled?
    pub rolled: bool,
    known: Vec<(Label, SymbolId)>,
    /// The ties whose reactions are being solved for, each for the one before it.
    solving: Vec<usize>,
}

/// A body's label.
pub const fn of_body(quantity: Quantity, body: usize) -> Label {
    Label { quantity, of: Owner::Body(body) }
}

/// A tie's label.
pub const fn of_tie(quantity: Quantity, tie: usize) -> Label {
    Label { quantity, of: Owner::Tie(tie) }
}

/// A label of the whole scene.
pub const fn of_scene(quantity: Quantity) -> Label {
    Label { quantity, of: Owner::Scene }
}

const fn along(body: usize) -> Coordinate {
    Coordinate { body, degree: Degree::Along }
}

const fn turn(body: usize) -> Coordinate {
    Coordinate { body, degree: Degree::Turn }
}

fn beyond<T>(what: Beyond) -> Result<T, DerivationStop> {
    Err(what.into())
}

impl<'d, 'a> Account<'d, 'a> {
    /// Sets out: terms, senses, start. `slips`: each slipping contact with the sense of its friction, positive up.
    ///
    /// # Errors
    /// What is not covered.
    pub fn new(
        draft: &'d mut Draft<'a>,
        rolled: bool,
        slips: &[(usize, f64)],
    ) -> Result<Self, DerivationStop> {
        let m = Terms::new(draft, rolled)?;
        let mut this = Self {
            page: Page::new(draft),
            m,
            gammas: Vec::new(),
            sense: 1.0,
            v0: ZERO,
            s: ZERO,
            v: ZERO,
            effective: ZERO,
            drive: ZERO,
            spring: None,
            rolled,
            known: Vec::new(),
            solving: Vec::new(),
        };
        this.name_ratios();
        if let Some((tie, ks, x0, rigid)) = this.page.draft.scene.spring() {
            let stiffness = this.page.draft.number(ks, "k_s", "N/m");
            let stretch = this.page.draft.number(x0, "x_0", "m");
            let (Some(action), Some(tension)) = (this.m.action_of(tie).cloned(), this.m.force_of(tie)) else {
                return beyond(Beyond::Arrangement);
            };
            let gamma = this.point(&action);
            this.spring = Some(CordSpring { tie, stiffness, stretch, rigid, gamma, tension });
        }
        this.effective = this.effective_mass();
        this.set_out(slips)?;
        Ok(this)
    }

    /// The ratio of displacements of a pulled or sprung cord that is wound on a rolling body has a name.
    fn name_ratios(&mut self) {
        let slips = |b: usize| self.m.parts[b].slips;
        let named = |a: &&Action| {
            matches!(a.kind, ForceKind::Given | ForceKind::Spring)
                && matches!(a.source, ForceSource::Tie(_))
                && !a.arm.is_zero()
                && !a.along.is_zero()
                && !slips(a.body)
        };
        let actions: Vec<Action> = self.m.actions.iter().filter(named).cloned().collect();
        let several = actions.len() > 1;
        for (i, action) in actions.iter().enumerate() {
            let ForceSource::Tie(tie) = action.source else { continue };
            let is = self.magnitude(&self.m.point(action)).expr();
            if is.uses().len() < 2 {
                continue;
            }
            let tag = if several { (i + 1).to_string() } else { String::new() };
            let symbol = self.new_symbol(&[&tagged(r"\gamma", &tag), &tagged("n", &tag)], "1");
            self.page.draft.settle(symbol, &is);
            self.gammas.push((tie, symbol, is));
        }
    }

    /// Velocity of the point of a force in its own sense, per unit velocity of the lead, by its name if it has one.
    pub fn point(&self, action: &Action) -> Factors {
        let plain = self.m.point(action);
        match self.gammas.iter().find(|(t, ..)| action.source == ForceSource::Tie(*t)) {
            Some((_, symbol, _)) => Factors::of(&(*symbol).into()).signed(sign(self.value(&plain.expr()))),
            None => plain,
        }
    }

    /// What the lead has to accelerate: each mass and moment of inertia times the square of its ratio, common factors in front. The
    /// spin of a slipping body is left out.
    fn effective_mass(&self) -> Expr {
        let coordinates = self.page.draft.scene.coordinates().filter(|c| !self.m.ratio(*c).is_zero());
        let terms: Vec<Factors> = coordinates
            .flat_map(|c| {
                let square = self.m.ratio(c).squared();
                self.m.inertia(c).into_iter().map(move |i| i.times(&square))
            })
            .collect();
        gathered(&terms)
    }

    /// Value of an expression.
    pub fn value(&self, e: &Expr) -> f64 {
        e.value(&self.page.draft.symbols)
    }

    /// A new quantity.
    pub fn new_symbol(&mut self, names: &[&str], unit: &str) -> SymbolId {
        let tex = self.page.draft.free(names);
        let tex = if self.rolled { marked(&tex, r"\mathrm{r}") } else { tex };
        self.page.draft.unknown(&tex, unit)
    }

    /// Magnitude of a quantity: itself where it is positive.
    pub fn size(&self, of: Expr) -> Expr {
        if self.value(&of) < 0.0 { magnitude(of) } else { of }
    }

    /// Magnitude of a ratio.
    pub fn magnitude(&self, ratio: &Factors) -> Factors {
        let size = if self.value(&ratio.expr()) < 0.0 { ratio.opposite() } else { ratio.clone() };
        size.upright(&self.page.draft.symbols)
    }

    /// Distance that the lead goes, a magnitude.
    pub fn distance(&self) -> Expr {
        in_sense(self.s.clone(), self.value(&self.s))
    }

    /// The lead.
    pub fn lead(&self) -> Coordinate {
        self.m.lead
    }

    /// Does the lead move along a line?
    pub fn straight(&self) -> bool {
        self.lead().degree == Degree::Along
    }

    /// Is the freedom of this coordinate its own: the spin of a slipping body?
    pub fn own(&self, c: Coordinate) -> bool {
        c.degree == Degree::Turn && self.m.parts[c.body].slips
    }

    fn start_velocity(&mut self) -> Result<Expr, DerivationStop> {
        let mut v0 = ZERO;
        for start in &self.page.draft.scene.start {
            let Start::Speed(c, num) = start else { return beyond(Beyond::Arrangement) };
            let given = self.page.draft.number(
                *num,
                if c.degree == Degree::Along { "v_0" } else { r"\omega_0" },
                "m/s",
            );
            if given == ZERO {
                continue;
            }
            let ratio = self.m.ratio(*c).clone();
            if ratio.is_zero() || v0 != ZERO {
                return beyond(Beyond::SeveralSpeeds);
            }
            v0 = Factors::of(&given).per(&ratio).expr();
        }
        Ok(v0)
    }

    /// Sense of the motion, kinetic friction with its sign, the sum of the constant forces.
    fn set_out(&mut self, slips: &[(usize, f64)]) -> Result<(), DerivationStop> {
        self.v0 = self.start_velocity()?;
        // Without sliding friction first: it needs the sense.
        let given = self.shares(&[ForceKind::Given]);
        let mut push: f64 = given.iter().map(|(_, e)| self.value(e)).sum();
        if let Some(s) = &self.spring {
            push += self.value(&s.gamma.expr()) * self.value(&s.stiffness) * self.value(&s.stretch);
        }
        let v0 = self.value(&self.v0);
        let slipping =
            self.page.draft.scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. })) && !self.rolled;
        self.sense = if v0 != 0.0 { v0.signum() } else { push.signum() };
        if slipping && v0 == 0.0 {
            // A couple has no share in the path of a centre that slips: friction alone may drive it.
            let rubbed: f64 = slips.iter().map(|(tie, sense)| sense * self.friction_of_slip(*tie)).sum();
            self.sense = (push + rubbed).signum();
        }
        if push == 0.0 && v0 == 0.0 && !slipping {
            return beyond(Beyond::NothingMoves);
        }
        if slipping && (v0 != 0.0 || self.spring.is_some()) {
            return beyond(Beyond::SlipWithSpeed);
        }
        self.rub(slips);
        let all = self.shares(&[ForceKind::Given, ForceKind::Kinetic]);
        self.drive = positive_first(all.into_iter().map(|(_, e)| e).collect());
        Ok(())
    }

    /// Share of the friction of a slipping contact in the equation of the lead, N, if it points up.
    fn friction_of_slip(&mut self, tie: usize) -> f64 {
        let Tie::Slip { body, mu_k, .. } = self.page.draft.scene.ties[tie] else { return 0.0 };
        let mu = self.page.draft.number(mu_k, r"\mu_k", "1");
        match (self.m.action_of(tie), &self.m.parts[body].normal) {
            (Some(action), Some((_, normal))) => {
                self.value(&self.m.point(action).expr()) * self.value(&mu) * self.value(normal)
            }
            _ => 0.0,
        }
    }

    /// Normal forces, and the size and sign of kinetic friction, positive up: of a slide against the motion, of a slip as told.
    fn rub(&mut self, slips: &[(usize, f64)]) {
        for body in 0..self.m.parts.len() {
            if let Some((n, is)) = self.m.parts[body].normal.clone() {
                self.found(of_body(Quantity::Normal, body), n, is);
            }
        }
        for t in 0..self.page.draft.scene.ties.len() {
            let (body, mu, sense) = match self.page.draft.scene.ties[t] {
                Tie::Slip { body, mu_k, .. } if !self.rolled => {
                    (body, mu_k, slips.iter().find(|(s, _)| *s == t).map_or(1.0, |(_, sense)| *sense))
                }
                Tie::Slide { body, mu_k, .. } => {
                    let velocity = self.value(&self.m.parts[body].along.expr()) * self.sense;
                    (body, mu_k, -velocity.signum() * f64::from(self.m.parts[body].up))
                }
                _ => continue,
            };
            let mu = self.page.draft.number(mu, r"\mu_k", "1");
            if let (Some(f), Some((n, _))) = (self.m.force_of(t), self.m.parts[body].normal.clone()) {
                self.found(of_body(Quantity::Friction, body), f, in_sense(mu * n, sense));
            }
        }
    }

    /// What of the forces of these kinds does not drop out, each as its share of the lead's equation.
    pub fn shares(&self, kinds: &[ForceKind]) -> Vec<(Action, Expr)> {
        let mut list: Vec<(Action, Factors)> = Vec::new();
        for action in self.m.actions.iter().filter(|a| kinds.contains(&a.kind)) {
            let share = Factors::of(&action.force).times(&self.point(action));
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

    /// Notes a quantity with what it is equal to.
    pub fn found(&mut self, label: Label, symbol: SymbolId, from: Expr) -> SymbolId {
        self.step(symbol, from);
        self.known.push((label, symbol));
        symbol
    }

    /// A quantity that answers no question.
    pub fn step(&mut self, symbol: SymbolId, from: Expr) {
        self.page.step(symbol, from);
    }

    fn new_found(&mut self, label: Label, names: &[&str], unit: &str, from: Expr) -> SymbolId {
        let symbol = self.new_symbol(names, unit);
        self.found(label, symbol, from)
    }

    fn length(&mut self, num: Num) -> Expr {
        let unit = if self.straight() { "m" } else { "rad" };
        self.page.draft.number(num, "d", unit)
    }

    fn new_way(&mut self, from: Expr) {
        let names: ([&str; 2], &str) =
            if self.straight() { (["s", "s_2"], "m") } else { ([r"\varphi", r"\psi"], "rad") };
        let symbol = self.new_symbol(&names.0, names.1);
        self.step(symbol, from);
        self.s = symbol.into();
    }

    /// The motion up to its end: displacement, speed, acceleration of the lead.
    ///
    /// # Errors
    /// What is not covered.
    pub fn arrive(&mut self) -> Result<(), DerivationStop> {
        let lead = self.lead();
        let (Some(a), Some(v)) = (self.m.acceleration(lead), self.m.speed(lead)) else {
            return beyond(Beyond::Arrangement);
        };
        let (a_label, v_label) =
            (self.of_lead(Quantity::A, Quantity::Alpha), self.of_lead(Quantity::V, Quantity::Omega));
        let per = Factors::of(&self.drive).per(&Factors::of(&self.effective)).expr();
        if self.spring.is_some() {
            return self.arrive_on_spring(a, v);
        }
        match self.page.draft.scene.end {
            End::Travel(_, d) | End::Position(_, d) => {
                let d = self.length(d);
                self.s = match self.page.draft.scene.end {
                    End::Travel(..) => in_sense(d, self.sense),
                    _ => d,
                };
                let push = positive_first(vec![in_sense(self.drive.clone(), self.value(&self.s))]);
                let twice = Factors::of(&(number(2) * self.distance() * push));
                let gained = twice.per(&Factors::of(&self.effective)).expr();
                let before = if self.v0 == ZERO { ZERO } else { square(self.v0.clone()) };
                self.found(v_label, v, root(before + gained));
                self.v = v.into();
                self.found(a_label, a, per);
            }
            End::Time(_, t) => {
                let t = self.page.draft.number(t, "t", "s");
                self.found(a_label, a, per);
                let end = &self.v0 + a * &t;
                let end = in_sense(end.clone(), self.value(&end));
                self.found(v_label, v, end);
                self.v = v.into();
                self.new_way(&self.v0.clone() * &t + ratio(1, 2) * a * square(&t));
            }
            End::Speed(_, u) => {
                let names = if self.straight() { ("v_1", "m/s") } else { (r"\omega_1", "rad/s") };
                let u = self.page.draft.number(u, names.0, names.1);
                self.found(a_label, a, per);
                self.found(v_label, v, u.clone());
                self.new_way((square(&u) - square(&self.v0)) / (number(2) * a));
                self.v = u;
            }
            End::TurningPoint(_) => {
                self.found(a_label, a, per);
                self.found(v_label, v, ZERO);
                self.new_way(-(square(&self.v0) / (number(2) * a)));
                self.v = ZERO;
            }
            End::AtOnce | End::Angle(..) | End::Rolling(_) | End::Leaves(_) => {
                return beyond(Beyond::OtherEnd);
            }
        }
        Ok(())
    }

    fn arrive_on_spring(&mut self, a: SymbolId, v: SymbolId) -> Result<(), DerivationStop> {
        let Some(spring) = self.spring.clone() else { return beyond(Beyond::Arrangement) };
        if self.v0 != ZERO {
            return beyond(Beyond::SpringWithSpeed);
        }
        self.s = match self.page.draft.scene.end {
            End::Travel(_, d) => in_sense(self.length(d), self.sense),
            End::Position(_, x) => self.length(x),
            _ => return beyond(Beyond::SpringWithoutPlace),
        };
        let stretch = self.stretch_at(&self.s.clone());
        let last = match stretch {
            ZERO => ZERO,
            from => {
                let x1 = self.new_symbol(&["x_1", r"x_{\mathrm{e}}"], "m");
                self.step(x1, from);
                x1.into()
            }
        };
        let squares =
            if last == ZERO { square(&spring.stretch) } else { square(&spring.stretch) - square(&last) };
        let others = number(2) * self.distance() * in_sense(self.drive.clone(), self.value(&self.s));
        let twice = positive_first(vec![&spring.stiffness * squares, others]);
        self.found(self.of_lead(Quantity::V, Quantity::Omega), v, root(twice / &self.effective));
        self.v = v.into();
        self.found(of_tie(Quantity::Tension, spring.tie), spring.tension, &spring.stiffness * last);
        let pull = Factors::of(&spring.tension.into()).times(&spring.gamma).expr();
        let now = positive_first(vec![pull, self.drive.clone()]);
        self.found(self.of_lead(Quantity::A, Quantity::Alpha), a, now / &self.effective);
        Ok(())
    }

    /// The label of the lead: this for a line, that for a turn.
    pub fn of_lead(&self, line: Quantity, spin: Quantity) -> Label {
        of_body(if self.straight() { line } else { spin }, self.lead().body)
    }

    /// Stretch of the spring after this displacement of the lead; 0 where its cord is slack.
    pub fn stretch_at(&self, s: &Expr) -> Expr {
        let Some(spring) = &self.spring else { return ZERO };
        let stretch = &spring.stretch - spring.gamma.times(&Factors::of(s)).expr();
        let slack = SLACK * self.value(&spring.stretch).abs();
        if !spring.rigid && self.value(&stretch) < slack { ZERO } else { stretch }
    }

    /// The reactions in the order in which they leave the equations, and the row that is left: each from a row in which it is the
    /// only one, moments first.
    ///
    /// # Errors
    /// Only several equations together give a reaction.
    pub fn elimination(&self) -> Result<(Vec<Eliminated>, Coordinate), DerivationStop> {
        let mut rows: Vec<Coordinate> =
            self.page.draft.scene.coordinates().filter(|c| !self.own(*c)).collect();
        rows.sort_by_key(|c| c.degree == Degree::Along);
        let mut gone: Vec<Eliminated> = Vec::new();
        let mut ties: Vec<usize> = Vec::new();
        while rows.len() > 1 {
            let open = |c: &Coordinate| -> Vec<(Action, usize)> {
                let reaction = |a: &Action| match (a.kind, a.source) {
                    (ForceKind::Reaction, ForceSource::Tie(t)) if !ties.contains(&t) => Some(t),
                    _ => None,
                };
                self.row(*c).into_iter().filter_map(|(a, _)| reaction(&a).map(|t| (a, t))).collect()
            };
            let Some(at) = rows.iter().position(|c| open(c).len() == 1) else {
                return beyond(Beyond::SeveralEquations);
            };
            let c = rows.remove(at);
            let (action, tie) = open(&c).remove(0);
            let Some(force) = self.m.force_of(tie) else { return beyond(Beyond::Arrangement) };
            let is = self.solved(c, &action, self.gain(c))?;
            gone.push(Eliminated { row: c, force, is });
            ties.push(tie);
        }
        rows.pop().map(|last| (gone, last)).ok_or_else(|| Beyond::Arrangement.into())
    }

    /// A row, solved for one of its forces, its inertia term given.
    fn solved(&self, c: Coordinate, action: &Action, gain: Expr) -> Result<Expr, DerivationStop> {
        let lever = self.m.lever(action, c).clone();
        let mut rest = vec![gain];
        let others = self.row(c).into_iter().filter(|(a, _)| a.source != action.source);
        rest.extend(others.map(|(_, share)| -share));
        let over = positive_first(vec![in_sense(sum(rest), self.value(&lever.expr()))]);
        let lever = self.magnitude(&lever);
        if lever.is_zero() { beyond(Beyond::Arrangement) } else { Ok(Factors::of(&over).per(&lever).expr()) }
    }

    /// `m a` or `I a/r` of a coordinate: what its forces amount to, with the acceleration of its body's line or of the lead.
    pub fn gain(&self, c: Coordinate) -> Expr {
        let part = &self.m.parts[c.body];
        let (by, ratio) = match (c.degree, part.a, self.m.acceleration(self.lead())) {
            (_, Some(a), _) if !part.along.is_zero() && !self.own(c) => (a, self.m.ratio(c).per(&part.along)),
            (_, _, Some(lead)) => (lead, self.m.ratio(c).clone()),
            _ => return ZERO,
        };
        let by = Factors::of(&by.into()).times(&ratio);
        sum(self.m.inertia(c).iter().map(|i| i.times(&by).expr()))
    }

    /// A quantity: looked up, or derived.
    ///
    /// # Errors
    /// What is not covered.
    pub fn get(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some((_, symbol)) = self.known.iter().find(|(l, _)| *l == label) {
            return Ok(*symbol);
        }
        let body = match label.of {
            Owner::Body(b) => b,
            _ => self.lead().body,
        };
        match label.quantity {
            Quantity::A | Quantity::Alpha => self.acceleration(label, body),
            Quantity::V | Quantity::Omega => self.speed(label, body),
            Quantity::Phi => self.angle(body, label),
            Quantity::Displacement => {
                let from = Factors::of(&self.s).times(&self.m.parts[body].along).expr();
                Ok(self.new_found(label, &[r"\Delta x"], "m", from))
            }
            Quantity::Rise => {
                let tag = self.tag(body, |p| p.a.is_some());
                let climb = self.m.actions.iter().find(|a| a.source == ForceSource::Weight(body));
                let climb = climb.map_or_else(Factors::zero, |a| a.along.opposite());
                let from = Factors::of(&self.s).times(&self.m.parts[body].along).times(&climb).expr();
                Ok(self.new_found(label, &[&tagged("h", &tag), &tagged("y", &tag)], "m", from))
            }
            Quantity::Friction | Quantity::Tension => self.reaction(label, body),
            Quantity::MuRequired => self.least_grip(body, label),
            Quantity::T => self.time(label),
            Quantity::CordTravel => self.cord_travel(label),
            Quantity::WorkPull | Quantity::PowerPull => self.pull(label),
            Quantity::KineticEnergy => {
                let from = self.kinetic_sum()?;
                Ok(self.new_found(label, &["E_{k}", r"E_{\mathrm{kin}}"], "J", from))
            }
            Quantity::RotationalFraction => self.rotational(label),
            Quantity::SlipDistance => self.slip_distance(body, label),
            Quantity::Heat => self.heat(label),
            Quantity::KBound => self.bound_of_gyration(body, label),
            Quantity::XEq => {
                let Some(spring) = self.spring.clone() else { return beyond(Beyond::Arrangement) };
                let per = Factors::of(&spring.stiffness).times(&spring.gamma);
                let from = Factors::of(&(-&self.drive)).per(&per).expr();
                Ok(self.new_found(label, &[r"x_{\mathrm{eq}}"], "m", from))
            }
            Quantity::VMax | Quantity::DAtVMax => self.fastest(label),
            Quantity::DTurn => self.turning(label),
            other => beyond(Beyond::Quantity(other)),
        }
    }

    fn tag(&self, body: usize, has: impl Fn(&crate::solution::terms::BodyTerms) -> bool) -> String {
        let several = self.m.parts.iter().filter(|p| has(p)).count() > 1;
        if several { self.m.parts[body].tag.clone() } else { String::new() }
    }

    /// Another acceleration than the lead's, by its ratio; that of a slipping body's spin from its own equation.
    fn acceleration(&mut self, label: Label, body: usize) -> Result<SymbolId, DerivationStop> {
        let c = if label.quantity == Quantity::A { along(body) } else { turn(body) };
        let Some(symbol) = self.m.acceleration(c) else { return beyond(Beyond::Arrangement) };
        if self.own(c) {
            let over = positive_first(self.row(c).into_iter().map(|(_, e)| e).collect());
            let from = Factors::of(&over).per(&Factors::of(&self.m.inertia_expr(c))).expr();
            return Ok(self.found(label, symbol, from));
        }
        let by = self.get(self.of_lead(Quantity::A, Quantity::Alpha))?;
        let from = Factors::of(&by.into()).times(self.m.ratio(c)).expr();
        Ok(self.found(label, symbol, from))
    }

    fn speed(&mut self, label: Label, body: usize) -> Result<SymbolId, DerivationStop> {
        let c = if label.quantity == Quantity::V { along(body) } else { turn(body) };
        let Some(symbol) = self.m.speed(c) else { return beyond(Beyond::Arrangement) };
        let from = if self.own(c) {
            // Both accelerations are constant and both motions start from rest.
            let alpha = self.get(of_body(Quantity::Alpha, body))?;
            let a = self.get(of_body(Quantity::A, body))?;
            let v = self.get(of_body(Quantity::V, body))?;
            let turned = self.value(&alpha.into()) * self.value(&a.into());
            in_sense(alpha / a * v, turned)
        } else {
            Factors::of(&self.v).times(&self.magnitude(self.m.ratio(c))).expr()
        };
        Ok(self.found(label, symbol, from))
    }

    fn angle(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let tag = self.tag(body, |p| p.alpha.is_some());
        let from = if self.own(turn(body)) {
            let alpha = self.get(of_body(Quantity::Alpha, body))?;
            let a = self.get(of_body(Quantity::A, body))?;
            let sense = self.value(&alpha.into()) * self.value(&a.into());
            let way = Factors::of(&self.distance()).times(&self.magnitude(&self.m.parts[body].along)).expr();
            in_sense(alpha / a, sense) * way
        } else {
            Factors::of(&self.distance()).times(&self.magnitude(&self.m.parts[body].turn)).expr()
        };
        Ok(self.new_found(label, &[&tagged(r"\varphi", &tag), &tagged(r"\psi", &tag)], "rad", from))
    }

    fn label_of_tie(&self, tie: usize) -> Label {
        match &self.page.draft.scene.ties[tie] {
            Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => {
                of_body(Quantity::Friction, *body)
            }
            Tie::Cord(_) => of_tie(Quantity::Tension, tie),
        }
    }

    /// The contact of a body.
    pub fn contact_of(&self, body: usize) -> Option<usize> {
        self.page.draft.scene.ties.iter().position(|t| match t {
            Tie::Roll { body: b, .. } | Tie::Slip { body: b, .. } | Tie::Slide { body: b, .. } => *b == body,
            Tie::Cord(_) => false,
        })
    }

    /// A reaction: from the row in which it is the only unknown left, others first where need be.
    fn reaction(&mut self, label: Label, body: usize) -> Result<SymbolId, DerivationStop> {
        let tie = match label.of {
            Owner::Tie(t) => Some(t),
            _ => self.contact_of(body),
        };
        let Some(tie) = tie else { return beyond(Beyond::Arrangement) };
        // Each would need the other first.
        if self.solving.contains(&tie) {
            return beyond(Beyond::SeveralEquations);
        }
        self.solving.push(tie);
        // The row that asks for the fewest other reactions; lines before turns.
        let mut best: Option<(usize, Coordinate, Action, Vec<usize>)> = None;
        for c in self.page.draft.scene.coordinates() {
            let row = self.row(c);
            let Some((action, _)) = row.iter().find(|(a, _)| a.source == ForceSource::Tie(tie)) else {
                continue;
            };
            let known = |t: usize| self.known.iter().any(|(l, _)| *l == self.label_of_tie(t));
            let others: Vec<usize> = row
                .iter()
                .filter_map(|(a, _)| match (a.kind, a.source) {
                    (ForceKind::Reaction, ForceSource::Tie(t)) if t != tie && !known(t) => Some(t),
                    _ => None,
                })
                .collect();
            if others.iter().any(|t| self.solving.contains(t)) {
                continue;
            }
            let price = 2 * others.len() + usize::from(c.degree == Degree::Turn);
            if best.as_ref().is_none_or(|(p, ..)| price < *p) {
                best = Some((price, c, action.clone(), others));
            }
        }
        let Some((_, c, action, others)) = best else { return beyond(Beyond::SeveralEquations) };
        for other in others {
            self.get(self.label_of_tie(other))?;
        }
        if self.m.parts[c.body].a.is_some() && !self.m.parts[c.body].along.is_zero() {
            self.get(of_body(Quantity::A, c.body))?;
        }
        let from = self.solved(c, &action, self.gain(c))?;
        let Some(symbol) = self.m.force_of(tie) else { return beyond(Beyond::Arrangement) };
        self.solving.pop();
        Ok(self.found(self.label_of_tie(tie), symbol, from))
    }

    fn least_grip(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let n = self.get(of_body(Quantity::Normal, body))?;
        let most = match self.spring {
            Some(_) => {
                let [one, other] = self.extremes(body)?;
                let larger = self.value(&one.1.into()).abs() >= self.value(&other.1.into()).abs();
                if larger { one.1 } else { other.1 }
            }
            None => {
                // Kinetic friction says nothing of the grip that rolling needs.
                let rolling = self.page.draft.found_for(of_body(Quantity::FrictionIfRolled, body));
                match rolling {
                    Some(DerivedAnswer::Value(f)) if self.m.parts[body].slips => f,
                    _ => self.get(of_body(Quantity::Friction, body))?,
                }
            }
        };
        let size = self.size(most.into());
        Ok(self.new_found(label, &[r"\mu_{\mathrm{min}}"], "1", size / n))
    }

    /// Friction on a body at release and at the far end of what the conditions look at, for a wheel on a spring, each with the
    /// stretch there, m: it is linear in the tension, so one of them is the largest.
    ///
    /// # Errors
    /// What is not covered.
    pub fn extremes(&mut self, body: usize) -> Result<[(f64, SymbolId); 2], DerivationStop> {
        let far = match self.page.draft.scene.span {
            Span::ToEnd if self.s != ZERO => self.s.clone(),
            _ => self.turning_or_slack()?.0,
        };
        let first = self.friction_at(body, &ZERO, "0")?;
        let last = if far == self.s {
            let now = self.get(of_body(Quantity::Friction, body))?;
            (self.value(&self.stretch_at(&far)), now)
        } else {
            self.friction_at(body, &far, "2")?
        };
        Ok([first, last])
    }

    /// How far it would go to its turning point while the cord is taut, or where the cord goes slack, if that comes first; and
    /// whether it does.
    fn turning_or_slack(&self) -> Result<(Expr, bool), DerivationStop> {
        let Some(spring) = &self.spring else { return beyond(Beyond::Arrangement) };
        let kappa = Factors::of(&spring.stiffness).times(&spring.gamma.squared()).expr();
        let pull = Factors::of(&spring.stiffness).times(&spring.gamma).times(&Factors::of(&spring.stretch));
        let turn = number(2) * positive_first(vec![pull.expr(), self.drive.clone()]) / kappa;
        let slack = Factors::of(&spring.stretch).per(&spring.gamma).expr();
        let (t, s) = (self.value(&turn), self.value(&slack));
        let goes_slack = !spring.rigid && s * t > 0.0 && s.abs() < t.abs();
        Ok(if goes_slack { (slack, true) } else { (turn, false) })
    }

    /// Friction on a rolling body where the lead has moved by `s`: that at the end, moved along with the tension.
    fn friction_at(&mut self, body: usize, s: &Expr, mark: &str) -> Result<(f64, SymbolId), DerivationStop> {
        let Some(spring) = self.spring.clone() else { return beyond(Beyond::Arrangement) };
        let now = self.get(of_body(Quantity::Friction, body))?;
        let stretch = self.stretch_at(s);
        let rate = self.friction_per_tension(body, spring.tie)?;
        let tex = marked(self.page.draft.symbols.tex(now), mark);
        let symbol = self.page.draft.symbols.unknown_like(&tex, now);
        let less = &spring.stiffness * &stretch - spring.tension;
        self.step(symbol, now + Factors::of(&rate).times(&Factors::of(&less)).expr());
        Ok((self.value(&stretch), symbol))
    }

    /// By how much the friction on a body grows with the tension of a cord: from its closed form.
    fn friction_per_tension(&mut self, body: usize, tie: usize) -> Result<Expr, DerivationStop> {
        let Some(closed) = self.closed_friction(body) else { return beyond(Beyond::Arrangement) };
        let own = closed.terms.iter().find(|(a, _)| a.source == ForceSource::Tie(tie));
        let over = own.map_or_else(Factors::zero, |(_, over)| over.clone());
        Ok(over.per(&closed.under).expr())
    }

    /// The friction of a single rolling body as the sum of its forces, each with its factor: `F (c^2 + j) = sum S (c p - j e)`,
    /// `j = I/m`. From `m a = sum S e + F` and `I a/c = sum S p - F c`.
    pub fn closed_friction(&mut self, body: usize) -> Option<ClosedFriction> {
        let part = self.m.parts.get(body)?.clone();
        let tied = |a: &Action| a.kind == ForceKind::Reaction && !a.contact;
        let tie = self.contact_of(body)?;
        let rolls = matches!(self.page.draft.scene.ties[tie], Tie::Roll { .. }) || self.rolled;
        if !rolls || part.mass.is_zero() || self.m.actions.iter().any(|a| a.body == body && tied(a)) {
            return None;
        }
        let c = self.magnitude(&self.m.action_of(tie)?.arm);
        let mut j = Factors::zero();
        for i in &part.inertia {
            j = j.plus(&i.per(&part.mass));
        }
        let up = part.up;
        let mut terms = Vec::new();
        for action in self.m.actions.iter().filter(|a| a.body == body && !a.contact) {
            let lever = c.times(&action.arm).plus(&j.times(&action.along).opposite()).signed(up);
            if !lever.is_zero() {
                terms.push((action.clone(), lever));
            }
        }
        terms.sort_by_key(|(a, _)| rank(a));
        Some(ClosedFriction { terms, under: c.squared().plus(&j) })
    }

    fn time(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if self.spring.is_some() {
            return beyond(Beyond::SpringTime);
        }
        if let End::Time(_, t) = self.page.draft.scene.end {
            let t = self.page.draft.number(t, "t", "s");
            return Ok(self.new_found(label, &["t", "t_2"], "s", t));
        }
        let a = self.get(self.of_lead(Quantity::A, Quantity::Alpha))?;
        let from = if self.value(&a.into()) == 0.0 {
            &self.s / &self.v0
        } else if self.v0 == ZERO {
            number(2) * self.distance() / &self.v
        } else {
            (in_sense(self.v.clone(), self.sense) - &self.v0) / a
        };
        Ok(self.new_found(label, &["t", "t_2"], "s", from))
    }

    fn several_pulls(&self) -> bool {
        let pulled =
            |t: &&Tie| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_) | Far::Spring { .. }));
        self.page.draft.scene.ties.iter().filter(pulled).count() > 1
    }

    fn cord_of(&self, label: Label) -> Result<(usize, Action), DerivationStop> {
        let Owner::Tie(t) = label.of else { return beyond(Beyond::Arrangement) };
        self.m.action_of(t).map_or_else(|| beyond(Beyond::Arrangement), |a| Ok((t, a.clone())))
    }

    /// Travel (or velocity) of a cord's end on a slipping body, in the sense of the pull: that of the centre, and that of the turn.
    fn on_slipping(&self, action: &Action, centre: Expr, turned: Expr) -> Expr {
        let part = &self.m.parts[action.body];
        let along = Factors::of(&centre).times(&action.along.times(&part.along)).signed(sign(self.sense));
        let spin = self.spin_sense(action.body);
        let turn = Factors::of(&turned).times(&action.arm).signed(sign(spin));
        positive_first(vec![along.expr(), turn.expr()])
    }

    fn cord_travel(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let tag = if self.several_pulls() { (t + 1).to_string() } else { String::new() };
        let from = if self.m.parts[action.body].slips {
            let phi = self.get(of_body(Quantity::Phi, action.body))?;
            let travel = self.on_slipping(&action, self.distance(), phi.into());
            positive_first(vec![in_sense(travel.clone(), self.value(&travel))])
        } else {
            Factors::of(&self.distance()).times(&self.magnitude(&self.point(&action))).expr()
        };
        Ok(self.new_found(label, &[&tagged(r"\ell", &tag), &tagged("L", &tag)], "m", from))
    }

    fn pull(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let work = label.quantity == Quantity::WorkPull;
        let tag = if self.several_pulls() { (t + 1).to_string() } else { "P".to_owned() };
        let name = if work { "W" } else { r"\dot{W}" };
        let slips = self.m.parts[action.body].slips;
        let rate = match (work, slips) {
            (true, false) => {
                let travel = self.get(of_tie(Quantity::CordTravel, t))?;
                let helps = self.value(&self.point(&action).expr()) * self.value(&self.s);
                in_sense(travel.into(), helps)
            }
            (true, true) => {
                let phi = self.get(of_body(Quantity::Phi, action.body))?;
                self.on_slipping(&action, self.distance(), phi.into())
            }
            (false, false) => {
                let point = self.point(&action).signed(sign(self.sense));
                Factors::of(&self.v).times(&point).expr()
            }
            (false, true) => {
                let v = self.get(of_body(Quantity::V, action.body))?;
                let omega = self.get(of_body(Quantity::Omega, action.body))?;
                self.on_slipping(&action, v.into(), omega.into())
            }
        };
        let from = Factors::of(&action.force).times(&Factors::of(&rate)).expr();
        Ok(self.new_found(label, &[&tagged(name, &tag)], if work { "J" } else { "W" }, from))
    }

    /// Kinetic energy: each mass and moment of inertia with its own speed.
    fn kinetic_sum(&mut self) -> Result<Expr, DerivationStop> {
        let mut all = Vec::new();
        for c in self.page.draft.scene.coordinates() {
            let quantity = if c.degree == Degree::Along { Quantity::V } else { Quantity::Omega };
            let inertia = self.m.inertia(c);
            if inertia.is_empty() || (self.m.ratio(c).is_zero() && !self.own(c)) {
                continue;
            }
            let v = self.get(of_body(quantity, c.body))?;
            all.extend(
                inertia
                    .iter()
                    .map(|i| i.times(&Factors::of(&square(v))).times(&Factors::of(&ratio(1, 2))).expr()),
            );
        }
        Ok(sum(all))
    }

    fn rotational(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let mut turning = Vec::new();
        let slips = self.m.parts.iter().any(|p| p.slips);
        for body in 0..self.m.parts.len() {
            let c = turn(body);
            for i in self.m.inertia(c) {
                if slips {
                    let omega = self.get(of_body(Quantity::Omega, body))?;
                    turning.push(ratio(1, 2) * i.expr() * square(omega));
                } else {
                    turning.push(i.times(&self.m.ratio(c).squared()).expr());
                }
            }
        }
        // The speed cancels in the share.
        let whole =
            if slips { self.get(of_scene(Quantity::KineticEnergy))?.into() } else { self.effective.clone() };
        let from = Factors::of(&sum(turning)).per(&Factors::of(&whole)).expr();
        Ok(self.new_found(label, &[r"\eta", r"\beta"], "1", from))
    }

    /// Sense in which a slipping body turns.
    fn spin_sense(&self, body: usize) -> f64 {
        let over = sum(self.row(turn(body)).into_iter().map(|(_, e)| e));
        if self.value(&over) < 0.0 { -1.0 } else { 1.0 }
    }

    fn slip_distance(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let radius = self.page.draft.scene.ties.iter().find_map(|tie| match tie {
            Tie::Slip { body: b, radius_m, .. } if *b == body => Some(*radius_m),
            _ => None,
        });
        let Some(radius) = radius else { return beyond(Beyond::Arrangement) };
        let c = self.page.draft.number(radius, "R", "m");
        let phi = self.get(of_body(Quantity::Phi, body))?;
        let way = Factors::of(&self.s).times(&self.m.parts[body].along).expr();
        let from = way - in_sense(c * phi, self.spin_sense(body));
        let from = positive_first(vec![in_sense(from.clone(), self.value(&from))]);
        Ok(self.new_found(label, &[r"\delta", r"\Delta"], "m", from))
    }

    fn heat(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let mut all = Vec::new();
        for tie in &self.page.draft.scene.ties {
            let (body, way) = match tie {
                Tie::Slip { body, .. } => (*body, self.get(of_body(Quantity::SlipDistance, *body))?.into()),
                Tie::Slide { body, .. } => {
                    let ratio = self.magnitude(&self.m.parts[*body].along);
                    (*body, Factors::of(&self.distance()).times(&ratio).expr())
                }
                _ => continue,
            };
            let f = self.get(of_body(Quantity::Friction, body))?;
            let size = self.size(f.into());
            all.push(size * way);
        }
        Ok(self.new_found(label, &["Q", r"Q_{\mathrm{th}}"], "J", sum(all)))
    }

    /// With F = 0: `a = X/m`, `alpha = M/(m k^2)` and `a = c alpha`.
    fn bound_of_gyration(&mut self, body: usize, label: Label) -> Result<SymbolId, DerivationStop> {
        let c = self.page.draft.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { radius_m, .. } => Some(*radius_m),
            _ => None,
        });
        let Some(c) = c else { return beyond(Beyond::NoBound) };
        let c = self.page.draft.number(c, "R", "m");
        let share = |task: &Self, c: Coordinate| {
            let given = task.row(c).into_iter().filter(|(a, _)| a.kind == ForceKind::Given);
            sum(given.map(|(_, e)| e))
        };
        let (force, moment) = (share(self, along(body)), share(self, turn(body)));
        let up = f64::from(self.m.parts[body].up);
        if self.value(&force) * up <= 0.0 || self.value(&moment) * up <= 0.0 {
            return beyond(Beyond::NoBound);
        }
        Ok(self.new_found(label, &["k_{0}"], "m", root(c * moment / force)))
    }

    /// The greatest speed of a motion, and where it is.
    fn fastest(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let body = self.lead().body;
        let (at, top) = (of_body(Quantity::DAtVMax, body), of_body(Quantity::VMax, body));
        let Some(spring) = self.spring.clone() else {
            // Thrown against a constant force: fastest at the start.
            if self.value(&self.drive) * self.sense > 0.0 {
                return beyond(Beyond::NeverFastest);
            }
            let size = in_sense(self.v0.clone(), self.sense);
            self.new_found(top, &[r"v_{\mathrm{max}}"], "m/s", size);
            self.new_found(at, &["D_{v}"], "m", ZERO);
            return self.get(label);
        };
        let x_eq = self.get(of_scene(Quantity::XEq))?;
        if !spring.rigid && self.value(&x_eq.into()) < 0.0 {
            return beyond(Beyond::FastestSlack);
        }
        let gap = &spring.stretch - x_eq;
        let gap = positive_first(vec![in_sense(gap.clone(), self.value(&gap))]);
        let per = self.magnitude(&spring.gamma);
        self.new_found(at, &["D_{v}"], "m", Factors::of(&gap).per(&per).expr());
        let from = gap * root(&spring.stiffness / &self.effective);
        self.new_found(top, &[r"v_{\mathrm{max}}"], "m/s", from);
        self.get(label)
    }

    fn turning(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        let names = [r"D_{\mathrm{t}}"];
        let against = in_sense(self.drive.clone(), self.value(&self.drive));
        let Some(spring) = self.spring.clone() else {
            if self.value(&self.drive) * self.sense >= 0.0 {
                return beyond(Beyond::NeverTurns);
            }
            let over = &self.effective * square(&self.v0);
            return Ok(self.new_found(label, &names, "m", over / (number(2) * against)));
        };
        let (far, slack) = self.turning_or_slack()?;
        if !slack {
            let from = in_sense(far.clone(), self.value(&far));
            return Ok(self.new_found(label, &names, "m", from));
        }
        // Slack: all that the spring stored goes into what the other forces take up to the turning point.
        if self.value(&self.drive) * self.value(&far) >= 0.0 {
            return beyond(Beyond::NeverTurns);
        }
        let over = &spring.stiffness * square(&spring.stretch);
        Ok(self.new_found(label, &names, "m", over / (number(2) * against)))
    }
}

/// The friction of a single rolling body, `sum S over / under`.
#[derive(Debug, Clone)]
pub struct ClosedFriction {
    /// Each force with what stands over.
    pub terms: Vec<(Action, Factors)>,
    /// What stands under all.
    pub under: Factors,
}

impl ClosedFriction {
    /// As an expression.
    pub fn expr(&self) -> Expr {
        let over = |(a, lever): &(Action, Factors)| Factors::of(&a.force).times(lever);
        match self.under.expr() {
            Expr::Sum(_) => {
                let terms = self.terms.iter().map(|t| over(t).expr()).collect();
                positive_first(terms) / self.under.expr()
            }
            _ => positive_first(self.terms.iter().map(|t| over(t).per(&self.under).expr()).collect()),
        }
    }
}

/// The sum of these, with the factors that all have in front: `m (1 + k^2/r^2)`.
pub fn gathered(terms: &[Factors]) -> Expr {
    let [first, others @ ..] = terms else { return ZERO };
    if others.is_empty() {
        return first.expr();
    }
    let common = others.iter().fold(first.clone(), |common, t| common.shared(t));
    if common.is_one() {
        return sum(terms.iter().map(Factors::expr));
    }
    let inner = terms.iter().map(|t| t.per(&common));
    if inner.clone().all(|i| i.is_number()) {
        let whole = terms.iter().skip(1).fold(first.clone(), |all, t| all.plus(t));
        return whole.expr();
    }
    common.expr() * sum(inner.map(|i| i.expr()))
}

/// A symbol with a mark below it, behind what stands there already.
pub fn marked(tex: &str, mark: &str) -> String {
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
