//! Everything about one mark, in words.
use crate::answer::read::{Reading, UnitCache, read};
use crate::bank::{Problem, Relative};
use crate::finding::Findings;
use crate::grade::compare;
use crate::grade::feedback::Feedback;
use crate::grade::row::{AnswerRow, OF_ANOTHER};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, Given, KeyEntry, ProblemKey};
use crate::misconception::catalogue::Catalogue;
use crate::num::shown;
use crate::policy::time::{Evidence, Moment};
use crate::policy::{self, For, Policy, Unread};
use crate::problem::maker::Variant;
use crate::regrade::changes::ChangeRow;
use crate::set::grading::{JOINED, StoredGrading};
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::sheet::terminal;
use crate::template::{Templates, View};
use crate::words::plain::{beginning, capital, plain};
use serde_json::{Value, json};

/// Figures of keys and answers in the text.
const FIGURES: usize = 9;
/// Letters of a cell that are shown.
const LONGEST: usize = 120;
/// Width of the text.
const WIDTH: usize = 100;

/// The lines of a text: what is set in is wrapped, with further lines set in more.
fn wrapped(text: &str) -> String {
    let mut out = String::new();
    for set_in in text.lines() {
        let words = set_in.trim_start_matches(' ');
        let indent = &set_in[..set_in.len() - words.len()];
        let mut line = indent.to_owned();
        for word in words.split(' ') {
            let long = !indent.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH;
            if long && line.trim() != "" {
                out.extend([line.trim_end(), "\n"]);
                line = format!("{indent}    ");
            } else if line.trim() != "" {
                line.push(' ');
            }
            line.push_str(word);
        }
        out.extend([line.trim_end(), "\n"]);
    }
    out
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

/// Points and verdict of a part before or after a regrading.
fn marked(points: &str, verdict: &str) -> String {
    let points = match points {
        "" => String::new(),
        "1" => "1 point".to_owned(),
        points => format!("{points} points"),
    };
    match (points.as_str(), verdict) {
        ("", "") => "no answer".to_owned(),
        (points, "") => format!("{points} without an answer"),
        ("", verdict) => verdict.to_owned(),
        (points, verdict) => format!("{points} ({verdict})"),
    }
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

/// A word such as `late:0.8`: what it is about, and the rest.
fn kind_and_rest(word: &str) -> Value {
    let (kind, what) = word.split_once(':').unwrap_or((word, ""));
    json!({"kind": kind, "what": what, "text": word})
}

impl ExplainedMarks<'_> {
    /// All of it, or what concerns one part, in words: those of the template `explain.txt`. Errors: a fault of the template.
    pub fn text(&self, part: Option<&str>) -> Result<String, Findings> {
        let (student, made, policy) = (self.student, self.grading, self.policy);
        let stored = self.number.checked_sub(1).and_then(|i| student.problems.get(i));
        let asks = |id: &str| part.is_none_or(|p| p == id);
        let others = stored.into_iter().flat_map(|s| &s.parts).filter(|(id, _)| asks(id));
        let parts = self.key.parts.iter().enumerate().filter(|(_, entry)| asks(&entry.part));
        let per_cent = |share: f64| shown::per_cent(share, 3);
        let mut view = View::new();
        view.fields(&json!({
            "student": student.student,
            "name": student.name,
            "number": self.number,
            "problem": self.problem.id,
            "set": self.set.name,
            "data": stored.map(data),
            "others": others.map(|(id, other)| json!({"part": id, "data": data(other)})).collect::<Vec<_>>(),
            "parts": parts.map(|(i, _)| self.part(i)).collect::<Vec<_>>(),
            "counts": policy.attempts.counts.as_str(),
            "at_most": policy.attempts.at_most,
            "attempts": {"penalty": per_cent(policy.attempts.penalty), "least": per_cent(policy.attempts.least)},
            "zone": policy.zone.name(),
            "total": self.total,
            "drop_lowest": policy.drop_lowest,
            "rounding": policy.rounding.map(|r| json!({"way": r.way.as_str(), "to": r.to.to_string()})),
            "made": made,
            "replayed": made.replayed,
            "drawn_from": self.set.bank.sha256,
            "files": made.submissions_files.map(|files| terminal::count(files, "file")),
            "joined": JOINED,
        }));
        let template = include_str!("../../templates/explain.txt");
        let templates = Templates::of_program(&[("explain.txt".to_owned(), template.to_owned())])?;
        Ok(wrapped(&String::from_utf8_lossy(&templates.made("explain.txt", &view)?)))
    }

    fn part(&self, index: usize) -> Value {
        let (entry, policy) = (&self.key.parts[index], self.policy);
        let rows: Vec<&AnswerRow> = self.rows.iter().filter(|r| r.part == entry.part).collect();
        let counting = rows.iter().find(|r| r.counts());
        let means =
            |(part, _): &&(policy::PolicyPart, f64)| part.means(self.number, &self.problem.id, &entry.part);
        let most = policy.points.iter().find(means).map_or(entry.points, |(_, points)| *points);
        let correction = |answered| policy.correction(self.number, &self.problem.id, &entry.part, answered);
        let given = correction(false).filter(|c| c.to == For::All).map(|c| policy::plain(c.share * most));
        let changes = self.changes.iter().filter(|c| c.part == entry.part).map(|c| {
            let before = marked(&c.points_before, &c.verdict_before);
            json!({"before": before, "after": marked(&c.points_after, &c.verdict_after), "why": c.why})
        });
        json!({
            "id": entry.part,
            "of": most.to_string(),
            "given": given.map(|points| points.to_string()),
            "asked": self.asked(index),
            "attempts": rows.iter().map(|row| self.attempt(index, row)).collect::<Vec<_>>(),
            "several": rows.iter().filter(|r| r.verdict != Verdict::Blank).count() > 1,
            "counting": counting.map(|row| self.counting(index, row)),
            "correction": correction(counting.is_some()).map(|c| c.in_words("this part")),
            "changes": changes.collect::<Vec<_>>(),
        })
    }

    /// What was asked, the key and its tolerance.
    fn asked(&self, index: usize) -> Value {
        let entry = &self.key.parts[index];
        let question = self.problem.questions.iter().find(|q| q.id == entry.part);
        let label = question.and_then(|q| {
            let case = self.problem.cases.get(self.variant.case)?;
            Some(case.scene.name_of(q.label))
        });
        let label = label.unwrap_or_else(|| entry.part.clone());
        match &entry.answer {
            Answer::Word { right, offered } => {
                json!({"label": label, "right": right, "offered": offered.join(", ")})
            }
            Answer::Number { value, half_width, .. } => {
                let unit = &entry.unit;
                let shown = |si: f64| shown::significant(unit.from_si(si), FIGURES);
                let or = |number: Option<String>, none: &str| number.unwrap_or_else(|| none.to_owned());
                let gap = |g: f64| if g > 0.0 { shown::figures(g, 1) } else { "0".to_owned() };
                json!({
                    "label": label,
                    "unit": if unit.is_number() { "" } else { unit.ascii() },
                    "unit_required": entry.unit_required,
                    "key": in_unit(entry, *value),
                    "eom": or(entry.eom.map(shown), "none"),
                    "energy": or(entry.energy.map(shown), "none"),
                    "gap": or(entry.gap.map(gap), "unknown"),
                    "cond": or(entry.cond.map(|c| shown::significant(c, 3)), "unknown"),
                    "bound": entry.bound.map(|b| shown::figures(unit.from_si(b), 1)),
                    "rule": question.map_or_else(String::new, |q| rule(q, entry, *value, *half_width)),
                    "half_width": unit.text_with(&shown::significant(unit.from_si(*half_width), 5)),
                    "low": shown(value - half_width),
                    "high": shown(value + half_width),
                })
            }
        }
    }

    /// One attempt: what was written, how it was read, what it is.
    fn attempt(&self, index: usize, row: &AnswerRow) -> Value {
        let entry = &self.key.parts[index];
        let mut units = UnitCache::default();
        let judged = compare::compare_with(&row.answer, entry, &mut units, Feedback::english());
        let (mut number, mut word) = (Value::Null, None);
        // What was written to other data is not held against this key.
        match read(&row.answer, &mut units) {
            _ if row.credit.starts_with(OF_ANOTHER) => {}
            Reading::Number(read) => {
                let unit = match read.unit_for(&entry.unit) {
                    Some(unit) => format!("in {}", unit.ascii()),
                    None if entry.unit.is_number() => "without unit".to_owned(),
                    None => format!("without unit, so {}", entry.unit.ascii()),
                };
                let si = Some(judged.number).filter(|x| x.is_finite());
                let asked = si.map(|si| (entry.unit.from_si(si), si));
                let other = asked.filter(|(asked, si)| (asked - si).abs() > 1e-12 * si.abs());
                let off = match entry.answer {
                    Answer::Number { value, .. } if value != 0.0 => si.map(|si| (si - value) / value.abs()),
                    _ => None,
                };
                let shown = |x: f64| shown::significant(x, FIGURES);
                number = json!({
                    "value": read.value.to_string(),
                    "unit": unit,
                    "word": read.word.map(|word| word.as_str()),
                    "asked": asked.map(|(asked, _)| entry.unit.text_with(&shown(asked))),
                    "si": other.map(|(_, si)| shown(si)),
                    "off": off.map(signed_per_cent),
                });
            }
            Reading::Word(read) => word = Some(read.as_str()),
            Reading::Blank | Reading::Unreadable(_) => {}
        }
        let became = match row.verdict {
            Verdict::Superseded => capital(&row.reason),
            verdict => format!("{}: {}", capital(verdict.as_str()), row.reason),
        };
        json!({
            "line": row.line,
            "column": row.column,
            "when": row.submitted_at,
            "answer": beginning(&row.answer, LONGEST),
            "number": number,
            "word": word,
            "became": became,
        })
    }

    /// The attempt that counts: methods, slip, when it came, and how its points add up.
    fn counting(&self, index: usize, row: &AnswerRow) -> Value {
        let entry = &self.key.parts[index];
        let catalogue = Catalogue::shared("en");
        let methods = row.methods.split_whitespace().map(|id| {
            let at = self.key.methods.iter().position(|m| m == id);
            let wrong = at.and_then(|m| entry.wrong.iter().find(|w| usize::from(w.method) == m));
            let comes = wrong.map(|w| in_unit(entry, w.value));
            let told = catalogue.get(id).map(|e| format!("{} {}", plain(&e.did), plain(&e.see)));
            json!({"id": id, "comes": comes, "told": told})
        });
        // The share that was given last is the one that holds.
        let (mut share, mut followed, mut steps) = (None, None, Vec::new());
        for word in row.credit.split_whitespace() {
            match word.split_once(':').unwrap_or((word, "")) {
                ("methods", _) => {
                    let all = row.methods.split(' ').map(|id| self.policy.credit.of(id));
                    (share, followed) = (Some(all.fold(0.0, f64::max)), None);
                }
                ("follow", what) => (share, followed) = (Some(self.policy.credit.follow), Some(what)),
                _ => steps.push(kind_and_rest(word)),
            }
        }
        let follows = row.credit.split(' ').any(|w| w.starts_with("follow:"));
        json!({
            "line": row.line,
            "points": row.points.to_string(),
            "of": row.max_points.to_string(),
            "verdict": row.verdict.as_str(),
            "methods": methods.collect::<Vec<_>>(),
            "slip": kind_and_rest(&row.slip),
            "follow": if follows { self.follow(index, row) } else { None },
            "late": self.policy.timed().then(|| self.late(row)),
            "share": share.map(|share| shown::per_cent(share, 3)),
            "followed": followed,
            "steps": steps,
        })
    }

    /// When it was due, when it came, how late that is.
    fn late(&self, row: &AnswerRow) -> Value {
        let (policy, zone, student) = (self.policy, &self.policy.zone, &self.student.student);
        let (due, closes) = (policy.due_for(student), policy.closes_for(student));
        let certain = |m: &Moment| !m.uncertain || self.evidence.decides();
        let limits = (due.unwrap_or(i64::MAX), closes.unwrap_or(i64::MAX));
        let choice = self.evidence.choice();
        let known =
            |m: &Moment| certain(m) && !(m.whole_day && policy.hour_matters(limits, m.micros[choice]));
        let came = zone.read(&row.submitted_at).filter(known);
        let at = came.map(|moment| moment.micros[choice]);
        let by = due.zip(at).filter(|(due, at)| at > due).map(|(due, at)| {
            let minutes = (at - due + policy::MINUTE - 1) / policy::MINUTE;
            format!("{} d {} h {} min", minutes / 1440, minutes / 60 % 24, minutes % 60)
        });
        let late = &policy.late;
        json!({
            "due": due.map(|due| zone.shown(due)),
            "extended": policy.extensions.iter().any(|(id, _)| id == student),
            "closes": closes.map(|closes| zone.shown(closes)),
            "came": at.map(|at| zone.shown(at)),
            "whole_day": came.is_some_and(|moment| moment.whole_day),
            "doubt": zone.doubt(&row.submitted_at).map(|doubt| doubt.to_string()),
            "unread": late.unread.map_or("in time", Unread::as_str),
            "by": by,
            "penalty": shown::per_cent(late.penalty, 3),
            "per": late.per.as_str(),
            "most": shown::per_cent(late.most, 3),
            "grace": late.grace / policy::MINUTE,
        })
    }

    /// What the relation comes to with the student's own answers.
    fn follow(&self, index: usize, row: &AnswerRow) -> Option<Value> {
        let entry = &self.key.parts[index];
        let asked = |question: usize| self.problem.questions.get(question);
        let is_here = |question: usize| asked(question).is_some_and(|q| q.id == entry.part);
        let written = self.problem.follows.iter().find(|f| is_here(f.question))?;
        let follow = self.key.follows.iter().find(|f| f.part == index)?;
        let number = |part: usize, row: &AnswerRow| {
            let (entry, mut units) = (self.key.parts.get(part)?, UnitCache::default());
            Some(compare::compare_with(&row.answer, entry, &mut units, Feedback::english()).number)
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
        let answer = number(index, row).unwrap_or(f64::NAN);
        let near = |y: f64| (y.abs() - answer.abs()).abs();
        let value = if near(by(true)) <= near(by(false)) { by(true) } else { by(false) };
        let from: Vec<&str> =
            follow.from.iter().filter_map(|p| self.key.parts.get(*p)).map(|e| e.part.as_str()).collect();
        let value = in_unit(entry, value);
        Some(json!({"text": written.text, "from": from.join(" and "), "value": value}))
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
    let why = match question.relative {
        Relative::Fixed(_) => "",
        Relative::Widens { .. } => ", by its condition number",
    };
    format!("{} % of the key{why}", shown::per_cent(share, 3))
}

/// A number in the unit that is asked, with it.
fn in_unit(entry: &KeyEntry, si: f64) -> String {
    entry.unit.text_with(&shown::significant(entry.unit.from_si(si), FIGURES))
}

fn signed_per_cent(share: f64) -> String {
    let share = share * 100.0;
    let sign = if share < 0.0 { "-" } else { "+" };
    format!("{sign}{} %", shown::significant(share.abs(), 3))
}
