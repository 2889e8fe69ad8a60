//! A body on a pin under its weight alone: what its motion has in closed form. `omega d omega = alpha d phi` is a difference of
//! cosines, and the time an elliptic integral, by Carlson's R_F.
//!
//! Places are told by the way from the start, radians, and by sine and cosine of half the angle from hanging, growing on the way.
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::num::{Dd, Real, elliptic, root, trig};
use crate::solve::outcome::Refusal;

/// The body on its way in one sense.
#[derive(Debug, Clone, Copy)]
pub struct Pendulum<T> {
    /// Half the angle from hanging at the start, between top and top; the top, if it starts there, is behind it.
    start: Half<T>,
    /// Half the square of the angular speed at the start.
    half_square: T,
    /// Angular frequency of small swings.
    frequency: T,
}

/// A place as an elliptic integral sees it.
#[derive(Debug, Clone, Copy)]
struct Arc<T> {
    /// Sine and cosine of half the angle.
    sine: T,
    cosine: T,
    /// Angular speed as a share of twice the frequency of small swings: `p^2 = k^2 - sin^2`.
    pace: T,
}

impl<T: Real> Pendulum<T> {
    /// One that starts at this angle from hanging, growing on the way, with half this square of the angular speed.
    pub fn new(hanging: Half<T>, half_square: T, frequency: T) -> Self {
        let Half { sine, cosine } = hanging;
        // Half turns change both signs.
        let beyond = cosine.sign() < 0.0 || (cosine.is_zero() && sine.sign() > 0.0);
        let start = if beyond { Half { sine: -sine, cosine: -cosine } } else { hanging };
        Self { start, half_square, frequency }
    }

    /// Angular frequency of small swings.
    pub const fn frequency(&self) -> T {
        self.frequency
    }

    /// Half the square of the angular speed after a way; 0 where it just comes to rest.
    pub fn half_square(&self, way: T) -> T {
        let step = Half::of_radians(way);
        let end = self.start.plus(step);
        let product = (step.sine * end.plus(self.start).sine).scale2(1);
        let gained = -(plant!("eom: integral of the weight's moment", self.frequency.square()) * product);
        (self.half_square + gained).cleared(self.half_square.size() + gained.size())
    }

    fn first(&self) -> Arc<T> {
        let Half { sine, cosine } = self.start;
        let speed = self.half_square.scale2(1).root();
        Arc { sine, cosine, pace: (speed / self.frequency).scale2(-1) }
    }

    /// The modulus, what it lacks to 1 by its square (above 0 it swings, below it goes over the top), and the root of that, which
    /// without a speed at the start needs no squares.
    fn modulus(&self) -> (T, T, T) {
        let Arc { sine, cosine, pace } = self.first();
        if pace.is_zero() {
            return (sine.abs(), cosine.square(), cosine);
        }
        let rest = cosine.square().balance(-pace.square());
        ((sine.square() + pace.square()).root(), rest, rest.abs().root())
    }

    /// The way to where it comes to rest; `None` if it goes over the top.
    pub fn turning(&self) -> Option<T> {
        let Half { sine, cosine } = self.start;
        let (k, rest, complement) = self.modulus();
        let across = (k * cosine).balance(-(complement * sine));
        let along = (complement * cosine).balance(k * sine);
        (rest.sign() >= 0.0).then(|| trig::angle(across, along).scale2(1))
    }

    /// The angle from hanging where it comes to rest.
    pub fn turned(&self) -> Half<T> {
        let (sine, _, cosine) = self.modulus();
        Half { sine, cosine }
    }

    /// Period and greatest angular speed.
    pub fn period(&self) -> (T, T) {
        let (k, rest, complement) = self.modulus();
        let fastest = (self.frequency * k).scale2(1);
        let period = if rest.sign() < 0.0 {
            elliptic::rf_of_roots(T::zero(), complement, k).scale2(1)
        } else {
            elliptic::rf_of_roots(T::zero(), complement, T::of(1.0)).scale2(2)
        };
        (plant!("eom: period", period) / self.frequency, fastest)
    }

    /// The greatest angular speed on a way that ends at `limit`, where it turns, if it does.
    pub fn fastest(&self, limit: Option<T>) -> T {
        let rises = self.start.sine.sign() >= 0.0 && limit.is_some();
        if rises { self.half_square.scale2(1).root() } else { self.period().1 }
    }

