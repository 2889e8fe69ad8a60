//! What follows from the terms of a scene of lines and axles: the motion, and each further quantity on demand, as an
//! expression in symbols. Nothing is worded here; [`crate::solution::narrate`] tells it.
use crate::scene::{
    AsIf, Coordinate, Degree, End, Far, GivenForce, Grows, Label, Num, Owner, Quantity, Span, SpringTie, Tie,
};
use crate::solution::draft::{Draft, tex_of};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, arc_cosine, cosine, in_sense, magnitude, number, positive_first, power, ratio,
    root, square, sum,
};
use crate::solution::factors::{Cancel, Factors, Sum};
use crate::solution::narrate::Short;
use crate::solution::order::{Found, Row, needed};
use crate::solution::page::Page;
use crate::solution::stop::{Beyond, DerivationStop, unfound};
use crate::solution::terms::{
    Action, BodyTerms, Carrying, ForceKind, ForceSource, Freedom, Terms, mark_of, tagged,
};

/// The spring of a scene.
#[derive(Debug, Clone)]
pub struct CordSpring {
    /// Index of its tie.
    pub tie: usize,
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

/// A given force that grows.
#[derive(Debug, Clone)]
pub struct GrownForce {
    /// Which.
    pub source: ForceSource,
    /// At the start.
    pub first: Expr,
    /// At the end.
    pub last: SymbolId,
    /// Its mean over the way, if it grows with place, until [`Account::grow_up`].
    pub mean: Option<SymbolId>,
}

/// The angular frequency of a swing on a spring.
pub const OMEGA_SWING: &str = r"\omega_{\mathrm{s}}";
/// The time after which its cord goes slack.
pub const TIME_SLACK: &str = r"t_{\mathrm{s}}";

/// Names and units of a speed and a spin of the start.
pub const START_NAMES: [(&str, &str); 2] = [("v_0", "m/s"), (r"\omega_0", "rad/s")];

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
    /// The springs whose ends move.
    pub springs: Vec<CordSpring>,
    /// The only one, or one that acts on the lead like all of them together.
    pub spring: Option<CordSpring>,
    /// Stiffness and stretch of the latter.
    pub together_as: Vec<(SymbolId, Expr)>,
    /// The stretch of [`Self::spring`] at the end.
    pub last: Expr,
    /// Forces that grow with time, and the acceleration of the lead at the start then.
    pub grown: Vec<GrownForce>,
    /// See [`Self::grown`].
    pub first_rate: Option<SymbolId>,
    /// Velocity of the point of contact at the start, of a body thrown with slip.
    pub slip: Option<SymbolId>,
    /// Which way comes first.
    pub short: Short,
    /// Does a thrown body still slip at the time that is asked?
    pub still_slips: bool,
    /// Are the ratios of displacements on the page?
    pub ratios_told: bool,
    known: Vec<(Label, SymbolId)>,
    /// What is seen from the ground of what is carried.
    seen: Vec<(Label, SymbolId)>,
}

/// The symbols of a quantity that is not among the terms; the first that is free is taken.
const fn names_of(quantity: Quantity) -> [&'static str; 2] {
    match quantity {
        Quantity::A => ["a", "a_G"],
        Quantity::ARolling => [r"a_{\mathrm{r}}", "a_2"],
        Quantity::V => ["v", "u"],
        Quantity::T => ["t", "t_2"],
        Quantity::Displacement => [r"\Delta x", r"\Delta x_G"],
        Quantity::Distance => ["d", "D"],
        Quantity::Rise => ["h", "y"],
        Quantity::Phi => [r"\varphi", r"\psi"],
        Quantity::CordTravel => [r"\ell", "L"],
        Quantity::SlipDistance => [r"\delta", r"\Delta"],
        Quantity::AngularMomentum => ["L", r"\Lambda"],
        Quantity::Impulse => ["J", "S"],
        Quantity::Work => ["W", "A_{W}"],
        Quantity::WorkPull => ["W", "A"],
        Quantity::PowerPull => [r"\dot{W}", r"\dot{A}"],
        Quantity::WorkCouple => ["W_{M}", "A_{M}"],
        Quantity::PowerCouple => [r"\dot{W}_{M}", r"\dot{A}_{M}"],
        Quantity::Heat => ["Q", r"Q_{\mathrm{th}}"],
        Quantity::KineticEnergy => ["E_{k}", r"E_{\mathrm{kin}}"],
        Quantity::RotationalFraction => [r"\eta", r"\beta"],
        Quantity::MuRequired => [r"\mu_{\mathrm{min}}", r"\mu_{\mathrm{m}}"],
        Quantity::KBound => ["k_{0}", "k_{1}"],
        Quantity::XEq => [r"x_{\mathrm{eq}}", "x_{0}"],
        Quantity::VMax => [r"v_{\mathrm{max}}", "v_{m}"],
        Quantity::DAtVMax => ["D_{v}", "d_{v}"],
        Quantity::DTurn => [r"D_{\mathrm{t}}", r"d_{\mathrm{t}}"],
        Quantity::OmegaSmall => [r"\Omega", r"\omega_s"],
        Quantity::PeriodSmall => [r"\tau_0", r"\tau_s"],
        Quantity::PinX => ["O_x", "R_x"],
        Quantity::PinY => ["O_y", "R_y"],
        Quantity::PinForce => ["O", "F_O"],
        Quantity::PinAngle => [r"\psi", r"\chi"],
        _ => ["Z", "Y"],
    }
}

/// A body's label.
pub const fn of_body(quantity: Quantity, body: usize) -> Label {
    Label { quantity, of: Owner::Body(body) }
}

/// A tie's label.
pub const fn of_tie(quantity: Quantity, tie: usize) -> Label {
    Label { quantity, of: Owner::Tie(tie) }
}

