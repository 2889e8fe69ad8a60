//! A body on a fixed pin, worked: moments about the pin, the integral over the angle, the force of the pin from the other two
//! rows; then energies, with the kinetic energy of the mass centre and of the rotation about it. Under the weight alone also
//! the periods: of small swings, and the real one by the arithmetic-geometric mean and by a mean value over the swing.
use crate::num::{shown, trig};
use crate::scene::{Arm, End, Label, Owner, Pin, Quantity, Rest, Start, Zero};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, cosine, magnitude, number as whole, ratio, root, signed, sine, square, sum,
};
use crate::solution::mass;
use crate::solution::section_writer::SectionWriter;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solve::outcome::Word;

/// Step in degrees in which an angle is looked for at which something happens.
const LOOK: f64 = 0.25;
/// The farthest way that is looked over, degrees.
const FAR: f64 = 720.0;
/// Error of a mean value over a swing, as a share.
const MEAN_REL: f64 = 1e-11;

/// The body in symbols.
struct PinnedBody {
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
    about: SymbolId,
    /// Moments of the couples, positive with growing angle.
    couples: Vec<Expr>,
    spring: Option<PinnedSpring>,
    phi: Expr,
    phi0: Expr,
    phi1: Expr,
    w0: Expr,
    /// Is only the instant of the start asked?
    instant: bool,
    /// Sense of the motion: 1 with growing angle.
    sense: f64,
    names: PinnedNames,
}

/// The spring in symbols.
struct PinnedSpring {
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
struct PinnedNames {
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
struct SpringPlace {
    phi: Expr,
    /// Force of the spring, and the components of its direction outward and across.
    spring: Option<(Expr, Expr, Expr)>,
}

/// Writes the sections of a pinned body.
///
/// # Errors
/// What this derivation does not cover.
pub fn work(draft: &mut Draft) -> Result<(), DerivationStop> {
    let Some((body, pin)) = draft.scene.pinned() else {
        return Err(Beyond::Arrangement.into());
    };
    let pin = *pin;
    let known = [Quantity::Omega, Quantity::Alpha, Quantity::V, Quantity::KineticEnergy];
    let ended = known.iter().any(|q| {
        let owner = if *q == Quantity::KineticEnergy { Owner::Scene } else { Owner::Body(body) };
        *q != Quantity::Alpha && draft.variant.solved.get(Label { quantity: *q, of: owner }).is_some()
    });
    if !ended {
        return Err(Beyond::NotThere.into());
    }
    let swing = read(draft, body, &pin)?;
    let solved = swing.equations(draft);
    if solved.pendulum {
        swing.swings(draft);
    }
    swing.balance(draft, &solved);
    if solved.pendulum {
        swing.swings_by_energy(draft);
    }
    swing.regime(draft, &solved);
    Ok(())
}

impl PinnedNames {
    fn new(draft: &Draft) -> Self {
        Self {
            omega: draft.free(&[r"\omega", r"\omega_1"]),
            alpha: draft.free(&[r"\alpha", r"\alpha_1"]),
            radial: draft.free(&["R", "O_r"]),
            across: draft.free(&["S", "O_t"]),
            pin: draft.free(&["F_O", "O"]),
            spring: draft.free(&["F_s", r"F_{\mathrm{s}}"]),
            length: draft.free(&["s", "d"]),
            out: draft.free(&["n_r", "c_r"]),
            side: draft.free(&["n_t", "c_t"]),
            central: draft.free(&["a_n", "a_c"]),
            aside: draft.free(&["a_t", "a_q"]),
            stretch: draft.free(&[r"\delta", "e"]),
            speed: draft.free(&["v_G", "u_G"]),
        }
    }
}

/// The free body, and the senses that count as positive.
fn free_body(
    draft: &mut Draft,
    pin: &Pin,
    names: &PinnedNames,
    (body, angle): (usize, &str),
    couples: &[Expr],
) {
    let moments: Vec<String> = couples
        .iter()
        .map(|c| {
            let (phrase, bare) = match c {
                Expr::Minus(inner) => ("pinned.forces_couple_back", inner.as_ref()),
                other => ("pinned.forces_couple", other),
            };
            draft.say(phrase, &[("moment", &bare.symbols(&draft.symbols))])
        })
        .collect();
    let mut page = SectionWriter::new(draft, "forces", "pinned.title_forces");
    page.picture("scene");
    let from = if pin.from == Zero::Upright { "pinned.from_upright" } else { "pinned.from_hanging" };
    let mut text = vec![
        page.draft.say("pinned.forces", &[("radial", &names.radial), ("across", &names.across)]),
        page.draft.say(from, &[("phi", angle)]),
    ];
    text.extend(moments);
    if pin.spring.is_some() {
        text.push(page.draft.say("pinned.forces_spring", &[("spring", &names.spring)]));
    }
    text.push(page.draft.say("pinned.kinetic", &[]));
    page.paragraph(&text);
    let name = format!("forces-{}", page.draft.scene.bodies[body].name);
    page.picture(&name);
    page.done();
}

impl PinnedSpring {
    /// Its data; where the stretch at the start is given, that stands for the natural length.
    fn new(draft: &mut Draft, pin: &Pin, stretch_name: &str) -> Option<Self> {
        let s = pin.spring.as_ref()?;
        Some(Self {
            b: draft.number(s.at_m, "b", "m"),
            x: draft.number(s.x_m, "x_A", "m"),
            y: draft.number(s.y_m, "y_A", "m"),
            k: draft.number(s.stiffness_n_m, "k_s", "N/m"),
            l0: match s.rest {
                Rest::Length(l) => draft.number(l, "l_0", "m"),
                Rest::Stretch(stretch) => draft.number(stretch, &format!("{stretch_name}_0"), "m"),
            },
        })
    }
}

/// Free body, and the quantities that everything else needs.
fn read(draft: &mut Draft, body: usize, pin: &Pin) -> Result<PinnedBody, DerivationStop> {
    let scene = draft.scene;
    let angle = draft.free(&[r"\phi", r"\varphi", r"\theta", r"\beta"]);
    let names = PinnedNames::new(draft);
    let (zero, one) = (format!("{angle}_0"), format!("{angle}_1"));
    let phi0 = draft.number(pin.start_deg, &zero, "deg");
    let g = draft.number(scene.gravity_m_s2, "g", "m/s^2");
    let start = scene.start.iter().rev().find_map(|s| match s {
        Start::Speed(c, w) if c.body == body => Some(*w),
        _ => None,
    });
    let w0_name = draft.free(&[r"\omega_0", r"\Omega_0"]);
    let w0 = start.map_or(ZERO, |w| draft.number(w, &w0_name, "rad/s"));
    let couples = scene.couples.iter().filter(|c| c.body == body);
    let couples: Vec<Expr> = couples
        .map(|c| signed(draft.number(c.moment_n_m, "M", "N m"), c.forward))
        .filter(|moment| *moment != ZERO)
        .collect();
    let phi = Expr::Symbol(draft.unknown(&angle, "1"));
    free_body(draft, pin, &names, (body, &angle), &couples);

    let mut page = SectionWriter::new(draft, "inertia", "pinned.title_inertia");
    let m = mass::mass(&mut page, body);
    let h = match pin.arm {
        Arm::Distance(h) => page.number(h, "h", "m"),
        Arm::HalfOf(l) => {
            let l = page.number(l, "L", "m");
            let name = page.free(&["h", "r_G"]);
            page.say("pinned.arm_rod", &[]);
            page.find(&name, "m", l / whole(2)).into()
        }
    };
    if page.value(&h) <= 0.0 {
        return Err(Beyond::PinAtCentre.into());
    }
    let own = mass::inertia(&mut page, body, &m);
    page.say(if own == ZERO { "pinned.inertia_point" } else { "pinned.inertia" }, &[]);
    let name = page.free(&["I_O", "J_O"]);
    let about = page.find(&name, "kg m^2", &own + &m * square(&h));
    page.motion(Label { quantity: Quantity::IO, of: Owner::Body(body) }, about);
    let spring = PinnedSpring::new(page.draft, pin, &names.stretch);
    page.done();

    let mut swing = PinnedBody {
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
        swing.natural_length(draft);
    }
    let spin = swing.w0.value(&draft.symbols);
    let drive = swing.moment_at(draft, swing.phi0.value(&draft.symbols));
    swing.sense = if spin != 0.0 { spin.signum() } else { drive.signum() };
    swing.phi1 = match scene.end {
        End::AtOnce => swing.phi0.clone(),
        End::Angle(_, angle) => draft.number(angle, &one, "deg"),
        End::TurningPoint(_) => swing.angle_of_speed(draft, &one, 0.0)?,
        End::Speed(_, w) => {
            let w = draft.value(w);
            swing.angle_of_speed(draft, &one, w)?
        }
        _ => {
            return Err(Beyond::PinnedEnd.into());
        }
    };
    Ok(swing)
}

impl PinnedSpring {
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

/// What the method of the equations of motion has found, for what comes after it.
struct PinnedResults {
    pendulum: bool,
    omega: SymbolId,
    /// Force of the spring, and its direction, at the end.
    place: SpringPlace,
    /// The angle turned, radians, where it was needed.
    turned: Option<SymbolId>,
}

/// Parts of an integral over the angle, or of a work: name, expression in symbols.
struct IntegralTerm {
    name: &'static str,
    from: Expr,
}

impl PinnedBody {
    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    /// The natural length is what is left of the length at the start without the stretch there.
    fn natural_length(&mut self, draft: &mut Draft) {
        let Some(s) = &mut self.spring else { return };
        let mut page = SectionWriter::new(draft, "spring", "pinned.title_spring");
        page.say("pinned.natural", &[]);
        let length = page.find(&format!("{}_0", self.names.length), "m", s.length(self.up, &self.phi0));
        let name = page.free(&["l_0", "l_n"]);
        s.l0 = page.find(&name, "m", length - &s.l0).into();
        page.done();
    }

