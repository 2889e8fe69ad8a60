//! How an answer is read, said back to who writes it: no key is needed for it.
use crate::answer::read::{Number, Reading, UnitCache, read};
use crate::grade::feedback::Feedback;
use crate::key::{Answer, KeyEntry};
use crate::units::Unit;
use crate::words::Words;

/// Figures of a converted number: more than anybody is asked for.
const FIGURES: usize = 6;

/// What a cell is read as where this part is asked: `45 km/h = 12.5 m/s`, `down`, nothing for a blank cell. Errors: the reason
/// why it cannot be read.
pub fn echo(cell: &str, entry: &KeyEntry, words: &Words) -> Result<String, String> {
    let say = &Feedback::new(words);
    Ok(match read(cell, &mut UnitCache::default()) {
        Reading::Blank => String::new(),
        Reading::Unreadable(why) => return Err(say.why(&why).into_owned()),
        Reading::Word(word) => say.word(word.as_str()).to_owned(),
        Reading::Number(number) => match &entry.answer {
            Answer::Word { .. } => written(&number, number.unit.as_deref(), say),
            Answer::Number { .. } => of_number(&number, entry, say),
        },
    })
}

fn of_number(number: &Number, entry: &KeyEntry, say: &Feedback) -> String {
    let asked = &entry.unit;
    let unit = match number.unit_for(asked) {
        Some(unit) if !asked.agrees(unit) => return written(number, Some(unit), say),
        None if entry.unit_required => return written(number, None, say),
        Some(unit) => unit,
        None => asked,
    };
    let mut text = written(number, Some(unit), say);
    if unit.ascii() != asked.ascii() {
        let turns = if unit.counts_turns(asked) { std::f64::consts::TAU } else { 1.0 };
        let value = asked.from_si(unit.to_si(number.value) * turns);
        let value = crate::num::shown::rounded(value, FIGURES);
        text.push_str(" = ");
        text.push_str(&with_word(say.read_as(value, asked.ascii()), number, say));
    }
    text
}

/// The number with its unit and the word behind it.
fn written(number: &Number, unit: Option<&Unit>, say: &Feedback) -> String {
    with_word(say.read_as(number.value, unit.map_or("1", Unit::ascii)), number, say)
}

fn with_word(mut text: String, number: &Number, say: &Feedback) -> String {
    if let Some(word) = number.word {
        text.push(' ');
        text.push_str(say.word(word.as_str()));
    }
    text
}
