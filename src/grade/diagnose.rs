//! What a wrong number has in common with numbers that are known: wrong methods, powers of ten, units, other parts. It says
//! only what the match proves, and never makes a wrong answer right.
use crate::key::Answer;
use crate::key::KeyEntry;
use crate::key::WrongValue;

/// What a wrong answer fits.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagnosis {
    /// Wrong methods, indices into the methods of the problem, the nearest first.
    pub methods: Vec<u16>,
    /// A slip of the pen.
    pub slip: Option<Slip>,
}

/// A slip that is no wrong method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Slip {
    /// The right number times ten to this power.
    PowerOfTen(i32),
    /// The right number in the first unit, given in the second.
    Unit(&'static str, &'static str),
    /// The right number, rounded to this many figures.
    FewerFigures(usize),
    /// As far off as rounding to three figures on the way explains.
    Drift,
    /// The right number of another part, by its index in the problem.
    OtherPart(usize),
}

/// Pairs of units that are taken for one another, and how many of the second make one of the first.
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
/// A drift ends at this many half-widths: what is farther off is no rounding.
const DRIFT_ENDS: f64 = 3.0;

/// What the number `x`, SI, judged wrong for `parts[part]`, has in common with what is known of its problem.
pub fn diagnose(x: f64, part: usize, parts: &[Option<KeyEntry>]) -> Diagnosis {
    let mut found = Diagnosis::default();
    let Some(entry) = parts.get(part).and_then(Option::as_ref) else { return found };
    let Answer::Number { value: key, half_width, magnitude, .. } = entry.answer else { return found };
    let x = if magnitude { x.abs() } else { x };
    let share = if key == 0.0 { 0.0 } else { half_width / key.abs() };
    // A wrong value has the relative tolerance of the right one.
    let miss = |x: f64, value: f64| {
        let width = (share * value.abs()).max(f64::MIN_POSITIVE);
        (x - value).abs() / width
    };
    let fits = |x: f64, value: f64| miss(x, value) <= 1.0;
    let mut methods: Vec<(f64, WrongValue)> =
        entry.wrong.iter().map(|w| (miss(x, w.value), *w)).filter(|(d, _)| *d <= 1.0).collect();
    // Stable: of equally near ones the first of the bank.
    methods.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.methods = methods.iter().map(|(_, w)| w.method).collect();
    found.slip = slip(x, (key, half_width), part, parts, &fits);
    found
}

fn slip(
    x: f64,
    (key, half_width): (f64, f64),
    part: usize,
    parts: &[Option<KeyEntry>],
    fits: &dyn Fn(f64, f64) -> bool,
) -> Option<Slip> {
    let entry = parts.get(part)?.as_ref()?;
    for n in (-TENS..=TENS).filter(|n| *n != 0) {
        if fits(x, key * ten_to(n)) {
            return Some(Slip::PowerOfTen(n));
        }
    }
    for (from, to, factor) in CONFUSED {
        if entry.unit.dimension() == unit_of(to) && fits(x, key * factor) {
            return Some(Slip::Unit(from, to));
        }
    }
    let figures = (1..=2).rev().find(|n| rounded(key, *n).is_some_and(|r| (x - r).abs() <= 1e-9 * r.abs()));
    if let Some(figures) = figures {
        return Some(Slip::FewerFigures(figures));
    }
    let reach = (DRIFT_PER_COND * entry.cond.unwrap_or(0.0) * key.abs()).min(DRIFT_ENDS * half_width);
    if (x - key).abs() <= reach {
        return Some(Slip::Drift);
    }
    parts
        .iter()
        .enumerate()
        .filter_map(|(i, other)| Some((i, other.as_ref()?)))
        .filter(|(i, other)| *i != part && other.unit.dimension() == entry.unit.dimension())
        .find(|(_, other)| match other.answer {
            Answer::Number { value, half_width, .. } => {
                (x.abs() - value.abs()).abs() <= half_width.min(1e-2 * value.abs())
            }
            Answer::Word { .. } => false,
        })
        .map(|(i, _)| Slip::OtherPart(i))
}

fn unit_of(name: &str) -> crate::units::Dimension {
    crate::units::Unit::parse(name)
        .map(|u| u.dimension())
        .unwrap_or_else(|_| crate::units::Unit::one().dimension())
}

fn ten_to(n: i32) -> f64 {
    let mut product = 1.0;
    for _ in 0..n.unsigned_abs() {
        product *= 10.0;
    }
    if n < 0 { 1.0 / product } else { product }
}

/// A number rounded to so many figures.
fn rounded(value: f64, figures: usize) -> Option<f64> {
    format!("{value:.*e}", figures.checked_sub(1)?).parse().ok()
}
