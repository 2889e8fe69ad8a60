//! Phrases by name, in one language: what the program says to students and in pictures, with places to fill in.
//!
//! A phrase is a line of a word list, `templates/words/TOPIC.yaml` (other languages: `templates/LANGUAGE/words/TOPIC.yaml`);
//! its name is the topic, a point, and the name in the list: `figure.wheel`. `{place}` in a phrase is filled in. A language is
//! complete or it does not build: every name of the English lists, with the same places, is checked by a test.
#[cfg(feature = "program")]
mod lists;
pub mod plain;

use rustc_hash::FxHashMap;
use serde::Serialize;
use serde_json::Value;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Phrases below a name, as the list nests them: for templates.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PhraseTree<'w> {
    /// A phrase.
    Phrase(&'w str),
    /// Phrases by name.
    Branch(BTreeMap<&'w str, PhraseTree<'w>>),
}

impl<'w> PhraseTree<'w> {
    fn put(&mut self, mut names: std::str::Split<'w, char>, phrase: &'w str) {
        match (names.next(), self) {
            (None, leaf) => *leaf = Self::Phrase(phrase),
            (Some(name), Self::Branch(below)) => {
                below.entry(name).or_insert_with(|| Self::Branch(BTreeMap::new())).put(names, phrase);
            }
            // A list cannot hold a phrase and phrases below it under one name.
            (Some(_), Self::Phrase(_)) => {}
        }
    }
}

/// The phrases of one language.
#[derive(Debug, Clone)]
pub struct Words {
    language: Cow<'static, str>,
    decimal: char,
    phrases: FxHashMap<String, String>,
}

/// Phrases by name in one language, as they are handed to a page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Phrases {
    /// Code of the language.
    pub language: String,
    /// The mark between whole and parts of a number.
    pub decimal: char,
    /// The phrases.
    pub phrases: BTreeMap<String, String>,
}

impl Words {
    /// A word of a key (`up`, `yes`) as the sheet says it.
    pub fn of_key<'w>(&'w self, word: &'w str) -> &'w str {
        match word {
            "up" => self.get("sheet.up"),
            "down" => self.get("sheet.down"),
            "forward" => self.get("sheet.forward"),
            "back" => self.get("sheet.back"),
            "stays" => self.get("sheet.stays"),
            "yes" => self.get("sheet.yes"),
            "no" => self.get("sheet.no"),
            other => other,
        }
    }
    /// Phrases that are handed to a page, from what [`Phrases`] are in JSON; `None` where they are none.
    pub fn handed(phrases: &Value) -> Option<Self> {
        let language = Cow::Owned(phrases["language"].as_str()?.to_owned());
        let decimal = phrases["decimal"].as_str()?.chars().next()?;
        let named = |(name, text): (&String, &Value)| Some((name.clone(), text.as_str()?.to_owned()));
        let phrases = phrases["phrases"].as_object()?.iter().map(named).collect::<Option<_>>()?;
        Some(Self { language, decimal, phrases })
    }

    /// The phrases whose names begin so (`feedback`, `report.verdict`), to be handed on.
    pub fn phrases(&self, below: &[&str]) -> Phrases {
        let is_below =
            |name: &str, begin: &str| name.strip_prefix(begin).is_some_and(|rest| rest.starts_with('.'));
        let wanted = |name: &&str| below.iter().any(|begin| is_below(name, begin));
        let names = self.names().into_iter().filter(wanted);
        let phrases = names.map(|name| (name.to_owned(), self.get(name).to_owned())).collect();
        Phrases { language: self.language.clone().into_owned(), decimal: self.decimal, phrases }
    }

    /// Code of the language, such as `en`.
    pub fn language(&self) -> &str {
        &self.language
    }

    /// The mark between whole and parts of a number.
    pub fn decimal(&self) -> char {
        self.decimal
    }

    /// A phrase without places.
    ///
    /// # Panics
    /// No phrase of this name: a bug, found by the test that names all.
    pub fn get(&self, name: &str) -> &str {
        match self.phrases.get(name) {
            Some(phrase) => phrase,
            None => panic!("the word lists of {} have no phrase {name}", self.language),
        }
    }

    /// The phrases of a topic.
    pub fn tree(&self, topic: &str) -> PhraseTree<'_> {
        let mut tree = PhraseTree::Branch(BTreeMap::new());
        for name in self.names() {
            let mut names = name.split('.');
            if names.next() == Some(topic) {
                tree.put(names, self.get(name));
            }
        }
        tree
    }

    /// The same phrases, but for one in whose place another stands.
    #[must_use]
    pub fn with(mut self, name: &str, instead: &str) -> Self {
        let other = self.get(instead).to_owned();
        self.phrases.insert(name.to_owned(), other);
        self
    }

    /// Is there a phrase of this name?
    pub fn has(&self, name: &str) -> bool {
        self.phrases.contains_key(name)
    }

    /// A phrase with its places filled in.
    pub fn say(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        let mut out = String::new();
        let mut rest = self.get(name);
        while let Some(open) = rest.find('{') {
            out.push_str(&rest[..open]);
            rest = &rest[open..];
            let piece = rest.find('}').and_then(|close| {
                let place = &rest[1..close];
                let (_, text) = pieces.iter().find(|(p, _)| *p == place)?;
                Some((close, text))
            });
            match piece {
                Some((close, text)) => {
                    out.push_str(text);
                    rest = &rest[close + 1..];
                }
                None => {
                    out.push('{');
                    rest = &rest[1..];
                }
            }
        }
        out.push_str(rest);
        out
    }

    /// A number written with a point, with the mark of the language: `0.25` is `0,25` in German.
    pub fn number(&self, text: &str) -> String {
        if self.decimal == '.' { text.to_owned() } else { text.replace('.', &self.decimal.to_string()) }
    }

    /// The same within a formula, where a bare comma would get the space of a list: `0{,}25`.
    pub fn tex_number(&self, text: &str) -> String {
        if self.decimal == '.' {
            text.to_owned()
        } else {
            text.replace('.', &format!("{{{}}}", self.decimal))
        }
    }

    /// Names of all phrases, sorted.
    pub fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.phrases.keys().map(String::as_str).collect();
        names.sort_unstable();
        names
    }
}

/// The places of a phrase, in order.
pub fn places(phrase: &str) -> Vec<&str> {
    let mut found: Vec<&str> = Vec::new();
    for part in phrase.split('{').skip(1) {
        if let Some((place, _)) = part.split_once('}')
            && !place.is_empty()
            && place.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && !found.contains(&place)
        {
            found.push(place);
        }
    }
    found
}
