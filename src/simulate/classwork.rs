//! A whole made-up class: what each student hands in, who copies from whom, when, and the two files of it, submissions and truth.
use crate::csv_field::{push_field, push_line};
use crate::key::SheetKey;
use crate::policy::{MINUTE, Zone};
use crate::simulate::chance::Chance;
use crate::simulate::habits::Habits;
use crate::simulate::student::SimulatedAnswer;
use crate::simulate::truth::{HEADER, TrueKind, Truth};
use crate::simulate::written::{self, WrittenCell};
use crate::words::Words;

/// One student's work.
#[derive(Debug, Clone)]
pub struct Work {
    /// The student's key.
    pub key: SheetKey,
    /// What is handed in, in the student's own order; empty for one who is absent.
    pub handed: Vec<SimulatedAnswer>,
}

/// The files of a class.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Files {
    /// The submissions, a row for each answer.
    pub submissions: Vec<u8>,
    /// The truth, a row for each row of the submissions.
    pub truth: Vec<u8>,
    /// Rows.
    pub rows: usize,
    /// Students who handed in.
    pub students: usize,
}

/// Stream of lots for what the class does as a class.
const CLASS: u64 = 0;

/// Lets groups copy: the members of a group take over answers of its first one, for the same parts of their own sheets.
pub fn copy(habits: &Habits, seed: u64, works: &mut [Work]) {
    let Some(copying) = &habits.copying else { return };
    let mut chance = Chance::new(seed, CLASS);
    let mut present: Vec<usize> = (0..works.len()).filter(|w| !works[*w].handed.is_empty()).collect();
    for i in (1..present.len()).rev() {
        present.swap(i, chance.below(i + 1));
    }
    for group in present.chunks_exact(copying.size.max(2)).take(copying.groups) {
        let Some((source, copiers)) = group.split_first() else { continue };
        let last: Vec<SimulatedAnswer> = last_attempts(&works[*source].handed);
        let name = works[*source].key.student.clone();
        for copier in copiers {
            let work = &mut works[*copier];
            for from in &last {
                if matches!(from.cell, WrittenCell::Blank) || !chance.meets(copying.share) {
                    continue;
                }
                let disguise = chance.meets(copying.disguise);
                let Some(entry) =
                    work.key.problems.get(from.problem).and_then(|p| p.parts.get(from.part)).cloned()
                else {
                    continue;
                };
                let cell = from.cell.clone();
                let cell = if disguise { cell.with_digits(written::disguised) } else { cell };
                let verdict = cell.verdict(&entry);
                let truth = Truth {
                    kind: TrueKind::Copied,
                    method: from.truth.method.clone(),
                    figures: from.truth.figures,
                    from: name.clone(),
                    // Nothing but the number can be judged: one that fits the copier's own data is right.
                    right: verdict == "right",
                    verdict,
                };
                let place = work.handed.iter().position(|h| (h.problem, h.part) == (from.problem, from.part));
                let place = place.unwrap_or(work.handed.len());
                work.handed.retain(|h| (h.problem, h.part) != (from.problem, from.part));
                let place = place.min(work.handed.len());
                let (problem, part) = (from.problem, from.part);
                work.handed.insert(place, SimulatedAnswer { problem, part, attempt: 1, cell, truth });
            }
        }
    }
}

/// The last attempt at each part, in the order of the sheet.
fn last_attempts(handed: &[SimulatedAnswer]) -> Vec<SimulatedAnswer> {
    let mut last: Vec<SimulatedAnswer> = Vec::new();
    for one in handed {
        match last.iter_mut().find(|h| (h.problem, h.part) == (one.problem, one.part)) {
            Some(old) if old.attempt < one.attempt => *old = one.clone(),
            Some(_) => {}
            None => last.push(one.clone()),
        }
    }
    last.sort_by_key(|h| (h.problem, h.part));
    last
}

/// A row before it is written.
struct HandedRow<'w> {
    student: &'w str,
    handed: &'w SimulatedAnswer,
    part: &'w str,
    verdict: &'static str,
    minute: Option<i64>,
    comma: bool,
}

