//! Poses of bodies in the plane as functions of one angle, with their first and second derivative by it: one function for each way
//! in which joints can place a body.
//!
//! One body leads: its angle is given. It hangs on a pin, or slides with two points in two guides, or with one in a guide while
//! nothing moves its mass centre along it. Each other body is placed by what already has a place: hinged there and guided at
//! another point (a circle and a line), or hinged there and to a second body that is (two circles).
use crate::num::half::Half;
use crate::num::{Jet, Real, trig};
use crate::scene::{Branch, JointKind, Num, Numbers, Place, Planar, Scene, Spot};
use smallvec::SmallVec;

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

/// Where everything is when the leading body has turned to this angle; `None` for a body that the joints do not place.
///
/// At the start, what is not placed by joints is where its data say.
pub fn poses<T: Real>(scene: &Scene, n: &Numbers<T>, angle: &Half<T>, at_start: bool) -> Option<Poses<T>> {
    let lead = scene.lead()?;
    let mut placer = Placer { scene, n, placed: scene.bodies.iter().map(|_| None).collect() };
    placer.lead(lead, angle, at_start)?;
    while placer.placed.iter().any(Option::is_none) {
        let before = placer.placed.iter().flatten().count();
        for b in 0..scene.bodies.len() {
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

struct Placer<'a, T: Real> {
    scene: &'a Scene,
    n: &'a Numbers<'a, T>,
    placed: SmallVec<[Option<Pose<T>>; 2]>,
}

impl<T: Real> Placer<'_, T> {
    fn planar(&self, body: usize) -> Option<&Planar> {
        self.scene.bodies[body].planar.as_ref()
    }
    /// Where a point of a body is that has a place.
    fn known(&self, spot: Spot) -> Option<Point<T>> {
        let pose = self.placed[spot.body]?;
        Some(pose.point(of_spot(self.scene, self.n, spot)))
    }
    /// Points of a body that are held at a known place: how far along its axis, and where.
    fn held(&self, body: usize) -> impl Iterator<Item = (T, Point<T>)> {
        self.scene.joints.iter().filter_map(move |joint| {
            let (own, place) = match joint.kind {
                JointKind::Pin { at, place_m } => (at, fixed(ground(self.n, place_m))),
                JointKind::Hinge { one, other } if one.body == body => (one, self.known(other)?),
                JointKind::Hinge { one, other } if other.body == body => (other, self.known(one)?),
                _ => return None,
            };
            (own.body == body).then(|| (of_spot(self.scene, self.n, own), place))
        })
    }
    /// Points of a body that are guided, itself or by a slider that is hinged there: how far along its axis, a place on the line
    /// and its direction.
    fn guided(&self, body: usize) -> impl Iterator<Item = (T, [T; 2], [T; 2])> {
        self.scene.joints.iter().filter_map(move |joint| {
            let JointKind::Guide { at, through_m, direction_deg, .. } = joint.kind else { return None };
            let own = if at.body == body { Some(at) } else { self.slider(at.body, body) }?;
            let line = (ground(self.n, through_m), direction(self.n, direction_deg));
            Some((of_spot(self.scene, self.n, own), line.0, line.1))
        })
    }
    /// The point of `body` that is hinged to a slider: a body that does not turn.
    fn slider(&self, slider: usize, body: usize) -> Option<Spot> {
        if self.scene.bodies[slider].turns || self.placed[slider].is_some() {
            return None;
        }
        self.scene.joints.iter().find_map(|joint| match joint.kind {
            JointKind::Hinge { one, other } if one.body == body && other.body == slider => Some(one),
            JointKind::Hinge { one, other } if other.body == body && one.body == slider => Some(other),
            _ => None,
        })
    }

    fn lead(&mut self, body: usize, angle: &Half<T>, at_start: bool) -> Option<()> {
        let planar = self.planar(body)?;
        let axis = axis(planar, angle);
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
            (None, Some((along, through, direction)), None, origin) => {
                // Nothing moves the mass centre along the line.
                let centre = self::along(self.n, planar.centre);
                let unit = fixed(direction);
                let start = origin.map_or_else(T::zero, |place| {
                    let place = fixed(ground(self.n, place));
                    dot(less(place, fixed(through)), unit).value
                });
                let across = -dot(left(unit), axis).times(along);
                let ahead = Jet::fixed(start) - dot(unit, axis).times(centre);
                plus(fixed(through), plus(scaled(unit, ahead), scaled(left(unit), across)))
            }
            (None, None, _, Some(place)) if at_start => fixed(ground(self.n, place)),
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
        if !self.scene.bodies[body].turns {
            let (along, place) = held?;
            let axis = fixed(planar.from.components().map(T::of));
            self.placed[body] = Some(Pose { origin: less(place, times(axis, along)), axis });
            return Some(());
        }
        if let (true, Some(start)) = (at_start, planar.start_deg) {
            let half = Half::of_degrees(self.n.get(start));
            // What leads elsewhere moves it: its own angle is known at the start alone.
            let axis = axis(planar, &half).map(|x| Jet::fixed(x.value));
            let origin = match (held, planar.origin_m) {
                (Some((along, place)), _) => less(place, times(axis, along)),
                (None, Some(place)) => fixed(ground(self.n, place)),
                _ => return None,
            };
            self.placed[body] = Some(Pose { origin, axis });
            return Some(());
        }
        let (along, place) = held?;
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
        let (own, other, far) = self.scene.joints.iter().find_map(|joint| {
            let JointKind::Hinge { one, other } = joint.kind else { return None };
            let (own, other) = if one.body == body { (one, other) } else { (other, one) };
            if own.body != body || self.placed[other.body].is_some() || !self.scene.bodies[other.body].turns {
                return None;
            }
            Some((own, other, self.held(other.body).next()?))
        })?;
        let (first, second) =
            (of_spot(self.scene, self.n, own) - along, of_spot(self.scene, self.n, other) - far.0);
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
