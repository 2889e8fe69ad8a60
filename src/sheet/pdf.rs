//! Documents to PDF: keeper of the Typst compiler, which comes only with the Cargo feature `pdf`.
//!
//! Without the feature everything here is there too, and [`PdfCompiler::new`] says how to get it, so that callers need no
//! conditions. The same documents give the same bytes on every machine: no clock, no fonts but the built-in ones.

/// Does this program write PDFs?
pub const BUILT_IN: bool = cfg!(feature = "pdf");

#[cfg(feature = "pdf")]
pub use compiler::PdfCompiler;
#[cfg(not(feature = "pdf"))]
pub use none::PdfCompiler;

#[cfg(not(feature = "pdf"))]
mod none {
    use crate::finding::Finding;
    use crate::sheet::document::{Document, Head};
    use crate::words::Words;
    use std::convert::Infallible;

    /// Would make PDFs; there is none.
    pub struct PdfCompiler(Infallible);

    impl PdfCompiler {
        /// Says how to get a program that makes PDFs. Errors: always.
        pub fn new(_: &Words, _: Option<(&str, &str)>) -> Result<Self, Finding> {
            let what = "this program was built without PDF: build it with `cargo build --release --features pdf`, or print the HTML pages";
            Err(Finding::new("--format pdf", what))
        }
        /// Is never called. Errors: none.
        pub fn press(&self, _: &[(&Head, &Document)]) -> Result<Vec<u8>, Finding> {
            match self.0 {}
        }
    }
}

#[cfg(feature = "pdf")]
mod compiler {
    use crate::finding::Finding;
    use crate::sheet::document::{Document, Head};
    use crate::sheet::typst::{PRELUDE, source};
    use crate::words::Words;
    use rayon::{ThreadPool, ThreadPoolBuilder};
    use std::sync::LazyLock;
    use std::sync::atomic::{AtomicU32, Ordering};
    use typst::diag::{FileError, FileResult, SourceDiagnostic};
    use typst::foundations::{Bytes, Datetime, Duration, Smart};
    use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
    use typst::text::{Font, FontBook};
    use typst::utils::LazyHash;
    use typst::{Library, LibraryExt as _, World, WorldExt as _};
    use typst_layout::PagedDocument;
    use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

    /// What never changes: fonts, library, names of files. The names are few: the compiler knows 65,535 in a process.
    struct Fixed {
        library: LazyHash<Library>,
        book: LazyHash<FontBook>,
        fonts: Vec<Font>,
        main: FileId,
        prelude: FileId,
    }

    static FIXED: LazyLock<Fixed> = LazyLock::new(|| {
        let fonts: Vec<Font> = typst_assets::fonts().flat_map(|data| Font::iter(Bytes::new(data))).collect();
        let name = |path: &str| {
            let path = VirtualPath::new(path).expect("a path within the project");
            RootedPath::new(VirtualRoot::Project, path).intern()
        };
        Fixed {
            library: LazyHash::new(Library::default()),
            book: LazyHash::new(FontBook::from_fonts(&fonts)),
            fonts,
            main: name("/main.typ"),
            prelude: name("/print.typ"),
        }
    });

    /// Threads of the compiler alone. Whoever waits in a pool works on what else is to be done there: with one pool for
    /// sheets and compiler a sheet would begin on the stack of another, that one's on a third, until no stack is left.
    static POOL: LazyLock<Result<ThreadPool, String>> =
        LazyLock::new(|| ThreadPoolBuilder::new().stack_size(STACK).build().map_err(|e| e.to_string()));

    /// Stack of such a thread, bytes; taken from the machine only where it is used.
    const STACK: usize = 64 << 20;

    /// PDFs made by the process; the compiler remembers parts of them until it is told to forget.
    static PRESSED: AtomicU32 = AtomicU32::new(0);
    /// Forget after so many ...
    const FORGET_EVERY: u32 = 16;
    /// ... what was not used since so many times.
    const FORGET_UNUSED: usize = 2;

    /// Makes PDFs. Made once, shared by all threads.
    pub struct PdfCompiler {
        words: Words,
        prelude: Source,
        file: Option<String>,
        options: PdfOptions,
    }

