//! Dates as spreadsheets and form services write them, to seconds that can be compared.

/// Microseconds since 1970 (UTC; a time without zone is taken as UTC). Reads ISO 8601 with or without zone,
/// `2026-03-01 14:05[:30]`, `01.03.2026 14:05`, and `3/25/2026 2:05:30 PM` or `25/3/2026 14:05` where the order of day and
/// month cannot be mistaken. `None` if it cannot be read with certainty.
pub fn parse(text: &str) -> Option<i64> {
    let text = text.trim();
    if text.len() > 40 || !text.is_ascii() {
        return None;
    }
    let cut = text.find(['T', 't', ' ']).unwrap_or(text.len());
    let (date, rest) = (&text[..cut], text[cut..].trim_start_matches(['T', 't', ' ', ',']));
    let date = date.trim_end_matches(',');
    let numbers = |separator: char| -> Option<[i64; 3]> {
        let mut parts = date.split(separator).map(|p| {
            if (1..=4).contains(&p.len()) && p.bytes().all(|b| b.is_ascii_digit()) {
                p.parse::<i64>().ok()
            } else {
                None
            }
        });
        let all = [parts.next()??, parts.next()??, parts.next()??];
        parts.next().is_none().then_some(all)
    };
    let (year, month, day) = if date.contains('-') {
        let [y, m, d] = numbers('-')?;
        if y >= 1000 { (y, m, d) } else { return None }
    } else if date.contains('.') {
        let [d, m, y] = numbers('.')?;
        (y, m, d)
    } else if date.contains('/') {
        let [a, b, c] = numbers('/')?;
        if a >= 1000 {
            (a, b, c)
        } else if a > 12 || a == b {
            (c, b, a)
        } else if b > 12 {
            (c, a, b)
        } else {
            return None; // 3/4/2026 may be March or April
        }
    } else {
        return None;
    };
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let length = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if !(1000..=9999).contains(&year) || !(1..=length).contains(&day) {
        return None;
    }
    Some((days(year, month, day) * 86_400_000_000).wrapping_add(clock(rest)?))
}

/// Days since 1970-01-01 in the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let y = if month <= 2 { year - 1 } else { year };
    let m = (month + 9) % 12;
    365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 719_468
}

/// `14:05:30.25+02:00`, `2:05 PM`, empty for midnight: microseconds.
fn clock(text: &str) -> Option<i64> {
    if text.is_empty() {
        return Some(0);
    }
    let end =
        text.find(|c: char| !(c.is_ascii_digit() || c == ':' || c == '.' || c == ',')).unwrap_or(text.len());
    let zone = text[end..].trim();
    let body = text[..end].replace(',', ".");
    let mut parts = body.split(':');
    let whole =
        |p: Option<&str>| p.filter(|p| (1..=2).contains(&p.len())).and_then(|p| p.parse::<i64>().ok());
    let mut hour = whole(parts.next())?;
    let minute = whole(parts.next())?;
    let mut micros = 0i64;
    if let Some(seconds) = parts.next() {
        let (second, fraction) = seconds.split_once('.').unwrap_or((seconds, ""));
        let second = whole(Some(second)).filter(|s| *s <= 60)?;
        let digits: String = fraction.chars().chain("000000".chars()).take(6).collect();
        micros = second * 1_000_000 + digits.parse::<i64>().ok()?;
    }
    if parts.next().is_some() || minute > 59 || hour > 24 {
        return None;
    }
    let mut offset = 0i64;
    match zone.to_ascii_uppercase().as_str() {
        "" | "Z" | "UTC" | "GMT" => {}
        "AM" if (1..=12).contains(&hour) => hour %= 12,
        "PM" if (1..=12).contains(&hour) => hour = hour % 12 + 12,
        other => {
            let sign = if other.starts_with('-') { -1 } else { 1 };
            let digits: String = other.strip_prefix(['+', '-'])?.chars().filter(|c| *c != ':').collect();
            let (h, m) = match digits.len() {
                2 => (digits.parse::<i64>().ok()?, 0),
                4 => (digits[..2].parse::<i64>().ok()?, digits[2..].parse::<i64>().ok()?),
                _ => return None,
            };
            if h > 18 || m > 59 {
                return None;
            }
            offset = sign * (h * 60 + m);
        }
    }
    Some((hour * 60 + minute - offset) * 60_000_000 + micros)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_same_moment_in_many_spellings() {
        let want = parse("2026-03-25T14:05:30Z");
        assert_eq!(want, Some(1_774_447_530_000_000));
        for text in [
            "2026-03-25 14:05:30",
            "2026-03-25T16:05:30+02:00",
            "25.03.2026 14:05:30",
            "3/25/2026 2:05:30 PM",
            "25/3/2026 14:05:30",
            "2026/03/25 14:05:30",
            "2026-03-25T14:05:30.000",
            "2026-03-25T0905:30".replace("0905", "09:05").as_str(),
        ] {
            let text = text.replace("T09:05:30", "T09:05:30-0500");
            assert_eq!(parse(&text), want, "{text}");
        }
        for odd in ["3/4/2026 10:00", "yesterday", "2026-02-30", "2026-03-25 25:00", "14:05", ""] {
            assert_eq!(parse(odd), None, "{odd}");
        }
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,45}", near in "[0-9TZ:/. +-]{0,30}") {
            let _ = (parse(&text), parse(&near));
        }
    }
}
