//! Scenes composed by lot: bodies, contacts, cords, couples, a start and an end in any combination that the bank's words
//! allow, as the text of a bank. What is drawn is kept in the words of the bank, so that a judge can read them for itself.
use std::fmt::Write as _;

/// A small generator of random numbers (splitmix64): the same scenes on every machine.
pub struct Lot(u64);

impl Lot {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5d2c_41a7_93b1_6e0f)
    }
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    pub fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % (n as u64)).expect("small")
    }
    pub fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }
    /// True in so many of 100.
    pub fn in_100(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
}

/// A number as the bank has it: a decimal and a unit; and its SI value as this test reads it.
#[derive(Clone)]
pub struct Amount {
    pub text: String,
    pub unit: &'static str,
    pub si: f64,
    /// Is it a datum of the problem? Else it stands in the scene as a constant.
    pub symbol: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Way {
    /// On a surface: index.
    Along(usize),
    Vertically,
    Axle,
}

#[derive(Clone)]
pub struct Surface {
    pub name: &'static str,
    /// `None`: said in a word, level (false) or vertical (true).
    pub slope: Option<Amount>,
    pub vertical: bool,
}

#[derive(Clone)]
pub enum Spread {
    /// It does not turn.
    Block,
    Gyration(Amount),
    Moment(Amount),
    /// Word and radius.
    Shape(&'static str, Amount),
    /// Discs: mass and radius of each.
    Discs(Vec<(Amount, Amount)>),
}

#[derive(Clone)]
pub struct Body {
    pub name: String,
    pub way: Way,
    /// Is the positive sense written, and which word?
    pub positive: Option<&'static str>,
    /// Mass, or weight if the unit is one of force; none where the parts or the moment say it.
    pub mass: Option<Amount>,
    pub spread: Spread,
    pub radii: Vec<(&'static str, Amount)>,
}

#[derive(Clone)]
pub struct End {
    pub body: usize,
    /// `None`: tied at the centre.
    pub wound: Option<&'static str>,
    pub leaves: &'static str,
    /// Degrees away from the surface.
    pub tilt: Option<i8>,
}

#[derive(Clone)]
pub enum Far {
    Pulled(Amount),
    To(End),
    Fast,
    Spring { stiffness: Amount, stretch: Amount, rigid: bool },
}

#[derive(Clone)]
pub enum Tie {
    Rolls {
        body: usize,
        on: &'static str,
        mu_s: Option<Amount>,
    },
    Slips {
        body: usize,
        on: &'static str,
        mu_s: Amount,
        mu_k: Amount,
    },
    Slides {
        body: usize,
        mu_s: Option<Amount>,
        mu_k: Amount,
    },
    Cord {
        from: End,
        far: Far,
    },
    /// A light rod between two centres.
    Link {
        from: End,
        to: End,
    },
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Event {
    Travel,
    Turn,
    Position,
    Time,
    Speed,
    TurningPoint,
    AtOnce,
    Rolling,
}

#[derive(Clone)]
pub struct Scene {
    pub gravity: Amount,
    pub surfaces: Vec<Surface>,
    pub bodies: Vec<Body>,
    pub ties: Vec<Tie>,
    /// Body, moment, forward.
    pub couples: Vec<(usize, Amount, bool)>,
    /// Body, is it a spin, how much.
    pub start: Vec<(usize, bool, Amount)>,
    pub event: Event,
    /// The body that the end watches.
    pub of: usize,
    pub by: Option<Amount>,
    pub heading: Option<&'static str>,
    /// For the table: what this scene has.
    pub constructs: Vec<&'static str>,
}

struct Maker<'l> {
    lot: &'l mut Lot,
    data: usize,
    most: usize,
}

impl Maker<'_> {
    /// `digits * 10^-decimals unit`, the unit this many SI units.
    fn amount(&mut self, digits: i64, decimals: usize, unit: &'static str, si: f64) -> Amount {
        let scale = [1.0, 10.0, 100.0, 1000.0, 10_000.0][decimals];
        let text = if decimals == 0 {
            digits.to_string()
        } else {
            format!("{:.*}", decimals, digits as f64 / scale)
        };
        // Degrees stay degrees.
        let value = digits as f64 / scale * si;
        let symbol = (self.data < self.most && self.lot.in_100(75)).then(|| {
            self.data += 1;
            format!("x{}", self.data)
        });
        Amount { text, unit, si: value, symbol }
    }
    fn whole(&mut self, low: i64, high: i64) -> i64 {
        low + i64::try_from(self.lot.below(usize::try_from(high - low + 1).expect("a range"))).expect("small")
    }
    fn mass(&mut self) -> Amount {
        // Often the same, so that things balance.
        let kg = if self.lot.in_100(30) { 20 } else { self.whole(5, 300) };
        match self.lot.below(4) {
            0 => self.amount(kg * 100, 0, "g", 1e-3),
            1 => self.amount(kg * 9, 1, "N", 1.0),
            _ => self.amount(kg, 1, "kg", 1.0),
        }
    }
    fn radius(&mut self) -> Amount {
        let cm = if self.lot.in_100(30) { 20 } else { self.whole(5, 60) };
        match self.lot.below(3) {
            0 => self.amount(cm * 10, 0, "mm", 1e-3),
            1 => self.amount(cm, 0, "cm", 1e-2),
            _ => self.amount(cm, 2, "m", 1.0),
        }
    }
    fn friction(&mut self, low: i64, high: i64) -> Amount {
        let mu = if self.lot.in_100(5) { 0 } else { self.whole(low, high) };
        self.amount(mu, 2, "1", 1.0)
    }
    /// 0 once in a while.
    fn some(&mut self, low: i64, high: i64, decimals: usize, unit: &'static str) -> Amount {
        let x = if self.lot.in_100(6) { 0 } else { self.whole(low, high) };
        self.amount(x, decimals, unit, 1.0)
    }

