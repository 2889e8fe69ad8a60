//! A cell to a number with its unit, a word, a blank, or why it cannot be read. Knows nothing of keys.
use crate::units::Unit;
use crate::units::UnitFault;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// A word that answers a question or gives a number its sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Word {
    /// Up, positive.
    Up,
    /// Down, negative.
    Down,
    /// Forward, positive.
    Forward,
    /// Back, negative.
    Back,
    /// To the right: a direction on a level only.
    Right,
    /// To the left.
    Left,
    /// Does not move.
    Stays,
    /// Yes.
    Yes,
    /// No.
    No,
}

impl Word {
    /// As keys write it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Word::Up => "up",
            Word::Down => "down",
            Word::Forward => "forward",
            Word::Back => "back",
            Word::Right => "right",
            Word::Left => "left",
            Word::Stays => "stays",
            Word::Yes => "yes",
            Word::No => "no",
        }
    }
    /// 1 or -1 for a direction.
    pub const fn sign(self) -> Option<f64> {
        match self {
            Word::Up | Word::Forward => Some(1.0),
            Word::Down | Word::Back => Some(-1.0),
            _ => None,
        }
    }
}

/// A number as it was written.
#[derive(Debug, Clone)]
pub struct Number {
    /// The number, in `unit`; finite.
    pub value: f64,
    /// Where a lone comma stands before three digits: the number if the comma only grouped digits.
    pub grouped: Option<f64>,
    /// A lone comma was read as the decimal mark.
    pub comma: bool,
    /// The unit, if one was written.
    pub unit: Option<Arc<Unit>>,
    /// Upper and lower case of the unit were forgiven.
    pub case_forgiven: bool,
    /// The direction, if one was written.
    pub word: Option<Word>,
    /// `about` or the like stood before it.
    pub about: bool,
    /// `clockwise`, `ccw` or the like stood after it.
    pub turning: bool,
}

impl Number {
    /// A number alone.
    fn plain(value: f64) -> Number {
        Number {
            value,
            grouped: None,
            comma: false,
            unit: None,
            case_forgiven: false,
            word: None,
            about: false,
            turning: false,
        }
    }
}

/// What a cell says.
#[derive(Debug, Clone)]
pub enum Reading {
    /// Nothing.
    Blank,
    /// A number.
    Number(Number),
    /// A word alone.
    Word(Word),
    /// Not to be read, and why.
    Unreadable(Why),
}

/// Why a cell cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Why {
    /// Longer than 200 characters.
    TooLong,
    /// Neither a number nor a known word.
    NoNumber,
    /// NaN, infinity, or a number beyond the range of a double.
    NotFinite,
    /// Comma and point, or two commas, or two points.
    Marks,
    /// Two numbers, or a range.
    TwoNumbers,
    /// A formula before or after the result.
    Formula,
    /// A negative number with a direction.
    SignAndWord,
    /// `yes`, `no` or `stays` after a number, or two directions.
    OddWord,
    /// What follows the number is no unit.
    Unit(UnitFault),
}

/// A unit, and whether its letters had to be forgiven.
type ReadUnit = Result<(Arc<Unit>, bool), UnitFault>;

/// Unit texts already read, so that a class of answers parses each spelling once.
#[derive(Debug, Default)]
pub struct UnitCache {
    known: FxHashMap<Box<str>, ReadUnit>,
}

impl UnitCache {
    fn unit(&mut self, text: &str) -> ReadUnit {
        if let Some(found) = self.known.get(text) {
            return found.clone();
        }
        let plain = spoken(text);
        let text = plain.as_deref().unwrap_or(text);
        let found = match Unit::parse(text) {
            Ok(unit) => Ok((Arc::new(unit), false)),
            Err(_) => Unit::parse_any_case(text).map(|(unit, forgiven)| (Arc::new(unit), forgiven)),
        };
        if self.known.len() < 512 && text.len() <= 64 {
            self.known.insert(text.into(), found.clone());
        }
        found
    }
}

/// `radians per second squared` as `radians/second^2`; `None` where nothing is spoken.
fn spoken(text: &str) -> Option<String> {
    let plain = text
        .replace(" per ", "/")
        .replace(" squared", "^2")
        .replace("Umdr./", "Umdr/")
        .replace("Umdr. /", "Umdr/");
    (plain != text).then_some(plain)
}

