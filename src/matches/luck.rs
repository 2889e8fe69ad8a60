//! How likely luck is: what share of a question's keys lies in a window, and how strong several hits together are.
//!
//! Data are drawn by lot for each student alone. So, whatever way led to a wrong answer, a classmate's key beside it is one more
//! draw of the same question: the chance that it falls within the rounding of the answer is the share of draws that do.
use crate::num::trig;

/// Keys needed before a share means anything.
pub const ENOUGH: usize = 20;
/// Bins for each power of ten of evidence, and powers of ten that are told apart.
const FINE: usize = 16;
const DECADES: usize = 24;
/// Evidence beyond the last bin counts as that of the last.
pub const BINS: usize = FINE * DECADES + 1;
/// Widths for which the share of close pairs of keys is known: each is 1/sqrt(2) of the one before.
const WIDTHS: usize = 80;

/// The keys that a question has, as far as they are known.
#[derive(Debug, Clone)]
pub struct Keys {
    sorted: Vec<f64>,
    /// Half-width and share of pairs of keys that lie within it, widest first.
    close: Vec<(f64, f64)>,
    /// The neighbour that measures how dense keys lie.
    kth: usize,
}

impl Keys {
    /// From the keys of a class and, if there are any, from further draws. Those that are no numbers do not count.
    pub fn new(keys: impl Iterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = keys.filter(|k| k.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let n = sorted.len();
        let kth = (1..).find(|k| k * k >= n).unwrap_or(1).max(5);
        let mut close = Vec::new();
        if let (Some(first), Some(last)) = (sorted.first(), sorted.last()) {
            let mut width = (last - first).max(f64::MIN_POSITIVE);
            for _ in 0..WIDTHS {
                close.push((width, share_of_pairs(&sorted, width)));
                width *= std::f64::consts::FRAC_1_SQRT_2;
            }
        }
        Self { sorted, close, kth }
    }

    pub fn len(&self) -> usize {
        self.sorted.len()
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.sorted.is_empty()
    }

    /// The chance that the key of some one classmate lies within `half` of `x`; above 0, at most 1. The greatest of three:
    /// the share of keys that do, one of them left out (it may be the classmate's own); the density of keys around `x`, from
    /// the distance to the k-th of them, times the window; and the share of pairs of keys that are as close to each other,
    /// which is what a number hits that is itself made as keys are (whole multiples of a step, say).
    pub fn chance(&self, x: f64, half: f64) -> f64 {
        let n = self.sorted.len();
        if n < ENOUGH {
            return 1.0;
        }
        let from = self.sorted.partition_point(|k| *k < x - half);
        let to = self.sorted.partition_point(|k| *k <= x + half);
        let inside = (to - from).saturating_sub(1) as f64 / n as f64;
        let reach = self.reach(x);
        let density = if reach > half { (self.kth + 1) as f64 / (n + 1) as f64 * half / reach } else { 0.0 };
        let alike =
            self.close.iter().rev().find(|(width, _)| *width >= half).map_or(1.0, |(_, share)| *share);
        inside.max(density).max(alike).clamp(f64::MIN_POSITIVE, 1.0)
    }

    /// Distance to the k-th nearest key.
    fn reach(&self, x: f64) -> f64 {
        let at = self.sorted.partition_point(|k| *k < x);
        let (mut low, mut high) = (at, at);
        let mut reach = 0.0;
        for _ in 0..self.kth.min(self.sorted.len()) {
            let below = low.checked_sub(1).map_or(f64::INFINITY, |i| x - self.sorted[i]);
            let above = self.sorted.get(high).map_or(f64::INFINITY, |k| k - x);
            if below < above {
                low -= 1;
                reach = below;
            } else {
                high += 1;
                reach = above;
            }
        }
        reach
    }
}

/// Share of pairs that are at most so far apart.
fn share_of_pairs(sorted: &[f64], width: f64) -> f64 {
    let n = sorted.len();
    if n < 2 {
        return 1.0;
    }
    let (mut close, mut end) = (0usize, 0);
    for (i, key) in sorted.iter().enumerate() {
        while end < n && sorted[end] - key <= width {
            end += 1;
        }
        close += end - i - 1;
    }
    close as f64 / (n as f64 * (n - 1) as f64 / 2.0)
}

/// What luck may bring one student's wrong answers to one problem: how probable each hit is, the least probable first, and how
/// strong it is then: the chance that this or a less probable one hits, by the sum of them. Parts of one problem hang
/// together, so they are one piece of evidence, the strongest of them; no independence is assumed among them.
pub fn levels(chances: &mut [f64]) -> Vec<(f64, f64)> {
    chances.sort_by(f64::total_cmp);
    let mut sum = 0.0f64;
    chances
        .iter()
        .map(|p| {
            sum = (sum + p).min(1.0);
            (*p, sum)
        })
        .collect()
}

/// Evidence of a chance in bins, rounded down.
pub fn observed(chance: f64) -> usize {
    bins(chance).floor() as usize
}

fn bins(chance: f64) -> f64 {
    (-trig::log10(chance) * FINE as f64).clamp(0.0, (BINS - 1) as f64)
}

/// How the evidence of a student beside one honest classmate is distributed: probability of each bin, where problems are drawn
/// independently. What luck brings is rounded up, what is seen down, so the chance is never too small by binning.
pub fn spread(problems: &[Vec<(f64, f64)>]) -> Vec<f64> {
    let mut now = vec![0.0; BINS];
    now[0] = 1.0;
    let mut end = 1;
    for levels in problems {
        let mut next = vec![0.0; BINS];
        let hit: f64 = levels.iter().map(|(p, _)| p).sum::<f64>().min(1.0);
        let mut reached = end;
        for (bin, mass) in now[..end].iter().enumerate().filter(|(_, m)| **m > 0.0) {
            next[bin] += mass * (1.0 - hit);
            for (p, strength) in levels {
                let to = (bin + bins(*strength).ceil() as usize).min(BINS - 1);
                next[to] += mass * p;
                reached = reached.max(to + 1);
            }
        }
        (now, end) = (next, reached);
    }
    now
}

/// From the probability of each bin to that of the bin or one above it.
pub fn at_least(spread: &[f64]) -> Vec<f64> {
    let mut tail = spread.to_vec();
    for i in (0..tail.len().saturating_sub(1)).rev() {
        tail[i] += tail[i + 1];
    }
    tail
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_share_of_keys_is_what_it_is() {
        // 1000 keys, even from 0 to 1: a window of 0.002 holds 2 of them.
        let keys = Keys::new((0..1000).map(|i| f64::from(i) / 1000.0));
        for x in [0.25, 0.5003, 0.75] {
            let p = keys.chance(x, 1e-4);
            assert!((2e-4..6e-4).contains(&p), "{x}: {p}");
        }
        // Far from all keys it is small, and not nothing.
        let far = keys.chance(50.0, 1e-4);
        assert!(far > 0.0 && far < 1e-2, "{far}");
        // Keys on a lattice of 50 steps: however finely an answer is written, one of 50 hits.
        let lattice = Keys::new((0..1000).map(|i| f64::from(i % 50)));
        let p = lattice.chance(25.0, 1e-9);
        assert!((0.018..0.022).contains(&p), "{p}");
        // Too few keys prove nothing.
        assert!((Keys::new([1.0, 2.0].into_iter()).chance(1.0, 0.1) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn evidence_of_problems_multiplies_and_that_of_parts_does_not() {
        let one = levels(&mut [1e-3, 1e-3]);
        let tail = at_least(&spread(&[one.clone(), one.clone()]));
        // Both problems hit, in any of two parts each: (2e-3)^2.
        let both = tail[observed(2e-3 * 2e-3)];
        assert!((3.9e-6..5e-6).contains(&both), "{both}");
        // One problem hit, any of the four parts.
        let some = tail[observed(2e-3)];
        assert!((3.9e-3..4.1e-3).contains(&some), "{some}");
        assert!((tail[0] - 1.0).abs() < 1e-12);
    }
}
