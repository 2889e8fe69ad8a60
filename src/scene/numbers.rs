//! The numbers of a scene, read once: masses, inertias, slopes. Arithmetic on data, no mechanics.
use crate::num::{Real, trig};
use crate::scene::{Body, Mass, Num, Part, RotaryInertia, Scene, Slope, inertia};
use smallvec::SmallVec;

/// The numbers of one body.
#[derive(Debug, Clone, Copy)]
pub struct BodyNumbers<T> {
    /// Mass.
    pub mass: T,
    /// Moment of inertia about the mass centre.
    pub inertia: T,
    /// Height gained per metre forward: the sine of the slope, negative where forward is down.
    pub climb: T,
    /// Cosine of the slope.
    pub level: T,
}

/// The numbers of a scene.
#[derive(Debug, Clone)]
pub struct Numbers<'a, T> {
    data: &'a [f64],
    /// Acceleration of free fall, m/s^2.
    pub gravity: T,
    /// One for each body.
    pub bodies: SmallVec<[BodyNumbers<T>; 1]>,
}

impl<'a, T: Real> Numbers<'a, T> {
    /// Reads the numbers of a scene.
    pub fn new(scene: &Scene, data: &'a [f64]) -> Self {
        let mut n = Self { data, gravity: T::zero(), bodies: SmallVec::new() };
        n.gravity = n.get(scene.gravity_m_s2);
        // Bodies on one incline share its sine and cosine.
        let mut known: Option<(Num, T, T)> = None;
        for b in &scene.bodies {
            let mass = n.mass_of(b, &b.mass);
            let inertia = n.inertia_of(b, mass);
            let (sine, cosine) = match b.line.map(|l| l.slope) {
                None => (T::zero(), T::zero()),
                Some(Slope::Level) => (T::zero(), T::of(1.0)),
                Some(Slope::Vertical) => (T::of(1.0), T::zero()),
                Some(Slope::Degrees(angle)) => match known {
                    Some((a, s, c)) if a == angle => (s, c),
                    _ => {
                        let (s, c) = trig::sin_cos_of_degrees(n.get(angle));
                        known = Some((angle, s, c));
                        (s, c)
                    }
                },
            };
            let climb = if b.line.is_some_and(|l| l.forward_up) { sine } else { -sine };
            n.bodies.push(BodyNumbers { mass, inertia, climb, level: cosine });
        }
        n
    }

    /// A number of the scene.
    #[inline]
    pub fn get(&self, num: Num) -> T {
        match num {
            Num::Datum(i) => T::datum(self.data.get(i).copied().unwrap_or(f64::NAN)),
            Num::Fixed(x) => T::datum(x),
        }
    }

    fn mass_of(&self, body: &Body, mass: &Mass) -> T {
        match mass {
            Mass::Kilograms(m) => self.get(*m),
            Mass::Weight(w) => self.get(*w) / self.gravity,
            Mass::OfParts => match &body.inertia {
                Some(RotaryInertia::Parts(parts)) => {
                    parts.iter().fold(T::zero(), |sum, p| sum + self.mass_of(body, &p.mass))
                }
                _ => body.particles.iter().fold(T::zero(), |sum, p| sum + self.get(p.mass_kg)),
            },
        }
    }

    fn inertia_of(&self, body: &Body, mass: T) -> T {
        match &body.inertia {
            None => T::zero(),
            Some(RotaryInertia::Gyration(k)) => mass * self.get(*k).square(),
            Some(RotaryInertia::Moment(i)) => self.get(*i),
            Some(RotaryInertia::Shape(shape, r)) => mass * inertia::beta::<T>(*shape) * self.get(*r).square(),
            Some(RotaryInertia::Parts(parts)) => {
                parts.iter().fold(T::zero(), |sum, Part { mass, shape, radius_m }| {
                    sum + self.mass_of(body, mass) * inertia::beta::<T>(*shape) * self.get(*radius_m).square()
                })
            }
        }
    }
}
