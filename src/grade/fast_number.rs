//! The number of a cell in SI, the quick way: a plain number, alone or before a unit whose spelling was met before where the same
//! unit was asked, and about which nothing is to be said. It reads as [`read`] does, or leaves the cell to it.
use crate::answer::read::{Reading, UnitCache, read};
use crate::grade::id_index::{ShortText, short};
use crate::grade::table::{AskedColumn, KeyTable, WORD};
use crate::units::{TENS, Unit};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// So many spellings are remembered at most.
const MOST: usize = 1024;

/// A spelling where a unit is asked: SI value = number * times / over; `None`: the long way.
type Conversion = Option<(f64, f64)>;

/// Reads numbers of cells, and remembers from row to row how units were spelled.
#[derive(Debug, Default)]
pub(crate) struct SiReader {
    /// What stood behind a number, and the unit that was asked, by its place in [`KeyTable::units`].
    known: FxHashMap<(ShortText, u16), Conversion>,
    /// For the long way.
    pub units: UnitCache,
}

impl SiReader {
    /// The number of a cell in SI, if its verdict depends on nothing else.
    #[inline]
    pub fn si(&mut self, table: &KeyTable, asked: &AskedColumn, answer: &[u8]) -> Option<f64> {
        if asked.cyclic {
            return None;
        }
        let (number, end, raised) = leading_number(answer)?;
        let behind = &answer[end..];
        let (times, over) = match behind.iter().all(u8::is_ascii_whitespace) {
            true if asked.bare => (asked.times, asked.over),
            true => return None,
            false if may_begin(behind, raised) => self.conversion(table, behind, asked.unit)?,
            false => return None,
        };
        let x = number * times / over;
        x.is_finite().then_some(x)
    }

    #[inline]
    fn conversion(&mut self, table: &KeyTable, behind: &[u8], asked: u16) -> Conversion {
        if asked == WORD {
            return None;
        }
        let key = (short(behind)?, asked);
        self.known.get(&key).copied().unwrap_or_else(|| self.learn(table, behind, key))
    }

    #[cold]
    fn learn(&mut self, table: &KeyTable, behind: &[u8], key: (ShortText, u16)) -> Conversion {
        if self.known.len() == MOST {
            return None;
        }
        let asked = table.units.get(usize::from(key.1))?;
        let found = self.spelled(behind).filter(|unit| asked.agrees(unit) && !unit.counts_turns(asked));
        let found = found.map(|unit| unit.times_over());
        self.known.insert(key, found);
        found
    }

    /// The unit behind a number, read the long way behind a one; `None` where the text is no unit alone, or something is to be said of
    /// how it is spelled.
    fn spelled(&mut self, behind: &[u8]) -> Option<Arc<Unit>> {
        let text = std::str::from_utf8(behind).ok()?;
        // A digit, a mark or a sign of another alphabet may go on with the number: only a unit's own letters may not.
        let unit = text.trim_start();
        let letters =
            unit.starts_with(|c: char| c.is_alphabetic() || matches!(c, '°' | 'º' | '%' | '(' | '['));
        if !letters && !unit.starts_with("1/") {
            return None;
        }
        let Reading::Number(number) = read(&format!("1{text}"), &mut self.units) else { return None };
        let plain = !number.is_interpreted() && !number.case_forgiven;
        number.unit.filter(|_| plain && (number.value - 1.0).abs() < f64::MIN_POSITIVE)
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

    /// A table that asks for these units.
    fn table() -> KeyTable {
        let mut table = KeyTable::default();
        table.units =
            ["1", "rad/s", "rpm", "N", "m/s", "1/s", "kg", "deg"].map(|u| Unit::parse(u).unwrap()).to_vec();
        table
    }

    /// Whatever is asked, the quick way gives what the long way gives, or nothing; is it something for any?
    fn agrees(cell: &str, known: &mut SiReader) -> bool {
        let table = table();
        let quickly = |(i, unit): (usize, &Unit)| {
            let ((times, over), index) = (unit.times_over(), u16::try_from(i).unwrap());
            let (points, magnitude, cyclic, bare) = (1.0, false, false, true);
            let asked = AskedColumn { times, over, points, magnitude, cyclic, bare, unit: index };
            let Some(x) = known.si(&table, &asked, cell.as_bytes()) else { return false };
            let Reading::Number(number) = read(cell, &mut UnitCache::default()) else {
                panic!("{cell:?}: the quick way reads {x}, the long way no number")
            };
            let (times, over) = number.unit.as_deref().unwrap_or(unit).times_over();
            assert_eq!((number.value * times / over).to_bits(), x.to_bits(), "{cell:?}");
            assert!(!number.is_interpreted() && !number.case_forgiven, "{cell:?}");
            assert!(number.unit.is_none_or(|own| unit.agrees(&own) && !own.counts_turns(unit)), "{cell:?}");
            true
        };
        table.units.iter().enumerate().map(quickly).fold(false, |any, one| any | one)
    }

    #[test]
    fn common_spellings_take_the_quick_way() {
        let mut known = SiReader::default();
        for cell in
            ["30.3", "-0.05", " 12 ", "30.3 rad/s", "289.4 rpm", "1.2346e+05 mN", "-62.6N", "5 1/s", "2e3 N"]
        {
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
            "7 KN",
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
        let mut known = SiReader::default();
        for i in 0..200 {
            agrees(&format!("1 q{i}"), &mut known);
        }
        assert_eq!(known.known.len(), MOST);
        assert!(agrees("3.5", &mut known) && !agrees("3.5 m/s", &mut known));
    }

    proptest! {
        #[test]
        fn both_ways_agree(cells in prop::collection::vec("[-+]?[0-9 .]{0,6}[0-9][eE×x^+*10-]{0,5}[ NkmradsJpcwup/.,'^2µ°%$1()±√π’．٫٣&;lbft-]{0,8}", 1..30)) {
            let mut known = SiReader::default();
            for cell in cells {
                agrees(&cell, &mut known);
            }
        }

        #[test]
        fn no_cell_panics(cells in prop::collection::vec("\\PC{0,24}", 1..10)) {
            let mut known = SiReader::default();
            for cell in cells {
                agrees(&cell, &mut known);
            }
        }
    }
}
