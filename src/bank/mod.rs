//! What an instructor writes: problems with their data, scenes, questions and rules, checked and ready to be drawn.
use crate::bank::decimal::Decimal;
use crate::bank::expression::Expression;
use crate::finding::Findings;
use crate::policy::Policy;
use crate::scene::{Label, Num, Scene};
use crate::solve::outcome::CheckKind;
use crate::units::{Unit, WrittenQuantity};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// How the variables of a template are found: template text in, names out, or what is wrong with the template.
pub type Variables<'a> = &'a dyn Fn(&str) -> Result<Vec<String>, Findings>;

/// Names that templates know besides the symbols of the data (what they hold: `sheet/statement.rs`).
pub const TEMPLATE_NAMES: &[&str] =
    &["value", "tex", "title", "number", "case", "count", "particles", "motion", "series", "questions"];

/// A bank, checked: every symbol is known, every unit fits, every datum is used.
#[derive(Debug, Clone)]
pub struct Bank {
    /// Id, such as `wheels-on-inclines`.
    pub id: String,
    /// Title for people.
    pub title: String,
    /// Problems in the order of the file.
    pub problems: Vec<Problem>,
    /// May students check their own answers against the sheet file?
    pub self_check: bool,
    /// May `check --reveal` show values?
    pub reveal: bool,
    /// Settings that bear on marks.
    pub grading: Policy,
    /// SHA-256 of the file's bytes, hex.
    pub hash: String,
    /// Where statements and questions stand, by field path: file, line and column.
    pub places: BTreeMap<String, (String, usize, usize)>,
}

/// One problem.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Problem {
    /// Id, such as `pulled-rolling`.
    pub id: String,
    /// Title for people.
    pub title: String,
    /// The data, in the order of the file; index = `Num::Datum`. g is the last one, always `value` drawn "always".
    pub data: Vec<Datum>,
    /// Named cases, at least one, each with its own ranges, chosen by share.
    pub cases: Vec<Case>,
    /// Questions that a set asks, in order.
    pub questions: Vec<Question>,
    /// Statement: text of the Tera template, written in the bank; `None`: the template file named after the problem.
    pub statement: Option<String>,
    /// What the figure of the statement is labelled with.
    pub figure: FigureLabels,
    /// Greatest input energy of a spring problem, in kinetic energies at the end.
    pub energy_limit: f64,
    /// Wrong methods that students take, with the way to their answers.
    pub mistakes: Vec<Mistake>,
    /// Their ids, for every key.
    pub methods: Arc<[String]>,
    /// Parts that follow from other parts.
    pub follows: Vec<Follow>,
    /// Least margins by check kind (0.1 for `moves` and so on), as shares.
    pub margins: Vec<(CheckKind, f64)>,
}

/// What the figure of a statement is labelled with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum FigureLabels {
    /// Symbols with the drawn values: `R = 0.40 m`.
    Values,
    /// Symbols alone.
    Symbols,
    /// There is no figure.
    None,
}

/// A named quantity that is drawn.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Datum {
    /// Symbol, such as `mu_s`.
    pub symbol: String,
    /// Symbol in LaTeX, such as `\mu_s`.
    pub tex: String,
    /// What it is, in words.
    pub name: String,
    /// Unit in which it is drawn and printed.
    pub unit: Unit,
    /// A slope: scenes take it in degrees. Every other datum goes to the scene in SI.
    pub degrees: bool,
    /// It is not given but found, from a measurement: the draw that is its range.
    pub unknown: Option<Draw>,
}

impl Problem {
    /// The numbers of printed values, as its scenes take them; 0 for what is not there.
    pub fn numbers(&self, values: &[Option<Decimal>]) -> Vec<f64> {
        self.data.iter().zip(values).map(|(d, value)| value.map_or(0.0, |v| d.number(v))).collect()
    }
}

impl Datum {
    /// The number of a printed value, as the scene takes it: SI, slopes in degrees. It is the nearest double.
    pub fn number(&self, value: Decimal) -> f64 {
        if self.degrees {
            self.unit.decimal_to_scene(value.value, value.decimals)
        } else {
            self.unit.decimal_to_si(value.value, value.decimals)
        }
    }
    /// The number of a quantity that was typed, as the scene takes it.
    pub fn typed(&self, quantity: &WrittenQuantity) -> f64 {
        if self.degrees { quantity.value_scene } else { quantity.value_si }
    }
}

