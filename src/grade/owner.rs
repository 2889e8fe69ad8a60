//! To which student and which column of the key an answer cell belongs.
use crate::grade::cells::AnswerCell;
use crate::grade::table::{KeyTable, joined};

/// To whom and what a cell belongs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Belongs {
    /// The student, if known.
    pub who: Option<u32>,
    /// The column of the table, if known.
    pub what: Option<u32>,
    /// The id differs from that of the roster, as [`crate::answer::roster::folded`] allows.
    pub respelled: bool,
    /// It was given to another variant than the one that counts.
    pub of_another: bool,
}

/// Finds it; rows of one student mostly stand together, so the last one is remembered.
#[derive(Debug, Default)]
pub(crate) struct Finder {
    student: Option<(Vec<u8>, (u32, bool))>,
    key: Vec<u8>,
}

impl Finder {
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
        let who = student.map(|(who, _)| who);
        let is_other = |who: u32, what: u32| table.code(who as usize, what as usize).as_bytes() != cell.code;
        let of_another =
            !cell.code.is_empty() && who.zip(what).is_some_and(|(who, what)| is_other(who, what));
        Belongs { who, what, respelled, of_another }
    }

    /// The number of a student, and whether the spelling of the id had to be forgiven.
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
