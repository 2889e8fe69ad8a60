//! The mechanism of a scene in symbols: velocity ratios, forces with their points, masses and moments of inertia.
//!
//! Derived here anew from the scene: neither road's code is used.
use crate::figure::names;
use crate::scene::Attach;
use crate::scene::Body;
use crate::scene::Coordinate;
use crate::scene::CordEnd;
use crate::scene::Degree;
use crate::scene::Far;
use crate::scene::Mass;
use crate::scene::Num;
use crate::scene::Quantity;
use crate::scene::RotaryInertia;
use crate::scene::Scene;
use crate::scene::Shape;
use crate::scene::Side;
use crate::scene::Slope;
use crate::scene::Tie;
use crate::solution::desk::Desk;
use crate::solution::expr::Expr;
use crate::solution::expr::ONE;
use crate::solution::expr::Symbol;
use crate::solution::expr::ZERO;
use crate::solution::expr::cosine;
use crate::solution::expr::sine;
use crate::solution::expr::sum;
use crate::solution::factors::Factors;
use crate::solution::mass::beta;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;

/// What brings a force or couple.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The weight of this body.
    Weight(usize),
    /// A couple, by index.
    Couple(usize),
    /// A tie, by index.
    Tie(usize),
}

/// What is known of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Given: weights, pulls, couples.
    Given,
    /// The spring's, which changes on the way.
    Spring,
    /// Kinetic friction: of known size once the normal force is known.
    Kinetic,
    /// A reaction: known from the equations alone.
    Reaction,
}

/// A force or couple at its point on a body.
#[derive(Debug, Clone)]
pub struct Action {
    /// What brings it.
    pub source: Source,
    /// What is known of it.
    pub kind: Kind,
    /// Is it the friction of a contact?
    pub contact: bool,
    /// The body.
    pub body: usize,
    /// Its size, positive in its own sense.
    pub force: Expr,
    /// Share of it along the line of the body, positive forward: 0 for a couple, `sin` for a weight.
    pub along: Factors,
    /// Its arm about the mass centre, positive with rolling forward.
    pub arm: Factors,
}

/// One body.
#[derive(Debug, Clone)]
pub struct Part {
    /// Its name for headings.
    pub label: String,
    /// What stands below the symbols that belong to it where several bodies have such a symbol.
    pub tag: String,
    /// Mass.
    pub mass: Factors,
    /// Moment of inertia about the mass centre, as a sum.
    pub inertia: Vec<Factors>,
    /// Acceleration along its line.
    pub a: Option<Symbol>,
    /// Angular acceleration.
    pub alpha: Option<Symbol>,
    /// Speed at the end.
    pub v: Option<Symbol>,
    /// Angular speed at the end.
    pub omega: Option<Symbol>,
    /// Normal force of the surface, and what it is.
    pub normal: Option<(Symbol, Expr)>,
    /// Velocity of the line, per unit velocity of the lead.
    pub along: Factors,
    /// Spin, per unit velocity of the lead.
    pub turn: Factors,
    /// 1 if forward is up (or right), else -1: the sense in which friction counts as positive.
    pub up: i8,
    /// Line it moves on, for words: `incline`, `vertical`, `level`; `axle` where it only turns.
    pub path: &'static str,
    /// Slips: its spin is a freedom of its own.
    pub slips: bool,
}

/// The mechanism.
#[derive(Debug, Clone)]
pub struct Mechanism {
    /// The bodies.
    pub parts: Vec<Part>,
    /// All forces but normal ones.
    pub actions: Vec<Action>,
    /// Lead: the coordinate to which the velocity ratios refer.
    pub lead: Coordinate,
    /// Free fall.
    pub g: Expr,
    /// Is there gravity in any equation?
    pub weighty: bool,
}

/// Friction or tension of a tie as a symbol.
fn symbol_of(action: &Action) -> Option<Symbol> {
    match action.force {
        Expr::Symbol(s) => Some(s),
        _ => None,
    }
}