/// How a datum is drawn. All numbers are integers in units of 10^-decimals of the printed unit: no float in the draw.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Draw {
    /// From `min` to `max` by `step`.
    Grid {
        /// Least.
        min: i64,
        /// Greatest.
        max: i64,
        /// Step, > 0.
        step: i64,
        /// Decimals.
        decimals: u8,
    },
    /// One of a list.
    OneOf {
        /// The list.
        values: Vec<i64>,
        /// Decimals.
        decimals: u8,
    },
    /// Always this.
    Always {
        /// The value.
        value: i64,
        /// Decimals.
        decimals: u8,
    },
}

/// A case: ranges, share and the scene to which they belong.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Case {
    /// Name, empty if the problem has only one.
    pub name: String,
    /// Its name in the text of the bank: of a case that is two, by whether a contact rolls or slips, the name of both.
    pub written: String,
    /// Share among the cases, > 0.
    pub share: u32,
    /// One for each datum of the problem; `None` where this case does not use it.
    pub draws: Vec<Option<Draw>>,
    /// The scene.
    pub scene: Scene,
    /// Contacts that the bank leaves open (`touches:`) and that roll or slip in this case: index of the tie, and the kinetic
    /// coefficient, which is printed either way.
    pub touches: Vec<(usize, Num)>,
    /// The same scene with other ones of these contacts rolling and slipping: what happens in a draw may not happen in them too.
    pub rivals: Vec<Scene>,
    /// Regime words that count as valid here (`moves_up`, `up ok`).
    pub regimes: Vec<String>,
    /// Bounds on answers and derived quantities.
    pub bounds: Vec<Bound>,
}

impl Case {
    /// Are its data the same in every draw?
    pub fn is_constant(&self) -> bool {
        self.draws.iter().flatten().all(|draw| draw.count() == 1)
    }
    /// The least values of its data: all there are of constants.
    pub fn least(&self) -> Vec<Option<Decimal>> {
        self.draws.iter().map(|draw| draw.as_ref().map(|d| d.range().0)).collect()
    }
}

/// A wrong method: how it comes to its answers, from a changed scene, from changed data, or from the right values.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Mistake {
    /// Id in the catalogue, such as `A05`.
    pub id: String,
    /// Data that it changes: index and the value it takes instead, in the data and the right quantities, SI (an angle in
    /// radians).
    pub data: Vec<(usize, Expression)>,
    /// The scene that it takes instead, one for each case; empty: the right one.
    pub scenes: Vec<Option<Scene>>,
    /// Quantities to which it comes by an expression, in the right data and, where it changes data or scene, the quantities of
    /// the changed solution, else the right ones.
    pub values: Vec<(Label, Expression)>,
    /// The quantities that it spoils; empty: all that come out different.
    pub of: Vec<Label>,
    /// Indices of the cases in which it is taken; empty: all.
    pub cases: Vec<usize>,
    /// Why a draw is not refused although its answer may lie near the right one.
    pub unguarded: Option<String>,
}

/// A part that follows from other parts: `v` from `omega` by `r*omega`. What a student gets by it from a wrong earlier part is
/// right in method. For each draw the relation is checked with the right values.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Follow {
    /// The part, an index into the questions.
    pub question: usize,
    /// The parts from which it follows, indices below that of the part.
    pub from: Vec<usize>,
    /// How, in the data and the quantities.
    pub by: Expression,
    /// As it is written.
    pub text: String,
}

/// A bound on an expression in symbols and quantity names, SI.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bound {
    /// As written, for the table of refusals.
    pub text: String,
    /// The expression, parsed.
    pub expression: Expression,
    /// Least, SI.
    pub min: Option<f64>,
    /// Greatest, SI.
    pub max: Option<f64>,
}

