//! One list of numbers: mean, standard deviation, quartiles, classes of a histogram.

/// Description of a list of numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    pub n: usize,
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation with n - 1; 0 for a single number.
    pub deviation: f64,
    pub least: f64,
    /// First quartile.
    pub lower: f64,
    pub median: f64,
    /// Third quartile.
    pub upper: f64,
    pub greatest: f64,
}

/// Describes finite numbers; `None` for no numbers.
pub fn summary(values: &[f64]) -> Option<Distribution> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (least, greatest) = (*sorted.first()?, *sorted.last()?);
    Some(Distribution {
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
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let below = place.floor();
    let (i, rest) = (below as usize, place - below);
    let low = sorted[i.min(sorted.len() - 1)];
    let high = sorted[(i + 1).min(sorted.len() - 1)];
    low + rest * (high - low)
}

/// Classes of a histogram: where they begin, how wide they are, how many values lie in each.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    /// Lower end of the first class.
    pub from: f64,
    /// Width of each, > 0.
    pub width: f64,
    /// Values in each.
    pub counts: Vec<usize>,
}

/// Steps in which marks are commonly given.
const STEPS: [f64; 4] = [1.0, 0.5, 0.25, 0.1];
/// Widths of classes.
const WIDTHS: [f64; 12] = [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0];

/// A histogram of values from 0 to `greatest` (> 0) with at most `most` classes. Where all values are multiples of a step and
/// there are not too many of them, each multiple gets a class of its own, with the multiple in its middle; else classes have a
/// round width, a multiple of that step, and hold their lower end. Values outside count in the nearest class.
pub fn histogram(values: &[f64], greatest: f64, most: usize) -> Histogram {
    let whole = |x: f64| (x - x.round()).abs() < 1e-6;
    let step = STEPS.into_iter().find(|step| values.iter().all(|v| whole(v / step)));
    let (from, width) = match step {
        Some(step) if greatest / step < most as f64 => (-step / 2.0, step),
        _ => {
            let fits = |w: &&f64| greatest / **w <= most as f64 && step.is_none_or(|s| whole(**w / s));
            (0.0, WIDTHS.iter().find(fits).copied().unwrap_or(greatest / most as f64))
        }
    };
    let classes = (((greatest - from) / width - 1e-6).ceil() as usize).max(1);
    let mut counts = vec![0; classes];
    for value in values {
        // 0.6 stands at the beginning of the class from 0.6 on, whatever rounding makes of it.
        let place = ((value - from) / width + 1e-6).floor().max(0.0);
        counts[(place as usize).min(classes - 1)] += 1;
    }
    Histogram { from, width, counts }
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
        // Whole points: a class for each.
        let whole = histogram(&[0.0, 1.0, 1.0, 4.0], 4.0, 12);
        assert_eq!(whole, Histogram { from: -0.5, width: 1.0, counts: vec![1, 2, 0, 0, 1] });
        // Too many for that: classes of 5 points; the greatest is in the last.
        let many = histogram(&[0.0, 4.0, 5.0, 50.0], 50.0, 12);
        assert_eq!(many, Histogram { from: 0.0, width: 5.0, counts: vec![2, 1, 0, 0, 0, 0, 0, 0, 0, 1] });
        // Thirds: no step.
        let thirds = histogram(&[1.0 / 3.0, 0.6, 7.0, -1.0], 1.0, 12);
        assert_eq!((thirds.from, thirds.width), (0.0, 0.1));
        assert_eq!(thirds.counts, [1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
        assert_eq!(histogram(&[0.25; 3], 0.3, 12).counts.iter().sum::<usize>(), 3);
    }
}
