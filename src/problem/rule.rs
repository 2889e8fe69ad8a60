//! The rules of a draw, how often each refused and what came out instead, in words.
use crate::bank::{Bound, Problem, measure, need};
use crate::num::shown;
use crate::scene::admissible::Inadmissible;
use crate::scene::{End, Num, Scene, Tie, admissible};
use crate::solve::outcome::{CheckKind, Refusal, Regime};
use crate::units::Unit;
use std::collections::BTreeMap;

/// A rule of a draw, by what it is about: questions, bounds and wrong methods by index, a regime by what came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum DrawRule {
    /// The data are a scene.
    Admissible,
    /// The scene can be solved.
    Solvable,
    /// The start agrees with the ties and leaves no velocity open.
    Start,
    /// The two roads agree.
    Agree,
    /// Only this happens with these data: no other contacts could roll or slip instead.
    Alone,
    /// Rounding of the printed data leaves no doubt which way the scene goes.
    Certain,
    /// The proved error of this answer is small beside its tolerance.
    Proved(usize),
    /// The kinetic energy is not a small rest of the energy put in.
    Input,
    /// What happens is what the problem declares; this happens.
    Regime(Regime),
    /// The relation by which this part follows from others gives its right answer.
    Follows(usize),
    /// A condition of validity holds, with its margin.
    Check(CheckKind),
    /// This question has an answer.
    Answered(usize),
    /// The printed data determine this answer.
    Cond(usize),
    /// This bound holds.
    Bound(usize),
    /// This wrong method stays away from right answers.
    Mistake(usize),
}

/// A rule that refuses a draw, and the number that came out: a margin, a condition number, the value of a bound. NaN where
/// there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refused {
    pub rule: DrawRule,
    /// What came out.
    pub found: f64,
}

impl DrawRule {
    /// The refusal in which this number came out.
    pub const fn found(self, found: f64) -> Refused {
        Refused { rule: self, found }
    }
}

impl From<DrawRule> for Refused {
    fn from(rule: DrawRule) -> Self {
        rule.found(f64::NAN)
    }
}

/// How often a rule refused, and the least and the greatest number that came out.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RuleTally {
    count: u32,
    least: f64,
    most: f64,
}

impl RuleTally {
    const NONE: RuleTally = RuleTally { count: 0, least: f64::INFINITY, most: f64::NEG_INFINITY };
    fn join(&mut self, other: RuleTally) {
        self.count += other.count;
        // NaN is no number that came out.
        self.least = self.least.min(other.least);
        self.most = self.most.max(other.most);
    }
    /// `0.2`, or `0.2 to 0.4`; empty where no number came out.
    fn range(self, shown: &dyn Fn(f64) -> String) -> String {
        if self.least > self.most {
            return String::new();
        }
        let (least, most) = (shown(self.least), shown(self.most));
        if least == most { least } else { format!("{least} to {most}") }
    }
}

/// How often each rule refused a draw.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Refusals {
    tallies: BTreeMap<DrawRule, RuleTally>,
    /// The last draw of admissible data that could not be solved, or on which the two roads disagreed.
    pub unsolved: Option<Refusal>,
    /// What was wrong with the last draw that is no scene.
    pub inadmissible: Vec<Inadmissible>,
    /// Condition numbers of all questions, draw by draw, of the draws that hold all rules but those about them; kept only by
    /// a maker that is watching.
    pub conds: Vec<f64>,
    /// Draws that hold all rules but those about wrong methods; kept only by a maker that is watching.
    pub told: u32,
    /// How many of those each wrong method would refuse, guarded or not: for each method its questions in order, and last
    /// all of them together.
    pub near: Vec<u32>,
}

