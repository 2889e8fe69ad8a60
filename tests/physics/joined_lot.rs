//! Mechanisms composed by lot, as the text of a bank and as what a judge has to know of them: rods in two guides, on a floor, on pins
//! and hinges, cranks with sliders, linkages of four bars, wheels on lines and cylinders, bodies let go at an instant; with parts welded on,
//! forces, couples, springs and blows at any points. Places at the start are found here, by plane geometry.
use crate::composed::Lot;
use std::fmt::Write as _;

pub type V2 = [f64; 2];
/// A point of a body: which body, and how far along its axis and to the left of it, m.
pub type Spot = (usize, V2);
/// On the axis.
pub const fn on(along: f64) -> V2 {
    [along, 0.0]
}

pub fn dot(a: V2, b: V2) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
pub fn plus(a: V2, k: f64, b: V2) -> V2 {
    [a[0] + k * b[0], a[1] + k * b[1]]
}
/// A quarter turn counter-clockwise.
pub fn quarter(a: V2) -> V2 {
    [-a[1], a[0]]
}
pub fn unit(angle: f64) -> V2 {
    [libm::cos(angle), libm::sin(angle)]
}
pub fn turned(a: V2, angle: f64) -> V2 {
    let e = unit(angle);
    plus(e.map(|x| x * a[0]), a[1], quarter(e))
}
pub fn length(a: V2) -> f64 {
    libm::sqrt(dot(a, a))
}
pub fn radians(degrees: f64) -> f64 {
    degrees * std::f64::consts::PI / 180.0
}

pub struct Body {
    pub mass: f64,
    /// About the mass centre.
    pub inertia: f64,
    pub turns: bool,
    /// Of the mass centre, along the axis.
    pub centre: f64,
    pub points: Vec<V2>,
    /// Direction from which its angle counts, degrees counter-clockwise from the right; 1 if it counts counter-clockwise, else -1.
    pub from: f64,
    pub sense: f64,
}

pub enum Hold {
    Pin(Spot, V2),
    Hinge(Spot, Spot),
    /// The same, and the axis of the other stays turned by this from that of the one, degrees counter-clockwise.
    Weld(Spot, Spot, f64),
    /// Point, a place and the direction of the line, does it only push, friction.
    Guide(Spot, V2, f64, bool, Option<f64>),
    /// Point and place; is it a light rod, which pushes too?
    Cord(Spot, V2, bool),
    /// Centre, radius, does it roll; a line, the left side of which is free.
    Line(Spot, f64, bool, V2, f64, Option<f64>),
    /// The same on a cylinder: its axis and its radius, and is the body inside, or a hoop about it? Friction, and what turns with it.
    Arc(Spot, f64, bool, V2, f64, bool, (Option<f64>, Option<Spot>)),
}

impl Hold {
    /// Coefficient of kinetic friction.
    pub const fn mu(&self) -> Option<f64> {
        match *self {
            Self::Guide(.., mu) | Self::Line(.., mu) | Self::Arc(.., (mu, _)) => mu,
            _ => None,
        }
    }
}

pub enum Load {
    /// Point, force, direction; does it turn with the axis?
    Force(Spot, f64, f64, bool),
    /// Point, the place to which it is drawn at all times, force.
    Pull(Spot, V2, f64),
    /// Body, moment counter-clockwise.
    Couple(usize, f64),
    /// Point, fixed place or other point, stiffness, natural length; 1 if it only pulls, -1 if it only pushes, else 0.
    Spring(Spot, Far, f64, f64, f64),
    /// Body, stiffness, direction of its axis at which it is relaxed.
    Torsion(usize, f64, f64),
    /// Point, impulse, direction.
    Blow(Spot, f64, f64),
}

#[derive(Clone, Copy)]
pub enum Far {
    Place(V2),
    Spot(Spot),
}

#[derive(Clone, Copy, PartialEq)]
pub enum Ending {
    AtOnce,
    /// The leading body's angle as it counts, degrees.
    Angle(f64),
    /// Seconds.
    Time(f64),
    Turns,
    Leaves(usize),
    /// At rest in the equilibrium toward which it would set off.
    Equilibrium,
}

pub struct Machine {
    pub kind: &'static str,
    pub bodies: Vec<Body>,
    pub holds: Vec<Hold>,
    pub loads: Vec<Load>,
    /// Places of the mass centres and angles of the axes at the start.
    pub start: Vec<f64>,
    pub lead: usize,
    /// Rate of the angle that leads, as it counts.
    pub spin: f64,
    /// Spins of other bodies that are told, each as it counts: with that of the leading one for every freedom.
    pub spins: Vec<(usize, f64)>,
    /// Of the leading body, as it counts, degrees.
    pub angle: f64,
    pub end: Ending,
    /// Angular acceleration with which the leading body is driven, as it counts, rad/s^2.
    pub alpha: Option<f64>,
    pub gravity: f64,
    /// Acceleration of what carries all of it, to the right and up.
    pub carried: V2,
    body_text: Vec<String>,
    joint_text: Vec<String>,
    force_text: Vec<String>,
    start_text: Vec<String>,
    data: Vec<String>,
}

/// From where angles count: words, direction in degrees, sense.
const ANGLES: [(&str, f64, f64); 9] = [
    ("from horizontal", 0.0, 1.0),
    ("from vertical", 90.0, -1.0),
    ("from hanging", -90.0, 1.0),
    ("from right clockwise", 0.0, -1.0),
    ("from up counter-clockwise", 90.0, 1.0),
    ("from left clockwise", 180.0, -1.0),
    ("from left counter-clockwise", 180.0, 1.0),
    ("from down clockwise", -90.0, -1.0),
    ("from down counter-clockwise", -90.0, 1.0),
];

