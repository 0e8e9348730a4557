//! `povista fmt`: scenes neatly laid out.

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

use super::args::Fmt;
use super::terminal::Terminal;
use crate::cli::failure::Failure;
use crate::cli::problem::Problem;
use crate::fmt::{self, Refusal};
use crate::source::{FileId, Library, Source, Sources};

/// Name of a text that comes from standard input, and is written to standard output.
const STDIN: &str = "-";

/// Lays out files; tells whether all could be, or with `--check` whether all are.
///
/// # Errors
/// A file cannot be read or written, or nobody reads the answer.
pub(super) fn fmt(arguments: &Fmt, out: &mut dyn Write, err: &mut dyn Write) -> Result<bool, Failure> {
    let mut good = true;
    for name in &arguments.files {
        let mut sources = Sources::new(Library::default());
        let id = open(name, &mut sources)?;
        let source = sources.get(id);
        let text = match fmt::format(id, source) {
            Ok(text) => text,
            Err(refusal) => {
                tell(refusal, &sources, id, err)?;
                good = false;
                continue;
            }
        };
        let is_laid_out = *text == **source.text();
        if arguments.check {
            if !is_laid_out {
                writeln!(out, "{} is not laid out", source.name)?;
                good = false;
            }
        } else if arguments.stdout || name == STDIN {
            out.write_all(&source.bytes(&text))?;
        } else if !is_laid_out {
            let path = Path::new(name);
            replace(path, &source.bytes(&text)).map_err(|error| Problem::io("write", path, &error))?;
        }
    }
    Ok(good)
}

/// Reads a file, or standard input.
fn open(name: &str, sources: &mut Sources) -> Result<FileId, Problem> {
    if name != STDIN {
        let path = Path::new(name);
        return sources.read(path).map_err(|error| Problem::io("read", path, &error));
    }
    let mut bytes = Vec::new();
    match io::stdin().read_to_end(&mut bytes) {
        Ok(_) => Ok(sources.add(Source::new("standard input", "", bytes))),
        Err(error) => Err(Problem::io("read", Path::new("standard input"), &error)),
    }
}

/// Says why a file is left as it is.
fn tell(refusal: Refusal, sources: &Sources, id: FileId, err: &mut dyn Write) -> Result<(), Failure> {
    let name = &sources.get(id).name;
    match refusal {
        Refusal::Mistakes(mistakes) => {
            let terminal = Terminal::of_stderr();
            for mistake in &mistakes {
                err.write_all(terminal.report(mistake, sources).as_bytes())?;
            }
            writeln!(err, "povista: {name} is left as it is: mend this first")?;
        }
        Refusal::Changed => {
            writeln!(
                err,
                "povista: {name} is left as it is: laid out it would mean something else, which is a mistake of \
                 povista's own; please report it with the file"
            )?;
        }
    }
    Ok(())
}

/// Writes a file anew, so that whoever reads it meanwhile finds the old text or the new one.
fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // A link stays a link: what it leads to is replaced.
    let path = path.canonicalize()?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().set_permissions(fs::metadata(&path)?.permissions())?;
    file.as_file().sync_all()?;
    file.persist(&path).map(drop).map_err(|error| error.error)
}
