//! Where everything of a scene stands on the board: surfaces, bodies, cords, pulleys, to scale. Worked out from the ties.
//!
//! A body on a surface fixes its surface; cords lead from a placed body to the next one, straight where both ends point at
//! each other, else over a guide pulley. What hangs together is one group; groups stand side by side. Radii are to scale,
//! lengths of cords are as long as the picture needs.
use crate::figure::vector::V;
use crate::figure::vector::add;
use crate::figure::vector::along;
use crate::figure::vector::angle;
use crate::figure::vector::cross;
use crate::figure::vector::dot;
use crate::figure::vector::left;
use crate::figure::vector::mul;
use crate::figure::vector::polar_degrees;
use crate::figure::vector::right;
use crate::figure::vector::sub;
use crate::figure::view::View;
use crate::scene::Attach;
use crate::scene::Cord;
use crate::scene::CordEnd;
use crate::scene::Far;
use crate::scene::Line;
use crate::scene::Num;
use crate::scene::RotaryInertia;
use crate::scene::Side;
use crate::scene::Slope;
use crate::scene::Tie;
use std::f64::consts::PI;

/// Radius of a guide pulley.
pub const GUIDE: f64 = 13.0;
/// Least radius that is drawn.
const LEAST: f64 = 3.0;
/// Length of a pull's arrow.
pub const PULL: f64 = 58.0;
/// Length of a spring without stretch.
const SPRING: f64 = 62.0;

/// What a body looks like.
#[derive(Debug, Clone, PartialEq)]
pub enum Look {
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
    Block {
        /// Along.
        along: f64,
        /// Across.
        across: f64,
    },
}

/// A body on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Its mass centre.
    pub centre: V,
    /// Its forward direction.
    pub forward: V,
    /// Its top side: away from the surface.
    pub top: V,
    /// Is a positive turn clockwise?
    pub clockwise: bool,
    /// What it looks like.
    pub look: Look,
    /// Distance of the centre from the surface.
    pub contact: f64,
    /// Its surface.
    pub on: Option<usize>,
}

impl Placed {
    /// How far it reaches in a direction.
    pub fn reach(&self, towards: V) -> f64 {
        match &self.look {
            Look::Wheel { outer, .. } => *outer,
            Look::Block { along, across } => {
                along * dot(self.forward, towards).abs() + across * dot(self.top, towards).abs()
            }
        }
    }
    /// Direction from the centre to where a wound cord leaves it in a direction.
    pub fn winds(&self, side: Side, forward: bool, towards: V) -> V {
        let pays_out = (side == Side::Top) == forward;
        let out = if self.clockwise == pays_out { left(towards) } else { right(towards) };
        (out.0, out.1)
    }
    /// Does it roll or slip on a radius within its outline, so that its surface is a rail?
    pub fn on_rail(&self) -> bool {
        self.on.is_some() && matches!(&self.look, Look::Wheel { outer, .. } if self.contact < outer - 1.0)
    }
}

/// A surface on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// As the scene has it.
    pub slope: Slope,
    /// A point of it.
    pub origin: V,
    /// Up the slope (on a level: forward).
    pub up: V,
    /// Out of the surface.
    pub out: V,
    /// Its ends, counted from the origin along `up`.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// Does it end at `to` with a drop, so that something can hang there?
    pub drop: bool,
    /// Is it a narrow rail?
    pub rail: bool,
}

/// A piece of a cord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// Straight.
    Straight(V, V),
    /// Round a body or pulley: centre, radius, angles.
    Round(V, f64, f64, f64),
    /// A post on a block that is lower than the cord.
    Post(V, V),
}

/// What a cord ends at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stop {
    /// A pull: from, to.
    Pull(V, V),
    /// A spring: from, to; the wall stands at its end. The third is where the cord would end without stretch.
    Spring(V, V, V),
    /// A fixed point, with the direction in which the cord arrives.
    Fixed(V, V),
    /// Another body.
    Body,
}

/// A cord on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Index of its tie.
    pub tie: usize,
    /// Its pieces.
    pub pieces: Vec<Piece>,
    /// What it ends at.
    pub stop: Stop,
    /// Guide pulley: centre, radius.
    pub guide: Option<(V, f64)>,
    /// Where and in which direction it leaves the body from which it was drawn.
    pub leaves: (V, V),
    /// Each body that it is at, with the direction in which it leaves it.
    pub at: Vec<(usize, V)>,
}

