//! Drawing lots: seeds to streams of words, words to values on decimal grids.
//!
//! A variant depends on (seed, set name, problem id, student id) alone. The words are those of the ChaCha20 cipher, so
//! anybody can redo a draw; no range method of a library is used, since their results change between versions.
pub mod sample;
pub mod stream;
