//! Poses of bodies in the plane as functions of one angle, with their first and second derivative by it: one function for each way
//! in which joints can place a body.
//!
//! One body leads: its angle is given. It hangs on a pin, or slides with two points in two guides, or with one in a guide while
//! nothing moves its mass centre along it. Each other body is placed by what already has a place: hinged there and guided at
//! another point (a circle and a line), or hinged there and to a second body that is (two circles). A wheel that rolls on a line
//! turns with the way of its centre; one that leads on a cylinder is told by the angle of its centre.
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::num::{Jet, Real, trig};
use crate::scene::{Branch, JointKind, Num, Numbers, Place, Planar, Scene, Spot, Surface};
use smallvec::SmallVec;
use std::ops::{Add, Mul, Sub};

/// A point of the plane, or a vector.
pub type Point<T> = [Jet<T>; 2];

/// Where a body is: the origin of its axis, and the direction of its axis as a unit vector.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T> {
    /// Origin of the axis, m.
    pub origin: Point<T>,
    /// Direction of the axis.
    pub axis: Point<T>,
}

/// One pose for each body in the plane.
pub type Poses<T> = SmallVec<[Pose<T>; 2]>;

impl<T: Real> Pose<T> {
    /// The point at this distance along the axis.
    pub fn point(&self, along: T) -> Point<T> {
        plus(self.origin, times(self.axis, along))
    }
    /// Rate and second derivative of the angle of the axis, counter-clockwise positive.
    pub fn turn(&self) -> (T, T) {
        let [c, s] = self.axis;
        (c.value * s.first - s.value * c.first, c.value * s.second - s.value * c.second)
    }
}

fn plus<T: Real>(a: Point<T>, b: Point<T>) -> Point<T> {
    [a[0] + b[0], a[1] + b[1]]
}
fn less<T: Real>(a: Point<T>, b: Point<T>) -> Point<T> {
    [a[0] - b[0], a[1] - b[1]]
}
fn times<T: Real>(a: Point<T>, by: T) -> Point<T> {
    a.map(|x| x.times(by))
}
fn scaled<T: Real>(a: Point<T>, by: Jet<T>) -> Point<T> {
    a.map(|x| x * by)
}
fn dot<T: Real>(a: Point<T>, b: Point<T>) -> Jet<T> {
    a[0] * b[0] + a[1] * b[1]
}
/// A vector a quarter turn to the left.
fn left<T: Real>(a: Point<T>) -> Point<T> {
    [-a[1], a[0]]
}
fn fixed<T: Real>(a: [T; 2]) -> Point<T> {
    a.map(Jet::fixed)
}

/// A distance along the axis.
pub fn along<T: Real>(n: &Numbers<T>, place: Place) -> T {
    match place {
        Place::At(x) => n.get(x),
        Place::HalfOf(x) => n.get(x).scale2(-1),
    }
}

/// Distance of a named point from the origin of its body's axis.
pub fn of_spot<T: Real>(scene: &Scene, n: &Numbers<T>, spot: Spot) -> T {
    let planar = scene.bodies[spot.body].planar.as_ref();
    planar.and_then(|p| p.points.get(spot.point)).map_or_else(T::zero, |(_, place)| along(n, *place))
}

/// A fixed place.
pub fn ground<T: Real>(n: &Numbers<T>, place: [Num; 2]) -> [T; 2] {
    place.map(|x| n.get(x))
}

/// Unit vector along a direction in degrees, counter-clockwise from the right.
pub fn direction<T: Real>(n: &Numbers<T>, degrees: Num) -> [T; 2] {
    // A whole number of degrees is exactly that.
    let degrees = match degrees {
        Num::Fixed(x) if x.fract() == 0.0 => T::of(x),
        other => n.get(other),
    };
    let (s, c) = trig::sin_cos_of_degrees(degrees);
    [c, s]
}

/// The point of a line that lies nearest to a place; the line goes through a place along a unit vector.
pub fn foot<X: Copy + Add<Output = X> + Sub<Output = X> + Mul<Output = X>>(
    near: [X; 2],
    through: [X; 2],
    along: [X; 2],
) -> [X; 2] {
    let way = (near[0] - through[0]) * along[0] + (near[1] - through[1]) * along[1];
    [through[0] + along[0] * way, through[1] + along[1] * way]
}

/// Below this sine a line is level.
const LEVEL: f64 = 1e-12;

/// 1 where a direction leads up, or to the right on a level, else -1: the sense in which friction along it is told.
pub fn upward<T: Real>([c, s]: [T; 2]) -> f64 {
    if s.size() < LEVEL { c.sign() } else { s.sign() }
}

