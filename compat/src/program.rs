//! A renderer driven by POV-Ray's switches, and what became of a scene in it.

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use serde::{Deserialize, Serialize};

use crate::picture::Picture;
use crate::process::{Ended, Finished, Sandbox};
use crate::scene::{Scene, invalid};

/// Exit code of a Rust program that panicked.
const PANICKED: i32 = 101;

/// What povista's framed reports begin an error with.
const FRAMED: char = '×';

/// Either of the two programs.
#[derive(Clone, Debug)]
pub struct Program {
    /// The executable.
    pub path: PathBuf,
    /// What it calls itself with `--version`, one line.
    pub version: String,
}

/// What became of a scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outcome {
    /// A picture, as the PNG file the program wrote.
    Picture(#[serde(skip)] Vec<u8>),
    /// An error and no picture: the error.
    Refused(String),
    /// A panic, a signal, or success without a picture: what is known of it.
    Crashed(String),
    /// Neither picture nor error within the limit.
    OutOfTime,
}

/// One scene rendered once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rendering {
    /// What became of it.
    pub outcome: Outcome,
    /// Time by the clock, in seconds.
    pub wall: f64,
}

impl Program {
    /// POV-Ray: `POVRAY_BIN`, or `povray` on the search path.
    pub fn povray() -> io::Result<Self> {
        let path = std::env::var_os("POVRAY_BIN").unwrap_or("povray".into());
        Program::at(
            path.into(),
            "install Debian's povray, povray-includes and povray-examples, or set POVRAY_BIN",
        )
    }

    /// povista: `POVISTA_BIN`, or the one cargo built in the same profile as this program.
    pub fn povista() -> io::Result<Self> {
        let path = match std::env::var_os("POVISTA_BIN") {
            Some(path) => path.into(),
            None => beside_us("povista")?,
        };
        Program::at(path, "build it with `cargo build` in the same profile, or set POVISTA_BIN")
    }

    /// The program at `path`, asked for its version; `mend` is what to do where it doesn't run.
    pub fn at(path: PathBuf, mend: &str) -> io::Result<Self> {
        let output = Command::new(&path).arg("--version").output().map_err(|error| {
            io::Error::new(error.kind(), format!("cannot run `{}` ({error}): {mend}", path.display()))
        })?;
        // povray writes its version to standard error, below complaints about missing files.
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&text).into_owned();
        let version = text.lines().find(|line| line.starts_with("POV-Ray ") || line.starts_with("povista "));
        let version = version
            .ok_or_else(|| {
                invalid(format!("`{} --version` names neither POV-Ray nor povista", path.display()))
            })?
            .trim()
            .to_owned();
        Ok(Program { path, version })
    }

    /// The command line for a scene, without the program itself; run in the scene's folder.
    pub fn arguments(scene: &Scene, threads: u32, picture: &Path) -> Vec<String> {
        let mut arguments = vec![format!("+I{}", scene.file_name()), "+L.".to_owned()];
        arguments.extend(scene.switches.iter().cloned());
        arguments.push(format!("+WT{threads}"));
        arguments.push(format!("+O{}", picture.display()));
        arguments
    }

    /// Renders `scene` in a copy of its folder, using at most `limit` of processor time.
    pub fn render(&self, scene: &Scene, threads: u32, limit: Duration) -> io::Result<Rendering> {
        let sandbox = Sandbox::copy_of(scene.folder())?;
        let picture = sandbox.picture();
        let finished = sandbox.run(&self.path, &Program::arguments(scene, threads, &picture), limit)?;
        let wall = finished.wall.as_secs_f64();
        let outcome = outcome(&finished, std::fs::read(picture).ok());
        Ok(Rendering { outcome, wall })
    }

    /// Has povista read `scene` without rendering it; the error, if there is one.
    pub fn check(&self, scene: &Scene, limit: Duration) -> io::Result<(Finished, Option<String>)> {
        let finished =
            self.run(scene, &["check", "--format", "plain", &scene.file_name()].map(str::to_owned), limit)?;
        let error = (finished.ended != Ended::Code(0)).then(|| match outcome(&finished, None) {
            Outcome::Refused(message) => message,
            Outcome::Crashed(message) => format!("crashed: {message}"),
            Outcome::OutOfTime | Outcome::Picture(_) => "no end within the limit".to_owned(),
        });
        Ok((finished, error))
    }

    /// Runs the program with any arguments in a copy of the scene's folder.
    pub fn run(&self, scene: &Scene, arguments: &[String], limit: Duration) -> io::Result<Finished> {
        Sandbox::copy_of(scene.folder())?.run(&self.path, arguments, limit)
    }
}

/// A program in the folder of this one, or above it: cargo puts tests in `deps`.
fn beside_us(name: &str) -> io::Result<PathBuf> {
    let us = std::env::current_exe()?;
    let mut folders = us.ancestors().skip(1);
    let folder = match folders.next() {
        Some(folder) if folder.ends_with("deps") => folders.next(),
        folder => folder,
    };
    Ok(folder.unwrap_or(Path::new(".")).join(name))
}

