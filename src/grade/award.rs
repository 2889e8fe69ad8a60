//! What an answer that counts earns, and how the reason tells it: slips, credit, attempts, lateness, corrections.
use crate::grade::attempt::Winner;
use crate::grade::cells::GradingJob;
use crate::grade::credit::{CreditFor, credit};
use crate::grade::diagnose::{AnswerSlip, Diagnosis, diagnose};
use crate::grade::feedback::Feedback;
use crate::grade::table::KeyTable;
use crate::grade::verdict::{Judgement, Verdict};
use crate::policy::time::Doubt;
use crate::policy::{self, Unread};
use std::borrow::Cow;

/// What a wrong answer fits, as words for machines: ids of wrong methods, and a slip.
pub(crate) struct Fits {
    pub methods: String,
    pub slip: String,
    near: Vec<u16>,
}

/// A slip as a word for machines, and as students are told.
fn slip_in_words<'w>(
    slip: AnswerSlip,
    table: &KeyTable,
    what: u32,
    say: &Feedback<'w>,
) -> (String, Cow<'w, str>) {
    let number = |word: &str, n: String| {
        (format!("{word}:{n}"), say.fill(&format!("feedback.slip.{word}"), &[("n", &n)]))
    };
    match slip {
        AnswerSlip::PowerOfTen(n) => number("power_of_ten", n.to_string()),
        AnswerSlip::Unit(from, to) => {
            (format!("unit:{from}"), say.fill("feedback.slip.unit", &[("from", from), ("to", to)]))
        }
        AnswerSlip::FewerFigures(n) => number("figures", n.to_string()),
        AnswerSlip::Drift => ("drift".to_owned(), Cow::Borrowed(say.get("feedback.slip.drift"))),
        AnswerSlip::OtherPart(i) => {
            let other = table.columns.get(table.first_of(what as usize) + i).map_or("", |c| c.part.as_str());
            (format!("part:{other}"), say.fill("feedback.slip.other_part", &[("part", other)]))
        }
    }
}

/// Tells a slip in the reason; ids of methods have a column of their own.
pub(crate) fn diagnosed(
    job: &GradingJob,
    (who, what): (u32, u32),
    cell: &[u8],
    judgement: &mut Judgement,
) -> Fits {
    let GradingJob { table, say, .. } = *job;
    let methods = table.methods(what as usize);
    let at = (who as usize, what as usize);
    let Diagnosis { methods: found, near, slip } = match table.problem_of(at.0, at.1) {
        Some((key, part)) => diagnose(judgement.number, cell, part, &key.parts, job.wrong_values(at.0, at.1)),
        None => Diagnosis::default(),
    };
    let ids: Vec<&str> = found.iter().filter_map(|m| Some(methods.get(usize::from(*m))?.as_str())).collect();
    let mut fits = Fits { methods: ids.join(" "), slip: String::new(), near };
    if let Some((word, told)) = slip.map(|slip| slip_in_words(slip, table, what, say)) {
        judgement.reason = Cow::Owned(format!("{}; {told}", judgement.reason));
        fits.slip = word;
    }
    fits
}

/// A share as students read it: `50 %`.
fn percent(share: f64) -> String {
    format!("{} %", policy::plain(share * 100.0))
}

/// Points of a cell that counts, why they are not simply all or nothing (in words for machines), and the same in the reason.
pub(crate) fn awarded(
    job: &GradingJob,
    (who, what): (u32, u32),
    judgement: &mut Judgement,
    fits: Option<&Fits>,
    (winner, submitted): (&Winner, &[u8]),
    winners: &[Winner],
) -> (f64, String) {
    let (table, say) = (job.table, job.say);
    let points = table.points(job.index(who, what));
    let mut words: Vec<String> = Vec::new();
    let mut told: Vec<Cow<str>> = Vec::new();
    let mut share = match judgement.verdict {
        Verdict::Right => 1.0,
        Verdict::Wrong | Verdict::WrongDirection => {
            let at = (who as usize, what as usize);
            let earned = credit(judgement.number, at, job, winners, fits.map(|f| f.near.as_slice()));
            let share = percent(earned.share);
            match earned.why {
                CreditFor::Nothing => {}
                CreditFor::Method => {
                    words.push("methods".to_owned());
                    told.push(say.fill("feedback.credit.method", &[("share", &share)]));
                }
                CreditFor::Follows(column) => {
                    let part = &table.columns[column].part;
                    words.push(format!("follow:{part}"));
                    told.push(say.fill("feedback.credit.follows", &[("part", part), ("share", &share)]));
                }
            }
            earned.share
        }
        _ => 0.0,
    };
    if share > 0.0 && winner.attempt < 1.0 {
        words.push(format!("attempt:{}", policy::plain(winner.attempt)));
        told.push(say.fill("feedback.credit.attempt", &[("share", &percent(winner.attempt))]));
    }
    if winner.closed {
        words.push("closed".to_owned());
        told.push(Cow::Borrowed(say.get("feedback.credit.closed")));
    } else if share > 0.0 && winner.late < 1.0 {
        words.push(format!("late:{}", policy::plain(winner.late)));
        told.push(say.fill("feedback.credit.late", &[("share", &percent(winner.late))]));
    }
    share *= winner.attempt * winner.late;
    if job.rules.policy.timed() && (winner.undated || job.layout.submitted.is_none()) {
        let taken = say.get(match job.rules.policy.late.unread {
            Some(Unread::Late) => "feedback.credit.undated_late",
            _ => "feedback.credit.undated",
        });
        let why = match job.rules.policy.zone.doubt(&String::from_utf8_lossy(submitted)) {
            None => None,
            Some(Doubt::WholeDay) => Some(Cow::Borrowed(say.get("feedback.credit.no_hour"))),
            Some(Doubt::Weekday) => Some(Cow::Borrowed(say.get("feedback.credit.weekday"))),
            Some(Doubt::Zone(word)) => Some(say.fill("feedback.credit.zones", &[("zone", word.name())])),
        };
        told.push(why.map_or(Cow::Borrowed(taken), |why| Cow::Owned(format!("{taken} ({why})"))));
    } else if job.rules.policy.timed() && winner.whole_day {
        told.push(Cow::Borrowed(say.get("feedback.credit.midnight")));
    }
    if let Some((given, why)) = job.rules.correction(what as usize, true)
        && given > share
    {
        share = given;
        words.push("correction".to_owned());
        told.push(say.fill("feedback.credit.correction", &[("share", &percent(given)), ("why", why)]));
    }
    if !told.is_empty() {
        judgement.reason = Cow::Owned(format!("{}; {}", judgement.reason, told.join("; ")));
    }
    (if share >= 1.0 { points } else { policy::plain(points * share) }, words.join(" "))
}
