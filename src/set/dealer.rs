//! Dealing: the variants of one student and their key, problem by problem.
use crate::bank::{Bank, Problem};
use crate::finding::{Finding, Findings};
use crate::key::{ProblemKey, SheetKey};
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

    /// Draws and solves the problems of one student.
    ///
    /// # Errors
    /// The bank cannot be satisfied: the table of refusals.
    pub fn deal(&self, student: &str) -> Result<Dealt, Box<Unsatisfiable>> {
        let mut variants = Vec::with_capacity(self.makers.len());
        let mut keys = Vec::with_capacity(self.makers.len());
        for (problem, maker) in &self.makers {
            let variant = maker.variant(student)?;
            keys.push(coded(maker.key(&variant), &stored(problem, &variant)));
            variants.push(variant);
        }
        Ok(Dealt { variants, key: SheetKey { student: student.to_owned(), problems: keys } })
    }

    /// Deals once more what is stored: of each problem only the draw that was taken, not the refused ones before it. `None`
    /// where anything differs; [`Dealer::deal`] then tells what.
    pub fn deal_again(&self, old: &StoredStudent) -> Option<Dealt> {
        let mut variants = Vec::with_capacity(self.makers.len());
        let mut keys = Vec::with_capacity(self.makers.len());
        if old.problems.len() != self.makers.len() {
            return None;
        }
        for ((problem, maker), old_variant) in self.makers.iter().zip(&old.problems) {
            let variant = maker.again(&old.student, old_variant.tries)?;
            if old_variant.difference(&stored(problem, &variant)).is_some() {
                return None;
            }
            keys.push(coded(maker.key(&variant), old_variant));
            variants.push(variant);
        }
        Some(Dealt { variants, key: SheetKey { student: old.student.clone(), problems: keys } })
    }
}

/// The key of a variant with the code of what is stored of it.
pub(crate) fn coded(key: ProblemKey, stored: &StoredVariant) -> ProblemKey {
    ProblemKey { code: stored.code(), ..key }
}

/// What is stored of a variant: case and data as printed.
pub fn stored(problem: &Problem, variant: &Variant) -> StoredVariant {
    let mut data = Map::new();
    for (i, datum) in problem.data.iter().enumerate() {
        if let Some(drawn) = variant.values.get(i).copied().flatten() {
            data.insert(datum.symbol.clone(), Value::String(statement::printed(problem, i, drawn)));
        }
    }
    let case = problem.cases.get(variant.case).map_or_else(String::new, |c| c.name.clone());
    let table = variant.refusals.names(problem, variant.case);
    let refused = table.into_iter().map(|(rule, count)| (rule, Value::from(count))).collect();
    let (id, parts) = (problem.id.clone(), BTreeMap::new());
    StoredVariant { id, case, tries: variant.tries, refused, data, parts }
}

/// Indices of problems by id.
///
/// # Errors
/// Ids that the bank does not have, and ids given twice.
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

/// The same, or all of the bank where none are named.
///
/// # Errors
/// As [`indices`].
pub fn chosen(bank: &Bank, ids: Option<&[String]>, field: &str) -> Result<Vec<usize>, Findings> {
    ids.map_or_else(|| Ok((0..bank.problems.len()).collect()), |ids| indices(bank, ids, field))
}
