//! A text with its pictures: Markdown with `$...$` formulas is the single source of every format.
use crate::figure::picture::Picture;
use crate::figure::svg::Screen;

/// A text with its pictures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// The text. A picture stands in a paragraph of its own, `![what it shows](NAME.svg)`. Where paper needs room for an
    /// answer stands [`ANSWER`].
    pub markdown: String,
    /// The pictures by name (without `.svg`), in the order of the text.
    pub pictures: Vec<(String, Picture)>,
}

/// Room for an answer on paper: formats that are printed put a line or a box there, files of Markdown leave it out.
pub const ANSWER: &str = "<!-- answer -->";

/// What stands at the head of a document and of each of its printed pages: texts as people wrote them, not escaped.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Head {
    /// Title of the bank, or of the document.
    pub title: String,
    /// Name of the student; empty if the roster has none.
    pub name: String,
    /// Id of the student.
    pub student: String,
    /// Name of the set.
    pub set: String,
    /// Code of the drawn data, so that a sheet on paper can be told from every other.
    pub code: String,
}

impl Document {
    /// The Markdown as a file of its own: without room for answers.
    pub fn plain(&self) -> String {
        without_marks(&self.markdown)
    }

    /// The picture of this name.
    pub fn picture(&self, name: &str) -> Option<&Picture> {
        self.pictures.iter().find(|(n, _)| n == name).map(|(_, picture)| picture)
    }

    /// The pictures as they stand on a screen: made once, shown in the page, in the booklet and as files.
    pub fn screens(&self) -> Vec<(&str, Screen<'_>)> {
        self.pictures.iter().map(|(name, picture)| (name.as_str(), Screen::new(picture))).collect()
    }
}

/// A sign of percent stays on the line of its number: the blank between them becomes one that does not break.
pub fn kept_together(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut pieces = text.split(" %");
    out.push_str(pieces.next().unwrap_or_default());
    for piece in pieces {
        out.push_str(if out.ends_with(|c: char| c.is_ascii_digit()) { "\u{a0}%" } else { " %" });
        out.push_str(piece);
    }
    out
}

/// A Markdown text without room for answers.
pub fn without_marks(markdown: &str) -> String {
    markdown.replace(&format!(" {ANSWER}"), "").replace(ANSWER, "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_stays_with_its_number() {
        assert_eq!(kept_together("within 1.9 % or 2 %, in %"), "within 1.9\u{a0}% or 2\u{a0}%, in %");
    }
}
