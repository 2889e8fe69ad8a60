//! One list of numbers: mean, standard deviation, quartiles, classes of a histogram.

/// Description of a list of numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// How many.
    pub n: usize,
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation with n - 1; 0 for a single number.
    pub deviation: f64,
    /// Least.
    pub least: f64,
    /// First quartile.
    pub lower: f64,
    /// Median.
    pub median: f64,
    /// Third quartile.
    pub upper: f64,
    /// Greatest.
    pub greatest: f64,
}

/// Describes finite numbers; `None` for no numbers.
pub fn summary(values: &[f64]) -> Option<Summary> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (least, greatest) = (*sorted.first()?, *sorted.last()?);
    Some(Summary {
        n: sorted.len(),
        mean: mean(values),
        deviation: variance(values).sqrt(),
        least,
        lower: quantile(&sorted, 0.25),
        median: quantile(&sorted, 0.5),
        upper: quantile(&sorted, 0.75),
        greatest,
    })
}

/// Arithmetic mean; 0 for no numbers.
pub fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

/// Variance with n - 1; 0 for fewer than two numbers.
pub fn variance(values: &[f64]) -> f64 {
    if values.len() < 2 {
        return 0.0;
    }
    let mean = mean(values);
    values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (values.len() - 1) as f64
}

/// Quantile of sorted numbers (at least one), straight between neighbours: type 7 of Hyndman and Fan (1996), that of R, NumPy
/// and spreadsheets.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let below = place.floor();
    let (i, rest) = (below as usize, place - below);
    let low = sorted[i.min(sorted.len() - 1)];
    let high = sorted[(i + 1).min(sorted.len() - 1)];
    low + rest * (high - low)
}

/// How many values lie in each of `classes` equal classes from 0 to `greatest` (> 0); each class holds its lower end, the last
/// one both. Values outside count in the nearest class.
pub fn histogram(values: &[f64], greatest: f64, classes: usize) -> Vec<usize> {
    let mut counts = vec![0; classes];
    for value in values {
        // 0.6 of 1 is in the seventh of ten classes, whatever rounding makes of it.
        let place = (value / greatest * classes as f64 + 1e-9).floor().max(0.0);
        counts[(place as usize).min(classes - 1)] += 1;
    }
    counts
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "small whole numbers are exact")]
mod tests {
    use super::*;

    #[test]
    fn by_hand() {
        let s = summary(&[4.0, 1.0, 3.0, 2.0]).unwrap();
        assert_eq!((s.n, s.mean, s.least, s.greatest), (4, 2.5, 1.0, 4.0));
        assert_eq!((s.lower, s.median, s.upper), (1.75, 2.5, 3.25));
        assert!((s.deviation - (5.0f64 / 3.0).sqrt()).abs() < 1e-15);
        assert_eq!(summary(&[7.0]).unwrap().deviation, 0.0);
        assert_eq!(summary(&[]), None);
    }
    #[test]
    fn each_value_in_one_class() {
        assert_eq!(histogram(&[0.0, 0.1, 0.3, 0.6, 0.7, 1.0, 1.0], 1.0, 10), [1, 1, 0, 1, 0, 0, 1, 1, 0, 2]);
        assert_eq!(histogram(&[-1.0, 5.0], 1.0, 2), [1, 1]);
    }
}
