//! A body thrown with slip, worked: friction against the slip until the contact is at rest, rolling from then on; then by
//! the angular momentum about the surface, in which friction has no lever, the energy of the slip, and the whole balance with
//! its heat.
use crate::scene::End;
use crate::scene::Label;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Slope;
use crate::scene::Thrown;
use crate::solution;
use crate::solution::desk::Answer;
use crate::solution::desk::Desk;
use crate::solution::expr::Expr;
use crate::solution::expr::ONE;
use crate::solution::expr::Symbol;
use crate::solution::expr::ZERO;
use crate::solution::expr::cosine;
use crate::solution::expr::magnitude;
use crate::solution::expr::number as whole;
use crate::solution::expr::ratio;
use crate::solution::expr::signed;
use crate::solution::expr::sine;
use crate::solution::expr::square;
use crate::solution::mass;
use crate::solution::pen::Pen;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solve::outcome::Word;

/// The body in symbols.
struct Throw {
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
    names: Names,
}

/// How the unknowns are written.
struct Names {
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
enum Phase {
    /// The end is the start of rolling.
    Event,
    /// It still slips.
    Slips,
    /// It rolls by then.
    Rolls,
}

/// What the first road has found and the second needs.
struct Worked {
    phase: Phase,
    /// Slip at the start, positive forward.
    slip: Symbol,
    /// Sense of the slip: 1 forward.
    sense: f64,
    normal: Symbol,
    /// Time of the event, if it comes.
    event: Option<Symbol>,
    /// Velocity of the centre at the end.
    v: Symbol,
}

/// The slip at the start.
struct Slip {
    /// Positive forward.
    start: Symbol,
    /// Its size.
    speed: Symbol,
    /// 1 forward, -1 back.
    sense: f64,
}

/// Velocity, spin, displacement and angle at the end of a leg.
struct State {
    v: Symbol,
    w: Symbol,
    x: Symbol,
    phi: Symbol,
}

/// The slip, from its energy.
struct SlipByEnergy {
    /// How far the contact slips.
    way: Symbol,
    /// The slip that is left at the end.
    left: Expr,
    /// How long it slips.
    time: Expr,
    /// The same where the slip ends before the motion does.
    event: Option<Symbol>,
}

/// Accelerations and friction on a leg.
struct Rates {
    a: Symbol,
    alpha: Symbol,
    friction: Symbol,
}

/// Half of it.
fn half(e: Expr) -> Expr {
    ratio(1, 2) * e
}

/// Writes the sections of a body thrown with slip.
///
/// # Errors
/// What this derivation does not cover.
pub fn work(desk: &mut Desk) -> Result<(), Stop> {
    let Some(thrown) = desk.scene.thrown() else {
        return Err(Beyond::Arrangement.into());
    };
    let throw = read(desk, &thrown)?;
    let worked = throw.motion(desk)?;
    throw.balance(desk, &worked);
    throw.regime(desk, &worked);
    Ok(())
}

/// Free body and inertia.
fn read(desk: &mut Desk, thrown: &Thrown) -> Result<Throw, Stop> {
    let scene = desk.scene;
    let body = thrown.body;
    let Some(line) = scene.bodies[body].line else {
        return Err(Beyond::Arrangement.into());
    };
    let theta = match line.slope {
        Slope::Level => None,
        Slope::Degrees(angle) => Some(desk.number(angle, r"\theta", "deg")),
        Slope::Vertical => {
            return Err(Beyond::ThrownVertically.into());
        }
    };
    let theta = theta.filter(|t| *t != ZERO);
    let names = Names {
        a: desk.free(&["a", "a_G"]),
        alpha: desk.free(&[r"\alpha", r"\alpha_G"]),
        friction: desk.free(&["F", "F_f"]),
        normal: desk.free(&["N", "F_N"]),
        slip: desk.free(&["u", "w"]),
        v: desk.free(&["v", "v_G"]),
        omega: desk.free(&[r"\omega", r"\Omega"]),
        x: desk.free(&["x", "x_G"]),
        phi: desk.free(&[r"\phi", r"\varphi", r"\psi"]),
        way: desk.free(&["l", r"\ell", r"\lambda"]),
        heat: desk.free(&["Q", "Q_f"]),
        kinetic: desk.free(&["T", "E"]),
        momentum: desk.free(&["H", "L_A"]),
    };
    let c = desk.number(thrown.radius_m, "R", "m");
    let g = desk.number(scene.gravity_m_s2, "g", "m/s^2");
    let mu_s = desk.number(thrown.mu_s, r"\mu_s", "1");
    let mu_k = desk.number(thrown.mu_k, r"\mu_k", "1");
    let v0 = desk.number(thrown.speed_m_s, "v_0", "m/s");
    let w0 = desk.number(thrown.spin_rad_s, r"\omega_0", "rad/s");
    let t1 = match scene.end {
        End::Time(_, t) => Some(desk.number(t, "t_1", "s")),
        End::Rolling(_) => None,
        _ => {
            return Err(Beyond::OtherEnd.into());
        }
    };

    let mut pen = Pen::new(desk, "forces", "thrown.title_forces");
    pen.picture("scene");
    let inclined = theta.is_some();
    pen.say(
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
    pen.say(positive, &[("friction", &names.friction)]);
    pen.picture(&format!("forces-{}", scene.bodies[body].name));
    let m = mass::mass(&mut pen, body);
    let own = mass::inertia(&mut pen, body, &m);
    if own == ZERO {
        return Err(Beyond::ThrownWithoutInertia.into());
    }
    pen.done();
    Ok(Throw {
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

impl Throw {
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
    fn way<'w>(&self, desk: &Desk<'w>, forward: f64) -> &'w str {
        let value = if self.up { forward } else { -forward };
        solution::way(desk.scene, Owner::Body(self.body), value).map_or("", |phrase| desk.words.get(phrase))
    }

    /// `I_G + m c^2`.
    fn about_contact(&self) -> Expr {
        &self.own + &self.m * square(&self.c)
    }

    /// A quantity that is a magnitude: itself, or under bars where it is negative.
    fn magnitude(pen: &mut Pen, symbol: Symbol, unit: &str) -> Symbol {
        if pen.desk.ledger.value(symbol) >= 0.0 {
            return symbol;
        }
        let name = format!(r"\left|{}\right|", pen.desk.ledger.tex(symbol));
        pen.quiet(&name, unit, magnitude(symbol))
    }

    // -- the road of the equations of motion ------------------------------------------------------------------------------

    fn motion(&self, desk: &mut Desk) -> Result<Worked, Stop> {
        let mut pen = Pen::new(desk, "eom", "thrown.title_eom");
        let slip = self.first_slip(&mut pen)?;
        let (normal, slipping) = self.rows(&mut pen, slip.sense);
        let (rate, event, phase) = self.end_of_slip(&mut pen, &slip, &slipping)?;
        let ways = [Quantity::Displacement, Quantity::Rise, Quantity::Heat, Quantity::SlipDistance];
        let needs_way = ways.iter().any(|q| pen.desk.asks(*q));
        let t: Expr = match (phase, event, &self.t1) {
            (Phase::Slips, _, Some(t1)) => t1.clone(),
            (_, Some(event), _) => event.into(),
            (_, None, t1) => t1.clone().unwrap_or(ZERO),
        };
        let (mut state, mut rates) = (self.state(&mut pen, phase, &t, &slipping, needs_way), slipping);
        self.rubbed_way(&mut pen, phase, &slip, rate, normal, &t);
        if let (Phase::Event, Some(event)) = (phase, event) {
            pen.motion(Self::scene_label(Quantity::T), event);
        }
        // Rolling: from the event on, or to be checked.
        let of_rolling =
            [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired, Quantity::Rolls];
        if phase == Phase::Rolls || of_rolling.iter().any(|q| pen.desk.asks(*q)) {
            let (a, friction) = self.roll(&mut pen);
            pen.motion(self.label(Quantity::ARolling), a);
            pen.motion(self.label(Quantity::FrictionIfRolled), friction);
            if pen.desk.asks(Quantity::MuRequired) {
                let name = pen.desk.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
                let size = Self::magnitude(&mut pen, friction, "N");
                let mu = pen.find(&name, "1", size / normal);
                pen.motion(self.label(Quantity::MuRequired), mu);
            }
            if let (Phase::Rolls, Some(t1), Some(event)) = (phase, self.t1.clone(), event) {
                (state, rates) = self.rolling_leg(&mut pen, state, (a, friction), t1 - event, needs_way);
            }
        }
        self.answers(&mut pen, phase, &state, &rates);
        pen.done();
        let rolls = if self.holds(desk) { Word::Yes } else { Word::No };
        desk.from_motion(self.label(Quantity::Rolls), Answer::Word(rolls));
        Ok(Worked { phase, slip: slip.start, sense: slip.sense, normal, event, v: state.v })
    }

    /// The slip at the start, its sense, and what friction does against it.
    fn first_slip(&self, pen: &mut Pen) -> Result<Slip, Stop> {
        let name = &self.names.slip;
        pen.say("thrown.slip", &[("slip", name)]);
        let start = pen.find(&format!("{name}_0"), "m/s", &self.v0 - &self.c * &self.w0);
        let value = pen.desk.ledger.value(start);
        if value == 0.0 {
            return Err(Beyond::ThrownWithoutSlip.into());
        }
        let sense = value.signum();
        let speed = Self::magnitude(pen, start, "m/s");
        pen.only(self.label(Quantity::SlipSpeed), speed, "thrown.note_slip");
        let (slides, points) = (self.way(pen.desk, sense).to_owned(), self.way(pen.desk, -sense).to_owned());
        let text = [("slip", name.as_str()), ("slides", &slides), ("points", &points)];
        pen.say(if sense > 0.0 { "thrown.sense_forward" } else { "thrown.sense_back" }, &text);
        if pen.value(&self.v0) * sense < 0.0 {
            pen.say("thrown.drives", &[]);
        }
        Ok(Slip { start, speed, sense })
    }

    /// The equations of motion while it slips: the normal force, the accelerations and the friction.
    fn rows(&self, pen: &mut Pen, sense: f64) -> (Symbol, Rates) {
        let names = &self.names;
        let points = self.way(pen.desk, -sense).to_owned();
        let force = pen.unknown(&names.friction, "N");
        let normal = pen.unknown(&names.normal, "N");
        let a = pen.unknown(&names.a, "m/s^2");
        let alpha = pen.unknown(&names.alpha, "rad/s^2");
        pen.say("thrown.rows", &[]);
        let forward = signed(force.clone(), self.up);
        pen.equation(&self.m * a, &forward - self.weight());
        let pressing = &self.m * &self.g * &self.cosine;
        pen.equation(ZERO, &normal - &pressing);
        pen.equation(&self.own * alpha, -(&self.c * forward));
        let friction = |normal: Expr| signed(&self.mu_k * normal, (sense < 0.0) == self.up);
        pen.say("thrown.law", &[("points", &points)]);
        pen.equation(&force, friction(normal));
        pen.say("thrown.numbers", &[("points", &points)]);
        let normal = pen.find(&names.normal, "N", &pressing);
        pen.motion(self.label(Quantity::Normal), normal);
        let force = pen.find(&names.friction, "N", friction(normal.into()));
        let forward = signed(force.into(), self.up);
        let a = pen.find(&names.a, "m/s^2", &forward / &self.m - self.fall());
        let alpha = pen.find(&names.alpha, "rad/s^2", -(&self.c * forward / &self.own));
        (normal, Rates { a, alpha, friction: force })
    }

    /// The slip goes evenly: its rate, when it ends if it does, and whether that is before the end of the motion.
    fn end_of_slip(
        &self,
        pen: &mut Pen,
        slip: &Slip,
        rates: &Rates,
    ) -> Result<(Symbol, Option<Symbol>, Phase), Stop> {
        let names = &self.names;
        pen.say("thrown.even", &[("a", &names.a), ("alpha", &names.alpha), ("slip", &names.slip)]);
        let rate_name = format!(r"\dot{{{}}}", names.slip);
        let rate = pen.find(&rate_name, "m/s^2", rates.a - &self.c * rates.alpha);
        let event_name = match self.t1 {
            None => pen.desk.free(&["t", "t_r"]),
            Some(_) => pen.desk.free(&["t_r", "t_e"]),
        };
        let event = if pen.desk.ledger.value(rate) * slip.sense < 0.0 {
            pen.say("thrown.event", &[("slip", &names.slip), ("rate", &rate_name)]);
            Some(pen.find(&event_name, "s", -(slip.start / rate)))
        } else {
            pen.say("thrown.no_event", &[("rate", &rate_name)]);
            None
        };
        let holds = self.holds(pen.desk);
        let phase = match (&self.t1, event) {
            (None, Some(_)) if holds => Phase::Event,
            (None, _) => return Err(Beyond::NeverRolls.into()),
            (Some(t1), Some(event)) if pen.value(t1) > pen.desk.ledger.value(event) => {
                if !holds {
                    return Err(Beyond::CannotRoll.into());
                }
                Phase::Rolls
            }
            (Some(_), _) => Phase::Slips,
        };
        if let Some(t1) = &self.t1 {
            let t1 = pen.tex(t1);
            let phrase = match (phase, event) {
                (Phase::Rolls, _) => "thrown.by_then",
                (_, Some(_)) => "thrown.not_yet",
                (_, None) => "thrown.never",
            };
            pen.say(phrase, &[("asked", &t1), ("event", &event_name)]);
        }
        Ok((rate, event, phase))
    }

    /// The state at the end of the slip, or at the time asked.
    fn state(&self, pen: &mut Pen, phase: Phase, t: &Expr, rates: &Rates, needs_way: bool) -> State {
        let names = &self.names;
        let one = if phase == Phase::Rolls { "r" } else { "1" };
        let told = pen.tex(t);
        pen.say("thrown.state", &[("t", &told)]);
        let after = |start: &Expr, rate: Symbol| start + rate * t;
        let travelled = |start: &Expr, rate: Symbol| start * t + half(rate * square(t));
        let v = pen.find(&format!("{}_{one}", names.v), "m/s", after(&self.v0, rates.a));
        let spin = format!("{}_{one}", names.omega);
        let w = if phase == Phase::Slips {
            pen.find(&spin, "rad/s", after(&self.w0, rates.alpha))
        } else {
            pen.say("thrown.rolls_now", &[]);
            pen.find(&spin, "rad/s", v / &self.c)
        };
        let x = pen.find_if(needs_way, &format!("{}_{one}", names.x), "m", travelled(&self.v0, rates.a));
        let turns = pen.desk.asks(Quantity::Phi);
        let turned = travelled(&self.w0, rates.alpha);
        let phi = pen.find_if(turns, &format!("{}_{one}", names.phi), "rad", turned);
        if self.turns_back(pen.desk, v) && needs_way {
            pen.say("thrown.turns_back", &[]);
        }
        State { v, w, x, phi }
    }

    /// The way of the contact, mean slip times time, and the heat that friction makes on it.
    fn rubbed_way(&self, pen: &mut Pen, phase: Phase, slip: &Slip, rate: Symbol, normal: Symbol, t: &Expr) {
        let names = &self.names;
        let way = if phase == Phase::Slips {
            pen.say("thrown.way_slipping", &[("slip", &names.slip)]);
            let left = pen.find(&format!("{}_1", names.slip), "m/s", slip.start + rate * t);
            let mean = half(slip.start + left);
            let mean = if slip.sense < 0.0 { magnitude(mean) } else { mean };
            pen.find(&names.way, "m", mean * t)
        } else {
            pen.say("thrown.way", &[("slip", &names.slip)]);
            pen.find(&names.way, "m", half(slip.speed * t))
        };
        pen.motion(self.label(Quantity::SlipDistance), way);
        pen.say("thrown.heat", &[]);
        let heat = pen.find(&names.heat, "J", &self.mu_k * normal * way);
        pen.motion(Self::scene_label(Quantity::Heat), heat);
    }

    /// Rolling on from the end of the slip up to the time asked.
    fn rolling_leg(
        &self,
        pen: &mut Pen,
        from: State,
        (a, friction): (Symbol, Symbol),
        time: Expr,
        needs_way: bool,
    ) -> (State, Rates) {
        let names = &self.names;
        pen.say("thrown.leg", &[]);
        let name = format!(r"\Delta {}", pen.desk.free(&["t", "t_r"]));
        let left = Expr::Symbol(pen.find(&name, "s", time));
        let v = pen.find(&format!("{}_1", names.v), "m/s", from.v + a * &left);
        let w = pen.find(&format!("{}_1", names.omega), "rad/s", v / &self.c);
        let legs = from.x + from.v * &left + half(a * square(left));
        let x = pen.find_if(needs_way, &format!("{}_1", names.x), "m", legs);
        let turned = from.phi + (x - from.x) / &self.c;
        let turns = pen.desk.asks(Quantity::Phi);
        let phi = pen.find_if(turns, &format!("{}_1", names.phi), "rad", turned);
        let told = pen.desk.asks(Quantity::Alpha);
        let alpha = pen.find_if(told, &format!("{}_r", names.alpha), "rad/s^2", a / &self.c);
        (State { v, w, x, phi }, Rates { a, alpha, friction })
    }

    /// What is asked of the end of the motion.
    fn answers(&self, pen: &mut Pen, phase: Phase, end: &State, rates: &Rates) {
        for (quantity, symbol, unit) in
            [(Quantity::Omega, end.w, "rad/s"), (Quantity::V, end.v, "m/s"), (Quantity::Phi, end.phi, "rad")]
        {
            let size = Self::magnitude(pen, symbol, unit);
            pen.motion(self.label(quantity), size);
        }
        for (quantity, symbol) in [
            (Quantity::Displacement, end.x),
            (Quantity::A, rates.a),
            (Quantity::Alpha, rates.alpha),
            (Quantity::Friction, rates.friction),
        ] {
            pen.motion(self.label(quantity), symbol);
        }
        if let (Phase::Slips | Phase::Rolls, Some(Expr::Symbol(t1))) = (phase, &self.t1) {
            pen.only(Self::scene_label(Quantity::T), *t1, "thrown.note_time");
        }
        if pen.desk.asks(Quantity::Rise) {
            pen.say("thrown.rise", &[]);
            let rise = pen.find("h", "m", signed(end.x * &self.sine, self.up));
            pen.only(self.label(Quantity::Rise), rise, "thrown.note_rise");
        }
        if pen.desk.asks(Quantity::KineticEnergy) || pen.desk.asks(Quantity::RotationalFraction) {
            pen.say("thrown.kinetic", &[]);
            let spinning = half(&self.own * square(end.w));
            let energy = half(&self.m * square(end.v)) + &spinning;
            let energy = pen.find(&format!("{}_1", self.names.kinetic), "J", energy);
            pen.motion(Self::scene_label(Quantity::KineticEnergy), energy);
            if pen.desk.asks(Quantity::RotationalFraction) {
                let name = pen.desk.free(&[r"\zeta", r"\zeta_r"]);
                let share = pen.find(&name, "1", spinning / energy);
                pen.only(Self::scene_label(Quantity::RotationalFraction), share, "thrown.note_share");
            }
        }
    }

    /// Does the centre come to rest before the end of a leg that it leaves with this velocity?
    fn turns_back(&self, desk: &Desk, v: Symbol) -> bool {
        self.v0.value(&desk.ledger) * desk.ledger.value(v) < 0.0
    }

    /// Acceleration of rolling, and the friction that it needs, both positive forward, in doubles.
    fn rolling(&self, desk: &Desk) -> (f64, f64) {
        let of = |e: &Expr| e.value(&desk.ledger);
        let (own, c) = (of(&self.own), of(&self.c));
        let a = -of(&self.weight()) / (of(&self.m) + own / (c * c));
        // No negative zero.
        (a + 0.0, 0.0 - own * a / (c * c))
    }

    /// Can static friction hold it rolling?
    fn holds(&self, desk: &Desk) -> bool {
        let of = |e: &Expr| e.value(&desk.ledger);
        let normal = of(&self.m) * of(&self.g) * of(&self.cosine);
        self.rolling(desk).1.abs() <= of(&self.mu_s) * normal
    }

    /// Acceleration and friction of rolling, by the rows.
    fn roll(&self, pen: &mut Pen) -> (Symbol, Symbol) {
        let names = &self.names;
        let (a_name, f_name) = (format!("{}_r", names.a), format!("{}_r", names.friction));
        if self.level {
            pen.say("thrown.roll_level", &[]);
            return (pen.find(&a_name, "m/s^2", &ZERO), pen.find(&f_name, "N", &ZERO));
        }
        pen.say("thrown.roll", &[("friction", &f_name), ("a", &a_name), ("alpha", &names.alpha)]);
        let a = pen.unknown(&a_name, "m/s^2");
        let friction = pen.unknown(&f_name, "N");
        let forward = signed(friction, self.up);
        pen.equation(&self.m * &a, &forward - self.weight());
        let turning = &self.own * (a / &self.c);
        pen.equation(&turning, -(&self.c * forward));
        pen.say("thrown.roll_eliminate", &[("friction", &f_name)]);
        let carried = &self.m + &self.own / square(&self.c);
        let a = pen.find(&a_name, "m/s^2", -self.weight() / carried);
        let friction = &self.own * a / square(&self.c);
        let friction = pen.find(&f_name, "N", signed(friction, !self.up));
        (a, friction)
    }

    // -- the road of momentum, work and energy ----------------------------------------------------------------------------

    fn balance(&self, desk: &mut Desk, worked: &Worked) {
        let mut pen = Pen::new(desk, "energy", "thrown.title_energy");
        let by_energy = self.slip_by_energy(&mut pen, worked);
        let (v1, w1, x1, phi1) = self.momentum(&mut pen, worked, &by_energy);
        for (quantity, symbol, unit) in [(Quantity::V, v1, "m/s"), (Quantity::Omega, w1, "rad/s")] {
            let size = Self::magnitude(&mut pen, symbol, unit);
            pen.energy(self.label(quantity), size);
        }
        pen.energy(self.label(Quantity::Displacement), x1);
        if let Some(phi) = phi1 {
            let turned = Self::magnitude(&mut pen, phi, "rad");
            pen.energy(self.label(Quantity::Phi), turned);
        }
        self.heat(&mut pen, worked, (v1, w1, x1, by_energy.way));
        if worked.phase == Phase::Rolls {
            self.rolling_rate(&mut pen, true);
        } else {
            self.friction_by_work(&mut pen, (v1, w1, x1, phi1), &by_energy.time);
        }
        if pen.desk.asks(Quantity::Normal) {
            pen.only(self.label(Quantity::Normal), worked.normal, "thrown.note_normal");
        }
        pen.done();
        let value = desk.ledger.value(worked.v);
        let sloped = desk.scene.bodies[self.body].line.is_some_and(|l| l.slope != Slope::Level);
        let word = match (sloped, (value > 0.0) == self.up) {
            _ if value == 0.0 => Word::Stays,
            (true, true) => Word::Up,
            (true, false) => Word::Down,
            (false, _) if value > 0.0 => Word::Forward,
            (false, _) => Word::Back,
        };
        let label = self.label(Quantity::Direction);
        desk.from_motion(label, Answer::Word(word));
        desk.from_energy(label, Answer::Word(word));
    }

    /// The energy of the slip, which friction takes: how far the contact slips, and how long.
    fn slip_by_energy(&self, pen: &mut Pen, worked: &Worked) -> SlipByEnergy {
        let names = &self.names;
        let (h, v, w) = (&names.momentum, &names.v, &names.omega);
        pen.say("thrown.split", &[]);
        let (vs, ws) = (pen.unknown(v, "m/s"), pen.unknown(w, "rad/s"));
        let us = pen.unknown(&names.slip, "m/s");
        let hs = pen.unknown(h, "kg m^2/s");
        let reduced_name = pen.desk.free(&["m_u", "m_s"]);
        let ms = pen.unknown(&reduced_name, "kg");
        let plain = half(&self.m * square(&vs)) + half(&self.own * square(&ws));
        let split = square(&hs) / (whole(2) * self.about_contact()) + half(ms * square(&us));
        let (left, right) = (pen.tex(&plain), pen.tex(&split));
        pen.formula(format!("{} = {left} = {right}", names.kinetic));
        pen.equation(&hs, &self.own * ws + &self.m * &self.c * vs);
        let reduced = pen.find(&reduced_name, "kg", &self.m * &self.own / self.about_contact());
        let phrase = if self.level { "thrown.slip_energy_level" } else { "thrown.slip_energy" };
        pen.say(phrase, &[("reduced", &reduced_name)]);
        // Loss of the slip's energy per metre of its way.
        let pulled = signed(reduced * &self.g * &self.sine, self.up == (worked.sense > 0.0));
        let loss_name = pen.desk.free(&["D", "F_u"]);
        if !self.level {
            pen.say("thrown.loss_incline", &[("loss", &loss_name)]);
        }
        let loss = pen.find(&loss_name, "N", &self.mu_k * worked.normal + pulled);
        let slip_speed = Self::magnitude(pen, worked.slip, "m/s");
        let by_energy = if let (Phase::Slips, Some(t1)) = (worked.phase, self.t1.clone()) {
            pen.say("thrown.slip_impulse", &[("slip", &names.slip)]);
            let left = worked.slip + signed(loss * &t1 / reduced, worked.sense < 0.0);
            let left = pen.find(&format!("{}_1", names.slip), "m/s", left);
            let lost = reduced * (square(worked.slip) - square(left));
            pen.say("thrown.slip_way_part", &[]);
            let way = pen.find(&names.way, "m", lost / (whole(2) * loss));
            SlipByEnergy { way, left: left.into(), time: t1, event: None }
        } else {
            pen.say("thrown.slip_way", &[]);
            let stored = reduced * square(worked.slip);
            let way = pen.find(&names.way, "m", stored / (whole(2) * loss));
            pen.say("thrown.slip_time", &[]);
            let name = worked.event.map_or_else(String::new, |e| pen.desk.ledger.tex(e).to_owned());
            let until = pen.find(&name, "s", whole(2) * way / slip_speed);
            SlipByEnergy { way, left: ZERO, time: until.into(), event: Some(until) }
        };
        pen.energy(self.label(Quantity::SlipDistance), by_energy.way);
        if let (Phase::Event, Some(event)) = (worked.phase, by_energy.event) {
            pen.energy(Self::scene_label(Quantity::T), event);
        }
        by_energy
    }

    /// Velocity, spin, displacement and, if it is asked, angle at the end, from the angular momentum about the surface.
    fn momentum(
        &self,
        pen: &mut Pen,
        worked: &Worked,
        by_energy: &SlipByEnergy,
    ) -> (Symbol, Symbol, Symbol, Option<Symbol>) {
        let names = &self.names;
        let (h, v, w) = (&names.momentum, &names.v, &names.omega);
        let (slips, slid, slip_left) = (worked.phase == Phase::Slips, &by_energy.time, &by_energy.left);
        pen.say(if self.level { "thrown.momentum_level" } else { "thrown.momentum" }, &[("momentum", h)]);
        let momentum = &self.own * &self.w0 + &self.m * &self.c * &self.v0;
        let h0 = pen.find(&format!("{h}_0"), "kg m^2/s", momentum);
        let one = if worked.phase == Phase::Rolls { "r" } else { "1" };
        let momentum_after = |pen: &mut Pen, t: &Expr, one: &str| match self.level {
            true => h0,
            false => pen.find(&format!("{h}_{one}"), "kg m^2/s", h0 - self.weight_times(&self.c * t)),
        };
        let h1 = momentum_after(pen, slid, one);
        let about = self.about_contact();
        pen.say(if slips { "thrown.speeds_slipping" } else { "thrown.speeds" }, &[]);
        let centre = |h: Symbol, left: &Expr| (&self.c * h + &self.own * left) / &about;
        let mut v1 = pen.find(&format!("{v}_{one}"), "m/s", centre(h1, slip_left));
        if self.level && !slips {
            pen.say("thrown.any_friction", &[]);
        }
        let spin = |v: Symbol, left: &Expr| (v - left) / &self.c;
        let mut w1 = pen.find(&format!("{w}_{one}"), "rad/s", spin(v1, slip_left));
        let mean = |from: Expr, to: Symbol, t: &Expr| half(from + to) * t;
        pen.say("thrown.mean", &[]);
        let mut x1 = pen.find(&format!("{}_{one}", names.x), "m", mean(self.v0.clone(), v1, slid));
        let mut phi1 = None;
        if pen.desk.asks(Quantity::Phi) {
            let turned = mean(self.w0.clone(), w1, slid);
            phi1 = Some(pen.find(&format!("{}_{one}", names.phi), "rad", turned));
        }
        if let (Phase::Rolls, Some(t1), Some(event)) = (worked.phase, self.t1.clone(), by_energy.event) {
            let (v_slip, x_slip, w_slip) = (v1, x1, w1);
            pen.say("thrown.momentum_on", &[]);
            let h_end = momentum_after(pen, &t1, "1");
            v1 = pen.find(&format!("{v}_1"), "m/s", centre(h_end, &ZERO));
            w1 = pen.find(&format!("{w}_1"), "rad/s", spin(v1, &ZERO));
            let left = t1 - event;
            x1 = pen.find(&format!("{}_1", names.x), "m", x_slip + mean(v_slip.into(), v1, &left));
            if let Some(phi) = phi1 {
                let legs = phi + mean(w_slip.into(), w1, &left);
                phi1 = Some(pen.find(&format!("{}_1", names.phi), "rad", legs));
            }
        }
        (v1, w1, x1, phi1)
    }

    /// The whole balance: what is missing is heat.
    fn heat(&self, pen: &mut Pen, worked: &Worked, (v1, w1, x1, way): (Symbol, Symbol, Symbol, Symbol)) {
        let names = &self.names;
        let kinetic = |v: Expr, w: Expr| half(&self.m * square(&v)) + half(&self.own * square(&w));
        pen.say("thrown.balance", &[]);
        let t0 = pen.find(&format!("{}_0", names.kinetic), "J", kinetic(self.v0.clone(), self.w0.clone()));
        let t1 = pen.find(&format!("{}_1", names.kinetic), "J", kinetic(v1.into(), w1.into()));
        pen.energy(Self::scene_label(Quantity::KineticEnergy), t1);
        let mut left = t0 - t1;
        if !self.level {
            pen.say("thrown.weight_work", &[]);
            let work = pen.find("W_g", "J", -self.weight_times(x1.into()));
            left = t0 + work - t1;
        }
        pen.say("thrown.heat_energy", &[]);
        let heat = pen.find(&names.heat, "J", &left);
        pen.energy(Self::scene_label(Quantity::Heat), heat);
        let rubbed = &self.mu_k * worked.normal * way;
        let text = pen.tex(&rubbed);
        let again = pen.quiet(&text, "J", &rubbed);
        let same = format!("{text} = {}", pen.desk.ledger.shown(again));
        pen.say("thrown.heat_same", &[("same", &same)]);
        pen.picture("energy");
    }

    /// Friction and accelerations while it slips, from the work of the forces on the mass centre or in the rotation.
    fn friction_by_work(
        &self,
        pen: &mut Pen,
        (v1, w1, x1, phi1): (Symbol, Symbol, Symbol, Option<Symbol>),
        t: &Expr,
    ) {
        let names = &self.names;
        let asks = |pen: &Pen, q| pen.desk.asks(q);
        if asks(pen, Quantity::Friction) {
            // The way of the centre, or the angle, whichever is further from nothing.
            let value = |pen: &Pen, s: Symbol| pen.desk.ledger.value(s);
            let most = |pen: &Pen, start: &Expr, end: Symbol| {
                pen.value(start).abs().max(value(pen, end).abs()) * pen.value(t)
            };
            let share_x = value(pen, x1).abs() / most(pen, &self.v0, v1);
            if share_x > 0.02 {
                pen.say("thrown.work_centre", &[("friction", &names.friction)]);
                let gained = &self.m * (square(v1) - square(&self.v0));
                let over = whole(2) * x1;
                let forward = gained / over + self.weight();
                let force = pen.find(&names.friction, "N", signed(forward, self.up));
                pen.energy(self.label(Quantity::Friction), force);
            } else {
                let turned = match phi1 {
                    Some(phi) => phi,
                    None => {
                        let angle = half(&self.w0 + w1) * t;
                        pen.find(&format!("{}_1", names.phi), "rad", &angle)
                    }
                };
                pen.say("thrown.work_turn", &[("friction", &names.friction)]);
                let squares = square(w1) - square(&self.w0);
                let gained = &self.own * squares;
                let over = whole(2) * &self.c * turned;
                let forward = -(gained / over);
                let force = pen.find(&names.friction, "N", signed(forward, self.up));
                pen.energy(self.label(Quantity::Friction), force);
            }
        }
        if asks(pen, Quantity::A) || asks(pen, Quantity::Alpha) {
            pen.say("thrown.gain", &[]);
        }
        if asks(pen, Quantity::A) {
            let gain = (v1 - &self.v0) / t;
            let a = pen.find(&names.a, "m/s^2", &gain);
            pen.energy(self.label(Quantity::A), a);
        }
        if asks(pen, Quantity::Alpha) {
            let gain = (w1 - &self.w0) / t;
            let alpha = pen.find(&names.alpha, "rad/s^2", &gain);
            pen.energy(self.label(Quantity::Alpha), alpha);
        }
        let rolling = [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired];
        if rolling.iter().any(|q| asks(pen, *q)) {
            self.rolling_rate(pen, false);
        }
    }

    /// Acceleration and friction of rolling from the rate of the balance; does it roll at the end?
    fn rolling_rate(&self, pen: &mut Pen, rolls: bool) {
        let names = &self.names;
        let (a_name, f_name) = (format!("{}_r", names.a), format!("{}_r", names.friction));
        pen.say(if self.level { "thrown.rate_level" } else { "thrown.rate" }, &[]);
        let (a, friction) = if self.level {
            (pen.find(&a_name, "m/s^2", &ZERO), pen.find(&f_name, "N", &ZERO))
        } else {
            let over = -self.weight_times(square(self.c.clone()));
            let a = pen.find(&a_name, "m/s^2", over / self.about_contact());
            pen.say("thrown.rate_friction", &[("friction", &f_name)]);
            let forward = &self.m * a + self.weight();
            (a, pen.find(&f_name, "N", signed(forward, self.up)))
        };
        pen.energy(self.label(Quantity::ARolling), a);
        pen.energy(self.label(Quantity::FrictionIfRolled), friction);
        if rolls {
            pen.energy(self.label(Quantity::A), a);
            pen.energy(self.label(Quantity::Friction), friction);
            if pen.desk.asks(Quantity::Alpha) {
                let turning = a / &self.c;
                let alpha = pen.find(&format!("{}_r", names.alpha), "rad/s^2", &turning);
                pen.energy(self.label(Quantity::Alpha), alpha);
            }
        }
        if pen.desk.asks(Quantity::MuRequired) {
            let label = self.label(Quantity::MuRequired);
            let size = Self::magnitude(pen, friction, "N");
            let normal = &self.m * &self.g * &self.cosine;
            let name = pen.desk.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
            let mu = pen.quiet(&name, "1", size / normal);
            pen.energy(label, mu);
        }
    }
}

// -- what was assumed, and what suggests itself ---------------------------------------------------------------------------

impl Throw {
    /// Does the slip keep its sense, and can it roll on?
    fn regime(&self, desk: &mut Desk, worked: &Worked) {
        let names = &self.names;
        let mut pen = Pen::new(desk, "regime", "thrown.title_regime");
        let slip = names.slip.as_str();
        let normal = pen.rough(pen.desk.ledger.value(worked.normal), "N");
        pen.say("thrown.check_pressed", &[("normal", &names.normal), ("size", &normal)]);
        if worked.phase == Phase::Slips {
            pen.say("thrown.check_slips", &[("slip", slip)]);
        } else {
            pen.say("thrown.check_event", &[("slip", slip)]);
            if self.level {
                pen.say("thrown.check_level", &[]);
            } else {
                let known = pen.desk.found.iter().any(|f| f.label == self.label(Quantity::FrictionIfRolled));
                let friction = if known {
                    let of = |f: &solution::desk::Found| match f.eom {
                        Some(Answer::Value(symbol)) => Some(symbol),
                        _ => None,
                    };
                    let found =
                        pen.desk.found.iter().find(|f| f.label == self.label(Quantity::FrictionIfRolled));
                    found.and_then(of)
                } else {
                    None
                };
                let friction = match friction {
                    Some(friction) => friction,
                    None => self.roll(&mut pen).1,
                };
                let size = Self::magnitude(&mut pen, friction, "N");
                let limit = &self.mu_s * worked.normal;
                let needed = pen.with_value(size);
                pen.say("thrown.check_grip", &[("needed", &needed)]);
                let name = pen.desk.free(&[r"F_{\mathrm{max}}", "F_m"]);
                pen.find(&name, "N", &limit);
                pen.say("thrown.rolls_on", &[]);
            }
        }
        let value = pen.desk.ledger.value(worked.v);
        let way = self.way(pen.desk, value).to_owned();
        let v = pen.desk.ledger.tex(worked.v).to_owned();
        pen.picture("graph-slip");
        if value > 0.0 {
            pen.say("thrown.moves_forward", &[("v", &v), ("way", &way)]);
        } else if value < 0.0 {
            pen.say("thrown.moves_back", &[("v", &v), ("way", &way)]);
        }
        pen.done();
    }
}
