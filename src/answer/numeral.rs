//! The number at the start of a text: a decimal with its marks and power of ten, or an exact value such as `3/4` or `2*sqrt(3)`.
use crate::answer::read::WhyUnreadable;
use crate::num::decimal::{leading_whole, nearest, one_of};

/// A number without its sign, and what follows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Numeral<'t> {
    /// At least 0, finite.
    pub value: f64,
    /// Where a lone comma stands before three digits: the number if the comma only grouped digits.
    pub grouped: Option<f64>,
    /// A lone comma is the decimal mark.
    pub comma: bool,
    /// How it was read has to be told.
    pub told: bool,
    /// Digits alone, perhaps in groups.
    pub whole: bool,
    /// What follows.
    pub rest: &'t str,
}

/// Without the sign in front, and whether it is a minus.
pub(crate) fn unsigned(text: &str) -> (bool, &str) {
    (text.starts_with('-'), text.strip_prefix(one_of("-+")).unwrap_or(text).trim_start())
}

/// May a number begin here?
pub(crate) fn begins(text: &str) -> bool {
    let text = unsigned(text).1.trim_start_matches(one_of("( "));
    let text = unsigned(text).1;
    let digits = text.strip_prefix(one_of(".,")).unwrap_or(text);
    digits.starts_with(|c: char| c.is_ascii_digit()) || root(text).is_some() || pi(text).is_some()
}

/// Reads a number that has no sign.
pub(crate) fn numeral(text: &str) -> Result<Numeral<'_>, WhyUnreadable> {
    let mut exact = Exact { rest: text, told: false };
    match exact.product(0)? {
        Some(value) if exact.told && value.is_finite() => {
            Ok(Numeral { value, grouped: None, comma: false, told: true, whole: false, rest: exact.rest })
        }
        Some(_) if exact.told => Err(WhyUnreadable::NotFinite),
        _ => decimal(text),
    }
}

/// Behind the word or sign for a root.
fn root(text: &str) -> Option<&str> {
    let word = |word: &str| {
        let behind = text.get(word.len()..)?;
        let same = text.is_char_boundary(word.len()) && text[..word.len()].eq_ignore_ascii_case(word);
        (same && !behind.starts_with(char::is_alphabetic)).then_some(behind)
    };
    text.strip_prefix('√').or_else(|| word("sqrt")).or_else(|| word("wurzel"))
}

/// Behind π.
fn pi(text: &str) -> Option<&str> {
    let behind =
        text.strip_prefix('π').or_else(|| text.strip_prefix("pi")).or_else(|| text.strip_prefix("Pi"))?;
    (!behind.starts_with(char::is_alphabetic)).then_some(behind)
}

/// Reads exact values: fractions of whole numbers, roots, π, and products of these with a number. What is only a sum of
/// work, such as `2*0.625`, is a formula; what may be read in two ways, such as `1/2*3`, is refused.
struct Exact<'t> {
    rest: &'t str,
    /// More than a number stood there.
    told: bool,
}

/// A piece of a product.
#[derive(Clone, Copy, PartialEq)]
enum Factor {
    /// Digits alone.
    Whole(f64),
    /// Digits with a point.
    Decimal(f64),
    /// A root, π, or something in brackets.
    Exact(f64),
}

impl Factor {
    fn value(self) -> f64 {
        match self {
            Factor::Whole(x) | Factor::Decimal(x) | Factor::Exact(x) => x,
        }
    }
    fn is_number(self) -> bool {
        !matches!(self, Factor::Exact(_))
    }
}

impl<'t> Exact<'t> {
    /// A product with at most one fraction bar. `None`: no exact value stands here.
    fn product(&mut self, depth: u8) -> Result<Option<f64>, WhyUnreadable> {
        let Some(first) = self.factor(depth)? else { return Ok(None) };
        if let Factor::Whole(whole) = first
            && let Some(more) = self.mixed()
        {
            self.told = true;
            return if self.goes_on(depth) { Err(WhyUnreadable::Formula) } else { Ok(Some(whole + more)) };
        }
        let (mut value, mut last, mut barred) = (first.value(), first, false);
        loop {
            let behind = self.rest.trim_start();
            let times = behind.strip_prefix(one_of("*·×\u{22c5}\u{2219}"));
            let over = behind.strip_prefix('/');
            let next = times.or(over).unwrap_or(behind).trim_start();
            if times.is_none() && over.is_none() && root(next).is_none() && pi(next).is_none() {
                return Ok(Some(value)); // nothing that belongs to it
            }
            let before = self.rest;
            self.rest = next;
            let Some(factor) = self.factor(depth)? else {
                self.rest = before;
                return Ok(Some(value));
            };
            self.told = true;
            let both = [last, factor];
            let sum = match over {
                Some(_) => {
                    both.iter().all(|f| f.is_number()) && both.iter().any(|f| matches!(f, Factor::Decimal(_)))
                }
                None => both.iter().all(|f| f.is_number()),
            };
            if barred || sum {
                return Err(WhyUnreadable::Formula);
            }
            barred = over.is_some();
            value = if barred { value / factor.value() } else { value * factor.value() };
            last = factor;
        }
    }

