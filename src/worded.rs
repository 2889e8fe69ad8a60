//! Words that stand for the cases of an enum: how files, tables and people write each, said once.

/// An enum each of whose cases is a word, in the order in which messages and summaries name them.
#[macro_export]
macro_rules! worded {
    ($(#[$about:meta])* $name:ident { $($(#[$of:meta])* $case:ident $word:literal,)* }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $($(#[$of])* $case,)* }
        #[allow(dead_code, reason = "not each of them is listed, read and written")]
        impl $name {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$case,)*];
            /// How each is written.
            pub const WORDS: &[(&str, Self)] = &[$(($word, Self::$case),)*];
            /// As it is written.
            pub const fn as_str(self) -> &'static str { match self { $(Self::$case => $word,)* } }
            /// The one that is written so.
            pub fn of_word(word: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|one| one.as_str() == word)
            }
        }
    };
}
