//! Gauss-Jordan elimination on a few equations, any shape, in any number type.
use crate::num::{Real, ball};
use smallvec::{SmallVec, smallvec};

/// Equations `a x = b` as they are collected: rows of coefficients with their right-hand sides at the end, mostly one.
#[derive(Debug, Clone)]
pub struct Equations<T: Real> {
    cols: usize,
    rights: usize,
    cells: SmallVec<[T; 32]>,
    /// Are the coefficients made of few printed decimals? See [`Equations::of_decimals`].
    decimal: bool,
    /// For each row: sum of the magnitudes of the terms of its right-hand side, where it was told.
    sizes: SmallVec<[Option<f64>; 8]>,
    /// Pairs of rows that have the same coefficients in these columns. See [`Equations::alike`].
    alike: Vec<(usize, usize, [usize; 4])>,
}

/// Equations in reduced form.
#[derive(Debug, Clone)]
pub struct Reduced<T: Real> {
    equations: Equations<T>,
    /// Row in which each unknown is the pivot.
    pivot: SmallVec<[Option<usize>; 8]>,
    /// The right-hand sides that are spoken of.
    which: usize,
}

impl<T: Real> Equations<T> {
    /// No equations yet in `cols` unknowns.
    pub fn new(cols: usize) -> Self {
        Self::with_rights(cols, 1)
    }
    /// The same with so many right-hand sides.
    pub fn with_rights(cols: usize, rights: usize) -> Self {
        Self {
            cols,
            rights,
            decimal: false,
            cells: SmallVec::new(),
            sizes: SmallVec::new(),
            alike: Vec::new(),
        }
    }
    /// The same of coefficients that are made of few printed decimals, such as radii: a difference of two of their products is
    /// exactly 0, or far above the rounding of their doubles. Within that it is taken as the 0 that it is, in enclosures too.
    pub fn of_decimals(cols: usize) -> Self {
        Self { decimal: true, ..Self::new(cols) }
    }
    /// Adds an equation `0 = 0` and gives its numbers to be filled.
    pub fn row(&mut self) -> &mut [T] {
        let start = self.cells.len();
        self.sizes.push(None);
        self.cells.resize(start + self.cols + self.rights, T::zero());
        &mut self.cells[start..]
    }

    /// The numbers of an equation that was added before, to be filled.
    pub fn right_of(&mut self, row: usize) -> &mut [T] {
        let width = self.cols + self.rights;
        &mut self.cells[row * width..(row + 1) * width]
    }

    /// Tells that two rows have the very same numbers in these columns, such as the normal of two parallel guides: their difference has
    /// exactly 0 there, which enclosures of the numbers cannot tell.
    pub fn alike(&mut self, row: usize, other: usize, columns: [usize; 4]) {
        self.alike.push((row, other, columns));
    }

    /// Tells the sum of the magnitudes of the terms that made the right-hand side of the last row. Of two equations for one
    /// unknown the one is then taken whose terms leave it the smaller error: a small difference of large terms waits.
    pub fn sized(&mut self, size: f64) {
        if let Some(last) = self.sizes.last_mut() {
            *last = Some(size);
        }
    }

