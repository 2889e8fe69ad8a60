//! How a bank writes the draw of a datum: `25 to 50 step 1`, `one of 10, 20, 45`, `always 30`.
use crate::bank::Draw;
use crate::bank::decimal::{Decimal, MAX_DIGITS};
use crate::bank::node::shorten;

/// The forms of a draw, for hints.
pub const FORMS: &str = "write `25 to 50 step 1`, `one of 10, 20, 45` or `always 30`";

/// Reads a draw, or says what is wrong and what would be right.
pub fn parse(text: &str) -> Result<Draw, (String, String)> {
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
        return Err((format!("`{}` is no draw", shorten(text)), FORMS.to_owned()));
    };
    let Some((high, step)) = rest.split_once(" step ") else {
        return Err((
            format!("`{}` has no step", shorten(text)),
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
            true => "round it: the printed number is the number used".to_owned(),
            false => "write digits with a point, such as 0.30, without a unit".to_owned(),
        };
        (why, hint)
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
        assert_eq!(parse("0.30 to 0.5 step 0.01"), Ok(Draw::Grid { min: 30, max: 50, step: 1, decimals: 2 }));
        assert_eq!(parse("one of 10, 20.5"), Ok(Draw::OneOf { values: vec![100, 205], decimals: 1 }));
        assert_eq!(parse("always -3"), Ok(Draw::Always { value: -3, decimals: 0 }));
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
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}
