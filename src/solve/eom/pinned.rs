//! The free body of a pinned body: Newton-Euler about its mass centre, with both components of the pin's force unknown.
//!
//! Along the line from the pin to the mass centre (radial, outward) and across it (with growing angle), `r` the arm:
//!
//! ```text
//! m a_r + R = F_r                         R: the pin's force toward the pin
//! m a_t - S = F_t                         S: the pin's force across, with growing angle
//! I alpha + r S = M                       moments about the mass centre
//! a_r = -r omega^2,   a_t = r alpha       the pin holds
//! ```
//! In these directions nothing on the left depends on the angle, so the system is solved once, for a unit of each load.
//! Source: Meriam & Kraige, *Engineering Mechanics: Dynamics*, article 6/4 (fixed-axis rotation); Hibbeler, *Dynamics*, 17.4.
use crate::num::half::Half;
use crate::num::linear::Linear;
use crate::num::plant::plant;
use crate::num::{Real, trig};
use crate::scene::{Arm, Numbers, Pin, Rest, Scene, Zero};
use crate::solve::outcome::Refusal;

/// A pinned body in numbers: everything that its angular acceleration and the force of its pin depend on.
///
/// Masses, forces and moments are in units of 2^e, as [`Numbers`] has them.
#[derive(Debug, Clone, Copy)]
pub struct Pinned<T> {
    /// Angle at the start.
    pub start: Half<T>,
    /// Weight.
    weight: T,
    /// Moment of the couples, positive with growing angle.
    couple: T,
    spring: Option<Spring<T>>,
    /// 1 where the angle counts from upright, -1 from hanging.
    up: f64,
    unit: Units<T>,
}

/// What a unit of each load does.
#[derive(Debug, Clone, Copy)]
struct Units<T> {
    /// Angular acceleration by a force across at the mass centre, and by a moment.
    turn_by_force: T,
    turn_by_moment: T,
    /// Force toward the pin by a radial force, and by the square of the angular speed.
    radial_by_force: T,
    radial_by_spin: T,
    /// Force of the pin across by a force across, and by a moment.
    across_by_force: T,
    across_by_moment: T,
}

/// The spring, places as seen from the pin.
#[derive(Debug, Clone, Copy)]
struct Spring<T> {
    /// Distance of its point of the body.
    at: T,
    /// The same from the mass centre, outward.
    lever: T,
    x: T,
    y: T,
    stiffness: T,
    natural: T,
}

/// Loads on the body at a place: forces through the mass centre and the moment about it.
#[derive(Debug, Clone, Copy)]
struct Load<T> {
    radial: T,
    across: T,
    moment: T,
}

/// The force of the pin.
#[derive(Debug, Clone, Copy)]
pub struct Held<T> {
    /// Toward the pin, and the magnitudes of its terms.
    pub radial: (T, f64),
    /// Across, positive with growing angle, and the magnitudes of its terms.
    pub across: (T, f64),
}

const RADIAL: usize = 0;
const ACROSS: usize = 1;
const MOMENT: usize = 2;
const SPIN: usize = 3;

/// The angular acceleration in doubles, for steps in time: one evaluation of the forces is a sine, a cosine and a few products.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    sine: f64,
    cosine: f64,
    up: f64,
    weight: f64,
    couple: f64,
    spring: Option<Spring<f64>>,
    by_force: f64,
    by_moment: f64,
}

impl Law {
    /// Angular acceleration when the body has turned by this angle from its start, radians, positive with growing angle.
    pub fn at(&self, turned: f64) -> f64 {
        let (s, c) = trig::sin_cos_f64(0.5 * turned);
        // By halves, so that a start a hair from upright keeps its digits.
        let (half_sine, half_cosine) = (self.sine * c + self.cosine * s, self.cosine * c - self.sine * s);
        let sine = 2.0 * half_sine * half_cosine;
        let free = self.weight * self.up * sine + self.couple;
        let Some(k) = &self.spring else { return free };
        let up = self.up * (half_cosine - half_sine) * (half_cosine + half_sine);
        let outward = k.x * sine + k.y * up - k.at;
        let across = k.x * self.up * up - k.y * self.up * sine;
        let length = (outward * outward + across * across).sqrt();
        let slope =
            if k.natural == 0.0 { k.stiffness } else { k.stiffness - k.stiffness * k.natural / length };
        free + slope * across * (self.by_force + k.lever * self.by_moment)
    }

