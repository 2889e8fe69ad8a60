//! Dates as spreadsheets and form services write them, to seconds that can be compared.
use crate::policy::{DAY, MINUTE};
use jiff::civil::{Date, date};

const EPOCH: Date = date(1970, 1, 1);

/// Whether a column writes the day or the month first, as far as its dates with slashes or dashes prove it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Evidence {
    /// A date such as 25/3/2026 was seen.
    pub day_first: bool,
    /// A date such as 3/25/2026 was seen.
    pub month_first: bool,
}

impl Evidence {
    /// What a course says of the order.
    pub fn said(day_first: bool) -> Evidence {
        Evidence { day_first, month_first: !day_first }
    }
    /// Adds what another part of the column proves.
    pub fn join(&mut self, other: Evidence) {
        self.day_first |= other.day_first;
        self.month_first |= other.month_first;
    }
    /// Of the two moments of an uncertain date, which one counts: 1 where the month comes first, else 0.
    pub fn choice(self) -> usize {
        usize::from(self.month_first && !self.day_first)
    }
    /// Does the column decide the order of an uncertain date?
    pub fn decides(self) -> bool {
        self.day_first != self.month_first
    }
}

/// A moment, or two of which the column must choose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Moment {
    /// Microseconds since 1970 (UTC; a time without zone is taken as UTC): day first, then month first.
    pub micros: [i64; 2],
    /// Is a zone written?
    pub zoned: bool,
    /// No time of day is written: it is read as midnight.
    pub whole_day: bool,
    /// The day of the week that is written is not that of the date.
    pub clashes: bool,
    /// The zone is written as a word, and only a place knows what it means (`CST`, `BST`), or knows better.
    pub word: Option<ZoneWord>,
    /// The order of day and month is uncertain.
    pub uncertain: bool,
    /// What the date proves for others.
    pub evidence: Evidence,
}

impl Moment {
    /// This time of the first day on the day that begins at `midnight`.
    fn on(self, midnight: i64) -> Moment {
        Moment { micros: self.micros.map(|time| midnight.wrapping_add(time)), ..self }
    }
}

/// Why a time tells less than it seems to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doubt {
    /// A date without a time of day.
    WholeDay,
    /// The day of the week is not that of the date.
    Weekday,
    /// A word that means several zones.
    Zone(ZoneWord),
}

impl std::fmt::Display for Doubt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Doubt::WholeDay => f.write_str("no time of day"),
            Doubt::Weekday => f.write_str("the day of the week does not fit the date"),
            Doubt::Zone(word) => write!(f, "{} means several zones", word.name()),
        }
    }
}

/// A zone as a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ZoneWord {
    /// In capitals, filled up with blanks.
    name: [u8; 5],
    /// What it adds to UTC nearly everywhere, microseconds; it is taken from the moment already. `None`: it means several things.
    pub offset: Option<i64>,
}

impl ZoneWord {
    /// In capitals.
    pub fn name(&self) -> &str {
        std::str::from_utf8(&self.name).unwrap_or_default().trim_end()
    }
}

/// Words for zones that mean one thing to nearly everybody, in minutes from UTC. Those that do not (CST, IST, BST, AST, ...)
/// are understood where the zone of the course uses them.
#[rustfmt::skip] // a table
const ZONES: [(&str, i64); 29] = [
    ("CET", 60), ("CEST", 120), ("MEZ", 60), ("MESZ", 120), ("WET", 0), ("WEST", 60), ("EET", 120),
    ("EEST", 180), ("MSK", 180), ("EST", -300), ("EDT", -240), ("CDT", -300), ("MST", -420), ("MDT", -360),
    ("PST", -480), ("PDT", -420), ("AKST", -540), ("AKDT", -480), ("HST", -600), ("JST", 540), ("KST", 540),
    ("HKT", 480), ("SGT", 480), ("AEST", 600), ("AEDT", 660), ("NZST", 720), ("NZDT", 780), ("SAST", 120),
    ("BRT", -180),
];