/// Direction of an axis at this angle, as the angle of the body counts, with its derivatives by it.
fn axis<T: Real>(planar: &Planar, angle: &Half<T>) -> Point<T> {
    let (s, c) = (angle.full_sine(), angle.full_cosine());
    let u = planar.from.components();
    let sense = if planar.clockwise { -1.0 } else { 1.0 };
    let v = [-u[1] * sense, u[0] * sense];
    let at = |i: usize| {
        let value = c * T::of(u[i]) + s * T::of(v[i]);
        Jet { value, first: c * T::of(v[i]) - s * T::of(u[i]), second: -value }
    };
    [at(0), at(1)]
}

/// What places the bodies of a scene and is the same on the whole way.
#[derive(Debug, Clone)]
pub struct Layout<'a, T: Real> {
    scene: &'a Scene,
    n: &'a Numbers<'a, T>,
    lead: usize,
    start: Half<T>,
    /// For each joint: the direction of its line; zero where it has none.
    pub lines: SmallVec<[[T; 2]; 4]>,
    /// For each force: its direction, in space or from the axis of its body.
    pub pushes: SmallVec<[[T; 2]; 2]>,
    /// For each joint: how far along its line a wheel is at the start that rolls on it.
    starts: SmallVec<[T; 4]>,
    /// The cylinder on which the leading body moves.
    arc: Option<Arc<T>>,
}

/// The leading body on a cylinder.
#[derive(Debug, Clone, Copy)]
pub struct Arc<T> {
    /// The joint.
    pub joint: usize,
    /// Axis of the cylinder.
    pub axis: [T; 2],
    /// Distance of the centre of the body from it.
    pub apart: T,
    /// Angle that the body turns per angle of its centre, counted alike; 0 for what only slides.
    pub ratio: T,
}

/// A surface where a body touches it.
#[derive(Debug, Clone, Copy)]
pub struct Touch<T> {
    /// Unit vector from the surface to the body.
    pub normal: [T; 2],
    /// Unit vector along the surface, to the right of that.
    pub along: [T; 2],
    /// Radius of the wheel, negative where it touches on its inner side.
    pub radius: T,
    /// Curvature of the way of its centre, positive where it bends away from the normal.
    pub bend: T,
}

/// Where everything is when the leading body has turned to this angle; `None` for a body that the joints do not place.
///
/// At the start, what is not placed by joints is where its data say.
pub fn poses<T: Real>(scene: &Scene, n: &Numbers<T>, angle: &Half<T>, at_start: bool) -> Option<Poses<T>> {
    let layout = Layout::new(scene, n)?;
    let turned = angle.minus(layout.start);
    layout.poses(trig::angle(turned.sine, turned.cosine).scale2(1), at_start)
}

