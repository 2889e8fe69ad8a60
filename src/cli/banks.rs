//! From what was typed to a bank: a file, or one that the program brings along.
use crate::bank::Bank;
use crate::bank::Problem;
use crate::bank::Variables;
use crate::bank::load;
use crate::bank::overlay;
use crate::cli::args::Own;
use crate::cli::files;
use crate::cli::templates;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::sheet::statement;
use crate::template;
use crate::template::Templates;
use crate::units;
use crate::words::Words;
use std::fs;
use std::path::Path;

/// A file of a bank: id, file, text.
type OfBank = (&'static str, &'static str, &'static str);

/// Banks in the program.
pub const BUILT_IN: &[OfBank] = &[
    (
        "wheels-on-inclines",
        "banks/wheels-on-inclines.yaml",
        include_str!("../../banks/wheels-on-inclines.yaml"),
    ),
    (
        "hoists-and-pulleys",
        "banks/hoists-and-pulleys.yaml",
        include_str!("../../banks/hoists-and-pulleys.yaml"),
    ),
    ("slip-and-roll", "banks/slip-and-roll.yaml", include_str!("../../banks/slip-and-roll.yaml")),
    ("pinned-bodies", "banks/pinned-bodies.yaml", include_str!("../../banks/pinned-bodies.yaml")),
];

/// Texts of built-in banks in other languages, by code.
pub const TRANSLATED: &[(&str, &[OfBank])] = &[(
    "de",
    &[
        (
            "wheels-on-inclines",
            "templates/de/banks/wheels-on-inclines.yaml",
            include_str!("../../templates/de/banks/wheels-on-inclines.yaml"),
        ),
        (
            "hoists-and-pulleys",
            "templates/de/banks/hoists-and-pulleys.yaml",
            include_str!("../../templates/de/banks/hoists-and-pulleys.yaml"),
        ),
        (
            "slip-and-roll",
            "templates/de/banks/slip-and-roll.yaml",
            include_str!("../../templates/de/banks/slip-and-roll.yaml"),
        ),
        (
            "pinned-bodies",
            "templates/de/banks/pinned-bodies.yaml",
            include_str!("../../templates/de/banks/pinned-bodies.yaml"),
        ),
    ],
)];

/// A bank with the text that it was read from.
pub struct Loaded {
    /// The bank.
    pub bank: Bank,
    /// Its text.
    pub text: String,
    /// Its name for messages.
    pub file: String,
}

/// Reads the bank of this path or built-in id.
///
/// # Errors
/// All that is wrong with it.
pub fn load(name: &str) -> Result<Loaded, Findings> {
    let path = Path::new(name);
    let (file, text) = if path.is_file() {
        (name.to_owned(), files::read_text(path)?)
    } else if let Some((_, file, text)) = BUILT_IN.iter().find(|(id, _, _)| *id == name) {
        ((*file).to_owned(), (*text).to_owned())
    } else {
        let known: Vec<&str> = BUILT_IN.iter().map(|(id, _, _)| *id).collect();
        let fault = Finding::new("", "there is no such file and no built-in bank of this name").in_file(name);
        return Err(fault.hint(format!("built-in banks: {}", known.join(", "))).into());
    };
    let bank = parse(&text, &file)?;
    Ok(Loaded { bank, text, file })
}

/// Reads the text of a bank.
///
/// # Errors
/// All that is wrong with it.
pub fn parse(text: &str, file: &str) -> Result<Bank, Findings> {
    load::bank(text, file, &template::variables_of)
}

/// In which words a bank is told: templates, phrases, and the bank's own texts.
pub struct Texts {
    /// Templates of the language.
    pub templates: Templates,
    /// Phrases of the language.
    pub words: Words,
    /// The instructor's own prelude for PDFs: path and text.
    pub print: Option<(String, String)>,
}

impl Texts {
    /// The instructor's own prelude for PDFs: path and text.
    pub fn print(&self) -> Option<(&str, &str)> {
        self.print.as_ref().map(|(path, text)| (path.as_str(), text.as_str()))
    }
}

/// The phrases of a language.
///
/// # Errors
/// There is none of this code.
pub fn words(language: &str) -> Result<Words, Findings> {
    Words::of(language).ok_or_else(|| {
        let known: Vec<&str> = Words::languages().collect();
        let fault = Finding::new("--language", format!("there is no language `{language}`"));
        fault.hint(format!("languages: {}", known.join(", "))).into()
    })
}

/// The texts for a bank in a language: built-in ones, those of `--templates`, those in the bank. The bank's titles,
/// questions and statements become those of the language.
///
/// # Errors
/// All that is wrong with them.
pub fn texts(own: &Own, language: &str, bank: &mut Bank) -> Result<Texts, Findings> {
    let mut words = words(language)?;
    let mut files = Vec::new();
    if let Some(folder) = &own.templates {
        if !folder.is_dir() {
            let fault = Finding::new("", "there is no such folder").in_file(folder.display().to_string());
            return Err(fault.into());
        }
        collect(folder, "", &mut files)?;
        if files.is_empty() {
            let fault = Finding::new("", "holds no template").in_file(folder.display().to_string());
            return Err(fault
                .hint("templates end in .md or .html, such as statement/pulled-rolling.md")
                .into());
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
                faults
                    .extend(overlay::put_over(bank, &text, &path, variables, None).err().unwrap_or_default());
            }
        } else if name == "print.typ" {
            print = Some((path, text));
        } else if template::is_template(&name) {
            templates.push((name, path, text));
        }
    }
    let templates = Templates::new(language, &templates).map_err(|more| faults.extend(more)).ok();
    let Some(mut templates) = templates.filter(|_| faults.is_empty()) else { return Err(faults) };
    statement::add_own(&mut templates, bank)?;
    Ok(Texts { templates, words, print })
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
        // Deep enough for any sensible folder, and a link to itself ends.
        let is_folder = fs::metadata(&path).is_ok_and(|m| m.is_dir());
        if is_folder && full.matches('/').count() < 4 {
            collect(&path, &format!("{full}/"), texts)?;
        } else if full != templates::README
            && (template::is_template(&name) || name.ends_with(".yaml") || full.ends_with("print.typ"))
        {
            let text = files::read_text(&path)?;
            texts.push((full, path.display().to_string(), text));
        }
    }
    Ok(())
}

