//! Texts to their numbers, for looking up one in millions of rows: one table without pointers, few lines of cache.

/// Numbers of texts; a text that is put in twice has the later number.
#[derive(Debug, Default)]
pub(crate) struct Ids {
    /// High half: the high half of the hash; low half: place in `ends`, from 1; 0 where nothing is.
    slots: Vec<u64>,
    text: Vec<u8>,
    /// Where the texts end, and their numbers.
    ends: Vec<(u32, u32)>,
}

/// Mixes the bytes eight at a time; the bits above and below are both good.
#[inline]
pub(crate) fn mixed(text: &[u8]) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut hash = (text.len() as u64).wrapping_mul(ODD);
    let mut mix = |word: u64| {
        let product = u128::from(hash ^ word) * u128::from(ODD);
        hash = (product >> 64) as u64 ^ product as u64;
    };
    let (words, rest) = text.as_chunks::<8>();
    for word in words {
        mix(u64::from_le_bytes(*word));
    }
    mix(rest.iter().fold(0, |word, b| word << 8 | u64::from(*b)));
    hash
}

impl Ids {
    /// Room for so many texts.
    pub fn with_room(texts: usize) -> Ids {
        Ids { slots: vec![0; (texts * 2).next_power_of_two().max(16)], ..Ids::default() }
    }
    fn text_of(&self, place: usize) -> &[u8] {
        let start = place.checked_sub(1).map_or(0, |before| self.ends[before].0);
        &self.text[start as usize..self.ends[place].0 as usize]
    }
    /// The slot of a text: where it is, or where it would go.
    #[inline]
    fn slot(&self, text: &[u8]) -> (usize, u64) {
        let hash = mixed(text);
        let mask = self.slots.len() - 1;
        let mut at = hash as usize & mask;
        loop {
            let slot = self.slots[at];
            let same_hash = (slot ^ hash) >> 32 == 0;
            if slot == 0 || (same_hash && self.text_of(slot as u32 as usize - 1) == text) {
                return (at, hash);
            }
            at = (at + 1) & mask;
        }
    }
    /// Puts a text in. Texts beyond 4 GiB in all are not kept.
    pub fn put(&mut self, text: &[u8], number: u32) {
        if self.slots.len() < 2 * (self.ends.len() + 1) {
            let mut more = Ids::with_room(self.ends.len() * 2 + 8);
            for place in 0..self.ends.len() {
                more.put(self.text_of(place), self.ends[place].1);
            }
            *self = more;
        }
        let (at, hash) = self.slot(text);
        if self.slots[at] != 0 {
            self.ends[self.slots[at] as u32 as usize - 1].1 = number;
            return;
        }
        let Ok(end) = u32::try_from(self.text.len() + text.len()) else { return };
        self.text.extend_from_slice(text);
        self.ends.push((end, number));
        self.slots[at] = hash >> 32 << 32 | self.ends.len() as u64;
    }
    /// The number of a text.
    #[inline]
    pub fn get(&self, text: &[u8]) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        let place = (self.slots[self.slot(text).0] as u32 as usize).checked_sub(1)?;
        Some(self.ends[place].1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    proptest! {
        #[test]
        fn it_is_a_map(puts in prop::collection::vec(("[a-c0]{0,20}", 0u32..9), 0..200), asked in "[a-c0]{0,20}") {
            let (mut ids, mut map) = (Ids::default(), BTreeMap::new());
            for (text, number) in &puts {
                ids.put(text.as_bytes(), *number);
                map.insert(text.clone(), *number);
            }
            for text in puts.iter().map(|(t, _)| t).chain([&asked]) {
                prop_assert_eq!(ids.get(text.as_bytes()), map.get(text).copied());
            }
        }
    }
}
