//! Documents to files: the formats that were asked for, one document or all of a set in one.
use crate::bank::Bank;
use crate::cli::args::Format;
use crate::cli::banks::Texts;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::key::SheetKey;
use crate::sheet::document::Document;
use crate::sheet::document::Head;
use crate::sheet::html;
use crate::sheet::html::Converter;
use crate::sheet::html::Place;
use crate::sheet::key_table;
use crate::sheet::key_table::Row;
use crate::sheet::pdf;
use crate::sheet::pdf::Press;
use crate::sheet::tex;

/// The files of a booklet, and of a key table, whatever the formats.
pub const BOOKLETS: [&str; 3] = ["booklet.html", "booklet.pdf", "booklet.tex"];
/// The key for people.
pub const KEY_TABLES: [&str; 3] = ["key-table.html", "key-table.md", "key-table.pdf"];

/// What was asked for, or the default: Markdown and a page, and PDF where it is built in. Each once, in a fixed order.
pub fn formats(asked: Option<&[Format]>) -> Vec<Format> {
    match asked {
        Some(asked) => Format::ALL.into_iter().filter(|f| asked.contains(f)).collect(),
        None => Format::ALL
            .into_iter()
            .filter(|f| match f {
                Format::Md | Format::Html => true,
                Format::Tex => false,
                Format::Pdf => pdf::BUILT_IN,
            })
            .collect(),
    }
}

/// The formats of a stored set.
pub fn stored(endings: &[String]) -> Vec<Format> {
    Format::ALL.into_iter().filter(|f| endings.iter().any(|e| e == f.ending())).collect()
}

/// Writes documents in some formats.
pub struct Output<'o> {
    texts: &'o Texts,
    formats: &'o [Format],
    /// Name of the files, `sheet` or `solution`.
    name: &'static str,
    press: Option<Press>,
}

/// One document written: its files, and its part of the booklets.
pub struct Made {
    /// Who gets it.
    pub head: Head,
    /// Names and bytes.
    pub files: Vec<(String, Vec<u8>)>,
    html: String,
    tex: String,
    /// Kept only where a PDF of all is wanted.
    document: Document,
}

impl<'o> Output<'o> {
    /// Gets ready.
    ///
    /// # Errors
    /// PDF is asked for and not built in, or the instructor's `print.typ` is faulty.
    pub fn new(texts: &'o Texts, formats: &'o [Format], name: &'static str) -> Result<Self, Findings> {
        let press = match formats.contains(&Format::Pdf) {
            true => Some(Press::new(&texts.words, texts.print())?),
            false => None,
        };
        Ok(Self { texts, formats, name, press })
    }

    fn wants(&self, format: Format) -> bool {
        self.formats.contains(&format)
    }

    /// The files of a document that stands at this place (from 0) in the booklet.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn make(
        &self,
        at: usize,
        head: Head,
        document: Document,
        converter: &mut Converter,
    ) -> Result<Made, Finding> {
        let mut made = Made {
            head,
            files: Vec::new(),
            html: String::new(),
            tex: String::new(),
            document: Document::default(),
        };
        let screens = match self.wants(Format::Md) || self.wants(Format::Html) {
            true => document.screens(),
            false => Vec::new(),
        };
        for format in self.formats {
            let name = format!("{}.{}", self.name, format.ending());
            let bytes = match format {
                Format::Md => {
                    for (name, screen) in &screens {
                        made.files.push((format!("{name}.svg"), screen.file().into_bytes()));
                    }
                    document.plain().into_bytes()
                }
                Format::Html => {
                    let body = converter.body(&document, &screens, Place { lower: 0, prefix: "" });
                    let prefix = format!("{}-", html::part_id(at));
                    made.html = converter.body(&document, &screens, Place { lower: 1, prefix: &prefix });
                    html::page(&self.texts.templates, &self.texts.words, self.name, &made.head, &body)?
                }
                Format::Tex => {
                    made.tex = tex::body(&document);
                    tex::page(&self.texts.templates, &self.texts.words, &made.head, &made.tex)?
                }
                Format::Pdf => self.pressed(&[(&made.head, &document)])?,
            };
            made.files.push((name, bytes));
        }
        if self.wants(Format::Pdf) {
            made.document = document;
        }
        Ok(made)
    }

    fn pressed(&self, documents: &[(&Head, &Document)]) -> Result<Vec<u8>, Finding> {
        self.press.as_ref().map_or_else(|| Ok(Vec::new()), |press| press.press(documents))
    }

    /// The booklets of all documents.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn booklets(&self, title: &str, all: &[Made]) -> Result<Vec<(&'static str, Vec<u8>)>, Finding> {
        let Texts { templates, words, .. } = self.texts;
        let mut files = Vec::new();
        if self.wants(Format::Html) {
            let parts = all.iter().map(|m| (&m.head, m.html.as_str()));
            files.push(("booklet.html", html::booklet(templates, words, title, parts)?));
        }
        if self.wants(Format::Tex) {
            let parts = all.iter().map(|m| (&m.head, m.tex.as_str()));
            files.push(("booklet.tex", tex::booklet(templates, words, title, parts)?));
        }
        if self.wants(Format::Pdf) {
            let parts: Vec<(&Head, &Document)> = all.iter().map(|m| (&m.head, &m.document)).collect();
            files.push(("booklet.pdf", self.pressed(&parts)?));
        }
        Ok(files)
    }

    /// The key for people: a page, whatever the formats, and Markdown and PDF where they are asked for.
    ///
    /// # Errors
    /// Faults of the templates.
    pub fn key_table<'k>(
        &self,
        bank: &Bank,
        set: &str,
        problems: &[usize],
        rows: &[Row],
        keys: impl Iterator<Item = &'k SheetKey> + Clone,
    ) -> Result<Vec<(&'static str, Vec<u8>)>, Finding> {
        let Texts { templates, words, .. } = self.texts;
        let (head, document) = key_table::document(templates, words, bank, set, problems, rows, keys)?;
        let mut files = Vec::new();
        if self.wants(Format::Md) {
            files.push(("key-table.md", document.plain().into_bytes()));
        }
        if self.wants(Format::Pdf) {
            files.push(("key-table.pdf", self.pressed(&[(&head, &document)])?));
        }
        let body = Converter::new(words).body(&document, &[], Place { lower: 0, prefix: "" });
        files.push(("key-table.html", html::page(templates, words, "key", &head, &body)?));
        Ok(files)
    }
}

/// The threads on which sheets are made, as many as cores where no number is given.
///
/// # Errors
/// They cannot be started.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Findings> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build()
        .map_err(|e| Finding::new("--threads", e.to_string()).into())
}
