//! A body thrown with slip: its terms while it slips and once it rolls, told with the words of all solutions. Friction is known
//! while it slips, and the slip ends at a time, so the equations of motion come first.
use crate::scene::{End, Label, Owner, Quantity, Slope, Thrown};
use crate::solution;
use crate::solution::account::{marked, of_scene};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, cosine, in_sense, magnitude, number as whole_number, positive_first, ratio,
    signed, sine, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::page::{Page, aligned, packed};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::terms;
use crate::solution::text::Block;
use crate::solve::outcome::Word;

/// The body in symbols.
struct ThrownBody {
    body: usize,
    /// Is forward up the slope?
    up: bool,
    level: bool,
    m: Factors,
    g: Expr,
    /// Moment of inertia about the mass centre.
    own: Factors,
    /// Radius of the contact.
    c: Expr,
    sine: Expr,
    cosine: Expr,
    mu_s: Expr,
    mu_k: Expr,
    v0: Expr,
    w0: Expr,
    /// The time asked, where the motion ends after a time.
    t1: Option<Expr>,
}

/// What is known of the body while it slips.
struct Slipping {
    normal: SymbolId,
    friction: SymbolId,
    a: SymbolId,
    alpha: SymbolId,
    /// Slip at the start, and its rate.
    slip: SymbolId,
    rate: SymbolId,
    /// Sense of the slip: 1 forward.
    sense: f64,
    /// When it ends.
    event: Option<SymbolId>,
}

/// Velocity, spin, displacement and angle at one time.
#[derive(Clone, Copy)]
struct State {
    v: SymbolId,
    w: SymbolId,
    x: SymbolId,
    phi: SymbolId,
}

/// Writes the sections of a body thrown with slip.
///
/// # Errors
/// What this does not cover.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    let Some(thrown) = draft.scene.thrown() else { return Err(Beyond::Unfound.into()) };
    let throw = ThrownBody::new(draft, &thrown)?;
    let mut page = Page::new(draft);
    page.begin("idea");
    throw.say(&mut page, if throw.t1.is_some() { "idea_time" } else { "idea" }, &[]);
    page.begin("sketch");
    let name = format!("forces-{}", page.scene.bodies[throw.body].name);
    page.out.blocks = vec![Block::Picture("scene".to_owned()), Block::Picture(name)];
    page.begin_as("short", "one_motion");
    let slipping = throw.slip(&mut page)?;
    let holds = throw.holds(&page);
    let rolls = match (&throw.t1, slipping.event) {
        (None, Some(_)) if holds => false,
        (None, _) => return Err(Beyond::Unfound.into()),
        (Some(t1), Some(event)) => page.value(t1) > page.value(&event.into()),
        (Some(_), None) => false,
    };
    if rolls && !holds {
        return Err(Beyond::Unfound.into());
    }
    let slid: Expr = match (&throw.t1, slipping.event) {
        (Some(t1), _) if !rolls => t1.clone(),
        (_, Some(event)) => event.into(),
        _ => ZERO,
    };
    let first = throw.state(&mut page, &slipping, &slid, rolls);
    let energy = throw.friction_work(&mut page, &slipping, &slid, rolls);
    let rates = [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired];
    let mut rolling = None;
    if rolls || rates.iter().any(|q| page.asks(*q)) {
        rolling = Some(throw.rolling(&mut page, &slipping));
    }
    let last = match (rolls, rolling, &throw.t1, slipping.event) {
        (true, Some((a, _)), Some(t1), Some(event)) => throw.rolling_leg(&mut page, first, a, t1 - event),
        _ => first,
    };
    throw.other_method(&mut page, &slipping, (first, &slid), energy, rolls);
    throw.answers(&mut page, &slipping, [first, last], rolling.filter(|_| rolls));
    throw.regime(&mut page, &slipping, rolls, holds);
    page.begin("limits");
    if throw.level && (rolls || throw.t1.is_none()) {
        throw.say(&mut page, "limit_level", &[]);
    } else {
        throw.say(&mut page, "limit", &[]);
    }
    page.begin("onward");
    throw.say(&mut page, if throw.t1.is_some() { "onward_time" } else { "onward" }, &[]);
    page.end();
    Ok(())
}

