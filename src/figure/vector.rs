//! Points and directions of the drawing board: pixels, x to the right, y *up*. Plain geometry.
use crate::num::trig;

/// A point or a direction on the board.
pub type V = (f64, f64);

/// Sum.
pub fn add(a: V, b: V) -> V {
    (a.0 + b.0, a.1 + b.1)
}

/// Difference.
pub fn sub(a: V, b: V) -> V {
    (a.0 - b.0, a.1 - b.1)
}

/// Multiple.
pub fn mul(a: V, factor: f64) -> V {
    (a.0 * factor, a.1 * factor)
}

/// `from`, then `far` along `towards`.
pub fn along(from: V, towards: V, far: f64) -> V {
    (from.0 + towards.0 * far, from.1 + towards.1 * far)
}

/// Scalar product.
pub fn dot(a: V, b: V) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

/// Third component of the vector product: positive if `b` is counter-clockwise of `a`.
pub fn cross(a: V, b: V) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// Turned a quarter counter-clockwise.
pub fn left(a: V) -> V {
    (-a.1, a.0)
}

/// Turned a quarter clockwise.
pub fn right(a: V) -> V {
    (a.1, -a.0)
}

/// Length.
pub fn size(a: V) -> f64 {
    dot(a, a).sqrt()
}

/// Of length 1; what has no direction points to the right.
pub fn unit(a: V) -> V {
    let long = size(a);
    if long > 1e-9 { mul(a, 1.0 / long) } else { (1.0, 0.0) }
}

/// Middle of two points.
pub fn middle(a: V, b: V) -> V {
    mul(add(a, b), 0.5)
}

/// Direction at an angle, radians, counter-clockwise from the right.
pub fn polar(angle: f64) -> V {
    let (s, c) = trig::sin_cos_f64(angle);
    (c, s)
}

/// Direction at an angle in degrees, counter-clockwise from the right.
pub fn polar_degrees(angle: f64) -> V {
    let (s, c) = trig::sin_cos_degrees(angle);
    (c.hi, s.hi)
}

/// Angle of a direction, radians, from -pi to pi.
pub fn angle(a: V) -> f64 {
    trig::atan2::<f64>(a.1, a.0)
}