/// A plain decimal number such as `30.3` or `-0.05`, with blanks around it; nothing else. The way for the most of cells.
#[inline]
pub fn plain_number(cell: &[u8]) -> Option<f64> {
    let cell = cell.trim_ascii();
    let digits = cell.strip_prefix(b"-").unwrap_or(cell);
    if digits.is_empty() || digits.len() > 17 {
        return None;
    }
    let (mut mantissa, mut decimals, mut seen, mut point) = (0u64, 0usize, 0usize, 0usize);
    for &b in digits {
        let digit = b.wrapping_sub(b'0');
        if digit < 10 {
            mantissa = mantissa * 10 + u64::from(digit);
            seen += 1;
            decimals += point;
        } else if b == b'.' && point == 0 {
            point = 1;
        } else {
            return None;
        }
    }
    if seen == 0 || mantissa >= 1 << 53 {
        return None;
    }
    let value = mantissa as f64 / crate::units::TENS[decimals]; // both exact: one rounding
    Some(if digits.len() < cell.len() { -value } else { value })
}

/// Reads a cell.
///
/// ```
/// use slipstick::answer::read::{Reading, UnitCache, read};
/// let Reading::Number(n) = read("1,25 m/s", &mut UnitCache::default()) else { panic!("a number") };
/// assert_eq!((n.value, n.comma), (1.25, true));
/// ```
pub fn read(cell: &str, units: &mut UnitCache) -> Reading {
    if let Some(value) = plain_number(cell.as_bytes()) {
        return Reading::Number(Number::plain(value));
    }
    if cell.len() > 800 || cell.chars().count() > 200 {
        return if cell.trim().is_empty() { Reading::Blank } else { Reading::Unreadable(Why::TooLong) };
    }
    match general(&normal(cell), units) {
        Ok(reading) => reading,
        Err(why) => Reading::Unreadable(why),
    }
}

/// One kind of blank, one kind of minus, nothing invisible, no spreadsheet's wrapping.
fn normal(cell: &str) -> String {
    let mut text = String::with_capacity(cell.len());
    for c in cell.chars() {
        match c {
            '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}' | '\u{ad}' | '\u{202a}'..='\u{202e}' => {}
            '\u{2010}'..='\u{2015}' | '\u{2212}' | '\u{fe63}' | '\u{ff0d}' => text.push('-'),
            c if c.is_whitespace() => text.push(' '),
            '０'..='９' => text.extend(char::from_u32(u32::from(c) - u32::from('０') + u32::from('0'))),
            '．' => text.push('.'),
            '，' => text.push(','),
            '／' => text.push('/'),
            '＋' => text.push('+'),
            '＝' => text.push('='),
            '\u{2191}' => text.push_str(" up "),
            '\u{2193}' => text.push_str(" down "),
            c => text.push(c),
        }
    }
    if text.contains(['\\', '$']) {
        text = without_tex(&text);
    }
    let mut trimmed = text.trim();
    if let Some(inside) = trimmed.strip_prefix("=\"").and_then(|t| t.strip_suffix('"')) {
        trimmed = inside.trim();
    } else if trimmed.len() >= 2
        && let Some(inside) = trimmed.strip_prefix('"').and_then(|t| t.strip_suffix('"'))
    {
        trimmed = inside.trim();
    }
    let trimmed = trimmed.strip_prefix('\'').unwrap_or(trimmed).trim();
    trimmed.strip_suffix(['.', ';', ',']).unwrap_or(trimmed).trim_end().to_owned()
}

