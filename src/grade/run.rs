//! A file of submissions to a file of verdicts: every answer cell exactly once, in the order of the input.
//!
//! The input is walked over several times: first to find which attempt of each student and part counts (once more before that
//! where lateness or the number of an attempt bears on marks, so that times are understood; once more for each step of
//! follow-through where the best attempt counts), then to judge and write. What is held grows with students times parts, not
//! with rows. Batches of records are graded on several threads; the output does not depend on their number.
use crate::answer::submissions::Batch;
use crate::answer::submissions::Record;
use crate::answer::submissions::RecordFault;
use crate::answer::submissions::Scratch;
use crate::answer::submissions::Source;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::grade::choose;
use crate::grade::choose::Attempt;
use crate::grade::choose::ByRow;
use crate::grade::choose::Ordered;
use crate::grade::choose::Try;
use crate::grade::choose::Winner;
use crate::grade::choose::line_of;
use crate::grade::choose::place;
use crate::grade::credit::Why;
use crate::grade::credit::credit;
use crate::grade::diagnose::Diagnosis;
use crate::grade::diagnose::Slip;
use crate::grade::feedback::Feedback;
use crate::grade::judge::accepts;
use crate::grade::judge::judge_with;
use crate::grade::layout::Form;
use crate::grade::layout::Layout;
use crate::grade::layout::Row;
use crate::grade::layout::clean;
use crate::grade::layout::layout;
use crate::grade::layout::open_quote;
use crate::grade::layout::sort_of_row;
use crate::grade::layout::trimmed;
use crate::grade::lean::Lean;
use crate::grade::quick::Quick;
use crate::grade::rules::Rules;
use crate::grade::table::KeyTable;
use crate::grade::table::joined;
use crate::grade::tails::Kind;
use crate::grade::tails::Tails;
use crate::grade::threads::Halt;
use crate::grade::threads::sweep;
use crate::grade::verdict::Judgement;
use crate::grade::verdict::Verdict;
use crate::grade::write::push_float;
use crate::grade::write::push_number;
use crate::guard::push_text;
use crate::policy;
use crate::policy::Counts;
use crate::policy::Unread;
use crate::policy::time::Doubt;
use crate::policy::time::Evidence;
use crate::policy::time::Moment;
use std::borrow::Cow;
use std::fmt;
use std::io;
use std::io::Read;
use std::io::Write;

/// How to grade.
#[derive(Debug, Clone)]
pub struct Options<'w> {
    /// Role (`student`, `problem`, `part`, `answer`, `submitted_at`) and the header that stands for it.
    pub columns: Vec<(String, String)>,
    /// Threads, at least 1.
    pub threads: usize,
    /// What is said of an answer.
    pub feedback: Feedback<'w>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Options { columns: Vec::new(), threads: 1, feedback: Feedback::english().clone() }
    }
}

/// Why nothing was graded.
#[derive(Debug)]
pub enum GradeFault {
    /// Reading failed.
    Io(io::Error),
    /// Writing failed.
    Write(io::Error),
    /// The header does not do; all that is wrong with it.
    Header(Findings),
}

