//! The `scene` part of a problem: bodies, ties, forces, start and end, read into pure data.
use crate::bank::any::AnyNumber;
use crate::bank::measure;
use crate::bank::need::Need;
use crate::bank::node::{Faults, Fields, Node, Value, items, known_as, named, shorten, some_named};
use crate::scene::{
    AsIf, Body, Carrier, Coordinate, Couple, Degree, Derived, End, Formulas, GivenForce, Growth, Joint,
    JointKind, Line, Mass, Num, Part, Particle, Place, Planar, Push, Ray, RotaryInertia, Scene, Shape, Slope,
    Span, Start, Strut, Tie,
};
use crate::units::Unit;
use crate::units::spell;
use std::cell::{Cell, RefCell};

/// A datum as the scene sees it.
#[derive(Debug, Clone)]
pub struct DatumSymbol {
    /// Symbol, such as `mu_s`.
    pub name: String,
    /// Its unit; `None` if the bank's own is wrong (said elsewhere).
    pub unit: Option<Unit>,
    /// It is not there in this case (`draw: none`): a particle of such data is left out, a slope is level, a speed or spin
    /// at the start is 0.
    pub absent: bool,
}

/// Which of the contacts that do not say whether they roll or slip (`touches:`) slip: a bit for each, in the order of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Touching(u8);

impl Touching {
    /// All ways in which this many contacts can roll and slip, the one in which all roll first; of more than five the others roll.
    pub fn all(contacts: usize) -> impl Iterator<Item = Self> {
        (0..1 << contacts.min(5)).map(Self)
    }
    /// As these contacts are in a scene.
    pub fn of(touches: &[(usize, Num)], scene: &Scene) -> Self {
        let slips = |(i, (tie, _)): (usize, &(usize, Num))| {
            u8::from(matches!(scene.ties.get(*tie), Some(Tie::Slip { .. }))) << i
        };
        Self(touches.iter().take(5).enumerate().map(slips).sum())
    }
    /// Does this one slip?
    pub fn slips(self, contact: usize) -> bool {
        contact < 5 && self.0 >> contact & 1 == 1
    }
}

/// One use of a datum.
#[derive(Debug, Clone)]
pub struct DatumUse {
    /// Index of the datum.
    pub datum: usize,
    pub need: Need,
}

/// What was read of a scene, with the uses of the data.
#[derive(Debug, Clone, Default)]
pub struct SceneRead {
    /// The scene; `None` if anything is wrong with it.
    pub scene: Option<Scene>,
    /// Every use of a datum.
    pub uses: Vec<DatumUse>,
    /// Contacts that do not say whether they roll or slip: index of the tie, and the kinetic coefficient.
    pub touches: Vec<(usize, Num)>,
    /// Numbers that are `any`.
    pub any: Vec<AnyNumber>,
}

mod end;
mod next;
mod number;
mod planar;
mod ties;

struct SceneReader<'a> {
    symbols: &'a [DatumSymbol],
    /// Index of g among the data, after the symbols.
    gravity: usize,
    touching: Touching,
    faults: &'a Faults,
    /// What was met on the way, without the scene.
    met: RefCell<SceneRead>,
    /// Numbers that are worked out from data.
    derived: RefCell<Vec<Derived>>,
    /// Given forces that grow.
    growths: RefCell<Vec<Growth>>,
    /// The line of some body could not be read, so nothing is said of surfaces that are not used.
    lost: Cell<bool>,
    /// The start gives the angle of a pinned body.
    angled: Cell<bool>,
    /// The joint that acts in an impact alone.
    restitution: Cell<Option<(usize, Num)>>,
}

/// Reads a scene. `gravity` is the index of g among the data.
pub fn read(
    node: &Node,
    symbols: &[DatumSymbol],
    touching: Touching,
    gravity: usize,
    faults: &Faults,
) -> SceneRead {
    let before = faults.count();
    let reader = SceneReader {
        symbols,
        gravity,
        touching,
        faults,
        met: RefCell::default(),
        derived: RefCell::default(),
        growths: RefCell::default(),
        lost: Cell::default(),
        angled: Cell::default(),
        restitution: Cell::default(),
    };
    let scene = reader.scene(node, gravity).filter(|_| faults.count() == before);
    SceneRead { scene, ..reader.met.into_inner() }
}

/// The fields that give a body its inertia, of which it has one.
const INERTIA: [&str; 4] = ["shape", "radius of gyration", "moment of inertia", "parts"];
/// How a body on a fixed axle is written.
const FIXED: &str = "moves: about a fixed axle";

