//! A body on a fixed pin, worked: moments about the pin, the integral over the angle, the force of the pin from the other two
//! rows; then energies, with the kinetic energy of the mass centre and of the rotation about it. Under the weight alone also
//! the periods: of small swings, and the real one by the arithmetic-geometric mean and by a mean value over the swing.
use crate::num::trig;
use crate::scene::Arm;
use crate::scene::End;
use crate::scene::Label;
use crate::scene::Owner;
use crate::scene::Pin;
use crate::scene::Quantity;
use crate::scene::Rest;
use crate::scene::Start;
use crate::scene::Zero;
use crate::sheet::number;
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
use crate::solution::expr::root;
use crate::solution::expr::signed;
use crate::solution::expr::sine;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::mass;
use crate::solution::pen::Pen;
use crate::solution::quantities::FIGURES;
use crate::solution::quantities::tex_digits;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solve::outcome::Word;

/// Step in degrees in which an angle is looked for at which something happens.
const LOOK: f64 = 0.25;
/// The farthest way that is looked over, degrees.
const FAR: f64 = 720.0;
/// Error of a mean value over a swing, as a share.
const MEAN_REL: f64 = 1e-11;

/// The body in symbols.
struct Swing {
    body: usize,
    /// Does the angle count from upright?
    up: bool,
    m: Expr,
    g: Expr,
    /// Distance from the pin to the mass centre.
    h: Expr,
    /// Moment of inertia about the mass centre.
    own: Expr,
    /// About the pin.
    about: Symbol,
    /// Moments of the couples, positive with growing angle.
    couples: Vec<Expr>,
    spring: Option<Spring>,
    phi: Expr,
    phi0: Expr,
    phi1: Expr,
    w0: Expr,
    /// Is only the instant of the start asked?
    instant: bool,
    /// Sense of the motion: 1 with growing angle.
    sense: f64,
    names: Names,
}

/// The spring in symbols.
struct Spring {
    /// Distance from the pin to its point of the body.
    b: Expr,
    /// Its anchor, as seen from the pin.
    x: Expr,
    y: Expr,
    k: Expr,
    /// Natural length.
    l0: Expr,
}

/// How the unknowns are written.
struct Names {
    omega: String,
    alpha: String,
    radial: String,
    across: String,
    pin: String,
    spring: String,
    length: String,
    out: String,
    side: String,
    central: String,
    aside: String,
    stretch: String,
    speed: String,
}

/// What a place of the body needs of its spring.
struct Place {
    phi: Expr,
    /// Force of the spring, and the components of its direction outward and across.
    spring: Option<(Expr, Expr, Expr)>,
}

/// Writes the sections of a pinned body.
///
/// # Errors
/// What this derivation does not cover.
pub fn work(desk: &mut Desk) -> Result<(), Stop> {
    let Some((body, pin)) = desk.scene.pinned() else {
        return Err(Beyond::Arrangement.into());
    };
    let pin = *pin;
    let known = [Quantity::Omega, Quantity::Alpha, Quantity::V, Quantity::KineticEnergy];
    let ended = known.iter().any(|q| {
        let owner = if *q == Quantity::KineticEnergy { Owner::Scene } else { Owner::Body(body) };
        *q != Quantity::Alpha && desk.variant.solved.get(Label { quantity: *q, of: owner }).is_some()
    });
    if !ended {
        return Err(Beyond::NotThere.into());
    }
    let swing = read(desk, body, &pin)?;
    let solved = swing.equations(desk);
    if solved.pendulum {
        swing.swings(desk);
    }
    swing.balance(desk, &solved);
    if solved.pendulum {
        swing.swings_by_energy(desk);
    }
    swing.regime(desk, &solved);
    Ok(())
}

impl Names {
    fn new(desk: &Desk) -> Self {
        Self {
            omega: desk.free(&[r"\omega", r"\omega_1"]),
            alpha: desk.free(&[r"\alpha", r"\alpha_1"]),
            radial: desk.free(&["R", "O_r"]),
            across: desk.free(&["S", "O_t"]),
            pin: desk.free(&["F_O", "O"]),
            spring: desk.free(&["F_s", r"F_{\mathrm{s}}"]),
            length: desk.free(&["s", "d"]),
            out: desk.free(&["n_r", "c_r"]),
            side: desk.free(&["n_t", "c_t"]),
            central: desk.free(&["a_n", "a_c"]),
            aside: desk.free(&["a_t", "a_q"]),
            stretch: desk.free(&[r"\delta", "e"]),
            speed: desk.free(&["v_G", "u_G"]),
        }
    }
}

/// The free body, and the senses that count as positive.
fn free_body(desk: &mut Desk, pin: &Pin, names: &Names, (body, angle): (usize, &str), couples: &[Expr]) {
    let moments: Vec<String> = couples
        .iter()
        .map(|c| {
            let (phrase, bare) = match c {
                Expr::Minus(inner) => ("pinned.forces_couple_back", inner.as_ref()),
                other => ("pinned.forces_couple", other),
            };
            desk.say(phrase, &[("moment", &bare.symbols(&desk.ledger))])
        })
        .collect();
    let mut pen = Pen::new(desk, "forces", "pinned.title_forces");
    pen.picture("scene");
    let from = if pin.from == Zero::Upright { "pinned.from_upright" } else { "pinned.from_hanging" };
    let mut text = vec![
        pen.desk.say("pinned.forces", &[("radial", &names.radial), ("across", &names.across)]),
        pen.desk.say(from, &[("phi", angle)]),
    ];
    text.extend(moments);
    if pin.spring.is_some() {
        text.push(pen.desk.say("pinned.forces_spring", &[("spring", &names.spring)]));
    }
    text.push(pen.desk.say("pinned.kinetic", &[]));
    pen.paragraph(&text);
    let name = format!("forces-{}", pen.desk.scene.bodies[body].name);
    pen.picture(&name);
    pen.done();
}

impl Spring {
    /// Its data; where the stretch at the start is given, that stands for the natural length.
    fn new(desk: &mut Desk, pin: &Pin, stretch_name: &str) -> Option<Self> {
        let s = pin.spring.as_ref()?;
        Some(Self {
            b: desk.number(s.at_m, "b", "m"),
            x: desk.number(s.x_m, "x_A", "m"),
            y: desk.number(s.y_m, "y_A", "m"),
            k: desk.number(s.stiffness_n_m, "k_s", "N/m"),
            l0: match s.rest {
                Rest::Length(l) => desk.number(l, "l_0", "m"),
                Rest::Stretch(stretch) => desk.number(stretch, &format!("{stretch_name}_0"), "m"),
            },
        })
    }
}

