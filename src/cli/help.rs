//! `slipstick help`: what a verb does, a topic of the manual, or the whole manual as one page.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::files;
use crate::manual;
use crate::units::spell;
use std::path::Path;

pub fn run(topic: Option<&str>, html: Option<&Path>, force: bool, io: &mut Io) -> Result<Exit, Findings> {
    if let Some(path) = html {
        return book(path, force, io);
    }
    let mut command = args::command();
    command.build();
    let Some(asked) = topic else {
        io.piece(&command.render_long_help().to_string());
        return Ok(Exit::Fine);
    };
    let verb = command.find_subcommand_mut(asked).map(|verb| verb.render_long_help().to_string());
    let topic = manual::topic(asked);
    if verb.is_none() && topic.is_none() {
        let topics = manual::TOPICS.iter().map(|t| t.name);
        let verbs = command.get_subcommands().map(clap::Command::get_name);
        let hint = match spell::closest(asked, topics.clone().chain(verbs)) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "the topics: {}; `slipstick help` lists the verbs",
                topics.collect::<Vec<_>>().join(", ")
            ),
        };
        let fault = format!("`{}` is neither a verb nor a topic of the manual", asked.escape_debug());
        return Err(Finding::new("", fault).hint(hint).into());
    }
    let both = [verb.as_deref(), topic.map(|t| t.text)];
    let both: Vec<&str> = both.into_iter().flatten().map(str::trim_end).collect();
    io.piece(&format!("{}\n", both.join("\n\n\n")));
    Ok(Exit::Fine)
}

/// Writes the manual as a page.
fn book(path: &Path, force: bool, io: &mut Io) -> Result<Exit, Findings> {
    files::may_write_file(path, force)?;
    let mut command = args::command();
    command.build();
    let verbs: Vec<(String, String)> = command
        .get_subcommands_mut()
        .map(|verb| (verb.get_name().to_owned(), verb.render_long_help().to_string()))
        .collect();
    let page = manual::book(env!("CARGO_PKG_VERSION"), &verbs)?;
    let bytes = page.len();
    files::put_all(&[(path.to_owned(), page)])?;
    io.line(&format!(
        "the manual, {} topics, {} kB, in {}",
        manual::TOPICS.len(),
        bytes.div_ceil(1000),
        path.display()
    ));
    Ok(Exit::Fine)
}
