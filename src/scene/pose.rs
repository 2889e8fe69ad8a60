//! Poses of bodies in the plane as functions of one angle, with their first and second derivative by it: one function for each way
//! in which joints can place a body.
//!
//! One body leads: its angle is given. It hangs on a pin, or slides with two points in two guides, or with one in a guide while
//! nothing moves its mass centre along it. Each other body is placed by what already has a place: hinged there and guided at
//! another point (a circle and a line), or hinged there and to a second body that is (two circles). A wheel that rolls on a line
//! turns with the way of its centre; one that leads on a cylinder is told by the angle of its centre. A cord or a light rod guides
//! its point on a circle, as long as it is at the start.
mod plan;
mod springs;

use crate::num::half::Half;
use crate::num::jet::Followed;
use crate::num::plant::plant;
use crate::num::{Dd, Jet, Real, U, root, trig};
use crate::scene::admissible::TURNS;
use crate::scene::numbers::BodyNumbers;
use crate::scene::pose::plan::Planner;
use crate::scene::{
    Arrives, Coordinate, Degree, End, Joint, JointKind, Num, Numbers, Place, Planar, Ray, Rest, Scene, Spot,
    Straight, Strut, Surface,
};
use smallvec::{SmallVec, smallvec};
use std::borrow::Cow;
use std::ops::{Add, Mul, Neg, Sub};

/// A point of the plane with its derivatives, or a vector.
pub type Point<T> = [Jet<T>; 2];

/// Where a body is: the origin of its axis, and the direction of its axis as a unit vector; each number with its derivatives
/// ([`Jet`]) or alone.
#[derive(Debug, Clone, Copy)]
pub struct Pose<X> {
    /// Origin of the axis, m.
    pub origin: [X; 2],
    /// Direction of the axis.
    pub axis: [X; 2],
}

/// One pose for each body in the plane.
pub type Poses<X> = SmallVec<[Pose<X>; 3]>;

impl<X: Copy> Pose<X> {
    /// The point at these distances along the axis and to its left.
    pub fn point<T: Real>(&self, at: [T; 2]) -> [X; 2]
    where
        X: Followed<T>,
    {
        plus(self.origin, from_origin(self.axis, at))
    }
    /// The distances of a place from the origin of the axis, along it and to its left.
    pub fn within<T: Real>(&self, place: [X; 2]) -> [X; 2]
    where
        X: Followed<T>,
    {
        let from = less(place, self.origin);
        [dot(from, self.axis), dot(from, left(self.axis))]
    }
    /// With this point at this place.
    fn through<T: Real>(axis: [X; 2], at: [T; 2], place: [X; 2]) -> Self
    where
        X: Followed<T>,
    {
        Self { origin: less(place, from_origin(axis, at)), axis }
    }
}

impl<T: Real> Pose<Jet<T>> {
    /// Where it is, without the derivatives.
    pub fn here(&self) -> Pose<T> {
        Pose { origin: self.origin.map(|x| x.value), axis: self.axis.map(|x| x.value) }
    }
    /// Rate and second derivative of the angle of the axis, counter-clockwise positive.
    pub fn turn(&self) -> (T, T) {
        let [c, s] = self.axis;
        (c.value * s.first - s.value * c.first, c.value * s.second - s.value * c.second)
    }
}