    fn body(&mut self, name: String, surfaces: &[Surface], kind: usize) -> Body {
        let mut radii = Vec::new();
        let way = match kind {
            0 | 1 if !surfaces.is_empty() => Way::Along(self.lot.below(surfaces.len())),
            0 | 3 => Way::Vertically,
            1 => Way::Vertically,
            _ => Way::Axle,
        };
        let turns = kind != 0;
        let mut mass = Some(self.mass());
        let spread = if turns {
            if self.lot.in_100(60) {
                radii.push(("rim", self.radius()));
            }
            if self.lot.in_100(60) {
                radii.push(("inside", self.radius()));
            }
            if radii.is_empty() {
                radii.push(("band", self.radius()));
            }
            match self.lot.below(6) {
                0 | 1 => Spread::Gyration(self.radius()),
                2 => {
                    let i = if self.lot.in_100(8) { 0 } else { self.whole(1, 400) };
                    if way == Way::Axle {
                        mass = None;
                    }
                    Spread::Moment(self.amount(i, 2, "kg*m^2", 1.0))
                }
                3 => {
                    mass = None;
                    let n = 1 + self.lot.below(2);
                    let part = |m: &mut Self| {
                        let kg = m.whole(5, 200);
                        (m.amount(kg, 1, "kg", 1.0), m.radius())
                    };
                    Spread::Discs((0..n).map(|_| part(self)).collect())
                }
                _ => {
                    let radius = self.radius();
                    let word = self.lot.of(&["disc", "hoop", "sphere", "shell"]);
                    Spread::Shape(word, radius)
                }
            }
        } else {
            Spread::Block
        };
        let level = matches!(way, Way::Along(s) if surfaces[s].slope.is_none() && !surfaces[s].vertical);
        let positive = match way {
            Way::Axle => None,
            _ if self.lot.in_100(40) => None,
            _ if level => Some(self.lot.of(&["forward", "right", "back", "left"])),
            _ => Some(self.lot.of(&["up", "down"])),
        };
        // A uniform shape has its radius as its rim.
        if let Spread::Shape(_, r) = &spread
            && !radii.iter().any(|(n, _)| *n == "rim")
        {
            radii.push(("rim", r.clone()));
        }
        Body { name, way, positive, mass, spread, radii }
    }

