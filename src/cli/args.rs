//! What was typed, nothing resolved; keeper of clap.
use crate::bank::Bank;
use crate::bank::built_in::BUILT_IN;
use crate::export::{ExportFormat, QuestionLayout};
use crate::finding::Findings;
use crate::folder::banks::{self, Loaded};
use crate::folder::grading::Reports;
use crate::manual::TOPICS;
use crate::policy::Counts;
use crate::sheet::output::Format;
use crate::sheet::self_check::Hosting;
use crate::sheet::texts::Texts;
use crate::solution::draft::Detail;
use crate::solve::method::Method;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory as _, Parser, Subcommand};
use std::path::PathBuf;

/// Homework in rigid-body dynamics: draws a problem set for each student, solves every variant twice, grades what comes
/// back.
#[derive(Debug, Parser)]
#[command(name = "slipstick", version, max_term_width = 100, disable_help_subcommand = true)]
pub struct Typed {
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

/// What the help of each verb ends with, and at last that of the program: a line `=== VERB`, then the text.
const ENDS: &str = include_str!("../../templates/manual/ends-of-help.txt");

/// The command line, with what each help ends with.
pub fn command() -> clap::Command {
    let topics = TOPICS.iter().map(|t| format!("  {:<10} {}\n", t.name, t.about)).collect::<String>();
    let ends = ENDS.split("=== ").filter_map(|section| section.split_once('\n'));
    ends.fold(Typed::command(), |command, (verb, text)| match (verb, text.trim_end()) {
        ("slipstick", text) => command.after_help(text.replace("{topics}", &topics)),
        (verb, text) => command.mut_subcommand(verb, |of_verb| of_verb.after_help(text.to_owned())),
    })
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub enum Verb {
    /// Make a problem set: one sheet for each student of a roster, and the key
    Generate(GenerateArgs),
    /// Grade submissions against a set
    Grade(GradeArgs),
    /// Print a course file with every setting that bears on marks, explained: `slipstick course > course.yaml`
    Course,
    /// Report on grades: the class for the instructor, feedback for each student, gradebooks for Canvas and Moodle
    Report(ReportArgs),
    /// Grade the same submissions again after a change of bank or course, and show who gains and who loses
    Regrade(RegradeArgs),
    /// Say how many verdicts of a grading would change with other tolerances; changes nothing
    WhatIf {
        /// Folder of a grading, as grade made it
        graded: PathBuf,
        /// Relative tolerances in per cent
        #[arg(long, value_name = "PERCENT,...", value_delimiter = ',', default_value = "0.5,1,2,5")]
        tolerance: Vec<String>,
    },
    /// Find wrong answers that are the right ones of a classmate, with the chance that luck makes them so; for instructors
    Matches {
        /// Folder of a grading, as grade made it
        graded: PathBuf,
    },
    /// Tell everything about the marks of one student for one problem, in words
    Explain {
        /// Folder of a grading, as grade made it
        graded: PathBuf,
        /// Id of the student, or the name
        student: String,
        /// Number or id of the problem; `1.omega` names the part too
        problem: String,
        /// Only this part
        #[arg(long, value_name = "ID")]
        part: Option<String>,
    },
    /// Check your own answers against your sheet file; the sheet holds no key, the problem is solved anew
    Check(CheckArgs),
    /// Practise: a problem is drawn and shown, you answer, you are told what is wrong
    Practice(PracticeArgs),
    /// Solve one problem with given data, by equations of motion and by work and energy, and say what really happens
    Solve(SolveArgs),
    /// Measure what each method gives away for its speed, on one problem with given data
    Accuracy(AccuracyArgs),
    /// Begin a bank of one's own: a commented bank of one of a dozen scenes
    New {
        /// Name of the scene; without it the scenes are listed
        scene: Option<String>,
    },
    /// Tell which quantities may be asked of a problem: name, what it is, sign, unit
    Quantities {
        #[arg(help = bank())]
        bank: String,
        /// Id of the problem; a bank of one problem needs none
        problem: Option<String>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Find everything that is wrong in a bank, then try it over many seeds
    Lint(LintArgs),
    /// Look through a bank: many variants of each problem side by side, with their answers, on one page
    Gallery(GalleryArgs),
    /// Draw and solve a set again and prove its key: solved in two ways, and an enclosure of every answer
    Verify {
        /// Folder of the set, as generate made it
        set: PathBuf,
    },
    /// Write worked solutions of a set: solved in two ways, step by step, with figures; not for students yet
    Solutions(SolutionsArgs),
    /// Write the questions of a set, or a pool drawn from a bank, as one file that Moodle, Canvas or a QTI player imports
    Export(ExportArgs),
    /// Write out the built-in templates and word lists, to change them
    Templates {
        /// Folder to make
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Language: en or de
        #[arg(long, value_name = "CODE", default_value = "en")]
        language: String,
    },
    /// Let a made-up class with declared habits hand in, and write down what each answer really is
    Simulate(SimulateArgs),
    /// Show the whole job on a made-up class of 24: set, submissions, grades
    Demo {
        /// Folder to make
        #[arg(default_value = "slipstick-demo")]
        dir: PathBuf,
        /// Show index.html of the grades in the browser
        #[arg(long)]
        open: bool,
    },
    /// Read the manual: `slipstick help TOPIC`, or what a verb does: `slipstick help VERB`
    Help {
        /// A topic (commands, bank, grading, platforms, formats, trust, accuracy, speed) or a verb
        #[arg(conflicts_with = "html")]
        topic: Option<String>,
        /// Write the whole manual to this file, as one page
        #[arg(long, value_name = "FILE")]
        html: Option<PathBuf>,
        /// Replace a file that is there already
        #[arg(long, requires = "html")]
        force: bool,
    },
}

/// In which words: language, and templates of one's own.
#[derive(Debug, Default, Args)]
pub struct OwnArgs {
    /// Folder with templates that replace built-in ones of the same name, such as statement/pulled-rolling.md
    #[arg(long, value_name = "DIR")]
    pub templates: Option<PathBuf>,
    /// Language: en or de [default: en, or that of the set]
    #[arg(long, value_name = "CODE")]
    pub language: Option<String>,
}

impl OwnArgs {
    /// The texts for a bank, in English unless another language is asked. Errors: all that is wrong with them.
    pub fn texts(&self, bank: &mut Bank) -> Result<Texts, Findings> {
        self.texts_or("en", bank)
    }
    /// The same where another language is the usual one. Errors: all that is wrong with them.
    pub fn texts_or(&self, usual: &str, bank: &mut Bank) -> Result<Texts, Findings> {
        banks::texts(self.templates.as_deref(), self.language.as_deref().unwrap_or(usual), bank)
    }
    /// A bank with its texts. Errors: all that is wrong with either.
    pub fn load(&self, bank: &str) -> Result<(Loaded, Texts), Findings> {
        let mut loaded = banks::load(bank)?;
        let texts = self.texts(&mut loaded.bank)?;
        Ok((loaded, texts))
    }
}

/// `generate`
#[derive(Debug, Args)]
pub struct GenerateArgs {
    #[arg(help = bank())]
    pub bank: String,
    /// CSV file with a column `student` and, if you like, `name`
    #[arg(long, value_name = "ROSTER.csv")]
    pub roster: PathBuf,
    /// Seed, a whole number from 0; required unless --add is given, which takes it from the set
    #[arg(long, value_name = "N", required_unless_present = "add", value_parser = seed, allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Folder to make
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Name of the set; another name gives other variants [default: the bank's id]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// Problems to ask, in this order [default: all of the bank]
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    pub problems: Option<Vec<String>>,
    /// Formats of the sheets: html, md, pdf, tex [default: html,md, and pdf where it is built in]
    #[arg(long, value_name = "FORMAT,FORMAT", value_parser = format, value_delimiter = ',')]
    pub format: Option<Vec<Format>>,
    /// Where the program lies by which a sheet checks itself: single (in each sheet, one file that can be mailed) or site
    /// (beside the sheets, for a web server) [default: single]
    #[arg(long, value_name = "WHERE", value_parser = hosting)]
    pub page: Option<Hosting>,
    /// Add late joiners to an existing set; nothing else changes
    #[arg(long, conflicts_with = "force")]
    pub add: bool,
    /// Replace an existing set (and nothing but what generate made)
    #[arg(long)]
    pub force: bool,
    /// Show index.html of the set in the browser
    #[arg(long)]
    pub open: bool,
    /// Threads [default: one for each core]; the output does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Templates of one's own.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// What a bank is given by.
fn bank() -> String {
    let ids: Vec<&str> = BUILT_IN.iter().map(|(id, ..)| *id).collect();
    format!("Bank: a YAML file, or the id of a built-in one: {}", ids.join(", "))
}

/// One of some words, each with what it stands for and what that is.
fn one_of<T: Copy + Send + Sync>(words: &'static [(&str, T, &str)]) -> impl TypedValueParser<Value = T> {
    let all = words.iter().map(|(word, _, about)| PossibleValue::new(*word).help(*about));
    PossibleValuesParser::new(all).try_map(|word| {
        let known = words.iter().find(|(name, ..)| *name == word);
        known.map(|(_, value, _)| *value).ok_or("this word is not known")
    })
}

/// A word as people type it, if it is known; else which are.
fn typed<T>(known: fn(&str) -> Option<T>, text: &str, words: &str) -> Result<T, String> {
    known(&text.trim().to_ascii_lowercase()).ok_or_else(|| words.to_owned())
}
fn format(text: &str) -> Result<Format, String> {
    typed(Format::of_word, text, "the formats are html, md, pdf and tex")
}
fn export_format(text: &str) -> Result<ExportFormat, String> {
    typed(ExportFormat::of_word, text, "the formats are moodle, canvas, qti21 and qti3")
}
fn hosting(text: &str) -> Result<Hosting, String> {
    typed(Hosting::of_word, text, "a page is single or site")
}

/// Which attempt at a part counts.
const ATTEMPTS: &[(&str, Counts, &str)] = &[
    ("last", Counts::Last, "The last"),
    ("best", Counts::Best, "The one with the most points"),
    ("first", Counts::First, "The first"),
];

/// Are reports made with the grades?
const REPORTS: &[(&str, Reports, &str)] = &[
    ("auto", Reports::Auto, "Up to 300,000 answers"),
    ("yes", Reports::Yes, "Always"),
    ("no", Reports::No, "Never"),
];

/// How to come from the start to the end; none is the cheapest way that meets the tolerance.
type WishedMethod = Option<Method>;

/// Names of the methods.
const METHODS: &[(&str, WishedMethod, &str)] = &[
    ("auto", None, "The cheapest that meets the tolerance for this scene"),
    ("closed", Some(Method::Closed), "Closed forms"),
    ("gauss", Some(Method::Gauss), "Gauss-Legendre on the work of the forces over displacement"),
    ("dopri5", Some(Method::Dopri5), "Dormand-Prince 5(4), adaptive"),
    ("dop853", Some(Method::Dop853), "Dormand-Prince 8(5,3), adaptive"),
    ("euler", Some(Method::Euler), "Semi-implicit Euler at a fixed step"),
    ("verlet", Some(Method::Verlet), "Velocity Verlet at a fixed step"),
    ("rk4", Some(Method::Rk4), "Classical Runge-Kutta at a fixed step"),
];

/// How a problem becomes questions of Moodle.
const LAYOUTS: &[(&str, QuestionLayout, &str)] = &[
    ("cloze", QuestionLayout::Whole, "One question with a field for each part"),
    ("numerical", QuestionLayout::PartsWithUnits, "A question for each part, whose number may have a unit"),
];

/// `grade`
#[derive(Debug, Args)]
pub struct GradeArgs {
    /// Folder of the set, as generate made it
    pub set: PathBuf,
    /// The answers: a CSV file, or that of a quiz in Moodle or Canvas; a folder or ZIP archive of the files that sheets saved
    /// (answers-ID.csv); `-` for standard input
    pub submissions: PathBuf,
    /// Folder to make
    #[arg(long, value_name = "GRADED")]
    pub out: PathBuf,
    /// Settings that bear on marks: due date, attempts, late penalty, credit, rounding, corrections (see `slipstick course`)
    #[arg(long, value_name = "FILE")]
    pub course: Option<PathBuf>,
    /// Language of the reasons: en or de [default: that of the set]
    #[arg(long, value_name = "CODE")]
    pub language: Option<String>,
    /// Which attempt counts where there are several [default: as the course or the bank says, else the last]
    #[arg(long, value_parser = one_of(ATTEMPTS))]
    pub attempts: Option<Counts>,
    /// Which column is which, such as student="Email Address"; may be repeated
    #[arg(long, value_name = "FIELD=HEADER")]
    pub columns: Vec<String>,
    /// Reports, feedback for each student, gradebooks for Canvas and Moodle, matches (also: slipstick report, slipstick matches)
    #[arg(long, value_parser = one_of(REPORTS), default_value = "auto")]
    pub reports: Reports,
    /// Replace an earlier grading
    #[arg(long)]
    pub force: bool,
    /// Show index.html of the reports in the browser
    #[arg(long)]
    pub open: bool,
}

/// `report`
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Folder of grades, as grade made it
    pub graded: PathBuf,
    /// Folder to make [default: into GRADED]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace an earlier report (and nothing but what report made)
    #[arg(long)]
    pub force: bool,
    /// Threads [default: one for each core]; the output does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// In which words the feedback is.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// `regrade`
#[derive(Debug, Args)]
pub struct RegradeArgs {
    /// Folder of the set, as generate made it
    pub set: PathBuf,
    /// Folder of the grading, as grade made it
    pub graded: PathBuf,
    /// The same answers as before: a CSV file, a folder or ZIP archive of the files that sheets saved, `-` for standard input
    pub submissions: PathBuf,
    /// Folder to make
    #[arg(long, value_name = "NEW", required_unless_present = "dry_run")]
    pub out: Option<PathBuf>,
    /// The changed bank [default: bank.yaml of the set]
    #[arg(long, value_name = "FILE")]
    pub bank: Option<PathBuf>,
    /// Settings that bear on marks, over those of the old grading: what the file does not name stays as it was graded
    #[arg(long, value_name = "FILE")]
    pub course: Option<PathBuf>,
    /// Which attempt counts [default: as in the old grading, unless --course says otherwise]
    #[arg(long, value_parser = one_of(ATTEMPTS))]
    pub attempts: Option<Counts>,
    /// Which column is which [default: as in the old grading]
    #[arg(long, value_name = "FIELD=HEADER")]
    pub columns: Vec<String>,
    /// Language of the reasons: en or de [default: that of the old grading]
    #[arg(long, value_name = "CODE")]
    pub language: Option<String>,
    /// Only show what would change
    #[arg(long)]
    pub dry_run: bool,
}

/// `check`
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// The file sheet.json next to your sheet
    pub sheet: PathBuf,
    /// Answers, such as 1.omega="30.3 rad/s"
    #[arg(required = true, value_name = "PART=ANSWER")]
    pub answers: Vec<String>,
    /// Show the right values, if the bank allows it
    #[arg(long)]
    pub reveal: bool,
    /// Which hint to a wrong answer is told: each leads on from the one before
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = at_least_one)]
    pub hint: usize,
}

/// What data are drawn by.
fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("a whole number from 0 to {} is expected", u64::MAX))
}