fn plus<X: Copy + Add<Output = X>>(a: [X; 2], b: [X; 2]) -> [X; 2] {
    [a[0] + b[0], a[1] + b[1]]
}
/// `a - b`
pub fn less<X: Copy + Sub<Output = X>>(a: [X; 2], b: [X; 2]) -> [X; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
fn times<T: Real, X: Followed<T>>(a: [X; 2], by: T) -> [X; 2] {
    [a[0].by(by), a[1].by(by)]
}
fn scaled<X: Copy + Mul<Output = X>>(a: [X; 2], by: X) -> [X; 2] {
    [a[0] * by, a[1] * by]
}
/// The scalar product.
pub fn dot<X: Copy + Add<Output = X> + Mul<Output = X>>(a: [X; 2], b: [X; 2]) -> X {
    a[0] * b[0] + a[1] * b[1]
}
/// A vector of this length along a fixed direction.
fn along_unit<T: Real, X: Followed<T>>(unit: [T; 2], length: X) -> [X; 2] {
    [length.by(unit[0]), length.by(unit[1])]
}
/// The component along a fixed direction.
fn component<T: Real, X: Followed<T>>(a: [X; 2], unit: [T; 2]) -> X {
    a[0].by(unit[0]) + a[1].by(unit[1])
}
/// From the origin of an axis to the point at these distances along it and to its left.
fn from_origin<T: Real, X: Followed<T>>(axis: [X; 2], [along, aside]: [T; 2]) -> [X; 2] {
    let along = times(axis, along);
    if aside.is_zero() { along } else { plus(along, times(left(axis), aside)) }
}
/// How far one point of a body is from another, told by the distances between them along its axis and to its left.
fn reach<T: Real>(d: [T; 2]) -> T {
    if d[1].is_zero() { d[0] } else { (d[0].square() + d[1].square()).root() }
}
/// The axis of a body of which two points lie apart as [`reach`] says, along this direction.
fn axis_of<T: Real, X: Followed<T>>(along: [X; 2], d: [T; 2]) -> [X; 2] {
    if d[1].is_zero() {
        return along;
    }
    let per = T::of(1.0) / reach(d);
    less(times(along, d[0] * per), times(left(along), d[1] * per))
}
/// How far the point at these distances along an axis and to its left is from its origin, in this direction.
fn across<T: Real, X: Followed<T>>(direction: [T; 2], axis: [X; 2], at: [T; 2]) -> X {
    component(from_origin(axis, at), direction)
}
/// How far two places are apart.
fn off<T: Real>(to: [T; 2], from: [T; 2]) -> f64 {
    let [x, y] = less(to, from).map(|x| x.size());
    (x * x + y * y).sqrt()
}
/// Do two lines never meet?
fn parallel<T: Real>(one: [T; 2], other: [T; 2]) -> bool {
    (one[0] * other[1] - one[1] * other[0]).size() < LEVEL
}
/// What is left of the square over the long side of a right triangle; nothing where the triangle has folded up, as far as the
/// rounding of printed lengths lets it be seen: there it could open to either side, and it has no rate.
fn open<T: Real, X: Followed<T>>(long: X, leg: X) -> X {
    let left = long - leg;
    let folded = left.here().size() <= 8.0 * U * long.here().size();
    if folded { X::still(T::zero()) } else { left }
}
/// From the one end of a side of a triangle to its third corner, on the left of that side or (-1) on its right: the lengths of the
/// other sides are given.
fn triangle<T: Real, X: Followed<T>>(side: [X; 2], [first, second]: [T; 2], branch: f64) -> [X; 2] {
    let square = dot(side, side);
    let ahead = (square + X::still(first.square() - second.square())) / square;
    let ahead = ahead.by(T::of(0.5));
    let across = open(X::still(first.square()) / square, ahead * ahead).square_root();
    plus(scaled(side, ahead), scaled(left(side), across.by(T::of(branch))))
}
/// The direction in which a line lies at this distance, along its unit vector or (-1) against it; `way` leads to a place on it.
fn toward<T: Real, X: Followed<T>>(way: [X; 2], distance: T, unit: [T; 2], branch: f64) -> [X; 2] {
    let normal = left(unit);
    let across = component(way, normal).by(T::of(1.0) / distance);
    let ahead = open(X::still(T::of(1.0)), across * across).square_root();
    plus(along_unit(normal, across), along_unit(unit, ahead.by(T::of(branch))))
}
/// A vector a quarter turn to the left.
fn left<X: Copy + Neg<Output = X>>(a: [X; 2]) -> [X; 2] {
    [-a[1], a[0]]
}
fn fixed<T: Real, X: Followed<T>>(a: [T; 2]) -> [X; 2] {
    [X::still(a[0]), X::still(a[1])]
}

/// A distance along the axis.
pub fn along<T: Real>(n: &Numbers<T>, place: Place) -> T {
    match place {
        Place::At(x) => n.get(x),
        Place::HalfOf(x) => n.get(x).scale2(-1),
    }
}

/// Distances of a named point from the origin of its body's axis, along it and to its left.
pub fn of_spot<T: Real>(scene: &Scene, n: &Numbers<T>, spot: Spot) -> [T; 2] {
    let planar = scene.bodies[spot.body].planar.as_ref();
    let place = planar.and_then(|p| p.points.get(spot.point));
    place.map_or_else(|| [T::zero(); 2], |(_, [ahead, aside])| [along(n, *ahead), along(n, *aside)])
}

/// A fixed place.
pub fn ground<T: Real>(n: &Numbers<T>, place: [Num; 2]) -> [T; 2] {
    [n.get(place[0]), n.get(place[1])]
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

/// How far an axis has turned from a direction, in the sense in which the angle of its body counts: less than half a turn.
pub fn turned_from<T: Real>(planar: &Planar, axis: [T; 2], from: [T; 2]) -> T {
    let (along, across) = (dot(from, axis), from[0] * axis[1] - from[1] * axis[0]);
    // At half a turn it is open which way it has turned.
    if across.size() < LEVEL && along.sign() < 0.0 {
        return T::of(f64::NAN);
    }
    trig::angle(across, along).signed(planar.sense())
}

/// A joint holds whose points are no farther apart than this share of the size of everything: printed decimals of a place are rounded.
const MET: f64 = 1e-9;

/// Below this sine a line is level.
const LEVEL: f64 = 1e-12;

/// 1 where a direction leads up, or to the right on a level, else -1: the sense in which friction along it is told.
pub fn upward<T: Real>([c, s]: [T; 2]) -> f64 {
    if s.size() < LEVEL { c.sign() } else { s.sign() }
}

/// Direction of an axis at this angle, as the angle of the body counts.
fn axis<T: Real>(planar: &Planar, angle: &Half<T>) -> [T; 2] {
    facing(planar, [angle.full_cosine(), angle.full_sine()])
}
/// The same at the angle of this cosine and sine.
fn facing<T: Real>(planar: &Planar, [c, s]: [T; 2]) -> [T; 2] {
    let s = s.signed(planar.sense());
    match planar.from {
        Ray::Right => [c, s],
        Ray::Up => [-s, c],
        Ray::Left => [-c, -s],
        Ray::Down => [s, -c],
    }
}
/// A direction with its derivatives where it turns counter-clockwise at this rate, by the leading angle, and with this derivative
/// of it.
fn turning<T: Real, X: Followed<T>>(direction: [T; 2], rate: T, second: T) -> [X; 2] {
    let across = left(direction);
    let of = |here: T, across: T| X::with(here, || [across * rate, across * second - here * rate.square()]);
    [of(direction[0], across[0]), of(direction[1], across[1])]
}

/// A direction turned counter-clockwise by an angle.
fn rolled<T: Real, X: Followed<T>>([c, s]: [T; 2], by: X) -> [X; 2] {
    let (sine, cosine) = trig::turn(by.here());
    let now = [c * cosine - s * sine, s * cosine + c * sine];
    let [rate, second] = by.derivatives();
    turning(now, rate, second)
}
/// A body of which one point lies on a circle, on this side, while its axis has this direction and another point is guided too.
fn around<T: Real, X: Followed<T>>(
    axis: [X; 2],
    first: &Guided<T>,
    second: &Guided<T>,
    branch: f64,
) -> Option<Pose<X>> {
    let (centre, radius) = (fixed(first.through), first.ring?);
    // From the point on the circle to the other one.
    let beyond = from_origin(axis, less(second.at, first.at));
    let way = less(less(fixed(second.through), beyond), centre);
    let out = match second.ring {
        Some(far) => triangle(way, [radius, far], branch),
        None => times(toward(way, radius, second.unit, branch), radius),
    };
    Some(Pose::through(axis, first.at, plus(centre, out)))
}

/// What places the bodies of a scene and is the same on the whole way.
#[derive(Debug, Clone)]
pub struct Layout<'a, T: Real> {
    /// The scene.
    pub scene: &'a Scene,
    n: &'a Numbers<'a, T>,
    lead: usize,
    start: Half<T>,
    /// For each joint: the direction of its line, seen from the axis of the body that carries it; zero where it has none.
    pub lines: SmallVec<[[T; 2]; 4]>,
    /// For each force: its direction, in space or from the axis of its body.
    pushes: SmallVec<[[T; 2]; 2]>,
    /// Natural length of each spring; 0 of a torsion spring.
    pub natural: SmallVec<[T; 2]>,
    /// Of each torsion spring the direction of the axis of its body at which it is relaxed.
    relaxed_axes: SmallVec<[[T; 2]; 2]>,
    /// For each joint: how far along its line a wheel is at the start that rolls on it, or how long a cord or a light rod is.
    starts: SmallVec<[T; 4]>,
    /// Where everything is at the start, if cords or light rods guide on the way.
    first: Option<Poses<T>>,
    /// The cylinder on which the leading body moves.
    arc: Option<Arc<T>>,
    /// Where an instant is asked and two guides carry the leading body along without a turn: their direction, and how much its way
    /// bends to the left of it.
    glide: Option<([T; 2], T)>,
    /// How the bodies are placed on the way, one after the other; `None` if the joints do not place all.
    steps: Option<Steps<T>>,
    /// In how many turns an end is looked for.
    turns: f64,
}

/// A body and how it is placed.
type BodyStep<T> = (usize, Step<T>);
/// The same of all bodies: apart, for a step is large, and they are handed about at each place.
type Steps<T> = Vec<BodyStep<T>>;

/// A place that is known: fixed, or that of a point of a body that is placed before.
#[derive(Debug, Clone, Copy)]
enum Known<T> {
    Fixed([T; 2]),
    Of(usize, [T; 2]),
}

impl<T: Real> Known<T> {
    /// Where it is, as these bodies lie.
    fn among<X: Followed<T>>(self, poses: &Poses<X>) -> [X; 2] {
        match self {
            Self::Fixed(place) => fixed(place),
            Self::Of(body, at) => poses[body].point(at),
        }
    }
}

/// A point of a body at a known place: how far along and beside its axis, and where.
#[derive(Debug, Clone, Copy)]
struct Held<T> {
    at: [T; 2],
    place: Known<T>,
}

/// A point of a body that is guided: how far along and beside its axis, a place on the line and its direction; or the centre of
/// the circle that holds it, with its radius.
#[derive(Debug, Clone, Copy)]
struct Guided<T> {
    at: [T; 2],
    through: [T; 2],
    unit: [T; 2],
    ring: Option<T>,
}

/// A line on which a body rolls: its centre along and beside the axis, a place and the direction of the line, its radius.
#[derive(Debug, Clone, Copy)]
struct Track<T> {
    joint: usize,
    at: [T; 2],
    through: Known<T>,
    unit: [T; 2],
    radius: T,
}

/// A line on which a place lies that is so far from what it places: its normal, and how far it lies along that, which is the sum of how
/// far known places lie along vectors, a distance and what the turn of the leading body adds. Normal and vectors turn with a body.
#[derive(Debug, Clone, Copy)]
struct Line<T> {
    normal: [T; 2],
    own: [T; 2],
    to: [([T; 2], Known<T>); 2],
    far: T,
    turn: T,
    with: Option<usize>,
}

impl<T: Real> Line<T> {
    /// Its normal and how far it lies along it, after this way of what leads.
    fn among<X: Followed<T>>(&self, way: T, poses: &Poses<X>) -> ([X; 2], X) {
        let unit = |unit| self.with.map_or_else(|| fixed(unit), |body| from_origin(poses[body].axis, unit));
        let [one, other] = self.to.map(|(along, place)| dot(unit(along), place.among(poses)));
        let turned = X::with(self.far + way * self.turn, || [self.turn, T::zero()]);
        let normal = unit(self.normal);
        (normal, one + other + turned - component(normal, self.own))
    }
}

/// The place where two lines meet.
fn crossing<T: Real, X: Followed<T>>([(p, a), (q, b)]: [([X; 2], X); 2]) -> [X; 2] {
    let per_area = X::still(T::of(1.0)) / (p[0] * q[1] - p[1] * q[0]);
    [a * q[1] - b * p[1], b * p[0] - a * q[0]].map(|x| x * per_area)
}

/// A point on a line, on one side of where its cord comes from: how far along and beside the axis, the foot of that place on the line, how
/// far it is off the line, the direction to the point; the joint, and the other end of the cord with the place to which it leads.
#[derive(Debug, Clone, Copy)]
struct Hung<T> {
    at: [T; 2],
    foot: [T; 2],
    off: T,
    unit: [T; 2],
    joint: usize,
    other: (Spot, [Num; 2]),
}

/// How a body is placed.
#[derive(Debug, Clone, Copy)]
enum Step<T> {
    /// It leads on a cylinder, with its centre so far along and beside its axis.
    Arc([T; 2]),
    /// It leads and rolls on a line, from so far along it.
    Wheel(Track<T>, T),
    /// It leads about a point.
    Leads(Held<T>),
    /// It leads by its way along two guides, from this place in this direction, on a way that bends so to its left at the start.
    Glides([T; 2], [T; 2], T),
    /// It leads in two guides, on this side where one of them is a circle.
    Slides([Guided<T>; 2], f64),
    /// It leads in a guide along which nothing moves its mass centre, which is so far along its axis: from so far along the guide.
    Drops(Guided<T>, T, T),
    /// It is welded to a body with its axis turned so from that one's.
    Welded(Held<T>, usize, [T; 2]),
    /// Its axis has this direction.
    Still(Held<T>, [T; 2]),
    /// It does not turn: its axis has this direction, and what is left of a cord from another body places it on its guide.
    Hangs([T; 2], Hung<T>),
    /// It rolls on a line, and its axis has this direction at the start.
    Rolls(Held<T>, Track<T>, [T; 2]),
    /// A point of it lies where two lines meet; it rolls on a line if any, and its axis has this direction at the start.
    Crosses([T; 2], [Line<T>; 2], Option<Track<T>>, [T; 2]),
    /// Its centre goes about the axis of a gear with the turn of the leading body, and it meshes there: how far it turns per turn of that,
    /// and the direction of its axis at the start.
    Orbits(Held<T>, T, [T; 2]),
    /// Another point of it is guided, on this side.
    Rod(Held<T>, Guided<T>, f64),
    /// A line of it goes through a known place: its direction from the axis, how far that place is to its left of where the body is
    /// held, and on this side.
    Slot(Held<T>, Known<T>, ([T; 2], T), f64),
    /// It is hinged to a second rod, at these distances of the hinge from where they are held, on this side.
    Pair(Held<T>, usize, Held<T>, [[T; 2]; 2], f64),
}

impl<T: Real> Step<T> {
    /// The body that it places besides.
    const fn partner(&self) -> Option<usize> {
        if let Self::Pair(_, other, ..) = self { Some(*other) } else { None }
    }
    /// The other place that the joints leave the body, if they leave two, and the point that tells them apart.
    fn other_side(self) -> Option<(Self, [T; 2])> {
        Some(match self {
            Self::Slides([one, other], branch) if one.ring.is_some() || other.ring.is_some() => {
                let at = if one.ring.is_some() { one.at } else { other.at };
                (Self::Slides([one, other], -branch), at)
            }
            Self::Rod(held, guide, branch) => (Self::Rod(held, guide, -branch), guide.at),
            Self::Slot(held, through, line, branch) => {
                (Self::Slot(held, through, line, -branch), plus(held.at, line.0))
            }
            Self::Pair(held, other, far, own, branch) => {
                (Self::Pair(held, other, far, own, -branch), plus(held.at, own[0]))
            }
            _ => return None,
        })
    }
}

/// What the joints could place in two ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// The point of the body that lies on one side or the other.
    pub at: Spot,
    /// Where it is, m.
    pub here: [f64; 2],
    /// Where it would be on the other side, m.
    pub there: [f64; 2],
    /// Is it a parallelogram there, and crossed here?
    pub crossed: bool,
}

