//! The wrong methods of the other families, each against a formula of its own: elementary solutions written here, with the
//! mistake made in them. Nothing is shared with the program but the data of a variant.
use slipstick::bank::{Problem, load};
use slipstick::misconception;
use slipstick::problem::maker::Maker;
use slipstick::scene::Label;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// The data of a variant by symbol: SI, angles in radians.
struct D<'a>(&'a Problem, &'a [f64], &'a str);

impl D<'_> {
    fn of(&self, symbol: &str) -> f64 {
        let i = self.0.data.iter().position(|d| d.symbol == symbol).unwrap_or_else(|| panic!("{symbol}"));
        if self.0.data[i].degrees { self.1[i].to_radians() } else { self.1[i] }
    }
}

/// Answers by question.
type Answers = Vec<(&'static str, f64)>;

fn only(all: Answers, of: &[&str]) -> Answers {
    all.into_iter().filter(|(q, _)| of.contains(q)).collect()
}

// Particles.

fn particles(d: &D) -> Vec<(f64, f64, f64)> {
    ["A", "B", "C", "D", "E", "F"]
        .iter()
        .map(|p| (d.of(&format!("m_{p}")), d.of(&format!("x_{p}")), d.of(&format!("y_{p}"))))
        .filter(|(m, ..)| *m > 0.0)
        .collect()
}

fn mean(list: &[(f64, f64, f64)]) -> (f64, f64, f64) {
    let mass: f64 = list.iter().map(|p| p.0).sum();
    let x: f64 = list.iter().map(|p| p.0 * p.1).sum();
    let y: f64 = list.iter().map(|p| p.0 * p.2).sum();
    (mass, x / mass, y / mass)
}

fn inertia(list: &[(f64, f64, f64)], (x, y): (f64, f64)) -> f64 {
    list.iter().map(|p| p.0 * ((p.1 - x) * (p.1 - x) + (p.2 - y) * (p.2 - y))).sum()
}

/// Mass, mass centre, its velocity as the mean of the particles' velocities, moment of inertia, spin.
struct Lamina {
    list: Vec<(f64, f64, f64)>,
    mass: f64,
    g: (f64, f64),
    a: (f64, f64),
    v_a: (f64, f64),
    v_g: (f64, f64),
    i_g: f64,
    w: f64,
}

fn lamina(d: &D, w: f64) -> Lamina {
    let list = particles(d);
    let (mass, x, y) = mean(&list);
    let a = (d.of("x_A"), d.of("y_A"));
    let v_a = (d.of("vx"), d.of("vy"));
    let v: Vec<(f64, f64, f64)> =
        list.iter().map(|p| (p.0, v_a.0 - w * (p.2 - a.1), v_a.1 + w * (p.1 - a.0))).collect();
    let (_, vx, vy) = mean(&v);
    let i_g = inertia(&list, (x, y));
    Lamina { list, mass, g: (x, y), a, v_a, v_g: (vx, vy), i_g, w }
}

impl Lamina {
    fn energy(&self, v: (f64, f64), i: f64) -> f64 {
        self.mass * (v.0 * v.0 + v.1 * v.1) / 2.0 + i * self.w * self.w / 2.0
    }
    fn of_d(d: &D) -> Self {
        lamina(d, d.of("omega"))
    }
}

/// Wrong methods of a family by their names.
type Methods = &'static [(&'static str, fn(&D) -> Answers)];

const KINETIC: Methods = &[
    ("K01", |d| {
        let b = Lamina::of_d(d);
        let i = inertia(&b.list, (0.0, 0.0));
        vec![("I_G", i), ("kinetic_energy", b.energy(b.v_g, i))]
    }),
    ("K02", |d| {
        let b = Lamina::of_d(d);
        let i = inertia(&b.list, b.a);
        vec![("I_G", i), ("kinetic_energy", b.energy(b.v_g, i))]
    }),
    ("K03", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy(b.v_a, b.i_g))]
    }),
    ("K04", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy(b.v_a, inertia(&b.list, b.a)))]
    }),
    ("K05", |d| {
        let list = particles(d);
        let n = list.len() as f64;
        vec![
            ("x_G", list.iter().map(|p| p.1).sum::<f64>() / n),
            ("y_G", list.iter().map(|p| p.2).sum::<f64>() / n),
        ]
    }),
    ("K06", |d| {
        let b = Lamina::of_d(d);
        vec![("I_G", b.list.iter().map(|p| p.0 * (p.1 - b.g.0).hypot(p.2 - b.g.1)).sum())]
    }),
    ("K07", |d| {
        let b = lamina(d, -d.of("omega"));
        vec![("kinetic_energy", b.energy(b.v_g, b.i_g))]
    }),
    ("K08", |d| {
        let b = Lamina::of_d(d);
        let v = b.v_a.0.hypot(b.v_a.1) + b.w.abs() * (b.g.0 - b.a.0).hypot(b.g.1 - b.a.1);
        vec![("kinetic_energy", b.energy((v, 0.0), b.i_g))]
    }),
    ("K09", |d| {
        let b = Lamina::of_d(d);
        let v = (b.v_a.0 + b.w * (b.g.0 - b.a.0), b.v_a.1 + b.w * (b.g.1 - b.a.1));
        vec![("kinetic_energy", b.energy(v, b.i_g))]
    }),
    ("K10", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy((0.0, 0.0), inertia(&b.list, b.a)))]
    }),
    ("K11", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy(b.v_g, 0.0) + b.i_g * b.w.abs() / 2.0)]
    }),
    ("K12", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy(b.v_a, 0.0))]
    }),
    ("A03", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy(b.v_g, 0.0))]
    }),
    ("A04", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", b.energy((0.0, 0.0), b.i_g))]
    }),
    ("A17", |d| {
        let b = Lamina::of_d(d);
        vec![("kinetic_energy", 2.0 * b.energy(b.v_g, b.i_g))]
    }),
    ("K13", |d| {
        // omega x r_G in place of omega x rho.
        let b = Lamina::of_d(d);
        let v = (b.v_a.0 - b.w * b.g.1, b.v_a.1 + b.w * b.g.0);
        vec![("kinetic_energy", b.energy(v, b.i_g))]
    }),
];

// A block pulls a wheel.

/// Numbers of a block that pulls a wheel; `inert` is the pulley's moment of inertia over the square of its radius.
#[derive(Clone, Copy)]
struct Block {
    m: f64,
    ratio: f64,
    sin: f64,
    cos: f64,
    inert: f64,
    m_b: f64,
    g: f64,
    d: f64,
}

fn block(d: &D) -> Block {
    let (k, r) = (d.of("k"), d.of("R"));
    Block {
        m: d.of("m"),
        ratio: k * k / (r * r),
        sin: d.of("theta").sin(),
        cos: d.of("theta").cos(),
        inert: d.of("M") / 2.0,
        m_b: d.of("m_B"),
        g: d.of("g"),
        d: d.of("d"),
    }
}

