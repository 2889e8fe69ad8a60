//! What a student is told of an answer, step by step: the verdict, why, and hints that lead on without giving the answer away.
//!
//! One function, [`Tutor::tell`], for `check`, `practice` and a sheet's own page: it takes what a sheet puts and an answer, and gives
//! data. No number of the key stands in any hint; a number that does is that of a wrong method in a limiting case.
use crate::answer::read::UnitCache;
use crate::bank::Problem;
use crate::grade::compare;
use crate::grade::diagnose;
use crate::grade::diagnose::AnswerSlip;
use crate::grade::feedback::Feedback;
use crate::grade::verdict::Verdict;
use crate::key::{Answer, KeyEntry, ProblemKey};
use crate::misconception;
use crate::misconception::MethodWords;
use crate::num::shown;
use crate::policy::Hints;
use crate::problem::make_key;
use crate::problem::maker::{APART, Variant};
use crate::scene::{Label, Quantity};
use crate::solve::agree;
use crate::solve::outcome::{Entry, Solved};
use crate::words::Words;

/// Finds the words of a wrong method by its id.
pub type FindWords<'a, 'w> = &'a dyn Fn(&str) -> Option<MethodWords<'w>>;

/// What a hint does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// It names a slip: a unit, a power of ten, a sign.
    Slip,
    /// It asks a question.
    Nudge,
    /// It puts a limiting case.
    Limit,
    /// It says where to look in the figure.
    Where,
    /// It says what to do.
    Do,
}

impl Step {
    /// As a word for machines.
    pub const fn as_str(self) -> &'static str {
        match self {
            Step::Slip => "slip",
            Step::Nudge => "nudge",
            Step::Limit => "limit",
            Step::Where => "where",
            Step::Do => "do",
        }
    }
}

/// One hint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hint {
    /// What it does.
    pub step: Step,
    /// Markdown with formulas in `$...$`.
    pub text: String,
}

/// What is told of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Told {
    /// The verdict, as grading gives it.
    pub verdict: Verdict,
    /// Why.
    pub reason: String,
    /// Ids of the wrong methods that the number tells; of several it is one.
    pub methods: Vec<String>,
    /// Hints, as many as the bank allows; no two are the same.
    pub hints: Vec<Hint>,
}

/// A number of figures in which the value of a wrong method is told.
const FIGURES: usize = 3;
/// A limiting case tells something if the wrong value differs from the right one by more than this share there.
const TELLING: f64 = 0.05;
/// Shares below this are roundings.
const NONE: f64 = 1e-9;
/// How many questions are asked where several methods fit.
const QUESTIONS: usize = 3;

/// A datum taken to an end, the others as they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Limit {
    Zero(usize),
    Tenfold(usize),
}

/// Tells what becomes of answers to one problem of one student.
pub struct Tutor<'a, 'w> {
    problem: &'a Problem,
    variant: &'a Variant,
    parts: Vec<Option<KeyEntry>>,
    ids: Vec<String>,
    level: Hints,
    words: &'w Words,
    say: Feedback<'w>,
    find: FindWords<'a, 'w>,
}

impl<'a, 'w> Tutor<'a, 'w> {
    /// A tutor for a variant of a problem and its key. `level` is what the bank allows, `find` the words of wrong methods.
    pub fn new(
        problem: &'a Problem,
        variant: &'a Variant,
        key: &ProblemKey,
        level: Hints,
        words: &'w Words,
        find: FindWords<'a, 'w>,
    ) -> Self {
        let mut parts: Vec<Option<KeyEntry>> = key.parts.iter().cloned().map(Some).collect();
        // A sheet lists its wrong methods for every case: one that comes to the right answer in this case tells nothing here.
        for entry in parts.iter_mut().flatten() {
            if let Answer::Number { value, half_width, .. } = entry.answer {
                entry.wrong.retain(|w| (w.value - value).abs() >= APART * half_width);
            }
        }
        let ids = problem.mistakes.iter().map(|m| m.id.clone()).collect();
        Self { problem, variant, parts, ids, level, words, say: Feedback::new(words), find }
    }

