//! Finding and reading the scene of a job.

use std::io::Read;
use std::path::Path;

use super::failure::Failure;
use super::job::Job;
use super::problem::Problem;
use crate::diag::Sink;
use crate::interp;
use crate::options::LanguageOptions;
use crate::scene::Scene;
use crate::source::{FileId, FileKind, Library, Missing, Source, Sources};

/// Name of a scene that comes from standard input.
const STDIN: &str = "-";

/// Reads the scene of a job with these options; the sink hears what is wrong with it. What had to be compiled for it comes
/// along.
///
/// # Errors
/// There is no such file, or the scene has errors.
pub(super) fn scene(
    job: &Job,
    options: &LanguageOptions,
    sink: &mut dyn Sink,
) -> Result<(Scene, interp::Known, Sources), Failure> {
    let (main, mut sources) = open(job).map_err(Failure::Missing)?;
    let (scene, known) =
        interp::interpret_knowing(main, &mut sources, options, sink).ok_or(Failure::Scene)?;
    sources.release();
    Ok((scene, known, sources))
}

/// Opens the file of a job's scene.
///
/// # Errors
/// There is no such file.
pub(super) fn open(job: &Job) -> Result<(FileId, Sources), Problem> {
    let permissions = job.permissions.clone();
    if let Some(text) = job.text {
        let mut sources = Sources::new(Library { permissions, ..Library::default() });
        let main = sources.add(Source::new(&job.input, "", text.into()));
        return Ok((main, sources));
    }
    if job.input == STDIN {
        let mut bytes = Vec::new();
        std::io::stdin()
            .read_to_end(&mut bytes)
            .map_err(|error| Problem::io("read", Path::new("standard input"), &error))?;
        let mut sources = Sources::new(Library { permissions, ..Library::default() });
        let main = sources.add(Source::new("standard input", "", bytes));
        return Ok((main, sources));
    }
    let paths = job.language.library_paths.clone();
    let library = Library { paths, permissions: permissions.clone(), ..Library::default() };
    let (path, bytes) =
        library.open(&job.input, FileKind::Scene).map_err(|missing| no_scene(&job.input, missing))?;
    // The interpreter adds the paths of its options; the scene's own folder comes last.
    let scene = path.parent().map(Path::to_owned);
    let mut sources = Sources::new(Library { scene, permissions, ..Library::default() });
    let main = sources.add(Source::new(path.display().to_string(), path, bytes));
    Ok((main, sources))
}

/// Says why there is no scene.
fn no_scene(name: &str, missing: Missing) -> Problem {
    match missing {
        Missing::NotFound(folders) => {
            let names: Vec<String> = folders
                .iter()
                .filter(|folder| !folder.as_os_str().is_empty())
                .map(|folder| format!("`{}`", folder.display()))
                .collect();
            let others = if names.is_empty() { String::new() } else { format!(" and {}", names.join(", ")) };
            Problem::new(format!("cannot find the scene `{name}`"))
                .help(format!("searched in the current folder{others}"))
        }
        Missing::Folder(path) => Problem::new(format!("`{}` is a folder, not a scene", path.display())),
        Missing::Unreadable(path, error) => Problem::io("read", &path, &error),
    }
}
