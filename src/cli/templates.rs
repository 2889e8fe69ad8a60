//! `slipstick templates`: the built-in templates and word lists as files, to be changed, and what each of them receives.
use crate::bank::{built_in, overlay};
use crate::cli::tell::{Exit, Io};
use crate::finding::Findings;
use crate::folder::banks::README;
use crate::folder::files::NewFolder;
use crate::folder::staged::Staged;
use crate::folder::{banks, files};
use crate::sheet::terminal;
use crate::template;
use crate::words::Words;
use std::path::Path;

/// What is not written out: the looks of pages that only instructors see, and the font of formulas.
const NOT_WRITTEN: [&str; 5] =
    ["accuracy.html", "gallery.html", "index.html", "manual.html", "math-font.html"];

/// What each file receives.
const ABOUT: &str = include_str!("../../templates/README.md");

pub fn run(out: &Path, language: &str, io: &mut Io) -> Result<Exit, Findings> {
    banks::words(language)?;
    let new = NewFolder {
        verb: "templates",
        makes: "templates",
        example: "--out my-templates",
        taken: "give a new folder: templates that you changed are not replaced",
    };
    files::may_write_folder(out, false, &new, || Ok(None))?;
    let texts = texts(language)?;
    let staged = Staged::new(out)?;
    for (name, text) in &texts {
        staged.write(name, text.as_bytes())?;
    }
    staged.finish()?;
    let out = out.display();
    io.line(&format!(
        "{}, in {out}; {out}/{README} says what each receives",
        terminal::count(texts.len(), "file")
    ));
    io.line(&format!("  use them with: --templates {out}"));
    Ok(Exit::Fine)
}

/// All files: name, text.
fn texts(language: &str) -> Result<Vec<(String, String)>, Findings> {
    let mut texts: Vec<(String, String)> = Vec::new();
    for (name, text) in template::built_in(language).filter(|(name, _)| !NOT_WRITTEN.contains(name)) {
        texts.push((name.to_owned(), text.to_owned()));
    }
    for (topic, text) in Words::lists(language).unwrap_or_default() {
        texts.push((format!("words/{topic}.yaml"), (*text).to_owned()));
    }
    let translated = built_in::TRANSLATED.iter().find(|(code, _)| *code == language);
    for (id, file, text) in built_in::BUILT_IN {
        let own = translated.and_then(|(_, list)| list.iter().find(|(i, ..)| i == id));
        let text = match own {
            Some((_, _, text)) => (*text).to_owned(),
            None => overlay::text_of(&banks::parse(text, file)?),
        };
        texts.push((format!("banks/{id}.yaml"), text));
    }
    texts.push(("print.typ".to_owned(), crate::sheet::typst::PRELUDE.to_owned()));
    texts.push((
        README.to_owned(),
        format!("{ABOUT}\nThe texts in this folder are those of the language `{language}`.\n"),
    ));
    texts.sort();
    Ok(texts)
}
