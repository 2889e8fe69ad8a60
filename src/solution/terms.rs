//! The terms of a scene of lines and axles in symbols: each action with its point, velocity ratios, masses, moments of inertia.
//!
//! Derived here anew from the scene: neither method's code is used.
use crate::figure::names;
pub use crate::figure::names::tagged;
use crate::scene::inertia::fraction;
use crate::scene::{
    Aim, AsIf, Body, Coordinate, Degree, Far, Label, Mass, Num, Numbers, Owner, Quantity, RotaryInertia,
    Shape, Slope, Tie,
};
use crate::solution::asked;
use crate::solution::draft::Draft;
use crate::solution::expr::{Expr, ONE, SymbolId, ZERO, cosine, ratio, signed, sine, square, sum};
use crate::solution::factors::{Cancel, Factors};
use crate::solution::order::Eliminated;

/// What brings a force or couple.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceSource {
    /// The weight of this body.
    Weight(usize),
    /// A couple, by index.
    Couple(usize),
    /// A tie, by index.
    Tie(usize),
    /// What carries this body: the apparent force of its acceleration.
    Carrier(usize),
}

/// What is known of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceKind {
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
    pub source: ForceSource,
    /// What is known of it.
    pub kind: ForceKind,
    /// Is it the friction of a contact?
    pub contact: bool,
    pub body: usize,
    /// Its size, positive in its own sense.
    pub force: Expr,
    /// Share of it along the line of the body, positive forward: 0 for a couple, `sin` for a weight.
    pub along: Factors,
    /// Its arm about the mass centre, positive with rolling forward.
    pub arm: Factors,
}

/// What belongs to one coordinate of a body.
#[derive(Debug, Clone)]
pub struct Freedom {
    /// Acceleration, where it can move so.
    pub a: Option<SymbolId>,
    /// Speed at the end.
    pub v: Option<SymbolId>,
    /// Velocity per unit velocity of the lead.
    pub ratio: Factors,
    /// Mass or moments of inertia, as a sum.
    pub inertia: Vec<Factors>,
}

/// One body.
#[derive(Debug, Clone)]
pub struct BodyTerms {
    /// Its name for headings.
    pub label: String,
    /// What stands below the symbols that belong to it where several bodies have such a symbol.
    pub tag: String,
    pub mass: Factors,
    /// Along its line.
    pub line: Freedom,
    /// About its mass centre.
    pub spin: Freedom,
    /// Normal force of the surface, and what it is.
    pub normal: Option<(SymbolId, Expr)>,
    /// 1 if forward is up (or right), else -1: the sense in which friction counts as positive.
    pub up: i8,
    /// Slips: its spin is a freedom of its own.
    pub slips: bool,
}

/// The terms of a scene.
#[derive(Debug, Clone)]
pub struct Terms {
    /// The bodies.
    pub parts: Vec<BodyTerms>,
    /// All forces but normal ones.
    pub actions: Vec<Action>,
    /// Lead: the coordinate to which the velocity ratios refer.
    pub lead: Coordinate,
    /// Free fall.
    pub g: Expr,
    /// Do the ties give all velocities from the lead's?
    pub tied: bool,
    /// And does it move? Not where a contact holds by friction.
    pub one: bool,
    /// What carries it all.
    pub carrier: Option<Carrying>,
}

/// What carries a scene, which is told as it is seen from there.
#[derive(Debug, Clone)]
pub struct Carrying {
    /// Speed at the start.
    pub speed: Expr,
    pub acceleration: Expr,
    /// Its direction, to the right and up.
    pub direction: [Expr; 2],
    slope: Slope,
}

impl Carrying {
    /// That of the scene.
    pub fn of(draft: &mut Draft) -> Option<Self> {
        let carrier = draft.scene.carried?;
        let speed = draft.number(carrier.speed_m_s, "u", "m/s");
        let acceleration = draft.number(carrier.acceleration_m_s2, "A", "m/s^2");
        let [climb, level] = slope(draft, Some(carrier.slope));
        Some(Self { speed, acceleration, direction: [level, climb], slope: carrier.slope })
    }
    /// How much of it is forward along the line of a body, and out of it.
    pub fn shares(&self, draft: &mut Draft, body: &Body) -> [Expr; 2] {
        let Some(line) = body.line else { return [ZERO, ZERO] };
        if line.slope == self.slope {
            return [signed(ONE, line.forward_up), ZERO];
        }
        let ([climb, level], [right, up]) = (slope(draft, Some(line.slope)), &self.direction);
        let along = right * &level + up * &climb;
        [signed(along, line.forward_up), up * level - right * climb]
    }
    /// Its speed after a time, and its way.
    pub fn after(&self, time: &Expr) -> [Expr; 2] {
        let way = &self.speed * time + ratio(1, 2) * &self.acceleration * square(time);
        [&self.speed + &self.acceleration * time, way]
    }
}

