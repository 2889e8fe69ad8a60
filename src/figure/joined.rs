//! The picture of joined bodies in the plane: at the start, with the position considered as a ghost.
use crate::figure::view::SceneView;
use crate::figure::{layout, names, parts, say};
use crate::num::Jet;
use crate::num::half::Half;
use crate::picture::board::{Board, LabelTie, MIDDLE_FIRST, on_arc};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Role, TextRun, symbol};
use crate::scene::given;
use crate::scene::{
    Acts, Degree, End, Joint, JointKind, Num, Numbers, Owner, Place, Planar, Push, Quantity, Rest,
    RotaryInertia, Scene, Shape, Spot, Straight, Strut, StrutEnd, Surface, pose,
};
use crate::words::plain::capital;

/// Pixels of the height of all that moves, at most.
const HIGH: f64 = 330.0;
/// Pixels of its width, at most: a flat mechanism is wider, or its crank would be lost under its labels.
const WIDE: f64 = 400.0;
/// Half the width of a rod.
const THICK: f64 = 5.0;
/// Half the width of a slot in which the end of a rod slides, and of a guide of what only slides.
const SLOT: f64 = 9.0;
const GUIDE: f64 = 11.0;
/// Pixels by which two places of a mass centre differ that count as one.
const SAME: f64 = 1e-3;
/// Half the gap of a line round a dot.
const APART: f64 = 7.0;
/// Least radius of a disc, and of the end of a link that is no bar.
const END: f64 = 9.0;
/// A body whose points lie beside its axis by less than this share of its size is drawn as a bar.
const NARROW: f64 = 0.02;
/// The mass centre of a plate lies at least this share of its size from every edge.
const WELL_INSIDE: f64 = 0.1;
/// How far a guide is drawn beyond what slides on it.
const BEYOND: f64 = 30.0;
/// How far from the ends of a plank its mass stands.
const UPON: f64 = 45.0;

/// Where a body lies on the board.
#[derive(Debug, Clone, Copy)]
pub struct Laid {
    /// Origin of its axis.
    pub origin: Vec2,
    /// Direction of its axis.
    pub axis: Vec2,
}

/// Bodies in the plane on the board.
#[derive(Debug, Clone)]
pub struct PlaneLayout {
    /// Pixels per metre.
    pub scale: f64,
    /// The bodies at the start.
    pub start: Vec<Laid>,
    /// The bodies at the position considered, where it is another one.
    pub end: Option<Vec<Laid>>,
}

impl PlaneLayout {
    /// How the bodies of a view lie; `None` where the joints do not place them.
    pub fn new(view: &SceneView) -> Option<Self> {
        let numbers = Numbers::<f64>::new(view.scene, &view.variant.data);
        let start = lay(view, &numbers, &view.scene.start_angle(&numbers), true)?;
        let lead = view.scene.lead()?;
        let turned = |degrees: f64| lay(view, &numbers, &Half::of_degrees(degrees), false);
        let end = match view.scene.end {
            End::Angle(c, n) if c.body == lead => turned(view.of(n)),
            _ => None,
        };
        let mut plane = Self { scale: 1.0, start, end };
        let (mut low, mut high) = (vec2(f64::INFINITY, f64::INFINITY), vec2(-f64::INFINITY, -f64::INFINITY));
        for (b, body) in view.scene.bodies.iter().enumerate() {
            let Some(planar) = &body.planar else { continue };
            for corner in corners(view, b, planar) {
                for Laid { origin, axis } in
                    std::iter::once(&plane.start).chain(&plane.end).map(|laid| laid[b])
                {
                    let p = origin + axis * corner.x + axis.left() * corner.y;
                    (low, high) = (low.inf(&p), high.sup(&p));
                }
            }
        }
        for joint in &view.scene.joints {
            // Wheels, and the cylinders that they touch.
            let JointKind::Contact { at, radius_m, surface, .. } = joint.kind else { continue };
            let own = plane.spot(view, &plane.start, at);
            let last = plane.end.as_ref().map(|end| plane.spot(view, end, at));
            let mut round = vec![(own, view.of(radius_m))];
            round.extend(last.map(|place| (place, view.of(radius_m))));
            if let Surface::Arc { centre_m, radius_m, .. } = surface {
                round.push((ground(view, centre_m), view.of(radius_m)));
            }
            for (place, radius) in round {
                let corner = vec2(radius, radius);
                (low, high) = (low.inf(&(place - corner)), high.sup(&(place + corner)));
            }
        }
        for place in fixed_places(view.scene) {
            let p = ground(view, place);
            (low, high) = (low.inf(&p), high.sup(&p));
        }
        for strut in &view.scene.struts {
            let (_, far) = plane.ends(view, &plane.start, strut);
            (low, high) = (low.inf(&far), high.sup(&far));
        }
        let size = ((high - low).x / WIDE).max((high - low).y / HIGH);
        plane.scale = if size > 0.0 && size.is_finite() { 1.0 / size } else { HIGH };
        let scale = plane.scale;
        for laid in plane.start.iter_mut().chain(plane.end.iter_mut().flatten()) {
            laid.origin *= scale;
        }
        Some(plane)
    }

    /// The same with a scale at which a body is so many pixels long, or as wide as what rolls or slides of it.
    pub fn close_up(&self, view: &SceneView, body: usize, pixels: f64) -> Self {
        let [from, to] = view.scene.planar(body).map_or([0.0; 2], |p| span(view, body, p));
        let touching = view.scene.joints.iter().filter_map(|joint| match joint.kind {
            JointKind::Contact { at, radius_m, .. } if at.body == body => Some(2.0 * view.of(radius_m)),
            _ => None,
        });
        let own = view.scene.planar(body).and_then(|p| round(view, body, p)).map(|r| 2.0 * r);
        let size = touching.chain(own).fold(to - from, f64::max);
        let scale = if size > 0.0 { pixels / size } else { self.scale };
        Self { scale, ..self.clone() }
    }
    /// The bodies at the end, also where only the solver knows where that is: twice where it says no more than how far to either side.
    /// `None` where nothing moves.
    pub fn at_end(&self, view: &SceneView) -> Option<Vec<Vec<Laid>>> {
        if let Some(end) = &self.end {
            return Some(vec![end.clone()]);
        }
        let lead = view.scene.lead()?;
        let start = view.of(view.scene.planar(lead)?.start_deg?);
        let said = |quantity: Quantity| view.solved(quantity, Owner::Body(lead));
        let numbers = Numbers::<f64>::new(view.scene, &view.variant.data);
        let per_way = pose::Layout::new(view.scene, &numbers)?.turned(1.0);
        let (turned, rise) = (said(Quantity::Phi)?.to_degrees() / per_way, said(Quantity::Rise)?);
        let before = self.centre(view, &self.start, lead).y;
        // How far it turns is a magnitude: the sense is the one in which its mass centre rises as much as it is said to.
        let tried = [1.0, -1.0].into_iter().filter_map(|sense| {
            let mut laid = lay(view, &numbers, &Half::of_degrees(start + sense * turned), false)?;
            laid.iter_mut().for_each(|l| l.origin *= self.scale);
            let off = self.centre(view, &laid, lead).y - before - rise * self.scale;
            Some((off.abs(), laid))
        });
        let tried: Vec<(f64, Vec<Laid>)> = tried.collect();
        let least = tried.iter().map(|(off, _)| *off).fold(f64::INFINITY, f64::min);
        let near = tried.into_iter().filter(|(off, _)| *off <= least + SAME);
        Some(near.map(|(_, laid)| laid).collect()).filter(|all: &Vec<_>| !all.is_empty())
    }
    /// Both ends of a spring, where the bodies lie so.
    pub fn ends(&self, view: &SceneView, laid: &[Laid], strut: &Strut) -> (Vec2, Vec2) {
        let near = self.spot(view, laid, strut.at);
        let far = match strut.to {
            StrutEnd::Ground(place) => ground(view, place) * self.scale,
            StrutEnd::Spot(spot) => self.spot(view, laid, spot),
            StrutEnd::Guide { through_m, direction_deg } => {
                let (through, along) =
                    (ground(view, through_m) * self.scale, Vec2::at_degrees(view.of(direction_deg)));
                through + along * (near - through).dot(&along)
            }
            StrutEnd::Twist => near,
        };
        (near, far)
    }
    /// How far a spring is stretched, m, where the bodies lie so; how far a torsion spring is wound, radians. 0 where it does not act.
    pub fn stretch(&self, view: &SceneView, laid: &[Laid], strut: &Strut) -> f64 {
        let beyond = self.beyond(view, laid, strut);
        match strut.acts {
            Acts::Both => beyond,
            Acts::Pushes => beyond.min(0.0),
            Acts::Pulls => beyond.max(0.0),
        }
    }
    fn beyond(&self, view: &SceneView, laid: &[Laid], strut: &Strut) -> f64 {
        let long = |laid: &[Laid]| {
            let (near, far) = self.ends(view, laid, strut);
            (far - near).norm() / self.scale
        };
        let turned = |axis: Vec2| {
            let planar = view.scene.planar(strut.at.body);
            let numbers = Numbers::<f64>::new(view.scene, &view.variant.data);
            let from = pose::Layout::new(view.scene, &numbers).and_then(|layout| layout.relaxed(strut));
            let turned = |p, from| pose::turned_from(p, [axis.x, axis.y], from);
            planar.zip(from).map_or(0.0, |(p, from)| turned(p, from))
        };
        match strut.rest {
            _ if strut.twists() => turned(laid[strut.at.body].axis),
            Rest::Stretch(x) => view.of(x) + long(laid) - long(&self.start),
            Rest::Length(l) => long(laid) - view.of(l),
        }
    }
    /// A point of a body.
    pub fn spot(&self, view: &SceneView, laid: &[Laid], spot: Spot) -> Vec2 {
        let place = view.scene.planar(spot.body).and_then(|p| p.points.get(spot.point));
        let [along, aside] = place.map_or([0.0; 2], |(_, place)| place.map(|x| along(view, x)));
        let Laid { origin, axis } = laid[spot.body];
        origin + (axis * along + axis.left() * aside) * self.scale
    }
    /// On which side of a fixed pin its bracket stands: where no body is.
    fn bracket(&self, place: Vec2) -> Vec2 {
        let taken = |side: &Vec2| {
            self.start.iter().chain(self.end.iter().flatten()).any(|laid| {
                let near = (laid.origin - place).norm() < 60.0;
                near && laid.axis.dot(side) > 0.8
            })
        };
        let sides = [Vec2::DOWN, Vec2::UP, Vec2::LEFT, Vec2::RIGHT];
        sides.into_iter().find(|s| !taken(s)).unwrap_or(Vec2::DOWN)
    }
    /// The mass centre of a body.
    pub fn centre(&self, view: &SceneView, laid: &[Laid], body: usize) -> Vec2 {
        let along = view.scene.planar(body).map_or(0.0, |p| along(view, p.centre));
        laid[body].origin + laid[body].axis * (along * self.scale)
    }