impl Machine {
    /// A number with its unit, or the symbol of a datum that is always this.
    fn number(&mut self, lot: &mut Lot, value: f64, decimals: usize, unit: &str) -> String {
        let text = format!("{value:.decimals$}");
        if !lot.in_100(60) || self.data.len() >= 12 {
            return format!("{text} {unit}").trim_end().to_owned();
        }
        let symbol = format!("x{}", self.data.len() + 1);
        self.data.push(format!("{symbol}: {{name: {symbol}, unit: '{unit}', draw: always {text}}}"));
        symbol
    }
    fn place(&mut self, lot: &mut Lot, at: V2) -> String {
        let [x, y] = at.map(|x| self.number(lot, x, 2, "m"));
        format!("[{x}, {y}]")
    }
    fn names(i: usize) -> &'static str {
        ["bar", "link", "arm", "block"][i]
    }
    /// A body with points at these places along its axis; a rod of this length, or with a mass centre and a radius of gyration.
    fn body(
        &mut self,
        lot: &mut Lot,
        points: &[V2],
        rod: Option<f64>,
        turns: bool,
        angled: bool,
        more: &str,
    ) {
        let i = self.bodies.len();
        let mass = grid(lot, 0.5, 9.0, 1);
        let mass_text = self.number(lot, mass, 1, "kg");
        let (words, from, sense) = if angled { lot.of(&ANGLES) } else { ("", 0.0, 1.0) };
        let mut text = format!("{}: {{mass: {mass_text}, moves: in the plane", Self::names(i));
        let (mut inertia, mut centre) = (0.0, 0.0);
        match rod {
            Some(length) => {
                let length_text = self.number(lot, length, 2, "m");
                let _ = write!(text, ", shape: {{rod: {length_text}}}");
                (inertia, centre) = (mass * length * length / 12.0, length / 2.0);
            }
            None if turns => {
                let k = grid(lot, 0.1, 0.6, 2);
                centre = if lot.in_100(50) { 0.0 } else { grid(lot, -0.5, 0.9, 2) };
                let (k_text, centre_text) = (self.number(lot, k, 2, "m"), self.number(lot, centre, 2, "m"));
                let _ = write!(text, ", radius of gyration: {k_text}, mass centre: {centre_text}");
                inertia = mass * k * k;
            }
            None => {}
        }
        if turns {
            let list: Vec<String> = points
                .iter()
                .enumerate()
                .map(|(p, [x, y])| {
                    let along = self.number(lot, *x, 2, "m");
                    let at = if *y == 0.0 {
                        along
                    } else {
                        format!("[{along}, {}]", self.number(lot, *y, 2, "m"))
                    };
                    format!("{}: {at}", point_name(p))
                })
                .collect();
            let _ = write!(text, ", points: {{{}}}", list.join(", "));
        }
        if angled {
            let _ = write!(text, ", angle: {words}");
        }
        self.body_text.push(format!("{text}{more}}}"));
        self.bodies.push(Body { mass, inertia, turns, centre, points: points.to_vec(), from, sense });
    }
    fn spot_text(&self, (body, at): Spot) -> String {
        let point = self.bodies[body].points.iter().position(|p| *p == at).expect("a named point");
        if self.bodies[body].turns {
            format!("{}.{}", Self::names(body), point_name(point))
        } else {
            Self::names(body).to_owned()
        }
    }
    fn hold(&mut self, lot: &mut Lot, hold: Hold) {
        let name = format!("j{}", self.holds.len() + 1);
        let text = match &hold {
            Hold::Pin(at, place) => {
                format!("pins: {}, at: {}", self.spot_text(*at), self.place(lot, *place))
            }
            Hold::Hinge(one, other) => {
                format!("hinges: [{}, {}]", self.spot_text(*one), self.spot_text(*other))
            }
            Hold::Weld(one, other, turned) => {
                let turned = self.number(lot, *turned, 0, "deg");
                format!("welds: [{}, {}], turned: {turned}", self.spot_text(*one), self.spot_text(*other))
            }
            Hold::Guide(at, through, direction, pushes, mu) => {
                // A wall or a floor is told by the side to which it pushes: the left of its direction.
                let (words, side) = match *direction {
                    0.0 => ("horizontal".to_owned(), "up"),
                    180.0 => ("horizontal".to_owned(), "down"),
                    -90.0 => ("vertical".to_owned(), "right"),
                    90.0 => ("vertical".to_owned(), "left"),
                    other => (self.number(lot, other, 0, "deg"), "up"),
                };
                let mut text = format!("guides: {}, along: {words}", self.spot_text(*at));
                let _ = write!(text, ", through: {}", self.place(lot, *through));
                if *pushes {
                    let _ = write!(text, ", pushes: {side}");
                }
                if let Some(mu) = mu {
                    let _ = write!(text, ", mu_k: {}", self.number(lot, *mu, 2, "1"));
                }
                text
            }
            Hold::Cord(at, place, rod) => {
                let word = if *rod { "links" } else { "ties" };
                format!("{word}: {}, to: {}", self.spot_text(*at), self.place(lot, *place))
            }
            Hold::Line(at, radius, rolls, through, direction, mu) => {
                let direction = self.number(lot, *direction, 0, "deg");
                let text = self.touching(lot, *at, *radius, *rolls);
                let text = format!("{text}, along: {direction}, through: {}", self.place(lot, *through));
                self.rough(lot, text, *mu)
            }
            Hold::Arc(at, radius, rolls, axis, arc, inside, (mu, drum)) => {
                let text = self.touching(lot, *at, *radius, *rolls);
                let side = if *inside { "inside" } else { "outside" };
                let arc = self.number(lot, *arc, 2, "m");
                // The pin of a drum has to be told by the same numbers.
                let text = match drum {
                    Some(on) => {
                        let [x, y] = axis;
                        let on = self.spot_text(*on);
                        format!("{text}, {side}: {arc}, axis: [{x:.2} m, {y:.2} m], on: {on}")
                    }
                    None => format!("{text}, {side}: {arc}, axis: {}", self.place(lot, *axis)),
                };
                self.rough(lot, text, *mu)
            }
        };
        self.joint_text.push(format!("{name}: {{{text}}}"));
        self.holds.push(hold);
    }
    fn rough(&mut self, lot: &mut Lot, text: String, mu: Option<f64>) -> String {
        mu.map_or_else(|| text.clone(), |mu| format!("{text}, mu_k: {}", self.number(lot, mu, 2, "1")))
    }
    fn touching(&mut self, lot: &mut Lot, at: Spot, radius: f64, rolls: bool) -> String {
        let word = if rolls { "rolls" } else { "slides" };
        let text = format!("{word}: {}", self.spot_text(at));
        if radius == 0.0 { text } else { format!("{text}, radius: {}", self.number(lot, radius, 2, "m")) }
    }
    /// Places a body: this point of it stands at `at`, its axis at this angle.
    fn put(&mut self, body: usize, point: V2, at: V2, angle: f64) {
        let centre = plus(at, -1.0, turned(self.beside_centre((body, point)), angle));
        self.start.resize(3 * self.bodies.len(), 0.0);
        self.start[3 * body..3 * body + 3].copy_from_slice(&[centre[0], centre[1], angle]);
    }
    fn at(&self, spot: Spot) -> V2 {
        let at = 3 * spot.0;
        plus([self.start[at], self.start[at + 1]], 1.0, turned(self.beside_centre(spot), self.start[at + 2]))
    }
    /// A point from the mass centre, along the axis and to the left of it.
    pub fn beside_centre(&self, (body, [along, across]): Spot) -> V2 {
        [along - self.bodies[body].centre, across]
    }
    /// Angle of the axis of the leading body from the right, where it counts as `angle`.
    pub fn axis(&self, angle: f64) -> f64 {
        let lead = &self.bodies[self.lead];
        radians(lead.from + lead.sense * angle)
    }
}

