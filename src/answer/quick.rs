//! The quick way for most cells: a plain number, alone or before a unit whose spelling was met before. It reads as [`read`]
//! does, or leaves the cell to it.
use crate::answer::read::{Reading, UnitCache, read};
use crate::units::{TENS, Unit};
use std::sync::Arc;

/// Bytes behind a number that are remembered as the spelling of a unit.
const SPELLING: usize = 15;
/// Places for spellings, a power of two, and how many may be taken.
const PLACES: usize = 512;
const MOST: usize = 256;

/// A unit as it was spelled.
#[derive(Debug, Clone)]
pub struct KnownSpelling {
    pub unit: Arc<Unit>,
    /// Upper and lower case were forgiven.
    pub case_forgiven: bool,
}

/// Spellings of units met so far.
#[derive(Debug)]
pub struct Spellings {
    /// Text and its length, and the number of the spelling; `None` where the text is no unit alone.
    places: Vec<(u128, Option<u16>)>,
    taken: usize,
    known: Vec<KnownSpelling>,
    /// For the long way.
    pub units: UnitCache,
}

impl Default for Spellings {
    fn default() -> Self {
        Spellings {
            places: vec![(0, None); PLACES],
            taken: 0,
            known: Vec::new(),
            units: UnitCache::default(),
        }
    }
}

impl Spellings {
    /// A number and the spelling that stands behind it, if it does not stand alone; `None`: to be read the long way.
    #[inline]
    pub fn number(&mut self, cell: &[u8]) -> Option<(f64, Option<u16>)> {
        let (value, end, raised) = leading_number(cell)?;
        let rest = &cell[end..];
        if rest.is_empty() || rest.iter().all(u8::is_ascii_whitespace) {
            return Some((value, None));
        }
        Some((value, Some(self.spelling(rest, raised)?)))
    }

    pub fn unit(&self, spelling: u16) -> Option<&KnownSpelling> {
        self.known.get(usize::from(spelling))
    }

