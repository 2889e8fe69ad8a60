//! Quantities at the borders of the program: units, dimensions, text to number and back. Inside, all is SI.
//!
//! A unit has a dimension in which the radian is an axis of its own, so that a torque and an energy may be confused (SI
//! does) but an angle and a pure number may not. The radian may be dropped: `1/s` is taken for `rad/s`.
use crate::num::decimal::nearest;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

pub(crate) mod parse;
pub mod quantity;
pub(crate) mod spell;
mod table;

pub use parse::{UnitFault, names};
pub use quantity::{QuantityFault, WrittenQuantity, parse_quantity};

/// Exponents of mass, length, time and angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Dimension(pub [i8; 4]);

impl Dimension {
    /// The word for it (`force`), if mechanics has one.
    pub fn kind(self) -> Option<&'static str> {
        table::KINDS.iter().find(|(d, _)| *d == self.0).map(|(_, word)| *word)
    }
    fn over(self, other: Dimension) -> Option<Dimension> {
        let mut out = [0i8; 4];
        for (i, o) in out.iter_mut().enumerate() {
            *o = self.0[i].checked_sub(other.0[i])?;
        }
        Some(Dimension(out))
    }
}

impl fmt::Display for Dimension {
    /// `kg m s^-2`; `1` for a pure number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (name, exponent) in ["kg", "m", "s", "rad"].iter().zip(self.0) {
            if exponent != 0 {
                write!(f, "{}{name}", if first { "" } else { " " })?;
                if exponent != 1 {
                    write!(f, "^{exponent}")?;
                }
                first = false;
            }
        }
        if first { write!(f, "1") } else { Ok(()) }
    }
}

/// An exact size in SI: `num / den * 10^ten * pi^pi`, in lowest terms, no factor ten left in `num` or `den`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct UnitScale {
    pub num: u128,
    pub den: u128,
    pub ten: i16,
    pub pi: i8,
}

impl UnitScale {
    pub(crate) const ONE: UnitScale = UnitScale { num: 1, den: 1, ten: 0, pi: 0 };
    pub(crate) fn times(self, other: UnitScale) -> Option<UnitScale> {
        let (mut num, mut den) = (self.num.checked_mul(other.num)?, self.den.checked_mul(other.den)?);
        let (mut a, mut b) = (num, den);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        num /= a;
        den /= a;
        let mut ten = self.ten.checked_add(other.ten)?;
        while num % 10 == 0 {
            num /= 10;
            ten += 1;
        }
        for (p, q) in [(10, 1), (5, 2), (2, 5)] {
            while den % p == 0 {
                den /= p;
                num = num.checked_mul(q)?;
                ten -= 1;
            }
        }
        (ten.abs() <= 300).then_some(UnitScale { num, den, ten, pi: self.pi.checked_add(other.pi)? })
    }
    pub(crate) fn inverse(self) -> Option<UnitScale> {
        UnitScale { num: self.den, den: self.num, ten: self.ten.checked_neg()?, pi: self.pi.checked_neg()? }
            .times(UnitScale::ONE)
    }
    /// Nearest double of `digits * 10^exponent * self`; for factors of pi or a denominator such as 3600 to within an ulp or two.
    pub(crate) fn apply(self, negative: bool, digits: u128, exponent: i32) -> f64 {
        let exponent = exponent + i32::from(self.ten);
        let rest = |top: u128, bottom: u128| {
            let top: f64 = decimal(top, exponent.max(0));
            let bottom: f64 = decimal(bottom, (-exponent).max(0));
            top / bottom // one rounding where both fit 53 bits
        };
        let mut size = match digits.checked_mul(self.num) {
            Some(product) if self.den == 1 => decimal(product, exponent),
            Some(product) => rest(product, self.den),
            None => decimal(digits, exponent) * (self.num as f64 / self.den as f64),
        };
        for _ in 0..self.pi {
            size *= std::f64::consts::PI;
        }
        for _ in self.pi..0 {
            size /= std::f64::consts::PI;
        }
        if negative { -size } else { size }
    }
}

