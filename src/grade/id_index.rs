//! Texts to their numbers, for looking up one in millions of rows.
use rustc_hash::FxHashMap;

/// A text of fewer than sixteen bytes, and its length in the last of them.
pub(crate) type ShortText = [u64; 2];

/// Numbers of texts; a text that is put in twice has the later number. Short texts stand beside their numbers, so that a look-up
/// waits for memory once.
#[derive(Debug, Default)]
pub(crate) struct Ids {
    short: FxHashMap<ShortText, u32>,
    long: FxHashMap<Box<[u8]>, u32>,
}

#[inline]
pub(crate) fn short(text: &[u8]) -> Option<ShortText> {
    let mut bytes = [0; 16];
    bytes.get_mut(..text.len()).filter(|_| text.len() < 16)?.copy_from_slice(text);
    bytes[15] = text.len() as u8;
    let ([low, high], _) = bytes.as_chunks::<8>() else { return None };
    Some([u64::from_le_bytes(*low), u64::from_le_bytes(*high)])
}

impl Ids {
    pub fn put(&mut self, text: &[u8], number: u32) {
        match short(text) {
            Some(short) => self.short.insert(short, number),
            None => self.long.insert(text.into(), number),
        };
    }
    /// The number of a text.
    #[inline]
    pub fn get(&self, text: &[u8]) -> Option<u32> {
        match short(text) {
            Some(short) => self.short.get(&short).copied(),
            None => self.long.get(text).copied(),
        }
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
