//! Other ways in which books say a thing, put into the one that scenes are read in, before they are. Sheets get what this makes of a
//! bank.
use crate::bank::measure;
use crate::bank::node::{Node, Value};

/// Shapes, by what they are called besides.
const SHAPES: [(&str, &[&str]); 5] = [
    ("disc", &["disk", "cylinder", "solid cylinder", "solid disc", "solid disk"]),
    ("hoop", &["ring", "hollow cylinder", "thin hoop", "thin ring"]),
    ("sphere", &["ball", "solid sphere", "solid ball"]),
    ("shell", &["hollow sphere", "spherical shell", "hollow ball"]),
    ("rod", &["slender rod", "uniform rod", "bar"]),
];

/// Fields of the inertia about a pin, and those about the mass centre.
pub const ABOUT_PIN: [(&str, &str); 2] = [
    ("radius of gyration about the pin", "radius of gyration"),
    ("moment of inertia about the pin", "moment of inertia"),
];

/// [`put`] into a tree that is owned.
pub fn put_in(mut bank: Node) -> Node {
    put(&mut bank);
    bank
}

/// Puts all scenes of the tree of a bank into the words in which they are read.
pub fn put(bank: &mut Node) {
    for (_, problem) in fields(bank.field_mut("problems")) {
        let written = problem.field("scene").cloned();
        let own = problem.field_mut("scene").into_iter();
        own.for_each(scene);
        for list in ["cases", "mistakes"] {
            let entries = fields(problem.field_mut(list)).iter_mut();
            for changed in entries.filter_map(|(_, entry)| entry.field_mut("scene")) {
                if let Some(whole) = written.as_ref().filter(|_| list == "mistakes") {
                    turn_from_changed_start(changed, whole);
                }
                scene(changed);
            }
        }
    }
}

/// What changes the start of a motion, or its turn, and not both, turns so far from the start that it then has.
fn turn_from_changed_start(changes: &mut Node, whole: &Node) {
    let told = ["start", "end"].map(|field| changes.field(field).is_some());
    let Some(mut whole) = whole.overlaid(changes).filter(|_| told[0] || told[1]) else { return };
    if whole.field("end").is_some_and(|end| end.field("turn").is_some()) {
        turn_from_start(&mut whole);
        if let Some(end) = whole.field("end").cloned() {
            match changes.field_mut("end") {
                Some(own) => *own = end,
                None => add(changes, "end", end.value),
            }
        }
    }
}

/// The fields of a map; none of anything else.
fn fields(node: Option<&mut Node>) -> &mut [(Node, Node)] {
    match node.map(|n| &mut n.value) {
        Some(Value::Map(fields)) => fields,
        _ => &mut [],
    }
}

/// Gives a node another text, in its place of the file.
fn say(node: &mut Node, text: String) {
    node.value = Value::Text(text);
}

/// Gives a map one more field, at the place of the map.
fn add(map: &mut Node, name: &str, value: Value) {
    let at = |value| Node { value, line: map.line, column: map.column, path: map.path.clone() };
    let field = (at(Value::Text(name.to_owned())), at(value));
    if let Value::Map(fields) = &mut map.value {
        fields.push(field);
    }
}

fn scene(scene: &mut Node) {
    for (_, body) in fields(scene.field_mut("bodies")) {
        shapes(body);
        angle(body);
    }
    pins(scene);
    about_pins(scene);
    turn_from_start(scene);
    thrown(scene);
    contacts(scene);
    if let Some(next) = scene.field_mut("next") {
        contacts(next);
    }
}

/// What is set down spinning, or thrown and does not spin, has the other velocity 0, unless other ties may give it.
fn thrown(scene: &mut Node) {
    let Some(Value::List(ties)) = scene.field("ties").map(|ties| &ties.value) else { return };
    let held = |name: &str| {
        let ends = |tie: &Node| match &tie.value {
            Value::Map(kind) => kind.iter().any(|(_, tie)| {
                tie.field("on").is_some()
                    || ["from", "to"]
                        .iter()
                        .any(|end| tie.field(end).and_then(|end| end.field("body")?.text()) == Some(name))
            }),
            _ => false,
        };
        ties.iter().any(ends)
    };
    let slips = ties.iter().filter_map(|tie| tie.field("slips")?.field("body")?.text());
    let free: Vec<String> = slips.filter(|name| !held(name)).map(str::to_owned).collect();
    for (name, start) in fields(scene.field_mut("start")) {
        let [speed, spin] = ["speed", "spin"].map(|velocity| start.field(velocity).is_some());
        if speed != spin && name.text().is_some_and(|name| free.iter().any(|body| body == name)) {
            let (other, zero) = if spin { ("speed", "0 m/s") } else { ("spin", "0 rad/s") };
            add(start, other, Value::Text(zero.to_owned()));
        }
    }
}

