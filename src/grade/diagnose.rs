//! What a wrong number has in common with numbers that are known: wrong methods, powers of ten, units, other parts. It says
//! only what the match proves, and never makes a wrong answer right.
use crate::answer::figures::{self, Figures};
use crate::answer::read::{Reading, UnitCache, read};
use crate::key::{Answer, KeyEntry, WrongValue};
use crate::num::shown;
use crate::num::trig::{log10, power};
use crate::units::Dimension;

/// What a wrong answer fits.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagnosis {
    /// Wrong methods that come to this number, far likelier than by chance: indices into the methods of the problem, the
    /// nearest first. Of several it is one.
    pub methods: Vec<u16>,
    /// All that come within the tolerance of the number, for credit, where the benefit of the doubt is the student's.
    pub near: Vec<u16>,
    /// A slip of the pen.
    pub slip: Option<AnswerSlip>,
}

/// A slip that is no wrong method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnswerSlip {
    /// The right number times ten to this power.
    PowerOfTen(i32),
    /// The right number in the first unit, given in the second.
    Unit(&'static str, &'static str),
    /// The right number rounded to the figures that were written, this many, and that are too few.
    FewerFigures(usize),
    /// As far off as rounding to three figures on the way explains.
    Drift,
    /// The right number of another part, by its index in the problem.
    OtherPart(usize),
}

/// Of an angular velocity, of an angle, of a speed and of a time.
const RATE: Dimension = Dimension([0, 0, -1, 1]);
const ANGLE: Dimension = Dimension([0, 0, 0, 1]);
const SPEED: Dimension = Dimension([0, 1, -1, 0]);
const TIME: Dimension = Dimension([0, 0, 1, 0]);
/// Pairs of units that are taken for one another, and how many of the second make one of the first: three for a rate, two
/// for an angle, one for a speed, one for a time.
const CONFUSED: [(&str, &str, f64); 7] = [
    ("rev/min", "rad/s", 60.0 / std::f64::consts::TAU),
    ("rev/s", "rad/s", 1.0 / std::f64::consts::TAU),
    ("deg/s", "rad/s", 180.0 / std::f64::consts::PI),
    ("deg", "rad", 180.0 / std::f64::consts::PI),
    ("rev", "rad", 1.0 / std::f64::consts::TAU),
    ("km/h", "m/s", 3.6),
    ("min", "s", 1.0 / 60.0),
];
/// Greatest power of ten that is recognised, both ways.
const TENS: i32 = 6;
/// Rounding three figures on the way moves an answer by at most some half a per cent times its condition number.
const DRIFT_PER_COND: f64 = 0.005;
/// The condition number that is taken where it is not known: a sheet does not tell it, for it would go with the answer.
const USUAL_COND: f64 = 3.0;
/// A drift ends at this many half-widths: what is farther off is no rounding.
const DRIFT_ENDS: f64 = 3.0;

/// What rounding on the way adds to that of the last figure: a number computed by a method is at most this much farther from
/// it, as a share.
const ON_THE_WAY: f64 = 0.002;
/// A number of fewer figures is a guess or a datum: it fits a method only if it is exactly what the method gives.
const FIGURES: usize = 3;
/// A number that is what a method gives, to the roundings of doubles.
const EXACT: f64 = 1e-9;
/// Parts of a tolerance that are told apart.
const MILLION: f64 = 1e6;
/// Other methods are counted within so many times the distance at which one fits.
const AROUND: f64 = 10.0;
/// Where other methods lie so densely that one of them fits by chance oftener than this, a fit proves nothing.
const CHANCE: f64 = 0.5;

/// What an answer to one part of one student is compared with.
#[derive(Debug, Clone, Copy)]
struct Comparison {
    key: f64,
    magnitude: bool,
    /// Half-width over key; a wrong value has the relative tolerance of the right one.
    share: f64,
    /// How far off a drift may be.
    reach: f64,
    /// The pairs of [`CONFUSED`] that may apply.
    confused: (u8, u8),
    /// Another part of the problem is of the same dimension.
    alike: bool,
}

/// Fits `value`: within its tolerance, relative as that of the key.
fn fits(x: f64, value: f64, share: f64) -> bool {
    (x - value).abs() <= width(value, share)
}

fn width(value: f64, share: f64) -> f64 {
    (share * value.abs()).max(f64::MIN_POSITIVE)
}

