//! A small linear system, solved to double-double: by elimination where that leaves residuals of rounding only, else by
//! nalgebra's LU in doubles, refined with double-double residuals (Wilkinson); derivatives from the same factors. Keeper
//! of nalgebra.
//!
//! In the second way rows are scaled by powers of two, and columns by the size of their own unknown, so that an
//! acceleration that is 1e-30 of the others keeps all its digits: the test of convergence is the residual of each row
//! against the terms of that row.
use crate::num::Real;
use crate::num::Rough;
use crate::num::U;
use crate::num::eliminate::Equations;
use nalgebra::DMatrix;
use nalgebra::SMatrix;
use smallvec::SmallVec;
use smallvec::smallvec;

/// Refinements before the columns are scaled anew.
const REFINEMENTS: usize = 6;
/// Times that the columns may be scaled anew.
const SCALINGS: usize = 24;

/// Equations in the making: a sum of terms for each row, and right-hand sides.
#[derive(Debug, Clone)]
pub struct Linear<T> {
    unknowns: usize,
    columns: usize,
    terms: SmallVec<[(usize, usize, T); 14]>,
    right: SmallVec<[(usize, usize, T); 6]>,
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

/// Why elimination alone does not do.
enum Hard {
    /// A row is a repetition of others.
    Repeats,
    /// The unknowns are too far apart in size.
    Scaled,
}

impl<T: Real> Linear<T> {
    /// No equations yet, in `unknowns` unknowns with `columns` right-hand sides.
    pub fn new(unknowns: usize, columns: usize) -> Self {
        Self { unknowns, columns, terms: SmallVec::new(), right: SmallVec::new() }
    }
    /// Adds `value * x[col]` to the left of a row.
    pub fn term(&mut self, row: usize, col: usize, value: T) {
        if T::SLOPES > 0 || !value.is_zero() {
            self.terms.push((row, col, value));
        }
    }
    /// Adds `value` to right-hand side `column` of a row.
    pub fn right(&mut self, row: usize, column: usize, value: T) {
        if T::SLOPES > 0 || !value.is_zero() {
            self.right.push((row, column, value));
        }
    }

    /// Solves for all right-hand sides: by elimination where that leaves residuals of rounding only and all unknowns are
    /// of like size, else by refinement. Where equations repeat each other, the unknowns that have only one value all the same.
    pub fn solve(&self) -> Result<Solution<T>, Singular> {
        let whole = |x| Solution { unknowns: self.unknowns, x, open: SmallVec::new() };
        match self.eliminated() {
            Ok(x) => Ok(whole(x)),
            Err(Hard::Scaled) => self.refined().or_else(|singular| self.partly().map_err(|_| singular)),
            // Refinement in doubles would settle on one of many solutions.
            Err(Hard::Repeats) => self.partly(),
        }
    }

