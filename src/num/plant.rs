//! Planted errors, so that tests can prove that the agreement of two roads catches each of them.
//!
//! A road writes each of its mechanical terms as `plant!("road: what it is", expression)`. In the program that is the
//! expression and nothing else. In the unit tests one named term at a time can be spoiled.

#[cfg(test)]
thread_local! {
    static SPOILED: std::cell::RefCell<Option<(String, f64)>> = const { std::cell::RefCell::new(None) };
    static SEEN: std::cell::RefCell<std::collections::BTreeSet<&'static str>> =
        const { std::cell::RefCell::new(std::collections::BTreeSet::new()) };
}

/// The factor by which the term of this name is spoiled now.
#[cfg(test)]
pub fn factor(name: &'static str) -> Option<f64> {
    SEEN.with(|s| s.borrow_mut().insert(name));
    SPOILED.with(|s| s.borrow().as_ref().filter(|(n, _)| n == name).map(|(_, f)| *f))
}

/// Spoils the term of this name by a factor while `work` runs.
#[cfg(test)]
pub fn spoiled<R>(name: &str, by: f64, work: impl FnOnce() -> R) -> R {
    SPOILED.with(|s| *s.borrow_mut() = Some((name.to_owned(), by)));
    let r = work();
    SPOILED.with(|s| *s.borrow_mut() = None);
    r
}

/// The names of all terms that this thread has evaluated.
#[cfg(test)]
pub fn seen() -> Vec<&'static str> {
    SEEN.with(|s| s.borrow().iter().copied().collect())
}

/// Names a mechanical term: the expression itself, save in tests that spoil it.
macro_rules! plant {
    ($name:literal, $value:expr) => {{
        #[cfg(test)]
        {
            let value = $value;
            match $crate::num::plant::factor($name) {
                Some(f) => value * <_ as $crate::num::Real>::of(f),
                None => value,
            }
        }
        #[cfg(not(test))]
        {
            $value
        }
    }};
}
pub(crate) use plant;
