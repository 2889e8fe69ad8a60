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