impl Mechanism {
    /// Reads the scene; `rolled`: what is said to slip is taken as rolling, its unknowns get an r.
    ///
    /// # Errors
    /// What the derivation does not cover.
    pub fn new(desk: &mut Desk, rolled: bool) -> Result<Self, Stop> {
        let lead = desk.scene.ending_coordinate();
        let g = gravity(desk);
        let parts = parts(desk, rolled);
        let mut this = Self { parts, actions: Vec::new(), lead, g, weighty: false };
        this.act(desk, rolled);
        this.ratios(desk, rolled)?;
        Ok(this)
    }

    /// All forces at their points.
    fn act(&mut self, desk: &mut Desk, rolled: bool) {
        let scene = desk.scene;
        let contacts = scene.ties.iter().filter(|t| !matches!(t, Tie::Cord(_))).count();
        let tensed = scene.cords_with(Quantity::Tension).count();
        let mut cords = 0;
        for (t, tie) in scene.ties.iter().enumerate() {
            match tie {
                Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. } => {
                    let c = Factors::of(&desk.number(*radius_m, "R", "m"));
                    let rolls = rolled || matches!(tie, Tie::Roll { .. });
                    let kind = if rolls { Kind::Reaction } else { Kind::Kinetic };
                    let tag = if contacts > 1 { self.parts[*body].tag.as_str() } else { "" };
                    let force = friction(desk, &below(tag, rolled));
                    let up = self.parts[*body].up;
                    self.actions.push(Action {
                        contact: true,
                        source: Source::Tie(t),
                        kind,
                        body: *body,
                        force: force.into(),
                        along: Factors::one().signed(up),
                        arm: c.signed(-up),
                    });
                }
                Tie::Slide { body, .. } => {
                    let tag = if contacts > 1 { self.parts[*body].tag.as_str() } else { "" };
                    let force = friction(desk, &below(tag, rolled));
                    self.actions.push(Action {
                        contact: true,
                        source: Source::Tie(t),
                        kind: Kind::Kinetic,
                        body: *body,
                        force: force.into(),
                        along: Factors::one().signed(self.parts[*body].up),
                        arm: Factors::zero(),
                    });
                }
                Tie::Cord(cord) => {
                    let (kind, force) = match &cord.to {
                        Far::Pull(p) => (Kind::Given, desk.number(*p, "P", "N")),
                        other => {
                            cords += 1;
                            let tag = if tensed > 1 { cords.to_string() } else { String::new() };
                            let tag = below(&tag, rolled);
                            let tex = desk.free(&[&tagged("T", &tag), &tagged("S", &tag)]);
                            let spring = matches!(other, Far::Spring { .. });
                            let kind = if spring { Kind::Spring } else { Kind::Reaction };
                            (kind, desk.unknown(&tex, "N").into())
                        }
                    };
                    let mut ends = vec![cord.from];
                    if let Far::Body(other) = &cord.to {
                        ends.push(*other);
                    }
                    for end in ends {
                        let (along, arm) = lever(desk, &end);
                        let along = if self.parts[end.body].a.is_some() { along } else { Factors::zero() };
                        let arm = if self.parts[end.body].alpha.is_some() { arm } else { Factors::zero() };
                        self.actions.push(Action {
                            contact: false,
                            source: Source::Tie(t),
                            kind,
                            body: end.body,
                            force: force.clone(),
                            along,
                            arm,
                        });
                    }
                }
            }
        }
        for (i, c) in scene.couples.iter().enumerate() {
            let force = desk.number(c.moment_n_m, "M", "N m");
            self.actions.push(Action {
                contact: false,
                source: Source::Couple(i),
                kind: Kind::Given,
                body: c.body,
                force,
                along: Factors::zero(),
                arm: Factors::one().signed(if c.forward { 1 } else { -1 }),
            });
        }
        self.weigh(desk);
    }

    /// The weights of the bodies on slopes.
    fn weigh(&mut self, desk: &mut Desk) {
        let scene = desk.scene;
        for (i, body) in scene.bodies.iter().enumerate() {
            let climb = match body.line.map(|l| l.slope) {
                None | Some(Slope::Level) => continue,
                Some(Slope::Vertical) => ONE,
                Some(Slope::Degrees(angle)) => sine(desk.number(angle, r"\theta", "deg")),
            };
            if climb == ZERO {
                continue;
            }
            self.weighty = true;
            let part = &self.parts[i];
            self.actions.push(Action {
                contact: false,
                source: Source::Weight(i),
                kind: Kind::Given,
                body: i,
                force: part.mass.expr() * &self.g,
                along: Factors::of(&climb).signed(-part.up),
                arm: Factors::zero(),
            });
        }
    }

    /// Velocity ratios from the ties: first within each body, then from body to body.
    fn ratios(&mut self, desk: &mut Desk, rolled: bool) -> Result<(), Stop> {
        let scene = desk.scene;
        // Spin per unit velocity of the centre, where a tie of the body alone gives it.
        let mut inner: Vec<Option<Factors>> = vec![None; self.parts.len()];
        for tie in &scene.ties {
            match tie {
                Tie::Slip { .. } if !rolled => {}
                Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. } => {
                    let c = Factors::of(&desk.number(*radius_m, "R", "m"));
                    inner[*body] = Some(Factors::one().per(&c));
                }
                Tie::Cord(cord) if cord.to == Far::Fixed => {
                    let part = &self.parts[cord.from.body];
                    let (along, arm) = lever(desk, &cord.from);
                    // along v + arm omega = 0
                    if part.a.is_none() || part.alpha.is_none() || arm.is_zero() {
                        return Err(Beyond::HeldFast.into());
                    }
                    inner[cord.from.body] = Some(along.per(&arm).opposite());
                }
                _ => {}
            }
        }
        let mut known = vec![false; self.parts.len()];
        // Sets the ratios of a body from one of its coordinates.
        let settle = |parts: &mut Vec<Part>, body: usize, degree: Degree, ratio: Factors| -> bool {
            let part = &mut parts[body];
            match (part.a.is_some(), part.alpha.is_some() && !part.slips, &inner[body], degree) {
                (true, true, Some(inner), Degree::Along) => {
                    part.turn = ratio.times(inner);
                    part.along = ratio;
                }
                (true, true, Some(inner), Degree::Turn) => {
                    part.along = ratio.per(inner);
                    part.turn = ratio;
                }
                (true, true, None, _) => return false,
                (true, false, _, Degree::Along) => part.along = ratio,
                (false, true, _, Degree::Turn) => part.turn = ratio,
                _ => return false,
            }
            true
        };
        if self.parts[self.lead.body].slips && self.lead.degree == Degree::Turn {
            return Err(Beyond::EndBySpin.into());
        }
        if !settle(&mut self.parts, self.lead.body, self.lead.degree, Factors::one()) {
            return Err(Beyond::LooseSpin.into());
        }
        known[self.lead.body] = true;
        loop {
            let mut progress = false;
            for tie in &scene.ties {
                let Tie::Cord(cord) = tie else { continue };
                let Far::Body(other) = &cord.to else { continue };
                let (one, two) = match (known[cord.from.body], known[other.body]) {
                    (true, false) => (&cord.from, other),
                    (false, true) => (other, &cord.from),
                    _ => continue,
                };
                let given = self.point_of(desk, one);
                let (along, arm) = lever(desk, two);
                let part = &self.parts[two.body];
                if part.slips && !arm.is_zero() {
                    return Err(Beyond::WoundOnSlipping.into());
                }
                // given + (along v + arm omega) = 0, with omega = inner v.
                let (degree, per) = match (part.a.is_some(), part.alpha.is_some() && !part.slips) {
                    (true, true) => match &inner[two.body] {
                        Some(inner) => (Degree::Along, along.plus(&arm.times(inner))),
                        None if arm.is_zero() => (Degree::Along, along),
                        None => {
                            return Err(Beyond::LooseSpin.into());
                        }
                    },
                    (true, false) => (Degree::Along, along),
                    _ => (Degree::Turn, arm),
                };
                if per.is_zero() {
                    return Err(Beyond::HeldFast.into());
                }
                if !settle(&mut self.parts, two.body, degree, given.per(&per).opposite()) {
                    return Err(Beyond::LooseSpin.into());
                }
                known[two.body] = true;
                progress = true;
            }
            if !progress {
                break;
            }
        }
        if known.contains(&false) {
            return Err(Beyond::Untied.into());
        }
        self.cords_keep_their_length(desk)
    }

    fn cords_keep_their_length(&self, desk: &mut Desk) -> Result<(), Stop> {
        for tie in &desk.scene.ties {
            if let Tie::Cord(cord) = tie
                && let Far::Body(other) = &cord.to
            {
                let ends = [&cord.from, other].map(|end| self.point_of(desk, end).expr().value(&desk.ledger));
                if (ends[0] + ends[1]).abs() > 1e-9 * ends[0].abs().max(ends[1].abs()) {
                    return Err(Beyond::CordsLock.into());
                }
            }
        }
        Ok(())
    }

    /// Velocity of a cord's end along the cord, away from the body, per unit velocity of the lead.
    fn point_of(&self, desk: &mut Desk, end: &CordEnd) -> Factors {
        let (along, arm) = lever(desk, end);
        let part = &self.parts[end.body];
        part.along.times(&along).plus(&part.turn.times(&arm))
    }

    /// Velocity of the point of a force in its own sense, per unit velocity of the lead.
    pub fn point(&self, action: &Action) -> Factors {
        let part = &self.parts[action.body];
        part.along.times(&action.along).plus(&part.turn.times(&action.arm))
    }

    /// The ratio of a coordinate to the lead.
    pub fn ratio(&self, c: Coordinate) -> &Factors {
        let part = &self.parts[c.body];
        match c.degree {
            Degree::Along => &part.along,
            Degree::Turn => &part.turn,
        }
    }

    /// Acceleration of a coordinate.
    pub fn acceleration(&self, c: Coordinate) -> Option<Symbol> {
        let part = &self.parts[c.body];
        match c.degree {
            Degree::Along => part.a,
            Degree::Turn => part.alpha,
        }
    }

    /// Speed of a coordinate at the end.
    pub fn speed(&self, c: Coordinate) -> Option<Symbol> {
        let part = &self.parts[c.body];
        match c.degree {
            Degree::Along => part.v,
            Degree::Turn => part.omega,
        }
    }

    /// Mass or moments of inertia of a coordinate.
    pub fn inertia(&self, c: Coordinate) -> Vec<Factors> {
        let part = &self.parts[c.body];
        match c.degree {
            Degree::Along => vec![part.mass.clone()],
            Degree::Turn => part.inertia.clone(),
        }
    }

    /// Share of a force in the equation of a coordinate.
    pub fn lever<'m>(&self, action: &'m Action, c: Coordinate) -> &'m Factors {
        match c.degree {
            Degree::Along => &action.along,
            Degree::Turn => &action.arm,
        }
    }

    /// Friction or tension of a tie.
    pub fn force_of(&self, tie: usize) -> Option<Symbol> {
        self.actions.iter().find(|a| a.source == Source::Tie(tie)).and_then(symbol_of)
    }

    /// The action of a contact or of the first end of a cord.
    pub fn action_of(&self, tie: usize) -> Option<&Action> {
        self.actions.iter().find(|a| a.source == Source::Tie(tie))
    }

    /// `m` or `m k^2 + ...` of a coordinate, as one expression.
    pub fn inertia_expr(&self, c: Coordinate) -> Expr {
        sum(self.inertia(c).iter().map(Factors::expr))
    }

    /// What the lead has to accelerate: each mass and moment of inertia times the square of its ratio. The spin of a
    /// slipping body is left out.
    pub fn effective(&self, desk: &Desk) -> Expr {
        let coordinates = desk.scene.coordinates();
        sum(coordinates.filter(|c| !self.ratio(*c).is_zero()).flat_map(|c| {
            let square = self.ratio(c).squared();
            self.inertia(c).into_iter().map(move |i| i.times(&square).expr())
        }))
    }
}