/// What belongs to the motion as it is seen from what carries the scene.
pub fn relative(draft: &Draft, tag: &str) -> String {
    match (draft.scene.carried, tag) {
        (None, tag) => tag.to_owned(),
        (_, "") => r"\mathrm{rel}".to_owned(),
        (_, tag) => format!(r"{tag},\mathrm{{rel}}"),
    }
}

/// Friction or tension of a tie as a symbol.
fn symbol_of(action: &Action) -> Option<SymbolId> {
    match action.force {
        Expr::Symbol(s) => Some(s),
        _ => None,
    }
}

impl Terms {
    /// Reads the scene.
    pub fn new(draft: &mut Draft) -> Self {
        let lead = draft.scene.ending_coordinate();
        let g = gravity(draft);
        let carrier = Carrying::of(draft);
        let parts = parts(draft, carrier.as_ref());
        let mut this = Self { parts, actions: Vec::new(), lead, g, tied: true, one: true, carrier };
        this.act(draft);
        this.tied = this.ratios(draft).is_some();
        if !this.tied {
            match lead.degree {
                Degree::Along => this.parts[lead.body].line.ratio = Factors::one(),
                Degree::Turn => this.parts[lead.body].spin.ratio = Factors::one(),
            }
        }
        let held = this.actions.iter().any(|a| a.contact && a.kind == ForceKind::Reaction && a.arm.is_zero());
        this.one = this.tied && !held && !draft.stays();
        this
    }

    /// All forces at their points.
    fn act(&mut self, draft: &mut Draft) {
        let scene = draft.scene;
        let contacts = scene.ties.iter().filter(|t| !matches!(t, Tie::Cord(_))).count();
        let of = |force| scene.cords_with(force).count();
        let tensed = of(Quantity::Tension) + of(Quantity::RimForce);
        let mut cords = 0;
        for (t, tie) in scene.ties.iter().enumerate() {
            let (kind, force) = match tie {
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => {
                    let held = match tie {
                        Tie::Slide { .. } => stays(draft, *body),
                        Tie::Roll { .. } => true,
                        _ => draft.rolled == Some(t),
                    };
                    let tag = if contacts > 1 { self.parts[*body].tag.as_str() } else { "" };
                    let tag = below(draft, tag);
                    let force = draft.named(&["F", "R", "H"].map(|n| tagged(n, &tag)), "N");
                    (if held { ForceKind::Reaction } else { ForceKind::Kinetic }, force.into())
                }
                Tie::Cord(cord) => match &cord.to {
                    Far::Pull(p) => (ForceKind::Given, draft.number(*p, "P", "N")),
                    other => {
                        cords += 1;
                        let tag = if tensed > 1 { cords.to_string() } else { String::new() };
                        let tag = below(draft, &tag);
                        let force = draft.named(&["T", "S"].map(|n| tagged(n, &tag)), "N");
                        let spring = matches!(other, Far::Spring { .. });
                        (if spring { ForceKind::Spring } else { ForceKind::Reaction }, force.into())
                    }
                },
            };
            let contact = !matches!(tie, Tie::Cord(_));
            for end in tie.actions() {
                let (levers, part) = (levers(draft, &end), &self.parts[end.body]);
                // Friction is positive up, and what cannot move has no share in a cord.
                let moves = [part.line.a, part.spin.a].map(|a| contact || a.is_some());
                let sense = if contact { part.up } else { 1 };
                let levers = [0, 1].map(|i| if moves[i] { levers[i].signed(sense) } else { Factors::zero() });
                self.push(ForceSource::Tie(t), kind, contact, end.body, force.clone(), levers);
            }
        }
        for (i, c) in scene.couples.iter().enumerate() {
            let force = draft.number(c.moment_n_m, "M", "N m");
            let levers = [Factors::zero(), Factors::one().signed(if c.forward { 1 } else { -1 })];
            self.push(ForceSource::Couple(i), ForceKind::Given, false, c.body, force, levers);
        }
        self.weigh(draft);
    }

