//! Answers as people write them: digits, unit, direction; slips of the pen; and the verdict that the rules of grading give them.
use crate::key::{Answer, KeyEntry};
use crate::num::U;
use crate::num::shown::significant;
use crate::simulate::chance::Chance;
use crate::simulate::habits::UnitHabit;
use crate::units::Unit;

/// An answer before it is written into a cell.
#[derive(Debug, Clone, PartialEq)]
pub enum WrittenCell {
    /// Nothing.
    Blank,
    /// Something that cannot be read.
    Garbage(&'static str),
    /// A word, as keys have it, such as `up`.
    Word(&'static str),
    /// A number.
    Number {
        /// Digits with a point, perhaps a minus, perhaps an exponent.
        digits: String,
        /// The unit that is written.
        unit: Option<Unit>,
        /// The direction is written as a word, such as `down`, and the digits without a sign.
        way: Option<&'static str>,
    },
}

/// What no reader takes for an answer.
pub const GARBAGE: [&str; 6] = ["see attached", "?", "12 bananas", "1.2.3", "sqrt(2gh)", "m/s"];

/// Units that people change to, by the SI unit of their kind.
const OTHERS: &[&str] = &[
    "km/h", "cm/s", "rev/min", "rpm", "deg/s", "kN", "mN", "kJ", "cm", "mm", "ms", "min", "deg", "rev",
    "g cm^2", "kg cm^2", "cm/s^2", "%", "kW",
];

/// Units of another kind, of which one is taken that differs from the asked one in kind.
const STRANGE: [&str; 6] = ["N", "J", "m/s", "m/s^2", "rad/s", "s"];

/// Signs of directions by word.
const WAYS: [(&str, f64); 4] = [("up", 1.0), ("down", -1.0), ("forward", 1.0), ("back", -1.0)];

impl WrittenCell {
    /// A number of this value, SI, in this unit with so many figures.
    pub fn number(si: f64, unit: &Unit, figures: u32) -> Self {
        let digits = significant(unit.from_si(si), usize::try_from(figures).unwrap_or(4));
        // Nobody writes the unit of a pure number.
        let unit = (unit.ascii() != "1").then(|| unit.clone());
        Self::Number { digits, unit, way: None }
    }

    /// The same with other digits, where it is a number.
    pub fn with_digits(mut self, other: impl FnOnce(&str) -> String) -> Self {
        if let Self::Number { digits, .. } = &mut self {
            *digits = other(digits);
        }
        self
    }

    /// The same number with another unit behind it.
    pub fn with_unit(mut self, other: Unit) -> Self {
        if let Self::Number { unit, .. } = &mut self {
            *unit = Some(other);
        }
        self
    }

    /// The number that it says, SI; `asked` is the unit of a number that has none.
    pub fn si(&self, asked: &Unit) -> Option<f64> {
        let Self::Number { digits, unit, way } = self else { return None };
        let sign = way.and_then(|w| WAYS.iter().find(|(name, _)| *name == w)).map_or(1.0, |(_, s)| *s);
        digits.parse::<f64>().ok().map(|x| sign * unit.as_ref().unwrap_or(asked).to_si(x))
    }

    /// The verdict that it gets with a decimal comma where it gets `verdict` with a point: `1,799` may be 1799 as well, and where
    /// that would be right, it cannot be decided.
    pub fn verdict_with_comma(&self, entry: &KeyEntry, verdict: &'static str) -> &'static str {
        let Self::Number { digits, unit, way } = self else { return verdict };
        let grouped = digits.trim_start_matches('-').split_once('.').is_some_and(|(whole, decimals)| {
            let digits = |t: &str, n: usize| t.len() <= n && t.bytes().all(|b| b.is_ascii_digit());
            digits(whole, 3) && decimals.len() == 3 && digits(decimals, 3) && whole != "0"
        });
        if !grouped || verdict != "wrong" {
            return verdict;
        }
        let whole = Self::Number { digits: digits.replace('.', ""), unit: unit.clone(), way: *way };
        if matches!(whole.verdict(entry), "right" | "wrong direction") { "unreadable" } else { verdict }
    }

    /// The verdict that it gets by the rules of grading, in their words.
    pub fn verdict(&self, entry: &KeyEntry) -> &'static str {
        match (self, &entry.answer) {
            (Self::Blank, _) => "blank",
            (Self::Garbage(_), _) => "unreadable",
            (Self::Word(word), Answer::Word { right, .. }) if word == right => "right",
            (Self::Word(_), Answer::Word { .. }) => "wrong",
            (Self::Word(_), _) | (_, Answer::Word { .. }) => "unreadable",
            (Self::Number { unit, .. }, Answer::Number { value, half_width, .. }) => match unit {
                Some(unit) if !entry.unit.agrees(unit) => "wrong dimension",
                None if entry.unit_required && !entry.unit.is_number() => "missing unit",
                _ => {
                    let x = self.si(&entry.unit).unwrap_or(f64::NAN);
                    // Conversions of units in doubles are not held against anybody.
                    let width = half_width + 8.0 * U * (half_width + x.abs());
                    if (x - value).abs() <= width {
                        "right"
                    } else if (-x - value).abs() <= width {
                        "wrong direction"
                    } else {
                        "wrong"
                    }
                }
            },
        }
    }
}

/// Another unit of the same kind as the asked one; `None` if nobody would change it.
pub fn other_unit(asked: &Unit, chance: &mut Chance) -> Option<Unit> {
    let fits = |name: &&&str| **name != asked.ascii();
    let units = OTHERS.iter().filter(fits).filter_map(|name| Unit::parse(name).ok());
    let fitting: Vec<Unit> = units.filter(|u| u.dimension() == asked.dimension()).collect();
    let pick = chance.below(fitting.len());
    fitting.into_iter().nth(pick)
}

/// A unit of another kind than the asked one.
pub fn strange_unit(asked: &Unit, chance: &mut Chance) -> Option<Unit> {
    let units = STRANGE.iter().filter_map(|name| Unit::parse(name).ok());
    let strange: Vec<Unit> = units.filter(|u| !asked.agrees(u)).collect();
    let pick = chance.below(strange.len());
    strange.into_iter().nth(pick)
}

/// The same number, its unit written as the habit is.
pub fn in_habit(
    cell: WrittenCell,
    asked: &Unit,
    written: UnitHabit,
    figures: u32,
    chance: &mut Chance,
) -> WrittenCell {
    let Some(si) = cell.si(asked) else { return cell };
    match (written, cell) {
        (UnitHabit::Without, WrittenCell::Number { digits, way, .. }) => {
            WrittenCell::Number { digits, unit: None, way }
        }
        (UnitHabit::Other, cell) => match other_unit(asked, chance) {
            Some(unit) => WrittenCell::number(si, &unit, figures),
            None => cell,
        },
        (_, cell) => cell,
    }
}

/// The same number with its sign as a word: `up` and `down`, on a level `forward` and `back`.
pub fn by_word(cell: WrittenCell, level: bool) -> WrittenCell {
    match cell {
        WrittenCell::Number { digits, unit, way: None } => {
            let (size, back) = match digits.strip_prefix('-') {
                Some(size) => (size.to_owned(), true),
                None => (digits, false),
            };
            let way = match (level, back) {
                (false, false) => "up",
                (false, true) => "down",
                (true, false) => "forward",
                (true, true) => "back",
            };
            WrittenCell::Number { digits: size, unit, way: Some(way) }
        }
        other => other,
    }
}

/// A slip of the finger in digits: two neighbours swapped, one left out, one typed twice, or a neighbour on the keyboard. The
/// number changes. The digits come back as they are where no such slip is possible.
pub fn mistyped(digits: &str, chance: &mut Chance) -> String {
    let (mantissa, exponent) = digits.split_once('e').map_or((digits, None), |(m, e)| (m, Some(e)));
    let chars: Vec<char> = mantissa.chars().collect();
    let places: Vec<usize> = (0..chars.len()).filter(|i| chars[*i].is_ascii_digit()).collect();
    let value = |t: &str| t.parse::<f64>().unwrap_or(f64::NAN);
    for _ in 0..20 {
        let Some(place) = places.get(chance.below(places.len())).copied() else { break };
        let mut slipped = chars.clone();
        match chance.below(4) {
            0 => match places.iter().copied().find(|p| *p > place) {
                Some(next) => slipped.swap(place, next),
                None => continue,
            },
            1 => {
                slipped.remove(place);
            }
            2 => slipped.insert(place, chars[place]),
            _ => {
                let digit = chars[place].to_digit(10).unwrap_or(0);
                let up = digit == 0 || (digit < 9 && chance.meets(0.5));
                let near = if up { digit + 1 } else { digit - 1 };
                slipped[place] = char::from_digit(near, 10).unwrap_or('0');
            }
        }
        let text: String = slipped.into_iter().collect();
        let bare = text.trim_start_matches('-');
        // Nobody types 01.2 or 5. or .5 there.
        let odd = bare.is_empty() || bare.starts_with('.') || bare.ends_with('.');
        let zeros = bare.starts_with('0') && !bare.starts_with("0.");
        let (old, new) = (value(mantissa), value(&text));
        #[expect(clippy::float_cmp, reason = "another number than before, by however little")]
        if !odd && !zeros && new.is_finite() && new != old {
            return match exponent {
                Some(e) => format!("{text}e{e}"),
                None => text,
            };
        }
    }
    digits.to_owned()
}

/// The last digit changed by one.
pub fn disguised(digits: &str) -> String {
    let end = digits.find('e').unwrap_or(digits.len());
    let mut chars: Vec<char> = digits.chars().collect();
    if let Some(last) = (0..end.min(chars.len())).rev().find(|i| chars[*i].is_ascii_digit()) {
        let digit = chars[last].to_digit(10).unwrap_or(0);
        chars[last] = char::from_digit(if digit == 9 { 8 } else { digit + 1 }, 10).unwrap_or('0');
    }
    chars.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_of_the_finger_change_the_number_and_stay_one() {
        let mut chance = Chance::new(1, 7);
        for digits in ["30.26", "-62.60", "0.0512", "1230", "1.230e6", "7", "11", "0"] {
            for _ in 0..200 {
                let slipped = mistyped(digits, &mut chance);
                assert!(slipped.parse::<f64>().is_ok_and(f64::is_finite), "{digits} {slipped}");
                // Of a single digit there is not always another.
                assert!(slipped != digits || digits.len() == 1, "{digits}");
            }
        }
        assert_eq!((disguised("30.26").as_str(), disguised("1.29e6").as_str()), ("30.27", "1.28e6"));
    }

    #[test]
    fn a_number_keeps_its_value_in_another_unit_and_by_word() {
        let mut chance = Chance::new(1, 8);
        let asked = Unit::parse("rad/s").unwrap();
        let cell = WrittenCell::number(-30.0, &asked, 6);
        assert_eq!(cell.si(&asked), Some(-30.0));
        let other = in_habit(cell.clone(), &asked, UnitHabit::Other, 6, &mut chance);
        assert!((other.si(&asked).unwrap() + 30.0).abs() < 1e-3, "{other:?}");
        assert_eq!(by_word(cell.clone(), false).si(&asked), Some(-30.0));
        assert_eq!(by_word(cell, true).si(&asked), Some(-30.0));
    }
}