impl fmt::Display for GradeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GradeFault::Io(fault) | GradeFault::Write(fault) => write!(f, "{fault}"),
            GradeFault::Header(findings) => {
                for (i, finding) in findings.iter().enumerate() {
                    write!(f, "{}{finding}", if i > 0 { "\n" } else { "" })?;
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for GradeFault {}

impl From<io::Error> for GradeFault {
    fn from(fault: io::Error) -> Self {
        GradeFault::Io(fault)
    }
}

impl From<Halt> for GradeFault {
    fn from(halt: Halt) -> Self {
        match halt {
            Halt::Read(fault) => GradeFault::Io(fault),
            Halt::Write(fault) => GradeFault::Write(fault),
        }
    }
}

/// Counts by verdict, in the order of `Verdict::ALL`.
pub type VerdictCounts = [u64; Verdict::ALL.len()];

/// What came out.
#[derive(Debug, Clone)]
pub struct Graded {
    /// Lines written, one for each answer cell or unreadable record.
    pub cells: u64,
    /// By verdict.
    pub counts: VerdictCounts,
    /// By verdict for each column of the table.
    pub by_column: Vec<VerdictCounts>,
    /// Points of the attempt that counts, student after student; `None` where nothing was handed in and nothing is given.
    pub points: Vec<Option<f64>>,
    /// Long or wide form.
    pub wide: bool,
    /// Parts of a student whose attempts were ordered by row because a `submitted_at` cannot be read.
    pub untimed: u64,
    /// Lateness bears on marks, and so many of the answers that count have no time that can be read.
    pub undated: u64,
    /// Answers under an id that differs in upper and lower case alone from that of the roster.
    pub respelled: u64,
    /// Columns of the file that were not used.
    pub unused_columns: Vec<String>,
}

impl Graded {
    /// Count of one verdict.
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.counts[verdict as usize]
    }
}

/// What the walks before the writing one collect for each student and part.
enum Found {
    /// Nothing yet.
    Nothing,
    /// Where nothing but the order of rows matters; column after column.
    Rows(Vec<ByRow>),
    /// Where neither lateness nor the number of an attempt matters.
    Attempts(Vec<Attempt>),
    /// Where times are understood.
    Ordered(Vec<Ordered>),
}

/// What a worker keeps between rows.
struct Worker {
    scratch: Scratch,
    quick: Quick,
    tails: Tails,
    found: Found,
    evidence: Evidence,
    points: Vec<(u32, f64)>,
    cells: u64,
    undated: u64,
    respelled: u64,
    counts: VerdictCounts,
    by_column: Vec<VerdictCounts>,
}

impl Worker {
    fn new(table: &KeyTable, found: Found) -> Worker {
        Worker {
            scratch: Scratch::default(),
            quick: Quick::default(),
            tails: Tails::default(),
            found,
            evidence: Evidence::default(),
            points: Vec::new(),
            cells: 0,
            undated: 0,
            respelled: 0,
            counts: VerdictCounts::default(),
            by_column: vec![VerdictCounts::default(); table.columns.len()],
        }
    }
}

/// A cell with what is known of it.
struct Cell<'a> {
    line: u64,
    /// Index and header in a wide file.
    column: Option<(usize, &'a str)>,
    student: &'a [u8],
    problem: &'a [u8],
    part: &'a [u8],
    answer: &'a [u8],
    who: Option<u32>,
    /// The id differs in upper and lower case from that of the roster.
    respelled: bool,
    what: Option<u32>,
}

/// Calls `each` for every cell of a record.
#[inline]
fn cells<'a>(
    record: &Record<'a>,
    layout: &'a Layout,
    table: &KeyTable,
    quick: &mut Quick,
    mut each: impl FnMut(&mut Quick, &Cell<'a>),
) {
    let student = trimmed(record.get(layout.student).unwrap_or_default());
    let found = quick.student(table, student);
    let (who, respelled) = (found.map(|(who, _)| who), found.is_some_and(|(_, respelled)| respelled));
    let line = record.line();
    match &layout.form {
        Form::Long { problem, part, answer } => {
            let (problem, part) = (
                trimmed(record.get(*problem).unwrap_or_default()),
                trimmed(record.get(*part).unwrap_or_default()),
            );
            let what = quick.column(table, problem, part);
            let answer = record.get(*answer).unwrap_or_default();
            each(quick, &Cell { line, column: None, student, problem, part, answer, who, respelled, what });
        }
        Form::Wide(all) => {
            for (index, one) in all.iter().enumerate() {
                let cell = Cell {
                    line,
                    column: Some((index, &one.header)),
                    student,
                    problem: one.problem.as_bytes(),
                    part: one.part.as_bytes(),
                    answer: record.get(one.field).unwrap_or_default(),
                    who,
                    respelled,
                    what: one.column,
                };
                each(quick, &cell);
            }
        }
    }
}

/// Judges a cell whose student and column are known; the plain number's way needs no text.
#[inline]
fn judged<'w>(
    table: &KeyTable,
    who: u32,
    what: u32,
    answer: &[u8],
    quick: &mut Quick,
    say: &Feedback<'w>,
) -> Judgement<'w> {
    let hot = &table.hot[who as usize * table.columns.len() + what as usize];
    if let Some(x) = quick.si(table, hot, answer) {
        let (verdict, points, reason) = if accepts(x, hot.value, hot.half_width) {
            (Verdict::Right, hot.points, say.within)
        } else if accepts(-x, hot.value, hot.half_width) {
            (Verdict::WrongDirection, 0.0, if hot.magnitude { say.no_sign } else { say.other_sign })
        } else {
            (Verdict::Wrong, 0.0, say.outside)
        };
        return Judgement { verdict, points, reason: Cow::Borrowed(reason), number: x };
    }
    match table.entry(who as usize, what as usize) {
        Some(entry) => judge_with(&String::from_utf8_lossy(answer), entry, quick.units(), say),
        None => Judgement {
            verdict: Verdict::UnknownPart,
            points: 0.0,
            reason: Cow::Borrowed(say.get("feedback.no_such_part")),
            number: f64::NAN,
        },
    }
}

/// What does not change during a grading.
struct Job<'j> {
    table: &'j KeyTable,
    layout: &'j Layout,
    rules: &'j Rules<'j>,
    say: &'j Feedback<'j>,
    lean: &'j Lean,
}

/// The time of a record: what was read, and whether it is uncertain.
fn moment(record: &Record, job: &Job) -> Option<Moment> {
    let text = record.get(job.layout.submitted?).and_then(|t| std::str::from_utf8(t).ok())?;
    job.rules.policy.zone.read(text)
}

/// Class, number and share of the points of a cell: what the choice among attempts needs. Blank cells have none.
fn worth(
    job: &Job,
    (who, what): (u32, u32),
    answer: &[u8],
    quick: &mut Quick,
    winners: &[Winner],
) -> Option<(u8, f64, f64)> {
    let (table, rules) = (job.table, job.rules);
    let best = rules.policy.attempts.counts == Counts::Best;
    let hot = &table.hot[who as usize * table.columns.len() + what as usize];
    if !best && let Some(x) = quick.si(table, hot, answer) {
        return Some((choose::READABLE, x, 0.0));
    }
    let judgement = judged(table, who, what, answer, quick, job.say);
    let x = judgement.number;
    match judgement.verdict {
        Verdict::Blank | Verdict::UnknownPart => None,
        Verdict::Unreadable => Some((choose::UNREADABLE, x, 0.0)),
        Verdict::Right => Some((choose::READABLE, x, 1.0)),
        _ if best => {
            let share = credit(x, (who as usize, what as usize), table, rules, winners, None).share;
            Some((choose::READABLE, x, share))
        }
        _ => Some((choose::READABLE, x, 0.0)),
    }
}

