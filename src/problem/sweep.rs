//! What a problem does over many seeds: how many draws are accepted, which rules refuse, in what range the answers lie,
//! how well they are conditioned, and how likely two students get the same sheet.
use crate::bank::Problem;
use crate::draw::stream::Source;
use crate::problem::make_key::{self, List};
use crate::problem::maker::{Maker, Refusals, Unsatisfiable};
use crate::problem::rounding;
use crate::problem::variant::Variant;
use crate::solve::outcome::Refusal;

/// A sweep over one problem.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Id of the problem.
    pub problem: String,
    /// One for each case.
    pub cases: Vec<CaseSweep>,
    /// One for each question.
    pub questions: Vec<QuestionSweep>,
    /// One for each wrong method.
    pub mistakes: Vec<MistakeSweep>,
    /// Chance that two students have equal data.
    pub pair_chance: f64,
    /// The first seed for which no draw held the rules, with the table.
    pub unsatisfiable: Option<(u64, Unsatisfiable)>,
    /// A draw of admissible data that could not be solved, or on which the two roads disagreed.
    pub unsolved: Option<Refusal>,
}

/// A sweep over one case.
#[derive(Debug, Clone)]
pub struct CaseSweep {
    /// Name, empty if there is only one.
    pub name: String,
    /// Share that the bank gives it, of all cases.
    pub share: f64,
    /// Variants that were made.
    pub variants: u64,
    /// Draws that were tried for them.
    pub tries: u64,
    /// Rules and how often each refused, most first.
    pub refusals: Vec<(String, u32)>,
    /// Grid points of the case.
    pub grid: f64,
    /// Estimated number of valid variants: grid points times acceptance.
    pub valid: f64,
    /// The data of the first variant.
    pub sample: Option<Vec<f64>>,
}

impl CaseSweep {
    /// Accepted draws of all draws; NaN if none was tried.
    pub fn acceptance(&self) -> f64 {
        count(self.variants) / count(self.tries)
    }
}

/// Range of the answers to one question.
#[derive(Debug, Clone)]
pub struct QuestionSweep {
    /// Id of the question.
    pub id: String,
    /// Least and greatest answer in the asked unit; `None` for words.
    pub range: Option<(f64, f64)>,
    /// Condition numbers of the draws that hold all rules but those about them; `None` for words.
    pub cond: Option<Spread>,
    /// Honest answers with the asked figures on the way that were tried on the variants, and how many of them miss the
    /// tolerance.
    pub honest: (u32, u32),
    /// Least and greatest relative tolerance.
    pub within: (f64, f64),
    /// The words of the lists that were printed, and how often each was right.
    pub words: Vec<Listed>,
}

/// Each word of a list that sheets print is to be right in at least this share of the variants that print the list: else it is
/// no question.
pub const WORD_SHARE: f64 = 0.2;

/// Variants with a list from which on a word that was never right counts as one that never is: of those that are right as often
/// as they should be, one in 70,000 hides so long.
const ENOUGH: u64 = 50;

/// A word of a list that sheets print.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Listed {
    /// The word.
    pub word: &'static str,
    /// The list: a word may stand on several.
    pub list: List,
    /// Variants that print this list in which it was right.
    pub right: u64,
}

/// How a word of a printed list fares that is right too seldom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seldom {
    /// The word.
    pub word: &'static str,
    /// Variants in which it was right.
    pub right: u64,
    /// Variants that print its list.
    pub printed: u64,
}

impl Seldom {
    /// Is it never right, as far as can be seen?
    pub fn never(&self) -> bool {
        self.right == 0
    }
}

/// Words that are right too seldom, by more than chance explains; `words` are all words of the lists that were printed, with
/// how often each was right.
pub fn seldom(words: &[Listed]) -> Vec<Seldom> {
    let of = |w: &Listed| Seldom { word: w.word, right: w.right, printed: printed(words, w.list) };
    let all = words.iter().map(of);
    let short = |s: &Seldom| {
        let spread = (WORD_SHARE * (1.0 - WORD_SHARE) / count(s.printed)).sqrt();
        s.printed >= ENOUGH && count(s.right) / count(s.printed) < WORD_SHARE - 2.0 * spread
    };
    all.filter(short).collect()
}

