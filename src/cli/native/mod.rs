//! povista's own command line: `render`, `check`, `diff` and their kin.

mod args;
mod bench;
mod check;
mod compare;
mod diff;
mod dump;
mod fmt;
mod lsp;
mod render;
mod settings;
mod teller;
mod terminal;

use std::ffi::OsString;
use std::io::Write;
use std::path::Path;

use clap::{CommandFactory, Parser};

use super::exit;
use super::failure::Failure;
use super::povray;
use super::problem::Problem;
use super::settings::Name;
use args::{Arguments, Command};
use teller::Teller;
use terminal::Terminal;

/// What `--version` says.
const LONG_VERSION: &str = concat!(
    env!("CARGO_PKG_VERSION"),
    "\nReads and renders the scenes of POV-Ray 3.7.\n",
    "Licensed under MIT or Apache-2.0, at your choice. Not part of POV-Ray."
);

/// The subcommands' names; with one of these first, words are povista's own.
pub(super) const COMMANDS: [&str; 10] =
    ["render", "check", "fmt", "dump", "diff", "compare", "bench", "lsp", "completions", "help"];

/// Whether a word is an option that only povista has.
pub(super) fn is_own(word: &str) -> bool {
    word.len() > 2 && word.starts_with("--")
}

/// Runs a command line and returns the exit code.
pub(super) fn main(
    arguments: Vec<OsString>,
    out: &mut (dyn Write + Send),
    err: &mut (dyn Write + Send),
) -> u8 {
    let words = arguments.clone();
    if let Some(problem) = mixed(&words) {
        tell(&problem, err);
        return exit::FAILURE;
    }
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(answer) => {
            if let Some(problem) = misspelt(&words) {
                tell(&problem, err);
                return exit::FAILURE;
            }
            let good = answer.exit_code() == 0;
            // Help was asked for, so it goes where answers go.
            let text = if Terminal::of_stderr().is_there() && Terminal::of_stdout().is_there() {
                answer.render().ansi().to_string()
            } else {
                answer.render().to_string()
            };
            let stream: &mut dyn Write = if good { out } else { err };
            let _ = stream.write_all(text.as_bytes());
            return if good { exit::SUCCESS } else { exit::FAILURE };
        }
    };
    let result = run(arguments, out, err);
    end(result, err)
}

/// Runs a command line of POV-Ray's for a person who watches.
pub(super) fn as_povray(words: &[String], err: &mut (dyn Write + Send)) -> u8 {
    let result = povray::job(words).map_err(Failure::Problem).and_then(|(settings, job)| {
        let quiet = settings.bool(Name::AllConsole) == Some(false);
        render::watch(&job, Teller::new(&mut *err, quiet), false, "+C")
    });
    end(result.map(|()| true), err)
}

/// The exit code of a result, told if it is no good one.
fn end(result: Result<bool, Failure>, err: &mut dyn Write) -> u8 {
    match result {
        Ok(true) => exit::SUCCESS,
        Ok(false) | Err(Failure::Scene | Failure::Halted) => exit::FAILURE,
        Err(Failure::Abandoned) => exit::ABANDONED,
        Err(Failure::Missing(problem) | Failure::Problem(problem)) => {
            tell(&problem, err);
            exit::FAILURE
        }
    }
}

/// Runs a command; tells whether its answer is a good one.
fn run(
    arguments: Arguments,
    out: &mut (dyn Write + Send),
    err: &mut (dyn Write + Send),
) -> Result<bool, Failure> {
    match arguments.command.unwrap_or(Command::Render(arguments.render)) {
        Command::Render(arguments) => render::render(&arguments, err).map(|()| true),
        Command::Compare(arguments) => compare::compare(&arguments, out).map(|()| true),
        Command::Check(arguments) => check::check(&arguments, out),
        Command::Fmt(arguments) => fmt::fmt(&arguments, out, err),
        Command::Dump(arguments) => dump::dump(&arguments, out, err).map(|()| true),
        Command::Diff(arguments) => diff::diff(&arguments, out),
        Command::Lsp(arguments) => lsp::lsp(arguments).map(|()| true),
        Command::Bench(arguments) => bench::bench(&arguments, out, err).map(|()| true),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "povista", &mut script);
            out.write_all(&script)?;
            Ok(true)
        }
    }
}

/// Tells whether a command line that makes no sense begins with nearly a command.
fn misspelt(words: &[OsString]) -> Option<Problem> {
    let first = words.get(1)?.to_str().filter(|first| !first.starts_with('-') && !first.contains('.'))?;
    let near = COMMANDS.into_iter().find(|command| strsim::damerau_levenshtein(first, command) <= 2)?;
    let command = Problem::new(format!("there is no command `{first}`"));
    (near != first).then(|| command.help(format!("did you mean `{near}`?")))
}

/// Tells whether a picture is asked for with words of both programs.
fn mixed(words: &[OsString]) -> Option<Problem> {
    let words: Vec<&str> = words.iter().skip(1).filter_map(|word| word.to_str()).collect();
    let command = words.first().filter(|first| COMMANDS.contains(first));
    if command.is_some_and(|command| *command != "render") {
        return None;
    }
    let is_switch =
        |word: &&&str| word.strip_prefix('+').is_some_and(|rest| rest.starts_with(char::is_alphabetic));
    let switch = words.iter().find(is_switch).filter(|switch| !Path::new(switch).exists())?;
    let own = words.iter().find(|word| is_own(word)).or(command)?;
    let mixed = Problem::new(format!("`{switch}` is a word of POV-Ray's and `{own}` one of povista's own"));
    Some(
        mixed.help(
            "keep to one of them: `povista help render` tells povista's words, such as `--size 640x480`",
        ),
    )
}

/// Tells a problem and what may help.
fn tell(problem: &Problem, err: &mut dyn Write) {
    let terminal = Terminal::of_stderr();
    let _ = writeln!(err, "{} {}", terminal.bold("povista:"), problem.message);
    if let Some(help) = &problem.help {
        let _ = writeln!(err, "  help: {help}");
    }
}
