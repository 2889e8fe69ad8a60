//! Upright boxes round what is drawn.
use crate::picture::vector::{Vec2, vec2};

/// A box that stands upright, its edges included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Its least coordinates.
    pub low: Vec2,
    /// Its greatest coordinates.
    pub high: Vec2,
}

impl Frame {
    /// The box round these points; `None` if there are none.
    pub fn round(points: impl IntoIterator<Item = Vec2>) -> Option<Self> {
        points.into_iter().map(|p| Self { low: p, high: p }).reduce(Self::joined)
    }

    /// A box by its middle and half its size.
    pub fn about(centre: Vec2, half: Vec2) -> Self {
        Self { low: centre - half, high: centre + half }
    }

    /// The box round both.
    pub fn joined(self, other: Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    /// Larger by so much on every side.
    pub fn grown(self, by: f64) -> Self {
        Self { low: self.low - vec2(by, by), high: self.high + vec2(by, by) }
    }

    /// Have both an area in common?
    pub fn overlaps(self, other: Self) -> bool {
        self.low.x < other.high.x
            && other.low.x < self.high.x
            && self.low.y < other.high.y
            && other.low.y < self.high.y
    }

    /// Its point that is nearest to this one.
    pub fn nearest(self, p: Vec2) -> Vec2 {
        vec2(p.x.clamp(self.low.x, self.high.x), p.y.clamp(self.low.y, self.high.y))
    }

    /// Distance of its farthest corner from a point.
    pub fn farthest(self, p: Vec2) -> f64 {
        (self.high - p).sup(&(p - self.low)).norm()
    }

    /// Does it meet the segment from `a` to `b`? (Clipped slab by slab.)
    pub fn meets(self, a: Vec2, b: Vec2) -> bool {
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for (start, step, low, high) in
            [(a.x, b.x - a.x, self.low.x, self.high.x), (a.y, b.y - a.y, self.low.y, self.high.y)]
        {
            if step.abs() < 1e-12 {
                if start < low || start > high {
                    return false;
                }
            } else {
                let (t1, t2) = ((low - start) / step, (high - start) / step);
                from = from.max(t1.min(t2));
                to = to.min(t1.max(t2));
            }
        }
        from <= to
    }
}
