//! Markdown with formulas as plain text: for terminals, and for hints in a page.

/// The text without marks of Markdown, formulas written with the signs that plain text has.
pub fn plain(markdown: &str) -> String {
    let mut out = String::with_capacity(markdown.len());
    let mut math = false;
    let mut rest = markdown;
    const SIGNS: [(&str, &str); 29] = [
        (r"\ ", " "),
        (r"\,", " "),
        (r"{}^\circ", "°"),
        (r"^\circ", "°"),
        ("{,}", ","),
        (r"\mathrm", ""),
        (r"\frac", ""),
        ("}{", "/"),
        (r"\sqrt", "√"),
        (r"\times", "×"),
        (r"\cdot", "·"),
        (r"\sin", "sin "),
        (r"\cos", "cos "),
        (r"\tan", "tan "),
        (r"\rho", "ρ"),
        (r"\pi", "π"),
        (r"\le", "≤"),
        (r"\ge", "≥"),
        (r"\theta", "θ"),
        (r"\omega", "ω"),
        (r"\alpha", "α"),
        (r"\phi", "φ"),
        (r"\mu", "μ"),
        (r"\%", "%"),
        ("^{2}", "²"),
        ("^2", "²"),
        ("{", ""),
        ("}", ""),
        (r"\", ""),
    ];
    while let Some(c) = rest.chars().next() {
        if c == '$' {
            math = !math;
            rest = &rest[1..];
        } else if let Some((tex, sign)) = SIGNS.iter().filter(|_| math).find(|(tex, _)| rest.starts_with(tex))
        {
            out.push_str(sign);
            rest = &rest[tex.len()..];
        } else {
            out.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    out
}
/// The beginning of a text, at most so many letters, without signs that neither a page nor a reader can show.
pub fn beginning(text: &str, most: usize) -> String {
    let shown = |c: char| match c {
        '\n' | '\r' | '\t' => ' ',
        c if c.is_control() || noncharacter(c) => '\u{fffd}',
        c => c,
    };
    let mut out: String = text.chars().take(most).map(shown).collect();
    if text.chars().nth(most).is_some() {
        out.push('…');
    }
    out
}

fn noncharacter(c: char) -> bool {
    let code = u32::from(c);
    (0xfdd0..=0xfdef).contains(&code) || code & 0xfffe == 0xfffe
}

/// What stands in the places of a phrase, `rounded to {n} figures`, if a text is that phrase; a last place takes all that follows.
pub fn in_places<'t>(phrase: &str, text: &'t str) -> Option<Vec<&'t str>> {
    let mut pieces = phrase.split('{');
    let mut rest = text.strip_prefix(pieces.next()?)?;
    let mut found = Vec::new();
    for piece in pieces {
        let fixed = piece.split_once('}').map_or("", |(_, fixed)| fixed);
        let end = if fixed.is_empty() { rest.len() } else { rest.find(fixed)? };
        found.push(&rest[..end]);
        rest = &rest[end + fixed.len()..];
    }
    rest.is_empty().then_some(found)
}

/// The first letter large.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