impl ThrownBody {
    fn new(draft: &mut Draft, thrown: &Thrown) -> Result<Self, DerivationStop> {
        let (scene, body) = (draft.scene, thrown.body);
        let Some(line) = scene.bodies[body].line else { return Err(Beyond::Unfound.into()) };
        let theta = match line.slope {
            Slope::Level => None,
            Slope::Degrees(angle) => Some(draft.number(angle, r"\theta", "deg")).filter(|t| *t != ZERO),
            Slope::Vertical => return Err(Beyond::Unfound.into()),
        };
        let g = terms::gravity(draft);
        let m = terms::mass(draft, &scene.bodies[body], &g, "");
        let own = terms::inertia(draft, &scene.bodies[body], &m, &g, "");
        let own = own.iter().fold(Factors::zero(), |all, i| all.plus(i));
        if own.is_zero() {
            return Err(Beyond::Unfound.into());
        }
        Ok(Self {
            body,
            up: line.forward_up || theta.is_none(),
            level: theta.is_none(),
            m,
            g,
            own,
            c: draft.number(thrown.radius_m, "R", "m"),
            sine: theta.clone().map_or(ZERO, sine),
            cosine: theta.map_or(ONE, cosine),
            mu_s: draft.number(thrown.mu_s, r"\mu_s", "1"),
            mu_k: draft.number(thrown.mu_k, r"\mu_k", "1"),
            v0: draft.number(thrown.speed_m_s, "v_0", "m/s"),
            w0: draft.number(thrown.spin_rad_s, r"\omega_0", "rad/s"),
            t1: match scene.end {
                End::Time(_, t) => Some(draft.number(t, "t_1", "s")),
                End::Rolling(_) => None,
                _ => return Err(Beyond::Unfound.into()),
            },
        })
    }

    fn say(&self, page: &mut Page, name: &str, pieces: &[(&str, &str)]) {
        page.say(&format!("thrown.{name}"), pieces);
    }

    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    fn answer(&self, page: &mut Page, quantity: Quantity, symbol: SymbolId) {
        page.answer(self.label(quantity), DerivedAnswer::Value(symbol));
    }

    /// Component of the weight against forward, positive where forward is up, over a length or a time.
    fn weight(&self, by: &Expr) -> Expr {
        let size =
            self.m.times(&Factors::of(&self.g)).times(&Factors::of(by)).times(&Factors::of(&self.sine));
        signed(size.expr(), self.up)
    }

    /// The words for where something points that is positive forward.
    fn way(&self, page: &Page, forward: f64) -> String {
        let value = if self.up { forward } else { -forward };
        let name = solution::way(page.scene, Owner::Body(self.body), value);
        name.map_or_else(String::new, |phrase| page.words.get(phrase).to_owned())
    }

    /// A magnitude: the quantity itself, or under bars where it is negative.
    fn size(page: &mut Page, symbol: SymbolId) -> SymbolId {
        if page.symbols.value(symbol) >= 0.0 {
            return symbol;
        }
        let name = format!(r"\left|{}\right|", page.symbols.tex(symbol));
        let size = page.symbols.unknown_like(&name, symbol);
        page.symbols.settle_by(size, &magnitude(symbol));
        size
    }

