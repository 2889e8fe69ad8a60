//! Drawing a set, and drawing it again to see that nothing has changed.
use crate::bank::{Bank, Problem};
use crate::draw::stream;
use crate::finding::{Finding, Findings};
use crate::key::SheetKey;
use crate::problem::make::{Maker, Unsatisfiable, Variant};
use crate::set::given;
use crate::set::given::GivenSheet;
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::sheet::statement;
use rayon::prelude::*;
use serde_json::{Map, Value};
use std::sync::atomic::{AtomicBool, Ordering};

/// What one student got: variants and key, problem by problem.
pub struct Dealt {
    /// Variants in the order of the sheet.
    pub variants: Vec<Variant>,
    /// Their key.
    pub key: SheetKey,
}

/// Makes the variants of a set, problem by problem.
pub struct Dealer<'b> {
    makers: Vec<Maker<'b>>,
}

impl<'b> Dealer<'b> {
    /// For these problems (indices into the bank).
    pub fn new(bank: &'b Bank, problems: &[usize], seed: u64, set: &str) -> Self {
        let chosen = problems.iter().filter_map(|p| bank.problems.get(*p));
        Self { makers: chosen.map(|p| Maker::new(p, seed, set)).collect() }
    }

    /// Draws and solves the problems of one student.
    ///
    /// # Errors
    /// The bank cannot be satisfied: the table of refusals.
    pub fn deal(&self, student: &str) -> Result<Dealt, Box<Unsatisfiable>> {
        let mut variants = Vec::with_capacity(self.makers.len());
        let mut keys = Vec::with_capacity(self.makers.len());
        for maker in &self.makers {
            let variant = maker.variant(student)?;
            keys.push(maker.key(&variant));
            variants.push(variant);
        }
        Ok(Dealt { variants, key: SheetKey { student: student.to_owned(), problems: keys } })
    }

