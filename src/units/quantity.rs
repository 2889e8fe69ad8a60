//! A number with its unit, read strictly: for banks and the command line. Students' cells are read in `answer`.
use crate::num::decimal::{leading_whole, nearest, one_of, power_of_ten};
use crate::units::{Unit, UnitFault};
use std::fmt;

/// A value and the unit in which it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenQuantity {
    /// Number as written, in `unit`.
    pub number: f64,
    /// The unit as written, or the one that a plain number takes.
    pub unit: Unit,
    /// All of the text is the number: no unit is written, not even `1`.
    pub plain: bool,
    /// In SI (angles in rad): the nearest double where the unit is a decimal multiple.
    pub value_si: f64,
    /// As a scene holds it: degrees for an angle, else SI.
    pub value_scene: f64,
}

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QuantityFault {
    /// It does not begin with a number.
    NoNumber,
    /// The number is beyond the range of a double.
    TooLarge,
    /// What follows the number is no unit.
    Unit(UnitFault),
}

impl fmt::Display for QuantityFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            QuantityFault::NoNumber => write!(f, "a number is expected, such as `40 kg` or `0.2`"),
            QuantityFault::TooLarge => write!(f, "the number is too large"),
            QuantityFault::Unit(fault) => write!(f, "{fault}"),
        }
    }
}

impl std::error::Error for QuantityFault {}

/// A decimal number at the start of a text.
struct LeadingDecimal {
    negative: bool,
    digits: Option<u128>,
    exponent: i32,
    /// Bytes of the text.
    length: usize,
}

/// Sign (`-`, `+` or U+2212), digits with at most one point, `e` and a whole exponent.
fn leading_decimal(text: &str) -> Option<LeadingDecimal> {
    let unsigned = text.strip_prefix(one_of("-\u{2212}"));
    let negative = unsigned.is_some();
    let body = unsigned.or_else(|| text.strip_prefix('+')).unwrap_or(text);
    let bytes = body.as_bytes();
    let (mut at, mut digits, mut seen, mut point, mut decimals) = (0, Some(0u128), false, false, 0u32);
    while let Some(&b) = bytes.get(at) {
        match b {
            b'0'..=b'9' => {
                digits = digits.and_then(|d| d.checked_mul(10)?.checked_add(u128::from(b - b'0')));
                decimals += u32::from(point);
                seen = true;
            }
            b'.' if !point => point = true,
            _ => break,
        }
        at += 1;
    }
    if !seen {
        return None;
    }
    let mut exponent = 0;
    if matches!(bytes.get(at), Some(b'e' | b'E'))
        && let Some((power, behind)) = leading_whole(&body[at + 1..])
    {
        exponent = power_of_ten(&power);
        at = body.len() - behind.len();
    }
    let length = text.len() - body.len() + at;
    Some(LeadingDecimal { negative, digits, exponent: exponent - i32::try_from(decimals).ok()?, length })
}

