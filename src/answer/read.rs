//! A cell to a number with its unit, a word, a blank, or why it cannot be read. Knows nothing of keys.
use crate::answer::numeral::{Numeral, begins, numeral, unsigned};
use crate::answer::plain::{PlainText, plain};
use crate::answer::spelling::SpelledUnit;
pub use crate::answer::spelling::UnitCache;
use crate::answer::word::{AnswerWord, phrase};
use crate::num::decimal::one_of;
use crate::units::{Unit, UnitFault};
use std::sync::Arc;

/// How a number was read, where it could not simply be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReadingNote {
    /// A lone comma is the decimal mark.
    Comma,
    /// Marks, brackets, a fraction, a root, several units or digits of another script: the value is told.
    ReadAs,
    /// The number before `±` counts.
    Uncertainty,
    /// `about` or the like stood before it.
    About,
    /// The number has no unit and its uncertainty is in per cent: where a pure number is asked, both may be.
    PerCent,
}

/// A number as it was written.
#[derive(Debug, Clone, Default)]
pub struct Number {
    /// The number, in `unit`; finite.
    pub value: f64,
    /// Where a lone comma stands before three digits: the number if the comma only grouped digits.
    pub grouped: Option<f64>,
    /// The unit, if one was written.
    pub unit: Option<Arc<Unit>>,
    /// What the unit means where that is of the kind that is asked, and `unit` is not: `lb` a force, `kn` a knot.
    pub otherwise: Option<Arc<Unit>>,
    /// Upper and lower case of the unit were forgiven.
    pub case_forgiven: bool,
    /// The direction, if one was written.
    pub word: Option<AnswerWord>,
    /// How it was read.
    pub notes: Vec<ReadingNote>,
}

impl Number {
    /// The unit as it is meant where a quantity in `asked` is asked.
    pub fn unit_for(&self, asked: &Unit) -> Option<&Unit> {
        let unit = self.unit.as_deref()?;
        match self.otherwise.as_deref() {
            Some(other) if !asked.agrees(unit) && asked.agrees(other) => Some(other),
            _ => Some(unit),
        }
    }
    /// Was anything forgiven or interpreted?
    pub fn is_interpreted(&self) -> bool {
        !self.notes.is_empty() || self.grouped.is_some() || self.word.is_some()
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
    Word(AnswerWord),
    /// Not to be read, and why.
    Unreadable(WhyUnreadable),
}

/// Why a cell cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WhyUnreadable {
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
    /// A negative number with a direction: its size, its unit and the direction.
    SignAndWord {
        /// Digits without the minus.
        size: String,
        /// In ASCII; empty if there is none.
        unit: String,
        /// The direction.
        word: AnswerWord,
    },
    /// `yes`, `no` or `stays` after a number, or two directions.
    OddWord,
    /// Nothing stands behind a sign: `5-`, `12 ±`.
    Lacking(char),
    /// `>= 0.42`.
    Bound,
    /// `12·71`: a point or a product.
    Dot,
    /// `0x10`.
    Hex,
    /// `12'`, `4' 3`: the signs for feet and inches alone.
    Prime,
    /// `3 ft 14 in`: the smaller part holds a whole larger unit.
    Full {
        /// As it is written.
        part: String,
        /// The larger unit.
        whole: String,
    },
    /// What follows the number is no unit.
    Unit(UnitFault),
}

/// Reads a cell.
///
/// ```
/// use slipstick::answer::read::{ReadingNote, Reading, UnitCache, read};
/// let Reading::Number(n) = read("1,25 m/s", &mut UnitCache::default()) else { panic!("a number") };
/// assert_eq!((n.value, n.notes), (1.25, vec![ReadingNote::Comma]));
/// ```
pub fn read(cell: &str, units: &mut UnitCache) -> Reading {
    if cell.len() > 800 || cell.chars().count() > 200 {
        return if cell.trim().is_empty() {
            Reading::Blank
        } else {
            Reading::Unreadable(WhyUnreadable::TooLong)
        };
    }
    match general(&plain(cell), units) {
        Ok(reading) => reading,
        Err(why) => Reading::Unreadable(why),
    }
}

const ABOUT: &[&str] =
    &["about", "approximately", "approx", "around", "roughly", "circa", "ca", "etwa", "ungefähr", "rund"];

/// Without `about` or its like before a number, and whether it stood there.
fn without_about(text: &str) -> (&str, bool) {
    let end = text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len());
    let rest = text[end..].strip_prefix('.').unwrap_or(&text[end..]).trim_start();
    let about = begins(rest) && ABOUT.contains(&text[..end].to_lowercase().as_str());
    if about { (rest, true) } else { (text, false) }
}