    /// Deals once more what is stored: for each problem only the last of so many tries. `None` where anything differs, for
    /// [`Dealer::deal`] to say what.
    fn deal_again(&self, bank: &Bank, problems: &[usize], old: &StoredStudent) -> Option<Dealt> {
        let mut variants = Vec::with_capacity(self.makers.len());
        let mut keys = Vec::with_capacity(self.makers.len());
        if old.problems.len() != self.makers.len() {
            return None;
        }
        for ((maker, index), old_variant) in self.makers.iter().zip(problems).zip(&old.problems) {
            let variant = maker.again(&old.student, old_variant.tries)?;
            if difference(old_variant, &stored(bank.problems.get(*index)?, &variant)).is_some() {
                return None;
            }
            keys.push(maker.key(&variant));
            variants.push(variant);
        }
        Some(Dealt { variants, key: SheetKey { student: old.student.clone(), problems: keys } })
    }
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
    StoredVariant { id: problem.id.clone(), case, tries: variant.tries, refused, data }
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
                faults.push(fault.hint(crate::units::spell::hint(id, "its problems", known)));
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

/// Was the set drawn by an earlier version, which chose other draws? Then nothing is drawn again: what was drawn is taken as it
/// is stored, and so is the key ([`crate::set::key_file::put_stored`]).
pub fn is_earlier(set: &StoredSet) -> bool {
    set.draw_version < stream::DRAW_VERSION
}

/// Draws and solves a stored set again. The keys are returned only if the bank copy and every drawn number are the
/// stored ones.
///
/// # Errors
/// What differs: at most five findings and their number.
pub fn keys(bank: &Bank, set: &StoredSet) -> Result<Vec<SheetKey>, Findings> {
    each(bank, set, &|_, _, dealt| Ok(dealt.key))
}

/// The same for every student: what `make` makes of a student's place in the set, variants and key, in the order of the
/// set and on several threads.
///
/// # Errors
/// What differs, or what `make` found: at most five findings and their number.
pub fn each<T: Send>(
    bank: &Bank,
    set: &StoredSet,
    make: &(dyn Fn(usize, &StoredStudent, Dealt) -> Result<T, Finding> + Sync),
) -> Result<Vec<T>, Findings> {
    if bank.hash != set.bank.sha256 {
        let what = format!(
            "the bank copy was changed: its SHA-256 is {}…, the set was made from {}…",
            bank.hash.get(..12).unwrap_or_default(),
            set.bank.sha256.get(..12).unwrap_or_default()
        );
        let fault = Finding::new("", what).in_file(&set.bank.file);
        return Err(fault.hint("put the original copy back, or make the set anew").into());
    }
    // Another program version is fine as long as it draws the same way and the numbers agree.
    if set.draw_version > stream::DRAW_VERSION {
        let what = format!("is {}; this program draws by version {}", set.draw_version, stream::DRAW_VERSION);
        let hint = format!("the set was made by {}: use that version, or make the set anew", set.program);
        return Err(Finding::new("draw_version", what).hint(hint).into());
    }
    let problems = indices(bank, &set.problems, "problems")?;
    let dealer = Dealer::new(bank, &problems, set.seed, &set.name);
    let earlier = is_earlier(set);
    // What `make` finds is no difference.
    let made_badly = AtomicBool::new(false);
    let one = |(i, student): (usize, &StoredStudent)| -> Result<T, Findings> {
        let by_make = |f| {
            made_badly.store(true, Ordering::Relaxed);
            Findings::from(f)
        };
        if earlier {
            let GivenSheet { variants, key } =
                given::as_stored(bank, &problems, &student.student, &student.problems)?;
            return make(i, student, Dealt { variants, key }).map_err(by_make);
        }
        if let Some(dealt) = dealer.deal_again(bank, &problems, student) {
            return make(i, student, dealt).map_err(by_make);
        }
        let undrawn =
            |none: Box<Unsatisfiable>| Finding::new(format!("problems.{}", none.problem), none.to_string());
        let dealt = dealer.deal(&student.student).map_err(undrawn)?;
        let mut faults = Findings::default();
        if student.problems.len() != problems.len() {
            let what = format!(
                "{} has {} problems, the set {}",
                student.student,
                student.problems.len(),
                problems.len()
            );
            return Err(Finding::new("students", what).into());
        }
        for ((index, variant), old) in problems.iter().zip(&dealt.variants).zip(&student.problems) {
            let new = stored(&bank.problems[*index], variant);
            if let Some(what) = difference(old, &new) {
                faults.push(Finding::new(format!("students {}, {}", student.student, old.id), what));
            }
        }
        if faults.is_empty() { make(i, student, dealt).map_err(by_make) } else { Err(faults) }
    };
    let dealt: Vec<Result<T, Findings>> = set.students.par_iter().enumerate().map(one).collect();
    let mut made = Vec::with_capacity(dealt.len());
    let mut faults = Findings::default();
    for result in dealt {
        match result {
            Ok(one) => made.push(one),
            Err(more) => faults.extend(more.into_iter().filter(|f| !faults.contains(f)).collect::<Vec<_>>()),
        }
    }
    if faults.is_empty() {
        return Ok(made);
    }
    let more = faults.len().saturating_sub(5);
    faults.truncate(5);
    if more > 0 {
        faults.push(Finding::new("", format!("and {more} more differences")));
    }
    if made_badly.into_inner() {
        return Err(faults);
    }
    let last = faults.pop();
    faults.extend(last.map(|f| {
        f.hint(format!(
            "the set was made by {} with draw version {}; seed, names or drawn data were changed since, or this program ({} {}) draws otherwise",
            set.program,
            set.draw_version,
            env!("CARGO_PKG_NAME"),
            env!("CARGO_PKG_VERSION")
        ))
    }));
    Err(faults)
}

/// What differs between the stored and the new variant.
fn difference(old: &StoredVariant, new: &StoredVariant) -> Option<String> {
    if old.id != new.id {
        return Some(format!("the problem is `{}` in the set, `{}` when drawn anew", old.id, new.id));
    }
    if old.case != new.case {
        return Some(format!("the case is `{}` in the set, `{}` when drawn anew", old.case, new.case));
    }
    let shown = |v: Option<&Value>| match v {
        Some(Value::String(text)) => format!("`{text}`"),
        Some(other) => format!("`{other}`"),
        None => "missing".to_owned(),
    };
    let names = old.data.keys().chain(new.data.keys().filter(|k| !old.data.contains_key(*k)));
    for name in names {
        if old.data.get(name) != new.data.get(name) {
            let (old, new) = (shown(old.data.get(name)), shown(new.data.get(name)));
            return Some(format!("{name} is {old} in the set, {new} when drawn anew"));
        }
    }
    None
}