    /// The corners of a body that does not turn, below the line that it carries: under all that moves there.
    fn top(&self, view: &SceneView, laid: &[Laid], body: usize) -> Option<[Vec2; 4]> {
        // What is struck is no wedge.
        let carries = |(j, joint): &(usize, &Joint)| {
            joint.kind.carrier().is_some_and(|on| on.body == body) && !recoils(view, *j)
        };
        let all = view.scene.joints.iter().enumerate().filter(carries).map(|(_, joint)| joint);
        let (line, on) = all.clone().find_map(|j| Some((j.kind.line()?, j.kind.carrier()?)))?;
        let (direction, through) = (self.direction(view, laid, line), self.spot(view, laid, on));
        let slotted = is_slotted(view, body);
        // A slot is as long as the way of the point in it.
        let places = std::iter::once(&self.start).chain(&self.end).map(Vec::as_slice);
        let places = if slotted { places.collect() } else { vec![laid] };
        let places = &places;
        let reach = all.filter_map(|j| j.kind.surface()).flat_map(|(at, radius_m, _)| {
            // Under the whole of a wheel.
            let radius = view.of(radius_m) * self.scale;
            let along =
                move |laid: &&[Laid]| (self.spot(view, laid, at) - self.spot(view, laid, on)).dot(&direction);
            places.iter().map(along).flat_map(move |x| [x - radius, x + radius])
        });
        let (low, high) = reach.fold((0.0, 0.0), |(a, b), x| (f64::min(a, x), f64::max(b, x)));
        if slotted {
            let (from, to) =
                (through + direction * (low - 2.0 * BEYOND), through + direction * (high + 2.0 * BEYOND));
            let aside = direction.left() * (SLOT + GUIDE);
            return Some([from + aside, to + aside, to - aside, from - aside]);
        }
        let down = direction.left() * -GUIDE;
        // A face aslant is that of a wedge, which stands on the level of its foot.
        let wedge =
            !view.scene.bodies[body].turns && down.y < 0.0 && direction.y.abs() > 1e-3 && -down.y > 1.0;
        // Its toe lies on what guides it, under all that lies on it.
        let [foot, head] =
            if wedge { [(GUIDE / direction.y.abs()).min(2.0 * BEYOND), 2.0 * BEYOND] } else { [BEYOND; 2] };
        let [below, above] = if direction.y < 0.0 { [head, foot] } else { [foot, head] };
        let (from, to) = (through + direction * (low - below), through + direction * (high + above));
        if wedge {
            let low = from.y.min(to.y).min(through.y - GUIDE);
            return Some([from, to, vec2(to.x, low), vec2(from.x, low)]);
        }
        Some([from, to, to + down, from + down])
    }

    /// The corners of a block that does not turn: along its guide, or upon the surface on which it slides.
    fn block(&self, view: &SceneView, laid: &[Laid], body: usize) -> [Vec2; 4] {
        let Laid { origin, axis } = laid[body];
        let lies = view.scene.joints.iter().enumerate().find_map(|(j, joint)| match joint.kind {
            JointKind::Guide { at, line, .. } if at.body == body => {
                Some((self.direction(view, laid, line), if line.on.is_some() { 10.0 } else { 0.0 }))
            }
            JointKind::Guide { line: line @ Straight { on: Some(on), .. }, .. }
                if on.body == body && recoils(view, j) =>
            {
                Some((self.direction(view, laid, line), -10.0))
            }
            JointKind::Contact { at, surface: Surface::Arc { inside, .. }, .. } if at.body == body => {
                Some((-axis.left(), if inside { -10.0 } else { 10.0 }))
            }
            JointKind::Contact { at, surface: Surface::Line(line), .. } if at.body == body => {
                Some((self.direction(view, laid, line), 10.0))
            }
            _ => None,
        });
        let (side, off) = lies.unwrap_or((axis, 0.0));
        // What strikes lies on the side from which it comes, as seen from what it strikes.
        let comes = |body: usize| {
            let arrives = view.scene.planar(body).and_then(|planar| planar.arrives);
            let comes = arrives.map(|a| Vec2::at_degrees(view.of(a.direction_deg)) * view.of(a.speed_m_s));
            comes.unwrap_or_default()
        };
        let strikes = view.scene.restitution.and_then(|(j, _)| {
            let mut spots = view.scene.joints.get(j)?.kind.spots();
            Some((spots.next()?.body, spots.next()?.body))
        });
        let way = match strikes {
            Some((striker, struck)) if [striker, struck].contains(&body) => comes(striker) - comes(struck),
            _ => comes(body),
        };
        let beyond = way.dot(&side.left()) > 1e-9;
        let off = if beyond { -off } else { off };
        let (a, b) = (side * 15.0, side.left() * 10.0);
        let origin = origin + side.left() * off;
        [origin + a + b, origin - a + b, origin - a - b, origin + a - b]
    }

    /// The corners of what does not turn, a wedge, a plank or a block; `None` of a particle and of what is round.
    fn edges(&self, view: &SceneView, laid: &[Laid], body: usize) -> Option<[Vec2; 4]> {
        let this = &view.scene.bodies[body];
        // Nothing turns a disc on a smooth bearing: it is round all the same.
        let round = matches!(this.inertia, Some(RotaryInertia::Shape(shape, _)) if shape != Shape::Rod);
        if this.turns || round && !is_guided(view, body) {
            return None;
        }
        let block = || (!names::is_particle(view.scene, body)).then(|| self.block(view, laid, body));
        self.top(view, laid, body).or_else(block)
    }

    /// Is what touches with this radius, m, and has its mass centre so many pixels off the middle, half of a cylinder, a tube, a ball
    /// or a shell? No other body has its mass like that.
    fn is_half(&self, view: &SceneView, body: usize, off: f64, radius: f64) -> bool {
        const PI: f64 = std::f64::consts::PI;
        let this = &view.scene.bodies[body];
        let off = off / (self.scale * radius);
        let about_middle = view.inertia(this) / (view.kilograms(this) * radius * radius) + off * off;
        let halves = [(4.0 / (3.0 * PI), 0.5), (2.0 / PI, 1.0), (0.375, 0.4), (0.5, 2.0 / 3.0)];
        halves
            .iter()
            .any(|(centre, moment)| (off - centre).abs() < 1e-6 && (about_middle - moment).abs() < 1e-6)
    }

    pub fn outline(&self, board: &mut Board, view: &SceneView, laid: &[Laid], body: usize, role: Role) {
        let this = &view.scene.bodies[body];
        let Some(planar) = &this.planar else { return };
        let Laid { origin, axis } = laid[body];
        if this.removed && role == Role::Body {
            // What is taken away shows the paper, with an edge.
            self.outline(board, view, laid, body, Role::Paper);
            return self.outline(board, view, laid, body, Role::Inner);
        }
        if let Some(corners) = self.edges(view, laid, body) {
            return board.lines(&corners, true, role);
        }
        if names::is_particle(view.scene, body) {
            return board.circle(origin, END, role);
        }
        let place = |p: Vec2| origin + (axis * p.x + axis.left() * p.y) * self.scale;
        let open = role == Role::Body && layout::is_open(this);
        let plate = plate(view, body, planar);
        if let Some(corners) = &plate {
            let corners: Vec<Vec2> = corners.iter().copied().map(place).collect();
            board.lines(&corners, true, role);
        }
        let [from, to] = span(view, body, planar).map(|x| place(vec2(x, 0.0)));
        // What rolls or slides on a circle of it is drawn as this circle; else its shape, or its radius of gyration.
        let touching = |joint: &Joint| match joint.kind {
            JointKind::Contact { at, radius_m, .. } if at.body == body => {
                Some((self.spot(view, laid, at), view.of(radius_m))).filter(|(_, radius)| *radius > 0.0)
            }
            _ => None,
        };
        let mut circles: Vec<(Vec2, f64)> = view.scene.joints.iter().filter_map(touching).collect();
        let centre = self.centre(view, laid, body);
        match (&this.inertia, round(view, body, planar)) {
            (Some(RotaryInertia::Shape(..)), round) if !planar.pinned || round.is_none() => {
                circles.extend(round.map(|r| (centre, r)))
            }
            (_, Some(round)) if circles.is_empty() => {
                let round = (round * self.scale).max(END);
                return parts::round_link(board, (centre, round), &[from, to], open, role);
            }
            _ => {}
        }
        circles.dedup();
        for (at, radius) in &mut circles {
            let off = centre - *at;
            if self.is_half(view, body, off.norm(), *radius) {
                let flat = off.angle_of() - 0.5 * std::f64::consts::PI;
                let half = (*at, *radius * self.scale, flat, flat + std::f64::consts::PI);
                return board.arcs(vec![half], role);
            }
            *radius = (*radius * self.scale).max(END);
            parts::rim(board, *at, *radius, open, role);
        }
        // What is round has no rod in it: a thin line shows how it has turned.
        let inside = |p: Vec2| circles.iter().any(|(centre, radius)| (p - centre).norm() < radius + 1.0);
        if this.rod().is_none() && inside(from) && inside(to) {
            return board.lines(&[from, to], false, if role == Role::Body { Role::Inner } else { role });
        }
        if plate.is_none() {
            // An arm leads from its axis to what acts beside it, as to a shoe.
            for (point, (_, at)) in planar.points.iter().enumerate() {
                let [x, y] = at.map(|x| along(view, x));
                let (foot, tip, side) = (place(vec2(x, 0.0)), place(vec2(x, y)), axis * (0.8 * THICK));
                let acts = acts_at(view.scene).any(|spot| spot == Spot { body, point });
                if acts && (tip - foot).norm() > THICK && !inside(tip) {
                    board.lines(&[foot + side, tip + side, tip - side, foot - side], true, role);
                }
            }
            let (side, on) = (axis.left() * THICK, axis * THICK);
            board.lines(&[from - on + side, to + on + side, to + on - side, from - on - side], true, role);
        }
    }
}

/// Does its point recoil there?
fn recoils(view: &SceneView, joint: usize) -> bool {
    view.scene.restitution.is_some_and(|(recoils, _)| recoils == joint)
}

/// The point at which something is cut out that is taken away.
fn cut_from(scene: &Scene, body: usize) -> Option<Spot> {
    let weld = scene.joints.iter().find(|j| j.kind.is_weld() && j.kind.spots().any(|spot| spot.body == body));
    weld.filter(|_| scene.bodies[body].removed)?.kind.spots().find(|spot| !scene.bodies[spot.body].removed)
}

/// Does a straight guide hold a point of it?
fn is_guided(view: &SceneView, body: usize) -> bool {
    let guides = |j: &Joint| matches!(j.kind, JointKind::Guide { at, .. } if at.body == body);
    view.scene.joints.iter().any(guides)
}