fn general(plain: &PlainText, units: &mut UnitCache) -> Result<Reading, WhyUnreadable> {
    if plain.text.is_empty() {
        return Ok(Reading::Blank);
    }
    if plain.text.contains(one_of("<>≥≤⩾⩽")) {
        return Err(WhyUnreadable::Bound);
    }
    let text = after_symbol(&plain.text)?.replace("+/-", "±").replace("+-", "±");
    let (text, bracketed) = without_brackets(&text);
    let text = text.trim_start_matches(one_of("~\u{2248}\u{2243} "));
    let (text, about) = without_about(text);
    if let Some(word) = phrase(text) {
        return word.map(Reading::Word);
    }
    let (mut word, mut text) = (None, text);
    if !begins(text) {
        let lower = text.trim_start_matches(one_of("-+")).trim().to_lowercase();
        if ["nan", "inf", "infinity", "\u{221e}"]
            .iter()
            .any(|w| lower == *w || lower.starts_with(&format!("{w} ")))
        {
            return Err(WhyUnreadable::NotFinite);
        }
        let digit = text.find(|c: char| c.is_ascii_digit()).ok_or(WhyUnreadable::NoNumber)?;
        let before = text[..digit].trim_end_matches(one_of(".,-+("));
        word = Some(phrase(before.trim_end_matches(one_of(": "))).ok_or(WhyUnreadable::NoNumber)??);
        text = without_brackets(&text[before.len()..]).0;
        if !begins(text) {
            return Err(WhyUnreadable::NoNumber);
        }
    }
    if let Some(why) = looks_like(text) {
        return Err(why);
    }
    let (negative, mut number) = quantity(text, (bracketed || plain.foreign, about), units)?;
    if let (Some(before), Some(after)) = (word, number.word)
        && before != after
    {
        return Err(WhyUnreadable::OddWord);
    }
    number.word = number.word.or(word);
    if let Some(word) = number.word {
        if !AnswerWord::DIRECTIONS.contains(&word) {
            return Err(WhyUnreadable::OddWord);
        }
        if negative {
            let unit = number.unit.as_ref().map_or("", |unit| unit.ascii()).to_owned();
            return Err(WhyUnreadable::SignAndWord { size: number.value.to_string(), unit, word });
        }
    }
    if negative {
        number.value = -number.value;
        number.grouped = number.grouped.map(|g| -g);
    }
    Ok(Reading::Number(number))
}

/// What looks like a number and is none, or may be another one.
fn looks_like(text: &str) -> Option<WhyUnreadable> {
    let body = unsigned(text).1;
    let digits = |t: &str| t.bytes().take_while(u8::is_ascii_digit).count();
    if let Some(hex) = body.strip_prefix("0x").or_else(|| body.strip_prefix("0X")) {
        let power =
            hex.strip_prefix("10").is_some_and(|t| t.starts_with(one_of("^*")) || digits(t) < t.len());
        if hex.starts_with(|c: char| c.is_ascii_hexdigit()) && !power {
            return Some(WhyUnreadable::Hex);
        }
    }
    let whole = digits(body);
    if let Some(behind) = body[whole..].strip_prefix(one_of("·\u{22c5}\u{2219}"))
        && whole > 0
    {
        let more = digits(behind);
        let power = more == 2 && behind.starts_with("10");
        if more > 0 && !power && !behind[more..].starts_with(one_of(".,/^*·")) {
            return Some(WhyUnreadable::Dot);
        }
    }
    let last = text.chars().last().filter(|c| matches!(c, '-' | '+' | '±'))?;
    let raised = text.ends_with("^-") || text.ends_with("^+");
    (text.contains(|c: char| c.is_ascii_digit()) && !raised).then_some(WhyUnreadable::Lacking(last))
}

/// Where the bracket closes that opens at the start.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0usize;
    for (i, b) in text.bytes().enumerate() {
        match b {
            b'(' => depth += 1,
            b')' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (b == b')').then_some(i);
        }
    }
    None
}

/// Without brackets around all of it.
fn without_brackets(text: &str) -> (&str, bool) {
    let (mut text, mut found) = (text.trim(), false);
    while text.starts_with('(') && closing(text).is_some_and(|at| at + 1 == text.len()) {
        text = text[1..text.len() - 1].trim();
        found = true;
    }
    (text, found)
}