    fn push(
        &mut self,
        source: ForceSource,
        kind: ForceKind,
        contact: bool,
        body: usize,
        force: Expr,
        [along, arm]: [Factors; 2],
    ) {
        self.actions.push(Action { source, kind, contact, body, force, along, arm });
    }

    /// Share of a direction to the right, or up.
    pub fn component(&self, draft: &mut Draft, aim: Aim, upright: bool) -> Factors {
        match aim {
            Aim::Level(right) if !upright => Factors::one().signed(if right { 1 } else { -1 }),
            Aim::Upright(up) if upright => Factors::one().signed(if up { 1 } else { -1 }),
            Aim::Level(_) | Aim::Upright(_) => Factors::zero(),
            Aim::Tilted(tilt, right) => {
                let beta = draft.number(tilt, r"\beta", "deg");
                let share = if upright { sine(beta) } else { cosine(beta) };
                share.factors().signed(if upright || right { 1 } else { -1 })
            }
            Aim::Along(body, forward) => {
                let line = draft.scene.bodies[body].line;
                let [climb, level] = slope(draft, line.map(|l| l.slope));
                let way = if forward { 1 } else { -1 };
                if upright {
                    climb.factors().signed(way * self.parts[body].up)
                } else {
                    level.factors().signed(way)
                }
            }
        }
    }

    /// The weights of the bodies on slopes, and the apparent forces of what is carried.
    fn weigh(&mut self, draft: &mut Draft) {
        let scene = draft.scene;
        for (i, body) in scene.bodies.iter().enumerate() {
            if let Some(carrier) = &self.carrier {
                let [forward, _] = carrier.shares(draft, body);
                let force = self.parts[i].mass.expr() * &carrier.acceleration;
                if force != ZERO {
                    let levers = [forward.factors().opposite(), Factors::zero()];
                    self.push(ForceSource::Carrier(i), ForceKind::Given, false, i, force, levers);
                }
            }
            let [climb, _] = slope(draft, body.line.map(|l| l.slope));
            if climb != ZERO {
                let part = &self.parts[i];
                let levers = [climb.factors().signed(-part.up), Factors::zero()];
                let weight = part.mass.expr() * &self.g;
                self.push(ForceSource::Weight(i), ForceKind::Given, false, i, weight, levers);
            }
        }
    }