/// LaTeX such as `$47.3$\\ \\mathrm{rad/s}` as plain text.
fn without_tex(text: &str) -> String {
    const PLAIN: &[(&str, &str)] = &[
        ("$", ""),
        ("^{\\circ}", "°"),
        ("^\\circ", "°"),
        ("\\degree", "°"),
        ("{,}", ","),
        ("\\mathrm", ""),
        ("\\textrm", ""),
        ("\\text", ""),
        ("\\rm", ""),
        ("\\left", ""),
        ("\\right", ""),
        ("\\qquad", " "),
        ("\\quad", " "),
        ("\\cdot", "·"),
        ("\\times", "×"),
        ("\\approx", "≈"),
        ("\\uparrow", " up "),
        ("\\downarrow", " down "),
        ("\\%", "%"),
        ("\\ ", " "),
        ("\\,", " "),
        ("\\;", " "),
        ("\\:", " "),
        ("\\!", ""),
        ("\\(", ""),
        ("\\)", ""),
    ];
    let mut text = text.to_owned();
    for (from, to) in PLAIN {
        text = text.replace(from, to);
    }
    let mut out = String::with_capacity(text.len());
    let mut raised = false; // inside ^{ }
    for c in text.chars() {
        match c {
            '{' if out.ends_with('^') => {
                raised = true;
                out.push('(');
            }
            '}' if raised => {
                raised = false;
                out.push(')');
            }
            '{' | '}' => {}
            c => out.push(c),
        }
    }
    out
}

const ABOUT: &[&str] =
    &["about", "approximately", "approx", "around", "roughly", "circa", "ca", "etwa", "ungefähr", "rund"];

/// Without `about` or its like before a number, and whether it stood there.
fn without_about(text: &str) -> (&str, bool) {
    let end = text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len());
    let rest = text[end..].strip_prefix('.').unwrap_or(&text[end..]).trim_start();
    let about = rest.starts_with(|c: char| c.is_ascii_digit() || "-+.,".contains(c))
        && ABOUT.contains(&text[..end].to_lowercase().as_str());
    if about { (rest, true) } else { (text, false) }
}

const TURNING: &[&str] = &[
    "counterclockwise",
    "counter-clockwise",
    "counter clockwise",
    "anticlockwise",
    "anti-clockwise",
    "clockwise",
    "gegen den uhrzeigersinn",
    "im uhrzeigersinn",
    "ccw",
    "cw",
];

/// Without the sense of turning after a number, and whether it stood there.
fn without_turning(text: &str) -> (&str, bool) {
    let inside = text.strip_suffix(')').unwrap_or(text).trim_end();
    for word in TURNING {
        let Some(at) = inside.len().checked_sub(word.len()) else { continue };
        let (Some(before), Some(last)) = (inside.get(..at), inside.get(at..)) else { continue };
        if last.eq_ignore_ascii_case(word)
            && before.ends_with([' ', ',', '('])
            && before.contains(|c: char| c.is_ascii_digit())
        {
            return (before.trim_end_matches([' ', ',', '(']), true);
        }
    }
    (text, false)
}

fn general(text: &str, units: &mut UnitCache) -> Result<Reading, Why> {
    if text.is_empty() {
        return Ok(Reading::Blank);
    }
    let text = after_symbol(text)?;
    let text = text.trim_start_matches(['~', '\u{2248}', '\u{2243}', ' ']);
    let (text, about) = without_about(text);
    let (text, turning) = without_turning(text);
    if let Some(word) = phrase(text) {
        return word.map(Reading::Word);
    }
    let starts = |t: &str| {
        let t = t.strip_prefix(['-', '+']).unwrap_or(t).trim_start();
        let t = t.strip_prefix(['.', ',']).unwrap_or(t);
        t.starts_with(|c: char| c.is_ascii_digit())
    };
    let (mut word, mut text) = (None, text);
    if !starts(text) {
        let lower = text.trim_start_matches(['-', '+']).trim().to_lowercase();
        if ["nan", "inf", "infinity", "\u{221e}"]
            .iter()
            .any(|w| lower == *w || lower.starts_with(&format!("{w} ")))
        {
            return Err(Why::NotFinite);
        }
        let digit = text.find(|c: char| c.is_ascii_digit()).ok_or(Why::NoNumber)?;
        let before = text[..digit].trim_end_matches(['.', ',', '-', '+']);
        word = Some(phrase(before.trim_end_matches([':', ' '])).ok_or(Why::NoNumber)??);
        text = text[before.len()..].trim_start();
        if !starts(text) {
            return Err(Why::NoNumber);
        }
    }
    let (mut number, negative, rest) = decimal(text)?;
    let (unit_text, after) = split_unit(rest, units)?;
    if let Some(after) = after {
        if word.is_some_and(|w| w != after) {
            return Err(Why::OddWord);
        }
        word = Some(after);
    }
    if let Some((unit, forgiven)) = unit_text {
        number.unit = Some(unit);
        number.case_forgiven = forgiven;
    }
    if let Some(w) = word {
        if w.sign().is_none() && !matches!(w, Word::Left | Word::Right) {
            return Err(Why::OddWord);
        }
        if negative {
            return Err(Why::SignAndWord);
        }
    }
    number.word = word;
    number.about = about;
    number.turning = turning;
    Ok(Reading::Number(number))
}

