//! What was really done in each simulated row, and which verdict it should get.

macro_rules! kinds {
    ($($variant:ident $name:literal;)*) => {
        /// What was done.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum TrueKind { $(#[doc = $name] $variant,)* }
        impl TrueKind {
            /// All.
            pub const ALL: &'static [TrueKind] = &[$(TrueKind::$variant,)*];
            /// In words.
            pub const fn name(self) -> &'static str { match self { $(TrueKind::$variant => $name,)* } }
        }
    };
}
kinds! {
    Right "right";
    RoundedOnTheWay "rounded on the way";
    WrongMethod "wrong method";
    WrongSign "wrong sign";
    UnitSlip "unit slip";
    WrongUnit "wrong unit";
    PowerOfTen "power of ten";
    TypingError "typing error";
    OtherPart "other part";
    Blank "blank";
    Garbage "garbage";
    Followed "followed";
    Copied "copied";
}

impl TrueKind {
    /// Those that a file of habits declares; the others come of other habits.
    pub const DECLARED: &'static [TrueKind] = TrueKind::ALL.split_at(TrueKind::ALL.len() - 2).0;

    /// Should it be marked right, whatever number came out?
    pub const fn deserves(self) -> bool {
        matches!(self, TrueKind::Right | TrueKind::RoundedOnTheWay)
    }
}

/// Columns of the truth: line in the submissions; student, number of the problem, part, attempt from 1; the answer as written;
/// what was done; id of the wrong method; figures of the answer, or on the way where it was rounded there; student or part that
/// the number is from; should it be marked right (`yes`, `no`); verdict that the grader's rules give to the number as written.
pub const HEADER: [&str; 12] = [
    "line", "student", "problem", "part", "attempt", "answer", "kind", "method", "figures", "from", "right",
    "verdict",
];

/// What was done in one row.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// What was done.
    pub kind: TrueKind,
    /// Id of the wrong method; empty if there is none.
    pub method: String,
    /// Significant figures of the answer, of what was rounded on the way where it was; `None` for what is no number.
    pub figures: Option<u32>,
    /// The student or the part that the number is from; empty if it is from none.
    pub from: String,
    /// Should it be marked right?
    pub right: bool,
    /// The verdict that the number as written gets, in the words of grading.
    pub verdict: &'static str,
}
