//! Why a derivation stops: what it does not cover, told in every language, or a fault.
use crate::finding::Finding;
use crate::scene::Quantity;
use crate::words::Words;
use std::fmt;

/// Why a derivation stops.
#[derive(Debug, Clone, PartialEq)]
pub enum DerivationStop {
    /// It does not cover this: the key stands, and the page says so.
    Beyond(Beyond),
    /// Something is wrong: nothing is printed.
    Fault(Finding),
}

impl fmt::Display for DerivationStop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Beyond(what) => {
                write!(f, "the worked solution does not cover {}", what.text(&Words::english()))
            }
            Self::Fault(fault) => write!(f, "{fault}"),
        }
    }
}

impl From<Finding> for DerivationStop {
    fn from(fault: Finding) -> Self {
        Self::Fault(fault)
    }
}

impl From<Beyond> for DerivationStop {
    fn from(what: Beyond) -> Self {
        Self::Beyond(what)
    }
}

macro_rules! beyond {
    ($($variant:ident $name:literal;)*) => {
        /// What the derivations do not cover; in words: `solution.beyond.NAME`.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Beyond {
            $(#[doc = concat!("`", $name, "`")] $variant,)*
            /// A quantity that they do not find.
            Quantity(Quantity),
            /// A quantity of which they find another value than the key: a fault of a derivation.
            Differs(Quantity),
        }
        impl Beyond {
            /// All but the quantities.
            pub const ALL: &'static [Beyond] = &[$(Beyond::$variant,)*];
            const fn name(self) -> &'static str {
                match self {
                    $(Beyond::$variant => $name,)*
                    Beyond::Quantity(_) => "quantity",
                    Beyond::Differs(_) => "differs",
                }
            }
        }
    };
}
beyond! {
    Any "any";
    Found "found";
    Arrangement "arrangement";
    BehindTurning "behind_turning";
    CannotRoll "cannot_roll";
    CordsLock "cords_lock";
    EndBySpin "end_by_spin";
    FastestSlack "fastest_slack";
    FrictionWithSlip "friction_with_slip";
    GrowingForce "growing_force";
    HeldFast "held_fast";
    JoinedBodies "joined_bodies";
    LaminaInCompany "lamina_in_company";
    LaminaWithoutMotion "lamina_without_motion";
    LooseSpin "loose_spin";
    NeverFastest "never_fastest";
    NeverRolls "never_rolls";
    NeverTurns "never_turns";
    NoAngle "no_angle";
    NoBound "no_bound";
    NotThere "not_there";
    NothingMoves "nothing_moves";
    OtherEnd "other_end";
    PinAtCentre "pin_at_centre";
    PinnedEnd "pinned_end";
    RollsAfterAll "rolls_after_all";
    SeveralEquations "several_equations";
    SeveralSlips "several_slips";
    SeveralSpeeds "several_speeds";
    SlackCord "slack_cord";
    SlipInCompany "slip_in_company";
    SlipWithSpeed "slip_with_speed";
    SlipsAfterAll "slips_after_all";
    SpringTime "spring_time";
    SpringWithSpeed "spring_with_speed";
    SpringWithoutPlace "spring_without_place";
    ThrownVertically "thrown_vertically";
    ThrownWithoutInertia "thrown_without_inertia";
    ThrownWithoutSlip "thrown_without_slip";
    Unfound "unfound";
    Untied "untied";
    WoundOnSlipping "wound_on_slipping";
}

impl Beyond {
    /// Is it a fault of this program, worth reporting?
    pub const fn is_fault(self) -> bool {
        matches!(self, Self::Differs(_))
    }

    /// In words: `a slipping wheel with other bodies`.
    pub fn text(self, words: &Words) -> String {
        let name = match self {
            Self::Quantity(q) | Self::Differs(q) => {
                let way = words.get("solution.way.forward");
                words.say(&format!("solution.name.{}", q.name()), &[("way", way)])
            }
            _ => String::new(),
        };
        words.say(&format!("solution.beyond.{}", self.name()), &[("name", &name)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_not_covered_has_words() {
        for words in Words::languages().filter_map(Words::of) {
            for what in Beyond::ALL
                .iter()
                .copied()
                .chain([Beyond::Quantity(Quantity::V), Beyond::Differs(Quantity::V)])
            {
                assert!(what.text(&words).len() > 9, "{what:?}");
            }
        }
    }
}
