//! The key of a set from its stored data, with a bank that may have been changed since: nothing is drawn, what was printed on
//! the sheets stays what it was, and both roads are solved anew.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Draw, Problem};
use crate::finding::{Finding, Findings, push_new};
use crate::key::ProblemKey;
use crate::problem::maker::Variant;
use crate::problem::{make_key, maker};
use crate::set::dealer::{Dealt, coded, indices};
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::sheet::statement;
use crate::solve::outcome::Refusal;
use crate::units::spell;
use rayon::prelude::*;

/// That the stored data of a student give no key.
#[derive(Debug, Clone, PartialEq)]
pub struct Lost {
    /// Id of the student.
    pub student: String,
    /// Index of the problem in the bank.
    pub problem: usize,
    /// Index of the case.
    pub case: usize,
    /// Why.
    pub why: LostWhy,
}

/// Why there is no key.
#[derive(Debug, Clone, PartialEq)]
pub enum LostWhy {
    /// The scene cannot be solved, or the two roads disagree.
    Refused(Refusal),
    /// It is solved, but something else happens than the problem says: what does.
    Happens(String),
    /// This part has no answer.
    Unanswered(String),
    /// The relation by which this part follows from others does not give its right answer.
    Relation(String),
}

/// What stands in the way.
#[derive(Debug, Clone, PartialEq)]
pub enum GivenFault {
    /// The bank and the stored data do not fit each other.
    Misfit(Finding),
    /// The data of one student give no key.
    Lost(Lost),
}