impl Refusals {
    /// Counts a refusal.
    pub fn add(&mut self, refused: Refused) {
        let one = RuleTally { count: 1, least: refused.found, most: refused.found };
        self.tallies.entry(refused.rule).or_insert(RuleTally::NONE).join(one);
    }
    /// Adds the counts of another variant of the same case.
    pub fn join(&mut self, other: &Refusals) {
        for (rule, tally) in &other.tallies {
            self.tallies.entry(*rule).or_insert(RuleTally::NONE).join(*tally);
        }
        self.conds.extend_from_slice(&other.conds);
        self.told += other.told;
        if self.near.len() < other.near.len() {
            self.near.resize(other.near.len(), 0);
        }
        for (mine, theirs) in self.near.iter_mut().zip(&other.near) {
            *mine += theirs;
        }
        if other.unsolved.is_some() {
            self.unsolved.clone_from(&other.unsolved);
        }
        if !other.inadmissible.is_empty() {
            self.inadmissible.clone_from(&other.inadmissible);
        }
    }
    /// Names of the rules that refused and how often, most first.
    pub fn names(&self, problem: &Problem, case: usize) -> Vec<(String, u32)> {
        let named = self.tallies.iter().map(|(rule, tally)| (name(problem, case, *rule), tally.count));
        sorted(named)
    }
    /// The same with what came out and what the problem declares.
    pub fn table(&self, problem: &Problem, case: usize) -> Vec<(String, u32)> {
        let regime = |rule: &DrawRule| matches!(rule, DrawRule::Regime(_));
        let others = self.tallies.iter().filter(|(rule, _)| !regime(rule));
        let rows = others.map(|(rule, tally)| (self.sentence(problem, case, *rule, *tally), tally.count));
        let mut happened: Vec<(Regime, u32)> = Vec::new();
        for (rule, tally) in &self.tallies {
            if let DrawRule::Regime(regime) = rule {
                happened.push((*regime, tally.count));
            }
        }
        happened.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let all: u32 = happened.iter().map(|(_, n)| n).sum();
        let list: Vec<String> = happened.iter().map(|(r, n)| format!("{n} of {all} {}", r.they())).collect();
        let declared = problem.cases.get(case).map_or_else(String::new, |c| c.regimes.join(", "));
        let declared = match declared.is_empty() {
            true => "no `regimes`, so nothing may slip".to_owned(),
            false => format!("`regimes`: {declared}"),
        };
        // Where forces change on the way, a regime says whether the end is reached.
        let longer = happened.iter().find(|(r, _)| r.word().ends_with(" ok") && declared.contains("moves_"));
        let declared =
            longer.map_or_else(|| declared.clone(), |(r, _)| format!("{declared}; write `{}`", r.word()));
        let regime = format!("regime: {} ({declared})", list.join(", "));
        sorted(rows.chain((all > 0).then_some((regime, all))))
    }

    /// What to do about draws that are all refused; nothing where the refusal itself says it.
    pub fn hint(&self, problem: &Problem, constant: bool) -> Option<String> {
        if !constant {
            return Some("widen the ranges, or loosen the rule that refuses most".to_owned());
        }
        let told = |rule: &DrawRule| {
            use DrawRule::{Admissible, Agree, Alone, Certain, Solvable, Start};
            matches!(rule, Admissible | Solvable | Start | Agree | Certain | Alone)
        };
        if self.tallies.keys().any(told) {
            return None;
        }
        let conds = self.tallies.iter().filter_map(|(rule, tally)| match rule {
            DrawRule::Cond(question) => Some((problem.questions.get(*question)?.id.as_str(), tally.most)),
            _ => None,
        });
        let (ill, open): (Vec<_>, Vec<_>) = conds.partition(|(_, found)| found.is_finite());
        let listed = |all: &[(&str, f64)], one: &dyn Fn(&str, f64) -> String| {
            all.iter().map(|(id, found)| one(id, *found)).collect::<Vec<_>>().join(", ")
        };
        let of_cond = |rule: &DrawRule| matches!(rule, DrawRule::Cond(_));
        let mut others = self.tallies.iter().filter(|(rule, _)| !of_cond(rule)).peekable();
        let mut hints = Vec::new();
        if others.peek().is_some() {
            let near = |(rule, tally): (&DrawRule, &RuleTally)| {
                let share = matches!(rule, DrawRule::Check(kind) if kind.is_share());
                share && tally.least > 0.0 && tally.least.is_finite()
            };
            let instant = |rule: &DrawRule| matches!(rule, DrawRule::Regime(r) if r.word() == "instant");
            hints.push(
                if self.tallies.keys().any(instant) {
                    "of an instant no regime is told: leave `regimes` out, and ask for what holds then"
                } else if others.all(near) {
                    "with these numbers it happens, but within a margin: write the `margins:` that is named above smaller, or change a number"
                } else {
                    "with these numbers it does not happen, whatever the margins: change a number, the ties or the end"
                }
                .to_owned(),
            );
        }
        if !open.is_empty() {
            hints.push(format!(
                "with just these numbers nothing says how well {} is determined (it is 0, or they lie at a kink or a limit): change a \
                 number a little, or the question",
                listed(&open, &|id, _| format!("`{id}`"))
            ));
        }
        if !ill.is_empty() {
            hints.push(format!(
                "these numbers determine it less well than most: write {}, or in the problem",
                listed(&ill, &|id, found| format!("`cond limit: {}` beside `{id}`", (1.1 * found).ceil()))
            ));
        }
        Some(hints.join("; "))
    }

