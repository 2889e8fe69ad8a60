//! A text with its pictures: Markdown with `$...$` formulas is the single source of every format.
use crate::figure::picture::Picture;

/// A text with its pictures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// The text. A picture stands in a paragraph of its own, `![what it shows](NAME.svg)`.
    pub markdown: String,
    /// The pictures by name, in the order of the text.
    pub pictures: Vec<(String, Picture)>,
}