/// What does not go together in a body: the field that is too much, beside which others (with their text, if it matters),
/// where which others are not written; what is said of the body, and the hint.
type Exclusion = (&'static str, &'static [&'static str], &'static [&'static str], &'static str, &'static str);
const EXCLUDED: [Exclusion; 10] = [
    ("angle", &["moves"], &["pinned"], "`{}` moves along a line, so it has no angle", REMOVE),
    (
        "angle",
        &[],
        &["pinned", "moves"],
        "`{}` has an angle, but `pinned` is missing",
        "write `pinned: at its end` (a rod) or `pinned: {distance: h}`",
    ),
    ("weight", &["mass"], &[], "`{}` has a mass and a weight", "keep one of them"),
    ("mass", &["parts"], &[], SUM_OF_PARTS, REMOVE),
    ("weight", &["parts"], &["mass"], SUM_OF_PARTS, REMOVE),
    ("moves", &["pinned"], &[], NO_LINE, REMOVE),
    ("positive", &["pinned"], &[], NO_LINE, REMOVE),
    ("positive", &["angle"], &["moves"], NO_LINE, REMOVE),
    ("radii", &["pinned"], &[], NO_TIES, REMOVE),
    ("radii", &["angle"], &["moves"], NO_TIES, REMOVE),
];
const REMOVE: &str = "remove this field";
const SUM_OF_PARTS: &str = "the mass of a body made of parts is the sum of its parts";
const NO_LINE: &str = "a pinned body moves about its pin, not along a line";
const NO_TIES: &str = "nothing rolls on a pinned body and no cord is wound on it";

/// Is this field there, with this text if one is written after a colon?
fn holds(body: &Node, field: &str) -> bool {
    match field.split_once(": ") {
        Some((name, text)) => body.field(name).and_then(Node::text).is_some_and(|t| t.trim() == text),
        None => body.field(field).is_some(),
    }
}

/// Is this the mass of a light crank or rod in the plane, or of a light movable pulley, 0 kg?
fn is_light(body: &Node, mass: &Node) -> bool {
    let pulley = holds(body, "moves: vertically") && holds(body, "moment of inertia");
    let planar = ["moves: in the plane", "moves: in a horizontal plane"];
    (pulley || planar.iter().any(|moves| holds(body, moves)))
        && mass.text().is_some_and(|text| measure::constant(text.trim(), "kg").is_ok_and(|m| m == 0.0))
}

/// Tells what does not go together in a body.
fn excluded(name: &str, body: &Node, faults: &Faults) {
    for (field, beside, without, message, hint) in EXCLUDED {
        let too_much = beside.iter().all(|f| holds(body, f)) && !without.iter().any(|f| holds(body, f));
        if let Some(node) = body.field(field).filter(|_| too_much) {
            faults.hint(node, message.replace("{}", name), hint);
        }
    }
}

struct NamedSurface<'n> {
    name: &'n str,
    slope: Slope,
}

/// Positive senses along a line, and whether that is up: of any line, and of a level one.
const SENSES: [(&str, bool); 6] =
    [("up", true), ("down", false), ("forward", true), ("right", true), ("back", false), ("left", false)];

impl SceneReader<'_> {
    fn scene(&self, node: &Node, gravity: usize) -> Option<Scene> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a scene (bodies, ties, start, end)", f)?;
        let surfaces = fields.get("surfaces").map_or_else(Vec::new, |n| self.surfaces(n));
        let carried_node = fields.get("carried");
        let carried = carried_node.and_then(|n| self.carrier(n, &surfaces));
        let bodies_node = fields.need("bodies", "{wheel: {mass: m, moves: vertically}}");
        let along = carried_node.and_then(|n| n.field("along")).and_then(Node::text).map(str::trim);
        let mut bodies = bodies_node.map_or_else(Vec::new, |n| self.bodies(n, &surfaces, along));
        let ties = fields.get("ties").map_or_else(Vec::new, |n| self.ties(n, &bodies));
        let start_node = fields.get("start");
        let start = start_node.map_or_else(Vec::new, |n| self.start(n, &mut bodies));
        let mut joints = fields.get("joints").map_or_else(Vec::new, |n| self.joints(n, &bodies));
        joints.extend(bodies.iter().enumerate().filter_map(|(i, body)| body.pin(i)));
        let forces = fields.get("forces").map_or_else(Forces::default, |n| self.forces(n, &mut bodies));
        let Forces { couples, pushes, struts } = forces;
        let end_node = fields.need("end", "{travel: {of: wheel, by: d}}");
        let end = end_node.and_then(|n| self.end(n, &bodies, &ties, &joints));
        let stays = end_node.is_some_and(|n| n.field("stops slipping").is_some());
        let next_node = fields.get("next");
        let (end, heading) = end?;
        if let [body] = &bodies[..]
            && body.is_pinned()
            && !self.angled.get()
            && !matches!(end, End::AtOnce)
        {
            f.hint(
                start_node.unwrap_or(node),
                format!("the angle at which `{}` starts is missing", body.name),
                format!("write `start: {{{}: {{angle: phi0}}}}`", body.name),
            );
        }
        if let [Body { planar: Some(planar), .. }] = &mut bodies[..]
            && planar.pinned
        {
            planar.start_deg.get_or_insert(Num::Fixed(0.0));
        }
        let below = self.below(&ties, &bodies, &joints);
        let mut scene = Scene {
            gravity_m_s2: Num::Datum(gravity),
            bodies,
            ties,
            couples,
            joints,
            restitution: self.restitution.take(),
            pushes,
            struts,
            growths: self.growths.take(),
            carried,
            start,
            end,
            heading,
            span: Span::default(),
            formulas: Formulas { numbers: self.derived.take(), stays, below, ..Formulas::default() },
        };
        scene.still_turns();
        scene.round_from_start();
        if let Some(lead) = scene.lead()
            && !matches!(scene.end, End::Time(..))
            && scene.ending_coordinate().body != lead
        {
            let [asked, leads] =
                [scene.ending_coordinate().body, lead].map(|body| scene.bodies[body].name.as_str());
            let other = match scene.bodies[scene.ending_coordinate().body].turns {
                true => format!(", or give the angle at the start of `{asked}` in its place"),
                false => String::new(),
            };
            f.hint(
                end_node.unwrap_or(node),
                format!("the motion is followed by the angle of `{leads}`, not by that of `{asked}`"),
                format!("end it at `of: {leads}`{other}"),
            );
        }
        if let Some(n) = next_node {
            let next = self.next(n, node, &scene, gravity)?;
            scene.formulas.others.push((AsIf::Next, next));
        }
        Some(scene)
    }

    /// Kinetic and static coefficients of contacts that may roll or slip, and roll here: their tie has no kinetic one. Masses that are taken
    /// away, and those from which they are.
    fn below(&self, ties: &[Tie], bodies: &[Body], joints: &[Joint]) -> Vec<(Num, Num)> {
        let rolls = |(tie, mu_k): &(usize, Num)| match ties.get(*tie) {
            Some(Tie::Roll { mu_s: Some(mu_s), .. }) => Some((*mu_k, *mu_s)),
            _ => None,
        };
        let holes = joints.iter().filter_map(|joint| {
            let JointKind::Hinge { one, other, turned_deg: Some(_) } = joint.kind else { return None };
            let [one, other] = [one, other].map(|spot| &bodies[spot.body]);
            let (hole, whole) = if other.removed { (other, one) } else { (one, other) };
            match (hole.removed && !whole.removed, &hole.mass, &whole.mass) {
                (true, Mass::Kilograms(hole), Mass::Kilograms(whole)) => Some((*hole, *whole)),
                _ => None,
            }
        });
        self.met.borrow().touches.iter().filter_map(rolls).chain(holes).collect()
    }

    /// Mass or weight of a body or of a part, if one of them is given.
    fn given_mass(&self, mass: Option<&Node>, weight: Option<&Node>) -> Option<Mass> {
        match (mass, weight) {
            (Some(n), None) => self.number(n, Need::MASS).map(Mass::Kilograms),
            (None, Some(n)) => self.number(n, Need::WEIGHT).map(Mass::Weight),
            _ => None,
        }
    }

    /// One word out of a list, said in one of its spellings.
    fn word<T: Copy>(&self, node: &Node, what: &str, words: &[(&str, T)]) -> Option<T> {
        self.among(node, what, words.len(), &|i| words[i].0).map(|i| words[i].1)
    }
    /// Which of so many words it is: one function for all that they may mean.
    fn among<'w>(
        &self,
        node: &Node,
        what: &str,
        count: usize,
        word: &dyn Fn(usize) -> &'w str,
    ) -> Option<usize> {
        let text = node.text().unwrap_or("").split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
        let found = (0..count).find(|i| word(*i) == text);
        found.or_else(|| {
            let hint = spell::hint(&text, "words known here", (0..count).map(word));
            self.faults.expected(node, what, hint)
        })
    }

    /// The place of what is called so, among those of a kind.
    fn called<'s>(
        &self,
        node: &Node,
        (what, kind): (&str, &str),
        names: impl Iterator<Item = &'s str> + Clone,
    ) -> Option<usize> {
        let text = node.text().unwrap_or("").trim();
        let found = names.clone().position(|name| name == text);
        found.or_else(|| self.faults.expected(node, what, spell::hint(text, kind, names)))
    }

    fn one<'n>(&self, node: &'n Node, what: &str) -> Option<(&'n str, &'n Node, &'n Node)> {
        match &node.value {
            Value::Map(entries) if entries.len() == 1 => {
                let (key, value) = &entries[0];
                Some((key.text().unwrap_or(""), key, value))
            }
            _ => self.faults.refuse(node, format!("expected {what}, found {}", node.kind())),
        }
    }

    fn unknown(&self, key: &Node, what: &str, known: &[&str]) {
        let text = key.text().unwrap_or("");
        let hint = spell::hint(text, "known", known.iter().copied());
        self.faults.hint(key, format!("`{}` is no {what}", shorten(text)), hint);
    }

    fn surfaces<'n>(&self, node: &'n Node) -> Vec<NamedSurface<'n>> {
        let mut list = Vec::new();
        for (name, _, value) in named(node, "surfaces by name", self.faults) {
            let slope = match &value.value {
                Value::Map(_) => Fields::open(value, "a slope", self.faults).and_then(|mut fields| {
                    let slope = fields.need("slope", "theta");
                    // One that cannot be read is some incline, along which bodies move up and down.
                    let degrees = |n| Slope::Degrees(self.number(n, Need::SLOPE).unwrap_or(Num::Fixed(1.0)));
                    slope.filter(|n| !self.absent(n)).map(degrees)
                }),
                _ => self.word(
                    value,
                    "`level`, `vertical` or `{slope: theta}`",
                    &[("level", Slope::Level), ("horizontal", Slope::Level), ("vertical", Slope::Vertical)],
                ),
            };
            // A slope that is wrong is a finding already; the name stays known, so that no other finding follows from it.
            list.push(NamedSurface { name, slope: slope.unwrap_or(Slope::Level) });
        }
        list
    }

    /// What carries the scene: along which line, its speed and its acceleration.
    fn carrier(&self, node: &Node, surfaces: &[NamedSurface]) -> Option<Carrier> {
        let f = self.faults;
        let mut fields = Fields::open(node, "what carries the scene (along, speed, acceleration)", f)?;
        let along = fields.need("along", "horizontal");
        let [speed, acceleration] = fields.each(["speed", "acceleration"]);
        if speed.is_none() && acceleration.is_none() {
            f.hint(node, "neither a speed nor an acceleration is given", "write `acceleration: a`");
        }
        let mut words: Vec<(&str, Slope)> = surfaces.iter().map(|s| (s.name, s.slope)).collect();
        words.extend([("horizontal", Slope::Level), ("level", Slope::Level), ("vertical", Slope::Vertical)]);
        let what = "along which line the scene is carried: a surface, `horizontal` or `vertical`";
        let slope = along.and_then(|n| {
            let own = surfaces.iter().find(|s| n.text().map(str::trim) == Some(s.name));
            own.map(|s| s.slope).or_else(|| self.word(n, what, &words))
        });
        let number = |n: Option<&Node>, need| n.map_or(Some(Num::Fixed(0.0)), |n| self.number(n, need));
        let (speed, acceleration) = (number(speed, Need::VELOCITY), number(acceleration, Need::ACCELERATION));
        Some(Carrier { slope: slope?, speed_m_s: speed?, acceleration_m_s2: acceleration? })
    }

    fn bodies(&self, node: &Node, surfaces: &[NamedSurface], carried_along: Option<&str>) -> Vec<Body> {
        let mut bodies = Vec::new();
        for (name, key, value) in
            some_named(node, "bodies by name", "a scene has at least one body", self.faults)
        {
            check_name(key, name, "a body", self.faults);
            bodies.push(self.body(name, value, surfaces));
        }
        let used = |surface: &NamedSurface| {
            let Value::Map(entries) = &node.value else { return false };
            let moves = entries.iter().filter_map(|(_, body)| body.field("moves")?.text());
            let mut on = moves.filter_map(|text| text.trim().strip_prefix("along")).map(str::trim);
            on.any(|on| on == surface.name) || carried_along == Some(surface.name)
        };
        for surface in surfaces.iter().filter(|s| !self.lost.get() && !used(s)) {
            self.faults.hint(
                node,
                format!("nothing moves along the surface `{}`", surface.name),
                "remove the surface, or write `moves: along ...`",
            );
        }
        bodies
    }

    fn body(&self, name: &str, node: &Node, surfaces: &[NamedSurface]) -> Body {
        let f = self.faults;
        let mut body = Body { name: name.to_owned(), ..Body::default() };
        let Some(mut fields) = Fields::open(node, "a body (mass, moves, ...)", f) else { return body };
        if let Some(particles) = fields.get("particles") {
            body.turns = true;
            body.particles = self.particles(particles);
            return body;
        }
        for (about, _) in crate::bank::synonyms::ABOUT_PIN {
            if let Some(n) = node.field(about).and_then(|_| fields.get(about)) {
                let hint = "make data of this, of the distance from the pin to the mass centre, and of the mass, or give all as constants; it is no smaller than that of the mass at its mass centre";
                f.hint(n, format!("`{about}` cannot be put about the mass centre"), hint);
            }
        }
        let [mass, weight] = fields.each(["mass", "weight"]);
        let inertia = fields.each(INERTIA);
        let moves = node.field("moves").and_then(Node::text).map_or("", str::trim);
        if planar::PLANES.contains(&moves) {
            fields.get("moves");
            self.inertia(inertia, &mut body);
            body.turns = inertia.iter().flatten().next().is_some();
            let removed = fields.get("mass removed");
            body.removed = removed.is_some();
            if let (Some(n), Some(_)) = (removed, mass.or(weight)) {
                f.hint(n, format!("`{name}` has a mass, and a mass that is taken away"), "keep one of them");
            }
            body.mass = self.mass(node, mass.or(removed), weight);
            body.planar = Some(self.planar(&mut fields, &body, moves == planar::PLANES[1]));
            return body;
        }
        let [pinned, angle, moves, positive] = fields.each(["pinned", "angle", "moves", "positive"]);
        let given = inertia.iter().flatten().count();
        if given > 1 {
            f.hint(
                node,
                format!("`{name}` has its inertia given {given} times"),
                "keep one of `shape`, `radius of gyration`, `moment of inertia`, `parts`",
            );
        }
        let rim = self.inertia(inertia, &mut body);
        body.turns = given > 0;
        let swings = pinned.or(angle.filter(|_| moves.is_none()));
        if swings.is_none() && moves.is_none() {
            // Said with its example.
            fields.need("moves", "along incline");
        }
        body.mass = self.mass(node, mass, weight);
        excluded(name, node, f);
        if let Some(swings) = swings {
            if given == 0 {
                f.hint(
                    node,
                    format!("`{name}` has no inertia, so it cannot swing"),
                    "give it a `shape`, a `radius of gyration` or a `moment of inertia`",
                );
            }
            body.turns = true;
            let mut planar = self.pin(pinned, swings, angle, &body);
            planar.points.extend(fields.get("points").into_iter().flat_map(|n| self.points(n, body.rod())));
            body.planar = Some(planar);
            fields.get("radii");
            return body;
        }
        body.line = match moves.map(|n| self.line(n, positive, surfaces)) {
            Some(Ok(line)) => line,
            Some(Err(())) | None => {
                // It is a finding already; a line is assumed, so that no other finding follows from it.
                self.lost.set(true);
                let slope = surfaces.first().map_or(Slope::Vertical, |s| s.slope);
                Some(Line { slope, forward_up: true, surface: !surfaces.is_empty() })
            }
        };
        if let Some(n) = fields.get("radii") {
            body.radii_m = self.radii(n);
        }
        if let Some(radius) = rim
            && !body.radii_m.iter().any(|(n, _)| n == "rim")
        {
            body.radii_m.push(("rim".to_owned(), radius));
        }
        body
    }

    /// Sets the inertia by the fields of [`INERTIA`]; gives the radius of the rim, where a shape has one.
    fn inertia(&self, [shape, gyration, moment, parts]: [Option<&Node>; 4], body: &mut Body) -> Option<Num> {
        if let Some(n) = gyration {
            body.inertia = self.number(n, Need::GYRATION).map(RotaryInertia::Gyration);
        } else if let Some(n) = moment {
            body.inertia = self.number(n, Need::INERTIA).map(RotaryInertia::Moment);
        } else if let Some(n) = shape {
            let (word, key, radius) = self.one(n, "a shape such as `{disc: R}`")?;
            let known = shape_of(word);
            if known.is_none() {
                self.unknown(key, "shape", SHAPES);
            }
            let rod = known == Some(Shape::Rod);
            let radius = self.number(radius, if rod { Need::ROD } else { Need::RADIUS });
            body.inertia = known.zip(radius).map(|(s, r)| RotaryInertia::Shape(s, r));
            // A rod has a length where the others have a rim.
            return radius.filter(|_| !rod);
        } else if let Some(n) = parts {
            body.inertia = Some(RotaryInertia::Parts(self.parts(n)));
        }
        None
    }

    /// The mass of a body, by its mass or its weight.
    fn mass(&self, node: &Node, mass: Option<&Node>, weight: Option<&Node>) -> Mass {
        let given = match (mass, weight) {
            (Some(n), None) if is_light(node, n) => {
                let turns = |n: &Node| measure::constant(n.text().unwrap_or("").trim(), "kg*m^2") != Ok(0.0);
                if node.field("moment of inertia").is_some_and(turns) {
                    let hint = "leave out the moment of inertia, or give it a mass";
                    self.faults.hint(n, "what has a moment of inertia has a mass", hint);
                }
                Some(Mass::Kilograms(Num::Fixed(0.0)))
            }
            // The mass of a body on a fixed axle whose moment of inertia is given enters but the force of the axle.
            (None, None)
                if !(holds(node, "parts") || holds(node, FIXED) && holds(node, "moment of inertia")) =>
            {
                self.faults.refuse_with(node, "`mass` is missing", "write `mass: m`, or `weight: W`")
            }
            // That there are both is told elsewhere.
            _ => self.given_mass(mass, weight),
        };
        given.unwrap_or(Mass::OfParts)
    }

    fn radii(&self, node: &Node) -> Vec<(String, Num)> {
        let mut radii = Vec::new();
        for (radius, key, value) in named(node, "radii by name", self.faults) {
            if !plain_name(radius) {
                let message = format!("`{}` is no name for a radius", shorten(radius));
                self.faults.hint(key, message, "a name such as `rim`");
            }
            // The use is recorded when a tie acts at this radius.
            let before = self.met.borrow().uses.len();
            if let Some(num) = self.number(value, Need::RADIUS) {
                self.met.borrow_mut().uses.truncate(before);
                radii.push((radius.to_owned(), num));
            }
        }
        radii
    }

    /// The pin of a body; the start gives the angle, forces the spring.
    fn pin(&self, pinned: Option<&Node>, node: &Node, angle: Option<&Node>, body: &Body) -> Planar {
        let f = self.faults;
        let zeros = [("from upright", Ray::Up), ("from hanging", Ray::Down)];
        let from = match angle {
            Some(n) => self.word(n, "from where the angle counts", &zeros),
            None => f.refuse_with(
                node,
                format!("`angle` of `{}` is missing", body.name),
                "write `angle: from upright` (mass centre above the pin) or `angle: from hanging`",
            ),
        };
        let arm = pinned.and_then(|node| match &node.value {
            Value::Map(_) => Fields::open(node, "where it is pinned", f).and_then(|mut fields| {
                let distance = self.need_number(&mut fields, "distance", "h", Need::ARM);
                distance.map(Place::At)
            }),
            _ => match (
                self.word(
                    node,
                    "`at its end` or `{distance: h}`",
                    &[("at its end", ()), ("at one end", ()), ("at the end", ())],
                ),
                &body.inertia,
            ) {
                (Some(()), Some(RotaryInertia::Shape(Shape::Rod, length))) => Some(Place::HalfOf(*length)),
                (Some(()), Some(_)) => f.refuse_with(
                    node,
                    format!("`{}` is no rod, so it has no end", body.name),
                    "write `pinned: {distance: h}` with the distance from the pin to the mass centre",
                ),
                _ => None,
            },
        });
        // What is wrong is a finding already; the body stays pinned, so that no other finding follows from it.
        Planar::pinned(arm.unwrap_or(Place::At(Num::Fixed(1.0))), from.unwrap_or(Ray::Down), None)
    }

    fn line(
        &self,
        moves: &Node,
        positive: Option<&Node>,
        surfaces: &[NamedSurface],
    ) -> Result<Option<Line>, ()> {
        let text = moves.text().unwrap_or("").trim();
        let (slope, surface) = if text == "about a fixed axle" {
            if let Some(n) = positive {
                self.faults.hint(n, "a body on a fixed axle does not move along a line", "remove this field");
            }
            return Ok(None);
        } else if text == "vertically" {
            (Slope::Vertical, false)
        } else if let Some(on) = text.strip_prefix("along ") {
            let on = on.trim().trim_start_matches("the ");
            match surfaces.iter().find(|s| s.name == on) {
                Some(s) => (s.slope, true),
                None => {
                    let hint = if surfaces.is_empty() {
                        "name it under `surfaces`, for example `surfaces: {incline: {slope: theta}}`"
                            .to_owned()
                    } else {
                        spell::hint(on, "surfaces", surfaces.iter().map(|s| s.name))
                    };
                    self.faults.hint(moves, format!("`{}` is no surface of this scene", shorten(on)), hint);
                    return Err(());
                }
            }
        } else {
            self.faults.hint(
                moves,
                format!("expected how the body moves, found {}", moves.kind()),
                "`along SURFACE`, `vertically`, `about a fixed axle` or `in the plane`",
            );
            return Err(());
        };
        // Down a slope and on along a level floor, in the motion that follows, a body keeps its positive sense.
        let words = if slope == Slope::Level { &SENSES[..] } else { &SENSES[..2] };
        let forward_up =
            positive.map_or(Some(true), |n| self.word(n, "the positive sense", words)).ok_or(())?;
        Ok(Some(Line { slope, forward_up, surface }))
    }

    fn particles(&self, node: &Node) -> Vec<Particle> {
        let f = self.faults;
        let mut list = Vec::new();
        let mut left_out = 0;
        for (name, _, value) in named(node, "particles by name", f) {
            if matches!(value.value, Value::Map(_)) && self.all_absent(value) {
                left_out += 1;
                continue;
            }
            let Some(mut fields) = Fields::open(value, "a particle (mass, at)", f) else { continue };
            let mass = self.need_number(&mut fields, "mass", "m_A", Need::MASS);
            let at = fields.need("at", "[x_A, y_A]").and_then(|n| self.place(n));
            if let Some((mass_kg, [x_m, y_m])) = mass.zip(at) {
                list.push(Particle { name: name.to_owned(), mass_kg, x_m, y_m });
            }
        }
        if let Value::Map(m) = &node.value
            && m.len() < 2 + left_out
        {
            f.at(node, "a body of particles has at least two of them");
        }
        list
    }

    fn parts(&self, node: &Node) -> Vec<Part> {
        let f = self.faults;
        let what = "a list of parts such as `- disc: {mass: m1, radius: R}`";
        let Some(items) = items(node, what, f) else { return Vec::new() };
        if items.is_empty() {
            f.at(node, "a body made of parts has at least one");
        }
        let mut list = Vec::new();
        for item in items {
            let Some((word, key, value)) = self.one(item, "a part such as `disc: {mass: m1, radius: R}`")
            else {
                continue;
            };
            let shape = shape_of(word);
            if shape.is_none() {
                self.unknown(key, "shape", SHAPES);
            }
            let Some(mut fields) = Fields::open(value, "mass and radius of the part", f) else { continue };
            let [mass, weight] = fields.each(["mass", "weight"]);
            if mass.is_some() == weight.is_some() {
                f.hint(value, "a part has a mass or a weight", "write `mass: m1`");
            }
            let mass = self.given_mass(mass, weight);
            let radius = self.need_number(&mut fields, "radius", "R", Need::RADIUS);
            if let (Some(mass), Some(shape), Some(radius_m)) = (mass, shape, radius) {
                list.push(Part { mass, shape, radius_m });
            }
        }
        list
    }

    fn body_named(&self, node: &Node, bodies: &[Body]) -> Option<usize> {
        self.called(node, ("a body of this scene", "bodies"), bodies.iter().map(|b| b.name.as_str()))
    }

    fn need_body(&self, fields: &mut Fields, name: &'static str, bodies: &[Body]) -> Option<usize> {
        let example = bodies.first().map_or("wheel", |b| b.name.as_str());
        fields.need(name, example).and_then(|n| self.body_named(n, bodies))
    }

    fn forces(&self, node: &Node, bodies: &mut [Body]) -> Forces {
        let f = self.faults;
        let what = "a list of forces, each after `- `";
        let Some(items) = items(node, what, f) else { return Forces::default() };
        let mut list = Forces::default();
        for item in items {
            let Some((word, key, value)) =
                self.one(item, "a force such as `couple: {on: wheel, moment: M, sense: forward}`")
            else {
                continue;
            };
            let springs = list.struts.len();
            match word {
                "force" | "impulse" => {
                    let blow = word == "impulse";
                    let count = list.pushes.iter().filter(|p| p.blow == blow).count();
                    list.pushes.extend(self.push(value, bodies, count, blow));
                }
                "torsion" => list.struts.extend(self.torsion(value, bodies, springs)),
                "spring" if bodies.iter().any(|b| b.planar.is_some() && !b.is_pinned()) => {
                    list.struts.extend(self.strut(value, bodies, springs));
                }
                "spring" => list.struts.extend(self.pin_spring(value, bodies, springs)),
                "couple" => list.couples.extend(self.couple(value, bodies, list.couples.len())),
                _ => self.unknown(key, "force", &["couple", "force", "impulse", "spring", "torsion"]),
            }
        }
        list
    }

    fn couple(&self, node: &Node, bodies: &[Body], count: usize) -> Option<Couple> {
        let mut fields = Fields::open(node, "a couple (on, moment, sense)", self.faults)?;
        let body = self.need_body(&mut fields, "on", bodies);
        let moment = self.need_number(&mut fields, "moment", "M", Need::MOMENT);
        let senses = [("forward", true), ("back", false)];
        let forward =
            fields.get("sense").map_or(Some(true), |n| self.word(n, "the sense of the couple", &senses));
        self.grows(fields.get("growing by"), GivenForce::Couple(count));
        let body = body?;
        if !bodies[body].turns {
            let message = format!("`{}` has no inertia, so a couple cannot turn it", bodies[body].name);
            return self.faults.refuse(node, message);
        }
        Some(Couple { body, moment_n_m: moment?, forward: forward? })
    }

    /// A spring between a fixed anchor and a point of a pinned body.
    fn pin_spring(&self, node: &Node, bodies: &mut [Body], count: usize) -> Option<Strut> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a spring (on, at, anchor, stiffness, natural length)", f)?;
        let body = self.need_body(&mut fields, "on", bodies);
        let at = self.need_number(&mut fields, "at", "b", Need::RADIUS);
        let anchor = fields.need("anchor", "[x_A, y_A]").and_then(|n| self.place(n));
        let stiffness = self.need_number(&mut fields, "stiffness", "ks", Need::STIFFNESS);
        let rest = self.natural(node, &mut fields, Need::LENGTH);
        let name = &bodies[body?].name;
        if !bodies[body?].is_pinned() {
            return f.refuse_with(
                node,
                format!("`{name}` is not pinned"),
                "a spring on a cord is written `cord: {from: ..., spring: {...}}` under `ties`",
            );
        }
        if count > 0 {
            f.hint(node, format!("`{name}` has a spring already"), "a scene has at most one spring");
        }
        bodies[body?].spring(body?, at?, anchor?, (stiffness?, rest?))
    }

    fn start(&self, node: &Node, bodies: &mut [Body]) -> Vec<Start> {
        let f = self.faults;
        if node.text().is_some_and(|t| matches!(t.trim(), "at rest" | "from rest")) {
            return Vec::new();
        }
        if !matches!(node.value, Value::Map(_)) {
            let hint = "`at rest`, or for example `{wheel: {speed: v0}}`";
            return f.expected(node, "the start", hint).unwrap_or_default();
        }
        let mut list = Vec::new();
        for (name, key, value) in named(node, "bodies with their speeds", f) {
            let known = bodies.iter().map(|b| b.name.as_str());
            let Some(body) = known_as(name, key, "body of this scene", known, f) else { continue };
            let Some(mut fields) = Fields::open(value, "a speed, such as `{speed: v0}`", f) else { continue };
            if bodies[body].particles.is_empty() {
                let angled = bodies[body].planar.is_some();
                let angle = if angled { fields.get("angle") } else { None };
                let speed = fields.get("speed");
                let spin = fields.get("spin");
                let driven = if bodies[body].turns && angled { fields.get("alpha") } else { None };
                if let (Some(n), Some(planar)) = (driven, &mut bodies[body].planar) {
                    planar.driven = self.number(n, Need::ANGULAR_ACCELERATION);
                }
                if let Some(n) = angle {
                    self.angled.set(true);
                    let angle = self.number(n, Need::ANGLE);
                    if let Some(planar) = &mut bodies[body].planar {
                        planar.start_deg = angle;
                    }
                }
                let arrives = if angled { fields.get("arrives") } else { None };
                if let (Some(n), Some(planar)) = (arrives, &mut bodies[body].planar) {
                    planar.arrives = self.arrives(n, bodies[body].turns);
                }
                if speed.is_none() && spin.is_none() && angle.is_none() && arrives.is_none() {
                    f.hint(value, "no speed is given", "write `{speed: v0}` or `{spin: w0}`");
                }
                if let Some(n) = speed {
                    if bodies[body].line.is_none() && (!angled || bodies[body].is_pinned()) {
                        f.hint(n, format!("`{name}` does not move along a line"), "write `spin:`");
                    } else if let Some(v) = self.at_start(n, Need::VELOCITY) {
                        list.push(Start::Speed(Coordinate { body, degree: Degree::Along }, v));
                    }
                }
                if let Some(n) = spin {
                    if !bodies[body].turns {
                        f.hint(n, format!("`{name}` does not turn"), "write `speed:`");
                    } else if let Some(w) = self.at_start(n, Need::SPIN) {
                        list.push(Start::Speed(Coordinate { body, degree: Degree::Turn }, w));
                    }
                }
                continue;
            }
            let names = bodies[body].particles.iter().map(|p| p.name.as_str());
            let particle = fields
                .need("velocity of", "A")
                .and_then(|n| self.called(n, ("a particle", "particles"), names));
            let vx = self.need_number(&mut fields, "x", "vx", Need::VELOCITY);
            let vy = self.need_number(&mut fields, "y", "vy", Need::VELOCITY);
            let spin = self.need_number(&mut fields, "spin", "omega", Need::SPIN);
            if let (Some(particle), Some(vx_m_s), Some(vy_m_s), Some(spin_rad_s)) = (particle, vx, vy, spin) {
                list.push(Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s });
            }
        }
        list
    }
}

/// What stands under `forces`.
#[derive(Default)]
struct Forces {
    couples: Vec<Couple>,
    pushes: Vec<Push>,
    struts: Vec<Strut>,
}

#[rustfmt::skip] // a table
const SHAPES: &[&str] = &[
    "disc", "disk", "cylinder", "solid cylinder", "hoop", "ring", "hollow cylinder", "sphere", "ball",
    "shell", "hollow sphere", "rod",
];

fn shape_of(word: &str) -> Option<Shape> {
    match word {
        "disc" => Some(Shape::Disc),
        "hoop" => Some(Shape::Hoop),
        "sphere" => Some(Shape::Sphere),
        "shell" => Some(Shape::Shell),
        "rod" => Some(Shape::Rod),
        _ => None,
    }
}

/// Tells of a name that is none for such a thing.
fn check_name(key: &Node, name: &str, what: &str, faults: &Faults) {
    if !plain_name(name) {
        let hint = "letters, digits and `_`, beginning with a letter";
        faults.hint(key, format!("`{}` is no name for {what}", shorten(name)), hint);
    }
}

/// Letters, digits, `_`; begins with a letter; short.
pub fn plain_name(text: &str) -> bool {
    text.len() <= 64
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}
