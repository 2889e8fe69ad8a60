//! Dealing: the variants of one student and their key, problem by problem.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Problem};
use crate::finding::{Finding, Findings};
use crate::key::{ProblemKey, SheetKey, WrongValue};
use crate::problem::maker::{Maker, Unsatisfiable, Variant};
use crate::set::store::{StoredStudent, StoredVariant};
use crate::sheet::statement;
use crate::units::spell;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// What one student got, problem by problem, drawn or as it is stored.
pub struct Dealt {
    /// Variants in the order of the sheet.
    pub variants: Vec<Variant>,
    /// Their key.
    pub key: SheetKey,
}

impl Dealt {
    /// From variant and key of each problem.
    pub fn new(student: &str, drawn: Vec<(Variant, ProblemKey)>) -> Self {
        let (variants, problems) = drawn.into_iter().unzip();
        Self { variants, key: SheetKey { student: student.to_owned(), problems } }
    }
}

/// Makes the variants of a set, problem by problem.
pub struct Dealer<'b> {
    makers: Vec<(&'b Problem, Maker<'b>)>,
}

impl<'b> Dealer<'b> {
    /// For these problems (indices into the bank).
    pub fn new(bank: &'b Bank, problems: &[usize], seed: u64, set: &str) -> Self {
        let chosen = problems.iter().filter_map(|p| bank.problems.get(*p));
        Self { makers: chosen.map(|p| (p, Maker::new(p, seed, set))).collect() }
    }

    /// Draws and solves the problems of one student. Errors: the bank cannot be satisfied: the table of refusals.
    pub fn deal(&self, student: &str) -> Result<Dealt, Box<Unsatisfiable>> {
        let drawn = self.makers.iter().map(|(problem, maker)| -> Result<_, Box<Unsatisfiable>> {
            let variant = maker.variant(student)?;
            let key = coded(maker.key(&variant), &stored(problem, &variant));
            Ok((variant, key))
        });
        Ok(Dealt::new(student, drawn.collect::<Result<Vec<_>, _>>()?))
    }

    /// Deals once more what is stored: of each problem only the draw that was taken, not the refused ones before it. `None`
    /// where anything differs; [`Dealer::deal`] then tells what.
    pub fn deal_again(&self, old: &StoredStudent) -> Option<Dealt> {
        self.dealt_by(old, |maker, student, tries| maker.again(student, tries).ok())
    }

    /// By which rule the draw that a student was dealt is refused now; `None` where another one is drawn in its place, or it holds.
    pub fn refusal(&self, old: &StoredStudent, problem: usize) -> Option<String> {
        let ((problem, maker), old_variant) = (self.makers.get(problem)?, old.problems.get(problem)?);
        let refused = maker.again(&old.student, old_variant.tries).err()?;
        (printed(problem, &refused.variant.values) == old_variant.data).then_some(refused.why)
    }

    /// The same by the first road alone: unproved, and without wrong methods ([`Dealer::wrong_values`]).
    pub fn by_first_road(&self, old: &StoredStudent) -> Option<Dealt> {
        self.dealt_by(old, Maker::by_first_road)
    }

    /// Where the wrong methods of a student's problem come to, part by part.
    pub fn wrong_values(&self, old: &StoredStudent, problem: usize) -> Option<Vec<Vec<WrongValue>>> {
        let (_, maker) = self.makers.get(problem)?;
        maker.wrong_values(&old.student, old.problems.get(problem)?.tries)
    }

    fn dealt_by(
        &self,
        old: &StoredStudent,
        draw: impl Fn(&Maker<'b>, &str, u32) -> Option<Variant>,
    ) -> Option<Dealt> {
        let drawn = self.makers.iter().zip(&old.problems).map(|((problem, maker), old_variant)| {
            let variant = draw(maker, &old.student, old_variant.tries)?;
            let same = old_variant.difference(&stored(problem, &variant)).is_none();
            let key = coded(maker.key(&variant), old_variant);
            same.then_some((variant, key))
        });
        let drawn = drawn.collect::<Option<Vec<_>>>()?;
        (old.problems.len() == self.makers.len()).then(|| Dealt::new(&old.student, drawn))
    }
}

/// The key of a variant with the code of what is stored of it.
pub(crate) fn coded(key: ProblemKey, stored: &StoredVariant) -> ProblemKey {
    ProblemKey { code: stored.code(), ..key }
}

/// Values as printed, by the symbols of their data.
fn printed(problem: &Problem, values: &[Option<Decimal>]) -> Map<String, Value> {
    let drawn = values.iter().enumerate().filter_map(|(i, value)| Some((i, (*value)?)));
    let text = |i, value| Value::String(statement::printed(problem, i, value));
    drawn.filter_map(|(i, value)| Some((problem.data.get(i)?.symbol.clone(), text(i, value)))).collect()
}

/// What is stored of a variant: case and data as printed.
pub fn stored(problem: &Problem, variant: &Variant) -> StoredVariant {
    let data = printed(problem, &variant.values);
    let case = problem.cases.get(variant.case).map_or_else(String::new, |c| c.name.clone());
    let table = variant.refusals.names(problem, variant.case);
    let refused = table.into_iter().map(|(rule, count)| (rule, Value::from(count))).collect();
    let (id, parts) = (problem.id.clone(), BTreeMap::new());
    StoredVariant { id, case, tries: variant.tries, refused, data, parts }
}

/// Indices of problems by id. Errors: ids that the bank does not have, and ids given twice.
pub fn indices(bank: &Bank, ids: &[String], field: &str) -> Result<Vec<usize>, Findings> {
    let mut found = Vec::new();
    let mut faults = Findings::default();
    for id in ids {
        match bank.problems.iter().position(|p| p.id == *id) {
            Some(i) if found.contains(&i) => {
                faults.push(Finding::new(field, format!("`{id}` is named twice")))
            }
            Some(i) => found.push(i),
            None => {
                let known = bank.problems.iter().map(|p| p.id.as_str());
                let fault = Finding::new(field, format!("the bank has no problem `{id}`"));
                faults.push(fault.hint(spell::hint(id, "its problems", known)));
            }
        }
    }
    faults.into_result(found)
}

/// The same, or all of the bank where none are named. Errors: as [`indices`].
pub fn chosen(bank: &Bank, ids: Option<&[String]>, field: &str) -> Result<Vec<usize>, Findings> {
    ids.map_or_else(|| Ok((0..bank.problems.len()).collect()), |ids| indices(bank, ids, field))
}