/// Variants that print this list: one of its words is right in each.
pub fn printed(words: &[Listed], list: List) -> u64 {
    words.iter().filter(|w| w.list == list).map(|w| w.right).sum()
}

/// The words of the lists that variants of a problem print, and how often each is right: for each question that is answered in
/// words, over so many variants, without the tables of a [`sweep`].
pub fn words_of(problem: &Problem, variants: u32, set: &str) -> Vec<(usize, Vec<Listed>)> {
    let asked = problem.questions.iter().enumerate().filter(|(_, q)| q.label.quantity.is_word());
    let mut found: Vec<(usize, Vec<Listed>)> = asked.map(|(i, _)| (i, Vec::new())).collect();
    if found.is_empty() {
        return found;
    }
    let maker = Maker::new(problem, 1, set);
    for student in 0..variants {
        let Ok(variant) = maker.variant(&format!("words {student}")) else { break };
        for (question, words) in &mut found {
            count_word(problem, &variant, *question, words);
        }
    }
    found
}

fn count_word(problem: &Problem, variant: &Variant, question: usize, words: &mut Vec<Listed>) {
    let label = problem.questions[question].label;
    let list = make_key::offered(problem, label.quantity, &problem.cases[variant.case].scene);
    if words.iter().all(|w| w.list != list) {
        words.extend(list.iter().map(|word| Listed { word, list, right: 0 }));
    }
    if let Some(right) = variant.solved.word(label)
        && let Some(listed) = words.iter_mut().find(|w| w.list == list && w.word == right.as_str())
    {
        listed.right += 1;
    }
}

/// How often a wrong method lands near a right answer.
#[derive(Debug, Clone, PartialEq)]
pub struct MistakeSweep {
    /// Id of the method.
    pub id: String,
    /// For each case the share of draws that it would refuse, of those that hold all other rules; NaN if none was tried.
    pub near: Vec<f64>,
    /// The same for each question, all cases together.
    pub by_question: Vec<f64>,
}

/// How condition numbers are spread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Half of them are not above this.
    pub median: f64,
    /// Nine of ten are not above this.
    pub ninth: f64,
    /// The greatest.
    pub worst: f64,
    /// Share of those above the limit of the question, whose draws are refused.
    pub above: f64,
}

impl Spread {
    fn of(mut conds: Vec<f64>, limit: f64) -> Option<Self> {
        conds.sort_by(f64::total_cmp);
        let last = conds.len().checked_sub(1)?;
        let above = conds.iter().filter(|c| !c.le(&&limit)).count();
        Some(Self {
            median: conds[last / 2],
            ninth: conds[last * 9 / 10],
            worst: conds[last],
            above: count(above as u64) / count(conds.len() as u64),
        })
    }
}

impl QuestionSweep {
    /// Share of the honest answers that miss the tolerance; NaN if none was tried.
    pub fn missed(&self) -> f64 {
        f64::from(self.honest.1) / f64::from(self.honest.0)
    }
}

impl Sweep {
    /// Was any variant made?
    pub fn has_variants(&self) -> bool {
        self.cases.iter().any(|case| case.variants > 0)
    }
    /// Before any variant is made.
    fn empty(problem: &Problem) -> Sweep {
        let total: u32 = problem.cases.iter().map(|c| c.share).sum();
        Sweep {
            problem: problem.id.clone(),
            cases: problem
                .cases
                .iter()
                .map(|c| CaseSweep {
                    name: c.name.clone(),
                    share: f64::from(c.share) / f64::from(total.max(1)),
                    variants: 0,
                    tries: 0,
                    refusals: Vec::new(),
                    grid: c.draws.iter().flatten().map(|d| count(d.count())).product(),
                    valid: 0.0,
                    sample: None,
                })
                .collect(),
            questions: problem
                .questions
                .iter()
                .map(|q| QuestionSweep {
                    id: q.id.clone(),
                    range: None,
                    cond: None,
                    honest: (0, 0),
                    within: (f64::INFINITY, 0.0),
                    words: Vec::new(),
                })
                .collect(),
            mistakes: Vec::new(),
            pair_chance: 0.0,
            unsatisfiable: None,
            unsolved: None,
        }
    }