fn point_name(i: usize) -> &'static str {
    ["A", "B", "C", "D"][i]
}

/// A number of a decimal grid.
fn grid(lot: &mut Lot, low: f64, high: f64, decimals: i32) -> f64 {
    let scale = 10.0_f64.powi(decimals);
    let (a, b) = ((low * scale).round(), (high * scale).round());
    (a + lot.below((b - a) as usize + 1) as f64) / scale
}

/// Now and then a truck or a lift carries it.
fn carrier(seed: u64) -> V2 {
    let by = grid(&mut Lot::new(seed ^ 0x0ca4_41ed), -6.0, 6.0, 1);
    match seed % 10 {
        3 => [by, 0.0],
        7 => [0.0, by],
        _ => [0.0; 2],
    }
}

/// The mechanism of a seed: `None` where its parts do not meet.
pub fn machine(seed: u64) -> Option<(Machine, Lot)> {
    let mut lot = Lot::new(seed);
    let l = &mut lot;
    let mut m = Machine {
        kind: "",
        bodies: Vec::new(),
        holds: Vec::new(),
        loads: Vec::new(),
        start: Vec::new(),
        lead: 0,
        spin: 0.0,
        spins: Vec::new(),
        angle: grid(l, -180.0, 180.0, 0),
        end: Ending::AtOnce,
        alpha: None,
        gravity: l.of(&[9.81, 9.81, 9.81, 1.62]),
        carried: carrier(seed),
        body_text: Vec::new(),
        joint_text: Vec::new(),
        force_text: Vec::new(),
        start_text: Vec::new(),
        data: Vec::new(),
    };
    let picked = match seed % 8 {
        3 => 12,
        5 => 11,
        _ => l.below(11),
    };
    let at_once = match picked {
        0 => slots(&mut m, l)?,
        1 => ladder(&mut m, l),
        2 => on_a_floor(&mut m, l),
        3 => pendulum(&mut m, l),
        4 | 5 => crank(&mut m, l)?,
        6 => four_bars(&mut m, l)?,
        7 => on_a_line(&mut m, l),
        8 | 9 => on_a_cylinder(&mut m, l),
        11 => on_links(&mut m, l)?,
        12 => rubbing(&mut m, l)?,
        _ => let_go(&mut m, l),
    };
    if l.in_100(20) {
        weld(&mut m, l);
    }
    loads(&mut m, l);
    if l.in_100(if picked == 12 { 85 } else { 40 }) && m.kind != "let go" && m.bodies[m.lead].turns {
        m.spin = grid(l, -6.0, 6.0, 1);
    }
    let angle = m.number(l, m.angle, 0, "deg");
    let mut start = format!("{}: {{angle: {angle}", Machine::names(m.lead));
    if m.spin != 0.0 {
        let spin = m.number(l, m.spin, 1, "rad/s");
        let _ = write!(start, ", spin: {spin}");
    }
    m.start_text.insert(0, format!("{start}}}"));
    if !at_once && !l.in_100(25) {
        m.end = Ending::Angle(f64::NAN);
    }
    Some((m, lot))
}

