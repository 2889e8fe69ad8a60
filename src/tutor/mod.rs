//! What a student is told of an answer, step by step: the verdict, why, and hints that lead on without giving the answer away.
//!
//! One function, [`Tutor::tell`], for `check`, `practice` and a sheet's own page: it takes what a sheet puts and an answer, and gives
//! data. No number of the key stands in any hint; a number that does is that of a wrong method in a limiting case.
use crate::answer::read::UnitCache;
use crate::bank::Problem;
use crate::grade::diagnose::AnswerSlip;
use crate::grade::feedback::Feedback;
use crate::grade::verdict::Verdict;
use crate::grade::{compare, diagnose};
use crate::key::{Answer, KeyEntry, ProblemKey};
use crate::misconception::{self, MethodWords};
use crate::num::shown;
use crate::policy::Hints;
use crate::problem::maker::{APART, Variant};
use crate::scene::{End, Label, Num, Quantity};
use crate::solve::agree;
use crate::solve::outcome::Solved;
use crate::words::Words;

/// Finds the words of a wrong method by its id.
pub type FindWords<'a, 'w> = &'a dyn Fn(&str) -> Option<MethodWords<'w>>;

worded! {
    /// What a hint does.
    HintKind {
        /// It names a slip: a unit, a power of ten, a sign.
        Slip "slip",
        /// It asks a question.
        Nudge "nudge",
        /// It puts a limiting case.
        Limit "limit",
        /// It says where to look in the figure.
        Where "where",
        /// It says what to do.
        Do "do",
    }
}

/// One hint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hint {
    /// What it does.
    pub step: HintKind,
    /// Markdown with formulas in `$...$`.
    pub text: String,
}

/// What is told of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct TutorReply {
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
    Twofold(usize),
    Half(usize),
}

impl Limit {
    const fn is_zero(self) -> bool {
        matches!(self, Self::Zero(_))
    }
}