    /// Reduces the equations. The unknowns in `free` become pivots only if nothing else is left, the last of them first.
    pub fn reduce(mut self, free: &[usize]) -> Reduced<T> {
        let (cols, width) = (self.cols, self.cols + self.rights);
        let rows = self.cells.len() / width;
        let mut pivot: SmallVec<[Option<usize>; 8]> = smallvec![None; cols];
        let mut used: SmallVec<[bool; 8]> = smallvec![false; rows];
        let mut base: SmallVec<[T; 9]> = SmallVec::new();
        if T::ENCLOSES {
            for (row, other, columns) in &self.alike {
                for k in 0..width {
                    let less = self.cells[row * width + k];
                    let cell = &mut self.cells[other * width + k];
                    *cell = if columns.contains(&k) { T::zero() } else { *cell - less };
                }
            }
        }
        // What an enclosure leaves open is reckoned with: it decides nothing, save as the last pivot that is left.
        let nothing = |v: T| if T::ENCLOSES { v.is_nothing() } else { v.is_zero() };
        let sure = |v: &T| !T::ENCLOSES || v.radius() < v.size();
        for allowed in (0..=free.len()).rev() {
            let kept = &free[..allowed];
            loop {
                // The pivot that is largest within its own row loses least; of rows with sizes, that of least error. Of equal
                // ones the shortest row: what holds one unknown fast does so before its value is mixed with others.
                let mut best: Option<(usize, usize, f64, usize)> = None;
                for i in (0..rows).filter(|i| !used[*i]) {
                    let row = &self.cells[i * width..i * width + cols];
                    let size = row.iter().fold(0.0, |s: f64, v| s.max(v.size()));
                    let mut lead: Option<(usize, f64, f64)> = None;
                    let mut length = 0;
                    for (j, v) in row.iter().enumerate() {
                        if pivot[j].is_some() || nothing(*v) {
                            continue;
                        }
                        length += 1;
                        if kept.contains(&j) {
                            continue;
                        }
                        let own = if sure(v) { v.size() } else { 0.0 };
                        if lead.is_none_or(|(_, s, _)| own / size > s) {
                            lead = Some((j, own / size, own));
                        }
                    }
                    if let Some((j, share, coefficient)) = lead {
                        let score = self.sizes[i].map_or(share, |error| coefficient / error);
                        if best.is_none_or(|(_, _, s, l)| score > s || score >= s && length < l) {
                            best = Some((i, j, score, length));
                        }
                    }
                }
                let Some((i, j, ..)) = best else { break };
                used[i] = true;
                let row = &mut self.cells[i * width..(i + 1) * width];
                let lead = row[j];
                // Whether what is left of a row says anything may be open: that is a doubt.
                if T::ENCLOSES && lead.is_zero() {
                    continue;
                }
                pivot[j] = Some(i);
                row[j] = T::of(1.0);
                for (k, v) in row.iter_mut().enumerate() {
                    if k != j && !nothing(*v) {
                        *v = *v / lead;
                    }
                }
                base.clear();
                base.extend_from_slice(row);
                let error = self.sizes[i].map(|s| s / lead.size());
                self.sizes[i] = error;
                for (k, row) in self.cells.chunks_exact_mut(width).enumerate() {
                    let f = row[j];
                    if k == i || nothing(f) {
                        continue;
                    }
                    row[j] = T::zero();
                    if let (Some(own), Some(error)) = (self.sizes[k], error) {
                        self.sizes[k] = Some(own + f.size() * error);
                    }
                    for (k, (v, b)) in row.iter_mut().zip(&base).enumerate() {
                        if k == j || nothing(*b) {
                            continue;
                        }
                        *v = if self.decimal && k < cols {
                            ball::unwatched(|| v.apart(f * *b))
                        } else {
                            // An equation that says again what others say leaves nothing but rounding.
                            v.balance(-(f * *b))
                        };
                    }
                }
            }
        }
        Reduced { equations: self, pivot, which: 0 }
    }
}

