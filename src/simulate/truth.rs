//! What was really done in each simulated row, and which verdict it should get.

worded! {
    /// What was done.
    #[derive(PartialOrd, Ord, Hash)]
    TrueKind {
        /// The right answer.
        Right "right",
        /// The right way, rounded on it.
        RoundedOnTheWay "rounded on the way",
        /// A known wrong method.
        WrongMethod "wrong method",
        /// The right size with the other sign.
        WrongSign "wrong sign",
        /// The right number in another unit than is said.
        UnitSlip "unit slip",
        /// A unit of another kind.
        WrongUnit "wrong unit",
        /// Off by a power of ten.
        PowerOfTen "power of ten",
        /// A slip of the hand.
        TypingError "typing error",
        /// The answer to another part.
        OtherPart "other part",
        /// Nothing.
        Blank "blank",
        /// Nothing that can be read.
        Garbage "garbage",
        /// What follows from an own wrong answer.
        Followed "followed",
        /// The answer of somebody else.
        Copied "copied",
    }
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