/// A body that cannot be put between the places that hold it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// The body.
    pub body: usize,
    /// The one with which it is hinged in between.
    pub other: Option<usize>,
    /// How far those places are apart, m.
    pub apart_m: f64,
    /// The most that it bridges, or the least, m.
    pub bridged_m: f64,
}

/// What a motion does not pass: its end has to come before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Obstacle {
    /// This torsion spring is wound by half a turn, where its moment has two senses.
    Wound(usize),
    /// The load on the cord of this joint comes to its pulley, from where it could go either way.
    Pulley(usize),
    /// These two hinged bodies lie in one line, from where they could go on in two ways.
    InLine(usize, usize),
    /// This body lies across its guide, likewise.
    Across(usize),
    /// The point in the slot of this body is at its pin, likewise.
    AtPin(usize),
    /// This point passes through the surface of a joint: an impact.
    Strikes(Spot, usize),
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

impl<T: Real> Arc<T> {
    /// The cylinder of this joint.
    fn of(scene: &Scene, n: &Numbers<T>, joint: usize) -> Option<Self> {
        let JointKind::Contact {
            radius_m,
            surface: Surface::Arc { centre_m, radius_m: arc, inside, .. },
            rolls,
            ..
        } = scene.joints[joint].kind
        else {
            return None;
        };
        let (own, arc) = (n.get(radius_m), n.get(arc));
        let apart = if inside { own - arc } else { arc + own };
        let ratio = plant!("pose: turn of a wheel on a cylinder", apart / own);
        let ratio = if rolls { ratio } else { T::zero() };
        Some(Self { joint, axis: ground(n, centre_m), apart: apart.abs(), ratio })
    }
}

