//! Where everything of a scene stands on the board: surfaces, bodies, cords, pulleys, to scale. Worked out from the ties.
//!
//! A body on a surface fixes its surface; cords lead from a placed body to the next one, straight where both ends point at
//! each other, else over a guide pulley. What hangs together is one group; groups stand side by side. Radii are to scale,
//! lengths of cords are as long as the picture needs.
use crate::figure::view::SceneView;
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::scene::{
    Aim, Attach, Body, Cord, CordEnd, Degree, End, Far, Line, Made, Num, RotaryInertia, Shape, Side, Slope,
    Tie,
};
use std::f64::consts::PI;

/// Radius of a guide pulley.
pub const GUIDE: f64 = 13.0;
/// Least radius that is drawn.
const LEAST: f64 = 3.0;
/// Length of a pull's arrow.
pub const PULL: f64 = 58.0;
/// Distance between cords that leave a block side by side.
const BESIDE: f64 = 18.0;
/// Length of a spring without stretch.
const SPRING: f64 = 62.0;

/// What a body looks like.
#[derive(Debug, Clone, PartialEq)]
pub enum BodyLook {
    /// Turns: circles, the outermost first. `open` for what is mostly a ring.
    Wheel {
        /// Outermost radius.
        outer: f64,
        /// All radii within it, that have a meaning.
        rings: Vec<f64>,
        /// Is it a hoop or a shell?
        open: bool,
    },
    /// Only moves: half its length along its line, half its width.
    Block { along: f64, across: f64 },
}

/// A body on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Its mass centre.
    pub centre: Vec2,
    /// Its forward direction.
    pub forward: Vec2,
    /// Its top side: away from the surface.
    pub top: Vec2,
    /// Is a positive turn clockwise?
    pub clockwise: bool,
    /// What it looks like.
    pub look: BodyLook,
    /// Distance of the centre from the surface.
    pub contact: f64,
    /// Its surface.
    pub on: Option<usize>,
}

impl Placed {
    /// How far it reaches in a direction.
    pub fn reach(&self, towards: Vec2) -> f64 {
        match &self.look {
            BodyLook::Wheel { outer, .. } => *outer,
            BodyLook::Block { along, across } => {
                along * self.forward.dot(&towards).abs() + across * self.top.dot(&towards).abs()
            }
        }
    }
    /// Direction from the centre to where a wound cord leaves it in a direction.
    pub fn winds(&self, side: Side, forward: bool, towards: Vec2) -> Vec2 {
        let pays_out = (side == Side::Top) == forward;
        if self.clockwise == pays_out { towards.left() } else { towards.right() }
    }
    /// Direction at an angle in degrees, counted from forward toward the top.
    pub fn direction(&self, degrees: f64) -> Vec2 {
        let [x, y] = Vec2::at_degrees(degrees).into();
        self.forward * x + self.top * y
    }
    /// The point so far from the centre in that direction, and the direction.
    pub fn spot(&self, degrees: f64, far: f64) -> (Vec2, Vec2) {
        let towards = self.direction(degrees);
        (self.centre + towards * far, towards)
    }
    /// Does it roll or slip on a radius within its outline, so that its surface is a rail?
    pub fn on_rail(&self) -> bool {
        self.on.is_some() && matches!(&self.look, BodyLook::Wheel { outer, .. } if self.contact < outer - 1.0)
    }
}

/// A surface on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// As the scene has it.
    pub slope: Slope,
    /// A point of it.
    pub origin: Vec2,
    /// Up the slope (on a level: forward).
    pub up: Vec2,
    /// Out of the surface.
    pub out: Vec2,
    /// Its ends, counted from the origin along `up`.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// Does it end at `to` with a drop, so that something can hang there?
    pub drop: bool,
    /// Is it a narrow rail?
    pub rail: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CordPiece {
    Straight(Vec2, Vec2),
    /// Round a body or pulley: centre, radius, angles.
    Round(Vec2, f64, f64, f64),
    /// A post on a block that is lower than the cord.
    Post(Vec2, Vec2),
}

/// What a cord ends at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CordStop {
    /// A pull: from, to.
    Pull(Vec2, Vec2),
    /// A spring: from, to; the wall stands at its end. The third is where the cord would end without stretch.
    Spring(Vec2, Vec2, Vec2),
    /// A fixed point, with the direction in which the cord arrives.
    Fixed(Vec2, Vec2),
    /// Another body.
    Body,
}

/// A cord on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct CordRun {
    /// Index of its tie.
    pub tie: usize,
    pub pieces: Vec<CordPiece>,
    /// What it ends at.
    pub stop: CordStop,
    /// Guide pulley: centre, radius.
    pub guide: Option<(Vec2, f64)>,
    /// Where and in which direction it leaves the body from which it was drawn.
    pub leaves: (Vec2, Vec2),
    /// Each body that it is at, with the direction in which it leaves it.
    pub at: Vec<(usize, Vec2)>,
}

