//! The same scene in other units of mass, length and time. They are powers of two of the SI units, so that every number keeps its
//! digits.
//!
//! Products of data near 1e150 or 1e-150 leave the doubles in SI units; in units of the size of the scene few do.
use crate::num::dd::{exponent, ldexp};
use crate::scene::{Formulas, Label, Num, Owner, Scene, given};

/// Units of mass, length and time: 2^e kg, m and s.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scales {
    mass: i32,
    length: i32,
    time: i32,
}

/// Sizes of scaled data up to which products of a few of them stay inside the doubles, as a power of two.
const ROOM: i32 = 900;
/// Steps between units that are tried, and how many of them to each side of the middle: of mass, length and time.
const STEPS: [i32; 3] = [160, 96, 96];
const TRIED: [i32; 3] = [2, 3, 6];

impl Scales {
    /// The units of SI.
    pub const SI: Self = Self { mass: 0, length: 0, time: 0 };

    /// Powers of mass, length and time of a unit of SI.
    fn powers(unit: &str) -> [i32; 3] {
        match unit {
            "kg" => [1, 0, 0],
            "m" => [0, 1, 0],
            "s" => [0, 0, 1],
            "m/s" => [0, 1, -1],
            "m/s^2" => [0, 1, -2],
            "rad/s" => [0, 0, -1],
            "rad/s^2" => [0, 0, -2],
            "N" => [1, 1, -2],
            "N/m" => [1, 0, -2],
            "N/m^2" => [1, -1, -2],
            "N/m^3" => [1, -2, -2],
            "N/s" => [1, 1, -3],
            "N/s^2" => [1, 1, -4],
            "N/s^3" => [1, 1, -5],
            "N*m/s^2" => [1, 2, -4],
            "N*m/s^3" => [1, 2, -5],
            "N*m" | "N*m/rad" | "N*m/rad^2" | "N*m/rad^3" | "J" => [1, 2, -2],
            "N*m/s" | "W" => [1, 2, -3],
            "kg*m^2" => [1, 2, 0],
            "kg*m^2/s" => [1, 2, -1],
            "N*s" => [1, 1, -1],
            _ => [0, 0, 0],
        }
    }
    /// The exponent with which the number of a unit of SI is scaled.
    fn power(self, unit: &str) -> i32 {
        self.of_powers(Self::powers(unit))
    }
    /// The same for a unit of these powers of mass, length and time.
    fn of_powers(self, [mass, length, time]: [i32; 3]) -> i32 {
        mass * self.mass + length * self.length + time * self.time
    }
    fn of_label(self, scene: &Scene, label: Label) -> i32 {
        self.of_powers(Self::powers_of(scene, label))
    }
    /// The value of a quantity in SI that is `x` in these units.
    pub fn said(self, scene: &Scene, label: Label, x: f64) -> f64 {
        ldexp(x, self.of_label(scene, label))
    }
    /// The value of a quantity in these units that is `x` in SI.
    pub fn own_said(self, scene: &Scene, label: Label, x: f64) -> f64 {
        ldexp(x, -self.of_label(scene, label))
    }
    /// A number in a unit of SI that is `x` in these units.
    pub fn si(self, unit: &str, x: f64) -> f64 {
        ldexp(x, self.power(unit))
    }
    /// A number in these units that is `x` in a unit of SI.
    pub fn own(self, unit: &str, x: f64) -> f64 {
        ldexp(x, -self.power(unit))
    }

    /// Powers of mass, length and time of what is said of a label.
    pub fn powers_of(scene: &Scene, label: Label) -> [i32; 3] {
        match label.of {
            Owner::Asked(i) => scene.formulas.asked.get(i).map_or([0; 3], |a| a.powers),
            _ => Self::powers(label.quantity.unit()),
        }
    }