/// A surface where a body touches it.
#[derive(Debug, Clone, Copy)]
pub struct Touch<T, X> {
    /// Unit vector from the surface to the body.
    pub normal: [X; 2],
    /// Unit vector along the surface, in the sense in which friction is told; of teeth, to the right of that.
    pub along: [X; 2],
    /// Radius of the wheel, negative where it touches on its inner side, and where the surface rises to the left.
    pub radius: T,
    /// The same, whichever side the surface rises to.
    pub rim: T,
    /// Curvature of the way of its centre, positive where it bends away from the normal.
    pub bend: X,
}

/// Sum of all weights and of what springs exert that are stretched by the size of everything, N: what forces are small beside.
pub fn pulls<T: Real>(scene: &Scene, n: &Numbers<T>) -> f64 {
    let size = size(scene, n);
    let weights: f64 = n.bodies.iter().map(|b| (b.mass * n.gravity).size()).sum();
    let spring = |s: &Strut| n.massive(s.stiffness_n_m).size() * if s.twists() { 1.0 / size } else { size };
    weights + scene.struts.iter().map(spring).sum::<f64>()
}

/// Sum of the magnitudes of all impulses that strike, and of the momenta before an impact, N s: what impulses are small beside.
pub fn blows<T: Real>(scene: &Scene, n: &Numbers<T>) -> f64 {
    let momentum = |(b, arrives): (usize, Arrives)| {
        let fastest = n.get(arrives.speed_m_s).size() + n.get(arrives.spin_rad_s).size() * size(scene, n);
        n.bodies[b].mass.size() * fastest
    };
    let blows = scene.pushes.iter().filter(|p| p.blow);
    blows.map(|p| n.massive(p.force_n).size()).chain(scene.arrivals().map(momentum)).sum()
}

/// How far a body of the plane reaches from the origin of its axes, m.
pub fn extent<T: Real>(scene: &Scene, n: &Numbers<T>, body: usize) -> f64 {
    let Some(planar) = scene.planar(body) else { return 0.0 };
    let points = planar.points.iter().map(|(_, at)| at.map(|x| along(n, x).size()).iter().sum());
    points.fold(along(n, planar.centre).size(), f64::max)
}

/// Sum of what each body reaches, from the origin of its axes to its farthest point, and of radii, m: what lengths and speeds are small
/// beside.
pub fn size<T: Real>(scene: &Scene, n: &Numbers<T>) -> f64 {
    let rods: f64 = (0..scene.bodies.len()).map(|body| extent(scene, n, body)).sum();
    let round = scene.joints.iter().map(|joint| match joint.kind {
        JointKind::Contact { radius_m, surface: Surface::Arc { radius_m: arc, .. }, .. } => {
            n.get(radius_m).size() + n.get(arc).size()
        }
        JointKind::Contact { radius_m, .. } => n.get(radius_m).size(),
        _ => 0.0,
    });
    let sum = rods + round.sum::<f64>();
    // A disc about its centre reaches nowhere: it has a radius of gyration; a block that does not turn is where it is placed.
    let gyration = |b: &BodyNumbers<T>| (b.inertia / b.mass).root().size();
    let placed = scene.bodies.iter().filter_map(|b| b.planar.as_ref()?.origin_m).flatten();
    let spread = || n.bodies.iter().map(gyration).chain(placed.map(|x| n.get(x).size())).sum();
    if sum > 0.0 { sum } else { spread() }
}

/// Where everything is when the leading body has turned to this angle; `None` for a body that the joints do not place.
///
/// At the start, what is not placed by joints is where its data say.
pub fn poses<T: Real>(scene: &Scene, n: &Numbers<T>, angle: &Half<T>, at_start: bool) -> Option<Poses<T>> {
    let layout = Layout::new(scene, n)?;
    let turned = angle.minus(layout.start);
    layout.poses(trig::angle(turned.sine, turned.cosine).scale2(1), at_start)
}

/// The first body that is not where another motion left it, where this one begins, and by how much, m.
pub fn moved<T: Real>(left: (&Scene, &Numbers<T>), begins: (&Scene, &Numbers<T>)) -> Option<(usize, f64)> {
    let angle = begins.0.start_angle(begins.1);
    let [before, after] =
        [(left, false), (begins, true)].map(|((scene, n), at_start)| poses(scene, n, &angle, at_start));
    let size = size(begins.0, begins.1);
    let apart = |(a, b): (Pose<T>, Pose<T>)| off(a.origin, b.origin) + off(a.axis, b.axis) * size;
    let mut all = before?.into_iter().zip(after?).map(apart).enumerate();
    all.find(|(_, off)| off.is_nan() || *off > MET * size)
}

