//! Text to unit, or the column of the trouble.
use crate::num::decimal::one_of;
use crate::units::table::{PREFIXES, ROWS, UnitRow};
use crate::units::{Dimension, Unit, UnitScale, spell};
use std::fmt;

/// Why a text is no unit. Columns count characters from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnitFault {
    /// Nothing there.
    Empty,
    /// A name that is not known, and a known one that is close.
    Unknown {
        /// The name.
        name: String,
        /// Where.
        column: usize,
        /// Perhaps this was meant.
        close: Option<String>,
    },
    /// A name that would be known in several ways if upper and lower case did not matter.
    CaseMatters {
        /// The name.
        name: String,
        /// What it might be.
        either: Vec<String>,
    },
    /// A name that stands for two units, such as `r` for the radian and for the revolution.
    Either {
        /// The name.
        name: String,
        /// What it may be.
        either: Vec<String>,
    },
    /// A character that has no place there.
    Stray {
        /// The character.
        found: char,
        /// Where.
        column: usize,
    },
    /// An exponent that is missing or beyond 9.
    Exponent {
        /// Where.
        column: usize,
    },
    /// A unit is missing after `/`, `*` or `(`, or a `)` is missing.
    Unfinished,
    /// Longer than 64 characters or too large to hold.
    TooLarge,
}

impl fmt::Display for UnitFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnitFault::Empty => write!(f, "the unit is missing"),
            UnitFault::Unknown { name, close: Some(close), .. } => {
                write!(f, "unknown unit `{name}`; did you mean `{close}`?")
            }
            UnitFault::Unknown { name, column, close: None } => {
                write!(f, "unknown unit `{name}` at column {column}")
            }
            UnitFault::CaseMatters { name, either } => {
                write!(
                    f,
                    "unknown unit `{name}`: write {} (upper and lower case matter)",
                    either.join(" or ")
                )
            }
            UnitFault::Either { name, either } => {
                write!(f, "`{name}` may be {}: write one of them", either.join(" or "))
            }
            UnitFault::Stray { found, column } => {
                write!(f, "unexpected `{}` at column {column}", found.escape_debug())
            }
            UnitFault::Exponent { column } => {
                write!(f, "an exponent from -9 to 9 is expected at column {column} of the unit")
            }
            UnitFault::Unfinished => write!(f, "the unit is not finished"),
            UnitFault::TooLarge => write!(f, "the unit is too long"),
        }
    }
}

impl std::error::Error for UnitFault {}

struct UnitReader<'a> {
    text: &'a [char],
    at: usize,
    any_case: bool,
    forgiven: bool,
    factors: Vec<(Box<str>, i8)>,
    dimension: [i8; 4],
    scale: UnitScale,
}

/// Reads a whole unit; `true`: upper and lower case were forgiven.
pub(crate) fn unit(text: &str, any_case: bool) -> Result<(Unit, bool), UnitFault> {
    let chars: Vec<char> = text.chars().take(65).collect();
    if chars.len() > 64 {
        return Err(UnitFault::TooLarge);
    }
    if chars.iter().all(|c| c.is_whitespace()) {
        return Err(UnitFault::Empty);
    }
    let mut reader = UnitReader {
        text: &chars,
        at: 0,
        any_case,
        forgiven: false,
        factors: Vec::new(),
        dimension: [0; 4],
        scale: UnitScale::ONE,
    };
    reader.product(1, 0)?;
    if let Some(&found) = chars.get(reader.at) {
        return Err(UnitFault::Stray { found, column: reader.at + 1 });
    }
    Ok((Unit::build(reader.factors, Dimension(reader.dimension), reader.scale), reader.forgiven))
}

fn superscript(c: char) -> Option<i8> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip(0i8..).find(|(s, _)| *s == c).map(|(_, n)| n)
}

fn is_minus(c: char) -> bool {
    matches!(c, '-' | '\u{2212}' | '\u{2013}' | '\u{2010}' | '\u{2011}')
}

