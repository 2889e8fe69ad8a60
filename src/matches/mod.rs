//! Whose answer is this: wrong answers that hit the key of a classmate, and how often luck alone would bring as much.
//!
//! An answer hits a key if it equals it within the rounding of the figures it was given with; the tolerance plays no part. What
//! a wrong method, a slip or another part of the student's own problem explains is told and never flagged. Hits in
//! several problems multiply, parts of one problem are one piece of evidence ([`luck`]). How often luck would bring a pair as
//! striking somewhere in the class, all students beside all classmates, is told with each pair, and a pair is flagged only
//! where that is below [`FLAGGED`]: so among honest students one set in so many has a false flag. A hit accuses nobody: sheets are
//! swapped, friends work with one set of data, a form is filled in under another name.
//!
//! For instructors only: what is in here must not reach a student.
pub(crate) mod luck;

use crate::matches::luck::Keys;
use std::collections::BTreeMap;

/// A pair is flagged if luck alone would bring fewer than this many pairs as striking in such a class.
pub const FLAGGED: f64 = 0.01;
/// A pair is listed if luck alone would bring fewer than this many.
pub const LISTED: f64 = 1.0;
/// Beyond the rounding of its figures an answer may differ from a key by this share: conversion of units in doubles.
const ROUNDING: f64 = 1e-9;

/// One question of the set: a column of the gradebook.
#[derive(Debug, Clone)]
pub struct AnswerColumn {
    /// Number of its problem.
    pub problem: usize,
    /// Key of each student, SI; NaN where there is none, or a word.
    pub keys: Vec<f64>,
    /// Keys of further draws of the same question, SI: the fewer students, the more they are needed.
    pub draws: Vec<f64>,
}

/// A wrong answer that counts.
#[derive(Debug, Clone, PartialEq)]
pub struct WrongAnswer {
    /// Whose, an index.
    pub student: usize,
    /// To which question, an index.
    pub question: usize,
    /// The number as it was compared with the key, SI.
    pub value: f64,
    /// Half a unit of its last figure, SI.
    pub half: f64,
    /// What explains it without a classmate, such as `A05` or `power_of_ten:3`; empty if nothing does.
    pub explained: String,
}

/// A student whose wrong answers hit a classmate's keys.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// Who gave the answers, an index.
    pub student: usize,
    /// Whose keys they hit, an index.
    pub classmate: usize,
    /// The answers, indices into those given to [`find`].
    pub hits: Vec<usize>,
    /// The chance that luck alone makes wrong answers as fine as these of this student hit this classmate's keys so well.
    pub chance: f64,
    /// How many pairs as striking luck alone would bring in the whole class.
    pub expected: f64,
    /// Is it to be looked at? Never where each hit is explained otherwise.
    pub flagged: bool,
}

/// What was found in a class.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PairsFound {
    /// Most striking first; of equal ones by student, then classmate.
    pub pairs: Vec<Pair>,
    /// Wrong answers in numbers that were held against classmates' keys.
    pub answers: usize,
    /// How many of those nothing else explains.
    pub unexplained: usize,
    /// Questions with too few keys to say what is luck.
    pub unclear: usize,
}

/// Holds the wrong answers of a class against the keys of classmates.
pub fn find(questions: &[AnswerColumn], wrong: &[WrongAnswer]) -> PairsFound {
    let known: Vec<Keys> =
        questions.iter().map(|q| Keys::new(q.keys.iter().chain(&q.draws).copied())).collect();
    let students = questions.iter().map(|q| q.keys.len()).max().unwrap_or(0);
    let orders = questions.iter().map(order).collect();
    let chances = wrong.iter().map(|answer| {
        let (value, half) = window(answer);
        known.get(answer.question).map_or(1.0, |keys| keys.chance(value, half))
    });
    let chances = chances.collect();
    let class = WrongInClass { questions, orders, wrong, known, chances, students };
    let all: Vec<usize> = (0..wrong.len()).filter(|i| class.counts(*i)).collect();
    let free: Vec<usize> = all.iter().copied().filter(|i| wrong[*i].explained.is_empty()).collect();
    let mut pairs = class.pairs(&free);
    for pair in &mut pairs {
        pair.flagged = pair.expected < FLAGGED;
    }
    // What has another explanation stands beside it, or alone and unflagged.
    let known_pairs: BTreeMap<(usize, usize), usize> =
        pairs.iter().enumerate().map(|(i, p)| ((p.student, p.classmate), i)).collect();
    for explained in class.pairs(&all) {
        match known_pairs.get(&(explained.student, explained.classmate)) {
            Some(i) => pairs[*i].hits = explained.hits,
            None => pairs.push(explained),
        }
    }
    pairs.sort_by(|a, b| {
        let who = |p: &Pair| (p.student, p.classmate);
        b.flagged.cmp(&a.flagged).then(a.expected.total_cmp(&b.expected)).then(who(a).cmp(&who(b)))
    });
    let unclear = class.known.iter().filter(|k| !k.is_empty() && k.len() < luck::ENOUGH).count();
    PairsFound { pairs, answers: all.len(), unexplained: free.len(), unclear }
}

