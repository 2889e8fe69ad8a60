//! The `scene` part of a problem: bodies, ties, forces, start and end, read into pure data.
use crate::bank::any::AnyNumber;
use crate::bank::expression::{Exponents, Expression, Name};
use crate::bank::measure;
use crate::bank::need::Need;
use crate::bank::node::{Faults, Fields, Node, Value, WHOLE, named, shorten};
use crate::finding::told;
use crate::num::formula::{Formula, Step};
use crate::scene::{
    Arm, AsIf, Attach, Body, Carrier, Coordinate, Cord, CordEnd, Couple, Degree, Derived, End, Far, Formulas,
    Given, GivenForce, Grows, Growth, Heading, Joint, Law, Line, Made, Mass, Num, Part, Particle, Pin,
    PinSpring, Push, RotaryInertia, Scene, Shape, Side, Slope, Span, Start, Strut, Tie, Zero,
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
    /// What for.
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

mod next;
mod planar;

struct SceneReader<'a> {
    symbols: &'a [DatumSymbol],
    /// Index of g among the data, after the symbols.
    gravity: usize,
    touching: Touching,
    faults: &'a Faults,
    touches: RefCell<Vec<(usize, Num)>>,
    uses: RefCell<Vec<DatumUse>>,
    /// Numbers that are worked out from data.
    derived: RefCell<Vec<Derived>>,
    /// Given forces that grow.
    growths: RefCell<Vec<Growth>>,
    /// Those that are `any`.
    any: RefCell<Vec<AnyNumber>>,
    /// The line of some body could not be read, so nothing is said of surfaces that are not used.
    lost: Cell<bool>,
    /// The start gives the angle of a pinned body.
    angled: Cell<bool>,
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
        touches: RefCell::new(Vec::new()),
        uses: RefCell::new(Vec::new()),
        derived: RefCell::new(Vec::new()),
        growths: RefCell::new(Vec::new()),
        any: RefCell::new(Vec::new()),
        lost: Cell::new(false),
        angled: Cell::new(false),
    };
    let scene = reader.scene(node, gravity).filter(|_| faults.count() == before);
    SceneRead {
        scene,
        uses: reader.uses.into_inner(),
        touches: reader.touches.into_inner(),
        any: reader.any.into_inner(),
    }
}

/// The fields that give a body its inertia, of which it has one.
const INERTIA: [&str; 4] = ["shape", "radius of gyration", "moment of inertia", "parts"];
/// What cords and light rods are called that have no name.
const UNNAMED: [&str; 2] = ["cord", "link"];
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

