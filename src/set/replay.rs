//! Drawing a stored set again to see that nothing has changed.
use crate::bank::Bank;
use crate::draw::stream;
use crate::finding::{Finding, Findings, FirstFindings, push_new};
use crate::key::{FindWrong, SheetKey, WrongValue};
use crate::problem::maker::Unsatisfiable;
use crate::set::dealer::{Dealer, Dealt, indices, stored};
use crate::set::given;
use crate::set::store::{StoredSet, StoredStudent};
use rayon::prelude::*;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

/// Was the set drawn by an earlier version, which chose other draws? Then nothing is drawn again: what was drawn is taken as it
/// is stored, and so is the key ([`crate::set::key_file::put_stored`]).
pub fn is_earlier(set: &StoredSet) -> bool {
    set.draw_version < stream::DRAW_VERSION
}

/// Draws and solves a stored set again. The keys are returned only if the bank copy and every drawn number are the
/// stored ones. Errors: what differs: at most five findings and their number.
pub fn keys(bank: &Bank, set: &StoredSet) -> Result<Vec<SheetKey>, Findings> {
    each(bank, set, &|_, _, dealt| Ok(dealt.key))
}

/// The keys of a stored set by the first road alone: unproved, and without wrong methods ([`WrongOnDemand`]). `None` where the set
/// was not drawn by this version or anything differs, or where the first road does not say all; [`keys`] then tells what.
pub fn by_first_road(bank: &Bank, set: &StoredSet) -> Option<Vec<SheetKey>> {
    if bank.hash != set.bank.sha256 || set.draw_version != stream::DRAW_VERSION {
        return None;
    }
    let problems = indices(bank, &set.problems, "problems").ok()?;
    let dealer = Dealer::new(bank, &problems, set.seed, &set.name);
    let one = |student: &StoredStudent| {
        let key = dealer.by_first_road(student)?.key;
        let said = key.problems.iter().all(|p| p.known.iter().all(|x| !x.is_nan()));
        said.then_some(key)
    };
    set.students.par_iter().map(one).collect()
}

/// Where wrong methods come to in a set that was replayed by the first road: found when it is first asked, for most students'
/// answers are right.
pub struct WrongOnDemand<'b> {
    dealer: Dealer<'b>,
    set: &'b StoredSet,
    found: Vec<OnceLock<Vec<Vec<WrongValue>>>>,
}

impl<'b> WrongOnDemand<'b> {
    /// Nothing is found yet. Errors: the bank has not the problems of the set.
    pub fn new(bank: &'b Bank, set: &'b StoredSet) -> Result<Self, Findings> {
        let problems = indices(bank, &set.problems, "problems")?;
        let dealer = Dealer::new(bank, &problems, set.seed, &set.name);
        let found = std::iter::repeat_with(OnceLock::new).take(set.students.len() * problems.len());
        Ok(Self { dealer, set, found: found.collect() })
    }
}

impl FindWrong for WrongOnDemand<'_> {
    fn values(&self, student: usize, problem: usize) -> &[Vec<WrongValue>] {
        let at = student * self.set.problems.len() + problem;
        let find = || self.dealer.wrong_values(&self.set.students[student], problem).unwrap_or_default();
        self.found[at].get_or_init(find)
    }
}

/// The same for every student: what `make` makes of a student's place in the set, variants and key, in the order of the
/// set and on several threads. Errors: what differs, or what `make` found: at most five findings and their number.
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
            let dealt = given::as_stored(bank, &problems, student)?;
            return make(i, student, dealt).map_err(by_make);
        }
        if let Some(dealt) = dealer.deal_again(student) {
            return make(i, student, dealt).map_err(by_make);
        }
        let undrawn =
            |none: Box<Unsatisfiable>| Finding::new(format!("problems.{}", none.problem), none.to_string());
        let dealt = dealer.deal(&student.student).map_err(undrawn)?;
        let mut faults = Findings::default();
        if student.problems.len() != problems.len() {
            let (name, own) = (&student.student, student.problems.len());
            let what = format!("{name} has {own} problems, the set {}", problems.len());
            return Err(Finding::new("students", what).into());
        }
        for (i, (index, old)) in problems.iter().zip(&student.problems).enumerate() {
            let new = stored(&bank.problems[*index], &dealt.variants[i]);
            if let Some(mut what) = old.difference(&new) {
                if let Some(why) = dealer.refusal(student, i) {
                    what = format!("{what}; the draw of the set is refused now: {why}");
                }
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
            Err(more) => more.into_iter().for_each(|fault| push_new(&mut faults, fault)),
        }
    }
    if faults.is_empty() {
        return Ok(made);
    }
    let mut first = FirstFindings::default();
    faults.into_iter().for_each(|fault| first.push(fault));
    let mut faults = first.told();
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
