//! One student of a made-up class at work on a sheet: what is handed in for each part, attempt by attempt, and what was really done.
use crate::bank::Problem;
use crate::key::{Answer, KeyEntry, ProblemKey};
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::scene::Label;
use crate::simulate::chance::Chance;
use crate::simulate::habits::Habits;
use crate::simulate::truth::{TrueKind, Truth};
use crate::simulate::written::{self, WrittenCell};
use crate::solution::by_hand::{self, ByHand};
use crate::units::Unit;
use crate::words::Words;

/// Fewer figures than these are not sensible, at the end or on the way.
const SENSIBLE: u32 = 3;

/// One answer that is handed in.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulatedAnswer {
    /// Index of the problem in the sheet.
    pub problem: usize,
    /// Index of the part.
    pub part: usize,
    /// Which attempt at the part, from 1.
    pub attempt: u32,
    /// What is written.
    pub cell: WrittenCell,
    /// What was done.
    pub truth: Truth,
}

/// Where a number comes from, before it is written and judged.
struct Idea {
    truth: Truth,
    cell: WrittenCell,
}

impl Idea {
    fn new(kind: TrueKind, cell: WrittenCell, figures: Option<u32>) -> Self {
        let (method, from, right, verdict) = (String::new(), String::new(), false, "");
        Self { truth: Truth { kind, method, figures, from, right, verdict }, cell }
    }
    /// The same, from this student or part.
    fn from(mut self, from: &str) -> Self {
        from.clone_into(&mut self.truth.from);
        self
    }
}

/// One part of one problem.
struct WorkedPart<'s> {
    problem: &'s Problem,
    variant: &'s Variant,
    key: &'s ProblemKey,
    index: usize,
}

impl<'s> WorkedPart<'s> {
    fn entry(&self) -> &'s KeyEntry {
        &self.key.parts[self.index]
    }
    fn label(&self) -> Option<Label> {
        self.problem.questions.get(self.index).map(|q| q.label)
    }
    /// Do words for its direction say `forward` and `back`? `None` where no word does, or `up` would mean a minus.
    fn level(&self) -> Option<bool> {
        let scene = &self.problem.cases[self.variant.case].scene;
        let words = make_key::sense_words(scene, self.label().filter(|l| l.quantity.is_directed())?)?;
        match words[0] {
            "up" => Some(false),
            "forward" => Some(true),
            _ => None,
        }
    }
}

/// What a student remembers of the problem at hand.
#[derive(Default)]
struct Memory {
    /// The wrong method in use.
    method: Option<u16>,
    /// Answers to earlier parts that are wrong numbers, SI.
    wrong: Vec<(usize, f64)>,
    /// What comes out by hand, with so many figures on the way.
    by_hand: Vec<(u32, Vec<ByHand>)>,
}

/// A student with the habits of the class.
pub struct SimulatedStudent<'h> {
    habits: &'h Habits,
    words: &'h Words,
    chance: Chance,
}

impl<'h> SimulatedStudent<'h> {
    /// A student of a class that hands in with this seed.
    pub fn new(habits: &'h Habits, words: &'h Words, seed: u64, student: &str) -> Self {
        Self { habits, words, chance: Chance::of(seed, student) }
    }

    /// Works on the problems of a sheet: first attempts at all parts in the order of the sheet, then second ones and so on. Somebody
    /// who is absent hands in nothing.
    pub fn work(&mut self, problems: &[(&Problem, &Variant, &ProblemKey)]) -> Vec<SimulatedAnswer> {
        if self.chance.meets(self.habits.absent) {
            return Vec::new();
        }
        let mut rounds: Vec<Vec<SimulatedAnswer>> = Vec::new();
        for (at, (problem, variant, key)) in problems.iter().enumerate() {
            let mut memory = Memory::default();
            for index in 0..key.parts.len() {
                let part = WorkedPart { problem, variant, key, index };
                let attempts = self.habits.attempts.at(self.chance.share());
                for attempt in 1..=attempts {
                    let sure = attempt > 1 && self.chance.meets(self.habits.improves);
                    let idea = if sure { self.right(&part) } else { self.idea(&part, &mut memory) };
                    let cell = self.write(&part, &idea);
                    let verdict = cell.verdict(part.entry());
                    // A number with a unit of another kind leads nowhere.
                    let leads = matches!(verdict, "wrong" | "wrong direction");
                    let wrong = leads.then(|| cell.si(&part.entry().unit)).flatten();
                    memory.wrong.retain(|(p, _)| *p != index);
                    memory.wrong.extend(wrong.map(|x| (index, x)));
                    let truth = judged(idea.truth, verdict);
                    let done = truth.right;
                    let round = usize::try_from(attempt).unwrap_or(1) - 1;
                    if rounds.len() <= round {
                        rounds.push(Vec::new());
                    }
                    rounds[round].push(SimulatedAnswer { problem: at, part: index, attempt, cell, truth });
                    if done {
                        break;
                    }
                }
            }
        }
        rounds.into_iter().flatten().collect()
    }

