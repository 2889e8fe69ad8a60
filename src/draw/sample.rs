//! Ranges and choices to values on decimal grids: integers only, no float in the draw.
use crate::bank::decimal::Decimal;
use crate::bank::{Case, Draw};
use crate::draw::stream::DrawWords;

/// The case of a variant, by share, as an index into `cases` (0 if there are none).
pub fn case(words: &mut DrawWords, cases: &[Case]) -> usize {
    if cases.len() <= 1 {
        return 0;
    }
    words.attempt(1);
    let total: u64 = cases.iter().map(|c| u64::from(c.share)).sum();
    let mut lot = words.below(0, total);
    for (i, case) in cases.iter().enumerate() {
        let share = u64::from(case.share);
        if lot < share {
            return i;
        }
        lot -= share;
    }
    cases.len().saturating_sub(1)
}

/// The value of datum number `index` in this try.
pub fn value(words: &mut DrawWords, index: usize, draw: &Draw) -> Decimal {
    let value = match draw {
        Draw::Always { value, .. } => *value,
        Draw::OneOf { values, .. } => {
            let lot = words.below(index + 1, values.len() as u64);
            usize::try_from(lot).ok().and_then(|i| values.get(i)).copied().unwrap_or(0)
        }
        Draw::Grid { min, step, .. } => {
            let lot = words.below(index + 1, draw.count());
            min + step * i64::try_from(lot).unwrap_or(0)
        }
    };
    Decimal { value, decimals: draw.decimals() }
}