/// The acceleration of a coordinate.
pub const fn rate_of(c: Coordinate) -> Label {
    of_body(if matches!(c.degree, Degree::Along) { Quantity::A } else { Quantity::Alpha }, c.body)
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

/// The coordinate that a quantity of a body is of: its line or its turn.
const fn coordinate(quantity: Quantity, body: usize) -> Coordinate {
    match quantity {
        Quantity::A | Quantity::V | Quantity::Displacement | Quantity::Distance => along(body),
        _ => turn(body),
    }
}

/// What may have a symbol before it is asked.
const SAME: [Quantity; 3] = [Quantity::FrictionIfRolled, Quantity::OmegaSmall, Quantity::T];

stands_on!(Account.page: Page<'d, 'a>);

impl<'d, 'a> Account<'d, 'a> {
    /// Sets out: terms, senses, start.
    pub fn new(draft: &'d mut Draft<'a>) -> Result<Self, DerivationStop> {
        let m = Terms::new(draft);
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
            springs: Vec::new(),
            spring: None,
            together_as: Vec::new(),
            last: ZERO,
            grown: Vec::new(),
            first_rate: None,
            slip: None,
            short: Short::Instant,
            still_slips: false,
            ratios_told: false,
            known: Vec::new(),
            seen: Vec::new(),
        };
        // What is only supposed to roll has no names of its own.
        if this.rolled.is_none() {
            this.name_ratios();
        }
        for SpringTie { tie, stiffness_n_m, stretch_m, rigid, .. } in this.scene.springs() {
            let stiffness = this.number(stiffness_n_m, "k_s", "N/m");
            let stretch = this.number(stretch_m, "x_0", "m");
            let (Some(action), Some(tension)) = (this.m.action_of(tie).cloned(), this.m.force_of(tie)) else {
                return unfound();
            };
            let gamma = this.point(&action);
            if gamma.is_zero() {
                // Its end does not move, so it pulls all the time as it does at the start.
                let pull = &stiffness * &stretch;
                this.found(of_tie(Quantity::Tension, tie), tension, pull);
                continue;
            }
            this.springs.push(CordSpring { tie, stiffness, stretch, rigid, gamma, tension });
        }
        this.spring = this.all_springs();
        this.grow();
        // Common factors are in front; the spin of a slipping body is left out, as it has no ratio.
        this.effective = this.scene.coordinates().flat_map(|c| this.reckoned(c)).collect::<Sum>().expr();
        this.set_out()?;
        Ok(this)
    }

    /// What grows has a symbol for its value at the end, which is that of the equations of motion; with place also one for its mean.
    fn grow(&mut self) {
        for growth in &self.scene.growths {
            let (source, unit) = match growth.of {
                GivenForce::Pull(tie) => (ForceSource::Tie(tie), "N"),
                GivenForce::Couple(couple) => (ForceSource::Couple(couple), "N m"),
            };
            let Some(action) = self.m.actions.iter().find(|a| a.source == source).cloned() else { continue };
            let first = action.force.clone();
            let extent = match self.scene.end {
                End::Time(_, t) => self.number(t, "t", "s"),
                End::Travel(_, d) | End::Position(_, d) => {
                    let own = self.magnitude(&self.point(&action));
                    let way = self.length(d);
                    self.positive(&way).by(own)
                }
                _ => continue,
            };
            let rate = self.number(growth.rate, "c", growth.rate_unit());
            let mut gain = rate * power(extent.clone(), growth.law.whole().into());
            if growth.law.halves % 2 == 1 {
                let (one, of) = (format!(r"1\ {}", tex_of(growth.of_unit())), growth.of_unit());
                let one = self.symbols.given(&one, 1.0, "1", &tex_of(of), false);
                gain = gain * root(extent / one);
            }
            let name =
                if let Expr::Symbol(s) = first { self.symbols.tex(s).to_owned() } else { "P".to_owned() };
            // Of a first value `M_0` the last one is `M_1`.
            let base = name.strip_suffix("_0").unwrap_or(&name);
            let last = self.page.find(&[tagged(base, "1")], unit, &first + gain);
            let mean = (growth.law.with == Grows::Place).then(|| {
                let h = i64::from(growth.law.halves);
                let mean = weighed([(&first, (h, h + 2)), (&last.into(), (2, h + 2))]);
                self.page.find(&[tagged(base, r"\mathrm{m}")], unit, mean)
            });
            for action in self.m.actions.iter_mut().filter(|a| a.source == source) {
                action.force = mean.unwrap_or(last).into();
            }
            self.grown.push(GrownForce { source, first, last, mean });
        }
    }

    /// An expression with what grows as it is at the start.
    pub fn at_start(&self, of: &Expr) -> Expr {
        self.grown.iter().fold(of.clone(), |all, g| all.put(g.mean.unwrap_or(g.last), &g.first))
    }

    /// From here on what grows with place has its last value, no longer its mean.
    pub fn grow_up(&mut self) {
        let at_end: Vec<(SymbolId, SymbolId)> =
            self.grown.iter_mut().filter_map(|g| Some((g.mean.take()?, g.last))).collect();
        for (mean, last) in at_end {
            self.drive = self.drive.put(mean, &last.into());
            self.m.actions.iter_mut().for_each(|a| a.force = a.force.put(mean, &last.into()));
        }
    }

    /// The acceleration at the start under forces that grow.
    fn first_acceleration(&mut self) -> SymbolId {
        let first = self.at_start(&self.drive.clone());
        let (names, unit) = self.of_lead((["a_0", "a_a"], "m/s^2"), ([r"\alpha_0", r"\alpha_a"], "rad/s^2"));
        let start = self.page.find(&names, unit, first.over(&self.effective));
        self.first_rate = Some(start);
        start
    }

    /// The end after a time under forces that grow with a power `h/2` of it: so does the acceleration, from its first to its last
    /// value. What turns back on its way is not drawn.
    fn arrive_grown(&mut self, t: &Expr, a: SymbolId, v: SymbolId) -> Result<(), DerivationStop> {
        let start = self.first_acceleration();
        let v_label = self.lead().speed();
        self.accelerate();
        let h = self.halves();
        let [first, last] = [start, a].map(Expr::from);
        let end = &self.v0 + weighed([(&first, (h, h + 2)), (&last, (2, h + 2))]).by(t);
        if !self.m.one {
            return Err(Beyond::GrowingForce.into());
        }
        self.sense = self.value(&end).signum();
        let end = self.positive(&end);
        self.found(v_label, v, end);
        self.v = v.into();
        let both = (h + 2) * (h + 4);
        let share = weighed([(&first, (both - 8, 2 * both)), (&last, (4, both))]);
        self.new_way(&self.v0.clone() * t + share.by(square(t)));
        Ok(())
    }

    /// Twice the power with which forces grow.
    fn halves(&self) -> i64 {
        self.scene.law().map_or(0, |law| law.halves.into())
    }

    /// Integral over the motion of a force that may grow, times the velocity of the lead.
    fn worked(&mut self, action: &Action) -> Result<Expr, DerivationStop> {
        let Some(g) = self.grown.iter().find(|g| g.source == action.source).cloned() else {
            return Ok(action.force.by(&self.s));
        };
        let h = self.halves();
        let (End::Time(_, t), Some(start)) = (self.scene.end, self.first_rate) else {
            let mean = weighed([(&g.first, (h, h + 2)), (&g.last.into(), (2, h + 2))]);
            return Ok(mean.by(&self.s));
        };
        let (t, a) = (self.number(t, "t", "s"), self.get(rate_of(self.lead()))?);
        let square = (h + 2) * (h + 2);
        let [first, last] = [start, a].map(|rate| rate * &t);
        let gained = weighed([
            (&self.v0, (2, h + 2)),
            (&first, (2 * square - 2 * (h + 4), square * (h + 4))),
            (&last, (2, square)),
        ]);
        Ok(&g.first * &self.s + (g.last - &g.first) * gained.by(&t))
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
            if is == ONE || self.value(&is) == 0.0 {
                continue;
            }
            let tag = if several { (i + 1).to_string() } else { String::new() };
            let symbol = self.new_symbol(&[tagged(r"\gamma", &tag), tagged("n", &tag)], "1");
            self.settle(symbol, &is);
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

    /// The mass or the moments of inertia of a coordinate as the lead feels them: times the square of the velocity ratio.
    pub fn reckoned(&self, c: Coordinate) -> impl Iterator<Item = Factors> {
        let square = self.m.of(c).ratio.squared();
        self.m.of(c).inertia.iter().map(move |i| i.times(&square))
    }

    /// A new quantity.
    pub fn new_symbol(&mut self, names: &[impl AsRef<str>], unit: &str) -> SymbolId {
        let tex = tagged(&self.free(names), mark_of(&self.page));
        self.unknown(&tex, unit)
    }

    /// Magnitude of a quantity: itself where it is positive.
    pub fn size(&self, of: Expr) -> Expr {
        if self.value(&of) < 0.0 { magnitude(of) } else { of }
    }

    /// Magnitude of a ratio.
    pub fn magnitude(&self, ratio: &Factors) -> Factors {
        let size = if self.value(&ratio.expr()) < 0.0 { ratio.opposite() } else { ratio.clone() };
        size.upright(&self.symbols)
    }

    /// Distance that the lead goes, a magnitude.
    pub fn distance(&self) -> Expr {
        self.positive(&self.s)
    }

    pub fn lead(&self) -> Coordinate {
        self.m.lead
    }

    /// Does the lead move along a line?
    pub fn straight(&self) -> bool {
        self.lead().degree == Degree::Along
    }

    /// What belongs to a lead that moves along a line, or to one that turns.
    pub fn of_lead<T>(&self, line: T, turn: T) -> T {
        if self.straight() { line } else { turn }
    }

    /// Does this coordinate stand in no ratio to the lead: the spin of a slipping body, or any of several freedoms?
    pub fn own(&self, c: Coordinate) -> bool {
        c != self.lead() && (!self.m.one || c.degree == Degree::Turn && self.m.parts[c.body].slips)
    }

    /// Velocity of the lead at the start; what else is given there has to agree.
    fn start_velocity(&mut self) -> Expr {
        let scene = self.scene;
        for (c, num) in scene.start_speeds() {
            let given = self.given_start(c, num);
            let ratio = self.m.of(c).ratio.clone();
            if given != ZERO && !ratio.is_zero() {
                return given.over(&ratio);
            }
        }
        ZERO
    }

    /// A speed or spin of the start as it is seen from what carries the scene.
    fn given_start(&mut self, c: Coordinate, num: Num) -> Expr {
        let (tex, unit) = START_NAMES[usize::from(c.degree == Degree::Turn)];
        let given = self.number(num, tex, unit);
        let Some((carrier, [forward, _])) = self.carried(c) else { return given };
        let own = given - carrier.speed * forward;
        if self.value(&own) == 0.0 { ZERO } else { own }
    }

    /// What carries the line of a body, with its share forward and out of the line.
    fn carried(&mut self, c: Coordinate) -> Option<(Carrying, [Expr; 2])> {
        let carrier = self.m.carrier.clone().filter(|_| c.degree == Degree::Along)?;
        let body = &self.scene.bodies[c.body];
        let shares = carrier.shares(self, body);
        Some((carrier, shares))
    }

    /// Is this another quantity as it is seen from the ground?
    pub fn is_grounded(&self, quantity: Quantity) -> bool {
        use Quantity as Q;
        let moves = matches!(quantity, Q::V | Q::Displacement | Q::KineticEnergy | Q::Work);
        let steady = self.m.carrier.as_ref().is_none_or(|c| c.acceleration == ZERO);
        self.m.carrier.is_some() && (moves || !steady && matches!(quantity, Q::A | Q::ARolling))
    }

    /// A quantity as it is asked: of what is carried as it is seen from the ground.
    pub fn asked(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some((_, symbol)) = self.seen.iter().find(|(l, _)| *l == label) {
            return Ok(*symbol);
        }
        if !self.is_grounded(label.quantity) {
            return self.get(label);
        }
        let body = if let Owner::Body(b) = label.of { b } else { self.lead().body };
        let Some((carrier, [forward, out])) = self.carried(along(body)) else { return self.get(label) };
        let from = match label.quantity {
            Quantity::KineticEnergy => self.seen_energy(false)?,
            Quantity::Work => {
                let after = self.asked(of_scene(Quantity::KineticEnergy))?;
                let gain = after - self.seen_energy(true)?;
                // What is 0 but for rounding.
                let same = self.value(&gain).abs() <= SLACK * self.symbols.value(after);
                if same { ZERO } else { gain }
            }
            Quantity::A | Quantity::ARolling => self.get(label)? + carrier.acceleration * forward,
            Quantity::V => {
                let v = self.seen_velocity(along(body), false)?;
                let [speed, _] = carrier.after(&self.since_start(false)?);
                let aside = speed * out;
                if self.value(&aside) == 0.0 { self.positive(&v) } else { root(square(v) + square(aside)) }
            }
            Quantity::Displacement => {
                let [_, way] = carrier.after(&self.get(of_scene(Quantity::T))?.into());
                let own = match self.slip {
                    Some(_) => self.get(label)?.into(),
                    None => self.signed_travel(along(body))?,
                };
                positive_first([own, way * forward])
            }
            _ => return self.get(label),
        };
        let symbol = match from {
            Expr::Symbol(same) if matches!(label.quantity, Quantity::A | Quantity::ARolling) => same,
            from => {
                let alone = self.m.parts.len() == 1 || matches!(label.of, Owner::Scene);
                let tag = if alone { String::new() } else { self.m.parts[body].tag.clone() };
                let names = names_of(label.quantity).map(|n| tagged(n, &tag));
                self.page.find(&names, label.quantity.unit(), from)
            }
        };
        self.seen.push((label, symbol));
        Ok(symbol)
    }

    /// The velocity of a line as it is seen from the ground, at the start or at the end.
    fn seen_velocity(&mut self, c: Coordinate, at_start: bool) -> Result<Expr, DerivationStop> {
        let given = self.scene.start_speeds().find(|(s, _)| at_start && *s == c);
        if let Some((_, given)) = given {
            let (tex, unit) = START_NAMES[usize::from(c.degree == Degree::Turn)];
            return Ok(self.number(given, tex, unit));
        }
        let own = if at_start && self.own(c) && self.v0 != ZERO {
            // Tied to the lead by several equations together.
            let [rate, lead] = [self.get(rate_of(c))?, self.get(rate_of(self.lead()))?];
            self.v0.by(&(rate / lead))
        } else if at_start {
            self.v0.by(&self.m.of(c).ratio)
        } else {
            let v = self.get(c.speed())?;
            if self.symbols.value(v) == 0.0 { ZERO } else { in_sense(v.into(), self.velocity_sense(c)) }
        };
        let Some((carrier, [forward, _])) = self.carried(c) else { return Ok(own) };
        let [speed, _] = carrier.after(&self.since_start(at_start)?);
        let seen = positive_first([own, speed * forward]);
        Ok(if self.value(&seen) == 0.0 { ZERO } else { seen })
    }

    fn since_start(&mut self, at_start: bool) -> Result<Expr, DerivationStop> {
        let none = at_start || self.scene.end == End::AtOnce;
        if none { Ok(ZERO) } else { self.get(of_scene(Quantity::T)).map(Expr::from) }
    }

    /// The kinetic energy of what is carried as it is seen from the ground.
    fn seen_energy(&mut self, at_start: bool) -> Result<Expr, DerivationStop> {
        let mut all = Vec::new();
        for c in self.scene.coordinates().collect::<Vec<_>>() {
            let inertia = self.m.of(c).inertia.clone();
            if inertia.is_empty() {
                continue;
            }
            // The speed at the end has in it what carries the body out of its line.
            let whole = c.degree == Degree::Along && !at_start;
            let rate = if whole { self.asked(c.speed())?.into() } else { self.seen_velocity(c, at_start)? };
            let mut squares = square(rate);
            if !whole && let Some((carrier, [_, out])) = self.carried(c) {
                let [speed, _] = carrier.after(&self.since_start(at_start)?);
                squares = squares + square(speed * out);
            }
            all.extend(inertia.iter().map(|i| i.by(&squares).by(ratio(1, 2))));
        }
        Ok(sum(all))
    }

    /// Does nothing move on, so that a spring pulls as at the start?
    pub fn still(&self) -> bool {
        self.scene.end == End::AtOnce || self.stays()
    }

    /// Start, sense of the motion, kinetic friction with its sign, the sum of the constant forces.
    fn set_out(&mut self) -> Result<(), DerivationStop> {
        let moves = self.scene.end != End::AtOnce;
        let rubs = self.scene.ties.iter().any(|t| t.rubbing().is_some());
        if moves && self.scene.goes_in_phases() && self.scene.thrown().is_none() {
            return Err(Beyond::Phases.into());
        }
        if !moves && self.scene.is_sprung() && (rubs || !self.m.one) {
            return Err(Beyond::SpringAtOnce.into());
        }
        self.v0 = self.start_velocity();
        if let Some(thrown) = self.scene.thrown().filter(|_| self.scene.end != End::AtOnce) {
            let c = self.number(thrown.radius_m, "R", "m");
            let spin = self.number(thrown.spin_rad_s, r"\omega_0", "rad/s");
            let slip = positive_first([&self.v0 - c * spin]);
            let name = format!("{}_0", self.free(&["u", "w"]));
            self.slip = Some(self.page.find(&[&name], "m/s", slip));
        }
        self.rub();
        if let (Some(spring), true) = (self.spring.clone(), self.still()) {
            self.find_pulls(&spring, spring.stretch.clone());
        }
        if !self.m.one {
            self.together()?;
        }
        self.drive = self.share_sum(&[ForceKind::Given, ForceKind::Kinetic]);
        let lead = self.lead();
        let push = self.value(&self.drive) + self.first_pull();
        let v0 = self.value(&self.v0);
        self.sense = match self.m.of(lead).a {
            _ if v0 != 0.0 => v0.signum(),
            Some(a) if !self.m.one => self.symbols.value(a).signum(),
            _ => push.signum(),
        };
        Ok(())
    }

    /// What the spring pulls the lead with at the start.
    fn first_pull(&self) -> f64 {
        let pull =
            |s: &CordSpring| self.value(&s.gamma.expr()) * self.value(&s.stiffness) * self.value(&s.stretch);
        self.spring.as_ref().map_or(0.0, pull)
    }

    /// Sense of the friction on a body, positive up, as the key has it.
    fn friction_sense(&self, body: usize) -> f64 {
        if let Some(slip) = self.slip {
            return -self.symbols.value(slip).signum() * f64::from(self.m.parts[body].up);
        }
        if self.as_if == Some(AsIf::Next) {
            // The key has the motion before it; this one goes on, or is set off by what is given.
            let v0 = self.value(&self.v0);
            let push = self.value(&self.share_sum(&[ForceKind::Given])) + self.first_pull();
            let goes = if v0 == 0.0 { push } else { v0 };
            let own = self.value(&self.m.of(along(body)).ratio.expr());
            return -(goes * own).signum() * f64::from(self.m.parts[body].up);
        }
        self.key(of_body(Quantity::Friction, body)).map_or(1.0, |key| f64::from(sign(key)))
    }

    /// Normal forces, and the size and sign of kinetic friction, positive up.
    fn rub(&mut self) {
        for body in 0..self.m.parts.len() {
            if let Some((n, is)) = self.m.parts[body].normal.clone() {
                self.found(of_body(Quantity::Normal, body), n, is);
            }
        }
        for (t, tie) in self.scene.ties.iter().enumerate() {
            let (Tie::Slip { body, mu_k, .. } | Tie::Slide { body, mu_k, .. }) = tie else { continue };
            let kinetic = self.m.action_of(t).is_some_and(|a| a.kind == ForceKind::Kinetic);
            let mu = self.number(*mu_k, r"\mu_k", "1");
            if let (true, Some(f), Some((n, _))) =
                (kinetic, self.m.force_of(t), self.m.parts[*body].normal.clone())
            {
                let is = in_sense(mu * n, self.friction_sense(*body));
                self.found(of_body(Quantity::Friction, *body), f, is);
            }
        }
    }

    /// Accelerations and reactions that are unknown, of which the rows and the ties are as many equations.
    fn unknowns(&self) -> Vec<(Label, SymbolId)> {
        let rates = self.scene.coordinates().filter_map(|c| Some((rate_of(c), self.m.of(c).a?)));
        let ties = self.m.reactions().into_iter().map(|(t, f)| (self.label_of_tie(t), f));
        rates.chain(ties).collect()
    }

    /// The equations of motion of all bodies and those of the ties, solved together.
    fn rows_solved(&mut self) -> Option<Vec<Option<f64>>> {
        let rows = (0..self.m.parts.len()).flat_map(|body| self.equations(body));
        let rows = rows.filter(|(c, ..)| c.is_some()).map(|(_, left, right)| (left, right));
        let all: Vec<(Expr, Expr)> = rows.chain(self.demands()).collect();
        let unknowns: Vec<SymbolId> = self.unknowns().into_iter().map(|(_, symbol)| symbol).collect();
        self.page.solved(&all, &unknowns)
    }

    /// What the ties demand of the accelerations, both sides without a minus in front.
    pub fn demands(&self) -> Vec<(Expr, Expr)> {
        self.tied(|freedom| freedom.a)
    }

    /// What the ties demand of these rates.
    fn tied(&self, rate: impl Fn(&Freedom) -> Option<SymbolId>) -> Vec<(Expr, Expr)> {
        let each = |(tie, _): (usize, SymbolId)| {
            let terms = self.m.tied(tie).into_iter();
            let terms = terms.filter_map(|(c, share)| Some(share.by(rate(self.m.of(c))?)));
            let (left, right): (Vec<Expr>, Vec<Expr>) = terms.partition(|t| !matches!(t, Expr::Minus(_)));
            let right = sum(right.into_iter().map(|t| -t));
            if left.is_empty() { (right, ZERO) } else { (sum(left), right) }
        };
        self.m.reactions().into_iter().map(each).collect()
    }

    /// Accelerations and reactions as all equations together give them.
    fn together(&mut self) -> Result<(), DerivationStop> {
        let Some(solution) = self.rows_solved() else { return unfound() };
        for ((label, symbol), value) in self.unknowns().into_iter().zip(solution) {
            let (Some(value), None) = (value, self.known(label)) else { continue };
            // What is 0 but for rounding.
            let value = if value.abs() < SLACK * self.value(&self.m.g) { 0.0 } else { value };
            self.symbols.settle(symbol, value, 0.0);
            self.found(label, symbol, symbol.into());
        }
        Ok(())
    }

    /// The velocities of an instant, from those of the start and from what the ties demand: the start may say more than is needed.
    fn velocities_together(&mut self) -> Result<(), DerivationStop> {
        let moving = self.scene.coordinates().filter_map(|c| Some((c.speed(), self.m.of(c).v?)));
        let (labels, unknowns): (Vec<Label>, Vec<SymbolId>) = moving.unzip();
        let mut all = self.tied(|freedom| freedom.v);
        for (c, given) in self.scene.start_speeds() {
            let given = self.given_start(c, given);
            all.extend(self.m.of(c).v.map(|v| (v.into(), given)));
        }
        let rest = self.scene.start_speeds().next().is_none();
        let found = self.page.solved(&all, &unknowns).ok_or(Beyond::Unfound)?;
        for ((label, symbol), v) in labels.into_iter().zip(unknowns).zip(found) {
            if let Some(v) = if rest { Some(0.0) } else { v.map(f64::abs) } {
                self.symbols.settle(symbol, v, 0.0);
                self.found(label, symbol, symbol.into());
            }
        }
        Ok(())
    }

    /// What of the forces of these kinds does not drop out, each as its share of the lead's equation.
    pub fn shares(&self, kinds: &[ForceKind]) -> Vec<(Action, Expr)> {
        self.listed(&|a| kinds.contains(&a.kind), &|a| self.point(a))
    }

    /// Forces or moments in the equation of a coordinate.
    pub fn row(&self, c: Coordinate) -> Vec<(Action, Expr)> {
        self.listed(&|a| a.body == c.body, &|a| self.m.lever(a, c).clone())
    }

    /// The sum of [`Self::shares`].
    pub fn share_sum(&self, kinds: &[ForceKind]) -> Expr {
        positive_first(self.shares(kinds).into_iter().map(|(_, e)| e))
    }

    /// The equations of motion of a body, both sides; with its coordinate one that belongs to a coordinate of the scene.
    pub fn equations(&self, body: usize) -> Vec<(Option<Coordinate>, Expr, Expr)> {
        let (mut all, part) = (Vec::new(), &self.m.parts[body]);
        for c in [along(body), turn(body)] {
            let (inertia, forces) = (&self.m.of(c).inertia, self.row_sum(c));
            if let Some(a) = self.m.of(c).a.filter(|_| !inertia.is_empty() || forces != ZERO) {
                all.push((Some(c), forces, sum(inertia.iter().map(|i| i.by(a)))));
            }
            if let (Degree::Along, Some((normal, is))) = (c.degree, part.normal.clone()) {
                all.push((None, normal - is, ZERO));
            }
        }
        all
    }

    /// The sum of [`Self::row`].
    pub fn row_sum(&self, c: Coordinate) -> Expr {
        positive_first(self.row(c).into_iter().map(|(_, e)| e))
    }

    /// These forces, each with its share, as they stand in an equation.
    fn listed(
        &self,
        which: &dyn Fn(&Action) -> bool,
        lever: &dyn Fn(&Action) -> Factors,
    ) -> Vec<(Action, Expr)> {
        let actions = self.m.actions.iter().filter(|a| which(a));
        let shares = actions.map(|a| (a.clone(), a.force.factors().times(lever(a))));
        let mut list: Vec<(Action, Factors)> = shares.filter(|(_, share)| !share.is_zero()).collect();
        list.sort_by_key(|(a, share)| (negative(share), rank(a)));
        list.into_iter().map(|(a, share)| (a, share.expr())).collect()
    }

    /// Notes a quantity with what it is equal to.
    pub fn found(&mut self, label: Label, symbol: SymbolId, from: Expr) -> SymbolId {
        self.step(symbol, from);
        self.known.push((label, symbol));
        symbol
    }

    /// What a quantity of the end is, in place of what it was on the way.
    pub fn ends_as(&mut self, label: Label, symbol: SymbolId) {
        self.known.retain(|(l, _)| *l != label);
        self.known.push((label, symbol));
    }

    /// A quantity that is not among the terms.
    fn new_found(&mut self, label: Label, from: Expr) -> SymbolId {
        let tag = self.tag_of(label);
        let names = names_of(label.quantity).map(|name| tagged(name, &tag));
        let tex = self.free(&names);
        let mut mark = String::new();
        if self.symbols.named(&[&tagged(&tex, mark_of(&self.page))]).is_some() {
            // Another body or cord bears it already.
            mark = match label.of {
                Owner::Body(b) => self.m.parts[b].tag.clone(),
                Owner::Tie(t) => (t + 1).to_string(),
                _ => "*".to_owned(),
            };
        }
        let symbol = self.new_symbol(&[tagged(&tex, &mark)], label.quantity.unit());
        self.found(label, symbol, from)
    }

    /// What tells a quantity of one body or cord from that of another, where several have it.
    fn tag_of(&self, label: Label) -> String {
        let has = |p: &&BodyTerms| match label.quantity {
            Quantity::Phi | Quantity::AngularMomentum => p.spin.a.is_some(),
            Quantity::Distance | Quantity::Impulse | Quantity::Rise => p.line.a.is_some(),
            _ => false,
        };
        let pulled =
            |t: &&Tie| matches!(t, Tie::Cord(c) if matches!(c.to, Far::Pull(_) | Far::Spring { .. }));
        match (label.of, label.quantity) {
            (Owner::Body(b), _) if self.m.parts.iter().filter(has).count() > 1 => self.m.parts[b].tag.clone(),
            (Owner::Tie(_), Quantity::XEq) if self.scene.springs().count() < 2 => String::new(),
            (Owner::Tie(t), _) if self.scene.ties.iter().filter(pulled).count() > 1 => (t + 1).to_string(),
            (_, Quantity::WorkPull | Quantity::PowerPull) => "P".to_owned(),
            _ => String::new(),
        }
    }

    fn length(&mut self, num: Num) -> Expr {
        let unit = self.of_lead("m", "rad");
        self.number(num, "d", unit)
    }

    fn new_way(&mut self, from: Expr) {
        let (names, unit) = self.of_lead((["s", "s_2"], "m"), ([r"\varphi", r"\psi"], "rad"));
        let symbol = self.new_symbol(&names, unit);
        self.step(symbol, from);
        self.s = symbol.into();
    }

    /// The acceleration of the lead, of forces that grow at the end.
    pub fn accelerate(&mut self) {
        if let (Some(a), true) = (self.m.of(self.lead()).a, self.m.one) {
            let per = self.drive.over(&self.effective);
            let last =
                self.grown.iter().fold(per, |per, g| per.put(g.mean.unwrap_or(g.last), &g.last.into()));
            self.found(rate_of(self.lead()), a, last);
        }
    }

    /// The motion up to its end: displacement, speed, acceleration of the lead.
    pub fn arrive(&mut self) -> Result<(), DerivationStop> {
        let lead = self.lead();
        let (Some(a), Some(v)) = (self.m.of(lead).a, self.m.of(lead).v) else {
            return unfound();
        };
        let v_label = self.lead().speed();
        if self.spring.is_some() && self.scene.end != End::AtOnce {
            // Where ties give no velocity ratios the swing is not known from the lead alone.
            if !self.m.one {
                return unfound();
            }
            return self.arrive_on_spring(a, v);
        }
        if self.slip.is_some() || self.rates_alone() {
            self.accelerate();
            return Ok(());
        }
        match self.scene.end {
            End::Travel(_, d) | End::Position(_, d) => {
                let d = self.length(d);
                self.s = match self.scene.end {
                    End::Travel(..) => in_sense(d, self.sense),
                    _ => d,
                };
                if !self.grown.is_empty() {
                    self.first_acceleration();
                }
                let push = if self.m.one { self.drive.clone() } else { a.into() };
                let push = positive_first([in_sense(push, self.value(&self.s))]);
                let twice = Factors::of(&(number(2) * self.distance() * push));
                let gained = if self.m.one { twice.over(&self.effective) } else { twice.expr() };
                self.found(v_label, v, root(square(&self.v0) + gained));
                self.v = v.into();
                self.accelerate();
            }
            End::Time(_, t) => {
                let t = self.number(t, "t", "s");
                if !self.grown.is_empty() {
                    return self.arrive_grown(&t, a, v);
                }
                self.accelerate();
                let end = &self.v0 + a * &t;
                let end = self.positive(&end);
                self.found(v_label, v, end);
                self.v = v.into();
                self.new_way(&self.v0.clone() * &t + ratio(1, 2) * a * square(&t));
            }
            end @ (End::Speed(..) | End::TurningPoint(_)) => {
                let names = self.of_lead(("v_1", "m/s"), (r"\omega_1", "rad/s"));
                let given = if let End::Speed(_, u) = end { Some(u) } else { None };
                self.v = given.map_or(ZERO, |u| self.number(u, names.0, names.1));
                self.accelerate();
                self.found(v_label, v, self.v.clone());
                self.new_way((square(&self.v) - square(&self.v0)) / (number(2) * a));
            }
            End::AtOnce if !self.m.one || self.m.parts.iter().any(|p| p.slips) => {
                self.velocities_together()?;
                self.accelerate();
            }
            End::AtOnce | End::Angle(..) | End::Rolling(_) | End::Leaves(_) | End::Equilibrium => {
                let size = self.positive(&self.v0);
                self.found(v_label, v, size.clone());
                self.v = if size == ZERO { ZERO } else { v.into() };
                match self.spring.clone() {
                    None => self.accelerate(),
                    Some(spring) if self.m.one && self.scene.tells_rates() => self.accelerate_by(&spring, a),
                    Some(_) => {}
                }
            }
        }
        Ok(())
    }

    /// The only spring, or one that acts on the lead like all of them together while all are stretched: `k = sum k_i gamma_i^2` and
    /// `k x_0 = sum k_i gamma_i x_i`.
    fn all_springs(&mut self) -> Option<CordSpring> {
        let springs = self.springs.clone();
        if let [] | [_] = springs.as_slice() {
            return springs.first().cloned();
        }
        let stiff = sum(springs.iter().map(|s| s.stiffness.by(s.gamma.squared())));
        let pull = sum(springs.iter().map(|s| s.stiffness.by(&s.gamma).by(&s.stretch)));
        let sense = sign(self.value(&pull));
        let pull = positive_first([in_sense(pull, f64::from(sense))]);
        let [stiffness, stretch, tension] = [("k", "N/m"), ("x", "m"), ("F", "N")].map(|(letter, unit)| {
            self.new_symbol(&["g", "s"].map(|mark| format!(r"{letter}_{{\mathrm{{{mark}}}}}")), unit)
        });
        self.settle(stiffness, &stiff);
        self.settle(stretch, &(pull.clone() / stiffness));
        self.together_as = vec![(stiffness, stiff), (stretch, pull / stiffness)];
        let tie = springs.first()?.tie;
        let (stiffness, stretch) = (stiffness.into(), stretch.into());
        Some(CordSpring {
            tie,
            stiffness,
            stretch,
            rigid: true,
            gamma: Factors::of(&ONE).signed(sense),
            tension,
        })
    }

    /// The pull of each spring at this stretch of [`Account::spring`].
    fn find_pulls(&mut self, spring: &CordSpring, stretch: Expr) {
        let pull = &spring.stiffness * stretch;
        if self.springs.len() > 1 {
            for own in self.springs.clone() {
                let stretch = &own.stretch - own.gamma.by(&self.s);
                self.found(of_tie(Quantity::Tension, own.tie), own.tension, &own.stiffness * stretch);
            }
            self.step(spring.tension, pull);
        } else {
            self.found(of_tie(Quantity::Tension, spring.tie), spring.tension, pull);
        }
    }

    /// Do the cords of several springs stay taut up to this displacement of the lead? One that goes slack is told of one spring alone.
    fn stays_taut(&self, s: &Expr) -> Result<(), DerivationStop> {
        let slack = |own: &CordSpring| !own.rigid && self.value(&(&own.stretch - own.gamma.by(s))) < 0.0;
        if self.springs.len() > 1 && self.springs.iter().any(slack) {
            return Err(Beyond::Slack.into());
        }
        Ok(())
    }

    /// The stretch at which a spring balances a force on the lead.
    fn rest_under(&self, spring: &CordSpring, force: &Expr) -> Expr {
        let per = Factors::of(&spring.stiffness).times(&spring.gamma);
        -force.over(&per)
    }

    /// Angular frequency of the swing on a spring.
    fn frequency(&mut self, spring: &CordSpring) -> SymbolId {
        let per = Factors::of(&spring.stiffness).times(spring.gamma.squared());
        let frequency = root(per.over(&self.effective));
        self.page.find_once(&[OMEGA_SWING, r"\Omega_{\mathrm{s}}"], "rad/s", frequency)
    }

    /// The stretch about which it swings: that of equilibrium, or what friction makes of it on the way.
    pub fn middle(&mut self, spring: &CordSpring) -> Result<SymbolId, DerivationStop> {
        if self.springs.len() == 1 && self.shares(&[ForceKind::Kinetic]).is_empty() {
            return self.get(of_tie(Quantity::XEq, spring.tie));
        }
        let middle = self.rest_under(spring, &self.drive);
        Ok(self.page.find_once(&[r"x_{\mathrm{m}}"], "m", middle))
    }

    /// What the swing on a spring hangs on: angular frequency, stretch at rest, and the greatest distance from it.
    fn swing(&mut self, spring: &CordSpring) -> Result<[Expr; 3], DerivationStop> {
        let frequency = self.frequency(spring);
        let rest = self.middle(spring)?;
        let off = &spring.stretch - rest;
        let amplitude = if self.v0 == ZERO {
            self.positive(&off)
        } else {
            root(square(off) + &self.effective * square(&self.v0) / &spring.stiffness)
        };
        let amplitude = self.page.find_once(&["A", "B"], "m", amplitude);
        Ok([frequency.into(), rest.into(), amplitude.into()])
    }

    /// Sense in which the stretch begins to change: 1 where it grows.
    fn stretching(&self, spring: &CordSpring) -> f64 {
        -self.sense * self.value(&spring.gamma.expr()).signum()
    }

    fn arrive_on_spring(&mut self, a: SymbolId, v: SymbolId) -> Result<(), DerivationStop> {
        let Some(spring) = self.spring.clone() else { return unfound() };
        let v_label = self.lead().speed();
        let grows = self.stretching(&spring);
        // The stretch at the end, and the displacement up to there.
        let mut last = None;
        match self.scene.end {
            End::Travel(_, d) => self.s = in_sense(self.length(d), self.sense),
            End::Position(_, x) => self.s = self.length(x),
            End::TurningPoint(_) => {
                let far = self.turning_point(&spring)?;
                self.new_way(far);
            }
            End::Speed(_, u) => {
                let u = self.number(u, "v_1", "m/s");
                let [_, rest, amplitude] = self.swing(&spring)?;
                let off = root(square(&amplitude) - &self.effective * square(&u) / &spring.stiffness);
                // Faster than at the start: before the place of rest; slower: behind it.
                let before = self.value(&u) > self.value(&self.v0).abs();
                let x = rest + in_sense(off, if before { -grows } else { grows });
                if spring.rigid || self.value(&x) >= 0.0 {
                    last = Some(x);
                } else {
                    let stored =
                        &spring.stiffness * square(&spring.stretch) + &self.effective * square(&self.v0);
                    self.new_way((&self.effective * square(&u) - stored) / (number(2) * &self.drive));
                }
            }
            End::Time(_, t) => {
                let t = self.number(t, "t", "s");
                let slack = if spring.rigid { None } else { self.slackened(&spring)? };
                match slack.filter(|(time, _)| self.value(time) < self.value(&t)) {
                    Some((time, speed)) => {
                        let left = self.page.find_once(&[r"\Delta t"], "s", &t - time);
                        let first = spring.stretch.over(&spring.gamma);
                        let coast = &self.drive / &self.effective;
                        let more = in_sense(speed, self.sense) * left + ratio(1, 2) * coast * square(left);
                        self.new_way(first + more);
                    }
                    None => {
                        let [frequency, rest, amplitude] = self.swing(&spring)?;
                        let begin = self.phase(&spring, &spring.stretch.clone())?;
                        let turned = positive_first([&frequency * t + begin]);
                        last = Some(rest - in_sense(amplitude * cosine(turned), grows));
                    }
                }
            }
            _ => return unfound(),
        }
        if let Some(x) = last {
            let x1 = self.new_symbol(&["x_1", r"x_{\mathrm{e}}"], "m");
            self.step(x1, x);
            self.new_way((&spring.stretch - x1).over(&spring.gamma));
            last = Some(x1.into());
        }
        let last = match last {
            Some(x1) => x1,
            None => match self.stretch_at(&self.s.clone()) {
                ZERO => ZERO,
                from => self.page.find_once(&["x_1", r"x_{\mathrm{e}}"], "m", from).into(),
            },
        };
        let squares = square(&spring.stretch) - square(&last);
        let others = number(2) * self.distance() * in_sense(self.drive.clone(), self.value(&self.s));
        let twice = positive_first([&spring.stiffness * squares, others]);
        match self.scene.end {
            end @ (End::TurningPoint(_) | End::Speed(..)) => {
                let given = if let End::Speed(_, u) = end { Some(u) } else { None };
                self.v = given.map_or(ZERO, |u| self.number(u, "v_1", "m/s"));
                self.found(v_label, v, self.v.clone());
            }
            _ => {
                self.found(v_label, v, root(square(&self.v0) + twice / &self.effective));
                self.v = v.into();
            }
        }
        self.last = last.clone();
        self.stays_taut(&self.s)?;
        self.find_pulls(&spring, last);
        self.accelerate_by(&spring, a);
        Ok(())
    }

    /// The acceleration of the lead, of the spring as it then pulls and of the other forces.
    fn accelerate_by(&mut self, spring: &CordSpring, a: SymbolId) {
        let now = positive_first([spring.tension.by(&spring.gamma), self.drive.clone()]);
        self.found(rate_of(self.lead()), a, now / &self.effective);
    }

    /// The angle of the swing at a stretch: 0 at the greatest distance from rest before it.
    fn phase(&mut self, spring: &CordSpring, stretch: &Expr) -> Result<Expr, DerivationStop> {
        if self.v0 == ZERO && *stretch == spring.stretch {
            return Ok(ZERO);
        }
        let [_, rest, amplitude] = self.swing(spring)?;
        let grows = self.stretching(spring);
        Ok(arc_cosine(positive_first([in_sense(stretch - rest, -grows)]) / amplitude))
    }

    /// When the cord of the spring goes slack, and how fast the lead is then; `None` where it does not.
    fn slackened(&mut self, spring: &CordSpring) -> Result<Option<(Expr, Expr)>, DerivationStop> {
        let [frequency, rest, amplitude] = self.swing(spring)?;
        if self.stretching(spring) > 0.0 || self.value(&rest) - self.value(&amplitude) >= 0.0 {
            return Ok(None);
        }
        let (begin, end) = (self.phase(spring, &spring.stretch.clone())?, self.phase(spring, &ZERO)?);
        let time = self.page.find_once(&[TIME_SLACK], "s", (end - begin) / &frequency);
        let way = spring.stretch.over(&spring.gamma);
        let work = &spring.stiffness * square(&spring.stretch) + number(2) * &self.drive * way;
        let speed =
            self.page.find_once(&[r"v_{\mathrm{s}}"], "m/s", root(square(&self.v0) + work / &self.effective));
        Ok(Some((time.into(), speed.into())))
    }

    /// Time of a motion on a spring, by the angle of its swing.
    fn time_on_spring(&mut self) -> Result<Expr, DerivationStop> {
        let Some(spring) = self.spring.clone() else { return unfound() };
        let last = self.last.clone();
        if last == ZERO
            && !spring.rigid
            && let Some((time, speed)) = self.slackened(&spring)?
        {
            let way = spring.stretch.over(&spring.gamma);
            if self.drive == ZERO {
                return Ok(time + (&self.s - way) / in_sense(speed, self.sense));
            }
            let gain = in_sense(self.v.clone() - speed, self.sense);
            return Ok(time + gain.by(&self.effective).over(&self.drive));
        }
        let [frequency, ..] = self.swing(&spring)?;
        let begin = self.phase(&spring, &spring.stretch.clone())?;
        let end = match self.scene.end {
            End::TurningPoint(_) => self.draft.pi().into(),
            _ => self.phase(&spring, &last)?,
        };
        Ok((end - begin) / frequency)
    }

    /// Stretch of the spring after this displacement of the lead; 0 where its cord is slack.
    pub fn stretch_at(&self, s: &Expr) -> Expr {
        let Some(spring) = &self.spring else { return ZERO };
        let stretch = &spring.stretch - spring.gamma.by(s);
        let slack = SLACK * self.value(&spring.stretch).abs();
        if !spring.rigid && self.value(&stretch) < slack { ZERO } else { stretch }
    }

    /// The reactions in the order in which they leave the equations, moments first, and the row that is left.
    pub fn elimination(&mut self) -> Option<(Vec<Found>, Coordinate)> {
        let mut rows: Vec<Coordinate> = self.scene.coordinates().filter(|c| !self.own(*c)).collect();
        rows.sort_by_key(|c| c.degree == Degree::Along);
        let gone = self.eliminated(&rows, self.m.reactions().into_iter().map(|(_, force)| force).collect());
        let mut left = (0..rows.len()).filter(|at| !gone.iter().any(|f| f.rows[0].at == *at));
        let last = rows[left.next()?];
        left.next().is_none().then_some((gone, last))
    }

    /// What these rows give of what is open, each reaction from one in which it is the only one.
    fn eliminated(&mut self, rows: &[Coordinate], mut open: Vec<SymbolId>) -> Vec<Found> {
        let row = |(at, c): (usize, &Coordinate)| {
            let sides = (self.row_sum(*c), self.gain(*c));
            Row { at, name: self.number_of(*c), sides, told: true }
        };
        let all = rows.iter().enumerate().map(row).collect();
        self.page.untangle(all, &mut open, false)
    }

    /// `m a` or `I a/r` of a coordinate: what its forces amount to, with the acceleration of its body's line or of the lead.
    pub fn gain(&self, c: Coordinate) -> Expr {
        let part = &self.m.parts[c.body];
        let (by, ratio) = match (c.degree, part.line.a, self.m.of(self.lead()).a) {
            (_, Some(a), _) if !part.line.ratio.is_zero() && !self.own(c) => {
                (a, self.m.of(c).ratio.per(&part.line.ratio))
            }
            (_, _, Some(lead)) => (lead, self.m.of(c).ratio.clone()),
            _ => return ZERO,
        };
        let by = Factors::of(&by.into()).times(&ratio);
        sum(self.m.of(c).inertia.iter().map(|i| i.by(&by)))
    }

    fn known(&self, label: Label) -> Option<SymbolId> {
        self.known.iter().find(|(l, _)| *l == label).map(|(_, symbol)| *symbol)
    }

    /// A quantity: looked up, or derived.
    pub fn get(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        if let Some(symbol) = self.known(label) {
            return Ok(symbol);
        }
        // In the equations the force between two rims is a tension.
        if let (Quantity::RimForce, Owner::Tie(tie)) = (label.quantity, label.of) {
            return self.get(of_tie(Quantity::Tension, tie));
        }
        let body = match label.of {
            Owner::Body(b) => b,
            _ => self.lead().body,
        };
        if matches!(label.quantity, Quantity::Friction | Quantity::Tension) {
            return self.reaction(label, body).or_else(|_| {
                self.together()?;
                self.known(label).ok_or(Beyond::Unfound.into())
            });
        }
        let from = self.derived(label, body)?;
        // What belongs together was found together.
        if let Some(symbol) = self.known(label) {
            return Ok(symbol);
        }
        let c = coordinate(label.quantity, body);
        let own = match label.quantity {
            Quantity::A | Quantity::Alpha => self.m.of(c).a,
            Quantity::V | Quantity::Omega => self.m.of(c).v,
            _ => None,
        };
        match (own, &from) {
            (Some(symbol), _) => Ok(self.found(label, symbol, from)),
            // It has its symbol already.
            (None, &Expr::Symbol(symbol)) if SAME.contains(&label.quantity) => {
                self.known.push((label, symbol));
                Ok(symbol)
            }
            _ => Ok(self.new_found(label, from)),
        }
    }

    /// What a quantity is equal to.
    fn derived(&mut self, label: Label, body: usize) -> Result<Expr, DerivationStop> {
        use Quantity::{AngularMomentum, DAtVMax, DTurn, KineticEnergy, Omega, V, VMax};
        let moving =
            matches!(label.quantity, V | Omega | KineticEnergy | AngularMomentum | VMax | DAtVMax | DTurn);
        if self.stays() && moving {
            return Ok(ZERO);
        }
        let c = coordinate(label.quantity, body);
        match label.quantity {
            Quantity::A | Quantity::Alpha => self.acceleration(c),
            Quantity::V | Quantity::Omega if self.own(c) => self.since_rest(c, 1),
            Quantity::V | Quantity::Omega if self.m.of(c).v.is_some() => Ok(self.over_lead(&self.v, c)),
            Quantity::Phi | Quantity::Distance => self.travel(c),
            Quantity::Displacement => self.signed_travel(c),
            Quantity::AngularMomentum => {
                let omega = self.get(of_body(Quantity::Omega, body))?;
                Ok(sum(self.m.of(c).inertia.iter().map(|i| i.by(omega))))
            }
            Quantity::Impulse => {
                let v = self.velocity(along(body))?;
                let before = self.v0.by(&self.m.parts[body].line.ratio);
                Ok(self.m.parts[body].mass.by(positive_first([v - before])))
            }
            Quantity::Work => match self.m.one && !self.m.parts.iter().any(|p| p.slips) {
                true if self.grown.is_empty() => Ok(self.drive.by(&self.s)),
                true => Ok(ratio(1, 2) * &self.effective * (square(&self.v) - square(&self.v0))),
                false => Ok(self.get(of_scene(Quantity::KineticEnergy))?.into()),
            },
            Quantity::WorkCouple | Quantity::PowerCouple => {
                let couples =
                    self.row(c).into_iter().filter(|(a, _)| matches!(a.source, ForceSource::Couple(_)));
                if label.quantity == Quantity::WorkCouple && !self.grown.is_empty() {
                    let mut all = Vec::new();
                    for (action, _) in couples {
                        let turn = self.m.of(c).ratio.times(self.m.lever(&action, c));
                        all.push(self.worked(&action)?.by(turn));
                    }
                    return Ok(positive_first(all));
                }
                let moment = positive_first(couples.map(|(_, e)| e));
                let work = label.quantity == Quantity::WorkCouple;
                let rate = if work { self.signed_travel(c)? } else { self.velocity(c)? };
                Ok(moment.by(&rate))
            }
            // Found before, as if it rolled.
            Quantity::FrictionIfRolled => self.value_for(label).map_or_else(unfound, |s| Ok(s.into())),
            Quantity::Rise => {
                let climb = self.m.actions.iter().find(|a| a.source == ForceSource::Weight(body));
                let climb = climb.map_or_else(Factors::zero, |a| a.along.opposite());
                Ok(self.signed_travel(along(body))?.by(&climb))
            }
            Quantity::MuRequired => self.least_grip(body),
            Quantity::T => self.time(),
            Quantity::CordTravel => self.cord_travel(label),
            Quantity::WorkPull | Quantity::PowerPull => self.pull(label),
            Quantity::KineticEnergy => self.kinetic_sum(),
            Quantity::RotationalFraction => self.rotational(),
            Quantity::SlipDistance => self.slip_distance(body),
            Quantity::Heat => self.heat(),
            Quantity::KBound => self.bound_of_gyration(body),
            Quantity::XEq => {
                let Some(spring) = self.spring.clone() else { return unfound() };
                // Without friction, which would hold it in many places.
                let given = self.share_sum(&[ForceKind::Given]);
                if !self.m.tied {
                    return Ok(ZERO);
                }
                let rest = self.rest_under(&spring, &given);
                let one_of_several =
                    |s: &&CordSpring| self.springs.len() > 1 && label.of == Owner::Tie(s.tie);
                Ok(match self.springs.iter().find(one_of_several) {
                    Some(own) => &own.stretch - own.gamma.by((&spring.stretch - rest).over(&spring.gamma)),
                    None => rest,
                })
            }
            Quantity::OmegaSmall | Quantity::PeriodSmall => {
                let Some(spring) = self.spring.clone() else { return unfound() };
                let frequency = self.frequency(&spring);
                match label.quantity {
                    Quantity::OmegaSmall => Ok(frequency.into()),
                    _ => Ok(number(2) * self.draft.pi() / frequency),
                }
            }
            Quantity::VMax | Quantity::DAtVMax => self.fastest(label.quantity),
            Quantity::DTurn => self.turning(),
            Quantity::PinX | Quantity::PinY | Quantity::PinForce | Quantity::PinAngle => {
                self.axle(label.quantity, body)
            }
            other => Err(Beyond::Quantity(other).into()),
        }
    }

    /// The force of a fixed axle: what weight and cords leave of a sum of nothing.
    fn axle(&mut self, quantity: Quantity, body: usize) -> Result<Expr, DerivationStop> {
        let Some(pulls) = self.scene.axle_pulls(body) else { return unfound() };
        if matches!(quantity, Quantity::PinForce | Quantity::PinAngle) {
            let both = [self.get(of_body(Quantity::PinX, body))?, self.get(of_body(Quantity::PinY, body))?];
            return Ok(self.composed(quantity, both));
        }
        let upright = quantity == Quantity::PinY;
        let mut terms = Vec::new();
        if upright {
            terms.push(self.m.parts[body].mass.expr() * &self.m.g);
        }
        if let Some(carrier) = &self.m.carrier {
            let way = &carrier.acceleration * &carrier.direction[usize::from(upright)];
            terms.push(self.m.parts[body].mass.expr() * way);
        }
        for (tie, aim) in pulls {
            let share = self.m.component(self.page.draft, aim, upright);
            if share.is_zero() {
                continue;
            }
            let given = matches!(&self.scene.ties[tie], Tie::Cord(c) if matches!(c.to, Far::Pull(_)));
            let own =
                self.m.actions.iter().find(|a| a.source == ForceSource::Tie(tie)).map(|a| a.force.clone());
            let force = match own.filter(|_| given) {
                Some(force) => force,
                None => self.get(of_tie(Quantity::Tension, tie))?.into(),
            };
            terms.push(force.by(share.opposite()));
        }
        Ok(positive_first(terms))
    }

    /// Another acceleration than the lead's, by its ratio; that of a slipping body's spin from its own equation.
    fn acceleration(&mut self, c: Coordinate) -> Result<Expr, DerivationStop> {
        if self.m.of(c).a.is_none() || c == self.lead() || !self.m.one {
            return unfound();
        }
        if self.own(c) {
            return Ok(self.row_sum(c).over(sum(self.m.of(c).inertia.iter().map(Factors::expr))));
        }
        let by = self.get(rate_of(self.lead()))?;
        Ok(by.by(&self.m.of(c).ratio))
    }

    /// By the lead's, a magnitude.
    fn over_lead(&self, of: &Expr, c: Coordinate) -> Expr {
        of.by(self.magnitude(&self.m.of(c).ratio))
    }

    /// Speed (1) or distance (2) of a coordinate with an acceleration of its own, from rest: by the time, or, since all accelerations
    /// are constant, in the ratio of the accelerations.
    fn since_rest(&mut self, c: Coordinate, order: u8) -> Result<Expr, DerivationStop> {
        let own = self.get(rate_of(c))?;
        let size = in_sense(own.into(), self.symbols.value(own));
        if self.symbols.value(own) == 0.0 {
            return Ok(ZERO);
        }
        if let End::Time(_, t) = self.scene.end
            && !self.m.one
        {
            let t = self.number(t, "t", "s");
            return Ok(if order == 1 { size * t } else { ratio(1, 2) * size * square(t) });
        }
        let lead = self.get(rate_of(self.lead()))?;
        let by = in_sense(lead.into(), self.symbols.value(lead));
        let of = if order == 1 { self.v.clone() } else { self.distance() };
        Ok(size / by * of)
    }

    /// Distance or angle of a coordinate, a magnitude.
    fn travel(&mut self, c: Coordinate) -> Result<Expr, DerivationStop> {
        if self.own(c) { self.since_rest(c, 2) } else { Ok(self.over_lead(&self.distance(), c)) }
    }

    /// The same with its sign.
    fn signed_travel(&mut self, c: Coordinate) -> Result<Expr, DerivationStop> {
        if !self.own(c) {
            return Ok(self.s.by(&self.m.of(c).ratio));
        }
        let travel = self.travel(c)?;
        Ok(in_sense(travel, self.velocity_sense(c)))
    }

    /// The velocity of a coordinate, with its sign.
    fn velocity(&mut self, c: Coordinate) -> Result<Expr, DerivationStop> {
        Ok(in_sense(self.get(c.speed())?.into(), self.velocity_sense(c)))
    }

    /// Sense in which a coordinate moves; nothing turns back.
    pub fn velocity_sense(&self, c: Coordinate) -> f64 {
        match self.m.of(c).a {
            Some(a) if self.own(c) => self.symbols.value(a),
            _ => self.value(&self.m.of(c).ratio.expr()) * self.sense,
        }
    }

    /// Whose reaction a tie has.
    pub fn label_of_tie(&self, tie: usize) -> Label {
        let touching = self.scene.ties[tie].touching();
        touching.map_or(of_tie(Quantity::Tension, tie), |body| of_body(Quantity::Friction, body))
    }

    /// The contact of a body.
    pub fn contact_of(&self, body: usize) -> Option<usize> {
        self.scene.ties.iter().position(|t| t.touching() == Some(body))
    }

    /// The radius of the contact of a body.
    pub fn radius_of(&self, body: usize) -> Option<Factors> {
        self.contact_of(body).and_then(|t| self.m.action_of(t)).map(|a| self.magnitude(&a.arm))
    }

    /// A reaction: from a row in which it is the only unknown left, lines before turns; others first where need be.
    fn reaction(&mut self, label: Label, body: usize) -> Result<SymbolId, DerivationStop> {
        let tie = match label.of {
            Owner::Tie(t) => Some(t),
            _ => self.contact_of(body),
        };
        let reactions = self.m.reactions();
        let Some(symbol) = tie.and_then(|t| self.m.force_of(t)) else { return unfound() };
        let mut rows: Vec<Coordinate> = self.scene.coordinates().collect();
        rows.sort_by_key(|c| c.degree == Degree::Turn);
        let unknown = |(t, _): &&(usize, SymbolId)| self.known(self.label_of_tie(*t)).is_none();
        let open: Vec<SymbolId> = reactions.iter().filter(unknown).map(|(_, force)| *force).collect();
        let alone = |c: &Coordinate| {
            let uses = self.row_sum(*c).uses();
            open.iter().filter(|s| uses.contains(s)).eq([&symbol])
        };
        if rows.iter().any(alone) {
            rows.retain(alone);
        }
        for found in needed(self.eliminated(&rows, open), vec![symbol]) {
            let c = rows[found.rows[0].at];
            if self.m.parts[c.body].line.a.is_some() && !self.m.parts[c.body].line.ratio.is_zero() {
                self.get(of_body(Quantity::A, c.body))?;
            }
            let own = reactions.iter().find(|(_, force)| found.symbols.contains(force));
            // Another one may have taken all equations together.
            let own = own.map(|(t, _)| self.label_of_tie(*t)).filter(|own| self.known(*own).is_none());
            if let (Some(own), Some(is)) = (own, found.is) {
                self.found(own, found.symbols[0], is);
            }
        }
        let known = tie.and_then(|t| self.known(self.label_of_tie(t)));
        known.ok_or(Beyond::Unfound.into())
    }

    fn least_grip(&mut self, body: usize) -> Result<Expr, DerivationStop> {
        let n = self.get(of_body(Quantity::Normal, body))?;
        let most = match self.spring {
            Some(_) => {
                let [[_, one], [_, other]] = self.extremes(body)?;
                if self.symbols.value(one).abs() >= self.symbols.value(other).abs() { one } else { other }
            }
            // Kinetic friction says nothing of the grip that rolling needs.
            None => match self.value_for(of_body(Quantity::FrictionIfRolled, body)) {
                Some(f) if self.m.parts[body].slips => f,
                _ => {
                    let last = self.get(of_body(Quantity::Friction, body))?;
                    self.largest_grown(last)?
                }
            },
        };
        Ok(self.size(most.into()) / n)
    }

    /// Of a friction that changes evenly with forces that grow, the larger one of its first and its last value.
    fn largest_grown(&mut self, last: SymbolId) -> Result<SymbolId, DerivationStop> {
        let Some(start) = self.first_rate else { return Ok(last) };
        let a = self.get(rate_of(self.lead()))?;
        let from = self.from(last).put(a, &start.into());
        let first = self.grown.iter().fold(from, |f, g| f.put(g.last, &g.first));
        if self.m.reactions().iter().any(|(_, f)| first.uses().contains(f)) {
            return Err(Beyond::GrowingForce.into());
        }
        if self.value(&first).abs() <= self.symbols.value(last).abs() {
            return Ok(last);
        }
        let name = tagged(self.symbols.tex(last), "0");
        Ok(self.page.find(&[&name], "N", first))
    }

    /// Friction on a body at release and at the far end of what the conditions look at, for a wheel on a spring: it is linear in the
    /// tension, so one of them is the largest.
    pub fn extremes(&mut self, body: usize) -> Result<[[SymbolId; 2]; 2], DerivationStop> {
        let far = match self.scene.span {
            Span::ToEnd if self.s != ZERO => self.s.clone(),
            _ => match self.turning_or_slack()? {
                (far, true) => far,
                (far, false) => {
                    let size = self.get(of_body(Quantity::DTurn, self.lead().body))?;
                    in_sense(size.into(), self.value(&far))
                }
            },
        };
        let first = self.friction_at(body, &ZERO, "0")?;
        let last = if far == self.s {
            let friction = self.get(of_body(Quantity::Friction, body))?;
            [self.springs.first().map_or(friction, |s| s.tension), friction]
        } else {
            self.friction_at(body, &far, "2")?
        };
        Ok([first, last])
    }

    /// How far it would go to its turning point while the cord is taut, or where the cord goes slack, if that comes first; and
    /// whether it does.
    pub fn turning_or_slack(&mut self) -> Result<(Expr, bool), DerivationStop> {
        let Some(spring) = self.spring.clone() else { return unfound() };
        let kappa = spring.stiffness.by(spring.gamma.squared());
        let pull = Factors::of(&spring.stiffness).times(&spring.gamma).times(&spring.stretch);
        let turn = if self.v0 == ZERO {
            (number(2) * positive_first([pull.expr(), self.drive.clone()])).over(&kappa)
        } else {
            let [_, rest, amplitude] = self.swing(&spring)?;
            let last = rest + in_sense(amplitude, self.stretching(&spring));
            (&spring.stretch - last).over(&spring.gamma)
        };
        let slack = spring.stretch.over(&spring.gamma);
        let (t, s) = (self.value(&turn), self.value(&slack));
        let goes_slack = !spring.rigid && s * t > 0.0 && s.abs() < t.abs();
        self.stays_taut(&turn)?;
        Ok(if goes_slack { (slack, true) } else { (turn, false) })
    }

    /// The pull of the spring and the friction on a rolling body where the lead has moved by `s`.
    fn friction_at(&mut self, body: usize, s: &Expr, mark: &str) -> Result<[SymbolId; 2], DerivationStop> {
        let now = self.get(of_body(Quantity::Friction, body))?;
        let springs = self.springs.clone();
        let mut there = |of: SymbolId| {
            let tex = tagged(self.symbols.tex(of), mark);
            self.page.draft.symbols.unknown_like(&tex, of)
        };
        let symbol = there(now);
        let all: Vec<(CordSpring, SymbolId)> =
            springs.into_iter().map(|s| (s.clone(), there(s.tension))).collect();
        for (own, tension) in &all {
            let stretch = if all.len() > 1 { &own.stretch - own.gamma.by(s) } else { self.stretch_at(s) };
            self.step(*tension, &own.stiffness * stretch);
        }
        let Some(tension) = all.first().map(|(_, tension)| *tension) else { return unfound() };
        match self.closed_friction(body) {
            Some(closed) => {
                let is =
                    all.iter().fold(closed.expr(), |is, (own, there)| is.put(own.tension, &(*there).into()));
                self.settle(symbol, &is);
            }
            None => {
                // From all equations together, with the pulls of the springs there.
                let ends: Vec<f64> = all.iter().map(|(own, _)| self.symbols.value(own.tension)).collect();
                for (own, there) in &all {
                    let there = self.symbols.value(*there);
                    self.symbols.settle(own.tension, there, 0.0);
                }
                let solved = self.rows_solved();
                for ((own, _), end) in all.iter().zip(ends) {
                    self.symbols.settle(own.tension, end, 0.0);
                }
                let at = self.unknowns().iter().position(|(_, s)| *s == now);
                let Some(value) = solved.zip(at).and_then(|(all, at)| all[at]) else {
                    return unfound();
                };
                self.symbols.settle(symbol, value, 0.0);
            }
        }
        self.step(symbol, symbol.into());
        Ok([tension, symbol])
    }

    /// The friction of a single rolling body as the sum of its forces, each with its factor: `F (c^2 + j) = sum S (c p - j e)`,
    /// `j = I/m`. From `m a = sum S e + F` and `I a/c = sum S p - F c`.
    pub fn closed_friction(&mut self, body: usize) -> Option<ClosedFriction> {
        let part = self.m.parts.get(body)?.clone();
        let tied = |a: &Action| a.kind == ForceKind::Reaction && !a.contact;
        let tie = self.contact_of(body)?;
        let rolls = matches!(self.scene.ties[tie], Tie::Roll { .. }) || self.rolled == Some(tie);
        if !rolls || part.mass.is_zero() || self.m.actions.iter().any(|a| a.body == body && tied(a)) {
            return None;
        }
        let c = self.magnitude(&self.m.action_of(tie)?.arm);
        let j = part.spin.inertia.iter().fold(Factors::zero(), |j, i| j.plus(&i.per(&part.mass)));
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

    fn time(&mut self) -> Result<Expr, DerivationStop> {
        if let End::Time(_, t) = self.scene.end {
            return Ok(self.number(t, "t", "s"));
        }
        if self.value(&self.s) == 0.0 {
            return Ok(ZERO);
        }
        if self.spring.is_some() {
            return self.time_on_spring();
        }
        let a = self.get(rate_of(self.lead()))?;
        Ok(if self.value(&a.into()) == 0.0 {
            &self.s / &self.v0
        } else if self.v0 == ZERO && self.short != Short::Motion {
            number(2) * self.distance() / &self.v
        } else {
            (in_sense(self.v.clone(), self.sense) - &self.v0) / a
        })
    }

    fn cord_of(&self, label: Label) -> Result<(usize, Action), DerivationStop> {
        let Owner::Tie(t) = label.of else { return unfound() };
        self.m.action_of(t).map_or_else(unfound, |a| Ok((t, a.clone())))
    }

    /// Travel or speed of a cord's end in the sense of the pull, from those of the centre and of the turn.
    fn pulled(&mut self, action: &Action, travel: bool) -> Result<Expr, DerivationStop> {
        let mut all = Vec::new();
        for (c, share) in [(along(action.body), &action.along), (turn(action.body), &action.arm)] {
            if share.is_zero() {
                continue;
            }
            let rate = if travel { self.signed_travel(c)? } else { self.velocity(c)? };
            all.push(rate.by(share));
        }
        Ok(positive_first(all))
    }

    /// Do the centre and the turn of this body move by themselves?
    fn loose(&self, body: usize) -> bool {
        !self.m.one || self.m.parts[body].slips
    }

    fn cord_travel(&mut self, label: Label) -> Result<Expr, DerivationStop> {
        let (_, action) = self.cord_of(label)?;
        if self.loose(action.body) {
            let way = self.pulled(&action, true)?;
            return Ok(self.positive(&way));
        }
        Ok(self.distance().by(self.magnitude(&self.point(&action))))
    }

    fn pull(&mut self, label: Label) -> Result<Expr, DerivationStop> {
        let (t, action) = self.cord_of(label)?;
        let work = label.quantity == Quantity::WorkPull;
        if work && self.grown.iter().any(|g| g.source == action.source) {
            let point = self.point(&action);
            return Ok(self.worked(&action)?.by(point));
        }
        let rate = match (self.loose(action.body), work) {
            (true, work) => self.pulled(&action, work)?,
            (false, true) => {
                let travel = self.get(of_tie(Quantity::CordTravel, t))?;
                let helps = self.value(&self.point(&action).expr()) * self.value(&self.s);
                in_sense(travel.into(), helps)
            }
            (false, false) => self.v.by(self.point(&action).signed(sign(self.sense))),
        };
        Ok(action.force.by(&rate))
    }

    /// Kinetic energy: each mass and moment of inertia with its own speed.
    fn kinetic_sum(&mut self) -> Result<Expr, DerivationStop> {
        let mut all = Vec::new();
        for c in self.scene.coordinates() {
            let inertia = self.m.of(c).inertia.clone();
            if inertia.is_empty() || (self.m.of(c).ratio.is_zero() && !self.own(c)) {
                continue;
            }
            let v = self.get(c.speed())?;
            all.push(half_squares(&inertia, v));
        }
        Ok(sum(all))
    }

    fn rotational(&mut self) -> Result<Expr, DerivationStop> {
        let mut turning = Vec::new();
        let slips = !self.m.one || self.m.parts.iter().any(|p| p.slips);
        for c in (0..self.m.parts.len()).map(turn) {
            let inertia = self.m.of(c).inertia.clone();
            if slips && !inertia.is_empty() {
                turning.push(half_squares(&inertia, self.get(c.speed())?));
            } else {
                turning.extend(self.reckoned(c).map(|i| i.expr()));
            }
        }
        // The speed cancels in the share.
        let whole =
            if slips { self.get(of_scene(Quantity::KineticEnergy))?.into() } else { self.effective.clone() };
        Ok(sum(turning).over(&whole))
    }

    fn slip_distance(&mut self, body: usize) -> Result<Expr, DerivationStop> {
        if self.scene.ties.iter().any(|t| matches!(t, Tie::Slide { body: b, .. } if *b == body)) {
            return self.travel(along(body));
        }
        let Some(c) = self.radius_of(body) else { return unfound() };
        let phi = self.get(of_body(Quantity::Phi, body))?;
        let way = self.signed_travel(along(body))?;
        let from = way - in_sense(c.expr() * phi, self.velocity_sense(turn(body)));
        Ok(self.positive(&from))
    }

    fn heat(&mut self) -> Result<Expr, DerivationStop> {
        let mut all = Vec::new();
        for tie in &self.scene.ties {
            let (body, way) = match tie {
                Tie::Slip { body, .. } => (*body, self.get(of_body(Quantity::SlipDistance, *body))?.into()),
                Tie::Slide { body, .. } => (*body, self.travel(along(*body))?),
                _ => continue,
            };
            let f = self.get(of_body(Quantity::Friction, body))?;
            all.push(self.size(f.into()) * way);
        }
        Ok(sum(all))
    }

    /// With F = 0: `a = X/m`, `alpha = M/(m k^2)` and `a = c alpha`.
    fn bound_of_gyration(&mut self, body: usize) -> Result<Expr, DerivationStop> {
        let Some(c) = self.radius_of(body) else { return unfound() };
        let share = |task: &Self, c: Coordinate| {
            let given = task.row(c).into_iter().filter(|(a, _)| a.kind == ForceKind::Given);
            sum(given.map(|(_, e)| e))
        };
        let (force, moment) = (share(self, along(body)), share(self, turn(body)));
        let up = f64::from(self.m.parts[body].up);
        if self.value(&force) * up <= 0.0 || self.value(&moment) * up <= 0.0 {
            return unfound();
        }
        Ok(root(c.expr() * moment / force))
    }

    /// The greatest speed of a motion, and where it is.
    fn fastest(&mut self, quantity: Quantity) -> Result<Expr, DerivationStop> {
        let body = self.lead().body;
        let (at, top) = (of_body(Quantity::DAtVMax, body), of_body(Quantity::VMax, body));
        let first = in_sense(self.v0.clone(), self.sense);
        let (size, way) = match self.spring.clone() {
            // Thrown against a constant force: fastest at the start.
            None if self.value(&self.drive) * self.sense > 0.0 => return unfound(),
            None => (first, ZERO),
            Some(spring) => {
                let x_eq: Expr = self.middle(&spring)?.into();
                let gap = &spring.stretch - &x_eq;
                let per = self.magnitude(&spring.gamma);
                let ahead = self.value(&gap) * -self.stretching(&spring);
                let gap = self.positive(&gap);
                if ahead < 0.0 && self.v0 != ZERO {
                    // It goes away from the place of rest, so it was fastest at the start.
                    (first, ZERO)
                } else if !spring.rigid && self.value(&x_eq) < 0.0 {
                    return unfound();
                } else if self.v0 == ZERO {
                    (&gap * root(&spring.stiffness / &self.effective), gap.over(&per))
                } else {
                    let [frequency, _, amplitude] = self.swing(&spring)?;
                    ((amplitude * frequency).over(&per), gap.over(&per))
                }
            }
        };
        self.new_found(at, way.clone());
        self.new_found(top, size.clone());
        Ok(if quantity == Quantity::VMax { size } else { way })
    }

    fn turning(&mut self) -> Result<Expr, DerivationStop> {
        if let Some(spring) = self.spring.clone() {
            let far = self.turning_point(&spring)?;
            return Ok(self.positive(&far));
        }
        if self.value(&self.drive) * self.sense >= 0.0 {
            return unfound();
        }
        Ok(&self.effective * square(&self.v0) / (number(2) * self.positive(&self.drive)))
    }

    /// Displacement of the lead to its turning point, on the spring or, once its cord is slack, without it.
    fn turning_point(&mut self, spring: &CordSpring) -> Result<Expr, DerivationStop> {
        let (far, slack) = self.turning_or_slack()?;
        if !slack {
            return Ok(far);
        }
        if self.value(&self.drive) * self.value(&far) >= 0.0 {
            return unfound();
        }
        let stored = &spring.stiffness * square(&spring.stretch);
        let moving = &self.effective * square(&self.v0);
        Ok(-((stored + moving) / (number(2) * &self.drive)))
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
                let terms = self.terms.iter().map(|t| over(t).expr());
                positive_first(terms) / self.under.expr()
            }
            _ => positive_first(self.terms.iter().map(|t| over(t).over(&self.under))),
        }
    }
}

/// The kinetic energy of masses or moments of inertia at a rate.
pub fn half_squares(inertia: &[Factors], rate: impl Into<Expr>) -> Expr {
    let square = square(rate);
    sum(inertia.iter().map(|i| i.times(&square).by(ratio(1, 2))))
}

/// What a spring gives off from one stretch to another.
pub fn stored(stiffness: &Expr, first: &Expr, last: &Expr) -> Expr {
    ratio(1, 2) * stiffness * (square(first) - square(last))
}

/// The sum of these, each with its share.
fn weighed<const N: usize>(terms: [(&Expr, (i64, i64)); N]) -> Expr {
    Sum::of(terms.map(|(of, (over, under))| of.factors().times(ratio(over, under)))).expr()
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
        (_, ForceKind::Spring) => 1,
        (ForceSource::Couple(_), _) => 2,
        (ForceSource::Tie(_), _) if !action.contact => 3,
        (ForceSource::Tie(_), _) => 4,
        (ForceSource::Weight(_) | ForceSource::Carrier(_), _) => 5,
    }
}