/// Which attempts count, in the columns of one level or in all.
fn walk_attempts(worker: &mut Worker, batch: &Batch, job: &Job, level: Option<u8>, winners: &[Winner]) {
    let Worker { scratch, quick, found, evidence, .. } = worker;
    let Found::Attempts(attempts) = found else { return };
    let counts = job.rules.policy.attempts.counts;
    batch.records(scratch, |record| {
        if !matches!(sort_of_row(record, job.layout, job.say), Row::Cells) {
            return;
        }
        let time = moment(record, job);
        if let Some(moment) = time {
            evidence.join(moment.evidence);
        }
        let uncertain = time.and_then(|t| t.uncertain);
        cells(record, job.layout, job.table, quick, |quick, cell| {
            let (Some(who), Some(what)) = (cell.who, cell.what) else { return };
            if level.is_some_and(|level| job.rules.level(what as usize) != level) {
                return;
            }
            let found = worth(job, (who, what), cell.answer, quick, winners);
            let Some((class, number, share)) = found else { return };
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            let one = Attempt {
                class,
                several: false,
                untimed: [
                    job.layout.submitted.is_some() && time.is_none(),
                    uncertain == Some(false),
                    uncertain == Some(true),
                ],
                by_time: time.map_or([0; 2], |t| t.micros).map(|t| (t, at, number)),
                by_row: (at, number),
                best: (share, at, number),
            };
            attempts[who as usize * job.table.columns.len() + what as usize].join(&one, counts);
        });
    });
}

/// Which attempts count where only their order in the file matters.
fn walk_rows(worker: &mut Worker, batch: &Batch, job: &Job) {
    let Worker { scratch, quick, found, .. } = worker;
    let Found::Rows(rows) = found else { return };
    let counts = job.rules.policy.attempts.counts;
    batch.records(scratch, |record| {
        if !matches!(sort_of_row(record, job.layout, job.say), Row::Cells) {
            return;
        }
        cells(record, job.layout, job.table, quick, |quick, cell| {
            let (Some(who), Some(what)) = (cell.who, cell.what) else { return };
            let x = job.lean.column(what).and_then(|hot| quick.si(job.table, hot, cell.answer));
            let found = match x {
                Some(x) => Some((choose::READABLE, x, 0.0)),
                None => worth(job, (who, what), cell.answer, quick, &[]),
            };
            let Some((class, number, _)) = found else { return };
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            rows[job.lean.at(who, what)].join(&ByRow::new(class, at, number), counts);
        });
    });
}

/// What is known of the times after the first walk of a careful grading.
struct Times {
    evidence: Evidence,
    /// Students and parts whose attempts are ordered by row.
    untimed: Vec<bool>,
}

/// Which attempts count where lateness or their number bears on marks.
fn walk_ordered(
    worker: &mut Worker,
    batch: &Batch,
    job: &Job,
    level: Option<u8>,
    winners: &[Winner],
    times: &Times,
) {
    let Worker { scratch, quick, found, .. } = worker;
    let Found::Ordered(ordered) = found else { return };
    let attempts = &job.rules.policy.attempts;
    let depth = choose::depth(attempts);
    batch.records(scratch, |record| {
        if !matches!(sort_of_row(record, job.layout, job.say), Row::Cells) {
            return;
        }
        let certain = |m: &Moment| m.uncertain.is_none_or(|dotted| times.evidence.decides(dotted));
        let read = moment(record, job).filter(certain);
        let time = read.map(|m| m.micros[times.evidence.choice()]);
        let whole_day = read.is_some_and(|m| m.whole_day);
        cells(record, job.layout, job.table, quick, |quick, cell| {
            let (Some(who), Some(what)) = (cell.who, cell.what) else { return };
            if level.is_some_and(|level| job.rules.level(what as usize) != level) {
                return;
            }
            let found = worth(job, (who, what), cell.answer, quick, winners);
            let Some((mut class, number, share)) = found else { return };
            let index = who as usize * job.table.columns.len() + what as usize;
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            // A date alone is enough where every hour of the day costs the same.
            let known = time.filter(|time| !(whole_day && job.rules.hour_matters(who as usize, *time)));
            let late = match known {
                Some(time) => job.rules.late(who as usize, time),
                None => job.rules.undated(who as usize),
            };
            if late.is_none() && class == choose::READABLE {
                class = choose::CLOSED;
            }
            let key = (if times.untimed[index] { 0 } else { time.unwrap_or(0) }, at);
            let late = late.unwrap_or(0.0);
            let one = Try { key, number, share, late, undated: known.is_none(), whole_day };
            ordered[index].add(class, one, depth);
        });
    });
}