/// Is this the mass of a light crank or rod in the plane, 0 kg?
fn is_light(body: &Node, mass: &Node) -> bool {
    let planar =
        ["moves: in the plane", "moves: in a horizontal plane"].iter().any(|moves| holds(body, moves));
    planar && mass.text().is_some_and(|text| measure::constant(text.trim(), "kg").is_ok_and(|m| m == 0.0))
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

/// An end with a value: its word, the field of the value, an example of it, what it is along a line and in turning, and
/// what is made of it.
type EndRow = (&'static str, &'static str, &'static str, Need, Need, fn(Coordinate, Num) -> End);
const ENDS: [EndRow; 6] = [
    ("travel", "by", "d", Need::LENGTH, Need::TURN, End::Travel),
    ("turn", "by", "phi", Need::TURN, Need::TURN, End::Travel),
    ("position", "at", "s", Need::PLACE, Need::PLACE, End::Position),
    ("time", "is", "t1", Need::TIME, Need::TIME, End::Time),
    ("speed", "reaches", "v1", Need::SPEED_REACHED, Need::SPIN_REACHED, End::Speed),
    ("angle", "reaches", "phi1", Need::ANGLE, Need::ANGLE, End::Angle),
];

struct Surface<'n> {
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
        if let Some(n) = bodies_node
            && bodies.is_empty()
            && matches!(&n.value, Value::Map(m) if m.is_empty())
        {
            f.at(n, "a scene has at least one body");
        }
        let ties = fields.get("ties").map_or_else(Vec::new, |n| self.ties(n, &bodies));
        let joints = fields.get("joints").map_or_else(Vec::new, |n| self.joints(n, &bodies));
        let forces = fields.get("forces").map_or_else(Forces::default, |n| self.forces(n, &mut bodies));
        let Forces { couples, pushes, struts } = forces;
        let start_node = fields.get("start");
        let start = start_node.map_or_else(Vec::new, |n| self.start(n, &mut bodies));
        let end = fields
            .need("end", "{travel: {of: wheel, by: d}}")
            .and_then(|n| self.end(n, &bodies, &ties, &joints));
        let next_node = fields.get("next");
        fields.close();
        let (end, heading) = end?;
        if WHOLE
            && let Some(body) = bodies.iter().find(|b| b.pin.is_some())
            && !self.angled.get()
            && !matches!(end, End::AtOnce)
        {
            f.hint(
                start_node.unwrap_or(node),
                told!("the angle at which `{}` starts is missing", body.name),
                told!("write `start: {{{}: {{angle: phi0}}}}`", body.name),
            );
        }
        let mut scene = Scene {
            gravity_m_s2: Num::Datum(gravity),
            bodies,
            ties,
            couples,
            joints,
            pushes,
            struts,
            growths: self.growths.take(),
            carried,
            start,
            end,
            heading,
            span: Span::default(),
            formulas: Formulas { numbers: self.derived.take(), ..Formulas::default() },
        };
        scene.still_turns();
        if let Some(n) = next_node {
            let next = self.next(n, node, &scene, gravity)?;
            scene.formulas.others.push((AsIf::Next, next));
        }
        Some(scene)
    }

    /// Is this the symbol of a datum that is not there in this case?
    fn absent(&self, node: &Node) -> bool {
        let text = node.text().map(str::trim);
        self.symbols.iter().any(|s| s.absent && Some(s.name.as_str()) == text)
    }

    /// Is everything that is written in this node the symbol of such a datum?
    fn all_absent(&self, node: &Node) -> bool {
        match &node.value {
            Value::Map(fields) => !fields.is_empty() && fields.iter().all(|(_, v)| self.all_absent(v)),
            Value::List(items) => !items.is_empty() && items.iter().all(|v| self.all_absent(v)),
            _ => self.absent(node),
        }
    }

    /// A speed or a spin at the start: 0 where its datum is not there.
    fn at_start(&self, node: &Node, need: Need) -> Option<Num> {
        if self.absent(node) { Some(Num::Fixed(0.0)) } else { self.number(node, need) }
    }

    fn number(&self, node: &Node, need: Need) -> Option<Num> {
        let f = self.faults;
        let Some(text) = node.text().map(str::trim) else {
            let hint = told!("a symbol of the data, or a constant such as `{}`", need.example);
            f.hint(node, told!("expected {}, found {}", need.words, node.kind()), hint);
            return None;
        };
        if text == "any" {
            return self.any(node, need);
        }
        if let Some(datum) = self.symbols.iter().position(|s| s.name == text) {
            // A unit that is wrong is a finding already; the datum counts as used all the same.
            if let Some(unit) = self.symbols[datum].unit.as_ref().filter(|u| !measure::fits(u, need.unit)) {
                f.hint(
                    node,
                    told!("`{text}` has the unit {}, but it is used as {}", unit.ascii(), need.words),
                    told!("{} has a unit such as {}", need.words, need.unit),
                );
                return None;
            }
            self.uses.borrow_mut().push(DatumUse { datum, need });
            return Some(Num::Datum(datum));
        }
        if is_expression(text) {
            return self.derived(node, text, need, measure::own_powers(need.unit));
        }
        if text.is_empty() || text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            let known = self.symbols.iter().map(|s| s.name.as_str());
            let hint = spell::did_you_mean(text, known.clone()).unwrap_or_else(|| {
                told!(
                    "symbols: {}; or a constant such as `{}`",
                    known.collect::<Vec<_>>().join(", "),
                    need.example
                )
            });
            f.hint(node, told!("`{}` is no symbol of the data", shorten(text)), hint);
            return None;
        }
        match measure::constant(text, need.unit) {
            Ok(value) => match need.admits(value) {
                Ok(()) => return Some(Num::Fixed(value)),
                Err(message) => f.at(node, told!("`{}`: {message}", shorten(text))),
            },
            Err(message) => {
                f.hint(node, message, told!("{} is written like `{}`", need.words, need.example));
            }
        }
        None
    }

    /// A mass or a radius that cancels: 1 in its unit, which is proved to make no difference.
    fn any(&self, node: &Node, need: Need) -> Option<Num> {
        let text = match need.words {
            words if words == Need::MASS.words => "m",
            words if words == Need::RADIUS.words => "R",
            _ => {
                let message = told!("{} cannot be `any`", need.words);
                self.faults.hint(
                    node,
                    message,
                    "only a mass or the radius of a shape may be `any`, where it cancels",
                );
                return None;
            }
        };
        let formula = Formula::new(vec![Step::Number(1.0)]);
        let mut derived = self.derived.borrow_mut();
        derived.push(Derived { formula, degrees: false, text: text.to_owned(), any: true });
        let number = Num::Derived(derived.len() - 1);
        self.any.borrow_mut().push(AnyNumber { node: node.clone(), number });
        Some(number)
    }

    /// A number that is worked out from data, such as `2*R` or `-w0`, and the dimension that it has.
    fn derived(&self, node: &Node, text: &str, need: Need, wanted: Exponents) -> Option<Num> {
        let f = self.faults;
        let lookup = |name: &str| -> Result<(Name, Exponents), (String, Option<String>)> {
            if name == "g" {
                return Ok((Name::Datum(self.gravity, false), measure::own_powers("m/s^2")));
            }
            let Some(datum) = self.symbols.iter().position(|s| s.name == name) else {
                let known = self.symbols.iter().map(|s| s.name.as_str());
                let hint = spell::hint(name, "symbols", known);
                return Err((told!("`{}` is no symbol of the data", shorten(name)), Some(hint)));
            };
            let symbol = &self.symbols[datum];
            if symbol.absent {
                return Err((told!("`{name}` is not drawn"), Some("draw it, or leave it out".to_owned())));
            }
            let powers = symbol.unit.as_ref().map_or([0; 3], measure::powers);
            Ok((Name::Datum(datum, false), powers))
        };
        let mut read = Expression::parse(text, &lookup);
        if read.is_err() && self.symbols.iter().any(|s| s.unit.is_none()) {
            // A unit that is wrong is a finding already, and no sum can be judged without it.
            read = Expression::parse_loosely(text, &lookup);
        }
        let expression = read.map_err(|fault| fault.tell(node, text, f)).ok()?;
        let data: Vec<usize> = expression.data().collect();
        let own = |i: usize| self.symbols.get(i);
        let known = data.iter().all(|i| own(*i).is_none_or(|s| s.unit.is_some()));
        if known && expression.powers != wanted {
            let found = measure::powers_text(expression.powers);
            let message =
                told!("`{}` has the dimension {found}, but it is used as {}", shorten(text), need.words);
            f.hint(node, message, told!("{} has the dimension {}", need.words, measure::powers_text(wanted)));
            return None;
        }
        let mut uses = self.uses.borrow_mut();
        let symbols = data.iter().filter(|i| own(**i).is_some());
        uses.extend(symbols.map(|datum| DatumUse { datum: *datum, need: Need::TERM }));
        let powers = |i: usize| {
            let given = || own(i)?.unit.as_ref().map(measure::powers);
            let powers = if i == self.gravity { Some(measure::own_powers("m/s^2")) } else { given() };
            powers.unwrap_or_default().map(|p| p / 4)
        };
        let formula = expression.formula().map(&mut |name| match name {
            Name::Datum(datum, degrees) => Given { datum, degrees, powers: powers(datum) },
            Name::Quantity(_) | Name::Next(_) => Given { datum: usize::MAX, degrees: false, powers: [0; 3] },
        });
        let number = Derived { formula, degrees: need.in_degrees(), text: text.to_owned(), any: false };
        if data.is_empty() {
            let value = number.value(&[]);
            return match need.admits(value) {
                Ok(()) => Some(Num::Fixed(value)),
                Err(message) => {
                    f.at(node, told!("`{}`: {message}", shorten(text)));
                    None
                }
            };
        }
        let mut derived = self.derived.borrow_mut();
        let at = derived.iter().position(|d| *d == number).unwrap_or_else(|| {
            derived.push(number);
            derived.len() - 1
        });
        Some(Num::Derived(at))
    }

    /// A point, `[x, y]`.
    fn place(&self, node: &Node) -> Option<(Num, Num)> {
        match &node.value {
            Value::List(xy) if xy.len() == 2 => {
                self.number(&xy[0], Need::PLACE).zip(self.number(&xy[1], Need::PLACE))
            }
            _ => {
                let message = told!("expected a place such as `[x_A, y_A]`, found {}", node.kind());
                self.faults.at(node, message);
                None
            }
        }
    }

    fn need_number(
        &self,
        fields: &mut Fields,
        name: &'static str,
        example: &'static str,
        need: Need,
    ) -> Option<Num> {
        fields.need(name, example).and_then(|n| self.number(n, need))
    }

    /// One word out of a list, said in one of its spellings.
    fn word<T: Copy>(&self, node: &Node, what: &str, words: &[(&str, T)]) -> Option<T> {
        let text = node.text().unwrap_or("").split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
        if let Some((_, meaning)) = words.iter().find(|(w, _)| *w == text) {
            return Some(*meaning);
        }
        let hint = spell::hint(&text, "words known here", words.iter().map(|(w, _)| *w));
        self.faults.hint(node, told!("expected {what}, found {}", node.kind()), hint);
        None
    }

    fn one<'n>(&self, node: &'n Node, what: &str) -> Option<(&'n str, &'n Node, &'n Node)> {
        match &node.value {
            Value::Map(entries) if entries.len() == 1 => {
                let (key, value) = &entries[0];
                Some((key.text().unwrap_or(""), key, value))
            }
            _ => {
                self.faults.at(node, told!("expected {what}, found {}", node.kind()));
                None
            }
        }
    }

    fn unknown(&self, key: &Node, what: &str, known: &[&str]) {
        let text = key.text().unwrap_or("");
        let hint = spell::hint(text, "known", known.iter().copied());
        self.faults.hint(key, told!("`{}` is no {what}", shorten(text)), hint);
    }

    fn surfaces<'n>(&self, node: &'n Node) -> Vec<Surface<'n>> {
        let mut list = Vec::new();
        for (name, _, value) in named(node, "surfaces by name", self.faults) {
            let slope = match &value.value {
                Value::Map(_) => Fields::open(value, "a slope", self.faults).and_then(|mut fields| {
                    let slope = fields.need("slope", "theta");
                    fields.close();
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
            list.push(Surface { name, slope: slope.unwrap_or(Slope::Level) });
        }
        list
    }

    /// What carries the scene: along which line, its speed and its acceleration.
    fn carrier(&self, node: &Node, surfaces: &[Surface]) -> Option<Carrier> {
        let f = self.faults;
        let mut fields = Fields::open(node, "what carries the scene (along, speed, acceleration)", f)?;
        let along = fields.need("along", "horizontal");
        let [speed, acceleration] = fields.each(["speed", "acceleration"]);
        fields.close();
        if WHOLE && speed.is_none() && acceleration.is_none() {
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

    fn bodies(&self, node: &Node, surfaces: &[Surface], carried_along: Option<&str>) -> Vec<Body> {
        let mut bodies = Vec::new();
        for (name, key, value) in named(node, "bodies by name", self.faults) {
            if WHOLE && !plain_name(name) {
                self.faults.hint(
                    key,
                    told!("`{}` is no name for a body", shorten(name)),
                    "letters, digits and `_`, beginning with a letter",
                );
            }
            bodies.push(self.body(name, value, surfaces));
        }
        let used = |surface: &Surface| {
            let Value::Map(entries) = &node.value else { return false };
            let moves = entries.iter().filter_map(|(_, body)| body.field("moves")?.text());
            let mut on = moves.filter_map(|text| text.trim().strip_prefix("along")).map(str::trim);
            on.any(|on| on == surface.name) || carried_along == Some(surface.name)
        };
        for surface in surfaces.iter().filter(|s| !self.lost.get() && !used(s)) {
            self.faults.hint(
                node,
                told!("nothing moves along the surface `{}`", surface.name),
                "remove the surface, or write `moves: along ...`",
            );
        }
        bodies
    }

    fn body(&self, name: &str, node: &Node, surfaces: &[Surface]) -> Body {
        let f = self.faults;
        let mut body = Body {
            name: name.to_owned(),
            mass: Mass::OfParts,
            inertia: None,
            radii_m: Vec::new(),
            line: None,
            turns: false,
            particles: Vec::new(),
            pin: None,
            planar: None,
        };
        let Some(mut fields) = Fields::open(node, "a body (mass, moves, ...)", f) else { return body };
        if let Some(particles) = fields.get("particles") {
            body.turns = true;
            body.particles = self.particles(particles);
            fields.close();
            return body;
        }
        let [mass, weight] = fields.each(["mass", "weight"]);
        let inertia = fields.each(INERTIA);
        let moves = node.field("moves").and_then(Node::text).map_or("", str::trim);
        if planar::PLANES.contains(&moves) {
            fields.get("moves");
            self.inertia(inertia, &mut body);
            body.turns = inertia.iter().flatten().next().is_some();
            body.mass = self.mass(node, mass, weight);
            body.planar = Some(self.planar(&mut fields, &body, moves == planar::PLANES[1]));
            fields.close();
            return body;
        }
        let [pinned, angle, moves, positive] = fields.each(["pinned", "angle", "moves", "positive"]);
        let given = inertia.iter().flatten().count();
        if given > 1 {
            f.hint(
                node,
                told!("`{name}` has its inertia given {given} times"),
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
        if WHOLE {
            excluded(name, node, f);
        }
        if let Some(swings) = swings {
            if given == 0 {
                f.hint(
                    node,
                    told!("`{name}` has no inertia, so it cannot swing"),
                    "give it a `shape`, a `radius of gyration` or a `moment of inertia`",
                );
            }
            body.turns = true;
            body.pin = Some(self.pin(pinned, swings, angle, &body));
            fields.get("radii");
            fields.close();
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
        fields.close();
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
                if node.field("moment of inertia").is_some() {
                    let hint = "leave out the moment of inertia, or give it a mass";
                    self.faults.hint(n, "what has a moment of inertia has a mass", hint);
                }
                Some(Mass::Kilograms(Num::Fixed(0.0)))
            }
            (Some(n), None) => self.number(n, Need::MASS).map(Mass::Kilograms),
            (None, Some(n)) => self.number(n, Need::WEIGHT).map(Mass::Weight),
            // That there are both is told elsewhere.
            (Some(_), Some(_)) => None,
            (None, None) if node.field("parts").is_some() => None,
            // The mass of a body on a fixed axle whose moment of inertia is given enters but the force of the axle.
            (None, None) if holds(node, FIXED) && holds(node, "moment of inertia") => None,
            (None, None) => {
                self.faults.hint(node, "`mass` is missing", "write `mass: m`, or `weight: W`");
                None
            }
        };
        given.unwrap_or(Mass::OfParts)
    }

    fn radii(&self, node: &Node) -> Vec<(String, Num)> {
        let mut radii = Vec::new();
        for (radius, key, value) in named(node, "radii by name", self.faults) {
            if !plain_name(radius) {
                let message = told!("`{}` is no name for a radius", shorten(radius));
                self.faults.hint(key, message, "a name such as `rim`");
            }
            // The use is recorded when a tie acts at this radius.
            let before = self.uses.borrow().len();
            if let Some(num) = self.number(value, Need::RADIUS) {
                self.uses.borrow_mut().truncate(before);
                radii.push((radius.to_owned(), num));
            }
        }
        radii
    }

    /// The pin of a body; the start gives the angle, forces the spring.
    fn pin(&self, pinned: Option<&Node>, node: &Node, angle: Option<&Node>, body: &Body) -> Pin {
        let f = self.faults;
        let zeros = [
            ("from upright", Zero::Upright),
            ("upright", Zero::Upright),
            ("from hanging", Zero::Hanging),
            ("hanging", Zero::Hanging),
        ];
        let from = match angle {
            Some(n) => self.word(n, "from where the angle counts", &zeros),
            None => {
                f.hint(
                    node,
                    told!("`angle` of `{}` is missing", body.name),
                    "write `angle: from upright` (mass centre above the pin) or `angle: from hanging`",
                );
                None
            }
        };
        let arm = pinned.and_then(|node| match &node.value {
            Value::Map(_) => Fields::open(node, "where it is pinned", f).and_then(|mut fields| {
                let distance = self.need_number(&mut fields, "distance", "h", Need::ARM);
                fields.close();
                distance.map(Arm::Distance)
            }),
            _ => match (
                self.word(
                    node,
                    "`at its end` or `{distance: h}`",
                    &[("at its end", ()), ("at one end", ()), ("at the end", ())],
                ),
                &body.inertia,
            ) {
                (Some(()), Some(RotaryInertia::Shape(Shape::Rod, length))) => Some(Arm::HalfOf(*length)),
                (Some(()), Some(_)) => {
                    f.hint(
                        node,
                        told!("`{}` is no rod, so it has no end", body.name),
                        "write `pinned: {distance: h}` with the distance from the pin to the mass centre",
                    );
                    None
                }
                _ => None,
            },
        });
        // What is wrong is a finding already; the body stays pinned, so that no other finding follows from it.
        Pin {
            arm: arm.unwrap_or(Arm::Distance(Num::Fixed(1.0))),
            from: from.unwrap_or(Zero::Hanging),
            start_deg: Num::Fixed(0.0),
            spring: None,
        }
    }

    fn line(&self, moves: &Node, positive: Option<&Node>, surfaces: &[Surface]) -> Result<Option<Line>, ()> {
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
                    self.faults.hint(moves, told!("`{}` is no surface of this scene", shorten(on)), hint);
                    return Err(());
                }
            }
        } else {
            self.faults.hint(
                moves,
                told!("expected how the body moves, found {}", moves.kind()),
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
            let Some(mut fields) = Fields::open(value, "a particle (mass, at)", f) else { continue };
            if self.all_absent(value) {
                left_out += 1;
                continue;
            }
            let mass = self.need_number(&mut fields, "mass", "m_A", Need::MASS);
            let at = fields.need("at", "[x_A, y_A]").and_then(|n| self.place(n));
            fields.close();
            if let Some((mass_kg, (x_m, y_m))) = mass.zip(at) {
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
        let Value::List(items) = &node.value else {
            f.at(
                node,
                told!(
                    "expected a list of parts such as `- disc: {{mass: m1, radius: R}}`, found {}",
                    node.kind()
                ),
            );
            return Vec::new();
        };
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
            let mass = match (fields.get("mass"), fields.get("weight")) {
                (Some(n), None) => self.number(n, Need::MASS).map(Mass::Kilograms),
                (None, Some(n)) => self.number(n, Need::WEIGHT).map(Mass::Weight),
                _ => {
                    f.hint(value, "a part has a mass or a weight", "write `mass: m1`");
                    None
                }
            };
            let radius = self.need_number(&mut fields, "radius", "R", Need::RADIUS);
            fields.close();
            if let (Some(mass), Some(shape), Some(radius_m)) = (mass, shape, radius) {
                list.push(Part { mass, shape, radius_m });
            }
        }
        list
    }

    fn body_named(&self, node: &Node, bodies: &[Body]) -> Option<usize> {
        let text = node.text().unwrap_or("").trim();
        let found = bodies.iter().position(|b| b.name == text);
        if found.is_none() {
            let hint = spell::hint(text, "bodies", bodies.iter().map(|b| b.name.as_str()));
            self.faults.hint(node, told!("expected a body of this scene, found {}", node.kind()), hint);
        }
        found
    }

    fn need_body(&self, fields: &mut Fields, name: &'static str, bodies: &[Body]) -> Option<usize> {
        let example = bodies.first().map_or("wheel", |b| b.name.as_str());
        fields.need(name, example).and_then(|n| self.body_named(n, bodies))
    }

    /// The radius of a body at which a tie acts; this is what makes a radius used.
    fn radius(&self, node: &Node, body: &Body) -> Option<Num> {
        let text = node.text().unwrap_or("").trim();
        let Some((_, num)) = body.radii_m.iter().find(|(n, _)| n == text) else {
            let hint = if body.radii_m.is_empty() {
                told!("give `{}` a field `radii`, for example `radii: {{rim: R}}`", body.name)
            } else {
                let names = body.radii_m.iter().map(|(n, _)| n.as_str());
                spell::hint(text, &told!("radii of `{}`", body.name), names)
            };
            self.faults.hint(
                node,
                told!("expected a radius of `{}`, found {}", body.name, node.kind()),
                hint,
            );
            return None;
        };
        self.winds_on(*num);
        Some(*num)
    }

    /// Notes a radius as used.
    fn winds_on(&self, radius: Num) {
        let mut uses = self.uses.borrow_mut();
        match radius {
            Num::Datum(datum) => uses.push(DatumUse { datum, need: Need::RADIUS }),
            Num::Derived(at) => {
                let derived = self.derived.borrow();
                let given = derived.get(at).into_iter().flat_map(|n| n.formula.names());
                uses.extend(given.map(|g| DatumUse { datum: g.datum, need: Need::TERM }));
            }
            Num::Fixed(_) => {}
        }
    }

    fn ties(&self, node: &Node, bodies: &[Body]) -> Vec<Tie> {
        let f = self.faults;
        let Value::List(items) = &node.value else {
            f.at(node, told!("expected a list of ties, each after `- `, found {}", node.kind()));
            return Vec::new();
        };
        let mut ties: Vec<Tie> = Vec::new();
        for item in items {
            let Some((word, key, value)) =
                self.one(item, "a tie such as `rolls: {body: wheel, on its: hub}`")
            else {
                continue;
            };
            if word == "rests" {
                for cord in self.rests(value, bodies) {
                    let Far::Body(end) = cord.to else { continue };
                    let on =
                        |t: &Tie| matches!(t, Tie::Cord(c) if c.made == Made::Rests && c.name == cord.name);
                    if ties.iter().any(on) {
                        f.hint(
                            item,
                            told!("something rests on `{}` twice", bodies[end.body].name),
                            "keep one of them",
                        );
                    }
                    ties.push(Tie::Cord(cord));
                }
                continue;
            }
            let tie = match word {
                "rolls" | "slips" | "slides" | "touches" => self.contact(word, value, bodies, ties.len()),
                "cord" => self.cord(value, bodies, ties.len()).map(Tie::Cord),
                "link" => self.link(value, bodies).map(Tie::Cord),
                "meshes" | "belt" => {
                    let made = if word == "belt" { Made::Belt } else { Made::Teeth };
                    let like = ties.iter().filter(|t| matches!(t, Tie::Cord(c) if c.made == made)).count();
                    self.mesh(value, bodies, (made, like)).map(Tie::Cord)
                }
                _ => {
                    self.unknown(
                        key,
                        "tie",
                        &["rolls", "slips", "slides", "touches", "cord", "link", "meshes", "belt", "rests"],
                    );
                    None
                }
            };
            let Some(tie) = tie else { continue };
            if let Some(body) = contact_body(&tie)
                && ties.iter().filter_map(contact_body).any(|b| b == body)
            {
                f.hint(
                    item,
                    told!("`{}` touches its surface twice", bodies[body].name),
                    "keep one of `rolls`, `slips`, `slides`, `touches`",
                );
            }
            if let Tie::Cord(c) = &tie
                && !UNNAMED.contains(&c.name.as_str())
                && ties.iter().any(|t| matches!(t, Tie::Cord(o) if o.name == c.name))
            {
                f.hint(item, told!("two cords are called `{}`", c.name), "give each its own name");
            }
            ties.push(tie);
        }
        for name in UNNAMED {
            let unnamed = ties.iter_mut().filter_map(|t| match t {
                Tie::Cord(c) if c.name == name && !matches!(c.to, Far::Pull(_)) => Some(c),
                _ => None,
            });
            let unnamed: Vec<&mut Cord> = unnamed.collect();
            if unnamed.len() > 1 {
                // Several tensions need names; number the cords in the order of the file.
                unnamed.into_iter().enumerate().for_each(|(n, c)| c.name = format!("{name}{}", n + 1));
            }
        }
        ties
    }

    fn contact(&self, word: &str, node: &Node, bodies: &[Body], tie: usize) -> Option<Tie> {
        let f = self.faults;
        let mut fields = Fields::open(node, "the body and where it touches", f)?;
        let body = self.need_body(&mut fields, "body", bodies);
        let surface = body.is_none_or(|b| bodies[b].line.is_some_and(|l| l.surface));
        if !surface && body.is_some_and(|b| bodies[b].line.is_some() || bodies[b].turns) {
            f.hint(
                node,
                told!("`{}` touches no surface", body.map_or("", |b| &bodies[b].name)),
                "write `moves: along SURFACE`",
            );
        }
        if word == "slides" {
            let mu_k = self.need_number(&mut fields, "mu_k", "mu_k", Need::FRICTION);
            let mu_s = fields.get("mu_s").map(|n| self.number(n, Need::FRICTION));
            fields.close();
            if let Some(b) = body
                && bodies[b].turns
            {
                f.hint(
                    node,
                    told!("`{}` can turn, so it rolls or slips", bodies[b].name),
                    "write `rolls:` or `slips:`",
                );
                return None;
            }
            return Some(Tie::Slide { body: body?, mu_s: settle(mu_s)?, mu_k: mu_k? });
        }
        let on = fields.need("on its", "rim");
        let radius = body.zip(on).and_then(|(b, n)| self.radius(n, &bodies[b]));
        if let Some(b) = body
            && !bodies[b].turns
        {
            f.hint(
                node,
                told!("`{}` has no inertia, so it cannot turn", bodies[b].name),
                "give it a `radius of gyration` or a `shape`, or write `slides:`",
            );
        }
        if word == "rolls" {
            let mu_s = fields.get("mu_s").map(|n| self.number(n, Need::FRICTION));
            fields.close();
            return Some(Tie::Roll { body: body?, radius_m: radius?, mu_s: settle(mu_s)? });
        }
        let mu_s = self.need_number(&mut fields, "mu_s", "mu_s", Need::FRICTION);
        let mu_k = self.need_number(&mut fields, "mu_k", "mu_k", Need::FRICTION);
        fields.close();
        if word == "touches" {
            let mut touches = self.touches.borrow_mut();
            touches.push((tie, mu_k?));
            if !self.touching.slips(touches.len() - 1) {
                return Some(Tie::Roll { body: body?, radius_m: radius?, mu_s: Some(mu_s?) });
            }
        }
        Some(Tie::Slip { body: body?, radius_m: radius?, mu_s: mu_s?, mu_k: mu_k? })
    }

    /// A given force that grows: `growing by: c`, evenly with time, or `growing by: {rate: c, with: t^2}`.
    fn grows(&self, node: Option<&Node>, of: GivenForce) {
        let Some(node) = node else { return };
        let mut law = Law::EVEN;
        let mut rate = Some(node.clone());
        if matches!(node.value, Value::Map(_)) {
            let Some(mut fields) = Fields::open(node, "a growth (rate, with)", self.faults) else { return };
            rate = fields.need("rate", "c").cloned();
            let with = fields.need("with", "t^2").and_then(|n| self.law(n, of));
            fields.close();
            let Some(with) = with else { return };
            law = with;
        }
        let mut growth = Growth { of, law, rate: Num::Fixed(0.0), unit: Num::Fixed(1.0) };
        let need = Need::growth(growth.rate_unit(), matches!(of, GivenForce::Couple(_)));
        if let Some(number) = rate.and_then(|n| self.number(&n, need)) {
            growth.rate = number;
            self.growths.borrow_mut().push(growth);
        }
    }

    /// The power of time or place with which a force grows: `t^2`, `sqrt(t)`, of a pull `x`, of a couple `phi`.
    fn law(&self, node: &Node, of: GivenForce) -> Option<Law> {
        let place = if matches!(of, GivenForce::Pull(_)) { "x" } else { "phi" };
        let text = node.text().unwrap_or("").replace(' ', "");
        let powers = |name: &str| {
            [
                format!("sqrt({name})"),
                name.to_owned(),
                format!("{name}^1.5"),
                format!("{name}^2"),
                format!("{name}^3"),
            ]
        };
        let halves =
            |name: &str| powers(name).iter().position(|word| *word == text).map(|i| [1, 2, 3, 4, 6][i]);
        let law = |with, name| halves(name).map(|halves| Law { with, halves });
        let found = law(Grows::Time, "t").or_else(|| law(Grows::Place, place));
        if found.is_none() {
            let what = if place == "x" {
                "x is the way of its point along it"
            } else {
                "phi is the turn of its body"
            };
            self.faults.hint(
                node,
                told!("expected what it grows with, found {}", node.kind()),
                told!(
                    "one of {}; {what} since the start",
                    ["t", place].iter().flat_map(|name| powers(name)).collect::<Vec<_>>().join(", ")
                ),
            );
        }
        found
    }

    /// Two wheels that turn each other, by teeth or a belt: rims by body and radius.
    fn mesh(&self, node: &Node, bodies: &[Body], (made, like): (Made, usize)) -> Option<Cord> {
        let f = self.faults;
        let Value::List(both) = &node.value else {
            f.at(node, told!("expected two rims such as `[gear.rim, pinion.rim]`, found {}", node.kind()));
            return None;
        };
        let [one, other] = &both[..] else {
            f.at(node, told!("expected two rims such as `[gear.rim, pinion.rim]`, found {}", both.len()));
            return None;
        };
        let rim = |node: &Node| {
            let text = node.text().unwrap_or("").trim();
            let (name, radius) = text.split_once('.')?;
            let (index, body) = bodies.iter().enumerate().find(|(_, b)| b.name == name)?;
            let (_, radius) = body.radii_m.iter().find(|(n, _)| n == radius)?;
            (body.line.is_none() && body.turns && body.pin.is_none()).then_some((index, *radius))
        };
        let rim = |node: &Node| {
            let found = rim(node);
            if found.is_none() {
                let hint = "a body about a fixed axle and one of its radii, such as `gear.rim`";
                f.hint(node, told!("expected the rim of a wheel, found {}", node.kind()), hint);
            }
            found
        };
        let ((body, radius), (second, other_radius)) = rim(one).zip(rim(other))?;
        self.winds_on(radius);
        self.winds_on(other_radius);
        if body == second {
            f.at(node, "a wheel does not drive itself");
            return None;
        }
        // What the rim of the one gains, that of the other loses: teeth turn the other way, a belt the same way.
        let end = |body, radius, forward| CordEnd {
            body,
            attach: Attach::Wound(radius, Side::Top),
            forward,
            upright: None,
            tilt_deg: None,
        };
        let (from, to) = (end(body, radius, true), end(second, other_radius, made == Made::Teeth));
        let word = if made == Made::Teeth { "mesh" } else { "belt" };
        let name = if like == 0 { word.to_owned() } else { format!("{word}{}", like + 1) };
        Some(Cord { name, from, to: Far::Body(to), made })
    }

    /// A body that rests on wheels: on their rims, along which it does not slip, or on their axles.
    fn rests(&self, node: &Node, bodies: &[Body]) -> Vec<Cord> {
        let f = self.faults;
        let Some(mut fields) = Fields::open(node, "a body that rests on wheels (body, on)", f) else {
            return Vec::new();
        };
        let body = self.need_body(&mut fields, "body", bodies);
        let on = fields.need("on", "[front.rim, rear.rim]");
        fields.close();
        let (Some(load), Some(on)) = (body, on) else { return Vec::new() };
        let Some(line) = bodies[load].line.filter(|_| !bodies[load].turns) else {
            let hint = "what rests on wheels only moves, `moves: along SURFACE`, without an inertia";
            f.hint(node, told!("`{}` cannot rest on wheels", bodies[load].name), hint);
            return Vec::new();
        };
        let wheels = match &on.value {
            Value::List(items) => &items[..],
            _ => std::slice::from_ref(on),
        };
        let end = |node: &Node| {
            let (name, radius) = node.text().unwrap_or("").trim().split_once('.')?;
            let (index, wheel) = bodies.iter().enumerate().find(|(_, b)| b.name == name)?;
            let attach = match radius {
                "centre" | "center" | "axle" => Attach::Centre,
                _ => Attach::Wound(wheel.radii_m.iter().find(|(n, _)| n == radius)?.1, Side::Top),
            };
            // Beside each other along one line; a wheel on a fixed axle has none and turns what lies on it.
            let beside = match (wheel.line, attach) {
                (Some(own), _) => own.slope == line.slope,
                (None, attach) => attach != Attach::Centre,
            };
            let wheels = wheel.turns && wheel.pin.is_none() && wheel.planar.is_none() && beside;
            // What moves the load forward moves the wheel forward.
            let same = wheel.line.is_none_or(|l| l.forward_up) == line.forward_up;
            wheels.then_some((
                name.to_owned(),
                CordEnd { body: index, attach, forward: !same, upright: None, tilt_deg: None },
            ))
        };
        let mut list = Vec::new();
        for wheel in wheels {
            let Some((name, to)) = end(wheel) else {
                let hint = "a wheel on the same surface or on a fixed axle, with one of its radii, or with `.centre` for its axle: `roller.rim`";
                f.hint(wheel, told!("expected the rim or the axle of a wheel, found {}", wheel.kind()), hint);
                continue;
            };
            let from =
                CordEnd { body: load, attach: Attach::Centre, forward: true, upright: None, tilt_deg: None };
            list.push(Cord { name, from, to: Far::Body(to), made: Made::Rests });
        }
        list
    }

    /// The name of a cord or a light rod.
    fn tie_name(&self, node: Option<&Node>, unnamed: &str) -> Option<String> {
        let Some(node) = node else { return Some(unnamed.to_owned()) };
        let name = node.text().filter(|t| !WHOLE || plain_name(t));
        if name.is_none() {
            let message = told!("{} is no name for a {unnamed}", node.kind());
            self.faults.hint(node, message, "letters, digits and `_`");
        }
        name.map(str::to_owned)
    }

    /// A light rod between the centres of two bodies that move along one line.
    fn link(&self, node: &Node, bodies: &[Body]) -> Option<Cord> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a light rod (from, to)", f)?;
        let name = self.tie_name(fields.get("name"), UNNAMED[1]);
        let like = "{body: front, tied at: centre, leaves: back}";
        let [from, to] =
            ["from", "to"].map(|end| fields.need(end, like).and_then(|n| self.cord_end(n, bodies)));
        fields.close();
        let (from, to) = (from?, to?);
        // Each end by its line, and whether it leads up that.
        let up = |end: CordEnd| {
            let line = bodies[end.body].line.filter(|_| end.attach == Attach::Centre);
            line.map(|line| (line.slope, end.forward == line.forward_up))
        };
        let straight = || matches!((up(from), up(to)), (Some((a, x)), Some((b, y))) if a == b && x != y);
        if WHOLE && (from.body == to.body || !straight()) {
            let hint = "both bodies move along the same surface, or both vertically, each end is `tied at: centre`, and of two that count \
                        positive alike one end leaves `forward`, the other `back`; round a corner only a `cord` goes";
            f.hint(node, "a light rod is straight: its ends leave toward each other", hint);
            return None;
        }
        Some(Cord { name: name?, from, to: Far::Body(to), made: Made::Link })
    }

    fn cord(&self, node: &Node, bodies: &[Body], tie: usize) -> Option<Cord> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a cord (from, and where it goes)", f)?;
        let name = self.tie_name(fields.get("name"), UNNAMED[0])?;
        let from = fields
            .need("from", "{body: wheel, wound on: rim, leaves: top forward}")
            .and_then(|n| self.cord_end(n, bodies));
        let ends = [fields.get("pulled with"), fields.get("to"), fields.get("spring"), fields.get("held")];
        if ends.iter().flatten().count() != 1 {
            f.hint(
                node,
                "a cord has exactly one other end",
                "one of `pulled with: P`, `to: {body: ...}`, `spring: {...}`, `held: fast`",
            );
        }
        let [pulled, to, spring, held] = ends;
        let growing = fields.get("growing by");
        fields.close();
        if let (Some(n), None) = (growing, pulled) {
            f.hint(n, "what is not given does not grow", "`growing by` stands beside `pulled with`");
        }
        self.grows(growing, GivenForce::Pull(tie));
        if WHOLE
            && from.is_some_and(|from| from.tilt_deg.is_some())
            && (pulled.is_none() || growing.is_some())
        {
            let hint = "`at an angle` stands beside `pulled with` and a constant force: what grows, and what ends at another body, a spring \
                        or a wall, leads along the surface";
            f.hint(node, "only a constant pull leads away from the surface", hint);
        }
        let far = if let Some(n) = pulled {
            self.number(n, Need::FORCE).map(Far::Pull)
        } else if let Some(n) = to {
            self.cord_end(n, bodies).map(Far::Body)
        } else if let Some(n) = spring {
            self.spring(n)
        } else {
            held.and_then(|n| self.word(n, "`fast`", &[("fast", ())])).map(|()| Far::Fixed)
        };
        if let (Some(from), Some(Far::Body(to))) = (&from, &far)
            && from.body == to.body
        {
            f.at(node, told!("both ends of this cord are at `{}`", bodies[from.body].name));
            return None;
        }
        Some(Cord { name, from: from?, to: far?, made: Made::Cord })
    }

    fn spring(&self, node: &Node) -> Option<Far> {
        let mut fields = Fields::open(node, "a spring (stiffness, stretch)", self.faults)?;
        let stiffness = self.need_number(&mut fields, "stiffness", "ks", Need::STIFFNESS);
        let stretch = self.need_number(&mut fields, "stretch", "x0", Need::LENGTH);
        let rigid = fields.get("attached").map_or(Some(false), |n| {
            self.word(
                n,
                "how the spring is attached",
                &[("by the cord", false), ("cord", false), ("rigidly", true), ("rigid", true)],
            )
        });
        fields.close();
        Some(Far::Spring { stiffness_n_m: stiffness?, stretch_m: stretch?, rigid: rigid? })
    }

    fn cord_end(&self, node: &Node, bodies: &[Body]) -> Option<CordEnd> {
        let f = self.faults;
        let mut fields = Fields::open(node, "an end of a cord (body, tied at or wound on, leaves)", f)?;
        let body = self.need_body(&mut fields, "body", bodies);
        let wound = fields.get("wound on");
        let tied = fields.get("tied at");
        let leaves = fields.need("leaves", if tied.is_some() { "forward" } else { "top forward" });
        let tilted = fields.get("at an angle");
        fields.close();
        let index = body?;
        let body = &bodies[index];
        let tilt = tilted.and_then(|n| self.number(n, Need::TILT));
        let sideways = |n: &Node| {
            n.text().is_some_and(|t| t.trim().ends_with(" forward") || t.trim().ends_with(" back"))
        };
        let level = body.line.is_none() && body.pin.is_none() && leaves.is_some_and(sideways);
        if WHOLE && let (Some(n), false) = (tilted, level || body.line.is_some_and(|l| l.surface)) {
            f.hint(
                n,
                told!("`{}` moves along no surface", body.name),
                "an angle is that of a pull on what lies on a surface, or of one that leaves a fixed axle at the `top forward`, `bottom back` and the like",
            );
        }
        if !body.particles.is_empty() {
            f.at(node, told!("`{}` is made of particles; no cord can be tied to it", body.name));
            return None;
        }
        if body.pin.is_some() {
            f.hint(
                node,
                told!("no cord is tied to the pinned body `{}`", body.name),
                "a spring stands under `forces`: `spring: {on: ..., at: b, anchor: [x_A, y_A], ...}`",
            );
            return None;
        }
        match (wound, tied) {
            (Some(n), None) => {
                let radius = self.radius(n, body);
                if !body.turns {
                    f.hint(
                        node,
                        told!("`{}` has no inertia, so it cannot turn", body.name),
                        "write `tied at: centre`",
                    );
                    return None;
                }
                let (side, forward) = self.leaves_wound(leaves?, body)?;
                let said = leaves.and_then(Node::text).and_then(|text| text.trim().rsplit_once(' '));
                let upright = said.and_then(|(_, word)| match word {
                    "up" => Some(true),
                    "down" => Some(false),
                    _ => None,
                });
                let upright = upright.filter(|_| body.line.is_none());
                let attach = Attach::Wound(radius?, side);
                Some(CordEnd { body: index, attach, forward, upright, tilt_deg: tilt })
            }
            (None, Some(n)) => {
                self.word(
                    n,
                    "`centre`",
                    &[("centre", ()), ("center", ()), ("its centre", ()), ("mass centre", ())],
                )?;
                let Some(line) = body.line else {
                    f.hint(
                        node,
                        told!("the centre of `{}` does not move", body.name),
                        "write `wound on: ...`",
                    );
                    return None;
                };
                let up = if line.forward_up { ("up", true) } else { ("up", false) };
                let down = ("down", !line.forward_up);
                let forward = if line.slope == Slope::Level {
                    self.word(leaves?, "where the cord leaves", &[("forward", true), ("back", false)])
                } else {
                    self.word(
                        leaves?,
                        "where the cord leaves",
                        &[("forward", true), ("back", false), up, down],
                    )
                }?;
                Some(CordEnd { body: index, attach: Attach::Centre, forward, upright: None, tilt_deg: tilt })
            }
            _ => {
                f.hint(
                    node,
                    "a cord is tied at the centre or wound on a radius",
                    "write `tied at: centre` or `wound on: rim`",
                );
                None
            }
        }
    }

    /// Side and direction of a wound cord.
    fn leaves_wound(&self, node: &Node, body: &Body) -> Option<(Side, bool)> {
        use Side::{Bottom, Top};
        let surface = body.line.is_some_and(|l| l.surface);
        let mut words = vec![
            ("top forward", (Top, true)),
            ("top back", (Top, false)),
            ("bottom forward", (Bottom, true)),
            ("bottom back", (Bottom, false)),
        ];
        if !surface {
            // Seen with forward to the right, a positive turn moves the front side down: it pays a cord out that
            // leaves there downward, and takes one in that leaves there upward.
            for (word, pays_out, down) in [
                ("front down", true, true),
                ("back down", false, true),
                ("front up", false, false),
                ("back up", true, false),
            ] {
                let forward = match body.line {
                    None => true,
                    Some(line) => line.forward_up != down,
                };
                words.push((word, (if pays_out == forward { Top } else { Bottom }, forward)));
            }
            if let Some(line) = body.line {
                // The side for which a positive turn goes with unwinding while it moves down.
                words.push(("up", (if line.forward_up { Top } else { Bottom }, line.forward_up)));
            }
        }
        self.word(node, "where the wound cord leaves", &words)
    }

    fn forces(&self, node: &Node, bodies: &mut [Body]) -> Forces {
        let f = self.faults;
        let Value::List(items) = &node.value else {
            f.at(node, told!("expected a list of forces, each after `- `, found {}", node.kind()));
            return Forces::default();
        };
        let mut list = Forces::default();
        for item in items {
            let Some((word, key, value)) =
                self.one(item, "a force such as `couple: {on: wheel, moment: M, sense: forward}`")
            else {
                continue;
            };
            if word == "force" || word == "impulse" {
                let blow = word == "impulse";
                let count = list.pushes.iter().filter(|p| p.blow == blow).count();
                list.pushes.extend(self.push(value, bodies, count, blow));
                continue;
            }
            if word == "torsion" {
                list.struts.extend(self.torsion(value, bodies, list.struts.len()));
                continue;
            }
            if word == "spring" && bodies.iter().any(|b| b.planar.is_some()) {
                list.struts.extend(self.strut(value, bodies, list.struts.len()));
                continue;
            }
            if word == "spring" {
                self.pin_spring(value, bodies);
                continue;
            }
            if word != "couple" {
                self.unknown(key, "force", &["couple", "force", "impulse", "spring", "torsion"]);
                continue;
            }
            let Some(mut fields) = Fields::open(value, "a couple (on, moment, sense)", f) else { continue };
            let body = self.need_body(&mut fields, "on", bodies);
            let moment = self.need_number(&mut fields, "moment", "M", Need::MOMENT);
            let forward = fields.get("sense").map_or(Some(true), |n| {
                self.word(n, "the sense of the couple", &[("forward", true), ("back", false)])
            });
            self.grows(fields.get("growing by"), GivenForce::Couple(list.couples.len()));
            fields.close();
            if let Some(b) = body
                && !bodies[b].turns
            {
                f.at(value, told!("`{}` has no inertia, so a couple cannot turn it", bodies[b].name));
                continue;
            }
            if let (Some(body), Some(moment_n_m), Some(forward)) = (body, moment, forward) {
                list.couples.push(Couple { body, moment_n_m, forward });
            }
        }
        list
    }

    /// A spring between a fixed anchor and a point of a pinned body.
    fn pin_spring(&self, node: &Node, bodies: &mut [Body]) {
        let f = self.faults;
        let Some(mut fields) = Fields::open(node, "a spring (on, at, anchor, stiffness, natural length)", f)
        else {
            return;
        };
        let body = self.need_body(&mut fields, "on", bodies);
        let at = self.need_number(&mut fields, "at", "b", Need::RADIUS);
        let anchor = fields.need("anchor", "[x_A, y_A]").and_then(|n| self.place(n));
        let stiffness = self.need_number(&mut fields, "stiffness", "ks", Need::STIFFNESS);
        let rest = self.natural(node, &mut fields, Need::LENGTH);
        fields.close();
        let Some(body) = body else { return };
        let name = bodies[body].name.clone();
        let Some(pin) = &mut bodies[body].pin else {
            f.hint(
                node,
                told!("`{name}` is not pinned"),
                "a spring on a cord is written `cord: {from: ..., spring: {...}}` under `ties`",
            );
            return;
        };
        if pin.spring.is_some() {
            f.hint(node, told!("`{name}` has a spring already"), "a scene has at most one spring");
        }
        if let (Some(at_m), Some((x_m, y_m)), Some(stiffness_n_m), Some(rest)) = (at, anchor, stiffness, rest)
        {
            pin.spring = Some(PinSpring { at_m, x_m, y_m, stiffness_n_m, rest });
        }
    }

    fn start(&self, node: &Node, bodies: &mut [Body]) -> Vec<Start> {
        let f = self.faults;
        if node.text().is_some_and(|t| matches!(t.trim(), "at rest" | "from rest")) {
            return Vec::new();
        }
        if !matches!(node.value, Value::Map(_)) {
            f.hint(
                node,
                told!("expected the start, found {}", node.kind()),
                "`at rest`, or for example `{wheel: {speed: v0}}`",
            );
            return Vec::new();
        }
        let mut list = Vec::new();
        for (name, key, value) in named(node, "bodies with their speeds", f) {
            let Some(body) = bodies.iter().position(|b| b.name == name) else {
                let hint = spell::did_you_mean(name, bodies.iter().map(|b| b.name.as_str()));
                f.maybe(key, told!("`{}` is no body of this scene", shorten(name)), hint);
                continue;
            };
            let Some(mut fields) = Fields::open(value, "a speed, such as `{speed: v0}`", f) else { continue };
            if bodies[body].particles.is_empty() {
                let angled = bodies[body].pin.is_some() || bodies[body].planar.is_some();
                let angle = if angled { fields.get("angle") } else { None };
                let speed = fields.get("speed");
                let spin = fields.get("spin");
                let driven = if bodies[body].turns && angled { fields.get("alpha") } else { None };
                fields.close();
                if let (Some(n), Some(planar)) = (driven, &mut bodies[body].planar) {
                    planar.driven = self.number(n, Need::ANGULAR_ACCELERATION);
                }
                if let Some(n) = angle {
                    self.angled.set(true);
                    let angle = self.number(n, Need::ANGLE);
                    if let (Some(angle), Some(pin)) = (angle, &mut bodies[body].pin) {
                        pin.start_deg = angle;
                    }
                    if let Some(planar) = &mut bodies[body].planar {
                        planar.start_deg = angle;
                    }
                }
                if speed.is_none() && spin.is_none() && angle.is_none() {
                    f.hint(value, "no speed is given", "write `{speed: v0}` or `{spin: w0}`");
                }
                if let Some(n) = speed {
                    if bodies[body].line.is_none() && bodies[body].planar.is_none() {
                        f.hint(n, told!("`{name}` does not move along a line"), "write `spin:`");
                    } else if let Some(v) = self.at_start(n, Need::VELOCITY) {
                        list.push(Start::Speed(Coordinate { body, degree: Degree::Along }, v));
                    }
                }
                if let Some(n) = spin {
                    if !bodies[body].turns {
                        f.hint(n, told!("`{name}` does not turn"), "write `speed:`");
                    } else if let Some(w) = self.at_start(n, Need::SPIN) {
                        list.push(Start::Speed(Coordinate { body, degree: Degree::Turn }, w));
                    }
                }
                continue;
            }
            let particle = fields.need("velocity of", "A").and_then(|n| {
                let text = n.text().unwrap_or("").trim();
                let found = bodies[body].particles.iter().position(|p| p.name == text);
                if found.is_none() {
                    let names = || bodies[body].particles.iter().map(|p| p.name.as_str());
                    f.hint(
                        n,
                        told!("expected a particle, found {}", n.kind()),
                        told!("particles: {}", names().collect::<Vec<_>>().join(", ")),
                    );
                }
                found
            });
            let vx = self.need_number(&mut fields, "x", "vx", Need::VELOCITY);
            let vy = self.need_number(&mut fields, "y", "vy", Need::VELOCITY);
            let spin = self.need_number(&mut fields, "spin", "omega", Need::SPIN);
            fields.close();
            if let (Some(particle), Some(vx_m_s), Some(vy_m_s), Some(spin_rad_s)) = (particle, vx, vy, spin) {
                list.push(Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s });
            }
        }
        list
    }

    /// As an expression names it: a datum or what is worked out from data; `None` for a constant with a unit.
    fn named(&self, number: Num) -> Option<String> {
        match number {
            Num::Datum(i) => Some(self.symbols[i].name.clone()),
            Num::Derived(i) => {
                self.derived.borrow().get(i).filter(|d| !d.any).map(|d| format!("({})", d.text))
            }
            Num::Fixed(_) => None,
        }
    }

    /// A length over a pure number or another length, as the way or the angle at which a motion ends: the divisor, and whether it is
    /// a length that stands there without its unit.
    fn over(&self, node: &Node, by: Option<(String, bool)>, need: Need) -> Option<Num> {
        let text = node.text().map(str::trim)?;
        let known = is_expression(text) || self.symbols.iter().any(|s| s.name == text);
        // What is no number at all is told as such.
        let constant = if known { None } else { Some(self.number(node, Need::LENGTH)?) };
        let Some((by, bare)) = by else {
            self.faults.hint(
                node,
                "this length is divided by the radius on which the cord is wound, which is no datum",
                "make the radius a datum, such as `r: {name: radius, unit: m, draw: always 0.2}`",
            );
            return None;
        };
        let over = match constant {
            Some(Num::Fixed(length_m)) => length_m.to_string(),
            _ if is_expression(text) => format!("({text})"),
            _ => text.to_owned(),
        };
        let metres = i32::from(bare) - i32::from(constant.is_some());
        let [mass, length, time] = measure::own_powers(need.unit);
        let wanted = [mass, length + metres * measure::own_powers("m")[1], time];
        self.derived(node, &format!("{over}/{by}"), need, wanted)
    }

    /// An end by the height that a body gains or loses: the way along its surface follows from the slope.
    fn height(&self, value: &Node, bodies: &[Body], up: bool) -> Option<(End, Option<Heading>)> {
        let mut fields = Fields::open(value, "the body and the height", self.faults)?;
        let body = self.need_body(&mut fields, "of", bodies);
        let by = fields.need("by", "h");
        fields.close();
        let (body, by) = (body?, by?);
        let (way, line) = match bodies[body].line.map(|line| (line.slope, line)) {
            Some((Slope::Vertical, line)) => (self.number(by, Need::LENGTH), line),
            Some((Slope::Degrees(slope), line)) => {
                let slope = match slope {
                    Num::Fixed(degrees) => Some(format!("{degrees}*pi/180")),
                    other => self.named(other),
                };
                (self.over(by, slope.map(|s| (format!("sin({s})"), false)), Need::LENGTH), line)
            }
            _ => {
                let name = &bodies[body].name;
                let message = told!("`{name}` gains and loses no height along its line");
                self.faults.hint(value, message, "write `travel`, `turn` or another end");
                return None;
            }
        };
        let heading = if up == line.forward_up { Heading::Forward } else { Heading::Back };
        Some((End::Travel(Coordinate { body, degree: Degree::Along }, way?), Some(heading)))
    }

    /// An end by the length of cord that has come off a body, or onto it.
    fn unwound(&self, value: &Node, ties: &[Tie]) -> Option<(End, Option<Heading>)> {
        let mut fields = Fields::open(value, "the cord and the length", self.faults)?;
        let cord = fields.need("cord", "cord");
        let by = fields.need("by", "L");
        fields.close();
        let (cord, by) = (cord?, by?);
        let wound = |c: &Cord| {
            let far = match &c.to {
                Far::Body(end) => Some(*end),
                Far::Pull(_) | Far::Spring { .. } | Far::Fixed => None,
            };
            [Some(c.from), far].into_iter().flatten().find_map(|end| match end.attach {
                Attach::Wound(radius, _) => Some((c.name.clone(), end.body, radius)),
                Attach::Centre => None,
            })
        };
        let wound = ties.iter().filter_map(|t| if let Tie::Cord(c) = t { wound(c) } else { None });
        let wound: Vec<(String, usize, Num)> = wound.collect();
        let Some((_, body, radius)) = wound.iter().find(|(name, ..)| Some(name.as_str()) == cord.text())
        else {
            let names = || wound.iter().map(|(name, ..)| name.as_str());
            let message =
                told!("`{}` is no cord that is wound on a body", shorten(cord.text().unwrap_or("")));
            self.faults.hint(cord, message, told!("wound cords: {}", names().collect::<Vec<_>>().join(", ")));
            return None;
        };
        let radius = match *radius {
            Num::Fixed(radius_m) => Some((radius_m.to_string(), true)),
            other => self.named(other).map(|name| (name, false)),
        };
        let angle = self.over(by, radius, Need::TURN);
        Some((End::Travel(Coordinate { body: *body, degree: Degree::Turn }, angle?), None))
    }

    fn end(
        &self,
        node: &Node,
        bodies: &[Body],
        ties: &[Tie],
        joints: &[Joint],
    ) -> Option<(End, Option<Heading>)> {
        let f = self.faults;
        if node.text().is_some_and(|t| t.trim() == "at once") {
            return Some((End::AtOnce, None));
        }
        if node.text().is_some_and(|t| t.trim() == "equilibrium") {
            if !bodies.iter().any(|b| b.planar.is_some()) {
                let hint = "write `moves: in the plane` with joints; of a spring on a line, ask `period_small` of its motion";
                f.hint(node, "only joined bodies are looked for in their equilibrium", hint);
                return None;
            }
            return Some((End::Equilibrium, None));
        }
        let (word, key, value) = self
            .one(node, "the end: `at once`, `equilibrium`, or for example `{travel: {of: wheel, by: d}}`")?;
        if word == "turning point" {
            let body = self.body_named(value, bodies)?;
            let degree = if bodies[body].line.is_some() { Degree::Along } else { Degree::Turn };
            return Some((End::TurningPoint(Coordinate { body, degree }), None));
        }
        if word == "leaves" {
            let text = value.text().unwrap_or("").trim();
            let found = joints.iter().position(|j| j.name == text && j.kind.only_pushes());
            if found.is_none() {
                let hint = "a joint that can only push is written `wall: {guides: rod.B, along: vertical, pushes: right}`";
                f.hint(value, told!("expected a joint that can only push, found {}", value.kind()), hint);
            }
            return found.map(|joint| (End::Leaves(joint), None));
        }
        if word == "stops slipping" {
            let body = self.body_named(value, bodies)?;
            let along = Coordinate { body, degree: Degree::Along };
            let end = if bodies[body].turns { End::Rolling(along) } else { End::TurningPoint(along) };
            return Some((end, None));
        }
        if word == "rolling" {
            let body = self.body_named(value, bodies)?;
            return Some((End::Rolling(Coordinate { body, degree: Degree::Along }), None));
        }
        match word {
            "rise" => return self.height(value, bodies, true),
            "descent" => return self.height(value, bodies, false),
            "unwinds" => return self.unwound(value, ties),
            _ => {}
        }
        let Some((_, by, example, along, in_turning, end)) = ENDS.into_iter().find(|row| row.0 == word)
        else {
            let names = [
                "travel",
                "turn",
                "position",
                "time",
                "speed",
                "turning point",
                "rolling",
                "stops slipping",
                "angle",
                "rise",
                "descent",
                "unwinds",
                "leaves",
            ];
            self.unknown(key, "end", &names);
            return None;
        };
        let mut fields = Fields::open(value, "the body and the value", f)?;
        let body = self.need_body(&mut fields, "of", bodies);
        let line = body.and_then(|b| bodies[b].line);
        let turning = word == "turn" || (body.is_some() && line.is_none());
        let degree = if turning { Degree::Turn } else { Degree::Along };
        let need = if turning { in_turning } else { along };
        let number = self.need_number(&mut fields, by, example, need);
        let heading_node = fields.get("heading");
        let heading = heading_node.map_or(Some(None), |n| {
            let mut words = vec![("forward", Heading::Forward), ("back", Heading::Back)];
            if let Some(line) = line
                && line.slope != Slope::Level
                && !turning
            {
                let (up, down) = if line.forward_up {
                    (Heading::Forward, Heading::Back)
                } else {
                    (Heading::Back, Heading::Forward)
                };
                words.push(("up", up));
                words.push(("down", down));
            }
            self.word(n, "the direction of motion", &words).map(Some)
        });
        fields.close();
        let body = body?;
        if word == "turn" && !bodies[body].turns {
            f.at(value, told!("`{}` does not turn", bodies[body].name));
            return None;
        }
        let pinned = bodies[body].pin.is_some() || bodies[body].planar.is_some();
        let name = &bodies[body].name;
        if pinned && ["travel", "turn", "position"].contains(&word) {
            let planar = bodies[body].planar.is_some();
            let slides = planar && !bodies[body].turns;
            let held = if planar { "moves in the plane" } else { "is pinned" };
            let hint = if slides {
                told!(
                    "end it at the angle of a body that turns; what only slides along a line moves `vertically` or `along` a surface"
                )
            } else {
                told!("write `angle: {{of: {name}, reaches: phi1}}`")
            };
            f.hint(key, told!("`{name}` {held}: it ends at an angle"), hint);
        }
        if !pinned && word == "angle" {
            f.hint(key, told!("`{name}` is not pinned, so it has no angle"), "`travel`, `turn`, or pin it");
        }
        if let Some(n) = heading_node.filter(|_| pinned) {
            f.hint(n, "a pinned body goes where its forces or its start take it", "remove this field");
        }
        let coordinate = Coordinate { body, degree };
        Some((end(coordinate, number?), heading?))
    }
}