impl UnitReader<'_> {
    fn peek(&self) -> Option<char> {
        self.text.get(self.at).copied()
    }
    fn blanks(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.at += 1;
        }
    }

    /// Factors until the end or a closing parenthesis; `sign` is -1 below a fraction bar.
    fn product(&mut self, sign: i8, depth: u8) -> Result<(), UnitFault> {
        if depth > 4 {
            return Err(UnitFault::TooLarge);
        }
        let mut below = false;
        let mut expected = true; // a factor must follow
        loop {
            self.blanks();
            match self.peek() {
                None | Some(')') => return if expected { Err(UnitFault::Unfinished) } else { Ok(()) },
                Some('/' | '\u{2215}' | '\u{2044}') if !expected => {
                    self.at += 1;
                    below = true;
                    expected = true;
                }
                Some('*' | '·' | '\u{22c5}' | '\u{d7}' | '\u{2219}' | '\u{2022}' | '.') if !expected => {
                    self.at += 1;
                    below = false;
                    expected = true;
                }
                Some('(') => {
                    self.at += 1;
                    self.product(if below { -sign } else { sign }, depth + 1)?;
                    if self.peek() != Some(')') {
                        return Err(UnitFault::Unfinished);
                    }
                    self.at += 1;
                    below = false;
                    expected = false;
                }
                Some('1') => {
                    self.at += 1;
                    if let Some(found) = self.peek().filter(char::is_ascii_digit) {
                        return Err(UnitFault::Stray { found, column: self.at + 1 });
                    }
                    below = false;
                    expected = false;
                }
                Some(_) => {
                    self.factor(if below { -sign } else { sign })?;
                    below = false;
                    expected = false;
                }
            }
        }
    }

    fn factor(&mut self, sign: i8) -> Result<(), UnitFault> {
        let start = self.at;
        let letter = |c: char| (c.is_alphabetic() || matches!(c, '°' | '%')) && superscript(c).is_none();
        while let Some(c) = self.peek() {
            let joined =
                c == '-' && self.at > start && self.text.get(self.at + 1).copied().is_some_and(letter);
            if !(letter(c) || joined) || (self.at > start && (c == '°' || c == '%')) {
                break;
            }
            self.at += 1;
        }
        let name: String = self.text[start..self.at].iter().collect();
        if name.is_empty() {
            let found = self.text[start];
            return Err(UnitFault::Stray { found, column: start + 1 });
        }
        let rest: String = self.text[self.at..].iter().filter(|c| !c.is_whitespace()).collect();
        let rest = rest.trim_start_matches(one_of("·\u{22c5}*"));
        // Above a second `r` is a radian to some and a turn to others; what is right of it does not matter.
        let lower = rest.to_lowercase();
        let rest = if self.any_case { lower.as_str() } else { rest };
        let second = rest.strip_prefix('/').unwrap_or(rest).trim_start_matches('(');
        let second = second.strip_prefix("sec").or_else(|| second.strip_prefix('s'));
        let per_second = second.is_some_and(|more| !more.starts_with(char::is_alphabetic));
        if (name == "r" || (name == "R" && self.any_case)) && per_second {
            let tail: String = self.text[self.at..].iter().collect();
            return Err(UnitFault::Either {
                name: format!("{name}{tail}"),
                either: vec![format!("rad{tail}"), format!("rev{tail}")],
            });
        }
        // r/min, U/min, U/s: there these letters are a turn.
        let turns = || {
            ["/min", "/s", "min-1", "min^-1", "min^(-1)", "min⁻¹", "s-1", "s^-1", "s^(-1)", "s⁻¹"]
                .contains(&rest)
        };
        // kgm^2 is kg m^2: the exponent belongs to the metre
        if let Some((_, mass, length)) =
            [("kgm", "kg", "m"), ("slugft", "slug", "ft")].iter().find(|(n, ..)| *n == name)
        {
            let exponent = self.exponent()?;
            for (name, e) in [(mass, 1), (length, exponent)] {
                let (row, prefix, ten) = look_up(name).ok_or(UnitFault::Unfinished)?;
                self.push(row, prefix, ten, sign * e)?;
            }
            return Ok(());
        }
        let found =
            if matches!(name.as_str(), "r" | "U" | "u") && turns() { look_up("rev") } else { look_up(&name) };
        let (row, prefix, ten) = match found {
            Some(found) => found,
            None if self.any_case => {
                let (found, forgiven) = any_case(&name, start + 1)?;
                self.forgiven |= forgiven;
                found
            }
            None => return Err(unknown(&name, start + 1)),
        };
        let exponent = self.exponent()?;
        self.push(row, prefix, ten, exponent.checked_mul(sign).ok_or(UnitFault::TooLarge)?)
    }

    /// `^2`, `**-1`, `²`, `⁻¹`, or a plain digit after the name (`m/s2`, `s-1`); 1 if there is none.
    fn exponent(&mut self) -> Result<i8, UnitFault> {
        let column = self.at + 1;
        let mut negative = false;
        if self.peek() == Some('\u{207b}') || self.peek().and_then(superscript).is_some() {
            if self.peek() == Some('\u{207b}') {
                negative = true;
                self.at += 1;
            }
            let n = self.peek().and_then(superscript).ok_or(UnitFault::Exponent { column })?;
            self.at += 1;
            if self.peek().and_then(superscript).is_some() {
                return Err(UnitFault::Exponent { column });
            }
            return Ok(if negative { -n } else { n });
        }
        let mut caret = false;
        if self.peek() == Some('^') {
            self.at += 1;
            caret = true;
        } else if self.text[self.at..].starts_with(&['*', '*']) {
            self.at += 2;
            caret = true;
        }
        let open = caret && self.peek() == Some('(');
        if open {
            self.at += 1;
        }
        let digit_at = |k: usize| self.text.get(k).and_then(|c| c.to_digit(10));
        if self.peek().is_some_and(is_minus) && (caret || digit_at(self.at + 1).is_some()) {
            negative = true;
            self.at += 1;
        }
        let Some(n) = self.peek().and_then(|c| c.to_digit(10)) else {
            return if caret || negative { Err(UnitFault::Exponent { column }) } else { Ok(1) };
        };
        self.at += 1;
        if self.peek().is_some_and(|c| c.is_ascii_digit()) {
            return Err(UnitFault::Exponent { column });
        }
        if open {
            if self.peek() != Some(')') {
                return Err(UnitFault::Unfinished);
            }
            self.at += 1;
        }
        let n = n as i8; // one digit
        Ok(if negative { -n } else { n })
    }

    fn push(&mut self, row: &UnitRow, prefix: &'static str, ten: i16, exponent: i8) -> Result<(), UnitFault> {
        if self.factors.len() >= 8 {
            return Err(UnitFault::TooLarge);
        }
        let one = UnitScale { num: 1, den: 1, ten, pi: 0 }.times(row.scale).ok_or(UnitFault::TooLarge)?;
        let one = if exponent < 0 { one.inverse().ok_or(UnitFault::TooLarge)? } else { one };
        for _ in 0..exponent.unsigned_abs() {
            self.scale = self.scale.times(one).ok_or(UnitFault::TooLarge)?;
        }
        for (axis, e) in self.dimension.iter_mut().zip(row.dimension.0) {
            let step = e.checked_mul(exponent).ok_or(UnitFault::TooLarge)?;
            *axis = axis.checked_add(step).ok_or(UnitFault::TooLarge)?;
        }
        if exponent == 0 {
            return Ok(());
        }
        // `Nm` is shown as `N m`, `kmh` as `km/h`: shown names may themselves be products
        let mut sign = exponent;
        for (i, part) in row.ascii.split('/').enumerate() {
            if i == 1 {
                sign = exponent.saturating_neg();
            }
            for (j, name) in part.split(' ').enumerate() {
                let name = if i == 0 && j == 0 { format!("{prefix}{name}") } else { name.to_owned() };
                self.factors.push((name.into(), sign));
            }
        }
        Ok(())
    }
}