/// Nearest double of `digits * 10^exponent`.
fn decimal(digits: u128, exponent: i32) -> f64 {
    if digits < 1 << 53 && (-22..=22).contains(&exponent) {
        let ten = TENS[exponent.unsigned_abs() as usize]; // both exact, so one rounding
        return if exponent < 0 { digits as f64 / ten } else { digits as f64 * ten };
    }
    nearest(&format!("{digits}e{exponent}")).unwrap_or(f64::NAN)
}

pub(crate) const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// A unit: how it is spelled, its dimension, and its size in SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Unit {
    ascii: Arc<str>,
    factors: Arc<[(Box<str>, i8)]>,
    dimension: Dimension,
    scale: UnitScale,
    factor: f64,
}

impl Unit {
    /// Reads a unit: `m/s^2`, `N·m`, `kg m²`, `rev/min`, `°`, `%`, `1`. Upper and lower case matter.
    ///
    /// ```
    /// use slipstick::units::Unit;
    /// assert_eq!(Unit::parse("km/h").unwrap().to_si(36.0), 10.0);
    /// assert_eq!(Unit::parse("m s⁻²").unwrap().ascii(), "m/s^2");
    /// ```
    ///
    /// # Errors
    /// Says at which column what is wrong.
    pub fn parse(text: &str) -> Result<Unit, UnitFault> {
        parse::unit(text, false).map(|(unit, _)| unit)
    }
    /// As `parse`, but a wrong case is forgiven where only one unit can be meant; `true` says that this was needed.
    /// Errors: says at which column what is wrong.
    pub fn parse_any_case(text: &str) -> Result<(Unit, bool), UnitFault> {
        parse::unit(text, true)
    }
    /// The pure number, `1`.
    pub fn one() -> Unit {
        Unit::build(Vec::new(), Dimension([0; 4]), UnitScale::ONE)
    }
    pub(crate) fn build(factors: Vec<(Box<str>, i8)>, dimension: Dimension, scale: UnitScale) -> Unit {
        let ascii = spelled(&factors, "1", " ", |name, exponent| match exponent {
            1 => name.to_owned(),
            e => format!("{name}^{e}"),
        });
        let factor = scale.apply(false, 1, 0);
        Unit { ascii: ascii.into(), factors: factors.into(), dimension, scale, factor }
    }
    /// In SI; angles in rad.
    #[inline]
    pub fn to_si(&self, value: f64) -> f64 {
        match self.ten() {
            Some(ten @ 0..) => value * TENS[ten as usize],
            Some(ten) => value / TENS[usize::from(ten.unsigned_abs())],
            None => value * self.factor,
        }
    }
    /// From SI into this unit.
    #[inline]
    pub fn from_si(&self, value: f64) -> f64 {
        match self.ten() {
            Some(ten @ 0..) => value / TENS[ten as usize],
            Some(ten) => value * TENS[usize::from(ten.unsigned_abs())],
            None => value / self.factor,
        }
    }
    /// `to_si(x)` is `x * times / over`, to the last bit.
    #[cfg(feature = "program")]
    pub(crate) fn times_over(&self) -> (f64, f64) {
        match self.ten() {
            Some(ten @ 0..) => (TENS[ten as usize], 1.0),
            Some(ten) => (1.0, TENS[usize::from(ten.unsigned_abs())]),
            None => (self.factor, 1.0),
        }
    }
    /// The power of ten, if it is nothing else and an exact double.
    #[inline]
    fn ten(&self) -> Option<i16> {
        let s = &self.scale;
        (s.num == 1 && s.den == 1 && s.pi == 0 && s.ten.abs() <= 22).then_some(s.ten)
    }
    /// The double nearest to `int * 10^-decimals` of this unit in SI (angles: in rad, within two ulp). `200 mm` is 0.2.
    pub fn decimal_to_si(&self, int: i64, decimals: u8) -> f64 {
        self.scale.apply(int < 0, u128::from(int.unsigned_abs()), -i32::from(decimals))
    }
    /// As the data of a scene are held: angles in degrees, everything else in SI; the nearest double.
    pub fn decimal_to_scene(&self, int: i64, decimals: u8) -> f64 {
        self.scene_scale().apply(int < 0, u128::from(int.unsigned_abs()), -i32::from(decimals))
    }
    /// SI, but degrees for an angle.
    pub(crate) fn scene_scale(&self) -> UnitScale {
        if self.is_angle() {
            let degrees = UnitScale { num: 18, den: 1, ten: 1, pi: -1 };
            return self.scale.times(degrees).unwrap_or(self.scale);
        }
        self.scale
    }
    pub(crate) fn scale(&self) -> UnitScale {
        self.scale
    }
    /// Is it an angle, and nothing else?
    fn is_angle(&self) -> bool {
        self.dimension.0 == [0, 0, 0, 1]
    }
    /// Is it a pure number (`1`, `%`)?
    pub fn is_number(&self) -> bool {
        self.dimension.0 == [0; 4]
    }
    /// The dimension.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }
    /// In ASCII, as in key.csv and sheet.json: `m/s^2`, `deg`, `N m`, `1`. `parse` reads it back.
    pub fn ascii(&self) -> &str {
        &self.ascii
    }
    /// In LaTeX, without the dollars: `\mathrm{m}/\mathrm{s}^{2}`, `^\circ`, `\%`; empty for `1`.
    pub fn tex(&self) -> String {
        if self.factors.is_empty() {
            return String::new();
        }
        spelled(&self.factors, "1", r"\,", |name, exponent| {
            let symbol = match name {
                "deg" => r"{}^\circ".to_owned(),
                "%" => r"\%".to_owned(),
                "um" | "us" | "ug" | "uN" | "uJ" | "urad" => format!(r"\mathrm{{\mu {}}}", &name[1..]),
                _ => format!(r"\mathrm{{{name}}}"),
            };
            if exponent == 1 { symbol } else { format!("{symbol}^{{{exponent}}}") }
        })
    }
    /// In HTML: `m/s<sup>2</sup>`, `°`, `N·m`; empty for `1`.
    pub fn html(&self) -> String {
        if self.factors.is_empty() {
            return String::new();
        }
        spelled(&self.factors, "1", "·", |name, exponent| {
            let symbol = if name == "deg" { "°" } else { name };
            let symbol = match symbol.strip_prefix('u') {
                Some(rest) => format!("µ{rest}"),
                None => symbol.to_owned(),
            };
            if exponent == 1 { symbol } else { format!("{symbol}<sup>{exponent}</sup>") }
        })
    }
    /// A value with this unit in LaTeX, without the dollars: `40\ \mathrm{kg}`, `30^\circ`, `0.55`.
    pub fn tex_with(&self, value: &str) -> String {
        match self.ascii() {
            "1" => value.to_owned(),
            "deg" => format!(r"{value}^\circ"),
            _ => format!(r"{value}\ {}", self.tex()),
        }
    }
    /// A value with this unit as plain ASCII text: `40 kg`, `30 deg`, `0.55`.
    pub fn text_with(&self, value: &str) -> String {
        match self.ascii() {
            "1" => value.to_owned(),
            unit => format!("{value} {unit}"),
        }
    }
    /// May a quantity in `other` be converted to this unit? The radian may be dropped (`1/s` for `rad/s`), a degree not.
    pub fn agrees(&self, other: &Unit) -> bool {
        let (mine, other_angle) = (self.dimension.0, other.dimension.0[3]);
        if mine[..3] != other.dimension.0[..3] {
            return false;
        }
        if mine[3] == other_angle {
            return true;
        }
        if mine[3] != 0 && other_angle != 0 {
            return false;
        }
        mine[..3] != [0; 3] || (self.scale.pi == 0 && other.scale.pi == 0)
    }
    /// How many of the other it is, from the exact scales: 3.6 km/h to a m/s.
    #[cfg(feature = "program")]
    pub(crate) fn per(&self, other: &Unit) -> f64 {
        let ratio = other.scale.inverse().and_then(|inverse| self.scale.times(inverse));
        ratio.map_or_else(|| other.from_si(self.to_si(1.0)), |ratio| ratio.apply(false, 1, 0))
    }
    /// Is it a power of ten of the other?
    pub(crate) fn by_tens(&self, other: &Unit) -> bool {
        let ratio = other.scale.inverse().and_then(|inverse| self.scale.times(inverse));
        ratio.is_some_and(|r| (r.num, r.den, r.pi) == (1, 1, 0))
    }
    /// `1/min` where an angular velocity is asked: turns in that time, as engineers write it. `1/s` is `rad/s`.
    pub(crate) fn counts_turns(&self, asked: &Unit) -> bool {
        let per_second = self.scale.num == 1 && self.scale.den == 1;
        asked.dimension.0 == [0, 0, -1, 1] && self.dimension.0 == [0, 0, -1, 0] && !per_second
    }
    /// What is wrong with `found` where this unit is expected, with the missing factor if a single one is missing:
    /// `expected N m (energy or moment), found N (force): a factor m is missing`.
    pub fn mismatch(&self, found: &Unit) -> String {
        let named = |u: &Unit| match u.kind() {
            UnitKind::Named(kind) => format!("{} ({kind})", u.ascii),
            UnitKind::Dimension(dimension) => format!("{} ({dimension})", u.ascii),
            UnitKind::Itself => u.ascii.to_string(),
        };
        let mut text = format!("expected {}, found {}", named(self), named(found));
        match self.slip(found) {
            Some(UnitSlip::PoundIsMass) => text.push_str(": lb is a mass here; write lbf"),
            Some(UnitSlip::Millisecond) => text.push_str(": ms is a millisecond; write m/s or m s^-1"),
            Some(UnitSlip::Missing(name)) => text.push_str(&format!(": a factor {name} is missing")),
            Some(UnitSlip::TooMany(name)) => text.push_str(&format!(": a factor {name} too many")),
            None => {}
        }
        text
    }
    /// What kind of unit it is.
    pub fn kind(&self) -> UnitKind {
        match self.dimension.kind() {
            Some(kind) => UnitKind::Named(kind),
            None if self.dimension.to_string() == *self.ascii => UnitKind::Itself,
            None => UnitKind::Dimension(self.dimension),
        }
    }
    /// What may have gone wrong where `found` stands and this unit is expected.
    pub fn slip(&self, found: &Unit) -> Option<UnitSlip> {
        match (self.dimension.kind(), found.ascii()) {
            (Some("force"), "lb") => return Some(UnitSlip::PoundIsMass),
            _ if found.ascii.contains("ms") && self.ascii.contains('m') => {
                return Some(UnitSlip::Millisecond);
            }
            _ => {}
        }
        let ratio = self.dimension.over(found.dimension)?;
        let back = found.dimension.over(self.dimension)?;
        table::SINGLE.iter().find_map(|name| {
            let d = Unit::parse(name).ok()?.dimension;
            if d == ratio {
                Some(UnitSlip::Missing(name))
            } else if d == back {
                Some(UnitSlip::TooMany(name))
            } else {
                None
            }
        })
    }
}