/// A rod or another body, its points at A = 0 and B.
fn bar(m: &mut Machine, l: &mut Lot, reach: f64, angled: bool, more: &str) {
    let mut points = vec![on(0.0), on(reach)];
    if l.in_100(40) {
        let across = if l.in_100(40) { grid(l, -0.3, 0.3, 2) } else { 0.0 };
        points.push([grid(l, -0.3, reach + 0.4, 2), across]);
        if points[..2].contains(&points[2]) {
            points.pop();
        }
    }
    let rod = l.in_100(70).then_some(reach);
    m.body(l, &points, rod, true, angled, more);
}

fn slots(m: &mut Machine, l: &mut Lot) -> Option<bool> {
    m.kind = "two guides";
    let reach = grid(l, 0.3, 2.0, 2);
    bar(m, l, reach, true, "");
    let words = [0.0, -90.0, grid(l, 1.0, 89.0, 0), grid(l, -89.0, -1.0, 0)];
    let (one, other) = (l.of(&words), l.of(&words));
    if libm::sin(radians(one - other)).abs() < 0.3 {
        return None;
    }
    let (p, q) = (place(l), place(l));
    // The origin: n . (o + s u - p) = 0 for both.
    let u = unit(m.axis(m.angle));
    let (a, b) = (quarter(unit(radians(one))), quarter(unit(radians(other))));
    let right = [dot(a, p), dot(b, q) - reach * dot(b, u)];
    let area = a[0] * b[1] - a[1] * b[0];
    let origin = [(right[0] * b[1] - right[1] * a[1]) / area, (right[1] * a[0] - right[0] * b[0]) / area];
    m.put(0, on(0.0), origin, m.axis(m.angle));
    let rough = l.in_100(30).then(|| grid(l, 0.02, 0.35, 2));
    m.hold(l, Hold::Guide((0, on(0.0)), p, one, false, rough));
    m.hold(l, Hold::Guide((0, on(reach)), q, other, false, None));
    Some(false)
}

/// Against a wall on its left, on a floor that may be rough.
fn ladder(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "ladder";
    let reach = grid(l, 0.5, 4.0, 2);
    bar(m, l, reach, true, "");
    // The foot on the right: its axis leads up and to the left.
    let axis = grid(l, 100.0, 170.0, 0);
    let body = &m.bodies[0];
    m.angle = (axis - body.from) * body.sense;
    let foot = [-reach * libm::cos(radians(axis)), 0.0];
    m.put(0, on(0.0), foot, m.axis(m.angle));
    let mu = |l: &mut Lot| l.in_100(30).then(|| grid(l, 0.02, 0.35, 2));
    let (floor, wall) = (mu(l), mu(l));
    m.hold(l, Hold::Guide((0, on(0.0)), [0.0, 0.0], 0.0, true, floor));
    m.hold(l, Hold::Guide((0, on(reach)), [0.0, 0.0], -90.0, true, wall));
    false
}

fn on_a_floor(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "on a floor";
    let reach = grid(l, 0.3, 2.0, 2);
    bar(m, l, reach, true, "");
    let axis = m.axis(m.angle);
    let centre = m.bodies[0].centre;
    // Its mass centre above the start of the floor.
    let foot = [-centre * libm::cos(axis), 0.0];
    m.put(0, on(0.0), foot, axis);
    m.hold(l, Hold::Guide((0, on(0.0)), [0.0, 0.0], 0.0, false, None));
    false
}

fn pendulum(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "on a pin";
    let reach = grid(l, 0.3, 2.0, 2);
    bar(m, l, reach, true, "");
    let at = place(l);
    m.put(0, on(0.0), at, m.axis(m.angle));
    m.hold(l, Hold::Pin((0, on(0.0)), at));
    false
}

fn place(l: &mut Lot) -> V2 {
    [grid(l, -1.5, 1.5, 2), grid(l, -1.5, 1.5, 2)]
}

/// A crank, a connecting rod, and a block or the rod's end itself on a guide.
fn crank(m: &mut Machine, l: &mut Lot) -> Option<bool> {
    m.kind = "slider-crank";
    let (r, reach) = (grid(l, 0.15, 0.5, 2), grid(l, 0.4, 1.5, 2));
    bar(m, l, r, true, "");
    let pin = if l.in_100(50) { [0.0, 0.0] } else { place(l) };
    m.put(0, on(0.0), pin, m.axis(m.angle));
    m.hold(l, Hold::Pin((0, on(0.0)), pin));
    let behind = l.in_100(40);
    bar(m, l, reach, false, if behind { ", side: behind" } else { "" });
    m.hold(l, Hold::Hinge((0, on(r)), (1, on(0.0))));
    let slope = grid(l, -80.0, 80.0, 0);
    let direction = l.of(&[0.0, -90.0, slope]);
    let through =
        plus(pin, 1.0, [grid(l, -0.1, 0.1, 2), grid(l, -0.1, 0.1, 2)].map(|x| (x * 100.0).round() / 100.0));
    let through = through.map(|x| (x * 100.0).round() / 100.0);
    // The far end: on the line, `reach` from the hinge; ahead along the guide or behind.
    let (u, hinge) = (unit(radians(direction)), m.at((0, on(r))));
    let away = plus(through, -1.0, hinge);
    let across = dot(away, quarter(u));
    if across.abs() > 0.9 * reach {
        return None;
    }
    let ahead = libm::sqrt(reach * reach - across * across) * if behind { -1.0 } else { 1.0 };
    let far = plus(plus(hinge, ahead, u), across, quarter(u));
    let axis = libm::atan2(far[1] - hinge[1], far[0] - hinge[0]);
    m.put(1, on(0.0), hinge, axis);
    let rough = l.in_100(30).then(|| grid(l, 0.02, 0.35, 2));
    if l.in_100(60) {
        m.body(l, &[on(0.0)], None, false, false, "");
        m.put(2, on(0.0), far, 0.0);
        m.hold(l, Hold::Hinge((1, on(reach)), (2, on(0.0))));
        m.hold(l, Hold::Guide((2, on(0.0)), through, direction, false, rough));
    } else {
        m.hold(l, Hold::Guide((1, on(reach)), through, direction, false, rough));
    }
    Some(false)
}

