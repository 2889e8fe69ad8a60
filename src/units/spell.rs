//! "Did you mean": the closest of some words, only when it is close.

/// The closest of `known` to `word`: one slip (a letter inserted, left out or changed, or two neighbours swapped) for words
/// of three to five letters, two for longer ones, none for shorter ones; letters' case does not count. Ties are
/// broken by name.
pub fn closest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let allowed = match word.chars().count() {
        3..=5 => 1,
        6..=64 => 2,
        _ => return None,
    };
    let slips = |k: &str| strsim::osa_distance(&word, &k.to_lowercase());
    known.into_iter().map(|k| (slips(k), k)).filter(|(d, _)| *d <= allowed).min().map(|(_, k)| k)
}

/// A hint for a word that is not known: the closest one, or all of them behind what they are (`its parts: a, omega`).
pub fn hint<'a>(word: &str, what: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    match closest(word, known.clone()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("{what}: {}", known.collect::<Vec<_>>().join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_when_close() {
        let known = ["omega", "friction", "v", "v_max"];
        assert_eq!(closest("omgea", known), Some("omega"));
        assert_eq!(closest("Fricton", known), Some("friction"));
        assert_eq!(closest("vx", known), None);
        assert_eq!(closest("tension", known), None);
    }
}