/// Free body, and the quantities that everything else needs.
fn read(desk: &mut Desk, body: usize, pin: &Pin) -> Result<Swing, Stop> {
    let scene = desk.scene;
    let angle = desk.free(&[r"\phi", r"\varphi", r"\theta", r"\beta"]);
    let names = Names::new(desk);
    let (zero, one) = (format!("{angle}_0"), format!("{angle}_1"));
    let phi0 = desk.number(pin.start_deg, &zero, "deg");
    let g = desk.number(scene.gravity_m_s2, "g", "m/s^2");
    let start = scene.start.iter().rev().find_map(|s| match s {
        Start::Speed(c, w) if c.body == body => Some(*w),
        _ => None,
    });
    let w0_name = desk.free(&[r"\omega_0", r"\Omega_0"]);
    let w0 = start.map_or(ZERO, |w| desk.number(w, &w0_name, "rad/s"));
    let couples = scene.couples.iter().filter(|c| c.body == body);
    let couples: Vec<Expr> = couples
        .map(|c| signed(desk.number(c.moment_n_m, "M", "N m"), c.forward))
        .filter(|moment| *moment != ZERO)
        .collect();
    let phi = Expr::Symbol(desk.unknown(&angle, "1"));
    free_body(desk, pin, &names, (body, &angle), &couples);

    let mut pen = Pen::new(desk, "inertia", "pinned.title_inertia");
    let m = mass::mass(&mut pen, body);
    let h = match pin.arm {
        Arm::Distance(h) => pen.desk.number(h, "h", "m"),
        Arm::HalfOf(l) => {
            let l = pen.desk.number(l, "L", "m");
            let name = pen.desk.free(&["h", "r_G"]);
            pen.say("pinned.arm_rod", &[]);
            pen.find(&name, "m", l / whole(2)).into()
        }
    };
    if pen.value(&h) <= 0.0 {
        return Err(Beyond::PinAtCentre.into());
    }
    let own = mass::inertia(&mut pen, body, &m);
    pen.say(if own == ZERO { "pinned.inertia_point" } else { "pinned.inertia" }, &[]);
    let name = pen.desk.free(&["I_O", "J_O"]);
    let about = pen.find(&name, "kg m^2", &own + &m * square(&h));
    pen.motion(Label { quantity: Quantity::IO, of: Owner::Body(body) }, about);
    let spring = Spring::new(pen.desk, pin, &names.stretch);
    pen.done();

    let mut swing = Swing {
        body,
        up: pin.from == Zero::Upright,
        m,
        g,
        h,
        own,
        about,
        couples,
        spring,
        phi,
        phi0: phi0.clone(),
        phi1: phi0,
        w0,
        instant: matches!(scene.end, End::AtOnce),
        sense: 1.0,
        names,
    };
    if let Some(Rest::Stretch(_)) = pin.spring.as_ref().map(|s| s.rest) {
        swing.natural_length(desk);
    }
    let spin = swing.w0.value(&desk.ledger);
    let drive = swing.moment_at(desk, swing.phi0.value(&desk.ledger));
    swing.sense = if spin != 0.0 { spin.signum() } else { drive.signum() };
    swing.phi1 = match scene.end {
        End::AtOnce => swing.phi0.clone(),
        End::Angle(_, angle) => desk.number(angle, &one, "deg"),
        End::TurningPoint(_) => swing.angle_of_speed(desk, &one, 0.0)?,
        End::Speed(_, w) => {
            let w = desk.value(w);
            swing.angle_of_speed(desk, &one, w)?
        }
        _ => {
            return Err(Beyond::PinnedEnd.into());
        }
    };
    Ok(swing)
}

impl Spring {
    /// Its length at an angle, by the law of cosines.
    fn length(&self, up: bool, phi: &Expr) -> Expr {
        let along = &self.x * sine(phi) + signed(&self.y * cosine(phi), up);
        let twice = match &along {
            Expr::Sum(terms) => whole(2) * &self.b * Expr::Sum(terms.clone()),
            one => whole(2) * &self.b * one,
        };
        root(square(&self.x) + square(&self.y) + square(&self.b) - twice)
    }

    /// The same by the places of its ends.
    fn length_by_places(&self, up: bool, phi: &Expr) -> Expr {
        let dx = &self.x - &self.b * sine(phi);
        let dy = &self.y - signed(&self.b * cosine(phi), up);
        root(square(dx) + square(dy))
    }

    /// Anchor as seen from the pin, along the body outward.
    fn along(&self, up: bool, phi: &Expr) -> Expr {
        &self.x * sine(phi) + signed(&self.y * cosine(phi), up)
    }

    /// Anchor as seen from the pin, across the body, with growing angle.
    fn aside(&self, up: bool, phi: &Expr) -> Expr {
        &self.x * cosine(phi) - signed(&self.y * sine(phi), up)
    }
}

/// What the road of the equations of motion has found, for what comes after it.
struct Worked {
    pendulum: bool,
    omega: Symbol,
    /// Force of the spring, and its direction, at the end.
    place: Place,
    /// The angle turned, radians, where it was needed.
    turned: Option<Symbol>,
}

/// Parts of an integral over the angle, or of a work: name, expression in symbols.
struct Part {
    name: &'static str,
    from: Expr,
}

impl Swing {
    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    /// The natural length is what is left of the length at the start without the stretch there.
    fn natural_length(&mut self, desk: &mut Desk) {
        let Some(s) = &mut self.spring else { return };
        let mut pen = Pen::new(desk, "spring", "pinned.title_spring");
        pen.say("pinned.natural", &[]);
        let length = pen.find(&format!("{}_0", self.names.length), "m", s.length(self.up, &self.phi0));
        let name = pen.desk.free(&["l_0", "l_n"]);
        s.l0 = pen.find(&name, "m", length - &s.l0).into();
        pen.done();
    }

    fn asks_pin(&self, desk: &Desk) -> bool {
        [Quantity::PinRadial, Quantity::PinTangential, Quantity::PinForce].iter().any(|q| desk.asks(*q))
    }

    /// Moment of the weight about the pin, with growing angle.
    fn weight_moment(&self, phi: &Expr) -> Expr {
        let size = &self.m * &self.g * &self.h * sine(phi);
        signed(size, self.up)
    }

    /// Component of the weight toward the pin.
    fn weight_toward(&self, phi: &Expr) -> Expr {
        signed(&self.m * &self.g * cosine(phi), self.up)
    }

    /// Component of the weight across, with growing angle.
    fn weight_across(&self, phi: &Expr) -> Expr {
        signed(&self.m * &self.g * sine(phi), self.up)
    }

    /// `cos phi0 - cos phi1` from upright, `cos phi1 - cos phi0` from hanging: what the mass centre sinks by, over `h`.
    fn sinking(&self, from: &Expr, to: &Expr) -> Expr {
        if self.up { cosine(from) - cosine(to) } else { cosine(to) - cosine(from) }
    }

    /// The moments about the pin, one for each force.
    fn moments(&self, place: &Place) -> Vec<Expr> {
        let mut terms = vec![self.weight_moment(&place.phi)];
        terms.extend(self.couples.iter().cloned());
        if let (Some(s), Some((force, _, side))) = (&self.spring, &place.spring) {
            terms.push(force * &s.b * side);
        }
        terms.retain(|t| *t != ZERO);
        terms
    }

    /// Force of the pin toward it.
    fn toward(&self, square_of_spin: Expr, place: &Place) -> Expr {
        let pull = place.spring.as_ref().map_or(ZERO, |(f, out, _)| f * out);
        let kept = &self.m * &self.h * square_of_spin;
        kept - self.weight_toward(&place.phi) + pull
    }

    /// Force of the pin across.
    fn aside(&self, alpha: Expr, place: &Place) -> Expr {
        let pull = place.spring.as_ref().map_or(ZERO, |(f, _, side)| f * side);
        let kept = &self.m * &self.h * alpha;
        kept - self.weight_across(&place.phi) - pull
    }

    /// What the couples add up to.
    fn couple(&self) -> Expr {
        sum(self.couples.iter().cloned())
    }

    // -- in doubles -----------------------------------------------------------------------------------------------------