impl Block {
    fn a(&self) -> f64 {
        self.g * (self.m_b - self.m * self.sin) / (self.m_b + self.inert + self.m * (1.0 + self.ratio))
    }
    fn upper(&self) -> f64 {
        self.m * (self.a() * (1.0 + self.ratio) + self.g * self.sin)
    }
    fn lower(&self) -> f64 {
        self.m_b * (self.g - self.a())
    }
    fn friction(&self) -> f64 {
        -self.m * self.ratio * self.a()
    }
    fn answers(&self) -> Answers {
        let a = self.a();
        vec![
            ("v", (2.0 * a * self.d).sqrt()),
            ("t", (2.0 * self.d / a).sqrt()),
            ("upper_tension", self.upper()),
            ("lower_tension", self.lower()),
            ("friction", self.friction()),
            ("mu_required", self.friction().abs() / (self.m * self.g * self.cos)),
        ]
    }
}

const MOTION: &[&str] = &["v", "t"];

const BLOCK: Methods = &[
    ("H01", |d| Block { inert: 0.0, ..block(d) }.answers()),
    ("H02", |d| vec![("upper_tension", block(d).lower()), ("lower_tension", block(d).upper())]),
    ("H03", |d| {
        // The cord pulls the wheel with the weight of the block.
        let b = block(d);
        let pull = b.m_b * b.g;
        let a = (pull - b.m * b.g * b.sin) / (b.m * (1.0 + b.ratio));
        vec![
            ("upper_tension", pull),
            ("lower_tension", pull),
            ("v", (2.0 * a * b.d).sqrt()),
            ("t", (2.0 * b.d / a).sqrt()),
        ]
    }),
    ("H04", |d| Block { inert: d.of("M"), ..block(d) }.answers()),
    ("H05", |d| {
        // (T2 - T1) b = I a, with a for alpha.
        let b = d.of("b");
        Block { inert: d.of("M") * b * b / 2.0 / b, ..block(d) }.answers()
    }),
    ("H06", |d| vec![("t", d.of("d") / (2.0 * block(d).a() * d.of("d")).sqrt())]),
    ("H07", |d| {
        let (g, s) = (d.of("g"), d.of("d"));
        vec![("v", (2.0 * g * s).sqrt()), ("t", (2.0 * s / g).sqrt())]
    }),
    ("H09", |d| vec![("lower_tension", block(d).m_b * (block(d).g + block(d).a()))]),
    ("A03", |d| {
        let all = Block { ratio: 0.0, ..block(d) }.answers();
        only(all, &["v", "t", "upper_tension", "lower_tension"])
    }),
    ("A05", |d| only(Block { ratio: 0.5, ..block(d) }.answers(), &["v", "t", "friction", "mu_required"])),
    ("A10", |d| {
        let all = Block { sin: 0.0, ..block(d) }.answers();
        only(all, &["v", "t", "upper_tension", "lower_tension", "friction"])
    }),
    ("A11", |d| Block { sin: block(d).cos, cos: block(d).sin, ..block(d) }.answers()),
    ("A12", |d| only(Block { sin: d.of("theta").to_degrees().sin(), ..block(d) }.answers(), MOTION)),
    ("A14", |d| only(Block { sin: 1.0, ..block(d) }.answers(), MOTION)),
    ("A15", |d| Block { ratio: block(d).ratio / 4.0, ..block(d) }.answers()),
    ("A17", |d| vec![("v", (block(d).a() * d.of("d")).sqrt())]),
    ("A18", |d| Block { ratio: d.of("k") / (d.of("R") * d.of("R")), ..block(d) }.answers()),
    ("A20", |d| Block { g: 10.0, ..block(d) }.answers()),
    ("A24", |d| {
        let b = block(d);
        vec![("friction", -d.of("mu_s") * b.m * b.g * b.cos), ("mu_required", d.of("mu_s"))]
    }),
    ("A26", |d| {
        let b = block(d);
        let f = b.m * b.g * b.sin - b.upper();
        vec![("friction", f), ("mu_required", f.abs() / (b.m * b.g * b.cos))]
    }),
    ("A27", |d| {
        let b = block(d);
        let f = b.m * b.a() + b.m * b.g * b.sin;
        vec![("friction", f), ("mu_required", f / (b.m * b.g * b.cos))]
    }),
    ("A28", |d| vec![("mu_required", block(d).friction().abs() / (block(d).m * block(d).g))]),
    ("A29", |d| {
        let b = block(d);
        vec![("mu_required", b.friction().abs() / (b.m * b.g * b.sin))]
    }),
    // m k^2 alpha = -F R: friction would drive the rotation backward, so that its inertia helps.
    ("A25", |d| only(Block { ratio: -block(d).ratio, ..block(d) }.answers(), MOTION)),
    ("A35", |d| vec![("mu_required", d.of("theta").tan())]),
    ("T04", |d| only(Block { ratio: 1.0, ..block(d) }.answers(), &["v", "t", "friction", "mu_required"])),
    // The pulley's whole mass moves with the cord.
    ("H17", |d| only(Block { ratio: 0.0, inert: d.of("M"), ..block(d) }.answers(), MOTION)),
];

// A yo-yo.

fn falls(a: f64, tension: f64, turn: f64, d: &D) -> Answers {
    let s = d.of("d");
    let v = (2.0 * a * s).sqrt();
    vec![("a", a), ("tension", tension), ("v", v), ("t", (2.0 * s / a).sqrt()), ("omega", v / turn)]
}

fn yoyo(k: f64, r: f64, g: f64, d: &D) -> Answers {
    let a = g * r * r / (r * r + k * k);
    falls(a, d.of("m") * (g - a), r, d)
}

fn right_yoyo(d: &D) -> Answers {
    yoyo(d.of("k"), d.of("r"), d.of("g"), d)
}

fn part(all: &Answers, question: &str) -> f64 {
    all.iter().find(|(q, _)| *q == question).unwrap().1
}

