//! The program: calls [`slipstick::cli::run`] and returns its exit code.
use slipstick::cli;
use slipstick::cli::tell::Io;
use std::io::{self, IsTerminal as _};
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

fn main() -> ExitCode {
    // A file beyond the limit of its size is then a fault of writing with its message, and not the end by a signal.
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
    let watched = io::stderr().is_terminal();
    let typed = io::stdin().is_terminal();
    let mut input = io::stdin().lock();
    let mut out = io::BufWriter::new(io::stdout().lock());
    // Not locked: other threads draw the bar of progress there.
    let mut err = io::stderr();
    let exit = cli::run(
        std::env::args_os(),
        &mut Io { input: &mut input, out: &mut out, err: &mut err, watched, typed },
    );
    ExitCode::from(exit as u8)
}