/// The bodies with their unknowns, before anything ties them.
pub fn parts(desk: &mut Desk, rolled: bool) -> Vec<Part> {
    let scene = desk.scene;
    let g = gravity(desk);
    let mut parts = Vec::new();
    let tags = tags(scene);
    let count = |has: &dyn Fn(&Body) -> bool| scene.bodies.iter().filter(|b| has(b)).count();
    let lines = count(&|b| b.line.is_some());
    let turns = count(&|b| b.turns);
    let surfaces = count(&|b| b.line.is_some_and(|l| l.surface));
    for (i, body) in scene.bodies.iter().enumerate() {
        let tag = tags[i].clone();
        let mass = mass(desk, body, &g, &tag);
        let inertia = inertia(desk, body, &mass, &g, &tag);
        let named = |desk: &mut Desk, names: &[&str], several: bool, unit: &str| {
            let tag = below(if several { &tag } else { "" }, rolled);
            let names: Vec<String> = names.iter().map(|n| tagged(n, &tag)).collect();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let tex = desk.free(&names);
            desk.unknown(&tex, unit)
        };
        let moves = body.line.is_some();
        let a = moves.then(|| named(desk, &["a", "a_G"], lines > 1, "m/s^2"));
        let v = moves.then(|| named(desk, &["v", "v_2"], lines > 1, "m/s"));
        let alpha = body.turns.then(|| named(desk, &[r"\alpha", r"\dot{\omega}"], turns > 1, "rad/s^2"));
        let omega = body.turns.then(|| named(desk, &[r"\omega", r"\omega_2"], turns > 1, "rad/s"));
        let level = level(desk, body);
        let normal = body.line.is_some_and(|l| l.surface).then(|| {
            let tex = tagged("N", if surfaces > 1 { &tag } else { "" });
            let tex = desk.free(&[&tex, "N_s"]);
            let n = desk.unknown(&tex, "N");
            (n, mass.expr() * &g * level)
        });
        let path = match body.line.map(|l| l.slope) {
            None => "axle",
            Some(Slope::Level) => "level",
            Some(Slope::Vertical) => "vertical",
            Some(Slope::Degrees(_)) => "incline",
        };
        parts.push(Part {
            label: names::body(desk.words, desk.scene, i),
            tag,
            mass,
            inertia,
            a,
            alpha,
            v,
            omega,
            normal,
            along: Factors::zero(),
            turn: Factors::zero(),
            up: if body.line.is_none_or(|l| l.forward_up) { 1 } else { -1 },
            path,
            slips: !rolled && scene.ties.iter().any(|t| matches!(t, Tie::Slip { body, .. } if *body == i)),
        });
    }
    parts
}