fn four_bars(m: &mut Machine, l: &mut Lot) -> Option<bool> {
    m.kind = "four bars";
    let (a, b, c) = (grid(l, 0.15, 0.5, 2), grid(l, 0.4, 1.2, 2), grid(l, 0.3, 1.0, 2));
    let far_pin = [grid(l, 0.3, 1.2, 2), grid(l, -0.4, 0.4, 2)];
    bar(m, l, a, true, "");
    m.put(0, on(0.0), [0.0, 0.0], m.axis(m.angle));
    m.hold(l, Hold::Pin((0, on(0.0)), [0.0, 0.0]));
    let behind = l.in_100(50);
    bar(m, l, b, false, if behind { ", side: behind" } else { "" });
    bar(m, l, c, false, "");
    m.hold(l, Hold::Hinge((0, on(a)), (1, on(0.0))));
    m.hold(l, Hold::Hinge((1, on(b)), (2, on(c))));
    m.hold(l, Hold::Pin((2, on(0.0)), far_pin));
    // The hinge of the two: on the left of the line from the crank's end to the far pin, or on its right.
    let near = m.at((0, on(a)));
    let apart = plus(far_pin, -1.0, near);
    let d = length(apart);
    let along = (b * b - c * c + d * d) / (2.0 * d);
    let square = b * b - along * along;
    if square < 0.02 * b * b {
        return None;
    }
    let e = apart.map(|x| x / d);
    let across = libm::sqrt(square) * if behind { -1.0 } else { 1.0 };
    let hinge = plus(plus(near, along, e), across, quarter(e));
    m.put(1, on(0.0), near, libm::atan2(hinge[1] - near[1], hinge[0] - near[0]));
    m.put(2, on(0.0), far_pin, libm::atan2(hinge[1] - far_pin[1], hinge[0] - far_pin[0]));
    Some(false)
}

/// A wheel, its mass centre on its axle or off it.
fn wheel(m: &mut Machine, l: &mut Lot, angled: bool) {
    let across = if l.in_100(40) { grid(l, -0.3, 0.3, 2) } else { 0.0 };
    let points = if l.in_100(50) { vec![on(0.0), [grid(l, 0.05, 0.4, 2), across]] } else { vec![on(0.0)] };
    m.body(l, &points, None, true, angled, "");
}

fn on_a_line(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "on a line";
    wheel(m, l, true);
    let radius = grid(l, 0.1, 0.6, 2);
    let direction = grid(l, -45.0, 45.0, 0);
    let through = place(l);
    let centre = plus(through, radius, quarter(unit(radians(direction))));
    m.put(0, on(0.0), centre, m.axis(m.angle));
    m.hold(l, Hold::Line((0, on(0.0)), radius, true, through, direction, None));
    false
}

fn on_a_cylinder(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "on a cylinder";
    let inside = l.in_100(60);
    let arc = grid(l, 0.4, 1.5, 2);
    let rolls = l.in_100(75);
    let radius = match (inside, l.below(3)) {
        (true, 0) if rolls => arc + grid(l, 0.1, 0.8, 2),
        (true, _) => grid(l, 0.1, arc - 0.1, 2),
        _ => grid(l, 0.1, 0.9, 2),
    };
    if rolls {
        wheel(m, l, true);
    } else {
        m.body(l, &[on(0.0)], None, false, true, "");
    }
    let radius = if rolls { (radius * 100.0).round() / 100.0 } else { 0.0 };
    let axis = if l.in_100(50) { [0.0, 0.0] } else { place(l) };
    // It stays where it presses: above the cylinder, low inside it, about the peg below its centre's height.
    let from_down = grid(l, -70.0, 70.0, 0);
    let up = if inside { -90.0 } else { 90.0 };
    let body = &m.bodies[0];
    m.angle = (up + from_down - body.from) * body.sense;
    let apart = if inside { (arc - radius).abs() } else { arc + radius };
    let out = m.axis(m.angle);
    let centre = plus(axis, apart, unit(out));
    // Its own axis stands at this angle too, at the start.
    m.put(0, on(0.0), centre, if rolls { out } else { 0.0 });
    let mu = (!rolls).then(|| grid(l, 0.02, 0.6, 2)).filter(|_| l.in_100(50));
    m.hold(l, Hold::Arc((0, on(0.0)), radius, rolls, axis, arc, inside, (mu, None)));
    false
}