const YOYO: Methods = &[
    ("H03", |d| vec![("tension", d.of("m") * d.of("g"))]),
    ("H06", |d| vec![("t", d.of("d") / part(&right_yoyo(d), "v"))]),
    ("H07", |d| only(falls(d.of("g"), 0.0, d.of("r"), d), &["a", "v", "t", "omega"])),
    // Moments about the cord: m g r = m k^2 alpha.
    ("H08", |d| {
        let alpha = d.of("g") * d.of("r") / (d.of("k") * d.of("k"));
        only(falls(alpha * d.of("r"), 0.0, d.of("r"), d), &["a", "t"])
    }),
    ("H09", |d| vec![("tension", d.of("m") * (d.of("g") + part(&right_yoyo(d), "a")))]),
    ("H10", |d| vec![("omega", part(&right_yoyo(d), "v") / d.of("k"))]),
    ("A04", |d| {
        // All of the weight's work turns it.
        let omega = (2.0 * d.of("g") * d.of("d")).sqrt() / d.of("k");
        vec![("omega", omega), ("v", omega * d.of("r"))]
    }),
    ("A06", |d| {
        let r = d.of("r");
        yoyo((r * r / 2.0).sqrt(), r, d.of("g"), d)
    }),
    ("A15", |d| yoyo(d.of("k"), 2.0 * d.of("r"), d.of("g"), d)),
    ("A17", |d| {
        let v = (part(&right_yoyo(d), "a") * d.of("d")).sqrt();
        vec![("v", v), ("omega", v / d.of("r"))]
    }),
    ("A18", |d| yoyo(d.of("k").sqrt(), d.of("r"), d.of("g"), d)),
    ("A20", |d| yoyo(d.of("k"), d.of("r"), 10.0, d)),
    ("A33", |d| {
        let alpha = part(&right_yoyo(d), "a") / d.of("r");
        vec![("omega", (2.0 * alpha * d.of("d")).sqrt())]
    }),
];

// Two loads on a stepped drum.

/// Loads with their radii, moment of inertia of the drum.
fn drum(d: &D, (outer, inner): (f64, f64), i: f64, g: f64) -> Answers {
    let (m1, m2) = (d.of("m_1"), d.of("m_2"));
    let alpha = g * (m1 * outer - m2 * inner) / (m1 * outer * outer + m2 * inner * inner + i);
    vec![
        ("alpha", alpha),
        ("v_1", (2.0 * outer * alpha.abs() * d.of("d")).sqrt()),
        ("rope1_tension", m1 * (g - outer * alpha)),
        ("rope2_tension", m2 * (g + inner * alpha)),
    ]
}

fn drum_inertia(d: &D) -> f64 {
    d.of("M") * d.of("k") * d.of("k")
}

fn right_drum(d: &D) -> Answers {
    drum(d, (d.of("R"), d.of("r")), drum_inertia(d), d.of("g"))
}

const DRUM: Methods = &[
    ("H01", |d| drum(d, (d.of("R"), d.of("r")), 0.0, d.of("g"))),
    ("H03", |d| {
        let (w1, w2) = (d.of("m_1") * d.of("g"), d.of("m_2") * d.of("g"));
        let alpha = (w1 * d.of("R") - w2 * d.of("r")) / drum_inertia(d);
        let v = (2.0 * alpha.abs() * d.of("R") * d.of("d")).sqrt();
        vec![("alpha", alpha), ("v_1", v), ("rope1_tension", w1), ("rope2_tension", w2)]
    }),
    ("H09", |d| {
        let (alpha, g) = (part(&right_drum(d), "alpha"), d.of("g"));
        vec![
            ("rope1_tension", d.of("m_1") * (g + d.of("R") * alpha)),
            ("rope2_tension", d.of("m_2") * (g - d.of("r") * alpha)),
        ]
    }),
    ("H11", |d| drum(d, (d.of("r"), d.of("R")), drum_inertia(d), d.of("g"))),
    ("H12", |d| {
        // One acceleration a = R alpha for both loads, moments with both radii.
        let (m1, m2, outer, inner, g) = (d.of("m_1"), d.of("m_2"), d.of("R"), d.of("r"), d.of("g"));
        let a = (m1 * g * outer - m2 * g * inner) / (m1 * outer + m2 * inner + drum_inertia(d) / outer);
        let v = (2.0 * a.abs() * d.of("d")).sqrt();
        vec![
            ("alpha", a / outer),
            ("v_1", v),
            ("rope1_tension", m1 * (g - a)),
            ("rope2_tension", m2 * (g + a)),
        ]
    }),
    ("H13", |d| {
        let (m1, m2, outer, inner) = (d.of("m_1"), d.of("m_2"), d.of("R"), d.of("r"));
        let i = m1 * outer * outer + m2 * inner * inner + drum_inertia(d);
        let alpha = (m1 * outer + m2 * inner) * d.of("g") / i;
        vec![("alpha", alpha), ("v_1", (2.0 * alpha * outer * d.of("d")).sqrt())]
    }),
    ("H14", |d| drum(d, (d.of("R"), d.of("R")), drum_inertia(d), d.of("g"))),
    ("H15", |d| vec![("v_1", part(&right_drum(d), "v_1") / d.of("R") * d.of("r"))]),
    ("H16", |d| vec![("v_1", part(&right_drum(d), "v_1") / d.of("R"))]),
    ("A05", |d| {
        let r = d.of("R");
        drum(d, (r, d.of("r")), d.of("M") * r * r / 2.0, d.of("g"))
    }),
    ("A15", |d| drum(d, (2.0 * d.of("R"), 2.0 * d.of("r")), drum_inertia(d), d.of("g"))),
    ("A17", |d| {
        let alpha = part(&right_drum(d), "alpha").abs();
        vec![("v_1", (alpha * d.of("R") * d.of("d")).sqrt())]
    }),
    ("A18", |d| drum(d, (d.of("R"), d.of("r")), d.of("M") * d.of("k"), d.of("g"))),
    ("A20", |d| drum(d, (d.of("R"), d.of("r")), drum_inertia(d), 10.0)),
    ("A33", |d| vec![("v_1", (2.0 * part(&right_drum(d), "alpha").abs() * d.of("d")).sqrt())]),
    ("A36", |d| {
        let (outer, inner) = (d.of("R"), d.of("r"));
        drum(d, (outer, inner), d.of("M") * (outer * outer + inner * inner) / 2.0, d.of("g"))
    }),
    ("T04", |d| drum(d, (d.of("R"), d.of("r")), d.of("M") * d.of("R") * d.of("R"), d.of("g"))),
];

// A ball thrown with slip.

/// Numbers of a ball thrown with slip; `beta` is its moment of inertia over `m R^2`.
#[derive(Clone, Copy)]
struct Ball {
    m: f64,
    beta: f64,
    r: f64,
    sin: f64,
    cos: f64,
    v0: f64,
    w0: f64,
    mu: f64,
    g: f64,
}

fn ball(d: &D) -> Ball {
    Ball {
        m: d.of("m"),
        beta: 0.4,
        r: d.of("R"),
        sin: d.of("theta").sin(),
        cos: d.of("theta").cos(),
        v0: d.of("v0"),
        w0: d.of("w0"),
        mu: d.of("mu_k"),
        g: d.of("g"),
    }
}