    #[inline]
    fn spelling(&mut self, rest: &[u8], raised: bool) -> Option<u16> {
        if rest.len() > SPELLING || !may_begin(rest, raised) {
            return None;
        }
        let mut key = rest.iter().rev().fold(0u128, |key, b| key << 8 | u128::from(*b));
        key |= (rest.len() as u128) << 120;
        let mixed = ((key >> 64) as u64 ^ key as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut at = (mixed >> 55) as usize;
        while self.places[at].0 != 0 {
            if self.places[at].0 == key {
                return self.places[at].1;
            }
            at = (at + 1) % PLACES;
        }
        if self.taken == MOST {
            return None;
        }
        let found = self.learn(rest);
        self.taken += 1;
        self.places[at] = (key, found);
        found
    }

    /// Reads the text behind a one, the long way.
    fn learn(&mut self, rest: &[u8]) -> Option<u16> {
        let text = std::str::from_utf8(rest).ok()?;
        // A digit, a mark or a sign of another alphabet may go on with the number: only a unit's own letters may not.
        let unit = text.trim_start();
        let letters =
            unit.starts_with(|c: char| c.is_alphabetic() || matches!(c, '°' | 'º' | '%' | '(' | '['));
        if !letters && !unit.starts_with("1/") {
            return None;
        }
        let cell = format!("1{text}");
        let Reading::Number(number) = read(&cell, &mut self.units) else { return None };
        let one = (number.value - 1.0).abs() < f64::MIN_POSITIVE;
        if !one || number.is_interpreted() {
            return None;
        }
        let spelled = KnownSpelling { unit: number.unit?, case_forgiven: number.case_forgiven };
        self.known.push(spelled);
        u16::try_from(self.known.len() - 1).ok()
    }
}

/// May the text behind a number be the spelling of a unit, whatever the number? Not where it may go on with the number:
/// digits in groups, a second point, another power of ten.
#[inline]
fn may_begin(rest: &[u8], raised: bool) -> bool {
    let first = rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(0);
    match rest[first] {
        b'0'..=b'9' => rest.starts_with(b" 1/"),
        b'.' | b',' | b'\'' => false,
        b'e' | b'E' | b'x' | b'X' => !raised,
        b => !raised || b.is_ascii_alphabetic(),
    }
}

/// The number at the start of a cell, the place behind it, and whether it has a power of ten (`e3`).
#[inline]
fn leading_number(cell: &[u8]) -> Option<(f64, usize, bool)> {
    let mut at = 0;
    while cell.get(at).is_some_and(u8::is_ascii_whitespace) {
        at += 1;
    }
    let negative = cell.get(at) == Some(&b'-');
    at += usize::from(negative);
    let (mut mantissa, mut seen) = (0u64, 0usize);
    let mut digits = |at: &mut usize| {
        let from = *at;
        while let Some(digit) = cell.get(*at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            *at += 1;
        }
        seen += *at - from;
        *at - from
    };
    digits(&mut at);
    let mut decimals = 0;
    if cell.get(at) == Some(&b'.') {
        at += 1;
        decimals = digits(&mut at);
        if decimals == 0 {
            return None;
        }
    }
    if seen == 0 || seen > 17 || mantissa >= 1 << 53 {
        return None;
    }
    let mut exponent = 0i64;
    let mut raised = false;
    if let Some(b'e' | b'E') = cell.get(at) {
        let sign = cell.get(at + 1).copied();
        let from = at + 1 + usize::from(matches!(sign, Some(b'+' | b'-')));
        let length = cell[from..].iter().take(4).take_while(|b| b.is_ascii_digit()).count();
        if length == 4 {
            return None;
        }
        if length > 0 {
            exponent = cell[from..from + length].iter().fold(0, |e, b| e * 10 + i64::from(b - b'0'));
            if sign == Some(b'-') {
                exponent = -exponent;
            }
            raised = true;
            at = from + length;
        }
    }
    let tens = exponent - decimals as i64;
    let ten = *TENS.get(usize::try_from(tens.unsigned_abs()).ok()?)?;
    // both exact: one rounding
    let value = if tens < 0 { mantissa as f64 / ten } else { mantissa as f64 * ten };
    Some((if negative { -value } else { value }, at, raised))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The quick way gives what the long way gives, or nothing.
    fn agrees(cell: &str, known: &mut Spellings) -> bool {
        let Some((value, behind)) = known.number(cell.as_bytes()) else { return false };
        let Reading::Number(number) = read(cell, &mut UnitCache::default()) else {
            panic!("{cell:?}: the quick way reads {value}, the long way no number")
        };
        assert_eq!(number.value.to_bits(), value.to_bits(), "{cell:?}");
        assert!(!number.is_interpreted(), "{cell:?}");
        let quick = behind.and_then(|spelling| known.unit(spelling));
        assert_eq!(quick.map(|q| q.unit.as_ref()), number.unit.as_deref(), "{cell:?}");
        assert_eq!(quick.is_some_and(|q| q.case_forgiven), number.case_forgiven, "{cell:?}");
        true
    }

    #[test]
    fn common_spellings_take_the_quick_way() {
        let mut known = Spellings::default();
        for cell in [
            "30.3",
            "-0.05",
            " 12 ",
            "30.3 rad/s",
            "289.4 rpm",
            "1.2346e+05 mN",
            "-62.6N",
            "5 1/s",
            "2e3 N",
            "7 KN",
        ] {
            assert!(agrees(cell, &mut known), "{cell}");
        }
        for cell in [
            "",
            "abc",
            "1,5 N",
            "1.2.0 N",
            "1 000 N",
            "1e5e0 N",
            "1e5x10^0 N",
            "5. N",
            "3 N up",
            "5 cw",
            "12345678901234567890",
        ] {
            assert!(!agrees(cell, &mut known), "{cell}");
        }
        // Spellings that one number would teach wrongly for another.
        for cell in ["1.0 N", "5.2.0 N", "5×10^0 N", "5e2×10^0 N", "5 e0 N", "5 000 N", "5.5 000 N", "5 ' N"]
        {
            agrees(cell, &mut known);
        }
    }

    #[test]
    fn no_more_spellings_than_there_is_room_for() {
        let mut known = Spellings::default();
        for i in 0..2000 {
            known.number(format!("1 q{i}").as_bytes());
        }
        assert_eq!(known.taken, MOST);
        assert!(agrees("3.5", &mut known) && !agrees("3.5 m/s", &mut known));
    }

    proptest! {
        #[test]
        fn both_ways_agree(cells in prop::collection::vec("[-+]?[0-9 .]{0,6}[0-9][eE×x^+*10-]{0,5}[ NkmradsJpcwup/.,'^2µ°%$1()±√π’．٫٣&;lbft-]{0,8}", 1..30)) {
            let mut known = Spellings::default();
            for cell in cells {
                agrees(&cell, &mut known);
            }
        }

        #[test]
        fn no_cell_panics(cells in prop::collection::vec("\\PC{0,24}", 1..10)) {
            let mut known = Spellings::default();
            for cell in cells {
                agrees(&cell, &mut known);
            }
        }
    }
}