impl<'a, T: Real> Layout<'a, T> {
    /// Reads a scene; `None` if no body leads or a wheel has no place.
    pub fn new(scene: &'a Scene, n: &'a Numbers<'a, T>) -> Option<Self> {
        let lead = scene.lead()?;
        let none = [T::zero(); 2];
        let line = |kind: &JointKind| match *kind {
            JointKind::Guide { direction_deg, .. }
            | JointKind::Contact { surface: Surface::Line { direction_deg, .. }, .. } => {
                direction(n, direction_deg)
            }
            _ => none,
        };
        let arc = scene.joints.iter().enumerate().find_map(|(joint, j)| match j.kind {
            JointKind::Contact {
                at,
                radius_m,
                surface: Surface::Arc { centre_m, radius_m: arc, inside },
                rolls,
            } if at.body == lead => {
                let (own, arc) = (n.get(radius_m), n.get(arc));
                let apart = if inside { own - arc } else { arc + own };
                let ratio = plant!("pose: turn of a wheel on a cylinder", apart / own);
                let ratio = if rolls { ratio } else { T::zero() };
                Some(Arc { joint, axis: ground(n, centre_m), apart: apart.abs(), ratio })
            }
            _ => None,
        });
        let mut layout = Self {
            scene,
            n,
            lead,
            start: scene.start_angle(n),
            lines: scene.joints.iter().map(|j| line(&j.kind)).collect(),
            pushes: scene.pushes.iter().map(|p| direction(n, p.direction_deg)).collect(),
            starts: scene.joints.iter().map(|_| T::zero()).collect(),
            arc,
        };
        if scene.joints.iter().any(|j| matches!(j.kind, JointKind::Contact { rolls: true, .. })) {
            let first = layout.poses(T::zero(), true)?;
            for (j, joint) in scene.joints.iter().enumerate() {
                if let JointKind::Contact { at, surface: Surface::Line { through_m, .. }, .. } = joint.kind {
                    let centre = first[at.body].point(of_spot(scene, n, at));
                    let from = less(centre, fixed(ground(n, through_m)));
                    layout.starts[j] = dot(from, fixed(layout.lines[j])).value;
                }
            }
        }
        Some(layout)
    }
    /// The leading body's cylinder.
    pub const fn arc(&self) -> Option<&Arc<T>> {
        self.arc.as_ref()
    }
    /// Angle that the leading body turns per angle that leads.
    pub fn ratio(&self) -> T {
        self.arc.map_or_else(|| T::of(1.0), |arc| arc.ratio)
    }
    /// How a body touches the surface of a joint with its centre at this place.
    pub fn touch(&self, joint: usize, centre: [T; 2]) -> Option<Touch<T>> {
        let JointKind::Contact { radius_m, surface, .. } = self.scene.joints[joint].kind else { return None };
        let own = self.n.get(radius_m);
        let (normal, bend, radius) = match surface {
            Surface::Line { .. } => {
                let [c, s] = self.lines[joint];
                ([-s, c], T::zero(), own)
            }
            Surface::Arc { centre_m, radius_m, inside } => {
                // A hoop hangs on its inner side.
                let radius = if inside && self.n.get(radius_m).below(own) { -own } else { own };
                let axis = ground(self.n, centre_m);
                let out = [centre[0] - axis[0], centre[1] - axis[1]];
                let apart = (out[0].square() + out[1].square()).root();
                let sense = if inside { -1.0 } else { 1.0 };
                (out.map(|x| (x / apart).signed(sense)), (T::of(1.0) / apart).signed(sense), radius)
            }
        };
        Some(Touch { normal, along: [normal[1], -normal[0]], radius, bend })
    }
    /// Where everything is when the leading angle has changed by this, radians; `None` for a body that the joints do not place.
    ///
    /// At the start, what is not placed by joints is where its data say.
    pub fn poses(&self, way: T, at_start: bool) -> Option<Poses<T>> {
        let mut placer = Placer { layout: self, placed: self.scene.bodies.iter().map(|_| None).collect() };
        placer.lead(self.lead, way, at_start)?;
        while placer.placed.iter().any(Option::is_none) {
            let before = placer.placed.iter().flatten().count();
            for b in 0..self.scene.bodies.len() {
                if placer.placed[b].is_none() {
                    placer.follow(b, at_start);
                }
            }
            if placer.placed.iter().flatten().count() == before {
                return None;
            }
        }
        placer.placed.into_iter().collect()
    }
}

/// A line on which a body rolls: its joint, its centre along the axis, a place and the direction of the line, its radius.
type Track<T> = (usize, T, Point<T>, Point<T>, T);

struct Placer<'l, 'a, T: Real> {
    layout: &'l Layout<'a, T>,
    placed: SmallVec<[Option<Pose<T>>; 2]>,
}