impl Ball {
    fn slip(&self) -> f64 {
        self.v0 - self.r * self.w0
    }
    fn friction(&self) -> f64 {
        -self.slip().signum() * self.mu * self.m * self.g * self.cos
    }
    /// Rates of change of speed and spin.
    fn rates(&self) -> (f64, f64) {
        (self.friction() / self.m - self.g * self.sin, -self.friction() / (self.beta * self.m * self.r))
    }
    fn t(&self) -> f64 {
        let (a, alpha) = self.rates();
        self.slip() / (self.r * alpha - a)
    }
    fn way(&self) -> f64 {
        let t = self.t();
        self.v0 * t + self.rates().0 * t * t / 2.0
    }
    fn turn(&self) -> f64 {
        let t = self.t();
        self.w0 * t + self.rates().1 * t * t / 2.0
    }
    fn answers(&self) -> Answers {
        let t = self.t();
        let slid = (self.way() - self.r * self.turn()).abs();
        vec![
            ("slip_speed", self.slip().abs()),
            ("friction", self.friction()),
            ("t", t),
            ("displacement", self.way()),
            ("v", (self.v0 + self.rates().0 * t).abs()),
            ("slip_distance", slid),
            ("heat", self.friction().abs() * slid),
        ]
    }
}

const BALL: Methods = &[
    ("T01", |d| Ball { w0: 0.0, ..ball(d) }.answers()),
    ("T02", |d| Ball { w0: -ball(d).w0, ..ball(d) }.answers()),
    ("T03", |d| Ball { beta: 0.5, ..ball(d) }.answers()),
    ("T04", |d| Ball { beta: 1.0, ..ball(d) }.answers()),
    ("T05", |d| vec![("v", ball(d).v0), ("displacement", ball(d).v0 * ball(d).t())]),
    ("T06", |d| {
        // Thrown on a level, without spin.
        let b = Ball { w0: 0.0, sin: 0.0, cos: 1.0, ..ball(d) };
        only(b.answers(), &["v"])
    }),
    ("T09", |d| {
        let slid = ball(d).slip().abs() * ball(d).t();
        vec![("slip_distance", slid), ("heat", slid * ball(d).friction().abs())]
    }),
    ("T10", |d| {
        let v = part(&ball(d).answers(), "v");
        vec![("heat", (ball(d).m * ball(d).v0 * ball(d).v0 / 2.0 - ball(d).m * v * v / 2.0).abs())]
    }),
    ("T12", |d| {
        // What is left of the kinetic energy, the height not counted.
        let b = ball(d);
        let v = part(&b.answers(), "v");
        let i = b.beta * b.m * b.r * b.r;
        let before = b.m * b.v0 * b.v0 / 2.0 + i * b.w0 * b.w0 / 2.0;
        vec![("heat", before - (b.m + i / (b.r * b.r)) * v * v / 2.0)]
    }),
    ("A11", |d| Ball { sin: ball(d).cos, cos: ball(d).sin, ..ball(d) }.answers_on_slope(d)),
    ("A12", |d| {
        let x = d.of("theta").to_degrees();
        only(Ball { sin: x.sin(), cos: x.cos(), ..ball(d) }.answers(), &["friction", "t"])
    }),
    ("A15", |d| Ball { r: 2.0 * ball(d).r, ..ball(d) }.answers()),
    ("A20", |d| Ball { g: 10.0, ..ball(d) }.answers()),
    ("B03", |d| {
        let b = ball(d);
        let a = -b.friction() / b.m - b.g * b.sin;
        let t = b.t();
        vec![("displacement", b.v0 * t + a * t * t / 2.0), ("v", (b.v0 + a * t).abs())]
    }),
    // The spin stays as it is.
    ("B04", |d| vec![("t", -ball(d).slip() / ball(d).rates().0)]),
    // The friction is not there for the centre.
    ("B05", |d| {
        let b = ball(d);
        vec![("t", b.slip() / (b.r * b.rates().1 + b.g * b.sin))]
    }),
    ("B06", |d| {
        let all = Ball { mu: d.of("mu_s"), ..ball(d) }.answers();
        only(all, &["friction", "t", "displacement", "slip_distance"])
    }),
    ("B11", |d| only(Ball { beta: 1.4, ..ball(d) }.answers(), &["t"])),
    ("B13", |d| Ball { sin: 0.0, ..ball(d) }.answers()),
    ("B17", |d| vec![("heat", (ball(d).friction() * ball(d).way()).abs())]),
    ("B18", |d| vec![("heat", (ball(d).friction() * ball(d).r * ball(d).turn()).abs())]),
    ("B19", |d| vec![("slip_distance", (ball(d).r * ball(d).turn()).abs())]),
    ("B20", |d| vec![("slip_distance", ball(d).way().abs())]),
    ("T13", |d| {
        let b = ball(d);
        let i = b.beta * b.m * b.r * b.r;
        let raised = b.sin * part(&b.answers(), "displacement");
        let left = b.m * b.v0 * b.v0 / 2.0 + i * b.w0 * b.w0 / 2.0 - b.m * b.g * raised;
        vec![("v", (2.0 * left / (b.m + i / (b.r * b.r))).sqrt())]
    }),
    ("T14", |d| vec![("t", ball(d).v0 / ball(d).rates().0.abs())]),
    ("A25", |d| {
        // The spin changes the other way.
        let (a, alpha) = ball(d).rates();
        vec![("t", (ball(d).slip() / (-ball(d).r * alpha - a)).abs())]
    }),
];

impl Ball {
    /// On a level there is no slope to take wrongly.
    fn answers_on_slope(self, d: &D) -> Answers {
        if d.2 == "up an incline" { self.answers() } else { ball(d).answers() }
    }
}

// A spinning wheel is set down.

#[derive(Clone, Copy)]
struct SetDown {
    m: f64,
    k: f64,
    r: f64,
    sin: f64,
    cos: f64,
    w0: f64,
    mu: f64,
    g: f64,
    t1: f64,
}

fn wheel(d: &D) -> SetDown {
    SetDown {
        m: d.of("m"),
        k: d.of("k"),
        r: d.of("R"),
        sin: d.of("theta").sin(),
        cos: d.of("theta").cos(),
        w0: d.of("w0"),
        mu: d.of("mu_k"),
        g: d.of("g"),
        t1: d.of("t1"),
    }
}

