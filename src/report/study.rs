//! What the marks of a class tell: numbers only, with the sizes below which they tell nothing.
use crate::finding::push_new;
use crate::grade::row::AnswerRow;
use crate::grade::verdict::Verdict;
use crate::report::marks::Marks;
use crate::report::stats::items::Matrix;
use crate::report::stats::spread::Distribution;
use crate::report::stats::{
    Interval, LEAST_FOR_CORRELATION, LEAST_FOR_MEDIAN, LEAST_IN_GROUP, NoStatistic, items, ranks, spread,
};
use std::collections::BTreeMap;

/// What is known of a part.
#[derive(Debug, Clone, PartialEq)]
pub struct PartStudy {
    /// Students whose sheet has it and who handed in anything at all.
    pub asked: usize,
    /// Of them, those with an answer to this part.
    pub answered: usize,
    /// Right answers among those that count.
    pub right: usize,
    /// The same as a share, with its interval; `None` for no answers.
    pub success: Option<Interval>,
    /// Mean share of the points of those asked, no answer counting 0; `None` if the part has no points or none was asked.
    pub ease: Option<f64>,
    /// Correlation with the rest.
    pub discrimination: Result<f64, NoStatistic>,
    /// Right at the first, second, third and a later attempt.
    pub first_right: [usize; 4],
    /// Median of the attempts up to the first right one.
    pub attempts: Option<f64>,
    /// Median of the seconds from the first attempt to the first right one, of those who needed several; with their number.
    pub seconds: Option<(f64, usize)>,
}

/// A wrong method, with the answers that it explains best.
#[derive(Debug, Clone, PartialEq)]
pub struct MistakeCount {
    /// Its id; several where one mistake has an id in each kind of problem.
    pub ids: Vec<String>,
    /// Methods that fit some of these answers as well, the most frequent first.
    pub also: Vec<String>,
    /// Answers that count and fit.
    pub answers: usize,
    /// Students (indices) with such an answer, ascending.
    pub who: Vec<usize>,
    /// Answers by part (index), ascending.
    pub parts: Vec<(usize, usize)>,
}

impl MistakeCount {
    /// Students with such an answer.
    pub fn students(&self) -> usize {
        self.who.len()
    }

    /// Takes another in that is the same mistake: nobody is counted twice.
    pub fn join(&mut self, other: &MistakeCount) {
        self.ids.extend(other.ids.iter().cloned());
        let more = other.also.iter().filter(|id| !self.also.contains(id)).cloned().collect::<Vec<_>>();
        self.also.extend(more);
        let ids = &self.ids;
        self.also.retain(|id| !ids.contains(id));
        self.answers += other.answers;
        self.who.extend(&other.who);
        self.who.sort_unstable();
        self.who.dedup();
        let mut parts: BTreeMap<usize, usize> = self.parts.iter().copied().collect();
        for (part, n) in &other.parts {
            *parts.entry(*part).or_default() += n;
        }
        self.parts = parts.into_iter().collect();
    }

    /// Most students first, then most answers.
    pub fn sort(list: &mut [MistakeCount]) {
        list.sort_by(|a, b| {
            (b.students(), b.answers).cmp(&(a.students(), a.answers)).then_with(|| a.ids.cmp(&b.ids))
        });
    }
}

/// How marks of a problem go with a datum, or differ between cases.
#[derive(Debug, Clone, PartialEq)]
pub struct DatumComparison {
    /// Index of the problem.
    pub problem: usize,
    /// Symbol of the datum; empty for the comparison of cases.
    pub datum: String,
    /// Students.
    pub n: usize,
    /// Correlation of ranks with its interval; `None` for cases.
    pub rho: Option<Interval>,
    /// Name of each case, its students, their mean share of the points.
    pub cases: Vec<(String, usize, f64)>,
    /// Probability by chance.
    pub p: f64,
    /// The same, corrected for all comparisons of the report.
    pub corrected: f64,
}

/// All that the report tells.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassStudy {
    /// Students (indices) who handed in something.
    pub took_part: Vec<usize>,
    pub totals: Vec<f64>,
    /// The most that anybody could get.
    pub most: f64,
    pub same_most: bool,
    /// Description of the totals.
    pub summary: Option<Distribution>,
    pub parts: Vec<PartStudy>,
    /// Reliability.
    pub alpha: Result<Interval, NoStatistic>,
    /// Parts that count in it, and in discrimination: those that all who took part were asked.
    pub scale: Vec<usize>,
    /// Wrong methods, most students first.
    pub mistakes: Vec<MistakeCount>,
    /// Wrong answers that count, and how many of them fit no known method nor slip.
    pub wrong: (usize, usize),
    /// Slips by their words (`power_of_ten`, `unit rev/min`, ...), with the number of answers.
    pub slips: Vec<(String, usize)>,
    /// Words of credit (`methods`, `follow`, `late`, ...), with the number of answers.
    pub credit: Vec<(String, usize)>,
    /// Comparisons of marks with what was drawn.
    pub fairness: Vec<DatumComparison>,
    /// Problems (indices) with too few students for comparisons, and how many they have.
    pub too_few: Vec<(usize, usize)>,
}