    /// Does a product go on here?
    fn goes_on(&self, depth: u8) -> bool {
        let behind = self.rest.trim_start();
        let next = behind.strip_prefix(one_of("*·×/")).map(str::trim_start);
        let mut ahead = Exact { rest: next.unwrap_or(behind), told: false };
        (next.is_some() || root(behind).is_some() || pi(behind).is_some())
            && !matches!(ahead.factor(depth), Ok(None))
    }

    fn factor(&mut self, depth: u8) -> Result<Option<Factor>, WhyUnreadable> {
        if depth > 4 {
            return Err(WhyUnreadable::Formula);
        }
        if let Some(behind) = root(self.rest) {
            self.rest = behind.trim_start();
            let under = match self.rest.starts_with('(') {
                true => self.brackets(depth)?,
                false => self.number().map(Factor::value),
            };
            self.told = true;
            return under.map(|x| Factor::Exact(x.sqrt())).ok_or(WhyUnreadable::Formula).map(Some);
        }
        if let Some(behind) = pi(self.rest) {
            self.rest = behind;
            self.told = true;
            return Ok(Some(Factor::Exact(std::f64::consts::PI)));
        }
        if self.rest.starts_with('(') {
            let (before, told) = (self.rest, self.told);
            self.told = false;
            let found = self.brackets(depth)?;
            let inside = self.told;
            self.told = told || inside && found.is_some();
            if found.is_none() {
                self.rest = before;
            }
            let number = |x: f64| if x.fract() > 0.0 { Factor::Decimal(x) } else { Factor::Whole(x) };
            return Ok(found.map(|x| if inside { Factor::Exact(x) } else { number(x) }));
        }
        Ok(self.number())
    }

    /// A product in brackets; `None` where something else stands in them.
    fn brackets(&mut self, depth: u8) -> Result<Option<f64>, WhyUnreadable> {
        let Some(inside) = self.rest.strip_prefix('(') else { return Ok(None) };
        self.rest = inside.trim_start();
        let Some(value) = self.product(depth + 1)? else { return Ok(None) };
        let Some(behind) = self.rest.trim_start().strip_prefix(')') else { return Ok(None) };
        self.rest = behind;
        Ok(Some(value))
    }

