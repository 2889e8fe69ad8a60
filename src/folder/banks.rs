//! A bank by its name: a file, or one that the program brings along; and the texts to tell it in.
use crate::bank::built_in::{BUILT_IN, TRANSLATED};
use crate::bank::{Bank, Problem, Variables, load, overlay};
use crate::finding::{Finding, Findings};
use crate::folder::files;
use crate::sheet::statement;
use crate::sheet::texts::Texts;
use crate::template::{self, Templates};
use crate::units::spell;
use crate::words::Words;
use std::fs;
use std::path::Path;

/// The file in a folder of templates that explains the others; it is no template.
pub const README: &str = "README.md";

/// A bank with the text that it was read from.
pub struct Loaded {
    pub bank: Bank,
    pub text: String,
    /// Its name for messages.
    pub file: String,
}

/// Reads the bank of this path or built-in id. Errors: all that is wrong with it.
pub fn load(name: &str) -> Result<Loaded, Findings> {
    let path = Path::new(name);
    let (file, text) = if path.is_file() {
        (name.to_owned(), files::read_text(path)?)
    } else if let Some((_, file, text)) = BUILT_IN.iter().find(|(id, _, _)| *id == name) {
        ((*file).to_owned(), (*text).to_owned())
    } else if path.is_dir() {
        let fault = Finding::new("", "is a folder, and a bank is a file").in_file(name);
        return Err(fault.hint("name the file, such as my-bank.yaml").into());
    } else {
        let known: Vec<&str> = BUILT_IN.iter().map(|(id, _, _)| *id).collect();
        let fault = Finding::new("", "there is no such file and no built-in bank of this name").in_file(name);
        return Err(fault.hint(format!("built-in banks: {}", known.join(", "))).into());
    };
    let bank = parse(&text, &file)?;
    Ok(Loaded { bank, text, file })
}

/// Reads the text of a bank. Errors: all that is wrong with it.
pub fn parse(text: &str, file: &str) -> Result<Bank, Findings> {
    load::bank(text, file, &template::variables_of)
}

/// The phrases of a language. Errors: there is none of this code.
pub fn words(language: &str) -> Result<Words, Findings> {
    Words::of(language).ok_or_else(|| {
        let known: Vec<&str> = Words::languages().collect();
        let fault = Finding::new("--language", format!("there is no language `{language}`"));
        fault.hint(format!("languages: {}", known.join(", "))).into()
    })
}

/// The texts for a bank in a language: built-in ones, those of a folder of one's own, those in the bank. The bank's titles,
/// questions and statements become those of the language. Errors: all that is wrong with them.
pub fn texts(own: Option<&Path>, language: &str, bank: &mut Bank) -> Result<Texts, Findings> {
    let mut words = words(language)?;
    let mut files = Vec::new();
    if let Some(folder) = own {
        if !folder.is_dir() {
            return Err(Finding::of_file(folder, "there is no such folder").into());
        }
        collect(folder, "", &mut files)?;
        if files.is_empty() {
            let hint = "templates end in .md or .html, such as statement/pulled-rolling.md";
            return Err(Finding::of_file(folder, "holds no template").hint(hint).into());
        }
    }
    let files = of_language(files, language);
    let mut faults = Findings::default();
    let variables: Variables = &template::variables_of;
    let built_in = TRANSLATED.iter().find(|(code, _)| *code == language).map_or(&[][..], |(_, list)| *list);
    if let Some((_, name, text)) = built_in.iter().find(|(id, ..)| *id == bank.id) {
        // A bank that was changed since keeps the texts that were changed.
        let original = BUILT_IN.iter().find(|(id, ..)| *id == bank.id);
        let same = original.is_some_and(|(_, _, text)| load::hash(text) == bank.hash);
        let reference = match original {
            Some((_, file, text)) if !same => Some(parse(text, file)?),
            _ => None,
        };
        overlay::put_over(bank, text, name, variables, reference.as_ref())?;
    }
    let mut templates = Vec::new();
    let mut print = None;
    for (name, path, text) in files {
        let yaml = name.strip_suffix(".yaml");
        if let Some(topic) = yaml.and_then(|n| n.strip_prefix("words/")) {
            let topics = || Words::lists(language).unwrap_or_default().iter().map(|(topic, _)| *topic);
            if topics().any(|t| t == topic) {
                faults.extend(words.put_over(topic, &text, &path).err().unwrap_or_default());
            } else {
                let known: Vec<&str> = topics().collect();
                let fault = Finding::new("", format!("there is no word list `{topic}`")).in_file(path);
                faults.push(fault.hint(format!("word lists: {}", known.join(", "))));
            }
        } else if let Some(id) = yaml.and_then(|n| n.strip_prefix("banks/")) {
            if id == bank.id {
                let put = overlay::put_over(bank, &text, &path, variables, None);
                faults.extend(put.err().unwrap_or_default());
            }
        } else if name == "print.typ" {
            print = Some((path, text));
        } else if template::is_template(&name) {
            templates.push((name, path, text));
        }
    }
    faults.extend(misspelt(&templates));
    let templates = Templates::new(language, &templates).map_err(|more| faults.extend(more)).ok();
    let Some(mut templates) = templates.filter(|_| faults.is_empty()) else { return Err(faults) };
    statement::add_own(&mut templates, bank)?;
    Ok(Texts { templates, words, print })
}