    /// Moment about the pin at an angle in degrees.
    fn moment_at(&self, desk: &Desk, degrees: f64) -> f64 {
        let of = |e: &Expr| e.value(&desk.ledger);
        let (s, c): (f64, f64) = trig::sin_cos_of_degrees(degrees);
        let up = if self.up { 1.0 } else { -1.0 };
        let mut moment = up * of(&self.m) * of(&self.g) * of(&self.h) * s + of(&self.couple());
        if let Some(spring) = &self.spring {
            let (force, length) = self.spring_at(desk, degrees);
            moment += force * of(&spring.b) * (of(&spring.x) * c - up * of(&spring.y) * s) / length;
        }
        moment
    }

    /// Force and length of the spring at an angle in degrees.
    fn spring_at(&self, desk: &Desk, degrees: f64) -> (f64, f64) {
        let Some(spring) = &self.spring else { return (0.0, 0.0) };
        let of = |e: &Expr| e.value(&desk.ledger);
        let (s, c): (f64, f64) = trig::sin_cos_of_degrees(degrees);
        let up = if self.up { 1.0 } else { -1.0 };
        let (dx, dy) = (of(&spring.x) - of(&spring.b) * s, of(&spring.y) - up * of(&spring.b) * c);
        let length = (dx * dx + dy * dy).sqrt();
        (of(&spring.k) * (length - of(&spring.l0)), length)
    }

    /// Square of the angular speed at an angle in degrees, from the work since the start.
    fn square_at(&self, desk: &Desk, degrees: f64) -> f64 {
        let of = |e: &Expr| e.value(&desk.ledger);
        let start = of(&self.phi0);
        let cosine = |d: f64| -> f64 { trig::sin_cos_of_degrees::<f64>(d).1 };
        let up = if self.up { 1.0 } else { -1.0 };
        let fall = up * (cosine(start) - cosine(degrees));
        let mut work = of(&self.m) * of(&self.g) * of(&self.h) * fall
            + of(&self.couple()) * (degrees - start) * std::f64::consts::PI / 180.0;
        if let Some(spring) = &self.spring {
            let stretch = |d: f64| self.spring_at(desk, d).1 - of(&spring.l0);
            let (a, b) = (stretch(start), stretch(degrees));
            work += 0.5 * of(&spring.k) * (a - b) * (a + b);
        }
        let spin = of(&self.w0);
        spin * spin + 2.0 * work / desk.ledger.value(self.about)
    }

    /// The first angle at which the body has this speed, as a symbol in degrees.
    fn angle_of_speed(&self, desk: &mut Desk, tex: &str, speed: f64) -> Result<Expr, Stop> {
        let start = self.phi0.value(&desk.ledger);
        let over = |way: f64| self.square_at(desk, start + self.sense * way) - speed * speed;
        let first = over(LOOK);
        let mut low = LOOK;
        let found = loop {
            let high = low + LOOK;
            if high > FAR {
                break None;
            }
            if over(high) * first <= 0.0 {
                break Some((low, high));
            }
            low = high;
        };
        let Some((mut low, mut high)) = found else {
            return Err(Beyond::NoAngle.into());
        };
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if over(middle) * first > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let value = start + self.sense * 0.5 * (low + high);
        let digits = number::rounded(value, FIGURES);
        Ok(desk.ledger.given(tex, value, &digits, "", true).into())
    }

    // -- the road of the equations of motion ------------------------------------------------------------------------------

    /// Force and direction of the spring at the end, with the steps.
    fn place(&self, pen: &mut Pen, by_places: bool) -> Place {
        let spring = self.spring.as_ref().map(|s| {
            let length = if by_places {
                s.length_by_places(self.up, &self.phi1)
            } else {
                s.length(self.up, &self.phi1)
            };
            let length = Expr::Symbol(pen.find(&format!("{}_1", self.names.length), "m", &length));
            let force = pen.find(&self.names.spring, "N", &s.k * (&length - &s.l0));
            let label = self.label(Quantity::SpringForce);
            if by_places {
                pen.energy(label, force)
            } else {
                pen.motion(label, force)
            }
            let side = pen.find(&self.names.side, "1", s.aside(self.up, &self.phi1) / &length);
            let out = if self.asks_pin(pen.desk) {
                let out = (s.along(self.up, &self.phi1) - &s.b) / length;
                pen.find(&self.names.out, "1", &out).into()
            } else {
                ZERO
            };
            (Expr::Symbol(force), out, Expr::Symbol(side))
        });
        Place { phi: self.phi1.clone(), spring }
    }

    /// The equations of motion at any angle, in symbols.
    fn rows(&self, pen: &mut Pen, pins: bool) {
        let names = &self.names;
        let alpha = pen.unknown(&names.alpha, "rad/s^2");
        let omega = pen.unknown(&names.omega, "rad/s");
        let generic = Place {
            phi: self.phi.clone(),
            spring: self.spring.as_ref().map(|_| {
                let mut of = |tex: &str| pen.unknown(tex, "1");
                (of(&names.spring), of(&names.out), of(&names.side))
            }),
        };
        pen.say("pinned.row_moment", &[]);
        let moments = sum(self.moments(&generic));
        pen.equation(self.about * &alpha, &moments);
        let mut circle = None;
        if pins {
            let unknown = |pen: &mut Pen, tex: &str| pen.unknown(tex, "N");
            let (radial, across) = (unknown(pen, &names.radial), unknown(pen, &names.across));
            pen.say("pinned.row_radial", &[("central", &names.central)]);
            let pull = generic.spring.as_ref();
            let right = radial + self.weight_toward(&self.phi) + pull.map_or(ZERO, |(f, out, _)| -(f * out));
            let central = pen.unknown(&names.central, "m/s^2");
            pen.equation(&self.m * &central, &right);
            pen.say("pinned.row_across", &[("aside", &names.aside)]);
            let right = across + self.weight_across(&self.phi) + pull.map_or(ZERO, |(f, _, side)| f * side);
            let aside = pen.unknown(&names.aside, "m/s^2");
            pen.equation(&self.m * &aside, &right);
            circle = Some((central, aside));
        }
        if let (Some(s), Some((force, out, side))) = (&self.spring, &generic.spring) {
            let length = pen.unknown(&names.length, "m");
            pen.say(
                if pins { "pinned.spring_rows" } else { "pinned.spring_row" },
                &[("length", &names.length), ("out", &names.out), ("side", &names.side)],
            );
            pen.equation(&length, s.length(self.up, &self.phi));
            pen.equation(force, &s.k * (&length - &s.l0));
            pen.equation(side, s.aside(self.up, &self.phi) / &length);
            if pins {
                let along = s.along(self.up, &self.phi) - &s.b;
                pen.equation(out, along / length);
            }
        }
        let radius = pen.tex(&self.h);
        let closed =
            [("radius", radius.as_str()), ("alpha", names.alpha.as_str()), ("omega", names.omega.as_str())];
        if let Some((central, aside)) = circle {
            pen.say("pinned.closed_pins", &closed[..1]);
            pen.equation(&central, &self.h * square(&omega));
            pen.equation(&aside, &self.h * &alpha);
            pen.say("pinned.order", &closed[1..]);
        } else {
            pen.say("pinned.closed", &closed[..2]);
        }
    }

