use crate::cli::args;
use crate::cli::tell::{Exit, Io};
pub fn run(_args: &args::Grade, _io: &mut Io) -> Exit {
    Exit::Fine
}
