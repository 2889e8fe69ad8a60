//! From what was typed to a bank: a file, or one that the program brings along.
use crate::bank::Bank;
use crate::bank::Problem;
use crate::bank::load;
use crate::cli::args::Own;
use crate::cli::files;
use crate::finding::Finding;
use crate::sheet::statement;
use crate::template;
use crate::template::Templates;
use crate::units;
use std::fs;
use std::path::Path;

/// Banks in the program: id, file, text.
pub const BUILT_IN: &[(&str, &str, &str)] = &[
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
pub fn load(name: &str) -> Result<Loaded, Vec<Finding>> {
    let path = Path::new(name);
    let (file, text) = if path.is_file() {
        (name.to_owned(), files::read_text(path).map_err(|f| vec![f])?)
    } else if let Some((_, file, text)) = BUILT_IN.iter().find(|(id, _, _)| *id == name) {
        ((*file).to_owned(), (*text).to_owned())
    } else {
        let known: Vec<&str> = BUILT_IN.iter().map(|(id, _, _)| *id).collect();
        let fault = Finding::new("", "there is no such file and no built-in bank of this name").in_file(name);
        return Err(vec![fault.hint(format!("built-in banks: {}", known.join(", ")))]);
    };
    let bank = parse(&text, &file)?;
    Ok(Loaded { bank, text, file })
}

/// Reads the text of a bank.
///
/// # Errors
/// All that is wrong with it.
pub fn parse(text: &str, file: &str) -> Result<Bank, Vec<Finding>> {
    load::bank(text, file, &template::variables_of)
}

/// The templates for a bank: built-in ones, those of `--templates`, those in the bank.
///
/// # Errors
/// All that is wrong with them.
pub fn templates(own: &Own, bank: &Bank) -> Result<Templates, Vec<Finding>> {
    let mut texts = Vec::new();
    if let Some(folder) = &own.templates {
        if !folder.is_dir() {
            let fault = Finding::new("", "there is no such folder").in_file(folder.display().to_string());
            return Err(vec![fault]);
        }
        collect(folder, "", &mut texts)?;
        if texts.is_empty() {
            let fault = Finding::new("", "holds no template").in_file(folder.display().to_string());
            return Err(vec![
                fault.hint("templates end in .md or .html, such as statement/pulled-rolling.md"),
            ]);
        }
    }
    let mut templates = Templates::new(&texts)?;
    statement::add_own(&mut templates, bank)?;
    Ok(templates)
}

fn collect(
    folder: &Path,
    prefix: &str,
    texts: &mut Vec<(String, String, String)>,
) -> Result<(), Vec<Finding>> {
    for name in files::names_in(folder) {
        let path = folder.join(&name);
        let full = format!("{prefix}{name}");
        // Deep enough for any sensible folder, and a link to itself ends.
        let is_folder = fs::metadata(&path).is_ok_and(|m| m.is_dir());
        if is_folder && full.matches('/').count() < 4 {
            collect(&path, &format!("{full}/"), texts)?;
        } else if [".md", ".html"].iter().any(|end| name.ends_with(end)) {
            let text = files::read_text(&path).map_err(|f| vec![f])?;
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
pub fn unknown_names(bank: &Bank, templates: &Templates) -> Vec<Finding> {
    let mut findings = Vec::new();
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
pub fn never_given(bank: &Bank, templates: &Templates) -> Vec<Finding> {
    let mut findings = Vec::new();
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
