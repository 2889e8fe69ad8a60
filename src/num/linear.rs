//! A small linear system by Gaussian elimination in the number type of the solvers.
//!
//! Rows may differ by any power of ten: the pivot is what is largest within its own row. Unknowns may differ too: where the
//! residuals of a first solution are above rounding, its own sizes scale the columns, and the pivots are chosen anew, so that an
//! acceleration that is 1e-30 of the others keeps all its digits. Our own, and the same for doubles and 32 digits: a library's LU
//! is of doubles, and would need refining with residuals in 32 digits and scaling on top.
use crate::num::Real;
use crate::num::eliminate::Equations;
use smallvec::{SmallVec, smallvec};
use std::ops::Range;

/// Times that the columns may be scaled anew.
const SCALINGS: usize = 6;
/// Residuals of a good elimination are below this many times the rounding of one operation.
const OPERATIONS: f64 = 8.0;

/// Equations in the making: a row of coefficients and right-hand sides for each.
#[derive(Debug, Clone)]
pub struct Linear<T> {
    unknowns: usize,
    columns: usize,
    cells: SmallVec<[T; 30]>,
    /// For each row and right-hand side: sum of the magnitudes of its terms.
    given: SmallVec<[f64; 8]>,
}

/// The solution: one value for each unknown and right-hand side.
#[derive(Debug, Clone)]
pub struct Solution<T> {
    unknowns: usize,
    x: SmallVec<[T; 8]>,
    /// The unknowns that the equations leave open; empty where all are determined.
    open: SmallVec<[bool; 8]>,
}

impl<T: Real> Solution<T> {
    /// Do the equations leave unknown `i` open? Its value is then NaN.
    pub fn is_open(&self, i: usize) -> bool {
        self.open.get(i).copied().unwrap_or(false)
    }
    /// Unknown `i` for right-hand side `k`.
    pub fn get(&self, i: usize, k: usize) -> T {
        self.x[k * self.unknowns + i]
    }
}

/// The equations do not determine the unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Singular {
    /// How many unknowns.
    pub unknowns: usize,
    /// How many of them are determined.
    pub rank: usize,
}

/// Why elimination does not do.
enum Hard<T> {
    /// A row is a repetition of others.
    Repeats,
    /// Residuals of this solution are above rounding.
    Residual(SmallVec<[T; 8]>),
}

/// The largest of sizes; 0 of none, and NaN is none.
#[inline]
fn most(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.fold(0.0, |most, size| if size > most { size } else { most })
}

fn add<T: Real>(cell: &mut T, v: T) {
    *cell = if cell.is_nothing() { v } else { *cell + v };
}

impl<T: Real> Linear<T> {
    /// No equations yet, in `unknowns` unknowns with `columns` right-hand sides.
    pub fn new(unknowns: usize, columns: usize) -> Self {
        let cells = smallvec![T::zero(); unknowns * (unknowns + columns)];
        Self { unknowns, columns, cells, given: smallvec![0.0; unknowns * columns] }
    }
    /// Adds `value * x[col]` to the left of a row.
    pub fn term(&mut self, row: usize, col: usize, value: T) {
        add(&mut self.cells[row * (self.unknowns + self.columns) + col], value);
    }
    /// Adds `value` to right-hand side `column` of a row.
    pub fn right(&mut self, row: usize, column: usize, value: T) {
        add(&mut self.cells[row * (self.unknowns + self.columns) + self.unknowns + column], value);
        self.given[row * self.columns + column] += value.size();
    }
    /// Each row: its coefficients, right-hand side `k` and the size of that.
    fn rows(&self, k: usize) -> impl Iterator<Item = (&[T], T, f64)> {
        let given = self.given.chunks_exact(self.columns).map(move |sizes| sizes[k]);
        let rows = self.cells.chunks_exact(self.unknowns + self.columns);
        rows.zip(given).map(move |(row, given)| (&row[..self.unknowns], row[self.unknowns + k], given))
    }