    /// Judges an answer to the part with this index, and gives the hints that lead on from it.
    pub fn tell(&self, part: usize, cell: &str) -> Option<Told> {
        let entry = self.parts.get(part)?.as_ref()?;
        let judgement = compare::compare_with(cell, entry, &mut UnitCache::default(), &self.say);
        let mut told = Told {
            verdict: judgement.verdict,
            reason: judgement.reason.into_owned(),
            methods: Vec::new(),
            hints: Vec::new(),
        };
        let asks = matches!(told.verdict, Verdict::Wrong | Verdict::WrongDirection);
        if !asks || self.level == Hints::None {
            return Some(told);
        }
        let mut hints = Vec::new();
        if judgement.number.is_finite() {
            let found = diagnose::diagnose(judgement.number, cell, part, &self.parts);
            let index = found.methods.iter().map(|m| usize::from(*m));
            told.methods = index.filter_map(|m| self.ids.get(m).cloned()).collect();
            self.of_number(part, entry, told.verdict, &told.methods, found.slip, &mut hints);
        } else {
            hints.push((Step::Nudge, self.of_group("nudge", part)));
            self.of_place(part, &mut hints);
        }
        for (step, text) in hints {
            if !told.hints.iter().any(|h: &Hint| h.text == text) {
                told.hints.push(Hint { step, text });
            }
        }
        if self.level == Hints::Nudge {
            told.hints.truncate(2);
        }
        Some(told)
    }

    /// Hints for a wrong number.
    fn of_number(
        &self,
        part: usize,
        entry: &KeyEntry,
        verdict: Verdict,
        methods: &[String],
        slip: Option<AnswerSlip>,
        hints: &mut Vec<(Step, String)>,
    ) {
        let slip_text = match (verdict, slip) {
            (Verdict::WrongDirection, _) => {
                let magnitude = matches!(entry.answer, Answer::Number { magnitude: true, .. });
                let name = if magnitude { "tutor.slip.magnitude" } else { "tutor.slip.sign" };
                Some(self.words.get(name).to_owned())
            }
            (_, Some(slip)) => Some(self.of_slip(slip)),
            _ => None,
        };
        let slipped = slip_text.is_some();
        hints.extend(slip_text.map(|text| (Step::Slip, text)));
        // Who has the right digits needs no hint about the method.
        let digits = matches!(
            slip,
            Some(
                AnswerSlip::PowerOfTen(_)
                    | AnswerSlip::Unit(..)
                    | AnswerSlip::FewerFigures(_)
                    | AnswerSlip::Drift
            )
        );
        let known: Vec<MethodWords> = methods.iter().filter_map(|id| (self.find)(id)).collect();
        if digits && known.is_empty() {
            return;
        }
        let single = match known.as_slice() {
            [one] => {
                hints.push((Step::Nudge, one.hint.to_owned()));
                methods.first().and_then(|id| self.ids.iter().position(|i| i == id)).map(|i| (i, *one))
            }
            [] => {
                if !slipped {
                    hints.push((Step::Nudge, self.unknown(entry)));
                }
                None
            }
            several => {
                let mut questions: Vec<&str> = Vec::new();
                for hint in several.iter().map(|w| w.hint).take(QUESTIONS) {
                    if !questions.contains(&hint) {
                        questions.push(hint);
                    }
                }
                let text = match questions.as_slice() {
                    [one] => (*one).to_owned(),
                    all => self.words.say("tutor.one_of", &[("questions", &all.join(" "))]),
                };
                hints.push((Step::Nudge, text));
                None
            }
        };
        let label = self.problem.questions.get(part).map(|q| q.label);
        let limit = label.and_then(|label| {
            let taken = single.and_then(|(method, _)| self.method_in_a_limit(method, label, entry));
            taken.or_else(|| self.right_in_a_limit(label))
        });
        hints.extend(limit.map(|text| (Step::Limit, text)));
        self.of_place(part, hints);
        if let (Some((_, words)), Some((_, last))) = (single, hints.last_mut()) {
            let pieces = [("did", words.did), ("see", words.see), ("step", last.as_str())];
            *last = self.words.say("tutor.done", &pieces);
        }
    }

    /// Where to look, and what to do.
    fn of_place(&self, part: usize, hints: &mut Vec<(Step, String)>) {
        hints.push((Step::Where, self.of_group("where", part)));
        hints.push((Step::Do, self.of_group("step", part)));
    }

    fn of_group(&self, what: &str, part: usize) -> String {
        let quantity = self.problem.questions.get(part).map_or(Quantity::V, |q| q.label.quantity);
        self.words.get(&format!("tutor.{what}.{}", group(quantity))).to_owned()
    }

