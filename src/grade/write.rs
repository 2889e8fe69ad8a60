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

/// `-62,6`, `-62.6 N` and their like: a sign, a number, perhaps a unit that begins with a letter; nothing that a
/// spreadsheet could run, as it would `-2/A1`.
fn signed_quantity(text: &[u8]) -> bool {
    let [b'+' | b'-', rest @ ..] = text else { return false };
    let digits = |t: &[u8]| t.iter().take_while(|b| b.is_ascii_digit() || matches!(b, b'.' | b',')).count();
    let mut at = digits(rest);
    if at == 0 {
        return false;
    }
    if let [b'e' | b'E', more @ ..] = &rest[at..] {
        let signed = usize::from(matches!(more.first(), Some(b'+' | b'-')));
        let exponent = digits(&more[signed..]);
        if exponent > 0 {
            at += 1 + signed + exponent;
        }
    }
    let unit = rest[at..].trim_ascii_start();
    unit.is_empty()
        || unit == b"%"
        || (unit.first().is_some_and(|b| b.is_ascii_alphabetic() || !b.is_ascii())
            && unit.iter().enumerate().all(|(i, b)| match b {
                b'.' | b' ' | b'/' | b'^' => true,
                b'-' => i > 0 && unit[i - 1] == b'^',
                _ => b.is_ascii_alphanumeric() || !b.is_ascii(),
            }))
}

/// Does a spreadsheet take it for a formula, or for what may become one? The wide signs `＝ ＋ － ＠` count as well.
fn begins_oddly(text: &[u8]) -> bool {
    matches!(
        text,
        [b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r' | b'\n', ..] | [0xef, 0xbc, 0x9d | 0x8b | 0x8d | 0xa0, ..]
    )
}

/// A field of CSV: quoted where needed, and harmless to a spreadsheet: what begins with `= + - @` and is neither a number
/// nor a number with a unit gets an apostrophe in front.
pub(crate) fn push_text(out: &mut Vec<u8>, text: &[u8]) {
    let number = || {
        plain_number(text).is_some()
            || std::str::from_utf8(text).is_ok_and(|t| t.parse::<f64>().is_ok_and(f64::is_finite))
    };
    let guard = begins_oddly(text) && !number() && !signed_quantity(text);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_texts_and_numbers_stay_numbers() {
        let shown = |text: &str| {
            let mut out = Vec::new();
            push_text(&mut out, text.as_bytes());
            String::from_utf8(out).unwrap()
        };
        for text in [
            "-62.6",
            "+3e5",
            "-62.6 N",
            "-1.2e-3 m/s^2",
            "+4 kg m^2 s^-2",
            "-5 %",
            "-30°",
            "-3,5",
            "-.5 N",
            "30.3",
        ] {
            assert!(!shown(text).contains('\''), "{text}");
        }
        for text in [
            "=cmd|' /C calc'!A0",
            "+1+1",
            "-2+3",
            "@SUM(1)",
            "\t=1",
            "\r=1",
            "\n=1",
            "=1",
            "-A1",
            "-2/A1",
            "-5^2",
            "-2*3",
            "-1e5/A1",
            "-1e+5/A1",
            "+cmd|x",
            "-",
            "+",
            "-5%/A1",
            "-3 N+1",
            "-3 N(1)",
            "-3 N!A1",
            "＝1+1",
            "＋1+1",
            "－2+3",
            "＠SUM(1)",
        ] {
            let shown = shown(text);
            assert!(shown.trim_start_matches('"').starts_with('\''), "{text:?}: {shown}");
        }
    }
}
