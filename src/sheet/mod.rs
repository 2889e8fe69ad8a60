//! What a reader sees: statements, sheets, the public sheet file. Numbers become text here, once.
pub mod document;
pub mod html;
pub mod key_table;
pub mod output;
pub mod pdf;
pub mod public;
pub mod self_check;
pub mod sheets;
pub mod statement;
pub mod terminal;
pub mod tex;
pub mod texts;
pub mod typst;