/// Below this a corrected probability stands out.
pub const LEVEL: f64 = 0.05;

impl ClassStudy {
    pub fn of(marks: &Marks) -> Self {
        let took_part: Vec<usize> = (0..marks.class.students.len()).filter(|s| marks.took_part(*s)).collect();
        let totals: Vec<f64> = took_part.iter().map(|s| marks.totals[*s].0).collect();
        let mosts: Vec<f64> = took_part.iter().map(|s| marks.totals[*s].1).collect();
        let most = mosts.iter().copied().fold(0.0, f64::max);
        let scale: Vec<usize> = (0..marks.class.parts.len())
            .filter(|p| marks.class.parts[*p].points > 0.0 && took_part.iter().all(|s| marks.asked(*s, *p)))
            .collect();
        let rows = took_part.iter().map(|s| scale.iter().map(|p| marks.points(*s, *p)).collect()).collect();
        let matrix = Matrix { rows, items: scale.len() };
        let parts =
            (0..marks.class.parts.len()).map(|p| part(marks, &took_part, p, &scale, &matrix)).collect();
        let (fairness, too_few) = fairness(marks);
        let (mistakes, wrong) = mistakes(marks);
        Self {
            summary: spread::summary(&totals),
            same_most: mosts.iter().all(|m| (m - most).abs() <= 1e-9 * most),
            most,
            totals,
            parts,
            alpha: matrix.alpha(),
            scale,
            mistakes,
            wrong,
            slips: words(marks, &|row| vec![slip_kind(&row.slip)]),
            credit: words(marks, &|row| row.credit.split_whitespace().map(before_colon).collect()),
            fairness,
            too_few,
            took_part,
        }
    }
}

/// `late` of `late:0.8`
fn before_colon(word: &str) -> String {
    word.split(':').next().unwrap_or_default().to_owned()
}

/// `unit rev/min` of `unit:rev/min`; of the others the first word.
fn slip_kind(slip: &str) -> String {
    match slip.split_once(':') {
        Some(("unit", unit)) => format!("unit {unit}"),
        _ => before_colon(slip),
    }
}

/// How often each word stands in the rows that count, most first.
fn words(marks: &Marks, of: &dyn Fn(&AnswerRow) -> Vec<String>) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for row in marks.cells.iter().filter_map(|c| c.row.as_ref()) {
        for word in of(row).into_iter().filter(|w| !w.is_empty()) {
            *counts.entry(word).or_default() += 1;
        }
    }
    most_first(counts)
}

/// Things with their numbers, the most frequent first, equal ones by name.
fn most_first(counts: BTreeMap<String, usize>) -> Vec<(String, usize)> {
    let mut list: Vec<_> = counts.into_iter().collect();
    list.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    list
}

fn part(marks: &Marks, took_part: &[usize], p: usize, scale: &[usize], matrix: &Matrix) -> PartStudy {
    let asked: Vec<usize> = took_part.iter().copied().filter(|s| marks.asked(*s, p)).collect();
    let cells: Vec<_> = asked.iter().map(|s| marks.cell(*s, p)).collect();
    let rows: Vec<_> = cells.iter().filter_map(|c| c.row.as_ref()).collect();
    let right = rows.iter().filter(|r| r.verdict == Verdict::Right).count();
    let points = marks.class.parts[p].points;
    let ease = (points > 0.0 && !asked.is_empty())
        .then(|| spread::mean(&asked.iter().map(|s| marks.points(*s, p) / points).collect::<Vec<_>>()));
    let mut first_right = [0; 4];
    for n in cells.iter().filter_map(|c| c.first_right) {
        first_right[(n as usize).clamp(1, 4) - 1] += 1;
    }
    let needed: Vec<f64> = cells.iter().filter_map(|c| c.first_right).map(f64::from).collect();
    let waited: Vec<f64> =
        cells.iter().filter(|c| c.first_right.is_some_and(|n| n > 1)).filter_map(|c| c.seconds).collect();
    let median =
        |values: &[f64]| spread::summary(values).filter(|s| s.n >= LEAST_FOR_MEDIAN).map(|s| s.median);
    PartStudy {
        asked: asked.len(),
        answered: rows.len(),
        right,
        success: items::wilson(right, rows.len()),
        ease,
        discrimination: match scale.iter().position(|other| *other == p) {
            Some(item) => matrix.discrimination(item),
            None => Err(NoStatistic::NotAll),
        },
        first_right,
        attempts: median(&needed),
        seconds: median(&waited).map(|m| (m, waited.len())),
    }
}

