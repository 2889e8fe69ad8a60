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
use crate::solution::expr::ZERO;
use crate::solution::expr::cosine;
use crate::solution::expr::difference;
use crate::solution::expr::magnitude;
use crate::solution::expr::minus;
use crate::solution::expr::number as whole;
use crate::solution::expr::product;
use crate::solution::expr::quotient;
use crate::solution::expr::ratio;
use crate::solution::expr::sine;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::ledger::Symbol;
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

fn signed(e: Expr, positive: bool) -> Expr {
    if positive { e } else { minus(e) }
}

/// Half of it.
fn half(e: Expr) -> Expr {
    product([ratio(1, 2), e])
}

fn square_of(e: &Expr) -> Expr {
    if *e == ZERO { ZERO } else { square(e.clone()) }
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
        signed(product([self.m.clone(), self.g.clone(), self.sine.clone()]), self.up)
    }

    /// The same times something; the sine stays last, where nothing can be read into it.
    fn weight_times(&self, factor: Expr) -> Expr {
        signed(product([self.m.clone(), self.g.clone(), factor, self.sine.clone()]), self.up)
    }

    /// The same as an acceleration.
    fn fall(&self) -> Expr {
        signed(product([self.g.clone(), self.sine.clone()]), self.up)
    }

    /// The words for where something points that is positive forward.
    fn way<'w>(&self, desk: &Desk<'w>, forward: f64) -> &'w str {
        let value = if self.up { forward } else { -forward };
        solution::way(desk.scene, Owner::Body(self.body), value).map_or("", |phrase| desk.words.get(phrase))
    }

    /// `I_G + m c^2`.
    fn about_contact(&self) -> Expr {
        sum([self.own.clone(), product([self.m.clone(), square(self.c.clone())])])
    }

    /// A quantity that is a magnitude: itself, or under bars where it is negative.
    fn magnitude(pen: &mut Pen, symbol: Symbol, unit: &str) -> Symbol {
        if pen.desk.ledger.value(symbol) >= 0.0 {
            return symbol;
        }
        let name = format!(r"\left|{}\right|", pen.desk.ledger.tex(symbol));
        pen.quiet(&name, unit, &magnitude(symbol.into()))
    }

    // -- the road of the equations of motion ------------------------------------------------------------------------------

    fn motion(&self, desk: &mut Desk) -> Result<Worked, Stop> {
        let names = &self.names;
        let mut pen = Pen::new(desk, "eom", "thrown.title_eom");
        pen.say("thrown.slip", &[("slip", &names.slip)]);
        let slip = difference(self.v0.clone(), product([self.c.clone(), self.w0.clone()]));
        let slip = pen.find(&format!("{}_0", names.slip), "m/s", &slip);
        let slip_value = pen.desk.ledger.value(slip);
        if slip_value == 0.0 {
            return Err(Beyond::ThrownWithoutSlip.into());
        }
        let sense = slip_value.signum();
        let slip_speed = Self::magnitude(&mut pen, slip, "m/s");
        let note = pen.desk.words.get("thrown.note_slip").to_owned();
        let label = self.label(Quantity::SlipSpeed);
        pen.desk.from_one_road(label, Answer::Value(slip_speed), &note);
        let (slides, points) = (self.way(pen.desk, sense).to_owned(), self.way(pen.desk, -sense).to_owned());
        let with = pen.value(&self.v0) * sense < 0.0;
        let text = [("slip", names.slip.as_str()), ("slides", &slides), ("points", &points)];
        pen.say(if sense > 0.0 { "thrown.sense_forward" } else { "thrown.sense_back" }, &text);
        if with {
            pen.say("thrown.drives", &[]);
        }

        // The rows.
        let force = Expr::Symbol(pen.desk.unknown(&names.friction, "N"));
        let normal = Expr::Symbol(pen.desk.unknown(&names.normal, "N"));
        let a = Expr::Symbol(pen.desk.unknown(&names.a, "m/s^2"));
        let alpha = Expr::Symbol(pen.desk.unknown(&names.alpha, "rad/s^2"));
        pen.say("thrown.rows", &[]);
        let forward = signed(force.clone(), self.up);
        pen.equation(&product([self.m.clone(), a]), &difference(forward.clone(), self.weight()));
        let pressing = product([self.m.clone(), self.g.clone(), self.cosine.clone()]);
        pen.equation(&ZERO, &difference(normal.clone(), pressing.clone()));
        let turning = minus(product([self.c.clone(), forward]));
        pen.equation(&product([self.own.clone(), alpha]), &turning);
        let friction = |normal: Expr| signed(product([self.mu_k.clone(), normal]), (sense < 0.0) == self.up);
        pen.say("thrown.law", &[("points", &points)]);
        pen.equation(&force, &friction(normal));
        pen.say("thrown.numbers", &[("points", &points)]);
        let normal = pen.find(&names.normal, "N", &pressing);
        pen.motion(self.label(Quantity::Normal), normal);
        let force = pen.find(&names.friction, "N", &friction(normal.into()));
        let forward = signed(force.into(), self.up);
        let a = difference(quotient(forward.clone(), self.m.clone()), self.fall());
        let a = pen.find(&names.a, "m/s^2", &a);
        let alpha = minus(quotient(product([self.c.clone(), forward]), self.own.clone()));
        let alpha = pen.find(&names.alpha, "rad/s^2", &alpha);

        // The slip goes evenly.
        pen.say("thrown.even", &[("a", &names.a), ("alpha", &names.alpha), ("slip", &names.slip)]);
        let rate_name = format!(r"\dot{{{}}}", names.slip);
        let rate = difference(a.into(), product([self.c.clone(), alpha.into()]));
        let rate = pen.find(&rate_name, "m/s^2", &rate);
        let closes = pen.desk.ledger.value(rate) * sense < 0.0;
        let holds = self.holds(pen.desk);
        let event_name = match self.t1 {
            None => pen.desk.free(&["t", "t_r"]),
            Some(_) => pen.desk.free(&["t_r", "t_e"]),
        };
        let event = if closes {
            pen.say("thrown.event", &[("slip", &names.slip), ("rate", &rate_name)]);
            let until = minus(quotient(slip.into(), rate.into()));
            Some(pen.find(&event_name, "s", &until))
        } else {
            pen.say("thrown.no_event", &[("rate", &rate_name)]);
            None
        };
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

        // The state at the end of the slip, or at the time asked.
        let one = if phase == Phase::Rolls { "r" } else { "1" };
        let t: Expr = match (phase, event, &self.t1) {
            (Phase::Slips, _, Some(t1)) => t1.clone(),
            (_, Some(event), _) => event.into(),
            (_, None, t1) => t1.clone().unwrap_or(ZERO),
        };
        let in_phase = pen.tex(&t);
        pen.say("thrown.state", &[("t", &in_phase)]);
        let after = |start: &Expr, rate: Symbol| sum([start.clone(), product([rate.into(), t.clone()])]);
        let travelled = |start: &Expr, rate: Symbol| {
            let drift = product([start.clone(), t.clone()]);
            sum([drift, half(product([rate.into(), square(t.clone())]))])
        };
        let v1 = pen.find(&format!("{}_{one}", names.v), "m/s", &after(&self.v0, a));
        let w1 = if phase == Phase::Slips {
            pen.find(&format!("{}_{one}", names.omega), "rad/s", &after(&self.w0, alpha))
        } else {
            pen.say("thrown.rolls_now", &[]);
            pen.find(&format!("{}_{one}", names.omega), "rad/s", &quotient(v1.into(), self.c.clone()))
        };
        let needs_way = [Quantity::Displacement, Quantity::Rise, Quantity::Heat, Quantity::SlipDistance]
            .iter()
            .any(|q| pen.desk.asks(*q));
        let x1 = if needs_way {
            pen.find(&format!("{}_{one}", names.x), "m", &travelled(&self.v0, a))
        } else {
            pen.quiet(&format!("{}_{one}", names.x), "m", &travelled(&self.v0, a))
        };
        let phi1 = if pen.desk.asks(Quantity::Phi) {
            pen.find(&format!("{}_{one}", names.phi), "rad", &travelled(&self.w0, alpha))
        } else {
            pen.quiet(&format!("{}_{one}", names.phi), "rad", &travelled(&self.w0, alpha))
        };
        if self.turns_back(pen.desk, v1) && needs_way {
            pen.say("thrown.turns_back", &[]);
        }
        // The way of the contact: mean slip times time.
        let way = if phase == Phase::Slips {
            pen.say("thrown.way_slipping", &[("slip", &names.slip)]);
            let left = sum([slip.into(), product([rate.into(), t.clone()])]);
            let left = pen.find(&format!("{}_1", names.slip), "m/s", &left);
            let mean = half(sum([slip.into(), left.into()]));
            let mean = if sense < 0.0 { magnitude(mean) } else { mean };
            pen.find(&names.way, "m", &product([mean, t.clone()]))
        } else {
            pen.say("thrown.way", &[("slip", &names.slip)]);
            pen.find(&names.way, "m", &half(product([Expr::from(slip_speed), t.clone()])))
        };
        pen.motion(self.label(Quantity::SlipDistance), way);
        pen.say("thrown.heat", &[]);
        let made = product([self.mu_k.clone(), normal.into(), way.into()]);
        let heat = pen.find(&names.heat, "J", &made);
        pen.motion(Self::scene_label(Quantity::Heat), heat);
        if phase == Phase::Event
            && let Some(event) = event
        {
            pen.motion(Self::scene_label(Quantity::T), event);
        }
        let (mut v, mut w, mut x, mut phi) = (v1, w1, x1, phi1);
        let (mut now_a, mut now_alpha, mut now_friction) = (a, alpha, force);

        // Rolling: from the event on, or to be checked.
        let asks = |pen: &Pen, q| pen.desk.asks(q);
        let rolling_asked =
            [Quantity::ARolling, Quantity::FrictionIfRolled, Quantity::MuRequired, Quantity::Rolls];
        if phase == Phase::Rolls || rolling_asked.iter().any(|q| asks(&pen, *q)) {
            let (a_r, friction_r) = self.roll(&mut pen);
            pen.motion(self.label(Quantity::ARolling), a_r);
            pen.motion(self.label(Quantity::FrictionIfRolled), friction_r);
            if asks(&pen, Quantity::MuRequired) {
                let name = pen.desk.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
                let size = Self::magnitude(&mut pen, friction_r, "N");
                let mu = pen.find(&name, "1", &quotient(size.into(), normal.into()));
                pen.motion(self.label(Quantity::MuRequired), mu);
            }
            if let (Phase::Rolls, Some(t1), Some(event)) = (phase, self.t1.clone(), event) {
                pen.say("thrown.leg", &[]);
                let name = format!(r"\Delta {}", pen.desk.free(&["t", "t_r"]));
                let left = Expr::Symbol(pen.find(&name, "s", &difference(t1, event.into())));
                let gained = product([Expr::from(a_r), left.clone()]);
                v = pen.find(&format!("{}_1", names.v), "m/s", &sum([v1.into(), gained]));
                w = pen.find(&format!("{}_1", names.omega), "rad/s", &quotient(v.into(), self.c.clone()));
                let legs = sum([
                    x1.into(),
                    product([v1.into(), left.clone()]),
                    half(product([Expr::from(a_r), square(left)])),
                ]);
                let name = format!("{}_1", names.x);
                x = if needs_way { pen.find(&name, "m", &legs) } else { pen.quiet(&name, "m", &legs) };
                let turned = sum([phi1.into(), quotient(difference(x.into(), x1.into()), self.c.clone())]);
                let name = format!("{}_1", names.phi);
                let told = asks(&pen, Quantity::Phi);
                phi = if told { pen.find(&name, "rad", &turned) } else { pen.quiet(&name, "rad", &turned) };
                now_a = a_r;
                now_friction = friction_r;
                let turning = quotient(a_r.into(), self.c.clone());
                let name = format!("{}_r", names.alpha);
                let told = asks(&pen, Quantity::Alpha);
                now_alpha = if told {
                    pen.find(&name, "rad/s^2", &turning)
                } else {
                    pen.quiet(&name, "rad/s^2", &turning)
                };
            }
        }
        let spin = Self::magnitude(&mut pen, w, "rad/s");
        pen.motion(self.label(Quantity::Omega), spin);
        let speed = Self::magnitude(&mut pen, v, "m/s");
        pen.motion(self.label(Quantity::V), speed);
        pen.motion(self.label(Quantity::Displacement), x);
        let turned = Self::magnitude(&mut pen, phi, "rad");
        pen.motion(self.label(Quantity::Phi), turned);
        pen.motion(self.label(Quantity::A), now_a);
        pen.motion(self.label(Quantity::Alpha), now_alpha);
        pen.motion(self.label(Quantity::Friction), now_friction);
        if let (Phase::Slips | Phase::Rolls, Some(Expr::Symbol(t1))) = (phase, &self.t1) {
            let note = pen.desk.words.get("thrown.note_time").to_owned();
            pen.desk.from_one_road(Self::scene_label(Quantity::T), Answer::Value(*t1), &note);
        }
        if pen.desk.asks(Quantity::Rise) {
            pen.say("thrown.rise", &[]);
            let rise = signed(product([Expr::from(x), self.sine.clone()]), self.up);
            let rise = pen.find("h", "m", &rise);
            let note = pen.desk.words.get("thrown.note_rise").to_owned();
            pen.desk.from_one_road(self.label(Quantity::Rise), Answer::Value(rise), &note);
        }
        if pen.desk.asks(Quantity::KineticEnergy) || pen.desk.asks(Quantity::RotationalFraction) {
            pen.say("thrown.kinetic", &[]);
            let spinning = half(product([self.own.clone(), square(w.into())]));
            let energy = sum([half(product([self.m.clone(), square(v.into())])), spinning.clone()]);
            let energy = pen.find(&format!("{}_1", names.kinetic), "J", &energy);
            pen.motion(Self::scene_label(Quantity::KineticEnergy), energy);
            if pen.desk.asks(Quantity::RotationalFraction) {
                let name = pen.desk.free(&[r"\zeta", r"\zeta_r"]);
                let share = pen.find(&name, "1", &quotient(spinning, energy.into()));
                let note = pen.desk.words.get("thrown.note_share").to_owned();
                let label = Self::scene_label(Quantity::RotationalFraction);
                pen.desk.from_one_road(label, Answer::Value(share), &note);
            }
        }
        pen.done();
        let rolls = if holds { Word::Yes } else { Word::No };
        let label = self.label(Quantity::Rolls);
        desk.from_motion(label, Answer::Word(rolls));
        Ok(Worked { phase, slip, sense, normal, event, v })
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
        let a = Expr::Symbol(pen.desk.unknown(&a_name, "m/s^2"));
        let friction = Expr::Symbol(pen.desk.unknown(&f_name, "N"));
        let forward = signed(friction, self.up);
        pen.equation(&product([self.m.clone(), a.clone()]), &difference(forward.clone(), self.weight()));
        let turning = product([self.own.clone(), quotient(a, self.c.clone())]);
        pen.equation(&turning, &minus(product([self.c.clone(), forward])));
        pen.say("thrown.roll_eliminate", &[("friction", &f_name)]);
        let carried = sum([self.m.clone(), quotient(self.own.clone(), square(self.c.clone()))]);
        let a = pen.find(&a_name, "m/s^2", &quotient(minus(self.weight()), carried));
        let friction = quotient(product([self.own.clone(), a.into()]), square(self.c.clone()));
        let friction = pen.find(&f_name, "N", &signed(friction, !self.up));
        (a, friction)
    }

    // -- the road of momentum, work and energy ----------------------------------------------------------------------------

    fn balance(&self, desk: &mut Desk, worked: &Worked) {
        let names = &self.names;
        let mut pen = Pen::new(desk, "energy", "thrown.title_energy");
        let slips = worked.phase == Phase::Slips;
        let (h, v, w) = (&names.momentum, &names.v, &names.omega);

        // The energy of the slip.
        pen.say("thrown.split", &[]);
        let (vs, ws) = (Expr::Symbol(pen.desk.unknown(v, "m/s")), Expr::Symbol(pen.desk.unknown(w, "rad/s")));
        let us = Expr::Symbol(pen.desk.unknown(&names.slip, "m/s"));
        let hs = Expr::Symbol(pen.desk.unknown(h, "kg m^2/s"));
        let reduced_name = pen.desk.free(&["m_u", "m_s"]);
        let ms = Expr::Symbol(pen.desk.unknown(&reduced_name, "kg"));
        let plain = sum([
            half(product([self.m.clone(), square(vs.clone())])),
            half(product([self.own.clone(), square(ws.clone())])),
        ]);
        let split = sum([
            quotient(square(hs.clone()), product([whole(2), self.about_contact()])),
            half(product([ms, square(us.clone())])),
        ]);
        let (left, right) = (pen.tex(&plain), pen.tex(&split));
        pen.formula(format!("{} = {left} = {right}", names.kinetic));
        let momentum = sum([product([self.own.clone(), ws]), product([self.m.clone(), self.c.clone(), vs])]);
        pen.equation(&hs, &momentum);
        let reduced = quotient(product([self.m.clone(), self.own.clone()]), self.about_contact());
        let reduced = pen.find(&reduced_name, "kg", &reduced);
        let phrase = if self.level { "thrown.slip_energy_level" } else { "thrown.slip_energy" };
        pen.say(phrase, &[("reduced", &reduced_name)]);
        // Loss of the slip's energy per metre of its way.
        let rubbing = product([self.mu_k.clone(), worked.normal.into()]);
        let pulled = product([Expr::from(reduced), self.g.clone(), self.sine.clone()]);
        let loss = sum([rubbing, signed(pulled, self.up == (worked.sense > 0.0))]);
        let loss_name = pen.desk.free(&["D", "F_u"]);
        if !self.level {
            pen.say("thrown.loss_incline", &[("loss", &loss_name)]);
        }
        let loss = pen.find(&loss_name, "N", &loss);
        let slip_speed = Self::magnitude(&mut pen, worked.slip, "m/s");
        let stored = product([Expr::from(reduced), square(worked.slip.into())]);
        let twice = |e: Expr| product([whole(2), e]);
        let way;
        let mut slip_left = ZERO;
        let mut event: Option<Symbol> = None;
        let t_name = match (worked.phase, worked.event) {
            (Phase::Slips, _) | (_, None) => String::new(),
            (_, Some(event)) => pen.desk.ledger.tex(event).to_owned(),
        };
        let slid: Expr;
        if let (true, Some(t1)) = (slips, self.t1.clone()) {
            pen.say("thrown.slip_impulse", &[("slip", &names.slip)]);
            let spent = quotient(product([Expr::from(loss), t1.clone()]), reduced.into());
            let left = sum([worked.slip.into(), signed(spent, worked.sense < 0.0)]);
            let left = pen.find(&format!("{}_1", names.slip), "m/s", &left);
            let squares = difference(square(worked.slip.into()), square(left.into()));
            let lost = product([Expr::from(reduced), squares]);
            pen.say("thrown.slip_way_part", &[]);
            way = pen.find(&names.way, "m", &quotient(lost, twice(loss.into())));
            slip_left = left.into();
            slid = t1;
        } else {
            pen.say("thrown.slip_way", &[]);
            way = pen.find(&names.way, "m", &quotient(stored, twice(loss.into())));
            pen.say("thrown.slip_time", &[]);
            let until = pen.find(&t_name, "s", &quotient(twice(way.into()), slip_speed.into()));
            event = Some(until);
            slid = until.into();
        }
        pen.energy(self.label(Quantity::SlipDistance), way);
        if let (Phase::Event, Some(event)) = (worked.phase, event) {
            pen.energy(Self::scene_label(Quantity::T), event);
        }

        // The angular momentum about the surface.
        pen.say(if self.level { "thrown.momentum_level" } else { "thrown.momentum" }, &[("momentum", h)]);
        let momentum = sum([
            product([self.own.clone(), self.w0.clone()]),
            product([self.m.clone(), self.c.clone(), self.v0.clone()]),
        ]);
        let h0 = pen.find(&format!("{h}_0"), "kg m^2/s", &momentum);
        let momentum_after = |t: &Expr| {
            let lost = self.weight_times(product([self.c.clone(), t.clone()]));
            difference(h0.into(), lost)
        };
        let one = if worked.phase == Phase::Rolls { "r" } else { "1" };
        let h1 =
            if self.level { h0 } else { pen.find(&format!("{h}_{one}"), "kg m^2/s", &momentum_after(&slid)) };
        let about = self.about_contact();
        pen.say(if slips { "thrown.speeds_slipping" } else { "thrown.speeds" }, &[]);
        let centre = |h: Symbol, left: &Expr| {
            let over = sum([product([self.c.clone(), h.into()]), product([self.own.clone(), left.clone()])]);
            quotient(over, about.clone())
        };
        let mut v1 = pen.find(&format!("{v}_{one}"), "m/s", &centre(h1, &slip_left));
        if self.level && !slips {
            pen.say("thrown.any_friction", &[]);
        }
        let spin = |v: Symbol, left: &Expr| quotient(difference(v.into(), left.clone()), self.c.clone());
        let mut w1 = pen.find(&format!("{w}_{one}"), "rad/s", &spin(v1, &slip_left));
        let asks = |pen: &Pen, q| pen.desk.asks(q);
        let mean = |from: Expr, to: Symbol, t: &Expr| product([half(sum([from, to.into()])), t.clone()]);
        pen.say("thrown.mean", &[]);
        let mut x1 = pen.find(&format!("{}_{one}", names.x), "m", &mean(self.v0.clone(), v1, &slid));
        let (v_slip, x_slip, w_slip) = (v1, x1, w1);
        let mut phi1 = None;
        if asks(&pen, Quantity::Phi) {
            let turned = mean(self.w0.clone(), w1, &slid);
            phi1 = Some(pen.find(&format!("{}_{one}", names.phi), "rad", &turned));
        }
        if let (Phase::Rolls, Some(t1), Some(event)) = (worked.phase, self.t1.clone(), event) {
            pen.say("thrown.momentum_on", &[]);
            let h_end =
                if self.level { h0 } else { pen.find(&format!("{h}_1"), "kg m^2/s", &momentum_after(&t1)) };
            v1 = pen.find(&format!("{v}_1"), "m/s", &centre(h_end, &ZERO));
            w1 = pen.find(&format!("{w}_1"), "rad/s", &spin(v1, &ZERO));
            let left = difference(t1, event.into());
            let legs = sum([x_slip.into(), mean(v_slip.into(), v1, &left)]);
            x1 = pen.find(&format!("{}_1", names.x), "m", &legs);
            if let Some(phi) = phi1 {
                let legs = sum([phi.into(), mean(w_slip.into(), w1, &left)]);
                phi1 = Some(pen.find(&format!("{}_1", names.phi), "rad", &legs));
            }
        }
        let speed = Self::magnitude(&mut pen, v1, "m/s");
        pen.energy(self.label(Quantity::V), speed);
        let spin = Self::magnitude(&mut pen, w1, "rad/s");
        pen.energy(self.label(Quantity::Omega), spin);
        pen.energy(self.label(Quantity::Displacement), x1);
        if let Some(phi) = phi1 {
            let turned = Self::magnitude(&mut pen, phi, "rad");
            pen.energy(self.label(Quantity::Phi), turned);
        }
        self.heat(&mut pen, worked, (v1, w1, x1, way));
        if worked.phase == Phase::Rolls {
            self.rolling_rate(&mut pen, true);
        } else {
            self.friction_by_work(&mut pen, (v1, w1, x1, phi1), &slid);
        }
        pen.done();
        let value = desk.ledger.value(worked.v);
        let sloped = desk.scene.bodies[self.body].line.is_some_and(|l| l.slope != Slope::Level);
        let upward = if self.up { value } else { -value };
        let word = match (sloped, value == 0.0) {
            (_, true) => Word::Stays,
            (true, _) => {
                if upward > 0.0 {
                    Word::Up
                } else {
                    Word::Down
                }
            }
            (false, _) => {
                if value > 0.0 {
                    Word::Forward
                } else {
                    Word::Back
                }
            }
        };
        let label = self.label(Quantity::Direction);
        desk.from_motion(label, Answer::Word(word));
        desk.from_energy(label, Answer::Word(word));
        let label = self.label(Quantity::Normal);
        if desk.asks(Quantity::Normal) {
            let note = desk.words.get("thrown.note_normal").to_owned();
            desk.from_one_road(label, Answer::Value(worked.normal), &note);
        }
    }

    /// The whole balance: what is missing is heat.
    fn heat(&self, pen: &mut Pen, worked: &Worked, (v1, w1, x1, way): (Symbol, Symbol, Symbol, Symbol)) {
        let names = &self.names;
        let kinetic = |v: Expr, w: Expr| {
            sum([
                half(product([self.m.clone(), square_of(&v)])),
                half(product([self.own.clone(), square_of(&w)])),
            ])
        };
        pen.say("thrown.balance", &[]);
        let t0 = kinetic(self.v0.clone(), self.w0.clone());
        let t0 = pen.find(&format!("{}_0", names.kinetic), "J", &t0);
        let t1 = pen.find(&format!("{}_1", names.kinetic), "J", &kinetic(v1.into(), w1.into()));
        pen.energy(Self::scene_label(Quantity::KineticEnergy), t1);
        let mut left = sum([Expr::from(t0), minus(t1.into())]);
        if !self.level {
            pen.say("thrown.weight_work", &[]);
            let work = minus(self.weight_times(x1.into()));
            let work = pen.find("W_g", "J", &work);
            left = sum([Expr::from(t0), work.into(), minus(t1.into())]);
        }
        pen.say("thrown.heat_energy", &[]);
        let heat = pen.find(&names.heat, "J", &left);
        pen.energy(Self::scene_label(Quantity::Heat), heat);
        let rubbed = product([self.mu_k.clone(), worked.normal.into(), way.into()]);
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
                let gained = product([self.m.clone(), difference(square(v1.into()), square_of(&self.v0))]);
                let over = product([whole(2), x1.into()]);
                let forward = sum([quotient(gained, over), self.weight()]);
                let force = pen.find(&names.friction, "N", &signed(forward, self.up));
                pen.energy(self.label(Quantity::Friction), force);
            } else {
                let turned = match phi1 {
                    Some(phi) => phi,
                    None => {
                        let angle = product([half(sum([self.w0.clone(), w1.into()])), t.clone()]);
                        pen.find(&format!("{}_1", names.phi), "rad", &angle)
                    }
                };
                pen.say("thrown.work_turn", &[("friction", &names.friction)]);
                let squares = difference(square(w1.into()), square_of(&self.w0));
                let gained = product([self.own.clone(), squares]);
                let over = product([whole(2), self.c.clone(), turned.into()]);
                let forward = minus(quotient(gained, over));
                let force = pen.find(&names.friction, "N", &signed(forward, self.up));
                pen.energy(self.label(Quantity::Friction), force);
            }
        }
        if asks(pen, Quantity::A) || asks(pen, Quantity::Alpha) {
            pen.say("thrown.gain", &[]);
        }
        if asks(pen, Quantity::A) {
            let gain = quotient(difference(v1.into(), self.v0.clone()), t.clone());
            let a = pen.find(&names.a, "m/s^2", &gain);
            pen.energy(self.label(Quantity::A), a);
        }
        if asks(pen, Quantity::Alpha) {
            let gain = quotient(difference(w1.into(), self.w0.clone()), t.clone());
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
            let over = minus(self.weight_times(square(self.c.clone())));
            let a = pen.find(&a_name, "m/s^2", &quotient(over, self.about_contact()));
            pen.say("thrown.rate_friction", &[("friction", &f_name)]);
            let forward = sum([product([self.m.clone(), a.into()]), self.weight()]);
            (a, pen.find(&f_name, "N", &signed(forward, self.up)))
        };
        pen.energy(self.label(Quantity::ARolling), a);
        pen.energy(self.label(Quantity::FrictionIfRolled), friction);
        if rolls {
            pen.energy(self.label(Quantity::A), a);
            pen.energy(self.label(Quantity::Friction), friction);
            if pen.desk.asks(Quantity::Alpha) {
                let turning = quotient(a.into(), self.c.clone());
                let alpha = pen.find(&format!("{}_r", names.alpha), "rad/s^2", &turning);
                pen.energy(self.label(Quantity::Alpha), alpha);
            }
        }
        if pen.desk.asks(Quantity::MuRequired) {
            let label = self.label(Quantity::MuRequired);
            let size = Self::magnitude(pen, friction, "N");
            let normal = product([self.m.clone(), self.g.clone(), self.cosine.clone()]);
            let name = pen.desk.free(&[r"\mu_{\mathrm{min}}", r"\mu_0"]);
            let mu = pen.quiet(&name, "1", &quotient(size.into(), normal));
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
                let limit = product([self.mu_s.clone(), worked.normal.into()]);
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
