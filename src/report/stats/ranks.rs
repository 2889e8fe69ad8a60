//! Does one thing go with another: correlations, of ranks too, groups by ranks, and how many comparisons allow for chance.
use crate::num::chance::NORMAL_95;
use crate::num::{chance, trig};
use crate::report::stats::{Interval, spread};

/// Pearson's correlation of pairs; `None` if one of the two does not vary.
pub fn pearson(xs: &[f64], ys: &[f64]) -> Option<f64> {
    let (mx, my) = (spread::mean(xs), spread::mean(ys));
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for (x, y) in xs.iter().zip(ys) {
        let (dx, dy) = (x - mx, y - my);
        xx += dx * dx;
        yy += dy * dy;
        xy += dx * dy;
    }
    // What rounding leaves of equal numbers is no variance.
    let size = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>() * 1e-24;
    if xx <= size(xs) || yy <= size(ys) {
        return None;
    }
    Some((xy / (xx.sqrt() * yy.sqrt())).clamp(-1.0, 1.0))
}

/// Ranks from 1, equal values share the mean of theirs.
pub fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut i = 0;
    while i < order.len() {
        let mut end = i + 1;
        while end < order.len() && values[order[end]].total_cmp(&values[order[i]]).is_eq() {
            end += 1;
        }
        // Ranks i+1 ..= end have this mean.
        let shared = (i + 1 + end) as f64 / 2.0;
        for place in &order[i..end] {
            ranks[*place] = shared;
        }
        i = end;
    }
    ranks
}

/// A correlation of ranks with its 95 % interval and the probability of one at least so far from 0 by chance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spearman {
    /// The correlation with its interval.
    pub rho: Interval,
    /// Two-sided probability by chance.
    pub p: f64,
}

/// Spearman's rho, Pearson's correlation of the ranks. Interval by Fisher's z with the variance `(1 + rho²/2)/(n - 3)` of
/// Bonett and Wright (2000); the probability takes z with the variance for rho = 0, `1/(n - 3)`. `None` for fewer than four
/// pairs or if one of the two does not vary.
pub fn spearman(xs: &[f64], ys: &[f64]) -> Option<Spearman> {
    if xs.len() < 4 {
        return None;
    }
    let rho = pearson(&ranks(xs), &ranks(ys))?;
    let n = xs.len() as f64 - 3.0;
    // At +-1 Fisher's z is infinite.
    let inside = rho.clamp(-1.0 + 1e-12, 1.0 - 1e-12);
    let z = 0.5 * trig::ln((1.0 + inside) / (1.0 - inside));
    let reach = NORMAL_95 * ((1.0 + rho * rho / 2.0) / n).sqrt();
    let back = |z: f64| {
        let e = trig::exp(2.0 * z);
        if e.is_finite() { (e - 1.0) / (e + 1.0) } else { 1.0 }
    };
    let rho = Interval { value: rho, low: back(z - reach), high: back(z + reach) };
    Some(Spearman { rho, p: chance::normal_two_sided(z * n.sqrt()) })
}

/// Do groups differ in rank? The probability by chance of the statistic H of Kruskal and Wallis (1952) with their correction for
/// ties, by chi-squared with one degree less than there are groups. For two groups it is the test of Wilcoxon, Mann and Whitney.
/// `None` for fewer than two groups or if nothing varies.
pub fn kruskal_wallis(groups: &[Vec<f64>]) -> Option<(f64, f64)> {
    let all: Vec<f64> = groups.iter().flatten().copied().collect();
    if groups.len() < 2 || groups.iter().any(Vec::is_empty) {
        return None;
    }
    let ranks = ranks(&all);
    let n = all.len() as f64;
    let mut from = 0;
    let mut sum = 0.0;
    for group in groups {
        let of_group: f64 = ranks[from..from + group.len()].iter().sum();
        sum += of_group * of_group / group.len() as f64;
        from += group.len();
    }
    let h = 12.0 / (n * (n + 1.0)) * sum - 3.0 * (n + 1.0);
    let mut sorted = all;
    sorted.sort_by(f64::total_cmp);
    let mut ties = 0.0;
    for same in sorted.chunk_by(|a, b| a.total_cmp(b).is_eq()) {
        let t = same.len() as f64;
        ties += t * t * t - t;
    }
    let correction = 1.0 - ties / (n * n * n - n);
    if correction <= 1e-12 {
        return None;
    }
    let h = (h / correction).max(0.0);
    Some((h, chance::chi_squared_above(h, groups.len() as f64 - 1.0)))
}

