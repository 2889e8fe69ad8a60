//! Shares with intervals, difficulty and discrimination of parts, reliability of the whole.
use crate::num::chance::{self, NORMAL_95};
use crate::report::stats::{Interval, LEAST_FOR_CORRELATION, NoStatistic, ranks, spread};

/// A share with the interval of Wilson (1927), 95 %, without correction for continuity; `None` for no trials.
///
/// `(p + z²/2n ± z sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n)`; it stays within 0 and 1 and is sensible for few trials and shares
/// near 0 and 1 (Brown, Cai, DasGupta 2001).
pub fn wilson(hits: usize, trials: usize) -> Option<Interval> {
    if trials == 0 {
        return None;
    }
    let (n, z) = (trials as f64, NORMAL_95);
    let p = hits as f64 / n;
    let middle = p + z * z / (2.0 * n);
    let reach = z * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + z * z / n;
    Some(Interval {
        value: p,
        low: ((middle - reach) / scale).max(0.0),
        high: ((middle + reach) / scale).min(1.0),
    })
}

/// Marks of students on items: a row for each student.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Matrix {
    /// Points, row after row.
    pub rows: Vec<Vec<f64>>,
    /// Number of items.
    pub items: usize,
}

impl Matrix {
    fn column(&self, item: usize) -> Vec<f64> {
        self.rows.iter().map(|r| r[item]).collect()
    }

    /// Corrected item-total correlation: Pearson's correlation of the points of an item with the sum of all other items
    /// (Nunnally and Bernstein 1994, chapter 8). The item is left out of the sum, else it would correlate with itself. Errors:
    /// fewer than [`LEAST_FOR_CORRELATION`] students, or nothing that varies.
    pub fn discrimination(&self, item: usize) -> Result<f64, NoStatistic> {
        enough(self.rows.len())?;
        if self.items < 2 {
            return Err(NoStatistic::OnePart);
        }
        let own = self.column(item);
        let rest: Vec<f64> = self.rows.iter().map(|r| r.iter().sum::<f64>() - r[item]).collect();
        ranks::pearson(&own, &rest).ok_or(NoStatistic::AllAlike)
    }

    /// Cronbach's alpha, `k/(k-1) (1 - sum of variances / variance of sums)` (Cronbach 1951), with the exact interval of Feldt
    /// (1965): `1 - (1 - alpha) F`, F at 97.5 % and 2.5 % with n - 1 and (n - 1)(k - 1) degrees of freedom. Errors: fewer than
    /// [`LEAST_FOR_CORRELATION`] students, fewer than two items that vary, or no variance of sums.
    pub fn alpha(&self) -> Result<Interval, NoStatistic> {
        enough(self.rows.len())?;
        self.alpha_of_any()
    }

    fn alpha_of_any(&self) -> Result<Interval, NoStatistic> {
        let variances: Vec<f64> =
            (0..self.items).map(|i| spread::variance(&self.column(i))).filter(|v| *v > 0.0).collect();
        if variances.len() < 2 {
            return Err(NoStatistic::FewParts);
        }
        let sums: Vec<f64> = self.rows.iter().map(|r| r.iter().sum()).collect();
        let whole = spread::variance(&sums);
        if whole <= 1e-12 * variances.iter().sum::<f64>() {
            return Err(NoStatistic::EqualTotals);
        }
        // An item without variance neither adds nor takes; it is no item of the scale.
        let k = variances.len() as f64;
        let value = k / (k - 1.0) * (1.0 - variances.iter().sum::<f64>() / whole);
        let n = self.rows.len() as f64;
        let (above, below) = (n - 1.0, (n - 1.0) * (k - 1.0));
        let end = |p: f64| 1.0 - (1.0 - value) * chance::f_quantile(p, above, below);
        Ok(Interval { value, low: end(0.975), high: end(0.025).min(1.0) })
    }
}

fn enough(n: usize) -> Result<(), NoStatistic> {
    if n >= LEAST_FOR_CORRELATION { Ok(()) } else { Err(NoStatistic::TooFew(n)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::Words;

    fn close(a: f64, b: f64, within: f64) {
        assert!((a - b).abs() <= within, "{a} {b}");
    }

    /// Newcombe 1998 (Statistics in Medicine 17, 857), table I, method 3: 81/263, 15/148, 0/20, 1/29.
    #[test]
    fn wilson_as_published() {
        for (hits, trials, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let found = wilson(hits, trials).unwrap();
            close(found.low, low, 5e-5);
            close(found.high, high, 5e-5);
        }
        assert_eq!(wilson(0, 0), None);
        close(wilson(9, 9).unwrap().high, 1.0, 1e-12);
    }

    /// By hand: items (1,2,3,4) and (1,3,2,4): variances 5/3 each, sums 2,5,5,8 of variance 6, alpha = 2 (1 - (10/3)/6) = 8/9.
    /// Ends by Feldt with F(0.975; 3, 3) = 15.4392 (tables) and its reciprocal.
    #[test]
    fn alpha_by_hand() {
        let rows = vec![vec![1.0, 1.0], vec![2.0, 3.0], vec![3.0, 2.0], vec![4.0, 4.0]];
        let matrix = Matrix { rows, items: 2 };
        let alpha = matrix.alpha_of_any().unwrap();
        close(alpha.value, 8.0 / 9.0, 1e-14);
        close(alpha.low, 1.0 - 15.4392 / 9.0, 1e-4);
        close(alpha.high, 1.0 - 1.0 / (9.0 * 15.4392), 1e-5);
        assert_eq!(matrix.alpha(), Err(NoStatistic::TooFew(4)));
        assert_eq!(matrix.discrimination(0), Err(NoStatistic::TooFew(4)));
        let told = |n| NoStatistic::TooFew(n).say(&Words::english());
        assert!(told(1).starts_with("1 student is too few"), "{}", told(1));
        assert!(told(2).starts_with("2 students are too few"), "{}", told(2));
        assert!(told(0).starts_with("0 students are too few"), "{}", told(0));
    }

    #[test]
    fn equal_marks_have_no_number() {
        let flat = Matrix { rows: vec![vec![1.0, 0.0, 2.0]; 30], items: 3 };
        assert!(flat.alpha().is_err() && flat.discrimination(1).is_err());
        // Parts differ, but all have the same total.
        let rows = (0..30).map(|i| if i % 2 == 0 { vec![1.0, 0.0] } else { vec![0.0, 1.0] }).collect();
        let against = Matrix { rows, items: 2 };
        assert!(against.alpha().is_err());
        close(against.discrimination(0).unwrap(), -1.0, 1e-12);
    }
}