/// A wheel that rubs where it is held: in a corner, on a line at the end of a rod or of a link; or a drum that a lever or a wheel on it
/// brakes.
fn rubbing(m: &mut Machine, l: &mut Lot) -> Option<bool> {
    m.kind = "rubbing";
    wheel(m, l, true);
    let hub = (0, on(0.0));
    let rough = |l: &mut Lot| l.in_100(80).then(|| grid(l, 0.05, 0.7, 2));
    let radius = grid(l, 0.1, 0.6, 2);
    let directions = [0.0, -90.0, 90.0, grid(l, -60.0, 60.0, 0)];
    let (direction, through) = (l.of(&directions), place(l));
    let along = unit(radians(direction));
    let above = plus(through, radius, quarter(along));
    match l.below(4) {
        0 => {
            let (other, beyond, mu) = (grid(l, -180.0, 180.0, 0), place(l), rough(l));
            let across = unit(radians(other));
            let sine = dot(quarter(along), across);
            if sine.abs() < 0.3 {
                return None;
            }
            let far = plus(beyond, radius, quarter(across));
            let ahead = dot(plus(far, -1.0, above), quarter(across)) / dot(along, quarter(across));
            m.put(0, on(0.0), plus(above, ahead, along), m.axis(m.angle));
            m.hold(l, Hold::Line(hub, radius, false, through, direction, mu));
            let mu = rough(l);
            m.hold(l, Hold::Line(hub, radius, false, beyond, other, mu));
        }
        1 => {
            let (reach, pin, behind) = (grid(l, 0.3, 2.0, 2), place(l), l.in_100(50));
            bar(m, l, reach, false, if behind { ", side: behind" } else { "" });
            let away = plus(above, -1.0, pin);
            let aside = dot(away, quarter(along));
            if aside.abs() > 0.9 * reach {
                return None;
            }
            let ahead = libm::sqrt(reach * reach - aside * aside) * if behind { -1.0 } else { 1.0 };
            let centre = plus(plus(pin, ahead, along), aside, quarter(along));
            m.put(0, on(0.0), centre, m.axis(m.angle));
            m.put(1, on(0.0), pin, libm::atan2(centre[1] - pin[1], centre[0] - pin[0]));
            m.hold(l, Hold::Pin((1, on(0.0)), pin));
            m.hold(l, Hold::Hinge((1, on(reach)), hub));
            let mu = rough(l);
            m.hold(l, Hold::Line(hub, radius, false, through, direction, mu));
        }
        2 => {
            let direction = l.of(&directions[..3]);
            let foot = plus(through, -radius, quarter(unit(radians(direction))))
                .map(|x| (x * 100.0).round() / 100.0);
            let text = format!(", placed: [{:.2} m, {:.2} m]", through[0], through[1]);
            let last = m.body_text.pop()?;
            m.body_text.push(format!("{}{text}}}", &last[..last.len() - 1]));
            m.put(0, on(0.0), through, m.axis(m.angle));
            let far = place(l);
            if length(plus(far, -1.0, through)) < 0.2 {
                return None;
            }
            let mu = rough(l);
            m.hold(l, Hold::Line(hub, radius, false, foot, direction, mu));
            let rod = l.in_100(70);
            m.hold(l, Hold::Cord(hub, far, rod));
        }
        _ => {
            let (reach, pin, axle) = (grid(l, 0.3, 2.0, 2), place(l), through);
            bar(m, l, reach, false, "");
            let apart = plus(axle, -1.0, pin);
            let d = length(apart);
            let along = (reach * reach - radius * radius + d * d) / (2.0 * d);
            let square = reach * reach - along * along;
            if !(square > 0.02 * reach * reach) {
                return None;
            }
            // By default on the left of the line from its pin to the axle.
            let e = apart.map(|x| x / d);
            let shoe = plus(plus(pin, along, e), libm::sqrt(square), quarter(e));
            m.put(0, on(0.0), axle, m.axis(m.angle));
            m.put(1, on(0.0), pin, libm::atan2(shoe[1] - pin[1], shoe[0] - pin[0]));
            m.plain_pin(hub, axle);
            m.hold(l, Hold::Pin((1, on(0.0)), pin));
            let mu = rough(l);
            m.hold(l, Hold::Arc((1, on(reach)), 0.0, false, axle, radius, false, (mu, Some(hub))));
        }
    }
    Some(false)
}

/// Two light rods or cords to fixed places, or one and a guide.
fn on_links(m: &mut Machine, l: &mut Lot) -> Option<bool> {
    m.kind = "on links";
    let reach = grid(l, 0.3, 2.0, 2);
    let at = place(l);
    bar(m, l, reach, true, &format!(", placed: [{:.2} m, {:.2} m]", at[0], at[1]));
    m.put(0, on(0.0), at, m.axis(m.angle));
    let ends = [on(0.0), on(reach)];
    let guided = l.below(4);
    for (i, end) in ends.into_iter().enumerate() {
        let near = m.at((0, end));
        if i == guided {
            let words = [0.0, -90.0, grid(l, 1.0, 89.0, 0)];
            let direction = l.of(&words);
            let through = if i == 0 { at } else { return None };
            m.hold(l, Hold::Guide((0, end), through, direction, false, None));
            continue;
        }
        let far = place(l);
        if length(plus(far, -1.0, near)) < 0.2 {
            return None;
        }
        let rod = l.in_100(70);
        m.hold(l, Hold::Cord((0, end), far, rod));
    }
    Some(false)
}

