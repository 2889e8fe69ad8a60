//! What the page uses of the crate `smallvec`, with every list on the heap: a page is to be small, and a list that may lie on the
//! stack or on the heap asks which at every access.
use std::ops::{Deref, DerefMut};

/// An array of a fixed length.
pub trait Array {
    /// What it holds.
    type Item;
}

impl<T, const N: usize> Array for [T; N] {
    type Item = T;
}

/// A list.
pub struct SmallVec<A: Array>(Vec<A::Item>);

impl<A: Array> SmallVec<A> {
    /// None yet.
    pub const fn new() -> Self {
        Self(Vec::new())
    }
    /// None yet, and room for so many.
    pub fn with_capacity(_room: usize) -> Self {
        Self::new()
    }
    /// Adds one at the end.
    pub fn push(&mut self, item: A::Item) {
        self.0.push(item);
    }
    /// Makes it so long, with copies of an item.
    pub fn resize(&mut self, count: usize, item: A::Item)
    where
        A::Item: Clone,
    {
        self.0.resize(count, item);
    }
    /// As many of one item.
    pub fn from_elem(item: A::Item, count: usize) -> Self
    where
        A::Item: Clone,
    {
        std::iter::repeat_n(item, count).collect()
    }
}

impl<A: Array<Item: Clone>> From<&[A::Item]> for SmallVec<A> {
    fn from(items: &[A::Item]) -> Self {
        items.iter().cloned().collect()
    }
}

impl<A: Array> Deref for SmallVec<A> {
    type Target = Vec<A::Item>;
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}
impl<A: Array> DerefMut for SmallVec<A> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}
impl<A: Array> Default for SmallVec<A> {
    fn default() -> Self {
        Self::new()
    }
}
impl<A: Array<Item: Clone>> Clone for SmallVec<A> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}
impl<A: Array<Item: std::fmt::Debug>> std::fmt::Debug for SmallVec<A> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}
impl<A: Array<Item: PartialEq>> PartialEq for SmallVec<A> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}
impl<A: Array<Item: Eq>> Eq for SmallVec<A> {}
impl<A: Array> Extend<A::Item> for SmallVec<A> {
    fn extend<I: IntoIterator<Item = A::Item>>(&mut self, items: I) {
        items.into_iter().for_each(|item| self.0.push(item));
    }
}
impl<A: Array> FromIterator<A::Item> for SmallVec<A> {
    fn from_iter<I: IntoIterator<Item = A::Item>>(items: I) -> Self {
        let mut list = Self::new();
        list.extend(items);
        list
    }
}
impl<A: Array> IntoIterator for SmallVec<A> {
    type Item = A::Item;
    type IntoIter = std::vec::IntoIter<A::Item>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}
impl<'l, A: Array> IntoIterator for &'l SmallVec<A> {
    type Item = &'l A::Item;
    type IntoIter = std::slice::Iter<'l, A::Item>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}
impl<'l, A: Array> IntoIterator for &'l mut SmallVec<A> {
    type Item = &'l mut A::Item;
    type IntoIter = std::slice::IterMut<'l, A::Item>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter_mut()
    }
}

/// A list of these items, or of so many of one.
#[macro_export]
macro_rules! smallvec {
    ($item:expr; $count:expr) => { ::smallvec::SmallVec::from_elem($item, $count) };
    ($($item:expr),* $(,)?) => {{
        #[allow(unused_mut, reason = "of an empty list")]
        let mut list = ::smallvec::SmallVec::new();
        $(list.push($item);)*
        list
    }};
}
