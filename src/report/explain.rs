//! Everything about one mark, in words.
use crate::answer::read::{Reading, UnitCache, read};
use crate::bank::{Problem, Relative};
use crate::grade::compare;
use crate::grade::feedback::Feedback;
use crate::grade::row::{AnswerRow, OF_ANOTHER};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, Given, KeyEntry, ProblemKey};
use crate::misconception::catalogue::Catalogue;
use crate::num::shown;
use crate::policy::time::{Evidence, Moment};
use crate::policy::{self, For, Per, Policy, RoundingWay, Unread};
use crate::problem::maker::Variant;
use crate::regrade::changes::ChangeRow;
use crate::set::grading::{JOINED, StoredGrading};
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::sheet::terminal;
use crate::words::plain::{beginning, capital, plain};
use std::fmt::Write as _;

/// Figures of keys and answers in the text.
const FIGURES: usize = 9;
/// Letters of a cell that are shown.
const LONGEST: usize = 120;
/// Width of the text.
const WIDTH: usize = 100;

/// A line below a heading, worded as by `format!`.
macro_rules! say {
    ($page:ident, $($text:tt)*) => { $page.say(1, &format!($($text)*)) };
}
macro_rules! head {
    ($page:ident, $($text:tt)*) => { $page.say(0, &format!($($text)*)) };
}

/// Lines that are wrapped when all is said.
#[derive(Default)]
struct WrappedText(String);

impl WrappedText {
    /// A line, a heading at depth 0; below a heading wrapped, further lines set in.
    fn say(&mut self, depth: usize, text: &str) {
        let indent = "  ".repeat(depth);
        let mut line = indent.clone();
        for word in text.split(' ') {
            let long = depth > 0 && line.chars().count() + 1 + word.chars().count() > WIDTH;
            if long && line.trim() != "" {
                let _ = writeln!(self.0, "{}", line.trim_end());
                line = format!("{indent}    ");
            } else if line.trim() != "" {
                line.push(' ');
            }
            line.push_str(word);
        }
        let _ = writeln!(self.0, "{}", line.trim_end());
    }
}

/// The marks of one student for one problem, and what they were made from.
pub struct ExplainedMarks<'g> {
    pub set: &'g StoredSet,
    pub student: &'g StoredStudent,
    /// Number of the problem in the set, from 1.
    pub number: usize,
    pub problem: &'g Problem,
    /// The student's key.
    pub key: &'g ProblemKey,
    /// What the student was dealt.
    pub variant: &'g Variant,
    /// Settings by which it was graded.
    pub policy: &'g Policy,
    pub grading: &'g StoredGrading,
    /// What the times of all answers say about the order of day and month.
    pub evidence: Evidence,
    /// The student's answers to this problem.
    pub rows: &'g [AnswerRow<'g>],
    /// What a regrading changed.
    pub changes: &'g [ChangeRow],
    /// Columns `total`, `max_total` and `dropped` of the gradebook.
    pub total: Option<[String; 3]>,
}

/// What a regrading changed for one part, in words.
fn regraded(row: &ChangeRow) -> String {
    let told = |points: &str, verdict: &str| match (points, verdict) {
        ("", "") => "no answer".to_owned(),
        (points, "") => format!("{} without an answer", in_points(points)),
        ("", verdict) => verdict.to_owned(),
        (points, verdict) => format!("{} ({verdict})", in_points(points)),
    };
    let before = told(&row.points_before, &row.verdict_before);
    let after = told(&row.points_after, &row.verdict_after);
    format!("regraded: {before} before, {after} now ({})", row.why)
}

fn in_points(text: &str) -> String {
    if text == "1" { "1 point".to_owned() } else { format!("{text} points") }
}