impl Comparison {
    /// Of `parts[part]`; `None` where no number is asked.
    fn of(part: usize, parts: &[KeyEntry]) -> Option<Comparison> {
        let entry = parts.get(part)?;
        let Answer::Number { value: key, half_width, magnitude, .. } = entry.answer else { return None };
        let share = if key == 0.0 { 0.0 } else { half_width / key.abs() };
        let dimension = entry.unit.dimension();
        let confused = match dimension {
            RATE => (0, 3),
            ANGLE => (3, 5),
            SPEED => (5, 6),
            TIME => (6, 7),
            _ => (0, 0),
        };
        let alike = |(i, other): (usize, &KeyEntry)| i != part && other.unit.dimension() == dimension;
        let alike = parts.iter().enumerate().any(alike);
        let reach =
            (DRIFT_PER_COND * entry.cond.unwrap_or(USUAL_COND) * key.abs()).min(DRIFT_ENDS * half_width);
        Some(Comparison { key, magnitude, share, reach, confused, alike })
    }

    /// Of the methods near a number those that it tells: it lies as near as rounding brings it, and the others are not so many
    /// that one of them would lie there by chance.
    fn likely(&self, x: f64, cell: &[u8], wrong: &[WrongValue], near: &[u16]) -> Vec<u16> {
        if near.is_empty() {
            return Vec::new();
        }
        let written = std::str::from_utf8(cell).ok().and_then(figures::written);
        // A whole number of four digits may end in zeros that were computed; one of a single figure is a guess.
        let fine = written.and_then(|Figures { count, number, filled }| match (count, count + filled) {
            (FIGURES.., _) => Some(0.5 / number),
            (2, 4..) => Some(0.5 / (number * power(10.0, filled as f64))),
            _ => None,
        });
        let reach = fine.map_or(EXACT, |half| (half + ON_THE_WAY).min(self.share).max(EXACT));
        let told: Vec<u16> = near
            .iter()
            .copied()
            .filter(|m| wrong.iter().any(|w| w.method == *m && fits(x, w.value, reach)))
            .collect();
        // Methods that come to the same number are one here.
        let mut others: Vec<f64> =
            wrong.iter().map(|w| w.value).filter(|v| fits(x, *v, AROUND * reach)).collect();
        others.retain(|v| !fits(x, *v, reach));
        others.sort_unstable_by(f64::total_cmp);
        others.dedup_by(|a, b| fits(*a, *b, EXACT));
        if others.len() as f64 > CHANCE * AROUND { Vec::new() } else { told }
    }

    /// The number that is compared. The right magnitude with a sign that nobody asked for fits nothing else.
    fn compared(&self, x: f64) -> Option<f64> {
        let signed = self.magnitude && x < 0.0 && fits(-x, self.key, self.share);
        (!signed).then_some(if self.magnitude { x.abs() } else { x })
    }

    /// The wrong methods that a number fits, the nearest first.
    fn methods(&self, x: f64, wrong: &[WrongValue]) -> Vec<u16> {
        // Nearly always none fits, so all are compared first without a branch for each.
        if wrong.iter().fold(false, |any, w| any | fits(x, w.value, self.share)) {
            // In millionths of the tolerance: methods that come to one number by different sums are equally near.
            let miss = |value: f64| (MILLION * (x - value).abs() / width(value, self.share)).round();
            let near = wrong.iter().filter(|w| fits(x, w.value, self.share));
            let mut methods: Vec<(f64, u16)> = near.map(|w| (miss(w.value), w.method)).collect();
            // Of equally near ones the first of the bank.
            methods.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            return methods.iter().map(|(_, method)| *method).collect();
        }
        Vec::new()
    }

