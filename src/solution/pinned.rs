//! A body on a fixed pin: its terms, the speed from energies, the force of the pin from the equations of motion, the periods of a
//! pendulum. The velocity ratios vary with the angle, so its rows are written here and told with the words of all solutions.
use crate::num::{gauss, shown, trig};
use crate::scene::{Arm, End, Label, Owner, Pin, Quantity, Rest, RotaryInertia, Start, Zero};
use crate::solution::account::of_scene;
use crate::solution::draft::{DerivedAnswer, Draft, tex_of};
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, arc_cosine, cosine, in_sense, magnitude, number as whole, positive_first,
    ratio, root, signed, sine, square, sum,
};
use crate::solution::factors::Factors;
use crate::solution::page::{Page, aligned, packed};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solution::terms;
use crate::solution::text::{Block, LINE};
use crate::solution::written::width;
use crate::solve::outcome::Word;

/// Step in degrees in which an angle is looked for at which something happens.
const LOOK: f64 = 0.25;
/// The farthest way that is looked over, degrees.
const FAR: f64 = 720.0;

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

/// Force of a spring, and the components of its direction outward and across.
type Pull = Option<(Expr, Expr, Expr)>;

/// Writes the sections of a pinned body.
///
/// # Errors
/// What this does not cover.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    let Some((body, pin)) = draft.scene.pinned() else {
        return Err(Beyond::Unfound.into());
    };
    let pin = *pin;
    let ended = [
        (Quantity::Omega, Owner::Body(body)),
        (Quantity::V, Owner::Body(body)),
        (Quantity::KineticEnergy, Owner::Scene),
    ];
    if !ended
        .iter()
        .any(|(quantity, of)| draft.variant.solved.get(Label { quantity: *quantity, of: *of }).is_some())
    {
        return Err(Beyond::Unfound.into());
    }
    let mut page = Page::new(draft);
    let swing = read(&mut page, body, &pin)?;
    swing.energy(&mut page);
    let omega = swing.omega(&mut page);
    swing.rows(&mut page);
    swing.forces(&mut page, omega);
    swing.swings(&mut page);
    swing.rest(&mut page, omega);
    swing.regime(&mut page);
    swing.limits(&mut page, omega);
    page.begin("onward");
    // A spring that is stretched further holds it back.
    let stretch = |tex: &str| page.symbols.named(tex).map_or(0.0, |s| page.symbols.value(s).abs());
    let braked = stretch(r"\delta_1") > stretch(r"\delta_0");
    let name = if braked { "pinned.onward_spring" } else { "pinned.onward" };
    swing.say(&mut page, name, &[]);
    page.end();
    Ok(())
}

impl PinnedSpring {
    /// Its data; where the stretch at the start is given, that stands for the natural length.
    fn new(draft: &mut Draft, pin: &Pin) -> Option<Self> {
        let s = pin.spring.as_ref()?;
        Some(Self {
            b: draft.number(s.at_m, "b", "m"),
            x: draft.number(s.x_m, "x_A", "m"),
            y: draft.number(s.y_m, "y_A", "m"),
            k: draft.number(s.stiffness_n_m, "k_s", "N/m"),
            l0: match s.rest {
                Rest::Length(l) => draft.number(l, "l_0", "m"),
                Rest::Stretch(stretch) => draft.number(stretch, r"\delta_0", "m"),
            },
        })
    }
}