impl<'a, T: Real> Layout<'a, T> {
    /// Reads a scene; `None` if no body leads or a wheel has no place.
    pub fn new(scene: &'a Scene, n: &'a Numbers<'a, T>) -> Option<Self> {
        let lead = scene.lead()?;
        let none = [T::zero(); 2];
        let line = |kind: &JointKind| kind.line().map_or(none, |line| direction(n, line.direction_deg));
        let leads = |(joint, j): (usize, &Joint)| {
            let first = j.kind.spots().next().filter(|at| at.body == lead && scene.leads_on_arc(joint));
            first.and_then(|_| Arc::of(scene, n, joint))
        };
        let arc = scene.joints.iter().enumerate().find_map(leads);
        let mut layout = Self {
            scene,
            n,
            lead,
            start: scene.start_angle(n),
            lines: scene.joints.iter().map(|j| line(&j.kind)).collect(),
            pushes: scene.pushes.iter().map(|p| direction(n, p.direction_deg)).collect(),
            natural: SmallVec::new(),
            relaxed_axes: SmallVec::new(),
            starts: scene.joints.iter().map(|_| T::zero()).collect(),
            first: None,
            arc,
            glide: None,
            steps: None,
            turns: 2.0,
        };
        let tied = |j: &Joint| matches!(j.kind, JointKind::Cord { .. });
        let rolls = |j: &Joint| matches!(j.kind, JointKind::Contact { rolls: true, .. });
        if scene.joints.iter().any(|j| rolls(j) || tied(j)) {
            let first: Poses<T> = layout.poses(T::zero(), true)?;
            for (j, joint) in scene.joints.iter().enumerate() {
                layout.starts[j] = match joint.kind {
                    JointKind::Contact { at, surface: Surface::Line(line), .. } => {
                        layout.beside(j, (at, line), &first)[0]
                    }
                    JointKind::Cord { at, place_m, beyond, .. } => layout.cord(&first, (at, place_m), beyond),
                    _ => T::zero(),
                };
            }
            layout.first = scene.joints.iter().any(tied).then_some(first);
        }
        layout.glide = layout.carried();
        layout.steps = layout.planned(false).ok();
        Some(layout)
    }
    /// The leading body's cylinder.
    pub const fn arc(&self) -> Option<&Arc<T>> {
        self.arc.as_ref()
    }
    /// The direction in which two guides carry the leading body: what leads is then its way in it, m.
    pub fn glide(&self) -> Option<[T; 2]> {
        self.glide.map(|(along, _)| along)
    }
    fn carried(&self) -> Option<([T; 2], T)> {
        let held = Planner::new(self, true).held(self.lead);
        // The direction of each guide, and how much the way bends there to its left: across a cord about its fixed end.
        let mut lines = self.scene.joints.iter().enumerate().filter_map(|(j, joint)| match joint.kind {
            JointKind::Guide { at, line: Straight { on: None, .. }, .. } if at.body == self.lead => {
                Some((self.lines[j], T::zero()))
            }
            JointKind::Cord { at, place_m, beyond: None, .. } if at.body == self.lead => {
                let near = self.first.as_ref()?[at.body].point(of_spot(self.scene, self.n, at));
                let per = T::of(1.0) / self.starts[j];
                Some((left(less(near, ground(self.n, place_m))).map(|x| x * per), per))
            }
            _ => None,
        });
        let (first, second) = (lines.next()?, lines.next()?);
        let free = held.is_none() && self.arc.is_none() && self.scene.driven().is_none();
        // Where their ways bend differently, a body that moves turns at the next instant.
        let still = self.scene.starts_from_rest();
        let like = |(line, bend): ([T; 2], T)| {
            let bend = bend.signed(dot(first.0, line).sign());
            parallel(first.0, line) && (still || (bend - first.1).size() <= MET * first.1.size())
        };
        let instant = matches!(self.scene.end, End::AtOnce);
        let up = upward(first.0);
        (free && like(second) && lines.all(like) && instant)
            .then(|| (first.0.map(|x| x.signed(up)), first.1.signed(up)))
    }
    /// Angle that the leading body turns per angle that leads.
    pub fn ratio(&self) -> T {
        self.arc.map_or_else(|| T::of(1.0), |arc| arc.ratio)
    }
    /// How far the leading body turns on its way, or moves about the axis of the cylinder on which it only slides.
    pub fn turned(&self, way: T) -> T {
        let ratio = self.ratio().abs();
        if ratio.is_zero() { way } else { way * ratio }
    }
    /// Direction of the axis of a body at which its torsion spring is relaxed; zero of another spring.
    pub fn relaxed(&self, strut: &Strut) -> Option<[T; 2]> {
        let planar = self.scene.planar(strut.at.body).filter(|_| strut.twists());
        let Some(planar) = planar else { return Some([T::zero(); 2]) };
        Some(match strut.rest {
            Rest::Length(angle) => axis(planar, &Half::of_degrees(self.n.get(angle))),
            Rest::Stretch(wound) => {
                let [c, s] = self.poses::<T>(T::zero(), true)?[strut.at.body].axis;
                let [cosine, sine] = direction(self.n, wound);
                let back = -sine.signed(planar.sense());
                [c * cosine - s * back, s * cosine + c * back]
            }
        })
    }
    /// How far the leading angle changes up to the angle that ends the motion, degrees.
    pub fn to_end_deg(&self) -> Option<T> {
        let End::Angle(_, angle) = self.scene.end else { return None };
        let start = self.scene.planar(self.lead).and_then(|planar| planar.start_deg);
        Some(self.n.get(angle) - start.map_or_else(T::zero, |start| self.n.get(start)))
    }
    /// Looks for the end of a motion in more turns than at first, in which nearly every one has ended; false if it has done so already.
    pub fn looks_farther(&mut self) -> bool {
        let more = self.turns < TURNS;
        self.turns = TURNS;
        more
    }
    /// How far a motion is followed, radians of the leading angle: two turns and if that is not enough twenty, or as far as its end.
    pub fn horizon(&self) -> T {
        let turns = T::constant(Dd::PI.scale2(1) * Dd::new(self.turns));
        self.to_end_deg().map_or(turns, |apart| (apart * trig::radians_per_degree()).abs().larger(turns))
    }
    /// The first way in this sense, looked for up to `far`, on which a torsion spring comes to be wound by half a turn, from where it
    /// is relaxed, or a load to its pulley.
    pub fn overruns(&self, sense: f64, far: (T, T)) -> Option<(T, Obstacle)> {
        let poses = |way: T| self.poses::<T>(way.signed(sense), false);
        let changes = |value: &dyn Fn(T) -> Option<T>| {
            root::changes(far, &[], &|way| value(way).ok_or(())).unwrap_or_default()
        };
        let twisted =
            self.scene.struts.iter().zip(&self.relaxed_axes).enumerate().filter(|(_, (s, _))| s.twists());
        let wound = twisted.filter_map(|(s, (strut, [x, y]))| {
            let axis = |way: T| Some(poses(way)?[strut.at.body].axis);
            let ways = changes(&|way| axis(way).map(|[c, s]| *x * s - *y * c));
            let way =
                ways.into_iter().find(|way| axis(*way).is_some_and(|at| dot([*x, *y], at).sign() < 0.0));
            Some((way?, Obstacle::Wound(s)))
        });
        let hung = self.steps.iter().flatten().filter_map(|(_, step)| {
            let Step::Hangs(_, hung) = step else { return None };
            let ways = changes(&|way| Some(self.left(hung, &poses(way)?) - hung.off.abs()));
            Some((*ways.first()?, Obstacle::Pulley(hung.joint)))
        });
        wound.chain(hung).reduce(|one, other| if other.0.below(one.0) { other } else { one })
    }
    /// How much of a cord is left for the load that hangs on it.
    fn left<X: Followed<T>>(&self, hung: &Hung<T>, poses: &Poses<X>) -> X {
        let (spot, over_m) = hung.other;
        X::still(self.starts[hung.joint]) - self.distance(poses, spot, over_m)
    }
    /// Do two hinged rods lie in one line after this way, or a rod across its guide, or a point in a slot at the pin of its arm, where
    /// they could go on in two ways?
    pub fn in_line(&self, way: T) -> Option<Obstacle> {
        const SINE: f64 = 1e-4;
        let poses = self.poses::<T>(way, false)?;
        let place = |held: &Held<T>| held.place.among(&poses);
        let sine = |one: [T; 2], other: [T; 2]| {
            let size = (dot(one, one) * dot(other, other)).root();
            ((one[0] * other[1] - one[1] * other[0]) / size).size()
        };
        self.steps.iter().flatten().find_map(|(body, step)| {
            let (sine, obstacle) = match step {
                Step::Pair(held, other, far, [own, _], _) => {
                    let hinge = poses[*body].point(plus(held.at, *own));
                    let sine = sine(less(hinge, place(held)), less(place(far), hinge));
                    (sine, Obstacle::InLine(*body, *other))
                }
                Step::Rod(held, guide, _) => {
                    let along = less(poses[*body].point(guide.at), place(held));
                    (sine(along, left(guide.unit)), Obstacle::Across(*body))
                }
                Step::Slot(held, through, ..) => {
                    let apart = off(through.among(&poses), place(held));
                    (apart / size(self.scene, self.n), Obstacle::AtPin(*body))
                }
                _ => return None,
            };
            (sine < SINE).then_some(obstacle)
        })
    }
    /// Rate of the leading angle at the start: a spin is that of its body, a speed that of its mass centre, positive where the
    /// leading angle grows if that is its own and told, else up, or to the right on a level. `None` where what has it does not move with
    /// that angle.
    pub fn start_rate(&self) -> Option<T> {
        let Some((Coordinate { body, degree }, number)) = self.scene.start_speeds().next() else {
            return Some(T::zero());
        };
        let given = self.n.get(number);
        if degree == Degree::Turn && body == self.lead && self.glide.is_none() {
            return Some(given / self.ratio());
        }
        let (poses, planar) = (self.poses::<Jet<T>>(T::zero(), false)?, self.scene.planar(body)?);
        let unit = match degree {
            Degree::Turn if planar.clockwise => -poses[body].turn().0,
            Degree::Turn => poses[body].turn().0,
            Degree::Along => {
                let way = poses[body].point([along(self.n, planar.centre), T::zero()]).map(|x| x.first);
                let length = dot(way, way).root();
                // What rests has no direction.
                let forth = body == self.lead && !planar.unmarked || length.is_zero();
                if forth { length } else { length.signed(upward(way.map(|x| x / length))) }
            }
        };
        (given.is_zero() || !unit.is_zero()).then(|| if given.is_zero() { given } else { given / unit })
    }
    /// The first body whose side is told and decides nothing, or contradicts that of this one, with which it is placed.
    pub fn idle_side(&self) -> Option<(usize, Option<usize>)> {
        let side = |body: usize| self.scene.planar(body)?.side;
        let plans = [true, false].map(|at_start| self.plan(at_start));
        let steps = || plans.iter().flatten().flat_map(|steps| steps.iter());
        let clash = steps().find_map(|(own, step)| {
            let other = step.partner()?;
            let [one, two] = [side(*own)?, side(other)?];
            (one != two).then_some((other, Some(*own)))
        });
        let idle = |body: &usize| {
            let decides = |own: &usize, step: &Step<T>| own == body || step.partner() == Some(*body);
            let open = |(own, step): &(usize, Step<T>)| step.other_side().is_some() && decides(own, step);
            side(*body).is_some() && steps().next().is_some() && !steps().any(open)
        };
        clash.or_else(|| (0..self.scene.bodies.len()).find(idle).map(|body| (body, None)))
    }
    /// The first body that does not lie at the angle at the start that is told of it, that angle, and that at which it lies, degrees.
    pub fn tilted(&self, poses: &Poses<T>) -> Option<(usize, [f64; 2])> {
        poses.iter().enumerate().find_map(|(body, pose)| {
            let planar = self.scene.planar(body)?;
            let told = self.n.get(planar.start_deg?);
            let from = planar.from.components().map(T::of);
            let apart = off(pose.axis, axis(planar, &Half::of_degrees(told)));
            (apart > MET).then(|| {
                let across = from[0] * pose.axis[1] - from[1] * pose.axis[0];
                let lies = trig::angle(across, dot(from, pose.axis)).signed(planar.sense());
                (body, [told.f64(), lies.f64().to_degrees()])
            })
        })
    }
    /// The first body that is too short, or too long, for the places that hold it.
    pub fn unbridged(&self, poses: &Poses<T>, at_start: bool) -> Option<Gap> {
        let slack = MET * size(self.scene, self.n);
        self.plan(at_start)?.iter().find_map(|(body, step)| {
            let (other, apart_m, [one, two], line) = match step {
                Step::Rod(held, guide, _) => {
                    let (way, own) =
                        (less(guide.through, held.place.among(poses)), reach(less(guide.at, held.at)));
                    let across = match guide.ring {
                        Some(_) => dot(way, way).root(),
                        None => dot(left(guide.unit), way),
                    };
                    (None, across.size(), [own, guide.ring.unwrap_or_else(T::zero)], guide.ring.is_none())
                }
                Step::Pair(held, other, far, own, _) => {
                    let apart = off(far.place.among(poses), held.place.among(poses));
                    (Some(*other), apart, own.map(reach), false)
                }
                _ => return None,
            };
            let [one, two] = [one.size(), two.size()];
            let (least, most) = (if line { 0.0 } else { (one - two).abs() }, one + two);
            let bridged_m = if apart_m > most + slack { most } else { least };
            (apart_m > most + slack || apart_m < least - slack).then_some(Gap {
                body: *body,
                other,
                apart_m,
                bridged_m,
            })
        })
    }
    /// The first joint that does not hold where everything is, and by how much, m: what placed the bodies is not asked. A cord has
    /// the length that it has at the start. There a joint must leave a body where it is said to be placed.
    pub fn parted(&self, poses: &Poses<T>, at_start: bool) -> Option<(usize, f64)> {
        let place = |spot: Spot| self.spot(spot, poses);
        let aside = |j: usize, at, line| self.beside(j, (at, line), poses)[1];
        let size = size(self.scene, self.n);
        let parts = self.scene.joints.iter().enumerate().map(|(j, joint)| match joint.kind {
            JointKind::Pin { at, place_m } => off(place(at), ground(self.n, place_m)),
            JointKind::Hinge { one, other, turned_deg } => {
                let turned = turned_deg.map_or(0.0, |by| {
                    let ([x, y], [c, s]) = (poses[one.body].axis, direction(self.n, by));
                    off(poses[other.body].axis, [x * c - y * s, x * s + y * c]) * size
                });
                off(place(one), place(other)) + turned
            }
            JointKind::Guide { at, line, .. } => aside(j, at, line).size(),
            JointKind::Contact { at, radius_m, surface: Surface::Line(line), .. } => {
                (aside(j, at, line) - self.n.get(radius_m)).size()
            }
            JointKind::Contact { at, surface: Surface::Arc { centre_m: middle, .. }, .. } => {
                (self.distance(poses, at, middle) - self.apart(j).unwrap_or_else(T::zero)).size()
            }
            JointKind::Cord { at, place_m, beyond, .. } => {
                (self.cord(poses, (at, place_m), beyond) - self.starts[j]).size()
            }
        });
        let moved = |joint: &Joint| {
            let own = joint.kind.spots().filter_map(|spot| {
                let place = self.scene.planar(spot.body)?.origin_m.filter(|_| at_start)?;
                Some(off(poses[spot.body].origin, ground(self.n, place)))
            });
            own.fold(0.0, f64::max)
        };
        let all = parts.zip(self.scene.joints.iter().map(moved)).map(|(apart, moved)| apart + moved);
        all.enumerate().find(|(_, off)| off.is_nan() || *off > MET * size)
    }
    /// Where a point of a body is.
    pub fn spot<X: Followed<T>>(&self, spot: Spot, poses: &Poses<X>) -> [X; 2] {
        poses[spot.body].point(of_spot(self.scene, self.n, spot))
    }
    /// How far a point is along the line of a joint and to its left.
    fn beside(&self, joint: usize, (at, line): (Spot, Straight), poses: &Poses<T>) -> [T; 2] {
        let through = line.on.map_or_else(|| ground(self.n, line.through_m), |on| self.spot(on, poses));
        let (from, unit) = (less(self.spot(at, poses), through), self.line(joint, poses));
        [dot(unit, from), dot(left(unit), from)]
    }
    /// How long a cord or a light rod is that holds a point, as far as its fixed place or on to another body.
    fn cord(&self, poses: &Poses<T>, near: (Spot, [Num; 2]), beyond: Option<(Spot, [Num; 2])>) -> T {
        let length = |(at, place_m)| self.distance(poses, at, place_m);
        beyond.map_or_else(T::zero, length) + length(near)
    }
    /// How far the centre of a body is from the axis of the cylinder that it touches, or a point from where its cord is tied.
    fn apart(&self, joint: usize) -> Option<T> {
        match self.scene.joints[joint].kind {
            JointKind::Cord { beyond: None, .. } => Some(self.starts[joint]),
            _ => Arc::of(self.scene, self.n, joint).map(|arc| arc.apart),
        }
    }
    /// The direction of the line of a joint.
    pub fn line<X: Followed<T>>(&self, joint: usize, poses: &Poses<X>) -> [X; 2] {
        let unit = self.lines[joint];
        match self.scene.joints[joint].kind.carrier() {
            Some(on) => from_origin(poses[on.body].axis, unit),
            None => fixed(unit),
        }
    }
    /// The direction in which a speed along the line of a joint is told: as written on a body that carries it, else up, or to the right.
    pub fn told_along(&self, joint: usize, poses: &Poses<T>) -> [T; 2] {
        let (line, kind) = (self.line(joint, poses), &self.scene.joints[joint].kind);
        let forth = match kind {
            JointKind::Guide { reversed: true, .. } if kind.carrier().is_some() => -1.0,
            _ if kind.carrier().is_some() => 1.0,
            _ => upward(line),
        };
        line.map(|x| x.signed(forth))
    }
    /// How a body touches the surface of a joint with its centre at this place; `line` is the direction of a straight one.
    pub fn touch<X: Followed<T>>(&self, joint: usize, centre: [X; 2], line: [X; 2]) -> Option<Touch<T, X>> {
        let kind = &self.scene.joints[joint].kind;
        let ((_, radius_m, surface), [_, teeth]) = (kind.surface()?, kind.rolls());
        let own = self.n.get(radius_m);
        let (normal, bend, radius) = match surface {
            Surface::Line(_) => (left(line), X::still(T::zero()), own),
            Surface::Arc { centre_m, radius_m, inside, .. } => {
                // A hoop hangs on its inner side.
                let radius = if inside && self.n.get(radius_m).below(own) { -own } else { own };
                let out = less(centre, fixed(ground(self.n, centre_m)));
                let apart = dot(out, out).square_root();
                let sense = |x: X| if inside { -x } else { x };
                (out.map(|x| sense(x / apart)), sense(X::still(T::of(1.0)) / apart), radius)
            }
        };
        let right = [normal[1], -normal[0]];
        let up = if teeth { 1.0 } else { upward(right.map(X::here)) };
        Some(Touch {
            normal,
            along: if up < 0.0 { right.map(|x| -x) } else { right },
            radius: radius.signed(up),
            rim: radius,
            bend,
        })
    }
    /// Where everything is when the leading angle has changed by this, radians; `None` for a body that the joints do not place.
    ///
    /// At the start, what is not placed by joints is where its data say.
    pub fn poses<X: Followed<T>>(&self, way: T, at_start: bool) -> Option<Poses<X>> {
        let steps = self.plan(at_start)?;
        let none = [X::still(T::zero()); 2];
        let mut poses: Poses<X> = smallvec![Pose { origin: none, axis: none }; self.scene.bodies.len()];
        for (body, step) in steps.iter() {
            poses[*body] = self.place(way, step, &mut poses)?;
        }
        Some(poses)
    }

