//! A body thrown with slip, worked: friction against the slip until the contact is at rest, rolling from then on; then by
//! the angular momentum about the surface, in which friction has no lever, the energy of the slip, and the whole balance with
//! its heat.
use crate::scene::{End, Label, Owner, Quantity, Slope, Thrown};
use crate::solution;
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, cosine, magnitude, number as whole, ratio, signed, sine, square,
};
use crate::solution::mass;
use crate::solution::section_writer::SectionWriter;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solve::outcome::Word;

/// The body in symbols.
struct ThrownBody {
    body: usize,
    /// Is forward up the slope?
    up: bool,
    level: bool,
    m: Expr,
    g: Expr,
    /// Moment of inertia about the mass centre.
    own: Expr,
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
    names: ThrownNames,
}

/// How the unknowns are written.
struct ThrownNames {
    a: String,
    alpha: String,
    friction: String,
    normal: String,
    slip: String,
    v: String,
    omega: String,
    x: String,
    phi: String,
    way: String,
    heat: String,
    kinetic: String,
    momentum: String,
}

/// What becomes of the slip by the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SlipPhase {
    /// The end is the start of rolling.
    Event,
    /// It still slips.
    Slips,
    /// It rolls by then.
    Rolls,
}

/// What the first method has found and the second needs.
struct ThrownResults {
    phase: SlipPhase,
    /// Slip at the start, positive forward.
    slip: SymbolId,
    /// Sense of the slip: 1 forward.
    sense: f64,
    normal: SymbolId,
    /// Time of the event, if it comes.
    event: Option<SymbolId>,
    /// Velocity of the centre at the end.
    v: SymbolId,
}

/// The slip at the start.
struct StartSlip {
    /// Positive forward.
    start: SymbolId,
    /// Its size.
    speed: SymbolId,
    /// 1 forward, -1 back.
    sense: f64,
}

/// Velocity, spin, displacement and angle at the end of a leg.
struct LegEnd {
    v: SymbolId,
    w: SymbolId,
    x: SymbolId,
    phi: SymbolId,
}

/// The slip, from its energy.
struct SlipByEnergy {
    /// How far the contact slips.
    way: SymbolId,
    /// The slip that is left at the end.
    left: Expr,
    /// How long it slips.
    time: Expr,
    /// The same where the slip ends before the motion does.
    event: Option<SymbolId>,
}

/// Accelerations and friction on a leg.
struct LegRates {
    a: SymbolId,
    alpha: SymbolId,
    friction: SymbolId,
}

/// Half of it.
fn half(e: Expr) -> Expr {
    ratio(1, 2) * e
}

/// Writes the sections of a body thrown with slip.
///
/// # Errors
/// What this derivation does not cover.
pub fn work(draft: &mut Draft) -> Result<(), DerivationStop> {
    let Some(thrown) = draft.scene.thrown() else {
        return Err(Beyond::Arrangement.into());
    };
    let throw = read(draft, &thrown)?;
    let worked = throw.motion(draft)?;
    throw.balance(draft, &worked);
    throw.regime(draft, &worked);
    Ok(())
}

/// Free body and inertia.
fn read(draft: &mut Draft, thrown: &Thrown) -> Result<ThrownBody, DerivationStop> {
    let scene = draft.scene;
    let body = thrown.body;
    let Some(line) = scene.bodies[body].line else {
        return Err(Beyond::Arrangement.into());
    };
    let theta = match line.slope {
        Slope::Level => None,
        Slope::Degrees(angle) => Some(draft.number(angle, r"\theta", "deg")),
        Slope::Vertical => {
            return Err(Beyond::ThrownVertically.into());
        }
    };
    let theta = theta.filter(|t| *t != ZERO);
    let names = ThrownNames {
        a: draft.free(&["a", "a_G"]),
        alpha: draft.free(&[r"\alpha", r"\alpha_G"]),
        friction: draft.free(&["F", "F_f"]),
        normal: draft.free(&["N", "F_N"]),
        slip: draft.free(&["u", "w"]),
        v: draft.free(&["v", "v_G"]),
        omega: draft.free(&[r"\omega", r"\Omega"]),
        x: draft.free(&["x", "x_G"]),
        phi: draft.free(&[r"\phi", r"\varphi", r"\psi"]),
        way: draft.free(&["l", r"\ell", r"\lambda"]),
        heat: draft.free(&["Q", "Q_f"]),
        kinetic: draft.free(&["T", "E"]),
        momentum: draft.free(&["H", "L_A"]),
    };
    let c = draft.number(thrown.radius_m, "R", "m");
    let g = draft.number(scene.gravity_m_s2, "g", "m/s^2");
    let mu_s = draft.number(thrown.mu_s, r"\mu_s", "1");
    let mu_k = draft.number(thrown.mu_k, r"\mu_k", "1");
    let v0 = draft.number(thrown.speed_m_s, "v_0", "m/s");
    let w0 = draft.number(thrown.spin_rad_s, r"\omega_0", "rad/s");
    let t1 = match scene.end {
        End::Time(_, t) => Some(draft.number(t, "t_1", "s")),
        End::Rolling(_) => None,
        _ => {
            return Err(Beyond::OtherEnd.into());
        }
    };

    let mut page = SectionWriter::new(draft, "forces", "thrown.title_forces");
    page.picture("scene");
    let inclined = theta.is_some();
    page.say(
        if inclined { "thrown.forces_incline" } else { "thrown.forces_level" },
        &[("friction", &names.friction), ("normal", &names.normal)],
    );
    let positive = if !inclined {
        "thrown.positive_level"
    } else if line.forward_up {
        "thrown.positive_up"
    } else {
        "thrown.positive_down"
    };
    page.say(positive, &[("friction", &names.friction)]);
    page.picture(&format!("forces-{}", scene.bodies[body].name));
    let m = mass::mass(&mut page, body);
    let own = mass::inertia(&mut page, body, &m);
    if own == ZERO {
        return Err(Beyond::ThrownWithoutInertia.into());
    }
    page.done();
    Ok(ThrownBody {
        body,
        up: line.forward_up || theta.is_none(),
        level: theta.is_none(),
        m,
        g,
        own,
        c,
        sine: theta.clone().map_or(ZERO, sine),
        cosine: theta.map_or(ONE, cosine),
        mu_s,
        mu_k,
        v0,
        w0,
        t1,
        names,
    })
}

