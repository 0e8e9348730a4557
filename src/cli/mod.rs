//! The command lines, POV-Ray's and povista's own, and the files they leave behind.

pub mod animation;
mod exit;
pub mod failure;
pub mod job;
mod native;
pub mod output;
pub mod picture;
pub mod povray;
mod problem;
mod read;
pub mod settings;

use std::ffi::OsString;
use std::io::Write;

pub use problem::Problem;

/// Runs the program and returns its exit code.
pub fn main(
    arguments: impl IntoIterator<Item = OsString>,
    out: &mut (dyn Write + Send),
    err: &mut (dyn Write + Send),
) -> u8 {
    native::main(arguments.into_iter().collect(), out, err)
}
