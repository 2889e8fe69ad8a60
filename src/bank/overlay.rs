//! Texts of a bank in another language, put over its own: title, problems' titles, names of data, questions, statements.
use crate::bank::node::{Faults, Fields, Node, named, shorten, text};
use crate::bank::{Bank, Problem, Variables, load, soundness, yaml};
use crate::finding::Findings;
use crate::units::spell;

/// Puts the texts of an overlay over those of a bank. With a `reference`, the bank that the overlay was written for, only
/// texts that are still what they are there are replaced, and ids that this bank does not have are passed over: a changed
/// question is never shown as the old one.
/// Errors: ids that the bank does not have, fields that are unknown, texts that are none, templates with unknown names.
pub fn put_over(
    bank: &mut Bank,
    text: &str,
    file: &str,
    variables: Variables,
    reference: Option<&Bank>,
) -> Result<(), Findings> {
    let tree = yaml::tree(text).map_err(|f| f.in_file(file))?;
    let faults = Faults::default();
    if let Some(mut fields) = Fields::open(&tree, "texts of a bank (title, problems)", &faults) {
        let (title, problems) = (fields.get("title"), fields.get("problems"));
        if let Some(title) = title.and_then(|n| words(n, &faults))
            && reference.is_none_or(|r| r.title == bank.title)
        {
            bank.title = title;
        }
        for (id, key, node) in problems.map_or_else(Vec::new, |n| named(n, "problems by id", &faults)) {
            let was = reference.map(|r| r.problems.iter().find(|p| p.id == id));
            match (bank.problems.iter_mut().find(|p| p.id == id), was) {
                (Some(this), None) => problem(this, node, variables, None, &faults),
                (Some(this), Some(Some(was))) => problem(this, node, variables, Some(was), &faults),
                (Some(_), Some(None)) | (None, Some(_)) => {}
                (None, None) => {
                    let known: Vec<&str> = bank.problems.iter().map(|p| p.id.as_str()).collect();
                    unknown(key, "the bank has no problem", id, &known, &faults);
                }
            }
        }
    }
    for (field, node) in load::texts(&tree) {
        let mut now =
            bank.problems.iter().flat_map(|p| p.statement.iter().chain(p.questions.iter().map(|q| &q.ask)));
        if now.any(|text| node.text().is_some_and(|t| t.trim() == text)) {
            bank.places.insert(field, (file.to_owned(), node.line, node.column));
        }
    }
    faults.into_sorted(file).into_result(())
}

fn problem(this: &mut Problem, node: &Node, variables: Variables, was: Option<&Problem>, faults: &Faults) {
    let Some(mut fields) = Fields::open(node, "texts of a problem (title, data, ask, statement)", faults)
    else {
        return;
    };
    let (title, data) = (fields.get("title"), fields.get("data"));
    let (ask, statement) = (fields.get("ask"), fields.get("statement"));
    let symbols: Vec<String> = this.data.iter().map(|d| d.symbol.clone()).collect();
    let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
    if let Some(title) = title.and_then(|n| words(n, faults))
        && was.is_none_or(|w| w.title == this.title)
    {
        this.title = title;
    }
    for (symbol, key, node) in data.map_or_else(Vec::new, |n| named(n, "names by symbol", faults)) {
        let known = was.map(|w| w.data.iter().find(|d| d.symbol == symbol));
        match this.data.iter_mut().find(|d| d.symbol == symbol) {
            Some(datum) => {
                if let Some(name) = words(node, faults)
                    && known.is_none_or(|w| w.is_some_and(|w| w.name == datum.name))
                {
                    datum.name = name;
                }
            }
            None if was.is_some() => {}
            None => unknown(key, "the problem has no datum", symbol, &symbols, faults),
        }
    }
    for (id, key, node) in ask.map_or_else(Vec::new, |n| named(n, "questions by id", faults)) {
        let known = was.map(|w| w.questions.iter().find(|q| q.id == id));
        match this.questions.iter_mut().find(|q| q.id == id) {
            Some(question) => {
                soundness::template(node, false, &symbols, variables, faults);
                if let Some(text) = words(node, faults)
                    && known.is_none_or(|w| w.is_some_and(|w| w.ask == question.ask))
                {
                    question.ask = text;
                }
            }
            None if was.is_some() => {}
            None => {
                let ids: Vec<&str> = this.questions.iter().map(|q| q.id.as_str()).collect();
                unknown(key, "the problem asks no", id, &ids, faults);
            }
        }
    }
    if let Some(node) = statement {
        if was.is_none() {
            // What is looked for is not given.
            let given = this.data.iter().filter(|d| d.unknown.is_none());
            let given: Vec<&str> = given.map(|d| d.symbol.as_str()).collect();
            soundness::template(node, true, &given, variables, faults);
        }
        if let Some(text) = words(node, faults)
            && was.is_none_or(|w| w.statement == this.statement)
        {
            this.statement = Some(text);
        }
    }
}

fn words(node: &Node, faults: &Faults) -> Option<String> {
    text(node, "a text", faults)
}

fn unknown(key: &Node, what: &str, id: &str, known: &[&str], faults: &Faults) {
    let hint = spell::hint(id, "known here", known.iter().copied());
    faults.hint(key, format!("{what} `{}`", shorten(id)), hint);
}

/// The texts of a bank as an overlay, to be translated.
pub fn text_of(bank: &Bank) -> String {
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