/// The points of bodies at which a joint, a force or a spring acts.
fn acts_at(scene: &Scene) -> impl Iterator<Item = Spot> {
    let joints = scene.joints.iter().flat_map(|joint| joint.kind.spots());
    joints.chain(scene.pushes.iter().map(|push| push.at)).chain(scene.struts.iter().map(|strut| strut.at))
}

/// The bodies at an angle of the leading one, m; `None` where the joints do not place them.
fn lay(view: &SceneView, numbers: &Numbers<f64>, angle: &Half<f64>, at_start: bool) -> Option<Vec<Laid>> {
    let laid = pose::poses(view.scene, numbers, angle, at_start)?;
    let vector = |[x, y]: [f64; 2]| vec2(x, y);
    let mut laid: Vec<Laid> =
        laid.iter().map(|p| Laid { origin: vector(p.origin), axis: vector(p.axis) }).collect();
    // What slides on a cylinder without turning by itself is drawn along it.
    for joint in &view.scene.joints {
        if let JointKind::Contact { at, surface: Surface::Arc { centre_m, .. }, .. } = joint.kind
            && !view.scene.bodies[at.body].turns
        {
            laid[at.body].axis = (laid[at.body].origin - ground(view, centre_m)).unit();
        }
    }
    laid.iter().all(|l| l.origin.norm().is_finite() && l.axis.norm().is_finite()).then_some(laid)
}

/// A distance along the axis of a body, m.
pub fn along(view: &SceneView, place: Place) -> f64 {
    match place {
        Place::At(n) => view.of(n),
        Place::HalfOf(n) => view.of(n) / 2.0,
    }
}

/// Radius of what is drawn round the mass centre of a body, m: that of its shape, or its radius of gyration; `None` of a rod or a plate.
fn round(view: &SceneView, body: usize, planar: &Planar) -> Option<f64> {
    let this = &view.scene.bodies[body];
    match &this.inertia {
        Some(RotaryInertia::Shape(Shape::Rod, _)) => None,
        Some(RotaryInertia::Shape(_, r)) => Some(view.of(*r)),
        _ => {
            let mass = view.kilograms(this);
            let square = if mass > 0.0 { (view.inertia(this) / mass).max(0.0) } else { 0.0 };
            plate(view, body, planar).is_none().then(|| square.sqrt())
        }
    }
}

/// From where to where a body lies along its axis, m.
pub fn span(view: &SceneView, body: usize, planar: &Planar) -> [f64; 2] {
    let long = view.scene.bodies[body].rod().map(|l| view.of(l));
    let centre = along(view, planar.centre);
    let ends = long.map(|l| [centre - l / 2.0, centre + l / 2.0]);
    let points = planar.points.iter().map(|(_, p)| along(view, p[0]));
    let corners = plate(view, body, planar).unwrap_or_default();
    let all = points.chain([centre]).chain(ends.into_iter().flatten()).chain(corners.iter().map(|c| c.x));
    all.fold([f64::INFINITY, -f64::INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// The points of a body that have names, as [`corners`].
fn named(view: &SceneView, planar: &Planar) -> impl Iterator<Item = Vec2> {
    planar.points.iter().map(|(_, [x, y])| vec2(along(view, *x), along(view, *y)))
}

/// The corners between which a body lies: how far along its axis and beside it, m.
fn corners(view: &SceneView, body: usize, planar: &Planar) -> Vec<Vec2> {
    let ends = span(view, body, planar).map(|x| vec2(x, 0.0));
    let (centre, round) = (vec2(along(view, planar.centre), 0.0), round(view, body, planar));
    let around = [Vec2::RIGHT, Vec2::UP, Vec2::LEFT, Vec2::DOWN].into_iter();
    let named = named(view, planar).chain(ends).chain(around.filter_map(|d| Some(centre + d * round?)));
    named.chain(plate(view, body, planar).unwrap_or_default()).collect()
}

/// The corners of a plate, counter-clockwise, as [`corners`]; `None` of a body of known shape and of one that is held on its axis alone.
///
/// They are the hull of its named points where the mass centre lies well inside it, as that of a plate must. Else not all
/// of its corners are named: the body is taken to be symmetric about its axis and about the line across it through the mass centre, as a
/// crate is.
fn plate(view: &SceneView, body: usize, planar: &Planar) -> Option<Vec<Vec2>> {
    if matches!(view.scene.bodies[body].inertia, Some(RotaryInertia::Shape(..))) {
        return None;
    }
    let named: Vec<Vec2> = named(view, planar).collect();
    let centre = along(view, planar.centre);
    let size = named.iter().map(|p| p.norm()).fold(centre.abs(), f64::max);
    if named.iter().all(|p| p.y.abs() < NARROW * size) {
        return None;
    }
    let own = hull(named.clone());
    let edges = own.iter().zip(own.iter().cycle().skip(1));
    let off = |(a, b): (&Vec2, &Vec2)| (b - a).unit().perp(&(vec2(centre, 0.0) - a));
    if own.len() > 2 && edges.map(off).all(|inside| inside > WELL_INSIDE * size) {
        return Some(own);
    }
    let mirrored = |p: Vec2| [p, vec2(2.0 * centre - p.x, p.y)].map(|p| [p, vec2(p.x, -p.y)]);
    Some(hull(named.into_iter().flat_map(mirrored).flatten().collect()))
}

/// The convex hull of points, counter-clockwise (the chains of Andrew).
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let chain = |points: &mut dyn Iterator<Item = &Vec2>| {
        let mut chain: Vec<Vec2> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp(&(p - b)) <= 1e-9 * (b - a).norm() * (p - a).norm()
            {
                chain.pop();
            }
            chain.push(*p);
        }
        chain.pop();
        chain
    };
    [chain(&mut points.iter()), chain(&mut points.iter().rev())].concat()
}

pub fn ground(view: &SceneView, place: [Num; 2]) -> Vec2 {
    vec2(view.of(place[0]), view.of(place[1]))
}

/// Places to which bodies are pinned or tied, or are pulled.
fn fixed_places(scene: &Scene) -> impl Iterator<Item = [Num; 2]> {
    let held = scene.joints.iter().flat_map(|joint| match joint.kind {
        JointKind::Pin { place_m, .. } => [Some(place_m), None],
        JointKind::Cord { place_m, beyond, .. } => [Some(place_m), beyond.map(|(_, last_m)| last_m)],
        _ => [None, None],
    });
    held.flatten().chain(scene.pushes.iter().filter_map(|push| push.toward_m))
}

/// Do the bodies hang from all that holds them?
pub fn hangs(view: &SceneView) -> bool {
    let Some(plane) = PlaneLayout::new(view) else { return false };
    let low = fixed_places(view.scene).map(|p| view.of(p[1]) * plane.scale).fold(f64::INFINITY, f64::min);
    let held = |j: &Joint| !matches!(j.kind, JointKind::Guide { .. } | JointKind::Contact { .. });
    let below = |b: usize| plane.centre(view, &plane.start, b).y < low;
    low.is_finite() && view.scene.joints.iter().all(held) && (0..plane.start.len()).all(below)
}

/// Draws the bodies with their joints, forces and sizes.
pub fn draw(board: &mut Board, view: &SceneView) {
    let Some(plane) = PlaneLayout::new(view) else { return };
    // What strikes a body is guided by nothing.
    let bodies_strike = |(j, joint): &(usize, &Joint)| recoils(view, *j) && joint.kind.carrier().is_some();
    let joints = view.scene.joints.iter().enumerate().filter(|joint| !bodies_strike(joint));
    let runs: Vec<GuideRun> = joints.filter_map(|(_, joint)| GuideRun::new(view, &plane, joint)).collect();
    let others = |i: usize| -> Vec<&GuideRun> {
        runs.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, run)| run).collect()
    };
    let rails = |board: &mut Board, carrier: Option<usize>| {
        let own = runs.iter().enumerate().filter(|(_, run)| run.carrier == carrier);
        own.for_each(|(i, run)| guide(board, run, &others(i), view.scene.carried.is_some()));
    };
    rails(board, None);
    for (i, run) in runs.iter().enumerate() {
        // The same coefficient a second time is named, not told again.
        let told = runs[..i].iter().any(|r| r.mu_k == run.mu_k);
        rubs(board, view, run, &others(i), told);
    }
    if let Some(end) = &plane.end {
        for b in 0..view.scene.bodies.len() {
            plane.outline(board, view, end, b, Role::Ghost);
        }
    }
    // What moves in a slot lies above it, but for a disc, which would hide it.
    let hides = |b: usize| {
        let planar = view.scene.planar(b).filter(|_| view.scene.bodies[b].turns);
        planar.and_then(|planar| round(view, b, planar)).is_some_and(|r| r * plane.scale > 2.0 * GUIDE)
    };
    let mut order: Vec<usize> = (0..view.scene.bodies.len()).collect();
    order.sort_by_key(|b| (!hides(*b), !is_slotted(view, *b), view.scene.bodies[*b].removed));
    for b in order {
        plane.outline(board, view, &plane.start, b, Role::Body);
        rails(board, Some(b));
    }
    for joint in 0..view.scene.joints.len() {
        held(board, view, &plane, joint);
    }
    for strut in &view.scene.struts {
        let (mut near, far) = plane.ends(view, &plane.start, strut);
        let rows = vec![view.label(strut.stiffness_n_m, spring_units(strut)[0]), relaxed(view, strut)];
        if strut.twists() {
            // A spiral about the point, out from it by half turns.
            for (i, lower) in [0.0, 1.0, 0.0, 1.0].into_iter().enumerate() {
                let (centre, from) = (near + Vec2::RIGHT * (3.0 * lower), std::f64::consts::PI * lower);
                board.arc(centre, 9.0 + 3.0 * i as f64, from, from + std::f64::consts::PI, Role::Spring);
            }
            let spots = [30.0, 150.0, -30.0, -150.0].map(Vec2::at_degrees).map(|d| (near + d * 22.0, d));
            board.label(rows, Role::Spring, (LabelTie::Leader, 4.0), spots.to_vec());
            continue;
        }
        // One that is met on the way only stands there at its natural length.
        let mut hangs = None;
        if strut.acts != Acts::Both
            && plane.stretch(view, &plane.start, strut) == 0.0
            && let Rest::Length(rest) = strut.rest
        {
            let long = view.of(rest) * plane.scale;
            match strut.acts {
                Acts::Pulls => hangs = Some(slack(board, (near, far), long)),
                Acts::Both | Acts::Pushes => near = far + (near - far).unit() * long,
            }
        }
        if hangs.is_some() {
        } else if (far - near).norm() > 14.0 {
            board.spring(far, near, 9, 6.0);
        } else {
            board.line(far, near, Role::Spring);
        }
        if !matches!(strut.to, StrutEnd::Spot(_)) && (far - near).norm() > 1.0 {
            let back = (far - near).unit();
            parts::wall(board, far, back, 13.0, -13.0);
            // Of a body on a pin of its own the bank names no points: its spring is held at A.
            if view.scene.pinned().is_some() {
                let spots = vec![(far + back * 9.0, back), (far + Vec2::UP * 14.0, Vec2::UP)];
                board.label(vec![symbol::italic("A")], Role::Dot, (LabelTie::Near, 4.0), spots);
            }
        }
        let (middle, out) = hangs.unwrap_or((far.middle(near), (far - near).unit().left()));
        let spots = vec![(middle + out * 10.0, out), (middle - out * 10.0, -out)];
        board.label(rows, Role::Spring, (LabelTie::Leader, 4.0), spots);
    }
    letters(board, view, &plane, &plane.start, None);
    angles(board, view, &plane);
    for (j, joint) in view.scene.joints.iter().enumerate() {
        face(board, view, &plane, joint);
        if recoils(view, j) {
            line_of_contact(board, view, &plane, joint);
        }
    }
    for b in 0..view.scene.bodies.len() {
        sizes(board, view, &plane, b);
    }
    places(board, view, &plane);
    loads(board, view, &plane);
}

