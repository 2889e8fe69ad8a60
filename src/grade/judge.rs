//! The comparison of one cell with its key: readable, dimension, value, direction.
use crate::answer::read::Number;
use crate::answer::read::Reading;
use crate::answer::read::UnitCache;
use crate::answer::read::Why;
use crate::answer::read::Word;
use crate::answer::read::read;
use crate::grade::verdict::Judgement;
use crate::grade::verdict::Verdict;
use crate::key::Answer;
use crate::key::KeyEntry;
use std::borrow::Cow;

/// Half the distance from 1 to the next double.
const U: f64 = 1.0 / 9_007_199_254_740_992.0;
/// Roundings allowed on top of a tolerance: of the key's half-width and of the conversion of the answer.
const ROUNDINGS: f64 = 8.0;

/// Is `x` accepted for `key`? `|x - key| <= half_width (1 + 8u) + 8u |x|`; never for NaN or infinity.
#[inline]
pub fn accepts(x: f64, key: f64, half_width: f64) -> bool {
    x.is_finite() && (x - key).abs() <= half_width * (1.0 + ROUNDINGS * U) + ROUNDINGS * U * x.abs()
}

/// Judges one cell.
pub fn judge(cell: &str, entry: &KeyEntry) -> Judgement {
    judge_with(cell, entry, &mut UnitCache::default())
}

/// Judges one cell, remembering units already read.
pub fn judge_with(cell: &str, entry: &KeyEntry, units: &mut UnitCache) -> Judgement {
    let (verdict, reason) = match (read(cell, units), &entry.answer) {
        (Reading::Blank, _) => (Verdict::Blank, Cow::Borrowed("nothing written")),
        (Reading::Unreadable(why), Answer::Word { offered, .. }) => {
            (Verdict::Unreadable, Cow::Owned(format!("{why}; write one of: {}", offered.join(", "))))
        }
        (Reading::Unreadable(why), _) => (Verdict::Unreadable, Cow::Owned(why.to_string())),
        (Reading::Word(word), Answer::Word { right, offered }) => judge_word(word, right, offered),
        (Reading::Number(_), Answer::Word { offered, .. }) => {
            (Verdict::Unreadable, Cow::Owned(format!("a word is asked: write one of {}", offered.join(", "))))
        }
        (Reading::Word(word), Answer::Number { .. }) => {
            (Verdict::Unreadable, Cow::Owned(format!("`{}` alone: write the number too", word.as_str())))
        }
        (Reading::Number(number), Answer::Number { value, half_width, directed, magnitude }) => judge_number(
            &number,
            entry,
            Key { value: *value, half_width: *half_width, directed: *directed, magnitude: *magnitude },
        ),
    };
    Judgement { verdict, points: if verdict == Verdict::Right { entry.points } else { 0.0 }, reason }
}

fn judge_word(word: Word, right: &str, offered: &[&str]) -> (Verdict, Cow<'static, str>) {
    let level = offered.contains(&Word::Forward.as_str());
    let word = match word {
        Word::Right if level => Word::Forward,
        Word::Left if level => Word::Back,
        other => other,
    };
    if word.as_str() == right {
        (Verdict::Right, Cow::Borrowed("the right word"))
    } else if offered.contains(&word.as_str()) {
        (Verdict::Wrong, Cow::Borrowed("another word is right"))
    } else {
        (
            Verdict::Unreadable,
            Cow::Owned(format!("`{}` is not offered: write one of {}", word.as_str(), offered.join(", "))),
        )
    }
}

#[derive(Clone, Copy)]
struct Key {
    value: f64,
    half_width: f64,
    directed: bool,
    magnitude: bool,
}

/// Reason of a right answer.
pub(crate) const WITHIN: &str = "within the tolerance";
/// Reason of a wrong answer.
pub(crate) const OUTSIDE: &str = "not within the tolerance";
/// Reason of a wrong direction where the sign tells it.
pub(crate) const OTHER_SIGN: &str = "the magnitude is right, the sign is not";
const OTHER_WORD: &str = "the magnitude is right, the direction is not";
/// Reason for a negative magnitude.
pub(crate) const NO_SIGN: &str = "the magnitude is right, but a magnitude is asked, without a minus sign";

