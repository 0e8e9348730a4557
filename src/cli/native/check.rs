//! `povista check`: what is wrong with a scene, and what looks like it might be.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::args::{self, Check, Finding, Telling};
use super::settings;
use super::terminal::Terminal;
use crate::cli::failure::Failure;
use crate::cli::read;
use crate::diag::{self, Diagnostic, Severity, Sink, Stream};
use crate::interp;
use crate::lint::{self, Level, Levels};
use crate::source::{FileId, Sources};

/// Tells diagnostics to whoever reads standard output.
struct Teller<'w> {
    telling: Telling,
    levels: Levels,
    out: &'w mut dyn Write,
    terminal: Terminal,
    /// The first trouble with the output.
    broken: io::Result<()>,
    /// What a log will hold.
    kept: Vec<Diagnostic>,
    errors: usize,
    warnings: usize,
}

impl Sink for Teller<'_> {
    fn diagnostic(&mut self, diagnostic: Diagnostic, sources: &Sources) {
        let Some(diagnostic) = self.levels.apply(diagnostic) else { return };
        if diagnostic.severity == Severity::Error {
            self.errors += 1;
        } else {
            self.warnings += 1;
        }
        let text = match self.telling {
            Telling::Human => self.terminal.report(&diagnostic, sources) + &code_of(&diagnostic),
            Telling::Plain => diag::plain(&diagnostic, sources) + &code_of(&diagnostic),
            Telling::Json => diag::json(&diagnostic, sources) + "\n",
            Telling::Sarif => return self.kept.push(diagnostic),
        };
        if self.broken.is_ok() {
            self.broken = self.out.write_all(text.as_bytes());
        }
    }

    fn text(&mut self, _: Stream, _: &str) {}
}

/// The line that says by which code a finding is switched off.
fn code_of(diagnostic: &Diagnostic) -> String {
    if diagnostic.code.is_lint() { format!("  code: {}\n", diagnostic.code) } else { String::new() }
}

/// Checks a scene; tells whether it is without errors.
///
/// # Errors
/// There is no scene, or nobody reads the answer.
pub(super) fn check(arguments: &Check, out: &mut dyn Write) -> Result<bool, Failure> {
    let job = settings::job(&arguments.scene, &settings::of_scene(&arguments.scene)?)?;
    let mut teller = Teller {
        telling: arguments.format,
        levels: levels(&arguments.levels),
        out,
        terminal: Terminal::of_stdout(),
        broken: Ok(()),
        kept: Vec::new(),
        errors: 0,
        warnings: 0,
    };
    let (main, mut sources) = read::open(&job).map_err(Failure::Missing)?;
    let read = interp::interpret(main, &mut sources, &job.first_language(), &mut teller);
    // A scene with errors has more urgent things to hear.
    if let Some(scene) = read {
        let own = own_files(main, &sources);
        let found =
            lint::text(main, &sources, |file| own.contains(&file)).into_iter().chain(lint::geometry(scene));
        for diagnostic in found {
            teller.diagnostic(diagnostic, &sources);
        }
    }
    let Teller { broken, kept, errors, warnings, out, .. } = teller;
    broken?;
    match arguments.format {
        Telling::Sarif => writeln!(out, "{}", diag::sarif(&kept, &sources))?,
        Telling::Human => {
            let many =
                |count: usize, name: &str| format!("{count} {name}{}", if count == 1 { "" } else { "s" });
            writeln!(out, "{}: {}, {}", job.input, many(errors, "error"), many(warnings, "warning"))?;
        }
        Telling::Plain | Telling::Json => {}
    }
    Ok(errors == 0)
}

/// The files in the folder of the scene and below: whoever wrote it wrote those too.
fn own_files(main: FileId, sources: &Sources) -> Vec<FileId> {
    let real = |path: &Path| path.canonicalize().unwrap_or_default();
    let home: PathBuf = real(&sources.get(main).path).parent().map(Path::to_owned).unwrap_or_default();
    (0..)
        .zip(sources.all())
        .filter(|(_, source)| !home.as_os_str().is_empty() && real(&source.path).starts_with(&home))
        .map(|(number, _)| FileId(number))
        .collect()
}

/// The levels that were chosen: names of codes go before `all`, and more serious ones before others.
fn levels(chosen: &args::Levels) -> Levels {
    let mut levels = Levels::default();
    let lists = [(&chosen.allow, Level::Allow), (&chosen.warn, Level::Warn), (&chosen.deny, Level::Deny)];
    for general in [true, false] {
        for (list, level) in lists {
            for finding in list {
                match finding {
                    Finding::All if general => levels.set(None, level),
                    Finding::Of(code) if !general => levels.set(Some(*code), level),
                    _ => {}
                }
            }
        }
    }
    levels
}