/// A scene on the board.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Pixels per metre.
    pub scale: f64,
    /// Bodies that move along lines or turn about fixed axles; `None` for the others.
    pub bodies: Vec<Option<Placed>>,
    /// Surfaces.
    pub grounds: Vec<Ground>,
    /// Cords.
    pub cords: Vec<Run>,
}

struct Builder<'a> {
    view: View<'a>,
    scale: f64,
    bodies: Vec<Option<Placed>>,
    grounds: Vec<Ground>,
    cords: Vec<Run>,
    /// Cords that hang from each body, so that they hang at different heights.
    hanging: Vec<usize>,
    /// Limits of surfaces at their upper ends.
    limits: Vec<Option<f64>>,
}

/// Outermost radius of a body that turns, m: the largest that is given, or as for a disc where the given ones lie within
/// its radius of gyration.
pub fn outer_m(view: &View, body: usize) -> f64 {
    let body = &view.scene.bodies[body];
    let given = view.radii(body).first().map_or(0.0, |(_, r)| *r);
    let gyration = match &body.inertia {
        Some(RotaryInertia::Gyration(k)) => view.of(*k),
        _ => 0.0,
    };
    let outer = if gyration >= given { gyration * 1.35 } else { given };
    if outer.is_finite() && outer > 0.0 { outer } else { 1.0 }
}

/// What a body looks like at a scale.
pub fn look(view: &View, index: usize, scale: f64) -> Look {
    let body = &view.scene.bodies[index];
    if body.turns {
        let outer = outer_m(view, index) * scale;
        let radii = view.radii(body).into_iter().map(|(_, r)| (r * scale).max(LEAST));
        let rings = radii.filter(|r| *r < outer - 1.0);
        let open = matches!(
            &body.inertia,
            Some(RotaryInertia::Shape(crate::scene::Shape::Hoop | crate::scene::Shape::Shell, _))
        );
        Look::Wheel { outer, rings: rings.collect(), open }
    } else {
        let blocks = view.scene.bodies.iter().filter(|b| !b.turns);
        let most = blocks.map(|b| view.kilograms(b)).fold(0.0, f64::max);
        let share = if most > 0.0 { view.kilograms(body) / most } else { 1.0 };
        // The edge goes with the cube root of the mass.
        let edge = 25.0 * crate::num::trig::power(share.clamp(0.1, 1.0), 1.0 / 3.0);
        let across = if body.line.is_some_and(|l| l.surface) { 0.72 } else { 1.0 };
        let along = if body.line.is_some_and(|l| l.surface) { 1.15 } else { 0.86 };
        Look::Block { along: edge * along, across: edge * across }
    }
}

/// Works out where everything stands.
pub fn layout(view: &View) -> Layout {
    let scene = view.scene;
    let round: Vec<usize> = (0..scene.bodies.len())
        .filter(|b| {
            scene.bodies[*b].turns && scene.bodies[*b].pin.is_none() && scene.bodies[*b].particles.is_empty()
        })
        .collect();
    let largest = round.iter().map(|b| outer_m(view, *b)).fold(0.0, f64::max);
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
        hanging: vec![0; scene.bodies.len()],
        limits: Vec::new(),
    };
    builder.all();
    Layout { scale, bodies: builder.bodies, grounds: builder.grounds, cords: builder.cords }
}

