//! Statistics of a class: what is worked out, exactly how, and below which size nothing is said.
pub mod items;
pub mod ranks;
pub mod spread;

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
    /// The value.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// A number, or a sentence why there is none.
pub type Told<T> = Result<T, String>;