/// What kind of quantity a unit belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitKind {
    /// One that mechanics has a word for, such as `force`.
    Named(&'static str),
    /// One that has none, told by its dimension.
    Dimension(Dimension),
    /// The unit says it itself.
    Itself,
}

/// What may have gone wrong with a unit of another kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitSlip {
    /// `lb` where a force is expected.
    PoundIsMass,
    /// `ms` where metres per second may be meant.
    Millisecond,
    /// This single factor is missing.
    Missing(&'static str),
    /// This single factor is too many.
    TooMany(&'static str),
}

/// The words for kinds of quantities.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    table::KINDS.iter().map(|(_, word)| *word)
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.ascii)
    }
}

/// Factors with positive exponents, then one slash before each with a negative one.
fn spelled(
    factors: &[(Box<str>, i8)],
    one: &str,
    between: &str,
    write: impl Fn(&str, i8) -> String,
) -> String {
    let above: Vec<String> = factors.iter().filter(|(_, e)| *e > 0).map(|(n, e)| write(n, *e)).collect();
    let mut text = if above.is_empty() { one.to_owned() } else { above.join(between) };
    for (name, exponent) in factors.iter().filter(|(_, e)| *e < 0) {
        text.push('/');
        text.push_str(&write(name, exponent.saturating_neg()));
    }
    text
}