/// What stands after `omega =` or `=`.
fn after_symbol(text: &str) -> Result<&str, Why> {
    let Some(at) = text.find(['=', '\u{2248}']) else { return Ok(text) };
    let (name, rest) = (text[..at].trim(), text[at..].trim_start_matches(['=', '\u{2248}']).trim_start());
    let symbol = name.chars().count() <= 24
        && name.chars().next().is_none_or(|c| c.is_alphabetic() || c == '\\' || c == '|')
        && name.chars().all(|c| c.is_alphanumeric() || " _\\|{}'".contains(c));
    if !symbol || rest.contains(['=', '\u{2248}']) {
        return Err(Why::Formula);
    }
    Ok(rest)
}

fn superscript(c: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹"
        .chars()
        .zip('0'..='9')
        .find(|(s, _)| *s == c)
        .map(|(_, d)| d)
        .or((c == '\u{207b}').then_some('-'))
}

/// The number at the start: (number, was it written with a minus, what follows).
fn decimal(text: &str) -> Result<(Number, bool, &str), Why> {
    let negative = text.starts_with('-');
    let mut rest = text.strip_prefix(['-', '+']).unwrap_or(text).trim_start();
    let mut digits = String::with_capacity(24); // with a point
    let (mut commas, mut points, mut spaced) = (0, 0, false);
    let mut after_mark = 0usize;
    let bytes = rest.as_bytes();
    let digit_at = |k: usize| bytes.get(k).is_some_and(u8::is_ascii_digit);
    let mut at = 0;
    while let Some(&b) = bytes.get(at) {
        match b {
            b'0'..=b'9' => {
                digits.push(char::from(b));
                after_mark += 1;
            }
            b',' | b'.' if digit_at(at + 1) || (b == b'.' && at > 0 && points == 0 && commas == 0) => {
                if b == b',' {
                    commas += 1;
                } else {
                    points += 1;
                }
                if commas + points > 1 {
                    return Err(Why::Marks);
                }
                digits.push('.');
                after_mark = 0;
            }
            b' ' if bytes[at + 1..].starts_with(b"1/") || bytes[at + 1..].starts_with(b"1 /") => break, // `30.3 1/s`
            b' ' if digit_at(at + 1) => {
                // a blank groups digits only before exactly three of them, and only above the decimal mark
                let three = (1..=3).all(|k| digit_at(at + k)) && !digit_at(at + 4);
                let first = digits.len() <= 3 || spaced;
                if !(three && first && commas + points == 0 && !digits.is_empty()) {
                    return Err(Why::TwoNumbers);
                }
                spaced = true;
            }
            b'\'' if digit_at(at + 1) => return Err(Why::Marks),
            _ => break,
        }
        at += 1;
    }
    if !digits.bytes().any(|b| b.is_ascii_digit()) {
        return Err(Why::NoNumber);
    }
    rest = &rest[at..];
    let grouped_digits = (commas == 1
        && !spaced
        && after_mark == 3
        && digits.find('.').is_some_and(|p| (1..=3).contains(&p))
        && !digits.starts_with('0'))
    .then(|| digits.replace('.', ""));
    // powers of ten
    let mut exponent = String::new();
    if let Some(tail) = rest.strip_prefix(['e', 'E']) {
        let sign = tail.starts_with('-');
        let number = tail.strip_prefix(['-', '+']).unwrap_or(tail);
        let length = number.bytes().take_while(u8::is_ascii_digit).count();
        if length > 0 {
            exponent = format!("{}{}", if sign { "-" } else { "" }, &number[..length]);
            rest = &number[length..];
        }
    } else if let Some((power, tail)) = times_ten(rest)? {
        exponent = power;
        rest = tail;
    }
    let parse = |digits: &str| -> Result<f64, Why> {
        let text = if exponent.is_empty() { digits.to_owned() } else { format!("{digits}e{exponent}") };
        let value: f64 = text.parse().map_err(|_| Why::NoNumber)?;
        if !value.is_finite() {
            return Err(Why::NotFinite);
        }
        Ok(if negative { -value } else { value })
    };
    let value = parse(&digits)?;
    let grouped = grouped_digits.and_then(|d| parse(&d).ok());
    let number = Number { grouped, comma: commas == 1, ..Number::plain(value) };
    Ok((number, negative, rest))
}