/// Units of the stiffness of a spring and of what says when it is relaxed.
fn spring_units(strut: &Strut) -> [&'static str; 2] {
    if strut.twists() { ["N·m/rad", "°"] } else { ["N/m", "m"] }
}

/// When a spring is relaxed: a number that no symbol tells has a name.
fn relaxed(view: &SceneView, strut: &Strut) -> Vec<TextRun> {
    let (Rest::Length(rest) | Rest::Stretch(rest)) = strut.rest;
    let label = view.label(rest, spring_units(strut)[1]);
    match rest {
        Num::Fixed(_) => symbol::upright(rest_words(view, strut, &symbol::plain(&label))),
        _ => label,
    }
}

/// The same in words.
fn rest_words(view: &SceneView, strut: &Strut, size: &str) -> String {
    let name = match (strut.rest, strut.twists()) {
        (Rest::Length(_), false) => "length",
        (Rest::Stretch(_), false) => "stretch",
        (Rest::Length(_), true) => "relaxed",
        (Rest::Stretch(_), true) => "wound",
    };
    view.words.say(&format!("figure.joined.rest.{name}"), &[("size", size)])
}

/// A strap that is longer than the distance of its ends, hanging slack: as an arc, of its own length where that is less than half a
/// circle. Its lowest point, and out of it.
fn slack(board: &mut Board, (near, far): (Vec2, Vec2), long: f64) -> (Vec2, Vec2) {
    let (middle, chord) = (near.middle(far), (far - near).norm());
    let out = match (far - near).unit().left() {
        left if left.y > 0.0 => -left,
        left => left,
    };
    // Half the angle of the arc, halved until chord and length go together: sin x / x falls.
    let [mut low, mut high] = [0.01, 0.5 * std::f64::consts::PI];
    for _ in 0..40 {
        let x = f64::midpoint(low, high);
        let too_short = Vec2::at_angle(x).y * long > x * chord;
        (low, high) = if too_short { (x, high) } else { (low, x) };
    }
    let direction = Vec2::at_angle(high);
    let radius = (0.5 * chord / direction.y).max(1.0);
    let (centre, towards) = (middle - out * (radius * direction.x), out.angle_of());
    board.arc(centre, radius, towards - high, towards + high, Role::Spring);
    [near, far].into_iter().for_each(|end| board.dot(end));
    (centre + out * radius, out)
}

impl PlaneLayout {
    /// The direction of a line.
    pub fn direction(&self, view: &SceneView, laid: &[Laid], line: Straight) -> Vec2 {
        let direction = Vec2::at_degrees(view.of(line.direction_deg));
        let Some(axis) = line.on.map(|on| laid[on.body].axis) else { return direction };
        axis * direction.x + axis.left() * direction.y
    }
    /// From a surface to what touches it at a place.
    pub fn normal(&self, view: &SceneView, laid: &[Laid], surface: Surface, at: Vec2) -> Vec2 {
        match surface {
            Surface::Line(line) => self.direction(view, laid, line).left(),
            Surface::Arc { centre_m, inside, .. } => {
                let out = (at - ground(view, centre_m) * self.scale).unit();
                if inside { -out } else { out }
            }
        }
    }
}

/// Does a body that does not turn have a slot in which a point of a rod or a wheel moves?
fn is_slotted(view: &SceneView, body: usize) -> bool {
    let bodies = &view.scene.bodies;
    let slot = |j: &Joint| match j.kind {
        JointKind::Guide { at, one_sided: false, .. } => {
            bodies[at.body].turns && j.kind.carrier().is_some_and(|on| on.body == body)
        }
        _ => false,
    };
    !bodies[body].turns && view.scene.joints.iter().any(slot)
}

/// A line that guides a point, as far as it is drawn.
struct GuideRun {
    body: usize,
    through: Vec2,
    direction: Vec2,
    /// The distances along it between which it guides.
    low: f64,
    high: f64,
    /// Half its width.
    apart: f64,
    one_sided: bool,
    /// The body that carries it.
    carrier: Option<usize>,
    mu_k: Option<Num>,
}

