//! What a solution says, in order, before a template decides how it stands on the page.

/// A part of a solution.
#[derive(Debug, Clone, PartialEq)]
pub struct SolutionSection {
    /// Its name for templates: `eom`, `energy`, ...
    pub id: &'static str,
    /// Its heading.
    pub title: String,
    /// What stands in it.
    pub blocks: Vec<Block>,
}

/// A piece of a section.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A paragraph of Markdown.
    Words(String),
    /// A displayed formula, LaTeX without dollars.
    Formula(String),
    /// The picture of this name.
    Picture(String),
    /// What else is Markdown: a box, a list, a table.
    Markdown(String),
}

impl Block {
    /// What is written in it; of a picture its name.
    pub fn text(&self) -> &str {
        match self {
            Self::Words(text) | Self::Formula(text) | Self::Picture(text) | Self::Markdown(text) => text,
        }
    }
}

impl SolutionSection {
    /// An empty one.
    pub fn new(id: &'static str, title: &str) -> Self {
        Self { id, title: title.to_owned(), blocks: Vec::new() }
    }
    /// Adds a paragraph.
    pub fn say(&mut self, words: impl Into<String>) {
        self.blocks.push(Block::Words(words.into()));
    }
    /// What stands between its title and its text: a space where words go on, else an empty line.
    pub fn gap(&self) -> &'static str {
        if matches!(self.blocks.first(), Some(Block::Words(_))) { " " } else { "\n\n" }
    }
    /// Its blocks as Markdown; `alt` tells what a picture shows.
    pub fn markdown(&self, alt: &dyn Fn(&str) -> String) -> String {
        let block = |block: &Block| match block {
            Block::Words(text) | Block::Markdown(text) => text.clone(),
            Block::Formula(tex) => format!("$${tex}$$"),
            Block::Picture(name) => format!("![{}]({name}.svg)", alt(name)),
        };
        self.blocks.iter().map(block).collect::<Vec<_>>().join("\n\n")
    }
}

/// Width of a line of a formula that fits on 16 cm of print, in digits.
pub const LINE: f64 = 74.0;
/// Width of the widest line that is still printed whole.
pub const WIDEST: f64 = 86.0;
