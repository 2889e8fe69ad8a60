//! The verdicts.
use std::borrow::Cow;
use std::fmt;

macro_rules! verdicts {
    ($($variant:ident $name:literal $doc:literal;)*) => {
        /// What becomes of a cell.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Verdict { $(#[doc = $doc] $variant,)* }
        impl Verdict {
            /// All, in the order in which summaries list them.
            pub const ALL: &'static [Verdict] = &[$(Verdict::$variant,)*];
            /// Lower case, with spaces.
            pub const fn as_str(self) -> &'static str { match self { $(Verdict::$variant => $name,)* } }
        }
    };
}
verdicts! {
    Right "right" "Within the tolerance.";
    Wrong "wrong" "Not within the tolerance.";
    WrongDirection "wrong direction" "Right magnitude, other sign or word.";
    WrongDimension "wrong dimension" "The unit is of another kind.";
    MissingUnit "missing unit" "A unit is demanded.";
    Unreadable "unreadable" "Neither right nor wrong: it cannot be read.";
    Blank "blank" "Nothing written.";
    UnknownStudent "unknown student" "Not on the roster.";
    UnknownPart "unknown part" "No such part on the sheet.";
    Superseded "superseded" "Another attempt counts.";
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
}
