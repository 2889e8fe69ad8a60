//! The number of a cell in SI, the quick way: a plain number, or one with a unit whose spelling was met before
//! and about which nothing is to be said. Everything else is left to the long way.
use crate::answer::quick::Spellings;
use crate::answer::read::UnitCache;
use crate::grade::table::{AskedColumn, KeyTable, WORD};

/// A spelling where a unit is asked: SI value = number * times / over; `None`: the long way.
type Conversion = Option<(f64, f64)>;

/// Reads numbers of cells, and remembers from row to row how units were spelled.
#[derive(Debug, Default)]
pub(crate) struct SiReader {
    spellings: Spellings,
    /// For each spelling and asked unit, where it is known.
    pairs: Vec<Option<Conversion>>,
}

impl SiReader {
    /// The number of a cell in SI, if its verdict depends on nothing else.
    #[inline]
    pub fn si(&mut self, table: &KeyTable, asked: &AskedColumn, answer: &[u8]) -> Option<f64> {
        if asked.cyclic {
            return None;
        }
        let (number, behind) = self.spellings.number(answer)?;
        let (times, over) = match behind {
            None if asked.bare => (asked.times, asked.over),
            None => return None,
            Some(spelling) => self.pair(table, spelling, asked.unit)?,
        };
        let x = number * times / over;
        x.is_finite().then_some(x)
    }

    /// For the long way.
    pub fn units(&mut self) -> &mut UnitCache {
        &mut self.spellings.units
    }

    #[inline]
    fn pair(&mut self, table: &KeyTable, spelling: u16, asked: u16) -> Conversion {
        if asked == WORD {
            return None;
        }
        let at = usize::from(spelling) * table.units.len() + usize::from(asked);
        match self.pairs.get(at) {
            Some(Some(pair)) => *pair,
            _ => self.new_pair(table, at, spelling, asked),
        }
    }

    #[cold]
    fn new_pair(&mut self, table: &KeyTable, at: usize, spelling: u16, asked: u16) -> Conversion {
        let spelled = self.spellings.unit(spelling)?;
        let asked = table.units.get(usize::from(asked))?;
        let silent =
            asked.agrees(&spelled.unit) && !spelled.unit.counts_turns(asked) && !spelled.case_forgiven;
        let pair = silent.then(|| spelled.unit.times_over());
        if self.pairs.len() <= at {
            self.pairs.resize(at + 1, None);
        }
        self.pairs[at] = Some(pair);
        pair
    }
}