/// A scene on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneLayout {
    /// Pixels per metre.
    pub scale: f64,
    /// Bodies that move along lines or turn about fixed axles; `None` for the others.
    pub bodies: Vec<Option<Placed>>,
    /// Surfaces.
    pub grounds: Vec<Ground>,
    pub cords: Vec<CordRun>,
    /// A spring that is met only in the motion that follows.
    pub awaited: Option<Awaited>,
}

/// A spring that stands in the way of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Awaited {
    pub stiffness: Num,
    /// Its free end.
    pub from: Vec2,
    /// Its end at the wall.
    pub to: Vec2,
    /// Out of the surface on which the body meets it.
    pub out: Vec2,
    /// From its axis to this surface; 0 where the body moves freely.
    pub high: f64,
}

struct Builder<'a> {
    view: SceneView<'a>,
    scale: f64,
    bodies: Vec<Option<Placed>>,
    grounds: Vec<Ground>,
    cords: Vec<CordRun>,
    awaited: Option<Awaited>,
    /// Cords that hang from each body, so that they hang at different heights.
    hanging: Vec<usize>,
    /// Limits of surfaces at their upper ends.
    limits: Vec<Option<f64>>,
}

/// Two bodies that a cord joins.
struct BodyPair {
    near: CordEnd,
    far: CordEnd,
    from: Placed,
    to: Placed,
    /// Did the second one stand before?
    placed: bool,
    /// Surfaces that were there before.
    grounds: usize,
    /// Directions in which the cord leaves both.
    away: Vec2,
    back: Vec2,
    /// Where it leaves the first one, and where it is seen to.
    at: Vec2,
    start: Vec2,
}

/// How far a body is drawn to go at most in a direction, of the way of its centre.
pub fn most_travel(p: &Placed, towards: Vec2) -> f64 {
    p.reach(towards) + if p.on.is_none() { 70.0 } else { 96.0 }
}

/// Outermost radius of a body that turns, m: the largest that is given, or as for a disc where the given ones lie within
/// its radius of gyration.
pub fn outer_m(view: &SceneView, body: usize) -> f64 {
    let body = &view.scene.bodies[body];
    let given = view.radii(body).first().map_or(0.0, |(_, r)| *r);
    let gyration = match &body.inertia {
        Some(RotaryInertia::Gyration(k)) => view.of(*k),
        _ => 0.0,
    };
    let outer = if gyration >= given { gyration * 1.35 } else { given };
    if outer.is_finite() && outer > 0.0 { outer } else { 1.0 }
}

/// Is it a hoop or a shell, with nothing inside?
pub fn is_open(body: &Body) -> bool {
    matches!(body.inertia, Some(RotaryInertia::Shape(Shape::Hoop | Shape::Shell, _)))
}

/// What a body looks like at a scale.
pub fn look(view: &SceneView, index: usize, scale: f64) -> BodyLook {
    let body = &view.scene.bodies[index];
    if body.turns {
        let outer = outer_m(view, index) * scale;
        let radii = view.radii(body).into_iter().map(|(_, r)| (r * scale).max(LEAST));
        let rings = radii.filter(|r| *r < outer - 1.0);
        BodyLook::Wheel { outer, rings: rings.collect(), open: is_open(body) }
    } else {
        let blocks = view.scene.bodies.iter().filter(|b| !b.turns);
        let most = blocks.map(|b| view.kilograms(b)).fold(0.0, f64::max);
        let share = if most > 0.0 { view.kilograms(body) / most } else { 1.0 };
        // The edge goes with the cube root of the mass.
        let edge = 25.0 * crate::num::trig::power(share.clamp(0.1, 1.0), 1.0 / 3.0);
        let (along, across) = if body.line.is_some_and(|l| l.surface) { (1.15, 0.72) } else { (0.86, 1.0) };
        BodyLook::Block { along: edge * along, across: edge * across }
    }
}

/// Works out where everything stands.
pub fn layout(view: &SceneView) -> SceneLayout {
    let scene = view.scene;
    let bodies = scene.bodies.iter().enumerate();
    let round = bodies.filter(|(_, b)| b.turns && b.planar.is_none() && b.particles.is_empty());
    let largest = round.map(|(b, _)| outer_m(view, b)).fold(0.0, f64::max);
    let target = match scene.bodies.len() {
        1 => 80.0,
        2 => 66.0,
        _ => 60.0,
    };
    let scale = if largest > 0.0 { target / largest } else { 100.0 };
    let mut builder = Builder {
        view: *view,
        scale,
        bodies: vec![None; scene.bodies.len()],
        grounds: Vec::new(),
        cords: Vec::new(),
        awaited: None,
        hanging: vec![0; scene.bodies.len()],
        limits: Vec::new(),
    };
    builder.all();
    let Builder { bodies, grounds, cords, awaited, .. } = builder;
    SceneLayout { scale, bodies, grounds, cords, awaited }
}