    fn end(&mut self, bodies: &[Body], surfaces: &[Surface], body: usize) -> End {
        let b = &bodies[body];
        let can_tie = b.way != Way::Axle;
        let can_wind = !matches!(b.spread, Spread::Block);
        if can_wind && (!can_tie || self.lot.in_100(60)) {
            let radius = b.radii[self.lot.below(b.radii.len())].0;
            let plain = ["top forward", "top back", "bottom forward", "bottom back"];
            let hanging = ["front down", "back down", "front up", "back up"];
            let leaves = match b.way {
                Way::Along(_) => self.lot.of(&plain),
                Way::Axle => {
                    if self.lot.in_100(60) {
                        self.lot.of(&hanging)
                    } else {
                        self.lot.of(&plain)
                    }
                }
                Way::Vertically => match self.lot.below(3) {
                    0 => "up",
                    1 => self.lot.of(&hanging),
                    _ => self.lot.of(&plain),
                },
            };
            return End { body, wound: Some(radius), leaves, tilt: None };
        }
        let level = matches!(b.way, Way::Along(s) if surfaces[s].slope.is_none() && !surfaces[s].vertical);
        let leaves = if level {
            self.lot.of(&["forward", "back"])
        } else {
            self.lot.of(&["forward", "back", "up", "down"])
        };
        End { body, wound: None, leaves, tilt: None }
    }
}

/// The scene of a seed.
pub fn scene(seed: u64) -> Scene {
    let mut lot = Lot::new(seed);
    let most = lot.of(&[0, 6, 9, 9, 20, 23, 40]);
    let mut m = Maker { lot: &mut lot, data: 0, most };
    let g = m.lot.of(&[981, 981, 981, 1000, 162]);
    let mut gravity = m.amount(g, 2, "m/s^2", 1.0);
    gravity.symbol = None;
    let mut surfaces = Vec::new();
    let theta = if m.lot.in_100(6) { m.lot.of(&[0, 90]) } else { m.whole(1, 60) };
    if m.lot.in_100(60) {
        let slope = m.amount(theta, 0, "deg", 1.0);
        surfaces.push(Surface { name: "incline", slope: Some(slope), vertical: false });
    }
    if m.lot.in_100(45) || surfaces.is_empty() {
        surfaces.push(Surface { name: "floor", slope: None, vertical: false });
    }
    if m.lot.in_100(5) {
        surfaces.push(Surface { name: "wall", slope: None, vertical: true });
    }
    let count = m.lot.of(&[1, 1, 2, 2, 2, 3, 3, 4]);
    let mut bodies = Vec::new();
    for i in 0..count {
        // Blocks, wheels, drums, yo-yos.
        let kind = if count == 1 {
            m.lot.of(&[0, 1, 1, 1, 2, 3, 3])
        } else {
            m.lot.of(&[0, 0, 0, 1, 1, 1, 2, 2, 3])
        };
        let name = format!("{}{}", ["block", "wheel", "drum", "yoyo"][kind], i + 1);
        bodies.push(m.body(name, &surfaces, kind));
    }
    // A surface that bears nothing is a finding.
    let mut kept: Vec<usize> = Vec::new();
    for b in &mut bodies {
        if let Way::Along(s) = &mut b.way {
            let at = kept.iter().position(|k| k == s).unwrap_or_else(|| {
                kept.push(*s);
                kept.len() - 1
            });
            *s = at;
        }
    }
    let surfaces: Vec<Surface> = kept.into_iter().map(|k| surfaces[k].clone()).collect();
    let mut ties = Vec::new();
    let mut free = 0usize;
    for (i, b) in bodies.iter().enumerate() {
        free += usize::from(b.way != Way::Axle) + usize::from(!matches!(b.spread, Spread::Block));
        if !matches!(b.way, Way::Along(_)) {
            continue;
        }
        let wall = matches!(b.way, Way::Along(s) if surfaces[s].vertical);
        if matches!(b.spread, Spread::Block) {
            if m.lot.in_100(60) {
                let mu_k = m.friction(2, 50);
                let mu_s = m.lot.in_100(50).then(|| {
                    let more = m.whole(0, 20);
                    let least: f64 = mu_k.si * 100.0;
                    m.amount(least.round() as i64 + more, 2, "1", 1.0)
                });
                ties.push(Tie::Slides { body: i, mu_s, mu_k });
            }
            continue;
        }
        let on = b.radii[m.lot.below(b.radii.len())].0;
        let slips = m.lot.in_100(if count == 1 { 30 } else { 8 });
        let massless = matches!(&b.spread, Spread::Moment(i) if i.si == 0.0);
        if slips && !wall && !massless {
            let mu_k = m.friction(2, 30);
            let least = (mu_k.si * 100.0).round() as i64;
            let more = m.whole(0, 10);
            let mu_s = m.amount(least + more, 2, "1", 1.0);
            ties.push(Tie::Slips { body: i, on, mu_s, mu_k });
        } else if m.lot.in_100(90) {
            let mu_s = m.lot.in_100(60).then(|| m.friction(20, 90));
            ties.push(Tie::Rolls { body: i, on, mu_s });
            free -= 1;
        }
    }
    // Cords between bodies and to fixed points until one freedom is left; sometimes fewer or more.
    let wanted = m.lot.of(&[1, 1, 1, 1, 1, 1, 2, 2, 0]);
    let mut linked: Vec<usize> = vec![m.lot.below(count)];
    while free > wanted {
        let near = m.lot.below(count);
        let others: Vec<usize> = (0..count).filter(|b| *b != near).collect();
        let fresh: Vec<usize> = others.iter().copied().filter(|b| !linked.contains(b)).collect();
        let (near, far) = if let Some(far) = fresh.first() {
            (linked[m.lot.below(linked.len())], Some(*far))
        } else if others.is_empty() || m.lot.in_100(45) {
            (near, None)
        } else {
            (near, Some(others[m.lot.below(others.len())]))
        };
        let from = m.end(&bodies, &surfaces, near);
        match far {
            Some(far) => {
                linked.push(far);
                let to = m.end(&bodies, &surfaces, far);
                ties.push(Tie::Cord { from, far: Far::To(to) });
            }
            None => ties.push(Tie::Cord { from, far: Far::Fast }),
        }
        free -= 1;
        if m.lot.in_100(6) {
            break;
        }
    }
    for _ in 0..m.lot.of(&[0, 0, 1, 1, 2]) {
        let body = m.lot.below(count);
        let from = m.end(&bodies, &surfaces, body);
        let p = m.some(10, 600, 0, "N");
        ties.push(Tie::Cord { from, far: Far::Pulled(p) });
    }
    let springs = m.lot.of(&[0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 2]) + usize::from(m.lot.in_100(2));
    for _ in 0..springs {
        let body = m.lot.below(count);
        let from = m.end(&bodies, &surfaces, body);
        let stiffness = m.whole(20, 800);
        let stiffness = m.amount(stiffness, 0, "N/m", 1.0);
        let stretch = m.some(2, 60, 2, "m");
        let rigid = m.lot.in_100(40);
        ties.push(Tie::Cord { from, far: Far::Spring { stiffness, stretch, rigid } });
    }
    let mut couples = Vec::new();
    for (i, b) in bodies.iter().enumerate() {
        if !matches!(b.spread, Spread::Block) && m.lot.in_100(25) {
            let moment = m.some(10, 900, 1, "N*m");
            let forward = m.lot.in_100(50);
            couples.push((i, moment, forward));
        }
    }
    let mut start = Vec::new();
    if m.lot.in_100(25) {
        let body = m.lot.below(count);
        let turns = !matches!(bodies[body].spread, Spread::Block);
        let spin = bodies[body].way == Way::Axle || turns && m.lot.in_100(40);
        let v = m.some(-40, 40, 1, if spin { "rad/s" } else { "m/s" });
        start.push((body, spin, v));
    }
    let of = m.lot.below(count);
    let line = bodies[of].way != Way::Axle;
    let turns = !matches!(bodies[of].spread, Spread::Block);
    let event = m.lot.of(&[
        Event::Travel,
        Event::Travel,
        Event::Travel,
        Event::Turn,
        Event::Position,
        Event::Time,
        Event::Time,
        Event::Speed,
        Event::TurningPoint,
        Event::AtOnce,
    ]);
    let event = match event {
        Event::Turn if !turns => Event::Travel,
        Event::Position if !line => Event::Turn,
        Event::Travel if !line => Event::Turn,
        e => e,
    };
    let by = match event {
        Event::Travel => Some(m.some(2, 250, 2, "m")),
        Event::Turn if m.lot.in_100(30) => {
            let deg = m.whole(5, 700);
            Some(m.amount(deg, 0, "deg", std::f64::consts::PI / 180.0))
        }
        Event::Turn => Some(m.some(2, 90, 1, "rad")),
        Event::Position => Some(m.some(-200, 200, 2, "m")),
        Event::Time => Some(m.some(5, 200, 2, "s")),
        Event::Speed => Some(m.some(5, 300, 2, if line { "m/s" } else { "rad/s" })),
        Event::TurningPoint | Event::AtOnce | Event::Rolling => None,
    };
    let headed = matches!(event, Event::Travel | Event::Turn | Event::Speed | Event::Time | Event::Position);
    let heading = (headed && m.lot.in_100(12)).then(|| m.lot.of(&["forward", "back"]));
    let mut scene = Scene {
        gravity,
        surfaces,
        bodies,
        ties,
        couples,
        start,
        event,
        of,
        by,
        heading,
        constructs: Vec::new(),
    };
    pull_aside(&mut scene, seed);
    stiffen(&mut scene, seed);
    scene.constructs = constructs(&scene);
    // Radii that nothing uses are no data.
    scene
}

/// Some pulls lead away from their surfaces, or toward them.
fn pull_aside(s: &mut Scene, seed: u64) {
    let mut lot = Lot::new(seed ^ 0x7117_ed00);
    let Scene { bodies, ties, .. } = s;
    for tie in ties {
        if let Tie::Cord { from, far: Far::Pulled(_) } = tie
            && matches!(bodies[from.body].way, Way::Along(_))
            && lot.in_100(40)
        {
            from.tilt = Some(i8::try_from(lot.below(120)).expect("small") - 40);
        }
    }
}

/// Some cords that run straight from one centre to another are light rods.
fn stiffen(s: &mut Scene, seed: u64) {
    let mut lot = Lot::new(seed ^ 0x0571_ff00);
    let Scene { bodies, surfaces, ties, .. } = s;
    for tie in ties {
        let Tie::Cord { from, far: Far::To(to) } = tie else { continue };
        let (one, other) = (&bodies[from.body], &bodies[to.body]);
        // Told upward, so that the positive senses do not matter.
        let level = |b: &Body| matches!(b.positive, Some("forward" | "right" | "back" | "left"));
        let like = one.way == other.way && one.way != Way::Axle && !level(one) && !level(other);
        let sloped =
            !matches!(one.way, Way::Along(i) if surfaces[i].slope.is_none() && !surfaces[i].vertical);
        if like && sloped && lot.in_100(60) {
            let straight = |end: &End, leaves| End { wound: None, leaves, ..end.clone() };
            *tie = Tie::Link { from: straight(from, "up"), to: straight(to, "down") };
        }
    }
}

fn constructs(s: &Scene) -> Vec<&'static str> {
    let mut list: Vec<&'static str> =
        vec![["one body", "two bodies", "three bodies", "four bodies"][s.bodies.len() - 1]];
    for b in &s.bodies {
        list.push(match (b.way, &b.spread) {
            (_, Spread::Block) => "block",
            (Way::Along(_), _) => "wheel",
            (Way::Axle, _) => "drum",
            (Way::Vertically, _) => "yo-yo",
        });
    }
    for t in &s.ties {
        list.push(match t {
            Tie::Rolls { .. } => "rolls",
            Tie::Slips { .. } => "slips",
            Tie::Slides { .. } => "slides",
            Tie::Cord { from: End { tilt: Some(_), .. }, .. } => "pull at an angle",
            Tie::Link { .. } => "light rod",
            Tie::Cord { far: Far::Pulled(_), .. } => "pull",
            Tie::Cord { far: Far::To(_), .. } => "cord between bodies",
            Tie::Cord { far: Far::Fast, .. } => "cord held fast",
            Tie::Cord { far: Far::Spring { rigid, .. }, .. } => {
                if *rigid {
                    "rigid spring"
                } else {
                    "spring on a cord"
                }
            }
        });
    }
    if !s.couples.is_empty() {
        list.push("couple");
    }
    if !s.start.is_empty() {
        list.push("start with a speed");
    }
    list.push(match s.event {
        Event::Travel => "end: travel",
        Event::Turn => "end: turn",
        Event::Position => "end: position",
        Event::Time => "end: time",
        Event::Speed => "end: speed",
        Event::TurningPoint => "end: turning point",
        Event::AtOnce => "end: at once",
        Event::Rolling => "end: rolling",
    });
    list.sort_unstable();
    list.dedup();
    list
}

/// A scene of a seed set going: contacts that rub, and a speed for each freedom that `adds` says is one beside those before it.
pub fn set_going(seed: u64, adds: impl Fn(&Scene) -> bool) -> Scene {
    let mut s = scene(seed);
    let mut lot = Lot::new(seed ^ 0x90a1_6000);
    let mut m = Maker { lot: &mut lot, data: 100, most: 120 };
    let Scene { bodies, ties, surfaces, .. } = &mut s;
    for tie in ties.iter_mut() {
        let Tie::Rolls { body, on, .. } = *tie else { continue };
        let wall = matches!(bodies[body].way, Way::Along(i) if surfaces[i].vertical);
        let massless = matches!(&bodies[body].spread, Spread::Moment(i) if i.si == 0.0);
        if !wall && !massless && m.lot.in_100(65) {
            let mu_k = m.friction(2, 40);
            let least = (mu_k.si * 100.0).round() as i64;
            let more = m.lot.of(&[0, 5, 20, 40]);
            let mu_s = m.amount(least + more, 2, "1", 1.0);
            *tie = Tie::Slips { body, on, mu_s, mu_k };
        }
    }
    for (i, b) in bodies.iter().enumerate() {
        let rests = matches!(b.way, Way::Along(_)) && matches!(b.spread, Spread::Block);
        let bare = !ties.iter().any(|t| matches!(t, Tie::Slides { body, .. } if *body == i));
        if rests && bare && m.lot.in_100(50) {
            let mu_k = m.friction(5, 60);
            let mu_s = m.lot.in_100(50).then(|| m.amount((mu_k.si * 100.0).round() as i64 + 10, 2, "1", 1.0));
            ties.push(Tie::Slides { body: i, mu_s, mu_k });
        }
    }
    let at_once = m.lot.in_100(12);
    if !at_once {
        ties.retain(|t| !matches!(t, Tie::Cord { far: Far::Spring { .. }, .. }));
    }
    s.start.clear();
    s.heading = None;
    let mut candidates: Vec<(usize, bool)> = Vec::new();
    for (i, b) in s.bodies.iter().enumerate() {
        candidates.extend((b.way != Way::Axle).then_some((i, false)));
        candidates.extend((!matches!(b.spread, Spread::Block)).then_some((i, true)));
    }
    while !candidates.is_empty() {
        let (body, spin) = candidates.swap_remove(m.lot.below(candidates.len()));
        let x = if m.lot.in_100(15) { 0 } else { m.whole(-60, 60) };
        let v = m.amount(if spin { 4 * x } else { x }, 1, if spin { "rad/s" } else { "m/s" }, 1.0);
        s.start.push((body, spin, v));
        if !adds(&s) {
            s.start.pop();
        }
    }
    let slipping: Vec<usize> = s
        .ties
        .iter()
        .filter_map(|t| if let Tie::Slips { body, .. } = t { Some(*body) } else { None })
        .collect();
    if at_once {
        (s.event, s.by) = (Event::AtOnce, None);
    } else if !slipping.is_empty() && m.lot.in_100(30) {
        (s.event, s.by, s.of) = (Event::Rolling, None, m.lot.of(&slipping));
    } else if matches!(s.event, Event::AtOnce) || m.lot.in_100(35) {
        let time = m.lot.of(&[5, 20, 50, 100, 200, 400]) + m.whole(0, 40);
        (s.event, s.by) = (Event::Time, Some(m.amount(time, 2, "s", 1.0)));
    }
    s.constructs = constructs(&s);
    s
}

/// The same with every datum a little off, each by its own share: data that are equal by chance are so no more.
pub fn nudged(mut s: Scene) -> Scene {
    let nudge = |a: &mut Amount| {
        if let Some(n) = a.symbol.as_ref().and_then(|x| x[1..].parse::<u32>().ok()) {
            a.si *= 1.0 + 1e-3 * f64::from(n * n % 31 + 1).sqrt();
        }
    };
    for b in &mut s.bodies {
        if let Spread::Shape(_, r) = &mut b.spread {
            nudge(r);
        }
        b.radii.iter_mut().for_each(|(_, r)| nudge(r));
    }
    s
}

/// The scene as the text of a bank.
pub fn yaml(s: &Scene) -> String {
    let mut data: Vec<&Amount> = Vec::new();
    let mut out = String::new();
    fn say<'a>(a: &'a Amount, data: &mut Vec<&'a Amount>) -> String {
        match &a.symbol {
            Some(symbol) => {
                if !data.iter().any(|d| d.symbol == a.symbol) {
                    data.push(a);
                }
                symbol.clone()
            }
            None if a.unit == "1" => a.text.clone(),
            None => format!("{} {}", a.text, a.unit),
        }
    }
    if !s.surfaces.is_empty() {
        let list: Vec<String> = s
            .surfaces
            .iter()
            .map(|f| match &f.slope {
                Some(slope) => format!("{}: {{slope: {}}}", f.name, say(slope, &mut data)),
                None => format!("{}: {}", f.name, if f.vertical { "vertical" } else { "level" }),
            })
            .collect();
        let _ = writeln!(out, "      surfaces: {{{}}}", list.join(", "));
    }
    out.push_str("      bodies:\n");
    let used = |body: usize, radius: &str| {
        let at = |e: &End| e.body == body && e.wound == Some(radius);
        s.ties.iter().any(|t| match t {
            Tie::Rolls { body: b, on, .. } | Tie::Slips { body: b, on, .. } => *b == body && *on == radius,
            Tie::Slides { .. } => false,
            Tie::Cord { from, far } => at(from) || matches!(far, Far::To(to) if at(to)),
            Tie::Link { .. } => false,
        })
    };
    for (i, b) in s.bodies.iter().enumerate() {
        let mut fields: Vec<String> = Vec::new();
        if let Some(m) = &b.mass {
            let what = if m.unit == "N" { "weight" } else { "mass" };
            fields.push(format!("{what}: {}", say(m, &mut data)));
        }
        let mut own_rim = false;
        match &b.spread {
            Spread::Block => {}
            Spread::Gyration(k) => fields.push(format!("radius of gyration: {}", say(k, &mut data))),
            Spread::Moment(k) => fields.push(format!("moment of inertia: {}", say(k, &mut data))),
            Spread::Shape(word, r) => {
                // Its rim is its own radius unless another is written.
                own_rim =
                    b.radii.iter().any(|(n, a)| *n == "rim" && a.text == r.text && a.symbol == r.symbol);
                fields.push(format!("shape: {{{word}: {}}}", say(r, &mut data)));
            }
            Spread::Discs(parts) => {
                let parts: Vec<String> = parts
                    .iter()
                    .map(|(m, r)| {
                        let m = say(m, &mut data);
                        format!("{{disc: {{mass: {m}, radius: {}}}}}", say(r, &mut data))
                    })
                    .collect();
                fields.push(format!("parts: [{}]", parts.join(", ")));
            }
        }
        let radii: Vec<String> = b
            .radii
            .iter()
            .filter(|(n, _)| used(i, n) && !(own_rim && *n == "rim"))
            .map(|(n, a)| format!("{n}: {}", say(a, &mut data)))
            .collect();
        if !radii.is_empty() {
            fields.push(format!("radii: {{{}}}", radii.join(", ")));
        }
        fields.push(match b.way {
            Way::Along(on) => format!("moves: along {}", s.surfaces[on].name),
            Way::Vertically => "moves: vertically".to_owned(),
            Way::Axle => "moves: about a fixed axle".to_owned(),
        });
        if let Some(p) = b.positive {
            fields.push(format!("positive: {p}"));
        }
        let _ = writeln!(out, "        {}: {{{}}}", b.name, fields.join(", "));
    }
    if !s.ties.is_empty() {
        out.push_str("      ties:\n");
    }
    for t in &s.ties {
        let end = |e: &End| {
            let name = &s.bodies[e.body].name;
            let tilt = e.tilt.map(|tilt| format!(", at an angle: {tilt} deg")).unwrap_or_default();
            match e.wound {
                Some(r) => format!("{{body: {name}, wound on: {r}, leaves: {}{tilt}}}", e.leaves),
                None => format!("{{body: {name}, tied at: centre, leaves: {}{tilt}}}", e.leaves),
            }
        };
        let line = match t {
            Tie::Rolls { body, on, mu_s } => {
                let mu = mu_s.as_ref().map(|m| format!(", mu_s: {}", say(m, &mut data))).unwrap_or_default();
                format!("rolls: {{body: {}, on its: {on}{mu}}}", s.bodies[*body].name)
            }
            Tie::Slips { body, on, mu_s, mu_k } => {
                let (mu_s, mu_k) = (say(mu_s, &mut data), say(mu_k, &mut data));
                format!("slips: {{body: {}, on its: {on}, mu_s: {mu_s}, mu_k: {mu_k}}}", s.bodies[*body].name)
            }
            Tie::Slides { body, mu_s, mu_k } => {
                let mu_k = say(mu_k, &mut data);
                let mu = mu_s.as_ref().map(|m| format!(", mu_s: {}", say(m, &mut data))).unwrap_or_default();
                format!("slides: {{body: {}, mu_k: {mu_k}{mu}}}", s.bodies[*body].name)
            }
            Tie::Link { from, to } => format!("link: {{from: {}, to: {}}}", end(from), end(to)),
            Tie::Cord { from, far } => {
                let far = match far {
                    Far::Pulled(p) => format!("pulled with: {}", say(p, &mut data)),
                    Far::To(to) => format!("to: {}", end(to)),
                    Far::Fast => "held: fast".to_owned(),
                    Far::Spring { stiffness, stretch, rigid } => {
                        let (ks, x0) = (say(stiffness, &mut data), say(stretch, &mut data));
                        let how = if *rigid { "rigidly" } else { "by the cord" };
                        format!("spring: {{stiffness: {ks}, stretch: {x0}, attached: {how}}}")
                    }
                };
                format!("cord: {{from: {}, {far}}}", end(from))
            }
        };
        let _ = writeln!(out, "        - {line}");
    }
    if !s.couples.is_empty() {
        out.push_str("      forces:\n");
    }
    for (body, moment, forward) in &s.couples {
        let sense = if *forward { "forward" } else { "back" };
        let moment = say(moment, &mut data);
        let _ = writeln!(
            out,
            "        - couple: {{on: {}, moment: {moment}, sense: {sense}}}",
            s.bodies[*body].name
        );
    }
    if s.start.is_empty() {
        out.push_str("      start: at rest\n");
    }
    let mut starts: Vec<String> = Vec::new();
    for (i, b) in s.bodies.iter().enumerate() {
        let own = s.start.iter().filter(|(body, ..)| *body == i);
        let own: Vec<String> = own
            .map(|(_, spin, v)| format!("{}: {}", if *spin { "spin" } else { "speed" }, say(v, &mut data)))
            .collect();
        if !own.is_empty() {
            starts.push(format!("{}: {{{}}}", b.name, own.join(", ")));
        }
    }
    if !starts.is_empty() {
        let _ = writeln!(out, "      start: {{{}}}", starts.join(", "));
    }
    let of = &s.bodies[s.of].name;
    let by = s.by.as_ref().map(|b| say(b, &mut data)).unwrap_or_default();
    let heading = s.heading.map(|h| format!(", heading: {h}")).unwrap_or_default();
    let end = match s.event {
        Event::AtOnce => "at once".to_owned(),
        Event::TurningPoint => format!("{{turning point: {of}}}"),
        Event::Rolling => format!("{{rolling: {of}}}"),
        Event::Travel => format!("{{travel: {{of: {of}, by: {by}{heading}}}}}"),
        Event::Turn => format!("{{turn: {{of: {of}, by: {by}{heading}}}}}"),
        Event::Position => format!("{{position: {{of: {of}, at: {by}{heading}}}}}"),
        Event::Time => format!("{{time: {{of: {of}, is: {by}{heading}}}}}"),
        Event::Speed => format!("{{speed: {{of: {of}, reaches: {by}{heading}}}}}"),
    };
    let _ = writeln!(out, "      end: {end}");
    let mut text = format!(
        "bank: composed\ntitle: Composed by lot\ngravity: {} m/s^2\nproblems:\n  composed:\n    title: Composed by lot\n",
        s.gravity.text
    );
    if data.is_empty() {
        text.push_str("    data: {}\n");
    } else {
        text.push_str("    data:\n");
    }
    for d in &data {
        let symbol = d.symbol.as_deref().unwrap_or_default();
        let _ =
            writeln!(text, "      {symbol}: {{name: datum, unit: \"{}\", draw: always {}}}", d.unit, d.text);
    }
    text.push_str("    scene:\n");
    text.push_str(&out);
    text.push_str("    questions:\n      kinetic_energy: {ask: the kinetic energy}\n");
    text
}