type KnownUnit = (&'static UnitRow, &'static str, i16);

fn look_up(name: &str) -> Option<KnownUnit> {
    if let Some(row) = ROWS.iter().find(|r| r.names.contains(&name)) {
        return Some((row, "", 0));
    }
    let first = name.chars().next()?;
    let rest = &name[first.len_utf8()..];
    let row = ROWS.iter().find(|r| r.names.contains(&rest) && r.prefixes.contains(first))?;
    let (_, ascii, ten) = PREFIXES.iter().find(|(c, _, _)| *c == first)?;
    Some((row, ascii, *ten))
}

/// Every name of a unit that is read, with each of its prefixes.
pub fn names() -> impl Iterator<Item = String> {
    let named = ROWS.iter().flat_map(|r| r.names.iter().map(move |name| (r, name)));
    named.flat_map(|(r, name)| {
        let prefixed = r.prefixes.chars().map(move |p| format!("{p}{name}"));
        std::iter::once((*name).to_owned()).chain(prefixed)
    })
}

fn unknown(name: &str, column: usize) -> UnitFault {
    let known: Vec<String> = names().filter(|n| !n.starts_with(one_of("\u{b5}\u{3bc}"))).collect();
    let close = known.iter().find(|k| k.to_lowercase() == name.to_lowercase()).cloned();
    // Revolutions, and not one of the names that look alike.
    let close = close.or_else(|| name.eq_ignore_ascii_case("rps").then(|| "rev/s".to_owned()));
    let close = close.or_else(|| spell::closest(name, known.iter().map(String::as_str)).map(str::to_owned));
    UnitFault::Unknown { name: name.chars().take(24).collect(), column, close }
}

/// A name read without regard to case, if all readings are the same unit.
fn any_case(name: &str, column: usize) -> Result<(KnownUnit, bool), UnitFault> {
    let mut found: Vec<(String, KnownUnit)> = Vec::new();
    let lower = name.to_lowercase();
    let mut add = |spelling: String, row: &'static UnitRow, prefix: &'static str, ten: i16| {
        if spelling.to_lowercase() == lower
            && !found.iter().any(|(_, (r, _, t))| {
                r.dimension == row.dimension
                    && r.scale.ten + t == row.scale.ten + ten
                    && r.scale.num == row.scale.num
            })
        {
            found.push((spelling, (row, prefix, ten)));
        }
    };
    for (row, name) in ROWS.iter().flat_map(|row| row.names.iter().map(move |name| (row, *name))) {
        add(name.to_owned(), row, "", 0);
        for (c, ascii, ten) in PREFIXES.iter().filter(|(c, _, _)| row.prefixes.contains(*c)) {
            add(format!("{c}{name}"), row, ascii, *ten);
        }
    }
    match found.len() {
        0 => Err(unknown(name, column)),
        1 => Ok((found.remove(0).1, true)),
        _ => Err(UnitFault::CaseMatters {
            name: name.chars().take(24).collect(),
            either: found.into_iter().map(|(s, _)| s).collect(),
        }),
    }
}