    fn of_slip(&self, slip: AnswerSlip) -> String {
        match slip {
            AnswerSlip::PowerOfTen(_) => self.words.get("tutor.slip.power_of_ten").to_owned(),
            AnswerSlip::Unit(from, to) => self.words.say("tutor.slip.unit", &[("from", from), ("to", to)]),
            AnswerSlip::FewerFigures(_) => self.words.get("tutor.slip.figures").to_owned(),
            AnswerSlip::Drift => self.words.get("tutor.slip.drift").to_owned(),
            AnswerSlip::OtherPart(_) => self.words.get("tutor.slip.other_part").to_owned(),
        }
    }

    /// That nothing known fits, and which check would show what is wrong.
    fn unknown(&self, entry: &KeyEntry) -> String {
        let signed = matches!(entry.answer, Answer::Number { magnitude: false, .. });
        let check = if signed { "tutor.check.sign" } else { "tutor.check.dimension" };
        format!("{} {}", self.words.get("tutor.unknown"), self.words.get(check))
    }

    /// The limiting cases that are still a motion of this kind: the data, and the solution there.
    fn limits(&self) -> impl Iterator<Item = (Limit, Vec<f64>, Solved)> + '_ {
        let given = self.variant.values.iter().enumerate().filter(|(i, value)| {
            let free_fall = self.problem.data.get(*i).is_none_or(|d| d.symbol == "g");
            value.is_some() && !free_fall && self.variant.data[*i] != 0.0
        });
        given.filter_map(|(i, _)| {
            let angle = self.problem.data[i].degrees;
            let zero = self.solved_with(i, 0.0).map(|(data, solved)| (Limit::Zero(i), data, solved));
            let more = || self.solved_with(i, 10.0 * self.variant.data[i]);
            zero.or_else(|| {
                let (data, solved) = (!angle).then(more).flatten()?;
                Some((Limit::Tenfold(i), data, solved))
            })
        })
    }

    fn solved_with(&self, datum: usize, value: f64) -> Option<(Vec<f64>, Solved)> {
        let mut data = self.variant.data.clone();
        data[datum] = value;
        // The first road is enough: no right number of it is told.
        let half = agree::first(&self.problem.cases.get(self.variant.case)?.scene, &data).ok()?;
        let solved = half.preview().clone();
        let right = &self.variant.solved;
        let same = solved.regime == right.regime && solved.all_hold() == right.all_hold();
        same.then_some((data, solved))
    }

    /// `With k = 0`.
    fn of_limit(&self, limit: Limit) -> String {
        let (Limit::Zero(i) | Limit::Tenfold(i)) = limit;
        let symbol = format!("${}$", self.problem.data[i].tex);
        let name = match limit {
            Limit::Zero(_) => "tutor.limit.zero",
            Limit::Tenfold(_) => "tutor.limit.tenfold",
        };
        self.words.say(name, &[("symbol", &symbol)])
    }

    /// What a wrong method gives in the limiting case in which that is oddest.
    fn method_in_a_limit(&self, method: usize, label: Label, entry: &KeyEntry) -> Option<String> {
        let magnitude = make_key::is_magnitude(label.quantity);
        let mut best: Option<(f64, Limit, f64)> = None;
        for (limit, data, solved) in self.limits() {
            let Some(right) = solved.get(label).map(Entry::value).filter(|r| r.is_finite()) else { continue };
            let values = misconception::values(self.problem, self.variant.case, &data, &solved, &[label]);
            let Some(wrong) = values.iter().find(|w| w.mistake == method) else { continue };
            let value = if magnitude { wrong.value.abs() } else { wrong.value };
            let size = value.abs().max(right.abs());
            // A datum that changes neither tells nothing.
            let (here, before) =
                (self.variant.solved.get(label).map_or(f64::NAN, Entry::value), self.wrong(method, label));
            let same = |a: f64, b: f64| (a - b).abs() <= NONE * a.abs().max(b.abs());
            let idle = same(right, here) && same(value, before);
            if idle || (value - right).abs() <= TELLING * size || self.is_a_key(value) {
                continue;
            }
            // Oddest is a number where there should be none, then one of the other sign, then none where there should be one.
            let oddness = if right.abs() <= NONE * size {
                4.0
            } else if value * right < 0.0 {
                3.0
            } else if value.abs() <= NONE * size {
                2.0
            } else {
                let zero = matches!(limit, Limit::Zero(_));
                f64::from(zero) + 0.5 - 0.5 * value.abs().min(right.abs()) / size
            };
            if best.is_none_or(|(most, ..)| oddness > most) {
                best = Some((oddness, limit, value));
            }
        }
        let (_, limit, value) = best?;
        let value = self.written(value, entry);
        Some(self.words.say("tutor.limit.method", &[("limit", &self.of_limit(limit)), ("value", &value)]))
    }

    /// What a wrong method gives for this student's data, SI; NaN where it gives nothing.
    fn wrong(&self, method: usize, label: Label) -> f64 {
        let part = self.problem.questions.iter().position(|q| q.label == label);
        let entry = part.and_then(|part| self.parts.get(part)?.as_ref());
        let values = entry.map_or(&[][..], |entry| &entry.wrong);
        values.iter().find(|w| usize::from(w.method) == method).map_or(f64::NAN, |w| w.value)
    }

    fn written(&self, value: f64, entry: &KeyEntry) -> String {
        let digits = self.words.number(&shown::significant(entry.unit.from_si(value), FIGURES));
        if entry.unit.is_number() { digits } else { format!("{digits} {}", entry.unit.ascii()) }
    }

    /// Would this number, as it is written, be a right answer to any part?
    fn is_a_key(&self, value: f64) -> bool {
        self.parts.iter().flatten().any(|entry| match entry.answer {
            Answer::Number { value: key, half_width, .. } => {
                let written = entry.unit.to_si(shown::rounded(entry.unit.from_si(value), FIGURES));
                [value, written].iter().any(|x| compare::accepts(x.abs(), key.abs(), half_width))
            }
            Answer::Word { .. } => false,
        })
    }

    /// What the right answer does in the limiting case that tells most, in words.
    fn right_in_a_limit(&self, label: Label) -> Option<String> {
        let here = self.variant.solved.get(label)?;
        let mut best: Option<(u8, Limit, &str)> = None;
        for (limit, _, solved) in self.limits() {
            let Some(there) = solved.get(label).map(Entry::value).filter(|x| x.is_finite()) else { continue };
            let value = here.value();
            let (rank, trend) = if there.abs() <= NONE * value.abs().max(here.scale) {
                (5, "vanishes")
            } else if there * value < 0.0 {
                (4, "turns")
            } else if (there - value).abs() <= NONE * value.abs() {
                (3, "stays")
            } else if there.abs() > value.abs() {
                (1, "grows")
            } else {
                (2, "shrinks")
            };
            if best.is_none_or(|(most, ..)| rank > most) {
                best = Some((rank, limit, trend));
            }
        }
        let (_, limit, trend) = best?;
        let trend = self.words.get(&format!("tutor.trend.{trend}"));
        Some(self.words.say("tutor.limit.right", &[("limit", &self.of_limit(limit)), ("trend", trend)]))
    }
}