/// `×10^n`, `x 10^-3`, `·10ⁿ`, `*10**n`: the exponent and what follows.
fn times_ten(text: &str) -> Result<Option<(String, &str)>, Why> {
    let Some(tail) = text.trim_start().strip_prefix(['\u{d7}', 'x', 'X', '*', '·', '\u{22c5}', '\u{2219}'])
    else {
        return Ok(None);
    };
    let Some(tail) = tail.trim_start().strip_prefix("10") else {
        return if tail.trim_start().starts_with(|c: char| c.is_ascii_digit()) {
            Err(Why::Formula)
        } else {
            Ok(None)
        };
    };
    let raised: String = tail.chars().map_while(superscript).collect();
    if !raised.is_empty() {
        let bytes: usize = tail.chars().take(raised.chars().count()).map(char::len_utf8).sum();
        return Ok(Some((raised, &tail[bytes..])));
    }
    let tail = tail.trim_start();
    let Some(tail) = tail.strip_prefix("**").or_else(|| tail.strip_prefix('^')) else {
        return Err(Why::Formula);
    };
    let tail = tail.trim_start();
    let (closing, tail) = match tail.chars().next() {
        Some('(') => (Some(')'), &tail[1..]),
        Some('{') => (Some('}'), &tail[1..]),
        _ => (None, tail),
    };
    let sign = tail.starts_with('-');
    let number = tail.strip_prefix(['-', '+']).unwrap_or(tail);
    let length = number.bytes().take_while(u8::is_ascii_digit).count();
    if length == 0 {
        return Err(Why::Formula);
    }
    let mut rest = &number[length..];
    if let Some(closing) = closing {
        rest = rest.strip_prefix(closing).ok_or(Why::Formula)?;
    }
    Ok(Some((format!("{}{}", if sign { "-" } else { "" }, &number[..length]), rest)))
}

type UnitAndWord = (Option<(Arc<Unit>, bool)>, Option<Word>);

/// What follows a number: a unit, then perhaps a direction.
fn split_unit(rest: &str, units: &mut UnitCache) -> Result<UnitAndWord, Why> {
    let rest = rest.trim();
    if rest.is_empty() {
        return Ok((None, None));
    }
    let first_fault = match units.unit(rest) {
        Ok(found) => return Ok((Some(found), None)),
        Err(fault) => fault,
    };
    let mut cuts: Vec<usize> = rest.match_indices([' ', ',', '(']).map(|(i, _)| i).collect();
    cuts.reverse();
    cuts.push(0);
    let mut fault_before_word = None;
    for cut in cuts {
        let Some(word) = phrase(&rest[cut..]) else { continue };
        let before = rest[..cut].trim_end_matches([',', ' ', ';']);
        if before.is_empty() {
            return Ok((None, Some(word?)));
        }
        if before.ends_with(" in") {
            continue; // `62.6 N in up direction`
        }
        match units.unit(before) {
            Ok(found) => return Ok((Some(found), Some(word?))),
            Err(fault) => fault_before_word = Some(fault),
        }
    }
    if let Some(fault) = fault_before_word {
        return Err(Why::Unit(fault));
    }
    if rest.starts_with(['/', '+', '-', '^']) || rest.contains('\u{b1}') {
        return Err(if rest.contains('\u{b1}') || rest.starts_with(['+', '-']) {
            Why::TwoNumbers
        } else {
            Why::Formula
        });
    }
    Err(Why::Unit(first_fault))
}

