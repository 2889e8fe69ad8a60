//! A body on a pin under its weight alone: what the balance of its energies gives in closed form. The time is Legendre's integral of
//! the first kind, here by the arithmetic-geometric mean, its amplitude from the addition theorem of the elliptic functions.
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::num::{Dd, Real, ball, elliptic, trig};

/// A place as the integral sees it: sine and cosine of half the angle from hanging, growing on the way, and the pace
/// `omega / (2 frequency)`.
#[derive(Debug, Clone, Copy)]
struct Bob<T> {
    sine: T,
    cosine: T,
    pace: T,
}

/// The body on its way in one sense.
#[derive(Debug, Clone, Copy)]
pub struct Pendulum<T> {
    /// Half of the angle at the start, and whether it counts from upright.
    start: Half<T>,
    upright: bool,
    /// Does the angle grow (1) or shrink (-1)?
    sense: f64,
    /// Angular frequency of small swings.
    frequency: T,
    first: Bob<T>,
}

impl<T: Real> Pendulum<T> {
    /// One that starts at this angle, counted from upright or from hanging, with this spin, and moves in this sense.
    pub fn new((start, upright): (Half<T>, bool), sense: f64, spin: T, frequency: T) -> Self {
        let hanging = if upright { start.less_half_turn() } else { start };
        let pace = (spin.abs() / frequency).scale2(-1);
        let (sine, cosine) = (hanging.sine.signed(sense), hanging.cosine);
        // Beyond the top it is a turn further on: both signs are those of the same place between top and top.
        let beyond = cosine.sign() < 0.0 || (cosine.is_zero() && sine.sign() > 0.0);
        let (sine, cosine) = if beyond { (-sine, -cosine) } else { (sine, cosine) };
        Self { start, upright, sense, frequency, first: Bob { sine, cosine, pace } }
    }

    /// Energy from the lowest place as a share of that at the top: `k^2`, and `1 - k^2` with its root.
    fn share(&self) -> (T, T, T) {
        let Bob { sine, cosine, pace } = self.first;
        if pace.is_zero() {
            return (sine.square(), cosine.square(), cosine);
        }
        let rest = cosine.square().balance(-pace.square());
        (sine.square() + pace.square(), rest, rest.abs().root())
    }
    fn modulus(&self) -> T {
        if self.first.pace.is_zero() { self.first.sine.abs() } else { self.share().0.root() }
    }

    /// The way to where it comes to rest, and that place; `None` if it goes over the top.
    pub fn turning(&self) -> Option<(T, Half<T>)> {
        let Bob { sine, cosine, .. } = self.first;
        let (_, rest, complement) = self.share();
        if rest.sign() < 0.0 {
            return None;
        }
        // It turns where half the angle has the sine k.
        let k = self.modulus();
        let across = (k * cosine).balance(-(complement * sine));
        let way = trig::angle(across, (complement * cosine).balance(k * sine)).scale2(1);
        let hanging = Half { sine: k.signed(self.sense), cosine: complement };
        // From upright it is half a turn more; and a whole turn more or less, as the way there has it.
        let place = if self.upright { Half { sine: hanging.cosine, cosine: -hanging.sine } } else { hanging };
        let roughly = self.start.plus(Half::of_radians(way.signed(self.sense)));
        let same = place.sine * roughly.sine + place.cosine * roughly.cosine;
        Some((way, if same.sign() < 0.0 { place.less_half_turn().less_half_turn() } else { place }))
    }

    /// Period, and greatest angular speed, from the energy at the lowest place.
    pub fn period(&self) -> (T, T) {
        let ((_, rest, complement), k) = (self.share(), self.modulus());
        let quarters = if rest.sign() < 0.0 {
            (elliptic::complete(complement / k) / k).scale2(1)
        } else {
            elliptic::complete(complement).scale2(2)
        };
        (quarters / self.frequency, (k * self.frequency).scale2(1))
    }

    /// The time over a way to a place where it has this angular speed.
    pub fn time(&self, way: T, place: &Half<T>, speed: T) -> T {
        if way.is_zero() {
            return T::zero();
        }
        // What rounding leaves open of the time is open of nothing else.
        let (time, doubt) = ball::watch(|| self.integral(way, &self.last(way, place, speed)));
        let time = plant!("energy: time of the swing", time) / self.frequency;
        if doubt { time.widened(|| f64::INFINITY) } else { time }
    }

    /// A place on the way, with the signs that sine and cosine have there.
    fn last(&self, way: T, place: &Half<T>, speed: T) -> Bob<T> {
        let hanging = if self.upright { place.less_half_turn() } else { *place };
        let (sine, cosine) = (hanging.sine.signed(self.sense), hanging.cosine);
        // Which of the two signs: the half angle is that of the start and half the way, roughly.
        let half = trig::atan2(self.first.sine, self.first.cosine).f64() + 0.5 * way.f64();
        let (s, c) = trig::sin_cos_radians(Dd::new(half));
        let turned = s.hi * sine.f64() + c.hi * cosine.f64() < 0.0;
        let (sine, cosine) = if turned { (-sine, -cosine) } else { (sine, cosine) };
        Bob { sine, cosine, pace: (speed / self.frequency).scale2(-1) }
    }

    fn integral(&self, way: T, last: &Bob<T>) -> T {
        let Bob { sine: s0, cosine: c0, pace: p0 } = self.first;
        let Bob { sine: s1, cosine: c1, pace: p1 } = *last;
        let (k2, rest, complement) = self.share();
        if rest.sign() < 0.0 {
            // Over the top: modulus 1/k; the amplitude is half the angle.
            let k = k2.root();
            let across = k * (s1 * c0 * p0).balance(-(s0 * c1 * p1));
            let along = (k2 * c0 * c1).balance(s0 * s1 * p0 * p1);
            let complement = complement / k;
            // The way of a turn is half a turn of the amplitude, after two turns all is as before: in the first of two, or in the second.
            let back = across.sign() < 0.0;
            let middle = if back { 3.0 } else { 1.0 };
            let pairs =
                ((way.f64() / std::f64::consts::PI - middle) / 4.0).round() + if back { 1.0 } else { 0.0 };
            let own = elliptic::incomplete(across.abs(), along, complement);
            let own = if back { -own } else { own };
            let whole = || elliptic::complete(complement).scale2(2) * T::of(pairs);
            return if pairs > 0.0 { whole() + own } else { own } / k;
        }
        if p0.is_zero() {
            // From rest, without the common factors, which may be very small.
            return elliptic::incomplete(p1, -(s1 * c0), complement);
        }
        let across = (s1 * p0 * c0).balance(-(s0 * p1 * c1));
        let along = (p0 * p1).balance(s0 * s1 * c0 * c1);
        elliptic::incomplete(across, along, complement)
    }
}