    fn equations(&self, desk: &mut Desk) -> Worked {
        let names = &self.names;
        let pins = self.asks_pin(desk);
        let pendulum = desk.scene.is_pendulum();
        let mut pen = Pen::new(desk, "eom", "pinned.title_eom");
        self.rows(&mut pen, pins);
        let ends = match pen.desk.scene.end {
            End::TurningPoint(_) => Some("pinned.angle_turning"),
            End::Speed(..) => Some("pinned.angle_speed"),
            _ => None,
        };
        if let (Some(phrase), Expr::Symbol(angle)) = (ends, &self.phi1) {
            pen.say(phrase, &[("omega", &names.omega)]);
            pen.formula(pen.with_value(*angle));
        }
        let at = self.told(&pen, &self.phi1);
        pen.say(if self.instant { "pinned.at_start" } else { "pinned.at" }, &[("angle", &at)]);
        let place = self.place(&mut pen, false);
        let moments = self.moments(&place);
        let over = if moments.len() > 1 {
            let name = pen.desk.free(&["M_O", r"M_{\mathrm{O}}"]);
            Expr::Symbol(pen.find(&name, "N m", sum(moments)))
        } else {
            sum(moments)
        };
        let alpha = pen.find(&names.alpha, "rad/s^2", over / self.about);
        pen.motion(self.label(Quantity::Alpha), alpha);

        let mut worked = Worked { pendulum, omega: alpha, place, turned: None };
        worked.omega = self.integral(&mut pen, &mut worked);
        let omega = worked.omega;
        pen.motion(self.label(Quantity::Omega), omega);
        if pins {
            pen.say("pinned.reactions", &[("angle", &at)]);
            let radial = pen.find(&names.radial, "N", self.toward(square(omega), &worked.place));
            let across = pen.find(&names.across, "N", self.aside(alpha.into(), &worked.place));
            self.told_pin(&mut pen, radial, across);
            pen.motion(self.label(Quantity::PinRadial), radial);
            pen.motion(self.label(Quantity::PinTangential), across);
            if pen.desk.asks(Quantity::PinForce) {
                let whole = root(square(radial) + square(across));
                let force = pen.find(&names.pin, "N", &whole);
                pen.motion(self.label(Quantity::PinForce), force);
            }
        }
        self.others(&mut pen, omega);
        pen.done();
        worked
    }

    /// `\phi_1 = 30^\circ`; only the number where it is a constant 0.
    fn told(&self, pen: &Pen, angle: &Expr) -> String {
        match angle {
            Expr::Symbol(s) => pen.with_value(*s),
            _ => format!(r"{} = 0", pen.tex(&self.phi)),
        }
    }

    /// What the signs of the pin's force say.
    fn told_pin(&self, pen: &mut Pen, radial: Symbol, across: Symbol) {
        let (r, s) = (pen.desk.ledger.value(radial), pen.desk.ledger.value(across));
        let toward = if r > 0.0 { "pinned.pin_toward" } else { "pinned.pin_outward" };
        let aside = if s > 0.0 { "pinned.pin_with" } else { "pinned.pin_against" };
        let mut text = Vec::new();
        if r != 0.0 {
            text.push(pen.desk.say(toward, &[("radial", &self.names.radial)]));
        }
        if s != 0.0 {
            text.push(pen.desk.say(aside, &[("across", &self.names.across)]));
        }
        pen.paragraph(&text);
    }

    /// The integral over the angle; the angular speed at the end.
    fn integral(&self, pen: &mut Pen, worked: &mut Worked) -> Symbol {
        let names = &self.names;
        if self.instant {
            pen.say("pinned.instant", &[]);
            return pen.find(&names.omega, "rad/s", magnitude_of(&self.w0, pen.value(&self.w0)));
        }
        let (phi0, phi1, phi) = (pen.tex(&self.phi0), pen.tex(&self.phi1), pen.tex(&self.phi));
        let (a, w) = (&names.alpha, &names.omega);
        let chain = format!(
            r"{a} = \frac{{\mathrm{{d}}{w}}}{{\mathrm{{d}}t}} = {w}\,\frac{{\mathrm{{d}}{w}}}{{\mathrm{{d}}{phi}}}"
        );
        pen.say("pinned.integrate", &[("chain", &chain), ("alpha", a), ("phi", &phi)]);
        let w0 = pen.tex(&self.w0);
        pen.formula(format!(
            r"\int_{{{w0}}}^{{{w}}} {w}\,\mathrm{{d}}{w} = \int_{{{phi0}}}^{{{phi1}}} {a}\,\mathrm{{d}}{phi}"
        ));
        let mut parts = vec![Part {
            name: "J_g",
            from: &self.m * &self.g * &self.h * self.sinking(&self.phi0, &self.phi1),
        }];
        if !self.couples.is_empty() {
            let turned = self.turned(pen);
            worked.turned = Some(turned);
            parts.push(Part { name: "J_M", from: self.couple() * turned });
        }
        if let Some(s) = &self.spring {
            let (length, force, side) = (&names.length, &names.spring, &names.side);
            let b = pen.tex(&s.b);
            let chain = format!(r"\mathrm{{d}}{length} = -{b}\,{side}\,\mathrm{{d}}{phi}");
            let stretch = pen.unknown(length, "m") - &s.l0;
            let law = pen.tex(&(&s.k * stretch));
            let becomes = format!(r"{force}\,{b}\,{side}\,\mathrm{{d}}{phi} = -{law}\,\mathrm{{d}}{length}");
            pen.say("pinned.spring_integral", &[("chain", &chain), ("becomes", &becomes)]);
            let first = pen.find(&format!("{length}_0"), "m", s.length(self.up, &self.phi0));
            let last = self.length(pen);
            let of = |l: Symbol| l - &s.l0;
            let a = pen.find(&format!("{}_0", names.stretch), "m", of(first));
            let b = pen.find(&format!("{}_1", names.stretch), "m", of(last));
            let squares = square(a) - square(b);
            parts.push(Part { name: "J_s", from: ratio(1, 2) * &s.k * squares });
        }
        parts.retain(|p| p.from != ZERO);
        let omega = pen.unknown(w, "rad/s");
        let gained = square(omega) - square(&self.w0);
        let left = ratio(1, 2) * self.about * gained;
        pen.say("pinned.integrated", &[]);
        pen.equation(&left, sum(parts.iter().map(|p| p.from.clone())));
        let twice = self.collected(pen, parts, self.about.into(), "J");
        if matches!(pen.desk.scene.end, End::TurningPoint(_)) {
            pen.say("pinned.at_rest", &[]);
            return pen.quiet(w, "rad/s", &ZERO);
        }
        let inside = square(&self.w0) + twice;
        let omega = pen.find(w, "rad/s", root(inside));
        if self.sense < 0.0 {
            pen.say("pinned.magnitude", &[("omega", w)]);
        }
        omega
    }

    /// Twice the sum of the parts over an inertia; several parts each by itself first.
    fn collected(&self, pen: &mut Pen, parts: Vec<Part>, inertia: Expr, total: &str) -> Expr {
        let sum_of = if parts.len() > 1 {
            let mut found = Vec::new();
            for part in parts {
                found.push(Expr::Symbol(pen.find(part.name, "J", &part.from)));
            }
            let name = pen.desk.free(&[total, "Z"]);
            pen.find(&name, "J", sum(found)).into()
        } else {
            sum(parts.into_iter().map(|p| p.from))
        };
        whole(2) * sum_of / inertia
    }