/// Reads how a renderer ended: by its exit code first, then by what it wrote.
fn outcome(finished: &Finished, picture: Option<Vec<u8>>) -> Outcome {
    let panicked = finished.text.lines().find(|line| line.contains("panicked at"));
    match finished.ended {
        Ended::OutOfTime => Outcome::OutOfTime,
        Ended::Signal(signal) => Outcome::Crashed(format!("signal {signal}")),
        Ended::Code(code) if code == PANICKED || panicked.is_some() => {
            Outcome::Crashed(panicked.unwrap_or("exit code 101").trim().to_owned())
        }
        Ended::Code(0) => match picture {
            Some(png) => match Picture::decode(&png) {
                Ok(_) => Outcome::Picture(png),
                Err(error) => Outcome::Crashed(format!("success with a broken picture: {error}")),
            },
            None => Outcome::Crashed("success without a picture".to_owned()),
        },
        Ended::Code(_) => Outcome::Refused(error_line(&finished.text)),
    }
}

/// The one line of a program's output that says why it gave up.
fn error_line(text: &str) -> String {
    let plain = without_escapes(&unwrapped(text));
    let lines: Vec<&str> = plain.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    // povray calls some of its warnings possible errors.
    let says = |what: &str| {
        let says =
            |line: &&&str| line.to_lowercase().contains(what) && !line.contains("Possible Parse Error");
        lines.iter().find(says)
    };
    let framed = || lines.iter().find(|line| line.starts_with(FRAMED));
    let line = says("not supported yet").or_else(|| says("error:")).or_else(framed).or_else(|| says("error"));
    let line = line.or(lines.last()).map_or("no message", |line| line);
    line.trim_start_matches(FRAMED).trim_start().to_owned()
}

/// `text` with the messages about a file, which POV-Ray's console breaks at 80 columns, on one line each.
fn unwrapped(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        match lines.last_mut() {
            Some(message) if message.starts_with("File '") && line.starts_with(' ') => message.push_str(line),
            _ => lines.push(line.to_owned()),
        }
    }
    lines.join("\n")
}

/// `text` without terminal colours.
fn without_escapes(text: &str) -> String {
    let mut plain = String::new();
    let mut chars = text.chars();
    while let Some(c) = chars.next() {
        if c == '\u{1b}' {
            chars.find(|c| c.is_ascii_alphabetic());
        } else {
            plain.push(c);
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ended(ended: Ended, text: &str) -> Finished {
        Finished { ended, text: text.to_owned(), wall: Duration::ZERO }
    }

    #[test]
    fn a_refusal_carries_its_message() {
        let text = "Warning: no camera\nFile 'a.pov' line 3: Parse Error: \u{1b}[31mnot supported yet\u{1b}[0m: media\nmore\n";
        assert_eq!(
            outcome(&ended(Ended::Code(1), text), None),
            Outcome::Refused("File 'a.pov' line 3: Parse Error: not supported yet: media".to_owned())
        );
    }

    #[test]
    fn an_error_without_the_word_is_its_last_line() {
        assert_eq!(error_line("reading\ncannot open it\n\n"), "cannot open it");
        assert_eq!(error_line(""), "no message");
        let wrapped =
            "File 'a.pov' line 1: Parse Error: not supported yet:\n `media`\nFatal error in parser\n";
        assert_eq!(error_line(wrapped), "File 'a.pov' line 1: Parse Error: not supported yet: `media`");
        let framed = "  × expected `}`\n    ╭─[a.pov:1:1]\n  × another\na.pov: 2 errors, 0 warnings\n";
        assert_eq!(error_line(framed), "expected `}`");
        let warned =
            "File 'a.pov' line 1: Possible Parse Error: odd\nFile 'a.pov' line 2: Parse Error: wrong\n";
        assert_eq!(error_line(warned), "File 'a.pov' line 2: Parse Error: wrong");
    }

    #[test]
    fn panics_signals_and_missing_pictures_are_crashes() {
        let panic = "thread 'main' panicked at src/main.rs:3:5:\nboom";
        assert_eq!(
            outcome(&ended(Ended::Code(101), panic), None),
            Outcome::Crashed("thread 'main' panicked at src/main.rs:3:5:".to_owned())
        );
        assert_eq!(outcome(&ended(Ended::Signal(11), ""), None), Outcome::Crashed("signal 11".to_owned()));
        assert_eq!(
            outcome(&ended(Ended::Code(0), ""), None),
            Outcome::Crashed("success without a picture".to_owned())
        );
        assert!(matches!(outcome(&ended(Ended::Code(0), ""), Some(vec![1, 2])), Outcome::Crashed(_)));
    }

    #[test]
    fn a_program_that_is_not_there_says_how_to_mend_it() {
        let error = Program::at("/nonexistent/povray".into(), "install it").unwrap_err().to_string();
        assert!(
            error.contains("cannot run `/nonexistent/povray`") && error.ends_with("install it"),
            "{error}"
        );
    }
}
