//! "Did you mean": the closest of some words, only when it is close.

/// The closest of `known` to `word`, other than the word itself: one slip (a letter inserted, left out or changed, or two
/// neighbours swapped) for words of three to five letters, two for longer ones, none for shorter ones; letters' case does not
/// count. Ties are broken by name.
pub fn closest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let folded = word.to_lowercase();
    let allowed = match folded.chars().count() {
        3..=5 => 1,
        6..=64 => 2,
        _ => return None,
    };
    let slips = |k: &str| strsim::osa_distance(&folded, &k.to_lowercase());
    let others = known.into_iter().filter(|k| *k != word);
    others.map(|k| (slips(k), k)).filter(|(d, _)| *d <= allowed).min().map(|(_, k)| k)
}

/// A hint for a word that is not known here: the closest one, if one is close. For findings only, of which a page tells none.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    if cfg!(not(feature = "program")) {
        return None;
    }
    closest(word, known).map(|near| format!("did you mean `{near}`?"))
}

/// The same, or all that are known behind what they are (`its parts: a, omega`).
pub fn hint<'a>(word: &str, what: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    if cfg!(not(feature = "program")) {
        return String::new();
    }
    did_you_mean(word, known.clone())
        .unwrap_or_else(|| format!("{what}: {}", known.collect::<Vec<_>>().join(", ")))
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