/// The data of a variant as they are printed, with its case.
fn data(stored: &StoredVariant) -> String {
    let case = if stored.case.is_empty() { String::new() } else { format!("case {}: ", stored.case) };
    let shown = |(symbol, value): (&String, &serde_json::Value)| {
        format!("{symbol} = {}", value.as_str().unwrap_or_default())
    };
    let data: Vec<String> = stored.data.iter().map(shown).collect();
    format!("{case}{}", data.join(", "))
}

impl ExplainedMarks<'_> {
    /// All of it, or what concerns one part, in words.
    pub fn text(&self, part: Option<&str>) -> String {
        let (student, number) = (self.student, self.number);
        let mut page = WrappedText::default();
        let called = if student.name.is_empty() { String::new() } else { format!(" ({})", student.name) };
        head!(
            page,
            "{}{called}, problem {number} ({}) of set {}",
            student.student,
            self.problem.id,
            self.set.name
        );
        page.say(0, "");
        page.say(0, "Data on the sheet");
        if let Some(stored) = number.checked_sub(1).and_then(|i| student.problems.get(i)) {
            page.say(1, &data(stored));
            for (asked, other) in stored.parts.iter().filter(|(id, _)| part.is_none_or(|p| p == id.as_str()))
            {
                say!(page, "{number}.{asked} was asked with {}", data(other));
            }
        }
        for (i, entry) in self.key.parts.iter().enumerate() {
            if part.is_none_or(|p| *p == entry.part) {
                self.part(&mut page, i);
                for change in self.changes.iter().filter(|c| c.part == entry.part) {
                    page.say(1, &regraded(change));
                }
            }
        }
        page.say(0, "");
        page.say(0, "The total");
        self.whole(&mut page);
        page.say(0, "");
        page.say(0, "What it was graded with");
        self.provenance(&mut page);
        page.0
    }

    /// How the total of the gradebook is made.
    fn whole(&self, page: &mut WrappedText) {
        let Some([total, most, dropped]) = &self.total else { return };
        let policy = self.policy;
        let mut text = format!("{total} of {most} points");
        if policy.drop_lowest > 0 {
            let told = if dropped.is_empty() { "none here" } else { dropped };
            let _ = write!(
                text,
                "; of the problems the lowest {} are dropped by their share of points: {told}",
                policy.drop_lowest
            );
        }
        if let Some(rounding) = policy.rounding {
            let way = match rounding.way {
                RoundingWay::Nearest => "to the nearest multiple of",
                RoundingWay::Up => "up to multiples of",
                RoundingWay::Down => "down to multiples of",
            };
            let _ = write!(text, "; rounded {way} {}", rounding.to);
        }
        page.say(1, &text);
    }

    fn provenance(&self, page: &mut WrappedText) {
        let made = self.grading;
        say!(
            page,
            "{}, draw version {}; set {} from seed {}{}",
            made.program,
            made.draw_version,
            made.set,
            made.seed,
            if made.replayed { "" } else { ", not replayed" }
        );
        let drawn = self.set.bank.sha256.as_str();
        let other = if drawn == made.bank_sha256 {
            String::new()
        } else {
            format!("; the sheets were drawn from {drawn}")
        };
        say!(page, "bank {}, SHA-256 {}{other}", made.bank, made.bank_sha256);
        let key = match made.replayed {
            true => "solved anew for this text, and the same",
            false => "as it was stored with the set, which an earlier version drew",
        };
        say!(page, "key, SHA-256 {}; {key}", made.key_sha256);
        if let Some(course) = &made.course_sha256 {
            say!(page, "course, SHA-256 {course}");
        }
        match made.submissions_files {
            Some(files) => say!(
                page,
                "submissions: {}, {} joined, as kept in {JOINED}",
                made.submissions,
                terminal::count(files, "file")
            ),
            None => say!(page, "submissions: {}, {} bytes", made.submissions, made.submissions_bytes),
        }
    }

    fn part(&self, page: &mut WrappedText, index: usize) {
        let entry = &self.key.parts[index];
        let rows: Vec<&AnswerRow> = self.rows.iter().filter(|r| r.part == entry.part).collect();
        let counting = rows.iter().find(|r| r.counts());
        let policy = self.policy;
        let most = policy
            .points
            .iter()
            .find(|(p, _)| p.means(self.number, &self.problem.id, &entry.part))
            .map_or(entry.points, |(_, points)| *points);
        page.say(0, "");
        let outcome = match counting {
            Some(row) => format!("{} of {} points, {}", row.points, row.max_points, row.verdict),
            None => match policy.correction(self.number, &self.problem.id, &entry.part, false) {
                Some(c) if c.to == For::All => {
                    format!("no answer, {} of {most} points by a correction", policy::plain(c.share * most))
                }
                _ => format!("no answer, of {most} points"),
            },
        };
        head!(page, "{}.{}: {outcome}", self.number, entry.part);
        self.asked(page, index);
        if rows.is_empty() {
            page.say(1, "attempts: none was handed in");
        } else {
            match self.grading.submissions_files {
                Some(_) => say!(page, "attempts, in the order of {JOINED}:"),
                None => page.say(1, "attempts, in the order of the file:"),
            }
        }
        for row in &rows {
            self.attempt(page, index, row);
        }
        if let Some(row) = counting {
            if rows.iter().filter(|r| r.verdict != Verdict::Blank).count() > 1 {
                let at_most =
                    policy.attempts.at_most.map_or_else(String::new, |n| format!(" of the first {n}"));
                say!(
                    page,
                    "which counts: the {}{at_most}; that is line {}",
                    match policy.attempts.counts.as_str() {
                        "best" => "one with the most points",
                        other => other,
                    },
                    row.line
                );
            }
            self.why(page, index, row);
        }
        let correction = policy.correction(self.number, &self.problem.id, &entry.part, counting.is_some());
        if let Some(correction) = correction {
            page.say(1, &correction.in_words("this part"));
        }
    }

    /// What was asked, the key and its tolerance.
    fn asked(&self, page: &mut WrappedText, index: usize) {
        let entry = &self.key.parts[index];
        let question = self.problem.questions.iter().find(|q| q.id == entry.part);
        let label = question.and_then(|q| {
            let case = self.problem.cases.get(self.variant.case)?;
            Some(case.scene.name_of(q.label))
        });
        let label = label.unwrap_or_else(|| entry.part.clone());
        match &entry.answer {
            Answer::Word { right, offered } => {
                say!(page, "asked: {label}, a word of {}; the key is {right}", offered.join(", "));
            }
            Answer::Number { value, half_width, .. } => {
                let unit = &entry.unit;
                let shown = |si: f64| shown::significant(unit.from_si(si), FIGURES);
                let road = |si: Option<f64>| si.map_or_else(|| "none".to_owned(), shown);
                say!(page, "asked: {label}, {}", in_unit(entry));
                say!(
                    page,
                    "key: {}; equations of motion {}, work and energy {}, gap {}; condition number {}{}",
                    unit.text_with(&shown(*value)),
                    road(entry.eom),
                    road(entry.energy),
                    entry.gap.map_or_else(
                        || "unknown".to_owned(),
                        |g| match g > 0.0 {
                            true => shown::figures(g, 1),
                            false => "0".to_owned(),
                        }
                    ),
                    entry.cond.map_or_else(|| "unknown".to_owned(), |c| shown::significant(c, 3)),
                    entry.bound.map_or_else(String::new, |b| format!(
                        "; the true answer lies within {} of it, proved",
                        shown::figures(unit.from_si(b), 1)
                    ))
                );
                let rule = question.map_or_else(String::new, |q| rule(q, entry, *value, *half_width));
                say!(
                    page,
                    "tolerance: {rule}, which is {} to either side: right is what lies from {} to {}",
                    unit.text_with(&shown::significant(unit.from_si(*half_width), 5)),
                    shown(value - half_width),
                    shown(value + half_width)
                );
            }
        }
    }

    /// One attempt: what was written, how it was read, what it is.
    fn attempt(&self, page: &mut WrappedText, index: usize, row: &AnswerRow) {
        let entry = &self.key.parts[index];
        let mut units = UnitCache::default();
        let judged = compare::compare_with(&row.answer, entry, &mut units, Feedback::english());
        let when =
            if row.submitted_at.is_empty() { String::new() } else { format!(", {}", row.submitted_at) };
        let place = if row.column.is_empty() { String::new() } else { format!(", column {}", row.column) };
        let mut text = format!("line {}{place}{when}: `{}`", row.line, beginning(&row.answer, LONGEST));
        // What was written to other data is not held against this key.
        let of_another = row.credit.starts_with(OF_ANOTHER);
        match read(&row.answer, &mut units) {
            _ if of_another => {}
            Reading::Number(number) => {
                let unit = number.unit_for(&entry.unit).map_or_else(
                    || match entry.unit.is_number() {
                        true => "without unit".to_owned(),
                        false => format!("without unit, so {}", entry.unit.ascii()),
                    },
                    |u| format!("in {}", u.ascii()),
                );
                let _ = write!(text, ", read as {} {unit}", number.value);
                if let Some(word) = number.word {
                    let _ = write!(text, ", {}", word.as_str());
                }
                if judged.number.is_finite() {
                    let (asked, si) = (entry.unit.from_si(judged.number), judged.number);
                    let _ = write!(
                        text,
                        ", that is {}",
                        entry.unit.text_with(&shown::significant(asked, FIGURES))
                    );
                    if (asked - si).abs() > 1e-12 * si.abs() {
                        let _ = write!(text, " ({} in SI)", shown::significant(si, FIGURES));
                    }
                    if let Answer::Number { value, .. } = entry.answer
                        && value != 0.0
                    {
                        let off = (judged.number - value) / value.abs();
                        let _ = write!(text, ", {} from the key", signed_per_cent(off));
                    }
                }
            }
            Reading::Word(word) => {
                let _ = write!(text, ", read as the word {}", word.as_str());
            }
            Reading::Blank | Reading::Unreadable(_) => {}
        }
        let _ = match row.verdict {
            Verdict::Superseded => write!(text, ". {}", capital(&row.reason)),
            verdict => write!(text, ". {}: {}", capital(verdict.as_str()), row.reason),
        };
        page.say(2, &text);
    }

    /// Methods, slip and how the points of the attempt that counts add up.
    fn why(&self, page: &mut WrappedText, index: usize, row: &AnswerRow) {
        let entry = &self.key.parts[index];
        let catalogue = Catalogue::shared("en");
        for id in row.methods.split_whitespace() {
            let at = self.key.methods.iter().position(|m| m == id);
            let value = at.and_then(|m| entry.wrong.iter().find(|w| usize::from(w.method) == m));
            let comes = value.map_or_else(String::new, |w| {
                let shown = shown::significant(entry.unit.from_si(w.value), FIGURES);
                format!(" (which comes to {})", entry.unit.text_with(&shown))
            });
            let told = catalogue
                .get(id)
                .map_or_else(String::new, |e| format!(": {} {}", plain(&e.did), plain(&e.see)));
            say!(page, "fits the wrong method {id}{comes}{told}");
        }
        if let Some(slip) = slip(&row.slip) {
            say!(page, "fits a slip: {slip}");
        }
        if row.credit.split(' ').any(|w| w.starts_with("follow:")) {
            self.follows(page, index, row);
        }
        if self.policy.timed() {
            page.say(1, &self.late(row));
        }
        let points = points(row, self.policy);
        say!(page, "points: {points}");
    }

    /// When it was due, when it came, how late that is.
    fn late(&self, row: &AnswerRow) -> String {
        let policy = self.policy;
        let zone = &policy.zone;
        let extended = policy.extensions.iter().any(|(id, _)| *id == self.student.student);
        let due = policy.due_for(&self.student.student);
        let mut text = match due {
            Some(due) => {
                let why = if extended { " (extension)" } else { "" };
                format!("due: {} {}{why}", zone.shown(due), zone.name())
            }
            None => format!("due: at no time ({})", zone.name()),
        };
        if let Some(closes) = policy.closes_for(&self.student.student) {
            let _ = write!(text, ", nothing counts after {}", zone.shown(closes));
        }
        let certain = |m: &Moment| m.uncertain.is_none_or(|dotted| self.evidence.decides(dotted));
        let limits = (due.unwrap_or(i64::MAX), policy.closes_for(&self.student.student).unwrap_or(i64::MAX));
        let choice = self.evidence.choice();
        let known =
            |m: &Moment| certain(m) && !(m.whole_day && policy.hour_matters(limits, m.micros[choice]));
        let Some(moment) = zone.read(&row.submitted_at).filter(known) else {
            let unread = policy.late.unread.map_or("in time", Unread::as_str);
            let doubt = zone.doubt(&row.submitted_at).map_or_else(String::new, |d| format!(" ({d})"));
            let _ = write!(text, "; when it came cannot be read{doubt}, so it is taken as {unread}");
            return text;
        };
        let at = moment.micros[choice];
        let _ = write!(text, "; came {}", zone.shown(at));
        if moment.whole_day {
            text.push_str(" (no time of day is written)");
        }
        match due {
            Some(due) if at > due => {
                let late = &policy.late;
                let minutes = (at - due + policy::MINUTE - 1) / policy::MINUTE;
                let (days, hours, minutes) = (minutes / 1440, minutes / 60 % 24, minutes % 60);
                let _ = write!(
                    text,
                    ", {days} d {hours} h {minutes} min late; lateness costs {} %{}, at most {} %",
                    shown::per_cent(late.penalty, 3),
                    match late.per {
                        Per::Once => "",
                        Per::Hour => " for each begun hour",
                        Per::Day => " for each begun day",
                    },
                    shown::per_cent(late.most, 3)
                );
                if late.grace > 0 {
                    let _ = write!(text, ", {} min are no lateness", late.grace / policy::MINUTE);
                }
            }
            _ => text.push_str(", in time"),
        }
        text
    }

    /// What the relation comes to with the student's own answers.
    fn follows(&self, page: &mut WrappedText, index: usize, row: &AnswerRow) {
        let written = self.problem.follows.iter().find(|f| {
            self.problem.questions.get(f.question).is_some_and(|q| q.id == self.key.parts[index].part)
        });
        let (Some(written), Some(follow)) = (written, self.key.follows.iter().find(|f| f.part == index))
        else {
            return;
        };
        let number = |part: usize, row: &AnswerRow| {
            let entry = self.key.parts.get(part)?;
            Some(
                compare::compare_with(&row.answer, entry, &mut UnitCache::default(), Feedback::english())
                    .number,
            )
        };
        let own = |part: usize| {
            let id = self.key.parts.get(part).map(|e| e.part.as_str());
            let row = self.rows.iter().find(|r| r.counts() && Some(&*r.part) == id);
            row.and_then(|r| Some((number(part, r)?, r.verdict == Verdict::Right)))
                .unwrap_or((f64::NAN, false))
        };
        // A right answer may stand for itself or for the key's.
        let by = |keys: bool| {
            follow.by.eval(&|given| match given {
                Given::Known(i, factor) => self.key.known.get(i).map_or(f64::NAN, |n| n * factor),
                Given::Part(part) => match (own(part), self.key.parts.get(part).map(|e| &e.answer)) {
                    ((_, true), Some(Answer::Number { value, .. })) if keys => *value,
                    ((answer, _), _) => answer,
                },
            })
        };
        let entry = &self.key.parts[index];
        let answer = number(index, row).unwrap_or(f64::NAN);
        let near = |y: f64| (y.abs() - answer.abs()).abs();
        let value = if near(by(true)) <= near(by(false)) { by(true) } else { by(false) };
        let from: Vec<&str> =
            follow.from.iter().filter_map(|p| self.key.parts.get(*p)).map(|e| e.part.as_str()).collect();
        say!(
            page,
            "follow-through: {} = {}, with the student's own {} it comes to {}",
            entry.part,
            written.text,
            from.join(" and "),
            entry.unit.text_with(&shown::significant(entry.unit.from_si(value), FIGURES))
        );
    }
}

