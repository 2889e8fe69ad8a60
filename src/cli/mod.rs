//! The street door: what was typed becomes files read, the library called, results told.
use crate::cli::args::{Typed, Verb};
use crate::cli::tell::{Exit, Io, ResultStream};
use crate::folder::files;
use clap::FromArgMatches as _;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::ffi::OsString;
use std::io::Write as _;
use std::path::Path;

mod accuracy;
pub(crate) mod args;
mod check;
mod demo;
mod explain;
mod export;
mod gallery;
mod generate;
mod grade;
mod help;
mod lint;
mod matches;
mod new;
mod practice;
mod quantities;
mod regrade;
mod report;
mod simulate;
mod solutions;
mod solve;
pub mod tell;
mod templates;
mod verify;
mod what_if;

/// Runs one command line; the first argument is the program's name. May be called any number of times.
pub fn run(args: impl IntoIterator<Item = OsString>, io: &mut Io) -> Exit {
    let mut told = ResultStream { out: &mut *io.out, fault: None };
    let (watched, typed) = (io.watched, io.typed);
    let exit =
        verb(args, &mut Io { input: &mut *io.input, out: &mut told, err: &mut *io.err, watched, typed });
    // The flush fails with what is told below.
    let _ = told.flush();
    // A reader who went away (`| head`) is no error; a disk that is full is one.
    match told.fault {
        Some(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            let fault = files::trouble(Path::new("standard output"), "cannot be written")(error);
            io.findings(&[fault])
        }
        _ => exit,
    }
}

/// What to write instead, where an argument is faulty or missing that its name does not explain.
fn hint(error: &clap::Error) -> Option<&'static str> {
    let at_fault = |name: &str| match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(arg)) => arg.starts_with(name),
        Some(ContextValue::Strings(args)) => args.iter().any(|arg| arg.starts_with(name)),
        _ => false,
    };
    if error.kind() == ErrorKind::ArgumentConflict && at_fault("--seed") {
        Some("hint: --seed draws the data, --set gives them: write one of the two")
    } else if at_fault("--seed ") {
        Some(
            "hint: a seed is any whole number from 0, such as --seed 2026: the same seed draws the same data again",
        )
    } else if at_fault("<PART=ANSWER>") {
        Some(
            "hint: write each answer with its part after the sheet, such as sheet.json 1.omega=\"12.5 rad/s\"",
        )
    } else {
        None
    }
}

fn verb(words: impl IntoIterator<Item = OsString>, io: &mut Io) -> Exit {
    let typed = args::command().try_get_matches_from(words).and_then(|typed| Typed::from_arg_matches(&typed));
    let typed = match typed {
        Ok(typed) => typed,
        Err(error) => {
            let text = error.render().to_string();
            if error.use_stderr() {
                io.note(text.trim_end());
                if let Some(hint) = hint(&error) {
                    io.note(hint);
                }
                return Exit::Faulty;
            }
            io.piece(&text);
            return Exit::Fine;
        }
    };
    let done = match typed.verb {
        Verb::Generate(args) => generate::run(&args, io),
        Verb::Grade(args) => grade::run(&args, io),
        Verb::Course => {
            io.piece(crate::bank::course::EXAMPLE);
            Ok(Exit::Fine)
        }
        Verb::Report(args) => report::run(&args, io),
        Verb::Check(args) => check::run(&args, io),
        Verb::Practice(args) => practice::run(&args, io),
        Verb::Solve(args) => solve::run(&args, io),
        Verb::Accuracy(args) => accuracy::run(&args, io),
        Verb::Lint(args) => lint::run(&args, io),
        Verb::New { scene } => new::run(scene.as_deref(), io),
        Verb::Quantities { bank, problem, json } => quantities::run(&bank, problem.as_deref(), json, io),
        Verb::Gallery(args) => gallery::run(&args, io),
        Verb::Verify { set } => verify::run(&set, io),
        Verb::Solutions(args) => solutions::run(&args, io),
        Verb::Regrade(args) => regrade::run(&args, io),
        Verb::Matches { graded } => matches::run(&graded, io),
        Verb::WhatIf { graded, tolerance } => what_if::run(&graded, &tolerance, io),
        Verb::Export(args) => export::run(&args, io),
        Verb::Explain { graded, student, problem, part } => {
            explain::run(&graded, &student, &problem, part.as_deref(), io)
        }
        Verb::Templates { out, language } => templates::run(&out, &language, io),
        Verb::Simulate(args) => simulate::run(&args, io),
        Verb::Demo { dir, open } => demo::run(&dir, open, io),
        Verb::Help { topic, html, force } => help::run(topic.as_deref(), html.as_deref(), force, io),
    };
    done.unwrap_or_else(|findings| io.findings(&findings))
}