    /// The first way up to `far` after which half the square of the angular speed is this much.
    ///
    /// Errors: none; a search may have some.
    pub fn reaching(&self, level: T, far: T) -> Result<Option<T>, Refusal> {
        let rising = self.half_square.below(level);
        // From one extreme of the speed to the next.
        let Half { sine, cosine } = self.start;
        let half_turn = T::constant(Dd::PI);
        let to_bottom = -trig::angle(sine, cosine).scale2(1);
        let (mut before, mut next) =
            (T::zero(), if sine.sign() < 0.0 { to_bottom } else { to_bottom + half_turn });
        while before.below(far) {
            next = if next.below(far) { next } else { far };
            if self.half_square(next).reaches(level) == rising {
                let value = |way: T| Ok(self.half_square(way) - level);
                return root::between_values(before, next, rising, &value).map(Some);
            }
            (before, next) = (next, next + half_turn);
        }
        Ok(None)
    }

    /// The time over a way that ends at rest or not.
    pub fn time(&self, way: T, rest: bool) -> T {
        let first = self.first();
        let (k, _, complement) = self.modulus();
        // Half of the way as an angle of its own.
        let (sine, cosine) = trig::turn(way.scale2(-1));
        let last = self.start.plus(Half { sine, cosine });
        let mut last = if rest {
            // A hair from the top only this keeps the digits of the hair.
            Arc { sine: k, cosine: complement, pace: T::zero() }
        } else {
            let speed = self.half_square(way).scale2(1).root();
            Arc { sine: last.sine, cosine: last.cosine, pace: (speed / self.frequency).scale2(-1) }
        };
        // How often it has passed the top: an even number where the cosine has kept its sign.
        let half = trig::atan2(first.sine, first.cosine).f64() + 0.5 * way.f64();
        let tops = half / std::f64::consts::PI;
        let odd = last.cosine.sign() < 0.0;
        let passed = if odd { 2.0 * ((tops - 1.0) / 2.0).round() + 1.0 } else { 2.0 * (tops / 2.0).round() };
        let total = if passed < 0.5 {
            between(&first, &last, k, Half { sine, cosine })
        } else {
            if odd {
                (last.sine, last.cosine) = (-last.sine, -last.cosine);
            }
            let pace = complement;
            let one = T::of(1.0);
            let before = Arc { sine: one, cosine: T::zero(), pace };
            let beyond = Arc { sine: -one, cosine: T::zero(), pace };
            let up = Half { sine: first.cosine, cosine: first.sine };
            let down = Half { sine: last.cosine, cosine: -last.sine };
            let turn = elliptic::rf_of_roots(T::zero(), pace, k);
            between(&first, &before, k, up) + between(&beyond, &last, k, down) + turn * T::of(passed - 1.0)
        };
        plant!("eom: time of the swing", total.scale2(1)) / self.frequency
    }
}

/// Half of `int ds / sqrt((1 - s^2)(k^2 - s^2))` between two places of one swing whose halves are `step` apart:
/// R_F of four factors `1 - s, 1 + s, k - s, k + s` (NIST DLMF 19.29.4).
fn between<T: Real>(from: &Arc<T>, to: &Arc<T>, k: T, step: Half<T>) -> T {
    // The difference of the sines as a product: it vanishes with the way.
    let quarter = Half::of_point(step.sine, step.cosine);
    let middle = (from.cosine * quarter.cosine).balance(-(from.sine * quarter.sine));
    let apart = (quarter.sine * middle).scale2(1);
    if apart.is_zero() {
        return T::zero();
    }
    // Roots of the factors; the smaller of two from their product.
    let roots = |a: &Arc<T>| {
        let pair = |one: T, product: T| {
            let larger = (one + a.sine.abs()).root();
            let smaller = if larger.is_zero() { larger } else { product / larger };
            if a.sine.sign() < 0.0 { (larger, smaller) } else { (smaller, larger) }
        };
        (pair(T::of(1.0), a.cosine), pair(k, a.pace))
    };
    let ((x1, x2), (x3, x4)) = roots(to);
    let ((y1, y2), (y3, y4)) = roots(from);
    let u12 = (x1 * x2 * y3 * y4 + y1 * y2 * x3 * x4) / apart;
    let u13 = (x1 * x3 * y2 * y4 + y1 * y3 * x2 * x4) / apart;
    let u14 = (x1 * x4 * y2 * y3 + y1 * y4 * x2 * x3) / apart;
    elliptic::rf_of_roots(u12, u13, u14)
}
