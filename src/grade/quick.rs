//! The SI number of a cell and its column, the quick way: a plain number, or one with a unit whose spelling was met before
//! and about which nothing is to be said. Everything else is left to the long way.
use crate::answer::quick::{Behind, Spellings};
use crate::answer::read::UnitCache;
use crate::grade::cells::AnswerCell;
use crate::grade::table::{Asked, KeyTable, WORD, joined};

/// A spelling where a unit is asked: SI value = number * times / over; `None`: the long way.
type Conversion = Option<(f64, f64)>;

/// To whom and what a cell belongs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Belongs {
    /// The student, if known.
    pub who: Option<u32>,
    /// The column of the table, if known.
    pub what: Option<u32>,
    /// The id differs in upper and lower case from that of the roster.
    pub respelled: bool,
}

/// What is remembered from row to row.
#[derive(Debug, Default)]
pub(crate) struct Quick {
    spellings: Spellings,
    /// For each spelling and asked unit, where it is known.
    pairs: Vec<Option<Conversion>>,
    student: Option<(Vec<u8>, (u32, bool))>,
    key: Vec<u8>,
}

impl Quick {
    /// The number of a cell in SI, if its verdict depends on nothing else.
    #[inline]
    pub fn si(&mut self, table: &KeyTable, asked: &Asked, answer: &[u8]) -> Option<f64> {
        let (number, behind) = self.spellings.number(answer)?;
        let (times, over) = match behind {
            Behind::Nothing if asked.bare => (asked.times, asked.over),
            Behind::Nothing => return None,
            Behind::Unit(spelling) => self.pair(table, spelling, asked.unit)?,
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

    /// Whose cell it is, and of which column.
    #[inline]
    pub fn find(&mut self, table: &KeyTable, cell: &AnswerCell) -> Belongs {
        let student = self.student(table, cell.student);
        let what = match cell.wide {
            Some((_, column)) => column.column,
            None => {
                joined(cell.problem, cell.part, &mut self.key);
                table.column(&self.key)
            }
        };
        let respelled = student.is_some_and(|(_, respelled)| respelled);
        Belongs { who: student.map(|(who, _)| who), what, respelled }
    }

    /// The number of a student, and whether upper and lower case had to be forgiven.
    #[inline]
    fn student(&mut self, table: &KeyTable, id: &[u8]) -> Option<(u32, bool)> {
        if let Some((last, number)) = &self.student
            && last == id
        {
            return Some(*number);
        }
        let number = table.student(id).map(|n| (n, false)).or_else(|| table.student_by_case(id))?;
        let last = self.student.get_or_insert_default();
        last.0.clear();
        last.0.extend_from_slice(id);
        last.1 = number;
        Some(number)
    }
}