/// Probabilities corrected for being many, by Holm (1979): the chance that any of the comparisons comes out so by chance alone
/// stays at its level.
pub fn holm(ps: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..ps.len()).collect();
    order.sort_by(|a, b| ps[*a].total_cmp(&ps[*b]));
    let mut corrected = vec![1.0; ps.len()];
    let mut least: f64 = 0.0;
    for (i, place) in order.iter().enumerate() {
        least = least.max(ps[*place] * (ps.len() - i) as f64).min(1.0);
        corrected[*place] = least;
    }
    corrected
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "halves are exact")]
mod tests {
    use super::*;

    fn close(a: f64, b: f64, within: f64) {
        assert!((a - b).abs() <= within, "{a} {b}");
    }

    #[test]
    fn ranks_share_ties() {
        assert_eq!(ranks(&[10.0, 20.0, 10.0, 5.0, 20.0, 20.0]), [2.5, 5.0, 2.5, 1.0, 5.0, 5.0]);
    }

    /// IQ and hours of television of ten persons, as in many textbooks: rho = -29/165.
    #[test]
    fn spearman_as_in_textbooks() {
        let iq = [106.0, 100.0, 86.0, 101.0, 99.0, 103.0, 97.0, 113.0, 112.0, 110.0];
        let tv = [7.0, 27.0, 2.0, 50.0, 28.0, 29.0, 20.0, 12.0, 6.0, 17.0];
        let found = spearman(&iq, &tv).unwrap();
        close(found.rho.value, -29.0 / 165.0, 1e-12);
        // z = atanh(-29/165) = -0.177606, standard error sqrt((1 + rho²/2)/7) = 0.38087 by hand.
        close(found.rho.low, -0.7278, 2e-4);
        close(found.rho.high, 0.5145, 2e-4);
        close(found.p, 0.638, 2e-3);
        assert_eq!(spearman(&iq, &[1.0; 10]), None);
        let same = spearman(&iq, &iq).unwrap();
        assert!(same.rho.value > 0.999_999 && same.rho.high <= 1.0 && same.p < 1e-6);
    }

    /// By hand: ranks 1, 2, 3 against 4, 5, 6: H = 12/42 (36/3 + 225/3) - 21 = 27/7, one degree of freedom.
    #[test]
    fn groups_by_hand() {
        let (h, p) = kruskal_wallis(&[vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]]).unwrap();
        close(h, 27.0 / 7.0, 1e-12);
        close(p, 0.049_534_613, 1e-8);
        // With ties, ranks 1.5 1.5 4 | 4 4 6: H = (12/42 (49/3 + 196/3) - 21) / (1 - 30/210).
        let (h, _) = kruskal_wallis(&[vec![1.0, 1.0, 2.0], vec![2.0, 2.0, 3.0]]).unwrap();
        close(h, (12.0 / 42.0 * (49.0 / 3.0 + 196.0 / 3.0) - 21.0) / (1.0 - 30.0 / 210.0), 1e-12);
        assert_eq!(kruskal_wallis(&[vec![1.0, 1.0], vec![1.0]]), None);
        assert_eq!(kruskal_wallis(&[vec![1.0, 1.0], vec![]]), None);
    }

    #[test]
    fn many_comparisons_by_hand() {
        let found = holm(&[0.01, 0.04, 0.03, 0.005]);
        for (a, b) in found.iter().zip([0.03, 0.06, 0.06, 0.02]) {
            close(*a, b, 1e-12);
        }
        assert_eq!(holm(&[0.9, 0.8]), [1.0, 1.0]);
        assert!(holm(&[]).is_empty());
    }
}
