//! The words that answer a question, or give a number its sign, in both languages.
use crate::answer::read::WhyUnreadable;

worded! {
    /// A word that answers a question or gives a number its sign.
    AnswerWord {
        /// Up, positive.
        Up "up",
        /// Down, negative.
        Down "down",
        /// Forward, positive.
        Forward "forward",
        /// Back, negative.
        Back "back",
        /// To the right.
        Right "right",
        /// To the left.
        Left "left",
        /// Turning clockwise.
        Clockwise "clockwise",
        /// Turning the other way.
        CounterClockwise "counter-clockwise",
        /// Does not move.
        Stays "stays",
        /// Yes.
        Yes "yes",
        /// No.
        No "no",
    }
}

impl AnswerWord {
    /// Those that tell a direction.
    #[rustfmt::skip] // a table
    pub const DIRECTIONS: [AnswerWord; 8] = [
        AnswerWord::Up, AnswerWord::Down, AnswerWord::Forward, AnswerWord::Back, AnswerWord::Right,
        AnswerWord::Left, AnswerWord::Clockwise, AnswerWord::CounterClockwise,
    ];
    /// Does it tell a sense of turning?
    pub const fn turns(self) -> bool {
        matches!(self, AnswerWord::Clockwise | AnswerWord::CounterClockwise)
    }
    /// The other way.
    pub const fn opposite(self) -> AnswerWord {
        match self {
            AnswerWord::Up => AnswerWord::Down,
            AnswerWord::Down => AnswerWord::Up,
            AnswerWord::Forward => AnswerWord::Back,
            AnswerWord::Back => AnswerWord::Forward,
            AnswerWord::Right => AnswerWord::Left,
            AnswerWord::Left => AnswerWord::Right,
            AnswerWord::Clockwise => AnswerWord::CounterClockwise,
            AnswerWord::CounterClockwise => AnswerWord::Clockwise,
            AnswerWord::Yes => AnswerWord::No,
            AnswerWord::No => AnswerWord::Yes,
            AnswerWord::Stays => AnswerWord::Stays,
        }
    }
}

/// The words of both languages.
const WORDS: [(AnswerWord, &str); 11] = [
    (
        AnswerWord::Up,
        "up upward upwards uphill upslope above auf aufwärts hinauf herauf rauf bergauf oben hangaufwärts oberhalb",
    ),
    (
        AnswerWord::Down,
        "down downward downwards downhill downslope below ab abwärts hinab herab hinunter herunter runter bergab unten hangabwärts unterhalb",
    ),
    (AnswerWord::Forward, "forward forwards vorwärts vor vorn vorne voran"),
    (AnswerWord::Back, "back backward backwards rückwärts zurück hinten"),
    (AnswerWord::Right, "right rightward rightwards rechts"),
    (AnswerWord::Left, "left leftward leftwards links"),
    (AnswerWord::Clockwise, "cw clockwise uhrzeigersinn"),
    (AnswerWord::CounterClockwise, "ccw counterclockwise anticlockwise gegenuhrzeigersinn"),
    (AnswerWord::Stays, "stays stay rest stationary still bleibt ruht ruhe unbewegt unmoved"),
    (AnswerWord::Yes, "yes y ja j true wahr"),
    (AnswerWord::No, "no n nein false falsch"),
];
/// What is read as `stays` though it has more than one word.
const NO_MOTION: [&str; 5] =
    ["does not move", "doesn't move", "not moving", "no motion", "bewegt sich nicht"];
/// What is read as `yes` where it is asked whether a body rolls; with a comma behind `no` the same says that it slips.
#[rustfmt::skip] // a table
const ROLLS: [&str; 7] = [
    "no slipping", "no slip", "without slipping", "kein schlupf", "kein rutschen", "ohne rutschen",
    "ohne schlupf",
];