    /// Digits, perhaps with one point; not where they go on in any other way.
    fn number(&mut self) -> Option<Factor> {
        let text = self.rest;
        let digits = |t: &str| t.bytes().take_while(u8::is_ascii_digit).count();
        let mut end = digits(text);
        if end == 0 || end > 15 {
            return None;
        }
        let mut decimal = false;
        if text[end..].starts_with('.') {
            let decimals = digits(&text[end + 1..]);
            if decimals == 0 || decimals > 15 {
                return None;
            }
            decimal = true;
            end += 1 + decimals;
        }
        let behind = &text[end..];
        let raised = behind.trim_start();
        let power = raised.starts_with('^')
            || raised.starts_with("**")
            || behind.starts_with(|c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹⁻.,'".contains(c));
        let exponent = behind
            .strip_prefix(one_of("eE"))
            .is_some_and(|t| t.trim_start_matches(one_of("+-")).starts_with(|c: char| c.is_ascii_digit()));
        // A mark at the very end is no part of the number.
        if exponent || (power && !matches!(behind, "." | "," | "'")) {
            return None;
        }
        self.rest = behind;
        let value = nearest(&text[..end])?;
        Some(if decimal { Factor::Decimal(value) } else { Factor::Whole(value) })
    }

    /// The fraction of a mixed number, `3/4` in `1 3/4`. Three digits above the bar may be a group of the whole number.
    fn mixed(&mut self) -> Option<f64> {
        let behind = self.rest.strip_prefix(' ')?.trim_start();
        let mut ahead = Exact { rest: behind, told: false };
        let Some(Factor::Whole(above)) = ahead.number() else { return None };
        let digits = behind.len() - ahead.rest.len();
        ahead.rest = ahead.rest.trim_start().strip_prefix('/')?.trim_start();
        let Some(Factor::Whole(below)) = ahead.number() else { return None };
        (digits != 3 && above < below).then(|| {
            self.rest = ahead.rest;
            above / below
        })
    }
}

/// Decimal digits with their marks, and a power of ten. A point or a comma is the decimal mark where it stands alone; where
/// both stand there, the last one is it, and the other groups digits by three, as an apostrophe or a blank does.
fn decimal(text: &str) -> Result<Numeral<'_>, WhyUnreadable> {
    let bytes = text.as_bytes();
    let digit_at = |k: usize| bytes.get(k).is_some_and(u8::is_ascii_digit);
    let mut groups: Vec<&str> = Vec::new();
    let mut marks: Vec<u8> = Vec::new(); // between the groups
    let (mut at, mut from) = (0, 0);
    while let Some(&b) = bytes.get(at) {
        let next = digit_at(at + 1);
        match b {
            b'0'..=b'9' => {}
            b' ' if bytes[at + 1..].starts_with(b"1/") || bytes[at + 1..].starts_with(b"1 /") => break, // `30.3 1/s`
            b'\'' if next && text[at..].contains(one_of("\"″")) => break, // 5'3"
            b',' | b'.' | b'\'' | b' ' if next => {
                groups.push(&text[from..at]);
                marks.push(b);
                from = at + 1;
            }
            _ => break,
        }
        at += 1;
    }
    groups.push(&text[from..at]);
    if groups.iter().all(|g| g.is_empty()) {
        return Err(WhyUnreadable::NoNumber);
    }
    let mut rest = &text[at..];
    let count = |mark: u8| marks.iter().filter(|m| **m == mark).count();
    let (commas, points) = (count(b','), count(b'.'));
    if rest.starts_with(one_of(",.")) && rest[1..].starts_with(one_of(",.")) {
        return Err(WhyUnreadable::Marks);
    }
    if commas + points == 0 && at > 0 {
        rest = rest.strip_prefix('.').unwrap_or(rest); // `5. N`
    }
    let decimal_mark = marks.last().copied().filter(|last| matches!(last, b',' | b'.') && count(*last) == 1);
    let grouping = &marks[..marks.len() - usize::from(decimal_mark.is_some())];
    if !grouping.is_empty() {
        let of_one_kind = grouping.iter().all(|m| *m == grouping[0]);
        let decimals = usize::from(decimal_mark.is_some());
        let (first, others) = (groups[0], &groups[1..groups.len() - decimals]);
        let by_three =
            (1..=3).contains(&first.len()) && !first.starts_with('0') && others.iter().all(|g| g.len() == 3);
        // A comma or a point groups only where the other one is the decimal mark.
        let twice = decimal_mark.is_none() && commas + points > 0;
        if !of_one_kind || !by_three || twice {
            return Err(if grouping.contains(&b' ') {
                WhyUnreadable::TwoNumbers
            } else {
                WhyUnreadable::Marks
            });
        }
    }
    let (whole, decimals) = match decimal_mark {
        Some(_) => groups.split_at(groups.len() - 1),
        None => (groups.as_slice(), [].as_slice()),
    };
    let (whole, decimals) = (whole.concat(), decimals.concat());
    let lone_comma = decimal_mark == Some(b',') && grouping.is_empty();
    let ambiguous =
        lone_comma && decimals.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0');
    // powers of ten
    let mut exponent = String::new();
    if let Some(tail) = rest.strip_prefix(one_of("eE")) {
        if let Some((power, tail)) = leading_whole(tail) {
            (exponent, rest) = (power, tail);
        }
    } else if let Some((power, tail)) = times_ten(rest)? {
        (exponent, rest) = (power, tail);
    }
    let parse = |digits: String| -> Result<f64, WhyUnreadable> {
        let text = if exponent.is_empty() { digits } else { format!("{digits}e{exponent}") };
        let value = nearest(&text).ok_or(WhyUnreadable::NoNumber)?;
        if value.is_finite() { Ok(value) } else { Err(WhyUnreadable::NotFinite) }
    };
    Ok(Numeral {
        value: parse(format!("{whole}.{decimals}"))?,
        grouped: if ambiguous { parse(format!("{whole}{decimals}")).ok() } else { None },
        comma: lone_comma,
        told: !grouping.is_empty(),
        whole: decimal_mark.is_none() && exponent.is_empty(),
        rest,
    })
}

fn superscript(c: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹"
        .chars()
        .zip('0'..='9')
        .find(|(s, _)| *s == c)
        .map(|(_, d)| d)
        .or((c == '\u{207b}').then_some('-'))
}

/// `×10^n`, `x 10^-3`, `·10ⁿ`, `*10**n`: the exponent and what follows.
fn times_ten(text: &str) -> Result<Option<(String, &str)>, WhyUnreadable> {
    let Some(tail) = text.trim_start().strip_prefix(one_of("\u{d7}xX*·\u{22c5}\u{2219}")) else {
        return Ok(None);
    };
    let Some(tail) = tail.trim_start().strip_prefix("10") else {
        return if tail.trim_start().starts_with(|c: char| c.is_ascii_digit()) {
            Err(WhyUnreadable::Formula)
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
        return Err(WhyUnreadable::Formula);
    };
    let tail = tail.trim_start();
    let (closing, tail) = match tail.chars().next() {
        Some('(') => (Some(')'), &tail[1..]),
        Some('{') => (Some('}'), &tail[1..]),
        _ => (None, tail),
    };
    let (power, mut rest) = leading_whole(tail).ok_or(WhyUnreadable::Formula)?;
    if let Some(closing) = closing {
        rest = rest.strip_prefix(closing).ok_or(WhyUnreadable::Formula)?;
    }
    Ok(Some((power, rest)))
}