    fn slip(&self, x: f64, cell: &[u8], part: usize, parts: &[KeyEntry]) -> Option<AnswerSlip> {
        let Comparison { key, share, .. } = *self;
        // Between these ratios no power of ten fits a tolerance below a half.
        let ratio = x / key;
        let near = share < 0.5 && (ratio <= 0.0 || (0.16..4.9).contains(&ratio));
        if !near {
            for n in (-TENS..=TENS).filter(|n| *n != 0) {
                if fits(x, key * ten_to(n), share) {
                    return Some(AnswerSlip::PowerOfTen(n));
                }
            }
        }
        let (first, end) = self.confused;
        for (from, to, factor) in &CONFUSED[usize::from(first)..usize::from(end)] {
            if fits(x, key * factor, share) {
                return Some(AnswerSlip::Unit(from, to));
            }
        }
        if let Some(figures) = self.rounded_to(x, cell) {
            return Some(AnswerSlip::FewerFigures(figures));
        }
        if (x - key).abs() <= self.reach {
            return Some(AnswerSlip::Drift);
        }
        if !self.alike {
            return None;
        }
        let entry = parts.get(part)?;
        parts
            .iter()
            .enumerate()
            .filter(|(i, other)| *i != part && other.unit.dimension() == entry.unit.dimension())
            .find(|(_, other)| match other.answer {
                Answer::Number { value, half_width, .. } => {
                    (x.abs() - value.abs()).abs() <= half_width.min(1e-2 * value.abs())
                }
                Answer::Word { .. } => false,
            })
            .map(|(i, _)| AnswerSlip::OtherPart(i))
    }

    /// How many figures were written, if they are those of the right number rounded to that many, in the unit of the answer.
    fn rounded_to(&self, x: f64, cell: &[u8]) -> Option<usize> {
        // Rounded to one figure a number changes by half of itself at most.
        let near = (x - self.key).abs() <= 0.5 * x.abs();
        if !near {
            return None;
        }
        let cell = std::str::from_utf8(cell).ok()?;
        let Figures { count, number, .. } = figures::written(cell)?;
        // The unit, the point and the power of ten drop out: both numbers in units of the last figure.
        let right = number * (self.key / x);
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
        if !same(shown::rounded(right, count), number) {
            return None;
        }
        // Of `sqrt(2)` the 2 is no answer.
        let Reading::Number(read) = read(cell, &mut UnitCache::default()) else { return None };
        let scale = read.value.abs() / number;
        same(scale, power(10.0, log10(scale).round())).then_some(count)
    }
}

/// What the number `x`, SI, written as `cell` and judged wrong for `parts[part]`, has in common with what is known of its
/// problem; `wrong` is where wrong methods come to.
pub fn diagnose(x: f64, cell: &[u8], part: usize, parts: &[KeyEntry], wrong: &[WrongValue]) -> Diagnosis {
    let known = Comparison::of(part, parts);
    let Some((known, x)) = known.and_then(|known| Some((known, known.compared(x)?))) else {
        return Diagnosis::default();
    };
    let near = known.methods(x, wrong);
    let methods = known.likely(x, cell, wrong, &near);
    Diagnosis { methods, near, slip: known.slip(x, cell, part, parts) }
}

/// The wrong methods within the tolerance of the number `x`, SI, judged wrong for `parts[part]`.
#[cfg(feature = "program")]
pub fn methods(x: f64, part: usize, parts: &[KeyEntry], wrong: &[WrongValue]) -> Vec<u16> {
    let known = Comparison::of(part, parts);
    let found = known.and_then(|known| Some(known.methods(known.compared(x)?, wrong)));
    found.unwrap_or_default()
}

fn ten_to(n: i32) -> f64 {
    let ten = crate::units::TENS[n.unsigned_abs() as usize];
    if n < 0 { 1.0 / ten } else { ten }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    #[test]
    fn confused_units_are_of_the_dimensions_that_are_asked() {
        for (pairs, dimension) in [
            (&CONFUSED[..3], RATE),
            (&CONFUSED[3..5], ANGLE),
            (&CONFUSED[5..6], SPEED),
            (&CONFUSED[6..], TIME),
        ] {
            for (from, to, factor) in pairs {
                let (from, to) = (Unit::parse(from).unwrap(), Unit::parse(to).unwrap());
                assert_eq!((from.dimension(), to.dimension()), (dimension, dimension));
                assert!((from.to_si(*factor) - to.to_si(1.0)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn no_power_of_ten_is_missed_by_the_quick_look() {
        for share in [0.001, 0.01, 0.1, 0.49] {
            for n in (-TENS..=TENS).filter(|n| *n != 0) {
                for edge in [1.0 - share, 1.0, 1.0 + share] {
                    let ratio = ten_to(n) * edge;
                    assert!(!(0.16..4.9).contains(&ratio), "{n} {edge}");
                }
            }
        }
    }
}