/// What stands under `forces`.
#[derive(Default)]
struct Forces {
    couples: Vec<Couple>,
    pushes: Vec<Push>,
    struts: Vec<Strut>,
}

/// `None`: given but wrong; `Some(None)`: absent.
#[expect(clippy::option_option, reason = "absent and wrong are told apart")]
fn settle(field: Option<Option<Num>>) -> Option<Option<Num>> {
    match field {
        None => Some(None),
        Some(Some(num)) => Some(Some(num)),
        Some(None) => None,
    }
}

fn contact_body(tie: &Tie) -> Option<usize> {
    match tie {
        Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => Some(*body),
        Tie::Cord(_) => None,
    }
}

const SHAPES: &[&str] = &[
    "disc",
    "disk",
    "cylinder",
    "solid cylinder",
    "hoop",
    "ring",
    "hollow cylinder",
    "sphere",
    "ball",
    "shell",
    "hollow sphere",
    "rod",
];

fn shape_of(word: &str) -> Option<Shape> {
    match word.trim().to_lowercase().as_str() {
        "disc" | "disk" | "cylinder" | "solid cylinder" | "solid disc" | "solid disk" => Some(Shape::Disc),
        "hoop" | "ring" | "hollow cylinder" | "thin hoop" | "thin ring" => Some(Shape::Hoop),
        "sphere" | "ball" | "solid sphere" | "solid ball" => Some(Shape::Sphere),
        "shell" | "hollow sphere" | "spherical shell" | "hollow ball" => Some(Shape::Shell),
        "rod" | "slender rod" | "uniform rod" | "bar" => Some(Shape::Rod),
        _ => None,
    }
}

/// Is it to be worked out, and no symbol alone and no constant with its unit (`4 kg*m^2`, `-2 m/s`)?
fn is_expression(text: &str) -> bool {
    let signless = text.trim_start_matches(['-', '+']).trim_start();
    let number = |c: char| c.is_ascii_digit() || c == '.';
    if !signless.starts_with(number) {
        return text.contains(['+', '-', '*', '/', '^', '(', '·']);
    }
    let rest = signless.trim_start_matches(number);
    // A power of ten belongs to the number.
    let ten = rest.strip_prefix(['e', 'E']).map(|r| r.trim_start_matches(['+', '-']));
    let rest = match ten {
        Some(digits) if digits.starts_with(|c: char| c.is_ascii_digit()) => digits.trim_start_matches(number),
        _ => rest,
    };
    rest.trim_start().starts_with(['+', '-', '*', '/', '^', '·'])
}

/// Letters, digits, `_`; begins with a letter; short.
pub fn plain_name(text: &str) -> bool {
    text.len() <= 64
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}