    /// The unknowns that have only one value although equations repeat each other. Errors: they contradict each other.
    fn partly(&self) -> Result<Solution<T>, Singular> {
        let n = self.unknowns;
        let mut x = SmallVec::with_capacity(n * self.columns);
        let mut open: SmallVec<[bool; 8]> = smallvec![false; n];
        for k in 0..self.columns {
            let mut equations = Equations::new(n);
            for r in 0..n {
                let mut size = T::Rough::zero();
                let row: &mut [T] = equations.row();
                for (_, c, v) in self.terms.iter().filter(|(row, ..)| *row == r) {
                    row[*c] = row[*c] + *v;
                }
                for (_, _, v) in self.right.iter().filter(|(row, column, _)| *row == r && *column == k) {
                    row[n] = row[n] + *v;
                    size += v.size();
                }
                row[n] = row[n].cleared(size);
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

    /// Gaussian elimination with scaled partial pivoting, derivatives by its own factors: `A dx = db - dA x`. Nothing is
    /// allocated up to 5 unknowns and one right-hand side.
    fn eliminated(&self) -> Result<SmallVec<[T; 8]>, Hard> {
        let (n, m) = (self.unknowns, self.columns);
        let width = n + m;
        let nothing = T::Rough::zero();
        let mut cells: SmallVec<[T::Plain; 30]> = smallvec![T::Plain::zero(); n * width];
        let mut largest: SmallVec<[T::Rough; 6]> = smallvec![nothing; n];
        for (r, c, v) in &self.terms {
            let cell = &mut cells[r * width + c];
            *cell = if cell.is_zero() { v.plain() } else { *cell + v.plain() };
            largest[*r] = largest[*r].max(cell.size());
        }
        for (r, k, v) in &self.right {
            let cell = &mut cells[r * width + n + k];
            *cell = if cell.is_zero() { v.plain() } else { *cell + v.plain() };
        }
        // Row in which each unknown is the pivot; then the rows not used yet.
        let mut order: SmallVec<[usize; 6]> = (0..n).collect();
        // The share of the pivot's row that is taken from a row stays in the place of the number that it made 0.
        for col in 0..n {
            let mut best: Option<(usize, T::Rough)> = None;
            for (place, r) in order.iter().enumerate().skip(col) {
                let cell = cells[r * width + col];
                if !cell.is_zero() {
                    let share = cell.size() / largest[*r];
                    if best.is_none_or(|(_, s)| share > s) {
                        best = Some((place, share));
                    }
                }
            }
            order.swap(col, best.ok_or(Hard::Repeats)?.0);
            let pivot = order[col] * width;
            for r in &order[col + 1..] {
                let row = r * width;
                if cells[row + col].is_zero() {
                    continue;
                }
                let factor = cells[row + col] / cells[pivot + col];
                cells[row + col] = factor;
                for c in col + 1..width {
                    if !cells[pivot + c].is_zero() {
                        let less = factor * cells[pivot + c];
                        // A coefficient that is only rounding is no pivot.
                        let cell = &mut cells[row + c];
                        *cell = if c < n { cell.balance(-less) } else { *cell - less };
                    }
                }
            }
        }
        let mut out = SmallVec::with_capacity(n * m);
        let mut x: SmallVec<[T::Plain; 6]> = smallvec![T::Plain::zero(); n];
        let mut residual: SmallVec<[T::Plain; 6]> = smallvec![T::Plain::zero(); n];
        let mut size: SmallVec<[T::Rough; 6]> = smallvec![nothing; n];
        let mut change: SmallVec<[T::Rough; 60]> = SmallVec::new();
        let settled = T::Rough::of(T::SETTLED);
        for k in 0..m {
            for col in (0..n).rev() {
                let row = order[col] * width;
                let mut sum = cells[row + n + k];
                for c in col + 1..n {
                    if !cells[row + c].is_zero() && !x[c].is_zero() {
                        sum = sum.balance(-(cells[row + c] * x[c]));
                    }
                }
                x[col] = if sum.is_zero() { sum } else { sum / cells[row + col] };
            }
            if !like_size(&x) {
                return Err(Hard::Scaled);
            }
            self.residual(k, &x, &mut residual, &mut size);
            if !residual.iter().zip(&size).all(|(r, s)| r.size() <= settled * *s) {
                return Err(Hard::Scaled);
            }
            if T::SLOPES == 0 {
                out.extend(x.iter().map(|v| T::exactly(*v)));
                continue;
            }
            let slopes = T::SLOPES;
            change.clear();
            change.resize(n * slopes, nothing);
            let mut add = |row: usize, value: &T, factor: T::Rough| {
                for (i, c) in change[row * slopes..(row + 1) * slopes].iter_mut().enumerate() {
                    *c += factor * value.slope(i);
                }
            };
            for (r, _, v) in self.right.iter().filter(|(_, column, _)| *column == k) {
                add(*r, v, T::Rough::of(1.0));
            }
            for (r, c, v) in self.terms.iter().filter(|(_, c, _)| !x[*c].is_zero()) {
                add(*r, v, -x[*c].rough());
            }
            let mut take = |to: usize, from: usize, share: T::Rough| {
                for i in 0..slopes {
                    let less = share * change[from * slopes + i];
                    change[to * slopes + i] = change[to * slopes + i] - less;
                }
            };
            for col in 0..n {
                for r in &order[col + 1..] {
                    let share = cells[r * width + col];
                    if !share.is_zero() {
                        take(*r, order[col], share.rough());
                    }
                }
            }
            for col in (0..n).rev() {
                let row = order[col] * width;
                for c in col + 1..n {
                    if !cells[row + c].is_zero() {
                        let share = cells[row + c].rough() / cells[order[c] * width + c].rough();
                        take(order[col], order[c], share);
                    }
                }
            }
            for (col, v) in x.iter().enumerate() {
                let lead = cells[order[col] * width + col].rough();
                out.push(T::with_slopes(*v, |i| change[order[col] * slopes + i] / lead));
            }
        }
        Ok(out)
    }

    fn refined(&self) -> Result<Solution<T>, Singular> {
        let (n, m) = (self.unknowns, self.columns);
        let nothing = T::Rough::zero();
        let one = T::Rough::of(1.0);
        // Up to six unknowns and two right-hand sides nothing is allocated.
        let mut x: SmallVec<[T::Plain; 12]> = smallvec![T::Plain::zero(); n * m];
        let mut inverse: SmallVec<[f64; 36]> = smallvec![0.0; n * n];
        let mut rows: SmallVec<[T::Rough; 6]> = smallvec![one; n];
        let mut cols: SmallVec<[T::Rough; 6]> = smallvec![one; n];
        let mut residual: SmallVec<[T::Plain; 6]> = smallvec![T::Plain::zero(); n];
        let mut size: SmallVec<[T::Rough; 6]> = smallvec![nothing; n];
        let converged = T::Rough::of(T::SETTLED);
        let mut out = SmallVec::with_capacity(n * m);
        let mut scaled = true;
        for k in 0..m {
            if scaled {
                // Scales that fit one right-hand side may be noise for the next.
                cols.fill(one);
                if self.factor(&mut inverse, &mut rows, &cols).is_err() {
                    // Singular, or a column so small beside the others that it vanished.
                    self.equilibrate(&mut rows, &mut cols);
                    self.factor(&mut inverse, &mut rows, &cols)?;
                }
                scaled = false;
            }
            let column = &mut x[k * n..(k + 1) * n];
            let mut settled = false;
            'scalings: for scaling in 0..=SCALINGS {
                if scaling > 0 {
                    scaled = true;
                    for (c, v) in cols.iter_mut().zip(column.iter()) {
                        if !v.is_zero() {
                            *c = T::Rough::pow2(v.rough().exponent());
                        }
                    }
                    self.factor(&mut inverse, &mut rows, &cols)?;
                    self.silence(&mut inverse, &rows, &cols);
                }
                for _ in 0..REFINEMENTS {
                    self.residual(k, column, &mut residual, &mut size);
                    settled = residual.iter().zip(&size).all(|(r, s)| r.size() <= converged * *s);
                    if settled {
                        break 'scalings;
                    }
                    for (i, x) in column.iter_mut().enumerate() {
                        let mut sum = nothing;
                        for ((share, r), scale) in
                            inverse[i * n..(i + 1) * n].iter().zip(&residual).zip(&rows)
                        {
                            sum += T::Rough::of(*share) * (r.rough() * *scale);
                        }
                        *x = *x + T::Plain::with_rough(sum * cols[i]);
                    }
                }
                // Terms that cancel altogether leave noise, which no scaling can settle: that unknown is 0.
                self.cancel(k, column, &inverse, &rows, &cols);
            }
            self.cancel(k, column, &inverse, &rows, &cols);
            self.vanish(k, column);
            // Where unknowns cancel to their last bits the residual stays a little above rounding.
            settled |= residual.iter().zip(&size).all(|(r, s)| r.negligible(*s));
            if !settled || column.iter().any(|v| !v.is_finite()) {
                return Err(Singular { unknowns: n, rank: n.saturating_sub(1) });
            }
            if T::SLOPES > 0 && far_apart(column, &cols) {
                // A row of the inverse that belongs to a tiny unknown is noise unless its column is scaled to it. Where
                // that hides another one, the factors that solved the equations have to do.
                scaled = true;
                let kept = (inverse.clone(), rows.clone(), cols.clone());
                self.scale_to(column, &mut rows, &mut cols);
                if self.factor(&mut inverse, &mut rows, &cols).is_err() {
                    (inverse, rows, cols) = kept;
                }
            }
            self.slopes(k, column, (&inverse, &rows, &cols), &mut out);
        }
        Ok(Solution { unknowns: n, x: out, open: SmallVec::new() })
    }

    /// Inverse of the matrix with its rows and columns scaled by powers of two, row-major; fills in the scales of the rows.
    fn factor(&self, inverse: &mut [f64], rows: &mut [T::Rough], cols: &[T::Rough]) -> Result<(), Singular> {
        let n = self.unknowns;
        inverse.fill(0.0);
        rows.fill(T::Rough::zero());
        for (r, c, v) in &self.terms {
            rows[*r] = rows[*r].max(v.size() * cols[*c]);
        }
        for r in rows.iter_mut() {
            *r = T::Rough::pow2(if r.is_zero() { 0 } else { -r.exponent() });
        }
        for (r, c, v) in &self.terms {
            inverse[r * n + c] += (v.rough() * cols[*c] * rows[*r]).f64();
        }
        if invert(n, inverse) { Ok(()) } else { Err(Singular { unknowns: n, rank: rank(n, inverse) }) }
    }

    /// Sets to 0 the entries of the inverse that are its own rounding, at most some `u |A^-1| |A| |A^-1|`: an unknown that
    /// is exactly 0 would otherwise be fed with noise for ever.
    fn silence(&self, inverse: &mut [f64], rows: &[T::Rough], cols: &[T::Rough]) {
        let n = self.unknowns;
        let mut half: SmallVec<[f64; 36]> = smallvec![0.0; n * n];
        for (r, c, v) in &self.terms {
            let entry = (v.rough() * cols[*c] * rows[*r]).f64().abs();
            for i in 0..n {
                half[i * n + c] += inverse[i * n + r].abs() * entry;
            }
        }
        let noise: SmallVec<[f64; 36]> = (0..n * n)
            .map(|at| (0..n).map(|k| half[at / n * n + k] * inverse[k * n + at % n].abs()).sum::<f64>())
            .collect();
        for (entry, noise) in inverse.iter_mut().zip(noise) {
            if entry.abs() <= 8.0 * U * noise {
                *entry = 0.0;
            }
        }
    }

    /// Scales each column to its unknown; that of an unknown that is 0 so that it hides nothing in its rows.
    fn scale_to(&self, x: &[T::Plain], rows: &mut [T::Rough], cols: &mut [T::Rough]) {
        rows.fill(T::Rough::zero());
        for (c, v) in cols.iter_mut().zip(x).filter(|(_, v)| !v.is_zero()) {
            *c = T::Rough::pow2(v.rough().exponent());
        }
        for (r, c, v) in self.terms.iter().filter(|(_, c, _)| !x[*c].is_zero()) {
            rows[*r] = rows[*r].max(v.size() * cols[*c]);
        }
        let mut least: SmallVec<[Option<T::Rough>; 6]> = smallvec![None; self.unknowns];
        for (r, c, v) in self.terms.iter().filter(|(r, _, v)| !v.is_zero() && !rows[*r].is_zero()) {
            let fits = rows[*r] / v.size();
            if least[*c].is_none_or(|l| fits < l) {
                least[*c] = Some(fits);
            }
        }
        for ((c, v), least) in cols.iter_mut().zip(x).zip(least) {
            if let (true, Some(least)) = (v.is_zero(), least) {
                *c = T::Rough::pow2(least.exponent());
            }
        }
    }

    /// Scales each column to its largest entry in rows that are scaled to theirs.
    fn equilibrate(&self, rows: &mut [T::Rough], cols: &mut [T::Rough]) {
        rows.fill(T::Rough::zero());
        cols.fill(T::Rough::zero());
        for (r, _, v) in &self.terms {
            rows[*r] = rows[*r].max(v.size());
        }
        for (r, c, v) in self.terms.iter().filter(|(_, _, v)| !v.is_zero()) {
            cols[*c] = cols[*c].max(v.size() / rows[*r]);
        }
        for c in cols.iter_mut() {
            *c = T::Rough::pow2(if c.is_zero() { 0 } else { -c.exponent() });
        }
    }

    /// Sets to 0 what is nothing beside the terms that it is made of.
    fn cancel(&self, k: usize, x: &mut [T::Plain], inverse: &[f64], rows: &[T::Rough], cols: &[T::Rough]) {
        let n = self.unknowns;
        for (i, x) in x.iter_mut().enumerate() {
            let mut natural = T::Rough::zero();
            for (r, _, v) in self.right.iter().filter(|(_, column, _)| *column == k) {
                natural += (T::Rough::of(inverse[i * n + r]) * rows[*r] * v.rough()).abs();
            }
            if x.negligible((natural * cols[i]).abs()) {
                *x = T::Plain::zero();
            }
        }
    }

    /// Sets to 0 all unknowns together that no equation would miss: beside the other terms of each of its equations such an
    /// unknown is rounding, or all other terms of the equation are such unknowns too.
    fn vanish(&self, k: usize, x: &mut [T::Plain]) {
        let mut noise: SmallVec<[bool; 12]> = x.iter().map(|v| !v.is_zero()).collect();
        let mut others: SmallVec<[T::Rough; 6]> = smallvec![T::Rough::zero(); self.unknowns];
        loop {
            others.fill(T::Rough::zero());
            for (r, _, v) in self.right.iter().filter(|(_, column, _)| *column == k) {
                others[*r] += v.size();
            }
            for (r, c, v) in self.terms.iter().filter(|(_, c, _)| !noise[*c]) {
                others[*r] += (v.plain() * x[*c]).size();
            }
            let before = noise.clone();
            for (r, c, v) in self.terms.iter().filter(|(r, c, _)| before[*c] && !others[*r].is_zero()) {
                noise[*c] &= (v.plain() * x[*c]).negligible(others[*r]);
            }
            if noise == before {
                break;
            }
        }
        for (v, _) in x.iter_mut().zip(&noise).filter(|(_, noise)| **noise) {
            *v = T::Plain::zero();
        }
    }

    fn residual(&self, k: usize, x: &[T::Plain], residual: &mut [T::Plain], size: &mut [T::Rough]) {
        residual.fill(T::Plain::zero());
        size.fill(T::Rough::zero());
        for (r, column, v) in &self.right {
            if *column == k {
                residual[*r] = residual[*r] + v.plain();
                size[*r] += v.size();
            }
        }
        for (r, c, v) in &self.terms {
            let t = v.plain() * x[*c];
            residual[*r] = residual[*r] - t;
            size[*r] += t.size();
        }
    }

    /// Implicit differentiation: `A dx = db - dA x`, with the same factors; appends the unknowns of right-hand side `k`.
    fn slopes(
        &self,
        k: usize,
        column: &[T::Plain],
        (inverse, rows, cols): (&[f64], &[T::Rough], &[T::Rough]),
        out: &mut SmallVec<[T; 8]>,
    ) {
        let (n, m) = (self.unknowns, T::SLOPES);
        let nothing = T::Rough::zero();
        if m == 0 {
            out.extend(column.iter().map(|v| T::exactly(*v)));
            return;
        }
        let mut change: SmallVec<[T::Rough; 72]> = smallvec![nothing; n * m];
        let mut sums: SmallVec<[T::Rough; 24]> = smallvec![nothing; m];
        let mut add = |row: usize, value: &T, factor: T::Rough| {
            for (i, c) in change[row * m..(row + 1) * m].iter_mut().enumerate() {
                *c += factor * value.slope(i);
            }
        };
        for (r, c, v) in &self.right {
            if *c == k {
                add(*r, v, rows[*r]);
            }
        }
        for (r, c, v) in &self.terms {
            add(*r, v, -column[*c].rough() * rows[*r]);
        }
        for i in 0..n {
            sums.fill(nothing);
            for j in 0..n {
                let share = inverse[i * n + j];
                if share != 0.0 {
                    let share = T::Rough::of(share);
                    for (s, c) in sums.iter_mut().zip(&change[j * m..(j + 1) * m]) {
                        *s += share * *c;
                    }
                }
            }
            out.push(T::with_slopes(column[i], |s| sums[s] * cols[i]));
        }
    }
}

/// Binary digits between the unknowns, beside their scales, from which on the inverse is computed anew.
const APART: i32 = 24;

/// Are all unknowns that are not 0 within [`APART`] of each other, and finite?
fn like_size<P: Real>(x: &[P]) -> bool {
    let sizes = x.iter().filter(|v| !v.is_zero()).map(|v| v.rough().exponent());
    x.iter().all(|v| v.is_finite()) && spread(sizes) <= APART
}

/// Are the unknowns of very different sizes, measured by the scales of their columns?
fn far_apart<P: Real>(x: &[P], cols: &[P::Rough]) -> bool {
    let known = x.iter().zip(cols).filter(|(v, _)| !v.is_zero());
    spread(known.map(|(v, c)| v.rough().exponent() - c.exponent())) > APART
}

/// From the least to the greatest exponent; far below 0 if there is none.
fn spread(exponents: impl Iterator<Item = i32>) -> i32 {
    let (least, most) = exponents.fold((i32::MAX, i32::MIN), |(a, b), e| (a.min(e), b.max(e)));
    most.saturating_sub(least)
}

/// Inverts a row-major matrix in place by LU with partial pivoting; sizes up to 12 live on the stack.
fn invert(n: usize, a: &mut [f64]) -> bool {
    macro_rules! fixed {
        ($($size:literal)*) => {
            match n {
                0 => true,
                $($size => match SMatrix::<f64, $size, $size>::from_row_slice(a).lu().try_inverse() {
                    Some(inverse) => {
                        for i in 0..$size { for j in 0..$size { a[i * $size + j] = inverse[(i, j)]; } }
                        a.iter().all(|v| v.is_finite())
                    }
                    None => false,
                },)*
                _ => match DMatrix::from_row_slice(n, n, a).lu().try_inverse() {
                    Some(inverse) => {
                        for i in 0..n { for j in 0..n { a[i * n + j] = inverse[(i, j)]; } }
                        a.iter().all(|v| v.is_finite())
                    }
                    None => false,
                },
            }
        };
    }
    fixed!(1 2 3 4 5 6 7 8 9 10 11 12)
}

/// Rank by Gaussian elimination with full pivoting, for the message of a refusal.
fn rank(n: usize, a: &[f64]) -> usize {
    let mut m = DMatrix::from_row_slice(n, n, a);
    let mut rank = 0;
    for step in 0..n {
        let mut best = (step, step, 0.0f64);
        for i in step..n {
            for j in step..n {
                if m[(i, j)].abs() > best.2 {
                    best = (i, j, m[(i, j)].abs());
                }
            }
        }
        if best.2 < 1e-12 {
            break;
        }
        m.swap_rows(step, best.0);
        m.swap_columns(step, best.1);
        rank += 1;
        for i in step + 1..n {
            let f = m[(i, step)] / m[(step, step)];
            for j in step..n {
                let t = m[(step, j)] * f;
                m[(i, j)] -= t;
            }
        }
    }
    rank
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Dd;
    use crate::num::Jet;

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
    #[test]
    fn derivatives_by_the_same_factors() {
        // x = b/a, y = c x: cond 2 and 3.
        let (a, b, c) = (Jet::<3>::datum(0, 3.0), Jet::<3>::datum(1, 5.0), Jet::<3>::datum(2, 7.0));
        let mut l = Linear::new(2, 1);
        l.term(0, 0, a);
        l.right(0, 0, b);
        l.term(1, 1, Jet::of(1.0));
        l.term(1, 0, -c);
        let x = l.solve().unwrap();
        assert!((x.get(0, 0).cond() - 2.0).abs() < 1e-14);
        assert!((x.get(1, 0).cond() - 3.0).abs() < 1e-14);
    }
    /// Two unknowns that only name each other and are 0 kept their rounding: nothing of the right-hand side was in them.
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
        let mut x = [1e-32, 3e-32, 7e-32, 15.0].map(Dd::new);
        l.vanish(0, &mut x);
        assert_eq!(x.map(|v| v.hi.to_bits()), [0.0_f64, 0.0, 0.0, 15.0].map(f64::to_bits));
        // A tiny acceleration of a large mass is none.
        let mut l = Linear::<Dd>::new(1, 1);
        l.term(0, 0, Dd::new(1e35));
        l.right(0, 0, Dd::new(1e3));
        let mut x = [Dd::new(1e-32)];
        l.vanish(0, &mut x);
        assert_eq!(x[0].hi.to_bits(), 1e-32_f64.to_bits());
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
