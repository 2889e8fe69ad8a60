//! What the sweeps beyond doubles share: numbers of 700 bits, and dice over powers of ten.
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A number of [`BITS`] bits.
pub type F = FBig<HalfEven, 2>;
/// Bits of every number of the formulas.
pub const BITS: usize = 700;

/// A double, exactly.
pub fn big(x: f64) -> F {
    F::try_from(x).unwrap().with_precision(BITS).value()
}
/// The nearest double.
pub fn double(x: &F) -> f64 {
    x.to_f64().value()
}
/// Absolute value.
pub fn abs(x: &F) -> F {
    if *x < F::ZERO { -x.clone() } else { x.clone() }
}

/// Draws of data.
pub struct Dice(ChaCha20Rng);
impl Dice {
    /// The same draws for the same seed.
    pub fn new(seed: u64) -> Self {
        Self(ChaCha20Rng::seed_from_u64(seed))
    }
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }
    /// Uniform from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    /// 10 to a power that is uniform between two.
    pub fn log(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(low + (high - low) * self.unit())
    }
    /// Below `n`.
    pub fn pick(&mut self, n: u64) -> u64 {
        self.bits() % n
    }
    /// True once in `n` times.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.pick(n) == 0
    }
}