/// Quantities that are found alike: a name in the word list.
const fn group(quantity: Quantity) -> &'static str {
    use Quantity as Q;
    match quantity {
        Q::V | Q::VX | Q::VY | Q::Omega | Q::VMax | Q::OmegaMax => "speed",
        Q::A | Q::AX | Q::AY | Q::Alpha | Q::ARolling => "acceleration",
        Q::Friction | Q::Normal => "friction",
        Q::FrictionIfRolled | Q::MuRequired | Q::KBound => "rolling",
        Q::T => "time",
        Q::Tension => "tension",
        Q::CordTravel | Q::Displacement | Q::Phi | Q::Rise | Q::DTurn => "way",
        Q::SlipDistance | Q::SlipSpeed => "slip",
        Q::Heat | Q::WorkPull | Q::PowerPull => "work",
        Q::KineticEnergy | Q::RotationalFraction => "energy",
        Q::XEq | Q::DAtVMax => "equilibrium",
        Q::XG | Q::YG => "centre",
        Q::IG | Q::IO => "inertia",
        Q::PinRadial | Q::PinTangential | Q::PinX | Q::PinY | Q::PinForce => "pin",
        Q::SpringForce => "spring",
        Q::Period | Q::PeriodSmall | Q::OmegaSmall => "swing",
        Q::Direction => "direction",
        Q::Rolls => "rolls",
    }
}
