//! The comparison of one cell with its key: readable, dimension, value, direction.
use crate::answer::read::{Number, Reading, ReadingNote, UnitCache, WhyUnreadable, read};
use crate::answer::word::AnswerWord;
use crate::grade::feedback::Feedback;
use crate::grade::verdict::{Judgement, Verdict};
use crate::key::{Answer, KeyEntry, WordSigns};
use std::borrow::Cow;
use std::f64::consts::TAU;

/// Half the distance from 1 to the next double.
const U: f64 = 1.0 / 9_007_199_254_740_992.0;
/// Roundings allowed on top of a tolerance: of the key's half-width and of the conversion of the answer.
const ROUNDINGS: f64 = 8.0;

/// Is `x` accepted for `key`? `|x - key| <= half_width (1 + 8u) + 8u |x|`; never for NaN or infinity.
#[inline]
pub fn accepts(x: f64, key: f64, half_width: f64) -> bool {
    x.is_finite() && (x - key).abs() <= half_width * (1.0 + ROUNDINGS * U) + ROUNDINGS * U * x.abs()
}

/// What the number `x`, SI, is for a key.
#[inline]
pub(crate) fn verdict_on(x: f64, key: f64, half_width: f64) -> Verdict {
    if accepts(x, key, half_width) {
        Verdict::Right
    } else if accepts(-x, key, half_width) {
        Verdict::WrongDirection
    } else {
        Verdict::Wrong
    }
}

/// Compares one cell with its key; the reason is English.
#[cfg(feature = "program")]
pub fn compare(cell: &str, entry: &KeyEntry) -> Judgement<'static> {
    compare_with(cell, entry, &mut UnitCache::default(), Feedback::english())
}

/// The same, remembering units already read; the reason is in the language of the feedback.
pub fn compare_with<'w>(
    cell: &str,
    entry: &KeyEntry,
    units: &mut UnitCache,
    say: &Feedback<'w>,
) -> Judgement<'w> {
    let mut compared = f64::NAN;
    let (verdict, reason) = match (read(cell, units), &entry.answer) {
        (Reading::Blank, _) => (Verdict::Blank, Cow::Borrowed(say.get("feedback.blank"))),
        (Reading::Unreadable(why), Answer::Word { offered, .. }) => {
            let why = match why {
                WhyUnreadable::NoNumber => Cow::Borrowed(say.get("feedback.no_word")),
                why => say.why(&why),
            };
            let pieces = [("why", &*why), ("words", &*say.offered(offered))];
            (Verdict::Unreadable, say.fill("feedback.write_one_of", &pieces))
        }
        (Reading::Unreadable(why), _) => (Verdict::Unreadable, say.why(&why)),
        (Reading::Word(word), Answer::Word { right, offered }) => compare_word(word, right, offered, say),
        (Reading::Number(_), Answer::Word { offered, .. }) => {
            (Verdict::Unreadable, say.fill("feedback.word_asked", &[("words", &say.offered(offered))]))
        }
        (Reading::Word(word), Answer::Number { .. }) => {
            (Verdict::Unreadable, say.fill("feedback.word_alone", &[("word", say.word(word.as_str()))]))
        }
        (Reading::Number(number), &Answer::Number { value, half_width, magnitude, words, cyclic, .. }) => {
            let key = Key { value, half_width, magnitude, words, cyclic };
            compare_number(&number, entry, key, say, &mut compared)
        }
    };
    let points = if verdict == Verdict::Right { entry.points } else { 0.0 };
    Judgement { verdict, points, reason, number: compared }
}

fn compare_word<'w>(
    word: AnswerWord,
    right: &str,
    offered: &[&str],
    say: &Feedback<'w>,
) -> (Verdict, Cow<'w, str>) {
    let either =
        |a: AnswerWord, b: AnswerWord| offered.contains(&a.as_str()) || offered.contains(&b.as_str());
    let level = either(AnswerWord::Forward, AnswerWord::Back);
    let word = match word {
        AnswerWord::Right if level => AnswerWord::Forward,
        AnswerWord::Left if level => AnswerWord::Back,
        other => other,
    };
    // To stay is on few lists of directions (on sheets of earlier versions it was on all), and an answer all the same.
    let stays = word == AnswerWord::Stays && (level || either(AnswerWord::Up, AnswerWord::Down));
    if word.as_str() == right {
        (Verdict::Right, Cow::Borrowed(say.get("feedback.right_word")))
    } else if stays || offered.contains(&word.as_str()) {
        (Verdict::Wrong, Cow::Borrowed(say.get("feedback.another_word")))
    } else {
        let pieces = [("word", say.word(word.as_str())), ("words", &*say.offered(offered))];
        (Verdict::Unreadable, say.fill("feedback.not_offered", &pieces))
    }
}

#[derive(Clone, Copy)]
struct Key {
    value: f64,
    half_width: f64,
    magnitude: bool,
    words: Option<WordSigns>,
    cyclic: bool,
}

/// Turns by which a direction may be off; beyond them digits are lost.
const TURNS: f64 = 100.0;

impl Key {
    /// The number that means the same and lies next to the key.
    fn near(&self, x: f64) -> f64 {
        if self.cyclic && x.abs() < TURNS * TAU {
            x - TAU * ((x - self.value) / TAU).round_ties_even()
        } else {
            x
        }
    }
    /// What the number `x`, SI, is for the key.
    fn verdict(&self, x: f64) -> Verdict {
        match verdict_on(self.near(x), self.value, self.half_width) {
            Verdict::Wrong if accepts(self.near(-x), self.value, self.half_width) => Verdict::WrongDirection,
            verdict => verdict,
        }
    }
}