impl GuideRun {
    fn new(view: &SceneView, plane: &PlaneLayout, joint: &Joint) -> Option<Self> {
        let JointKind::Guide { at, line, one_sided, mu_k, .. } = joint.kind else {
            return None;
        };
        let direction = plane.direction(view, &plane.start, line);
        let through = match line.on {
            Some(on) => plane.spot(view, &plane.start, on),
            None => ground(view, line.through_m) * plane.scale,
        };
        let places = std::iter::once(&plane.start).chain(&plane.end);
        // Under the whole of a plank.
        let reach = places.flat_map(|laid| {
            let corners = plane.top(view, laid, at.body).into_iter().flatten();
            let all = corners.chain([plane.spot(view, laid, at)]);
            all.map(|p| (p - through).dot(&direction)).collect::<Vec<_>>()
        });
        let (low, high) = reach.fold((f64::INFINITY, -f64::INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        // What slides on it lies within it, a rod's end upon it.
        let slider = !view.scene.bodies[at.body].turns;
        let apart = match (slider, one_sided) {
            (true, _) if line.on.is_some() => 0.0,
            (true, _) => GUIDE,
            (false, true) => THICK + 1.0,
            (false, false) => SLOT,
        };
        let carrier = line.on.map(|on| on.body);
        Some(Self { body: at.body, through, direction, low, high, apart, one_sided, carrier, mu_k })
    }
    /// A line of it, this far to its left: its ends, up to the corner with the other lines on which the same body slides.
    fn ends(&self, side: f64, others: &[&GuideRun]) -> (Vec2, Vec2) {
        let (mut low, mut high) = (self.low, self.high);
        for other in others.iter().filter(|o| o.body == self.body) {
            if let Some(at) = self.meets(0.0, other, 0.0) {
                (low, high) = (low.min(at), high.max(at));
            }
        }
        (self.at(low - BEYOND, side), self.at(high + BEYOND, side))
    }
    fn at(&self, along: f64, side: f64) -> Vec2 {
        self.through + self.direction * along + self.direction.left() * side
    }
    /// How far along it a line beside it meets a line beside another one; `None` where they are parallel.
    fn meets(&self, side: f64, other: &GuideRun, other_side: f64) -> Option<f64> {
        let cross = self.direction.perp(&other.direction);
        let gap = other.at(0.0, other_side) - self.at(0.0, side);
        (cross.abs() > 1e-6).then(|| gap.perp(&other.direction) / cross)
    }
    /// Is a point within it: between its rails, or behind its surface?
    fn covers(&self, point: Vec2) -> bool {
        let off = (point - self.through).dot(&self.direction.left());
        if self.one_sided { off < -self.apart - 0.1 } else { off.abs() < self.apart - 0.1 }
    }
    /// The pieces of a line beside it that no other one covers.
    fn pieces(&self, side: f64, others: &[&GuideRun]) -> Vec<(Vec2, Vec2)> {
        let (from, to) = self.ends(side, others);
        let along = |p: Vec2| (p - self.through).dot(&self.direction);
        let (low, high) = (along(from), along(to));
        let mut cuts = vec![low, high];
        for other in others {
            let sides = if other.one_sided { vec![-other.apart] } else { vec![-other.apart, other.apart] };
            cuts.extend(sides.iter().filter_map(|s| self.meets(side, other, *s)));
        }
        cuts.retain(|x| (low..=high).contains(x));
        cuts.sort_by(f64::total_cmp);
        let pieces = cuts.windows(2).map(|w| (self.at(w[0], side), self.at(w[1], side)));
        pieces.filter(|(a, b)| !others.iter().any(|o| o.covers(a.middle(*b)))).collect()
    }
}

/// A line that guides a point: hatched where it only pushes, else two rails, open where two of them cross.
fn guide(board: &mut Board, run: &GuideRun, others: &[&GuideRun], carried: bool) {
    let normal = run.direction.left();
    let sides = if run.one_sided { vec![-run.apart] } else { vec![run.apart, -run.apart] };
    for side in sides {
        for (from, to) in run.pieces(side, others) {
            if run.one_sided && run.carrier.is_none() && !carried {
                board.hatch(from, to, -normal);
            }
            board.line(from, to, if run.carrier.is_some() { Role::Body } else { Role::Ground });
        }
    }
}

/// A coefficient of friction: told where it is not `told` already.
fn roughness(view: &SceneView, mu: Num, told: bool) -> Vec<TextRun> {
    match view.symbol(mu) {
        symbol if symbol.is_empty() => {
            crate::figure::view::joined(symbol::symbol(r"\mu_k"), view.value(mu, ""))
        }
        symbol if told => symbol,
        _ => view.label(mu, ""),
    }
}

/// The coefficient of friction of a guide.
fn rubs(board: &mut Board, view: &SceneView, run: &GuideRun, others: &[&GuideRun], told: bool) {
    let normal = run.direction.left();
    if let Some(mu) = run.mu_k {
        let (from, to) = run.ends(-run.apart, others);
        let middle = from.middle(to);
        let label = roughness(view, mu, told);
        let direction = run.direction;
        let mut spots = vec![(middle, -normal), (to, direction), (from, -direction)];
        // Under the face of a wedge it would be told of its floor.
        if run.carrier.is_some() && direction.y.abs() > 1e-3 {
            spots = vec![(to + direction * 30.0, normal), (from - direction * 30.0, normal)];
        }
        board.wish(label, spots, Role::Friction);
    }
}

/// A surface under a wheel as far as the other ones that it touches, with which it makes a corner.
fn cornered(
    view: &SceneView,
    plane: &PlaneLayout,
    joint: usize,
    (mut from, mut to): (Vec2, Vec2),
) -> (Vec2, Vec2) {
    let wheel = view.scene.joints[joint].kind.surface().map(|(at, ..)| at);
    for other in &view.scene.joints {
        let JointKind::Contact { at, surface: Surface::Line(line), radius_m, .. } = other.kind else {
            continue;
        };
        if wheel != Some(at) || line.on.is_some() {
            continue;
        }
        let normal = plane.direction(view, &plane.start, line).left();
        let foot = plane.spot(view, &plane.start, at) - normal * (view.of(radius_m) * plane.scale);
        let [behind, before] = [from, to].map(|end| (end - foot).dot(&normal));
        if behind * before < 0.0 {
            let corner = from + (to - from) * (behind / (behind - before));
            if behind < 0.0 { from = corner } else { to = corner }
        }
    }
    (from, to)
}

/// Pins, hinges and cords.
fn held(board: &mut Board, view: &SceneView, plane: &PlaneLayout, index: usize) {
    let joint = &view.scene.joints[index];
    match joint.kind {
        JointKind::Guide { at, one_sided, .. } => {
            if !one_sided && !recoils(view, index) && view.scene.bodies[at.body].turns {
                board.circle(plane.spot(view, &plane.start, at), 3.6, Role::Inner);
            }
        }
        JointKind::Hinge { turned_deg: Some(_), .. } => {}
        JointKind::Hinge { one, .. } => board.circle(plane.spot(view, &plane.start, one), 3.6, Role::Inner),
        JointKind::Pin { at, .. } => {
            let place = plane.spot(view, &plane.start, at);
            let side = plane.bracket(place);
            let (wall, across) = (place + side * 24.0, side.left());
            board.lines(&[wall - across * 12.0, place, wall + across * 12.0], true, Role::Inner);
            let (a, b) = (wall + across * 24.0, wall - across * 24.0);
            let (a, b) = if side.y < -0.5 || side.x < -0.5 { (b, a) } else { (a, b) };
            // What carries the whole scene is no ground.
            if view.scene.carried.is_none() {
                board.hatch(a, b, side);
            }
            board.line(a, b, Role::Ground);
            board.circle(place, 3.6, Role::Inner);
        }
        JointKind::Contact { at, radius_m, surface, mu_k, .. } => {
            let place = plane.spot(view, &plane.start, at);
            let radius = view.of(radius_m) * plane.scale;
            if radius > 0.0 {
                // A round shape has its radius beside its mass.
                let told = view.scene.bodies[at.body].inertia.as_ref();
                if !matches!(told, Some(RotaryInertia::Shape(_, r)) if *r == radius_m) {
                    radius_line(board, view, place, radius_m, plane.scale);
                }
            }
            match surface {
                Surface::Line(line) => {
                    let direction = plane.direction(view, &plane.start, line);
                    let foot = place - direction.left() * radius;
                    let reach =
                        plane.end.iter().map(|laid| (plane.spot(view, laid, at) - place).dot(&direction));
                    let (low, high) = reach.fold((0.0, 0.0), |(a, b), x| (f64::min(a, x), f64::max(b, x)));
                    let margin = radius + 40.0;
                    let ends = (foot + direction * (low - margin), foot + direction * (high + margin));
                    let (from, to) = cornered(view, plane, index, ends);
                    match line.on {
                        None => {
                            board.hatch(from, to, -direction.left());
                            board.line(from, to, Role::Ground);
                        }
                        // The top of a plank is drawn with it.
                        Some(on) if !view.scene.bodies[on.body].turns => {}
                        Some(_) => board.line(from, to, Role::Body),
                    }
                }
                Surface::Arc { centre_m, radius_m, on, .. } => {
                    let drum = |on: Spot| round(view, on.body, view.scene.planar(on.body)?);
                    // The rim of a drum is drawn with it.
                    if on.and_then(drum) != Some(view.of(radius_m)) {
                        let centre = ground(view, centre_m) * plane.scale;
                        board.circle(centre, view.of(radius_m) * plane.scale, Role::Ground);
                        radius_line(board, view, centre, radius_m, plane.scale);
                    }
                }
            }
            if let Some(mu) = mu_k {
                let told = view.scene.joints[..index].iter().any(|j| j.kind.mu_k() == mu_k);
                let (normal, far) = (plane.normal(view, &plane.start, surface, place), radius + 40.0);
                let (foot, along) = (place - normal * radius, normal.right());
                let ends = cornered(view, plane, index, (foot - along * far, foot + along * far));
                let sides = [(ends.1, along), (ends.0, -along)];
                let sides = sides.into_iter().filter(|_| matches!(surface, Surface::Line(_)));
                let spots = std::iter::once((foot, -normal)).chain(sides).collect();
                board.wish(roughness(view, mu, told), spots, Role::Friction);
            }
        }
        JointKind::Cord { at, place_m, beyond: Some((to, last_m)), .. } => {
            let ends = [(at, place_m), (to, last_m)].map(|(spot, place)| {
                let pulley = ground(view, place) * plane.scale;
                board.line(plane.spot(view, &plane.start, spot), pulley, Role::Cord);
                pulley
            });
            board.line(ends[0], ends[1], Role::Cord);
            ends.into_iter().for_each(|pulley| small_pulley(board, pulley));
        }
        JointKind::Cord { at, place_m, beyond: None, rod } => {
            let (near, far) = (plane.spot(view, &plane.start, at), ground(view, place_m) * plane.scale);
            if rod {
                board.line(near, far, Role::Body);
                [near, far].into_iter().for_each(|end| board.dot(end));
            } else {
                board.line(near, far, Role::Cord);
            }
            parts::wall(board, far, (far - near).unit(), -14.0, 14.0);
        }
    }
}

/// Names of points, and the mass centre, of a single body or of this one alone.
pub fn letters(board: &mut Board, view: &SceneView, plane: &PlaneLayout, laid: &[Laid], only: Option<usize>) {
    let single = view.scene.bodies.len() == 1 || only.is_some();
    let mut named: Vec<(Vec2, &str, usize)> = Vec::new();
    for (b, body) in view.scene.bodies.iter().enumerate().filter(|(b, _)| only.is_none_or(|o| o == *b)) {
        let Some(planar) = body.planar.as_ref().filter(|_| body.turns) else { continue };
        let centre = single.then(|| {
            let at = plane.centre(view, laid, b);
            board.dot(at);
            (at, "G", b)
        });
        let spot = |point| plane.spot(view, laid, Spot { body: b, point });
        let points = planar.points.iter().enumerate().map(|(point, (name, _))| (spot(point), &**name, b));
        for letter in centre.into_iter().chain(points) {
            if !named.iter().any(|(at, ..)| (*at - letter.0).norm() < 3.0) {
                named.push(letter);
            }
        }
    }
    let tags = names::tags(view.problem, view.scene);
    for (at, name, b) in &named {
        let (at, axis, centre) = (*at, laid[*b].axis, single && *name == "G");
        // Beside the axis, then between the lines that cross there: the axis, a slot, a bracket, a dashed line.
        let across = axis.left();
        let beside = [across, -across, axis, -axis].map(|d| (at + d * 6.0, d));
        let along = [14.0, -14.0, 24.0, -24.0, 34.0, -34.0]
            .into_iter()
            .flat_map(|s| [across, -across].map(|d| (at + axis * s + d * 6.0, d)));
        let between = (0..4).flat_map(|quarter| {
            let d = Vec2::at_degrees(45.0 + 90.0 * f64::from(quarter));
            [(at + d * 10.0, d), (at + d * 18.0, d)]
        });
        let spots = beside.into_iter().chain(between).chain(along.filter(|_| centre)).collect();
        // Points of several bodies that are called alike bear the mark of their body.
        let letter = match named.iter().any(|(_, other, of)| other == name && of != b) {
            true => symbol::symbol(&names::tagged(name, &tags[*b])),
            false => symbol::italic(*name),
        };
        board.label(vec![letter], Role::Dot, (LabelTie::Near, 4.0), spots);
    }
}

/// The angle of the leading body, at the start and at the position considered.
fn angles(board: &mut Board, view: &SceneView, plane: &PlaneLayout) {
    let Some(lead) = view.scene.lead() else { return };
    let Some(planar) = view.scene.planar(lead) else { return };
    let [x, y] = planar.from.components();
    let zero = vec2(x, y);
    let sense = if planar.clockwise { -1.0 } else { 1.0 };
    // On a cylinder the angle is that of the mass centre, seen from the axis.
    let mut leading = (0..view.scene.joints.len()).filter(|joint| view.scene.leads_on_arc(*joint));
    let axis = leading.find_map(|joint| match view.scene.joints[joint].kind {
        JointKind::Contact { at, surface: Surface::Arc { centre_m, .. }, .. } if at.body == lead => {
            Some((at, ground(view, centre_m) * plane.scale))
        }
        _ => None,
    });
    let mut shown = Vec::new();
    if let Some(start) = planar.start_deg {
        shown.push((start, &plane.start, 46.0));
    }
    if let (End::Angle(_, n), Some(end)) = (view.scene.end, &plane.end) {
        shown.push((n, end, 72.0));
    }
    for (num, laid, mut radius) in shown {
        let degrees = view.of(num);
        if matches!(num, Num::Fixed(_)) && degrees.abs() < 1e-9 {
            continue;
        }
        let corner = axis.map_or(laid[lead].origin, |(_, axis)| axis);
        // The line whose angle is told, over what is round about it.
        if planar.pinned && round(view, lead, planar).is_some() {
            board.line(corner, plane.centre(view, laid, lead), Role::Ghost);
        }
        if let Some((at, axis)) = axis {
            board.line(axis, plane.spot(view, laid, at), Role::Ghost);
        }
        // No arrow ends on the mass centre of a single body.
        let tip = corner + Vec2::at_angle(zero.angle_of() + sense * degrees.to_radians()) * radius;
        let centre = plane.centre(view, &plane.start, lead);
        if view.scene.bodies.len() == 1 && (centre - tip).norm() < 2.0 * APART {
            radius = ((centre - corner).norm() - 2.0 * APART).max(2.0 * APART);
        }
        // Broken where the mass centre of a single body has its dot.
        let off = plane.centre(view, &plane.start, lead) - corner;
        let dotted = view.scene.bodies.len() == 1 && off.perp(&zero).abs() < APART;
        let dot = if dotted { off.dot(&zero) } else { f64::INFINITY };
        let far: f64 = radius + 16.0;
        for (low, high) in [(9.0, far.min(dot - APART)), (9f64.max(dot + APART), far)] {
            if high > low {
                board.line(corner + zero * low, corner + zero * high, Role::Ghost);
            }
        }
        let from = zero.angle_of();
        let turned = board.angle(corner, radius, from, sense * degrees);
        let spots = on_arc(corner, radius, from, turned, MIDDLE_FIRST);
        board.label(vec![view.label(num, "°")], Role::Dimension, (LabelTie::Clear, 5.0), spots);
    }
}

/// The side of a body on which its length stands: away from the angle of the leading body, then from where it goes; away from
/// the other bodies for all that follow it.
fn free_side(view: &SceneView, plane: &PlaneLayout, body: usize) -> Vec2 {
    let across = plane.start[body].axis.left();
    // What is cut out of a body has its length on the other side than that.
    if let Some(whole) = cut_from(view.scene, body) {
        return if free_side(view, plane, whole.body).dot(&across) > 0.0 { -across } else { across };
    }
    let middle = |laid: &[Laid], b: usize| plane.centre(view, laid, b);
    let here = middle(&plane.start, body);
    let away = match view.scene.planar(body).filter(|_| view.scene.lead() == Some(body)) {
        Some(planar) => {
            let [x, y] = planar.from.components();
            let side = |off: f64| if off.abs() > 1e-6 { off.signum() } else { 0.0 };
            let goes = plane.end.as_ref().map_or(Vec2::ZERO, |end| middle(end, body) - here);
            side(goes.dot(&across)) + 2.0 * side(vec2(x, y).dot(&across))
        }
        None => (0..plane.start.len()).map(|b| (middle(&plane.start, b) - here).dot(&across)).sum(),
    };
    if away > 0.0 { -across } else { across }
}

/// Coordinates of fixed places that are data, each as a length from the origin.
fn places(board: &mut Board, view: &SceneView, plane: &PlaneLayout) {
    let springs = view.scene.struts.iter().filter_map(|s| match s.to {
        StrutEnd::Ground(place) | StrutEnd::Guide { through_m: place, .. } => Some(place),
        StrutEnd::Spot(_) | StrutEnd::Twist => None,
    });
    let mut seen: Vec<Num> = Vec::new();
    for place in fixed_places(view.scene).chain(springs) {
        let at = ground(view, place) * plane.scale;
        let [x, y] = place;
        // An upright length stands on the side where no body is.
        let centres = (0..plane.start.len()).map(|b| plane.centre(view, &plane.start, b).x - at.x);
        let side = if centres.sum::<f64>() > 0.0 { Vec2::LEFT } else { Vec2::RIGHT };
        let lengths = [(x, vec2(0.0, at.y), Vec2::DOWN, 66.0), (y, vec2(at.x, 0.0), side, 40.0)];
        for (n, from, out, off) in lengths {
            if matches!(n, Num::Datum(_)) && !seen.contains(&n) {
                seen.push(n);
                dimension(board, from, at, out, off, view.label(n, "m"));
            }
        }
    }
}

/// Length, mass and radius of gyration of a body.
fn sizes(board: &mut Board, view: &SceneView, plane: &PlaneLayout, body: usize) {
    let this = &view.scene.bodies[body];
    let Some(planar) = &this.planar else { return };
    let Laid { origin, axis } = plane.start[body];
    let [from, to] = span(view, body, planar).map(|x| origin + axis * (x * plane.scale));
    let out = free_side(view, plane, body);
    let mut rows = Vec::new();
    if let Some((n, weight)) = view.mass(this) {
        let several = view.scene.bodies.iter().filter(|body| !body.turns).count() > 1;
        let before = match this.removed {
            true => symbol::upright("−\u{2009}"),
            false if view.scene.restitution.is_some() && !this.turns && several => {
                // Which of the bodies that meet is which.
                let tag = &names::tags(view.problem, view.scene)[body];
                [symbol::symbol(tag), symbol::upright(":\u{a0}")].concat()
            }
            false => Vec::new(),
        };
        rows.push([before, view.label(n, if weight { "N" } else { "kg" })].concat());
    }
    match &this.inertia {
        Some(RotaryInertia::Shape(Shape::Rod, l)) => {
            dimension(board, from, to, out, 40.0, view.label(*l, "m"))
        }
        Some(RotaryInertia::Shape(_, r) | RotaryInertia::Gyration(r @ Num::Datum(_))) => {
            rows.push(view.label(*r, "m"))
        }
        Some(RotaryInertia::Moment(i @ Num::Datum(_))) => rows.push(view.label(*i, "kg·m<sup>2</sup>")),
        _ => {}
    }
    lengths(board, view, plane, body);
    let middle = from.middle(to);
    let side = match round(view, body, planar).filter(|_| !this.turns) {
        Some(radius) => radius * plane.scale,
        None if this.turns => THICK,
        None => 12.0,
    };
    // Beside the middle, where the mass centre has its dot; across the line of its length only where all else is taken.
    let places = [0.22, -0.22, 0.33, -0.33, 0.12, -0.12].map(|share| middle + (to - from) * share);
    let beside = [-out, out].into_iter().flat_map(|d| places.map(|p| (p + d * side, d)));
    let top = plane.top(view, &plane.start, body).filter(|_| !this.turns);
    let carried =
        |j: &Joint| j.kind.carrier().is_some() && j.kind.spots().next().is_some_and(|at| at.body == body);
    let ends = match top {
        // Beside the upright side of a wedge.
        Some([a, b, ..]) if top.is_some_and(is_wedge) => {
            let (foot, head) = if a.y < b.y { (a, b) } else { (b, a) };
            vec![(vec2(head.x, head.y.midpoint(foot.y)), vec2((head.x - foot.x).signum(), 0.0))]
        }
        // Upon the ends of a plank, what rolls on it is not in the way.
        Some([a, b, ..]) => {
            let along = (b - a).unit();
            [a + along * UPON, b - along * UPON].map(|p| (p, along.left())).to_vec()
        }
        // Beside a block that another body carries, away from that.
        None if !this.turns && view.scene.joints.iter().any(carried) => {
            let [a, b, c, d] = plane.block(view, &plane.start, body);
            let (up, along) = ((a - d).unit(), (a - b).unit());
            vec![(a.middle(b), up), (b.middle(c), -along), (a.middle(d), along)]
        }
        None => Vec::new(),
    };
    let spots = ends.into_iter().chain(beside);
    board.label(rows, Role::Dot, (LabelTie::Clear, 6.0), spots.collect());
}

/// Distances of the named points and of the mass centre of a body from its origin, each once. An expression is drawn where it alone
/// tells a datum.
fn lengths(board: &mut Board, view: &SceneView, plane: &PlaneLayout, body: usize) {
    let this = &view.scene.bodies[body];
    let Some(planar) = this.planar.as_ref().filter(|_| this.turns) else { return };
    let Laid { origin, axis } = plane.start[body];
    let out = free_side(view, plane, body);
    let whole = corners(view, body, planar);
    let reach = |way: Vec2| {
        let far = whole.iter().map(|c| axis * c.x + axis.left() * c.y);
        far.map(|c| c.dot(&way) * plane.scale).fold(0.0, f64::max)
    };
    let is_plate = plate(view, body, planar).is_some();
    let centre = [planar.centre, Place::At(Num::Fixed(0.0))];
    // Where no length of the body stands on the free side, the distance of its mass centre does.
    let acts = |point| acts_at(view.scene).any(|spot| spot == Spot { body, point });
    let pushed = |point| view.scene.pushes.iter().any(|push| push.at == Spot { body, point });
    let points = planar.points.iter().enumerate();
    let sides = points.map(|(point, (_, place))| (place, -out, acts(point), pushed(point)));
    let centre_side = if this.rod().is_some() { -out } else { out };
    let mut found = Vec::new();
    for (place, side, acts, pushed) in sides.chain([(&centre, centre_side, false, false)]) {
        let [x, y] = place.map(|x| along(view, x) * plane.scale);
        let foot = origin + axis * x;
        let point = foot + axis.left() * y;
        // Beside a plate, else by the point.
        let (end, off) = match is_plate {
            true if x < 0.5 * (reach(axis) - reach(-axis)) => (-axis, reach(-axis) + x),
            true => (axis, reach(axis) - x),
            false => (axis, 0.0),
        };
        for (n, line, aside, off) in
            [(place[0], (origin, foot), side, reach(side)), (place[1], (foot, point), end, off)]
        {
            let Place::At(n) = n else { continue };
            // Both halves of a plate are a length of it.
            let whole = view.twice(n).filter(|_| is_plate && line.0 == foot);
            let line = whole.map_or(line, |_| (foot * 2.0 - point, point));
            // Where a force or a blow acts, a constant place is told as well.
            let told = pushed && matches!(n, Num::Fixed(x) if x != 0.0);
            found.push((whole.unwrap_or(view.unsigned(n)), line, aside, 26.0 + off, told, acts));
        }
    }
    let touches = view.scene.joints.iter().filter(|joint| joint.kind.spots().any(|spot| spot.body == body));
    let told = touches.filter_map(|joint| Some(joint.kind.surface()?.1)).chain(this.rod());
    let mut told: Vec<Num> = told.chain(view.radii(this).into_iter().map(|(n, _)| n)).collect();
    let own = told.clone();
    // Data first: an expression of them tells nothing more. Then where nothing stands.
    found.sort_by_key(|(n, .., acts)| (!matches!(n, Num::Datum(_)), *acts));
    for (n, (from, to), aside, off, constant, _) in found {
        let data = if constant { vec![n] } else { view.data(n) };
        let radius = !constant && data == [n] && own.contains(&n) && this.rod() != Some(n);
        if radius || data.iter().any(|datum| !told.contains(datum)) {
            dimension(board, from, to, aside, off, view.label(n, "m"));
        }
        told.extend(data);
    }
}

/// Do these corners of what carries a line make a wedge, and no plank?
fn is_wedge([from, to, below, _]: [Vec2; 4]) -> bool {
    below.x.to_bits() == to.x.to_bits() && (to - from).y.abs() > 1.0
}

/// The angle of the face of a wedge at its foot, above the level.
fn face(board: &mut Board, view: &SceneView, plane: &PlaneLayout, joint: &Joint) {
    let Some((line, on)) = joint.kind.line().zip(joint.kind.carrier()) else { return };
    let Some([a, b, ..]) = plane.top(view, &plane.start, on.body).filter(|top| is_wedge(*top)) else {
        return;
    };
    let (foot, head) = if a.y < b.y { (a, b) } else { (b, a) };
    let level = vec2((head.x - foot.x).signum(), 0.0);
    let degrees = ((head - foot).angle_of() - level.angle_of()).to_degrees();
    // Where the axis is level, the angle that is told is that of the face; else it is another.
    if (degrees.abs() - view.of(line.direction_deg).abs()).abs() > 1e-6 {
        return;
    }
    board.line(foot, foot + level * 50.0, Role::Ghost);
    let turned = board.angle(foot, 36.0, level.angle_of(), degrees);
    let spots = on_arc(foot, 36.0, level.angle_of(), turned, MIDDLE_FIRST);
    let label = view.size_label(line.direction_deg, "°");
    board.label(vec![label], Role::Dimension, (LabelTie::Clear, 5.0), spots);
}

/// The line along which bodies meet, with its angle from the axis from which that is told, where it is aslant.
fn line_of_contact(board: &mut Board, view: &SceneView, plane: &PlaneLayout, joint: &Joint) {
    let Some((line, on)) = joint.kind.line().zip(joint.kind.carrier()) else { return };
    let degrees = view.of(line.direction_deg);
    if (degrees / 90.0).fract().abs() < 1e-9 {
        return;
    }
    let (at, along) = (plane.spot(view, &plane.start, on), plane.direction(view, &plane.start, line));
    let axis = plane.start[on.body].axis;
    board.line(at - along * 56.0, at + along * 56.0, Role::Ghost);
    board.line(at, at + axis * 56.0, Role::Ghost);
    let turned = board.angle(at, 40.0, axis.angle_of(), degrees);
    let spots = on_arc(at, 40.0, axis.angle_of(), turned, MIDDLE_FIRST);
    let label = view.label(line.direction_deg, "°");
    board.label(vec![label], Role::Dimension, (LabelTie::Clear, 5.0), spots);
}

/// A dimension line beside a length.
pub fn dimension(board: &mut Board, from: Vec2, to: Vec2, out: Vec2, off: f64, label: Vec<TextRun>) {
    for p in [from, to] {
        board.line(p + out * (off - 16.0).clamp(8.0, 30.0), p + out * (off + 5.0), Role::Dimension);
    }
    let (a, b) = (from + out * off, to + out * off);
    board.double_arrow(a, b, Role::Dimension);
    let mid = a.middle(b);
    let along = (b - a).unit();
    let spots =
        vec![(mid, out), (mid + along * 34.0, out), (mid + along * 60.0, out), (b, along), (a, -along)];
    board.label(vec![label], Role::Dimension, (LabelTie::Clear, 5.0), spots);
}

/// The radius of a circle that is a datum, drawn to its rim.
fn radius_line(board: &mut Board, view: &SceneView, centre: Vec2, radius_m: Num, scale: f64) {
    if !matches!(radius_m, Num::Datum(_)) {
        return;
    }
    let out = Vec2::at_degrees(-140.0);
    let rim = centre + out * (view.of(radius_m) * scale);
    board.arrow(centre, rim, Role::Dimension);
    let (middle, across) = (centre.middle(rim), out.left());
    let spots = vec![(rim, out), (middle, across), (middle, -across)];
    board.label(vec![view.label(radius_m, "m")], Role::Dimension, (LabelTie::Clear, 5.0), spots);
}

fn small_pulley(board: &mut Board, at: Vec2) {
    board.circle(at, 5.0, Role::Body);
    board.dot(at);
}

/// Forces, couples and the spin at the start.
fn loads(board: &mut Board, view: &SceneView, plane: &PlaneLayout) {
    for push in &view.scene.pushes {
        let at = plane.spot(view, &plane.start, push.at);
        let towards = towards(view, plane, &plane.start, push);
        if let Some(place) = push.toward_m {
            let pulley = ground(view, place) * plane.scale;
            board.line(at, pulley, Role::Cord);
            small_pulley(board, pulley);
        }
        let tip = at + towards * 56.0;
        board.arrow(at, tip, Role::Force);
        let spots = vec![(tip, towards), (at.middle(tip), towards.left()), (at.middle(tip), towards.right())];
        board.wish(view.label(push.force_n, if push.blow { "N·s" } else { "N" }), spots, Role::Force);
    }
    for couple in &view.scene.couples {
        let clockwise = view.scene.planar(couple.body).is_some_and(|p| p.clockwise);
        let forward = couple.forward == (view.of(couple.moment_n_m) >= 0.0);
        let laid = plane.start[couple.body];
        let sense = if clockwise == forward { -1.0 } else { 1.0 };
        // Between the body and the bracket of its pin, on the side where there is more room.
        let mut taken = vec![laid.axis.angle_of()];
        let pins = |j: &Joint| matches!(j.kind, JointKind::Pin { at, .. } if (plane.spot(view, &plane.start, at) - laid.origin).norm() < 1.0);
        if view.scene.joints.iter().any(pins) {
            taken.push(plane.bracket(laid.origin).angle_of());
        }
        let turn = 2.0 * std::f64::consts::PI;
        let room = |from: f64| {
            let others = taken.iter().map(|t| (t - from).rem_euclid(turn));
            others.filter(|r| *r > 1e-9).fold(turn, f64::min)
        };
        let widest = taken.iter().map(|from| (*from, room(*from))).max_by(|a, b| a.1.total_cmp(&b.1));
        let (low, wide) = widest.unwrap_or((0.0, turn));
        let (middle, half) = (low + wide / 2.0, (wide / 2.0 - 0.65).clamp(0.6, 1.8));
        let (from, to) = (middle - sense * half, middle + sense * half);
        board.curved_arrow(laid.origin, 24.0, from, to, Role::Force);
        let spots = on_arc(laid.origin, 24.0, from, to - from, &[0.5, 0.3, 0.7, 0.1, 1.0]);
        let label = view.size_label(couple.moment_n_m, "N·m");
        board.label(vec![label], Role::Force, (LabelTie::Clear, 5.0), spots);
    }
    for (b, laid) in plane.start.iter().enumerate() {
        let started = |asked| view.started(b).filter(move |(degree, _)| *degree == asked).map(|(_, num)| num);
        let arrives = view.scene.planar(b).and_then(|planar| planar.arrives);
        let arriving =
            arrives.map(|arrives| (arrives.speed_m_s, Vec2::at_degrees(view.of(arrives.direction_deg))));
        let going = started(Degree::Along).filter_map(|num| Some((num, heading(view, b, num)?)));
        for (speed, towards) in arriving.filter(|(speed, _)| view.of(*speed) != 0.0).into_iter().chain(going)
        {
            let edges = plane.edges(view, &plane.start, b);
            let from = edges.map_or(plane.centre(view, &plane.start, b), |[a, _, c, _]| a.middle(c));
            let tip = from + towards * 56.0;
            board.arrow(from, tip, Role::Motion);
            let middle = from.middle(tip);
            let spots = vec![(tip, towards), (middle, towards.left()), (middle, towards.right())];
            board.wish(view.size_label(speed, "m/s"), spots, Role::Motion);
        }
        let arriving = arrives.map(|arrives| arrives.spin_rad_s).filter(|spin| view.of(*spin) != 0.0);
        // What rolls goes another way than it spins.
        let rolling =
            |joint: &Joint| matches!(joint.kind, JointKind::Contact { at, rolls: true, .. } if at.body == b);
        let rolls = view.scene.joints.iter().any(rolling);
        let (middle, radius) =
            match view.scene.planar(b).and_then(|planar| round(view, b, planar)).filter(|_| rolls) {
                Some(radius) => (plane.centre(view, &plane.start, b), radius * plane.scale + 14.0),
                None => (laid.origin, 92.0),
            };
        for num in started(Degree::Turn).chain(arriving) {
            let clockwise = view.scene.planar(b).is_some_and(|p| p.clockwise);
            let sense = if clockwise == (view.of(num) >= 0.0) { -1.0 } else { 1.0 };
            let mid = laid.axis.angle_of();
            let far = 36.8 / radius;
            board.curved_arrow(middle, radius, mid + sense * 0.2 * far, mid + sense * far, Role::Motion);
            let d = Vec2::at_angle(mid + sense * 0.6 * far);
            board.wish(view.size_label(num, "rad/s"), vec![(middle + d * radius, d)], Role::Motion);
        }
    }
}

/// Direction in which the mass centre of a body with this speed along its line moves at the start; `None` where it rests. Of several
/// speeds that are told each is seen from what carries the line.
fn heading(view: &SceneView, body: usize, speed: Num) -> Option<Vec2> {
    let numbers = Numbers::<f64>::new(view.scene, &view.variant.data);
    let layout = pose::Layout::new(view.scene, &numbers)?;
    let [x, y] = if view.scene.tells_speeds() {
        let start = pose::poses(view.scene, &numbers, &view.scene.start_angle(&numbers), true)?;
        let (joint, _) = view.scene.guide_of(body)?;
        layout.told_along(joint, &start).map(|x| x * view.of(speed))
    } else {
        let (rate, poses) = (layout.start_rate()?, layout.poses::<Jet<f64>>(0.0, false)?);
        let along = pose::along(&numbers, view.scene.planar(body)?.centre);
        poses[body].point([along, 0.0]).map(|x| x.first * rate)
    };
    Some(vec2(x, y)).filter(|way| way.norm() > 0.0).map(Direction::unit)
}

/// Direction of a force.
pub fn towards(view: &SceneView, plane: &PlaneLayout, laid: &[Laid], push: &Push) -> Vec2 {
    if let Some(place) = push.toward_m {
        return (ground(view, place) * plane.scale - plane.spot(view, laid, push.at)).unit();
    }
    let direction = Vec2::at_degrees(view.of(push.direction_deg));
    if push.turns {
        let axis = laid[push.at.body].axis;
        axis * direction.x + axis.left() * direction.y
    } else {
        direction
    }
}

/// What the picture shows, in words.
pub fn tell(view: &SceneView, out: &mut Vec<String>) {
    let teller = Teller { view };
    let say = |name: &str, pieces: &[(&str, &str)]| teller.say(name, pieces);
    for (b, body) in view.scene.bodies.iter().enumerate() {
        let name = match view.scene.lies_level() {
            _ if body.removed => "removed",
            true => "flat_body",
            false => "body",
        };
        out.push(say(name, &[("body", &say::named(view, body))]));
        say::couples(view, b, out);
        for (degree, num) in view.started(b) {
            let along = || heading(view, b, num).map(|to| teller.heads(to * view.of(num).signum()));
            let positive = match degree {
                Degree::Turn => teller.positive_turn(b),
                Degree::Along => along().map_or_else(String::new, |way| say("positive", &[("sense", &way)])),
            };
            let spin = say::text(view, num, given::speed_unit(degree));
            out.push(say("spin", &[("spin", &spin), ("positive", &positive)]));
        }
    }
    if let Some((lead, planar)) = view.scene.lead().and_then(|l| Some((l, view.scene.planar(l)?))) {
        let body = names::body_within(view.words, view.scene, lead);
        let the = names::the_body(view.words, view.scene, lead);
        let flat = if view.scene.lies_level() { "flat_ray" } else { "ray" };
        let from = view.words.get(&format!("figure.joined.{flat}.{}", ray(planar)));
        if let Some(start) = planar.start_deg {
            out.push(say(
                "start",
                &[("body", &body), ("the", &the), ("from", from), ("angle", &say::text(view, start, "°"))],
            ));
        }
        if let End::Angle(_, n) = view.scene.end {
            out.push(say("end", &[("angle", &say::text(view, n, "°"))]));
        }
    }
    for (j, joint) in view.scene.joints.iter().enumerate() {
        match (joint.kind, view.scene.restitution.filter(|(recoils, _)| *recoils == j)) {
            (JointKind::Guide { at, line, .. }, Some((_, e))) => {
                let struck = line.on.map(|on| names::the_body(view.words, view.scene, on.body));
                let struck = struck.unwrap_or_else(|| teller.line(line.direction_deg));
                let (point, e) = (teller.called(at), say::text(view, e, ""));
                out.push(say("strikes", &[("point", &point), ("struck", &struck), ("e", &e)]));
            }
            (kind, Some((_, e))) => {
                out.push(teller.joint(kind));
                out.push(say("impact", &[("e", &say::text(view, e, ""))]));
            }
            (kind, None) => out.push(teller.joint(kind)),
        }
    }
    for push in &view.scene.pushes {
        let (name, unit) = if push.blow { ("blow", "N·s") } else { ("force", "N") };
        let name = if push.toward_m.is_some() { "pull" } else { name };
        let force = say::text(view, push.force_n, unit);
        let to = push.toward_m.map_or_else(String::new, |place| teller.place(place));
        let way = push.toward_m.map_or_else(|| teller.way(push.direction_deg, push.turns), |_| String::new());
        let pieces = [("force", &*force), ("point", &teller.called(push.at)), ("place", &to), ("way", &way)];
        out.push(say(name, &pieces));
    }
    for (b, arrival) in view.scene.arrivals() {
        let moves = [arrival.speed_m_s, arrival.spin_rad_s].map(|num| view.of(num) != 0.0);
        let mut arrives = |name: &str, (num, unit): (Num, &str), way: &str| {
            let (the, size) = (names::the_body(view.words, view.scene, b), say::text(view, num, unit));
            out.push(say(name, &[("the", &the), ("size", &size), ("way", way)]));
        };
        if moves[0] {
            arrives("arrives", (arrival.speed_m_s, "m/s"), &teller.way(arrival.direction_deg, false));
        }
        if moves[1] {
            arrives("arrives_turning", (arrival.spin_rad_s, "rad/s"), &teller.positive_turn(b));
        }
        if moves == [false; 2] {
            arrives("arrives_at_rest", (arrival.speed_m_s, "m/s"), "");
        }
    }
    out.extend(view.scene.struts.iter().map(|strut| teller.strut(strut)));
    // The letter of a point stays as it is.
    for said in out.iter_mut().filter(|said| said.chars().nth(1).is_some_and(char::is_alphabetic)) {
        *said = capital(said);
    }
}

/// The words of the pieces of a scene of joined bodies.
struct Teller<'v, 'a> {
    view: &'v SceneView<'a>,
}

impl Teller<'_, '_> {
    fn say(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        self.view.words.say(&format!("figure.joined.{name}"), pieces)
    }
    /// In which sense the turn of a body counts.
    fn positive_turn(&self, body: usize) -> String {
        let clockwise = self.view.scene.planar(body).is_some_and(|p| p.clockwise);
        let sense =
            self.view.words.get(if clockwise { "figure.turn.clockwise" } else { "figure.turn.counter" });
        self.say("positive", &[("sense", sense)])
    }
    fn called(&self, spot: Spot) -> String {
        let (_, point) = self.view.scene.point_name(spot).unwrap_or(("", ""));
        let body = names::body_within(self.view.words, self.view.scene, spot.body);
        let the = names::the_body(self.view.words, self.view.scene, spot.body);
        let name = if self.view.scene.bodies[spot.body].turns { "point" } else { "itself" };
        self.say(name, &[("point", point), ("body", &body), ("the", &the)])
    }
    fn place(&self, place: [Num; 2]) -> String {
        let (x, y) = (say::text(self.view, place[0], "m"), say::text(self.view, place[1], "m"));
        self.say("place", &[("x", &x), ("y", &y)])
    }
    /// A line that is level, upright or sloped.
    fn line(&self, direction_deg: Num) -> String {
        let name = match direction_deg {
            Num::Fixed(d) if d % 180.0 == 0.0 => "level",
            Num::Fixed(d) if (d % 180.0).abs().to_bits() == 90.0_f64.to_bits() => "upright",
            _ => "sloped",
        };
        self.say(name, &[("angle", &say::text(self.view, direction_deg, "°"))])
    }
    fn straight(&self, line: Straight) -> String {
        let Some(on) = line.on else { return self.line(line.direction_deg) };
        let on = self.called(on);
        match line.direction_deg {
            Num::Fixed(0.0) => on,
            angle => {
                let angle = say::text(self.view, angle, "°");
                self.say("carried", &[("on", &on), ("angle", &angle)])
            }
        }
    }
    /// Whither a force acts, or a body moves.
    fn way(&self, direction_deg: Num, turns: bool) -> String {
        let angle = say::text(self.view, direction_deg, "°");
        let name = match direction_deg {
            _ if turns => "from_axis",
            Num::Fixed(0.0) => "to.right",
            Num::Fixed(90.0) => "to.up",
            Num::Fixed(180.0) => "to.left",
            Num::Fixed(-90.0) => "to.down",
            _ => "to.angle",
        };
        self.say(name, &[("angle", &angle)])
    }
    /// The same of a direction that no datum tells.
    fn heads(&self, to: Vec2) -> String {
        let degrees = to.angle_of().to_degrees();
        let quarter = (degrees / 90.0).round() * 90.0;
        if (degrees - quarter).abs() < 1e-6 {
            // One name for both ends of a half turn.
            return self.way(Num::Fixed(if quarter < -90.0 { 180.0 } else { quarter + 0.0 }), false);
        }
        let degrees = (degrees.rem_euclid(360.0) * 10.0).round() / 10.0;
        let angle = format!("{}°", self.view.words.number(&degrees.to_string()));
        self.say("to.angle", &[("angle", &angle)])
    }
    fn joint(&self, kind: JointKind) -> String {
        match kind {
            JointKind::Pin { at, place_m } => {
                self.say("pin", &[("point", &self.called(at)), ("place", &self.place(place_m))])
            }
            JointKind::Hinge { one, other, turned_deg } => {
                let removed = |spot: Spot| self.view.scene.bodies[spot.body].removed;
                let particle = |spot: Spot| names::is_particle(self.view.scene, spot.body);
                let (name, one, other) = match turned_deg {
                    Some(_) if removed(one) != removed(other) => match removed(one) {
                        true => ("cut", one, other),
                        false => ("cut", other, one),
                    },
                    Some(_) => ("weld", one, other),
                    None if particle(one) => ("sits", one, other),
                    None if particle(other) => ("sits", other, one),
                    None => ("hinge", one, other),
                };
                self.say(name, &[("one", &self.called(one)), ("other", &self.called(other))])
            }
            JointKind::Guide { at, line, one_sided, mu_k, .. } => {
                let what = if one_sided { "touches" } else { "guide" };
                let guide = self.say(what, &[("point", &self.called(at)), ("line", &self.straight(line))]);
                self.rough(guide, mu_k)
            }
            JointKind::Contact { at, radius_m, surface, rolls, mu_k, teeth } => {
                let what = match rolls {
                    true if teeth && kind.carrier().is_some() => "meshes_carried",
                    true if teeth => "meshes",
                    true => "rolls",
                    false => match (mu_k.is_some(), self.view.of(radius_m) == 0.0) {
                        (true, true) => "rubs_itself",
                        (true, false) => "slips",
                        (false, true) => "slides_itself",
                        (false, false) => "slides",
                    },
                };
                let on = match surface {
                    Surface::Line(line) if line.on.is_some() => {
                        self.say("surface", &[("line", &self.straight(line))])
                    }
                    Surface::Line(Straight { direction_deg, .. }) => {
                        let line =
                            self.say("sloped", &[("angle", &say::text(self.view, direction_deg, "°"))]);
                        self.say("surface", &[("line", &line)])
                    }
                    Surface::Arc { radius_m, on: Some(on), .. } => {
                        let radius = say::text(self.view, radius_m, "m");
                        self.say("rim", &[("body", &self.called(on)), ("radius", &radius)])
                    }
                    Surface::Arc { radius_m, inside, .. } => {
                        let name = if inside { "within" } else { "outside" };
                        self.say(name, &[("radius", &say::text(self.view, radius_m, "m"))])
                    }
                };
                let radius = say::text(self.view, radius_m, "m");
                let point = match self.view.scene.bodies[at.body].turns {
                    true => self.called(at),
                    false => capital(&names::the_body(self.view.words, self.view.scene, at.body)),
                };
                self.rough(self.say(what, &[("point", &point), ("radius", &radius), ("on", &on)]), mu_k)
            }
            JointKind::Cord { at, place_m, beyond: Some((to, last_m)), .. } => {
                let what = if last_m == place_m { "cord_over" } else { "cord_over_both" };
                let [place, last] = [place_m, last_m].map(|place| self.place(place));
                let names =
                    [("point", self.called(at)), ("place", place), ("last", last), ("to", self.called(to))];
                self.say(what, &names.each_ref().map(|(name, text)| (*name, text.as_str())))
            }
            JointKind::Cord { at, place_m, beyond: None, rod } => {
                let what = if rod { "rod" } else { "cord" };
                self.say(what, &[("point", &self.called(at)), ("place", &self.place(place_m))])
            }
        }
    }
    /// What is said of a contact, with its coefficient of friction if it is rough.
    fn rough(&self, contact: String, mu_k: Option<Num>) -> String {
        let rubs = |mu| self.say("rubs", &[("mu", &say::text(self.view, mu, ""))]);
        mu_k.map_or_else(|| contact.clone(), |mu| format!("{contact} {}", rubs(mu)))
    }
    fn strut(&self, strut: &Strut) -> String {
        let (Rest::Length(rest) | Rest::Stretch(rest)) = strut.rest;
        let units = spring_units(strut);
        let rest = rest_words(self.view, strut, &say::text(self.view, rest, units[1]));
        let list = [say::text(self.view, strut.stiffness_n_m, units[0]), rest];
        let name = match (strut.to, strut.acts) {
            (StrutEnd::Twist, _) => "torsion",
            (_, Acts::Both) => "spring",
            (_, Acts::Pushes) => "pushing_spring",
            (_, Acts::Pulls) => "pulling_spring",
        };
        let to = match strut.to {
            StrutEnd::Twist => String::new(),
            StrutEnd::Ground(p) => self.place(p),
            StrutEnd::Spot(spot) => self.called(spot),
            StrutEnd::Guide { through_m, direction_deg } => {
                let name = [("line", self.line(direction_deg)), ("place", self.place(through_m))];
                self.say("guided", &name.each_ref().map(|(name, text)| (*name, text.as_str())))
            }
        };
        let list = list.join(say::separator(self.view));
        self.say(name, &[("point", &self.called(strut.at)), ("to", &to), ("list", &list)])
    }
}

/// From where an angle counts and in which sense: a name in the word list.
fn ray(planar: &Planar) -> String {
    let from = match planar.from.components() {
        [x, _] if x > 0.5 => "right",
        [x, _] if x < -0.5 => "left",
        [_, y] if y > 0.0 => "up",
        _ => "down",
    };
    format!("{from}_{}", if planar.clockwise { "clockwise" } else { "counter" })
}
