//! Decimal numbers as integers: no float, so that the printed value is the value used.
use crate::bank::node::shorten;
use crate::units::TENS;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// Most decimals of a datum.
const MAX_DECIMALS: u8 = 12;
/// Most digits of a datum: they fit a double exactly.
pub const MAX_DIGITS: usize = 15;

/// A decimal number: `value` times 10^-`decimals`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Decimal {
    /// The digits.
    pub value: i64,
    /// How many of them stand after the point.
    pub decimals: u8,
}

impl Decimal {
    /// Reads `-0.30`: digits with at most one point and at most 15 digits.
    pub fn parse(text: &str) -> Option<Self> {
        Self::read(text).ok()
    }
    /// Reads a share, `5 %` or `0.05`; errors: what is wrong with its number, in words.
    pub fn share(text: &str) -> Result<f64, String> {
        let text = text.trim();
        let (digits, more) = text.strip_suffix('%').map_or((text, 0), |rest| (rest.trim(), 2));
        Self::read(digits).map(|d| Self { decimals: d.decimals + more, ..d }.f64())
    }
    /// The same as [`Decimal::parse`]; errors: what is wrong with it, in words.
    pub fn read(text: &str) -> Result<Self, String> {
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let all = whole.bytes().chain(part.bytes());
        if whole.is_empty() || !all.clone().all(|b| b.is_ascii_digit()) || digits.ends_with('.') {
            return Err(format!("`{}` is not a decimal number", shorten(text)));
        }
        let decimals = u8::try_from(part.len()).ok().filter(|d| *d <= MAX_DECIMALS);
        let (Some(decimals), true) = (decimals, whole.len() + part.len() <= MAX_DIGITS) else {
            return Err(format!(
                "`{}` has too many digits: {} in all and {} after the point, where at most {MAX_DIGITS} and {MAX_DECIMALS} are read",
                shorten(text),
                whole.len() + part.len(),
                part.len()
            ));
        };
        let value = all.fold(0i64, |v, b| v * 10 + i64::from(b - b'0'));
        Ok(Self { value: if negative { -value } else { value }, decimals })
    }
    /// The same number with more decimals.
    pub(super) fn widened(self, decimals: u8) -> Option<i64> {
        let mut value = self.value;
        for _ in self.decimals..decimals {
            value = value.checked_mul(10)?;
        }
        (value.unsigned_abs() < 1_000_000_000_000_000).then_some(value)
    }
    /// The same number without zeros at the end of its decimals, at most so many of them.
    #[must_use]
    pub fn trimmed(self, at_most: u8) -> Self {
        let mut out = self;
        for _ in 0..at_most {
            if out.decimals == 0 || out.value % 10 != 0 {
                break;
            }
            out = Self { value: out.value / 10, decimals: out.decimals - 1 };
        }
        out
    }
    /// The nearest double: digits and power of ten are doubles themselves, so that one quotient is all rounding there is.
    #[expect(clippy::cast_precision_loss, reason = "at most 15 digits")]
    pub fn f64(self) -> f64 {
        self.value as f64 / TENS[usize::from(self.decimals)]
    }
    /// As it is printed: `-0.30`.
    pub fn text(self) -> String {
        let mut text = String::new();
        self.push(&mut text);
        text
    }
    /// Appends it as it is printed.
    pub fn push(self, out: &mut String) {
        let digits = self.value.unsigned_abs();
        let sign = if self.value < 0 { "-" } else { "" };
        let width = usize::from(self.decimals);
        let ten = 10u64.saturating_pow(u32::from(self.decimals));
        let _ = match width {
            0 => write!(out, "{sign}{digits}"),
            _ => write!(out, "{sign}{}.{:0width$}", digits / ten, digits % ten),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_as_drawn() {
        for text in ["0.30", "-0.05", "12", "-7", "0.001"] {
            assert_eq!(Decimal::parse(text).map(Decimal::text).as_deref(), Some(text));
        }
        for bad in ["", "-", ".", "1.", ".5", "1,5", "1e3", "0x1", "١", "--1", "1234567890123456"] {
            assert_eq!(Decimal::parse(bad), None, "{bad}");
        }
    }
}