    /// What a rule refused, with the numbers.
    fn sentence(&self, problem: &Problem, case: usize, rule: DrawRule, tally: RuleTally) -> String {
        let plain = rounded;
        let name = name(problem, case, rule);
        let came_out = match rule {
            DrawRule::Check(kind) => {
                let margin = problem.margins.iter().find(|(k, _)| *k == kind).map_or(0.0, |(_, m)| *m);
                let range = tally.range(&|x| format!("{} %", rounded(100.0 * x)));
                match (kind.is_share() && !range.is_empty(), margin > 0.0) {
                    (false, _) => "does not hold".to_owned(),
                    (true, true) => format!("margin {range} (`margins`: {} %)", rounded(100.0 * margin)),
                    (true, false) => format!("margin {range} (above 0 % it holds)"),
                }
            }
            DrawRule::Cond(_) => format!("{} (`cond limit`)", tally.range(&plain)),
            DrawRule::Input => format!("{} times (`input energy limit`)", tally.range(&plain)),
            DrawRule::Bound(bound) => match problem.cases.get(case).and_then(|c| c.bounds.get(bound)) {
                Some(bound) => format!("{} ({})", tally.range(&|x| in_unit(bound, x)), wanted(bound)),
                None => String::new(),
            },
            DrawRule::Proved(_) => {
                format!("{} of its tolerance", tally.range(&plain))
            }
            DrawRule::Admissible => {
                let scene = problem.cases.get(case).map(|c| &c.scene);
                let told = |f| Some(inadmissible(problem, scene?, f));
                self.inadmissible.iter().filter_map(told).collect::<Vec<_>>().join("; ")
            }
            _ => String::new(),
        };
        if came_out.is_empty() { name } else { format!("{name}: {came_out}") }
    }
}

fn sorted(rows: impl Iterator<Item = (String, u32)>) -> Vec<(String, u32)> {
    let mut list: Vec<(String, u32)> = Vec::new();
    for (name, count) in rows {
        match list.iter_mut().find(|(n, _)| *n == name) {
            Some((_, n)) => *n += count,
            None => list.push((name, count)),
        }
    }
    list.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    list
}

/// What a rule is called where it refuses.
fn name(problem: &Problem, case: usize, rule: DrawRule) -> String {
    let question = |i: usize| problem.questions.get(i).map_or("?", |q| q.id.as_str());
    match rule {
        DrawRule::Admissible => "data that are no scene".to_owned(),
        DrawRule::Solvable => "cannot be solved".to_owned(),
        DrawRule::Start => "the start contradicts the ties, or leaves a velocity open".to_owned(),
        DrawRule::Agree => "the equations of motion and work and energy disagree".to_owned(),
        DrawRule::Alone => {
            "with these data other contacts may roll or slip as well: change a number (`mu_k` nearer to `mu_s`), or write `rolls` and \
             `slips` and tell students so"
                .to_owned()
        }
        DrawRule::Certain => {
            let open = "the key is not proved: rounding of the printed data leaves open which way it goes";
            match problem.cases.get(case).map(|c| c.scene.end) {
                Some(End::Speed(..)) => {
                    format!("{open} or how fast: end with `turning point` where it comes to rest")
                }
                _ => open.to_owned(),
            }
        }
        DrawRule::Proved(i) => format!("the key is not proved: the bound of the error of {}", question(i)),
        DrawRule::Input => format!("input energy above {} times the kinetic", problem.energy_limit),
        DrawRule::Regime(_) => "regime".to_owned(),
        DrawRule::Follows(i) => format!("the relation of `follows` for {} does not hold", question(i)),
        DrawRule::Check(kind) => kind.name().to_owned(),
        DrawRule::Answered(i) => format!("question {} has no answer", question(i)),
        DrawRule::Cond(i) => {
            let limit = problem.questions.get(i).map_or(f64::NAN, |q| q.cond_limit);
            let limit = shown::decimals(limit, 1);
            format!("cond of {} above {}", question(i), limit.trim_end_matches(".0"))
        }
        DrawRule::Bound(i) => {
            let bound = problem.cases.get(case).and_then(|c| c.bounds.get(i));
            format!("bound {}", bound.map_or("?", |b| b.text.as_str()))
        }
        DrawRule::Mistake(i) => {
            let mistake = problem.mistakes.get(i);
            format!("wrong method {} near a right answer", mistake.map_or("?", |m| m.id.as_str()))
        }
    }
}

/// A value of a bound's expression, in SI.
fn in_unit(bound: &Bound, value: f64) -> String {
    let powers = measure::powers_text(bound.expression.powers);
    // Roots of units have no spelling of their own.
    let unit = Unit::parse(&powers).map_or(powers, |u| u.ascii().to_owned());
    if unit == "1" { rounded(value) } else { format!("{} {unit}", rounded(value)) }
}