/// Finds which attempts count.
fn choose_winners(
    open: Open<'_>,
    job: &Job,
    threads: usize,
    heard: &mut (dyn FnMut(u64) + Send),
) -> Result<Vec<Winner>, GradeFault> {
    let (table, rules) = (job.table, job.rules);
    let attempts = rules.policy.attempts;
    let cells = table.students.len() * table.columns.len();
    let mut winners = vec![Winner::NONE; cells];
    let careful = rules.careful() && job.layout.submitted.is_some();
    let walk = |found: &dyn Fn() -> Found,
                process: &(dyn Fn(&mut Worker, &Batch, &mut Vec<u8>) + Sync),
                heard: &mut (dyn FnMut(u64) + Send)|
     -> Result<Vec<Worker>, GradeFault> {
        let (source, _) = Source::open(open()?)?;
        let workers = (0..threads).map(|_| Worker::new(table, found())).collect();
        Ok(sweep(source, workers, process, None, heard)?)
    };
    let gathered = |workers: Vec<Worker>| {
        let mut all: Vec<Attempt> = Vec::new();
        let mut evidence = Evidence::default();
        for worker in workers {
            evidence.join(worker.evidence);
            let Found::Attempts(attempts) = worker.found else { continue };
            if all.is_empty() {
                all = attempts;
                continue;
            }
            for (all, one) in all.iter_mut().zip(&attempts) {
                all.join(one, rules.policy.attempts.counts);
            }
        }
        (all, rules.policy.day_first.map_or(evidence, Evidence::said))
    };
    let no_attempts = || Found::Attempts(vec![Attempt::NONE; cells]);
    // What follows from another part is worth what it is only when the winner there is known.
    let levels: Vec<Option<u8>> = match rules.walks() {
        1 => vec![None],
        n => (0..n).map(Some).collect(),
    };
    if !careful && !attempts.ordered() && attempts.counts != Counts::Best && job.layout.submitted.is_none() {
        let process = |w: &mut Worker, b: &Batch, _: &mut Vec<u8>| walk_rows(w, b, job);
        let workers = walk(&|| Found::Rows(vec![ByRow::NONE; cells]), &process, heard)?;
        let mut all: Vec<ByRow> = Vec::new();
        for worker in workers {
            let Found::Rows(rows) = worker.found else { continue };
            if all.is_empty() {
                all = rows;
                continue;
            }
            for (all, one) in all.iter_mut().zip(&rows) {
                all.join(one, attempts.counts);
            }
        }
        // By column here, by student there.
        let students = table.students.len().max(1);
        for (from, one) in all.iter().enumerate().filter(|(_, one)| one.is_some()) {
            winners[from % students * table.columns.len() + from / students] = one.winner();
        }
        return Ok(winners);
    }
    if !careful && !attempts.ordered() {
        for level in levels {
            let process =
                |w: &mut Worker, b: &Batch, _: &mut Vec<u8>| walk_attempts(w, b, job, level, &winners);
            let (all, evidence) = gathered(walk(&no_attempts, &process, heard)?);
            for (winner, one) in winners.iter_mut().zip(&all).filter(|(_, one)| one.class > 0) {
                *winner = one.decide(attempts.counts, evidence);
            }
        }
        return Ok(winners);
    }
    let mut times = Times { evidence: Evidence::default(), untimed: vec![false; cells] };
    if careful {
        let process = |w: &mut Worker, b: &Batch, _: &mut Vec<u8>| walk_attempts(w, b, job, None, &winners);
        let (all, evidence) = gathered(walk(&no_attempts, &process, heard)?);
        times.evidence = evidence;
        for (untimed, one) in times.untimed.iter_mut().zip(&all) {
            *untimed = one.class > 0 && one.is_untimed(evidence);
        }
    }
    let depth = choose::depth(&attempts);
    for level in levels {
        let process = |w: &mut Worker, b: &Batch, _: &mut Vec<u8>| {
            walk_ordered(w, b, job, level, &winners, &times);
        };
        let workers = walk(&|| Found::Ordered(vec![Ordered::NONE; cells]), &process, heard)?;
        let mut all: Vec<Ordered> = Vec::new();
        for worker in workers {
            let Found::Ordered(ordered) = worker.found else { continue };
            if all.is_empty() {
                all = ordered;
                continue;
            }
            for (all, one) in all.iter_mut().zip(&ordered) {
                all.join(one, depth);
            }
        }
        let decided = all.iter().zip(&times.untimed).map(|(one, untimed)| one.decide(&attempts, *untimed));
        for ((winner, new), _) in winners.iter_mut().zip(decided).zip(&all).filter(|(_, one)| one.class > 0) {
            *winner = new;
        }
    }
    Ok(winners)
}

/// Lines whose times are shown where they cannot be read.
const SHOWN: usize = 3;