impl<T: Real> Reduced<T> {
    fn cell(&self, row: usize, col: usize) -> T {
        self.equations.cells[row * (self.equations.cols + self.equations.rights) + col]
    }
    /// The same equations with this one of the right-hand sides, the first of which is 0.
    pub fn with_right(&mut self, which: usize) -> &Self {
        self.which = which;
        self
    }
    /// The unknowns that the equations leave open.
    pub fn open(&self) -> SmallVec<[usize; 4]> {
        (0..self.pivot.len()).filter(|j| self.pivot[*j].is_none()).collect()
    }
    /// Unknown `j` in the solution with all right-hand sides zero, open unknown `which` equal to 1 and the other open ones 0.
    pub fn in_mode(&self, which: usize, j: usize) -> T {
        match self.pivot[j] {
            Some(row) => -self.cell(row, which),
            None if j == which => T::of(1.0),
            None => T::zero(),
        }
    }
    /// Unknown `j`, if it has only one value in all solutions for the right-hand sides.
    pub fn value(&self, j: usize) -> Option<T> {
        let row = self.pivot[j]?;
        let alone = self.open().into_iter().all(|open| self.cell(row, open).is_zero());
        alone.then(|| self.right(row))
    }
    /// Unknown `j` in the solution in which the open unknowns are 0.
    pub fn at_zero(&self, j: usize) -> T {
        self.pivot[j].map_or_else(T::zero, |row| self.right(row))
    }
    /// Right-hand side of a row, nothing where it is nothing beside the terms that made it.
    fn right(&self, row: usize) -> T {
        let value = self.cell(row, self.equations.cols + self.which);
        self.equations.sizes[row].map_or(value, |size| value.cleared(size))
    }
    /// How many equations say something of their own.
    pub fn rank(&self) -> usize {
        self.pivot.iter().flatten().count()
    }
    /// Do the equations that say nothing of their own say what the others say?
    pub fn repeats(&self) -> bool {
        (0..self.equations.sizes.len()).all(|i| self.pivot.contains(&Some(i)) || self.right(i).is_zero())
    }
    /// What the right-hand side of the last equation is more than the others say, where it says nothing of its own.
    pub fn lacks(&self) -> T {
        self.right(self.equations.sizes.len() - 1)
    }
    /// The solution for the right-hand sides, if no unknown is open.
    pub fn solution(&self) -> Option<SmallVec<[T; 4]>> {
        self.pivot.iter().map(|p| p.map(|row| self.right(row))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Dd;

    #[test]
    fn a_chain_of_ratios() {
        // v = 2 w, w = 3 z: the mode with z = 1 is (6, 3, 1).
        let d = Dd::new;
        let mut e = Equations::new(3);
        e.row().copy_from_slice(&[d(1.0), d(-2.0), d(0.0), d(0.0)]);
        e.row().copy_from_slice(&[d(0.0), d(1.0), d(-3.0), d(0.0)]);
        let r = e.reduce(&[2]);
        assert_eq!(r.open().as_slice(), [2]);
        assert_eq!([0, 1, 2].map(|j| r.in_mode(2, j)), [d(6.0), d(3.0), d(1.0)]);
        assert!(r.solution().is_none());
    }
    /// Two equations that say the same left rounding, which was taken for a third of its own.
    #[test]
    fn what_is_said_twice_leaves_open_only_what_it_leaves_open() {
        let d = |x: f64| Dd::new(x) / Dd::new(3.0);
        let mut e = Equations::new(3);
        e.row().copy_from_slice(&[d(1.0), d(1.0), d(0.0), d(5.0)]);
        e.row().copy_from_slice(&[d(0.7), d(0.7), d(0.0), d(5.0) * Dd::new(0.7)]);
        e.row().copy_from_slice(&[d(0.0), d(0.0), d(2.0), d(8.0)]);
        let r = e.reduce(&[]);
        assert_eq!((r.rank(), r.repeats()), (2, true));
        assert_eq!([r.value(0), r.value(1)], [None, None]);
        assert!((r.value(2).unwrap() - Dd::new(4.0)).hi.abs() < 1e-30);
    }
    #[test]
    fn two_equations_in_two_unknowns() {
        // x + y = 5, x - y = 1.
        let d = Dd::new;
        let mut e = Equations::new(2);
        e.row().copy_from_slice(&[d(1.0), d(1.0), d(5.0)]);
        e.row().copy_from_slice(&[d(1.0), d(-1.0), d(1.0)]);
        assert_eq!(e.reduce(&[]).solution().unwrap().as_slice(), [d(3.0), d(2.0)]);
    }
}
