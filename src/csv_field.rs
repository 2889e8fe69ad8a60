//! Fields of CSV that no spreadsheet runs, written and read back: what looks like a formula gets an apostrophe in front.

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
            // `1e5cmd` begins like a number and is none.
            if rest.get(at).is_some_and(u8::is_ascii_alphanumeric) {
                return false;
            }
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
#[inline]
fn begins_oddly(text: &[u8]) -> bool {
    matches!(
        text,
        [b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r' | b'\n', ..] | [0xef, 0xbc, 0x9d | 0x8b | 0x8d | 0xa0, ..]
    )
}

/// Does a text need an apostrophe in front? One that needs it and already has apostrophes of its own gets one more, so that
/// exactly one can be taken off again.
#[inline]
fn needs_guard(text: &[u8]) -> bool {
    match text {
        [b'\'', ..] => {
            let apostrophes = text.iter().take_while(|b| **b == b'\'').count();
            needs_guard(&text[apostrophes..])
        }
        _ => begins_oddly(text) && !signed_quantity(text),
    }
}

/// Appends a field: `quoted`, or where `delimiter` or blanks at an end demand it, and harmless to a spreadsheet: what begins with
/// `= + - @` and is neither a number nor a number with a unit gets an apostrophe in front.
pub fn push_field(out: &mut Vec<u8>, text: &[u8], delimiter: u8, quoted: bool) {
    let guard = needs_guard(text);
    let space = |b: Option<&u8>| matches!(b, Some(b' '));
    let quote = quoted
        || text.iter().any(|b| *b == delimiter || matches!(b, b'"' | b'\n' | b'\r'))
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

/// Appends a field of a file whose fields are separated by commas.
pub fn push_text(out: &mut Vec<u8>, text: &[u8]) {
    push_field(out, text, b',', false);
}

/// Appends a line of such a file.
pub fn push_line<S: AsRef<str>>(out: &mut Vec<u8>, fields: impl IntoIterator<Item = S>) {
    for (i, field) in fields.into_iter().enumerate() {
        if i > 0 {
            out.push(b',');
        }
        push_text(out, field.as_ref().as_bytes());
    }
    out.push(b'\n');
}

/// A field as it was before it was written: without the apostrophe that keeps a spreadsheet from running it.
#[inline]
pub fn unguarded(text: &str) -> &str {
    match text.strip_prefix('\'') {
        Some(rest) if needs_guard(rest.as_bytes()) => rest,
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shown(text: &str) -> String {
        let mut out = Vec::new();
        push_text(&mut out, text.as_bytes());
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn formulas_are_texts_and_numbers_stay_numbers() {
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
            "'30.3",
            "O'Brien",
        ] {
            let shown = shown(text);
            assert_eq!(shown.trim_matches('"'), text);
            assert_eq!(unguarded(text), text);
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
            "+1e5cmd",
            "-1E-5x y",
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
            "'=1",
            "''@x",
        ] {
            let shown = shown(text);
            assert!(shown.trim_start_matches('"').starts_with('\''), "{text:?}: {shown}");
            assert_eq!(unguarded(&format!("'{text}")), text);
        }
    }

    proptest! {
        /// An apostrophe of the writer's own must not be lost, nor one of the guard kept; both look alike in the file.
        #[test]
        fn what_is_written_is_read_back(texts in prop::collection::vec("['=+@\t＝1-]{0,3}\\PC{0,6}", 1..5), semicolon: bool) {
            let delimiter = if semicolon { b';' } else { b',' };
            let mut out = Vec::new();
            for text in &texts {
                push_field(&mut out, text.as_bytes(), delimiter, text.len() > 4);
                out.push(delimiter);
            }
            let mut reader = csv::ReaderBuilder::new().has_headers(false).delimiter(delimiter).from_reader(out.as_slice());
            let record = reader.records().next().unwrap().unwrap();
            let back: Vec<&str> = record.iter().take(texts.len()).map(unguarded).collect();
            prop_assert_eq!(back, texts);
        }
    }
}