/// Refuses to guess: where lateness bears on marks and an answer that counts has no time that can be read, the course must say
/// what holds.
fn said_of_unread(open: Open<'_>, job: &Job, winners: &[Winner]) -> Result<(), GradeFault> {
    let (rules, layout) = (job.rules, job.layout);
    if !rules.policy.timed() || rules.policy.late.unread.is_some() {
        return Ok(());
    }
    let width = job.table.columns.len().max(1);
    let unread = winners.iter().enumerate().filter(|(index, w)| {
        w.at != Winner::NONE.at && (w.undated || layout.submitted.is_none()) && rules.matters(index / width)
    });
    let lines: Vec<u64> = unread.map(|(_, w)| line_of(w.at)).collect();
    if lines.is_empty() {
        return Ok(());
    }
    let says = "say in the course file what holds: `late: {unread: in time}` or `late: {unread: late}`";
    let Some(field) = layout.submitted else {
        let what = "no column `submitted_at`, and lateness bears on marks";
        let hint = format!("map one with --columns submitted_at=\"Its header\", or {says}");
        return Err(GradeFault::Header(Finding::new("header", what).at(1, 1).hint(hint).into()));
    };
    let mut first = lines.clone();
    first.sort_unstable();
    first.dedup();
    first.truncate(SHOWN);
    let (mut shown, mut uncertain) = (Vec::new(), None);
    let (mut source, _) = Source::open(open()?)?;
    let (mut batch, mut scratch) = (Batch::default(), Scratch::default());
    while shown.len() < first.len() && source.next_batch(&mut batch)? {
        batch.records(&mut scratch, |record| {
            if !first.contains(&record.line()) {
                return;
            }
            let text = String::from_utf8_lossy(record.get(field).unwrap_or_default()).trim().to_owned();
            if rules.policy.zone.read(&text).is_some_and(|m| m.uncertain.is_some()) {
                uncertain.get_or_insert(text.clone());
            }
            let doubt = rules.policy.zone.doubt(&text).map_or_else(String::new, |d| format!(", {d}"));
            let text: String = text.chars().take(40).collect();
            let text = if text.is_empty() { "nothing".to_owned() } else { format!("`{text}`") };
            shown.push(format!("line {}: {text}{doubt}", record.line()));
        });
    }
    let what = format!(
        "lateness bears on marks, and {} that count{} no time that can be read ({}{})",
        if lines.len() == 1 { "1 answer".to_owned() } else { format!("{} answers", lines.len()) },
        if lines.len() == 1 { "s has" } else { " have" },
        shown.join("; "),
        if lines.len() > shown.len() { "; ..." } else { "" }
    );
    let order = uncertain.map_or_else(String::new, |text| {
        format!("; of `{text}` it says which comes first: `dates: day first` or `dates: month first`")
    });
    let fault = Finding::new("submitted_at", what).hint(format!("mend the times, or {says}{order}"));
    Err(GradeFault::Header(fault.into()))
}

/// What a wrong answer fits, as words for machines: ids of wrong methods, and a slip.
struct Fits {
    methods: String,
    slip: String,
    found: Vec<u16>,
}

/// A slip as a word for machines, and as students are told.
fn slip_in_words<'w>(slip: Slip, table: &KeyTable, what: u32, say: &Feedback<'w>) -> (String, Cow<'w, str>) {
    match slip {
        Slip::PowerOfTen(n) => {
            (format!("power_of_ten:{n}"), say.fill("feedback.slip.power_of_ten", &[("n", &n.to_string())]))
        }
        Slip::Unit(from, to) => {
            (format!("unit:{from}"), say.fill("feedback.slip.unit", &[("from", from), ("to", to)]))
        }
        Slip::FewerFigures(n) => {
            (format!("figures:{n}"), say.fill("feedback.slip.figures", &[("n", &n.to_string())]))
        }
        Slip::Drift => ("drift".to_owned(), Cow::Borrowed(say.get("feedback.slip.drift"))),
        Slip::OtherPart(i) => {
            let other = table.columns.get(table.first_of(what as usize) + i).map_or("", |c| c.part.as_str());
            (format!("part:{other}"), say.fill("feedback.slip.other_part", &[("part", other)]))
        }
    }
}

/// Tells a slip in the reason; ids of methods have a column of their own.
fn diagnosed(
    table: &KeyTable,
    (who, what): (u32, u32),
    cell: &[u8],
    judgement: &mut Judgement,
    say: &Feedback,
) -> Fits {
    let methods = table.methods(what as usize);
    let Diagnosis { methods: found, slip } =
        table.diagnose(judgement.number, cell, who as usize, what as usize);
    let mut fits = Fits { methods: String::new(), slip: String::new(), found };
    let told = slip.map(|slip| slip_in_words(slip, table, what, say));
    if let Some((word, told)) = told {
        judgement.reason = Cow::Owned(format!("{}; {told}", judgement.reason));
        fits.slip = word;
    }
    for id in fits.found.iter().filter_map(|m| methods.get(usize::from(*m))) {
        if !fits.methods.is_empty() {
            fits.methods.push(' ');
        }
        fits.methods.push_str(id);
    }
    fits
}

/// A share as students read it: `50 %`.
fn percent(share: f64) -> String {
    format!("{} %", policy::plain(share * 100.0))
}