/// One question.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Question {
    /// Id of the part, such as `omega`.
    pub id: String,
    /// The quantity.
    pub label: Label,
    /// What is asked, in words, a Tera template (Markdown with `$...$`).
    pub ask: String,
    /// Unit in which the answer is asked.
    pub unit: Unit,
    /// Points.
    pub points: f64,
    /// Relative tolerance.
    pub relative: Relative,
    /// Absolute tolerance, SI; `None`: 1e-3 of the scale for quantities that may vanish, else 0.
    pub absolute: Option<f64>,
    /// Must a unit be written?
    pub unit_required: bool,
    /// Significant figures asked for, for the statement.
    pub figures: u8,
    /// A draw is refused whose answer has a greater condition number.
    pub cond_limit: f64,
    /// Wrong methods near which a draw may have this answer, each with the reason.
    pub unguarded: Vec<(String, String)>,
}

/// Relative tolerance of a question: fixed, or as wide as the condition number of the answer asks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Relative {
    /// The same for every variant, such as 0.01.
    Fixed(f64),
    /// `per_cond` times the condition number, at least `least` and at most `most`.
    Widens {
        /// Least.
        least: f64,
        /// Share for each unit of the condition number.
        per_cond: f64,
        /// Most.
        most: f64,
    },
}

impl Relative {
    /// The tolerance that `widens with cond` means: three figures on the way bring a rounding of up to some 0.3 % each, and an
    /// answer of condition number c takes c of them; 5 % still tell a right method from a wrong one.
    pub const WIDENS: Self = Self::Widens { least: 0.01, per_cond: 0.003, most: 0.05 };

    /// The tolerance of an answer with this condition number: what is printed and what is used. One that widens is rounded
    /// up to a tenth of a per cent; an infinite or unknown condition number takes the most.
    pub fn at(self, cond: f64) -> f64 {
        match self {
            Self::Fixed(share) => share,
            Self::Widens { least, per_cond, most } => {
                let tenths = (per_cond * cond * 1000.0 - ROUNDING).ceil();
                let share = tenths / 1000.0;
                if share < most { share.max(least) } else { most }
            }
        }
    }
    /// The tolerance, where it is the same for every variant.
    pub const fn fixed(self) -> Option<f64> {
        match self {
            Self::Fixed(share) => Some(share),
            Self::Widens { .. } => None,
        }
    }
    /// Condition number up to which the tolerance grows; `None` where it is fixed.
    pub fn reach(self) -> Option<f64> {
        match self {
            Self::Fixed(_) => None,
            Self::Widens { per_cond, most, .. } => Some(most / per_cond),
        }
    }
}

/// Greatest rounding error of a number of tenths of a per cent that is whole but for doubles.
const ROUNDING: f64 = 1e-6;

pub mod decimal;
pub(crate) mod draw;
pub(crate) mod expression;
pub(crate) mod measure;
pub(crate) mod need;
pub(crate) mod node;

// What reads banks. A page gets its problems as they were read.
#[cfg(feature = "program")]
pub(crate) mod any;
#[cfg(feature = "program")]
pub mod asked;
#[cfg(feature = "program")]
pub mod built_in;
#[cfg(feature = "program")]
pub mod course;
#[cfg(feature = "program")]
pub(crate) mod inverse;
#[cfg(feature = "program")]
pub mod labels;
#[cfg(feature = "program")]
pub mod load;
#[cfg(feature = "program")]
pub(crate) mod mistake;
#[cfg(feature = "program")]
pub mod overlay;
#[cfg(feature = "program")]
pub(crate) mod scene;
#[cfg(feature = "program")]
pub(crate) mod schema;
#[cfg(feature = "program")]
pub(crate) mod soundness;
#[cfg(feature = "program")]
pub(crate) mod synonyms;
#[cfg(feature = "program")]
pub mod yaml;

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "what is printed is what is used")]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_widens_in_tenths_of_a_per_cent() {
        for (cond, share) in [
            (0.0, 0.01),
            (3.3, 0.01),
            (3.34, 0.011),
            (10.0, 0.03),
            (10.01, 0.031),
            (16.6, 0.05),
            (17.0, 0.05),
            (f64::INFINITY, 0.05),
            (f64::NAN, 0.05),
        ] {
            assert_eq!(Relative::WIDENS.at(cond), share, "{cond}");
        }
        assert_eq!(Relative::Fixed(0.02).at(1e9), 0.02);
        assert!((Relative::WIDENS.reach().unwrap() - 50.0 / 3.0).abs() < 1e-12);
    }
}