    /// Velocity ratios from what the ties demand; `None` where they do not give all.
    fn ratios(&mut self, draft: &Draft) -> Option<()> {
        let slides = |tie: usize| matches!(draft.scene.ties[tie], Tie::Slide { .. });
        let ties = self.reactions().into_iter().filter(|(tie, _)| !slides(*tie));
        let ties: Vec<Vec<(Coordinate, Factors)>> = ties.map(|(tie, _)| self.tied(tie)).collect();
        // Where the spin of a body leads whose contact slips, no tie of its own says how it moves along.
        let along = Coordinate { degree: Degree::Along, ..self.lead };
        if self.parts[along.body].slips && along != self.lead && self.of(along).a.is_some() {
            return None;
        }
        let rate = |(c, share): &(Coordinate, Factors)| Some(share.times(self.of(*c).a?));
        let rows = ties.iter().map(|terms| terms.iter().filter_map(rate).collect()).collect();
        // The spin of a body whose contact slips is a freedom of its own.
        let tied =
            |c: &Coordinate| !(self.parts[c.body].slips && c.degree == Degree::Turn) && *c != self.lead;
        let free = draft.scene.coordinates().filter(tied).filter_map(|c| Some((c, self.of(c).a?)));
        let free: Vec<(Coordinate, SymbolId)> = free.collect();
        let Eliminated { found, idle, .. } =
            draft.eliminate(rows, free.iter().map(|(_, a)| *a).collect(), |_| false)?;
        let mut known = vec![(self.of(self.lead).a?, Factors::one())];
        for (symbol, is) in found {
            let (over, under) =
                if let Expr::Quotient(over, under) = is { (*over, *under) } else { (is, ONE) };
            let put = |term: &Expr| {
                let (of, ratio) = known.iter().find(|(of, _)| term.uses().contains(of))?;
                Some(ratio.times(term.factors().per(*of)))
            };
            let terms: Option<Vec<Factors>> = over.terms().iter().map(put).collect();
            let ratio = terms?.into_iter().reduce(|sum, term| sum.plus(&term))?;
            known.push((symbol, ratio.per(under)));
        }
        let ratio = |c: &Coordinate| {
            let of = known.iter().find(|(of, _)| self.of(*c).a == Some(*of));
            of.map(|(_, ratio)| ratio)
        };
        // A tie that closes a loop has to hold too.
        let holds = |terms: &Vec<(Coordinate, Factors)>| {
            let value = |(c, share)| Some(ratio(c)?.times(share).expr().value(&draft.symbols));
            let values: Option<Vec<f64>> = terms.iter().map(|(c, share)| value((c, share))).collect();
            values.is_some_and(|v| {
                v.iter().sum::<f64>().abs() <= 1e-9 * v.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
            })
        };
        if !idle.is_empty() || !ties.iter().all(holds) {
            return None;
        }
        let all = [self.lead].into_iter().chain(free.iter().map(|(c, _)| *c));
        let all: Vec<(Coordinate, Factors)> = all.filter_map(|c| Some((c, ratio(&c)?.clone()))).collect();
        for (c, ratio) in all {
            let part = &mut self.parts[c.body];
            let of = if c.degree == Degree::Along { &mut part.line } else { &mut part.spin };
            of.ratio = ratio;
        }
        Some(())
    }

    /// The reactions of ties: index of the tie, and the force.
    pub fn reactions(&self) -> Vec<(usize, SymbolId)> {
        let mut all: Vec<(usize, SymbolId)> = Vec::new();
        for action in self.actions.iter().filter(|a| a.kind == ForceKind::Reaction) {
            if let (ForceSource::Tie(tie), Some(force)) = (action.source, symbol_of(action))
                && !all.iter().any(|(t, _)| *t == tie)
            {
                all.push((tie, force));
            }
        }
        all
    }

    /// What a tie demands: the sum of these coordinates' rates, each times its share, is 0.
    pub fn tied(&self, tie: usize) -> Vec<(Coordinate, Factors)> {
        let own = self.actions.iter().filter(|a| a.source == ForceSource::Tie(tie));
        let both = |a: &Action| [(Degree::Along, a.along.clone()), (Degree::Turn, a.arm.clone())];
        own.flat_map(|a| both(a).map(|(degree, share)| (Coordinate { body: a.body, degree }, share)))
            .filter(|(_, share)| !share.is_zero())
            .collect()
    }

    /// Velocity of the point of a force in its own sense, per unit velocity of the lead.
    pub fn point(&self, action: &Action) -> Factors {
        let part = &self.parts[action.body];
        part.line.ratio.times(&action.along).plus(&part.spin.ratio.times(&action.arm))
    }

    /// What belongs to a coordinate.
    pub fn of(&self, c: Coordinate) -> &Freedom {
        let part = &self.parts[c.body];
        if c.degree == Degree::Along { &part.line } else { &part.spin }
    }

    /// Share of a force in the equation of a coordinate.
    pub fn lever<'m>(&self, action: &'m Action, c: Coordinate) -> &'m Factors {
        match c.degree {
            Degree::Along => &action.along,
            Degree::Turn => &action.arm,
        }
    }

    /// Friction or tension of a tie.
    pub fn force_of(&self, tie: usize) -> Option<SymbolId> {
        self.actions.iter().find(|a| a.source == ForceSource::Tie(tie)).and_then(symbol_of)
    }

    /// The action of a contact or of the first end of a cord.
    pub fn action_of(&self, tie: usize) -> Option<&Action> {
        self.actions.iter().find(|a| a.source == ForceSource::Tie(tie))
    }
}

/// Up to this share of an acceleration another one is the same.
const ROUNDING: f64 = 1e-12;

