//! Fields of CSV as bytes: no formatting where a number will do, nothing that a spreadsheet would run.
use crate::answer::read::plain_number;

/// A whole number.
pub(crate) fn push_number(out: &mut Vec<u8>, mut number: u64) {
    let mut digits = [0u8; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

/// Points: whole numbers without a point.
pub(crate) fn push_float(out: &mut Vec<u8>, value: f64) {
    if (0.0..1e15).contains(&value) && value.fract() <= 0.0 {
        push_number(out, value as u64);
    } else {
        out.extend_from_slice(value.to_string().as_bytes());
    }
}

/// `-62.6 N` and its like: a sign, a number, letters; nothing that a spreadsheet could run.
fn signed_quantity(text: &[u8]) -> bool {
    let [b'+' | b'-', rest @ ..] = text else { return false };
    let exponent = |i: usize| i > 0 && matches!(rest[i - 1], b'e' | b'E' | b'^');
    rest.first().is_some_and(|b| b.is_ascii_digit() || *b == b'.')
        && rest.iter().enumerate().all(|(i, b)| match b {
            b'.' | b',' | b' ' | b'/' | b'^' | b'%' => true,
            b'+' | b'-' => exponent(i),
            _ => b.is_ascii_alphanumeric() || !b.is_ascii(),
        })
}

/// A field of CSV: quoted where needed, and harmless to a spreadsheet: what begins with `= + - @` and is neither a number
/// nor a number with a unit gets an apostrophe in front.
pub(crate) fn push_text(out: &mut Vec<u8>, text: &[u8]) {
    let odd = matches!(text.first(), Some(b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r'));
    let number = || {
        plain_number(text).is_some()
            || std::str::from_utf8(text).is_ok_and(|t| t.parse::<f64>().is_ok_and(f64::is_finite))
    };
    let guard = odd && !number() && !signed_quantity(text);
    let space = |b: Option<&u8>| matches!(b, Some(b' '));
    let quote = text.iter().any(|b| matches!(b, b',' | b'"' | b'\n' | b'\r'))
        || space(text.first())
        || space(text.last());
    if quote {
        out.push(b'"');
    }
    if guard {
        out.push(b'\'');
    }
    if quote {
        for b in text {
            if *b == b'"' {
                out.push(b'"');
            }
            out.push(*b);
        }
        out.push(b'"');
    } else {
        out.extend_from_slice(text);
    }
}