    impl PdfCompiler {
        /// Loads fonts and the prelude: `own` is the instructor's `print.typ`, with its path for messages, instead of the
        /// built-in one. Errors: what is wrong in the prelude.
        pub fn new(words: &Words, own: Option<(&str, &str)>) -> Result<Self, Finding> {
            let text = own.map_or(PRELUDE, |(_, text)| text);
            let standards = PdfStandards::new(&[PdfStandard::Ua_1])
                .map_err(|e| Finding::new("", format!("the standard PDF/UA-1 cannot be kept: {e:?}")))?;
            let creator = format!("slipstick {}", env!("CARGO_PKG_VERSION"));
            Ok(Self {
                words: words.clone(),
                prelude: Source::new(FIXED.prelude, text.to_owned()),
                file: own.map(|(file, _)| file.to_owned()),
                options: PdfOptions {
                    creator: Smart::Custom(Some(creator)),
                    standards,
                    ..PdfOptions::default()
                },
            })
        }

        /// One PDF with these documents one after the other, each from a new page and with pages counted from 1. Documents
        /// may be pressed by many threads at once.
        /// Errors: a formula that has no translation, a picture that is not there, what the prelude does not take.
        pub fn press(&self, documents: &[(&Head, &Document)]) -> Result<Vec<u8>, Finding> {
            let text = source(documents, &self.words)?;
            let job = Compilation { prelude: &self.prelude, main: Source::new(FIXED.main, text) };
            let pool = POOL.as_ref().map_err(|e| Finding::new("", format!("PDF: no threads: {e}")))?;
            let compile = || {
                let pages = typst::compile::<PagedDocument>(&job).output;
                pages.and_then(|pages| typst_pdf::pdf(&pages, &self.options))
            };
            // A thread of its own waits for the pool, and ours for it: so it takes up nothing else meanwhile.
            let pdf = std::thread::scope(|scope| scope.spawn(|| pool.install(compile)).join());
            let pdf = match pdf {
                Ok(pdf) => pdf.map_err(|errors| self.finding(&job, errors.first())),
                Err(panic) => std::panic::resume_unwind(panic),
            };
            if PRESSED.fetch_add(1, Ordering::Relaxed) % FORGET_EVERY == FORGET_EVERY - 1 {
                typst::comemo::evict(FORGET_UNUSED);
            }
            pdf
        }

        /// The compiler's first error: in the prelude with its place, else with what stands there.
        fn finding(&self, job: &Compilation, error: Option<&SourceDiagnostic>) -> Finding {
            let Some(error) = error else {
                return Finding::new("", "the PDF cannot be made, and the compiler does not say why");
            };
            let message = format!("PDF: {}", error.message);
            let hint = error.hints.first().map(|h| h.v.to_string());
            let with_hint = |finding: Finding| match &hint {
                Some(hint) => finding.hint(hint.clone()),
                None => finding,
            };
            let own = self.file.as_deref().unwrap_or("print.typ");
            // The place itself, or the call in the prelude that led to it.
            let spans = std::iter::once(error.span).chain(error.trace.iter().map(|t| t.span.into()));
            for span in spans {
                if span.id() == Some(FIXED.prelude)
                    && let Some(range) = job.range(span)
                    && let Some((line, column)) = self.prelude.lines().byte_to_line_column(range.start)
                {
                    return with_hint(Finding::new("", message).at(line + 1, column + 1).in_file(own));
                }
            }
            let shown = job.range(error.span).and_then(|range| job.main.text().get(range));
            let shown: String = shown.unwrap_or("").chars().take(120).collect();
            with_hint(Finding::new(
                "",
                if shown.is_empty() { message } else { format!("{message}: {shown}") },
            ))
        }
    }

    /// One run of the compiler.
    struct Compilation<'m> {
        prelude: &'m Source,
        main: Source,
    }

    impl World for Compilation<'_> {
        fn library(&self) -> &LazyHash<Library> {
            &FIXED.library
        }
        fn book(&self) -> &LazyHash<FontBook> {
            &FIXED.book
        }
        fn main(&self) -> FileId {
            FIXED.main
        }
        fn source(&self, id: FileId) -> FileResult<Source> {
            if id == FIXED.main {
                Ok(self.main.clone())
            } else if id == FIXED.prelude {
                Ok(self.prelude.clone())
            } else {
                Err(FileError::Other(Some("a print.typ stands alone, it cannot read other files".into())))
            }
        }
        fn file(&self, id: FileId) -> FileResult<Bytes> {
            self.source(id).map(|source| Bytes::from_string(source.text().to_owned()))
        }
        fn font(&self, index: usize) -> Option<Font> {
            FIXED.fonts.get(index).cloned()
        }
        fn today(&self, _: Option<Duration>) -> Option<Datetime> {
            None
        }
    }
}