/// Reads ISO 8601 with or without zone, `2026-03-01 14:05[:30]`, `2026/03/01 2:05:30 PM GMT+1`, `01.03.2026 14:05`,
/// `3/25/2026 2:05:30 PM`, `25/3/26 14:05`, `3-25-2026 14:05`, `20260325T140530Z`, `2026-03-25 14h05`, `Sunday, 29 March 2026, 3:30 PM`,
/// `29. März 2026 15:30 MESZ`, the serial number of a spreadsheet (days since 1899-12-30), and seconds or milliseconds since 1970.
/// `None` if it cannot be read. `3/4/2026` is two moments: March and April.
pub fn parse(text: &str) -> Option<Moment> {
    let text = text.trim();
    if text.len() > 80 {
        return None;
    }
    if text.is_ascii() {
        return read(text);
    }
    // A narrow blank stands before AM and PM in newer exports; some write marks for the direction of the text.
    let invisible =
        |c: char| matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    // Digits of Arabic, Persian and full width.
    let latin = |c: char| match u32::from(c) {
        n @ 0x660..=0x669 => char::from_digit(n - 0x660, 10).unwrap_or(c),
        n @ 0x6f0..=0x6f9 => char::from_digit(n - 0x6f0, 10).unwrap_or(c),
        n @ 0xff01..=0xff5e => char::from_u32(n - 0xfee0).unwrap_or(c),
        _ if c.is_whitespace() => ' ',
        _ => c,
    };
    let spaced: String = text.chars().filter(|c| !invisible(*c)).map(latin).collect();
    read(spaced.trim())
}

/// Reads a text whose digits and blanks are ASCII.
fn read(text: &str) -> Option<Moment> {
    let hours = with_colons(text);
    let text = hours.as_deref().unwrap_or(text);
    let extended = extended(text);
    let text = extended.as_deref().unwrap_or(text);
    dated(text).or_else(|| counted(text)).or_else(|| worded(text))
}

/// `15h30` as `15:30`, `15h` as `15:00`; `None` where no hour is written so.
fn with_colons(text: &str) -> Option<String> {
    let at = text.char_indices().find_map(|(at, c)| {
        let digit = |b: Option<&u8>| b.is_some_and(u8::is_ascii_digit);
        let before = at.checked_sub(1).and_then(|i| text.as_bytes().get(i));
        (matches!(c, 'h' | 'H') && digit(before)).then_some(at)
    })?;
    let (hour, behind) = (&text[..at], &text[at + 1..]);
    let digits = behind.bytes().take_while(u8::is_ascii_digit).count();
    match digits {
        2 => Some(format!("{hour}:{behind}")),
        0 if !behind.starts_with(|c: char| c.is_alphanumeric()) => Some(format!("{hour}:00{behind}")),
        _ => None,
    }
}

/// `20260329T153000Z` as `2026-03-29 15:30:00Z`; `None` where the date is not eight digits.
fn extended(text: &str) -> Option<String> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    if digits(text) != 8 {
        return None;
    }
    let (date, rest) = text.split_at(8);
    let clock = rest.trim_start_matches(['T', 't', ' ']);
    if clock.len() == rest.len() && !rest.is_empty() {
        return None;
    }
    let clock = match digits(clock) {
        4 => format!("{}:{}", &clock[..2], &clock[2..]),
        6 => format!("{}:{}:{}", &clock[..2], &clock[2..4], &clock[4..]),
        _ => clock.to_owned(),
    };
    Some(format!("{}-{}-{} {clock}", &date[..4], &date[4..6], &date[6..]).trim_end().to_owned())
}

/// One moment without doubt.
fn certain(at: i64, zoned: bool, word: Option<ZoneWord>) -> Moment {
    Moment { micros: [at; 2], zoned, word, ..Moment::default() }
}