const WORDS: &[(Word, &[&str])] = &[
    (
        Word::Up,
        &[
            "up",
            "upward",
            "upwards",
            "uphill",
            "upslope",
            "auf",
            "aufwärts",
            "hinauf",
            "herauf",
            "rauf",
            "bergauf",
            "oben",
            "hangaufwärts",
        ],
    ),
    (
        Word::Down,
        &[
            "down",
            "downward",
            "downwards",
            "downhill",
            "downslope",
            "ab",
            "abwärts",
            "hinab",
            "herab",
            "hinunter",
            "herunter",
            "runter",
            "bergab",
            "unten",
            "hangabwärts",
        ],
    ),
    (Word::Forward, &["forward", "forwards", "vorwärts", "vor", "vorn", "vorne", "voran"]),
    (Word::Back, &["back", "backward", "backwards", "rückwärts", "zurück", "hinten"]),
    (Word::Right, &["right", "rightward", "rightwards", "rechts"]),
    (Word::Left, &["left", "leftward", "leftwards", "links"]),
    (
        Word::Stays,
        &["stays", "stay", "rest", "stationary", "still", "bleibt", "ruht", "ruhe", "unbewegt", "unmoved"],
    ),
    (Word::Yes, &["yes", "y", "ja", "j", "true", "wahr"]),
    (Word::No, &["no", "n", "nein", "false", "falsch"]),
];
const FILLERS: &[&str] = &[
    "the",
    "a",
    "an",
    "incline",
    "inclined",
    "plane",
    "slope",
    "ramp",
    "along",
    "to",
    "at",
    "acting",
    "acts",
    "directed",
    "pointing",
    "points",
    "moves",
    "it",
    "is",
    "in",
    "direction",
    "nach",
    "die",
    "der",
    "schiefe",
    "schiefen",
    "ebene",
    "es",
    "das",
    "rad",
    "kraft",
    "wirkt",
    "zeigt",
    "gerichtet",
    "entlang",
    "längs",
    "richtung",
    "stehen",
    "könnte",
    "kann",
    "würde",
    "sich",
    "bewegt",
    "could",
    "have",
    "would",
    "will",
    "does",
    "put",
    "remains",
    "wheel",
];

/// A phrase made of one direction or word and fillers only. `None`: other words; `Some(Err)`: two that differ.
fn phrase(text: &str) -> Option<Result<Word, Why>> {
    if text.len() > 80 || !text.contains(|c: char| c.is_alphabetic()) {
        return None;
    }
    let mut found: Option<Word> = None;
    let mut two = false;
    let (mut rolls, mut denied) = (None, false); // what `it rolls`, `it slips` and `not` add to a yes or no
    let lower = text.to_lowercase();
    let lower = ["does not move", "doesn't move", "not moving", "no motion", "bewegt sich nicht"]
        .iter()
        .fold(lower, |t, said| t.replace(said, "stays"));
    let plain =
        lower.split(|c: char| c.is_whitespace() || "(),.;:!-\"'".contains(c)).filter(|t| !t.is_empty());
    for token in plain {
        if let Some((word, _)) = WORDS.iter().find(|(_, all)| all.contains(&token)) {
            two |= found.is_some_and(|f| f != *word);
            found = Some(*word);
        } else if ["roll", "rolls", "rolling", "rolled", "rollt", "rollen", "rollte"].contains(&token) {
            two |= rolls == Some(false);
            rolls = Some(true);
        } else if ["slip", "slips", "slipping", "slides", "rutscht", "gleitet", "gleiten"].contains(&token) {
            two |= rolls == Some(true);
            rolls = Some(false);
        } else if ["not", "nicht"].contains(&token) {
            denied = true;
        } else if !FILLERS.contains(&token) {
            return None;
        }
    }
    let word = found?;
    let contradicts = match word {
        Word::Yes => denied != (rolls == Some(false)),
        Word::No => rolls.is_some_and(|r| r != denied),
        _ => denied,
    };
    Some(if two || contradicts { Err(Why::OddWord) } else { Ok(word) })
}