    fn asks_pin(&self, draft: &Draft) -> bool {
        [Quantity::PinRadial, Quantity::PinTangential, Quantity::PinForce].iter().any(|q| draft.asks(*q))
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
    fn moments(&self, place: &SpringPlace) -> Vec<Expr> {
        let mut terms = vec![self.weight_moment(&place.phi)];
        terms.extend(self.couples.iter().cloned());
        if let (Some(s), Some((force, _, side))) = (&self.spring, &place.spring) {
            terms.push(force * &s.b * side);
        }
        terms.retain(|t| *t != ZERO);
        terms
    }

    /// Force of the pin toward it.
    fn toward(&self, square_of_spin: Expr, place: &SpringPlace) -> Expr {
        let pull = place.spring.as_ref().map_or(ZERO, |(f, out, _)| f * out);
        let kept = &self.m * &self.h * square_of_spin;
        kept - self.weight_toward(&place.phi) + pull
    }

    /// Force of the pin across.
    fn aside(&self, alpha: Expr, place: &SpringPlace) -> Expr {
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
    fn moment_at(&self, draft: &Draft, degrees: f64) -> f64 {
        let of = |e: &Expr| e.value(&draft.symbols);
        let (s, c): (f64, f64) = trig::sin_cos_of_degrees(degrees);
        let up = if self.up { 1.0 } else { -1.0 };
        let mut moment = up * of(&self.m) * of(&self.g) * of(&self.h) * s + of(&self.couple());
        if let Some(spring) = &self.spring {
            let (force, length) = self.spring_at(draft, degrees);
            moment += force * of(&spring.b) * (of(&spring.x) * c - up * of(&spring.y) * s) / length;
        }
        moment
    }

    /// Force and length of the spring at an angle in degrees.
    fn spring_at(&self, draft: &Draft, degrees: f64) -> (f64, f64) {
        let Some(spring) = &self.spring else { return (0.0, 0.0) };
        let of = |e: &Expr| e.value(&draft.symbols);
        let (s, c): (f64, f64) = trig::sin_cos_of_degrees(degrees);
        let up = if self.up { 1.0 } else { -1.0 };
        let (dx, dy) = (of(&spring.x) - of(&spring.b) * s, of(&spring.y) - up * of(&spring.b) * c);
        let length = (dx * dx + dy * dy).sqrt();
        (of(&spring.k) * (length - of(&spring.l0)), length)
    }

    /// Square of the angular speed at an angle in degrees, from the work since the start.
    fn square_at(&self, draft: &Draft, degrees: f64) -> f64 {
        let of = |e: &Expr| e.value(&draft.symbols);
        let start = of(&self.phi0);
        let cosine = |d: f64| -> f64 { trig::sin_cos_of_degrees::<f64>(d).1 };
        let up = if self.up { 1.0 } else { -1.0 };
        let fall = up * (cosine(start) - cosine(degrees));
        let mut work = of(&self.m) * of(&self.g) * of(&self.h) * fall
            + of(&self.couple()) * (degrees - start) * std::f64::consts::PI / 180.0;
        if let Some(spring) = &self.spring {
            let stretch = |d: f64| self.spring_at(draft, d).1 - of(&spring.l0);
            let (a, b) = (stretch(start), stretch(degrees));
            work += 0.5 * of(&spring.k) * (a - b) * (a + b);
        }
        let spin = of(&self.w0);
        spin * spin + 2.0 * work / draft.symbols.value(self.about)
    }

    /// The first angle at which the body has this speed, as a symbol in degrees.
    fn angle_of_speed(&self, draft: &mut Draft, tex: &str, speed: f64) -> Result<Expr, DerivationStop> {
        let start = self.phi0.value(&draft.symbols);
        let over = |way: f64| self.square_at(draft, start + self.sense * way) - speed * speed;
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
        let digits = shown::significant(value, FIGURES);
        Ok(draft.symbols.given(tex, value, &digits, "", true).into())
    }

    // -- the method of the equations of motion ------------------------------------------------------------------------------

    /// Force and direction of the spring at the end, with the steps.
    fn place(&self, page: &mut SectionWriter, by_places: bool) -> SpringPlace {
        let spring = self.spring.as_ref().map(|s| {
            let length = if by_places {
                s.length_by_places(self.up, &self.phi1)
            } else {
                s.length(self.up, &self.phi1)
            };
            let length = Expr::Symbol(page.find(&format!("{}_1", self.names.length), "m", &length));
            let force = page.find(&self.names.spring, "N", &s.k * (&length - &s.l0));
            let label = self.label(Quantity::SpringForce);
            if by_places {
                page.energy(label, force)
            } else {
                page.motion(label, force)
            }
            let side = page.find(&self.names.side, "1", s.aside(self.up, &self.phi1) / &length);
            let out = if self.asks_pin(page.draft) {
                let out = (s.along(self.up, &self.phi1) - &s.b) / length;
                page.find(&self.names.out, "1", &out).into()
            } else {
                ZERO
            };
            (Expr::Symbol(force), out, Expr::Symbol(side))
        });
        SpringPlace { phi: self.phi1.clone(), spring }
    }

    /// The equations of motion at any angle, in symbols.
    fn rows(&self, page: &mut SectionWriter, pins: bool) {
        let names = &self.names;
        let alpha = page.unknown(&names.alpha, "rad/s^2");
        let omega = page.unknown(&names.omega, "rad/s");
        let generic = SpringPlace {
            phi: self.phi.clone(),
            spring: self.spring.as_ref().map(|_| {
                let mut of = |tex: &str| page.unknown(tex, "1");
                (of(&names.spring), of(&names.out), of(&names.side))
            }),
        };
        page.say("pinned.row_moment", &[]);
        let moments = sum(self.moments(&generic));
        page.equation(self.about * &alpha, &moments);
        let mut circle = None;
        if pins {
            let unknown = |page: &mut SectionWriter, tex: &str| page.unknown(tex, "N");
            let (radial, across) = (unknown(page, &names.radial), unknown(page, &names.across));
            page.say("pinned.row_radial", &[("central", &names.central)]);
            let pull = generic.spring.as_ref();
            let right = radial + self.weight_toward(&self.phi) + pull.map_or(ZERO, |(f, out, _)| -(f * out));
            let central = page.unknown(&names.central, "m/s^2");
            page.equation(&self.m * &central, &right);
            page.say("pinned.row_across", &[("aside", &names.aside)]);
            let right = across + self.weight_across(&self.phi) + pull.map_or(ZERO, |(f, _, side)| f * side);
            let aside = page.unknown(&names.aside, "m/s^2");
            page.equation(&self.m * &aside, &right);
            circle = Some((central, aside));
        }
        if let (Some(s), Some((force, out, side))) = (&self.spring, &generic.spring) {
            let length = page.unknown(&names.length, "m");
            page.say(
                if pins { "pinned.spring_rows" } else { "pinned.spring_row" },
                &[("length", &names.length), ("out", &names.out), ("side", &names.side)],
            );
            page.equation(&length, s.length(self.up, &self.phi));
            page.equation(force, &s.k * (&length - &s.l0));
            page.equation(side, s.aside(self.up, &self.phi) / &length);
            if pins {
                let along = s.along(self.up, &self.phi) - &s.b;
                page.equation(out, along / length);
            }
        }
        let radius = page.tex(&self.h);
        let closed =
            [("radius", radius.as_str()), ("alpha", names.alpha.as_str()), ("omega", names.omega.as_str())];
        if let Some((central, aside)) = circle {
            page.say("pinned.closed_pins", &closed[..1]);
            page.equation(&central, &self.h * square(&omega));
            page.equation(&aside, &self.h * &alpha);
            page.say("pinned.order", &closed[1..]);
        } else {
            page.say("pinned.closed", &closed[..2]);
        }
    }

    fn equations(&self, draft: &mut Draft) -> PinnedResults {
        let names = &self.names;
        let pins = self.asks_pin(draft);
        let pendulum = draft.scene.is_pendulum();
        let mut page = SectionWriter::new(draft, "eom", "pinned.title_eom");
        self.rows(&mut page, pins);
        let ends = match page.draft.scene.end {
            End::TurningPoint(_) => Some("pinned.angle_turning"),
            End::Speed(..) => Some("pinned.angle_speed"),
            _ => None,
        };
        if let (Some(phrase), Expr::Symbol(angle)) = (ends, &self.phi1) {
            page.say(phrase, &[("omega", &names.omega)]);
            page.formula(page.with_value(*angle));
        }
        let at = self.told(&page, &self.phi1);
        page.say(if self.instant { "pinned.at_start" } else { "pinned.at" }, &[("angle", &at)]);
        let place = self.place(&mut page, false);
        let moments = self.moments(&place);
        let over = if moments.len() > 1 {
            let name = page.free(&["M_O", r"M_{\mathrm{O}}"]);
            Expr::Symbol(page.find(&name, "N m", sum(moments)))
        } else {
            sum(moments)
        };
        let alpha = page.find(&names.alpha, "rad/s^2", over / self.about);
        page.motion(self.label(Quantity::Alpha), alpha);

        let mut worked = PinnedResults { pendulum, omega: alpha, place, turned: None };
        worked.omega = self.integral(&mut page, &mut worked);
        let omega = worked.omega;
        page.motion(self.label(Quantity::Omega), omega);
        if pins {
            page.say("pinned.reactions", &[("angle", &at)]);
            let radial = page.find(&names.radial, "N", self.toward(square(omega), &worked.place));
            let across = page.find(&names.across, "N", self.aside(alpha.into(), &worked.place));
            self.told_pin(&mut page, radial, across);
            page.motion(self.label(Quantity::PinRadial), radial);
            page.motion(self.label(Quantity::PinTangential), across);
            if page.asks(Quantity::PinForce) {
                let whole = root(square(radial) + square(across));
                let force = page.find(&names.pin, "N", &whole);
                page.motion(self.label(Quantity::PinForce), force);
            }
        }
        self.others(&mut page, omega);
        page.done();
        worked
    }

    /// `\phi_1 = 30^\circ`; only the number where it is a constant 0.
    fn told(&self, page: &SectionWriter, angle: &Expr) -> String {
        match angle {
            Expr::Symbol(s) => page.with_value(*s),
            _ => format!(r"{} = 0", page.tex(&self.phi)),
        }
    }

    /// What the signs of the pin's force say.
    fn told_pin(&self, page: &mut SectionWriter, radial: SymbolId, across: SymbolId) {
        let (r, s) = (page.draft.symbols.value(radial), page.draft.symbols.value(across));
        let toward = if r > 0.0 { "pinned.pin_toward" } else { "pinned.pin_outward" };
        let aside = if s > 0.0 { "pinned.pin_with" } else { "pinned.pin_against" };
        let mut text = Vec::new();
        if r != 0.0 {
            text.push(page.draft.say(toward, &[("radial", &self.names.radial)]));
        }
        if s != 0.0 {
            text.push(page.draft.say(aside, &[("across", &self.names.across)]));
        }
        page.paragraph(&text);
    }

    /// The integral over the angle; the angular speed at the end.
    fn integral(&self, page: &mut SectionWriter, worked: &mut PinnedResults) -> SymbolId {
        let names = &self.names;
        if self.instant {
            page.say("pinned.instant", &[]);
            return page.find(&names.omega, "rad/s", magnitude_of(&self.w0, page.value(&self.w0)));
        }
        let (phi0, phi1, phi) = (page.tex(&self.phi0), page.tex(&self.phi1), page.tex(&self.phi));
        let (a, w) = (&names.alpha, &names.omega);
        let chain = format!(
            r"{a} = \frac{{\mathrm{{d}}{w}}}{{\mathrm{{d}}t}} = {w}\,\frac{{\mathrm{{d}}{w}}}{{\mathrm{{d}}{phi}}}"
        );
        page.say("pinned.integrate", &[("chain", &chain), ("alpha", a), ("phi", &phi)]);
        let w0 = page.tex(&self.w0);
        page.formula(format!(
            r"\int_{{{w0}}}^{{{w}}} {w}\,\mathrm{{d}}{w} = \int_{{{phi0}}}^{{{phi1}}} {a}\,\mathrm{{d}}{phi}"
        ));
        let mut parts = vec![IntegralTerm {
            name: "J_g",
            from: &self.m * &self.g * &self.h * self.sinking(&self.phi0, &self.phi1),
        }];
        if !self.couples.is_empty() {
            let turned = self.turned(page);
            worked.turned = Some(turned);
            parts.push(IntegralTerm { name: "J_M", from: self.couple() * turned });
        }
        if let Some(s) = &self.spring {
            let (length, force, side) = (&names.length, &names.spring, &names.side);
            let b = page.tex(&s.b);
            let chain = format!(r"\mathrm{{d}}{length} = -{b}\,{side}\,\mathrm{{d}}{phi}");
            let stretch = page.unknown(length, "m") - &s.l0;
            let law = page.tex(&(&s.k * stretch));
            let becomes = format!(r"{force}\,{b}\,{side}\,\mathrm{{d}}{phi} = -{law}\,\mathrm{{d}}{length}");
            page.say("pinned.spring_integral", &[("chain", &chain), ("becomes", &becomes)]);
            let first = page.find(&format!("{length}_0"), "m", s.length(self.up, &self.phi0));
            let last = self.length(page);
            let of = |l: SymbolId| l - &s.l0;
            let a = page.find(&format!("{}_0", names.stretch), "m", of(first));
            let b = page.find(&format!("{}_1", names.stretch), "m", of(last));
            let squares = square(a) - square(b);
            parts.push(IntegralTerm { name: "J_s", from: ratio(1, 2) * &s.k * squares });
        }
        parts.retain(|p| p.from != ZERO);
        let omega = page.unknown(w, "rad/s");
        let gained = square(omega) - square(&self.w0);
        let left = ratio(1, 2) * self.about * gained;
        page.say("pinned.integrated", &[]);
        page.equation(&left, sum(parts.iter().map(|p| p.from.clone())));
        let twice = self.collected(page, parts, self.about.into(), "J");
        if matches!(page.draft.scene.end, End::TurningPoint(_)) {
            page.say("pinned.at_rest", &[]);
            return page.quiet(w, "rad/s", &ZERO);
        }
        let inside = square(&self.w0) + twice;
        let omega = page.find(w, "rad/s", root(inside));
        if self.sense < 0.0 {
            page.say("pinned.magnitude", &[("omega", w)]);
        }
        omega
    }

    /// Twice the sum of the parts over an inertia; several parts each by itself first.
    fn collected(
        &self,
        page: &mut SectionWriter,
        parts: Vec<IntegralTerm>,
        inertia: Expr,
        total: &str,
    ) -> Expr {
        let sum_of = if parts.len() > 1 {
            let mut found = Vec::new();
            for part in parts {
                found.push(Expr::Symbol(page.find(part.name, "J", &part.from)));
            }
            let name = page.free(&[total, "Z"]);
            page.find(&name, "J", sum(found)).into()
        } else {
            sum(parts.into_iter().map(|p| p.from))
        };
        whole(2) * sum_of / inertia
    }

    /// The length of the spring at the end, which [`Self::place`] has found.
    fn length(&self, page: &mut SectionWriter) -> SymbolId {
        let Some(s) = &self.spring else { return self.about };
        page.quiet(&format!("{}_1", self.names.length), "m", s.length(self.up, &self.phi1))
    }

    /// The angle turned, in radians with its sign.
    fn turned(&self, page: &mut SectionWriter) -> SymbolId {
        let name = format!(r"\Delta {}", page.tex(&self.phi));
        page.say("pinned.radians", &[]);
        let pi = page.draft.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let half = page.draft.symbols.given(r"180^\circ", 180.0, "180", "", true);
        let angle = &self.phi1 - &self.phi0;
        page.find(&name, "rad", angle * pi / half)
    }

    /// Quantities that follow at once.
    fn others(&self, page: &mut SectionWriter, omega: SymbolId) {
        let asked = |page: &SectionWriter, q| page.asks(q);
        if asked(page, Quantity::V) {
            page.say("pinned.speed", &[]);
            let v = page.find(&self.names.speed, "m/s", &self.h * omega);
            page.motion(self.label(Quantity::V), v);
        }
        if asked(page, Quantity::KineticEnergy) {
            page.say("pinned.kinetic_pin", &[]);
            let name = page.free(&["T", "T_1", "E"]);
            let t = page.find(&name, "J", ratio(1, 2) * self.about * square(omega));
            page.motion(Label { quantity: Quantity::KineticEnergy, of: Owner::Scene }, t);
        }
        if asked(page, Quantity::RotationalFraction) {
            page.say("pinned.share", &[]);
            let name = page.free(&[r"\zeta", r"\zeta_r"]);
            let share = page.find(&name, "1", &self.own / self.about);
            let label = Label { quantity: Quantity::RotationalFraction, of: Owner::Scene };
            page.motion(label, share);
            let by_speeds = &self.own / (&self.m * square(&self.h) + &self.own);
            let share = page.quiet(&name, "1", &by_speeds);
            page.energy(label, share);
        }
        let geometry = page.draft.words.get("pinned.note_geometry").to_owned();
        if asked(page, Quantity::Phi) && !self.instant {
            let turned = self.turned(page);
            let size = magnitude_of(&turned.into(), page.draft.symbols.value(turned));
            let label = self.label(Quantity::Phi);
            let name = format!(r"\left|{}\right|", page.draft.symbols.tex(turned));
            let turned = page.quiet(&name, "rad", &size);
            page.draft.from_one_method(label, DerivedAnswer::Value(turned), &geometry);
        }
        if asked(page, Quantity::Rise) && !self.instant {
            page.say("pinned.rise", &[]);
            let rise = page.find(r"\Delta z", "m", -(&self.h * self.sinking(&self.phi0, &self.phi1)));
            page.draft.from_one_method(self.label(Quantity::Rise), DerivedAnswer::Value(rise), &geometry);
        }
    }
}

/// The magnitude of something whose value is known.
fn magnitude_of(e: &Expr, value: f64) -> Expr {
    if value < 0.0 { magnitude(e.clone()) } else { e.clone() }
}

// -- swings under the weight alone ----------------------------------------------------------------------------------------

/// The swing from its lowest place.
struct SwingSize {
    /// `kappa`: the sine of half the amplitude, above 1 where it goes over the top.
    kappa: SymbolId,
    /// Its complement `sqrt(1 - kappa^2)`; of a body that goes over the top `sqrt(kappa^2 - 1)`.
    complement: SymbolId,
}

impl PinnedBody {
    fn asks_swings(&self, draft: &Draft) -> bool {
        let all = [Quantity::Period, Quantity::PeriodSmall, Quantity::OmegaSmall, Quantity::OmegaMax];
        all.iter().any(|q| draft.asks(*q))
    }

    /// `1 - cos` of the angle from hanging: by how much the mass centre is above its lowest place, over `h`.
    fn above_lowest(&self) -> Expr {
        if self.up { ONE + cosine(&self.phi0) } else { ONE - cosine(&self.phi0) }
    }

    /// Half the angle from hanging at the start.
    fn half(&self, page: &mut SectionWriter) -> Expr {
        if !self.up {
            return &self.phi0 / whole(2);
        }
        let turn = page.draft.symbols.given(r"180^\circ", 180.0, "180", "", true);
        (turn - &self.phi0) / whole(2)
    }

    /// Periods and the greatest speed, from the first row of the equations.
    fn swings(&self, draft: &mut Draft) {
        if !self.asks_swings(draft) {
            return;
        }
        let mut page = SectionWriter::new(draft, "swings", "pinned.title_swings");
        let from_lowest = if self.up { "pinned.small_upright" } else { "pinned.small" };
        let phi = page.tex(&self.phi);
        page.say(from_lowest, &[("phi", &phi)]);
        let psi = page.free(&[r"\psi", r"\chi"]);
        let angle = if self.up { psi.clone() } else { phi.clone() };
        let stiffness = page.tex(&(&self.m * &self.g * &self.h));
        let about = page.draft.symbols.tex(self.about).to_owned();
        page.formula(format!(
            r"{about}\,\ddot{{{angle}}} = -{stiffness}\,\sin {angle} \quad \Rightarrow \quad {about}\,\ddot{{{angle}}} \approx -{stiffness}\,{angle}"
        ));
        page.say("pinned.small_law", &[]);
        let pulled = &self.m * &self.g * &self.h;
        let frequency = page.free(&[r"\Omega", r"\omega_s"]);
        let frequency = page.find(&frequency, "rad/s", root(pulled / self.about));
        page.motion(self.label(Quantity::OmegaSmall), frequency);
        if page.asks(Quantity::PeriodSmall) {
            let small = self.small_period(&mut page, frequency);
            page.motion(self.label(Quantity::PeriodSmall), small);
        }
        if page.asks(Quantity::OmegaMax) {
            page.say("pinned.fastest", &[("alpha", &self.names.alpha)]);
            let fall = whole(2) * &self.m * &self.g * &self.h * self.above_lowest();
            let inside = square(&self.w0) + fall / self.about;
            let name = page.free(&[r"\omega_{\mathrm{max}}", r"\omega_m"]);
            let fastest = page.find(&name, "rad/s", root(inside));
            page.motion(self.label(Quantity::OmegaMax), fastest);
        }
        if page.asks(Quantity::Period) {
            let shape = self.shape(&mut page, frequency);
            self.by_mean(&mut page, frequency, &shape);
        }
        page.done();
    }

    fn small_period(&self, page: &mut SectionWriter, frequency: SymbolId) -> SymbolId {
        let pi = page.draft.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = page.free(&[r"\tau_0", r"\tau_s"]);
        page.find(&name, "s", whole(2) * pi / frequency)
    }

    /// The sine of half the amplitude; above 1 where the body goes over the top.
    fn amplitude(&self, page: &mut SectionWriter, frequency: SymbolId) -> Expr {
        let half = self.half(page);
        let sine_half = if self.phi0 == ZERO && !self.up { ZERO } else { sine(half) };
        if self.w0 == ZERO {
            let value = page.value(&sine_half);
            return magnitude_of(&sine_half, value);
        }
        let share = &self.w0 / (whole(2) * frequency);
        root(square(&sine_half) + square(&share))
    }

    /// The modulus of the swing, with its steps.
    fn shape(&self, page: &mut SectionWriter, frequency: SymbolId) -> SwingSize {
        let half = self.half(page);
        let phi = page.tex(&self.phi);
        let kappa = page.free(&[r"\kappa", r"\lambda"]);
        let psi = page.free(&[r"\psi", r"\chi"]);
        let started = self.w0 != ZERO;
        let from = self.amplitude(page, frequency);
        let omega = &self.names.omega;
        let tex_frequency = page.draft.symbols.tex(frequency).to_owned();
        // The angle from hanging, in the formulas of the integral.
        let lowest = if self.up { page.free(&[r"\psi_h", r"\beta_h"]) } else { phi };
        page.say(
            if started { "pinned.period_speed_started" } else { "pinned.period_speed" },
            &[("omega", omega), ("kappa", &kappa)],
        );
        page.formula(format!(
            r"{omega} = 2\,{tex_frequency}\,\sqrt{{{kappa}^{{2}} - \left(\sin \frac{{{lowest}}}{{2}}\right)^{{2}}}}"
        ));
        let kappa = page.find(&kappa, "1", &from);
        let over = page.draft.symbols.value(kappa) > 1.0;
        let (kappa_tex, value) = (page.draft.symbols.tex(kappa).to_owned(), Expr::from(kappa));
        let name = page.free(&[r"\kappa_c", r"\lambda_c"]);
        if over {
            page.say("pinned.period_over", &[("kappa", &kappa_tex)]);
            let complement = page.find(&name, "1", root(square(value) - ONE));
            return SwingSize { kappa, complement };
        }
        page.say(
            "pinned.period_integral",
            &[
                ("omega", omega),
                ("angle", &lowest),
                ("substitution", &format!(r"\sin \frac{{{lowest}}}{{2}} = {kappa_tex}\,\sin {psi}")),
            ],
        );
        let tau = page.free(&[r"\tau", r"\tau_1"]);
        page.formula(format!(
            r"\frac{{{tau}}}{{4}} = \int_{{0}}^{{\frac{{\pi}}{{2}}}} \frac{{\mathrm{{d}}{psi}}}{{{tex_frequency}\,\sqrt{{1 - {kappa_tex}^{{2}}\,\left(\sin {psi}\right)^{{2}}}}}}"
        ));
        let cosine_half = if self.phi0 == ZERO && !self.up { ONE } else { cosine(half.clone()) };
        let from = if started {
            root(ONE - square(value))
        } else {
            let value = page.value(&cosine_half);
            magnitude_of(&cosine_half, value)
        };
        page.say("pinned.period_complement", &[("kappa", &kappa_tex)]);
        let complement = page.find(&name, "1", &from);
        SwingSize { kappa, complement }
    }

    /// The period by the arithmetic-geometric mean, with its steps as a table.
    fn by_mean(&self, page: &mut SectionWriter, frequency: SymbolId, shape: &SwingSize) {
        let (kappa, complement) =
            (page.draft.symbols.value(shape.kappa), page.draft.symbols.value(shape.complement));
        let over = kappa > 1.0;
        let (mut a, mut b) = (if over { kappa } else { 1.0 }, complement);
        let first = if over { page.draft.symbols.tex(shape.kappa).to_owned() } else { "1".to_owned() };
        let second = page.draft.symbols.tex(shape.complement).to_owned();
        page.say("pinned.mean", &[("first", &first), ("second", &second)]);
        page.formula(r"a_{n+1} = \frac{a_n + b_n}{2}, \quad b_{n+1} = \sqrt{a_n\,b_n}");
        let mut rows = vec![vec!["$n$".to_owned(), "$a_n$".to_owned(), "$b_n$".to_owned()]];
        for n in 0..12 {
            let cell = |x: f64| format!("${}$", tex_digits(&shown::significant(x, 8), page.draft.words));
            rows.push(vec![format!("${n}$"), cell(a), cell(b)]);
            if (a - b).abs() <= 1e-8 * a {
                break;
            }
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        for _ in 0..6 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        page.table(rows);
        let name = page.free(&[r"\mu", r"\nu"]);
        let mean = page.draft.symbols.found(&name, a, "");
        page.say("pinned.mean_found", &[]);
        page.formula(page.with_value(mean));
        page.say(if over { "pinned.mean_over" } else { "pinned.mean_quarter" }, &[("mean", &name)]);
        let pi = page.draft.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = page.free(&[r"\tau", r"\tau_1"]);
        let turns = if over { pi.into() } else { whole(2) * pi };
        let period = page.find(&name, "s", turns / (frequency * mean));
        page.motion(self.label(Quantity::Period), period);
    }

    /// The same from energies: the pendulum of equal period, the fall to the lowest place, the mean slowness of the swing.
    fn swings_by_energy(&self, draft: &mut Draft) {
        if !self.asks_swings(draft) {
            return;
        }
        let mut page = SectionWriter::new(draft, "swings-energy", "pinned.title_swings_energy");
        let turning = &self.m * square(&self.h) + &self.own;
        page.say("pinned.small_energy", &[]);
        let name = page.free(&[r"\ell", r"\ell_r"]);
        let length = page.find(&name, "m", &turning / (&self.m * &self.h));
        let name = page.free(&[r"\Omega", r"\omega_s"]);
        let frequency = page.find(&name, "rad/s", root(&self.g / length));
        page.energy(self.label(Quantity::OmegaSmall), frequency);
        if page.asks(Quantity::PeriodSmall) {
            let small = self.small_period(&mut page, frequency);
            page.energy(self.label(Quantity::PeriodSmall), small);
        }
        if page.asks(Quantity::OmegaMax) {
            page.say("pinned.fastest_energy", &[]);
            let name = page.free(&["z_0", "z_m"]);
            let fall = page.find(&name, "m", &self.h * self.above_lowest());
            let gained = whole(2) * &self.m * &self.g * fall;
            let inside = square(&self.w0) + gained / turning;
            let name = page.free(&[r"\omega_{\mathrm{max}}", r"\omega_m"]);
            let fastest = page.find(&name, "rad/s", root(inside));
            page.energy(self.label(Quantity::OmegaMax), fastest);
        }
        if page.asks(Quantity::Period) {
            self.period_by_mean_value(&mut page, frequency);
        }
        page.done();
    }

    /// The period as that of small swings times a mean value over the swing.
    fn period_by_mean_value(&self, page: &mut SectionWriter, frequency: SymbolId) {
        let from = self.amplitude(page, frequency);
        let kappa = page.value(&from);
        let over = kappa > 1.0;
        let name = page.free(&["q", "q_1"]);
        let psi = page.free(&[r"\psi", r"\chi"]);
        page.say(if over { "pinned.mean_value_over" } else { "pinned.mean_value" }, &[("psi", &psi)]);
        // Of a body that goes over the top the amplitude is half the angle, and the modulus 1 / kappa.
        let q = page.find(&name, "1", &if over { ONE / from } else { from });
        let modulus = page.draft.symbols.value(q);
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
            let digits = shown::significant(value, 8);
            let shown = tex_digits(&digits, page.draft.words);
            let angle = tex_digits(&shown::significant(angle, FIGURES), page.draft.words);
            rows.push(vec![format!(r"${angle}^\circ$"), format!("${shown}$")]);
            // A number that is its own name.
            values.push(Expr::Symbol(page.draft.symbols.given(&shown, value, &digits, "", false)));
        }
        let count = points.to_string();
        page.say("pinned.mean_value_sum", &[("count", &count)]);
        let name = page.free(&[r"\eta", r"\xi"]);
        let parts = whole(i64::from(points));
        let mean = if points <= 12 {
            page.table(rows);
            let total = page.free(&["Z", "Z_1"]);
            let total = page.find(&total, "1", sum(values));
            page.find(&name, "1", total / parts)
        } else {
            let mean = page.quiet(&name, "1", sum(values) / parts);
            page.formula(page.with_value(mean));
            mean
        };
        page.say("pinned.mean_value_found", &[]);
        let pi = page.draft.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let name = page.free(&[r"\tau", r"\tau_1"]);
        let from = if over { pi * mean * q / frequency } else { whole(2) * pi * mean / frequency };
        let period = page.find(&name, "s", &from);
        page.energy(self.label(Quantity::Period), period);
    }

    // -- the method of work and energy --------------------------------------------------------------------------------------

    fn balance(&self, draft: &mut Draft, worked: &PinnedResults) {
        let names = &self.names;
        let mut page = SectionWriter::new(draft, "energy", "pinned.title_energy");
        let turning = &self.m * square(&self.h) + &self.own;
        let (first, last) = (self.told(&page, &self.phi0), self.told(&page, &self.phi1));
        let scene = Owner::Scene;
        let omega;
        if self.instant {
            page.say("pinned.states_instant", &[("angle", &first)]);
            omega = page.quiet(&names.omega, "rad/s", magnitude_of(&self.w0, page.value(&self.w0)));
        } else {
            page.say("pinned.states", &[("first", &first), ("last", &last)]);
            let height = -(&self.h * self.sinking(&self.phi0, &self.phi1));
            page.say("pinned.height", &[]);
            let height = page.find(r"\Delta z", "m", &height);
            let sinks = page.draft.symbols.value(height) < 0.0;
            let size = page.rough(page.draft.symbols.value(height).abs(), "m");
            page.say(if sinks { "pinned.sinks" } else { "pinned.rises" }, &[("size", &size)]);
            let weight = -(&self.m * &self.g * height);
            let mut works = vec![Expr::Symbol(page.find("W_g", "J", &weight))];
            page.say("pinned.work_pin", &[]);
            if let Some(turned) = worked.turned {
                page.say("pinned.work_couple", &[("angle", &page.with_value(turned))]);
                let work = self.couple() * turned;
                works.push(page.find("W_M", "J", &work).into());
            }
            if let Some(s) = &self.spring {
                page.say("pinned.work_spring", &[]);
                let length = &names.length;
                let a = page.find(&format!("{length}_0"), "m", s.length_by_places(self.up, &self.phi0));
                let b = page.find(&format!("{length}_1"), "m", s.length_by_places(self.up, &self.phi1));
                let stored = |l: SymbolId| square(l - &s.l0);
                let work = ratio(1, 2) * &s.k * (stored(a) - stored(b));
                works.push(page.find("W_s", "J", &work).into());
            }
            let kinetic = page.free(&["T", "E"]);
            let (t0, t1) = (format!("{kinetic}_0"), format!("{kinetic}_1"));
            let started = self.w0 != ZERO;
            page.say(
                if started { "pinned.kinetic_both_started" } else { "pinned.kinetic_both" },
                &[("speed", &format!("{} = {}\\,{}", names.speed, page.tex(&self.h), names.omega))],
            );
            let w = page.unknown(&names.omega, "rad/s");
            let v = page.unknown(&names.speed, "m/s");
            let halves = |rate: &Expr, inertia: &Expr| ratio(1, 2) * inertia * square(rate);
            let mut energy = halves(&v, &self.m).symbols(&page.draft.symbols);
            if self.own != ZERO {
                energy.push_str(" + ");
                energy.push_str(&halves(&w, &self.own).symbols(&page.draft.symbols));
            }
            let product_form = page.tex(&(ratio(1, 2) * &turning * square(w)));
            page.formula(format!("{t1} = {energy} = {product_form}"));
            let mut start = ZERO;
            if started {
                let from = ratio(1, 2) * &turning * square(&self.w0);
                start = page.find(&t0, "J", &from).into();
            }
            let mut left = works.clone();
            left.insert(0, start.clone());
            let total = sum(left);
            let t1_symbol = page.unknown(&t1, "J");
            page.say("pinned.balance", &[]);
            page.equation(&total, &t1_symbol);
            let t1_found = if matches!(total, Expr::Sum(_)) {
                page.find(&t1, "J", &total)
            } else {
                page.quiet(&t1, "J", &total)
            };
            let over = if matches!(total, Expr::Sum(_)) { t1_found.into() } else { total };
            omega = if matches!(page.draft.scene.end, End::TurningPoint(_)) {
                page.say("pinned.at_rest_energy", &[]);
                page.quiet(&names.omega, "rad/s", &ZERO)
            } else {
                page.find(&names.omega, "rad/s", root(whole(2) * over / &turning))
            };
        }
        page.energy(self.label(Quantity::Omega), omega);
        if page.asks(Quantity::KineticEnergy) {
            let name = page.free(&["T", "E"]);
            let moving = ratio(1, 2) * &self.m * square(&self.h * omega);
            let spinning = ratio(1, 2) * &self.own * square(omega);
            let energy = page.find(&name, "J", moving + spinning);
            page.energy(Label { quantity: Quantity::KineticEnergy, of: scene }, energy);
        }
        self.rate(&mut page, worked, &turning, omega);
        page.picture("energy");
        if page.asks(Quantity::IO) {
            page.say("pinned.inertia_energy", &[]);
            let name = page.free(&["I_O", "J_O"]);
            let about = page.find(&name, "kg m^2", &turning);
            page.energy(self.label(Quantity::IO), about);
        }
        page.done();
    }

    /// Angular acceleration from the rate of the balance; forces of the pin from the central acceleration and from moments
    /// about the mass centre.
    fn rate(&self, page: &mut SectionWriter, worked: &PinnedResults, turning: &Expr, omega: SymbolId) {
        let names = &self.names;
        let needs =
            page.asks(Quantity::Alpha) || self.asks_pin(page.draft) || page.asks(Quantity::SpringForce);
        if page.asks(Quantity::V) {
            let v = page.find(&names.speed, "m/s", &self.h * omega);
            page.energy(self.label(Quantity::V), v);
        }
        if !needs {
            return;
        }
        let phi = page.tex(&self.phi);
        let last = self.told(page, &self.phi1);
        let alpha = page.unknown(&names.alpha, "rad/s^2");
        let slope_z = format!("z_{{{phi}}}");
        let slope_s = format!("{}_{{{phi}}}", names.length);
        page.say("pinned.rate", &[("omega", &names.omega), ("phi", &phi)]);
        let z = page.unknown(&slope_z, "m");
        let mut powers = vec![-(&self.m * &self.g * z)];
        powers.extend(self.couples.iter().cloned());
        if self.spring.is_some() {
            let force = page.unknown(&names.spring, "N");
            let s = page.unknown(&slope_s, "m");
            powers.push(-(force * s));
        }
        page.equation(turning * alpha, sum(powers));
        page.say("pinned.slopes", &[("angle", &last)]);
        let sinking = signed(&self.h * sine(&self.phi1), self.up);
        let z = page.find(&slope_z, "m", -sinking);
        let mut powers = vec![-(&self.m * &self.g * z)];
        powers.extend(self.couples.iter().cloned());
        let mut place = SpringPlace { phi: self.phi1.clone(), spring: None };
        if let (Some(s), Some((_, out, _))) = (&self.spring, &worked.place.spring) {
            let length =
                page.quiet(&format!("{}_1", names.length), "m", s.length_by_places(self.up, &self.phi1));
            let force = page.find(&names.spring, "N", &s.k * (length - &s.l0));
            page.energy(self.label(Quantity::SpringForce), force);
            let longer = -(&s.b * s.aside(self.up, &self.phi1) / length);
            let slope = page.find(&slope_s, "m", &longer);
            powers.push(-(force * slope));
            let side = page.quiet(&names.side, "1", -(slope / &s.b));
            place.spring = Some((force.into(), out.clone(), side.into()));
        }
        let over = if powers.len() > 1 {
            let name = format!("W_{{{phi}}}");
            Expr::Symbol(page.find(&name, "J", sum(powers)))
        } else {
            sum(powers)
        };
        let alpha = page.find(&names.alpha, "rad/s^2", over / turning);
        page.energy(self.label(Quantity::Alpha), alpha);
        if !self.asks_pin(page.draft) {
            return;
        }
        page.say("pinned.pin_energy", &[("speed", &names.speed)]);
        let speed = page.find(&names.speed, "m/s", &self.h * omega);
        let kept = &self.m * square(speed) / &self.h;
        let pull = place.spring.as_ref().map_or(ZERO, |(f, out, _)| f * out);
        let radial = page.find(&names.radial, "N", kept - self.weight_toward(&self.phi1) + pull);
        page.energy(self.label(Quantity::PinRadial), radial);
        // Moments about the mass centre.
        page.say("pinned.pin_moment", &[("across", &names.across)]);
        let mut about: Vec<Expr> = self.couples.clone();
        if let (Some(s), Some((force, _, side))) = (&self.spring, &place.spring) {
            let lever = &s.b - &self.h;
            about.push(force * lever * side);
        }
        if about.len() > 1 {
            let name = page.free(&["M_G", r"M_{\mathrm{G}}"]);
            about = vec![page.find(&name, "N m", sum(about)).into()];
        }
        about.push(-(&self.own * alpha));
        let across = page.find(&names.across, "N", sum(about) / &self.h);
        page.energy(self.label(Quantity::PinTangential), across);
        if page.asks(Quantity::PinForce) {
            let force = page.find(&names.pin, "N", root(square(radial) + square(across)));
            page.energy(self.label(Quantity::PinForce), force);
        }
    }
}

/// Natural logarithm.
fn natural_log(x: f64) -> f64 {
    trig::log10(x) / trig::log10(std::f64::consts::E)
}

// -- what was assumed, and what suggests itself ---------------------------------------------------------------------------

impl PinnedBody {
    /// Does it get there, and which way?
    fn regime(&self, draft: &mut Draft, worked: &PinnedResults) {
        let (first, last) = (self.phi0.value(&draft.symbols), self.phi1.value(&draft.symbols));
        let way = (last - first).abs();
        let mut page = SectionWriter::new(draft, "regime", "pinned.title_regime");
        if self.instant {
            self.direction(&mut page);
            return;
        }
        let start = self.told(&page, &self.phi0);
        let end = self.told(&page, &self.phi1);
        let growing = if self.sense > 0.0 { "pinned.growing" } else { "pinned.falling" };
        let sense = page.draft.words.get(growing).to_owned();
        let drive = self.moment_at(page.draft, first);
        if self.w0 == ZERO {
            let moment = page.rough(drive, "N m");
            page.say("pinned.sets_off", &[("angle", &start), ("moment", &moment), ("sense", &sense)]);
        } else {
            page.say("pinned.goes_on", &[("angle", &start), ("sense", &sense)]);
        }
        // How often the moment changes its sense on the way.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
        let steps = (way / LOOK).ceil().clamp(1.0, 4000.0) as u32;
        let at = |i: u32| first + (last - first) * f64::from(i) / f64::from(steps);
        let drives = |i: u32| self.moment_at(page.draft, at(i)) * self.sense;
        let sizes = (0..=steps).map(|i| drives(i).abs()).fold(0.0, f64::max);
        let helps = (0..=steps).all(|i| drives(i) >= -1e-12 * sizes);
        let turns = (1..=steps).filter(|i| drives(*i - 1) * drives(*i) < 0.0).count();
        let square = self.square_at(page.draft, last);
        let angle = [("angle", end.as_str()), ("omega", self.names.omega.as_str())];
        if matches!(page.draft.scene.end, End::TurningPoint(_)) {
            page.say("pinned.turns_there", &angle);
        } else if helps {
            page.say("pinned.only_faster", &angle);
        } else if turns <= 1 && drives(0) >= 0.0 && square > 0.0 {
            page.say("pinned.brakes_late", &angle);
        } else {
            let least = (1..=steps).map(|i| self.square_at(page.draft, at(i))).fold(f64::INFINITY, f64::min);
            let least = page.rough(least, "rad^2/s^2");
            page.say("pinned.never_rests", &[angle[0], angle[1], ("least", &least)]);
        }
        if worked.pendulum && self.w0 == ZERO && !self.up {
            let phi = page.tex(&self.phi);
            page.say("pinned.stays", &[("phi", &phi), ("angle", &start)]);
        }
        page.picture("graph-swing");
        self.direction(&mut page);
        page.done();
    }

    /// The direction as a word, if it is asked.
    fn direction(&self, page: &mut SectionWriter) {
        let word = if self.sense > 0.0 { Word::Forward } else { Word::Back };
        let label = self.label(Quantity::Direction);
        page.draft.from_motion(label, DerivedAnswer::Word(word));
        page.draft.from_energy(label, DerivedAnswer::Word(word));
    }
}
