//! What is said of an answer, in one language: phrases that every other row needs are looked up once, and no reason is
//! built where a phrase will do. Verdicts are not translated: scripts read them.
use crate::answer::read::WhyUnreadable;
#[cfg(feature = "program")]
use crate::grade::verdict::Verdict;
use crate::num::decimal::nearest;
use crate::units::{Unit, UnitFault, UnitKind, UnitSlip};
use crate::words::Words;
use crate::words::plain::beginning;
use std::borrow::Cow;
#[cfg(feature = "program")]
use std::sync::LazyLock;

/// The phrases of the topic `feedback`, ready for many rows.
#[derive(Debug, Clone)]
pub struct Feedback<'w> {
    words: &'w Words,
    pub(crate) within: &'w str,
    pub(crate) outside: &'w str,
    pub(crate) other_sign: &'w str,
    pub(crate) no_sign: &'w str,
}

#[cfg(feature = "program")]
static ENGLISH: LazyLock<Feedback<'static>> =
    LazyLock::new(|| Feedback::new(Words::built_in("en").expect("English is built in")));

impl<'w> Feedback<'w> {
    /// Looks up what is needed often.
    pub fn new(words: &'w Words) -> Self {
        Self {
            words,
            within: words.get("feedback.within"),
            outside: words.get("feedback.outside"),
            other_sign: words.get("feedback.other_sign"),
            no_sign: words.get("feedback.no_sign"),
        }
    }

    /// The English one.
    #[cfg(feature = "program")]
    pub fn english() -> &'static Feedback<'static> {
        &ENGLISH
    }