impl Builder<'_> {
    fn all(&mut self) {
        let scene = self.view.scene;
        let drawn = |b: usize| {
            let body = &scene.bodies[b];
            body.planar.is_none() && body.particles.is_empty()
        };
        let mut order: Vec<usize> = (0..scene.bodies.len()).filter(|b| drawn(*b)).collect();
        let at =
            |cord: &Cord, b: usize| cord.from.body == b || matches!(cord.to, Far::Body(end) if end.body == b);
        let tied = |b: usize| scene.ties.iter().any(|t| matches!(t, Tie::Cord(cord) if at(cord, b)));
        // Surfaces first, then axles, then what hangs.
        order.sort_by_key(|b| {
            let body = &scene.bodies[*b];
            let surface = body.line.is_some_and(|l| l.surface);
            (u8::from(!surface), u8::from(body.line.is_some()), u8::from(!tied(*b)))
        });
        let mut right_end: Option<f64> = None;
        for root in order {
            if self.bodies[root].is_some() {
                continue;
            }
            let (bodies, cords, grounds) = (self.bodies.clone(), self.cords.len(), self.grounds.len());
            let shared = self.root(root);
            self.stack(root);
            self.spread();
            if shared {
                continue;
            }
            // A group of its own stands to the right of what is there.
            let fresh: Vec<usize> = (0..self.bodies.len())
                .filter(|b| bodies[*b].is_none() && self.bodies[*b].is_some())
                .collect();
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            let mut see = |x: f64| {
                low = low.min(x);
                high = high.max(x);
            };
            for b in &fresh {
                if let Some(p) = &self.bodies[*b] {
                    see(p.centre.x - p.reach(Vec2::RIGHT) - 34.0);
                    see(p.centre.x + p.reach(Vec2::RIGHT) + 34.0);
                }
            }
            for run in &self.cords[cords..] {
                let end = match run.stop {
                    CordStop::Pull(_, to) | CordStop::Spring(_, to, _) | CordStop::Fixed(to, _) => to,
                    CordStop::Body => run.leaves.1,
                };
                see(end.x);
                if let Some((c, r)) = run.guide {
                    see(c.x - r);
                    see(c.x + r);
                }
            }
            let by = vec2(right_end.map_or(0.0, |x| x + 60.0 - low), 0.0);
            for b in fresh {
                if let Some(p) = &mut self.bodies[b] {
                    p.centre += by;
                }
            }
            for run in &mut self.cords[cords..] {
                shift(run, by);
            }
            for ground in &mut self.grounds[grounds..] {
                ground.origin += by;
            }
            right_end = Some(right_end.map_or(high, |_| high + by.x));
        }
        self.await_spring();
        self.ends();
        self.go_beyond();
    }

    /// The spring of the motion that follows, which its body meets where this one ends: as far off as it is drawn to go.
    fn await_spring(&mut self) {
        let scene = self.view.scene;
        let Some((next, end, stiffness)) = self.view.awaited() else { return };
        let (Some(p), Some(line)) = (&self.bodies[end.body], scene.bodies[end.body].line) else { return };
        if next.bodies[end.body].line.map(|l| l.slope) != Some(line.slope) {
            return;
        }
        let towards = if end.forward { p.forward } else { -p.forward };
        let (out, high) = if p.on.is_some() { (p.top, p.contact) } else { (Vec2::LEFT, 0.0) };
        let way = match scene.end {
            End::Travel(c, way) if c.body == end.body && c.degree == Degree::Along => self.view.of(way),
            _ => f64::INFINITY,
        };
        let free = p.centre + towards * ((way * self.scale).min(most_travel(p, towards)) + p.reach(towards));
        self.awaited = Some(Awaited { stiffness, from: free, to: free + towards * SPRING, out, high });
    }

    /// The surface on which the motion that follows meets its spring, where that is another one: from the end of the first one on.
    fn go_beyond(&mut self) {
        let Some((next, end, stiffness)) = self.view.awaited() else { return };
        let (Some(p), Some(line)) = (&self.bodies[end.body], next.bodies[end.body].line) else { return };
        let Some(g) = p.on.map(|g| &self.grounds[g]).filter(|g| g.slope != line.slope) else { return };
        let (up, out) = Self::directions(self.view.degrees(line.slope), g.up.x < 0.0);
        let up = if line.forward_up == end.forward { up } else { -up };
        let onward = if up.dot(&g.up) < 0.0 { g.from } else { g.to };
        let origin = g.origin + g.up * onward;
        let free = p.reach(g.up) + 70.0;
        let at = |far: f64| origin + up * far + out * p.contact;
        let (from, to, high, slope) = (at(free), at(free + SPRING), p.contact, line.slope);
        self.awaited = Some(Awaited { stiffness, from, to, out, high });
        let to = free + SPRING;
        self.grounds.push(Ground { slope, origin, up, out, from: 0.0, to, drop: false, rail: false });
    }

    /// Distance of a body's centre from its surface.
    fn contact(&self, body: usize, look: &BodyLook) -> f64 {
        let radius = self.view.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { body: b, radius_m, .. } | Tie::Slip { body: b, radius_m, .. } if *b == body => {
                Some(self.view.of(*radius_m) * self.scale)
            }
            _ => None,
        });
        match look {
            BodyLook::Wheel { outer, .. } => radius.unwrap_or(*outer).max(LEAST),
            BodyLook::Block { across, .. } => *across,
        }
    }

    fn directions(slope: f64, mirrored: bool) -> (Vec2, Vec2) {
        let up = Vec2::at_degrees(slope);
        if mirrored { (vec2(-up.x, up.y), vec2(up.y, up.x)) } else { (up, up.left()) }
    }

    /// The surface of this slope, made at the origin if there is none.
    fn ground(&mut self, slope: Slope, mirrored: bool) -> usize {
        if let Some(i) = self.grounds.iter().position(|g| g.slope == slope) {
            return i;
        }
        let (up, out) = Self::directions(self.view.degrees(slope), mirrored);
        let origin = Vec2::ZERO;
        self.grounds.push(Ground { slope, origin, up, out, from: 0.0, to: 0.0, drop: false, rail: false });
        self.limits.push(None);
        self.grounds.len() - 1
    }

    /// A body with its directions, still at the origin.
    fn loose(&mut self, body: usize) -> Placed {
        let look = look(&self.view, body, self.scale);
        let line = self.view.scene.bodies[body].line;
        let contact = self.contact(body, &look);
        let (centre, forward, top) = (Vec2::ZERO, Vec2::RIGHT, Vec2::UP);
        let mut placed = Placed { centre, forward, top, clockwise: true, look, contact: 0.0, on: None };
        match line {
            None => {}
            Some(Line { surface: true, slope, forward_up }) => {
                let ground = self.ground(slope, self.view.scene.is_turned_round(body));
                let g = &self.grounds[ground];
                placed.forward = if forward_up { g.up } else { -g.up };
                (placed.top, placed.contact, placed.on) = (g.out, contact, Some(ground));
            }
            Some(Line { slope, forward_up, .. }) => {
                let (up, _) = Self::directions(self.view.degrees(slope), false);
                placed.forward = if forward_up { up } else { -up };
                placed.top = placed.forward.left();
            }
        }
        placed.clockwise = placed.forward.perp(&placed.top) > 0.0;
        placed
    }

    /// Places the first body of a group. True if it stands on a surface that is already there.
    fn root(&mut self, body: usize) -> bool {
        let before = self.grounds.len();
        let mut placed = self.loose(body);
        let mut shared = false;
        if let Some(ground) = placed.on {
            let mut s = 0.0;
            if ground < before {
                // Beside those that stand there: farther down.
                shared = true;
                let g = &self.grounds[ground];
                let least = self.bodies.iter().flatten().filter(|p| p.on == Some(ground));
                let least =
                    least.map(|p| (p.centre - g.origin).dot(&g.up) - p.reach(g.up)).fold(0.0, f64::min);
                s = least - placed.reach(g.up) - 70.0;
            }
            let g = &self.grounds[ground];
            placed.centre = g.origin + g.up * s + g.out * placed.contact;
        }
        self.bodies[body] = Some(placed);
        shared
    }

    /// A body that rests on wheels, with all of them side by side below it, where the first of these stands.
    fn stack(&mut self, first: usize) {
        let scene = self.view.scene;
        let resting = |t: &Tie| match t {
            Tie::Cord(Cord { from, to: Far::Body(to), made: Made::Rests, .. }) => {
                Some((from.body, to.body, to.attach))
            }
            _ => None,
        };
        let pairs: Vec<_> = scene.ties.iter().filter_map(resting).collect();
        let Some((load, ..)) = pairs.iter().find(|(load, wheel, _)| [*load, *wheel].contains(&first)) else {
            return;
        };
        let wheels: Vec<_> = pairs.iter().filter(|(other, ..)| other == load).collect();
        let mut placed = |b: usize| self.bodies[b].clone().unwrap_or_else(|| self.loose(b));
        let (mut above, stand) = (placed(*load), placed(first).centre);
        let mut below: Vec<Placed> = wheels.iter().map(|(_, wheel, _)| placed(*wheel)).collect();
        let Some(g) = above.on.map(|g| self.grounds[g].clone()) else { return };
        let outer = below.iter().map(|p| p.reach(g.up)).fold(0.0, f64::max);
        let (apart, middle) = (2.0 * outer + 64.0, (below.len() - 1) as f64 / 2.0);
        let base = g.origin + g.up * (stand - g.origin).dot(&g.up);
        let on_axles = wheels.iter().all(|(_, _, attach)| *attach == Attach::Centre);
        let across = if on_axles { 0.4 * outer } else { 7.0 };
        let mut high: f64 = 0.0;
        for (i, (p, (_, _, attach))) in below.iter_mut().zip(&wheels).enumerate() {
            let axle = if p.on.is_some() { p.contact } else { outer + 24.0 };
            p.centre = base + g.up * (apart * (i as f64 - middle)) + g.out * axle;
            high = high.max(match attach {
                Attach::Centre => axle + across,
                Attach::Wound(radius, _) => axle + self.radius(*radius) + across,
            });
        }
        above.look = BodyLook::Block { along: apart * middle + outer + 22.0, across };
        (above.centre, above.contact) = (base + g.out * high, high);
        self.bodies[*load] = Some(above);
        for ((_, wheel, _), p) in wheels.into_iter().zip(below) {
            self.bodies[*wheel] = Some(p);
        }
    }

    /// Follows the cords of what is placed until nothing is left.
    fn spread(&mut self) {
        let scene = self.view.scene;
        let placed = |builder: &Self, end: CordEnd| builder.bodies[end.body].is_some();
        let mut again = true;
        while again {
            again = false;
            for (i, tie) in scene.ties.iter().enumerate() {
                let Tie::Cord(cord) = tie else { continue };
                if cord.made == Made::Rests || self.cords.iter().any(|r| r.tie == i) {
                    continue;
                }
                let run = match cord.to {
                    Far::Body(to) if placed(self, cord.from) => self.join(i, cord.from, to),
                    Far::Body(to) if placed(self, to) => self.join(i, to, cord.from),
                    Far::Pull(_) | Far::Spring { .. } | Far::Fixed if placed(self, cord.from) => {
                        self.ending(i, cord)
                    }
                    _ => continue,
                };
                self.cords.push(run);
                again = true;
            }
        }
    }

    /// Direction in which a cord to another end leaves a placed body; `None` where it is not told (a fixed axle beside a slope).
    fn leaves(&self, placed: &Placed, end: CordEnd, other: Option<&CordEnd>) -> Option<Vec2> {
        let scene = self.view.scene;
        let (axis, positive) = match scene.bodies[end.body].line {
            Some(_) => (placed.forward, end.forward),
            None => match scene.aim(&end, other)? {
                Aim::Upright(up) => (Vec2::UP, up),
                Aim::Level(right) if !scene.is_any_turned_round() => (Vec2::RIGHT, right),
                _ => return None,
            },
        };
        Some(if positive { axis } else { -axis })
    }

    /// Where a cord leaves a body in a direction.
    fn attach(&self, placed: &Placed, end: CordEnd, towards: Vec2) -> (Vec2, Vec2) {
        match end.attach {
            Attach::Centre => (placed.centre, placed.centre),
            Attach::Wound(radius, side) => {
                let out = placed.winds(side, end.forward, towards);
                (placed.centre + out * self.radius(radius), out)
            }
        }
    }

    fn radius(&self, radius: Num) -> f64 {
        (self.view.of(radius) * self.scale).max(LEAST)
    }

    /// Where the visible part of a cord begins: a block hides what is within it.
    fn visible(placed: &Placed, end: CordEnd, at: Vec2, towards: Vec2) -> Vec2 {
        match (&placed.look, end.attach) {
            (BodyLook::Block { .. }, Attach::Centre) => at + towards * placed.reach(towards),
            _ => at,
        }
    }

    /// The turns of a cord that are wound on a body, as an arc behind where it leaves.
    fn wound(&self, placed: &Placed, end: CordEnd, towards: Vec2) -> Option<CordPiece> {
        let Attach::Wound(radius, side) = end.attach else { return None };
        let out = placed.winds(side, end.forward, towards);
        let start = out.angle_of();
        // Back from where it leaves, away from the straight part.
        let sense = if out.perp(&towards) > 0.0 { -1.0 } else { 1.0 };
        Some(CordPiece::Round(placed.centre, self.radius(radius), start, start + sense * PI * 0.75))
    }

    /// A cord that ends at no body.
    fn ending(&mut self, tie: usize, cord: &Cord) -> CordRun {
        let end = cord.from;
        let placed = self.bodies[end.body].clone().expect("a placed body");
        let ahead = if end.forward { placed.forward } else { -placed.forward };
        let towards = self.leaves(&placed, end, None).unwrap_or(ahead);
        let towards = end.tilt_deg.map_or(towards, |tilt| {
            let tilt = self.view.of(tilt);
            placed.direction(if end.forward { tilt } else { 180.0 - tilt })
        });
        let (mut at, _) = self.attach(&placed, end, towards);
        if let (BodyLook::Block { .. }, Attach::Centre) = (&placed.look, end.attach) {
            // Beside what leaves the block there already.
            let same = |r: &&CordRun| r.at.iter().any(|(b, to)| *b == end.body && to.dot(&towards) > 0.999);
            let beside = self.cords.iter().filter(same).count();
            at += vec2(towards.y, -towards.x) * (BESIDE * beside as f64);
        }
        let mut pieces: Vec<CordPiece> = self.wound(&placed, end, towards).into_iter().collect();
        let from = Self::visible(&placed, end, at, towards);
        // What leaves a rim aslant is clear of it at once, and shall not reach what hangs beside.
        let own =
            if end.tilt_deg.is_some() && end.attach != Attach::Centre { 0.0 } else { placed.reach(towards) };
        let clear = own
            + match cord.to {
                Far::Pull(_) => 26.0,
                Far::Spring { .. } => 40.0,
                _ => 66.0,
            };
        let to = at + towards * clear;
        pieces.push(CordPiece::Straight(from, to));
        let stop = match cord.to {
            Far::Pull(_) => CordStop::Pull(to, to + towards * PULL),
            Far::Spring { stretch_m, .. } => {
                // The stretch is to scale where it fits; it always shows.
                let stretch = (self.view.of(stretch_m) * self.scale).clamp(-0.4 * SPRING, 130.0);
                let (to, by) = (to, SPRING + stretch);
                CordStop::Spring(to, to + towards * by, to + towards * stretch)
            }
            Far::Fixed | Far::Body(_) => CordStop::Fixed(to, towards),
        };
        CordRun { tie, pieces, stop, guide: None, leaves: (at, towards), at: vec![(end.body, towards)] }
    }

    /// A cord from a placed body to another one, which is placed if it is not yet.
    fn join(&mut self, tie: usize, near: CordEnd, far: CordEnd) -> CordRun {
        if let Some(Tie::Cord(Cord { made: made @ (Made::Teeth | Made::Belt), .. })) =
            self.view.scene.ties.get(tie)
        {
            return self.mesh((tie, *made), near, far);
        }
        let from = self.bodies[near.body].clone().expect("a placed body");
        let known = self.bodies[far.body].clone();
        let grounds = self.grounds.len();
        let placed = known.is_some();
        let leaves = self.leaves(&from, near, Some(&far));
        let to = known.unwrap_or_else(|| self.loose(far.body));
        let arrives = self.leaves(&to, far, Some(&near));
        let away = match (leaves, arrives) {
            (Some(e), _) => e,
            (None, Some(e)) => -e,
            (None, None) if placed => (to.centre - from.centre).unit(),
            // From axle to axle: to the left and a little down, clear of what hangs.
            (None, None) => vec2(-1.0, -0.25).unit(),
        };
        let back = arrives.unwrap_or_else(|| -away);
        let (at, _) = self.attach(&from, near, away);
        let mut pieces: Vec<CordPiece> = self.wound(&from, near, away).into_iter().collect();
        let start = Self::visible(&from, near, at, away);
        let mut joint = BodyPair { near, far, from, to, placed, grounds, away, back, at, start };
        let guide = if away.dot(&back) < -0.999 {
            self.straight(&mut joint, &mut pieces);
            None
        } else {
            Some(self.guided(&mut joint, &mut pieces))
        };
        pieces.extend(self.wound(&joint.to, far, back));
        self.bodies[far.body] = Some(joint.to);
        let ends = vec![(near.body, away), (far.body, back)];
        CordRun { tie, pieces, stop: CordStop::Body, guide, leaves: (at, away), at: ends }
    }

    /// Two wheels that turn each other: gears touch, a belt runs around both along their outer tangents.
    fn mesh(&mut self, (tie, made): (usize, Made), near: CordEnd, far: CordEnd) -> CordRun {
        let from = self.bodies[near.body].clone().expect("a placed body");
        let known = self.bodies[far.body].clone();
        let mut to = known.clone().unwrap_or_else(|| self.loose(far.body));
        let radius = |end: CordEnd| match end.attach {
            Attach::Wound(radius, _) => self.radius(radius),
            Attach::Centre => 0.0,
        };
        let (own, other) = (radius(near), radius(far));
        if known.is_none() {
            // On the side where no wheel is yet.
            let taken = self.bodies.iter().flatten().any(|p| p.centre.x < from.centre.x - 1.0);
            let apart = if made == Made::Belt {
                from.reach(Vec2::RIGHT) + to.reach(Vec2::RIGHT) + 60.0
            } else {
                own + other
            };
            to.centre = from.centre + (if taken { Vec2::RIGHT } else { Vec2::LEFT }) * apart;
        }
        let line = to.centre - from.centre;
        let (along, share) = (line.unit(), ((own - other) / line.norm()).clamp(-1.0, 1.0));
        let tangent = |side: f64| {
            let out = along * share + along.left() * (side * (1.0 - share * share).sqrt());
            CordPiece::Straight(from.centre + out * own, to.centre + out * other)
        };
        let pieces = if made == Made::Belt { vec![tangent(1.0), tangent(-1.0)] } else { Vec::new() };
        let leaves = (from.centre + along * own, along.left());
        self.bodies[far.body] = Some(to);
        let at = vec![(near.body, along), (far.body, -along)];
        CordRun { tie, pieces, stop: CordStop::Body, guide: None, leaves, at }
    }

    /// Moves the second body to where the cord meets it at this point; a surface that came with it comes along.
    fn meet(&mut self, joint: &mut BodyPair, target: Vec2) {
        let (own, _) = self.attach(&joint.to, joint.far, joint.back);
        joint.to.centre = target - (own - joint.to.centre);
        if let Some(ground) = joint.to.on.filter(|g| *g >= joint.grounds) {
            let g = &mut self.grounds[ground];
            g.origin = joint.to.centre - g.out * joint.to.contact;
        }
    }

    /// The point at which the cord is seen to meet the second body.
    fn met(&self, joint: &BodyPair) -> Vec2 {
        let (own, _) = self.attach(&joint.to, joint.far, joint.back);
        Self::visible(&joint.to, joint.far, own, joint.back)
    }

    /// A cord whose ends point at each other.
    fn straight(&mut self, joint: &mut BodyPair, pieces: &mut Vec<CordPiece>) {
        if !joint.placed {
            self.place_along(joint);
        }
        let BodyPair { from, to, away, start, .. } = &*joint;
        let seen = self.met(joint);
        // Parallel to the line that both share: where the block is too low, a post holds the cord.
        let high = (*start - seen).dot(&(away.left()));
        let end = if let (Some(_), BodyLook::Block { across, .. }) = (to.on, &to.look)
            && to.on == from.on
            && high.abs() > across + 2.0
        {
            let top = to.centre + away.left() * high;
            let foot = to.centre + away.left() * (across * high.signum());
            pieces.push(CordPiece::Post(foot, top));
            top
        } else {
            seen
        };
        pieces.push(CordPiece::Straight(*start, end));
    }

    /// Places the second body of a straight cord.
    fn place_along(&mut self, joint: &mut BodyPair) {
        let BodyPair { from, to, away, .. } = &*joint;
        let hangs = away.y < -0.7 && from.on.is_none();
        let far_axle = self.view.scene.bodies[joint.far.body].line.is_none();
        // Clear of what is pulled aslant above it.
        let aslant = |tie: &Tie| matches!(tie, Tie::Cord(c) if c.from.body == joint.near.body && c.from.tilt_deg.is_some());
        let lower = if self.view.scene.ties.iter().any(aslant) { PULL } else { 0.0 };
        let free = match (hangs, far_axle) {
            (true, _) => 40.0 + lower + self.hanging[joint.near.body] as f64 * 30.0,
            (false, true) => 74.0,
            (false, false) => 58.0,
        };
        let target = joint.at + *away * (from.reach(*away) + to.reach(*away) + free);
        self.meet(joint, target);
        let BodyPair { near, far, from, to, away, grounds, .. } = joint;
        if let Some(g) = to.on.filter(|g| *g < *grounds).map(|g| &self.grounds[g]) {
            // On the same surface: a block is as high as the cord wants.
            let s = (to.centre - g.origin).dot(&g.up);
            let high = (target - g.origin).dot(&g.out);
            if let (BodyLook::Block { along, across }, Attach::Centre) = (&mut to.look, far.attach)
                && (12.0..50.0).contains(&high)
            {
                *across = high;
                *along = along.max(high * 1.15);
                to.contact = high;
            }
            to.centre = g.origin + g.up * s + g.out * to.contact;
        }
        if hangs {
            self.hanging[near.body] += 1;
        }
        // An axle at the end of a surface: the surface stops before it.
        if let Some(ground) = from.on.filter(|_| far_axle) {
            let g = &self.grounds[ground];
            if away.dot(&g.up) > 0.0 {
                self.limits[ground] = Some((to.centre - g.origin).dot(&g.up) - to.reach(g.up) - 7.0);
            }
        }
    }

    /// A cord over a guide pulley, which is told: it turns the short way.
    fn guided(&mut self, joint: &mut BodyPair, pieces: &mut Vec<CordPiece>) -> (Vec2, f64) {
        let BodyPair { from, to, away, back, at, start, .. } = &*joint;
        let (away, back) = (*away, *back);
        let travel = -back;
        // Where it turns right round, to the side on which the cord leaves.
        let (turn, beside) = (away.perp(&travel), (*at - from.centre).perp(&away));
        let clockwise = if turn.abs() < 1e-9 { beside > -1e-9 } else { turn < 0.0 };
        let inward = |d: Vec2| if clockwise { d.right() } else { d.left() };
        let both_hang = away.dot(&back) > 0.9;
        let half = |p: &Placed| p.reach(away.right());
        let radius = if both_hang { ((half(from) + half(to)) / 2.0 + 12.0).max(GUIDE) } else { GUIDE };
        let first = *at + away * (from.reach(away) + radius + if both_hang { 70.0 } else { 52.0 });
        let centre = first + inward(away) * radius;
        let second = centre - inward(travel) * radius;
        let (a, mut b) = ((first - centre).angle_of(), (second - centre).angle_of());
        while clockwise && b > a {
            b -= 2.0 * PI;
        }
        while !clockwise && b < a {
            b += 2.0 * PI;
        }
        pieces.push(CordPiece::Straight(*start, first));
        pieces.push(CordPiece::Round(centre, radius, a, b));
        if !joint.placed {
            let drop = to.reach(travel) + radius + if both_hang { 96.0 } else { 50.0 };
            self.meet(joint, second + travel * drop);
            // Surfaces end before the pulley.
            let fresh = joint.to.on.filter(|g| *g >= joint.grounds && back.dot(&self.grounds[*g].up) > 0.0);
            let below = joint.from.on.filter(|g| away.dot(&(self.grounds[*g].up)) > 0.0);
            for ground in [fresh, below].into_iter().flatten() {
                let g = &self.grounds[ground];
                self.limits[ground] = Some((centre - g.origin).dot(&g.up) - radius - 5.0);
            }
        }
        pieces.push(CordPiece::Straight(second, self.met(joint)));
        (centre, radius)
    }

    /// How far each surface goes.
    fn ends(&mut self) {
        for i in 0..self.grounds.len() {
            let g = self.grounds[i].clone();
            let at = |p: Vec2| (p - g.origin).dot(&g.up);
            let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
            let mut rail = false;
            for p in self.bodies.iter().flatten().filter(|p| p.on == Some(i)) {
                let reach = p.reach(g.up);
                from = from.min(at(p.centre) - reach);
                to = to.max(at(p.centre) + reach);
                rail |= p.on_rail();
            }
            let (mut low, mut high) = (from - 34.0, to + 34.0);
            for run in &self.cords {
                let Some(Tie::Cord(cord)) = self.view.scene.ties.get(run.tie) else { continue };
                let stands = self.bodies[cord.from.body].as_ref().is_some_and(|p| p.on == Some(i));
                if !stands {
                    continue;
                }
                let end = match run.stop {
                    CordStop::Pull(a, b) => at(a.middle(b)),
                    CordStop::Spring(_, b, _) | CordStop::Fixed(b, _) => at(b),
                    CordStop::Body => continue,
                };
                (low, high) = (low.min(end), high.max(end));
            }
            if let Some(spring) = self.awaited.filter(|s| s.high > 0.0) {
                from = from.min(at(spring.to));
                (low, high) = (low.min(at(spring.to)), high.max(at(spring.to)));
            }
            // Room for the angle at the foot.
            if self.view.degrees(g.slope) > 0.0 {
                let steep = if rail { 96.0 } else { 84.0 };
                low = low.min(from - steep);
            }
            let ground = &mut self.grounds[i];
            (ground.from, ground.to, ground.rail) = (low, high, rail);
            if let Some(limit) = self.limits[i] {
                // What hangs at the end hangs free.
                let free = |p: &Placed| {
                    let side = g.up.x.signum();
                    (p.centre.x - side * (p.reach(Vec2::RIGHT) + 12.0) - g.origin.x) / g.up.x
                };
                let hanging = self.bodies.iter().flatten().filter(|p| {
                    p.on.is_none() && at(p.centre) > to && p.centre.y < g.origin.y + g.up.y * limit
                });
                let limit = if g.up.x.abs() > 0.1 { hanging.map(free).fold(limit, f64::min) } else { limit };
                let stands = self.bodies.iter().flatten().filter(|p| p.on == Some(i));
                let least = stands.map(|p| at(p.centre) + 14.0).fold(f64::NEG_INFINITY, f64::max);
                ground.to = limit.max(least);
                ground.drop = true;
            }
        }
    }
}

fn shift(run: &mut CordRun, by: Vec2) {
    for piece in &mut run.pieces {
        match piece {
            CordPiece::Straight(a, b) | CordPiece::Post(a, b) => {
                *a += by;
                *b += by;
            }
            CordPiece::Round(c, ..) => *c += by,
        }
    }
    let (stop, guide) = (&mut run.stop, &mut run.guide);
    let ends: Vec<&mut Vec2> = match stop {
        CordStop::Pull(a, b) => vec![a, b],
        CordStop::Spring(a, b, c) => vec![a, b, c],
        CordStop::Fixed(a, _) => vec![a],
        CordStop::Body => Vec::new(),
    };
    let guide = guide.iter_mut().map(|(centre, _)| centre);
    ends.into_iter().chain(guide).chain([&mut run.leaves.0]).for_each(|p| *p += by);
}
