//! Seeds to independent streams of random words.
//!
//! Draw version 5: the key of a variant is HMAC-SHA256 with the key `slipstick draw 4` of the seed (u64, little endian)
//! and then, each after its length in bytes (u64, little endian), the set's name, the problem's id and the student's id.
//! With this key and nonce = number of the try (1, 2, ...), ChaCha20 gives 64-bit words (two 32-bit words, the first one
//! low). Word 0 of try 1 chooses the case; datum number i (from 0) takes word i + 1 of each try. Data that are added at the
//! end of a problem therefore never move the others, and a try costs one block. A word that would favour some value is
//! dropped; the next one in its place is the same word of the same try with 2^32 added to the nonce, and so on.
use hmac::{Hmac, KeyInit, Mac};
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sha2::Sha256;

/// Version of the draw: if a pinned draw changes, this number changes. Version 2 refuses draws with an ill-conditioned answer,
/// version 3 those in which a wrong method lands near a right answer; with version 4 no range of a built-in bank tells a word;
/// version 5 refuses draws in which one of the wrong methods that the built-in banks have learnt since lands near a right
/// answer. The streams are those of version 4: a draw that no new method refuses is the same.
pub const DRAW_VERSION: u32 = 5;

/// Named after the version that began these streams.
const DOMAIN: &[u8] = b"slipstick draw 4";

/// Keys of the variants of one problem of one set.
#[derive(Clone)]
pub struct Source {
    mac: Hmac<Sha256>,
}

impl Source {
    /// The source of one problem of one set.
    ///
    /// # Panics
    /// Never: HMAC takes a key of any length.
    pub fn new(seed: u64, set: &str, problem: &str) -> Self {
        let mut mac = Hmac::<Sha256>::new_from_slice(DOMAIN).expect("HMAC takes a key of any length");
        mac.update(&seed.to_le_bytes());
        let mut source = Self { mac };
        source.part(set);
        source.part(problem);
        source
    }
    fn part(&mut self, text: &str) {
        self.mac.update(&(text.len() as u64).to_le_bytes());
        self.mac.update(text.as_bytes());
    }
    /// The words of one student.
    pub fn student(&self, id: &str) -> DrawWords {
        let mut own = self.clone();
        own.part(id);
        DrawWords::new(own.mac.finalize().into_bytes().into())
    }
}

impl std::fmt::Debug for Source {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Source")
    }
}

/// Words that are kept of a try: as many as the cipher makes at once.
const KEPT: usize = 32;

/// The random words of one variant.
#[derive(Debug, Clone)]
pub struct DrawWords {
    key: [u8; 32],
    cipher: ChaCha20Rng,
    attempt: u64,
    /// The first words of this try, as far as they were made.
    kept: [u64; KEPT],
    made: usize,
}

impl DrawWords {
    /// Words of a ChaCha20 key, at try 1.
    pub fn new(key: [u8; 32]) -> Self {
        let mut words =
            Self { key, cipher: ChaCha20Rng::from_seed(key), attempt: 0, kept: [0; KEPT], made: 0 };
        words.attempt(1);
        words
    }
    /// Goes to a try, from 1.
    pub fn attempt(&mut self, number: u32) {
        if self.attempt == u64::from(number) {
            return;
        }
        self.attempt = u64::from(number);
        // A fresh cipher makes no block before it is asked for a word; a moved one would make one for nothing.
        self.cipher = ChaCha20Rng::from_seed(self.key);
        self.cipher.set_stream(self.attempt);
        self.made = 0;
    }
    /// Word `index` of this try.
    fn word(&mut self, index: usize) -> u64 {
        if index >= KEPT {
            return self.far(self.attempt, index);
        }
        while self.made <= index {
            self.kept[self.made] = self.cipher.next_u64();
            self.made += 1;
        }
        self.kept[index]
    }
    /// Word `index` of any nonce.
    fn far(&self, nonce: u64, index: usize) -> u64 {
        let mut cipher = ChaCha20Rng::from_seed(self.key);
        cipher.set_stream(nonce);
        cipher.set_word_pos(2 * index as u128);
        cipher.next_u64()
    }
    /// An unbiased whole number below `n`, from word `index` of this try. `n` = 0 counts as 1.
    pub fn below(&mut self, index: usize, n: u64) -> u64 {
        if n <= 1 {
            return 0;
        }
        let least = n.wrapping_neg() % n;
        let mut word = self.word(index);
        let mut again = 0u64;
        loop {
            let product = u128::from(word) * u128::from(n);
            // The low half decides about bias, the high half is the number.
            let (high, low) = halves(product);
            if low >= least {
                return high;
            }
            again += 1;
            word = self.far(self.attempt | (again << 32), index);
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "the two halves of 128 bits")]
const fn halves(product: u128) -> (u64, u64) {
    ((product >> 64) as u64, product as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_those_of_the_cipher() {
        // An external ChaCha20: zero key; and key 07...07, block counter 1, nonce 5.
        let zero = DrawWords::new([0; 32]);
        assert_eq!(zero.far(0, 0).swap_bytes(), 0x76b8_e0ad_a0f1_3d90);
        let mut seven = ChaCha20Rng::from_seed([7; 32]);
        seven.set_stream(5);
        seven.set_word_pos(16);
        assert_eq!(seven.next_u64(), 0xe58c_3bc1_2820_9a4c);
        let mut words = DrawWords::new([7; 32]);
        words.attempt(5);
        assert_eq!(words.word(8), 0xe58c_3bc1_2820_9a4c);
        for index in 0..80 {
            assert_eq!(words.word(index), words.far(5, index));
        }
    }

    #[test]
    fn the_key_can_be_redone_elsewhere() {
        // python3: hmac.new(b"slipstick draw 4", struct.pack("<Q", 7) + b"".join(struct.pack("<Q", len(p)) + p
        //          for p in [b"week-3", b"pulled-rolling", "Zoë".encode()]), "sha256").hexdigest()
        let source = Source::new(7, "week-3", "pulled-rolling");
        let mut own = source.clone();
        own.part("Zoë");
        let hex: String = own.mac.finalize().into_bytes().iter().map(|b| format!("{b:02x}")).collect();
        assert_eq!(hex, "2d2e0039c36d2e9ca4d66e4e3f318ab0cc635b991ef4420b0efd8b5f04ffb009");
    }

    #[test]
    fn parts_cannot_be_shifted() {
        let first =
            |set: &str, problem: &str, student: &str| Source::new(1, set, problem).student(student).word(0);
        assert_ne!(first("ab", "c", "d"), first("a", "bc", "d"));
        assert_ne!(first("a", "b", "cd"), first("a", "bc", "d"));
        assert_eq!(first("a", "b", "c"), first("a", "b", "c"));
    }

    #[test]
    fn below_is_even_and_dropped_words_are_replaced() {
        let mut words = DrawWords::new([3; 32]);
        let mut count = [0u32; 6];
        for attempt in 1..=6000 {
            words.attempt(attempt);
            count[usize::try_from(words.below(2, 6)).unwrap()] += 1;
        }
        assert!(count.iter().all(|c| (850..1150).contains(c)), "{count:?}");
        // With n just above 2^63 half of all words are dropped.
        let n = (1 << 63) + 1;
        for attempt in 1..200 {
            words.attempt(attempt);
            assert!(words.below(0, n) < n);
        }
    }
}