/// Does friction hold this body where it slides as soon as it moves? As the key has it.
fn stays(draft: &Draft, body: usize) -> bool {
    let numbers = Numbers::<f64>::new(draft.scene, &draft.values);
    let of = |quantity| draft.key(Label { quantity, of: Owner::Body(body) });
    let rests = draft.as_if.is_none() && draft.scene.start_speeds().all(|(c, v)| numbers.start(c, v) == 0.0);
    match numbers.bodies[body].carried {
        // It stays on what carries it.
        Some([forward, _]) => {
            let own = of(Quantity::A).map(|a| (a - forward.acceleration).abs());
            rests && own.is_some_and(|a| a <= ROUNDING * forward.acceleration.abs())
        }
        None => rests && of(Quantity::A) == Some(0.0) && of(Quantity::V).is_none_or(|v| v == 0.0),
    }
}

/// The bodies with their unknowns, before anything ties them.
fn parts(draft: &mut Draft, carrier: Option<&Carrying>) -> Vec<BodyTerms> {
    let scene = draft.scene;
    let g = gravity(draft);
    let mut parts = Vec::new();
    let tags = names::tags(draft.problem, scene);
    let count = |has: &dyn Fn(&Body) -> bool| scene.bodies.iter().filter(|b| has(b)).count();
    let lines = count(&|b| b.line.is_some());
    let turns = count(&|b| b.turns);
    let surfaces = count(&|b| b.line.is_some_and(|l| l.surface));
    for (i, body) in scene.bodies.iter().enumerate() {
        let tag = tags[i].clone();
        let own = if scene.bodies.len() > 1 { tag.as_str() } else { "" };
        let mass = mass(draft, body, &g, own);
        let inertia = inertia(draft, body, &mass, &g, own);
        let named = |draft: &mut Draft, moves: bool, tag: &str, names: [&str; 2], unit: &str| {
            moves.then(|| draft.named(&names.map(|n| tagged(n, tag)), unit))
        };
        let along = relative(draft, &below(draft, if lines > 1 { &tag } else { "" }));
        let about = below(draft, if turns > 1 { &tag } else { "" });
        let moves = body.line.is_some();
        let freedom = |a, v, inertia| Freedom { a, v, ratio: Factors::zero(), inertia };
        let a = named(draft, moves, &along, ["a", "a_G"], "m/s^2");
        let v = named(draft, moves, &along, ["v", "V"], "m/s");
        let line = freedom(a, v, vec![mass.clone()]);
        let alpha = named(draft, body.turns, &about, [r"\alpha", r"\dot{\omega}"], "rad/s^2");
        let omega = named(draft, body.turns, &about, [r"\omega", r"\omega_2"], "rad/s");
        let spin = freedom(alpha, omega, inertia);
        let [_, level] = slope(draft, body.line.map(|l| l.slope));
        let out = carrier.map_or(ZERO, |c| &c.acceleration * c.shares(draft, body)[1].clone());
        // How wheels share a load is not known.
        let normal_of = Label { quantity: Quantity::Normal, of: Owner::Body(i) };
        let pressed = body.line.is_some_and(|l| l.surface) && scene.tells(normal_of);
        let normal = pressed.then(|| {
            let tag = if surfaces > 1 { tag.as_str() } else { "" };
            // A motion that follows may have another surface; one that is only supposed has the same.
            let tag = if draft.as_if == Some(AsIf::Next) { below(draft, tag) } else { tag.to_owned() };
            let n = draft.named(&[tagged("N", &tag), "N_s".to_owned()], "N");
            let lifts = scene.ties.iter().filter_map(Tie::tilted).filter(|(on, ..)| *on == i);
            let lifts = lifts.map(|(_, force, tilt)| {
                draft.number(force, "P", "N") * sine(draft.number(tilt, r"\beta", "deg"))
            });
            (n, lifts.fold(mass.expr() * (&g * level + out), |left, lift| left - lift))
        });
        parts.push(BodyTerms {
            label: names::body(draft.words, draft.scene, i),
            tag,
            mass,
            line,
            spin,
            normal,
            up: if body.line.is_none_or(|l| l.forward_up) { 1 } else { -1 },
            slips: (0..scene.ties.len()).any(|t| {
                draft.rolled != Some(t) && matches!(scene.ties[t], Tie::Slip { body, .. } if body == i)
            }),
        });
    }
    parts
}

