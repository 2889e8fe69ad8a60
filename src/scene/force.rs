//! Forces that no body and no tie brings with it.
use crate::scene::Num;

/// A couple of constant moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Couple {
    /// Index of the body.
    pub body: usize,
    /// Moment, N m, >= 0.
    pub moment_n_m: Num,
    /// True: in the sense of rolling forward.
    pub forward: bool,
}