/// Tells what becomes of answers to one problem of one student.
pub struct Tutor<'a, 'w> {
    problem: &'a Problem,
    variant: &'a Variant,
    parts: Vec<KeyEntry>,
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
        let mut parts: Vec<KeyEntry> = key.parts.clone();
        // A sheet lists its wrong methods for every case: one that comes to the right answer in this case tells nothing here.
        for entry in &mut parts {
            if let Answer::Number { value, half_width, .. } = entry.answer {
                entry.wrong.retain(|w| (w.value - value).abs() >= APART * half_width);
            }
        }
        let ids = problem.mistakes.iter().map(|m| m.id.clone()).collect();
        Self { problem, variant, parts, ids, level, words, say: Feedback::new(words), find }
    }

    /// Judges an answer to the part with this index, and gives the hints that lead on from it.
    pub fn tell(&self, part: usize, cell: &str) -> Option<TutorReply> {
        let entry = self.parts.get(part)?;
        let judgement = compare::compare_with(cell, entry, &mut UnitCache::default(), &self.say);
        let mut told = TutorReply {
            verdict: judgement.verdict,
            reason: judgement.reason.into_owned(),
            methods: Vec::new(),
            hints: Vec::new(),
        };
        if self.level == Hints::None && told.verdict == Verdict::WrongDirection {
            // That only the sign is wrong is a hint.
            told.verdict = Verdict::Wrong;
            let signs = [self.say.other_sign, self.say.no_sign, self.say.get("feedback.other_word")];
            let notes = signs.into_iter().find_map(|sign| told.reason.strip_prefix(sign)).unwrap_or_default();
            told.reason = format!("{}{notes}", self.say.outside);
        }
        let asks = matches!(told.verdict, Verdict::Wrong | Verdict::WrongDirection);
        if !asks || self.level == Hints::None {
            return Some(told);
        }
        let mut hints = Vec::new();
        if judgement.number.is_finite() {
            let found =
                diagnose::diagnose(judgement.number, cell.as_bytes(), part, &self.parts, &entry.wrong);
            let index = found.methods.iter().map(|m| usize::from(*m));
            told.methods = index.filter_map(|m| self.ids.get(m).cloned()).collect();
            // That a number of one or two figures is the right one rounded would give away the next figure of the key.
            let rounded = |slip: &AnswerSlip| matches!(slip, AnswerSlip::FewerFigures(n) if *n < FIGURES);
            let slip = found.slip.filter(|slip| !rounded(slip));
            self.of_number(part, entry, told.verdict, &told.methods, slip, &mut hints);
        } else {
            hints.push((HintKind::Nudge, self.of_group("nudge", part)));
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
        hints: &mut Vec<(HintKind, String)>,
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
        hints.extend(slip_text.map(|text| (HintKind::Slip, text)));
        // Who has the right digits needs no hint about the method, nor does who has but the sign to mend.
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
        if (digits || verdict == Verdict::WrongDirection) && known.is_empty() {
            return;
        }
        let single = match known.as_slice() {
            [one] => {
                hints.push((HintKind::Nudge, one.hint.to_owned()));
                methods.first().and_then(|id| self.ids.iter().position(|i| i == id)).map(|i| (i, *one))
            }
            [] => {
                if !slipped {
                    hints.push((HintKind::Nudge, self.unknown(part, entry)));
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
                hints.push((HintKind::Nudge, text));
                None
            }
        };
        let label = self.problem.questions.get(part).map(|q| q.label);
        let limit = label.and_then(|label| match single {
            Some((method, words)) => self.method_in_a_limit(method, label, entry, words.did),
            None => self.right_in_a_limit(label).map(|text| (text, false)),
        });
        let named = limit.as_ref().is_some_and(|(_, named)| *named);
        hints.extend(limit.map(|(text, _)| (HintKind::Limit, text)));
        self.of_place(part, hints);
        if let (Some((_, words)), Some((_, last))) = (single, hints.last_mut()) {
            // A method is named once.
            let name = if named { "tutor.instead" } else { "tutor.done" };
            let pieces = [("did", words.did), ("see", words.see), ("step", last.as_str())];
            *last = self.words.say(name, &pieces);
        }
    }

    /// Where to look, and what to do.
    fn of_place(&self, part: usize, hints: &mut Vec<(HintKind, String)>) {
        hints.push((HintKind::Where, self.of_group("where", part)));
        hints.push((HintKind::Do, self.of_group("step", part)));
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
    fn unknown(&self, part: usize, entry: &KeyEntry) -> String {
        let signed = matches!(entry.answer, Answer::Number { magnitude: false, .. });
        let check = match self.problem.questions.get(part).map(|q| group(q.label.quantity)) {
            Some("centre") => "tutor.check.place",
            _ if signed => "tutor.check.sign",
            _ => "tutor.check.dimension",
        };
        format!("{} {}", self.words.get("tutor.unknown"), self.words.get(check))
    }

    /// The limiting cases that are still a motion of this kind: the data, and the solution there. What is at the end of a motion of no
    /// length or duration tells nothing.
    fn limits(&self) -> impl Iterator<Item = (Limit, Vec<f64>, Solved)> + '_ {
        let end = match self.problem.cases.get(self.variant.case).map(|case| case.scene.end) {
            Some(End::Travel(_, n) | End::Position(_, n) | End::Time(_, n) | End::Speed(_, n)) => Some(n),
            _ => None,
        };
        let given = self.variant.values.iter().enumerate().filter(move |(i, value)| {
            let free_fall = self.problem.data.get(*i).is_none_or(|d| d.symbol == "g");
            value.is_some() && !free_fall && self.variant.data[*i] != 0.0 && end != Some(Num::Datum(*i))
        });
        given.flat_map(move |(i, _)| {
            let (angle, here) = (self.problem.data[i].degrees, self.variant.data[i]);
            let zero = (Limit::Zero(i), 0.0);
            let more = [
                (Limit::Tenfold(i), 10.0 * here),
                (Limit::Twofold(i), 2.0 * here),
                (Limit::Half(i), 0.5 * here),
            ];
            let cases = std::iter::once(zero).chain(more.into_iter().filter(move |_| !angle));
            cases.filter_map(move |(limit, value)| {
                let (data, solved) = self.solved_with(i, value)?;
                Some((limit, data, solved))
            })
        })
    }

    fn solved_with(&self, datum: usize, value: f64) -> Option<(Vec<f64>, Solved)> {
        let mut data = self.variant.data.clone();
        data[datum] = value;
        // The first road is enough: no right number of it is told.
        let half = agree::again(&self.problem.cases.get(self.variant.case)?.scene, &data).ok()?;
        let solved = half.preview().clone();
        let right = &self.variant.solved;
        let same = solved.regime == right.regime && solved.all_hold() == right.all_hold();
        same.then_some((data, solved))
    }

    /// `With k = 0`.
    fn of_limit(&self, limit: Limit) -> String {
        let (Limit::Zero(i) | Limit::Tenfold(i) | Limit::Twofold(i) | Limit::Half(i)) = limit;
        let symbol = format!("${}$", self.problem.data[i].tex);
        let name = match limit {
            Limit::Zero(_) => "tutor.limit.zero",
            Limit::Tenfold(_) => "tutor.limit.tenfold",
            Limit::Twofold(_) => "tutor.limit.twofold",
            Limit::Half(_) => "tutor.limit.half",
        };
        self.words.say(name, &[("symbol", &symbol)])
    }

    /// For a recognised method: its number where that is visibly wrong, else what the right answer does where the method's does
    /// otherwise, in words. Is the method named in it? `None` where no limiting case tells the two apart.
    fn method_in_a_limit(
        &self,
        method: usize,
        label: Label,
        entry: &KeyEntry,
        did: &str,
    ) -> Option<(String, bool)> {
        let scene = &self.problem.cases.get(self.variant.case)?.scene;
        let (here, now) = (self.variant.solved.get(label)?, self.variant.solved.asked(scene, label));
        let before = self.wrong(method, label);
        let mut odd: Option<(u8, Limit, f64)> = None;
        let mut apart: Option<(u8, Limit, Trend)> = None;
        for (limit, data, solved) in self.limits() {
            let right = solved.asked(scene, label);
            if !right.is_finite() {
                continue;
            }
            let at = (method, label);
            let value = misconception::value(self.problem, self.variant.case, (&data, &solved), at);
            let Some(value) = value.map(|v| scene.as_asked(label, v)) else { continue };
            let size = value.abs().max(right.abs());
            // A difference that nobody sees tells nothing.
            if (value - right).abs() <= TELLING * size {
                continue;
            }
            // Visibly wrong is a number where there should be none, and none where there should be one.
            let none = [right, value].map(|x| x.abs() <= NONE * size);
            let oddness = if limit.is_zero() { 2 * u8::from(none[0]) + u8::from(none[1]) } else { 0 };
            if oddness > 0 && !self.is_a_key(value) && odd.is_none_or(|(most, ..)| oddness > most) {
                odd = Some((oddness, limit, if none[1] { 0.0 } else { value }));
            }
            let trend = Trend::of(now, right, here.scale);
            let rank = trend.rank(limit);
            if trend != Trend::of(before, value, here.scale) && apart.is_none_or(|(most, ..)| rank > most) {
                apart = Some((rank, limit, trend));
            }
        }
        if let Some((_, limit, value)) = odd {
            let (limit, value) = (self.of_limit(limit), self.written(value, entry));
            let pieces = [("did", did), ("limit", &*limit), ("value", &*value)];
            return Some((self.words.say("tutor.limit.method", &pieces), true));
        }
        apart.map(|(_, limit, trend)| (self.of_right(limit, trend), false))
    }

    /// What a wrong method gives for this student's data, SI; NaN where it gives nothing.
    fn wrong(&self, method: usize, label: Label) -> f64 {
        let part = self.problem.questions.iter().position(|q| q.label == label);
        let entry = part.and_then(|part| self.parts.get(part));
        let values = entry.map_or(&[][..], |entry| &entry.wrong);
        values.iter().find(|w| usize::from(w.method) == method).map_or(f64::NAN, |w| w.value)
    }

    fn written(&self, value: f64, entry: &KeyEntry) -> String {
        let digits = self.words.number(&shown::significant(entry.unit.from_si(value), FIGURES));
        if entry.unit.is_number() { digits } else { format!("{digits} {}", entry.unit.ascii()) }
    }

    /// Would this number, as it is written, be a right answer to any part?
    fn is_a_key(&self, value: f64) -> bool {
        self.parts.iter().any(|entry| match entry.answer {
            Answer::Number { value: key, half_width, .. } => {
                let written = entry.unit.to_si(shown::rounded(entry.unit.from_si(value), FIGURES));
                [value, written].iter().any(|x| compare::accepts(x.abs(), key.abs(), half_width))
            }
            Answer::Word { .. } => false,
        })
    }

    /// What the right answer does in the limiting case that tells most, in words.
    fn right_in_a_limit(&self, label: Label) -> Option<String> {
        let scene = &self.problem.cases.get(self.variant.case)?.scene;
        let (here, now) = (self.variant.solved.get(label)?, self.variant.solved.asked(scene, label));
        let mut best: Option<(u8, Limit, Trend)> = None;
        for (limit, _, solved) in self.limits() {
            let there = solved.asked(scene, label);
            if !there.is_finite() {
                continue;
            }
            let trend = Trend::of(now, there, here.scale);
            let rank = trend.rank(limit);
            if best.is_none_or(|(most, ..)| rank > most) {
                best = Some((rank, limit, trend));
            }
        }
        best.map(|(_, limit, trend)| self.of_right(limit, trend))
    }

    fn of_right(&self, limit: Limit, trend: Trend) -> String {
        let trend = self.words.get(match trend {
            Trend::Grows => "tutor.trend.grows",
            Trend::Shrinks => "tutor.trend.shrinks",
            Trend::Stays => "tutor.trend.stays",
            Trend::Turns => "tutor.trend.turns",
            Trend::Vanishes => "tutor.trend.vanishes",
        });
        self.words.say("tutor.limit.right", &[("limit", &self.of_limit(limit)), ("trend", trend)])
    }
}

/// What becomes of a number in a limiting case: the later one tells more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Trend {
    Stays,
    Grows,
    Shrinks,
    Turns,
    Vanishes,
}