    /// The length of the spring at the end, which [`Self::place`] has found.
    fn length(&self, pen: &mut Pen) -> Symbol {
        let Some(s) = &self.spring else { return self.about };
        pen.quiet(&format!("{}_1", self.names.length), "m", s.length(self.up, &self.phi1))
    }

    /// The angle turned, in radians with its sign.
    fn turned(&self, pen: &mut Pen) -> Symbol {
        let name = format!(r"\Delta {}", pen.tex(&self.phi));
        pen.say("pinned.radians", &[]);
        let pi = pen.desk.ledger.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let half = pen.desk.ledger.given(r"180^\circ", 180.0, "180", "", true);
        let angle = &self.phi1 - &self.phi0;
        pen.find(&name, "rad", angle * pi / half)
    }

    /// Quantities that follow at once.
    fn others(&self, pen: &mut Pen, omega: Symbol) {
        let asked = |pen: &Pen, q| pen.desk.asks(q);
        if asked(pen, Quantity::V) {
            pen.say("pinned.speed", &[]);
            let v = pen.find(&self.names.speed, "m/s", &self.h * omega);
            pen.motion(self.label(Quantity::V), v);
        }
        if asked(pen, Quantity::KineticEnergy) {
            pen.say("pinned.kinetic_pin", &[]);
            let name = pen.desk.free(&["T", "T_1", "E"]);
            let t = pen.find(&name, "J", ratio(1, 2) * self.about * square(omega));
            pen.motion(Label { quantity: Quantity::KineticEnergy, of: Owner::Scene }, t);
        }
        if asked(pen, Quantity::RotationalFraction) {
            pen.say("pinned.share", &[]);
            let name = pen.desk.free(&[r"\zeta", r"\zeta_r"]);
            let share = pen.find(&name, "1", &self.own / self.about);
            let label = Label { quantity: Quantity::RotationalFraction, of: Owner::Scene };
            pen.motion(label, share);
            let by_speeds = &self.own / (&self.m * square(&self.h) + &self.own);
            let share = pen.quiet(&name, "1", &by_speeds);
            pen.energy(label, share);
        }
        let geometry = pen.desk.words.get("pinned.note_geometry").to_owned();
        if asked(pen, Quantity::Phi) && !self.instant {
            let turned = self.turned(pen);
            let size = magnitude_of(&turned.into(), pen.desk.ledger.value(turned));
            let label = self.label(Quantity::Phi);
            let name = format!(r"\left|{}\right|", pen.desk.ledger.tex(turned));
            let turned = pen.quiet(&name, "rad", &size);
            pen.desk.from_one_road(label, Answer::Value(turned), &geometry);
        }
        if asked(pen, Quantity::Rise) && !self.instant {
            pen.say("pinned.rise", &[]);
            let rise = pen.find(r"\Delta z", "m", -(&self.h * self.sinking(&self.phi0, &self.phi1)));
            pen.desk.from_one_road(self.label(Quantity::Rise), Answer::Value(rise), &geometry);
        }
    }
}

/// The magnitude of something whose value is known.
fn magnitude_of(e: &Expr, value: f64) -> Expr {
    if value < 0.0 { magnitude(e.clone()) } else { e.clone() }
}

// -- swings under the weight alone ----------------------------------------------------------------------------------------

/// The swing from its lowest place.
struct Shape {
    /// `kappa`: the sine of half the amplitude, above 1 where it goes over the top.
    kappa: Symbol,
    /// Its complement `sqrt(1 - kappa^2)`; of a body that goes over the top `sqrt(kappa^2 - 1)`.
    complement: Symbol,
}

impl Swing {
    fn asks_swings(&self, desk: &Desk) -> bool {
        let all = [Quantity::Period, Quantity::PeriodSmall, Quantity::OmegaSmall, Quantity::OmegaMax];
        all.iter().any(|q| desk.asks(*q))
    }

    /// `1 - cos` of the angle from hanging: by how much the mass centre is above its lowest place, over `h`.
    fn above_lowest(&self) -> Expr {
        if self.up { ONE + cosine(&self.phi0) } else { ONE - cosine(&self.phi0) }
    }

    /// Half the angle from hanging at the start.
    fn half(&self, pen: &mut Pen) -> Expr {
        if !self.up {
            return &self.phi0 / whole(2);
        }
        let turn = pen.desk.ledger.given(r"180^\circ", 180.0, "180", "", true);
        (turn - &self.phi0) / whole(2)
    }

    /// Periods and the greatest speed, from the first row of the equations.
    fn swings(&self, desk: &mut Desk) {
        if !self.asks_swings(desk) {
            return;
        }
        let mut pen = Pen::new(desk, "swings", "pinned.title_swings");
        let from_lowest = if self.up { "pinned.small_upright" } else { "pinned.small" };
        let phi = pen.tex(&self.phi);
        pen.say(from_lowest, &[("phi", &phi)]);
        let psi = pen.desk.free(&[r"\psi", r"\chi"]);
        let angle = if self.up { psi.clone() } else { phi.clone() };
        let stiffness = pen.tex(&(&self.m * &self.g * &self.h));
        let about = pen.desk.ledger.tex(self.about).to_owned();
        pen.formula(format!(
            r"{about}\,\ddot{{{angle}}} = -{stiffness}\,\sin {angle} \quad \Rightarrow \quad {about}\,\ddot{{{angle}}} \approx -{stiffness}\,{angle}"
        ));
        pen.say("pinned.small_law", &[]);
        let pulled = &self.m * &self.g * &self.h;
        let frequency = pen.desk.free(&[r"\Omega", r"\omega_s"]);
        let frequency = pen.find(&frequency, "rad/s", root(pulled / self.about));
        pen.motion(self.label(Quantity::OmegaSmall), frequency);
        if pen.desk.asks(Quantity::PeriodSmall) {
            let small = self.small_period(&mut pen, frequency);
            pen.motion(self.label(Quantity::PeriodSmall), small);
        }
        if pen.desk.asks(Quantity::OmegaMax) {
            pen.say("pinned.fastest", &[("alpha", &self.names.alpha)]);
            let fall = whole(2) * &self.m * &self.g * &self.h * self.above_lowest();
            let inside = square(&self.w0) + fall / self.about;
            let name = pen.desk.free(&[r"\omega_{\mathrm{max}}", r"\omega_m"]);
            let fastest = pen.find(&name, "rad/s", root(inside));
            pen.motion(self.label(Quantity::OmegaMax), fastest);
        }
        if pen.desk.asks(Quantity::Period) {
            let shape = self.shape(&mut pen, frequency);
            self.by_mean(&mut pen, frequency, &shape);
        }
        pen.done();
    }

    fn small_period(&self, pen: &mut Pen, frequency: Symbol) -> Symbol {
        let pi = pen.desk.ledger.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = pen.desk.free(&[r"\tau_0", r"\tau_s"]);
        pen.find(&name, "s", whole(2) * pi / frequency)
    }

    /// The sine of half the amplitude; above 1 where the body goes over the top.
    fn amplitude(&self, pen: &mut Pen, frequency: Symbol) -> Expr {
        let half = self.half(pen);
        let sine_half = if self.phi0 == ZERO && !self.up { ZERO } else { sine(half) };
        if self.w0 == ZERO {
            let value = pen.value(&sine_half);
            return magnitude_of(&sine_half, value);
        }
        let share = &self.w0 / (whole(2) * frequency);
        root(square(&sine_half) + square(&share))
    }

