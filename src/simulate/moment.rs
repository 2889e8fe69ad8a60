//! Minutes of a calendar, for the times at which a made-up class hands in.

/// Days of the proleptic Gregorian calendar since 1970-01-01. Source: H. Hinnant, "chrono-Compatible Low-Level Date
/// Algorithms", days_from_civil.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year.rem_euclid(400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

/// Year, month, day of a day since 1970-01-01; the same source, civil_from_days.
fn civil(days: i64) -> (i64, i64, i64) {
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let of_era = z.rem_euclid(146_097);
    let of_400 = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * of_400 + of_400 / 4 - of_400 / 100);
    let m = (5 * of_year + 2) / 153;
    let month = if m < 10 { m + 3 } else { m - 9 };
    (of_400 + era * 400 + i64::from(month <= 2), month, of_year - (153 * m + 2) / 5 + 1)
}

/// Reads `2026-03-06 18:00` (or with `T`): minutes since 1970 in the same zone. `None` for anything else, such as the 30th
/// of February.
pub fn minute(text: &str) -> Option<i64> {
    let (date, time) = text.trim().split_once([' ', 'T'])?;
    let number = |t: &str, digits: usize| match t.len() == digits && t.bytes().all(|b| b.is_ascii_digit()) {
        true => t.parse::<i64>().ok(),
        false => None,
    };
    let mut parts = date.split('-');
    let (year, month, day) =
        (number(parts.next()?, 4)?, number(parts.next()?, 2)?, number(parts.next()?, 2)?);
    let (hour, minute) = time.trim().split_once(':')?;
    let (hour, minute) = (number(hour, 2)?, number(minute, 2)?);
    let whole = parts.next().is_none() && (0..24).contains(&hour) && (0..60).contains(&minute);
    let days = days(year, month, day);
    (whole && civil(days) == (year, month, day)).then_some((days * 24 + hour) * 60 + minute)
}

/// `2026-03-06 18:00` of minutes since 1970.
pub fn text(minute: i64) -> String {
    let (year, month, day) = civil(minute.div_euclid(1440));
    let of_day = minute.rem_euclid(1440);
    format!("{year:04}-{month:02}-{day:02} {:02}:{:02}", of_day / 60, of_day % 60)
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