    /// The rows while it slips, and the end of the slip.
    fn slip(&self, page: &mut Page) -> Result<Slipping, DerivationStop> {
        let slip = page.find(&["u_0", "w_0"], "m/s", positive_first(vec![&self.v0 - &self.c * &self.w0]));
        let value = page.symbols.value(slip);
        if value == 0.0 {
            return Err(Beyond::Unfound.into());
        }
        let sense = value.signum();
        self.say(page, "slip", &[]);
        page.tell_new();
        let speed = Self::size(page, slip);
        self.answer(page, Quantity::SlipSpeed, speed);
        let (slides, points) = (self.way(page, sense), self.way(page, -sense));
        self.say(page, "sense", &[("slides", &slides), ("points", &points)]);
        let unknown = |page: &mut Page, names: &[&str], unit: &str| {
            let tex = page.free(names);
            page.unknown(&tex, unit)
        };
        let force = unknown(page, &["F", "F_f"], "N");
        let normal = unknown(page, &["N", "F_N"], "N");
        let a = unknown(page, &["a", "a_G"], "m/s^2");
        let alpha = unknown(page, &[r"\alpha", r"\alpha_G"], "rad/s^2");
        let forward = signed(force.into(), self.up);
        let pressing = self.m.times(&Factors::of(&self.g)).times(&Factors::of(&self.cosine)).expr();
        let (one, two, three) = (
            format!(
                "{} = {}",
                page.tex(&positive_first(vec![&forward - self.weight(&ONE)])),
                page.tex(&(self.m.expr() * a))
            ),
            format!("{} = 0", page.tex(&(normal - &pressing))),
            format!(
                "{} = {}",
                page.tex(&(-(&forward * &self.c))),
                page.tex(&self.own.times(&Factors::of(&alpha.into())).expr())
            ),
        );
        page.formula(format!(r"{one} \quad (1), \qquad {two} \quad (2), \qquad {three} \quad (3)"));
        self.say(page, "law", &[]);
        page.step(normal, pressing);
        let known = signed(&self.mu_k * normal, (sense < 0.0) == self.up);
        page.step(force, known);
        self.answer(page, Quantity::Normal, normal);
        let fall = signed(&self.g * &self.sine, self.up);
        let per_mass = Factors::of(&forward).per(&self.m).expr();
        page.step(a, positive_first(vec![per_mass - fall]));
        let turned = Factors::of(&(-(&forward * &self.c))).per(&self.own).expr();
        page.step(alpha, turned);
        page.tell_new();
        let dotted = page.free(&["u", "w"]);
        let rate = page.find(&[&format!(r"\dot{{{dotted}}}")], "m/s^2", a - &self.c * alpha);
        let closes = page.symbols.value(rate) * sense < 0.0;
        self.say(page, if closes { "even" } else { "even_open" }, &[]);
        let event = closes.then(|| {
            let names: [&str; 2] = if self.t1.is_some() { ["t_r", "t_e"] } else { ["t", "t_r"] };
            page.find(&names, "s", -(slip / rate))
        });
        page.tell_new();
        Ok(Slipping { normal, friction: force, a, alpha, slip, rate, sense, event })
    }

    /// Where it is at a time, while it slips or as the slip ends.
    fn state(&self, page: &mut Page, s: &Slipping, t: &Expr, rolls: bool) -> State {
        let one = if rolls { r"\mathrm{r}" } else { "1" };
        let name = |page: &Page, names: &[&str]| {
            let tex = page.free(names);
            if self.t1.is_some() { marked(&tex, one) } else { tex }
        };
        if let (Some(t1), Some(event)) = (&self.t1, s.event) {
            let (t1, event) = (page.inline(t1), page.names(&[event]));
            self.say(page, if rolls { "by_then" } else { "not_yet" }, &[("asked", &t1), ("event", &event)]);
        }
        let time = page.inline(t);
        self.say(page, "state", &[("t", &time)]);
        let slips = !rolls && self.t1.is_some();
        let tex = name(page, &["v", "v_G"]);
        let v = page.find(&[&tex], "m/s", &self.v0 + s.a * t);
        let tex = name(page, &[r"\omega", r"\Omega"]);
        let spin = if slips { &self.w0 + s.alpha * t } else { v / &self.c };
        let w = page.find(&[&tex], "rad/s", spin);
        let way = |start: &Expr, rate: SymbolId| start * t + ratio(1, 2) * (rate * square(t));
        let tex = name(page, &["x", "x_G"]);
        let x = page.find(&[&tex], "m", way(&self.v0, s.a));
        page.tell_new();
        let tex = name(page, &[r"\phi", r"\varphi", r"\psi"]);
        let phi = page.find(&[&tex], "rad", way(&self.w0, s.alpha));
        if page.asks(Quantity::Phi) {
            page.tell_new();
        }
        page.skip_new();
        if self.v0.value(&page.symbols) * page.symbols.value(v) < 0.0 {
            self.say(page, "turns_back", &[]);
        }
        State { v, w, x, phi }
    }

