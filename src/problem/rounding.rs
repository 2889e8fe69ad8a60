//! How far an honest answer may be off that was computed with few figures on the way.
//!
//! Somebody who writes down three figures of each intermediate result is off by up to half a unit of the third at each
//! step. Here each datum but g enters with two such errors, with leading digits as numbers have them (evenly spread
//! logarithm), and the answer is rounded too; what comes out is held against the tolerance. It stands in for a calculation step
//! by step, which needs a worked solution (those are worked by hand in `solution::by_hand`, and scored in `tests/grading/scoring.rs`), and
//! errs on the careful side: of the slip distances and heats of a wheel pulled with slip that were computed in such steps 14 to
//! 18 % missed 1 %, of these 22 %.
use crate::bank::Problem;
use crate::draw::stream::DrawWords;
use crate::num::shown;
use crate::num::trig::power;
use crate::problem::make_key;
use crate::problem::variant::Variant;
use crate::solve::agree;
use crate::solve::outcome::Scope;

/// Roundings that a datum goes through on its way to the answer.
const ROUNDINGS: usize = 2;
/// Steps of the lots that choose a rounding.
const STEPS: u64 = 1 << 20;

/// For each question: would this try of an honest answer miss the tolerance? `None` where that cannot be said (words; the rounded
/// data give no such answer).
pub fn misses(
    problem: &Problem,
    variant: &Variant,
    words: &mut DrawWords,
    attempt: u32,
) -> Vec<Option<bool>> {
    words.attempt(attempt);
    let scene = &problem.cases[variant.case].scene;
    let mut out = vec![None; problem.questions.len()];
    let mut figures: Vec<u8> = problem.questions.iter().map(|q| q.figures).collect();
    figures.sort_unstable();
    figures.dedup();
    for figures in figures {
        let mut data = variant.data.clone();
        // The last one is g, which is printed as it is used.
        let own = data.len().saturating_sub(1);
        for (i, x) in data.iter_mut().take(own).enumerate() {
            for r in 0..ROUNDINGS {
                *x *= 1.0 + rounding(words, 2 * (ROUNDINGS * i + r), figures);
            }
        }
        let Ok(half) = agree::first(scene, &data, Scope::ALL) else { continue };
        let asked = problem.questions.iter().zip(&mut out).filter(|(q, _)| q.figures == figures);
        for (question, missed) in asked {
            let (Some(right), Some(rough)) =
                (variant.solved.get(question.label), half.preview().get(question.label))
            else {
                continue;
            };
            let width = make_key::half_width(question, right.value(), right.scale, right.cond);
            let answer = question.unit.from_si(rough.value());
            let written = question.unit.to_si(significant(answer, figures));
            *missed = Some(!(written - right.value()).abs().le(&width));
        }
    }
    out
}

/// Relative error of a number that was rounded to so many figures.
fn rounding(words: &mut DrawWords, lot: usize, figures: u8) -> f64 {
    let mut share = |lot| {
        let drawn = u32::try_from(words.below(lot, STEPS)).unwrap_or(0);
        f64::from(drawn) / f64::from(u32::try_from(STEPS).unwrap_or(1))
    };
    let (place, leading) = (share(lot) - 0.5, share(lot + 1));
    let unit = power(10.0, 1.0 - f64::from(figures));
    place * unit / power(10.0, leading)
}

/// The number rounded to so many figures.
fn significant(value: f64, figures: u8) -> f64 {
    shown::rounded(value, usize::from(figures))
}