impl SetDown {
    fn kinetic(&self) -> f64 {
        self.mu * self.m * self.g * self.cos
    }
    /// When rolling begins; infinite if never.
    fn rolls_at(&self) -> f64 {
        let a = self.kinetic() / self.m - self.g * self.sin;
        let alpha = self.kinetic() * self.r / (self.m * self.k * self.k);
        let t = self.r * self.w0 / (a + self.r * alpha);
        if t > 0.0 { t } else { f64::INFINITY }
    }
    /// Speed, spin, way, angle after slipping for a time.
    fn slipping(&self, t: f64) -> (f64, f64, f64, f64) {
        let a = self.kinetic() / self.m - self.g * self.sin;
        let alpha = self.kinetic() * self.r / (self.m * self.k * self.k);
        (a * t, self.w0 - alpha * t, a * t * t / 2.0, self.w0 * t - alpha * t * t / 2.0)
    }
    fn turn(&self) -> f64 {
        let first = self.rolls_at().min(self.t1);
        let (.., x, phi) = self.slipping(first);
        (phi + (self.way() - x) / self.r).abs() * f64::from(first < self.t1)
            + phi.abs() * f64::from(first >= self.t1)
    }
    fn way(&self) -> f64 {
        let first = self.rolls_at().min(self.t1);
        let (v, _, x, _) = self.slipping(first);
        let rest = self.t1 - first;
        x + v * rest + self.rolling_a() * rest * rest / 2.0
    }
    fn rolling_a(&self) -> f64 {
        -self.g * self.sin / (1.0 + self.k * self.k / (self.r * self.r))
    }
    fn answers(&self) -> Answers {
        let first = self.rolls_at().min(self.t1);
        let (v, w, x, phi) = self.slipping(first);
        let rest = self.t1 - first;
        let slid = (x - self.r * phi).abs();
        let (friction, a, v, w) = if rest > 0.0 {
            let a = self.rolling_a();
            let v = v + a * rest;
            (self.m * a + self.m * self.g * self.sin, a, v, v / self.r)
        } else {
            (self.kinetic(), self.kinetic() / self.m - self.g * self.sin, v, w)
        };
        vec![
            ("friction", friction),
            ("a", a),
            ("v", v.abs()),
            ("omega", w.abs()),
            ("displacement", self.way()),
            ("slip_distance", slid),
            ("heat", self.kinetic() * slid),
        ]
    }
}

const SET_DOWN: Methods = &[
    ("T04", |d| SetDown { k: wheel(d).r, ..wheel(d) }.answers()),
    ("T07", |d| {
        let w = wheel(d);
        let (v, spin, x, _) = w.slipping(w.t1);
        let a = w.mu * w.g * w.cos - w.g * w.sin;
        vec![("friction", w.kinetic()), ("a", a), ("v", v), ("omega", spin.abs()), ("displacement", x)]
    }),
    ("T08", |d| {
        let w = wheel(d);
        let a = w.rolling_a();
        vec![("friction", w.m * (a + w.g * w.sin)), ("a", a)]
    }),
    ("T09", |d| {
        let slid = wheel(d).r * wheel(d).w0 * wheel(d).t1;
        vec![("slip_distance", slid), ("heat", slid * wheel(d).kinetic())]
    }),
    ("T10", |d| {
        let v = part(&wheel(d).answers(), "v");
        vec![("heat", wheel(d).m * v * v / 2.0)]
    }),
    ("T11", |d| {
        let w = wheel(d);
        let spin = part(&w.answers(), "omega");
        vec![("heat", w.m * w.k * w.k * (w.w0 * w.w0 - spin * spin) / 2.0)]
    }),
    ("T12", |d| {
        let w = wheel(d);
        let (v, spin) = (part(&w.answers(), "v"), part(&w.answers(), "omega"));
        vec![("heat", w.m * w.k * w.k * (w.w0 * w.w0 - spin * spin) / 2.0 - w.m * v * v / 2.0)]
    }),
    ("A05", |d| SetDown { k: (wheel(d).r * wheel(d).r / 2.0).sqrt(), ..wheel(d) }.answers()),
    ("A11", |d| SetDown { sin: wheel(d).cos, cos: wheel(d).sin, ..wheel(d) }.answers()),
    ("A12", |d| {
        let x = d.of("theta").to_degrees();
        let w = SetDown { sin: x.sin(), cos: x.cos(), ..wheel(d) };
        let (v, _, x, _) = w.slipping(w.t1);
        let a = w.kinetic() / w.m - w.g * w.sin;
        vec![("friction", w.kinetic()), ("a", a), ("v", v.abs()), ("displacement", x)]
    }),
    ("A15", |d| SetDown { r: 2.0 * wheel(d).r, ..wheel(d) }.answers()),
    ("A18", |d| SetDown { k: wheel(d).k.sqrt(), ..wheel(d) }.answers()),
    ("A20", |d| SetDown { g: 10.0, ..wheel(d) }.answers()),
    ("B01", |d| vec![("omega", part(&wheel(d).answers(), "v") / wheel(d).r)]),
    ("B03", |d| {
        let w = wheel(d);
        let a = -w.kinetic() / w.m - w.g * w.sin;
        vec![("a", a), ("v", (a * w.t1).abs()), ("displacement", a * w.t1 * w.t1 / 2.0)]
    }),
    ("B04", |d| {
        let w = wheel(d);
        let slid = w.r * w.w0 * w.t1 - w.way();
        vec![("omega", w.w0), ("slip_distance", slid), ("heat", slid * w.kinetic())]
    }),
    ("B05", |d| {
        let w = wheel(d);
        let a = -w.g * w.sin;
        vec![("a", a), ("v", (a * w.t1).abs()), ("displacement", a * w.t1 * w.t1 / 2.0)]
    }),
    ("B06", |d| SetDown { mu: d.of("mu_s"), ..wheel(d) }.answers()),
    ("B11", |d| SetDown { k: wheel(d).k.hypot(wheel(d).r), ..wheel(d) }.answers()),
    ("B13", |d| SetDown { sin: 0.0, ..wheel(d) }.answers()),
    ("B16", |d| vec![("v", part(&wheel(d).answers(), "omega") * wheel(d).r)]),
    ("B17", |d| vec![("heat", (wheel(d).kinetic() * wheel(d).way()).abs())]),
    ("B18", |d| vec![("heat", wheel(d).kinetic() * wheel(d).r * wheel(d).turn())]),
    ("B19", |d| vec![("slip_distance", wheel(d).r * wheel(d).turn())]),
    ("B20", |d| vec![("slip_distance", wheel(d).way().abs())]),
    ("A25", |d| {
        let w = wheel(d);
        vec![("omega", w.w0 + w.kinetic() * w.r / (w.m * w.k * w.k) * w.t1)]
    }),
];

// Pinned bodies.

/// A rod at an angle from upright: what drives it, and the force of its pin.
#[derive(Clone, Copy)]
struct Rod {
    m: f64,
    l: f64,
    /// Moment of inertia about the pin.
    i: f64,
    g: f64,
    /// Angles from upright.
    from: f64,
    to: f64,
    /// Work of everything but the weight, and its moment at the end.
    work: f64,
    moment: f64,
    /// Force of everything else on the rod, along it (away from the pin) and across.
    other: (f64, f64),
}

