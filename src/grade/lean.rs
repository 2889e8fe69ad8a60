//! What the quick way needs of a set, close together and column after column: where rows stand in random order, the time goes
//! into waiting for memory.
use crate::grade::choose::Winner;
use crate::grade::table::Hot;
use crate::grade::table::KeyTable;
use crate::grade::table::WORD;

/// Bytes of a name that is kept here; the last byte of its place is its length.
const NAME: usize = 15;

/// The part of a table that most rows need.
#[derive(Debug)]
pub(crate) struct Lean {
    students: usize,
    /// What all students share of a column; `None` where they differ, or where no number is asked.
    columns: Vec<Option<Hot>>,
    /// Value and half-width, column after column.
    bounds: Vec<(f64, f64)>,
    names: Vec<[u8; NAME + 1]>,
}

impl Lean {
    /// Of a table whose points do not change any more.
    pub fn of(table: &KeyTable) -> Lean {
        let (students, width) = (table.students.len(), table.columns.len());
        let cells = |column: usize| table.hot.iter().skip(column).step_by(width.max(1));
        let columns = (0..width).map(|column| {
            let first = *cells(column).next().filter(|hot| hot.unit != WORD)?;
            let bits = |hot: &Hot| [hot.times, hot.over, hot.points].map(f64::to_bits);
            let same = |hot: &Hot| {
                bits(hot) == bits(&first)
                    && (hot.unit, hot.fast, hot.magnitude) == (first.unit, first.fast, first.magnitude)
            };
            cells(column).all(same).then_some(first)
        });
        let columns = columns.collect();
        let bounds = (0..width).flat_map(|column| cells(column).map(|hot| (hot.value, hot.half_width)));
        let name = |field: &[u8]| {
            let mut name = [u8::MAX; NAME + 1];
            if field.len() <= NAME {
                name[..field.len()].copy_from_slice(field);
                name[NAME] = field.len() as u8;
            }
            name
        };
        let names = table.students.iter().map(|s| name(&s.field)).collect();
        Lean { students, columns, bounds: bounds.collect(), names }
    }
    /// Place of a student and a column in what is kept column after column.
    #[inline]
    pub fn at(&self, who: u32, what: u32) -> usize {
        what as usize * self.students + who as usize
    }
    /// What all students share of a column.
    #[inline]
    pub fn column(&self, what: u32) -> Option<&Hot> {
        self.columns.get(what as usize)?.as_ref()
    }
    /// Value and half-width.
    #[inline]
    pub fn bounds(&self, at: usize) -> (f64, f64) {
        self.bounds[at]
    }
    /// Writes the id of a student as a field.
    #[inline]
    pub fn push_name(&self, who: u32, table: &KeyTable, out: &mut Vec<u8>) {
        let name = &self.names[who as usize];
        match name.get(..usize::from(name[NAME])) {
            Some(field) => out.extend_from_slice(field),
            None => out.extend_from_slice(&table.students[who as usize].field),
        }
    }
    /// The places of the attempts that count, column after column; none where more is to be said than that.
    pub fn places(&self, winners: &[Winner]) -> Vec<u64> {
        let width = self.columns.len().max(1);
        let place = |w: &Winner| if w.by_row { u64::MAX } else { w.at };
        let column = |column: usize| winners.iter().skip(column).step_by(width).map(place);
        (0..self.columns.len()).flat_map(column).collect()
    }
}
