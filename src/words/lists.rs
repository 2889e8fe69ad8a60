//! The word lists that are built in, and an instructor's own over them.
use crate::bank::node::{Node, Value};
use crate::bank::yaml;
use crate::finding::{Finding, Findings};
use crate::words::{Words, places};
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::sync::LazyLock;

/// The word lists below a folder, by topic.
macro_rules! lists {
    ($folder:literal) => {
        lists![
            $folder: "figure", "sheet", "page", "print", "solution", "gallery", "feedback", "marks", "tutor", "index", "export",
            "report"
        ]
    };
    ($folder:literal: $($topic:literal),*) => {
        &[$(($topic, include_str!(concat!("../../templates/", $folder, "words/", $topic, ".yaml")))),*]
    };
}

/// The languages: code, name in itself, mark between whole and parts of a number, word lists by topic.
const LANGUAGES: &[(&str, &str, char, Lists)] =
    &[("en", "English", '.', lists!("")), ("de", "Deutsch", ',', lists!("de/"))];

/// The built-in lists, read once.
static READ: LazyLock<Vec<Words>> = LazyLock::new(|| Words::languages().filter_map(Words::of).collect());

/// Word lists: topic, text.
pub type Lists = &'static [(&'static str, &'static str)];

impl Words {
    /// Codes of the languages that are built in, English first.
    pub fn languages() -> impl Iterator<Item = &'static str> {
        LANGUAGES.iter().map(|(code, ..)| *code)
    }

    /// The built-in lists of a language; `None` if there is none of this code.
    ///
    /// # Panics
    /// A built-in list that cannot be read is a bug, found by any test.
    pub fn of(language: &str) -> Option<Self> {
        let (code, _, decimal, lists) = LANGUAGES.iter().find(|(code, ..)| *code == language)?;
        let mut words =
            Self { language: Cow::Borrowed(code), decimal: *decimal, phrases: FxHashMap::default() };
        for (topic, text) in *lists {
            if let Err(faults) = words.read(topic, text, false) {
                panic!("the built-in word list {topic} of {code} cannot be read: {faults:?}");
            }
        }
        Some(words)
    }

    /// The English ones.
    ///
    /// # Panics
    /// Never: English is built in.
    pub fn english() -> Self {
        Self::of("en").expect("English is built in")
    }

    /// The built-in phrases of a language for good; `None` if there is none of this code.
    pub fn built_in(language: &str) -> Option<&'static Self> {
        READ.iter().find(|words| words.language == language)
    }

    /// What solving says to instructors, in English alone: phrases of the topic `sentences`.
    pub fn sentences() -> &'static Self {
        static READ: LazyLock<Words> = LazyLock::new(|| {
            let (language, text) = (Cow::Borrowed("en"), include_str!("../../templates/sentences.yaml"));
            let mut words = Words { language, decimal: '.', phrases: FxHashMap::default() };
            if let Err(faults) = words.read("sentences", text, false) {
                panic!("the built-in sentences cannot be read: {faults:?}");
            }
            words
        });
        &READ
    }

    /// The word lists of a language: topic, text.
    pub fn lists(language: &str) -> Option<Lists> {
        LANGUAGES.iter().find(|(code, ..)| *code == language).map(|(_, _, _, lists)| *lists)
    }

    /// Puts phrases of an instructor's own list over the built-in ones. Errors: names that no phrase has, places that the phrase
    /// does not know, what is no list.
    pub fn put_over(&mut self, topic: &str, text: &str, file: &str) -> Result<(), Findings> {
        self.read(topic, text, true).map_err(|faults| faults.in_file(file))
    }

    fn read(&mut self, topic: &str, text: &str, known_only: bool) -> Result<(), Findings> {
        let tree = yaml::tree(text)?;
        let mut faults = Findings::default();
        self.branch(topic, &tree, known_only, &mut faults);
        faults.into_result(())
    }

    fn branch(&mut self, name: &str, node: &Node, known_only: bool, faults: &mut Findings) {
        match &node.value {
            Value::Map(fields) => {
                for (key, value) in fields {
                    self.branch(&format!("{name}.{}", key.text().unwrap_or("")), value, known_only, faults);
                }
            }
            Value::Text(phrase) => {
                let here = |what: String| Finding::new(name, what).at(node.line, node.column);
                if known_only {
                    let Some(old) = self.phrases.get(name) else {
                        let known = self.phrases.keys().map(String::as_str);
                        let fault = here("is no phrase of the program".to_owned());
                        faults.push(match crate::units::spell::closest(name, known) {
                            Some(close) => fault.hint(format!("did you mean {close}?")),
                            None => fault.hint(
                                "`slipstick templates` writes out all the lists; a line of an earlier version may go",
                            ),
                        });
                        return;
                    };
                    let (have, want) = (places(phrase), places(old));
                    if let Some(unknown) = have.iter().find(|p| !want.contains(p)) {
                        let list: Vec<String> = want.iter().map(|p| format!("{{{p}}}")).collect();
                        let fault = here(format!("has a place {{{unknown}}} that nothing fills"));
                        faults.push(match list.is_empty() {
                            true => fault.hint("this phrase has no places"),
                            false => fault.hint(format!("the phrase may use {}", list.join(", "))),
                        });
                        return;
                    }
                }
                self.phrases.insert(name.to_owned(), phrase.clone());
            }
            Value::Empty | Value::List(_) => {
                let fault = Finding::new(name, format!("is {}, not a phrase", node.kind()));
                faults.push(fault.at(node.line, node.column).hint("write a text in quotes"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_every_phrase_with_the_same_places() {
        let english = Words::english();
        for code in Words::languages() {
            let other = Words::of(code).expect("a language of the list");
            assert_eq!(english.names(), other.names(), "{code}");
            for name in english.names() {
                let sorted = |phrase: &str| {
                    // Who is spoken of is named with an article where a language needs one.
                    let named =
                        |place: &str| if ["the", "The"].contains(&place) { "body" } else { place }.to_owned();
                    let mut places: Vec<String> = places(phrase).into_iter().map(named).collect();
                    places.sort_unstable();
                    places
                };
                assert_eq!(sorted(english.get(name)), sorted(other.get(name)), "{code}: {name}");
            }
        }
    }

    #[test]
    fn places_are_filled_once_and_text_is_left_alone() {
        let mut words = Words::english();
        words.phrases.insert("x.y".to_owned(), "a {b} and {c}, {d}".to_owned());
        assert_eq!(words.say("x.y", &[("b", "{c}"), ("c", "2")]), "a {c} and 2, {d}");
    }

    #[test]
    fn own_phrases_must_be_known_and_use_known_places() {
        let mut words = Words::english();
        let faults = words.put_over("figure", "whele: a cart\n", "own.yaml").unwrap_err();
        assert_eq!(faults.len(), 1);
        let faults = words.put_over("figure", "wheel: [a]\n", "own.yaml").unwrap_err();
        assert_eq!(faults.len(), 1);
        words.put_over("figure", "wheel: a cart\n", "own.yaml").unwrap();
        assert_eq!(words.get("figure.wheel"), "a cart");
    }

    #[test]
    fn german_numbers_have_a_comma() {
        let german = Words::of("de").expect("German is built in");
        assert_eq!(german.number("-0.25"), "-0,25");
        assert_eq!(german.tex_number("0.25"), "0{,}25");
    }
}