impl Rod {
    fn new(d: &D, from: f64, to: f64) -> Self {
        let (m, l, g) = (d.of("m"), d.of("L"), d.of("g"));
        Self { m, l, i: m * l * l / 3.0, g, from, to, work: 0.0, moment: 0.0, other: (0.0, 0.0) }
    }
    fn omega(&self) -> f64 {
        let work = self.m * self.g * self.l / 2.0 * (self.from.cos() - self.to.cos()) + self.work;
        (2.0 * work / self.i).sqrt()
    }
    fn alpha(&self) -> f64 {
        (self.m * self.g * self.l / 2.0 * self.to.sin() + self.moment) / self.i
    }
    /// Force of the pin toward the pin and across, with these accelerations of the mass centre and this weight.
    fn pin(&self, central: f64, across: f64, weight: f64) -> (f64, f64) {
        let (s, c) = self.to.sin_cos();
        (self.m * central - weight * c + self.other.0, self.m * across - weight * s - self.other.1)
    }
    fn forces(&self, (radial, tangential): (f64, f64)) -> Answers {
        vec![("pin_radial", radial), ("pin_tangential", tangential), ("pin_force", radial.hypot(tangential))]
    }
    fn central(&self) -> f64 {
        self.omega() * self.omega() * self.l / 2.0
    }
    fn across(&self) -> f64 {
        self.alpha() * self.l / 2.0
    }
    fn weight(&self) -> f64 {
        self.m * self.g
    }
    fn motion(&self) -> Answers {
        vec![("omega", self.omega()), ("alpha", self.alpha())]
    }
    fn answers(&self) -> Answers {
        let mut all = self.motion();
        all.extend(self.forces(self.pin(self.central(), self.across(), self.weight())));
        all
    }
    /// Uniformly accelerated with the final angular acceleration.
    fn uniform(&self) -> Answers {
        vec![("omega", (2.0 * self.alpha() * (self.to - self.from)).sqrt())]
    }
}

fn falling(d: &D) -> Rod {
    Rod::new(d, d.of("phi0"), d.of("phi1"))
}

fn inert(rod: Rod, share: f64) -> Answers {
    Rod { i: rod.m * rod.l * rod.l * share, ..rod }.motion()
}

const FALLING: Methods = &[
    ("P01", |d| inert(falling(d), 1.0 / 12.0)),
    ("P02", |d| inert(falling(d), 1.0 / 4.0)),
    ("P03", |d| {
        // The weight at the end: work and moment once more.
        let r = falling(d);
        let (work, moment) =
            (r.weight() * r.l / 2.0 * (r.from.cos() - r.to.cos()), r.across() * 2.0 * r.i / r.l);
        Rod { work, moment, ..r }.motion()
    }),
    ("P04", |d| only(Rod { from: 0.0, ..falling(d) }.motion(), &["omega"])),
    ("P05", |d| {
        let r = falling(d);
        only(Rod { from: 0.0, to: r.to - r.from, ..r }.motion(), &["omega"])
    }),
    ("P06", |d| {
        let r = falling(d);
        let work = r.weight() * r.l / 2.0 * (r.to.sin() - r.from.sin());
        let moment = r.weight() * r.l / 2.0 * r.to.cos();
        vec![("omega", (2.0 * work.abs() / r.i).sqrt()), ("alpha", moment / r.i)]
    }),
    ("P13", |d| {
        let r = falling(d);
        only(r.forces(r.pin(0.0, r.across(), r.weight())), &["pin_radial", "pin_force"])
    }),
    ("P14", |d| {
        let r = falling(d);
        r.forces(r.pin(r.central(), r.across(), 0.0))
    }),
    ("P15", |d| {
        let r = falling(d);
        let all = r.forces(r.pin(2.0 * r.central(), 2.0 * r.across(), r.weight()));
        only(all, &["pin_radial", "pin_tangential"])
    }),
    ("P16", |d| {
        let r = falling(d);
        only(r.forces(r.pin(r.central(), 0.0, r.weight())), &["pin_tangential"])
    }),
    ("P17", |d| vec![("pin_force", falling(d).weight())]),
    ("P23", |d| inert(falling(d), 1.0 / 3.0 + 1.0 / 4.0)),
    ("P24", |d| falling(d).uniform()),
    ("P25", |d| vec![("alpha", d.of("g") * d.of("phi1").sin() / d.of("L"))]),
    ("A12", |d| {
        Rod { from: d.of("phi0").to_degrees(), to: d.of("phi1").to_degrees(), ..falling(d) }.motion()
    }),
    ("A17", |d| {
        let r = falling(d);
        only(Rod { i: 2.0 * r.i, ..r }.motion(), &["omega"])
    }),
    ("A20", |d| Rod { g: 10.0, ..falling(d) }.answers()),
    ("P27", |d| {
        let r = falling(d);
        r.forces(r.pin(r.central(), r.across(), -r.weight()))
    }),
];

/// From hanging: the angle from upright is half a turn more.
fn lifted(d: &D) -> Rod {
    let (m, phi) = (d.of("M"), d.of("phi1"));
    Rod { work: m * phi, moment: m, ..Rod::new(d, PI, PI + phi) }
}

const LIFTED: Methods = &[
    ("P01", |d| inert(lifted(d), 1.0 / 12.0)),
    ("P02", |d| inert(lifted(d), 1.0 / 4.0)),
    ("P03", |d| Rod { g: 2.0 * d.of("g"), ..lifted(d) }.motion()),
    ("P06", |d| {
        // sin for 1 - cos, cos for sin.
        let (r, phi) = (lifted(d), d.of("phi1"));
        let arm = r.weight() * r.l / 2.0;
        vec![
            ("omega", (2.0 * (d.of("M") * phi - arm * phi.sin()) / r.i).sqrt()),
            ("alpha", (d.of("M") - arm * phi.cos()) / r.i),
        ]
    }),
    ("P07", |d| only(Rod { work: d.of("M"), ..lifted(d) }.motion(), &["omega"])),
    ("P08", |d| only(Rod { work: d.of("M") * d.of("phi1").to_degrees(), ..lifted(d) }.motion(), &["omega"])),
    ("P13", |d| {
        let r = lifted(d);
        only(r.forces(r.pin(0.0, r.across(), r.weight())), &["pin_radial"])
    }),
    ("P14", |d| {
        let r = lifted(d);
        r.forces(r.pin(r.central(), r.across(), 0.0))
    }),
    ("P15", |d| {
        let r = lifted(d);
        r.forces(r.pin(2.0 * r.central(), 2.0 * r.across(), r.weight()))
    }),
    ("P16", |d| {
        let r = lifted(d);
        only(r.forces(r.pin(r.central(), 0.0, r.weight())), &["pin_tangential"])
    }),
    ("P23", |d| inert(lifted(d), 1.0 / 3.0 + 1.0 / 4.0)),
    ("P24", |d| lifted(d).uniform()),
    ("A09", |d| Rod { g: -d.of("g"), ..lifted(d) }.motion()),
    ("A10", |d| Rod { g: 0.0, ..lifted(d) }.motion()),
    ("A12", |d| Rod { to: PI + d.of("phi1").to_degrees(), ..lifted(d) }.motion()),
    ("A17", |d| {
        let r = lifted(d);
        only(Rod { i: 2.0 * r.i, work: r.work, ..r }.motion(), &["omega"])
    }),
    ("A20", |d| Rod { g: 10.0, ..lifted(d) }.answers()),
    ("P27", |d| {
        let r = lifted(d);
        only(r.forces(r.pin(r.central(), r.across(), -r.weight())), &["pin_radial", "pin_tangential"])
    }),
];

