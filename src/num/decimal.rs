//! Decimal numbers as they are written.

/// Is a character one of these?
pub fn one_of(these: &'static str) -> impl Fn(char) -> bool + Copy {
    move |c| these.contains(c)
}

/// The whole number at the start of a text, with its minus, and what follows.
pub fn leading_whole(text: &str) -> Option<(String, &str)> {
    let number = text.strip_prefix(one_of("-+\u{2212}")).unwrap_or(text);
    let length = number.bytes().take_while(u8::is_ascii_digit).count();
    let sign = if text.starts_with(one_of("-\u{2212}")) { "-" } else { "" };
    (length > 0).then(|| (format!("{sign}{}", &number[..length]), &number[length..]))
}

/// A whole number as a power of ten: of one beyond all doubles it does not matter by how much.
pub fn power_of_ten(whole: &str) -> i32 {
    let most = if whole.starts_with('-') { -100_000 } else { 100_000 };
    whole.parse().unwrap_or(most).clamp(-100_000, 100_000)
}

/// The double nearest to a decimal number such as `-1.5e-7`, ties to even; `None` of what is no number.
pub fn nearest(text: &str) -> Option<f64> {
    text.parse().ok()
}
