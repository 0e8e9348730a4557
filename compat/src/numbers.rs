//! Numbers that a scene prints with `#write`, as either program computes them.

use std::fs;
use std::io;
use std::path::Path;
use std::time::Duration;

use crate::process::{Ended, Sandbox};
use crate::program::Program;
use crate::scene::invalid;

/// The file that a scene prints its numbers to.
pub const FILE: &str = "numbers.txt";

/// The numbers that the scene `text` writes to [`FILE`], read by `program` in a copy of `folder`.
///
/// # Errors
/// The program fails, or what it writes is no list of numbers.
pub fn printed(program: &Program, folder: &Path, text: &str, limit: Duration) -> io::Result<Vec<f64>> {
    let sandbox = Sandbox::copy_of(folder)?;
    fs::write(sandbox.scene_folder().join("probe.pov"), text)?;
    let arguments = ["+Iprobe.pov", "+L.", "+W1", "+H1", "-A", "-D", "-F", "+WT1"].map(str::to_owned);
    let finished = sandbox.run(&program.path, &arguments, limit)?;
    if finished.ended != Ended::Code(0) {
        return Err(invalid(format!(
            "{} ended with {:?}:\n{}",
            program.version, finished.ended, finished.text
        )));
    }
    let written = fs::read_to_string(sandbox.scene_folder().join(FILE))?;
    let number = |word: &str| word.parse().map_err(|_| invalid(format!("`{word}` is no number")));
    written.split_whitespace().map(number).collect()
}