    /// The places at the start of what the joints could place in two ways, where the bank does not say in which.
    pub fn choices(&self) -> Vec<Choice> {
        // What cords and light rods guide lies as it does at the start.
        let rests = self.scene.start_speeds().next().is_none() || self.scene.tells_speeds();
        let still = self.scene.is_still() && rests || self.first.is_some();
        let Some(steps) = self.plan(still) else { return Vec::new() };
        let Some(poses) = self.poses::<T>(T::zero(), still) else { return Vec::new() };
        let all = steps.iter().filter_map(|(body, step)| {
            let planar = self.scene.planar(*body)?;
            let open = |body: usize| self.scene.planar(body).is_none_or(|planar| planar.side.is_none());
            if !open(*body) || !step.partner().is_none_or(open) {
                return None;
            }
            let (other, at) = step.other_side()?;
            let there = self.place(T::zero(), &other, &mut poses.clone())?.point(at);
            let here = poses[*body].point(at);
            let spot = |point| of_spot(self.scene, self.n, Spot { body: *body, point });
            let point = (0..planar.points.len()).find(|point| off(spot(*point), at) == 0.0)?;
            let near = |a, b| off(a, b) <= MET * size(self.scene, self.n);
            let crossed = match step {
                Step::Pair(held, _, far, ..) => [(held, far), (far, held)].iter().any(|(moves, rests)| {
                    let Some(parallel) = self.parallelogram(&steps, &poses, moves, rests) else {
                        return false;
                    };
                    near(there, parallel) && !near(here, parallel)
                }),
                _ => false,
            };
            let [here, there] = [here, there].map(|place| place.map(Real::f64));
            Some(Choice { at: Spot { body: *body, point }, here, there, crossed })
        });
        all.collect()
    }
    /// The fourth corner of a parallelogram: beside where a body is hinged that is itself held, and a second place.
    fn parallelogram(
        &self,
        steps: &[BodyStep<T>],
        poses: &Poses<T>,
        moves: &Held<T>,
        rests: &Held<T>,
    ) -> Option<[T; 2]> {
        let place = |held: &Held<T>| held.place.among(poses);
        let Known::Of(link, _) = moves.place else { return None };
        let held = steps.iter().find_map(|(body, step)| match step {
            Step::Leads(held) | Step::Rod(held, ..) | Step::Pair(held, ..) if *body == link => Some(held),
            _ => None,
        })?;
        Some(plus(place(moves), less(place(rests), place(held))))
    }