impl Builder<'_> {
    fn all(&mut self) {
        let scene = self.view.scene;
        let drawn = |b: usize| {
            let body = &scene.bodies[b];
            body.pin.is_none() && body.particles.is_empty()
        };
        let mut order: Vec<usize> = (0..scene.bodies.len()).filter(|b| drawn(*b)).collect();
        let tied = |b: usize| self.cords_of(b).next().is_some();
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
                    see(p.centre.0 - p.reach((1.0, 0.0)) - 34.0);
                    see(p.centre.0 + p.reach((1.0, 0.0)) + 34.0);
                }
            }
            for run in &self.cords[cords..] {
                let end = match run.stop {
                    Stop::Pull(_, to) | Stop::Spring(_, to, _) | Stop::Fixed(to, _) => to,
                    Stop::Body => run.leaves.1,
                };
                see(end.0);
                if let Some((c, r)) = run.guide {
                    see(c.0 - r);
                    see(c.0 + r);
                }
            }
            let by = right_end.map_or(0.0, |x| x + 60.0 - low);
            let by = (by, 0.0);
            for b in fresh {
                if let Some(p) = &mut self.bodies[b] {
                    p.centre = add(p.centre, by);
                }
            }
            for run in &mut self.cords[cords..] {
                shift(run, by);
            }
            for ground in &mut self.grounds[grounds..] {
                ground.origin = add(ground.origin, by);
            }
            right_end = Some(right_end.map_or(high, |_| high + by.0));
        }
        self.ends();
    }

    /// Cords at a body: index of the tie, the end at the body, is it the first end?
    fn cords_of(&self, body: usize) -> impl Iterator<Item = (usize, &Cord, CordEnd, bool)> {
        self.view.scene.ties.iter().enumerate().flat_map(move |(i, tie)| {
            let Tie::Cord(cord) = tie else { return Vec::new() };
            let mut ends = Vec::new();
            if cord.from.body == body {
                ends.push((i, cord, cord.from, true));
            }
            if let Far::Body(end) = cord.to
                && end.body == body
            {
                ends.push((i, cord, end, false));
            }
            ends
        })
    }

    /// Distance of a body's centre from its surface.
    fn contact(&self, body: usize, look: &Look) -> f64 {
        let radius = self.view.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { body: b, radius_m, .. } | Tie::Slip { body: b, radius_m, .. } if *b == body => {
                Some(self.view.of(*radius_m) * self.scale)
            }
            _ => None,
        });
        match look {
            Look::Wheel { outer, .. } => radius.unwrap_or(*outer).max(LEAST),
            Look::Block { across, .. } => *across,
        }
    }

    fn directions(slope: f64, mirrored: bool) -> (V, V) {
        let (c, s) = polar_degrees(slope);
        if mirrored { ((-c, s), (s, c)) } else { ((c, s), (-s, c)) }
    }

    fn slope_degrees(&self, slope: Slope) -> f64 {
        match slope {
            Slope::Level => 0.0,
            Slope::Vertical => 90.0,
            Slope::Degrees(n) => self.view.of(n),
        }
    }

    /// The surface of this slope, made at the origin if there is none.
    fn ground(&mut self, slope: Slope, mirrored: bool) -> usize {
        if let Some(i) = self.grounds.iter().position(|g| g.slope == slope) {
            return i;
        }
        let (up, out) = Self::directions(self.slope_degrees(slope), mirrored);
        self.grounds.push(Ground {
            slope,
            origin: (0.0, 0.0),
            up,
            out,
            from: 0.0,
            to: 0.0,
            drop: false,
            rail: false,
        });
        self.limits.push(None);
        self.grounds.len() - 1
    }

    /// A body with its directions, still at the origin.
    fn loose(&mut self, body: usize, mirrored: bool) -> Placed {
        let look = look(&self.view, body, self.scale);
        let line = self.view.scene.bodies[body].line;
        let contact = self.contact(body, &look);
        let mut placed = Placed {
            centre: (0.0, 0.0),
            forward: (1.0, 0.0),
            top: (0.0, 1.0),
            clockwise: true,
            look,
            contact: 0.0,
            on: None,
        };
        match line {
            None => {}
            Some(Line { surface: true, slope, forward_up }) => {
                let ground = self.ground(slope, mirrored);
                let g = &self.grounds[ground];
                placed.forward = if forward_up { g.up } else { mul(g.up, -1.0) };
                placed.top = g.out;
                placed.contact = contact;
                placed.on = Some(ground);
            }
            Some(Line { slope, forward_up, .. }) => {
                let (up, _) = Self::directions(self.slope_degrees(slope), false);
                placed.forward = if forward_up { up } else { mul(up, -1.0) };
                placed.top = left(placed.forward);
            }
        }
        placed.clockwise = cross(placed.forward, placed.top) > 0.0;
        placed
    }

    /// Places the first body of a group. True if it stands on a surface that is already there.
    fn root(&mut self, body: usize) -> bool {
        let before = self.grounds.len();
        let mut placed = self.loose(body, false);
        let mut shared = false;
        if let Some(ground) = placed.on {
            let mut s = 0.0;
            if ground < before {
                // Beside those that stand there: farther down.
                shared = true;
                let g = &self.grounds[ground];
                let least = self.bodies.iter().flatten().filter(|p| p.on == Some(ground));
                let least =
                    least.map(|p| dot(sub(p.centre, g.origin), g.up) - p.reach(g.up)).fold(0.0, f64::min);
                s = least - placed.reach(g.up) - 70.0;
            }
            let g = &self.grounds[ground];
            placed.centre = add(along(g.origin, g.up, s), mul(g.out, placed.contact));
        }
        self.bodies[body] = Some(placed);
        shared
    }

    /// Follows the cords of what is placed until nothing is left.
    fn spread(&mut self) {
        let scene = self.view.scene;
        let mut again = true;
        while again {
            again = false;
            for (i, tie) in scene.ties.iter().enumerate() {
                let Tie::Cord(cord) = tie else { continue };
                if self.cords.iter().any(|r| r.tie == i) {
                    continue;
                }
                match cord.to {
                    Far::Body(to) => {
                        let (a, b) = (self.bodies[cord.from.body].is_some(), self.bodies[to.body].is_some());
                        if a || b {
                            let run =
                                if a { self.join(i, cord.from, to) } else { self.join(i, to, cord.from) };
                            self.cords.push(run);
                            again = true;
                        }
                    }
                    Far::Pull(_) | Far::Spring { .. } | Far::Fixed => {
                        if self.bodies[cord.from.body].is_some() {
                            let run = self.ending(i, cord);
                            self.cords.push(run);
                            again = true;
                        }
                    }
                }
            }
        }
    }

    /// Direction in which a cord leaves a placed body; `None` where the body does not say (a fixed axle).
    fn leaves(&self, placed: &Placed, end: CordEnd) -> Option<V> {
        self.view.scene.bodies[end.body].line?;
        Some(if end.forward { placed.forward } else { mul(placed.forward, -1.0) })
    }

    /// Where a cord leaves a body in a direction.
    fn attach(&self, placed: &Placed, end: CordEnd, towards: V) -> (V, V) {
        match end.attach {
            Attach::Centre => (placed.centre, placed.centre),
            Attach::Wound(radius, side) => {
                let out = placed.winds(side, end.forward, towards);
                (along(placed.centre, out, self.radius(radius)), out)
            }
        }
    }

    fn radius(&self, radius: Num) -> f64 {
        (self.view.of(radius) * self.scale).max(LEAST)
    }

    /// Where the visible part of a cord begins: a block hides what is within it.
    fn visible(placed: &Placed, end: CordEnd, at: V, towards: V) -> V {
        match (&placed.look, end.attach) {
            (Look::Block { .. }, Attach::Centre) => along(at, towards, placed.reach(towards)),
            _ => at,
        }
    }

    /// The turns of a cord that are wound on a body, as an arc behind where it leaves.
    fn wound(&self, placed: &Placed, end: CordEnd, towards: V) -> Option<Piece> {
        let Attach::Wound(radius, side) = end.attach else { return None };
        let out = placed.winds(side, end.forward, towards);
        let start = angle(out);
        // Back from where it leaves, away from the straight part.
        let sense = if cross(out, towards) > 0.0 { -1.0 } else { 1.0 };
        Some(Piece::Round(placed.centre, self.radius(radius), start, start + sense * PI * 0.75))
    }

    /// A cord that ends at no body.
    fn ending(&mut self, tie: usize, cord: &Cord) -> Run {
        let end = cord.from;
        let placed = self.bodies[end.body].clone().expect("a placed body");
        let towards = self.leaves(&placed, end).unwrap_or_else(|| match self.view.upward(&cord.name) {
            Some(true) => (0.0, 1.0),
            Some(false) => (0.0, -1.0),
            None if end.forward => placed.forward,
            None => mul(placed.forward, -1.0),
        });
        let (at, _) = self.attach(&placed, end, towards);
        let mut pieces: Vec<Piece> = self.wound(&placed, end, towards).into_iter().collect();
        let from = Self::visible(&placed, end, at, towards);
        let clear = placed.reach(towards)
            + match cord.to {
                Far::Pull(_) => 26.0,
                Far::Spring { .. } => 40.0,
                _ => 66.0,
            };
        let to = along(at, towards, clear);
        pieces.push(Piece::Straight(from, to));
        let stop = match cord.to {
            Far::Pull(_) => Stop::Pull(to, along(to, towards, PULL)),
            Far::Spring { stretch_m, .. } => {
                // The stretch is to scale where it fits; it always shows.
                let stretch = (self.view.of(stretch_m) * self.scale).clamp(0.0, 130.0);
                let (to, by) = (to, SPRING + stretch);
                Stop::Spring(to, along(to, towards, by), along(to, towards, stretch))
            }
            Far::Fixed | Far::Body(_) => Stop::Fixed(to, towards),
        };
        Run { tie, pieces, stop, guide: None, leaves: (at, towards), at: vec![(end.body, towards)] }
    }

    /// A cord from a placed body to another one, which is placed if it is not yet.
    fn join(&mut self, tie: usize, near: CordEnd, far: CordEnd) -> Run {
        let from = self.bodies[near.body].clone().expect("a placed body");
        let known = self.bodies[far.body].clone();
        let grounds = self.grounds.len();
        let mirrored = from.on.is_some();
        let mut to = match &known {
            Some(p) => p.clone(),
            None => self.loose(far.body, mirrored),
        };
        let leaves = self.leaves(&from, near);
        let arrives = self.leaves(&to, far);
        let away = match (leaves, arrives) {
            (Some(e), _) => e,
            (None, Some(e)) => mul(e, -1.0),
            (None, None) => match &known {
                Some(p) => crate::figure::vector::unit(sub(p.centre, from.centre)),
                // From axle to axle: to the left and a little down, clear of what hangs.
                None => crate::figure::vector::unit((-1.0, -0.25)),
            },
        };
        let back = arrives.unwrap_or_else(|| mul(away, -1.0));
        let (at, _) = self.attach(&from, near, away);
        let straight = dot(away, back) < -0.999;
        let mut pieces: Vec<Piece> = self.wound(&from, near, away).into_iter().collect();
        let start = Self::visible(&from, near, at, away);
        let mut guide = None;
        let end;
        if straight {
            if known.is_none() {
                let hangs = away.1 < -0.7 && from.on.is_none();
                let stagger = if hangs { self.hanging[near.body] as f64 * 30.0 } else { 0.0 };
                let far_axle = self.view.scene.bodies[far.body].line.is_none();
                let long = from.reach(away)
                    + to.reach(away)
                    + if hangs {
                        40.0 + stagger
                    } else if far_axle {
                        74.0
                    } else {
                        58.0
                    };
                let target = along(at, away, long);
                // Where the cord meets a body standing at the origin.
                let (own, _) = self.attach(&to, far, back);
                to.centre = sub(target, sub(own, to.centre));
                if let Some(ground) = to.on {
                    let g = &mut self.grounds[ground];
                    if ground >= grounds {
                        g.origin = sub(to.centre, mul(g.out, to.contact));
                    } else {
                        // On the same surface: a block is as high as the cord wants.
                        let s = dot(sub(to.centre, g.origin), g.up);
                        let high = dot(sub(target, g.origin), g.out);
                        if let (Look::Block { along, across }, Attach::Centre) = (&mut to.look, far.attach)
                            && (12.0..50.0).contains(&high)
                        {
                            *across = high;
                            *along = along.max(high * 1.15);
                            to.contact = high;
                        }
                        to.centre =
                            add(crate::figure::vector::along(g.origin, g.up, s), mul(g.out, to.contact));
                    }
                }
                if hangs {
                    self.hanging[near.body] += 1;
                }
                // An axle at the end of a surface: the surface stops before it.
                if let (Some(ground), true) = (from.on, far_axle) {
                    let g = &self.grounds[ground];
                    let s = dot(sub(to.centre, g.origin), g.up);
                    let toward_up = dot(away, g.up) > 0.0;
                    if toward_up {
                        self.limits[ground] = Some(s - to.reach(g.up) - 7.0);
                    }
                }
            }
            let (own, _) = self.attach(&to, far, back);
            let seen = Self::visible(&to, far, own, back);
            // Parallel to the line that both share: where the block is too low, a post holds the cord.
            let high = dot(sub(start, seen), left(away));
            end = if let (Some(_), Look::Block { across, .. }) = (to.on, &to.look)
                && to.on == from.on
                && high.abs() > across + 2.0
            {
                let top = along(to.centre, left(away), high);
                let foot = along(to.centre, left(away), across * high.signum());
                pieces.push(Piece::Post(foot, top));
                top
            } else {
                seen
            };
            pieces.push(Piece::Straight(start, end));
        } else {
            // Over a guide pulley: the cord turns the short way.
            let travel = mul(back, -1.0);
            let turn = cross(away, travel);
            let clockwise = turn < 1e-9;
            let inward = |d: V| if clockwise { right(d) } else { left(d) };
            let both_hang = dot(away, back) > 0.9;
            let half = |p: &Placed| p.reach(right(away));
            let radius = if both_hang { ((half(&from) + half(&to)) / 2.0 + 12.0).max(GUIDE) } else { GUIDE };
            let long = from.reach(away) + radius + if both_hang { 70.0 } else { 52.0 };
            let first = along(at, away, long);
            let centre = along(first, inward(away), radius);
            let second = sub(centre, mul(inward(travel), radius));
            guide = Some((centre, radius));
            let (a, b) = (angle(sub(first, centre)), angle(sub(second, centre)));
            let mut b = b;
            while clockwise && b > a {
                b -= 2.0 * PI;
            }
            while !clockwise && b < a {
                b += 2.0 * PI;
            }
            pieces.push(Piece::Straight(start, first));
            pieces.push(Piece::Round(centre, radius, a, b));
            if known.is_none() {
                let drop = to.reach(travel) + radius + if both_hang { 96.0 } else { 50.0 };
                let target = along(second, travel, drop);
                let (own, _) = self.attach(&to, far, back);
                to.centre = sub(target, sub(own, to.centre));
                if let Some(ground) = to.on
                    && ground >= grounds
                {
                    let g = &mut self.grounds[ground];
                    g.origin = sub(to.centre, mul(g.out, to.contact));
                    let s = dot(sub(centre, g.origin), g.up);
                    self.limits[ground] = Some(s - radius - 5.0);
                }
                if let Some(ground) = from.on {
                    let g = &self.grounds[ground];
                    let s = dot(sub(centre, g.origin), g.up);
                    if dot(away, g.up) > 0.0 {
                        self.limits[ground] = Some(s - radius - 5.0);
                    }
                }
            }
            let (own, _) = self.attach(&to, far, back);
            end = Self::visible(&to, far, own, back);
            pieces.push(Piece::Straight(second, end));
        }
        pieces.extend(self.wound(&to, far, back));
        if known.is_none() {
            self.bodies[far.body] = Some(to);
        }
        let ends = vec![(near.body, away), (far.body, back)];
        Run { tie, pieces, stop: Stop::Body, guide, leaves: (at, away), at: ends }
    }

    /// How far each surface goes.
    fn ends(&mut self) {
        for i in 0..self.grounds.len() {
            let g = self.grounds[i].clone();
            let at = |p: V| dot(sub(p, g.origin), g.up);
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
                match run.stop {
                    Stop::Pull(a, b) => {
                        let s = at(crate::figure::vector::middle(a, b));
                        low = low.min(s);
                        high = high.max(s);
                    }
                    Stop::Spring(_, b, _) | Stop::Fixed(b, _) => {
                        low = low.min(at(b));
                        high = high.max(at(b));
                    }
                    Stop::Body => {}
                }
            }
            // Room for the angle at the foot.
            if self.slope_degrees(g.slope) > 0.0 {
                let steep = if rail { 96.0 } else { 84.0 };
                low = low.min(from - steep);
            }
            let ground = &mut self.grounds[i];
            ground.from = low;
            ground.to = high;
            ground.rail = rail;
            if let Some(limit) = self.limits[i] {
                // What hangs at the end hangs free.
                let free = |p: &Placed| {
                    let side = g.up.0.signum();
                    (p.centre.0 - side * (p.reach((1.0, 0.0)) + 12.0) - g.origin.0) / g.up.0
                };
                let hanging = self.bodies.iter().flatten().filter(|p| {
                    p.on.is_none() && at(p.centre) > to && p.centre.1 < g.origin.1 + g.up.1 * limit
                });
                let limit = if g.up.0.abs() > 0.1 { hanging.map(free).fold(limit, f64::min) } else { limit };
                let stands = self.bodies.iter().flatten().filter(|p| p.on == Some(i));
                let least = stands.map(|p| at(p.centre) + 14.0).fold(f64::NEG_INFINITY, f64::max);
                ground.to = limit.max(least);
                ground.drop = true;
            }
        }
    }
}

fn shift(run: &mut Run, by: V) {
    for piece in &mut run.pieces {
        *piece = match *piece {
            Piece::Straight(a, b) => Piece::Straight(add(a, by), add(b, by)),
            Piece::Post(a, b) => Piece::Post(add(a, by), add(b, by)),
            Piece::Round(c, r, a, b) => Piece::Round(add(c, by), r, a, b),
        };
    }
    run.stop = match run.stop {
        Stop::Pull(a, b) => Stop::Pull(add(a, by), add(b, by)),
        Stop::Spring(a, b, c) => Stop::Spring(add(a, by), add(b, by), add(c, by)),
        Stop::Fixed(a, towards) => Stop::Fixed(add(a, by), towards),
        Stop::Body => Stop::Body,
    };
    if let Some((c, _)) = &mut run.guide {
        *c = add(*c, by);
    }
    run.leaves.0 = add(run.leaves.0, by);
}