/// Reads `40kg`, `200 mm`, `9.81 m/s^2`, `-3e2 N`; a plain number takes the unit `plain`.
///
/// ```
/// use slipstick::units::{Unit, parse_quantity};
/// assert_eq!(parse_quantity("200 mm", &Unit::one()).unwrap().value_si, 0.2);
/// ```
///
/// # Errors
/// Says why the text is no quantity.
pub fn parse_quantity(text: &str, plain: &Unit) -> Result<WrittenQuantity, QuantityFault> {
    let text = text.trim();
    let decimal = leading_decimal(text).ok_or(QuantityFault::NoNumber)?;
    let rest = text[decimal.length..].trim();
    let unit =
        if rest.is_empty() { plain.clone() } else { Unit::parse(rest).map_err(QuantityFault::Unit)? };
    let written = text[..decimal.length].replace('\u{2212}', "-");
    let number = nearest(&written).ok_or(QuantityFault::NoNumber)?;
    let (value_si, value_scene) = match decimal.digits {
        Some(digits) if decimal.exponent.abs() < 100_000 => (
            unit.scale().apply(decimal.negative, digits, decimal.exponent),
            unit.scene_scale().apply(decimal.negative, digits, decimal.exponent),
        ),
        _ => (unit.to_si(number), unit.scene_scale().apply(false, 1, 0) * number),
    };
    if !(number.is_finite() && value_si.is_finite() && value_scene.is_finite()) {
        return Err(QuantityFault::TooLarge);
    }
    Ok(WrittenQuantity { number, unit, plain: rest.is_empty(), value_si, value_scene })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn si(text: &str) -> f64 {
        parse_quantity(text, &Unit::one()).unwrap().value_si
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "these are the nearest doubles")]
    fn nearest_doubles() {
        for (text, value) in [
            ("200 mm", 0.2),
            ("40kg", 40.0),
            ("9.81 m/s^2", 9.81),
            ("0.30 m", 0.3),
            ("\u{2212}3e2 N", -300.0),
            ("12 ft", 3.6576),
            ("1 lbf", 4.448_221_615_260_5),
            ("36 km/h", 10.0),
            ("2 rev", 4.0 * std::f64::consts::PI),
            ("1 slug", 14.593_902_937_206_364),
            ("90 deg", std::f64::consts::FRAC_PI_2),
            ("5 %", 0.05),
            ("1e-7 km", 1e-4),
            ("2.5 kN", 2500.0),
            ("3 µm", 3e-6),
            ("7", 7.0),
            ("60 Hz", 120.0 * std::f64::consts::PI),
            ("7 N mm", 0.007),
        ] {
            assert_eq!(si(text), value, "{text}");
        }
        assert_eq!(parse_quantity("30.1 deg", &Unit::one()).unwrap().value_scene, 30.1);
        let half = parse_quantity("0.5 rev", &Unit::one()).unwrap().value_scene;
        assert!((half - 180.0).abs() < 1e-13, "{half}");
        assert_eq!(Unit::parse("mm").unwrap().decimal_to_si(2001, 1), 0.2001);
        assert_eq!(Unit::parse("deg").unwrap().decimal_to_scene(301, 1), 30.1);
    }

    #[test]
    fn units_and_their_spellings() {
        for (text, ascii, tex) in [
            ("m/s²", "m/s^2", r"\mathrm{m}/\mathrm{s}^{2}"),
            ("°", "deg", r"{}^\circ"),
            ("N·m", "N m", r"\mathrm{N}\,\mathrm{m}"),
            ("Nm", "N m", r"\mathrm{N}\,\mathrm{m}"),
            ("Ns", "N s", r"\mathrm{N}\,\mathrm{s}"),
            ("Nms", "N m s", r"\mathrm{N}\,\mathrm{m}\,\mathrm{s}"),
            ("s⁻¹", "1/s", r"1/\mathrm{s}"),
            ("1", "1", ""),
            ("%", "%", r"\%"),
            ("r/min", "rev/min", r"\mathrm{rev}/\mathrm{min}"),
            ("kg*m**2", "kg m^2", r"\mathrm{kg}\,\mathrm{m}^{2}"),
            (
                "kg m^2 / (s^2 rad)",
                "kg m^2/s^2/rad",
                r"\mathrm{kg}\,\mathrm{m}^{2}/\mathrm{s}^{2}/\mathrm{rad}",
            ),
            ("µm", "um", r"\mathrm{\mu m}"),
            ("m/s2", "m/s^2", r"\mathrm{m}/\mathrm{s}^{2}"),
            ("rad s-1", "rad/s", r"\mathrm{rad}/\mathrm{s}"),
            ("ft·lbf", "ft lbf", r"\mathrm{ft}\,\mathrm{lbf}"),
            ("ft-lb", "ft lbf", r"\mathrm{ft}\,\mathrm{lbf}"),
        ] {
            let unit = Unit::parse(text).unwrap();
            assert_eq!((unit.ascii(), unit.tex().as_str()), (ascii, tex), "{text}");
            let again = Unit::parse(ascii).unwrap();
            assert_eq!((again.dimension(), again.scale()), (unit.dimension(), unit.scale()), "{text}");
        }
    }

    #[test]
    fn faults_say_where() {
        let fault = |t: &str| Unit::parse(t).unwrap_err().to_string();
        assert_eq!(fault("m/sek"), "unknown unit `sek`; did you mean `sec`?");
        assert_eq!(fault("m/xy"), "unknown unit `xy` at column 3");
        assert_eq!(fault("RAD/s"), "unknown unit `RAD`; did you mean `rad`?");
        assert_eq!(fault("m/s^"), "an exponent from -9 to 9 is expected at column 4 of the unit");
        assert_eq!(fault("m/"), "the unit is not finished");
        assert_eq!(fault("m,s"), "unexpected `,` at column 2");
        assert_eq!(fault(""), "the unit is missing");
        let fault = |t: &str| Unit::parse_any_case(t).unwrap_err().to_string();
        assert_eq!(fault("mw"), "unknown unit `mw`: write MW or mW (upper and lower case matter)");
    }

    #[test]
    fn case_forgiven_where_one_unit_can_be_meant() {
        for (text, ascii) in
            [("RAD/S", "rad/s"), ("n", "N"), ("KN", "kN"), ("Rad/s", "rad/s"), ("RPM", "rpm"), ("KG", "kg")]
        {
            let (unit, forgiven) = Unit::parse_any_case(text).unwrap();
            assert_eq!((unit.ascii(), forgiven), (ascii, true), "{text}");
        }
        assert!(matches!(Unit::parse_any_case("mw"), Err(UnitFault::CaseMatters { .. })));
        assert!(matches!(Unit::parse_any_case("NM"), Err(UnitFault::CaseMatters { .. })));
    }

    #[test]
    fn mismatches_name_the_missing_factor() {
        let say = |a: &str, b: &str| Unit::parse(a).unwrap().mismatch(&Unit::parse(b).unwrap());
        assert_eq!(
            say("N m", "N"),
            "expected N m (energy or moment), found N (force): a factor m is missing"
        );
        assert_eq!(
            say("rad/s", "rad"),
            "expected rad/s (angular velocity), found rad (angle): a factor s too many"
        );
        assert_eq!(say("N", "lb"), "expected N (force), found lb (mass): lb is a mass here; write lbf");
    }

    #[test]
    fn the_radian_may_be_dropped_but_not_the_degree() {
        let agree = |a: &str, b: &str| Unit::parse(a).unwrap().agrees(&Unit::parse(b).unwrap());
        assert!(
            agree("rad/s", "1/s") && agree("1/s^2", "rad/s^2") && agree("rpm", "1/s") && agree("rad", "1")
        );
        assert!(!agree("1", "deg") && !agree("m/s", "rad/s") && !agree("deg", "1"));
        assert!(agree("m/s", "ft/s") && agree("J", "N m"));
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,70}", unitlike in "[a-zA-Z0-9/^*()²⁻¹· .%°µ-]{0,20}") {
            let one = Unit::one();
            for t in [text.as_str(), unitlike.as_str()] {
                let _ = parse_quantity(t, &one);
                if let Ok((unit, _)) = Unit::parse_any_case(t) {
                    let again = Unit::parse(unit.ascii()).expect("ascii() is read back");
                    prop_assert_eq!(again.dimension(), unit.dimension());
                    let _ = (unit.tex(), unit.html(), unit.mismatch(&one));
                }
            }
        }

        #[test]
        #[expect(clippy::float_cmp, reason = "the nearest double is asked")]
        fn decimals_are_correctly_rounded(int in -999_999_999i64..999_999_999, decimals in 0u8..9) {
            let text = format!("{int}e-{decimals}");
            let thousandth = format!("{int}e-{}", decimals + 3);
            prop_assert_eq!(Unit::parse("m").unwrap().decimal_to_si(int, decimals), text.parse::<f64>().unwrap());
            prop_assert_eq!(Unit::parse("mm").unwrap().decimal_to_si(int, decimals), thousandth.parse::<f64>().unwrap());
        }
    }
}