    /// Is it certain that the angular acceleration is 0 at most once while the body turns from `a` to `b`, radians from its
    /// start? By value and derivative halfway and a bound of the second derivative: `f'` keeps its sign, or `f` does.
    pub fn changes_once(&self, a: f64, b: f64) -> bool {
        let (middle, reach) = (0.5 * (a + b), 0.5 * (b - a).abs());
        let (s, c) = trig::sin_cos_f64(0.5 * middle);
        let (half_sine, half_cosine) = (self.sine * c + self.cosine * s, self.cosine * c - self.sine * s);
        let cosine = (half_cosine - half_sine) * (half_cosine + half_sine);
        let (mut slope, mut bend) = (self.weight * self.up * cosine, self.weight.abs());
        if let Some(k) = &self.spring {
            // The anchor as seen from the pin, along the body and across it: across' = -along, length' = -at across / length.
            let sine = 2.0 * half_sine * half_cosine;
            let along = k.x * sine + k.y * self.up * cosine;
            let across = k.x * cosine - k.y * self.up * sine;
            let outward = along - k.at;
            let length = (outward * outward + across * across).sqrt();
            let far = (k.x * k.x + k.y * k.y).sqrt();
            let lever = k.stiffness * (self.by_force + k.lever * self.by_moment);
            if k.natural == 0.0 {
                slope -= lever * along;
                bend += (lever * far).abs();
            } else {
                // The point of the body is nowhere nearer to the anchor than this.
                let near = length - k.at.abs() * reach;
                if near.is_nan() || near <= 0.0 {
                    return false;
                }
                let (at, natural) = (k.at.abs(), k.natural.abs());
                let square = (across / length) * (across / length);
                slope -= lever * ((1.0 - k.natural / length) * along + k.natural * k.at * square / length);
                bend += lever.abs() * (far + natural / near * (far + 3.0 * at * (far + at) / near));
            }
        }
        slope.abs() >= bend * reach || self.at(middle).abs() >= (slope.abs() + 0.5 * bend * reach) * reach
    }
}

impl<T: Real> Spring<T> {
    fn doubles(&self) -> Spring<f64> {
        Spring {
            at: self.at.f64(),
            lever: self.lever.f64(),
            x: self.x.f64(),
            y: self.y.f64(),
            stiffness: self.stiffness.f64(),
            natural: self.natural.f64(),
        }
    }
}

impl<T: Real> Pinned<T> {
    /// The same body in doubles.
    pub fn doubles(&self) -> Pinned<f64> {
        let u = &self.unit;
        Pinned {
            start: Half { sine: self.start.sine.f64(), cosine: self.start.cosine.f64() },
            weight: self.weight.f64(),
            couple: self.couple.f64(),
            spring: self.spring.map(|s| s.doubles()),
            up: self.up,
            unit: Units {
                turn_by_force: u.turn_by_force.f64(),
                turn_by_moment: u.turn_by_moment.f64(),
                radial_by_force: u.radial_by_force.f64(),
                radial_by_spin: u.radial_by_spin.f64(),
                across_by_force: u.across_by_force.f64(),
                across_by_moment: u.across_by_moment.f64(),
            },
        }
    }

    /// The angular acceleration in doubles.
    pub fn law(&self) -> Law {
        Law {
            sine: self.start.sine.f64(),
            cosine: self.start.cosine.f64(),
            up: self.up,
            weight: (self.weight * self.unit.turn_by_force).f64(),
            couple: (self.couple * self.unit.turn_by_moment).f64(),
            spring: self.spring.map(|s| s.doubles()),
            by_force: self.unit.turn_by_force.f64(),
            by_moment: self.unit.turn_by_moment.f64(),
        }
    }

