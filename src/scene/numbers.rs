//! The numbers of a scene, read once: masses, inertias, slopes. Arithmetic on data, no mechanics.
//!
//! Everything with the dimension of mass is divided by a power of two near the first mass; [`Numbers::publish`] undoes it. A mass
//! beyond 2^128 kg or its inverse stays: such a scene is solved in units of its own ([`crate::scene::Scales`]).
use crate::num::dd::exponent;
use crate::num::{Real, trig};
use crate::scene::{
    Body, Coordinate, Degree, Mass, Num, Part, Quantity, RotaryInertia, Scene, Slope, inertia,
};
use smallvec::SmallVec;

/// The numbers of one body.
#[derive(Debug, Clone, Copy)]
pub struct BodyNumbers<T> {
    /// Mass, in units of 2^e kg.
    pub mass: T,
    /// Moment of inertia about the mass centre, in units of 2^e kg m^2.
    pub inertia: T,
    /// Height gained per metre forward: the sine of the slope, negative where forward is down.
    pub climb: T,
    /// Cosine of the slope.
    pub level: T,
    /// How it is carried, forward and out of its line; `None` where the scene stands on the ground.
    pub carried: Option<[Carried<T>; 2]>,
}

/// One component of the motion of what carries a scene.
#[derive(Debug, Clone, Copy)]
pub struct Carried<T> {
    /// Speed at the start, m/s.
    pub speed: T,
    /// The number that is this speed, where it goes along whole.
    pub given: Option<Num>,
    /// Acceleration, m/s^2.
    pub acceleration: T,
}

impl<T: Real> Carried<T> {
    /// Speed after a time.
    pub fn after(&self, time: T) -> T {
        self.speed.balance(self.acceleration * time)
    }
    /// Way in a time.
    pub fn way(&self, time: T) -> T {
        (self.speed * time).balance((self.acceleration * time.square()).scale2(-1))
    }
}

/// The speed of what goes along its line with one velocity and out of it with another.
pub fn speed<T: Real>(along: T, out: T) -> T {
    if out.is_zero() { along.abs() } else { (along.square() + out.square()).root() }
}

/// The numbers of a scene.
#[derive(Debug, Clone)]
pub struct Numbers<'a, T> {
    data: &'a [f64],
    /// The numbers that are worked out from data.
    derived: SmallVec<[T; 1]>,
    mass_exponent: i32,
    /// Acceleration of free fall, m/s^2; 0 in a horizontal plane.
    pub gravity: T,
    /// Acceleration of what carries the scene, to the right and up.
    pub carried: Option<[T; 2]>,
    /// One for each body.
    pub bodies: SmallVec<[BodyNumbers<T>; 1]>,
}

