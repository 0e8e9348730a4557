//! The command lines, POV-Ray's and povista's own, and the files they leave behind.

pub mod animation;
pub mod exit;
pub mod failure;
pub mod job;
mod native;
pub mod output;
pub mod picture;
pub mod povray;
mod problem;
mod read;
pub mod restrictions;
mod resume;
pub mod run;
pub mod settings;
pub mod shellout;
mod state;
mod stop;

use std::ffi::OsString;
use std::io::{IsTerminal, Write};
use std::path::Path;

pub use problem::Problem;
pub use stop::stop;

use crate::math::pages;

/// Runs the program and returns its exit code.
///
/// Words of POV-Ray's command line are read as POV-Ray reads them, and so is everything when the program's
/// name is `povray`; what it says is POV-Ray's too, unless a person watches who called it `povista`.
pub fn main(
    arguments: impl IntoIterator<Item = OsString>,
    out: &mut (dyn Write + Send),
    err: &mut (dyn Write + Send),
) -> u8 {
    pages::small();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let program = arguments.first().map(|program| Path::new(program).file_stem().unwrap_or_default());
    let is_povray = program.is_some_and(|program| program.eq_ignore_ascii_case("povray"));
    let words: Vec<String> =
        arguments.iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    if is_povray {
        povray::main(&words, err)
    } else if !speaks_povray(&words) {
        native::main(arguments, out, err)
    } else if std::io::stderr().is_terminal() {
        native::as_povray(&words, err)
    } else {
        povray::main(&words, err)
    }
}

/// Whether a command line is POV-Ray's rather than povista's own.
fn speaks_povray(words: &[String]) -> bool {
    let own = |word: &String| native::is_own(word);
    let command = words.first().is_some_and(|word| native::COMMANDS.contains(&word.as_str()));
    let version = matches!(words, [word] if word == "-V");
    povray::asks_for_benchmark(words)
        || !command && !version && !words.iter().any(own) && words.iter().any(|word| povray::is_povray(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_line_is_told_by_its_words() {
        let speaks =
            |line: &str| speaks_povray(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
        for line in [
            "+Ia.pov",
            "a.pov +W640",
            "a.pov -D",
            "quick.ini a.pov",
            "Width=3 a.pov",
            "-A0.3 a.pov",
            "+ZZ",
            "--benchmark",
        ] {
            assert!(speaks(line), "{line}");
        }
        for line in [
            "a.pov",
            "",
            "-V",
            "--version",
            "render a.pov",
            "a.pov -o b.png",
            "a.pov -L dir --size 3x4",
            "diff +a.png b.png",
            "a.pov --declare Size=3",
            "a.pov --clock -1",
            "-h",
        ] {
            assert!(!speaks(line), "{line}");
        }
    }
}