/// The stored students with their keys, in the order of the set.
/// Errors: problems, cases and data that the bank no longer has, once each; then the students whose data give no key, all of them.
pub fn all(bank: &Bank, set: &StoredSet) -> Result<Vec<Dealt>, Vec<GivenFault>> {
    let problems = indices(bank, &set.problems, "problems")
        .map_err(|faults| faults.into_iter().map(GivenFault::Misfit).collect::<Vec<_>>())?;
    let one = |s: &StoredStudent| {
        one(bank, &problems, s, &|index, case, values| {
            let lost = |why| GivenFault::Lost(Lost { student: s.student.clone(), problem: index, case, why });
            solved(&bank.problems[index], case, values).map_err(lost)
        })
    };
    let solved: Vec<Result<Dealt, Vec<GivenFault>>> = set.students.par_iter().map(one).collect();
    let (mut found, mut faults) = (Vec::with_capacity(solved.len()), Vec::new());
    for result in solved {
        match result {
            Ok(given) => found.push(given),
            Err(more) => more.into_iter().for_each(|fault| push_new(&mut faults, fault)),
        }
    }
    // What is wrong with the bank goes before what is wrong for somebody.
    faults.sort_by_key(|f| matches!(f, GivenFault::Lost(_)));
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

/// Solves a problem (an index) of a case with data as they are stored.
type Solve<'s> = dyn Fn(usize, usize, &[Option<Decimal>]) -> Result<(Variant, ProblemKey), GivenFault> + 's;

/// Variants and key of a student; parts that were asked with other data have theirs from those.
fn one(
    bank: &Bank,
    problems: &[usize],
    student: &StoredStudent,
    solve: &Solve,
) -> Result<Dealt, Vec<GivenFault>> {
    let (id, stored) = (&student.student, &student.problems);
    let misfit = |what: String| GivenFault::Misfit(Finding::new("students", what));
    if stored.len() != problems.len() {
        return Err(vec![misfit(format!("{id} has {} problems, the set {}", stored.len(), problems.len()))]);
    }
    let (mut found, mut faults) = (Vec::with_capacity(problems.len()), Vec::new());
    for (index, old) in problems.iter().zip(stored) {
        let problem = &bank.problems[*index];
        if old.id != problem.id {
            faults.push(misfit(format!("{id} has `{}` where the set has `{}`", old.id, problem.id)));
            continue;
        }
        let solve = |old: &StoredVariant| -> Result<_, Vec<GivenFault>> {
            let misfits = |more: Findings| more.into_iter().map(GivenFault::Misfit).collect::<Vec<_>>();
            let (case, values) = values(problem, old).map_err(misfits)?;
            let (variant, key) = solve(*index, case, &values).map_err(|fault| vec![fault])?;
            Ok((variant, coded(key, old)))
        };
        let with_parts = || -> Result<_, Vec<GivenFault>> {
            let (variant, mut key) = solve(old)?;
            for (part, other) in &old.parts {
                key.take_part(part, &solve(other)?.1);
            }
            Ok((variant, key))
        };
        match with_parts() {
            Ok(both) => found.push(both),
            Err(more) => faults.extend(more),
        }
    }
    if faults.is_empty() { Ok(Dealt::new(id, found)) } else { Err(faults) }
}

/// All students of a set that an earlier version drew, see [`as_stored`].
/// Errors: those of [`as_stored`], of the first student who has any.
pub fn all_as_stored(bank: &Bank, set: &StoredSet) -> Result<Vec<Dealt>, Findings> {
    let problems = indices(bank, &set.problems, "problems")?;
    let all: Vec<_> = set.students.par_iter().map(|s| as_stored(bank, &problems, s)).collect();
    all.into_iter().collect()
}

/// A stored student of a set that an earlier version drew: variants and key from the stored data. What counts is the stored
/// key, so no rule of drawing is asked. Errors: bank and data do not fit each other, or the scene has no answer.
pub fn as_stored(bank: &Bank, problems: &[usize], student: &StoredStudent) -> Result<Dealt, Findings> {
    let solve = |index: usize, case: usize, values: &[Option<Decimal>]| {
        let problem = &bank.problems[index];
        let variant = maker::from_values(problem, case, values).map_err(|_| {
            let field = format!("students {}, {}", student.student, problem.id);
            GivenFault::Misfit(Finding::new(field, "the stored data have no answer by this version"))
        })?;
        let key = make_key::key(problem, &variant);
        Ok((variant, key))
    };
    let misfit = |fault| match fault {
        GivenFault::Misfit(finding) => Some(finding),
        GivenFault::Lost(_) => None,
    };
    one(bank, problems, student, &solve).map_err(|faults| faults.into_iter().filter_map(misfit).collect())
}

/// Case and data as the bank's problem takes them. Findings are the same for every student with the same trouble.
fn values(problem: &Problem, old: &StoredVariant) -> Result<(usize, Vec<Option<Decimal>>), Findings> {
    let path = |rest: &str| format!("problems.{}.{rest}", problem.id);
    let Some(index) = problem.cases.iter().position(|c| c.name == old.case) else {
        let what = match old.case.as_str() {
            "" => "the bank has cases now, the sheets were drawn without".to_owned(),
            name => format!("the bank has no case `{name}`, which is on sheets"),
        };
        return Err(Finding::new(path("cases"), what).into());
    };
    let mut faults = Findings::default();
    let case = &problem.cases[index];
    for symbol in old.data.keys() {
        let used = problem.data.iter().position(|d| d.symbol == *symbol);
        if used.is_none_or(|i| case.draws.get(i).is_none_or(Option::is_none)) {
            let known = problem.data.iter().map(|d| d.symbol.as_str());
            let fault = Finding::new(
                path("data"),
                format!("`{symbol}` is printed on sheets, the bank has it no more"),
            );
            faults.push(match spell::closest(symbol, known) {
                Some(near) if !old.data.contains_key(near) => fault.hint(format!(
                    "was it renamed to `{near}`? Sheets keep the symbol that they were printed with"
                )),
                _ => fault,
            });
        }
    }
    let mut values = vec![None; problem.data.len()];
    for (i, datum) in problem.data.iter().enumerate() {
        let Some(draw) = case.draws.get(i).and_then(Option::as_ref) else { continue };
        let field = path(&format!("data.{}", datum.symbol));
        match old.data.get(&datum.symbol).and_then(serde_json::Value::as_str) {
            Some(text) => {
                let digits = text.split(' ').next().unwrap_or_default();
                let value = Decimal::parse(digits);
                // The unit is that of the sheet, or the number would mean something else.
                match value.filter(|v| statement::printed(problem, i, *v) == text) {
                    Some(value) => values[i] = Some(value),
                    None => {
                        let unit = text.split_once(' ').map_or("no unit", |(_, unit)| unit);
                        let what = format!(
                            "is printed in {unit} on the sheets, the bank says {}",
                            datum.unit.ascii()
                        );
                        faults.push(Finding::new(field, what).hint("give the datum its old unit back"));
                    }
                }
            }
            None => match draw {
                // A constant that no sheet prints is the same for all.
                Draw::Always { value, decimals } => {
                    values[i] = Some(Decimal { value: *value, decimals: *decimals });
                }
                _ => faults.push(
                    Finding::new(field, "is drawn in the bank, and on no sheet")
                        .hint("a datum that came later can only be `draw: always ...`"),
                ),
            },
        }
    }
    faults.into_result((index, values))
}

fn solved(
    problem: &Problem,
    case: usize,
    values: &[Option<Decimal>],
) -> Result<(Variant, ProblemKey), LostWhy> {
    let variant = maker::from_values(problem, case, values).map_err(LostWhy::Refused)?;
    let regime = variant.solved.regime;
    let told = &problem.cases[case];
    if !regime.is_one_of(&told.regimes, &told.scene) {
        return Err(LostWhy::Happens(regime.word()));
    }
    if let Some(check) = variant.solved.failing(&told.regimes) {
        return Err(LostWhy::Happens(format!("{} fails", check.kind.name())));
    }
    let missing = problem.questions.iter().find(|q| match q.label.quantity.is_word() {
        true => variant.solved.word(q.label).is_none(),
        false => variant.solved.get(q.label).is_none_or(|e| !e.value().is_finite()),
    });
    if let Some(question) = missing {
        return Err(LostWhy::Unanswered(question.id.clone()));
    }
    if let Some(part) =
        maker::broken_relation(problem, &problem.cases[variant.case], &variant.data, &variant.solved)
    {
        return Err(LostWhy::Relation(problem.questions[part].id.clone()));
    }
    let key = make_key::key(problem, &variant);
    Ok((variant, key))
}
