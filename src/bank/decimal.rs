//! Decimal numbers as integers, and how a datum is drawn: no float, so that the printed value is the value used.
use crate::bank::Draw;
use crate::units::TENS;

/// Most decimals of a datum.
pub const MAX_DECIMALS: u8 = 12;
/// Most digits of a datum: they fit a double exactly.
pub const MAX_DIGITS: usize = 15;

/// A decimal number: `value` times 10^-`decimals`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// The same; errors: what is wrong with it, in words.
    pub fn read(text: &str) -> Result<Self, String> {
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let all = whole.bytes().chain(part.bytes());
        if whole.is_empty() || !all.clone().all(|b| b.is_ascii_digit()) || digits.ends_with('.') {
            return Err(format!("`{}` is not a decimal number", crate::bank::node::shorten(text)));
        }
        let decimals = u8::try_from(part.len()).ok().filter(|d| *d <= MAX_DECIMALS);
        let (Some(decimals), true) = (decimals, whole.len() + part.len() <= MAX_DIGITS) else {
            return Err(format!(
                "`{}` has too many digits: {} in all and {} after the point, where at most {MAX_DIGITS} and {MAX_DECIMALS} are read",
                crate::bank::node::shorten(text),
                whole.len() + part.len(),
                part.len()
            ));
        };
        let value = all.fold(0i64, |v, b| v * 10 + i64::from(b - b'0'));
        Ok(Self { value: if negative { -value } else { value }, decimals })
    }
    /// The same number with more decimals.
    fn widened(self, decimals: u8) -> Option<i64> {
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
        self.value as f64 / TENS[usize::from(self.decimals.min(MAX_DECIMALS))]
    }
    /// As it is printed: `-0.30`.
    pub fn text(self) -> String {
        let digits = self.value.unsigned_abs().to_string();
        let sign = if self.value < 0 { "-" } else { "" };
        let decimals = usize::from(self.decimals);
        if decimals == 0 {
            return format!("{sign}{digits}");
        }
        let digits = format!("{digits:0>width$}", width = decimals + 1);
        let (whole, part) = digits.split_at(digits.len() - decimals);
        format!("{sign}{whole}.{part}")
    }
}

/// The forms of a draw, for hints.
pub const FORMS: &str = "write `25 to 50 step 1`, `one of 10, 20, 45` or `always 30`";

/// Reads a draw, or says what is wrong and what would be right.
pub fn draw(text: &str) -> Result<Draw, (String, String)> {
    let text = text.trim();
    if let Some(rest) = word(text, "always") {
        let d = number(rest)?;
        return Ok(Draw::Always { value: d.value, decimals: d.decimals });
    }
    if let Some(rest) = word(text, "one of") {
        let list = rest.split(',').map(|t| number(t.trim())).collect::<Result<Vec<_>, _>>()?;
        let decimals = list.iter().map(|d| d.decimals).max().unwrap_or(0);
        let values =
            list.iter().map(|d| d.widened(decimals)).collect::<Option<Vec<_>>>().ok_or_else(too_long)?;
        if let Some((i, v)) = values.iter().enumerate().find(|(i, v)| values[..*i].contains(v)) {
            let shown = Decimal { value: *v, decimals }.text();
            return Err((
                format!("{shown} stands twice (again as number {})", i + 1),
                "list each value once".into(),
            ));
        }
        return Ok(Draw::OneOf { values, decimals });
    }
    let Some((low, rest)) = text.split_once(" to ") else {
        return Err((format!("`{}` is no draw", crate::bank::node::shorten(text)), FORMS.to_owned()));
    };
    let Some((high, step)) = rest.split_once(" step ") else {
        return Err((
            format!("`{}` has no step", crate::bank::node::shorten(text)),
            format!("write `{} to {} step ...`: values are drawn on a grid", low.trim(), rest.trim()),
        ));
    };
    let (low, high, step) = (number(low.trim())?, number(high.trim())?, number(step.trim())?);
    let decimals = low.decimals.max(high.decimals).max(step.decimals);
    let all = |d: Decimal| d.widened(decimals).ok_or_else(too_long);
    let (min, max, size) = (all(low)?, all(high)?, all(step)?);
    if size <= 0 {
        return Err((
            format!("the step {} is not above 0", step.text()),
            "a step is a positive number".into(),
        ));
    }
    if min > max {
        return Err((
            format!("{} is above {}", low.text(), high.text()),
            format!("write `{} to {} step {}`", high.text(), low.text(), step.text()),
        ));
    }
    let left = (max - min) % size;
    if left != 0 {
        let last = Decimal { value: max - left, decimals }.text();
        return Err((
            format!("the step {} does not lead from {} to {}", step.text(), low.text(), high.text()),
            format!("the last value would be {last}: write `{} to {last} step {}`", low.text(), step.text()),
        ));
    }
    Ok(Draw::Grid { min, max, step: size, decimals })
}

fn too_long() -> (String, String) {
    (
        "these numbers have too many digits".to_owned(),
        format!("at most {MAX_DIGITS} digits in all, counted to the last decimal"),
    )
}

fn word<'t>(text: &'t str, start: &str) -> Option<&'t str> {
    text.strip_prefix(start).filter(|rest| rest.starts_with(' ')).map(str::trim)
}

fn number(text: &str) -> Result<Decimal, (String, String)> {
    Decimal::read(text).map_err(|why| {
        let hint = match why.contains("too many") {
            true => "round it: the printed number is the number used",
            false => "write digits with a point, such as 0.30, without a unit",
        };
        (why, hint.to_owned())
    })
}

impl Draw {
    /// Decimals of the printed value.
    pub const fn decimals(&self) -> u8 {
        match self {
            Self::Grid { decimals, .. } | Self::OneOf { decimals, .. } | Self::Always { decimals, .. } => {
                *decimals
            }
        }
    }
    /// How many values it can give.
    pub fn count(&self) -> u64 {
        match self {
            Self::Grid { min, max, step, .. } => ((max - min) / step).unsigned_abs() + 1,
            Self::OneOf { values, .. } => values.len() as u64,
            Self::Always { .. } => 1,
        }
    }
    /// Least and greatest value.
    pub fn range(&self) -> (Decimal, Decimal) {
        let (low, high) = match self {
            Self::Grid { min, max, .. } => (*min, *max),
            Self::OneOf { values, .. } => {
                (values.iter().copied().min().unwrap_or(0), values.iter().copied().max().unwrap_or(0))
            }
            Self::Always { value, .. } => (*value, *value),
        };
        let decimals = self.decimals();
        (Decimal { value: low, decimals }, Decimal { value: high, decimals })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms() {
        assert_eq!(draw("0.30 to 0.5 step 0.01"), Ok(Draw::Grid { min: 30, max: 50, step: 1, decimals: 2 }));
        assert_eq!(draw("one of 10, 20.5"), Ok(Draw::OneOf { values: vec![100, 205], decimals: 1 }));
        assert_eq!(draw("always -3"), Ok(Draw::Always { value: -3, decimals: 0 }));
        for bad in [
            "",
            "30",
            "1 to 2",
            "2 to 1 step 1",
            "1 to 2 step 0",
            "1 to 2 step 0.3",
            "1 to 1e3 step 1",
            "one of",
            "one of 1, 1.0",
            "always",
            "1 to 2 step 0.0000000000001",
            "99999999999999 to 99999999999999 step 0.001",
        ] {
            assert!(draw(bad).is_err(), "{bad}");
        }
    }

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
