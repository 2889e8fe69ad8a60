//! The lots of a made-up class: one stream for each student, so that a late joiner changes nobody else's answers.
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha20Rng;

/// A stream of lots.
#[derive(Debug, Clone)]
pub struct Chance(ChaCha20Rng);

impl Chance {
    /// Stream number `stream` of a seed.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut rng = ChaCha20Rng::seed_from_u64(seed);
        rng.set_stream(stream);
        Self(rng)
    }
    /// The stream of a student.
    pub fn of(seed: u64, student: &str) -> Self {
        // FNV-1a; stream 0 is the class's own.
        let hash = student
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3));
        Self::new(seed, hash.max(1))
    }
    /// A share, `0 <= share < 1`.
    pub fn share(&mut self) -> f64 {
        const STEPS: u32 = 1 << 30;
        f64::from(self.0.random_range(0..STEPS)) / f64::from(STEPS)
    }
    /// True in this share of the cases.
    pub fn meets(&mut self, share: f64) -> bool {
        self.share() < share
    }
    /// A whole number below `n`; 0 for an `n` of 0.
    pub fn below(&mut self, n: usize) -> usize {
        let n = u32::try_from(n).unwrap_or(u32::MAX).max(1);
        usize::try_from(self.0.random_range(0..n)).unwrap_or(0)
    }
}