/// A date in numbers, with or without the time of day.
fn dated(text: &str) -> Option<Moment> {
    let cut = text.find(['T', 't', ' ']).unwrap_or(text.len());
    let (date, rest) = (&text[..cut], text[cut..].trim_start_matches(['T', 't', ' ', ',']));
    let date = date.trim_end_matches(',');
    let separator = ['-', '.', '/'].into_iter().find(|s| date.contains(*s))?;
    let mut parts = date.split(separator).map(|p| {
        let digits = (1..=4).contains(&p.len()) && p.bytes().all(|b| b.is_ascii_digit());
        if digits { p.parse::<i64>().ok().map(|n| (n, p.len())) } else { None }
    });
    let [(a, _), (b, _), (c, length)] = [parts.next()??, parts.next()??, parts.next()??];
    if parts.next().is_some() {
        return None;
    }
    let clock = clock(rest)?;
    let moment = |y, m, d| Some(clock.on(midnight(y, m, d)?));
    let whole_day = rest.is_empty();
    if a >= 1000 {
        return Some(Moment { whole_day, ..moment(a, b, c)? });
    }
    // Of 26-03-29 nobody knows which is the year.
    if separator == '-' && length != 4 {
        return None;
    }
    let year = if length == 2 { full_year(c) } else { c };
    let (day_first, month_first) = (moment(year, b, a), moment(year, a, b));
    let tells = |first, second| separator != '.' && first > 12 && second <= 12;
    let evidence = Evidence { day_first: tells(a, b), month_first: tells(b, a) };
    let [x, y] = [day_first.or(month_first)?, month_first.or(day_first)?].map(|one| one.micros[0]);
    // A date with points has the day first, whatever others have, and tells nothing of them.
    let [x, y] = if separator == '.' { [x, x] } else { [x, y] };
    Some(Moment { micros: [x, y], uncertain: x != y, evidence, whole_day, ..clock })
}

/// A year of two digits: 1970 to 2069.
fn full_year(year: i64) -> i64 {
    if year < 70 { 2000 + year } else { 1900 + year }
}

/// A number alone: days as spreadsheets count them, seconds or milliseconds since 1970; between 2000 and 2100 they are apart.
fn counted(text: &str) -> Option<Moment> {
    let (whole, fraction) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let digits = |t: &str| t.len() <= 15 && t.bytes().all(|b| b.is_ascii_digit());
    if whole.is_empty() || !digits(whole) || !digits(fraction) {
        return None;
    }
    let count: i64 = whole.parse().ok()?;
    let part: f64 = if fraction.is_empty() { 0.0 } else { format!("0.{fraction}").parse().ok()? };
    match (whole.len(), count) {
        // A spreadsheet counts from 1899-12-30, in the zone of who wrote it; its days are exact to a second.
        (5, 36_526..73_051) => {
            let seconds = (part * 86_400.0).round() as i64;
            let whole_day = fraction.bytes().all(|b| b == b'0');
            let at = (count - 25_569) * 86_400_000_000 + seconds * 1_000_000;
            Some(Moment { whole_day, ..certain(at, false, None) })
        }
        (9 | 10, 946_684_800..4_102_444_800) => {
            Some(certain(count * 1_000_000 + (part * 1e6).round() as i64, true, None))
        }
        (12 | 13, 946_684_800_000..4_102_444_800_000) => Some(certain(count * 1_000, true, None)),
        _ => None,
    }
}

/// The number of a month by its English or German name, whole or cut to three letters (`Sept` to four).
fn month(word: &str) -> Option<i64> {
    const MONTHS: [&[&str]; 12] = [
        &["january", "januar", "jänner"],
        &["february", "februar"],
        &["march", "märz", "maerz", "mrz"],
        &["april"],
        &["may", "mai"],
        &["june", "juni"],
        &["july", "juli"],
        &["august"],
        &["september", "sept"],
        &["october", "oktober"],
        &["november"],
        &["december", "dezember"],
    ];
    let is = |name: &&str| *name == word || (word.chars().count() == 3 && name.starts_with(word));
    (1..).zip(MONTHS).find(|(_, names)| names.iter().any(is)).map(|(number, _)| number)
}