    /// Solves for all right-hand sides. Where equations repeat each other, the unknowns that have only one value all the same.
    pub fn solve(&self) -> Result<Solution<T>, Singular> {
        let n = self.unknowns;
        let whole = |x| Solution { unknowns: n, x, open: SmallVec::new() };
        let same: SmallVec<[f64; 8]> = smallvec![1.0; n];
        if let Ok(x) = self.eliminated(0..self.columns, &same) {
            return Ok(whole(x));
        }
        let mut all = SmallVec::with_capacity(n * self.columns);
        for k in 0..self.columns {
            let mut scales = same.clone();
            let mut found = None;
            for _ in 0..SCALINGS {
                match self.eliminated(k..k + 1, &scales) {
                    Ok(x) => {
                        found = Some(x);
                        break;
                    }
                    Err(Hard::Residual(x)) => {
                        for (scale, x) in scales.iter_mut().zip(&x).filter(|(_, x)| !x.is_zero()) {
                            *scale = x.size();
                        }
                    }
                    Err(Hard::Repeats) => break,
                }
            }
            match found {
                Some(x) => all.extend(x),
                None => return self.partly(),
            }
        }
        Ok(whole(all))
    }

    /// The unknowns that have only one value although equations repeat each other. Errors: they contradict each other.
    fn partly(&self) -> Result<Solution<T>, Singular> {
        let n = self.unknowns;
        let mut x = SmallVec::with_capacity(n * self.columns);
        let mut open: SmallVec<[bool; 8]> = smallvec![false; n];
        for k in 0..self.columns {
            let mut equations = Equations::new(n);
            for (coefficients, right, size) in self.rows(k) {
                let row: &mut [T] = equations.row();
                row[..n].copy_from_slice(coefficients);
                row[n] = right.cleared(size);
                equations.sized(size);
            }
            let reduced = equations.reduce(&[]);
            if !reduced.repeats() {
                return Err(Singular { unknowns: n, rank: reduced.rank() });
            }
            for (i, open) in open.iter_mut().enumerate() {
                let value = reduced.value(i);
                *open |= value.is_none();
                x.push(value.unwrap_or_else(|| T::of(f64::NAN)));
            }
        }
        Ok(Solution { unknowns: n, x, open })
    }

    /// Gaussian elimination with scaled partial pivoting, unknown `i` being about `scales[i]` in size. Nothing is allocated up to
    /// 5 unknowns and one right-hand side.
    fn eliminated(&self, wanted: Range<usize>, scales: &[f64]) -> Result<SmallVec<[T; 8]>, Hard<T>> {
        let (n, width) = (self.unknowns, self.unknowns + self.columns);
        let mut cells: SmallVec<[T; 30]> = SmallVec::from(&self.cells[..]);
        // As slices: a small vector asks at each access where it lies.
        let cells = &mut cells[..];
        // Where each row begins, and its largest number: first the rows that are used, then the others.
        let mut rows: SmallVec<[(usize, f64); 6]> = smallvec![(0, 0.0); n];
        let rows = &mut rows[..];
        for (place, row) in rows.iter_mut().enumerate() {
            let numbers = cells[place * width..][..n].iter().zip(scales);
            *row = (place * width, most(numbers.map(|(cell, scale)| cell.size() * scale)));
        }
        for col in 0..n {
            let mut best: Option<(usize, f64)> = None;
            for (place, (start, largest)) in rows.iter().enumerate().skip(col) {
                let share = cells[start + col].size() * scales[col] / largest;
                if !cells[start + col].is_nothing() && best.is_none_or(|(_, s)| share > s) {
                    best = Some((place, share));
                }
            }
            rows.swap(col, best.ok_or(Hard::Repeats)?.0);
            let (pivot, rest) = (rows[col].0, &rows[col + 1..]);
            for (start, _) in rest {
                if cells[start + col].is_nothing() {
                    continue;
                }
                let factor = cells[start + col] / cells[pivot + col];
                for c in col + 1..width {
                    let (cell, above) = (cells[start + c], cells[pivot + c]);
                    if !above.is_nothing() {
                        let less = factor * above;
                        // A coefficient that is only rounding is no pivot.
                        cells[start + c] = if c < n { cell.balance(-less) } else { cell - less };
                    }
                }
            }
        }
        let mut out: SmallVec<[T; 8]> = smallvec![T::zero(); n * wanted.len()];
        let mut settled = true;
        for (k, x) in wanted.zip(out.chunks_exact_mut(n.max(1))) {
            for (col, (start, _)) in rows.iter().enumerate().rev() {
                let row = &cells[*start..][..width];
                let mut sum = row[n + k];
                for (cell, x) in row[col + 1..n].iter().zip(&x[col + 1..]) {
                    if !cell.is_nothing() && !x.is_nothing() {
                        sum = sum.balance(-(*cell * *x));
                    }
                }
                x[col] = if sum.is_nothing() { sum } else { sum / row[col] };
            }
            if self.far_apart(k, x) {
                self.vanish(k, x);
            }
            settled &= self.settled(k, x);
        }
        if settled { Ok(out) } else { Err(Hard::Residual(out)) }
    }