fn in_unit(entry: &KeyEntry) -> String {
    match (entry.unit.is_number(), entry.unit_required) {
        (true, _) => "a plain number".to_owned(),
        (false, true) => format!("in {}, the unit must be written", entry.unit.ascii()),
        (false, false) => format!("in {}", entry.unit.ascii()),
    }
}

fn rule(question: &crate::bank::Question, entry: &KeyEntry, value: f64, half_width: f64) -> String {
    let share = question.relative.at(entry.cond.unwrap_or(f64::NAN));
    if share * value.abs() * (1.0 + 1e-9) < half_width {
        return match question.absolute {
            Some(_) => "the absolute one of the bank".to_owned(),
            None => "a thousandth of the largest term, because the answer may vanish".to_owned(),
        };
    }
    match question.relative {
        Relative::Fixed(_) => format!("{} % of the key", shown::per_cent(share, 3)),
        Relative::Widens { .. } => {
            format!("{} % of the key, by its condition number", shown::per_cent(share, 3))
        }
    }
}

fn signed_per_cent(share: f64) -> String {
    let share = share * 100.0;
    let sign = if share < 0.0 { "-" } else { "+" };
    format!("{sign}{} %", shown::significant(share.abs(), 3))
}

/// The column `slip` in words.
fn slip(text: &str) -> Option<String> {
    let (kind, what) = text.split_once(':').unwrap_or((text, ""));
    Some(match kind {
        "" => return None,
        "power_of_ten" => format!("the right number times ten to the power {what}"),
        "unit" => format!("the right number in {what}"),
        "figures" => format!("the right number, rounded to {what} figures"),
        "drift" => "as far off as rounding intermediate results to three figures explains".to_owned(),
        "part" => format!("the right number of part {what}"),
        _ => text.to_owned(),
    })
}