/// Reads `-12,876.9 mm`, `3/4 m`, `42 ft 3 in`, `34.65 ± 0.1 N`, `(34.65 ± 0.1) N`, `62.6 N up`: the number without its sign, and
/// whether that is a minus. Of what stood around it is known whether it has to be told, and whether the number is `about` right.
fn quantity(
    text: &str,
    (mut told, about): (bool, bool),
    units: &mut UnitCache,
) -> Result<(bool, Number), WhyUnreadable> {
    let (negative, body) = unsigned(text);
    let (mut sign, mut spread_inside, mut per_cent) = (negative, false, false);
    let (number, behind) = match numeral(body) {
        Err(WhyUnreadable::NoNumber) if body.starts_with('(') => {
            // The number in brackets, its unit behind them.
            let end = closing(body).ok_or(WhyUnreadable::NoNumber)?;
            let (minus, inside) = unsigned(body[1..end].trim());
            let inner = numeral(inside)?;
            let left = inner.rest.trim();
            if let Some(spread) = left.strip_prefix('±') {
                if !numeral(spread.trim())?.rest.trim().is_empty() {
                    return Err(WhyUnreadable::TwoNumbers);
                }
                spread_inside = true;
            } else if !left.is_empty() || (negative && minus) {
                return Err(WhyUnreadable::Formula);
            }
            sign = negative || minus;
            told = true;
            (inner, &body[end + 1..])
        }
        found => {
            let found = found?;
            let behind = found.rest;
            (found, behind)
        }
    };
    let (behind, spread) = match behind.split_once('±') {
        Some((behind, spread)) => {
            match (behind.trim_end().strip_suffix('('), spread.trim().strip_suffix(')')) {
                (Some(behind), Some(spread)) => (behind, Some(spread)), // N (± 0.1)
                _ => (behind, Some(spread.trim())),
            }
        }
        None => (behind, None),
    };
    let (value, mut unit, mut word);
    match sum(&number, behind, units)? {
        Some((all, first, rest)) => {
            (value, unit) = (all, Some(first));
            word = match rest.trim() {
                "" => None,
                rest => Some(phrase(rest).ok_or(WhyUnreadable::TwoNumbers)??),
            };
            told = true;
        }
        None => {
            value = number.value;
            (unit, word) = split_unit(behind, units)?;
        }
    }
    if let Some(spread) = spread {
        if spread_inside || spread.contains('±') || !begins(spread) || spread.starts_with(one_of("-+(")) {
            return Err(WhyUnreadable::TwoNumbers);
        }
        let spread = numeral(spread)?;
        let (its, way) = split_unit(spread.rest, units)?;
        match (&unit, its) {
            (_, None) => {}
            // Of `25 ± 1 %` nobody knows what is in per cent, unless a unit is asked.
            (None, Some(its)) if its.unit.ascii() == "%" => per_cent = true,
            (None, Some(its)) => unit = Some(its),
            (Some(unit), Some(its)) if unit.unit.agrees(&its.unit) || its.unit.ascii() == "%" => {}
            (Some(_), Some(_)) => return Err(WhyUnreadable::TwoNumbers),
        }
        if let (Some(one), Some(other)) = (word, way)
            && one != other
        {
            return Err(WhyUnreadable::OddWord);
        }
        word = word.or(way);
    }
    if !value.is_finite() {
        return Err(WhyUnreadable::NotFinite);
    }
    let notes = [
        (number.comma, ReadingNote::Comma),
        (told || number.told, ReadingNote::ReadAs),
        (spread.is_some() || spread_inside, ReadingNote::Uncertainty),
        (about, ReadingNote::About),
        (per_cent, ReadingNote::PerCent),
    ];
    let notes = notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note).collect();
    let mut read = Number { value, grouped: number.grouped, word, notes, ..Number::default() };
    if let Some(SpelledUnit { unit, case_forgiven, otherwise }) = unit {
        (read.unit, read.case_forgiven, read.otherwise) = (Some(unit), case_forgiven, otherwise);
    }
    Ok((sign, read))
}

