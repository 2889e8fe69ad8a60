//! Numbers rounded for people: in decimals and half up, as a person rounds who sees the digits.
//!
//! A double holds fifteen decimal digits; behind them stands only how far it, or the data that it was made from, lie from the
//! decimal number that is meant. So 0.5275, which no double is, is rounded as 0.5275 and not as 0.52749999999999996891.
//! Half a unit of the last place goes away from zero, so that a number and its opposite look alike.

use crate::num::decimal::nearest;

/// Decimal digits that a double holds, whatever it is.
const HELD: usize = 15;

/// Fifteen digits as one integer, and the power of ten of the first of them.
fn held(value: f64) -> Option<(u64, i32)> {
    let text = format!("{:.*e}", HELD - 1, value.abs());
    let (mantissa, exponent) = text.split_once('e')?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).fold(0, |n, b| 10 * n + u64::from(b - b'0'));
    Some((digits, exponent.parse().ok()?))
}

/// The first `kept` of fifteen digits, half up; one digit more where all were nines, zeros behind the fifteenth.
fn first_of(digits: u64, kept: usize) -> String {
    match u32::try_from(HELD.saturating_sub(kept)) {
        Ok(dropped) if dropped > 0 => {
            let unit = 10u64.pow(dropped);
            ((digits + unit / 2) / unit).to_string()
        }
        _ if digits == 0 => "0".to_owned(),
        _ => format!("{digits}{}", "0".repeat(kept - HELD)),
    }
}