/// A whole number from 1.
fn at_least_one(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|n| *n > 0).ok_or_else(|| "a whole number from 1 is expected".to_owned())
}

/// `practice`
#[derive(Debug, Args)]
pub struct PracticeArgs {
    #[arg(help = bank())]
    pub bank: String,
    /// Seed, for the same problems again [default: from the clock]
    #[arg(long, value_name = "N", value_parser = seed, allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Only these problems
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    pub problems: Option<Vec<String>>,
    /// Write a page to practise with in a browser, offline, such as practice.html
    #[arg(long, value_name = "FILE")]
    pub page: Option<PathBuf>,
    /// How many variants of each problem are on the page
    #[arg(long, value_name = "N", default_value_t = 3, requires = "page")]
    pub variants: u32,
    /// Replace a page that is there already
    #[arg(long, requires = "page")]
    pub force: bool,
    /// Templates of one's own.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// A problem with given data.
#[derive(Debug, Args)]
pub struct ProblemArgs {
    #[arg(help = bank())]
    pub bank: String,
    /// Id of the problem; a bank of one problem needs none
    pub problem: Option<String>,
    /// A datum with its unit, such as m=40kg; may be repeated
    #[arg(long, value_name = "SYMBOL=VALUE")]
    pub set: Vec<String>,
    /// Without --set: draw with this seed; not needed where all data are constants
    #[arg(long, value_name = "N", conflicts_with = "set", value_parser = seed, allow_negative_numbers = true)]
    pub seed: Option<u64>,
}

/// `solve`
#[derive(Debug, Args)]
pub struct SolveArgs {
    /// The problem and its data.
    #[command(flatten)]
    pub of: ProblemArgs,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// How to come from the start to the end
    #[command(flatten)]
    pub by: ByArgs,
}

/// How to come from the start to the end.
#[derive(Debug, Args)]
pub struct ByArgs {
    /// Method: auto takes the cheapest that meets the tolerance; gauss sums the work, the others step in time
    #[arg(long, value_parser = one_of(METHODS), default_value = "auto")]
    pub method: WishedMethod,
    /// Relative error allowed in a step (dopri5, dop853) or in the result (auto, gauss) [default: rounding]
    #[arg(long, value_name = "RTOL")]
    pub rtol: Option<f64>,
    /// Time step of euler, verlet, rk4, such as 1/60s or 1ms [default: 1ms]
    #[arg(long, value_name = "TIME")]
    pub step: Option<String>,
}

/// `accuracy`
#[derive(Debug, Args)]
pub struct AccuracyArgs {
    /// The problem and its data.
    #[command(flatten)]
    pub of: ProblemArgs,
    /// Leave out the clock: the cost is the number of force evaluations, and the same command prints the same bytes
    #[arg(long)]
    pub no_time: bool,
    /// A file to write (.csv, .html or .svg), or a folder for all three; may be repeated
    #[arg(long, value_name = "FILE or DIR")]
    pub out: Vec<PathBuf>,
    /// Replace files that are there already
    #[arg(long)]
    pub force: bool,
}

/// `lint`
#[derive(Debug, Args)]
pub struct LintArgs {
    #[arg(help = bank())]
    pub bank: String,
    /// How many seeds to try
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub seeds: u64,
    /// Templates of one's own.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// `gallery`
#[derive(Debug, Args)]
pub struct GalleryArgs {
    #[arg(help = bank())]
    pub bank: String,
    /// File to write, such as gallery.html
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// How many variants of each problem to show
    #[arg(long, value_name = "N", default_value_t = 12)]
    pub variants: u32,
    /// How many seeds to try for the tables
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub seeds: u64,
    /// Only these problems
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    pub problems: Option<Vec<String>>,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
    /// Lint the bank and write the page again whenever the file of the bank is saved, until Ctrl-C
    #[arg(long)]
    pub watch: bool,
    /// In which words.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// How much worked solutions tell.
const DETAILS: &[(&str, Detail, &str)] = &[
    ("short", Detail::Short, "Two pages a problem, for students"),
    ("full", Detail::Full, "Every step with its numbers put in, for the instructor"),
];

/// `solutions`
#[derive(Debug, Args)]
pub struct SolutionsArgs {
    /// Folder of the set, as generate made it
    pub set: PathBuf,
    /// Folder to make, not within the students' folders
    #[arg(long, value_name = "DIR3")]
    pub out: PathBuf,
    /// How much they tell
    #[arg(long, value_parser = one_of(DETAILS), default_value = "short")]
    pub detail: Detail,
    /// Formats: html, md, pdf, tex [default: html,md, and pdf where it is built in]
    #[arg(long, value_name = "FORMAT,FORMAT", value_parser = format, value_delimiter = ',')]
    pub format: Option<Vec<Format>>,
    /// Replace solutions that were made before (and nothing else)
    #[arg(long)]
    pub force: bool,
    /// Threads [default: one for each core]; the output does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// In which words.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// `export`
#[derive(Debug, Args)]
pub struct ExportArgs {
    /// Folder of a set, as generate made it; with --variants a bank: a YAML file, or the id of a built-in one
    #[arg(value_name = "SET or BANK")]
    pub source: String,
    /// Format: moodle, canvas, qti21 or qti3
    #[arg(long, value_name = "FORMAT", value_parser = export_format)]
    pub format: ExportFormat,
    /// File to write, such as week-5.xml for Moodle and week-5.zip for the others; not within the students' folders
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Draw a pool of so many variants of each problem from a bank
    #[arg(long, value_name = "N", requires = "seed")]
    pub variants: Option<u32>,
    /// Seed of the pool, a whole number from 0
    #[arg(long, value_name = "N", requires = "variants")]
    pub seed: Option<u64>,
    /// Name of the pool's set; another name gives other variants [default: the bank's id]
    #[arg(long, value_name = "NAME", requires = "variants")]
    pub name: Option<String>,
    /// How a problem becomes questions of Moodle [default: cloze]
    #[arg(long = "as", value_parser = one_of(LAYOUTS), value_name = "LAYOUT")]
    pub layout: Option<QuestionLayout>,
    /// Give the worked solution as feedback after the answer
    #[arg(long)]
    pub with_solutions: bool,
    /// Only these problems
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    pub problems: Option<Vec<String>>,
    /// Replace a file that is there already, and the set of a pool
    #[arg(long)]
    pub force: bool,
    /// Threads [default: one for each core]; the output does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// In which words.
    #[command(flatten)]
    pub own: OwnArgs,
}

/// `simulate`
#[derive(Debug, Args)]
pub struct SimulateArgs {
    /// Folder of the set, as generate made it
    #[arg(required_unless_present = "example")]
    pub set: Option<PathBuf>,
    /// Habits of the class, a YAML file [default: those of --example]
    #[arg(long, value_name = "FILE")]
    pub like: Option<PathBuf>,
    /// File of submissions to write, CSV
    #[arg(long, value_name = "SUBMISSIONS", required_unless_present = "example")]
    pub out: Option<PathBuf>,
    /// File to write what each row really is, CSV
    #[arg(long, value_name = "FILE", required_unless_present = "example")]
    pub truth: Option<PathBuf>,
    /// Seed, a whole number from 0
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Language of words such as `up`: en or de [default: that of the set]
    #[arg(long, value_name = "CODE")]
    pub language: Option<String>,
    /// Replace files that are there already
    #[arg(long)]
    pub force: bool,
    /// Print a file of habits with every field explained, and do nothing else
    #[arg(long)]
    pub example: bool,
}