/// A date with the month as a word: `Monday, 29 March 2026, 3:30 PM`, `March 29th, 2026 at 15:30`, `29-Mar-26 15:30`,
/// `Sun Mar 29 15:30:00 CEST 2026`.
fn worded(text: &str) -> Option<Moment> {
    const FILLERS: [&str; 9] = ["at", "um", "the", "of", "den", "der", "on", "am", "uhr"];
    let lower = text.to_lowercase();
    let mut words: Vec<&str> = lower.split([' ', ',']).filter(|w| !w.is_empty()).collect();
    let at = words.iter().position(|w| w.contains(':')).unwrap_or(words.len());
    let mut clock_words = words.split_off(at);
    let is_year = |w: &str| w.len() == 4 && w.bytes().all(|b| b.is_ascii_digit());
    // As the system clock writes it, with the year at the end.
    if clock_words.len() > 1 && clock_words.last().is_some_and(|w| is_year(w)) {
        words.extend(clock_words.pop());
    }
    // How many numbers stand before the month, and which it is; numbers with their digits.
    let mut month_at: Option<(usize, i64)> = None;
    let mut numbers: Vec<(i64, usize)> = Vec::new();
    let mut week: Vec<i64> = Vec::new();
    for word in words.iter().flat_map(|w| w.split(['-', '/', '.'])).filter(|w| !w.is_empty()) {
        let digits = word.bytes().take_while(u8::is_ascii_digit).count();
        if digits > 0 {
            if digits > 4 || !["", "st", "nd", "rd", "th"].contains(&&word[digits..]) {
                return None;
            }
            numbers.push((word[..digits].parse().ok()?, digits));
        } else if let Some(month) = month(word) {
            if month_at.replace((numbers.len(), month)).is_some() {
                return None;
            }
        } else if let Some(day) = weekday(word) {
            week.push(day);
        } else if !FILLERS.contains(&word) {
            return None;
        }
    }
    let ((before, month), [first, second]) = (month_at?, <[(i64, usize); 2]>::try_from(numbers).ok()?);
    let ((day, _), (year, length)) = match (before, first.1) {
        (0 | 1, 1 | 2) => (first, second),
        (1, 4) => (second, first), // 2026 March 29
        _ => return None,
    };
    let year = if length == 2 { full_year(year) } else { year };
    let clock = clock(&clock_words.join(" "))?;
    let at = midnight(year, month, day)?;
    // 1970 began on a Thursday.
    let clashes = week.iter().any(|d| *d != (at.div_euclid(DAY) + 3).rem_euclid(7));
    Some(Moment { whole_day: clock_words.is_empty(), clashes, ..clock.on(at) })
}

/// The day of the week by its English or German name, whole or cut; 0 is Monday.
fn weekday(word: &str) -> Option<i64> {
    const DAYS: [&[&str]; 7] = [
        &["mon", "monday", "mo", "montag"],
        &["tue", "tues", "tuesday", "di", "dienstag"],
        &["wed", "wednesday", "mi", "mittwoch"],
        &["thu", "thur", "thurs", "thursday", "do", "donnerstag"],
        &["fri", "friday", "fr", "freitag"],
        &["sat", "saturday", "sa", "samstag", "sonnabend"],
        &["sun", "sunday", "so", "sonntag"],
    ];
    (0..).zip(DAYS).find(|(_, names)| names.contains(&word)).map(|(day, _)| day)
}

/// Microseconds from 1970 to the beginning of a day that exists.
fn midnight(year: i64, month: i64, day: i64) -> Option<i64> {
    let date = Date::new(year.try_into().ok()?, month.try_into().ok()?, day.try_into().ok()?).ok()?;
    let days = date.duration_since(EPOCH).as_hours() / 24;
    (1000..=9999).contains(&year).then_some(days * DAY)
}

/// The time of day with its zone, as a moment of the first day: `14:05:30.25+02:00`, `2:05 PM`, `14:05 CEST`, empty for midnight.
fn clock(text: &str) -> Option<Moment> {
    if text.is_empty() {
        return Some(Moment::default());
    }
    let end =
        text.find(|c: char| !(c.is_ascii_digit() || c == ':' || c == '.' || c == ',')).unwrap_or(text.len());
    let zone = text[end..].trim();
    let body = text[..end].trim_end_matches(',').replace(',', ".");
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
    let mut zone = zone.strip_prefix("UHR").unwrap_or(&zone).trim_start();
    for (half, add) in [("AM", 0), ("A.M.", 0), ("PM", 12), ("P.M.", 12)] {
        if let Some(after) = zone.strip_prefix(half) {
            if !(1..=12).contains(&hour) {
                return None;
            }
            hour = hour % 12 + add;
            zone = after.trim_start();
            break;
        }
    }
    let shown = (hour * 60 + minute) * 60_000_000 + micros;
    // `GMT+0200 (Central European Summer Time)`, `(CEST)`
    if let Some((before, inside)) = zone.split_once('(') {
        let inside = inside.strip_suffix(')')?;
        zone = if before.trim().is_empty() { inside } else { before.trim() };
    }
    let zoned = !zone.is_empty();
    if (2..=5).contains(&zone.len())
        && zone.bytes().all(|b| b.is_ascii_uppercase())
        && !["GMT", "UTC"].contains(&zone)
    {
        let mut name = [b' '; 5];
        name[..zone.len()].copy_from_slice(zone.as_bytes());
        let offset = ZONES.iter().find(|(known, _)| *known == zone).map(|(_, minutes)| minutes * 60_000_000);
        let word = Some(ZoneWord { name, offset });
        return Some(certain(shown - offset.unwrap_or(0), zoned, word));
    }
    for name in ["GMT", "UTC", "Z"] {
        if let Some(after) = zone.strip_prefix(name) {
            zone = after.trim_start();
            break;
        }
    }
    let offset = if zone.is_empty() { 0 } else { offset(zone)? };
    Some(certain(shown - offset * MINUTE, zoned, None))
}