    /// The scene and its data in these units; `None` where a number leaves the doubles.
    pub fn of(self, scene: &Scene, data: &[f64]) -> Option<(Scene, Vec<f64>)> {
        let (mut scaled, mut numbers, mut inside) = (scene.clone(), data.to_vec(), true);
        for (_, other) in &mut scaled.formulas.others {
            // What a motion takes over counts constants in SI, without their units.
            if !other.formulas.taken.is_empty() && self != Self::SI {
                return None;
            }
            let (in_scales, own) = self.of(other, data)?;
            *other = in_scales;
            for (number, (own, old)) in numbers.iter_mut().zip(own.iter().zip(data)) {
                if own.to_bits() != old.to_bits() {
                    *number = *own;
                }
            }
        }
        given::change::all(&mut scaled, &mut |num, (unit, _)| {
            let (old, new) = match num {
                Num::Datum(i) => match (data.get(*i), numbers.get_mut(*i)) {
                    (Some(old), Some(new)) => (*old, new),
                    _ => return,
                },
                Num::Fixed(x) => (*x, x),
                // A formula is worked out from data in these units.
                Num::Derived(_) => return,
            };
            *new = self.own(unit, old);
            inside &= old == 0.0 || *new != 0.0 && exponent(*new).abs() <= ROOM;
        });
        if let Some(found) = &mut scaled.formulas.found {
            let power = self.of_powers(found.unknown.powers);
            found.range = found.range.map(|x| ldexp(x, -power));
        }
        for given in scene.formulas.givens() {
            let power = self.of_powers(given.powers);
            if let (Some(old), Some(new)) = (data.get(given.datum), numbers.get_mut(given.datum)) {
                *new = ldexp(*old, -power);
                inside &= *old == 0.0 || *new != 0.0 && exponent(*new).abs() <= ROOM;
            }
        }
        inside.then_some((scaled, numbers))
    }

    /// Units to be tried for a scene, those first in which its lengths, masses and weights are nearest to 1.
    pub fn tried(scene: &Scene, data: &[f64]) -> impl Iterator<Item = Self> {
        let mut known: Vec<(&'static str, i32)> = Vec::new();
        given::read::all(scene, &mut |num, (unit, _)| {
            let x = match num {
                Num::Datum(i) => data.get(*i).copied().unwrap_or(0.0),
                Num::Fixed(x) => *x,
                Num::Derived(_) => 0.0,
            };
            if x != 0.0 && x.is_finite() {
                known.push((unit, exponent(x)));
            }
        });
        // The middle of the sizes of one kind.
        let middle = |wanted: &dyn Fn(&str, i32) -> Option<i32>| {
            let sizes = || known.iter().filter_map(|(unit, e)| wanted(unit, *e));
            sizes().min().zip(sizes().max()).map_or(0, |(least, most)| i32::midpoint(least, most))
        };
        let length = middle(&|unit, e| (unit == "m").then_some(e));
        // As a length over the square of a time, that of the weight.
        let time = (length - middle(&|unit, e| (unit == "m/s^2").then_some(e))) / 2;
        let free = Self { mass: 0, length, time };
        let mass = middle(&|unit, e| is_massive(unit).then(|| e - free.power(unit)));
        let mut tried: Vec<[i32; 3]> = Vec::new();
        for m in -TRIED[0]..=TRIED[0] {
            for l in -TRIED[1]..=TRIED[1] {
                tried.extend((-TRIED[2]..=TRIED[2]).map(|t| [m, l, t]));
            }
        }
        tried.sort_unstable_by_key(|steps| (steps.iter().map(|s| s.abs()).sum::<i32>(), *steps));
        tried.into_iter().map(move |[m, l, t]| Self {
            mass: mass + STEPS[0] * m,
            length: length + STEPS[1] * l,
            time: time + STEPS[2] * t,
        })
    }
}

/// Powers of mass, length and time of these data, where a change of units changes nothing but them: no number of the scene that is no
/// datum has a unit.
pub fn powers_of_data(scene: &Scene, data: &[usize]) -> Option<Vec<[i32; 3]>> {
    let mut powers: Vec<Option<[i32; 3]>> = vec![None; data.len()];
    let mut all = scene.formulas == Formulas::default();
    given::read::all(scene, &mut |num, (unit, _)| {
        let own = Scales::powers(unit);
        match *num {
            Num::Datum(i) => {
                if let Some(at) = data.iter().position(|datum| *datum == i) {
                    all &= *powers[at].get_or_insert(own) == own;
                }
            }
            Num::Fixed(x) => all &= x == 0.0 || own == [0; 3],
            Num::Derived(_) => all = false,
        }
    });
    powers.into_iter().collect::<Option<_>>().filter(|_| all)
}

/// Has a unit of the scene the dimension of mass in it?
pub fn is_massive(unit: &str) -> bool {
    Scales { mass: 1, length: 0, time: 0 }.power(unit) != 0
}
