//! A file of submissions to a file of verdicts: every answer cell exactly once, in the order of the input.
//!
//! The input is walked over several times: first to find which attempt of each student and part counts (`winners.rs`), then to
//! judge and write (`write.rs`). What is held grows with students times parts, and up to a limit with rows. Batches
//! of records are graded on several threads; the output does not depend on their number.
use crate::answer::submissions::{Batch, RecordScratch, RecordSource};
use crate::finding::{Finding, Findings, push_new};
use crate::grade::attempt::{Winner, line_of};
use crate::grade::cells::GradingJob;
use crate::grade::feedback::Feedback;
use crate::grade::header::layout;
use crate::grade::layout::FileForm;
use crate::grade::row;
use crate::grade::rules::Rules;
use crate::grade::table::KeyTable;
use crate::grade::threads::run_batches;
use crate::grade::verdict::Verdict;
use crate::grade::winners::choose_winners;
use crate::grade::write::{RowWriter, Writing};
use crate::key::FindWrong;
use crate::policy;
use std::io::{Read, Write};
use std::{fmt, io};

/// How to grade.
#[derive(Clone)]
pub struct Options<'w> {
    /// Role (`student`, `problem`, `part`, `answer`, `submitted_at`) and the header that stands for it.
    pub columns: Vec<(String, String)>,
    /// The file was made of the download of a quiz: it says line and variant of each answer.
    pub quiz: bool,
    /// Threads, at least 1.
    pub threads: usize,
    /// What is said of an answer.
    pub feedback: Feedback<'w>,
    /// Where wrong methods come to, if the table does not say it.
    pub wrong: Option<&'w dyn FindWrong>,
}

/// Columns of a file that was made of the download of a quiz beside the usual ones: the line of an answer, and
/// the code of the variant to which it was given.
pub const QUIZ_COLUMNS: [&str; 2] = ["line", "code"];

impl Default for Options<'_> {
    fn default() -> Self {
        Options {
            columns: Vec::new(),
            quiz: false,
            threads: 1,
            feedback: Feedback::english().clone(),
            wrong: None,
        }
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
            GradeFault::Header(findings) => f.write_str(findings.to_string().trim_end()),
        }
    }
}

impl std::error::Error for GradeFault {}

impl From<io::Error> for GradeFault {
    fn from(fault: io::Error) -> Self {
        GradeFault::Io(fault)
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
    /// Answers under an id that differs from that of the roster as [`crate::answer::roster::folded`] allows.
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

/// Opens the input anew.
pub type Open<'a> = &'a dyn Fn() -> io::Result<Box<dyn Read + Send>>;

/// Lines whose times are shown where they cannot be read.
const SHOWN: usize = 3;

/// Refuses to guess: where lateness bears on marks and an answer that counts has no time that can be read, the course must say
/// what holds.
fn need_unread_setting(open: Open<'_>, job: &GradingJob, winners: &[Winner]) -> Result<(), GradeFault> {
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
    let (mut source, _) = RecordSource::open(open()?)?;
    let (mut batch, mut scratch) = (Batch::default(), RecordScratch::default());
    while shown.len() < first.len() && source.next_batch(&mut batch)? {
        batch.records(&mut scratch, |record| {
            let line = job.layout.line(record);
            if !first.contains(&line) {
                return;
            }
            let text = String::from_utf8_lossy(record.get(field).unwrap_or_default()).trim().to_owned();
            if rules.policy.zone.read(&text).is_some_and(|m| m.uncertain) {
                uncertain.get_or_insert(text.clone());
            }
            let doubt = rules.policy.zone.doubt(&text).map_or_else(String::new, |d| format!(", {d}"));
            let text: String = text.chars().take(40).collect();
            let text = if text.is_empty() { "nothing".to_owned() } else { format!("`{text}`") };
            let told = format!("line {line}: {text}{doubt}");
            push_new(&mut shown, told);
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

/// Grades a file of submissions. `open` is called for each walk and must give the same bytes; `out` receives answers.csv;
/// `progress` hears the bytes read so far and how often the file will be read.
/// Errors: a header that does not do, or reading and writing that fail.
pub fn grade(
    open: Open<'_>,
    table: &KeyTable,
    rules: &Rules,
    options: &Options,
    out: &mut (dyn Write + Send),
    progress: &mut (dyn FnMut(u64) + Send),
) -> Result<Graded, GradeFault> {
    let threads = options.threads.max(1);
    let (_, header) = RecordSource::open(open()?)?;
    let layout = layout(header, table, options).map_err(GradeFault::Header)?;
    let job = GradingJob { table, layout: &layout, rules, say: &options.feedback, wrong: options.wrong };
    // The file is read several times, one after the other: the bytes of all are added up.
    let (mut before, mut now) = (0, 0);
    let mut heard = |read: u64| {
        if read < now {
            before += now;
        }
        now = read;
        progress(before + now);
    };
    let mut chosen = choose_winners(open, &job, threads, &mut heard)?;
    need_unread_setting(open, &job, &chosen.winners)?;
    if layout.submitted.is_none() && rules.policy.timed() {
        // All are undated, and cost alike: which one counts does not change.
        let width = table.columns.len().max(1);
        for (index, winner) in chosen.winners.iter_mut().enumerate().filter(|(_, w)| w.at != Winner::NONE.at)
        {
            let left = rules.undated(index / width);
            (winner.late, winner.closed) = (left.unwrap_or(0.0), left.is_none());
        }
    }
    let (source, _) = RecordSource::open(open()?)?;
    out.write_all((row::COLUMNS.join(",") + "\n").as_bytes()).map_err(GradeFault::Write)?;
    let writer = RowWriter::new(&job, &chosen);
    let workers = (0..threads).map(|_| Writing::new(table)).collect();
    let process = |w: &mut Writing, b: &Batch, out: &mut Vec<u8>| writer.batch(w, b, out);
    let workers = run_batches(source, workers, &process, Some(&mut *out), &mut heard)?;
    out.flush().map_err(GradeFault::Write)?;
    let mut graded = Graded {
        cells: 0,
        counts: VerdictCounts::default(),
        by_column: vec![VerdictCounts::default(); table.columns.len()],
        points: vec![None; chosen.winners.len()],
        wide: matches!(layout.form, FileForm::Wide(_)),
        untimed: chosen.winners.iter().filter(|w| w.by_row).count() as u64,
        undated: 0,
        respelled: 0,
        unused_columns: layout.unused.clone(),
    };
    for worker in workers {
        worker.counts().add_to(&mut graded);
    }
    // What is given to all is given to those who handed in nothing, too.
    for (index, points) in graded.points.iter_mut().enumerate().filter(|(_, p)| p.is_none()) {
        if let Some((share, _)) = rules.correction(index % table.columns.len().max(1), false) {
            *points = Some(policy::plain(table.points(index) * share));
        }
    }
    Ok(graded)
}
