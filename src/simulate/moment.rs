//! Minutes of a calendar, for the times at which a made-up class hands in.
use jiff::SignedDuration;
use jiff::civil::{DateTime, datetime};

const EPOCH: DateTime = datetime(1970, 1, 1, 0, 0, 0, 0);
const WRITTEN: &str = "%Y-%m-%d %H:%M";

/// Reads `2026-03-06 18:00` (or with `T`): minutes since 1970 in the same zone. `None` for anything else, such as the 30th
/// of February.
pub fn minute(text: &str) -> Option<i64> {
    let text = text.trim().replacen('T', " ", 1);
    let at = DateTime::strptime(WRITTEN, &text).ok()?;
    let minute = at.duration_since(EPOCH).as_mins();
    // What is read leniently, such as `2026-3-6`, is not written so.
    (self::text(minute) == text).then_some(minute)
}

/// `2026-03-06 18:00` of minutes since 1970.
pub fn text(minute: i64) -> String {
    EPOCH.saturating_add(SignedDuration::from_mins(minute)).strftime(WRITTEN).to_string()
}

/// Reads `90 min`, `36 h`, `2 d`: minutes.
pub fn span(text: &str) -> Option<i64> {
    let text = text.trim();
    let cut = text.find(|c: char| !c.is_ascii_digit())?;
    let each = match text[cut..].trim() {
        "min" => 1,
        "h" => 60,
        "d" => 1440,
        _ => return None,
    };
    text[..cut].parse::<i64>().ok().filter(|n| *n < 100_000).map(|n| n * each)
}

/// `Z`, or an offset such as `+01:00`.
pub fn is_zone(text: &str) -> bool {
    let offset = || {
        let (hour, minute) = text.strip_prefix(['+', '-'])?.split_once(':')?;
        let two = |t: &str| t.len() == 2 && t.bytes().all(|b| b.is_ascii_digit());
        (two(hour) && two(minute) && hour < "15" && minute < "60").then_some(())
    };
    text == "Z" || offset().is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minutes_are_read_and_written() {
        assert_eq!(minute("1970-01-01 00:00"), Some(0));
        assert_eq!(minute("2000-03-01T12:30"), Some(11_017 * 1440 + 750));
        for t in ["2026-03-06 18:00", "2024-02-29 23:59", "1969-12-31 00:01", "2100-03-01 00:00"] {
            assert_eq!(minute(t).map(text).as_deref(), Some(t));
        }
        for t in
            ["2026-02-29 10:00", "2026-13-01 10:00", "2026-3-6 18:00", "2026-03-06", "6.3.2026 18:00", ""]
        {
            assert_eq!(minute(t), None, "{t}");
        }
        for day in (-200_000..200_000).step_by(17) {
            assert_eq!(minute(&text(day * 1440)).unwrap_or(day * 1440), day * 1440);
        }
    }

    #[test]
    fn spans_and_zones() {
        assert_eq!(
            (span("36 h"), span("2d"), span("90min"), span("2 w")),
            (Some(2160), Some(2880), Some(90), None)
        );
        assert!(is_zone("+01:00") && is_zone("-09:30") && is_zone("Z"));
        assert!(!is_zone("CET") && !is_zone("+1:00") && !is_zone("01:00"));
    }
}
