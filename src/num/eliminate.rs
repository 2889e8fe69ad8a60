//! Gauss-Jordan elimination on a few equations, any shape, in any number type.
use crate::num::Real;

/// Equations `a x = b` in reduced form.
#[derive(Debug, Clone)]
pub struct Reduced<T> {
    cols: usize,
    /// Rows of `cols + 1` numbers, the last one the right-hand side.
    rows: Vec<Vec<T>>,
    /// Row in which each unknown is the pivot.
    pivot: Vec<Option<usize>>,
}

/// Reduces equations with `cols` unknowns; each row holds `cols + 1` numbers. The unknowns in `free` become pivots only if
/// nothing else is left.
pub fn reduce<T: Real>(cols: usize, mut rows: Vec<Vec<T>>, free: &[usize]) -> Reduced<T> {
    let mut pivot = vec![None; cols];
    let mut used = vec![false; rows.len()];
    for allow_free in [false, true] {
        loop {
            // The pivot that is largest within its own row loses least.
            let mut best: Option<(usize, usize, f64)> = None;
            for (i, row) in rows.iter().enumerate() {
                if used[i] {
                    continue;
                }
                let size = row[..cols].iter().fold(0.0f64, |s, v| s.max(v.f64().abs()));
                for (j, v) in row[..cols].iter().enumerate() {
                    if pivot[j].is_some() || v.is_zero() || (free.contains(&j) && !allow_free) {
                        continue;
                    }
                    let share = v.f64().abs() / size;
                    if best.is_none_or(|(_, _, s)| share > s) {
                        best = Some((i, j, share));
                    }
                }
            }
            let Some((i, j, _)) = best else { break };
            used[i] = true;
            pivot[j] = Some(i);
            let lead = rows[i][j];
            for v in &mut rows[i] {
                if !v.is_zero() {
                    *v = *v / lead;
                }
            }
            rows[i][j] = T::of(1.0);
            let base = rows[i].clone();
            for (k, row) in rows.iter_mut().enumerate() {
                if k == i || row[j].is_zero() {
                    continue;
                }
                let f = row[j];
                for (v, b) in row.iter_mut().zip(&base) {
                    if !b.is_zero() {
                        *v = *v - f * *b;
                    }
                }
                row[j] = T::zero();
            }
        }
    }
    Reduced { cols, rows, pivot }
}

impl<T: Real> Reduced<T> {
    /// The unknowns that the equations leave open.
    pub fn open(&self) -> Vec<usize> {
        (0..self.cols).filter(|j| self.pivot[*j].is_none()).collect()
    }
    /// The solution with all right-hand sides zero and open unknown `which` equal to 1, the other open ones 0.
    pub fn mode(&self, which: usize) -> Vec<T> {
        (0..self.cols)
            .map(|j| match self.pivot[j] {
                Some(row) => -self.rows[row][which],
                None if j == which => T::of(1.0),
                None => T::zero(),
            })
            .collect()
    }
    /// The solution for the right-hand sides, if no unknown is open.
    pub fn solution(&self) -> Option<Vec<T>> {
        (0..self.cols).map(|j| self.pivot[j].map(|row| self.rows[row][self.cols])).collect()
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
        let rows = vec![vec![d(1.0), d(-2.0), d(0.0), d(0.0)], vec![d(0.0), d(1.0), d(-3.0), d(0.0)]];
        let r = reduce(3, rows, &[2]);
        assert_eq!(r.open(), [2]);
        assert_eq!(r.mode(2), [d(6.0), d(3.0), d(1.0)]);
        assert!(r.solution().is_none());
    }
}