/// Let go at an instant: one to three bodies on cords, pins and hinges, with whatever freedoms that leaves. What hangs on a pin may turn,
/// each body on its own.
fn let_go(m: &mut Machine, l: &mut Lot) -> bool {
    m.kind = "let go";
    let reach = grid(l, 0.3, 2.0, 2);
    let at = place(l);
    let text = format!(", placed: [{:.2} m, {:.2} m]", at[0], at[1]);
    let hung = l.below(3);
    bar(m, l, reach, true, if hung == 0 { "" } else { &text });
    m.put(0, on(0.0), at, m.axis(m.angle));
    match hung {
        0 => m.hold(l, Hold::Pin((0, on(0.0)), at)),
        1 => {
            let far = plus(at, 1.0, [grid(l, -1.0, 1.0, 2), grid(l, 0.2, 1.5, 2)])
                .map(|x| (x * 100.0).round() / 100.0);
            m.hold(l, Hold::Cord((0, on(0.0)), far, far[0] > at[0]));
        }
        _ => {}
    }
    let turns = hung == 0 && l.in_100(60);
    if turns {
        m.spin = spinning(l);
    }
    for i in 1..1 + l.below(3) {
        let reach = grid(l, 0.3, 1.5, 2);
        bar(m, l, reach, true, "");
        let angle = grid(l, 0.0, 359.0, 0);
        let own = &m.bodies[i];
        let axis = radians(own.from + own.sense * angle);
        let last = *m.bodies[i - 1].points.last().expect("a point");
        let hinge = m.at((i - 1, last));
        m.put(i, on(0.0), hinge, axis);
        m.hold(l, Hold::Hinge((i - 1, last), (i, on(0.0))));
        let angle = m.number(l, angle, 0, "deg");
        let mut told = format!("angle: {angle}");
        if turns {
            let spin = spinning(l);
            m.spins.push((i, spin));
            let spin = m.number(l, spin, 1, "rad/s");
            let _ = write!(told, ", spin: {spin}");
        }
        m.start_text.push(format!("{}: {{{told}}}", Machine::names(i)));
    }
    true
}

/// A spin that is not 0.
fn spinning(l: &mut Lot) -> f64 {
    let spin = grid(l, 0.1, 6.0, 1);
    if l.in_100(50) { -spin } else { spin }
}

/// Another body on a point of what is there, and there to stay.
fn weld(m: &mut Machine, l: &mut Lot) {
    let (one, new) = (l.below(m.bodies.len()), m.bodies.len());
    if !m.bodies[one].turns || new == 4 {
        return;
    }
    let reach = grid(l, 0.1, 0.8, 2);
    bar(m, l, reach, false, "");
    let points = [&m.bodies[one].points, &m.bodies[new].points].map(|all| all[l.below(all.len())]);
    let spots = [(one, points[0]), (new, points[1])];
    let turn = grid(l, -180.0, 180.0, 0);
    m.put(new, points[1], m.at(spots[0]), m.start[3 * one + 2] + radians(turn));
    m.hold(l, Hold::Weld(spots[0], spots[1], turn));
}

impl Machine {
    /// A pin of which the place is told in numbers.
    fn plain_pin(&mut self, at: Spot, place: V2) {
        let (name, [x, y]) = (self.holds.len() + 1, place);
        self.joint_text.push(format!("j{name}: {{pins: {}, at: [{x:.2} m, {y:.2} m]}}", self.spot_text(at)));
        self.holds.push(Hold::Pin(at, place));
    }
    /// Strikes a point of it at the start.
    pub fn strike(&mut self, lot: &mut Lot) {
        let body = lot.below(self.bodies.len());
        let points = &self.bodies[body].points;
        let at = (body, points[lot.below(points.len())]);
        let (blow, direction) = (grid(lot, 0.5, 9.0, 1), grid(lot, -180.0, 180.0, 0));
        let on = self.spot_text(at);
        let (j, d) = (self.number(lot, blow, 1, "N*s"), self.number(lot, direction, 0, "deg"));
        self.force_text.push(format!("impulse: {{on: {on}, magnitude: {j}, direction: {d}}}"));
        self.loads.push(Load::Blow(at, blow, radians(direction)));
    }
    /// Has what leads driven, at the start.
    pub fn drive(&mut self, lot: &mut Lot) {
        let alpha = grid(lot, -20.0, 20.0, 1);
        let text = self.number(lot, alpha, 1, "rad/s^2");
        let start = self.start_text[0].trim_end_matches('}');
        self.start_text[0] = format!("{start}, alpha: {text}}}");
        self.alpha = Some(alpha);
        self.end = Ending::AtOnce;
    }
    /// Leaves it at rest at the start.
    pub fn stop(&mut self) {
        if self.spin != 0.0 {
            let start = self.start_text[0].split(", spin").next().expect("an angle");
            self.start_text[0] = format!("{start}}}");
            self.spin = 0.0;
        }
    }
}

