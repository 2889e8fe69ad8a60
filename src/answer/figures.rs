//! How finely an answer was given: half a unit of its last figure, as a share of the number.
use crate::num::decimal::{nearest, one_of};

/// Figures beyond these are no longer counted: a double holds no more.
const MOST: usize = 15;

/// The figures of a number as they are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// How many: 3 of `2.50`, `-1.00e+02` and `0,00725`.
    pub count: usize,
    /// What they say without point and power of ten: 250.
    pub number: f64,
    /// Zeros behind them that may only fill up a whole number: 2 of `1500`.
    pub filled: usize,
}

/// The figures of the first number in a cell. Zeros at the end of a whole number may only fill it up and do not count. `None` if
/// there is no digit but 0.
pub fn written(cell: &str) -> Option<Figures> {
    let start = cell.find(|c: char| c.is_ascii_digit())?;
    // `.5` and `,5` have a mark before the first digit.
    let mut mark = cell[..start].ends_with(one_of(".,"));
    let mut digits = String::new();
    let mut chars = cell[start..].chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '0'..='9' => digits.push(c),
            '.' | ',' => mark = true,
            '\'' | '_' | ' ' | '\u{a0}' | '\u{2009}' | '\u{202f}' => {
                if !chars.peek().is_some_and(char::is_ascii_digit) {
                    break;
                }
            }
            _ => break,
        }
    }
    let figures = digits.trim_start_matches('0');
    let counted = if mark { figures } else { figures.trim_end_matches('0') };
    let filled = figures.len() - counted.len();
    let figures = counted;
    let figures = figures.get(..figures.len().min(MOST))?;
    let number = nearest(figures)?;
    (number > 0.0).then_some(Figures { count: figures.len(), number, filled })
}

/// Half a unit in the last place of the first number in a cell, as a share of that number: 0.005 / 2.50 for `2.50 N`.
pub fn rounding(cell: &str) -> Option<f64> {
    written(cell).map(|figures| 0.5 / figures.number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_as_they_are_written() {
        for (cell, counted) in [
            ("2.50 N", 250.0),
            ("2,5", 25.0),
            ("-0.00725 m", 725.0),
            ("1500", 15.0),
            ("1500.", 1500.0),
            ("1 234.5 N", 12345.0),
            ("3.0e5 rpm", 30.0),
            ("-1.00e+02", 100.0),
            ("6.02×10^3", 602.0),
            (".25", 25.0),
            ("115,2 N down", 1152.0),
            ("7 m/s^2", 7.0),
        ] {
            let found = rounding(cell).map(|share| 0.5 / share);
            assert!(found.is_some_and(|f: f64| (f - counted).abs() < 1e-9), "{cell}: {found:?}");
            let count = written(cell).map(|figures| figures.count);
            assert_eq!(count, Some(counted.to_string().len()), "{cell}");
        }
        assert_eq!([rounding("up"), rounding(""), rounding("0"), rounding("0.000")], [None; 4]);
    }
}