    /// Are the unknowns and the right-hand sides of very different sizes?
    fn far_apart(&self, k: usize, x: &[T]) -> bool {
        let given = self.given.iter().skip(k).step_by(self.columns).copied();
        let largest = f64::max(most(x.iter().map(|v| v.size())), most(given));
        x.iter().any(|v| v.size() > 0.0 && v.size() < APART * largest)
    }

    /// Sets to 0 all unknowns together that no equation would miss: beside the other terms of each of its equations such an
    /// unknown is rounding, or all other terms of the equation are such unknowns too.
    fn vanish(&self, k: usize, x: &mut [T]) {
        let mut noise: SmallVec<[bool; 12]> = x.iter().map(|v| !v.is_zero()).collect();
        loop {
            let before = noise.clone();
            for (row, _, given) in self.rows(k) {
                let terms = || row.iter().zip(&*x).map(|(v, x)| *v * *x).zip(&before);
                let others = terms().filter(|(_, noise)| !**noise).fold(given, |sum, (v, _)| sum + v.size());
                if others > 0.0 {
                    for (noise, (term, _)) in noise.iter_mut().zip(terms()) {
                        *noise &= term.negligible(others);
                    }
                }
            }
            if noise == before {
                break;
            }
        }
        for (v, _) in x.iter_mut().zip(&noise).filter(|(_, noise)| **noise) {
            *v = T::zero();
        }
    }

    /// Does each row hold for these unknowns, up to the rounding of its terms?
    fn settled(&self, k: usize, x: &[T]) -> bool {
        self.rows(k).all(|(row, right, given)| {
            let terms = row.iter().zip(x).filter(|(v, _)| !v.is_nothing()).map(|(v, x)| *v * *x);
            let (residual, size) = terms.fold((right, given), |(sum, size), t| (sum - t, size + t.size()));
            residual.within(OPERATIONS * T::SETTLED * size)
        })
    }
}

/// Share of the largest number below which an unknown may be the rounding of it, 2^-24: units differ, so most are not.
const APART: f64 = 1.0 / (1u64 << 24) as f64;

/// A pivot below this share of its row, 2^-20, would cost more than a few digits.
const POOR: f64 = 1.0 / (1u64 << 20) as f64;

/// A matrix in triangular factors, for many right-hand sides. It is made again and again in the same place. Most of its cells are 0.
#[derive(Debug, Clone, Default)]
pub struct Factors<T> {
    size: usize,
    /// The factors row by row, with the inverse of each pivot in its place.
    cells: Vec<T>,
    /// For each row a bit for each column that may be other than 0.
    filled: Vec<u64>,
    /// The rows in the order of their pivots.
    order: Vec<usize>,
}

/// The places of the bits that are set, from the lowest.
#[inline]
fn places(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (place < 64).then_some(place)
    })
}