/// What an offset such as `+05:30`, `+0530` or `-3` adds to UTC, minutes.
pub fn offset(text: &str) -> Option<i64> {
    let sign = if text.starts_with('-') { -1 } else { 1 };
    let number = text.strip_prefix(['+', '-'])?;
    let (hours, minutes) = match number.split_once(':') {
        Some(both) => both,
        None if number.len() == 4 => number.split_at_checked(2)?,
        None => (number, "0"),
    };
    let digits = |t: &str| {
        let short = (1..=2).contains(&t.len()) && t.bytes().all(|b| b.is_ascii_digit());
        t.parse::<i64>().ok().filter(|_| short)
    };
    let (hours, minutes) = (digits(hours)?, digits(minutes)?);
    (hours <= 18 && minutes <= 59).then_some(sign * (hours * 60 + minutes))
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
            "3/25/26 14:05:30",
            "25.03.26, 14:05:30",
            "Wednesday, 25 March 2026, 2:05:30 PM",
            "25 March 2026 2:05:30 PM",
            "Mittwoch, 25. M\u{e4}rz 2026, 14:05:30",
            "25. Mrz. 2026 um 14:05:30 Uhr",
            "Mar 25, 2026, 2:05:30\u{202f}p.m.",
            "March 25th, 2026 at 14:05:30",
            "25-Mar-2026 14:05:30",
            "25-Mar-26 14:05:30",
            "Wed, 25 Mar 2026 15:05:30 +0100",
            "Wed Mar 25 15:05:30 CET 2026",
            "Wed Mar 25 2026 15:05:30 GMT+0100 (Central European Standard Time)",
            "2026-03-25 16:05:30 CEST",
            "2026-03-25 16:05:30 (MESZ)",
            "25.03.2026 10:05:30 AM EDT",
            "20260325T140530Z",
            "20260325T150530+0100",
            "20260325 140530",
            "3-25-2026 14:05:30",
            "25-3-2026 14:05:30",
            "2026-03-25 14h05:30",
            "\u{662}\u{660}\u{662}\u{666}-\u{660}\u{663}-\u{662}\u{665} \u{661}\u{664}:\u{660}\u{665}:\u{663}\u{660}",
            "46106.587153",
            "46106,58715278",
            "1774447530",
            "1774447530.0",
            "1774447530000",
        ] {
            assert_eq!(parse(text).map(|m| (m.micros, m.uncertain)), Some((want, false)), "{text}");
        }
        for odd in [
            "13/13/2026 10:00",
            "yesterday",
            "2026-02-30",
            "2026-03-25 25:00",
            "14:05",
            "",
            "26-03-29",
            "20261329T1530",
            "2026-03-25 14h5",
            "31 February 2026 10:00",
            "March 2026",
            "25 March April 2026",
            "25 Marchember 2026",
            "1234",
            "12345678",
            "46106 x",
            "25 March 2026 15:05 CEST+1",
        ] {
            assert_eq!(parse(odd), None, "{odd}");
        }
    }

    /// The tests held only that these spellings are read at all: a date alone became midnight and a wrong day of the week was
    /// passed over, and nothing told it.
    #[test]
    fn a_date_alone_and_a_wrong_weekday_are_told_apart() {
        let zone = crate::policy::Zone::default();
        for (text, doubt) in [
            ("2026-03-29", Some("no time of day")),
            ("20260329", Some("no time of day")),
            ("3/29/2026", Some("no time of day")),
            ("29. März 2026", Some("no time of day")),
            ("46110", Some("no time of day")),
            ("46110.0", Some("no time of day")),
            ("46110.5", None),
            ("2026-03-29 00:00", None),
            ("2026-03-29 15h", None),
            ("Monday, 29 March 2026, 3:30 PM", Some("the day of the week does not fit the date")),
            ("So, 29. März 2026, 15:30", None),
            ("Sonnabend, 28. März 2026, 15:30", None),
            ("2026-03-29 15:30 CST", Some("CST means several zones")),
            ("whenever", None),
        ] {
            assert_eq!(zone.doubt(text).map(|d| d.to_string()).as_deref(), doubt, "{text}");
        }
        assert_eq!(zone.read("Monday, 29 March 2026, 3:30 PM"), None);
        assert_eq!(parse("3-4-2026 10:00").map(|m| m.uncertain), Some(true));
    }

    #[test]
    fn the_column_decides_the_order_of_day_and_month() {
        let day = parse("25/3/2026").unwrap().evidence;
        let month = parse("3/25/2026").unwrap().evidence;
        // In a list of both, this one tells nothing of those with slashes.
        assert_eq!(parse("25.3.2026").unwrap().evidence, Evidence::default());
        let uncertain = parse("3/4/2026").unwrap();
        assert_eq!((uncertain.uncertain, uncertain.evidence), (true, Evidence::default()));
        assert_eq!(Some(uncertain.micros[day.choice()]), parse("2026-04-03").map(|m| m.micros[0]));
        assert_eq!(Some(uncertain.micros[month.choice()]), parse("2026-03-04").map(|m| m.micros[0]));
        let mut both = day;
        both.join(month);
        let none = Evidence::default();
        assert_eq!([day, month, both, none].map(Evidence::decides), [true, true, false, false]);
        let dotted = parse("3.4.2026").unwrap();
        assert_eq!(
            (dotted.uncertain, Some(dotted.micros[1])),
            (false, parse("2026-04-03").map(|m| m.micros[0]))
        );
    }

    /// Words for zones were refused before, and a wrong offset moves a deadline: the fixed ones are the database's own.
    #[test]
    fn words_for_zones_are_those_of_the_database() {
        let places = [
            ("CET", "Europe/Berlin"),
            ("CEST", "Europe/Berlin"),
            ("WET", "Europe/Lisbon"),
            ("WEST", "Europe/Lisbon"),
            ("EET", "Europe/Helsinki"),
            ("EEST", "Europe/Helsinki"),
            ("MSK", "Europe/Moscow"),
            ("EST", "America/New_York"),
            ("EDT", "America/New_York"),
            ("CDT", "America/Chicago"),
            ("MST", "America/Denver"),
            ("MDT", "America/Denver"),
            ("PST", "America/Los_Angeles"),
            ("PDT", "America/Los_Angeles"),
            ("AKST", "America/Anchorage"),
            ("AKDT", "America/Anchorage"),
            ("HST", "Pacific/Honolulu"),
            ("JST", "Asia/Tokyo"),
            ("KST", "Asia/Seoul"),
            ("HKT", "Asia/Hong_Kong"),
            ("AEST", "Australia/Sydney"),
            ("AEDT", "Australia/Sydney"),
            ("NZST", "Pacific/Auckland"),
            ("NZDT", "Pacific/Auckland"),
            ("SAST", "Africa/Johannesburg"),
        ];
        for (word, place) in places {
            let zone = crate::policy::Zone::named(place).unwrap();
            let found = ["2026-01-15 12:00", "2026-07-15 12:00"].into_iter().find_map(|at| {
                let by_word = parse(&format!("{at} {word}"))?;
                zone.calls(parse(at)?.micros[0], word)
                    .then_some((by_word.micros[0], zone.read(at)?.micros[0]))
            });
            let (by_word, by_place) = found.unwrap_or_else(|| panic!("{word} is not used in {place}"));
            assert_eq!(by_word, by_place, "{word}");
        }
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,45}", near in "[0-9TZ:/. +-]{0,30}") {
            let _ = (parse(&text), parse(&near));
            let _ = parse(&format!("{near} March {text}"));
        }
    }
}
