//! Rounded numbers for people.
use crate::num::shown;

/// As many significant figures as asked, with the zeros at the end that belong to them.
pub fn rounded(value: f64, figures: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        let word = if value.is_nan() {
            "none"
        } else if value > 0.0 {
            "infinite"
        } else {
            "-infinite"
        };
        return word.to_owned();
    }
    let figures = figures.max(1);
    let short = shown::figures(value, figures);
    let exponent: i32 = short.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let decimals = i32::try_from(figures).unwrap_or(17) - 1 - exponent;
    if (-5..6).contains(&exponent) && decimals >= 0 {
        shown::decimals(value, usize::try_from(decimals).unwrap_or(0))
    } else if (0..6).contains(&exponent) {
        // More digits before the point than figures: round them there.
        let whole: f64 = short.parse().unwrap_or(value);
        shown::decimals(whole, 0)
    } else {
        short
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_kept() {
        for (value, figures, text) in [
            (30.2634, 3, "30.3"),
            (0.05, 3, "0.0500"),
            (1234.6, 3, "1230"),
            (9.999, 3, "10.0"),
            (-62.6, 4, "-62.60"),
            (1e-9, 2, "1.0e-9"),
            (0.0, 3, "0"),
        ] {
            assert_eq!(rounded(value, figures), text);
        }
    }
}