impl<'a, T: Real> Placer<'_, 'a, T> {
    fn planar(&self, body: usize) -> Option<&'a Planar> {
        self.layout.scene.bodies[body].planar.as_ref()
    }
    /// Where a point of a body is that has a place.
    fn known(&self, spot: Spot) -> Option<Point<T>> {
        let pose = self.placed[spot.body]?;
        Some(pose.point(of_spot(self.layout.scene, self.layout.n, spot)))
    }
    /// Points of a body that are held at a known place: how far along its axis, and where.
    fn held(&self, body: usize) -> impl Iterator<Item = (T, Point<T>)> {
        self.layout.scene.joints.iter().filter_map(move |joint| {
            let (own, place) = match joint.kind {
                JointKind::Pin { at, place_m } => (at, fixed(ground(self.layout.n, place_m))),
                JointKind::Hinge { one, other } if one.body == body => (one, self.known(other)?),
                JointKind::Hinge { one, other } if other.body == body => (other, self.known(one)?),
                _ => return None,
            };
            (own.body == body).then(|| (of_spot(self.layout.scene, self.layout.n, own), place))
        })
    }
    /// Points of a body that are guided, itself or by a slider that is hinged there: how far along its axis, a place on the line
    /// and its direction.
    fn guided(&self, body: usize) -> impl Iterator<Item = (T, [T; 2], [T; 2])> {
        let joints = self.layout.scene.joints.iter().zip(&self.layout.lines);
        joints.filter_map(move |(joint, unit)| {
            let (at, through) = match joint.kind {
                JointKind::Guide { at, through_m, .. } => (at, ground(self.layout.n, through_m)),
                // The centre of a wheel is a radius off the line.
                JointKind::Contact { at, radius_m, surface: Surface::Line { through_m, .. }, .. } => {
                    let ([x, y], radius) = (ground(self.layout.n, through_m), self.layout.n.get(radius_m));
                    (at, [x - unit[1] * radius, y + unit[0] * radius])
                }
                _ => return None,
            };
            let own = if at.body == body { Some(at) } else { self.slider(at.body, body) }?;
            Some((of_spot(self.layout.scene, self.layout.n, own), through, *unit))
        })
    }
    /// The point of `body` that is hinged to a slider: a body that does not turn.
    fn slider(&self, slider: usize, body: usize) -> Option<Spot> {
        if self.layout.scene.bodies[slider].turns || self.placed[slider].is_some() {
            return None;
        }
        self.layout.scene.joints.iter().find_map(|joint| match joint.kind {
            JointKind::Hinge { one, other } if one.body == body && other.body == slider => Some(one),
            JointKind::Hinge { one, other } if other.body == body && one.body == slider => Some(other),
            _ => None,
        })
    }

    /// The line on which a body rolls.
    fn rolls(&self, body: usize) -> Option<Track<T>> {
        let layout = self.layout;
        layout.scene.joints.iter().enumerate().find_map(|(j, joint)| match joint.kind {
            JointKind::Contact { at, radius_m, surface: Surface::Line { through_m, .. }, rolls: true }
                if at.body == body =>
            {
                let through = fixed(ground(layout.n, through_m));
                let own = of_spot(layout.scene, layout.n, at);
                Some((j, own, through, fixed(layout.lines[j]), layout.n.get(radius_m)))
            }
            _ => None,
        })
    }

    fn lead(&mut self, body: usize, way: T, at_start: bool) -> Option<()> {
        let planar = self.planar(body)?;
        let layout = self.layout;
        let angle = layout.start.plus(Half::of_radians(way));
        let sense = if planar.clockwise { -1.0 } else { 1.0 };
        if let Some(arc) = &layout.arc {
            let JointKind::Contact { at, .. } = layout.scene.joints[arc.joint].kind else { return None };
            let out = axis(planar, &angle);
            let turned = layout.start.plus(Half::of_radians(way * arc.ratio));
            let [c, s] = axis(planar, &turned);
            let by = |x: Jet<T>| Jet {
                value: x.value,
                first: x.first * arc.ratio,
                second: x.second * arc.ratio.square(),
            };
            let centre = plus(fixed(arc.axis), times(out, arc.apart));
            let axis = [by(c), by(s)];
            let along = of_spot(layout.scene, layout.n, at);
            self.placed[body] = Some(Pose { origin: less(centre, times(axis, along)), axis });
            return Some(());
        }
        let axis = axis(planar, &angle);
        let free = self.held(body).next().is_none();
        if let (Some((_, along, through, unit, radius)), true) = (self.rolls(body), free) {
            let start = planar.origin_m.map_or_else(T::zero, |place| {
                let from = less(fixed(ground(layout.n, place)), through);
                dot(from, unit).value
            });
            let turned = Jet { value: way.signed(sense), first: T::of(sense), second: T::zero() };
            let ahead = turned.times(plant!("pose: way of a wheel on a line", -radius)) + Jet::fixed(start);
            let centre = plus(plus(through, scaled(unit, ahead)), times(left(unit), radius));
            self.placed[body] = Some(Pose { origin: less(centre, times(axis, along)), axis });
            return Some(());
        }
        let held = self.held(body).next();
        let mut guides = self.guided(body);
        let origin = match (held, guides.next(), guides.next(), planar.origin_m) {
            (Some((along, place)), ..) => less(place, times(axis, along)),
            (None, Some(one), Some(other), _) => {
                // origin + s axis lies on each line: two equations for the origin.
                let row = |(along, through, direction): (T, [T; 2], [T; 2])| {
                    let normal = left(fixed(direction));
                    (normal, dot(normal, fixed(through)) - dot(normal, axis).times(along))
                };
                let ((p, a), (q, b)) = (row(one), row(other));
                let area = p[0] * q[1] - p[1] * q[0];
                [(a * q[1] - b * p[1]) / area, (b * p[0] - a * q[0]) / area]
            }
            (None, Some((along, through, direction)), None, origin)
                if at_start || layout.scene.drifts().is_some() =>
            {
                // Nothing moves the mass centre along the line.
                let centre = self::along(self.layout.n, planar.centre);
                let unit = fixed(direction);
                let start = origin.map_or_else(T::zero, |place| {
                    let place = fixed(ground(self.layout.n, place));
                    dot(less(place, fixed(through)), unit).value
                });
                let across = -dot(left(unit), axis).times(along);
                let ahead = Jet::fixed(start) - dot(unit, axis).times(centre);
                plus(fixed(through), plus(scaled(unit, ahead), scaled(left(unit), across)))
            }
            (None, None, _, Some(place)) if at_start => fixed(ground(self.layout.n, place)),
            _ => return None,
        };
        drop(guides);
        self.placed[body] = Some(Pose { origin, axis });
        Some(())
    }

    /// Places a body beside those that have a place, if its joints do.
    fn follow(&mut self, body: usize, at_start: bool) -> Option<()> {
        let planar = self.planar(body)?;
        let branch = if planar.side == Branch::Ahead { 1.0 } else { -1.0 };
        let held = self.held(body).next();
        if !self.layout.scene.bodies[body].turns {
            let (along, place) = held?;
            let axis = fixed(planar.from.components().map(T::of));
            self.placed[body] = Some(Pose { origin: less(place, times(axis, along)), axis });
            return Some(());
        }
        if let (true, Some(start)) = (at_start, planar.start_deg) {
            let half = Half::of_degrees(self.layout.n.get(start));
            // What leads elsewhere moves it: its own angle is known at the start alone.
            let axis = axis(planar, &half).map(|x| Jet::fixed(x.value));
            let origin = match (held, planar.origin_m) {
                (Some((along, place)), _) => less(place, times(axis, along)),
                (None, Some(place)) => fixed(ground(self.layout.n, place)),
                _ => return None,
            };
            self.placed[body] = Some(Pose { origin, axis });
            return Some(());
        }
        let (along, place) = held?;
        if let Some((joint, own, through, unit, radius)) = self.rolls(body)
            && own.same(along)
        {
            // Its turn goes with the way of its centre.
            let ahead = dot(less(place, through), unit) - Jet::fixed(self.layout.starts[joint]);
            let turned = -ahead.times(T::of(1.0) / radius);
            let start = planar.start_deg.map_or_else(T::zero, |x| self.layout.n.get(x));
            let [c, s] = axis(planar, &Half::of_degrees(start)).map(|x| x.value);
            let (sine, cosine) = trig::turn(turned.value);
            let now = [c * cosine - s * sine, s * cosine + c * sine];
            let by = |x: T, across: T| Jet {
                value: x,
                first: across * turned.first,
                second: across * turned.second - x * turned.first.square(),
            };
            let axis = [by(now[0], -now[1]), by(now[1], now[0])];
            self.placed[body] = Some(Pose { origin: less(place, times(axis, along)), axis });
            return Some(());
        }
        let guided = self.guided(body).next();
        if let Some((other, through, direction)) = guided {
            let unit = fixed(direction);
            let reach = other - along;
            let across = dot(left(unit), less(fixed(through), place)).times(T::of(1.0) / reach);
            let ahead =
                (Jet::fixed(T::of(1.0)) - across * across).root().times(T::of(branch).signed(reach.sign()));
            let axis = plus(scaled(left(unit), across), scaled(unit, ahead));
            self.placed[body] = Some(Pose { origin: less(place, times(axis, along)), axis });
            return Some(());
        }
        // The other rod of the pair, where both are hinged, and where that one is held.
        let (own, other, far) = self.layout.scene.joints.iter().find_map(|joint| {
            let JointKind::Hinge { one, other } = joint.kind else { return None };
            let (own, other) = if one.body == body { (one, other) } else { (other, one) };
            if own.body != body
                || self.placed[other.body].is_some()
                || !self.layout.scene.bodies[other.body].turns
            {
                return None;
            }
            Some((own, other, self.held(other.body).next()?))
        })?;
        let (first, second) = (
            of_spot(self.layout.scene, self.layout.n, own) - along,
            of_spot(self.layout.scene, self.layout.n, other) - far.0,
        );
        let apart = less(far.1, place);
        let square = dot(apart, apart);
        let ahead = (square + Jet::fixed(first.square() - second.square())) / square;
        let ahead = ahead.times(T::of(0.5));
        let across = (Jet::fixed(first.square()) / square - ahead * ahead).root().times(T::of(branch));
        let joint = plus(scaled(apart, ahead), scaled(left(apart), across));
        let one = times(joint, T::of(1.0) / first);
        let two = times(less(joint, apart), T::of(1.0) / second);
        self.placed[body] = Some(Pose { origin: less(place, times(one, along)), axis: one });
        self.placed[other.body] = Some(Pose { origin: less(far.1, times(two, far.0)), axis: two });
        Some(())
    }
}
