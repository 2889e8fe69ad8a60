//! Dates as spreadsheets and form services write them, to seconds that can be compared.

/// Whether a column writes the day or the month first, as far as its dates with slashes or points prove it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Evidence {
    /// A date such as 25/3/2026 was seen.
    pub day_first: bool,
    /// A date such as 3/25/2026 was seen.
    pub month_first: bool,
}

impl Evidence {
    /// Adds what another part of the column proves.
    pub fn join(&mut self, other: Evidence) {
        self.day_first |= other.day_first;
        self.month_first |= other.month_first;
    }
    /// Of the two moments of an uncertain date, which one counts: 1 where the month comes first, else 0.
    pub fn choice(self) -> usize {
        usize::from(self.month_first && !self.day_first)
    }
    /// Does the column decide the order of an uncertain date? Points stand after the day unless a date denies it.
    pub fn decides(self, dotted: bool) -> bool {
        match (self.day_first, self.month_first) {
            (true, true) => false,
            (false, false) => dotted,
            _ => true,
        }
    }
}

/// A moment, or two of which the column must choose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Moment {
    /// Microseconds since 1970 (UTC; a time without zone is taken as UTC): day first, then month first.
    pub micros: [i64; 2],
    /// Is a zone written?
    pub zoned: bool,
    /// The order of day and month is uncertain, and whether points stand between them.
    pub uncertain: Option<bool>,
    /// What the date proves for others.
    pub evidence: Evidence,
}

/// Reads ISO 8601 with or without zone, `2026-03-01 14:05[:30]`, `2026/03/01 2:05:30 PM GMT+1`, `01.03.2026 14:05`,
/// `3/25/2026 2:05:30 PM`, `25/3/2026 14:05`. `None` if it cannot be read. `3/4/2026` is two moments: March and April.
pub fn parse(text: &str) -> Option<Moment> {
    let spaced: String;
    let mut text = text.trim();
    if text.len() > 48 {
        return None;
    }
    if !text.is_ascii() {
        // a narrow blank stands before AM and PM in newer exports
        spaced = text.replace(char::is_whitespace, " ");
        text = spaced.as_str();
        if !text.is_ascii() {
            return None;
        }
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
    let (clock, zoned) = clock(rest)?;
    let moment = |y, m, d| midnight(y, m, d).map(|at| at.wrapping_add(clock));
    let separator = ['-', '.', '/'].into_iter().find(|s| date.contains(*s))?;
    let [a, b, c] = numbers(separator)?;
    if a >= 1000 {
        let at = moment(a, b, c)?;
        return Some(Moment { micros: [at; 2], zoned, uncertain: None, evidence: Evidence::default() });
    }
    if separator == '-' {
        return None;
    }
    let (day_first, month_first) = (moment(c, b, a), moment(c, a, b));
    let evidence = Evidence { day_first: a > 12 && b <= 12, month_first: b > 12 && a <= 12 };
    match (day_first, month_first) {
        (Some(x), Some(y)) => {
            Some(Moment { micros: [x, y], zoned, uncertain: (x != y).then_some(separator == '.'), evidence })
        }
        (Some(x), None) | (None, Some(x)) => {
            Some(Moment { micros: [x; 2], zoned, uncertain: None, evidence })
        }
        (None, None) => None,
    }
}

/// Microseconds from 1970 to the beginning of a day that exists.
fn midnight(year: i64, month: i64, day: i64) -> Option<i64> {
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
    Some(days(year, month, day) * 86_400_000_000)
}

/// Days since 1970-01-01 in the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let y = if month <= 2 { year - 1 } else { year };
    let m = (month + 9) % 12;
    365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 719_468
}

/// `14:05:30.25+02:00`, `2:05 PM`, empty for midnight: microseconds, and whether a zone is written.
fn clock(text: &str) -> Option<(i64, bool)> {
    if text.is_empty() {
        return Some((0, false));
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
    let zone = zone.to_ascii_uppercase();
    let mut zone = zone.as_str();
    for (half, add) in [("AM", 0), ("PM", 12)] {
        if let Some(after) = zone.strip_prefix(half) {
            if !(1..=12).contains(&hour) {
                return None;
            }
            hour = hour % 12 + add;
            zone = after.trim_start();
            break;
        }
    }
    let zoned = !zone.is_empty();
    for name in ["GMT", "UTC", "Z"] {
        if let Some(after) = zone.strip_prefix(name) {
            zone = after.trim_start();
            break;
        }
    }
    let mut offset = 0i64;
    if !zone.is_empty() {
        let sign = if zone.starts_with('-') { -1 } else { 1 };
        let number = zone.strip_prefix(['+', '-'])?;
        let (h, m) = match number.split_once(':') {
            Some(both) => both,
            None if number.len() == 4 => number.split_at_checked(2)?,
            None => (number, ""),
        };
        let digits =
            |t: &str| (t.len() <= 2 && t.bytes().all(|b| b.is_ascii_digit())).then(|| t.parse::<i64>().ok());
        let (h, m) = (digits(h)??, if m.is_empty() { 0 } else { digits(m)?? });
        if h > 18 || m > 59 {
            return None;
        }
        offset = sign * (h * 60 + m);
    }
    Some(((hour * 60 + minute - offset) * 60_000_000 + micros, zoned))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_same_moment_in_many_spellings() {
        let want = [1_774_447_530_000_000; 2];
        for text in [
            "2026-03-25T14:05:30Z",
            "2026-03-25 14:05:30",
            "2026-03-25T16:05:30+02:00",
            "25.03.2026 14:05:30",
            "3/25/2026 2:05:30 PM",
            "3/25/2026, 2:05:30\u{202f}PM",
            "25/3/2026 14:05:30",
            "2026/03/25 14:05:30",
            "2026/03/25 3:05:30 PM GMT+1",
            "2026/03/25 7:35:30 PM GMT+5:30",
            "2026/03/25 9:05:30 AM UTC-5",
            "2026-03-25T14:05:30.000",
            "2026-03-25T09:05:30-0500",
        ] {
            assert_eq!(parse(text).map(|m| (m.micros, m.uncertain)), Some((want, None)), "{text}");
        }
        for odd in
            ["13/13/2026 10:00", "yesterday", "2026-02-30", "2026-03-25 25:00", "14:05", "", "03-04-2026"]
        {
            assert_eq!(parse(odd), None, "{odd}");
        }
    }

    #[test]
    fn the_column_decides_the_order_of_day_and_month() {
        let day = parse("25/3/2026").unwrap().evidence;
        let month = parse("3/25/2026").unwrap().evidence;
        let uncertain = parse("3/4/2026").unwrap();
        assert_eq!((uncertain.uncertain, uncertain.evidence), (Some(false), Evidence::default()));
        assert_eq!(Some(uncertain.micros[day.choice()]), parse("2026-04-03").map(|m| m.micros[0]));
        assert_eq!(Some(uncertain.micros[month.choice()]), parse("2026-03-04").map(|m| m.micros[0]));
        let mut both = day;
        both.join(month);
        let none = Evidence::default();
        assert_eq!([day, month, both, none].map(|e| e.decides(false)), [true, true, false, false]);
        assert_eq!([day, month, both, none].map(|e| e.decides(true)), [true, true, false, true]);
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,45}", near in "[0-9TZ:/. +-]{0,30}") {
            let _ = (parse(&text), parse(&near));
        }
    }
}