/// So many decimals, `-0.053` for three; never `-0.000`. `inf` and `NaN` stay what they are.
pub fn decimals(value: f64, decimals: usize) -> String {
    let Some((digits, exponent)) = held(value).filter(|_| value.is_finite()) else {
        return value.to_string();
    };
    let places = i64::try_from(decimals).unwrap_or(i64::MAX / 2);
    let whole = match usize::try_from(i64::from(exponent) + 1 + places) {
        Ok(kept) => first_of(digits, kept),
        // Less than half a unit of the last place.
        Err(_) => "0".to_owned(),
    };
    let sign = if value < 0.0 && whole.bytes().any(|b| b != b'0') { "-" } else { "" };
    let text = format!("{whole:0>width$}", width = decimals + 1);
    match text.split_at(text.len() - decimals) {
        (whole, "") => format!("{sign}{whole}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

/// So many significant figures with a power of ten, `-5.28e-1` for three; a single one where none is asked.
pub fn figures(value: f64, figures: usize) -> String {
    let figures = figures.max(1);
    let Some((digits, exponent)) = held(value).filter(|_| value.is_finite()) else {
        return value.to_string();
    };
    let (digits, exponent) = match first_of(digits, figures) {
        digits if digits.len() > figures => (digits[..figures].to_owned(), exponent + 1),
        digits => (format!("{digits:0<figures$}"), exponent),
    };
    let sign = if value < 0.0 { "-" } else { "" };
    match digits.split_at(1) {
        (first, "") => format!("{sign}{first}e{exponent}"),
        (first, rest) => format!("{sign}{first}.{rest}e{exponent}"),
    }
}

/// As many significant figures as asked, with the zeros at the end that belong to them.
pub fn significant(value: f64, figures: usize) -> String {
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
    let short = self::figures(value, figures);
    let exponent: i32 = short.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let decimals = i32::try_from(figures).unwrap_or(17) - 1 - exponent;
    if (-5..6).contains(&exponent) && decimals >= 0 {
        self::decimals(value, usize::try_from(decimals).unwrap_or(0))
    } else if (0..6).contains(&exponent) {
        // More digits before the point than figures: round them there.
        let whole = nearest(&short).unwrap_or(value);
        self::decimals(whole, 0)
    } else {
        short
    }
}

/// The number that is meant by so many significant figures of this one.
pub fn rounded(value: f64, to_figures: usize) -> f64 {
    nearest(&figures(value, to_figures)).unwrap_or(value)
}

/// A number that a bank wrote, perhaps in another unit, in SI: as it stands where six figures write it, else with five.
pub fn constant(value: f64) -> String {
    if rounded(value, 6).to_bits() == value.to_bits() { format!("{value}") } else { significant(value, 5) }
}

/// At most so many decimals, without zeros at their end: `12.5` for three.
pub fn at_most_decimals(value: f64, most: usize) -> String {
    without_zeros(&decimals(value, most))
}

/// A decimal number without the zeros at its end that say nothing.
pub fn without_zeros(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }.to_owned()
}

/// A share in per cent with at most so many decimals, without zeros at their end and without the sign: `12.5`.
pub fn per_cent(share: f64, most: usize) -> String {
    at_most_decimals(share * 100.0, most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_float::DBig;
    use proptest::prelude::*;
    use std::str::FromStr;

    fn exact(text: &str) -> DBig {
        DBig::from_str(text).expect(text)
    }

    #[test]
    fn a_constant_is_written_briefly() {
        let [stiffness, spin] = [10.0 * 14.593_902_937_206_363, 100.0 * std::f64::consts::PI / 30.0];
        assert_eq!([constant(stiffness), constant(spin)], ["145.94", "10.472"]);
        assert_eq!([constant(0.3048), constant(-12.5), constant(1e6)], ["0.3048", "-12.5", "1000000"]);
    }

    // The tests before this one held rounding against the formatting of the standard library, which rounds the binary number:
    // of 0.5275 and 0.6025, both printed with six figures, one went down and one up. A `DBig` rounds decimals half away from zero.
    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(3000) })]
        #[test]
        fn decimals_are_rounded_half_up_as_exact_arithmetic_does(
            digits in 1u64..1_000_000_000_000_000,
            short in 0u32..15,
            exponent in -20i32..8,
            tie in any::<bool>(),
            negative in any::<bool>(),
            kept in 1usize..14,
            places in 0usize..12,
        ) {
            // Half of them end in a 5, where it matters.
            let digits = digits / 10u64.pow(short);
            let digits = if tie { digits / 10 * 10 + 5 } else { digits };
            let text = format!("{}{digits}e{exponent}", if negative { "-" } else { "" });
            let (value, meant) = (text.parse::<f64>().unwrap(), exact(&text));
            let told = figures(value, kept);
            prop_assert_eq!(exact(&told), meant.clone().with_precision(kept).value(), "{} to {} figures: {}", text, kept, told);
            let told = decimals(value, places);
            let ten = exact(&format!("1e{places}"));
            let whole = (meant.with_precision(60).value() * &ten).round();
            prop_assert_eq!(exact(&told) * ten, whole, "{} to {} decimals: {}", text, places, told);
            prop_assert_eq!(told.split_once('.').map_or(0, |(_, part)| part.len()), places, "{}", told);
        }
    }

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
            assert_eq!(significant(value, figures), text);
        }
    }

    #[test]
    fn what_is_no_tie_is_written_as_ever() {
        for (value, places) in
            [(0.0, 2), (-0.0, 0), (1234.5678, 1), (-9.96, 1), (1e-9, 3), (6.5e15, 0), (0.125, 20)]
        {
            let plain = format!("{:.places$}", value + 0.0);
            assert_eq!(decimals(value, places), plain, "{value}");
        }
        assert_eq!(decimals(-0.001, 2), "0.00");
        assert_eq!(
            (decimals(0.5, 0), decimals(0.4999, 0), decimals(-1.5, 0)),
            ("1".into(), "0".into(), "-2".into())
        );
        for (value, kept) in [(0.0, 3), (9.996, 3), (-1e300, 1), (1.0 / 3.0, 15)] {
            assert_eq!(figures(value, kept), format!("{value:.*e}", kept - 1), "{value}");
        }
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(decimals(odd, 2), odd.to_string());
            assert_eq!(figures(odd, 2), odd.to_string());
        }
    }

    #[test]
    fn dust_behind_the_digits_that_a_double_holds_decides_nothing() {
        // (3 * 0.35 + 5 * 0.634) / 8 and the like, a bit off in doubles.
        for step in 0..2000u32 {
            let tie = f64::from(2 * step + 1) / 2000.0;
            let up = f64::from(step + 1) / 1000.0;
            for near in [tie.next_down(), tie, tie.next_up()] {
                assert_eq!(decimals(near, 3), format!("{up:.3}"), "{near}");
            }
        }
    }
}