/// Up to three forces, couples and springs at named points.
fn loads(m: &mut Machine, l: &mut Lot) {
    for _ in 0..l.of(&[0, 0, 1, 1, 2, 3]) {
        let body = l.below(m.bodies.len());
        let points = m.bodies[body].points.clone();
        let spot = (body, points[l.below(points.len())]);
        let on = m.spot_text(spot);
        match l.below(4) {
            0 => {
                let force = grid(l, 1.0, 90.0, 0);
                let turns = m.bodies[body].turns && l.in_100(40);
                let direction = grid(l, -180.0, 180.0, 0);
                let vertical = m.kind == "on a floor";
                let direction = if vertical { l.of(&[90.0, -90.0]) } else { direction };
                let turns = turns && !vertical;
                let (f, d) = (m.number(l, force, 0, "N"), m.number(l, direction, 0, "deg"));
                let word = if turns { "from the axis" } else { "direction" };
                m.force_text.push(format!("force: {{on: {on}, magnitude: {f}, {word}: {d}}}"));
                m.loads.push(Load::Force(spot, force, radians(direction), turns));
            }
            1 if m.bodies[body].turns && l.in_100(30) => {
                let (stiffness, relaxed) = (grid(l, 1.0, 60.0, 0), grid(l, -180.0, 180.0, 0));
                let (kt, angle) = (m.number(l, stiffness, 0, "N*m/rad"), m.number(l, relaxed, 0, "deg"));
                m.force_text.push(format!("torsion: {{on: {on}, stiffness: {kt}, relaxed at: {angle}}}"));
                let Body { from, sense, .. } = m.bodies[body];
                m.loads.push(Load::Torsion(body, stiffness, radians(from + sense * relaxed)));
            }
            1 if m.bodies[body].turns => {
                let moment = grid(l, 1.0, 40.0, 0);
                let forward = l.in_100(50);
                let text = m.number(l, moment, 0, "N*m");
                let word = if forward { "forward" } else { "back" };
                let name = Machine::names(body);
                m.force_text.push(format!("couple: {{on: {name}, moment: {text}, sense: {word}}}"));
                let sense = m.bodies[body].sense * if forward { 1.0 } else { -1.0 };
                m.loads.push(Load::Couple(body, moment * sense));
            }
            _ if m.kind != "on a floor" => {
                let other = l.below(m.bodies.len());
                let far = if other != body && l.in_100(50) {
                    let points = &m.bodies[other].points;
                    Far::Spot((other, points[l.below(points.len())]))
                } else {
                    Far::Place(place(l))
                };
                let (to, at) = match far {
                    Far::Place(at) => (m.place(l, at), at),
                    Far::Spot(s) => (m.spot_text(s), m.at(s)),
                };
                // A spring of no length has no direction.
                if length(plus(at, -1.0, m.at(spot))) < 0.1 {
                    continue;
                }
                if let Far::Place(at) = far
                    && l.in_100(30)
                {
                    let force = grid(l, 1.0, 90.0, 0);
                    let f = m.number(l, force, 0, "N");
                    m.force_text.push(format!("force: {{on: {on}, magnitude: {f}, toward: {to}}}"));
                    m.loads.push(Load::Pull(spot, at, force));
                    continue;
                }
                let (stiffness, natural) = (grid(l, 5.0, 300.0, 0), grid(l, 0.05, 1.5, 2));
                let (ks, l0) = (m.number(l, stiffness, 0, "N/m"), m.number(l, natural, 2, "m"));
                let (acts, only) =
                    l.of(&[(0.0, ""), (0.0, ""), (1.0, ", only: pulls"), (-1.0, ", only: pushes")]);
                m.force_text.push(format!(
                    "spring: {{on: {on}, to: {to}, stiffness: {ks}, natural length: {l0}{only}}}"
                ));
                m.loads.push(Load::Spring(spot, far, stiffness, natural, acts));
            }
            _ => {}
        }
    }
}

/// The bank of a mechanism.
pub fn yaml(m: &Machine) -> String {
    let lead = Machine::names(m.lead);
    let end = match m.end {
        Ending::AtOnce => "at once".to_owned(),
        Ending::Angle(a) => format!("{{angle: {{of: {lead}, reaches: {a:.0} deg}}}}"),
        Ending::Time(t) => format!("{{time: {{of: {lead}, is: {t:.2} s}}}}"),
        Ending::Turns => format!("{{turning point: {lead}}}"),
        Ending::Equilibrium => "equilibrium".to_owned(),
        Ending::Leaves(j) => format!("{{leaves: j{}}}", j + 1),
    };
    let (quantity, unit) = match m.end {
        Ending::Equilibrium => ("phi", "rad"),
        _ if m.carried != [0.0; 2] && m.bodies[m.lead].turns => ("omega", "rad/s"),
        _ if m.carried != [0.0; 2] => ("a_x", "m/s^2"),
        _ if m.bodies.len() == 1 => ("kinetic_energy", "J"),
        _ => ("v_x", "m/s"),
    };
    let quantity = if m.bodies.len() == 1 { quantity.to_owned() } else { format!("{lead}.{quantity}") };
    let list = |lines: &[String], mark: &str| {
        lines.iter().fold(String::new(), |mut all, line| {
            let _ = writeln!(all, "        {mark}{line}");
            all
        })
    };
    let forces = if m.force_text.is_empty() {
        String::new()
    } else {
        format!("      forces:\n{}", list(&m.force_text, "- "))
    };
    let carried = match m.carried {
        [0.0, 0.0] => String::new(),
        [0.0, up] => format!("      carried: {{along: vertical, acceleration: {up} m/s^2}}\n"),
        [right, _] => format!("      carried: {{along: horizontal, acceleration: {right} m/s^2}}\n"),
    };
    let joints = if m.joint_text.is_empty() {
        String::new()
    } else {
        format!("      joints:\n{}", list(&m.joint_text, ""))
    };
    format!(
        "bank: lot\ntitle: t\ngravity: {:.2} m/s^2\nproblems:\n  p:\n    title: t\n    data: {{{}}}\n    scene:\n{carried}      bodies:\n{}{joints}{forces}      start: {{{}}}\n      end: {end}\n    questions: {{q: {{quantity: {quantity}, ask: q, unit: {unit}}}}}\n",
        m.gravity,
        m.data.join(", "),
        list(&m.body_text, ""),
        m.start_text.join(", "),
    )
}