    /// How far the contact slips, and the heat.
    fn friction_work(&self, page: &mut Page, s: &Slipping, t: &Expr, rolls: bool) -> SymbolId {
        let slips = !rolls && self.t1.is_some();
        let mean = if slips {
            let left = page.find(&["u_1", "w_1"], "m/s", s.slip + s.rate * t);
            in_sense(s.slip + left, s.sense)
        } else {
            in_sense(s.slip.into(), s.sense)
        };
        self.say(page, "heat", &[]);
        let way = page.find(
            &["l", r"\ell", r"\lambda"],
            "m",
            Factors::of(&mean).times(&Factors::of(t)).times(&Factors::of(&ratio(1, 2))).expr(),
        );
        self.answer(page, Quantity::SlipDistance, way);
        let heat = page.find(&["Q", "Q_f"], "J", &self.mu_k * s.normal * way);
        page.answer(of_scene(Quantity::Heat), DerivedAnswer::Value(heat));
        page.tell_new();
        heat
    }

    /// In doubles: acceleration and friction once it rolls, positive forward.
    fn holds(&self, page: &Page) -> bool {
        let (m, own, c) = (page.value(&self.m.expr()), page.value(&self.own.expr()), page.value(&self.c));
        let a = -page.value(&self.weight(&ONE)) / (m + own / (c * c));
        let normal = m * page.value(&self.g) * page.value(&self.cosine);
        (own * a / (c * c)).abs() <= page.value(&self.mu_s) * normal
    }

    /// Acceleration and friction once it rolls.
    fn rolling(&self, page: &mut Page, s: &Slipping) -> (SymbolId, SymbolId) {
        self.say(page, if self.level { "roll_level" } else { "roll" }, &[]);
        let j = self.own.per(&Factors::of(&self.c).squared());
        let carried = self.m.plus(&j);
        let from = Factors::of(&self.weight(&ONE)).opposite().per(&carried).expr();
        let a = page.free(&["a", "a_G"]);
        let a = page.find(&[&marked(&a, r"\mathrm{r}")], "m/s^2", from);
        let f = page.free(&["F", "F_f"]);
        let from = signed(j.times(&Factors::of(&a.into())).expr(), !self.up);
        let friction = page.find(&[&marked(&f, r"\mathrm{r}")], "N", if self.level { ZERO } else { from });
        self.answer(page, Quantity::ARolling, a);
        self.answer(page, Quantity::FrictionIfRolled, friction);
        if page.asks(Quantity::MuRequired) {
            let size = if page.symbols.value(friction) < 0.0 { magnitude(friction) } else { friction.into() };
            let mu = page.find(&[r"\mu_{\mathrm{min}}"], "1", size / s.normal);
            self.answer(page, Quantity::MuRequired, mu);
        }
        page.tell_new();
        (a, friction)
    }

    fn rolling_leg(&self, page: &mut Page, from: State, a: SymbolId, time: Expr) -> State {
        self.say(page, "leg", &[]);
        let left = page.find(&[r"\Delta t"], "s", time);
        let name = |page: &Page, names: &[&str]| marked(&page.free(names), "1");
        let tex = name(page, &["v", "v_G"]);
        let v = page.find(&[&tex], "m/s", from.v + a * left);
        let tex = name(page, &[r"\omega", r"\Omega"]);
        let w = page.find(&[&tex], "rad/s", v / &self.c);
        let tex = name(page, &["x", "x_G"]);
        let legs = from.x + from.v * left + ratio(1, 2) * (a * square(left));
        let x = page.find(&[&tex], "m", legs);
        page.tell_new();
        let tex = name(page, &[r"\phi", r"\varphi", r"\psi"]);
        let phi = page.find(&[&tex], "rad", from.phi + (x - from.x) / &self.c);
        if page.asks(Quantity::Phi) {
            page.forget(&[Some(from.phi), Some(phi)]);
            page.tell_new();
        }
        page.skip_new();
        State { v, w, x, phi }
    }

