//! Points and directions of a drawing, in pixels: on the board y points *up*, in a finished picture *down*.
use crate::num::trig;
use nalgebra::Vector2;

/// A point or a direction: x to the right, y up on the board and down in a picture.
pub type Vec2 = Vector2<f64>;

/// A point or a direction, from both of its components.
pub const fn vec2(x: f64, y: f64) -> Vec2 {
    Vector2::new(x, y)
}

/// What a drawing asks of directions beyond what [`Vec2`] brings with it.
pub trait Direction: Sized {
    /// The origin.
    const ZERO: Self;
    /// To the right.
    const RIGHT: Self;
    /// To the left.
    const LEFT: Self;
    /// Up, on the board.
    const UP: Self;
    /// Down, on the board.
    const DOWN: Self;

    /// Direction at an angle, radians, counter-clockwise from the right.
    fn at_angle(angle: f64) -> Self;
    /// Direction at an angle in degrees, counter-clockwise from the right.
    fn at_degrees(angle: f64) -> Self;
    /// Points of an arc, its ends included, in equal steps; angles in radians, counter-clockwise from the right.
    fn on_arc(centre: Self, radius: f64, ends: (f64, f64), steps: u32) -> impl Iterator<Item = Self>;
    /// Angle of a direction, radians, from -pi to pi.
    fn angle_of(self) -> f64;
    /// Turned a quarter counter-clockwise.
    fn left(self) -> Self;
    /// Turned a quarter clockwise.
    fn right(self) -> Self;
    /// Of length 1; what has no direction points to the right.
    fn unit(self) -> Self;
    /// Middle between two points.
    fn middle(self, other: Self) -> Self;
}

impl Direction for Vec2 {
    const ZERO: Self = vec2(0.0, 0.0);
    const RIGHT: Self = vec2(1.0, 0.0);
    const LEFT: Self = vec2(-1.0, 0.0);
    const UP: Self = vec2(0.0, 1.0);
    const DOWN: Self = vec2(0.0, -1.0);

    fn at_angle(angle: f64) -> Self {
        let (s, c) = trig::sin_cos_f64(angle);
        vec2(c, s)
    }
    fn at_degrees(angle: f64) -> Self {
        let (s, c) = trig::sin_cos_degrees(angle);
        vec2(c.hi, s.hi)
    }
    fn on_arc(centre: Self, radius: f64, (from, to): (f64, f64), steps: u32) -> impl Iterator<Item = Self> {
        (0..=steps).map(move |i| {
            let share = f64::from(i) / f64::from(steps);
            centre + Self::at_angle(from + (to - from) * share) * radius
        })
    }
    fn angle_of(self) -> f64 {
        trig::atan2::<f64>(self.y, self.x)
    }
    fn left(self) -> Self {
        vec2(-self.y, self.x)
    }
    fn right(self) -> Self {
        vec2(self.y, -self.x)
    }
    fn unit(self) -> Self {
        let length = self.norm();
        if length > 1e-9 { self * (1.0 / length) } else { Self::RIGHT }
    }
    fn middle(self, other: Self) -> Self {
        (self + other) * 0.5
    }
}