    /// Reads the body and solves its equations for a unit of each load.
    ///
    /// Errors: equations that do not determine the motion (no inertia about the pin).
    pub fn new(scene: &Scene, n: &Numbers<T>, body: usize, pin: &Pin) -> Result<Self, Refusal> {
        let numbers = n.bodies[body];
        let arm = Self::arm(n, pin);
        let couple = scene.couples.iter().fold(T::zero(), |sum, c| {
            let moment = plant!("eom: moment of a couple on a pinned body", n.massive(c.moment_n_m));
            if c.forward { sum + moment } else { sum - moment }
        });
        let mut pinned = Self {
            start: Half::of_degrees(n.get(pin.start_deg)),
            weight: plant!("eom: weight of a pinned body", numbers.mass * n.gravity),
            couple,
            spring: None,
            up: if pin.from == Zero::Upright { 1.0 } else { -1.0 },
            unit: Self::units(numbers.mass, numbers.inertia, arm)?,
        };
        if let Some(s) = &pin.spring {
            let at = n.get(s.at_m);
            let lever = at - plant!("eom: mass centre as seen from the spring", arm);
            let (x, y) = (n.get(s.x_m), n.get(s.y_m));
            let stiffness =
                plant!("eom: stiffness of the spring on a pinned body", n.massive(s.stiffness_n_m));
            let mut spring = Spring { at, lever, x, y, stiffness, natural: T::zero() };
            spring.natural = match s.rest {
                Rest::Length(l) => n.get(l),
                Rest::Stretch(x0) => pinned.away(&spring, &pinned.start).2 - n.get(x0),
            };
            pinned.spring = Some(spring);
        }
        Ok(pinned)
    }

    /// Distance from the pin to the mass centre.
    pub fn arm(n: &Numbers<T>, pin: &Pin) -> T {
        match pin.arm {
            Arm::Distance(h) => n.get(h),
            Arm::HalfOf(l) => n.get(l).scale2(-1),
        }
    }

    /// Solves for a unit of each load.
    fn units(mass: T, inertia: T, arm: T) -> Result<Units<T>, Refusal> {
        // Unknowns: angular acceleration, accelerations outward and across, force of the pin toward it and across.
        let (alpha, out, across, toward, side) = (0, 1, 2, 3, 4);
        let one = T::of(1.0);
        let mut rows = Linear::new(5, 4);
        rows.term(0, alpha, plant!("eom: inertia about the mass centre", inertia));
        rows.term(0, side, plant!("eom: lever of the pin", arm));
        rows.right(0, MOMENT, one);
        rows.term(1, out, plant!("eom: mass times acceleration outward", mass));
        rows.term(1, toward, one);
        rows.right(1, RADIAL, one);
        rows.term(2, across, plant!("eom: mass times acceleration across", mass));
        rows.term(2, side, -one);
        rows.right(2, ACROSS, one);
        rows.term(3, out, one);
        rows.right(3, SPIN, -plant!("eom: arm of the centripetal acceleration", arm));
        rows.term(4, across, one);
        rows.term(4, alpha, -plant!("eom: arm of the acceleration across", arm));
        let found = rows.solve().map_err(|s| Refusal::Singular { unknowns: s.unknowns, rank: s.rank })?;
        Ok(Units {
            turn_by_force: found.get(alpha, ACROSS),
            turn_by_moment: found.get(alpha, MOMENT),
            radial_by_force: found.get(toward, RADIAL),
            radial_by_spin: found.get(toward, SPIN),
            across_by_force: found.get(side, ACROSS),
            across_by_moment: found.get(side, MOMENT),
        })
    }

    /// Moment of inertia about the pin: what a moment of 1 accelerates by its inverse.
    pub fn inertia(&self) -> T {
        T::of(1.0) / self.unit.turn_by_moment
    }

    /// Angular acceleration when the body has turned by this angle from its start, radians, positive with growing angle.
    ///
    /// One evaluation of the forces; for angles of a few turns.
    pub fn acceleration_after(&self, turned: T) -> T {
        self.acceleration(&self.start.plus(Half::of_radians(turned)))
    }

    /// Angular acceleration at a place; exactly 0 where the moments balance.
    pub fn acceleration(&self, place: &Half<T>) -> T {
        self.acceleration_of_terms(place).0
    }

    /// The same with the sum of the magnitudes of its terms.
    pub fn acceleration_of_terms(&self, place: &Half<T>) -> (T, f64) {
        let weight = self.weight_across(place) * self.unit.turn_by_force;
        let couple = self.couple * self.unit.turn_by_moment;
        total(&[weight, couple, self.pulling(place)])
    }

    /// The share of the spring in the angular acceleration.
    pub fn pulling(&self, place: &Half<T>) -> T {
        let Some(spring) = &self.spring else { return T::zero() };
        let pull = self.pull(spring, place);
        pull.across * self.unit.turn_by_force + pull.moment * self.unit.turn_by_moment
    }