/// `along` and `arm` of a force: its share along the line, its arm about the mass centre.
fn levers(draft: &mut Draft, action: &crate::scene::Action) -> [Factors; 2] {
    let sign = |x: f64| if x < 0.0 { -1 } else { 1 };
    let arm = match action.arm {
        None => Factors::zero(),
        Some((radius, sense)) => Factors::of(&draft.number(radius, "R", "m")).signed(sign(sense)),
    };
    let share = action.tilt_deg.map_or(ONE, |tilt| cosine(draft.number(tilt, r"\beta", "deg")));
    [share.factors().signed(sign(action.along)), arm]
}

/// A tag, with an r if it belongs to the rolling that does not happen.
fn below(draft: &Draft, tag: &str) -> String {
    match (mark_of(draft), tag) {
        ("", tag) => tag.to_owned(),
        (mark, "") => mark.to_owned(),
        (mark, tag) => format!("{tag},{mark}"),
    }
}

/// What marks the symbols where a contact is taken as another than it is.
pub fn mark_of(draft: &Draft) -> &'static str {
    let rolled = draft.rolled.map(|_| AsIf::Rolls);
    draft.as_if.or(rolled).map_or("", asked::mark)
}

/// Components of the weight along the line of a body and across, over the weight.
fn slope(draft: &mut Draft, of: Option<Slope>) -> [Expr; 2] {
    match of {
        None => [ZERO, ZERO],
        Some(Slope::Level) => [ZERO, ONE],
        Some(Slope::Vertical) => [ONE, ZERO],
        Some(Slope::Degrees(angle)) => {
            let angle = draft.number(angle, r"\theta", "deg");
            [sine(&angle), cosine(angle)]
        }
    }
}

fn mass_of(draft: &mut Draft, mass: &Mass, g: &Expr, tag: &str) -> Expr {
    match mass {
        Mass::Kilograms(m) => draft.number(*m, &tagged("m", tag), "kg"),
        Mass::Weight(w) => draft.number(*w, &tagged("W", tag), "N") / g,
        Mass::OfParts => ZERO,
    }
}

/// g, told only where something has a weight.
pub fn gravity(draft: &mut Draft) -> Expr {
    if draft.scene.bodies.iter().all(Body::massless) {
        return ZERO;
    }
    draft.number(draft.scene.gravity_m_s2, "g", "m/s^2")
}

/// The mass of a body, from its parts or its weight where need be.
pub fn mass(draft: &mut Draft, body: &Body, g: &Expr, tag: &str) -> Factors {
    if body.massless() {
        return Factors::zero();
    }
    Factors::of(&match (&body.mass, &body.inertia) {
        (Mass::OfParts, Some(RotaryInertia::Parts(parts))) => {
            sum(parts.iter().map(|p| mass_of(draft, &p.mass, g, tag)).collect::<Vec<_>>())
        }
        (mass, _) => mass_of(draft, mass, g, tag),
    })
}

/// The moment of inertia about the mass centre, as a sum.
pub fn inertia(draft: &mut Draft, body: &Body, mass: &Factors, g: &Expr, tag: &str) -> Vec<Factors> {
    if !body.turns {
        return Vec::new();
    }
    let shape = |draft: &mut Draft, mass: Factors, shape: Shape, radius: Num| {
        let name = if shape == Shape::Rod { tagged("L", tag) } else { "R".to_owned() };
        let radius = Factors::of(&draft.number(radius, &name, "m"));
        let [over, under] = fraction(shape).map(i64::from);
        Factors::of(&ratio(over, under)).times(&mass).times(radius.squared())
    };
    let all = match &body.inertia {
        None => Vec::new(),
        Some(RotaryInertia::Gyration(k)) => {
            vec![mass.times(square(draft.number(*k, &tagged("k", tag), "m")))]
        }
        Some(RotaryInertia::Moment(i)) => vec![Factors::of(&draft.number(*i, &tagged("I", tag), "kg m^2"))],
        Some(RotaryInertia::Shape(s, r)) => vec![shape(draft, mass.clone(), *s, *r)],
        Some(RotaryInertia::Parts(parts)) => parts
            .iter()
            .map(|p| {
                let mass = Factors::of(&mass_of(draft, &p.mass, g, tag));
                shape(draft, mass, p.shape, p.radius_m)
            })
            .collect(),
    };
    all.into_iter().filter(|i| !i.is_zero()).collect()
}