impl<'a, T: Real> Numbers<'a, T> {
    /// The same numbers of the same scene in doubles.
    pub fn in_doubles(&self, scene: &Scene) -> Numbers<'a, f64> {
        Numbers::new(scene, self.data)
    }
    /// Reads the numbers of a scene.
    pub fn new(scene: &Scene, data: &'a [f64]) -> Self {
        Self::after(scene, data, &[])
    }
    /// The same of a motion that takes over so much of another one ([`crate::scene::Derived::value_after`]).
    pub fn after(scene: &Scene, data: &'a [f64], taken: &[T]) -> Self {
        let derived = scene.formulas.numbers.iter().map(|number| number.value_after(data, taken)).collect();
        let (gravity, bodies) = (T::zero(), SmallVec::new());
        let mut n = Self { data, derived, mass_exponent: 0, gravity, carried: None, bodies };
        n.gravity = n.get(scene.gravity_m_s2);
        let first = scene.bodies.iter().map(|b| n.mass_of(b, &b.mass).size()).find(|m| *m > 0.0);
        n.mass_exponent = first.map_or(0, exponent);
        if n.mass_exponent.abs() > 128 {
            n.mass_exponent = 0;
        }
        // Bodies on one incline share its sine and cosine.
        let mut known: Option<(Num, T, T)> = None;
        let mut direction = |n: &Self, slope: Option<Slope>| match slope {
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
        let carrier = scene.carried.map(|c| (c, direction(&n, Some(c.slope))));
        n.carried = carrier.map(|(c, (s, level))| [level, s].map(|x| x * n.get(c.acceleration_m_s2)));
        for b in &scene.bodies {
            let mass = n.mass_of(b, &b.mass);
            let inertia = n.inertia_of(b, mass);
            let (mass, inertia) = if b.removed { (-mass, -inertia) } else { (mass, inertia) };
            let slope = b.line.map(|l| l.slope);
            let (sine, cosine) = direction(&n, slope);
            let up = b.line.is_some_and(|l| l.forward_up);
            let climb = if up { sine } else { -sine };
            let carried = carrier.map(|(c, (s, level))| {
                let (along, out) = if slope == Some(c.slope) {
                    (T::of(1.0), T::zero())
                } else {
                    (level * cosine + s * sine, s * cosine - level * sine)
                };
                [along.signed(if up { 1.0 } else { -1.0 }), out].map(|share| Carried {
                    speed: share * n.get(c.speed_m_s),
                    given: share.same(T::of(1.0)).then_some(c.speed_m_s),
                    acceleration: share * n.get(c.acceleration_m_s2),
                })
            });
            n.bodies.push(BodyNumbers { mass, inertia, climb, level: cosine, carried });
        }
        if scene.lies_level() {
            n.gravity = T::zero();
        }
        n
    }

    /// A number without the dimension of mass.
    #[inline]
    pub fn get(&self, num: Num) -> T {
        match num {
            Num::Datum(i) => T::given(i, self.data.get(i).copied().unwrap_or(f64::NAN)),
            Num::Fixed(x) => T::datum(x),
            Num::Derived(i) => self.derived.get(i).copied().unwrap_or_else(|| T::of(f64::NAN)),
        }
    }

    /// A speed or spin that the start gives, counted on what carries the scene.
    pub fn start(&self, c: Coordinate, given: Num) -> T {
        match (c.degree, self.bodies[c.body].carried) {
            // The same number twice has no difference, whatever its rounding.
            (Degree::Along, Some([forward, _])) if forward.given == Some(given) => T::zero(),
            (Degree::Along, Some([forward, _])) => self.get(given).apart(forward.speed),
            _ => self.get(given),
        }
    }

    /// A number with the dimension of mass (a force, a stiffness, a moment), in units of 2^e.
    #[inline]
    pub fn massive(&self, num: Num) -> T {
        self.get(num).scale2(-self.mass_exponent)
    }

    /// Power of two that gives a quantity back its SI size.
    pub fn exponent(&self, quantity: Quantity) -> i32 {
        if quantity.is_massive() { self.mass_exponent } else { 0 }
    }

    /// Gives a quantity back its SI size.
    #[inline]
    pub fn publish(&self, quantity: Quantity, value: T) -> T {
        match self.exponent(quantity) {
            0 => value,
            e => value.scale2(e),
        }
    }

    fn mass_of(&self, body: &Body, mass: &Mass) -> T {
        match mass {
            Mass::Kilograms(m) => self.massive(*m),
            Mass::Weight(w) => self.massive(*w) / self.gravity,
            Mass::OfParts => match &body.inertia {
                Some(RotaryInertia::Parts(parts)) => {
                    parts.iter().fold(T::zero(), |sum, p| sum + self.mass_of(body, &p.mass))
                }
                _ => body.particles.iter().fold(T::zero(), |sum, p| sum + self.massive(p.mass_kg)),
            },
        }
    }

    fn inertia_of(&self, body: &Body, mass: T) -> T {
        match &body.inertia {
            None => T::zero(),
            Some(RotaryInertia::Gyration(k)) => mass * self.get(*k).square(),
            Some(RotaryInertia::Moment(i)) => self.massive(*i),
            Some(RotaryInertia::Shape(shape, r)) => mass * inertia::beta::<T>(*shape) * self.get(*r).square(),
            Some(RotaryInertia::Parts(parts)) => {
                parts.iter().fold(T::zero(), |sum, Part { mass, shape, radius_m }| {
                    sum + self.mass_of(body, mass) * inertia::beta::<T>(*shape) * self.get(*radius_m).square()
                })
            }
        }
    }
}