/// How the points of a row come about.
fn points(row: &AnswerRow, policy: &Policy) -> String {
    let mut steps = vec![match row.verdict {
        Verdict::Right => format!("{} for a right answer", row.max_points),
        _ => format!("0 of {}, the answer is not right", row.max_points),
    }];
    for word in row.credit.split_whitespace() {
        let (kind, what) = word.split_once(':').unwrap_or((word, ""));
        match kind {
            "methods" => {
                let share = row.methods.split(' ').map(|id| policy.credit.of(id)).fold(0.0, f64::max);
                steps[0] =
                    format!("{} % of {} for a known wrong method", shown::per_cent(share, 3), row.max_points);
            }
            "follow" => {
                let share = shown::per_cent(policy.credit.follow, 3);
                steps[0] = format!(
                    "{share} % of {}, because the answer follows correctly from the student's own answer to {what}",
                    row.max_points
                );
            }
            "attempt" => steps.push(format!(
                "times {what} for earlier attempts (each costs {} %, {} % are left at least)",
                shown::per_cent(policy.attempts.penalty, 3),
                shown::per_cent(policy.attempts.least, 3)
            )),
            "late" => steps.push(format!("times {what} for lateness")),
            "closed" => steps.push("nothing, because it came after the end".to_owned()),
            "correction" => steps.push("raised to what a correction gives to all".to_owned()),
            _ => steps.push(word.to_owned()),
        }
    }
    format!("{}; together {}", steps.join(", "), row.points)
}