/// What several numbers with ever smaller units come to in the first of these, and what follows: `42 ft 3 in`, `10° 3'`.
/// Lengths, times, masses and angles are written so; a list of two answers looks alike, so a comma or an `and` joins only what
/// is not counted by tens. `None`: no second number with a unit of the same kind stands there.
fn sum<'t>(
    first: &Numeral<'t>,
    behind: &'t str,
    units: &mut UnitCache,
) -> Result<Option<(f64, SpelledUnit, &'t str)>, WhyUnreadable> {
    let (first_name, mut rest) = unit_name(behind);
    let Some(whole) = unit_of(first_name, ["ft", "in"], units) else { return Ok(None) };
    let angle = whole.unit.dimension().0 == [0, 0, 0, 1];
    let primes = if angle { ["arcmin", "arcsec"] } else { ["ft", "in"] };
    let (mut value, mut larger, mut more) = (first.value, (whole.clone(), first.whole), false);
    let mut touching = first_name.starts_with(char::is_alphabetic);
    loop {
        let apart = rest.trim_start();
        let joined =
            [". ", "and ", "und ", "& ", ", "].iter().find_map(|j| Some((*j, apart.strip_prefix(j)?)));
        let text = joined.map_or(apart, |(_, text)| text).trim_start();
        if !text.starts_with(|c: char| c.is_ascii_digit()) || (touching && text.len() == rest.len()) {
            break;
        }
        let Ok(next) = numeral(text) else { break };
        let (next_name, behind) = unit_name(next.rest);
        let Some(unit) = unit_of(next_name, primes, units) else { break };
        let product = behind.starts_with(one_of("/^*·²³"));
        if product || unit.unit.dimension() != whole.unit.dimension() {
            break;
        }
        let [one, less] = [&larger.0, &unit].map(|u| u.unit.to_si(1.0));
        let share = unit.unit.to_si(next.value) / one;
        let list = joined.is_some_and(|(by, _)| by != ". ") && whole.unit.by_tens(&unit.unit);
        let customary =
            matches!(whole.unit.dimension().0, [1, 0, 0, 0] | [0, 1, 0, 0] | [0, 0, 1, 0] | [0, 0, 0, 1]);
        if !larger.1 || less >= one || list || !customary {
            return Err(WhyUnreadable::TwoNumbers);
        }
        if share >= 1.0 {
            let end = text.len() - behind.len();
            let whole = larger.0.unit.ascii().to_owned();
            return Err(WhyUnreadable::Full { part: text[..end].trim().to_owned(), whole });
        }
        value += unit.unit.to_si(next.value) / whole.unit.to_si(1.0);
        larger = (unit, next.whole);
        touching = next_name.starts_with(char::is_alphabetic);
        rest = behind;
        more = true;
    }
    Ok(more.then_some((value, whole, rest)))
}

/// The name of a unit at the start of a text, or the sign for degrees, feet or inches, and what follows.
fn unit_name(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let sign = ["''", "'", "′", "\"", "″", "°", "º"].into_iter().find(|sign| text.starts_with(sign));
    let end = sign.map(str::len).or_else(|| text.find(|c: char| !c.is_alphabetic()));
    text.split_at(end.unwrap_or(text.len()))
}

/// The unit of a name, or of one prime or two.
fn unit_of(name: &str, primes: [&str; 2], units: &mut UnitCache) -> Option<SpelledUnit> {
    let name = match name {
        "" => return None,
        "'" | "′" => primes[0],
        "''" | "\"" | "″" => primes[1],
        name => name,
    };
    units.unit(name).ok()
}

/// What stands after `omega =` or `=`.
fn after_symbol(text: &str) -> Result<&str, WhyUnreadable> {
    let Some(at) = text.find(one_of("=\u{2248}")) else { return Ok(text) };
    let (name, rest) = (text[..at].trim(), text[at..].trim_start_matches(one_of("=\u{2248}")).trim_start());
    let symbol = name.chars().count() <= 24
        && name.chars().next().is_none_or(|c| c.is_alphabetic() || c == '\\' || c == '|')
        && name.chars().all(|c| c.is_alphanumeric() || " _\\|()'".contains(c));
    if !symbol || rest.contains(one_of("=\u{2248}")) {
        return Err(WhyUnreadable::Formula);
    }
    Ok(rest)
}

type UnitAndWord = (Option<SpelledUnit>, Option<AnswerWord>);

/// What follows a number: a unit, then perhaps a direction.
fn split_unit(rest: &str, units: &mut UnitCache) -> Result<UnitAndWord, WhyUnreadable> {
    let rest = rest.trim();
    if rest.is_empty() {
        return Ok((None, None));
    }
    if rest.starts_with(one_of("'′\"″")) {
        return Err(WhyUnreadable::Prime);
    }
    // 12 /s
    if rest.starts_with('/')
        && let Ok(found) = units.unit(&format!("1{rest}"))
    {
        return Ok((Some(found), None));
    }
    let first_fault = match units.unit(rest) {
        Ok(found) => return Ok((Some(found), None)),
        Err(fault) => fault,
    };
    let mut cuts: Vec<usize> = rest.match_indices(one_of(" ,(")).map(|(i, _)| i).collect();
    cuts.reverse();
    cuts.push(0);
    let mut fault_before_word = None;
    for cut in cuts {
        let Some(word) = phrase(&rest[cut..]) else { continue };
        // `155.3 N -down` says the sign and the direction.
        if rest[cut..]
            .trim_start_matches(one_of(" ,("))
            .strip_prefix('-')
            .is_some_and(|t| !t.starts_with(' '))
        {
            return Err(WhyUnreadable::OddWord);
        }
        let before = rest[..cut].trim_end_matches(one_of(", ;"));
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
        return Err(WhyUnreadable::Unit(fault));
    }
    if rest.starts_with(one_of("+-")) {
        return Err(WhyUnreadable::TwoNumbers);
    }
    if rest.starts_with(one_of("/^*\u{d7}·")) {
        return Err(WhyUnreadable::Formula);
    }
    Err(WhyUnreadable::Unit(first_fault))
}