/// What a bound allows.
fn wanted(bound: &Bound) -> String {
    let shown = |x: f64| in_unit(bound, x);
    match (bound.min, bound.max) {
        (Some(min), Some(max)) => format!("wanted: {} to {}", shown(min), shown(max)),
        (Some(min), None) => format!("wanted: at least {}", shown(min)),
        (None, Some(max)) => format!("wanted: at most {}", shown(max)),
        (None, None) => "wanted: a number".to_owned(),
    }
}

/// A number of the scene by its symbol.
fn symbol(problem: &Problem, scene: &Scene, num: Num) -> String {
    match num {
        Num::Derived(i) => {
            let written = scene.formulas.numbers.get(i);
            written.map_or_else(|| "a number".to_owned(), |n| format!("`{}`", n.text))
        }
        Num::Datum(i) => problem.data.get(i).map_or_else(|| "a datum".to_owned(), |d| d.symbol.clone()),
        Num::Fixed(x) => format!("the constant {x}"),
    }
}

/// What is wrong with a number of the scene.
pub fn inadmissible(problem: &Problem, scene: &Scene, fault: &Inadmissible) -> String {
    use admissible::Rule as R;
    let (name, value) = (symbol(problem, scene, fault.datum), fault.value);
    // A constant tells its value itself.
    let mut told =
        if matches!(fault.datum, Num::Fixed(_)) { name.clone() } else { format!("{name} = {value}") };
    if value.is_nan() && !fault.of.is_empty() {
        told = format!("{name} is no number");
    }
    let of = fault.of.iter().filter_map(|(i, x)| problem.data.get(*i).map(|d| (d, d.unit.from_si(*x))));
    let of: Vec<String> =
        of.map(|(d, x)| format!("{} = {}", d.symbol, d.unit.text_with(&rounded(x)))).collect();
    if !of.is_empty() {
        told = format!("{told} with {}", of.join(", "));
    }
    if let Num::Derived(i) = fault.datum
        && let Some(needs) =
            scene.formulas.numbers.get(i).and_then(|written| need::about_pin_needs(&written.text))
    {
        return format!("{told}: {needs}");
    }
    match fault.rule {
        R::Finite => format!("{told}: must be a finite number"),
        R::Positive => format!("{told}: must be above 0"),
        R::NotNegative => {
            let way = if scene.couples.iter().any(|c| c.moment_n_m == fault.datum) {
                need::TURNS_BACK
            } else if scene.pushes.iter().any(|p| p.force_n == fault.datum) {
                need::ACTS_WHITHER
            } else {
                ""
            };
            format!("{told}: must not be below 0{way}")
        }
        R::Range => format!(
            "{name} = {value:e}: must be 0 or from {:e} to {:e} in SI units; beyond, products leave the doubles",
            admissible::LEAST,
            admissible::MOST
        ),
        R::Angle => format!("{told}: an angle is from -360 to 360 degrees"),
        R::Turns => format!("{told}: an angle lies within 20 turns of 0"),
        R::Stretch => format!("{told}: must not be above the length of the spring at the start"),
        R::Slope => format!("{told}: a slope is from 0 to 90 degrees"),
        R::NotAbove(other) => {
            let frictions = scene.ties.iter().any(|tie| match *tie {
                Tie::Slip { mu_s, mu_k, .. } => (mu_k, Some(mu_s)) == (fault.datum, Some(other)),
                Tie::Slide { mu_s, mu_k, .. } => (mu_k, mu_s) == (fault.datum, Some(other)),
                Tie::Roll { .. } | Tie::Cord(_) => false,
            }) || scene.formulas.below.contains(&(fault.datum, other));
            let [own, its] = if frictions { ["mu_k, ", "mu_s, "] } else { [""; 2] };
            format!("{own}{told}: must not be above {its}{}", symbol(problem, scene, other))
        }
        R::Inside(other) => {
            format!("{told}: must be below {}, for the body moves inside it", symbol(problem, scene, other))
        }
        R::Unlike(other) => format!(
            "{told}: must not be {}: the body would touch all around and could not roll or slide",
            symbol(problem, scene, other)
        ),
    }
}

/// Four figures, for people: enough to tell what just breaks a limit from the limit.
fn rounded(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    let decimals = match size {
        1e-3..1.0 => 4,
        1.0..10.0 => 3,
        10.0..100.0 => 2,
        100.0..1e3 => 1,
        1e3..1e6 => 0,
        _ => return shown::figures(value, 2),
    };
    shown::at_most_decimals(value, decimals)
}