/// Points of a cell that counts, why they are not simply all or nothing (in words for machines), and the same in the reason.
fn awarded(
    job: &Job,
    (who, what): (u32, u32),
    judgement: &mut Judgement,
    fits: Option<&Fits>,
    (winner, submitted): (&Winner, &[u8]),
    winners: &[Winner],
) -> (f64, String) {
    let (table, say) = (job.table, job.say);
    let points = table.hot[who as usize * table.columns.len() + what as usize].points;
    let mut words = String::new();
    let mut told: Vec<Cow<str>> = Vec::new();
    let mut word = |text: &str| {
        if !words.is_empty() {
            words.push(' ');
        }
        words.push_str(text);
    };
    let mut share = match judgement.verdict {
        Verdict::Right => 1.0,
        Verdict::Wrong | Verdict::WrongDirection => {
            let at = (who as usize, what as usize);
            let earned =
                credit(judgement.number, at, table, job.rules, winners, fits.map(|f| f.found.as_slice()));
            let share = percent(earned.share);
            match earned.why {
                Why::Nothing => {}
                Why::Method => {
                    word("methods");
                    told.push(say.fill("feedback.credit.method", &[("share", &share)]));
                }
                Why::Follows(column) => {
                    let part = &table.columns[column].part;
                    word(&format!("follow:{part}"));
                    told.push(say.fill("feedback.credit.follows", &[("part", part), ("share", &share)]));
                }
            }
            earned.share
        }
        _ => 0.0,
    };
    if share > 0.0 && winner.attempt < 1.0 {
        word(&format!("attempt:{}", policy::plain(winner.attempt)));
        told.push(say.fill("feedback.credit.attempt", &[("share", &percent(winner.attempt))]));
    }
    if winner.closed {
        word("closed");
        told.push(Cow::Borrowed(say.get("feedback.credit.closed")));
    } else if share > 0.0 && winner.late < 1.0 {
        word(&format!("late:{}", policy::plain(winner.late)));
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
        word("correction");
        told.push(say.fill("feedback.credit.correction", &[("share", &percent(given)), ("why", why)]));
    }
    if !told.is_empty() {
        judgement.reason = Cow::Owned(format!("{}; {}", judgement.reason, told.join("; ")));
    }
    (if share >= 1.0 { points } else { policy::plain(points * share) }, words)
}

/// Writes the line of an attempt that does not count, where its number can be had the quick way; `None`: nothing is written.
/// Most lines of a large file are such.
#[inline]
fn superseded_line(
    job: &Job,
    places: &[u64],
    (quick, tails): (&mut Quick, &mut Tails),
    cell: &Cell,
    (who, what): (u32, u32),
    submitted: &[u8],
    out: &mut Vec<u8>,
) -> Option<()> {
    let Job { table, say, lean, .. } = *job;
    let at = lean.at(who, what);
    let winner = places[at];
    if cell.column.is_some() || cell.respelled || winner == u64::MAX || winner == place(cell.line, 0) {
        return None;
    }
    let hot = lean.column(what)?;
    let x = quick.si(table, hot, cell.answer)?;
    let (key, half_width) = lean.bounds(at);
    let (verdict, found) = if accepts(x, key, half_width) {
        (Verdict::Right, Diagnosis::default())
    } else {
        let found = table.diagnose(x, cell.answer, who as usize, what as usize);
        let other_way = accepts(-x, key, half_width);
        (if other_way { Verdict::WrongDirection } else { Verdict::Wrong }, found)
    };
    let column = what as usize;
    let kind = Kind { verdict, slip: found.slip, magnitude: hot.magnitude, points: hot.points };
    let at = match tails.find(column, &kind) {
        Some(at) => at,
        None => {
            let reason = match verdict {
                Verdict::Right => say.within,
                Verdict::Wrong => say.outside,
                _ if hot.magnitude => say.no_sign,
                _ => say.other_sign,
            };
            let slip = found.slip.map(|slip| slip_in_words(slip, table, what, say));
            let (word, told) = slip.unwrap_or_default();
            tails.add(column, kind, say, reason, (&word, &told))?
        }
    };
    let tail = tails.get(column, at)?;
    push_number(out, cell.line);
    out.extend_from_slice(b",,");
    lean.push_name(who, table, out);
    out.push(b',');
    out.extend_from_slice(&table.columns[column].fields);
    out.push(b',');
    push_text(out, cell.answer);
    out.extend_from_slice(&tail.before);
    push_number(out, line_of(winner));
    out.extend_from_slice(&tail.after);
    if !found.methods.is_empty() {
        push_ids(out, &found.methods, table.methods(column));
    }
    out.extend_from_slice(&tail.slip);
    push_text(out, submitted);
    out.push(b'\n');
    Some(())
}

/// Ids of wrong methods with blanks between.
fn push_ids(out: &mut Vec<u8>, found: &[u16], methods: &[String]) {
    for (i, id) in found.iter().filter_map(|m| methods.get(usize::from(*m))).enumerate() {
        if i > 0 {
            out.push(b' ');
        }
        out.extend_from_slice(id.as_bytes());
    }
}