impl<T: Real> Factors<T> {
    /// No matrix yet.
    pub const fn none() -> Self {
        Self { size: 0, cells: Vec::new(), filled: Vec::new(), order: Vec::new() }
    }
    /// Makes room for a matrix of zeros, to be filled.
    pub fn room(&mut self, size: usize) {
        self.size = size;
        self.cells.clear();
        self.cells.resize(size * size, T::zero());
        self.filled.clear();
        self.filled.resize(size, 0);
    }
    /// Adds to a cell.
    pub fn add(&mut self, row: usize, col: usize, value: T) {
        if !value.is_nothing() {
            add(&mut self.cells[row * self.size + col], value);
            self.filled[row] |= 1 << (col % 64);
        }
    }
    /// Puts the factors of the matrix in its place. False where a pivot is lost beside its row and its column, or of more than 64
    /// unknowns: [`Linear`] may still do. Rows and columns may differ by any power of ten.
    pub fn reduce(&mut self) -> bool {
        let (size, cells, filled) = (self.size, &mut self.cells[..], &mut self.filled[..]);
        if size > 64 {
            return false;
        }
        let mut sizes: SmallVec<[f64; 24]> = smallvec![0.0; 2 * size];
        let (largest, scales) = sizes.split_at_mut(size);
        for (row, bits) in cells.chunks_exact(size).zip(&*filled) {
            for col in places(*bits) {
                largest[col] = if row[col].size() > largest[col] { row[col].size() } else { largest[col] };
            }
        }
        largest.iter_mut().for_each(|x| *x = 1.0 / *x);
        for ((row, bits), scale) in cells.chunks_exact(size).zip(&*filled).zip(scales.iter_mut()) {
            *scale = 1.0 / most(places(*bits).map(|col| row[col].size() * largest[col]));
        }
        self.order.clear();
        self.order.extend(0..size);
        let order = &mut self.order[..];
        for col in 0..size {
            let (mut best, mut most) = (col, 0.0);
            for (place, row) in order.iter().copied().enumerate().skip(col) {
                if filled[row] >> col & 1 == 1 {
                    let share = cells[row * size + col].size() * scales[row];
                    (best, most) = if share > most { (place, share) } else { (best, most) };
                }
            }
            let kept = most * largest[col] > POOR;
            if !kept {
                return false;
            }
            order.swap(col, best);
            let (pivot, bits) = (order[col] * size, filled[order[col]] & !1 << col);
            let inverse = T::of(1.0) / cells[pivot + col];
            cells[pivot + col] = inverse;
            for row in order[col + 1..].iter().copied() {
                let start = row * size;
                if filled[row] >> col & 1 == 0 || cells[start + col].is_nothing() {
                    continue;
                }
                let factor = cells[start + col] * inverse;
                cells[start + col] = factor;
                filled[row] |= bits;
                for c in places(bits) {
                    let above = cells[pivot + c];
                    if !above.is_nothing() {
                        cells[start + c] = cells[start + c] - factor * above;
                    }
                }
            }
        }
        true
    }
    /// Puts the solution in the place of a right-hand side. What is nothing beside the terms that made it is 0.
    pub fn solve(&self, right: &mut [T]) {
        // What is left of each side, with the magnitudes of its terms.
        let mut rests: SmallVec<[(T, f64); 12]> = smallvec![(T::zero(), 0.0); self.size];
        // As slices: a small vector asks at each access where it lies.
        let (rests, order) = (&mut rests[..], &self.order[..]);
        // The unknowns that are other than 0.
        let mut some = 0_u64;
        for (r, row) in order.iter().copied().enumerate() {
            let cells = &self.cells[row * self.size..][..self.size];
            let (mut sum, mut size) = (right[row], right[row].size());
            for c in places(self.filled[row] & some) {
                let term = cells[c] * rests[c].0;
                (sum, size) = (sum - term, size + term.size());
            }
            rests[r] = (sum, size);
            some |= u64::from(!sum.is_nothing()) << r;
        }
        some = 0;
        for (r, row) in order.iter().copied().enumerate().rev() {
            let cells = &self.cells[row * self.size..][..self.size];
            let (mut sum, mut size) = rests[r];
            for c in places(self.filled[row] & some) {
                let term = cells[c] * right[c];
                (sum, size) = (sum - term, size + term.size());
            }
            right[r] = sum.cleared(size) * cells[r];
            some |= u64::from(!right[r].is_nothing()) << r;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Dd;

    #[test]
    fn badly_scaled_unknowns_keep_their_digits() {
        // a - F = 1, q a + F = 3 with q = 1e30: a = 4/(q+1), F = a - 1 ... the tiny unknown must be right to the last bit.
        let q = 1e30;
        let mut l = Linear::<Dd>::new(2, 1);
        l.term(0, 0, Dd::ONE);
        l.term(0, 1, -Dd::ONE);
        l.right(0, 0, Dd::ONE);
        l.term(1, 0, Dd::new(q));
        l.term(1, 1, Dd::ONE);
        l.right(1, 0, Dd::new(3.0));
        let x = l.solve().unwrap();
        let a = Dd::new(4.0) / (Dd::new(q) + Dd::ONE);
        assert!(((x.get(0, 0) - a) / a).hi.abs() < 1e-25, "{:?}", x);
    }
    /// Unknowns that only name each other are 0, not the rounding of those beside them.
    #[test]
    fn what_is_only_rounding_is_zero() {
        // a - c w = 0, m a - F = 0, I w + c F = 0, and beside them T = 5: a = w = F = 0.
        let third = Dd::new(1.0) / Dd::new(3.0);
        let mut l = Linear::<Dd>::new(4, 1);
        l.term(0, 0, Dd::ONE);
        l.term(0, 1, -third);
        l.term(1, 0, Dd::new(7.0));
        l.term(1, 2, -Dd::ONE);
        l.term(2, 1, Dd::new(0.3));
        l.term(2, 2, third);
        l.term(3, 3, third);
        l.right(3, 0, Dd::new(5.0));
        let x = l.solve().unwrap();
        assert_eq!([0, 1, 2].map(|i| x.get(i, 0).hi.to_bits()), [0.0_f64; 3].map(f64::to_bits));
        assert!((x.get(3, 0).hi - 15.0).abs() < 1e-14);
        // The tiny acceleration of a large mass stays.
        let mut l = Linear::<Dd>::new(1, 1);
        l.term(0, 0, Dd::new(1e35));
        l.right(0, 0, Dd::new(1e3));
        assert_eq!(l.solve().unwrap().get(0, 0).hi.to_bits(), 1e-32_f64.to_bits());
    }
    #[test]
    fn factors_solve_what_elimination_solves() {
        let rows = [[0.0, 2.0, 1.0], [4.0, 1.0, -1.0], [1.0, 0.0, 3.0]];
        let mut factors = Factors::none();
        let mut fill = |size: usize, cells: &[f64]| {
            factors.room(size);
            cells.iter().enumerate().for_each(|(i, x)| factors.add(i / size, i % size, Dd::new(*x)));
            factors.reduce().then_some(factors.clone())
        };
        let mut x = [7.0, 3.0, 10.0].map(Dd::new);
        fill(3, rows.as_flattened()).unwrap().solve(&mut x);
        for (row, right) in rows.iter().zip([7.0, 3.0, 10.0]) {
            let sum = row.iter().zip(&x).fold(Dd::new(-right), |sum, (a, x)| sum + Dd::new(*a) * *x);
            assert!(sum.hi.abs() < 1e-29, "{x:?}");
        }
        assert!(fill(2, &[1.0, 2.0, 2.0, 4.0]).is_none());
    }
    #[test]
    fn a_singular_system_says_so() {
        let mut l = Linear::<Dd>::new(2, 1);
        l.term(0, 0, Dd::ONE);
        l.term(1, 0, Dd::ONE);
        l.right(0, 0, Dd::ONE);
        assert_eq!(l.solve().unwrap_err(), Singular { unknowns: 2, rank: 1 });
    }
}