    /// The modulus of the swing, with its steps.
    fn shape(&self, pen: &mut Pen, frequency: Symbol) -> Shape {
        let half = self.half(pen);
        let phi = pen.tex(&self.phi);
        let kappa = pen.desk.free(&[r"\kappa", r"\lambda"]);
        let psi = pen.desk.free(&[r"\psi", r"\chi"]);
        let started = self.w0 != ZERO;
        let from = self.amplitude(pen, frequency);
        let omega = &self.names.omega;
        let tex_frequency = pen.desk.ledger.tex(frequency).to_owned();
        // The angle from hanging, in the formulas of the integral.
        let lowest = if self.up { pen.desk.free(&[r"\psi_h", r"\beta_h"]) } else { phi };
        pen.say(
            if started { "pinned.period_speed_started" } else { "pinned.period_speed" },
            &[("omega", omega), ("kappa", &kappa)],
        );
        pen.formula(format!(
            r"{omega} = 2\,{tex_frequency}\,\sqrt{{{kappa}^{{2}} - \left(\sin \frac{{{lowest}}}{{2}}\right)^{{2}}}}"
        ));
        let kappa = pen.find(&kappa, "1", &from);
        let over = pen.desk.ledger.value(kappa) > 1.0;
        let (kappa_tex, value) = (pen.desk.ledger.tex(kappa).to_owned(), Expr::from(kappa));
        let name = pen.desk.free(&[r"\kappa_c", r"\lambda_c"]);
        if over {
            pen.say("pinned.period_over", &[("kappa", &kappa_tex)]);
            let complement = pen.find(&name, "1", root(square(value) - ONE));
            return Shape { kappa, complement };
        }
        pen.say(
            "pinned.period_integral",
            &[
                ("omega", omega),
                ("angle", &lowest),
                ("substitution", &format!(r"\sin \frac{{{lowest}}}{{2}} = {kappa_tex}\,\sin {psi}")),
            ],
        );
        let tau = pen.desk.free(&[r"\tau", r"\tau_1"]);
        pen.formula(format!(
            r"\frac{{{tau}}}{{4}} = \int_{{0}}^{{\frac{{\pi}}{{2}}}} \frac{{\mathrm{{d}}{psi}}}{{{tex_frequency}\,\sqrt{{1 - {kappa_tex}^{{2}}\,\left(\sin {psi}\right)^{{2}}}}}}"
        ));
        let cosine_half = if self.phi0 == ZERO && !self.up { ONE } else { cosine(half.clone()) };
        let from = if started {
            root(ONE - square(value))
        } else {
            let value = pen.value(&cosine_half);
            magnitude_of(&cosine_half, value)
        };
        pen.say("pinned.period_complement", &[("kappa", &kappa_tex)]);
        let complement = pen.find(&name, "1", &from);
        Shape { kappa, complement }
    }