/// Files of a folder that nothing reads: their names are nearly those of built-in templates, and no other file names them.
fn misspelt(own: &[(String, String, String)]) -> Findings {
    let built_in = || template::built_in("en").map(|(name, _)| name);
    let idle = own.iter().filter(|(name, ..)| {
        // Those in folders are named after problems.
        let known = name.contains('/') || built_in().any(|known| known == name);
        !known && !own.iter().any(|(_, _, text)| text.contains(name.as_str()))
    });
    let found = idle.filter_map(|(name, path, _)| {
        let close = spell::closest(name, built_in())?;
        let fault = Finding::new("", "no page is made from a file of this name").in_file(path);
        Some(fault.hint(format!("did you mean {close}?")))
    });
    found.collect()
}

/// A folder may hold texts of several languages, each in a folder of its code: those go before the others.
fn of_language(files: Vec<(String, String, String)>, language: &str) -> Vec<(String, String, String)> {
    let code_of = |name: &str| {
        let (first, _) = name.split_once('/')?;
        Words::languages().find(|code| *code == first)
    };
    let (mut mine, mut all) = (Vec::new(), Vec::new());
    for (name, path, text) in files {
        match code_of(&name) {
            Some(code) if code == language => mine.push((name[code.len() + 1..].to_owned(), path, text)),
            Some(_) => {}
            None => all.push((name, path, text)),
        }
    }
    all.retain(|(name, _, _)| mine.iter().all(|(n, _, _)| n != name));
    all.extend(mine);
    all
}

fn collect(folder: &Path, prefix: &str, texts: &mut Vec<(String, String, String)>) -> Result<(), Findings> {
    for name in files::names_in(folder) {
        let path = folder.join(&name);
        let full = format!("{prefix}{name}");
        // At most four levels deep, so that a link to a folder above it ends.
        let is_folder = fs::metadata(&path).is_ok_and(|m| m.is_dir());
        if is_folder && full.matches('/').count() < 4 {
            collect(&path, &format!("{full}/"), texts)?;
        } else if full != README
            && (template::is_template(&name) || name.ends_with(".yaml") || full.ends_with("print.typ"))
        {
            let text = files::read_text(&path)?;
            texts.push((full, path.display().to_string(), text));
        }
    }
    Ok(())
}

/// The problem of this id; without one that of a bank that has no other. Errors: there is none, or which one is meant is not
/// said.
pub fn problem<'l>(loaded: &'l Loaded, id: Option<&str>) -> Result<&'l Problem, Finding> {
    let Some(id) = id else {
        if let [only] = &loaded.bank.problems[..] {
            return Ok(only);
        }
        let ids: Vec<&str> = loaded.bank.problems.iter().map(|p| p.id.as_str()).collect();
        let fault = Finding::new("problems", "there are several: say which").in_file(&loaded.file);
        return Err(fault.hint(format!("write one of these after the bank: {}", ids.join(", "))));
    };
    loaded.bank.problems.iter().find(|p| p.id == id).ok_or_else(|| {
        let known = loaded.bank.problems.iter().map(|p| p.id.as_str());
        let fault = Finding::new("problems", format!("there is no problem `{id}`")).in_file(&loaded.file);
        fault.hint(spell::hint(id, "its problems", known))
    })
}