/// `along` and `arm` of a cord's end: its share along the line, its arm about the mass centre.
pub fn lever(desk: &mut Desk, end: &CordEnd) -> (Factors, Factors) {
    let toward = if end.forward { 1 } else { -1 };
    let arm = match end.attach {
        Attach::Centre => Factors::zero(),
        Attach::Wound(p, side) => {
            let side = if side == Side::Top { toward } else { -toward };
            Factors::of(&desk.number(p, "r", "m")).signed(side)
        }
    };
    (Factors::one().signed(toward), arm)
}

/// A tag, with an r if it belongs to the rolling that does not happen.
fn below(tag: &str, rolled: bool) -> String {
    match (rolled, tag) {
        (false, tag) => tag.to_owned(),
        (true, "") => r"\mathrm{r}".to_owned(),
        (true, tag) => format!(r"{tag},\mathrm{{r}}"),
    }
}

fn friction(desk: &mut Desk, tag: &str) -> Symbol {
    let tex = desk.free(&[&tagged("F", tag), &tagged("R", tag)]);
    desk.unknown(&tex, "N")
}

fn level(desk: &mut Desk, body: &Body) -> Expr {
    match body.line.map(|l| l.slope) {
        None | Some(Slope::Vertical) => ZERO,
        Some(Slope::Level) => ONE,
        Some(Slope::Degrees(angle)) => cosine(desk.number(angle, r"\theta", "deg")),
    }
}