impl ThrownBody {
    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    fn scene_label(quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Scene }
    }

    /// Component of the weight against forward, positive where forward is up.
    fn weight(&self) -> Expr {
        signed(&self.m * &self.g * &self.sine, self.up)
    }

    /// The same times something; the sine stays last, where nothing can be read into it.
    fn weight_times(&self, factor: Expr) -> Expr {
        signed(&self.m * &self.g * factor * &self.sine, self.up)
    }

    /// The same as an acceleration.
    fn fall(&self) -> Expr {
        signed(&self.g * &self.sine, self.up)
    }

    /// The words for where something points that is positive forward.
    fn way<'w>(&self, draft: &Draft<'w>, forward: f64) -> &'w str {
        let value = if self.up { forward } else { -forward };
        solution::way(draft.scene, Owner::Body(self.body), value).map_or("", |phrase| draft.words.get(phrase))
    }

    /// `I_G + m c^2`.
    fn about_contact(&self) -> Expr {
        &self.own + &self.m * square(&self.c)
    }

    /// A quantity that is a magnitude: itself, or under bars where it is negative.
    fn magnitude(page: &mut SectionWriter, symbol: SymbolId, unit: &str) -> SymbolId {
        if page.draft.symbols.value(symbol) >= 0.0 {
            return symbol;
        }
        let name = format!(r"\left|{}\right|", page.draft.symbols.tex(symbol));
        page.quiet(&name, unit, magnitude(symbol))
    }

    // -- the method of the equations of motion ------------------------------------------------------------------------------

    fn motion(&self, draft: &mut Draft) -> Result<ThrownResults, DerivationStop> {
        let mut page = SectionWriter::new(draft, "eom", "thrown.title_eom");
        let slip = self.first_slip(&mut page)?;
        let (normal, slipping) = self.rows(&mut page, slip.sense);
        let (rate, event, phase) = self.end_of_slip(&mut page, &slip, &slipping)?;
        let ways = [Quantity::Displacement, Quantity::Rise, Quantity::Heat, Quantity::SlipDistance];
        let needs_way = ways.iter().any(|q| page.asks(*q));
        let t: Expr = match (phase, event, &self.t1) {
            (SlipPhase::Slips, _, Some(t1)) => t1.clone(),
            (_, Some(event), _) => event.into(),
            (_, None, t1) => t1.clone().unwrap_or(ZERO),
        };
        let (mut state, mut rates) = (self.state(&mut page, phase, &t, &slipping, needs_way), slipping);
        self.rubbed_way(&mut page, phase, &slip, rate, normal, &t);
        if let (SlipPhase::Event, Some(event)) = (phase, event) {
            page.motion(Self::scene_label(Quantity::T), event);
        }
        // Rolling: from the event on, or to be checked.
        let of_rolling =
            [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired, Quantity::Rolls];
        if phase == SlipPhase::Rolls || of_rolling.iter().any(|q| page.asks(*q)) {
            let (a, friction) = self.roll(&mut page);
            page.motion(self.label(Quantity::ARolling), a);
            page.motion(self.label(Quantity::FrictionIfRolled), friction);
            if page.asks(Quantity::MuRequired) {
                let name = page.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
                let size = Self::magnitude(&mut page, friction, "N");
                let mu = page.find(&name, "1", size / normal);
                page.motion(self.label(Quantity::MuRequired), mu);
            }
            if let (SlipPhase::Rolls, Some(t1), Some(event)) = (phase, self.t1.clone(), event) {
                (state, rates) = self.rolling_leg(&mut page, state, (a, friction), t1 - event, needs_way);
            }
        }
        self.answers(&mut page, phase, &state, &rates);
        page.done();
        let rolls = if self.holds(draft) { Word::Yes } else { Word::No };
        draft.from_motion(self.label(Quantity::Rolls), DerivedAnswer::Word(rolls));
        Ok(ThrownResults { phase, slip: slip.start, sense: slip.sense, normal, event, v: state.v })
    }

    /// The slip at the start, its sense, and what friction does against it.
    fn first_slip(&self, page: &mut SectionWriter) -> Result<StartSlip, DerivationStop> {
        let name = &self.names.slip;
        page.say("thrown.slip", &[("slip", name)]);
        let start = page.find(&format!("{name}_0"), "m/s", &self.v0 - &self.c * &self.w0);
        let value = page.draft.symbols.value(start);
        if value == 0.0 {
            return Err(Beyond::ThrownWithoutSlip.into());
        }
        let sense = value.signum();
        let speed = Self::magnitude(page, start, "m/s");
        page.only(self.label(Quantity::SlipSpeed), speed, "thrown.note_slip");
        let (slides, points) =
            (self.way(page.draft, sense).to_owned(), self.way(page.draft, -sense).to_owned());
        let text = [("slip", name.as_str()), ("slides", &slides), ("points", &points)];
        page.say(if sense > 0.0 { "thrown.sense_forward" } else { "thrown.sense_back" }, &text);
        if page.value(&self.v0) * sense < 0.0 {
            page.say("thrown.drives", &[]);
        }
        Ok(StartSlip { start, speed, sense })
    }

    /// The equations of motion while it slips: the normal force, the accelerations and the friction.
    fn rows(&self, page: &mut SectionWriter, sense: f64) -> (SymbolId, LegRates) {
        let names = &self.names;
        let points = self.way(page.draft, -sense).to_owned();
        let force = page.unknown(&names.friction, "N");
        let normal = page.unknown(&names.normal, "N");
        let a = page.unknown(&names.a, "m/s^2");
        let alpha = page.unknown(&names.alpha, "rad/s^2");
        page.say("thrown.rows", &[]);
        let forward = signed(force.clone(), self.up);
        page.equation(&self.m * a, &forward - self.weight());
        let pressing = &self.m * &self.g * &self.cosine;
        page.equation(ZERO, &normal - &pressing);
        page.equation(&self.own * alpha, -(&self.c * forward));
        let friction = |normal: Expr| signed(&self.mu_k * normal, (sense < 0.0) == self.up);
        page.say("thrown.law", &[("points", &points)]);
        page.equation(&force, friction(normal));
        page.say("thrown.numbers", &[("points", &points)]);
        let normal = page.find(&names.normal, "N", &pressing);
        page.motion(self.label(Quantity::Normal), normal);
        let force = page.find(&names.friction, "N", friction(normal.into()));
        let forward = signed(force.into(), self.up);
        let a = page.find(&names.a, "m/s^2", &forward / &self.m - self.fall());
        let alpha = page.find(&names.alpha, "rad/s^2", -(&self.c * forward / &self.own));
        (normal, LegRates { a, alpha, friction: force })
    }

    /// The slip goes evenly: its rate, when it ends if it does, and whether that is before the end of the motion.
    fn end_of_slip(
        &self,
        page: &mut SectionWriter,
        slip: &StartSlip,
        rates: &LegRates,
    ) -> Result<(SymbolId, Option<SymbolId>, SlipPhase), DerivationStop> {
        let names = &self.names;
        page.say("thrown.even", &[("a", &names.a), ("alpha", &names.alpha), ("slip", &names.slip)]);
        let rate_name = format!(r"\dot{{{}}}", names.slip);
        let rate = page.find(&rate_name, "m/s^2", rates.a - &self.c * rates.alpha);
        let event_name = match self.t1 {
            None => page.free(&["t", "t_r"]),
            Some(_) => page.free(&["t_r", "t_e"]),
        };
        let event = if page.draft.symbols.value(rate) * slip.sense < 0.0 {
            page.say("thrown.event", &[("slip", &names.slip), ("rate", &rate_name)]);
            Some(page.find(&event_name, "s", -(slip.start / rate)))
        } else {
            page.say("thrown.no_event", &[("rate", &rate_name)]);
            None
        };
        let holds = self.holds(page.draft);
        let phase = match (&self.t1, event) {
            (None, Some(_)) if holds => SlipPhase::Event,
            (None, _) => return Err(Beyond::NeverRolls.into()),
            (Some(t1), Some(event)) if page.value(t1) > page.draft.symbols.value(event) => {
                if !holds {
                    return Err(Beyond::CannotRoll.into());
                }
                SlipPhase::Rolls
            }
            (Some(_), _) => SlipPhase::Slips,
        };
        if let Some(t1) = &self.t1 {
            let t1 = page.tex(t1);
            let phrase = match (phase, event) {
                (SlipPhase::Rolls, _) => "thrown.by_then",
                (_, Some(_)) => "thrown.not_yet",
                (_, None) => "thrown.never",
            };
            page.say(phrase, &[("asked", &t1), ("event", &event_name)]);
        }
        Ok((rate, event, phase))
    }

    /// The state at the end of the slip, or at the time asked.
    fn state(
        &self,
        page: &mut SectionWriter,
        phase: SlipPhase,
        t: &Expr,
        rates: &LegRates,
        needs_way: bool,
    ) -> LegEnd {
        let names = &self.names;
        let one = if phase == SlipPhase::Rolls { "r" } else { "1" };
        let told = page.tex(t);
        page.say("thrown.state", &[("t", &told)]);
        let after = |start: &Expr, rate: SymbolId| start + rate * t;
        let travelled = |start: &Expr, rate: SymbolId| start * t + half(rate * square(t));
        let v = page.find(&format!("{}_{one}", names.v), "m/s", after(&self.v0, rates.a));
        let spin = format!("{}_{one}", names.omega);
        let w = if phase == SlipPhase::Slips {
            page.find(&spin, "rad/s", after(&self.w0, rates.alpha))
        } else {
            page.say("thrown.rolls_now", &[]);
            page.find(&spin, "rad/s", v / &self.c)
        };
        let x = page.find_if(needs_way, &format!("{}_{one}", names.x), "m", travelled(&self.v0, rates.a));
        let turns = page.asks(Quantity::Phi);
        let turned = travelled(&self.w0, rates.alpha);
        let phi = page.find_if(turns, &format!("{}_{one}", names.phi), "rad", turned);
        if self.turns_back(page.draft, v) && needs_way {
            page.say("thrown.turns_back", &[]);
        }
        LegEnd { v, w, x, phi }
    }

    /// The way of the contact, mean slip times time, and the heat that friction makes on it.
    fn rubbed_way(
        &self,
        page: &mut SectionWriter,
        phase: SlipPhase,
        slip: &StartSlip,
        rate: SymbolId,
        normal: SymbolId,
        t: &Expr,
    ) {
        let names = &self.names;
        let way = if phase == SlipPhase::Slips {
            page.say("thrown.way_slipping", &[("slip", &names.slip)]);
            let left = page.find(&format!("{}_1", names.slip), "m/s", slip.start + rate * t);
            let mean = half(slip.start + left);
            let mean = if slip.sense < 0.0 { magnitude(mean) } else { mean };
            page.find(&names.way, "m", mean * t)
        } else {
            page.say("thrown.way", &[("slip", &names.slip)]);
            page.find(&names.way, "m", half(slip.speed * t))
        };
        page.motion(self.label(Quantity::SlipDistance), way);
        page.say("thrown.heat", &[]);
        let heat = page.find(&names.heat, "J", &self.mu_k * normal * way);
        page.motion(Self::scene_label(Quantity::Heat), heat);
    }

    /// Rolling on from the end of the slip up to the time asked.
    fn rolling_leg(
        &self,
        page: &mut SectionWriter,
        from: LegEnd,
        (a, friction): (SymbolId, SymbolId),
        time: Expr,
        needs_way: bool,
    ) -> (LegEnd, LegRates) {
        let names = &self.names;
        page.say("thrown.leg", &[]);
        let name = format!(r"\Delta {}", page.free(&["t", "t_r"]));
        let left = Expr::Symbol(page.find(&name, "s", time));
        let v = page.find(&format!("{}_1", names.v), "m/s", from.v + a * &left);
        let w = page.find(&format!("{}_1", names.omega), "rad/s", v / &self.c);
        let legs = from.x + from.v * &left + half(a * square(left));
        let x = page.find_if(needs_way, &format!("{}_1", names.x), "m", legs);
        let turned = from.phi + (x - from.x) / &self.c;
        let turns = page.asks(Quantity::Phi);
        let phi = page.find_if(turns, &format!("{}_1", names.phi), "rad", turned);
        let told = page.asks(Quantity::Alpha);
        let alpha = page.find_if(told, &format!("{}_r", names.alpha), "rad/s^2", a / &self.c);
        (LegEnd { v, w, x, phi }, LegRates { a, alpha, friction })
    }

    /// What is asked of the end of the motion.
    fn answers(&self, page: &mut SectionWriter, phase: SlipPhase, end: &LegEnd, rates: &LegRates) {
        for (quantity, symbol, unit) in
            [(Quantity::Omega, end.w, "rad/s"), (Quantity::V, end.v, "m/s"), (Quantity::Phi, end.phi, "rad")]
        {
            let size = Self::magnitude(page, symbol, unit);
            page.motion(self.label(quantity), size);
        }
        for (quantity, symbol) in [
            (Quantity::Displacement, end.x),
            (Quantity::A, rates.a),
            (Quantity::Alpha, rates.alpha),
            (Quantity::Friction, rates.friction),
        ] {
            page.motion(self.label(quantity), symbol);
        }
        if let (SlipPhase::Slips | SlipPhase::Rolls, Some(Expr::Symbol(t1))) = (phase, &self.t1) {
            page.only(Self::scene_label(Quantity::T), *t1, "thrown.note_time");
        }
        if page.asks(Quantity::Rise) {
            page.say("thrown.rise", &[]);
            let rise = page.find("h", "m", signed(end.x * &self.sine, self.up));
            page.only(self.label(Quantity::Rise), rise, "thrown.note_rise");
        }
        if page.asks(Quantity::KineticEnergy) || page.asks(Quantity::RotationalFraction) {
            page.say("thrown.kinetic", &[]);
            let spinning = half(&self.own * square(end.w));
            let energy = half(&self.m * square(end.v)) + &spinning;
            let energy = page.find(&format!("{}_1", self.names.kinetic), "J", energy);
            page.motion(Self::scene_label(Quantity::KineticEnergy), energy);
            if page.asks(Quantity::RotationalFraction) {
                let name = page.free(&[r"\zeta", r"\zeta_r"]);
                let share = page.find(&name, "1", spinning / energy);
                page.only(Self::scene_label(Quantity::RotationalFraction), share, "thrown.note_share");
            }
        }
    }

    /// Does the centre come to rest before the end of a leg that it leaves with this velocity?
    fn turns_back(&self, draft: &Draft, v: SymbolId) -> bool {
        self.v0.value(&draft.symbols) * draft.symbols.value(v) < 0.0
    }

    /// Acceleration of rolling, and the friction that it needs, both positive forward, in doubles.
    fn rolling(&self, draft: &Draft) -> (f64, f64) {
        let of = |e: &Expr| e.value(&draft.symbols);
        let (own, c) = (of(&self.own), of(&self.c));
        let a = -of(&self.weight()) / (of(&self.m) + own / (c * c));
        // No negative zero.
        (a + 0.0, 0.0 - own * a / (c * c))
    }

    /// Can static friction hold it rolling?
    fn holds(&self, draft: &Draft) -> bool {
        let of = |e: &Expr| e.value(&draft.symbols);
        let normal = of(&self.m) * of(&self.g) * of(&self.cosine);
        self.rolling(draft).1.abs() <= of(&self.mu_s) * normal
    }

    /// Acceleration and friction of rolling, by the rows.
    fn roll(&self, page: &mut SectionWriter) -> (SymbolId, SymbolId) {
        let names = &self.names;
        let (a_name, f_name) = (format!("{}_r", names.a), format!("{}_r", names.friction));
        if self.level {
            page.say("thrown.roll_level", &[]);
            return (page.find(&a_name, "m/s^2", &ZERO), page.find(&f_name, "N", &ZERO));
        }
        page.say("thrown.roll", &[("friction", &f_name), ("a", &a_name), ("alpha", &names.alpha)]);
        let a = page.unknown(&a_name, "m/s^2");
        let friction = page.unknown(&f_name, "N");
        let forward = signed(friction, self.up);
        page.equation(&self.m * &a, &forward - self.weight());
        let turning = &self.own * (a / &self.c);
        page.equation(&turning, -(&self.c * forward));
        page.say("thrown.roll_eliminate", &[("friction", &f_name)]);
        let carried = &self.m + &self.own / square(&self.c);
        let a = page.find(&a_name, "m/s^2", -self.weight() / carried);
        let friction = &self.own * a / square(&self.c);
        let friction = page.find(&f_name, "N", signed(friction, !self.up));
        (a, friction)
    }

    // -- the method of momentum, work and energy ----------------------------------------------------------------------------

    fn balance(&self, draft: &mut Draft, worked: &ThrownResults) {
        let mut page = SectionWriter::new(draft, "energy", "thrown.title_energy");
        let by_energy = self.slip_by_energy(&mut page, worked);
        let (v1, w1, x1, phi1) = self.momentum(&mut page, worked, &by_energy);
        for (quantity, symbol, unit) in [(Quantity::V, v1, "m/s"), (Quantity::Omega, w1, "rad/s")] {
            let size = Self::magnitude(&mut page, symbol, unit);
            page.energy(self.label(quantity), size);
        }
        page.energy(self.label(Quantity::Displacement), x1);
        if let Some(phi) = phi1 {
            let turned = Self::magnitude(&mut page, phi, "rad");
            page.energy(self.label(Quantity::Phi), turned);
        }
        self.heat(&mut page, worked, (v1, w1, x1, by_energy.way));
        if worked.phase == SlipPhase::Rolls {
            self.rolling_rate(&mut page, true);
        } else {
            self.friction_by_work(&mut page, (v1, w1, x1, phi1), &by_energy.time);
        }
        if page.asks(Quantity::Normal) {
            page.only(self.label(Quantity::Normal), worked.normal, "thrown.note_normal");
        }
        page.done();
        let value = draft.symbols.value(worked.v);
        let sloped = draft.scene.bodies[self.body].line.is_some_and(|l| l.slope != Slope::Level);
        let word = match (sloped, (value > 0.0) == self.up) {
            _ if value == 0.0 => Word::Stays,
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, _) if value > 0.0 => Word::Forward,
            (false, _) => Word::Back,
        };
        let label = self.label(Quantity::Direction);
        draft.from_motion(label, DerivedAnswer::Word(word));
        draft.from_energy(label, DerivedAnswer::Word(word));
    }

    /// The energy of the slip, which friction takes: how far the contact slips, and how long.
    fn slip_by_energy(&self, page: &mut SectionWriter, worked: &ThrownResults) -> SlipByEnergy {
        let names = &self.names;
        let (h, v, w) = (&names.momentum, &names.v, &names.omega);
        page.say("thrown.split", &[]);
        let (vs, ws) = (page.unknown(v, "m/s"), page.unknown(w, "rad/s"));
        let us = page.unknown(&names.slip, "m/s");
        let hs = page.unknown(h, "kg m^2/s");
        let reduced_name = page.free(&["m_u", "m_s"]);
        let ms = page.unknown(&reduced_name, "kg");
        let plain = half(&self.m * square(&vs)) + half(&self.own * square(&ws));
        let split = square(&hs) / (whole(2) * self.about_contact()) + half(ms * square(&us));
        let (left, right) = (page.tex(&plain), page.tex(&split));
        page.formula(format!("{} = {left} = {right}", names.kinetic));
        page.equation(&hs, &self.own * ws + &self.m * &self.c * vs);
        let reduced = page.find(&reduced_name, "kg", &self.m * &self.own / self.about_contact());
        let phrase = if self.level { "thrown.slip_energy_level" } else { "thrown.slip_energy" };
        page.say(phrase, &[("reduced", &reduced_name)]);
        // Loss of the slip's energy per metre of its way.
        let pulled = signed(reduced * &self.g * &self.sine, self.up == (worked.sense > 0.0));
        let loss_name = page.free(&["D", "F_u"]);
        if !self.level {
            page.say("thrown.loss_incline", &[("loss", &loss_name)]);
        }
        let loss = page.find(&loss_name, "N", &self.mu_k * worked.normal + pulled);
        let slip_speed = Self::magnitude(page, worked.slip, "m/s");
        let by_energy = if let (SlipPhase::Slips, Some(t1)) = (worked.phase, self.t1.clone()) {
            page.say("thrown.slip_impulse", &[("slip", &names.slip)]);
            let left = worked.slip + signed(loss * &t1 / reduced, worked.sense < 0.0);
            let left = page.find(&format!("{}_1", names.slip), "m/s", left);
            let lost = reduced * (square(worked.slip) - square(left));
            page.say("thrown.slip_way_part", &[]);
            let way = page.find(&names.way, "m", lost / (whole(2) * loss));
            SlipByEnergy { way, left: left.into(), time: t1, event: None }
        } else {
            page.say("thrown.slip_way", &[]);
            let stored = reduced * square(worked.slip);
            let way = page.find(&names.way, "m", stored / (whole(2) * loss));
            page.say("thrown.slip_time", &[]);
            let name = worked.event.map_or_else(String::new, |e| page.draft.symbols.tex(e).to_owned());
            let until = page.find(&name, "s", whole(2) * way / slip_speed);
            SlipByEnergy { way, left: ZERO, time: until.into(), event: Some(until) }
        };
        page.energy(self.label(Quantity::SlipDistance), by_energy.way);
        if let (SlipPhase::Event, Some(event)) = (worked.phase, by_energy.event) {
            page.energy(Self::scene_label(Quantity::T), event);
        }
        by_energy
    }

    /// Velocity, spin, displacement and, if it is asked, angle at the end, from the angular momentum about the surface.
    fn momentum(
        &self,
        page: &mut SectionWriter,
        worked: &ThrownResults,
        by_energy: &SlipByEnergy,
    ) -> (SymbolId, SymbolId, SymbolId, Option<SymbolId>) {
        let names = &self.names;
        let (h, v, w) = (&names.momentum, &names.v, &names.omega);
        let (slips, slid, slip_left) = (worked.phase == SlipPhase::Slips, &by_energy.time, &by_energy.left);
        page.say(if self.level { "thrown.momentum_level" } else { "thrown.momentum" }, &[("momentum", h)]);
        let momentum = &self.own * &self.w0 + &self.m * &self.c * &self.v0;
        let h0 = page.find(&format!("{h}_0"), "kg m^2/s", momentum);
        let one = if worked.phase == SlipPhase::Rolls { "r" } else { "1" };
        let momentum_after = |page: &mut SectionWriter, t: &Expr, one: &str| match self.level {
            true => h0,
            false => page.find(&format!("{h}_{one}"), "kg m^2/s", h0 - self.weight_times(&self.c * t)),
        };
        let h1 = momentum_after(page, slid, one);
        let about = self.about_contact();
        page.say(if slips { "thrown.speeds_slipping" } else { "thrown.speeds" }, &[]);
        let centre = |h: SymbolId, left: &Expr| (&self.c * h + &self.own * left) / &about;
        let mut v1 = page.find(&format!("{v}_{one}"), "m/s", centre(h1, slip_left));
        if self.level && !slips {
            page.say("thrown.any_friction", &[]);
        }
        let spin = |v: SymbolId, left: &Expr| (v - left) / &self.c;
        let mut w1 = page.find(&format!("{w}_{one}"), "rad/s", spin(v1, slip_left));
        let mean = |from: Expr, to: SymbolId, t: &Expr| half(from + to) * t;
        page.say("thrown.mean", &[]);
        let mut x1 = page.find(&format!("{}_{one}", names.x), "m", mean(self.v0.clone(), v1, slid));
        let mut phi1 = None;
        if page.asks(Quantity::Phi) {
            let turned = mean(self.w0.clone(), w1, slid);
            phi1 = Some(page.find(&format!("{}_{one}", names.phi), "rad", turned));
        }
        if let (SlipPhase::Rolls, Some(t1), Some(event)) = (worked.phase, self.t1.clone(), by_energy.event) {
            let (v_slip, x_slip, w_slip) = (v1, x1, w1);
            page.say("thrown.momentum_on", &[]);
            let h_end = momentum_after(page, &t1, "1");
            v1 = page.find(&format!("{v}_1"), "m/s", centre(h_end, &ZERO));
            w1 = page.find(&format!("{w}_1"), "rad/s", spin(v1, &ZERO));
            let left = t1 - event;
            x1 = page.find(&format!("{}_1", names.x), "m", x_slip + mean(v_slip.into(), v1, &left));
            if let Some(phi) = phi1 {
                let legs = phi + mean(w_slip.into(), w1, &left);
                phi1 = Some(page.find(&format!("{}_1", names.phi), "rad", legs));
            }
        }
        (v1, w1, x1, phi1)
    }

    /// The whole balance: what is missing is heat.
    fn heat(
        &self,
        page: &mut SectionWriter,
        worked: &ThrownResults,
        (v1, w1, x1, way): (SymbolId, SymbolId, SymbolId, SymbolId),
    ) {
        let names = &self.names;
        let kinetic = |v: Expr, w: Expr| half(&self.m * square(&v)) + half(&self.own * square(&w));
        page.say("thrown.balance", &[]);
        let t0 = page.find(&format!("{}_0", names.kinetic), "J", kinetic(self.v0.clone(), self.w0.clone()));
        let t1 = page.find(&format!("{}_1", names.kinetic), "J", kinetic(v1.into(), w1.into()));
        page.energy(Self::scene_label(Quantity::KineticEnergy), t1);
        let mut left = t0 - t1;
        if !self.level {
            page.say("thrown.weight_work", &[]);
            let work = page.find("W_g", "J", -self.weight_times(x1.into()));
            left = t0 + work - t1;
        }
        page.say("thrown.heat_energy", &[]);
        let heat = page.find(&names.heat, "J", &left);
        page.energy(Self::scene_label(Quantity::Heat), heat);
        let rubbed = &self.mu_k * worked.normal * way;
        let text = page.tex(&rubbed);
        let again = page.quiet(&text, "J", &rubbed);
        let same = format!("{text} = {}", page.draft.symbols.shown(again));
        page.say("thrown.heat_same", &[("same", &same)]);
        page.picture("energy");
    }

    /// Friction and accelerations while it slips, from the work of the forces on the mass centre or in the rotation.
    fn friction_by_work(
        &self,
        page: &mut SectionWriter,
        (v1, w1, x1, phi1): (SymbolId, SymbolId, SymbolId, Option<SymbolId>),
        t: &Expr,
    ) {
        let names = &self.names;
        let asks = |page: &SectionWriter, q| page.asks(q);
        if asks(page, Quantity::Friction) {
            // The way of the centre, or the angle, whichever is further from nothing.
            let value = |page: &SectionWriter, s: SymbolId| page.draft.symbols.value(s);
            let most = |page: &SectionWriter, start: &Expr, end: SymbolId| {
                page.value(start).abs().max(value(page, end).abs()) * page.value(t)
            };
            let share_x = value(page, x1).abs() / most(page, &self.v0, v1);
            if share_x > 0.02 {
                page.say("thrown.work_centre", &[("friction", &names.friction)]);
                let gained = &self.m * (square(v1) - square(&self.v0));
                let over = whole(2) * x1;
                let forward = gained / over + self.weight();
                let force = page.find(&names.friction, "N", signed(forward, self.up));
                page.energy(self.label(Quantity::Friction), force);
            } else {
                let turned = match phi1 {
                    Some(phi) => phi,
                    None => {
                        let angle = half(&self.w0 + w1) * t;
                        page.find(&format!("{}_1", names.phi), "rad", &angle)
                    }
                };
                page.say("thrown.work_turn", &[("friction", &names.friction)]);
                let squares = square(w1) - square(&self.w0);
                let gained = &self.own * squares;
                let over = whole(2) * &self.c * turned;
                let forward = -(gained / over);
                let force = page.find(&names.friction, "N", signed(forward, self.up));
                page.energy(self.label(Quantity::Friction), force);
            }
        }
        if asks(page, Quantity::A) || asks(page, Quantity::Alpha) {
            page.say("thrown.gain", &[]);
        }
        if asks(page, Quantity::A) {
            let gain = (v1 - &self.v0) / t;
            let a = page.find(&names.a, "m/s^2", &gain);
            page.energy(self.label(Quantity::A), a);
        }
        if asks(page, Quantity::Alpha) {
            let gain = (w1 - &self.w0) / t;
            let alpha = page.find(&names.alpha, "rad/s^2", &gain);
            page.energy(self.label(Quantity::Alpha), alpha);
        }
        let rolling = [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired];
        if rolling.iter().any(|q| asks(page, *q)) {
            self.rolling_rate(page, false);
        }
    }

    /// Acceleration and friction of rolling from the rate of the balance; does it roll at the end?
    fn rolling_rate(&self, page: &mut SectionWriter, rolls: bool) {
        let names = &self.names;
        let (a_name, f_name) = (format!("{}_r", names.a), format!("{}_r", names.friction));
        page.say(if self.level { "thrown.rate_level" } else { "thrown.rate" }, &[]);
        let (a, friction) = if self.level {
            (page.find(&a_name, "m/s^2", &ZERO), page.find(&f_name, "N", &ZERO))
        } else {
            let over = -self.weight_times(square(self.c.clone()));
            let a = page.find(&a_name, "m/s^2", over / self.about_contact());
            page.say("thrown.rate_friction", &[("friction", &f_name)]);
            let forward = &self.m * a + self.weight();
            (a, page.find(&f_name, "N", signed(forward, self.up)))
        };
        page.energy(self.label(Quantity::ARolling), a);
        page.energy(self.label(Quantity::FrictionIfRolled), friction);
        if rolls {
            page.energy(self.label(Quantity::A), a);
            page.energy(self.label(Quantity::Friction), friction);
            if page.asks(Quantity::Alpha) {
                let turning = a / &self.c;
                let alpha = page.find(&format!("{}_r", names.alpha), "rad/s^2", &turning);
                page.energy(self.label(Quantity::Alpha), alpha);
            }
        }
        if page.asks(Quantity::MuRequired) {
            let label = self.label(Quantity::MuRequired);
            let size = Self::magnitude(page, friction, "N");
            let normal = &self.m * &self.g * &self.cosine;
            let name = page.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
            let mu = page.quiet(&name, "1", size / normal);
            page.energy(label, mu);
        }
    }
}