    /// Angular momentum about the contact, and the balance of energies: what they give, and what not.
    fn other_method(
        &self,
        page: &mut Page,
        s: &Slipping,
        (end, t): (State, &Expr),
        heat: SymbolId,
        rolls: bool,
    ) {
        page.begin_as("long", "slip_energy");
        self.say(page, if self.level { "momentum_level" } else { "momentum" }, &[]);
        let mc = self.m.times(&Factors::of(&self.c));
        let spun = |w: &Expr, v: &Expr| {
            sum([self.own.times(&Factors::of(w)).expr(), mc.times(&Factors::of(v)).expr()])
        };
        let (before, after) = (spun(&self.w0, &self.v0), spun(&end.w.into(), &end.v.into()));
        let before = before - if self.level { ZERO } else { self.weight(&(&self.c * t)) };
        page.formula(format!("{} = {}", page.tex(&before), page.tex(&after)));
        self.say(page, "balance", &[]);
        let half = Factors::of(&ratio(1, 2));
        let kinetic = |w: &Expr, v: &Expr| {
            let term =
                |i: &Factors, rate: &Expr| i.times(&half).times(&Factors::of(&square(rate.clone()))).expr();
            let zero = |e: Expr, rate: &Expr| if *rate == ZERO { ZERO } else { e };
            sum([zero(term(&self.m, v), v), zero(term(&self.own, w), w)])
        };
        let left = kinetic(&self.w0, &self.v0) - heat;
        let left = left - if self.level { ZERO } else { self.weight(&end.x.into()) };
        page.formula(format!("{} = {}", page.tex(&left), page.tex(&kinetic(&end.w.into(), &end.v.into()))));
        if self.level && (self.t1.is_none() || rolls) {
            self.by_momentum(page, s, end, heat);
        }
        page.begin_as("why", "which");
        self.say(page, if self.level { "why_level" } else { "why" }, &[]);
        page.say("why.ask_slip", &[]);
    }

    /// The speed at which rolling begins, and the heat, without the friction.
    fn by_momentum(&self, page: &mut Page, s: &Slipping, end: State, heat: SymbolId) {
        let c = Factors::of(&self.c);
        let spin = self.own.times(&Factors::of(&self.w0)).per(&c);
        let moving = self.m.times(&Factors::of(&self.v0));
        let carried = self.m.plus(&self.own.per(&c.squared()));
        let over = sum([moving.expr(), spin.expr()]);
        let speed = Factors::of(&over).per(&carried).expr();
        let lost = self.m.times(&self.own).times(&Factors::of(&square(s.slip)));
        let whole = self.own.plus(&self.m.times(&c.squared())).times(&Factors::of(&whole_number(2)));
        let lost = lost.per(&whole).expr();
        self.say(page, "by_momentum", &[]);
        let lines = [(end.v, speed), (heat, lost)].map(|(symbol, from)| page.chain(symbol, &from).concat());
        for line in packed(lines) {
            page.formula(if line.contains('&') { aligned(&line) } else { line });
        }
    }

