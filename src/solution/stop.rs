//! Why a derivation stops: what it does not cover, told in every language, or a fault.
use crate::finding::Finding;
use crate::num::gauss;
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

impl From<gauss::Unsettled> for DerivationStop {
    fn from(_: gauss::Unsettled) -> Self {
        Self::Beyond(Beyond::Unfound)
    }
}

impl From<Beyond> for DerivationStop {
    fn from(what: Beyond) -> Self {
        Self::Beyond(what)
    }
}

/// Something does not come out.
pub fn unfound<T>() -> Result<T, DerivationStop> {
    Err(Beyond::Unfound.into())
}

/// What the derivations do not cover; in words: `solution.beyond.NAME`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beyond {
    /// A force that grows on bodies of several freedoms.
    GrowingForce,
    /// A mechanism that is not placed, or not looked through.
    Mechanism,
    /// A part that is taken away.
    Removed,
    /// An instant of several freedoms that have speeds.
    Speeds,
    /// What a motion that follows takes over.
    Next,
    /// A motion in phases, in which contacts come to rest one after the other.
    Phases,
    /// One of several springs whose cord goes slack on the way.
    Slack,
    /// A spring that pulls at an instant what rubs, or where several motions are free.
    SpringAtOnce,
    /// Something that does not come out.
    Unfound,
    /// A quantity that they do not find.
    Quantity(Quantity),
    /// A quantity of which they find another value than the key: a fault of a derivation.
    Differs(Quantity),
}

impl Beyond {
    /// Is it a fault of this program, worth reporting?
    pub const fn is_fault(self) -> bool {
        matches!(self, Self::Differs(_))
    }

    /// In words: `a slipping wheel with other bodies`.
    pub fn text(self, words: &Words) -> String {
        let (what, quantity) = match self {
            Self::GrowingForce => ("growing_force", None),
            Self::Mechanism => ("mechanism", None),
            Self::Removed => ("removed", None),
            Self::Speeds => ("speeds", None),
            Self::Next => ("next", None),
            Self::Phases => ("phases", None),
            Self::Slack => ("slack", None),
            Self::SpringAtOnce => ("spring_at_once", None),
            Self::Unfound => ("unfound", None),
            Self::Quantity(q) => ("quantity", Some(q)),
            Self::Differs(q) => ("differs", Some(q)),
        };
        let way = [("way", words.get("solution.way.forward"))];
        let name = quantity.map(|q| words.say(&format!("solution.name.{}", q.name()), &way));
        words.say(&format!("solution.beyond.{what}"), &[("name", &name.unwrap_or_default())])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_not_covered_has_words() {
        for words in Words::languages().filter_map(Words::of) {
            let alone = [
                Beyond::GrowingForce,
                Beyond::Mechanism,
                Beyond::Removed,
                Beyond::Speeds,
                Beyond::Next,
                Beyond::Phases,
                Beyond::Slack,
                Beyond::SpringAtOnce,
                Beyond::Unfound,
            ];
            for what in alone.into_iter().chain([Beyond::Quantity(Quantity::V), Beyond::Differs(Quantity::V)])
            {
                assert!(what.text(&words).len() > 9, "{what:?}");
            }
        }
    }
}