/// Writes the files. The rows stand student by student, or by the times where there are some.
pub fn write(habits: &Habits, words: &Words, seed: u64, works: &[Work]) -> Files {
    let mut rows: Vec<HandedRow> = Vec::new();
    for work in works {
        let student = work.key.student.as_str();
        // A stream of its own: what is handed in does not depend on when, nor on commas.
        let mut chance = Chance::of(seed ^ 0x5ca1_ab1e, student);
        let comma = chance.meets(habits.commas) || habits.spreadsheet;
        let count = i64::try_from(work.handed.len()).unwrap_or(i64::MAX);
        let last = habits.times.as_ref().map(|t| {
            let within = |from: i64, to: i64, share: f64| from + whole(share * float(to - from));
            if chance.meets(t.late) {
                within(t.due + 1, t.due + t.by + 1, chance.share())
            } else {
                // This is when the last answer comes: those before it came a minute apart.
                within((t.opens + count).min(t.due), t.due, chance.share())
            }
        });
        for (i, handed) in work.handed.iter().enumerate() {
            let entry = work.key.problems.get(handed.problem).and_then(|p| p.parts.get(handed.part));
            let minute = last.map(|l| l - (count - 1 - i64::try_from(i).unwrap_or(0)));
            let part = entry.map_or("", |e| e.part.as_str());
            let verdict = match entry {
                Some(entry) if comma => handed.cell.verdict_with_comma(entry, handed.truth.verdict),
                _ => handed.truth.verdict,
            };
            rows.push(HandedRow { student, handed, part, verdict, minute, comma });
        }
    }
    if habits.times.is_some() {
        rows.sort_by_key(|r| r.minute);
    }
    let shown = |minute: i64| Zone::default().shown(minute * MINUTE);
    let mut truth = Vec::new();
    push_line(&mut truth, HEADER);
    let separator = if habits.spreadsheet { b';' } else { b',' };
    let mut submissions = header(habits).as_bytes().to_vec();
    for (i, row) in rows.iter().enumerate() {
        // What varies without meaning anything varies by what is answered, not by where the row stands.
        let odd = row.handed.problem + row.handed.part + usize::try_from(row.handed.attempt).unwrap_or(0);
        let answer = text(&row.handed.cell, row.comma, odd, words);
        let time = row.minute.map(|m| match habits.times.as_ref().map_or("", |t| t.zone.as_str()) {
            "" => shown(m),
            zone => format!("{}:00{zone}", shown(m).replace(' ', "T")),
        });
        let problem = (row.handed.problem + 1).to_string();
        let mut fields = vec![row.student, problem.as_str(), row.part, answer.as_str()];
        if let Some(time) = &time {
            if habits.spreadsheet { fields.insert(0, time) } else { fields.push(time) }
        }
        if habits.spreadsheet {
            fields.push(if odd % 2 == 0 { "phone" } else { "" });
        }
        for (j, field) in fields.iter().enumerate() {
            if j > 0 {
                submissions.push(separator);
            }
            // Spreadsheets quote more than they must.
            let quoted = habits.spreadsheet && field.contains(' ') && odd % 3 == 0;
            push_field(&mut submissions, field.as_bytes(), separator, quoted);
        }
        submissions.extend_from_slice(if habits.spreadsheet { b"\r\n" } else { b"\n" });
        let t = &row.handed.truth;
        let figures = t.figures.map_or_else(String::new, |f| f.to_string());
        let (line, attempt, right) = (i + 2, row.handed.attempt, if t.right { "yes" } else { "no" });
        let [line, attempt] = [line.to_string(), attempt.to_string()];
        let what: [&str; 6] = [&problem, row.part, &attempt, &answer, t.kind.as_str(), &t.method];
        let fields = [line.as_str(), row.student].into_iter().chain(what);
        push_line(&mut truth, fields.chain([figures.as_str(), &t.from, right, row.verdict]));
    }
    Files {
        submissions,
        truth,
        rows: rows.len(),
        students: works.iter().filter(|w| !w.handed.is_empty()).count(),
    }
}

fn header(habits: &Habits) -> &'static str {
    match (habits.spreadsheet, habits.times.is_some()) {
        (false, false) => "student,problem,part,answer\n",
        (false, true) => "student,problem,part,answer,submitted_at\n",
        (true, false) => "\u{feff}STUDENT;Problem;Part ;Answer;Device\r\n",
        (true, true) => "\u{feff}Submitted_at;STUDENT;Problem;Part ;Answer;Device\r\n",
    }
}

/// What stands in the cell; `odd` tells whether a blank has blanks in it.
fn text(cell: &WrittenCell, comma: bool, odd: usize, words: &Words) -> String {
    match cell {
        WrittenCell::Blank => if odd.is_multiple_of(2) { "" } else { "  " }.to_owned(),
        WrittenCell::Garbage(text) => (*text).to_owned(),
        WrittenCell::Word(word) => words.get(&format!("sheet.{word}")).to_owned(),
        WrittenCell::Number { digits, unit, way } => {
            let digits = if comma { digits.replace('.', ",") } else { digits.clone() };
            let number = match unit {
                Some(unit) => unit.text_with(&digits),
                None => digits,
            };
            match way {
                Some(way) => format!("{number} {}", words.get(&format!("sheet.{way}"))),
                None => number,
            }
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "minutes of a term")]
const fn float(minutes: i64) -> f64 {
    minutes as f64
}

#[expect(clippy::cast_possible_truncation, reason = "minutes of a term")]
const fn whole(minutes: f64) -> i64 {
    minutes as i64
}
