//! `slipstick new`: a commented bank of one scene, to begin a bank of one's own with.
use crate::bank::built_in::SCENES;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::sheet::terminal;
use crate::units;

pub fn run(scene: Option<&str>, io: &mut Io) -> Result<Exit, Findings> {
    let Some(wanted) = scene else {
        let row = |(name, text): &(&str, &str)| vec![(*name).to_owned(), about(text).to_owned()];
        let rows: Vec<Vec<String>> = SCENES.iter().map(row).collect();
        io.piece(&terminal::table(&rows, &[0, 1]));
        io.line("");
        io.line("slipstick new SCENE > my-bank.yaml    writes a bank of one of them, with comments: change what you like");
        return Ok(Exit::Fine);
    };
    let Some((_, text)) = SCENES.iter().find(|(name, _)| *name == wanted) else {
        let known = SCENES.iter().map(|(name, _)| *name);
        let fault = Finding::new("", format!("there is no scene `{wanted}`"));
        return Err(fault.hint(units::spell::hint(wanted, "scenes", known)).into());
    };
    io.piece(text);
    Ok(Exit::Fine)
}

/// What a scene is, in a sentence: the first line of its bank.
fn about(text: &str) -> &str {
    text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
}
