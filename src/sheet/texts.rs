//! In which words a bank is told.
use crate::bank::{Bank, TEMPLATE_NAMES};
use crate::finding::{Finding, Findings};
use crate::sheet::statement;
use crate::template::Templates;
use crate::words::Words;

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

/// Names in template files that are neither symbols nor known to every statement. (Templates in the bank were reviewed
/// with it.)
pub fn unknown_names(bank: &Bank, templates: &Templates) -> Findings {
    let mut findings = Findings::default();
    for problem in bank.problems.iter().filter(|p| p.statement.is_none()) {
        let name = statement::template_name(problem);
        let known: Vec<&str> = problem.data.iter().map(|d| d.symbol.as_str()).collect();
        let used = templates.variables(&name).unwrap_or_else(|fault| {
            findings.push(fault);
            Vec::new()
        });
        let has = |name: &str| TEMPLATE_NAMES.contains(&name) || known.contains(&name);
        for unknown in used.iter().filter(|name| !has(name)) {
            let fault = Finding::new(unknown, format!("is no datum of {}", problem.id));
            let fault = fault.in_file(templates.own_file(&name).unwrap_or(&name));
            findings.push(fault.hint(format!("its data: {}", known.join(", "))));
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
            let fault = Finding::new("", format!("the statement never gives `{symbol}`")).in_file(file);
            findings.push(fault.hint(format!("write `{{{{ {symbol} }}}}` where it belongs")));
        }
    }
    findings
}
