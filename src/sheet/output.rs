//! Documents to files: the formats that were asked for, one document or all of a set in one.
use crate::bank::Bank;
use crate::finding::Finding;
use crate::key::SheetKey;
use crate::sheet::document::{Document, Head};
use crate::sheet::html::{Converter, PlaceInPage};
use crate::sheet::key_table::KeyTableRow;
use crate::sheet::pdf::PdfCompiler;
use crate::sheet::self_check::Tools;
use crate::sheet::texts::Texts;
use crate::sheet::{html, key_table, pdf, tex};

worded! {
    /// A format in which sheets and solutions are written.
    #[derive(PartialOrd, Ord)]
    Format {
        /// Markdown, with its figures as SVG files
        Md "md",
        /// A page that needs nothing else
        Html "html",
        /// LaTeX, figures in TikZ
        Tex "tex",
        /// PDF, where the program was built with `--features pdf`
        Pdf "pdf",
    }
}

/// What was asked for, or the default: Markdown and a page, and PDF where it is built in. Each once, in a fixed order.
pub fn formats(asked: Option<&[Format]>) -> Vec<Format> {
    let wanted = |format: &Format| match (asked, format) {
        (Some(asked), format) => asked.contains(format),
        (None, Format::Md | Format::Html) => true,
        (None, Format::Tex) => false,
        (None, Format::Pdf) => pdf::BUILT_IN,
    };
    Format::ALL.iter().copied().filter(wanted).collect()
}

/// The formats of a stored set.
pub fn stored(endings: &[String]) -> Vec<Format> {
    Format::ALL.iter().copied().filter(|f| endings.iter().any(|e| e == f.as_str())).collect()
}

/// Writes documents in some formats.
pub struct DocumentWriter<'o> {
    texts: &'o Texts,
    formats: &'o [Format],
    /// Name of the files, `sheet` or `solution`.
    name: &'static str,
    press: Option<PdfCompiler>,
}

/// One document written: its files, and its part of the booklets.
#[derive(Default)]
pub struct WrittenDocument {
    /// Who gets it.
    pub head: Head,
    /// Names and bytes.
    pub files: Vec<(String, Vec<u8>)>,
    html: String,
    tex: String,
    /// Kept only where a PDF of all is wanted.
    document: Document,
}

impl<'o> DocumentWriter<'o> {
    /// Gets ready. Errors: pDF is asked for and not built in, or the instructor's `print.typ` is faulty.
    pub fn new(texts: &'o Texts, formats: &'o [Format], name: &'static str) -> Result<Self, Finding> {
        let press = match formats.contains(&Format::Pdf) {
            true => Some(PdfCompiler::new(&texts.words, texts.print())?),
            false => None,
        };
        Ok(Self { texts, formats, name, press })
    }

    fn wants(&self, format: Format) -> bool {
        self.formats.contains(&format)
    }

    /// The files of a document that stands at this place (from 0) in the booklet; as a page it may have tools. Errors: faults of
    /// the templates.
    pub fn make(
        &self,
        at: usize,
        head: Head,
        document: Document,
        converter: &mut Converter,
        tools: Option<&Tools>,
    ) -> Result<WrittenDocument, Finding> {
        let mut made = WrittenDocument { head, ..WrittenDocument::default() };
        let Texts { templates, words, .. } = self.texts;
        let screens = match self.wants(Format::Md) || self.wants(Format::Html) {
            true => document.screens(),
            false => Vec::new(),
        };
        for format in self.formats {
            let name = format!("{}.{}", self.name, format.as_str());
            let bytes = match format {
                Format::Md => {
                    for (name, screen) in &screens {
                        made.files.push((format!("{name}.svg"), screen.file().into_bytes()));
                    }
                    document.plain().into_bytes()
                }
                Format::Html => {
                    let boxes = tools.map_or(&[][..], |tools| &tools.parts);
                    let alone = PlaceInPage { boxes, ..PlaceInPage::default() };
                    let body = converter.body(&document, &screens, alone);
                    let prefix = format!("{}-", html::part_id(at));
                    let in_booklet = PlaceInPage { lower: 1, prefix: &prefix, boxes: &[] };
                    made.html = converter.body(&document, &screens, in_booklet);
                    html::page(templates, words, self.name, &made.head, &body, tools)?
                }
                Format::Tex => {
                    made.tex = tex::body(&document);
                    tex::page(templates, words, &made.head, &made.tex)?
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

    /// The booklets of all documents. Errors: faults of the templates.
    pub fn booklets(
        &self,
        title: &str,
        all: &[WrittenDocument],
    ) -> Result<Vec<(&'static str, Vec<u8>)>, Finding> {
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

    /// The key for people: a page, whatever the formats, and Markdown and PDF where they are asked for. Errors: faults of the
    /// templates.
    pub fn key_table<'k>(
        &self,
        bank: &Bank,
        set: &str,
        problems: &[usize],
        rows: &[KeyTableRow],
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
        let body = Converter::new(words).body(&document, &[], PlaceInPage::default());
        files.push(("key-table.html", html::page(templates, words, "key", &head, &body, None)?));
        Ok(files)
    }
}