    /// The first body that the joints do not place.
    pub fn unplaced(&self, at_start: bool) -> Option<usize> {
        self.planned(at_start).err()
    }

    /// The order in which joints place all bodies; `None` if they do not.
    fn plan(&self, at_start: bool) -> Option<Cow<'_, [BodyStep<T>]>> {
        if at_start {
            self.planned(true).ok().map(Cow::Owned)
        } else {
            self.steps.as_deref().map(Cow::Borrowed)
        }
    }
    /// The order in which joints place all bodies; or else the first that they do not.
    fn planned(&self, at_start: bool) -> Result<Steps<T>, usize> {
        let mut planner = Planner::new(self, at_start);
        // What rods hold fast beside the leading body is placed before it: it turns there on the axle that they hold.
        for body in (0..self.scene.bodies.len()).filter(|body| *body != self.lead) {
            if !planner.placed[body]
                && let Some(step @ (Step::Rod(..) | Step::Pair(..))) = planner.follow(body)
            {
                planner.add(body, step);
            }
        }
        planner.lead().ok_or(self.lead)?;
        while let Some(next) = planner.placed.iter().position(|placed| !placed) {
            let before = planner.steps.len();
            for body in 0..self.scene.bodies.len() {
                if !planner.placed[body]
                    && let Some(step) = planner.follow(body)
                {
                    planner.add(body, step);
                }
            }
            if planner.steps.len() == before {
                return Err(next);
            }
        }
        Ok(planner.steps)
    }

    /// The direction of the leading body's axis when it has turned by this, with the rate at which it turns.
    fn axis<X: Followed<T>>(&self, turned: T, rate: T) -> Option<[X; 2]> {
        let planar = self.scene.bodies[self.lead].planar.as_ref()?;
        let direction = axis(planar, &self.start.plus(Half::of_radians(turned)));
        Some(turning(direction, rate.signed(planar.sense()), T::zero()))
    }

    /// How the leading body is held, if it hangs on a fixed pin.
    fn pinned(&self) -> Option<(&Planar, [T; 2], [T; 2])> {
        match self.steps.as_ref()?.first()? {
            (_, Step::Leads(Held { at, place: Known::Fixed(place) })) => {
                Some((self.scene.planar(self.lead)?, *at, *place))
            }
            _ => None,
        }
    }
    /// Where the leading body is at this angle, if it hangs on a fixed pin.
    pub fn hung<X: Followed<T>>(&self, angle: &Half<T>) -> Option<Pose<X>> {
        let (planar, at, place) = self.pinned()?;
        let direction = turning(axis(planar, angle), T::of(planar.sense()), T::zero());
        Some(Pose::through(direction, at, fixed(place)))
    }
    /// How far it has moved from the start with this change of its angle, to this angle: a difference of two directions is a product,
    /// which keeps the digits of a short way.
    pub fn swung(&self, turned: T, angle: Option<&Half<T>>) -> Option<Pose<T>> {
        let (planar, at, _) = self.pinned()?;
        let step = Half::of_radians(turned);
        let middle = angle.map_or_else(|| self.start.plus(step), |angle| *angle).plus(self.start);
        let by = step.sine.scale2(1).signed(planar.sense());
        let axis = left(facing(planar, [middle.cosine, middle.sine])).map(|x| x * by);
        Some(Pose { origin: from_origin(axis, at).map(|x| -x), axis })
    }

    /// The pose of a body beside those that are placed before it; of a pair the second one is placed too.
    fn place<X: Followed<T>>(&self, way: T, step: &Step<T>, poses: &mut Poses<X>) -> Option<Pose<X>> {
        let place = |held: &Held<T>, poses: &Poses<X>| held.place.among(poses);
        let lead = || self.axis(way, T::of(1.0));
        // The turn of a wheel goes with the way of its centre.
        let rolls = |centre: [X; 2], track: &Track<T>, axis: [T; 2], poses: &Poses<X>| {
            let ahead = component(less(centre, track.through.among(poses)), track.unit)
                - X::still(self.starts[track.joint]);
            rolled(axis, -ahead.by(T::of(1.0) / track.radius))
        };
        Some(match step {
            Step::Arc(at) => {
                let arc = self.arc.as_ref()?;
                let centre = plus(fixed(arc.axis), times(lead()?, arc.apart));
                Pose::through(self.axis(way * arc.ratio, arc.ratio)?, *at, centre)
            }
            Step::Wheel(track, start) => {
                let sense = self.scene.sense(self.lead);
                let turned = X::with(way.signed(sense), || [T::of(sense), T::zero()]);
                let ahead =
                    turned.by(plant!("pose: way of a wheel on a line", -track.radius)) + X::still(*start);
                let up = left(track.unit).map(|u| u * track.radius);
                let centre = plus(along_unit(track.unit, ahead), plus(track.through.among(poses), fixed(up)));
                Pose::through(lead()?, track.at, centre)
            }
            Step::Leads(held) => Pose::through(lead()?, held.at, place(held, poses)),
            Step::Glides(from, unit, bend) => {
                let ahead = X::with(way, || [T::of(1.0), T::zero()]);
                let aside = (ahead * ahead).by(bend.scale2(-1));
                let moved = plus(along_unit(*unit, ahead), along_unit(left(*unit), aside));
                Pose { origin: plus(fixed(*from), moved), axis: self.axis(T::zero(), T::zero())? }
            }
            Step::Slides([one, other], branch) if one.ring.is_some() => around(lead()?, one, other, *branch)?,
            Step::Slides([one, other], branch) if other.ring.is_some() => {
                around(lead()?, other, one, *branch)?
            }
            Step::Slides([one, other], _) => {
                let axis = lead()?;
                let row = |guide: &Guided<T>| {
                    let normal = left(guide.unit);
                    let far = X::still(dot(normal, guide.through));
                    (fixed(normal), far - across(normal, axis, guide.at))
                };
                Pose { origin: crossing([row(one), row(other)]), axis }
            }
            Step::Drops(guide, centre, start) => {
                let axis = lead()?;
                let across = -across(left(guide.unit), axis, guide.at);
                let ahead = X::still(*start) - component(axis, guide.unit).by(*centre);
                let from = plus(along_unit(guide.unit, ahead), along_unit(left(guide.unit), across));
                Pose { origin: plus(fixed(guide.through), from), axis }
            }
            Step::Welded(held, to, [c, s]) => {
                let [x, y] = poses[*to].axis;
                let axis = [x.by(*c) - y.by(*s), x.by(*s) + y.by(*c)];
                Pose::through(axis, held.at, place(held, poses))
            }
            Step::Still(held, axis) => Pose::through(fixed(*axis), held.at, place(held, poses)),
            Step::Hangs(axis, hung) => {
                let left = self.left(hung, poses);
                let ahead = match hung.off.is_nothing() {
                    true => left,
                    false => open(left * left, X::still(hung.off.square())).square_root(),
                };
                let place = plus(fixed(hung.foot), along_unit(hung.unit, ahead));
                Pose::through(fixed(*axis), hung.at, place)
            }
            Step::Rolls(held, track, axis) => {
                let place = place(held, poses);
                Pose::through(rolls(place, track, *axis, poses), held.at, place)
            }
            Step::Crosses(at, lines, track, axis) => {
                let place = crossing(lines.map(|line| line.among(way, poses)));
                let still = || fixed(*axis);
                let axis = track.as_ref().map_or_else(still, |track| rolls(place, track, *axis, poses));
                Pose::through(axis, *at, place)
            }
            Step::Orbits(held, ratio, axis) => {
                let sense = self.scene.sense(self.lead);
                let turned = X::with((way * *ratio).signed(sense), || [ratio.signed(sense), T::zero()]);
                Pose::through(rolled(*axis, turned), held.at, place(held, poses))
            }
            Step::Rod(held, guide, branch) => {
                let place = place(held, poses);
                let apart = [guide.at[0] - held.at[0], guide.at[1] - held.at[1]];
                let (reach, way) = (reach(apart), less(fixed(guide.through), place));
                let along = match guide.ring {
                    Some(radius) => times(triangle(way, [reach, radius], *branch), T::of(1.0) / reach),
                    None => toward(way, reach, guide.unit, branch * reach.sign()),
                };
                Pose::through(axis_of(along, apart), held.at, place)
            }
            Step::Slot(held, through, (unit, aside), branch) => {
                let place = place(held, poses);
                let way = less(through.among(poses), place);
                let square = dot(way, way);
                let ahead = open(square, X::still(aside.square())).square_root().by(T::of(*branch));
                let line = less(scaled(way, ahead), times(left(way), *aside)).map(|x| x / square);
                Pose::through(from_origin(line, [unit[0], -unit[1]]), held.at, place)
            }
            Step::Pair(held, other, far, [own, other_own], branch) => {
                let (first, second) = (reach(*own), reach(*other_own));
                let (place, far_place) = (place(held, poses), place(far, poses));
                let apart = less(far_place, place);
                let joint = triangle(apart, [first, second], *branch);
                let one = axis_of(times(joint, T::of(1.0) / first), *own);
                let two = axis_of(times(less(joint, apart), T::of(1.0) / second), *other_own);
                poses[*other] = Pose::through(two, far.at, far_place);
                Pose::through(one, held.at, place)
            }
        })
    }
}