// -- what was assumed, and what suggests itself ---------------------------------------------------------------------------

impl ThrownBody {
    /// Does the slip keep its sense, and can it roll on?
    fn regime(&self, draft: &mut Draft, worked: &ThrownResults) {
        let names = &self.names;
        let mut page = SectionWriter::new(draft, "regime", "thrown.title_regime");
        let slip = names.slip.as_str();
        let normal = page.rough(page.draft.symbols.value(worked.normal), "N");
        page.say("thrown.check_pressed", &[("normal", &names.normal), ("size", &normal)]);
        if worked.phase == SlipPhase::Slips {
            page.say("thrown.check_slips", &[("slip", slip)]);
        } else {
            page.say("thrown.check_event", &[("slip", slip)]);
            if self.level {
                page.say("thrown.check_level", &[]);
            } else {
                let known =
                    page.draft.found.iter().any(|f| f.label == self.label(Quantity::FrictionIfRolled));
                let friction = if known {
                    let of = |f: &solution::draft::FoundAnswer| match f.eom {
                        Some(DerivedAnswer::Value(symbol)) => Some(symbol),
                        _ => None,
                    };
                    let found =
                        page.draft.found.iter().find(|f| f.label == self.label(Quantity::FrictionIfRolled));
                    found.and_then(of)
                } else {
                    None
                };
                let friction = match friction {
                    Some(friction) => friction,
                    None => self.roll(&mut page).1,
                };
                let size = Self::magnitude(&mut page, friction, "N");
                let limit = &self.mu_s * worked.normal;
                let needed = page.with_value(size);
                page.say("thrown.check_grip", &[("needed", &needed)]);
                let name = page.free(&[r"F_{\mathrm{max}}", "F_m"]);
                page.find(&name, "N", &limit);
                page.say("thrown.rolls_on", &[]);
            }
        }
        let value = page.draft.symbols.value(worked.v);
        let way = self.way(page.draft, value).to_owned();
        let v = page.draft.symbols.tex(worked.v).to_owned();
        page.picture("graph-slip");
        if value > 0.0 {
            page.say("thrown.moves_forward", &[("v", &v), ("way", &way)]);
        } else if value < 0.0 {
            page.say("thrown.moves_back", &[("v", &v), ("way", &way)]);
        }
        page.done();
    }
}