fn judge_number(number: &Number, entry: &KeyEntry, key: Key) -> (Verdict, Cow<'static, str>) {
    let unit = match &number.unit {
        Some(unit) if !entry.unit.agrees(unit) => {
            return (Verdict::WrongDimension, Cow::Owned(entry.unit.mismatch(unit)));
        }
        Some(unit) => unit,
        None if entry.unit_required && !entry.unit.is_number() => {
            return (
                Verdict::MissingUnit,
                Cow::Owned(format!("write the unit, such as {}", entry.unit.ascii())),
            );
        }
        None => &entry.unit,
    };
    let angular = entry.unit.dimension().0[3] != 0 || entry.unit.dimension().0 == [0, 0, -1, 0];
    if number.turning && !angular {
        return (Verdict::Unreadable, Cow::Owned(Why::OddWord.to_string()));
    }
    let word_counts = key.directed || !key.magnitude;
    if word_counts && matches!(number.word, Some(Word::Left | Word::Right)) {
        return (
            Verdict::Unreadable,
            Cow::Borrowed("left or right is no direction here: write up or down, on a level forward or back"),
        );
    }
    let sign = number.word.and_then(Word::sign).filter(|_| word_counts).unwrap_or(1.0);
    let turns = unit.counts_turns(&entry.unit);
    let literal = unit.to_si(number.value) * sign;
    let per_turn = if turns { std::f64::consts::TAU } else { 1.0 };
    let x = literal * per_turn;
    if !x.is_finite() {
        return (Verdict::Unreadable, Cow::Borrowed("not a finite number"));
    }
    let decide = |x: f64| {
        if accepts(x, key.value, key.half_width) {
            Verdict::Right
        } else if accepts(-x, key.value, key.half_width) {
            Verdict::WrongDirection
        } else {
            Verdict::Wrong
        }
    };
    let verdict = decide(x);
    if let Some(grouped) = number.grouped.filter(|_| verdict == Verdict::Wrong)
        && decide(unit.to_si(grouped) * sign * per_turn) != Verdict::Wrong
    {
        let text = format!("the comma may mean either: write {} or {}", grouped, number.value);
        return (Verdict::Unreadable, Cow::Owned(text));
    }
    if turns && verdict == Verdict::Wrong && decide(literal) != Verdict::Wrong {
        let text = format!("{unit} is read as turns: write rev/min or rad/min");
        return (Verdict::Unreadable, Cow::Owned(text));
    }
    let reason = match verdict {
        Verdict::Right => WITHIN,
        Verdict::WrongDirection if number.word.is_some() => OTHER_WORD,
        Verdict::WrongDirection if key.magnitude => NO_SIGN,
        Verdict::WrongDirection => OTHER_SIGN,
        _ => OUTSIDE,
    };
    let mut notes: Vec<String> = Vec::new();
    if number.comma {
        notes.push("the comma is read as the decimal mark".to_owned());
    }
    if turns {
        let time = unit.ascii().strip_prefix("1/").unwrap_or(unit.ascii());
        notes.push(format!("{unit} is read as revolutions: rev/{time}"));
    }
    if number.about {
        notes.push("the number is taken as it stands, without the word before it".to_owned());
    }
    if number.turning {
        notes.push("the sense of turning is passed over: it is not asked".to_owned());
    }
    if number.case_forgiven {
        notes.push(format!("the unit is read as {}", unit.ascii()));
    }
    if number.word.is_some() && !word_counts {
        notes.push("no direction is asked".to_owned());
    }
    if notes.is_empty() {
        return (verdict, Cow::Borrowed(reason));
    }
    (verdict, Cow::Owned(format!("{reason}; {}", notes.join("; "))))
}