    /// What follows from all draws together, case by case: condition numbers, wrong methods, refusals.
    fn conclude(&mut self, problem: &Problem, refusals: &[Refusals]) {
        for (i, (question, seen)) in problem.questions.iter().zip(&mut self.questions).enumerate() {
            let conds = refusals.iter().flat_map(|r| r.conds.iter().skip(i).step_by(problem.questions.len()));
            if !question.label.quantity.is_word() {
                seen.cond = Spread::of(conds.copied().collect(), question.cond_limit);
            }
        }
        let width = problem.questions.len() + 1;
        let share = |all: &[Refusals], column: usize| {
            let near: u32 = all.iter().map(|r| r.near.get(column).copied().unwrap_or(0)).sum();
            let told: u32 = all.iter().map(|r| r.told).sum();
            f64::from(near) / f64::from(told)
        };
        for (i, mistake) in problem.mistakes.iter().enumerate() {
            let last = (i + 1) * width - 1;
            self.mistakes.push(MistakeSweep {
                id: mistake.id.clone(),
                near: refusals.iter().map(|r| share(std::slice::from_ref(r), last)).collect(),
                by_question: (i * width..last).map(|column| share(refusals, column)).collect(),
            });
        }
        for (i, (case, refused)) in self.cases.iter_mut().zip(refusals).enumerate() {
            case.refusals = refused.table(problem, i);
            self.unsolved = self.unsolved.take().or_else(|| refused.unsolved.clone());
            // A case that the seeds did not reach counts as accepted nowhere.
            case.valid = if case.tries > 0 { (case.grid * case.acceptance()).max(1.0) } else { 1.0 };
            self.pair_chance += case.share * case.share / case.valid;
        }
    }
}

/// Honest answers that are tried for each variant.
const HONEST: u32 = 2;

/// Makes a variant for each of `seeds` seeds, from `first` on; `made` hears of each.
pub fn sweep(problem: &Problem, first: u64, seeds: u32, set: &str, made: &dyn Fn()) -> Sweep {
    let mut refusals: Vec<Refusals> = vec![Refusals::default(); problem.cases.len()];
    let mut out = Sweep::empty(problem);
    let mut words = Source::new(first, set, "honest rounding").student(&problem.id);
    let mut attempt = 0;
    let mut maker = Maker::new(problem, first, set).watching();
    for seed in (first..).take(seeds as usize) {
        maker = maker.with_seed(seed, set);
        let variant = match maker.variant("lint") {
            Ok(variant) => variant,
            Err(none) => {
                // One such table is enough, and each costs thousands of tries.
                out.unsatisfiable = Some((seed, *none));
                break;
            }
        };
        made();
        let case = &mut out.cases[variant.case];
        case.variants += 1;
        case.sample.get_or_insert_with(|| variant.data.clone());
        case.tries += u64::from(variant.tries);
        refusals[variant.case].join(&variant.refusals);
        for _ in 0..HONEST {
            attempt += 1;
            let tried = rounding::misses(problem, &variant, &mut words, attempt);
            for (missed, seen) in tried.into_iter().zip(&mut out.questions) {
                if let Some(missed) = missed {
                    seen.honest = (seen.honest.0 + 1, seen.honest.1 + u32::from(missed));
                }
            }
        }
        for (i, ((question, seen), within)) in
            problem.questions.iter().zip(&mut out.questions).zip(&variant.within).enumerate()
        {
            if question.label.quantity.is_word() {
                count_word(problem, &variant, i, &mut seen.words);
            } else if let Some(entry) = variant.solved.get(question.label) {
                let value = question
                    .unit
                    .from_si(problem.cases[variant.case].scene.as_asked(entry.label, entry.value()));
                let (low, high) = seen.range.unwrap_or((value, value));
                seen.range = Some((low.min(value), high.max(value)));
                seen.within = (seen.within.0.min(*within), seen.within.1.max(*within));
            }
        }
    }
    out.conclude(problem, &refusals);
    out
}

/// Chance that among so many students two have equal sheets, if the sheet holds all these problems: at most the number
/// of pairs times the chance of a pair.
pub fn coincidence(sweeps: &[Sweep], students: u32) -> f64 {
    let pairs = f64::from(students) * (f64::from(students) - 1.0) / 2.0;
    let pair: f64 = sweeps.iter().map(|s| s.pair_chance.min(1.0)).product();
    (pairs * pair).min(1.0)
}

#[expect(clippy::cast_precision_loss, reason = "an estimate")]
fn count(n: u64) -> f64 {
    n as f64
}