/// The problem of this id.
///
/// # Errors
/// There is none.
pub fn problem<'l>(loaded: &'l Loaded, id: &str) -> Result<&'l Problem, Finding> {
    loaded.bank.problems.iter().find(|p| p.id == id).ok_or_else(|| {
        let known: Vec<&str> = loaded.bank.problems.iter().map(|p| p.id.as_str()).collect();
        let fault = Finding::new("problems", format!("there is no problem `{id}`")).in_file(&loaded.file);
        match units::spell::closest(id, known.iter().copied()) {
            Some(near) => fault.hint(format!("did you mean `{near}`?")),
            None => fault.hint(format!("its problems: {}", known.join(", "))),
        }
    })
}

/// Names in template files that are neither symbols nor known to every statement. (Templates in the bank were reviewed
/// with it.)
pub fn unknown_names(bank: &Bank, templates: &Templates) -> Findings {
    let mut findings = Findings::default();
    for problem in bank.problems.iter().filter(|p| p.statement.is_none()) {
        let name = statement::template_name(problem);
        match templates.variables(&name) {
            Ok(used) => {
                for unknown in used.iter().filter(|u| {
                    !statement::RESERVED.contains(&u.as_str()) && problem.data.iter().all(|d| d.symbol != **u)
                }) {
                    let known: Vec<&str> = problem.data.iter().map(|d| d.symbol.as_str()).collect();
                    findings.push(
                        Finding::new(unknown, format!("is no datum of {}", problem.id))
                            .in_file(templates.own_file(&name).unwrap_or(&name))
                            .hint(format!("its data: {}", known.join(", "))),
                    );
                }
            }
            Err(fault) => findings.push(fault),
        }
    }
    findings
}

/// Data that a statement in a file of `--templates` never gives, as the review finds them in a statement in the bank.
pub fn never_given(bank: &Bank, templates: &Templates) -> Findings {
    let mut findings = Findings::default();
    for problem in bank.problems.iter().filter(|p| p.statement.is_none()) {
        let name = statement::template_name(problem);
        let (Some(file), Ok(used)) = (templates.own_file(&name), templates.variables(&name)) else {
            continue;
        };
        // A statement that lists values or particles may give any of them.
        if used.iter().any(|n| matches!(n.as_str(), "value" | "particles")) {
            continue;
        }
        for symbol in problem.data.iter().map(|d| &d.symbol).filter(|s| *s != "g" && !used.contains(s)) {
            findings.push(
                Finding::new("", format!("the statement never gives `{symbol}`"))
                    .in_file(file)
                    .hint(format!("write `{{{{ {symbol} }}}}` where it belongs")),
            );
        }
    }
    findings
}

/// The texts of a bank as an overlay, to be translated.
pub fn overlay_text(bank: &Bank) -> String {
    // A text in single quotes means itself; one of them is written twice.
    let quoted = |text: &str| format!("'{}'", text.replace('\'', "''"));
    let mut out =
        format!("# The texts of the bank {}; data, scenes and rules stand in the bank itself.\n", bank.id);
    let mut line = |indent: usize, text: &str| {
        out.extend(std::iter::repeat_n(' ', indent));
        out.push_str(text);
        out.push('\n');
    };
    line(0, &format!("title: {}", quoted(&bank.title)));
    line(0, "problems:");
    for problem in &bank.problems {
        line(2, &format!("{}:", problem.id));
        line(4, &format!("title: {}", quoted(&problem.title)));
        line(4, "data:");
        for datum in problem.data.iter().filter(|d| d.symbol != "g") {
            line(6, &format!("{}: {}", datum.symbol, quoted(&datum.name)));
        }
        line(4, "ask:");
        for question in &problem.questions {
            line(6, &format!("{}: {}", question.id, quoted(&question.ask)));
        }
        if let Some(statement) = &problem.statement {
            line(4, "statement: |");
            for text in statement.lines() {
                line(if text.is_empty() { 0 } else { 6 }, text);
            }
        }
    }
    out
}