/// Judges and writes.
fn walk_and_write(
    worker: &mut Worker,
    batch: &Batch,
    out: &mut Vec<u8>,
    job: &Job,
    (winners, places): (&[Winner], &[u64]),
) {
    let Job { table, layout, say, rules, .. } = *job;
    let Worker {
        scratch,
        quick,
        tails,
        points: earned,
        cells: written,
        undated,
        respelled,
        counts,
        by_column,
        ..
    } = worker;
    let needs_date = rules.policy.timed();
    let by_row_says = say.get("feedback.by_row");
    let mut reason = Vec::new();
    let whole = |out: &mut Vec<u8>, record: &Record, verdict: Verdict, reason: &str| {
        push_number(out, record.line());
        out.extend_from_slice(b",,");
        let before_answer = match &layout.form {
            Form::Long { answer, .. } => *answer,
            Form::Wide(_) => usize::MAX,
        };
        let bytes = record.fault() == Some(RecordFault::Bytes);
        let in_place = |i: usize| i < before_answer || (bytes && record.len() == layout.width);
        // what stands before the trouble can be shown in its column
        let field = |i: usize| {
            let text = trimmed(record.get(i).unwrap_or_default());
            let fits = record.fault().is_none() || (bytes && clean(text));
            if fits && in_place(i) { text } else { b"" }
        };
        let student = field(layout.student);
        push_text(out, student);
        out.push(b',');
        let mut points = None;
        if let Form::Long { problem, part, .. } = layout.form {
            let mut key = Vec::new();
            joined(field(problem), field(part), &mut key);
            match table.column(&key) {
                Some(what) => {
                    out.extend_from_slice(&table.columns[what as usize].fields);
                    points = table
                        .student(student)
                        .map(|who| table.hot[who as usize * table.columns.len() + what as usize].points);
                }
                None => {
                    push_text(out, field(problem));
                    out.push(b',');
                    push_text(out, field(part));
                }
            }
        } else {
            out.push(b',');
        }
        out.push(b',');
        push_text(out, record.shown(layout.delimiter).as_bytes());
        out.push(b',');
        out.extend_from_slice(verdict.as_str().as_bytes());
        out.extend_from_slice(b",0,");
        push_float(out, points.unwrap_or(0.0));
        out.push(b',');
        push_text(out, reason.as_bytes());
        out.extend_from_slice(b",,,,");
        if let Some(at) = layout.submitted {
            push_text(out, field(at));
        }
        out.push(b'\n');
    };
    batch.records(scratch, |record| {
        match sort_of_row(record, layout, say) {
            Row::Cells => {}
            Row::Empty => {
                *written += 1;
                counts[Verdict::Blank as usize] += 1;
                return whole(out, record, Verdict::Blank, say.get("feedback.empty_record"));
            }
            Row::Unreadable(reason) => {
                *written += 1;
                counts[Verdict::Unreadable as usize] += 1;
                return whole(out, record, Verdict::Unreadable, &reason);
            }
        }
        let submitted = layout.submitted.and_then(|i| record.get(i)).map_or(&b""[..], trimmed);
        cells(record, layout, table, quick, |quick, cell| {
            if let (Some(who), Some(what)) = (cell.who, cell.what)
                && superseded_line(job, places, (&mut *quick, &mut *tails), cell, (who, what), submitted, out)
                    .is_some()
            {
                *written += 1;
                counts[Verdict::Superseded as usize] += 1;
                by_column[what as usize][Verdict::Superseded as usize] += 1;
                return;
            }
            push_number(out, cell.line);
            out.push(b',');
            if let Some((_, header)) = cell.column {
                push_text(out, header.as_bytes());
            }
            out.push(b',');
            match cell.who {
                Some(who) => out.extend_from_slice(&table.students[who as usize].field),
                None => push_text(out, cell.student),
            }
            out.push(b',');
            match cell.what {
                Some(what) => out.extend_from_slice(&table.columns[what as usize].fields),
                None => {
                    push_text(out, cell.problem);
                    out.push(b',');
                    push_text(out, cell.part);
                }
            }
            out.push(b',');
            push_text(out, cell.answer);
            out.push(b',');
            *written += 1;
            let (Some(who), Some(what)) = (cell.who, cell.what) else {
                let text = |b: &[u8]| String::from_utf8_lossy(b).into_owned();
                let (verdict, reason) = if cell.who.is_none() {
                    (Verdict::UnknownStudent, table.unknown_student(&text(cell.student), say))
                } else {
                    (Verdict::UnknownPart, table.unknown_part(&text(cell.problem), &text(cell.part), say))
                };
                counts[verdict as usize] += 1;
                out.extend_from_slice(verdict.as_str().as_bytes());
                out.extend_from_slice(b",0,0,");
                push_text(out, reason.as_bytes());
                out.extend_from_slice(b",,,,");
                push_text(out, submitted);
                out.push(b'\n');
                return;
            };
            let index = who as usize * table.columns.len() + what as usize;
            let mut judgement = judged(table, who, what, cell.answer, quick, say);
            if judgement.verdict == Verdict::Unreadable
                && record.quote_left_open()
                && cell.answer.trim_ascii_start().starts_with(b"\"")
            {
                judgement.reason = open_quote(cell.line, say);
            }
            if cell.respelled {
                *respelled += 1;
                let written = String::from_utf8_lossy(cell.student);
                let pieces = [("written", &*written), ("student", &*table.students[who as usize].id)];
                let said = say.fill("feedback.respelled", &pieces);
                judgement.reason = Cow::Owned(format!("{}; {said}", judgement.reason));
            }
            let wrong = matches!(judgement.verdict, Verdict::Wrong | Verdict::WrongDirection);
            let fits = wrong.then(|| diagnosed(table, (who, what), cell.answer, &mut judgement, say));
            let winner = winners[index];
            let counts_not = !matches!(judgement.verdict, Verdict::Blank | Verdict::UnknownPart);
            let at = place(cell.line, cell.column.map_or(0, |(i, _)| i));
            let superseded = counts_not && winner.at != at;
            let verdict = if superseded { Verdict::Superseded } else { judgement.verdict };
            counts[verdict as usize] += 1;
            by_column[what as usize][verdict as usize] += 1;
            let mut credit = String::new();
            if counts_not && !superseded {
                (judgement.points, credit) =
                    awarded(job, (who, what), &mut judgement, fits.as_ref(), (&winner, submitted), winners);
                earned.push((index as u32, judgement.points));
                *undated += u64::from(needs_date && (winner.undated || layout.submitted.is_none()));
            }
            out.extend_from_slice(verdict.as_str().as_bytes());
            out.push(b',');
            push_float(out, if superseded { 0.0 } else { judgement.points });
            out.push(b',');
            push_float(out, table.hot[index].points);
            out.push(b',');
            let by_row = winner.by_row && counts_not;
            if superseded {
                let plain =
                    judgement.verdict != Verdict::Unreadable && matches!(judgement.reason, Cow::Borrowed(_));
                reason.clear();
                say.superseded(line_of(winner.at), judgement.verdict, push_number, &mut reason);
                if !plain {
                    reason.extend_from_slice(b": ");
                    reason.extend_from_slice(judgement.reason.as_bytes());
                    if by_row {
                        reason.extend_from_slice(b"; ");
                        reason.extend_from_slice(by_row_says.as_bytes());
                    }
                } else if by_row {
                    reason.extend_from_slice(b"; ");
                    reason.extend_from_slice(say.get("feedback.by_row_short").as_bytes());
                }
                push_text(out, &reason);
            } else if by_row {
                push_text(out, format!("{}; {by_row_says}", judgement.reason).as_bytes());
            } else {
                push_text(out, judgement.reason.as_bytes());
            }
            out.push(b',');
            if let Some(fits) = &fits {
                out.extend_from_slice(fits.methods.as_bytes());
                out.push(b',');
                out.extend_from_slice(fits.slip.as_bytes());
            } else {
                out.push(b',');
            }
            out.push(b',');
            out.extend_from_slice(credit.as_bytes());
            out.push(b',');
            push_text(out, submitted);
            out.push(b'\n');
        });
    });
}