    /// The period by the arithmetic-geometric mean, with its steps as a table.
    fn by_mean(&self, pen: &mut Pen, frequency: Symbol, shape: &Shape) {
        let (kappa, complement) =
            (pen.desk.ledger.value(shape.kappa), pen.desk.ledger.value(shape.complement));
        let over = kappa > 1.0;
        let (mut a, mut b) = (if over { kappa } else { 1.0 }, complement);
        let first = if over { pen.desk.ledger.tex(shape.kappa).to_owned() } else { "1".to_owned() };
        let second = pen.desk.ledger.tex(shape.complement).to_owned();
        pen.say("pinned.mean", &[("first", &first), ("second", &second)]);
        pen.formula(r"a_{n+1} = \frac{a_n + b_n}{2}, \quad b_{n+1} = \sqrt{a_n\,b_n}");
        let mut rows = vec![vec!["$n$".to_owned(), "$a_n$".to_owned(), "$b_n$".to_owned()]];
        for n in 0..12 {
            let cell = |x: f64| format!("${}$", tex_digits(&number::rounded(x, 8), pen.desk.words));
            rows.push(vec![format!("${n}$"), cell(a), cell(b)]);
            if (a - b).abs() <= 1e-8 * a {
                break;
            }
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        for _ in 0..6 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        pen.table(rows);
        let name = pen.desk.free(&[r"\mu", r"\nu"]);
        let mean = pen.desk.ledger.found(&name, a, "");
        pen.say("pinned.mean_found", &[]);
        pen.formula(pen.with_value(mean));
        pen.say(if over { "pinned.mean_over" } else { "pinned.mean_quarter" }, &[("mean", &name)]);
        let pi = pen.desk.ledger.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = pen.desk.free(&[r"\tau", r"\tau_1"]);
        let turns = if over { pi.into() } else { whole(2) * pi };
        let period = pen.find(&name, "s", turns / (frequency * mean));
        pen.motion(self.label(Quantity::Period), period);
    }

    /// The same from energies: the pendulum of equal period, the fall to the lowest place, the mean slowness of the swing.
    fn swings_by_energy(&self, desk: &mut Desk) {
        if !self.asks_swings(desk) {
            return;
        }
        let mut pen = Pen::new(desk, "swings-energy", "pinned.title_swings_energy");
        let turning = &self.m * square(&self.h) + &self.own;
        pen.say("pinned.small_energy", &[]);
        let name = pen.desk.free(&[r"\ell", r"\ell_r"]);
        let length = pen.find(&name, "m", &turning / (&self.m * &self.h));
        let name = pen.desk.free(&[r"\Omega", r"\omega_s"]);
        let frequency = pen.find(&name, "rad/s", root(&self.g / length));
        pen.energy(self.label(Quantity::OmegaSmall), frequency);
        if pen.desk.asks(Quantity::PeriodSmall) {
            let small = self.small_period(&mut pen, frequency);
            pen.energy(self.label(Quantity::PeriodSmall), small);
        }
        if pen.desk.asks(Quantity::OmegaMax) {
            pen.say("pinned.fastest_energy", &[]);
            let name = pen.desk.free(&["z_0", "z_m"]);
            let fall = pen.find(&name, "m", &self.h * self.above_lowest());
            let gained = whole(2) * &self.m * &self.g * fall;
            let inside = square(&self.w0) + gained / turning;
            let name = pen.desk.free(&[r"\omega_{\mathrm{max}}", r"\omega_m"]);
            let fastest = pen.find(&name, "rad/s", root(inside));
            pen.energy(self.label(Quantity::OmegaMax), fastest);
        }
        if pen.desk.asks(Quantity::Period) {
            self.period_by_mean_value(&mut pen, frequency);
        }
        pen.done();
    }

    /// The period as that of small swings times a mean value over the swing.
    fn period_by_mean_value(&self, pen: &mut Pen, frequency: Symbol) {
        let from = self.amplitude(pen, frequency);
        let kappa = pen.value(&from);
        let over = kappa > 1.0;
        let name = pen.desk.free(&["q", "q_1"]);
        let psi = pen.desk.free(&[r"\psi", r"\chi"]);
        pen.say(if over { "pinned.mean_value_over" } else { "pinned.mean_value" }, &[("psi", &psi)]);
        // Of a body that goes over the top the amplitude is half the angle, and the modulus 1 / kappa.
        let q = pen.find(&name, "1", &if over { ONE / from } else { from });
        let modulus = pen.desk.ledger.value(q);
        // The nearest singular place of the integrand is as far from the real axis as this: each point gains its share.
        let away = 1.0 / modulus;
        let far = natural_log(away + (away * away - 1.0).max(0.0).sqrt());
        let enough = (-natural_log(MEAN_REL) / (4.0 * far)).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 4 and 4096")]
        let points = enough.clamp(4.0, 4096.0) as u32;
        let mut rows = vec![vec![
            format!("${psi}$"),
            format!(r"$\frac{{1}}{{\sqrt{{1 - {name}^{{2}}\,\left(\sin {psi}\right)^{{2}}}}}}$"),
        ]];
        let mut values = Vec::new();
        for i in 0..points {
            let angle = 90.0 * (f64::from(i) + 0.5) / f64::from(points);
            let (s, _): (f64, f64) = trig::sin_cos_of_degrees(angle);
            let value = 1.0 / (1.0 - modulus * modulus * s * s).sqrt();
            let digits = number::rounded(value, 8);
            let shown = tex_digits(&digits, pen.desk.words);
            let angle = tex_digits(&number::rounded(angle, FIGURES), pen.desk.words);
            rows.push(vec![format!(r"${angle}^\circ$"), format!("${shown}$")]);
            // A number that is its own name.
            values.push(Expr::Symbol(pen.desk.ledger.given(&shown, value, &digits, "", false)));
        }
        let count = points.to_string();
        pen.say("pinned.mean_value_sum", &[("count", &count)]);
        let name = pen.desk.free(&[r"\eta", r"\xi"]);
        let parts = whole(i64::from(points));
        let mean = if points <= 12 {
            pen.table(rows);
            let total = pen.desk.free(&["Z", "Z_1"]);
            let total = pen.find(&total, "1", sum(values));
            pen.find(&name, "1", total / parts)
        } else {
            let mean = pen.quiet(&name, "1", sum(values) / parts);
            pen.formula(pen.with_value(mean));
            mean
        };
        pen.say("pinned.mean_value_found", &[]);
        let pi = pen.desk.ledger.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = pen.desk.free(&[r"\tau", r"\tau_1"]);
        let from = if over { pi * mean * q / frequency } else { whole(2) * pi * mean / frequency };
        let period = pen.find(&name, "s", &from);
        pen.energy(self.label(Quantity::Period), period);
    }

    // -- the road of work and energy --------------------------------------------------------------------------------------

    fn balance(&self, desk: &mut Desk, worked: &Worked) {
        let names = &self.names;
        let mut pen = Pen::new(desk, "energy", "pinned.title_energy");
        let turning = &self.m * square(&self.h) + &self.own;
        let (first, last) = (self.told(&pen, &self.phi0), self.told(&pen, &self.phi1));
        let scene = Owner::Scene;
        let omega;
        if self.instant {
            pen.say("pinned.states_instant", &[("angle", &first)]);
            omega = pen.quiet(&names.omega, "rad/s", magnitude_of(&self.w0, pen.value(&self.w0)));
        } else {
            pen.say("pinned.states", &[("first", &first), ("last", &last)]);
            let height = -(&self.h * self.sinking(&self.phi0, &self.phi1));
            pen.say("pinned.height", &[]);
            let height = pen.find(r"\Delta z", "m", &height);
            let sinks = pen.desk.ledger.value(height) < 0.0;
            let size = pen.rough(pen.desk.ledger.value(height).abs(), "m");
            pen.say(if sinks { "pinned.sinks" } else { "pinned.rises" }, &[("size", &size)]);
            let weight = -(&self.m * &self.g * height);
            let mut works = vec![Expr::Symbol(pen.find("W_g", "J", &weight))];
            pen.say("pinned.work_pin", &[]);
            if let Some(turned) = worked.turned {
                pen.say("pinned.work_couple", &[("angle", &pen.with_value(turned))]);
                let work = self.couple() * turned;
                works.push(pen.find("W_M", "J", &work).into());
            }
            if let Some(s) = &self.spring {
                pen.say("pinned.work_spring", &[]);
                let length = &names.length;
                let a = pen.find(&format!("{length}_0"), "m", s.length_by_places(self.up, &self.phi0));
                let b = pen.find(&format!("{length}_1"), "m", s.length_by_places(self.up, &self.phi1));
                let stored = |l: Symbol| square(l - &s.l0);
                let work = ratio(1, 2) * &s.k * (stored(a) - stored(b));
                works.push(pen.find("W_s", "J", &work).into());
            }
            let kinetic = pen.desk.free(&["T", "E"]);
            let (t0, t1) = (format!("{kinetic}_0"), format!("{kinetic}_1"));
            let started = self.w0 != ZERO;
            pen.say(
                if started { "pinned.kinetic_both_started" } else { "pinned.kinetic_both" },
                &[("speed", &format!("{} = {}\\,{}", names.speed, pen.tex(&self.h), names.omega))],
            );
            let w = pen.unknown(&names.omega, "rad/s");
            let v = pen.unknown(&names.speed, "m/s");
            let halves = |rate: &Expr, inertia: &Expr| ratio(1, 2) * inertia * square(rate);
            let mut energy = halves(&v, &self.m).symbols(&pen.desk.ledger);
            if self.own != ZERO {
                energy.push_str(" + ");
                energy.push_str(&halves(&w, &self.own).symbols(&pen.desk.ledger));
            }
            let product_form = pen.tex(&(ratio(1, 2) * &turning * square(w)));
            pen.formula(format!("{t1} = {energy} = {product_form}"));
            let mut start = ZERO;
            if started {
                let from = ratio(1, 2) * &turning * square(&self.w0);
                start = pen.find(&t0, "J", &from).into();
            }
            let mut left = works.clone();
            left.insert(0, start.clone());
            let total = sum(left);
            let t1_symbol = pen.unknown(&t1, "J");
            pen.say("pinned.balance", &[]);
            pen.equation(&total, &t1_symbol);
            let t1_found = if matches!(total, Expr::Sum(_)) {
                pen.find(&t1, "J", &total)
            } else {
                pen.quiet(&t1, "J", &total)
            };
            let over = if matches!(total, Expr::Sum(_)) { t1_found.into() } else { total };
            omega = if matches!(pen.desk.scene.end, End::TurningPoint(_)) {
                pen.say("pinned.at_rest_energy", &[]);
                pen.quiet(&names.omega, "rad/s", &ZERO)
            } else {
                pen.find(&names.omega, "rad/s", root(whole(2) * over / &turning))
            };
        }
        pen.energy(self.label(Quantity::Omega), omega);
        if pen.desk.asks(Quantity::KineticEnergy) {
            let name = pen.desk.free(&["T", "E"]);
            let moving = ratio(1, 2) * &self.m * square(&self.h * omega);
            let spinning = ratio(1, 2) * &self.own * square(omega);
            let energy = pen.find(&name, "J", moving + spinning);
            pen.energy(Label { quantity: Quantity::KineticEnergy, of: scene }, energy);
        }
        self.rate(&mut pen, worked, &turning, omega);
        pen.picture("energy");
        if pen.desk.asks(Quantity::IO) {
            pen.say("pinned.inertia_energy", &[]);
            let name = pen.desk.free(&["I_O", "J_O"]);
            let about = pen.find(&name, "kg m^2", &turning);
            pen.energy(self.label(Quantity::IO), about);
        }
        pen.done();
    }

    /// Angular acceleration from the rate of the balance; forces of the pin from the central acceleration and from moments
    /// about the mass centre.
    fn rate(&self, pen: &mut Pen, worked: &Worked, turning: &Expr, omega: Symbol) {
        let names = &self.names;
        let needs =
            pen.desk.asks(Quantity::Alpha) || self.asks_pin(pen.desk) || pen.desk.asks(Quantity::SpringForce);
        if pen.desk.asks(Quantity::V) {
            let v = pen.find(&names.speed, "m/s", &self.h * omega);
            pen.energy(self.label(Quantity::V), v);
        }
        if !needs {
            return;
        }
        let phi = pen.tex(&self.phi);
        let last = self.told(pen, &self.phi1);
        let alpha = pen.unknown(&names.alpha, "rad/s^2");
        let slope_z = format!("z_{{{phi}}}");
        let slope_s = format!("{}_{{{phi}}}", names.length);
        pen.say("pinned.rate", &[("omega", &names.omega), ("phi", &phi)]);
        let z = pen.unknown(&slope_z, "m");
        let mut powers = vec![-(&self.m * &self.g * z)];
        powers.extend(self.couples.iter().cloned());
        if self.spring.is_some() {
            let force = pen.unknown(&names.spring, "N");
            let s = pen.unknown(&slope_s, "m");
            powers.push(-(force * s));
        }
        pen.equation(turning * alpha, sum(powers));
        pen.say("pinned.slopes", &[("angle", &last)]);
        let sinking = signed(&self.h * sine(&self.phi1), self.up);
        let z = pen.find(&slope_z, "m", -sinking);
        let mut powers = vec![-(&self.m * &self.g * z)];
        powers.extend(self.couples.iter().cloned());
        let mut place = Place { phi: self.phi1.clone(), spring: None };
        if let (Some(s), Some((_, out, _))) = (&self.spring, &worked.place.spring) {
            let length =
                pen.quiet(&format!("{}_1", names.length), "m", s.length_by_places(self.up, &self.phi1));
            let force = pen.find(&names.spring, "N", &s.k * (length - &s.l0));
            pen.energy(self.label(Quantity::SpringForce), force);
            let longer = -(&s.b * s.aside(self.up, &self.phi1) / length);
            let slope = pen.find(&slope_s, "m", &longer);
            powers.push(-(force * slope));
            let side = pen.quiet(&names.side, "1", -(slope / &s.b));
            place.spring = Some((force.into(), out.clone(), side.into()));
        }
        let over = if powers.len() > 1 {
            let name = format!("W_{{{phi}}}");
            Expr::Symbol(pen.find(&name, "J", sum(powers)))
        } else {
            sum(powers)
        };
        let alpha = pen.find(&names.alpha, "rad/s^2", over / turning);
        pen.energy(self.label(Quantity::Alpha), alpha);
        if !self.asks_pin(pen.desk) {
            return;
        }
        pen.say("pinned.pin_energy", &[("speed", &names.speed)]);
        let speed = pen.find(&names.speed, "m/s", &self.h * omega);
        let kept = &self.m * square(speed) / &self.h;
        let pull = place.spring.as_ref().map_or(ZERO, |(f, out, _)| f * out);
        let radial = pen.find(&names.radial, "N", kept - self.weight_toward(&self.phi1) + pull);
        pen.energy(self.label(Quantity::PinRadial), radial);
        // Moments about the mass centre.
        pen.say("pinned.pin_moment", &[("across", &names.across)]);
        let mut about: Vec<Expr> = self.couples.clone();
        if let (Some(s), Some((force, _, side))) = (&self.spring, &place.spring) {
            let lever = &s.b - &self.h;
            about.push(force * lever * side);
        }
        if about.len() > 1 {
            let name = pen.desk.free(&["M_G", r"M_{\mathrm{G}}"]);
            about = vec![pen.find(&name, "N m", sum(about)).into()];
        }
        about.push(-(&self.own * alpha));
        let across = pen.find(&names.across, "N", sum(about) / &self.h);
        pen.energy(self.label(Quantity::PinTangential), across);
        if pen.desk.asks(Quantity::PinForce) {
            let force = pen.find(&names.pin, "N", root(square(radial) + square(across)));
            pen.energy(self.label(Quantity::PinForce), force);
        }
    }
}

/// Natural logarithm.
fn natural_log(x: f64) -> f64 {
    trig::log10(x) / trig::log10(std::f64::consts::E)
}

// -- what was assumed, and what suggests itself ---------------------------------------------------------------------------

impl Swing {
    /// Does it get there, and which way?
    fn regime(&self, desk: &mut Desk, worked: &Worked) {
        let (first, last) = (self.phi0.value(&desk.ledger), self.phi1.value(&desk.ledger));
        let way = (last - first).abs();
        let mut pen = Pen::new(desk, "regime", "pinned.title_regime");
        if self.instant {
            self.direction(&mut pen);
            return;
        }
        let start = self.told(&pen, &self.phi0);
        let end = self.told(&pen, &self.phi1);
        let growing = if self.sense > 0.0 { "pinned.growing" } else { "pinned.falling" };
        let sense = pen.desk.words.get(growing).to_owned();
        let drive = self.moment_at(pen.desk, first);
        if self.w0 == ZERO {
            let moment = pen.rough(drive, "N m");
            pen.say("pinned.sets_off", &[("angle", &start), ("moment", &moment), ("sense", &sense)]);
        } else {
            pen.say("pinned.goes_on", &[("angle", &start), ("sense", &sense)]);
        }
        // How often the moment changes its sense on the way.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
        let steps = (way / LOOK).ceil().clamp(1.0, 4000.0) as u32;
        let at = |i: u32| first + (last - first) * f64::from(i) / f64::from(steps);
        let drives = |i: u32| self.moment_at(pen.desk, at(i)) * self.sense;
        let sizes = (0..=steps).map(|i| drives(i).abs()).fold(0.0, f64::max);
        let helps = (0..=steps).all(|i| drives(i) >= -1e-12 * sizes);
        let turns = (1..=steps).filter(|i| drives(*i - 1) * drives(*i) < 0.0).count();
        let square = self.square_at(pen.desk, last);
        let angle = [("angle", end.as_str()), ("omega", self.names.omega.as_str())];
        if matches!(pen.desk.scene.end, End::TurningPoint(_)) {
            pen.say("pinned.turns_there", &angle);
        } else if helps {
            pen.say("pinned.only_faster", &angle);
        } else if turns <= 1 && drives(0) >= 0.0 && square > 0.0 {
            pen.say("pinned.brakes_late", &angle);
        } else {
            let least = (1..=steps).map(|i| self.square_at(pen.desk, at(i))).fold(f64::INFINITY, f64::min);
            let least = pen.rough(least, "rad^2/s^2");
            pen.say("pinned.never_rests", &[angle[0], angle[1], ("least", &least)]);
        }
        if worked.pendulum && self.w0 == ZERO && !self.up {
            let phi = pen.tex(&self.phi);
            pen.say("pinned.stays", &[("phi", &phi), ("angle", &start)]);
        }
        pen.picture("graph-swing");
        self.direction(&mut pen);
        pen.done();
    }

    /// The direction as a word, if it is asked.
    fn direction(&self, pen: &mut Pen) {
        let word = if self.sense > 0.0 { Word::Forward } else { Word::Back };
        let label = self.label(Quantity::Direction);
        pen.desk.from_motion(label, Answer::Word(word));
        pen.desk.from_energy(label, Answer::Word(word));
    }
}
