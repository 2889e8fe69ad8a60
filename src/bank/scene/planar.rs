//! Bodies that move in the plane, and their joints, forces and springs.
use crate::bank::need::Need;
use crate::bank::node::{Fields, Node, Value, named};
use crate::bank::scene::{SceneReader, check_name};
use crate::scene::{
    Acts, Arrives, Body, Branch, Joint, JointKind, Num, Place, Planar, Push, Ray, Rest, RotaryInertia, Shape,
    Spot, Straight, Strut, StrutEnd, Surface, on_axis,
};
use crate::units::spell;

/// How a body in the plane is written, and one in a plane that lies level.
pub const PLANES: [&str; 2] = ["in the plane", "in a horizontal plane"];

/// Where the axis of a body begins.
const ORIGIN: [Place; 2] = [Place::At(Num::Fixed(0.0)); 2];

/// Kinds of joints: field that names what is held, and what it is.
const JOINTS: [(&str, &str); 9] = [
    ("pins", "a point that stays in its place"),
    ("hinges", "two points that stay together"),
    ("welds", "two points that stay together, with the angle between their bodies"),
    ("guides", "a point that stays on a line"),
    ("ties", "a point at the end of a cord"),
    ("links", "a point at the end of a light rod"),
    ("rolls", "a wheel that rolls, by its centre"),
    ("meshes", "a gear that meshes with a fixed one, by its centre"),
    ("slides", "a wheel or a point on a smooth surface"),
];

/// Directions of lines in words, degrees.
const LINES: [(&str, f64); 2] = [("horizontal", 0.0), ("vertical", -90.0)];

/// Directions of forces and velocities, degrees counter-clockwise from the right.
const WHITHER: [(&str, f64); 4] = [("right", 0.0), ("up", 90.0), ("left", 180.0), ("down", -90.0)];

/// From where angles count, and whether clockwise.
pub const ANGLES: [(&str, (Ray, bool)); 8] = [
    ("from right counter-clockwise", (Ray::Right, false)),
    ("from right clockwise", (Ray::Right, true)),
    ("from up counter-clockwise", (Ray::Up, false)),
    ("from up clockwise", (Ray::Up, true)),
    ("from left counter-clockwise", (Ray::Left, false)),
    ("from left clockwise", (Ray::Left, true)),
    ("from down counter-clockwise", (Ray::Down, false)),
    ("from down clockwise", (Ray::Down, true)),
];

/// All words for that, for who writes another one.
const FROM_WHERE: &str = "write `from right` or `from horizontal`, `from up`, `from upright` or `from vertical`, `from down` or \
                          `from hanging`; another sense than the usual one, and that of `from left`, with `clockwise` or `counter-clockwise`";