/// Books often give one coefficient of what slides: static friction is no smaller.
fn contacts(scene: &mut Node) {
    let Some(Value::List(ties)) = scene.field_mut("ties").map(|ties| &mut ties.value) else { return };
    for slips in ties.iter_mut().filter_map(|tie| tie.field_mut("slips")) {
        let mu_k = slips.field("mu_k").map(|mu_k| mu_k.value.clone());
        if let Some(mu_k) = mu_k.filter(|_| slips.field("mu_s").is_none()) {
            add(slips, "mu_s", mu_k);
        }
    }
}

/// Calls shapes by one name each.
fn shapes(body: &mut Node) {
    let called = |shape: &mut Node| {
        let said = words(shape);
        let known = SHAPES.iter().find(|(name, others)| *name == said || others.contains(&said.as_str()));
        if let Some((name, _)) = known {
            say(shape, (*name).to_owned());
        }
    };
    fields(body.field_mut("shape")).iter_mut().for_each(|(shape, _)| called(shape));
    if let Some(Value::List(parts)) = body.field_mut("parts").map(|parts| &mut parts.value) {
        parts.iter_mut().flat_map(|part| fields(Some(part))).for_each(|(shape, _)| called(shape));
    }
}

/// The words of a text, as they are compared.
fn words(node: &Node) -> String {
    node.text().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Says from where an angle counts, and in which sense: a body with a pin of its own counts from upright or from hanging.
fn angle(body: &mut Node) {
    let pinned = body.field("pinned").is_some() || body.field("moves").is_none();
    let Some(angle) = body.field_mut("angle") else { return };
    let (mut ray, mut sense) = (None, None);
    for word in words(angle).split(' ') {
        let once = match word {
            "from" | "the" => true,
            "right" | "horizontal" => ray.replace(("right", "counter-clockwise")).is_none(),
            "up" | "upright" | "vertical" => ray.replace(("up", "clockwise")).is_none(),
            "down" | "hanging" => ray.replace(("down", "counter-clockwise")).is_none(),
            "left" => ray.replace(("left", "")).is_none(),
            "clockwise" => sense.replace("clockwise").is_none(),
            "counter-clockwise" | "counterclockwise" | "anticlockwise" => {
                sense.replace("counter-clockwise").is_none()
            }
            _ => false,
        };
        // Of two, or of a word that is none of these, it is said where it is read.
        if !once {
            return;
        }
    }
    let Some((ray, usual)) = ray else { return };
    let meant = match (pinned, ray, sense.unwrap_or(usual)) {
        // Which sense is meant is asked where it is read.
        (_, _, "") => return,
        (true, "up", "clockwise") => "from upright".to_owned(),
        (true, "down", "counter-clockwise") => "from hanging".to_owned(),
        (_, ray, sense) => format!("from {ray} {sense}"),
    };
    say(angle, meant);
}

/// Puts a body with a pin of its own into the plane that has company and whose angle counts from elsewhere than upright or hanging: its
/// pin is a joint like others.
fn pins(scene: &mut Node) {
    let mut held = Vec::new();
    let joints = scene.field("joints").cloned();
    let bodies = fields(scene.field_mut("bodies"));
    let alone = bodies.len() == 1;
    for (name, body) in bodies.iter_mut().filter(|_| !alone) {
        // What bears these names already is not written over.
        let joint = name.text().and_then(|name| joints.as_ref()?.field(name));
        if joint.or(body.field("points").and_then(|points| points.field("pin"))).is_some() {
            continue;
        }
        let usual = body
            .field("angle")
            .is_none_or(|angle| matches!(angle.text(), Some("from upright" | "from hanging")));
        let (Some(pinned), Some(name)) = (body.field("pinned").filter(|_| !usual).cloned(), name.text())
        else {
            continue;
        };
        let distance = pinned.field("distance").map(|distance| distance.value.clone());
        if let Value::Map(own) = &mut body.value {
            own.retain(|(field, _)| field.text() != Some("pinned"));
        }
        let text = |text: &str| Value::Text(text.to_owned());
        add(body, "moves", text("in the plane"));
        if body.field("points").is_none() {
            add(body, "points", Value::Map(Vec::new()));
        }
        if let Some(points) = body.field_mut("points") {
            add(points, "pin", text("0 m"));
        }
        if let Some(distance) = distance {
            add(body, "mass centre", distance);
        }
        let pin = (Node::of_text("pins"), Node::of_text(&format!("{name}.pin")));
        held.push((name.to_owned(), Value::Map(vec![pin])));
    }
    if !held.is_empty() && scene.field("joints").is_none() {
        add(scene, "joints", Value::Map(Vec::new()));
    }
    if let Some(joints) = scene.field_mut("joints") {
        held.into_iter().for_each(|(name, pin)| add(joints, &name, pin));
    }
}

/// A number of the bank as a term of an expression: a constant, in this unit, or the symbols of data.
enum Term {
    Constant(f64),
    Symbols(String),
}

impl Term {
    fn of(text: &str, unit: &str) -> Self {
        match measure::constant(text.trim(), unit) {
            Ok(value) => Self::Constant(value),
            Err(_) => Self::Symbols(format!("({})", text.trim())),
        }
    }
}

/// The moment of inertia or the radius of gyration about a pin, put into that about the mass centre by the theorem of parallel axes.
/// Left as it is where constants with units stand beside symbols: an expression holds none.
fn about_pins(scene: &mut Node) {
    let joints = scene.field("joints").cloned();
    for (name, body) in fields(scene.field_mut("bodies")) {
        let arm = name.text().and_then(|name| arm(name, body, joints.as_ref()));
        for (about, own) in ABOUT_PIN {
            let Some(given) = body.field(about).and_then(Node::text) else { continue };
            let text_of = |field: &str| body.field(field).and_then(Node::text);
            let mass = text_of("mass").map(|m| Term::of(m, "kg"));
            let weight = || text_of("weight").map(|w| Term::Symbols(format!("({w})/g")));
            let central =
                match (own, Term::of(given, if own == "moment of inertia" { "kg*m^2" } else { "m" }), &arm) {
                    ("moment of inertia", Term::Constant(i), Some(Term::Constant(h))) => match mass {
                        Some(Term::Constant(m)) if i >= m * h * h => format!("{} kg*m^2", i - m * h * h),
                        _ => continue,
                    },
                    ("moment of inertia", Term::Symbols(i), Some(Term::Symbols(h))) => {
                        match mass.or_else(weight) {
                            Some(Term::Symbols(m)) => format!("{i} - {m}*{h}^2"),
                            _ => continue,
                        }
                    }
                    (_, Term::Constant(k), Some(Term::Constant(h))) if k >= h.abs() => {
                        format!("{} m", (k * k - h * h).sqrt())
                    }
                    (_, Term::Symbols(k), Some(Term::Symbols(h))) => format!("sqrt({k}^2 - {h}^2)"),
                    _ => continue,
                };
            for (field, value) in
                fields(Some(body)).iter_mut().filter(|(field, _)| field.text() == Some(about))
            {
                say(field, own.to_owned());
                say(value, central.clone());
            }
        }
    }
}

/// How far the pin of a body is from its mass centre, along its axis.
fn arm(name: &str, body: &Node, joints: Option<&Node>) -> Option<Term> {
    if let Some(distance) = body.field("pinned").and_then(|pinned| pinned.field("distance")) {
        return Some(Term::of(distance.text()?, "m"));
    }
    let Value::Map(joints) = &joints?.value else { return None };
    let point = joints.iter().find_map(|(_, joint)| {
        let spot = joint.field("pins")?.text()?.trim();
        let (body, point) = spot.split_once('.').unwrap_or((spot, "A"));
        (body == name).then_some(point)
    })?;
    let place = |text: &str| Some(Term::of(text, "m"));
    let point = body.field("points").and_then(|points| points.field(point));
    let point = point.map_or(Some(Term::Constant(0.0)), |point| place(point.text()?))?;
    match (place(body.field("mass centre")?.text()?)?, point) {
        (centre, Term::Constant(0.0)) => Some(centre),
        (Term::Constant(0.0), point) => Some(point),
        (Term::Constant(centre), Term::Constant(point)) => Some(Term::Constant(centre - point)),
        (Term::Symbols(centre), Term::Symbols(point)) => Some(Term::Symbols(format!("({centre} - {point})"))),
        _ => None,
    }
}

/// `turn: {of: rod, by: phi}` of what has an angle ends at that of the start and so much more.
fn turn_from_start(scene: &mut Node) {
    let Some(turn) = scene.field("end").and_then(|end| end.field("turn")) else { return };
    let [of, by] = ["of", "by"].map(|field| turn.field(field).and_then(Node::text).map(str::to_owned));
    let (Some(of), Some(by)) = (of, by) else { return };
    let Some(body) = scene.field("bodies").and_then(|bodies| bodies.field(of.trim())) else { return };
    let planar = body.field("moves").and_then(Node::text).is_some_and(|moves| moves.contains("plane"));
    if !planar && body.field("pinned").is_none() {
        return;
    }
    let start = scene.field("start").and_then(|start| start.field(of.trim())?.field("angle")?.text());
    let radians = |x: f64| format!("{x}*pi/180");
    let reaches = match [start.unwrap_or("0 deg"), by.as_str()].map(|text| Term::of(text, "deg")) {
        [Term::Constant(from), Term::Constant(by)] => format!("{} deg", from + by),
        [Term::Constant(0.0), Term::Symbols(by)] => by,
        [Term::Constant(from), Term::Symbols(by)] => format!("{} + {by}", radians(from)),
        [Term::Symbols(from), Term::Constant(by)] => format!("{from} + {}", radians(by)),
        [Term::Symbols(from), Term::Symbols(by)] => format!("{from} + {by}"),
    };
    for (word, end) in fields(scene.field_mut("end")) {
        say(word, "angle".to_owned());
        for (field, value) in fields(Some(end)).iter_mut().filter(|(field, _)| field.text() == Some("by")) {
            say(field, "reaches".to_owned());
            say(value, reaches.clone());
        }
    }
}
