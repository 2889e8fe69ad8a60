//! What an answer that is not right may still earn: as a known wrong method, or because it follows correctly from the
//! student's own wrong answer to an earlier part.
use crate::grade::attempt::Winner;
use crate::grade::cells::GradingJob;
use crate::grade::compare::accepts;
use crate::grade::diagnose;
use crate::grade::table::KeyTable;
use crate::key::{Answer, Given};

/// Share of the points, and what it is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EarnedShare {
    /// 0 to 1.
    pub share: f64,
    pub why: CreditFor,
}

/// What a share of the points is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CreditFor {
    /// It is none.
    Nothing,
    /// A known wrong method.
    Method,
    /// It follows from the wrong answer in this column.
    Follows(usize),
}

impl EarnedShare {
    const NONE: EarnedShare = EarnedShare { share: 0.0, why: CreditFor::Nothing };
}

/// Values from which something may follow, and what follows, lie within this factor of the right ones: what is farther off
/// was not computed with care, or cannot be in this scene.
const REACH: f64 = 4.0;
/// So near to 0, 1 or a number of the statement an answer was not computed.
const COPIED: f64 = 1e-3;

/// The larger of what the methods and the relation earn. `x` is the number, SI, judged wrong; `methods` are those that it
/// fits, if they are known already.
pub(crate) fn credit(
    x: f64,
    (who, what): (usize, usize),
    job: &GradingJob,
    winners: &[Winner],
    methods: Option<&[u16]>,
) -> EarnedShare {
    let GradingJob { table, rules, .. } = *job;
    let mut best = EarnedShare::NONE;
    if !x.is_finite() || !rules.may_earn(what) {
        return best;
    }
    if rules.methods_earn(what) {
        let share = |methods: &[u16]| methods.iter().map(|m| rules.method(what, *m)).fold(0.0, f64::max);
        let found = match methods {
            Some(methods) => share(methods),
            None => {
                let Some((problem, part)) = table.problem_of(who, what) else { return best };
                share(&diagnose::methods(x, part, &problem.parts, job.wrong_values(who, what)))
            }
        };
        if found > best.share {
            best = EarnedShare { share: found, why: CreditFor::Method };
        }
    }
    let follow = rules.policy.credit.follow;
    if follow > best.share
        && let Some(source) = follows(x, (who, what), table, winners)
    {
        best = EarnedShare { share: follow, why: CreditFor::Follows(source) };
    }
    best
}

/// Does `x` follow from the student's own answers? From the first wrong one, or the first if all are right: from answers that
/// are off by as much as their tolerance something may follow that is not right.
///
/// The relation is solved again with the wrong answers in place of the key's; beside them the key's, or the student's own
/// right ones, which may differ by what the tolerance allows.
fn follows(x: f64, (who, what): (usize, usize), table: &KeyTable, winners: &[Winner]) -> Option<usize> {
    let (follow, first) = table.follow(what)?;
    // Of parts with other data nothing follows.
    if follow.from.iter().any(|part| table.code(who, first + part) != table.code(who, what)) {
        return None;
    }
    let (numbers, _) = table.problem_of(who, what)?;
    let (key, half_width, kind) = number(table, who, what)?;
    let trivial = |n: f64| {
        let same = |a: f64| (n.abs() - a.abs()).abs() <= COPIED * a.abs();
        n.abs() <= 0.0 || round(n) || same(1.0) || numbers.given.iter().any(|g| same(*g))
    };
    // Of its size, and of its sign where the other one cannot be.
    let possible = |n: f64, key: f64, kind: Signs| {
        let ratio = n / key;
        let ratio = if kind == Signs::Directed { ratio.abs() } else { ratio };
        ratio.is_finite() && (1.0 / REACH..=REACH).contains(&ratio)
    };
    if trivial(x) || !possible(x, key, kind) {
        return None;
    }
    let own =
        |part: usize| winners.get(who * table.columns.len() + first + part).map_or(f64::NAN, |w| w.number);
    let mut wrong = None;
    for part in &follow.from {
        let answer = own(*part);
        let (key, half_width, kind) = number(table, who, first + part)?;
        if !answer.is_finite() {
            return None;
        }
        if !accepts(answer, key, half_width) {
            if trivial(answer) || !possible(answer, key, kind) {
                return None;
            }
            wrong = wrong.or(Some(first + part));
        }
    }
    let source = wrong.or_else(|| follow.from.first().map(|part| first + part))?;
    let by = |right_ones_are_the_keys: bool| {
        follow.by.eval(&|given| match given {
            Given::Known(i, factor) => numbers.known.get(i).map_or(f64::NAN, |n| n * factor),
            Given::Part(part) => {
                let answer = own(part);
                match number(table, who, first + part) {
                    Some((key, half, _)) if right_ones_are_the_keys && accepts(answer, key, half) => key,
                    _ => answer,
                }
            }
        })
    };
    // The relative tolerance of the part, around what follows.
    let share = half_width / key.abs();
    let meets = |y: f64| {
        let y = if kind == Signs::Magnitude { y.abs() } else { y };
        y.is_finite() && possible(y, key, kind) && (x - y).abs() <= share * y.abs()
    };
    (meets(by(true)) || meets(by(false))).then_some(source)
}

/// Which signs a number may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Signs {
    /// Never negative.
    Magnitude,
    /// Along a line, so that a wrong one may well have the other sign.
    Directed,
    /// The sign of the key: a cord does not push.
    Signed,
}

/// One significant figure: a guess.
fn round(n: f64) -> bool {
    let text = format!("{n:.0e}");
    text.parse::<f64>().is_ok_and(|r| (n - r).abs() <= 1e-9 * n.abs())
}

/// Key, accepted half-width, and which signs it may have.
fn number(table: &KeyTable, who: usize, what: usize) -> Option<(f64, f64, Signs)> {
    match table.entry(who, what)?.answer {
        Answer::Number { value, half_width, magnitude, directed, .. } => {
            let kind = match (magnitude, directed) {
                (_, true) => Signs::Directed,
                (true, false) => Signs::Magnitude,
                (false, false) => Signs::Signed,
            };
            Some((value, half_width, kind))
        }
        Answer::Word { .. } => None,
    }
}
