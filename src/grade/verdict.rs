//! The verdicts.
use std::borrow::Cow;
use std::fmt;

worded! {
    /// What becomes of a cell.
    #[derive(PartialOrd, Ord, Hash, Default)]
    Verdict {
        /// Within the tolerance.
        Right "right",
        /// Not within the tolerance.
        Wrong "wrong",
        /// Right magnitude, other sign or word.
        WrongDirection "wrong direction",
        /// The unit is of another kind.
        WrongDimension "wrong dimension",
        /// A unit is demanded.
        MissingUnit "missing unit",
        /// Neither right nor wrong: it cannot be read.
        Unreadable "unreadable",
        /// Nothing written.
        #[default]
        Blank "blank",
        /// Not on the roster.
        UnknownStudent "unknown student",
        /// No such part on the sheet.
        UnknownPart "unknown part",
        /// Another attempt counts.
        Superseded "superseded",
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A verdict, its points and the reason in words. The reason never tells the value of the key.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement<'w> {
    /// The verdict.
    pub verdict: Verdict,
    /// Points earned.
    pub points: f64,
    /// Why, in words.
    pub reason: Cow<'w, str>,
    /// The number that was judged, SI with its sign; NaN where no number was compared.
    pub number: f64,
}
