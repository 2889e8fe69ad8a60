//! A judge of composed scenes, written for the test from nothing: Lagrange's equations with multipliers in plain x and y (x to
//! the right, y up, turns counter-clockwise), three coordinates a body. It reads the words of the bank for itself, derives the
//! constraints from geometry, finds by trial which contacts hold, and moves along in time. It shares no line with the
//! program. Everything is in doubles.
use crate::composed::{Amount, Body, End, Event, Far, Scene, Spread, Tie, Way};

type V2 = (f64, f64);
/// A quantity of an axle.
type Axle = (&'static str, Owner, f64);
fn dot(a: V2, b: V2) -> f64 {
    a.0 * b.0 + a.1 * b.1
}
fn times(k: f64, a: V2) -> V2 {
    (k * a.0, k * a.1)
}
/// A quarter turn counter-clockwise.
fn quarter(a: V2) -> V2 {
    (-a.1, a.0)
}

/// Below this a number of a reduced matrix, whose rows were of order 1, is 0.
const NOTHING: f64 = 1e-9;

/// Where a body moves, in plain x and y.
struct Frame {
    /// Forward along the line; to the right for an axle.
    forward: V2,
    /// Up along the line (to the right on a level).
    up: V2,
    /// From the surface to the body; where there is none, so that forward is to its right.
    out: V2,
    /// Counter-clockwise turn that goes with rolling forward on a surface below: 1 or -1.
    sense: f64,
    on_surface: bool,
    line: bool,
    turns: bool,
}

fn frame(s: &Scene, b: &Body) -> Frame {
    let turns = !matches!(b.spread, Spread::Block);
    let (up, on_surface, line) = match b.way {
        Way::Axle => ((1.0, 0.0), false, false),
        Way::Vertically => ((0.0, 1.0), false, true),
        Way::Along(i) => {
            let surface = &s.surfaces[i];
            let up = match &surface.slope {
                Some(a) if a.si == 90.0 => (0.0, 1.0),
                Some(a) => {
                    let angle = a.si * std::f64::consts::PI / 180.0;
                    (libm::cos(angle), libm::sin(angle))
                }
                None if surface.vertical => (0.0, 1.0),
                None => (1.0, 0.0),
            };
            (up, true, true)
        }
    };
    let back = matches!(b.positive, Some("down" | "back" | "left"));
    let forward = if back { times(-1.0, up) } else { up };
    let out = if on_surface { quarter(up) } else { quarter(forward) };
    // The point of contact, at -out c, is at rest: v forward + turn * quarter(-out c) = 0.
    let sense = dot(quarter(out), forward).signum();
    Frame { forward, up, out, sense, on_surface, line, turns }
}

fn radius(b: &Body, name: &str) -> f64 {
    b.radii.iter().find(|(n, _)| *n == name).map(|(_, a)| a.si).expect("a radius that was drawn")
}

/// Where a cord leaves: from the mass centre to the point, and the direction away from the body.
fn leaves(s: &Scene, frames: &[Frame], e: &End) -> (V2, V2) {
    let f = &frames[e.body];
    if let Some(tilt) = e.tilt {
        // Turned out of the surface, with the place at which it leaves the rim.
        let (at, along) = leaves(s, frames, &End { tilt: None, ..e.clone() });
        let angle = f64::from(tilt) * std::f64::consts::PI / 180.0;
        let (c, s) = (libm::cos(angle), libm::sin(angle) * dot(quarter(along), f.out));
        let turned = |a: V2| (c * a.0 - s * a.1, c * a.1 + s * a.0);
        return (turned(at), turned(along));
    }
    let Some(on) = e.wound else {
        let along = match e.leaves {
            "forward" => f.forward,
            "back" => times(-1.0, f.forward),
            "up" => f.up,
            "down" => times(-1.0, f.up),
            other => panic!("{other}"),
        };
        return ((0.0, 0.0), along);
    };
    let p = radius(&s.bodies[e.body], on);
    let (above, below) = (times(p, f.out), times(-p, f.out));
    match e.leaves {
        "top forward" => (above, f.forward),
        "top back" => (above, times(-1.0, f.forward)),
        "bottom forward" => (below, f.forward),
        "bottom back" => (below, times(-1.0, f.forward)),
        // A turn forward is clockwise where no surface says otherwise, so the front, which it moves down, is on the right.
        "front down" => ((p, 0.0), (0.0, -1.0)),
        "front up" => ((p, 0.0), (0.0, 1.0)),
        "back down" => ((-p, 0.0), (0.0, -1.0)),
        // Moving down it then turns forward.
        "back up" | "up" => ((-p, 0.0), (0.0, 1.0)),
        other => panic!("{other}"),
    }
}

/// The force with which a body presses on its surface: its weight less what pulls lift.
fn pressed(s: &Scene, frames: &[Frame], mass: f64, body: usize) -> f64 {
    let out = frames[body].out;
    s.ties.iter().fold(mass * s.gravity.si * out.1, |left, tie| match tie {
        Tie::Cord { from, far: Far::Pulled(p) } if from.tilt.is_some() && from.body == body => {
            left - p.si * dot(leaves(s, frames, from).1, out)
        }
        _ => left,
    })
}

fn masses(s: &Scene, b: &Body) -> (f64, f64) {
    let kg = |a: &Amount| if a.unit == "N" { a.si / s.gravity.si } else { a.si };
    let m = b.mass.as_ref().map_or(1.0, kg);
    match &b.spread {
        Spread::Block => (m, 0.0),
        Spread::Gyration(k) => (m, m * k.si * k.si),
        Spread::Moment(i) => (m, i.si),
        Spread::Shape(word, r) => {
            let beta = match *word {
                "disc" => 1.0 / 2.0,
                "hoop" => 1.0,
                "sphere" => 2.0 / 5.0,
                "shell" => 2.0 / 3.0,
                other => panic!("{other}"),
            };
            (m, beta * m * r.si * r.si)
        }
        Spread::Discs(parts) => {
            let m = parts.iter().map(|(m, _)| m.si).sum();
            (m, parts.iter().map(|(m, r)| 0.5 * m.si * r.si * r.si).sum())
        }
    }
}

/// Rows reduced with full pivoting: `a x = b` in the last column. Pivots as (row, column); what is left of the rows without
/// a pivot, and the size that their right-hand sides had.
struct Reduced {
    rows: Vec<Vec<f64>>,
    pivots: Vec<(usize, usize)>,
}

fn reduce(mut rows: Vec<Vec<f64>>, cols: usize) -> Reduced {
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    loop {
        let mut best = (0, 0, NOTHING);
        for (i, row) in rows.iter().enumerate().filter(|(i, _)| !pivots.iter().any(|p| p.0 == *i)) {
            for (j, v) in row.iter().take(cols).enumerate() {
                if v.abs() > best.2 {
                    best = (i, j, v.abs());
                }
            }
        }
        let (i, j, size) = best;
        if size <= NOTHING {
            break;
        }
        pivots.push((i, j));
        let lead = rows[i][j];
        rows[i].iter_mut().for_each(|v| *v /= lead);
        let base = rows[i].clone();
        for (k, row) in rows.iter_mut().enumerate() {
            if k != i && row[j] != 0.0 {
                let f = row[j];
                row.iter_mut().zip(&base).for_each(|(v, b)| *v -= f * b);
                row[j] = 0.0;
            }
        }
    }
    Reduced { rows, pivots }
}

impl Reduced {
    /// Solutions of `a x = 0`.
    fn kernel(&self, cols: usize) -> Vec<Vec<f64>> {
        let open = (0..cols).filter(|j| !self.pivots.iter().any(|p| p.1 == *j));
        open.map(|j| {
            let mut x = vec![0.0; cols];
            x[j] = 1.0;
            for (row, col) in &self.pivots {
                x[*col] = -self.rows[*row][j];
            }
            for v in &mut x {
                if v.abs() < NOTHING {
                    *v = 0.0;
                }
            }
            x
        })
        .collect()
    }
    /// The unknowns that have one value only.
    fn determined(&self, cols: usize) -> Vec<Option<f64>> {
        let mut x = vec![None; cols];
        let open: Vec<usize> = (0..cols).filter(|j| !self.pivots.iter().any(|p| p.1 == *j)).collect();
        for (row, col) in &self.pivots {
            if open.iter().all(|j| self.rows[*row][*j].abs() < NOTHING) {
                x[*col] = Some(self.rows[*row][cols]);
            }
        }
        x
    }
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What a contact that can stick or slide does.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Grip {
    Sticks,
    /// Kinetic friction along `forward` of its body, this sign.
    Slides(f64),
}

/// A contact with friction: row of its velocity along forward, N, coefficients.
struct Contact {
    tie: usize,
    body: usize,
    row: Vec<f64>,
    normal: f64,
    mu_s: Option<f64>,
    mu_k: f64,
    /// Said to roll (holds without limit), said to slip, or slides.
    said: Said,
}

impl Contact {
    fn loose(&self) -> Grip {
        if self.said == Said::Rolls { Grip::Sticks } else { Grip::Slides(0.0) }
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Said {
    Rolls,
    Slips,
    Slides,
}

/// Accelerations, and the reaction of each tie where it is determined.
struct Instant {
    a: Vec<f64>,
    reactions: Vec<Option<f64>>,
}

/// Everything of a scene that stays while it moves.
pub struct System<'s> {
    s: &'s Scene,
    frames: Vec<Frame>,
    mass: Vec<f64>,
    inertia: Vec<f64>,
    /// Ties without friction, and what holds bodies on their lines and axles; index of the tie, if it is one.
    rows: Vec<(Option<usize>, Vec<f64>)>,
    contacts: Vec<Contact>,
    /// Forces without those of springs.
    force: Vec<f64>,
    springs: Vec<Spring>,
    /// Sum of the magnitudes of all forces, N: what a zero is held against.
    pub forces: f64,
}

/// A spring on a cord.
struct Spring {
    tie: usize,
    /// Row of the velocity of its end along the cord.
    row: Vec<f64>,
    ks: f64,
    /// Stretch at the start.
    x0: f64,
    rigid: bool,
}

/// What the judge has to say.
pub enum Verdict {
    /// The motion is not determined: something without inertia is free to move.
    Undetermined,
    /// More freedoms than one and a spring on the way: not for this judge.
    Beyond(&'static str),
    /// On the way friction can no longer hold a contact that came to rest, or was at rest.
    Torn,
    /// A start speed that the ties do not allow.
    Contradiction,
    /// Which contacts hold is not settled by Coulomb's law with two coefficients.
    Ambiguous,
    /// A contact that is said to slip could hold.
    CouldRoll,
    /// A pull lifts a body off its surface: contacts that only push are no longer there.
    LiftsOff,
    /// Values by name (`v of 0`).
    Told(Told),
}

/// All that this judge would publish.
#[derive(Default)]
pub struct Told {
    /// Quantity, owner, value, size of its terms.
    pub values: Vec<(&'static str, Owner, f64, f64)>,
    /// Reactions that statics leaves open.
    pub open: Vec<(&'static str, Owner)>,
    /// Does anything move?
    pub rests: bool,
    /// Sense of the ending coordinate, forward.
    pub sense: f64,
    /// The word for it.
    pub direction: &'static str,
    /// Does it go where the scene says?
    pub as_said: bool,
    /// Is the end reached? And is that a matter of rounding?
    pub reached: bool,
    pub near_reach: bool,
    /// Checks by name and owner (index): hold or not; absent where it is a matter of rounding.
    pub checks: Vec<(&'static str, usize, bool)>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Owner {
    Scene,
    Body(usize),
    Tie(usize),
}

impl Told {
    /// Velocities as they are, accelerations and forces; nothing of what comes later.
    fn at_once(&mut self, velocities: Vec<(&'static str, Owner, f64, f64)>) {
        let at_once = ["a", "alpha", "normal", "friction", "friction_if_rolled", "mu_required", "tension"];
        self.values.retain(|v| at_once.contains(&v.0) || v.0.starts_with("pin_"));
        self.values.extend(velocities);
    }
}

/// A stretch of a motion with constant accelerations.
struct Stretch {
    /// Velocities at its start.
    from: Vec<f64>,
    now: Instant,
    grips: Vec<Grip>,
    lasts: f64,
}

impl Stretch {
    fn after(&self) -> Vec<f64> {
        self.from.iter().zip(&self.now.a).map(|(v, a)| v + a * self.lasts).collect()
    }
    /// How far something has gone whose velocity is this row of velocities.
    fn moved(&self, row: &[f64]) -> f64 {
        self.lasts * (inner(row, &self.from) + 0.5 * self.lasts * inner(row, &self.now.a))
    }
    /// The same there and back.
    fn covered(&self, row: &[f64]) -> f64 {
        let (u, a) = (inner(row, &self.from), inner(row, &self.now.a));
        let turns = if a == 0.0 { 0.0 } else { -u / a };
        if turns > 0.0 && turns < self.lasts {
            0.5 * a.abs() * (turns * turns + (self.lasts - turns) * (self.lasts - turns))
        } else {
            self.moved(row).abs()
        }
    }
}

/// How far the ending coordinate is.
#[derive(Default)]
struct Ending {
    sense: f64,
    gone: f64,
    turned: bool,
    near: bool,
}

impl<'s> System<'s> {
    pub fn new(s: &'s Scene) -> Self {
        let frames: Vec<Frame> = s.bodies.iter().map(|b| frame(s, b)).collect();
        let n = 3 * s.bodies.len();
        let point = |body: usize, at: V2, along: V2| {
            // Velocity of the point at `at` from the mass centre, along a direction.
            let mut row = vec![0.0; n];
            row[3 * body] = along.0;
            row[3 * body + 1] = along.1;
            row[3 * body + 2] = dot(quarter(at), along);
            row
        };
        let (mut mass, mut inertia) = (vec![0.0; n], vec![0.0; s.bodies.len()]);
        let mut force = vec![0.0; n];
        let mut rows: Vec<(Option<usize>, Vec<f64>)> = Vec::new();
        let mut forces = 0.0;
        let add = |force: &mut Vec<f64>, sum: &mut f64, row: &[f64], size: f64| {
            force.iter_mut().zip(row).for_each(|(f, r)| *f += size * r);
            *sum += size.abs();
        };
        for (i, (b, f)) in s.bodies.iter().zip(&frames).enumerate() {
            let (m, moment) = masses(s, b);
            mass[3 * i] = m;
            mass[3 * i + 1] = m;
            mass[3 * i + 2] = moment;
            inertia[i] = moment;
            add(&mut force, &mut forces, &point(i, (0.0, 0.0), (0.0, -1.0)), m * s.gravity.si);
            if f.line {
                rows.push((None, point(i, (0.0, 0.0), f.out)));
            } else {
                rows.push((None, point(i, (0.0, 0.0), (1.0, 0.0))));
                rows.push((None, point(i, (0.0, 0.0), (0.0, 1.0))));
            }
            if !f.turns {
                let mut row = vec![0.0; n];
                row[3 * i + 2] = 1.0;
                rows.push((None, row));
                mass[3 * i + 2] = 1.0;
            }
        }
        for (body, moment, forward) in &s.couples {
            let sense = if *forward { frames[*body].sense } else { -frames[*body].sense };
            force[3 * body + 2] += sense * moment.si;
            forces += moment.si;
        }
        let mut contacts = Vec::new();
        let mut springs = Vec::new();
        for (t, tie) in s.ties.iter().enumerate() {
            let contact = |body: usize, c: f64| {
                let f = &frames[body];
                let normal = pressed(s, &frames, mass[3 * body], body);
                (point(body, times(-c, f.out), f.forward), if normal.abs() < 1e-12 { 0.0 } else { normal })
            };
            match tie {
                Tie::Rolls { body, on, mu_s } => {
                    let (row, normal) = contact(*body, radius(&s.bodies[*body], on));
                    let mu_s = mu_s.as_ref().map(|m| m.si);
                    contacts.push(Contact {
                        tie: t,
                        body: *body,
                        row,
                        normal,
                        mu_s,
                        mu_k: 0.0,
                        said: Said::Rolls,
                    });
                }
                Tie::Slips { body, on, mu_s, mu_k } => {
                    let (row, normal) = contact(*body, radius(&s.bodies[*body], on));
                    let (mu_s, mu_k) = (Some(mu_s.si), mu_k.si);
                    contacts.push(Contact {
                        tie: t,
                        body: *body,
                        row,
                        normal,
                        mu_s,
                        mu_k,
                        said: Said::Slips,
                    });
                }
                Tie::Slides { body, mu_s, mu_k } => {
                    let (row, normal) = contact(*body, 0.0);
                    let mu_s = Some(mu_s.as_ref().unwrap_or(mu_k).si);
                    contacts.push(Contact {
                        tie: t,
                        body: *body,
                        row,
                        normal,
                        mu_s,
                        mu_k: mu_k.si,
                        said: Said::Slides,
                    });
                }
                Tie::Link { from, to } => {
                    let mut row = vec![0.0; n];
                    for end in [from, to] {
                        let (at, along) = leaves(s, &frames, end);
                        row.iter_mut().zip(point(end.body, at, along)).for_each(|(r, o)| *r += o);
                    }
                    rows.push((Some(t), row));
                }
                Tie::Cord { from, far } => {
                    let (at, along) = leaves(s, &frames, from);
                    let mut row = point(from.body, at, along);
                    match far {
                        Far::Pulled(p) => add(&mut force, &mut forces, &row, p.si),
                        Far::Fast => rows.push((Some(t), row)),
                        Far::To(to) => {
                            // What one end takes in the other gives.
                            let (at, along) = leaves(s, &frames, to);
                            row.iter_mut().zip(point(to.body, at, along)).for_each(|(r, o)| *r += o);
                            rows.push((Some(t), row));
                        }
                        Far::Spring { stiffness, stretch, rigid } => {
                            let (ks, x0) = (stiffness.si, stretch.si);
                            forces += ks * x0;
                            springs.push(Spring { tie: t, row, ks, x0, rigid: *rigid });
                        }
                    }
                }
            }
        }
        Self { s, frames, mass, inertia, rows, contacts, force, springs, forces }
    }

    fn cols(&self) -> usize {
        self.mass.len()
    }

    /// How many motions the ties leave, contacts with friction loose, and fast.
    pub fn rank(&self) -> [usize; 2] {
        let loose: Vec<Grip> = self.contacts.iter().map(Contact::loose).collect();
        let fast = vec![Grip::Sticks; self.contacts.len()];
        [self.modes(&loose).len(), self.modes(&fast).len()]
    }

    /// Rows that hold with these grips.
    fn holding(&self, grips: &[Grip]) -> Vec<(Option<usize>, &[f64])> {
        let mut rows: Vec<(Option<usize>, &[f64])> =
            self.rows.iter().map(|(t, r)| (*t, r.as_slice())).collect();
        for (c, g) in self.contacts.iter().zip(grips) {
            if *g == Grip::Sticks {
                rows.push((Some(c.tie), &c.row));
            }
        }
        rows
    }

    fn modes(&self, grips: &[Grip]) -> Vec<Vec<f64>> {
        let rows = self.holding(grips).iter().map(|(_, r)| [r, &[0.0][..]].concat()).collect();
        reduce(rows, self.cols()).kernel(self.cols())
    }

    /// Given forces with these grips, the springs at these tensions.
    fn given(&self, grips: &[Grip], tensions: &[f64]) -> Vec<f64> {
        let mut f = self.force.clone();
        let mut add = |row: &[f64], size: f64| f.iter_mut().zip(row).for_each(|(f, r)| *f += size * r);
        for (c, g) in self.contacts.iter().zip(grips) {
            if let Grip::Slides(sign) = g {
                add(&c.row, sign * c.mu_k * c.normal);
            }
        }
        for (spring, tension) in self.springs.iter().zip(tensions) {
            add(&spring.row, *tension);
        }
        f
    }

    /// Sum of the magnitudes of what the forces do in a mode.
    fn terms(&self, grips: &[Grip], z: &[f64], tensions: &[f64]) -> f64 {
        let own: f64 = z.iter().zip(&self.force).map(|(z, f)| (z * f).abs()).sum();
        let of = |row: &[f64], size: f64| row.iter().zip(z).map(|(r, z)| (r * z * size).abs()).sum::<f64>();
        let contacts = self.contacts.iter().zip(grips).filter(|(_, g)| **g != Grip::Sticks);
        own + contacts.map(|(c, _)| of(&c.row, c.mu_k * c.normal)).sum::<f64>()
            + self.springs.iter().zip(tensions).map(|(s, t)| of(&s.row, *t)).sum::<f64>()
    }

    /// Is something without inertia free to move?
    pub fn massless(&self) -> bool {
        let loose: Vec<Grip> = self.contacts.iter().map(Contact::loose).collect();
        self.instant(&loose, &[]).is_none()
    }

    /// Accelerations and reactions; `None` where something without inertia is free.
    fn instant(&self, grips: &[Grip], tensions: &[f64]) -> Option<Instant> {
        let n = self.cols();
        let force = self.given(grips, tensions);
        let modes = self.modes(grips);
        let k = modes.len();
        let weigh = |z: &[f64]| z.iter().zip(&self.mass).map(|(z, m)| z * m).collect::<Vec<f64>>();
        // z M z' u = z Q
        let rows: Vec<Vec<f64>> = modes
            .iter()
            .map(|z| {
                let heavy = weigh(z);
                let own: f64 = inner(&heavy, z).max(1e-30);
                // A balance of forces.
                let drive = if inner(z, &force).abs() <= 1e-12 * self.terms(grips, z, tensions) {
                    0.0
                } else {
                    inner(z, &force)
                };
                modes.iter().map(|o| inner(&heavy, o) / own).chain([drive / own]).collect()
            })
            .collect();
        for z in &modes {
            if inner(&weigh(z), z) < 1e-12 {
                return None;
            }
        }
        let reduced = reduce(rows, k);
        if reduced.pivots.len() < k {
            return None;
        }
        let rates = reduced.determined(k);
        let mut a = vec![0.0; n];
        let mut size = vec![0.0f64; n];
        for (z, u) in modes.iter().zip(&rates) {
            for i in 0..n {
                let term = z[i] * u.expect("determined");
                a[i] += term;
                size[i] += term.abs();
            }
        }
        // Lengths are of order 0.1 to 1 m, so turns and travels are of like size.
        let most = a.iter().fold(0.0f64, |m, a| m.max(a.abs()));
        for (a, s) in a.iter_mut().zip(&size) {
            if a.abs() <= 1e-12 * s.max(most) {
                *a = 0.0;
            }
        }
        // G^T l = M a - Q
        let holding = self.holding(grips);
        let cols = holding.len();
        let rest: Vec<f64> = (0..n).map(|i| self.mass[i] * a[i] - force[i]).collect();
        let rows = (0..n).map(|i| holding.iter().map(|(_, r)| r[i]).chain([rest[i]]).collect()).collect();
        let found = reduce(rows, cols).determined(cols);
        let mut reactions = vec![None; self.s.ties.len()];
        for ((tie, _), value) in holding.iter().zip(found) {
            if let Some(t) = tie {
                reactions[*t] = value;
            }
        }
        for (c, g) in self.contacts.iter().zip(grips) {
            if let Grip::Slides(sign) = g {
                reactions[c.tie] = Some(sign * c.mu_k * c.normal);
            }
        }
        Some(Instant { a, reactions })
    }

    /// Can static friction hold the contacts that stick (those said to roll hold without limit), given that the others
    /// slide? By virtual work: in no motion that the other ties allow may the forces do more than friction can take.
    fn can_hold(&self, grips: &[Grip], tensions: &[f64]) -> Option<bool> {
        let now = self.instant(grips, tensions)?;
        let sticking: Vec<&Contact> = self
            .contacts
            .iter()
            .zip(grips)
            .filter(|(c, g)| **g == Grip::Sticks && c.said != Said::Rolls)
            .map(|(c, _)| c)
            .collect();
        // Those that stick take kinetic coefficient 0 here: their friction is what is looked for.
        let loose: Vec<Grip> = self
            .contacts
            .iter()
            .zip(grips)
            .map(|(c, g)| if *g == Grip::Sticks && c.said != Said::Rolls { Grip::Slides(0.0) } else { *g })
            .collect();
        let force = self.given(&loose, tensions);
        let surplus: Vec<f64> = (0..self.cols()).map(|i| force[i] - self.mass[i] * now.a[i]).collect();
        let modes = self.modes(&loose);
        let k = modes.len();
        let mut tried: Vec<Vec<f64>> = Vec::new();
        // Extreme motions: all but one of the freedoms that the contacts could take are taken.
        let subsets = 1usize << sticking.len();
        let mut left = 0;
        for set in (0..subsets).rev() {
            let rows: Vec<Vec<f64>> = sticking
                .iter()
                .enumerate()
                .filter(|(i, _)| set >> i & 1 == 1)
                .map(|(_, c)| modes.iter().map(|z| inner(&c.row, z)).chain([0.0]).collect())
                .collect();
            let kernel = reduce(rows, k).kernel(k);
            if set == subsets - 1 {
                left = kernel.len();
            }
            if kernel.len() <= left + 1 {
                tried.extend(kernel);
            }
        }
        for v in tried {
            let mut motion = vec![0.0; self.cols()];
            for (z, share) in modes.iter().zip(&v) {
                motion.iter_mut().zip(z).for_each(|(m, z)| *m += share * z);
            }
            // What rounding leaves of a part that does not move.
            let most = motion.iter().fold(0.0f64, |most, m| most.max(m.abs()));
            motion.iter_mut().filter(|m| m.abs() < NOTHING * most).for_each(|m| *m = 0.0);
            let work = inner(&motion, &surplus).abs();
            let size = |i: usize| force[i].abs() + (self.mass[i] * now.a[i]).abs();
            let terms: f64 = motion.iter().enumerate().map(|(i, m)| m.abs() * size(i)).sum();
            let most: f64 = sticking
                .iter()
                .map(|c| (inner(&c.row, &motion) * c.mu_s.unwrap_or(0.0) * c.normal).abs())
                .sum();
            if work > most + 1e-11 * (terms + most) {
                return Some(false);
            }
        }
        Some(true)
    }

    fn moving(&self, body: usize, turn: bool) -> Vec<f64> {
        let f = &self.frames[body];
        let mut row = vec![0.0; self.cols()];
        if turn {
            row[3 * body + 2] = f.sense;
        } else {
            row[3 * body] = f.forward.0;
            row[3 * body + 1] = f.forward.1;
        }
        row
    }

    /// What contacts do at the start from rest.
    fn grips_from_rest(&self, tensions: &[f64]) -> Result<Vec<Grip>, Verdict> {
        let n = self.contacts.len();
        let mut fitting: Vec<Vec<Grip>> = Vec::new();
        for code in 0..3usize.pow(u32::try_from(n).expect("few")) {
            let mut rest = code;
            let grips: Vec<Grip> = (0..n)
                .map(|_| {
                    let g = [Grip::Sticks, Grip::Slides(1.0), Grip::Slides(-1.0)][rest % 3];
                    rest /= 3;
                    g
                })
                .collect();
            let said = self.contacts.iter().zip(&grips);
            if said.clone().any(|(c, g)| c.said == Said::Rolls && *g != Grip::Sticks) {
                continue;
            }
            let Some(now) = self.instant(&grips, tensions) else { continue };
            let against = said.clone().all(|(c, g)| match g {
                Grip::Sticks => true,
                Grip::Slides(sign) => {
                    let slip = inner(&c.row, &now.a);
                    let terms: f64 = c.row.iter().zip(&now.a).map(|(r, a)| (r * a).abs()).sum();
                    slip * sign < 0.0 && slip.abs() > 1e-11 * terms
                }
            });
            if against && self.can_hold(&grips, tensions) == Some(true) {
                fitting.push(grips);
            }
        }
        // Where everything can stay, it stays.
        if let Some(all) = fitting.iter().find(|g| g.iter().all(|g| *g == Grip::Sticks)) {
            return Ok(all.clone());
        }
        match fitting.len() {
            1 => Ok(fitting.remove(0)),
            0 => Err(Verdict::Undetermined),
            _ => Err(Verdict::Ambiguous),
        }
    }

    /// Friction of the only contact at the start, up the incline, if the wheel had this radius of gyration.
    pub fn friction_with(s: &Scene, k: f64) -> Option<f64> {
        let mut other = s.clone();
        if let Spread::Gyration(own) = &mut other.bodies[0].spread {
            own.si = k;
        }
        let system = System::new(&other);
        let now = system.instant(&vec![Grip::Sticks; system.contacts.len()], &[])?;
        let contact = system.contacts.first()?;
        let f = &system.frames[contact.body];
        now.reactions[contact.tie].map(|r| r * dot(f.forward, f.up))
    }

    /// The word for a sense of the ending coordinate.
    fn direction(&self, sense: f64) -> &'static str {
        let s = self.s;
        let f = &self.frames[s.of];
        let level = matches!(s.bodies[s.of].way, Way::Along(i) if s.surfaces[i].slope.is_none() && !s.surfaces[i].vertical);
        match (sense, f.line && !level) {
            (0.0, _) => "stays",
            (_, true) => {
                if sense * dot(f.forward, f.up) > 0.0 {
                    "up"
                } else {
                    "down"
                }
            }
            // On a level up is to the right, whichever way is forward.
            (_, false) => {
                if sense * dot(f.forward, f.up) > 0.0 {
                    "forward"
                } else {
                    "back"
                }
            }
        }
    }

    /// The forces of the fixed axles, and those that nothing determines, springs at these tensions.
    fn axles(&self, there: &Instant, pulls: &[f64]) -> (Vec<Axle>, Vec<(&'static str, Owner)>) {
        let s = self.s;
        // An axle holds the weight of its body against the pulls of its cords: one to a body on a slope runs along that, any other as
        // it leaves. Nobody knows the direction of one that goes round a corner, nor what is to the
        // right where a surface is drawn turned round, for a cord that leaves both its bodies to the same side. A wall faces left: what
        // leads upward from it leads on to the right.
        let leaving = |e: &End| leaves(s, &self.frames, e).1;
        let onward = |e: &End| dot(leaving(e), self.frames[e.body].forward) > 0.0;
        let surface = |e: &End| match s.bodies[e.body].way {
            Way::Along(k) => Some(k),
            _ => None,
        };
        let upward = |e: &End| {
            let (right, up) = self.frames[e.body].forward;
            onward(e) == (right + up > 0.0)
        };
        let rightward = |e: &End| match surface(e) {
            Some(k) if s.surfaces[k].vertical => leaving(e).1,
            Some(k) if s.surfaces[k].slope.is_some() => {
                if upward(e) {
                    1.0
                } else {
                    -1.0
                }
            }
            Some(_) => leaving(e).0,
            None => 0.0,
        };
        let turned = |tie: &Tie| match tie {
            Tie::Cord { from, far: Far::To(to) } => rightward(from) * rightward(to) > 0.0,
            _ => false,
        };
        // So it is where a wheel about a fixed axle leads on from one surface to another.
        let mut led: Vec<(usize, usize, f64)> = Vec::new();
        for tie in &s.ties {
            let Tie::Cord { from, far: Far::To(to) } = tie else { continue };
            for (axle, end) in [(from, to), (to, from)] {
                if let (Way::Axle, Some(k)) = (&s.bodies[axle.body].way, surface(end)) {
                    led.push((axle.body, k, rightward(end)));
                }
            }
        }
        let led_on = led.iter().any(|a| led.iter().any(|b| a.0 == b.0 && a.1 != b.1 && a.2 * b.2 > 0.0));
        if led_on || s.ties.iter().any(turned) {
            return (Vec::new(), Vec::new());
        }
        let (mut pins, mut open) = (Vec::new(), Vec::new());
        for (b, body) in s.bodies.iter().enumerate() {
            if !matches!(body.way, Way::Axle) || matches!(body.spread, Spread::Moment(_)) {
                continue;
            }
            let own = Owner::Body(b);
            let (mut x, mut y, mut told, mut shared) = (0.0, self.mass[3 * b] * s.gravity.si, true, false);
            for (t, tie) in s.ties.iter().enumerate() {
                let Tie::Cord { from, far } = tie else { continue };
                let to = if let Far::To(end) = far { Some(end) } else { None };
                let (end, other) = match to {
                    Some(end) if end.body == b => (end, Some(from)),
                    _ if from.body == b => (from, to),
                    _ => continue,
                };
                let pull = match far {
                    Far::Pulled(p) => Some(p.si),
                    Far::Spring { .. } => {
                        Some(pulls[self.springs.iter().position(|s| s.tie == t).expect("a spring")])
                    }
                    Far::Fast | Far::To(_) => there.reactions[t],
                };
                shared |= pull.is_none();
                let mut along = leaving(end);
                let level = along.1.abs() < 1e-12;
                if let Some(other) = other.filter(|e| matches!(s.bodies[e.body].way, Way::Axle)) {
                    told &= dot(along, leaving(other)) < -0.5;
                }
                if let Some((other, k)) = other.and_then(|other| Some((other, surface(other)?))) {
                    if s.surfaces[k].slope.is_some() {
                        // Forward is to the right: of what counts positive down a picture may show either side.
                        let (right, up) = self.frames[other.body].forward;
                        let faces = if level {
                            onward(end) != onward(other)
                        } else {
                            (along.1 > 0.0) != upward(other)
                        };
                        told &= faces && right + up > 0.0;
                        along = times(-1.0, leaving(other));
                    } else if !s.surfaces[k].vertical {
                        told &= level;
                    }
                }
                (x, y) = (x - pull.unwrap_or(0.0) * along.0, y - pull.unwrap_or(0.0) * along.1);
            }
            if told && shared {
                open.extend(["pin_x", "pin_y", "pin_force", "pin_angle"].map(|name| (name, own)));
            } else if told {
                pins.extend([("pin_x", own, x), ("pin_y", own, y), ("pin_force", own, x.hypot(y))]);
            }
        }
        (pins, open)
    }

    /// The powers of pulls and couples at these velocities.
    fn powers(&self, s: &Scene, v: &[f64]) -> Vec<(&'static str, Owner, f64, f64)> {
        let mut powers = Vec::new();
        // What ties hold still beside what moves is still to rounding.
        let speeds: f64 = v.iter().map(|v| v.abs()).sum();
        let most = |row: &[f64]| speeds * row.iter().map(|x| x.abs()).sum::<f64>();
        for body in 0..self.frames.len() {
            let row = self.moving(body, true);
            let turn = inner(&row, v);
            let on = s.couples.iter().filter(|c| c.0 == body);
            let each: Vec<f64> =
                on.map(|(_, m, forward)| if *forward { m.si * turn } else { -m.si * turn }).collect();
            if !each.is_empty() {
                let size: f64 = s.couples.iter().filter(|c| c.0 == body).map(|c| c.1.si.abs()).sum();
                powers.push(("power_couple", Owner::Body(body), each.iter().sum(), size * most(&row)));
            }
        }
        for (t, tie) in s.ties.iter().enumerate() {
            if let Tie::Cord { from, far: Far::Pulled(p) } = tie {
                let (point, along) = leaves(s, &self.frames, from);
                let mut row = vec![0.0; self.cols()];
                (row[3 * from.body], row[3 * from.body + 1]) = along;
                row[3 * from.body + 2] = dot(quarter(point), along);
                powers.push(("power_pull", Owner::Tie(t), p.si * inner(&row, v), p.si * most(&row)));
            }
        }
        powers
    }

    /// The account of these velocities.
    fn velocities(&self, v0: &[f64]) -> Vec<(&'static str, Owner, f64, f64)> {
        let mut values = Vec::new();
        let energy = 0.5 * v0.iter().zip(&self.mass).map(|(v, m)| m * v * v).sum::<f64>();
        values.push(("kinetic_energy", Owner::Scene, energy, energy));
        let mut spinning = 0.0;
        for (b, f) in self.frames.iter().enumerate() {
            let mut say = |name, spin| {
                let v = inner(&self.moving(b, spin), v0).abs();
                values.push((name, Owner::Body(b), v, v));
                v
            };
            if f.line {
                say("v", false);
            }
            if f.turns {
                let w = say("omega", true);
                let spin = self.inertia[b] * w;
                values.push(("angular_momentum", Owner::Body(b), spin, spin));
                spinning += 0.5 * self.inertia[b] * w * w;
            }
        }
        if energy > 0.0 {
            values.push(("rotational_fraction", Owner::Scene, spinning / energy, 1.0));
        }
        values
    }

    /// The velocities that the start gives, if it gives all and they fit.
    fn set_out(&self, loose: &[Grip]) -> Result<Vec<f64>, Verdict> {
        let modes = self.modes(loose);
        // Of what slips and hangs on nothing the velocity that is not told is 0.
        let held = |body: usize| {
            self.s.ties.iter().any(|tie| match tie {
                Tie::Cord { from, far } => from.body == body || matches!(far, Far::To(to) if to.body == body),
                Tie::Link { from, to } => [from.body, to.body].contains(&body),
                _ => false,
            })
        };
        let slips =
            |body: usize| self.s.ties.iter().any(|t| matches!(t, Tie::Slips { body: b, .. } if *b == body));
        let told = self.s.start.iter().map(|(body, spin, v)| (*body, *spin, v.si));
        let alone = |(body, spin, _): &(usize, bool, f64)| {
            slips(*body) && !held(*body) && !self.s.start.iter().any(|(b, s, _)| b == body && s != spin)
        };
        let silent = told.clone().filter(alone).map(|(body, spin, _)| (body, !spin, 0.0));
        let rows = told.clone().chain(silent).map(|(body, spin, v)| {
            let moving = self.moving(body, spin);
            modes.iter().map(|z| inner(&moving, z)).chain([v]).collect()
        });
        let k = modes.len();
        let reduced = reduce(rows.collect(), k);
        let left = reduced.rows.iter().enumerate().filter(|(i, _)| !reduced.pivots.iter().any(|p| p.0 == *i));
        if left.into_iter().any(|(_, row)| row[k].abs() > NOTHING) {
            return Err(Verdict::Contradiction);
        }
        let mut v = vec![0.0; self.cols()];
        for (z, rate) in modes.iter().zip(reduced.determined(k)) {
            let rate = rate.ok_or(Verdict::Undetermined)?;
            v.iter_mut().zip(z).for_each(|(v, z)| *v += rate * z);
        }
        Ok(v)
    }

    /// Does the last speed of the start say something that those before it do not?
    pub fn starts_add(&self) -> bool {
        let loose: Vec<Grip> = self.contacts.iter().map(Contact::loose).collect();
        let modes = self.modes(&loose);
        let rank = |count: usize| {
            let rows = self.s.start[..count].iter().map(|(body, spin, _)| {
                let moving = self.moving(*body, *spin);
                modes.iter().map(|z| inner(&moving, z)).chain([0.0]).collect()
            });
            reduce(rows.collect(), modes.len()).pivots.len()
        };
        rank(self.s.start.len()) > rank(self.s.start.len() - 1)
    }

    /// What contacts do that slip in these senses, or do not (0): of those at rest each may stay or set off either way. Do all stay?
    fn settle(&self, slips: &[f64], tensions: &[f64]) -> Result<(Vec<Grip>, bool), Verdict> {
        let open: Vec<usize> =
            (0..slips.len()).filter(|i| slips[*i] == 0.0 && self.contacts[*i].said != Said::Rolls).collect();
        let mut fitting: Vec<Vec<Grip>> = Vec::new();
        for code in 0..3usize.pow(u32::try_from(open.len()).expect("few")) {
            let mut grips: Vec<Grip> =
                slips.iter().map(|s| if *s == 0.0 { Grip::Sticks } else { Grip::Slides(-s) }).collect();
            let mut rest = code;
            for i in &open {
                grips[*i] = [Grip::Sticks, Grip::Slides(1.0), Grip::Slides(-1.0)][rest % 3];
                rest /= 3;
            }
            let Some(now) = self.instant(&grips, tensions) else { return Err(Verdict::Undetermined) };
            let against = open.iter().all(|i| match grips[*i] {
                Grip::Sticks => true,
                Grip::Slides(sign) => {
                    let row = &self.contacts[*i].row;
                    let terms: f64 = row.iter().zip(&now.a).map(|(r, a)| (r * a).abs()).sum();
                    let slip = inner(row, &now.a);
                    slip * sign < 0.0 && slip.abs() > 1e-11 * terms
                }
            });
            if against && self.can_hold(&grips, tensions) == Some(true) {
                if code == 0 {
                    return Ok((grips, true));
                }
                fitting.push(grips);
            }
        }
        match fitting.len() {
            1 => Ok((fitting.remove(0), false)),
            0 => Err(Verdict::Undetermined),
            _ => Err(Verdict::Ambiguous),
        }
    }

    /// A motion that starts with speeds where something slips or several freedoms are left, from one contact that comes to rest to the
    /// next, up to its end.
    fn in_phases(&self, loose: &[Grip]) -> Verdict {
        let s = self.s;
        let mut v = match self.set_out(loose) {
            Ok(v) => v,
            Err(verdict) => return verdict,
        };
        if self.contacts.iter().any(|c| c.normal < 0.0) {
            return Verdict::LiftsOff;
        }
        let tensions: Vec<f64> = self.springs.iter().map(|s| s.ks * s.x0).collect();
        let speeds: f64 = v.iter().map(|v| v.abs()).sum();
        let slip = |c: &Contact, v: &[f64]| {
            let terms: f64 = c.row.iter().zip(v).map(|(r, v)| (r * v).abs()).sum();
            let slip = inner(&c.row, v);
            if c.said == Said::Rolls || slip.abs() <= 1e-11 * (terms + speeds) { 0.0 } else { slip }
        };
        let mut slips: Vec<f64> = self.contacts.iter().map(|c| slip(c, &v)).collect();
        slips.iter_mut().filter(|s| **s != 0.0).for_each(|s| *s = s.signum());
        let could_roll = self.contacts.iter().zip(&slips).any(|(c, s)| c.said == Said::Slips && *s == 0.0);
        let held = |c: &&Contact| self.modes(loose).iter().all(|z| inner(&c.row, z).abs() < NOTHING);
        if s.event == Event::AtOnce
            && self.contacts.iter().filter(|c| c.said == Said::Slips).any(|c| held(&c))
        {
            // Nothing more is told of a contact that other ties hold.
            let values = [self.velocities(&v), self.powers(s, &v)].concat();
            return Verdict::Told(Told { values, ..Told::default() });
        }
        let mut ending = Ending::default();
        let mut legs: Vec<Stretch> = Vec::new();
        let (mut told, mut time) = (Told::default(), 0.0);
        let mut closed: Vec<usize> = Vec::new();
        loop {
            let (grips, all) = match self.settle(&slips, &tensions) {
                Ok(settled) => settled,
                Err(_) if !legs.is_empty() => return Verdict::Torn,
                Err(verdict) => return verdict,
            };
            // What slides goes on the other way where it cannot be held; what holds, or is to roll, is not to be torn loose.
            let torn = |i: usize| grips[i] != Grip::Sticks && slips[i] == 0.0;
            let free = |i: usize| closed.contains(&i) && self.contacts[i].said == Said::Slides;
            if !all && !legs.is_empty() && !(0..slips.len()).filter(|i| torn(*i)).all(free) {
                return Verdict::Torn;
            }
            for (s, g) in slips.iter_mut().zip(&grips) {
                if let Grip::Slides(sign) = g {
                    *s = -sign;
                }
            }
            let Some(now) = self.instant(&grips, &tensions) else { return Verdict::Undetermined };
            let closing = |i: usize| {
                let c = &self.contacts[i];
                let terms: f64 = c.row.iter().zip(&now.a).map(|(r, a)| (r * a).abs()).sum();
                let rate = -inner(&c.row, &now.a) * slips[i];
                let slip = slip(c, &v).abs();
                (slips[i] != 0.0 && slip > 0.0 && rate > 1e-11 * terms).then(|| slip / rate)
            };
            let closings: Vec<Option<f64>> = (0..slips.len()).map(closing).collect();
            let next = closings.iter().flatten().copied().reduce(f64::min);
            let rests = |i: usize| closings[i].zip(next).is_some_and(|(t, next)| t <= next * (1.0 + 1e-9));
            let own = |i: usize, said: Said| self.contacts[i].body == s.of && self.contacts[i].said == said;
            let end = self.ends_in(&mut ending, (&v, &now.a, &slips), next, time);
            let mut leg = Stretch { from: v.clone(), now, grips, lasts: next.unwrap_or(0.0) };
            if let Some(end) = end {
                told.near_reach = next.is_some_and(|next| (end / next - 1.0).abs() < 1e-9)
                    && self.event() != Event::TurningPoint;
                leg.lasts = end;
                legs.push(leg);
                break;
            }
            let Some(next) = next.filter(|_| s.event != Event::AtOnce) else {
                told.near_reach |= ending.near;
                legs.push(leg);
                return self.tell_of(told, &ending, &legs, None, could_roll);
            };
            v = leg.after();
            time += next;
            legs.push(leg);
            closed = (0..slips.len()).filter(|i| rests(*i)).collect();
            closed.iter().for_each(|i| slips[*i] = 0.0);
            // A body that slides to its turning point may be torn loose there.
            if self.event() == Event::TurningPoint && closed.iter().any(|i| own(*i, Said::Slides)) {
                break;
            }
            if s.event == Event::Rolling && closed.iter().any(|i| own(*i, Said::Slips)) {
                if !self.settle(&slips, &tensions).is_ok_and(|settled| settled.1) {
                    return Verdict::Torn;
                }
                break;
            }
        }
        told.near_reach |= ending.near;
        let arrived = if s.event == Event::AtOnce { None } else { Some(legs.as_slice()) };
        self.tell_of(told, &ending, &legs, arrived, could_roll)
    }

    /// What ends the motion; what comes down to no speed comes to rest.
    fn event(&self) -> Event {
        match &self.s.by {
            Some(by) if self.s.event == Event::Speed && by.si == 0.0 && by.symbol.is_none() => {
                Event::TurningPoint
            }
            _ => self.s.event,
        }
    }

    /// Sense in which the centre of the ending body goes with these velocities, of this size; this of what has no line.
    fn goes(&self, v: &[f64], size: f64, sense: f64) -> f64 {
        let along = inner(&self.moving(self.s.of, false), v);
        match self.frames[self.s.of].line {
            true if along.abs() > 1e-11 * size => along.signum(),
            true => 0.0,
            false => sense,
        }
    }

    /// The ending coordinate.
    fn watch(&self) -> Vec<f64> {
        self.moving(self.s.of, self.s.event == Event::Turn || !self.frames[self.s.of].line)
    }

    /// When the end comes in a stretch of constant accelerations, unless a contact comes to rest before.
    fn ends_in(
        &self,
        ending: &mut Ending,
        (v, a, slips): (&[f64], &[f64], &[f64]),
        next: Option<f64>,
        time: f64,
    ) -> Option<f64> {
        let s = self.s;
        let watch = self.watch();
        let clean = |x: f64, of: &[f64]| {
            let terms: f64 = of.iter().map(|x| x.abs()).sum();
            if x.abs() <= 1e-11 * terms { 0.0 } else { x }
        };
        let (u, a) = (clean(inner(&watch, v), v), clean(inner(&watch, a), a));
        if ending.sense == 0.0 {
            ending.sense = if u != 0.0 {
                u.signum()
            } else if a != 0.0 {
                a.signum()
            } else {
                0.0
            };
        }
        let by = s.by.as_ref().map_or(0.0, |b| b.si);
        let by_then = |t: &f64| next.is_none_or(|next| *t <= next * (1.0 + 1e-9));
        let own = |said: Said, sticks: bool| {
            let mut own = self.contacts.iter().zip(slips);
            own.any(|(c, slip)| c.body == s.of && c.said == said && (*slip == 0.0) == sticks)
        };
        match self.event() {
            Event::AtOnce => return Some(0.0),
            Event::Time => return Some(by - time).filter(by_then),
            Event::Rolling => return (time == 0.0 && own(Said::Slips, true)).then_some(0.0),
            Event::TurningPoint if own(Said::Slides, false) => return None,
            _ => {}
        }
        if ending.turned || ending.sense == 0.0 {
            return None;
        }
        let (u, a) = (u * ending.sense, a * ending.sense);
        let turning = (a < 0.0).then(|| u.max(0.0) / -a);
        let way = |d: f64| -> Option<f64> {
            let square = u * u + 2.0 * a * d;
            (d >= 0.0 && square >= 0.0 && u + square.sqrt() > 0.0).then(|| 2.0 * d / (u + square.sqrt()))
        };
        let (mut all, mut least) = (None, 0.0);
        match self.event() {
            Event::Travel | Event::Turn => (all, least) = (way(by - ending.gone), by),
            Event::Position => (all, least) = (way(by * ending.sense - ending.gone), by.abs()),
            Event::Speed if u == by => all = Some(0.0),
            Event::Speed if a != 0.0 => all = Some((by - u) / a).filter(|t| *t >= 0.0),
            Event::TurningPoint => all = turning,
            _ => {}
        }
        if all.is_none() && next.is_none() && u == 0.0 && a == 0.0 && ending.gone > 0.0 {
            ending.near |= (ending.gone / least - 1.0).abs() < 1e-9;
        }
        ending.turned = turning.is_some_and(|t| by_then(&t));
        if let Some(t) = turning.filter(by_then) {
            let farthest = ending.gone + 0.5 * u * t;
            ending.near |= least != 0.0 && (farthest / least - 1.0).abs() < 1e-9;
        }
        let all = all.filter(|t| turning.is_none_or(|turning| *t <= turning * (1.0 + 1e-12)));
        if let Some(next) = next {
            ending.gone += u * next + 0.5 * a * next * next;
        }
        all.filter(by_then)
    }

    /// What there is to tell at the end of these stretches, or, where it does not come, of the start.
    fn tell_of(
        &self,
        mut told: Told,
        ending: &Ending,
        legs: &[Stretch],
        arrived: Option<&[Stretch]>,
        could_roll: bool,
    ) -> Verdict {
        let s = self.s;
        let tensions: Vec<f64> = self.springs.iter().map(|s| s.ks * s.x0).collect();
        let last = legs.last().expect("one at least");
        let v = last.after();
        let at_once = s.event == Event::AtOnce;
        let forces = self.forces;
        let speeds: f64 = legs.iter().flat_map(|leg| &leg.from).chain(&v).fold(0.0, |m, v| m.max(v.abs()));
        let time: f64 = legs.iter().map(|leg| leg.lasts).sum();
        let ways = speeds * time;
        let accelerations = legs.iter().flat_map(|leg| &leg.now.a).fold(s.gravity.si, |m, a| m.max(a.abs()));
        let own = inner(&self.watch(), &v);
        let moving = arrived.is_some() && own.abs() > 1e-11 * speeds && self.event() != Event::TurningPoint;
        told.sense = if moving { own.signum() } else { ending.sense };
        let wrong_way = match s.heading {
            Some("forward") => ending.sense < 0.0,
            Some("back") => ending.sense > 0.0,
            _ => false,
        };
        let there = if arrived.is_some() && !wrong_way { Some(&v) } else { None };
        told.direction = self.direction(match (s.event, there) {
            (Event::Turn, _) => self.goes(there.unwrap_or(&legs[0].from), speeds, told.sense),
            (Event::Rolling, Some(v)) => self.goes(v, speeds, told.sense),
            _ => told.sense,
        });
        told.as_said = told.sense != 0.0 && !wrong_way;
        let by = s.by.as_ref().map_or(0.0, |b| b.si);
        let back = match self.event() {
            Event::Speed => by == inner(&self.watch(), &legs[0].from).abs(),
            Event::TurningPoint | Event::AtOnce | Event::Rolling => false,
            _ => by == 0.0,
        };
        told.reached = arrived.is_some() && !back && !wrong_way;
        let mut say = |name, of, value: f64, size: f64| told.values.push((name, of, value, size));
        let mut open = Vec::new();
        let there = if arrived.is_some() { &last.now } else { &legs[0].now };
        let sum = |of: &dyn Fn(&Stretch) -> f64| -> f64 { legs.iter().map(of).sum() };
        let mut work = 0.0;
        for (b, f) in self.frames.iter().enumerate() {
            let body = Owner::Body(b);
            for (turns, _, acceleration) in
                [(false, f.line, "a"), (true, f.turns, "alpha")].into_iter().filter(|d| d.1)
            {
                let row = self.moving(b, turns);
                say(acceleration, body, inner(&row, &there.a), accelerations);
                if arrived.is_none() {
                    continue;
                }
                let (moved, path) = (sum(&|leg| leg.moved(&row)), sum(&|leg| leg.covered(&row)));
                let (u, u0) = (inner(&row, &v), inner(&row, &legs[0].from));
                if turns {
                    say("phi", body, moved.abs(), ways);
                    let couples = s.couples.iter().filter(|c| c.0 == b);
                    let moment = couples.map(|(_, m, forward)| if *forward { m.si } else { -m.si });
                    if let Some(m) = moment.reduce(|a, b| a + b) {
                        say("work_couple", body, m * moved, m.abs() * ways);
                        say("power_couple", body, m * u, m.abs() * speeds);
                        work += m * moved;
                    }
                } else {
                    say("displacement", body, moved, ways);
                    say("distance", body, path, ways);
                    say("impulse", body, self.mass[3 * b] * (u - u0), self.mass[3 * b] * speeds);
                }
            }
            if f.line && arrived.is_some() {
                let mut up = vec![0.0; self.cols()];
                up[3 * b + 1] = 1.0;
                let rise = sum(&|leg| leg.moved(&up));
                say("rise", body, rise, ways);
                work -= self.mass[3 * b] * s.gravity.si * rise;
            }
            let wall = matches!(s.bodies[b].way, Way::Along(i) if s.surfaces[i].vertical);
            let toothed = |tie: &Tie| matches!(tie, Tie::Rolls { body, mu_s: None, .. } if *body == b);
            let pulled =
                |tie: &Tie| matches!(tie, Tie::Cord { from, .. } if from.body == b && from.tilt.is_some());
            if f.line && f.on_surface && (!wall || !s.ties.iter().any(toothed) || s.ties.iter().any(pulled)) {
                say("normal", body, pressed(s, &self.frames, self.mass[3 * b], b), forces);
            }
        }
        let mut velocities = self.velocities(&v);
        let energy = velocities[0].2;
        let before = self.velocities(&legs[0].from)[0].2;
        if energy < 1e-20 * (before + forces * ways) {
            velocities.retain(|v| v.0 != "rotational_fraction");
        }
        if arrived.is_some() {
            say("t", Owner::Scene, time, time);
        }
        if arrived.is_some() || at_once {
            for (name, of, value, _) in velocities {
                say(name, of, value, if name == "rotational_fraction" { 1.0 } else { value + speeds });
            }
        }
        if at_once {
            for (name, of, value, size) in self.powers(s, &v) {
                say(name, of, value, size);
            }
        }
        let mut heat = None;
        let mut checks: Vec<(&'static str, usize, bool)> = Vec::new();
        for (i, c) in self.contacts.iter().enumerate() {
            let body = Owner::Body(c.body);
            let upward = dot(self.frames[c.body].forward, self.frames[c.body].up);
            match there.reactions[c.tie] {
                Some(force) => say("friction", body, force * upward, forces),
                None => open.push(("friction", body)),
            }
            if c.said != Said::Rolls {
                let slid: f64 = legs
                    .iter()
                    .filter(|leg| leg.grips[i] != Grip::Sticks)
                    .map(|leg| leg.covered(&c.row))
                    .sum();
                if arrived.is_some() {
                    heat = Some(heat.unwrap_or(0.0) + c.mu_k * c.normal * slid);
                    if c.said == Said::Slips {
                        say("slip_distance", body, slid, ways);
                    }
                    if legs.iter().any(|leg| leg.grips[i] == Grip::Sticks) {
                        checks.push(("no_slip", c.tie, true));
                    }
                }
                continue;
            }
            if self.frames[c.body].on_surface {
                let most = legs.iter().map(|leg| leg.now.reactions[c.tie]);
                let most = most.collect::<Option<Vec<f64>>>();
                let Some(most) = most else {
                    open.push(("mu_required", body));
                    continue;
                };
                let most = most.into_iter().fold(0.0f64, |m, r| m.max(r.abs()));
                if c.normal > 0.0 {
                    say("mu_required", body, most / c.normal, forces / c.normal);
                }
                if let Some(mu) = c.mu_s
                    && (mu * c.normal - most).abs() > 1e-9 * forces
                {
                    checks.push(("no_slip", c.tie, mu * c.normal > most));
                }
            }
        }
        if let Some(heat) = heat {
            say("heat", Owner::Scene, heat, heat);
        }
        for (t, tie) in s.ties.iter().enumerate() {
            let cord = Owner::Tie(t);
            match tie {
                Tie::Cord { from, far: Far::Pulled(p) } if arrived.is_some() => {
                    let (point, along) = leaves(s, &self.frames, from);
                    let mut row = vec![0.0; self.cols()];
                    row[3 * from.body] = along.0;
                    row[3 * from.body + 1] = along.1;
                    row[3 * from.body + 2] = dot(quarter(point), along);
                    if from.tilt.is_none() {
                        say("cord_travel", cord, sum(&|leg| leg.covered(&row)), ways);
                    }
                    let done = p.si * sum(&|leg| leg.moved(&row));
                    say("work_pull", cord, done, p.si * ways);
                    say("power_pull", cord, p.si * inner(&row, &v), p.si * speeds);
                    work += done;
                }
                Tie::Cord { far: Far::Spring { .. }, .. } => {
                    let own = self.springs.iter().position(|s| s.tie == t).expect("a spring");
                    say("tension", cord, tensions[own], forces);
                }
                Tie::Cord { far: Far::Fast | Far::To(_), .. } | Tie::Link { .. } => {
                    match there.reactions[t] {
                        Some(pull) => say("tension", cord, pull, forces),
                        None => open.push(("tension", cord)),
                    }
                    let all: Option<Vec<f64>> = legs.iter().map(|leg| leg.now.reactions[t]).collect();
                    if let (Tie::Cord { .. }, Some(least)) =
                        (tie, all.and_then(|all| all.into_iter().reduce(f64::min)))
                        && least.abs() > 1e-9 * forces
                    {
                        checks.push(("taut", t, least > 0.0));
                    }
                }
                _ => {}
            }
        }
        let (pins, shared) = self.axles(there, &tensions);
        pins.into_iter().for_each(|(name, of, value)| say(name, of, value, forces));
        open.extend(shared);
        (told.open, told.checks) = (open, checks);
        if arrived.is_some() {
            let off = (before + work - heat.unwrap_or(0.0) - energy).abs();
            let size = before + energy + heat.unwrap_or(0.0) + forces * ways;
            assert!(off <= 1e-9 * size, "the judge's own energies differ by {off}");
        }
        if could_roll { Verdict::CouldRoll } else { Verdict::Told(told) }
    }

    pub fn judge(&self) -> Verdict {
        let s = self.s;
        let all: Vec<Grip> = vec![Grip::Sticks; self.contacts.len()];
        let loose: Vec<Grip> = self.contacts.iter().map(Contact::loose).collect();
        let freedoms = self.modes(&loose).len();
        let slips = self.contacts.iter().any(|c| c.said == Said::Slips);
        // On the way; at an instant a spring is a force like others.
        let sprung = !self.springs.is_empty() && s.event != Event::AtOnce;
        if slips && sprung {
            return Verdict::Beyond("a spring where something slips");
        }
        if freedoms > 1 && sprung {
            return Verdict::Beyond("a spring with two freedoms");
        }
        if !s.start.is_empty() && (slips || freedoms > 1) {
            return self.in_phases(&loose);
        }
        let (v0, started) = match s.start.first() {
            None => (vec![0.0; self.cols()], false),
            Some((.., v)) if freedoms == 0 && v.si != 0.0 => return Verdict::Contradiction,
            Some(_) if freedoms == 0 => (vec![0.0; self.cols()], false),
            Some((body, spin, v)) => {
                let mode = self.modes(&loose).remove(0);
                let ratio = inner(&self.moving(*body, *spin), &mode);
                if ratio.abs() < NOTHING {
                    if v.si != 0.0 {
                        return Verdict::Contradiction;
                    }
                    (vec![0.0; self.cols()], false)
                } else {
                    (mode.iter().map(|z| z * v.si / ratio).collect(), v.si != 0.0)
                }
            }
        };
        let mut velocities = Vec::new();
        if s.event == Event::AtOnce {
            velocities = self.velocities(&v0);
            velocities.extend(self.powers(s, &v0));
        }
        if self.contacts.iter().any(|c| c.normal < 0.0) {
            return Verdict::LiftsOff;
        }
        let tensions: Vec<f64> = self.springs.iter().map(|s| s.ks * s.x0).collect();
        let grips = if started {
            // What moves has kinetic friction against it; what the ties hold at rest stays.
            self.contacts
                .iter()
                .map(|c| {
                    let slip = inner(&c.row, &v0);
                    if c.said == Said::Rolls || slip.abs() < NOTHING * v0.iter().map(|v| v.abs()).sum::<f64>()
                    {
                        Grip::Sticks
                    } else {
                        Grip::Slides(-slip.signum())
                    }
                })
                .collect()
        } else {
            match self.grips_from_rest(&tensions) {
                Ok(grips) => grips,
                Err(verdict) => return verdict,
            }
        };
        if self.contacts.iter().zip(&grips).any(|(c, g)| c.said == Said::Slips && *g == Grip::Sticks) {
            return Verdict::CouldRoll;
        }
        let Some(now) = self.instant(&grips, &tensions) else { return Verdict::Undetermined };
        let mut told = Told::default();
        self.move_on(&grips, &all, &v0, started, now, &tensions, &mut told);
        if s.event == Event::AtOnce {
            told.at_once(velocities);
        }
        Verdict::Told(told)
    }

    #[expect(clippy::too_many_arguments, reason = "a test's own walk through one motion")]
    fn move_on(
        &self,
        grips: &[Grip],
        all: &[Grip],
        v0: &[f64],
        started: bool,
        now: Instant,
        tensions: &[f64],
        told: &mut Told,
    ) {
        let s = self.s;
        let n = self.cols();
        let turn_end = s.event == Event::Turn || !self.frames[s.of].line;
        let watch = self.moving(s.of, turn_end);
        let still = |x: &[f64]| x.iter().all(|v| *v == 0.0);
        told.rests = !started && still(&now.a);
        let lead_v = inner(&watch, v0);
        let lead_a = {
            let a = inner(&watch, &now.a);
            let terms: f64 = watch.iter().zip(&now.a).map(|(w, a)| (w * a).abs()).sum();
            if a.abs() < 1e-11 * terms { 0.0 } else { a }
        };
        told.sense = if lead_v != 0.0 {
            lead_v.signum()
        } else if lead_a != 0.0 {
            lead_a.signum()
        } else {
            0.0
        };
        let by = s.by.as_ref().map_or(0.0, |b| b.si);
        // What comes down to no speed comes to rest.
        let event = match &s.by {
            Some(by) if s.event == Event::Speed && by.si == 0.0 && by.symbol.is_none() => Event::TurningPoint,
            _ => s.event,
        };
        // The motion as one coordinate `q` that grows, everything else in proportion (from rest under constant forces, or
        // with one freedom).
        let shape: Vec<f64> = if started { v0.to_vec() } else { now.a.clone() };
        let per = inner(&watch, &shape);
        let moves = told.sense != 0.0;
        let q: Vec<f64> =
            if moves { shape.iter().map(|x| x / per * told.sense).collect() } else { vec![0.0; n] };
        let u0 = lead_v.abs();
        let lead = |a: &[f64]| inner(&watch, a) * told.sense;
        let mut law = Law { u0, a: lead(&now.a), springs: Vec::new() };
        // At an instant they are forces like others.
        if moves && s.event != Event::AtOnce {
            // Those whose ends do not move pull all the time.
            let acts = |s: &Spring| inner(&s.row, &q).abs() > NOTHING;
            let pulls = |i: usize, f: f64| -> Vec<f64> {
                let of = |(k, s): (usize, &Spring)| if acts(s) { f64::from(k == i) * f } else { tensions[k] };
                self.springs.iter().enumerate().map(of).collect()
            };
            let under = |i: usize, f: f64| lead(&self.instant(grips, &pulls(i, f)).expect("as before").a);
            for (i, s) in self.springs.iter().enumerate().filter(|(_, s)| acts(s)) {
                let (ks, x0, gamma, rigid) = (s.ks, s.x0, inner(&s.row, &q), s.rigid);
                law.springs.push(Pull { per_newton: under(i, 1.0) - under(i, 0.0), ks, x0, gamma, rigid });
                law.a = under(i, 0.0);
            }
        }
        let turns_at = law.turning();
        let farthest = turns_at.map_or(f64::INFINITY, |t| law.place(t));
        let wrong_way = match s.heading {
            Some("forward") => told.sense < 0.0,
            Some("back") => told.sense > 0.0,
            _ => false,
        };
        let place = |d: f64| -> Option<f64> { told_time(d, farthest, turns_at, |t| law.place(t)) };
        let time = if !moves || wrong_way {
            None
        } else {
            match event {
                Event::Travel | Event::Turn => place(by),
                Event::Position => {
                    if by * told.sense >= 0.0 {
                        place(by.abs())
                    } else {
                        None
                    }
                }
                Event::Time => turns_at.is_none_or(|t| by <= t * (1.0 + 1e-12)).then_some(by),
                Event::Speed => law.reaching(by),
                Event::TurningPoint => turns_at,
                Event::AtOnce | Event::Rolling => None,
            }
        };
        told.as_said = moves && !wrong_way;
        told.direction =
            self.direction(if event == Event::Turn { self.goes(&q, 1.0, told.sense) } else { told.sense });
        // Where it is set going is no place at which it ends.
        let back = match event {
            Event::Speed => by == law.speed(0.0),
            Event::TurningPoint => false,
            _ => by == 0.0,
        };
        told.reached = time.is_some() && !back;
        told.near_reach = match event {
            Event::Travel | Event::Turn | Event::Position => (by.abs() / farthest - 1.0).abs() < 1e-9,
            Event::Time => turns_at.is_some_and(|t| (by / t - 1.0).abs() < 1e-9),
            Event::Speed => law.fastest().is_some_and(|(_, v)| (by / v - 1.0).abs() < 1e-9),
            _ => false,
        };
        let at = time.map_or(0.0, |t| law.place(t));
        let pulls_at = |place: f64| -> Vec<f64> {
            let pull = |s: &Spring| {
                let x = s.x0 - inner(&s.row, &q) * place;
                if x < 0.0 && !s.rigid { 0.0 } else { s.ks * x }
            };
            self.springs.iter().map(pull).collect()
        };
        let pulls = if moves && time.is_some() { pulls_at(at) } else { tensions.to_vec() };
        let pull_of = |t: usize| {
            let own = self.springs.iter().position(|s| s.tie == t);
            own.map_or(0.0, |i| pulls[i])
        };
        let there = self.instant(grips, &pulls).expect("as before");
        let u = match (event, time) {
            (Event::TurningPoint, _) => 0.0,
            (_, Some(t)) if law.speed(t) < 1e-12 * u0 => 0.0,
            (_, Some(t)) => law.speed(t),
            _ => 0.0,
        };
        let forces = self.forces;
        // Natural sizes, for what cancels.
        let accelerations = now.a.iter().chain(&there.a).fold(s.gravity.si, |m, a| m.max(a.abs()));
        let mut say = |name, of, value: f64, size: f64| told.values.push((name, of, value, size));
        let arrived = time.is_some();
        let mut energy = 0.0;
        let mut spinning = 0.0;
        for (b, f) in self.frames.iter().enumerate() {
            let own = Owner::Body(b);
            let degrees = [
                (false, f.line, ["a", "v", "displacement"], self.mass[3 * b]),
                (true, f.turns, ["alpha", "omega", "phi"], self.inertia[b]),
            ];
            for (turns, _, [acceleration, speed, way], inertia) in degrees.into_iter().filter(|d| d.1) {
                let row = self.moving(b, turns);
                say(acceleration, own, inner(&row, &there.a), accelerations);
                let v = inner(&row, &q) * u;
                if arrived || told.rests {
                    say(speed, own, v.abs(), v.abs());
                }
                if arrived {
                    let signed = inner(&row, &q) * at;
                    say(way, own, if turns { signed.abs() } else { signed }, at);
                    let before = inner(&row, v0);
                    if turns {
                        say("angular_momentum", own, inertia * v.abs(), inertia * v.abs());
                        let couples = s.couples.iter().filter(|c| c.0 == b);
                        let moment = couples
                            .map(|(_, m, forward)| if *forward { m.si } else { -m.si })
                            .reduce(|a, b| a + b);
                        if let Some(m) = moment {
                            say("work_couple", own, m * signed, m.abs() * at);
                            say("power_couple", own, m * v, m.abs() * u);
                        }
                    } else {
                        say("distance", own, signed.abs(), at);
                        say("impulse", own, inertia * (v - before), inertia * (v.abs() + before.abs()));
                    }
                }
                let kinetic = 0.5 * inertia * v * v;
                energy += kinetic;
                if turns {
                    spinning += kinetic;
                }
            }
            if f.line && arrived {
                say("rise", own, q[3 * b + 1] * at, at * q[3 * b].abs().max(q[3 * b + 1].abs()));
            }
            if f.line && f.on_surface {
                let normal = pressed(s, &self.frames, self.mass[3 * b], b);
                // On a wall what rolls without a coefficient of friction has teeth.
                let wall = matches!(s.bodies[b].way, Way::Along(i) if s.surfaces[i].vertical);
                let toothed = |tie: &Tie| matches!(tie, Tie::Rolls { body, mu_s: None, .. } if *body == b);
                let pulled = |tie: &Tie| matches!(tie, Tie::Cord { from, .. } if from.body == b && from.tilt.is_some());
                if !wall || !s.ties.iter().any(toothed) || s.ties.iter().any(pulled) {
                    say("normal", own, normal, forces);
                }
            }
        }
        if arrived || told.rests {
            say("kinetic_energy", Owner::Scene, energy, energy);
        }
        if arrived {
            say("t", Owner::Scene, time.unwrap_or(0.0), time.unwrap_or(0.0));
            let start: f64 = 0.5 * v0.iter().zip(&self.mass).map(|(v, m)| m * v * v).sum::<f64>();
            // With a spring the work of all forces is not told: it may be the small rest of large works.
            if self.springs.is_empty() {
                say("work", Owner::Scene, energy - start, energy + start);
            }
            // The share is that of any speed: the program tells it only where something moves.
            if energy > 0.0 {
                say("rotational_fraction", Owner::Scene, spinning / energy, 1.0);
            }
        }
        // Over the motion: the ends of the range of the tensions, and where a cord goes slack.
        let last_place = match turns_at {
            Some(t) if !self.springs.is_empty() => law.place(t),
            _ => 0.0,
        };
        // As far as the scene looks: to its end, or to the turning point if it turns before.
        let places: Vec<f64> = if !moves || s.event == Event::AtOnce {
            Vec::new()
        } else {
            let last = if arrived {
                at
            } else if turns_at.is_some() {
                last_place
            } else {
                f64::INFINITY
            };
            let slack = law.springs.iter().filter(|p| !p.rigid && p.gamma > 0.0).map(|p| p.x0 / p.gamma);
            slack.filter(|at| *at < last).chain((last < f64::INFINITY).then_some(last)).collect()
        };
        let later = places.into_iter().map(|at| self.instant(grips, &pulls_at(at)).expect("as before"));
        let over: Vec<Instant> = std::iter::once(now).chain(later).collect();
        let mut heat = None;
        let mut open = Vec::new();
        let mut checks: Vec<(&'static str, usize, bool)> = Vec::new();
        let mut check = |name, of, room: f64, size: f64| {
            if room.abs() > 1e-9 * size {
                checks.push((name, of, room > 0.0));
            }
        };
        for c in &self.contacts {
            let own = Owner::Body(c.body);
            let f = &self.frames[c.body];
            let upward = dot(f.forward, f.up);
            match there.reactions[c.tie] {
                Some(force) => say("friction", own, force * upward, forces),
                None => open.push(("friction", own)),
            }
            let slip = inner(&c.row, &q) * at;
            if c.said != Said::Rolls && arrived {
                // What does not slip makes no heat, whatever holds it.
                let force = if slip == 0.0 { Some(0.0) } else { there.reactions[c.tie] };
                heat = force.map(|f| heat.unwrap_or(0.0) + (f * slip).abs());
            }
            if c.said == Said::Slips && arrived {
                say("slip_distance", own, slip.abs(), at);
            }
            if c.said == Said::Rolls && f.on_surface {
                let most = over
                    .iter()
                    .map(|i| i.reactions[c.tie])
                    .try_fold(0.0f64, |m, r| r.map(|r| m.max(r.abs())));
                match most {
                    Some(most) => {
                        let normal = if c.normal == 0.0 { 0.0 } else { c.normal };
                        if normal > 0.0 {
                            say("mu_required", own, most / normal, forces / normal);
                        }
                        if let Some(mu) = c.mu_s {
                            check("no_slip", c.tie, mu * normal - most, forces);
                        }
                    }
                    None => open.push(("mu_required", own)),
                }
            }
            if c.said == Said::Slips {
                // As if this contact rolled, the others as they are.
                let mut rolled = grips.to_vec();
                let place = self.contacts.iter().position(|o| o.tie == c.tie).expect("itself");
                rolled[place] = Grip::Sticks;
                if let Some(r) = self.instant(&rolled, tensions).and_then(|i| i.reactions[c.tie]) {
                    say("friction_if_rolled", own, r * upward, forces);
                    if c.normal > 0.0 {
                        say("mu_required", own, r.abs() / c.normal, forces / c.normal);
                        check("must_slip", c.tie, r.abs() - c.mu_s.unwrap_or(0.0) * c.normal, forces);
                    }
                }
            }
        }
        let _ = all;
        if let Some(heat) = heat {
            say("heat", Owner::Scene, heat, heat);
        }
        for (t, tie) in s.ties.iter().enumerate() {
            let own = Owner::Tie(t);
            if let Tie::Link { .. } = tie {
                match there.reactions[t] {
                    Some(pull) => say("tension", own, pull, forces),
                    None => open.push(("tension", own)),
                }
            }
            let Tie::Cord { from, far } = tie else { continue };
            let (point, along) = leaves(s, &self.frames, from);
            let b = from.body;
            let rate =
                q[3 * b] * along.0 + q[3 * b + 1] * along.1 + q[3 * b + 2] * dot(quarter(point), along);
            match far {
                Far::Pulled(p) if arrived => {
                    if from.tilt.is_none() {
                        say("cord_travel", own, (rate * at).abs(), at);
                    }
                    say("work_pull", own, p.si * rate * at, p.si * at);
                    say("power_pull", own, p.si * rate * u, p.si * u);
                }
                Far::Pulled(_) => {}
                Far::Spring { .. } => {
                    if arrived {
                        say("cord_travel", own, (rate * at).abs(), at);
                    }
                    say("tension", own, pull_of(t), forces);
                }
                Far::Fast | Far::To(_) => {
                    match there.reactions[t] {
                        Some(pull) => say("tension", own, pull, forces),
                        None => open.push(("tension", own)),
                    }
                    let all: Option<Vec<f64>> = over.iter().map(|i| i.reactions[t]).collect();
                    if let Some(least) = all.and_then(|all| all.into_iter().reduce(f64::min)) {
                        check("taut", t, least, forces);
                    }
                }
            }
        }
        let (pins, shared) = self.axles(&there, &pulls);
        pins.into_iter().for_each(|(name, own, value)| say(name, own, value, forces));
        open.extend(shared);
        // Where nothing accelerates, sliding friction left out.
        let mode = self.modes(&self.contacts.iter().map(Contact::loose).collect::<Vec<_>>());
        if let Some(mode) =
            mode.first().filter(|m| self.springs.iter().any(|s| inner(&s.row, m).abs() > NOTHING))
        {
            let gamma: Vec<f64> = self.springs.iter().map(|s| inner(&s.row, mode)).collect();
            let sum = |of: &dyn Fn(&Spring, f64) -> f64| -> f64 {
                self.springs.iter().zip(&gamma).map(|(s, g)| of(s, *g)).sum()
            };
            let stiff = sum(&|s, g| s.ks * g * g);
            let free = inner(mode, &self.force);
            let free = if free.abs() < 1e-12 * self.terms(&[], mode, &[]) { 0.0 } else { free };
            // The energy of all is least there.
            let moved = (free + sum(&|s, g| s.ks * g * s.x0)) / stiff;
            let at_rest: Vec<f64> = self.springs.iter().zip(&gamma).map(|(s, g)| s.x0 - g * moved).collect();
            let small = |s: &Spring, x: f64| x.abs() < 1e-12 * (s.x0.abs() + forces / s.ks);
            let stretched = |least: bool| {
                self.springs
                    .iter()
                    .zip(&at_rest)
                    .all(|(s, x)| s.rigid || if small(s, *x) { !least } else { *x > 0.0 })
            };
            if stretched(false) {
                for (s, x) in self.springs.iter().zip(&at_rest) {
                    say("x_eq", Owner::Tie(s.tie), if small(s, *x) { 0.0 } else { *x }, s.x0 + forces / s.ks);
                }
                let rubs = s.ties.iter().any(|t| matches!(t, Tie::Slips { .. } | Tie::Slides { .. }));
                let [x_end, y_end, turn] = [0, 1, 2].map(|i| mode[3 * s.of + i].abs());
                let ends = if turn_end { turn } else { x_end.max(y_end) };
                if !rubs && ends > NOTHING && stretched(true) {
                    let moved: f64 = mode.iter().zip(&self.mass).map(|(z, m)| m * z * z).sum();
                    let rate = (stiff / moved).sqrt();
                    say("omega_small", Owner::Body(s.of), rate, rate);
                    let period = 2.0 * std::f64::consts::PI / rate;
                    say("period_small", Owner::Body(s.of), period, period);
                }
            }
        }
        if (!self.springs.is_empty() || started) && !turn_end {
            let own = Owner::Body(s.of);
            if moves {
                if let Some((at, v)) = law.fastest() {
                    say("v_max", own, v, v);
                    say("D_at_v_max", own, at, farthest.min(at.max(1.0)));
                }
                say("D_turn", own, farthest, farthest);
            } else if !self.springs.is_empty() {
                for name in ["v_max", "D_at_v_max", "D_turn"] {
                    say(name, own, 0.0, 0.0);
                }
            }
        }
        told.open = open;
        told.checks = checks;
        // The friction of what is lifted off its surface would drive it: no account, and nothing is published of it.
        if arrived && self.contacts.iter().all(|c| c.normal >= 0.0) {
            self.account(&q, at, u, u0, energy, told);
        }
    }

    /// The judge judges itself: kinetic energy gained is the work done.
    fn account(&self, q: &[f64], at: f64, u: f64, u0: f64, energy: f64, told: &Told) {
        let _ = u;
        let start: f64 = 0.5 * q.iter().zip(&self.mass).map(|(z, m)| m * z * z).sum::<f64>() * u0 * u0;
        let mut work = inner(q, &self.force) * at;
        let mut size = q.iter().zip(&self.force).map(|(z, f)| (z * f * at).abs()).sum::<f64>();
        for Spring { row, ks, x0, rigid, .. } in &self.springs {
            let mut x = x0 - inner(row, q) * at;
            if x < 0.0 && !rigid {
                x = 0.0;
            }
            work += 0.5 * ks * (x0 * x0 - x * x);
            size += 0.5 * ks * (x0 * x0 + x * x);
        }
        let heat = told.values.iter().find(|v| v.0 == "heat").map_or(0.0, |v| v.2);
        let off = (start + work - heat - energy).abs();
        assert!(
            off <= 1e-8 * (size + start + heat + energy),
            "the judge's own energies differ by {off}: {start} + {work} - {heat} - {energy}"
        );
    }
}

/// Time at which a growing place is reached.
fn told_time(d: f64, farthest: f64, turns_at: Option<f64>, place: impl Fn(f64) -> f64) -> Option<f64> {
    if d > farthest * (1.0 + 1e-12) {
        return None;
    }
    if d <= 0.0 {
        return Some(0.0);
    }
    let most = turns_at.unwrap_or_else(|| {
        let mut t = 1.0;
        while place(t) < d {
            t *= 2.0;
        }
        t
    });
    Some(bisect(0.0, most, |t| place(t) >= d))
}

/// The least argument at which a condition that stays holds.
fn bisect(low: f64, high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (low, high);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// A spring that acts on the coordinate.
#[derive(Clone)]
struct Pull {
    per_newton: f64,
    ks: f64,
    x0: f64,
    gamma: f64,
    rigid: bool,
}

/// The motion of the ending coordinate in time, in the sense in which it sets off.
struct Law {
    u0: f64,
    /// Acceleration without the springs.
    a: f64,
    springs: Vec<Pull>,
}

impl Law {
    fn acceleration(&self, place: f64) -> f64 {
        let pull = |p: &Pull| {
            let x = p.x0 - p.gamma * place;
            p.per_newton * p.ks * if x < 0.0 && !p.rigid { 0.0 } else { x }
        };
        self.a + self.springs.iter().map(pull).sum::<f64>()
    }
    /// Square of the angular frequency of the swing on all springs, 0 without any.
    fn w2(&self) -> f64 {
        self.springs.iter().map(|p| p.per_newton * p.ks * p.gamma).sum()
    }
    /// Place and speed of the swing at a time, as long as all springs act.
    fn swing(&self, t: f64) -> (f64, f64) {
        let (w2, start) = (self.w2(), self.acceleration(0.0));
        if self.springs.is_empty() {
            return (self.u0 * t + 0.5 * self.a * t * t, self.u0 + self.a * t);
        }
        assert!(w2 > 0.0, "a spring holds back");
        let w = w2.sqrt();
        let (s, c) = (libm::sin(w * t), libm::cos(w * t));
        let half = libm::sin(0.5 * w * t);
        (start / w2 * 2.0 * half * half + self.u0 / w * s, start / w * s + self.u0 * c)
    }
    /// Time at which the swing comes to rest.
    fn swing_rest(&self) -> f64 {
        let w = self.w2().sqrt();
        // start/w sin + u0 cos = 0 for the first time.
        let angle = std::f64::consts::PI - libm::atan2(self.u0, self.acceleration(0.0) / w);
        if self.u0 == 0.0 { std::f64::consts::PI / w } else { angle / w }
    }
    /// Time and place at which the first cord goes slack, and the motion from there on.
    fn beyond(&self) -> Option<(f64, f64, Self)> {
        let place = |p: &Pull| (!p.rigid && p.gamma > 0.0).then(|| p.x0 / p.gamma);
        let (first, at) = self
            .springs
            .iter()
            .enumerate()
            .filter_map(|(i, p)| Some((i, place(p)?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        let time = if at == 0.0 {
            0.0
        } else {
            let rest = self.swing_rest();
            if self.swing(rest).0 <= at {
                return None;
            }
            bisect(0.0, rest, |t| self.swing(t).0 >= at)
        };
        let mut springs = self.springs.clone();
        springs.remove(first);
        springs.iter_mut().for_each(|p| p.x0 -= p.gamma * at);
        Some((time, at, Self { u0: self.swing(time).1, a: self.a, springs }))
    }
    fn state(&self, t: f64) -> (f64, f64) {
        match self.beyond() {
            Some((time, at, next)) if t > time => {
                let (x, u) = next.state(t - time);
                (at + x, u)
            }
            _ => self.swing(t),
        }
    }
    fn place(&self, t: f64) -> f64 {
        self.state(t).0
    }
    fn speed(&self, t: f64) -> f64 {
        self.state(t).1
    }
    fn turning(&self) -> Option<f64> {
        match self.beyond() {
            Some((time, _, next)) => next.turning().map(|t| time + t),
            None if self.springs.is_empty() => (self.a < 0.0).then(|| -self.u0 / self.a),
            None => Some(self.swing_rest()),
        }
    }
    /// Place and speed at which it is fastest; none if it grows without end.
    fn fastest(&self) -> Option<(f64, f64)> {
        let t = self.peak()?;
        Some((self.place(t), self.speed(t)))
    }
    fn peak(&self) -> Option<f64> {
        if self.acceleration(0.0) <= 0.0 {
            return Some(0.0);
        }
        let end = self.turning().or_else(|| {
            // It goes on and on, at a constant speed once all cords are slack, or faster and faster.
            let (mut law, mut end) = (self.beyond()?, 0.0);
            loop {
                end += law.0;
                match law.2.beyond() {
                    Some(next) => law = next,
                    None => return (law.2.a <= 0.0).then_some(end),
                }
            }
        })?;
        Some(bisect(0.0, end, |t| self.acceleration(self.place(t)) <= 0.0 || t >= end))
    }
    /// First time at which it has this speed.
    fn reaching(&self, u: f64) -> Option<f64> {
        if u == self.u0 {
            return Some(0.0);
        }
        let peak = self.peak();
        if u > self.u0 {
            let end = match peak {
                Some(t) => t,
                None => {
                    let mut t = 1.0;
                    while self.speed(t) < u {
                        t *= 2.0;
                        if t > 1e12 {
                            return None;
                        }
                    }
                    t
                }
            };
            return (self.speed(end) >= u).then(|| bisect(0.0, end, |t| self.speed(t) >= u));
        }
        // Slower than at the start: on the way to the turning point.
        let end = self.turning()?;
        let from = peak.unwrap_or(0.0);
        Some(bisect(from, end, |t| self.speed(t) <= u))
    }
}
