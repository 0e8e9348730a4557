//! `povista check`: what is wrong with a scene.

use std::io::{self, Write};

use super::args::{Check, Telling};
use super::settings;
use super::terminal::Terminal;
use crate::cli::failure::Failure;
use crate::cli::read;
use crate::diag::{self, Diagnostic, Severity, Sink, Stream};
use crate::source::Sources;

/// Tells diagnostics to whoever reads standard output.
struct Teller<'w> {
    telling: Telling,
    out: &'w mut dyn Write,
    terminal: Terminal,
    /// The first trouble with the output.
    broken: io::Result<()>,
    errors: usize,
    warnings: usize,
}

impl Sink for Teller<'_> {
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources) {
        if diagnostic.severity == Severity::Error {
            self.errors += 1;
        } else {
            self.warnings += 1;
        }
        let text = match self.telling {
            Telling::Human => self.terminal.report(&diagnostic, sources),
            Telling::Plain => diag::plain(&diagnostic, sources),
            Telling::Json => diag::json(&diagnostic, sources) + "\n",
        };
        if self.broken.is_ok() {
            self.broken = self.out.write_all(text.as_bytes());
        }
    }

    fn text(&mut self, _: Stream, _: &str) {}
}

/// Checks a scene; tells whether it is without errors.
///
/// # Errors
/// There is no scene, or nobody reads the answer.
pub(super) fn check(arguments: &Check, out: &mut dyn Write) -> Result<bool, Failure> {
    let job = settings::job(&arguments.scene, &settings::of_scene(&arguments.scene)?)?;
    let terminal = Terminal::of_stdout();
    let mut teller =
        Teller { telling: arguments.format, out, terminal, broken: Ok(()), errors: 0, warnings: 0 };
    let read = read::scene(&job, &job.first_language(), &mut teller);
    let Teller { broken, errors, warnings, out, .. } = teller;
    broken?;
    match read {
        Ok(_) | Err(Failure::Scene) => {}
        Err(other) => return Err(other),
    }
    if arguments.format == Telling::Human {
        let many = |count: usize, name: &str| format!("{count} {name}{}", if count == 1 { "" } else { "s" });
        writeln!(out, "{}: {}, {}", job.input, many(errors, "error"), many(warnings, "warning"))?;
    }
    Ok(errors == 0)
}