    fn answers(
        &self,
        page: &mut Page,
        s: &Slipping,
        [first, end]: [State; 2],
        rolling: Option<(SymbolId, SymbolId)>,
    ) {
        page.begin("rest");
        page.skip_new();
        for (quantity, symbol) in [(Quantity::Omega, end.w), (Quantity::V, end.v), (Quantity::Phi, end.phi)] {
            let size = Self::size(page, symbol);
            self.answer(page, quantity, size);
        }
        self.answer(page, Quantity::Displacement, end.x);
        let (a, friction) = rolling.unwrap_or((s.a, s.friction));
        self.answer(page, Quantity::A, a);
        self.answer(page, Quantity::Friction, friction);
        let mut alpha = s.alpha;
        if rolling.is_some() {
            let tex = marked(&page.free(&[r"\alpha", r"\alpha_G"]), r"\mathrm{r}");
            alpha = page.find(&[&tex], "rad/s^2", a / &self.c);
            if !page.asks(Quantity::Alpha) {
                page.skip_new();
            }
        }
        self.answer(page, Quantity::Alpha, alpha);
        let time = match (&self.t1, s.event) {
            (Some(Expr::Symbol(t1)), _) => Some(*t1),
            (_, event) => event,
        };
        if let Some(t) = time {
            page.answer(of_scene(Quantity::T), DerivedAnswer::Value(t));
        }
        if page.asks(Quantity::Rise) {
            let rise = page.find(&["h", "h_G"], "m", signed(end.x * &self.sine, self.up));
            self.answer(page, Quantity::Rise, rise);
        }
        if page.asks(Quantity::KineticEnergy) || page.asks(Quantity::RotationalFraction) {
            let half = Factors::of(&ratio(1, 2));
            let of = |i: &Factors, rate: SymbolId| i.times(&half).times(&Factors::of(&square(rate))).expr();
            let spin = of(&self.own, end.w);
            let energy = page.find(&["E_{k}", r"E_{\mathrm{kin}}"], "J", of(&self.m, end.v) + &spin);
            page.answer(of_scene(Quantity::KineticEnergy), DerivedAnswer::Value(energy));
            if page.asks(Quantity::RotationalFraction) {
                let share = page.find(&[r"\zeta", r"\zeta_r"], "1", spin / energy);
                page.answer(of_scene(Quantity::RotationalFraction), DerivedAnswer::Value(share));
            }
        }
        if page.asks(Quantity::AngularMomentum) {
            let size = Self::size(page, end.w);
            let l =
                page.find(&["L", r"\Lambda"], "kg m^2/s", self.own.times(&Factors::of(&size.into())).expr());
            self.answer(page, Quantity::AngularMomentum, l);
        }
        if page.asks(Quantity::Impulse) {
            let gain = Factors::of(&(end.v - &self.v0));
            let j = page.find(&["J", "S"], "N s", self.m.times(&gain).expr());
            self.answer(page, Quantity::Impulse, j);
        }
        if page.asks(Quantity::Distance) {
            let turns = |a: &Expr, b: &Expr| page.value(a) * page.value(b) < 0.0;
            let from = if turns(&self.v0, &first.v.into()) {
                Some(-(square(&self.v0) / (whole_number(2) * s.a)))
            } else if turns(&first.v.into(), &end.v.into()) {
                Some(first.x - square(first.v) / (whole_number(2) * a))
            } else {
                None
            };
            let way = match from {
                // There and back.
                Some(turn) => {
                    let turn = page.find(&["x_t"], "m", turn);
                    magnitude(turn) + magnitude(end.x - turn)
                }
                None => in_sense(end.x.into(), page.symbols.value(end.x)),
            };
            let d = page.find(&["d", "d_G"], "m", way);
            self.answer(page, Quantity::Distance, d);
        }
        page.tell_new();
        let v = page.symbols.value(end.v);
        let sloped = page.scene.bodies[self.body].line.is_some_and(|l| l.slope != Slope::Level);
        let word = match (sloped, (v > 0.0) == self.up) {
            _ if v == 0.0 => Word::Stays,
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, _) if v > 0.0 => Word::Forward,
            (false, _) => Word::Back,
        };
        page.answer(self.label(Quantity::Direction), DerivedAnswer::Word(word));
    }

    /// Can it roll on?
    fn regime(&self, page: &mut Page, s: &Slipping, rolls: bool, holds: bool) {
        let word = if holds { Word::Yes } else { Word::No };
        page.answer(self.label(Quantity::Rolls), DerivedAnswer::Word(word));
        page.begin("holds");
        let normal = page.shown(s.normal);
        self.say(page, "presses", &[("n", &normal)]);
        if self.t1.is_some() && !rolls {
            return;
        }
        let j = self.own.per(&Factors::of(&self.c).squared());
        let share = j.per(&self.m.plus(&j));
        let needed = share.times(&self.m).times(&Factors::of(&self.g)).times(&Factors::of(&self.sine)).expr();
        if self.level {
            self.say(page, "rolls_on_level", &[]);
        } else {
            let needed = page.valued(&needed, "N");
            let limit = page.valued(&(&self.mu_s * s.normal), "N");
            self.say(page, "rolls_on", &[("needed", &needed), ("limit", &limit)]);
        }
    }
}