/// The sign that a word of direction gives: 1 or -1, 0 if it does not fit.
const fn sign_of(word: AnswerWord, signs: WordSigns) -> i8 {
    match word {
        AnswerWord::Up => signs.up,
        AnswerWord::Down => -signs.up,
        AnswerWord::Forward => signs.forward,
        AnswerWord::Back => -signs.forward,
        AnswerWord::Right => signs.right,
        AnswerWord::Left => -signs.right,
        AnswerWord::CounterClockwise => signs.counter_clockwise,
        AnswerWord::Clockwise => -signs.counter_clockwise,
        AnswerWord::Stays | AnswerWord::Yes | AnswerWord::No => 0,
    }
}

/// That a word does not fit, and which do.
fn odd_way<'w>(word: AnswerWord, signs: WordSigns, say: &Feedback<'w>) -> Cow<'w, str> {
    let mut fit = Vec::new();
    for way in &AnswerWord::DIRECTIONS {
        if sign_of(*way, signs) != 0 {
            fit.push(way.as_str());
        }
    }
    let pieces = [("word", say.word(word.as_str())), ("words", &*say.offered(&fit))];
    say.fill(if fit.is_empty() { "feedback.no_way" } else { "feedback.odd_way" }, &pieces)
}

fn compare_number<'w>(
    number: &Number,
    entry: &KeyEntry,
    key: Key,
    say: &Feedback<'w>,
    compared: &mut f64,
) -> (Verdict, Cow<'w, str>) {
    let unit = match number.unit_for(&entry.unit) {
        Some(unit) if !entry.unit.agrees(unit) => {
            return (Verdict::WrongDimension, say.mismatch(&entry.unit, unit));
        }
        Some(unit) => unit,
        None if entry.unit_required && !entry.unit.is_number() => {
            return (Verdict::MissingUnit, say.fill("feedback.write_unit", &[("unit", entry.unit.ascii())]));
        }
        None => &entry.unit,
    };
    if number.notes.contains(&ReadingNote::PerCent) && entry.unit.is_number() {
        return (Verdict::Unreadable, say.why(&WhyUnreadable::TwoNumbers));
    }
    let angular = entry.unit.dimension().0[3] != 0 || entry.unit.dimension().0 == [0, 0, -1, 0];
    let sign = match (number.word, key.words) {
        (Some(word), None) if word.turns() && !angular => {
            return (Verdict::Unreadable, say.why(&WhyUnreadable::OddWord));
        }
        (Some(word), Some(signs)) => match sign_of(word, signs) {
            0 => return (Verdict::Unreadable, odd_way(word, signs, say)),
            sign => f64::from(sign),
        },
        _ => 1.0,
    };
    let turns = unit.counts_turns(&entry.unit);
    let literal = unit.to_si(number.value) * sign;
    let per_turn = if turns { TAU } else { 1.0 };
    let x = literal * per_turn;
    if !x.is_finite() {
        return (Verdict::Unreadable, say.why(&WhyUnreadable::NotFinite));
    }
    let verdict = key.verdict(x);
    if let Some(grouped) = number.grouped.filter(|_| verdict == Verdict::Wrong)
        && key.verdict(unit.to_si(grouped) * sign * per_turn) != Verdict::Wrong
    {
        let pieces = [("a", &*say.number(grouped)), ("b", &*say.number(number.value))];
        return (Verdict::Unreadable, say.fill("feedback.comma_either", &pieces));
    }
    if turns && verdict == Verdict::Wrong && key.verdict(literal) != Verdict::Wrong {
        return (Verdict::Unreadable, say.fill("feedback.read_as_turns", &[("unit", unit.ascii())]));
    }
    *compared = key.near(x);
    let reason = match verdict {
        Verdict::Right => say.within,
        Verdict::WrongDirection if number.word.is_some() => say.get("feedback.other_word"),
        Verdict::WrongDirection if key.magnitude => say.no_sign,
        Verdict::WrongDirection => say.other_sign,
        _ => say.outside,
    };
    let mut notes: Vec<Cow<str>> = Vec::new();
    if number.notes.contains(&ReadingNote::Comma) && say.comma_is_odd() {
        notes.push(Cow::Borrowed(say.get("feedback.decimal_comma")));
    }
    if number.notes.contains(&ReadingNote::ReadAs) {
        let unit = number.unit.as_ref().map_or("1", |_| unit.ascii());
        let value = say.read_as(number.value, unit);
        notes.push(say.fill("feedback.read_as", &[("value", &value)]));
    }
    if number.notes.contains(&ReadingNote::Uncertainty) {
        notes.push(Cow::Borrowed(say.get("feedback.uncertainty")));
    }
    if turns {
        let time = unit.ascii().strip_prefix("1/").unwrap_or(unit.ascii());
        notes.push(say.fill("feedback.revolutions", &[("unit", unit.ascii()), ("time", time)]));
    }
    if number.notes.contains(&ReadingNote::About) {
        notes.push(Cow::Borrowed(say.get("feedback.about")));
    }
    let passed_over = number.word.filter(|_| key.words.is_none());
    if passed_over.is_some_and(AnswerWord::turns) {
        notes.push(Cow::Borrowed(say.get("feedback.turning")));
    }
    if number.case_forgiven || number.unit.as_deref().is_some_and(|u| u != unit) {
        notes.push(say.fill("feedback.unit_read", &[("unit", unit.ascii())]));
    }
    if passed_over.is_some_and(|word| !word.turns()) {
        notes.push(Cow::Borrowed(say.get("feedback.no_direction")));
    }
    if notes.is_empty() {
        return (verdict, Cow::Borrowed(reason));
    }
    (verdict, Cow::Owned(format!("{reason}; {}", notes.join("; "))))
}
