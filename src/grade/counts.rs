//! What the workers count while they write, and its sum.
use crate::grade::run::{Graded, VerdictCounts};
use crate::grade::table::KeyTable;
use crate::grade::verdict::Verdict;

/// What one worker counts.
pub(crate) struct GradedCounts {
    /// Points of the attempts that count, by their index.
    pub points: Vec<(u32, f64)>,
    cells: u64,
    /// See [`Graded::undated`].
    pub undated: u64,
    /// See [`Graded::respelled`].
    pub respelled: u64,
    counts: VerdictCounts,
    by_column: Vec<VerdictCounts>,
}

impl GradedCounts {
    /// Nothing yet.
    pub fn new(table: &KeyTable) -> GradedCounts {
        GradedCounts {
            points: Vec::new(),
            cells: 0,
            undated: 0,
            respelled: 0,
            counts: VerdictCounts::default(),
            by_column: vec![VerdictCounts::default(); table.columns.len()],
        }
    }
    /// Counts a cell, or a record without cells.
    #[inline]
    pub fn verdict(&mut self, verdict: Verdict, column: Option<usize>) {
        self.cells += 1;
        self.counts[verdict as usize] += 1;
        if let Some(column) = column {
            self.by_column[column][verdict as usize] += 1;
        }
    }
    /// Adds what was counted.
    pub fn add_to(self, graded: &mut Graded) {
        graded.cells += self.cells;
        graded.undated += self.undated;
        graded.respelled += self.respelled;
        let add = |to: &mut VerdictCounts, from: &VerdictCounts| {
            to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
        };
        add(&mut graded.counts, &self.counts);
        for (to, from) in graded.by_column.iter_mut().zip(&self.by_column) {
            add(to, from);
        }
        for (index, points) in self.points {
            graded.points[index as usize] = Some(points);
        }
    }
}
