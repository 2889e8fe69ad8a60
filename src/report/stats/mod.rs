//! Statistics of a class: what is worked out, exactly how, and below which size nothing is said.
pub mod items;
pub mod ranks;
pub mod spread;

use crate::words::Words;

/// A correlation, a reliability, a comparison needs at least so many students: with fewer the 95 % interval of a correlation
/// of 0 is wider than -0.44 to 0.44, so that hardly any value would say anything.
pub const LEAST_FOR_CORRELATION: usize = 20;
/// A share in per cent needs at least so many answers; with fewer the counts themselves are told.
pub const LEAST_FOR_SHARE: usize = 5;
/// A median of waiting times needs at least so many.
pub const LEAST_FOR_MEDIAN: usize = 5;
/// Each group needs at least so many for the comparison of groups: the chi-squared distribution of the Kruskal-Wallis statistic
/// is an approximation that is good from 5 on (Kruskal and Wallis 1952).
pub const LEAST_IN_GROUP: usize = 5;

/// A value with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// Why there is no such number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoStatistic {
    /// Fewer students than [`LEAST_FOR_CORRELATION`]: so many.
    TooFew(usize),
    /// There is nothing to correlate a part with.
    OnePart,
    /// The points of a part, or of all others, do not vary.
    AllAlike,
    /// Fewer than two parts vary.
    FewParts,
    /// The totals do not vary.
    EqualTotals,
    /// Not everybody was asked this part.
    NotAll,
}

impl NoStatistic {
    /// The reason in words.
    pub fn say(self, words: &Words) -> String {
        let least = LEAST_FOR_CORRELATION.to_string();
        let name = match self {
            Self::TooFew(1) => return words.say("report.why.too_few_one", &[("least", &least)]),
            Self::TooFew(n) => {
                return words.say("report.why.too_few", &[("n", &n.to_string()), ("least", &least)]);
            }
            Self::OnePart => "one_part",
            Self::AllAlike => "all_alike",
            Self::FewParts => "few_parts",
            Self::EqualTotals => "equal_totals",
            Self::NotAll => "not_all",
        };
        words.get(&format!("report.why.{name}")).to_owned()
    }
}
