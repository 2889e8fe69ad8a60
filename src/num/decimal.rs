//! Decimal numbers as they are written.
use std::cmp::Ordering;

/// Powers of ten beyond which a number is infinite or 0, whatever its digits.
const REACH: i32 = 400;

/// Is a character one of these?
pub fn one_of(these: &'static str) -> impl Fn(char) -> bool + Copy {
    move |c| these.contains(c)
}

/// The whole number at the start of a text, with its minus, and what follows.
pub fn leading_whole(text: &str) -> Option<(String, &str)> {
    let number = text.strip_prefix(one_of("-+\u{2212}")).unwrap_or(text);
    let length = number.bytes().take_while(u8::is_ascii_digit).count();
    let sign = if text.starts_with(one_of("-\u{2212}")) { "-" } else { "" };
    (length > 0).then(|| (format!("{sign}{}", &number[..length]), &number[length..]))
}

/// A whole number as a power of ten: of one beyond all doubles it does not matter by how much.
pub fn power_of_ten(whole: &str) -> i32 {
    let most = if whole.starts_with('-') { -100_000 } else { 100_000 };
    whole.parse().unwrap_or(most).clamp(-100_000, 100_000)
}

/// The double nearest to a decimal number such as `-1.5e-7`, ties to even; `None` of anything else. That of the standard library
/// has a table of ten kilobytes, too much for a page.
pub fn nearest(text: &str) -> Option<f64> {
    if cfg!(feature = "program") { text.parse().ok() } else { by_digits(text) }
}

/// The same digit by digit: halved or doubled until it lies between 1/2 and 1, then doubled once for each bit.
fn by_digits(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(one_of("-+")).unwrap_or(text);
    let (number, power) = match unsigned.split_once(one_of("eE")) {
        None => (unsigned, 0),
        Some((number, power)) => match leading_whole(power)? {
            (power, "") => (number, power_of_ten(&power)),
            _ => return None,
        },
    };
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let written = [whole, part].concat();
    if written.is_empty() || !written.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let digits: Vec<u8> = written.bytes().map(|b| b - b'0').skip_while(|d| *d == 0).collect();
    let point = i32::try_from(whole.len()).ok()? - i32::try_from(written.len() - digits.len()).ok()?;
    let size = Fraction { point: point.saturating_add(power), digits }.nearest();
    Some(if text.starts_with('-') { -size } else { size })
}

/// `0.ddd` times a power of ten, exact; the first digit is none of 0.
struct Fraction {
    digits: Vec<u8>,
    point: i32,
}

impl Fraction {
    fn nearest(mut self) -> f64 {
        if self.digits.is_empty() || self.point < -REACH {
            return 0.0;
        }
        if self.point > REACH {
            return f64::INFINITY;
        }
        let mut power = 0;
        while self.point > 0 {
            self.halve();
            power += 1;
        }
        while self.point < 0 || self.digits.first().is_some_and(|d| *d < 5) {
            match self.double() {
                0 => {}
                carry => {
                    self.digits.insert(0, carry);
                    self.point += 1;
                }
            }
            power -= 1;
        }
        // The exponent of the double, counted as its bits count it; below 1 there are fewer bits.
        let exponent = power + 1022;
        let mut mantissa = 0;
        for _ in 0..(exponent + 52).min(53) {
            mantissa = 2 * mantissa + u64::from(self.double());
        }
        mantissa += match self.digits.as_slice().cmp(&[5]) {
            Ordering::Less => 0,
            Ordering::Equal => mantissa % 2,
            Ordering::Greater => u64::from(exponent >= -52),
        };
        let exponent = u64::try_from(exponent - 1).unwrap_or(0);
        if exponent > 2045 { f64::INFINITY } else { f64::from_bits((exponent << 52) + mantissa) }
    }

    fn halve(&mut self) {
        let mut carry = 0;
        for digit in &mut self.digits {
            let value = 10 * carry + *digit;
            (*digit, carry) = (value / 2, value % 2);
        }
        if carry > 0 {
            self.digits.push(5);
        }
        if self.digits.first() == Some(&0) {
            self.digits.remove(0);
            self.point -= 1;
        }
    }

    /// Doubles the digits behind the point; gives what goes over it.
    fn double(&mut self) -> u8 {
        let mut carry = 0;
        for digit in self.digits.iter_mut().rev() {
            let value = 2 * *digit + carry;
            (*digit, carry) = (value % 10, value / 10);
        }
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
        carry
    }
}

#[cfg(test)]
mod tests {
    use super::by_digits;
    use proptest::prelude::*;

    fn as_in_std(text: &str) {
        let std = text.parse::<f64>().ok().map(f64::to_bits);
        assert_eq!(by_digits(text).map(f64::to_bits), std, "{text}");
    }

    #[test]
    fn edges_are_those_of_the_standard_library() {
        let texts = "|.|1.|.5|-0|+1e3|1e|1e+|1e-+3|1.2.3| 1|0x1|1e99999999999999999999|\
            1e-99999999999999999999|0e99999999999|9007199254740993|9007199254740992.99999|\
            9007199254740995|5e-324|2.4703282292062327e-324|2.4703282292062328e-324|\
            2.2250738585072011e-308|2.2250738585072014e-308|1.7976931348623157e308|\
            1.7976931348623158e308|1.7976931348623159e308|1.8e308|1e309|\
            0.000000000000000000000000000000000000000000000000001e60|\
            100000000000000000000000000000000000000000000000000000000e-40|8.5e-325";
        for text in texts.split('|') {
            as_in_std(text);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]
        #[test]
        fn every_number_is_that_of_the_standard_library(
            (digits, places) in (any::<u64>(), 0i32..25),
            (size, exponent) in (any::<u64>(), -345i32..330),
        ) {
            let value = f64::from_bits(size);
            as_in_std(&format!("{digits}e-{places}"));
            as_in_std(&format!("{digits}e{exponent}"));
            as_in_std(&format!("{}.{digits}", digits % 1000));
            if value.is_finite() {
                as_in_std(&format!("{value}"));
                as_in_std(&format!("{value:.40e}"));
            }
        }
    }
}
