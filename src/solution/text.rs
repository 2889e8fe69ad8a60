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
    /// Pieces of Markdown in a box.
    Box(Vec<String>),
    /// A list, each item Markdown.
    List(Vec<String>),
    /// A table of Markdown cells, first row the head.
    Table(Vec<Vec<String>>),
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
        let mut out = String::new();
        for block in &self.blocks {
            if !out.is_empty() {
                out.push_str("\n\n");
            }
            match block {
                Block::Words(words) => out.push_str(words),
                Block::Formula(tex) => out.push_str(&format!("$${tex}$$")),
                Block::Picture(name) => out.push_str(&format!("![{}]({name}.svg)", alt(name))),
                Block::Box(items) => {
                    out.push_str("> ");
                    out.push_str(&items.join(" · "));
                }
                Block::List(items) => {
                    let items: Vec<String> = items.iter().map(|i| format!("- {i}")).collect();
                    out.push_str(&items.join("\n"));
                }
                Block::Table(rows) => {
                    for (i, row) in rows.iter().enumerate() {
                        out.push_str(&format!("| {} |\n", row.join(" | ")));
                        if i == 0 {
                            let rule = vec![":--"; row.len()];
                            out.push_str(&format!("|{}|\n", rule.join("|")));
                        }
                    }
                    out.truncate(out.trim_end().len());
                }
            }
        }
        out
    }
}

/// Width of a line of a formula that fits on 16 cm of print, in digits.
pub const LINE: f64 = 74.0;