/// Idea, sketch, and the quantities that everything else needs.
fn read(page: &mut Page, body: usize, pin: &Pin) -> Result<PinnedBody, DerivationStop> {
    let scene = page.scene;
    let draft = &mut *page.draft;
    let angle = draft.free(&[r"\phi", r"\varphi", r"\theta", r"\beta"]);
    let (zero, one) = (format!("{angle}_0"), format!("{angle}_1"));
    let phi0 = draft.number(pin.start_deg, &zero, "deg");
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
    let g = terms::gravity(draft);
    let m = terms::mass(draft, &scene.bodies[body], &g, "");
    let h = match pin.arm {
        Arm::Distance(h) => draft.number(h, "h", "m"),
        Arm::HalfOf(l) => draft.number(l, "L", "m") / whole(2),
    };
    let own = match &scene.bodies[body].inertia {
        Some(RotaryInertia::Gyration(k)) => {
            m.times(&Factors::of(&draft.number(*k, "k", "m")).squared()).expr()
        }
        _ => sum(terms::inertia(draft, &scene.bodies[body], &m, &g, "").iter().map(Factors::expr)),
    };
    let spring = PinnedSpring::new(draft, pin);
    page.begin("idea");
    let place = match scene.end {
        End::AtOnce => "pinned.idea_instant",
        End::Angle(..) => "pinned.idea",
        _ => "pinned.idea_speed",
    };
    page.say(place, &[]);
    if scene.end != End::AtOnce {
        page.say("pinned.idea_pin", &[]);
    }
    page.begin("sketch");
    let name = format!("forces-{}", scene.bodies[body].name);
    page.out.blocks = vec![Block::Picture("scene".to_owned()), Block::Picture(name)];
    page.begin_as("short", "short_energy");
    page.say(if own == ZERO { "pinned.inertia_point" } else { "pinned.inertia" }, &[]);
    let steiner = &own + &m.expr() * square(&h);
    let about = page.find(&["I_O", "J_O"], "kg m^2", steiner.clone());
    let short = Factors::of(&own).plus(&m.times(&Factors::of(&h).squared())).expr();
    let mut line = page.chain(about, &steiner).concat();
    if !line.contains('&')
        && !matches!(short, Expr::Sum(_))
        && short != steiner
        && width(&line) < LINE - 20.0
        && own != ZERO
    {
        let tex = page.symbols.tex(about).to_owned();
        line = line.replacen(" = ", &format!(" = {} = ", page.tex(&short)), 1);
        line = format!("{tex}{}", &line[tex.len()..]);
    }
    page.skip_new();
    page.formula(if line.contains('&') { aligned(&line) } else { line });
    page.answer(Label { quantity: Quantity::IO, of: Owner::Body(body) }, DerivedAnswer::Value(about));
    let mut swing = PinnedBody {
        body,
        up: pin.from == Zero::Upright,
        m: m.expr(),
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
    };
    if let Some(Rest::Stretch(_)) = pin.spring.as_ref().map(|s| s.rest) {
        swing.natural_length(page);
    }
    let spin = swing.w0.value(&page.symbols);
    let drive = swing.moment_at(page.draft, swing.phi0.value(&page.symbols));
    swing.sense = if spin != 0.0 { spin.signum() } else { drive.signum() };
    swing.phi1 = match scene.end {
        End::AtOnce => swing.phi0.clone(),
        End::Angle(_, angle) => page.number(angle, &one, "deg"),
        End::TurningPoint(_) => swing.angle_of_speed(page.draft, &one, 0.0)?,
        End::Speed(_, w) => {
            let w = page.datum(w);
            swing.angle_of_speed(page.draft, &one, w)?
        }
        _ => {
            return Err(Beyond::Unfound.into());
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

    /// Anchor as seen from the pin, along the body outward.
    fn along(&self, up: bool, phi: &Expr) -> Expr {
        &self.x * sine(phi) + signed(&self.y * cosine(phi), up)
    }

    /// Anchor as seen from the pin, across the body, with growing angle.
    fn aside(&self, up: bool, phi: &Expr) -> Expr {
        &self.x * cosine(phi) - signed(&self.y * sine(phi), up)
    }
}

impl PinnedBody {
    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    fn say(&self, page: &mut Page, name: &str, pieces: &[(&str, &str)]) {
        page.say(name, pieces);
    }

    fn answer(&self, page: &mut Page, quantity: Quantity, symbol: SymbolId) {
        page.answer(self.label(quantity), DerivedAnswer::Value(symbol));
    }

    /// The natural length is what is left of the length at the start without the stretch there.
    fn natural_length(&mut self, page: &mut Page) {
        let length = self.spring.as_ref().map(|s| (s.length(self.up, &self.phi0), s.l0.clone()));
        let Some((length, stretch)) = length else { return };
        page.say("pinned.natural", &[]);
        let first = page.find(&["s_0", "d_0"], "m", length);
        let l0 = page.find(&["l_0", "l_n"], "m", first - stretch);
        page.tell_new();
        if let Some(s) = &mut self.spring {
            s.l0 = l0.into();
        }
    }

    /// `cos phi0 - cos phi1` from upright, `cos phi1 - cos phi0` from hanging: what the mass centre sinks by, over `h`.
    fn sinking(&self) -> Expr {
        let (from, to) = (&self.phi0, &self.phi1);
        if self.up { cosine(from) - cosine(to) } else { cosine(to) - cosine(from) }
    }

    /// What the couples add up to.
    fn couple(&self) -> Expr {
        sum(self.couples.iter().cloned())
    }

    /// The weight times a function of the angle, positive as it counts from upright.
    fn weight(&self, wave: Expr, arm: &Expr) -> Expr {
        let size = Factors::of(&self.m)
            .times(&Factors::of(&self.g))
            .times(&Factors::of(arm))
            .times(&Factors::of(&wave));
        signed(size.expr(), self.up)
    }

    /// Moments about the pin with growing angle, the forces toward the pin but its own, and those across.
    fn rows_at(&self, phi: &Expr, pull: &Pull) -> [Expr; 3] {
        let mut moments = vec![self.weight(sine(phi), &self.h)];
        moments.extend(self.couples.iter().cloned());
        let mut toward = vec![self.weight(cosine(phi), &ONE)];
        let mut across = vec![self.weight(sine(phi), &ONE)];
        if let (Some(s), Some((force, out, side))) = (&self.spring, pull) {
            moments.push(force * &s.b * side);
            toward.push(-(force * out));
            across.push(force * side);
        }
        [moments, toward, across].map(|terms| sum(terms.into_iter().filter(|t| *t != ZERO)))
    }

    /// The balance from the start to the end, and the speed that follows.
    fn energy(&self, page: &mut Page) {
        if self.instant {
            return;
        }
        let ends = match page.scene.end {
            End::TurningPoint(_) => Some("pinned.angle_turning"),
            End::Speed(..) => Some("pinned.angle_speed"),
            _ => None,
        };
        if let (Some(phrase), Expr::Symbol(angle)) = (ends, &self.phi1) {
            let shown = page.shown(*angle);
            self.say(page, phrase, &[("angle", &shown)]);
        }
        let fall = Factors::of(&self.m)
            .times(&Factors::of(&self.g))
            .times(&Factors::of(&self.h))
            .times(&Factors::of(&self.sinking()));
        let mut works = vec![fall.expr()];
        if !self.couples.is_empty() {
            let turned = self.turned(page);
            self.say(page, "pinned.radians", &[]);
            page.tell_new();
            works.push(self.couple() * turned);
        }
        if let Some(s) = &self.spring {
            self.say(page, "pinned.lengths", &[]);
            let known = page.symbols.named("s_0");
            let first = match known {
                Some(symbol) => symbol,
                None => page.find(&["s_0", "d_0"], "m", s.length(self.up, &self.phi0)),
            };
            let last = page.find(&["s_1", "d_1"], "m", s.length(self.up, &self.phi1));
            let (a, b) = (first - &s.l0, last - &s.l0);
            let d0 = page.find(&[r"\delta_0", "e_0"], "m", a);
            let d1 = page.find(&[r"\delta_1", "e_1"], "m", b);
            page.tell_new();
            works.push(ratio(1, 2) * &s.k * (square(d0) - square(d1)));
        }
        works.retain(|w| *w != ZERO);
        let omega = page.free(&[r"\omega", r"\omega_1"]);
        let omega = page.unknown(&omega, "rad/s");
        let gained = if self.w0 == ZERO { square(omega) } else { square(omega) - square(&self.w0) };
        let name = if self.w0 == ZERO { "from_rest" } else { "moving" };
        page.say(&format!("energy.{name}"), &[]);
        let (left, right) = (positive_first(works.clone()), ratio(1, 2) * self.about * gained);
        let line = format!("{} = {}", page.tex(&left), page.tex(&right));
        page.formula(line);
        let twice = match works.as_slice() {
            [one] => Factors::of(&(whole(2) * one)).per(&Factors::of(&self.about.into())).expr(),
            _ => {
                let two = Factors::of(&whole(2));
                let doubled = works.iter().map(|w| Factors::of(w).times(&two).expr()).collect();
                positive_first(doubled) / self.about
            }
        };
        let from = if matches!(page.scene.end, End::TurningPoint(_)) {
            ZERO
        } else {
            root(square(&self.w0) + twice)
        };
        page.step(omega, from.clone());
        page.display(omega, &from, r" \quad (\mathrm{E})");
        if self.sense < 0.0 {
            let name = page.names(&[omega]);
            self.say(page, "pinned.magnitude", &[("omega", &name)]);
        }
        self.answer(page, Quantity::Omega, omega);
        page.skip_new();
    }

    /// The angular speed at the end.
    fn omega(&self, page: &mut Page) -> SymbolId {
        let found = page.found_for(self.label(Quantity::Omega));
        if let Some(DerivedAnswer::Value(omega)) = found {
            return omega;
        }
        let size = magnitude_of(&self.w0, page.value(&self.w0));
        let omega = page.find(&[r"\omega", r"\omega_1"], "rad/s", size);
        page.tell_new();
        self.answer(page, Quantity::Omega, omega);
        omega
    }

    /// The rows, what they have in common with (E), and which way is shorter.
    fn rows(&self, page: &mut Page) {
        page.begin_as(
            if self.instant { "short" } else { "long" },
            if self.instant { "short_motion" } else { "long_motion" },
        );
        let from = if self.up { "pinned.from_upright" } else { "pinned.from_hanging" };
        let name = |page: &Page, names: &[&str]| page.free(names);
        let (radial, across) = (name(page, &["R", "O_r"]), name(page, &["S", "O_t"]));
        let angle = page.tex(&self.phi);
        self.say(
            page,
            from,
            &[
                ("phi", &format!("${angle}$")),
                ("radial", &format!("${radial}$")),
                ("across", &format!("${across}$")),
            ],
        );
        let (alpha, omega) = (name(page, &[r"\alpha", r"\alpha_1"]), name(page, &[r"\omega", r"\omega_1"]));
        let mut generic = |tex: &[&str]| {
            let tex = page.free(tex);
            Expr::Symbol(page.unknown(&tex, "1"))
        };
        let pull: Pull = self.spring.as_ref().map(|_| {
            (generic(&["F_s", r"F_{\mathrm{s}}"]), generic(&["n_r", "c_r"]), generic(&["n_t", "c_t"]))
        });
        let [moments, toward, aside] = self.rows_at(&self.phi, &pull);
        let with = |page: &Page, own: &str, rest: &Expr| {
            let rest = page.tex(rest);
            match rest.strip_prefix('-') {
                Some(rest) => format!("{own} - {rest}"),
                None => format!("{own} + {rest}"),
            }
        };
        let mh = page.tex(&Factors::of(&self.m).times(&Factors::of(&self.h)).expr());
        let rows = [
            format!(r"{} = {}\,{alpha} \quad (1)", page.tex(&moments), page.symbols.tex(self.about)),
            format!(r"{} = {mh}\,{omega}^{{2}} \quad (2)", with(page, &radial, &toward)),
            format!(r"{} = {mh}\,{alpha} \quad (3)", with(page, &across, &aside)),
        ];
        for line in packed(rows) {
            page.formula(line);
        }
        if self.spring.is_some() {
            self.say(page, "pinned.spring_rows", &[]);
        }
        if self.instant {
            return;
        }
        let pieces = [("alpha", &*alpha), ("omega", &*omega), ("phi", &*angle)];
        self.say(page, "pinned.integral", &pieces);
        page.begin("why");
        let (many, few) = (format!("${radial}$, ${across}$, ${alpha}$, ${omega}$"), format!("${omega}$"));
        self.say(
            page,
            "pinned.why",
            &[("many", &many), ("few", &few), ("alpha", &alpha), ("radial", &radial), ("across", &across)],
        );
        page.say("why.ask", &[]);
    }

    /// Force and direction of the spring at the end.
    fn pull(&self, page: &mut Page) -> Pull {
        let s = self.spring.as_ref()?;
        let length = match page.symbols.named("s_1").or_else(|| page.symbols.named("d_1")) {
            Some(symbol) => symbol,
            None => page.find(&["s_1", "d_1"], "m", s.length(self.up, &self.phi1)),
        };
        let force = page.find(&["F_s", r"F_{\mathrm{s}}"], "N", &s.k * (length - &s.l0));
        self.answer(page, Quantity::SpringForce, force);
        let side = page.find(&["n_t", "c_t"], "1", s.aside(self.up, &self.phi1) / length);
        let out = page.find(&["n_r", "c_r"], "1", (s.along(self.up, &self.phi1) - &s.b) / length);
        Some((force.into(), out.into(), side.into()))
    }

    /// Angular acceleration and force of the pin at the end.
    fn forces(&self, page: &mut Page, omega: SymbolId) {
        let asked = [
            Quantity::Alpha,
            Quantity::PinRadial,
            Quantity::PinTangential,
            Quantity::PinForce,
            Quantity::PinX,
            Quantity::PinY,
            Quantity::PinAngle,
            Quantity::SpringForce,
        ];
        if !asked.iter().any(|q| page.asks(*q)) {
            return;
        }
        page.begin("forces");
        let at = match &self.phi1 {
            Expr::Symbol(s) => page.shown(*s),
            _ => format!("${} = 0$", page.tex(&self.phi)),
        };
        self.say(page, "pinned.forces", &[("angle", &at)]);
        let pull = self.pull(page);
        let [moments, toward, aside] = self.rows_at(&self.phi1, &pull);
        let over = positive_first(vec![moments]);
        let alpha = page.find(
            &[r"\alpha", r"\alpha_1"],
            "rad/s^2",
            Factors::of(&over).per(&Factors::of(&self.about.into())).expr(),
        );
        self.answer(page, Quantity::Alpha, alpha);
        if asked[1..7].iter().any(|q| page.asks(*q)) {
            let mh = Factors::of(&self.m).times(&Factors::of(&self.h));
            let radial = mh.times(&Factors::of(&square(omega))).expr() - toward;
            let radial = page.find(&["R", "O_r"], "N", positive_first(vec![radial]));
            let across = mh.times(&Factors::of(&alpha.into())).expr() - aside;
            let across = page.find(&["S", "O_t"], "N", positive_first(vec![across]));
            self.answer(page, Quantity::PinRadial, radial);
            self.answer(page, Quantity::PinTangential, across);
            if page.asks(Quantity::PinForce) {
                let force = page.find(&["F_O", "O"], "N", root(square(radial) + square(across)));
                self.answer(page, Quantity::PinForce, force);
            }
            self.parts_of_pin(page, radial, across);
            page.tell_new();
            let (r, s) = (page.symbols.value(radial), page.symbols.value(across));
            let names = [page.names(&[radial]), page.names(&[across])];
            if r != 0.0 {
                self.say(
                    page,
                    if r > 0.0 { "pinned.pin_toward" } else { "pinned.pin_outward" },
                    &[("radial", &names[0])],
                );
            }
            if s != 0.0 {
                self.say(
                    page,
                    if s > 0.0 { "pinned.pin_with" } else { "pinned.pin_against" },
                    &[("across", &names[1])],
                );
            }
        }
        page.tell_new();
    }

    /// The force of the pin in a fixed frame: horizontal to the side of small positive angles, vertical up, and its angle.
    fn parts_of_pin(&self, page: &mut Page, radial: SymbolId, across: SymbolId) {
        let (s, c) = (sine(&self.phi1), cosine(&self.phi1));
        let x = positive_first(vec![across * &c - radial * &s]);
        let y = if self.up { -(radial * &c) - across * &s } else { radial * &c + across * &s };
        let parts = [Quantity::PinX, Quantity::PinY, Quantity::PinAngle];
        if !parts.iter().any(|q| page.asks(*q)) {
            return;
        }
        let x = page.find(&["O_x", "X_O"], "N", x);
        let y = page.find(&["O_y", "Y_O"], "N", positive_first(vec![y]));
        self.answer(page, Quantity::PinX, x);
        self.answer(page, Quantity::PinY, y);
        if page.asks(Quantity::PinAngle) {
            let angle = arc_cosine(x / root(square(x) + square(y)));
            let angle = in_sense(angle, page.symbols.value(y));
            let angle = page.find(&[r"\psi_O", r"\chi_O"], "rad", angle);
            self.answer(page, Quantity::PinAngle, angle);
        }
    }

    /// The angle turned, in radians with its sign.
    fn turned(&self, page: &mut Page) -> SymbolId {
        let name = format!(r"\Delta {}", page.tex(&self.phi));
        if let Some(known) = page.symbols.named(&name) {
            return known;
        }
        let pi = page.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let half = page.symbols.given(r"180^\circ", 180.0, "180", "", true);
        let angle = &self.phi1 - &self.phi0;
        page.find(&[&name], "rad", angle * pi / half)
    }

    /// What else is asked.
    fn rest(&self, page: &mut Page, omega: SymbolId) {
        page.begin("rest");
        page.skip_new();
        if page.asks(Quantity::V) {
            let v = page.find(
                &["v_G", "u_G"],
                "m/s",
                Factors::of(&self.h).times(&Factors::of(&omega.into())).expr(),
            );
            self.answer(page, Quantity::V, v);
        }
        if page.asks(Quantity::KineticEnergy) {
            let t = page.find(&["E_{k}", r"E_{\mathrm{kin}}"], "J", ratio(1, 2) * self.about * square(omega));
            page.answer(of_scene(Quantity::KineticEnergy), DerivedAnswer::Value(t));
        }
        if page.asks(Quantity::RotationalFraction) {
            let share = page.find(
                &[r"\zeta", r"\zeta_r"],
                "1",
                Factors::of(&self.own).per(&Factors::of(&self.about.into())).expr(),
            );
            page.answer(of_scene(Quantity::RotationalFraction), DerivedAnswer::Value(share));
        }
        if page.asks(Quantity::AngularMomentum) {
            let from = Factors::of(&self.about.into()).times(&Factors::of(&omega.into())).expr();
            let l = page.find(&["L_O", r"\Lambda_O"], "kg m^2/s", from);
            self.answer(page, Quantity::AngularMomentum, l);
        }
        if page.asks(Quantity::PowerCouple) {
            let power = Factors::of(&self.couple()).times(&Factors::of(&omega.into())).expr();
            let power = page.find(&[r"\dot{W}_{M}"], "W", in_sense(power, self.sense));
            self.answer(page, Quantity::PowerCouple, power);
        }
        if page.asks(Quantity::WorkCouple) && !self.instant {
            let turned = self.turned(page);
            let work = page.find(&["W_{M}"], "J", self.couple() * turned);
            self.answer(page, Quantity::WorkCouple, work);
        }
        if page.asks(Quantity::T) && !self.instant {
            page.tell_new();
            self.say(page, "pinned.time", &[]);
            let time = self.time(page);
            let tex = page.free(&["t", "t_1"]);
            let t = page.symbols.found(&tex, time, &tex_of("s"));
            page.step(t, t.into());
            page.draft.answer(of_scene(Quantity::T), DerivedAnswer::Value(t));
        }
        if page.asks(Quantity::Phi) && !self.instant {
            let turned = self.turned(page);
            let size = magnitude_of(&turned.into(), page.symbols.value(turned));
            let name = format!(r"\left|{}\right|", page.symbols.tex(turned));
            let size = page.find(&[&name], "rad", size);
            self.answer(page, Quantity::Phi, size);
        }
        if page.asks(Quantity::Rise) && !self.instant {
            let from = -(Factors::of(&self.h).times(&Factors::of(&self.sinking())).expr());
            let rise = page.find(&[r"\Delta z"], "m", from);
            self.answer(page, Quantity::Rise, rise);
        }
        page.tell_new();
    }

    /// Time from the start to the end, s: the integral of the angle over the angular speed, whose ends, where the body may be at
    /// rest, a cosine takes away.
    fn time(&self, page: &Page) -> f64 {
        let (first, last) = (page.value(&self.phi0), page.value(&self.phi1));
        let half = 0.5 * (last - first).abs();
        let pace = |theta: f64| {
            let (sine, cosine): (f64, f64) = trig::sin_cos(theta);
            let square = self.square_at(page.draft, first + 0.5 * (last - first) * (1.0 - cosine));
            half.to_radians() * sine / square.max(f64::MIN_POSITIVE).sqrt()
        };
        let pieces = 40;
        let step = std::f64::consts::PI / f64::from(pieces);
        let piece = |i: i32| {
            let places = gauss::nodes().iter().map(|node| pace((f64::from(i) + node.hi) * step));
            gauss::mean(&places.collect::<Vec<f64>>())
        };
        step * (0..pieces).map(piece).sum::<f64>()
    }

    /// Is this true? A particle in the mass centre, and the share of the rotation.
    fn limits(&self, page: &mut Page, omega: SymbolId) {
        if self.instant || self.own == ZERO || page.symbols.value(omega) == 0.0 {
            return;
        }
        page.begin("limits");
        let share = Factors::of(&self.own).per(&Factors::of(&self.about.into())).expr();
        let percent = tex_digits(&shown::significant(100.0 * page.value(&share), 2), page.words);
        let faster = page.symbols.value(omega) >= page.value(&self.w0).abs();
        let name = if faster { "pinned.particle_faster" } else { "pinned.particle_slower" };
        self.say(page, name, &[("percent", &percent)]);
        let given = matches!(page.scene.bodies[self.body].inertia, Some(RotaryInertia::Moment(_)));
        if self.couples.is_empty() && self.spring.is_none() && !given {
            self.say(page, "pinned.no_mass", &[]);
        }
    }

    /// Does it get there, and which way?
    fn regime(&self, page: &mut Page) {
        let word = if self.sense > 0.0 { Word::Forward } else { Word::Back };
        page.answer(self.label(Quantity::Direction), DerivedAnswer::Word(word));
        if self.instant {
            return;
        }
        let (first, last) = (self.phi0.value(&page.symbols), self.phi1.value(&page.symbols));
        let way = (last - first).abs();
        page.begin("holds");
        let told = |page: &Page, angle: &Expr| match angle {
            Expr::Symbol(s) => page.shown(*s),
            _ => format!("${} = 0$", page.tex(&self.phi)),
        };
        let (start, end) = (told(page, &self.phi0), told(page, &self.phi1));
        let growing = if self.sense > 0.0 { "pinned.growing" } else { "pinned.falling" };
        let sense = page.words.get(&format!("solution.{growing}")).to_owned();
        let drive = self.moment_at(page.draft, first);
        let rough = |page: &Page, value: f64, unit: &str| {
            let digits = tex_digits(&shown::significant(value, 4), page.words);
            format!(r"${digits}\ {}$", crate::solution::draft::tex_of(unit))
        };
        if self.w0 == ZERO {
            let moment = rough(page, drive, "N m");
            self.say(page, "pinned.sets_off", &[("angle", &start), ("moment", &moment), ("sense", &sense)]);
        } else {
            self.say(page, "pinned.goes_on", &[("angle", &start), ("sense", &sense)]);
        }
        // How often the moment changes its sense on the way.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
        let steps = (way / LOOK).ceil().clamp(1.0, 4000.0) as u32;
        let at = |i: u32| first + (last - first) * f64::from(i) / f64::from(steps);
        let drives: Vec<f64> = (0..=steps).map(|i| self.moment_at(page.draft, at(i)) * self.sense).collect();
        let sizes = drives.iter().fold(0.0f64, |most, d| most.max(d.abs()));
        let helps = drives.iter().all(|d| *d >= -1e-12 * sizes);
        let turns = drives.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        let square = self.square_at(page.draft, last);
        let angle = [("angle", end.as_str())];
        if matches!(page.scene.end, End::TurningPoint(_)) {
            self.say(page, "pinned.turns_there", &angle);
        } else if helps {
            self.say(page, "pinned.only_faster", &angle);
        } else if turns <= 1 && drives[0] >= 0.0 && square > 0.0 {
            self.say(page, "pinned.brakes_late", &angle);
        } else {
            let least = (1..=steps).map(|i| self.square_at(page.draft, at(i))).fold(f64::INFINITY, f64::min);
            let least = rough(page, least, "rad^2/s^2");
            self.say(page, "pinned.never_rests", &[angle[0], ("least", &least)]);
        }
    }

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
            return Err(Beyond::Unfound.into());
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

    // -- swings under the weight alone ------------------------------------------------------------------------------------

    /// `1 - cos` of the angle from hanging: by how much the mass centre is above its lowest place, over `h`.
    fn above_lowest(&self) -> Expr {
        if self.up { ONE + cosine(&self.phi0) } else { ONE - cosine(&self.phi0) }
    }

    /// Half the angle from hanging at the start.
    fn half(&self, page: &mut Page) -> Expr {
        if !self.up {
            return &self.phi0 / whole(2);
        }
        let turn = page.symbols.given(r"180^\circ", 180.0, "180", "", true);
        (turn - &self.phi0) / whole(2)
    }

    /// Periods and the greatest speed.
    fn swings(&self, page: &mut Page) {
        let all = [Quantity::Period, Quantity::PeriodSmall, Quantity::OmegaSmall, Quantity::OmegaMax];
        if !page.scene.is_pendulum() || !all.iter().any(|q| page.asks(*q)) {
            return;
        }
        page.begin_as("swings", "swings");
        page.skip_new();
        let pulled = Factors::of(&self.m).times(&Factors::of(&self.g)).times(&Factors::of(&self.h));
        if page.asks(Quantity::OmegaMax) {
            self.say(page, "pinned.fastest", &[]);
            let fall = pulled.times(&Factors::of(&whole(2))).times(&Factors::of(&self.above_lowest()));
            let inside = square(&self.w0) + fall.per(&Factors::of(&self.about.into())).expr();
            let fastest = page.find(&[r"\omega_{\mathrm{max}}", r"\omega_m"], "rad/s", root(inside));
            self.answer(page, Quantity::OmegaMax, fastest);
            page.tell_new();
        }
        self.say(page, "pinned.small", &[]);
        let pi = page.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false);
        let frequency = page.find(&[r"\Omega", r"\omega_s"], "rad/s", root(pulled.expr() / self.about));
        self.answer(page, Quantity::OmegaSmall, frequency);
        if page.asks(Quantity::PeriodSmall) {
            let small = page.find(&[r"\tau_0", r"\tau_s"], "s", whole(2) * pi / frequency);
            self.answer(page, Quantity::PeriodSmall, small);
        }
        page.tell_new();
        if page.asks(Quantity::Period) {
            self.period(page, frequency, pi);
        }
    }

    /// The real period, by the arithmetic-geometric mean.
    fn period(&self, page: &mut Page, frequency: SymbolId, pi: SymbolId) {
        let half = self.half(page);
        let hangs = self.phi0 == ZERO && !self.up;
        let (sine_half, cosine_half) = if hangs { (ZERO, ONE) } else { (sine(half.clone()), cosine(half)) };
        let started = self.w0 != ZERO;
        let amplitude = if started {
            let share = &self.w0 / (whole(2) * frequency);
            root(square(&sine_half) + square(&share))
        } else {
            magnitude_of(&sine_half, page.value(&sine_half))
        };
        let over = page.value(&amplitude) > 1.0;
        self.say(page, if over { "pinned.period_over" } else { "pinned.period" }, &[]);
        let (mut a, mut b, turns);
        if over {
            let kappa = page.find(&[r"\kappa", r"\lambda"], "1", amplitude);
            let rest = page.find(&[r"\kappa_c", r"\lambda_c"], "1", root(square(kappa) - ONE));
            (a, b, turns) = (page.symbols.value(kappa), page.symbols.value(rest), Expr::from(pi));
        } else {
            let from = if started {
                root(ONE - square(&amplitude))
            } else {
                magnitude_of(&cosine_half, page.value(&cosine_half))
            };
            let rest = page.find(&[r"\kappa_c", r"\lambda_c"], "1", from);
            (a, b, turns) = (1.0, page.symbols.value(rest), whole(2) * pi);
        }
        page.tell_new();
        let mut pairs = Vec::new();
        for _ in 0..40 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            let digits = |x: f64| tex_digits(&shown::significant(x, 6), page.words);
            if pairs.len() < 3 {
                pairs.push(format!(
                    "${}$ {} ${}$",
                    digits(a),
                    page.words.get("solution.pinned.and"),
                    digits(b)
                ));
            }
            if (a - b).abs() <= 1e-15 * a {
                break;
            }
        }
        self.say(page, "pinned.means", &[("pairs", &pairs.join("; "))]);
        let name = page.free(&[r"\mu", r"\nu"]);
        let mean = page.symbols.found(&name, a, "");
        let shown = page.shown(mean);
        self.say(page, "pinned.mean_found", &[("mean", &shown)]);
        let period = page.find(&[r"\tau", r"\tau_1"], "s", turns / (frequency * mean));
        self.answer(page, Quantity::Period, period);
        page.tell_new();
    }
}

/// The magnitude of something whose value is known.
fn magnitude_of(e: &Expr, value: f64) -> Expr {
    if value < 0.0 { magnitude(e.clone()) } else { e.clone() }
}