/// Length of the spring, and its force along the rod (away from the pin) and across it, for this natural length.
fn spring(d: &D, phi: f64, natural: f64) -> (f64, f64, (f64, f64)) {
    let (a, l) = (d.of("a"), d.of("L"));
    // Tip and anchor.
    let (tx, ty) = (l * phi.sin(), l * phi.cos());
    let (dx, dy) = (-tx, a - ty);
    let length = dx.hypot(dy);
    let force = d.of("ks") * (length - natural);
    let (ux, uy) = (dx / length * force, dy / length * force);
    let (s, c) = phi.sin_cos();
    (length, force, (ux * s + uy * c, ux * c - uy * s))
}

fn sprung_with(d: &D, natural: f64, g: f64) -> Rod {
    let (from, to) = (d.of("phi0"), d.of("phi1"));
    let (x0, x1) = (spring(d, from, natural).0 - natural, spring(d, to, natural).0 - natural);
    let (.., (along, across)) = spring(d, to, natural);
    Rod {
        g,
        work: d.of("ks") * (x0 * x0 - x1 * x1) / 2.0,
        moment: across * d.of("L"),
        other: (along, across),
        ..Rod::new(d, from, to)
    }
}

fn sprung(d: &D) -> Rod {
    sprung_with(d, d.of("l0"), d.of("g"))
}

/// Stretches at the start and at the end.
fn stretches(d: &D) -> (f64, f64) {
    let l0 = d.of("l0");
    (spring(d, d.of("phi0"), l0).0 - l0, spring(d, d.of("phi1"), l0).0 - l0)
}

fn with_work(d: &D, work: f64) -> Answers {
    only(Rod { work, ..sprung(d) }.motion(), &["omega"])
}

const SPRUNG: Methods = &[
    ("P01", |d| inert(sprung(d), 1.0 / 12.0)),
    ("P02", |d| inert(sprung(d), 1.0 / 4.0)),
    ("P03", |d| Rod { g: 2.0 * d.of("g"), ..sprung(d) }.motion()),
    ("P04", |d| {
        // The weight's work from upright, the spring's from the start.
        only(Rod { from: 0.0, ..sprung(d) }.motion(), &["omega"])
    }),
    ("P09", |d| {
        let r = sprung_with(d, 0.0, d.of("g"));
        let mut all = r.motion();
        all.push(("spring_force", spring(d, d.of("phi1"), 0.0).1));
        all
    }),
    ("P10", |d| with_work(d, -d.of("ks") * stretches(d).1 * stretches(d).1 / 2.0)),
    ("P11", |d| Rod { work: 0.0, moment: 0.0, ..sprung(d) }.motion()),
    ("P12", |d| {
        let force = spring(d, d.of("phi1"), d.of("l0")).1;
        only(Rod { moment: -force * d.of("L"), ..sprung(d) }.motion(), &["alpha"])
    }),
    ("P13", |d| {
        let r = sprung(d);
        only(r.forces(r.pin(0.0, r.across(), r.weight())), &["pin_force"])
    }),
    ("P14", |d| {
        let r = sprung(d);
        only(r.forces(r.pin(r.central(), r.across(), 0.0)), &["pin_force"])
    }),
    ("P17", |d| vec![("pin_force", sprung(d).weight())]),
    ("P24", |d| sprung(d).uniform()),
    ("P26", |d| {
        let r = sprung(d);
        let pin = Rod { other: (0.0, 0.0), ..r }.pin(r.central(), r.across(), r.weight());
        only(r.forces(pin), &["pin_force"])
    }),
    ("A12", |d| Rod { from: d.of("phi0").to_degrees(), to: d.of("phi1").to_degrees(), ..sprung(d) }.motion()),
    ("A17", |d| {
        let r = sprung(d);
        only(Rod { i: 2.0 * r.i, ..r }.motion(), &["omega"])
    }),
    ("A20", |d| {
        let r = sprung_with(d, d.of("l0"), 10.0);
        let mut all = r.answers();
        all.push(("spring_force", spring(d, d.of("phi1"), d.of("l0")).1));
        all
    }),
    ("C14", |d| with_work(d, 2.0 * sprung(d).work)),
    ("C15", |d| {
        let (x0, x1) = stretches(d);
        with_work(d, -d.of("ks") * (x1 - x0) * (x1 - x0) / 2.0)
    }),
    ("P27", |d| {
        let r = sprung(d);
        only(r.forces(r.pin(r.central(), r.across(), -r.weight())), &["pin_force"])
    }),
];

/// A compound pendulum: moment of inertia about the pin, and what follows from it.
#[derive(Clone, Copy)]
struct Pendulum {
    m: f64,
    h: f64,
    i: f64,
    g: f64,
    from: f64,
    to: f64,
}

fn pendulum(d: &D) -> Pendulum {
    let (m, h, k) = (d.of("m"), d.of("h"), d.of("k"));
    Pendulum { m, h, i: m * (h * h + k * k), g: d.of("g"), from: d.of("phi0"), to: d.of("phi1") }
}

impl Pendulum {
    fn small(&self) -> f64 {
        (self.m * self.g * self.h / self.i).sqrt()
    }
    fn omega_at(&self, phi: f64) -> f64 {
        (2.0 * self.m * self.g * self.h * (phi.cos() - self.from.cos()) / self.i).sqrt()
    }
    fn alpha(&self) -> f64 {
        -self.m * self.g * self.h * self.to.sin() / self.i
    }
    fn period(&self) -> f64 {
        // The arithmetic-geometric mean of 1 and cos(phi0/2).
        let (mut a, mut b) = (1.0f64, (self.from / 2.0).cos());
        for _ in 0..40 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        2.0 * PI / self.small() / a
    }
    fn pin(&self, central: f64, across: f64, weight: f64) -> f64 {
        (self.m * central + weight * self.to.cos()).hypot(self.m * across + weight * self.to.sin())
    }
    fn central(&self) -> f64 {
        self.omega_at(self.to) * self.omega_at(self.to) * self.h
    }
    fn answers(&self) -> Answers {
        vec![
            ("I_O", self.i),
            ("period_small", 2.0 * PI / self.small()),
            ("period", self.period()),
            ("omega_max", self.omega_at(0.0)),
            ("omega", self.omega_at(self.to)),
            ("alpha", self.alpha()),
            ("pin_force", self.pin(self.central(), self.alpha() * self.h, self.m * self.g)),
        ]
    }
}