impl SceneReader<'_> {
    /// How a body lies in the plane; the start gives its angle.
    pub(super) fn planar(&self, fields: &mut Fields, body: &Body, level: bool) -> Planar {
        let (f, rod) = (self.faults, body.rod());
        let points = match fields.get("points") {
            Some(node) => self.points(node, rod),
            None => {
                let ends = [("A", Some(Num::Fixed(0.0))), ("B", rod)];
                let end = |(name, at): (&str, Option<Num>)| Some((name.to_owned(), on_axis(Place::At(at?))));
                ends.into_iter().filter_map(end).collect()
            }
        };
        let given = fields.get("mass centre").and_then(|n| match n.value {
            Value::List(_) => f.refuse_with(
                n,
                "the mass centre lies on the axis of its body: one distance is read, not a list",
                "lay the axis through the mass centre; points beside it are `[along, to the left]`",
            ),
            _ => self.along(n, rod),
        });
        let centre = given.unwrap_or(rod.map_or(Place::At(Num::Fixed(0.0)), Place::HalfOf));
        let angle = fields.get("angle").and_then(|n| {
            // Other words of the same meaning have been put into these.
            let known = ANGLES.iter().find(|(word, _)| n.text().is_some_and(|text| text.trim() == *word));
            known
                .map(|(_, meant)| *meant)
                .or_else(|| f.expected(n, "from where the angle counts", FROM_WHERE))
        });
        let (from, clockwise) = angle.unwrap_or((Ray::Right, false));
        let origin_m = fields.get("placed").and_then(|n| self.place(n));
        let words = [("ahead", Branch::Ahead), ("behind", Branch::Behind)];
        let side = fields.get("side").and_then(|n| self.word(n, "on which side it lies", &words));
        Planar { points, centre, from, clockwise, origin_m, level, side, ..Planar::default() }
    }

    /// The named points of a body.
    pub(super) fn points(&self, node: &Node, rod: Option<Num>) -> Vec<(String, [Place; 2])> {
        let (f, mut points) = (self.faults, Vec::new());
        for (name, key, value) in named(node, "points by name, such as `{A: 0 m, B: L}`", f) {
            check_name(key, name, "a point", f);
            let place = match &value.value {
                Value::List(both) if both.len() == 2 => {
                    self.along(&both[0], rod).zip(self.along(&both[1], rod)).map(|(x, y)| [x, y])
                }
                _ => self.along(value, rod).map(on_axis),
            };
            points.extend(place.map(|place| (name.to_owned(), place)));
        }
        points
    }

    /// A distance along the axis of a body: a length, or a place of a rod in words.
    fn along(&self, node: &Node, rod: Option<Num>) -> Option<Place> {
        match (node.text().map(str::trim), rod) {
            (Some("its end" | "the other end"), Some(length)) => Some(Place::At(length)),
            (Some("the middle" | "midway"), Some(length)) => Some(Place::HalfOf(length)),
            _ => self.number(node, Need::PLACE).map(Place::At),
        }
    }

    /// A point of a body, `rod.B`; the body alone, where the origin of its axis is its only one.
    fn spot(&self, node: &Node, bodies: &[Body]) -> Option<Spot> {
        let text = node.text().unwrap_or("").trim();
        let (name, point) = text.split_once('.').map_or((text, None), |(b, p)| (b, Some(p)));
        let body = bodies.iter().position(|b| b.name == name && b.planar.is_some());
        let found = body.and_then(|body| {
            let planar = bodies[body].planar.as_ref()?;
            match point {
                Some(point) => planar.points.iter().position(|(n, _)| n == point),
                // By its name alone a body is meant where its axis begins: at its only point, or at its middle.
                None => planar.points.iter().position(|(_, at)| {
                    *at == ORIGIN && (planar.points.len() == 1 || planar.centre == ORIGIN[0])
                }),
            }
            .map(|point| Spot { body, point })
        });
        found.or_else(|| {
            // Of a body that there is its own points.
            let own = |b: &&Body| b.planar.is_some() && body.is_none_or(|body| bodies[body].name == b.name);
            let known = bodies.iter().filter(own).flat_map(|b| {
                let names = b.planar.iter().flat_map(|p| p.points.iter().map(|(n, _)| n.as_str()));
                names.map(|point| format!("{}.{point}", b.name))
            });
            let known: Vec<String> = known.collect();
            let hint = spell::hint(text, "points", known.iter().map(String::as_str));
            let what = match known.first().filter(|_| body.is_some()) {
                Some(first) => format!("a point of `{name}`, such as `{first}`"),
                None => "a point of a body".to_owned(),
            };
            self.faults.expected(node, &what, hint)
        })
    }

    /// The joints of a scene.
    pub(super) fn joints(&self, node: &Node, bodies: &[Body]) -> Vec<Joint> {
        let f = self.faults;
        let mut list = Vec::new();
        for (name, key, value) in named(node, "joints by name, such as `{floor: {guides: rod.A}}`", f) {
            check_name(key, name, "a joint", f);
            let Some(mut fields) = Fields::open(
                value,
                "a joint (pins, hinges, welds, guides, ties, links, rolls, meshes or slides)",
                f,
            ) else {
                continue;
            };
            let held = fields.each(JOINTS.map(|(word, _)| word)).into_iter().zip(JOINTS);
            let mut held = held.filter_map(|(node, (word, _))| Some((word, node?)));
            let kind = match (held.next(), held.next()) {
                (Some((word, n)), None) => self.joint(word, n, &mut fields, bodies),
                _ => {
                    let words = JOINTS.map(|(word, what)| format!("`{word}` ({what})")).join(", ");
                    f.refuse_with(value, format!("`{name}` has to say what it holds"), words)
                }
            };
            if let Some(n) = fields.get("restitution")
                && let Some(e) = self.number(n, Need::RESTITUTION)
                && self.restitution.replace(Some((list.len(), e))).is_some()
            {
                f.hint(n, "two joints act in the impact alone", "only one has `restitution`");
            }
            list.extend(kind.map(|kind| Joint { name: name.to_owned(), kind }));
        }
        list
    }

    fn joint(&self, word: &str, node: &Node, fields: &mut Fields, bodies: &[Body]) -> Option<JointKind> {
        match word {
            "pins" => {
                let at = self.spot(node, bodies);
                at.zip(self.ground(fields.get("at"))).map(|(at, place_m)| JointKind::Pin { at, place_m })
            }
            "hinges" | "welds" => self.hinge(node, word == "welds", fields, bodies),
            "guides" => self.guide(node, fields, bodies),
            "ties" | "links" => {
                let over = if word == "ties" { fields.get("over") } else { None };
                let to = fields.need("to", "[x_A, y_A]");
                let (at, rod) = (self.spot(node, bodies), word == "links");
                let Some(over) = over else {
                    let held = at.zip(self.ground(to));
                    return held.map(|(at, place_m)| JointKind::Cord { at, place_m, beyond: None, rod });
                };
                let pulleys = match &over.value {
                    Value::List(both) if both.iter().all(|n| matches!(n.value, Value::List(_))) => &both[..],
                    _ => std::slice::from_ref(over),
                };
                let places: Option<Vec<_>> = pulleys.iter().map(|n| self.ground(Some(n))).collect();
                let (place_m, last_m) = match places?[..] {
                    [one] => (one, one),
                    [first, last] => (first, last),
                    _ => {
                        return self.faults.expected(
                            over,
                            "the place of a small pulley, or of two",
                            "such as `[x_C, h]` or `[[x_A, y_A], [x_B, y_B]]`",
                        );
                    }
                };
                let to = self.spot(to?, bodies)?;
                let at = at?;
                if to.body == at.body {
                    return self.faults.refuse(node, "a cord over a pulley ties two bodies");
                }
                Some(JointKind::Cord { at, place_m, beyond: Some((to, last_m)), rod })
            }
            _ => self.surface(node, (word != "slides", word == "meshes"), fields, bodies),
        }
    }

    /// A fixed place, by default the origin.
    fn ground(&self, node: Option<&Node>) -> Option<[Num; 2]> {
        match node {
            None => Some([Num::Fixed(0.0); 2]),
            Some(n) => self.place(n),
        }
    }

    fn hinge(&self, node: &Node, welded: bool, fields: &mut Fields, bodies: &[Body]) -> Option<JointKind> {
        let turned = if welded { self.optional(fields, "turned", Need::ANGLE) } else { Some(None) };
        match &node.value {
            Value::List(both) if both.len() == 2 => {
                let (one, other) = (self.spot(&both[0], bodies)?, self.spot(&both[1], bodies)?);
                if one.body == other.body {
                    return self.faults.refuse(node, "a hinge or a weld joins two bodies");
                }
                // A particle is stuck on: it has no turn that the weld would hold.
                let holds = welded && [one, other].iter().all(|spot| bodies[spot.body].turns);
                let turned_deg = turned?.or(Some(Num::Fixed(0.0))).filter(|_| holds);
                Some(JointKind::Hinge { one, other, turned_deg })
            }
            _ => {
                let message =
                    format!("expected two points such as `[crank.B, rod.A]`, found {}", node.kind());
                self.faults.refuse(node, message)
            }
        }
    }

    /// A wheel that rolls, or a wheel or a point that slides, on a line or a cylinder; inside a smaller one it is a hoop on a peg.
    fn surface(
        &self,
        node: &Node,
        (rolls, teeth): (bool, bool),
        fields: &mut Fields,
        bodies: &[Body],
    ) -> Option<JointKind> {
        let f = self.faults;
        let at = self.spot(node, bodies);
        let radius = match fields.get("radius") {
            Some(n) => self.number(n, if rolls { Need::RADIUS } else { Need::LENGTH }),
            None if rolls => {
                f.refuse_with(node, "a wheel that rolls has a radius", "write `radius: r` beside it")
            }
            None => Some(Num::Fixed(0.0)),
        };
        let [outside, inside, along, on] = fields.each(["outside", "inside", "along", "on"]);
        let mu_k = if rolls { Some(None) } else { self.optional(fields, "mu_k", Need::FRICTION) };
        let surface = match (outside, inside, along) {
            (Some(n), None, None) | (None, Some(n), None) if !rolls || on.is_none() => {
                let centre = self.ground(fields.get("axis"));
                let arc = self.number(n, Need::RADIUS);
                let on = on.map_or(Some(None), |n| self.spot(n, bodies).map(Some));
                centre.zip(arc).zip(on).map(|((centre_m, radius_m), on)| {
                    let inside = inside.is_some();
                    Surface::Arc { centre_m, radius_m, inside, on }
                })
            }
            (Some(n), None, None) | (None, Some(n), None) => f.refuse_with(
                on.unwrap_or(n),
                "what rolls on a cylinder that turns is not solved",
                "leave `on:` out where the cylinder stays; wheels about fixed axles turn one another by `meshes` or `belt`",
            ),
            (None, None, None) if on.is_some_and(|n| self.is_round(n, bodies)) => f.refuse_with(
                on.unwrap_or(node),
                "`on:` alone means a straight line that this body carries along its axis, and it is round",
                "tell the line by `along: 0 deg`; wheels about fixed axles turn one another by `meshes` or `belt`, two that both turn while an arm carries one of them are not solved",
            ),
            (None, None, _) if on.or(along).is_some() => self.straight((on, along), fields, bodies).map(Surface::Line),
            _ => f.refuse_with(
                node,
                "it has to say on what it rolls or slides",
                "`along: horizontal` or an angle for a plane, `outside: R` or `inside: R` for a cylinder, `on: cart.A` for a body",
            ),
        };
        let (at, radius_m, surface, mu_k) = (at?, radius?, surface?, mu_k?);
        match (surface, mu_k) {
            (Surface::Line(line), Some(_)) if radius_m == Num::Fixed(0.0) => {
                Some(JointKind::Guide { at, line, reversed: false, one_sided: true, mu_k })
            }
            _ => Some(JointKind::Contact { at, radius_m, surface, rolls, mu_k, teeth }),
        }
    }

    /// Has the body of this point a round shape?
    fn is_round(&self, node: &Node, bodies: &[Body]) -> bool {
        let name = node.text().unwrap_or("").trim().split('.').next();
        let round =
            |b: &Body| matches!(b.inertia, Some(RotaryInertia::Shape(shape, _)) if shape != Shape::Rod);
        bodies.iter().any(|b| Some(b.name.as_str()) == name && round(b))
    }

    /// A straight line: fixed in space, or in a body through one of its points, with its direction from the axis of that.
    fn straight(
        &self,
        (on, along): (Option<&Node>, Option<&Node>),
        fields: &mut Fields,
        bodies: &[Body],
    ) -> Option<Straight> {
        if let (Some(_), Some(n)) = (on, along)
            && LINES.iter().any(|(word, _)| n.text().map(str::trim) == Some(*word))
        {
            let hint = "tell the angle counter-clockwise from the axis of that body, such as `along: 0 deg`";
            self.faults.hint(n, "a line that a body carries goes with it", hint);
            return None;
        }
        let direction_deg = along.map_or(Some(Num::Fixed(0.0)), |n| self.direction(n, &LINES));
        let (on, through) = match on {
            Some(n) => (Some(self.spot(n, bodies)?), None),
            None => (None, fields.get("through")),
        };
        Some(Straight { on, through_m: self.ground(through)?, direction_deg: direction_deg? })
    }

    /// A direction, in one of these words or as an angle.
    fn direction(&self, node: &Node, words: &[(&str, f64)]) -> Option<Num> {
        let text = node.text().map(str::trim);
        match words.iter().find(|(word, _)| Some(*word) == text) {
            Some((_, degrees)) => Some(Num::Fixed(*degrees)),
            None => self.number(node, Need::ANGLE),
        }
    }

    fn guide(&self, node: &Node, fields: &mut Fields, bodies: &[Body]) -> Option<JointKind> {
        let f = self.faults;
        let at = self.spot(node, bodies);
        let on = fields.get("on");
        let along_node = if on.is_some() { fields.get("along") } else { fields.need("along", "horizontal") };
        let line = self.straight((on, along_node), fields, bodies);
        let words = [("up", Ray::Up), ("down", Ray::Down), ("left", Ray::Left), ("right", Ray::Right)];
        let pushes_node = fields.get("pushes");
        let pushes = pushes_node.and_then(|n| self.word(n, "whither it pushes", &words));
        let mu_k = self.optional(fields, "mu_k", Need::FRICTION);
        let mut line = line?;
        let mut reversed = false;
        if let (Some(pushes), Some(node)) = (pushes, pushes_node) {
            // The normal force is positive to the left of the direction.
            match (line.fixed_deg(bodies, false), line.direction_deg, pushes) {
                (Some(in_space), own, pushes) => {
                    let (sine, cosine) = crate::num::trig::sin_cos_degrees(in_space);
                    let [x, y] = pushes.components();
                    let along_push = x * -sine.hi + y * cosine.hi;
                    if along_push.abs() < 1e-9 {
                        let hint = "a level line pushes up or down, a vertical one right or left";
                        f.hint(node, "the line cannot push that way", hint);
                    } else if along_push < 0.0 {
                        let Num::Fixed(d) = own else { return None };
                        line.direction_deg = Num::Fixed(if d > 0.0 { d - 180.0 } else { d + 180.0 });
                        reversed = true;
                    }
                }
                (None, ..) if line.on.is_some() => {
                    let hint = "leave `pushes` away: the line then holds on both sides";
                    f.hint(node, "a line on a body that turns, or along a drawn direction of it, has no side that is up or down", hint);
                }
                (None, Num::Datum(_), Ray::Up | Ray::Left) => {
                    // In no draw may the left of the direction be the other side.
                    let need = if pushes == Ray::Up { Need::PUSHES_UP } else { Need::PUSHES_LEFT };
                    along_node.and_then(|n| self.number(n, need));
                }
                (None, Num::Derived(_), Ray::Up | Ray::Left) => {}
                (None, ..) => {
                    let hint = "it pushes to the left of its direction: write the angle so that this is `up`";
                    f.hint(node, "a line along a drawn direction pushes up", hint);
                }
            }
        }
        let one_sided = pushes.is_some();
        let (at, mu_k) = (at?, mu_k?);
        Some(JointKind::Guide { at, line, reversed, one_sided, mu_k })
    }

    /// How a body moves just before an impact.
    pub(super) fn arrives(&self, node: &Node, turns: bool) -> Option<Arrives> {
        let what = "how it moves just before the impact (speed, direction, spin)";
        let mut fields = Fields::open(node, what, self.faults)?;
        let [speed, spin] = fields.each(["speed", "spin"]);
        let given =
            |node: Option<&Node>, need| node.map_or(Some(Num::Fixed(0.0)), |n| self.at_start(n, need));
        if speed.is_none() && spin.is_none() || spin.is_some() && !turns {
            let hint = "write `{speed: v, direction: right}`, or `{spin: w}` of what turns";
            self.faults.hint(node, "it has no such velocity before the impact", hint);
        }
        let speed_m_s = given(speed, Need::VELOCITY)?;
        let direction = if speed_m_s == Num::Fixed(0.0) {
            fields.get("direction")
        } else {
            fields.need("direction", "right")
        };
        Some(Arrives {
            turns_alone: speed.is_none(),
            speed_m_s,
            direction_deg: direction.map_or(Some(Num::Fixed(0.0)), |n| self.direction(n, &WHITHER))?,
            spin_rad_s: given(spin, Need::SPIN)?,
        })
    }

    /// A force on a point of a body in the plane, or a blow.
    pub(super) fn push(&self, node: &Node, bodies: &[Body], count: usize, blow: bool) -> Option<Push> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a force (on, magnitude, direction)", f)?;
        let at = fields.need("on", "rod.B").and_then(|n| self.spot(n, bodies));
        let (symbol, need) = if blow { ("J", Need::IMPULSE) } else { ("P", Need::PUSH) };
        let force = self.need_number(&mut fields, "magnitude", symbol, need);
        let turning = fields.get("from the axis");
        let toward = if blow { None } else { fields.get("toward") };
        let given = turning.is_some() || toward.is_some();
        let towards = if given { None } else { fields.need("direction", "right") };
        let direction = match (turning, towards) {
            (Some(n), _) => self.number(n, Need::ANGLE),
            (None, None) if toward.is_some() => Some(Num::Fixed(0.0)),
            (None, n) => n.and_then(|n| self.direction(n, &WHITHER)),
        };
        let toward_m = toward.and_then(|n| self.place(n));
        let name = own_name(&mut fields, symbol, count);
        let turns = turning.is_some();
        Some(Push { name, at: at?, force_n: force?, direction_deg: direction?, turns, toward_m, blow })
    }

    /// A torsion spring between a body and what does not move.
    pub(super) fn torsion(&self, node: &Node, bodies: &[Body], count: usize) -> Option<Strut> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a torsion spring (on, stiffness, relaxed at)", f)?;
        let at = fields.need("on", "rod.A").and_then(|n| self.spot(n, bodies));
        let stiffness = self.need_number(&mut fields, "stiffness", "kt", Need::TORSION);
        let rest = match (fields.get("relaxed at"), fields.get("wound")) {
            (Some(n), None) => self.number(n, Need::ANGLE).map(Rest::Length),
            (None, Some(n)) => self.number(n, Need::ANGLE).map(Rest::Stretch),
            _ => {
                let hint = "write `relaxed at: 0 deg`, the angle of its body, or `wound: 30 deg`, how far it is wound at the start";
                let message = "a torsion spring is relaxed at an angle, or wound by one at the start";
                f.refuse_with(node, message, hint)
            }
        };
        let name = own_name(&mut fields, "spring", count);
        let (to, acts) = (StrutEnd::Twist, Acts::Both);
        let at = at.filter(|spot| {
            let turns = bodies[spot.body].turns;
            if !turns {
                f.hint(
                    node,
                    format!("`{}` does not turn", bodies[spot.body].name),
                    "give it a shape or another inertia",
                );
            }
            turns
        });
        Some(Strut { name, at: at?, to, stiffness_n_m: stiffness?, rest: rest?, acts })
    }

    /// A spring at a point of a body in the plane.
    pub(super) fn strut(&self, node: &Node, bodies: &[Body], count: usize) -> Option<Strut> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a spring (on, to, stiffness, natural length)", f)?;
        let at = fields.need("on", "rod.B").and_then(|n| self.spot(n, bodies));
        let to = fields.need("to", "[x_A, y_A]").and_then(|n| match &n.value {
            Value::List(_) => self.place(n).map(StrutEnd::Ground),
            Value::Map(_) => {
                let mut fields = Fields::open(n, "a guide (along, through)", f)?;
                let through = self.ground(fields.get("through"));
                let along = fields.need("along", "horizontal").and_then(|n| self.direction(n, &LINES));
                through
                    .zip(along)
                    .map(|(through_m, direction_deg)| StrutEnd::Guide { through_m, direction_deg })
            }
            _ => self.spot(n, bodies).map(StrutEnd::Spot),
        });
        let stiffness = self.need_number(&mut fields, "stiffness", "ks", Need::STIFFNESS);
        let rest = self.natural(node, &mut fields, Need::STRETCH);
        let words = [("pushes", Acts::Pushes), ("pulls", Acts::Pulls)];
        let acts = fields.get("only").and_then(|n| self.word(n, "what the spring does", &words));
        let acts = acts.unwrap_or_default();
        let name = own_name(&mut fields, "spring", count);
        Some(Strut { name, at: at?, to: to?, stiffness_n_m: stiffness?, rest: rest?, acts })
    }

    /// Natural length of a spring, or its stretch at the start: in the plane that may be negative.
    pub(super) fn natural(&self, node: &Node, fields: &mut Fields, stretch: &Need) -> Option<Rest> {
        match (fields.get("natural length"), fields.get("stretch")) {
            (Some(n), None) => self.number(n, Need::LENGTH).map(Rest::Length),
            (None, Some(n)) => self.number(n, stretch).map(Rest::Stretch),
            _ => self.faults.refuse_with(
                node,
                "a spring has a natural length, or a stretch at the start",
                "write `natural length: l0`, or `stretch: x0`",
            ),
        }
    }
}

/// The name that is given; else the first is called as its kind, the next ones are numbered.
fn own_name(fields: &mut Fields, kind: &str, count: usize) -> String {
    match fields.get("name").and_then(Node::text) {
        Some(name) => name.to_owned(),
        None if count == 0 => kind.to_owned(),
        None => format!("{kind}{}", count + 1),
    }
}