fn mass_of(desk: &mut Desk, mass: &Mass, g: &Expr, tag: &str) -> Expr {
    match mass {
        Mass::Kilograms(m) => desk.number(*m, &tagged("m", tag), "kg"),
        Mass::Weight(w) => desk.number(*w, &tagged("W", tag), "N") / g,
        Mass::OfParts => ZERO,
    }
}

/// g, told only where something has a weight.
fn gravity(desk: &mut Desk) -> Expr {
    if desk.scene.bodies.iter().all(Body::massless) {
        return ZERO;
    }
    desk.number(desk.scene.gravity_m_s2, "g", "m/s^2")
}

fn mass(desk: &mut Desk, body: &Body, g: &Expr, tag: &str) -> Factors {
    if body.massless() {
        return Factors::zero();
    }
    Factors::of(&match (&body.mass, &body.inertia) {
        (Mass::OfParts, Some(RotaryInertia::Parts(parts))) => {
            sum(parts.iter().map(|p| mass_of(desk, &p.mass, g, tag)).collect::<Vec<_>>())
        }
        (mass, _) => mass_of(desk, mass, g, tag),
    })
}

fn inertia(desk: &mut Desk, body: &Body, mass: &Factors, g: &Expr, tag: &str) -> Vec<Factors> {
    if !body.turns {
        return Vec::new();
    }
    let shape = |desk: &mut Desk, mass: Factors, shape: Shape, radius: Num| {
        let radius = Factors::of(&desk.number(radius, "R", "m"));
        Factors::of(&beta(shape)).times(&mass).times(&radius.squared())
    };
    let all = match &body.inertia {
        None => Vec::new(),
        Some(RotaryInertia::Gyration(k)) => {
            vec![mass.times(&Factors::of(&desk.number(*k, &tagged("k", tag), "m")).squared())]
        }
        Some(RotaryInertia::Moment(i)) => vec![Factors::of(&desk.number(*i, &tagged("I", tag), "kg m^2"))],
        Some(RotaryInertia::Shape(s, r)) => vec![shape(desk, mass.clone(), *s, *r)],
        Some(RotaryInertia::Parts(parts)) => parts
            .iter()
            .map(|p| {
                let mass = Factors::of(&mass_of(desk, &p.mass, g, tag));
                shape(desk, mass, p.shape, p.radius_m)
            })
            .collect(),
    };
    all.into_iter().filter(|i| !i.is_zero()).collect()
}

/// The symbol with something below it.
pub fn tagged(symbol: &str, tag: &str) -> String {
    if tag.is_empty() { symbol.to_owned() } else { format!("{symbol}_{{{tag}}}") }
}

/// What stands below the symbols of each body: the number at the end of its name, its first letter if no other body has it,
/// else its name.
fn tags(scene: &Scene) -> Vec<String> {
    let digits = |name: &str| -> String {
        let start = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        name[start..].to_owned()
    };
    let initial = |name: &str| name.chars().next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    let names: Vec<&str> = scene.bodies.iter().map(|b| b.name.as_str()).collect();
    let short = |name: &str| {
        let number = digits(name);
        if number.is_empty() { initial(name) } else { number }
    };
    let shorts: Vec<String> = names.iter().map(|n| short(n)).collect();
    names
        .iter()
        .zip(&shorts)
        .map(|(name, short)| {
            if shorts.iter().filter(|s| *s == short).count() > 1 {
                let plain: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
                format!(r"\mathrm{{{plain}}}")
            } else {
                short.clone()
            }
        })
        .collect()
}
