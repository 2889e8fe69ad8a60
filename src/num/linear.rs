//! A small linear system in the number type of the solvers, by triangular factors.
//!
//! Rows and columns may differ by any power of ten: a pivot is judged beside the largest numbers of its row and its column, so that an
//! acceleration that is 1e-30 of the others keeps all its digits. Where pivots are lost, Gauss-Jordan elimination tells which unknowns
//! have only one value. Our own, and the same for doubles and 32 digits: a library's LU is of doubles.
use crate::num::Real;
use crate::num::eliminate::Equations;
use smallvec::{SmallVec, smallvec};

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
        let mut factors = Factors::none();
        factors.room(n);
        for (row, cells) in self.cells.chunks_exact(n + self.columns).enumerate() {
            cells[..n].iter().enumerate().for_each(|(col, x)| factors.add(row, col, *x));
        }
        if !factors.reduce() {
            return self.partly();
        }
        let mut x = SmallVec::with_capacity(n * self.columns);
        for k in 0..self.columns {
            let start = x.len();
            x.extend(self.rows(k).map(|(_, right, given)| right.cleared(given)));
            factors.solve(&mut x[start..]);
        }
        Ok(Solution { unknowns: n, x, open: SmallVec::new() })
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
}

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
        for (row, bits) in cells.chunks_exact(size.max(1)).zip(&*filled) {
            for col in places(*bits) {
                largest[col] = if row[col].size() > largest[col] { row[col].size() } else { largest[col] };
            }
        }
        largest.iter_mut().for_each(|x| *x = 1.0 / *x);
        for ((row, bits), scale) in cells.chunks_exact(size.max(1)).zip(&*filled).zip(scales.iter_mut()) {
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