impl Trend {
    /// How much it tells: without a datum more than with more of it.
    const fn rank(self, limit: Limit) -> u8 {
        2 * self as u8 + limit.is_zero() as u8
    }

    /// From its value at the student's data and in the limiting case; `scale` is the size of the terms that make it up.
    fn of(here: f64, there: f64, scale: f64) -> Self {
        if there.abs() <= NONE * here.abs().max(scale) {
            Self::Vanishes
        } else if there * here < 0.0 {
            Self::Turns
        } else if (there - here).abs() <= NONE * here.abs() {
            Self::Stays
        } else if there.abs() > here.abs() {
            Self::Grows
        } else {
            Self::Shrinks
        }
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
        Q::RimForce => "rim",
        Q::CordTravel | Q::Displacement | Q::Distance | Q::Phi | Q::Angle | Q::Rise | Q::DTurn => "way",
        Q::SlipDistance | Q::SlipSpeed => "slip",
        Q::Heat | Q::WorkPull | Q::PowerPull | Q::WorkCouple | Q::PowerCouple | Q::Work => "work",
        Q::Impulse | Q::ImpulseX | Q::ImpulseY | Q::FrictionImpulse | Q::AngularMomentum => "momentum",
        Q::KineticEnergy | Q::RotationalFraction => "energy",
        Q::XEq | Q::DAtVMax => "equilibrium",
        Q::XG | Q::YG => "centre",
        Q::IG | Q::IO => "inertia",
        Q::PinRadial | Q::PinTangential | Q::PinForce | Q::PinX | Q::PinY | Q::PinAngle => "pin",
        Q::SpringForce => "spring",
        Q::Drive | Q::Moment => "pin",
        Q::Period | Q::PeriodSmall | Q::OmegaSmall => "swing",
        Q::Direction => "direction",
        Q::Rolls => "rolls",
        Q::Value => "value",
    }
}