    /// Magnitude of the terms that make up the share of the spring, without its natural length.
    pub fn pull_terms(&self) -> f64 {
        let Some(s) = &self.spring else { return 0.0 };
        let turn = self.unit.turn_by_force + s.lever * self.unit.turn_by_moment;
        (s.stiffness * turn).size() * (s.x.size() + s.y.size())
    }

    /// Does the angle count from upright?
    pub fn is_upright(&self) -> bool {
        self.up > 0.0
    }

    /// Is there a spring?
    pub fn has_spring(&self) -> bool {
        self.spring.is_some()
    }

    /// `int alpha d phi` from one place to another of all but the spring: `turned` apart, radians with sign.
    ///
    /// The weight's part is a difference of cosines, written as a product.
    pub fn closed_gain(&self, from: &Half<T>, to: &Half<T>, step: &Half<T>, turned: T) -> T {
        let product = (step.sine * to.plus(*from).sine).scale2(1);
        let weight = plant!("eom: integral of the weight's moment", self.weight) * product.signed(self.up);
        let couple = plant!("eom: integral of the couple", self.couple) * turned * self.unit.turn_by_moment;
        (weight * self.unit.turn_by_force).balance(couple)
    }

    /// Angular frequency of small swings under the weight alone; 0 where the mass centre is at the pin.
    pub fn frequency(&self) -> T {
        (self.weight * self.unit.turn_by_force).root()
    }

    /// Force of the spring, positive if it pulls, and the magnitudes of its terms.
    pub fn spring_force(&self, place: &Half<T>) -> Option<(T, f64)> {
        let spring = self.spring.as_ref()?;
        let (_, _, length) = self.away(spring, place);
        let force = spring.stiffness * length.balance(-spring.natural);
        Some((force, (spring.stiffness * (length + spring.natural)).f64().abs()))
    }

    /// Force of the pin at a place, at this square of the angular speed.
    pub fn held(&self, place: &Half<T>, square: T) -> Held<T> {
        let u = &self.unit;
        let pull = match &self.spring {
            Some(s) => self.pull(s, place),
            None => Load { radial: T::zero(), across: T::zero(), moment: T::zero() },
        };
        let weight = -place.full_cosine().signed(self.up)
            * plant!("eom: weight along the line to the pin", self.weight);
        let radial = [weight * u.radial_by_force, pull.radial * u.radial_by_force, square * u.radial_by_spin];
        let across = [
            self.weight_across(place) * u.across_by_force,
            pull.across * u.across_by_force,
            pull.moment * u.across_by_moment,
            self.couple * u.across_by_moment,
        ];
        Held { radial: total(&radial), across: total(&across) }
    }

    fn weight_across(&self, place: &Half<T>) -> T {
        place.full_sine().signed(self.up) * plant!("eom: weight across the line to the pin", self.weight)
    }

    /// The anchor as seen from the spring's point of the body: outward, across, and how far.
    fn away(&self, s: &Spring<T>, place: &Half<T>) -> (T, T, T) {
        let (sine, cosine) = (place.full_sine(), place.full_cosine());
        let up = cosine.signed(self.up);
        let outward = plant!("eom: anchor along the body", s.x * sine + s.y * up) - s.at;
        let across = s.x * cosine - s.y * sine.signed(self.up);
        let across = plant!("eom: anchor across the body", across);
        (outward, across, (outward.square() + across.square()).root())
    }

    fn pull(&self, s: &Spring<T>, place: &Half<T>) -> Load<T> {
        let (outward, across, length) = self.away(s, place);
        // A spring without natural length pulls in proportion to the distance, also where that is 0.
        let slope =
            if s.natural.is_zero() { s.stiffness } else { s.stiffness - s.stiffness * s.natural / length };
        let across = slope * across;
        let moment = plant!("eom: lever of the spring", s.lever) * across;
        Load { radial: slope * outward, across, moment }
    }
}

/// Sum of terms, exactly 0 where they cancel, and the sum of their magnitudes.
fn total<T: Real>(terms: &[T]) -> (T, f64) {
    let size = terms.iter().fold(0.0, |sum, t| sum + t.size());
    let sum = terms.iter().fold(T::zero(), |sum, t| sum + *t);
    (sum.cleared(size), size.f64())
}