/// Does any answer hit the key of a classmate at all? If not there is nothing to find, whatever luck may bring.
pub fn any_hit(questions: &[AnswerColumn], wrong: &[WrongAnswer]) -> bool {
    let orders: Vec<Vec<usize>> = questions.iter().map(order).collect();
    wrong.iter().any(|answer| {
        let (Some(question), Some(order)) = (questions.get(answer.question), orders.get(answer.question))
        else {
            return false;
        };
        let (value, half) = window(answer);
        let from = order.partition_point(|s| question.keys[*s] < value - half);
        order[from..].iter().take_while(|s| question.keys[**s] <= value + half).any(|s| *s != answer.student)
    })
}

/// Students with a key, in the order of their keys.
fn order(question: &AnswerColumn) -> Vec<usize> {
    let mut order: Vec<usize> = (0..question.keys.len()).filter(|s| question.keys[*s].is_finite()).collect();
    order.sort_by(|a, b| question.keys[*a].total_cmp(&question.keys[*b]).then(a.cmp(b)));
    order
}

struct WrongInClass<'c> {
    questions: &'c [AnswerColumn],
    orders: Vec<Vec<usize>>,
    wrong: &'c [WrongAnswer],
    known: Vec<Keys>,
    /// Of each answer: that luck makes it hit the key of some one classmate.
    chances: Vec<f64>,
    students: usize,
}

/// The number, and how far from it a key may lie.
fn window(answer: &WrongAnswer) -> (f64, f64) {
    (answer.value, answer.half + ROUNDING * answer.value.abs())
}

impl WrongInClass<'_> {
    /// Is it a number of a student who has the question, and known what luck brings there?
    fn counts(&self, index: usize) -> bool {
        let answer = &self.wrong[index];
        let number = answer.value.is_finite() && answer.value != 0.0 && answer.half > 0.0;
        number && self.known.get(answer.question).is_some_and(|k| k.len() >= luck::ENOUGH)
    }

    fn problem(&self, index: usize) -> usize {
        self.questions[self.wrong[index].question].problem
    }

    /// Pairs that are listed, by these answers.
    fn pairs(&self, answers: &[usize]) -> Vec<Pair> {
        let mut of_student = answers.to_vec();
        of_student.sort_by_key(|i| (self.wrong[*i].student, self.problem(*i), *i));
        let students: Vec<&[usize]> =
            of_student.chunk_by(|a, b| self.wrong[*a].student == self.wrong[*b].student).collect();
        let others = self.students.saturating_sub(1) as f64;
        let mut expected = vec![0.0; luck::BINS];
        for student in &students {
            for (sum, share) in expected.iter_mut().zip(luck::spread(&self.levels(student))) {
                *sum += others * share;
            }
        }
        let expected = luck::at_least(&expected);
        let mut pairs = Vec::new();
        for student in &students {
            let mut hits = self.hits(student);
            hits.sort_unstable_by_key(|(mate, i)| (*mate, self.problem(*i), *i));
            let mut alone: Option<Vec<f64>> = None;
            for of_one in hits.chunk_by(|a, b| a.0 == b.0) {
                let bin = luck::observed(self.strength(student, of_one));
                if bin == 0 || expected[bin] >= LISTED {
                    continue;
                }
                let alone = alone.get_or_insert_with(|| luck::at_least(&luck::spread(&self.levels(student))));
                pairs.push(Pair {
                    student: self.wrong[student[0]].student,
                    classmate: of_one[0].0,
                    hits: of_one.iter().map(|(_, i)| *i).collect(),
                    chance: alone[bin].min(1.0),
                    expected: expected[bin],
                    flagged: false,
                });
            }
        }
        pairs
    }

    /// What luck may bring the answers of one student, problem by problem.
    fn levels(&self, student: &[usize]) -> Vec<Vec<(f64, f64)>> {
        let of_problem = student.chunk_by(|a, b| self.problem(*a) == self.problem(*b));
        of_problem
            .map(|answers| luck::levels(&mut answers.iter().map(|i| self.chances[*i]).collect::<Vec<_>>()))
            .collect()
    }

    /// Whose keys the answers of one student hit: classmate and answer.
    fn hits(&self, student: &[usize]) -> Vec<(usize, usize)> {
        let mut found = Vec::new();
        for index in student {
            let answer = &self.wrong[*index];
            let (value, half) = window(answer);
            let (keys, order) = (&self.questions[answer.question].keys, &self.orders[answer.question]);
            let from = order.partition_point(|s| keys[*s] < value - half);
            let near = order[from..].iter().take_while(|s| keys[**s] <= value + half);
            found.extend(near.filter(|s| **s != answer.student).map(|s| (*s, *index)));
        }
        found
    }

    /// The chance that stands for these hits of one student on one classmate: that of the strongest of each problem, multiplied.
    fn strength(&self, student: &[usize], hits: &[(usize, usize)]) -> f64 {
        let mut product = 1.0;
        for of_problem in hits.chunk_by(|a, b| self.problem(a.1) == self.problem(b.1)) {
            let strongest = of_problem.iter().map(|(_, i)| self.chances[*i]).fold(f64::INFINITY, f64::min);
            let problem = self.problem(of_problem[0].1);
            let looked_at = student.iter().filter(|i| self.problem(**i) == problem).map(|i| self.chances[*i]);
            product *= looked_at.filter(|p| *p <= strongest).sum::<f64>().min(1.0);
        }
        product
    }
}