    /// A phrase without places, by its whole name.
    pub fn get(&self, name: &str) -> &'w str {
        self.words.get(name)
    }

    /// A phrase with its places filled in.
    pub fn fill(&self, name: &str, pieces: &[(&str, &str)]) -> Cow<'w, str> {
        Cow::Owned(self.words.say(name, pieces))
    }

    /// A word of a key (`up`, `yes`) in this language.
    pub fn word<'t>(&self, word: &'t str) -> &'t str
    where
        'w: 't,
    {
        match word {
            "right" => self.words.get("feedback.to_the_right"),
            "left" => self.words.get("feedback.to_the_left"),
            "clockwise" => self.words.get("feedback.clockwise"),
            "counter-clockwise" => self.words.get("feedback.counter_clockwise"),
            other => self.words.of_key(other),
        }
    }

    /// The words that are offered: `up, down`.
    pub fn offered(&self, offered: &[&str]) -> String {
        let words: Vec<&str> = offered.iter().map(|w| self.word(w)).collect();
        words.join(", ")
    }

    /// A number as this language writes it.
    pub fn number(&self, value: f64) -> String {
        self.words.number(&value.to_string())
    }

    /// A number as it was read, with its unit: ten figures, which nobody who writes a fraction or a root exceeds.
    pub fn read_as(&self, value: f64, unit: &str) -> String {
        let rounded = nearest(&format!("{value:.9e}")).unwrap_or(value);
        let plain = rounded == 0.0 || (1e-5..1e16).contains(&rounded.abs());
        let text = if plain { format!("{rounded}") } else { format!("{rounded:e}") };
        let number = self.words.number(&text);
        if unit == "1" { number } else { format!("{number} {unit}") }
    }

    /// Is a decimal comma worth a note?
    pub fn comma_is_odd(&self) -> bool {
        self.words.decimal() != ','
    }

    /// Why a cell cannot be read.
    pub fn why(&self, why: &WhyUnreadable) -> Cow<'w, str> {
        Cow::Borrowed(self.get(match why {
            WhyUnreadable::TooLong => "feedback.too_long",
            WhyUnreadable::NoNumber => "feedback.no_number",
            WhyUnreadable::NotFinite => "feedback.not_finite",
            WhyUnreadable::Marks => "feedback.marks",
            WhyUnreadable::TwoNumbers => "feedback.two_numbers",
            WhyUnreadable::Formula => "feedback.formula",
            WhyUnreadable::OddWord => "feedback.odd_word",
            WhyUnreadable::SignAndWord { size, unit, word } => {
                let mut size = self.words.number(size);
                if !unit.is_empty() {
                    size.push_str(&format!(" {unit}"));
                }
                let [way, other] = [*word, word.opposite()].map(|w| self.word(w.as_str()).to_owned());
                return self
                    .fill("feedback.sign_and_word", &[("size", &size), ("way", &way), ("other", &other)]);
            }
            WhyUnreadable::Lacking(sign) => {
                return self.fill("feedback.lacking", &[("sign", &sign.to_string())]);
            }
            WhyUnreadable::Bound => "feedback.bound",
            WhyUnreadable::Dot => "feedback.dot",
            WhyUnreadable::Hex => "feedback.hex",
            WhyUnreadable::Prime => "feedback.prime",
            WhyUnreadable::Full { part, whole } => {
                return self.fill("feedback.full", &[("part", part), ("whole", whole)]);
            }
            WhyUnreadable::Unit(fault) => return self.unit(fault),
        }))
    }

    fn unit(&self, fault: &UnitFault) -> Cow<'w, str> {
        match fault {
            UnitFault::Empty => Cow::Borrowed(self.get("feedback.unit_empty")),
            UnitFault::Unknown { name, close: Some(close), .. } => {
                self.fill("feedback.unit_close", &[("name", name), ("close", close)])
            }
            // A column would count in the unit, not in the cell.
            UnitFault::Unknown { name, close: None, .. } => {
                self.fill("feedback.unit_unknown", &[("name", name)])
            }
            UnitFault::CaseMatters { name, either } => {
                let either = either.join(self.get("feedback.unit_or"));
                self.fill("feedback.unit_case", &[("name", name), ("either", &either)])
            }
            UnitFault::Either { name, either } => {
                let either = either.join(self.get("feedback.unit_or"));
                self.fill("feedback.unit_either", &[("name", name), ("either", &either)])
            }
            UnitFault::Stray { found, .. } => {
                let found = beginning(&found.to_string(), 1);
                self.fill("feedback.unit_stray", &[("found", &found)])
            }
            UnitFault::Exponent { column } => {
                self.fill("feedback.unit_exponent", &[("column", &column.to_string())])
            }
            UnitFault::Unfinished => Cow::Borrowed(self.get("feedback.unit_unfinished")),
            UnitFault::TooLarge => Cow::Borrowed(self.get("feedback.unit_too_long")),
        }
    }

    /// What is wrong with a unit of another kind.
    pub fn mismatch(&self, expected: &Unit, found: &Unit) -> Cow<'w, str> {
        let named = |unit: &Unit| match unit.kind() {
            UnitKind::Named(kind) => {
                format!(
                    "{} ({})",
                    unit.ascii(),
                    self.get(&format!("feedback.kind.{}", kind.replace(' ', "_")))
                )
            }
            UnitKind::Dimension(dimension) => format!("{} ({dimension})", unit.ascii()),
            UnitKind::Itself => unit.ascii().to_owned(),
        };
        let hint = match expected.slip(found) {
            Some(UnitSlip::PoundIsMass) => Cow::Borrowed(self.get("feedback.pound_mass")),
            Some(UnitSlip::Millisecond) => Cow::Borrowed(self.get("feedback.millisecond")),
            Some(UnitSlip::Missing(factor)) => self.fill("feedback.factor_missing", &[("factor", factor)]),
            Some(UnitSlip::TooMany(factor)) => self.fill("feedback.factor_many", &[("factor", factor)]),
            None => {
                return self
                    .fill("feedback.dimension", &[("expected", &named(expected)), ("found", &named(found))]);
            }
        };
        let pieces = [("expected", &*named(expected)), ("found", &*named(found)), ("hint", &*hint)];
        self.fill("feedback.dimension_and", &pieces)
    }

    /// That another attempt counts, and what this one would have been.
    #[cfg(feature = "program")]
    pub(crate) fn superseded(&self, line: &str, verdict: Verdict) -> String {
        self.words.say("feedback.superseded", &[("line", line), ("verdict", verdict.as_str())])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units;

    /// Banks are told of units in English by `units`; students by the word list: both say the same.
    #[test]
    fn english_reasons_are_those_of_units() {
        let say = Feedback::english();
        for (expected, found) in
            [("N m", "N"), ("N", "lb"), ("m/s", "ms"), ("m", "m^2"), ("kg", "N^3"), ("m", "s")]
        {
            let (expected, found) = (Unit::parse(expected).unwrap(), Unit::parse(found).unwrap());
            assert_eq!(say.mismatch(&expected, &found), expected.mismatch(&found));
        }
        for text in ["", "furlong", "Newtn", "PA", "m/", "m^", "m;", "m^99", &"m".repeat(80)] {
            if let Err(fault) = Unit::parse(text) {
                let shown = fault.to_string();
                let column = match fault {
                    UnitFault::Exponent { .. } => None,
                    _ => shown.find(" at column"),
                };
                assert_eq!(say.unit(&fault), shown[..column.unwrap_or(shown.len())]);
            }
        }
        for kind in units::kinds() {
            assert_eq!(say.get(&format!("feedback.kind.{}", kind.replace(' ', "_"))), kind);
        }
    }
}
