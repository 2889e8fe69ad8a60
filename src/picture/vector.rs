//! Points and directions of a drawing, in pixels: on the board y points *up*, in a finished picture *down*. Plain geometry.
use crate::num::trig;
use std::ops::Add;
use std::ops::AddAssign;
use std::ops::Mul;
use std::ops::Neg;
use std::ops::Sub;

/// A point or a direction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vec2 {
    /// To the right.
    pub x: f64,
    /// Up on the board, down in a picture.
    pub y: f64,
}

/// A point or a direction, from both of its components.
pub const fn vec2(x: f64, y: f64) -> Vec2 {
    Vec2 { x, y }
}

impl Vec2 {
    /// The origin.
    pub const ZERO: Self = vec2(0.0, 0.0);
    /// To the right.
    pub const RIGHT: Self = vec2(1.0, 0.0);
    /// To the left.
    pub const LEFT: Self = vec2(-1.0, 0.0);
    /// Up, on the board.
    pub const UP: Self = vec2(0.0, 1.0);
    /// Down, on the board.
    pub const DOWN: Self = vec2(0.0, -1.0);

    /// Direction at an angle, radians, counter-clockwise from the right.
    pub fn polar(angle: f64) -> Self {
        let (s, c) = trig::sin_cos_f64(angle);
        vec2(c, s)
    }

    /// Direction at an angle in degrees, counter-clockwise from the right.
    pub fn polar_degrees(angle: f64) -> Self {
        let (s, c) = trig::sin_cos_degrees(angle);
        vec2(c.hi, s.hi)
    }

    /// Points of an arc, its ends included, in equal steps; angles in radians, counter-clockwise from the right.
    pub fn on_arc(
        centre: Self,
        radius: f64,
        (from, to): (f64, f64),
        steps: u32,
    ) -> impl Iterator<Item = Self> {
        (0..=steps).map(move |i| {
            let share = f64::from(i) / f64::from(steps);
            centre + Self::polar(from + (to - from) * share) * radius
        })
    }

    /// Angle of a direction, radians, from -pi to pi.
    pub fn angle(self) -> f64 {
        trig::atan2::<f64>(self.y, self.x)
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// Third component of the vector product: positive if `other` is counter-clockwise of this one.
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Turned a quarter counter-clockwise.
    pub fn left(self) -> Self {
        vec2(-self.y, self.x)
    }

    /// Turned a quarter clockwise.
    pub fn right(self) -> Self {
        vec2(self.y, -self.x)
    }

    /// Length.
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// Of length 1; what has no direction points to the right.
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > 1e-9 { self * (1.0 / length) } else { Self::RIGHT }
    }

    /// The lesser of both in each component.
    pub fn min(self, other: Self) -> Self {
        vec2(self.x.min(other.x), self.y.min(other.y))
    }

    /// The greater of both in each component.
    pub fn max(self, other: Self) -> Self {
        vec2(self.x.max(other.x), self.y.max(other.y))
    }

    /// Middle between two points.
    pub fn middle(self, other: Self) -> Self {
        (self + other) * 0.5
    }
}

impl Add for Vec2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        vec2(self.x + other.x, self.y + other.y)
    }
}

impl AddAssign for Vec2 {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Vec2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        vec2(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        vec2(self.x * factor, self.y * factor)
    }
}

impl Neg for Vec2 {
    type Output = Self;
    fn neg(self) -> Self {
        vec2(-self.x, -self.y)
    }
}