    /// What comes into the student's head for a part.
    fn idea(&mut self, part: &WorkedPart, memory: &mut Memory) -> Idea {
        if let Some(idea) = self.carried(part, memory).or_else(|| self.followed(part, memory)) {
            return idea;
        }
        let kind = self.habits.answers.at(self.chance.share());
        let idea = match &part.entry().answer {
            Answer::Word { right, offered } => self.word(kind, right, offered),
            Answer::Number { value, .. } => self.number(kind, *value, part, memory),
        };
        // Where a habit has no place (no such unit, no method spoils the part), the answer is right.
        idea.unwrap_or_else(|| self.right(part))
    }

    fn figures(&mut self) -> u32 {
        self.habits.figures.at(self.chance.share())
    }

    /// The right answer, rounded.
    fn right(&mut self, part: &WorkedPart) -> Idea {
        match &part.entry().answer {
            Answer::Word { right, .. } => Idea::new(TrueKind::Right, WrittenCell::Word(right), None),
            Answer::Number { value, .. } => {
                let figures = self.figures();
                let cell = WrittenCell::number(*value, &part.entry().unit, figures);
                Idea::new(TrueKind::Right, cell, Some(figures))
            }
        }
    }

    fn word(
        &mut self,
        kind: TrueKind,
        right: &'static str,
        offered: &'static [&'static str],
    ) -> Option<Idea> {
        match kind {
            TrueKind::Blank => Some(Idea::new(kind, WrittenCell::Blank, None)),
            TrueKind::Garbage => Some(self.garbage()),
            TrueKind::WrongMethod | TrueKind::WrongSign => {
                let others: Vec<&str> = offered.iter().copied().filter(|o| *o != right).collect();
                let word = others.get(self.chance.below(others.len())).copied()?;
                Some(Idea::new(kind, WrittenCell::Word(word), None))
            }
            _ => None,
        }
    }

    fn garbage(&mut self) -> Idea {
        let text = written::GARBAGE[self.chance.below(written::GARBAGE.len())];
        Idea::new(TrueKind::Garbage, WrittenCell::Garbage(text), None)
    }

    /// A number that came about in this way; `None` where that is not possible.
    fn number(&mut self, kind: TrueKind, value: f64, part: &WorkedPart, memory: &mut Memory) -> Option<Idea> {
        let unit = &part.entry().unit;
        let figures = self.figures();
        let idea = |cell: WrittenCell| Idea::new(kind, cell, Some(figures));
        Some(match kind {
            TrueKind::Right => return None,
            TrueKind::RoundedOnTheWay => return self.rounded(part, memory),
            TrueKind::WrongMethod => {
                let method = self.method(part)?;
                memory.method = Some(method);
                return self.by_method(part, method);
            }
            TrueKind::WrongSign => idea(WrittenCell::number(-value, unit, figures)),
            TrueKind::UnitSlip => {
                let meant = written::other_unit(unit, &mut self.chance)?;
                let cell = WrittenCell::number(value, &meant, figures).with_unit(unit.clone());
                idea(cell).from(meant.ascii())
            }
            TrueKind::WrongUnit => {
                let strange = written::strange_unit(unit, &mut self.chance)?;
                idea(WrittenCell::number(value, unit, figures).with_unit(strange))
            }
            TrueKind::PowerOfTen => {
                let tens = [1e-3, 1e-2, 0.1, 10.0, 100.0, 1e3];
                idea(WrittenCell::number(value * tens[self.chance.below(tens.len())], unit, figures))
            }
            TrueKind::TypingError => {
                let cell = WrittenCell::number(value, unit, figures);
                idea(cell.with_digits(|digits| written::mistyped(digits, &mut self.chance)))
            }
            TrueKind::OtherPart => {
                let numbers = part.key.parts.iter().enumerate().filter_map(|(i, e)| match e.answer {
                    Answer::Number { value, .. } if i != part.index => Some((e, value)),
                    _ => None,
                });
                let others: Vec<(&KeyEntry, f64)> = numbers.collect();
                let (other, value) = *others.get(self.chance.below(others.len()))?;
                idea(WrittenCell::number(value, &other.unit, figures)).from(&other.part)
            }
            TrueKind::Blank => Idea::new(kind, WrittenCell::Blank, None),
            TrueKind::Garbage => self.garbage(),
            TrueKind::Followed | TrueKind::Copied => return None,
        })
    }

    /// Worked by hand with few figures on the way; the answer has as many.
    fn rounded(&mut self, part: &WorkedPart, memory: &mut Memory) -> Option<Idea> {
        let figures = self.habits.on_the_way.at(self.chance.share());
        let label = part.label()?;
        if !memory.by_hand.iter().any(|(f, _)| *f == figures) {
            let digits = usize::try_from(figures).unwrap_or(3);
            let all = by_hand::answers(part.problem, part.variant, self.words, digits).unwrap_or_default();
            memory.by_hand.push((figures, all));
        }
        let all = memory.by_hand.iter().find(|(f, _)| *f == figures).map(|(_, all)| all)?;
        let scene = &part.problem.cases[part.variant.case].scene;
        let si = scene.as_asked(label, all.iter().find(|h| h.label == label)?.value()?);
        let cell = WrittenCell::number(si, &part.entry().unit, figures);
        Some(Idea::new(TrueKind::RoundedOnTheWay, cell, Some(figures)))
    }

    /// A wrong method that spoils this part, by the favourites of the class.
    fn method(&mut self, part: &WorkedPart) -> Option<u16> {
        let likes = |method: u16| {
            let id = part.key.methods.get(usize::from(method))?;
            let named = self.habits.methods.iter().find(|(m, _)| m == id);
            Some(named.map_or(self.habits.any_method, |(_, w)| *w))
        };
        let weights: Vec<(u16, f64)> =
            part.entry().wrong.iter().filter_map(|w| Some((w.method, likes(w.method)?))).collect();
        let total: f64 = weights.iter().map(|(_, w)| w).sum();
        let mut left = self.chance.share() * total;
        for (method, weight) in weights {
            if left < weight {
                return Some(method);
            }
            left -= weight;
        }
        None
    }

    fn by_method(&mut self, part: &WorkedPart, method: u16) -> Option<Idea> {
        let wrong = part.entry().wrong.iter().find(|w| w.method == method)?;
        let figures = self.figures();
        let method = part.key.methods.get(usize::from(method))?.clone();
        let cell = WrittenCell::number(wrong.value, &part.entry().unit, figures);
        let mut idea = Idea::new(TrueKind::WrongMethod, cell, Some(figures));
        idea.truth.method = method;
        Some(idea)
    }

    /// The wrong method of an earlier part, used again.
    fn carried(&mut self, part: &WorkedPart, memory: &Memory) -> Option<Idea> {
        let method = memory.method?;
        part.entry().wrong.iter().find(|w| w.method == method)?;
        if self.chance.meets(self.habits.carries_on) { self.by_method(part, method) } else { None }
    }

    /// Worked out from a wrong answer to an earlier part, as the bank says.
    fn followed(&mut self, part: &WorkedPart, memory: &Memory) -> Option<Idea> {
        let follow = part.problem.follows.iter().find(|f| f.question == part.index)?;
        let from = follow.from.iter().find(|p| memory.wrong.iter().any(|(w, _)| w == *p))?;
        if !self.chance.meets(self.habits.follows_on) {
            return None;
        }
        let scene = &part.problem.cases[part.variant.case].scene;
        let own = |label: Label| {
            let asked = part.problem.questions.iter().position(|q| q.label == label);
            let wrong = asked.and_then(|q| memory.wrong.iter().find(|(p, _)| *p == q));
            wrong.map_or_else(|| part.variant.solved.asked(scene, label), |(_, x)| *x)
        };
        let si = follow.by.eval(&part.variant.data, &own);
        if !si.is_finite() {
            return None;
        }
        let figures = self.figures();
        let from = part.problem.questions.get(*from)?;
        let cell = WrittenCell::number(si, &part.entry().unit, figures);
        Some(Idea::new(TrueKind::Followed, cell, Some(figures)).from(&from.id))
    }

    /// Unit and direction as the habits are. Slips that live in the unit keep theirs.
    fn write(&mut self, part: &WorkedPart, idea: &Idea) -> WrittenCell {
        let unit: &Unit = &part.entry().unit;
        let written = self.habits.units.at(self.chance.share());
        let by_word = self.chance.meets(self.habits.words);
        let (figures, cell) = (idea.truth.figures.unwrap_or(4), idea.cell.clone());
        let cell = match idea.truth.kind {
            TrueKind::UnitSlip | TrueKind::WrongUnit | TrueKind::OtherPart | TrueKind::TypingError => cell,
            _ => written::in_habit(cell, unit, written, figures, &mut self.chance),
        };
        match part.level().filter(|_| by_word) {
            Some(level) => written::by_word(cell, level),
            None => cell,
        }
    }
}

/// Judges what was done by the verdict that it gets.
fn judged(truth: Truth, verdict: &'static str) -> Truth {
    // Neither a right number without the unit that is demanded is to be marked right, nor one with too few figures.
    let enough = truth.figures.is_none_or(|f| f >= SENSIBLE);
    let right = truth.kind.deserves() && enough && verdict != "missing unit";
    Truth { right, verdict, ..truth }
}