/// Opens the input anew.
pub type Open<'a> = &'a dyn Fn() -> io::Result<Box<dyn Read + Send>>;

/// Header of answers.csv.
pub const ANSWERS_HEADER: &str = "line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at\n";

/// Grades a file of submissions. `open` is called for each walk and must give the same bytes; `out` receives answers.csv;
/// `progress` hears the bytes read so far and how often the file will be read.
///
/// # Errors
/// A header that does not do, or reading and writing that fail.
pub fn grade(
    open: Open<'_>,
    table: &KeyTable,
    rules: &Rules,
    options: &Options,
    out: &mut (dyn Write + Send),
    progress: &mut (dyn FnMut(u64) + Send),
) -> Result<Graded, GradeFault> {
    let threads = options.threads.max(1);
    let (_, header) = Source::open(open()?)?;
    let layout = layout(header, table, &options.columns).map_err(GradeFault::Header)?;
    let lean = Lean::of(table);
    let job = Job { table, layout: &layout, rules, say: &options.feedback, lean: &lean };
    // Walks one after the other: what each has read is added up.
    let (mut before, mut now) = (0, 0);
    let mut heard = |read: u64| {
        if read < now {
            before += now;
        }
        now = read;
        progress(before + now);
    };
    let mut winners = choose_winners(open, &job, threads, &mut heard)?;
    said_of_unread(open, &job, &winners)?;
    if layout.submitted.is_none() && rules.policy.timed() {
        // All are undated, and cost alike: which one counts does not change.
        let width = table.columns.len().max(1);
        for (index, winner) in winners.iter_mut().enumerate().filter(|(_, w)| w.at != Winner::NONE.at) {
            let left = rules.undated(index / width);
            (winner.late, winner.closed) = (left.unwrap_or(0.0), left.is_none());
        }
    }
    let places = lean.places(&winners);
    let (source, _) = Source::open(open()?)?;
    out.write_all(ANSWERS_HEADER.as_bytes()).map_err(GradeFault::Write)?;
    let workers = (0..threads).map(|_| Worker::new(table, Found::Nothing)).collect();
    let process =
        |w: &mut Worker, b: &Batch, out: &mut Vec<u8>| walk_and_write(w, b, out, &job, (&winners, &places));
    let workers = sweep(source, workers, &process, Some(&mut *out), &mut heard)?;
    out.flush().map_err(GradeFault::Write)?;
    let mut graded = Graded {
        cells: 0,
        counts: VerdictCounts::default(),
        by_column: vec![VerdictCounts::default(); table.columns.len()],
        points: vec![None; winners.len()],
        wide: matches!(layout.form, Form::Wide(_)),
        untimed: winners.iter().filter(|w| w.by_row).count() as u64,
        undated: 0,
        respelled: 0,
        unused_columns: layout.unused.clone(),
    };
    for worker in workers {
        graded.cells += worker.cells;
        graded.undated += worker.undated;
        graded.respelled += worker.respelled;
        let add = |to: &mut VerdictCounts, from: &VerdictCounts| {
            to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
        };
        add(&mut graded.counts, &worker.counts);
        for (to, from) in graded.by_column.iter_mut().zip(&worker.by_column) {
            add(to, from);
        }
        for (index, points) in worker.points {
            graded.points[index as usize] = Some(points);
        }
    }
    // What is given to all is given to those who handed in nothing, too.
    for (index, points) in graded.points.iter_mut().enumerate().filter(|(_, p)| p.is_none()) {
        if let Some((share, _)) = rules.correction(index % table.columns.len().max(1), false) {
            *points = Some(policy::plain(table.hot[index].points * share));
        }
    }
    Ok(graded)
}
