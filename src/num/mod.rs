//! Arithmetic that gives the same digits everywhere: double-double numbers, enclosures, portable functions,
//! small linear systems. No mechanics.
pub mod ball;
pub mod chance;
pub mod dd;
pub mod decimal;
mod double;
pub mod eliminate;
pub mod elliptic;
pub mod formula;
pub mod gauss;
pub mod half;
pub mod jet;
pub mod lanes;
pub mod linear;
pub mod ode;
pub mod plant;
pub mod real;
pub mod root;
pub mod shares;
pub mod shown;
pub mod trig;

pub use ball::Ball;
pub use dd::Dd;
pub use jet::Jet;
pub use lanes::Lanes;
pub use real::Real;

/// What is computed quickly rather than finely: wrong methods, condition numbers, and the answers by which a page judges.
pub type Fast = f64;
/// Unit roundoff of a double, 2^-53.
pub const U: f64 = f64::EPSILON / 2.0;

/// A sum below this share of its terms is rounding of double-doubles, 2^-88: far above their 2^-104, far below the 2^-53
/// of the data.
pub const NOISE: f64 = U * U * 262_144.0;