/// What people write of a direction in more than one word, as far as [`phrase`] reads it.
#[cfg(feature = "program")]
#[rustfmt::skip] // a table
const DIRECTIONS: [&str; 19] = [
    "up the incline", "down the incline", "up the slope", "down the slope", "up the track",
    "down the track", "to the right", "to the left", "nach oben", "nach unten", "nach vorn", "nach vorne",
    "nach hinten", "nach rechts", "nach links", "die Ebene hinauf", "die Ebene hinab",
    "die schiefe Ebene hinauf", "die schiefe Ebene hinab",
];

/// All that is read as this word of a key where nothing stands beside it.
#[cfg(feature = "program")]
pub fn spellings(word: &str) -> Vec<&'static str> {
    // A direction on a level only, where it is another name for these.
    let also = match word {
        "forward" => "right",
        "back" => "left",
        _ => word,
    };
    let read_so = WORDS.iter().filter(|(w, _)| [word, also].contains(&w.as_str()));
    let phrases = NO_MOTION.into_iter().filter(|_| word == "stays");
    let reads = |said: &&str| matches!(phrase(said), Some(Ok(w)) if [word, also].contains(&w.as_str()));
    let directions = DIRECTIONS.into_iter().filter(reads);
    read_so.flat_map(|(_, all)| all.split_ascii_whitespace()).chain(phrases).chain(directions).collect()
}

/// Words that say nothing more beside them.
const FILLERS: &str = "the a an incline inclined plane slope ramp track along to at acting acts directed pointing points \
    moves it is in direction nach die der den dem im schiefe schiefen ebene bahn es das rad kraft wirkt zeigt \
    gerichtet entlang längs richtung stehen könnte kann würde sich bewegt could have would will does do \
    put remains wheel";

/// Is it one of these words?
fn one_of(words: &str, token: &str) -> bool {
    words.split_ascii_whitespace().any(|word| word == token)
}

/// A phrase made of one direction or word and fillers only. `None`: other words; `Some(Err)`: two that differ.
pub(crate) fn phrase(text: &str) -> Option<Result<AnswerWord, WhyUnreadable>> {
    if text.len() > 80 || !text.contains(|c: char| c.is_alphabetic()) {
        return None;
    }
    let mut found: Option<AnswerWord> = None;
    let mut two = false;
    let (mut rolls, mut denied) = (None, false); // what `it rolls`, `it slips` and `not` add to a yes or no
    let mut against = false; // the other way than clockwise
    let lower = text.to_lowercase();
    let lower = NO_MOTION.iter().fold(lower, |t, said| t.replace(said, "stays"));
    let lower = ROLLS.iter().fold(lower, |t, said| t.replace(said, "yes"));
    let plain =
        lower.split(|c: char| c.is_whitespace() || "(),.;:!-\"'".contains(c)).filter(|t| !t.is_empty());
    for token in plain {
        if let Some((word, _)) = WORDS.iter().find(|(_, all)| one_of(all, token)) {
            two |= found.is_some_and(|f| f != *word);
            found = Some(*word);
        } else if one_of("roll rolls rolling rolled rollt rollen rollte", token) {
            two |= rolls == Some(false);
            rolls = Some(true);
        } else if one_of("slip slips slipping slides rutscht gleitet gleiten", token) {
            two |= rolls == Some(true);
            rolls = Some(false);
        } else if ["not", "nicht"].contains(&token) {
            denied = true;
        } else if one_of("counter anti gegen entgegen", token) {
            against = true;
        } else if !one_of(FILLERS, token) {
            return None;
        }
    }
    // `It slips` is an answer by itself.
    let said = rolls.map(|rolls| if rolls == denied { AnswerWord::No } else { AnswerWord::Yes });
    let word = match (found.or(said)?, against) {
        (AnswerWord::Clockwise, true) => AnswerWord::CounterClockwise,
        (_, true) => return None,
        (word, false) => word,
    };
    let contradicts = match word {
        AnswerWord::Yes => denied != (rolls == Some(false)),
        AnswerWord::No => rolls.is_some_and(|r| r != denied),
        _ => denied,
    };
    Some(if two || contradicts { Err(WhyUnreadable::OddWord) } else { Ok(word) })
}