const PENDULUM: Methods = &[
    ("P01", |d| {
        let all = Pendulum { i: d.of("m") * d.of("k") * d.of("k"), ..pendulum(d) }.answers();
        only(all, &["I_O", "period_small", "period", "omega_max", "omega", "alpha"])
    }),
    ("P02", |d| Pendulum { i: d.of("m") * d.of("h") * d.of("h"), ..pendulum(d) }.answers()),
    ("P05", |d| {
        let p = pendulum(d);
        vec![("omega", Pendulum { from: p.from - p.to, ..p }.omega_at(0.0))]
    }),
    ("P06", |d| {
        let p = pendulum(d);
        let drop = p.h * (p.from.sin() - p.to.sin()).abs();
        vec![("omega", (2.0 * p.m * p.g * drop / p.i).sqrt()), ("alpha", -p.m * p.g * p.h * p.to.cos() / p.i)]
    }),
    ("P13", |d| {
        let p = pendulum(d);
        vec![("pin_force", p.pin(0.0, p.alpha() * p.h, p.m * p.g))]
    }),
    ("P14", |d| {
        let p = pendulum(d);
        vec![("pin_force", p.pin(p.central(), p.alpha() * p.h, 0.0))]
    }),
    ("P17", |d| vec![("pin_force", d.of("m") * d.of("g"))]),
    ("P18", |d| {
        // phi = phi0 cos(w t).
        let p = pendulum(d);
        let w = p.small();
        let turn = (p.to / p.from).acos();
        vec![
            ("period", 2.0 * PI / w),
            ("omega_max", p.from * w),
            ("omega", p.from * w * turn.sin()),
            ("alpha", -p.from * w * w * turn.cos()),
        ]
    }),
    ("P19", |d| vec![("period_small", 2.0 * PI * pendulum(d).small())]),
    ("P20", |d| {
        let p = pendulum(d);
        vec![("period_small", 1.0 / p.small()), ("period", p.period() / (2.0 * PI))]
    }),
    ("P21", |d| {
        let p = pendulum(d);
        vec![("period_small", PI / p.small()), ("period", p.period() / 2.0)]
    }),
    ("P22", |d| {
        let r = d.of("k") + d.of("h");
        vec![("I_O", d.of("m") * r * r)]
    }),
    ("P24", |d| {
        let p = pendulum(d);
        vec![("omega", (2.0 * p.alpha() * (p.to - p.from)).sqrt())]
    }),
    ("A12", |d| {
        let p = pendulum(d);
        let p = Pendulum { from: p.from.to_degrees(), to: p.to.to_degrees(), ..p };
        only(p.answers(), &["omega", "omega_max", "alpha"])
    }),
    ("A17", |d| {
        let p = pendulum(d);
        let p = Pendulum { i: 2.0 * p.i, ..p };
        only(p.answers(), &["omega", "omega_max"])
    }),
    ("A20", |d| Pendulum { g: 10.0, ..pendulum(d) }.answers()),
    ("P27", |d| {
        let p = pendulum(d);
        vec![("pin_force", p.pin(p.central(), p.h * p.alpha(), -p.m * p.g))]
    }),
];

const FAMILIES: &[(&str, &str, Methods)] = &[
    ("wheels-on-inclines", "kinetic-energy", KINETIC),
    ("hoists-and-pulleys", "block-pulls-wheel", BLOCK),
    ("hoists-and-pulleys", "yo-yo", YOYO),
    ("hoists-and-pulleys", "two-loads-on-a-stepped-drum", DRUM),
    ("slip-and-roll", "thrown-ball", BALL),
    ("slip-and-roll", "wheel-set-down", SET_DOWN),
    ("pinned-bodies", "falling-rod", FALLING),
    ("pinned-bodies", "compound-pendulum", PENDULUM),
    ("pinned-bodies", "lifted-rod", LIFTED),
    ("pinned-bodies", "rod-and-spring", SPRUNG),
];

/// Variants of each problem.
const VARIANTS: u32 = 24;

#[test]
fn each_wrong_method_of_the_families_is_the_mistake_that_it_is_said_to_be() {
    let mut faults: Vec<String> = Vec::new();
    let mut compared: BTreeMap<(&str, String, String), u32> = BTreeMap::new();
    for (file, id, table) in FAMILIES {
        let text = match *file {
            "hoists-and-pulleys" => include_str!("../../banks/hoists-and-pulleys.yaml"),
            "slip-and-roll" => include_str!("../../banks/slip-and-roll.yaml"),
            "pinned-bodies" => include_str!("../../banks/pinned-bodies.yaml"),
            _ => include_str!("../../banks/wheels-on-inclines.yaml"),
        };
        let bank = load::scenes_only(text, file).unwrap();
        let problem = bank.problems.iter().find(|p| p.id == *id).unwrap();
        for mistake in &problem.mistakes {
            if table.iter().filter(|(m, _)| *m == mistake.id).count() != 1 {
                faults.push(format!("{id}: {} does not stand in the table once", mistake.id));
            }
        }
        // Draws near which a method lies are as good as others here, and cheaper.
        let mut bare = problem.clone();
        bare.mistakes.clear();
        let maker = Maker::new(&bare, 1, "families");
        for student in 0..VARIANTS {
            let variant = maker.variant(&format!("{student}")).unwrap();
            let case = problem.cases[variant.case].name.as_str();
            let data = D(problem, &variant.data, case);
            let labels: Vec<Label> = problem.questions.iter().map(|q| q.label).collect();
            let all = misconception::values(problem, variant.case, &variant.data, &variant.solved, &labels);
            for (method, formula) in *table {
                let Some(index) = problem.mistakes.iter().position(|m| m.id == *method) else {
                    faults.push(format!("{id} has no wrong method {method}"));
                    continue;
                };
                let cases = &problem.mistakes[index].cases;
                if !cases.is_empty() && !cases.contains(&variant.case) {
                    continue;
                }
                let expected = formula(&data);
                for q in problem.questions.iter().filter(|q| !q.label.quantity.is_word()) {
                    let right = variant.solved.get(q.label).unwrap().value();
                    let found = all
                        .iter()
                        .find(|w| w.mistake == index && w.label == q.label)
                        .map_or(f64::NAN, |w| w.value);
                    let own = expected.iter().find(|(name, _)| *name == q.id).map_or(f64::NAN, |(_, v)| *v);
                    let near = |a: f64, b: f64| (a - b).abs() <= 1e-7 * a.abs().max(b.abs()).max(right.abs());
                    // What comes out right is not told; the root of what should be 0 may be none.
                    let none = !own.is_finite() || near(own, right) || near(own, 0.0);
                    let same = near(found, own) || (!found.is_finite() && none);
                    if !same {
                        let at = format!("{id} {case} {method} {}", q.id);
                        faults.push(format!("{at}: {found:e} against {own:e}, right {right:e}"));
                    }
                    if found.is_finite() {
                        *compared.entry((id, (*method).to_owned(), q.id.clone())).or_default() += 1;
                    }
                }
            }
        }
    }
    let few: Vec<_> = compared.iter().filter(|(_, n)| **n < 3).collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults[..faults.len().min(60)].join("\n"));
    assert!(few.is_empty(), "compared fewer than three times: {few:?}");
    println!("{} values of {} formulas", compared.values().sum::<u32>(), compared.len());
}
