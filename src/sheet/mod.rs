//! What a reader sees: statements, sheets, the public sheet file. Numbers become text here, once.
pub mod document;
pub mod formula;
pub mod html;
pub(crate) mod key_table;
pub(crate) mod output;
pub mod pdf;
pub mod public;
pub mod self_check;
pub mod sheets;
pub mod statement;
pub(crate) mod terminal;
pub mod tex;
pub(crate) mod texts;
pub mod typst;