/// Each answer counts for the first, most likely method that fits it.
fn mistakes(marks: &Marks) -> (Vec<MistakeCount>, (usize, usize)) {
    #[derive(Default)]
    struct MistakeTally {
        also: BTreeMap<String, usize>,
        parts: BTreeMap<usize, usize>,
        who: Vec<usize>,
    }
    let mut counts: BTreeMap<String, MistakeTally> = BTreeMap::new();
    let (mut wrong, mut unexplained) = (0, 0);
    let width = marks.class.parts.len().max(1);
    for (i, row) in marks.cells.iter().enumerate().filter_map(|(i, c)| Some((i, c.row.as_ref()?))) {
        if !matches!(row.verdict, Verdict::Wrong | Verdict::WrongDirection) {
            continue;
        }
        wrong += 1;
        let mut methods = row.methods.split_whitespace();
        let Some(first) = methods.next() else {
            unexplained += usize::from(row.slip.is_empty() && row.verdict == Verdict::Wrong);
            continue;
        };
        let count = counts.entry(first.to_owned()).or_default();
        for other in methods.filter(|id| *id != first) {
            *count.also.entry(other.to_owned()).or_default() += 1;
        }
        *count.parts.entry(i % width).or_default() += 1;
        if count.who.last() != Some(&(i / width)) {
            count.who.push(i / width);
        }
    }
    let mut list: Vec<MistakeCount> = counts
        .into_iter()
        .map(|(id, count)| MistakeCount {
            ids: vec![id],
            also: most_first(count.also).into_iter().map(|(id, _)| id).collect(),
            answers: count.parts.values().sum(),
            who: count.who,
            parts: count.parts.into_iter().collect(),
        })
        .collect();
    MistakeCount::sort(&mut list);
    (list, (wrong, unexplained))
}

/// Share of the points of a problem, for the students who answered any part of it.
fn shares(marks: &Marks, problem: usize) -> Vec<(usize, f64)> {
    let parts: Vec<usize> =
        (0..marks.class.parts.len()).filter(|p| marks.class.parts[*p].number == problem + 1).collect();
    (0..marks.class.students.len())
        .filter(|s| parts.iter().any(|p| marks.cell(*s, *p).attempts > 0))
        .filter_map(|s| {
            let of: f64 =
                parts.iter().filter(|p| marks.asked(s, **p)).map(|p| marks.class.parts[*p].points).sum();
            let points: f64 = parts.iter().map(|p| marks.points(s, *p)).sum();
            (of > 0.0).then_some((s, points / of))
        })
        .collect()
}

fn fairness(marks: &Marks) -> (Vec<DatumComparison>, Vec<(usize, usize)>) {
    let mut found = Vec::new();
    let mut too_few = Vec::new();
    for problem in 0..marks.class.problems.len() {
        let shares = shares(marks, problem);
        if shares.len() < LEAST_FOR_CORRELATION {
            too_few.push((problem, shares.len()));
            continue;
        }
        let drawn = |s: usize| marks.class.students[s].problems.get(problem);
        let mut cases: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
        let mut symbols: Vec<&str> = Vec::new();
        for (s, share) in &shares {
            let Some(drawn) = drawn(*s) else { continue };
            cases.entry(&drawn.case).or_default().push(*share);
            for symbol in drawn.data.keys().filter(|symbol| drawn.number(symbol).is_some()) {
                push_new(&mut symbols, symbol);
            }
        }
        cases.retain(|_, group| group.len() >= LEAST_IN_GROUP);
        let groups: Vec<Vec<f64>> = cases.values().cloned().collect();
        if let Some((_, p)) = ranks::kruskal_wallis(&groups) {
            found.push(DatumComparison {
                problem,
                datum: String::new(),
                n: groups.iter().map(Vec::len).sum(),
                rho: None,
                cases: cases.iter().map(|(name, g)| ((*name).to_owned(), g.len(), spread::mean(g))).collect(),
                p,
                corrected: 1.0,
            });
        }
        for symbol in symbols {
            let pairs = shares.iter().filter_map(|(s, share)| Some((drawn(*s)?.number(symbol)?, *share)));
            let (xs, ys): (Vec<f64>, Vec<f64>) = pairs.unzip();
            if xs.len() < LEAST_FOR_CORRELATION {
                continue;
            }
            if let Some(spearman) = ranks::spearman(&xs, &ys) {
                found.push(DatumComparison {
                    problem,
                    datum: symbol.to_owned(),
                    n: xs.len(),
                    rho: Some(spearman.rho),
                    cases: Vec::new(),
                    p: spearman.p,
                    corrected: 1.0,
                });
            }
        }
    }
    let ps: Vec<f64> = found.iter().map(|c| c.p).collect();
    for (comparison, corrected) in found.iter_mut().zip(ranks::holm(&ps)) {
        comparison.corrected = corrected;
    }
    (found, too_few)
}
